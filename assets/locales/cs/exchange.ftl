# exchange

# Measurements from files
exchange-format-logs = měřicí protokoly HEIDENHAIN, například TCHPR421.TXT
exchange-format-log-444 = protokoly 3D snímání, jak je zapisuje Fitcheck
exchange-format-fn16 = výstup FN 16 z řídicího systému, čtený přes jeho masku (--mask)
exchange-format-series-table = tabulka řídicího systému, kterou program plní pomocí FN 27, jeden řádek na díl
exchange-format-contacts = body dotyku jedné kružnice: x, y a volitelně z
exchange-format-measurements = měření jako CSV: id, callout, measured
exchange-empty = soubor je prázdný
exchange-not-recognised = není to soubor známého formátu
exchange-model-not-read = model { $format }: Fitcheck modely nečte; exportujte naměřené hodnoty jako CSV, XLSX, QIF nebo AQDEF
exchange-drawing-not-read = výkres { $format }: Fitcheck výkresy nečte; exportujte rozměry jako CSV nebo XLSX
exchange-document-not-read = dokument { $format }: Fitcheck dokumenty nečte; exportujte hodnoty jako CSV, XLSX, QIF nebo AQDEF
exchange-image-not-read = obrázek { $format }: Fitcheck obrázky nečte; exportujte hodnoty jako CSV, XLSX, QIF nebo AQDEF
exchange-archive-not-read = archiv { $format }: rozbalte jej a zadejte soubory z něj
exchange-no-sheet = sešit nemá list { $given }; má { $sheets }
exchange-other-format = nejsou to měření jako CSV, ale { $format }
exchange-parquet-unknown = tento program byl sestaven bez Parquet: cargo build --release bez dalších voleb jej zahrne
exchange-parquet-stream = Parquet uvádí sloupce na konci souboru a nelze jej číst z roury: uveďte název souboru
exchange-parquet = tento soubor Parquet nelze přečíst: { $reason }
exchange-parquet-nested = sloupec { $column } obsahuje sloupce nebo seznamy: posoudit lze jen sloupce jednotlivých hodnot
exchange-mask-backwards = { $mask }: { $reason }
exchange-mask-none = žádná ze zadaných masek takový soubor nevytváří: { $masks }
exchange-mask-several = takový soubor vytváří více masek; uveďte jen tu, která jej zapsala: { $masks }
exchange-mask-no-measured = { $mask } netiskne naměřenou hodnotu: Fitcheck zná Q153 až Q156, Q160 a každé jiné číslo, vedle kterého je vytištěn jeho předpis
exchange-mask-measured = { $mask }: naměřenou hodnotou může být kterékoli z těchto polí: { $fields }; tiskněte výsledek cyklu, například Q153; jinak soubor potřebuje předpisy s různými mezemi
exchange-print-ambiguous = maska to může přečíst několika způsoby
exchange-print-broken = výpis končí předčasně: očekává se výstup řádku { $line } masky
exchange-print-other = maska takový řádek netiskne, ale jsou v něm čísla: může to být výpis s chybějící nebo změněnou hodnotou; opravte jej nebo odstraňte
exchange-print-unit = řádek { $line } udává { $unit }, ale výstup řídicího systému se čte v mm: tiskněte hodnoty v mm
exchange-table-no-part = žádný sloupec neříká, ke kterému dílu řádek patří: tabulka série potřebuje sloupec jako PART nebo SERIAL
exchange-table-no-values = žádný sloupec neobsahuje naměřené hodnoty
exchange-table-no-value = není jasné, který sloupec { $name } je naměřená hodnota
exchange-table-touches = buňka ve sloupci { $column } se dotýká sousední, jedna z nich může být špatně oddělena: oddělte je mezerou
exchange-table-unit = tabulka je v palcích a sloupec { $column } není typu LENGTH, jeho hodnoty tedy mohou být v mm: použijte typ LENGTH
exchange-no-rows = žádný řádek neobsahuje měření
exchange-no-measured-column = chybí sloupec naměřených hodnot: pojmenujte jej v prvním řádku, například id;callout;measured
exchange-several-columns = více sloupců ({ $columns }) může být: { $role }; zvolte jeden pomocí import --columns, například { $word }=3, nebo sloupce v prvním řádku pojmenujte tak, aby se hodil jen jeden, například id;callout;measured
exchange-role-id = název
exchange-role-tolerance = předpis
exchange-role-nominal = jmenovitý rozměr
exchange-role-measured = naměřená hodnota
exchange-role-time = čas
exchange-role-simulated = zda jde o simulaci
exchange-role-number = číslo
exchange-role-part = díl
exchange-role-serial = sériové číslo
exchange-role-who = obsluha
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = co se měřilo
exchange-role-upper = horní úchylka
exchange-role-lower = dolní úchylka
exchange-role-minus = dolní úchylka bez mínusu
exchange-role-maximum = horní mezní rozměr
exchange-role-minimum = dolní mezní rozměr
exchange-role-kind = díra nebo hřídel
exchange-role-units = jednotka
exchange-role-status = stav
exchange-role-machine = stroj
exchange-role-batch = dávka
exchange-role-sample = vzorek
exchange-no-column = { $role }: má být ve sloupci { $given }, ale soubor má { $columns }
exchange-column-twice = sloupec { $column } nemůže být zároveň { $first } a { $second }
exchange-unit = neznámá jednotka { $unit }: použijte mm, µm nebo inch
exchange-limit = mez: { $reason }
exchange-tolerance-unsigned = tolerance { $given } nemá znaménko: napište ±{ $given }, nebo obě úchylky, například +0.02 0
exchange-minus-again = dolní úchylka { $given } má mínus, ale ostatní ne: napište všechny se znaménkem
exchange-limits-contradict = { $callout } má meze { $minimum } až { $maximum }, ale sloupce uvádějí { $given }: pro posouzení podle kóty zadejte --columns { $columns }, podle sloupců --columns callout=-
exchange-limits-or-deviations = sloupce { $columns } mohou být meze nebo úchylky od jmenovitého rozměru: zvolte pomocí --columns, například maximum={ $upper },minimum={ $lower } nebo upper={ $upper },lower={ $lower }
exchange-limits-or-readings = sloupce { $columns } mohou být meze, nebo největší a nejmenší z několika odečtů: zvolte pomocí --columns, například maximum={ $upper },minimum={ $lower } pro meze nebo maximum=-,minimum=- pro odečty
exchange-minus-or-plus = dolní úchylky ve sloupci { $columns } nemají znaménko: zvolte pomocí --columns, minus={ $lower } pro pod jmenovitým rozměrem nebo lower={ $lower } pro nad ním
exchange-samples-side-by-side = několik naměřených hodnot stojí vedle sebe ve sloupcích { $columns }: přečtěte je pomocí fitcheck import, nebo zvolte jednu pomocí --columns, například measured={ $first }
exchange-unit-stated = řádek { $line } udává jednotku { $unit }, která není podporována („{ $text }“): použijte mm, µm nebo inch, nebo zvolte jednotku rozměrů (--columns unit=mm)
exchange-unit-mentioned = řádek { $line } zmiňuje { $unit } („{ $text }“), nic však neříká, zda jsou hodnoty v této jednotce: zvolte jednotku rozměrů (--columns unit=mm, um nebo inch)
exchange-units-differ = „{ $at }“ udává { $unit }, „{ $other-at }“ udává { $other }: jedno z nich opravte
exchange-unit-late = řádek { $line } udává { $unit } („{ $text }“), ale řádky nad ním se čtou v { $read }: uveďte jednotku nad prvním řádkem, nebo opravte tento řádek
exchange-unit-stray = tento řádek udává { $unit } („{ $text }“), ale všechny ostatní se čtou v { $read }: uveďte jednotku nad prvním řádkem, nebo opravte tento řádek
exchange-unit-given = zvolená jednotka je { $given }, ale soubor udává { $unit } („{ $text }“): zvolte { $unit }, nebo opravte soubor
exchange-unit-half = sloupec { $column } je v palcích a sloupec { $open } jednotku neudává: napište ji k oběma názvům, nebo zvolte jednotku rozměrů (--columns unit=inch)
exchange-unit-missing = chybí jednotka tohoto řádku: pište mm, µm nebo inch, nebo zvolte jednotku rozměrů (--columns unit=mm)
exchange-callout-unit = { $given }: řádek je v palcích a předpis s rozměrem nebo úchylkami je v mm: dejte jmenovitý rozměr do vlastního sloupce vedle třídy
exchange-row-short = očekávaný počet buněk { $expected }, nalezeno { $found }
exchange-row-long = očekávaný počet buněk { $expected }, nalezeno { $found }: nepoužívá se oddělovač i jako desetinný oddělovač nebo v textu?
exchange-row-too-long = řádek je delší než { $most } KiB
exchange-open-quote = uvozovky na tomto řádku nejsou uzavřeny
exchange-header-hides-rows = řádek { $line }: záhlaví zabírá několik řádků a jeden z nich vypadá jako hodnoty: uzavřete uvozovky na řádku, kde začínají
exchange-within-quotes = tento řádek mohou být hodnoty nebo poznámka: uvozovky začínají nad ním a končí zde nebo níže; uzavřete je na řádku, kde začínají
exchange-callout = předpis: { $reason }
exchange-nominal = jmenovitý rozměr: { $reason }
exchange-nominal-differs = předpis { $callout } neodpovídá jmenovitému rozměru { $nominal } ve vlastním sloupci
exchange-measured = naměřeno: { $reason }
exchange-simulated = simulováno: { $given } není ani true, ani false
exchange-other-header = tento řádek pojmenovává jiné sloupce než první: řádky pod ním posuďte jako samostatný soubor
exchange-below-other-header = neposouzeno: řádek { $line } pojmenovává jiné sloupce. Řádky pod ním posuďte jako samostatný soubor
exchange-simulated-below = řádky pod tímto řádkem jsou simulované: posuďte je jako samostatný soubor, nebo pomocí fitcheck import
exchange-origin = původ: { $given } neříká ani měřeno, ani simulováno; pište measured, typed nebo simulated, nebo nastavte simulated=-, znamená-li tento sloupec něco jiného
exchange-decimal-sign = naměřeno: { $given } má jiný desetinný oddělovač než ostatní hodnoty: „{ $sign }“
exchange-not-positive = naměřeno: průměr { $given } není nad 0
exchange-decimal-comma = { $joined } může být jedno číslo s desetinnou čárkou: použijte desetinnou tečku nebo jiný oddělovač
exchange-other-feature = { $given } je { $feature ->
        [hole] hřídel a toto jsou díry: nejsou soubory zaměněny?
       *[shaft] díra a toto jsou hřídele: nejsou soubory zaměněny?
    }
