# exchange

# Metingen uit bestanden
exchange-format-logs = HEIDENHAIN-meetprotocollen zoals TCHPR421.TXT
exchange-format-log-444 = meetprotocollen van het tasten in 3D, geschreven door Fitcheck
exchange-format-fn16 = FN 16-uitvoer van een besturing, gelezen via het masker (--mask)
exchange-format-series-table = tabel van een besturing die een programma met FN 27 vult, een regel per onderdeel
exchange-format-contacts = meetpunten van één cirkel: x, y en eventueel z
exchange-format-measurements = metingen als CSV: naam, passing, gemeten
exchange-empty = het bestand is leeg
exchange-not-recognised = geen bestand van een bekend formaat
exchange-model-not-read = een { $format }-model: Fitcheck leest geen modellen; exporteer de gemeten waarden als CSV, XLSX, QIF of AQDEF
exchange-drawing-not-read = een { $format }-tekening: Fitcheck leest geen tekeningen; exporteer de maten als CSV of XLSX
exchange-document-not-read = een { $format }-document: Fitcheck leest geen documenten; exporteer de waarden als CSV, XLSX, QIF of AQDEF
exchange-image-not-read = een { $format }-afbeelding: Fitcheck leest geen afbeeldingen; exporteer de waarden als CSV, XLSX, QIF of AQDEF
exchange-archive-not-read = een { $format }-archief: pak het uit en geef de bestanden erin
exchange-no-sheet = de werkmap heeft geen blad { $given }; wel { $sheets }
exchange-other-format = dit zijn { $format }, geen metingen als CSV
exchange-parquet-unknown = dit programma is gebouwd zonder Parquet: cargo build --release zonder verdere opties bouwt het in
exchange-parquet-stream = Parquet beschrijft zijn kolommen aan het einde van het bestand en kan niet uit een pipe worden gelezen: geef de naam van het bestand
exchange-parquet = dit Parquet-bestand kan niet worden gelezen: { $reason }
exchange-parquet-nested = kolom { $column } bevat kolommen of lijsten: alleen kolommen met enkele waarden kunnen worden beoordeeld
exchange-mask-backwards = { $mask }: { $reason }
exchange-mask-none = geen van de gegeven maskers drukt zo'n bestand af: { $masks }
exchange-mask-several = meerdere maskers drukken zo'n bestand af, geef alleen het masker dat het heeft geschreven: { $masks }
exchange-mask-no-measured = { $mask } drukt geen gemeten waarde af: Fitcheck herkent Q153 tot Q156, Q160 en elk ander getal waarvan de passing ernaast wordt afgedrukt
exchange-mask-measured = { $mask }: elk van deze getallen kan de gemeten waarde zijn: { $fields }; druk het resultaat van de cyclus af, zoals Q153; anders heeft het bestand passingen met verschillende grenzen nodig
exchange-print-ambiguous = dit kan door het masker op meerdere manieren worden gelezen
exchange-print-broken = het record eindigt te vroeg: de uitvoer van regel { $line } van het masker verwacht
exchange-print-other = het masker drukt zo’n regel niet af, maar er staan getallen in: het kan een record met een ontbrekende of gewijzigde waarde zijn; corrigeer of verwijder de regel
exchange-print-unit = regel { $line } noemt { $unit }, maar uitvoer van een besturing wordt in mm gelezen: druk de waarden in mm af
exchange-table-no-part = geen kolom zegt bij welk onderdeel een regel hoort: de tabel van een serie heeft een kolom zoals PART of SERIAL nodig
exchange-table-no-values = geen kolom bevat meetwaarden
exchange-table-no-value = welke kolom van { $name } de meetwaarde is, is niet duidelijk
exchange-table-touches = de cel in kolom { $column } raakt de cel ernaast, een van beide kan verkeerd gescheiden zijn: zet er een spatie tussen
exchange-table-unit = de tabel is in inch en kolom { $column } is niet van het type LENGTH, de waarden kunnen dus in mm zijn: gebruik het type LENGTH
exchange-no-rows = geen enkele rij bevat een meting
exchange-no-measured-column = geen kolom met gemeten waarden: benoem die in de eerste regel, bijvoorbeeld id;passing;gemeten
exchange-several-columns = kolommen { $columns } kunnen elk { $role } zijn: kies er een met import --columns, bijvoorbeeld { $word }=3, of benoem de kolommen in de eerste regel zo dat er maar één past, bijvoorbeeld id;passing;gemeten
exchange-role-id = de naam
exchange-role-tolerance = de passing
exchange-role-nominal = de nominale maat
exchange-role-measured = de gemeten waarde
exchange-role-time = de tijd
exchange-role-simulated = of de meting gesimuleerd is
exchange-role-number = het nummer
exchange-role-part = het onderdeel
exchange-role-serial = het serienummer
exchange-role-who = wie heeft gemeten
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = wat gemeten is
exchange-role-upper = de bovenafwijking
exchange-role-lower = de onderafwijking
exchange-role-minus = de onderafwijking zonder minteken
exchange-role-maximum = de bovengrens
exchange-role-minimum = de ondergrens
exchange-role-kind = gat of as
exchange-role-units = de eenheid
exchange-role-status = de status
exchange-role-machine = de machine
exchange-role-batch = de partij
exchange-role-sample = een monster
exchange-no-column = { $role } zou in kolom { $given } moeten staan, maar het bestand heeft { $columns }
exchange-column-twice = kolom { $column } kan niet tegelijk { $first } en { $second } zijn
exchange-unit = onbekende eenheid { $unit }: gebruik mm, µm of inch
exchange-limit = grens: { $reason }
exchange-tolerance-unsigned = de tolerantie { $given } heeft geen teken: schrijf ±{ $given }, of beide afwijkingen, zoals +0.02 0
exchange-minus-again = de onderafwijking { $given } heeft een minteken, maar de andere niet: schrijf ze alle met hun teken
exchange-limits-contradict = { $callout } heeft de grenzen { $minimum } tot { $maximum }, maar de kolommen zeggen { $given }: voor de maataanduiding --columns { $columns } opgeven, voor de kolommen --columns callout=-
exchange-limits-or-deviations = kolommen { $columns } kunnen grenzen zijn of afwijkingen van de nominale maat: kies met --columns, zoals maximum={ $upper },minimum={ $lower } of upper={ $upper },lower={ $lower }
exchange-limits-or-readings = kolommen { $columns } kunnen grenzen zijn, of de grootste en de kleinste van meerdere metingen: kies met --columns, zoals maximum={ $upper },minimum={ $lower } voor grenzen of maximum=-,minimum=- voor metingen
exchange-minus-or-plus = de onderafwijkingen in kolom { $columns } hebben geen teken: kies met --columns, minus={ $lower } voor onder de nominale maat of lower={ $lower } voor erboven
exchange-samples-side-by-side = meerdere meetwaarden staan naast elkaar in kolommen { $columns }: lees ze met fitcheck import, of kies er een met --columns, zoals measured={ $first }
exchange-unit-stated = regel { $line } noemt de eenheid { $unit }, die niet wordt ondersteund (“{ $text }”): gebruik mm, µm of inch, of kies de eenheid van de maten (--columns unit=mm)
exchange-unit-mentioned = regel { $line } noemt { $unit } (“{ $text }”), maar niets zegt of de waarden in die eenheid staan: kies de eenheid van de maten (--columns unit=mm, um of inch)
exchange-units-differ = “{ $at }” zegt { $unit }, “{ $other-at }” zegt { $other }: corrigeer een van beide
exchange-unit-late = regel { $line } noemt { $unit } (“{ $text }”), maar de rijen erboven zijn gelezen in { $read }: zet de eenheid boven de eerste rij of corrigeer die regel
exchange-unit-stray = deze regel noemt { $unit } (“{ $text }”), maar alle andere rijen zijn gelezen in { $read }: zet de eenheid boven de eerste rij of corrigeer deze regel
exchange-unit-given = de gekozen eenheid is { $given }, maar het bestand zegt { $unit } (“{ $text }”): kies { $unit } of corrigeer het bestand
exchange-unit-half = kolom { $column } is in inch en kolom { $open } noemt geen eenheid: zet die bij beide namen of kies de eenheid van de maten (--columns unit=inch)
exchange-unit-missing = de eenheid van deze rij ontbreekt: vul mm, µm of inch in of kies de eenheid van de maten (--columns unit=mm)
exchange-callout-unit = { $given }: de rij is in inch en een passing met een maat of afwijkingen is in mm: zet de nominale maat in een eigen kolom naast de klasse
exchange-row-short = { $expected } cellen verwacht, { $found } gevonden
exchange-row-long = { $expected } cellen verwacht, { $found } gevonden: is het scheidingsteken ook decimaalteken, of staat het in een tekst?
exchange-row-too-long = de rij is langer dan { $most } KiB
exchange-open-quote = een aanhalingsteken is op deze regel niet gesloten
exchange-header-hides-rows = regel { $line }: de kop loopt over meer regels en een daarvan lijkt op een rij: sluit de aanhalingstekens op de regel waar ze opengaan
exchange-within-quotes = deze regel kan een rij of een opmerking zijn: aanhalingstekens gaan hierboven open en hier of hieronder dicht; sluit ze op de regel waar ze opengaan
exchange-callout = passing: { $reason }
exchange-nominal = nominale maat: { $reason }
exchange-nominal-differs = passing { $callout } klopt niet met de nominale maat { $nominal } in de eigen kolom
exchange-measured = gemeten: { $reason }
exchange-simulated = gesimuleerd: { $given } is geen true en geen false
exchange-other-header = deze regel noemt andere kolommen dan de eerste: beoordeel de rijen eronder als een apart bestand
exchange-below-other-header = niet beoordeeld: regel { $line } noemt andere kolommen. Beoordeel de rijen eronder als een apart bestand
exchange-simulated-below = de rijen onder deze regel zijn gesimuleerd: beoordeel ze als een apart bestand, of met fitcheck import
exchange-origin = herkomst: { $given } zegt niet of er gemeten of gesimuleerd is; schrijf gemeten, getypt of gesimuleerd, of stel simulated=- in als deze kolom iets anders zegt
exchange-decimal-sign = gemeten: { $given } heeft een ander decimaalteken dan de andere waarden: "{ $sign }"
exchange-not-positive = gemeten: een diameter van { $given } is niet groter dan 0
exchange-decimal-comma = { $joined } is misschien één getal met een decimale komma: gebruik een decimale punt of een ander scheidingsteken
exchange-other-feature = { $given } is { $feature ->
        [hole] een as, en dit zijn de boringen: zijn de bestanden verwisseld?
       *[shaft] een boring, en dit zijn de assen: zijn de bestanden verwisseld?
    }
