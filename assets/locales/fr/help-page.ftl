page-help = Aide

help-page-help = Aide sur cette page
help-page-help-hint = Ouvre le manuel ; dans la page d'aide, revient à la page précédente
help-page-explain = Expliquer ce champ
help-page-explain-hint = Montre à quoi sert le champ, son unité, sa plage et un exemple de saisie
help-page-about-field = Aide sur { $name }
help-page-in-manual = Dans le manuel
help-page-entry = Aide : { $title }
help-page-keys = Raccourcis clavier
help-page-search = Chercher dans le manuel
help-page-open-found = Ouvrir le meilleur résultat
help-page-nothing = Aucune page du manuel ne contient ces mots.
help-page-topics = Sommaire
help-page-list = Pages du manuel
help-page-found = { $title }, { $heading }
help-page-found-line = { $place } : { $line }
help-page-move = Aller à une autre page du manuel
help-page-read = Afficher la page
help-page-scroll = Faire défiler le texte
help-page-back = Retour
help-page-english = Le manuel est en anglais.

# Exemples
help-page-samples = Essayer
help-page-sample-value = Essayer 25 H7 avec 25,012
help-page-sample-part = Ouvrir une pièce d'exemple
help-page-sample-file = Ouvrir un fichier d'exemple
help-page-sample-program = Ouvrir un programme d'exemple
help-page-sample-hint = Les exemples font partie du programme. Les valeurs du fichier d'exemple sont marquées comme simulées.

# La feuille des touches
help-page-keys-about = Une touche propre à une page agit tant que cette page est ouverte.
help-page-everywhere = Dans toutes les pages
help-page-in-dialogs = Dans les dialogues
help-page-on-workpiece = Pièce simulée
help-page-key-row = { $keys } : { $text }
