# control

# Masks
mask-empty = la máscara está vacía
mask-too-large = la máscara es mayor que { $most } KiB
mask-unknown = { $found } no es una línea de salida, una palabra clave ni un comentario
mask-unclosed-quote = las comillas no están cerradas
mask-unknown-format = { $found } no es un formato: se admiten %S %RS %F %LF %D %I %%
mask-too-wide = { $found } es demasiado ancho: como máximo { $most }
mask-count = formatos: { $formats }, parámetros: { $parameters }
mask-unknown-parameter = { $found } no es un parámetro: se admiten Q, QL, QR, QS con un número, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = falta el ; al final
mask-unknown-word = { $word } es desconocido y no tiene efecto
mask-behind-semicolon = { $found } después del ; se omite
mask-other-languages = la máscara tiene texto para { $languages } y ninguno para { $wanted }
mask-inverse-touching = { $first } y { $second } se imprimen sin nada entre ellos, así que la salida no se puede volver a leer
mask-inverse-blanks = { $first } y { $second } son textos con solo espacios entre ellos, así que la salida no se puede volver a leer: un texto puede contener espacios
mask-inverse-no-mark = ningún texto fijo marca dónde empieza una salida, así que no se puede volver a leer
mask-inverse-too-long = la máscara imprime más de { $most } líneas cada vez: solo se pueden volver a leer salidas más cortas
mask-inverse-no-number = la máscara no imprime ningún número que pueda ser un valor medido
mask-undefined = { $name } no está definido
mask-text-as-number = { $name } es un texto, el formato necesita un número
mask-number-as-text = { $name } es un número, el formato necesita un texto
mask-not-finite = { $name } no es un número finito
# Measuring logs
log-empty = el archivo está vacío
log-no-log = no es un protocolo de medición: ninguna línea de título con el número de un ciclo de medición
log-too-long = el protocolo tiene más de { $lines } líneas, o una línea de más de { $bytes } bytes
log-no-title = el protocolo no tiene línea de título, así que no se conoce su ciclo
log-other-cycle = los protocolos del ciclo { $cycle } no se pueden leer, solo los de { $known }
log-unit = la unidad de medida { $given } no es ni 0 (mm) ni 1 (pulgada)
log-count = { $section }: esperado: { $expected }, encontrado: { $found }
log-missing = falta la { $section }: el protocolo está cortado o incompleto
log-no-label = ningún rótulo delante de { $given }
log-cut-figure = el archivo termina dentro de este valor: { $given } puede estar incompleto
log-swapped = el máximo { $maximum } es menor que el mínimo { $minimum }
log-uneven = los límites { $minimum } y { $maximum } no son simétricos respecto al valor nominal { $nominal }
log-deviation = la desviación { $given } no es valor real menos nominal, { $actual } - { $nominal }
log-not-positive = el diámetro { $given } no es mayor que 0
log-section-nominal = sección de valores nominales
log-section-limits = sección de valores límite
log-section-actual = sección de valores reales
log-section-deviations = sección de desviaciones
log-no-unit = ninguna línea da la unidad: se suponen milímetros
log-no-time = fecha y hora de la medición son desconocidas
log-no-deviations = faltan las desviaciones: el protocolo puede estar cortado
log-ignored = omitido: { $text }
log-text-before = se omitió el texto anterior al primer protocolo

