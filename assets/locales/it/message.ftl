# Dove si trova un errore o un avviso in un file

located-in-file = { $what }: { $file }, linea { $line }, colonna { $column }
located-in-line-of-file = { $what }: { $file }, linea { $line }
located-at-file = { $what }: { $file }
located-at-column = linea { $line }, colonna { $column }: { $what }
located-at-line = linea { $line }: { $what }
