# Die Seite Zyklen: das Formular eines Messzyklus, sein Werkstück, seine Bahn und seine Ergebnisse.

page-cycles = Zyklen

cycles-cycle = Zyklus
cycles-choose = Zyklus { $number } { $name }
cycles-group-position = Position
cycles-group-probing = Antasten
cycles-group-tolerance = Toleranz
cycles-group-output = Ausgabe
cycles-optional-position = Position, optional
cycles-optional-probing = Antasten, optional
cycles-optional-tolerance = Toleranz, optional
cycles-optional-output = Ausgabe, optional
cycles-contacts-from = Antastpunkte von
cycles-perfect = Ideales Teil
cycles-simulated = Simuliert
cycles-recorded = Aus Datei
cycles-workpiece = Werkstück…
cycles-suit = Werkstück an Zyklus anpassen
cycles-open-contacts = Antastpunkte…
cycles-no-file = noch keine Datei
cycles-contacts-of = { $count ->
    [one] { $count } Antastpunkt
   *[other] { $count } Antastpunkte
    }, { $file }
cycles-probe = Tastsystem
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Eigene Tastsystemtabelle…
cycles-shipped-probes = Mitgelieferte Tabelle
cycles-run = Ausführen
cycles-needed = erforderlich
cycles-none = keine
cycles-predef = PREDEF steht für
cycles-predef-missing = PREDEF: den Wert aus GLOBAL DEF eingeben
cycles-without-effect = Zulässig, ohne Wirkung
cycles-position = Kugelposition
cycles-ball-stands = Kugel steht auf
cycles-paste-block = NC-Satz einfügen…
cycles-copy-block = Als NC-Satz kopieren
cycles-copy-results = Ergebnisse kopieren
cycles-block-copied = Der NC-Satz wurde kopiert
cycles-block = NC-Satz
cycles-block-hint = Einen NC-Satz wie TCH PROBE 427 … Q263=+35 ;TEXT ~ oder G785 R0 BR0 K2 einfügen: er ersetzt das Formular
cycles-fill = Formular ausfüllen

cycles-nothing-seen = Bahn und Antastpunkte erscheinen nach einem Lauf: Enter oder F5 drücken
cycles-allowed = Zulässig: { $range } { $unit }
cycles-must-be-given = Erforderlich
cycles-may-be-left-out = Optional
cycles-default = { $value }, wenn das Feld leer bleibt
cycles-may-be-predef = PREDEF ist zulässig
cycles-path = Bahn der Kugel
cycles-first = Erste
cycles-back = Vorige
cycles-next = Nächste
cycles-last = Letzte
cycles-move = Bewegung
cycles-phase-pre-position = vorpositionieren
cycles-phase-approach = anfahren
cycles-phase-contact = antasten
cycles-phase-retract = zurückziehen
cycles-phase-leave = freifahren
cycles-move-contact = { $number } von { $count }: { $phase } { $touch }, bei { $to }
cycles-move-of-touch = { $number } von { $count }: { $phase }, Antastpunkt { $touch }, von { $from } nach { $to }
cycles-move-of-none = { $number } von { $count }: { $phase }, von { $from } nach { $to }
cycles-criteria = Kriterien nebeneinander

cycles-word-stopped = Nicht gemessen
cycles-word-no-verdict = Kein Urteil
cycles-no-limits = keine Grenzmaße angegeben
cycles-no-limits-marked = keine Grenzmaße angegeben; eine Steuerung meldet dann innerhalb der Toleranz
cycles-more-out = { $what }, { $count } weitere unten
cycles-no-window = Keine Grenzmaße: die Steuerung zeigt kein Statusfenster
cycles-results = Ergebnisparameter
cycles-log-file = Die Steuerung schreibt { $name }
cycles-log-screen = Die Steuerung hält an und zeigt das Messprotokoll am Bildschirm
cycles-log-shown = Die Steuerung zeigt das Ergebnis am Bildschirm
cycles-save-log = Messprotokoll speichern…
cycles-dialog-save-log = Messprotokoll speichern
cycles-no-log = kein Messprotokoll zu speichern
cycles-from-perfect = An einem idealen Werkstück mit Nennmaß gemessen, mit einem Punkt als Tastsystem
cycles-from-simulated = Am simulierten Werkstück gemessen, Startwert { $seed }
cycles-from-recorded = Antastpunkte aus { $file }
cycles-unused = Der Zyklus hat { $count ->
    [one] einen Antastpunkt
   *[other] { $count } Antastpunkte
    } der Datei nicht verwendet

cycles-fields-wrong = { $count ->
    [one] ein Feld ist
   *[other] { $count } Felder sind
    } nicht verwendbar: siehe Formular
