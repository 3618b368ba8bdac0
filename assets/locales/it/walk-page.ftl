# La misura di un pezzo, quota per quota, e la cartella sorvegliata, nella pagina Pezzi.

walk-page-begin = Iniziare pezzo
walk-page-count-up = Numero successivo
walk-page-take = Valutare
walk-page-take-meant = Usare { $meant } mm
walk-page-it-is-so = È così: valutare { $measured } mm
walk-page-measure-anew = Scartare e rimisurare
walk-page-confirmed = confermato alla misura: è così
walk-page-alarms = Allarmi aperti: { $count }
walk-page-alarms-short = Allarmi
walk-page-alarms-more = Altri allarmi: { $count }
walk-page-alarm = { $name }: { $said }
walk-page-alarm-ask = Rispondere all'allarme
walk-page-alarm-ask-of = Rispondere all'allarme di { $name }
walk-page-alarm-answer = Registrare la risposta
walk-page-alarm-later = Più tardi
walk-page-alarm-cause = Causa
walk-page-alarm-action = Provvedimento
walk-page-alarm-causes = Usura dell'utensile; Utensile nuovo; Correzione dell'utensile; Serraggio; Trucioli o sporco; Temperatura; Materiale; Errore di misura; Sconosciuta
walk-page-alarm-actions = Utensile cambiato; Correzione modificata; Pezzo riserrato; Macchina pulita; Rimisurato; Attrezzista avvisato; In osservazione; Nessuno necessario
walk-page-alarm-empty = scrivere un testo o sceglierne uno dall'elenco
walk-page-alarms-unread = Impossibile verificare le regole delle carte di controllo: { $why }
walk-page-alarms-unchecked = Impossibile verificare le regole delle carte di controllo, { $name }: { $why }
walk-page-alarm-unrecorded = Impossibile registrare l'allarme della carta di controllo: { $why }
walk-page-simulate = Simulare
walk-page-simulate-hint = Esegue il ciclo dell'elemento su un pezzo perfetto; nessuno misura il valore, che resta contrassegnato come simulato
walk-page-again = Rimisurare
walk-page-skip = Saltare
walk-page-skip-for = Saltare per questo motivo
walk-page-skip-not = Non saltare
walk-page-next = Pezzo successivo
walk-page-move = Passare a un'altra quota
walk-page-import = Importare valori…
walk-page-watch = Sorvegliare cartella…
walk-page-watch-hint = I file messi nella cartella vengono valutati secondo il piano e registrati, ciascuno una volta
walk-page-watch-stop = Terminare sorveglianza
walk-page-dialog-watch = Sorvegliare una cartella
walk-page-begin-warned = { $count ->
    [one] 1 quota di questo pezzo non ha né valore né motivo. Premere di nuovo per terminare questo pezzo.
   *[other] { $count } quote di questo pezzo non hanno né valore né motivo. Premere di nuovo per terminare questo pezzo.
}
walk-page-no-plan = Ancora nessun piano: aprirne uno, o crearne uno nella vista Piano.
walk-page-plan-wrong = { $count ->
        [one] Il piano ha un errore: vedere la vista Piano.
       *[other] Il piano ha { $count } errori: vedere la vista Piano.
    }
walk-page-not-saved = Il piano ha modifiche non salvate: un pezzo interrotto non si può ripristinare dopo un riavvio.
walk-page-serial = Numero di serie
walk-page-serial-again = Il numero di serie { $serial } è già stato misurato. Premere di nuovo Invio, dopo mezzo secondo, per ricominciarlo.
walk-page-serial-hint = Digitarlo, leggerlo con lo scanner o usare il numero successivo; Invio inizia il pezzo.
walk-page-recent = Piani recenti
walk-page-done = Ogni quota ha un valore o è saltata
walk-page-part = { $part }, numero di serie { $serial }
walk-page-part-serial = Numero di serie { $serial }
walk-page-part-no-serial = { $part }, senza numero di serie
walk-page-other-plan = Nel frattempo il piano è cambiato: le modifiche valgono dal pezzo successivo.
walk-page-part-of = Questo pezzo viene misurato secondo { $own }
walk-page-open-is = Aperto ora: { $open }
walk-page-begin-by = Iniziare un pezzo secondo { $open }
walk-page-keep-on = Continuare questo pezzo
walk-page-unfinished = Un pezzo misurato secondo { $own } non è finito. Misurare chiede se continuarlo.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = Nessuna posizione nel piano
walk-page-value = Valore misurato
walk-page-measured-before = { $count ->
        [one] Misurata una volta: entrambi i valori sono conservati, e vale il nuovo
       *[other] Misurata { $count } volte: tutti i valori sono conservati, e vale il nuovo
    }
