# The cycles page: the form of a measuring cycle, its workpiece, its path and its results.

page-cycles = Ciclos

cycles-cycle = Ciclo
cycles-choose = Ciclo { $number } { $name }
cycles-group-position = Posición
cycles-group-probing = Palpación
cycles-group-tolerance = Tolerancia
cycles-group-output = Salida
cycles-optional-position = Posición, opcional
cycles-optional-probing = Palpación, opcional
cycles-optional-tolerance = Tolerancia, opcional
cycles-optional-output = Salida, opcional
cycles-contacts-from = Puntos de
cycles-perfect = Pieza perfecta
cycles-simulated = Simulados
cycles-recorded = Grabados
cycles-workpiece = Pieza de trabajo…
cycles-suit = Adaptar pieza al ciclo
cycles-open-contacts = Puntos…
cycles-no-file = aún no hay archivo
cycles-contacts-of = { $count ->
    [one] { $count } punto de palpación
   *[other] { $count } puntos de palpación
    }, { $file }
cycles-probe = Palpador
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Tabla de palpación propia…
cycles-shipped-probes = Tabla integrada
cycles-run = Ejecutar
cycles-needed = obligatorio
cycles-none = ninguno
cycles-predef = PREDEF equivale a
cycles-predef-missing = PREDEF: escriba el valor que da GLOBAL DEF
cycles-without-effect = Se admite sin efecto
cycles-position = Posición de la bola
cycles-ball-stands = La bola está en
cycles-paste-block = Pegar frase NC…
cycles-copy-block = Copiar como frase NC
cycles-copy-results = Copiar los resultados
cycles-block-copied = La frase NC se ha copiado
cycles-block = Frase NC
cycles-block-hint = Pegue una frase como TCH PROBE 427 … Q263=+35 ;TEXT ~ o G785 R0 BR0 K2: sustituye al formulario
cycles-fill = Rellenar el formulario

cycles-nothing-seen = La trayectoria y los puntos de palpación aparecen tras la ejecución: pulse Intro o F5
cycles-allowed = Admitido: { $range } { $unit }
cycles-must-be-given = Obligatorio
cycles-may-be-left-out = Opcional
cycles-default = { $value } si se deja vacío
cycles-may-be-predef = Se admite PREDEF
cycles-path = Trayectoria de la bola
cycles-first = Primero
cycles-back = Atrás
cycles-next = Siguiente
cycles-last = Último
cycles-move = Movimiento
cycles-phase-pre-position = preposicionado
cycles-phase-approach = aproximación
cycles-phase-contact = palpación
cycles-phase-retract = retirada
cycles-phase-leave = salida
cycles-move-contact = { $number } de { $count }: { $phase } { $touch }, en { $to }
cycles-move-of-touch = { $number } de { $count }: { $phase }, punto de palpación { $touch }, de { $from } a { $to }
cycles-move-of-none = { $number } de { $count }: { $phase }, de { $from } a { $to }
cycles-criteria = Criterios comparados

cycles-word-stopped = No medido
cycles-word-no-verdict = Sin dictamen
cycles-no-limits = no se indicaron límites
cycles-no-limits-marked = no se indicaron límites; un control indica entonces «dentro de tolerancia»
cycles-more-out = { $what }, { $count } más abajo
cycles-no-window = Sin medidas límite: el control no muestra ninguna ventana de estado
cycles-results = Parámetros de resultado
cycles-log-file = El control escribe { $name }
cycles-log-screen = El control se detiene y muestra su protocolo en pantalla
cycles-log-shown = El control muestra el resultado en pantalla
cycles-save-log = Guardar protocolo…
cycles-dialog-save-log = Guardar el protocolo de medición
cycles-no-log = no hay protocolo que guardar
cycles-from-perfect = Medido en una pieza de trabajo perfecta en medida nominal, con un punto como palpador
cycles-from-simulated = Medido en la pieza de trabajo simulada, semilla { $seed }
cycles-from-recorded = Puntos de palpación de { $file }
cycles-unused = El ciclo dejó sin usar { $count ->
    [one] un punto de palpación
   *[other] { $count } puntos de palpación
    } del archivo

cycles-fields-wrong = { $count ->
    [one] un campo no se puede usar
   *[other] { $count } campos no se pueden usar
    }: véase el formulario
