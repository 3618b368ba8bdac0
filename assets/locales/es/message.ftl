# Where an error or a warning is in a file

located-in-file = { $what }: { $file }, línea { $line }, columna { $column }
located-in-line-of-file = { $what }: { $file }, línea { $line }
located-at-file = { $what }: { $file }
located-at-column = línea { $line }, columna { $column }: { $what }
located-at-line = línea { $line }: { $what }
