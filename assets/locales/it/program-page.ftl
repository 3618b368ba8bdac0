## La pagina Programmi

page-program = Programmi
program-page-dialog-open = Aprire un programma NC
program-page-choice = Programma NC
program-page-open = Aprire…
program-page-not-shipped = { $name } non è compreso in questa versione
program-page-nothing = Nessun programma aperto
program-page-listing = { $name }, { $count ->
    [one] { $count } blocco
   *[other] { $count } blocchi
  }

program-page-run = Eseguire
program-page-pause = Pausa
program-page-step = Blocco singolo
program-page-step-over = Chiamata intera
program-page-to-selected = Fino al cursore
program-page-breakpoint = Breakpoint
program-page-reset = Azzerare
program-page-move = Passare a un altro blocco
program-page-speed = Velocità
program-page-speed-slow = 4 blocchi/s
program-page-speed-medium = 20 blocchi/s
program-page-speed-fast = velocità massima
program-page-options = Opzioni
program-page-skip-unknown = Saltare blocchi sconosciuti
program-page-assume-tool = Tastare lungo Z senza TOOL CALL
program-page-block-skip = Saltare blocchi con /
program-page-optional-stop = Arresto con M1
program-page-outline-none = titolo o label
program-page-outline = Andare a

program-page-state-ready = Pronto per l'esecuzione
program-page-state-running = In esecuzione
program-page-state-paused = In pausa
program-page-state-step = Blocco singolo
program-page-state-breakpoint = In pausa a un breakpoint
program-page-state-goal = In pausa al cursore
program-page-state-over = In pausa dopo la chiamata
program-page-state-stop = Il programma si è arrestato da sé: Eseguire continua
program-page-state-optional-stop = Il programma si è arrestato da sé con M1: Eseguire continua
program-page-state-tolerance = Fuori tolleranza: { $stop }
program-page-state-log = Il protocollo è sullo schermo: Eseguire continua
program-page-state-ended = Terminato dopo { $blocks } blocchi
program-page-state-fault = Arrestato con un errore
program-page-refused-inputs = Un'immissione non è leggibile
program-page-refused-none = Nessun programma aperto
program-page-refused-workpiece = Il pezzo in lavorazione non è leggibile
program-page-refused-no-contacts = Nessun punto di contatto aperto

program-page-has-breakpoint = breakpoint
program-page-is-current = blocco successivo
program-page-is-failed = errore qui

program-page-inputs = Immissioni
program-page-answers = Fitcheck e il programma
program-page-program = Programma
program-page-verdict = Esito
program-page-no-limits = Nessun limite: un'immissione non è leggibile
program-page-agrees = Il programma concorda con Fitcheck
program-page-contested = Programma { $program }, Fitcheck { $own }
program-page-contested-limits = Programma { $program }, con limiti diversi da quelli di Fitcheck
program-page-stopped-at = Arrestato con un errore; finora { $program }
program-page-differs = Il programma differisce: { $what }
program-page-differs-minimum = il suo minimo è { $program } mm, quello di Fitcheck { $own } mm
program-page-differs-maximum = il suo massimo è { $program } mm, quello di Fitcheck { $own } mm
program-page-differs-status = dice { $program }, Fitcheck dice { $own }
program-page-differs-fault = si è arrestato con un errore
program-page-differs-native-refuses = ha dato un esito, Fitcheck non ha limiti
program-page-other-inputs = Non confrontato: il programma ha poi impostato altre immissioni e misura un altro elemento
program-page-both-refuse = Né il programma né Fitcheck danno un risultato

program-page-workpiece = Pezzo in lavorazione
program-page-from-perfect = perfetto, al centro dei limiti
program-page-from-nominal = perfetto, alla quota nominale
program-page-from-given = perfetto, diametro indicato
program-page-from-simulated = simulato
program-page-from-part = pezzo con più elementi
program-page-open-part = Aprire pezzo…
program-page-dialog-part = Aprire un pezzo simulato con più elementi
program-page-refused-no-part = Nessun pezzo aperto
program-page-from-recorded = punti di contatto registrati
program-page-workpiece-x = Centro effettivo X
program-page-workpiece-y = Centro effettivo Y
program-page-edit-workpiece = Pezzo in lavorazione e tastatore…
program-page-open-contacts = Altri punti di contatto…
program-page-recorded = { $count ->
    [one] { $count } punto di contatto
   *[other] { $count } punti di contatto
  } da { $name }
program-page-path = Percorso del tastatore
program-page-no-path = Ancora nessun percorso
program-page-zero = Zero X { $x }, Y { $y }, Z { $z } mm
program-page-turned = ruotato di { $angle }°
program-page-tilted = inclinato A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = Il programma non ha aperto finestre
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, SIMULATO
program-page-cycles = Misurato
program-page-show-block = Mostrare il blocco
program-page-last-of = Gli ultimi { $shown } di { $all }
program-page-outputs = File
program-page-outputs-hint = Mostrati qui, non scritti su disco

