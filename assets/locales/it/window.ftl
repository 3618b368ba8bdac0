# La finestra: etichette, pulsanti, titoli.

page-check = Controllo
page-fit = Accoppiamenti
page-tables = Tabelle
import = Importare…
export = Esportare
export-people = Rapporto di controllo ({ $format })…
export-programs = Cronologia come { $format }…
export-status-check = Finestra di stato di Controllo come testo…
export-status-cycle = Finestra di stato del ciclo { $cycle } come testo…
export-status-program = Finestra del programma come testo…
menu = Menu
language = Lingua
theme = Aspetto
theme-system = Come il sistema
theme-light = Chiaro
theme-dark = Scuro
theme-contrast = Alto contrasto su bianco
theme-inverted = Alto contrasto su nero
density = Dimensione dei pulsanti
density-by-use = Automatica
density-mouse = Mouse
density-touch = Tocco
limits-from = Limiti da
standard-js-rounded = Mezzi micrometri di JS arrotondati per difetto, come nel 1988
standard-1988 = cd, ef e fg solo fino a 10 mm, come nel 1988
load-tables = Tabelle proprie…
no-own-tables = Non usare più le tabelle proprie
load-mask = Maschera propria…
undo = Annullare
undo-what = Annullare: { $what }
undo-add = { $count ->
    [one] aggiunta di 1 controllo
   *[other] aggiunta di { $count } controlli
}
undo-correct = correzione
undo-feature = foro o albero
undo-clear = svuotamento della cronologia
undone = Annullato: { $what }
clear-history = Svuotare la cronologia
choose-bad = { $count ->
    [0] Selezionare i controlli non buoni
    [one] Selezionare il controllo non buono
   *[other] Selezionare { $count } controlli non buoni
}
choose-none = Deselezionare tutto

callout = Indicazione
callout-hint = Digitare una quota nominale e una classe, ad esempio 25 H7
feature-hole = Foro
feature-shaft = Albero
feature-neither = Nessuno dei due
nominal-is = quota nominale { $nominal } mm
maximum = Massimo
minimum = Minimo
from-source = da { $source }
source-overrides = Tabella propria: ISO 286 ha { $upper } / { $lower } µm, quindi una differenza di { $by-upper } / { $by-lower } µm
measured-value = Valore misurato
measured-once = Già valutato. Per valutare ancora lo stesso valore, digitarlo di nuovo o premere il pulsante
by-typing = Digitare
by-simulating = Simulare
judge = Valutare
measure = Misurare
clear = Svuotare
nominal-size = Quota nominale
tolerance-class = Classe
class-none = Scegliere
classes-hole = Classi dei fori
classes-shaft = Classi degli alberi
part-section = Pezzo
part-name = Pezzo o elemento

probe-position = Posizione di tastatura
centre-x = Centro X
centre-y = Centro Y
height-z = Altezza Z
first-contact = Primo contatto
clearance = Dist. di sicurezza
centre-tolerance = Tolleranza centro ±
simulated-workpiece = Pezzo in lavorazione simulato
simulated-hint = Senza diametro vale il centro della zona di tolleranza. Il seme aumenta dopo ogni misura; lo stesso seme dà gli stessi punti di contatto.
true-diameter = Diametro effettivo
seed = Seme
offset-x = Spostamento X
offset-y = Spostamento Y
ovality = Ovalità
lobes = Lobi
lobe-height = Altezza dei lobi
surface-scatter = Dispersione superficie 1σ
probe-scatter = Dispersione tastatore 1σ

field-range = { $given } è fuori da −{ $limit } … { $limit }
field-not-negative = { $given } è minore di 0: è ammesso da 0 a { $limit }
field-above-zero = { $given } non è maggiore di 0: è ammesso fino a { $limit }
field-not-whole = { $given } non è un numero intero

limit-band = Banda dei limiti
band-example = un esempio: { $callout }, un foro
band-empty = La banda dei limiti appare con i limiti
band-describe = Scostamento dalla quota nominale in micrometri: zona di tolleranza da { $lower } a { $upper }, { $left } al di sotto, { $right } al di sopra.
band-describe-measured = Misurato { $deviation }, { $above } sopra il minimo, { $below } sotto il massimo.
side-rework = ripresa
side-scrap = scarto
side-out = fuori limite

last-values = Ultimi valori
last-values-empty = Qui appaiono gli ultimi valori con questi limiti
last-values-describe = { $count ->
    [one] L'ultimo valore, il più recente in fondo:
   *[other] Gli ultimi { $count } valori, il più recente in fondo:
}
contacts = Punti di contatto
contacts-factor = scostamenti × { $factor }
contacts-empty = I punti di contatto appaiono con la misura
contacts-describe = { $count } punti di contatto visti dall'alto, scostamenti ingranditi { $factor } volte. { $circle }
centre-is = centro { $x } / { $y }

