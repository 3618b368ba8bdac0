## The program page

page-program = Programas
program-page-dialog-open = Abrir un programa NC
program-page-choice = Programa NC
program-page-open = Abrir…
program-page-not-shipped = { $name } no está incluido en esta versión
program-page-nothing = No hay ningún programa abierto
program-page-listing = { $name }, { $count ->
    [one] { $count } frase
   *[other] { $count } frases
  }

program-page-run = Ejecutar
program-page-pause = Pausa
program-page-step = Frase a frase
program-page-step-over = Saltar llamada
program-page-to-selected = Al cursor
program-page-breakpoint = Punto de parada
program-page-reset = Reiniciar
program-page-move = Ir a otra frase
program-page-speed = Velocidad
program-page-speed-slow = 4 frases/s
program-page-speed-medium = 20 frases/s
program-page-speed-fast = máxima
program-page-options = Opciones
program-page-skip-unknown = Omitir frases desconocidas
program-page-assume-tool = Palpar en Z sin TOOL CALL
program-page-block-skip = Omitir frases con /
program-page-optional-stop = Parar en M1
program-page-outline-none = título o label
program-page-outline = Ir a

program-page-state-ready = Listo para ejecutar
program-page-state-running = En ejecución
program-page-state-paused = En pausa
program-page-state-step = Frase a frase
program-page-state-breakpoint = En pausa en un punto de parada
program-page-state-goal = En pausa en el cursor
program-page-state-over = En pausa después de la llamada
program-page-state-stop = El programa se detuvo a sí mismo: Ejecutar continúa
program-page-state-optional-stop = El programa se detuvo a sí mismo con M1: Ejecutar continúa
program-page-state-tolerance = Fuera de tolerancia: { $stop }
program-page-state-log = El protocolo está en la pantalla: Ejecutar continúa
program-page-state-ended = Terminado después de { $blocks } frases
program-page-state-fault = Detenido con un error
program-page-refused-inputs = Una entrada no se puede leer
program-page-refused-none = No hay ningún programa abierto
program-page-refused-workpiece = La pieza de trabajo no se puede leer
program-page-refused-no-contacts = No hay puntos de palpación abiertos

program-page-has-breakpoint = punto de parada
program-page-is-current = frase siguiente
program-page-is-failed = error aquí

program-page-inputs = Entradas
program-page-answers = Fitcheck y el programa
program-page-program = Programa
program-page-verdict = Dictamen
program-page-no-limits = Sin límites: una entrada no se puede leer
program-page-agrees = El programa coincide con Fitcheck
program-page-contested = Programa { $program }, Fitcheck { $own }
program-page-contested-limits = Programa { $program }, con límites distintos de los de Fitcheck
program-page-stopped-at = Detenido con un error; hasta ahora { $program }
program-page-differs = El programa difiere: { $what }
program-page-differs-minimum = su mínimo es { $program } mm, el de Fitcheck { $own } mm
program-page-differs-maximum = su máximo es { $program } mm, el de Fitcheck { $own } mm
program-page-differs-status = dice { $program }, Fitcheck dice { $own }
program-page-differs-fault = se detuvo con un error
program-page-differs-native-refuses = dio un dictamen, Fitcheck no tiene límites
program-page-other-inputs = Sin comparar: el programa ha fijado después otras entradas y mide otro elemento
program-page-both-refuse = Ni el programa ni Fitcheck dan un resultado

program-page-workpiece = Pieza de trabajo
program-page-from-perfect = perfecta, centro de los límites
program-page-from-nominal = perfecta, en nominal
program-page-from-given = perfecta, diámetro indicado
program-page-from-simulated = simulada
program-page-from-part = pieza de varios elementos
program-page-open-part = Abrir una pieza…
program-page-dialog-part = Abrir una pieza simulada de varios elementos
program-page-refused-no-part = No hay ninguna pieza abierta
program-page-from-recorded = puntos de palpación grabados
program-page-workpiece-x = Centro real X
program-page-workpiece-y = Centro real Y
program-page-edit-workpiece = Pieza de trabajo y palpador…
program-page-open-contacts = Otros puntos…
program-page-recorded = { $count ->
    [one] { $count } punto de palpación
   *[other] { $count } puntos de palpación
  } de { $name }
program-page-path = Trayectoria del palpador
program-page-no-path = Aún sin trayectoria
program-page-zero = Cero X { $x }, Y { $y }, Z { $z } mm
program-page-turned = girado { $angle }°
program-page-tilted = inclinado A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = El programa no ha abierto ninguna ventana
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, SIMULADO
program-page-cycles = Medido
program-page-show-block = Mostrar la frase
program-page-last-of = Los últimos { $shown } de { $all }
program-page-outputs = Archivos
program-page-outputs-hint = Se muestran aquí, no se escriben en disco

