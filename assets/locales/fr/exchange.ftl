# exchange

# Mesures lues dans des fichiers
exchange-format-logs = procès-verbaux de mesure HEIDENHAIN tels que TCHPR421.TXT
exchange-format-log-444 = procès-verbaux de palpage 3D tels que Fitcheck les écrit
exchange-format-fn16 = sortie FN 16 d'une commande, lue à travers son masque (--mask)
exchange-format-series-table = tableau d'une commande qu'un programme remplit avec FN 27, une ligne par pièce
exchange-format-contacts = points de palpage d'un cercle : x, y et facultativement z
exchange-format-measurements = mesures en CSV : id, callout, measured
exchange-empty = le fichier est vide
exchange-not-recognised = pas un fichier d'un format connu
exchange-model-not-read = un modèle { $format } : Fitcheck ne lit pas les modèles ; exporter les valeurs mesurées en CSV, XLSX, QIF ou AQDEF
exchange-drawing-not-read = un dessin { $format } : Fitcheck ne lit pas les dessins ; exporter les cotes en CSV ou XLSX
exchange-document-not-read = un document { $format } : Fitcheck ne lit pas les documents ; exporter les valeurs en CSV, XLSX, QIF ou AQDEF
exchange-image-not-read = une image { $format } : Fitcheck ne lit pas les images ; exporter les valeurs en CSV, XLSX, QIF ou AQDEF
exchange-archive-not-read = une archive { $format } : la décompresser et donner les fichiers qu'elle contient
exchange-no-sheet = le classeur n'a pas de feuille { $given } ; il a { $sheets }
exchange-other-format = ce ne sont pas des mesures en CSV, mais : { $format }
exchange-parquet-unknown = ce programme a été compilé sans Parquet : cargo build --release sans autre option l'inclut
exchange-parquet-stream = Parquet liste ses colonnes à la fin du fichier et ne peut pas être lu depuis un tube : donner le nom du fichier
exchange-parquet = ce fichier Parquet ne peut pas être lu : { $reason }
exchange-parquet-nested = la colonne { $column } contient des colonnes ou des listes : seules des colonnes de valeurs simples peuvent être jugées
exchange-mask-backwards = { $mask } : { $reason }
exchange-mask-none = aucun des masques donnés n'imprime un tel fichier : { $masks }
exchange-mask-several = plusieurs masques impriment un tel fichier ; ne donner que celui qui l'a écrit : { $masks }
exchange-mask-no-measured = { $mask } n'imprime aucune valeur mesurée : Fitcheck reconnaît Q153 à Q156, Q160, et tout autre nombre avec sa cote tolérancée imprimée à côté
exchange-mask-measured = { $mask } : chacun de ceux-ci pourrait être la valeur mesurée : { $fields } ; imprimer le résultat du cycle, par exemple Q153 ; sinon le fichier a besoin de cotes tolérancées aux limites différentes
exchange-print-ambiguous = le masque peut lire ceci de plusieurs façons
exchange-print-broken = l'enregistrement finit trop tôt : sortie de la ligne { $line } du masque attendue
exchange-print-other = le masque n’imprime pas une telle ligne, mais elle contient des nombres : il peut s’agir d’un enregistrement dont une valeur manque ou a changé ; corrigez-la ou supprimez-la
exchange-print-unit = la ligne { $line } indique { $unit }, mais la sortie d'une commande est lue en mm : imprimer les valeurs en mm
exchange-table-no-part = aucune colonne n'indique à quelle pièce appartient une ligne : le tableau d'une série a besoin d'une colonne comme PART ou SERIAL
exchange-table-no-values = aucune colonne ne contient de valeurs mesurées
exchange-table-no-value = la colonne de { $name } qui contient la valeur mesurée n'est pas claire
exchange-table-touches = la cellule de la colonne { $column } touche sa voisine, l'une des deux peut être mal séparée : les séparer par une espace
exchange-table-unit = le tableau est en pouces et la colonne { $column } n'est pas de type LENGTH, ses valeurs peuvent donc être en mm : utiliser le type LENGTH
exchange-no-rows = aucune rangée ne contient de mesure
exchange-no-measured-column = pas de colonne de valeurs mesurées : la nommer dans la première ligne, par exemple id;callout;measured
exchange-several-columns = chacune des colonnes { $columns } peut être { $role } : en choisir une avec import --columns, par exemple { $word }=3, ou nommer les colonnes dans la première ligne pour qu'une seule convienne, par exemple id;callout;measured
exchange-role-id = le nom
exchange-role-tolerance = la cote tolérancée
exchange-role-nominal = la cote nominale
exchange-role-measured = la valeur mesurée
exchange-role-time = l'heure
exchange-role-simulated = l'indication de simulation
exchange-role-number = le numéro
exchange-role-part = la pièce
exchange-role-serial = le numéro de série
exchange-role-who = l'opérateur
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = la grandeur mesurée
exchange-role-upper = l’écart supérieur
exchange-role-lower = l’écart inférieur
exchange-role-minus = l’écart inférieur sans son signe moins
exchange-role-maximum = la limite supérieure
exchange-role-minimum = la limite inférieure
exchange-role-kind = alésage ou arbre
exchange-role-units = l’unité
exchange-role-status = le statut
exchange-role-machine = la machine
exchange-role-batch = le lot
exchange-role-sample = un échantillon
exchange-no-column = { $role } devrait être dans la colonne { $given }, mais le fichier a { $columns }
exchange-column-twice = la colonne { $column } ne peut pas être à la fois { $first } et { $second }
exchange-unit = unité inconnue { $unit } : utiliser mm, µm ou inch
exchange-limit = limite : { $reason }
exchange-tolerance-unsigned = la tolérance { $given } n’a pas de signe : écrire ±{ $given }, ou les deux écarts, comme +0.02 0
exchange-minus-again = l’écart inférieur { $given } a un signe moins, mais les autres n’en ont pas : les écrire tous avec leur signe
exchange-limits-contradict = { $callout } a les limites { $minimum } à { $maximum }, mais les colonnes disent { $given } : pour juger selon la cote, indiquer --columns { $columns } ; selon les colonnes, --columns callout=-
exchange-limits-or-deviations = les colonnes { $columns } peuvent être des limites ou des écarts par rapport à la cote nominale : choisir avec --columns, comme maximum={ $upper },minimum={ $lower } ou upper={ $upper },lower={ $lower }
exchange-limits-or-readings = les colonnes { $columns } peuvent être des limites, ou la plus grande et la plus petite de plusieurs lectures : choisir avec --columns, comme maximum={ $upper },minimum={ $lower } pour des limites ou maximum=-,minimum=- pour des lectures
exchange-minus-or-plus = les écarts inférieurs de la colonne { $columns } n’ont pas de signe : choisir avec --columns, minus={ $lower } pour en dessous de la cote nominale ou lower={ $lower } pour au-dessus
exchange-samples-side-by-side = plusieurs valeurs mesurées se suivent dans les colonnes { $columns } : les lire avec fitcheck import, ou en choisir une avec --columns, comme measured={ $first }
exchange-unit-stated = la ligne { $line } indique l'unité { $unit }, qui n'est pas prise en charge (« { $text } ») : utiliser mm, µm ou inch, ou choisir l'unité des cotes (--columns unit=mm)
exchange-unit-mentioned = la ligne { $line } mentionne { $unit } (« { $text } »), mais rien ne dit si les valeurs sont dans cette unité : choisir l'unité des cotes (--columns unit=mm, um ou inch)
exchange-units-differ = « { $at } » indique { $unit }, « { $other-at } » indique { $other } : corriger l'un des deux
exchange-unit-late = la ligne { $line } indique { $unit } (« { $text } »), mais les rangées au-dessus sont lues en { $read } : indiquer l'unité au-dessus de la première rangée, ou corriger cette ligne
exchange-unit-stray = cette ligne indique { $unit } (« { $text } »), mais toutes les autres rangées sont lues en { $read } : indiquer l'unité au-dessus de la première rangée, ou corriger cette ligne
exchange-unit-given = l'unité choisie est { $given }, mais le fichier indique { $unit } (« { $text } ») : choisir { $unit }, ou corriger le fichier
exchange-unit-half = la colonne { $column } est en pouces, et la colonne { $open } ne dit pas son unité : l'écrire à côté des deux noms, ou choisir l'unité des cotes (--columns unit=inch)
exchange-unit-missing = l'unité de cette rangée manque : écrire mm, µm ou inch, ou choisir l'unité des cotes (--columns unit=mm)
exchange-callout-unit = { $given } : la rangée est en pouces, et une cote tolérancée avec cote ou écarts est en mm : mettre la cote nominale dans sa propre colonne à côté de la classe
exchange-row-short = { $expected } cellules attendues, { $found } trouvées
exchange-row-long = { $expected } cellules attendues, { $found } trouvées : le séparateur sert-il aussi de séparateur décimal ou dans un texte ?
exchange-row-too-long = la rangée dépasse { $most } Kio
exchange-open-quote = un guillemet n'est pas fermé dans cette ligne
exchange-header-hides-rows = ligne { $line } : l'en-tête occupe plusieurs lignes, et l'une d'elles ressemble à une rangée : fermer les guillemets dans la ligne où ils s'ouvrent
exchange-within-quotes = cette ligne est peut-être une rangée ou une remarque : des guillemets s'ouvrent au-dessus et se ferment ici ou plus bas ; les fermer dans la ligne où ils s'ouvrent
exchange-callout = cote tolérancée : { $reason }
exchange-nominal = cote nominale : { $reason }
exchange-nominal-differs = la cote tolérancée { $callout } ne correspond pas à la cote nominale { $nominal } dans sa propre colonne
exchange-measured = mesuré : { $reason }
exchange-simulated = simulé : { $given } n'est ni vrai ni faux
exchange-other-header = cette ligne nomme d'autres colonnes que la première : juger les rangées au-dessous comme un fichier à part
exchange-below-other-header = non jugé : la ligne { $line } nomme d'autres colonnes. Juger les rangées au-dessous comme un fichier à part
exchange-simulated-below = les rangées sous cette ligne sont simulées : les juger comme un fichier à part, ou avec fitcheck import
exchange-origin = origine : { $given } ne dit ni mesuré ni simulé ; écrire measured, typed ou simulated, ou poser simulated=- si cette colonne dit autre chose
exchange-decimal-sign = mesuré : { $given } a un autre séparateur décimal que les autres valeurs : « { $sign } »
exchange-not-positive = mesuré : un diamètre de { $given } n'est pas supérieur à 0
exchange-decimal-comma = { $joined } est peut-être un seul nombre avec virgule décimale : utiliser un point décimal ou un autre séparateur
exchange-other-feature = { $given } est { $feature ->
        [hole] un arbre, et ce sont ici les alésages : les fichiers sont-ils intervertis ?
       *[shaft] un alésage, et ce sont ici les arbres : les fichiers sont-ils intervertis ?
    }
