# La fenêtre pour un opérateur

operator-mode = Pour qui est cette fenêtre
operator-mode-about = Un opérateur a la mesure, les résultats et l'aide, en grandes lettres ; tout le reste est dans la fenêtre complète
operator-mode-operator = Opérateur
operator-mode-operator-about = Mesure, résultats et aide, pour doigts, gants et deux mètres de distance.
operator-mode-full = Tout
operator-mode-full-about = Toutes les pages, pour un bureau.
operator-question = Pour qui est cette fenêtre ?
operator-question-later = Ce choix peut être changé à tout moment dans les réglages ; un opérateur y arrive par « Quitter ».
operator-leave = Quitter
operator-report = Rapport
operator-undo = Annuler
operator-measure = Mesurer
operator-results = Résultats
operator-one-size = Une cote
operator-part = Pièce
operator-last = Derniers résultats
operator-no-results = Rien n'a encore été mesuré.
operator-features = { $count ->
    [one] { $count } élément
   *[other] Les { $count } éléments
}
operator-next = Suivant
operator-next-part = Pièce suivante
operator-to-value = Valeur
operator-type-callout = Saisir ce que dit le dessin, par exemple 25 H7.
operator-type-value = Mesurer, puis saisir la valeur.
operator-choose-part = Choisir une pièce, puis saisir son numéro de série.
operator-hole-or-shaft = Lequel est mesuré ?
operator-plans = Pièces
operator-no-plans = Aucun plan n'a encore été ouvert sur cet ordinateur. Les plans s'ouvrent dans la fenêtre complète, page Pièces.
operator-go-on-first = Lire d'abord le verdict et appuyer sur Suivant : ce qui a été saisi avant n'a pas été pris