cycles-no-workpiece = das simulierte Werkstück ist nicht vollständig
cycles-workpiece-wrong = simuliertes Werkstück: { $problem }
cycles-workpiece-field = { $name }: { $problem }
cycles-no-contacts = noch keine Datei mit Antastpunkten geöffnet
cycles-cannot-suit = Noch kein passendes Werkstück: { $problem }
cycles-not-written = das Werkstück kann nicht geschrieben werden: { $reason }
cycles-contacts-loaded = Antastpunkte aus { $name } werden verwendet
cycles-column-ignored = Spalte { $column } ist übersprungen
cycles-probes-loaded = Tastsystemtabelle { $name } wird verwendet
cycles-dialog-contacts = Erfasste Antastpunkte öffnen
cycles-dialog-workpiece = Simuliertes Werkstück öffnen
cycles-dialog-probes = Tastsystemtabelle öffnen
cycles-dialog-save-workpiece = Simuliertes Werkstück speichern

cycles-open-workpiece = Öffnen…
cycles-save-workpiece = Speichern…
cycles-shape-bore = Bohrung
cycles-shape-stud = Welle
cycles-shape-face = Fläche
cycles-shape-point = Punkt auf Freiformfläche
cycles-shape-slot = Nut
cycles-shape-ridge = Steg
cycles-shape-pocket = Rechtecktasche
cycles-shape-boss = Rechteckzapfen
cycles-plane = Ebene
workpiece-probe = Tastsystem
workpiece-machine = Streuung und Temperatur
workpiece-centre-1 = Mitte, 1. Achse
workpiece-centre-2 = Mitte, 2. Achse
workpiece-ovality-angle = Winkel der Ovalität
workpiece-lobe-angle = Winkel der Ecken
workpiece-point-x = Punkt X
workpiece-point-y = Punkt Y
workpiece-point-z = Punkt Z
workpiece-normal-x = Normale X
workpiece-normal-y = Normale Y
workpiece-normal-z = Normale Z
workpiece-wave-height = Wellenamplitude
workpiece-wave-length = Wellenlänge
workpiece-wave-x = Wellenrichtung X
workpiece-wave-y = Wellenrichtung Y
workpiece-wave-z = Wellenrichtung Z
workpiece-deviation = Abweichung entlang der Normalen
workpiece-radius = Radius der Fläche
workpiece-width = Breite
workpiece-length-1 = 1. Länge
workpiece-length-2 = 2. Länge
workpiece-angle = Winkel der Wände
workpiece-ball = Kugelradius
workpiece-trigger = Schaltstreuung 1σ
workpiece-calibration = Kalibrierfehler
workpiece-offset-x = Versatz der Kugel X
workpiece-offset-y = Versatz der Kugel Y
workpiece-lobing-count = Ecken des Schaltwegs
workpiece-lobing = Amplitude des Schaltwegs
workpiece-lobing-angle = Winkel des Schaltwegs
workpiece-temperature = Werkstücktemperatur
workpiece-expansion = Ausdehnung

