page-statistics = Statistica

# Che cosa si chiede
statistics-page-question = Registrazioni
statistics-page-question-hint = Le registrazioni i cui valori vengono usati, nel linguaggio della pagina Registro, per esempio part:"Flangia 40" station:"Fresatrice 3" from:2026-11-01. Vuoto: tutte le registrazioni.
statistics-page-last = Valori più recenti
statistics-page-size = Valori per punto
statistics-page-pause = Pausa in minuti
statistics-page-mean-of = Media di
statistics-page-mean-count = tanti valori di seguito
statistics-page-mean-pause = valori senza pausa
statistics-page-mean-part = valori di un pezzo
statistics-page-mean-station = valori di una postazione
statistics-page-mean-person = valori di una persona
statistics-page-part = Pezzo
statistics-page-all-parts = Tutti i pezzi
statistics-page-read-again = Rileggere
statistics-page-range = deve essere un numero intero da { $least } a { $most }
statistics-page-reading = Lettura dei valori…
statistics-page-off = Non viene registrato nulla. La statistica si fa con i valori del registro.
statistics-page-none = Nessuna registrazione con un valore misurato risponde a questa domanda.
statistics-page-not-read = I valori non si possono leggere: { $why }

# Che cosa è stato letto
statistics-page-values = { $count ->
        [one] 1 valore
       *[other] { $count } valori
    }
statistics-page-groups = { $count ->
        [one] 1 gruppo
       *[other] { $count } gruppi
    } da { $size }
statistics-page-out = { $count } esclusi: { $why ->
        [simulated] simulati
        [invalid] non validi
        [doubtful] dubbi
        [withdrawn] corretti o ritirati
       *[user] con motivo
    }
statistics-page-newest = Sono state lette le { $count } registrazioni più recenti. Quelle precedenti non sono comprese.
statistics-page-unread = { $count ->
        [one] 1 registrazione non si può leggere.
       *[other] { $count } registrazioni non si possono leggere.
    }

# Elementi
statistics-page-features = Elementi
statistics-page-features-head = Ppk, segno a { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 valore
       *[other] { $count } valori
    }, Ppk { $ppk }
statistics-page-below = { $count } su { $all } sotto { $asked }
statistics-page-move-feature = Un altro elemento

# Valori
statistics-page-figures = Valori
statistics-page-figure-mean = Media
statistics-page-figure-deviation = Scarto tipo
statistics-page-figure-cp = Cp a breve termine
statistics-page-figure-cpk = Cpk a breve termine
statistics-page-figure-pp = Pp complessivo
statistics-page-figure-ppk = Ppk complessivo
statistics-page-figure-outside = Fuori limite
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = su { $count }
statistics-page-expected = attesi { $ppm } per milione
statistics-page-proven = Un Ppk di { $asked } è dimostrato: il suo limite inferiore è { $lower }.
statistics-page-not-proven = Un Ppk di { $asked } non è dimostrato: il suo limite inferiore è { $lower }.
statistics-page-no-ppk = Un Ppk di { $asked } non è dimostrato: { $why }.

# La carta
statistics-page-single = Valori singoli
statistics-page-means = Medie di { $size }
statistics-page-means-of-groups = Medie di gruppi
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Istogramma
statistics-page-spread = Dispersione
statistics-page-probability = Grafico di probabilità
statistics-page-no-chart = Nessun limite di controllo: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 punto
       *[other] { $count } punti
    }, linea centrale { $centre }, limiti di controllo { $lower } … { $upper }, limiti { $minimum } … { $maximum }, { $signals ->
        [one] 1 segnale
       *[other] { $signals } segnali
    }, { $outside } fuori limite.
statistics-page-said-mean-mm = media
statistics-page-said-sd-mm = scarto tipo
statistics-page-said-spread-centre-mm = dispersione media
statistics-page-said-spread-upper-mm = limite di controllo superiore della dispersione
statistics-page-said-ewma-mm = media ponderata
statistics-page-said-ewma-lower-mm = limite inferiore della media
statistics-page-said-ewma-upper-mm = limite superiore della media
statistics-page-said-cusum-above-mm = somma sopra la media
statistics-page-said-cusum-below-mm = somma sotto la media
statistics-page-said-cusum-interval-mm = intervallo di decisione
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Un altro punto
statistics-page-open = Aprire la registrazione
statistics-page-zoom-in = Meno punti
statistics-page-zoom-out = Più punti
statistics-page-zoom-whole = Tutti i punti
statistics-page-freeze = Limiti dai punti fin qui
statistics-page-unfreeze = Limiti da tutti i punti
statistics-page-freeze-hint = I punti successivi non spostano i limiti di controllo.
statistics-page-leave-out = Escludere…
statistics-page-leave-out-hint = Il punto resta nella carta con il suo motivo. Non conta per limiti, regole e valori.
statistics-page-stage = Iniziare qui una fase
statistics-page-no-stage = Togliere la fase
statistics-page-stage-hint = Da questo punto i limiti si ricalcolano, per esempio dopo un cambio utensile. I valori sono quelle dell'ultima fase.
statistics-page-take-in = Includere di nuovo
statistics-page-reason = Motivo
statistics-page-take-reason = Escludere
statistics-page-cancel-reason = Annullare
statistics-page-copy = Copiare i valori
statistics-page-copy-hint = Valori, segnali e consigli come tabella per un foglio di calcolo
statistics-page-report = Rapporto…
statistics-page-report-hint = Valori e grafici di tutte le caratteristiche come rapporto da firmare
statistics-page-save-chart = Salvare la carta…
statistics-page-save-chart-hint = Tutte le carte della caratteristica su un foglio, come SVG o PNG
statistics-page-dialog-chart = Salvare la carta
statistics-page-chart-ending = Il nome del file deve finire in .svg o .png.

