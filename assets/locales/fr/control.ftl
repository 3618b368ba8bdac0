# control

# Masques
mask-empty = le masque est vide
mask-too-large = le masque dépasse { $most } Kio
mask-unknown = { $found } n'est ni un enregistrement, ni un mot-clé, ni un commentaire
mask-unclosed-quote = le guillemet n'est pas fermé
mask-unknown-format = { $found } n'est pas un format : sont admis %S %RS %F %LF %D %I %%
mask-too-wide = { $found } est trop large : au plus { $most }
mask-count = { $formats } formats et { $parameters } paramètres
mask-unknown-parameter = { $found } n'est pas un paramètre : sont admis Q, QL, QR, QS avec un numéro, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = le ; à la fin manque
mask-unknown-word = { $word } est inconnu et n'a pas d'effet
mask-behind-semicolon = { $found } après le ; est ignoré
mask-other-languages = le masque a du texte pour { $languages } et aucun pour { $wanted }
mask-inverse-touching = { $first } et { $second } sont imprimés sans rien entre eux, la sortie ne peut donc pas être relue
mask-inverse-blanks = { $first } et { $second } sont des textes séparés seulement par des espaces, la sortie ne peut donc pas être relue : un texte peut contenir des espaces
mask-inverse-no-mark = aucun texte fixe ne marque le début d'un enregistrement, la sortie ne peut donc pas être relue
mask-inverse-too-long = le masque imprime plus de { $most } lignes à la fois : seuls des enregistrements plus courts peuvent être relus
mask-inverse-no-number = le masque n'imprime aucun nombre qui puisse être une valeur mesurée
mask-undefined = { $name } n'est pas défini
mask-text-as-number = { $name } est un texte, le format demande un nombre
mask-number-as-text = { $name } est un nombre, le format demande un texte
mask-not-finite = { $name } n'est pas un nombre fini
# Procès-verbaux de mesure
log-empty = le fichier est vide
log-no-log = pas un procès-verbal de mesure : aucune ligne de titre avec le numéro d'un cycle de mesure
log-too-long = le procès-verbal a plus de { $lines } lignes, ou une ligne de plus de { $bytes } octets
log-no-title = le procès-verbal n'a pas de ligne de titre, son cycle est donc inconnu
log-other-cycle = les procès-verbaux du cycle { $cycle } ne peuvent pas être lus, seulement ceux de { $known }
log-unit = le type de cote { $given } n'est ni 0 (mm) ni 1 (inch)
log-count = { $section } : { $expected } attendu, { $found } trouvé
log-missing = { $section } manque : le procès-verbal est tronqué ou incomplet
log-no-label = pas de libellé avant { $given }
log-cut-figure = le fichier finit dans cette valeur : { $given } est peut-être incomplet
log-swapped = le maximum { $maximum } est sous le minimum { $minimum }
log-uneven = les limites { $minimum } et { $maximum } ne sont pas symétriques par rapport à la valeur nominale { $nominal }
log-deviation = l'écart { $given } n'est pas valeur réelle moins valeur nominale, { $actual } - { $nominal }
log-not-positive = le diamètre { $given } n'est pas supérieur à 0
log-section-nominal = section des valeurs nominales
log-section-limits = section des valeurs limites
log-section-actual = section des valeurs réelles
log-section-deviations = section des écarts
log-no-unit = aucune ligne ne donne l'unité : millimètres supposés
log-no-time = la date et l'heure de la mesure sont inconnues
log-no-deviations = les écarts manquent : le procès-verbal est peut-être tronqué
log-ignored = ignoré : { $text }
log-text-before = le texte avant le premier procès-verbal a été ignoré

