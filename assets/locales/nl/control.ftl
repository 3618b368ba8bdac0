# control

# Maskers
mask-empty = het masker is leeg
mask-too-large = het masker is groter dan { $most } KiB
mask-unknown = { $found } is geen uitvoerregel, sleutelwoord of commentaar
mask-unclosed-quote = het aanhalingsteken wordt niet gesloten
mask-unknown-format = { $found } is geen formaat, toegestaan zijn %S %RS %F %LF %D %I %%
mask-too-wide = { $found } is te breed, hoogstens { $most }
mask-count = { $formats } formaten en { $parameters } parameters
mask-unknown-parameter = { $found } is geen parameter, toegestaan zijn Q, QL, QR, QS met een nummer, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = de ; aan het einde ontbreekt
mask-unknown-word = { $word } is onbekend en heeft geen werking
mask-behind-semicolon = { $found } achter de ; wordt overgeslagen
mask-undefined = { $name } heeft geen waarde
mask-text-as-number = { $name } is een tekst, het formaat vraagt een getal
mask-number-as-text = { $name } is een getal, het formaat vraagt een tekst
mask-not-finite = { $name } is geen eindig getal
# Meetprotocollen
log-empty = het bestand is leeg
log-no-log = hier staat geen meetprotocol: er is geen titelregel met het nummer van een meetcyclus
log-no-title = een protocol zonder titelregel: onbekend is met welke cyclus is gemeten
log-other-cycle = protocollen van cyclus { $cycle } worden niet gelezen, alleen die van { $known }
log-unit = maateenheid { $given } is niet 0 (mm) en niet 1 (inch)
log-count = { $section } heeft { $found } getallen, het moeten er { $expected } zijn
log-missing = { $section } ontbreekt: het protocol is afgebroken of niet volledig
log-no-label = voor { $given } staat niet wat het is
log-cut-figure = het bestand eindigt midden in dit getal: { $given } is misschien niet volledig
log-swapped = maximum { $maximum } ligt onder minimum { $minimum }
log-uneven = de grenzen { $minimum } en { $maximum } liggen niet gelijk om de nominale waarde { $nominal }
log-deviation = afwijking { $given } is niet werkelijke min nominale waarde, { $actual } - { $nominal }
log-not-positive = diameter { $given } is niet groter dan 0
log-section-nominal = het blok met nominale waarden
log-section-limits = het blok met grenswaarden
log-section-actual = het blok met werkelijke waarden
log-section-deviations = het blok met afwijkingen
log-no-unit = geen regel noemt de maateenheid: millimeter aangenomen
log-no-time = datum en tijd van de meting zijn niet bekend
log-no-deviations = de afwijkingen ontbreken: het protocol is misschien afgebroken
log-ignored = niet gebruikt: { $text }
log-text-before = de tekst voor het eerste protocol is niet gebruikt

## Tabellen
table-empty = het bestand is leeg
table-not-text = teken { $code } is geen tekst: dit is geen tabel of hij is beschadigd
table-line-too-long = de regel is langer dan { $limit } bytes
table-too-large = de tabel heeft meer dan { $limit } cellen
table-too-many-columns = de tabel heeft meer dan { $limit } kolommen
table-no-begin = een tabel begint met BEGIN en zijn naam, niet met { $found }
table-no-name = achter BEGIN ontbreekt de naam van de tabel
table-unclosed-quote = een aanhalingsteken is niet gesloten
table-unclosed-block = het blok { $block } van regel { $line } is niet afgesloten
table-second-block = de kolommen worden een tweede keer beschreven
table-unexpected = hier hoort { $expected } te staan, niet { $found }
table-not-a-size = { $key } is een geheel getal tot en met { $limit }, niet { $text }
table-no-columns = de regel met de namen van de kolommen ontbreekt
table-tab = hier staat een tab: alleen spaties houden kolommen uit elkaar
table-column-twice = kolom { $name } komt twee keer voor
table-short-row = de rij houdt op vóór kolom { $name }: vul hem aan met spaties, of schrijf - voor geen waarde
table-truncated = het bestand houdt midden in deze rij op, zonder [END]: misschien is het afgebroken
table-text-after-end = tekst na [END]: { $found }
table-no-end = [END] ontbreekt
table-begin-word = { $word } heeft in de BEGIN-regel geen bekende betekenis
table-width = kolom { $name } is hier { $found } tekens breed, maar in de beschrijving { $described }; de namen gelden
table-not-in-table = kolom { $name } is beschreven maar staat niet in de tabel
table-not-described = kolom { $name } is niet beschreven
table-skipped = { $name } is onbekend en is overgeslagen
table-write-too-wide = rij { $row }, kolom { $column }: { $text } past niet in { $width } tekens
table-write-too-many-columns = de tabel heeft { $columns } kolommen; een iTNC 530 kan er hoogstens { $limit } aan
table-write-too-long = de regels van de tabel hebben { $characters } tekens; een iTNC 530 kan er hoogstens { $limit } aan
table-write-reads-otherwise = de tabel is niet zo te schrijven dat hij gelijk teruggelezen wordt: controleer de namen van de tabel en zijn kolommen

