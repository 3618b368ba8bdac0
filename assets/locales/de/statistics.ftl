# statistics

# Warum es keine Zahl gibt
statistics-reason-empty = es gibt keine Werte
statistics-reason-not-a-number = Wert { $place } ist keine Zahl
statistics-reason-too-few = zu wenige Werte oder Gruppen: { $found }, mindestens { $needed } nötig
statistics-reason-all-equal = alle Werte sind gleich: es gibt keine Streuung, mit der gerechnet werden kann
statistics-reason-no-subgroups = keine Stichprobe hat zwei oder mehr Werte
statistics-reason-ungrouped = Werte ohne Angabe der Gruppe: { $count }
statistics-look-grouped = Punkte sind Mittel: { $by ->
        [part] der Werte eines Teils
        [batch] der Werte einer Charge
        [machine] der Werte einer Maschine
        [gauge] der Werte einer Station
        [who] der Werte einer Person
       *[other] der Werte ohne eine Pause von mehr als { $minutes } min
    }.
statistics-look-stages = Punkte, bei denen ein Abschnitt beginnt: { $points }. Die Kennwerte sind die des letzten Abschnitts.
statistics-look-waits = Abschnitte, die noch zu wenige verschiedene Werte haben und noch nicht gelten: { $count }.
statistics-look-frozen = Die Eingriffsgrenzen stammen aus den Punkten { $first } bis { $last }.
statistics-look-memory = Zweite Karte: { $method }.
statistics-look-no-memory = Keine Karte { $method }: { $why }.
statistics-reason-large-subgroup = eine Stichprobe hat { $found } Werte: Spannweiten werden bis höchstens { $most } verwendet
statistics-reason-unequal-subgroups = Stichproben haben { $least } bis { $most } Werte: diese Karte braucht gleich große Stichproben
statistics-reason-no-limits = es gibt keine Grenzwerte
statistics-reason-one-limit = es gibt nur einen Grenzwert, beide sind nötig
statistics-reason-swapped-limits = der untere Grenzwert liegt nicht unter dem oberen
statistics-reason-not-positive = diese Verteilung hat nur positive Werte
statistics-reason-negative = diese Verteilung hat keine negativen Werte
statistics-reason-no-fit = diese Verteilung passt nicht zu den Werten
statistics-reason-uneven-cell = Messungen von Teil { $part } durch Prüfer { $operator }: { $found }, erwartet { $needed }
statistics-reason-no-baseline = der Bezugszeitraum liegt nicht in seinem Abschnitt, oder seine Zahlen sind nicht verwendbar
statistics-reason-parameter = { $name } kann nicht { $given } sein

# Regeln der Regelkarten, wo eine anspricht
statistics-rule-beyond-limits = 1 Punkt außerhalb einer Eingriffsgrenze
statistics-rule-nine-one-side = 9 Punkte in Folge auf einer Seite der Mittellinie
statistics-rule-six-trend = 6 Punkte in Folge steigend oder fallend
statistics-rule-fourteen-alternating = 14 Punkte in Folge abwechselnd auf und ab
statistics-rule-two-of-three = 2 von 3 Punkten jenseits von 2 s auf einer Seite
statistics-rule-four-of-five = 4 von 5 Punkten jenseits von 1 s auf einer Seite
statistics-rule-fifteen-within = 15 Punkte in Folge innerhalb von 1 s um die Mittellinie
statistics-rule-eight-beyond = 8 Punkte in Folge jenseits von 1 s, auf beiden Seiten
statistics-rule-eight-one-side = 8 Punkte in Folge auf einer Seite der Mittellinie
statistics-chart-maximum = Höchstmaß { $size }
statistics-chart-minimum = Mindestmaß { $size }
statistics-chart-upper = obere { $size }
statistics-chart-mean = Mittel { $size }
statistics-chart-lower = untere { $size }
statistics-chart-values = Einzelwerte in µm ab { $base }, die ältesten links
statistics-chart-means = Mittelwerte der Gruppen in µm ab { $base }, die ältesten links
statistics-chart-histogram = Histogramm
statistics-chart-moving-range = Gleitende Spannweite, µm
statistics-chart-range = Spannweite der Gruppen, µm
statistics-chart-deviation = Standardabweichung der Gruppen, µm
statistics-chart-probability = Wahrscheinlichkeitsnetz
statistics-chart-ewma = Gewichtete Mittelwerte (EWMA)
statistics-chart-cusum = Summen der Abweichungen vom Mittelwert (CUSUM)
statistics-chart-probability-test = Wahrscheinlichkeitsnetz, Anderson-Darling { $statistic }, p = { $p }

