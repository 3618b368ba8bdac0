# Running NC programs.

## Paths and files
machine-path-empty = la ruta está vacía
machine-path-too-long = la ruta tiene más de { $most } caracteres, lo que un control no admite
machine-path-other-root = { $path } no es una ruta de TNC: ni una ruta desde la carpeta del programa
machine-path-leads-out = { $path } sale de la carpeta
machine-path-no-name = { $name } en { $path } no es un nombre de archivo o carpeta
machine-store-missing = archivo no encontrado: { $path }
machine-store-outside = { $path } sale de las carpetas indicadas
machine-store-no-file = { $path } no es un archivo
machine-store-too-large = { $path } es mayor que { $most } MiB
machine-store-ambiguous = { $path } existe con varias grafías, { $names }, pero un control tiene un solo archivo de cada nombre: quite los otros o cámbieles el nombre
machine-store-elsewhere = { $path } no está en la carpeta de salida: un programa solo borra archivos allí
machine-store-read-only = no se ha elegido ninguna carpeta de salida
machine-store-system = { $path }: { $reason }

## Faults
machine-fault-in-block = { $program }, frase { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, línea { $line }, { $text }: { $fault }
machine-used-blocks = alcanzado el límite de { $most } frases: posible bucle sin fin
machine-used-label-calls = alcanzado el límite de { $most } llamadas a label anidadas: ¿se llama el programa a sí mismo?
machine-used-program-calls = alcanzado el límite de { $most } llamadas a programa anidadas: ¿se llama el programa a sí mismo?
machine-used-windows = alcanzado el límite de { $most } ventanas
machine-used-outputs = alcanzado el límite de { $most } salidas a archivo
machine-used-output-files = alcanzado el límite de { $most } archivos de salida
machine-used-folders = alcanzado el límite de { $most } carpetas para archivos de salida
machine-used-table-writes = alcanzado el límite de { $most } escrituras de tablas modificadas
machine-used-output = alcanzado el límite de { $most } bytes impresos
machine-used-cycles = alcanzado el límite de { $most } mediciones
machine-used-path = alcanzado el límite de { $most } movimientos
machine-used-files = alcanzado el límite de { $most } programas y tablas modificadas abiertos
machine-used-traffic = alcanzado el límite de { $most } bytes leídos y escritos
machine-used-file-bytes = los programas y las tablas modificadas superan juntos { $most } bytes
machine-text-too-long = el texto tiene { $length } caracteres, un parámetro admite como máximo { $most }
machine-unknown-block = frase desconocida: Fitcheck ejecuta solo lo que entiende
machine-unknown-cycle = Fitcheck no sigue el ciclo { $cycle }, aunque el control lo tenga: sigue { $known }
machine-file-open = { $path } está abierto como tabla de FN 26: no se puede copiar, mover ni borrar
machine-broken = el programa está dañado: falta { $what }
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } no es un label
machine-no-tool-data = { $parameter } no está definido: contiene una medida de la herramienta en el husillo, que da una tabla de herramientas
machine-undefined = { $parameter } no está definido
machine-lost = { $parameter } no está definido: la línea { $line }, { $text }, puede fijarlo y no se ejecutó
machine-file-unknown = { $path } no se lee: la línea { $line }, { $text }, puede escribirlo o quitarlo y no se ejecutó
machine-tools-unknown = la herramienta no se corrige: la línea { $line }, { $text }, puede cambiar la tabla de herramientas y no se ejecutó
machine-contacts-unknown = no se sabe qué puntos de palpación grabados son de este ciclo: algunos pueden ser de la línea { $line }, { $text }, que no se ejecutó
machine-not-skipped = esta frase decide qué se ejecuta después o qué recibe otro programa: no se puede omitir
machine-whole-only = { $parameter } contiene solo números enteros, no { $value }
machine-no-answer = INPUT "{ $question }" pide { $parameter }: dele un valor antes de la ejecución
machine-no-parameter = el parámetro { $parameter } no existe: Q y QS llegan hasta 1999, QL y QR hasta 499
machine-no-variable = la variable { $variable } no existe: { $family } va de { $least } a { $most }
machine-not-number = { $parameter } contiene un texto: se esperaba un número
machine-not-text = { $parameter } contiene un número: se esperaba un texto
machine-division-by-zero = división por cero
machine-negative-root = la raíz cuadrada de { $value } no está definida
machine-no-result = { $function } { $value } no está definido
machine-beyond-range = { $value } está fuera del campo de valores, de -10^10 a 10^10
machine-not-whole = { $what } = { $value }: se esperaba un número entero desde 0
machine-counted-row = fila
machine-counted-word = { $word }
machine-behind-text = el texto tiene { $length } caracteres: la posición { $from } está después de su final
machine-no-number-in-text = { $parameter } = "{ $text }" no es un número
machine-unknown-system-text = texto de sistema desconocido ID{ $id } NR{ $number }: solo se admiten fecha y hora (ID10321)
machine-no-table = no hay ninguna tabla abierta
machine-several-columns = { $parameter } = { $text } nombra varias columnas: con un parámetro de texto solo se puede leer una
machine-no-column = la tabla { $table } no tiene la columna { $column }; sus columnas son { $columns }
machine-no-row = la tabla { $table } no tiene la fila { $row }: sus filas van de 0 a { $last }
machine-no-rows = la tabla { $table } no tiene filas
machine-empty-cell = tabla { $table }, fila { $row }, columna { $column }: la celda está vacía
machine-no-number-in-cell = tabla { $table }, fila { $row }, columna { $column }: { $cell } no es un número
machine-touches = tabla { $table }, fila { $row }, columna { $column }: la celda toca a su vecina, así que su valor es incierto
machine-table-write = tabla { $table }: { $error }
machine-mask = máscara { $mask }: { $error }
machine-programmed = el programa se detuvo a sí mismo con el error { $number }
machine-no-cycle-parameter = el ciclo { $cycle } no tiene el parámetro { $parameter }
machine-cycle-parameter-twice = ciclo { $cycle }: { $parameter } se da dos veces
machine-cycle-parameter-for = ciclo { $cycle }: { $parameter } se da dos veces, y { $other } ninguna: ¿el segundo debía ser { $other }?
machine-global-not-number = GLOBAL DEF { $number }: { $parameter } no tiene número
machine-global-twice = GLOBAL DEF { $number }: { $parameter } se da dos veces
machine-open-subprogram = el programa termina dentro del subprograma llamado en la línea { $line }: falta LBL 0
machine-repeat-ahead = REP repite la parte entre un label y esta frase, pero el label viene después, en la línea { $line }
machine-cycle = ciclo { $cycle }: { $error }
machine-workpiece = pieza de trabajo: { $error }
machine-no-tool-call = ningún TOOL CALL con eje de la herramienta precede a este ciclo de medición
machine-mode = el control está en modo { $mode }: los ciclos de medición funcionan solo en modo de fresado (FUNCTION MODE MILL)
machine-changed = desde la línea { $line }, { $text }, está en vigor { $change }: mientras tanto Fitcheck no mide
machine-nothing-selected = ningún SEL PGM precede a CALL SELECTED PGM
machine-no-datum-table = el punto de referencia iría a la fila { $row } de la tabla de puntos cero activa (Q303 = 0), que solo tiene el control: aquí no se puede medir nada desde él
machine-datum-in-tilt = desde la línea { $line }, { $text }, el plano está inclinado: Fitcheck no fija en él ningún punto de referencia, porque no se sabe qué escribe ahí un control; anule el plano antes del ciclo (PLANE RESET)
machine-point-without-part = los ciclos 0 y 1 palpan un único punto, y una pieza perfecta no tiene ninguno: elija una pieza simulada o contactos registrados
machine-point-from-nowhere = el lugar donde empieza la palpación no se conoce en todos los ejes: escriba X, Y y Z en la frase
machine-no-preset = { $table } no tiene la fila { $row }
machine-preset-locked = { $table }: la fila { $row } está bloqueada, el ciclo no puede escribirla
machine-shifted-preset = la fila { $row } es el punto de referencia activo y hay un desplazamiento del punto cero activo: no se sabe qué hace un control con él
machine-change-not-known = un punto cero desconocido
machine-change-turning = el sistema girado del ciclo 800
machine-change-datum-table = un desplazamiento de una tabla de puntos cero
machine-change-rotation = un giro
machine-change-mirror = un espejo
machine-change-scaling = un factor de escala
machine-change-axis-scaling = un factor de escala específico de cada eje
machine-change-tilt = un plano de mecanizado inclinado
machine-change-tilted-shift = un desplazamiento de un plano que ya no está inclinado
machine-change-axis-turned = un giro de la pieza con un eje rotativo, sin un punto de referencia nuevo en los dos ejes del plano desde entonces,

