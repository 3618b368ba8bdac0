# statistics

# Pourquoi il n'y a pas de chiffre
statistics-reason-empty = il n'y a pas de valeurs
statistics-reason-not-a-number = la valeur { $place } n'est pas un nombre
statistics-reason-too-few = trop peu de valeurs ou de groupes : { $found }, au moins { $needed } nécessaires
statistics-reason-all-equal = toutes les valeurs sont égales : il n'y a pas de dispersion à calculer
statistics-reason-no-subgroups = aucun sous-groupe n'a deux valeurs ou plus
statistics-reason-ungrouped = valeurs qui ne disent pas leur groupe : { $count }
statistics-look-grouped = Les points sont des moyennes : { $by ->
        [part] des valeurs d'une pièce
        [batch] des valeurs d'un lot
        [machine] des valeurs d'une machine
        [gauge] des valeurs d'un poste
        [who] des valeurs d'une personne
       *[other] des valeurs sans pause de plus de { $minutes } min
    }.
statistics-look-stages = Points où commence une étape : { $points }. Les valeurs sont celles de la dernière étape.
statistics-look-waits = Étapes qui ont encore trop peu de valeurs différentes et ne comptent pas pour l'instant : { $count }.
statistics-look-frozen = Les limites de contrôle sont celles des points { $first } à { $last }.
statistics-look-memory = Seconde carte : { $method }.
statistics-look-no-memory = Pas de carte { $method } : { $why }.
statistics-reason-large-subgroup = un sous-groupe a { $found } valeurs : l'étendue ne sert que jusqu'à { $most }
statistics-reason-unequal-subgroups = les sous-groupes ont de { $least } à { $most } valeurs : cette carte demande des sous-groupes de même taille
statistics-reason-no-limits = il n'y a pas de limites
statistics-reason-one-limit = il n'y a qu'une limite, et les deux sont nécessaires
statistics-reason-swapped-limits = la limite inférieure n'est pas sous la limite supérieure
statistics-reason-not-positive = cette loi ne prend que des valeurs positives
statistics-reason-negative = cette loi ne prend pas de valeurs négatives
statistics-reason-no-fit = cette loi ne convient pas aux valeurs
statistics-reason-uneven-cell = mesures de la pièce { $part } par l'opérateur { $operator } : { $found }, attendu { $needed }
statistics-reason-no-baseline = la période de référence n'est pas dans son étape, ou ses chiffres sont inutilisables
statistics-reason-parameter = { $name } ne peut pas valoir { $given }

# Règles des cartes de contrôle, là où l'une se déclenche
statistics-rule-beyond-limits = 1 point au-delà d'une limite de contrôle
statistics-rule-nine-one-side = 9 points de suite d'un même côté de la ligne centrale
statistics-rule-six-trend = 6 points de suite en hausse ou en baisse
statistics-rule-fourteen-alternating = 14 points de suite alternant hausse et baisse
statistics-rule-two-of-three = 2 points sur 3 au-delà de 2 s d'un même côté
statistics-rule-four-of-five = 4 points sur 5 au-delà de 1 s d'un même côté
statistics-rule-fifteen-within = 15 points de suite à moins de 1 s de la ligne centrale
statistics-rule-eight-beyond = 8 points de suite au-delà de 1 s, d'un côté ou de l'autre
statistics-rule-eight-one-side = 8 points de suite d'un même côté de la ligne centrale
statistics-chart-maximum = maximum { $size }
statistics-chart-minimum = minimum { $size }
statistics-chart-upper = supérieure { $size }
statistics-chart-mean = moyenne { $size }
statistics-chart-lower = inférieure { $size }
statistics-chart-values = Valeurs individuelles en µm à partir de { $base }, les plus anciennes à gauche
statistics-chart-means = Moyennes des groupes en µm à partir de { $base }, les plus anciennes à gauche
statistics-chart-histogram = Histogramme
statistics-chart-moving-range = Étendue mobile, µm
statistics-chart-range = Étendue des groupes, µm
statistics-chart-deviation = Écart-type des groupes, µm
statistics-chart-probability = Diagramme de probabilité
statistics-chart-ewma = Moyennes pondérées (EWMA)
statistics-chart-cusum = Sommes des écarts à la moyenne (CUSUM)
statistics-chart-probability-test = Diagramme de probabilité, Anderson-Darling { $statistic }, p = { $p }

# Que faire des chiffres
statistics-advice-few-values = { $count } valeurs : les intervalles sont larges, { $enough } ou plus sont d'usage
statistics-advice-few-points = les limites de contrôle viennent de { $count } points : { $enough } ou plus sont d'usage
statistics-advice-unstable = points où une règle se déclenche : { $count } ; la capabilité ne vaut que pour un procédé stable
statistics-advice-not-of-law = les valeurs ne suivent guère cette loi (p = { $p }) : ses parts hors limites ne sont pas fiables
statistics-advice-centred = ne pas corriger : { $what ->
        [line] la cote est maintenant à
       *[mean] la moyenne est à
    } { $um } µm du milieu de la tolérance, ce qui n'est que du bruit avec { $count } valeurs
statistics-advice-near = ne pas corriger : { $what ->
        [line] la cote est maintenant à
       *[mean] la moyenne est à
    } { $um } µm du milieu de la tolérance, { $count } valeurs
statistics-advice-correct = corriger de { $correction } µm : { $what ->
        [line] la cote est maintenant à
       *[mean] la moyenne est à
    } { $um } µm du milieu de la tolérance, { $count } valeurs
