# Le parcours d'une pièce, et le dossier surveillé, dans la page Pièces.

walk-page-begin = Commencer la pièce
walk-page-count-up = Numéro suivant
walk-page-take = Juger
walk-page-take-meant = Prendre { $meant } mm
walk-page-it-is-so = C'est bien cela : juger { $measured } mm
walk-page-measure-anew = Rejeter et remesurer
walk-page-confirmed = confirmé lors de la mesure : c'est bien cela
walk-page-alarms = Alarmes ouvertes : { $count }
walk-page-alarms-short = Alarmes
walk-page-alarms-more = Autres alarmes : { $count }
walk-page-alarm = { $name } : { $said }
walk-page-alarm-ask = Répondre à l'alarme
walk-page-alarm-ask-of = Répondre à l'alarme de { $name }
walk-page-alarm-answer = Enregistrer la réponse
walk-page-alarm-later = Plus tard
walk-page-alarm-cause = Cause
walk-page-alarm-action = Mesure prise
walk-page-alarm-causes = Usure de l'outil; Outil neuf; Correction d'outil; Serrage; Copeaux ou saleté; Température; Matière; Erreur de mesure; Inconnue
walk-page-alarm-actions = Outil changé; Correction modifiée; Pièce resserrée; Machine nettoyée; Remesuré; Régleur informé; Sous surveillance; Aucune nécessaire
walk-page-alarm-empty = écrire un texte ou en choisir un dans la liste
walk-page-alarms-unread = Impossible de vérifier les règles des cartes de contrôle : { $why }
walk-page-alarms-unchecked = Impossible de vérifier les règles des cartes de contrôle, { $name } : { $why }
walk-page-alarm-unrecorded = Impossible d'enregistrer l'alarme de la carte de contrôle : { $why }
walk-page-simulate = Simuler
walk-page-simulate-hint = Exécute le cycle de l'élément sur une pièce parfaite ; personne ne mesure la valeur, et elle reste marquée comme simulée
walk-page-again = Remesurer
walk-page-skip = Ignorer
walk-page-skip-for = Ignorer pour cette raison
walk-page-skip-not = Ne pas ignorer
walk-page-next = Pièce suivante
walk-page-move = Aller à une autre cote
walk-page-import = Importer des valeurs…
walk-page-watch = Surveiller un dossier…
walk-page-watch-hint = Les fichiers déposés dans le dossier sont jugés selon le plan et consignés, chacun une seule fois
walk-page-watch-stop = Ne plus surveiller
walk-page-dialog-watch = Surveiller un dossier
walk-page-begin-warned = { $count ->
    [one] { $count } cote de cette pièce n'a ni valeur ni raison. Appuyer encore une fois pour terminer cette pièce.
   *[other] { $count } cotes de cette pièce n'ont ni valeur ni raison. Appuyer encore une fois pour terminer cette pièce.
}
walk-page-no-plan = Pas encore de plan : en ouvrir un, ou en créer un dans la vue Plan.
walk-page-plan-wrong = { $count ->
        [one] Le plan a { $count } erreur : voir la vue Plan.
       *[other] Le plan a { $count } erreurs : voir la vue Plan.
    }
walk-page-not-saved = Le plan a des modifications non enregistrées : une pièce interrompue ne peut pas être rétablie après un redémarrage.
walk-page-serial = Numéro de série
walk-page-serial-again = Le numéro de série { $serial } a déjà été mesuré. Appuyer encore sur Entrée, après une demi-seconde, pour le recommencer.
walk-page-serial-hint = Le saisir, le scanner ou prendre le numéro suivant ; Entrée commence la pièce.
walk-page-recent = Plans récents
walk-page-done = Chaque cote a une valeur ou est ignorée
walk-page-part = { $part }, numéro de série { $serial }
walk-page-part-serial = Numéro de série { $serial }
walk-page-part-no-serial = { $part }, sans numéro de série
walk-page-other-plan = Le plan a changé depuis : les modifications s'appliquent à partir de la pièce suivante.
walk-page-part-of = Cette pièce est mesurée selon { $own }
walk-page-open-is = Ouvert maintenant : { $open }
walk-page-begin-by = Commencer une pièce selon { $open }
walk-page-keep-on = Continuer cette pièce
walk-page-unfinished = Une pièce mesurée selon { $own } n'est pas terminée. Mesurer demande s'il faut la continuer.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = Pas de position dans le plan
walk-page-value = Valeur mesurée
walk-page-measured-before = { $count ->
        [one] Mesurée { $count } fois : les deux valeurs sont conservées, et la nouvelle compte
       *[other] Mesurée { $count } fois : toutes les valeurs sont conservées, et la nouvelle compte
    }
