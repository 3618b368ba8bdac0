# Das Fenster: Beschriftungen, Schaltflächen, Überschriften.

page-check = Prüfung
page-fit = Passungen
page-tables = Tabellen
import = Importieren…
export = Exportieren
export-people = Prüfbericht ({ $format })…
export-programs = Verlauf als { $format }…
export-status-check = Statusfenster der Prüfung als Text…
export-status-cycle = Statusfenster von Zyklus { $cycle } als Text…
export-status-program = Fenster des Programms als Text…
menu = Menü
language = Sprache
theme = Darstellung
theme-system = Wie das System
theme-light = Hell
theme-dark = Dunkel
theme-contrast = Hoher Kontrast auf Weiß
theme-inverted = Hoher Kontrast auf Schwarz
density = Größe der Bedienelemente
density-by-use = Automatisch
density-mouse = Maus
density-touch = Touch
limits-from = Grenzmaße aus
standard-js-rounded = Halbe Mikrometer bei JS abrunden, wie 1988
standard-1988 = cd, ef, fg nur bis 10 mm, wie 1988
load-tables = Eigene Tabellen…
no-own-tables = Eigene Tabellen nicht mehr verwenden
load-mask = Eigene Maske…
undo = Rückgängig
undo-what = Rückgängig: { $what }
undo-add = { $count ->
    [one] 1 Prüfung hinzufügen
   *[other] { $count } Prüfungen hinzufügen
}
undo-correct = Berichtigung
undo-feature = Bohrung oder Welle
undo-clear = Verlauf leeren
undone = Rückgängig gemacht: { $what }
clear-history = Verlauf leeren
choose-bad = { $count ->
    [0] Nicht gute Prüfungen auswählen
    [one] 1 nicht gute Prüfung auswählen
   *[other] { $count } nicht gute Prüfungen auswählen
}
choose-none = Nichts auswählen

callout = Toleranzangabe
callout-hint = Nennmaß und Klasse eingeben, zum Beispiel 25 H7
feature-hole = Bohrung
feature-shaft = Welle
feature-neither = Keins von beiden
nominal-is = Nennmaß { $nominal } mm
maximum = Höchstmaß
minimum = Mindestmaß
from-source = Quelle: { $source }
source-overrides = Eigene Tabelle: ISO 286 hat { $upper } / { $lower } µm, der Unterschied beträgt { $by-upper } / { $by-lower } µm
measured-value = Messwert
measured-once = Schon beurteilt. Um denselben Wert noch einmal zu beurteilen, neu eingeben oder die Schaltfläche benutzen
by-typing = Eingeben
by-simulating = Simulieren
judge = Beurteilen
measure = Messen
clear = Leeren
nominal-size = Nennmaß
tolerance-class = Klasse
class-none = Auswählen
classes-hole = Klassen für Bohrungen
classes-shaft = Klassen für Wellen
part-section = Teil
part-name = Teil oder Merkmal

probe-position = Antastposition
centre-x = Mitte X
centre-y = Mitte Y
height-z = Höhe Z
first-contact = Erster Antastpunkt
clearance = Sicherheitsabstand
centre-tolerance = Toleranz Mitte ±
simulated-workpiece = Simuliertes Werkstück
simulated-hint = Ohne Durchmesser gilt die Mitte des Toleranzfelds. Der Startwert zählt nach jeder Messung hoch; derselbe Startwert ergibt dieselben Antastpunkte.
true-diameter = Wahrer Durchmesser
seed = Startwert
offset-x = Versatz X
offset-y = Versatz Y
ovality = Ovalität
lobes = Eckenzahl
lobe-height = Eckenhöhe
surface-scatter = Streuung Oberfläche 1σ
probe-scatter = Streuung Tastsystem 1σ

field-range = { $given } liegt außerhalb von −{ $limit } bis { $limit }
field-not-negative = { $given } ist kleiner als 0: zulässig ist 0 bis { $limit }
field-above-zero = { $given } ist nicht größer als 0: zulässig ist bis { $limit }
field-not-whole = { $given } ist keine ganze Zahl

limit-band = Toleranzband
band-example = ein Beispiel: { $callout }, eine Bohrung
band-empty = Das Toleranzband erscheint mit den Grenzmaßen
band-describe = Abweichung vom Nennmaß in Mikrometern: Toleranzfeld von { $lower } bis { $upper }, { $left } darunter, { $right } darüber.
band-describe-measured = Gemessen { $deviation }, { $above } über dem Mindestmaß, { $below } unter dem Höchstmaß.
side-rework = Nacharbeit
side-scrap = Ausschuss
side-out = außer Toleranz

last-values = Letzte Werte
last-values-empty = Hier erscheinen die letzten Werte zu diesen Grenzmaßen
last-values-describe = { $count ->
    [one] Der letzte Wert, neuester zuletzt:
   *[other] Die letzten { $count } Werte, neuester zuletzt:
}
contacts = Antastpunkte
contacts-factor = Abweichungen × { $factor }
contacts-empty = Die Antastpunkte erscheinen mit der Messung
contacts-describe = { $count } Antastpunkte von oben gesehen, Abweichungen { $factor }-fach vergrößert. { $circle }
centre-is = Mitte { $x } / { $y }

