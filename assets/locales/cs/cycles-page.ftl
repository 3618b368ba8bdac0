# The cycles page: the form of a measuring cycle, its workpiece, its path and its results.

page-cycles = Cykly

cycles-cycle = Cyklus
cycles-choose = Cyklus { $number } { $name }
cycles-group-position = Poloha
cycles-group-probing = Snímání
cycles-group-tolerance = Tolerance
cycles-group-output = Výstup
cycles-optional-position = Poloha, volitelné
cycles-optional-probing = Snímání, volitelné
cycles-optional-tolerance = Tolerance, volitelné
cycles-optional-output = Výstup, volitelné
cycles-contacts-from = Zdroj bodů dotyku
cycles-perfect = Dokonalý díl
cycles-simulated = Simulované
cycles-recorded = Zaznamenané
cycles-workpiece = Obrobek…
cycles-suit = Přizpůsobit obrobek cyklu
cycles-open-contacts = Body dotyku…
cycles-no-file = zatím žádný soubor
cycles-contacts-of = { $count ->
    [one] { $count } bod dotyku
    [few] { $count } body dotyku
   *[other] { $count } bodů dotyku
    }, { $file }
cycles-probe = Sonda
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Vlastní tabulka sond…
cycles-shipped-probes = Vestavěná tabulka
cycles-run = Spustit
cycles-needed = povinné
cycles-none = žádné
cycles-predef = PREDEF znamená
cycles-predef-missing = PREDEF: zadejte hodnotu, kterou dává GLOBAL DEF
cycles-without-effect = Přijato bez účinku
cycles-position = Poloha kuličky
cycles-ball-stands = Kulička stojí na
cycles-paste-block = Vložit NC blok…
cycles-copy-block = Kopírovat jako NC blok
cycles-copy-results = Kopírovat výsledky
cycles-block-copied = NC blok byl zkopírován
cycles-block = NC blok
cycles-block-hint = Vložte blok jako TCH PROBE 427 … Q263=+35 ;TEXT ~ nebo G785 R0 BR0 K2: nahradí formulář
cycles-fill = Vyplnit formulář

cycles-nothing-seen = Dráha a body dotyku se zobrazí po spuštění: stiskněte Enter nebo F5
cycles-allowed = Dovoleno: { $range } { $unit }
cycles-must-be-given = Povinné
cycles-may-be-left-out = Volitelné
cycles-default = { $value }, je-li prázdné
cycles-may-be-predef = PREDEF je dovoleno
cycles-path = Dráha kuličky
cycles-first = První
cycles-back = Zpět
cycles-next = Další
cycles-last = Poslední
cycles-move = Pohyb
cycles-phase-pre-position = předpolohování
cycles-phase-approach = najetí
cycles-phase-contact = dotyk
cycles-phase-retract = odjetí
cycles-phase-leave = opuštění
cycles-move-contact = { $number } z { $count }: { $phase } { $touch }, na { $to }
cycles-move-of-touch = { $number } z { $count }: { $phase }, bod dotyku { $touch }, z { $from } na { $to }
cycles-move-of-none = { $number } z { $count }: { $phase }, z { $from } na { $to }
cycles-criteria = Porovnání kritérií

cycles-word-stopped = Nezměřeno
cycles-word-no-verdict = Bez výroku
cycles-no-limits = nebyly zadány žádné meze
cycles-no-limits-marked = nebyly zadány žádné meze; řídicí systém pak hlásí „v toleranci“
cycles-more-out = { $what }, další níže: { $count }
cycles-no-window = Bez mezních rozměrů: řídicí systém nezobrazí stavové okno
cycles-results = Parametry výsledku
cycles-log-file = Řídicí systém zapíše { $name }
cycles-log-screen = Řídicí systém se zastaví a zobrazí protokol na obrazovce
cycles-log-shown = Řídicí systém zobrazí výsledek na obrazovce
cycles-save-log = Uložit protokol…
cycles-dialog-save-log = Uložit měřicí protokol
cycles-no-log = není protokol k uložení
cycles-from-perfect = Měřeno na dokonalém obrobku se jmenovitým rozměrem, sonda jako bod
cycles-from-simulated = Měřeno na simulovaném obrobku, počáteční číslo { $seed }
cycles-from-recorded = Body dotyku z { $file }
cycles-unused = Cyklus nepoužil ze souboru { $count ->
    [one] jeden bod dotyku
    [few] { $count } body dotyku
   *[other] { $count } bodů dotyku
    }

cycles-fields-wrong = { $count ->
    [one] jedno pole nelze použít
    [few] { $count } pole nelze použít
   *[other] { $count } polí nelze použít
    }: viz formulář
