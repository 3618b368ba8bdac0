# statistics

# Perché non c'è un valore
statistics-reason-empty = non ci sono valori
statistics-reason-not-a-number = il valore { $place } non è un numero
statistics-reason-too-few = troppo pochi valori o gruppi: { $found }, ne servono almeno { $needed }
statistics-reason-all-equal = tutti i valori sono uguali: non c'è dispersione con cui calcolare
statistics-reason-no-subgroups = nessun sottogruppo ha due o più valori
statistics-reason-ungrouped = valori che non dicono il loro gruppo: { $count }
statistics-look-grouped = I punti sono medie: { $by ->
        [part] dei valori di un pezzo
        [batch] dei valori di un lotto
        [machine] dei valori di una macchina
        [gauge] dei valori di una postazione
        [who] dei valori di una persona
       *[other] dei valori senza una pausa di oltre { $minutes } min
    }.
statistics-look-stages = Punti in cui inizia una fase: { $points }. I valori sono quelli dell'ultima fase.
statistics-look-waits = Fasi che hanno ancora troppo pochi valori diversi e per ora non contano: { $count }.
statistics-look-frozen = I limiti di controllo sono quelli dei punti da { $first } a { $last }.
statistics-look-memory = Seconda carta: { $method }.
statistics-look-no-memory = Nessuna carta { $method }: { $why }.
statistics-reason-large-subgroup = un sottogruppo ha { $found } valori: l'escursione si usa fino a { $most }
statistics-reason-unequal-subgroups = i sottogruppi hanno da { $least } a { $most } valori: questa carta richiede sottogruppi di uguale dimensione
statistics-reason-no-limits = non ci sono limiti
statistics-reason-one-limit = c'è un solo limite, e ne servono due
statistics-reason-swapped-limits = il limite inferiore non è sotto quello superiore
statistics-reason-not-positive = questa distribuzione ha solo valori positivi
statistics-reason-negative = questa distribuzione non ha valori negativi
statistics-reason-no-fit = questa distribuzione non si adatta ai valori
statistics-reason-uneven-cell = letture del pezzo { $part } da parte dell'operatore { $operator }: { $found }, attese { $needed }
statistics-reason-no-baseline = il periodo di riferimento non è nella sua fase, o i suoi valori non sono utilizzabili
statistics-reason-parameter = { $name } non può essere { $given }

# Regole delle carte di controllo, dove una scatta
statistics-rule-beyond-limits = 1 punto oltre un limite di controllo
statistics-rule-nine-one-side = 9 punti di seguito dallo stesso lato della linea centrale
statistics-rule-six-trend = 6 punti di seguito in salita o in discesa
statistics-rule-fourteen-alternating = 14 punti di seguito alternati in su e in giù
statistics-rule-two-of-three = 2 punti su 3 oltre 2 s dallo stesso lato
statistics-rule-four-of-five = 4 punti su 5 oltre 1 s dallo stesso lato
statistics-rule-fifteen-within = 15 punti di seguito entro 1 s dalla linea centrale
statistics-rule-eight-beyond = 8 punti di seguito oltre 1 s, da un lato o dall'altro
statistics-rule-eight-one-side = 8 punti di seguito dallo stesso lato della linea centrale
statistics-chart-maximum = massimo { $size }
statistics-chart-minimum = minimo { $size }
statistics-chart-upper = superiore { $size }
statistics-chart-mean = media { $size }
statistics-chart-lower = inferiore { $size }
statistics-chart-values = Valori singoli in µm da { $base }, i più vecchi a sinistra
statistics-chart-means = Medie dei gruppi in µm da { $base }, le più vecchie a sinistra
statistics-chart-histogram = Istogramma
statistics-chart-moving-range = Escursione mobile, µm
statistics-chart-range = Escursione dei gruppi, µm
statistics-chart-deviation = Deviazione standard dei gruppi, µm
statistics-chart-probability = Grafico di probabilità
statistics-chart-ewma = Medie ponderate (EWMA)
statistics-chart-cusum = Somme degli scostamenti dalla media (CUSUM)
statistics-chart-probability-test = Grafico di probabilità, Anderson-Darling { $statistic }, p = { $p }

# Che cosa fare dei valori
statistics-advice-few-values = { $count } valori: gli intervalli sono ampi, di solito ne servono { $enough } o più
statistics-advice-few-points = i limiti di controllo vengono da { $count } punti: di solito ne servono { $enough } o più
statistics-advice-unstable = punti in cui scatta una regola: { $count }; la capacità vale solo per un processo stabile
statistics-advice-not-of-law = i valori seguono a stento questa distribuzione (p = { $p }): le sue quote fuori limite non sono affidabili
statistics-advice-centred = non correggere: { $what ->
        [line] la misura ora dista
       *[mean] la media dista
    } { $um } µm dal centro della tolleranza, che con { $count } valori è rumore
statistics-advice-near = non correggere: { $what ->
        [line] la misura ora dista
       *[mean] la media dista
    } { $um } µm dal centro della tolleranza, { $count } valori
statistics-advice-correct = correggere di { $correction } µm: { $what ->
        [line] la misura ora dista
       *[mean] la media dista
    } { $um } µm dal centro della tolleranza, { $count } valori
