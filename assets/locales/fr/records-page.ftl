page-records = Relevés

## Ce qui est consigné avec un contrôle
records-page-fold = Relevé
records-page-fold-hint = Le numéro de série et la remarque sont consignés avec les contrôles suivants
records-page-serial = Numéro de série
records-page-serial-short = N° de série
records-page-remark = Remarque
records-page-feature = Élément
records-page-record = Relevé { $number }
records-page-waiting = Consignation en cours
records-page-not-recorded = Non consigné : { $why }
records-page-nowhere = Les contrôles ne sont pas consignés : il n'y a pas de dossier de données pour cela
records-page-off = Les contrôles ne sont pas consignés : la consignation est désactivée dans le fichier d'état
records-page-opening = Ouverture du journal en cours
records-page-how-on = La section [records] du fichier d'état, state.toml, nomme le fichier du journal et dit si les contrôles sont consignés.
records-page-not-opened = Le journal ne peut pas être ouvert, et les contrôles ne sont pas consignés : { $why }
records-page-not-kept = { $count ->
    [one] { $count } contrôle n'est pas consigné : { $why }
   *[other] { $count } contrôles ne sont pas consignés : { $why }
}
records-page-refused = { $count ->
    [one] { $count } contrôle ne peut pas être consigné : { $why }
   *[other] { $count } contrôles ne peuvent pas être consignés ; raison pour le premier : { $why }
}
records-page-not-kept-why = le journal n'a pas répondu
records-page-no-thread = le système ne peut pas lancer de fil d'exécution pour le journal
records-page-interrupted = interrompu
records-page-failed = { $count ->
    [one] { $count } contrôle n'est pas consigné
   *[other] { $count } contrôles ne sont pas consignés
}
records-page-try-again = Réessayer
records-page-stay = Les relevés restent dans le journal
records-page-leave = { $count ->
    [one] { $count } contrôle n'est pas encore consigné. Il est perdu si la fenêtre se ferme.
   *[other] { $count } contrôles ne sont pas encore consignés. Ils sont perdus si la fenêtre se ferme.
}

## Qui mesure
records-page-who = Mesuré par
records-page-nobody = Nom…
records-page-who-nobody = Aucun nom n'est choisi. Choisir un nom
records-page-who-is = Mesuré par { $name }
records-page-nobody-named = Sans nom
records-page-new-name = Autre nom
records-page-take-name = Utiliser ce nom

## La question
records-page-question = Rechercher
records-page-help = Mots, bon retouche rebut, ou part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = Plus
records-page-today = Aujourd'hui
records-page-this-week = Cette semaine
records-page-not-good = Non bons
records-page-measured-only = Mesurés seulement
records-page-filter = Filtre
records-page-filter-hint = Réduit la liste par pièce, numéro de série, date et plus
records-page-add-filter = Ajouter un filtre
records-page-filter-by = Filtrer par
records-page-filter-value = Valeur
records-page-from = Du
records-page-to = Au
records-page-standing = Valides seulement
records-page-simulated-only = Simulés seulement
records-page-reports-only = Rapports seulement
records-page-alarms-only = Alarmes seulement
records-page-checks-only = Sans rapports
records-page-remove-filter = Retirer le filtre { $filter }
records-page-looking = Recherche
records-page-count = { $many ->
    [one] { $count } relevé
   *[other] { $count } relevés
}
records-page-more = { $count }+ relevés
records-page-unread = Le journal ne peut pas être lu : { $why }
records-page-none = aucun journal n'est ouvert
records-page-missing = Le relevé { $number } manque
records-page-empty = Les contrôles apparaissent ici dès qu'ils sont consignés
records-page-none-found = Aucun relevé ne correspond