statistics-advice-no-trend = pas de tendance : la variation d'une pièce à l'autre n'est que du bruit
statistics-advice-trend = la cote varie de { $um } µm par pièce
statistics-advice-trend-at-limit = la cote varie de { $um } µm par pièce, et des pièces hors limite sont à attendre dès maintenant
statistics-advice-trend-to = la cote varie de { $um } µm par pièce : il reste environ { $parts } pièces jusqu'à la limite ({ $level } % : { $least } à { $most })
statistics-advice-average-out = la moyenne pondérée est hors de ses limites, d'abord au point { $at } : la moyenne s'est déplacée
statistics-advice-sum-out = la somme est hors de l'intervalle de décision, d'abord au point { $at } : la moyenne s'est déplacée, depuis le point { $since } environ
statistics-advice-groups-alike = les groupes ne diffèrent pas plus que par hasard (p = { $p })
statistics-advice-groups-differ = les groupes diffèrent (p = { $p })

# Études d'instruments
statistics-gauge-operator-per-value = chaque valeur a son propre opérateur : les colonnes sont-elles justes ?
statistics-gauge-more-operators = opérateurs : { $operators }, pièces : { $parts } : les colonnes des pièces et des opérateurs sont-elles inversées ?
statistics-gauge-operators-differ-more = les opérateurs diffèrent plus que les pièces : les colonnes des pièces et des opérateurs sont-elles inversées ?
statistics-gauge-same-parts = chaque opérateur a des pièces de mêmes noms : l'étude est-elle croisée ?
statistics-gauge-several-masters = les valeurs sont de { $parts } pièces, et cette étude demande un seul étalon
statistics-gauge-master-good = assez bon pour cette tolérance : Cg et Cgk atteignent { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = pas assez bon pour cette tolérance : Cg et Cgk doivent atteindre { $required }, avec un pas d'affichage d'au plus 5 % de la tolérance (AIAG MSA, VDA 5)
statistics-gauge-smallest = plus petite tolérance pour laquelle il est assez bon : { $mm } mm ({ $level } % : jusqu'à { $most } mm)
statistics-gauge-biased = l'erreur de justesse de { $um } µm dépasse le hasard (p = { $p })
statistics-gauge-not-biased = l'erreur de justesse de { $um } µm peut être due au hasard (p = { $p })
statistics-gauge-good = assez bon : l'instrument prend { $percent } % de { $of ->
        [tolerance] la tolérance
       *[variation] toute la dispersion
    }, et jusqu'à 10 % c'est bon (AIAG MSA)
statistics-gauge-accepted = assez bon seulement s'il doit suffire : l'instrument prend { $percent } % de { $of ->
        [tolerance] la tolérance
       *[variation] toute la dispersion
    }, et de 10 % à 30 % cela dépend de l'emploi (AIAG MSA)
statistics-gauge-bad = pas assez bon : l'instrument prend { $percent } % de { $of ->
        [tolerance] la tolérance
       *[variation] toute la dispersion
    }, et plus de 30 % c'est trop (AIAG MSA)
statistics-gauge-smallest-shares = plus petite tolérance pour laquelle il est assez bon : { $good } mm ; s'il doit suffire : { $accepted } mm
statistics-gauge-interaction-kept = les opérateurs diffèrent plus sur certaines pièces que sur d'autres (p = { $p }) : l'interaction est gardée
statistics-gauge-interaction-pooled = les opérateurs ne diffèrent pas plus sur certaines pièces que sur d'autres (p = { $p }) : l'interaction est réunie à la répétabilité
statistics-gauge-negative = la variance { $what ->
        [operator] des opérateurs
        [interaction] de l'interaction
       *[part] des pièces
    } est négative et compte pour 0
statistics-gauge-not-linear = l'erreur de justesse change avec la cote (p = { $p })
statistics-gauge-linear = l'erreur de justesse ne change pas avec la cote plus que par hasard (p = { $p })
statistics-gauge-stable = stable : aucune règle ne se déclenche et les lectures ne dérivent pas
statistics-gauge-not-stable = pas stable : une règle se déclenche ou les lectures dérivent

# Pourquoi des valeurs ne font pas une étude
series-study-no-parts = valeurs sans pièce : { $count }
series-study-no-operators = valeurs sans opérateur à côté d'autres qui en ont un : { $count }
series-study-uneven-cell = lectures de la pièce { $part } par l'opérateur { $operator } : { $found }, attendu { $needed }
series-study-uneven-operator = pièces de l'opérateur { $operator } : { $found }, attendu { $needed }
series-study-nested = chaque pièce n'a été mesurée que par un opérateur : c'est une étude emboîtée
series-study-no-reference = valeurs sans cote étalonnée : { $count }
series-study-references = les valeurs d'un étalon ont plusieurs cotes étalonnées

# Comment les valeurs d'une étude sont calculées
series-method-word = { $word }
series-method-given = donnée
series-method-mean = moyenne, Student
series-method-deviation = écart-type, khi-deux
series-method-bias = moyenne − référence, Student
series-method-t-test = test t
series-method-type1 = type 1
series-method-share = { $percent } % de la tolérance, { $spread } s
series-method-required = Cg et Cgk au moins { $required }
series-method-anova = analyse de la variance
series-method-degrees = analyse de la variance, degrés de liberté : { $degrees }
series-method-ratio = F = { $f }
series-method-negative = négative, comptée pour 0
series-method-chi-square = khi-deux
series-method-large-sample = grand échantillon modifié
series-method-variances = variances
series-method-categories = 1,41 pièces / moyen de mesure
series-method-linearity = linéarité
series-method-least-squares = moindres carrés
series-method-within-masters = s au sein des étalons
statistics-on-spread = dispersion : { $rule }