exchange-rejected = het bestand keurt deze waarde zelf af ({ $given }): verwijder de rij of corrigeer die in het bestand
exchange-no-part = { $given } is de naam van een kengetal over meerdere onderdelen of van de instelmaat van een meetmiddel, en niet van een onderdeel: verwijder de rij of geef het onderdeel een andere naam
exchange-other-log = { $feature ->
        [hole] dit is het meetprotocol van een as, en dit zijn de boringen: zijn de bestanden verwisseld?
       *[shaft] dit is het meetprotocol van een boring, en dit zijn de assen: zijn de bestanden verwisseld?
    }
exchange-not-a-size = { $what }: dit is geen maat die kan worden gepaard
exchange-no-place-axis = het ligt langs { $axis }, maar de cycli 421 en 422 tasten langs Z
exchange-no-place-no-axis = het bestand zegt niet langs welke as het ligt
exchange-no-place-kind = { $kind }: de cycli 421 en 422 tasten alleen cirkels en cilinders
exchange-no-place-system = het wordt gecontroleerd in coördinatensysteem { $system }, maar de coördinaten gelden in dat van het bestand
exchange-contacts-not-sizes = rijen van twee of drie getallen zijn meetpunten: benoem de kolommen in de eerste regel, bijvoorbeeld id;gemeten
exchange-too-many-rows = alleen de eerste { $most } rijen zijn gelezen: splits het bestand
exchange-unjudged-no-callout = niet beoordeeld: geen passing opgegeven
exchange-unjudged-no-limits = niet beoordeeld: de grensmaten in het meetprotocol zijn 0, dus de diameter is niet bewaakt
exchange-unjudged-coordinate = een coördinaat van cyclus { $cycle }, geen boring of as
exchange-unjudged-coordinate-without-limits = niet beoordeeld: de grenzen in het meetprotocol zijn 0, dus de coördinaat is niet bewaakt
exchange-unjudged-size = { $what } van cyclus { $cycle }, geen boring of as
exchange-unjudged-size-without-limits = niet beoordeeld: de grenzen in het meetprotocol zijn 0, dus niet bewaakt: { $what }
exchange-unjudged-point = een oppervlaktepunt van cyclus { $cycle }: de afwijking langs de normaal is geen maat
exchange-unjudged-point-without-tolerance = niet beoordeeld: het punt is zonder tolerantie getast
exchange-unjudged-contacts = niet beoordeeld: { $count } meetpunten zonder passing
exchange-warning-ignored-columns = overgeslagen kolommen: { $columns }
exchange-warning-quantity-unknown = kolom { $column } heeft geen bekend woord voor wat gemeten is ({ $words }): al haar waarden worden als maten gelezen; klopt dat, geef dan import --columns quantity=- op
exchange-warning-not-used = overgeslagen, geen meting: { $text }
exchange-warning-minus-supplied = kolom { $column } heeft geen mintekens: de waarden worden gelezen als onderafwijkingen onder de nominale maat
exchange-warning-callouts-unnamed = kolom { $column } lijkt de passingen te bevatten, maar de naam is niet bekend: noem de kolom passing, of geef het nummer met --columns, zoals callout=2
exchange-warning-limits-read = kolommen { $columns } worden als grenzen gelezen
exchange-warning-head-read = gelezen voor alle waarden: { $said }
exchange-warning-samples-read = kolommen { $columns } worden gelezen als onderdelen naast elkaar: elke waarde wordt apart beoordeeld, een lege cel is geen waarde, en zonder serienummers is elke kolom een eigen onderdeel
exchange-warning-comment = een regel die met # begint is commentaar, maar hier staat een meting in
exchange-warning-several-lines = de rij loopt binnen aanhalingstekens over { $lines } regels
exchange-warning-time = { $given } is geen datum en tijd: het tijdstip van importeren is gebruikt
exchange-warning-place = { $given } is geen lengte: de plaats is overgeslagen
exchange-warning-no-time = hier staat geen datum en tijd: het tijdstip van importeren is gebruikt
exchange-warning-offset = { $given } wordt bewaard als lokale tijd zonder het verschil met UTC
exchange-warning-cut-off = het bestand eindigt hier zonder regeleinde, en { $given } heeft minder decimalen dan de andere waarden: het is misschien afgekapt
exchange-warning-open-end = het bestand eindigt hier zonder regeleinde: de laatste waarde, { $given }, is misschien afgekapt

