## La catena di un registro
journal-hex = «{ $text }» non è di { $digits } cifre esadecimali
journal-break-changed = la voce { $number } non è quella che è stata scritta
journal-break-removed = { $count ->
        [one] manca la voce { $number }
       *[other] mancano { $count } voci dalla { $number } in poi
    }
journal-break-inserted = la voce { $number } è stata inserita
journal-break-reordered = le voci { $number } e { $other } sono state scambiate
journal-break-rewritten = la voce { $number } differisce da quella nota altrove: il registro è stato riscritto da lì o da una voce precedente
journal-break-cut-off = il registro finisce con la voce { $last }, ma altrove è nota la voce { $known }: le voci più recenti sono state tagliate, o è stata rimessa una copia più vecchia

## Voci
journal-body-json = non è una voce di un registro: { $reason }
journal-body-newer = creata da un Fitcheck più recente: versione { $version } del formato, questo Fitcheck legge versioni fino alla { $known }
journal-body-too-large = non è una voce di un registro: { $bytes } byte, ne sono ammessi al massimo { $most }
journal-body-too-long = { $field } ha { $bytes } byte, ne sono ammessi al massimo { $most }
journal-body-control = { $field } ha il carattere di controllo { $code } come carattere { $place }: i testi di un registro sono una linea senza caratteri di controllo
journal-body-empty = { $field } è vuoto
journal-body-too-many = { $field } ha { $count } valori, ne sono ammessi al massimo { $most }
journal-body-value = { $field } non può essere «{ $given }»
journal-body-contradiction = { $field } contraddice i campi da cui deriva
journal-origin-perfect = simulato, un pezzo in lavorazione senza difetti
journal-origin-workpiece = simulato, { $file }, seme { $seed }
journal-origin-contacts = punti di contatto da { $file }
journal-check-judged-otherwise = deciso come { $kept }, che resta valido; questa versione di Fitcheck decide { $now }

## Domande
journal-ask-at = { $reason } (carattere { $at })
journal-ask-unknown-key = { $key }: non è una parola chiave nota; attesa { $known }, o virgolette attorno a una parola con i due punti
journal-ask-no-value = { $key }: non ha valore
journal-ask-empty-word = una parola tra virgolette è vuota
journal-ask-twice = { $key } è indicato due volte
journal-ask-not-closed = le virgolette non sono chiuse
journal-ask-after-quote = atteso uno spazio dopo le virgolette di chiusura, trovato { $found }
journal-ask-date = «{ $given }» non è un giorno né un'ora: atteso 2026-11-23 o 2026-11-23T14:30
journal-ask-verdict = «{ $given }» non è un esito: atteso { $known }
journal-ask-callout = { $error }; un'indicazione va tra virgolette: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = il periodo finisce prima di cominciare: from deve essere prima di to
journal-ask-both-origins = simulated e measured si escludono a vicenda
journal-ask-both-kinds = reports e checks si escludono a vicenda
journal-ask-too-long = la domanda ha { $bytes } byte, ne sono ammessi al massimo { $most }

## Il registro di una stazione
store-missing = nessun registro in { $path }
store-not-a-file = { $path } non è un file
store-not-a-journal = { $path } non è un registro di Fitcheck; è rimasto invariato
store-newer = { $path } è stato creato da un Fitcheck più recente (versione { $version }, questo supporta la { $known }); è rimasto invariato
store-older = { $path } è stato creato da un Fitcheck meno recente: viene aggiornato quando vi si registra qualcosa
store-damaged = { $path } è danneggiato: le sue pagine si contraddicono
store-full = non c'è più spazio per { $path }: non è stato registrato nulla
store-read-only = non è permesso scrivere in { $path }: non è stato registrato nulla
store-locked = un altro programma ha bloccato { $path } troppo a lungo: non è stato registrato nulla
store-disk = il disco di { $path } segnala un errore: { $reason }
store-cannot-open = impossibile aprire { $path }
store-network-folder = { $path } è in una cartella di un altro computer, dove due stazioni potrebbero sovrascriversi le voci: scegliere una cartella su questo computer, e un server per l'officina
store-altered = «{ $name }», che protegge le voci dalle modifiche, manca in { $path } o è stato modificato
store-no-beginning = { $path } non dice di quale catena è
store-moved = { $path } nel frattempo è stato spostato o messo da parte: non è stato registrato nulla
store-other-target = la voce { $number } non è quella che si voleva correggere: non è stato registrato nulla
store-corrected = la voce { $number } è già stata corretta o ritirata dalla voce { $by }: correggere quella, a meno che sia un ritiro
store-is-report = la voce { $number } è un rapporto: dice quale file è stato scritto e non si può correggere né ritirare
store-is-alarm = la voce { $number } è un allarme di una carta di controllo: dice quale regola è scattata e non si può correggere né ritirare; rispondere all'allarme
store-no-alarm = la voce { $number } non è un allarme di una carta di controllo: si può rispondere solo a un allarme
journal-alarm-since-part = { $rule }, dal pezzo { $serial }
journal-alarm-since-entry = { $rule }, dalla registrazione { $number }
store-other-journal = la voce { $number } di questo registro non è quella indicata dal rapporto: non è stato registrato nulla
store-finding-no-beginning = il registro non ha una prima voce che indichi la sua catena
store-finding-pages = le pagine del registro si contraddicono, e le domande possono non trovare voci che vi sono: { $reason }
store-finding-index = un indice per le domande non corrisponde alla sua tabella: { $reason }
store-hidden = la voce { $number } di { $path } non si trova al suo posto: il registro è stato modificato o il suo file è danneggiato; eseguire fitcheck journal verify
store-no-entry = { $path } non ha la voce { $number }: l'ultima è { $last }
store-backup = la copia di { $path } era incompleta ed è stata rimossa
store-interrupted = interrotto
store-database = { $path }: { $reason }
store-remark-begun = è stato creato un nuovo registro: { $path }
store-remark-set-aside = il registro { $path } era danneggiato: ora è in { $folder }, invariato, e al suo posto ne è stato creato uno nuovo
store-remark-migrated = { $path } è stato aggiornato a questa versione; il file com'era prima è { $copy }
store-remark-behind = { $path } finisce con la voce { $last }, ma un tempo aveva la voce { $known }: le voci più recenti sono state tagliate, o è stata rimessa una copia più vecchia
store-remark-other = la voce { $number } di { $path } differisce da com'era: il registro è stato riscritto da lì o da una voce precedente
store-remark-replaced = { $path } non è il registro che c'era prima, che aveva { $known } voci
store-remark-waits = un altro programma sta scrivendo in { $path }: attesa della fine
store-remark-no-anchor = non è stato possibile annotare l'ultima voce di questo registro in { $path }: { $reason }
store-finding-altered = «{ $name }», che protegge le voci dalle modifiche, manca o è stato modificato
store-finding-not-found = { $entries ->
        [one] 1 voce è indicizzata con altro da ciò che dice, o non è indicizzata
       *[other] { $entries } voci sono indicizzate con altro da ciò che dicono, o non sono indicizzate
    }
