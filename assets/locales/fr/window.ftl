# La fenêtre : libellés, boutons, titres. Majuscule au début seulement, pas de deux-points après un libellé, points de suspension sur ce qui ouvre un dialogue.

page-check = Contrôle
page-fit = Ajustements
page-tables = Tables
import = Importer…
export = Exporter
export-people = Rapport de contrôle ({ $format })…
export-programs = Historique en { $format }…
export-status-check = Fenêtre d'état de Contrôle en texte…
export-status-cycle = Fenêtre d'état du cycle { $cycle } en texte…
export-status-program = Fenêtre du programme en texte…
menu = Menu
language = Langue
theme = Apparence
theme-system = Comme le système
theme-light = Clair
theme-dark = Sombre
theme-contrast = Contraste élevé sur blanc
theme-inverted = Contraste élevé sur noir
density = Taille des boutons
density-by-use = Automatique
density-mouse = Souris
density-touch = Tactile
limits-from = Limites selon
standard-js-rounded = Arrondir les demi-micromètres de JS vers le bas, comme en 1988
standard-1988 = cd, ef et fg jusqu'à 10 mm seulement, comme en 1988
load-tables = Tables personnelles…
no-own-tables = Ne plus utiliser les tables personnelles
load-mask = Masque personnel…
undo = Annuler
undo-what = Annuler : { $what }
undo-add = { $count ->
    [one] ajout de { $count } contrôle
   *[other] ajout de { $count } contrôles
}
undo-correct = correction
undo-feature = alésage ou arbre
undo-clear = effacement de l'historique
undone = Annulé : { $what }
clear-history = Effacer l'historique
choose-bad = { $count ->
    [0] Sélectionner les contrôles non bons
    [one] Sélectionner { $count } contrôle non bon
   *[other] Sélectionner { $count } contrôles non bons
}
choose-none = Tout désélectionner

callout = Cote tolérancée
callout-hint = Saisir une cote nominale et une classe, par exemple 25 H7
feature-hole = Alésage
feature-shaft = Arbre
feature-neither = Ni l’un ni l’autre
nominal-is = cote nominale { $nominal } mm
maximum = Maximum
minimum = Minimum
from-source = selon { $source }
source-overrides = Table personnelle : ISO 286 donne { $upper } / { $lower } µm, soit une différence de { $by-upper } / { $by-lower } µm
measured-value = Valeur mesurée
measured-once = Déjà jugée. Pour juger de nouveau la même valeur, la ressaisir ou appuyer sur le bouton
by-typing = Saisir
by-simulating = Simuler
judge = Juger
measure = Mesurer
clear = Effacer
nominal-size = Cote nominale
tolerance-class = Classe
class-none = Choisir
classes-hole = Classes d'alésage
classes-shaft = Classes d'arbre
part-section = Pièce
part-name = Pièce ou élément

probe-position = Position de palpage
centre-x = Centre X
centre-y = Centre Y
height-z = Hauteur Z
first-contact = Premier point
clearance = Distance d'approche
centre-tolerance = Tolérance centre ±
simulated-workpiece = Pièce simulée
simulated-hint = Sans diamètre, le milieu de l'intervalle de tolérance s'applique. La graine augmente après chaque mesure ; la même graine donne les mêmes points de palpage.
true-diameter = Diamètre réel
seed = Graine
offset-x = Décalage X
offset-y = Décalage Y
ovality = Ovalité
lobes = Lobes
lobe-height = Hauteur des lobes
surface-scatter = Dispersion surface 1σ
probe-scatter = Dispersion palpeur 1σ

field-range = { $given } est hors de −{ $limit } à { $limit }
field-not-negative = { $given } est inférieur à 0 : 0 à { $limit } est admis
field-above-zero = { $given } n'est pas supérieur à 0 : au plus { $limit } est admis
field-not-whole = { $given } n'est pas un nombre entier

limit-band = Bande des limites
band-example = par exemple : { $callout }, un alésage
band-empty = La bande apparaît avec les limites
band-describe = Écart à la cote nominale en micromètres : intervalle de tolérance de { $lower } à { $upper }, { $left } en dessous, { $right } au-dessus.
band-describe-measured = Mesuré { $deviation }, { $above } au-dessus du minimum, { $below } au-dessous du maximum.
side-rework = retouche
side-scrap = rebut
side-out = hors tolérance

last-values = Dernières valeurs
last-values-empty = Les dernières valeurs pour ces limites apparaissent ici
last-values-describe = { $count ->
    [one] La dernière valeur, la plus récente à la fin :
   *[other] Les { $count } dernières valeurs, la plus récente à la fin :
}
contacts = Points de palpage
contacts-factor = écarts × { $factor }
contacts-empty = Les points de palpage apparaissent avec la mesure
contacts-describe = { $count } points de palpage vus de dessus, écarts agrandis { $factor } fois. { $circle }
centre-is = centre { $x } / { $y }

