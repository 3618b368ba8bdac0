# Esecuzione di programmi NC.

## Percorsi e file
machine-path-empty = il percorso è vuoto
machine-path-too-long = il percorso ha più di { $most } caratteri, cosa che un controllo numerico non ammette
machine-path-other-root = { $path } non è né un percorso su TNC: né un percorso dalla cartella del programma
machine-path-leads-out = { $path } porta fuori dalla cartella
machine-path-no-name = { $name } in { $path } non è un nome di file o di cartella
machine-store-missing = file non trovato: { $path }
machine-store-outside = { $path } porta fuori dalle cartelle indicate
machine-store-no-file = { $path } non è un file
machine-store-too-large = { $path } supera { $most } MiB
machine-store-ambiguous = { $path } esiste in più grafie, { $names }, ma un controllo numerico ha un solo file per nome: rimuovere o rinominare gli altri
machine-store-elsewhere = { $path } non è nella cartella di output: un programma cancella file solo lì
machine-store-read-only = nessuna cartella di output scelta
machine-store-system = { $path }: { $reason }

## Errori
machine-fault-in-block = { $program }, blocco { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, linea { $line }, { $text }: { $fault }
machine-used-blocks = raggiunto il limite di { $most } blocchi: possibile ripetizione senza fine
machine-used-label-calls = raggiunto il limite di { $most } chiamate di label annidate: il programma richiama se stesso?
machine-used-program-calls = raggiunto il limite di { $most } chiamate di programma annidate: il programma richiama se stesso?
machine-used-windows = raggiunto il limite di { $most } finestre
machine-used-outputs = raggiunto il limite di { $most } scritture su file
machine-used-output-files = raggiunto il limite di { $most } file di output
machine-used-folders = raggiunto il limite di { $most } cartelle per file di output
machine-used-table-writes = raggiunto il limite di { $most } scritture di tabelle modificate
machine-used-output = raggiunto il limite di { $most } byte stampati
machine-used-cycles = raggiunto il limite di { $most } misure
machine-used-path = raggiunto il limite di { $most } spostamenti
machine-used-files = raggiunto il limite di { $most } programmi aperti e tabelle modificate
machine-used-traffic = raggiunto il limite di { $most } byte letti e scritti
machine-used-file-bytes = programmi e tabelle modificate superano insieme { $most } byte
machine-text-too-long = il testo ha { $length } caratteri, un parametro ne contiene al massimo { $most }
machine-unknown-block = blocco sconosciuto: Fitcheck esegue solo ciò che comprende
machine-unknown-cycle = Fitcheck non esegue il ciclo { $cycle }, neanche dove il controllo numerico lo ha: esegue { $known }
machine-file-open = { $path } è aperto come tabella di FN 26: non può essere copiato, spostato o cancellato
machine-broken = il programma è danneggiato: manca { $what }
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } non è una label
machine-no-tool-data = { $parameter } non è definito: contiene una misura dell'utensile nel mandrino, che dà una tabella utensili
machine-undefined = { $parameter } non è definito
machine-lost = { $parameter } non è definito: la linea { $line }, { $text }, può impostarlo e non è stata eseguita
machine-file-unknown = { $path } non viene letto: la linea { $line }, { $text }, può scriverlo o rimuoverlo e non è stata eseguita
machine-tools-unknown = l'utensile non viene corretto: la linea { $line }, { $text }, può modificare la tabella utensili e non è stata eseguita
machine-contacts-unknown = non è noto quali punti di contatto registrati appartengano a questo ciclo: alcuni possono appartenere alla linea { $line }, { $text }, che non è stata eseguita
machine-not-skipped = questo blocco decide che cosa viene eseguito dopo o che cosa riceve un altro programma: non si può saltare
machine-whole-only = { $parameter } contiene solo numeri interi, non { $value }
machine-no-answer = INPUT "{ $question }" chiede { $parameter }: dargli un valore prima dell'esecuzione
machine-no-parameter = il parametro { $parameter } non esiste: Q e QS arrivano fino a 1999, QL e QR fino a 499
machine-no-variable = la variabile { $variable } non esiste: { $family } va da { $least } a { $most }
machine-not-number = { $parameter } contiene un testo: atteso un numero
machine-not-text = { $parameter } contiene un numero: atteso un testo
machine-division-by-zero = divisione per zero
machine-negative-root = la radice quadrata di { $value } non è definita
machine-no-result = { $function } { $value } non è definito
machine-beyond-range = { $value } è fuori dal campo dei valori, da -10^10 a 10^10
machine-not-whole = { $what } = { $value }: atteso un numero intero da 0
machine-counted-row = riga
machine-counted-word = { $word }
machine-behind-text = il testo ha { $length } caratteri: la posizione { $from } è oltre la fine
machine-no-number-in-text = { $parameter } = «{ $text }» non è un numero
machine-unknown-system-text = testo di sistema sconosciuto ID{ $id } NR{ $number }: sono supportate solo data e ora (ID10321)
machine-no-table = nessuna tabella aperta
machine-several-columns = { $parameter } = { $text } indica più colonne: con un parametro di testo se ne può leggere solo una
machine-no-column = la tabella { $table } non ha la colonna { $column }; le sue colonne sono { $columns }
machine-no-row = la tabella { $table } non ha la riga { $row }: le sue righe vanno da 0 a { $last }
machine-no-rows = la tabella { $table } non ha righe
machine-empty-cell = tabella { $table }, riga { $row }, colonna { $column }: la cella è vuota
machine-no-number-in-cell = tabella { $table }, riga { $row }, colonna { $column }: { $cell } non è un numero
machine-touches = tabella { $table }, riga { $row }, colonna { $column }: la cella tocca quella vicina, quindi il suo valore è incerto
machine-table-write = tabella { $table }: { $error }
machine-mask = maschera { $mask }: { $error }
machine-programmed = il programma si è arrestato da sé con l'errore { $number }
machine-no-cycle-parameter = il ciclo { $cycle } non ha il parametro { $parameter }
machine-cycle-parameter-twice = ciclo { $cycle }: { $parameter } è indicato due volte
machine-cycle-parameter-for = ciclo { $cycle }: { $parameter } è indicato due volte, e { $other } affatto: il secondo sta per { $other }?
machine-global-not-number = GLOBAL DEF { $number }: { $parameter } non ha un numero
machine-global-twice = GLOBAL DEF { $number }: { $parameter } è indicato due volte
machine-open-subprogram = il programma finisce dentro il sottoprogramma chiamato alla linea { $line }: manca LBL 0
machine-repeat-ahead = REP ripete la parte tra una label e questo blocco, ma la label viene dopo, alla linea { $line }
machine-cycle = ciclo { $cycle }: { $error }
machine-workpiece = pezzo in lavorazione: { $error }
machine-no-tool-call = prima di questo ciclo di misura non c'è un TOOL CALL con asse utensile
machine-mode = il controllo numerico è in modalità { $mode }: i cicli di misura funzionano solo in modalità di fresatura (FUNCTION MODE MILL)
machine-changed = dalla linea { $line }, { $text }, è in vigore { $change }: nel frattempo Fitcheck non misura
machine-nothing-selected = prima di CALL SELECTED PGM non c'è un SEL PGM
machine-no-datum-table = l'origine andrebbe nella riga { $row } della tabella punti zero attiva (Q303 = 0), che ha solo il controllo numerico: qui da essa non si può misurare nulla
machine-datum-in-tilt = dalla linea { $line }, { $text }, il piano è ruotato: Fitcheck non vi imposta alcuna origine, perché non si sa che cosa vi scriva un controllo numerico; annullare il piano prima del ciclo (PLANE RESET)
machine-point-without-part = i cicli 0 e 1 tastano un singolo punto, e un pezzo perfetto non ne ha: scegliere un pezzo simulato o contatti registrati
machine-point-from-nowhere = il punto di partenza della tastatura non è noto in tutti gli assi: scrivere X, Y e Z nel blocco
machine-no-preset = { $table } non ha la riga { $row }
machine-preset-locked = { $table }: la riga { $row } è bloccata, il ciclo non può scriverla
machine-shifted-preset = la riga { $row } è l'origine attiva ed è attivo uno spostamento del punto zero: non è noto che cosa ne fa un controllo numerico
machine-change-not-known = un'origine sconosciuta
machine-change-turning = il sistema ruotato del ciclo 800
machine-change-datum-table = uno spostamento da una tabella punti zero
machine-change-rotation = una rotazione
machine-change-mirror = una specularità
machine-change-scaling = un fattore di scala
machine-change-axis-scaling = un fattore di scala di singoli assi
machine-change-tilt = un piano di lavoro ruotato
machine-change-tilted-shift = uno spostamento di un piano che non è più ruotato
machine-change-axis-turned = una rotazione del pezzo con un asse rotativo, senza una nuova origine nei due assi del piano da allora,

