# tolerance

## Lunghezze
length-empty = manca una lunghezza
length-not-a-number = { $text } non è un numero
length-ambiguous = { $text } è ambiguo: scrivere un solo segno decimale e nessun separatore delle migliaia
length-too-fine = { $text } è più fine di un nanometro
length-too-large = { $text } è troppo grande: al massimo { $max } mm nei due versi

## Indicazioni e classi
callout-empty = manca un'indicazione di tolleranza: scrivere una quota nominale e una classe di tolleranza, come 25 H7
callout-no-nominal = { $text } non comincia con una quota nominale: scriverla, come 25 H7
callout-nominal = quota nominale: { $error }
callout-not-positive = la quota nominale { $nominal } mm non è maggiore di 0
class-missing = manca una classe di tolleranza, come H7 per un foro o h7 per un albero
class-mixed-case = { $text } mescola maiuscole e minuscole: scrivere { $upper } per un foro o { $lower } per un albero
class-malformed = { $text } non è una classe di tolleranza: scrivere lettere e un grado, come H7 o js13

## Scostamenti e limiti
deviations-order = lo scostamento superiore { $upper } mm è sotto lo scostamento inferiore { $lower } mm
nominal-by-operator = ? significa che l’operatore posiziona il tastatore: scrivere il valore nominale senza questo segno
nominal-not-probed = @ significa che il controllo non tasta e prende il valore che segue: non si misurerebbe nulla
source-choice-iso286 = ISO 286, ogni classe fino a 3150 mm
source-choice-control = Tabelle del controllo numerico, 47 classi fino a 400 mm
source-choice-after-own = Tabelle proprie, poi { $base }
source-iso286 = ISO 286, oltre { $over } fino a { $to } mm
source-iso286-remark = ISO 286, oltre { $over } fino a { $to } mm; { $remark }
source-shipped-table = tabella integrata { $name }, oltre { $over } fino a { $to } mm
source-table = tabella { $name }, oltre { $over } fino a { $to } mm
figure-own-table = { $class } oltre { $over } fino a { $to } mm: la tabella { $table } differisce da ISO 286, che ha { $upper } e { $lower } mm
figure-standard = { $class } oltre { $over } fino a { $to } mm: { $why }
source-file = file { $name }
source-iso2768 = ISO 2768-1 classe { $class }, oltre { $over } fino a { $to } mm
source-callout = indicazione stessa
source-without-own = { $source }; non è stato possibile leggere le tabelle proprie in { $folder }
source-recorded = { $text }
limits-own-awaited = La lettura delle tabelle proprie in { $folder } è ancora in corso
limits-no-feature = { $callout } non dice se si intende il foro o l'albero
limits-other-feature = { $feature ->
    [hole] { $class } è una classe per fori e non per alberi
   *[shaft] { $class } è una classe per alberi e non per fori
}
limits-other-case = { $feature ->
    [hole] { $class } è una classe per fori e la tabella { $table } non la contiene; la classe per alberi è { $other }
   *[shaft] { $class } è una classe per alberi e la tabella { $table } non la contiene; la classe per fori è { $other }
}
limits-unknown-class = { $class } non è nella tabella { $table }; questa contiene { $known }
limits-no-own-table = { $class } non è una classe di tolleranza di ISO 286: scrivere lettere e un grado, come H7 o js13, o scegliere tabelle proprie con una colonna { $class }
limits-no-own-column = { $class } non è una classe di tolleranza di ISO 286, e la tabella { $table } non ha una colonna { $class }: contiene { $known }
limits-beyond-last-range = la quota nominale { $nominal } mm è oltre la tabella { $table }, il cui ultimo campo va da oltre { $over } fino a { $to } mm compresi
limits-not-defined = { $class } non è definita oltre { $over } fino a { $to } mm nella tabella { $table }; { $where }
limits-defined-nowhere = non è definita per alcuna dimensione
limits-defined = è definita { $ranges }
limits-range = oltre { $over } fino a { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = i limiti di { $nominal } mm sono troppo grandi

## Zone fuori da ogni proporzione
zone-micrometres = una zona di tolleranza di { $width } mm è sproporzionata rispetto a { $nominal } mm, il cui IT 18 è { $widest } mm: se gli scostamenti sono in micrometri, scrivere { $offer }
zone-wide = una zona di tolleranza di { $width } mm è sproporzionata rispetto a { $nominal } mm, il cui IT 18 è { $widest } mm: verificare quota nominale e limiti
zone-micrometres-to-zero = il limite minimo { $minimum } mm non è maggiore di 0: se gli scostamenti sono in micrometri, scrivere { $offer }
zone-to-zero = il limite minimo { $minimum } mm non è maggiore di 0: verificare quota nominale e limiti
zone-coordinate-micrometres = una zona di tolleranza di { $width } mm è più ampia di { $widest } mm, il massimo per una coordinata: se gli scostamenti sono in micrometri, scrivere { $offer }
zone-coordinate = una zona di tolleranza di { $width } mm è più ampia di { $widest } mm, il massimo per una coordinata: verificare i limiti

shape-no-ranges = la tabella non ha alcun campo di dimensioni
shape-not-ascending = il campo di dimensioni fino a { $end } mm non finisce oltre il precedente, { $before } mm
shape-cells = la colonna { $class } ha { $cells } celle per { $ranges } campi di dimensioni
shape-twice = la colonna { $class } compare due volte

## Esiti
status-good = BUONO
status-accepted = ACCETTATO
status-rework = RIPRESA
status-re-measure = RIMISURARE
status-out-of-limits = FUORI LIMITE
status-scrap = SCARTO
rule-simple = nessuna banda di guardia, i limiti fanno parte della zona di tolleranza
rule-iso14253-2017 = ISO 14253-1:2017, conformità 95 %, { $prover ->
    [customer] il cliente prova la non conformità
   *[supplier] il fornitore prova la conformità
    }; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, banda di guardia U, { $prover ->
    [customer] il cliente prova la non conformità
   *[supplier] il fornitore prova la conformità
    }; { $u }
rule-ilac-g8 = ILAC-G8, banda di guardia { $factor } U, { $prover ->
    [customer] il cliente prova la non conformità
   *[supplier] il fornitore prova la conformità
    }; { $u }
rule-asme-simple = ASME B89.7.3.1, accettazione semplice 4:1; { $u }
rule-asme-stringent = ASME B89.7.3.1, accettazione restrittiva, banda di guardia { $factor } U; { $u }
rule-asme-relaxed = ASME B89.7.3.1, accettazione permissiva di { $factor } U; { $u }
rule-fixed = banda di guardia { $width } µm, { $prover ->
    [customer] il cliente prova la non conformità
   *[supplier] il fornitore prova la conformità
    }
rule-no-uncertainty = la regola { $rule } richiede l'incertezza del valore misurato
rule-no-factor = la regola { $rule } non ha un fattore
rule-no-width = la regola { $rule } calcola la banda di guardia dall'incertezza
rule-width-missing = la regola { $rule } richiede una banda di guardia maggiore di 0 µm
rule-no-prover = la regola { $rule } non dipende dall'onere della prova
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = un'incertezza deve essere maggiore di 0 µm
uncertainty-factor = fattore di copertura { $given }: atteso un numero da 1 a 10, con al massimo tre decimali
uncertainty-by-budget = u di ogni valore secondo il bilancio
undecided-contacts = i { $contacts } punti di contatto rendono il diametro { $times } volte meno certo di { $contacts } punti di contatto sull'intero cerchio, ma l'incertezza indicata vale solo fino a 3 volte: distribuire i punti su un arco più lungo, o indicare un bilancio
doubt-times-inch = valore misurato è 25,4 volte la quota nominale: è stato convertito due volte da pollici?
doubt-inches = valore misurato è la quota nominale divisa per 25,4: è in pollici?
doubt-double = valore misurato è il doppio della quota nominale: un diametro è stato preso per un raggio?
doubt-half = valore misurato è la metà della quota nominale: è un raggio?
doubt-decimal-sign = valore misurato è circa la quota nominale con il segno decimale spostato: si intende { $meant } mm?
doubt-far = valore misurato è { $distance } mm fuori dai limiti: è di questo pezzo, in millimetri?
doubt-implausible = valore misurato è fuori da ciò che il piano dice possibile, da { $lower } a { $upper } mm: unità e segno decimale sono giusti?

## File
file-is-folder = è una cartella, non un file: { $path }
file-missing = file o cartella inesistente: { $path }
file-exists = un file o una cartella di questo nome esiste già: { $path }
file-half-set = la scrittura di un set di file si è fermata a metà, quindi nella cartella alcuni file sono vecchi e altri nuovi: scrivere di nuovo il set per completarlo; ciò che resta da spostare è in { $path }
file-not-a-file = è una pipe o un dispositivo, non un file: { $path }
file-changed = il file è cambiato durante la lettura; leggerlo di nuovo: { $path }
file-busy = il file è aperto in un altro programma: chiuderlo lì e riprovare: { $path }
file-stopped = interrotto: non è stato scritto nulla: { $path }
file-too-large = il file supera { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-grade-missing = { $class } non è una classe di tolleranza di ISO 286: scrivere lettere e un grado, come H7 o js13
iso286-no-grade = { $class } non è una classe di tolleranza di ISO 286: i gradi sono { $grades }
iso286-no-letter = { $class } non è una classe di tolleranza di ISO 286: la lettera { $letters } non esiste, solo { $known }
iso286-too-large = la quota nominale { $nominal } mm è oltre ISO 286, che finisce a 3150 mm
iso286-not-here = { $class } non è definita a { $nominal } mm in ISO 286; { $where }
iso286-js-rounded = JS arrotondato come nel 1988
iso286-contested-ef = controverso: ef è qui 28 µm, altre fonti hanno 25 µm
iso286-older-it5 = in uso sperimentale; i cataloghi meno recenti hanno qui un IT5 minore
iso286-trial-use = in uso sperimentale

## Accoppiamenti
fit-kind-clearance = accoppiamento con gioco
fit-kind-transition = accoppiamento incerto
fit-kind-interference = accoppiamento con interferenza
fit-basis-hole = foro base
fit-basis-shaft = albero base
fit-basis-both = foro base e albero base
fit-preferred-hole-basis = accoppiamento preferenziale foro base
fit-preferred-shaft-basis = accoppiamento preferenziale albero base
fit-function-loose-running = libero ampio
fit-function-free-running = libero normale
fit-function-close-running = libero stretto
fit-function-sliding = scorrevole
fit-function-locational-clearance = di posizione con gioco
fit-function-locational-transition = di posizione, incerto
fit-function-locational-transition-tighter = di posizione, incerto, più stretto
fit-function-locational-interference = di posizione con interferenza
fit-function-medium-drive = bloccato medio
fit-function-force = bloccato forte
fit-one-sided = { $callout } non è un accoppiamento: scrivere una dimensione, una classe per fori e una per alberi, come 25 H7/g6
fit-not-a-hole = da { $minimum } a { $maximum } mm sono i limiti di un albero: attesi quelli di un foro
fit-not-a-shaft = da { $minimum } a { $maximum } mm sono i limiti di un foro: attesi quelli di un albero
fit-nominal-sizes = un accoppiamento ha una sola quota nominale: il foro ha { $hole } mm, l'albero { $shaft } mm
fit-too-large = il gioco è troppo grande
fit-search-order = il gioco minimo { $minimum } mm è maggiore del gioco massimo { $maximum } mm
fit-search-no-classes = le tabelle non hanno classi sia per fori sia per alberi a { $nominal } mm
fit-thermal-too-fine = { $text } ha più di tre decimali
fit-thermal-temperature = una temperatura di { $text } °C è fuori campo: da -273,15 a 1000 °C
fit-thermal-expansion = una dilatazione di { $text } è fuori campo: da -20 a 500, in milionesimi per kelvin, come 11,5 per l'acciaio
fit-thermal-expansion-unit = una dilatazione di { $text } è in un'altra unità: le dilatazioni sono in milionesimi per kelvin; scrivere { $meant }

## Temperature dubbie
thermal-doubt-fahrenheit = { $given } °C è lontano da ogni temperatura a cui si misurano pezzi: se è in gradi Fahrenheit, scrivere { $meant }
thermal-doubt-kelvin = { $given } °C è lontano da ogni temperatura a cui si misurano pezzi: se è in kelvin, scrivere { $meant }
thermal-doubt-far = { $given } °C è lontano da ogni temperatura a cui si misurano pezzi, da { $least } a { $most } °C: verificarla
thermal-doubt-beyond = { $given } °C è fuori dal campo da { $least } a { $most } °C, in cui vale una dilatazione di { $expansion } milionesimi per kelvin: indicare la dilatazione per questa temperatura

## Materiali
material-published = valore pubblicato
material-verify = valore usuale, da verificare
material-own = valore proprio
material-toml = { $reason }
material-version = la versione { $found } del file dei materiali non è supportata: attesa la versione { $known }
material-too-many = { $count } materiali sono troppi: al massimo { $most }
material-too-large = un file dei materiali ha al massimo { $most } byte
material-name = il nome di un materiale ha da 1 a { $longest } caratteri e nessun carattere di controllo
material-range = un campo di temperatura comincia con la più bassa: scrivere due numeri in °C, come [-50, 200]
material-elastic = modulus e poisson vanno insieme: modulus da 1 a 1200000 MPa, poisson da 0 a 0.5, yield da 1 a 10000 MPa
material-twice = il materiale { $name } è definito due volte
material-unknown = materiale sconosciuto { $name }: sceglierne uno tra { $known }, o indicare la dilatazione stessa, come 11,5
## Indicazioni: scostamenti, limiti, accoppiamenti e tolleranze generali
callout-at = { $reason } (carattere { $at })
callout-no-tolerance = manca una tolleranza, come H7, h7, H7/g6, m, +0,1 -0,2 o ±0,1
callout-general-capital = { $capital } non ha un grado: scrivere { $offer } per la tolleranza generale di ISO 2768-1, o aggiungere un grado, come { $capital }7
callout-fit-order = l'albero sta prima del foro: scrivere { $offer }
callout-fit-side = { $first } e { $second } non sono un foro e un albero: un accoppiamento si scrive con lettere maiuscole, poi minuscole, come 25 H7/g6
callout-number = { $part }: { $error }
callout-not-a = { $found } non è valido come { $part }: { $how }
callout-missing = manca: { $part }; { $how }
callout-part-deviation = scostamento
callout-part-limit = dimensione limite
callout-part-actual = valore dopo @
callout-how-deviation = scrivere un segno e un numero, come +0,1 o -0,1
callout-how-limit = scrivere due dimensioni, prima la maggiore, come 12,01/11,985
callout-how-actual = scrivere un numero, come 10H7@10,004
callout-no-sign = { $number } non ha segno: scrivere +{ $number } o -{ $number } per uno scostamento, senza spazi nel numero
callout-no-unit = { $number } non ha unità e l'altro scostamento è in µm: scrivere l'unità dopo entrambi
callout-deviation-order = lo scostamento inferiore sta prima del superiore: scrivere { $offer }
callout-limits-order = il limite minore sta prima del maggiore: scrivere { $offer }
callout-limits-apart = { $larger } mm è più del doppio di { $smaller } mm, quindi probabilmente non sono limiti: scrivere scostamenti, come 12 +0,2 0
callout-limits-or-deviation = è ambiguo: scrivere { $limits } per dimensioni limite o { $deviation } per uno scostamento inferiore
callout-limits-meant = con un tale scostamento non resterebbe alcuna dimensione: scrivere { $limits } per dimensioni limite
callout-minimum-not-positive = il limite minimo { $minimum } mm non è maggiore di 0
callout-micrometres-meant = il limite minimo { $minimum } mm non è maggiore di 0: se gli scostamenti sono in micrometri, scrivere { $offer }
callout-mixed-decimals = { $number } ha un segno decimale diverso dal numero precedente: usarne uno solo
callout-cycle-sign = { $sign } è per i testi dei cicli 14xx, non per un'indicazione
callout-not-in-cycle-text = { $found } non può stare in un testo dei cicli 14xx: scrivere una classe, una classe generale o scostamenti
callout-too-much = { $found } qui non è atteso: il testo è completo senza
callout-too-long = il testo è troppo lungo: al massimo { $most } caratteri
callout-band-order = lo scostamento inferiore sta prima del superiore: scrivere QS400 come 0.4-0.1
callout-lone-order = lo scostamento inferiore sta prima del superiore: scrivere { $offer }
callout-inch = { $given } è { $nominal } mm: le quote sono in millimetri, scrivere { $offer }
callout-inch-size = { $given } è { $nominal } mm: scrivere dimensione e tolleranza in millimetri
callout-inch-somewhere = { $given } è in pollici: scrivere dimensione e tolleranza in millimetri, 1 pollice è 25.4 mm
callout-thread = { $given } è una filettatura, non un foro o albero liscio: scrivere il diametro di nocciolo o medio con entrambi i limiti, come 5.153/4.917
callout-exact = una quota teoricamente esatta non ha una tolleranza propria: scrivere la dimensione con i limiti che le si applicano, come 25 ±0.1
callout-reference = una quota tra parentesi è solo ausiliaria e non ha tolleranza: scriverla senza parentesi se va giudicata
callout-one-sided = { $given } ha un solo limite: scrivere entrambi i limiti, il maggiore per primo, come 8.2/8
callout-roughness = { $given } è una rugosità, non una dimensione: scrivere una dimensione con tolleranza, come 25 H7
callout-modifier = { $given } non è un modificatore della ISO 14405-1: i modificatori sono { $known }
callout-grade = { $given } non è definito a { $nominal } mm: scrivere un grado da IT1 a IT18 che la ISO 286 prevede lì
callout-ansi = { $class } è una classe della ANSI B4.1, le cui tabelle Fitcheck non ha: scrivere una classe ISO 286, oppure dimensione e scostamenti in millimetri
callout-stated-micrometres = gli scostamenti dopo la tolleranza sono sproporzionati rispetto a { $nominal } mm: se sono in micrometri, scrivere ({ $offer })
callout-stated-of-fit = gli scostamenti dopo un accoppiamento possono riguardare l'uno o l'altro pezzo: scriverli dopo ciascuna classe
iso286-grade-alone = { $class } è un grado: dice quanto è ampia una zona, ma non dove si trova; scrivere ±{ $grade }/2 o una classe, come H7
general-too-small = la quota nominale { $nominal } mm è sotto { $first } mm, dove comincia ISO 2768-1: scrivere gli scostamenti accanto alla quota
general-too-large = la quota nominale { $nominal } mm è oltre ISO 2768-1, che finisce a { $last } mm
general-not-defined = ISO 2768-1 non definisce la classe { $class } { $range }; è definita { $defined }
general-range-from = da { $over } fino a { $to } mm

## Tabelle ricavate dalla norma
make-no-class = nessuna classe di tolleranza indicata: indicarne una o più, come H7 H8 JS9
make-both-features = { $hole } e { $shaft } non possono stare in una stessa tabella: differiscono solo per maiuscole e minuscole, quindi creare una tabella per fori e una per alberi
make-last-size = l'ultima dimensione è { $to } mm: deve essere maggiore di 0 e al massimo 3150 mm

## Press fits
press-no-interference = l'accoppiamento ha un gioco di almeno { $clearance } mm: un accoppiamento forzato richiede interferenza, come 40 H7/s6
press-length = lunghezza { $length } mm non è maggiore di 0
press-hub-outer = diametro esterno del mozzo { $given } mm non è maggiore del diametro di accoppiamento, { $nominal } mm
press-shaft-bore = foro dell'albero { $given } mm: scrivere 0 per un albero pieno, o un foro minore di { $nominal } mm
press-roughness = rugosità { $given } mm è minore di 0
press-friction = un accoppiamento forzato richiede un attrito maggiore di 0
press-material = il modulo di elasticità di { $name } non è noto: scegliere un altro materiale, o aggiungere modulus e poisson a un file di materiali propri
press-ratio = { $text } non è un numero da 0 a 1 con al massimo tre decimali
press-yields = NON ELASTICO: la tensione { $part ->
    [hole] del mozzo
   *[shaft] dell'albero
    } sarebbe { $stress } MPa, oltre il limite di snervamento di { $limit } MPa: la teoria elastica non vale e non si dichiara che qualcosa tenga
press-yield-unknown = se { $part ->
    [hole] il mozzo
   *[shaft] l'albero
    } si snervi non è noto: il suo materiale qui non ha un limite di snervamento; indicarne uno
press-may-be-loose = i pezzi possono avere un gioco di { $clearance } mm: il collegamento potrebbe non tenere affatto
press-all-smoothed = lo spianamento della rugosità, { $loss } mm, può esaurire l'interferenza: il collegamento potrebbe non tenere affatto
press-no-roughness = nessuna rugosità Rz indicata: non si sottrae alcuna perdita di interferenza per spianamento
press-too-hot = riscaldare solo il mozzo non basta fino a { $most } °C, dove la sua dilatazione è nota
press-too-cold = raffreddare solo l'albero non basta, nemmeno in azoto liquido
press-contraction-unknown = la contrazione del materiale dell'albero al freddo non è nota: si usa la sua dilatazione, l'albero potrebbe dover essere più freddo
