# La page des cycles : le formulaire d'un cycle de mesure, sa pièce, son trajet et ses résultats.

page-cycles = Cycles

cycles-cycle = Cycle
cycles-choose = Cycle { $number } { $name }
cycles-group-position = Position
cycles-group-probing = Palpage
cycles-group-tolerance = Tolérance
cycles-group-output = Sortie
cycles-optional-position = Position, facultative
cycles-optional-probing = Palpage, facultatif
cycles-optional-tolerance = Tolérance, facultative
cycles-optional-output = Sortie, facultative
cycles-contacts-from = Points de palpage
cycles-perfect = Pièce parfaite
cycles-simulated = Simulés
cycles-recorded = Enregistrés
cycles-workpiece = Pièce…
cycles-suit = Adapter la pièce au cycle
cycles-open-contacts = Points…
cycles-no-file = pas encore de fichier
cycles-contacts-of = { $count ->
    [one] { $count } point de palpage
   *[other] { $count } points de palpage
    }, { $file }
cycles-probe = Palpeur
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Tableau personnel…
cycles-shipped-probes = Tableau intégré
cycles-run = Exécuter
cycles-needed = requis
cycles-none = aucun
cycles-predef = PREDEF signifie
cycles-predef-missing = PREDEF : saisir la valeur que donne GLOBAL DEF
cycles-without-effect = Accepté sans effet
cycles-position = Position de la bille
cycles-ball-stands = Bille à
cycles-paste-block = Coller la séquence CN…
cycles-copy-block = Copier en séquence CN
cycles-copy-results = Copier les résultats
cycles-block-copied = La séquence CN a été copiée
cycles-block = Séquence CN
cycles-block-hint = Coller une séquence telle que TCH PROBE 427 … Q263=+35 ;TEXT ~ ou G785 R0 BR0 K2 : elle remplace le formulaire
cycles-fill = Remplir le formulaire

cycles-nothing-seen = Le trajet et les points de palpage apparaissent après une exécution : appuyer sur Entrée ou F5
cycles-allowed = Admis : { $range } { $unit }
cycles-must-be-given = Requis
cycles-may-be-left-out = Facultatif
cycles-default = { $value } si vide
cycles-may-be-predef = PREDEF est admis
cycles-path = Trajet de la bille
cycles-first = Premier
cycles-back = Précédent
cycles-next = Suivant
cycles-last = Dernier
cycles-move = Déplacement
cycles-phase-pre-position = prépositionnement
cycles-phase-approach = approche
cycles-phase-contact = contact
cycles-phase-retract = retrait
cycles-phase-leave = dégagement
cycles-move-contact = { $number } sur { $count } : { $phase } { $touch }, à { $to }
cycles-move-of-touch = { $number } sur { $count } : { $phase }, point { $touch }, de { $from } à { $to }
cycles-move-of-none = { $number } sur { $count } : { $phase }, de { $from } à { $to }
cycles-criteria = Critères comparés

cycles-word-stopped = Non mesuré
cycles-word-no-verdict = Sans verdict
cycles-no-limits = aucune limite n'a été donnée
cycles-no-limits-marked = aucune limite n'a été donnée ; une commande annonce alors dans la tolérance
cycles-more-out = { $what }, { $count } de plus ci-dessous
cycles-no-window = Pas de cotes limites : la commande n'affiche pas de fenêtre d'état
cycles-results = Paramètres de résultat
cycles-log-file = La commande écrit { $name }
cycles-log-screen = La commande s'arrête et affiche son procès-verbal
cycles-log-shown = La commande affiche le résultat à l'écran
cycles-save-log = Enregistrer le PV…
cycles-dialog-save-log = Enregistrer le procès-verbal de mesure
cycles-no-log = pas de procès-verbal à enregistrer
cycles-from-perfect = Mesuré sur une pièce parfaite à la cote nominale, avec un point comme palpeur
cycles-from-simulated = Mesuré sur la pièce simulée, graine { $seed }
cycles-from-recorded = Points de palpage de { $file }
cycles-unused = Le cycle a laissé { $count ->
    [one] { $count } point de palpage
   *[other] { $count } points de palpage
    } du fichier sans les utiliser

cycles-fields-wrong = { $count ->
    [one] { $count } champ inutilisable
   *[other] { $count } champs inutilisables
    } : voir le formulaire