## Note
machine-file-from = { $path } è stato letto da { $file }
machine-file-given = { $path } è stato letto
machine-file-built-in = { $path } è integrato
machine-remark-skipped = blocco sconosciuto saltato
machine-remark-cycle-passed-over = questo ciclo calibra il tastatore o misura un utensile: è stato saltato. Ciò che restituisce non è definito da qui, se non è stato dato prima dell'esecuzione (--set Q115=0)
machine-remark-measurement-skipped = questa misura è stata saltata: da qui i suoi risultati non sono definiti
machine-remark-datum-skipped = questa misura è stata saltata: da qui i suoi risultati non sono definiti, e dopo non si misura nulla, perché può impostare un'origine
machine-remark-not-followed = questo blocco non viene eseguito e può cambiare l'origine: dopo non si misura nulla
machine-remark-no-system-data = da qui { $parameter } non è definito: solo un controllo numerico conosce i dati di sistema di FN 18
machine-remark-axis-assumed = prima di questo ciclo non c'è un TOOL CALL: misurato lungo Z con il primo sistema di tastatura
machine-remark-measured-again = rimisurato dopo la ripresa: vale questa misura
machine-remark-spindle-turns = il mandrino gira da M{ $function }: un controllo numerico non tasterebbe
machine-remark-rotary-moved = { $axes } si sono mossi prima di questo ciclo: il pezzo in lavorazione è stato misurato come se non fosse stato ruotato
machine-remark-other-preset = origine { $number }: si suppone che il pezzo in lavorazione stia anche lì
machine-remark-rotation-ended = la rotazione base di { $angle } è terminata: questo ciclo misura senza di essa, e resta disattivata
machine-remark-axes-as-tilted = il piano è ruotato: si presume che gli assi rotativi stiano come esso richiede
machine-remark-machine-zero-assumed = FN 18 chiede un luogo dallo zero della macchina: qui non si sa dove sia, e si conta da quello del pezzo
machine-remark-datum-set = origine impostata: il suo zero è ora a { $zero } mm nelle coordinate del pezzo in lavorazione
machine-remark-preset-set = riga { $row } della tabella origini impostata a { $zero } mm nelle coordinate del pezzo in lavorazione: agisce con il ciclo 247
machine-remark-active-preset-set = la riga { $row } è l'origine attiva: il suo zero è ora a { $zero } mm nelle coordinate del pezzo in lavorazione; su una iTNC 530 solo dopo il ciclo 247
machine-remark-presets-left = { $path } resta com'è: nessun ciclo 247 precedente dice quale riga è attiva, perciò non è noto dove si trova il pezzo in lavorazione sulla macchina
machine-remark-shift-ended = lo spostamento del punto zero termina in { $axes } senza che lì si sia misurato, come su un TNC7: una iTNC 530 forse lo mantiene
machine-remark-built-in = { $path } non è tra i file indicati: è stato letto quello integrato
machine-remark-other-names = è stato letto { $read }, ma esiste anche { $others }: un controllo numerico ha un solo file per nome
machine-remark-read = { $path }: { $what }
machine-remark-other-spelling = la tabella { $table } non ha la colonna { $column }: è stata usata { $other }, l'altra grafia in NC-Solution 8255
machine-remark-row-number = tabella { $table }: NR è { $found } nella riga { $row }: FN 27 e FN 28 contano le righe da 0
machine-remark-length-converted = tabella { $table }: la colonna { $column } è una LENGTH ed è stata convertita tra mm e pollici
machine-remark-ended-within = M{ $function } in un programma chiamato ha terminato l'esecuzione: un controllo numerico non lo ammette
machine-remark-given-wins = { $parameter } = { $value } è stato indicato prima dell'esecuzione e sostituisce il valore di questo blocco
machine-remark-given-without-effect = { $parameter } è stato indicato prima dell'esecuzione e non ha avuto effetto: nessun blocco lo ha letto
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = il blocco tralascia { $parameters }: sono stati usati questi valori, ma un controllo numerico può rifiutare il blocco
machine-remark-measurement-behind-end = { $count ->
        [one] un ciclo di misura viene
       *[other] { $count } cicli di misura vengono
    } dopo questo blocco, dove un controllo numerico smette di leggere: dopo di esso non è stato misurato nulla