word-none = Nessun esito
nothing-measured = Non è stato misurato nulla
judged-without-own = Valutato senza le tabelle proprie
word-question = È corretto?
simulated = SIMULATO
status-simulated = { simulated } { $status }
judge-anyway = Valutare { $measured } mm così com'è
take-meant = Usare { $meant } mm
take-text = Usare { $meant }
keep-text = Usare { $given } così com'è
doubted-enter = Invio usa il pulsante evidenziato; digitando si sostituisce il testo
doubted-type = Nulla viene valutato finché il testo non è digitato di nuovo o usato così com'è
question-enter = Dopo mezzo secondo, Invio preme il pulsante pieno; digitando si sostituisce il valore
doubt-sentence = Il { $doubt }
lot-title = { $rows ->
    [one] { $name }: 1 riga
   *[other] { $name }: { $rows } righe
}
lot-unjudged = { $count } non valutate
lot-refused = { $count ->
    [one] 1 riga rifiutata
   *[other] { $count } righe rifiutate
}
lot-doubted = { $count ->
    [one] 1 valore dubbio
   *[other] { $count } valori dubbi
}
lot-shown = Mostrato: { $place } di { $judged }, peggiori prima; linea { $line }
lot-shown-part = Mostrato: { $place } di { $judged }, peggiori prima; linea { $line }, pezzo { $part }
lot-worst = Il peggiore
lot-worse = Peggiore
lot-better = Migliore
lot-best = Il migliore
lot-count = { $status } { $count }
above-minimum = { $um } µm sopra il minimo
below-minimum = { $um } µm sotto il minimo
below-maximum = { $um } µm sotto il massimo
above-maximum = { $um } µm sopra il massimo
remove-amount = Asportare { $um } µm
remove-to-limit = fino al limite
remove-to-limit-per-side = fino al limite, { $um } µm per lato
remove-to-middle = { $um } µm fino al centro zona
position-in = Centro in posizione
position-out = Centro fuori posizione
diameter-alone = Solo il diametro: { $status }
first-steps = Primi passi
first-steps-title = Primo avvio
first-steps-about = Queste impostazioni vengono conservate.
first-steps-done = Fatto
first-way-part = Un pezzo intero
first-way-part-about = Elemento per elemento, secondo un piano con immagine.
first-way-file = Un file di valori
first-way-file-about = CSV, una cartella di lavoro, QIF, AQDEF o un protocollo di misura.
first-way-program = Senza macchina
first-way-program-about = Un programma NC o un ciclo misura un foro simulato, contatto per contatto.
first-step-callout = 1. Indicazione: ciò che dice il disegno
first-step-value = 2. Valore misurato: digitato, simulato o da un file
first-step-verdict = 3. Esito, e quanto asportare
why = Perché?
why-limits = Limiti da { $what }
why-measured = Valore misurato: { $what }
why-rule = Regola: { $what }
why-caveat = Limitazione di questa misura: { $what }

popup-title = Finestra di stato
popup-title-accepted = Finestra di stato: fuori dai limiti, accettato secondo la regola
popup-title-simulated = Finestra di stato, SIMULATO
popup-exact = La finestra arrotonda a quattro decimali. Valori esatti: { $values }
popup-empty = Ancora nessuna misura
copy = Copiare
mask-choice = Maschera
mask-choice-of-language = Lingua della finestra
mask-choice-own = Maschera propria…

history = Cronologia
history-count = { $count ->
    [0] nessun controllo
    [one] 1 controllo
   *[other] { $count } controlli
}
history-chosen = { $count } da esportare
history-hidden = di cui { $hidden } non in elenco
history-shown = { $shown } di { $count ->
    [one] 1 controllo
   *[other] { $count } controlli
}
history-exported-listed = { $count ->
    [0] Nessun controllo in elenco: nulla da esportare
    [one] Viene esportato l'unico controllo in elenco, su { $all }
   *[other] Vengono esportati i { $count } controlli in elenco, su { $all }
}
rows-exported = Vengono esportate le { $listed } righe in elenco di { $name }, nell'ordine dell'elenco
rows-export-not-yet = Le righe si possono esportare quando sono tutte valutate e in elenco
history-exported = { $count ->
    [0] Nulla da esportare
    [one] Viene esportato 1 controllo
   *[other] Vengono esportati tutti i { $count } controlli
}
history-cleared = { $count ->
    [one] 1 controllo rimosso dalla cronologia. Annullare (Ctrl+Z) lo riporta.
   *[other] { $count } controlli rimossi dalla cronologia. Annullare (Ctrl+Z) li riporta.
}
history-none-found = Nessun controllo corrisponde al filtro
history-filter = Filtro
history-filter-hint = Elenca i controlli che contengono queste parole: pezzo, indicazione, valore, data, stato o file
history-only-bad = Solo non buoni
history-only-bad-hint = Ripresa, da rimisurare e scarto
history-sort-hint = Ordina secondo questa colonna; premere di nuovo per invertire l'ordine, ancora una volta per avere prima i più recenti
history-ascending = { $column }, ordine crescente
history-descending = { $column }, ordine decrescente
history-list = Controlli della cronologia
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, selezionato per l'esportazione
history-move = Passare a un altro controllo
history-show = Mostrare il controllo
history-choose = Selezionare per l'esportazione
choose-all = Selezionare tutto l'elenco
copy-checks = Copiare per un foglio di calcolo
history-empty = Qui appaiono i controlli, prima i più recenti
head-time = Data e ora
head-part = Pezzo
head-callout = Indicazione
head-measured = Misurato
head-deviation = Scostamento
head-status = Stato
head-from = Provenienza
choose-check = Selezionare { $check } ({ $time }) per l'esportazione

