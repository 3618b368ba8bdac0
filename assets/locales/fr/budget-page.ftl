page-budget = Incertitude
page-budget-also = Bilan

budget-page-text = Bilan en TOML
budget-page-none = Créer un nouveau bilan, ou en ouvrir un
budget-page-new = Nouveau bilan
budget-page-open = Ouvrir un bilan…
budget-page-save = Enregistrer sous…
budget-page-dialog-open = Ouvrir un bilan
budget-page-dialog-save = Enregistrer le bilan
budget-page-dialog-readings = Lectures de la pièce étalonnée
budget-page-not-saved = { $name }, non enregistré

budget-page-for = Évalué pour
budget-page-size = Cote mesurée
budget-page-contacts = Points de palpage
budget-page-touches = Nombre de points
budget-page-step = Pas
budget-page-contacts-hint = Vide : les points de palpage du bilan
budget-page-day = Jour
budget-page-day-hint = Jour vide : aujourd'hui, { $day }
budget-page-no-day = { $given } n'est pas un jour : AAAA-MM-JJ attendu
budget-page-other-missing = Manquant : donner à la fois le nombre de points et le pas, ou aucun des deux
budget-page-take-check = Du contrôle affiché
budget-page-take-recorded = Points enregistrés
budget-page-own-contacts = Du bilan
budget-page-of-check = { $count } points de palpage du contrôle { $what }, { $time }
budget-page-of-simulated-check = { $count } points de palpage du contrôle { $what }, { $time }, simulés
budget-page-of-recorded = { $count } points de palpage enregistrés de { $name }
budget-page-contacts-used = { $count } points de palpage, facteur { $factor }
budget-page-contacts-stepped = { $count } points de palpage à { $step }°, facteur { $factor }
budget-page-no-circle = Les points de palpage ne sont pas utilisés : { $problem }

budget-page-readings = Lectures
budget-page-open-readings = D'un fichier…
budget-page-take-readings = De l'historique
budget-page-own-readings = Du bilan
budget-page-readings-own = { $count ->
        [one] { $count } lecture dans le bilan
       *[other] { $count } lectures dans le bilan
    }
budget-page-readings-of-file = { $count ->
        [one] { $count } lecture de { $name }
       *[other] { $count } lectures de { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] { $count } lecture : le contrôle de l'historique
       *[other] { $count } lectures : tous les contrôles de l'historique
    }
budget-page-readings-of-chosen = { $count ->
        [one] { $count } lecture : le contrôle sélectionné de l'historique
       *[other] { $count } lectures : les contrôles sélectionnés de l'historique
    }
budget-page-readings-are-shafts = { $count ->
        [one] { $count } contrôle d'arbre n'est pas utilisé
       *[other] { $count } contrôles d'arbres ne sont pas utilisés
    } : la pièce étalonnée est un alésage
budget-page-readings-are-holes = { $count ->
        [one] { $count } contrôle d'alésage n'est pas utilisé
       *[other] { $count } contrôles d'alésages ne sont pas utilisés
    } : la pièce étalonnée est un arbre
budget-page-readings-simulated = { $count ->
        [one] { $count } lecture est simulée
       *[other] { $count } lectures sont simulées
    } : rien n'a été mesuré
budget-page-more-notes = { $count ->
        [one] et { $count } de plus
       *[other] et { $count } de plus
    }

