# control

# Maskers
mask-empty = het masker is leeg
mask-too-large = het masker is groter dan { $most } KiB
mask-unknown = { $found } is geen uitvoerregel, sleutelwoord of commentaar
mask-unclosed-quote = het aanhalingsteken is niet gesloten
mask-unknown-format = { $found } is geen formaat: toegestaan zijn %S %RS %F %LF %D %I %%
mask-too-wide = { $found } is te breed: hoogstens { $most }
mask-count = { $formats } formaten en { $parameters } parameters
mask-unknown-parameter = { $found } is geen parameter: toegestaan zijn Q, QL, QR, QS met een nummer, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = de ; aan het einde ontbreekt
mask-unknown-word = { $word } is onbekend en heeft geen werking
mask-behind-semicolon = { $found } na de ; is overgeslagen
mask-other-languages = het masker heeft tekst voor { $languages } en geen voor { $wanted }
mask-inverse-touching = { $first } en { $second } worden zonder iets ertussen afgedrukt, dus de uitvoer kan niet worden teruggelezen
mask-inverse-blanks = { $first } en { $second } zijn teksten met alleen spaties ertussen, dus de uitvoer kan niet worden teruggelezen: een tekst kan spaties bevatten
mask-inverse-no-mark = geen vaste tekst laat zien waar een record begint, dus de uitvoer kan niet worden teruggelezen
mask-inverse-too-long = het masker drukt meer dan { $most } regels tegelijk af: alleen kortere records worden teruggelezen
mask-inverse-no-number = het masker drukt geen getal af dat een gemeten waarde kan zijn
mask-undefined = { $name } is niet gedefinieerd
mask-text-as-number = { $name } is een tekst: het formaat verwacht een getal
mask-number-as-text = { $name } is een getal: het formaat verwacht een tekst
mask-not-finite = { $name } is geen eindig getal
# Meetprotocollen
log-empty = het bestand is leeg
log-no-log = geen meetprotocol: geen titelregel met het nummer van een meetcyclus
log-too-long = het meetprotocol heeft meer dan { $lines } regels, of een regel van meer dan { $bytes } bytes
log-no-title = het meetprotocol heeft geen titelregel: de cyclus is onbekend
log-other-cycle = meetprotocollen van cyclus { $cycle } worden niet gelezen, alleen die van { $known }
log-unit = maateenheid { $given } is geen 0 (mm) en geen 1 (inch)
log-count = { $section }: { $expected } getallen verwacht, { $found } gevonden
log-missing = { $section } ontbreekt: het meetprotocol is afgekapt of niet volledig
log-no-label = geen aanduiding vóór { $given }
log-cut-figure = het bestand eindigt midden in deze waarde: { $given } is misschien niet volledig
log-swapped = maximum { $maximum } ligt onder minimum { $minimum }
log-uneven = de grenzen { $minimum } en { $maximum } liggen niet symmetrisch om de nominale waarde { $nominal }
log-deviation = afwijking { $given } is niet werkelijke waarde min nominale waarde, { $actual } - { $nominal }
log-not-positive = diameter { $given } is niet groter dan 0
log-section-nominal = het blok met nominale waarden
log-section-limits = het blok met grenswaarden
log-section-actual = het blok met werkelijke waarden
log-section-deviations = het blok met afwijkingen
log-no-unit = de maateenheid is niet vermeld: millimeter aangenomen
log-no-time = datum en tijd van de meting zijn niet bekend
log-no-deviations = de afwijkingen ontbreken: het meetprotocol is misschien afgekapt
log-ignored = overgeslagen: { $text }
log-text-before = de tekst vóór het eerste meetprotocol is overgeslagen

## Tabellen
table-empty = het bestand is leeg
table-not-text = teken { $code } is geen tekst: het bestand is geen tabel of is beschadigd
table-line-too-long = de regel is langer dan { $limit } bytes
table-too-large = de tabel heeft meer dan { $limit } cellen
table-too-many-columns = de tabel heeft meer dan { $limit } kolommen
table-no-begin = een tabel begint met BEGIN en de naam, niet met { $found }
table-no-name = na BEGIN ontbreekt de naam van de tabel
table-unclosed-quote = een aanhalingsteken is niet gesloten
table-unclosed-block = het blok { $block } van regel { $line } is niet gesloten
table-second-block = de kolommen worden een tweede keer beschreven
table-unexpected = { $expected } verwacht, { $found } gevonden
table-not-a-size = { $key } moet een geheel getal tot en met { $limit } zijn, niet { $text }
table-no-columns = de regel met de namen van de kolommen ontbreekt
table-tab = tabteken: scheid kolommen alleen met spaties
table-column-twice = kolom { $name } komt twee keer voor
table-short-row = de rij eindigt vóór kolom { $name }: vul de rij aan met spaties, of schrijf - voor geen waarde
table-truncated = het bestand eindigt midden in deze rij, zonder [END]: misschien is het afgekapt
table-text-after-end = tekst na [END]: { $found }
table-no-end = [END] ontbreekt
table-no-lock = de gereedschapstabel heeft geen kolom TL: een gebroken gereedschap wordt er niet in geblokkeerd
table-no-unit = de tabel noemt haar eenheid niet: de lengten zijn als millimeters gelezen
table-begin-word = { $word } heeft in de BEGIN-regel geen bekende betekenis
table-width = kolom { $name } is hier { $found } tekens breed, maar in de beschrijving { $described }; de regel met kolomnamen geldt
table-not-in-table = kolom { $name } is beschreven maar staat niet in de tabel
table-not-described = kolom { $name } is niet beschreven
table-skipped = { $name } is onbekend en is overgeslagen
table-write-too-wide = rij { $row }, kolom { $column }: { $text } past niet in { $width } tekens
table-write-too-many-columns = de tabel heeft { $columns } kolommen: een iTNC 530 kan er hoogstens { $limit } aan
table-write-too-long = de regels van de tabel hebben { $characters } tekens: een iTNC 530 kan er hoogstens { $limit } aan
table-write-reads-otherwise = de tabel kan niet zo worden geschreven dat dezelfde tabel wordt teruggelezen: controleer de namen van de tabel en de kolommen