## Tables
table-empty = el archivo está vacío
table-not-text = el carácter { $code } no es texto: el archivo no es una tabla o está dañado
table-line-too-long = la línea tiene más de { $limit } bytes
table-too-large = la tabla tiene más de { $limit } celdas
table-too-many-columns = la tabla tiene más de { $limit } columnas
table-no-begin = una tabla empieza con BEGIN y su nombre, no con { $found }
table-no-name = falta el nombre de la tabla después de BEGIN
table-unclosed-quote = unas comillas no están cerradas
table-unclosed-block = el bloque { $block } de la línea { $line } no está cerrado
table-second-block = las columnas se describen por segunda vez
table-unexpected = se esperaba { $expected }, se encontró { $found }
table-not-a-size = { $key } debe ser un número entero hasta { $limit }, no { $text }
table-no-columns = falta la línea con los nombres de las columnas
table-tab = carácter de tabulación: separe las columnas solo con espacios
table-column-twice = la columna { $name } aparece dos veces
table-short-row = la fila termina antes de la columna { $name }: rellénela con espacios, o escriba - si no hay valor
table-truncated = el archivo termina dentro de esta fila y sin [END]: puede estar cortado
table-text-after-end = texto después de [END]: { $found }
table-no-end = falta [END]
table-no-lock = la tabla de herramientas no tiene la columna TL: una herramienta rota no se bloquea en ella
table-no-unit = la tabla no indica su unidad: sus longitudes se leyeron como milímetros
table-begin-word = { $word } no tiene significado conocido en la línea BEGIN
table-width = la columna { $name } tiene aquí { $found } caracteres de ancho pero { $described } en la descripción; vale la línea de nombres de columnas
table-not-in-table = la columna { $name } está descrita pero no está en la tabla
table-not-described = la columna { $name } no está descrita
table-skipped = { $name } es desconocido y se omitió
table-write-too-wide = fila { $row }, columna { $column }: { $text } no cabe en { $width } caracteres
table-write-too-many-columns = la tabla tiene { $columns } columnas; un iTNC 530 admite como máximo { $limit }
table-write-too-long = las líneas de la tabla tienen { $characters } caracteres; un iTNC 530 admite como máximo { $limit }
table-write-reads-otherwise = la tabla no se puede escribir de modo que se lea igual: revise los nombres de la tabla y de sus columnas

## Tables of deviations
deviations-no-tables = ninguna tabla de desviaciones (*.tab con una columna BEREICH) en esta carpeta: { $folder }
tables-contradict = { $first } y { $second } se contradicen, { $class } más de { $over } hasta { $to } mm: { $one ->
        [none] sin valor
       *[other] { $one } µm
    } y { $other ->
        [none] sin valor
       *[other] { $other } µm
    }: quite la columna de una de ellas
deviations-two-range-columns = la tabla tiene BEREICH y BEREIK: solo una puede contener los intervalos de medidas
deviations-inch = la tabla está en pulgadas: escriba los intervalos de medidas en milímetros y las desviaciones en micrómetros
deviations-no-class = ninguna columna es una clase de tolerancia como H7
deviations-odd-rows = el número de filas es impar ({ $rows }): cada intervalo de medidas ocupa dos, primero la desviación superior, después la inferior
deviations-no-range = falta el final del intervalo de medidas
deviations-other-range = el intervalo de medidas hasta { $end } mm tiene { $found } en su segunda fila: repítalo o déjelo en blanco
deviations-column = columna { $column }: { $error }
deviations-half = la columna { $class } tiene solo una de las dos desviaciones para el intervalo de medidas hasta { $end } mm
deviations-touches = la columna { $column } y su vecina se tocan: sepárelas con un espacio
deviations-no-deviations = omitido, no es una tabla de desviaciones (sin columna BEREICH): { $file }
deviations-range-alias = BEREIK se leyó como BEREICH
deviations-other-column = la columna { $name } se omitió, porque su nombre no puede ser el de una clase de tolerancia: le falta a una tabla escrita a partir de esta
deviations-no-numbers = la columna { $name } se omitió, porque contiene textos y no desviaciones: le falta a una tabla escrita a partir de esta
deviations-mixed-case = la columna { $name } se omitió, porque una clase de tolerancia no mezcla mayúsculas y minúsculas: le falta a una tabla escrita a partir de esta

## Parameters
no-parameter = { $given } no es un parámetro: se admiten Q, QL, QR y QS con un número

## Writing measuring logs
log-write-cycle = el ciclo { $cycle } no escribe estos valores
log-write-no-title = el protocolo del ciclo { $cycle } no tiene título en { $file }
log-write-unit = un protocolo está en mm o en pulgadas, no en µm
log-write-character = { $given } no se puede escribir: un protocolo no puede contener el carácter U+{ $code }
log-write-program = { $given } no se leería de nuevo como la ruta de un programa: escriba una ruta como TNC:\PART\CHECK.H
log-write-unfinished = el archivo termina dentro de una línea: puede estar cortado, así que no se le añade nada
log-write-reads-otherwise = el protocolo no se puede escribir de modo que se lea igual: revise fecha, hora y demás resultados

