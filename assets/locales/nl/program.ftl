# NC-programma's

## Lezen
program-empty = het programma is leeg
program-too-large = het programma is groter dan { $most } MiB
program-too-many-lines = het programma heeft meer dan { $most } tekstregels
program-binary = het bestand is geen tekst: { $controls } van de { $bytes } bytes zijn geen tekens
program-no-begin = het programma begint niet met BEGIN PGM
program-second-begin = tweede BEGIN PGM
program-no-end = END PGM ontbreekt
program-units = END PGM zegt { $end }, BEGIN PGM zegt { $begin }
program-after-end = tekst na END PGM hoort niet bij het programma
program-no-section = { $section } ontbreekt
program-no-unit = de programmakop noemt geen eenheid (#EINHEIT METRISCH / INCH): het programma wordt gelezen als een in mm
program-after-last-section = na ENDE / END mogen alleen subprogramma's volgen
program-unclosed-comment = het commentaar heeft geen sluithaak ]
program-numbers = regelnummer { $number } volgt op { $previous }; regelnummers buiten de volgorde: { $count }
program-label-again = LBL { $label } is al gedefinieerd in tekstregel { $first }
program-unclosed-quote = het aanhalingsteken is niet gesloten
program-open-end = de tekstregel eindigt op ~, maar er volgt niets meer
program-cycle-cut = cyclus { $cycle } is in tekstregel { $line } geëindigd, omdat daar geen ~ aan het einde staat: { $parameter } hoort er niet bij en zou worden toegekend
program-no-star = de NC-regel eindigt niet op *
program-iso-no-end = de laatste NC-regel ontbreekt: % met de naam van het programma
program-iso-units = de laatste NC-regel zegt { $end }, de eerste { $begin }
program-iso-after-end = tekst na de laatste NC-regel hoort niet bij het programma
program-iso-cycle-cut = cyclus { $cycle } is in tekstregel { $line } geëindigd: { $parameter } hoort er niet bij en zou worden toegekend
program-comment-holds = { $found } hoort bij het commentaar, dat aan het eind van zijn regel eindigt
program-cycle-without-tilde = cyclus { $cycle } is in tekstregel { $line } geëindigd, omdat daar geen ~ aan het einde staat: de tekstregels daaronder worden als deel ervan gelezen
program-block-goes-on = de NC-regel hierboven eindigt op ~, zodat deze NC-regel erbij zou horen
program-comment-goes-on = het commentaar eindigt op ~, zodat deze NC-regel erbij zou horen
program-not-understood = niet begrepen: { $reason }
program-more = nog { $count } opmerkingen zijn niet vermeld

## Labels
program-label-missing = LBL { $label } komt in het programma niet voor
program-label-twice = LBL { $label } is twee keer gedefinieerd, in tekstregel { $first } en tekstregel { $second }
program-label-zero = LBL 0 sluit een subprogramma af: er kan niet naartoe worden gesprongen
program-label-parameter = welk label { $label } bevat, is pas bekend terwijl het programma loopt

## Waarom een NC-regel niet begrepen wordt
program-missing = { $wanted } ontbreekt
program-unexpected = { $wanted } verwacht, { $found } gevonden
program-left-over = onverwachte tekst { $found }
program-unknown-function = { $found } is geen functie
program-number-size = { $found } is te groot
program-parameter-range = { $found } is geen parameter: { $family } loopt van { $least } tot { $most }
program-range = { $found } is te groot: hoogstens { $most }
program-label-of-parameter = { $parameter } kan geen naam zijn van het label dat hier begint
program-relation = FN { $number } vergelijkt met { $allowed }: { $found } gevonden
program-not-together = { $one } en { $other } staan niet in één NC-regel
program-unknown-word = { $found } is niet bekend
program-no-form = de ISO-schrijfwijze van { $found } is niet bekend
program-measure-unknown = hier is niet bekend of G90 of G91 geldt
program-and-with-or = AND en OR in één voorwaarde hebben haakjes nodig die zeggen wat eerst komt
program-letter-twice = { $letters } is twee keer opgegeven
program-second-unit = er is al een andere eenheid genoemd
program-acts-in-unit = units worden overgeslagen, maar deze NC-regel meet, roept aan of stelt een variabele in
program-shifts-in-unit = units worden overgeslagen, maar deze NC-regel kan het nulpunt verschuiven
program-alone = { $found } zonder { $missing }
program-axis-twice = een as is twee keer opgegeven
program-too-deep = haakjes en functies zijn meer dan { $most } diep genest
program-too-many-operands = de formule heeft meer dan { $most } operanden
program-too-long = de NC-regel heeft meer dan { $most } tekens
program-too-much = formules en lange NC-regels zijn samen groter dan { $most } MiB
program-wanted-word = { $word }
program-wanted-number = een getal
program-wanted-value = een getal of een Q-parameter
program-wanted-value-or-variable = een getal of een variabele
program-wanted-variable = een variabele (#l, #c, #g, #x, #i)
program-wanted-parameter = een parameter
program-wanted-number-parameter = een Q-, QL- of QR-parameter
program-wanted-text-parameter = een QS-parameter
program-wanted-text = een tekst tussen aanhalingstekens of een QS-parameter
program-wanted-label = een label
program-wanted-path = een pad
program-wanted-relation = EQU, NE, GT, LT of IS
program-wanted-unit = MM of INCH
program-wanted-cycle-value = een waarde
