# exchange

# Measurements from files
exchange-format-logs = protocolos de medición HEIDENHAIN como TCHPR421.TXT
exchange-format-log-444 = protocolos de palpación en 3D como los escribe Fitcheck
exchange-format-fn16 = salida FN 16 de un control, leída con su máscara (--mask)
exchange-format-series-table = tabla de un control que un programa rellena con FN 27, una fila por pieza
exchange-format-contacts = puntos de palpación de un círculo: x, y y opcionalmente z
exchange-format-measurements = mediciones como CSV: id, callout, measured
exchange-empty = el archivo está vacío
exchange-not-recognised = no es un archivo de un formato conocido
exchange-model-not-read = un modelo { $format }: Fitcheck no lee modelos; exporte los valores medidos como CSV, XLSX, QIF o AQDEF
exchange-drawing-not-read = un dibujo { $format }: Fitcheck no lee dibujos; exporte las cotas como CSV o XLSX
exchange-document-not-read = un documento { $format }: Fitcheck no lee documentos; exporte los valores como CSV, XLSX, QIF o AQDEF
exchange-image-not-read = una imagen { $format }: Fitcheck no lee imágenes; exporte los valores como CSV, XLSX, QIF o AQDEF
exchange-archive-not-read = un archivo comprimido { $format }: descomprímalo e indique los archivos que contiene
exchange-no-sheet = el libro no tiene la hoja { $given }; tiene { $sheets }
exchange-other-format = esto es otra cosa: { $format }, no mediciones como CSV
exchange-parquet-unknown = este programa se compiló sin Parquet: cargo build --release sin más opciones lo incluye
exchange-parquet-stream = Parquet enumera sus columnas al final del archivo y no se puede leer de una canalización: indique el nombre del archivo
exchange-parquet = este archivo Parquet no se puede leer: { $reason }
exchange-parquet-nested = la columna { $column } contiene columnas o listas: solo se pueden evaluar columnas de valores simples
exchange-mask-backwards = { $mask }: { $reason }
exchange-mask-none = ninguna de las máscaras indicadas imprime un archivo así: { $masks }
exchange-mask-several = varias máscaras imprimen un archivo así; indique solo la que lo escribió: { $masks }
exchange-mask-no-measured = { $mask } no imprime ningún valor medido: Fitcheck reconoce de Q153 a Q156, Q160, y cualquier otro número con su cota impresa al lado
exchange-mask-measured = { $mask }: cualquiera de estos podría ser el valor medido: { $fields }; imprima el resultado del ciclo, como Q153; si no, el archivo necesita cotas con límites distintos
exchange-print-ambiguous = la máscara puede leer esto de varias formas
exchange-print-broken = la salida termina demasiado pronto: se esperaba la salida de la línea { $line } de la máscara
exchange-print-other = la máscara no imprime una línea así, pero contiene números: puede ser una salida con un valor que falta o que ha cambiado; corríjala o elimínela
exchange-print-unit = la línea { $line } indica { $unit }, pero la salida de un control se lee en mm: imprima los valores en mm
exchange-table-no-part = ninguna columna indica a qué pieza corresponde una fila: la tabla de una serie necesita una columna como PART o SERIAL
exchange-table-no-values = ninguna columna contiene valores medidos
exchange-table-no-value = no está claro qué columna de { $name } es el valor medido
exchange-table-touches = la celda de la columna { $column } toca a su vecina y una de las dos puede estar mal separada: sepárelas con un espacio
exchange-table-unit = la tabla está en pulgadas y la columna { $column } no es del tipo LENGTH, así que sus valores podrían estar en mm: use el tipo LENGTH
exchange-no-rows = ninguna fila contiene una medición
exchange-no-measured-column = ninguna columna de valores medidos: nómbrela en la primera línea, como id;callout;measured
exchange-several-columns = cada una de las columnas { $columns } puede ser { $role }: elija una con import --columns, como { $word }=3, o nombre las columnas en la primera línea de modo que solo una sirva, como id;callout;measured
exchange-role-id = el nombre
exchange-role-tolerance = la cota
exchange-role-nominal = la medida nominal
exchange-role-measured = el valor medido
exchange-role-time = la hora
exchange-role-simulated = la marca de simulado
exchange-role-number = el número
exchange-role-part = la pieza
exchange-role-serial = el número de serie
exchange-role-who = el operador
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = lo que se midió
exchange-role-upper = la desviación superior
exchange-role-lower = la desviación inferior
exchange-role-minus = la desviación inferior sin su signo menos
exchange-role-maximum = el límite superior
exchange-role-minimum = el límite inferior
exchange-role-kind = agujero o eje
exchange-role-units = la unidad
exchange-role-status = el estado
exchange-role-machine = la máquina
exchange-role-batch = el lote
exchange-role-sample = una muestra
exchange-no-column = { $role } debería estar en la columna { $given }, pero el archivo tiene { $columns }
exchange-column-twice = la columna { $column } no puede ser a la vez { $first } y { $second }
exchange-unit = unidad desconocida { $unit }: use mm, µm o inch
exchange-limit = límite: { $reason }
exchange-tolerance-unsigned = la tolerancia { $given } no tiene signo: escriba ±{ $given }, o ambas desviaciones, como +0.02 0
exchange-minus-again = la desviación inferior { $given } tiene signo menos, pero las otras no: escríbalas todas con su signo
exchange-limits-contradict = { $callout } tiene los límites { $minimum } a { $maximum }, pero las columnas dicen { $given }: para juzgar por la cota, indique --columns { $columns }; por las columnas, --columns callout=-
exchange-limits-or-deviations = las columnas { $columns } pueden ser límites o desviaciones de la medida nominal: elija con --columns, como maximum={ $upper },minimum={ $lower } o upper={ $upper },lower={ $lower }
exchange-limits-or-readings = las columnas { $columns } pueden ser límites, o la mayor y la menor de varias lecturas: elija con --columns, como maximum={ $upper },minimum={ $lower } para límites o maximum=-,minimum=- para lecturas
exchange-minus-or-plus = las desviaciones inferiores de la columna { $columns } no tienen signo: elija con --columns, minus={ $lower } para debajo de la medida nominal o lower={ $lower } para encima
exchange-samples-side-by-side = varios valores medidos están uno junto a otro en las columnas { $columns }: léalos con fitcheck import, o elija uno con --columns, como measured={ $first }
exchange-unit-stated = la línea { $line } indica la unidad { $unit }, que no se admite («{ $text }»): use mm, µm o inch, o elija la unidad de medida (--columns unit=mm)
exchange-unit-mentioned = la línea { $line } menciona { $unit } («{ $text }»), pero nada dice si los valores están en esa unidad: elija la unidad de medida (--columns unit=mm, um o inch)
exchange-units-differ = «{ $at }» dice { $unit }, «{ $other-at }» dice { $other }: corrija uno de los dos
exchange-unit-late = la línea { $line } indica { $unit } («{ $text }»), pero las filas anteriores se leen en { $read }: indique la unidad antes de la primera fila, o corrija esa línea
exchange-unit-stray = esta línea indica { $unit } («{ $text }»), pero todas las demás filas se leen en { $read }: indique la unidad antes de la primera fila, o corrija esta línea
exchange-unit-given = la unidad elegida es { $given }, pero el archivo dice { $unit } («{ $text }»): elija { $unit }, o corrija el archivo
exchange-unit-half = la columna { $column } está en pulgadas, y la columna { $open } no dice su unidad: escríbala junto a ambos nombres, o elija la unidad de medida (--columns unit=inch)
exchange-unit-missing = falta la unidad de esta fila: escriba mm, µm o inch, o elija la unidad de medida (--columns unit=mm)
exchange-callout-unit = { $given }: la fila está en pulgadas, y una cota con medida o desviaciones está en mm: ponga la medida nominal en una columna propia junto a la clase
exchange-row-short = celdas esperadas: { $expected }, encontradas: { $found }
exchange-row-long = celdas esperadas: { $expected }, encontradas: { $found }: ¿se usa el separador también como signo decimal o dentro de un texto?
exchange-row-too-long = la fila tiene más de { $most } KiB
exchange-open-quote = unas comillas no están cerradas en esta línea
exchange-header-hides-rows = línea { $line }: el encabezado ocupa varias líneas, y una de ellas parece una fila: cierre las comillas en la línea en que se abren
exchange-within-quotes = esta línea puede ser una fila o una observación: unas comillas se abren antes y se cierran aquí o después; ciérrelas en la línea en que se abren
exchange-callout = cota: { $reason }
exchange-nominal = medida nominal: { $reason }
exchange-nominal-differs = la cota { $callout } no concuerda con la medida nominal { $nominal } de su propia columna
exchange-measured = medido: { $reason }
exchange-simulated = simulado: { $given } no es ni true ni false
exchange-other-header = esta línea nombra columnas distintas de la primera: evalúe las filas que siguen como archivo aparte
exchange-below-other-header = no evaluado: la línea { $line } nombra otras columnas. Evalúe las filas que siguen como archivo aparte
exchange-simulated-below = las filas que siguen a esta línea son simuladas: evalúelas como archivo aparte, o con fitcheck import
exchange-origin = origen: { $given } no dice ni medido ni simulado; escriba measured, typed o simulated, o ponga simulated=- si esta columna dice otra cosa
exchange-decimal-sign = medido: { $given } tiene un signo decimal distinto de los demás valores: "{ $sign }"
exchange-not-positive = medido: un diámetro de { $given } no es mayor que 0
exchange-decimal-comma = { $joined } puede ser un solo número con coma decimal: use punto decimal u otro separador
exchange-other-feature = { $given } es { $feature ->
        [hole] un eje, y estos son los agujeros: ¿están cambiados los archivos?
       *[shaft] un agujero, y estos son los ejes: ¿están cambiados los archivos?
    }
