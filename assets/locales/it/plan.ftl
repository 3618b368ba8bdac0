# Piani di elementi: che cosa non va in un piano.

plan-no-features = il piano non ha elementi
plan-no-form-limit = { $text } non è il limite di una tolleranza di forma o posizione: indicare una sola lunghezza sopra 0 in mm, per esempio 0.02
plan-too-many = il piano ha più di { $most } elementi
plan-too-large = un piano ha al massimo { $most } KiB
plan-no-column = manca la colonna { $column }
plan-unknown-column = colonna sconosciuta { $column }: le colonne sono { $known }
plan-column-twice = la colonna { $column } compare due volte
plan-cells = la riga ha { $found } celle e l'intestazione { $expected }: con la virgola decimale, separare le colonne con punti e virgola
plan-no-cell = manca { $column }
plan-value = { $what }: { $error }
plan-no-feature = { $callout } può essere un foro o un albero: aggiungere feature = "hole" o feature = "shaft", oppure kind = "length" se non è né l'uno né l'altro
plan-fit = { $callout } è un accoppiamento: scrivere il foro e l'albero come due elementi
plan-clearance-height = l'altezza di sicurezza { $height } mm non è sopra l'altezza di misura, { $z } mm
plan-same-name = il nome { $name } compare due volte{ $line ->
    [0] : i nomi di file su un controllo numerico non distinguono maiuscole e minuscole
   *[other] , la prima alla linea { $line }: i nomi di file su un controllo numerico non distinguono maiuscole e minuscole
}
plan-unknown = { $column } { $given } non è noto: atteso { $known }
plan-other-side = il tipo { $given } contraddice { $column } { $text }, che è di { $side ->
    [hole] un foro
   *[shaft] un albero
    }: correggere uno dei due, o scrivere diameter
