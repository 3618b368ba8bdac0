# The command line

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = varování: { $what }
cli-remark = poznámka: { $what }

# What an error is about
cli-what-callout = předpis
cli-what-measured-value = naměřená hodnota
cli-what-hole = díra
cli-what-shaft = hřídel
cli-what-measured-hole = změřená díra
cli-what-measured-shaft = změřený hřídel
cli-what-hole-material = materiál díry
cli-what-shaft-material = materiál hřídele
cli-what-temperature = teplota
cli-what-smallest-clearance = nejmenší vůle
cli-what-largest-clearance = největší vůle
cli-what-nominal-size = jmenovitý rozměr { $text }
cli-what-true-diameter = skutečný průměr
cli-what-simulated-workpiece = simulovaný obrobek
cli-what-simulated-measurement = simulované měření
cli-what-perfect-workpiece = jmenovitý obrobek
cli-what-size = rozměr
cli-what-cycle = cyklus { $code }
cli-what-log = protokol
cli-what-entry = zápis { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Errors
cli-batch-simulated = první řádky { $name } uvádějí, že je simulovaný, a zachovat je umí jen CSV: zapisujte CSV
cli-dash = - je standardní výstup, což zde není možné: uveďte název, nebo ./- pro soubor či složku s názvem -
cli-no-subcommand = { $given } není podpříkaz; zde jsou: { $names }
cli-not-above-zero = { $diameter } mm není nad 0
cli-ratio-of-one-limit = pravidlo asme-simple porovnává nejistotu s tolerancí: očekává se --lower a --upper
cli-already-corrected = --temperature: soubor udává, že jeho hodnoty už platí pro 20 °C
cli-not-a-multiple = { $given }: očekává se číslo nad 0 s nejvýše třemi desetinnými místy
cli-no-limits = uveďte --lower, --upper nebo obě, dolní mez pod horní
cli-risk-without-uncertainty = rizika procesu potřebují --u nebo --expanded
cli-risk-without-process = --consumer-risk potřebuje --process-mean a --process-sd, nebo --gamma
cli-not-a-risk = riziko { $given }: očekává se pravděpodobnost mezi 0 a 1, například 0.001
cli-not-a-gamma = rozdělení gama { $given }: očekává se jeho tvar a měřítko v µm, například 4,0.25
cli-no-zone-for-risk = žádné pole přijímaných hodnot nemá toto riziko odběratele
cli-line-too-long = řádek je delší než { $limit } bajtů
cli-not-a-table = { $name } není tabulka úchylek
cli-stats-features = více znaků: vyberte jeden pomocí --feature: { $names }
cli-stats-no-feature = znak { $given } neexistuje: soubory mají { $names }
cli-stats-limits = meze se liší hodnotu od hodnoty: zadejte --lower a --upper, nebo vyberte znak pomocí --feature
cli-stats-no-point = bod { $point } neexistuje: diagram jich má { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (pokud je to správně: --confirm-layout)
cli-stats-no-budget = tato studie nedává do bilance žádný příspěvek
cli-stats-no-picture = obrázek nelze nakreslit: { $why }
cli-stats-points = --stage a --leave-out platí pro jeden znak: vyberte ho pomocí --feature místo --all
cli-stats-parameters = --parameters patří k --chart ewma nebo cusum
cli-add-feature = { $error }: doplňte --feature hole nebo --feature shaft
cli-add-wide-zone = { $asked }: { $error }; je-li toto toleranční pole záměr, doplňte --wide-zone
cli-add-far-temperature = { $what }: { $error }; je-li tato teplota záměr, doplňte --far-temperature
cli-remark-open = { $count ->
    [one] jedna hodnota je mimo meze; zda je to oprava, nebo zmetek, závisí na tom, zda jde o díru, nebo hřídel: doplňte --feature hole nebo --feature shaft, sloupec kind s těmito slovy, nebo plán
    [few] hodnoty mimo meze: { $count }; zda je to oprava, nebo zmetek, závisí na tom, zda jde o díru, nebo hřídel: doplňte --feature hole nebo --feature shaft, sloupec kind s těmito slovy, nebo plán
   *[other] hodnoty mimo meze: { $count }; zda je to oprava, nebo zmetek, závisí na tom, zda jde o díru, nebo hřídel: doplňte --feature hole nebo --feature shaft, sloupec kind s těmito slovy, nebo plán
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked }: { $um } µm nad maximem; zda je to oprava, nebo zmetek, závisí na tom, zda jde o díru, nebo hřídel: doplňte --feature hole nebo --feature shaft
   *[below] { $asked }: { $um } µm pod minimem; zda je to oprava, nebo zmetek, závisí na tom, zda jde o díru, nebo hřídel: doplňte --feature hole nebo --feature shaft
}
cli-parts-of-several = změřené díly patří k jednomu uložení: uveďte jeden předpis
cli-search-with-parts = hledání nepřijímá změřené díly, materiály ani teploty
cli-search-without-size = hledání potřebuje jeden jmenovitý rozměr, například 25
cli-search-without-clearance = hledání potřebuje --min-clearance a --max-clearance
cli-table-ending = { $path }: název tabulky řídicího systému končí .tab
cli-format-ending = { $path }: soubor formátu { $format } končí .{ $endings }
cli-several-tables = tabulka řídicího systému je jeden soubor: uveďte jednu tabulku, nebo třídy jen pro díry či jen pro hřídele
cli-report-format = --format { $format } neodpovídá příponě { $file }: jedno z nich vynechte
cli-stopped = zastaveno pomocí Ctrl+C, řádků: { $rows }
cli-report-empty = žádná kontrola nebyla použitelná, zpráva proto nebyla zapsána
cli-inputs-too-large = vstupy cyklu mají nejvýše { $most } KiB
cli-not-an-object = vstupy musí být objekt JSON, například {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: očekává se číslo nebo text
cli-given-twice = { $name } je uvedeno dvakrát
cli-option-of-standard = --{ $option } nemá s --source control účinek: tabulky řídicího systému mají jen jedno vydání ISO 286
cli-set-twice = { $name } je nastaveno dvakrát
cli-several-blocks = několik měřicích cyklů, na řádcích { $blocks }: vyberte jeden pomocí --at ŘÁDEK
cli-other-cycle = toto je cyklus { $given }, ne { $wanted }
cli-not-predef = PREDEF není u parametru { $name } dovoleno
cli-no-probe = tabulka dotykových sond nemá sondu { $number }
cli-not-a-pair = { $text }: pište parametr jako NAME=VALUE
cli-not-a-position = poloha { $text }: očekávají se tři čísla X,Y,Z v mm
cli-not-a-number = to není číslo
cli-no-folder = taková složka neexistuje: { $path }
cli-watched-already = { $path } sleduje pro tento deník jiný program
cli-no-program = { $error }; vestavěné programy jsou { $names }
cli-option-beside-plan = --{ $option } je pro jednotlivý předpis: plán má pro to sloupec
cli-option-missing = chybí --{ $option }: jednotlivý předpis potřebuje --x, --y a --z
cli-batch-ending = { $path }: výstup musí končit .{ $endings }, pro kompresi následuje .gz nebo .zst
cli-batch-onto-itself = { $path } je jedním ze vstupů: zapište odpovědi do jiného souboru
cli-batch-columns = { $name } má jiné sloupce než první soubor, který má { $columns }
cli-batch-separator = { $name } má jiný oddělovač než první soubor: zapisujte .jsonl, nebo tento soubor posuďte samostatně
cli-batch-types = sloupec { $column } v { $name } má v prvním souboru jiný typ: zapisujte .csv, nebo tento soubor posuďte samostatně
cli-batch-packed = { $path }: Parquet je už komprimován: vynechte .gz nebo .zst
cli-batch-twice = { $name } má dva sloupce s názvem { $column }: zapisujte .csv, které to dovoluje
cli-batch-input = { $name }: { $error }
cli-batch-name = { $name } už má sloupec { $column }: pomocí --prefix dejte před názvy přidaných sloupců slovo
cli-use-force = { $error }; --force přepíše

# A --check of a report
cli-check-no-measured = { $text } nemá naměřenou hodnotu: pište předpis, = a milimetry, například 25 H7=25.012
cli-check-measured = naměřená hodnota: { $value }
cli-check-not-positive = naměřená hodnota { $measured } mm není nad 0

# Remarks
cli-remark-wrote = zapsáno: { $path }
cli-remark-wrote-files = zapsáno: { $path } (souborů: { $count })
cli-remark-simulated = simulováno: nic se neměřilo
cli-remark-perfect-workpiece = simulováno: každý cyklus měřil dokonalý obrobek se jmenovitým rozměrem; pro jiný obrobek použijte --workpiece FILE.toml
cli-remark-corrected = naměřeno { $measured } mm při { $temperature } °C: { $change } µm, tedy { $at-reference } mm při 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = každá naměřená hodnota je přepočtena z { $temperature } °C na 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = odměřování při { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = lineární přepočet se od přesného liší o { $off } µm
cli-remark-rule = pravidlo: { $rule }
cli-remark-rule-by-budget = pravidlo: { $rule }
cli-remark-budget = nejistota z bilance { $name }, vytvořena { $date }, platí do { $until }
cli-remark-budget-contacts = rozptýlení bodů dotyku, počet { $touches }{ $step }, geometrický činitel { $factor }
cli-remark-accepted = přijímá se: { $least } až { $most } mm
cli-remark-nothing-accepted = nepřijímá se žádná hodnota: pravidlo z této tolerance nic nenechává
cli-remark-proven = podle tohoto pravidla prokázáno
cli-remark-not-proven = podle tohoto pravidla neprokázáno
cli-remark-conformity = shoda s pravděpodobností { $percent } %
cli-remark-remove = odebrat { $limit } mm k nejbližší mezi, { $middle } mm do středu tolerančního pole
cli-remark-refused = odmítnuto předpisů: { $refused } z { $asked }
cli-remark-no-pair = žádný pár nevyhovuje; nejbližší je { $nearest }
cli-remark-trace-ends = výpis průběhu zde končí, bloků: { $blocks }
cli-remark-batch-utf16 = { $name } je v UTF-16 a zapisuje se jako UTF-8
cli-remark-batch-floats = { $name } má čísla s plovoucí čárkou v { $columns }: každé se posuzuje jako nejkratší desetinné číslo, které je zastupuje
cli-remark-tools-not-written = tabulka nástrojů se nezapisuje: s těmito změnami ji zapíše --tools-out FILE.t
cli-remark-clearance-height = bezpečná výška je { $height } mm: mění ji --clearance-height
cli-remark-more-entries = vypsáno je jen { $limit } zápisů: pro více použijte --limit N
cli-remark-backed-up = zkopírováno až po zápis { $number } do { $path } (hash { $hash })
cli-remark-no-head-known = žádný zápis tohoto deníku není znám odjinud: chybějící nejnovější zápisy by se nezjistily

# Warnings
cli-warning-stopped-unrecorded = nic nebylo zaznamenáno: řádky se zaznamenávají společně, až jsou všechny přečteny
cli-warning-column-not-used = sloupec { $column } je přeskočen
cli-warning-expansion-unconfirmed = roztažnost { $expansion } · 10⁻⁶/K je obvyklá hodnota, kterou zde nepotvrzuje žádný dokument
cli-warning-file-twice = tento soubor je uveden dvakrát: jeho řádky se počítají dvakrát
cli-warning-position-unused = --position nemá účinek: cyklus { $code } nezačíná v poloze kuličky
cli-warning-predef-unused = --predef nemá na { $name } účinek: není nastaveno na PREDEF
cli-warning-log-option = --{ $option } nemá účinek: žádný protokol se nezapisuje ani nezobrazuje
cli-warning-more-figures = další taková čísla nejsou vypsána, počet: { $count }
cli-warning-tables-not-used = --tables, --source a volby normy se nepoužijí: bez --fit se žádné meze nehledají
cli-warning-empty-cell = { $class } nad { $over } do { $to } mm zůstává prázdné: ISO 286 nemá pro celý rozsah jedinou hodnotu
cli-warning-budget-option = --{ $option } nemá účinek: bilance na tom nezávisí
cli-warning-contacts-left = cyklus použil { $used } z { $count } bodů dotyku
cli-warning-not-in-csv = CSV nemá místo pro { $options }: HTML, JSON a PDF ano
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } hlášení není v CSV: HTML a JSON je obsahují
    [few] { $count } hlášení nejsou v CSV: HTML a JSON je obsahují
   *[other] { $count } hlášení není v CSV: HTML a JSON je obsahují
}
cli-warning-no-tool-monitored = tabulka nástrojů se nepoužije: v Q330 není uveden nástroj
cli-warning-log-unknown = žádný protokol se nezapisuje: protokol cyklu { $code } není znám
cli-warning-limits-alone = zde rozhodují jen meze: rozhodovací pravidlo a teplota platí jen pro průměry
cli-warning-log-off = žádný protokol se nezapisuje: Q281 = 0
cli-warning-log-none = žádný protokol se nezapisuje: cyklus žádný nemá
cli-warning-log-on-screen = žádný protokol se nezapisuje: Q281 = 2 jej zobrazí na obrazovce

# Tables against ISO 286
cli-verify-off = { $place }: { $class } nad { $over } do { $to } mm: { $table }, ISO 286 má { $standard }: { $by }
cli-verify-missing = { $place }: { $class } nad { $over } do { $to } mm: bez hodnoty, ISO 286 má { $standard }
cli-verify-undefined = { $place }: { $class } nad { $over } do { $to } mm: { $table }, ale { $reason }
cli-verify-neither = { $place }: { $class } nad { $over } do { $to } mm: { $reason }
cli-verify-by = { $side ->
        [upper] horní
       *[lower] dolní
    } o { $um } µm { $way ->
        [more] více
       *[less] méně
    }
cli-verify-table = { $name }: { $classes ->
        [one] { $classes } třída
        [few] { $classes } třídy
       *[other] { $classes } tříd
    }, { $ranges ->
        [one] { $ranges } rozsah rozměrů
        [few] { $ranges } rozsahy rozměrů
       *[other] { $ranges } rozsahů rozměrů
    }, porovnáno { $cells ->
        [one] { $cells } buňka
        [few] { $cells } buňky
       *[other] { $cells } buněk
    }: { $differ ->
        [0] vše se shoduje s ISO 286
        [one] { $differ } se liší od ISO 286
       *[other] { $differ } se liší od ISO 286
    }
cli-verify-nothing = { $name }: { $classes ->
        [one] { $classes } třída
        [few] { $classes } třídy
       *[other] { $classes } tříd
    }, { $ranges ->
        [one] { $ranges } rozsah rozměrů
        [few] { $ranges } rozsahy rozměrů
       *[other] { $ranges } rozsahů rozměrů
    }, porovnáno buněk { $cells }: není co porovnat s ISO 286
cli-verify-own = { $table }; neporovnáno, nejsou to třídy ISO 286: { $own }

## Start
start-missing = takový soubor neexistuje: { $path }; uveďte existující soubor, který se má otevřít v okně, nebo podpříkaz
start-folder = to je složka, ne soubor: { $path }; v okně se otevírají jen soubory

## What was recorded
cli-recorded-entry = zaznamenáno jako zápis { $number } v { $file } (hash { $hash })
cli-recorded-entries = zaznamenáno jako zápisy { $first } až { $last } v { $file } (hash posledního { $hash })
cli-recorded-nothing = nic nebylo posouzeno, nic proto nebylo zaznamenáno
cli-recorded-without = { $rows ->
    [one] 1 řádek není zaznamenán
    [few] { $rows } řádky nejsou zaznamenány
   *[other] { $rows } řádků není zaznamenáno
}: { $places }
cli-not-recorded = nic nebylo zaznamenáno: { $error }
cli-journal-is-server = je třeba soubor deníku stanice: server jen přijímá, co stanice zaznamenaly
cli-no-shop = tento program byl sestaven bez podpory serveru dílny: uveďte jako deník soubor
cli-recorded-not-sent = zatím neodesláno na server: { $error }; záznamy se zde uchovávají a odešle je fitcheck journal send
cli-no-journal-folder = tento systém nemá složku pro vaše data: uveďte deník pomocí --journal FILE
cli-no-entry = zápis { $number } v { $path } není: poslední je { $last }
cli-no-check = zápis { $number } není kontrola
cli-no-hash = žádný zápis v { $path } nemá hash, který začíná { $prefix }
cli-several-hashes = hashe více zápisů začínají { $prefix }: { $numbers }. Uveďte více číslic nebo číslo zápisu
cli-record-needs-file = --record uvádí soubor, který byl zapsán, a standardní výstup jím není: uveďte -o FILE
cli-report-not-known = { $file } je zapsán, ale deník jej nezná: { $error }
cli-already-corrected-by = zápis { $number } už byl korigován nebo odvolán zápisem { $by }: korigujte ten, pokud to není odvolání
cli-not-typed = hodnota zápisu { $number } nebyla zadána ručně: přeměřte, nebo kontrolu odvolejte
cli-nothing-corrected = korekce musí něco změnit: uveďte --measured, --who, --part, --serial, --feature-name, --remark nebo --withdraw
cli-remark-sent = { $entries ->
    [0] nebylo co odeslat
    [one] odeslán 1 zápis
    [few] odeslány { $entries } zápisy
   *[other] odesláno { $entries } zápisů
} na { $server }, kde je tento deník až po zápis { $number }
cli-remark-nothing-found = dotazu { $question } neodpovídá žádná kontrola
cli-remark-unread = { $entries ->
    [one] 1 zápis je přeskočen
    [few] { $entries } zápisy jsou přeskočeny
   *[other] { $entries } zápisů je přeskočeno
}: tato verze { $entries ->
    [one] jej neumí číst
   *[other] je neumí číst
}
cli-head-without-chain = server má několik řetězů: uveďte --head CHAIN:NUMBER:HASH
cli-head-of-other = tento deník je řetěz { $chain }, ale --head uvádí { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } prvek
    [few] { $count } prvky
   *[other] { $count } prvků
}
cli-remark-plan-example = není uveden předpis: plán má jeden prvek jako příklad
cli-remark-plan-to-fill = plán je zapsán, pokud je znám; chyby k opravě: { $count }
cli-remark-no-columns = soubor se čte podle vlastního formátu a nemá sloupce k výběru
cli-remark-plan-head-left = CSV obsahuje jen prvky: { $keys } dílu se nezapisuje
cli-warning-neither-stands = zápis { $number } korigoval zápis { $target }: nyní neplatí žádný z nich. Je-li jedna z hodnot správná, zaznamenejte ji znovu
cli-warning-beyond-limits = mimo meze: podle pravidla přijato, protože není prokázáno, že je mimo
cli-warning-plan-missing = nezměřeno: { $names }
cli-warning-plan-missing-of = { $who }: nezměřeno: { $names }
cli-warning-contradiction = { $name } má hodnoty, které si odporují: { $values }
cli-warning-contradiction-of = { $who }: { $name } má hodnoty, které si odporují: { $values }
cli-warning-worst-counts = z hodnot, které si odporují, platí nejhorší, dokud nezvolíte: --repeats last nebo --repeats worst. Díly rozlišují sériová čísla a poslední hodnotu určuje čas u každé z nich
cli-warning-plan-more-parts = více než { $most } dílů: chybějící prvky ostatních se nehlásí
cli-warning-plan-no-value = chybí: hodnota nenalezena
cli-warning-plan-no-value-of = chybí na { $who }: hodnota nenalezena
cli-remark-watching = sleduje se { $folder }; dříve importované soubory: { $known }
cli-warning-see-note = ne vše bylo možné použít: důvody uvádí vedlejší soubor s koncovkou { $note }
cli-not-seconds = { $given } není čas v sekundách
cli-warning-same-content = stejný obsah byl importován dříve jako { $known }: nic se znovu nezaznamená
cli-warning-not-alone = nelze zjistit, zda tuto složku nesleduje pro stejný deník jiný program: { $reason }