exchange-rejected = le fichier lui-même rejette cette valeur ({ $given }) : supprimer la rangée, ou la corriger dans le fichier
exchange-no-part = { $given } nomme un chiffre de plusieurs pièces ou un étalon de réglage, et non une pièce : supprimer la rangée, ou donner un autre nom à la pièce
exchange-other-log = { $feature ->
        [hole] c'est le procès-verbal d'un arbre, et ce sont ici les alésages : les fichiers sont-ils intervertis ?
       *[shaft] c'est le procès-verbal d'un alésage, et ce sont ici les arbres : les fichiers sont-ils intervertis ?
    }
exchange-not-a-size = { $what } : ce n'est pas une cote qui peut être appariée
exchange-no-place-axis = son axe est { $axis }, mais les cycles 421 et 422 palpent suivant Z
exchange-no-place-no-axis = le fichier ne dit pas suivant quel axe
exchange-no-place-kind = { $kind } : les cycles 421 et 422 ne palpent que cercles et cylindres
exchange-no-place-system = contrôlé dans le système de coordonnées { $system }, mais les coordonnées se rapportent à celui du fichier
exchange-contacts-not-sizes = des rangées de deux ou trois nombres sont des points de palpage : nommer les colonnes dans la première ligne, par exemple id;measured
exchange-too-many-rows = seules les { $most } premières rangées ont été lues : diviser le fichier
exchange-unjudged-no-callout = non jugé : aucune cote tolérancée donnée
exchange-unjudged-no-limits = non jugé : les cotes limites du procès-verbal sont 0, le diamètre n'était donc pas surveillé
exchange-unjudged-coordinate = une coordonnée du cycle { $cycle }, et non un alésage ou un arbre
exchange-unjudged-coordinate-without-limits = non jugé : les limites du procès-verbal sont 0, la coordonnée n'était donc pas surveillée
exchange-unjudged-size = { $what } du cycle { $cycle }, et non un alésage ou un arbre
exchange-unjudged-size-without-limits = non jugé, non surveillé car les limites du procès-verbal sont 0 : { $what }
exchange-unjudged-point = un point de surface du cycle { $cycle } : son écart suivant la normale n'est pas une cote
exchange-unjudged-point-without-tolerance = non jugé : le point a été palpé sans tolérance
exchange-unjudged-contacts = non jugé : { $count } points de palpage sans cote tolérancée
exchange-warning-ignored-columns = colonnes ignorées : { $columns }
exchange-warning-quantity-unknown = la colonne { $column } n'a aucun mot connu pour la grandeur mesurée ({ $words }) : toutes ses valeurs sont lues comme des cotes ; si c'est exact, donner import --columns quantity=-
exchange-warning-not-used = ignoré, pas une mesure : { $text }
exchange-warning-minus-supplied = la colonne { $column } n’a pas de signes moins : ses valeurs sont lues comme écarts inférieurs en dessous de la cote nominale
exchange-warning-callouts-unnamed = la colonne { $column } semble contenir les cotes tolérancées, mais son nom n’est pas connu : la nommer callout, ou donner son numéro avec --columns, par exemple callout=2
exchange-warning-limits-read = les colonnes { $columns } sont lues comme limites
exchange-warning-head-read = lu pour toutes les valeurs : { $said }
exchange-warning-samples-read = les colonnes { $columns } sont lues comme pièces côte à côte : chaque valeur est jugée seule, une cellule vide n’est pas une valeur, et sans numéros de série chaque colonne est une pièce à part
exchange-warning-comment = une ligne qui commence par # est un commentaire, mais celle-ci contient une mesure
exchange-warning-several-lines = la rangée occupe { $lines } lignes entre guillemets
exchange-warning-time = { $given } n'est pas une date avec heure : l'heure de l'import est utilisée
exchange-warning-place = { $given } n'est pas une longueur : la position est ignorée
exchange-warning-no-time = pas de date ni d'heure ici : l'heure de l'import est utilisée
exchange-warning-offset = { $given } est conservé comme heure locale sans son décalage par rapport à UTC
exchange-warning-cut-off = le fichier finit ici sans fin de ligne, et { $given } a moins de décimales que les autres valeurs : il est peut-être tronqué
exchange-warning-open-end = le fichier finit ici sans fin de ligne : sa dernière valeur, { $given }, est peut-être tronquée

