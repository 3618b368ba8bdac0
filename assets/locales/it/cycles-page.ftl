# La pagina Cicli: il modulo di un ciclo di misura, il suo pezzo in lavorazione, il suo percorso e i suoi risultati.

page-cycles = Cicli

cycles-cycle = Ciclo
cycles-choose = Ciclo { $number } { $name }
cycles-group-position = Posizione
cycles-group-probing = Tastatura
cycles-group-tolerance = Tolleranza
cycles-group-output = Output
cycles-optional-position = Posizione, facoltativa
cycles-optional-probing = Tastatura, facoltativa
cycles-optional-tolerance = Tolleranza, facoltativa
cycles-optional-output = Output, facoltativo
cycles-contacts-from = Punti di contatto da
cycles-perfect = Pezzo perfetto
cycles-simulated = Simulati
cycles-recorded = Registrati
cycles-workpiece = Pezzo in lavorazione…
cycles-suit = Adattare al ciclo
cycles-open-contacts = Punti di contatto…
cycles-no-file = ancora nessun file
cycles-contacts-of = { $count ->
    [one] { $count } punto di contatto
   *[other] { $count } punti di contatto
    }, { $file }
cycles-probe = Tastatore
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Tabella di tastatura propria…
cycles-shipped-probes = Tabella integrata
cycles-run = Eseguire
cycles-needed = obbligatorio
cycles-none = nessuno
cycles-predef = PREDEF sta per
cycles-predef-missing = PREDEF: digitare il valore dato da GLOBAL DEF
cycles-without-effect = Accettato senza effetto
cycles-position = Posizione della sfera
cycles-ball-stands = Sfera a
cycles-paste-block = Incollare blocco NC…
cycles-copy-block = Copiare come blocco NC
cycles-copy-results = Copiare i risultati
cycles-block-copied = Il blocco NC è stato copiato
cycles-block = Blocco NC
cycles-block-hint = Incollare un blocco come TCH PROBE 427 … Q263=+35 ;TEXT ~ o G785 R0 BR0 K2: sostituisce il modulo
cycles-fill = Compilare il modulo

cycles-nothing-seen = Percorso e punti di contatto appaiono dopo un'esecuzione: premere Invio o F5
cycles-allowed = Ammesso: { $range } { $unit }
cycles-must-be-given = Obbligatorio
cycles-may-be-left-out = Facoltativo
cycles-default = { $value } se vuoto
cycles-may-be-predef = PREDEF è ammesso
cycles-path = Percorso della sfera
cycles-first = Primo
cycles-back = Indietro
cycles-next = Avanti
cycles-last = Ultimo
cycles-move = Spostamento
cycles-phase-pre-position = preposizionamento
cycles-phase-approach = avvicinamento
cycles-phase-contact = contatto
cycles-phase-retract = ritorno
cycles-phase-leave = disimpegno
cycles-move-contact = { $number } di { $count }: { $phase } { $touch }, a { $to }
cycles-move-of-touch = { $number } di { $count }: { $phase }, contatto { $touch }, da { $from } a { $to }
cycles-move-of-none = { $number } di { $count }: { $phase }, da { $from } a { $to }
cycles-criteria = Criteri a confronto

cycles-word-stopped = Non misurato
cycles-word-no-verdict = Nessun esito
cycles-no-limits = nessun limite indicato
cycles-no-limits-marked = nessun limite indicato; un controllo numerico segnala allora entro tolleranza
cycles-more-out = { $what }, altri { $count } sotto
cycles-no-window = Nessuna dimensione limite: il controllo numerico non mostra la finestra di stato
cycles-results = Parametri di risultato
cycles-log-file = Il controllo numerico scrive { $name }
cycles-log-screen = Il controllo numerico si arresta e mostra il protocollo sullo schermo
cycles-log-shown = Il controllo numerico mostra il risultato sullo schermo
cycles-save-log = Salvare protocollo…
cycles-dialog-save-log = Salvare il protocollo di misura
cycles-no-log = nessun protocollo da salvare
cycles-from-perfect = Misurato su un pezzo in lavorazione perfetto alla quota nominale, con un punto come tastatore
cycles-from-simulated = Misurato sul pezzo in lavorazione simulato, seme { $seed }
cycles-from-recorded = Punti di contatto da { $file }
cycles-unused = Il ciclo non ha usato { $count ->
    [one] un punto di contatto
   *[other] { $count } punti di contatto
    } del file

cycles-fields-wrong = { $count ->
    [one] un campo non è utilizzabile
   *[other] { $count } campi non sono utilizzabili
    }: vedere il modulo