program-page-parameters = Parámetros
program-page-filter = Filtro
program-page-set = Empezar con
program-page-value = Valor
program-page-give = Fijar
program-page-give-hint = La próxima ejecución empieza con este valor
program-page-given = Fijado para la próxima ejecución
program-page-drop = quitar
program-page-no-parameter = { $given } no es un parámetro: escriba Q5, QL5, QR5 o QS5
program-page-no-number = { $given } no es un número
program-page-none-found = Ningún parámetro coincide
program-page-no-parameters = Los parámetros aparecen cuando el programa se ejecuta
program-page-undefined = no definido
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, cambiado
program-page-pin = Mantener { $parameter } arriba
program-page-unpin = No mantener { $parameter } arriba
program-page-q108 = radio de la herramienta
program-page-q109 = eje de herramienta: 0 X, 1 Y, 2 Z
program-page-q110 = husillo: 0 M3, 1 M4, 2 o 3 parado después
program-page-q111 = refrigerante: 0 apagado, 1 encendido
program-page-q113 = unidad: 0 mm, 1 pulgada
program-page-q114 = longitud de la herramienta
program-page-q115 = posición palpada, X
program-page-q116 = posición palpada, Y
program-page-q117 = posición palpada, Z
program-page-q150 = ángulo medido

program-page-problems = { $count ->
    [one] { $count } observación
   *[other] { $count } observaciones
  }
program-page-unlisted = { $count ->
    [one] { $count } más no se muestra
   *[other] { $count } más no se muestran
  }
program-page-at-block = frase { $number }: { $what }
program-page-at-line = línea { $line }: { $what }

program-page-create = Crear para un control…
program-page-create-hint = Programas NC, tablas y máscara con los que un control mide por sí mismo
program-page-create-also = escribir crear programas NC archivos juego
program-page-create-head = Crear para un control
program-page-create-control = Control
program-page-create-language = Idioma de diálogo
program-page-create-from = A partir de
program-page-create-series = Para una serie: cada arranque mide la pieza siguiente
program-page-create-texts = Tolerancias de los diámetros como textos del ciclo
program-page-create-callout = { $callout } de Comprobación, en X { $x } Y { $y } Z { $z }
program-page-create-no-callout = La cota de Comprobación
program-page-create-plan = Plan { $name }, { $count ->
    [one] { $count } elemento
   *[other] { $count } elementos
  }
program-page-create-nothing = Escriba una cota en Comprobación, o abra un plan en Piezas
program-page-create-plan-wrong = { $name } tiene errores: abra el plan en Piezas y corríjalos
program-page-create-folder = Carpeta en el control: { $folder }
program-page-create-proven-callout = Releído y ejecutado: { $callout } recibe exactamente los límites de Fitcheck
program-page-create-proven-plan = Releído y ejecutado: cada elemento recibe los límites del plan
program-page-create-clearance-height = La altura de seguridad es { $height } mm; en un plan, la fija una columna
program-page-create-files-none = Crear archivos…
program-page-create-files = Crear { $count ->
    [one] { $count } archivo…
   *[other] { $count } archivos…
  }
program-page-dialog-create = Crear archivos para un control: elegir o nombrar una carpeta
program-page-create-written = { $count ->
    [one] Se escribió { $count } archivo
   *[other] Se escribieron { $count } archivos
  } en { $folder }: { $names }
program-page-create-no-folder = { $name } es un archivo: indique una carpeta
program-page-contacts-left = Los puntos de palpación de { $name } son del programa anterior: este mide una pieza de trabajo perfecta
program-page-unfinished = Sin comparar: el programa no llegó a su final
program-page-unknown = { $fault }. Para seguir sin ello, active Opciones → Omitir frases desconocidas
program-page-missing-file = { $fault }. Se buscó en { $folder } y entre los archivos integrados. Póngalo allí, junto al programa, o abra el programa en la carpeta que lo tiene
program-page-unknown-datum = { $fault }. Sin su punto cero no se mide nada. Para probar, abra una copia del programa sin la frase que lo fija, y una pieza de trabajo vista desde ese punto cero
program-page-not-written = { $path } se escribiría en el control. Su texto está en Archivos; en la línea de comandos lo escribe fitcheck run --output-folder
program-page-no-verdict = Sin límites, sin dictamen