## Tabellen met afwijkingen
deviations-no-tables = geen tabel met afwijkingen (*.tab met een kolom BEREICH) in deze map: { $folder }
tables-contradict = { $first } en { $second } spreken elkaar tegen, { $class } boven { $over } tot en met { $to } mm: { $one ->
        [none] geen waarde
       *[other] { $one } µm
    } en { $other ->
        [none] geen waarde
       *[other] { $other } µm
    }: verwijder de kolom uit een van beide
deviations-two-range-columns = de tabel heeft zowel BEREICH als BEREIK: maar één ervan kan de maatbereiken bevatten
deviations-inch = de tabel is in inch: schrijf maatbereiken in millimeters en afwijkingen in micrometers
deviations-no-class = geen enkele kolom is een tolerantieklasse zoals H7
deviations-odd-rows = het aantal rijen is oneven ({ $rows }): elk maatbereik heeft er twee, eerst de bovenafwijking, dan de onderafwijking
deviations-no-range = het einde van het maatbereik ontbreekt
deviations-other-range = het maatbereik tot en met { $end } mm heeft in de tweede rij { $found }: herhaal het einde of laat het leeg
deviations-column = kolom { $column }: { $error }
deviations-half = kolom { $class } heeft maar één van de twee afwijkingen voor het maatbereik tot en met { $end } mm
deviations-touches = kolom { $column } en de kolom ernaast lopen in elkaar over: zet er een spatie tussen
deviations-no-deviations = overgeslagen, geen tabel met afwijkingen (geen kolom BEREICH): { $file }
deviations-range-alias = BEREIK is gelezen als BEREICH
deviations-other-column = kolom { $name } is overgeslagen, omdat een tolerantieklasse niet zo kan heten: in een tabel die uit deze wordt geschreven ontbreekt zij
deviations-no-numbers = kolom { $name } is overgeslagen, omdat zij teksten en geen afwijkingen bevat: in een tabel die uit deze wordt geschreven ontbreekt zij
deviations-mixed-case = kolom { $name } is overgeslagen, omdat een tolerantieklasse hoofdletters en kleine letters niet mengt: in een tabel die uit deze wordt geschreven ontbreekt zij

## Parameters
no-parameter = { $given } is geen parameter: toegestaan zijn Q, QL, QR en QS met een nummer

## Meetprotocollen schrijven
log-write-cycle = cyclus { $cycle } schrijft deze waarden niet
log-write-no-title = het meetprotocol van cyclus { $cycle } heeft geen titel in { $file }
log-write-unit = een meetprotocol is in mm of inch, niet in µm
log-write-character = { $given } kan niet worden geschreven: teken U+{ $code } mag niet in een meetprotocol staan
log-write-program = { $given } wordt niet als pad van een programma teruggelezen: schrijf het zoals TNC:\PART\CHECK.H
log-write-unfinished = het bestand eindigt midden in een regel: misschien is het afgekapt, dus er is niets aan toegevoegd
log-write-reads-otherwise = het meetprotocol kan niet zo worden geschreven dat hetzelfde wordt teruggelezen: controleer datum, tijd en overige meetresultaten