cycles-no-workpiece = la pieza de trabajo simulada no está completa
cycles-workpiece-wrong = pieza de trabajo simulada: { $problem }
cycles-workpiece-field = { $name }: { $problem }
cycles-no-contacts = aún no se ha abierto ningún archivo de puntos de palpación
cycles-cannot-suit = Aún no hay pieza de trabajo adecuada: { $problem }
cycles-not-written = la pieza de trabajo no se puede escribir: { $reason }
cycles-contacts-loaded = Se usan los puntos de palpación de { $name }
cycles-column-ignored = la columna { $column } se omite
cycles-probes-loaded = Se usa la tabla de palpación { $name }
cycles-dialog-contacts = Abrir puntos de palpación grabados
cycles-dialog-workpiece = Abrir una pieza de trabajo simulada
cycles-dialog-probes = Abrir una tabla de palpación
cycles-dialog-save-workpiece = Guardar la pieza de trabajo simulada

cycles-open-workpiece = Abrir…
cycles-save-workpiece = Guardar…
cycles-shape-bore = Agujero
cycles-shape-stud = Eje
cycles-shape-face = Cara
cycles-shape-point = Punto de superficie
cycles-shape-slot = Ranura
cycles-shape-ridge = Alma
cycles-shape-pocket = Cajera
cycles-shape-boss = Isla
cycles-plane = Plano
workpiece-probe = Palpador
workpiece-machine = Dispersión y temperatura
workpiece-centre-1 = Centro, 1.er eje
workpiece-centre-2 = Centro, 2.º eje
workpiece-ovality-angle = Ángulo de ovalidad
workpiece-lobe-angle = Ángulo de lóbulo
workpiece-point-x = Punto X
workpiece-point-y = Punto Y
workpiece-point-z = Punto Z
workpiece-normal-x = Normal X
workpiece-normal-y = Normal Y
workpiece-normal-z = Normal Z
workpiece-wave-height = Amplitud de onda
workpiece-wave-length = Longitud de onda
workpiece-wave-x = Dirección de onda X
workpiece-wave-y = Dirección de onda Y
workpiece-wave-z = Dirección de onda Z
workpiece-deviation = Desviación según la normal
workpiece-radius = Radio de la superficie
workpiece-width = Anchura
workpiece-length-1 = 1.ª longitud
workpiece-length-2 = 2.ª longitud
workpiece-angle = Ángulo de las paredes
workpiece-ball = Radio de la bola
workpiece-trigger = Dispersión de disparo 1σ
workpiece-calibration = Error de calibración
workpiece-offset-x = Desplaz. de la bola X
workpiece-offset-y = Desplaz. de la bola Y
workpiece-lobing-count = Lóbulos del prerrecorrido
workpiece-lobing = Amplitud del prerrecorrido
workpiece-lobing-angle = Ángulo del prerrecorrido
workpiece-temperature = Temperatura de la pieza
workpiece-expansion = Dilatación

