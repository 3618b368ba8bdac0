# control

# Masks
mask-empty = maska je prázdná
mask-too-large = maska je větší než { $most } KiB
mask-unknown = { $found } není záznam, klíčové slovo ani komentář
mask-unclosed-quote = uvozovky nejsou uzavřeny
mask-unknown-format = { $found } není formát: dovoleny jsou %S %RS %F %LF %D %I %%
mask-too-wide = { $found } je příliš široké: nejvýše { $most }
mask-count = počet formátů { $formats }, počet parametrů { $parameters }
mask-unknown-parameter = { $found } není parametr: dovoleny jsou Q, QL, QR, QS s číslem, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = na konci chybí ;
mask-unknown-word = { $word } není známo a nemá účinek
mask-behind-semicolon = { $found } za ; je přeskočeno
mask-other-languages = maska má text pro { $languages } a žádný pro { $wanted }
mask-inverse-touching = { $first } a { $second } se tisknou bez mezery mezi sebou, výstup proto nelze přečíst zpět
mask-inverse-blanks = { $first } a { $second } jsou texty jen s mezerami mezi sebou, výstup proto nelze přečíst zpět: text může obsahovat mezery
mask-inverse-no-mark = žádný pevný text neoznačuje, kde záznam začíná, výstup proto nelze přečíst zpět
mask-inverse-too-long = maska tiskne najednou více než { $most } řádků: zpět lze přečíst jen kratší záznamy
mask-inverse-no-number = maska netiskne číslo, které by mohlo být naměřenou hodnotou
mask-undefined = { $name } není definováno
mask-text-as-number = { $name } je text, formát potřebuje číslo
mask-number-as-text = { $name } je číslo, formát potřebuje text
mask-not-finite = { $name } není konečné číslo
# Measuring logs
log-empty = soubor je prázdný
log-no-log = není to měřicí protokol: chybí titulní řádek s číslem měřicího cyklu
log-too-long = protokol má více než { $lines } řádků, nebo řádek delší než { $bytes } bajtů
log-no-title = protokol nemá titulní řádek, jeho cyklus proto není znám
log-other-cycle = protokoly cyklu { $cycle } nelze číst, jen cyklů { $known }
log-unit = druh měrové jednotky { $given } není 0 (mm) ani 1 (palec)
log-count = { $section }: očekává se { $expected }, nalezeno { $found }
log-missing = chybí { $section }: protokol je oříznutý nebo neúplný
log-no-label = před { $given } chybí označení
log-cut-figure = soubor končí uvnitř této hodnoty: { $given } může být neúplné
log-swapped = maximum { $maximum } je pod minimem { $minimum }
log-uneven = meze { $minimum } a { $maximum } nejsou souměrné kolem jmenovité hodnoty { $nominal }
log-deviation = úchylka { $given } není skutečná minus jmenovitá hodnota, { $actual } - { $nominal }
log-not-positive = průměr { $given } není nad 0
log-section-nominal = oddíl jmenovitých hodnot
log-section-limits = oddíl mezních hodnot
log-section-actual = oddíl skutečných hodnot
log-section-deviations = oddíl úchylek
log-no-unit = žádný řádek neudává jednotku: předpokládají se milimetry
log-no-time = datum a čas měření nejsou známy
log-no-deviations = chybí úchylky: protokol může být oříznutý
log-ignored = přeskočeno: { $text }
log-text-before = text před prvním protokolem byl přeskočen

