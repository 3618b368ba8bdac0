# pairing

pairing-not-a-range = jeux { $given } : le plus petit et le plus grand en mm attendus, avec deux points entre eux, par exemple 0.010..0.030
pairing-minimum = jeu minimal : { $reason }
pairing-maximum = jeu maximal : { $reason }
pairing-swapped = le jeu minimal { $minimum } mm est plus grand que le maximal, { $maximum } mm
pairing-too-narrow = les { $feature ->
        [hole] alésages
       *[shaft] arbres
    } de { $from } à { $to } mm ne peuvent pas être triés en { $count } groupes : un groupe a au moins un nanomètre
pairing-group-count = { $count } groupes : 1 à { $most } attendus
pairing-no-sizes = il n'y a pas { $feature ->
        [hole] d'alésages
       *[shaft] d'arbres
    } à trier

# Ce qu'il faut vérifier sur les pièces
pairing-parts-outside-limits = { $count ->
        [one] { $count } pièce est hors de ses propres limites
       *[other] { $count } pièces sont hors de leurs propres limites
    } : les paires sont choisies selon le jeu seul
pairing-parts-checked-twice = { $rows ->
        [one] { $rows } contrôle a le nom d'un contrôle antérieur
       *[other] { $rows } contrôles ont le nom d'un contrôle antérieur
    }, par exemple { $id }, contrôles { $first } et { $second } : chaque contrôle compte comme une pièce
pairing-parts-simulated-checks = { $count ->
        [one] { $count } contrôle est simulé
       *[other] { $count } contrôles sont simulés
    } : rien n'a été mesuré