walk-page-last-counts = Misurata { $count } volte: tutti i valori sono conservati, e vale questo
walk-page-skip-why = Motivo del salto
walk-page-skip-access = Tastatore senza accesso
walk-page-skip-gauge = Manca lo strumento
walk-page-skip-machined = Non ancora lavorata
walk-page-skip-elsewhere = Misurata altrove
walk-page-reason = Altro motivo
walk-page-no-reason = serve un motivo
walk-page-skipped = saltata: { $reason }
walk-page-next-warned = { $count ->
        [one] Una quota non ha né valore né motivo. Scegliere di nuovo Pezzo successivo per terminare questo pezzo.
       *[other] { $count } quote non hanno né valore né motivo. Scegliere di nuovo Pezzo successivo per terminare questo pezzo.
    }
walk-page-typed-elsewhere = il valore è stato digitato per { $name }, e ora si chiede { $asked }: digitarlo di nuovo
walk-page-next-size = Prossima: { $name }, { $asked }
walk-page-is-serial = { $given } sembra un numero di serie e non viene preso come valore: finire prima questo pezzo, poi leggerlo per il pezzo successivo. Se è il valore misurato, digitarlo con più decimali
walk-page-simulate-measured = { $name } ha un valore misurato: un valore simulato non prende mai il posto di uno misurato
walk-page-part-status = Stato del pezzo
walk-page-not-complete = Ancora nessun esito
walk-page-simulated = { $count ->
        [one] Un valore è simulato: nessuno lo ha misurato, quindi non può rendere buono il pezzo.
       *[other] { $count } valori sono simulati: nessuno li ha misurati, quindi non possono rendere buono il pezzo.
    }
walk-page-missing = Mancanti: { $names }
walk-page-off = La registrazione è disattivata: un pezzo interrotto non si può ripristinare dopo un riavvio.
walk-page-nowhere = Non viene registrato nulla: un pezzo interrotto non si può ripristinare dopo un riavvio.
walk-page-no-part = Nessun pezzo in misura.
walk-page-sizes = Quote del pezzo
walk-page-open = aperta
walk-page-row-simulated = simulata
walk-page-times = { $count } valori
walk-page-rule-plan = Valutato secondo la regola del piano: { $rule }
walk-page-rule-own = Il piano non ha una regola; valutato secondo quella della pagina Controllo: { $rule }
walk-page-nothing-asked = nessuna quota del piano è in misura
walk-page-refused = { $count ->
        [one] Un controllo non è stato registrato: { $why }
       *[other] { $count } controlli non sono stati registrati: { $why }
    }
walk-page-import-late = { $name } è stato letto dopo la fine del pezzo: i suoi valori non vengono usati
walk-page-imported = { $name }: { $good } importati, { $bad } no
walk-page-file-for-check = Nulla in esso è di questo piano. La pagina Controllo può valutare il file secondo ciò che esso stesso indica
walk-page-found-by-name = { $count ->
    [one] Attribuita per nome: 1 riga
   *[other] Attribuite per nome: { $count } righe
}
walk-page-found-by-number = Attribuite solo per numero, con le loro linee: { $rows }
walk-page-found-by-place = Attribuite per posizione, con le loro linee: { $rows }
walk-page-other-parts = I valori di altri pezzi sono registrati con i loro numeri di serie: { $serials }
walk-page-label = Il file non ha numeri di serie e chiama il pezzo { $part }: i suoi valori valgono per questo pezzo
walk-page-other-label = del pezzo { $part }, e senza numero di serie non è noto se sia questo pezzo
walk-page-remark-label = Pezzo nel file: { $part }
walk-page-not-judged = linea { $line }: { $why }
walk-page-no-journal = Il pezzo { $serial } è stato ripristinato senza i suoi valori: non ci sono registrazioni da cui ripristinarli
walk-page-gone = Alcune quote non sono più nel piano: i loro valori misurati restano nel registro
walk-page-gone-name = { $name }
walk-page-changed = Il piano è cambiato: i valori valutati con altri limiti o un'altra regola, e quelli di righe senza nome, restano nel registro, e le loro quote sono di nuovo aperte
walk-page-changed-size = { $name }: { $measured } mm, misurato secondo { $asked }
walk-page-given-up = Il pezzo interrotto { $serial } non viene ripristinato, perché ne è stato iniziato un altro: i suoi valori restano nel registro
walk-page-ended = Non usato per il pezzo { $serial }, che è terminato
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = Un valore di { $name } è stato corretto o ritirato nel registro: non vale più per questo pezzo
walk-page-put-right = Un valore di { $name } è stato corretto nel registro: per questo pezzo vale quello corretto
walk-page-no-folder = { $path } non è una cartella
walk-page-not-read = Non è stato possibile leggere i valori del pezzo interrotto: { $why }
walk-page-came-back = { $count ->
        [one] Il pezzo interrotto { $serial } è stato ripristinato con un valore
       *[other] Il pezzo interrotto { $serial } è stato ripristinato con { $count } valori
    }