# Meetpunten
contacts-file-empty = het bestand bevat geen meetpunten
contacts-no-columns = de kopregel moet x en y noemen en mag z noemen; er staat { $given }
contacts-twice = kolommen { $first } en { $second } zijn allebei { $name }
contacts-cells = { $wanted } cellen verwacht, { $cells } gevonden: { $given }
contacts-not-a-number = { $name } is { $given }, geen getal in millimeters
contacts-row-too-long = de rij is langer dan { $most } KiB
contacts-comment = een regel die met # begint is commentaar, maar hier staan coördinaten in: verwijder de #, of de hele regel
contacts-other-unit = meetpunten staan in mm, maar deze regel noemt { $given }: reken ze om naar mm
contacts-too-many = het bestand heeft meer dan { $most } meetpunten
contacts-simulated = deze meetpunten zijn gesimuleerd en meten niets: gebruik in plaats daarvan een werkstukbestand
contacts-origin = { $given } zegt niet of er gemeten of gesimuleerd is: schrijf gemeten of gesimuleerd, of verwijder de kolom
contacts-open-quote = een aanhalingsteken is niet gesloten
contacts-mixed-signs = { $given } heeft een ander decimaalteken dan de rijen ervoor

## Tables of deviations
table-format-name = { $name } begint niet met een letter: op een TNC7 is dat verplicht voor tabelnamen
table-format-operator = { $name } bevat { $sign }: in tabelnamen op een TNC7 mogen geen rekentekens staan
table-format-warning-lower-sign = de handleiding van PC-DMIS toont geen andere onderafwijking dan 0: controleer { $class } in PC-DMIS vóór gebruik, vooral de tekens
table-format-csv = de CSV kan niet worden geschreven: { $reason }
table-format-parquet-unknown = dit programma is gebouwd zonder Parquet: cargo build --release zonder verdere opties bouwt het in
table-format-parquet = het Parquet-bestand kan niet worden geschreven: { $reason }
table-format-itnc530 = besturingstabel voor iTNC 530
table-format-tnc640 = besturingstabel voor TNC 620 en TNC 640
table-format-tnc7 = besturingstabel voor TNC7
table-format-plain-csv = CSV, een regel per klasse en maatbereik
table-format-plain-parquet = Parquet, een rij per klasse en maatbereik
table-format-pcdmis = CSV met ISO-toleranties voor PC-DMIS

