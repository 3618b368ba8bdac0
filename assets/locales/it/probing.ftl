# probing

# Da dove viene una misura, e che cosa non può dire.
origin-simulated = simulato, ciclo { $cycle }, seme { $seed }
origin-contacts = punti di contatto da { $file }
origin-imported = importato da { $file }
origin-imported-simulation = importato da { $file }, simulato
origin-typed = digitato
caveat-only-a-diameter = un solo diametro: forma e posizione non sono note
caveat-only-a-circle = solo diametro e centro: la forma non è nota
caveat-three-contacts = 3 punti di contatto: la forma non si può misurare
caveat-four-contacts = 4 punti di contatto: nessuna forma oltre l'ovalità viene rilevata
caveat-few-contacts = { $contacts } punti di contatto: la forma tra l'uno e l'altro non viene rilevata
caveat-short-arc = i punti di contatto coprono solo { $arc }°: la dispersione è amplificata nel diametro e nel centro
caveat-two-point = il diametro tra i contatti { $one } e { $other } è { $size } mm, oltre il limite di { $limit } mm, che il cerchio medio non supera: per regola una dimensione vale tra due punti opposti qualsiasi
caveat-form = i raggi dei punti di contatto differiscono di { $form } mm, quindi i diametri possono differire più della zona di tolleranza di { $zone } mm: due punti opposti possono essere fuori dai limiti
caveat-heights = le altezze dei punti di contatto differiscono di { $spread } mm: su un cono o un asse inclinato questo cambia il diametro
caveat-stated = la quota indica dopo la tolleranza { $upper } e { $lower } µm, la tolleranza ha { $used-upper } e { $used-lower } µm: vale la tolleranza; verificare che cosa intende il disegno
caveat-count = la quota vale per { $count } elementi: questo valore è quello di uno
caveat-form-class = la classe { $class } della ISO 2768-2 vale per forma e posizione: la dimensione non le mostra
caveat-each-two-point = { $modifier } richiede ogni dimensione tra due punti entro i limiti: questo è un solo diametro
caveat-mean-of-two-points = { $modifier } richiede ogni dimensione tra due punti entro i limiti: il diametro ai minimi quadrati è solo la loro media
caveat-not-least-squares = { $modifier } indica la dimensione ai minimi quadrati: un solo diametro non la mostra
caveat-one-section = { $modifier } indica la dimensione ai minimi quadrati dell'intero elemento: questa è quella di una sezione
caveat-envelope = { $modifier } richiede l'inviluppo di forma perfetta alla dimensione di massimo materiale: un diametro non mostra se la superficie lo supera; usare un calibro
caveat-other-size = { $modifier } indica una dimensione diversa da quella misurata: un diametro tra due punti o ai minimi quadrati non la dimostra
caveat-condition = { $modifier } dice dove o come vale la dimensione: il valore misurato non mostra se è rispettato
contact-beyond-travel = il contatto { $number } è a { $distance } mm da dove comincia la sua tastatura, e la sfera percorre al massimo { $allowed } mm (DIST o K, più SET_UP della tabella di tastatura e Q320): verificare che questi punti di contatto siano di questo elemento, in questo ordine e riferiti a questo zero
contact-missed = contatto { $number }: il sistema di tastatura non ha incontrato nulla sulla corsa di tastatura
contact-no-height = il contatto { $number } non ha altezza: aggiungere al file una colonna z
contact-used-up = contatto { $number }: il file ha solo { $available ->
    [one] { $available } punto di contatto
   *[other] { $available } punti di contatto
    }