dialog-import = Importare misure
dialog-mask = Maschera propria
dialog-tables = Cartella con tabelle proprie
dialog-export = Esportare
dialog-export-rows = Esportare le righe in elenco
dialog-export-status = Esportare la finestra di stato
file-path = File
folder-path = Cartella
dialog-open = Aprire
dialog-save = Salvare
dialog-browse = Sfogliare…
dialog-cancel = Annullare
dialog-busy = In corso…
dialog-no-path = Manca un percorso
dialog-no-status = Nessuna finestra di stato da salvare
dialog-browse-hint = Mostra la finestra dei file del sistema
dialog-up = Cartella superiore
dialog-home = Cartella home
dialog-all-files = Tutti i file
file-kind-measurements = Misure
file-kind-mask = Maschere
file-kind-own-tables = Cartelle di tabelle
file-kind-report = Rapporti
file-kind-rows = Righe
file-kind-status = Testo
file-kind-table = Tabelle
file-kind-contacts = Punti di contatto
file-kind-workpiece = Pezzi in lavorazione simulati
file-kind-probes = Tabelle di tastatura
file-kind-log = Protocolli di misura
file-kind-program = Programmi NC
file-kind-part = Pezzi simulati
file-kind-set = File per un controllo numerico
file-kind-tools = Tabelle utensili
file-kind-plan = Piani di misura
file-kind-picture = Immagini
file-kind-watched = Cartelle sorvegliate
file-kind-budget = Bilanci dell'incertezza
file-kind-chart = Carte di controllo
file-kind-readings = Letture
file-kind-study = Letture di uno strumento
dialog-move = Passare a un altro nome
dialog-recent-folders = Cartelle recenti
dialog-exists = { $name } esiste già. Sostituirlo?
dialog-exists-set = { $name } esiste già in questa cartella. Sostituirvi i file del set?
dialog-replace = Sostituire
dialog-keep = Conservare
dialog-nothing-picked = La finestra dei file del sistema non ha restituito alcun file. Sceglierne uno nell'elenco o digitare un percorso.
dialog-list = Cartella { $folder }
dialog-entries = File e cartelle
dialog-list-none = Nessuna cartella aperta: digitare un percorso
dialog-list-reading = Lettura della cartella…
dialog-list-empty = Nulla da scegliere in questa cartella
dialog-list-more = Sono elencati solo i primi { $most } nomi: digitare il nome di un altro
dialog-is-folder = Cartella
file-name-checks = controlli
open-written = Aprire
show-in-folder = Mostrare in cartella
launch-failed = impossibile aprire il file: { $reason }
recent-files = File recenti
forget-recent = Svuotare l'elenco
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] 1 nome non è mostrato
   *[other] { $count } nomi non sono mostrati
}
file-bytes = { $count } B
file-kilobytes = { $count } kB
file-megabytes = { $count } MB
notice = Messaggio
copied = { $lines ->
    [one] Copiato, una linea
   *[other] Copiato, { $lines } linee
    }
