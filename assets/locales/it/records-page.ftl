page-records = Registro

## Ciò che si registra con un controllo
records-page-fold = Registrazione
records-page-fold-hint = Numero di serie e nota vengono registrati con i prossimi controlli
records-page-serial = Numero di serie
records-page-serial-short = N. di serie
records-page-remark = Nota
records-page-feature = Elemento
records-page-record = Registrazione { $number }
records-page-waiting = In registrazione
records-page-not-recorded = Non registrato: { $why }
records-page-nowhere = I controlli non vengono registrati: manca una cartella dei dati
records-page-off = I controlli non vengono registrati: la registrazione è disattivata nel file di stato
records-page-opening = Apertura del registro in corso
records-page-how-on = La sezione [records] del file di stato, state.toml, indica il file del registro e se i controlli vengono registrati.
records-page-not-opened = Impossibile aprire il registro, e i controlli non vengono registrati: { $why }
records-page-not-kept = { $count ->
    [one] 1 controllo non è registrato: { $why }
   *[other] { $count } controlli non sono registrati: { $why }
}
records-page-refused = { $count ->
    [one] 1 controllo non può essere registrato: { $why }
   *[other] { $count } controlli non possono essere registrati; il motivo del primo: { $why }
}
records-page-not-kept-why = il registro non ha risposto
records-page-no-thread = il sistema non può avviare un thread per il registro
records-page-interrupted = è stato interrotto
records-page-failed = { $count ->
    [one] 1 controllo non è registrato
   *[other] { $count } controlli non sono registrati
}
records-page-try-again = Riprovare
records-page-stay = Le registrazioni restano nel registro
records-page-leave = { $count ->
    [one] 1 controllo non è ancora registrato. Va perso se la finestra si chiude.
   *[other] { $count } controlli non sono ancora registrati. Vanno persi se la finestra si chiude.
}

## Chi misura
records-page-who = Misurato da
records-page-nobody = Nome…
records-page-who-nobody = Nessun nome scelto. Scegliere un nome
records-page-who-is = Misurato da { $name }
records-page-nobody-named = Nessun nome
records-page-new-name = Altro nome
records-page-take-name = Usare questo nome

## La domanda
records-page-question = Cercare
records-page-help = Parole, buono ripresa scarto, o part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = Altro
records-page-today = Oggi
records-page-this-week = Questa settimana
records-page-not-good = Non buoni
records-page-measured-only = Solo misurati
records-page-filter = Filtro
records-page-filter-hint = Riduce l'elenco per pezzo, numero di serie, data e altro
records-page-add-filter = Aggiungere filtro
records-page-filter-by = Filtrare per
records-page-filter-value = Valore
records-page-from = Dal
records-page-to = Al
records-page-standing = Solo validi
records-page-simulated-only = Solo simulati
records-page-reports-only = Solo rapporti
records-page-alarms-only = Solo allarmi
records-page-checks-only = Senza rapporti
records-page-remove-filter = Rimuovere il filtro { $filter }
records-page-looking = Ricerca…
records-page-count = { $many ->
    [one] 1 registrazione
   *[other] { $count } registrazioni
}
records-page-more = { $count }+ registrazioni
records-page-unread = Impossibile leggere il registro: { $why }
records-page-none = nessun registro aperto
records-page-missing = Manca la registrazione { $number }
records-page-empty = Qui appaiono i controlli dopo la registrazione
records-page-none-found = Nessuna registrazione corrisponde