walk-page-watched = Cartella sorvegliata
walk-page-part-waits = Il pezzo { $serial } viene ripristinato quando il suo piano non ha più errori
walk-page-watch-waits = La cartella { $path } viene di nuovo sorvegliata quando il piano non ha più errori
walk-page-watch-no-plan = per sorvegliare una cartella serve un piano senza errori: aprirne prima uno
walk-page-watch-no-journal = impossibile aprire il registro: non è noto quali file siano già stati importati, quindi nessuna cartella viene sorvegliata
walk-page-watch-begins = Ricerca nel registro dei file già importati
walk-page-known = { $count ->
        [0] Il registro non ha file importati in precedenza
        [one] Il registro ha un file importato in precedenza, da qualsiasi cartella: non viene importato di nuovo
       *[other] Il registro ha { $count } file e parti di file importati in precedenza, da qualsiasi cartella: non vengono importati di nuovo
    }
walk-page-mask = L'output di FN 16 viene riletto con la maschera { $name }
walk-page-watch-recording = In registrazione
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] Un file importato
       *[other] { $count } file importati
    }
walk-page-report = Rapporto…
walk-page-report-people = Rapporto di controllo ({ $format })…
walk-page-report-programs = Valori del pezzo come { $format }…
walk-page-contradicted = { $names }: i valori si contraddicono, e nulla dice quale sia giusto. Vale il peggiore finché non si rimisura o si sceglie.
walk-page-contradicting = { $name } ha valori che si contraddicono: { $values }. Vale il peggiore finché non si rimisura o si sceglie.
walk-page-count-newest = Vale l'ultimo valore
walk-page-newest-counts = { $name }: vale l'ultimo valore, come scelto
walk-page-accepted = Accettato fuori dai limiti: { $names }
walk-page-because = A causa di { $names }
walk-page-left-out = Saltate: { $names }. Un pezzo con quote saltate non può essere buono.
walk-page-whole = Il pezzo intero
walk-page-whole-serial = Il pezzo { $serial }
walk-page-strip-open = Il pezzo: ancora nessun esito
walk-page-strip-part = Il pezzo: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Misurato secondo il piano { $name }
walk-page-judged-by-plan = Valutato secondo il piano { $name }
walk-page-watch-no-mask = Impossibile leggere la maschera propria { $path }: la cartella viene sorvegliata quando si sceglie di nuovo questa maschera o un'altra (Menu, Maschera propria…)
walk-page-watch-nobody = { $count ->
        [one] Un valore è registrato senza numero di serie: il suo file non ne indica, e nessun pezzo è in misura secondo questo piano
       *[other] { $count } valori sono registrati senza numero di serie: il loro file non ne indica, e nessun pezzo è in misura secondo questo piano
    }
walk-page-watch-other-plan = La cartella è valutata secondo il piano com'era all'inizio della sorveglianza. Per valutare secondo il piano attuale, iniziare un pezzo o sorvegliare di nuovo la cartella.
walk-page-watch-not-saved = Il piano ha modifiche non salvate: dopo un riavvio la cartella non viene più sorvegliata.
walk-page-values = Valori di { $name }
walk-page-to-do = { $name }: { $what }
walk-page-of = quota { $at } di { $count }
walk-page-no-serial = Nessun numero di serie
