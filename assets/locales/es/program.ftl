# NC programs

## Reading
program-empty = el programa está vacío
program-too-large = el programa es mayor que { $most } MiB
program-too-many-lines = el programa tiene más de { $most } líneas
program-binary = el archivo no es texto: { $controls } de sus { $bytes } bytes no son caracteres
program-no-begin = el programa no empieza con BEGIN PGM
program-second-begin = segundo BEGIN PGM
program-no-end = falta END PGM
program-units = END PGM dice { $end }, BEGIN PGM dice { $begin }
program-after-end = el texto después de END PGM no forma parte del programa
program-no-section = falta { $section }
program-no-unit = la cabecera no da la unidad (#EINHEIT METRISCH / INCH): el programa se lee como uno en mm
program-after-last-section = después de ENDE / END solo pueden venir subprogramas
program-unclosed-comment = al comentario le falta el corchete de cierre ]
program-numbers = el número de frase { $number } sigue a { $previous }; números de frase fuera de orden: { $count }
program-label-again = LBL { $label } ya está definido en la línea { $first }
program-unclosed-quote = las comillas no están cerradas
program-open-end = la línea termina en ~, pero no sigue nada
program-cycle-cut = el ciclo { $cycle } terminó en la línea { $line }, que no tiene ~ al final: { $parameter } no forma parte de él y en su lugar se asignaría
program-no-star = la frase no termina en *
program-iso-no-end = falta la última frase: % con el nombre del programa
program-iso-units = la última frase dice { $end }, la primera { $begin }
program-iso-after-end = el texto después de la última frase no forma parte del programa
program-iso-cycle-cut = el ciclo { $cycle } terminó en la línea { $line }: { $parameter } no forma parte de él y en su lugar se asignaría
program-comment-holds = { $found } forma parte del comentario, que termina al final de su línea
program-cycle-without-tilde = el ciclo { $cycle } terminó en la línea { $line }, que no tiene ~ al final: las líneas que siguen se leen como parte de él
program-block-goes-on = la frase anterior termina en ~, así que esta frase sería parte de ella
program-comment-goes-on = el comentario termina en ~, así que esta frase sería parte de él
program-not-understood = no se entiende: { $reason }
program-more = más observaciones que no se muestran: { $count }

## Labels
program-label-missing = LBL { $label } no aparece en el programa
program-label-twice = LBL { $label } está definido dos veces, en la línea { $first } y en la línea { $second }
program-label-zero = LBL 0 termina un subprograma: no se puede saltar a él
program-label-parameter = qué label contiene { $label } solo se sabe mientras se ejecuta el programa

## Why a block is not understood
program-missing = falta { $wanted }
program-unexpected = se esperaba { $wanted }, se encontró { $found }
program-left-over = texto inesperado { $found }
program-unknown-function = { $found } no es una función
program-number-size = { $found } es demasiado grande
program-parameter-range = { $found } no es un parámetro: { $family } va de { $least } a { $most }
program-range = { $found } es demasiado grande: como máximo { $most }
program-label-of-parameter = { $parameter } no puede ser el nombre del label que empieza aquí
program-relation = FN { $number } compara con { $allowed }: se encontró { $found }
program-not-together = { $one } y { $other } no pueden estar en la misma frase
program-unknown-word = { $found } no es conocido
program-no-form = la forma ISO de { $found } no es conocida
program-measure-unknown = no se sabe si aquí está activo G90 o G91
program-and-with-or = AND y OR en una misma condición necesitan paréntesis que muestren cuál va primero
program-letter-twice = { $letters } se da dos veces
program-second-unit = antes se dio otra unidad
program-acts-in-unit = las «units» quedan sin efecto, pero esta frase mide, llama o fija una variable
program-shifts-in-unit = las «units» quedan sin efecto, pero esta frase puede desplazar el punto cero
program-alone = { $found } sin { $missing }
program-axis-twice = un eje se da dos veces
program-too-deep = paréntesis y funciones están anidados en más de { $most } niveles
program-too-many-operands = la fórmula tiene más de { $most } operandos
program-too-long = la frase tiene más de { $most } caracteres
program-too-much = las fórmulas y las frases largas ocupan en total más de { $most } MiB
program-wanted-word = { $word }
program-wanted-number = un número
program-wanted-value = un número o un parámetro Q
program-wanted-value-or-variable = un número o una variable
program-wanted-variable = una variable (#l, #c, #g, #x, #i)
program-wanted-parameter = un parámetro
program-wanted-number-parameter = un parámetro Q, QL o QR
program-wanted-text-parameter = un parámetro QS
program-wanted-text = un texto entre comillas o un parámetro QS
program-wanted-label = un label
program-wanted-path = una ruta
program-wanted-relation = EQU, NE, GT, LT o IS
program-wanted-unit = MM o INCH
program-wanted-cycle-value = un valor
