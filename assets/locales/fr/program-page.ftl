## La page des programmes

page-program = Programmes
program-page-dialog-open = Ouvrir un programme CN
program-page-choice = Programme CN
program-page-open = Ouvrir…
program-page-not-shipped = { $name } ne fait pas partie de cette version
program-page-nothing = Aucun programme n'est ouvert
program-page-listing = { $name }, { $count ->
    [one] { $count } séquence
   *[other] { $count } séquences
  }

program-page-run = Exécuter
program-page-pause = Pause
program-page-step = Pas à pas
program-page-step-over = Appel en un pas
program-page-to-selected = Jusqu'au curseur
program-page-breakpoint = Point d'arrêt
program-page-reset = Réinitialiser
program-page-move = Aller à une autre séquence
program-page-speed = Vitesse
program-page-speed-slow = 4 séquences/s
program-page-speed-medium = 20 séquences/s
program-page-speed-fast = pleine vitesse
program-page-options = Options
program-page-skip-unknown = Ignorer les séquences inconnues
program-page-assume-tool = Palper suivant Z sans TOOL CALL
program-page-block-skip = Ignorer les séquences avec /
program-page-optional-stop = Arrêt sur M1
program-page-outline-none = titre ou label
program-page-outline = Aller à

program-page-state-ready = Prêt à exécuter
program-page-state-running = En cours
program-page-state-paused = En pause
program-page-state-step = Pas à pas
program-page-state-breakpoint = En pause à un point d'arrêt
program-page-state-goal = En pause au curseur
program-page-state-over = En pause après l'appel
program-page-state-stop = Le programme s'est arrêté : Exécuter le poursuit
program-page-state-optional-stop = Le programme s'est arrêté sur M1 : Exécuter le poursuit
program-page-state-tolerance = Hors tolérance : { $stop }
program-page-state-log = Le procès-verbal est à l'écran : Exécuter poursuit
program-page-state-ended = Terminé après { $blocks } séquences
program-page-state-fault = Arrêté par une erreur
program-page-refused-inputs = Une donnée ne peut pas être lue
program-page-refused-none = Aucun programme n'est ouvert
program-page-refused-workpiece = La pièce ne peut pas être lue
program-page-refused-no-contacts = Aucun point de palpage n'est ouvert

program-page-has-breakpoint = point d'arrêt
program-page-is-current = séquence suivante
program-page-is-failed = erreur ici

program-page-inputs = Données
program-page-answers = Fitcheck et le programme
program-page-program = Programme
program-page-verdict = Verdict
program-page-no-limits = Pas de limites : une donnée ne peut pas être lue
program-page-agrees = Le programme est en accord avec Fitcheck
program-page-contested = Programme { $program }, Fitcheck { $own }
program-page-contested-limits = Programme { $program }, avec d'autres limites que Fitcheck
program-page-stopped-at = Arrêté par une erreur ; { $program } jusque-là
program-page-differs = Le programme diffère : { $what }
program-page-differs-minimum = son minimum est { $program } mm, celui de Fitcheck { $own } mm
program-page-differs-maximum = son maximum est { $program } mm, celui de Fitcheck { $own } mm
program-page-differs-status = il donne { $program }, Fitcheck { $own }
program-page-differs-fault = il s'est arrêté par une erreur
program-page-differs-native-refuses = il a donné un verdict, Fitcheck n'a pas de limites
program-page-other-inputs = Non comparé : le programme a posé d'autres données depuis et mesure un autre élément
program-page-both-refuse = Ni le programme ni Fitcheck ne donnent de réponse

program-page-workpiece = Pièce
program-page-from-perfect = parfaite, milieu des limites
program-page-from-nominal = parfaite, cote nominale
program-page-from-given = parfaite, diamètre donné
program-page-from-simulated = simulée
program-page-from-part = pièce à plusieurs éléments
program-page-open-part = Ouvrir une pièce…
program-page-dialog-part = Ouvrir une pièce simulée à plusieurs éléments
program-page-refused-no-part = Aucune pièce n'est ouverte
program-page-from-recorded = points enregistrés
program-page-workpiece-x = Centre réel X
program-page-workpiece-y = Centre réel Y
program-page-edit-workpiece = Pièce et palpeur…
program-page-open-contacts = Autres points…
program-page-recorded = { $count ->
    [one] { $count } point de palpage
   *[other] { $count } points de palpage
  } de { $name }
program-page-path = Trajet du palpeur
program-page-no-path = Pas encore de trajet
program-page-zero = Zéro X { $x }, Y { $y }, Z { $z } mm
program-page-turned = tourné de { $angle }°
program-page-tilted = incliné A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = Le programme n'a ouvert aucune fenêtre
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, SIMULÉ
program-page-cycles = Mesuré
program-page-show-block = Voir la séquence
program-page-last-of = Les { $shown } derniers sur { $all }
program-page-outputs = Fichiers
program-page-outputs-hint = Affichés ici, non écrits sur le disque

