# probing

# Where a measurement comes from, and what it cannot tell.
origin-simulated = simulado, ciclo { $cycle }, semilla { $seed }
origin-contacts = puntos de palpación de { $file }
origin-imported = importado de { $file }
origin-imported-simulation = importado de { $file }, simulado
origin-typed = escrito
caveat-only-a-diameter = un solo diámetro: forma y posición desconocidas
caveat-only-a-circle = solo diámetro y centro: forma desconocida
caveat-three-contacts = 3 puntos de palpación: la forma no se puede medir
caveat-four-contacts = 4 puntos de palpación: no se detecta más forma que la ovalidad
caveat-few-contacts = { $contacts } puntos de palpación: la forma entre ellos no se detecta
caveat-short-arc = los puntos de palpación cubren solo { $arc }°: la dispersión se amplía en diámetro y centro
caveat-two-point = el diámetro entre los puntos de palpación { $one } y { $other } es { $size } mm, más allá del límite de { $limit } mm, que el círculo medio no supera: por defecto, una medida vale entre dos puntos opuestos cualesquiera
caveat-form = los radios de los puntos de palpación difieren en { $form } mm, así que los diámetros entre ellos pueden diferir más que la zona de { $zone } mm: dos puntos opuestos pueden estar fuera de los límites
caveat-heights = las alturas de los puntos de palpación difieren en { $spread } mm: en un cono o con un eje inclinado eso cambia el diámetro
caveat-stated = la cota indica tras la tolerancia { $upper } y { $lower } µm, la tolerancia tiene { $used-upper } y { $used-lower } µm: se usó la tolerancia; compruebe qué quiere decir el plano
caveat-count = la cota vale para { $count } elementos: este valor es el de uno
caveat-form-class = la clase { $class } de ISO 2768-2 es para forma y posición: la medida no las muestra
caveat-each-two-point = { $modifier } exige cada medida entre dos puntos dentro de los límites: esto es un solo diámetro
caveat-mean-of-two-points = { $modifier } exige cada medida entre dos puntos dentro de los límites: el diámetro de mínimos cuadrados es solo su media
caveat-not-least-squares = { $modifier } se refiere a la medida de mínimos cuadrados: un solo diámetro no la muestra
caveat-one-section = { $modifier } se refiere a la medida de mínimos cuadrados de todo el elemento: esta es la de una sección
caveat-envelope = { $modifier } exige la envolvente de forma perfecta en la medida de máximo material: un diámetro no muestra si la superficie la rebasa; use un calibre
caveat-other-size = { $modifier } se refiere a otra medida que la medida obtenida: un diámetro entre dos puntos o de mínimos cuadrados no la demuestra
caveat-condition = { $modifier } dice dónde o cómo vale la medida: el valor medido no muestra si se cumple
contact-beyond-travel = el punto de palpación { $number } está a { $distance } mm de donde empieza su palpación, y la bola recorre como máximo { $allowed } mm (DIST o K, más SET_UP de la tabla de palpación y Q320): revise que estos puntos sean de este elemento, en este orden, y contados desde este punto cero
contact-missed = punto de palpación { $number }: el palpador no encontró nada en el recorrido de palpación
contact-no-height = el punto de palpación { $number } no tiene altura: añada una columna z al archivo
contact-used-up = punto de palpación { $number }: el archivo tiene solo { $available ->
    [one] { $available } punto de palpación
   *[other] { $available } puntos de palpación
    }

