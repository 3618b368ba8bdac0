# The command line

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = advertencia: { $what }
cli-remark = observación: { $what }

# What an error is about
cli-what-callout = cota
cli-what-measured-value = valor medido
cli-what-hole = agujero
cli-what-shaft = eje
cli-what-measured-hole = agujero medido
cli-what-measured-shaft = eje medido
cli-what-hole-material = material del agujero
cli-what-shaft-material = material del eje
cli-what-temperature = temperatura
cli-what-smallest-clearance = juego mínimo
cli-what-largest-clearance = juego máximo
cli-what-nominal-size = medida nominal { $text }
cli-what-true-diameter = diámetro real
cli-what-simulated-workpiece = pieza de trabajo simulada
cli-what-simulated-measurement = medición simulada
cli-what-perfect-workpiece = pieza de trabajo en medida nominal
cli-what-size = medida
cli-what-cycle = ciclo { $code }
cli-what-log = protocolo
cli-what-entry = entrada { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Errors
cli-batch-simulated = las primeras líneas de { $name } dicen que es simulado, y solo CSV puede conservarlas: escriba CSV
cli-dash = - es la salida estándar, que aquí no es posible: dé un nombre, o ./- para un archivo o una carpeta llamados -
cli-no-subcommand = { $given } no es un subcomando; aquí los hay: { $names }
cli-not-above-zero = { $diameter } mm no es mayor que 0
cli-ratio-of-one-limit = la regla asme-simple compara la incertidumbre con la tolerancia: se esperaban --lower y --upper
cli-already-corrected = --temperature: el archivo dice que sus valores ya están a 20 °C
cli-not-a-multiple = { $given }: se esperaba un número mayor que 0 con tres decimales como máximo
cli-no-limits = indique --lower, --upper o ambos, con el límite inferior por debajo del superior
cli-risk-without-uncertainty = los riesgos de un proceso necesitan --u o --expanded
cli-risk-without-process = --consumer-risk necesita --process-mean y --process-sd, o --gamma
cli-not-a-risk = riesgo { $given }: se esperaba una probabilidad entre 0 y 1, como 0.001
cli-not-a-gamma = distribución gamma { $given }: se esperaba su forma y su escala en µm, como 4,0.25
cli-no-zone-for-risk = ninguna zona de valores aceptados tiene este riesgo del consumidor
cli-line-too-long = la línea tiene más de { $limit } bytes
cli-not-a-table = { $name } no es una tabla de desviaciones
cli-stats-features = varias características: elija una con --feature: { $names }
cli-stats-no-feature = no hay característica { $given }: los archivos tienen { $names }
cli-stats-limits = los límites difieren de un valor a otro: indique --lower y --upper, o elija una característica con --feature
cli-stats-no-point = no hay punto { $point }: el gráfico tiene { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (si es correcto: --confirm-layout)
cli-stats-no-budget = este estudio no da ninguna contribución a un balance
cli-stats-no-picture = no se puede dibujar ninguna imagen: { $why }
cli-stats-points = --stage y --leave-out son para una característica: elíjala con --feature en lugar de --all
cli-stats-parameters = --parameters es para --chart ewma o cusum
cli-add-feature = { $error }: añada --feature hole o --feature shaft
cli-add-wide-zone = { $asked }: { $error }; si esta zona es intencionada, añada --wide-zone
cli-add-far-temperature = { $what }: { $error }; si esta temperatura es intencionada, añada --far-temperature
cli-remark-open = { $count ->
    [one] un valor está fuera de límites; que sea retrabajo o desecho depende de si es agujero o eje: añada --feature hole o --feature shaft, una columna kind con estas palabras, o un plan
   *[other] { $count } valores están fuera de límites; que sean retrabajo o desecho depende de si son agujeros o ejes: añada --feature hole o --feature shaft, una columna kind con estas palabras, o un plan
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked }: { $um } µm por encima del máximo; que sea retrabajo o desecho depende de si es agujero o eje: añada --feature hole o --feature shaft
   *[below] { $asked }: { $um } µm por debajo del mínimo; que sea retrabajo o desecho depende de si es agujero o eje: añada --feature hole o --feature shaft
}
cli-parts-of-several = las piezas medidas son de un solo ajuste: dé una sola cota
cli-search-with-parts = una búsqueda no admite piezas medidas, materiales ni temperaturas
cli-search-without-size = una búsqueda necesita una medida nominal, como 25
cli-search-without-clearance = una búsqueda necesita --min-clearance y --max-clearance
cli-table-ending = { $path }: el nombre de una tabla del control termina en .tab
cli-format-ending = { $path }: un archivo de formato { $format } termina en .{ $endings }
cli-several-tables = una tabla del control es un solo archivo: indique una tabla, o clases de agujero o de eje
cli-report-format = --format { $format } no concuerda con la terminación de { $file }: omita uno de los dos
cli-stopped = detenido con Ctrl+C después de { $rows } filas
cli-report-empty = ninguna comprobación era utilizable, así que no se escribió ningún informe
cli-inputs-too-large = las entradas de un ciclo tienen como máximo { $most } KiB
cli-not-an-object = las entradas deben ser un objeto JSON como {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: se esperaba un número o un texto
cli-given-twice = { $name } se da dos veces
cli-option-of-standard = --{ $option } no tiene efecto con --source control: las tablas del control tienen una sola edición de ISO 286
cli-set-twice = { $name } se fija dos veces
cli-several-blocks = varios ciclos de medición, en las líneas { $blocks }: elija uno con --at LÍNEA
cli-other-cycle = es el ciclo { $given }, no { $wanted }
cli-not-predef = no se admite PREDEF para el parámetro { $name }
cli-no-probe = la tabla de palpación no tiene el palpador { $number }
cli-not-a-pair = { $text }: escriba un parámetro como NAME=VALUE
cli-not-a-position = posición { $text }: se esperaban tres números X,Y,Z en mm
cli-not-a-number = no es un número
cli-no-folder = no existe la carpeta: { $path }
cli-watched-already = otro programa vigila { $path } para este registro
cli-no-program = { $error }; los programas integrados son { $names }
cli-option-beside-plan = --{ $option } es para una sola cota: un plan tiene una columna para ello
cli-option-missing = falta --{ $option }: una sola cota necesita --x, --y y --z
cli-batch-ending = { $path }: la salida debe terminar en .{ $endings }, seguido de .gz o .zst para comprimirla
cli-batch-onto-itself = { $path } es una de las entradas: escriba los resultados en otro archivo
cli-batch-columns = { $name } tiene columnas distintas del primer archivo, que tiene { $columns }
cli-batch-separator = { $name } tiene un separador distinto del primer archivo: escriba .jsonl, o evalúe este archivo aparte
cli-batch-types = la columna { $column } de { $name } tiene otro tipo en el primer archivo: escriba .csv, o evalúe este archivo aparte
cli-batch-packed = { $path }: Parquet ya está comprimido: omita .gz o .zst
cli-batch-twice = { $name } tiene dos columnas llamadas { $column }: escriba .csv, que admite ambas
cli-batch-input = { $name }: { $error }
cli-batch-name = { $name } ya tiene una columna { $column }: use --prefix para anteponer una palabra a los nombres de las columnas añadidas
cli-use-force = { $error }; --force sobrescribe

# A --check of a report
cli-check-no-measured = { $text } no tiene valor medido: escriba una cota, = y milímetros, como 25 H7=25.012
cli-check-measured = valor medido: { $value }
cli-check-not-positive = el valor medido { $measured } mm no es mayor que 0

# Remarks
cli-remark-wrote = escrito { $path }
cli-remark-wrote-files = escrito { $path } (archivos: { $count })
cli-remark-simulated = simulado: no se midió nada
cli-remark-perfect-workpiece = simulado: cada ciclo midió una pieza de trabajo perfecta en medida nominal; para otra, use --workpiece FILE.toml
cli-remark-corrected = medido { $measured } mm a { $temperature } °C: { $change } µm, por tanto { $at-reference } mm a 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = cada valor medido se corrige de { $temperature } °C a 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = escalas a { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = la corrección lineal difiere de la exacta en { $off } µm
cli-remark-rule = regla: { $rule }
cli-remark-rule-by-budget = regla: { $rule }
cli-remark-budget = incertidumbre según el balance { $name }, creado el { $date }, válido hasta el { $until }
cli-remark-budget-contacts = dispersión de { $touches } puntos de palpación{ $step }, factor geométrico { $factor }
cli-remark-accepted = aceptado: de { $least } a { $most } mm
cli-remark-nothing-accepted = no se acepta ningún valor: la regla no deja nada de esta tolerancia
cli-remark-proven = demostrado según esta regla
cli-remark-not-proven = no demostrado según esta regla
cli-remark-conformity = conforme con una probabilidad del { $percent } %
cli-remark-remove = quitar { $limit } mm hasta el límite más próximo, { $middle } mm hasta el centro de la zona
cli-remark-refused = { $refused } de { $asked } cotas no admitidas
cli-remark-no-pair = ningún par cumple; el más próximo es { $nearest }
cli-remark-trace-ends = el rastro termina aquí, después de { $blocks } frases
cli-remark-batch-utf16 = { $name } es UTF-16 y se escribe como UTF-8
cli-remark-batch-floats = { $name } tiene números de coma flotante en { $columns }: cada uno se evalúa como el decimal más corto que lo representa
cli-remark-tools-not-written = la tabla de herramientas no se escribe: --tools-out FILE.t la escribe con estos cambios
cli-remark-clearance-height = la altura de seguridad es { $height } mm: --clearance-height la cambia
cli-remark-more-entries = solo se muestran { $limit } entradas: para ver más, use --limit N
cli-remark-backed-up = copiado hasta la entrada { $number } en { $path } (hash { $hash })
cli-remark-no-head-known = ninguna entrada de este registro se conoce en otro lugar: no se notaría si faltan las más recientes

# Warnings
cli-warning-stopped-unrecorded = no se registró nada: las filas se registran juntas, cuando se han leído todas
cli-warning-column-not-used = la columna { $column } se omite
cli-warning-expansion-unconfirmed = la dilatación de { $expansion } · 10⁻⁶/K es un valor usual que aquí ningún documento confirma
cli-warning-file-twice = este archivo se nombra dos veces: sus filas se cuentan dos veces
cli-warning-position-unused = --position no tiene efecto: el ciclo { $code } no empieza en la posición de la bola
cli-warning-predef-unused = --predef no tiene efecto en { $name }: no está en PREDEF
cli-warning-log-option = --{ $option } no tiene efecto: no se escribe ni se muestra ningún protocolo
cli-warning-more-figures = más valores así que no se muestran: { $count }
cli-warning-tables-not-used = --tables, --source y las opciones de la norma no se usan: sin --fit no se buscan límites
cli-warning-empty-cell = { $class } más de { $over } hasta { $to } mm queda vacío: ISO 286 no tiene un valor único para todo el intervalo
cli-warning-budget-option = --{ $option } no tiene efecto: el balance no depende de ello
cli-warning-contacts-left = el ciclo usó { $used } de { $count } puntos de palpación
cli-warning-not-in-csv = CSV no tiene lugar para { $options }: HTML, JSON y PDF sí
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } nota no está en el CSV: HTML y JSON la contienen
   *[other] { $count } notas no están en el CSV: HTML y JSON las contienen
}
cli-warning-no-tool-monitored = la tabla de herramientas no se usa: Q330 no indica ninguna herramienta
cli-warning-log-unknown = no se escribe ningún protocolo: el del ciclo { $code } es desconocido
cli-warning-limits-alone = aquí deciden solo los límites: la regla de decisión y la temperatura valen solo para diámetros
cli-warning-log-off = no se escribe ningún protocolo: Q281 = 0
cli-warning-log-none = no se escribe ningún protocolo: el ciclo no tiene
cli-warning-log-on-screen = no se escribe ningún protocolo: Q281 = 2 lo muestra en pantalla

# Tables against ISO 286
cli-verify-off = { $place }: { $class } más de { $over } hasta { $to } mm: { $table }, ISO 286 tiene { $standard }: { $by }
cli-verify-missing = { $place }: { $class } más de { $over } hasta { $to } mm: sin valor, ISO 286 tiene { $standard }
cli-verify-undefined = { $place }: { $class } más de { $over } hasta { $to } mm: { $table }, pero { $reason }
cli-verify-neither = { $place }: { $class } más de { $over } hasta { $to } mm: { $reason }
cli-verify-by = { $side ->
        [upper] superior
       *[lower] inferior
    } { $um } µm { $way ->
        [more] más
       *[less] menos
    }
cli-verify-table = { $name }: { $classes ->
        [one] { $classes } clase
       *[other] { $classes } clases
    }, { $ranges ->
        [one] { $ranges } intervalo de medidas
       *[other] { $ranges } intervalos de medidas
    }, { $cells ->
        [one] { $cells } celda comparada
       *[other] { $cells } celdas comparadas
    }: { $differ ->
        [0] todo coincide con ISO 286
        [one] { $differ } difiere de ISO 286
       *[other] { $differ } difieren de ISO 286
    }
cli-verify-nothing = { $name }: { $classes ->
        [one] { $classes } clase
       *[other] { $classes } clases
    }, { $ranges ->
        [one] { $ranges } intervalo de medidas
       *[other] { $ranges } intervalos de medidas
    }, { $cells } celdas comparadas: nada que comparar con ISO 286
cli-verify-own = { $table }; sin comparar, no son clases de ISO 286: { $own }

## Start
start-missing = no existe el archivo: { $path }; indique un archivo existente para abrirlo en la ventana, o un subcomando
start-folder = es una carpeta, no un archivo: { $path }; en la ventana solo se abren archivos

## What was recorded
cli-recorded-entry = registrado como entrada { $number } de { $file } (hash { $hash })
cli-recorded-entries = registrado como entradas { $first } a { $last } de { $file } (hash de la última { $hash })
cli-recorded-nothing = no se evaluó nada, así que no se registró nada
cli-recorded-without = { $rows ->
    [one] 1 fila no está registrada
   *[other] { $rows } filas no están registradas
}: { $places }
cli-not-recorded = no se registró nada: { $error }
cli-journal-is-server = esto necesita el archivo de registro de un puesto: un servidor solo recibe lo que los puestos han registrado
cli-no-shop = este programa se compiló sin soporte para un servidor del taller: indique un archivo como registro
cli-recorded-not-sent = aún no enviado al servidor: { $error }; las entradas se conservan aquí, y fitcheck journal send las envía
cli-no-journal-folder = este sistema no tiene carpeta para sus datos: indique un registro con --journal FILE
cli-no-entry = no hay ninguna entrada { $number } en { $path }: la última es { $last }
cli-no-check = la entrada { $number } no es una comprobación
cli-no-hash = ninguna entrada de { $path } tiene un hash que empiece por { $prefix }
cli-several-hashes = los hash de varias entradas empiezan por { $prefix }: { $numbers }. Indique más cifras o el número
cli-record-needs-file = --record nombra el archivo que se escribió, y la salida estándar no lo es: indique -o FILE
cli-report-not-known = { $file } está escrito, pero el registro no lo conoce: { $error }
cli-already-corrected-by = la entrada { $number } ya fue corregida o retirada por la entrada { $by }: corrija esta, salvo que sea una retirada
cli-not-typed = el valor de la entrada { $number } no fue escrito: remida, o retire la comprobación
cli-nothing-corrected = una corrección debe cambiar algo: indique --measured, --who, --part, --serial, --feature-name, --remark o --withdraw
cli-remark-sent = { $entries ->
    [0] no hubo que enviar nada
    [one] 1 entrada enviada
   *[other] { $entries } entradas enviadas
} a { $server }, que tiene este registro hasta la entrada { $number }
cli-remark-nothing-found = ninguna comprobación cumple { $question }
cli-remark-unread = { $entries ->
    [one] 1 entrada omitida
   *[other] { $entries } entradas omitidas
}: esta versión no { $entries ->
    [one] la puede leer
   *[other] las puede leer
}
cli-head-without-chain = un servidor tiene varias cadenas: indique --head CHAIN:NUMBER:HASH
cli-head-of-other = este registro es la cadena { $chain }, pero --head nombra { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } elemento
   *[other] { $count } elementos
}
cli-remark-plan-example = no se dio ninguna cota: el plan tiene un elemento de muestra
cli-remark-plan-to-fill = el plan está escrito hasta donde se conoce; errores por corregir en él: { $count }
cli-remark-no-columns = el archivo se lee según su propio formato y no tiene columnas que elegir
cli-remark-plan-head-left = CSV contiene solo los elementos: { $keys } de la pieza no se escribe
cli-warning-neither-stands = la entrada { $number } corregía la entrada { $target }: ahora ninguna de las dos cuenta. Si uno de los valores es correcto, regístrelo de nuevo
cli-warning-beyond-limits = fuera de los límites: aceptado por la regla, pues no está demostrado que esté fuera
cli-warning-plan-missing = sin medir: { $names }
cli-warning-plan-missing-of = { $who }: sin medir: { $names }
cli-warning-contradiction = { $name } tiene valores que se contradicen: { $values }
cli-warning-contradiction-of = { $who }: { $name } tiene valores que se contradicen: { $values }
cli-warning-worst-counts = el peor de varios valores contradictorios cuenta hasta que se elija: --repeats last o --repeats worst. Los números de serie distinguen las piezas, y una hora en cada valor muestra cuál es el último
cli-warning-plan-more-parts = más de { $most } piezas: no se indican los elementos que faltan de las demás
cli-warning-plan-no-value = falta: no se encontró ningún valor
cli-warning-plan-no-value-of = falta en { $who }: no se encontró ningún valor
cli-remark-watching = se vigila { $folder }; archivos importados antes: { $known }
cli-warning-see-note = no se pudo usar todo: el archivo que está al lado y termina en { $note } da los motivos
cli-not-seconds = { $given } no es un tiempo en segundos
cli-warning-same-content = el mismo contenido se importó antes como { $known }: no se vuelve a registrar nada
cli-warning-not-alone = no se sabe si otro programa vigila esta carpeta para el mismo registro: { $reason }