exchange-rejected = soubor sám tuto hodnotu odmítá ({ $given }): odstraňte řádek, nebo ji v souboru opravte
exchange-no-part = { $given } označuje údaj o více dílech nebo nastavovací etalon měřidla, ne díl: odstraňte řádek, nebo dejte dílu jiný název
exchange-other-log = { $feature ->
        [hole] toto je protokol hřídele a toto jsou díry: nejsou soubory zaměněny?
       *[shaft] toto je protokol díry a toto jsou hřídele: nejsou soubory zaměněny?
    }
exchange-not-a-size = { $what }: to není rozměr, který lze párovat
exchange-no-place-axis = leží podél { $axis }, ale cykly 421 a 422 snímají podél Z
exchange-no-place-no-axis = soubor neříká, podél které osy leží
exchange-no-place-kind = { $kind }: cykly 421 a 422 snímají jen kružnice a válce
exchange-no-place-system = kontroluje se v souřadném systému { $system }, ale souřadnice se vztahují k systému souboru
exchange-contacts-not-sizes = řádky se dvěma nebo třemi čísly jsou body dotyku: pojmenujte sloupce v prvním řádku, například id;measured
exchange-too-many-rows = přečteno bylo jen prvních { $most } řádků: rozdělte soubor
exchange-unjudged-no-callout = neposouzeno: není uveden předpis
exchange-unjudged-no-limits = neposouzeno: mezní rozměry protokolu jsou 0, průměr se tedy nehlídal
exchange-unjudged-coordinate = souřadnice cyklu { $cycle }, ne díra nebo hřídel
exchange-unjudged-coordinate-without-limits = neposouzeno: meze protokolu jsou 0, souřadnice se tedy nehlídala
exchange-unjudged-size = { $what } cyklu { $cycle }, ne díra nebo hřídel
exchange-unjudged-size-without-limits = neposouzeno ({ $what }): meze protokolu jsou 0, nic se tedy nehlídalo
exchange-unjudged-point = bod plochy cyklu { $cycle }: jeho úchylka ve směru normály není rozměr
exchange-unjudged-point-without-tolerance = neposouzeno: bod byl snímán bez tolerance
exchange-unjudged-contacts = neposouzeno: body dotyku bez předpisu, počet { $count }
exchange-warning-ignored-columns = přeskočené sloupce: { $columns }
exchange-warning-quantity-unknown = sloupec { $column } nemá známé slovo pro to, co se měřilo ({ $words }): všechny jeho hodnoty se čtou jako rozměry; je-li to správně, uveďte import --columns quantity=-
exchange-warning-not-used = přeskočeno, není to měření: { $text }
exchange-warning-minus-supplied = sloupec { $column } nemá znaménka mínus: jeho hodnoty se čtou jako dolní úchylky pod jmenovitým rozměrem
exchange-warning-callouts-unnamed = sloupec { $column } zřejmě obsahuje tolerované rozměry, ale jeho název není známý: pojmenujte jej callout, nebo zadejte jeho číslo pomocí --columns, například callout=2
exchange-warning-limits-read = sloupce { $columns } se čtou jako meze
exchange-warning-head-read = přečteno pro všechny hodnoty: { $said }
exchange-warning-samples-read = sloupce { $columns } se čtou jako díly vedle sebe: každá hodnota se posuzuje zvlášť, prázdná buňka není hodnota a bez sériových čísel je každý sloupec samostatný díl
exchange-warning-comment = řádek začínající # je komentář, tento však obsahuje měření
exchange-warning-several-lines = řádek tabulky zabírá v uvozovkách několik řádků souboru: { $lines }
exchange-warning-time = { $given } není datum a čas: použije se čas importu
exchange-warning-place = { $given } není délka: poloha je přeskočena
exchange-warning-no-time = není zde datum a čas: použije se čas importu
exchange-warning-offset = { $given } se ukládá jako místní čas bez posunu od UTC
exchange-warning-cut-off = soubor zde končí bez konce řádku a { $given } má méně desetinných míst než ostatní hodnoty: může být oříznutý
exchange-warning-open-end = soubor zde končí bez konce řádku: jeho poslední hodnota { $given } může být oříznutá

