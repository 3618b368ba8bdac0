# Exécution de programmes CN.

## Chemins et fichiers
machine-path-empty = le chemin est vide
machine-path-too-long = le chemin a plus de { $most } caractères, ce qu'une commande n'admet pas
machine-path-other-root = { $path } n'est ni un chemin sur TNC: ni un chemin depuis le dossier du programme
machine-path-leads-out = { $path } mène hors du dossier
machine-path-no-name = { $name } dans { $path } n'est pas un nom de fichier ou de dossier
machine-store-missing = fichier introuvable : { $path }
machine-store-outside = { $path } mène hors des dossiers donnés
machine-store-no-file = { $path } n'est pas un fichier
machine-store-too-large = { $path } dépasse { $most } Mio
machine-store-ambiguous = { $path } existe sous plusieurs graphies, { $names }, mais une commande n'a qu'un fichier de chaque nom : supprimer ou renommer les autres
machine-store-elsewhere = { $path } n'est pas dans le dossier de sortie : un programme ne supprime des fichiers que là
machine-store-read-only = aucun dossier de sortie n'a été choisi
machine-store-system = { $path } : { $reason }

## Erreurs
machine-fault-in-block = { $program }, séquence { $number }, { $text } : { $fault }
machine-fault-in-line = { $program }, ligne { $line }, { $text } : { $fault }
machine-used-blocks = limite de { $most } séquences atteinte : boucle sans fin possible
machine-used-label-calls = limite de { $most } appels de label imbriqués atteinte : le programme s'appelle-t-il lui-même ?
machine-used-program-calls = limite de { $most } appels de programme imbriqués atteinte : le programme s'appelle-t-il lui-même ?
machine-used-windows = limite de { $most } fenêtres atteinte
machine-used-outputs = limite de { $most } sorties dans des fichiers atteinte
machine-used-output-files = limite de { $most } fichiers de sortie atteinte
machine-used-folders = limite de { $most } dossiers pour fichiers de sortie atteinte
machine-used-table-writes = limite de { $most } écritures de tables modifiées atteinte
machine-used-output = limite de { $most } octets imprimés atteinte
machine-used-cycles = limite de { $most } mesures atteinte
machine-used-path = limite de { $most } déplacements atteinte
machine-used-files = limite de { $most } programmes ouverts et tables modifiées atteinte
machine-used-traffic = limite de { $most } octets lus et écrits atteinte
machine-used-file-bytes = programmes et tables modifiées dépassent ensemble { $most } octets
machine-text-too-long = le texte a { $length } caractères, un paramètre en contient au plus { $most }
machine-unknown-block = séquence inconnue : Fitcheck n'exécute que ce qu'il comprend
machine-unknown-cycle = Fitcheck ne suit pas le cycle { $cycle }, même là où la commande l'a : il suit { $known }
machine-file-open = { $path } est ouvert comme tableau de FN 26 : il ne peut être ni copié, ni déplacé, ni supprimé
machine-broken = le programme est incomplet : { $what } manque
machine-no-program = { $path } : { $error }
machine-no-label = { $parameter } = { $value } n'est pas un label
machine-no-tool-data = { $parameter } n'est pas défini : il contient une mesure de l'outil dans la broche, que donne un tableau d'outils
machine-undefined = { $parameter } n'est pas défini
machine-lost = { $parameter } n'est pas défini : la ligne { $line }, { $text }, le définit peut-être et n'a pas été exécutée
machine-file-unknown = { $path } n'est pas lu : la ligne { $line }, { $text }, l'écrit ou le supprime peut-être et n'a pas été exécutée
machine-tools-unknown = l'outil n'est pas corrigé : la ligne { $line }, { $text }, modifie peut-être le tableau d'outils et n'a pas été exécutée
machine-contacts-unknown = on ne sait pas quels points de palpage enregistrés sont de ce cycle : certains peuvent être de la ligne { $line }, { $text }, qui n'a pas été exécutée
machine-not-skipped = cette séquence décide de ce qui est exécuté ensuite ou de ce que reçoit un autre programme : elle ne peut pas être ignorée
machine-whole-only = { $parameter } ne contient que des nombres entiers, pas { $value }
machine-no-answer = INPUT « { $question } » demande { $parameter } : lui donner une valeur avant l'exécution
machine-no-parameter = le paramètre { $parameter } n'existe pas : Q et QS vont jusqu'à 1999, QL et QR jusqu'à 499
machine-no-variable = la variable { $variable } n'existe pas : { $family } va de { $least } à { $most }
machine-not-number = { $parameter } contient un texte : nombre attendu
machine-not-text = { $parameter } contient un nombre : texte attendu
machine-division-by-zero = division par zéro
machine-negative-root = la racine carrée de { $value } n'est pas définie
machine-no-result = { $function } { $value } n'est pas défini
machine-beyond-range = { $value } est hors de la plage de valeurs, -10^10 à 10^10
machine-not-whole = { $what } = { $value } : nombre entier à partir de 0 attendu
machine-counted-row = rangée
machine-counted-word = { $word }
machine-behind-text = le texte a { $length } caractères : la position { $from } est après sa fin
machine-no-number-in-text = { $parameter } = « { $text } » n'est pas un nombre
machine-unknown-system-text = texte système inconnu ID{ $id } NR{ $number } : seules la date et l'heure (ID10321) sont prises en charge
machine-no-table = aucune table n'est ouverte
machine-several-columns = { $parameter } = { $text } nomme plusieurs colonnes : une seule peut être lue par un paramètre de texte
machine-no-column = la table { $table } n'a pas de colonne { $column } ; ses colonnes sont { $columns }
machine-no-row = la table { $table } n'a pas de rangée { $row } : ses rangées sont 0 à { $last }
machine-no-rows = la table { $table } n'a aucune rangée
machine-empty-cell = table { $table }, rangée { $row }, colonne { $column } : la cellule est vide
machine-no-number-in-cell = table { $table }, rangée { $row }, colonne { $column } : { $cell } n'est pas un nombre
machine-touches = table { $table }, rangée { $row }, colonne { $column } : la cellule déborde sur sa voisine, sa valeur est donc incertaine
machine-table-write = table { $table } : { $error }
machine-mask = masque { $mask } : { $error }
machine-programmed = le programme s'est arrêté avec l'erreur { $number }
machine-no-cycle-parameter = le cycle { $cycle } n'a pas de paramètre { $parameter }
machine-cycle-parameter-twice = cycle { $cycle } : { $parameter } est donné deux fois
machine-cycle-parameter-for = cycle { $cycle } : { $parameter } est donné deux fois, et { $other } pas du tout : le second était-il prévu comme { $other } ?
machine-global-not-number = GLOBAL DEF { $number } : { $parameter } n'a pas de nombre
machine-global-twice = GLOBAL DEF { $number } : { $parameter } est donné deux fois
machine-open-subprogram = le programme finit dans le sous-programme appelé à la ligne { $line } : LBL 0 manque
machine-repeat-ahead = REP répète la partie entre un label et cette séquence, mais le label vient après, à la ligne { $line }
machine-cycle = cycle { $cycle } : { $error }
machine-workpiece = pièce : { $error }
machine-no-tool-call = aucun TOOL CALL avec un axe d'outil ne précède ce cycle de mesure
machine-mode = la commande est en mode { $mode } : les cycles de mesure ne s'exécutent qu'en mode fraisage (FUNCTION MODE MILL)
machine-changed = { $change } : actif depuis la ligne { $line }, { $text } ; Fitcheck ne mesure pas pendant ce temps
machine-nothing-selected = aucun SEL PGM ne précède CALL SELECTED PGM
machine-no-datum-table = le point d'origine irait dans la ligne { $row } du tableau de points zéro actif (Q303 = 0), que seule la commande possède : rien ne peut être mesuré ici à partir de lui
machine-datum-in-tilt = depuis la ligne { $line }, { $text }, le plan est incliné : Fitcheck n'y initialise aucun point d'origine, car on ignore ce qu'une commande y écrit ; réinitialiser le plan avant le cycle (PLANE RESET)
machine-point-without-part = les cycles 0 et 1 palpent un seul point, et une pièce parfaite n'en a pas : choisir une pièce simulée ou des contacts enregistrés
machine-point-from-nowhere = le point de départ du palpage n'est pas connu dans tous les axes : écrire X, Y et Z dans la séquence
machine-no-preset = { $table } n'a pas de ligne { $row }
machine-preset-locked = { $table } : la ligne { $row } est verrouillée, le cycle ne peut pas y écrire
machine-shifted-preset = la ligne { $row } est le point d'origine actif et un décalage du point zéro est actif : ce qu'une commande en fait n'est pas connu
machine-change-not-known = un point d'origine inconnu
machine-change-turning = le système tourné du cycle 800
machine-change-datum-table = un décalage d'un tableau de points zéro
machine-change-rotation = une rotation
machine-change-mirror = une image miroir
machine-change-scaling = un facteur d'échelle
machine-change-axis-scaling = un facteur d'échelle par axe
machine-change-tilt = un plan incliné
machine-change-tilted-shift = un décalage d'un plan qui n'est plus incliné
machine-change-axis-turned = une rotation de la pièce par un axe rotatif, sans nouveau point d'origine dans les deux axes du plan depuis,

