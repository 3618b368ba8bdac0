page-pairing = Abbinamento

# Ciò che si chiede
pairing-page-wanted = Gioco o accoppiamento voluto
pairing-page-wanted-hint = Minimo e massimo in mm, come 0.010..0.030, o un accoppiamento, come 25 H7/g6. Negativo significa interferenza.
pairing-page-wanted-range = Gioco { $minimum } … { $maximum } µm, centro { $middle } µm
pairing-page-wanted-fit = { $fit }: gioco { $minimum } … { $maximum } µm, centro { $middle } µm
pairing-page-wanted-refused = { $reason }; sono ammessi un accoppiamento, come 25 H7/g6, e due giochi in mm, come 0.010..0.030
pairing-page-holes = Fori misurati
pairing-page-shafts = Alberi misurati
pairing-page-no-parts = ancora nessuno
pairing-page-reading = lettura…
pairing-page-from-file = { $name }, { $count ->
        [one] 1 pezzo
       *[other] { $count } pezzi
    }
pairing-page-from-history = Dalla cronologia, { $count ->
        [one] 1 pezzo
       *[other] { $count } pezzi
    }
pairing-page-refused = { $count ->
        [one] 1 riga rifiutata
       *[other] { $count } righe rifiutate
    }
pairing-page-all-refused = Tutte le { $count } righe rifiutate
pairing-page-all-notes = Tutti i { $count } avvisi
pairing-page-open-holes = Aprire fori…
pairing-page-open-shafts = Aprire alberi…
pairing-page-history-holes = Fori della cronologia
pairing-page-history-shafts = Alberi della cronologia
pairing-page-history-hint = Usa i controlli selezionati, o tutti quelli in elenco se nessuno è selezionato
pairing-page-groups = Gruppi
pairing-page-groups-hint = Numero di gruppi di uguale ampiezza in cui ripartire anche i pezzi. Vuoto: nessun gruppo.
pairing-page-do-wanted = Digitare il gioco voluto o un accoppiamento.
pairing-page-do-holes = Aprire i fori misurati, o prenderli dalla cronologia.
pairing-page-do-shafts = Aprire gli alberi misurati, o prenderli dalla cronologia.
pairing-page-about = Fitcheck forma quante più coppie possibile entro il gioco voluto. Tra tutti i modi di farlo, prende quello con la minima somma dei quadrati delle distanze dal centro. Bastano nomi e dimensioni misurate. I file si possono anche trascinare qui, prima i fori.
pairing-page-no-side = { $name } non viene aperto: ci sono già fori e alberi. Aprirlo come fori o come alberi.
pairing-page-none-in-history = La cronologia non ha controlli di { $feature ->
        [hole] fori
       *[shaft] alberi
    }.
pairing-page-listed-only = La cronologia è filtrata: { $feature ->
        [hole] i fori
       *[shaft] gli alberi
    } vengono dai { $listed } controlli in elenco su { $all }
pairing-page-none-chosen = Nessuno dei controlli selezionati è di un { $feature ->
        [hole] foro
       *[shaft] albero
    }.
pairing-page-nothing-read = { $name } non ha dimensioni utilizzabili: { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }({ $count } righe rifiutate)
    }
pairing-page-nothing-to-save = nessuna coppia da salvare

# Le coppie
pairing-page-pairs = Coppie
pairing-page-hole = Foro
pairing-page-shaft = Albero
pairing-page-clearance = Gioco
pairing-page-from-middle = Dal centro
pairing-page-from-middle-head = Dal centro
pairing-page-remark = Nota
pairing-page-line = linea { $line }
pairing-page-check = controllo { $line }
pairing-page-hole-simulated = foro simulato
pairing-page-shaft-simulated = albero simulato
pairing-page-both-simulated = entrambi simulati
pairing-page-list = Coppie di fori e alberi
pairing-page-row = { $hole } { $hole-mm } mm con { $shaft } { $shaft-mm } mm, gioco { $clearance } µm, { $middle } µm dal centro
pairing-page-move = Passare a un'altra coppia
pairing-page-copy = Copiare coppie

