# pairing

pairing-not-a-range = juegos { $given }: se esperaban el mínimo y el máximo en mm con dos puntos seguidos entre ellos, como 0.010..0.030
pairing-minimum = juego mínimo: { $reason }
pairing-maximum = juego máximo: { $reason }
pairing-swapped = el juego mínimo { $minimum } mm es mayor que el máximo, { $maximum } mm
pairing-too-narrow = { $feature ->
        [hole] agujeros
       *[shaft] ejes
    } de { $from } a { $to } mm no se pueden clasificar en { $count } grupos: un grupo tiene al menos un nanómetro
pairing-group-count = { $count } grupos: se esperaba de 1 a { $most }
pairing-no-sizes = no hay { $feature ->
        [hole] agujeros
       *[shaft] ejes
    } que clasificar

# What to check about parts
pairing-parts-outside-limits = { $count ->
        [one] 1 pieza está fuera de sus propios límites
       *[other] { $count } piezas están fuera de sus propios límites
    }: los pares se eligen solo por el juego
pairing-parts-checked-twice = { $rows ->
        [one] una comprobación tiene el nombre de una anterior
       *[other] { $rows } comprobaciones tienen el nombre de una anterior
    }, como { $id }, comprobaciones { $first } y { $second }: cada comprobación cuenta como una pieza
pairing-parts-simulated-checks = { $count ->
        [one] 1 comprobación es simulada
       *[other] { $count } comprobaciones son simuladas
    }: no se midió nada
