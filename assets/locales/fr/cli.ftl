# La ligne de commande

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what } : { $error }
cli-warning = avertissement : { $what }
cli-remark = note : { $what }

# Sur quoi porte une erreur
cli-what-callout = cote tolérancée
cli-what-measured-value = valeur mesurée
cli-what-hole = alésage
cli-what-shaft = arbre
cli-what-measured-hole = alésage mesuré
cli-what-measured-shaft = arbre mesuré
cli-what-hole-material = matière de l'alésage
cli-what-shaft-material = matière de l'arbre
cli-what-temperature = température
cli-what-smallest-clearance = jeu minimal
cli-what-largest-clearance = jeu maximal
cli-what-nominal-size = cote nominale { $text }
cli-what-true-diameter = diamètre réel
cli-what-simulated-workpiece = pièce simulée
cli-what-simulated-measurement = mesure simulée
cli-what-perfect-workpiece = pièce à la cote nominale
cli-what-size = cote
cli-what-cycle = cycle { $code }
cli-what-log = procès-verbal
cli-what-entry = entrée { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Erreurs
cli-batch-simulated = les premières lignes de { $name } disent qu'il est simulé, et seul CSV peut les conserver : écrire du CSV
cli-dash = - est la sortie standard, impossible ici : donner un nom, ou ./- pour un fichier ou dossier nommé -
cli-no-subcommand = { $given } n’est pas une sous-commande ; il y a ici : { $names }
cli-not-above-zero = { $diameter } mm n'est pas supérieur à 0
cli-ratio-of-one-limit = la règle asme-simple compare l'incertitude à la tolérance : --lower et --upper attendus
cli-already-corrected = --temperature : le fichier dit que ses valeurs sont déjà à 20 °C
cli-not-a-multiple = { $given } : nombre supérieur à 0 attendu, avec au plus trois décimales
cli-no-limits = donner --lower, --upper ou les deux, la limite inférieure sous la supérieure
cli-risk-without-uncertainty = les risques d'un procédé demandent --u ou --expanded
cli-risk-without-process = --consumer-risk demande --process-mean et --process-sd, ou --gamma
cli-not-a-risk = risque { $given } : probabilité entre 0 et 1 attendue, par exemple 0.001
cli-not-a-gamma = loi gamma { $given } : sa forme et son échelle en µm attendues, par exemple 4,0.25
cli-no-zone-for-risk = aucune zone de valeurs acceptées n'a ce risque du client
cli-line-too-long = la ligne dépasse { $limit } octets
cli-not-a-table = { $name } n'est pas une table d'écarts
cli-stats-features = plusieurs caractéristiques : en choisir une avec --feature : { $names }
cli-stats-no-feature = pas de caractéristique { $given } : les fichiers ont { $names }
cli-stats-limits = les limites diffèrent d'une valeur à l'autre : donner --lower et --upper, ou choisir une caractéristique avec --feature
cli-stats-no-point = pas de point { $point } : la carte en a { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (si c'est juste : --confirm-layout)
cli-stats-no-budget = cette étude ne donne aucune contribution à un bilan
cli-stats-no-picture = aucune image possible : { $why }
cli-stats-points = --stage et --leave-out valent pour une caractéristique : la choisir avec --feature au lieu de --all
cli-stats-parameters = --parameters vaut pour --chart ewma ou cusum
cli-add-feature = { $error } : ajouter --feature hole ou --feature shaft
cli-add-wide-zone = { $asked } : { $error } ; si cet intervalle est voulu, ajouter --wide-zone
cli-add-far-temperature = { $what } : { $error } ; si cette température est voulue, ajouter --far-temperature
cli-remark-open = { $count ->
    [one] une valeur est hors limites ; retouche ou rebut dépend d'alésage ou arbre : ajouter --feature hole ou --feature shaft, une colonne kind avec ces mots, ou un plan
   *[other] { $count } valeurs sont hors limites ; retouche ou rebut dépend d'alésage ou arbre : ajouter --feature hole ou --feature shaft, une colonne kind avec ces mots, ou un plan
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked } : { $um } µm au-dessus du maximum ; retouche ou rebut dépend d'alésage ou arbre : ajouter --feature hole ou --feature shaft
   *[below] { $asked } : { $um } µm au-dessous du minimum ; retouche ou rebut dépend d'alésage ou arbre : ajouter --feature hole ou --feature shaft
}
cli-parts-of-several = les pièces mesurées sont d'un seul ajustement : donner une seule cote tolérancée
cli-search-with-parts = une recherche ne prend ni pièces mesurées, ni matières, ni températures
cli-search-without-size = une recherche demande une cote nominale, par exemple 25
cli-search-without-clearance = une recherche demande --min-clearance et --max-clearance
cli-table-ending = { $path } : le nom d'une table de commande finit par .tab
cli-format-ending = { $path } : un fichier de format { $format } finit par .{ $endings }
cli-several-tables = une table de commande est un seul fichier : nommer une seule table, ou des classes d'un seul côté, alésage ou arbre
cli-report-format = --format { $format } ne va pas avec l'extension de { $file } : omettre l'un des deux
cli-stopped = arrêté par Ctrl+C après { $rows } rangées
cli-report-empty = aucun contrôle n'était utilisable, aucun rapport n'a donc été écrit
cli-inputs-too-large = les données d'un cycle ont au plus { $most } Kio
cli-not-an-object = les données doivent être un objet JSON tel que {"{"}"Q263": 35{"}"} : { $error }
cli-not-an-input = { $name } = { $value } : nombre ou texte attendu
cli-given-twice = { $name } est donné deux fois
cli-option-of-standard = --{ $option } n'a pas d'effet avec --source control : les tables de la commande ont une seule édition d'ISO 286
cli-set-twice = { $name } est défini deux fois
cli-several-blocks = plusieurs cycles de mesure, aux lignes { $blocks } : en choisir un par --at LIGNE
cli-other-cycle = c'est le cycle { $given }, et non { $wanted }
cli-not-predef = PREDEF n'est pas admis pour le paramètre { $name }
cli-no-probe = le tableau de palpeurs n'a pas de palpeur { $number }
cli-not-a-pair = { $text } : écrire un paramètre sous la forme NAME=VALUE
cli-not-a-position = position { $text } : trois nombres X,Y,Z en mm attendus
cli-not-a-number = ce n'est pas un nombre
cli-no-folder = dossier introuvable : { $path }
cli-watched-already = un autre programme surveille { $path } pour ce journal
cli-no-program = { $error } ; les programmes intégrés sont { $names }
cli-option-beside-plan = --{ $option } est pour une seule cote tolérancée : un plan a une colonne pour cela
cli-option-missing = --{ $option } manque : une seule cote tolérancée demande --x, --y et --z
cli-batch-ending = { $path } : la sortie doit finir par .{ $endings }, suivi de .gz ou .zst pour la compresser
cli-batch-onto-itself = { $path } est l'une des entrées : écrire les réponses dans un autre fichier
cli-batch-columns = { $name } a d'autres colonnes que le premier fichier, qui a { $columns }
cli-batch-separator = { $name } a un autre séparateur que le premier fichier : écrire .jsonl, ou juger ce fichier à part
cli-batch-types = la colonne { $column } de { $name } a un autre type dans le premier fichier : écrire .csv, ou juger ce fichier à part
cli-batch-packed = { $path } : Parquet est déjà compressé : omettre .gz ou .zst
cli-batch-twice = { $name } a deux colonnes nommées { $column } : écrire .csv, qui admet les deux
cli-batch-input = { $name } : { $error }
cli-batch-name = { $name } a déjà une colonne { $column } : utiliser --prefix pour mettre un mot devant les noms des colonnes ajoutées
cli-use-force = { $error } ; --force écrase

# Un --check d'un rapport
cli-check-no-measured = { $text } n'a pas de valeur mesurée : écrire une cote tolérancée, = et des millimètres, par exemple 25 H7=25,012
cli-check-measured = valeur mesurée : { $value }
cli-check-not-positive = la valeur mesurée { $measured } mm n'est pas supérieure à 0

# Remarques
cli-remark-wrote = { $path } écrit
cli-remark-wrote-files = { $path } écrit ({ $count } fichiers)
cli-remark-simulated = simulé : rien n'a été mesuré
cli-remark-perfect-workpiece = simulé : chaque cycle a mesuré une pièce parfaite à la cote nominale ; pour une autre pièce, utiliser --workpiece FILE.toml
cli-remark-corrected = mesuré { $measured } mm à { $temperature } °C : { $change } µm, donc { $at-reference } mm à 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = chaque valeur mesurée est corrigée de { $temperature } °C à 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = systèmes de mesure à { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = la correction linéaire diffère de l'exacte de { $off } µm
cli-remark-rule = règle : { $rule }
cli-remark-rule-by-budget = règle : { $rule }
cli-remark-budget = incertitude selon le bilan { $name }, créé le { $date }, valable jusqu'au { $until }
cli-remark-budget-contacts = dispersion de { $touches } points de palpage{ $step }, facteur géométrique { $factor }
cli-remark-accepted = accepté : { $least } à { $most } mm
cli-remark-nothing-accepted = aucune valeur n'est acceptée : la règle ne laisse rien de cette tolérance
cli-remark-proven = prouvé selon cette règle
cli-remark-not-proven = non prouvé selon cette règle
cli-remark-conformity = conforme avec une probabilité de { $percent } %
cli-remark-remove = enlever { $limit } mm jusqu'à la limite la plus proche, { $middle } mm jusqu'au milieu de l'intervalle
cli-remark-refused = { $refused } cotes tolérancées refusées sur { $asked }
cli-remark-no-pair = aucun ajustement ne convient ; le plus proche est { $nearest }
cli-remark-trace-ends = la trace finit ici, après { $blocks } séquences
cli-remark-batch-utf16 = { $name } est en UTF-16 et est écrit en UTF-8
cli-remark-batch-floats = { $name } a des nombres à virgule flottante dans { $columns } : chacun est jugé comme le nombre décimal le plus court qui le représente
cli-remark-tools-not-written = le tableau d'outils n'est pas écrit : --tools-out FILE.t l'écrit avec ces modifications
cli-remark-clearance-height = la hauteur de sécurité est { $height } mm : --clearance-height la change
cli-remark-more-entries = seules { $limit } entrées sont listées : pour davantage, utiliser --limit N
cli-remark-backed-up = copié jusqu'à l'entrée { $number } dans { $path } (empreinte { $hash })
cli-remark-no-head-known = aucune entrée de ce journal n'est connue ailleurs : l'absence des plus récentes ne serait pas détectée

# Avertissements
cli-warning-stopped-unrecorded = rien n'a été consigné : les rangées sont consignées ensemble, une fois toutes lues
cli-warning-column-not-used = la colonne { $column } est ignorée
cli-warning-expansion-unconfirmed = la dilatation de { $expansion } · 10⁻⁶/K est une valeur courante qu'aucun document ne confirme ici
cli-warning-file-twice = ce fichier est nommé deux fois : ses rangées sont comptées deux fois
cli-warning-position-unused = --position n'a pas d'effet : le cycle { $code } ne part pas de la position de la bille
cli-warning-predef-unused = --predef n'a pas d'effet sur { $name } : il n'est pas défini à PREDEF
cli-warning-log-option = --{ $option } n'a pas d'effet : aucun procès-verbal n'est écrit ni affiché
cli-warning-more-figures = { $count } autres chiffres de ce genre ne sont pas listés
cli-warning-tables-not-used = --tables, --source et les options de la norme ne sont pas utilisés : sans --fit, aucune limite n'est cherchée
cli-warning-empty-cell = { $class } au-delà de { $over } jusqu'à { $to } mm reste vide : ISO 286 n'a pas de valeur unique pour tout cela
cli-warning-budget-option = --{ $option } n'a pas d'effet : le bilan n'en dépend pas
cli-warning-contacts-left = le cycle a utilisé { $used } points de palpage sur { $count }
cli-warning-not-in-csv = CSV n'a pas de place pour { $options } : HTML, JSON et PDF en ont
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } note n'est pas dans le CSV : HTML et JSON la contiennent
   *[other] { $count } notes ne sont pas dans le CSV : HTML et JSON les contiennent
}
cli-warning-no-tool-monitored = le tableau d'outils n'est pas utilisé : aucun outil n'est donné dans Q330
cli-warning-log-unknown = aucun procès-verbal n'est écrit : celui du cycle { $code } est inconnu
cli-warning-limits-alone = les limites seules décident ici : la règle de décision et la température ne s'appliquent qu'aux diamètres
cli-warning-log-off = aucun procès-verbal n'est écrit : Q281 = 0
cli-warning-log-none = aucun procès-verbal n'est écrit : le cycle n'en a pas
cli-warning-log-on-screen = aucun procès-verbal n'est écrit : Q281 = 2 l'affiche à l'écran

# Tables comparées à ISO 286
cli-verify-off = { $place } : { $class } au-delà de { $over } jusqu'à { $to } mm : { $table }, ISO 286 donne { $standard } : { $by }
cli-verify-missing = { $place } : { $class } au-delà de { $over } jusqu'à { $to } mm : aucune valeur, ISO 286 donne { $standard }
cli-verify-undefined = { $place } : { $class } au-delà de { $over } jusqu'à { $to } mm : { $table }, mais { $reason }
cli-verify-neither = { $place } : { $class } au-delà de { $over } jusqu'à { $to } mm : { $reason }
cli-verify-by = { $side ->
        [upper] supérieur
       *[lower] inférieur
    } { $um } µm { $way ->
        [more] de plus
       *[less] de moins
    }
cli-verify-table = { $name } : { $classes ->
        [one] { $classes } classe
       *[other] { $classes } classes
    }, { $ranges ->
        [one] { $ranges } plage de cotes
       *[other] { $ranges } plages de cotes
    }, { $cells ->
        [one] { $cells } cellule comparée
       *[other] { $cells } cellules comparées
    } : { $differ ->
        [0] toutes conformes à ISO 286
        [one] { $differ } diffère d'ISO 286
       *[other] { $differ } diffèrent d'ISO 286
    }
cli-verify-nothing = { $name } : { $classes ->
        [one] { $classes } classe
       *[other] { $classes } classes
    }, { $ranges ->
        [one] { $ranges } plage de cotes
       *[other] { $ranges } plages de cotes
    }, { $cells } cellules comparées : rien à comparer avec ISO 286
cli-verify-own = { $table } ; non comparées, pas des classes ISO 286 : { $own }

## Démarrage
start-missing = fichier introuvable : { $path } ; nommer un fichier existant pour l'ouvrir dans la fenêtre, ou une sous-commande
start-folder = c'est un dossier et non un fichier : { $path } ; seuls des fichiers s'ouvrent dans la fenêtre

## Ce qui a été consigné
cli-recorded-entry = consigné comme entrée { $number } de { $file } (empreinte { $hash })
cli-recorded-entries = consigné comme entrées { $first } à { $last } de { $file } (empreinte de la dernière { $hash })
cli-recorded-nothing = rien n'a été jugé, rien n'a donc été consigné
cli-recorded-without = { $rows ->
    [one] { $rows } rangée n'est pas consignée
   *[other] { $rows } rangées ne sont pas consignées
} : { $places }
cli-not-recorded = rien n'a été consigné : { $error }
cli-journal-is-server = ceci demande le fichier journal d'un poste : un serveur ne fait que recevoir ce que les postes ont consigné
cli-no-shop = ce programme a été compilé sans prise en charge d'un serveur d'atelier : nommer un fichier comme journal
cli-recorded-not-sent = pas encore envoyé au serveur : { $error } ; les relevés sont conservés ici, et fitcheck journal send les envoie
cli-no-journal-folder = ce système n'a pas de dossier pour les données de l'utilisateur : nommer un journal avec --journal FILE
cli-no-entry = il n'y a pas d'entrée { $number } dans { $path } : la dernière est { $last }
cli-no-check = l'entrée { $number } n'est pas un contrôle
cli-no-hash = aucune entrée de { $path } n'a d'empreinte qui commence par { $prefix }
cli-several-hashes = les empreintes de plusieurs entrées commencent par { $prefix } : { $numbers }. Donner plus de chiffres ou le numéro
cli-record-needs-file = --record nomme le fichier écrit, et la sortie standard n'en est pas un : donner -o FILE
cli-report-not-known = { $file } est écrit, mais le journal ne le connaît pas : { $error }
cli-already-corrected-by = l'entrée { $number } a déjà été corrigée ou retirée par l'entrée { $by } : corriger celle-là, sauf si c'est un retrait
cli-not-typed = la valeur de l'entrée { $number } n'a pas été saisie : remesurer, ou retirer le contrôle
cli-nothing-corrected = une correction doit changer quelque chose : donner --measured, --who, --part, --serial, --feature-name, --remark ou --withdraw
cli-remark-sent = { $entries ->
    [0] rien n'était à envoyer
    [one] { $entries } entrée a été envoyée
   *[other] { $entries } entrées ont été envoyées
} à { $server }, qui a ce journal jusqu'à l'entrée { $number }
cli-remark-nothing-found = aucun contrôle ne correspond à { $question }
cli-remark-unread = { $entries ->
    [one] { $entries } entrée est ignorée : cette version ne peut pas la lire
   *[other] { $entries } entrées sont ignorées : cette version ne peut pas les lire
}
cli-head-without-chain = un serveur a plusieurs chaînes : donner --head CHAIN:NUMBER:HASH
cli-head-of-other = ce journal est la chaîne { $chain }, mais --head nomme { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } élément
   *[other] { $count } éléments
}
cli-remark-plan-example = aucune cote tolérancée donnée : le plan a un élément à titre d'exemple
cli-remark-plan-to-fill = le plan est écrit pour autant qu’il est connu ; erreurs à y corriger : { $count }
cli-remark-no-columns = le fichier est lu selon son propre format et n’a pas de colonnes à choisir
cli-remark-plan-head-left = CSV ne contient que les éléments : { $keys } de la pièce n'est pas écrit
cli-warning-neither-stands = l'entrée { $number } corrigeait l'entrée { $target } : maintenant, aucune des deux ne compte. Si l'une des valeurs est juste, la consigner de nouveau
cli-warning-beyond-limits = hors limites : accepté par la règle, car le dépassement n'est pas prouvé
cli-warning-plan-missing = non mesurées : { $names }
cli-warning-plan-missing-of = { $who } : non mesurées : { $names }
cli-warning-contradiction = { $name } a des valeurs qui se contredisent : { $values }
cli-warning-contradiction-of = { $who } : { $name } a des valeurs qui se contredisent : { $values }
cli-warning-worst-counts = la pire de plusieurs valeurs contradictoires compte jusqu'au choix : --repeats last ou --repeats worst. Les numéros de série distinguent les pièces, et une heure par valeur montre laquelle est la dernière
cli-warning-plan-more-parts = plus de { $most } pièces : les éléments manquants des autres ne sont pas signalés
cli-warning-plan-no-value = manquant : aucune valeur trouvée
cli-warning-plan-no-value-of = manquant sur { $who } : aucune valeur trouvée
cli-remark-watching = surveillance de { $folder } ; fichiers déjà importés : { $known }
cli-warning-see-note = tout n'a pas pu être utilisé : le fichier à côté, qui finit par { $note }, donne les raisons
cli-not-seconds = { $given } n'est pas une durée en secondes
cli-warning-same-content = le même contenu a déjà été importé sous { $known } : rien n'est consigné de nouveau
cli-warning-not-alone = impossible de savoir si un autre programme surveille ce dossier pour le même journal : { $reason }

