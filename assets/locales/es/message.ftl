# Where an error or a warning is in a file

located-in-file = { $what }: { $file }, línea { $line }, columna { $column }
located-in-line-of-file = { $what }: { $file }, línea { $line }
located-at-file = { $what }: { $file }
located-at-column = línea { $line }, columna { $column }: { $what }
located-at-line = línea { $line }: { $what }

# Textos propios del usuario

own-text-language = { $given } no empieza por el código de ningún idioma. El nombre de un archivo de textos propios empieza por uno de { $codes }, como nl_OurShop.ftl: cambie el nombre del archivo
own-text-too-large = el archivo tiene { $bytes } bytes, y un archivo de textos propios puede tener { $most }: deje solo los textos que son distintos
own-text-not-utf8 = el byte { $byte } no es UTF-8: guarde el archivo como UTF-8
own-text-syntax = { $given } no se puede leer como Fluent ({ $reason }). Escriba el nombre al principio de una línea, después = y el texto, y sangre las líneas siguientes
own-text-not-a-text = { $given } es un término o tiene atributos, y solo se pueden sustituir textos: escriba nombre = texto
own-text-unknown = no hay ningún texto { $name }, y ningún nombre se le parece. Los nombres son los de los textos incorporados: corríjalo o bórrelo
own-text-misspelt = no hay ningún texto { $name }. El nombre más parecido es { $nearest }: corríjalo o bórrelo
own-text-twice = { $name } está dos veces, primero en la línea { $first }, y ninguno de los dos cuenta: borre uno
own-text-empty = { $given } tiene un texto vacío, o una variante que no muestra nada: escriba un texto, o bórrelo para tener el incorporado
own-text-control = { $given } tiene el carácter de control { $code }, y solo se admiten caracteres visibles: bórrelo
own-text-too-much = { $given } tiene más de { $longest } caracteres, más de { $deepest } llaves anidadas o demasiadas variantes: escríbalo más sencillo
own-text-surplus = { $name } tiene { $given }, donde no se pone nada. Solo es posible { $allowed }: corríjalo o bórrelo
own-text-surplus-of-none = { $name } tiene { $given }, pero en este texto no se pone nada: bórrelo
own-text-lost = en { $name } falta { $lost } del texto incorporado, al menos en una variante, y algo no se diría: añádalo
own-text-read-back = { $name } dice de dónde viene un valor y se vuelve a leer de archivos, por eso no se puede sustituir: bórrelo
own-text-property = { $name } pertenece al idioma y no es un texto que se pueda sustituir: bórrelo
own-text-same-verdict = { $name } no cuenta, porque { $clash } dice { $word }, lo mismo que { $other }. Cada dictamen necesita una palabra propia, también junto a las incorporadas y las inglesas: dé a cada uno otra palabra
