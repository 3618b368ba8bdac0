# The window: labels, buttons, headings. Sentence case, no colon after a label, an ellipsis on what opens a dialog.

page-check = Comprobación
page-fit = Ajustes
page-tables = Tablas
import = Importar…
export = Exportar
export-people = Informe de inspección ({ $format })…
export-programs = Historial como { $format }…
export-status-check = Ventana de estado de Comprobación como texto…
export-status-cycle = Ventana de estado del ciclo { $cycle } como texto…
export-status-program = Ventana del programa como texto…
menu = Menú
language = Idioma
theme = Aspecto
theme-system = Según el sistema
theme-light = Claro
theme-dark = Oscuro
theme-contrast = Alto contraste sobre blanco
theme-inverted = Alto contraste sobre negro
density = Tamaño de los mandos
density-by-use = Automático
density-mouse = Ratón
density-touch = Táctil
limits-from = Límites según
standard-js-rounded = Redondear hacia abajo los medios micrómetros de JS, como en 1988
standard-1988 = cd, ef y fg solo hasta 10 mm, como en 1988
load-tables = Tablas propias…
no-own-tables = Dejar de usar las tablas propias
load-mask = Máscara propia…
undo = Deshacer
undo-what = Deshacer: { $what }
undo-add = { $count ->
    [one] añadir 1 comprobación
   *[other] añadir { $count } comprobaciones
}
undo-correct = corrección
undo-feature = agujero o eje
undo-clear = vaciar el historial
undone = Deshecho: { $what }
clear-history = Vaciar el historial
choose-bad = { $count ->
    [0] Elegir las comprobaciones no buenas
    [one] Elegir la comprobación no buena
   *[other] Elegir { $count } comprobaciones no buenas
}
choose-none = No elegir ninguna

callout = Cota
callout-hint = Escriba una medida nominal y una clase, por ejemplo 25 H7
feature-hole = Agujero
feature-shaft = Eje
feature-neither = Ninguno de los dos
nominal-is = medida nominal { $nominal } mm
maximum = Máximo
minimum = Mínimo
from-source = de { $source }
source-overrides = Tabla propia: ISO 286 tiene { $upper } / { $lower } µm, la diferencia es de { $by-upper } / { $by-lower } µm
measured-value = Valor medido
measured-once = Ya evaluado. Para volver a evaluar el mismo valor, escríbalo de nuevo o pulse el botón
by-typing = Escribir
by-simulating = Simular
judge = Evaluar
measure = Medir
clear = Borrar
nominal-size = Medida nominal
tolerance-class = Clase
class-none = Elegir
classes-hole = Clases de agujero
classes-shaft = Clases de eje
part-section = Pieza
part-name = Pieza o elemento

probe-position = Posición de palpación
centre-x = Centro X
centre-y = Centro Y
height-z = Altura Z
first-contact = Primer punto
clearance = Dist. de seguridad
centre-tolerance = Tolerancia centro ±
simulated-workpiece = Pieza de trabajo simulada
simulated-hint = Sin diámetro se toma el centro de la zona. La semilla aumenta después de cada medición; con la misma semilla resultan los mismos puntos de palpación.
true-diameter = Diámetro real
seed = Semilla
offset-x = Desplazamiento X
offset-y = Desplazamiento Y
ovality = Ovalidad
lobes = Lóbulos
lobe-height = Altura de lóbulo
surface-scatter = Dispersión superf. 1σ
probe-scatter = Dispersión palpador 1σ

field-range = { $given } está fuera de −{ $limit } a { $limit }
field-not-negative = { $given } es menor que 0: se admite de 0 a { $limit }
field-above-zero = { $given } no es mayor que 0: se admite hasta { $limit }
field-not-whole = { $given } no es un número entero

limit-band = Banda de límites
band-example = un ejemplo: { $callout }, un agujero
band-empty = La banda de límites aparece con los límites
band-describe = Desviación respecto a la medida nominal en micrómetros: zona de { $lower } a { $upper }, { $left } por debajo, { $right } por encima.
band-describe-measured = Medido { $deviation }, { $above } por encima del mínimo, { $below } por debajo del máximo.
side-rework = retrabajo
side-scrap = desecho
side-out = fuera de límites

last-values = Últimos valores
last-values-empty = Aquí aparecen los últimos valores de estos límites
last-values-describe = { $count ->
    [one] El último valor, el más reciente al final:
   *[other] Los últimos { $count } valores, el más reciente al final:
}
contacts = Puntos de palpación
contacts-factor = desviaciones × { $factor }
contacts-empty = Los puntos de palpación aparecen con la medición
contacts-describe = { $count } puntos de palpación vistos desde arriba, desviaciones ampliadas { $factor } veces. { $circle }
centre-is = centro { $x } / { $y }

