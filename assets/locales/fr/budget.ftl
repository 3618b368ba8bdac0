# budget

budget-toml = { $said }
budget-too-large = un fichier de bilan a au plus { $most } Kio
budget-not-one = un bilan demande soit des tables [[contribution]], soit une table [calibrated]
budget-too-many = { $count } contributions : un bilan en a au plus { $most }
budget-empty = { $key } est vide : un texte est attendu
budget-day = { $key } : { $given } n'est pas un jour : AAAA-MM-JJ attendu
budget-days = valid_until { $until } est avant date { $date }
budget-key = { $table } : { $key } n'est pas utilisé ici : les clés admises sont { $allowed }
budget-missing = { $table } : { $keys } manque
budget-range = { $table } : { $key } est { $given } : { $least } à { $most } attendu
budget-resolution-law = { $table } : une résolution est rectangulaire : law = "rectangular" attendu, ou pas de law
budget-geometry = { $table } : { $error }
budget-length = { $key } : { $error }
budget-geometry-touches = { $touches } palpages : 3 à { $most } attendus
budget-geometry-step = { $touches } palpages à { $step } degrés : un pas de 0,01 à { $most } degrés attendu
budget-evaluation-no-size = { $contribution } dépend de la cote, mais aucune cote n'est donnée
budget-evaluation-no-contacts = { $contribution } dépend des points de palpage, mais le bilan n'a ni touches ni step_deg, et aucun point n'est donné
budget-evaluation-nothing = toutes les contributions sont nulles
budget-calibrated-too-few = { $readings ->
        [one] { $readings } lecture
       *[other] { $readings } lectures
    } : au moins 2 sont nécessaires
budget-calibrated-far-away = la moyenne des lectures, { $mean } mm, est à plus de 1 mm de la cote étalonnée, { $size } mm
budget-calibrated-nothing = toutes les incertitudes sont nulles

budget-warning-expired = le bilan est périmé : il était valable jusqu'au { $until }
budget-warning-not-yet = le bilan n'est pas encore valable : sa date est { $date }
budget-warning-of-template = le bilan a encore des indications du modèle pour son nom, son auteur ou ses chiffres : elles ne disent rien de ce poste
budget-warning-failed-study = une étude dit de ce moyen de mesure : { $why }
budget-warning-template-figures = ces contributions ont encore les chiffres du modèle : { $contributions }. Vérifier qu'ils sont vrais pour ce poste
budget-warning-few-readings = { $readings } lectures de la pièce étalonnée : ISO 15530-3 en demande au moins { $fewest }
budget-warning-bias-corrected = biais { $bias } µm : l'incertitude vaut pour des valeurs dont le biais a été soustrait ; Fitcheck ne le soustrait pas
budget-warning-bias-not-corrected = biais { $bias } µm : il n'est pas corrigé, l'incertitude le comprend donc
budget-warning-other-size = la pièce étalonnée du bilan a { $calibrated } mm, mais { $measured } mm ont été mesurés : l'incertitude vaut pour des pièces semblables
budget-warning-other-side = la pièce étalonnée du bilan est un { $calibrated ->
    [hole] alésage, mais un arbre a été mesuré
   *[shaft] arbre, mais un alésage a été mesuré
    }
budget-warning-other-expansion = { $contribution } du bilan a la dilatation { $budget } · 10⁻⁶/K, mais la valeur a été corrigée avec { $given }
budget-warning-other-temperature = { $contribution } du bilan vaut pour une température à { $budget } K de 20 °C, mais la valeur a été corrigée pour { $given } K
budget-warning-recorded = { $text }