# Was mit den Zahlen zu tun ist
statistics-advice-few-values = { $count } Werte: die Vertrauensbereiche sind weit, üblich sind { $enough } oder mehr
statistics-advice-few-points = die Eingriffsgrenzen stammen aus { $count } Punkten: üblich sind { $enough } oder mehr
statistics-advice-unstable = Punkte, an denen eine Regel anspricht: { $count }; Fähigkeit gilt nur für einen stabilen Prozess
statistics-advice-not-of-law = die Werte stammen kaum aus dieser Verteilung (p = { $p }): ihre Anteile außerhalb der Grenzwerte sind nicht verlässlich
statistics-advice-centred = nicht korrigieren: { $what ->
        [line] das Maß liegt jetzt
       *[mean] der Mittelwert liegt
    } { $um } µm neben der Toleranzmitte, bei { $count } Werten ist das Rauschen
statistics-advice-near = nicht korrigieren: { $what ->
        [line] das Maß liegt jetzt
       *[mean] der Mittelwert liegt
    } { $um } µm neben der Toleranzmitte, { $count } Werte
statistics-advice-correct = um { $correction } µm korrigieren: { $what ->
        [line] das Maß liegt jetzt
       *[mean] der Mittelwert liegt
    } { $um } µm neben der Toleranzmitte, { $count } Werte
statistics-advice-no-trend = kein Trend: die Änderung von Teil zu Teil ist Rauschen
statistics-advice-trend = das Maß ändert sich um { $um } µm je Teil
statistics-advice-trend-at-limit = das Maß ändert sich um { $um } µm je Teil, und ab sofort ist mit Teilen außerhalb des Grenzwerts zu rechnen
statistics-advice-trend-to = das Maß ändert sich um { $um } µm je Teil: bis zum Grenzwert bleiben etwa { $parts } Teile ({ $level } %: { $least } bis { $most })
statistics-advice-average-out = das gewichtete Mittel liegt außerhalb seiner Grenzen, zuerst an Punkt { $at }: der Mittelwert hat sich verschoben
statistics-advice-sum-out = die Summe liegt außerhalb des Entscheidungsintervalls, zuerst an Punkt { $at }: der Mittelwert hat sich etwa seit Punkt { $since } verschoben
statistics-advice-groups-alike = die Gruppen unterscheiden sich nicht mehr als durch Zufall (p = { $p })
statistics-advice-groups-differ = die Gruppen unterscheiden sich (p = { $p })