## Grensmaten als SQL
sql-border = tabel { $table }: een maatbereik eindigt bij { $end } mm; voor SQL moeten bereiken bij hele millimeters eindigen
sql-too-far = tabel { $table }: een maatbereik eindigt bij { $end } mm; voor SQL moeten bereiken uiterlijk bij { $most } mm eindigen
sql-twice = klasse { $class } is twee keer genoemd
exchange-correction = de waarde bij 20 °C volgt niet uit de gemeten waarde en haar temperaturen: de kolommen zoals Fitcheck ze schrijft verwacht
exchange-warning-corrected = waarden met een cel in de kolom as_measured_mm gelden al bij 20 °C
sizes-warning-named-twice = { $rows ->
        [one] een rij heeft de naam van een eerdere rij
       *[other] { $rows } rijen hebben de naam van een eerdere rij
    }, zoals { $id } op regels { $first } en { $second }: elke rij telt als een onderdeel
sizes-warning-simulated-rows = { $count ->
        [one] 1 rij is gesimuleerd
       *[other] { $count } rijen zijn gesimuleerd
    }: er is niets gemeten
exchange-position-out = het midden lag buiten positie, maar het bestand heeft alleen de maat
exchange-undecided = hier was niets beslist: { $given }
exchange-warning-other-rule = de oordelen in dit bestand kunnen van een andere beslisregel komen (kolom rule_name): de waarden worden opnieuw beoordeeld
exchange-read = de rest van het bestand kan niet worden gelezen: { $reason }
exchange-too-large = groter dan { $most } MiB, de grens voor bestanden van dit formaat
exchange-unjudged-one-limit = niet beoordeeld: een van de twee grensmaten ontbreekt
exchange-unjudged-no-tolerance = niet beoordeeld: geen grensmaten opgegeven
exchange-unjudged-rounded = niet beoordeeld: de afgedrukte cijfers staan voor elke waarde van { $from } tot { $to }, en daartussen ligt een grensmaat: druk meer decimalen af
exchange-unjudged-implausible = niet beoordeeld: { $measured } mm kan niet: het plan noemt { $lower } tot { $upper } mm; controleer eenheid en decimaalteken, of meet opnieuw
exchange-unjudged-swapped-limits = niet beoordeeld: de ondergrens { $minimum } ligt boven de bovengrens { $maximum }
exchange-unjudged-not-a-size = { $what }: geen maat van een boring of as
exchange-warning-limits-differ = { $callout } heeft de grensmaten { $minimum } tot { $maximum } en het bestand heeft andere: die van het bestand tellen
exchange-warning-class-unknown = klasse { $given } heeft hier geen grensmaten: die van het bestand tellen
exchange-warning-status-differs = het bestand zegt { $given }, maar de grenzen zeggen { $status }
exchange-warning-status-unknown = het bestand zegt { $given }, en dat is geen bekende status: de grenzen zeggen { $status }
exchange-warning-limit-differs = het bestand zegt { $given }, maar de grenzen zijn { $minimum } tot { $maximum }
exchange-warning-deviation-differs = het bestand zegt { $given }, maar dat is niet de afwijking van { $measured } ten opzichte van { $nominal }
exchange-warning-feature-differs = het bestand zegt { $given }, maar de grenzen zijn die van { $feature ->
        [hole] een boring
       *[shaft] een as
    }
