# tolerance

## Lengths
length-empty = falta una longitud
length-not-a-number = { $text } no es un número
length-ambiguous = { $text } es ambiguo: escriba un solo signo decimal y ningún separador de miles
length-too-fine = { $text } es más fino que un nanómetro
length-too-large = { $text } es demasiado grande: como máximo { $max } mm en ambos sentidos

## Callouts and classes
callout-empty = falta una cota: escriba una medida nominal y una clase de tolerancia, como 25 H7
callout-no-nominal = { $text } no empieza con una medida nominal: escríbala, como en 25 H7
callout-nominal = medida nominal: { $error }
callout-not-positive = la medida nominal { $nominal } mm no es mayor que 0
class-missing = falta una clase de tolerancia, como H7 para un agujero o h7 para un eje
class-mixed-case = { $text } mezcla mayúsculas y minúsculas: escriba { $upper } para un agujero o { $lower } para un eje
class-malformed = { $text } no es una clase de tolerancia: escriba letras y un grado, como H7 o js13

## Deviations and limits
deviations-order = la desviación superior { $upper } mm es menor que la desviación inferior { $lower } mm
nominal-by-operator = ? significa que el operario posiciona el palpador: escriba el valor nominal sin este signo
nominal-not-probed = @ significa que el control no palpa y toma el valor que sigue: no se mediría nada
source-choice-iso286 = ISO 286, todas las clases hasta 3150 mm
source-choice-control = Las tablas del control, 47 clases hasta 400 mm
source-choice-after-own = Tablas propias, después { $base }
source-iso286 = ISO 286, más de { $over } hasta { $to } mm
source-iso286-remark = ISO 286, más de { $over } hasta { $to } mm; { $remark }
source-shipped-table = tabla integrada { $name }, más de { $over } hasta { $to } mm
source-table = tabla { $name }, más de { $over } hasta { $to } mm
figure-own-table = { $class } más de { $over } hasta { $to } mm: la tabla { $table } difiere de ISO 286, que tiene { $upper } y { $lower } mm
figure-standard = { $class } más de { $over } hasta { $to } mm: { $why }
source-file = archivo { $name }
source-iso2768 = ISO 2768-1 clase { $class }, más de { $over } hasta { $to } mm
source-callout = la propia cota
source-without-own = { $source }; las tablas propias de { $folder } no se pudieron leer
source-recorded = { $text }
limits-own-awaited = Las tablas propias de { $folder } aún se están leyendo
limits-no-feature = { $callout } no dice si se trata del agujero o del eje
limits-other-feature = { $feature ->
    [hole] { $class } es una clase de agujero y no de eje
   *[shaft] { $class } es una clase de eje y no de agujero
}
limits-other-case = { $feature ->
    [hole] { $class } es una clase de agujero y no está en la tabla { $table }; la clase de eje es { $other }
   *[shaft] { $class } es una clase de eje y no está en la tabla { $table }; la clase de agujero es { $other }
}
limits-unknown-class = { $class } no está en la tabla { $table }, que tiene { $known }
limits-no-own-table = { $class } no es una clase de tolerancia de ISO 286: escriba letras y un grado, como H7 o js13, o elija tablas propias con una columna { $class }
limits-no-own-column = { $class } no es una clase de tolerancia de ISO 286, y la tabla { $table } no tiene ninguna columna { $class }: tiene { $known }
limits-beyond-last-range = la medida nominal { $nominal } mm supera la tabla { $table }, cuyo último intervalo es más de { $over } hasta { $to } mm inclusive
limits-not-defined = { $class } no está definida para medidas de más de { $over } hasta { $to } mm en la tabla { $table }; { $where }
limits-defined-nowhere = no está definida en ninguna medida
limits-defined = está definida para medidas de { $ranges }
limits-range = más de { $over } hasta { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = los límites de { $nominal } mm son demasiado grandes

## Zones out of all proportion
zone-micrometres = una zona de { $width } mm no guarda proporción con { $nominal } mm, cuyo IT 18 es { $widest } mm: si las desviaciones están en micrómetros, escriba { $offer }
zone-wide = una zona de { $width } mm no guarda proporción con { $nominal } mm, cuyo IT 18 es { $widest } mm: revise la medida nominal y los límites
zone-micrometres-to-zero = el límite mínimo { $minimum } mm no es mayor que 0: si las desviaciones están en micrómetros, escriba { $offer }
zone-to-zero = el límite mínimo { $minimum } mm no es mayor que 0: revise la medida nominal y los límites
zone-coordinate-micrometres = una zona de { $width } mm es más ancha que { $widest } mm, el máximo para una coordenada: si las desviaciones están en micrómetros, escriba { $offer }
zone-coordinate = una zona de { $width } mm es más ancha que { $widest } mm, el máximo para una coordenada: revise los límites

shape-no-ranges = la tabla no tiene ningún intervalo de medidas
shape-not-ascending = el intervalo hasta { $end } mm no termina por encima del anterior, { $before } mm
shape-cells = la columna { $class } tiene { $cells } celdas para { $ranges } intervalos de medidas
shape-twice = la columna { $class } aparece dos veces

## Verdicts
status-good = BUENO
status-accepted = ACEPTADO
status-rework = RETRABAJO
status-re-measure = REMEDIR
status-out-of-limits = FUERA DE LÍMITES
status-scrap = DESECHO
rule-simple = sin banda de guarda, los límites pertenecen a la zona
rule-iso14253-2017 = ISO 14253-1:2017, 95 % de conformidad, { $prover ->
    [customer] el cliente demuestra la no conformidad
   *[supplier] el proveedor demuestra la conformidad
    }; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, banda de guarda U, { $prover ->
    [customer] el cliente demuestra la no conformidad
   *[supplier] el proveedor demuestra la conformidad
    }; { $u }
rule-ilac-g8 = ILAC-G8, banda de guarda { $factor } U, { $prover ->
    [customer] el cliente demuestra la no conformidad
   *[supplier] el proveedor demuestra la conformidad
    }; { $u }
rule-asme-simple = ASME B89.7.3.1, aceptación simple 4:1; { $u }
rule-asme-stringent = ASME B89.7.3.1, aceptación estricta, banda de guarda { $factor } U; { $u }
rule-asme-relaxed = ASME B89.7.3.1, aceptación relajada en { $factor } U; { $u }
rule-fixed = banda de guarda { $width } µm, { $prover ->
    [customer] el cliente demuestra la no conformidad
   *[supplier] el proveedor demuestra la conformidad
    }
rule-no-uncertainty = la regla { $rule } necesita la incertidumbre del valor medido
rule-no-factor = la regla { $rule } no tiene factor
rule-no-width = la regla { $rule } calcula su banda de guarda a partir de la incertidumbre
rule-width-missing = la regla { $rule } necesita una banda de guarda mayor que 0 µm
rule-no-prover = la regla { $rule } no depende de la carga de la prueba
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = una incertidumbre debe ser mayor que 0 µm
uncertainty-factor = factor de cobertura { $given }: se esperaba un número de 1 a 10, con tres decimales como máximo
uncertainty-by-budget = u de cada valor según el balance
undecided-contacts = con estos { $contacts } puntos de palpación, el diámetro es { $times } veces menos seguro que con { $contacts } puntos en todo el círculo, pero la incertidumbre dada solo vale hasta 3 veces: reparta los puntos en un arco más largo, o indique un balance
doubt-times-inch = el valor medido es 25,4 veces la medida nominal: ¿se convirtió dos veces de pulgadas?
doubt-inches = el valor medido es la medida nominal dividida por 25,4: ¿está en pulgadas?
doubt-double = el valor medido es el doble de la medida nominal: ¿se tomó un diámetro por un radio?
doubt-half = el valor medido es la mitad de la medida nominal: ¿es un radio?
doubt-decimal-sign = el valor medido es aproximadamente la medida nominal con el signo decimal en otro lugar: ¿son { $meant } mm?
doubt-far = el valor medido está { $distance } mm fuera de los límites: ¿es de esta pieza y está en milímetros?
doubt-implausible = el valor medido está fuera de lo que el plan considera posible, de { $lower } a { $upper } mm: ¿son correctos la unidad y el signo decimal?

## Files
file-is-folder = es una carpeta, no un archivo: { $path }
file-missing = no existe el archivo o la carpeta: { $path }
file-exists = ya existe un archivo o una carpeta con este nombre: { $path }
file-half-set = la escritura de un juego de archivos se detuvo a la mitad, así que unos archivos de la carpeta son nuevos y otros antiguos: escriba de nuevo el juego para terminarla; lo que falta por mover está en { $path }
file-not-a-file = es una canalización o un dispositivo, no un archivo: { $path }
file-changed = el archivo cambió mientras se leía; léalo de nuevo: { $path }
file-busy = el archivo está abierto en otro programa: ciérrelo allí e inténtelo de nuevo: { $path }
file-stopped = detenido: no se ha escrito nada: { $path }
file-too-large = el archivo es mayor que { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-grade-missing = { $class } no es una clase de tolerancia de ISO 286: escriba letras y un grado, como H7 o js13
iso286-no-grade = { $class } no es una clase de tolerancia de ISO 286: los grados son { $grades }
iso286-no-letter = { $class } no es una clase de tolerancia de ISO 286: la letra { $letters } no existe, solo { $known }
iso286-too-large = la medida nominal { $nominal } mm supera ISO 286, que termina en 3150 mm
iso286-not-here = { $class } no está definida a { $nominal } mm en ISO 286; { $where }
iso286-js-rounded = JS redondeado como en 1988
iso286-contested-ef = discutido: aquí ef es 28 µm, otras fuentes tienen 25 µm
iso286-older-it5 = experimental; los catálogos antiguos tienen aquí un IT5 menor
iso286-trial-use = experimental

## Fits
fit-kind-clearance = ajuste con juego
fit-kind-transition = ajuste indeterminado
fit-kind-interference = ajuste con apriete
fit-basis-hole = agujero base
fit-basis-shaft = eje base
fit-basis-both = agujero base y eje base
fit-preferred-hole-basis = ajuste preferente de agujero base
fit-preferred-shaft-basis = ajuste preferente de eje base
fit-function-loose-running = giratorio amplio
fit-function-free-running = giratorio libre
fit-function-close-running = giratorio preciso
fit-function-sliding = deslizante
fit-function-locational-clearance = posicionamiento con juego
fit-function-locational-transition = posicionamiento indeterminado
fit-function-locational-transition-tighter = posicionamiento indeterminado, más apretado
fit-function-locational-interference = posicionamiento con apriete
fit-function-medium-drive = apriete medio
fit-function-force = apriete forzado
fit-one-sided = { $callout } no es un ajuste: escriba una medida, una clase de agujero y una clase de eje, como 25 H7/g6
fit-not-a-hole = { $minimum } a { $maximum } mm son los límites de un eje: se esperaban los de un agujero
fit-not-a-shaft = { $minimum } a { $maximum } mm son los límites de un agujero: se esperaban los de un eje
fit-nominal-sizes = un ajuste tiene una sola medida nominal: el agujero tiene { $hole } mm, el eje { $shaft } mm
fit-too-large = el juego es demasiado grande
fit-search-order = el juego mínimo { $minimum } mm es mayor que el juego máximo { $maximum } mm
fit-search-no-classes = las tablas no tienen clases para agujero y eje a { $nominal } mm
fit-thermal-too-fine = { $text } tiene más de tres decimales
fit-thermal-temperature = una temperatura de { $text } °C está fuera del intervalo: de -273,15 a 1000 °C
fit-thermal-expansion = una dilatación de { $text } está fuera del intervalo: de -20 a 500, en millonésimas por kelvin, como 11,5 para el acero
fit-thermal-expansion-unit = una dilatación de { $text } está en otra unidad: las dilataciones van en millonésimas por kelvin; escriba { $meant }

## Temperatures that are doubted
thermal-doubt-fahrenheit = { $given } °C está lejos de toda temperatura a la que se miden piezas: si son grados Fahrenheit, escriba { $meant }
thermal-doubt-kelvin = { $given } °C está lejos de toda temperatura a la que se miden piezas: si son kelvin, escriba { $meant }
thermal-doubt-far = { $given } °C está lejos de toda temperatura a la que se miden piezas, de { $least } a { $most } °C: revísela
thermal-doubt-beyond = { $given } °C está fuera de { $least } a { $most } °C, donde vale una dilatación de { $expansion } millonésimas por kelvin: indique la dilatación para esta temperatura

## Materials
material-published = valor publicado
material-verify = valor usual, por verificar
material-own = valor propio
material-toml = { $reason }
material-version = no se admite la versión { $found } del archivo de materiales: se esperaba la versión { $known }
material-too-many = { $count } materiales son demasiados: como máximo { $most }
material-too-large = un archivo de materiales tiene como máximo { $most } bytes
material-name = el nombre de un material tiene de 1 a { $longest } caracteres y ningún carácter de control
material-range = un intervalo de temperaturas empieza por la más baja: escriba dos números en °C, como [-50, 200]
material-elastic = modulus y poisson van juntos: modulus de 1 a 1200000 MPa, poisson de 0 a 0.5, yield de 1 a 10000 MPa
material-twice = el material { $name } está definido dos veces
material-unknown = material desconocido { $name }: elija uno de { $known }, o indique la propia dilatación, como 11,5
## Callouts: deviations, limits, fits and general tolerances
callout-at = { $reason } (carácter { $at })
callout-no-tolerance = falta la tolerancia, como H7, h7, H7/g6, m, +0,1 -0,2 o ±0,1
callout-general-capital = { $capital } no tiene grado: escriba { $offer } para la tolerancia general de ISO 2768-1, o añada un grado, como { $capital }7
callout-fit-order = el eje está antes que el agujero: escriba { $offer }
callout-fit-side = { $first } y { $second } no son un agujero y un eje: un ajuste se escribe con mayúsculas y después minúsculas, como 25 H7/g6
callout-number = { $part }: { $error }
callout-not-a = { $found } no sirve como { $part }: { $how }
callout-missing = falta esto: { $part }; { $how }
callout-part-deviation = desviación
callout-part-limit = medida límite
callout-part-actual = valor tras @
callout-how-deviation = escriba un signo y un número, como +0,1 o -0,1
callout-how-limit = escriba dos medidas, la mayor primero, como 12,01/11,985
callout-how-actual = escriba un número, como 10H7@10,004
callout-no-sign = { $number } no tiene signo: escriba +{ $number } o -{ $number } para una desviación, sin espacio dentro del número
callout-no-unit = { $number } no tiene unidad y la otra desviación está en µm: escriba la unidad tras ambas
callout-deviation-order = la desviación inferior está antes que la superior: escriba { $offer }
callout-limits-order = el límite menor está antes que el mayor: escriba { $offer }
callout-limits-apart = { $larger } mm es más del doble de { $smaller } mm, así que probablemente no son límites: escriba desviaciones, como 12 +0,2 0
callout-limits-or-deviation = es ambiguo: escriba { $limits } para medidas límite o { $deviation } para una desviación inferior
callout-limits-meant = con tal desviación no quedaría ninguna medida: escriba { $limits } para medidas límite
callout-minimum-not-positive = el límite mínimo { $minimum } mm no es mayor que 0
callout-micrometres-meant = el límite mínimo { $minimum } mm no es mayor que 0: si las desviaciones están en micrómetros, escriba { $offer }
callout-mixed-decimals = { $number } tiene un signo decimal distinto del número anterior: use uno solo
callout-cycle-sign = { $sign } es para los textos de los ciclos 14xx, no para una cota
callout-not-in-cycle-text = { $found } no puede estar en un texto de los ciclos 14xx: escriba una clase, una clase general o desviaciones
callout-too-much = { $found } sobra aquí: el texto está completo sin ello
callout-too-long = el texto es demasiado largo: como máximo { $most } caracteres
callout-band-order = la desviación inferior está antes que la superior: escriba QS400 como 0.4-0.1
callout-lone-order = la desviación inferior está antes que la superior: escriba { $offer }
callout-inch = { $given } son { $nominal } mm: las cotas son en milímetros, escriba { $offer }
callout-inch-size = { $given } son { $nominal } mm: escriba medida y tolerancia en milímetros
callout-inch-somewhere = { $given } está en pulgadas: escriba medida y tolerancia en milímetros, 1 pulgada son 25.4 mm
callout-thread = { $given } es una rosca, no un agujero o eje liso: escriba el diámetro interior o medio con ambos límites, como 5.153/4.917
callout-exact = una cota teóricamente exacta no tiene tolerancia propia: escriba la medida con los límites que le corresponden, como 25 ±0.1
callout-reference = una cota entre paréntesis es solo auxiliar y no tiene tolerancia: escríbala sin paréntesis si debe juzgarse
callout-one-sided = { $given } solo tiene un límite: escriba ambos límites, primero el mayor, como 8.2/8
callout-roughness = { $given } es una rugosidad, no una medida: escriba una medida con su tolerancia, como 25 H7
callout-modifier = { $given } no es un modificador de ISO 14405-1: los modificadores son { $known }
callout-grade = { $given } no está definido a { $nominal } mm: escriba un grado de IT1 a IT18 que ISO 286 tenga ahí
callout-ansi = { $class } es una clase de ANSI B4.1, cuyas tablas Fitcheck no tiene: escriba una clase de ISO 286, o medida y desviaciones en milímetros
callout-stated-micrometres = las desviaciones tras la tolerancia son desproporcionadas para { $nominal } mm: si están en micrómetros, escriba ({ $offer })
callout-stated-of-fit = las desviaciones tras un ajuste pueden ser de cualquiera de las piezas: escríbalas tras cada clase
iso286-grade-alone = { $class } es un grado: dice lo ancha que es una zona, pero no dónde está; escriba ±{ $grade }/2 o una clase, como H7
general-too-small = la medida nominal { $nominal } mm es menor que { $first } mm, donde empieza ISO 2768-1: escriba las desviaciones junto a la medida
general-too-large = la medida nominal { $nominal } mm supera ISO 2768-1, que termina en { $last } mm
general-not-defined = ISO 2768-1 no define la clase { $class } { $range }; está definida { $defined }
general-range-from = desde { $over } hasta { $to } mm

## Tables made of the standard
make-no-class = no se ha dado ninguna clase de tolerancia: indique una o varias, como H7 H8 JS9
make-both-features = { $hole } y { $shaft } no pueden estar en una misma tabla: solo se distinguen por mayúsculas y minúsculas, así que cree una tabla para agujeros y otra para ejes
make-last-size = la última medida es { $to } mm: debe ser mayor que 0 y como máximo 3150 mm

## Press fits
press-no-interference = el ajuste tiene un juego de al menos { $clearance } mm: un ajuste a presión necesita apriete, como 40 H7/s6
press-length = la longitud { $length } mm no es mayor que 0
press-hub-outer = el diámetro exterior del cubo { $given } mm no es mayor que el diámetro de la unión, { $nominal } mm
press-shaft-bore = agujero del eje { $given } mm: escriba 0 para un eje macizo, o un agujero menor que { $nominal } mm
press-roughness = la rugosidad { $given } mm es menor que 0
press-friction = un ajuste a presión necesita un rozamiento mayor que 0
press-material = el módulo de elasticidad de { $name } no se conoce: elija otro material, o añada modulus y poisson a un archivo de materiales propios
press-ratio = { $text } no es un número de 0 a 1 con tres decimales como máximo
press-yields = NO ELÁSTICO: la tensión { $part ->
    [hole] del cubo
   *[shaft] del eje
    } sería de { $stress } MPa, por encima de su límite elástico de { $limit } MPa: la teoría elástica no se aplica, y no se dice que nada aguante
press-yield-unknown = no se sabe si { $part ->
    [hole] el cubo
   *[shaft] el eje
    } fluye: su material no tiene aquí límite elástico; indique uno
press-may-be-loose = las piezas pueden tener un juego de { $clearance } mm: la unión puede no aguantar nada
press-all-smoothed = el aplastamiento de la rugosidad, { $loss } mm, puede agotar el apriete: la unión puede no aguantar nada
press-no-roughness = no se indicó rugosidad Rz: no se resta ninguna pérdida de apriete por aplastamiento
press-too-hot = calentar solo el cubo no basta hasta { $most } °C, donde se conoce su dilatación
press-too-cold = enfriar solo el eje no basta, ni en nitrógeno líquido
press-contraction-unknown = la contracción del material del eje en frío no se conoce: se usa su dilatación, el eje quizá deba estar más frío
