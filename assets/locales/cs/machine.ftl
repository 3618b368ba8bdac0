# Running NC programs.

## Paths and files
machine-path-empty = cesta je prázdná
machine-path-too-long = cesta má více než { $most } znaků, což řídicí systém nedovoluje
machine-path-other-root = { $path } není cesta na TNC: ani cesta od složky programu
machine-path-leads-out = { $path } vede ven ze složky
machine-path-no-name = { $name } v { $path } není název souboru ani složky
machine-store-missing = soubor nenalezen: { $path }
machine-store-outside = { $path } vede ven ze zadaných složek
machine-store-no-file = { $path } není soubor
machine-store-too-large = { $path } je větší než { $most } MiB
machine-store-ambiguous = { $path } existuje v několika způsobech psaní, { $names }, řídicí systém má však pro každý název jen jeden soubor: ostatní odstraňte nebo přejmenujte
machine-store-elsewhere = { $path } není ve výstupní složce: program maže soubory jen tam
machine-store-read-only = nebyla zvolena výstupní složka
machine-store-system = { $path }: { $reason }

## Faults
machine-fault-in-block = { $program }, blok { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, řádek { $line }, { $text }: { $fault }
machine-used-blocks = dosažen limit bloků, { $most }: možná nekonečná smyčka
machine-used-label-calls = dosažen limit vnoření volání návěští, { $most }: nevolá program sám sebe?
machine-used-program-calls = dosažen limit vnoření volání programů, { $most }: nevolá program sám sebe?
machine-used-windows = dosažen limit oken: { $most }
machine-used-outputs = dosažen limit výstupů do souborů: { $most }
machine-used-output-files = dosažen limit výstupních souborů: { $most }
machine-used-folders = dosažen limit složek pro výstupní soubory: { $most }
machine-used-table-writes = dosažen limit zápisů změněných tabulek: { $most }
machine-used-output = dosažen limit vytištěných bajtů: { $most }
machine-used-cycles = dosažen limit měření: { $most }
machine-used-path = dosažen limit pohybů: { $most }
machine-used-files = dosažen limit otevřených programů a změněných tabulek: { $most }
machine-used-traffic = dosažen limit přečtených a zapsaných bajtů: { $most }
machine-used-file-bytes = programy a změněné tabulky dohromady překračují { $most } bajtů
machine-text-too-long = text má { $length } znaků, parametr pojme nejvýše { $most }
machine-unknown-block = neznámý blok: Fitcheck provádí jen to, čemu rozumí
machine-unknown-cycle = cyklus { $cycle } Fitcheck neprovádí, i když jej řídicí systém má: provádí { $known }
machine-file-open = { $path } je otevřen jako tabulka FN 26: nelze jej kopírovat, přesunout ani smazat
machine-broken = program je vadný: chybí { $what }
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } není návěští
machine-no-tool-data = { $parameter } není definováno: obsahuje rozměr nástroje ve vřetenu, který udává tabulka nástrojů
machine-undefined = { $parameter } není definováno
machine-lost = { $parameter } není definováno: řádek { $line }, { $text }, je může nastavovat a nebyl proveden
machine-file-unknown = { $path } se nečte: řádek { $line }, { $text }, jej může zapisovat nebo mazat a nebyl proveden
machine-tools-unknown = nástroj se nekoriguje: řádek { $line }, { $text }, může měnit tabulku nástrojů a nebyl proveden
machine-contacts-unknown = není známo, které zaznamenané body dotyku patří k tomuto cyklu: některé mohou patřit k řádku { $line }, { $text }, který nebyl proveden
machine-not-skipped = tento blok rozhoduje, co se provede dál nebo co dostane jiný program: nelze jej přeskočit
machine-whole-only = { $parameter } pojme jen celá čísla, ne { $value }
machine-no-answer = INPUT „{ $question }“ žádá { $parameter }: dejte mu hodnotu před během
machine-no-parameter = parametr { $parameter } neexistuje: Q a QS jdou do 1999, QL a QR do 499
machine-no-variable = proměnná { $variable } neexistuje: { $family } jde od { $least } do { $most }
machine-not-number = { $parameter } obsahuje text: očekává se číslo
machine-not-text = { $parameter } obsahuje číslo: očekává se text
machine-division-by-zero = dělení nulou
machine-negative-root = odmocnina z { $value } není definována
machine-no-result = { $function } { $value } není definováno
machine-beyond-range = { $value } je mimo rozsah hodnot, -10^10 až 10^10
machine-not-whole = { $what } = { $value }: očekává se celé číslo od 0
machine-counted-row = řádek
machine-counted-word = { $word }
machine-behind-text = text má { $length } znaků: pozice { $from } je za jeho koncem
machine-no-number-in-text = { $parameter } = „{ $text }“ není číslo
machine-unknown-system-text = neznámý systémový text ID{ $id } NR{ $number }: podporovány jsou jen datum a čas (ID10321)
machine-no-table = není otevřena žádná tabulka
machine-several-columns = { $parameter } = { $text } uvádí několik sloupců: přes textový parametr lze číst jen jeden
machine-no-column = tabulka { $table } nemá sloupec { $column }; její sloupce jsou { $columns }
machine-no-row = tabulka { $table } nemá řádek { $row }: její řádky jsou 0 až { $last }
machine-no-rows = tabulka { $table } nemá žádné řádky
machine-empty-cell = tabulka { $table }, řádek { $row }, sloupec { $column }: buňka je prázdná
machine-no-number-in-cell = tabulka { $table }, řádek { $row }, sloupec { $column }: { $cell } není číslo
machine-touches = tabulka { $table }, řádek { $row }, sloupec { $column }: buňka navazuje na sousední, její hodnota proto není jistá
machine-table-write = tabulka { $table }: { $error }
machine-mask = maska { $mask }: { $error }
machine-programmed = program se sám zastavil s chybou { $number }
machine-no-cycle-parameter = cyklus { $cycle } nemá parametr { $parameter }
machine-cycle-parameter-twice = cyklus { $cycle }: { $parameter } je uvedeno dvakrát
machine-cycle-parameter-for = cyklus { $cycle }: { $parameter } je uvedeno dvakrát a { $other } vůbec: není druhým míněno { $other }?
machine-global-not-number = GLOBAL DEF { $number }: { $parameter } nemá číslo
machine-global-twice = GLOBAL DEF { $number }: { $parameter } je uvedeno dvakrát
machine-open-subprogram = program končí uvnitř podprogramu volaného na řádku { $line }: chybí LBL 0
machine-repeat-ahead = REP opakuje část mezi návěštím a tímto blokem, návěští je však až za ním, na řádku { $line }
machine-cycle = cyklus { $cycle }: { $error }
machine-workpiece = obrobek: { $error }
machine-no-tool-call = před tímto měřicím cyklem není TOOL CALL s osou nástroje
machine-mode = řídicí systém je v režimu { $mode }: měřicí cykly běží jen v režimu frézování (FUNCTION MODE MILL)
machine-changed = od řádku { $line }, { $text }, je aktivní { $change }: po tu dobu Fitcheck neměří
machine-nothing-selected = před CALL SELECTED PGM není SEL PGM
machine-no-datum-table = vztažný bod by přišel do řádku { $row } aktivní tabulky nulových bodů (Q303 = 0), kterou má jen řídicí systém: zde od něj nelze nic měřit
machine-datum-in-tilt = od řádku { $line }, { $text }, je rovina naklopená: vztažný bod v ní Fitcheck nenastavuje, protože není známo, co v ní řídicí systém zapíše; rovinu před cyklem vraťte (PLANE RESET)
machine-point-without-part = cykly 0 a 1 snímají jediný bod a ideální obrobek žádný nemá: zvolte simulovaný obrobek nebo zaznamenané dotyky
machine-point-from-nowhere = odkud se snímá, není známo ve všech osách: uveďte v bloku X, Y a Z
machine-no-preset = { $table } nemá řádek { $row }
machine-preset-locked = { $table }: řádek { $row } je uzamčen, cyklus do něj nemůže zapsat
machine-shifted-preset = řádek { $row } je aktivní vztažný bod a je aktivní posunutí nulového bodu: co s ním řídicí systém udělá, není známo
machine-change-not-known = neznámý nulový bod
machine-change-turning = natočený systém cyklu 800
machine-change-datum-table = posunutí z tabulky nulových bodů
machine-change-rotation = natočení
machine-change-mirror = zrcadlení
machine-change-scaling = změna měřítka
machine-change-axis-scaling = změna měřítka jednotlivých os
machine-change-tilt = naklopená rovina
machine-change-tilted-shift = posunutí z roviny, která už není naklopená
machine-change-axis-turned = natočení dílu rotační osou, po němž ještě nejsou nové vztažné body obou os roviny,