## Le fuseau horaire de cet ordinateur
zone-not-understood = TZ est « { $given } », qui n'est pas un fuseau horaire : lui donner un nom tel que Europe/Amsterdam ou UTC, ou le supprimer
zone-unknown = le fuseau horaire de cet ordinateur est inconnu, les heures sont donc en UTC : donner à TZ un nom tel que Europe/Amsterdam

# Le docteur
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, il est { $time }
doctor-clock = pas avant la dernière entrée du journal
doctor-clock-behind = avant la dernière entrée de { $path }, écrite à { $newest } : régler l'horloge de cet ordinateur
doctor-folder = { $path } : des fichiers peuvent y être écrits
doctor-journal = { $path } : entrées { $entries }
doctor-no-journal = { $path } n'existe pas encore : le premier contrôle enregistré le crée
doctor-server = { $address } répond
doctor-no-server = aucun serveur réglé : le nommer avec --journal postgres://…, ou dans la fenêtre sous Réglages
doctor-gauges = ports de cet ordinateur : { $ports }
doctor-no-port = cet ordinateur n'a pas de port série : brancher l'instrument ou son câble
doctor-gauge-gone = { $gauge } : le port { $port } est absent : brancher l'instrument ou choisir un autre port dans la fenêtre sous Réglages
doctor-no-gauges = ce programme a été construit sans les ports d'instruments : les paquets les ont
doctor-ports-not-listed = les ports de cet ordinateur ne peuvent pas être énumérés : { $reason }
doctor-tables = { $path } : tables { $count }
doctor-no-tables = pas de tables propres : ISO 286 et les tables de la commande sont intégrées
doctor-settings = ce que garde la fenêtre est lisible
doctor-window = dessinée avec { $renderer }
doctor-no-window = ce programme a été construit sans la fenêtre
