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
operator-newer = Plus récents
operator-older = Plus anciens
operator-back-to-results = Retour aux résultats
operator-dropped = { $name } ne s'ouvre pas ici : un opérateur n'ouvre pas de fichiers. Passer d'abord à la fenêtre complète.
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

## The PIN
operator-pin = Code PIN de la fenêtre opérateur
operator-pin-about = Qui quitte la fenêtre opérateur le saisit. Seul un hachage salé est conservé
operator-pin-use = Verrouiller avec ce code
operator-pin-remove = Supprimer le code
operator-pin-try = Déverrouiller
operator-stay = Rester
operator-pin-short = un code PIN a au moins { $least } caractères
operator-pin-set = La fenêtre opérateur est désormais verrouillée par un code
operator-pin-removed = La fenêtre opérateur n'est plus verrouillée
operator-pin-wrong = Ce n'est pas le code PIN
operator-pin-not-hashed = Impossible de hacher le code PIN : { $why }
operator-pin-asked = Saisir le code PIN pour quitter la fenêtre opérateur.
operator-pin-forgotten = Oublié ? Le manuel dit comment un administrateur entre : The operator's window, The PIN.
