# Plans d'éléments : ce qui ne va pas dans un plan.

plan-no-features = le plan n'a aucun élément
plan-no-form-limit = { $text } n'est pas la limite d'une tolérance de forme ou de position : écrire une seule longueur supérieure à 0 en mm, par exemple 0.02
plan-too-many = le plan a plus de { $most } éléments
plan-too-large = un plan a au plus { $most } Kio
plan-no-column = la colonne { $column } manque
plan-unknown-column = colonne inconnue { $column } : les colonnes sont { $known }
plan-column-twice = la colonne { $column } est présente deux fois
plan-cells = la rangée a { $found } cellules et l'en-tête { $expected } : avec une virgule décimale, séparer les colonnes par des points-virgules
plan-no-cell = { $column } manque
plan-value = { $what } : { $error }
plan-no-feature = { $callout } peut être un alésage ou un arbre : ajouter feature = "hole" ou feature = "shaft", ou kind = "length" si ce n'est ni l'un ni l'autre
plan-fit = { $callout } est un ajustement : écrire l'alésage et l'arbre comme deux éléments
plan-clearance-height = la hauteur de sécurité { $height } mm n'est pas au-dessus de la hauteur de mesure, { $z } mm
plan-same-name = le nom { $name } est présent deux fois{ $line ->
    [0] { "\u00A0" }: sur une commande, les noms de fichiers ne distinguent pas la casse
   *[other] , d'abord à la ligne { $line } : sur une commande, les noms de fichiers ne distinguent pas la casse
}
plan-unknown = { $column } { $given } est inconnu : { $known } attendu
plan-other-side = le type { $given } contredit { $column } { $text }, qui est celui d'un { $side ->
    [hole] alésage
   *[shaft] arbre
    } : corriger l'un des deux, ou écrire diameter
