# NC-programma’s uitvoeren.

## Paden en bestanden
machine-path-empty = het pad is leeg
machine-path-too-long = het pad heeft meer dan { $most } tekens
machine-path-other-root = { $path } is geen pad op TNC: en geen pad vanuit de map van het programma
machine-path-leads-out = { $path } leidt buiten de map
machine-path-no-name = { $name } in { $path } is geen naam voor een bestand of map
machine-store-missing = bestand { $path } bestaat niet
machine-store-outside = { $path } leidt buiten de opgegeven mappen
machine-store-no-file = { $path } is geen bestand
machine-store-too-large = { $path } is groter dan { $most } MiB
machine-store-read-only = er is geen map voor uitvoer gekozen
machine-store-system = { $path }: { $reason }

## Fouten
machine-fault-in-block = { $program }, regel { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, tekstregel { $line }, { $text }: { $fault }
machine-used-blocks = de { $most } NC-regels van deze uitvoering zijn op: loopt het programma in een kringetje?
machine-used-label-calls = { $most } aanroepen van labels zitten in elkaar, nog een mag niet: roept het programma zichzelf aan?
machine-used-program-calls = { $most } aanroepen van programma's zitten in elkaar, nog een mag niet: roept het programma zichzelf aan?
machine-used-windows = er zijn { $most } vensters geopend, nog een mag niet
machine-used-outputs = er is { $most } keer naar een bestand geschreven, nog een keer mag niet
machine-used-output = er zijn { $most } bytes uitgevoerd, meer mag niet
machine-used-cycles = er is { $most } keer gemeten, nog een keer mag niet
machine-used-path = de baan heeft { $most } bewegingen, nog een mag niet
machine-used-files = { $most } programma's en gewijzigde tabellen zijn open, nog een mag niet
machine-used-traffic = er zijn { $most } bytes gelezen en geschreven, meer mag niet
machine-used-file-bytes = programma's en gewijzigde tabellen hebben samen meer dan { $most } bytes
machine-text-too-long = de tekst heeft { $length } tekens, een parameter bevat er hooguit { $most }
machine-unknown-block = deze NC-regel is hier niet bekend: wat niet begrepen wordt, wordt niet uitgevoerd
machine-unknown-cycle = cyclus { $cycle } is hier niet bekend; bekend zijn { $known }
machine-broken = het programma is beschadigd: { $what } ontbreekt
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } is geen label
machine-undefined = { $parameter } is niet gedefinieerd
machine-no-parameter = parameter { $parameter } bestaat niet: Q en QS gaan tot 1999, QL en QR tot 499
machine-not-number = { $parameter } bevat een tekst, er is een getal nodig
machine-not-text = { $parameter } bevat een getal, er is een tekst nodig
machine-division-by-zero = deling door nul
machine-negative-root = de wortel van { $value } bestaat niet
machine-no-result = { $function } { $value } bestaat niet
machine-beyond-range = { $value } ligt buiten het waardebereik, 10^10 naar beide kanten
machine-not-whole = { $what } = { $value }: er is een geheel getal vanaf 0 nodig
machine-behind-text = de tekst heeft { $length } tekens, op { $from } begint niets
machine-no-number-in-text = { $parameter } = "{ $text }" is geen getal
machine-unknown-system-text = ID{ $id } NR{ $number } is hier niet bekend; bekend zijn datum en tijd, ID10321
machine-no-table = er is geen tabel geopend
machine-no-column = tabel { $table } heeft geen kolom { $column }; de kolommen zijn { $columns }
machine-no-row = tabel { $table } heeft geen regel { $row }: de regels zijn 0 tot en met { $last }
machine-no-rows = tabel { $table } heeft geen regels
machine-empty-cell = tabel { $table }, regel { $row }, kolom { $column }: de cel is leeg
machine-no-number-in-cell = tabel { $table }, regel { $row }, kolom { $column }: { $cell } is geen getal
machine-touches = tabel { $table }, regel { $row }, kolom { $column }: de cel raakt de cel ernaast, misschien is er verkeerd gesneden
machine-table-write = tabel { $table }: { $error }
machine-mask = masker { $mask }: { $error }
machine-programmed = het programma heeft zichzelf gestopt met fout { $number }
machine-no-cycle-parameter = cyclus { $cycle } heeft geen parameter { $parameter }
machine-cycle-parameter-twice = cyclus { $cycle }: { $parameter } is twee keer opgegeven
machine-cycle = cyclus { $cycle }: { $error }
machine-workpiece = werkstuk: { $error }
machine-inch = cycli worden alleen in programma's in MM uitgevoerd

## Opmerkingen
machine-remark-skipped = de NC-regel is hier niet bekend en is overgeslagen
machine-remark-ended-within = M{ $function } in een aangeroepen programma heeft de uitvoering beëindigd: een besturing staat dat daar niet toe
machine-remark-given-wins = { $parameter } = { $value } is vooraf opgegeven en komt in de plaats van de waarde in deze NC-regel
machine-remark-not-written = { $path } is niet geschreven: er is geen map voor uitvoer gekozen
machine-remark-not-saved = { $path } is niet geschreven: { $reason }
machine-remark-full = { $path } heeft zijn { $kilobytes } kilobyte bereikt, er is niets toegevoegd
machine-remark-table-written = { $path } is geschreven
machine-remark-contacts-left = de cycli hebben { $used } van de { $count } opgenomen contacten gebruikt
machine-remark-more = nog { $count } opmerkingen staan niet in de lijst
machine-remark-other-probe = gereedschap { $tool } staat niet in de tastsysteemtabel: taster { $probe } is gebruikt

## Pauzes
machine-pause-stop = het programma is gestopt: STOP of M0
machine-pause-optional-stop = het programma is gestopt: M1
machine-pause-breakpoint = de volgende NC-regel heeft een onderbrekingspunt
machine-pause-log = het meetprotocol staat op het scherm (Q281 = 2)
