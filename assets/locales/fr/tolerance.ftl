# tolerance

## Longueurs
length-empty = une longueur manque
length-not-a-number = { $text } n'est pas un nombre
length-ambiguous = { $text } est ambigu : écrire un seul séparateur décimal et aucun séparateur de milliers
length-too-fine = { $text } est plus fin qu'un nanomètre
length-too-large = { $text } est trop grand : au plus { $max } mm dans les deux sens

## Cotes tolérancées et classes
callout-empty = une cote tolérancée manque : écrire une cote nominale et une classe de tolérance, par exemple 25 H7
callout-no-nominal = { $text } ne commence pas par une cote nominale : en écrire une, par exemple 25 H7
callout-nominal = cote nominale : { $error }
callout-not-positive = la cote nominale { $nominal } mm n'est pas supérieure à 0
class-missing = une classe de tolérance manque, par exemple H7 pour un alésage ou h7 pour un arbre
class-mixed-case = { $text } mélange majuscules et minuscules : écrire { $upper } pour un alésage ou { $lower } pour un arbre
class-malformed = { $text } n'est pas une classe de tolérance : écrire des lettres et un degré, par exemple H7 ou js13

## Écarts et limites
deviations-order = l'écart supérieur { $upper } mm est sous l'écart inférieur { $lower } mm
nominal-by-operator = ? signifie que l'opérateur positionne le palpeur : écrivez la valeur nominale sans ce signe
nominal-not-probed = @ signifie que la commande ne palpe pas et reprend la valeur qui suit : rien ne serait mesuré
source-choice-iso286 = ISO 286, toutes les classes jusqu'à 3150 mm
source-choice-control = Les tables de la commande, 47 classes jusqu'à 400 mm
source-choice-after-own = Tables personnelles, puis { $base }
source-iso286 = ISO 286, plus de { $over } à { $to } mm
source-iso286-remark = ISO 286, plus de { $over } à { $to } mm ; { $remark }
source-shipped-table = table intégrée { $name }, plus de { $over } à { $to } mm
source-table = table { $name }, plus de { $over } à { $to } mm
figure-own-table = { $class } au-delà de { $over } jusqu'à { $to } mm : la table { $table } diffère d'ISO 286, qui donne { $upper } et { $lower } mm
figure-standard = { $class } au-delà de { $over } jusqu'à { $to } mm : { $why }
source-file = fichier { $name }
source-iso2768 = ISO 2768-1 classe { $class }, plus de { $over } à { $to } mm
source-callout = la cote tolérancée elle-même
source-without-own = { $source } ; les tables personnelles de { $folder } n'ont pas pu être lues
source-recorded = { $text }
limits-own-awaited = Les tables personnelles de { $folder } sont en cours de lecture
limits-no-feature = { $callout } ne dit pas s'il s'agit de l'alésage ou de l'arbre
limits-other-feature = { $feature ->
    [hole] { $class } est une classe d'alésage et non une classe d'arbre
   *[shaft] { $class } est une classe d'arbre et non une classe d'alésage
}
limits-other-case = { $feature ->
    [hole] { $class } est une classe d'alésage, absente de la table { $table } ; la classe d'arbre est { $other }
   *[shaft] { $class } est une classe d'arbre, absente de la table { $table } ; la classe d'alésage est { $other }
}
limits-unknown-class = { $class } n'est pas dans la table { $table } ; elle a { $known }
limits-no-own-table = { $class } n'est pas une classe de tolérance ISO 286 : écrire des lettres et un degré, par exemple H7 ou js13, ou choisir des tables personnelles avec une colonne { $class }
limits-no-own-column = { $class } n'est pas une classe de tolérance ISO 286, et la table { $table } n'a pas de colonne { $class } : elle a { $known }
limits-beyond-last-range = la cote nominale { $nominal } mm dépasse la table { $table }, dont la dernière plage va au-delà de { $over } jusqu'à { $to } mm inclus
limits-not-defined = { $class } n'est pas définie au-delà de { $over } jusqu'à { $to } mm dans la table { $table } ; { $where }
limits-defined-nowhere = elle n'est définie pour aucune cote
limits-defined = elle est définie { $ranges }
limits-range = au-delà de { $over } jusqu'à { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = les limites de { $nominal } mm sont trop grandes

