# pairing

pairing-not-a-range = giochi { $given }: attesi il minimo e il massimo in mm separati da due punti consecutivi, come 0.010..0.030
pairing-minimum = gioco minimo: { $reason }
pairing-maximum = gioco massimo: { $reason }
pairing-swapped = il gioco minimo { $minimum } mm è maggiore del massimo, { $maximum } mm
pairing-too-narrow = { $feature ->
        [hole] i fori
       *[shaft] gli alberi
    } da { $from } a { $to } mm non si possono ripartire in { $count } gruppi: un gruppo ha almeno un nanometro
pairing-group-count = { $count } gruppi: attesi da 1 a { $most }
pairing-no-sizes = non ci sono { $feature ->
        [hole] fori
       *[shaft] alberi
    } da ripartire

# Che cosa verificare sui pezzi
pairing-parts-outside-limits = { $count ->
        [one] 1 pezzo è fuori dai propri limiti
       *[other] { $count } pezzi sono fuori dai propri limiti
    }: le coppie sono scelte solo secondo il gioco
pairing-parts-checked-twice = { $rows ->
        [one] un controllo ha il nome di un controllo precedente
       *[other] { $rows } controlli hanno il nome di un controllo precedente
    }, come { $id }, controlli { $first } e { $second }: ogni controllo conta come un pezzo
pairing-parts-simulated-checks = { $count ->
        [one] 1 controllo è simulato
       *[other] { $count } controlli sono simulati
    }: non è stato misurato nulla