## La liste
records-page-list = Relevés
records-page-head-number = N°
records-page-zone = Dans l'intervalle
records-page-move = Aller à un autre relevé
records-page-open = Ouvrir le relevé
records-page-choose = Sélectionner pour un rapport
records-page-choose-record = Sélectionner le relevé { $number } pour un rapport
records-page-chosen = { $count ->
    [one] { $count } sélectionné
   *[other] { $count } sélectionnés
}
records-page-copy = Copier
records-page-report-of = Rapport ({ $count })…
records-page-reports-listed = Le rapport porte sur les { $count } relevés de la liste
records-page-reports-chosen = Le rapport porte sur les { $count } relevés sélectionnés
records-page-too-many = { $count } relevés sont listés. Un rapport ou une sélection en prend { $most } au plus : réduire la liste, par exemple par pièce ou par date
records-page-still-looking = La liste n'est pas encore complète. Réessayer quand son nombre est affiché
records-page-nothing-to-report = Aucun relevé de la liste ne peut figurer dans un rapport : ils sont non valides, simulés ou issus de cycles
records-page-report = Rapport…
records-page-with-simulated = Avec contrôles simulés
records-page-with-simulated-hint = Les contrôles simulés ne prouvent rien ; le rapport indique qu'il en contient
records-page-report-simulated = { $count ->
    [one] { $count } de ces contrôles est simulé : il ne prouve rien
   *[other] { $count } de ces contrôles sont simulés : ils ne prouvent rien
}
records-page-report-from = Du journal { $chain }, relevés { $numbers } ; son entrée la plus récente est { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] { $count } contrôle simulé est omis
   *[other] { $count } contrôles simulés sont omis
}
records-page-out-replaced = { $count ->
    [one] { $count } relevé corrigé ou retiré est omis
   *[other] { $count } relevés corrigés ou retirés sont omis
}
records-page-report-corrects = { $count ->
    [one] { $count } valeur remplace un relevé corrigé
   *[other] { $count } valeurs remplacent des relevés corrigés
}
records-page-out-cycles = { $count ->
    [one] { $count } relevé d'un cycle est omis
   *[other] { $count } relevés de cycles sont omis
}
records-page-out-reports = { $count ->
    [one] 1 rapport ou alarme est omis : ce n'est pas un contrôle
   *[other] { $count } rapports et alarmes sont omis : ce ne sont pas des contrôles
}
records-page-out-unread = { $count ->
    [one] { $count } relevé illisible est omis
   *[other] { $count } relevés illisibles sont omis
}
records-page-see = Non valide, voir { $number }
records-page-void = Relevé { $number }, non valide : voir { $by }
records-page-instead = pour { $number }
records-page-takes-back = Retire { $number }
records-page-withdrawal = Retrait
records-page-report-entry = Rapport
records-page-alarm = Alarme
records-page-alarm-answers = Réponse à l'alarme { $number }
records-page-alarm-answered = Alarme, réponse { $number }
records-page-alarm-first = Première valeur : { $number }
records-page-alarm-last = Valeur à laquelle la règle s'est déclenchée : { $number }
records-page-cycle = Cycle { $cycle }
records-page-went-back = { $time } (horloge)