# Contacts
contacts-file-empty = soubor neobsahuje body dotyku
contacts-no-columns = záhlaví musí obsahovat x a y a smí obsahovat z; je { $given }
contacts-twice = sloupce { $first } a { $second } jsou oba { $name }
contacts-cells = očekávaný počet buněk { $wanted }, nalezeno { $cells }: { $given }
contacts-not-a-number = { $name } je { $given }, ne počet milimetrů
contacts-row-too-long = řádek je delší než { $most } KiB
contacts-comment = řádek začínající # je komentář, tento však obsahuje souřadnice: odstraňte #, nebo celý řádek
contacts-other-unit = body dotyku jsou v mm, tento řádek však udává { $given }: převeďte je na mm
contacts-too-many = soubor má více než { $most } bodů dotyku
contacts-simulated = tyto body dotyku jsou simulované a nic neměří: použijte místo nich soubor obrobku
contacts-origin = { $given } neříká ani měřeno, ani simulováno: pište measured nebo simulated, nebo sloupec odstraňte
contacts-open-quote = uvozovky nejsou uzavřeny
contacts-mixed-signs = { $given } má jiný desetinný oddělovač než řádky před ním

## Tables of deviations
table-format-name = { $name } nezačíná písmenem: názvy tabulek na TNC7 jím začínat musí
table-format-operator = { $name } obsahuje { $sign }: názvy tabulek na TNC7 nesmějí mít aritmetické operátory
table-format-warning-lower-sign = příručka PC-DMIS neukazuje jinou dolní úchylku než 0: než se na { $class } v PC-DMIS spolehnete, ověřte ji, zvláště její znaménka
table-format-csv = CSV nelze zapsat: { $reason }
table-format-parquet-unknown = tento program byl sestaven bez Parquet: cargo build --release bez dalších voleb jej zahrne
table-format-parquet = soubor Parquet nelze zapsat: { $reason }
table-format-itnc530 = tabulka řídicího systému pro iTNC 530
table-format-tnc640 = tabulka řídicího systému pro TNC 620 a TNC 640
table-format-tnc7 = tabulka řídicího systému pro TNC7
table-format-plain-csv = CSV, řádek pro každou třídu a rozsah rozměrů
table-format-plain-parquet = Parquet, řádek pro každou třídu a rozsah rozměrů
table-format-pcdmis = CSV tolerancí ISO pro PC-DMIS