## The time zone of this computer
zone-not-understood = TZ está en "{ $given }", que no es una zona horaria: póngala en un nombre como Europe/Amsterdam o en UTC, o quítela
zone-unknown = no se conoce la zona horaria de este ordenador, así que las horas están en UTC: ponga TZ en un nombre como Europe/Amsterdam

# El doctor
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, son las { $time }
doctor-clock = no anterior a la última entrada del registro
doctor-clock-behind = anterior a la última entrada de { $path }, escrita a las { $newest }: ajuste el reloj de este equipo
doctor-folder = { $path }: se pueden escribir archivos
doctor-journal = { $path }: entradas { $entries }
doctor-no-journal = { $path } aún no existe: lo crea la primera comprobación registrada
doctor-server = { $address } responde
doctor-no-server = ningún servidor configurado: indíquelo con --journal postgres://…, o en la ventana en Configuración
doctor-gauges = puertos de este equipo: { $ports }
doctor-no-port = este equipo no tiene puerto serie: conecte el instrumento o su cable
doctor-gauge-gone = { $gauge }: falta el puerto { $port }: conecte el instrumento o elija otro puerto en la ventana en Configuración
doctor-no-gauges = este programa se construyó sin los puertos de instrumentos: los paquetes los tienen
doctor-ports-not-listed = no se pueden enumerar los puertos de este equipo: { $reason }
doctor-tables = { $path }: tablas { $count }
doctor-no-tables = sin tablas propias: ISO 286 y las tablas del control están integradas
doctor-settings = lo que guarda la ventana se puede leer
doctor-window = dibujada con { $renderer }
doctor-no-window = este programa se construyó sin la ventana