exchange-rejected = el propio archivo rechaza este valor ({ $given }): quite la fila, o corríjala en el archivo
exchange-no-part = { $given } nombra un valor de varias piezas o un patrón de reglaje de un aparato, no una pieza: quite la fila, o dé otro nombre a la pieza
exchange-other-log = { $feature ->
        [hole] es el protocolo de un eje, y estos son los agujeros: ¿están cambiados los archivos?
       *[shaft] es el protocolo de un agujero, y estos son los ejes: ¿están cambiados los archivos?
    }
exchange-not-a-size = { $what }: no es una medida que se pueda emparejar
exchange-no-place-axis = está a lo largo de { $axis }, pero los ciclos 421 y 422 palpan a lo largo de Z
exchange-no-place-no-axis = el archivo no dice a lo largo de qué eje está
exchange-no-place-kind = { $kind }: los ciclos 421 y 422 palpan solo círculos y cilindros
exchange-no-place-system = se comprueba en el sistema de coordenadas { $system }, pero las coordenadas se refieren al del archivo
exchange-contacts-not-sizes = filas de dos o tres números son puntos de palpación: nombre las columnas en la primera línea, como id;measured
exchange-too-many-rows = solo se leyeron las primeras { $most } filas: divida el archivo
exchange-unjudged-no-callout = no evaluado: no se da ninguna cota
exchange-unjudged-no-limits = no evaluado: las medidas límite del protocolo son 0, así que el diámetro no se supervisó
exchange-unjudged-coordinate = una coordenada del ciclo { $cycle }, no un agujero o eje
exchange-unjudged-coordinate-without-limits = no evaluado: los límites del protocolo son 0, así que la coordenada no se supervisó
exchange-unjudged-size = { $what } del ciclo { $cycle }, no un agujero o eje
exchange-unjudged-size-without-limits = no evaluado: los límites del protocolo son 0, así que no se supervisó esto: { $what }
exchange-unjudged-point = un punto de superficie del ciclo { $cycle }: su desviación según la normal no es una medida
exchange-unjudged-point-without-tolerance = no evaluado: el punto se palpó sin tolerancia
exchange-unjudged-contacts = no evaluado: puntos de palpación sin cota: { $count }
exchange-warning-ignored-columns = columnas omitidas: { $columns }
exchange-warning-quantity-unknown = la columna { $column } no tiene ninguna palabra conocida para lo que se midió ({ $words }): todos sus valores se leen como medidas; si es correcto, indique import --columns quantity=-
exchange-warning-not-used = omitido, no es una medición: { $text }
exchange-warning-minus-supplied = la columna { $column } no tiene signos menos: sus valores se leen como desviaciones inferiores por debajo de la medida nominal
exchange-warning-callouts-unnamed = la columna { $column } parece contener las cotas con tolerancia, pero su nombre no se conoce: llamarla callout o dar su número con --columns, por ejemplo callout=2
exchange-warning-limits-read = las columnas { $columns } se leen como límites
exchange-warning-head-read = leído para todos los valores: { $said }
exchange-warning-samples-read = las columnas { $columns } se leen como piezas una junto a otra: cada valor se juzga por sí solo, una celda vacía no es un valor, y sin números de serie cada columna es una pieza propia
exchange-warning-comment = una línea que empieza con # es un comentario, pero esta contiene una medición
exchange-warning-several-lines = la fila ocupa { $lines } líneas entre comillas
exchange-warning-time = { $given } no es una fecha y hora: se usa la hora de importación
exchange-warning-place = { $given } no es una longitud: la ubicación se omite
exchange-warning-no-time = aquí no hay fecha ni hora: se usa la hora de importación
exchange-warning-offset = { $given } se guarda como hora local sin su diferencia con UTC
exchange-warning-cut-off = el archivo termina aquí sin fin de línea, y { $given } tiene menos decimales que los demás valores: puede estar cortado
exchange-warning-open-end = el archivo termina aquí sin fin de línea: su último valor, { $given }, puede estar cortado