## Limits as SQL
sql-border = tabulka { $table }: rozsah rozměrů končí u { $end } mm; jako SQL musí rozsahy končit na celých milimetrech
sql-too-far = tabulka { $table }: rozsah rozměrů končí u { $end } mm; jako SQL musí rozsahy končit nejpozději u { $most } mm
sql-twice = třída { $class } je uvedena dvakrát
exchange-correction = hodnota při 20 °C neplyne z naměřené hodnoty a jejích teplot: očekávají se sloupce, jak je zapisuje Fitcheck
exchange-warning-corrected = hodnoty s údajem ve sloupci as_measured_mm už platí pro 20 °C
sizes-warning-named-twice = { $rows ->
        [one] jeden řádek má název dřívějšího řádku
        [few] { $rows } řádky mají název dřívějšího řádku
       *[other] { $rows } řádků má název dřívějšího řádku
    }, například { $id } na řádcích { $first } a { $second }: každý řádek se počítá jako díl
sizes-warning-simulated-rows = { $count ->
        [one] 1 řádek je simulovaný
        [few] { $count } řádky jsou simulované
       *[other] { $count } řádků je simulovaných
    }: nic se neměřilo
exchange-position-out = poloha středu byla mimo toleranci, ale soubor obsahuje jen rozměr
exchange-undecided = zde nebylo nic rozhodnuto: { $given }
exchange-warning-other-rule = výroky v tomto souboru mohou být podle jiného rozhodovacího pravidla (sloupec rule_name): hodnoty se posuzují znovu
exchange-read = zbytek souboru nelze přečíst: { $reason }
exchange-too-large = větší než { $most } MiB, limit pro soubory tohoto formátu
exchange-unjudged-one-limit = neposouzeno: jedna ze dvou mezí chybí
exchange-unjudged-no-tolerance = neposouzeno: meze nejsou uvedeny
exchange-unjudged-rounded = neposouzeno: vytištěné číslo zastupuje kteroukoli hodnotu od { $from } do { $to } a mez leží mezi nimi: tiskněte více desetinných míst
exchange-unjudged-implausible = neposouzeno: { $measured } mm není možné: plán uvádí { $lower } až { $upper } mm; zkontrolujte jednotku a desetinný oddělovač, nebo změřte znovu
exchange-unjudged-swapped-limits = neposouzeno: dolní mez { $minimum } je nad horní mezí { $maximum }
exchange-unjudged-not-a-size = { $what }: není to rozměr díry ani hřídele
exchange-warning-limits-differ = { $callout } má meze { $minimum } až { $maximum }, ale soubor má jiné: platí meze souboru
exchange-warning-class-unknown = třída { $given } zde nemá meze: platí meze souboru
exchange-warning-status-differs = soubor udává { $given }, ale podle mezí je to { $status }
exchange-warning-status-unknown = soubor udává { $given }, což není známý stav: podle mezí je to { $status }
exchange-warning-limit-differs = soubor udává { $given }, ale meze jsou { $minimum } až { $maximum }
exchange-warning-deviation-differs = soubor udává { $given }, ale to není úchylka hodnoty { $measured } od { $nominal }
exchange-warning-feature-differs = soubor udává { $given }, ale meze patří k { $feature ->
        [hole] díře
       *[shaft] hřídeli
    }
