## AQDEF di Q-DAS
aqdef-line = attesi una chiave e un testo come K0001/1 25.012, o una linea di valori
aqdef-number = { $key }: { $reason }
aqdef-whole = { $key }: { $given } non è un numero intero
aqdef-undeclared = valore della caratteristica { $number }, non dichiarata prima di questa linea
aqdef-of-all = { $key } con numero 0 sarebbe il valore di ogni caratteristica: viene saltato
aqdef-cut-off = il file finisce qui senza fine linea, quindi { $given } può essere troncato: viene saltato; se è completo, aggiungere un fine linea
aqdef-zeros = la linea ha byte di valore 0, quindi il file non è stato scritto completamente: la linea viene saltata
aqdef-mark-between = K0002/0 { $given } sta tra questa riga e la precedente e può valere per l'una o per l'altra: il valore viene saltato
aqdef-twice = { $key } è dato due volte con testi diversi, prima con { $other }: i valori di questa caratteristica non vengono valutati
aqdef-fields = attesi al massimo { $most } campi in un valore, trovati { $found }
aqdef-no-values = { $count ->
        [0] né caratteristiche né valori
        [one] 1 caratteristica ma nessun valore: è un piano, non sono misure
       *[other] { $count } caratteristiche ma nessun valore: è un piano, non sono misure
    }
aqdef-no-values-beside = { $count ->
        [0] né caratteristiche né valori
        [one] 1 caratteristica ma nessun valore
       *[other] { $count } caratteristiche ma nessun valore
    }, e accanto a questo file nessun { $file } fino a { $most } MiB: è un piano, non sono misure; se { $file } è più grande, indicare quello
aqdef-no-description = valori senza caratteristiche: accanto a questo file manca { $file }
aqdef-count = K0100 annuncia { $expected } caratteristiche, trovate { $found }: il file può essere troncato
aqdef-too-large = le caratteristiche superano { $most } MiB
aqdef-beside = { $file }, linea { $line }: { $reason }
aqdef-warning-count = K0100 annuncia { $expected } caratteristiche, trovate { $found }: il file può essere troncato
aqdef-warning-fewer = attesi { $expected } valori, trovati { $found }
aqdef-warning-missing = { $count ->
        [one] 1 valore è vuoto o contrassegnato come mancante (K0002 è 255 o 256), da questa linea: viene saltato
       *[other] { $count } valori sono vuoti o contrassegnati come mancanti (K0002 è 255 o 256), da questa linea in poi: vengono saltati
    }
aqdef-warning-skipped = dati saltati: { $keys }
aqdef-warning-repeated = { $key } è dato due volte con testi diversi: si usa questo
aqdef-warning-late = { $key } non appartiene a un valore letto subito prima: viene saltato
aqdef-warning-allowance = quota nominale e scostamento danno { $limit }, ma il limite è diverso: vale il limite
aqdef-warning-tolerance = { $key } ha una tolleranza di { $given } mm, ma i limiti danno { $expected } mm: valgono i limiti
aqdef-warning-no-limit = { $key } è dato, ma K2120 o K2121 dice che quel limite non c'è: viene saltato
aqdef-warning-kind-of-limit = { $given } non è un tipo di limite noto (0, 1 o 2): viene letto come limite
aqdef-warning-scrap-limit = il limite di scarto { $limit } differisce dal limite: viene saltato, e un valore oltre il limite da questo lato è scarto
aqdef-warning-scrap-feature = il limite di scarto è quello di { $feature ->
        [hole] un foro
       *[shaft] un albero
    }, ma { $callout } non lo è: vale la classe di tolleranza
aqdef-warning-cut-off = il file finisce qui senza fine linea, e { $given } è più corto degli altri: può essere troncato
aqdef-warning-zeros = il file ha qui byte di valore 0, quindi non è stato scritto completamente: possono mancare valori
aqdef-warning-values-left = { $file } ha { $count ->
        [one] 1 linea di valori, che non viene letta
       *[other] { $count } linee di valori, che non vengono lette
    }
aqdef-warning-values-beside = i valori vengono da { $file } accanto a questo file, e i numeri di linea si riferiscono a quello
aqdef-warning-description-beside = le caratteristiche vengono da { $file } accanto a questo file
aqdef-warning-beside = { $file }, linea { $line }: { $reason }
