page-pairing = Appariement

# Ce qui est demandé
pairing-page-wanted = Jeu ou ajustement voulu
pairing-page-wanted-hint = Le plus petit et le plus grand en mm, par exemple 0.010..0.030, ou un ajustement, par exemple 25 H7/g6. Négatif : serrage.
pairing-page-wanted-range = Jeu { $minimum } … { $maximum } µm, milieu { $middle } µm
pairing-page-wanted-fit = { $fit } : jeu { $minimum } … { $maximum } µm, milieu { $middle } µm
pairing-page-wanted-refused = { $reason } ; sont admis un ajustement, par exemple 25 H7/g6, et deux jeux en mm, par exemple 0.010..0.030
pairing-page-holes = Alésages mesurés
pairing-page-shafts = Arbres mesurés
pairing-page-no-parts = aucun encore
pairing-page-reading = lecture…
pairing-page-from-file = { $name }, { $count ->
        [one] { $count } pièce
       *[other] { $count } pièces
    }
pairing-page-from-history = De l'historique, { $count ->
        [one] { $count } pièce
       *[other] { $count } pièces
    }
pairing-page-refused = { $count ->
        [one] { $count } rangée refusée
       *[other] { $count } rangées refusées
    }
pairing-page-all-refused = Les { $count } rangées refusées
pairing-page-all-notes = Les { $count } avertissements
pairing-page-open-holes = Ouvrir les alésages…
pairing-page-open-shafts = Ouvrir les arbres…
pairing-page-history-holes = Alésages de l'historique
pairing-page-history-shafts = Arbres de l'historique
pairing-page-history-hint = Prend les contrôles sélectionnés, ou toute la liste si aucun ne l'est
pairing-page-groups = Groupes
pairing-page-groups-hint = Nombre de groupes de même largeur dans lesquels les pièces sont aussi triées. Vide : aucun.
pairing-page-do-wanted = Saisir le jeu voulu ou un ajustement.
pairing-page-do-holes = Ouvrir les alésages mesurés, ou les prendre de l'historique.
pairing-page-do-shafts = Ouvrir les arbres mesurés, ou les prendre de l'historique.
pairing-page-about = Fitcheck forme le plus de paires possible dans le jeu voulu. De toutes les façons d'y parvenir, il prend celle dont la somme des carrés des écarts au milieu est la plus petite. Des noms et des cotes mesurées suffisent. Des fichiers peuvent aussi être déposés ici, les alésages d'abord.
pairing-page-no-side = { $name } n'est pas ouvert : il y a déjà des alésages et des arbres. L'ouvrir comme alésages ou comme arbres.
pairing-page-none-in-history = L'historique n'a pas de contrôles { $feature ->
        [hole] d'alésages
       *[shaft] d'arbres
    }.
pairing-page-listed-only = L'historique est filtré : les { $feature ->
        [hole] alésages
       *[shaft] arbres
    } viennent des { $listed } contrôles listés sur { $all }
pairing-page-none-chosen = Aucun des contrôles sélectionnés n'est celui d'un { $feature ->
        [hole] alésage
       *[shaft] arbre
    }.
pairing-page-nothing-read = { $name } n'a aucune cote utilisable : { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }({ $count } rangées refusées)
    }
pairing-page-nothing-to-save = il n'y a pas de paires à enregistrer

# Les paires
pairing-page-pairs = Paires
pairing-page-hole = Alésage
pairing-page-shaft = Arbre
pairing-page-clearance = Jeu
pairing-page-from-middle = Écart au milieu
pairing-page-from-middle-head = Du milieu
pairing-page-remark = Remarque
pairing-page-line = ligne { $line }
pairing-page-check = contrôle { $line }
pairing-page-hole-simulated = alésage simulé
pairing-page-shaft-simulated = arbre simulé
pairing-page-both-simulated = les deux simulés
pairing-page-list = Paires d'alésages et d'arbres
pairing-page-row = { $hole } { $hole-mm } mm avec { $shaft } { $shaft-mm } mm, jeu { $clearance } µm, à { $middle } µm du milieu
pairing-page-move = Aller à une autre paire
pairing-page-copy = Copier les paires