# Contacts
contacts-file-empty = el archivo no contiene puntos de palpación
contacts-no-columns = el encabezado debe nombrar x e y, y puede nombrar z; es { $given }
contacts-twice = las columnas { $first } y { $second } son ambas { $name }
contacts-cells = celdas esperadas: { $wanted }, encontradas: { $cells }: { $given }
contacts-not-a-number = { $name } es { $given }, no un número de milímetros
contacts-row-too-long = la fila tiene más de { $most } KiB
contacts-comment = una línea que empieza con # es un comentario, pero esta contiene coordenadas: quite el #, o la línea entera
contacts-other-unit = los puntos de palpación están en mm, pero esta línea indica { $given }: conviértalos a mm
contacts-too-many = el archivo tiene más de { $most } puntos de palpación
contacts-simulated = estos puntos de palpación son simulados y no miden nada: use en su lugar un archivo de pieza de trabajo
contacts-origin = { $given } no dice ni medido ni simulado: escriba measured o simulated, o quite la columna
contacts-open-quote = unas comillas no están cerradas
contacts-mixed-signs = { $given } tiene un signo decimal distinto de las filas anteriores

## Tables of deviations
table-format-name = { $name } no empieza por una letra: los nombres de tablas en un TNC7 deben hacerlo
table-format-operator = { $name } contiene { $sign }: los nombres de tablas en un TNC7 no pueden tener operadores aritméticos
table-format-warning-lower-sign = el manual de PC-DMIS no muestra ninguna desviación inferior distinta de 0: revise { $class } en PC-DMIS antes de fiarse, sobre todo sus signos
table-format-csv = el CSV no se puede escribir: { $reason }
table-format-parquet-unknown = este programa se compiló sin Parquet: cargo build --release sin más opciones lo incluye
table-format-parquet = el archivo Parquet no se puede escribir: { $reason }
table-format-itnc530 = tabla del control para iTNC 530
table-format-tnc640 = tabla del control para TNC 620 y TNC 640
table-format-tnc7 = tabla del control para TNC7
table-format-plain-csv = CSV, una línea por cada clase e intervalo de medidas
table-format-plain-parquet = Parquet, una fila por cada clase e intervalo de medidas
table-format-pcdmis = CSV de tolerancias ISO para PC-DMIS