## Tables
table-empty = le fichier est vide
table-not-text = le caractère { $code } n'est pas du texte : le fichier n'est pas une table ou est endommagé
table-line-too-long = la ligne dépasse { $limit } octets
table-too-large = la table a plus de { $limit } cellules
table-too-many-columns = la table a plus de { $limit } colonnes
table-no-begin = une table commence par BEGIN et son nom, et non par { $found }
table-no-name = le nom de la table manque après BEGIN
table-unclosed-quote = un guillemet n'est pas fermé
table-unclosed-block = le bloc { $block } de la ligne { $line } n'est pas fermé
table-second-block = les colonnes sont décrites une seconde fois
table-unexpected = { $expected } attendu, { $found } trouvé
table-not-a-size = { $key } doit être un nombre entier jusqu'à { $limit }, et non { $text }
table-no-columns = la ligne avec les noms des colonnes manque
table-tab = caractère de tabulation : ne séparer les colonnes que par des espaces
table-column-twice = la colonne { $name } est présente deux fois
table-short-row = la rangée finit avant la colonne { $name } : la remplir d'espaces, ou écrire - pour aucune valeur
table-truncated = le fichier finit dans cette rangée et sans [END] : il est peut-être tronqué
table-text-after-end = texte après [END] : { $found }
table-no-end = [END] manque
table-no-lock = le tableau d'outils n'a pas de colonne TL : un outil cassé n'y est pas verrouillé
table-no-unit = la table n'indique pas son unité : ses longueurs ont été lues en millimètres
table-begin-word = { $word } n'a pas de signification connue dans la ligne BEGIN
table-width = la colonne { $name } a ici { $found } caractères mais { $described } dans la description ; la ligne des noms de colonnes s'applique
table-not-in-table = la colonne { $name } est décrite mais absente de la table
table-not-described = la colonne { $name } n'est pas décrite
table-skipped = { $name } est inconnu et a été ignoré
table-write-too-wide = rangée { $row }, colonne { $column } : { $text } ne tient pas en { $width } caractères
table-write-too-many-columns = la table a { $columns } colonnes ; une iTNC 530 en prend au plus { $limit }
table-write-too-long = les lignes de la table ont { $characters } caractères ; une iTNC 530 en prend au plus { $limit }
table-write-reads-otherwise = la table ne peut pas être écrite de façon à être relue à l'identique : vérifier les noms de la table et de ses colonnes

## Tables d'écarts
deviations-no-tables = aucune table d'écarts (*.tab avec une colonne BEREICH) dans ce dossier : { $folder }
tables-contradict = { $first } et { $second } se contredisent, { $class } au-delà de { $over } jusqu'à { $to } mm : { $one ->
        [none] aucune valeur
       *[other] { $one } µm
    } et { $other ->
        [none] aucune valeur
       *[other] { $other } µm
    } : supprimer la colonne dans l'une des deux
deviations-two-range-columns = la table a à la fois BEREICH et BEREIK : une seule colonne peut contenir les plages de cotes
deviations-inch = la table est en pouces : écrire les plages de cotes en millimètres et les écarts en micromètres
deviations-no-class = aucune colonne n'est une classe de tolérance telle que H7
deviations-odd-rows = le nombre de rangées est impair ({ $rows }) : chaque plage de cotes en prend deux, d'abord l'écart supérieur, puis l'écart inférieur
deviations-no-range = la fin de la plage de cotes manque
deviations-other-range = la plage de cotes jusqu'à { $end } mm a { $found } dans sa seconde rangée : la répéter ou laisser vide
deviations-column = colonne { $column } : { $error }
deviations-half = la colonne { $class } n'a que l'un des deux écarts pour la plage de cotes jusqu'à { $end } mm
deviations-touches = la colonne { $column } et sa voisine se touchent : les séparer par une espace
deviations-no-deviations = ignoré, pas une table d'écarts (sans colonne BEREICH) : { $file }
deviations-range-alias = BEREIK a été lu comme BEREICH
deviations-other-column = la colonne { $name } a été ignorée, car son nom ne peut pas être celui d'une classe de tolérance : une table écrite à partir de celle-ci ne l'a pas
deviations-no-numbers = la colonne { $name } a été ignorée, car elle contient des textes et aucun écart : une table écrite à partir de celle-ci ne l'a pas
deviations-mixed-case = la colonne { $name } a été ignorée, car une classe de tolérance ne mélange pas majuscules et minuscules : une table écrite à partir de celle-ci ne l'a pas

## Paramètres
no-parameter = { $given } n'est pas un paramètre : sont admis Q, QL, QR et QS avec un numéro

## Écriture de procès-verbaux de mesure
log-write-cycle = le cycle { $cycle } n'écrit pas ces valeurs
log-write-no-title = le procès-verbal du cycle { $cycle } n'a pas de titre dans { $file }
log-write-unit = un procès-verbal est en mm ou en pouces, pas en µm
log-write-character = { $given } ne peut pas être écrit : un procès-verbal ne peut pas contenir le caractère U+{ $code }
log-write-program = { $given } ne serait pas relu comme chemin d'un programme : écrire un chemin tel que TNC:\PART\CHECK.H
log-write-unfinished = le fichier finit dans une ligne : il est peut-être tronqué, rien n'y est donc ajouté
log-write-reads-otherwise = le procès-verbal ne peut pas être écrit de façon à être relu à l'identique : vérifier date, heure et autres résultats

