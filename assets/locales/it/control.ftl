# control

# Maschere
mask-empty = la maschera è vuota
mask-too-large = la maschera supera { $most } KiB
mask-unknown = { $found } non è un record, una parola chiave o un commento
mask-unclosed-quote = le virgolette non sono chiuse
mask-unknown-format = { $found } non è un formato: sono ammessi %S %RS %F %LF %D %I %%
mask-too-wide = { $found } è troppo largo: al massimo { $most }
mask-count = { $formats } formati e { $parameters } parametri
mask-unknown-parameter = { $found } non è un parametro: sono ammessi Q, QL, QR, QS con un numero, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = manca il ; alla fine
mask-unknown-word = { $word } è sconosciuto e non ha effetto
mask-behind-semicolon = { $found } dopo il ; viene saltato
mask-other-languages = la maschera ha testi per { $languages } e nessuno per { $wanted }
mask-inverse-touching = { $first } e { $second } vengono stampati senza nulla in mezzo, quindi l'output non si può rileggere
mask-inverse-blanks = { $first } e { $second } sono testi separati solo da spazi, quindi l'output non si può rileggere: un testo può contenere spazi
mask-inverse-no-mark = nessun testo fisso segna l'inizio di un record, quindi l'output non si può rileggere
mask-inverse-too-long = la maschera stampa più di { $most } linee alla volta: si possono rileggere solo record più brevi
mask-inverse-no-number = la maschera non stampa alcun numero che possa essere un valore misurato
mask-undefined = { $name } non è definito
mask-text-as-number = { $name } è un testo, il formato richiede un numero
mask-number-as-text = { $name } è un numero, il formato richiede un testo
mask-not-finite = { $name } non è un numero finito
# Protocolli di misura
log-empty = il file è vuoto
log-no-log = non è un protocollo di misura: nessuna linea di titolo con il numero di un ciclo di misura
log-too-long = il protocollo ha più di { $lines } linee, o una linea di più di { $bytes } byte
log-no-title = il protocollo non ha una linea di titolo, quindi il suo ciclo è sconosciuto
log-other-cycle = i protocolli del ciclo { $cycle } non si possono leggere, solo quelli di { $known }
log-unit = l'unità di misura { $given } non è né 0 (mm) né 1 (inch)
log-count = { $section }: attesi { $expected }, trovati { $found }
log-missing = manca: { $section }; il protocollo è troncato o incompleto
log-no-label = nessuna etichetta prima di { $given }
log-cut-figure = il file finisce in questo valore: { $given } può essere incompleto
log-swapped = il massimo { $maximum } è sotto il minimo { $minimum }
log-uneven = i limiti { $minimum } e { $maximum } non sono simmetrici rispetto al valore nominale { $nominal }
log-deviation = lo scostamento { $given } non è valore reale meno valore nominale, { $actual } - { $nominal }
log-not-positive = il diametro { $given } non è maggiore di 0
log-section-nominal = sezione dei valori nominali
log-section-limits = sezione dei valori limite
log-section-actual = sezione dei valori reali
log-section-deviations = sezione degli scostamenti
log-no-unit = nessuna linea indica l'unità: si suppongono millimetri
log-no-time = data e ora della misura non sono note
log-no-deviations = mancano gli scostamenti: il protocollo può essere troncato
log-ignored = saltato: { $text }
log-text-before = saltato del testo prima del primo protocollo

## Tabelle
table-empty = il file è vuoto
table-not-text = il carattere { $code } non è testo: il file non è una tabella o è danneggiato
table-line-too-long = la linea supera { $limit } byte
table-too-large = la tabella ha più di { $limit } celle
table-too-many-columns = la tabella ha più di { $limit } colonne
table-no-begin = una tabella comincia con BEGIN e il suo nome, non con { $found }
table-no-name = dopo BEGIN manca il nome della tabella
table-unclosed-quote = le virgolette non sono chiuse
table-unclosed-block = { $block } della linea { $line } non è chiuso
table-second-block = le colonne sono descritte una seconda volta
table-unexpected = atteso { $expected }, trovato { $found }
table-not-a-size = { $key } deve essere un numero intero fino a { $limit }, non { $text }
table-no-columns = manca la linea con i nomi delle colonne
table-tab = carattere di tabulazione: separare le colonne solo con spazi
table-column-twice = la colonna { $name } compare due volte
table-short-row = la riga finisce prima della colonna { $name }: riempirla con spazi, o scrivere - per nessun valore
table-truncated = il file finisce in questa riga e senza [END]: può essere troncato
table-text-after-end = testo dopo [END]: { $found }
table-no-end = manca [END]
table-no-lock = la tabella utensili non ha la colonna TL: un utensile rotto non vi viene bloccato
table-no-unit = la tabella non indica la sua unità: le lunghezze sono state lette come millimetri
table-begin-word = { $word } non ha un significato noto nella linea BEGIN
table-width = la colonna { $name } è qui larga { $found } caratteri ma { $described } nella descrizione; vale la linea dei nomi delle colonne
table-not-in-table = la colonna { $name } è descritta ma non è nella tabella
table-not-described = la colonna { $name } non è descritta
table-skipped = { $name } è sconosciuto ed è stato saltato
table-write-too-wide = riga { $row }, colonna { $column }: { $text } non sta in { $width } caratteri
table-write-too-many-columns = la tabella ha { $columns } colonne; un iTNC 530 ne accetta al massimo { $limit }
table-write-too-long = le linee della tabella hanno { $characters } caratteri; un iTNC 530 ne accetta al massimo { $limit }
table-write-reads-otherwise = la tabella non si può scrivere in modo da rileggerla uguale: verificare i nomi della tabella e delle sue colonne