cycles-no-workpiece = simulovaný obrobek není úplný
cycles-workpiece-wrong = simulovaný obrobek: { $problem }
cycles-workpiece-field = { $name }: { $problem }
cycles-no-contacts = zatím není otevřen žádný soubor s body dotyku
cycles-cannot-suit = Zatím se nehodí žádný obrobek: { $problem }
cycles-not-written = obrobek nelze zapsat: { $reason }
cycles-contacts-loaded = Používají se body dotyku ze souboru { $name }
cycles-column-ignored = sloupec { $column } je přeskočen
cycles-probes-loaded = Používá se tabulka sond { $name }
cycles-dialog-contacts = Otevřít zaznamenané body dotyku
cycles-dialog-workpiece = Otevřít simulovaný obrobek
cycles-dialog-probes = Otevřít tabulku sond
cycles-dialog-save-workpiece = Uložit simulovaný obrobek

cycles-open-workpiece = Otevřít…
cycles-save-workpiece = Uložit…
cycles-shape-bore = Díra
cycles-shape-stud = Hřídel
cycles-shape-face = Plocha
cycles-shape-point = Bod volné plochy
cycles-shape-slot = Drážka
cycles-shape-ridge = Výstupek
cycles-shape-pocket = Kapsa
cycles-shape-boss = Obdélníkový čep
cycles-plane = Rovina
workpiece-probe = Sonda
workpiece-machine = Rozptýlení a teplota
workpiece-centre-1 = Střed, 1. osa
workpiece-centre-2 = Střed, 2. osa
workpiece-ovality-angle = Úhel ovality
workpiece-lobe-angle = Úhel laloků
workpiece-point-x = Bod X
workpiece-point-y = Bod Y
workpiece-point-z = Bod Z
workpiece-normal-x = Normála X
workpiece-normal-y = Normála Y
workpiece-normal-z = Normála Z
workpiece-wave-height = Amplituda vlny
workpiece-wave-length = Délka vlny
workpiece-wave-x = Směr vlny X
workpiece-wave-y = Směr vlny Y
workpiece-wave-z = Směr vlny Z
workpiece-deviation = Úchylka ve směru normály
workpiece-radius = Poloměr plochy
workpiece-width = Šířka
workpiece-length-1 = 1. délka
workpiece-length-2 = 2. délka
workpiece-angle = Úhel stěn
workpiece-ball = Poloměr kuličky
workpiece-trigger = Rozptýlení sepnutí 1σ
workpiece-calibration = Chyba kalibrace
workpiece-offset-x = Přesazení kuličky X
workpiece-offset-y = Přesazení kuličky Y
workpiece-lobing-count = Laloky předběhu
workpiece-lobing = Amplituda předběhu
workpiece-lobing-angle = Úhel předběhu
workpiece-temperature = Teplota obrobku
workpiece-expansion = Roztažnost