budget-page-answer = Incertitude élargie
budget-page-no-answer = Pas de réponse
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } pour 95,45 %
budget-page-at-size = Pour { $size } mm ; chaque contrôle a l'incertitude de sa propre cote
budget-page-covered-by = k = { $k } selon { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Degrés de liberté effectifs { $degrees }
budget-page-infinite = infini
budget-page-valid = Valable jusqu'au { $until }
budget-page-expired = PÉRIMÉ
budget-page-expired-on = valable jusqu'au { $until }, au { $day }
budget-page-not-yet = PAS ENCORE VALABLE
budget-page-not-yet-on = valable à partir du { $date }
budget-page-made = Créé le { $date } par { $by }
budget-page-method = Méthode { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Contribution principale
budget-page-largest-is = { $name }, { $percent } % de la variance
budget-page-help = Ce qui aiderait le plus
budget-page-help-halved = Réduite de moitié : u = { $u } µm
budget-page-help-part-temperature = Moitié de l'incertitude sur la température de la pièce : u = { $u } µm
budget-page-help-scale-temperature = Moitié de l'incertitude sur la température des systèmes de mesure : u = { $u } µm
budget-page-help-expansion = Moitié de l'écart à 20 °C, ou moitié de l'incertitude de la dilatation : u = { $u } µm
budget-page-help-full-circle = { $count } points de palpage répartis régulièrement sur le cercle entier : u = { $u } µm
budget-page-help-more-touches = { $count } points de palpage répartis régulièrement sur le cercle entier : u = { $u } µm

budget-page-checks = Contrôles
budget-page-use = Utiliser pour les contrôles
budget-page-leave = Ne plus utiliser
budget-page-uses-none = Les contrôles n'utilisent aucun bilan
budget-page-uses-this = Utilisé : { $name }
budget-page-uses-another = Utilisé : { $name } de { $file }, qui diffère de ce qui est affiché ici
budget-page-uses-typed = « { $name } » ne compte pas : les contrôles utilisent l'incertitude choisie dans Contrôle
budget-page-uses-no-rule = « { $name } » est choisi, mais aucune règle de Contrôle n'utilise encore d'incertitude : y choisir la règle
budget-page-used-before = Jusqu'ici, les contrôles utilisaient l'incertitude saisie ({ $uncertainty }). « Ne plus utiliser » la rétablit
budget-page-used = Les contrôles utilisent le bilan { $name }
budget-page-used-no-rule = « { $name } » ne change encore aucun verdict : la règle de Contrôle est « { $rule } », qui n'utilise pas d'incertitude. Choisir une autre règle
budget-page-not-kept = Enregistrer le bilan pour continuer à l'utiliser après un redémarrage
budget-page-readings-not-kept = Les lectures ne sont pas dans le fichier du bilan : après un redémarrage, le bilan n'est plus utilisé
budget-page-used-unread = { $path } : le bilan utilisé pour les contrôles ne peut pas être lu, les contrôles n'utilisent donc aucun bilan : { $problem }

budget-page-table = Contributions
budget-page-column-name = Nom
budget-page-column-type = Type
budget-page-column-law = Loi
budget-page-column-sensitivity = c
budget-page-column-share = Part
budget-page-row = { $name }, type { $type }, { $law }, u { $u } { $unit }, sensibilité { $sensitivity }, contribution { $um } µm, part { $percent } %, degrés de liberté { $degrees }
budget-page-law-normal = normale
budget-page-law-rectangular = rectangulaire
budget-page-law-u-shaped = en U
budget-page-law-triangular = triangulaire
budget-page-shares = Parts de la variance
budget-page-terms = Termes et incertitude élargie
budget-page-mean = Moyenne des lectures { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, corrigée
budget-page-edition-2004 = U, 2004, non corrigée
budget-page-nothing-seen = La table et les parts apparaissent dès que le bilan peut être évalué
budget-page-named = { $name }
budget-page-placeholders = Les contrôles ne peuvent pas encore utiliser ce bilan. Ces indications sont encore celles du modèle : { $what }. Saisir les vraies dans leurs champs
budget-page-placeholder-name = son nom (« { $name } »)
budget-page-placeholder-by = son auteur (« { $by } »)
budget-page-placeholder-figures = les chiffres de toutes les contributions

## Le bilan en table

budget-show-table = Table
budget-show-text = Texte
budget-rows = Contributions
budget-head-name = Nom du bilan
budget-head-by = Créé par
budget-row-new = Nouvelle contribution
budget-row-add = Ajouter une contribution
budget-row-remove = Supprimer la contribution
budget-row-removed = Contribution « { $name } » supprimée du bilan
budget-row-comments-removed = Les commentaires à côté des clés supprimées ont disparu
budget-row-said = { $value } { $unit }, diviseur { $divisor }, { $law }
budget-row-unread = incomplète
budget-row-name = Nom
budget-row-k = Facteur d'élarg. k
budget-row-alpha = Dilatation, 1/K
budget-row-delta = Écart à 20 °C
budget-row-touches = Points propres
budget-row-step = Pas propre
budget-row-sensitivity = Sensibilité c
budget-row-freedom = Degrés de liberté
budget-row-freedom-a = Degrés de liberté, n − 1 pour n lectures
budget-row-kind = Compte pour
budget-row-type = Type
budget-row-law = Loi
budget-row-given = Donné comme
budget-row-half-width = Demi-largeur
budget-row-resolution = Pas de l'affichage
budget-given-standard = Incertitude-type
budget-given-expanded = Incertitude élargie
budget-type-a = A, statistique
budget-type-b = B, autre
budget-kind-plain = Diamètre
budget-kind-scatter = Dispersion d'un palpage
budget-kind-part-temperature = Température de la pièce
budget-kind-scale-temperature = Temp. des systèmes de mesure
budget-kind-part-expansion = Dilatation de la pièce
budget-kind-scale-expansion = Dilatation des syst. de mesure
budget-kind-resolution = Résolution
budget-table-stale = Le texte a une erreur : la table montre les contributions telles qu'elles étaient en dernier
budget-table-other = Le texte écrit ses contributions d'une façon que la table ne peut pas modifier. Modifier le texte
budget-table-calibrated = Ce bilan est celui d'une pièce étalonnée et n'a pas de contributions. Modifier le texte
budget-law-normal = Loi normale
budget-law-rectangular = Loi rectangulaire
budget-law-u-shaped = Loi en U
budget-law-triangular = Loi triangulaire