## Protocol van cyclus 444
point-log-no-log = geen meetprotocol van cyclus 444: de pagina bevat geen machineleesbare meting
point-log-count = de pagina vermeldt { $expected } metingen, maar bevat er { $found }: ze is afgekapt of gewijzigd
point-log-cut-off = de meting heeft geen einde: de pagina is afgekapt
point-log-json = de meting is onleesbaar: { $what }
point-log-version = versie { $version } van het meetprotocol wordt niet ondersteund: { $known } of ouder verwacht
point-log-normal = normaal { $given } heeft geen richting: drie getallen verwacht die niet alle drie 0 zijn
point-log-deviation = afwijking { $given } in { $axis } is niet gemeten coördinaat min nominale coördinaat, { $difference }
point-log-along = afwijking { $given } langs de normaal volgt niet uit die van de assen, { $along }
point-log-band = bovenafwijking { $upper } ligt onder onderafwijking { $lower }
point-log-status = status { $given } volgt niet uit afwijking en tolerantie, { $status }
## The touch-probe table
probe-table-no-column = de tabel heeft geen kolom { $column }
probe-table-no-probe = de tabel heeft geen tastsysteem
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: { $least } verwacht
probe-table-zero-or-more = 0 of meer
probe-table-above-zero = groter dan 0
probe-table-not-whole = { $column } = { $given }: een geheel getal verwacht
probe-table-twice = tastsysteem { $number } komt twee keer voor

## De gereedschapstabel
tool-table-no-column = de tabel heeft geen kolom { $column }
tool-table-no-tool = de tabel heeft geen gereedschap
tool-table-touches = { $column }: de cel loopt over in de cel ernaast, dus de waarde is onzeker
tool-table-no-number = { $column } = { $given }: een gereedschapsnummer van 0 tot en met 32767 verwacht, met of zonder index zoals 5.1
tool-table-twice = gereedschap { $number } komt twee keer voor
tool-table-name-too-long = NAME = { $given }: een naam heeft hoogstens { $most } tekens
tool-table-no-length = { $column }: { $error }
tool-table-out-of-range = { $column } = { $given } mm: { $least } tot en met { $most } mm verwacht
tool-table-no-lock = TL = { $given }: L of 1 verwacht voor een geblokkeerd gereedschap; 0, - of niets voor een vrij gereedschap
tool-table-not-whole = { $column } = { $given }: een geheel getal verwacht
tool-unknown = Q330 = { $tool }: de gereedschapstabel heeft dit gereedschap niet, maar wel { $known }
tool-no-deviation = Q330 = { $tool }: cyclus { $cycle } heeft hier geen grensmaten, dus is er geen afwijking om het gereedschap mee te corrigeren
tool-out-of-range = gereedschap { $tool }: { $column } zou van { $from } in { $to } mm veranderen: de grootste waarde is { $most } mm naar beide kanten
tool-broken = fout 1065: gereedschap { $tool } is gebroken: { $column } zou { $by } mm veranderen, { $limit } is { $most } mm; het gereedschap is geblokkeerd en niet gecorrigeerd
tool-broken-replacement = fout 1065: gereedschap { $tool } is gebroken: { $column } zou { $by } mm veranderen, { $limit } is { $most } mm; het gereedschap is geblokkeerd en niet gecorrigeerd; gereedschap { $replacement } vervangt het
tool-corrected = gereedschap { $tool }: { $column } { $by } mm gewijzigd, van { $from } in { $to } mm
tool-corrected-rounded = gereedschap { $tool }: { $column } { $by } mm gewijzigd, van { $from } in { $to } mm: de tabel bewaart de dichtstbijzijnde 0,00001 in
tool-locked = gereedschap { $tool }: geblokkeerd, TL = { $to }

## The log of a cycle's result
cycle-log-other-verdict = de waarden in het meetprotocol, afgerond op 0,0001 { $unit }, geven { $log }, maar de cyclus gaf { $cycle }

## The block of a probing cycle
block-none = geen tastcyclus: een NC-regel begint met TCH PROBE en een nummer, of met G785
block-inches = de NC-regel hoort bij een programma in inch, maar zou in mm worden gelezen: voer het programma uit
block-none-at = deze regel hoort bij geen meetcyclus: ze beginnen op de regels { $blocks }
block-second = tweede tastcyclus: geef er één tegelijk op; de eerste begint op regel { $first }
block-unknown-cycle = TCH PROBE { $given }: de cycli zijn { $known }
block-not-a-parameter = { $given } is geen parameter: schrijf een parameter zoals { $example }
block-no-value = { $key } heeft geen waarde
block-twice = { $key } is twee keer opgegeven, eerst op regel { $first }
block-unclosed-quote = een aanhalingsteken is niet gesloten
block-behind-end = { $given } staat na het einde van de NC-regel: elke tekstregel behalve de laatste eindigt op ~
block-too-many-parts = de tekstregel heeft meer dan { $most } delen tussen ~
block-cut-off = de NC-regel eindigt op ~, dus er ontbreekt een tekstregel: misschien is hij afgekapt
block-reference = { $key } = { $given }: de waarde van { $given } is alleen bekend terwijl een programma loopt
block-not-writable = { $key } = { $given }: een tekst in een NC-regel mag geen aanhalingstekens of regeleinden bevatten
block-unused = regel { $line }: { $text } hoort niet bij de tastcyclus en is overgeslagen
block-unused-more = regel { $line }: { $text } hoort niet bij de tastcyclus en is overgeslagen, en nog { $more }