# Segnali
statistics-page-signals = Segnali
statistics-page-no-signals = Non scatta nessuna regola.
statistics-page-rules = Regole
statistics-page-alarms = Allarmi aperti: { $count }
statistics-page-at = Punto { $point }
statistics-page-from-to = Punti da { $first } a { $last }
statistics-page-left-out-because = Escluso: { $reason }
statistics-page-advice = Consigli

# Uno studio dello strumento
statistics-study = Studio dello strumento
statistics-study-open = Apri letture…
statistics-study-open-hint = Un file con letture di uno strumento, in qualsiasi formato di misure
statistics-study-dialog = Apri letture di uno strumento
statistics-study-readings = { $count ->
        [one] 1 lettura
       *[other] { $count } letture
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 lettura
       *[other] { $count } letture
    }
statistics-study-none = Apra un file con letture di uno strumento. Le sue colonne dicono quale pezzo è stato letto e da chi. Prima di ogni calcolo si vede come è stato capito.
statistics-study-kind = Tipo di studio
statistics-study-type1 = Tipo 1
statistics-study-crossed = Incrociato
statistics-study-nested = Annidato
statistics-study-linearity = Linearità
statistics-study-stability = Stabilità
statistics-study-type1-hint = Un campione, 25 letture o più
statistics-study-crossed-hint = Ogni operatore legge ogni pezzo, due volte o più
statistics-study-nested-hint = Ogni operatore ha pezzi propri
statistics-study-linearity-hint = Più campioni di quote diverse
statistics-study-stability-hint = Un campione nel tempo
statistics-study-feature = Elemento dello studio
statistics-study-lower = Limite inferiore
statistics-study-upper = Limite superiore
statistics-study-reference = Quota tarata
statistics-study-resolution = Passo di lettura
statistics-study-references-hint = Una quota per ogni campione con il suo nome: M1 = 30.0012; M2 = 40.0005. Vuoto usa le quote nominali del file.
statistics-study-reference-unnamed = { $given } non nomina un campione: scriva il nome prima della quota, come M1 = 30.0012
statistics-study-own-limits = Limiti del file: { $lower } … { $upper } mm
statistics-study-understood = Come è stato capito il file
statistics-study-confirm = Non si calcola nulla finché non lo conferma.
statistics-study-evaluate = Valuta
statistics-study-all-the-same = Valuta comunque
statistics-study-working = Valutazione…
statistics-study-answer = Questo strumento è abbastanza buono?
statistics-study-each = { $what } ciascuno
statistics-study-parts = { $count ->
        [one] 1 pezzo
       *[other] { $count } pezzi
    }
statistics-study-operators = { $count ->
        [one] 1 operatore
       *[other] { $count } operatori
    }
statistics-study-repeats = { $count ->
        [one] 1 ripetizione
       *[other] { $count } ripetizioni
    }
statistics-study-masters = { $count ->
        [one] 1 campione
       *[other] { $count } campioni
    }
statistics-study-points = { $count ->
        [one] 1 punto
       *[other] { $count } punti
    }
statistics-study-readings-between = da { $least } a { $most } letture
statistics-study-more-faults = e altri { $count }
statistics-study-limits-differ = I limiti del file differiscono da un valore all'altro: indichi il limite inferiore e quello superiore, o scelga un elemento.
statistics-study-features = Il file ha più elementi: scelga quello letto dallo strumento.
statistics-study-save-budget = Salva come bilancio…
statistics-study-save-budget-hint = La dispersione trovata dallo studio, come tipo A con i gradi di libertà, per la pagina Incertezza
statistics-study-no-budget = Questo studio non dà contributi a un bilancio
statistics-study-source = { $of ->
        [part] pezzi
        [operator] operatori
        [interaction] interazione
        [repeatability] ripetibilità
        [gauge] strumento
       *[total] totale
    }
statistics-study-mean-square = Quadrato medio, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Varianza, { $source }
statistics-study-figure-reference = Quota tarata
statistics-study-figure-bias = Scostamento sistematico
statistics-study-figure-mean-bias = Scostamento sistematico medio
statistics-study-figure-bias-p = p dello scostamento
statistics-study-figure-bias-t = t dello scostamento
statistics-study-figure-bias-at = Scostamento a { $size } mm ({ $count })
statistics-study-figure-smallest = Tolleranza più piccola
statistics-study-figure-smallest-good = Tolleranza più piccola, 10 %
statistics-study-figure-smallest-accepted = Tolleranza più piccola, 30 %
statistics-study-figure-repeatability = Ripetibilità, s
statistics-study-figure-gauge = Strumento, s
statistics-study-figure-of-variance = Quota della varianza
statistics-study-figure-of-readings = Quota di tutte le letture
statistics-study-figure-of-tolerance = Quota della tolleranza
statistics-study-figure-categories = Categorie distinte
statistics-study-figure-slope = Pendenza
statistics-study-figure-slope-p = p della pendenza
statistics-study-figure-intercept = Scostamento a 0
statistics-study-figure-intercept-p = p dello scostamento a 0
statistics-study-figure-residual = s attorno alla retta
statistics-study-figure-centre = Linea centrale
statistics-study-figure-lower-control = Limite di controllo inferiore
statistics-study-figure-upper-control = Limite di controllo superiore
statistics-study-figure-spread-centre = Dispersione media
statistics-study-figure-spread-upper = Limite di controllo superiore della dispersione
