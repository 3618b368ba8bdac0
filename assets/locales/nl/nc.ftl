# Sets met programma's, tabellen en maskers voor een besturing.
## Plannen
nc-value = { $what }: { $error }
nc-name = naam { $name }: toegestaan zijn letters A tot Z, cijfers en _, hoogstens { $most }
nc-not-on-control = { $kind } wordt gemeten met cyclus { $cycle }, en die heeft een { $control } niet
## Sets
nc-folder = { $folder } is geen map voor programma's: schrijf TNC:\ en dan namen van letters, cijfers, _ en -, gescheiden door \
nc-no-texts = een set met tolerantieteksten is alleen mogelijk voor TNC7, niet voor { $control }
nc-series-name = { $name } kan geen kolom van de serietabel heten: laat de naam met een letter beginnen en gebruik niet NR, PART of STATUS
nc-series-sizes = een serie bewaart hoogstens { $most } maten van een onderdeel, en het plan heeft er { $sizes }: maak meer sets
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
nc-by-hand = { $name }: geen cyclus meet een { $kind }: het zit niet in de set
nc-not-in-set = { $name }: het plan zegt { $said }, maar de set gebruikt dat niet: op de besturing beslissen alleen de grensmaten, dus kan die GOED zeggen waar fitcheck import dat niet doet
nc-features = { $first } (en nog { $more })
nc-moved-nominal = { $name }: de nominale maat van { $callout } ligt buiten de grensmaten, en dat weigert een TNC7: { $parameter } is { $value } mm, en { $deviation } telt vanaf daar
nc-no-place = { $name } heeft x, y en z nodig: een programma gaat erheen
nc-own-cycle = { $name } heeft een eigen cyclus of parameters, en de aangeroepen programma's ondersteunen dat niet
nc-no-coordinate = { $column } ontbreekt: een programma gaat erheen
