# probing

# D'où vient une mesure, et ce qu'elle ne peut pas dire.
origin-simulated = simulé, cycle { $cycle }, graine { $seed }
origin-contacts = points de palpage de { $file }
origin-imported = importé de { $file }
origin-imported-simulation = importé de { $file }, simulé
origin-typed = saisi
caveat-only-a-diameter = un seul diamètre : forme et position sont inconnues
caveat-only-a-circle = diamètre et centre seulement : la forme est inconnue
caveat-three-contacts = 3 points de palpage : la forme ne peut pas être mesurée
caveat-four-contacts = 4 points de palpage : aucune forme au-delà de l'ovalité n'est détectée
caveat-few-contacts = { $contacts } points de palpage : la forme entre eux n'est pas détectée
caveat-short-arc = les points de palpage ne couvrent que { $arc }° : la dispersion est amplifiée sur le diamètre et le centre
caveat-two-point = le diamètre entre les points de palpage { $one } et { $other } est { $size } mm, au-delà de la limite de { $limit } mm, que le cercle moyen ne dépasse pas : par défaut, une cote s'applique entre deux points opposés quelconques
caveat-form = les rayons des points de palpage diffèrent de { $form } mm, les diamètres entre eux peuvent donc différer de plus que l'intervalle de { $zone } mm : deux points opposés peuvent être hors des limites
caveat-heights = les hauteurs des points de palpage diffèrent de { $spread } mm : sur un cône ou un axe incliné, cela change le diamètre
caveat-stated = la cote indique après la tolérance { $upper } et { $lower } µm, la tolérance a { $used-upper } et { $used-lower } µm : la tolérance a été utilisée ; vérifiez ce que veut le dessin
caveat-count = la cote vaut pour { $count } éléments : cette valeur est celle d'un seul
caveat-form-class = la classe { $class } de l'ISO 2768-2 concerne forme et position : la cote ne les montre pas
caveat-each-two-point = { $modifier } exige chaque taille entre deux points dans les limites : ceci n'est qu'un diamètre
caveat-mean-of-two-points = { $modifier } exige chaque taille entre deux points dans les limites : le diamètre des moindres carrés n'est que leur moyenne
caveat-not-least-squares = { $modifier } désigne la taille des moindres carrés : un seul diamètre ne la montre pas
caveat-one-section = { $modifier } désigne la taille des moindres carrés de tout l'élément : ceci est celle d'une section
caveat-envelope = { $modifier } exige l'enveloppe de forme parfaite à la dimension au maximum de matière : un diamètre ne montre pas si la surface la dépasse ; utilisez un calibre
caveat-other-size = { $modifier } désigne une autre taille que celle mesurée : un diamètre entre deux points ou des moindres carrés ne la prouve pas
caveat-condition = { $modifier } dit où ou comment la cote s'applique : la valeur mesurée ne montre pas si c'est respecté
contact-beyond-travel = le point de palpage { $number } est à { $distance } mm du départ de son palpage, et la bille parcourt au plus { $allowed } mm (DIST ou K, plus SET_UP du tableau de palpeurs et Q320) : vérifier que ces points sont de cet élément, dans cet ordre, et comptés depuis ce zéro
contact-missed = point de palpage { $number } : le palpeur n'a rien rencontré sur la course de palpage
contact-no-height = le point de palpage { $number } n'a pas de hauteur : ajouter une colonne z au fichier
contact-used-up = point de palpage { $number } : le fichier n'a que { $available ->
    [one] { $available } point de palpage
   *[other] { $available } points de palpage
    }

cycle-out-of-range = { $key } { $name } = { $given } : { $allowed }
cycle-length-range = au moins { $least } mm, au plus { $most } mm
cycle-angle-range = au plus { $most } dans les deux sens
cycle-angle-size-range = au moins { $smallest } en valeur absolue, au plus { $most }
cycle-one-of = une valeur parmi { $allowed } est attendue
cycle-tool-range = un numéro d'outil de 0 à 99999.9, ou un nom d'outil d'au plus 255 caractères
cycle-not-a-value = { $key } { $name } : { $error }
cycle-tool-no-name = { $text } n'appelle aucun outil : écrire son numéro ou son nom
cycle-tool-empty = aucun outil n'est nommé : pour aucun, écrire Q330=0
cycle-tool-unquoted = { $text } n'est pas un nombre, et un nom d'outil se met entre guillemets
cycle-no-diameter = { $key } { $name } = 0 mm : un cercle demande un diamètre supérieur à 0
cycle-one-limit = { $given } est donné sans { $missing } : 0 serait l'autre limite
cycle-missing = { $key } { $name } manque
cycle-no-such-parameter = le cycle { $cycle } n'a pas de paramètre { $parameter } : ses paramètres sont { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm est au-dessus de { $maximum-key } = { $maximum } mm : la cote minimale est au-dessus de la cote maximale
cycle-too-large = le cercle mesuré est trop grand : { $error }
workpiece-cannot-be = { $what } = { $given } : au moins { $least }, au plus { $most }

