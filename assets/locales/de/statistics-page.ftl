page-statistics = Statistik

# Was gefragt ist
statistics-page-question = Einträge
statistics-page-question-hint = Die Einträge, deren Werte verwendet werden, in der Sprache der Seite Journal, etwa part:"Flansch 40" station:"Fräse 3" from:2026-11-01. Leer: alle Einträge.
statistics-page-last = Neueste Werte
statistics-page-size = Werte je Punkt
statistics-page-pause = Pause in Minuten
statistics-page-mean-of = Mittel aus
statistics-page-mean-count = so vielen Werten nacheinander
statistics-page-mean-pause = Werten ohne Pause dazwischen
statistics-page-mean-part = Werten eines Teils
statistics-page-mean-station = Werten einer Station
statistics-page-mean-person = Werten einer Person
statistics-page-part = Teil
statistics-page-all-parts = Alle Teile
statistics-page-read-again = Neu lesen
statistics-page-range = muss eine ganze Zahl von { $least } bis { $most } sein
statistics-page-reading = Werte werden gelesen…
statistics-page-off = Es wird nichts aufgezeichnet. Statistik entsteht aus den Werten im Journal.
statistics-page-none = Kein Eintrag mit einem Messwert passt zu dieser Frage.
statistics-page-not-read = Die Werte können nicht gelesen werden: { $why }

# Was gelesen wurde
statistics-page-values = { $count ->
        [one] 1 Wert
       *[other] { $count } Werte
    }
statistics-page-groups = { $count ->
        [one] 1 Gruppe
       *[other] { $count } Gruppen
    } zu { $size }
statistics-page-out = { $count } ausgelassen: { $why ->
        [simulated] simuliert
        [invalid] ungültig
        [doubtful] zweifelhaft
        [withdrawn] korrigiert oder zurückgezogen
       *[user] mit Begründung
    }
statistics-page-newest = Die neuesten { $count } Einträge wurden gelesen. Ältere sind nicht enthalten.
statistics-page-unread = { $count ->
        [one] 1 Eintrag kann nicht gelesen werden.
       *[other] { $count } Einträge können nicht gelesen werden.
    }

# Merkmale
statistics-page-features = Merkmale
statistics-page-features-head = Ppk, Marke bei { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 Wert
       *[other] { $count } Werte
    }, Ppk { $ppk }
statistics-page-below = { $count } von { $all } unter { $asked }
statistics-page-move-feature = Ein anderes Merkmal

# Kennwerte
statistics-page-figures = Kennwerte
statistics-page-figure-mean = Mittelwert
statistics-page-figure-deviation = Standardabweichung
statistics-page-figure-cp = Cp kurzzeitig
statistics-page-figure-cpk = Cpk kurzzeitig
statistics-page-figure-pp = Pp gesamt
statistics-page-figure-ppk = Ppk gesamt
statistics-page-figure-outside = Außerhalb der Grenzwerte
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = von { $count }
statistics-page-expected = erwartet { $ppm } von einer Million
statistics-page-proven = Ppk von { $asked } ist nachgewiesen: die untere Vertrauensgrenze ist { $lower }.
statistics-page-not-proven = Ppk von { $asked } ist nicht nachgewiesen: die untere Vertrauensgrenze ist { $lower }.
statistics-page-no-ppk = Ppk von { $asked } ist nicht nachgewiesen: { $why }.

# Die Karte
statistics-page-single = Einzelwerte
statistics-page-means = Mittelwerte aus { $size }
statistics-page-means-of-groups = Mittel von Gruppen
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Histogramm
statistics-page-spread = Streuung
statistics-page-probability = Wahrscheinlichkeitsnetz
statistics-page-no-chart = Keine Eingriffsgrenzen: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 Punkt
       *[other] { $count } Punkte
    }, Mittellinie { $centre }, Eingriffsgrenzen { $lower } … { $upper }, Grenzwerte { $minimum } … { $maximum }, { $signals ->
        [one] 1 Signal
       *[other] { $signals } Signale
    }, { $outside } außerhalb der Grenzwerte.
