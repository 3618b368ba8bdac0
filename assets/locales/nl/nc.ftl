# Sets met programma's, tabellen en maskers voor een besturing.
## Plannen
nc-no-features = het plan heeft geen element
nc-too-many = het plan heeft meer dan { $most } elementen
nc-no-column = kolom { $column } ontbreekt
nc-unknown-column = kolom { $column } is onbekend; bekend zijn { $known }
nc-column-twice = kolom { $column } komt twee keer voor
nc-cells = de rij heeft { $found } cellen en de kop { $expected }: zet bij een decimale komma puntkomma's tussen de kolommen
nc-no-cell = { $column } is niet ingevuld
nc-value = { $what }: { $error }
nc-no-class = { $callout } heeft geen tolerantieklasse: de programma's zoeken een klasse op in een tabel, zoals H7
nc-fit = { $callout } is een hele passing: zet de boring en de as als twee elementen in het plan
nc-clearance-height = veilige hoogte { $height } mm ligt niet boven de meethoogte, { $z } mm
nc-name = naam { $name }: letters A tot Z, cijfers en _ mogen, hooguit { $most }
nc-same-name = naam { $name } komt twee keer voor; in bestandsnamen is a voor een besturing hetzelfde als A
## Sets
nc-folder = { $folder } is geen map voor programma's: schrijf TNC:\, dan namen met letters, cijfers, _ en -, gescheiden door \
nc-reads-otherwise = { $file } is niet zo te schrijven dat het weer hetzelfde gelezen wordt
nc-proof = de set is uitgeprobeerd en wordt niet afgegeven: { $reason }
nc-proof-no-end = het programma houdt niet op
nc-proof-count = { $found } van de { $expected } elementen zijn gemeten
nc-proof-other-verdict = { $name }: een ander oordeel dan dat van Fitcheck
nc-archive = het zipbestand is niet te maken: { $reason }
nc-own-column = { $class } hoort niet bij de 47 klassen van NC-Solution 8255: { $table } heeft een kolom meer
nc-fewer-columns = een iTNC 530 kan niet meer kolommen aan: { $table } heeft alleen de klassen van het plan, { $classes }
nc-moved-nominal = { $name }: de pasmaat van { $callout } ligt buiten de grensmaten, en dat weigert een TNC7: Q262 is { $value } mm, en Q163 telt vanaf daar
