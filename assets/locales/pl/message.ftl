# Gdzie w pliku jest błąd lub ostrzeżenie

located-in-file = { $what }: { $file }, linia { $line }, kolumna { $column }
located-in-line-of-file = { $what }: { $file }, linia { $line }
located-at-file = { $what }: { $file }
located-at-column = linia { $line }, kolumna { $column }: { $what }
located-at-line = linia { $line }: { $what }