cycles-choice-move-to-clearance-0 = a la altura de medición
cycles-choice-move-to-clearance-1 = a la altura de seguridad
cycles-choice-clearance-mode-minus-1 = nunca a la altura de seguridad
cycles-choice-clearance-mode-0 = antes y después del ciclo
cycles-choice-clearance-mode-1 = antes y después de cada objeto
cycles-choice-clearance-mode-2 = en cada punto
cycles-choice-traverse-0 = en línea recta
cycles-choice-traverse-1 = en arco
cycles-choice-contact-count-3 = puntos
cycles-choice-contact-count-4 = puntos
cycles-choice-contact-count-5 = puntos
cycles-choice-contact-count-6 = puntos
cycles-choice-contact-count-7 = puntos
cycles-choice-contact-count-8 = puntos
cycles-choice-contact-count-9 = puntos
cycles-choice-log-0 = sin protocolo
cycles-choice-log-1 = protocolo en un archivo
cycles-choice-log-2 = parada, protocolo en pantalla
cycles-choice-stop-0 = sin parada
cycles-choice-stop-1 = parada si fuera de tolerancia
cycles-choice-stop-on-undersize-0 = sin parada
cycles-choice-stop-on-undersize-1 = parada si fuera de tolerancia
cycles-choice-stop-on-undersize-2 = parada solo bajo el mínimo
cycles-choice-stop-on-scrap-0 = sin parada
cycles-choice-stop-on-scrap-1 = parada si fuera de tolerancia
cycles-choice-stop-on-scrap-2 = parada solo por desecho
cycles-choice-measured-axis-1 = eje principal X
cycles-choice-measured-axis-2 = eje auxiliar Y
cycles-choice-measured-axis-3 = eje del palpador Z
cycles-choice-axis-of-plane-1 = eje principal X
cycles-choice-axis-of-plane-2 = eje auxiliar Y
cycles-choice-direction-minus-1 = sentido negativo
cycles-choice-direction-1 = sentido positivo
cycles-choice-directed-axis-minus-3 = eje del palpador Z, sentido negativo
cycles-choice-directed-axis-minus-2 = eje auxiliar Y, sentido negativo
cycles-choice-directed-axis-minus-1 = eje principal X, sentido negativo
cycles-choice-directed-axis-1 = eje principal X, sentido positivo
cycles-choice-directed-axis-2 = eje auxiliar Y, sentido positivo
cycles-choice-directed-axis-3 = eje del palpador Z, sentido positivo
cycles-choice-tool-axis-probing-0 = queda igual
cycles-choice-tool-axis-probing-1 = se palpa y se fija
cycles-choice-transfer-minus-1 = no indicada
cycles-choice-transfer-0 = tabla de puntos cero
cycles-choice-transfer-1 = tabla de puntos de referencia
cycles-choice-preset-correction-0 = sin cambios
cycles-choice-preset-correction-1 = corregido con el punto
cycles-choice-preset-correction-2 = corregido con el 2.º punto
cycles-choice-preset-correction-3 = corregido con el punto medio
cycles-choice-compensation-axis-0 = eje del ángulo medido
cycles-choice-compensation-axis-4 = eje A
cycles-choice-compensation-axis-5 = eje B
cycles-choice-compensation-axis-6 = eje C
cycles-choice-zero-after-alignment-0 = conserva su valor
cycles-choice-zero-after-alignment-1 = marca cero
cycles-choice-rotary-alignment-0 = no se mueven
cycles-choice-rotary-alignment-1 = giran, el palpador acompaña
cycles-choice-rotary-alignment-2 = giran solos
cycles-choice-rotation-transfer-0 = no cambia nada
cycles-choice-rotation-transfer-1 = giro básico
cycles-choice-rotation-transfer-2 = desfase del eje rotativo
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = por dentro
cycles-choice-side-1 = por fuera
cycles-choice-geometries-0 = dos taladros
cycles-choice-geometries-1 = dos pivotes
cycles-choice-geometries-2 = un taladro y un pivote
cycles-choice-geometries-3 = un pivote y un taladro

## The tool table

tools = Tabla de herramientas
tools-none = ninguna
tools-open-one = { $name }, { $count ->
    [one] una herramienta
   *[other] { $count } herramientas
  }
tools-open = Abrir una tabla de herramientas…
tools-close = Sin tabla de herramientas
tools-save = Guardar tabla de herramientas…
tools-save-hint = La tabla con estos cambios. La próxima ejecución empieza con la tabla tal como se abrió.
tools-dialog-open = Abrir una tabla de herramientas
tools-dialog-save = Guardar la tabla de herramientas modificada
tools-loaded = Se usa la tabla de herramientas { $name }
tools-pick = elegir una herramienta
tools-pick-of = { $parameter } de la tabla de herramientas
tools-input = { $parameter } Herramienta que se supervisa (Q330)
tools-fixed = Q330 = { $tool } en el programa
tools-more = { $count ->
    [one] una herramienta más
   *[other] { $count } herramientas más
  }
tools-row = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, bloqueada
tools-without-name = { $count ->
    [one] una herramienta no se muestra: su nombre no la identifica
   *[other] { $count } herramientas no se muestran: su nombre no las identifica
  }
tools-not-in-table = Q330 = { $tool }: la tabla de herramientas no tiene esa herramienta
tools-not-monitored = Sin tabla de herramientas no se supervisa ninguna herramienta (Q330)
tools-none-named = Q330 no nombra ninguna herramienta: la tabla de herramientas no se usa
tools-no-deviation = el valor medido no se desvía: la herramienta no cambia
tools-changed = Cambios en la tabla de herramientas
tools-nothing-changed = ninguna ejecución ha cambiado la tabla de herramientas

## A part of several features

cycles-part-refused = el archivo tiene tablas [[feature]]: un ciclo por sí solo mide una superficie; la página de programas y fitcheck run miden una pieza así
part-features = Elementos de la pieza
part-of-features = { $name }, { $count ->
    [one] un elemento
   *[other] { $count } elementos
  }, radio de la bola { $ball } mm
part-round = { $name }: { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name }: { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name }: { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name }: { $kind } X { $x } Y { $y } Z { $z }