# Palpages.
contact-in-material = point de palpage { $number } : la course de palpage commence dans la matière
contact-in-feature = point de palpage { $number } : la course de palpage commence dans la matière de { $feature }
contact-behind = point de palpage { $number } : la bille atteint la paroi de { $feature } par derrière, et l'épaisseur de la matière y est inconnue
contact-ambiguous = point de palpage { $number } : la bille rencontre { $feature } et { $other } au même endroit, on ne sait donc pas lequel est mesuré

# Évaluation du cercle.
circle-too-few = un cercle demande au moins 3 points de palpage, { $contacts } trouvés
circle-coinciding = les points de palpage { $first } et { $second } coïncident à x = { $x }, y = { $y } : un cercle demande 3 points différents
circle-collinear = les { $contacts } points de palpage sont tous sur une même droite : aucun cercle n'y passe
circle-straight = une droite s'ajuste mieux aux { $contacts } points de palpage que tout cercle
circle-not-finite = point de palpage { $contact } : { $axis } = { $value } n'est pas un nombre fini
circle-too-large = { $what } = { $value } mm est trop grand : au plus { $most } mm dans les deux sens
circle-part-contact = point de palpage { $contact } : { $axis }
circle-part-diameter = diamètre
circle-part-centre = centre { $axis }
circle-three-contacts = 3 points de palpage : la forme ne peut pas être mesurée, le résidu est toujours nul
circle-four-contacts = 4 points de palpage : quatre lobes ne sont pas détectés et changent le diamètre
circle-short-arc = les points de palpage ne couvrent que { $arc }° d'arc : la dispersion sur le diamètre est { $factor } fois celle de 3 points à 120°
circle-circumscribed-of-short-arc = le cercle minimal circonscrit d'un arc court n'est pas la cote de l'élément
circle-counts-twice = les points de palpage { $first } et { $second } coïncident : cet endroit compte deux fois
circle-no-inscribed = pas de cercle maximal inscrit : les points de palpage n'en entourent aucun
circle-no-zone = pas de zone minimale : une bande droite est plus étroite que tout anneau
circle-too-many-contacts = le cercle maximal inscrit et la zone minimale ne sont pas calculés pour { $contacts } points de palpage : au plus { $most }
circle-short-chord = les points de palpage { $first } et { $second } sont opposés mais à côté du centre : cette cote est { $short } µm trop petite
circle-more-of-a-kind = il en va de même pour { $more } de plus
circle-apart = le point de palpage { $contact } est à { $apart } mm du cercle, bien plus que les autres : poussière ou faux déclenchement ?
circle-heights = les hauteurs des points de palpage diffèrent de { $spread } mm : sur un cône ou un axe incliné, cela change le diamètre