## Remarques
machine-file-from = { $path } a été lu dans { $file }
machine-file-given = { $path } a été lu
machine-file-built-in = { $path } est intégré
machine-remark-skipped = séquence inconnue ignorée
machine-remark-cycle-passed-over = ce cycle étalonne le palpeur ou mesure un outil : il a été ignoré. Ce qu'il renvoie n'est plus défini à partir d'ici, sauf si cela a été donné avant l'exécution (--set Q115=0)
machine-remark-measurement-skipped = cette mesure a été ignorée : ses résultats ne sont plus définis à partir d'ici
machine-remark-datum-skipped = cette mesure a été ignorée : ses résultats ne sont plus définis à partir d'ici, et rien n'est mesuré ensuite, car elle définit peut-être un point d'origine
machine-remark-not-followed = cette séquence n'est pas exécutée et peut modifier le point d'origine : rien n'est mesuré ensuite
machine-remark-no-system-data = { $parameter } n'est plus défini à partir d'ici : seule une commande connaît les données système de FN 18
machine-remark-axis-assumed = aucun TOOL CALL ne précède ce cycle : mesuré suivant Z avec le premier palpeur
machine-remark-measured-again = remesuré après retouche : cette mesure compte
machine-remark-spindle-turns = la broche tourne depuis M{ $function } : une commande ne palperait pas
machine-remark-rotary-moved = { $axes } déplacé avant ce cycle : la pièce a été mesurée comme si elle n'avait pas tourné
machine-remark-other-preset = point d'origine { $number } : la pièce y est supposée aussi
machine-remark-rotation-ended = la rotation de base de { $angle } a pris fin : ce cycle mesure sans elle, et elle ne revient pas
machine-remark-axes-as-tilted = le plan est incliné : les axes rotatifs sont supposés être là où il le demande
machine-remark-machine-zero-assumed = FN 18 demande un lieu depuis le zéro de la machine : on ignore ici où il est, et le lieu est compté depuis celui de la pièce
machine-remark-datum-set = point d'origine fixé : son zéro est maintenant en { $zero } mm dans les coordonnées de la pièce
machine-remark-preset-set = ligne { $row } du tableau de points d'origine fixée à { $zero } mm dans les coordonnées de la pièce : elle agit avec le cycle 247
machine-remark-active-preset-set = la ligne { $row } est le point d'origine actif : son zéro est maintenant en { $zero } mm dans les coordonnées de la pièce ; sur une iTNC 530 seulement après le cycle 247
machine-remark-presets-left = { $path } reste tel quel : aucun cycle 247 précédent ne dit quelle ligne est active, et l'on ne sait donc pas où se trouve la pièce sur la machine
machine-remark-shift-ended = le décalage du point zéro prend fin en { $axes } sans que l'on y ait mesuré, comme sur une TNC7 : une iTNC 530 le garde peut-être
machine-remark-built-in = { $path } n'est pas parmi les fichiers donnés : le fichier intégré a été lu
machine-remark-other-names = { $read } a été lu, mais { $others } existe aussi : une commande n'a qu'un fichier de chaque nom
machine-remark-read = { $path } : { $what }
machine-remark-other-spelling = la table { $table } n'a pas de colonne { $column } : { $other } a été utilisé, l'autre graphie dans NC-Solution 8255
machine-remark-row-number = table { $table } : NR est { $found } dans la rangée { $row } : FN 27 et FN 28 comptent les rangées à partir de 0
machine-remark-length-converted = table { $table } : la colonne { $column } est une LENGTH et a été convertie entre mm et pouces
machine-remark-ended-within = M{ $function } dans un programme appelé a mis fin à l'exécution : une commande ne l'y admet pas
machine-remark-given-wins = { $parameter } = { $value } a été donné avant l'exécution et remplace la valeur de cette séquence
machine-remark-given-without-effect = { $parameter } a été donné avant l'exécution et n'a pas eu d'effet : aucune séquence ne l'a lu
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = la séquence omet { $parameters } : ces valeurs ont été utilisées, mais une commande peut refuser la séquence
machine-remark-measurement-behind-end = { $count ->
        [one] { $count } cycle de mesure vient
       *[other] { $count } cycles de mesure viennent
    } après cette séquence, où une commande cesse de lire : rien n'a été mesuré ensuite