exchange-warning-temperature-differs = soubor udává { $given }, ale hodnota se bere jako měřená při { $counted } °C: uveďte --temperature a --material
exchange-warning-speaks-of-temperature = soubor zmiňuje jinou teplotu než { $counted } °C, při které se jeho hodnoty berou jako měřené: { $text }
exchange-warning-speaks-of-unit = poznámka udává jinou jednotku, než mají hodnoty: { $text }
exchange-warning-speaks-of-simulation = tento řádek zmiňuje simulaci: ověřte, zda byla hodnota změřena: { $text }
exchange-warning-all-nominal = všechny hodnoty ({ $count }) jsou přesně jejich jmenovité rozměry: může to být seznam rozměrů, které nikdo neměřil
exchange-warning-name-of-no-size = { $given } není název rozměru jednoho dílu, hodnota však byla jako rozměr posouzena
exchange-warning-other-values = sloupce s jinými rozměry blízkými naměřeným se neposuzují: { $columns }
exchange-warning-part-rejected = soubor udává { $given } o celém dílu
exchange-warning-uncertainty-not-used = soubor udává rozšířenou nejistotu { $expanded } mm: žádné pravidlo ji nepoužívá, uveďte místo ní --u
exchange-warning-plan-differs = soubor má meze { $minimum } až { $maximum }: platí meze plánu
exchange-warning-plan-differs-below = soubor má dolní mez { $minimum }: platí dolní mez plánu
exchange-warning-above-own-limit = není z plánu a je nad horní mezí svého souboru, { $maximum }
exchange-warning-below-own-limit = není z plánu a je pod dolní mezí svého souboru, { $minimum }
exchange-warning-plan-differs-above = soubor má horní mez { $maximum }: platí horní mez plánu
exchange-warning-plan-differs-nominal = soubor má jmenovitý rozměr { $nominal }: platí jmenovitý rozměr plánu
exchange-warning-part-differs = soubor uvádí díl { $given }: posuzuje se jako { $part }, díl plánu
exchange-warning-found-by-number-of = žádný prvek plánu se nejmenuje { $given }; přiřazeno podle čísla k { $name } v plánu
exchange-warning-found-by-place-of = žádný prvek plánu se nejmenuje { $given }; přiřazeno podle polohy k { $name } v plánu
exchange-warning-found-by-number = přiřazeno podle čísla k { $name } v plánu
exchange-warning-found-by-place = přiřazeno podle polohy k { $name } v plánu
exchange-format-aqdef = Q-DAS AQDEF, v jednom souboru nebo jako .dfd a .dfx
exchange-format-calypso = tabulky charakteristik CALYPSO, například NAME_chr.txt
exchange-format-calypso-text = tištěné protokoly CALYPSO uložené jako text
exchange-format-geopak = tolerance MCOSMOS (GEOPAK) v souboru bez názvů sloupců
exchange-format-gauge = řádky měřidel uložené v souboru, např. 01A+025.012
exchange-format-pcdmis = textové zprávy PC-DMIS
exchange-format-probed = výpisy snímacích maker, jak je zapisují Renishaw a systémy CAM
exchange-warning-unit-assumed = jednotka není uvedena: délky bez jednotky se čtou jako mm
exchange-warning-unit-read = délky se čtou v { $unit }, jak udává soubor: { $text }
exchange-warning-rounded = { $given } má číslice jemnější než nanometr: zaokrouhluje se na nejbližší nanometr
exchange-warning-rounded-values = { $count ->
        [one] 1 naměřená hodnota má od tohoto řádku číslice jemnější než nanometr: zaokrouhluje se na nejbližší nanometr
        [few] { $count } naměřené hodnoty mají od tohoto řádku číslice jemnější než nanometr: zaokrouhlují se na nejbližší nanometr
       *[other] { $count } naměřených hodnot má od tohoto řádku číslice jemnější než nanometr: zaokrouhlují se na nejbližší nanometr
    }