word-none = Sin resultado
nothing-measured = No se ha medido nada
judged-without-own = Evaluado sin las tablas propias
word-question = ¿Es correcto?
simulated = SIMULADO
status-simulated = { simulated }: { $status }
judge-anyway = Evaluar { $measured } mm tal cual
take-meant = Usar { $meant } mm
take-text = Usar { $meant }
keep-text = Usar { $given } tal cual
doubted-enter = Intro usa el botón resaltado; al escribir se sustituye el texto
doubted-type = No se evalúa nada hasta que el texto se escriba de nuevo o se use tal cual
question-enter = Tras medio segundo, Intro pulsa el botón relleno; al escribir se sustituye el valor
doubt-sentence = { $doubt }
lot-title = { $rows ->
    [one] { $name }: 1 fila
   *[other] { $name }: { $rows } filas
}
lot-unjudged = { $count } sin evaluar
lot-refused = { $count ->
    [one] 1 fila no admitida
   *[other] { $count } filas no admitidas
}
lot-doubted = { $count ->
    [one] 1 valor dudoso
   *[other] { $count } valores dudosos
}
lot-shown = Se muestra: { $place } de { $judged }, el peor primero; línea { $line }
lot-shown-part = Se muestra: { $place } de { $judged }, el peor primero; línea { $line }, pieza { $part }
lot-worst = El peor
lot-worse = Peor
lot-better = Mejor
lot-best = El mejor
lot-count = { $status } { $count }
above-minimum = { $um } µm sobre el mínimo
below-minimum = { $um } µm bajo el mínimo
below-maximum = { $um } µm bajo el máximo
above-maximum = { $um } µm sobre el máximo
remove-amount = Quitar { $um } µm
remove-to-limit = hasta el límite
remove-to-limit-per-side = hasta el límite, { $um } µm por lado
remove-to-middle = { $um } µm hasta el centro de la zona
position-in = Centro en posición
position-out = Centro fuera de posición
diameter-alone = Solo el diámetro: { $status }
first-steps = Primeros pasos
first-steps-title = ¿Es la primera vez?
first-steps-about = Esta configuración se conserva.
first-steps-done = Listo
first-way-part = Una pieza completa
first-way-part-about = Elemento por elemento, según un plan con imagen.
first-way-file = Un archivo de valores
first-way-file-about = CSV, un libro de cálculo, QIF, AQDEF o un protocolo de medición.
first-way-program = Sin máquina
first-way-program-about = Un programa NC o un ciclo mide un agujero simulado, punto por punto.
first-step-callout = 1. Cota: lo que indica el plano
first-step-value = 2. Valor medido: escrito, simulado o de un archivo
first-step-verdict = 3. Dictamen, y cuánto hay que quitar
why = ¿Por qué?
why-limits = Límites de { $what }
why-measured = Valor medido: { $what }
why-rule = Regla: { $what }
why-caveat = Limitación de esta medición: { $what }

popup-title = Ventana de estado
popup-title-accepted = Ventana de estado: fuera de los límites, aceptado por la regla
popup-title-simulated = Ventana de estado, SIMULADO
popup-exact = La ventana redondea a cuatro decimales. Valores exactos: { $values }
popup-empty = Aún no hay medición
copy = Copiar
mask-choice = Máscara
mask-choice-of-language = Idioma de la ventana
mask-choice-own = Máscara propia…

history = Historial
history-count = { $count ->
    [0] ninguna comprobación
    [one] 1 comprobación
   *[other] { $count } comprobaciones
}
history-chosen = elegidas para exportar: { $count }
history-hidden = de ellas sin mostrar: { $hidden }
history-shown = { $shown } de { $count ->
    [one] 1 comprobación
   *[other] { $count } comprobaciones
}
history-exported-listed = { $count ->
    [0] No se muestra ninguna comprobación: nada que exportar
    [one] Se exportará la única comprobación mostrada de { $all }
   *[other] Se exportarán las { $count } comprobaciones mostradas de { $all }
}
rows-exported = Se exportarán las filas mostradas de { $name } ({ $listed }), en el orden de la lista
rows-export-not-yet = Las filas se pueden exportar cuando todas estén evaluadas y mostradas
history-exported = { $count ->
    [0] Nada que exportar
    [one] Se exportará 1 comprobación
   *[other] Se exportarán las { $count } comprobaciones
}
history-cleared = { $count ->
    [one] 1 comprobación quitada del historial. Deshacer (Ctrl+Z) la recupera.
   *[other] { $count } comprobaciones quitadas del historial. Deshacer (Ctrl+Z) las recupera.
}
history-none-found = Ninguna comprobación cumple el filtro
history-filter = Filtro
history-filter-hint = Muestra las comprobaciones que contienen estas palabras: pieza, cota, valor, fecha, estado o archivo
history-only-bad = Solo no buenas
history-only-bad-hint = Retrabajo, remedir y desecho
history-sort-hint = Ordena por esta columna; otra pulsación invierte el orden, una más pone las más recientes primero
history-ascending = { $column }, orden ascendente
history-descending = { $column }, orden descendente
history-list = Comprobaciones del historial
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, elegida para exportar
history-move = Ir a otra comprobación
history-show = Mostrar comprobación
history-choose = Elegir para exportar
choose-all = Elegir todas las mostradas
copy-checks = Copiar para hoja de cálculo
history-empty = Aquí aparecen las comprobaciones, las más recientes primero
head-time = Fecha y hora
head-part = Pieza
head-callout = Cota
head-measured = Medido
head-deviation = Desviación
head-status = Estado
head-from = Origen
choose-check = Elegir { $check } de { $time } para exportar

