# report

## Erreurs
report-error-writer = le rapport { $format } n'a pas pu être établi : { $reason }
report-error-label-alone = { $format } est pour les étiquettes : choisissez le modèle label, ou le papier small-label ou large-label
report-error-no-statistics = { $format } n’a pas de place pour les statistiques : choisir PDF, HTML ou Markdown
report-attachment-too-large = les données du fichier dépassent { $most } octets
report-attachment-packed = les données du fichier sont compressées avec { $filter }, que Fitcheck ne lit pas
report-attachment-damaged = les données du fichier sont endommagées : { $reason }
report-attachment-several = le fichier a { $count } pièces jointes avec des contrôles : une seule est attendue
report-difference-field = entrée { $number } : { $field } est { $said } dans le fichier, { $kept } dans le journal
report-difference-missing = entrée { $number } : aucun contrôle du fichier ne dit ce que dit le journal
report-difference-more = { $count ->
    [one] le fichier a 1 contrôle de trop
   *[other] le fichier a { $count } contrôles de trop
}
report-difference-fewer = { $count ->
    [one] il manque 1 contrôle dans le fichier
   *[other] il manque { $count } contrôles dans le fichier
}
report-data-json = les données du fichier ne sont pas un rapport de Fitcheck : { $reason }
report-ending-missing = { $file } n'a pas d'extension qui donne le format du rapport : utiliser { $endings }
report-ending-unknown = .{ $ending } n'est pas un format du rapport : utiliser { $endings }