## Intervalles hors de toute proportion
zone-micrometres = un intervalle de { $width } mm est sans proportion avec { $nominal } mm, dont IT 18 est { $widest } mm : si les écarts sont en micromètres, écrire { $offer }
zone-wide = un intervalle de { $width } mm est sans proportion avec { $nominal } mm, dont IT 18 est { $widest } mm : vérifier la cote nominale et les limites
zone-micrometres-to-zero = la limite minimale { $minimum } mm n'est pas supérieure à 0 : si les écarts sont en micromètres, écrire { $offer }
zone-to-zero = la limite minimale { $minimum } mm n'est pas supérieure à 0 : vérifier la cote nominale et les limites
zone-coordinate-micrometres = un intervalle de { $width } mm dépasse { $widest } mm, le maximum pour une coordonnée : si les écarts sont en micromètres, écrire { $offer }
zone-coordinate = un intervalle de { $width } mm dépasse { $widest } mm, le maximum pour une coordonnée : vérifier les limites

shape-no-ranges = la table n'a aucune plage de cotes
shape-not-ascending = la plage jusqu'à { $end } mm ne finit pas au-dessus de la précédente, { $before } mm
shape-cells = la colonne { $class } a { $cells } cellules pour { $ranges } plages
shape-twice = la colonne { $class } est présente deux fois

## Verdicts
status-good = BON
status-accepted = ACCEPTÉ
status-rework = RETOUCHE
status-re-measure = REMESURER
status-out-of-limits = HORS TOLÉRANCE
status-scrap = REBUT
rule-simple = sans bande de garde, les limites font partie de l'intervalle
rule-iso14253-2017 = ISO 14253-1:2017, conformité 95 %, { $prover ->
    [customer] le client prouve la non-conformité
   *[supplier] le fournisseur prouve la conformité
    } ; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, bande de garde U, { $prover ->
    [customer] le client prouve la non-conformité
   *[supplier] le fournisseur prouve la conformité
    } ; { $u }
rule-ilac-g8 = ILAC-G8, bande de garde { $factor } U, { $prover ->
    [customer] le client prouve la non-conformité
   *[supplier] le fournisseur prouve la conformité
    } ; { $u }
rule-asme-simple = ASME B89.7.3.1, acceptation simple 4:1 ; { $u }
rule-asme-stringent = ASME B89.7.3.1, acceptation stricte, bande de garde { $factor } U ; { $u }
rule-asme-relaxed = ASME B89.7.3.1, acceptation assouplie de { $factor } U ; { $u }
rule-fixed = bande de garde { $width } µm, { $prover ->
    [customer] le client prouve la non-conformité
   *[supplier] le fournisseur prouve la conformité
    }
rule-no-uncertainty = la règle { $rule } demande l'incertitude de la valeur mesurée
rule-no-factor = la règle { $rule } n'a pas de facteur
rule-no-width = la règle { $rule } calcule sa bande de garde à partir de l'incertitude
rule-width-missing = la règle { $rule } demande une bande de garde supérieure à 0 µm
rule-no-prover = la règle { $rule } ne dépend pas de la charge de la preuve
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = une incertitude doit être supérieure à 0 µm
uncertainty-factor = facteur d'élargissement { $given } : nombre de 1 à 10 attendu, avec au plus trois décimales
uncertainty-by-budget = u de chaque valeur selon le bilan
undecided-contacts = avec ces { $contacts } points de palpage, le diamètre est { $times } fois plus incertain qu'avec { $contacts } points répartis sur le cercle entier, mais l'incertitude donnée ne vaut que jusqu'à 3 fois : répartir les points sur un arc plus long, ou donner un bilan
doubt-times-inch = la valeur mesurée est 25,4 fois la cote nominale : a-t-elle été convertie deux fois depuis des pouces ?
doubt-inches = la valeur mesurée est la cote nominale divisée par 25,4 : est-elle en pouces ?
doubt-double = la valeur mesurée est le double de la cote nominale : un diamètre a-t-il été pris pour un rayon ?
doubt-half = la valeur mesurée est la moitié de la cote nominale : est-ce un rayon ?
doubt-decimal-sign = la valeur mesurée est proche de la cote nominale, au séparateur décimal près : est-ce { $meant } mm ?
doubt-far = la valeur mesurée est à { $distance } mm hors des limites : est-ce bien cette pièce, en millimètres ?
doubt-implausible = la valeur mesurée est hors de ce que le plan dit possible, { $lower } à { $upper } mm : l'unité et le séparateur décimal sont-ils justes ?