statistics-page-said-mean-mm = Mittelwert
statistics-page-said-sd-mm = Standardabweichung
statistics-page-said-spread-centre-mm = mittlere Streuung
statistics-page-said-spread-upper-mm = obere Eingriffsgrenze der Streuung
statistics-page-said-ewma-mm = gewichtetes Mittel
statistics-page-said-ewma-lower-mm = untere Grenze des Mittels
statistics-page-said-ewma-upper-mm = obere Grenze des Mittels
statistics-page-said-cusum-above-mm = Summe über dem Mittelwert
statistics-page-said-cusum-below-mm = Summe unter dem Mittelwert
statistics-page-said-cusum-interval-mm = Entscheidungsintervall
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Ein anderer Punkt
statistics-page-open = Eintrag öffnen
statistics-page-zoom-in = Weniger Punkte
statistics-page-zoom-out = Mehr Punkte
statistics-page-zoom-whole = Alle Punkte
statistics-page-freeze = Grenzen aus den Punkten bis hier
statistics-page-unfreeze = Grenzen aus allen Punkten
statistics-page-freeze-hint = Spätere Punkte verschieben die Eingriffsgrenzen nicht.
statistics-page-leave-out = Auslassen…
statistics-page-leave-out-hint = Der Punkt bleibt mit seiner Begründung in der Karte. Für Grenzen, Regeln und Kennwerte zählt er nicht.
statistics-page-stage = Abschnitt hier beginnen
statistics-page-no-stage = Abschnitt entfernen
statistics-page-stage-hint = Ab diesem Punkt werden die Grenzen neu berechnet, etwa nach einem Werkzeugwechsel. Die Kennwerte sind die des letzten Abschnitts.
statistics-page-take-in = Wieder einbeziehen
statistics-page-reason = Begründung
statistics-page-take-reason = Auslassen
statistics-page-cancel-reason = Abbrechen
statistics-page-copy = Kennwerte kopieren
statistics-page-copy-hint = Kennwerte, Signale und Rat als Tabelle für eine Tabellenkalkulation
statistics-page-report = Bericht…
statistics-page-report-hint = Kennwerte und Diagramme aller Merkmale als Bericht zum Unterschreiben
statistics-page-save-chart = Karte speichern…
statistics-page-save-chart-hint = Alle Karten des Merkmals auf einem Blatt, als SVG oder PNG
statistics-page-dialog-chart = Karte speichern
statistics-page-chart-ending = Der Dateiname muss auf .svg oder .png enden.

# Signale
statistics-page-signals = Signale
statistics-page-no-signals = Keine Regel spricht an.
statistics-page-rules = Regeln
statistics-page-alarms = Offene Alarme: { $count }
statistics-page-at = Punkt { $point }
statistics-page-from-to = Punkte { $first } bis { $last }
statistics-page-left-out-because = Ausgelassen: { $reason }
statistics-page-advice = Rat

# Eine Prüfmittelstudie
statistics-study = Prüfmittelstudie
statistics-study-open = Messungen öffnen…
statistics-study-open-hint = Eine Datei mit Messungen eines Prüfmittels, in jedem Format von Messwerten
statistics-study-dialog = Messungen eines Prüfmittels öffnen
statistics-study-readings = { $count ->
        [one] 1 Messung
       *[other] { $count } Messungen
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 Messung
       *[other] { $count } Messungen
    }