## Tables
table-empty = soubor je prázdný
table-not-text = znak { $code } není text: soubor není tabulka nebo je poškozen
table-line-too-long = řádek je delší než { $limit } bajtů
table-too-large = tabulka má více než { $limit } buněk
table-too-many-columns = tabulka má více než { $limit } sloupců
table-no-begin = tabulka začíná BEGIN a svým názvem, ne { $found }
table-no-name = za BEGIN chybí název tabulky
table-unclosed-quote = uvozovky nejsou uzavřeny
table-unclosed-block = blok { $block } z řádku { $line } není uzavřen
table-second-block = sloupce jsou popsány podruhé
table-unexpected = očekává se { $expected }, nalezeno { $found }
table-not-a-size = { $key } musí být celé číslo do { $limit }, ne { $text }
table-no-columns = chybí řádek s názvy sloupců
table-tab = znak tabulátoru: sloupce oddělujte jen mezerami
table-column-twice = sloupec { $name } se vyskytuje dvakrát
table-short-row = řádek končí před sloupcem { $name }: doplňte jej mezerami, nebo pište - místo hodnoty
table-truncated = soubor končí uvnitř tohoto řádku a bez [END]: může být oříznutý
table-text-after-end = text za [END]: { $found }
table-no-end = chybí [END]
table-no-lock = tabulka nástrojů nemá sloupec TL: zlomený nástroj se v ní nezablokuje
table-no-unit = tabulka neudává jednotku: její délky byly přečteny jako milimetry
table-begin-word = { $word } nemá v řádku BEGIN známý význam
table-width = šířka sloupce { $name } ve znacích je zde { $found }, ale v popisu { $described }; platí řádek s názvy sloupců
table-not-in-table = sloupec { $name } je popsán, ale v tabulce není
table-not-described = sloupec { $name } není popsán
table-skipped = { $name } není známo a bylo přeskočeno
table-write-too-wide = řádek { $row }, sloupec { $column }: { $text } se nevejde, místa je jen na { $width } znaků
table-write-too-many-columns = počet sloupců tabulky je { $columns }; iTNC 530 jich pojme nejvýše { $limit }
table-write-too-long = řádky tabulky mají { $characters } znaků; iTNC 530 jich pojme nejvýše { $limit }
table-write-reads-otherwise = tabulku nelze zapsat tak, aby se zpět přečetla stejně: ověřte názvy tabulky a jejích sloupců

## Tables of deviations
deviations-no-tables = v této složce není tabulka úchylek (*.tab se sloupcem BEREICH): { $folder }
tables-contradict = { $first } a { $second } si odporují, { $class } nad { $over } do { $to } mm: { $one ->
        [none] bez hodnoty
       *[other] { $one } µm
    } a { $other ->
        [none] bez hodnoty
       *[other] { $other } µm
    }: odstraňte sloupec z jedné z nich
deviations-two-range-columns = tabulka má BEREICH i BEREIK: rozsahy rozměrů smí obsahovat jen jeden
deviations-inch = tabulka je v palcích: pište rozsahy rozměrů v milimetrech a úchylky v mikrometrech
deviations-no-class = žádný sloupec není toleranční třída, například H7
deviations-odd-rows = počet řádků je lichý ({ $rows }): každý rozsah rozměrů má dva, nejprve horní úchylku, pak dolní úchylku
deviations-no-range = chybí konec rozsahu rozměrů
deviations-other-range = rozsah rozměrů do { $end } mm má ve druhém řádku { $found }: zopakujte jej, nebo nechte prázdné
deviations-column = sloupec { $column }: { $error }
deviations-half = sloupec { $class } má pro rozsah rozměrů do { $end } mm jen jednu ze dvou úchylek
deviations-touches = sloupec { $column } a sousední sloupec na sebe navazují: oddělte je mezerou
deviations-no-deviations = přeskočeno, není to tabulka úchylek (chybí sloupec BEREICH): { $file }
deviations-range-alias = BEREIK byl přečten jako BEREICH
deviations-other-column = sloupec { $name } byl přeskočen, protože jeho název nemůže být toleranční třídou: v tabulce zapsané z této bude chybět
deviations-no-numbers = sloupec { $name } byl přeskočen, protože obsahuje texty a ne úchylky: v tabulce zapsané z této bude chybět
deviations-mixed-case = sloupec { $name } byl přeskočen, protože toleranční třída nemíchá velká a malá písmena: v tabulce zapsané z této bude chybět

## Parameters
no-parameter = { $given } není parametr: dovoleny jsou Q, QL, QR a QS s číslem

## Writing measuring logs
log-write-cycle = cyklus { $cycle } tyto hodnoty nezapisuje
log-write-no-title = protokol cyklu { $cycle } nemá v souboru { $file } titulek
log-write-unit = protokol je v mm nebo v palcích, ne v µm
log-write-character = { $given } nelze zapsat: protokol nesmí obsahovat znak U+{ $code }
log-write-program = { $given } by se zpět nepřečetlo jako cesta k programu: pište cestu jako TNC:\PART\CHECK.H
log-write-unfinished = soubor končí uvnitř řádku: může být oříznutý, nic se k němu proto nepřidá
log-write-reads-otherwise = protokol nelze zapsat tak, aby se zpět přečetl stejně: ověřte datum, čas a další výsledky