exchange-warning-temperature-differs = het bestand zegt { $given }, maar de waarde telt als gemeten bij { $counted } °C: geef --temperature en --material op
exchange-warning-speaks-of-temperature = het bestand noemt een andere temperatuur dan { $counted } °C, waarbij de waarden als gemeten tellen: { $text }
exchange-warning-speaks-of-unit = een opmerking noemt een andere eenheid dan die van de waarden: { $text }
exchange-warning-speaks-of-simulation = deze regel noemt een simulatie: controleer of de waarde is gemeten: { $text }
exchange-warning-all-nominal = alle { $count } waarden zijn precies hun nominale maat: misschien is dit een lijst van maten die niemand heeft gemeten
exchange-warning-name-of-no-size = { $given } is niet de naam van een maat van één onderdeel, maar de waarde is wel zo beoordeeld
exchange-warning-other-values = kolommen met andere maten dicht bij de gemeten maten worden niet beoordeeld: { $columns }
exchange-warning-part-rejected = het bestand zegt { $given } over het hele onderdeel
exchange-warning-uncertainty-not-used = het bestand noemt een uitgebreide onzekerheid van { $expanded } mm: geen regel gebruikt die, geef in plaats daarvan --u op
exchange-warning-plan-differs = het bestand heeft de grensmaten { $minimum } tot { $maximum }: die van het plan tellen
exchange-warning-plan-differs-below = het bestand heeft de ondergrens { $minimum }: die van het plan telt
exchange-warning-above-own-limit = niet van het plan, en boven de bovengrens van zijn bestand, { $maximum }
exchange-warning-below-own-limit = niet van het plan, en onder de ondergrens van zijn bestand, { $minimum }
exchange-warning-plan-differs-above = het bestand heeft de bovengrens { $maximum }: die van het plan telt
exchange-warning-plan-differs-nominal = het bestand heeft de nominale maat { $nominal }: die van het plan telt
exchange-warning-part-differs = het bestand noemt onderdeel { $given }: het wordt beoordeeld als { $part }, het onderdeel van het plan
exchange-warning-found-by-number-of = geen element van het plan heet { $given }; op nummer gevonden: { $name } van het plan
exchange-warning-found-by-place-of = geen element van het plan heet { $given }; op plaats gevonden: { $name } van het plan
exchange-warning-found-by-number = op nummer gevonden: { $name } van het plan
exchange-warning-found-by-place = op plaats gevonden: { $name } van het plan
exchange-format-aqdef = AQDEF van Q-DAS, in één bestand of als .dfd en .dfx
exchange-format-calypso = tabellen met kenmerken van CALYPSO, zoals NAAM_chr.txt
exchange-format-calypso-text = CALYPSO-rapporten, opgeslagen als tekst
exchange-format-geopak = toleranties van MCOSMOS (GEOPAK) in een bestand zonder kolomnamen
exchange-format-gauge = regels van meetmiddelen in een bestand, zoals 01A+025.012
exchange-format-pcdmis = tekstrapporten van PC-DMIS
exchange-format-probed = afdrukken van tastmacro's, zoals Renishaw en CAM-systemen ze schrijven
exchange-warning-unit-assumed = geen eenheid gegeven: lengten zonder eenheid zijn gelezen als mm
exchange-warning-unit-read = lengten zijn gelezen in { $unit }, zoals het bestand zegt: { $text }
exchange-warning-rounded = { $given } heeft cijfers voorbij de nanometer: afgerond op de dichtstbijzijnde
exchange-warning-rounded-values = { $count ->
        [one] 1 gemeten waarde heeft cijfers voorbij de nanometer, vanaf deze regel: afgerond op de dichtstbijzijnde
       *[other] { $count } gemeten waarden hebben cijfers voorbij de nanometer, vanaf deze regel: afgerond op de dichtstbijzijnde
    }