cycle-out-of-range = { $key } { $name } = { $given }: { $allowed }
cycle-length-range = almeno { $least } mm, al massimo { $most } mm
cycle-angle-range = al massimo { $most } nei due versi
cycle-angle-size-range = in valore assoluto almeno { $smallest }, al massimo { $most }
cycle-one-of = atteso uno tra { $allowed }
cycle-tool-range = un numero utensile da 0 a 99999.9, o un nome utensile di al massimo 255 caratteri
cycle-not-a-value = { $key } { $name }: { $error }
cycle-tool-no-name = { $text } non chiama alcun utensile: scriverne il numero o il nome
cycle-tool-empty = nessun utensile indicato: per nessuno scrivere Q330=0
cycle-tool-unquoted = { $text } non è un numero, e un nome utensile richiede virgolette
cycle-no-diameter = { $key } { $name } = 0 mm: un cerchio richiede un diametro maggiore di 0
cycle-one-limit = { $given } è indicato senza { $missing }: l'altro limite sarebbe 0
cycle-missing = manca { $key } { $name }
cycle-no-such-parameter = il ciclo { $cycle } non ha il parametro { $parameter }: i suoi parametri sono { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm è sopra { $maximum-key } = { $maximum } mm: la quota minima è sopra la massima
cycle-too-large = il cerchio misurato è troppo grande: { $error }
workpiece-cannot-be = { $what } = { $given }: almeno { $least }, al massimo { $most }

# Contatti.
contact-in-material = contatto { $number }: la corsa di tastatura comincia dentro il materiale
contact-in-feature = contatto { $number }: la corsa di tastatura comincia dentro il materiale di { $feature }
contact-behind = contatto { $number }: la sfera raggiunge la parete di { $feature } da dietro, e lo spessore del materiale lì non è noto
contact-ambiguous = contatto { $number }: la sfera incontra { $feature } e { $other } nello stesso punto, quindi non è noto quale si misura

# Calcolo del cerchio.
circle-too-few = un cerchio richiede almeno 3 punti di contatto, trovati { $contacts }
circle-coinciding = i punti di contatto { $first } e { $second } coincidono in x = { $x }, y = { $y }: un cerchio richiede 3 punti diversi
circle-collinear = tutti i { $contacts } punti di contatto stanno su una retta: nessun cerchio vi passa
circle-straight = per i { $contacts } punti di contatto una retta è più adatta di qualsiasi cerchio
circle-not-finite = contatto { $contact }: { $axis } = { $value } non è un numero finito
circle-too-large = { $what } = { $value } mm è troppo grande: al massimo { $most } mm nei due versi
circle-part-contact = contatto { $contact }: { $axis }
circle-part-diameter = diametro
circle-part-centre = centro { $axis }
circle-three-contacts = 3 punti di contatto: la forma non si può misurare, il residuo è sempre zero
circle-four-contacts = 4 punti di contatto: quattro lobi non vengono rilevati e cambiano il diametro
circle-short-arc = i punti di contatto coprono solo { $arc }° di arco: la dispersione nel diametro è { $factor } volte quella di 3 punti di contatto a 120°
circle-circumscribed-of-short-arc = il minimo cerchio circoscritto di un arco corto non è la dimensione dell'elemento
circle-counts-twice = i punti di contatto { $first } e { $second } coincidono: questo punto conta due volte
circle-no-inscribed = nessun massimo cerchio inscritto: i punti di contatto non ne circondano uno
circle-no-zone = nessuna zona minima: una striscia diritta è più stretta di qualsiasi anello
circle-too-many-contacts = il massimo cerchio inscritto e la zona minima non vengono calcolati per { $contacts } punti di contatto: al massimo { $most }
circle-short-chord = i punti di contatto { $first } e { $second } sono opposti ma non passano per il centro: questa dimensione è troppo piccola di { $short } µm
circle-more-of-a-kind = lo stesso vale per altri { $more }
circle-apart = il contatto { $contact } è a { $apart } mm dal cerchio, molto più degli altri: sporco o falso scatto?
circle-heights = le altezze dei punti di contatto differiscono di { $spread } mm: su un cono o un asse inclinato questo cambia il diametro

## Cicli di misura: errori, risultati, note
contact-out-of-reach = contatto { $number }: il sistema di tastatura non ha incontrato nulla entro la corsa di tastatura di { $longest } mm
cycle-number-range = un numero, al massimo { $most } nei due versi
cycle-count-range = un numero intero da 0 a { $most }
cycle-band-range = una tolleranza come 0.4-0.1, 0.4 o -0.1; 0 significa nessuna tolleranza
cycle-range = { $range }
cycle-range-tool = 0 … { $highest }, o al massimo { $longest } caratteri
cycle-range-band = 0.4-0.1, 0.4, -0.1 o nulla
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = nessuna tolleranza
cycle-no-global = { $key } { $name } = PREDEF: nessun GLOBAL DEF dà un valore
cycle-no-path = { $key } { $name } = 0 mm: una corsa di tastatura richiede una lunghezza; il segno dà la direzione
cycle-no-transfer = { $row-key } = { $row } con { $key } = -1: non è indicato in quale tabella è quella riga; { $key } deve essere 0 o 1 (un controllo numerico segnala l'errore 1078)
cycle-other-feature = { $key } { $name } = { $given }: la classe non corrisponde a { $geometry }: le maiuscole valgono per un foro, le minuscole per un’isola
cycle-not-measured = { $key } { $name } = { $given }: il ciclo non misura questo valore: scriverlo senza tolleranza
cycle-inch-tolerance = { $key } { $name } = { $given }: in un programma in pollici l’unità di una tolleranza non è nota: scrivere un programma in mm o il numero senza tolleranza
cycle-no-edge = { $first } e { $second } sono uguali: uno spigolo richiede due punti lungo di esso
cycle-no-sphere = i contatti non determinano una sfera
cycle-no-rotation = { $key } { $name }: Fitcheck segue solo una rotazione base (Q1121 = 1), e senza correzione (Q1120 = 0)
cycle-no-normal = { $first }, { $second } e { $third } sono tutti 0: una normale richiede una direzione
cycle-apart = contatto { $contact }: le sue due tastature distano { $difference } mm, { $key } ammette { $most } mm
cycle-too-far = la coordinata misurata è troppo grande: { $error }
cycle-stop = arresto del programma per Q309 = { $setting }: { $out }
check-within = { $what } { $measured } mm è tra { $minimum } e { $maximum } mm
check-above = { $what } { $measured } mm è sopra il massimo { $maximum } mm: { $status }
check-below = { $what } { $measured } mm è sotto il minimo { $minimum } mm: { $status }
check-and = { $one }; { $other }
found-centre-1 = centro misurato, 1° asse
found-centre-2 = centro misurato, 2° asse
found-centre-3 = centro misurato, 3° asse
found-diameter = diametro misurato
found-centre-deviation-1 = scostamento del centro, 1° asse
found-centre-deviation-2 = scostamento del centro, 2° asse
found-centre-deviation-3 = scostamento del centro, 3° asse
found-diameter-deviation = scostamento del diametro
found-coordinate = coordinata misurata
found-coordinate-deviation = scostamento della coordinata
found-position-1 = posizione misurata, 1° asse
found-position-2 = posizione misurata, 2° asse
found-position-3 = posizione misurata, 3° asse
found-angle = angolo misurato
found-deviation-1 = scostamento, 1° asse
found-deviation-2 = scostamento, 2° asse
found-deviation-3 = scostamento, 3° asse
found-deviation-along = scostamento lungo la normale
found-second-position-1 = 2. punto: posizione misurata, 1° asse
found-second-position-2 = 2. punto: posizione misurata, 2° asse
found-second-position-3 = 2. punto: posizione misurata, 3° asse
found-second-deviation-1 = 2. punto: scostamento, 1° asse
found-second-deviation-2 = 2. punto: scostamento, 2° asse
found-second-deviation-3 = 2. punto: scostamento, 3° asse
found-second-diameter = 2. cerchio: diametro misurato
found-second-diameter-deviation = 2. cerchio: scostamento del diametro
found-rotation = rotazione misurata
found-side-1 = lunghezza misurata, 1° lato
found-side-2 = lunghezza misurata, 2° lato
found-width = larghezza misurata
found-centre-line = posizione della linea mediana
found-side-deviation-1 = scostamento del 1° lato
found-side-deviation-2 = scostamento del 2° lato
found-width-deviation = scostamento della larghezza
found-good = entro tolleranza
found-rework = ripresa
found-scrap = scarto
found-status = stato: -1 non definito, 0 buono, 1 ripresa, 2 scarto
cycle-note-machine-builder = il costruttore della macchina deve abilitare e adattare questo ciclo: vedere il manuale della macchina
cycle-note-not-on-itnc530 = un iTNC 530 non ha questo ciclo; TNC 320, TNC 620, TNC 640 e TNC7 lo hanno
cycle-note-normal-from-cad = ricavare la normale da un sistema CAD o CAM
cycle-note-software-option = il controllo numerico richiede l'opzione software { $option }
cycle-note-recommended = dove il controllo numerico ha il ciclo { $cycle }, HEIDENHAIN consiglia quello
cycle-note-ends-rotation = termina una rotazione base attiva
remark-without-effect = { $key } è accettato ma non ha effetto
remark-tool-not-monitored = Q330 = { $tool }: l'utensile non viene controllato: nessuna tabella utensili
remark-outside-dimension = si suppone una quota esterna: sopra il massimo è ripresa, sotto il minimo è scarto
remark-nominal-outside-limits = il diametro nominale { $nominal } mm non è tra i limiti: un TNC7 lo rifiuta
remark-nominal-width-outside-limits = la larghezza nominale { $nominal } mm non è tra i limiti: un TNC7 la rifiuta
remark-nominal-coordinate-outside-limits = la coordinata nominale { $nominal } mm non è tra i limiti: secondo il suo manuale un TNC7 può rifiutarla
remark-contact-astray = { $count ->
    [one] il contatto { $contact } è a { $distance } mm da dove tasta il ciclo: forse appartiene a un altro elemento
   *[other] { $count } punti di contatto sono lontani da dove tasta il ciclo, il contatto { $contact } di { $distance } mm: forse appartengono a un altro elemento
}
remark-deviation-without-parameter = lo scostamento qui non ha un parametro: il manuale dice che un controllo numerico lo memorizza, ma non in quale
remark-new-datum = nuova origine, { $target }: { $axes } mm (misurato → voluto)
datum-target-display = subito attiva
datum-target-active = correzione dell’origine attiva
datum-target-preset = riga { $row } della tabella origini
datum-target-table = riga { $row } della tabella punti zero
remark-new-rotation = nuova rotazione base di { $angle }: { $target }
remark-axis-turned = l'asse { $axis } ruota il pezzo di { $angle }: solo la macchina sa dov'è il suo centro, e Fitcheck non scrive il suo zero in nessuna tabella
remark-variable-holds-diameter = #i99 viene letto come diametro: il manuale non dice quale valore contenga
remark-no-tolerance = { $key } non è una tolleranza: nulla viene valutato

## La macchina simulata
workpiece-file-toml = linea { $line }: { $said }
workpiece-file-too-large = un file di pezzo in lavorazione ha al massimo { $most } KiB
workpiece-file-not-one = il file ha { $found } tra { $tables }: ne serve esattamente uno
workpiece-file-cannot-be = linea { $line }: { $error }
workpiece-file-several = il file ha tabelle [[feature]]: qui è atteso un pezzo in lavorazione con una sola superficie
workpiece-file-too-many = un pezzo ha al massimo { $most } elementi
workpiece-file-feature = linea { $line }, colonna { $column }: { $feature }: { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } non è un tipo di elemento: i tipi sono { $known }
feature-fault-no-key = { $kind } richiede { $key }
feature-fault-other-key = { $kind } non ha { $key }
feature-fault-name = un nome ha da 1 a { $most } caratteri su una linea
feature-fault-same-name = un altro elemento ha lo stesso nome

# Dati del pezzo in lavorazione simulato, come li chiamano gli errori.
figure-temperature = temperatura
figure-expansion = dilatazione
figure-probe-scatter = dispersione del tastatore
figure-ball-radius = raggio della sfera
figure-calibration-error = errore di calibrazione
figure-offset = eccentricità della sfera
figure-lobing = ampiezza della precorsa
figure-lobing-angle = angolo della precorsa
figure-lobing-count = lobi della precorsa
figure-centre-x = centro x
figure-centre-y = centro y
figure-diameter = diametro
figure-surface-scatter = dispersione della superficie
figure-ovality = ovalità
figure-ovality-angle = angolo dell'ovalità
figure-ovality-count = numero di ovalità
figure-lobe-height = altezza dei lobi
figure-lobe-angle = angolo dei lobi
figure-lobes = lobi
figure-point = punto
figure-normal = normale
figure-normal-length = lunghezza della normale
figure-wave-length = lunghezza d'onda
figure-wave-amplitude = ampiezza dell'onda
figure-wave-direction = direzione dell'onda
figure-deviation = scostamento
figure-radius = raggio
figure-width = larghezza
figure-first-length = 1ª lunghezza
figure-second-length = 2ª lunghezza
figure-angle = angolo
figure-top = bordo superiore
figure-bottom = bordo inferiore
figure-length = lunghezza delle pareti
figure-reach = portata
figure-stylus-radius = raggio dello stilo

## Ciò che del tastatore tocca.
mover-ball = la sfera
mover-stylus = lo stilo
