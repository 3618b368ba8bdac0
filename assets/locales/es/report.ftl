# report

## Errors
report-error-writer = el informe { $format } no se pudo crear: { $reason }
report-error-label-alone = { $format } es para etiquetas: elija la plantilla label, o el papel small-label o large-label
report-error-no-statistics = { $format } no tiene lugar para estadísticas: elija PDF, HTML o Markdown
report-attachment-too-large = los datos del archivo superan { $most } bytes
report-attachment-packed = los datos del archivo están comprimidos con { $filter }, que Fitcheck no lee
report-attachment-damaged = los datos del archivo están dañados: { $reason }
report-attachment-several = el archivo tiene { $count } adjuntos con comprobaciones: se espera uno
report-difference-field = entrada { $number }: { $field } es { $said } en el archivo, { $kept } en el registro
report-difference-missing = entrada { $number }: ninguna comprobación del archivo dice lo que dice el registro
report-difference-more = { $count ->
    [one] el archivo tiene 1 comprobación de más
   *[other] el archivo tiene { $count } comprobaciones de más
}
report-difference-fewer = { $count ->
    [one] falta 1 comprobación en el archivo
   *[other] faltan { $count } comprobaciones en el archivo
}
report-data-json = los datos del archivo no son un informe de Fitcheck: { $reason }
report-ending-missing = { $file } no tiene terminación que indique el formato del informe: use una de { $endings }
report-ending-unknown = .{ $ending } no es un formato del informe: use uno de { $endings }

