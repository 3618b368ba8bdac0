# Les colonnes d'un fichier de mesures : vues, corrigées et retenues.

columns-page-import = Colonnes…
columns-page-hint = Montre comment chaque colonne d'un fichier est lue avant l'import de ses valeurs
columns-page-take = Importer
columns-page-correct = Colonnes…
columns-page-forget = Oublier ces colonnes
columns-page-dialog = Importer et choisir les colonnes
columns-page-title = Colonnes de { $name }
columns-page-wanted = Choisir ce que contient chaque colonne. Les fichiers de même structure seront lus de la même façon.
columns-page-uncertain = Certaines colonnes sont incertaines : vérifier ce que contient chacune, puis importer. Les fichiers de même structure seront lus de la même façon.
columns-page-sheet = Feuille
columns-page-separator = Séparateur
columns-page-separator-semicolon = Point-virgule
columns-page-separator-comma = Virgule
columns-page-separator-tab = Tabulation
columns-page-separator-pipe = Barre verticale
columns-page-decimal = Séparateur décimal
columns-page-decimal-point = Point
columns-page-decimal-comma = Virgule
columns-page-as-found = Comme dans le fichier
columns-page-unit = Unité des cotes
columns-page-place-unit = Unité de X, Y, Z
columns-page-unit-names = Selon l'en-tête, sinon mm
columns-page-unit-from = Selon le fichier : { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = pouces
columns-page-first-row = Première rangée
columns-page-below-header = Sous l'en-tête
columns-page-line = Ligne { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = non utilisée
columns-page-role-name = nom
columns-page-role-number = numéro
columns-page-role-callout = cote tolérancée
columns-page-role-nominal = cote nominale
columns-page-role-measured = valeur mesurée
columns-page-role-time = heure
columns-page-role-simulated = simulé
columns-page-role-part = pièce
columns-page-role-serial = numéro de série
columns-page-role-who = opérateur
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = grandeur mesurée
columns-page-header = { $line } en-tête
columns-page-row = { $line }
columns-page-not-read = { $line } non lue
columns-page-read = { $rows ->
        [0] Aucune des rangées affichées n'est lue
        [one] { $read } sur { $rows } rangée affichée devient une valeur
       *[other] { $read } sur { $rows } rangées affichées deviennent des valeurs
    }
columns-page-first-problem = Première erreur : { $why }
columns-page-no-measured = Aucune colonne ne contient la valeur mesurée : en choisir une
columns-page-no-callout = Aucune colonne ne contient la cote tolérancée, aucune valeur ne peut donc être jugée : en choisir une
columns-page-no-name = Aucune colonne n'identifie l'élément d'une valeur : choisir nom, numéro, ou X et Y
columns-page-taken = Colonnes : { $columns } ; unité des cotes : { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Colonnes lues comme corrigées le { $day }
columns-page-forgotten = Colonnes oubliées : le prochain fichier de cette structure est lu comme si c'était le premier. Les valeurs de ce fichier sont conservées.
columns-page-none = { $name } n'est pas une table à colonnes
columns-page-large = { $name } est trop gros pour être lu dans la fenêtre avec des colonnes corrigées : utiliser fitcheck import --columns