word-none = Kein Ergebnis
nothing-measured = Nichts wurde gemessen
judged-without-own = Ohne die eigenen Tabellen beurteilt
word-question = Stimmt das?
simulated = SIMULIERT
status-simulated = { simulated } { $status }
judge-anyway = { $measured } mm trotzdem beurteilen
take-meant = { $meant } mm verwenden
take-text = { $meant } verwenden
keep-text = { $given } trotzdem so verwenden
doubted-enter = Enter benutzt die hervorgehobene Schaltfläche; Tippen ersetzt den Text
doubted-type = Nichts wird beurteilt, bis der Text neu eingegeben oder so verwendet wird
question-enter = Nach einer halben Sekunde drückt Enter die ausgefüllte Schaltfläche; Tippen ersetzt den Wert
doubt-sentence = Der { $doubt }
lot-title = { $rows ->
    [one] { $name }: 1 Zeile
   *[other] { $name }: { $rows } Zeilen
}
lot-unjudged = { $count } nicht beurteilt
lot-refused = { $count ->
    [one] 1 Zeile abgewiesen
   *[other] { $count } Zeilen abgewiesen
}
lot-doubted = { $count ->
    [one] 1 zweifelhafter Wert
   *[other] { $count } zweifelhafte Werte
}
lot-shown = Angezeigt: { $place } von { $judged }, schlechteste zuerst; Textzeile { $line }
lot-shown-part = Angezeigt: { $place } von { $judged }, schlechteste zuerst; Textzeile { $line }, Teil { $part }
lot-worst = Schlechteste
lot-worse = Schlechtere
lot-better = Bessere
lot-best = Beste
lot-count = { $status } { $count }
above-minimum = { $um } µm über Mindestmaß
below-minimum = { $um } µm unter Mindestmaß
below-maximum = { $um } µm unter Höchstmaß
above-maximum = { $um } µm über Höchstmaß
remove-amount = { $um } µm abnehmen
remove-to-limit = bis zum Grenzmaß
remove-to-limit-per-side = bis zum Grenzmaß, { $um } µm je Seite
remove-to-middle = { $um } µm bis zur Toleranzmitte
position-in = Mitte in Toleranz
position-out = Mitte außer Toleranz
diameter-alone = Nur der Durchmesser: { $status }
first-steps = Erste Schritte
first-steps-title = Zum ersten Mal hier?
first-steps-about = Diese Einstellungen bleiben gespeichert.
first-steps-done = Fertig
first-way-part = Ein ganzes Teil
first-way-part-about = Merkmal für Merkmal, nach einem Plan mit Bild.
first-way-file = Eine Datei mit Messwerten
first-way-file-about = CSV, eine Arbeitsmappe, QIF, AQDEF oder ein Messprotokoll.
first-way-program = Ohne Maschine
first-way-program-about = Ein NC-Programm oder ein Zyklus misst eine simulierte Bohrung, Antastpunkt für Antastpunkt.
first-step-callout = 1. Toleranzangabe: was die Zeichnung sagt
first-step-value = 2. Messwert: eingegeben, simuliert oder aus einer Datei
first-step-verdict = 3. Urteil, und wie viel noch abzunehmen ist
why = Warum?
why-limits = Grenzmaße aus: { $what }
why-measured = Messwert: { $what }
why-rule = Regel: { $what }
why-caveat = Einschränkung dieser Messung: { $what }

popup-title = Statusfenster
popup-title-accepted = Statusfenster: außerhalb der Grenzmaße, nach der Regel angenommen
popup-title-simulated = Statusfenster, SIMULIERT
popup-exact = Das Fenster rundet auf vier Nachkommastellen. Genaue Werte: { $values }
popup-empty = Noch keine Messung
copy = Kopieren
mask-choice = Maske
mask-choice-of-language = Sprache des Fensters
mask-choice-own = Eigene Maske…

history = Verlauf
history-count = { $count ->
    [0] keine Prüfungen
    [one] 1 Prüfung
   *[other] { $count } Prüfungen
}
history-chosen = { $count } zum Export ausgewählt
history-hidden = davon { $hidden } nicht angezeigt
history-shown = { $shown } von { $count ->
    [one] 1 Prüfung
   *[other] { $count } Prüfungen
}
history-exported-listed = { $count ->
    [0] Keine Prüfung angezeigt: nichts zu exportieren
    [one] Die eine angezeigte Prüfung von { $all } wird exportiert
   *[other] Die { $count } angezeigten Prüfungen von { $all } werden exportiert
}
rows-exported = Die { $listed } angezeigten Zeilen von { $name } werden exportiert, in der Reihenfolge der Liste
rows-export-not-yet = Die Zeilen können exportiert werden, sobald alle beurteilt und angezeigt sind
history-exported = { $count ->
    [0] Nichts zu exportieren
    [one] 1 Prüfung wird exportiert
   *[other] Alle { $count } Prüfungen werden exportiert
}
history-cleared = { $count ->
    [one] 1 Prüfung aus dem Verlauf entfernt. Rückgängig (Ctrl+Z) holt sie zurück.
   *[other] { $count } Prüfungen aus dem Verlauf entfernt. Rückgängig (Ctrl+Z) holt sie zurück.
}
history-none-found = Keine Prüfung passt zum Filter
history-filter = Filter
history-filter-hint = Zeigt die Prüfungen mit diesen Wörtern: Teil, Toleranzangabe, Wert, Datum, Status oder Datei
history-only-bad = Nur nicht gute
history-only-bad-hint = Nacharbeit, neu messen und Ausschuss
history-sort-hint = Sortiert nach dieser Spalte; noch einmal kehrt die Reihenfolge um, danach neueste zuerst
history-ascending = { $column }, aufsteigend sortiert
history-descending = { $column }, absteigend sortiert
history-list = Prüfungen im Verlauf
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, zum Export ausgewählt
history-move = Zu einer anderen Prüfung
history-show = Prüfung anzeigen
history-choose = Zum Export auswählen
choose-all = Alle angezeigten auswählen
copy-checks = Für eine Tabellenkalkulation kopieren
history-empty = Hier erscheinen die Prüfungen, die neueste zuerst
head-time = Datum und Zeit
head-part = Teil
head-callout = Tol.-Angabe
head-measured = Gemessen
head-deviation = Abweichung
head-status = Status
head-from = Herkunft
choose-check = { $check } von { $time } zum Export auswählen