## Fichiers
file-is-folder = c'est un dossier et non un fichier : { $path }
file-missing = fichier ou dossier introuvable : { $path }
file-exists = un fichier ou dossier de ce nom existe déjà : { $path }
file-half-set = l'écriture d'un ensemble de fichiers s'est arrêtée en cours, si bien que le dossier contient des fichiers anciens et nouveaux : écrire l'ensemble de nouveau pour la terminer ; ce qui reste à déplacer est dans { $path }
file-not-a-file = c'est un tube ou un périphérique et non un fichier : { $path }
file-changed = le fichier a changé pendant la lecture ; le relire : { $path }
file-busy = le fichier est ouvert dans un autre programme : le fermer là-bas et réessayer : { $path }
file-stopped = arrêté, rien n'a été écrit : { $path }
file-too-large = le fichier dépasse { $limit } Mio : { $path }
file-system = { $reason } : { $path }

## ISO 286
iso286-grade-missing = { $class } n'est pas une classe de tolérance ISO 286 : écrire des lettres et un degré, par exemple H7 ou js13
iso286-no-grade = { $class } n'est pas une classe de tolérance ISO 286 : les degrés sont { $grades }
iso286-no-letter = { $class } n'est pas une classe de tolérance ISO 286 : la lettre { $letters } n'existe pas, seulement { $known }
iso286-too-large = la cote nominale { $nominal } mm dépasse ISO 286, qui finit à 3150 mm
iso286-not-here = { $class } n'est pas définie à { $nominal } mm dans ISO 286 ; { $where }
iso286-js-rounded = JS arrondi comme en 1988
iso286-contested-ef = contesté : ef vaut 28 µm ici, d'autres sources donnent 25 µm
iso286-older-it5 = à titre d'essai ; les anciens catalogues ont ici un IT5 plus petit
iso286-trial-use = à titre d'essai

## Ajustements
fit-kind-clearance = ajustement avec jeu
fit-kind-transition = ajustement incertain
fit-kind-interference = ajustement avec serrage
fit-basis-hole = alésage normal
fit-basis-shaft = arbre normal
fit-basis-both = alésage normal et arbre normal
fit-preferred-hole-basis = ajustement recommandé, alésage normal
fit-preferred-shaft-basis = ajustement recommandé, arbre normal
fit-function-loose-running = tournant très libre
fit-function-free-running = tournant libre
fit-function-close-running = tournant juste
fit-function-sliding = glissant
fit-function-locational-clearance = positionnement avec jeu
fit-function-locational-transition = positionnement incertain
fit-function-locational-transition-tighter = positionnement incertain, plus serré
fit-function-locational-interference = positionnement avec serrage
fit-function-medium-drive = serré moyen
fit-function-force = serré à la presse
fit-one-sided = { $callout } n'est pas un ajustement : écrire une cote, une classe d'alésage et une classe d'arbre, par exemple 25 H7/g6
fit-not-a-hole = { $minimum } à { $maximum } mm sont les limites d'un arbre : celles d'un alésage sont attendues
fit-not-a-shaft = { $minimum } à { $maximum } mm sont les limites d'un alésage : celles d'un arbre sont attendues
fit-nominal-sizes = un ajustement a une seule cote nominale : l'alésage a { $hole } mm, l'arbre { $shaft } mm
fit-too-large = le jeu est trop grand
fit-search-order = le jeu minimal { $minimum } mm est au-dessus du jeu maximal { $maximum } mm
fit-search-no-classes = les tables n'ont pas de classes d'alésage et d'arbre à { $nominal } mm
fit-thermal-too-fine = { $text } a plus de trois décimales
fit-thermal-temperature = une température de { $text } °C est hors plage : de −273,15 à 1000 °C
fit-thermal-expansion = une dilatation de { $text } est hors plage : de −20 à 500, en millionièmes par kelvin, par exemple 11,5 pour l'acier
fit-thermal-expansion-unit = une dilatation de { $text } est dans une autre unité : les dilatations sont en millionièmes par kelvin ; écrire { $meant }

## Températures douteuses
thermal-doubt-fahrenheit = { $given } °C est loin de toute température à laquelle on mesure des pièces : si elle est en degrés Fahrenheit, écrire { $meant }
thermal-doubt-kelvin = { $given } °C est loin de toute température à laquelle on mesure des pièces : si elle est en kelvins, écrire { $meant }
thermal-doubt-far = { $given } °C est loin de toute température à laquelle on mesure des pièces, { $least } à { $most } °C : à vérifier
thermal-doubt-beyond = { $given } °C est hors de { $least } à { $most } °C, où vaut une dilatation de { $expansion } millionièmes par kelvin : donner la dilatation à cette température