## Sentences about one check
report-feature-hole = agujero
report-feature-shaft = eje
report-feature-neither = ni agujero ni eje
report-side-good = bueno
report-side-rework = retrabajo
report-side-scrap = desecho
report-side-out = fuera de límites
report-side-too-small = demasiado pequeño
report-side-too-large = demasiado grande
report-source-instead = { $source }; ISO 286 dice aquí { $upper } y { $lower } µm
report-too-small = { $um } µm demasiado pequeño
report-too-large = { $um } µm demasiado grande
report-inside = dentro de los límites
report-above-minimum = { $um } µm sobre el mínimo
report-below-minimum = { $um } µm bajo el mínimo
report-below-maximum = { $um } µm bajo el máximo
report-above-maximum = { $um } µm sobre el máximo
report-position-unknown = no medida
report-position-unmonitored = no supervisada
report-position-in = DENTRO
report-position-out = FUERA
report-axis-unmonitored = { $axis } { $deviation } mm: no supervisado
report-axis-in = { $axis } { $deviation } mm, admisible ± { $tolerance } mm: DENTRO
report-axis-out = { $axis } { $deviation } mm, admisible ± { $tolerance } mm: FUERA
report-cause-position = el centro está fuera de posición; la medida sola: { $status }
report-origin-circle = { $origin }; círculo de mínimos cuadrados por { $contacts } puntos de palpación
report-centre = centro medido X { $x } mm, Y { $y } mm
report-band-nominal = medida nominal { $size } mm
report-band-title = Banda de límites, medido { $value }: { $distances }
report-in-guard-band = no hay nada decidido: el valor está en una banda de guarda de la regla de decisión
report-corrected = medido { $measured } mm a { $temperature } °C, dilatación { $expansion } · 10⁻⁶/K: corregido en { $change } µm a { $reference } mm a 20 °C
report-all-corrected = medido a { $temperature } °C, dilatación { $expansion } · 10⁻⁶/K; cada valor se corrige a 20 °C
report-scales = escalas a { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = sin corrección de las escalas
report-own-uncertainty = u de cada valor junto a su comprobación
report-accepted-zone = de { $least } a { $most } mm
report-accepted-none = ninguno: la regla no deja nada de esta tolerancia
report-proven = demostrado según esta regla
report-not-proven = no demostrado según esta regla
report-conformity = conforme con una probabilidad del { $percent } %
report-budget-made = { $name }, creado el { $date } por { $by }, válido hasta el { $until }
report-budget-expired = CADUCADO el día de la comprobación
report-budget-not-yet = AÚN NO VÁLIDO el día de la comprobación
report-guard-undecided = banda de guarda: remedir
report-guard-beyond = banda de guarda: aceptado más allá del límite
report-guard-range = { $what }, de { $from } a { $to } µm

## The page
report-title = Informe de inspección
report-part = Pieza
report-order = Orden
report-inspector = Inspector
report-program = Programa
report-notes = Filas omitidas y advertencias
report-no-checks = Este informe no tiene comprobaciones.
report-page-all-good = Ninguna de las { $total } comprobaciones se muestra en esta página: todas son buenas y ninguna es dudosa. Un informe CSV o JSON contiene todas.
report-page-not-good = Esta página muestra solo las { $listed } de { $total } comprobaciones que no son buenas o son dudosas. Los recuentos incluyen todas; un informe CSV o JSON las contiene todas.
report-page-first = Esta página muestra solo las primeras { $listed } de { $wanted } comprobaciones que no son buenas o son dudosas, de { $total } en total. Los recuentos incluyen todas; un informe CSV o JSON las contiene todas.
report-total = Total
report-check = Comprobación
report-id = Nombre
report-callout = Cota
report-heading-without-callout = { $nominal } mm, límites sin clase
report-verdict = Dictamen
report-nominal = Medida nominal
report-maximum = Máximo
report-minimum = Mínimo
report-measured = Medido
report-deviation = Desviación
report-remove = Por quitar
report-on-diameter = en diámetro
report-per-side = por lado
report-remove-to-limit = hasta el límite más próximo
report-remove-to-middle = hasta el centro de la zona
report-remove-to-accepted = hasta los valores aceptados
report-position = Posición
report-limits-from = Límites según
report-measured-from = Valor medido
report-from = Origen
report-limits = Límites
report-missing = Pendientes
report-skipped = Omitidos
report-verdict-from = Regla de decisión
report-temperature = Temperatura
report-accepted = Valores aceptados
report-proof = Demostración
report-budget = Balance de incertidumbre
report-cannot-tell = Limitaciones de esta medición
report-contacts = Puntos de palpación
report-contacts-at-end = al final del informe
report-contact = N.º
report-radial = desviación radial
report-sign-name = Nombre
report-sign-date = Fecha
report-sign-signature = Firma
report-footer = Cada dictamen se basa en valores sin redondear y en los límites y la regla de decisión indicados a su lado.

## Notes
report-note = { $place }: { $what }
report-note-line = { $place }, línea { $line }: { $what }
report-note-more = { $count ->
    [one] 1 nota más no se muestra
   *[other] { $count } notas más no se muestran
}

## A whole part
report-balloon = Globo
report-picture-room = { $name } no se muestra aquí: las imágenes de todas las piezas harían la página demasiado grande
report-picture-beside = { $count ->
    [one] un elemento no tiene globo en ella
   *[other] { $count } elementos no tienen globo en ella
}
report-part-older = { $count ->
    [one] Un valor más no se muestra: de cada cota se muestra solo el valor que cuenta
   *[other] { $count } valores más no se muestran: de cada cota se muestra solo el valor que cuenta
}
report-more-parts = { $count ->
    [one] Una pieza más no se muestra completa; sus valores están en la lista
   *[other] { $count } piezas más no se muestran completas, solo las primeras { $most }; sus valores están en la lista
}

## Plantillas de informes
report-template-toml = { $reason }
report-template-version = no se admite la versión { $found } de la plantilla: se espera la versión { $known }
report-template-too-large = una plantilla tiene como máximo { $most } bytes
report-template-text = { $key } está vacío, supera los { $longest } caracteres o contiene un carácter de control
report-template-twice = { $key } contiene { $word } dos veces
report-template-empty = { $key } está vacío: hace falta al menos una entrada
report-template-language = { $given } no es un idioma de informes: use uno de { $known }
report-template-logo = el logotipo { $given } debe ser el nombre de un archivo junto a la plantilla
report-section-verdict = Dictamen
report-section-head = Cabecera
report-section-picture = Imagen con globos
report-section-lot = Piezas, la peor primero
report-section-statistics = Estadística de los elementos
report-statistics-limits = Los límites difieren de un valor a otro: no se indica ninguna capacidad.
report-statistics-most = La estadística solo contiene los primeros { $count } valores.
report-section-features = Valores
report-section-statement = Declaración de conformidad
report-section-rule = Regla y límites en palabras
report-section-caveats = Limitaciones de la medición
report-section-remarks = Observaciones
report-section-signature = Línea de firma
report-section-code = Código del registro
report-revision = Revisión
report-serial = Número de serie
report-batch = Lote
report-customer = Cliente
report-material = Material
report-station = Puesto
report-instrument = Instrumento
report-calibrated = Calibrado
report-date = Fecha
report-plan = Plan
report-records = Registros
report-blank = Valor
report-remark = Observación
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Etiqueta 62 × 29 mm
report-paper-large-label = Etiqueta 100 × 50 mm
report-template-inspection = Informe de inspección
report-template-inspection-purpose = Piezas o comprobaciones, con imágenes
report-template-first-article = Primera pieza
report-template-first-article-purpose = Cada elemento, también lo que falta
report-template-certificate = Certificado
report-template-certificate-purpose = Valores y declaración de conformidad
report-template-list = Lista de comprobaciones
report-template-list-purpose = Todas las comprobaciones, una tras otra
report-template-statistics = Estadística
report-template-statistics-purpose = Cada elemento con todos sus valores, con gráficos
report-template-sheet = Hoja de medición
report-template-sheet-purpose = Vacía, para rellenar a mano
report-template-label = Etiqueta
report-template-label-purpose = Dictamen, pieza y número de serie
## Páginas para imprimir
report-pdf-page = Página { $page } de { $pages }
report-pdf-band = Banda de límites
report-pdf-remove = { $name }: quitar { $um } µm en diámetro
report-pdf-simulated = Valores simulados, que nadie midió: { $count } de { $total }
report-pdf-beyond = Valores que la regla de decisión acepta fuera de los límites: { $count } de { $total }
report-pdf-corrected = Valores corregidos a 20 °C: { $count } de { $total }
report-pdf-guarded = Valores con una regla de decisión propia: { $count } de { $total }
report-pdf-doubted = Valores dudosos, marcados con un signo de interrogación: { $count } de { $total }
report-pdf-notes = Filas omitidas y advertencias, listadas al final: { $count }
report-pdf-more-lacks = Más en las páginas de las piezas: { $count }
report-pdf-more = Más en los datos adjuntos: { $count }
report-pdf-all-checks = Todas las comprobaciones
report-pdf-attached = Adjunto a este archivo, para programas: { $names }
report-pdf-not-attached = No están adjuntos todos los datos: un archivo de más de { $most } MB sería demasiado grande
report-pdf-contacts = Los puntos de palpación están en los datos adjuntos.
report-pdf-cut = Un texto que termina en … está cortado aquí; en los datos adjuntos está entero.
report-pdf-substituted = Un □ representa un carácter que falta en las fuentes de estas páginas, como los que se escriben de derecha a izquierda; el texto copiado y los datos adjuntos contienen el carácter.
report-statement-conforms = { $count ->
    [one] Declaración de conformidad: el valor está dentro de sus límites según la regla de decisión indicada.
   *[other] Declaración de conformidad: los { $count } valores están dentro de sus límites según la regla de decisión indicada.
}
report-statement-not = { $count ->
    [one] Sin conformidad: el valor no es conforme según la regla de decisión indicada.
   *[other] Sin conformidad: { $bad } de { $count } valores no son conformes según la regla de decisión indicada.
}
report-statement-partial = Sin declaración de conformidad: algunas filas se rechazaron, no se evaluaron o no se leyeron. El informe las indica.
report-statement-simulated = { $count ->
    [one] Sin declaración de conformidad: un valor es simulado y nadie lo ha medido.
   *[other] Sin declaración de conformidad: { $count } valores son simulados y nadie los ha medido.
}
report-statement-open = Sin declaración de conformidad: faltan valores, { $count } en total.
report-code-said = Código del registro { $number }, su hash { $hash }
report-lot-order = La peor pieza va primero.
## Un libro
report-sheets = Solo las primeras { $listed } de { $total } piezas tienen una hoja propia; la hoja de las piezas las contiene todas.
report-sheets-corrected = corregido a 20 °C
report-sheets-without = Las imágenes y los puntos de palpación no están en este libro: un informe HTML contiene ambos, un informe JSON los puntos de palpación.
report-sheets-cut = { $count ->
    [one] Un texto está abreviado: una celda contiene como máximo 32767 caracteres.
   *[other] { $count } textos están abreviados: una celda contiene como máximo 32767 caracteres.
}
report-journal = Entradas { $numbers } del registro { $chain }; su última entrada entonces: { $number }:{ $hash }
report-template-new-about = Una plantilla de informes. Borre lo que un informe no deba mostrar; quite el # de lo que deba mostrar.
report-template-new-name = Plantilla nueva
report-changed-since = Cambios desde el informe del { $since }:
report-changed-none = ningún resultado y ningún límite
report-changed-result = { $name }: { $before } → { $now }
report-changed-limits = { $name }: límites de { $low } a { $high } → de { $lower } a { $higher } mm
report-changed-added = { $name }: nuevo
report-changed-removed = { $name }: ya no está en el informe
report-changed-several = { $name }: no comparado, porque hay varios valores
report-since-no-report = no es un informe de Fitcheck con sus datos: indique su PDF o su JSON
