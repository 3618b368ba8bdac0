page-statistics = Statistiques

# Ce qui est demandé
statistics-page-question = Relevés
statistics-page-question-hint = Les relevés dont les valeurs sont utilisées, dans le langage de la page Relevés, par exemple part:"Bride 40" station:"Fraiseuse 3" from:2026-11-01. Vide : tous les relevés.
statistics-page-last = Dernières valeurs
statistics-page-size = Valeurs par point
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
statistics-page-take-in = Reprendre
statistics-page-reason = Motif
statistics-page-take-reason = Écarter
statistics-page-cancel-reason = Annuler
statistics-page-copy = Copier les chiffres
statistics-page-copy-hint = Chiffres, signaux et conseils en tableau pour un tableur
statistics-page-report = Rapport…
statistics-page-report-hint = Les valeurs et les graphiques de toutes les caractéristiques en un rapport à signer

# Signaux
statistics-page-signals = Signaux
statistics-page-no-signals = Aucune règle ne se déclenche.
statistics-page-rules = Règles
statistics-page-on-spread = Dispersion : { $rule }
statistics-page-alarms = Alarmes ouvertes : { $count }
statistics-page-at = Point { $point }
statistics-page-from-to = Points { $first } à { $last }
statistics-page-left-out-because = Écarté : { $reason }
statistics-page-advice = Conseils
