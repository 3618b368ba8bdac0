# Where an error or a warning is in a file

located-in-file = { $what }: { $file }, line { $line }, column { $column }
located-in-line-of-file = { $what }: { $file }, line { $line }
located-at-file = { $what }: { $file }
located-at-column = line { $line }, column { $column }: { $what }
located-at-line = line { $line }: { $what }