## Procès-verbal du cycle 444
point-log-no-log = pas un procès-verbal du cycle 444 : la page ne contient aucune mesure lisible par machine
point-log-count = la page annonce { $expected } mesures, mais en contient { $found } : elle est tronquée ou a été modifiée
point-log-cut-off = la mesure n'a pas de fin : la page est tronquée
point-log-json = la mesure ne peut pas être lue : { $what }
point-log-version = la version { $version } du procès-verbal n'est pas prise en charge : { $known } ou antérieure attendue
point-log-normal = la normale { $given } n'a pas de direction : elle demande trois nombres qui ne sont pas tous nuls
point-log-deviation = l'écart { $given } sur { $axis } n'est pas coordonnée mesurée moins nominale, { $difference }
point-log-along = l'écart { $given } suivant la normale ne découle pas de ceux des axes, { $along }
point-log-band = l'écart supérieur { $upper } est sous l'écart inférieur { $lower }
point-log-status = le statut { $given } ne découle pas de l'écart et de la tolérance, { $status }
## Le tableau de palpeurs
probe-table-no-column = le tableau n'a pas de colonne { $column }
probe-table-no-probe = le tableau n'a aucun palpeur
probe-table-no-length = { $column } : { $error }
probe-table-too-small = { $column } = { $given } mm : doit être { $least }
probe-table-zero-or-more = 0 ou plus
probe-table-above-zero = supérieur à 0
probe-table-not-whole = { $column } = { $given } : nombre entier attendu
probe-table-twice = le palpeur { $number } est présent deux fois

## Le tableau d'outils
tool-table-no-column = le tableau n'a pas de colonne { $column }
tool-table-no-tool = le tableau n'a aucun outil
tool-table-touches = { $column } : la cellule déborde sur sa voisine, sa valeur est donc incertaine
tool-table-no-number = { $column } = { $given } : numéro d'outil de 0 à 32767 attendu, avec un indice tel que 5.1 ou sans
tool-table-twice = l'outil { $number } est présent deux fois
tool-table-name-too-long = NAME = { $given } : un nom a au plus { $most } caractères
tool-table-no-length = { $column } : { $error }
tool-table-out-of-range = { $column } = { $given } mm : { $least } à { $most } mm attendu
tool-table-no-lock = TL = { $given } : L ou 1 attendu pour un outil bloqué ; 0, - ou rien pour un outil libre
tool-table-not-whole = { $column } = { $given } : nombre entier attendu
tool-unknown = Q330 = { $tool } : cet outil n'est pas dans le tableau d'outils ; il a { $known }
tool-no-deviation = Q330 = { $tool } : le cycle { $cycle } n'a pas de limites ici, il n'y a donc pas d'écart pour corriger l'outil
tool-out-of-range = outil { $tool } : { $column } passerait de { $from } à { $to } mm : la plus grande valeur est { $most } mm dans les deux sens
tool-broken = erreur 1065 : l'outil { $tool } est cassé : { $column } changerait de { $by } mm, { $limit } est { $most } mm ; l'outil est bloqué et non corrigé
tool-broken-replacement = erreur 1065 : l'outil { $tool } est cassé : { $column } changerait de { $by } mm, { $limit } est { $most } mm ; l'outil est bloqué et non corrigé ; son outil jumeau est l'outil { $replacement }
tool-corrected = outil { $tool } : { $column } modifié de { $by } mm, de { $from } à { $to } mm
tool-corrected-rounded = outil { $tool } : { $column } modifié de { $by } mm, de { $from } à { $to } mm : le tableau conserve au plus proche 0,00001 in
tool-locked = outil { $tool } : bloqué, TL = { $to }

## Le procès-verbal d'un résultat de cycle
cycle-log-other-verdict = les valeurs du procès-verbal, arrondies à 0,0001 { $unit }, donnent { $log } où le cycle a donné { $cycle }

## La séquence d'un cycle de palpage
block-none = pas un cycle de palpage : une séquence commence par TCH PROBE et un numéro, ou par G785
block-inches = la séquence est d'un programme en pouces mais serait lue en mm : exécuter le programme
block-none-at = cette ligne n'est d'aucun cycle de mesure : ils commencent aux lignes { $blocks }
block-second = second cycle de palpage : en donner un seul à la fois ; le premier commence à la ligne { $first }
block-unknown-cycle = TCH PROBE { $given } : les cycles sont { $known }
block-not-a-parameter = { $given } n'est pas un paramètre : l'écrire comme { $example }
block-no-value = { $key } n'a pas de valeur
block-twice = { $key } est donné deux fois, d'abord à la ligne { $first }
block-unclosed-quote = un guillemet n'est pas fermé
block-behind-end = { $given } vient après la fin de la séquence : chaque ligne sauf la dernière finit par ~
block-too-many-parts = la ligne a plus de { $most } parties entre ~
block-cut-off = la séquence finit par ~, une ligne manque donc : elle est peut-être tronquée
block-reference = { $key } = { $given } : la valeur de { $given } n'est connue que pendant l'exécution d'un programme
block-not-writable = { $key } = { $given } : un texte dans une séquence ne peut contenir ni guillemets ni fins de ligne
block-unused = ligne { $line } : { $text } ne fait pas partie du cycle de palpage et a été ignoré
block-unused-more = ligne { $line } : { $text } ne fait pas partie du cycle de palpage et a été ignoré, et { $more } de plus
