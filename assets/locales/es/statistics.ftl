# statistics

# Por qué no hay cifra
statistics-reason-empty = no hay valores
statistics-reason-not-a-number = el valor { $place } no es un número
statistics-reason-too-few = muy pocos valores o grupos: { $found }, se necesitan al menos { $needed }
statistics-reason-all-equal = todos los valores son iguales: no hay dispersión con la que calcular
statistics-reason-no-subgroups = ningún subgrupo tiene dos valores o más
statistics-reason-large-subgroup = un subgrupo tiene { $found } valores: el recorrido se usa hasta { $most }
statistics-reason-no-limits = no hay límites
statistics-reason-one-limit = solo hay un límite y se necesitan los dos
statistics-reason-swapped-limits = el límite inferior no está por debajo del superior
statistics-reason-not-positive = esta distribución solo tiene valores positivos
statistics-reason-negative = esta distribución no tiene valores negativos
statistics-reason-no-fit = esta distribución no se ajusta a los valores
statistics-reason-uneven-cell = lecturas de la pieza { $part } por el operario { $operator }: { $found }, se esperaban { $needed }
statistics-reason-no-baseline = el periodo de referencia no está en su etapa, o sus cifras no se pueden usar
statistics-reason-parameter = { $name } no puede ser { $given }

# Reglas de los gráficos de control, donde salta una
statistics-rule-beyond-limits = 1 punto fuera de un límite de control
statistics-rule-nine-one-side = 9 puntos seguidos a un mismo lado de la línea central
statistics-rule-six-trend = 6 puntos seguidos subiendo o bajando
statistics-rule-fourteen-alternating = 14 puntos seguidos alternando arriba y abajo
statistics-rule-two-of-three = 2 de 3 puntos más allá de 2 s a un mismo lado
statistics-rule-four-of-five = 4 de 5 puntos más allá de 1 s a un mismo lado
statistics-rule-fifteen-within = 15 puntos seguidos a menos de 1 s de la línea central
statistics-rule-eight-beyond = 8 puntos seguidos más allá de 1 s, a uno u otro lado
statistics-rule-eight-one-side = 8 puntos seguidos a un mismo lado de la línea central
statistics-chart-maximum = máximo { $size }
statistics-chart-minimum = mínimo { $size }
statistics-chart-upper = superior { $size }
statistics-chart-mean = media { $size }
statistics-chart-lower = inferior { $size }
statistics-chart-values = Valores individuales en µm desde { $base }, los más antiguos a la izquierda
statistics-chart-means = Medias de los grupos en µm desde { $base }, las más antiguas a la izquierda
statistics-chart-histogram = Histograma
statistics-chart-moving-range = Rango móvil, µm
statistics-chart-range = Rango de los grupos, µm
statistics-chart-deviation = Desviación típica de los grupos, µm
statistics-chart-probability = Gráfico de probabilidad
statistics-chart-probability-test = Gráfico de probabilidad, Anderson-Darling { $statistic }, p = { $p }

# Qué hacer con las cifras
statistics-advice-few-values = { $count } valores: los intervalos son amplios, lo habitual son { $enough } o más
statistics-advice-few-points = los límites de control vienen de { $count } puntos: lo habitual son { $enough } o más
statistics-advice-unstable = puntos en los que salta una regla: { $count }; la capacidad solo vale para un proceso estable
statistics-advice-not-of-law = los valores apenas siguen esta distribución (p = { $p }): sus partes fuera de los límites no son fiables
statistics-advice-centred = no corregir: { $what ->
        [line] la medida está ahora a
       *[mean] la media está a
    } { $um } µm del centro de la tolerancia, lo que con { $count } valores es ruido
statistics-advice-near = no corregir: { $what ->
        [line] la medida está ahora a
       *[mean] la media está a
    } { $um } µm del centro de la tolerancia, { $count } valores
statistics-advice-correct = corregir { $correction } µm: { $what ->
        [line] la medida está ahora a
       *[mean] la media está a
    } { $um } µm del centro de la tolerancia, { $count } valores
statistics-advice-no-trend = sin tendencia: el cambio de una pieza a otra es ruido
statistics-advice-trend = la medida cambia { $um } µm por pieza
statistics-advice-trend-at-limit = la medida cambia { $um } µm por pieza, y desde ahora cabe esperar piezas fuera del límite
statistics-advice-trend-to = la medida cambia { $um } µm por pieza: quedan unas { $parts } piezas hasta el límite ({ $level } %: de { $least } a { $most })
statistics-advice-groups-alike = los grupos no difieren más que por azar (p = { $p })
statistics-advice-groups-differ = los grupos difieren (p = { $p })