cycle-out-of-range = { $key } { $name } = { $given }: { $allowed }
cycle-length-range = al menos { $least } mm, como máximo { $most } mm
cycle-angle-range = como máximo { $most } en ambos sentidos
cycle-angle-size-range = al menos { $smallest } en valor absoluto, como máximo { $most }
cycle-one-of = se esperaba uno de { $allowed }
cycle-tool-range = un número de herramienta de 0 a 99999.9, o un nombre de herramienta de 255 caracteres como máximo
cycle-not-a-value = { $key } { $name }: { $error }
cycle-tool-no-name = { $text } no llama a ninguna herramienta: escriba su número o su nombre
cycle-tool-empty = no se nombra ninguna herramienta: para ninguna, escriba Q330=0
cycle-tool-unquoted = { $text } no es un número, y un nombre de herramienta necesita comillas
cycle-no-diameter = { $key } { $name } = 0 mm: un círculo necesita un diámetro mayor que 0
cycle-one-limit = se da { $given } sin { $missing }: el otro límite sería 0
cycle-missing = falta { $key } { $name }
cycle-no-such-parameter = el ciclo { $cycle } no tiene el parámetro { $parameter }: sus parámetros son { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm es mayor que { $maximum-key } = { $maximum } mm: la medida mínima es mayor que la máxima
cycle-too-large = el círculo medido es demasiado grande: { $error }
workpiece-cannot-be = { $what } = { $given }: al menos { $least }, como máximo { $most }

# Touches.
contact-in-material = punto de palpación { $number }: el recorrido de palpación empieza dentro del material
contact-in-feature = punto de palpación { $number }: el recorrido de palpación empieza dentro del material de { $feature }
contact-behind = punto de palpación { $number }: la bola llega a la pared de { $feature } por detrás, y no se conoce el espesor del material allí
contact-ambiguous = punto de palpación { $number }: la bola encuentra { $feature } y { $other } en el mismo lugar, así que no se sabe cuál se mide

# Circle evaluation.
circle-too-few = un círculo necesita al menos 3 puntos de palpación, se encontraron { $contacts }
circle-coinciding = los puntos de palpación { $first } y { $second } coinciden en x = { $x }, y = { $y }: un círculo necesita 3 puntos distintos
circle-collinear = los { $contacts } puntos de palpación están en una recta: ningún círculo pasa por ellos
circle-straight = los { $contacts } puntos de palpación se ajustan mejor a una recta que a cualquier círculo
circle-not-finite = punto de palpación { $contact }: { $axis } = { $value } no es un número finito
circle-too-large = { $what } = { $value } mm es demasiado grande: como máximo { $most } mm en ambos sentidos
circle-part-contact = punto de palpación { $contact }: { $axis }
circle-part-diameter = diámetro
circle-part-centre = centro { $axis }
circle-three-contacts = 3 puntos de palpación: la forma no se puede medir, el residuo es siempre cero
circle-four-contacts = 4 puntos de palpación: cuatro lóbulos no se detectan y cambian el diámetro
circle-short-arc = los puntos de palpación cubren solo { $arc }° de arco: la dispersión del diámetro es { $factor } veces la de 3 puntos a 120°
circle-circumscribed-of-short-arc = el círculo mínimo circunscrito de un arco corto no es la medida del elemento
circle-counts-twice = los puntos de palpación { $first } y { $second } coinciden: este lugar cuenta dos veces
circle-no-inscribed = sin círculo máximo inscrito: los puntos de palpación no rodean ninguno
circle-no-zone = sin zona mínima: una banda recta es más estrecha que cualquier anillo
circle-too-many-contacts = el círculo máximo inscrito y la zona mínima no se calculan para { $contacts } puntos de palpación: como máximo { $most }
circle-short-chord = los puntos de palpación { $first } y { $second } están enfrentados pero fuera del centro: esta medida es { $short } µm demasiado pequeña
circle-more-of-a-kind = lo mismo vale para { $more } más
circle-apart = el punto de palpación { $contact } está a { $apart } mm del círculo, mucho más que los demás: ¿suciedad o un disparo falso?
circle-heights = las alturas de los puntos de palpación difieren en { $spread } mm: en un cono o con un eje inclinado eso cambia el diámetro

## Measuring cycles: errors, results, remarks
contact-out-of-reach = punto de palpación { $number }: el palpador no encontró nada en el recorrido de palpación de { $longest } mm
cycle-number-range = un número, como máximo { $most } en ambos sentidos
cycle-count-range = un número entero de 0 a { $most }
cycle-band-range = una tolerancia como 0.4-0.1, 0.4 o -0.1; 0 significa sin tolerancia
cycle-range = { $range }
cycle-range-tool = 0 … { $highest }, o { $longest } caracteres como máximo
cycle-range-band = 0.4-0.1, 0.4, -0.1 o nada
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = sin tolerancia
cycle-no-global = { $key } { $name } = PREDEF: ningún GLOBAL DEF da un valor
cycle-no-path = { $key } { $name } = 0 mm: un recorrido de palpación necesita una longitud; su signo da el sentido
cycle-no-transfer = { $row-key } = { $row } con { $key } = -1: no se indica en qué tabla está esa fila; { $key } debe ser 0 o 1 (un control muestra el error 1078)
cycle-other-feature = { $key } { $name } = { $given }: la clase no concuerda con { $geometry }: las mayúsculas son para un agujero, las minúsculas para una isla
cycle-not-measured = { $key } { $name } = { $given }: el ciclo no mide este valor: escríbalo sin tolerancia
cycle-inch-tolerance = { $key } { $name } = { $given }: en un programa en pulgadas no se conoce la unidad de una tolerancia: escriba un programa en mm o el número sin tolerancia
cycle-no-edge = { $first } y { $second } son iguales: una arista necesita dos puntos a lo largo de ella
cycle-no-sphere = los puntos de palpación no determinan una esfera
cycle-no-rotation = { $key } { $name }: Fitcheck solo sigue un giro básico (Q1121 = 1), y sin corrección (Q1120 = 0)
cycle-no-normal = { $first }, { $second } y { $third } son todos 0: una normal necesita una dirección
cycle-apart = punto de palpación { $contact }: sus dos palpaciones distan { $difference } mm, { $key } permite { $most } mm
cycle-too-far = la coordenada medida es demasiado grande: { $error }
cycle-stop = parada del programa por Q309 = { $setting }: { $out }
check-within = { $what } { $measured } mm está dentro de { $minimum } a { $maximum } mm
check-above = { $what } { $measured } mm supera su máximo { $maximum } mm: { $status }
check-below = { $what } { $measured } mm no alcanza su mínimo { $minimum } mm: { $status }
check-and = { $one }; { $other }
found-centre-1 = centro medido, 1.er eje
found-centre-2 = centro medido, 2.º eje
found-centre-3 = centro medido, 3.er eje
found-diameter = diámetro medido
found-centre-deviation-1 = desviación del centro, 1.er eje
found-centre-deviation-2 = desviación del centro, 2.º eje
found-centre-deviation-3 = desviación del centro, 3.er eje
found-diameter-deviation = desviación del diámetro
found-coordinate = coordenada medida
found-coordinate-deviation = desviación de la coordenada
found-position-1 = posición medida, 1.er eje
found-position-2 = posición medida, 2.º eje
found-position-3 = posición medida, 3.er eje
found-angle = ángulo medido
found-deviation-1 = desviación, 1.er eje
found-deviation-2 = desviación, 2.º eje
found-deviation-3 = desviación, 3.er eje
found-deviation-along = desviación según la normal
found-second-position-1 = 2.º punto: posición medida, 1.er eje
found-second-position-2 = 2.º punto: posición medida, 2.º eje
found-second-position-3 = 2.º punto: posición medida, 3.er eje
found-second-deviation-1 = 2.º punto: desviación, 1.er eje
found-second-deviation-2 = 2.º punto: desviación, 2.º eje
found-second-deviation-3 = 2.º punto: desviación, 3.er eje
found-second-diameter = 2.º círculo: diámetro medido
found-second-diameter-deviation = 2.º círculo: desviación del diámetro
found-rotation = rotación medida
found-side-1 = longitud medida, 1.er lado
found-side-2 = longitud medida, 2.º lado
found-width = anchura medida
found-centre-line = posición de la línea central
found-side-deviation-1 = desviación del 1.er lado
found-side-deviation-2 = desviación del 2.º lado
found-width-deviation = desviación de la anchura
found-good = dentro de tolerancia
found-rework = retrabajo
found-scrap = desecho
found-status = estado: -1 no definido, 0 bueno, 1 retrabajo, 2 desecho
cycle-note-machine-builder = el constructor de la máquina debe habilitar y adaptar este ciclo: véase el manual de la máquina
cycle-note-not-on-itnc530 = un iTNC 530 no tiene este ciclo; lo tienen TNC 320, TNC 620, TNC 640 y TNC7
cycle-note-normal-from-cad = tome la normal de un sistema CAD o CAM
cycle-note-software-option = el control necesita la opción de software { $option }
cycle-note-recommended = si el control tiene el ciclo { $cycle }, HEIDENHAIN recomienda ese
cycle-note-ends-rotation = termina un giro básico activo
remark-without-effect = { $key } se admite pero no tiene efecto
remark-tool-not-monitored = Q330 = { $tool }: la herramienta no se supervisa: no hay tabla de herramientas
remark-outside-dimension = se supone una medida exterior: por encima del máximo es retrabajo, por debajo del mínimo es desecho
remark-nominal-outside-limits = el diámetro nominal { $nominal } mm no está entre los límites: un TNC7 lo rechaza
remark-nominal-width-outside-limits = la anchura nominal { $nominal } mm no está entre los límites: un TNC7 lo rechaza
remark-nominal-coordinate-outside-limits = la coordenada nominal { $nominal } mm no está entre los límites: según su manual, un TNC7 puede rechazarlo
remark-contact-astray = { $count ->
    [one] el punto de palpación { $contact } está a { $distance } mm de donde palpa el ciclo: quizá sea de otro elemento
   *[other] { $count } puntos de palpación están lejos de donde palpa el ciclo, el punto { $contact } a { $distance } mm: quizá sean de otro elemento
}
remark-deviation-without-parameter = la desviación no tiene parámetro aquí: el manual dice que un control la guarda, pero no en cuál
remark-new-datum = nuevo punto de referencia, { $target }: { $axes } mm (medido → deseado)
datum-target-display = activo de inmediato
datum-target-active = corrección del punto de referencia activo
datum-target-preset = fila { $row } de la tabla de puntos de referencia
datum-target-table = fila { $row } de la tabla de puntos cero
remark-new-rotation = nuevo giro básico de { $angle }: { $target }
remark-axis-turned = el eje { $axis } gira la pieza { $angle }: solo la máquina sabe dónde está su centro, y Fitcheck no escribe su cero en ninguna tabla
remark-variable-holds-diameter = #i99 se lee como el diámetro: el manual no dice qué valor contiene
remark-no-tolerance = { $key } no es una tolerancia: no se evalúa nada

## The simulated machine
workpiece-file-toml = línea { $line }: { $said }
workpiece-file-too-large = un archivo de pieza de trabajo tiene como máximo { $most } KiB
workpiece-file-not-one = el archivo tiene { $found } de { $tables }: necesita exactamente una
workpiece-file-cannot-be = línea { $line }: { $error }
workpiece-file-several = el archivo tiene tablas [[feature]]: aquí se espera una pieza de trabajo con una sola superficie
workpiece-file-too-many = una pieza tiene como máximo { $most } elementos
workpiece-file-feature = línea { $line }, columna { $column }: { $feature }: { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } no es un tipo de elemento: los tipos son { $known }
feature-fault-no-key = { $kind } necesita { $key }
feature-fault-other-key = { $kind } no tiene { $key }
feature-fault-name = un nombre tiene de 1 a { $most } caracteres en una línea
feature-fault-same-name = otro elemento tiene el mismo nombre

# Figures of the simulated workpiece, as errors name them.
figure-temperature = temperatura
figure-expansion = dilatación
figure-probe-scatter = dispersión del palpador
figure-ball-radius = radio de la bola
figure-calibration-error = error de calibración
figure-offset = desplazamiento
figure-lobing = amplitud del prerrecorrido
figure-lobing-angle = ángulo del prerrecorrido
figure-lobing-count = lóbulos del prerrecorrido
figure-centre-x = centro x
figure-centre-y = centro y
figure-diameter = diámetro
figure-surface-scatter = dispersión de la superficie
figure-ovality = ovalidad
figure-ovality-angle = ángulo de ovalidad
figure-ovality-count = número de ovalidad
figure-lobe-height = altura de lóbulo
figure-lobe-angle = ángulo de lóbulo
figure-lobes = lóbulos
figure-point = punto
figure-normal = normal
figure-normal-length = longitud de la normal
figure-wave-length = longitud de onda
figure-wave-amplitude = amplitud de onda
figure-wave-direction = dirección de onda
figure-deviation = desviación
figure-radius = radio
figure-width = anchura
figure-first-length = 1.ª longitud
figure-second-length = 2.ª longitud
figure-angle = ángulo
figure-top = borde superior
figure-bottom = borde inferior
figure-length = longitud de las paredes
figure-reach = alcance
figure-stylus-radius = radio del vástago

## What of the probe touches.
mover-ball = la bola
mover-stylus = el vástago