## Tabelle di scostamenti
deviations-no-tables = nessuna tabella di scostamenti (*.tab con una colonna BEREICH) in questa cartella: { $folder }
tables-contradict = { $first } e { $second } si contraddicono, { $class } oltre { $over } fino a { $to } mm: { $one ->
        [none] nessun valore
       *[other] { $one } µm
    } e { $other ->
        [none] nessun valore
       *[other] { $other } µm
    }: rimuovere la colonna da una delle due
deviations-two-range-columns = la tabella ha sia BEREICH sia BEREIK: solo una può contenere i campi di dimensioni
deviations-inch = la tabella è in pollici: scrivere i campi di dimensioni in millimetri e gli scostamenti in micrometri
deviations-no-class = nessuna colonna è una classe di tolleranza come H7
deviations-odd-rows = il numero di righe è dispari ({ $rows }): ogni campo di dimensioni ne occupa due, prima lo scostamento superiore, poi l'inferiore
deviations-no-range = manca la fine del campo di dimensioni
deviations-other-range = il campo di dimensioni fino a { $end } mm ha { $found } nella seconda riga: ripetere la fine o lasciarla vuota
deviations-column = colonna { $column }: { $error }
deviations-half = la colonna { $class } ha solo uno dei due scostamenti per il campo di dimensioni fino a { $end } mm
deviations-touches = la colonna { $column } e quella vicina si toccano: separarle con uno spazio
deviations-no-deviations = saltato, non è una tabella di scostamenti (nessuna colonna BEREICH): { $file }
deviations-range-alias = BEREIK è stato letto come BEREICH
deviations-other-column = la colonna { $name } è stata saltata, perché il suo nome non può essere una classe di tolleranza: in una tabella scritta da questa manca
deviations-no-numbers = la colonna { $name } è stata saltata, perché contiene testi e non scostamenti: in una tabella scritta da questa manca
deviations-mixed-case = la colonna { $name } è stata saltata, perché una classe di tolleranza non mescola maiuscole e minuscole: in una tabella scritta da questa manca

## Parametri
no-parameter = { $given } non è un parametro: sono ammessi Q, QL, QR e QS con un numero

## Scrittura di protocolli di misura
log-write-cycle = il ciclo { $cycle } non scrive questi valori
log-write-no-title = il protocollo del ciclo { $cycle } non ha titolo in { $file }
log-write-unit = un protocollo è in mm o in pollici, non in µm
log-write-character = { $given } non si può scrivere: un protocollo non può contenere il carattere U+{ $code }
log-write-program = { $given } non verrebbe riletto come percorso di un programma: scrivere un percorso come TNC:\PART\CHECK.H
log-write-unfinished = il file finisce in mezzo a una linea: può essere troncato, quindi non vi si aggiunge nulla
log-write-reads-otherwise = il protocollo non si può scrivere in modo da rileggerlo uguale: verificare data, ora e altri risultati