word-none = Sans résultat
nothing-measured = Rien n'a été mesuré
judged-without-own = Jugé sans les tables personnelles
word-question = Est-ce exact ?
simulated = SIMULÉ
status-simulated = { simulated } { $status }
judge-anyway = Juger { $measured } mm tel quel
take-meant = Prendre { $meant } mm
take-text = Prendre { $meant }
keep-text = Juger avec { $given } tel quel
doubted-enter = Entrée active le bouton en couleur ; une saisie remplace le texte
doubted-type = Rien n'est jugé tant que le texte n'est pas ressaisi ou pris tel quel
question-enter = Après une demi-seconde, Entrée active le bouton plein ; une saisie remplace la valeur
doubt-sentence = Doute : { $doubt }
lot-title = { $rows ->
    [one] { $name } : { $rows } rangée
   *[other] { $name } : { $rows } rangées
}
lot-unjudged = { $count } non jugées
lot-refused = { $count ->
    [one] { $count } rangée refusée
   *[other] { $count } rangées refusées
}
lot-doubted = { $count ->
    [one] { $count } valeur douteuse
   *[other] { $count } valeurs douteuses
}
lot-shown = Affichée : { $place } sur { $judged }, les pires d'abord ; ligne { $line }
lot-shown-part = Affichée : { $place } sur { $judged }, les pires d'abord ; ligne { $line }, pièce { $part }
lot-worst = La pire
lot-worse = Moins bonne
lot-better = Meilleure
lot-best = La meilleure
lot-count = { $status } { $count }
above-minimum = { $um } µm au-dessus du minimum
below-minimum = { $um } µm sous le minimum
below-maximum = { $um } µm sous le maximum
above-maximum = { $um } µm au-dessus du maximum
remove-amount = Enlever { $um } µm
remove-to-limit = jusqu'à la limite
remove-to-limit-per-side = jusqu'à la limite, { $um } µm/côté
remove-to-middle = { $um } µm jusqu'au milieu
position-in = Centre en position
position-out = Centre hors position
diameter-alone = Diamètre seul : { $status }
first-steps = Premiers pas
first-steps-title = Première utilisation ?
first-steps-about = Ces réglages sont conservés.
first-steps-done = Terminé
first-way-part = Une pièce complète
first-way-part-about = Élément par élément, selon un plan avec une image.
first-way-file = Un fichier de valeurs
first-way-file-about = CSV, classeur, QIF, AQDEF ou procès-verbal de mesure.
first-way-program = Sans machine
first-way-program-about = Un programme CN ou un cycle mesure un alésage simulé, point par point.
first-step-callout = 1. Cote tolérancée : ce que dit le dessin
first-step-value = 2. Valeur mesurée : saisie, simulée ou importée
first-step-verdict = 3. Verdict, et quantité à enlever
why = Pourquoi ?
why-limits = Limites selon { $what }
why-measured = Valeur mesurée : { $what }
why-rule = Règle : { $what }
why-caveat = Limite de cette mesure : { $what }

popup-title = Fenêtre d'état
popup-title-accepted = Fenêtre d'état : hors limites, accepté par la règle
popup-title-simulated = Fenêtre d'état, SIMULÉ
popup-exact = La fenêtre arrondit à quatre décimales. Valeurs exactes : { $values }
popup-empty = Pas encore de mesure
copy = Copier
mask-choice = Masque
mask-choice-of-language = Langue de la fenêtre
mask-choice-own = Masque personnel…

history = Historique
history-count = { $count ->
    [0] aucun contrôle
    [one] { $count } contrôle
   *[other] { $count } contrôles
}
history-chosen = { $count } à exporter
history-hidden = dont { $hidden } hors liste
history-shown = { $shown } sur { $count ->
    [one] { $count } contrôle
   *[other] { $count } contrôles
}
history-exported-listed = { $count ->
    [0] Aucun contrôle dans la liste : rien à exporter
    [one] Le seul contrôle de la liste, sur { $all }, sera exporté
   *[other] Les { $count } contrôles de la liste, sur { $all }, seront exportés
}
rows-exported = Les { $listed } rangées de la liste de { $name } seront exportées, dans l'ordre de la liste
rows-export-not-yet = Les rangées peuvent être exportées dès qu'elles sont toutes jugées et listées
history-exported = { $count ->
    [0] Rien à exporter
    [one] { $count } contrôle sera exporté
   *[other] Les { $count } contrôles seront tous exportés
}
history-cleared = { $count ->
    [one] { $count } contrôle retiré de l'historique. Annuler (Ctrl+Z) le rétablit.
   *[other] { $count } contrôles retirés de l'historique. Annuler (Ctrl+Z) les rétablit.
}
history-none-found = Aucun contrôle ne correspond au filtre
history-filter = Filtre
history-filter-hint = Liste les contrôles qui contiennent ces mots : pièce, cote tolérancée, valeur, date, statut ou fichier
history-only-bad = Non bons seulement
history-only-bad-hint = Retouche, à remesurer et rebut
history-sort-hint = Trie par cette colonne ; un second appui inverse l'ordre, un troisième remet les plus récents en tête
history-ascending = { $column }, tri croissant
history-descending = { $column }, tri décroissant
history-list = Contrôles de l'historique
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, à exporter
history-move = Aller à un autre contrôle
history-show = Afficher le contrôle
history-choose = Sélectionner pour l'export
choose-all = Sélectionner toute la liste
copy-checks = Copier pour un tableur
history-empty = Les contrôles apparaissent ici, le plus récent en tête
head-time = Date et heure
head-part = Pièce
head-callout = Cote
head-measured = Mesuré
head-deviation = Écart
head-status = Statut
head-from = Origine
choose-check = Sélectionner { $check } du { $time } pour l'export