# Studien von Messmitteln
statistics-gauge-operator-per-value = jeder Wert hat einen eigenen Prüfer: stimmen die Spalten?
statistics-gauge-more-operators = Prüfer: { $operators }, Teile: { $parts }: sind die Spalten von Teilen und Prüfern vertauscht?
statistics-gauge-operators-differ-more = die Prüfer unterscheiden sich mehr als die Teile: sind die Spalten von Teilen und Prüfern vertauscht?
statistics-gauge-same-parts = jeder Prüfer hat Teile mit denselben Namen: ist die Studie gekreuzt?
statistics-gauge-several-masters = die Werte sind von { $parts } Teilen, und diese Studie braucht ein einziges Normal
statistics-gauge-master-good = gut genug für diese Toleranz: Cg und Cgk erreichen { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = nicht gut genug für diese Toleranz: Cg und Cgk müssen { $required } erreichen, bei einem Ziffernschritt von höchstens 5 % der Toleranz (AIAG MSA, VDA 5)
statistics-gauge-smallest = kleinste Toleranz, für die es gut genug ist: { $mm } mm ({ $level } %: bis { $most } mm)
statistics-gauge-biased = die systematische Abweichung von { $um } µm ist mehr als Zufall (p = { $p })
statistics-gauge-not-biased = die systematische Abweichung von { $um } µm kann Zufall sein (p = { $p })
statistics-gauge-good = gut genug: das Messmittel nimmt { $percent } % { $of ->
        [tolerance] der Toleranz
       *[variation] der gesamten Streuung
    }, und bis 10 % ist gut (AIAG MSA)
statistics-gauge-accepted = nur gut genug, wenn es genügen muss: das Messmittel nimmt { $percent } % { $of ->
        [tolerance] der Toleranz
       *[variation] der gesamten Streuung
    }, und bei 10 % bis 30 % kommt es auf den Einsatz an (AIAG MSA)
statistics-gauge-bad = nicht gut genug: das Messmittel nimmt { $percent } % { $of ->
        [tolerance] der Toleranz
       *[variation] der gesamten Streuung
    }, und mehr als 30 % ist zu viel (AIAG MSA)
statistics-gauge-smallest-shares = kleinste Toleranz, für die es gut genug ist: { $good } mm; wenn es genügen muss: { $accepted } mm
statistics-gauge-interaction-kept = die Prüfer unterscheiden sich an manchen Teilen mehr als an anderen (p = { $p }): die Wechselwirkung bleibt
statistics-gauge-interaction-pooled = die Prüfer unterscheiden sich nicht an manchen Teilen mehr als an anderen (p = { $p }): die Wechselwirkung zählt zur Wiederholbarkeit
statistics-gauge-negative = die Varianz der { $what ->
        [operator] Prüfer
        [interaction] Wechselwirkung
       *[part] Teile
    } wurde negativ und zählt als 0
statistics-gauge-not-linear = die systematische Abweichung ändert sich mit dem Maß (p = { $p })
statistics-gauge-linear = die systematische Abweichung ändert sich mit dem Maß nicht mehr als durch Zufall (p = { $p })
statistics-gauge-stable = stabil: keine Regel spricht an, und die Anzeigen driften nicht
statistics-gauge-not-stable = nicht stabil: eine Regel spricht an, oder die Anzeigen driften

# Warum Werte keine Studie sind
series-study-no-parts = Werte ohne Teil: { $count }
series-study-no-operators = Werte ohne Prüfer neben anderen mit Prüfer: { $count }
series-study-uneven-cell = Messungen von Teil { $part } durch Prüfer { $operator }: { $found }, erwartet { $needed }
series-study-uneven-operator = Teile von Prüfer { $operator }: { $found }, erwartet { $needed }
series-study-nested = jedes Teil wurde nur von einem Prüfer gemessen: das ist eine geschachtelte Studie
series-study-no-reference = Werte ohne kalibriertes Maß: { $count }
series-study-references = die Werte eines Normals haben mehrere kalibrierte Maße

# Wie Kennwerte einer Studie gerechnet sind
series-method-word = { $word }
series-method-given = gegeben
series-method-mean = Mittelwert, Student
series-method-deviation = Standardabweichung, Chi-Quadrat
series-method-bias = Mittelwert − Referenz, Student
series-method-t-test = t-Test
series-method-type1 = Verfahren 1
series-method-share = { $percent } % der Toleranz, { $spread } s
series-method-required = Cg und Cgk mindestens { $required }
series-method-anova = Varianzanalyse
series-method-degrees = Varianzanalyse, Freiheitsgrade: { $degrees }
series-method-ratio = F = { $f }
series-method-negative = negativ, zählt als 0
series-method-chi-square = Chi-Quadrat
series-method-large-sample = modifizierte große Stichprobe
series-method-variances = Varianzen
series-method-categories = 1,41 Teile / Prüfmittel
series-method-linearity = Linearität
series-method-least-squares = kleinste Quadrate
series-method-within-masters = s innerhalb der Normale
statistics-on-spread = Streuung: { $rule }
