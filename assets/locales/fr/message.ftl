# Où se trouve une erreur ou un avertissement dans un fichier

located-in-file = { $what } : { $file }, ligne { $line }, colonne { $column }
located-in-line-of-file = { $what } : { $file }, ligne { $line }
located-at-file = { $what } : { $file }
located-at-column = ligne { $line }, colonne { $column } : { $what }
located-at-line = ligne { $line } : { $what }

# Textes personnels de l'utilisateur

own-text-language = { $given } ne commence par aucun code de langue. Le nom d'un fichier de textes personnels commence par un de { $codes }, comme nl_OurShop.ftl : renommer le fichier
own-text-too-large = le fichier a { $bytes } octets, et un fichier de textes personnels peut en avoir { $most } : ne garder que les textes différents
own-text-not-utf8 = l'octet { $byte } n'est pas de l'UTF-8 : enregistrer le fichier en UTF-8
own-text-syntax = { $given } ne peut pas être lu comme du Fluent ({ $reason }). Écrire le nom au début d'une ligne, puis = et le texte, et mettre les lignes suivantes en retrait
own-text-not-a-text = { $given } est un terme ou a des attributs, et seuls des textes peuvent être remplacés : écrire nom = texte
own-text-unknown = il n'y a pas de texte { $name }, et aucun nom ne lui ressemble. Les noms sont ceux des textes intégrés : corriger ou supprimer
own-text-misspelt = il n'y a pas de texte { $name }. Le nom le plus proche est { $nearest } : corriger ou supprimer
own-text-twice = { $name } est donné deux fois, d'abord à la ligne { $first }, et aucun des deux ne compte : en supprimer un
own-text-empty = { $given } a un texte vide, ou une variante qui ne montre rien : écrire un texte, ou le supprimer pour avoir celui qui est intégré
own-text-control = { $given } a le caractère de commande { $code }, et seuls des caractères visibles sont permis : le supprimer
own-text-too-much = { $given } a plus de { $longest } caractères, plus de { $deepest } accolades imbriquées ou trop de variantes : l'écrire plus simplement
own-text-surplus = { $name } a { $given }, pour quoi rien n'est inséré. Seul { $allowed } est possible : corriger ou supprimer
own-text-surplus-of-none = { $name } a { $given }, mais rien n'est inséré dans ce texte : le supprimer
own-text-lost = { $lost } du texte intégré manque dans { $name }, au moins dans une variante, et quelque chose ne serait pas dit : l'ajouter
own-text-read-back = { $name } dit d'où vient une valeur et est relu dans des fichiers, il ne peut donc pas être remplacé : le supprimer
own-text-property = { $name } appartient à la langue et n'est pas un texte à remplacer : le supprimer
own-text-same-verdict = { $name } ne compte pas, car { $clash } dit { $word }, ce que dit aussi { $other }. Chaque verdict a besoin d'un mot à lui, aussi à côté des mots intégrés et anglais : donner à chacun un autre mot
