page-statistics = Statistiques

# Ce qui est demandé
statistics-page-question = Relevés
statistics-page-question-hint = Les relevés dont les valeurs sont utilisées, dans le langage de la page Relevés, par exemple part:"Bride 40" station:"Fraiseuse 3" from:2026-11-01. Vide : tous les relevés.
statistics-page-last = Dernières valeurs
statistics-page-size = Valeurs par point
statistics-page-pause = Pause en minutes
statistics-page-mean-of = Moyenne de
statistics-page-mean-count = tant de valeurs de suite
statistics-page-mean-pause = valeurs sans pause
statistics-page-mean-part = valeurs d'une pièce
statistics-page-mean-station = valeurs d'un poste
statistics-page-mean-person = valeurs d'une personne
statistics-page-part = Pièce
statistics-page-all-parts = Toutes les pièces
statistics-page-read-again = Relire
statistics-page-range = doit être un nombre entier de { $least } à { $most }
statistics-page-reading = Lecture des valeurs…
statistics-page-off = Rien n'est consigné. Les statistiques se font avec les valeurs du journal.
statistics-page-none = Aucun relevé avec une valeur mesurée ne répond à cette question.
statistics-page-not-read = Les valeurs ne peuvent pas être lues : { $why }

# Ce qui a été lu
statistics-page-values = { $count ->
        [one] 1 valeur
       *[other] { $count } valeurs
    }
statistics-page-groups = { $count ->
        [one] 1 groupe
       *[other] { $count } groupes
    } de { $size }
statistics-page-out = { $count } écartées : { $why ->
        [simulated] simulées
        [invalid] non valides
        [doubtful] douteuses
        [withdrawn] corrigées ou retirées
       *[user] avec un motif
    }
statistics-page-newest = Les { $count } relevés les plus récents ont été lus. Les plus anciens ne sont pas compris.
statistics-page-unread = { $count ->
        [one] 1 relevé ne peut pas être lu.
       *[other] { $count } relevés ne peuvent pas être lus.
    }

# Éléments
statistics-page-features = Éléments
statistics-page-features-head = Ppk, repère à { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 valeur
       *[other] { $count } valeurs
    }, Ppk { $ppk }
statistics-page-below = { $count } sur { $all } sous { $asked }
statistics-page-move-feature = Un autre élément

# Chiffres
statistics-page-figures = Chiffres
statistics-page-figure-mean = Moyenne
statistics-page-figure-deviation = Écart-type
statistics-page-figure-cp = Cp court terme
statistics-page-figure-cpk = Cpk court terme
statistics-page-figure-pp = Pp global
statistics-page-figure-ppk = Ppk global
statistics-page-figure-outside = Hors limites
statistics-page-interval = 95 % : { $lower } … { $upper }
statistics-page-of = sur { $count }
statistics-page-expected = { $ppm } attendues par million
statistics-page-proven = Un Ppk de { $asked } est prouvé : sa borne inférieure est { $lower }.
statistics-page-not-proven = Un Ppk de { $asked } n'est pas prouvé : sa borne inférieure est { $lower }.
statistics-page-no-ppk = Un Ppk de { $asked } n'est pas prouvé : { $why }.

# La carte
statistics-page-single = Valeurs seules
statistics-page-means = Moyennes de { $size }
statistics-page-means-of-groups = Moyennes de groupes
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Histogramme
statistics-page-spread = Dispersion
statistics-page-probability = Droite de Henry
statistics-page-no-chart = Pas de limites de contrôle : { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 point
       *[other] { $count } points
    }, ligne centrale { $centre }, limites de contrôle { $lower } … { $upper }, limites { $minimum } … { $maximum }, { $signals ->
        [one] 1 signal
       *[other] { $signals } signaux
    }, { $outside } hors limites.