## Limits as SQL
sql-border = tabla { $table }: un intervalo de medidas termina en { $end } mm; como SQL, los intervalos deben terminar en milímetros enteros
sql-too-far = tabla { $table }: un intervalo de medidas termina en { $end } mm; como SQL, los intervalos deben terminar a más tardar en { $most } mm
sql-twice = la clase { $class } se nombra dos veces
exchange-correction = el valor a 20 °C no se deduce del valor medido y sus temperaturas: se esperaban las columnas como las escribe Fitcheck
exchange-warning-corrected = los valores con un dato en la columna as_measured_mm ya están a 20 °C
sizes-warning-named-twice = { $rows ->
        [one] una fila tiene el nombre de una fila anterior
       *[other] { $rows } filas tienen el nombre de una fila anterior
    }, como { $id } en las líneas { $first } y { $second }: cada fila cuenta como una pieza
sizes-warning-simulated-rows = { $count ->
        [one] 1 fila es simulada
       *[other] { $count } filas son simuladas
    }: no se midió nada
exchange-position-out = el centro estaba fuera de posición, pero el archivo tiene solo la medida
exchange-undecided = aquí no se decidió nada: { $given }
exchange-warning-other-rule = los dictámenes de este archivo pueden venir de otra regla de decisión (columna rule_name): sus valores se evalúan de nuevo
exchange-read = el resto del archivo no se puede leer: { $reason }
exchange-too-large = mayor que { $most } MiB, el límite para archivos de este formato
exchange-unjudged-one-limit = no evaluado: falta uno de los dos límites
exchange-unjudged-no-tolerance = no evaluado: no se dan límites
exchange-unjudged-rounded = no evaluado: las cifras impresas representan cualquier valor de { $from } a { $to }, y un límite está entre ellos: imprima más decimales
exchange-unjudged-implausible = no evaluado: { $measured } mm no puede ser: el plan indica de { $lower } a { $upper } mm; compruebe la unidad y el signo decimal, o vuelva a medir
exchange-unjudged-swapped-limits = no evaluado: el límite inferior { $minimum } es mayor que el límite superior { $maximum }
exchange-unjudged-not-a-size = { $what }: no es una medida de un agujero o eje
exchange-warning-limits-differ = { $callout } tiene los límites { $minimum } a { $maximum }, pero el archivo tiene otros: valen los del archivo
exchange-warning-class-unknown = la clase { $given } no tiene límites aquí: valen los del archivo
exchange-warning-status-differs = el archivo dice { $given }, pero los límites dicen { $status }
exchange-warning-status-unknown = el archivo dice { $given }, que no es un estado conocido: los límites dicen { $status }
exchange-warning-limit-differs = el archivo dice { $given }, pero los límites son de { $minimum } a { $maximum }
exchange-warning-deviation-differs = el archivo dice { $given }, pero no es la desviación de { $measured } respecto a { $nominal }
exchange-warning-feature-differs = el archivo dice { $given }, pero los límites son los de { $feature ->
        [hole] un agujero
       *[shaft] un eje
    }
