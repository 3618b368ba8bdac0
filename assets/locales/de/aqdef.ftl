## AQDEF von Q-DAS
aqdef-line = ein Schlüssel und ein Text wie K0001/1 25.012 erwartet, oder eine Textzeile mit Werten
aqdef-number = { $key }: { $reason }
aqdef-whole = { $key }: { $given } ist keine ganze Zahl
aqdef-undeclared = Wert von Merkmal { $number }, das vor dieser Textzeile nicht beschrieben ist
aqdef-of-all = { $key } mit Nummer 0 wäre der Wert jedes Merkmals: übersprungen
aqdef-cut-off = die Datei endet hier ohne Zeilenende, daher ist { $given } vielleicht abgeschnitten: übersprungen; ist die Angabe vollständig, ein Zeilenende hinzufügen
aqdef-zeros = die Textzeile hat Bytes mit Wert 0, daher wurde die Datei nicht vollständig geschrieben: die Textzeile ist übersprungen
aqdef-mark-between = K0002/0 { $given } steht zwischen dieser Zeile und der vorigen und kann für beide gelten: der Wert ist übersprungen
aqdef-twice = { $key } ist zweimal mit verschiedenen Texten angegeben, vorher mit { $other }: Werte dieses Merkmals werden nicht beurteilt
aqdef-fields = höchstens { $most } Felder in einem Wert erwartet, { $found } gefunden
aqdef-no-values = { $count ->
        [0] weder Merkmale noch Werte
        [one] 1 Merkmal, aber keine Werte: das ist ein Plan, keine Messungen
       *[other] { $count } Merkmale, aber keine Werte: das ist ein Plan, keine Messungen
    }
aqdef-no-values-beside = { $count ->
        [0] weder Merkmale noch Werte
        [one] 1 Merkmal, aber keine Werte
       *[other] { $count } Merkmale, aber keine Werte
    }, und keine { $file } bis { $most } MiB neben dieser Datei: das ist ein Plan, keine Messungen; ist { $file } größer, sie selbst angeben
aqdef-no-description = Werte ohne Merkmale: { $file } fehlt neben dieser Datei
aqdef-count = K0100 kündigt { $expected } Merkmale an, { $found } gefunden: die Datei ist vielleicht abgeschnitten
aqdef-too-large = die Merkmale brauchen mehr als { $most } MiB
aqdef-beside = { $file }, Textzeile { $line }: { $reason }
aqdef-warning-count = K0100 kündigt { $expected } Merkmale an, { $found } gefunden: die Datei ist vielleicht abgeschnitten
aqdef-warning-fewer = { $expected } Werte erwartet, { $found } gefunden
aqdef-warning-missing = { $count ->
        [one] 1 Wert ist leer oder als fehlend gekennzeichnet (K0002 ist 255 oder 256), ab dieser Textzeile: er ist übersprungen
       *[other] { $count } Werte sind leer oder als fehlend gekennzeichnet (K0002 ist 255 oder 256), ab dieser Textzeile: sie sind übersprungen
    }
aqdef-warning-skipped = übersprungene Felder: { $keys }
aqdef-warning-repeated = { $key } ist zweimal mit verschiedenen Texten angegeben: dieser wird verwendet
aqdef-warning-late = { $key } gehört zu keinem kurz davor gelesenen Wert: übersprungen
aqdef-warning-allowance = Nennmaß und Grenzabmaß ergeben { $limit }, das Grenzmaß ist aber ein anderes: das Grenzmaß gilt
aqdef-warning-tolerance = { $key } hat eine Toleranz von { $given } mm, die Grenzmaße ergeben aber { $expected } mm: die Grenzmaße gelten
aqdef-warning-no-limit = { $key } ist angegeben, aber nach K2120 oder K2121 gibt es kein solches Grenzmaß: übersprungen
aqdef-warning-kind-of-limit = { $given } ist keine bekannte Art von Grenzmaß (0, 1 oder 2): als Grenzmaß gelesen
aqdef-warning-scrap-limit = die Ausschussgrenze { $limit } weicht vom Grenzmaß ab: sie ist übersprungen, und ein Wert jenseits des Grenzmaßes auf dieser Seite ist Ausschuss
aqdef-warning-scrap-feature = die Ausschussgrenze ist die { $feature ->
        [hole] einer Bohrung
       *[shaft] einer Welle
    }, { $callout } aber nicht: die Toleranzklasse gilt
aqdef-warning-cut-off = die Datei endet hier ohne Zeilenende, und { $given } ist kürzer als die anderen: vielleicht abgeschnitten
aqdef-warning-zeros = die Datei hat hier Bytes mit Wert 0, daher wurde sie nicht vollständig geschrieben: vielleicht fehlen Werte
aqdef-warning-values-left = { $file } hat { $count ->
        [one] 1 Textzeile mit Werten, die nicht gelesen wird
       *[other] { $count } Textzeilen mit Werten, die nicht gelesen werden
    }
aqdef-warning-values-beside = die Werte kommen aus { $file } neben dieser Datei, und die Nummern der Textzeilen beziehen sich darauf
aqdef-warning-description-beside = die Merkmale kommen aus { $file } neben dieser Datei
aqdef-warning-beside = { $file }, Textzeile { $line }: { $reason }