## The time zone of this computer
zone-not-understood = TZ je nastaveno na „{ $given }“, což není časové pásmo: nastavte název jako Europe/Amsterdam nebo UTC, nebo je zrušte
zone-unknown = časové pásmo tohoto počítače není známo, časy jsou proto v UTC: nastavte TZ na název jako Europe/Amsterdam

# Doktor
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, je { $time }
doctor-clock = ne před nejnovějším zápisem deníku
doctor-clock-behind = před nejnovějším zápisem v { $path }, zapsaným { $newest }: nastavte hodiny tohoto počítače
doctor-folder = { $path }: soubory lze zapisovat
doctor-journal = { $path }: zápisů { $entries }
doctor-no-journal = { $path } zatím není: vytvoří jej první zaznamenaná kontrola
doctor-server = { $address } odpovídá
doctor-no-server = žádný server není nastaven: uveďte jej pomocí --journal postgres://…, nebo v okně v Nastavení
doctor-gauges = porty tohoto počítače: { $ports }
doctor-no-port = tento počítač nemá sériový port: připojte měřidlo nebo jeho kabel
doctor-gauge-gone = { $gauge }: port { $port } chybí: připojte měřidlo, nebo v okně v Nastavení zvolte jiný port
doctor-no-gauges = tento program byl sestaven bez portů měřidel: balíčky je mají
doctor-ports-not-listed = porty tohoto počítače nelze vypsat: { $reason }
doctor-tables = { $path }: tabulek { $count }
doctor-no-tables = žádné vlastní tabulky: ISO 286 a tabulky řídicího systému jsou vestavěné
doctor-settings = co okno uchovává, lze přečíst
doctor-window = kresleno pomocí { $renderer }
doctor-no-window = tento program byl sestaven bez okna