dialog-import = Messungen importieren
dialog-mask = Eigene Maske
dialog-tables = Ordner mit eigenen Tabellen
dialog-export = Exportieren
dialog-export-rows = Angezeigte Zeilen exportieren
dialog-export-status = Statusfenster exportieren
file-path = Datei
folder-path = Ordner
dialog-open = Öffnen
dialog-save = Speichern
dialog-browse = Durchsuchen…
dialog-cancel = Abbrechen
dialog-busy = In Arbeit…
dialog-no-path = Ein Pfad fehlt
dialog-no-status = Kein Statusfenster zu speichern
dialog-browse-hint = Zeigt den Dateidialog des Systems
dialog-up = Übergeordneter Ordner
dialog-home = Persönlicher Ordner
dialog-all-files = Alle Dateien
file-kind-measurements = Messungen
file-kind-mask = Masken
file-kind-own-tables = Ordner mit Tabellen
file-kind-report = Prüfberichte
file-kind-rows = Zeilen
file-kind-status = Text
file-kind-table = Tabellen
file-kind-contacts = Antastpunkte
file-kind-workpiece = Simulierte Werkstücke
file-kind-probes = Tastsystemtabellen
file-kind-log = Messprotokolle
file-kind-program = NC-Programme
file-kind-part = Simulierte Teile
file-kind-set = Dateien für eine Steuerung
file-kind-tools = Werkzeugtabellen
file-kind-plan = Prüfpläne
file-kind-picture = Bilder
file-kind-watched = Überwachte Ordner
file-kind-budget = Unsicherheitsbudgets
file-kind-chart = Regelkarten
file-kind-readings = Einzelmesswerte
file-kind-study = Messungen eines Prüfmittels
dialog-move = Zu einem anderen Element
dialog-recent-folders = Letzte Ordner
dialog-exists = { $name } gibt es schon. Ersetzen?
dialog-exists-set = { $name } gibt es in diesem Ordner schon. Die Dateien des Dateisatzes dort ersetzen?
dialog-replace = Ersetzen
dialog-keep = Behalten
dialog-nothing-picked = Der Dateidialog des Systems hat keine Datei geliefert. Eine in der Liste auswählen oder einen Pfad eingeben.
dialog-list = Ordner { $folder }
dialog-entries = Dateien und Ordner
dialog-list-none = Kein Ordner geöffnet: einen Pfad eingeben
dialog-list-reading = Ordner wird gelesen…
dialog-list-empty = In diesem Ordner gibt es nichts auszuwählen
dialog-list-more = Nur die ersten { $most } Elemente werden angezeigt: den Namen eines anderen eingeben
dialog-is-folder = Ordner
file-name-checks = pruefungen
open-written = Öffnen
show-in-folder = Im Ordner zeigen
launch-failed = die Datei kann nicht geöffnet werden: { $reason }
recent-files = Letzte Dateien
forget-recent = Liste leeren
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] 1 Element wird nicht angezeigt
   *[other] { $count } Elemente werden nicht angezeigt
}
file-bytes = { $count } B
file-kilobytes = { $count } kB
file-megabytes = { $count } MB
notice = Meldung
copied = { $lines ->
    [one] Kopiert, eine Zeile
   *[other] Kopiert, { $lines } Zeilen
    }