cycles-no-workpiece = la pièce simulée n'est pas complète
cycles-workpiece-wrong = pièce simulée : { $problem }
cycles-workpiece-field = { $name } : { $problem }
cycles-no-contacts = aucun fichier de points de palpage n'a encore été ouvert
cycles-cannot-suit = Aucune pièce ne convient encore : { $problem }
cycles-not-written = la pièce ne peut pas être écrite : { $reason }
cycles-contacts-loaded = Les points de palpage de { $name } sont utilisés
cycles-column-ignored = la colonne { $column } est ignorée
cycles-probes-loaded = Le tableau de palpeurs { $name } est utilisé
cycles-dialog-contacts = Ouvrir des points de palpage enregistrés
cycles-dialog-workpiece = Ouvrir une pièce simulée
cycles-dialog-probes = Ouvrir un tableau de palpeurs
cycles-dialog-save-workpiece = Enregistrer la pièce simulée

cycles-open-workpiece = Ouvrir…
cycles-save-workpiece = Enregistrer…
cycles-shape-bore = Alésage
cycles-shape-stud = Arbre
cycles-shape-face = Face
cycles-shape-point = Point sur surface libre
cycles-shape-slot = Rainure
cycles-shape-ridge = Traverse
cycles-shape-pocket = Poche
cycles-shape-boss = Tenon
cycles-plane = Plan
workpiece-probe = Palpeur
workpiece-machine = Dispersion et température
workpiece-centre-1 = Centre, 1er axe
workpiece-centre-2 = Centre, 2e axe
workpiece-ovality-angle = Angle d'ovalité
workpiece-lobe-angle = Angle des lobes
workpiece-point-x = Point X
workpiece-point-y = Point Y
workpiece-point-z = Point Z
workpiece-normal-x = Normale X
workpiece-normal-y = Normale Y
workpiece-normal-z = Normale Z
workpiece-wave-height = Amplitude d'onde
workpiece-wave-length = Longueur d'onde
workpiece-wave-x = Direction d'onde X
workpiece-wave-y = Direction d'onde Y
workpiece-wave-z = Direction d'onde Z
workpiece-deviation = Écart suivant la normale
workpiece-radius = Rayon de la surface
workpiece-width = Largeur
workpiece-length-1 = 1re longueur
workpiece-length-2 = 2e longueur
workpiece-angle = Angle des parois
workpiece-ball = Rayon de la bille
workpiece-trigger = Dispersion déclench. 1σ
workpiece-calibration = Erreur d'étalonnage
workpiece-offset-x = Décalage de la bille X
workpiece-offset-y = Décalage de la bille Y
workpiece-lobing-count = Lobes de la précourse
workpiece-lobing = Amplitude de précourse
workpiece-lobing-angle = Angle de précourse
workpiece-temperature = Température de la pièce
workpiece-expansion = Dilatation