# L'immagine
pairing-page-picture = Pezzi per dimensione
pairing-page-legend = Anello: foro. Disco: albero, spostato del centro, { $middle } µm: una coppia al centro è orizzontale. Croce: avanzo.
pairing-page-part-of = A sinistra: tutti i pezzi; la cornice indica quelli disegnati.
pairing-page-thinned = Troppo fitti per disegnarli tutti: ne è disegnato 1 su { $step }.
pairing-page-left-over = avanzo
pairing-page-describe = { $holes ->
        [one] 1 foro
       *[other] { $holes } fori
    } a sinistra, { $shafts ->
        [one] 1 albero
       *[other] { $shafts } alberi
    } a destra, su un'unica scala di dimensione; gli alberi sono spostati di { $middle } µm, così una coppia al centro del gioco voluto è orizzontale. { $pairs ->
        [one] 1 coppia è disegnata come linea.
       *[other] { $pairs } coppie sono disegnate come linee.
    }
pairing-page-describe-part = { $pairs ->
        [one] 1 coppia è visibile.
       *[other] { $pairs } coppie sono visibili.
    }
pairing-page-describe-selected = Selezionato: { $hole } con { $shaft }, gioco { $clearance } µm.

# La risposta
pairing-page-count = { $count ->
        [one] 1 coppia
       *[other] { $count } coppie
    }
pairing-page-none = Ancora nessun risultato
pairing-page-at-work = Abbinamento…
pairing-page-nothing-left = nessun avanzo
pairing-page-left = avanzi: { $holes ->
        [one] 1 foro
       *[other] { $holes } fori
    }, { $shafts ->
        [one] 1 albero
       *[other] { $shafts } alberi
    }
pairing-page-simulated = { $count ->
        [one] 1 coppia con un pezzo simulato
       *[other] { $count } coppie con un pezzo simulato
    }
pairing-page-no-pair = Nessun foro e albero hanno un gioco nel campo voluto.
pairing-page-smallest = Gioco minimo
pairing-page-largest = Gioco massimo
pairing-page-middle = Centro voluto
pairing-page-band = Fascia attorno
pairing-page-grinding = Rettifica
pairing-page-grind = { $amount } µm in meno agli alberi in avanzo, o in più ai fori in avanzo: { $count ->
        [one] 1 coppia in più
       *[other] { $count } coppie in più
    }
pairing-page-grind-means = La minima quantità, a passi di 1 µm, che dà il maggior numero di coppie in più. Le coppie esistenti restano.
pairing-page-grind-nothing = Nessuna quantità dà un'altra coppia.
pairing-page-grind-bounded = Sono state provate quantità fino a { $tried } µm; i pezzi più lontani richiederebbero { $reach } µm.
pairing-page-groups-title = Gruppi
pairing-page-group = Gruppo { $number }: { $count ->
        [one] 1 coppia
       *[other] { $count } coppie
    }
pairing-page-all-within = ✓ tutte nel campo
pairing-page-not-all-within = ✗ non tutte nel campo
pairing-page-no-group-pairs = un lato è vuoto
pairing-page-group-holes = { $count ->
        [one] 1 foro
       *[other] { $count } fori
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] 1 albero
       *[other] { $count } alberi
    } { $from } … { $to } mm
pairing-page-group-clearance = gioco { $range }
pairing-page-outside-groups = In nessun gruppo, fuori dalle zone di tolleranza: { $holes ->
        [one] 1 foro
       *[other] { $holes } fori
    }, { $shafts ->
        [one] 1 albero
       *[other] { $shafts } alberi
    }

# File
pairing-page-save-csv = Salvare come CSV…
pairing-page-save-json = Salvare come JSON…
pairing-page-file-name = coppie
pairing-page-dialog-holes = Aprire fori misurati
pairing-page-dialog-shafts = Aprire alberi misurati
pairing-page-dialog-save = Salvare le coppie
file-kind-holes = Fori misurati
file-kind-shafts = Alberi misurati
file-kind-pairs = Coppie
