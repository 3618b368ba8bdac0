# Waar in een bestand een fout of waarschuwing staat

located-in-file = { $what }: { $file }, regel { $line }, kolom { $column }
located-in-line-of-file = { $what }: { $file }, regel { $line }
located-at-file = { $what }: { $file }
located-at-column = regel { $line }, kolom { $column }: { $what }
located-at-line = regel { $line }: { $what }