statistics-study-none = Öffnen Sie eine Datei mit Messungen eines Prüfmittels. Ihre Spalten sagen, welches Teil von wem gemessen wurde. Bevor gerechnet wird, sehen Sie, wie sie verstanden wurde.
statistics-study-kind = Art der Studie
statistics-study-type1 = Verfahren 1
statistics-study-crossed = Gekreuzt
statistics-study-nested = Geschachtelt
statistics-study-linearity = Linearität
statistics-study-stability = Stabilität
statistics-study-type1-hint = Ein Normal, 25 Messungen oder mehr
statistics-study-crossed-hint = Jeder Prüfer misst jedes Teil, zweimal oder öfter
statistics-study-nested-hint = Jeder Prüfer hat eigene Teile
statistics-study-linearity-hint = Mehrere Normale verschiedener Maße
statistics-study-stability-hint = Ein Normal über die Zeit
statistics-study-feature = Merkmal der Studie
statistics-study-lower = Untere Grenze
statistics-study-upper = Obere Grenze
statistics-study-reference = Kalibriertes Maß
statistics-study-resolution = Ziffernschritt
statistics-study-references-hint = Ein Maß für jedes Normal mit seinem Namen: M1 = 30.0012; M2 = 40.0005. Leer zählen die Nennmaße der Datei.
statistics-study-reference-unnamed = { $given } nennt kein Normal: den Namen vor das Maß schreiben, etwa M1 = 30.0012
statistics-study-own-limits = Grenzen der Datei: { $lower } … { $upper } mm
statistics-study-understood = So wurde die Datei verstanden
statistics-study-confirm = Gerechnet wird erst, wenn Sie das bestätigen.
statistics-study-evaluate = Auswerten
statistics-study-all-the-same = Trotzdem auswerten
statistics-study-working = Auswertung läuft…
statistics-study-answer = Ist dieses Prüfmittel gut genug?
statistics-study-each = je { $what }
statistics-study-parts = { $count ->
        [one] 1 Teil
       *[other] { $count } Teile
    }
statistics-study-operators = { $count ->
        [one] 1 Prüfer
       *[other] { $count } Prüfer
    }
statistics-study-repeats = { $count ->
        [one] 1 Wiederholung
       *[other] { $count } Wiederholungen
    }
statistics-study-masters = { $count ->
        [one] 1 Normal
       *[other] { $count } Normale
    }
statistics-study-points = { $count ->
        [one] 1 Punkt
       *[other] { $count } Punkte
    }
statistics-study-readings-between = { $least } bis { $most } Messungen
statistics-study-more-faults = und { $count } weitere
statistics-study-limits-differ = Die Grenzen der Datei unterscheiden sich von Wert zu Wert: untere und obere Grenze eingeben oder ein Merkmal wählen.
statistics-study-features = Die Datei hat mehrere Merkmale: das gemessene wählen.
statistics-study-save-budget = Als Budget speichern…
statistics-study-save-budget-hint = Die Streuung, die die Studie fand, als Typ A mit Freiheitsgraden, für die Seite Unsicherheit
statistics-study-no-budget = Diese Studie gibt keinen Beitrag zu einem Budget
statistics-study-source = { $of ->
        [part] Teile
        [operator] Prüfer
        [interaction] Wechselwirkung
        [repeatability] Wiederholbarkeit
        [gauge] Prüfmittel
       *[total] gesamt
    }
statistics-study-mean-square = Mittleres Quadrat, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Varianz, { $source }
statistics-study-figure-reference = Kalibriertes Maß
statistics-study-figure-bias = Systematische Abweichung
statistics-study-figure-mean-bias = Mittlere systematische Abweichung
statistics-study-figure-bias-p = p der Abweichung
statistics-study-figure-bias-t = t der Abweichung
statistics-study-figure-bias-at = Abweichung bei { $size } mm ({ $count })
statistics-study-figure-smallest = Kleinste Toleranz
statistics-study-figure-smallest-good = Kleinste Toleranz, 10 %
statistics-study-figure-smallest-accepted = Kleinste Toleranz, 30 %
statistics-study-figure-repeatability = Wiederholbarkeit, s
statistics-study-figure-gauge = Prüfmittel, s
statistics-study-figure-of-variance = Anteil an der Varianz
statistics-study-figure-of-readings = Anteil an allen Messungen
statistics-study-figure-of-tolerance = Anteil an der Toleranz
statistics-study-figure-categories = Unterscheidbare Klassen
statistics-study-figure-slope = Steigung
statistics-study-figure-slope-p = p der Steigung
statistics-study-figure-intercept = Abweichung bei 0
statistics-study-figure-intercept-p = p der Abweichung bei 0
statistics-study-figure-residual = s um die Gerade
statistics-study-figure-centre = Mittellinie
statistics-study-figure-lower-control = Untere Eingriffsgrenze
statistics-study-figure-upper-control = Obere Eingriffsgrenze
statistics-study-figure-spread-centre = Mittlere Streuung
statistics-study-figure-spread-upper = Obere Eingriffsgrenze der Streuung