## Remarks
machine-file-from = { $path }: načteno z { $file }
machine-file-given = { $path }: načteno
machine-file-built-in = { $path }: vestavěný soubor
machine-remark-skipped = neznámý blok přeskočen
machine-remark-cycle-passed-over = tento cyklus kalibruje sondu nebo měří nástroj: byl vynechán. Co vrací, není odtud definováno, pokud to nebylo zadáno před spuštěním (--set Q115=0)
machine-remark-measurement-skipped = toto měření bylo přeskočeno: jeho výsledky odtud nejsou definovány
machine-remark-datum-skipped = toto měření bylo přeskočeno: jeho výsledky odtud nejsou definovány a dál se nic neměří, protože může nastavovat nulový bod
machine-remark-not-followed = tento blok se neprovádí a může změnit nulový bod: dál se nic neměří
machine-remark-no-system-data = { $parameter } odtud není definováno: systémová data FN 18 zná jen řídicí systém
machine-remark-axis-assumed = před tímto cyklem není TOOL CALL: měřeno podél Z s první sondou
machine-remark-measured-again = po opravě přeměřeno: platí toto měření
machine-remark-spindle-turns = vřeteno se otáčí od M{ $function }: řídicí systém by nesnímal
machine-remark-rotary-moved = { $axes } se před tímto cyklem pohnulo: obrobek byl změřen, jako by nebyl otočen
machine-remark-other-preset = vztažný bod { $number }: předpokládá se, že obrobek leží i tam
machine-remark-rotation-ended = základní natočení { $angle } skončilo: tento cyklus měří bez něj, a zůstává vypnuté
machine-remark-axes-as-tilted = rovina je naklopená: má se za to, že rotační osy stojí, jak to vyžaduje
machine-remark-machine-zero-assumed = FN 18 se ptá na místo od nuly stroje: kde leží, zde není známo, a počítá se od nuly obrobku
machine-remark-datum-set = vztažný bod nastaven: jeho nula je nyní v { $zero } mm v souřadnicích obrobku
machine-remark-preset-set = řádek { $row } tabulky vztažných bodů nastaven na { $zero } mm v souřadnicích obrobku: působí s cyklem 247
machine-remark-active-preset-set = řádek { $row } je aktivní vztažný bod: jeho nula je nyní v { $zero } mm v souřadnicích obrobku; na iTNC 530 až po cyklu 247
machine-remark-presets-left = { $path } zůstává beze změny: žádný cyklus 247 předtím neříká, který řádek je aktivní, a není tedy známo, kde obrobek na stroji leží
machine-remark-shift-ended = posunutí nulového bodu končí v { $axes }, aniž tam bylo měřeno, jako na TNC7: iTNC 530 je možná ponechá
machine-remark-built-in = { $path } není mezi zadanými soubory: načten byl vestavěný
machine-remark-other-names = načteno { $read }, existuje však i { $others }: řídicí systém má pro každý název jen jeden soubor
machine-remark-read = { $path }: { $what }
machine-remark-other-spelling = tabulka { $table } nemá sloupec { $column }: použit byl { $other }, druhý způsob psaní v NC-Solution 8255
machine-remark-row-number = tabulka { $table }: NR je v řádku { $row } { $found }: FN 27 a FN 28 počítají řádky od 0
machine-remark-length-converted = tabulka { $table }: sloupec { $column } je LENGTH a byl převeden mezi mm a palci
machine-remark-ended-within = M{ $function } ve volaném programu ukončilo běh: řídicí systém je tam nedovoluje
machine-remark-given-wins = { $parameter } = { $value } bylo zadáno před během a nahrazuje hodnotu tohoto bloku
machine-remark-given-without-effect = { $parameter } bylo zadáno před během a nemělo účinek: žádný blok je nečetl
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = blok vynechává { $parameters }: použity byly tyto hodnoty, řídicí systém však může blok odmítnout
machine-remark-measurement-behind-end = { $count ->
        [one] za tímto blokem je měřicí cyklus
        [few] za tímto blokem jsou { $count } měřicí cykly
       *[other] za tímto blokem je { $count } měřicích cyklů
    }, řídicí systém zde však končí čtení: nic za ním se neměřilo