dialog-import = Importer des mesures
dialog-mask = Masque personnel
dialog-tables = Dossier des tables personnelles
dialog-export = Exporter
dialog-export-rows = Exporter les rangées de la liste
dialog-export-status = Exporter la fenêtre d'état
file-path = Fichier
folder-path = Dossier
dialog-open = Ouvrir
dialog-save = Enregistrer
dialog-browse = Parcourir…
dialog-cancel = Annuler
dialog-busy = En cours…
dialog-no-path = Un chemin manque
dialog-no-status = Pas de fenêtre d'état à enregistrer
dialog-browse-hint = Affiche le dialogue de fichiers du système
dialog-up = Dossier parent
dialog-home = Dossier personnel
dialog-all-files = Tous les fichiers
file-kind-measurements = Mesures
file-kind-mask = Masques
file-kind-own-tables = Dossiers de tables
file-kind-report = Rapports
file-kind-rows = Rangées
file-kind-status = Texte
file-kind-table = Tables
file-kind-contacts = Points de palpage
file-kind-workpiece = Pièces simulées
file-kind-probes = Tableaux de palpeurs
file-kind-log = Procès-verbaux de mesure
file-kind-program = Programmes CN
file-kind-part = Pièces à plusieurs éléments
file-kind-set = Fichiers pour une commande
file-kind-tools = Tableaux d'outils
file-kind-plan = Plans de pièce
file-kind-picture = Images
file-kind-watched = Dossiers surveillés
file-kind-budget = Bilans d'incertitude
file-kind-chart = Cartes de contrôle
file-kind-readings = Lectures
file-kind-study = Lectures d'un moyen de mesure
dialog-move = Aller à un autre élément de la liste
dialog-recent-folders = Dossiers récents
dialog-exists = { $name } existe déjà. Le remplacer ?
dialog-exists-set = { $name } existe déjà dans ce dossier. Y remplacer les fichiers de l'ensemble ?
dialog-replace = Remplacer
dialog-keep = Conserver
dialog-nothing-picked = Le dialogue du système n'a renvoyé aucun fichier. Choisir un fichier dans la liste ou saisir un chemin.
dialog-list = Dossier { $folder }
dialog-entries = Fichiers et dossiers
dialog-list-none = Aucun dossier n'est ouvert : saisir un chemin
dialog-list-reading = Lecture du dossier…
dialog-list-empty = Rien à choisir dans ce dossier
dialog-list-more = Seuls les { $most } premiers noms sont listés : saisir le nom voulu
dialog-is-folder = Dossier
file-name-checks = controles
open-written = Ouvrir
show-in-folder = Afficher le dossier
launch-failed = le fichier ne peut pas être ouvert : { $reason }
recent-files = Fichiers récents
forget-recent = Vider la liste
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] { $count } nom n'est pas affiché
   *[other] { $count } noms ne sont pas affichés
}
file-bytes = { $count } o
file-kilobytes = { $count } ko
file-megabytes = { $count } Mo
notice = Note
copied = { $lines ->
    [one] Copié, { $lines } ligne
   *[other] Copié, { $lines } lignes
    }