# Points de palpage
contacts-file-empty = le fichier ne contient aucun point de palpage
contacts-no-columns = l'en-tête doit nommer x et y, et peut nommer z ; il est { $given }
contacts-twice = les colonnes { $first } et { $second } sont toutes deux { $name }
contacts-cells = { $wanted } cellules attendues, { $cells } trouvées : { $given }
contacts-not-a-number = { $name } est { $given }, et non un nombre de millimètres
contacts-row-too-long = la rangée dépasse { $most } Kio
contacts-comment = une ligne qui commence par # est un commentaire, mais celle-ci contient des coordonnées : supprimer le #, ou toute la ligne
contacts-other-unit = les points de palpage sont en mm, mais cette ligne indique { $given } : les convertir en mm
contacts-too-many = le fichier a plus de { $most } points de palpage
contacts-simulated = ces points de palpage sont simulés et ne mesurent rien : utiliser plutôt un fichier de pièce
contacts-origin = { $given } ne dit ni mesuré ni simulé : écrire measured ou simulated, ou supprimer la colonne
contacts-open-quote = un guillemet n'est pas fermé
contacts-mixed-signs = { $given } a un autre séparateur décimal que les rangées précédentes

## Tables d'écarts
table-format-name = { $name } ne commence pas par une lettre : sur une TNC7, les noms de tables le doivent
table-format-operator = { $name } contient { $sign } : sur une TNC7, les noms de tables ne peuvent pas avoir d'opérateurs arithmétiques
table-format-warning-lower-sign = le manuel de PC-DMIS ne montre aucun écart inférieur autre que 0 : vérifier { $class } dans PC-DMIS avant de s'y fier, surtout les signes
table-format-csv = le CSV ne peut pas être écrit : { $reason }
table-format-parquet-unknown = ce programme a été compilé sans Parquet : cargo build --release sans autre option l'inclut
table-format-parquet = le fichier Parquet ne peut pas être écrit : { $reason }
table-format-itnc530 = table de commande pour iTNC 530
table-format-tnc640 = table de commande pour TNC 620 et TNC 640
table-format-tnc7 = table de commande pour TNC7
table-format-plain-csv = CSV, une ligne par classe et plage de cotes
table-format-plain-parquet = Parquet, une rangée par classe et plage de cotes
table-format-pcdmis = CSV de tolérances ISO pour PC-DMIS

