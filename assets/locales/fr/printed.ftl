## Rapports imprimés
printed-no-value = aucune valeur mesurée sous { $column }
printed-cells = { $found } nombres sous { $expected } colonnes : on ne sait pas quel nombre est dans quelle colonne ; imprimer le rapport avec toutes les colonnes
printed-no-column = aucune colonne { $column } : ajouter les valeurs mesurées au format d'impression du rapport
printed-no-heading = des nombres sans en-tête au-dessus : le début de la dimension manque
printed-no-rows = { $name } n'a aucune rangée : le rapport est peut-être tronqué
printed-minus-sign = la tolérance inférieure { $given } peut être au-dessous ou au-dessus de la valeur nominale, et aucune autre rangée ne décide : imprimer les tolérances inférieures sans signe
printed-unknown-row = axe inconnu { $given } : la rangée est ignorée
printed-warning-deviation = le rapport a un écart de { $given } mm, mais ses nombres donnent { $expected } mm
printed-warning-beyond = le rapport a { $given } mm hors de la tolérance, mais ses nombres donnent { $expected } mm
printed-warning-no-end = la dernière ligne, { $end }, manque : le rapport est peut-être tronqué
printed-warning-lines = ignoré, pas une mesure : { $text } (lignes de ce genre en tout : { $count })
printed-warning-out-of-place = le rapport dit { $given }, et aucune des limites lues ici ne le dit : regarder le rapport
