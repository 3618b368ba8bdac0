## Tables de CALYPSO
calypso-number = { $column } : { $reason }
calypso-no-actual = aucune valeur mesurée dans la colonne actual
calypso-cut-off = la dernière ligne, END, manque : le fichier est peut-être tronqué
calypso-row-cut-off = le fichier finit ici sans fin de ligne, la rangée est donc peut-être tronquée : elle est ignorée ; si elle est complète, ajouter une fin de ligne
calypso-zeros = la ligne a des octets de valeur 0, le fichier n'a donc pas été écrit en entier : la rangée est ignorée
calypso-differs = les rangées de { $name } aux lignes { $first } et { $second } ont des valeurs nominales ou des limites différentes
calypso-warning-no-end = la dernière ligne, END, manque : le fichier est peut-être tronqué
calypso-warning-behind = ignoré après la ligne END : { $given }
calypso-warning-zeros = le fichier a ici des octets de valeur 0, il n'a donc pas été écrit en entier : des rangées peuvent manquer
calypso-warning-deviation = la table a un écart de { $given } mm, mais ses valeurs donnent { $expected } mm
calypso-warning-exceed = la table a { $given } mm hors de la tolérance, mais ses valeurs donnent { $expected } mm