machine-remark-cycle-skipped = questo ciclo di misura è stato saltato come richiesto, per la / che lo precede
machine-remark-rounded = tabella { $table }, colonna { $column }: { $value } è stato arrotondato a { $written }
machine-remark-not-judged = qui nessun esito: nulla è stato confrontato con limiti
machine-remark-not-written = { $path } non è stato scritto: nessuna cartella di output scelta
machine-remark-deleted = { $path } è stato cancellato dal programma
machine-remark-not-deleted = { $path } non è stato cancellato: nessuna cartella di output scelta
machine-remark-other-device = { $given } è un altro dispositivo: il file è { $path }
machine-remark-screen-meant = SCREEN vale come nome di un file: si intendeva SCREEN:?
machine-remark-empty-mask = la maschera { $mask } è vuota: lo è anche ciò che stampa
machine-remark-not-saved = { $path } non è stato scritto: { $reason }
machine-remark-full = { $path } ha raggiunto il limite di { $kilobytes } kilobyte: non è stato aggiunto nulla
machine-remark-table-written = { $path } è stato scritto
machine-remark-contacts-left = i cicli hanno usato { $used } di { $count } punti di contatto registrati
machine-remark-more = altre { $count } note non sono elencate
machine-remark-empty-spindle = è stato chiamato l'utensile 0: un TNC7 non ha allora alcun sistema di tastatura nel mandrino
machine-remark-no-tool-named = nessun TOOL CALL prima di questo ciclo indica un utensile: misurato con il primo sistema di tastatura
machine-remark-tool-call-words = TOOL CALL non accetta { $words }: saltato
machine-remark-no-nominal = il ciclo non ha una quota nominale: il sistema di tastatura incontra il pezzo in lavorazione perfetto a metà di K
machine-remark-other-probe = l'utensile { $tool } non è nella tabella di tastatura: è stato usato il sistema di tastatura { $probe }
machine-remark-collision = { $mover } toccherebbe { $feature }, con il centro della sfera a X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = gli spostamenti non sono esaminati del tutto rispetto a { $features }
machine-remark-stylus-unchecked = lo stilo non è esaminato per collisioni: non sta lungo Z
machine-remark-tool-offsets = { $offsets } del TOOL CALL non modifica il sistema di tastatura simulato
machine-remark-tool-locked = l'utensile { $tool } è bloccato nella tabella utensili
machine-remark-no-probe-tool = l'utensile { $tool } non è un sistema di tastatura: TYP = { $kind }, atteso { $probe }
machine-remark-no-such-tool = l'utensile { $tool } non è nella tabella utensili
machine-remark-same-name = { $more ->
    [one] un altro utensile ha il nome { $tool }
   *[other] altri { $more } utensili hanno il nome { $tool }
}: è stato usato il primo nella tabella utensili
machine-remark-content-uncertain = qui viene letto { $parameter }, ma non è documentato che contenga il diametro
machine-remark-not-waited = { $parameter } viene letto senza G909 dopo il ciclo: un controllo numerico legge i blocchi in anticipo e può non aver ancora misurato
machine-remark-position-unknown = la posizione prima del ciclo non è nota: senza D comincia dal centro nominale, senza WB all'altezza 0

