# La riga di comando

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = avviso: { $what }
cli-remark = nota: { $what }

# Di che cosa parla un errore
cli-what-callout = indicazione
cli-what-measured-value = valore misurato
cli-what-hole = foro
cli-what-shaft = albero
cli-what-measured-hole = foro misurato
cli-what-measured-shaft = albero misurato
cli-what-hole-material = materiale del foro
cli-what-shaft-material = materiale dell'albero
cli-what-temperature = temperatura
cli-what-smallest-clearance = gioco minimo
cli-what-largest-clearance = gioco massimo
cli-what-nominal-size = quota nominale { $text }
cli-what-true-diameter = diametro effettivo
cli-what-simulated-workpiece = pezzo in lavorazione simulato
cli-what-simulated-measurement = misura simulata
cli-what-perfect-workpiece = pezzo in lavorazione alla quota nominale
cli-what-size = dimensione
cli-what-cycle = ciclo { $code }
cli-what-log = protocollo di misura
cli-what-entry = voce { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Errori
cli-batch-simulated = le prime linee di { $name } dicono che è simulato, e solo CSV può conservarle: scrivere CSV
cli-dash = - è lo standard output, che qui non è possibile: indicare un nome, o ./- per un file o una cartella di nome -
cli-no-subcommand = { $given } non è un sottocomando; qui ci sono: { $names }
cli-not-above-zero = { $diameter } mm non è maggiore di 0
cli-ratio-of-one-limit = la regola asme-simple confronta l'incertezza con la tolleranza: attesi --lower e --upper
cli-already-corrected = --temperature: il file dice che i suoi valori sono già a 20 °C
cli-not-a-multiple = { $given }: atteso un numero maggiore di 0 con al massimo tre decimali
cli-no-limits = indicare --lower, --upper o entrambi, con il limite inferiore sotto il superiore
cli-risk-without-uncertainty = i rischi di un processo richiedono --u o --expanded
cli-risk-without-process = --consumer-risk richiede --process-mean e --process-sd, o --gamma
cli-not-a-risk = rischio { $given }: attesa una probabilità tra 0 e 1, come 0.001
cli-not-a-gamma = distribuzione gamma { $given }: attesi la forma e la scala in µm, come 4,0.25
cli-no-zone-for-risk = nessuna zona di valori accettati ha questo rischio del cliente
cli-line-too-long = la linea supera { $limit } byte
cli-not-a-table = { $name } non è una tabella di scostamenti
cli-stats-features = più caratteristiche: sceglierne una con --feature: { $names }
cli-stats-no-feature = nessuna caratteristica { $given }: i file hanno { $names }
cli-stats-limits = i limiti differiscono da un valore all'altro: indicare --lower e --upper, o scegliere una caratteristica con --feature
cli-stats-no-point = nessun punto { $point }: la carta ne ha { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (se è giusto: --confirm-layout)
cli-stats-no-budget = questo studio non dà contributi a un bilancio
cli-stats-no-picture = nessuna immagine possibile: { $why }
cli-stats-points = --stage e --leave-out valgono per una caratteristica: sceglierla con --feature invece di --all
cli-stats-parameters = --parameters vale per --chart ewma o cusum
cli-add-feature = { $error }: aggiungere --feature hole o --feature shaft
cli-add-wide-zone = { $asked }: { $error }; se questa zona di tolleranza è voluta, aggiungere --wide-zone
cli-add-far-temperature = { $what }: { $error }; se questa temperatura è voluta, aggiungere --far-temperature
cli-remark-open = { $count ->
    [one] un valore è fuori dai limiti; se sia ripresa o scarto dipende da foro o albero: aggiungere --feature hole o --feature shaft, una colonna kind con queste parole, o un piano
   *[other] { $count } valori sono fuori dai limiti; se siano ripresa o scarto dipende da foro o albero: aggiungere --feature hole o --feature shaft, una colonna kind con queste parole, o un piano
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked }: { $um } µm sopra il massimo; se sia ripresa o scarto dipende da foro o albero: aggiungere --feature hole o --feature shaft
   *[below] { $asked }: { $um } µm sotto il minimo; se sia ripresa o scarto dipende da foro o albero: aggiungere --feature hole o --feature shaft
}
cli-parts-of-several = i pezzi misurati sono di un solo accoppiamento: indicare una sola indicazione
cli-search-with-parts = una ricerca non accetta pezzi misurati, materiali o temperature
cli-search-without-size = una ricerca richiede una quota nominale, come 25
cli-search-without-clearance = una ricerca richiede --min-clearance e --max-clearance
cli-table-ending = { $path }: il nome di una tabella del controllo numerico finisce con .tab
cli-format-ending = { $path }: un file in formato { $format } finisce con .{ $endings }
cli-several-tables = una tabella del controllo numerico è un solo file: indicare una tabella, o classi solo di fori o solo di alberi
cli-report-format = --format { $format } non corrisponde all'estensione di { $file }: tralasciarne uno
cli-stopped = interrotto con Ctrl+C dopo { $rows } righe
cli-report-empty = nessun controllo era utilizzabile, quindi non è stato scritto alcun rapporto
cli-inputs-too-large = le immissioni di un ciclo hanno al massimo { $most } KiB
cli-not-an-object = le immissioni devono essere un oggetto JSON come {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: atteso un numero o un testo
cli-given-twice = { $name } è indicato due volte
cli-option-of-standard = --{ $option } non ha effetto con --source control: le tabelle del controllo numerico hanno una sola edizione di ISO 286
cli-set-twice = { $name } è impostato due volte
cli-several-blocks = più cicli di misura, alle righe { $blocks }: sceglierne uno con --at RIGA
cli-other-cycle = è il ciclo { $given }, non { $wanted }
cli-not-predef = PREDEF non è ammesso per il parametro { $name }
cli-no-probe = la tabella di tastatura non ha il sistema di tastatura { $number }
cli-not-a-pair = { $text }: scrivere un parametro come NAME=VALUE
cli-not-a-position = posizione { $text }: attesi tre numeri X,Y,Z in mm
cli-not-a-number = non è un numero
cli-no-folder = cartella inesistente: { $path }
cli-watched-already = un altro programma sorveglia { $path } per questo registro
cli-no-program = { $error }; i programmi integrati sono { $names }
cli-option-beside-plan = --{ $option } vale per una singola indicazione: un piano ha per questo una colonna
cli-option-missing = manca --{ $option }: una singola indicazione richiede --x, --y e --z
cli-batch-ending = { $path }: l'output deve finire con .{ $endings }, seguito da .gz o .zst per comprimerlo
cli-batch-onto-itself = { $path } è uno dei file di ingresso: scrivere i risultati in un altro file
cli-batch-columns = { $name } ha colonne diverse dal primo file, che ha { $columns }
cli-batch-separator = { $name } ha un separatore diverso dal primo file: scrivere .jsonl, o valutare questo file a parte
cli-batch-types = la colonna { $column } di { $name } ha un tipo diverso dal primo file: scrivere .csv, o valutare questo file a parte
cli-batch-packed = { $path }: Parquet è già compresso: tralasciare .gz o .zst
cli-batch-twice = { $name } ha due colonne di nome { $column }: scrivere .csv, che le ammette entrambe
cli-batch-input = { $name }: { $error }
cli-batch-name = { $name } ha già una colonna { $column }: con --prefix mettere una parola davanti ai nomi delle colonne aggiunte
cli-use-force = { $error }; --force sovrascrive

# Un --check di un rapporto
cli-check-no-measured = { $text } non ha un valore misurato: scrivere un'indicazione, = e millimetri, come 25 H7=25,012
cli-check-measured = valore misurato: { $value }
cli-check-not-positive = il valore misurato { $measured } mm non è maggiore di 0

# Note
cli-remark-wrote = scritto { $path }
cli-remark-wrote-files = scritto { $path } ({ $count } file)
cli-remark-simulated = simulato: non è stato misurato nulla
cli-remark-perfect-workpiece = simulato: ogni ciclo ha misurato un pezzo in lavorazione perfetto alla quota nominale; per un altro pezzo, usare --workpiece FILE.toml
cli-remark-corrected = misurati { $measured } mm a { $temperature } °C: { $change } µm, quindi { $at-reference } mm a 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = ogni valore misurato viene corretto da { $temperature } °C a 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = righe ottiche a { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = la correzione lineare differisce da quella esatta di { $off } µm
cli-remark-rule = regola: { $rule }
cli-remark-rule-by-budget = regola: { $rule }
cli-remark-budget = incertezza dal bilancio { $name }, creato il { $date }, valido fino al { $until }
cli-remark-budget-contacts = dispersione di { $touches } punti di contatto{ $step }, fattore geometrico { $factor }
cli-remark-accepted = accettato: da { $least } a { $most } mm
cli-remark-nothing-accepted = nessun valore è accettato: la regola non lascia nulla di questa tolleranza
cli-remark-proven = provato secondo questa regola
cli-remark-not-proven = non provato secondo questa regola
cli-remark-conformity = conforme con una probabilità di { $percent } %
cli-remark-remove = asportare { $limit } mm fino al limite più vicino, { $middle } mm fino al centro della zona di tolleranza
cli-remark-refused = { $refused } di { $asked } indicazioni rifiutate
cli-remark-no-pair = nessuna coppia adatta; la più vicina è { $nearest }
cli-remark-trace-ends = la traccia finisce qui, dopo { $blocks } blocchi
cli-remark-batch-utf16 = { $name } è UTF-16 e viene scritto come UTF-8
cli-remark-batch-floats = { $name } ha numeri in virgola mobile in { $columns }: ciascuno è valutato come il più breve decimale che lo rappresenta
cli-remark-tools-not-written = la tabella utensili non viene scritta: --tools-out FILE.t la scrive con queste modifiche
cli-remark-clearance-height = l'altezza di sicurezza è { $height } mm: --clearance-height la cambia
cli-remark-more-entries = sono elencate solo { $limit } voci: per altre, usare --limit N
cli-remark-backed-up = copiato fino alla voce { $number } in { $path } (hash { $hash })
cli-remark-no-head-known = nessuna voce di questo registro è nota altrove: la mancanza delle voci più recenti non verrebbe scoperta

# Avvisi
cli-warning-stopped-unrecorded = non è stato registrato nulla: le righe si registrano insieme, quando sono tutte lette
cli-warning-column-not-used = la colonna { $column } viene saltata
cli-warning-expansion-unconfirmed = la dilatazione di { $expansion } · 10⁻⁶/K è un valore usuale che qui nessun documento conferma
cli-warning-file-twice = questo file è indicato due volte: le sue righe sono contate due volte
cli-warning-position-unused = --position non ha effetto: il ciclo { $code } non parte dalla posizione della sfera
cli-warning-predef-unused = --predef non ha effetto su { $name }: non è impostato su PREDEF
cli-warning-log-option = --{ $option } non ha effetto: nessun protocollo viene scritto o mostrato
cli-warning-more-figures = altri { $count } valori simili non sono elencati
cli-warning-tables-not-used = --tables, --source e le opzioni della norma non vengono usati: senza --fit non si cercano limiti
cli-warning-empty-cell = { $class } oltre { $over } fino a { $to } mm resta vuoto: ISO 286 non ha un valore unico per tutto il campo
cli-warning-budget-option = --{ $option } non ha effetto: il bilancio non ne dipende
cli-warning-contacts-left = il ciclo ha usato { $used } di { $count } punti di contatto
cli-warning-not-in-csv = CSV non ha posto per { $options }: HTML, JSON e PDF sì
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } nota non è nel CSV: HTML e JSON la contengono
   *[other] { $count } note non sono nel CSV: HTML e JSON le contengono
}
cli-warning-no-tool-monitored = la tabella utensili non viene usata: Q330 non indica alcun utensile
cli-warning-log-unknown = nessun protocollo viene scritto: il protocollo del ciclo { $code } non è noto
cli-warning-limits-alone = qui decidono solo i limiti: la regola di decisione e la temperatura valgono solo per diametri
cli-warning-log-off = nessun protocollo viene scritto: Q281 = 0
cli-warning-log-none = nessun protocollo viene scritto: il ciclo non ne ha
cli-warning-log-on-screen = nessun protocollo viene scritto: Q281 = 2 lo mostra sullo schermo

# Tabelle a confronto con ISO 286
cli-verify-off = { $place }: { $class } oltre { $over } fino a { $to } mm: { $table }, ISO 286 ha { $standard }: { $by }
cli-verify-missing = { $place }: { $class } oltre { $over } fino a { $to } mm: nessun valore, ISO 286 ha { $standard }
cli-verify-undefined = { $place }: { $class } oltre { $over } fino a { $to } mm: { $table }, ma { $reason }
cli-verify-neither = { $place }: { $class } oltre { $over } fino a { $to } mm: { $reason }
cli-verify-by = { $side ->
        [upper] superiore
       *[lower] inferiore
    } { $um } µm { $way ->
        [more] in più
       *[less] in meno
    }
cli-verify-table = { $name }: { $classes ->
        [one] { $classes } classe
       *[other] { $classes } classi
    }, { $ranges ->
        [one] { $ranges } campo di dimensioni
       *[other] { $ranges } campi di dimensioni
    }, { $cells ->
        [one] { $cells } cella confrontata
       *[other] { $cells } celle confrontate
    }: { $differ ->
        [0] tutte concordano con ISO 286
        [one] { $differ } differisce da ISO 286
       *[other] { $differ } differiscono da ISO 286
    }
cli-verify-nothing = { $name }: { $classes ->
        [one] { $classes } classe
       *[other] { $classes } classi
    }, { $ranges ->
        [one] { $ranges } campo di dimensioni
       *[other] { $ranges } campi di dimensioni
    }, { $cells } celle confrontate: nulla da confrontare con ISO 286
cli-verify-own = { $table }; non confrontate, non sono classi di ISO 286: { $own }

## Avvio
start-missing = file inesistente: { $path }; indicare un file esistente per aprirlo nella finestra, o un sottocomando
start-folder = è una cartella, non un file: { $path }; nella finestra si aprono solo file

## Ciò che è stato registrato
cli-recorded-entry = registrato come voce { $number } di { $file } (hash { $hash })
cli-recorded-entries = registrato come voci da { $first } a { $last } di { $file } (hash dell'ultima { $hash })
cli-recorded-nothing = non è stato valutato nulla, quindi non è stato registrato nulla
cli-recorded-without = { $rows ->
    [one] 1 riga non è registrata
   *[other] { $rows } righe non sono registrate
}: { $places }
cli-not-recorded = non è stato registrato nulla: { $error }
cli-journal-is-server = serve il file del registro di una stazione: un server riceve solo ciò che le stazioni hanno registrato
cli-no-shop = questo programma è compilato senza supporto per un server dell'officina: indicare come registro un file
cli-recorded-not-sent = non ancora inviato al server: { $error }; le registrazioni restano qui, e fitcheck journal send le invia
cli-no-journal-folder = questo sistema non ha una cartella per i dati: indicare un registro con --journal FILE
cli-no-entry = in { $path } non c'è la voce { $number }: l'ultima è { $last }
cli-no-check = la voce { $number } non è un controllo
cli-no-hash = nessuna voce di { $path } ha un hash che inizia con { $prefix }
cli-several-hashes = gli hash di più voci iniziano con { $prefix }: { $numbers }. Indicare più cifre o il numero
cli-record-needs-file = --record indica il file che è stato scritto, e l'uscita standard non lo è: indicare -o FILE
cli-report-not-known = { $file } è stato scritto, ma il registro non lo conosce: { $error }
cli-already-corrected-by = la voce { $number } è già stata corretta o ritirata dalla voce { $by }: correggere quella, a meno che sia un ritiro
cli-not-typed = il valore della voce { $number } non è stato digitato: rimisurare, o ritirare il controllo
cli-nothing-corrected = una correzione deve cambiare qualcosa: indicare --measured, --who, --part, --serial, --feature-name, --remark o --withdraw
cli-remark-sent = { $entries ->
    [0] non c'era nulla da inviare
    [one] 1 voce inviata
   *[other] { $entries } voci inviate
} a { $server }, che ha questo registro fino alla voce { $number }
cli-remark-nothing-found = nessun controllo corrisponde a { $question }
cli-remark-unread = { $entries ->
    [one] 1 voce viene saltata
   *[other] { $entries } voci vengono saltate
}: questa versione non può { $entries ->
    [one] leggerla
   *[other] leggerle
}
cli-head-without-chain = un server ha più catene: indicare --head CHAIN:NUMBER:HASH
cli-head-of-other = questo registro è la catena { $chain }, ma --head indica { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } elemento
   *[other] { $count } elementi
}
cli-remark-plan-example = nessuna indicazione di tolleranza: il piano ha un elemento come esempio
cli-remark-plan-to-fill = il piano è scritto per quanto noto; errori da correggere: { $count }
cli-remark-no-columns = il file è letto secondo il proprio formato e non ha colonne da scegliere
cli-remark-plan-head-left = CSV contiene solo gli elementi: { $keys } del pezzo non viene scritto
cli-warning-neither-stands = la voce { $number } correggeva la voce { $target }: ora non conta nessuna delle due. Se uno dei valori è giusto, registrarlo di nuovo
cli-warning-beyond-limits = fuori dai limiti: accettato secondo la regola, perché non è provato che sia fuori
cli-warning-plan-missing = non misurate: { $names }
cli-warning-plan-missing-of = { $who }: non misurate: { $names }
cli-warning-contradiction = { $name } ha valori che si contraddicono: { $values }
cli-warning-contradiction-of = { $who }: { $name } ha valori che si contraddicono: { $values }
cli-warning-worst-counts = tra più valori che si contraddicono vale il peggiore finché non si sceglie: --repeats last o --repeats worst. I numeri di serie distinguono i pezzi, e un'ora per ogni valore mostra qual è l'ultimo
cli-warning-plan-more-parts = più di { $most } pezzi: gli elementi mancanti degli altri non vengono segnalati
cli-warning-plan-no-value = mancante: nessun valore trovato
cli-warning-plan-no-value-of = mancante su { $who }: nessun valore trovato
cli-remark-watching = sorveglianza di { $folder }; file importati in precedenza: { $known }
cli-warning-see-note = non si è potuto usare tutto: il file accanto che finisce con { $note } dà i motivi
cli-not-seconds = { $given } non è un tempo in secondi
cli-warning-same-content = lo stesso contenuto è già stato importato come { $known }: nulla viene registrato di nuovo
cli-warning-not-alone = impossibile sapere se un altro programma sorveglia questa cartella per lo stesso registro: { $reason }

## Il fuso orario di questo computer
zone-not-understood = TZ è impostato su «{ $given }», che non è un fuso orario: impostarlo su un nome come Europe/Amsterdam o su UTC, o rimuoverlo
zone-unknown = il fuso orario di questo computer non è noto, quindi le ore sono in UTC: impostare TZ su un nome come Europe/Amsterdam

# Il dottore
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, sono le { $time }
doctor-clock = non precede l'ultima voce del registro
doctor-clock-behind = precede l'ultima voce di { $path }, scritta alle { $newest }: regolare l'orologio di questo computer
doctor-folder = { $path }: si possono scrivere file
doctor-journal = { $path }: voci { $entries }
doctor-no-journal = { $path } non esiste ancora: lo crea il primo controllo registrato
doctor-server = { $address } risponde
doctor-no-server = nessun server impostato: indicarlo con --journal postgres://…, o nella finestra sotto Impostazioni
doctor-gauges = porte di questo computer: { $ports }
doctor-no-port = questo computer non ha porte seriali: collegare lo strumento o il suo cavo
doctor-gauge-gone = { $gauge }: la porta { $port } non c'è: collegare lo strumento o scegliere un'altra porta nella finestra sotto Impostazioni
doctor-no-gauges = questo programma è stato costruito senza le porte degli strumenti: i pacchetti le hanno
doctor-ports-not-listed = le porte di questo computer non si possono elencare: { $reason }
doctor-tables = { $path }: tabelle { $count }
doctor-no-tables = nessuna tabella propria: ISO 286 e le tabelle del controllo sono integrate
doctor-settings = ciò che la finestra conserva è leggibile
doctor-window = disegnata con { $renderer }
doctor-no-window = questo programma è stato costruito senza la finestra