walk-page-last-counts = Mesurée { $count } fois : toutes les valeurs sont conservées, et celle-ci compte
walk-page-skip-why = Raison pour ignorer
walk-page-skip-access = Palpeur sans accès
walk-page-skip-gauge = Instrument manquant
walk-page-skip-machined = Pas encore usinée
walk-page-skip-elsewhere = Mesurée ailleurs
walk-page-reason = Autre raison
walk-page-no-reason = une raison est requise
walk-page-skipped = ignorée : { $reason }
walk-page-next-warned = { $count ->
        [one] { $count } cote n'a ni valeur ni raison. Choisir encore une fois Pièce suivante pour terminer cette pièce.
       *[other] { $count } cotes n'ont ni valeur ni raison. Choisir encore une fois Pièce suivante pour terminer cette pièce.
    }
walk-page-typed-elsewhere = la valeur a été saisie pour { $name }, et { $asked } est demandé maintenant : la ressaisir
walk-page-next-size = Suivante : { $name }, { $asked }
walk-page-is-serial = { $given } ressemble à un numéro de série et n'est pas pris comme valeur : terminer d'abord cette pièce, puis le scanner pour la pièce suivante. Si c'est la valeur mesurée, la saisir avec plus de décimales
walk-page-simulate-measured = { $name } est mesuré : une valeur simulée ne prend jamais la place d'une valeur mesurée
walk-page-part-status = Statut de la pièce
walk-page-not-complete = Pas encore de verdict
walk-page-simulated = { $count ->
        [one] { $count } valeur est simulée : personne ne l'a mesurée, elle ne peut donc pas rendre la pièce bonne.
       *[other] { $count } valeurs sont simulées : personne ne les a mesurées, elles ne peuvent donc pas rendre la pièce bonne.
    }
walk-page-missing = Manquantes : { $names }
walk-page-off = La consignation est désactivée : une pièce interrompue ne peut pas être rétablie après un redémarrage.
walk-page-nowhere = Rien n'est consigné : une pièce interrompue ne peut pas être rétablie après un redémarrage.
walk-page-no-part = Aucune pièce n'est en cours de mesure.
walk-page-sizes = Cotes de la pièce
walk-page-open = à faire
walk-page-row-simulated = simulée
walk-page-times = { $count } valeurs
walk-page-rule-plan = Jugé selon la règle du plan : { $rule }
walk-page-rule-own = Le plan n'a pas de règle ; jugé selon la règle de la page Contrôle : { $rule }
walk-page-nothing-asked = aucune cote du plan n'est en cours de mesure
walk-page-refused = { $count ->
        [one] { $count } contrôle n'a pas été consigné : { $why }
       *[other] { $count } contrôles n'ont pas été consignés : { $why }
    }
walk-page-import-late = { $name } a été lu après la fin de la pièce : ses valeurs ne sont pas utilisées
walk-page-imported = { $name } : { $good } valeurs importées, { $bad } non
walk-page-file-for-check = Rien n'y relève de ce plan. Contrôle peut juger le fichier d'après ce qu'il demande lui-même
walk-page-found-by-name = { $count ->
    [one] Rattachée par le nom : { $count } rangée
   *[other] Rattachées par le nom : { $count } rangées
}
walk-page-found-by-number = Rattachées par le numéro seul, avec leurs lignes : { $rows }
walk-page-found-by-place = Rattachées par la position, avec leurs lignes : { $rows }
walk-page-other-parts = Les valeurs d'autres pièces sont consignées sous leurs propres numéros de série : { $serials }
walk-page-label = Le fichier n'a pas de numéros de série et nomme la pièce { $part } : ses valeurs sont prises pour cette pièce
walk-page-other-label = de la pièce { $part } ; sans numéro de série, rien ne dit que c'est cette pièce
walk-page-remark-label = Pièce dans le fichier : { $part }
walk-page-not-judged = ligne { $line } : { $why }
walk-page-no-journal = La pièce { $serial } a été rétablie sans ses valeurs : il n'y a pas de relevés pour les rétablir
walk-page-gone = Certaines cotes ne sont plus dans le plan : leurs valeurs mesurées restent dans les relevés
walk-page-gone-name = { $name }
walk-page-changed = Le plan a changé : les valeurs jugées selon d'autres limites ou une autre règle, et les valeurs de rangées sans nom, restent dans les relevés, et leurs cotes sont de nouveau à faire
walk-page-changed-size = { $name } : { $measured } mm a été mesuré selon { $asked }
walk-page-given-up = La pièce interrompue { $serial } n'est pas rétablie, car une autre pièce a été commencée : ses valeurs restent dans les relevés
walk-page-ended = Non utilisé pour la pièce { $serial }, qui est terminée
walk-page-ended-size = { $name } : { $reason }
walk-page-taken-back = Une valeur de { $name } a été corrigée ou retirée dans les relevés : elle ne s'applique plus à cette pièce
walk-page-put-right = Une valeur de { $name } a été corrigée dans les relevés : la valeur corrigée s'applique à cette pièce
walk-page-no-folder = { $path } n'est pas un dossier
walk-page-not-read = Les valeurs de la pièce interrompue n'ont pas pu être lues : { $why }
walk-page-came-back = { $count ->
        [one] La pièce interrompue { $serial } a été rétablie avec { $count } valeur
       *[other] La pièce interrompue { $serial } a été rétablie avec { $count } valeurs
    }