cycles-choice-move-to-clearance-0 = à la hauteur de mesure
cycles-choice-move-to-clearance-1 = à la hauteur de sécurité
cycles-choice-clearance-mode-minus-1 = jamais à la hauteur de sécurité
cycles-choice-clearance-mode-0 = avant et après le cycle
cycles-choice-clearance-mode-1 = avant et après chaque objet
cycles-choice-clearance-mode-2 = à chaque point
cycles-choice-traverse-0 = droite
cycles-choice-traverse-1 = arc de cercle
cycles-choice-contact-count-3 = points
cycles-choice-contact-count-4 = points
cycles-choice-contact-count-5 = points
cycles-choice-contact-count-6 = points
cycles-choice-contact-count-7 = points
cycles-choice-contact-count-8 = points
cycles-choice-contact-count-9 = points
cycles-choice-log-0 = sans PV
cycles-choice-log-1 = PV dans un fichier
cycles-choice-log-2 = arrêt, PV à l'écran
cycles-choice-stop-0 = sans arrêt
cycles-choice-stop-1 = arrêt si hors tolérance
cycles-choice-stop-on-undersize-0 = sans arrêt
cycles-choice-stop-on-undersize-1 = arrêt si hors tolérance
cycles-choice-stop-on-undersize-2 = arrêt si sous-cote seulement
cycles-choice-stop-on-scrap-0 = sans arrêt
cycles-choice-stop-on-scrap-1 = arrêt si hors tolérance
cycles-choice-stop-on-scrap-2 = arrêt si rebut seulement
cycles-choice-measured-axis-1 = axe principal X
cycles-choice-measured-axis-2 = axe secondaire Y
cycles-choice-measured-axis-3 = axe du palpeur Z
cycles-choice-axis-of-plane-1 = axe principal X
cycles-choice-axis-of-plane-2 = axe secondaire Y
cycles-choice-direction-minus-1 = sens négatif
cycles-choice-direction-1 = sens positif
cycles-choice-directed-axis-minus-3 = axe du palpeur Z, sens négatif
cycles-choice-directed-axis-minus-2 = axe secondaire Y, sens négatif
cycles-choice-directed-axis-minus-1 = axe principal X, sens négatif
cycles-choice-directed-axis-1 = axe principal X, sens positif
cycles-choice-directed-axis-2 = axe secondaire Y, sens positif
cycles-choice-directed-axis-3 = axe du palpeur Z, sens positif
cycles-choice-tool-axis-probing-0 = inchangé
cycles-choice-tool-axis-probing-1 = palpé et fixé
cycles-choice-transfer-minus-1 = non indiqué
cycles-choice-transfer-0 = tableau de points zéro
cycles-choice-transfer-1 = tableau de points d'origine
cycles-choice-preset-correction-0 = inchangé
cycles-choice-preset-correction-1 = corrigé par le point
cycles-choice-preset-correction-2 = corrigé par le 2e point
cycles-choice-preset-correction-3 = corrigé par le milieu des deux
cycles-choice-compensation-axis-0 = axe de l'angle mesuré
cycles-choice-compensation-axis-4 = axe A
cycles-choice-compensation-axis-5 = axe B
cycles-choice-compensation-axis-6 = axe C
cycles-choice-zero-after-alignment-0 = garde sa valeur
cycles-choice-zero-after-alignment-1 = affiche zéro
cycles-choice-rotary-alignment-0 = ne bougent pas
cycles-choice-rotary-alignment-1 = tournent, le palpeur suit
cycles-choice-rotary-alignment-2 = tournent seuls
cycles-choice-rotation-transfer-0 = ne change rien
cycles-choice-rotation-transfer-1 = rotation de base
cycles-choice-rotation-transfer-2 = décalage de l'axe rotatif
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = intérieur
cycles-choice-side-1 = extérieur
cycles-choice-geometries-0 = deux trous
cycles-choice-geometries-1 = deux tenons
cycles-choice-geometries-2 = un trou et un tenon
cycles-choice-geometries-3 = un tenon et un trou

## Le tableau d'outils

tools = Tableau d'outils
tools-none = aucun
tools-open-one = { $name }, { $count ->
    [one] { $count } outil
   *[other] { $count } outils
  }
tools-open = Ouvrir un tableau d'outils…
tools-close = Sans tableau d'outils
tools-save = Enregistrer le tableau d'outils…
tools-save-hint = Le tableau avec ces modifications. L'exécution suivante part du tableau tel qu'il a été ouvert.
tools-dialog-open = Ouvrir un tableau d'outils
tools-dialog-save = Enregistrer le tableau d'outils modifié
tools-loaded = Le tableau d'outils { $name } est utilisé
tools-pick = choisir un outil
tools-pick-of = { $parameter } du tableau d'outils
tools-input = { $parameter } Outil à surveiller (Q330)
tools-fixed = Q330 = { $tool } dans le programme
tools-more = { $count ->
    [one] { $count } outil de plus
   *[other] { $count } outils de plus
  }
tools-row = { $tool } : L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool } : L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, bloqué
tools-without-name = { $count ->
    [one] { $count } outil n'est pas listé : son nom ne l'identifie pas
   *[other] { $count } outils ne sont pas listés : leurs noms ne les identifient pas
  }
tools-not-in-table = Q330 = { $tool } : cet outil n'est pas dans le tableau d'outils
tools-not-monitored = Sans tableau d'outils, aucun outil n'est surveillé (Q330)
tools-none-named = Q330 ne nomme aucun outil : le tableau d'outils n'est pas utilisé
tools-no-deviation = la valeur mesurée n'a pas d'écart : l'outil n'est pas modifié
tools-changed = Modifié dans le tableau d'outils
tools-nothing-changed = aucune exécution n'a modifié le tableau d'outils

## Une pièce à plusieurs éléments

cycles-part-refused = le fichier a des tables [[feature]] : un cycle seul mesure une seule surface ; la page Programmes et fitcheck run mesurent une telle pièce
part-features = Éléments de la pièce
part-of-features = { $name }, { $count ->
    [one] { $count } élément
   *[other] { $count } éléments
  }, rayon de la bille { $ball } mm
part-round = { $name } : { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name } : { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name } : { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name } : { $kind } X { $x } Y { $y } Z { $z }