machine-remark-cycle-skipped = ce cycle de mesure a été ignoré comme demandé, à cause du / devant lui
machine-remark-rounded = table { $table }, colonne { $column } : { $value } a été arrondi à { $written }
machine-remark-not-judged = pas de verdict ici : rien n'a été comparé à des limites
machine-remark-not-written = { $path } n'a pas été écrit : aucun dossier de sortie n'a été choisi
machine-remark-deleted = { $path } a été supprimé par le programme
machine-remark-not-deleted = { $path } n'a pas été supprimé : aucun dossier de sortie n'a été choisi
machine-remark-other-device = { $given } est un autre appareil : le fichier est { $path }
machine-remark-screen-meant = SCREEN est pris pour un nom de fichier : fallait-il SCREEN: ?
machine-remark-empty-mask = le masque { $mask } est vide : ce qu'il imprime l'est aussi
machine-remark-not-saved = { $path } n'a pas été écrit : { $reason }
machine-remark-full = { $path } a atteint sa limite de { $kilobytes } kilooctets : rien n'a été ajouté
machine-remark-table-written = { $path } a été écrit
machine-remark-contacts-left = les cycles ont utilisé { $used } points de palpage enregistrés sur { $count }
machine-remark-more = { $count } autres remarques ne sont pas listées
machine-remark-empty-spindle = l'outil 0 a été appelé : une TNC7 n'a alors pas de palpeur dans la broche
machine-remark-no-tool-named = aucun TOOL CALL avant ce cycle ne nomme d'outil : mesuré avec le premier palpeur
machine-remark-tool-call-words = TOOL CALL ne prend pas { $words } : ignoré
machine-remark-no-nominal = le cycle n'a pas de cote nominale : le palpeur rencontre la pièce parfaite à mi-chemin de K
machine-remark-other-probe = l'outil { $tool } n'est pas dans le tableau de palpeurs : le palpeur { $probe } a été utilisé
machine-remark-collision = { $mover } : contact avec { $feature } possible, centre de la bille à X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = les déplacements ne sont pas entièrement vérifiés par rapport à { $features }
machine-remark-stylus-unchecked = la tige de palpage n'est pas vérifiée quant aux collisions : elle n'est pas dirigée selon Z
machine-remark-tool-offsets = { $offsets } du TOOL CALL ne modifie pas le palpeur simulé
machine-remark-tool-locked = l'outil { $tool } est bloqué dans le tableau d'outils
machine-remark-no-probe-tool = l'outil { $tool } n'est pas un palpeur : TYP = { $kind }, { $probe } attendu
machine-remark-no-such-tool = l'outil { $tool } n'est pas dans le tableau d'outils
machine-remark-same-name = { $more ->
    [one] { $more } autre outil a le nom { $tool }
   *[other] { $more } autres outils ont le nom { $tool }
} : le premier dans le tableau d'outils a été utilisé
machine-remark-content-uncertain = { $parameter } est lu ici, mais il n'est pas documenté qu'il contient le diamètre
machine-remark-not-waited = { $parameter } est lu sans G909 après le cycle : une commande lit les séquences à l'avance et n'a peut-être pas encore mesuré
machine-remark-position-unknown = la position avant le cycle est inconnue : sans D, il commence au centre nominal, sans WB à la hauteur 0