walk-page-watched = Dossier surveillé
walk-page-part-waits = La pièce { $serial } sera rétablie dès que son plan n'aura plus d'erreurs
walk-page-watch-waits = Le dossier { $path } sera de nouveau surveillé dès que le plan n'aura plus d'erreurs
walk-page-watch-no-plan = surveiller un dossier demande un plan sans erreurs : en ouvrir un d'abord
walk-page-watch-no-journal = le journal ne peut pas être ouvert : on ne sait pas quels fichiers ont déjà été importés, aucun dossier n'est donc surveillé
walk-page-watch-begins = Recherche dans le journal des fichiers déjà importés
walk-page-known = { $count ->
        [0] Le journal n'a aucun fichier déjà importé
        [one] Le journal a { $count } fichier déjà importé, de n'importe quel dossier : il n'est pas importé de nouveau
       *[other] Le journal a { $count } fichiers et parties de fichiers déjà importés, de n'importe quel dossier : ils ne sont pas importés de nouveau
    }
walk-page-mask = La sortie FN 16 est relue à travers le masque { $name }
walk-page-watch-recording = Consignation en cours
walk-page-waiting = { $name } : { $why }
walk-page-watch-count = { $count ->
        [one] { $count } fichier importé
       *[other] { $count } fichiers importés
    }
walk-page-report = Rapport…
walk-page-report-people = Rapport de contrôle ({ $format })…
walk-page-report-programs = Valeurs de la pièce en { $format }…
walk-page-contradicted = { $names } : des valeurs se contredisent, et rien ne dit laquelle est juste. La pire compte jusqu'à ce qu'on remesure ou choisisse.
walk-page-contradicting = { $name } a des valeurs qui se contredisent : { $values }. La pire compte jusqu'à ce qu'on remesure ou choisisse.
walk-page-count-newest = La dernière valeur compte
walk-page-newest-counts = { $name } : la dernière valeur compte, selon le choix fait
walk-page-accepted = Accepté hors limites : { $names }
walk-page-because = À cause de { $names }
walk-page-left-out = Ignorées : { $names }. Une pièce avec des cotes ignorées ne peut pas être bonne.
walk-page-whole = La pièce entière
walk-page-whole-serial = La pièce { $serial }
walk-page-strip-open = La pièce : pas encore de verdict
walk-page-strip-part = La pièce : { $status }
walk-page-strip-size = { $name } : { $value } mm, { $status }
walk-page-by-plan = Mesuré selon le plan { $name }
walk-page-judged-by-plan = Jugé selon le plan { $name }
walk-page-watch-no-mask = Le masque personnel { $path } ne peut pas être lu : le dossier sera surveillé dès que ce masque ou un autre aura été choisi (Menu, Masque personnel…)
walk-page-watch-nobody = { $count ->
        [one] { $count } valeur est consignée sans numéro de série : son fichier n'en nomme pas, et aucune pièce n'est en cours de mesure selon ce plan
       *[other] { $count } valeurs sont consignées sans numéro de série : leur fichier n'en nomme pas, et aucune pièce n'est en cours de mesure selon ce plan
    }
walk-page-watch-other-plan = Le dossier est jugé selon le plan tel qu'il était au début de la surveillance. Commencer une pièce, ou surveiller de nouveau le dossier, pour juger selon le plan actuel.
walk-page-watch-not-saved = Le plan a des modifications non enregistrées : le dossier ne sera pas surveillé de nouveau après un redémarrage.
walk-page-values = Valeurs de { $name }
walk-page-to-do = { $name } : { $what }
walk-page-of = cote { $at } sur { $count }
walk-page-no-serial = Sans numéro de série