## Remarks
machine-file-from = { $path } se leyó de { $file }
machine-file-given = { $path } se leyó
machine-file-built-in = { $path } está integrado
machine-remark-skipped = frase desconocida omitida
machine-remark-cycle-passed-over = este ciclo calibra el palpador o mide una herramienta: se pasó por alto. Lo que devuelve no está definido desde aquí, salvo que se haya dado antes de la ejecución (--set Q115=0)
machine-remark-measurement-skipped = esta medición se omitió: sus resultados no están definidos desde aquí
machine-remark-datum-skipped = esta medición se omitió: sus resultados no están definidos desde aquí, y después no se mide nada, porque puede fijar un punto cero
machine-remark-not-followed = esta frase no se ejecuta y puede cambiar el punto cero: después no se mide nada
machine-remark-no-system-data = { $parameter } no está definido desde aquí: los datos de sistema de FN 18 solo los conoce un control
machine-remark-axis-assumed = ningún TOOL CALL precede a este ciclo: medido a lo largo de Z con el primer palpador
machine-remark-measured-again = remedido después del retrabajo: cuenta esta medición
machine-remark-spindle-turns = el cabezal gira desde M{ $function }: un control no palparía
machine-remark-rotary-moved = { $axes } se movió antes de este ciclo: la pieza de trabajo se midió como si no se hubiera girado
machine-remark-other-preset = punto de referencia { $number }: se supone que la pieza de trabajo está también allí
machine-remark-rotation-ended = el giro básico de { $angle } ha terminado: este ciclo mide sin él, y no vuelve
machine-remark-axes-as-tilted = el plano está inclinado: se supone que los ejes rotativos están como este los necesita
machine-remark-machine-zero-assumed = FN 18 pide un lugar desde el cero de la máquina: aquí no se sabe dónde está, y se cuenta desde el de la pieza
machine-remark-datum-set = punto de referencia fijado: su cero está ahora en { $zero } mm en las coordenadas de la pieza de trabajo
machine-remark-preset-set = fila { $row } de la tabla de puntos de referencia fijada en { $zero } mm en las coordenadas de la pieza de trabajo: actúa con el ciclo 247
machine-remark-active-preset-set = la fila { $row } es el punto de referencia activo: su cero está ahora en { $zero } mm en las coordenadas de la pieza de trabajo; en una iTNC 530 solo tras el ciclo 247
machine-remark-presets-left = { $path } queda como está: ningún ciclo 247 anterior dice qué fila está activa, así que no se sabe dónde está la pieza de trabajo en la máquina
machine-remark-shift-ended = el desplazamiento del punto cero termina en { $axes } sin que se haya medido allí, como en una TNC7: una iTNC 530 quizá lo conserve
machine-remark-built-in = { $path } no está entre los archivos indicados: se leyó el integrado
machine-remark-other-names = se leyó { $read }, pero también existe { $others }: un control tiene un solo archivo de cada nombre
machine-remark-read = { $path }: { $what }
machine-remark-other-spelling = la tabla { $table } no tiene la columna { $column }: se usó { $other }, la otra grafía de NC-Solution 8255
machine-remark-row-number = tabla { $table }: NR es { $found } en la fila { $row }: FN 27 y FN 28 cuentan las filas desde 0
machine-remark-length-converted = tabla { $table }: la columna { $column } es LENGTH y se convirtió entre mm y pulgadas
machine-remark-ended-within = M{ $function } en un programa llamado terminó la ejecución: un control no lo admite allí
machine-remark-given-wins = { $parameter } = { $value } se dio antes de la ejecución y sustituye el valor de esta frase
machine-remark-given-without-effect = { $parameter } se dio antes de la ejecución y no tuvo efecto: ninguna frase lo leyó
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = la frase no indica { $parameters }: se usaron estos valores, pero un control puede rechazar la frase
machine-remark-measurement-behind-end = { $count ->
        [one] un ciclo de medición viene
       *[other] { $count } ciclos de medición vienen
    } después de esta frase, donde un control deja de leer: después no se midió nada
