# Sets of programs, tables and masks for a control.
## Plans
nc-value = { $what }: { $error }
nc-name = nombre { $name }: se admiten letras de la A a la Z, cifras y _, como máximo { $most }
nc-not-on-control = { $kind }: se mide con el ciclo { $cycle }, que un { $control } no tiene
## Sets
nc-folder = { $folder } no es una carpeta para programas: escriba TNC:\ y después nombres de letras, cifras, _ y -, separados por \
nc-no-texts = un conjunto con textos de tolerancia solo es posible para TNC7, no para { $control }
nc-series-name = { $name } no puede nombrar una columna de la tabla de la serie: empiece el nombre por una letra y no use NR, PART ni STATUS
nc-series-sizes = una serie guarda como máximo { $most } medidas de una pieza y el plan tiene { $sizes }: cree varios juegos
nc-reads-otherwise = { $file } no se puede escribir de modo que se lea igual
nc-proof = el juego no superó su ejecución de prueba y no se escribió: { $reason }
nc-proof-no-end = el programa no termina
nc-proof-count = se midieron { $found } de { $expected } elementos
nc-proof-other-verdict = { $name }: el dictamen difiere del de Fitcheck
nc-archive = el archivo zip no se puede crear: { $reason }
nc-workpiece = la pieza de trabajo no se puede escribir: { $reason }
nc-own-column = { $class } no es una de las 47 clases de NC-Solution 8255: { $table } recibe una columna más
nc-figure = { $what }
nc-fewer-columns = límite de columnas de un iTNC 530: { $table } tiene solo las clases del plan, { $classes }
nc-by-hand = { $name }: ningún ciclo mide un elemento de tipo { $kind }: no está en el conjunto
nc-not-in-set = { $name }: el plan dice { $said }, pero el juego no lo usa: en el control deciden solo los límites, así que puede decir BUENO donde fitcheck import no lo hace
nc-features = { $first } (y { $more } más)
nc-moved-nominal = { $name }: la medida nominal de { $callout } está fuera de los límites, lo que un TNC7 rechaza: { $parameter } es { $value } mm, y { $deviation } se refiere a ese valor
nc-no-place = { $name } necesita x, y y z: el programa se desplaza allí
nc-own-cycle = { $name } tiene ciclo o parámetros propios, que los programas llamados no admiten
nc-no-coordinate = no se da { $column }: el programa se desplaza allí