machine-remark-cycle-skipped = tento měřicí cyklus byl na přání přeskočen kvůli / před ním
machine-remark-rounded = tabulka { $table }, sloupec { $column }: { $value } zaokrouhleno na { $written }
machine-remark-not-judged = zde není výrok: s mezemi se nic neporovnalo
machine-remark-not-written = { $path }: nezapsáno, nebyla zvolena výstupní složka
machine-remark-deleted = { $path } smazal program
machine-remark-not-deleted = { $path } nebyl smazán: nebyla zvolena výstupní složka
machine-remark-other-device = { $given } je jiné zařízení: soubor je { $path }
machine-remark-screen-meant = SCREEN se bere jako název souboru: mělo být SCREEN:?
machine-remark-empty-mask = maska { $mask } je prázdná: i to, co tiskne
machine-remark-not-saved = { $path }: nezapsáno: { $reason }
machine-remark-full = { $path }: dosažen limit { $kilobytes } kilobajtů, nic se nepřidalo
machine-remark-table-written = { $path }: zapsáno
machine-remark-contacts-left = cykly použily { $used } z { $count } zaznamenaných bodů dotyku
machine-remark-more = dalších nevypsaných poznámek: { $count }
machine-remark-empty-spindle = byl vyvolán nástroj 0: TNC7 pak nemá ve vřetenu sondu
machine-remark-no-tool-named = žádný TOOL CALL před tímto cyklem neuvádí nástroj: měřeno s první sondou
machine-remark-tool-call-words = TOOL CALL nepřijímá { $words }: přeskočeno
machine-remark-no-nominal = cyklus nemá jmenovitý rozměr: sonda narazí na dokonalý obrobek v polovině K
machine-remark-other-probe = nástroj { $tool } není v tabulce dotykových sond: použita byla sonda { $probe }
machine-remark-collision = možná kolize: { $mover } a { $feature }, se středem kuličky na X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = pohyby se neprověřují úplně vůči { $features }
machine-remark-stylus-unchecked = kolize snímacího hrotu se neprověřují: nestojí podél Z
machine-remark-tool-offsets = { $offsets } v TOOL CALL simulovanou sondu nemění
machine-remark-tool-locked = nástroj { $tool } je v tabulce nástrojů zablokován
machine-remark-no-probe-tool = nástroj { $tool } není dotyková sonda: TYP = { $kind }, očekává se { $probe }
machine-remark-no-such-tool = nástroj { $tool } není v tabulce nástrojů
machine-remark-same-name = { $more ->
    [one] název { $tool } má ještě jeden nástroj
    [few] název { $tool } mají ještě { $more } nástroje
   *[other] název { $tool } má ještě { $more } nástrojů
}: použit byl první v tabulce nástrojů
machine-remark-content-uncertain = { $parameter } se zde čte, ale není doloženo, že obsahuje průměr
machine-remark-not-waited = { $parameter } se čte bez G909 za cyklem: řídicí systém čte bloky napřed a ještě nemusel změřit
machine-remark-position-unknown = poloha před cyklem není známa: bez D začíná ve jmenovitém středu, bez WB ve výšce 0