notice-problem = Erreur
notice-more = { $count ->
    [one] { $count } autre message suit
   *[other] { $count } autres messages suivent
}
messages = Messages précédents
messages-forget = Vider cette liste
messages-count = { $count ->
    [one] { $count } message précédent
   *[other] { $count } messages précédents
}
close = Fermer
file-written = { $name } a été écrit dans { $folder }
file-written-here = { $name } a été écrit
tables-loaded = { $count ->
    [one] { $count } table de { $folder } est utilisée
   *[other] { $count } tables de { $folder } sont utilisées
}
mask-loaded-with-warnings = { $name } a été lu avec des avertissements
state-set-aside = L'état enregistré n'a pas pu être lu. Il a été conservé sous { $path }, et la fenêtre démarre avec les réglages par défaut.
state-set-aside-now = L'état enregistré ne peut plus être lu. Il a été conservé sous { $path }, et l'état de cette fenêtre est enregistré à sa place.
state-not-kept = L'état de cette fenêtre n'est pas enregistré : { $reason }
import-contacts-not-judged = Les points de palpage de { $name } n'ont pas été jugés
import-notice = { $name } : { $good ->
    [0] aucun contrôle
    [one] { $good } contrôle
   *[other] { $good } contrôles
}, { $bad ->
    [0] aucune rangée refusée
    [one] { $bad } rangée refusée
   *[other] { $bad } rangées refusées
}
import-counted = { $file }. { $counts }
check-said-afterwards = indiqué après le verdict : { $as }
lot-open = { $count ->
    [one] Pour une valeur, alésage ou arbre reste à dire :
   *[other] Pour { $count } valeurs, alésage ou arbre reste à dire :
}
check-all-holes = Tous des alésages
check-all-shafts = Tous des arbres
check-judged-again = { $count ->
    [one] Une valeur hors de ses limites a été jugée à nouveau : { $as }
   *[other] { $count } valeurs hors de leurs limites ont été jugées à nouveau : { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Afficher
notice-open-in = Ouvrir dans { $page }
judge-unplanned = Ouvrir dans Contrôle
sample-not-recorded = Un exemple n'est pas consigné.
limits-own-first = D'abord les tables personnelles : { $names }
limits-own-stay = Les tables personnelles passent toujours en premier : { $names }. Menu, Limites selon, pour ne plus les utiliser.
measured-needs-value = Saisir la valeur mesurée
measured-needs-limits = Pas de limites pour juger : saisir d'abord une cote tolérancée

keypad = Clavier
key = Touche
key-blank = Espace
key-decimal = Séparateur décimal
key-minus = Moins
edge-left = Bord du volet gauche : se déplace avec les flèches
edge-right = Bord du volet droit : se déplace avec les flèches
edge-top = Bord du volet supérieur : se déplace avec les flèches
edge-bottom = Bord du volet inférieur : se déplace avec les flèches
key-letters = Lettres
key-holes = Classes d'alésage
key-shafts = Classes d'arbre
key-more-letters = M à X
key-signs = Y, Z et signes
key-figures = Chiffres
key-shift = Majuscules ou minuscules
key-back = Effacer le dernier caractère
key-clear = Vider
key-enter = Entrée

## Page des tables
tables-choice = Table
tables-kind-shipped = intégrée
tables-kind-own = personnelle
tables-kind-file = d'un fichier
tables-kind-copy = copie
tables-kind-made = d'ISO 286
tables-unsaved = non enregistrée
tables-open = Ouvrir…
tables-save = Enregistrer sous
tables-redo = Rétablir
tables-use = Utiliser pour les limites
tables-in-use = Utilisée pour les limites
tables-filter = Filtre
tables-filter-hint = Classes telles que H7 g6, lettres, degrés, ou une cote en mm
tables-shown = { $count ->
    [one] { $shown } sur { $count } classe
   *[other] { $shown } sur { $count } classes
}
tables-only-differences = Différences seulement
tables-unmatched = rien ne correspond à { $words }
tables-agrees = { $count ->
    [one] conforme à ISO 286 dans sa seule cellule
   *[other] conforme à ISO 286 dans ses { $count } cellules
}
tables-differs = { $count ->
    [one] { $count } cellule sur { $compared } diffère d'ISO 286
   *[other] { $count } cellules sur { $compared } diffèrent d'ISO 286
}
tables-compared-nothing = rien à comparer avec ISO 286
tables-own-classes = { $count ->
    [one] { $count } classe personnelle
   *[other] { $count } classes personnelles
}
tables-own-class = personnelle
tables-previous = Différence précédente
tables-next = Différence suivante
tables-not-saved = Modifications non enregistrées
tables-keys = Les flèches déplacent, Entrée modifie, Suppr vide, F8 va à la différence suivante, Ctrl+F au filtre
tables-move = Aller à une autre cellule
tables-edit-cell = Modifier la cellule
tables-grid = Écarts de { $name } en µm
tables-range-head = > – ≤, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = vide
tables-cell = { $class }, au-delà de { $over } jusqu'à { $to } mm, { $figures }
tables-cell-differs = { $class }, au-delà de { $over } jusqu'à { $to } mm, { $figures }, diffère d'ISO 286
tables-no-columns = La table n'a aucune classe
tables-upper = Sup.
tables-lower = Inf.
tables-head-table = Table, µm
tables-head-standard = ISO 286
tables-head-by = diff.
tables-cell-agrees = Comme dans ISO 286
tables-cell-off = ISO 286 donne { $upper } / { $lower } µm ; la table s'en écarte de { $upper-by } / { $lower-by } µm
tables-more-differences = et { $count } de plus
tables-cell-missing = Vide ici ; ISO 286 donne { $upper } / { $lower } µm
tables-cell-empty = Vide ici, et non définie dans ISO 286
tables-defined = Dans ISO 286, la classe est définie { $ranges }
tables-shipped-hint = Une table intégrée n'est jamais modifiée : une modification crée une copie et l'affiche.
tables-set = Appliquer
tables-take-standard = Prendre ISO 286
tables-empty-cell = Vider
tables-remove-column = Supprimer { $class }
tables-from-standard = D'ISO 286
tables-classes = Classes, par exemple H7 K7 P9
tables-add-columns = Ajouter à cette table
tables-up-to = Cotes jusqu'à
tables-make = Nouvelle table
tables-order = l'écart supérieur { $upper } µm est sous l'écart inférieur { $lower } µm
tables-used-edited = { $name } donne les limites : les contrôles utilisent la modification dès maintenant
tables-used = Les limites sont d'abord cherchées dans { $name }, jusqu'à la fermeture de la fenêtre. Pour continuer à l'utiliser, l'enregistrer dans le dossier des tables personnelles.
tables-read-with-warnings = { $name } a été lu avec des avertissements
tables-nothing-read = Le fichier ne contient aucune table d'écarts
tables-nothing-to-save = Aucune table n'est ouverte
tables-cell-unreadable = Les valeurs de la cellule sélectionnée sont illisibles : les corriger d'abord
tables-too-many = { $count } tables ouvertes ont des modifications non enregistrées : en enregistrer une d'abord
tables-dialog-open = Ouvrir une table
tables-dialog-save = Enregistrer la table
## Page des ajustements
fit-callout = Ajustement alésage/arbre
fit-callout-hint = Saisir une cote nominale et les deux classes, par exemple 25 H7/g6
fit-example = par exemple : { $callout }
fit-shaft-missing = La classe de l'arbre manque, par exemple g6 dans 25 H7/g6
fit-hole-missing = La classe de l'alésage manque, par exemple H7 dans 25 H7/g6
fit-classes-missing = Un ajustement a une classe d'alésage et une classe d'arbre, par exemple 25 H7/g6
fit-preferred = Recommandé
fit-function = Fonction
fit-list-hole-basis = Alésage normal
fit-list-shaft-basis = Arbre normal
fit-parts = Pièces réelles
fit-hole-measured = Alésage mesuré
fit-shaft-measured = Arbre mesuré
fit-temperature = Température
fit-hole-material = Matière de l'alésage
fit-hole-expansion = Alésage, µm/(m K)
fit-shaft-material = Matière de l'arbre
fit-shaft-expansion = Arbre, µm/(m K)
fit-own-value = Valeur saisie
fit-press = Emmanchement
fit-press-length = Longueur d'emmanchement
fit-hub-outer = Extérieur du moyeu
fit-shaft-bore = Alésage de l'arbre
fit-press-material = Un emmanchement exige un matériau de la liste pour les deux pièces : choisissez-en un
fit-press-pressure = Pression de contact
fit-press-force = Tient axialement
fit-press-torque = Tient en couple
fit-press-pressing = Force d'emmanchement
fit-press-hub = Moyeu : contrainte / limite
fit-press-shaft = Arbre : contrainte / limite
fit-press-heat = Chauffer le moyeu à
fit-press-cool = Ou refroidir l'arbre à
fit-press-friction = Frottement { $friction } ; élastique, à 20 °C et au repos. Force axiale et couple ne valent pas ensemble
fit-search = Recherche par jeu
fit-wanted-minimum = Minimum
fit-wanted-maximum = Maximum
fit-scope = Parmi
fit-scope-all = Toutes les classes
fit-scope-basis = Alésage normal et arbre normal
fit-scope-preferred = Ajustements recommandés et nommés
fit-search-hint = Le jeu minimal et le jeu maximal ; une valeur négative est un serrage. Une unité est admise : 7 µm
fit-search-size = La recherche demande une cote nominale : la saisir ci-dessus
fit-found = { $count ->
    [one] { $count } ajustement
   *[other] { $count } ajustements
}
fit-found-first = les { $count } meilleurs sont listés
fit-found-none = Aucun ajustement ne convient. Le plus proche
fit-missed-by = { $below } µm de moins, { $above } µm de trop
fit-is-preferred = recommandé

fit-picture = Intervalles d'alésage et d'arbre
fit-picture-legend = µm depuis la ligne zéro ; écart fondamental en gras
fit-picture-empty = Les intervalles apparaissent avec l'ajustement
fit-arrow-clearance = Jeu réel
fit-arrow-interference = Serrage réel
fit-describe-zero = Ligne zéro à { $nominal } mm.
fit-describe-zone = { $part } { $class } de { $lower } à { $upper } µm.
fit-describe-fundamental = Écart fondamental { $deviation } µm.
fit-describe-measured = { $part } : valeur mesurée à { $deviation } µm.
fit-classes = Classes à { $nominal } mm
fit-classes-none = Classes
fit-classes-empty = Les classes apparaissent avec une cote nominale
fit-classes-nowhere = Aucune classe n'est définie à cette cote
fit-staircase = Intervalles du degré { $grade }

fit-word-clearance = Avec jeu
fit-word-transition = Incertain
fit-word-interference = Avec serrage
fit-word-none = Aucun ajustement
fit-maximum-clearance = Jeu maximal
fit-minimum-clearance = Jeu minimal
fit-maximum-interference = Serrage maximal
fit-minimum-interference = Serrage minimal
fit-mean-clearance = Jeu moyen
fit-mean-interference = Serrage moyen
fit-ansi = ANSI B4.2 : { $name }
fit-equivalent = Ajustement équivalent
fit-equivalent-same = Exactement les mêmes jeux
fit-equivalent-differs = Pas le même : jeu minimal { $minimum } µm, maximal { $maximum } µm
fit-check-hole = Contrôler l'alésage
fit-check-shaft = Contrôler l'arbre
fit-move = Aller à une autre classe
fit-actual-clearance = Jeu { $um } µm
fit-actual-interference = Serrage { $um } µm
fit-conforms = Dans les limites de la cote tolérancée
fit-conforms-not = Hors des limites de la cote tolérancée
fit-with-good-shaft = Jeu avec un arbre bon
fit-with-good-hole = Jeu avec un alésage bon
fit-at-temperature = À { $degrees } °C
fit-temperature-change = le jeu change de { $um } µm
fit-these-parts = Ces pièces : { $clearance }

## Matières personnelles
materials-refused = Les matières personnelles ne peuvent pas être utilisées : { $path }, { $reason }

## Palette
section-said = { $name } : { $value }
crash-report = La fenêtre s'est fermée à cause d'une erreur du programme. Un compte rendu, sans valeurs mesurées, se trouve dans { $path }
rail-more = Plus
top-open = { $name } est ouvert
top-undo = Annuler la dernière modification
top-recorded = Consigné, { $number }
top-recording = Consignation…
top-not-recorded = Non consigné
palette = Rechercher ou lancer
palette-do = Lancer
palette-open = Ouvrir
palette-settings = Réglages et aide
palette-records = Relevés
palette-fit = Ajustement { $fit }
palette-in-tables = { $what } dans les tables
palette-uncertainty = Incertitude à { $size } mm
palette-records-of = Relevés : { $what }
palette-show-setting = Afficher dans la page Réglages
palette-more = Autres actions possibles
palette-back = Retour aux résultats
palette-check-value = Contrôler { $callout } avec { $value }
palette-check = Contrôler { $callout }
palette-search-manual = Chercher « { $query } » dans le manuel
palette-nothing = Rien ne porte ce nom
palette-hint = Une cote tolérancée, une page, une action ou un fichier

## Quitter
leave = Fermer Fitcheck ?
discard = Abandonner les modifications ?
discard-unsaved = { $name } a des modifications non enregistrées.
discard-no = Continuer à modifier
discard-yes = Abandonner
leave-unsaved = Non enregistré : { $names }
leave-stay = Continuer le travail
leave-anyway = Fermer sans enregistrer

## Images des cycles
cycle-picture-centre-1 = centre nominal sur le premier axe
cycle-picture-centre-2 = centre nominal sur le deuxième axe
cycle-picture-centre-tolerance-1 = écart admissible du centre sur le premier axe, dans les deux sens ; 0 ne surveille rien
cycle-picture-centre-tolerance-2 = écart admissible du centre sur le deuxième axe, dans les deux sens ; 0 ne surveille rien
cycle-picture-side-length-1 = longueur nominale du rectangle le long du premier axe
cycle-picture-side-length-2 = longueur nominale du rectangle le long du deuxième axe
cycle-picture-maximum-side-1 = longueur maximale admissible le long du premier axe
cycle-picture-maximum-side-2 = longueur maximale admissible le long du deuxième axe
cycle-picture-minimum-side-1 = longueur minimale admissible le long du premier axe
cycle-picture-minimum-side-2 = longueur minimale admissible le long du deuxième axe
cycle-picture-width = largeur nominale, de paroi à paroi
cycle-picture-maximum-width = largeur maximale admissible
cycle-picture-minimum-width = largeur minimale admissible
cycle-picture-start-1 = point de départ du palpeur dans la rainure, premier axe
cycle-picture-start-2 = point de départ du palpeur dans la rainure, deuxième axe
cycle-picture-shift = décalage du deuxième point de palpage le long des parois ; 0 palpe en face du premier
cycle-picture-first-point-1 = premier point, sur la paroi côté plus : premier axe
cycle-picture-first-point-2 = premier point, sur la paroi côté plus : deuxième axe
cycle-picture-second-point-1 = deuxième point, sur la paroi côté moins : premier axe
cycle-picture-second-point-2 = deuxième point, sur la paroi côté moins : deuxième axe
cycle-picture-axis-of-plane = axe de mesure : 1 premier axe, 2 deuxième axe
cycle-picture-diameter = diamètre nominal
cycle-picture-maximum-size = diamètre maximal admissible
cycle-picture-minimum-size = diamètre minimal admissible
cycle-picture-start-diameter = diamètre du cercle où se tient le palpeur avant chaque point de palpage
cycle-picture-first-angle = angle du premier point de palpage, mesuré à partir du premier axe
cycle-picture-step = angle d'un point de palpage au suivant ; moins tourne dans le sens horaire
cycle-picture-arc = angle sur lequel les points de palpage sont répartis ; 360 est un tour complet, moins tourne dans le sens horaire
cycle-picture-longest-path = course de palpage la plus longue ; plus s'éloigne du centre, moins s'en approche
cycle-picture-difference = chaque point est palpé deux fois : différence maximale admissible
cycle-picture-measuring-height = hauteur du centre de la bille au point de palpage
cycle-picture-set-up-clearance = distance devant le point de palpage, ajoutée à SET_UP du tableau de palpeurs
cycle-picture-clearance-height = hauteur à laquelle le palpeur se déplace librement
cycle-picture-point-1 = point à palper, premier axe
cycle-picture-point-2 = point à palper, deuxième axe
cycle-picture-point-3 = point à palper, troisième axe
cycle-picture-next-point-1 = deuxième point de la droite, premier axe
cycle-picture-next-point-2 = deuxième point de la droite, deuxième axe
cycle-picture-next-point-3 = deuxième point de la droite, troisième axe
cycle-picture-second-centre-1 = centre nominal du deuxième cercle, premier axe
cycle-picture-second-centre-2 = centre nominal du deuxième cercle, deuxième axe
cycle-picture-second-diameter = diamètre nominal du deuxième cercle
cycle-picture-second-height = hauteur à laquelle le deuxième cercle est palpé
cycle-picture-geometries = 0 deux trous, 1 deux tenons, 2 un trou et un tenon, 3 un tenon et un trou
cycle-picture-maximum-coordinate = coordonnée maximale admissible
cycle-picture-minimum-coordinate = coordonnée minimale admissible
cycle-picture-normal-1 = composante de la normale à la surface sur le premier axe ; la normale sort de la matière
cycle-picture-normal-2 = composante de la normale à la surface sur le deuxième axe ; la normale sort de la matière
cycle-picture-normal-3 = composante de la normale à la surface sur le troisième axe ; la normale sort de la matière
cycle-picture-band = écart admissible suivant la normale : surcote plus, sous-cote moins
cycle-picture-retract = course de retrait depuis le point de palpage, dans le sens opposé au palpage
cycle-picture-move-to-clearance = trajet entre points de palpage : 0 à la hauteur de mesure, 1 par la hauteur de sécurité
cycle-picture-clearance-mode = hauteur de sécurité : −1 jamais, 0 avant et après le cycle, 1 avant et après chaque objet, 2 à chaque point de palpage
cycle-picture-traverse = trajet vers le point suivant : 0 droite, 1 arc de cercle
cycle-picture-contact-count = nombre de points de palpage
cycle-picture-plane = plan du cercle : 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 palpe à l'intérieur, 1 à l'extérieur
cycle-picture-measured-axis = axe de mesure : 1 premier axe, 2 deuxième axe, 3 axe du palpeur
cycle-picture-direction = sens de l'approche : −1 contre l'axe, +1 dans le sens de l'axe
cycle-picture-directed-axis = axe mesuré, 1 premier, 2 second, 3 axe du palpeur ; moins palpe en sens contraire
cycle-picture-tool-axis-probing = axe du palpeur : 0 reste tel quel, 1 est aussi palpé et fixé
cycle-picture-tool-axis-point-1 = où l'axe du palpeur est palpé, premier axe
cycle-picture-tool-axis-point-2 = où l'axe du palpeur est palpé, deuxième axe
cycle-picture-tool-axis-point-3 = où la surface est attendue dans l'axe du palpeur
cycle-picture-new-datum-1 = coordonnée que l'endroit mesuré reçoit dans le premier axe
cycle-picture-new-datum-2 = coordonnée que l'endroit mesuré reçoit dans le deuxième axe
cycle-picture-new-datum-3 = coordonnée que l'endroit mesuré reçoit dans l'axe du palpeur
cycle-picture-new-coordinate = coordonnée que l'endroit mesuré reçoit dans l'axe mesuré
cycle-picture-table-row = ligne du tableau où va le point d'origine ; avec 0 il est actif aussitôt
cycle-picture-transfer = tableau : −1 non indiqué, 0 points zéro, 1 points d'origine
cycle-picture-preset-correction = 0 laisse le point d'origine actif tel quel ; un autre nombre le corrige, pour que ce point affiche sa valeur nominale
cycle-picture-aligned-angle = angle sur lequel l'arête est alignée, à partir du premier axe ; 0 l'aligne sur l'axe
cycle-picture-compensation-axis = axe rotatif qui aligne l'arête : 0 celui autour duquel l'angle a été mesuré, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = l'axe rotatif après l'alignement : 0 garde sa valeur, 1 affiche zéro
cycle-picture-rotary-alignment = les axes rotatifs après la mesure : 0 ne bougent pas, un autre nombre les tourne, pour que la droite soit alignée
cycle-picture-rotation-transfer = l'angle mesuré : 0 ne change rien, 1 devient la rotation de base, 2 un décalage de l'axe rotatif
cycle-picture-log = procès-verbal de mesure : 0 aucun, 1 fichier, 2 à l'écran avec arrêt du programme
cycle-picture-stop = hors tolérance : 0 le programme continue, 1 il s'arrête avec un message
cycle-picture-stop-on-undersize = hors tolérance : 0 le programme continue, 1 il s'arrête, 2 il s'arrête seulement en sous-cote
cycle-picture-stop-on-scrap = hors tolérance : 0 le programme continue, 1 il s'arrête, 2 il s'arrête seulement pour un rebut
cycle-picture-tool = outil à surveiller, par son numéro ou son nom ; 0 signifie aucun
cycle-picture-any-length = { $name } Une longueur
cycle-picture-any-angle = { $name } Un angle
cycle-picture-any-choice = { $name } Au choix { $of }
cycle-picture-any-number = { $name } Un nombre
cycle-picture-part = Pièce à { $count ->
    [one] { $count } élément
   *[other] { $count } éléments
  } : { $names }.
cycle-picture-path = Trajet du palpeur, déplacement { $step } sur { $moves }, { $contacts ->
    [one] { $contacts } point de palpage
   *[other] { $contacts } points de palpage
}. Bille à X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, point de palpage { $touch }
cycle-picture-no-path = Le trajet apparaît quand le cycle a été exécuté
cycle-picture-phase-pre-position = prépositionnement
cycle-picture-phase-approach = approche
cycle-picture-phase-contact = contact
cycle-picture-phase-retract = retrait
cycle-picture-phase-leave = dégagement
cycle-picture-from-above = { $first }/{ $second } vu de dessus
cycle-picture-from-side = { $first }/{ $second } vu de côté
cycle-picture-contacts = { $count } points de palpage autour de leur cercle des moindres carrés Ø { $diameter } mm, { $factor } : { $residuals }.
cycle-picture-nominal = Cercle nominal Ø { $diameter } mm.
cycle-picture-legend-fitted = moindres carrés
cycle-picture-legend-nominal = nominal
cycle-picture-deviation = écart suivant la normale { $deviation } mm, sans tolérance
cycle-picture-no-limits = Aucune limite donnée : rien n'a été comparé
cycle-picture-head-criterion = Critère
cycle-picture-head-centre-1 = Centre, 1er axe
cycle-picture-head-centre-2 = Centre, 2e axe
cycle-picture-head-diameter = Ø en mm
cycle-picture-head-form = Forme
cycle-picture-none = —
cycle-picture-least-squares = Moindres carrés
cycle-picture-circumscribed = Minimal circonscrit
cycle-picture-inscribed = Maximal inscrit
cycle-picture-zone = Zone minimale, circularité
cycle-picture-two-point = Cote entre deux points
cycle-picture-two-point-of = Cote entre deux points { $first }–{ $second }
cycle-picture-two-point-least = Plus petite cote entre deux points, { $first }–{ $second }
cycle-picture-two-point-most = Plus grande cote entre deux points, { $first }–{ $second }
cycle-picture-no-opposed = aucun point de palpage n'est opposé à un autre
cycle-picture-uncertainty = Une dispersion s d'un point de palpage donne { $diameter } s sur le diamètre, { $against } fois celle de 3 points à 120°, et { $across } s à { $along } s sur le centre

# L'état enregistré, et la fenêtre elle-même
saved-broken = l'état enregistré ne peut pas être lu : { $reason }
saved-newer = l'état enregistré est de version { $version }, ce programme lit les versions jusqu'à { $known }
window-no-display = pas d'affichage : DISPLAY et WAYLAND_DISPLAY ne sont pas définis. Ouvrir une session sur un bureau, se connecter avec ssh -X, ou utiliser la ligne de commande, qui n'a pas besoin d'affichage : fitcheck check "25 H7" --measured 25.012 ; voir fitcheck --help
open-unknown = { $name } n'est pas un fichier que la fenêtre ouvre ; elle ouvre les mesures, procès-verbaux de mesure et points de palpage (.csv, .tsv, .txt, .html), programmes CN (.h), tables (.tab), tableaux d'outils (.t), pièces simulées (.toml), tableaux de palpeurs (.tp) et masques (.a)
window-not-opened = la fenêtre ne peut pas s'ouvrir : { $reason } ; la ligne de commande fonctionne sans affichage, voir fitcheck --help

## Rangées d'un gros fichier

rows = Rangées
rows-cancel = Arrêter
rows-again = Juger de nouveau
rows-close = Fermer le fichier
rows-close-hint = Ferme le gros fichier ; ses rangées ne sont pas conservées
rows-move = Aller à une autre rangée
rows-show = Afficher le contrôle de la rangée
rows-keep = Ajouter à l'historique
rows-kept = Le contrôle a été ajouté à l'historique
rows-progress = Part lue du fichier
rows-running = { $count } rangées jusqu'ici, { $percent } % du fichier, { $rate } rangées par seconde
rows-done = { $count } rangées, toutes jugées en { $seconds }
rows-seconds = { $seconds } s
rows-less-than = moins de { $seconds } s
rows-cancelled = INCOMPLET : arrêté après { $count } rangées, { $percent } % du fichier
rows-failed = INCOMPLET après { $count } rangées : { $why }
rows-why-bytes = { $size } Mio, plus de { $limit } Mio : jugé rangée par rangée, et les rangées ne restent pas dans l'historique
rows-why-packed = Compressé : jugé rangée par rangée, et les rangées ne restent pas dans l'historique ; le texte décompressé est dans un fichier temporaire jusqu'à la fermeture du fichier
rows-not-judged = NON JUGÉ
rows-fate = { $fate } { $count }
rows-fate-hint = Liste ces rangées ; plusieurs choix possibles
rows-classes = Classes
rows-all-classes = Toutes les classes
rows-no-class = Sans classe
rows-some-classes = { $count } classes
rows-class = { $class } : { $count }
rows-summary = Résumé
rows-fate-only = Lister les rangées { $fate } du gros fichier
rows-filter-hint = Liste les rangées dont les cellules contiennent ces mots : pièce, cote tolérancée, valeur ou statut
rows-worst-first = Les pires d'abord
rows-worst-first-hint = Liste les rebuts avant les retouches et les bons, le plus grand écart aux limites d'abord
rows-worst = Pire pièce
rows-sifting = Recherche dans les rangées…
rows-sifts-at-end = Le filtre et l'ordre s'appliquent quand toutes les rangées sont jugées
rows-in-order = les pires d'abord
rows-worst-of-many = les { $most } pires, les pires d'abord
rows-first-of-many = les { $most } premières
rows-export = Rangées du fichier en { $format }, avec verdicts…
rows-export-programs = Contrôles des rangées de la liste en { $format }…
rows-export-simulated = Les premières lignes du fichier disent qu'il est simulé, et seul CSV peut les conserver. Exporter en CSV
rows-export-twice = Le fichier a deux colonnes nommées { $column }. Exporter en CSV ou TSV, qui admettent les deux
rows-report-counts = { $name } : { $count } rangées ; { $good } BON, { $rework } RETOUCHE, { $remeasure } REMESURER, { $out } HORS TOLÉRANCE, { $scrap } REBUT, { $unjudged } NON JUGÉ ; { $listed } listées dans ce rapport
rows-report-without = { $count ->
    [one] { $count } rangée de la liste n'a ni verdict ni contrôle dans ce rapport
   *[other] { $count } rangées de la liste n'ont ni verdict ni contrôle dans ce rapport
}
rows-file-name = { $name }-juge
rows-not-whole = INCOMPLET : les nombres ne sont pas ceux du fichier entier
rows-listed = { $listed } rangées listées sur { $count }
rows-refused = { $count ->
    [one] { $number } rangée non jugée
   *[other] { $number } rangées non jugées
}
rows-doubted = { $count ->
    [one] { $number } valeur est peut-être une autre grandeur ou celle d'une autre pièce
   *[other] { $number } valeurs sont peut-être une autre grandeur ou celles d'une autre pièce
}
rows-simulated = { $count ->
    [one] { $number } rangée dit que personne n'a mesuré
   *[other] { $number } rangées disent que personne n'a mesuré
}
rows-status-differs = { $count ->
    [one] { $number } rangée a un autre statut dans son fichier
   *[other] { $number } rangées ont un autre statut dans leur fichier
}
rows-status-unknown = { $count ->
    [one] { $number } rangée a un statut inconnu dans son fichier
   *[other] { $number } rangées ont un statut inconnu dans leur fichier
}
rows-claim-differs = { $count ->
    [one] { $number } limite, écart ou type d'élément contredit sa rangée
   *[other] { $number } limites, écarts ou types d'élément contredisent leurs rangées
}
rows-several-lines = { $count ->
    [one] { $number } rangée occupe plusieurs lignes
   *[other] { $number } rangées occupent plusieurs lignes
}
rows-not-utf8 = { $count ->
    [one] { $number } ligne n'est pas en UTF-8 et a été lue en Windows-1252
   *[other] { $number } lignes ne sont pas en UTF-8 et ont été lues en Windows-1252
}
rows-comments = { $count ->
    [one] { $number } commentaire n'est pas une rangée
   *[other] { $number } commentaires ne sont pas des rangées
}
rows-note = Ligne { $line } : { $what }
rows-first-notes = Les { $first } premiers sur { $count } :
rows-line = Ligne { $line } de { $name }
rows-row-line = ligne { $line }
rows-list = Rangées du fichier
rows-none = Aucune rangée ne correspond au filtre
rows-none-yet = Pas encore de rangée
rows-head-line = Ligne
rows-head-what = À faire
rows-changed = le fichier a changé depuis qu'il a été jugé ; le juger de nouveau
rows-unread = les rangées ne peuvent pas être relues : { $reason }
rows-no-copy = le texte décompressé ne peut pas être conservé : { $reason }
rows-too-much = le texte décompressé dépasse { $most } Gio
rows-panicked = une erreur interne a mis fin à l'exécution

## Un fichier lu ou écrit
working = En cours
working-reading = Lecture de { $name } : { $rows } rangées, { $done } sur { $all } Mo, { $rate } rangées par seconde
working-reading-bytes = Lecture de { $name } : { $done } sur { $all } Mo, { $seconds } s
working-writing = Écriture de { $name } : { $done } Mo, { $seconds } s
working-progress = Avancement de la lecture
working-stop = Arrêter
working-stopped = Arrêté après { $rows } rangées : rien de { $name } n'a été importé

## What a code reader typed into the field of the value
scanned-callout = { $given } est une cote tolérancée et a été prise comme telle
scanned-serial = { $given } n'est pas une valeur : pris comme numéro de série des prochains contrôles
