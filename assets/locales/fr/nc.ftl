# Ensembles de programmes, de tables et de masques pour une commande.
## Plans
nc-value = { $what } : { $error }
nc-name = nom { $name } : lettres A à Z, chiffres et _ admis, au plus { $most }
nc-not-on-control = { $kind } : se mesure avec le cycle { $cycle }, absent de { $control }
## Ensembles
nc-folder = { $folder } n'est pas un dossier pour programmes : écrire TNC:\ puis des noms faits de lettres, chiffres, _ et -, séparés par \
nc-no-texts = un jeu avec des textes de tolérance n'est possible que pour TNC7, pas pour { $control }
nc-series-name = { $name } ne peut pas nommer une colonne du tableau de la série : commencer le nom par une lettre et ne pas utiliser NR, PART ni STATUS
nc-series-sizes = une série conserve au plus { $most } cotes d'une pièce et le plan en a { $sizes } : créer plusieurs ensembles
nc-reads-otherwise = { $file } ne peut pas être écrit de façon à être relu à l'identique
nc-proof = l'ensemble a échoué à l'essai et n'a pas été écrit : { $reason }
nc-proof-no-end = le programme ne se termine pas
nc-proof-count = { $found } éléments mesurés sur { $expected }
nc-proof-other-verdict = { $name } : le verdict diffère de celui de Fitcheck
nc-archive = le fichier zip ne peut pas être créé : { $reason }
nc-workpiece = la pièce ne peut pas être écrite : { $reason }
nc-own-column = { $class } n'est pas l'une des 47 classes de NC-Solution 8255 : { $table } reçoit une colonne de plus
nc-figure = { $what }
nc-fewer-columns = limite de colonnes d'une iTNC 530 : { $table } n'a que les classes du plan, { $classes }
nc-by-hand = { $name } : aucun cycle ne mesure un élément de type { $kind } : il n'est pas dans le jeu
nc-not-in-set = { $name } : le plan donne { $said }, mais l'ensemble ne l'utilise pas : sur la commande, les limites seules décident, elle peut donc dire BON là où fitcheck import ne le dit pas
nc-features = { $first } (et { $more } de plus)
nc-moved-nominal = { $name } : la cote nominale de { $callout } est hors des limites, ce qu'une TNC7 refuse : { $parameter } est { $value } mm, et { $deviation } s'y rapporte
nc-no-place = { $name } demande x, y et z : le programme s'y déplace
nc-own-cycle = { $name } a un cycle ou des paramètres propres, que les programmes appelés ne prennent pas en charge
nc-no-coordinate = { $column } n'est pas donné : le programme s'y déplace