## L'elenco
records-page-list = Registrazioni
records-page-head-number = N.
records-page-zone = Nella zona
records-page-move = Passare a un'altra registrazione
records-page-open = Aprire la registrazione
records-page-choose = Selezionare per un rapporto
records-page-choose-record = Selezionare la registrazione { $number } per un rapporto
records-page-chosen = { $count ->
    [one] 1 selezionata
   *[other] { $count } selezionate
}
records-page-copy = Copiare
records-page-report-of = Rapporto di { $count }…
records-page-reports-listed = Un rapporto comprende tutte le { $count } registrazioni in elenco
records-page-reports-chosen = Un rapporto comprende le { $count } registrazioni selezionate
records-page-too-many = In elenco ci sono { $count } registrazioni. Un rapporto o una selezione ne comprende al massimo { $most }: ridurre l'elenco, ad esempio per pezzo o data
records-page-still-looking = L'elenco non è ancora completo. Riprovare quando ne appare il numero
records-page-nothing-to-report = Nessuna registrazione in elenco può stare in un rapporto: non sono più valide, sono simulate o di cicli
records-page-report = Rapporto…
records-page-with-simulated = Con controlli simulati
records-page-with-simulated-hint = I controlli simulati non sono una prova; il rapporto dice che ne contiene
records-page-report-simulated = { $count ->
    [one] 1 di questi controlli è simulato: non è una prova
   *[other] { $count } di questi controlli sono simulati: non sono una prova
}
records-page-report-from = Dal registro { $chain }, registrazioni { $numbers }; la voce più recente è { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] 1 controllo simulato è tralasciato
   *[other] { $count } controlli simulati sono tralasciati
}
records-page-out-replaced = { $count ->
    [one] 1 registrazione corretta o ritirata è tralasciata
   *[other] { $count } registrazioni corrette o ritirate sono tralasciate
}
records-page-report-corrects = { $count ->
    [one] 1 valore sostituisce una registrazione corretta
   *[other] { $count } valori sostituiscono registrazioni corrette
}
records-page-out-cycles = { $count ->
    [one] 1 registrazione di un ciclo è tralasciata
   *[other] { $count } registrazioni di cicli sono tralasciate
}
records-page-out-reports = { $count ->
    [one] 1 rapporto o allarme è tralasciato: non è un controllo
   *[other] { $count } rapporti e allarmi sono tralasciati: non sono controlli
}
records-page-out-unread = { $count ->
    [one] 1 registrazione illeggibile è tralasciata
   *[other] { $count } registrazioni illeggibili sono tralasciate
}
records-page-see = Non valida, vedere { $number }
records-page-void = Registrazione { $number }, non più valida: vedere { $by }
records-page-instead = per { $number }
records-page-takes-back = Ritira { $number }
records-page-withdrawal = Ritiro
records-page-report-entry = Rapporto
records-page-alarm = Allarme
records-page-alarm-answers = Risposta all'allarme { $number }
records-page-alarm-answered = Allarme, risposta { $number }
records-page-alarm-first = Primo valore: { $number }
records-page-alarm-last = Valore a cui la regola è scattata: { $number }
records-page-cycle = Ciclo { $cycle }
records-page-went-back = { $time } (orologio)

