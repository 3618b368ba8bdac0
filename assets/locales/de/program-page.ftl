## Die Seite Programme

page-program = Programme
program-page-dialog-open = NC-Programm öffnen
program-page-choice = NC-Programm
program-page-open = Öffnen…
program-page-not-shipped = { $name } ist in dieser Version nicht enthalten
program-page-nothing = Kein Programm geöffnet
program-page-listing = { $name }, { $count ->
    [one] { $count } NC-Satz
   *[other] { $count } NC-Sätze
  }

program-page-run = Starten
program-page-pause = Pause
program-page-step = Einzelsatz
program-page-step-over = Ganzer Aufruf
program-page-to-selected = Bis Cursor
program-page-breakpoint = Haltepunkt
program-page-reset = Zurücksetzen
program-page-move = Zu einem anderen NC-Satz
program-page-speed = Tempo
program-page-speed-slow = 4 Sätze/s
program-page-speed-medium = 20 Sätze/s
program-page-speed-fast = volles Tempo
program-page-options = Optionen
program-page-skip-unknown = Unbekannte NC-Sätze überspringen
program-page-assume-tool = Ohne TOOL CALL entlang Z antasten
program-page-block-skip = NC-Sätze mit / überspringen
program-page-optional-stop = Bei M1 anhalten
program-page-outline-none = Überschrift oder Label
program-page-outline = Gehe zu

program-page-state-ready = Startbereit
program-page-state-running = Läuft
program-page-state-paused = Pause
program-page-state-step = Einzelsatz
program-page-state-breakpoint = Pause an einem Haltepunkt
program-page-state-goal = Pause am Cursor
program-page-state-over = Pause nach dem Aufruf
program-page-state-stop = Das Programm hat selbst angehalten: weiter mit Starten
program-page-state-optional-stop = Das Programm hat selbst mit M1 angehalten: weiter mit Starten
program-page-state-tolerance = Außer Toleranz: { $stop }
program-page-state-log = Das Messprotokoll steht am Bildschirm: weiter mit Starten
program-page-state-ended = Beendet nach { $blocks } NC-Sätzen
program-page-state-fault = Mit einem Fehler angehalten
program-page-refused-inputs = Eine Eingabe ist nicht lesbar
program-page-refused-none = Kein Programm geöffnet
program-page-refused-workpiece = Das Werkstück ist nicht lesbar
program-page-refused-no-contacts = Keine Antastpunkte geöffnet

program-page-has-breakpoint = Haltepunkt
program-page-is-current = nächster NC-Satz
program-page-is-failed = Fehler hier

program-page-inputs = Eingaben
program-page-answers = Fitcheck und das Programm
program-page-program = Programm
program-page-verdict = Urteil
program-page-no-limits = Keine Grenzmaße: eine Eingabe ist nicht lesbar
program-page-agrees = Das Programm und Fitcheck stimmen überein
program-page-contested = Programm { $program }, Fitcheck { $own }
program-page-contested-limits = Programm { $program }, nach anderen Grenzmaßen als Fitcheck
program-page-stopped-at = Mit einem Fehler angehalten; bis dahin { $program }
program-page-differs = Das Programm weicht ab: { $what }
program-page-differs-minimum = sein Mindestmaß ist { $program } mm, das von Fitcheck { $own } mm
program-page-differs-maximum = sein Höchstmaß ist { $program } mm, das von Fitcheck { $own } mm
program-page-differs-status = es sagt { $program }, Fitcheck sagt { $own }
program-page-differs-fault = es hat mit einem Fehler angehalten
program-page-differs-native-refuses = es gab ein Urteil, Fitcheck hat keine Grenzmaße
program-page-other-inputs = Nicht verglichen: das Programm hat inzwischen andere Eingaben gesetzt und misst ein anderes Merkmal
program-page-both-refuse = Weder das Programm noch Fitcheck gibt eine Antwort

program-page-workpiece = Werkstück
program-page-from-perfect = ideal, Toleranzmitte
program-page-from-nominal = ideal, mit Nennmaß
program-page-from-given = ideal, Durchmesser angegeben
program-page-from-simulated = simuliert
program-page-from-part = Teil mit mehreren Merkmalen
program-page-open-part = Teil öffnen…
program-page-dialog-part = Simuliertes Teil mit mehreren Merkmalen öffnen
program-page-refused-no-part = Kein Teil geöffnet
program-page-from-recorded = erfasste Antastpunkte
program-page-workpiece-x = Ist-Mitte X
program-page-workpiece-y = Ist-Mitte Y
program-page-edit-workpiece = Werkstück und Tastsystem…
program-page-open-contacts = Andere Antastpunkte…
program-page-recorded = { $count ->
    [one] { $count } Antastpunkt
   *[other] { $count } Antastpunkte
  } aus { $name }
program-page-path = Bahn des Tastsystems
program-page-no-path = Noch keine Bahn
program-page-zero = Nullpunkt X { $x }, Y { $y }, Z { $z } mm
program-page-turned = um { $angle }° gedreht
program-page-tilted = geschwenkt A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = Das Programm hat kein Fenster geöffnet
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, SIMULIERT
program-page-cycles = Gemessen
program-page-show-block = NC-Satz anzeigen
program-page-last-of = Die letzten { $shown } von { $all }
program-page-outputs = Dateien
program-page-outputs-hint = Hier angezeigt, nicht auf Datenträger geschrieben

