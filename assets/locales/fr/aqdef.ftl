## AQDEF de Q-DAS
aqdef-line = une clé et un texte tels que K0001/1 25.012 attendus, ou une ligne de valeurs
aqdef-number = { $key } : { $reason }
aqdef-whole = { $key } : { $given } n'est pas un nombre entier
aqdef-undeclared = valeur de la caractéristique { $number }, qui n'est pas déclarée avant cette ligne
aqdef-of-all = { $key } avec le numéro 0 serait la valeur de toutes les caractéristiques : ignoré
aqdef-cut-off = le fichier finit ici sans fin de ligne, { $given } est donc peut-être tronqué : ignoré ; si c'est complet, ajouter une fin de ligne
aqdef-zeros = la ligne a des octets de valeur 0, le fichier n'a donc pas été écrit en entier : la ligne est ignorée
aqdef-mark-between = K0002/0 { $given } est entre cette rangée et la précédente et peut valoir pour l'une ou l'autre : la valeur est ignorée
aqdef-twice = { $key } est donné deux fois avec des textes différents, avant avec { $other } : les valeurs de cette caractéristique ne sont pas jugées
aqdef-fields = au plus { $most } champs attendus dans une valeur, { $found } trouvés
aqdef-no-values = { $count ->
        [0] ni caractéristiques ni valeurs
        [one] { $count } caractéristique mais aucune valeur : c'est un plan, et non des mesures
       *[other] { $count } caractéristiques mais aucune valeur : c'est un plan, et non des mesures
    }
aqdef-no-values-beside = { $count ->
        [0] ni caractéristiques ni valeurs
        [one] { $count } caractéristique mais aucune valeur
       *[other] { $count } caractéristiques mais aucune valeur
    }, et pas de { $file } d'au plus { $most } Mio à côté de ce fichier : c'est un plan, et non des mesures ; donner { $file } lui-même s'il est plus gros
aqdef-no-description = valeurs sans caractéristiques : { $file } manque à côté de ce fichier
aqdef-count = K0100 annonce { $expected } caractéristiques, { $found } trouvées : le fichier est peut-être tronqué
aqdef-too-large = les caractéristiques prennent plus de { $most } Mio
aqdef-beside = { $file }, ligne { $line } : { $reason }
aqdef-warning-count = K0100 annonce { $expected } caractéristiques, { $found } trouvées : le fichier est peut-être tronqué
aqdef-warning-fewer = { $expected } valeurs attendues, { $found } trouvées
aqdef-warning-missing = { $count ->
        [one] { $count } valeur est vide ou marquée comme manquante (K0002 est 255 ou 256), à partir de cette ligne : elle est ignorée
       *[other] { $count } valeurs sont vides ou marquées comme manquantes (K0002 est 255 ou 256), à partir de cette ligne : elles sont ignorées
    }
aqdef-warning-skipped = indications ignorées : { $keys }
aqdef-warning-repeated = { $key } est donné deux fois avec des textes différents : celui-ci est utilisé
aqdef-warning-late = { $key } ne se rapporte pas à une valeur lue juste avant : ignoré
aqdef-warning-allowance = la cote nominale et l'écart admis donnent { $limit }, mais la limite est différente : la limite s'applique
aqdef-warning-tolerance = { $key } a une tolérance de { $given } mm, mais les limites donnent { $expected } mm : les limites s'appliquent
aqdef-warning-no-limit = { $key } est donné, mais K2120 ou K2121 dit que cette limite n'existe pas : ignoré
aqdef-warning-kind-of-limit = { $given } n'est pas un type de limite connu (0, 1 ou 2) : lu comme une limite
aqdef-warning-scrap-limit = la limite de rebut { $limit } diffère de la limite : elle est ignorée, et une valeur au-delà de la limite de ce côté est un rebut
aqdef-warning-scrap-feature = la limite de rebut est celle d'un { $feature ->
        [hole] alésage
       *[shaft] arbre
    }, mais { $callout } ne l'est pas : la classe de tolérance s'applique
aqdef-warning-cut-off = le fichier finit ici sans fin de ligne, et { $given } est plus court que les autres : peut-être tronqué
aqdef-warning-zeros = le fichier a ici des octets de valeur 0, il n'a donc pas été écrit en entier : des valeurs peuvent manquer
aqdef-warning-values-left = { $file } a { $count ->
        [one] { $count } ligne de valeurs, qui n'est pas lue
       *[other] { $count } lignes de valeurs, qui ne sont pas lues
    }
aqdef-warning-values-beside = les valeurs viennent de { $file } à côté de ce fichier, et les numéros de ligne s'y rapportent
aqdef-warning-description-beside = les caractéristiques viennent de { $file } à côté de ce fichier
aqdef-warning-beside = { $file }, ligne { $line } : { $reason }