## Limites en SQL
sql-border = table { $table } : une plage de cotes finit à { $end } mm ; en SQL, les plages doivent finir à des millimètres entiers
sql-too-far = table { $table } : une plage de cotes finit à { $end } mm ; en SQL, les plages doivent finir au plus tard à { $most } mm
sql-twice = la classe { $class } est nommée deux fois
exchange-correction = la valeur à 20 °C ne découle pas de la valeur mesurée et de ses températures : colonnes telles que Fitcheck les écrit attendues
exchange-warning-corrected = les valeurs avec une indication dans la colonne as_measured_mm sont déjà à 20 °C
sizes-warning-named-twice = { $rows ->
        [one] { $rows } rangée a le nom d'une rangée antérieure
       *[other] { $rows } rangées ont le nom d'une rangée antérieure
    }, par exemple { $id } aux lignes { $first } et { $second } : chaque rangée compte comme une pièce
sizes-warning-simulated-rows = { $count ->
        [one] { $count } rangée est simulée
       *[other] { $count } rangées sont simulées
    } : rien n'a été mesuré
exchange-position-out = le centre était hors position, mais le fichier n'a que la cote
exchange-undecided = rien n'a été décidé ici : { $given }
exchange-warning-other-rule = les verdicts de ce fichier peuvent venir d'une autre règle de décision (colonne rule_name) : ses valeurs sont jugées de nouveau
exchange-read = le reste du fichier ne peut pas être lu : { $reason }
exchange-too-large = plus de { $most } Mio, la limite pour les fichiers de ce format
exchange-unjudged-one-limit = non jugé : l'une des deux limites manque
exchange-unjudged-no-tolerance = non jugé : aucune limite donnée
exchange-unjudged-rounded = non jugé : les chiffres imprimés valent pour toute valeur de { $from } à { $to }, et une limite se trouve entre les deux : imprimer plus de décimales
exchange-unjudged-implausible = non jugé : { $measured } mm est impossible : le plan indique { $lower } à { $upper } mm ; vérifier l'unité et le séparateur décimal, ou remesurer
exchange-unjudged-swapped-limits = non jugé : la limite inférieure { $minimum } est au-dessus de la limite supérieure { $maximum }
exchange-unjudged-not-a-size = { $what } : pas une cote d'alésage ou d'arbre
exchange-warning-limits-differ = { $callout } a les limites { $minimum } à { $maximum }, mais le fichier en a d'autres : les limites du fichier s'appliquent
exchange-warning-class-unknown = la classe { $given } n'a pas de limites ici : les limites du fichier s'appliquent
exchange-warning-status-differs = le fichier dit { $given }, mais les limites donnent { $status }
exchange-warning-status-unknown = le fichier dit { $given }, ce qui n'est pas un statut connu : les limites donnent { $status }
exchange-warning-limit-differs = le fichier dit { $given }, mais les limites sont { $minimum } à { $maximum }
exchange-warning-deviation-differs = le fichier dit { $given }, mais ce n'est pas l'écart de { $measured } à { $nominal }
exchange-warning-feature-differs = le fichier dit { $given }, mais les limites sont celles d'{ $feature ->
        [hole] un alésage
       *[shaft] un arbre
    }