exchange-warning-temperature-differs = el archivo dice { $given }, pero el valor cuenta como medido a { $counted } °C: indique --temperature y --material
exchange-warning-speaks-of-temperature = el archivo menciona una temperatura distinta de { $counted } °C, a la que sus valores cuentan como medidos: { $text }
exchange-warning-speaks-of-unit = una observación indica una unidad distinta de la de los valores: { $text }
exchange-warning-speaks-of-simulation = esta línea menciona una simulación: revise si el valor se midió: { $text }
exchange-warning-all-nominal = los { $count } valores son exactamente sus medidas nominales: puede ser una lista de medidas que nadie midió
exchange-warning-name-of-no-size = { $given } no es el nombre de una medida de una pieza, pero el valor se evaluó como tal
exchange-warning-other-values = no se evalúan las columnas con otros valores próximos a los medidos: { $columns }
exchange-warning-part-rejected = el archivo dice { $given } de la pieza entera
exchange-warning-uncertainty-not-used = el archivo indica una incertidumbre expandida de { $expanded } mm: ninguna regla la usa, así que indique --u en su lugar
exchange-warning-plan-differs = el archivo tiene los límites { $minimum } a { $maximum }: valen los límites del plan
exchange-warning-plan-differs-below = el archivo tiene el límite inferior { $minimum }: vale el límite inferior del plan
exchange-warning-above-own-limit = no es del plan, y está por encima del límite superior de su archivo, { $maximum }
exchange-warning-below-own-limit = no es del plan, y está por debajo del límite inferior de su archivo, { $minimum }
exchange-warning-plan-differs-above = el archivo tiene el límite superior { $maximum }: vale el límite superior del plan
exchange-warning-plan-differs-nominal = el archivo tiene la medida nominal { $nominal }: vale la medida nominal del plan
exchange-warning-part-differs = el archivo nombra la pieza { $given }: se evalúa como { $part }, la pieza del plan
exchange-warning-found-by-number-of = ningún elemento del plan se llama { $given }; asignado por número a { $name } del plan
exchange-warning-found-by-place-of = ningún elemento del plan se llama { $given }; asignado por ubicación a { $name } del plan
exchange-warning-found-by-number = asignado por número a { $name } del plan
exchange-warning-found-by-place = asignado por ubicación a { $name } del plan
exchange-format-aqdef = Q-DAS AQDEF, en un archivo o como .dfd y .dfx
exchange-format-calypso = tablas de características de CALYPSO como NAME_chr.txt
exchange-format-calypso-text = informes impresos de CALYPSO guardados como texto
exchange-format-geopak = tolerancias de MCOSMOS (GEOPAK) en un archivo sin nombres de columnas
exchange-format-gauge = líneas de aparatos guardadas en un archivo, como 01A+025.012
exchange-format-pcdmis = informes de texto de PC-DMIS
exchange-format-probed = impresiones de macros de palpación, como las escriben Renishaw y los sistemas CAM
exchange-warning-unit-assumed = no se da ninguna unidad: las longitudes sin unidad se leen como mm
exchange-warning-unit-read = las longitudes se leen en { $unit }, como indica el archivo: { $text }
exchange-warning-rounded = { $given } tiene cifras más allá del nanómetro: se redondea al nanómetro más próximo
exchange-warning-rounded-values = { $count ->
        [one] 1 valor medido tiene cifras más allá del nanómetro, desde esta línea: se redondea al nanómetro más próximo
       *[other] { $count } valores medidos tienen cifras más allá del nanómetro, desde esta línea: se redondean al nanómetro más próximo
    }
