page-settings = Réglages

# Les sections
settings-page-find = Chercher un réglage
settings-page-sections = Section
settings-page-general = Général
settings-page-appearance = Apparence
settings-page-rule = Règle et limites
settings-page-own-files = Fichiers personnels
settings-page-records = Relevés
settings-page-shop-server = Serveur
settings-page-folders = Dossiers
settings-page-keys = Touches
settings-page-about = À propos
settings-page-nothing = Aucun réglage ne contient ces mots
settings-page-defaults = Valeurs par défaut
settings-page-defaults-hint = Remet cette section comme au premier démarrage. Fichiers, noms et adresses restent.

# Général
settings-page-language-about = Tous les textes de la fenêtre, et son séparateur décimal.
settings-page-own-texts = Textes personnels
settings-page-own-texts-about = Des mots de l'atelier à la place des mots intégrés : un fichier Fluent pour une langue, comme nl_OurShop.ftl.
settings-page-own-texts-count = { $file } : textes personnels { $count } sur { $all }
settings-page-own-texts-reading = { $file } est en cours de lecture
settings-page-own-texts-unread = { $file } n'a pas pu être lu et n'est pas utilisé : { $why }
settings-page-own-texts-elsewhere = Ce sont des textes en { $language }, qui ne comptent que si la fenêtre est dans cette langue.
settings-page-own-texts-refused = { $count ->
    [one] 1 texte est refusé, et le texte intégré est utilisé :
    [many] { $count } textes sont refusés, et les textes intégrés sont utilisés :
   *[other] { $count } textes sont refusés, et les textes intégrés sont utilisés :
}
settings-page-own-texts-more = … et { $count } de plus
load-texts = Textes personnels…
no-own-texts = Ne plus utiliser les textes personnels
dialog-own-texts = Textes personnels
file-kind-own-texts = Textes
settings-page-keypad-about = Grandes touches pour écrans tactiles et gants.
sounds = Sons
sounds-about = Chaque verdict s'entend. Un son long : bon ; deux sons : regarder la pièce ; trois : rebut. Les valeurs simulées ne s'entendent pas.
sounds-failed = Aucun son ne s'entend : { $reason }
sounds-no-player = Aucun son ne s'entend : aucun de ces programmes n'est sur cet ordinateur : { $players }
settings-page-shop = Réglages pour tout l'atelier
settings-page-shop-about = Un fichier pour les autres postes. Sans nom, sans adresse de serveur et sans cote tolérancée.
settings-page-export = Exporter les réglages…
settings-page-import = Importer des réglages…
settings-page-dialog-export = Exporter les réglages
settings-page-dialog-import = Importer des réglages
settings-page-imported = { $count ->
    [0] { $name } : rien n'est différent
    [one] { $name } : { $count } réglage modifié
   *[other] { $name } : { $count } réglages modifiés
}
settings-page-unknown-key = { $key } n'est pas un réglage de cette version. Un export le conserve.
settings-page-no-version = le fichier n'a pas de version : ce n'est pas un fichier de réglages
settings-page-edition = Édition d'ISO 286
file-kind-settings = Réglages

# Apparence
settings-page-colours = Couleurs
settings-page-colours-about = Le verdict a aussi un mot et une forme, quelle que soit sa couleur.
settings-page-zoom = Zoom
settings-page-zoom-about = Agrandit ou réduit tout. Touches : Ctrl avec plus, moins et 0.
settings-page-zoom-out = Réduire
settings-page-zoom-in = Agrandir
settings-page-zoom-normal = Zoom à 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automatique : le tactile agrandit boutons et champs, la souris les réduit.
settings-page-decimal = Séparateur décimal
settings-page-decimal-about = Dans la fenêtre. Les rapports suivent leur langue, les fichiers leurs propres réglages.
settings-page-decimal-of-language = Selon la langue
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Rangées des listes
settings-page-rows-about = Hauteur des rangées des tables : normale 32 px, serrée 26 px. Au tactile toujours 48 px.
settings-page-rows-usual = Normale
settings-page-rows-close = Serrée