dialog-import = Importar mediciones
dialog-mask = Máscara propia
dialog-tables = Carpeta con tablas propias
dialog-export = Exportar
dialog-export-rows = Exportar las filas mostradas
dialog-export-status = Exportar la ventana de estado
file-path = Archivo
folder-path = Carpeta
dialog-open = Abrir
dialog-save = Guardar
dialog-browse = Examinar…
dialog-cancel = Cancelar
dialog-busy = En curso…
dialog-no-path = Falta una ruta
dialog-no-status = No hay ventana de estado que guardar
dialog-browse-hint = Muestra el cuadro de archivos del sistema
dialog-up = Carpeta superior
dialog-home = Carpeta personal
dialog-all-files = Todos los archivos
file-kind-measurements = Mediciones
file-kind-mask = Máscaras
file-kind-own-tables = Carpetas de tablas
file-kind-report = Informes
file-kind-rows = Filas
file-kind-status = Texto
file-kind-table = Tablas
file-kind-contacts = Puntos de palpación
file-kind-workpiece = Piezas de trabajo simuladas
file-kind-probes = Tablas de palpación
file-kind-log = Protocolos de medición
file-kind-program = Programas NC
file-kind-part = Piezas simuladas
file-kind-set = Archivos para un control
file-kind-tools = Tablas de herramientas
file-kind-plan = Planes de pieza
file-kind-picture = Imágenes
file-kind-watched = Carpetas vigiladas
file-kind-budget = Balances de incertidumbre
file-kind-chart = Gráficos
file-kind-readings = Lecturas
file-kind-study = Lecturas de un instrumento
dialog-move = Ir a otro elemento de la lista
dialog-recent-folders = Carpetas recientes
dialog-exists = { $name } ya existe. ¿Reemplazar?
dialog-exists-set = { $name } ya existe en esta carpeta. ¿Reemplazar allí los archivos del juego?
dialog-replace = Reemplazar
dialog-keep = Conservar
dialog-nothing-picked = El cuadro del sistema no devolvió ningún archivo. Elija uno en la lista o escriba una ruta.
dialog-list = Carpeta { $folder }
dialog-entries = Archivos y carpetas
dialog-list-none = No hay ninguna carpeta abierta: escriba una ruta
dialog-list-reading = Leyendo la carpeta…
dialog-list-empty = No hay nada que elegir en esta carpeta
dialog-list-more = Solo se muestran los primeros { $most } nombres: escriba el de otro
dialog-is-folder = Carpeta
file-name-checks = comprobaciones
open-written = Abrir
show-in-folder = Mostrar en carpeta
launch-failed = el archivo no se puede abrir: { $reason }
recent-files = Archivos recientes
forget-recent = Borrar la lista
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] 1 nombre no se muestra
   *[other] { $count } nombres no se muestran
}
file-bytes = { $count } B
file-kilobytes = { $count } kB
file-megabytes = { $count } MB
notice = Aviso
copied = { $lines ->
    [one] Copiado, una línea
   *[other] Copiado, { $lines } líneas
    }