## Log of cycle 444
point-log-no-log = není to protokol cyklu 444: stránka neobsahuje strojově čitelné měření
point-log-count = stránka udává počet měření { $expected }, ale obsahuje { $found }: je oříznutá nebo byla změněna
point-log-cut-off = měření nemá konec: stránka je oříznutá
point-log-json = měření nelze přečíst: { $what }
point-log-version = verze protokolu { $version } není podporována: očekává se { $known } nebo starší
point-log-normal = normála { $given } nemá směr: potřebuje tři čísla, která nejsou všechna 0
point-log-deviation = úchylka { $given } v { $axis } není naměřená minus jmenovitá souřadnice, { $difference }
point-log-along = úchylka { $given } ve směru normály neplyne z úchylek v osách, { $along }
point-log-band = horní úchylka { $upper } je pod dolní úchylkou { $lower }
point-log-status = stav { $given } neplyne z úchylky a tolerance, { $status }
## The touch-probe table
probe-table-no-column = tabulka nemá sloupec { $column }
probe-table-no-probe = tabulka nemá žádnou sondu
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: musí být { $least }
probe-table-zero-or-more = 0 nebo více
probe-table-above-zero = nad 0
probe-table-not-whole = { $column } = { $given }: očekává se celé číslo
probe-table-twice = sonda { $number } se vyskytuje dvakrát

## The tool table
tool-table-no-column = tabulka nemá sloupec { $column }
tool-table-no-tool = tabulka nemá žádný nástroj
tool-table-touches = { $column }: buňka navazuje na sousední, její hodnota proto není jistá
tool-table-no-number = { $column } = { $given }: očekává se číslo nástroje od 0 do 32767, s indexem jako 5.1 nebo bez něj
tool-table-twice = nástroj { $number } se vyskytuje dvakrát
tool-table-name-too-long = NAME = { $given }: název má nejvýše { $most } znaků
tool-table-no-length = { $column }: { $error }
tool-table-out-of-range = { $column } = { $given } mm: očekává se { $least } až { $most } mm
tool-table-no-lock = TL = { $given }: očekává se L nebo 1 pro zablokovaný nástroj; 0, - nebo nic pro volný
tool-table-not-whole = { $column } = { $given }: očekává se celé číslo
tool-unknown = Q330 = { $tool }: tabulka nástrojů takový nástroj nemá; má { $known }
tool-no-deviation = Q330 = { $tool }: cyklus { $cycle } zde nemá meze, není tedy úchylka, podle které by se nástroj korigoval
tool-out-of-range = nástroj { $tool }: { $column } by se změnilo z { $from } na { $to } mm: největší hodnota je { $most } mm v obou směrech
tool-broken = chyba 1065: nástroj { $tool } je zlomený: { $column } by se změnilo o { $by } mm, { $limit } je { $most } mm; nástroj se zablokuje a nekoriguje
tool-broken-replacement = chyba 1065: nástroj { $tool } je zlomený: { $column } by se změnilo o { $by } mm, { $limit } je { $most } mm; nástroj se zablokuje a nekoriguje; jeho sesterský nástroj je { $replacement }
tool-corrected = nástroj { $tool }: { $column } změněno o { $by } mm, z { $from } na { $to } mm
tool-corrected-rounded = nástroj { $tool }: { $column } změněno o { $by } mm, z { $from } na { $to } mm: tabulka uchovává nejbližších 0,00001 palce
tool-locked = nástroj { $tool }: zablokován, TL = { $to }

## The log of a cycle's result
cycle-log-other-verdict = hodnoty protokolu, zaokrouhlené na 0,0001 { $unit }, dávají { $log }, zatímco cyklus dal { $cycle }

## The block of a probing cycle
block-none = není to cyklus snímání: blok začíná TCH PROBE a číslem, nebo G785
block-inches = blok patří k programu v palcích, ale četl by se v mm: spusťte program
block-none-at = tento řádek nepatří k žádnému měřicímu cyklu: začínají na řádcích { $blocks }
block-second = druhý cyklus snímání: zadávejte je po jednom; první začíná na řádku { $first }
block-unknown-cycle = TCH PROBE { $given }: cykly jsou { $known }
block-not-a-parameter = { $given } není parametr: pište jej jako { $example }
block-no-value = { $key } nemá hodnotu
block-twice = { $key } je uvedeno dvakrát, poprvé na řádku { $first }
block-unclosed-quote = uvozovky nejsou uzavřeny
block-behind-end = { $given } je za koncem bloku: každý řádek kromě posledního končí ~
block-too-many-parts = řádek má mezi ~ více než { $most } částí
block-cut-off = blok končí ~, řádek tedy chybí: může být oříznutý
block-reference = { $key } = { $given }: hodnota { $given } je známa jen za běhu programu
block-not-writable = { $key } = { $given }: text v bloku nesmí obsahovat uvozovky ani konce řádků
block-unused = řádek { $line }: { $text } k cyklu snímání nepatří a bylo přeskočeno
block-unused-more = řádek { $line }: { $text } k cyklu snímání nepatří a bylo přeskočeno, a další { $more }