statistics-page-said-mean-mm = moyenne
statistics-page-said-sd-mm = écart-type
statistics-page-said-spread-centre-mm = dispersion moyenne
statistics-page-said-spread-upper-mm = limite de contrôle supérieure de la dispersion
statistics-page-said-ewma-mm = moyenne pondérée
statistics-page-said-ewma-lower-mm = limite inférieure de la moyenne
statistics-page-said-ewma-upper-mm = limite supérieure de la moyenne
statistics-page-said-cusum-above-mm = somme au-dessus de la moyenne
statistics-page-said-cusum-below-mm = somme sous la moyenne
statistics-page-said-cusum-interval-mm = intervalle de décision
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Un autre point
statistics-page-open = Ouvrir le relevé
statistics-page-zoom-in = Moins de points
statistics-page-zoom-out = Plus de points
statistics-page-zoom-whole = Tous les points
statistics-page-freeze = Limites d'après les points jusqu'ici
statistics-page-unfreeze = Limites d'après tous les points
statistics-page-freeze-hint = Les points suivants ne déplacent pas les limites de contrôle.
statistics-page-leave-out = Écarter…
statistics-page-leave-out-hint = Le point reste sur la carte avec son motif. Il ne compte ni pour les limites, ni pour les règles, ni pour les chiffres.
statistics-page-stage = Commencer une étape ici
statistics-page-no-stage = Retirer l'étape
statistics-page-stage-hint = Les limites sont recalculées à partir de ce point, par exemple après un changement d'outil. Les valeurs sont celles de la dernière étape.
statistics-page-take-in = Reprendre
statistics-page-reason = Motif
statistics-page-take-reason = Écarter
statistics-page-cancel-reason = Annuler
statistics-page-copy = Copier les chiffres
statistics-page-copy-hint = Chiffres, signaux et conseils en tableau pour un tableur
statistics-page-report = Rapport…
statistics-page-report-hint = Les valeurs et les graphiques de toutes les caractéristiques en un rapport à signer
statistics-page-save-chart = Enregistrer la carte…
statistics-page-save-chart-hint = Toutes les cartes de la caractéristique sur une feuille, en SVG ou PNG
statistics-page-dialog-chart = Enregistrer la carte
statistics-page-chart-ending = Le nom du fichier doit finir par .svg ou .png.

# Signaux
statistics-page-signals = Signaux
statistics-page-no-signals = Aucune règle ne se déclenche.
statistics-page-rules = Règles
statistics-page-alarms = Alarmes ouvertes : { $count }
statistics-page-at = Point { $point }
statistics-page-from-to = Points { $first } à { $last }
statistics-page-left-out-because = Écarté : { $reason }
statistics-page-advice = Conseils

# Une étude d'un moyen de mesure
statistics-study = Étude du moyen de mesure
statistics-study-open = Ouvrir des lectures…
statistics-study-open-hint = Un fichier de lectures d'un moyen de mesure, dans tout format de mesures
statistics-study-dialog = Ouvrir les lectures d'un moyen de mesure
statistics-study-readings = { $count ->
        [one] 1 lecture
       *[other] { $count } lectures
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 lecture
       *[other] { $count } lectures
    }