exchange-unjudged-quantity = { $quantity ->
        [102] kruhovitost (K2009 je 102)
        [109] umístění (K2009 je 109)
        [117] souřadnice (K2009 je 117)
       *[other] jiná veličina než průměr (K2009 je { $quantity })
    }: není to rozměr díry ani hřídele
exchange-unjudged-kind = neměřeno: { $kind ->
        [1] počet neshodných dílů (K2004 je 1)
        [5] sběrná karta chyb (K2004 je 5)
        [6] sběrná karta chyb (K2004 je 6)
       *[other] neznámý druh charakteristiky (K2004 je { $kind })
    }
exchange-unjudged-attribute = neposouzeno: označeno { $given } (K0002); platnou hodnotu označuje jen 0
exchange-unjudged-not-valid = neposouzeno: soubor udává { $said }, platná hodnota tedy být nemusí
exchange-unjudged-declaration = neposouzeno: řádek { $declaration } jeho deklarace nelze použít
exchange-format-qif = QIF 2.0, 2.1, 3.0: výsledky měřicího softwaru a plány
exchange-xml = chybné XML: { $reason }
exchange-xml-doctype = DOCTYPE není podporován: odstraňte jej, nebo soubor exportujte bez něj
exchange-xml-entity = entita { $name } není známa: podporovány jsou jen &lt; &gt; &amp; &quot; a &apos;
exchange-xml-depth = dosažen limit vnoření elementů: { $most }
exchange-xml-long = značka nebo text je delší než { $most } KiB
exchange-xml-mixed = { $name } má uprostřed textu element
exchange-xml-cut-off = soubor končí uvnitř elementu: může být oříznutý
exchange-xml-encoding = neznámé kódování { $given }: použijte UTF-8, UTF-16 nebo ISO 8859-1
exchange-xml-bytes = tyto bajty nejsou text v kódování souboru
exchange-qif-unit = jednotka délky { $unit }: název není znám nebo neodpovídá činiteli; použijte mm, inch nebo jinou jednotku s činitelem na metry
exchange-qif-no-unit = soubor nemá jednotku délky: potřebuje FileUnits s PrimaryUnits a LinearUnit
exchange-qif-reference = v souboru není { $what } { $id }
exchange-qif-too-many = soubor má více než { $most } elementů { $what }
exchange-qif-no-value = není zde naměřená hodnota; stav { $status }
exchange-qif-limit = meze nebo jmenovitý rozměr: { $reason }
exchange-qif-other-kind = měření je druhu { $measured }, ale jeho charakteristika je druhu { $defined }
exchange-qif-several-values = měření má několik hodnot
exchange-qif-defined-as-limit = DefinedAsLimit chybí nebo není true ani false, čísla tedy mohou být meze i úchylky
exchange-qif-no-nominal = meze jsou úchylky, ale chybí jmenovitý rozměr
exchange-qif-zone = třída { $class } a { $zone } si odporují: velká písmena jsou díry, malá hřídele
exchange-qif-no-results = soubor QIF bez naměřených hodnot: plán lze číst jako plán dílu
exchange-qif-no-characteristics = soubor QIF nedeklaruje žádné charakteristiky
exchange-warning-standard-uncertainty-not-used = soubor udává kombinovanou standardní nejistotu { $standard } a střední chybu { $mean-error }: žádné pravidlo je nepoužívá, uveďte místo nich --u
exchange-warning-sheet-hidden = list { $sheet } se čte, i když je v sešitu skrytý
exchange-warning-rows-hidden = { $count ->
    [one] řádek { $rows } je v sešitu skrytý nebo odfiltrovaný, ale čte se jako ostatní
    [few] { $count } řádky jsou v sešitu skryté nebo odfiltrované, ale čtou se jako ostatní: { $rows }
   *[other] { $count } řádků je v sešitu skrytých nebo odfiltrovaných, ale čtou se jako ostatní: { $rows }
}
exchange-warning-columns-hidden = skryté sloupce se čtou jako ostatní: { $columns }
exchange-warning-qif-version = QIF verze { $version }: tento program je určen pro verze 2.0, 2.1 a 3.0
exchange-warning-qif-count = { $list } udává n={ $said }, ale obsahuje { $found }: něco může chybět nebo přebývat
exchange-warning-qif-twice = id { $id } se vyskytuje dvakrát: použije se první element
exchange-format-xlsx = měření v sešitu tabulkového procesoru: sloupce jako v CSV
exchange-workbook = tento sešit nelze přečíst: { $reason }
exchange-not-a-workbook = soubor ZIP, ale ne sešit: rozbalte jej a zadejte soubory z něj
exchange-old-workbook = sešit ve formátu { $format }, který není podporován: uložte jej jako XLSX
exchange-workbook-password = sešit má heslo: uložte jej bez hesla
exchange-zip-cut-off = chybí konec sešitu: může být oříznutý
exchange-zip-members = seznam částí sešitu je poškozen nebo má více než { $most } položek
exchange-zip-bomb = { $member } se rozbalí na více než { $most } MiB, nebo je na sešit příliš hustě komprimován: nečte se
exchange-zip-twice = dvě části sešitu mají stejný název, sešit byl tedy změněn: otevřete jej v tabulkovém procesoru a uložte
exchange-zip-texts = sešit má více než { $most } různých textů
exchange-sheet-wide = buňka { $cell } je za prvními sloupci, kterých se čte { $most }
exchange-too-many-cells = list má více než { $most } buněk
exchange-cell = { $cell }: { $reason }
exchange-formula-without-value = hodnota vzorce ={ $formula } není uložena: otevřete sešit v tabulkovém procesoru a uložte jej
exchange-cell-split = hodnota buňky není uložena jako jeden prostý text, přečíst by šla jen její část: otevřete sešit v tabulkovém procesoru a uložte jej
exchange-cell-error = buňka ukazuje { $error }
exchange-warning-sheets-left = čte se list { $sheet }; ostatní listy ne: { $left }
gauge-frame = znaky, které řádek ohraničují, byly přeskočeny
gauge-channel = z kanálu { $channel }
gauge-inches = { $given } palců
gauge-error-text = { $given } může být číslo chyby měřidla: je-li to rozměr, pište jej s jednotkou, { $given } mm
gauge-opinion = měřidlo hlásí { $sign }; rozhodují meze plánu