cycles-no-workpiece = il pezzo in lavorazione simulato non è completo
cycles-workpiece-wrong = pezzo in lavorazione simulato: { $problem }
cycles-workpiece-field = { $name }: { $problem }
cycles-no-contacts = nessun file di punti di contatto è stato ancora aperto
cycles-cannot-suit = Ancora nessun pezzo in lavorazione adatto: { $problem }
cycles-not-written = impossibile scrivere il pezzo in lavorazione: { $reason }
cycles-contacts-loaded = Si usano i punti di contatto di { $name }
cycles-column-ignored = la colonna { $column } viene saltata
cycles-probes-loaded = Si usa la tabella di tastatura { $name }
cycles-dialog-contacts = Aprire punti di contatto registrati
cycles-dialog-workpiece = Aprire un pezzo in lavorazione simulato
cycles-dialog-probes = Aprire una tabella di tastatura
cycles-dialog-save-workpiece = Salvare il pezzo in lavorazione simulato

cycles-open-workpiece = Aprire…
cycles-save-workpiece = Salvare…
cycles-shape-bore = Foro
cycles-shape-stud = Albero
cycles-shape-face = Superficie piana
cycles-shape-point = Punto su superficie libera
cycles-shape-slot = Scanalatura
cycles-shape-ridge = Isola a nervatura
cycles-shape-pocket = Tasca
cycles-shape-boss = Isola
cycles-plane = Piano
workpiece-probe = Tastatore
workpiece-machine = Dispersione e temperatura
workpiece-centre-1 = Centro, 1° asse
workpiece-centre-2 = Centro, 2° asse
workpiece-ovality-angle = Angolo dell'ovalità
workpiece-lobe-angle = Angolo dei lobi
workpiece-point-x = Punto X
workpiece-point-y = Punto Y
workpiece-point-z = Punto Z
workpiece-normal-x = Normale X
workpiece-normal-y = Normale Y
workpiece-normal-z = Normale Z
workpiece-wave-height = Ampiezza dell'onda
workpiece-wave-length = Lunghezza d'onda
workpiece-wave-x = Direzione onda X
workpiece-wave-y = Direzione onda Y
workpiece-wave-z = Direzione onda Z
workpiece-deviation = Scostamento lungo normale
workpiece-radius = Raggio della superficie
workpiece-width = Larghezza
workpiece-length-1 = 1ª lunghezza
workpiece-length-2 = 2ª lunghezza
workpiece-angle = Angolo delle pareti
workpiece-ball = Raggio della sfera
workpiece-trigger = Dispersione scatto 1σ
workpiece-calibration = Errore di calibrazione
workpiece-offset-x = Eccentricità sfera X
workpiece-offset-y = Eccentricità sfera Y
workpiece-lobing-count = Lobi della precorsa
workpiece-lobing = Ampiezza della precorsa
workpiece-lobing-angle = Angolo della precorsa
workpiece-temperature = Temperatura del pezzo
workpiece-expansion = Dilatazione