# Règle et limites
settings-page-limits-about = Où sont cherchées les limites d'une classe. Les tables personnelles passent toujours en premier.
settings-page-js-about = Pour dessins selon l'édition de 1988, degrés 7 à 11. Sinon les demi-micromètres sont conservés.
settings-page-1988-about = Pour dessins selon l'édition de 1988. Sinon elles sont aussi définies pour des cotes plus grandes.
settings-page-decision-rule = Règle de décision
settings-page-decision-rule-about = Quelle part de l'intervalle est acceptée, compte tenu de l'incertitude de la valeur.
settings-page-prover = Charge de la preuve
settings-page-prover-about = Qui doit prouver qu'une pièce est conforme, ou ne l'est pas.
settings-page-uncertainty-from = Incertitude donnée comme
settings-page-uncertainty-from-about = Une valeur saisie, ou le bilan, qui connaît chaque cote et ses points de palpage.
settings-page-uncertainty-about = De chaque valeur de la page Contrôle. Vide : inconnue.
settings-page-coverage-about = Combien d'incertitudes-types font l'incertitude élargie.
settings-page-budget = Bilan d'incertitude
settings-page-budget-about = Ouvrir un bilan dans sa page et l'utiliser pour les contrôles.
settings-page-guard-factor-about = La largeur de la bande de garde, pour les règles qui prennent un multiple.
settings-page-guard-width-about = Pour la règle à bande de garde fixe.
settings-page-part-temperature = Température de la pièce
settings-page-part-temperature-about = Les valeurs sont corrigées à 20 °C. Vide : sans correction.
settings-page-part-expansion-about = De combien se dilate la matière de la pièce.
settings-page-scale-temperature = Temp. des systèmes de mesure
settings-page-scale-temperature-about = Seulement si la machine ne la compense pas.
settings-page-scale-expansion-about = De combien se dilatent les systèmes de mesure de la machine.
settings-page-clearance-about = À quelle distance de la surface le palpeur commence à la chercher.
settings-page-height = Hauteur de mesure Z
settings-page-height-about = À quelle hauteur le palpeur touche la pièce.
settings-page-first-contact-about = L'angle du premier point de palpage.
settings-page-centre-tolerance-about = De combien le centre peut s'écarter en X et Y. 0 : non surveillé.

# Fichiers personnels
settings-page-own-tables = Tables personnelles
settings-page-own-tables-about = Un dossier avec des tables comme sur la commande. Elles passent avant ISO 286.
settings-page-mask = Masque de la fenêtre d'état
settings-page-mask-about = Ce que la commande imprime, et dans quelle langue.
settings-page-own-mask = Masque personnel
settings-page-own-mask-about = Un fichier de masque de la commande à la place du masque intégré.
settings-page-columns = Colonnes des fichiers
settings-page-columns-about = Montre le rôle de chaque colonne avant l'import d'un fichier, et le retient.

# Relevés
settings-page-journal = Journal
settings-page-journal-about = Chaque contrôle y est écrit. Le fichier d'état peut nommer un autre fichier.
settings-page-who-about = Chaque contrôle est consigné avec ce nom.
settings-page-station = Poste
settings-page-station-about = Le nom de cet ordinateur dans les relevés.

# Serveur de l'atelier
settings-page-server = Adresse du serveur
settings-page-server-about = Envoie chaque relevé à PostgreSQL en arrière-plan, par exemple postgres://mill3@shop.example/checks. Un mot de passe va au trousseau.
settings-page-sent = Déjà envoyés
settings-page-sent-about = Les relevés attendent sur cet ordinateur jusqu'à ce que le serveur les ait.

# Dossiers
settings-page-watched = Dossier surveillé
settings-page-watched-about = Les fichiers qui y sont déposés sont jugés selon le plan ouvert et consignés.
settings-page-recent-about = Le menu liste les derniers fichiers lus.
settings-page-recent-count = { $count ->
    [0] aucun fichier
    [one] { $count } fichier
   *[other] { $count } fichiers
}

# Touches
settings-page-everywhere = Partout
settings-page-on-workpiece = Cycles et programmes
settings-page-in-dialog = Dans le dialogue de fichiers

# À propos
settings-page-version = Version
settings-page-version-about = Fitcheck dit au premier regard si un alésage ou un arbre mesuré est bon.
settings-page-version-is = { $version }, commit { $commit }
settings-page-unknown = inconnu
settings-page-licences = Licences des composants intégrés
settings-page-licence = Licence
settings-page-licence-about = Logiciel libre. Les polices intégrées ont leurs propres licences.
settings-page-state-file = Fichier d'état
settings-page-state-file-about = Conserve réglages, champs et fichiers récents, une seconde après chaque modification.
settings-page-journal-file = Fichier du journal
settings-page-journal-file-about = Conserve chaque contrôle de ce poste.
settings-page-not-used = non utilisé
settings-page-own-tables-unread = { $folder } n'a pas pu être lu et n'est pas utilisé
settings-page-nowhere = non conservé
settings-page-changed = { $name } a été modifié
settings-page-several-changed = { $count } réglages ont été modifiés
settings-page-take-back = Annuler la dernière modification d'un réglage
settings-page-preview = Aperçu avec ces réglages

## The size of the screen
ruler = Taille de l'écran
ruler-about = Tenir une carte bancaire contre l'image et donner à l'image la même largeur : les boutons de l'opérateur font alors 20 mm
ruler-card = Une carte bancaire : pas encore comparée
ruler-known = Une carte bancaire, 85,6 mm
ruler-much-shorter = Beaucoup plus courte
ruler-shorter = Un peu plus courte
ruler-longer = Un peu plus longue
ruler-much-longer = Beaucoup plus longue
ruler-forget = Oublier
settings-page-company = Entreprise sur les rapports
settings-page-company-about = Figure en haut des PDF et HTML, si le modèle ne nomme pas d’entreprise.
settings-page-company-address = Adresse sur les rapports
settings-page-company-address-about = Un point-virgule commence une nouvelle ligne.
settings-page-company-logo = Logo sur les rapports
settings-page-company-logo-about = Le chemin complet d’un fichier PNG, JPEG ou SVG.
settings-page-company-logo-place = { $given } n’est pas un chemin complet : commencez par le lecteur ou le dossier racine