## Cycles de mesure : erreurs, résultats, remarques
contact-out-of-reach = point de palpage { $number } : le palpeur n'a rien rencontré sur la course de palpage de { $longest } mm
cycle-number-range = un nombre, au plus { $most } dans les deux sens
cycle-count-range = un nombre entier de 0 à { $most }
cycle-band-range = une tolérance telle que 0.4-0.1, 0.4 ou -0.1 ; 0 signifie sans tolérance
cycle-range = { $range }
cycle-range-tool = 0 … { $highest }, ou au plus { $longest } caractères
cycle-range-band = 0.4-0.1, 0.4, -0.1 ou rien
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = sans tolérance
cycle-no-global = { $key } { $name } = PREDEF : aucun GLOBAL DEF ne donne de valeur
cycle-no-path = { $key } { $name } = 0 mm : une course de palpage demande une longueur ; son signe donne le sens
cycle-no-transfer = { $row-key } = { $row } avec { $key } = -1 : il n'est pas indiqué dans quel tableau est cette ligne ; { $key } doit être 0 ou 1 (une commande signale l'erreur 1078)
cycle-other-feature = { $key } { $name } = { $given } : la classe ne correspond pas à { $geometry } : les majuscules valent pour un alésage, les minuscules pour un tenon
cycle-not-measured = { $key } { $name } = { $given } : le cycle ne mesure pas cette valeur : écrivez-la sans tolérance
cycle-inch-tolerance = { $key } { $name } = { $given } : dans un programme en pouces, l'unité d'une tolérance n'est pas connue : écrivez un programme en mm, ou le nombre sans tolérance
cycle-no-edge = { $first } et { $second } sont identiques : une arête demande deux points le long d'elle
cycle-no-sphere = les points de palpage ne déterminent pas de sphère
cycle-no-rotation = { $key } { $name } : Fitcheck ne suit qu'une rotation de base (Q1121 = 1), et sans correction (Q1120 = 0)
cycle-no-normal = { $first }, { $second } et { $third } sont tous 0 : une normale demande une direction
cycle-apart = point de palpage { $contact } : ses deux palpages sont à { $difference } mm l'un de l'autre, { $key } admet { $most } mm
cycle-too-far = la coordonnée mesurée est trop grande : { $error }
cycle-stop = arrêt du programme par Q309 = { $setting } : { $out }
check-within = { $what } { $measured } mm est dans { $minimum } à { $maximum } mm
check-above = { $what } { $measured } mm est au-dessus de son maximum { $maximum } mm : { $status }
check-below = { $what } { $measured } mm est sous son minimum { $minimum } mm : { $status }
check-and = { $one } ; { $other }
found-centre-1 = centre mesuré, 1er axe
found-centre-2 = centre mesuré, 2e axe
found-centre-3 = centre mesuré, 3e axe
found-diameter = diamètre mesuré
found-centre-deviation-1 = écart du centre, 1er axe
found-centre-deviation-2 = écart du centre, 2e axe
found-centre-deviation-3 = écart du centre, 3e axe
found-diameter-deviation = écart du diamètre
found-coordinate = coordonnée mesurée
found-coordinate-deviation = écart de la coordonnée
found-position-1 = position mesurée, 1er axe
found-position-2 = position mesurée, 2e axe
found-position-3 = position mesurée, 3e axe
found-angle = angle mesuré
found-deviation-1 = écart, 1er axe
found-deviation-2 = écart, 2e axe
found-deviation-3 = écart, 3e axe
found-deviation-along = écart suivant la normale
found-second-position-1 = 2e point : position mesurée, 1er axe
found-second-position-2 = 2e point : position mesurée, 2e axe
found-second-position-3 = 2e point : position mesurée, 3e axe
found-second-deviation-1 = 2e point : écart, 1er axe
found-second-deviation-2 = 2e point : écart, 2e axe
found-second-deviation-3 = 2e point : écart, 3e axe
found-second-diameter = 2e cercle : diamètre mesuré
found-second-diameter-deviation = 2e cercle : écart du diamètre
found-rotation = rotation mesurée
found-side-1 = longueur mesurée, 1er côté
found-side-2 = longueur mesurée, 2e côté
found-width = largeur mesurée
found-centre-line = position de la ligne médiane
found-side-deviation-1 = écart du 1er côté
found-side-deviation-2 = écart du 2e côté
found-width-deviation = écart de la largeur
found-good = dans la tolérance
found-rework = retouche
found-scrap = rebut
found-status = statut : -1 non défini, 0 bon, 1 retouche, 2 rebut
cycle-note-machine-builder = le constructeur de la machine doit activer et adapter ce cycle : voir le manuel de la machine
cycle-note-not-on-itnc530 = une iTNC 530 n'a pas ce cycle ; TNC 320, TNC 620, TNC 640 et TNC7 l'ont
cycle-note-normal-from-cad = reprendre la normale d'un système CAO ou FAO
cycle-note-software-option = la commande demande l'option logicielle { $option }
cycle-note-recommended = là où la commande a le cycle { $cycle }, HEIDENHAIN le recommande à la place
cycle-note-ends-rotation = met fin à une rotation de base active
remark-without-effect = { $key } est accepté mais n'a pas d'effet
remark-tool-not-monitored = Q330 = { $tool } : l'outil n'est pas surveillé : pas de tableau d'outils
remark-outside-dimension = une cote extérieure est supposée : au-dessus du maximum retouche, sous le minimum rebut
remark-nominal-outside-limits = le diamètre nominal { $nominal } mm n'est pas entre les limites : une TNC7 le refuse
remark-nominal-width-outside-limits = la largeur nominale { $nominal } mm n'est pas entre les limites : une TNC7 le refuse
remark-nominal-coordinate-outside-limits = la coordonnée nominale { $nominal } mm n'est pas entre les limites : selon son manuel, une TNC7 peut le refuser
remark-contact-astray = { $count ->
    [one] le point de palpage { $contact } est à { $distance } mm de l'endroit que palpe le cycle : il est peut-être d'un autre élément
   *[other] { $count } points de palpage sont à l'écart de l'endroit que palpe le cycle, le point { $contact } de { $distance } mm : ils sont peut-être d'un autre élément
}
remark-deviation-without-parameter = l'écart n'a pas de paramètre ici : le manuel dit qu'une commande le mémorise, mais pas dans lequel
remark-new-datum = nouveau point d'origine, { $target } : { $axes } mm (mesuré → voulu)
datum-target-display = actif aussitôt
datum-target-active = correction du point d'origine actif
datum-target-preset = ligne { $row } du tableau de points d'origine
datum-target-table = ligne { $row } du tableau de points zéro
remark-new-rotation = nouvelle rotation de base de { $angle } : { $target }
remark-axis-turned = l'axe { $axis } tourne la pièce de { $angle } : seule la machine sait où est son centre, et Fitcheck n'écrit son zéro dans aucun tableau
remark-variable-holds-diameter = #i99 est lu comme le diamètre : le manuel ne dit pas quelle valeur il contient
remark-no-tolerance = { $key } n'est pas une tolérance : rien n'est jugé

