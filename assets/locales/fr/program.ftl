# Programmes CN

## Lecture
program-empty = le programme est vide
program-too-large = le programme dépasse { $most } Mio
program-too-many-lines = le programme a plus de { $most } lignes
program-binary = le fichier n'est pas du texte : { $controls } de ses { $bytes } octets ne sont pas des caractères
program-no-begin = le programme ne commence pas par BEGIN PGM
program-second-begin = deuxième BEGIN PGM
program-no-end = END PGM manque
program-units = END PGM donne { $end }, BEGIN PGM donne { $begin }
program-after-end = le texte après END PGM ne fait pas partie du programme
program-no-section = { $section } manque
program-no-unit = l'en-tête ne donne pas l'unité (#EINHEIT METRISCH / INCH) : le programme est lu en mm
program-after-last-section = après ENDE / END, seuls des sous-programmes peuvent suivre
program-unclosed-comment = le commentaire n'a pas de crochet fermant ]
program-numbers = le numéro de séquence { $number } suit { $previous } ; numéros dans le désordre : { $count }
program-label-again = LBL { $label } est déjà défini à la ligne { $first }
program-unclosed-quote = le guillemet n'est pas fermé
program-open-end = la ligne finit par ~, mais rien ne suit
program-cycle-cut = le cycle { $cycle } a fini à la ligne { $line }, qui n'a pas de ~ à la fin : { $parameter } n'en fait pas partie et serait affecté à la place
program-no-star = la séquence ne finit pas par *
program-iso-no-end = la dernière séquence manque : % avec le nom du programme
program-iso-units = la dernière séquence donne { $end }, la première { $begin }
program-iso-after-end = le texte après la dernière séquence ne fait pas partie du programme
program-iso-cycle-cut = le cycle { $cycle } a fini à la ligne { $line } : { $parameter } n'en fait pas partie et serait affecté à la place
program-comment-holds = { $found } fait partie du commentaire, qui finit à la fin de sa ligne
program-cycle-without-tilde = le cycle { $cycle } a fini à la ligne { $line }, qui n'a pas de ~ à la fin : les lignes suivantes sont lues comme en faisant partie
program-block-goes-on = la séquence ci-dessus finit par ~, cette séquence en ferait donc partie
program-comment-goes-on = le commentaire finit par ~, cette séquence en ferait donc partie
program-not-understood = non compris : { $reason }
program-more = { $count } autres remarques ne sont pas listées

## Labels
program-label-missing = LBL { $label } n'existe pas dans le programme
program-label-twice = LBL { $label } est défini deux fois, aux lignes { $first } et { $second }
program-label-zero = LBL 0 termine un sous-programme : aucun saut n'y mène
program-label-parameter = le label contenu dans { $label } n'est connu que pendant l'exécution du programme

## Pourquoi une séquence n'est pas comprise
program-missing = manquant : { $wanted }
program-unexpected = attendu : { $wanted }, trouvé : { $found }
program-left-over = texte inattendu { $found }
program-unknown-function = { $found } n'est pas une fonction
program-number-size = { $found } est trop grand
program-parameter-range = { $found } n'est pas un paramètre : { $family } va de { $least } à { $most }
program-range = { $found } est trop grand : au plus { $most }
program-label-of-parameter = { $parameter } ne peut pas être le nom du label qui commence ici
program-relation = FN { $number } compare avec { $allowed } : { $found } trouvé
program-not-together = { $one } et { $other } ne peuvent pas être dans la même séquence
program-unknown-word = { $found } est inconnu
program-no-form = la forme ISO de { $found } est inconnue
program-measure-unknown = on ne sait pas si G90 ou G91 est actif ici
program-and-with-or = AND et OR dans une même condition demandent des parenthèses qui montrent l'ordre
program-letter-twice = { $letters } est donné deux fois
program-second-unit = une autre unité a été donnée avant
program-acts-in-unit = les unités sont sans influence, mais cette séquence mesure, appelle ou définit une variable
program-shifts-in-unit = les unités sont sans influence, mais cette séquence peut décaler le point zéro
program-alone = { $found } sans { $missing }
program-axis-twice = un axe est donné deux fois
program-too-deep = parenthèses et fonctions sont imbriquées sur plus de { $most } niveaux
program-too-many-operands = la formule a plus de { $most } opérandes
program-too-long = la séquence a plus de { $most } caractères
program-too-much = les formules et les longues séquences prennent plus de { $most } Mio en tout
program-wanted-word = { $word }
program-wanted-number = un nombre
program-wanted-value = un nombre ou un paramètre Q
program-wanted-value-or-variable = un nombre ou une variable
program-wanted-variable = une variable (#l, #c, #g, #x, #i)
program-wanted-parameter = un paramètre
program-wanted-number-parameter = un paramètre Q, QL ou QR
program-wanted-text-parameter = un paramètre QS
program-wanted-text = un texte entre guillemets ou un paramètre QS
program-wanted-label = un label
program-wanted-path = un chemin
program-wanted-relation = EQU, NE, GT, LT ou IS
program-wanted-unit = MM ou INCH
program-wanted-cycle-value = une valeur