cycles-choice-move-to-clearance-0 = ve výšce měření
cycles-choice-move-to-clearance-1 = v bezpečné výšce
cycles-choice-clearance-mode-minus-1 = nikdy v bezpečné výšce
cycles-choice-clearance-mode-0 = před cyklem a po něm
cycles-choice-clearance-mode-1 = před každým objektem a po něm
cycles-choice-clearance-mode-2 = u každého bodu dotyku
cycles-choice-traverse-0 = po přímce
cycles-choice-traverse-1 = po oblouku
cycles-choice-contact-count-3 = body dotyku
cycles-choice-contact-count-4 = body dotyku
cycles-choice-contact-count-5 = bodů dotyku
cycles-choice-contact-count-6 = bodů dotyku
cycles-choice-contact-count-7 = bodů dotyku
cycles-choice-contact-count-8 = bodů dotyku
cycles-choice-contact-count-9 = bodů dotyku
cycles-choice-log-0 = bez protokolu
cycles-choice-log-1 = protokol do souboru
cycles-choice-log-2 = zastavit, protokol na obrazovku
cycles-choice-stop-0 = nezastavovat
cycles-choice-stop-1 = zastavit mimo toleranci
cycles-choice-stop-on-undersize-0 = nezastavovat
cycles-choice-stop-on-undersize-1 = zastavit mimo toleranci
cycles-choice-stop-on-undersize-2 = zastavit jen pod rozměrem
cycles-choice-stop-on-scrap-0 = nezastavovat
cycles-choice-stop-on-scrap-1 = zastavit mimo toleranci
cycles-choice-stop-on-scrap-2 = zastavit jen při zmetku
cycles-choice-measured-axis-1 = hlavní osa X
cycles-choice-measured-axis-2 = vedlejší osa Y
cycles-choice-measured-axis-3 = osa sondy Z
cycles-choice-axis-of-plane-1 = hlavní osa X
cycles-choice-axis-of-plane-2 = vedlejší osa Y
cycles-choice-direction-minus-1 = záporný směr
cycles-choice-direction-1 = kladný směr
cycles-choice-directed-axis-minus-3 = osa sondy Z, záporný směr
cycles-choice-directed-axis-minus-2 = vedlejší osa Y, záporný směr
cycles-choice-directed-axis-minus-1 = hlavní osa X, záporný směr
cycles-choice-directed-axis-1 = hlavní osa X, kladný směr
cycles-choice-directed-axis-2 = vedlejší osa Y, kladný směr
cycles-choice-directed-axis-3 = osa sondy Z, kladný směr
cycles-choice-tool-axis-probing-0 = zůstává
cycles-choice-tool-axis-probing-1 = snímá se a nastaví
cycles-choice-transfer-minus-1 = neuvedeno
cycles-choice-transfer-0 = tabulka nulových bodů
cycles-choice-transfer-1 = tabulka vztažných bodů
cycles-choice-preset-correction-0 = beze změny
cycles-choice-preset-correction-1 = opraven podle bodu
cycles-choice-preset-correction-2 = opraven podle 2. bodu
cycles-choice-preset-correction-3 = opraven podle středu obou
cycles-choice-compensation-axis-0 = osa měřeného úhlu
cycles-choice-compensation-axis-4 = osa A
cycles-choice-compensation-axis-5 = osa B
cycles-choice-compensation-axis-6 = osa C
cycles-choice-zero-after-alignment-0 = ponechá svou hodnotu
cycles-choice-zero-after-alignment-1 = ukazuje nulu
cycles-choice-rotary-alignment-0 = zůstanou stát
cycles-choice-rotary-alignment-1 = otočí se, sonda jde s nimi
cycles-choice-rotary-alignment-2 = otočí se samy
cycles-choice-rotation-transfer-0 = nemění nic
cycles-choice-rotation-transfer-1 = základní natočení
cycles-choice-rotation-transfer-2 = posunutí rotační osy
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = uvnitř
cycles-choice-side-1 = vně
cycles-choice-geometries-0 = dvě díry
cycles-choice-geometries-1 = dva čepy
cycles-choice-geometries-2 = díra a čep
cycles-choice-geometries-3 = čep a díra

## The tool table

tools = Tabulka nástrojů
tools-none = žádná
tools-open-one = { $name }, { $count ->
    [one] jeden nástroj
    [few] { $count } nástroje
   *[other] { $count } nástrojů
  }
tools-open = Otevřít tabulku nástrojů…
tools-close = Bez tabulky nástrojů
tools-save = Uložit tabulku nástrojů…
tools-save-hint = Tabulka s těmito změnami. Další běh začíná tabulkou v podobě, v jaké byla otevřena.
tools-dialog-open = Otevřít tabulku nástrojů
tools-dialog-save = Uložit změněnou tabulku nástrojů
tools-loaded = Používá se tabulka nástrojů { $name }
tools-pick = vybrat nástroj
tools-pick-of = { $parameter } z tabulky nástrojů
tools-input = { $parameter } Nástroj ke sledování (Q330)
tools-fixed = Q330 = { $tool } v programu
tools-more = { $count ->
    [one] další jeden nástroj
    [few] další { $count } nástroje
   *[other] dalších { $count } nástrojů
  }
tools-row = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, zablokován
tools-without-name = { $count ->
    [one] jeden nástroj není v seznamu: jeho název jej jednoznačně neurčuje
    [few] { $count } nástroje nejsou v seznamu: jejich názvy je jednoznačně neurčují
   *[other] { $count } nástrojů není v seznamu: jejich názvy je jednoznačně neurčují
  }
tools-not-in-table = Q330 = { $tool }: tabulka nástrojů takový nástroj nemá
tools-not-monitored = Bez tabulky nástrojů se žádný nástroj nesleduje (Q330)
tools-none-named = Q330 neuvádí žádný nástroj: tabulka nástrojů se nepoužije
tools-no-deviation = naměřená hodnota se neodchyluje: nástroj se nemění
tools-changed = Změněno v tabulce nástrojů
tools-nothing-changed = žádný běh nezměnil tabulku nástrojů

## A part of several features

cycles-part-refused = soubor má tabulky [[feature]]: samostatný cyklus měří jednu plochu; takový díl měří stránka Programy a fitcheck run
part-features = Prvky dílu
part-of-features = { $name }, { $count ->
    [one] jeden prvek
    [few] { $count } prvky
   *[other] { $count } prvků
  }, poloměr kuličky { $ball } mm
part-round = { $name }: { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name }: { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name }: { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name }: { $kind } X { $x } Y { $y } Z { $z }