exchange-unjudged-quantity = { $quantity ->
        [102] redondez (K2009 es 102)
        [109] posición (K2009 es 109)
        [117] una coordenada (K2009 es 117)
       *[other] una magnitud distinta de un diámetro (K2009 es { $quantity })
    }: no es una medida de un agujero o eje
exchange-unjudged-kind = no medido: { $kind ->
        [1] un recuento de piezas no conformes (K2004 es 1)
        [5] una hoja de registro de errores (K2004 es 5)
        [6] una hoja de registro de errores (K2004 es 6)
       *[other] un tipo de característica desconocido (K2004 es { $kind })
    }
exchange-unjudged-attribute = no evaluado: marcado con { $given } (K0002); solo se sabe que 0 marca un valor válido
exchange-unjudged-not-valid = no evaluado: el archivo dice { $said }, así que puede no haber valor válido
exchange-unjudged-declaration = no evaluado: la línea { $declaration } de su declaración no se puede usar
exchange-format-qif = QIF 2.0, 2.1, 3.0: resultados de software de medición, y planes
exchange-xml = no es XML bien formado: { $reason }
exchange-xml-doctype = no se admite un DOCTYPE: quítelo, o exporte el archivo sin él
exchange-xml-entity = la entidad { $name } no es conocida: solo se admiten &lt; &gt; &amp; &quot; y &apos;
exchange-xml-depth = alcanzado el límite de { $most } elementos anidados
exchange-xml-long = una etiqueta o un texto tiene más de { $most } KiB
exchange-xml-mixed = { $name } tiene un elemento en medio de su texto
exchange-xml-cut-off = el archivo termina dentro de un elemento: puede estar cortado
exchange-xml-encoding = codificación desconocida { $given }: use UTF-8, UTF-16 o ISO 8859-1
exchange-xml-bytes = estos bytes no son texto en la codificación del archivo
exchange-qif-unit = unidad de longitud { $unit }: el nombre es desconocido o no concuerda con el factor; use mm, inch u otra unidad con su factor a metros
exchange-qif-no-unit = el archivo no tiene unidad de longitud: necesita FileUnits con PrimaryUnits y LinearUnit
exchange-qif-reference = { $what } { $id } no está en el archivo
exchange-qif-too-many = el archivo tiene más de { $most } elementos { $what }
exchange-qif-no-value = aquí no hay valor medido; estado { $status }
exchange-qif-limit = límites o medida nominal: { $reason }
exchange-qif-other-kind = la medición es del tipo { $measured }, pero su característica es del tipo { $defined }
exchange-qif-several-values = la medición tiene varios valores
exchange-qif-defined-as-limit = falta DefinedAsLimit o no es ni true ni false, así que los números pueden ser límites o desviaciones
exchange-qif-no-nominal = los límites son desviaciones, pero no hay medida nominal
exchange-qif-zone = la clase { $class } y { $zone } se contradicen: las mayúsculas son agujeros, las minúsculas son ejes
exchange-qif-no-results = un archivo QIF sin valores medidos: un plan se puede leer como plan de pieza
exchange-qif-no-characteristics = el archivo QIF no declara ninguna característica
exchange-warning-standard-uncertainty-not-used = el archivo indica una incertidumbre típica combinada de { $standard } y un error medio de { $mean-error }: ninguna regla los usa, así que indique --u en su lugar
exchange-warning-sheet-hidden = la hoja { $sheet } se lee, aunque está oculta en el libro
exchange-warning-rows-hidden = { $count ->
    [one] la fila { $rows } está oculta o filtrada en el libro, pero se lee como las demás
   *[other] { $count } filas están ocultas o filtradas en el libro, pero se leen como las demás: { $rows }
}
exchange-warning-columns-hidden = las columnas ocultas se leen como las demás: { $columns }
exchange-warning-qif-version = versión de QIF { $version }: este programa está hecho para las versiones 2.0, 2.1 y 3.0
exchange-warning-qif-count = { $list } dice n={ $said }, pero tiene { $found }: puede faltar o sobrar algo
exchange-warning-qif-twice = el id { $id } aparece dos veces: se usa el primer elemento
exchange-format-xlsx = mediciones en un libro de hojas de cálculo: columnas como en CSV
exchange-workbook = este libro no se puede leer: { $reason }
exchange-not-a-workbook = un archivo ZIP, pero no un libro: descomprímalo e indique los archivos que contiene
exchange-old-workbook = un libro en formato { $format }, que no se admite: guárdelo como XLSX
exchange-workbook-password = el libro tiene contraseña: guárdelo sin ella
exchange-zip-cut-off = falta el final del libro: puede estar cortado
exchange-zip-members = la lista de miembros del libro está dañada o tiene más de { $most }
exchange-zip-bomb = { $member } ocupa descomprimido más de { $most } MiB, o está demasiado comprimido para un libro: no se lee
exchange-zip-twice = dos miembros del libro tienen el mismo nombre, así que se ha modificado: ábralo en un programa de hojas de cálculo y guárdelo
exchange-zip-texts = el libro tiene más de { $most } textos distintos
exchange-sheet-wide = la celda { $cell } está más allá de las primeras { $most } columnas
exchange-too-many-cells = la hoja tiene más de { $most } celdas
exchange-cell = { $cell }: { $reason }
exchange-formula-without-value = el valor de la fórmula ={ $formula } no está guardado: abra el libro en un programa de hojas de cálculo y guárdelo
exchange-cell-split = el valor de la celda no está guardado como un solo texto simple, así que solo se pudo leer una parte: abra el libro en un programa de hojas de cálculo y guárdelo
exchange-cell-error = la celda muestra { $error }
exchange-warning-sheets-left = se lee la hoja { $sheet }; las demás no: { $left }
gauge-frame = se omitieron los caracteres que enmarcan la línea
gauge-channel = del canal { $channel }
gauge-inches = { $given } pulgadas
gauge-error-text = { $given } puede ser un número de error del aparato: si es una medida, escríbala con su unidad, { $given } mm
gauge-opinion = el aparato dice { $sign }; deciden los límites del plan

