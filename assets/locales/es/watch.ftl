# The folder that files are dropped into.

watch-written = se está escribiendo
watch-locked = en uso por otro programa: { $reason }
watch-same = el mismo contenido se importó antes como { $known }
watch-note = Fitcheck no pudo usar o evaluar todo en { $name }:
watch-again = el archivo se reescribió y empieza como antes: { $count ->
    [one] un valor importado
   *[other] { $count } valores importados
} de nuevo
watch-begins-as = el archivo empieza como { $known }, importado antes: { $count ->
    [one] un valor importado
   *[other] { $count } valores importados
} de nuevo
watch-same-again = reescrito con el mismo contenido, así que no se importa nada
watch-by-another = otro programa vigila esta carpeta para el mismo registro
watch-late = las líneas hasta la { $last } completan valores ya importados, desde la línea { $first }: revise estos valores en el registro
watch-no-line-end = la última línea no tiene fin de línea; se importó tal cual
watch-older = un archivo con este nombre se importó después con otro contenido; del principio de este no se importa de nuevo: { $count ->
    [one] un valor
   *[other] { $count } valores
}
watch-refused = no se puede leer; Fitcheck lo sigue intentando: { $reason }
watch-copy = el mismo contenido se importó antes como { $known }; si de verdad se remidió una pieza, su archivo necesita una hora o un número de serie
watch-verdicts = el archivo contiene dictámenes escritos por Fitcheck, no mediciones; no se importa nada
watch-other = un archivo con este nombre se importó antes y empezaba de otra forma; este se importa entero
