# NC-programma's

## Lezen
program-empty = het programma is leeg
program-too-large = het programma is groter dan { $most } MiB
program-too-many-lines = het programma heeft meer dan { $most } regels
program-binary = het bestand is geen tekst: { $controls } van de { $bytes } bytes zijn geen tekens
program-no-begin = het programma begint niet met BEGIN PGM
program-second-begin = BEGIN PGM staat hier nog een keer
program-no-end = END PGM ontbreekt
program-units = bij END PGM staat { $end }, bij BEGIN PGM { $begin }
program-after-end = wat na END PGM staat, hoort niet bij het programma
program-numbers = regelnummer { $number } staat na { $previous }; regelnummers die niet oplopen: { $count }
program-label-again = LBL { $label } is al gedefinieerd in regel { $first }
program-unclosed-quote = het aanhalingsteken wordt niet gesloten
program-open-end = de regel eindigt op ~, maar er volgt niets meer
program-not-understood = niet begrepen: { $reason }
program-more = nog { $count } opmerkingen worden niet getoond

## Labels
program-label-missing = LBL { $label } komt in het programma niet voor
program-label-twice = LBL { $label } is twee keer gedefinieerd, in regel { $first } en regel { $second }
program-label-zero = LBL 0 sluit subprogramma's af, daar kan niets naartoe springen
program-label-parameter = welk label in { $label } staat, is pas tijdens het uitvoeren bekend

## Waarom een NC-regel niet begrepen wordt
program-missing = { $wanted } ontbreekt
program-unexpected = hier hoort { $wanted }, er staat { $found }
program-left-over = { $found } is te veel
program-unknown-function = { $found } is geen functie voor formules
program-number-size = { $found } is een te groot getal
program-parameter-range = { $found } is geen parameter, { $family } loopt van 0 tot { $most }
program-range = { $found } is te groot, hoogstens { $most }
program-label-of-parameter = { $parameter } kan het label dat hier begint geen naam geven
program-relation = FN { $number } vergelijkt met { $allowed }, er staat { $found }
program-axis-twice = een as is twee keer opgegeven
program-too-deep = haakjes en functies zijn dieper dan { $most } keer genest
program-too-many-operands = de formule heeft meer dan { $most } operanden
program-too-long = de NC-regel heeft meer dan { $most } tekens
program-too-much = formules en lange NC-regels zijn samen groter dan { $most } MiB
program-wanted-word = { $word }
program-wanted-number = een getal
program-wanted-value = een getal of een Q-parameter
program-wanted-parameter = een parameter
program-wanted-number-parameter = een Q-, QL- of QR-parameter
program-wanted-text-parameter = een QS-parameter
program-wanted-text = een tekst tussen aanhalingstekens of een QS-parameter
program-wanted-label = een label
program-wanted-path = een pad
program-wanted-relation = EQU, NE, GT, LT of IS
program-wanted-unit = MM of INCH
program-wanted-cycle-value = een waarde