statistics-study-none = Ouvrez un fichier de lectures d'un moyen de mesure. Ses colonnes disent quelle pièce a été lue, et par qui. Vous voyez comment il a été compris avant tout calcul.
statistics-study-kind = Type d'étude
statistics-study-type1 = Type 1
statistics-study-crossed = Croisée
statistics-study-nested = Emboîtée
statistics-study-linearity = Linéarité
statistics-study-stability = Stabilité
statistics-study-type1-hint = Un étalon, 25 lectures ou plus
statistics-study-crossed-hint = Chaque opérateur lit chaque pièce, deux fois ou plus
statistics-study-nested-hint = Chaque opérateur a ses propres pièces
statistics-study-linearity-hint = Plusieurs étalons de cotes différentes
statistics-study-stability-hint = Un étalon au fil du temps
statistics-study-feature = Élément de l'étude
statistics-study-lower = Limite inférieure
statistics-study-upper = Limite supérieure
statistics-study-reference = Cote étalonnée
statistics-study-resolution = Pas d'affichage
statistics-study-references-hint = Une cote par étalon avec son nom : M1 = 30.0012; M2 = 40.0005. Vide, les cotes nominales du fichier comptent.
statistics-study-reference-unnamed = { $given } ne nomme aucun étalon : écrire son nom avant la cote, comme M1 = 30.0012
statistics-study-own-limits = Limites du fichier : { $lower } … { $upper } mm
statistics-study-understood = Comment le fichier a été compris
statistics-study-confirm = Rien n'est calculé avant votre confirmation.
statistics-study-evaluate = Évaluer
statistics-study-all-the-same = Évaluer quand même
statistics-study-working = Évaluation…
statistics-study-answer = Ce moyen de mesure est-il assez bon ?
statistics-study-each = { $what } chacun
statistics-study-parts = { $count ->
        [one] 1 pièce
       *[other] { $count } pièces
    }
statistics-study-operators = { $count ->
        [one] 1 opérateur
       *[other] { $count } opérateurs
    }
statistics-study-repeats = { $count ->
        [one] 1 répétition
       *[other] { $count } répétitions
    }
statistics-study-masters = { $count ->
        [one] 1 étalon
       *[other] { $count } étalons
    }
statistics-study-points = { $count ->
        [one] 1 point
       *[other] { $count } points
    }
statistics-study-readings-between = { $least } à { $most } lectures
statistics-study-more-faults = et { $count } de plus
statistics-study-limits-differ = Les limites du fichier diffèrent d'une valeur à l'autre : entrer les limites inférieure et supérieure, ou choisir un élément.
statistics-study-features = Le fichier a plusieurs éléments : choisir celui qui a été lu.
statistics-study-save-budget = Enregistrer comme bilan…
statistics-study-save-budget-hint = La dispersion trouvée par l'étude, en type A avec ses degrés de liberté, pour la page Incertitude
statistics-study-no-budget = Cette étude ne donne aucune contribution à un bilan
statistics-study-source = { $of ->
        [part] pièces
        [operator] opérateurs
        [interaction] interaction
        [repeatability] répétabilité
        [gauge] moyen de mesure
       *[total] total
    }
statistics-study-mean-square = Carré moyen, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Variance, { $source }
statistics-study-figure-reference = Cote étalonnée
statistics-study-figure-bias = Erreur de justesse
statistics-study-figure-mean-bias = Erreur de justesse moyenne
statistics-study-figure-bias-p = p de l'erreur de justesse
statistics-study-figure-bias-t = t de l'erreur de justesse
statistics-study-figure-bias-at = Erreur de justesse à { $size } mm ({ $count })
statistics-study-figure-smallest = Plus petite tolérance
statistics-study-figure-smallest-good = Plus petite tolérance, 10 %
statistics-study-figure-smallest-accepted = Plus petite tolérance, 30 %
statistics-study-figure-repeatability = Répétabilité, s
statistics-study-figure-gauge = Moyen de mesure, s
statistics-study-figure-of-variance = Part de la variance
statistics-study-figure-of-readings = Part de toutes les lectures
statistics-study-figure-of-tolerance = Part de la tolérance
statistics-study-figure-categories = Catégories distinctes
statistics-study-figure-slope = Pente
statistics-study-figure-slope-p = p de la pente
statistics-study-figure-intercept = Erreur de justesse à 0
statistics-study-figure-intercept-p = p de l'erreur de justesse à 0
statistics-study-figure-residual = s autour de la droite
statistics-study-figure-centre = Ligne centrale
statistics-study-figure-lower-control = Limite de contrôle inférieure
statistics-study-figure-upper-control = Limite de contrôle supérieure
statistics-study-figure-spread-centre = Dispersion moyenne
statistics-study-figure-spread-upper = Limite de contrôle supérieure de la dispersion
