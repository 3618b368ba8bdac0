# exchange

# Metingen uit bestanden
exchange-format-logs = HEIDENHAIN-meetprotocollen zoals TCHPR421.TXT
exchange-format-log-444 = meetprotocollen van het tasten in 3D, geschreven door Fitcheck
exchange-format-contacts = meetpunten van één cirkel: x, y en eventueel z
exchange-format-measurements = metingen als CSV: naam, passing, gemeten
exchange-empty = het bestand is leeg
exchange-not-recognised = geen bestand van een bekend formaat
exchange-other-format = dit zijn { $format }, geen metingen als CSV
exchange-parquet-unknown = dit programma is gebouwd zonder Parquet: cargo build --release zonder verdere opties heeft het
exchange-parquet-stream = Parquet heeft zijn kolommen aan het eind en kan niet uit een pipe worden gelezen: geef het bestand bij zijn naam
exchange-parquet = dit Parquet-bestand kan niet worden gelezen: { $reason }
exchange-parquet-nested = kolom { $column } bevat kolommen of lijsten: alleen kolommen met enkele waarden kunnen worden beoordeeld
exchange-no-rows = geen enkele rij bevat een meting
exchange-no-measured-column = geen kolom met gemeten waarden: benoem die in de eerste regel, bijvoorbeeld id;passing;gemeten
exchange-several-columns = kolommen { $columns } kunnen elk { $role } zijn: benoem ze in de eerste regel, bijvoorbeeld id;passing;gemeten
exchange-role-id = de naam
exchange-role-tolerance = de passing
exchange-role-nominal = de nominale maat
exchange-role-measured = de gemeten waarde
exchange-role-time = de tijd
exchange-role-simulated = of de meting gesimuleerd is
exchange-unit = onbekende eenheid { $unit }: gebruik mm, µm of inch
exchange-row-short = { $expected } cellen verwacht, { $found } gevonden
exchange-row-long = { $expected } cellen verwacht, { $found } gevonden: is het scheidingsteken ook decimaalteken, of staat het in een tekst?
exchange-row-too-long = de rij is langer dan { $most } KiB
exchange-open-quote = een aanhalingsteken is op deze regel niet gesloten
exchange-callout = passing: { $reason }
exchange-nominal = nominale maat: { $reason }
exchange-nominal-differs = passing { $callout } klopt niet met de nominale maat { $nominal } in de eigen kolom
exchange-measured = gemeten: { $reason }
exchange-simulated = gesimuleerd: { $given } is geen true en geen false
exchange-decimal-sign = gemeten: { $given } heeft een ander decimaalteken dan de andere waarden: "{ $sign }"
exchange-not-positive = gemeten: een diameter van { $given } is niet groter dan 0
exchange-decimal-comma = { $joined } is misschien één getal met een decimale komma: gebruik een decimale punt of een ander scheidingsteken
exchange-other-feature = { $given } is { $feature ->
        [hole] een as, en dit zijn de boringen: zijn de bestanden verwisseld?
       *[shaft] een boring, en dit zijn de assen: zijn de bestanden verwisseld?
    }
exchange-other-log = { $feature ->
        [hole] dit is het meetprotocol van een as, en dit zijn de boringen: zijn de bestanden verwisseld?
       *[shaft] dit is het meetprotocol van een boring, en dit zijn de assen: zijn de bestanden verwisseld?
    }
exchange-not-a-size = { $what }: dit is geen maat die kan worden gepaard
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
exchange-warning-not-used = overgeslagen, geen meting: { $text }
exchange-warning-comment = een regel die met # begint is commentaar, maar hier staat een meting in
exchange-warning-several-lines = de rij loopt binnen aanhalingstekens over { $lines } regels
exchange-warning-time = { $given } is geen datum en tijd: het tijdstip van importeren is gebruikt
exchange-warning-no-time = hier staat geen datum en tijd: de tijd van de import geldt
exchange-warning-offset = { $given } wordt bewaard als lokale tijd zonder het verschil met UTC
exchange-warning-cut-off = het bestand eindigt hier zonder regeleinde, en { $given } heeft minder decimalen dan de andere waarden: het is misschien afgekapt

# Meetpunten
contacts-file-empty = het bestand bevat geen meetpunten
contacts-no-columns = de kopregel moet x en y noemen en mag z noemen; er staat { $given }
contacts-twice = kolommen { $first } en { $second } zijn allebei { $name }
contacts-cells = { $wanted } cellen verwacht, { $cells } gevonden: { $given }
contacts-not-a-number = { $name } is { $given }, geen getal in millimeters
contacts-row-too-long = de rij is langer dan { $most } KiB
contacts-comment = een regel die met # begint is commentaar, maar hier staan coördinaten in: haal de # weg, of de hele regel
contacts-too-many = het bestand heeft meer dan { $most } meetpunten
contacts-open-quote = een aanhalingsteken is niet gesloten
contacts-mixed-signs = { $given } heeft een ander decimaalteken dan de rijen ervoor

## Tables of deviations
table-format-name = { $name } begint niet met een letter: tabelnamen op een TNC7 wel
table-format-operator = { $name } bevat { $sign }: tabelnamen op een TNC7 hebben geen rekentekens
table-format-warning-lower-sign = de handleiding van PC-DMIS toont geen andere onderafwijking dan 0: controleer { $class } in PC-DMIS vóór gebruik, vooral de tekens
table-format-csv = de CSV kan niet worden geschreven: { $reason }
table-format-parquet-unknown = dit programma is gebouwd zonder Parquet: cargo build --release zonder verdere opties heeft het
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
exchange-correction = de waarde bij 20 °C volgt niet uit de gemeten waarde en haar temperaturen: verwacht worden de kolommen zoals Fitcheck ze schrijft
exchange-warning-corrected = waarden met een cel in de kolom as_measured_mm gelden al bij 20 °C
sizes-warning-named-twice = { $rows ->
        [one] een rij heeft de naam van een eerdere rij
       *[other] { $rows } rijen hebben de naam van een eerdere rij
    }, zoals { $id } op regels { $first } en { $second }: elke rij telt als een onderdeel
sizes-warning-simulated-rows = { $count ->
        [one] 1 rij is gesimuleerd
       *[other] { $count } rijen zijn gesimuleerd
    }: er is niets gemeten
exchange-position-out = het middelpunt lag buiten positie, en een bestand heeft alleen de maat
exchange-undecided = hier was niets beslist: { $given }
exchange-warning-other-rule = de uitslagen van dit bestand kunnen volgens een andere beslisregel zijn (kolom rule_name): de waarden worden opnieuw beoordeeld