plan-not-of = con { $kind } non va indicato { $column }
plan-direction = l'asse { $given } non è una direzione: atteso { $known }, o tre numeri come 0.5 0 -1, da -10 a 10 con al massimo 9 decimali e non tutti 0
plan-no-band = { $text } non è una banda di tolleranza per un punto, come ±0,05 o +0,1/-0,05: { $error }
plan-band-side = un punto non può avere scostamenti da { $lower } a { $upper } mm: il ciclo richiede uno superiore di 0 o più e uno inferiore di 0 o meno, non entrambi 0
plan-side-class = { $callout }: con { $kind } entrambi i lati richiedono classi come { $example }
plan-face-class = { $callout }: una superficie piana si valuta come quota esterna e richiede una classe per alberi, come h9
plan-face-place = { $callout }: la superficie piana è a { $coordinate } mm lungo l'asse misurato, e questa deve essere la sua quota nominale
plan-not-a-plan = non è un piano: un piano ha una linea con i nomi delle sue colonne, come name;callout;x;y;z, o comincia con fitcheck_plan = 1
plan-other-version = questo piano ha la versione { $given }: sono supportate le versioni da 1 a { $newest }
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = chiave sconosciuta { $key }: attesa { $known }
plan-other-value = { $key }: atteso { $expected }, trovato { $found }
plan-parameter = il ciclo { $cycle } non accetta { $given } da un piano: scrivere NAME=VALUE con uno tra { $known }
plan-no-parameter = nessun ciclo di misura accetta { $given } da un piano: scrivere NAME=VALUE, come Q423=3
plan-travel = { $axis }{ $given } è fuori dalla corsa della macchina, da { $minimum } a { $maximum } mm
plan-clearance-travel = il sistema di tastatura si sposta a Z{ $height }, fuori dalla corsa della macchina, da { $minimum } a { $maximum } mm: indicare un altro clearance_height
plan-no-travel = { $given } non è una corsa: scrivere due numeri, prima il minore, come -250 250
plan-no-plausible = { $column }: { $given } non è un intervallo: scrivere due lunghezze in mm, prima la minore, come 24.5 25.5
plan-plausible-limits = { $column }: da { $lower } a { $upper } mm non contiene i limiti della quota, da { $minimum } a { $maximum } mm: indicare un intervallo più ampio
plan-text = { $column }: attesa una linea di al massimo { $most } caratteri
plan-same-number = { $line ->
    [0] il numero { $number } compare due volte: un altro elemento ha { $other }
   *[other] il numero { $number } compare due volte: l'elemento alla linea { $line } ha { $other }
}
plan-same-size = { $line ->
    [0] un valore { $called } può appartenere a questo elemento o a { $other }: rinominare uno dei due
   *[other] un valore { $called } può appartenere a questo elemento o a { $other } alla linea { $line }: rinominare uno dei due
}
plan-number-is-name = { $line ->
    [0] il numero { $number } è il nome di un altro elemento, { $other }
   *[other] il numero { $number } è il nome di un altro elemento, { $other } alla linea { $line }
}
plan-name-is-number = { $line ->
    [0] un valore { $called } può appartenere a questo elemento o a { $other }, di cui è il numero
   *[other] un valore { $called } può appartenere a questo elemento o a { $other } alla linea { $line }, di cui è il numero
}
plan-balloon = { $given } non è un punto dell'immagine: atteso da 0 a 1
plan-not-found-unknown = non valutato: nessun elemento del piano ha questo nome, numero o posizione
plan-not-found-no-clue = non valutato: il valore non ha nome, numero o posizione, quindi non corrisponde ad alcun elemento del piano
plan-not-found-half-place = non valutato: nessun elemento del piano ha questo nome o numero, e una posizione richiede X e Y
plan-not-found-contradiction = non valutato: il nome corrisponde a { $name } del piano, ma il numero a { $number }
plan-not-found-other-name = nessun elemento del piano si chiama { $given }; { $name } ha lo stesso numero, ma può essere un numero progressivo: chiamare l'elemento come nel piano, o indicarne la quota nominale
plan-not-found-running-number = non valutato: solo il numero corrisponde a { $name } del piano, e può essere un numero progressivo, perché altre righe del file non sono di questo piano
plan-not-found-other-nominal = non valutato: corrisponde a { $name } del piano, ma la sua quota nominale è { $given } e quella del piano { $planned }
plan-not-found-other-limits = non valutato: corrisponde a { $name } del piano, ma i suoi limiti { $given } non hanno nulla in comune con quelli del piano, { $planned }
plan-not-found-several = non valutato: più elementi del piano hanno questa posizione: { $names }
plan-not-found-which-side = non valutato: il valore non dice quale è tra { $names }
part-standing =
    { $measured ->
        [one] 1 misurata
       *[other] { $measured } misurate
    }, { $missing ->
        [one] 1 mancante
       *[other] { $missing } mancanti
    }, { $skipped ->
        [one] 1 saltata
       *[other] { $skipped } saltate
    }
plan-not-found-other-kind = non valutato: corrisponde a { $name } del piano, che però è di tipo { $kind }, ed è stato misurato altro
plan-remark-file = { $said }
plan-remark-left = { $name } viene saltato: { $why }
plan-remark-class-left = { $name }: { $class } ha limiti diversi dal file; valgono i limiti del file
plan-remark-place-left = { $name }: nessuna posizione tratta dal file: { $why }
plan-remark-axes-assumed = posizioni: il file non dice lungo quali assi giacciono fori e alberi; si suppone Z
plan-remark-uncertainty-left = { $name }: l'incertezza estesa di { $expanded } mm viene saltata, perché la sua metà non è un numero intero di nanometri
plan-remark-clearance-raised = { $name } è sopra l’altezza di sicurezza abituale: è scritto { $height }
plan-simulated-no-place = { $name } non ha una posizione nel piano: non si può simulare
plan-simulated-no-cycle = nessun ciclo misura { $name }: non si può simulare
