## Tables of CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = ningún valor medido en la columna actual
calypso-cut-off = falta la última línea, END: el archivo puede estar cortado
calypso-row-cut-off = el archivo termina aquí sin fin de línea, así que la fila puede estar cortada: se omite; si está completa, añada un fin de línea
calypso-zeros = la línea tiene bytes de valor 0, así que el archivo no se escribió por completo: la fila se omite
calypso-differs = las filas de { $name } en las líneas { $first } y { $second } tienen valores nominales o límites distintos
calypso-warning-no-end = falta la última línea, END: el archivo puede estar cortado
calypso-warning-behind = omitido después de la línea END: { $given }
calypso-warning-zeros = el archivo tiene aquí bytes de valor 0, así que no se escribió por completo: pueden faltar filas
calypso-warning-deviation = la tabla tiene una desviación de { $given } mm, pero sus valores dan { $expected } mm
calypso-warning-exceed = la tabla tiene { $given } mm más allá de la tolerancia, pero sus valores dan { $expected } mm
