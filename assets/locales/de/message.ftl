# Wo in einer Datei ein Fehler oder eine Warnung steht

located-in-file = { $what }: { $file }, Textzeile { $line }, Spalte { $column }
located-in-line-of-file = { $what }: { $file }, Textzeile { $line }
located-at-file = { $what }: { $file }
located-at-column = Textzeile { $line }, Spalte { $column }: { $what }
located-at-line = Textzeile { $line }: { $what }