exchange-warning-temperature-differs = le fichier dit { $given }, mais la valeur compte comme mesurée à { $counted } °C : donner --temperature et --material
exchange-warning-speaks-of-temperature = le fichier mentionne une autre température que { $counted } °C, à laquelle ses valeurs comptent comme mesurées : { $text }
exchange-warning-speaks-of-unit = une remarque indique une autre unité que celle des valeurs : { $text }
exchange-warning-speaks-of-simulation = cette ligne mentionne une simulation : vérifier si la valeur a été mesurée : { $text }
exchange-warning-all-nominal = les { $count } valeurs sont toutes exactement leurs cotes nominales : c'est peut-être une liste de cotes que personne n'a mesurées
exchange-warning-name-of-no-size = { $given } n'est pas le nom d'une cote d'une seule pièce, mais la valeur a été jugée comme telle
exchange-warning-other-values = les colonnes avec d'autres cotes à côté des cotes mesurées ne sont pas jugées : { $columns }
exchange-warning-part-rejected = le fichier dit { $given } de la pièce entière
exchange-warning-uncertainty-not-used = le fichier indique une incertitude élargie de { $expanded } mm : aucune règle ne l'utilise, donner plutôt --u
exchange-warning-plan-differs = le fichier a les limites { $minimum } à { $maximum } : les limites du plan s'appliquent
exchange-warning-plan-differs-below = le fichier a la limite inférieure { $minimum } : la limite inférieure du plan s'applique
exchange-warning-above-own-limit = n'est pas du plan, et au-dessus de la limite supérieure de son fichier, { $maximum }
exchange-warning-below-own-limit = n'est pas du plan, et au-dessous de la limite inférieure de son fichier, { $minimum }
exchange-warning-plan-differs-above = le fichier a la limite supérieure { $maximum } : la limite supérieure du plan s'applique
exchange-warning-plan-differs-nominal = le fichier a la cote nominale { $nominal } : la cote nominale du plan s'applique
exchange-warning-part-differs = le fichier nomme la pièce { $given } : elle est jugée comme { $part }, la pièce du plan
exchange-warning-found-by-number-of = aucun élément du plan ne s'appelle { $given } ; rattaché par le numéro à { $name } du plan
exchange-warning-found-by-place-of = aucun élément du plan ne s'appelle { $given } ; rattaché par la position à { $name } du plan
exchange-warning-found-by-number = rattaché par le numéro à { $name } du plan
exchange-warning-found-by-place = rattaché par la position à { $name } du plan
exchange-format-aqdef = Q-DAS AQDEF, en un fichier ou en .dfd et .dfx
exchange-format-calypso = tables de caractéristiques CALYPSO telles que NAME_chr.txt
exchange-format-calypso-text = rapports imprimés de CALYPSO enregistrés en texte
exchange-format-geopak = tolérances de MCOSMOS (GEOPAK) dans un fichier sans noms de colonnes
exchange-format-gauge = lignes d'instruments enregistrées dans un fichier, comme 01A+025.012
exchange-format-pcdmis = rapports texte de PC-DMIS
exchange-format-probed = impressions de macros de palpage, telles que Renishaw et les systèmes de FAO les écrivent
exchange-warning-unit-assumed = aucune unité donnée : les longueurs sans unité sont lues en mm
exchange-warning-unit-read = les longueurs sont lues en { $unit }, comme l'indique le fichier : { $text }
exchange-warning-rounded = { $given } a des chiffres au-delà du nanomètre : arrondi au nanomètre le plus proche
exchange-warning-rounded-values = { $count ->
        [one] { $count } valeur mesurée a des chiffres au-delà du nanomètre, à partir de cette ligne : elle est arrondie au nanomètre le plus proche
       *[other] { $count } valeurs mesurées ont des chiffres au-delà du nanomètre, à partir de cette ligne : elles sont arrondies au nanomètre le plus proche
    }
