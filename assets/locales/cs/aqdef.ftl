## AQDEF of Q-DAS
aqdef-line = očekává se klíč a text, například K0001/1 25.012, nebo řádek hodnot
aqdef-number = { $key }: { $reason }
aqdef-whole = { $key }: { $given } není celé číslo
aqdef-undeclared = hodnota charakteristiky { $number }, která není deklarována před tímto řádkem
aqdef-of-all = { $key } s číslem 0 by byla hodnota každé charakteristiky: je přeskočeno
aqdef-cut-off = soubor zde končí bez konce řádku, { $given } tedy může být oříznuté: je přeskočeno; je-li úplné, doplňte konec řádku
aqdef-zeros = řádek obsahuje bajty s hodnotou 0, soubor tedy nebyl zapsán celý: řádek je přeskočen
aqdef-mark-between = K0002/0 { $given } je mezi tímto řádkem a předchozím a může platit pro oba: hodnota je přeskočena
aqdef-twice = { $key } je uvedeno dvakrát s různými texty, předtím s { $other }: hodnoty této charakteristiky se neposuzují
aqdef-fields = hodnota má mít nejvýše { $most } polí, nalezeno { $found }
aqdef-no-values = { $count ->
        [0] žádné charakteristiky ani hodnoty
        [one] 1 charakteristika, ale žádné hodnoty: to je plán, ne měření
        [few] { $count } charakteristiky, ale žádné hodnoty: to je plán, ne měření
       *[other] { $count } charakteristik, ale žádné hodnoty: to je plán, ne měření
    }
aqdef-no-values-beside = { $count ->
        [0] žádné charakteristiky ani hodnoty
        [one] 1 charakteristika, ale žádné hodnoty
        [few] { $count } charakteristiky, ale žádné hodnoty
       *[other] { $count } charakteristik, ale žádné hodnoty
    }, a vedle tohoto souboru není { $file } do { $most } MiB: to je plán, ne měření; je-li { $file } větší, zadejte jej přímo
aqdef-no-description = hodnoty bez charakteristik: vedle tohoto souboru chybí { $file }
aqdef-count = K0100 ohlašuje charakteristik { $expected }, nalezeno { $found }: soubor může být oříznutý
aqdef-too-large = charakteristiky zabírají více než { $most } MiB
aqdef-beside = { $file }, řádek { $line }: { $reason }
aqdef-warning-count = K0100 ohlašuje charakteristik { $expected }, nalezeno { $found }: soubor může být oříznutý
aqdef-warning-fewer = očekávaný počet hodnot { $expected }, nalezeno { $found }
aqdef-warning-missing = { $count ->
        [one] 1 hodnota je od tohoto řádku prázdná nebo označená jako chybějící (K0002 je 255 nebo 256): je přeskočena
        [few] { $count } hodnoty jsou od tohoto řádku prázdné nebo označené jako chybějící (K0002 je 255 nebo 256): jsou přeskočeny
       *[other] { $count } hodnot je od tohoto řádku prázdných nebo označených jako chybějící (K0002 je 255 nebo 256): jsou přeskočeny
    }
aqdef-warning-skipped = přeskočené údaje: { $keys }
aqdef-warning-repeated = { $key } je uvedeno dvakrát s různými texty: použije se tento
aqdef-warning-late = { $key } nepatří k hodnotě přečtené těsně před ním: je přeskočeno
aqdef-warning-allowance = z jmenovitého rozměru a úchylky vychází { $limit }, ale mez je jiná: platí mez
aqdef-warning-tolerance = { $key } má toleranci { $given } mm, ale z mezí vychází { $expected } mm: platí meze
aqdef-warning-no-limit = { $key } je uvedeno, ale K2120 nebo K2121 říká, že taková mez není: je přeskočeno
aqdef-warning-kind-of-limit = { $given } není známý druh meze (0, 1 nebo 2): čte se jako mez
aqdef-warning-scrap-limit = mez zmetku { $limit } se liší od meze: je přeskočena a hodnota za mezí na této straně je zmetek
aqdef-warning-scrap-feature = mez zmetku patří k { $feature ->
        [hole] díře
       *[shaft] hřídeli
    }, ale { $callout } nikoli: platí toleranční třída
aqdef-warning-cut-off = soubor zde končí bez konce řádku a { $given } je kratší než ostatní: může být oříznutý
aqdef-warning-zeros = soubor zde obsahuje bajty s hodnotou 0, nebyl tedy zapsán celý: hodnoty mohou chybět
aqdef-warning-values-left = { $file } má { $count ->
        [one] 1 řádek hodnot, který se nečte
        [few] { $count } řádky hodnot, které se nečtou
       *[other] { $count } řádků hodnot, které se nečtou
    }
aqdef-warning-values-beside = hodnoty pocházejí z { $file } vedle tohoto souboru a čísla řádků se vztahují k němu
aqdef-warning-description-beside = charakteristiky pocházejí z { $file } vedle tohoto souboru
aqdef-warning-beside = { $file }, řádek { $line }: { $reason }