mapping-no-value = { $given } no asigna ninguna columna: escriba una palabra, = y una columna, como measured=3
mapping-word = { $given } no es un contenido de columna conocido: se admiten { $allowed }
mapping-value = { $word }: { $given } es desconocido: se admiten { $allowed }
mapping-twice = { $word } se da dos veces: indíquelo una vez
mapping-toml = no es una asignación de columnas: { $reason }

# How a value was judged by a plan, and what was given beside it.
planned-rule = evaluado según la regla del plan en lugar de { $given }: { $rule }
planned-uncertainty = evaluado con la incertidumbre del plan en lugar de la indicada: { $u }
planned-material = corregido a 20 °C con el material del plan en lugar del indicado: { $name }
planned-corrected = corregido de { $temperature } °C a 20 °C (dilatación { $expansion } · 10⁻⁶/K)
planned-not-corrected = sin corregir a 20 °C: una ubicación en la pieza no es una medida
planned-error-already-corrected = el archivo dice que el valor ya está a 20 °C: evalúelo sin temperatura

## Gauges
gauge-no-unit = { $given } no indica ninguna unidad: diga en la configuración del aparato si envía milímetros o pulgadas
exchange-gauge-unit = la línea { $line } de estas líneas de aparato, { $given }, no indica ni mm ni pulgadas: indique la unidad con import --columns unit=mm o --columns unit=inch
gauge-other-form = { $given } difiere de la línea que se enseñó para el aparato, { $example }, en algo más que las cifras
gauge-other-decimals = { $given } tiene { $decimals ->
        [one] 1 decimal
       *[other] { $decimals } decimales
    }, y la línea que se enseñó para el aparato tiene { $taught }: el aparato envía otra unidad, o se perdió una parte del número
teach-zero = 0 puede ser cualquier cero de la línea: use como ejemplo una línea con otro valor
teach-not-text = { $line } tiene caracteres que no son texto
teach-nowhere = { $value } mm no está en la línea { $line }: escriba el valor que el aparato mostraba con ella
teach-twice = { $value } mm está más de una vez en la línea { $line }: use como ejemplo una línea con otro valor
teach-other-unit = la línea dice { $given }, y eso no son { $value } mm: escriba el valor que el aparato mostraba, en milímetros