cycles-choice-move-to-clearance-0 = auf Messhöhe
cycles-choice-move-to-clearance-1 = auf sicherer Höhe
cycles-choice-clearance-mode-minus-1 = nie auf sichere Höhe
cycles-choice-clearance-mode-0 = vor und nach dem Zyklus
cycles-choice-clearance-mode-1 = vor und nach jedem Objekt
cycles-choice-clearance-mode-2 = bei jedem Antastpunkt
cycles-choice-traverse-0 = Gerade
cycles-choice-traverse-1 = Kreisbogen
cycles-choice-contact-count-3 = Antastpunkte
cycles-choice-contact-count-4 = Antastpunkte
cycles-choice-contact-count-5 = Antastpunkte
cycles-choice-contact-count-6 = Antastpunkte
cycles-choice-contact-count-7 = Antastpunkte
cycles-choice-contact-count-8 = Antastpunkte
cycles-choice-contact-count-9 = Antastpunkte
cycles-choice-log-0 = kein Messprotokoll
cycles-choice-log-1 = Messprotokoll in Datei
cycles-choice-log-2 = Stopp, Messprotokoll am Bildschirm
cycles-choice-stop-0 = kein Stopp
cycles-choice-stop-1 = Stopp, wenn außer Toleranz
cycles-choice-stop-on-undersize-0 = kein Stopp
cycles-choice-stop-on-undersize-1 = Stopp, wenn außer Toleranz
cycles-choice-stop-on-undersize-2 = Stopp nur bei Untermaß
cycles-choice-stop-on-scrap-0 = kein Stopp
cycles-choice-stop-on-scrap-1 = Stopp, wenn außer Toleranz
cycles-choice-stop-on-scrap-2 = Stopp nur bei Ausschuss
cycles-choice-measured-axis-1 = Hauptachse X
cycles-choice-measured-axis-2 = Nebenachse Y
cycles-choice-measured-axis-3 = Tastsystemachse Z
cycles-choice-axis-of-plane-1 = Hauptachse X
cycles-choice-axis-of-plane-2 = Nebenachse Y
cycles-choice-direction-minus-1 = negative Richtung
cycles-choice-direction-1 = positive Richtung
cycles-choice-directed-axis-minus-3 = Tastsystemachse Z, negative Richtung
cycles-choice-directed-axis-minus-2 = Nebenachse Y, negative Richtung
cycles-choice-directed-axis-minus-1 = Hauptachse X, negative Richtung
cycles-choice-directed-axis-1 = Hauptachse X, positive Richtung
cycles-choice-directed-axis-2 = Nebenachse Y, positive Richtung
cycles-choice-directed-axis-3 = Tastsystemachse Z, positive Richtung
cycles-choice-tool-axis-probing-0 = bleibt
cycles-choice-tool-axis-probing-1 = angetastet und gesetzt
cycles-choice-transfer-minus-1 = nicht angegeben
cycles-choice-transfer-0 = Nullpunkttabelle
cycles-choice-transfer-1 = Bezugspunkttabelle
cycles-choice-preset-correction-0 = unverändert
cycles-choice-preset-correction-1 = nach dem Punkt korrigiert
cycles-choice-preset-correction-2 = nach dem 2. Punkt korrigiert
cycles-choice-preset-correction-3 = nach der Mitte beider korrigiert
cycles-choice-compensation-axis-0 = Achse des gemessenen Winkels
cycles-choice-compensation-axis-4 = Achse A
cycles-choice-compensation-axis-5 = Achse B
cycles-choice-compensation-axis-6 = Achse C
cycles-choice-zero-after-alignment-0 = behält ihren Wert
cycles-choice-zero-after-alignment-1 = zeigt null
cycles-choice-rotary-alignment-0 = bleiben stehen
cycles-choice-rotary-alignment-1 = drehen, der Taster geht mit
cycles-choice-rotary-alignment-2 = drehen allein
cycles-choice-rotation-transfer-0 = ändert nichts
cycles-choice-rotation-transfer-1 = Grunddrehung
cycles-choice-rotation-transfer-2 = Versatz der Drehachse
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = innen
cycles-choice-side-1 = außen
cycles-choice-geometries-0 = zwei Bohrungen
cycles-choice-geometries-1 = zwei Zapfen
cycles-choice-geometries-2 = Bohrung und Zapfen
cycles-choice-geometries-3 = Zapfen und Bohrung

## Die Werkzeugtabelle

tools = Werkzeugtabelle
tools-none = keine
tools-open-one = { $name }, { $count ->
    [one] ein Werkzeug
   *[other] { $count } Werkzeuge
  }
tools-open = Werkzeugtabelle öffnen…
tools-close = Keine Werkzeugtabelle
tools-save = Werkzeugtabelle speichern…
tools-save-hint = Die Tabelle mit diesen Änderungen. Der nächste Lauf beginnt mit der Tabelle, wie sie geöffnet wurde.
tools-dialog-open = Werkzeugtabelle öffnen
tools-dialog-save = Geänderte Werkzeugtabelle speichern
tools-loaded = Werkzeugtabelle { $name } wird verwendet
tools-pick = Werkzeug wählen
tools-pick-of = { $parameter } aus der Werkzeugtabelle
tools-input = { $parameter } Werkzeug zur Überwachung (Q330)
tools-fixed = Q330 = { $tool } im Programm
tools-more = { $count ->
    [one] ein weiteres Werkzeug
   *[other] { $count } weitere Werkzeuge
  }
tools-row = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, gesperrt
tools-without-name = { $count ->
    [one] ein Werkzeug wird nicht angezeigt: sein Name ist nicht eindeutig
   *[other] { $count } Werkzeuge werden nicht angezeigt: ihre Namen sind nicht eindeutig
  }
tools-not-in-table = Q330 = { $tool }: die Werkzeugtabelle hat dieses Werkzeug nicht
tools-not-monitored = Ohne Werkzeugtabelle wird kein Werkzeug überwacht (Q330)
tools-none-named = Q330 nennt kein Werkzeug: die Werkzeugtabelle wird nicht verwendet
tools-no-deviation = der Messwert weicht nicht ab: das Werkzeug wird nicht geändert
tools-changed = Geändert in der Werkzeugtabelle
tools-nothing-changed = kein Lauf hat die Werkzeugtabelle geändert

## Ein Teil mit mehreren Merkmalen

cycles-part-refused = die Datei hat Tabellen [[feature]]: ein einzelner Zyklus misst eine Fläche; die Seite Programme und fitcheck run messen ein solches Teil
part-features = Merkmale des Teils
part-of-features = { $name }, { $count ->
    [one] ein Merkmal
   *[other] { $count } Merkmale
  }, Kugelradius { $ball } mm
part-round = { $name }: { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name }: { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name }: { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name }: { $kind } X { $x } Y { $y } Z { $z }
