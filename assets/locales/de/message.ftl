# Wo in einer Datei ein Fehler oder eine Warnung steht

located-in-file = { $what }: { $file }, Textzeile { $line }, Spalte { $column }
located-in-line-of-file = { $what }: { $file }, Textzeile { $line }
located-at-file = { $what }: { $file }
located-at-column = Textzeile { $line }, Spalte { $column }: { $what }
located-at-line = Textzeile { $line }: { $what }

# Eigene Texte des Benutzers

own-text-language = { $given } beginnt nicht mit dem Kürzel einer Sprache. Der Name einer Datei mit eigenen Texten beginnt mit einem von { $codes }, etwa nl_OurShop.ftl: Datei umbenennen
own-text-too-large = die Datei hat { $bytes } Byte, und eine Datei mit eigenen Texten darf { $most } haben: nur die Texte behalten, die anders sind
own-text-not-utf8 = Byte { $byte } ist kein UTF-8: Datei als UTF-8 speichern
own-text-syntax = { $given } ist nicht als Fluent lesbar ({ $reason }). Den Namen an den Anfang einer Zeile schreiben, dann = und den Text, und weitere Zeilen einrücken
own-text-not-a-text = { $given } ist ein Term oder hat Attribute, und nur Texte lassen sich ersetzen: als Name = Text schreiben
own-text-unknown = es gibt keinen Text { $name }, und kein Name ist ähnlich. Die Namen sind die der eingebauten Texte: berichtigen oder löschen
own-text-misspelt = es gibt keinen Text { $name }. Der ähnlichste Name ist { $nearest }: berichtigen oder löschen
own-text-twice = { $name } steht zweimal da, zuerst in Textzeile { $first }, und keiner von beiden zählt: einen löschen
own-text-empty = { $given } hat einen leeren Text oder eine Variante, die nichts zeigt: einen Text schreiben, oder ihn für den eingebauten löschen
own-text-control = { $given } hat das Steuerzeichen { $code }, und nur sichtbare Zeichen sind erlaubt: löschen
own-text-too-much = { $given } ist länger als { $longest } Zeichen, hat mehr als { $deepest } Klammern ineinander oder zu viele Varianten: einfacher schreiben
own-text-surplus = { $name } hat { $given }, wofür nichts eingesetzt wird. Möglich ist nur { $allowed }: berichtigen oder löschen
own-text-surplus-of-none = { $name } hat { $given }, aber in diesen Text wird nichts eingesetzt: löschen
own-text-lost = in { $name } fehlt { $lost } des eingebauten Textes, wenigstens in einer Variante, sodass etwas ungesagt bliebe: einfügen
own-text-read-back = { $name } sagt, woher ein Wert kommt, und wird aus Dateien wieder gelesen; er lässt sich nicht ersetzen: löschen
own-text-property = { $name } gehört zur Sprache und ist kein Text, der sich ersetzen lässt: löschen
own-text-same-verdict = { $name } zählt nicht, denn { $clash } sagt { $word }, und das sagt auch { $other }. Urteile brauchen je ein eigenes Wort, auch neben den eingebauten und den englischen: jedem ein anderes Wort geben