program-page-parameters = Paramètres
program-page-filter = Filtre
program-page-set = Commencer avec
program-page-value = Valeur
program-page-give = Définir
program-page-give-hint = L'exécution suivante commence avec cette valeur
program-page-given = Définis pour l'exécution suivante
program-page-drop = retirer
program-page-no-parameter = { $given } n'est pas un paramètre : écrire Q5, QL5, QR5 ou QS5
program-page-no-number = { $given } n'est pas un nombre
program-page-none-found = Aucun paramètre ne correspond
program-page-no-parameters = Les paramètres sont listés dès que le programme s'exécute
program-page-undefined = non défini
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, modifié
program-page-pin = Garder { $parameter } en tête
program-page-unpin = Ne plus garder { $parameter } en tête
program-page-q108 = rayon de l'outil
program-page-q109 = axe d'outil : 0 X, 1 Y, 2 Z
program-page-q110 = broche : 0 M3, 1 M4, 2 ou 3 arrêtée ensuite
program-page-q111 = arrosage : 0 arrêt, 1 marche
program-page-q113 = unité : 0 mm, 1 pouce
program-page-q114 = longueur de l'outil
program-page-q115 = position palpée, X
program-page-q116 = position palpée, Y
program-page-q117 = position palpée, Z
program-page-q150 = angle mesuré

program-page-problems = { $count ->
    [one] { $count } remarque
   *[other] { $count } remarques
  }
program-page-unlisted = { $count ->
    [one] { $count } autre n'est pas listée
   *[other] { $count } autres ne sont pas listées
  }
program-page-at-block = séquence { $number } : { $what }
program-page-at-line = ligne { $line } : { $what }

program-page-create = Créer pour une commande…
program-page-create-hint = Programmes CN, tables et masque avec lesquels une commande mesure elle-même
program-page-create-also = écrire programmes CN fichiers ensemble
program-page-create-head = Créer pour une commande
program-page-create-control = Commande
program-page-create-language = Langue de dialogue
program-page-create-from = À partir de
program-page-create-series = Pour une série : chaque départ mesure la pièce suivante
program-page-create-texts = Tolérances des diamètres comme textes du cycle
program-page-create-callout = { $callout } de Contrôle, à X { $x } Y { $y } Z { $z }
program-page-create-no-callout = La cote tolérancée de Contrôle
program-page-create-plan = Plan { $name }, { $count ->
    [one] { $count } élément
   *[other] { $count } éléments
  }
program-page-create-nothing = Saisir une cote tolérancée dans Contrôle, ou ouvrir un plan dans Pièces
program-page-create-plan-wrong = { $name } a des erreurs : ouvrir le plan dans Pièces et les corriger
program-page-create-folder = Dossier sur la commande : { $folder }
program-page-create-proven-callout = Relus et exécutés : { $callout } reçoit exactement les limites de Fitcheck
program-page-create-proven-plan = Relus et exécutés : chaque élément reçoit les limites du plan
program-page-create-clearance-height = La hauteur de sécurité est { $height } mm ; dans un plan, une colonne la fixe
program-page-create-files-none = Créer les fichiers…
program-page-create-files = Créer { $count ->
    [one] { $count } fichier…
   *[other] { $count } fichiers…
  }
program-page-dialog-create = Créer des fichiers pour une commande : choisir ou nommer un dossier
program-page-create-written = { $count ->
    [one] { $count } fichier a été écrit
   *[other] { $count } fichiers ont été écrits
  } dans { $folder } : { $names }
program-page-create-no-folder = { $name } est un fichier : nommer un dossier
program-page-contacts-left = Les points de palpage de { $name } sont ceux du programme précédent : celui-ci mesure une pièce parfaite
program-page-unfinished = Non comparé : le programme n'est pas arrivé à sa fin
program-page-unknown = { $fault }. Pour continuer sans cela, activer Options → Ignorer les séquences inconnues
program-page-missing-file = { $fault }. Il a été cherché dans { $folder }, et parmi les fichiers intégrés. L'y mettre, à côté du programme, ou ouvrir le programme dans le dossier qui le contient
program-page-unknown-datum = { $fault }. Sans son point d'origine, rien n'est mesuré. Pour un essai, ouvrir une copie du programme sans la séquence qui le définit, et une pièce vue depuis ce point d'origine
program-page-not-written = { $path } serait écrit sur la commande. Son texte se trouve sous Fichiers ; en ligne de commande, fitcheck run --output-folder l'écrit
program-page-no-verdict = Pas de limites, pas de verdict
