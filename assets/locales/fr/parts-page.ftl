page-parts = Pièces
parts-page-walk = Mesurer
parts-page-plan = Plan
parts-page-new = Nouveau plan
parts-page-open = Ouvrir un plan…
parts-page-save = Enregistrer le plan…
parts-page-save-csv = Enregistrer le plan en CSV…
parts-page-undo = Annuler
parts-page-redo = Rétablir
parts-page-dialog-open = Ouvrir un plan de pièce
parts-page-dialog-save = Enregistrer le plan de pièce
parts-page-not-saved = { $name }, non enregistré
parts-page-no-plan = Pas encore de plan : en ouvrir ou en créer un.
parts-page-move = Aller à une autre cellule
parts-page-extend = Étendre la sélection
parts-page-edit = Modifier la cellule
parts-page-take = Terminé
parts-page-empty = Vider les cellules
parts-page-copy = Copier les cellules
parts-page-paste = Coller
parts-page-insert = Insérer une rangée
parts-page-delete = Supprimer les rangées
parts-page-up = Monter
parts-page-down = Descendre
parts-page-sort = Trier
parts-page-sort-hint = Trie par la colonne de la cellule active, A2 avant A10 ; trier encore inverse l'ordre
parts-page-renumber = Renuméroter
parts-page-renumber-hint = Numérote les éléments à partir de 1 dans l'ordre des rangées
parts-page-all-columns = Toutes les colonnes
parts-page-previous = Erreur précédente
parts-page-next = Erreur suivante
parts-page-choose-picture = Choisir une image…
parts-page-dialog-picture = Choisir l'image de la pièce
parts-page-table = Éléments du plan
parts-page-cell-name = Cellule du plan
parts-page-cell = Rangée { $row }, { $column }, { $text }
parts-page-cell-empty = Rangée { $row }, { $column }, vide
parts-page-cell-wrong = { $cell }, erreur : { $what }
parts-page-new-row = nouvelle
parts-page-limits = Limites
parts-page-editing = { $column }, rangée { $row }
parts-page-head = Pièce
parts-page-words = Au choix : { $words }
parts-page-no-fault = Aucune erreur dans le plan
parts-page-blank = Saisir le premier élément, ou coller des rangées d'un tableur
parts-page-faults = { $count ->
    [one] { $count } erreur
   *[other] { $count } erreurs
}
parts-page-features = { $count ->
    [one] { $count } élément
   *[other] { $count } éléments
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Rangée { $row }
parts-page-fault-plan = Plan
parts-page-lost = Non compris dans le fichier : le plan ne mesure et n'enregistre rien tant que ce n'est pas corrigé dans le fichier ou omis ici
parts-page-take-meant = Prendre { $meant }
parts-page-leave-out = Omettre
parts-page-leave-out-hint = Le plan n'a alors que ce qui a pu être lu ; ce qui n'a pas été compris peut être un élément
parts-page-left-out = { $count ->
    [one] { $name } : { $count } indication non comprise est omise du plan ; le fichier la garde jusqu'à l'enregistrement du plan
   *[other] { $name } : { $count } indications non comprises sont omises du plan ; le fichier les garde jusqu'à l'enregistrement du plan
}
parts-page-pasted-rows = { $count ->
    [one] { $count } rangée collée a été ignorée : un plan a au plus { $most } éléments
   *[other] { $count } rangées collées ont été ignorées : un plan a au plus { $most } éléments
}
parts-page-pasted-columns = { $count ->
    [one] { $count } colonne collée a été ignorée : il n'y a plus de colonne à sa droite. « Toutes les colonnes » en montre davantage
   *[other] { $count } colonnes collées ont été ignorées : il n'y a plus de colonnes à droite. « Toutes les colonnes » en montre davantage
}
parts-page-column-number = N°
parts-page-column-name = Nom
parts-page-column-kind = Type
parts-page-column-axis = Axe
parts-page-column-callout = Cote
parts-page-column-callout2 = Cote Y
parts-page-column-feature = Alésage ou arbre
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Angle
parts-page-column-clearance = Dist. appr.
parts-page-column-clearance-height = Haut. sécurité
parts-page-column-cycle = Cycle
parts-page-column-parameters = Paramètres
parts-page-column-material = Matière
parts-page-column-rule = Règle
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Plausible
parts-page-column-plausible2 = Plausible Y
parts-page-column-remark = Remarque
parts-page-column-balloon-x = Bulle X
parts-page-column-balloon-y = Bulle Y
parts-page-head-part = Pièce
parts-page-head-drawing = Dessin
parts-page-head-picture = Image
parts-page-head-material = Matière
parts-page-head-rule = Règle
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Course X (mm)
parts-page-head-travel-y = Course Y (mm)
parts-page-head-travel-z = Course Z (mm)
parts-page-head-remark = Remarque
parts-page-head-file = fichier à côté du plan
parts-page-head-two = min max
parts-page-picture = Image de la pièce
parts-page-picture-said = Image de la pièce, { $on } bulles placées sur { $count }
parts-page-picture-none = Pas d'image
parts-page-picture-awaited = Lecture de l'image
parts-page-picture-folder = { $given } n'est pas le nom d'un fichier à côté du plan : l'image doit être dans le dossier du plan, donner donc son nom sans dossier
parts-page-picture-unsaved = Enregistrer d'abord le plan : l'image doit être dans le même dossier
parts-page-picture-elsewhere = { $given } n'est pas dans le dossier du plan : l'y copier d'abord, pour que les deux restent ensemble
parts-page-picture-large = { $name } a { $given } Kio ; une image a au plus { $most } Kio
parts-page-picture-dots = { $name } a { $width } × { $height } pixels ; une image a au plus { $most } millions de pixels
parts-page-picture-kind = { $name } n'est pas une image PNG, JPEG ou SVG
parts-page-picture-broken = { $name } ne peut pas être lu comme image : { $reason }
parts-page-balloon = Bulle { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, suivante
parts-page-balloon-beside = { $balloon }, hors de l'image
parts-page-balloon-open = non mesurée
parts-page-balloon-skipped = ignorée
parts-page-beside = Pas encore sur l'image : les y faire glisser
parts-page-beside-more = et { $count } de plus
parts-page-balloon-simulated = { $status }, simulée
parts-page-more = Rangées et cellules
parts-page-picture-heavy = { $name } serait trop long à dessiner : il a des filtres, de grands motifs ou trop de calques ; les enlever, ou enregistrer l'image en PNG
parts-page-csv-copy = Le fichier est une copie : CSV n'a que les éléments, et { $keys } de la pièce est omis
parts-page-opened = { $count ->
    [one] { $name } est ouvert, mais le plan omet { $count } chose que contient le fichier
   *[other] { $name } est ouvert, mais le plan omet { $count } choses que contient le fichier
}
parts-page-pasted-twice = Une colonne collée a été omise : la première rangée nomme { $keys } plus d'une fois, et la première colonne de ce nom est utilisée
parts-page-pasted-unknown = Des colonnes collées que n'a pas un plan ont été omises : { $names }
parts-page-pasted-nameless = { $count ->
    [one] { $count } colonne collée a été omise : la première rangée n'a pas de nom au-dessus d'elle
   *[other] { $count } colonnes collées ont été omises : la première rangée n'a pas de noms au-dessus d'elles
}
parts-page-comments = { $count ->
    [one] L'enregistrement supprime { $count } commentaire du fichier
   *[other] L'enregistrement supprime { $count } commentaires du fichier
}
parts-page-comments-lost = { $count ->
    [one] { $count } commentaire a été supprimé dans { $name } : un plan s'écrit sans commentaires
   *[other] { $count } commentaires ont été supprimés dans { $name } : un plan s'écrit sans commentaires
}
