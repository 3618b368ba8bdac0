# tolerance

## Lengths
length-empty = chybí délka
length-not-a-number = { $text } není číslo
length-ambiguous = { $text } není jednoznačné: pište jeden desetinný oddělovač a žádný oddělovač tisíců
length-too-fine = { $text } je jemnější než nanometr
length-too-large = { $text } je příliš velké: nejvýše { $max } mm v obou směrech

## Callouts and classes
callout-empty = chybí předpis: zadejte jmenovitý rozměr a toleranční třídu, například 25 H7
callout-no-nominal = { $text } nezačíná jmenovitým rozměrem: zadejte jej, například 25 H7
callout-nominal = jmenovitý rozměr: { $error }
callout-not-positive = jmenovitý rozměr { $nominal } mm není nad 0
class-missing = chybí toleranční třída, například H7 pro díru nebo h7 pro hřídel
class-mixed-case = { $text } míchá velká a malá písmena: pište { $upper } pro díru nebo { $lower } pro hřídel
class-malformed = { $text } není toleranční třída: pište písmena a stupeň, například H7 nebo js13

## Deviations and limits
deviations-order = horní úchylka { $upper } mm je pod dolní úchylkou { $lower } mm
nominal-by-operator = ? znamená, že sondu polohuje obsluha: zapište jmenovitou hodnotu bez tohoto znaku
nominal-not-probed = @ znamená, že řízení nesnímá a převezme hodnotu za ním: nic by se nezměřilo
source-choice-iso286 = ISO 286, všechny třídy do 3150 mm
source-choice-control = Tabulky řídicího systému, 47 tříd do 400 mm
source-choice-after-own = Vlastní tabulky, pak { $base }
source-iso286 = ISO 286, nad { $over } do { $to } mm
source-iso286-remark = ISO 286, nad { $over } do { $to } mm; { $remark }
source-shipped-table = vestavěná tabulka { $name }, nad { $over } do { $to } mm
source-table = tabulka { $name }, nad { $over } do { $to } mm
figure-own-table = { $class } nad { $over } do { $to } mm: tabulka { $table } se liší od ISO 286, kde je { $upper } a { $lower } mm
figure-standard = { $class } nad { $over } do { $to } mm: { $why }
source-file = soubor { $name }
source-iso2768 = ISO 2768-1 třída { $class }, nad { $over } do { $to } mm
source-callout = samotný předpis
source-without-own = { $source }; vlastní tabulky ve složce { $folder } nelze přečíst
source-recorded = { $text }
limits-own-awaited = Vlastní tabulky ve složce { $folder } se ještě čtou
limits-no-feature = { $callout } neříká, zda jde o díru, nebo o hřídel
limits-other-feature = { $feature ->
    [hole] { $class } je třída pro díry, ne pro hřídele
   *[shaft] { $class } je třída pro hřídele, ne pro díry
}
limits-other-case = { $feature ->
    [hole] { $class } je třída pro díry a tabulka { $table } ji nemá; třída pro hřídele je { $other }
   *[shaft] { $class } je třída pro hřídele a tabulka { $table } ji nemá; třída pro díry je { $other }
}
limits-unknown-class = { $class } není v tabulce { $table }; ta má { $known }
limits-no-own-table = { $class } není toleranční třída podle ISO 286: pište písmena a stupeň, například H7 nebo js13, nebo zvolte vlastní tabulky se sloupcem { $class }
limits-no-own-column = { $class } není toleranční třída podle ISO 286 a tabulka { $table } nemá sloupec { $class }; má { $known }
limits-beyond-last-range = jmenovitý rozměr { $nominal } mm je mimo tabulku { $table }, jejíž poslední rozsah je nad { $over } do { $to } mm včetně
limits-not-defined = { $class } není v tabulce { $table } stanovena pro rozměry nad { $over } do { $to } mm; { $where }
limits-defined-nowhere = není stanovena pro žádný rozměr
limits-defined = je stanovena pro rozměry { $ranges }
limits-range = nad { $over } do { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = meze pro { $nominal } mm jsou příliš velké

## Zones out of all proportion
zone-micrometres = toleranční pole { $width } mm je zcela nepřiměřené rozměru { $nominal } mm, jehož IT 18 je { $widest } mm: jsou-li úchylky v mikrometrech, pište { $offer }
zone-wide = toleranční pole { $width } mm je zcela nepřiměřené rozměru { $nominal } mm, jehož IT 18 je { $widest } mm: ověřte jmenovitý rozměr a meze
zone-micrometres-to-zero = dolní mez { $minimum } mm není nad 0: jsou-li úchylky v mikrometrech, pište { $offer }
zone-to-zero = dolní mez { $minimum } mm není nad 0: ověřte jmenovitý rozměr a meze
zone-coordinate-micrometres = toleranční pole { $width } mm je širší než { $widest } mm, maximum pro souřadnici: jsou-li úchylky v mikrometrech, pište { $offer }
zone-coordinate = toleranční pole { $width } mm je širší než { $widest } mm, maximum pro souřadnici: ověřte meze

shape-no-ranges = tabulka nemá žádný rozsah rozměrů
shape-not-ascending = rozsah rozměrů do { $end } mm nekončí nad předchozím, { $before } mm
shape-cells = sloupec { $class }, počet buněk { $cells }, počet rozsahů rozměrů { $ranges }
shape-twice = sloupec { $class } se vyskytuje dvakrát

## Verdicts
status-good = DOBRÝ
status-accepted = PŘIJATO
status-rework = OPRAVA
status-re-measure = PŘEMĚŘIT
status-out-of-limits = MIMO TOLERANCI
status-scrap = ZMETEK
rule-simple = bez ochranného pásma, meze patří do tolerančního pole
rule-iso14253-2017 = ISO 14253-1:2017, shoda 95 %, { $prover ->
    [customer] zákazník prokazuje neshodu
   *[supplier] dodavatel prokazuje shodu
    }; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, ochranné pásmo U, { $prover ->
    [customer] zákazník prokazuje neshodu
   *[supplier] dodavatel prokazuje shodu
    }; { $u }
rule-ilac-g8 = ILAC-G8, ochranné pásmo { $factor } U, { $prover ->
    [customer] zákazník prokazuje neshodu
   *[supplier] dodavatel prokazuje shodu
    }; { $u }
rule-asme-simple = ASME B89.7.3.1, prosté přijetí 4:1; { $u }
rule-asme-stringent = ASME B89.7.3.1, přísné přijetí, ochranné pásmo { $factor } U; { $u }
rule-asme-relaxed = ASME B89.7.3.1, zmírněné přijetí o { $factor } U; { $u }
rule-fixed = ochranné pásmo { $width } µm, { $prover ->
    [customer] zákazník prokazuje neshodu
   *[supplier] dodavatel prokazuje shodu
    }
rule-no-uncertainty = pravidlo { $rule } potřebuje nejistotu naměřené hodnoty
rule-no-factor = pravidlo { $rule } nemá násobek
rule-no-width = pravidlo { $rule } počítá ochranné pásmo z nejistoty
rule-width-missing = pravidlo { $rule } potřebuje ochranné pásmo nad 0 µm
rule-no-prover = pravidlo { $rule } nezávisí na důkazním břemenu
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = nejistota musí být nad 0 µm
uncertainty-factor = koeficient rozšíření { $given }: očekává se číslo od 1 do 10 s nejvýše třemi desetinnými místy
uncertainty-by-budget = u každé hodnoty podle bilance
undecided-contacts = body dotyku ({ $contacts }) určují průměr { $times }krát méně jistě než { $contacts } bodů po celé kružnici, zadaná nejistota však platí jen do trojnásobku: rozložte body po delším oblouku, nebo použijte bilanci
doubt-times-inch = naměřená hodnota je 25,4násobek jmenovitého rozměru: byla dvakrát přepočtena z palců?
doubt-inches = naměřená hodnota je jmenovitý rozměr dělený 25,4: je v palcích?
doubt-double = naměřená hodnota je dvojnásobek jmenovitého rozměru: nebyl průměr považován za poloměr?
doubt-half = naměřená hodnota je polovina jmenovitého rozměru: není to poloměr?
doubt-decimal-sign = naměřená hodnota je přibližně jmenovitý rozměr s jinak umístěným desetinným oddělovačem: má být { $meant } mm?
doubt-far = naměřená hodnota leží { $distance } mm mimo meze: je to tento díl a v milimetrech?
doubt-implausible = naměřená hodnota leží mimo to, co je podle plánu možné, { $lower } až { $upper } mm: jsou jednotka a desetinný oddělovač správně?

## Files
file-is-folder = to je složka, ne soubor: { $path }
file-missing = takový soubor nebo složka neexistuje: { $path }
file-exists = soubor nebo složka s tímto názvem už existuje: { $path }
file-half-set = zápis sady souborů se zastavil uprostřed, část souborů ve složce je proto stará a část nová: k dokončení zapište sadu znovu; co se má ještě přesunout, je v { $path }
file-not-a-file = to je roura nebo zařízení, ne soubor: { $path }
file-changed = soubor se během čtení změnil; načtěte jej znovu: { $path }
file-busy = soubor je otevřen v jiném programu: zavřete jej tam a zkuste to znovu: { $path }
file-stopped = zastaveno: nic nebylo zapsáno: { $path }
file-too-large = soubor je větší než { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-grade-missing = { $class } není toleranční třída podle ISO 286: pište písmena a stupeň, například H7 nebo js13
iso286-no-grade = { $class } není toleranční třída podle ISO 286: stupně jsou { $grades }
iso286-no-letter = { $class } není toleranční třída podle ISO 286: písmeno { $letters } neexistuje, jen { $known }
iso286-too-large = jmenovitý rozměr { $nominal } mm je mimo ISO 286, která končí u 3150 mm
iso286-not-here = { $class } není v ISO 286 pro { $nominal } mm stanovena; { $where }
iso286-js-rounded = JS zaokrouhleno jako v roce 1988
iso286-contested-ef = sporné: ef je zde 28 µm, jiné zdroje uvádějí 25 µm
iso286-older-it5 = ke zkušebnímu použití; starší katalogy zde mají menší IT5
iso286-trial-use = ke zkušebnímu použití

## Fits
fit-kind-clearance = uložení s vůlí
fit-kind-transition = přechodné uložení
fit-kind-interference = uložení s přesahem
fit-basis-hole = jednotná díra
fit-basis-shaft = jednotný hřídel
fit-basis-both = jednotná díra i jednotný hřídel
fit-preferred-hole-basis = přednostní uložení v soustavě jednotné díry
fit-preferred-shaft-basis = přednostní uložení v soustavě jednotného hřídele
fit-function-loose-running = volně točné s velkou vůlí
fit-function-free-running = volně točné
fit-function-close-running = těsně točné
fit-function-sliding = kluzné
fit-function-locational-clearance = středicí s vůlí
fit-function-locational-transition = středicí přechodné
fit-function-locational-transition-tighter = středicí přechodné, těsnější
fit-function-locational-interference = středicí s přesahem
fit-function-medium-drive = středně lisované
fit-function-force = silně lisované
fit-one-sided = { $callout } není uložení: pište rozměr, třídu díry a třídu hřídele, například 25 H7/g6
fit-not-a-hole = { $minimum } až { $maximum } mm jsou meze hřídele: očekávají se meze díry
fit-not-a-shaft = { $minimum } až { $maximum } mm jsou meze díry: očekávají se meze hřídele
fit-nominal-sizes = uložení má jeden jmenovitý rozměr: díra má { $hole } mm, hřídel { $shaft } mm
fit-too-large = vůle je příliš velká
fit-search-order = nejmenší vůle { $minimum } mm je nad největší vůlí { $maximum } mm
fit-search-no-classes = tabulky nemají pro { $nominal } mm třídy zároveň pro díru i hřídel
fit-thermal-too-fine = { $text } má více než tři desetinná místa
fit-thermal-temperature = teplota { $text } °C je mimo rozsah: od -273,15 do 1000 °C
fit-thermal-expansion = roztažnost { $text } je mimo rozsah: od -20 do 500 miliontin na kelvin, například 11,5 pro ocel
fit-thermal-expansion-unit = roztažnost { $text } je v jiné jednotce: roztažnosti jsou v miliontinách na kelvin; pište { $meant }

## Temperatures that are doubted
thermal-doubt-fahrenheit = { $given } °C je daleko od teplot, při kterých se díly měří: je-li to ve stupních Fahrenheita, pište { $meant }
thermal-doubt-kelvin = { $given } °C je daleko od teplot, při kterých se díly měří: je-li to v kelvinech, pište { $meant }
thermal-doubt-far = { $given } °C je daleko od teplot, při kterých se díly měří, { $least } až { $most } °C: ověřte ji
thermal-doubt-beyond = { $given } °C je mimo { $least } až { $most } °C, kde platí roztažnost { $expansion } miliontin na kelvin: zadejte roztažnost pro tuto teplotu

## Materials
material-published = zveřejněná hodnota
material-verify = obvyklá hodnota, je třeba ji ověřit
material-own = vlastní hodnota
material-toml = { $reason }
material-version = verze { $found } souboru materiálů není podporována: očekává se verze { $known }
material-too-many = příliš mnoho materiálů, { $count }: nejvýše { $most }
material-too-large = soubor materiálů má nejvýše { $most } bajtů
material-name = název materiálu má 1 až { $longest } znaků a žádné řídicí znaky
material-range = rozsah teplot začíná nižší teplotou: pište dvě čísla v °C, například [-50, 200]
material-elastic = modulus a poisson patří k sobě: modulus od 1 do 1200000 MPa, poisson od 0 do 0.5, yield od 1 do 10000 MPa
material-twice = materiál { $name } je definován dvakrát
material-unknown = neznámý materiál { $name }: zvolte jeden z { $known }, nebo zadejte samotnou roztažnost, například 11,5
## Callouts: deviations, limits, fits and general tolerances
callout-at = { $reason } (znak { $at })
callout-no-tolerance = chybí tolerance, například H7, h7, H7/g6, m, +0,1 -0,2 nebo ±0,1
callout-general-capital = { $capital } nemá stupeň: pište { $offer } pro všeobecnou toleranci podle ISO 2768-1, nebo doplňte stupeň, například { $capital }7
callout-fit-order = hřídel je před dírou: pište { $offer }
callout-fit-side = { $first } a { $second } nejsou díra a hřídel: uložení se píše velkými a pak malými písmeny, například 25 H7/g6
callout-number = { $part }: { $error }
callout-not-a = { $part }: { $found } se nehodí; { $how }
callout-missing = chybí { $part }: { $how }
callout-part-deviation = úchylka
callout-part-limit = mezní rozměr
callout-part-actual = hodnota za @
callout-how-deviation = pište znaménko a číslo, například +0,1 nebo -0,1
callout-how-limit = pište dva rozměry, větší jako první, například 12,01/11,985
callout-how-actual = pište číslo, například 10H7@10,004
callout-no-sign = { $number } nemá znaménko: pro úchylku pište +{ $number } nebo -{ $number }, bez mezery v čísle
callout-no-unit = { $number } nemá jednotku a druhá úchylka je v µm: pište jednotku za obě
callout-deviation-order = dolní úchylka je před horní: pište { $offer }
callout-limits-order = menší mez je před větší: pište { $offer }
callout-limits-apart = { $larger } mm je více než dvojnásobek { $smaller } mm, zřejmě to tedy nejsou meze: pište úchylky, například 12 +0,2 0
callout-limits-or-deviation = nejednoznačné: pište { $limits } pro mezní rozměry, nebo { $deviation } pro dolní úchylku
callout-limits-meant = taková úchylka by z rozměru nic nenechala: pište { $limits } pro mezní rozměry
callout-minimum-not-positive = dolní mez { $minimum } mm není nad 0
callout-micrometres-meant = dolní mez { $minimum } mm není nad 0: jsou-li úchylky v mikrometrech, pište { $offer }
callout-mixed-decimals = { $number } má jiný desetinný oddělovač než předchozí číslo: použijte jediný
callout-cycle-sign = { $sign } patří do textů cyklů 14xx, ne do předpisu
callout-not-in-cycle-text = { $found } v textu cyklů 14xx nemůže být: pište třídu, všeobecnou třídu nebo úchylky
callout-too-much = { $found } se zde neočekává: text je úplný i bez toho
callout-too-long = text je příliš dlouhý: nejvýše { $most } znaků
callout-band-order = dolní úchylka je před horní: pište QS400 jako 0.4-0.1
callout-lone-order = dolní úchylka je před horní: pište { $offer }
callout-inch = { $given } je { $nominal } mm: rozměry jsou v milimetrech, napište { $offer }
callout-inch-size = { $given } je { $nominal } mm: napište rozměr a toleranci v milimetrech
callout-inch-somewhere = { $given } je v palcích: napište rozměr a toleranci v milimetrech, 1 palec je 25.4 mm
callout-thread = { $given } je závit, ne hladká díra nebo hřídel: napište malý nebo střední průměr s oběma mezemi, např. 5.153/4.917
callout-exact = teoreticky přesný rozměr nemá vlastní toleranci: napište rozměr s mezemi, které pro něj platí, např. 25 ±0.1
callout-reference = rozměr v závorce je jen informativní a nemá toleranci: má-li se posuzovat, napište ho bez závorky
callout-one-sided = { $given } má jen jednu mez: napište oba mezní rozměry, větší první, např. 8.2/8
callout-roughness = { $given } je drsnost povrchu, ne rozměr: napište rozměr s tolerancí, např. 25 H7
callout-modifier = { $given } není modifikátor podle ISO 14405-1: modifikátory jsou { $known }
callout-grade = { $given } není při { $nominal } mm definováno: napište toleranční stupeň od IT1 do IT18, který tam ISO 286 má
callout-ansi = { $class } je třída podle ANSI B4.1, jejíž tabulky Fitcheck nemá: napište třídu podle ISO 286, nebo rozměr a úchylky v milimetrech
callout-stated-micrometres = úchylky za tolerancí jsou mimo jakýkoli poměr k { $nominal } mm: jsou-li v mikrometrech, napište ({ $offer })
callout-stated-of-fit = úchylky za uložením mohou patřit kterémukoli dílu: napište je za každou třídu zvlášť
iso286-grade-alone = { $class } je toleranční stupeň: říká, jak široké je pole, ale ne, kde leží; napište ±{ $grade }/2 nebo třídu, např. H7
general-too-small = jmenovitý rozměr { $nominal } mm je pod { $first } mm, kde ISO 2768-1 začíná: uveďte úchylky u rozměru
general-too-large = jmenovitý rozměr { $nominal } mm je mimo ISO 2768-1, která končí u { $last } mm
general-not-defined = ISO 2768-1 nestanoví třídu { $class } pro rozměry { $range }; je stanovena pro rozměry { $defined }
general-range-from = od { $over } do { $to } mm

## Tables made of the standard
make-no-class = není zadána žádná toleranční třída: uveďte jednu nebo více, například H7 H8 JS9
make-both-features = { $hole } a { $shaft } nemohou být v jedné tabulce: liší se jen velikostí písmen; vytvořte jednu tabulku pro díry a jednu pro hřídele
make-last-size = poslední rozměr je { $to } mm: musí být nad 0 a nejvýše 3150 mm

## Press fits
press-no-interference = uložení má vůli nejméně { $clearance } mm: nalisované spojení potřebuje přesah, např. 40 H7/s6
press-length = délka { $length } mm není větší než 0
press-hub-outer = vnější průměr náboje { $given } mm není větší než průměr spoje { $nominal } mm
press-shaft-bore = vrtání hřídele { $given } mm: napište 0 pro plný hřídel, nebo vrtání menší než { $nominal } mm
press-roughness = drsnost { $given } mm je menší než 0
press-friction = nalisované spojení potřebuje tření větší než 0
press-material = modul pružnosti materiálu { $name } není znám: zvolte jiný materiál, nebo přidejte modulus a poisson do souboru vlastních materiálů
press-ratio = { $text } není číslo od 0 do 1 s nejvýše třemi desetinnými místy
press-yields = NENÍ PRUŽNÉ: napětí { $part ->
    [hole] náboje
   *[shaft] hřídele
    } by bylo { $stress } MPa, nad mezí kluzu { $limit } MPa: teorie pružnosti neplatí a neříká se, že něco drží
press-yield-unknown = není známo, zda { $part ->
    [hole] náboj
   *[shaft] hřídel
    } zplastizuje: materiál zde nemá mez kluzu; zadejte ji
press-may-be-loose = díly mohou mít vůli { $clearance } mm: spoj nemusí držet vůbec
press-all-smoothed = vyhlazení drsnosti, { $loss } mm, může spotřebovat přesah: spoj nemusí držet vůbec
press-no-roughness = drsnost Rz nebyla zadána: žádná ztráta přesahu vyhlazením se neodečítá
press-too-hot = ohřát jen náboj nestačí do { $most } °C, kam je jeho roztažnost známa
press-too-cold = ochladit jen hřídel nestačí, ani v kapalném dusíku
press-contraction-unknown = smrštění materiálu hřídele v chladu není známo: použita je jeho roztažnost, hřídel možná musí být chladnější