mapping-no-value = { $given } nepřiřazuje žádný sloupec: pište slovo, = a sloupec, například measured=3
mapping-word = { $given } není známý obsah sloupce: dovoleno je { $allowed }
mapping-value = { $word }: { $given } není známo: dovoleno je { $allowed }
mapping-twice = { $word } je uvedeno dvakrát: uveďte je jednou
mapping-toml = není to přiřazení sloupců: { $reason }

# How a value was judged by a plan, and what was given beside it.
planned-rule = posouzeno podle pravidla plánu místo { $given }: { $rule }
planned-uncertainty = posouzeno s nejistotou plánu místo zadané: { $u }
planned-material = přepočteno na 20 °C s materiálem plánu místo zadaného: { $name }
planned-corrected = přepočteno z { $temperature } °C na 20 °C (roztažnost { $expansion } · 10⁻⁶/K)
planned-not-corrected = nepřepočteno na 20 °C: poloha na dílu není rozměr
planned-error-already-corrected = soubor udává, že hodnota už platí pro 20 °C: posuďte ji bez teploty

## Gauges
gauge-no-unit = { $given } neuvádí jednotku: zvolte v nastavení měřidla, zda posílá milimetry, nebo palce
exchange-gauge-unit = řádek { $line } z těchto řádků měřidla, { $given }, neuvádí mm ani palce: zadejte jednotku pomocí import --columns unit=mm nebo --columns unit=inch
gauge-other-form = { $given } se od řádku, kterým bylo měřidlo naučeno, { $example }, liší nejen číslicemi
gauge-other-decimals = { $given } má { $decimals ->
        [one] 1 desetinné místo
        [few] { $decimals } desetinná místa
        [many] { $decimals } desetinného místa
       *[other] { $decimals } desetinných míst
    } a řádek, kterým bylo měřidlo naučeno, jich má { $taught }: měřidlo posílá jinou jednotku, nebo se část čísla ztratila
teach-zero = 0 může být kterákoli nula řádku: k učení použijte řádek s jinou hodnotou
teach-not-text = { $line } obsahuje znaky, které nejsou text
teach-nowhere = { $value } mm není v řádku { $line }: zadejte hodnotu, kterou k němu měřidlo ukázalo
teach-twice = { $value } mm je v řádku { $line } více než jednou: k učení použijte řádek s jinou hodnotou
teach-other-unit = řádek udává { $given }, a to není { $value } mm: zadejte hodnotu, kterou měřidlo ukázalo, v milimetrech