## Log of cycle 444
point-log-no-log = no es un protocolo del ciclo 444: la página no contiene ninguna medición legible por máquina
point-log-count = la página dice contener { $expected } mediciones, pero contiene { $found }: está cortada o se modificó
point-log-cut-off = la medición no tiene final: la página está cortada
point-log-json = la medición no se puede leer: { $what }
point-log-version = no se admite la versión { $version } del protocolo: se esperaba { $known } o anterior
point-log-normal = la normal { $given } no tiene dirección: necesita tres números que no sean todos 0
point-log-deviation = la desviación { $given } en { $axis } no es coordenada medida menos nominal, { $difference }
point-log-along = la desviación { $given } según la normal no se deduce de las de los ejes, { $along }
point-log-band = la desviación superior { $upper } es menor que la desviación inferior { $lower }
point-log-status = el estado { $given } no se deduce de la desviación y la tolerancia, { $status }
## The touch-probe table
probe-table-no-column = la tabla no tiene la columna { $column }
probe-table-no-probe = la tabla no tiene ningún palpador
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: debe ser { $least }
probe-table-zero-or-more = 0 o mayor
probe-table-above-zero = mayor que 0
probe-table-not-whole = { $column } = { $given }: se esperaba un número entero
probe-table-twice = el palpador { $number } aparece dos veces

## The tool table
tool-table-no-column = la tabla no tiene la columna { $column }
tool-table-no-tool = la tabla no tiene ninguna herramienta
tool-table-touches = { $column }: la celda toca a su vecina, así que su valor es incierto
tool-table-no-number = { $column } = { $given }: se esperaba un número de herramienta de 0 a 32767, con un índice como 5.1 o sin él
tool-table-twice = la herramienta { $number } aparece dos veces
tool-table-name-too-long = NAME = { $given }: un nombre tiene como máximo { $most } caracteres
tool-table-no-length = { $column }: { $error }
tool-table-out-of-range = { $column } = { $given } mm: se esperaba de { $least } a { $most } mm
tool-table-no-lock = TL = { $given }: se esperaba L o 1 para una herramienta bloqueada; 0, - o nada para una libre
tool-table-not-whole = { $column } = { $given }: se esperaba un número entero
tool-unknown = Q330 = { $tool }: la tabla de herramientas no tiene esa herramienta; tiene { $known }
tool-no-deviation = Q330 = { $tool }: el ciclo { $cycle } no tiene límites aquí, así que no hay desviación con la que corregir la herramienta
tool-out-of-range = herramienta { $tool }: { $column } cambiaría de { $from } a { $to } mm: el valor mayor es { $most } mm en ambos sentidos
tool-broken = error 1065: herramienta { $tool } rota: { $column } cambiaría { $by } mm, { $limit } es { $most } mm; la herramienta se bloquea y no se corrige
tool-broken-replacement = error 1065: herramienta { $tool } rota: { $column } cambiaría { $by } mm, { $limit } es { $most } mm; la herramienta se bloquea y no se corrige; su herramienta gemela es { $replacement }
tool-corrected = herramienta { $tool }: { $column } cambió { $by } mm, de { $from } a { $to } mm
tool-corrected-rounded = herramienta { $tool }: { $column } cambió { $by } mm, de { $from } a { $to } mm: la tabla conserva las 0,00001 pulgadas más próximas
tool-locked = herramienta { $tool }: bloqueada, TL = { $to }

## The log of a cycle's result
cycle-log-other-verdict = los valores del protocolo, redondeados a 0,0001 { $unit }, dan { $log } donde el ciclo dio { $cycle }

## The block of a probing cycle
block-none = no es un ciclo de palpación: una frase empieza con TCH PROBE y un número, o con G785
block-inches = la frase es de un programa en pulgadas pero se leería en mm: ejecute el programa
block-none-at = esta línea no es de ningún ciclo de medición: empiezan en las líneas { $blocks }
block-second = segundo ciclo de palpación: indique uno cada vez; el primero empieza en la línea { $first }
block-unknown-cycle = TCH PROBE { $given }: los ciclos son { $known }
block-not-a-parameter = { $given } no es un parámetro: escríbalo como { $example }
block-no-value = { $key } no tiene valor
block-twice = { $key } se da dos veces, la primera en la línea { $first }
block-unclosed-quote = unas comillas no están cerradas
block-behind-end = { $given } viene después del final de la frase: todas las líneas menos la última terminan en ~
block-too-many-parts = la línea tiene más de { $most } partes entre ~
block-cut-off = la frase termina en ~, así que falta una línea: puede estar cortada
block-reference = { $key } = { $given }: el valor de { $given } solo se conoce mientras se ejecuta un programa
block-not-writable = { $key } = { $given }: un texto de una frase no puede contener comillas ni fines de línea
block-unused = línea { $line }: { $text } no forma parte del ciclo de palpación y se omitió
block-unused-more = línea { $line }: { $text } no forma parte del ciclo de palpación y se omitió, y { $more } más
