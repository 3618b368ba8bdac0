# Die Spalten einer Datei mit Messungen: gesehen, verbessert und gemerkt.

columns-page-import = Spalten…
columns-page-hint = Zeigt, wie jede Spalte einer Datei gelesen wird, bevor die Werte importiert werden
columns-page-take = Importieren
columns-page-correct = Spalten…
columns-page-forget = Diese Spalten vergessen
columns-page-dialog = Importieren und Spalten wählen
columns-page-title = Spalten von { $name }
columns-page-wanted = Wählen, was jede Spalte enthält. Dateien mit demselben Aufbau werden auf dieselbe Weise gelesen.
columns-page-uncertain = Bei manchen Spalten ist der Inhalt nicht sicher: prüfen, was jede enthält, dann importieren. Dateien mit demselben Aufbau werden auf dieselbe Weise gelesen.
columns-page-sheet = Blatt
columns-page-separator = Trennzeichen
columns-page-separator-semicolon = Semikolon
columns-page-separator-comma = Komma
columns-page-separator-tab = Tabulator
columns-page-separator-pipe = Senkrechter Strich
columns-page-decimal = Dezimalzeichen
columns-page-decimal-point = Punkt
columns-page-decimal-comma = Komma
columns-page-as-found = Wie in der Datei
columns-page-unit = Einheit der Maße
columns-page-place-unit = Einheit von X, Y, Z
columns-page-unit-names = Nach dem Kopf, sonst mm
columns-page-unit-from = Aus der Datei: { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = Inch
columns-page-first-row = Erste Zeile
columns-page-below-header = Unter dem Kopf
columns-page-line = Textzeile { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = nicht verwendet
columns-page-role-name = Name
columns-page-role-number = Nummer
columns-page-role-callout = Toleranzangabe
columns-page-role-nominal = Nennmaß
columns-page-role-measured = Messwert
columns-page-role-time = Zeit
columns-page-role-simulated = simuliert
columns-page-role-part = Teil
columns-page-role-serial = Seriennummer
columns-page-role-who = Bediener
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = was gemessen ist
columns-page-header = { $line } Kopf
columns-page-row = { $line }
columns-page-not-read = { $line } nicht gelesen
columns-page-read = { $rows ->
        [0] Keine der angezeigten Zeilen wird gelesen
        [one] { $read } von 1 angezeigten Zeile wird ein Wert
       *[other] { $read } von { $rows } angezeigten Zeilen werden Werte
    }
columns-page-first-problem = Erster Fehler: { $why }
columns-page-no-measured = Keine Spalte enthält den Messwert: eine wählen
columns-page-no-callout = Keine Spalte enthält die Toleranzangabe, daher kann kein Wert beurteilt werden: eine wählen
columns-page-no-name = Keine Spalte sagt, zu welchem Merkmal ein Wert gehört: Name, Nummer oder X und Y wählen
columns-page-taken = Spalten: { $columns }; Einheit der Maße: { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Spalten gelesen wie am { $day } festgelegt
columns-page-forgotten = Die Spalten sind vergessen: die nächste Datei mit diesem Aufbau wird gelesen, als wäre sie die erste. Die Werte dieser Datei bleiben.
columns-page-none = { $name } ist keine Tabelle mit Spalten
columns-page-large = { $name } ist zu groß, um im Fenster mit eigens festgelegten Spalten gelesen zu werden: fitcheck import --columns benutzen