statistics-advice-no-trend = nessuna tendenza: la variazione da un pezzo all'altro è rumore
statistics-advice-trend = la misura varia di { $um } µm per pezzo
statistics-advice-trend-at-limit = la misura varia di { $um } µm per pezzo, e da ora sono da attendersi pezzi fuori limite
statistics-advice-trend-to = la misura varia di { $um } µm per pezzo: restano circa { $parts } pezzi fino al limite ({ $level } %: da { $least } a { $most })
statistics-advice-average-out = la media ponderata è fuori dai suoi limiti, per la prima volta al punto { $at }: la media si è spostata
statistics-advice-sum-out = la somma è fuori dall'intervallo di decisione, per la prima volta al punto { $at }: la media si è spostata, circa dal punto { $since }
statistics-advice-groups-alike = i gruppi non differiscono più che per caso (p = { $p })
statistics-advice-groups-differ = i gruppi differiscono (p = { $p })

# Studi di strumenti
statistics-gauge-operator-per-value = ogni valore ha un proprio operatore: le colonne sono giuste?
statistics-gauge-more-operators = operatori: { $operators }, pezzi: { $parts }: le colonne di pezzi e operatori sono scambiate?
statistics-gauge-operators-differ-more = gli operatori differiscono più dei pezzi: le colonne di pezzi e operatori sono scambiate?
statistics-gauge-same-parts = ogni operatore ha pezzi con gli stessi nomi: lo studio è incrociato?
statistics-gauge-several-masters = i valori sono di { $parts } pezzi, e questo studio richiede un solo campione
statistics-gauge-master-good = abbastanza buono per questa tolleranza: Cg e Cgk raggiungono { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = non abbastanza buono per questa tolleranza: Cg e Cgk devono raggiungere { $required }, con un passo di lettura al massimo del 5 % della tolleranza (AIAG MSA, VDA 5)
statistics-gauge-smallest = tolleranza più piccola per cui è abbastanza buono: { $mm } mm ({ $level } %: fino a { $most } mm)
statistics-gauge-biased = lo scostamento sistematico di { $um } µm è più del caso (p = { $p })
statistics-gauge-not-biased = lo scostamento sistematico di { $um } µm può essere un caso (p = { $p })
statistics-gauge-good = abbastanza buono: lo strumento prende il { $percent } % { $of ->
        [tolerance] della tolleranza
       *[variation] di tutta la dispersione
    }, e fino al 10 % è buono (AIAG MSA)
statistics-gauge-accepted = abbastanza buono solo se deve bastare: lo strumento prende il { $percent } % { $of ->
        [tolerance] della tolleranza
       *[variation] di tutta la dispersione
    }, e dal 10 % al 30 % dipende dall'uso (AIAG MSA)
statistics-gauge-bad = non abbastanza buono: lo strumento prende il { $percent } % { $of ->
        [tolerance] della tolleranza
       *[variation] di tutta la dispersione
    }, e più del 30 % è troppo (AIAG MSA)
statistics-gauge-smallest-shares = tolleranza più piccola per cui è abbastanza buono: { $good } mm; se deve bastare: { $accepted } mm
statistics-gauge-interaction-kept = gli operatori differiscono su alcuni pezzi più che su altri (p = { $p }): l'interazione resta
statistics-gauge-interaction-pooled = gli operatori non differiscono su alcuni pezzi più che su altri (p = { $p }): l'interazione è unita alla ripetibilità
statistics-gauge-negative = la varianza { $what ->
        [operator] degli operatori
        [interaction] dell'interazione
       *[part] dei pezzi
    } è risultata negativa e conta come 0
statistics-gauge-not-linear = lo scostamento sistematico cambia con la quota (p = { $p })
statistics-gauge-linear = lo scostamento sistematico non cambia con la quota più che per caso (p = { $p })
statistics-gauge-stable = stabile: nessuna regola scatta e le letture non derivano
statistics-gauge-not-stable = non stabile: una regola scatta o le letture derivano

# Perché i valori non sono uno studio
series-study-no-parts = valori senza pezzo: { $count }
series-study-no-operators = valori senza operatore accanto ad altri che ne hanno uno: { $count }
series-study-uneven-cell = letture del pezzo { $part } dell'operatore { $operator }: { $found }, attese { $needed }
series-study-uneven-operator = pezzi dell'operatore { $operator }: { $found }, attesi { $needed }
series-study-nested = ogni pezzo è stato misurato da un solo operatore: questo è uno studio annidato
series-study-no-reference = valori senza quota tarata: { $count }
series-study-references = i valori di un campione hanno più quote tarate

# Come si calcolano i valori di uno studio
series-method-word = { $word }
series-method-given = data
series-method-mean = media, Student
series-method-deviation = scarto tipo, chi quadrato
series-method-bias = media − riferimento, Student
series-method-t-test = test t
series-method-type1 = tipo 1
series-method-share = { $percent } % della tolleranza, { $spread } s
series-method-required = Cg e Cgk almeno { $required }
series-method-anova = analisi della varianza
series-method-degrees = analisi della varianza, gradi di libertà: { $degrees }
series-method-ratio = F = { $f }
series-method-negative = negativa, conta come 0
series-method-chi-square = chi quadrato
series-method-large-sample = grande campione modificato
series-method-variances = varianze
series-method-categories = 1,41 pezzi / strumento
series-method-linearity = linearità
series-method-least-squares = minimi quadrati
series-method-within-masters = s entro i campioni
statistics-on-spread = dispersione: { $rule }
