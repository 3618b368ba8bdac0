## AQDEF of Q-DAS
aqdef-line = se esperaba una clave y un texto como K0001/1 25.012, o una línea de valores
aqdef-number = { $key }: { $reason }
aqdef-whole = { $key }: { $given } no es un número entero
aqdef-undeclared = valor de la característica { $number }, que no está declarada antes de esta línea
aqdef-of-all = { $key } con el número 0 sería el valor de todas las características: se omite
aqdef-cut-off = el archivo termina aquí sin fin de línea, así que { $given } puede estar cortado: se omite; si está completo, añada un fin de línea
aqdef-zeros = la línea tiene bytes de valor 0, así que el archivo no se escribió por completo: la línea se omite
aqdef-mark-between = K0002/0 { $given } está entre esta fila y la anterior y puede valer para cualquiera de las dos: el valor se omite
aqdef-twice = { $key } se da dos veces con textos distintos, antes con { $other }: los valores de esta característica no se evalúan
aqdef-fields = se esperaban como máximo { $most } campos en un valor, se encontraron { $found }
aqdef-no-values = { $count ->
        [0] ni características ni valores
        [one] 1 característica pero ningún valor: es un plan, no son mediciones
       *[other] { $count } características pero ningún valor: es un plan, no son mediciones
    }
aqdef-no-values-beside = { $count ->
        [0] ni características ni valores
        [one] 1 característica pero ningún valor
       *[other] { $count } características pero ningún valor
    }, y ningún { $file } de hasta { $most } MiB junto a este archivo: es un plan, no son mediciones; indique { $file } directamente si es mayor
aqdef-no-description = valores sin características: falta { $file } junto a este archivo
aqdef-count = características anunciadas por K0100: { $expected }, encontradas: { $found }: el archivo puede estar cortado
aqdef-too-large = las características ocupan más de { $most } MiB
aqdef-beside = { $file }, línea { $line }: { $reason }
aqdef-warning-count = características anunciadas por K0100: { $expected }, encontradas: { $found }: el archivo puede estar cortado
aqdef-warning-fewer = valores esperados: { $expected }, encontrados: { $found }
aqdef-warning-missing = { $count ->
        [one] 1 valor está vacío o marcado como ausente (K0002 es 255 o 256), desde esta línea: se omite
       *[other] { $count } valores están vacíos o marcados como ausentes (K0002 es 255 o 256), desde esta línea: se omiten
    }
aqdef-warning-skipped = datos omitidos: { $keys }
aqdef-warning-repeated = { $key } se da dos veces con textos distintos: se usa este
aqdef-warning-late = { $key } no pertenece a un valor leído justo antes: se omite
aqdef-warning-allowance = la medida nominal y la desviación límite dan { $limit }, pero el límite es otro: vale el límite
aqdef-warning-tolerance = { $key } tiene una tolerancia de { $given } mm, pero los límites dan { $expected } mm: valen los límites
aqdef-warning-no-limit = se da { $key }, pero K2120 o K2121 dice que no existe tal límite: se omite
aqdef-warning-kind-of-limit = { $given } no es un tipo de límite conocido (0, 1 o 2): se lee como límite
aqdef-warning-scrap-limit = el límite de desecho { $limit } difiere del límite: se omite, y un valor más allá del límite por este lado es desecho
aqdef-warning-scrap-feature = el límite de desecho es el de { $feature ->
        [hole] un agujero
       *[shaft] un eje
    }, pero { $callout } no lo es: vale la clase de tolerancia
aqdef-warning-cut-off = el archivo termina aquí sin fin de línea, y { $given } es más corto que los demás: puede estar cortado
aqdef-warning-zeros = el archivo tiene aquí bytes de valor 0, así que no se escribió por completo: pueden faltar valores
aqdef-warning-values-left = { $file } tiene { $count ->
        [one] 1 línea de valores, que no se lee
       *[other] { $count } líneas de valores, que no se leen
    }
aqdef-warning-values-beside = los valores vienen de { $file }, junto a este archivo, y los números de línea se refieren a él
aqdef-warning-description-beside = las características vienen de { $file }, junto a este archivo
aqdef-warning-beside = { $file }, línea { $line }: { $reason }