machine-remark-cycle-skipped = este ciclo de medición se omitió como se pidió, por la / que lo precede
machine-remark-rounded = tabla { $table }, columna { $column }: { $value } se redondeó a { $written }
machine-remark-not-judged = aquí no hay dictamen: no se comparó nada con límites
machine-remark-not-written = { $path } no se escribió: no se ha elegido ninguna carpeta de salida
machine-remark-deleted = { $path } fue borrado por el programa
machine-remark-not-deleted = { $path } no se borró: no se ha elegido ninguna carpeta de salida
machine-remark-other-device = { $given } es otro dispositivo: el archivo es { $path }
machine-remark-screen-meant = SCREEN se toma como nombre de un archivo: ¿se quería decir SCREEN:?
machine-remark-empty-mask = la máscara { $mask } está vacía: también lo que imprime
machine-remark-not-saved = { $path } no se escribió: { $reason }
machine-remark-full = { $path } ha alcanzado su límite de { $kilobytes } kilobytes: no se añadió nada
machine-remark-table-written = { $path } se escribió
machine-remark-contacts-left = los ciclos usaron { $used } de { $count } puntos de palpación grabados
machine-remark-more = más observaciones que no se muestran: { $count }
machine-remark-empty-spindle = se llamó la herramienta 0: un TNC7 no tiene entonces palpador en el cabezal
machine-remark-no-tool-named = ningún TOOL CALL anterior a este ciclo nombra una herramienta: medido con el primer palpador
machine-remark-tool-call-words = TOOL CALL no admite { $words }: omitido
machine-remark-no-nominal = el ciclo no tiene medida nominal: el palpador encuentra la pieza de trabajo perfecta a la mitad de K
machine-remark-other-probe = la herramienta { $tool } no está en la tabla de palpación: se usó el palpador { $probe }
machine-remark-collision = { $mover } tocaría { $feature }, con el centro de la bola en X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = los movimientos no se revisan por completo frente a { $features }
machine-remark-stylus-unchecked = el vástago no se revisa por colisiones: no está a lo largo de Z
machine-remark-tool-offsets = { $offsets } del TOOL CALL no cambia el palpador simulado
machine-remark-tool-locked = la herramienta { $tool } está bloqueada en la tabla de herramientas
machine-remark-no-probe-tool = la herramienta { $tool } no es un palpador: TYP = { $kind }, se esperaba { $probe }
machine-remark-no-such-tool = la herramienta { $tool } no está en la tabla de herramientas
machine-remark-same-name = { $more ->
    [one] otra herramienta tiene el nombre { $tool }
   *[other] otras { $more } herramientas tienen el nombre { $tool }
}: se usó la primera de la tabla de herramientas
machine-remark-content-uncertain = { $parameter } se lee aquí, pero no está documentado que contenga el diámetro
machine-remark-not-waited = { $parameter } se lee sin G909 después del ciclo: un control lee frases por adelantado y puede no haber medido aún
machine-remark-position-unknown = no se conoce la posición antes del ciclo: sin D empieza en el centro nominal, sin WB a la altura 0

