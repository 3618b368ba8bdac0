# exchange

# Metingen uit bestanden
exchange-format-logs = HEIDENHAIN-meetprotocollen zoals TCHPR421.TXT
exchange-format-log-444 = protocollen van het 3D-tasten, geschreven door Fitcheck
exchange-format-contacts = tastpunten van één cirkel: x, y en eventueel z
exchange-format-measurements = metingen als CSV: naam, passing, gemeten
exchange-empty = het bestand is leeg
exchange-not-recognised = geen bestand van een bekend formaat
exchange-no-rows = er staat geen regel met een meting in
exchange-no-measured-column = geen kolom met gemeten waarden: noem die in de eerste regel, bijvoorbeeld id;passing;gemeten
exchange-several-columns = kolommen { $columns } kunnen elk { $role } zijn: benoem ze in de eerste regel, bijvoorbeeld id;passing;gemeten
exchange-role-id = de naam
exchange-role-tolerance = de passing
exchange-role-nominal = de nominale maat
exchange-role-measured = de gemeten waarde
exchange-role-time = de tijd
exchange-role-simulated = of ze gesimuleerd is
exchange-unit = eenheid { $unit } is onbekend: gebruik mm, µm of inch
exchange-row-short = de regel heeft { $found } cellen, het moeten er { $expected } zijn
exchange-row-long = de regel heeft { $found } cellen, het moeten er { $expected } zijn: staat een scheidingsteken ook als decimaalteken of in een tekst?
exchange-open-quote = een aanhalingsteken wordt op deze regel niet gesloten
exchange-callout = passing: { $reason }
exchange-nominal = nominale maat: { $reason }
exchange-nominal-differs = passing { $callout } heeft niet de nominale maat { $nominal } uit de eigen kolom
exchange-measured = gemeten: { $reason }
exchange-simulated = simulated: { $given } is true noch false
exchange-decimal-sign = gemeten: { $given } heeft een ander decimaalteken dan de andere waarden, { $sign }
exchange-not-positive = gemeten: een diameter van { $given } is niet groter dan 0
exchange-decimal-comma = { $joined } is misschien één getal met een decimale komma: gebruik een decimale punt of een ander scheidingsteken
exchange-too-many-rows = alleen de eerste { $most } regels zijn gelezen: splits het bestand
exchange-unjudged-no-callout = niet beoordeeld: er is geen passing
exchange-unjudged-no-limits = niet beoordeeld: de grensmaten in het protocol zijn 0, de diameter is dus niet bewaakt
exchange-unjudged-coordinate = een coördinaat van cyclus { $cycle }, geen gat of as
exchange-unjudged-coordinate-without-limits = niet beoordeeld: de grenzen in het protocol zijn 0, dus de coördinaat is niet bewaakt
exchange-unjudged-size = { $what } van cyclus { $cycle }, geen gat of as
exchange-unjudged-size-without-limits = niet beoordeeld: de grenzen in het protocol zijn 0, dus { $what } is niet bewaakt
exchange-unjudged-point = een punt op een oppervlak van cyclus { $cycle }: de afwijking langs de normaal, geen maat
exchange-unjudged-point-without-tolerance = niet beoordeeld: het punt is zonder tolerantie getast
exchange-unjudged-contacts = niet beoordeeld: { $count } tastpunten zonder passing
exchange-warning-ignored-columns = niet gebruikte kolommen: { $columns }
exchange-warning-not-used = geen meting en niet gebruikt: { $text }
exchange-warning-comment = een regel die met # begint is commentaar, maar hier staat een meting in
exchange-warning-time = { $given } is geen datum en tijd: tijd van import gebruikt

# Meetpunten
contacts-file-empty = het bestand bevat geen meetpunten
contacts-no-columns = de kopregel moet x en y noemen en mag z noemen; er staat { $given }
contacts-twice = kolommen { $first } en { $second } zijn allebei { $name }
contacts-cells = { $cells } cellen in plaats van { $wanted }: { $given }
contacts-not-a-number = { $name } is { $given }, geen getal in millimeter
contacts-open-quote = een aanhalingsteken wordt niet gesloten
contacts-mixed-signs = { $given } heeft een ander decimaalteken dan de regels ervoor

## Tables of deviations
table-format-name = { $name } begint niet met een letter: namen van tabellen op een TNC7 wel
table-format-operator = er staat { $sign } in { $name }: namen van tabellen op een TNC7 hebben geen rekenteken
table-format-warning-lower-sign = de handleiding van PC-DMIS toont geen andere onderafwijking dan 0: controleer { $class } daar vóór gebruik, vooral de tekens
table-format-csv = de CSV kan niet worden geschreven: { $reason }
table-format-itnc530 = besturingstabel voor iTNC 530
table-format-tnc640 = besturingstabel voor TNC 620 en TNC 640
table-format-tnc7 = besturingstabel voor TNC7
table-format-plain-csv = CSV, een regel per klasse en maatbereik
table-format-pcdmis = CSV met ISO-toleranties voor PC-DMIS