plan-not-of = { $kind } : { $column } n'existe pas pour ce type
plan-direction = l'axe { $given } n'est pas une direction : { $known } attendu, ou trois nombres tels que 0.5 0 -1, de -10 à 10 avec au plus 9 décimales et pas tous nuls
plan-no-band = { $text } n'est pas la tolérance d'un point, par exemple ±0,05 ou +0,1/-0,05 : { $error }
plan-band-side = un point ne peut pas avoir d'écarts de { $lower } à { $upper } mm : le cycle demande un écart supérieur de 0 ou plus et un écart inférieur de 0 ou moins, pas tous deux nuls
plan-side-class = { $callout } : pour { $kind }, les deux côtés demandent des classes telles que { $example }
plan-face-class = { $callout } : une face est jugée comme une cote extérieure et demande une classe d'arbre, par exemple h9
plan-face-place = { $callout } : la face est à { $coordinate } mm suivant l'axe de mesure, ce qui doit être sa cote nominale
plan-not-a-plan = ce n'est pas un plan : un plan a une ligne avec les noms de ses colonnes, par exemple name;callout;x;y;z, ou commence par fitcheck_plan = 1
plan-other-version = ce plan est de version { $given } : les versions 1 à { $newest } sont prises en charge
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = clé inconnue { $key } : { $known } attendu
plan-other-value = { $key } : { $expected } attendu, { $found } trouvé
plan-parameter = le cycle { $cycle } ne prend pas { $given } d'un plan : écrire NAME=VALUE avec l'un de { $known }
plan-no-parameter = aucun cycle de mesure ne prend { $given } d'un plan : écrire NAME=VALUE, par exemple Q423=3
plan-travel = { $axis }{ $given } est hors de la course de la machine, { $minimum } à { $maximum } mm
plan-clearance-travel = le palpeur se déplace à Z{ $height }, hors de la course de la machine, { $minimum } à { $maximum } mm : donner une autre clearance_height
plan-no-travel = { $given } n'est pas une course : écrire deux nombres, le plus petit d'abord, par exemple -250 250
plan-no-plausible = { $column } : { $given } n'est pas un intervalle : écrire deux longueurs en mm, la plus petite d'abord, par exemple 24.5 25.5
plan-plausible-limits = { $column } : { $lower } à { $upper } mm ne contient pas les limites de la cote, { $minimum } à { $maximum } mm : donner un intervalle plus large
plan-text = { $column } : une seule ligne d'au plus { $most } caractères attendue
plan-same-number = { $line ->
    [0] le numéro { $number } est présent deux fois : un autre élément a { $other }
   *[other] le numéro { $number } est présent deux fois : l'élément à la ligne { $line } a { $other }
}
plan-same-size = { $line ->
    [0] une valeur { $called } pourrait être de cet élément ou de { $other } : renommer l'un des deux
   *[other] une valeur { $called } pourrait être de cet élément ou de { $other } à la ligne { $line } : renommer l'un des deux
}
plan-number-is-name = { $line ->
    [0] le numéro { $number } est le nom d'un autre élément, { $other }
   *[other] le numéro { $number } est le nom d'un autre élément, { $other } à la ligne { $line }
}
plan-name-is-number = { $line ->
    [0] une valeur { $called } pourrait être de cet élément ou de { $other }, dont c'est le numéro
   *[other] une valeur { $called } pourrait être de cet élément ou de { $other } à la ligne { $line }, dont c'est le numéro
}
plan-balloon = { $given } n'est pas une place sur l'image : 0 à 1 attendu
plan-not-found-unknown = non jugé : aucun élément du plan n'a ce nom, ce numéro ou cette position
plan-not-found-no-clue = non jugé : la valeur n'a ni nom, ni numéro, ni position, elle ne correspond donc à aucun élément du plan
plan-not-found-half-place = non jugé : aucun élément du plan n'a ce nom ou ce numéro, et une position demande X et Y
plan-not-found-contradiction = non jugé : son nom correspond à { $name } du plan, mais son numéro à { $number }
plan-not-found-other-name = aucun élément du plan ne s'appelle { $given } ; { $name } a le même numéro, mais ce peut être un numéro courant : nommer l'élément comme dans le plan, ou donner sa cote nominale
plan-not-found-running-number = non jugé : seul son numéro correspond à { $name } du plan, et ce peut être un numéro courant, car d'autres rangées du fichier ne sont pas de ce plan
plan-not-found-other-nominal = non jugé : correspond à { $name } du plan, mais sa cote nominale est { $given } et celle du plan { $planned }
plan-not-found-other-limits = non jugé : correspond à { $name } du plan, mais ses limites { $given } n'ont rien de commun avec celles du plan, { $planned }
plan-not-found-several = non jugé : plusieurs éléments du plan ont cette position : { $names }
plan-not-found-which-side = non jugé : la valeur ne dit pas duquel il s'agit : { $names }
part-standing =
    { $measured ->
        [one] { $measured } mesurée
       *[other] { $measured } mesurées
    }, { $missing ->
        [one] { $missing } manquante
       *[other] { $missing } manquantes
    }, { $skipped ->
        [one] { $skipped } ignorée
       *[other] { $skipped } ignorées
    }
plan-not-found-other-kind = non jugé : correspond à { $name } du plan, de type { $kind }, mais autre chose a été mesuré
plan-remark-file = { $said }
plan-remark-left = { $name } est ignoré : { $why }
plan-remark-class-left = { $name } : { $class } a d'autres limites que le fichier ; les limites du fichier s'appliquent
plan-remark-place-left = { $name } : aucune position n'a été reprise : { $why }
plan-remark-axes-assumed = positions : le fichier ne dit pas suivant quel axe sont ses alésages et ses arbres ; Z est supposé
plan-remark-uncertainty-left = { $name } : l'incertitude élargie de { $expanded } mm est ignorée, car sa moitié n'est pas un nombre entier de nanomètres
plan-remark-clearance-raised = { $name } est au-dessus de la hauteur de sécurité habituelle : { $height } est écrit
plan-simulated-no-place = { $name } n'a pas de position dans le plan : simulation impossible
plan-simulated-no-cycle = aucun cycle ne mesure { $name } : simulation impossible