## Matières
material-published = valeur publiée
material-verify = valeur usuelle, à vérifier
material-own = valeur saisie
material-toml = { $reason }
material-version = la version { $found } du fichier de matières n'est pas prise en charge : version { $known } attendue
material-too-many = { $count } matières, c'est trop : au plus { $most }
material-too-large = un fichier de matières a au plus { $most } octets
material-name = le nom d'une matière a 1 à { $longest } caractères, sans caractère de commande
material-range = une plage de températures commence par la plus basse : écrire deux nombres en °C, par exemple [-50, 200]
material-elastic = modulus et poisson vont ensemble : modulus de 1 à 1200000 MPa, poisson de 0 à 0.5, yield de 1 à 10000 MPa
material-twice = la matière { $name } est définie deux fois
material-unknown = matière inconnue { $name } : choisir parmi { $known }, ou donner la dilatation elle-même, par exemple 11,5
## Cotes tolérancées : écarts, limites, ajustements et tolérances générales
callout-at = { $reason } (caractère { $at })
callout-no-tolerance = une tolérance manque, par exemple H7, h7, H7/g6, m, +0,1 -0,2 ou ±0,1
callout-general-capital = { $capital } n'a pas de degré : écrire { $offer } pour la tolérance générale ISO 2768-1, ou ajouter un degré, par exemple { $capital }7
callout-fit-order = l'arbre est devant l'alésage : écrire { $offer }
callout-fit-side = { $first } et { $second } ne sont pas un alésage et un arbre : un ajustement s'écrit en majuscules, puis en minuscules, par exemple 25 H7/g6
callout-number = { $part } : { $error }
callout-not-a = { $part } attendu, { $found } trouvé : { $how }
callout-missing = { $part } : valeur manquante ; { $how }
callout-part-deviation = écart
callout-part-limit = nombre de cote limite
callout-part-actual = nombre après @
callout-how-deviation = écrire un signe et un nombre, par exemple +0,1 ou -0,1
callout-how-limit = écrire deux cotes, la plus grande d'abord, par exemple 12,01/11,985
callout-how-actual = écrire un nombre, par exemple 10H7@10,004
callout-no-sign = { $number } n'a pas de signe : écrire +{ $number } ou -{ $number } pour un écart, sans espace dans le nombre
callout-no-unit = { $number } n'a pas d'unité et l'autre écart est en µm : écrire l'unité après les deux
callout-deviation-order = l'écart inférieur est devant l'écart supérieur : écrire { $offer }
callout-limits-order = la plus petite limite est devant la plus grande : écrire { $offer }
callout-limits-apart = { $larger } mm est plus du double de { $smaller } mm, ce ne sont donc sans doute pas des limites : écrire des écarts, par exemple 12 +0,2 0
callout-limits-or-deviation = c'est ambigu : écrire { $limits } pour des cotes limites ou { $deviation } pour un écart inférieur
callout-limits-meant = un tel écart ne laisserait aucune cote : écrire { $limits } pour des cotes limites
callout-minimum-not-positive = la limite minimale { $minimum } mm n'est pas supérieure à 0
callout-micrometres-meant = la limite minimale { $minimum } mm n'est pas supérieure à 0 : si les écarts sont en micromètres, écrire { $offer }
callout-mixed-decimals = { $number } a un autre séparateur décimal que le nombre précédent : en utiliser un seul
callout-cycle-sign = { $sign } est destiné aux textes des cycles 14xx, et non à une cote tolérancée
callout-not-in-cycle-text = { $found } ne peut pas figurer dans un texte des cycles 14xx : écrire une classe, une classe générale ou des écarts
callout-too-much = { $found } n'est pas attendu ici : le texte est complet sans cela
callout-too-long = le texte est trop long : au plus { $most } caractères
callout-band-order = l'écart inférieur est devant l'écart supérieur : écrire QS400 ainsi : 0.4-0.1
callout-lone-order = l'écart inférieur est devant l'écart supérieur : écrire { $offer }
callout-inch = { $given } font { $nominal } mm : les cotes sont en millimètres, écrivez { $offer }
callout-inch-size = { $given } font { $nominal } mm : écrivez la cote et la tolérance en millimètres
callout-inch-somewhere = { $given } est en pouces : écrivez la cote et la tolérance en millimètres, 1 pouce fait 25.4 mm
callout-thread = { $given } est un filetage, pas un alésage ou arbre lisse : écrivez le diamètre intérieur ou sur flancs avec ses deux limites, comme 5.153/4.917
callout-exact = une cote théoriquement exacte n'a pas de tolérance propre : écrivez la cote avec les limites qui s'y appliquent, comme 25 ±0.1
callout-reference = une cote entre parenthèses est auxiliaire et n'a pas de tolérance : écrivez-la sans parenthèses si elle doit être jugée
callout-one-sided = { $given } n'a qu'une limite : écrivez les deux limites, la plus grande d'abord, comme 8.2/8
callout-roughness = { $given } est une rugosité, pas une cote : écrivez une cote avec sa tolérance, comme 25 H7
callout-modifier = { $given } n'est pas un modificateur de l'ISO 14405-1 : les modificateurs sont { $known }
callout-grade = { $given } n'est pas défini à { $nominal } mm : écrivez un degré de IT1 à IT18 que l'ISO 286 y définit
callout-ansi = { $class } est une classe de l'ANSI B4.1, dont Fitcheck n'a pas les tables : écrivez une classe ISO 286, ou la cote et les écarts en millimètres
callout-stated-micrometres = les écarts placés après la tolérance sont hors de proportion avec { $nominal } mm : s'ils sont en micromètres, écrivez ({ $offer })
callout-stated-of-fit = des écarts placés après un ajustement peuvent concerner l'une ou l'autre pièce : écrivez-les après chaque classe
iso286-grade-alone = { $class } est un degré : il dit la largeur d'une zone, mais pas sa position ; écrivez ±{ $grade }/2 ou une classe, comme H7
general-too-small = la cote nominale { $nominal } mm est sous { $first } mm, où commence ISO 2768-1 : écrire les écarts à côté de la cote
general-too-large = la cote nominale { $nominal } mm dépasse ISO 2768-1, qui finit à { $last } mm
general-not-defined = ISO 2768-1 ne définit pas la classe { $class } { $range } ; elle est définie { $defined }
general-range-from = de { $over } jusqu'à { $to } mm