notice-problem = Errore
notice-more = { $count ->
    [one] Segue ancora 1 messaggio
   *[other] Seguono ancora { $count } messaggi
}
messages = Messaggi precedenti
messages-forget = Svuotare questo elenco
messages-count = { $count ->
    [one] 1 messaggio precedente
   *[other] { $count } messaggi precedenti
}
close = Chiudere
file-written = { $name } è stato scritto in { $folder }
file-written-here = { $name } è stato scritto
tables-loaded = { $count ->
    [one] Si usa 1 tabella da { $folder }
   *[other] Si usano { $count } tabelle da { $folder }
}
mask-loaded-with-warnings = { $name } è stato letto con avvisi
state-set-aside = Non è stato possibile leggere lo stato salvato. È conservato come { $path }, e la finestra parte con le impostazioni predefinite.
state-set-aside-now = Lo stato salvato non è più leggibile. È conservato come { $path }, e al suo posto viene salvato lo stato di questa finestra.
state-not-kept = Lo stato di questa finestra non viene salvato: { $reason }
import-contacts-not-judged = I punti di contatto in { $name } non sono stati valutati
import-notice = { $name }: { $good ->
    [0] nessun controllo
    [one] 1 controllo
   *[other] { $good } controlli
}, { $bad ->
    [0] nessuna riga rifiutata
    [one] 1 riga rifiutata
   *[other] { $bad } righe rifiutate
}
import-counted = { $file }. { $counts }
check-said-afterwards = indicato dopo il giudizio: { $as }
lot-open = { $count ->
    [one] Per un valore manca foro o albero:
   *[other] Per { $count } valori manca foro o albero:
}
check-all-holes = Tutti fori
check-all-shafts = Tutti alberi
check-judged-again = { $count ->
    [one] Un valore fuori dai limiti è stato rigiudicato: { $as }
   *[other] { $count } valori fuori dai limiti sono stati rigiudicati: { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Mostrare
notice-open-in = Aprire nella pagina { $page }
judge-unplanned = Aprire nella pagina Controllo
sample-not-recorded = Un esempio non viene registrato.
limits-own-first = Prima dalle tabelle proprie: { $names }
limits-own-stay = Le tabelle proprie hanno ancora la precedenza: { $names }. Con Menu, Limiti da, non vengono più usate.
measured-needs-value = Digitare il valore misurato
measured-needs-limits = Nessun limite per valutare: digitare prima un'indicazione

keypad = Tastierino
key = Tasto
key-blank = Spazio
key-decimal = Segno decimale
key-minus = Meno
edge-left = Bordo del riquadro sinistro: si sposta con i tasti freccia
edge-right = Bordo del riquadro destro: si sposta con i tasti freccia
edge-top = Bordo del riquadro superiore: si sposta con i tasti freccia
edge-bottom = Bordo del riquadro inferiore: si sposta con i tasti freccia
key-letters = Lettere
key-holes = Classi dei fori
key-shafts = Classi degli alberi
key-more-letters = Da M a X
key-signs = Y, Z e segni
key-figures = Cifre
key-shift = Maiuscole o minuscole
key-back = Cancellare l'ultimo carattere
key-clear = Svuotare
key-enter = Invio

## Table page
tables-choice = Tabella
tables-kind-shipped = integrata
tables-kind-own = propria
tables-kind-file = da un file
tables-kind-copy = copia
tables-kind-made = da ISO 286
tables-unsaved = non salvata
tables-open = Aprire…
tables-save = Salvare come
tables-redo = Ripristinare
tables-use = Usare per i limiti
tables-in-use = Usata per i limiti
tables-filter = Filtro
tables-filter-hint = Classi come H7 g6, lettere, gradi o una dimensione in mm
tables-shown = { $count ->
    [one] { $shown } di 1 classe
   *[other] { $shown } di { $count } classi
}
tables-only-differences = Solo differenze
tables-unmatched = nulla corrisponde a { $words }
tables-agrees = { $count ->
    [one] concorda con ISO 286 nella sua unica cella
   *[other] concorda con ISO 286 in tutte le { $count } celle
}
tables-differs = { $count ->
    [one] 1 cella su { $compared } differisce da ISO 286
   *[other] { $count } celle su { $compared } differiscono da ISO 286
}
tables-compared-nothing = nulla da confrontare con ISO 286
tables-own-classes = { $count ->
    [one] 1 classe propria
   *[other] { $count } classi proprie
}
tables-own-class = propria
tables-previous = Differenza precedente
tables-next = Differenza successiva
tables-not-saved = Le modifiche non sono salvate
tables-keys = I tasti freccia spostano, Invio modifica, Canc svuota, F8 va alla differenza successiva, Ctrl+F al filtro
tables-move = Passare a un'altra cella
tables-edit-cell = Modificare la cella
tables-grid = Scostamenti di { $name } in µm
tables-range-head = oltre – fino a, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = vuota
tables-cell = { $class }, oltre { $over } fino a { $to } mm, { $figures }
tables-cell-differs = { $class }, oltre { $over } fino a { $to } mm, { $figures }, differisce da ISO 286
tables-no-columns = La tabella non ha classi
tables-upper = Sup.
tables-lower = Inf.
tables-head-table = Tabella, µm
tables-head-standard = ISO 286
tables-head-by = diff.
tables-cell-agrees = Come in ISO 286
tables-cell-off = ISO 286 ha { $upper } / { $lower } µm; la tabella differisce di { $upper-by } / { $lower-by } µm
tables-more-differences = e altre { $count }
tables-cell-missing = Qui vuota; ISO 286 ha { $upper } / { $lower } µm
tables-cell-empty = Qui vuota, e non definita in ISO 286
tables-defined = In ISO 286 la classe è definita { $ranges }
tables-shipped-hint = Una tabella integrata non cambia mai: una modifica ne crea una copia e mostra la copia.
tables-set = Applicare
tables-take-standard = Usare ISO 286
tables-empty-cell = Svuotare
tables-remove-column = Rimuovere { $class }
tables-from-standard = Da ISO 286
tables-classes = Classi, come H7 K7 P9
tables-add-columns = Aggiungere alla tabella
tables-up-to = Dimensioni fino a
tables-make = Nuova tabella
tables-order = scostamento superiore { $upper } µm sotto lo scostamento inferiore { $lower } µm
tables-used-edited = { $name } dà i limiti: da ora i controlli usano la modifica
tables-used = I limiti vengono cercati prima in { $name }, fino alla chiusura della finestra. Per usarla anche dopo, salvarla nella cartella delle tabelle proprie.
tables-read-with-warnings = { $name } è stata letta con avvisi
tables-nothing-read = Il file non contiene alcuna tabella di scostamenti
tables-nothing-to-save = Nessuna tabella aperta
tables-cell-unreadable = I valori della cella selezionata non sono leggibili: correggerli prima
tables-too-many = Sono aperte { $count } tabelle con modifiche non salvate: salvarne prima una
tables-dialog-open = Aprire una tabella
tables-dialog-save = Salvare la tabella
## Fit page
fit-callout = Accoppiamento di foro e albero
fit-callout-hint = Digitare una quota nominale e le due classi, ad esempio 25 H7/g6
fit-example = un esempio: { $callout }
fit-shaft-missing = Manca la classe dell'albero, ad esempio g6 in 25 H7/g6
fit-hole-missing = Manca la classe del foro, ad esempio H7 in 25 H7/g6
fit-classes-missing = Un accoppiamento ha le classi di foro e albero, ad esempio 25 H7/g6
fit-preferred = Accopp. preferenziale
fit-function = Funzione
fit-list-hole-basis = Foro base
fit-list-shaft-basis = Albero base
fit-parts = Pezzi reali
fit-hole-measured = Foro misurato
fit-shaft-measured = Albero misurato
fit-temperature = Temperatura
fit-hole-material = Materiale foro
fit-hole-expansion = Foro, µm/(m K)
fit-shaft-material = Materiale albero
fit-shaft-expansion = Albero, µm/(m K)
fit-own-value = Valore proprio
fit-press = Accoppiamento forzato
fit-press-length = Lunghezza di contatto
fit-hub-outer = Esterno mozzo
fit-shaft-bore = Foro albero
fit-press-material = Un accoppiamento forzato richiede un materiale dell'elenco per entrambi i pezzi: sceglierne uno
fit-press-pressure = Pressione di contatto
fit-press-force = Tiene assialmente
fit-press-torque = Tiene come coppia
fit-press-pressing = Forza di piantaggio
fit-press-hub = Mozzo: tensione / snervamento
fit-press-shaft = Albero: tensione / snervamento
fit-press-heat = Riscaldare il mozzo a
fit-press-cool = O raffreddare l'albero a
fit-press-friction = Attrito { $friction }; elastico, a 20 °C e da fermo. Forza assiale e coppia non valgono insieme
fit-search = Ricerca per gioco
fit-wanted-minimum = Minimo
fit-wanted-maximum = Massimo
fit-scope = Tra
fit-scope-all = Tutte le classi
fit-scope-basis = Foro base e albero base
fit-scope-preferred = Accopp. preferenziali e con nome
fit-search-hint = Il gioco minimo e il gioco massimo; un valore negativo è un'interferenza. Si può aggiungere un'unità: 7 µm
fit-search-size = Per la ricerca serve una quota nominale: digitarla sopra
fit-found = { $count ->
    [one] 1 accoppiamento
   *[other] { $count } accoppiamenti
}
fit-found-first = in elenco i migliori { $count }
fit-found-none = Nessun accoppiamento corrisponde. Il più vicino
fit-missed-by = { $below } µm in meno, { $above } µm in più
fit-is-preferred = preferenziale

fit-picture = Zone di foro e albero
fit-picture-legend = µm dalla linea dello zero; scostamento fondamentale in grassetto
fit-picture-empty = Le zone di tolleranza appaiono con l'accoppiamento
fit-arrow-clearance = Gioco effettivo
fit-arrow-interference = Interferenza effettiva
fit-describe-zero = Linea dello zero a { $nominal } mm.
fit-describe-zone = { $part } { $class } da { $lower } a { $upper } µm.
fit-describe-fundamental = Scostamento fondamentale { $deviation } µm.
fit-describe-measured = { $part }: misurato a { $deviation } µm.
fit-classes = Classi a { $nominal } mm
fit-classes-none = Classi
fit-classes-empty = Le classi appaiono con una quota nominale
fit-classes-nowhere = Nessuna classe è definita per questa dimensione
fit-staircase = Zone di tolleranza del grado { $grade }

fit-word-clearance = Con gioco
fit-word-transition = Incerto
fit-word-interference = Con interferenza
fit-word-none = Ancora nessuno
fit-maximum-clearance = Gioco massimo
fit-minimum-clearance = Gioco minimo
fit-maximum-interference = Interferenza massima
fit-minimum-interference = Interferenza minima
fit-mean-clearance = Gioco medio
fit-mean-interference = Interferenza media
fit-ansi = ANSI B4.2: { $name }
fit-equivalent = Accopp. equivalente
fit-equivalent-same = Esattamente gli stessi giochi
fit-equivalent-differs = Non gli stessi: gioco minimo { $minimum } µm, massimo { $maximum } µm
fit-check-hole = Controllare il foro
fit-check-shaft = Controllare l'albero
fit-move = Passare a un'altra classe
fit-actual-clearance = Gioco { $um } µm
fit-actual-interference = Interferenza { $um } µm
fit-conforms = Entro i limiti dell'indicazione
fit-conforms-not = Fuori dai limiti dell'indicazione
fit-with-good-shaft = Gioco con un albero buono
fit-with-good-hole = Gioco con un foro buono
fit-at-temperature = A { $degrees } °C
fit-temperature-change = il gioco varia di { $um } µm
fit-these-parts = Questi pezzi: { $clearance }

## Own materials
materials-refused = Impossibile usare i materiali propri: { $path }, { $reason }

## Palette
section-said = { $name }: { $value }
crash-report = La finestra si è chiusa per un errore del programma. Un resoconto, senza valori misurati, è in { $path }
rail-more = Altro
top-open = { $name }: aperto
top-undo = Annullare l'ultima modifica
top-recorded = Registrato, { $number }
top-recording = In registrazione
top-not-recorded = Non registrato
palette = Cercare o eseguire
palette-do = Eseguire
palette-open = Aprire
palette-settings = Impostazioni e guida
palette-records = Registro
palette-fit = Accoppiamento { $fit }
palette-in-tables = { $what } nelle tabelle
palette-uncertainty = Incertezza a { $size } mm
palette-records-of = Registrazioni di { $what }
palette-show-setting = Mostrare nella pagina Impostazioni
palette-more = Altre possibilità
palette-back = Tornare ai risultati
palette-check-value = Controllare { $callout } con { $value }
palette-check = Controllare { $callout }
palette-search-manual = Cercare «{ $query }» nel manuale
palette-nothing = Nulla ha questo nome
palette-hint = Un'indicazione, una pagina, un comando o un file

## Leaving
leave = Chiudere Fitcheck?
discard = Scartare le modifiche?
discard-unsaved = { $name } contiene modifiche non salvate.
discard-no = Continuare a modificare
discard-yes = Scartare le modifiche
leave-unsaved = Non salvato: { $names }
leave-stay = Continuare
leave-anyway = Chiudere senza salvare

## Cycle pictures
cycle-picture-centre-1 = centro nominale nel primo asse
cycle-picture-centre-2 = centro nominale nel secondo asse
cycle-picture-centre-tolerance-1 = scostamento ammesso del centro nel primo asse, nei due versi; 0 non sorveglia nulla
cycle-picture-centre-tolerance-2 = scostamento ammesso del centro nel secondo asse, nei due versi; 0 non sorveglia nulla
cycle-picture-side-length-1 = lunghezza nominale del rettangolo lungo il primo asse
cycle-picture-side-length-2 = lunghezza nominale del rettangolo lungo il secondo asse
cycle-picture-maximum-side-1 = lunghezza massima ammessa lungo il primo asse
cycle-picture-maximum-side-2 = lunghezza massima ammessa lungo il secondo asse
cycle-picture-minimum-side-1 = lunghezza minima ammessa lungo il primo asse
cycle-picture-minimum-side-2 = lunghezza minima ammessa lungo il secondo asse
cycle-picture-width = larghezza nominale, da parete a parete
cycle-picture-maximum-width = larghezza massima ammessa
cycle-picture-minimum-width = larghezza minima ammessa
cycle-picture-start-1 = punto nella scanalatura da cui parte il sistema di tastatura, primo asse
cycle-picture-start-2 = punto nella scanalatura da cui parte il sistema di tastatura, secondo asse
cycle-picture-shift = spostamento del secondo contatto lungo le pareti; con 0 è di fronte al primo
cycle-picture-first-point-1 = primo punto, sulla parete del lato positivo: primo asse
cycle-picture-first-point-2 = primo punto, sulla parete del lato positivo: secondo asse
cycle-picture-second-point-1 = secondo punto, sulla parete del lato negativo: primo asse
cycle-picture-second-point-2 = secondo punto, sulla parete del lato negativo: secondo asse
cycle-picture-axis-of-plane = asse misurato: 1 primo asse, 2 secondo asse
cycle-picture-diameter = diametro nominale
cycle-picture-maximum-size = diametro massimo ammesso
cycle-picture-minimum-size = diametro minimo ammesso
cycle-picture-start-diameter = diametro del cerchio su cui sta il sistema di tastatura prima di ogni contatto
cycle-picture-first-angle = angolo del primo contatto, dal primo asse
cycle-picture-step = angolo da contatto a contatto; negativo gira in senso orario
cycle-picture-arc = angolo su cui sono distribuiti i contatti; 360 è un giro completo, negativo gira in senso orario
cycle-picture-longest-path = corsa di tastatura massima; positiva si allontana dal centro, negativa vi si avvicina
cycle-picture-difference = ogni contatto viene tastato due volte: differenza massima ammessa
cycle-picture-measuring-height = altezza del centro della sfera al contatto
cycle-picture-set-up-clearance = distanza prima del contatto, sommata a SET_UP della tabella di tastatura
cycle-picture-clearance-height = altezza a cui il sistema di tastatura si muove liberamente
cycle-picture-point-1 = punto da tastare, primo asse
cycle-picture-point-2 = punto da tastare, secondo asse
cycle-picture-point-3 = punto da tastare, terzo asse
cycle-picture-next-point-1 = secondo punto della retta, primo asse
cycle-picture-next-point-2 = secondo punto della retta, secondo asse
cycle-picture-next-point-3 = secondo punto della retta, terzo asse
cycle-picture-second-centre-1 = centro nominale del secondo cerchio, primo asse
cycle-picture-second-centre-2 = centro nominale del secondo cerchio, secondo asse
cycle-picture-second-diameter = diametro nominale del secondo cerchio
cycle-picture-second-height = altezza alla quale si tasta il secondo cerchio
cycle-picture-geometries = 0 due fori, 1 due perni, 2 un foro e un perno, 3 un perno e un foro
cycle-picture-maximum-coordinate = coordinata massima ammessa
cycle-picture-minimum-coordinate = coordinata minima ammessa
cycle-picture-normal-1 = componente della normale alla superficie nel primo asse; la normale è rivolta verso l'esterno del materiale
cycle-picture-normal-2 = componente della normale alla superficie nel secondo asse; la normale è rivolta verso l'esterno del materiale
cycle-picture-normal-3 = componente della normale alla superficie nel terzo asse; la normale è rivolta verso l'esterno del materiale
cycle-picture-band = scostamento ammesso lungo la normale: sovrametallo positivo, sottomisura negativa
cycle-picture-retract = corsa di ritorno dal contatto, contro la direzione di tastatura
cycle-picture-move-to-clearance = percorso tra i contatti: 0 all'altezza di misura, 1 all'altezza di sicurezza
cycle-picture-clearance-mode = altezza di sicurezza: −1 mai, 0 prima e dopo il ciclo, 1 prima e dopo ogni oggetto, 2 a ogni contatto
cycle-picture-traverse = percorso al contatto successivo: 0 retta, 1 arco
cycle-picture-contact-count = numero di contatti
cycle-picture-plane = piano del cerchio: 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 tasta all'interno, 1 all'esterno
cycle-picture-measured-axis = asse misurato: 1 primo asse, 2 secondo asse, 3 asse di tastatura
cycle-picture-direction = direzione di tastatura: −1 contro l'asse, +1 lungo l'asse
cycle-picture-directed-axis = asse misurato, 1 primo, 2 secondo, 3 asse di tastatura; negativo tasta in senso contrario
cycle-picture-tool-axis-probing = asse di tastatura: 0 resta com'è, 1 viene anche tastato e impostato
cycle-picture-tool-axis-point-1 = dove si tasta l'asse di tastatura, primo asse
cycle-picture-tool-axis-point-2 = dove si tasta l'asse di tastatura, secondo asse
cycle-picture-tool-axis-point-3 = dove si attende la superficie nell'asse di tastatura
cycle-picture-new-datum-1 = coordinata che il punto misurato riceve nel primo asse
cycle-picture-new-datum-2 = coordinata che il punto misurato riceve nel secondo asse
cycle-picture-new-datum-3 = coordinata che il punto misurato riceve nell'asse di tastatura
cycle-picture-new-coordinate = coordinata che il punto misurato riceve nell'asse misurato
cycle-picture-table-row = riga della tabella in cui va l'origine; con 0 è subito attiva
cycle-picture-transfer = tabella: −1 non indicata, 0 punti zero, 1 origini
cycle-picture-preset-correction = 0 lascia l’origine attiva com’è; un altro numero la corregge, così che questo punto mostri il suo valore nominale
cycle-picture-aligned-angle = angolo a cui si allinea lo spigolo, dal primo asse; 0 lo allinea con l’asse
cycle-picture-compensation-axis = asse rotativo che allinea lo spigolo: 0 quello attorno al quale si è misurato l’angolo, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = l’asse rotativo dopo l’allineamento: 0 mantiene il suo valore, 1 indica zero
cycle-picture-rotary-alignment = gli assi rotativi dopo la misura: 0 restano fermi, un altro numero li ruota, così che la retta sia allineata
cycle-picture-rotation-transfer = l’angolo misurato: 0 non cambia nulla, 1 diventa la rotazione base, 2 uno scostamento dell’asse rotativo
cycle-picture-log = protocollo di misura: 0 nessuno, 1 file, 2 sullo schermo e il programma si arresta
cycle-picture-stop = fuori tolleranza: 0 il programma prosegue, 1 si arresta con un messaggio
cycle-picture-stop-on-undersize = fuori tolleranza: 0 il programma prosegue, 1 si arresta, 2 si arresta solo per sottomisura
cycle-picture-stop-on-scrap = fuori tolleranza: 0 il programma prosegue, 1 si arresta, 2 si arresta solo per uno scarto
cycle-picture-tool = utensile da controllare, con numero o nome; 0 nessuno
cycle-picture-any-length = { $name } Una lunghezza
cycle-picture-any-angle = { $name } Un angolo
cycle-picture-any-choice = { $name } Uno tra { $of }
cycle-picture-any-number = { $name } Un numero
cycle-picture-part = Pezzo con { $count ->
    [one] un elemento
   *[other] { $count } elementi
  }: { $names }.
cycle-picture-path = Percorso del tastatore, { $step } di { $moves } spostamenti eseguiti, { $contacts ->
    [one] 1 contatto
   *[other] { $contacts } contatti
}. Sfera a X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, contatto { $touch }
cycle-picture-no-path = Il percorso appare dopo l'esecuzione del ciclo
cycle-picture-phase-pre-position = preposizionamento
cycle-picture-phase-approach = avvicinamento
cycle-picture-phase-contact = contatto
cycle-picture-phase-retract = ritorno
cycle-picture-phase-leave = disimpegno
cycle-picture-from-above = { $first }/{ $second } dall'alto
cycle-picture-from-side = { $first }/{ $second } di lato
cycle-picture-contacts = { $count } contatti attorno al loro cerchio ai minimi quadrati Ø { $diameter } mm, { $factor }: { $residuals }.
cycle-picture-nominal = Cerchio nominale Ø { $diameter } mm.
cycle-picture-legend-fitted = minimi quadrati
cycle-picture-legend-nominal = nominale
cycle-picture-deviation = scostamento lungo la normale { $deviation } mm, senza tolleranza
cycle-picture-no-limits = Nessun limite indicato: nulla è stato confrontato
cycle-picture-head-criterion = Criterio
cycle-picture-head-centre-1 = Centro, 1° asse
cycle-picture-head-centre-2 = Centro, 2° asse
cycle-picture-head-diameter = Ø in mm
cycle-picture-head-form = Forma
cycle-picture-none = —
cycle-picture-least-squares = Minimi quadrati
cycle-picture-circumscribed = Minimo circoscritto
cycle-picture-inscribed = Massimo inscritto
cycle-picture-zone = Zona minima, rotondità
cycle-picture-two-point = Dimensione tra due punti
cycle-picture-two-point-of = Dimensione tra due punti { $first }–{ $second }
cycle-picture-two-point-least = Minima tra due punti, { $first }–{ $second }
cycle-picture-two-point-most = Massima tra due punti, { $first }–{ $second }
cycle-picture-no-opposed = nessuna coppia di contatti opposti
cycle-picture-uncertainty = La dispersione s di un contatto dà { $diameter } s nel diametro, { $against } volte quella di 3 contatti a 120°, e da { $across } s a { $along } s nel centro

# Lo stato salvato, e la finestra stessa
saved-broken = lo stato salvato non è leggibile: { $reason }
saved-newer = lo stato salvato ha la versione { $version }, questo programma supporta versioni fino alla { $known }
window-no-display = nessuno schermo: DISPLAY e WAYLAND_DISPLAY non sono impostati. Accedere a un desktop, collegarsi con ssh -X, o usare la riga di comando, che non richiede schermo: fitcheck check "25 H7" --measured 25.012; vedere fitcheck --help
open-unknown = { $name } non è un file che la finestra apre; apre misure, protocolli di misura e punti di contatto (.csv, .tsv, .txt, .html), programmi NC (.h), tabelle (.tab), tabelle utensili (.t), pezzi in lavorazione simulati (.toml), tabelle di tastatura (.tp) e maschere (.a)
window-not-opened = impossibile aprire la finestra: { $reason }; la riga di comando funziona senza schermo, vedere fitcheck --help

## Rows of a large file

rows = Righe
rows-cancel = Interrompere
rows-again = Valutare di nuovo
rows-close = Chiudere il file
rows-close-hint = Chiude il file grande; le sue righe non vengono conservate
rows-move = Passare a un'altra riga
rows-show = Mostrare il controllo della riga
rows-keep = Aggiungere alla cronologia
rows-kept = Il controllo è stato aggiunto alla cronologia
rows-progress = Parte letta del file
rows-running = { $count } righe finora, { $percent } % del file, { $rate } righe al secondo
rows-done = { $count } righe, tutte valutate in { $seconds }
rows-seconds = { $seconds } s
rows-less-than = meno di { $seconds } s
rows-cancelled = INCOMPLETO: interrotto dopo { $count } righe, { $percent } % del file
rows-failed = INCOMPLETO dopo { $count } righe: { $why }
rows-why-bytes = { $size } MiB, più di { $limit } MiB: valutato riga per riga, e le righe non vengono conservate nella cronologia
rows-why-packed = Compresso: valutato riga per riga, e le righe non vengono conservate nella cronologia; il testo decompresso è in un file temporaneo fino alla chiusura del file
rows-not-judged = NON VALUTATO
rows-fate = { $fate } { $count }
rows-fate-hint = Elenca queste righe; se ne possono scegliere più d'una
rows-classes = Classi
rows-all-classes = Tutte le classi
rows-no-class = Senza classe
rows-some-classes = { $count } classi
rows-class = { $class }: { $count }
rows-summary = Riepilogo
rows-fate-only = Elencare le righe { $fate } del file grande
rows-filter-hint = Elenca le righe che contengono queste parole nelle celle, come pezzo, indicazione, valore o stato
rows-worst-first = Peggiori prima
rows-worst-first-hint = Elenca scarto prima di ripresa e buono, con lo scostamento maggiore dai limiti in testa
rows-worst = Pezzo peggiore
rows-sifting = Ricerca tra le righe…
rows-sifts-at-end = Filtro e ordine valgono quando tutte le righe sono valutate
rows-in-order = peggiori prima
rows-worst-of-many = le { $most } peggiori di queste, peggiori prima
rows-first-of-many = le prime { $most } di queste
rows-export = Righe del file come { $format }, con esiti…
rows-export-programs = Controlli delle righe in elenco come { $format }…
rows-export-simulated = Le prime linee del file dicono che è simulato, e solo CSV può conservarle. Esportare come CSV
rows-export-twice = Il file ha due colonne di nome { $column }. Esportare come CSV o TSV, che le ammettono entrambe
rows-report-counts = { $name }: { $count } righe; { $good } BUONO, { $rework } RIPRESA, { $remeasure } RIMISURARE, { $out } FUORI LIMITE, { $scrap } SCARTO, { $unjudged } NON VALUTATO; { $listed } di queste in elenco in questo rapporto
rows-report-without = { $count ->
    [one] 1 riga in elenco non ha esito né controllo in questo rapporto
   *[other] { $count } righe in elenco non hanno esito né controllo in questo rapporto
}
rows-file-name = { $name }-valutato
rows-not-whole = INCOMPLETO: i conteggi non sono quelli dell'intero file
rows-listed = { $listed } di { $count } righe in elenco
rows-refused = { $count ->
    [one] 1 riga non valutata
   *[other] { $number } righe non valutate
}
rows-doubted = { $count ->
    [one] 1 valore è forse un'altra grandezza o di un altro pezzo
   *[other] { $number } valori sono forse un'altra grandezza o di un altro pezzo
}
rows-simulated = { $count ->
    [one] 1 riga dice che nessuno ha misurato
   *[other] { $number } righe dicono che nessuno ha misurato
}
rows-status-differs = { $count ->
    [one] 1 riga ha nel file uno stato diverso
   *[other] { $number } righe hanno nel file uno stato diverso
}
rows-status-unknown = { $count ->
    [one] 1 riga ha nel file uno stato sconosciuto
   *[other] { $number } righe hanno nel file uno stato sconosciuto
}
rows-claim-differs = { $count ->
    [one] 1 limite, scostamento o tipo di elemento contraddice la propria riga
   *[other] { $number } limiti, scostamenti o tipi di elementi contraddicono le proprie righe
}
rows-several-lines = { $count ->
    [one] 1 riga occupa più linee
   *[other] { $number } righe occupano più linee
}
rows-not-utf8 = { $count ->
    [one] 1 linea non è UTF-8 ed è stata letta come Windows-1252
   *[other] { $number } linee non sono UTF-8 e sono state lette come Windows-1252
}
rows-comments = { $count ->
    [one] 1 commento non è una riga
   *[other] { $number } commenti non sono righe
}
rows-note = Linea { $line }: { $what }
rows-first-notes = I primi { $first } di { $count }:
rows-line = Linea { $line } di { $name }
rows-row-line = linea { $line }
rows-list = Righe del file
rows-none = Nessuna riga corrisponde al filtro
rows-none-yet = Ancora nessuna riga
rows-head-line = Linea
rows-head-what = Da fare
rows-changed = il file è cambiato dopo la valutazione; valutarlo di nuovo
rows-unread = impossibile rileggere le righe: { $reason }
rows-no-copy = impossibile conservare il testo decompresso: { $reason }
rows-too-much = il testo decompresso supera { $most } GiB
rows-panicked = un errore interno ha terminato la valutazione

## A file that is read or written
working = In corso
working-reading = Lettura di { $name }: { $rows } righe, { $done } di { $all } MB, { $rate } righe al secondo
working-reading-bytes = Lettura di { $name }: { $done } di { $all } MB, { $seconds } s
working-writing = Scrittura di { $name }: { $done } MB, { $seconds } s
working-progress = Avanzamento della lettura
working-stop = Interrompere
working-stopped = Interrotto dopo { $rows } righe: nulla è stato importato da { $name }

## What a code reader typed into the field of the value
scanned-callout = { $given } è un'indicazione di tolleranza ed è stata presa come tale
scanned-serial = { $given } non è un valore: è stato preso come numero di serie dei prossimi controlli