## Un relevé ouvert
records-page-close = Retour à la liste
records-page-reading = Lecture du relevé
records-page-measure-again = Remesurer
records-page-measure-again-hint = Reprend cote tolérancée, pièce, numéro de série et règle dans la page Contrôle
records-page-correct = Corriger…
records-page-correct-hint = Ajoute un relevé à la place de celui-ci ; les deux restent
records-page-simulated = Simulé : personne n'a mesuré ceci
records-page-corrected-by = Corrigé ou retiré par le relevé { $number }
records-page-corrects = À la place du relevé { $number }
records-page-in-report = Dans le rapport { $number }, { $name }
records-page-reports-unread = Les rapports avec ce contrôle ne peuvent pas être lus : { $why }
records-page-report-unknown = { $name } est écrit, mais le journal ne le connaît pas : { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, alésage
    [neither] { $callout }, ni alésage ni arbre
   *[shaft] { $callout }, arbre
}
records-page-distance = Écart aux limites
records-page-importer = Importé par
records-page-void-why = Non valide pour
records-page-void-by = Corrigé ou retiré par
records-page-decided = Décision
records-page-limits = Limites
records-page-source = Limites selon
records-page-contacts = Points de palpage
records-page-rule = Règle
records-page-station = Poste
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = L'horloge du poste a été retardée avant ce relevé
records-page-cycle-number = Cycle
records-page-program = Programme
records-page-block = { $program }, ligne { $line }
records-page-datum = Point d'origine
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, fixé à la ligne { $line } : { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = axes tournés de { $angle }°, depuis la ligne { $line } : { $block }
records-page-datum-tilt = plan incliné de A { $a }°, B { $b }°, C { $c }°, depuis la ligne { $line } : { $block }
records-page-parameters = Paramètres
records-page-figures = Résultats
records-page-file-measurements = Mesures
records-page-file-program = Programme
records-page-file-workpiece = Pièce
records-page-file-budget = Bilan d'incertitude
records-page-report-file = Fichier
records-page-report-format = Format
records-page-report-size = Taille
records-page-report-bytes = { $count } octets
records-page-report-title = Titre
records-page-report-sha256 = SHA-256
records-page-report-checks = Contrôles consignés
records-page-report-numbers = Leurs relevés
records-page-report-unrecorded = Contrôles sans relevé
records-page-report-head = Entrée la plus récente alors
records-page-chain = Chaîne
records-page-chain-name = Journal
records-page-hash = Empreinte

## Une correction
records-page-correction = Corriger le relevé { $number }
records-page-correction-rule = Jugé de nouveau comme l'était le relevé { $number } : { $rule }.
records-page-correction-temperature = Corrigé de { $temperature } °C à 20 °C.
records-page-correction-rest = Pièce, numéro de série, nom
records-page-correction-hint = Un nouveau relevé prend la place de celui-ci. Les deux restent dans le journal.
records-page-corrector = Corrigé par
records-page-reason = Raison
records-page-reason-mistyped = faute de saisie
records-page-reason-wrong-part = mauvaise pièce
records-page-reason-trial = essai
records-page-withdrawal-hint = Le relevé ne compte plus, et rien ne prend sa place. Les deux entrées restent dans le journal.
records-page-withdraw = Retirer le relevé
records-page-withdraw-hint = Rien ne prend sa place
records-page-withdraw-neither = Le relevé { $number }, que celui-ci corrige, ne compte pas de nouveau
records-page-send-correction = Consigner la correction
records-page-leave-correction = Annuler
records-page-undo-void = Non annulé : le relevé a été retiré après la correction
records-page-undone-reason = annulé
records-page-taken-back = { $checks ->
    [one] { $checks } contrôle repris
   *[other] { $checks } contrôles repris
} ; { $records ->
    [one] le relevé { $numbers } est retiré
   *[other] les relevés { $numbers } sont retirés
}
records-page-taken-back-unwritten = { $checks ->
    [one] { $checks } contrôle repris ; il n'était pas encore consigné et ne le sera pas
   *[other] { $checks } contrôles repris ; ils n'étaient pas encore consignés et ne le seront pas
}
records-page-not-withdrawn = { $records ->
    [one] Le relevé { $numbers } compte toujours et n'a pas pu être retiré : { $why }
   *[other] Les relevés { $numbers } comptent toujours et n'ont pas pu être retirés : { $why }
}
records-page-undone = Correction annulée
records-page-no-reason = Une correction demande une raison
records-page-nothing-changed = Rien n'est différent : modifier un champ, ou retirer le relevé
records-page-not-open = Le relevé n'est pas ouvert
records-page-not-recording = Les contrôles ne sont pas consignés

## Le journal
records-page-place = { $file } · entrées : { $entries }
records-page-unsent = { $count } à envoyer à { $server }
records-page-all-sent = tout envoyé à { $server }
records-page-server-unknown = { $server } n'a pas encore été joint
records-page-server = Serveur de l'atelier
records-page-server-hint = Envoie chaque relevé à un serveur PostgreSQL, en arrière-plan ; sans serveur, tout reste sur cet ordinateur
records-page-server-address = Adresse, par exemple postgres://mill3@shop.example/checks
records-page-server-passwords = Le mot de passe vient de l'adresse, de PGPASSWORD, du fichier de mots de passe ou du trousseau du système. Un mot de passe dans l'adresse va au trousseau et n'est conservé nulle part ailleurs.
records-page-take-server = Utiliser ce serveur
records-page-leave-server = Arrêter l'envoi
records-page-send-again = Renvoyer
records-page-not-sent = Non envoyé : { $why }
records-page-and = { $one } ; { $other }
records-page-no-shop = ce Fitcheck a été compilé sans prise en charge d'un serveur d'atelier (feature shop)
records-page-in-keyring = Le mot de passe de { $server } est maintenant dans le trousseau du système
records-page-not-in-keyring = Le mot de passe de { $server } n'a pas pu être mis dans le trousseau du système ({ $reason }) : il est utilisé jusqu'à la fermeture de la fenêtre, puis doit venir de PGPASSWORD ou du fichier de mots de passe
records-page-verify = Vérifier
records-page-verify-hint = Vérifie chaque entrée par rapport à la précédente
records-page-verify-cancel = Annuler la vérification
records-page-verify-cancelled = Vérification annulée
records-page-verify-progress = Avancement de la vérification
records-page-verifying = { $done } entrées sur { $of }
records-page-whole = { $time } : { $entries } entrées vérifiées, jusqu'à { $number } ({ $hash })
records-page-broken = { $time } : { $entries } entrées vérifiées ; le journal n'est pas tel qu'il a été écrit
records-page-not-verified = { $time } : non vérifié : { $why }
records-page-no-anchors = les entrées connues ailleurs ne peuvent pas être lues : { $why }
