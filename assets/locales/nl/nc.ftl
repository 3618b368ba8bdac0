# Sets met programma's, tabellen en maskers voor een besturing.
## Plannen
nc-no-features = het plan heeft geen element
nc-too-many = het plan heeft meer dan { $most } elementen
nc-too-large = een plan heeft hoogstens { $most } KiB
nc-no-column = kolom { $column } ontbreekt
nc-unknown-column = onbekende kolom { $column }: de kolommen zijn { $known }
nc-column-twice = kolom { $column } komt twee keer voor
nc-cells = de rij heeft { $found } cellen en de kop { $expected }: scheid de kolommen bij een decimale komma met puntkomma's
nc-no-cell = { $column } ontbreekt
nc-value = { $what }: { $error }
nc-no-class = { $callout } heeft geen tolerantieklasse, zoals H7: de programma's zoeken de grensmaten op klasse op
nc-fit = { $callout } geldt voor boring en as samen: zet ze als twee elementen in het plan
nc-clearance-height = veilige hoogte { $height } mm ligt niet boven de meethoogte, { $z } mm
nc-name = naam { $name }: toegestaan zijn letters A tot Z, cijfers en _, hoogstens { $most }
nc-same-name = naam { $name } komt twee keer voor: bestandsnamen op een besturing maken geen verschil tussen hoofdletters en kleine letters
nc-unknown = { $column } { $given } is onbekend: { $known } verwacht
nc-not-of = bij { $kind } hoort geen { $column }
nc-direction = axis { $given } is geen richting: { $known } verwacht, of drie getallen zoals 0.5 0 -1, van -10 tot 10 met hoogstens 9 decimalen en niet alle 0
nc-no-band = { $text } is niet de tolerantie van een punt, zoals ±0.05 of +0.1/-0.05: { $error }
nc-band-side = een punt kan geen afwijkingen van { $lower } tot { $upper } mm hebben: de cyclus neemt een bovenafwijking van 0 of meer en een onderafwijking van 0 of minder, niet beide 0
nc-side-class = { $callout }: beide zijden van { $kind } hebben een klasse zoals { $example } nodig
nc-not-on-control = { $kind } wordt gemeten met cyclus { $cycle }, en die heeft een { $control } niet
nc-face-class = { $callout }: een vlak wordt als buitenmaat beoordeeld en heeft een asklasse nodig, zoals h9
nc-face-place = { $callout }: het vlak ligt op { $coordinate } mm langs de meetas, en dat moet de nominale maat zijn
## Sets
nc-folder = { $folder } is geen map voor programma's: schrijf TNC:\ en dan namen van letters, cijfers, _ en -, gescheiden door \
nc-reads-otherwise = { $file } kan niet zo worden geschreven dat hetzelfde wordt teruggelezen
nc-proof = de set is bij de proefuitvoering afgekeurd en niet geschreven: { $reason }
nc-proof-no-end = het programma eindigt niet
nc-proof-count = { $found } van de { $expected } elementen zijn gemeten
nc-proof-other-verdict = { $name }: het oordeel wijkt af van dat van Fitcheck
nc-archive = het zipbestand kan niet worden gemaakt: { $reason }
nc-workpiece = het werkstuk kan niet worden geschreven: { $reason }
nc-own-column = { $class } is geen van de 47 klassen van NC-Solution 8255: { $table } krijgt een extra kolom
nc-figure = { $what }
nc-fewer-columns = kolomgrens van een iTNC 530: { $table } heeft alleen de klassen van het plan, { $classes }
nc-moved-nominal = { $name }: de nominale maat van { $callout } ligt buiten de grensmaten, en dat weigert een TNC7: { $parameter } is { $value } mm, en { $deviation } telt vanaf daar