notice-problem = Error
notice-more = { $count ->
    [one] Sigue 1 aviso más
   *[other] Siguen { $count } avisos más
}
messages = Avisos anteriores
messages-forget = Vaciar la lista
messages-count = { $count ->
    [one] 1 aviso anterior
   *[other] { $count } avisos anteriores
}
close = Cerrar
file-written = { $name } se ha guardado en { $folder }
file-written-here = { $name } se ha guardado
tables-loaded = { $count ->
    [one] Se usa 1 tabla de { $folder }
   *[other] Se usan { $count } tablas de { $folder }
}
mask-loaded-with-warnings = { $name } se ha leído con advertencias
state-set-aside = No se pudo leer el estado guardado. Se conserva como { $path }, y la ventana empieza con la configuración predeterminada.
state-set-aside-now = El estado guardado ya no se puede leer. Se conserva como { $path }, y en su lugar se guarda el de esta ventana.
state-not-kept = El estado de esta ventana no se guarda: { $reason }
import-contacts-not-judged = Los puntos de palpación de { $name } no se han evaluado
import-notice = { $name }: { $good ->
    [0] ninguna comprobación
    [one] 1 comprobación
   *[other] { $good } comprobaciones
}, { $bad ->
    [0] ninguna fila no admitida
    [one] 1 fila no admitida
   *[other] { $bad } filas no admitidas
}
import-counted = { $file }. { $counts }
check-said-afterwards = indicado después del veredicto: { $as }
lot-open = { $count ->
    [one] A un valor le falta agujero o eje:
   *[other] A { $count } valores les falta agujero o eje:
}
check-all-holes = Todos son agujeros
check-all-shafts = Todos son ejes
check-judged-again = { $count ->
    [one] Un valor fuera de sus límites se ha juzgado de nuevo: { $as }
   *[other] { $count } valores fuera de sus límites se han juzgado de nuevo: { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Mostrar
notice-open-in = Abrir en la página { $page }
judge-unplanned = Abrir en Comprobación
sample-not-recorded = Un ejemplo no se registra.
limits-own-first = Primero de tablas propias: { $names }
limits-own-stay = Las tablas propias siguen teniendo prioridad: { $names }. Con Menú, Límites según, dejan de usarse.
measured-needs-value = Escriba el valor medido
measured-needs-limits = No hay límites para evaluar: escriba antes una cota

keypad = Teclado
key = Tecla
key-blank = Espacio
key-decimal = Signo decimal
key-minus = Menos
edge-left = Borde del panel izquierdo: se mueve con las flechas
edge-right = Borde del panel derecho: se mueve con las flechas
edge-top = Borde del panel superior: se mueve con las flechas
edge-bottom = Borde del panel inferior: se mueve con las flechas
key-letters = Letras
key-holes = Clases de agujeros
key-shafts = Clases de ejes
key-more-letters = De M a X
key-signs = Y, Z y signos
key-figures = Cifras
key-shift = Mayúsculas o minúsculas
key-back = Borrar el último carácter
key-clear = Vaciar
key-enter = Intro

## Table page
tables-choice = Tabla
tables-kind-shipped = integrada
tables-kind-own = propia
tables-kind-file = de un archivo
tables-kind-copy = copia
tables-kind-made = de ISO 286
tables-unsaved = sin guardar
tables-open = Abrir…
tables-save = Guardar como
tables-redo = Rehacer
tables-use = Usar esta tabla para límites
tables-in-use = En uso para límites
tables-filter = Filtro
tables-filter-hint = Clases como H7 g6, letras, grados o una medida en mm
tables-shown = { $count ->
    [one] { $shown } de 1 clase
   *[other] { $shown } de { $count } clases
}
tables-only-differences = Solo diferencias
tables-unmatched = nada encontrado para { $words }
tables-agrees = { $count ->
    [one] su única celda coincide con ISO 286
   *[other] sus { $count } celdas coinciden con ISO 286
}
tables-differs = { $count ->
    [one] 1 de { $compared } celdas difiere de ISO 286
   *[other] { $count } de { $compared } celdas difieren de ISO 286
}
tables-compared-nothing = nada que comparar con ISO 286
tables-own-classes = { $count ->
    [one] 1 clase propia
   *[other] { $count } clases propias
}
tables-own-class = propia
tables-previous = Diferencia anterior
tables-next = Diferencia siguiente
tables-not-saved = Los cambios no están guardados
tables-keys = Las flechas cambian de celda, Intro edita, Supr vacía, F8 va a la diferencia siguiente, Ctrl+F al filtro
tables-move = Ir a otra celda
tables-edit-cell = Editar la celda
tables-grid = Desviaciones de { $name } en µm
tables-range-head = más de – hasta, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = vacía
tables-cell = { $class }, más de { $over } hasta { $to } mm, { $figures }
tables-cell-differs = { $class }, más de { $over } hasta { $to } mm, { $figures }, difiere de ISO 286
tables-no-columns = La tabla no tiene ninguna clase
tables-upper = Superior
tables-lower = Inferior
tables-head-table = Tabla, µm
tables-head-standard = ISO 286
tables-head-by = difiere
tables-cell-agrees = Como en ISO 286
tables-cell-off = ISO 286 tiene { $upper } / { $lower } µm; la tabla difiere en { $upper-by } / { $lower-by } µm
tables-more-differences = y { $count } más
tables-cell-missing = Vacía aquí; ISO 286 tiene { $upper } / { $lower } µm
tables-cell-empty = Vacía aquí, y no definida en ISO 286
tables-defined = Definida en ISO 286: { $ranges }
tables-shipped-hint = Una tabla integrada nunca se modifica: al editarla se crea una copia, y se muestra la copia.
tables-set = Aplicar
tables-take-standard = Usar ISO 286
tables-empty-cell = Vaciar
tables-remove-column = Quitar { $class }
tables-from-standard = De ISO 286
tables-classes = Clases, como H7 K7 P9
tables-add-columns = Añadir a esta tabla
tables-up-to = Medidas hasta
tables-make = Tabla nueva
tables-order = la desviación superior { $upper } µm es menor que la desviación inferior { $lower } µm
tables-used-edited = { $name } da los límites: las comprobaciones usan el cambio desde ahora
tables-used = Los límites se buscan primero en { $name }, hasta que se cierre la ventana. Para seguir usándola, guárdela en la carpeta de tablas propias.
tables-read-with-warnings = { $name } se ha leído con advertencias
tables-nothing-read = El archivo no contiene ninguna tabla de desviaciones
tables-nothing-to-save = No hay ninguna tabla abierta
tables-cell-unreadable = Los valores de la celda elegida no se pueden leer: corríjalos antes
tables-too-many = Hay { $count } tablas abiertas con cambios sin guardar: guarde antes una de ellas
tables-dialog-open = Abrir una tabla
tables-dialog-save = Guardar la tabla
## Fit page
fit-callout = Ajuste de agujero y eje
fit-callout-hint = Escriba una medida nominal y ambas clases, por ejemplo 25 H7/g6
fit-example = un ejemplo: { $callout }
fit-shaft-missing = Falta la clase del eje, como g6 en 25 H7/g6
fit-hole-missing = Falta la clase del agujero, como H7 en 25 H7/g6
fit-classes-missing = Un ajuste lleva las clases de agujero y eje, como 25 H7/g6
fit-preferred = Ajuste preferente
fit-function = Función
fit-list-hole-basis = Agujero base
fit-list-shaft-basis = Eje base
fit-parts = Piezas reales
fit-hole-measured = Agujero medido
fit-shaft-measured = Eje medido
fit-temperature = Temperatura
fit-hole-material = Material agujero
fit-hole-expansion = Agujero, µm/(m K)
fit-shaft-material = Material eje
fit-shaft-expansion = Eje, µm/(m K)
fit-own-value = Valor propio
fit-press = Ajuste a presión
fit-press-length = Longitud de la unión
fit-hub-outer = Exterior del cubo
fit-shaft-bore = Agujero del eje
fit-press-material = Un ajuste a presión necesita un material de la lista para ambas piezas: elija uno
fit-press-pressure = Presión de contacto
fit-press-force = Aguanta axialmente
fit-press-torque = Aguanta como par
fit-press-pressing = Fuerza de calado
fit-press-hub = Cubo: tensión / límite
fit-press-shaft = Eje: tensión / límite
fit-press-heat = Calentar el cubo a
fit-press-cool = O enfriar el eje a
fit-press-friction = Rozamiento { $friction }; elástico, a 20 °C y en reposo. Fuerza axial y par no valen a la vez
fit-search = Buscar por juego
fit-wanted-minimum = Mínimo
fit-wanted-maximum = Máximo
fit-scope = Entre
fit-scope-all = Todas las clases
fit-scope-basis = Agujero base y eje base
fit-scope-preferred = Ajustes preferentes y con nombre
fit-search-hint = El juego más pequeño y el más grande; un valor negativo es un apriete. Se puede añadir una unidad: 7 µm
fit-search-size = La búsqueda necesita una medida nominal: escríbala arriba
fit-found = { $count ->
    [one] 1 ajuste
   *[other] { $count } ajustes
}
fit-found-first = se muestran los { $count } mejores
fit-found-none = Ningún ajuste cumple. El más próximo
fit-missed-by = { $below } µm de menos, { $above } µm de más
fit-is-preferred = preferente

fit-picture = Zonas de agujero y eje
fit-picture-legend = µm desde la línea cero; desviación fundamental en negrita
fit-picture-empty = Las zonas aparecen con el ajuste
fit-arrow-clearance = Juego real
fit-arrow-interference = Apriete real
fit-describe-zero = Línea cero en { $nominal } mm.
fit-describe-zone = { $part } { $class } de { $lower } a { $upper } µm.
fit-describe-fundamental = Desviación fundamental { $deviation } µm.
fit-describe-measured = { $part }: medido en { $deviation } µm.
fit-classes = Clases a { $nominal } mm
fit-classes-none = Clases
fit-classes-empty = Las clases aparecen con una medida nominal
fit-classes-nowhere = Ninguna clase está definida en esta medida
fit-staircase = Zonas del grado { $grade }

fit-word-clearance = Ajuste con juego
fit-word-transition = Ajuste indeterminado
fit-word-interference = Ajuste con apriete
fit-word-none = Aún no hay ajuste
fit-maximum-clearance = Juego máximo
fit-minimum-clearance = Juego mínimo
fit-maximum-interference = Apriete máximo
fit-minimum-interference = Apriete mínimo
fit-mean-clearance = Juego medio
fit-mean-interference = Apriete medio
fit-ansi = ANSI B4.2: { $name }
fit-equivalent = Ajuste equivalente
fit-equivalent-same = Exactamente los mismos juegos
fit-equivalent-differs = No es igual: juego mínimo { $minimum } µm, máximo { $maximum } µm
fit-check-hole = Comprobar el agujero
fit-check-shaft = Comprobar el eje
fit-move = Ir a otra clase
fit-actual-clearance = Juego { $um } µm
fit-actual-interference = Apriete { $um } µm
fit-conforms = Dentro de los límites de la cota
fit-conforms-not = Fuera de los límites de la cota
fit-with-good-shaft = Juego con un eje bueno
fit-with-good-hole = Juego con un agujero bueno
fit-at-temperature = A { $degrees } °C
fit-temperature-change = el juego cambia { $um } µm
fit-these-parts = Estas piezas: { $clearance }

## Own materials
materials-refused = Los materiales propios no se pueden usar: { $path }, { $reason }

## Palette
section-said = { $name }: { $value }
crash-report = La ventana terminó por un fallo del programa. El informe del fallo, sin valores medidos, está en { $path }
rail-more = Más
top-open = { $name } está abierto
top-undo = Deshacer el último cambio
top-recorded = Registrado, { $number }
top-recording = Registrando
top-not-recorded = No registrado
palette = Buscar o ejecutar
palette-do = Ejecutar
palette-open = Abrir
palette-settings = Configuración y ayuda
palette-records = Registro
palette-fit = Ajuste { $fit }
palette-in-tables = { $what } en las tablas
palette-uncertainty = Incertidumbre a { $size } mm
palette-records-of = { $what } en el registro
palette-show-setting = Mostrar en la página de configuración
palette-more = Qué más se puede hacer
palette-back = Volver a lo encontrado
palette-check-value = Comprobar { $callout } con { $value }
palette-check = Comprobar { $callout }
palette-search-manual = Buscar «{ $query }» en el manual
palette-nothing = Nada tiene este nombre
palette-hint = Una cota, una página, un comando o un archivo

## Leaving
leave = ¿Cerrar Fitcheck?
discard = ¿Descartar los cambios?
discard-unsaved = { $name } tiene cambios sin guardar.
discard-no = Seguir editando
discard-yes = Descartar cambios
leave-unsaved = Sin guardar: { $names }
leave-stay = Seguir trabajando
leave-anyway = Cerrar sin guardar

## Cycle pictures
cycle-picture-centre-1 = centro nominal en el primer eje
cycle-picture-centre-2 = centro nominal en el segundo eje
cycle-picture-centre-tolerance-1 = desviación admisible del centro en el primer eje, en ambos sentidos; 0 no supervisa
cycle-picture-centre-tolerance-2 = desviación admisible del centro en el segundo eje, en ambos sentidos; 0 no supervisa
cycle-picture-side-length-1 = longitud nominal del rectángulo a lo largo del primer eje
cycle-picture-side-length-2 = longitud nominal del rectángulo a lo largo del segundo eje
cycle-picture-maximum-side-1 = longitud máxima admisible a lo largo del primer eje
cycle-picture-maximum-side-2 = longitud máxima admisible a lo largo del segundo eje
cycle-picture-minimum-side-1 = longitud mínima admisible a lo largo del primer eje
cycle-picture-minimum-side-2 = longitud mínima admisible a lo largo del segundo eje
cycle-picture-width = anchura nominal, de pared a pared
cycle-picture-maximum-width = anchura máxima admisible
cycle-picture-minimum-width = anchura mínima admisible
cycle-picture-start-1 = punto de la ranura en el que empieza el palpador, primer eje
cycle-picture-start-2 = punto de la ranura en el que empieza el palpador, segundo eje
cycle-picture-shift = desplazamiento del segundo punto de palpación a lo largo de las paredes; 0 palpa enfrente del primero
cycle-picture-first-point-1 = primer punto, en la pared del lado positivo: primer eje
cycle-picture-first-point-2 = primer punto, en la pared del lado positivo: segundo eje
cycle-picture-second-point-1 = segundo punto, en la pared del lado negativo: primer eje
cycle-picture-second-point-2 = segundo punto, en la pared del lado negativo: segundo eje
cycle-picture-axis-of-plane = eje de medición: 1 primer eje, 2 segundo eje
cycle-picture-diameter = diámetro nominal
cycle-picture-maximum-size = diámetro máximo admisible
cycle-picture-minimum-size = diámetro mínimo admisible
cycle-picture-start-diameter = diámetro del círculo en el que está el palpador antes de cada palpación
cycle-picture-first-angle = ángulo del primer punto de palpación, contado desde el primer eje
cycle-picture-step = ángulo de punto a punto de palpación; menos gira en sentido horario
cycle-picture-arc = ángulo en el que se reparten los puntos de palpación; 360 es una vuelta completa, menos gira en sentido horario
cycle-picture-longest-path = recorrido de palpación más largo; más se aleja del centro, menos se acerca
cycle-picture-difference = cada punto se palpa dos veces: diferencia máxima admisible
cycle-picture-measuring-height = altura del centro de la bola en el punto de palpación
cycle-picture-set-up-clearance = distancia antes del punto de palpación, sumada a SET_UP de la tabla de palpación
cycle-picture-clearance-height = altura a la que el palpador se mueve libremente
cycle-picture-point-1 = punto que se palpa, primer eje
cycle-picture-point-2 = punto que se palpa, segundo eje
cycle-picture-point-3 = punto que se palpa, tercer eje
cycle-picture-next-point-1 = segundo punto de la recta, primer eje
cycle-picture-next-point-2 = segundo punto de la recta, segundo eje
cycle-picture-next-point-3 = segundo punto de la recta, tercer eje
cycle-picture-second-centre-1 = centro nominal del segundo círculo, primer eje
cycle-picture-second-centre-2 = centro nominal del segundo círculo, segundo eje
cycle-picture-second-diameter = diámetro nominal del segundo círculo
cycle-picture-second-height = altura a la que se palpa el segundo círculo
cycle-picture-geometries = 0 dos taladros, 1 dos pivotes, 2 un taladro y un pivote, 3 un pivote y un taladro
cycle-picture-maximum-coordinate = coordenada máxima admisible
cycle-picture-minimum-coordinate = coordenada mínima admisible
cycle-picture-normal-1 = componente de la normal a la superficie en el primer eje; la normal sale del material
cycle-picture-normal-2 = componente de la normal a la superficie en el segundo eje; la normal sale del material
cycle-picture-normal-3 = componente de la normal a la superficie en el tercer eje; la normal sale del material
cycle-picture-band = desviación admisible según la normal: exceso más, defecto menos
cycle-picture-retract = recorrido de retirada desde el punto de palpación, en sentido contrario a la palpación
cycle-picture-move-to-clearance = recorrido entre puntos de palpación: 0 a la altura de medición, 1 por la altura de seguridad
cycle-picture-clearance-mode = altura de seguridad: −1 nunca, 0 antes y después del ciclo, 1 antes y después de cada objeto, 2 en cada punto de palpación
cycle-picture-traverse = recorrido al siguiente punto de palpación: 0 recta, 1 arco
cycle-picture-contact-count = número de puntos de palpación
cycle-picture-plane = plano del círculo: 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 palpa por dentro, 1 por fuera
cycle-picture-measured-axis = eje de medición: 1 primer eje, 2 segundo eje, 3 eje del palpador
cycle-picture-direction = sentido de aproximación: −1 contra el eje, +1 a favor
cycle-picture-directed-axis = eje medido, 1 primero, 2 segundo, 3 eje del palpador; menos palpa en sentido contrario
cycle-picture-tool-axis-probing = eje del palpador: 0 queda como está, 1 también se palpa y se fija
cycle-picture-tool-axis-point-1 = dónde se palpa el eje del palpador, primer eje
cycle-picture-tool-axis-point-2 = dónde se palpa el eje del palpador, segundo eje
cycle-picture-tool-axis-point-3 = dónde se espera la superficie en el eje del palpador
cycle-picture-new-datum-1 = coordenada que recibe el lugar medido en el primer eje
cycle-picture-new-datum-2 = coordenada que recibe el lugar medido en el segundo eje
cycle-picture-new-datum-3 = coordenada que recibe el lugar medido en el eje del palpador
cycle-picture-new-coordinate = coordenada que recibe el lugar medido en el eje medido
cycle-picture-table-row = fila de la tabla a la que va el punto de referencia; con 0 está activo de inmediato
cycle-picture-transfer = tabla: −1 no indicada, 0 puntos cero, 1 puntos de referencia
cycle-picture-preset-correction = 0 deja el punto de referencia activo como está; otro número lo corrige, de modo que este punto muestre su valor nominal
cycle-picture-aligned-angle = ángulo al que se alinea la arista, desde el primer eje; 0 la alinea con el eje
cycle-picture-compensation-axis = eje rotativo que alinea la arista: 0 aquel en torno al cual se midió el ángulo, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = el eje rotativo tras alinear: 0 conserva su valor, 1 marca cero
cycle-picture-rotary-alignment = los ejes rotativos tras medir: 0 no se mueven, otro número los gira, de modo que la recta quede alineada
cycle-picture-rotation-transfer = el ángulo medido: 0 no cambia nada, 1 pasa a ser el giro básico, 2 un desfase del eje rotativo
cycle-picture-log = protocolo de medición: 0 ninguno, 1 archivo, 2 en pantalla y el programa se detiene
cycle-picture-stop = fuera de tolerancia: 0 el programa continúa, 1 se detiene con un mensaje
cycle-picture-stop-on-undersize = fuera de tolerancia: 0 el programa continúa, 1 se detiene, 2 se detiene solo si es menor que el mínimo
cycle-picture-stop-on-scrap = fuera de tolerancia: 0 el programa continúa, 1 se detiene, 2 se detiene solo por desecho
cycle-picture-tool = herramienta que se supervisa, por número o nombre; 0 es ninguna
cycle-picture-any-length = { $name } Una longitud
cycle-picture-any-angle = { $name } Un ángulo
cycle-picture-any-choice = { $name } Uno de { $of }
cycle-picture-any-number = { $name } Un número
cycle-picture-part = Pieza con { $count ->
    [one] un elemento
   *[other] { $count } elementos
  }: { $names }.
cycle-picture-path = Trayectoria del palpador, { $step } de { $moves } movimientos hechos, { $contacts ->
    [one] 1 punto de palpación
   *[other] { $contacts } puntos de palpación
}. Bola en X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, punto de palpación { $touch }
cycle-picture-no-path = La trayectoria aparece después de ejecutar el ciclo
cycle-picture-phase-pre-position = preposicionado
cycle-picture-phase-approach = aproximación
cycle-picture-phase-contact = palpación
cycle-picture-phase-retract = retirada
cycle-picture-phase-leave = salida
cycle-picture-from-above = { $first }/{ $second } desde arriba
cycle-picture-from-side = { $first }/{ $second } de lado
cycle-picture-contacts = { $count } puntos de palpación en torno a su círculo de mínimos cuadrados Ø { $diameter } mm, { $factor }: { $residuals }.
cycle-picture-nominal = Círculo nominal Ø { $diameter } mm.
cycle-picture-legend-fitted = mínimos cuadrados
cycle-picture-legend-nominal = nominal
cycle-picture-deviation = desviación según la normal { $deviation } mm, sin tolerancia
cycle-picture-no-limits = No se indicaron límites: no se ha comparado nada
cycle-picture-head-criterion = Criterio
cycle-picture-head-centre-1 = Centro, 1.er eje
cycle-picture-head-centre-2 = Centro, 2.º eje
cycle-picture-head-diameter = Ø en mm
cycle-picture-head-form = Forma
cycle-picture-none = —
cycle-picture-least-squares = Mínimos cuadrados
cycle-picture-circumscribed = Mínimo circunscrito
cycle-picture-inscribed = Máximo inscrito
cycle-picture-zone = Zona mínima, redondez
cycle-picture-two-point = Entre dos puntos
cycle-picture-two-point-of = Medida entre dos puntos { $first }–{ $second }
cycle-picture-two-point-least = Mínima medida entre dos puntos, { $first }–{ $second }
cycle-picture-two-point-most = Máxima medida entre dos puntos, { $first }–{ $second }
cycle-picture-no-opposed = no hay dos puntos de palpación opuestos
cycle-picture-uncertainty = La dispersión s de un punto de palpación da { $diameter } s en el diámetro, { $against } veces la de 3 puntos a 120°, y de { $across } s a { $along } s en el centro

# The saved state, and the window itself
saved-broken = el estado guardado no se puede leer: { $reason }
saved-newer = el estado guardado tiene la versión { $version }, este programa admite versiones hasta la { $known }
window-no-display = no hay pantalla: DISPLAY y WAYLAND_DISPLAY no están definidas. Inicie sesión en un escritorio, conéctese con ssh -X o use la línea de comandos, que no necesita pantalla: fitcheck check "25 H7" --measured 25.012; véase fitcheck --help
open-unknown = { $name } no es un archivo que la ventana abra; abre mediciones, protocolos de medición y puntos de palpación (.csv, .tsv, .txt, .html), programas NC (.h), tablas (.tab), tablas de herramientas (.t), piezas de trabajo simuladas (.toml), tablas de palpación (.tp) y máscaras (.a)
window-not-opened = la ventana no se puede abrir: { $reason }; la línea de comandos funciona sin pantalla, véase fitcheck --help

## Rows of a large file

rows = Filas
rows-cancel = Cancelar
rows-again = Evaluar de nuevo
rows-close = Cerrar archivo
rows-close-hint = Cierra el archivo grande; sus filas no se conservan
rows-move = Ir a otra fila
rows-show = Mostrar comprobación de la fila
rows-keep = Añadir al historial
rows-kept = La comprobación se ha añadido al historial
rows-progress = Parte leída del archivo
rows-running = { $count } filas hasta ahora, { $percent } % del archivo, { $rate } filas por segundo
rows-done = { $count } filas, todas evaluadas en { $seconds }
rows-seconds = { $seconds } s
rows-less-than = menos de { $seconds } s
rows-cancelled = INCOMPLETO: cancelado después de { $count } filas, { $percent } % del archivo
rows-failed = INCOMPLETO después de { $count } filas: { $why }
rows-why-bytes = { $size } MiB, más de { $limit } MiB: evaluado fila por fila, y las filas no se conservan en el historial
rows-why-packed = Comprimido: evaluado fila por fila, y las filas no se conservan en el historial; el texto descomprimido está en un archivo temporal hasta que se cierre el archivo
rows-not-judged = SIN EVALUAR
rows-fate = { $fate } { $count }
rows-fate-hint = Muestra estas filas; se pueden elegir varias
rows-classes = Clases
rows-all-classes = Todas las clases
rows-no-class = Sin clase
rows-some-classes = { $count } clases
rows-class = { $class }: { $count }
rows-summary = Resumen
rows-fate-only = Mostrar las filas { $fate } del archivo grande
rows-filter-hint = Muestra las filas que contienen estas palabras en sus celdas, como pieza, cota, valor o estado
rows-worst-first = Peores primero
rows-worst-first-hint = Muestra los desechos antes que los retrabajos y los buenos, con la mayor desviación de los límites primero
rows-worst = Peor pieza
rows-sifting = Buscando en las filas…
rows-sifts-at-end = El filtro y el orden se aplican cuando todas las filas están evaluadas
rows-in-order = peores primero
rows-worst-of-many = las { $most } peores, peores primero
rows-first-of-many = las { $most } primeras
rows-export = Filas del archivo como { $format }, con dictamen…
rows-export-programs = Comprobaciones de las filas mostradas como { $format }…
rows-export-simulated = Las primeras líneas del archivo dicen que es simulado, y solo CSV puede conservarlas. Exporte como CSV
rows-export-twice = El archivo tiene dos columnas llamadas { $column }. Exporte como CSV o TSV, que admiten ambas
rows-report-counts = { $name }: { $count } filas; { $good } BUENO, { $rework } RETRABAJO, { $remeasure } REMEDIR, { $out } FUERA DE LÍMITES, { $scrap } DESECHO, { $unjudged } SIN EVALUAR; { $listed } de ellas en este informe
rows-report-without = { $count ->
    [one] 1 fila mostrada no tiene dictamen ni comprobación en este informe
   *[other] { $count } filas mostradas no tienen dictamen ni comprobación en este informe
}
rows-file-name = { $name }-evaluado
rows-not-whole = INCOMPLETO: los recuentos no son los del archivo entero
rows-listed = { $listed } de { $count } filas mostradas
rows-refused = { $count ->
    [one] 1 fila sin evaluar
   *[other] { $number } filas sin evaluar
}
rows-doubted = { $count ->
    [one] 1 valor puede ser otra magnitud o de otra pieza
   *[other] { $number } valores pueden ser otra magnitud o de otra pieza
}
rows-simulated = { $count ->
    [one] 1 fila dice que nadie midió
   *[other] { $number } filas dicen que nadie midió
}
rows-status-differs = { $count ->
    [one] 1 fila tiene otro estado en su archivo
   *[other] { $number } filas tienen otro estado en su archivo
}
rows-status-unknown = { $count ->
    [one] 1 fila tiene un estado desconocido en su archivo
   *[other] { $number } filas tienen un estado desconocido en su archivo
}
rows-claim-differs = { $count ->
    [one] 1 límite, desviación o tipo de elemento contradice su fila
   *[other] { $number } límites, desviaciones o tipos de elemento contradicen sus filas
}
rows-several-lines = { $count ->
    [one] 1 fila ocupa varias líneas
   *[other] { $number } filas ocupan varias líneas
}
rows-not-utf8 = { $count ->
    [one] 1 línea no es UTF-8 y se ha leído como Windows-1252
   *[other] { $number } líneas no son UTF-8 y se han leído como Windows-1252
}
rows-comments = { $count ->
    [one] 1 comentario no es una fila
   *[other] { $number } comentarios no son filas
}
rows-note = Línea { $line }: { $what }
rows-first-notes = Las primeras { $first } de { $count }:
rows-line = Línea { $line } de { $name }
rows-row-line = línea { $line }
rows-list = Filas del archivo
rows-none = Ninguna fila cumple el filtro
rows-none-yet = Aún no hay filas
rows-head-line = Línea
rows-head-what = Qué hacer
rows-changed = el archivo ha cambiado desde que se evaluó; evalúelo de nuevo
rows-unread = las filas no se pueden volver a leer: { $reason }
rows-no-copy = el texto descomprimido no se puede conservar: { $reason }
rows-too-much = el texto descomprimido es mayor que { $most } GiB
rows-panicked = un error interno terminó la evaluación

## A file that is read or written
working = En curso
working-reading = Leyendo { $name }: { $rows } filas, { $done } de { $all } MB, { $rate } filas por segundo
working-reading-bytes = Leyendo { $name }: { $done } de { $all } MB, { $seconds } s
working-writing = Escribiendo { $name }: { $done } MB, { $seconds } s
working-progress = Progreso de la lectura
working-stop = Detener
working-stopped = Detenido después de { $rows } filas: no se ha importado nada de { $name }

## What a code reader typed into the field of the value
scanned-callout = { $given } es una cota y se ha tomado como tal
scanned-serial = { $given } no es un valor: se ha tomado como número de serie de las próximas comprobaciones