## Protocollo del ciclo 444
point-log-no-log = non è un protocollo del ciclo 444: la pagina non contiene alcuna misura leggibile da un programma
point-log-count = la pagina dice di contenere { $expected } misure, ma ne contiene { $found }: è troncata o è stata modificata
point-log-cut-off = la misura non ha fine: la pagina è troncata
point-log-json = la misura non è leggibile: { $what }
point-log-version = la versione { $version } del protocollo non è supportata: attesa { $known } o precedente
point-log-normal = la normale { $given } non ha direzione: servono tre numeri non tutti 0
point-log-deviation = lo scostamento { $given } in { $axis } non è coordinata misurata meno nominale, { $difference }
point-log-along = lo scostamento { $given } lungo la normale non deriva da quelli degli assi, { $along }
point-log-band = lo scostamento superiore { $upper } è sotto lo scostamento inferiore { $lower }
point-log-status = lo stato { $given } non deriva da scostamento e tolleranza, { $status }
## La tabella di tastatura
probe-table-no-column = la tabella non ha la colonna { $column }
probe-table-no-probe = la tabella non ha alcun sistema di tastatura
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: deve essere { $least }
probe-table-zero-or-more = 0 o maggiore
probe-table-above-zero = maggiore di 0
probe-table-not-whole = { $column } = { $given }: atteso un numero intero
probe-table-twice = il sistema di tastatura { $number } compare due volte

## La tabella utensili
tool-table-no-column = la tabella non ha la colonna { $column }
tool-table-no-tool = la tabella non ha alcun utensile
tool-table-touches = { $column }: la cella tocca quella vicina, quindi il suo valore è incerto
tool-table-no-number = { $column } = { $given }: atteso un numero utensile da 0 a 32767, con un indice come 5.1 o senza
tool-table-twice = l'utensile { $number } compare due volte
tool-table-name-too-long = NAME = { $given }: un nome ha al massimo { $most } caratteri
tool-table-no-length = { $column }: { $error }
tool-table-out-of-range = { $column } = { $given } mm: atteso da { $least } a { $most } mm
tool-table-no-lock = TL = { $given }: atteso L o 1 per un utensile bloccato; 0, - o nulla per uno libero
tool-table-not-whole = { $column } = { $given }: atteso un numero intero
tool-unknown = Q330 = { $tool }: la tabella utensili non ha questo utensile; contiene { $known }
tool-no-deviation = Q330 = { $tool }: il ciclo { $cycle } qui non ha limiti, quindi non c'è uno scostamento con cui correggere l'utensile
tool-out-of-range = utensile { $tool }: { $column } cambierebbe da { $from } a { $to } mm: il valore massimo è { $most } mm nei due versi
tool-broken = errore 1065: l'utensile { $tool } è rotto: { $column } cambierebbe di { $by } mm, { $limit } è { $most } mm; l'utensile viene bloccato e non corretto
tool-broken-replacement = errore 1065: l'utensile { $tool } è rotto: { $column } cambierebbe di { $by } mm, { $limit } è { $most } mm; l'utensile viene bloccato e non corretto; l'utensile gemello è { $replacement }
tool-corrected = utensile { $tool }: { $column } modificato di { $by } mm, da { $from } a { $to } mm
tool-corrected-rounded = utensile { $tool }: { $column } modificato di { $by } mm, da { $from } a { $to } mm: la tabella conserva il valore più vicino a 0,00001 in
tool-locked = utensile { $tool }: bloccato, TL = { $to }

## Il protocollo del risultato di un ciclo
cycle-log-other-verdict = i valori del protocollo, arrotondati a 0,0001 { $unit }, danno { $log } dove il ciclo ha dato { $cycle }

## Il blocco di un ciclo di tastatura
block-none = non è un ciclo di tastatura: un blocco comincia con TCH PROBE e un numero, o con G785
block-inches = il blocco appartiene a un programma in pollici ma verrebbe letto in mm: eseguire il programma
block-none-at = questa riga non è di alcun ciclo di misura: iniziano alle righe { $blocks }
block-second = secondo ciclo di tastatura: indicarne uno alla volta; il primo comincia alla linea { $first }
block-unknown-cycle = TCH PROBE { $given }: i cicli sono { $known }
block-not-a-parameter = { $given } non è un parametro: scriverlo come { $example }
block-no-value = { $key } non ha valore
block-twice = { $key } è dato due volte, la prima alla linea { $first }
block-unclosed-quote = le virgolette non sono chiuse
block-behind-end = { $given } viene dopo la fine del blocco: ogni linea tranne l'ultima finisce con ~
block-too-many-parts = la linea ha più di { $most } parti tra ~
block-cut-off = il blocco finisce con ~, quindi manca una linea: può essere troncato
block-reference = { $key } = { $given }: il valore di { $given } è noto solo durante l'esecuzione di un programma
block-not-writable = { $key } = { $given }: un testo in un blocco non può contenere virgolette o fine linea
block-unused = linea { $line }: { $text } non fa parte del ciclo di tastatura ed è stato saltato
block-unused-more = linea { $line }: { $text } non fa parte del ciclo di tastatura ed è stato saltato, e altri { $more }