program-page-parameters = Parametri
program-page-filter = Filtro
program-page-set = Iniziare con
program-page-value = Valore
program-page-give = Impostare
program-page-give-hint = La prossima esecuzione inizia con questo valore
program-page-given = Impostati per la prossima esecuzione
program-page-drop = rimuovere
program-page-no-parameter = { $given } non è un parametro: scrivere Q5, QL5, QR5 o QS5
program-page-no-number = { $given } non è un numero
program-page-none-found = Nessun parametro corrisponde
program-page-no-parameters = I parametri sono elencati quando il programma è in esecuzione
program-page-undefined = non definito
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, modificato
program-page-pin = Tenere { $parameter } in alto
program-page-unpin = Non tenere { $parameter } in alto
program-page-q108 = raggio dell'utensile
program-page-q109 = asse utensile: 0 X, 1 Y, 2 Z
program-page-q110 = mandrino: 0 M3, 1 M4, 2 o 3 poi fermato
program-page-q111 = refrigerante: 0 spento, 1 acceso
program-page-q113 = unità: 0 mm, 1 pollici
program-page-q114 = lunghezza dell'utensile
program-page-q115 = posizione tastata, X
program-page-q116 = posizione tastata, Y
program-page-q117 = posizione tastata, Z
program-page-q150 = angolo misurato

program-page-problems = { $count ->
    [one] { $count } nota
   *[other] { $count } note
  }
program-page-unlisted = { $count ->
    [one] { $count } altra non è elencata
   *[other] altre { $count } non sono elencate
  }
program-page-at-block = blocco { $number }: { $what }
program-page-at-line = linea { $line }: { $what }

program-page-create = Creare per un CN…
program-page-create-hint = Programmi NC, tabelle e maschera con cui un controllo numerico misura da solo
program-page-create-also = scrivere set di file programmi NC
program-page-create-head = Creare per un controllo numerico
program-page-create-control = Controllo numerico
program-page-create-language = Lingua di dialogo
program-page-create-from = Da
program-page-create-series = Per una serie: ogni avvio misura il pezzo successivo
program-page-create-texts = Tolleranze dei diametri come testi del ciclo
program-page-create-callout = { $callout } da Controllo, a X { $x } Y { $y } Z { $z }
program-page-create-no-callout = L'indicazione in Controllo
program-page-create-plan = Piano { $name }, { $count ->
    [one] { $count } elemento
   *[other] { $count } elementi
  }
program-page-create-nothing = Inserire un'indicazione nella pagina Controllo, o aprire un piano nella pagina Pezzi
program-page-create-plan-wrong = { $name } contiene errori: aprire il piano nella pagina Pezzi e correggerli
program-page-create-folder = Cartella sul controllo numerico: { $folder }
program-page-create-proven-callout = Riletti ed eseguiti: { $callout } riceve esattamente i limiti di Fitcheck
program-page-create-proven-plan = Riletti ed eseguiti: ogni elemento riceve i limiti del piano
program-page-create-clearance-height = L'altezza di sicurezza è { $height } mm; in un piano la imposta una colonna
program-page-create-files-none = Creare file…
program-page-create-files = Creare { $count ->
    [one] { $count } file…
   *[other] { $count } file…
  }
program-page-dialog-create = Creare file per un controllo numerico: scegliere o indicare una cartella
program-page-create-written = { $count ->
    [one] { $count } file scritto
   *[other] { $count } file scritti
  } in { $folder }: { $names }
program-page-create-no-folder = { $name } è un file: indicare una cartella
program-page-contacts-left = I punti di contatto di { $name } appartengono al programma precedente: questo misura un pezzo in lavorazione perfetto
program-page-unfinished = Non confrontato: il programma non è arrivato alla fine
program-page-unknown = { $fault }. Per proseguire senza, attivare Opzioni → Saltare blocchi sconosciuti
program-page-missing-file = { $fault }. È stato cercato in { $folder }, e tra i file integrati. Metterlo lì, accanto al programma, o aprire il programma nella cartella che lo contiene
program-page-unknown-datum = { $fault }. Senza la sua origine non si misura nulla. Per una prova, aprire una copia del programma senza il blocco che la imposta, e un pezzo in lavorazione visto da quell'origine
program-page-not-written = { $path } verrebbe scritto sul controllo numerico. Il suo testo è in File; nella riga di comando, fitcheck run --output-folder lo scrive
program-page-no-verdict = Nessun limite, nessun esito
