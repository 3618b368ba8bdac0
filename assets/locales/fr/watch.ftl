# Le dossier où sont déposés les fichiers.

watch-written = en cours d'écriture
watch-locked = utilisé par un autre programme : { $reason }
watch-same = le même contenu a déjà été importé sous { $known }
watch-note = Fitcheck n'a pas pu utiliser ou juger tout le contenu de { $name } :
watch-again = le fichier a été réécrit et commence comme avant : { $count ->
    [one] { $count } valeur importée
   *[other] { $count } valeurs importées
} de nouveau
watch-begins-as = le fichier commence comme { $known }, déjà importé : { $count ->
    [one] { $count } valeur importée
   *[other] { $count } valeurs importées
} de nouveau
watch-same-again = réécrit avec le même contenu, rien n'est donc importé
watch-by-another = un autre programme surveille ce dossier pour le même journal
watch-late = les lignes jusqu'à { $last } complètent des valeurs déjà importées, à partir de la ligne { $first } : vérifier ces valeurs dans le journal
watch-no-line-end = la dernière ligne n'a pas de fin de ligne ; elle a été importée telle quelle
watch-older = un fichier de ce nom a été importé plus tard avec un autre contenu ; non importé de nouveau depuis le début de celui-ci : { $count ->
    [one] { $count } valeur
   *[other] { $count } valeurs
}
watch-refused = lecture impossible ; Fitcheck continue d'essayer : { $reason }
watch-copy = le même contenu a déjà été importé sous { $known } ; si une pièce a vraiment été remesurée, son fichier doit avoir une heure ou un numéro de série
watch-verdicts = le fichier contient des verdicts écrits par Fitcheck, et non des mesures ; rien n'est importé
watch-other = un fichier de ce nom a déjà été importé et commençait autrement ; celui-ci est importé en entier