## Una registrazione aperta
records-page-close = Tornare all'elenco
records-page-reading = Lettura della registrazione
records-page-measure-again = Rimisurare
records-page-measure-again-hint = Porta indicazione, pezzo, numero di serie e regola nella pagina Controllo
records-page-correct = Correggere…
records-page-correct-hint = Aggiunge una registrazione al posto di questa; restano entrambe
records-page-simulated = Simulato: nessuno lo ha misurato
records-page-corrected-by = Corretta o ritirata dalla registrazione { $number }
records-page-corrects = Al posto della registrazione { $number }
records-page-in-report = Nel rapporto { $number }, { $name }
records-page-reports-unread = I rapporti con questo controllo non si possono leggere: { $why }
records-page-report-unknown = { $name } è stato scritto, ma il registro non lo conosce: { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, foro
    [neither] { $callout }, né foro né albero
   *[shaft] { $callout }, albero
}
records-page-distance = Dai limiti
records-page-importer = Importato da
records-page-void-why = Non più valida per
records-page-void-by = Corretta o ritirata da
records-page-decided = Decisione
records-page-limits = Limiti
records-page-source = Limiti da
records-page-contacts = Punti di contatto
records-page-rule = Regola
records-page-station = Stazione
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = L'orologio della stazione è stato spostato indietro prima di questa registrazione
records-page-cycle-number = Ciclo
records-page-program = Programma
records-page-block = { $program }, linea { $line }
records-page-datum = Origine
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, impostata nella linea { $line }: { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = assi ruotati di { $angle }°, dalla linea { $line }: { $block }
records-page-datum-tilt = piano ruotato di A { $a }°, B { $b }°, C { $c }°, dalla linea { $line }: { $block }
records-page-parameters = Parametri
records-page-figures = Risultati
records-page-file-measurements = Misure
records-page-file-program = Programma
records-page-file-workpiece = Pezzo in lavorazione
records-page-file-budget = Bilancio dell'incertezza
records-page-report-file = File
records-page-report-format = Formato
records-page-report-size = Dimensione
records-page-report-bytes = { $count } byte
records-page-report-title = Titolo
records-page-report-sha256 = SHA-256
records-page-report-checks = Controlli registrati
records-page-report-numbers = Le loro registrazioni
records-page-report-unrecorded = Controlli senza registrazione
records-page-report-head = Voce più recente allora
records-page-chain = Catena
records-page-chain-name = Registro
records-page-hash = Hash

## Una correzione
records-page-correction = Correggere la registrazione { $number }
records-page-correction-rule = Valutato di nuovo come la registrazione { $number }: { $rule }.
records-page-correction-temperature = Corretto da { $temperature } °C a 20 °C.
records-page-correction-rest = Pezzo, numero di serie, nome
records-page-correction-hint = Una nuova registrazione prende il posto di questa. Nel registro restano entrambe.
records-page-corrector = Corretto da
records-page-reason = Motivo
records-page-reason-mistyped = errore di digitazione
records-page-reason-wrong-part = pezzo sbagliato
records-page-reason-trial = prova
records-page-withdrawal-hint = La registrazione non conta più, e nulla ne prende il posto. Nel registro restano entrambe le voci.
records-page-withdraw = Ritirare la registrazione
records-page-withdraw-hint = Nulla ne prende il posto
records-page-withdraw-neither = La registrazione { $number }, corretta da questa, non torna a contare
records-page-send-correction = Registrare la correzione
records-page-leave-correction = Annullare
records-page-undo-void = Non annullato: la registrazione è stata ritirata dopo la correzione
records-page-undone-reason = annullato
records-page-taken-back = { $checks ->
    [one] 1 controllo annullato
   *[other] { $checks } controlli annullati
}; { $records ->
    [one] la registrazione { $numbers } è ritirata
   *[other] le registrazioni { $numbers } sono ritirate
}
records-page-taken-back-unwritten = { $checks ->
    [one] 1 controllo annullato; non era ancora registrato e non lo sarà
   *[other] { $checks } controlli annullati; non erano ancora registrati e non lo saranno
}
records-page-not-withdrawn = { $records ->
    [one] La registrazione { $numbers } conta ancora e non è stato possibile ritirarla: { $why }
   *[other] Le registrazioni { $numbers } contano ancora e non è stato possibile ritirarle: { $why }
}
records-page-undone = Correzione annullata
records-page-no-reason = Una correzione richiede un motivo
records-page-nothing-changed = Nulla è diverso: modificare un campo, o ritirare la registrazione
records-page-not-open = La registrazione non è aperta
records-page-not-recording = I controlli non vengono registrati

## Il registro
records-page-place = { $file } · voci: { $entries }
records-page-unsent = { $count } non ancora inviate a { $server }
records-page-all-sent = tutte inviate a { $server }
records-page-server-unknown = { $server } non è stato ancora raggiunto
records-page-server = Server dell'officina
records-page-server-hint = Invia ogni registrazione a un server PostgreSQL, in background; senza server tutto resta su questo computer
records-page-server-address = Indirizzo, come postgres://mill3@shop.example/checks
records-page-server-passwords = La password viene dall'indirizzo, da PGPASSWORD, dal file delle password o dal portachiavi del sistema. Una password nell'indirizzo va nel portachiavi e non è conservata altrove.
records-page-take-server = Usare questo server
records-page-leave-server = Non inviare più
records-page-send-again = Inviare di nuovo
records-page-not-sent = Non inviato: { $why }
records-page-and = { $one }; { $other }
records-page-no-shop = questo Fitcheck è compilato senza supporto per un server dell'officina (feature shop)
records-page-in-keyring = La password di { $server } è ora nel portachiavi del sistema
records-page-not-in-keyring = Non è stato possibile mettere la password di { $server } nel portachiavi del sistema ({ $reason }): vale fino alla chiusura della finestra, poi deve venire da PGPASSWORD o dal file delle password
records-page-verify = Verificare
records-page-verify-hint = Confronta ogni voce con la precedente
records-page-verify-cancel = Interrompere la verifica
records-page-verify-cancelled = Verifica interrotta
records-page-verify-progress = Avanzamento della verifica
records-page-verifying = { $done } di { $of } voci
records-page-whole = { $time }: { $entries } voci verificate, fino alla { $number } ({ $hash })
records-page-broken = { $time }: { $entries } voci esaminate; il registro non è come è stato scritto
records-page-not-verified = { $time }: non verificato: { $why }
records-page-no-anchors = impossibile leggere le voci note altrove: { $why }
