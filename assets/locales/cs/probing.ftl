# probing

# Where a measurement comes from, and what it cannot tell.
origin-simulated = simulováno, cyklus { $cycle }, počáteční číslo { $seed }
origin-contacts = body dotyku z { $file }
origin-imported = importováno z { $file }
origin-imported-simulation = importováno z { $file }, simulováno
origin-typed = zadáno
caveat-only-a-diameter = jen jeden průměr: tvar a poloha nejsou známy
caveat-only-a-circle = jen průměr a střed: tvar není znám
caveat-three-contacts = 3 body dotyku: tvar nelze měřit
caveat-four-contacts = 4 body dotyku: kromě ovality se žádná úchylka tvaru nezjistí
caveat-few-contacts = body dotyku: { $contacts }; úchylka tvaru mezi nimi se nezjistí
caveat-short-arc = body dotyku pokrývají jen { $arc }°: rozptýlení se v průměru a středu zvětšuje
caveat-two-point = průměr přes body dotyku { $one } a { $other } je { $size } mm, za mezí { $limit } mm, kterou střední kružnice nepřekračuje: rozměr standardně platí mezi kterýmikoli dvěma protilehlými body
caveat-form = poloměry bodů dotyku se liší o { $form } mm, průměry přes ně se tedy mohou lišit o více než toleranční pole { $zone } mm: dva protilehlé body mohou ležet mimo meze
caveat-heights = výšky bodů dotyku se liší o { $spread } mm: u kužele nebo šikmé osy to mění průměr
caveat-stated = rozměr uvádí za tolerancí { $upper } a { $lower } µm, tolerance má { $used-upper } a { $used-lower } µm: použita byla tolerance; ověřte, co výkres myslí
caveat-count = rozměr platí pro { $count } prvků: tato hodnota patří jednomu
caveat-form-class = třída { $class } podle ISO 2768-2 platí pro tvar a polohu: rozměr je neukazuje
caveat-each-two-point = { $modifier } vyžaduje každý dvoubodový rozměr v mezích: toto je jen jeden průměr
caveat-mean-of-two-points = { $modifier } vyžaduje každý dvoubodový rozměr v mezích: průměr metodou nejmenších čtverců je jen jejich střed
caveat-not-least-squares = { $modifier } znamená rozměr metodou nejmenších čtverců: jeden průměr ho neukazuje
caveat-one-section = { $modifier } znamená rozměr metodou nejmenších čtverců celého prvku: toto je rozměr jednoho řezu
caveat-envelope = { $modifier } vyžaduje obálku dokonalého tvaru při rozměru maxima materiálu: jeden průměr neukazuje, zda ji povrch překračuje; použijte kalibr
caveat-other-size = { $modifier } znamená jiný rozměr než změřený: dvoubodový průměr ani průměr nejmenších čtverců ho neprokazuje
caveat-condition = { $modifier } říká, kde nebo jak rozměr platí: naměřená hodnota neukazuje, zda je to splněno
contact-beyond-travel = bod dotyku { $number } leží { $distance } mm od začátku svého snímání a kulička ujede nejvýše { $allowed } mm (DIST nebo K, plus SET_UP z tabulky dotykových sond a Q320): ověřte, že body dotyku patří k tomuto prvku, v tomto pořadí a od tohoto nulového bodu
contact-missed = bod dotyku { $number }: sonda na dráze snímání na nic nenarazila
contact-no-height = bod dotyku { $number } nemá výšku: doplňte do souboru sloupec z
contact-used-up = bod dotyku { $number }: soubor má jen { $available ->
    [one] { $available } bod dotyku
    [few] { $available } body dotyku
   *[other] { $available } bodů dotyku
    }