exchange-unjudged-quantity = { $quantity ->
        [102] rondheid (K2009 is 102)
        [109] positie (K2009 is 109)
        [117] een coördinaat (K2009 is 117)
       *[other] een andere grootheid dan een diameter (K2009 is { $quantity })
    }: geen maat van een boring of as
exchange-unjudged-kind = niet gemeten: { $kind ->
        [1] een telling van afgekeurde onderdelen (K2004 is 1)
        [5] een foutenlijst (K2004 is 5)
        [6] een foutenlijst (K2004 is 6)
       *[other] een onbekende soort kenmerk (K2004 is { $kind })
    }
exchange-unjudged-attribute = niet beoordeeld: gemerkt met { $given } (K0002); alleen van 0 is bekend dat de waarde geldig is
exchange-unjudged-not-valid = niet beoordeeld: het bestand zegt { $said }, dus er is misschien geen geldige waarde
exchange-unjudged-declaration = niet beoordeeld: regel { $declaration } van de beschrijving is niet te gebruiken
exchange-format-qif = QIF 2.0, 2.1, 3.0: resultaten van meetsoftware, en meetplannen
exchange-xml = geen welgevormde XML: { $reason }
exchange-xml-doctype = een DOCTYPE wordt niet ondersteund: verwijder die, of exporteer het bestand zonder
exchange-xml-entity = entiteit { $name } is onbekend: alleen &lt; &gt; &amp; &quot; en &apos; worden gelezen
exchange-xml-depth = de grens van { $most } geneste elementen is bereikt
exchange-xml-long = een tag of tekst is langer dan { $most } KiB
exchange-xml-mixed = { $name } heeft een element midden in zijn tekst
exchange-xml-cut-off = het bestand eindigt binnen een element: misschien is het afgekapt
exchange-xml-encoding = onbekende codering { $given }: gebruik UTF-8, UTF-16 of ISO 8859-1
exchange-xml-bytes = deze bytes zijn geen tekst in de codering van het bestand
exchange-qif-unit = lengte-eenheid { $unit }: de naam is onbekend of past niet bij de factor; gebruik mm, inch of een andere eenheid met haar factor naar meter
exchange-qif-no-unit = het bestand noemt geen lengte-eenheid: nodig is FileUnits met PrimaryUnits en LinearUnit
exchange-qif-reference = { $what } { $id } staat niet in het bestand
exchange-qif-too-many = het bestand heeft meer dan { $most } elementen { $what }
exchange-qif-no-value = hier geen gemeten waarde; status { $status }
exchange-qif-limit = grensmaten of nominale maat: { $reason }
exchange-qif-other-kind = de meting is van soort { $measured }, maar haar kenmerk van soort { $defined }
exchange-qif-several-values = de meting heeft meerdere waarden
exchange-qif-defined-as-limit = DefinedAsLimit ontbreekt of is geen true of false, dus de getallen kunnen grensmaten of afwijkingen zijn
exchange-qif-no-nominal = de grenzen zijn afwijkingen, maar er is geen nominale maat
exchange-qif-zone = klasse { $class } en { $zone } spreken elkaar tegen: hoofdletters zijn boringen, kleine letters zijn assen
exchange-qif-no-results = een QIF-bestand zonder gemeten waarden: een meetplan kan als onderdeelplan worden gelezen
exchange-qif-no-characteristics = het QIF-bestand noemt geen kenmerken
exchange-warning-standard-uncertainty-not-used = het bestand noemt een gecombineerde standaardonzekerheid van { $standard } en een gemiddelde afwijking van { $mean-error }: geen regel gebruikt die, geef in plaats daarvan --u op
exchange-warning-sheet-hidden = blad { $sheet } wordt gelezen, hoewel het in de werkmap verborgen is
exchange-warning-rows-hidden = { $count ->
    [one] rij { $rows } is in de werkmap verborgen of weggefilterd, maar wordt gelezen als de andere
   *[other] { $count } rijen zijn in de werkmap verborgen of weggefilterd, maar worden gelezen als de andere: { $rows }
}
exchange-warning-columns-hidden = verborgen kolommen worden gelezen als de andere: { $columns }
exchange-warning-qif-version = QIF-versie { $version }: dit programma is gemaakt voor de versies 2.0, 2.1 en 3.0
exchange-warning-qif-count = { $list } zegt n={ $said }, maar heeft er { $found }: er kan iets ontbreken of bijgekomen zijn
exchange-warning-qif-twice = id { $id } staat er twee keer: het eerste element telt
exchange-format-xlsx = metingen in een werkmap van een spreadsheetprogramma: kolommen zoals in CSV
exchange-workbook = deze werkmap kan niet worden gelezen: { $reason }
exchange-not-a-workbook = een ZIP-bestand, maar geen werkmap: pak het uit en geef de bestanden erin
exchange-old-workbook = een werkmap in het formaat { $format }, dat niet wordt ondersteund: sla die op als XLSX
exchange-workbook-password = de werkmap heeft een wachtwoord: sla die zonder wachtwoord op
exchange-zip-cut-off = het einde van de werkmap ontbreekt: misschien is die afgekapt
exchange-zip-members = de lijst van onderdelen van de werkmap is beschadigd of heeft meer dan { $most } vermeldingen
exchange-zip-bomb = { $member } wordt uitgepakt groter dan { $most } MiB, of is te dicht gecomprimeerd voor een werkmap: het wordt niet gelezen
exchange-zip-twice = twee onderdelen van de werkmap hebben dezelfde naam, dus is die gewijzigd: open de werkmap in een spreadsheetprogramma en sla die op
exchange-zip-texts = de werkmap heeft meer dan { $most } verschillende teksten
exchange-sheet-wide = cel { $cell } ligt voorbij de eerste { $most } kolommen
exchange-too-many-cells = het blad heeft meer dan { $most } cellen
exchange-cell = { $cell }: { $reason }
exchange-formula-without-value = de waarde van de formule ={ $formula } is niet opgeslagen: open de werkmap in een spreadsheetprogramma en sla die op
exchange-cell-split = de waarde van de cel is niet als één gewone tekst opgeslagen, dus alleen een deel ervan is leesbaar: open de werkmap in een spreadsheetprogramma en sla die op
exchange-cell-error = de cel toont { $error }
exchange-warning-sheets-left = blad { $sheet } wordt gelezen; andere bladen niet: { $left }
gauge-frame = de tekens om de regel zijn overgeslagen
gauge-channel = van kanaal { $channel }
gauge-inches = { $given } inch
gauge-error-text = { $given } kan een foutnummer van het meetmiddel zijn: is het een maat, schrijf die dan met de eenheid, { $given } mm
gauge-opinion = het meetmiddel zegt { $sign }; de grenzen van het plan beslissen
gauge-no-unit = { $given } noemt geen eenheid: geef in de instellingen van het meetmiddel op of het millimeters of inch stuurt
exchange-gauge-unit = regel { $line } van deze meetmiddelregels, { $given }, noemt mm noch inch: geef de eenheid met import --columns unit=mm of --columns unit=inch
gauge-other-form = { $given } verschilt in meer dan de cijfers van de regel waarmee het meetmiddel is aangeleerd, { $example }
gauge-other-decimals = { $given } heeft { $decimals ->
        [one] 1 decimaal
       *[other] { $decimals } decimalen
    }, en de regel waarmee het meetmiddel is aangeleerd heeft er { $taught }: het meetmiddel stuurt een andere eenheid, of een deel van het getal is verloren gegaan