## Tables faites à partir de la norme
make-no-class = aucune classe de tolérance n'est donnée : en nommer une ou plusieurs, par exemple H7 H8 JS9
make-both-features = { $hole } et { $shaft } ne peuvent pas être dans une même table : seule la casse de leurs lettres diffère, faire donc une table pour les alésages et une pour les arbres
make-last-size = la dernière cote est { $to } mm : elle doit être supérieure à 0 et au plus égale à 3150 mm

## Press fits
press-no-interference = l'ajustement a un jeu d'au moins { $clearance } mm : un emmanchement exige un serrage, comme 40 H7/s6
press-length = la longueur { $length } mm n'est pas supérieure à 0
press-hub-outer = le diamètre extérieur du moyeu { $given } mm n'est pas supérieur au diamètre d'emmanchement, { $nominal } mm
press-shaft-bore = alésage de l'arbre { $given } mm : écrivez 0 pour un arbre plein, ou un alésage inférieur à { $nominal } mm
press-roughness = la rugosité { $given } mm est inférieure à 0
press-friction = un emmanchement exige un frottement supérieur à 0
press-material = le module d'élasticité de { $name } n'est pas connu : choisissez un autre matériau, ou ajoutez modulus et poisson à un fichier de vos matériaux
press-ratio = { $text } n'est pas un nombre de 0 à 1 avec au plus trois décimales
press-yields = NON ÉLASTIQUE : la contrainte { $part ->
    [hole] du moyeu
   *[shaft] de l'arbre
    } serait de { $stress } MPa, au-dessus de sa limite d'élasticité de { $limit } MPa : la théorie élastique ne s'applique pas, et rien n'est dit tenir
press-yield-unknown = on ne sait pas si { $part ->
    [hole] le moyeu
   *[shaft] l'arbre
    } plastifie : son matériau n'a pas de limite d'élasticité ici ; donnez-en une
press-may-be-loose = les pièces peuvent avoir un jeu de { $clearance } mm : l'assemblage peut ne pas tenir du tout
press-all-smoothed = l'écrasement de la rugosité, { $loss } mm, peut absorber le serrage : l'assemblage peut ne pas tenir du tout
press-no-roughness = aucune rugosité Rz donnée : aucune perte de serrage par écrasement n'est déduite
press-too-hot = chauffer le moyeu seul ne suffit pas jusqu'à { $most } °C, où sa dilatation est connue
press-too-cold = refroidir l'arbre seul ne suffit pas, même dans l'azote liquide
press-contraction-unknown = la contraction du matériau de l'arbre au froid n'est pas connue : sa dilatation est utilisée, l'arbre devra peut-être être plus froid