notice-problem = Fehler
notice-more = { $count ->
    [one] 1 weitere Meldung folgt
   *[other] { $count } weitere Meldungen folgen
}
messages = Frühere Meldungen
messages-forget = Liste leeren
messages-count = { $count ->
    [one] 1 frühere Meldung
   *[other] { $count } frühere Meldungen
}
close = Schließen
file-written = { $name } wurde in { $folder } geschrieben
file-written-here = { $name } wurde geschrieben
tables-loaded = { $count ->
    [one] 1 Tabelle wird verwendet aus { $folder }
   *[other] { $count } Tabellen werden verwendet aus { $folder }
}
mask-loaded-with-warnings = { $name } wurde mit Warnungen gelesen
state-set-aside = Der gespeicherte Zustand war nicht lesbar. Er wurde als { $path } aufbewahrt, und das Fenster beginnt mit den Standardeinstellungen.
state-set-aside-now = Der gespeicherte Zustand ist nicht mehr lesbar. Er wurde als { $path } aufbewahrt, und der Zustand dieses Fensters wird an seiner Stelle gespeichert.
state-not-kept = Der Zustand dieses Fensters wird nicht gespeichert: { $reason }
import-contacts-not-judged = Die Antastpunkte in { $name } wurden nicht beurteilt
import-notice = { $name }: { $good ->
    [0] keine Prüfung
    [one] 1 Prüfung
   *[other] { $good } Prüfungen
}, { $bad ->
    [0] keine Zeile abgewiesen
    [one] 1 Zeile abgewiesen
   *[other] { $bad } Zeilen abgewiesen
}
import-counted = { $file }. { $counts }
check-said-afterwards = nach dem Urteil angegeben: { $as }
lot-open = { $count ->
    [one] Bei einem Wert fehlt Bohrung oder Welle:
   *[other] Bei { $count } Werten fehlt Bohrung oder Welle:
}
check-all-holes = Alle sind Bohrungen
check-all-shafts = Alle sind Wellen
check-judged-again = { $count ->
    [one] Ein Wert außerhalb seiner Grenzmaße wurde neu beurteilt: { $as }
   *[other] { $count } Werte außerhalb ihrer Grenzmaße wurden neu beurteilt: { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Anzeigen
notice-open-in = Öffnen auf Seite { $page }
judge-unplanned = Öffnen auf Seite Prüfung
sample-not-recorded = Ein Beispiel wird nicht aufgezeichnet.
limits-own-first = Zuerst aus eigenen Tabellen: { $names }
limits-own-stay = Eigene Tabellen gehen weiterhin vor: { $names }. Über Menü, Grenzmaße aus, werden sie nicht mehr verwendet.
measured-needs-value = Messwert eingeben
measured-needs-limits = Keine Grenzmaße zum Beurteilen: zuerst eine Toleranzangabe eingeben

keypad = Tastenfeld
key = Taste
key-blank = Leerzeichen
key-decimal = Dezimalzeichen
key-minus = Minus
edge-left = Rand des linken Bereichs: mit den Pfeiltasten verschieben
edge-right = Rand des rechten Bereichs: mit den Pfeiltasten verschieben
edge-top = Rand des oberen Bereichs: mit den Pfeiltasten verschieben
edge-bottom = Rand des unteren Bereichs: mit den Pfeiltasten verschieben
key-letters = Buchstaben
key-holes = Klassen für Bohrungen
key-shafts = Klassen für Wellen
key-more-letters = M bis X
key-signs = Y, Z und Zeichen
key-figures = Ziffern
key-shift = Groß- oder Kleinbuchstaben
key-back = Letztes Zeichen löschen
key-clear = Leeren
key-enter = Enter

## Seite Tabellen
tables-choice = Tabelle
tables-kind-shipped = mitgeliefert
tables-kind-own = eigen
tables-kind-file = aus Datei
tables-kind-copy = Kopie
tables-kind-made = aus ISO 286
tables-unsaved = nicht gespeichert
tables-open = Öffnen…
tables-save = Speichern unter
tables-redo = Wiederholen
tables-use = Für Grenzmaße verwenden
tables-in-use = Für Grenzmaße verwendet
tables-filter = Filter
tables-filter-hint = Klassen wie H7 g6, Buchstaben, Toleranzgrade oder ein Maß in mm
tables-shown = { $count ->
    [one] { $shown } von 1 Klasse
   *[other] { $shown } von { $count } Klassen
}
tables-only-differences = Nur Unterschiede
tables-unmatched = nichts gefunden zu { $words }
tables-agrees = { $count ->
    [one] die einzige Zelle stimmt mit ISO 286 überein
   *[other] alle { $count } Zellen stimmen mit ISO 286 überein
}
tables-differs = { $count ->
    [one] 1 von { $compared } Zellen weicht von ISO 286 ab
   *[other] { $count } von { $compared } Zellen weichen von ISO 286 ab
}
tables-compared-nothing = nichts mit ISO 286 zu vergleichen
tables-own-classes = { $count ->
    [one] 1 eigene Klasse
   *[other] { $count } eigene Klassen
}
tables-own-class = eigen
tables-previous = Voriger Unterschied
tables-next = Nächster Unterschied
tables-not-saved = Änderungen sind nicht gespeichert
tables-keys = Pfeiltasten bewegen, Enter ändert, Delete leert, F8 geht zum nächsten Unterschied, Ctrl+F zum Filter
tables-move = Zu einer anderen Zelle
tables-edit-cell = Zelle ändern
tables-grid = Grenzabmaße von { $name } in µm
tables-range-head = über – bis, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = leer
tables-cell = { $class }, über { $over } bis { $to } mm, { $figures }
tables-cell-differs = { $class }, über { $over } bis { $to } mm, { $figures }, weicht von ISO 286 ab
tables-no-columns = Die Tabelle hat keine Klasse
tables-upper = Oberes
tables-lower = Unteres
tables-head-table = Tabelle, µm
tables-head-standard = ISO 286
tables-head-by = Diff.
tables-cell-agrees = Wie in ISO 286
tables-cell-off = ISO 286 hat { $upper } / { $lower } µm; die Tabelle weicht um { $upper-by } / { $lower-by } µm ab
tables-more-differences = und { $count } weitere
tables-cell-missing = Hier leer; ISO 286 hat { $upper } / { $lower } µm
tables-cell-empty = Hier leer und in ISO 286 nicht definiert
tables-defined = In ISO 286 ist die Klasse { $ranges } definiert
tables-shipped-hint = Eine mitgelieferte Tabelle bleibt unverändert: eine Änderung legt eine Kopie an und zeigt sie.
tables-set = Eintragen
tables-take-standard = ISO 286 übernehmen
tables-empty-cell = Leeren
tables-remove-column = { $class } entfernen
tables-from-standard = Aus ISO 286
tables-classes = Klassen, wie H7 K7 P9
tables-add-columns = Dieser Tabelle hinzufügen
tables-up-to = Maße bis
tables-make = Neue Tabelle
tables-order = oberes Grenzabmaß { $upper } µm liegt unter dem unteren Grenzabmaß { $lower } µm
tables-used-edited = { $name } liefert die Grenzmaße: Prüfungen verwenden ab jetzt die Änderung
tables-used = Grenzmaße kommen zuerst aus { $name }, bis das Fenster geschlossen wird. Zur weiteren Verwendung im Ordner der eigenen Tabellen speichern.
tables-read-with-warnings = { $name } wurde mit Warnungen gelesen
tables-nothing-read = Die Datei enthält keine Tabelle mit Grenzabmaßen
tables-nothing-to-save = Keine Tabelle geöffnet
tables-cell-unreadable = Die Werte der gewählten Zelle sind nicht lesbar: zuerst berichtigen
tables-too-many = { $count } Tabellen mit nicht gespeicherten Änderungen sind geöffnet: zuerst eine speichern
tables-dialog-open = Tabelle öffnen
tables-dialog-save = Tabelle speichern
## Seite Passungen
fit-callout = Passung von Bohrung und Welle
fit-callout-hint = Nennmaß und beide Klassen eingeben, zum Beispiel 25 H7/g6
fit-example = ein Beispiel: { $callout }
fit-shaft-missing = Die Klasse der Welle fehlt, zum Beispiel g6 in 25 H7/g6
fit-hole-missing = Die Klasse der Bohrung fehlt, zum Beispiel H7 in 25 H7/g6
fit-classes-missing = Eine Passung hat die Klassen von Bohrung und Welle, zum Beispiel 25 H7/g6
fit-preferred = Vorzugspassung
fit-function = Funktion
fit-list-hole-basis = Einheitsbohrung
fit-list-shaft-basis = Einheitswelle
fit-parts = Gemessene Teile
fit-hole-measured = Gemess. Bohrung
fit-shaft-measured = Gemess. Welle
fit-temperature = Temperatur
fit-hole-material = Werkstoff Bohrung
fit-hole-expansion = Bohrung, µm/(m K)
fit-shaft-material = Werkstoff Welle
fit-shaft-expansion = Welle, µm/(m K)
fit-own-value = Eigener Wert
fit-press = Pressverband
fit-press-length = Fugenlänge
fit-hub-outer = Nabe außen
fit-shaft-bore = Wellenbohrung
fit-press-material = Ein Pressverband braucht für beide Teile einen Werkstoff der Liste: wählen Sie einen
fit-press-pressure = Fugendruck
fit-press-force = Hält axial
fit-press-torque = Hält als Drehmoment
fit-press-pressing = Einpresskraft
fit-press-hub = Nabe: Spannung / Streckgrenze
fit-press-shaft = Welle: Spannung / Streckgrenze
fit-press-heat = Nabe erwärmen auf
fit-press-cool = Oder Welle kühlen auf
fit-press-friction = Reibung { $friction }; elastisch, bei 20 °C und in Ruhe. Axialkraft und Drehmoment gelten nicht zugleich
fit-search = Nach Spiel suchen
fit-wanted-minimum = Minimum
fit-wanted-maximum = Maximum
fit-scope = In
fit-scope-all = Alle Klassen
fit-scope-basis = Einheitsbohrung und Einheitswelle
fit-scope-preferred = Vorzugs- und benannte Passungen
fit-search-hint = Kleinstes und größtes Spiel; ein negativer Wert ist ein Übermaß. Eine Einheit ist möglich: 7 µm
fit-search-size = Zum Suchen ist ein Nennmaß nötig: oben eingeben
fit-found = { $count ->
    [one] 1 Passung
   *[other] { $count } Passungen
}
fit-found-first = die besten { $count } werden angezeigt
fit-found-none = Keine Passung erfüllt das. Die nächstliegende
fit-missed-by = { $below } µm zu wenig, { $above } µm zu viel
fit-is-preferred = Vorzug

fit-picture = Toleranzfelder von Bohrung und Welle
fit-picture-legend = µm ab der Nulllinie; Grundabmaß fett
fit-picture-empty = Die Toleranzfelder erscheinen mit der Passung
fit-arrow-clearance = Ist-Spiel
fit-arrow-interference = Ist-Übermaß
fit-describe-zero = Nulllinie bei { $nominal } mm.
fit-describe-zone = { $part } { $class } von { $lower } bis { $upper } µm.
fit-describe-fundamental = Grundabmaß { $deviation } µm.
fit-describe-measured = { $part } gemessen bei { $deviation } µm.
fit-classes = Klassen bei { $nominal } mm
fit-classes-none = Klassen
fit-classes-empty = Die Klassen erscheinen mit einem Nennmaß
fit-classes-nowhere = Bei diesem Maß ist keine Klasse definiert
fit-staircase = Toleranzfelder bei Toleranzgrad { $grade }

fit-word-clearance = Spielpassung
fit-word-transition = Übergangspassung
fit-word-interference = Übermaßpassung
fit-word-none = Noch keine Passung
fit-maximum-clearance = Höchstspiel
fit-minimum-clearance = Mindestspiel
fit-maximum-interference = Höchstübermaß
fit-minimum-interference = Mindestübermaß
fit-mean-clearance = Mittleres Spiel
fit-mean-interference = Mittleres Übermaß
fit-ansi = ANSI B4.2: { $name }
fit-equivalent = Gleichwertige Passung
fit-equivalent-same = Genau dasselbe Spiel
fit-equivalent-differs = Nicht dasselbe: kleinstes Spiel { $minimum } µm, größtes { $maximum } µm
fit-check-hole = Bohrung prüfen
fit-check-shaft = Welle prüfen
fit-move = Zu einer anderen Klasse
fit-actual-clearance = Spiel { $um } µm
fit-actual-interference = Übermaß { $um } µm
fit-conforms = Innerhalb der Grenzmaße der Toleranzangabe
fit-conforms-not = Außerhalb der Grenzmaße der Toleranzangabe
fit-with-good-shaft = Spiel mit einer guten Welle
fit-with-good-hole = Spiel mit einer guten Bohrung
fit-at-temperature = Bei { $degrees } °C
fit-temperature-change = das Spiel ändert sich um { $um } µm
fit-these-parts = Diese Teile: { $clearance }

## Eigene Werkstoffe
materials-refused = Eigene Werkstoffe können nicht verwendet werden: { $path }, { $reason }

## Palette
section-said = { $name }: { $value }
crash-report = Das Fenster wurde durch einen Fehler im Programm beendet. Ein Fehlerbericht ohne Messwerte steht in { $path }
rail-more = Mehr
top-open = { $name } ist geöffnet
top-undo = Letzte Änderung rückgängig machen
top-recorded = Aufgezeichnet, { $number }
top-recording = Wird aufgezeichnet
top-not-recorded = Nicht aufgezeichnet
palette = Suchen oder ausführen
palette-do = Ausführen
palette-open = Öffnen
palette-settings = Einstellungen und Hilfe
palette-records = Journal
palette-fit = Passung { $fit }
palette-in-tables = { $what } in den Tabellen
palette-uncertainty = Unsicherheit bei { $size } mm
palette-records-of = { $what } im Journal
palette-show-setting = Auf der Seite Einstellungen zeigen
palette-more = Was sonst noch damit möglich ist
palette-back = Zurück zu den Treffern
palette-check-value = { $callout } prüfen mit { $value }
palette-check = { $callout } prüfen
palette-search-manual = Im Handbuch nach „{ $query }“ suchen
palette-nothing = Nichts heißt so
palette-hint = Eine Toleranzangabe, eine Seite, ein Befehl oder eine Datei

## Beenden
leave = Fitcheck schließen?
discard = Änderungen verwerfen?
discard-unsaved = { $name } hat nicht gespeicherte Änderungen.
discard-no = Weiter bearbeiten
discard-yes = Änderungen verwerfen
leave-unsaved = Nicht gespeichert: { $names }
leave-stay = Weiterarbeiten
leave-anyway = Ohne Speichern schließen

## Bilder der Zyklen
cycle-picture-centre-1 = Sollmitte in der ersten Achse
cycle-picture-centre-2 = Sollmitte in der zweiten Achse
cycle-picture-centre-tolerance-1 = zulässige Abweichung der Mitte in der ersten Achse, nach beiden Seiten; 0 überwacht nichts
cycle-picture-centre-tolerance-2 = zulässige Abweichung der Mitte in der zweiten Achse, nach beiden Seiten; 0 überwacht nichts
cycle-picture-side-length-1 = Solllänge des Rechtecks entlang der ersten Achse
cycle-picture-side-length-2 = Solllänge des Rechtecks entlang der zweiten Achse
cycle-picture-maximum-side-1 = größte zulässige Länge entlang der ersten Achse
cycle-picture-maximum-side-2 = größte zulässige Länge entlang der zweiten Achse
cycle-picture-minimum-side-1 = kleinste zulässige Länge entlang der ersten Achse
cycle-picture-minimum-side-2 = kleinste zulässige Länge entlang der zweiten Achse
cycle-picture-width = Sollbreite, von Wand zu Wand
cycle-picture-maximum-width = größte zulässige Breite
cycle-picture-minimum-width = kleinste zulässige Breite
cycle-picture-start-1 = Punkt in der Nut, an dem das Tastsystem startet, erste Achse
cycle-picture-start-2 = Punkt in der Nut, an dem das Tastsystem startet, zweite Achse
cycle-picture-shift = Versatz des zweiten Antastpunkts entlang der Wände; bei 0 liegt er dem ersten gegenüber
cycle-picture-first-point-1 = erster Punkt, an der Wand auf der Plusseite: erste Achse
cycle-picture-first-point-2 = erster Punkt, an der Wand auf der Plusseite: zweite Achse
cycle-picture-second-point-1 = zweiter Punkt, an der Wand auf der Minusseite: erste Achse
cycle-picture-second-point-2 = zweiter Punkt, an der Wand auf der Minusseite: zweite Achse
cycle-picture-axis-of-plane = Messachse: 1 erste Achse, 2 zweite Achse
cycle-picture-diameter = Solldurchmesser
cycle-picture-maximum-size = größter zulässiger Durchmesser
cycle-picture-minimum-size = kleinster zulässiger Durchmesser
cycle-picture-start-diameter = Durchmesser des Kreises, auf dem das Tastsystem vor jedem Antastvorgang steht
cycle-picture-first-angle = Winkel des ersten Antastpunkts, gemessen ab der ersten Achse
cycle-picture-step = Winkel von Antastpunkt zu Antastpunkt; minus dreht im Uhrzeigersinn
cycle-picture-arc = Winkel, über den die Antastpunkte verteilt sind; 360 ist ein voller Kreis, minus dreht im Uhrzeigersinn
cycle-picture-longest-path = größter Antastweg; plus führt von der Mitte weg, minus zu ihr hin
cycle-picture-difference = jeder Antastpunkt wird zweimal angetastet: größter zulässiger Unterschied
cycle-picture-measuring-height = Höhe der Kugelmitte am Antastpunkt
cycle-picture-set-up-clearance = Abstand vor dem Antastpunkt, addiert zu SET_UP der Tastsystemtabelle
cycle-picture-clearance-height = Höhe, auf der sich das Tastsystem frei bewegt
cycle-picture-point-1 = anzutastender Punkt, erste Achse
cycle-picture-point-2 = anzutastender Punkt, zweite Achse
cycle-picture-point-3 = anzutastender Punkt, dritte Achse
cycle-picture-next-point-1 = zweiter Punkt der Geraden, erste Achse
cycle-picture-next-point-2 = zweiter Punkt der Geraden, zweite Achse
cycle-picture-next-point-3 = zweiter Punkt der Geraden, dritte Achse
cycle-picture-second-centre-1 = Sollmitte des zweiten Kreises, erste Achse
cycle-picture-second-centre-2 = Sollmitte des zweiten Kreises, zweite Achse
cycle-picture-second-diameter = Solldurchmesser des zweiten Kreises
cycle-picture-second-height = Höhe, in der der zweite Kreis angetastet wird
cycle-picture-geometries = 0 zwei Bohrungen, 1 zwei Zapfen, 2 Bohrung und Zapfen, 3 Zapfen und Bohrung
cycle-picture-maximum-coordinate = größte zulässige Koordinate
cycle-picture-minimum-coordinate = kleinste zulässige Koordinate
cycle-picture-normal-1 = Komponente der Flächennormalen in der ersten Achse; die Normale zeigt aus dem Material heraus
cycle-picture-normal-2 = Komponente der Flächennormalen in der zweiten Achse; die Normale zeigt aus dem Material heraus
cycle-picture-normal-3 = Komponente der Flächennormalen in der dritten Achse; die Normale zeigt aus dem Material heraus
cycle-picture-band = zulässige Abweichung entlang der Normalen: Aufmaß plus, Untermaß minus
cycle-picture-retract = Weg zurück vom Antastpunkt, entgegen der Antastrichtung
cycle-picture-move-to-clearance = Weg zwischen Antastpunkten: 0 auf Messhöhe, 1 über die sichere Höhe
cycle-picture-clearance-mode = sichere Höhe: −1 nie, 0 vor und nach dem Zyklus, 1 vor und nach jedem Objekt, 2 bei jedem Antastpunkt
cycle-picture-traverse = Weg zum nächsten Antastpunkt: 0 Gerade, 1 Kreisbogen
cycle-picture-contact-count = Anzahl der Antastpunkte
cycle-picture-plane = Ebene des Kreises: 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 tastet innen an, 1 außen
cycle-picture-measured-axis = Messachse: 1 erste Achse, 2 zweite Achse, 3 Tastsystemachse
cycle-picture-direction = Antastrichtung: −1 gegen die Achse, +1 mit der Achse
cycle-picture-directed-axis = gemessene Achse, 1 erste, 2 zweite, 3 Tastsystemachse; minus tastet entgegen der Achse an
cycle-picture-tool-axis-probing = Tastsystemachse: 0 bleibt, wie sie ist, 1 wird auch angetastet und gesetzt
cycle-picture-tool-axis-point-1 = wo die Tastsystemachse angetastet wird, erste Achse
cycle-picture-tool-axis-point-2 = wo die Tastsystemachse angetastet wird, zweite Achse
cycle-picture-tool-axis-point-3 = wo die Fläche in der Tastsystemachse erwartet wird
cycle-picture-new-datum-1 = Koordinate, die die gemessene Stelle in der ersten Achse erhält
cycle-picture-new-datum-2 = Koordinate, die die gemessene Stelle in der zweiten Achse erhält
cycle-picture-new-datum-3 = Koordinate, die die gemessene Stelle in der Tastsystemachse erhält
cycle-picture-new-coordinate = Koordinate, die die gemessene Stelle in der gemessenen Achse erhält
cycle-picture-table-row = Zeile der Tabelle, in die der Bezugspunkt kommt; bei 0 ist er sofort aktiv
cycle-picture-transfer = Tabelle: −1 nicht angegeben, 0 Nullpunkttabelle, 1 Bezugspunkttabelle
cycle-picture-preset-correction = 0 lässt den aktiven Bezugspunkt, wie er ist; eine andere Zahl korrigiert ihn, sodass dieser Punkt seinen Sollwert zeigt
cycle-picture-aligned-angle = Winkel, auf den die Kante ausgerichtet wird, ab der ersten Achse; 0 richtet sie nach der Achse aus
cycle-picture-compensation-axis = Drehachse, die die Kante ausrichtet: 0 die, um die der Winkel gemessen wurde, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = die Drehachse nach dem Ausrichten: 0 behält ihren Wert, 1 zeigt null
cycle-picture-rotary-alignment = die Drehachsen nach dem Messen: 0 bleiben stehen, eine andere Zahl dreht sie, sodass die Gerade ausgerichtet ist
cycle-picture-rotation-transfer = der gemessene Winkel: 0 ändert nichts, 1 wird Grunddrehung, 2 Versatz der Drehachse
cycle-picture-log = Messprotokoll: 0 keines, 1 Datei, 2 am Bildschirm, und das Programm hält an
cycle-picture-stop = außer Toleranz: 0 das Programm läuft weiter, 1 es hält mit einer Meldung an
cycle-picture-stop-on-undersize = außer Toleranz: 0 das Programm läuft weiter, 1 es hält an, 2 es hält nur bei Untermaß an
cycle-picture-stop-on-scrap = außer Toleranz: 0 das Programm läuft weiter, 1 es hält an, 2 es hält nur bei Ausschuss an
cycle-picture-tool = zu überwachendes Werkzeug, mit Nummer oder Name; 0 ist keines
cycle-picture-any-length = { $name } Eine Länge
cycle-picture-any-angle = { $name } Ein Winkel
cycle-picture-any-choice = { $name } Eines von { $of }
cycle-picture-any-number = { $name } Eine Zahl
cycle-picture-part = Teil mit { $count ->
    [one] einem Merkmal
   *[other] { $count } Merkmalen
  }: { $names }.
cycle-picture-path = Bahn des Tastsystems, { $step } von { $moves } Bewegungen ausgeführt, { $contacts ->
    [one] 1 Antastpunkt
   *[other] { $contacts } Antastpunkte
}. Kugel auf X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, Antastpunkt { $touch }
cycle-picture-no-path = Die Bahn erscheint, wenn der Zyklus gelaufen ist
cycle-picture-phase-pre-position = vorpositionieren
cycle-picture-phase-approach = anfahren
cycle-picture-phase-contact = antasten
cycle-picture-phase-retract = zurückziehen
cycle-picture-phase-leave = freifahren
cycle-picture-from-above = { $first }/{ $second } von oben
cycle-picture-from-side = { $first }/{ $second } von der Seite
cycle-picture-contacts = { $count } Antastpunkte um ihren Ausgleichskreis Ø { $diameter } mm, { $factor }: { $residuals }.
cycle-picture-nominal = Sollkreis Ø { $diameter } mm.
cycle-picture-legend-fitted = Ausgleichskreis
cycle-picture-legend-nominal = Sollkreis
cycle-picture-deviation = Abweichung entlang der Normalen { $deviation } mm, ohne Toleranz
cycle-picture-no-limits = Keine Grenzmaße angegeben: nichts wurde verglichen
cycle-picture-head-criterion = Kriterium
cycle-picture-head-centre-1 = Mitte, 1. Achse
cycle-picture-head-centre-2 = Mitte, 2. Achse
cycle-picture-head-diameter = Ø in mm
cycle-picture-head-form = Form
cycle-picture-none = —
cycle-picture-least-squares = Ausgleichskreis
cycle-picture-circumscribed = Kleinster Hüllkreis
cycle-picture-inscribed = Größter Pferchkreis
cycle-picture-zone = Kleinste Ringzone, Rundheit
cycle-picture-two-point = Zweipunktmaß
cycle-picture-two-point-of = Zweipunktmaß { $first }–{ $second }
cycle-picture-two-point-least = Kleinstes Zweipunktmaß, { $first }–{ $second }
cycle-picture-two-point-most = Größtes Zweipunktmaß, { $first }–{ $second }
cycle-picture-no-opposed = keine zwei Antastpunkte liegen einander gegenüber
cycle-picture-uncertainty = Die Streuung s eines Antastpunkts ergibt { $diameter } s im Durchmesser, { $against }-mal so viel wie bei 3 Antastpunkten im Abstand von 120°, und { $across } s bis { $along } s in der Mitte

# Der gespeicherte Zustand, und das Fenster selbst
saved-broken = der gespeicherte Zustand ist nicht lesbar: { $reason }
saved-newer = der gespeicherte Zustand hat Version { $version }, dieses Programm unterstützt Versionen bis { $known }
window-no-display = kein Bildschirm: DISPLAY und WAYLAND_DISPLAY sind nicht gesetzt. An einem Desktop anmelden, mit ssh -X verbinden oder die Befehlszeile benutzen, die keinen Bildschirm braucht: fitcheck check "25 H7" --measured 25.012; siehe fitcheck --help
open-unknown = { $name } ist keine Datei, die das Fenster öffnet; es öffnet Messungen, Messprotokolle und Antastpunkte (.csv, .tsv, .txt, .html), NC-Programme (.h), Tabellen (.tab), Werkzeugtabellen (.t), simulierte Werkstücke (.toml), Tastsystemtabellen (.tp) und Masken (.a)
window-not-opened = das Fenster kann nicht geöffnet werden: { $reason }; die Befehlszeile arbeitet ohne Bildschirm, siehe fitcheck --help

## Zeilen einer großen Datei

rows = Zeilen
rows-cancel = Abbrechen
rows-again = Neu beurteilen
rows-close = Datei schließen
rows-close-hint = Schließt die große Datei; ihre Zeilen bleiben nicht erhalten
rows-move = Zu einer anderen Zeile
rows-show = Prüfung der Zeile anzeigen
rows-keep = Zum Verlauf hinzufügen
rows-kept = Die Prüfung wurde zum Verlauf hinzugefügt
rows-progress = Gelesener Anteil der Datei
rows-running = { $count } Zeilen bisher, { $percent } % der Datei, { $rate } Zeilen pro Sekunde
rows-done = { $count } Zeilen, alle beurteilt in { $seconds }
rows-seconds = { $seconds } s
rows-less-than = weniger als { $seconds } s
rows-cancelled = UNVOLLSTÄNDIG: abgebrochen nach { $count } Zeilen, { $percent } % der Datei
rows-failed = UNVOLLSTÄNDIG nach { $count } Zeilen: { $why }
rows-why-bytes = { $size } MiB, mehr als { $limit } MiB: Zeile für Zeile beurteilt, und die Zeilen bleiben nicht im Verlauf
rows-why-packed = Komprimiert: Zeile für Zeile beurteilt, und die Zeilen bleiben nicht im Verlauf; der entpackte Text liegt in einer temporären Datei, bis die Datei geschlossen wird
rows-not-judged = NICHT BEURTEILT
rows-fate = { $fate } { $count }
rows-fate-hint = Zeigt diese Zeilen an; mehrere sind wählbar
rows-classes = Klassen
rows-all-classes = Alle Klassen
rows-no-class = Ohne Klasse
rows-some-classes = { $count } Klassen
rows-class = { $class }: { $count }
rows-summary = Übersicht
rows-fate-only = Große Datei: Zeilen { $fate } anzeigen
rows-filter-hint = Zeigt die Zeilen mit diesen Wörtern in ihren Zellen, wie Teil, Toleranzangabe, Wert oder Status
rows-worst-first = Schlechteste zuerst
rows-worst-first-hint = Zeigt Ausschuss vor Nacharbeit und gut, mit der größten Abweichung von den Grenzmaßen zuerst
rows-worst = Schlechtestes Teil
rows-sifting = Zeilen werden durchsucht…
rows-sifts-at-end = Filter und Reihenfolge gelten, sobald alle Zeilen beurteilt sind
rows-in-order = schlechteste zuerst
rows-worst-of-many = die { $most } schlechtesten davon, schlechteste zuerst
rows-first-of-many = die ersten { $most } davon
rows-export = Zeilen der Datei als { $format }, mit Urteil…
rows-export-programs = Prüfungen der angezeigten Zeilen als { $format }…
rows-export-simulated = Die ersten Textzeilen der Datei sagen, dass sie simuliert ist, und nur CSV kann sie behalten. Als CSV exportieren
rows-export-twice = Die Datei hat zwei Spalten mit dem Namen { $column }. Als CSV oder TSV exportieren, dort sind beide möglich
rows-report-counts = { $name }: { $count } Zeilen; { $good } GUT, { $rework } NACHARBEIT, { $remeasure } NEU MESSEN, { $out } AUSSER TOLERANZ, { $scrap } AUSSCHUSS, { $unjudged } NICHT BEURTEILT; davon { $listed } in diesem Prüfbericht
rows-report-without = { $count ->
    [one] 1 angezeigte Zeile hat kein Urteil und keine Prüfung in diesem Prüfbericht
   *[other] { $count } angezeigte Zeilen haben kein Urteil und keine Prüfung in diesem Prüfbericht
}
rows-file-name = { $name }-beurteilt
rows-not-whole = UNVOLLSTÄNDIG: die Anzahlen sind nicht die der ganzen Datei
rows-listed = { $listed } von { $count } Zeilen angezeigt
rows-refused = { $count ->
    [one] 1 Zeile nicht beurteilt
   *[other] { $number } Zeilen nicht beurteilt
}
rows-doubted = { $count ->
    [one] 1 Wert ist vielleicht eine andere Größe oder gehört zu einem anderen Teil
   *[other] { $number } Werte sind vielleicht eine andere Größe oder gehören zu einem anderen Teil
}
rows-simulated = { $count ->
    [one] 1 Zeile sagt, dass niemand gemessen hat
   *[other] { $number } Zeilen sagen, dass niemand gemessen hat
}
rows-status-differs = { $count ->
    [one] 1 Zeile hat in ihrer Datei einen anderen Status
   *[other] { $number } Zeilen haben in ihrer Datei einen anderen Status
}
rows-status-unknown = { $count ->
    [one] 1 Zeile hat in ihrer Datei einen unbekannten Status
   *[other] { $number } Zeilen haben in ihrer Datei einen unbekannten Status
}
rows-claim-differs = { $count ->
    [one] 1 Grenzmaß, Abweichung oder Merkmalsart widerspricht der eigenen Zeile
   *[other] { $number } Grenzmaße, Abweichungen oder Merkmalsarten widersprechen ihren Zeilen
}
rows-several-lines = { $count ->
    [one] 1 Zeile geht über mehrere Textzeilen
   *[other] { $number } Zeilen gehen über mehrere Textzeilen
}
rows-not-utf8 = { $count ->
    [one] 1 Textzeile ist nicht UTF-8 und wurde als Windows-1252 gelesen
   *[other] { $number } Textzeilen sind nicht UTF-8 und wurden als Windows-1252 gelesen
}
rows-comments = { $count ->
    [one] 1 Kommentar ist keine Zeile
   *[other] { $number } Kommentare sind keine Zeilen
}
rows-note = Textzeile { $line }: { $what }
rows-first-notes = Die ersten { $first } von { $count }:
rows-line = Textzeile { $line } von { $name }
rows-row-line = Textzeile { $line }
rows-list = Zeilen der Datei
rows-none = Keine Zeile passt zum Filter
rows-none-yet = Noch keine Zeile
rows-head-line = Textz.
rows-head-what = Zu tun
rows-changed = die Datei hat sich seit dem Beurteilen geändert; neu beurteilen
rows-unread = die Zeilen können nicht noch einmal gelesen werden: { $reason }
rows-no-copy = der entpackte Text kann nicht aufbewahrt werden: { $reason }
rows-too-much = der entpackte Text ist größer als { $most } GiB
rows-panicked = ein interner Fehler hat den Lauf beendet

## Eine Datei, die gelesen oder geschrieben wird
working = In Arbeit
working-reading = { $name } lesen: { $rows } Zeilen, { $done } von { $all } MB, { $rate } Zeilen pro Sekunde
working-reading-bytes = { $name } lesen: { $done } von { $all } MB, { $seconds } s
working-writing = { $name } schreiben: { $done } MB, { $seconds } s
working-progress = Gelesener Anteil
working-stop = Anhalten
working-stopped = Angehalten nach { $rows } Zeilen: aus { $name } wurde nichts importiert

## What a code reader typed into the field of the value
scanned-callout = { $given } ist eine Toleranzangabe und wurde als solche übernommen
scanned-serial = { $given } ist kein Wert: es wurde als Seriennummer der nächsten Prüfungen übernommen