exchange-unjudged-quantity = { $quantity ->
        [102] circularité (K2009 est 102)
        [109] position (K2009 est 109)
        [117] une coordonnée (K2009 est 117)
       *[other] une autre grandeur qu'un diamètre (K2009 est { $quantity })
    } : pas une cote d'alésage ou d'arbre
exchange-unjudged-kind = non mesuré : { $kind ->
        [1] un nombre de pièces non conformes (K2004 est 1)
        [5] une feuille de défauts (K2004 est 5)
        [6] une feuille de défauts (K2004 est 6)
       *[other] un type de caractéristique inconnu (K2004 est { $kind })
    }
exchange-unjudged-attribute = non jugé : marqué par { $given } (K0002) ; seul 0 est connu pour marquer une valeur valable
exchange-unjudged-not-valid = non jugé : le fichier dit { $said }, il n'y a donc peut-être pas de valeur valable
exchange-unjudged-declaration = non jugé : la ligne { $declaration } de sa déclaration est inutilisable
exchange-format-qif = QIF 2.0, 2.1, 3.0 : résultats de logiciels de mesure, et plans
exchange-xml = XML mal formé : { $reason }
exchange-xml-doctype = un DOCTYPE n'est pas pris en charge : le supprimer, ou exporter le fichier sans lui
exchange-xml-entity = l'entité { $name } est inconnue : seules &lt; &gt; &amp; &quot; et &apos; sont prises en charge
exchange-xml-depth = limite de { $most } éléments imbriqués atteinte
exchange-xml-long = une balise ou un texte dépasse { $most } Kio
exchange-xml-mixed = { $name } a un élément au milieu de son texte
exchange-xml-cut-off = le fichier finit dans un élément : il est peut-être tronqué
exchange-xml-encoding = encodage inconnu { $given } : utiliser UTF-8, UTF-16 ou ISO 8859-1
exchange-xml-bytes = ces octets ne sont pas du texte dans l'encodage du fichier
exchange-qif-unit = unité de longueur { $unit } : le nom est inconnu, ou ne correspond pas au facteur ; utiliser mm, inch ou une autre unité avec son facteur vers le mètre
exchange-qif-no-unit = le fichier n'a pas d'unité de longueur : il lui faut FileUnits avec PrimaryUnits et LinearUnit
exchange-qif-reference = { $what } { $id } n'est pas dans le fichier
exchange-qif-too-many = le fichier a plus de { $most } éléments { $what }
exchange-qif-no-value = pas de valeur mesurée ici ; statut { $status }
exchange-qif-limit = limites ou cote nominale : { $reason }
exchange-qif-other-kind = la mesure est de type { $measured }, mais sa caractéristique est de type { $defined }
exchange-qif-several-values = la mesure a plusieurs valeurs
exchange-qif-defined-as-limit = DefinedAsLimit manque ou n'est ni vrai ni faux, les nombres peuvent donc être des limites ou des écarts
exchange-qif-no-nominal = les limites sont des écarts, mais il n'y a pas de cote nominale
exchange-qif-zone = la classe { $class } et { $zone } se contredisent : les majuscules sont les alésages, les minuscules les arbres
exchange-qif-no-results = un fichier QIF sans valeurs mesurées : un plan peut être lu comme plan de pièce
exchange-qif-no-characteristics = le fichier QIF ne déclare aucune caractéristique
exchange-warning-standard-uncertainty-not-used = le fichier indique une incertitude-type composée de { $standard } et une erreur moyenne de { $mean-error } : aucune règle ne les utilise, donner plutôt --u
exchange-warning-sheet-hidden = la feuille { $sheet } est lue, bien que masquée dans le classeur
exchange-warning-rows-hidden = { $count ->
    [one] la rangée { $rows } est masquée ou filtrée dans le classeur, mais est lue comme les autres
   *[other] { $count } rangées sont masquées ou filtrées dans le classeur, mais sont lues comme les autres : { $rows }
}
exchange-warning-columns-hidden = les colonnes masquées sont lues comme les autres : { $columns }
exchange-warning-qif-version = QIF version { $version } : ce programme est fait pour les versions 2.0, 2.1 et 3.0
exchange-warning-qif-count = { $list } annonce n={ $said }, mais en a { $found } : quelque chose peut manquer ou avoir été ajouté
exchange-warning-qif-twice = l'id { $id } est présent deux fois : le premier élément est utilisé
exchange-format-xlsx = mesures dans un classeur de tableur : colonnes comme en CSV
exchange-workbook = ce classeur ne peut pas être lu : { $reason }
exchange-not-a-workbook = un fichier ZIP, mais pas un classeur : le décompresser et donner les fichiers qu'il contient
exchange-old-workbook = un classeur au format { $format }, qui n'est pas pris en charge : l'enregistrer en XLSX
exchange-workbook-password = le classeur a un mot de passe : l'enregistrer sans
exchange-zip-cut-off = la fin du classeur manque : il est peut-être tronqué
exchange-zip-members = la liste des membres du classeur est endommagée ou a plus de { $most } entrées
exchange-zip-bomb = { $member } dépasse { $most } Mio une fois décompressé, ou est trop compressé pour un classeur : il n'est pas lu
exchange-zip-twice = deux membres du classeur ont le même nom, il a donc été modifié : l'ouvrir dans un tableur et l'enregistrer
exchange-zip-texts = le classeur a plus de { $most } textes différents
exchange-sheet-wide = la cellule { $cell } est au-delà des { $most } premières colonnes
exchange-too-many-cells = la feuille a plus de { $most } cellules
exchange-cell = { $cell } : { $reason }
exchange-formula-without-value = la valeur de la formule ={ $formula } n'est pas enregistrée : ouvrir le classeur dans un tableur et l'enregistrer
exchange-cell-split = la valeur de la cellule n'est pas enregistrée comme un seul texte simple, une partie seulement a donc pu être lue : ouvrir le classeur dans un tableur et l'enregistrer
exchange-cell-error = la cellule affiche { $error }
exchange-warning-sheets-left = la feuille { $sheet } est lue ; les autres ne le sont pas : { $left }
gauge-frame = les caractères qui encadrent la ligne ont été ignorés
gauge-channel = du canal { $channel }
gauge-inches = { $given } pouces
gauge-error-text = { $given } est peut-être un numéro d'erreur de l'instrument : si c'est une cote, l'écrire avec son unité, { $given } mm
gauge-opinion = l'instrument donne { $sign } ; les limites du plan décident