teach-zero = 0 kan elke nul van de regel zijn: gebruik als voorbeeld een regel met een andere waarde
teach-not-text = { $line } bevat tekens die geen tekst zijn
teach-nowhere = { $value } mm staat niet in de regel { $line }: typ de waarde die het meetmiddel daarbij toonde
teach-twice = { $value } mm staat meer dan eens in de regel { $line }: gebruik als voorbeeld een regel met een andere waarde
teach-other-unit = de regel zegt { $given }, en dat is geen { $value } mm: typ de waarde die het meetmiddel toonde, in millimeters

mapping-no-value = { $given } wijst geen kolom toe: schrijf een woord, = en een kolom, zoals measured=3
mapping-word = { $given } is geen bekende inhoud van een kolom: toegestaan zijn { $allowed }
mapping-value = { $word }: { $given } is onbekend: toegestaan zijn { $allowed }
mapping-twice = { $word } staat er twee keer: noem het één keer
mapping-toml = geen toewijzing van kolommen: { $reason }

# Hoe een waarde met een plan beoordeeld is, en wat ernaast opgegeven was.
planned-rule = beoordeeld met de regel van het plan in plaats van { $given }: { $rule }
planned-uncertainty = beoordeeld met de onzekerheid van het plan in plaats van de opgegeven: { $u }
planned-material = naar 20 °C gecorrigeerd met het materiaal van het plan in plaats van het opgegeven: { $name }
planned-corrected = van { $temperature } °C naar 20 °C gecorrigeerd (uitzetting { $expansion } · 10⁻⁶/K)
planned-not-corrected = niet naar 20 °C gecorrigeerd: een plaats op het onderdeel is geen maat
planned-error-already-corrected = volgens het bestand geldt de waarde al bij 20 °C: beoordeel die zonder temperatuur