## Phrases sur un contrôle
report-feature-hole = alésage
report-feature-shaft = arbre
report-feature-neither = ni alésage ni arbre
report-side-good = bon
report-side-rework = retouche
report-side-scrap = rebut
report-side-out = hors tolérance
report-side-too-small = trop petit
report-side-too-large = trop grand
report-source-instead = { $source } ; ISO 286 donne ici { $upper } et { $lower } µm
report-too-small = { $um } µm trop petit
report-too-large = { $um } µm trop grand
report-inside = dans les limites
report-above-minimum = { $um } µm au-dessus du minimum
report-below-minimum = { $um } µm sous le minimum
report-below-maximum = { $um } µm sous le maximum
report-above-maximum = { $um } µm au-dessus du maximum
report-position-unknown = non mesurée
report-position-unmonitored = non surveillée
report-position-in = DANS
report-position-out = HORS
report-axis-unmonitored = { $axis } { $deviation } mm : non surveillé
report-axis-in = { $axis } { $deviation } mm, admis ± { $tolerance } mm : DANS
report-axis-out = { $axis } { $deviation } mm, admis ± { $tolerance } mm : HORS
report-cause-position = le centre est hors position ; la cote seule donne { $status }
report-origin-circle = { $origin } ; cercle des moindres carrés par { $contacts } points de palpage
report-centre = centre mesuré X { $x } mm, Y { $y } mm
report-band-nominal = cote nominale { $size } mm
report-band-title = Bande des limites, mesuré { $value } : { $distances }
report-in-guard-band = rien n'est décidé : la valeur est dans une bande de garde de la règle de décision
report-corrected = mesuré { $measured } mm à { $temperature } °C, dilatation { $expansion } · 10⁻⁶/K : corrigé de { $change } µm à { $reference } mm à 20 °C
report-all-corrected = mesuré à { $temperature } °C, dilatation { $expansion } · 10⁻⁶/K ; chaque valeur est corrigée à 20 °C
report-scales = systèmes de mesure à { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = sans correction des systèmes de mesure
report-own-uncertainty = u de chaque valeur à côté de son contrôle
report-accepted-zone = { $least } à { $most } mm
report-accepted-none = aucune : la règle ne laisse rien de cette tolérance
report-proven = prouvé selon cette règle
report-not-proven = non prouvé selon cette règle
report-conformity = conforme avec une probabilité de { $percent } %
report-budget-made = { $name }, créé le { $date } par { $by }, valable jusqu'au { $until }
report-budget-expired = PÉRIMÉ le jour du contrôle
report-budget-not-yet = PAS ENCORE VALABLE le jour du contrôle
report-guard-undecided = bande de garde : remesurer
report-guard-beyond = bande de garde : accepté au-delà de la limite
report-guard-range = { $what }, { $from } à { $to } µm

## La page
report-title = Rapport de contrôle
report-part = Pièce
report-order = Ordre de fabrication
report-inspector = Contrôleur
report-program = Programme
report-notes = Rangées ignorées et avertissements
report-no-checks = Ce rapport n'a aucun contrôle.
report-page-all-good = Aucun des { $total } contrôles n'est listé dans cette page : tous sont bons et aucun n'est douteux. Un rapport CSV ou JSON liste chaque contrôle.
report-page-not-good = Cette page ne liste que les { $listed } contrôles, sur { $total }, non bons ou douteux. Les nombres comprennent tous les contrôles ; un rapport CSV ou JSON les liste tous.
report-page-first = Cette page ne liste que les { $listed } premiers des { $wanted } contrôles non bons ou douteux, sur { $total } contrôles. Les nombres comprennent tous les contrôles ; un rapport CSV ou JSON les liste tous.
report-total = Total
report-check = Contrôle
report-id = Nom
report-callout = Cote tolérancée
report-heading-without-callout = { $nominal } mm, limites sans classe
report-verdict = Verdict
report-nominal = Cote nominale
report-maximum = Maximum
report-minimum = Minimum
report-measured = Mesuré
report-deviation = Écart
report-remove = À enlever
report-on-diameter = au diamètre
report-per-side = par côté
report-remove-to-limit = jusqu'à la limite la plus proche
report-remove-to-middle = jusqu'au milieu de l'intervalle
report-remove-to-accepted = jusqu'aux valeurs acceptées
report-position = Position
report-limits-from = Limites selon
report-measured-from = Valeur mesurée
report-from = Origine
report-limits = Limites
report-missing = Manquantes
report-skipped = Ignorées
report-verdict-from = Règle de décision
report-temperature = Température
report-accepted = Valeurs acceptées
report-proof = Preuve
report-budget = Bilan d'incertitude
report-cannot-tell = Limites de cette mesure
report-contacts = Points de palpage
report-contacts-at-end = à la fin du rapport
report-contact = N°
report-radial = écart radial
report-sign-name = Nom
report-sign-date = Date
report-sign-signature = Signature
report-footer = Chaque verdict repose sur des valeurs non arrondies et sur les limites et la règle de décision indiquées à côté.

## Notes
report-note = { $place } : { $what }
report-note-line = { $place }, ligne { $line } : { $what }
report-note-more = { $count ->
    [one] { $count } autre note n'est pas listée
   *[other] { $count } autres notes ne sont pas listées
}

## Une pièce complète
report-balloon = Bulle
report-picture-room = { $name } n'est pas affiché ici : les images de toutes les pièces rendraient la page trop grande
report-picture-beside = { $count ->
    [one] { $count } élément n'y a pas de bulle
   *[other] { $count } éléments n'y ont pas de bulle
}
report-part-older = { $count ->
    [one] { $count } autre valeur n'est pas listée : pour chaque cote, seule la valeur qui compte est listée
   *[other] { $count } autres valeurs ne sont pas listées : pour chaque cote, seule la valeur qui compte est listée
}
report-more-parts = { $count ->
    [one] { $count } autre pièce n'est pas présentée en entier, seulement les { $most } premières ; ses valeurs sont dans la liste
   *[other] { $count } autres pièces ne sont pas présentées en entier, seulement les { $most } premières ; leurs valeurs sont dans la liste
}

## Modèles de rapport
report-template-toml = { $reason }
report-template-version = la version { $found } du modèle n’est pas prise en charge : il faut la version { $known }
report-template-too-large = un modèle compte au plus { $most } octets
report-template-text = { $key } est vide, dépasse { $longest } caractères ou contient un caractère de contrôle
report-template-twice = { $key } cite { $word } deux fois
report-template-empty = { $key } est vide : il faut au moins une entrée
report-template-language = { $given } n’est pas une langue de rapport : utiliser { $known }
report-template-logo = le logo { $given } doit être le nom d’un fichier à côté du modèle
report-section-verdict = Verdict
report-section-head = En-tête
report-section-picture = Image avec bulles
report-section-lot = Pièces, la pire d’abord
report-section-statistics = Statistiques des éléments
report-statistics-limits = Les limites diffèrent d’une valeur à l’autre : aucune capabilité n’est indiquée.
report-statistics-most = Les statistiques ne comprennent que les { $count } premières valeurs.
report-section-features = Valeurs
report-section-statement = Déclaration de conformité
report-section-rule = Règle et limites en toutes lettres
report-section-caveats = Limites de la mesure
report-section-remarks = Remarques
report-section-signature = Ligne de signature
report-section-code = Code du relevé
report-revision = Révision
report-serial = Numéro de série
report-batch = Lot
report-customer = Client
report-material = Matière
report-station = Poste
report-instrument = Instrument
report-calibrated = Étalonné
report-date = Date
report-plan = Gamme
report-records = Relevés
report-blank = Valeur
report-remark = Remarque
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Étiquette 62 × 29 mm
report-paper-large-label = Étiquette 100 × 50 mm
report-template-inspection = Rapport de contrôle
report-template-inspection-purpose = Pièces ou contrôles, avec images
report-template-first-article = Premier article
report-template-first-article-purpose = Chaque élément, même ce qui manque
report-template-certificate = Certificat
report-template-certificate-purpose = Valeurs et déclaration de conformité
report-template-list = Liste des contrôles
report-template-list-purpose = Tous les contrôles à la suite
report-template-statistics = Statistiques
report-template-statistics-purpose = Chaque élément sur toutes ses valeurs, avec graphiques
report-template-sheet = Feuille de mesure
report-template-sheet-purpose = Vide, à remplir à la main
report-template-label = Étiquette
report-template-label-purpose = Verdict, pièce et numéro de série
## Pages à imprimer
report-pdf-page = Page { $page } sur { $pages }
report-pdf-band = Bande des limites
report-pdf-remove = { $name } : enlever { $um } µm au diamètre
report-pdf-simulated = Valeurs simulées, que personne n'a mesurées : { $count } sur { $total }
report-pdf-beyond = Valeurs acceptées hors des limites par la règle de décision : { $count } sur { $total }
report-pdf-corrected = Valeurs corrigées à 20 °C : { $count } sur { $total }
report-pdf-guarded = Valeurs jugées par une règle de décision propre : { $count } sur { $total }
report-pdf-doubted = Valeurs douteuses, marquées d'un point d'interrogation : { $count } sur { $total }
report-pdf-notes = Rangées ignorées et avertissements, listés à la fin : { $count }
report-pdf-more-lacks = Autres, sur les pages des pièces : { $count }
report-pdf-more = Autres, dans les données jointes : { $count }
report-pdf-all-checks = Tous les contrôles
report-pdf-attached = Joint à ce fichier, pour les programmes : { $names }
report-pdf-not-attached = Toutes les données ne sont pas jointes : un fichier de plus de { $most } Mo serait trop grand
report-pdf-contacts = Les points de palpage sont dans les données jointes.
report-pdf-cut = Un texte qui finit par … est coupé ici ; il est entier dans les données jointes.
report-pdf-substituted = Un □ remplace un caractère que les polices de ces pages n'ont pas, comme ceux qui s'écrivent de droite à gauche ; le texte copié et les données jointes contiennent ce caractère.
report-statement-conforms = { $count ->
    [one] Déclaration de conformité : la valeur est dans ses limites selon la règle de décision indiquée.
   *[other] Déclaration de conformité : les { $count } valeurs sont toutes dans leurs limites selon la règle de décision indiquée.
}
report-statement-not = { $count ->
    [one] Pas de conformité : la valeur n’est pas conforme selon la règle de décision indiquée.
   *[other] Pas de conformité : { $bad } valeurs sur { $count } ne sont pas conformes selon la règle de décision indiquée.
}
report-statement-partial = Pas de déclaration de conformité : certaines rangées ont été refusées, n’ont pas été évaluées ou n’ont pas été lues. Le rapport les indique.
report-statement-simulated = { $count ->
    [one] Pas de déclaration de conformité : une valeur est simulée et n’a été mesurée par personne.
   *[other] Pas de déclaration de conformité : { $count } valeurs sont simulées et n’ont été mesurées par personne.
}
report-statement-open = Pas de déclaration de conformité : il manque des valeurs, { $count } en tout.
report-code-said = Code du relevé { $number }, son empreinte { $hash }
report-lot-order = La pire pièce vient en premier.
## Un classeur
report-sheets = Seules les { $listed } premières pièces sur { $total } ont leur propre feuille ; la feuille des pièces les liste toutes.
report-sheets-corrected = corrigé à 20 °C
report-sheets-without = Les images et les points de palpage ne sont pas dans ce classeur : un rapport HTML contient les deux, un rapport JSON les points de palpage.
report-sheets-cut = { $count ->
    [one] { $count } texte est abrégé : une cellule contient au plus 32767 caractères.
   *[other] { $count } textes sont abrégés : une cellule contient au plus 32767 caractères.
}
report-journal = Relevés { $numbers } du journal { $chain } ; sa dernière entrée alors : { $number }:{ $hash }
report-template-new-about = Un modèle de rapports. Supprimez ce qu’un rapport ne doit pas montrer ; enlevez le # devant ce qu’il doit montrer.
report-template-new-name = Nouveau modèle
report-changed-since = Modifié depuis le rapport du { $since } :
report-changed-none = aucun résultat ni aucune limite
report-changed-result = { $name } : { $before } → { $now }
report-changed-limits = { $name } : limites de { $low } à { $high } → de { $lower } à { $higher } mm
report-changed-added = { $name } : nouveau
report-changed-removed = { $name } : ne figure plus dans le rapport
report-changed-several = { $name } : non comparé, car il y a plusieurs valeurs
report-since-no-report = n’est pas un rapport de Fitcheck avec ses données : indiquez son PDF ou son JSON
