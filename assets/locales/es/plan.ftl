# Plans of features: what is wrong with one.

plan-no-features = el plan no tiene elementos
plan-no-form-limit = { $text } no es el límite de una tolerancia de forma o posición: escriba una sola longitud mayor que 0 en mm, por ejemplo 0.02
plan-too-many = el plan tiene más de { $most } elementos
plan-too-large = un plan tiene como máximo { $most } KiB
plan-no-column = falta la columna { $column }
plan-unknown-column = columna desconocida { $column }: las columnas son { $known }
plan-column-twice = la columna { $column } aparece dos veces
plan-cells = la fila tiene { $found } celdas y el encabezado { $expected }: con coma decimal, separe las columnas con punto y coma
plan-no-cell = falta { $column }
plan-value = { $what }: { $error }
plan-no-feature = { $callout } puede ser un agujero o un eje: añada feature = "hole" o feature = "shaft", o kind = "length" si no es ninguno de los dos
plan-fit = { $callout } es un ajuste: escriba el agujero y el eje como dos elementos
plan-clearance-height = la altura de seguridad { $height } mm no está por encima de la altura de medición, { $z } mm
plan-same-name = el nombre { $name } aparece dos veces{ $line ->
    [0] : los nombres de archivo de un control no distinguen mayúsculas
   *[other] , la primera en la línea { $line }: los nombres de archivo de un control no distinguen mayúsculas
}
plan-unknown = { $column } { $given } no es conocido: se esperaba { $known }
plan-other-side = el tipo { $given } contradice { $column } { $text }, que es de un { $side ->
    [hole] agujero
   *[shaft] eje
    }: corrija uno de los dos, o escriba diameter
plan-not-of = { $kind }: no tiene { $column }
plan-direction = el eje { $given } no es una dirección: se esperaba { $known }, o tres números como 0.5 0 -1, de -10 a 10 con 9 decimales como máximo y no todos 0
plan-no-band = { $text } no es una banda de tolerancia para un punto, como ±0.05 o +0.1/-0.05: { $error }
plan-band-side = un punto no puede tener desviaciones de { $lower } a { $upper } mm: el ciclo necesita una superior de 0 o mayor y una inferior de 0 o menor, no ambas 0
plan-side-class = { $callout }: ambos lados necesitan clases como { $example } ({ $kind })
plan-face-class = { $callout }: una cara se evalúa como medida exterior y necesita una clase de eje, como h9
plan-face-place = { $callout }: la cara está en { $coordinate } mm a lo largo del eje de medición, que debe ser su medida nominal
plan-not-a-plan = esto no es un plan: un plan tiene una línea con los nombres de sus columnas, como name;callout;x;y;z, o empieza con fitcheck_plan = 1
plan-other-version = este plan tiene la versión { $given }: se admiten las versiones 1 a { $newest }
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = clave desconocida { $key }: se esperaba { $known }
plan-other-value = { $key }: se esperaba { $expected }, se encontró { $found }
plan-parameter = el ciclo { $cycle } no toma { $given } de un plan: escriba NAME=VALUE con uno de { $known }
plan-no-parameter = ningún ciclo de medición toma { $given } de un plan: escriba NAME=VALUE, como Q423=3
plan-travel = { $axis }{ $given } está fuera del recorrido de la máquina, de { $minimum } a { $maximum } mm
plan-clearance-travel = el palpador se mueve en Z{ $height }, fuera del recorrido de la máquina, de { $minimum } a { $maximum } mm: indique otro clearance_height
plan-no-travel = { $given } no es un recorrido: escriba dos números, el menor primero, como -250 250
plan-no-plausible = { $column }: { $given } no es un intervalo: escriba dos longitudes en mm, la menor primero, como 24.5 25.5
plan-plausible-limits = { $column }: de { $lower } a { $upper } mm no contiene los límites de la medida, de { $minimum } a { $maximum } mm: indique un intervalo más amplio
plan-text = { $column }: se esperaba una línea de { $most } caracteres como máximo
plan-same-number = { $line ->
    [0] el número { $number } aparece dos veces: otro elemento tiene { $other }
   *[other] el número { $number } aparece dos veces: el elemento de la línea { $line } tiene { $other }
}
plan-same-size = { $line ->
    [0] un valor { $called } podría ser de este elemento o de { $other }: cambie el nombre de uno de los dos
   *[other] un valor { $called } podría ser de este elemento o de { $other }, en la línea { $line }: cambie el nombre de uno de los dos
}
plan-number-is-name = { $line ->
    [0] el número { $number } es el nombre de otro elemento, { $other }
   *[other] el número { $number } es el nombre de otro elemento, { $other }, en la línea { $line }
}
plan-name-is-number = { $line ->
    [0] un valor { $called } podría ser de este elemento o de { $other }, que tiene ese número
   *[other] un valor { $called } podría ser de este elemento o de { $other }, en la línea { $line }, que tiene ese número
}
plan-balloon = { $given } no es un lugar de la imagen: se esperaba de 0 a 1
plan-not-found-unknown = no evaluado: ningún elemento del plan tiene este nombre, número o ubicación
plan-not-found-no-clue = no evaluado: el valor no tiene nombre, número ni ubicación, así que no corresponde a ningún elemento del plan
plan-not-found-half-place = no evaluado: ningún elemento del plan tiene este nombre o número, y una ubicación necesita X e Y
plan-not-found-contradiction = no evaluado: su nombre corresponde a { $name } del plan, pero su número a { $number }
plan-not-found-other-name = ningún elemento del plan se llama { $given }; { $name } tiene el mismo número, pero puede ser un número correlativo: nombre el elemento como en el plan, o indique su medida nominal
plan-not-found-running-number = no evaluado: solo su número corresponde a { $name } del plan, y puede ser un número correlativo, pues otras filas del archivo no son de este plan
plan-not-found-other-nominal = no evaluado: corresponde a { $name } del plan, pero su medida nominal es { $given } y la del plan es { $planned }
plan-not-found-other-limits = no evaluado: corresponde a { $name } del plan, pero sus límites { $given } no tienen nada en común con los del plan, { $planned }
plan-not-found-several = no evaluado: varios elementos del plan tienen esta ubicación: { $names }
plan-not-found-which-side = no evaluado: el valor no dice cuál de { $names } es
part-standing = medidos: { $measured }, pendientes: { $missing }, omitidos: { $skipped }
plan-not-found-other-kind = no evaluado: corresponde a { $name } del plan, pero es de otro tipo ({ $kind }), y se midió otra cosa
plan-remark-file = { $said }
plan-remark-left = { $name } se omite: { $why }
plan-remark-class-left = { $name }: { $class } tiene otros límites que el archivo; valen los del archivo
plan-remark-place-left = { $name }: no se tomó ninguna posición: { $why }
plan-remark-axes-assumed = posiciones: el archivo no dice a lo largo de qué ejes de coordenadas están sus agujeros y ejes; se supone Z
plan-remark-uncertainty-left = { $name }: la incertidumbre expandida de { $expanded } mm se omite, porque su mitad no es un número entero de nanómetros
plan-remark-clearance-raised = { $name } está por encima de la altura de seguridad habitual: se escribe { $height }
plan-simulated-no-place = { $name } no tiene ubicación en el plan: no se puede simular
plan-simulated-no-cycle = ningún ciclo mide { $name }: no se puede simular