## Tabellen met afwijkingen
deviations-no-tables = geen tabel met afwijkingen (*.tab met een kolom BEREICH) in deze map: { $folder }
deviations-two-range-columns = BEREICH en BEREIK staan er allebei: maar één ervan kan de maatbereiken bevatten
deviations-inch = de tabel is in inch: schrijf maatbereiken in millimeters en afwijkingen in micrometers
deviations-no-class = geen enkele kolom is een tolerantieklasse zoals H7
deviations-odd-rows = het aantal rijen is oneven, { $rows }: elk maatbereik heeft er twee, eerst de bovenafwijking en dan de onderafwijking
deviations-no-range = het einde van het maatbereik ontbreekt
deviations-other-range = bij het maatbereik tot en met { $end } mm staat in de tweede rij { $found }: herhaal het of laat het leeg
deviations-column = kolom { $column }: { $error }
deviations-half = kolom { $class } heeft maar één van de twee afwijkingen voor het maatbereik tot en met { $end } mm
deviations-touches = kolom { $column } en zijn buurkolom lopen in elkaar over: zet er een spatie tussen
deviations-no-deviations = geen tabel met afwijkingen, want de kolom BEREICH ontbreekt; overgeslagen: { $file }
deviations-range-alias = BEREIK is gelezen als BEREICH
deviations-no-numbers = kolom { $name } bevat geen getallen en is overgeslagen
deviations-mixed-case = kolom { $name } mengt hoofdletters en kleine letters, is dus geen tolerantieklasse en is overgeslagen

## Parameters
no-parameter = { $given } is geen parameter, toegestaan zijn Q, QL, QR en QS met een nummer

## Meetprotocollen schrijven
log-write-cycle = cyclus { $cycle } schrijft deze waarden niet
log-write-unit = een protocol is in mm of inch, niet in µm
log-write-character = { $given } is niet te schrijven: een protocol bevat geen teken U+{ $code }
log-write-program = { $given } wordt niet teruggelezen als pad van een programma: schrijf het zoals TNC:\PART\CHECK.H
log-write-unfinished = het bestand eindigt midden in een regel: misschien is het afgebroken, dus er wordt niets aan toegevoegd
log-write-reads-otherwise = het protocol is niet zo te schrijven dat het gelijk teruggelezen wordt: controleer datum, tijd en overige resultaten

## Protocol van cyclus 444
point-log-no-log = hier staat geen protocol van cyclus 444: de pagina bevat geen meting voor programma's
point-log-count = volgens de pagina zelf staan er { $expected } metingen in, maar het zijn er { $found }: hij is afgebroken of veranderd
point-log-cut-off = de meting heeft geen einde: de pagina is afgebroken
point-log-json = de meting is niet te lezen: { $what }
point-log-version = versie { $version } van het protocol is onbekend, bekend is alles tot en met { $known }
point-log-normal = normaal { $given } heeft geen richting: er zijn drie getallen nodig die niet alle 0 zijn
point-log-deviation = afwijking { $given } in { $axis } is niet gemeten min nominale coördinaat, { $difference }
point-log-along = afwijking { $given } langs de normaal volgt niet uit die van de assen, { $along }
point-log-band = bovenafwijking { $upper } ligt onder onderafwijking { $lower }
point-log-status = status { $given } volgt niet uit afwijking en tolerantie, { $status }
## The touch-probe table
probe-table-no-column = de tabel heeft geen kolom { $column }
probe-table-no-probe = de tabel heeft geen taster
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: dit moet { $least } zijn
probe-table-zero-or-more = 0 of meer
probe-table-above-zero = groter dan 0
probe-table-not-whole = { $column } = { $given }: er is een geheel getal nodig
probe-table-twice = taster { $number } komt twee keer voor

## The log of a cycle's result
cycle-log-other-verdict = de getallen in het protocol, afgerond op 0,0001 { $unit }, geven { $log } waar de cyclus { $cycle } gaf

## The block of a probing cycle
block-none = hier staat geen tastcyclus: een regel begint met TCH PROBE en een nummer, of met G785
block-second = een tweede tastcyclus: één tegelijk, de eerste begint op regel { $first }
block-unknown-cycle = TCH PROBE { $given }: de cycli zijn { $known }
block-not-a-parameter = { $given } is geen parameter: die schrijf je als { $example }
block-no-value = { $key } heeft geen waarde
block-twice = { $key } is twee keer gegeven, eerst op regel { $first }
block-unclosed-quote = een aanhalingsteken is niet gesloten
block-behind-end = { $given } staat achter het einde van de cyclus: elke regel behalve de laatste eindigt op ~
block-cut-off = de cyclus eindigt op ~, dus er ontbreekt een regel: het bestand is misschien afgebroken
block-reference = { $key } = { $given }: alleen een lopend programma weet wat er in { $given } staat
block-not-writable = { $key } = { $given }: een tekst in een cyclus bevat geen aanhalingsteken en geen regeleinde
block-unused = regel { $line }: { $text } hoort niet bij de tastcyclus en is niet gebruikt
block-unused-more = regel { $line }: { $text } hoort niet bij de tastcyclus en is niet gebruikt, en nog { $more }
