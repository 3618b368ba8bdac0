# Where an error or a warning is in a file

located-in-file = { $what }: { $file }, řádek { $line }, sloupec { $column }
located-in-line-of-file = { $what }: { $file }, řádek { $line }
located-at-file = { $what }: { $file }
located-at-column = řádek { $line }, sloupec { $column }: { $what }
located-at-line = řádek { $line }: { $what }