cycle-out-of-range = { $key } { $name } = { $given }: { $allowed }
cycle-length-range = nejméně { $least } mm, nejvýše { $most } mm
cycle-angle-range = nejvýše { $most } v obou směrech
cycle-angle-size-range = velikost nejméně { $smallest }, nejvýše { $most }
cycle-one-of = očekává se jedno z { $allowed }
cycle-tool-range = číslo nástroje od 0 do 99999.9, nebo název nástroje s nejvýše 255 znaky
cycle-not-a-value = { $key } { $name }: { $error }
cycle-tool-no-name = { $text } nevyvolává žádný nástroj: pište jeho číslo nebo název
cycle-tool-empty = není uveden žádný nástroj: pro žádný napište Q330=0
cycle-tool-unquoted = { $text } není číslo a název nástroje potřebuje uvozovky
cycle-no-diameter = { $key } { $name } = 0 mm: kružnice potřebuje průměr nad 0
cycle-one-limit = { $given } je uvedeno bez { $missing }: druhou mezí by byla 0
cycle-missing = chybí { $key } { $name }
cycle-no-such-parameter = cyklus { $cycle } nemá parametr { $parameter }: jeho parametry jsou { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm je nad { $maximum-key } = { $maximum } mm: minimální rozměr je nad maximálním
cycle-too-large = naměřená kružnice je příliš velká: { $error }
workpiece-cannot-be = { $what } = { $given }: nejméně { $least }, nejvýše { $most }

# Touches.
contact-in-material = bod dotyku { $number }: dráha snímání začíná uvnitř materiálu
contact-in-feature = bod dotyku { $number }: dráha snímání začíná uvnitř materiálu prvku { $feature }
contact-behind = bod dotyku { $number }: kulička se ke stěně prvku { $feature } dostává zezadu a tloušťka materiálu tam není známa
contact-ambiguous = bod dotyku { $number }: kulička narazí na { $feature } a { $other } ve stejném místě, není tedy známo, co se měří

# Circle evaluation.
circle-too-few = kružnice potřebuje nejméně 3 body dotyku, nalezeno { $contacts }
circle-coinciding = body dotyku { $first } a { $second } splývají na x = { $x }, y = { $y }: kružnice potřebuje 3 různé body
circle-collinear = všechny body dotyku ({ $contacts }) leží na jedné přímce: kružnice jimi neprochází
circle-straight = body dotyku ({ $contacts }) odpovídají přímce lépe než kterékoli kružnici
circle-not-finite = bod dotyku { $contact }: { $axis } = { $value } není konečné číslo
circle-too-large = { $what } = { $value } mm je příliš velké: nejvýše { $most } mm v obou směrech
circle-part-contact = bod dotyku { $contact }: { $axis }
circle-part-diameter = průměr
circle-part-centre = střed { $axis }
circle-three-contacts = 3 body dotyku: tvar nelze měřit, zbytková úchylka je vždy nula
circle-four-contacts = 4 body dotyku: čtyři laloky se nezjistí a mění průměr
circle-short-arc = body dotyku pokrývají jen { $arc }° oblouku: rozptýlení průměru je { $factor }krát větší než u 3 bodů po 120°
circle-circumscribed-of-short-arc = nejmenší opsaná kružnice krátkého oblouku není rozměrem prvku
circle-counts-twice = body dotyku { $first } a { $second } splývají: toto místo se počítá dvakrát
circle-no-inscribed = největší vepsaná kružnice není: body dotyku žádnou neobklopují
circle-no-zone = minimální zóna není: přímý pás je užší než kterýkoli prstenec
circle-too-many-contacts = největší vepsaná kružnice a minimální zóna se pro { $contacts } bodů dotyku nepočítají: nejvýše { $most }
circle-short-chord = body dotyku { $first } a { $second } jsou proti sobě, ale mimo střed: tento rozměr je o { $short } µm menší
circle-more-of-a-kind = totéž platí pro dalších { $more }
circle-apart = bod dotyku { $contact } leží { $apart } mm mimo kružnici, mnohem dál než ostatní: prach nebo chybné sepnutí?
circle-heights = výšky bodů dotyku se liší o { $spread } mm: u kužele nebo šikmé osy to mění průměr

## Measuring cycles: errors, results, remarks
contact-out-of-reach = bod dotyku { $number }: sonda v rámci dráhy snímání { $longest } mm na nic nenarazila
cycle-number-range = číslo, nejvýše { $most } v obou směrech
cycle-count-range = celé číslo od 0 do { $most }
cycle-band-range = tolerance, například 0.4-0.1, 0.4 nebo -0.1; 0 znamená bez tolerance
cycle-range = { $range }
cycle-range-tool = 0 … { $highest }, nebo nejvýše { $longest } znaků
cycle-range-band = 0.4-0.1, 0.4, -0.1 nebo nic
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = bez tolerance
cycle-no-global = { $key } { $name } = PREDEF: žádné GLOBAL DEF neudává hodnotu
cycle-no-path = { $key } { $name } = 0 mm: dráha snímání potřebuje délku; její znaménko udává směr
cycle-no-transfer = { $row-key } = { $row } při { $key } = -1: není uvedeno, ve které tabulce ten řádek je; { $key } musí být 0 nebo 1 (řídicí systém hlásí chybu 1078)
cycle-other-feature = { $key } { $name } = { $given }: třída neodpovídá { $geometry }: velká písmena platí pro díru, malá pro čep
cycle-not-measured = { $key } { $name } = { $given }: cyklus tuto hodnotu neměří: zapište ji bez tolerance
cycle-inch-tolerance = { $key } { $name } = { $given }: v programu v palcích není jednotka tolerance známa: napište program v mm, nebo číslo bez tolerance
cycle-no-edge = { $first } a { $second } jsou stejné: hrana potřebuje dva body podél sebe
cycle-no-sphere = body dotyku neurčují kouli
cycle-no-rotation = { $key } { $name }: Fitcheck sleduje jen základní natočení (Q1121 = 1), a to bez korekce (Q1120 = 0)
cycle-no-normal = { $first }, { $second } a { $third } jsou všechny 0: normála potřebuje směr
cycle-apart = bod dotyku { $contact }: jeho dvě snímání leží { $difference } mm od sebe, { $key } dovoluje { $most } mm
cycle-too-far = naměřená souřadnice je příliš velká: { $error }
cycle-stop = zastavení programu podle Q309 = { $setting }: { $out }
check-within = { $what } { $measured } mm je mezi { $minimum } a { $maximum } mm
check-above = { $what } { $measured } mm je nad maximem { $maximum } mm: { $status }
check-below = { $what } { $measured } mm je pod minimem { $minimum } mm: { $status }
check-and = { $one }; { $other }
found-centre-1 = naměřený střed, 1. osa
found-centre-2 = naměřený střed, 2. osa
found-centre-3 = naměřený střed, 3. osa
found-diameter = naměřený průměr
found-centre-deviation-1 = úchylka středu, 1. osa
found-centre-deviation-2 = úchylka středu, 2. osa
found-centre-deviation-3 = úchylka středu, 3. osa
found-diameter-deviation = úchylka průměru
found-coordinate = naměřená souřadnice
found-coordinate-deviation = úchylka souřadnice
found-position-1 = naměřená poloha, 1. osa
found-position-2 = naměřená poloha, 2. osa
found-position-3 = naměřená poloha, 3. osa
found-angle = naměřený úhel
found-deviation-1 = úchylka, 1. osa
found-deviation-2 = úchylka, 2. osa
found-deviation-3 = úchylka, 3. osa
found-deviation-along = úchylka ve směru normály
found-second-position-1 = 2. bod: naměřená poloha, 1. osa
found-second-position-2 = 2. bod: naměřená poloha, 2. osa
found-second-position-3 = 2. bod: naměřená poloha, 3. osa
found-second-deviation-1 = 2. bod: úchylka, 1. osa
found-second-deviation-2 = 2. bod: úchylka, 2. osa
found-second-deviation-3 = 2. bod: úchylka, 3. osa
found-second-diameter = 2. kružnice: naměřený průměr
found-second-diameter-deviation = 2. kružnice: úchylka průměru
found-rotation = naměřené natočení
found-side-1 = naměřená délka, 1. strana
found-side-2 = naměřená délka, 2. strana
found-width = naměřená šířka
found-centre-line = poloha středové osy
found-side-deviation-1 = úchylka 1. strany
found-side-deviation-2 = úchylka 2. strany
found-width-deviation = úchylka šířky
found-good = v toleranci
found-rework = oprava
found-scrap = zmetek
found-status = stav: -1 nedefinováno, 0 dobrý, 1 oprava, 2 zmetek
cycle-note-machine-builder = tento cyklus musí povolit a přizpůsobit výrobce stroje: viz příručka ke stroji
cycle-note-not-on-itnc530 = iTNC 530 tento cyklus nemá; mají jej TNC 320, TNC 620, TNC 640 a TNC7
cycle-note-normal-from-cad = normálu převezměte ze systému CAD nebo CAM
cycle-note-software-option = řídicí systém potřebuje volitelný software { $option }
cycle-note-recommended = má-li řídicí systém cyklus { $cycle }, HEIDENHAIN doporučuje použít jej
cycle-note-ends-rotation = ukončí aktivní základní natočení
remark-without-effect = { $key } se přijímá, ale nemá účinek
remark-tool-not-monitored = Q330 = { $tool }: nástroj se nesleduje: chybí tabulka nástrojů
remark-outside-dimension = předpokládá se vnější rozměr: nad maximem oprava, pod minimem zmetek
remark-nominal-outside-limits = jmenovitý průměr { $nominal } mm není mezi mezemi: TNC7 to odmítá
remark-nominal-width-outside-limits = jmenovitá šířka { $nominal } mm není mezi mezemi: TNC7 to odmítá
remark-nominal-coordinate-outside-limits = jmenovitá souřadnice { $nominal } mm není mezi mezemi: podle příručky to TNC7 může odmítnout
remark-contact-astray = { $count ->
    [one] bod dotyku { $contact } leží { $distance } mm od místa, kde cyklus snímá: možná patří k jinému prvku
    [few] { $count } body dotyku leží mimo místa, kde cyklus snímá, bod { $contact } o { $distance } mm: možná patří k jinému prvku
   *[other] { $count } bodů dotyku leží mimo místa, kde cyklus snímá, bod { $contact } o { $distance } mm: možná patří k jinému prvku
}
remark-deviation-without-parameter = úchylka zde nemá parametr: podle příručky ji řídicí systém ukládá, ale neuvádí kam
remark-new-datum = nový vztažný bod, { $target }: { $axes } mm (naměřeno → žádáno)
datum-target-display = ihned aktivní
datum-target-active = korekce aktivního vztažného bodu
datum-target-preset = řádek { $row } tabulky vztažných bodů
datum-target-table = řádek { $row } tabulky nulových bodů
remark-new-rotation = nové základní natočení { $angle }: { $target }
remark-axis-turned = osa { $axis } natočí díl o { $angle }: kde leží její střed, ví jen stroj, a nulu osy Fitcheck nikam nezapisuje
remark-variable-holds-diameter = #i99 se čte jako průměr: příručka neuvádí, kterou hodnotu obsahuje
remark-no-tolerance = { $key } není tolerance: nic se neposuzuje

## The simulated machine
workpiece-file-toml = řádek { $line }: { $said }
workpiece-file-too-large = soubor obrobku má nejvýše { $most } KiB
workpiece-file-not-one = z tabulek { $tables } má soubor { $found }: musí mít právě jednu
workpiece-file-cannot-be = řádek { $line }: { $error }
workpiece-file-several = soubor má tabulky [[feature]]: zde se očekává jeden obrobek s jedinou plochou
workpiece-file-too-many = díl má nejvýše { $most } prvků
workpiece-file-feature = řádek { $line }, sloupec { $column }: { $feature }: { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } není druh prvku: druhy jsou { $known }
feature-fault-no-key = { $kind } potřebuje { $key }
feature-fault-other-key = { $kind } nemá { $key }
feature-fault-name = název má 1 až { $most } znaků na jednom řádku
feature-fault-same-name = stejný název má jiný prvek

# Figures of the simulated workpiece, as errors name them.
figure-temperature = teplota
figure-expansion = roztažnost
figure-probe-scatter = rozptýlení sondy
figure-ball-radius = poloměr kuličky
figure-calibration-error = chyba kalibrace
figure-offset = přesazení
figure-lobing = amplituda předběhu
figure-lobing-angle = úhel předběhu
figure-lobing-count = laloky předběhu
figure-centre-x = střed x
figure-centre-y = střed y
figure-diameter = průměr
figure-surface-scatter = rozptýlení povrchu
figure-ovality = ovalita
figure-ovality-angle = úhel ovality
figure-ovality-count = počet ovality
figure-lobe-height = výška laloků
figure-lobe-angle = úhel laloků
figure-lobes = laloky
figure-point = bod
figure-normal = normála
figure-normal-length = délka normály
figure-wave-length = délka vlny
figure-wave-amplitude = amplituda vlny
figure-wave-direction = směr vlny
figure-deviation = úchylka
figure-radius = poloměr
figure-width = šířka
figure-first-length = 1. délka
figure-second-length = 2. délka
figure-angle = úhel
figure-top = horní konec
figure-bottom = dolní konec
figure-length = délka stěn
figure-reach = dosah
figure-stylus-radius = poloměr snímacího hrotu

## What of the probe touches.
mover-ball = kulička
mover-stylus = snímací hrot