cycles-choice-move-to-clearance-0 = all'altezza di misura
cycles-choice-move-to-clearance-1 = all'altezza di sicurezza
cycles-choice-clearance-mode-minus-1 = mai ad altezza di sicurezza
cycles-choice-clearance-mode-0 = prima e dopo il ciclo
cycles-choice-clearance-mode-1 = prima e dopo ogni oggetto
cycles-choice-clearance-mode-2 = a ogni contatto
cycles-choice-traverse-0 = in linea retta
cycles-choice-traverse-1 = su un arco
cycles-choice-contact-count-3 = contatti
cycles-choice-contact-count-4 = contatti
cycles-choice-contact-count-5 = contatti
cycles-choice-contact-count-6 = contatti
cycles-choice-contact-count-7 = contatti
cycles-choice-contact-count-8 = contatti
cycles-choice-contact-count-9 = contatti
cycles-choice-log-0 = nessun protocollo
cycles-choice-log-1 = protocollo in un file
cycles-choice-log-2 = arresto, protocollo sullo schermo
cycles-choice-stop-0 = nessun arresto
cycles-choice-stop-1 = arresto se fuori tolleranza
cycles-choice-stop-on-undersize-0 = nessun arresto
cycles-choice-stop-on-undersize-1 = arresto se fuori tolleranza
cycles-choice-stop-on-undersize-2 = arresto solo per sottomisura
cycles-choice-stop-on-scrap-0 = nessun arresto
cycles-choice-stop-on-scrap-1 = arresto se fuori tolleranza
cycles-choice-stop-on-scrap-2 = arresto solo per scarto
cycles-choice-measured-axis-1 = asse principale X
cycles-choice-measured-axis-2 = asse secondario Y
cycles-choice-measured-axis-3 = asse di tastatura Z
cycles-choice-axis-of-plane-1 = asse principale X
cycles-choice-axis-of-plane-2 = asse secondario Y
cycles-choice-direction-minus-1 = direzione negativa
cycles-choice-direction-1 = direzione positiva
cycles-choice-directed-axis-minus-3 = asse di tastatura Z, direzione negativa
cycles-choice-directed-axis-minus-2 = asse secondario Y, direzione negativa
cycles-choice-directed-axis-minus-1 = asse principale X, direzione negativa
cycles-choice-directed-axis-1 = asse principale X, direzione positiva
cycles-choice-directed-axis-2 = asse secondario Y, direzione positiva
cycles-choice-directed-axis-3 = asse di tastatura Z, direzione positiva
cycles-choice-tool-axis-probing-0 = resta
cycles-choice-tool-axis-probing-1 = tastato e impostato
cycles-choice-transfer-minus-1 = non indicata
cycles-choice-transfer-0 = tabella punti zero
cycles-choice-transfer-1 = tabella origini
cycles-choice-preset-correction-0 = invariata
cycles-choice-preset-correction-1 = corretta con il punto
cycles-choice-preset-correction-2 = corretta con il 2. punto
cycles-choice-preset-correction-3 = corretta con il punto medio
cycles-choice-compensation-axis-0 = asse dell’angolo misurato
cycles-choice-compensation-axis-4 = asse A
cycles-choice-compensation-axis-5 = asse B
cycles-choice-compensation-axis-6 = asse C
cycles-choice-zero-after-alignment-0 = mantiene il suo valore
cycles-choice-zero-after-alignment-1 = indica zero
cycles-choice-rotary-alignment-0 = restano fermi
cycles-choice-rotary-alignment-1 = ruotano, il tastatore segue
cycles-choice-rotary-alignment-2 = ruotano da soli
cycles-choice-rotation-transfer-0 = non cambia nulla
cycles-choice-rotation-transfer-1 = rotazione base
cycles-choice-rotation-transfer-2 = scostamento dell’asse rotativo
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = interno
cycles-choice-side-1 = esterno
cycles-choice-geometries-0 = due fori
cycles-choice-geometries-1 = due perni
cycles-choice-geometries-2 = un foro e un perno
cycles-choice-geometries-3 = un perno e un foro

## La tabella utensili

tools = Tabella utensili
tools-none = nessuna
tools-open-one = { $name }, { $count ->
    [one] un utensile
   *[other] { $count } utensili
  }
tools-open = Aprire tabella utensili…
tools-close = Nessuna tabella utensili
tools-save = Salvare tabella utensili…
tools-save-hint = La tabella con queste modifiche. La prossima esecuzione parte dalla tabella com'era all'apertura.
tools-dialog-open = Aprire una tabella utensili
tools-dialog-save = Salvare la tabella utensili modificata
tools-loaded = Si usa la tabella utensili { $name }
tools-pick = scegliere un utensile
tools-pick-of = { $parameter } dalla tabella utensili
tools-input = { $parameter } Utensile da controllare (Q330)
tools-fixed = Q330 = { $tool } nel programma
tools-more = { $count ->
    [one] un altro utensile
   *[other] altri { $count } utensili
  }
tools-row = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, bloccato
tools-without-name = { $count ->
    [one] un utensile non è in elenco: il suo nome non lo identifica
   *[other] { $count } utensili non sono in elenco: i loro nomi non li identificano
  }
tools-not-in-table = Q330 = { $tool }: la tabella utensili non ha questo utensile
tools-not-monitored = Senza tabella utensili non viene controllato alcun utensile (Q330)
tools-none-named = Q330 non indica alcun utensile: la tabella utensili non viene usata
tools-no-deviation = il valore misurato non si scosta: l'utensile non viene modificato
tools-changed = Modificato nella tabella utensili
tools-nothing-changed = nessuna esecuzione ha modificato la tabella utensili

## Un pezzo con più elementi

cycles-part-refused = il file ha tabelle [[feature]]: un ciclo da solo misura una sola superficie; un pezzo simile si misura con la pagina Programmi e fitcheck run
part-features = Elementi del pezzo
part-of-features = { $name }, { $count ->
    [one] un elemento
   *[other] { $count } elementi
  }, raggio della sfera { $ball } mm
part-round = { $name }: { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name }: { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name }: { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name }: { $kind } X { $x } Y { $y } Z { $z }