machine-passed-over = { $count } { $count ->
        [one] frase
       *[other] frases
    } sin efecto (ninguna medición depende de { $count ->
        [one] ella
       *[other] ellas
    }): { $list }

## Pauses
machine-pause-stop = el programa se ha detenido: STOP o M0
machine-pause-optional-stop = el programa se ha detenido: M1
machine-pause-breakpoint = la frase siguiente tiene un punto de parada
machine-pause-log = el protocolo de medición está en la pantalla (Q281 = 2)

## A block of a measuring cycle without its program
alone-moved = { $text } desplaza el ciclo de palpación que sigue o cambia sus ejes, pero el ciclo se ejecuta como si no lo hiciera: ejecute el programa entero
alone-called = { $text } ejecuta frases que pueden desplazar el ciclo de palpación que sigue, pero no se leen: ejecute el programa entero
alone-not-understood = { $text } no se entiende y puede desplazar el ciclo de palpación que sigue: revise el programa, o ejecútelo entero
alone-not-run = el programa no pasa de { $text } y no llega al ciclo de palpación que sigue, así que un control no mide aquí: revise el programa
alone-passed = { $text } puede saltarse el ciclo de palpación, así que un control puede no medir aquí: ejecute el programa entero
alone-skipped = un control puede omitir el ciclo de palpación por la / que lo precede: si debe medirse, borre la /
