# Où se trouve une erreur ou un avertissement dans un fichier

located-in-file = { $what } : { $file }, ligne { $line }, colonne { $column }
located-in-line-of-file = { $what } : { $file }, ligne { $line }
located-at-file = { $what } : { $file }
located-at-column = ligne { $line }, colonne { $column } : { $what }
located-at-line = ligne { $line } : { $what }