mapping-no-value = { $given } n'affecte aucune colonne : écrire un mot, = et une colonne, par exemple measured=3
mapping-word = { $given } n'est pas un contenu de colonne connu : sont admis { $allowed }
mapping-value = { $word } : { $given } est inconnu : sont admis { $allowed }
mapping-twice = { $word } est donné deux fois : le donner une seule fois
mapping-toml = pas une affectation de colonnes : { $reason }

# Comment une valeur a été jugée selon un plan, et ce qui a été donné à côté.
planned-rule = jugé selon la règle du plan au lieu de { $given } : { $rule }
planned-uncertainty = jugé avec l'incertitude du plan au lieu de celle donnée : { $u }
planned-material = corrigé à 20 °C avec la matière du plan au lieu de celle donnée : { $name }
planned-corrected = corrigé de { $temperature } °C à 20 °C (dilatation { $expansion } · 10⁻⁶/K)
planned-not-corrected = non corrigé à 20 °C : une position sur la pièce n'est pas une cote
planned-error-already-corrected = le fichier dit que la valeur est déjà à 20 °C : la juger sans température

## Gauges
gauge-no-unit = { $given } n'indique aucune unité : dire dans les réglages de l'instrument s'il envoie des millimètres ou des pouces
exchange-gauge-unit = la ligne { $line } de ces lignes d'instrument, { $given }, n'indique ni mm ni pouces : donnez l'unité avec import --columns unit=mm ou --columns unit=inch
gauge-other-form = { $given } diffère de la ligne apprise pour l'instrument, { $example }, par plus que ses chiffres
gauge-other-decimals = { $given } a { $decimals ->
        [one] { $decimals } décimale
       *[other] { $decimals } décimales
    }, et la ligne apprise pour l'instrument en a { $taught } : l'instrument envoie une autre unité, ou une partie du nombre s'est perdue
teach-zero = 0 peut être n'importe quel zéro de la ligne : prendre comme exemple une ligne d'une autre valeur
teach-not-text = { $line } contient des caractères qui ne sont pas du texte
teach-nowhere = { $value } mm ne figure pas dans la ligne { $line } : saisir la valeur que l'instrument affichait pour elle
teach-twice = { $value } mm figure plus d'une fois dans la ligne { $line } : prendre comme exemple une ligne d'une autre valeur
teach-other-unit = la ligne indique { $given }, ce qui ne fait pas { $value } mm : saisir la valeur que l'instrument affichait, en millimètres
