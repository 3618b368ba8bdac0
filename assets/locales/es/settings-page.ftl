page-settings = Configuración

# The sections
settings-page-find = Buscar una opción
settings-page-sections = Sección
settings-page-general = General
settings-page-appearance = Aspecto
settings-page-rule = Regla y límites
settings-page-own-files = Archivos propios
settings-page-records = Registro
settings-page-shop-server = Servidor
settings-page-folders = Carpetas
settings-page-keys = Teclas
settings-page-about = Acerca de
settings-page-nothing = Ninguna opción contiene estas palabras
settings-page-defaults = Valores predeterminados
settings-page-defaults-hint = Deja esta sección como en el primer inicio. Archivos, nombres y direcciones se mantienen.

# General
settings-page-language-about = Todos los textos de la ventana, y su signo decimal.
settings-page-own-texts = Textos propios
settings-page-own-texts-about = Palabras de su taller en lugar de las incorporadas: un archivo Fluent para un idioma, como nl_OurShop.ftl.
settings-page-own-texts-count = { $file }: { $count } de { $all } textos son propios
settings-page-own-texts-reading = { $file } se está leyendo
settings-page-own-texts-unread = { $file } no se pudo leer y no se usa: { $why }
settings-page-own-texts-elsewhere = Son textos en { $language } y solo cuentan cuando la ventana está en ese idioma.
settings-page-own-texts-refused = { $count ->
    [one] Se rechaza 1 texto, y se usa el incorporado:
    [many] Se rechazan { $count } textos, y se usan los incorporados:
   *[other] Se rechazan { $count } textos, y se usan los incorporados:
}
settings-page-own-texts-more = … y { $count } más
load-texts = Textos propios…
no-own-texts = Dejar de usar los textos propios
dialog-own-texts = Textos propios
file-kind-own-texts = Textos
settings-page-keypad-about = Teclas grandes para pantallas táctiles y guantes.
sounds = Sonidos
sounds-about = Cada dictamen se oye: un tono largo es bueno, dos tonos piden mirar la pieza, tres son desecho. Los valores simulados no se oyen.
sounds-failed = No se oye ningún sonido: { $reason }
sounds-no-player = No se oye ningún sonido: ninguno de estos programas está en este ordenador: { $players }
settings-page-shop = Configuración para todo el taller
settings-page-shop-about = Un archivo para otros puestos. No contiene ningún nombre, dirección de servidor ni cota.
settings-page-export = Exportar configuración…
settings-page-import = Importar configuración…
settings-page-dialog-export = Exportar la configuración
settings-page-dialog-import = Importar la configuración
settings-page-imported = { $count ->
    [0] { $name }: nada es diferente
    [one] { $name }: 1 opción cambiada
   *[other] { $name }: { $count } opciones cambiadas
}
settings-page-unknown-key = { $key } no es una opción de esta versión. Al exportar se conserva.
settings-page-no-version = el archivo no tiene versión: no es un archivo de configuración
settings-page-edition = Edición de ISO 286
file-kind-settings = Configuración

# Appearance
settings-page-colours = Colores
settings-page-colours-about = El dictamen tiene también una palabra y una forma, sea cual sea su color.
settings-page-zoom = Zoom
settings-page-zoom-about = Amplía o reduce todo. Las teclas son Ctrl con más, menos y 0.
settings-page-zoom-out = Reducir
settings-page-zoom-in = Ampliar
settings-page-zoom-normal = Zoom al 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automático: un toque agranda botones y campos, el ratón los reduce.
settings-page-decimal = Signo decimal
settings-page-decimal-about = En la ventana. Los informes siguen su idioma; los archivos, su propia configuración.
settings-page-decimal-of-language = Según el idioma
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Filas de las listas
settings-page-rows-about = Altura de las filas de las tablas: normal son 32 px, compacta 26 px. Con pantalla táctil siempre 48 px.
settings-page-rows-usual = Normal
settings-page-rows-close = Compacta