# L'image
pairing-page-picture = Pièces par cote
pairing-page-legend = Anneau : alésage. Disque : arbre, décalé du milieu, { $middle } µm : une paire au milieu est à l'horizontale. Croix : reste.
pairing-page-part-of = À gauche : toutes les pièces ; le cadre marque celles qui sont dessinées.
pairing-page-thinned = Trop serrées pour tout dessiner : 1 sur { $step } est dessinée.
pairing-page-left-over = reste
pairing-page-describe = { $holes ->
        [one] { $holes } alésage
       *[other] { $holes } alésages
    } à gauche, { $shafts ->
        [one] { $shafts } arbre
       *[other] { $shafts } arbres
    } à droite, sur une même échelle de cotes ; les arbres sont décalés de { $middle } µm, pour qu'une paire au milieu du jeu voulu soit à l'horizontale. { $pairs ->
        [one] { $pairs } paire est dessinée par une ligne.
       *[other] { $pairs } paires sont dessinées par des lignes.
    }
pairing-page-describe-part = { $pairs ->
        [one] { $pairs } paire est visible.
       *[other] { $pairs } paires sont visibles.
    }
pairing-page-describe-selected = Sélection : { $hole } avec { $shaft }, jeu { $clearance } µm.

# La réponse
pairing-page-count = { $count ->
        [one] { $count } paire
       *[other] { $count } paires
    }
pairing-page-none = Pas de réponse
pairing-page-at-work = Appariement…
pairing-page-nothing-left = aucun reste
pairing-page-left = reste : { $holes ->
        [one] { $holes } alésage
       *[other] { $holes } alésages
    }, { $shafts ->
        [one] { $shafts } arbre
       *[other] { $shafts } arbres
    }
pairing-page-simulated = { $count ->
        [one] { $count } paire avec une pièce simulée
       *[other] { $count } paires avec une pièce simulée
    }
pairing-page-no-pair = Aucun alésage et arbre n'ont un jeu dans la plage voulue.
pairing-page-smallest = Jeu minimal
pairing-page-largest = Jeu maximal
pairing-page-middle = Milieu voulu
pairing-page-band = Bande autour
pairing-page-grinding = Rectification
pairing-page-grind = { $amount } µm à enlever aux arbres restants, ou dans les alésages restants : { $count ->
        [one] { $count } paire de plus
       *[other] { $count } paires de plus
    }
pairing-page-grind-means = La plus petite quantité, par pas de 1 µm, qui donne le plus de paires supplémentaires. Les paires existantes sont conservées.
pairing-page-grind-nothing = Aucune quantité ne donne une autre paire.
pairing-page-grind-bounded = Des quantités jusqu'à { $tried } µm ont été essayées ; les pièces les plus éloignées demanderaient { $reach } µm.
pairing-page-groups-title = Groupes
pairing-page-group = Groupe { $number } : { $count ->
        [one] { $count } paire
       *[other] { $count } paires
    }
pairing-page-all-within = ✓ toutes dedans
pairing-page-not-all-within = ✗ pas toutes dedans
pairing-page-no-group-pairs = un côté est vide
pairing-page-group-holes = { $count ->
        [one] { $count } alésage
       *[other] { $count } alésages
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] { $count } arbre
       *[other] { $count } arbres
    } { $from } … { $to } mm
pairing-page-group-clearance = jeu { $range }
pairing-page-outside-groups = Dans aucun groupe, hors des intervalles : { $holes ->
        [one] { $holes } alésage
       *[other] { $holes } alésages
    }, { $shafts ->
        [one] { $shafts } arbre
       *[other] { $shafts } arbres
    }

# Fichiers
pairing-page-save-csv = Enregistrer en CSV…
pairing-page-save-json = Enregistrer en JSON…
pairing-page-file-name = paires
pairing-page-dialog-holes = Ouvrir les alésages mesurés
pairing-page-dialog-shafts = Ouvrir les arbres mesurés
pairing-page-dialog-save = Enregistrer les paires
file-kind-holes = Alésages mesurés
file-kind-shafts = Arbres mesurés
file-kind-pairs = Paires
