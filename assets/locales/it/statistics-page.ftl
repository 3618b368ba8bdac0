page-statistics = Statistica

# Che cosa si chiede
statistics-page-question = Registrazioni
statistics-page-question-hint = Le registrazioni i cui valori vengono usati, nel linguaggio della pagina Registro, per esempio part:"Flangia 40" station:"Fresatrice 3" from:2026-11-01. Vuoto: tutte le registrazioni.
statistics-page-last = Valori più recenti
statistics-page-size = Valori per punto
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
statistics-page-take-in = Includere di nuovo
statistics-page-reason = Motivo
statistics-page-take-reason = Escludere
statistics-page-cancel-reason = Annullare
statistics-page-copy = Copiare i valori
statistics-page-copy-hint = Valori, segnali e consigli come tabella per un foglio di calcolo
statistics-page-report = Rapporto…
statistics-page-report-hint = Valori e grafici di tutte le caratteristiche come rapporto da firmare

# Segnali
statistics-page-signals = Segnali
statistics-page-no-signals = Non scatta nessuna regola.
statistics-page-rules = Regole
statistics-page-on-spread = Dispersione: { $rule }
statistics-page-alarms = Allarmi aperti: { $count }
statistics-page-at = Punto { $point }
statistics-page-from-to = Punti da { $first } a { $last }
statistics-page-left-out-because = Escluso: { $reason }
statistics-page-advice = Consigli
