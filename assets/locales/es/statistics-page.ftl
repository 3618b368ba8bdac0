page-statistics = Estadística

# Lo que se pide
statistics-page-question = Registros
statistics-page-question-hint = Los registros cuyos valores se usan, en el lenguaje de la página Registro, por ejemplo part:"Brida 40" station:"Fresadora 3" from:2026-11-01. Vacío: todos los registros.
statistics-page-last = Valores más recientes
statistics-page-size = Valores por punto
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
statistics-page-take-in = Volver a incluir
statistics-page-reason = Motivo
statistics-page-take-reason = Excluir
statistics-page-cancel-reason = Cancelar
statistics-page-copy = Copiar las cifras
statistics-page-copy-hint = Cifras, señales y consejos como tabla para una hoja de cálculo
statistics-page-report = Informe…
statistics-page-report-hint = Las cifras y los gráficos de todas las características como informe para firmar

# Señales
statistics-page-signals = Señales
statistics-page-no-signals = No salta ninguna regla.
statistics-page-rules = Reglas
statistics-page-on-spread = Dispersión: { $rule }
statistics-page-alarms = Alarmas abiertas: { $count }
statistics-page-at = Punto { $point }
statistics-page-from-to = Puntos { $first } a { $last }
statistics-page-left-out-because = Excluido: { $reason }
statistics-page-advice = Consejos