# Rule and limits
settings-page-limits-about = Dónde se buscan los límites de una clase. Las tablas propias van siempre primero.
settings-page-js-about = Para planos según la edición de 1988, grados 7 a 11. Si no, se conservan los medios micrómetros.
settings-page-1988-about = Para planos según la edición de 1988. Si no, están definidas también para medidas mayores.
settings-page-decision-rule = Regla de decisión
settings-page-decision-rule-about = Qué parte de la zona se acepta, según la incertidumbre del valor.
settings-page-prover = Carga de la prueba
settings-page-prover-about = Quién tiene que demostrar que una pieza es conforme, o que no lo es.
settings-page-uncertainty-from = La incertidumbre se da como
settings-page-uncertainty-from-about = Un valor escrito, o el balance, que conoce cada medida y sus puntos de palpación.
settings-page-uncertainty-about = De cada valor de la página de comprobación. Vacío: desconocida.
settings-page-coverage-about = Cuántas incertidumbres típicas forman la expandida.
settings-page-budget = Balance de incertidumbre
settings-page-budget-about = Abra un balance en su página y úselo para las comprobaciones.
settings-page-guard-factor-about = El ancho de la banda de guarda, para reglas que usan un múltiplo.
settings-page-guard-width-about = Para la regla con banda de guarda fija.
settings-page-part-temperature = Temperatura de la pieza
settings-page-part-temperature-about = Los valores se corrigen a 20 °C. Vacío: sin corregir.
settings-page-part-expansion-about = Cuánto se dilata el material de la pieza.
settings-page-scale-temperature = Temperatura de las escalas
settings-page-scale-temperature-about = Solo si la máquina no la compensa.
settings-page-scale-expansion-about = Cuánto se dilatan las escalas de la máquina.
settings-page-clearance-about = A qué distancia de la superficie empieza el palpador a buscarla.
settings-page-height = Altura de medición Z
settings-page-height-about = A qué altura toca el palpador la pieza de trabajo.
settings-page-first-contact-about = El ángulo del primer punto de palpación.
settings-page-centre-tolerance-about = Cuánto puede desviarse el centro en X e Y. 0: no se supervisa.

# Own files
settings-page-own-tables = Tablas propias
settings-page-own-tables-about = Una carpeta con tablas como en su control. Van antes que ISO 286.
settings-page-mask = Máscara de la ventana de estado
settings-page-mask-about = Qué imprime el control, y en qué idioma.
settings-page-own-mask = Máscara propia
settings-page-own-mask-about = Un archivo de máscara de su control en lugar de la integrada.
settings-page-columns = Columnas de archivos
settings-page-columns-about = Muestra qué es cada columna antes de importar un archivo, y lo recuerda.

# Records
settings-page-journal = Registro
settings-page-journal-about = Aquí se escribe cada comprobación. El archivo de estado puede indicar otro archivo.
settings-page-who-about = Cada comprobación se registra con este nombre.
settings-page-station = Puesto
settings-page-station-about = El nombre de este ordenador en el registro.

# Shop server
settings-page-server = Dirección del servidor
settings-page-server-about = Envía cada entrada a PostgreSQL en segundo plano, como postgres://mill3@shop.example/checks. Una contraseña pasa al llavero.
settings-page-sent = Enviado
settings-page-sent-about = Las entradas esperan en este ordenador hasta que el servidor las tiene.

# Folders
settings-page-watched = Carpeta vigilada
settings-page-watched-about = Los archivos que llegan a ella se evalúan según el plan abierto y se registran.
settings-page-recent-about = El menú muestra los últimos archivos leídos.
settings-page-recent-count = { $count ->
    [0] ningún archivo
    [one] 1 archivo
   *[other] { $count } archivos
}

# Keys
settings-page-everywhere = En todas partes
settings-page-on-workpiece = Ciclos y programas
settings-page-in-dialog = En el cuadro de archivos

# About
settings-page-version = Versión
settings-page-version-about = Fitcheck dice de un vistazo si un agujero o un eje medido es bueno.
settings-page-version-is = { $version }, commit { $commit }
settings-page-unknown = desconocido
settings-page-licences = Licencias de lo integrado
settings-page-licence = Licencia
settings-page-licence-about = Software libre. Las fuentes incluidas tienen licencias propias.
settings-page-state-file = Archivo de estado
settings-page-state-file-about = Guarda configuración, campos y archivos recientes, un segundo después de cada cambio.
settings-page-journal-file = Archivo de registro
settings-page-journal-file-about = Guarda cada comprobación de este puesto.
settings-page-not-used = no se usa
settings-page-own-tables-unread = { $folder } no se pudo leer y no se usa
settings-page-nowhere = no se guarda
settings-page-changed = Cambiado: { $name }
settings-page-several-changed = { $count } opciones cambiadas
settings-page-take-back = Deshacer el último cambio de una opción
settings-page-preview = Ejemplo con esta configuración

## The size of the screen
ruler = Tamaño de la pantalla
ruler-about = Acerque una tarjeta bancaria a la imagen e iguale el ancho: los botones del operador miden entonces 20 mm
ruler-card = Una tarjeta bancaria: aún sin comparar
ruler-known = Una tarjeta bancaria, 85,6 mm
ruler-much-shorter = Mucho más corta
ruler-shorter = Un poco más corta
ruler-longer = Un poco más larga
ruler-much-longer = Mucho más larga
ruler-forget = Olvidar
settings-page-company = Empresa en los informes
settings-page-company-about = Aparece arriba en PDF y HTML, si la plantilla no nombra ninguna empresa.
settings-page-company-address = Dirección en los informes
settings-page-company-address-about = Un punto y coma empieza una línea nueva.
settings-page-company-logo = Logotipo en los informes
settings-page-company-logo-about = La ruta completa de un archivo PNG, JPEG o SVG.
settings-page-company-logo-place = { $given } no es una ruta completa: empiece por la unidad o la carpeta raíz
