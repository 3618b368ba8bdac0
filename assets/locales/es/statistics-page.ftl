page-statistics = Estadística

# Lo que se pide
statistics-page-question = Registros
statistics-page-question-hint = Los registros cuyos valores se usan, en el lenguaje de la página Registro, por ejemplo part:"Brida 40" station:"Fresadora 3" from:2026-11-01. Vacío: todos los registros.
statistics-page-last = Valores más recientes
statistics-page-size = Valores por punto
statistics-page-pause = Pausa en minutos
statistics-page-mean-of = Media de
statistics-page-mean-count = tantos valores seguidos
statistics-page-mean-pause = valores sin pausa
statistics-page-mean-part = valores de una pieza
statistics-page-mean-station = valores de una estación
statistics-page-mean-person = valores de una persona
statistics-page-part = Pieza
statistics-page-all-parts = Todas las piezas
statistics-page-read-again = Volver a leer
statistics-page-range = debe ser un número entero de { $least } a { $most }
statistics-page-reading = Leyendo valores…
statistics-page-off = No se registra nada. La estadística se hace con los valores del registro.
statistics-page-none = Ningún registro con un valor medido responde a esta pregunta.
statistics-page-not-read = No se pueden leer los valores: { $why }

# Lo que se ha leído
statistics-page-values = { $count ->
        [one] 1 valor
       *[other] { $count } valores
    }
statistics-page-groups = { $count ->
        [one] 1 grupo
       *[other] { $count } grupos
    } de { $size }
statistics-page-out = { $count } excluidos: { $why ->
        [simulated] simulados
        [invalid] no válidos
        [doubtful] dudosos
        [withdrawn] corregidos o retirados
       *[user] con motivo
    }
statistics-page-newest = Se han leído los { $count } registros más recientes. Los anteriores no se incluyen.
statistics-page-unread = { $count ->
        [one] No se puede leer 1 registro.
       *[other] No se pueden leer { $count } registros.
    }

# Características
statistics-page-features = Características
statistics-page-features-head = Ppk, marca en { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 valor
       *[other] { $count } valores
    }, Ppk { $ppk }
statistics-page-below = { $count } de { $all } por debajo de { $asked }
statistics-page-move-feature = Otra característica

# Cifras
statistics-page-figures = Cifras
statistics-page-figure-mean = Media
statistics-page-figure-deviation = Desviación típica
statistics-page-figure-cp = Cp a corto plazo
statistics-page-figure-cpk = Cpk a corto plazo
statistics-page-figure-pp = Pp global
statistics-page-figure-ppk = Ppk global
statistics-page-figure-outside = Fuera de los límites
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = de { $count }
statistics-page-expected = se esperan { $ppm } por millón
statistics-page-proven = Está demostrado un Ppk de { $asked }: su límite inferior es { $lower }.
statistics-page-not-proven = No está demostrado un Ppk de { $asked }: su límite inferior es { $lower }.
statistics-page-no-ppk = No está demostrado un Ppk de { $asked }: { $why }.

# El gráfico
statistics-page-single = Valores sueltos
statistics-page-means = Medias de { $size }
statistics-page-means-of-groups = Medias de grupos
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Histograma
statistics-page-spread = Dispersión
statistics-page-probability = Gráfico de probabilidad
statistics-page-no-chart = Sin límites de control: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 punto
       *[other] { $count } puntos
    }, línea central { $centre }, límites de control { $lower } … { $upper }, límites { $minimum } … { $maximum }, { $signals ->
        [one] 1 señal
       *[other] { $signals } señales
    }, { $outside } fuera de los límites.
statistics-page-said-mean-mm = media
statistics-page-said-sd-mm = desviación típica
statistics-page-said-spread-centre-mm = dispersión media
statistics-page-said-spread-upper-mm = límite de control superior de la dispersión
statistics-page-said-ewma-mm = media ponderada
statistics-page-said-ewma-lower-mm = límite inferior de la media
statistics-page-said-ewma-upper-mm = límite superior de la media
statistics-page-said-cusum-above-mm = suma por encima de la media
statistics-page-said-cusum-below-mm = suma por debajo de la media
statistics-page-said-cusum-interval-mm = intervalo de decisión
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Otro punto
statistics-page-open = Abrir el registro
statistics-page-zoom-in = Menos puntos
statistics-page-zoom-out = Más puntos
statistics-page-zoom-whole = Todos los puntos
statistics-page-freeze = Límites según los puntos hasta aquí
statistics-page-unfreeze = Límites según todos los puntos
statistics-page-freeze-hint = Los puntos posteriores no desplazan los límites de control.
statistics-page-leave-out = Excluir…
statistics-page-leave-out-hint = El punto sigue en el gráfico con su motivo. No cuenta para límites, reglas ni cifras.
statistics-page-stage = Empezar aquí una etapa
statistics-page-no-stage = Quitar la etapa
statistics-page-stage-hint = Desde este punto los límites se calculan de nuevo, por ejemplo tras un cambio de herramienta. Los valores son los de la última etapa.
statistics-page-take-in = Volver a incluir
statistics-page-reason = Motivo
statistics-page-take-reason = Excluir
statistics-page-cancel-reason = Cancelar
statistics-page-copy = Copiar las cifras
statistics-page-copy-hint = Cifras, señales y consejos como tabla para una hoja de cálculo
statistics-page-report = Informe…
statistics-page-report-hint = Las cifras y los gráficos de todas las características como informe para firmar
statistics-page-save-chart = Guardar gráfico…
statistics-page-save-chart-hint = Todos los gráficos de la característica en una hoja, como SVG o PNG
statistics-page-dialog-chart = Guardar gráfico
statistics-page-chart-ending = El nombre del archivo debe terminar en .svg o .png.

