# statistics

# Perché non c'è un valore
statistics-reason-empty = non ci sono valori
statistics-reason-not-a-number = il valore { $place } non è un numero
statistics-reason-too-few = troppo pochi valori o gruppi: { $found }, ne servono almeno { $needed }
statistics-reason-all-equal = tutti i valori sono uguali: non c'è dispersione con cui calcolare
statistics-reason-no-subgroups = nessun sottogruppo ha due o più valori
statistics-reason-large-subgroup = un sottogruppo ha { $found } valori: l'escursione si usa fino a { $most }
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
statistics-advice-groups-alike = i gruppi non differiscono più che per caso (p = { $p })
statistics-advice-groups-differ = i gruppi differiscono (p = { $p })