program-page-parameters = Parameter
program-page-filter = Filter
program-page-set = Beginnen mit
program-page-value = Wert
program-page-give = Setzen
program-page-give-hint = Der nächste Lauf beginnt mit diesem Wert
program-page-given = Für den nächsten Lauf gesetzt
program-page-drop = entfernen
program-page-no-parameter = { $given } ist kein Parameter: Q5, QL5, QR5 oder QS5 schreiben
program-page-no-number = { $given } ist keine Zahl
program-page-none-found = Kein passender Parameter
program-page-no-parameters = Parameter erscheinen, sobald das Programm läuft
program-page-undefined = nicht definiert
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, geändert
program-page-pin = { $parameter } oben halten
program-page-unpin = { $parameter } nicht oben halten
program-page-q108 = Radius des Werkzeugs
program-page-q109 = Werkzeugachse: 0 X, 1 Y, 2 Z
program-page-q110 = Spindel: 0 M3, 1 M4, 2 oder 3 danach gehalten
program-page-q111 = Kühlmittel: 0 aus, 1 ein
program-page-q113 = Maßeinheit: 0 mm, 1 Inch
program-page-q114 = Länge des Werkzeugs
program-page-q115 = Antastposition, X
program-page-q116 = Antastposition, Y
program-page-q117 = Antastposition, Z
program-page-q150 = gemessener Winkel

program-page-problems = { $count ->
    [one] { $count } Hinweis
   *[other] { $count } Hinweise
  }
program-page-unlisted = { $count ->
    [one] { $count } weiterer wird nicht angezeigt
   *[other] { $count } weitere werden nicht angezeigt
  }
program-page-at-block = NC-Satz { $number }: { $what }
program-page-at-line = Textzeile { $line }: { $what }

program-page-create = Für eine Steuerung erstellen…
program-page-create-hint = NC-Programme, Tabellen und Maske, mit denen eine Steuerung selbst misst
program-page-create-also = schreiben NC Programme Dateien Dateisatz
program-page-create-head = Für eine Steuerung erstellen
program-page-create-control = Steuerung
program-page-create-language = Dialogsprache
program-page-create-from = Aus
program-page-create-series = Für eine Serie: jeder Start misst das nächste Teil
program-page-create-texts = Toleranzen der Durchmesser als Texte des Zyklus
program-page-create-callout = { $callout } der Seite Prüfung, bei X { $x } Y { $y } Z { $z }
program-page-create-no-callout = Toleranzangabe der Seite Prüfung
program-page-create-plan = Plan { $name }, { $count ->
    [one] { $count } Merkmal
   *[other] { $count } Merkmale
  }
program-page-create-nothing = Auf der Seite Prüfung eine Toleranzangabe eingeben oder auf der Seite Teile einen Plan öffnen
program-page-create-plan-wrong = { $name } hat Fehler: den Plan auf der Seite Teile öffnen und berichtigen
program-page-create-folder = Ordner auf der Steuerung: { $folder }
program-page-create-proven-callout = Zurückgelesen und ausgeführt: { $callout } erhält genau die Grenzmaße von Fitcheck
program-page-create-proven-plan = Zurückgelesen und ausgeführt: jedes Merkmal erhält die Grenzmaße des Plans
program-page-create-clearance-height = Die sichere Höhe ist { $height } mm; in einem Plan setzt sie eine Spalte
program-page-create-files-none = Dateien erstellen…
program-page-create-files = { $count ->
    [one] { $count } Datei
   *[other] { $count } Dateien
  } erstellen…
program-page-dialog-create = Dateien für eine Steuerung erstellen: Ordner wählen oder nennen
program-page-create-written = { $count ->
    [one] { $count } Datei wurde
   *[other] { $count } Dateien wurden
  } in { $folder } geschrieben: { $names }
program-page-create-no-folder = { $name } ist eine Datei: einen Ordner nennen
program-page-contacts-left = Die Antastpunkte aus { $name } gehören zum vorigen Programm: dieses misst ein ideales Werkstück
program-page-unfinished = Nicht verglichen: das Programm kam nicht bis zum Ende
program-page-unknown = { $fault }. Um ohne ihn weiterzulaufen, Optionen → Unbekannte NC-Sätze überspringen einschalten
program-page-missing-file = { $fault }. Gesucht wurde in { $folder } und unter den mitgelieferten Dateien. Die Datei dort neben das Programm legen oder das Programm in dem Ordner öffnen, der sie enthält
program-page-unknown-datum = { $fault }. Ohne den Bezugspunkt wird nichts gemessen. Zum Versuch eine Kopie des Programms ohne den NC-Satz öffnen, der ihn setzt, und ein Werkstück von diesem Bezugspunkt aus gesehen
program-page-not-written = { $path } würde auf der Steuerung geschrieben. Der Text steht unter Dateien; in der Befehlszeile schreibt ihn fitcheck run --output-folder
program-page-no-verdict = Keine Grenzmaße, kein Urteil