machine-passed-over = { $count } { $count ->
        [one] blocco
       *[other] blocchi
    } da cui non dipende alcuna misura { $count ->
        [one] è rimasto
       *[other] sono rimasti
    } senza effetto: { $list }

## Pause
machine-pause-stop = il programma si è arrestato: STOP o M0
machine-pause-optional-stop = il programma si è arrestato: M1
machine-pause-breakpoint = il prossimo blocco ha un breakpoint
machine-pause-log = il protocollo di misura è sullo schermo (Q281 = 2)

## Un blocco di un ciclo di misura senza il suo programma
alone-moved = { $text } sposta il ciclo di tastatura successivo o ne cambia gli assi, ma il ciclo viene eseguito come se non lo facesse: eseguire invece l'intero programma
alone-called = { $text } esegue blocchi che possono spostare il ciclo di tastatura successivo, ma non vengono letti: eseguire invece l'intero programma
alone-not-understood = { $text } non è compreso e può spostare il ciclo di tastatura successivo: verificare il programma, o eseguirlo per intero
alone-not-run = il programma non prosegue oltre { $text } e non raggiunge il ciclo di tastatura successivo, quindi un controllo numerico qui non misura: verificare il programma
alone-passed = { $text } può oltrepassare il ciclo di tastatura, quindi un controllo numerico può non misurare qui: eseguire invece l'intero programma
alone-skipped = un controllo numerico può saltare il ciclo di tastatura per la / che lo precede: se deve essere misurato, eliminare la /
