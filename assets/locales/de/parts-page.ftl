page-parts = Teile
parts-page-walk = Messen
parts-page-plan = Plan
parts-page-new = Neuer Plan
parts-page-open = Plan öffnen…
parts-page-save = Plan speichern…
parts-page-save-csv = Plan als CSV speichern…
parts-page-undo = Rückgängig
parts-page-redo = Wiederholen
parts-page-dialog-open = Prüfplan öffnen
parts-page-dialog-save = Prüfplan speichern
parts-page-not-saved = { $name }, nicht gespeichert
parts-page-no-plan = Noch kein Plan: einen öffnen oder anlegen.
parts-page-move = Zu einer anderen Zelle
parts-page-extend = Auswahl erweitern
parts-page-edit = Zelle bearbeiten
parts-page-take = Fertig
parts-page-empty = Zellen leeren
parts-page-copy = Zellen kopieren
parts-page-paste = Einfügen
parts-page-insert = Zeile einfügen
parts-page-delete = Zeilen löschen
parts-page-up = Nach oben
parts-page-down = Nach unten
parts-page-sort = Sortieren
parts-page-sort-hint = Sortiert nach der Spalte der aktuellen Zelle, A2 vor A10; noch einmal sortieren kehrt die Reihenfolge um
parts-page-renumber = Nummerieren
parts-page-renumber-hint = Nummeriert die Merkmale ab 1 in der Reihenfolge der Zeilen
parts-page-all-columns = Alle Spalten
parts-page-previous = Voriger Fehler
parts-page-next = Nächster Fehler
parts-page-choose-picture = Bild wählen…
parts-page-dialog-picture = Bild des Teils wählen
parts-page-table = Merkmale des Plans
parts-page-cell-name = Zelle des Plans
parts-page-cell = Zeile { $row }, { $column }, { $text }
parts-page-cell-empty = Zeile { $row }, { $column }, leer
parts-page-cell-wrong = { $cell }, Fehler: { $what }
parts-page-new-row = neu
parts-page-limits = Grenzmaße
parts-page-editing = { $column } in Zeile { $row }
parts-page-head = Teil
parts-page-words = Eines von: { $words }
parts-page-no-fault = Keine Fehler im Plan
parts-page-blank = Das erste Merkmal eingeben oder Zeilen aus einer Tabellenkalkulation einfügen
parts-page-faults = { $count ->
    [one] Ein Fehler
   *[other] { $count } Fehler
}
parts-page-features = { $count ->
    [one] Ein Merkmal
   *[other] { $count } Merkmale
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Zeile { $row }
parts-page-fault-plan = Plan
parts-page-lost = In der Datei nicht verstanden: der Plan misst und speichert nichts, bis dies in der Datei berichtigt oder hier weggelassen ist
parts-page-take-meant = { $meant } verwenden
parts-page-leave-out = Diese weglassen
parts-page-leave-out-hint = Der Plan hat dann nur, was gelesen werden konnte; was nicht verstanden wurde, kann ein Merkmal sein
parts-page-left-out = { $count ->
    [one] { $name }: eine nicht verstandene Angabe ist aus dem Plan weggelassen; die Datei behält sie, bis der Plan gespeichert wird
   *[other] { $name }: { $count } nicht verstandene Angaben sind aus dem Plan weggelassen; die Datei behält sie, bis der Plan gespeichert wird
}
parts-page-pasted-rows = { $count ->
    [one] Eine eingefügte Zeile wurde übersprungen: ein Plan hat höchstens { $most } Merkmale
   *[other] { $count } eingefügte Zeilen wurden übersprungen: ein Plan hat höchstens { $most } Merkmale
}
parts-page-pasted-columns = { $count ->
    [one] Eine eingefügte Spalte wurde übersprungen: rechts davon gibt es keine weiteren. „Alle Spalten“ zeigt mehr
   *[other] { $count } eingefügte Spalten wurden übersprungen: rechts gibt es keine weiteren. „Alle Spalten“ zeigt mehr
}
parts-page-column-number = Nr.
parts-page-column-name = Name
parts-page-column-kind = Art
parts-page-column-axis = Achse
parts-page-column-callout = Tol.-Angabe
parts-page-column-callout2 = Tol.-Angabe Y
parts-page-column-feature = Bohrung/Welle
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Winkel
parts-page-column-clearance = Abstand
parts-page-column-clearance-height = Sichere Höhe
parts-page-column-cycle = Zyklus
parts-page-column-parameters = Parameter
parts-page-column-material = Werkstoff
parts-page-column-rule = Regel
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Plausibel
parts-page-column-plausible2 = Plausibel Y
parts-page-column-remark = Bemerkung
parts-page-column-balloon-x = Stempel X
parts-page-column-balloon-y = Stempel Y
parts-page-head-part = Teil
parts-page-head-drawing = Zeichnung
parts-page-head-picture = Bild
parts-page-head-material = Werkstoff
parts-page-head-rule = Regel
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Verfahrweg X (mm)
parts-page-head-travel-y = Verfahrweg Y (mm)
parts-page-head-travel-z = Verfahrweg Z (mm)
parts-page-head-remark = Bemerkung
parts-page-head-file = Datei neben dem Plan
parts-page-head-two = min max
parts-page-picture = Bild des Teils
parts-page-picture-said = Bild des Teils, { $on } von { $count } Stempeln gesetzt
parts-page-picture-none = Kein Bild
parts-page-picture-awaited = Das Bild wird gelesen
parts-page-picture-folder = { $given } ist nicht der Name einer Datei neben dem Plan: das Bild muss im Ordner des Plans liegen, daher den Namen ohne Ordner angeben
parts-page-picture-unsaved = Zuerst den Plan speichern: das Bild muss im selben Ordner liegen
parts-page-picture-elsewhere = { $given } liegt nicht im Ordner des Plans: zuerst dorthin kopieren, damit beide zusammenbleiben
parts-page-picture-large = { $name } hat { $given } KiB; ein Bild hat höchstens { $most } KiB
parts-page-picture-dots = { $name } hat { $width } × { $height } Pixel; ein Bild hat höchstens { $most } Millionen Pixel
parts-page-picture-kind = { $name } ist kein Bild in PNG, JPEG oder SVG
parts-page-picture-broken = { $name } kann nicht als Bild gelesen werden: { $reason }
parts-page-balloon = Stempel { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, nächster
parts-page-balloon-beside = { $balloon }, nicht im Bild
parts-page-balloon-open = nicht gemessen
parts-page-balloon-skipped = übersprungen
parts-page-beside = Noch nicht im Bild: dorthin ziehen
parts-page-beside-more = und { $count } weitere
parts-page-balloon-simulated = { $status }, simuliert
parts-page-more = Zeilen und Zellen
parts-page-picture-heavy = { $name } zu zeichnen würde zu lange dauern: es enthält Filter, große Muster oder zu viele Ebenen; diese entfernen oder das Bild als PNG speichern
parts-page-csv-copy = Die Datei ist eine Kopie: CSV hat nur die Merkmale, und { $keys } des Teils ist weggelassen
parts-page-opened = { $count ->
    [one] { $name } ist geöffnet, aber eine Angabe der Datei fehlt im Plan
   *[other] { $name } ist geöffnet, aber { $count } Angaben der Datei fehlen im Plan
}
parts-page-pasted-twice = Eine eingefügte Spalte wurde weggelassen: die erste Zeile nennt { $keys } mehr als einmal, und die erste Spalte dieses Namens gilt
parts-page-pasted-unknown = Eingefügte Spalten, die ein Plan nicht hat, wurden weggelassen: { $names }
parts-page-pasted-nameless = { $count ->
    [one] Eine eingefügte Spalte wurde weggelassen: die erste Zeile hat keinen Namen darüber
   *[other] { $count } eingefügte Spalten wurden weggelassen: die erste Zeile hat keine Namen darüber
}
parts-page-comments = { $count ->
    [one] Speichern entfernt einen Kommentar aus der Datei
   *[other] Speichern entfernt { $count } Kommentare aus der Datei
}
parts-page-comments-lost = { $count ->
    [one] Ein Kommentar wurde aus { $name } entfernt: ein Plan wird ohne Kommentare geschrieben
   *[other] { $count } Kommentare wurden aus { $name } entfernt: ein Plan wird ohne Kommentare geschrieben
}
