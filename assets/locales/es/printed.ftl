## Printed reports
printed-no-value = ningún valor medido bajo { $column }
printed-cells = { $found } números bajo { $expected } columnas: no está claro qué número está en qué columna; imprima el informe con todas las columnas
printed-no-column = no hay columna { $column }: añada los valores medidos al formato de impresión del informe
printed-no-heading = números sin encabezado encima: falta el comienzo de la dimensión
printed-no-rows = { $name } no tiene filas: el informe puede estar cortado
printed-minus-sign = la tolerancia inferior { $given } puede estar por debajo o por encima del valor nominal, y ninguna otra fila lo decide: imprima las tolerancias inferiores sin signo
printed-unknown-row = eje desconocido { $given }: la fila se omite
printed-warning-deviation = el informe tiene una desviación de { $given } mm, pero sus números dan { $expected } mm
printed-warning-beyond = el informe tiene { $given } mm más allá de la tolerancia, pero sus números dan { $expected } mm
printed-warning-no-end = falta la última línea, { $end }: el informe puede estar cortado
printed-warning-lines = omitido, no es una medición: { $text } (líneas de este tipo en total: { $count })
printed-warning-out-of-place = el informe dice { $given }, y ninguno de los límites leídos aquí lo dice: mire el informe
