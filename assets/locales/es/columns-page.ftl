# The columns of a file of measurements: seen, corrected and remembered.

columns-page-import = Columnas…
columns-page-hint = Muestra cómo se lee cada columna de un archivo antes de importar sus valores
columns-page-take = Importar
columns-page-correct = Columnas…
columns-page-forget = Olvidar estas columnas
columns-page-dialog = Importar y elegir columnas
columns-page-title = Columnas de { $name }
columns-page-wanted = Elija qué contiene cada columna. Los archivos con la misma disposición se leerán igual.
columns-page-uncertain = Algunas columnas son inciertas: revise qué contiene cada una y después importe. Los archivos con la misma disposición se leerán igual.
columns-page-sheet = Hoja
columns-page-separator = Separador
columns-page-separator-semicolon = Punto y coma
columns-page-separator-comma = Coma
columns-page-separator-tab = Tabulador
columns-page-separator-pipe = Barra vertical
columns-page-decimal = Signo decimal
columns-page-decimal-point = Punto
columns-page-decimal-comma = Coma
columns-page-as-found = Como en el archivo
columns-page-unit = Unidad de medida
columns-page-place-unit = Unidad de X, Y, Z
columns-page-unit-names = Del encabezado; si no, mm
columns-page-unit-from = Del archivo: { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = pulgada
columns-page-first-row = Primera fila
columns-page-below-header = Bajo el encabezado
columns-page-line = Línea { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = no se usa
columns-page-role-name = nombre
columns-page-role-number = número
columns-page-role-callout = cota
columns-page-role-nominal = medida nominal
columns-page-role-measured = valor medido
columns-page-role-time = hora
columns-page-role-simulated = simulado
columns-page-role-part = pieza
columns-page-role-serial = número de serie
columns-page-role-who = operador
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = qué se midió
columns-page-header = { $line } encabezado
columns-page-row = { $line }
columns-page-not-read = { $line } no leída
columns-page-read = { $rows ->
        [0] Ninguna de las filas mostradas se lee
        [one] { $read } de 1 fila mostrada da un valor
       *[other] { $read } de { $rows } filas mostradas dan valores
    }
columns-page-first-problem = Primer error: { $why }
columns-page-no-measured = Ninguna columna contiene el valor medido: elija una
columns-page-no-callout = Ninguna columna contiene la cota, así que no se puede evaluar ningún valor: elija una
columns-page-no-name = Ninguna columna identifica el elemento de un valor: elija nombre, número, o X e Y
columns-page-taken = Columnas: { $columns }; unidad de medida: { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Columnas leídas según la corrección del { $day }
columns-page-forgotten = Columnas olvidadas: el próximo archivo con esta disposición se lee como si fuera el primero. Los valores de este archivo se conservan.
columns-page-none = { $name } no es una tabla con columnas
columns-page-large = { $name } es demasiado grande para leerlo con columnas corregidas en la ventana: use fitcheck import --columns
