# Programmi NC

## Lettura
program-empty = il programma è vuoto
program-too-large = il programma supera { $most } MiB
program-too-many-lines = il programma ha più di { $most } linee
program-binary = il file non è testo: { $controls } dei suoi { $bytes } byte non sono caratteri
program-no-begin = il programma non comincia con BEGIN PGM
program-second-begin = secondo BEGIN PGM
program-no-end = manca END PGM
program-units = END PGM dice { $end }, BEGIN PGM dice { $begin }
program-after-end = il testo dopo END PGM non fa parte del programma
program-no-section = manca { $section }
program-no-unit = la testata non indica l'unità (#EINHEIT METRISCH / INCH): il programma viene letto come programma in mm
program-after-last-section = dopo ENDE / END possono seguire solo sottoprogrammi
program-unclosed-comment = il commento non ha la parentesi di chiusura ]
program-numbers = il blocco numero { $number } segue { $previous }; numeri di blocco fuori ordine: { $count }
program-label-again = LBL { $label } è già definita alla linea { $first }
program-unclosed-quote = le virgolette non sono chiuse
program-open-end = la linea finisce con ~, ma non segue nulla
program-cycle-cut = il ciclo { $cycle } è finito alla linea { $line }, che non ha ~ alla fine: { $parameter } non ne fa parte e verrebbe invece assegnato
program-no-star = il blocco non finisce con *
program-iso-no-end = manca l'ultimo blocco: % con il nome del programma
program-iso-units = l'ultimo blocco dice { $end }, il primo { $begin }
program-iso-after-end = il testo dopo l'ultimo blocco non fa parte del programma
program-iso-cycle-cut = il ciclo { $cycle } è finito alla linea { $line }: { $parameter } non ne fa parte e verrebbe invece assegnato
program-comment-holds = { $found } fa parte del commento, che finisce alla fine della sua linea
program-cycle-without-tilde = il ciclo { $cycle } è finito alla linea { $line }, che non ha ~ alla fine: le linee sottostanti vengono lette come sua parte
program-block-goes-on = il blocco precedente finisce con ~, quindi questo blocco ne farebbe parte
program-comment-goes-on = il commento finisce con ~, quindi questo blocco ne farebbe parte
program-not-understood = non compreso: { $reason }
program-more = altre { $count } note non sono elencate

## Label
program-label-missing = LBL { $label } non compare nel programma
program-label-twice = LBL { $label } è definita due volte, alla linea { $first } e alla linea { $second }
program-label-zero = LBL 0 chiude un sottoprogramma: non vi si può saltare
program-label-parameter = quale label contenga { $label } è noto solo durante l'esecuzione del programma

## Perché un blocco non è compreso
program-missing = manca { $wanted }
program-unexpected = atteso { $wanted }, trovato { $found }
program-left-over = testo inatteso { $found }
program-unknown-function = { $found } non è una funzione
program-number-size = { $found } è troppo grande
program-parameter-range = { $found } non è un parametro: { $family } va da { $least } a { $most }
program-range = { $found } è troppo grande: al massimo { $most }
program-label-of-parameter = { $parameter } non può essere il nome della label che comincia qui
program-relation = FN { $number } confronta con { $allowed }: trovato { $found }
program-not-together = { $one } e { $other } non possono stare nello stesso blocco
program-unknown-word = { $found } non è noto
program-no-form = la forma ISO di { $found } non è nota
program-measure-unknown = non è noto se qui sia attivo G90 o G91
program-and-with-or = AND e OR in una condizione richiedono parentesi che mostrino quale viene prima
program-letter-twice = { $letters } è indicato due volte
program-second-unit = un'altra unità è già stata indicata
program-acts-in-unit = le unità restano senza effetto, ma questo blocco misura, chiama o imposta una variabile
program-shifts-in-unit = le unità restano senza effetto, ma questo blocco può spostare il punto zero
program-alone = { $found } senza { $missing }
program-axis-twice = un asse è indicato due volte
program-too-deep = parentesi e funzioni sono annidate oltre { $most } livelli
program-too-many-operands = la formula ha più di { $most } operandi
program-too-long = il blocco ha più di { $most } caratteri
program-too-much = formule e blocchi lunghi superano in tutto { $most } MiB
program-wanted-word = { $word }
program-wanted-number = un numero
program-wanted-value = un numero o un parametro Q
program-wanted-value-or-variable = un numero o una variabile
program-wanted-variable = una variabile (#l, #c, #g, #x, #i)
program-wanted-parameter = un parametro
program-wanted-number-parameter = un parametro Q, QL o QR
program-wanted-text-parameter = un parametro QS
program-wanted-text = un testo tra virgolette o un parametro QS
program-wanted-label = una label
program-wanted-path = un percorso
program-wanted-relation = EQU, NE, GT, LT o IS
program-wanted-unit = MM o INCH
program-wanted-cycle-value = un valore