# Señales
statistics-page-signals = Señales
statistics-page-no-signals = No salta ninguna regla.
statistics-page-rules = Reglas
statistics-page-alarms = Alarmas abiertas: { $count }
statistics-page-at = Punto { $point }
statistics-page-from-to = Puntos { $first } a { $last }
statistics-page-left-out-because = Excluido: { $reason }
statistics-page-advice = Consejos

# Un estudio del instrumento
statistics-study = Estudio del instrumento
statistics-study-open = Abrir lecturas…
statistics-study-open-hint = Un archivo con lecturas de un instrumento, en cualquier formato de mediciones
statistics-study-dialog = Abrir lecturas de un instrumento
statistics-study-readings = { $count ->
        [one] 1 lectura
       *[other] { $count } lecturas
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 lectura
       *[other] { $count } lecturas
    }
statistics-study-none = Abra un archivo con lecturas de un instrumento. Sus columnas dicen qué pieza se leyó y quién la leyó. Antes de calcular nada verá cómo se ha entendido.
statistics-study-kind = Tipo de estudio
statistics-study-type1 = Tipo 1
statistics-study-crossed = Cruzado
statistics-study-nested = Anidado
statistics-study-linearity = Linealidad
statistics-study-stability = Estabilidad
statistics-study-type1-hint = Un patrón, 25 lecturas o más
statistics-study-crossed-hint = Cada operario lee cada pieza, dos veces o más
statistics-study-nested-hint = Cada operario tiene sus propias piezas
statistics-study-linearity-hint = Varios patrones de distintas medidas
statistics-study-stability-hint = Un patrón a lo largo del tiempo
statistics-study-feature = Característica del estudio
statistics-study-lower = Límite inferior
statistics-study-upper = Límite superior
statistics-study-reference = Medida calibrada
statistics-study-resolution = Paso de lectura
statistics-study-references-hint = Una medida para cada patrón por su nombre: M1 = 30.0012; M2 = 40.0005. Vacío usa las medidas nominales del archivo.
statistics-study-reference-unnamed = { $given } no nombra ningún patrón: escriba su nombre delante de la medida, como M1 = 30.0012
statistics-study-own-limits = Límites del archivo: { $lower } … { $upper } mm
statistics-study-understood = Cómo se entendió el archivo
statistics-study-confirm = No se calcula nada hasta que lo confirme.
statistics-study-evaluate = Evaluar
statistics-study-all-the-same = Evaluar de todos modos
statistics-study-working = Evaluando…
statistics-study-answer = ¿Es este instrumento bastante bueno?
statistics-study-each = { $what } cada uno
statistics-study-parts = { $count ->
        [one] 1 pieza
       *[other] { $count } piezas
    }
statistics-study-operators = { $count ->
        [one] 1 operario
       *[other] { $count } operarios
    }
statistics-study-repeats = { $count ->
        [one] 1 repetición
       *[other] { $count } repeticiones
    }
statistics-study-masters = { $count ->
        [one] 1 patrón
       *[other] { $count } patrones
    }
statistics-study-points = { $count ->
        [one] 1 punto
       *[other] { $count } puntos
    }
statistics-study-readings-between = de { $least } a { $most } lecturas
statistics-study-more-faults = y { $count } más
statistics-study-limits-differ = Los límites del archivo difieren de un valor a otro: indique el límite inferior y el superior, o elija una característica.
statistics-study-features = El archivo tiene varias características: elija la que leyó el instrumento.
statistics-study-save-budget = Guardar como balance…
statistics-study-save-budget-hint = La dispersión que halló el estudio, como tipo A con sus grados de libertad, para la página Incertidumbre
statistics-study-no-budget = Este estudio no da ninguna contribución a un balance
statistics-study-source = { $of ->
        [part] piezas
        [operator] operarios
        [interaction] interacción
        [repeatability] repetibilidad
        [gauge] instrumento
       *[total] total
    }
statistics-study-mean-square = Cuadrado medio, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Varianza, { $source }
statistics-study-figure-reference = Medida calibrada
statistics-study-figure-bias = Sesgo
statistics-study-figure-mean-bias = Sesgo medio
statistics-study-figure-bias-p = p del sesgo
statistics-study-figure-bias-t = t del sesgo
statistics-study-figure-bias-at = Sesgo en { $size } mm ({ $count })
statistics-study-figure-smallest = Tolerancia más pequeña
statistics-study-figure-smallest-good = Tolerancia más pequeña, 10 %
statistics-study-figure-smallest-accepted = Tolerancia más pequeña, 30 %
statistics-study-figure-repeatability = Repetibilidad, s
statistics-study-figure-gauge = Instrumento, s
statistics-study-figure-of-variance = Parte de la varianza
statistics-study-figure-of-readings = Parte de todas las lecturas
statistics-study-figure-of-tolerance = Parte de la tolerancia
statistics-study-figure-categories = Categorías distintas
statistics-study-figure-slope = Pendiente
statistics-study-figure-slope-p = p de la pendiente
statistics-study-figure-intercept = Sesgo en 0
statistics-study-figure-intercept-p = p del sesgo en 0
statistics-study-figure-residual = s en torno a la recta
statistics-study-figure-centre = Línea central
statistics-study-figure-lower-control = Límite de control inferior
statistics-study-figure-upper-control = Límite de control superior
statistics-study-figure-spread-centre = Dispersión media
statistics-study-figure-spread-upper = Límite de control superior de la dispersión
