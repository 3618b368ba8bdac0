# statistics

# Por qué no hay cifra
statistics-reason-empty = no hay valores
statistics-reason-not-a-number = el valor { $place } no es un número
statistics-reason-too-few = muy pocos valores o grupos: { $found }, se necesitan al menos { $needed }
statistics-reason-all-equal = todos los valores son iguales: no hay dispersión con la que calcular
statistics-reason-no-subgroups = ningún subgrupo tiene dos valores o más
statistics-reason-ungrouped = valores que no dicen a qué grupo pertenecen: { $count }
statistics-look-grouped = Los puntos son medias: { $by ->
        [part] de los valores de una pieza
        [batch] de los valores de un lote
        [machine] de los valores de una máquina
        [gauge] de los valores de una estación
        [who] de los valores de una persona
       *[other] de valores sin una pausa de más de { $minutes } min
    }.
statistics-look-stages = Puntos en los que empieza una etapa: { $points }. Los valores son los de la última etapa.
statistics-look-waits = Etapas que aún tienen muy pocos valores distintos y todavía no cuentan: { $count }.
statistics-look-frozen = Los límites de control son los de los puntos { $first } a { $last }.
statistics-look-memory = Segundo gráfico: { $method }.
statistics-look-no-memory = Ningún gráfico { $method }: { $why }.
statistics-reason-large-subgroup = un subgrupo tiene { $found } valores: el recorrido se usa hasta { $most }
statistics-reason-unequal-subgroups = los subgrupos tienen de { $least } a { $most } valores: este gráfico necesita subgrupos de igual tamaño
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
statistics-chart-ewma = Medias ponderadas (EWMA)
statistics-chart-cusum = Sumas de desviaciones de la media (CUSUM)
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
statistics-advice-average-out = la media ponderada está fuera de sus límites, por primera vez en el punto { $at }: la media se ha desplazado
statistics-advice-sum-out = la suma está fuera del intervalo de decisión, por primera vez en el punto { $at }: la media se ha desplazado, desde el punto { $since } aproximadamente
statistics-advice-groups-alike = los grupos no difieren más que por azar (p = { $p })
statistics-advice-groups-differ = los grupos difieren (p = { $p })

# Estudios de instrumentos
statistics-gauge-operator-per-value = cada valor tiene su propio operario: ¿son correctas las columnas?
statistics-gauge-more-operators = operarios: { $operators }, piezas: { $parts }: ¿están intercambiadas las columnas de piezas y operarios?
statistics-gauge-operators-differ-more = los operarios difieren más que las piezas: ¿están intercambiadas las columnas de piezas y operarios?
statistics-gauge-same-parts = cada operario tiene piezas con los mismos nombres: ¿es un estudio cruzado?
statistics-gauge-several-masters = los valores son de { $parts } piezas, y este estudio necesita un solo patrón
statistics-gauge-master-good = bastante bueno para esta tolerancia: Cg y Cgk alcanzan { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = no es bastante bueno para esta tolerancia: Cg y Cgk deben alcanzar { $required }, con un paso de lectura de como máximo el 5 % de la tolerancia (AIAG MSA, VDA 5)
statistics-gauge-smallest = tolerancia más pequeña para la que es bastante bueno: { $mm } mm ({ $level } %: hasta { $most } mm)
statistics-gauge-biased = el sesgo de { $um } µm es más que azar (p = { $p })
statistics-gauge-not-biased = el sesgo de { $um } µm puede ser azar (p = { $p })
statistics-gauge-good = bastante bueno: el instrumento ocupa el { $percent } % { $of ->
        [tolerance] de la tolerancia
       *[variation] de toda la variación
    }, y hasta el 10 % es bueno (AIAG MSA)
statistics-gauge-accepted = bastante bueno solo si tiene que bastar: el instrumento ocupa el { $percent } % { $of ->
        [tolerance] de la tolerancia
       *[variation] de toda la variación
    }, y del 10 % al 30 % depende del uso (AIAG MSA)
statistics-gauge-bad = no es bastante bueno: el instrumento ocupa el { $percent } % { $of ->
        [tolerance] de la tolerancia
       *[variation] de toda la variación
    }, y más del 30 % es demasiado (AIAG MSA)
statistics-gauge-smallest-shares = tolerancia más pequeña para la que es bastante bueno: { $good } mm; si tiene que bastar: { $accepted } mm
statistics-gauge-interaction-kept = los operarios difieren en unas piezas más que en otras (p = { $p }): la interacción se conserva
statistics-gauge-interaction-pooled = los operarios no difieren en unas piezas más que en otras (p = { $p }): la interacción se une a la repetibilidad
statistics-gauge-negative = la varianza { $what ->
        [operator] de los operarios
        [interaction] de la interacción
       *[part] de las piezas
    } resultó negativa y cuenta como 0
statistics-gauge-not-linear = el sesgo cambia con la medida (p = { $p })
statistics-gauge-linear = el sesgo no cambia con la medida más que por azar (p = { $p })
statistics-gauge-stable = estable: ninguna regla se activa y las lecturas no derivan
statistics-gauge-not-stable = no estable: se activa una regla o las lecturas derivan

# Por qué los valores no son un estudio
series-study-no-parts = valores sin pieza: { $count }
series-study-no-operators = valores sin operario junto a otros que lo tienen: { $count }
series-study-uneven-cell = lecturas de la pieza { $part } del operario { $operator }: { $found }, se esperaban { $needed }
series-study-uneven-operator = piezas del operario { $operator }: { $found }, se esperaban { $needed }
series-study-nested = cada pieza la midió un solo operario: es un estudio anidado
series-study-no-reference = valores sin medida calibrada: { $count }
series-study-references = los valores de un patrón tienen varias medidas calibradas

# Cómo se calculan las cifras de un estudio
series-method-word = { $word }
series-method-given = dada
series-method-mean = media, Student
series-method-deviation = desviación típica, ji cuadrado
series-method-bias = media − referencia, Student
series-method-t-test = prueba t
series-method-type1 = tipo 1
series-method-share = { $percent } % de la tolerancia, { $spread } s
series-method-required = Cg y Cgk al menos { $required }
series-method-anova = análisis de la varianza
series-method-degrees = análisis de la varianza, grados de libertad: { $degrees }
series-method-ratio = F = { $f }
series-method-negative = negativa, cuenta como 0
series-method-chi-square = ji cuadrado
series-method-large-sample = muestra grande modificada
series-method-variances = varianzas
series-method-categories = 1,41 piezas / instrumento
series-method-linearity = linealidad
series-method-least-squares = mínimos cuadrados
series-method-within-masters = s dentro de los patrones
statistics-on-spread = dispersión: { $rule }