## La machine simulée
workpiece-file-toml = ligne { $line } : { $said }
workpiece-file-too-large = un fichier de pièce a au plus { $most } Kio
workpiece-file-not-one = le fichier a { $found } de { $tables } : il en faut exactement une
workpiece-file-cannot-be = ligne { $line } : { $error }
workpiece-file-several = le fichier a des tables [[feature]] : une pièce à une seule surface est attendue ici
workpiece-file-too-many = une pièce a au plus { $most } éléments
workpiece-file-feature = ligne { $line }, colonne { $column } : { $feature } : { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } n'est pas un type d'élément : les types sont { $known }
feature-fault-no-key = { $kind } demande { $key }
feature-fault-other-key = { $kind } : la clé { $key } n'existe pas pour ce type
feature-fault-name = un nom a 1 à { $most } caractères sur une ligne
feature-fault-same-name = un autre élément a le même nom

# Grandeurs de la pièce simulée, telles que les erreurs les nomment.
figure-temperature = température
figure-expansion = dilatation
figure-probe-scatter = dispersion du palpeur
figure-ball-radius = rayon de la bille
figure-calibration-error = erreur d'étalonnage
figure-offset = décalage
figure-lobing = amplitude de précourse
figure-lobing-angle = angle de précourse
figure-lobing-count = lobes de la précourse
figure-centre-x = centre x
figure-centre-y = centre y
figure-diameter = diamètre
figure-surface-scatter = dispersion de surface
figure-ovality = ovalité
figure-ovality-angle = angle d'ovalité
figure-ovality-count = nombre d'ovalités
figure-lobe-height = hauteur des lobes
figure-lobe-angle = angle des lobes
figure-lobes = lobes
figure-point = point
figure-normal = normale
figure-normal-length = longueur de la normale
figure-wave-length = longueur d'onde
figure-wave-amplitude = amplitude d'onde
figure-wave-direction = direction d'onde
figure-deviation = écart
figure-radius = rayon
figure-width = largeur
figure-first-length = 1re longueur
figure-second-length = 2e longueur
figure-angle = angle
figure-top = dessus
figure-bottom = fond
figure-length = longueur des parois
figure-reach = portée
figure-stylus-radius = rayon de la tige de palpage

## Ce qui touche, du palpeur.
mover-ball = bille
mover-stylus = tige de palpage