machine-passed-over = { $count ->
        [one] { $count } séquence sans influence sur une mesure
       *[other] { $count } séquences sans influence sur une mesure
    } : { $list }

## Pauses
machine-pause-stop = le programme s'est arrêté : STOP ou M0
machine-pause-optional-stop = le programme s'est arrêté : M1
machine-pause-breakpoint = la séquence suivante a un point d'arrêt
machine-pause-log = le procès-verbal de mesure est à l'écran (Q281 = 2)

## Une séquence d'un cycle de mesure sans son programme
alone-moved = { $text } déplace le cycle de palpage qui suit ou change ses axes, mais le cycle est exécuté comme si de rien n'était : exécuter plutôt le programme entier
alone-called = { $text } exécute des séquences qui peuvent déplacer le cycle de palpage qui suit, mais elles ne sont pas lues : exécuter plutôt le programme entier
alone-not-understood = { $text } n'est pas compris et peut déplacer le cycle de palpage qui suit : vérifier le programme, ou l'exécuter en entier
alone-not-run = le programme ne va pas plus loin que { $text } et n'atteint pas le cycle de palpage qui suit, une commande ne mesure donc pas ici : vérifier le programme
alone-passed = { $text } peut passer outre le cycle de palpage, une commande peut donc ne pas mesurer ici : exécuter plutôt le programme entier
alone-skipped = une commande peut ignorer le cycle de palpage à cause du / devant lui : s'il doit être mesuré, effacer le /