machine-passed-over = { $count } { $count ->
        [one] blok
        [few] bloky
       *[other] bloků
    } bez vlivu na měření { $count ->
        [one] neproveden
        [few] neprovedeny
       *[other] neprovedeno
    }: { $list }

## Pauses
machine-pause-stop = program se zastavil: STOP nebo M0
machine-pause-optional-stop = program se zastavil: M1
machine-pause-breakpoint = na dalším bloku je zarážka
machine-pause-log = měřicí protokol je na obrazovce (Q281 = 2)

## A block of a measuring cycle without its program
alone-moved = { $text } posouvá následující cyklus snímání nebo mění jeho osy, cyklus se však provádí, jako by tomu tak nebylo: spusťte místo toho celý program
alone-called = { $text } provádí bloky, které mohou následující cyklus snímání posunout, ale nečtou se: spusťte místo toho celý program
alone-not-understood = { $text } je nesrozumitelné a může následující cyklus snímání posunout: ověřte program, nebo jej spusťte celý
alone-not-run = program nepokračuje za { $text } a k následujícímu cyklu snímání nedojde, řídicí systém zde tedy neměří: ověřte program
alone-passed = { $text } může cyklus snímání obejít, řídicí systém zde tedy měřit nemusí: spusťte místo toho celý program
alone-skipped = řídicí systém může cyklus snímání kvůli / před ním přeskočit: má-li se měřit, / smažte
