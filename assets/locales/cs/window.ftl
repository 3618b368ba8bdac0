# The window: labels, buttons, headings. Sentence case, no colon after a label, an ellipsis on what opens a dialog.

page-check = Kontrola
page-fit = Uložení
page-tables = Tabulky
import = Importovat…
export = Exportovat
export-people = Zpráva o kontrole ({ $format })…
export-programs = Historie jako { $format }…
export-status-check = Stavové okno kontroly jako text…
export-status-cycle = Stavové okno cyklu { $cycle } jako text…
export-status-program = Okno programu jako text…
menu = Nabídka
language = Jazyk
theme = Vzhled
theme-system = Podle systému
theme-light = Světlý
theme-dark = Tmavý
theme-contrast = Vysoký kontrast na bílé
theme-inverted = Vysoký kontrast na černé
density = Velikost ovládacích prvků
density-by-use = Automaticky
density-mouse = Myš
density-touch = Dotyk
limits-from = Zdroj mezí
standard-js-rounded = Poloviny mikrometru u JS zaokrouhlit dolů, jako v roce 1988
standard-1988 = cd, ef a fg jen do 10 mm, jako v roce 1988
load-tables = Vlastní tabulky…
no-own-tables = Nepoužívat vlastní tabulky
load-mask = Vlastní maska…
undo = Zpět
undo-what = Zpět: { $what }
undo-add = { $count ->
    [one] přidání 1 kontroly
   *[other] přidání { $count } kontrol
}
undo-correct = korekce
undo-feature = díra nebo hřídel
undo-clear = vymazání historie
undone = Vráceno zpět: { $what }
clear-history = Vymazat historii
choose-bad = { $count ->
    [0] Vybrat kontroly kromě dobrých
    [one] Vybrat 1 kontrolu, která není dobrá
    [few] Vybrat { $count } kontroly, které nejsou dobré
   *[other] Vybrat { $count } kontrol, které nejsou dobré
}
choose-none = Zrušit výběr

callout = Předpis
callout-hint = Zadejte jmenovitý rozměr a třídu, například 25 H7
feature-hole = Díra
feature-shaft = Hřídel
feature-neither = Ani jedno
nominal-is = jmenovitý rozměr { $nominal } mm
maximum = Maximum
minimum = Minimum
from-source = zdroj: { $source }
source-overrides = Vlastní tabulka: ISO 286 má { $upper } / { $lower } µm, rozdíl je tedy { $by-upper } / { $by-lower } µm
measured-value = Naměřená hodnota
measured-once = Už posouzeno. Chcete-li stejnou hodnotu posoudit znovu, zadejte ji znovu nebo použijte tlačítko
by-typing = Zadat
by-simulating = Simulovat
judge = Posoudit
measure = Měřit
clear = Vymazat
nominal-size = Jmenovitý rozměr
tolerance-class = Třída
class-none = Vybrat
classes-hole = Třídy pro díry
classes-shaft = Třídy pro hřídele
part-section = Díl
part-name = Díl nebo prvek

probe-position = Poloha sondy
centre-x = Střed X
centre-y = Střed Y
height-z = Výška Z
first-contact = První bod dotyku
clearance = Bezpečná vzdálenost
centre-tolerance = Tolerance středu ±
simulated-workpiece = Simulovaný obrobek
simulated-hint = Bez zadaného průměru platí střed tolerančního pole. Počáteční číslo se po každém měření zvýší; stejné počáteční číslo dá stejné body dotyku.
true-diameter = Skutečný průměr
seed = Poč. číslo
offset-x = Posun X
offset-y = Posun Y
ovality = Ovalita
lobes = Laloky
lobe-height = Výška laloků
surface-scatter = Rozptýlení povrchu 1σ
probe-scatter = Rozptýlení sondy 1σ

field-range = { $given } je mimo rozsah −{ $limit } až { $limit }
field-not-negative = { $given } je pod 0: dovoleno je 0 až { $limit }
field-above-zero = { $given } není nad 0: dovoleno je nejvýše { $limit }
field-not-whole = { $given } není celé číslo

limit-band = Pás mezí
band-example = příklad: { $callout }, díra
band-empty = Pás mezí se zobrazí, jakmile jsou známy meze
band-describe = Úchylka od jmenovitého rozměru v mikrometrech: toleranční pole od { $lower } do { $upper }, pod ním { $left }, nad ním { $right }.
band-describe-measured = Naměřeno { $deviation }, { $above } nad minimem, { $below } pod maximem.
side-rework = oprava
side-scrap = zmetek
side-out = mimo toleranci

last-values = Poslední hodnoty
last-values-empty = Zde se zobrazí poslední hodnoty k těmto mezím
last-values-describe = { $count ->
    [one] Poslední hodnota:
    [few] Poslední { $count } hodnoty, nejnovější jako poslední:
   *[other] Posledních { $count } hodnot, nejnovější jako poslední:
}
contacts = Body dotyku
contacts-factor = úchylky × { $factor }
contacts-empty = Body dotyku se zobrazí po měření
contacts-describe = Body dotyku při pohledu shora: { $count }, úchylky zvětšeny { $factor }krát. { $circle }
centre-is = střed { $x } / { $y }

word-none = Bez výsledku
nothing-measured = Nic nebylo změřeno
judged-without-own = Posouzeno bez vlastních tabulek
word-question = Je to správně?
simulated = SIMULOVÁNO
status-simulated = { simulated }: { $status }
judge-anyway = Posoudit { $measured } mm beze změny
take-meant = Použít { $meant } mm
take-text = Použít { $meant }
keep-text = Ponechat { $given } beze změny
doubted-enter = Enter použije zvýrazněné tlačítko; psaním se text přepíše
doubted-type = Dokud text není zadán znovu nebo potvrzen beze změny, nic se neposuzuje
question-enter = Po půl sekundě Enter stiskne vyplněné tlačítko; psaním se hodnota přepíše
doubt-sentence = Pochybnost: { $doubt }
lot-title = { $rows ->
    [one] { $name }: 1 řádek
    [few] { $name }: { $rows } řádky
   *[other] { $name }: { $rows } řádků
}
lot-unjudged = neposouzeno: { $count }
lot-refused = { $count ->
    [one] 1 odmítnutý řádek
    [few] { $count } odmítnuté řádky
   *[other] { $count } odmítnutých řádků
}
lot-doubted = { $count ->
    [one] 1 pochybná hodnota
    [few] { $count } pochybné hodnoty
   *[other] { $count } pochybných hodnot
}
lot-shown = Zobrazeno: { $place } z { $judged }, nejhorší první; řádek { $line }
lot-shown-part = Zobrazeno: { $place } z { $judged }, nejhorší první; řádek { $line }, díl { $part }
lot-worst = Nejhorší
lot-worse = Horší
lot-better = Lepší
lot-best = Nejlepší
lot-count = { $status } { $count }
above-minimum = { $um } µm nad minimem
below-minimum = { $um } µm pod minimem
below-maximum = { $um } µm pod maximem
above-maximum = { $um } µm nad maximem
remove-amount = Odebrat { $um } µm
remove-to-limit = k mezi
remove-to-limit-per-side = k mezi, { $um } µm na stranu
remove-to-middle = { $um } µm do středu tolerančního pole
position-in = Střed v toleranci
position-out = Střed mimo toleranci
diameter-alone = Jen průměr: { $status }
first-steps = První kroky
first-steps-title = Jste tu poprvé?
first-steps-about = Tato nastavení se uloží.
first-steps-done = Hotovo
first-way-part = Celý díl
first-way-part-about = Prvek po prvku, podle plánu s obrázkem.
first-way-file = Soubor s hodnotami
first-way-file-about = CSV, sešit, QIF, AQDEF nebo měřicí protokol.
first-way-program = Bez stroje
first-way-program-about = NC program nebo cyklus měří simulovanou díru, bod po bodu.
first-step-callout = 1. Předpis: co udává výkres
first-step-value = 2. Naměřená hodnota: zadaná, simulovaná nebo ze souboru
first-step-verdict = 3. Výrok a kolik odebrat
why = Proč?
why-limits = Zdroj mezí: { $what }
why-measured = Naměřená hodnota: { $what }
why-rule = Pravidlo: { $what }
why-caveat = Omezení tohoto měření: { $what }

popup-title = Stavové okno
popup-title-accepted = Stavové okno: mimo meze, podle pravidla přijato
popup-title-simulated = Stavové okno, SIMULOVÁNO
popup-exact = Okno zaokrouhluje na čtyři desetinná místa. Přesné hodnoty: { $values }
popup-empty = Zatím žádné měření
copy = Kopírovat
mask-choice = Maska
mask-choice-of-language = Jazyk okna
mask-choice-own = Vlastní maska…

history = Historie
history-count = { $count ->
    [0] žádné kontroly
    [one] 1 kontrola
    [few] { $count } kontroly
   *[other] { $count } kontrol
}
history-chosen = vybráno k exportu: { $count }
history-hidden = z toho mimo seznam: { $hidden }
history-shown = { $shown } z { $count ->
    [one] 1 kontroly
   *[other] { $count } kontrol
}
history-exported-listed = { $count ->
    [0] Seznam je prázdný: není co exportovat
    [one] Exportuje se 1 kontrola ze seznamu (celkem { $all })
    [few] Exportují se { $count } kontroly ze seznamu (celkem { $all })
   *[other] Exportuje se { $count } kontrol ze seznamu (celkem { $all })
}
rows-exported = Exportují se řádky ze seznamu souboru { $name } v pořadí seznamu, počet: { $listed }
rows-export-not-yet = Řádky lze exportovat, až budou všechny posouzeny a v seznamu
history-exported = { $count ->
    [0] Není co exportovat
    [one] Exportuje se 1 kontrola
    [few] Exportují se všechny { $count } kontroly
   *[other] Exportuje se všech { $count } kontrol
}
history-cleared = { $count ->
    [one] Z historie byla odebrána 1 kontrola. Příkaz Zpět (Ctrl+Z) ji vrátí.
    [few] Z historie byly odebrány { $count } kontroly. Příkaz Zpět (Ctrl+Z) je vrátí.
   *[other] Z historie bylo odebráno { $count } kontrol. Příkaz Zpět (Ctrl+Z) je vrátí.
}
history-none-found = Filtru neodpovídá žádná kontrola
history-filter = Filtr
history-filter-hint = Vypíše kontroly, které obsahují tato slova: díl, předpis, hodnota, datum, stav nebo soubor
history-only-bad = Kromě dobrých
history-only-bad-hint = Oprava, přeměřit a zmetek
history-sort-hint = Seřadí podle tohoto sloupce; dalším stisknutím se pořadí obrátí, třetím se vrátí nejnovější první
history-ascending = { $column }, vzestupně
history-descending = { $column }, sestupně
history-list = Kontroly v historii
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, vybráno k exportu
history-move = Přejít na jinou kontrolu
history-show = Zobrazit kontrolu
history-choose = Vybrat k exportu
choose-all = Vybrat vše ze seznamu
copy-checks = Kopírovat do tabulkového procesoru
history-empty = Zde se zobrazí kontroly, nejnovější první
head-time = Datum a čas
head-part = Díl
head-callout = Předpis
head-measured = Naměřeno
head-deviation = Úchylka
head-status = Stav
head-from = Zdroj
choose-check = Vybrat { $check } z { $time } k exportu

dialog-import = Import měření
dialog-mask = Vlastní maska
dialog-tables = Složka s vlastními tabulkami
dialog-export = Export
dialog-export-rows = Export řádků ze seznamu
dialog-export-status = Export stavového okna
file-path = Soubor
folder-path = Složka
dialog-open = Otevřít
dialog-save = Uložit
dialog-browse = Procházet…
dialog-cancel = Zrušit
dialog-busy = Probíhá…
dialog-no-path = Chybí cesta
dialog-no-status = Není stavové okno k uložení
dialog-browse-hint = Zobrazí dialog systému pro výběr souboru
dialog-up = Nadřazená složka
dialog-home = Domovská složka
dialog-all-files = Všechny soubory
file-kind-measurements = Měření
file-kind-mask = Masky
file-kind-own-tables = Složky s tabulkami
file-kind-report = Zprávy
file-kind-rows = Řádky
file-kind-status = Text
file-kind-table = Tabulky
file-kind-contacts = Body dotyku
file-kind-workpiece = Simulované obrobky
file-kind-probes = Tabulky dotykových sond
file-kind-log = Měřicí protokoly
file-kind-program = NC programy
file-kind-part = Simulované díly
file-kind-set = Soubory pro řídicí systém
file-kind-tools = Tabulky nástrojů
file-kind-plan = Plány dílů
file-kind-picture = Obrázky
file-kind-watched = Sledované složky
file-kind-budget = Bilance nejistot
file-kind-chart = Grafy
file-kind-readings = Odečty
file-kind-study = Odečty měřidla
dialog-move = Přejít na jinou položku
dialog-recent-folders = Nedávné složky
dialog-exists = { $name } už existuje. Nahradit?
dialog-exists-set = { $name } v této složce už existuje. Nahradit tam soubory sady?
dialog-replace = Nahradit
dialog-keep = Ponechat
dialog-nothing-picked = Dialog systému nevrátil žádný soubor. Vyberte jej v seznamu, nebo zadejte cestu.
dialog-list = Složka { $folder }
dialog-entries = Soubory a složky
dialog-list-none = Není otevřena žádná složka: zadejte cestu
dialog-list-reading = Načítá se složka…
dialog-list-empty = V této složce není co vybrat
dialog-list-more = Vypsáno je jen prvních { $most } položek: název jiné zadejte ručně
dialog-is-folder = Složka
file-name-checks = kontroly
open-written = Otevřít
show-in-folder = Zobrazit ve složce
launch-failed = soubor nelze otevřít: { $reason }
recent-files = Nedávné soubory
forget-recent = Vymazat seznam
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] 1 položka není zobrazena
    [few] { $count } položky nejsou zobrazeny
   *[other] { $count } položek není zobrazeno
}
file-bytes = { $count } B
file-kilobytes = { $count } kB
file-megabytes = { $count } MB
notice = Oznámení
copied = { $lines ->
    [one] Zkopírován jeden řádek
    [few] Zkopírovány { $lines } řádky
   *[other] Zkopírováno { $lines } řádků
    }
notice-problem = Chyba
notice-more = { $count ->
    [one] následuje 1 další hlášení
    [few] následují { $count } další hlášení
   *[other] následuje { $count } dalších hlášení
}
messages = Dřívější hlášení
messages-forget = Vyprázdnit seznam
messages-count = { $count ->
    [one] 1 dřívější hlášení
    [few] { $count } dřívější hlášení
   *[other] { $count } dřívějších hlášení
}
close = Zavřít
file-written = { $name }: zapsáno do složky { $folder }
file-written-here = { $name }: zapsáno
tables-loaded = { $count ->
    [one] Používá se 1 tabulka ze složky { $folder }
    [few] Používají se { $count } tabulky ze složky { $folder }
   *[other] Používá se { $count } tabulek ze složky { $folder }
}
mask-loaded-with-warnings = { $name }: načteno s varováními
state-set-aside = Uložený stav nelze přečíst. Zůstal zachován jako { $path } a okno začíná s výchozím nastavením.
state-set-aside-now = Uložený stav už nelze přečíst. Zůstal zachován jako { $path } a místo něj se uložil stav tohoto okna.
state-not-kept = Stav tohoto okna se neukládá: { $reason }
import-contacts-not-judged = Body dotyku v souboru { $name } nebyly posouzeny
import-notice = { $name }: { $good ->
    [0] žádná kontrola
    [one] 1 kontrola
    [few] { $good } kontroly
   *[other] { $good } kontrol
}, { $bad ->
    [0] žádný odmítnutý řádek
    [one] 1 odmítnutý řádek
    [few] { $bad } odmítnuté řádky
   *[other] { $bad } odmítnutých řádků
}
import-counted = { $file }. { $counts }
check-said-afterwards = uvedeno po posouzení: { $as }
lot-open = { $count ->
    [one] U jedné hodnoty chybí díra nebo hřídel:
    [few] U { $count } hodnot chybí díra nebo hřídel:
   *[other] U { $count } hodnot chybí díra nebo hřídel:
}
check-all-holes = Všechny jsou díry
check-all-shafts = Všechny jsou hřídele
check-judged-again = { $count ->
    [one] Jedna hodnota mimo meze byla znovu posouzena: { $as }
    [few] { $count } hodnoty mimo meze byly znovu posouzeny: { $as }
   *[other] { $count } hodnot mimo meze bylo znovu posouzeno: { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Zobrazit
notice-open-in = Otevřít: { $page }
judge-unplanned = Otevřít v Kontrole
sample-not-recorded = Ukázka se nezaznamenává.
limits-own-first = Nejprve z vlastních tabulek: { $names }
limits-own-stay = Vlastní tabulky mají nadále přednost: { $names }. Vypínají se v nabídce, Zdroj mezí.
measured-needs-value = Zadejte naměřenou hodnotu
measured-needs-limits = Chybějí meze pro posouzení: nejprve zadejte předpis

keypad = Klávesnice
key = Klávesa
key-blank = Mezera
key-decimal = Desetinný oddělovač
key-minus = Minus
edge-left = Okraj levého panelu: posouvá se šipkami
edge-right = Okraj pravého panelu: posouvá se šipkami
edge-top = Okraj horního panelu: posouvá se šipkami
edge-bottom = Okraj dolního panelu: posouvá se šipkami
key-letters = Písmena
key-holes = Třídy děr
key-shafts = Třídy hřídelů
key-more-letters = M až X
key-signs = Y, Z a znaky
key-figures = Číslice
key-shift = Velká nebo malá písmena
key-back = Smazat poslední znak
key-clear = Vyprázdnit
key-enter = Enter

## Table page
tables-choice = Tabulka
tables-kind-shipped = vestavěná
tables-kind-own = vlastní
tables-kind-file = ze souboru
tables-kind-copy = kopie
tables-kind-made = z ISO 286
tables-unsaved = neuloženo
tables-open = Otevřít…
tables-save = Uložit jako
tables-redo = Znovu
tables-use = Používat tabulku pro meze
tables-in-use = Používá se pro meze
tables-filter = Filtr
tables-filter-hint = Třídy jako H7 g6, písmena, stupně nebo rozměr v mm
tables-shown = { $count ->
    [one] { $shown } z 1 třídy
   *[other] { $shown } z { $count } tříd
}
tables-only-differences = Jen rozdíly
tables-unmatched = nenalezeno: { $words }
tables-agrees = { $count ->
    [one] 1 buňka, shodná s ISO 286
    [few] všechny { $count } buňky shodné s ISO 286
   *[other] všech { $count } buněk shodných s ISO 286
}
tables-differs = { $count ->
    [one] 1 buňka z { $compared } se liší od ISO 286
    [few] { $count } buňky z { $compared } se liší od ISO 286
   *[other] { $count } buněk z { $compared } se liší od ISO 286
}
tables-compared-nothing = není co porovnat s ISO 286
tables-own-classes = { $count ->
    [one] 1 vlastní třída
    [few] { $count } vlastní třídy
   *[other] { $count } vlastních tříd
}
tables-own-class = vlastní
tables-previous = Předchozí rozdíl
tables-next = Další rozdíl
tables-not-saved = Změny nejsou uloženy
tables-keys = Šipky přecházejí mezi buňkami, Enter upravuje, Delete vyprázdní, F8 přejde na další rozdíl, Ctrl+F do filtru
tables-move = Přejít na jinou buňku
tables-edit-cell = Upravit buňku
tables-grid = Úchylky tabulky { $name } v µm
tables-range-head = nad – do, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = prázdné
tables-cell = { $class }, nad { $over } do { $to } mm, { $figures }
tables-cell-differs = { $class }, nad { $over } do { $to } mm, { $figures }, liší se od ISO 286
tables-no-columns = Tabulka nemá žádnou třídu
tables-upper = Horní
tables-lower = Dolní
tables-head-table = Tabulka, µm
tables-head-standard = ISO 286
tables-head-by = rozdíl
tables-cell-agrees = Jako v ISO 286
tables-cell-off = ISO 286 má { $upper } / { $lower } µm; tabulka se liší o { $upper-by } / { $lower-by } µm
tables-more-differences = a dalších { $count }
tables-cell-missing = Zde prázdné; ISO 286 má { $upper } / { $lower } µm
tables-cell-empty = Zde prázdné a v ISO 286 nestanoveno
tables-defined = Rozsah třídy v ISO 286: { $ranges }
tables-shipped-hint = Vestavěná tabulka se nikdy nemění: úprava vytvoří kopii a zobrazí ji.
tables-set = Nastavit
tables-take-standard = Použít ISO 286
tables-empty-cell = Vyprázdnit
tables-remove-column = Odebrat { $class }
tables-from-standard = Z ISO 286
tables-classes = Třídy, například H7 K7 P9
tables-add-columns = Přidat do tabulky
tables-up-to = Rozměry do
tables-make = Nová tabulka
tables-order = horní úchylka { $upper } µm je pod dolní úchylkou { $lower } µm
tables-used-edited = { $name } udává meze: kontroly nyní používají změnu
tables-used = Meze se až do zavření okna hledají nejprve v tabulce { $name }. Chcete-li ji používat dál, uložte ji do složky s vlastními tabulkami.
tables-read-with-warnings = { $name }: načteno s varováními
tables-nothing-read = Soubor neobsahuje žádnou tabulku úchylek
tables-nothing-to-save = Není otevřena žádná tabulka
tables-cell-unreadable = Hodnoty vybrané buňky nelze přečíst: nejprve je opravte
tables-too-many = Otevřené tabulky s neuloženými změnami: { $count }. Nejprve jednu uložte
tables-dialog-open = Otevřít tabulku
tables-dialog-save = Uložit tabulku
## Fit page
fit-callout = Uložení díry a hřídele
fit-callout-hint = Zadejte jmenovitý rozměr a obě třídy, například 25 H7/g6
fit-example = příklad: { $callout }
fit-shaft-missing = Chybí třída hřídele, například g6 v 25 H7/g6
fit-hole-missing = Chybí třída díry, například H7 v 25 H7/g6
fit-classes-missing = Uložení má třídu díry a třídu hřídele, například 25 H7/g6
fit-preferred = Přednostní uložení
fit-function = Funkce
fit-list-hole-basis = Jednotná díra
fit-list-shaft-basis = Jednotný hřídel
fit-parts = Skutečné díly
fit-hole-measured = Změřená díra
fit-shaft-measured = Změřený hřídel
fit-temperature = Teplota
fit-hole-material = Materiál díry
fit-hole-expansion = Díra, µm/(m K)
fit-shaft-material = Materiál hřídele
fit-shaft-expansion = Hřídel, µm/(m K)
fit-own-value = Vlastní hodnota
fit-press = Nalisované spojení
fit-press-length = Délka spoje
fit-hub-outer = Náboj vně
fit-shaft-bore = Vrtání hřídele
fit-press-material = Nalisované spojení potřebuje pro oba díly materiál ze seznamu: zvolte ho
fit-press-pressure = Tlak ve spoji
fit-press-force = Drží axiálně
fit-press-torque = Drží jako moment
fit-press-pressing = Lisovací síla
fit-press-hub = Náboj: napětí / mez
fit-press-shaft = Hřídel: napětí / mez
fit-press-heat = Ohřát náboj na
fit-press-cool = Nebo ochladit hřídel na
fit-press-friction = Tření { $friction }; pružně, při 20 °C a v klidu. Axiální síla a moment neplatí zároveň
fit-search = Hledat podle vůle
fit-wanted-minimum = Minimum
fit-wanted-maximum = Maximum
fit-scope = Z čeho
fit-scope-all = Všechny třídy
fit-scope-basis = Jednotná díra a jednotný hřídel
fit-scope-preferred = Přednostní a pojmenovaná uložení
fit-search-hint = Nejmenší a největší vůle; záporná hodnota je přesah. Lze připojit jednotku: 7 µm
fit-search-size = K hledání je třeba jmenovitý rozměr: zadejte jej výše
fit-found = { $count ->
    [one] 1 uložení
   *[other] { $count } uložení
}
fit-found-first = vypsáno nejlepších { $count }
fit-found-none = Žádné uložení nevyhovuje. Nejbližší
fit-missed-by = { $below } µm chybí, { $above } µm přebývá
fit-is-preferred = přednostní

fit-picture = Toleranční pole díry a hřídele
fit-picture-legend = µm od nulové čáry; základní úchylka tučně
fit-picture-empty = Toleranční pole se zobrazí s uložením
fit-arrow-clearance = Skutečná vůle
fit-arrow-interference = Skutečný přesah
fit-describe-zero = Nulová čára { $nominal } mm.
fit-describe-zone = { $part } { $class } od { $lower } do { $upper } µm.
fit-describe-fundamental = Základní úchylka { $deviation } µm.
fit-describe-measured = { $part }, naměřeno { $deviation } µm.
fit-classes = Třídy pro { $nominal } mm
fit-classes-none = Třídy
fit-classes-empty = Třídy se zobrazí po zadání jmenovitého rozměru
fit-classes-nowhere = Pro tento rozměr není stanovena žádná třída
fit-staircase = Toleranční pole stupně { $grade }

fit-word-clearance = Uložení s vůlí
fit-word-transition = Přechodné uložení
fit-word-interference = Uložení s přesahem
fit-word-none = Zatím bez uložení
fit-maximum-clearance = Největší vůle
fit-minimum-clearance = Nejmenší vůle
fit-maximum-interference = Největší přesah
fit-minimum-interference = Nejmenší přesah
fit-mean-clearance = Střední vůle
fit-mean-interference = Střední přesah
fit-ansi = ANSI B4.2: { $name }
fit-equivalent = Rovnocenné uložení
fit-equivalent-same = Přesně stejné vůle
fit-equivalent-differs = Není stejné: nejmenší vůle { $minimum } µm, největší { $maximum } µm
fit-check-hole = Kontrolovat díru
fit-check-shaft = Kontrolovat hřídel
fit-move = Přejít na jinou třídu
fit-actual-clearance = Vůle { $um } µm
fit-actual-interference = Přesah { $um } µm
fit-conforms = V mezích předpisu
fit-conforms-not = Mimo meze předpisu
fit-with-good-shaft = Vůle s dobrým hřídelem
fit-with-good-hole = Vůle s dobrou dírou
fit-at-temperature = Při { $degrees } °C
fit-temperature-change = změna vůle o { $um } µm
fit-these-parts = Tyto díly: { $clearance }

## Own materials
materials-refused = Vlastní materiály nelze použít: { $path }, { $reason }

## Palette
section-said = { $name }: { $value }
crash-report = Okno se zavřelo kvůli chybě programu. Hlášení o ní, bez naměřených hodnot, je v souboru { $path }
rail-more = Další
top-open = Otevřeno: { $name }
top-undo = Vrátit poslední změnu
top-recorded = Zaznamenáno, { $number }
top-recording = Zaznamenává se
top-not-recorded = Nezaznamenáno
palette = Hledat nebo provést cokoli
palette-do = Provést
palette-open = Otevřít
palette-settings = Nastavení a nápověda
palette-records = Záznamy
palette-fit = Uložení { $fit }
palette-in-tables = { $what } v tabulkách
palette-uncertainty = Nejistota při { $size } mm
palette-records-of = Záznamy: { $what }
palette-show-setting = Zobrazit na stránce Nastavení
palette-more = Co s tím ještě
palette-back = Zpět k nalezenému
palette-check-value = Kontrolovat { $callout } s hodnotou { $value }
palette-check = Kontrolovat { $callout }
palette-search-manual = Hledat „{ $query }“ v příručce
palette-nothing = Nic nemá tento název
palette-hint = Předpis, stránka, příkaz nebo soubor

## Leaving
leave = Zavřít Fitcheck?
discard = Zahodit změny?
discard-unsaved = { $name } má neuložené změny.
discard-no = Upravovat dál
discard-yes = Zahodit změny
leave-unsaved = Neuloženo: { $names }
leave-stay = Pracovat dál
leave-anyway = Zavřít bez uložení

## Cycle pictures
cycle-picture-centre-1 = jmenovitý střed v první ose
cycle-picture-centre-2 = jmenovitý střed v druhé ose
cycle-picture-centre-tolerance-1 = dovolená úchylka středu v první ose, v obou směrech; 0 nic nehlídá
cycle-picture-centre-tolerance-2 = dovolená úchylka středu v druhé ose, v obou směrech; 0 nic nehlídá
cycle-picture-side-length-1 = jmenovitá délka obdélníku podél první osy
cycle-picture-side-length-2 = jmenovitá délka obdélníku podél druhé osy
cycle-picture-maximum-side-1 = největší dovolená délka podél první osy
cycle-picture-maximum-side-2 = největší dovolená délka podél druhé osy
cycle-picture-minimum-side-1 = nejmenší dovolená délka podél první osy
cycle-picture-minimum-side-2 = nejmenší dovolená délka podél druhé osy
cycle-picture-width = jmenovitá šířka od stěny ke stěně
cycle-picture-maximum-width = největší dovolená šířka
cycle-picture-minimum-width = nejmenší dovolená šířka
cycle-picture-start-1 = výchozí bod sondy v drážce, první osa
cycle-picture-start-2 = výchozí bod sondy v drážce, druhá osa
cycle-picture-shift = posun druhého bodu dotyku podél stěn; při 0 leží naproti prvnímu
cycle-picture-first-point-1 = první bod na stěně na kladné straně: první osa
cycle-picture-first-point-2 = první bod na stěně na kladné straně: druhá osa
cycle-picture-second-point-1 = druhý bod na stěně na záporné straně: první osa
cycle-picture-second-point-2 = druhý bod na stěně na záporné straně: druhá osa
cycle-picture-axis-of-plane = osa měření: 1 první osa, 2 druhá osa
cycle-picture-diameter = jmenovitý průměr
cycle-picture-maximum-size = největší dovolený průměr
cycle-picture-minimum-size = nejmenší dovolený průměr
cycle-picture-start-diameter = průměr kružnice, na které sonda stojí před každým dotykem
cycle-picture-first-angle = úhel prvního bodu dotyku, měřený od první osy
cycle-picture-step = úhel od bodu dotyku k dalšímu; minus otáčí ve směru hodinových ručiček
cycle-picture-arc = úhel, na kterém jsou body dotyku rozloženy; 360 je celá otáčka, minus otáčí ve směru hodinových ručiček
cycle-picture-longest-path = nejdelší dráha snímání; plus vede od středu, minus ke středu
cycle-picture-difference = každý bod se snímá dvakrát: největší dovolený rozdíl
cycle-picture-measuring-height = výška středu kuličky při dotyku
cycle-picture-set-up-clearance = vzdálenost před dotykem, přičítá se k SET_UP z tabulky dotykových sond
cycle-picture-clearance-height = výška, ve které se sonda volně pohybuje
cycle-picture-point-1 = snímaný bod, první osa
cycle-picture-point-2 = snímaný bod, druhá osa
cycle-picture-point-3 = snímaný bod, třetí osa
cycle-picture-next-point-1 = druhý bod přímky, první osa
cycle-picture-next-point-2 = druhý bod přímky, druhá osa
cycle-picture-next-point-3 = druhý bod přímky, třetí osa
cycle-picture-second-centre-1 = jmenovitý střed druhé kružnice, první osa
cycle-picture-second-centre-2 = jmenovitý střed druhé kružnice, druhá osa
cycle-picture-second-diameter = jmenovitý průměr druhé kružnice
cycle-picture-second-height = výška, ve které se snímá druhá kružnice
cycle-picture-geometries = 0 dvě díry, 1 dva čepy, 2 díra a čep, 3 čep a díra
cycle-picture-maximum-coordinate = největší dovolená souřadnice
cycle-picture-minimum-coordinate = nejmenší dovolená souřadnice
cycle-picture-normal-1 = složka normály plochy v první ose; normála míří ven z materiálu
cycle-picture-normal-2 = složka normály plochy v druhé ose; normála míří ven z materiálu
cycle-picture-normal-3 = složka normály plochy v třetí ose; normála míří ven z materiálu
cycle-picture-band = dovolená úchylka ve směru normály: nad rozměr plus, pod rozměr minus
cycle-picture-retract = dráha zpět od bodu dotyku, proti směru snímání
cycle-picture-move-to-clearance = dráha mezi body dotyku: 0 ve výšce měření, 1 přes bezpečnou výšku
cycle-picture-clearance-mode = bezpečná výška: −1 nikdy, 0 před cyklem a po něm, 1 před každým objektem a po něm, 2 u každého bodu dotyku
cycle-picture-traverse = dráha k dalšímu bodu dotyku: 0 přímka, 1 oblouk
cycle-picture-contact-count = počet bodů dotyku
cycle-picture-plane = rovina kružnice: 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 snímá uvnitř, 1 vně
cycle-picture-measured-axis = osa měření: 1 první osa, 2 druhá osa, 3 osa sondy
cycle-picture-direction = směr najetí: −1 proti ose, +1 ve směru osy
cycle-picture-directed-axis = měřená osa, 1 první, 2 druhá, 3 osa sondy; minus snímá proti ose
cycle-picture-tool-axis-probing = osa sondy: 0 zůstává, 1 se také snímá a nastaví
cycle-picture-tool-axis-point-1 = kde se snímá osa sondy, první osa
cycle-picture-tool-axis-point-2 = kde se snímá osa sondy, druhá osa
cycle-picture-tool-axis-point-3 = kde se v ose sondy očekává plocha
cycle-picture-new-datum-1 = souřadnice, kterou naměřené místo dostane v první ose
cycle-picture-new-datum-2 = souřadnice, kterou naměřené místo dostane ve druhé ose
cycle-picture-new-datum-3 = souřadnice, kterou naměřené místo dostane v ose sondy
cycle-picture-new-coordinate = souřadnice, kterou naměřené místo dostane v měřené ose
cycle-picture-table-row = řádek tabulky, do kterého přijde vztažný bod; při 0 je ihned aktivní
cycle-picture-transfer = tabulka: −1 neuvedeno, 0 nulové body, 1 vztažné body
cycle-picture-preset-correction = 0 ponechá aktivní vztažný bod, jak je; jiné číslo ho opraví, takže tento bod ukazuje svou jmenovitou hodnotu
cycle-picture-aligned-angle = úhel, do kterého se hrana vyrovná, od první osy; 0 ji vyrovná s osou
cycle-picture-compensation-axis = rotační osa, která hranu vyrovná: 0 ta, kolem níž se měřil úhel, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = rotační osa po vyrovnání: 0 ponechá svou hodnotu, 1 ukazuje nulu
cycle-picture-rotary-alignment = rotační osy po měření: 0 zůstanou stát, jiné číslo jimi otočí, takže přímka je vyrovnaná
cycle-picture-rotation-transfer = změřený úhel: 0 nemění nic, 1 se stane základním natočením, 2 posunutím rotační osy
cycle-picture-log = měřicí protokol: 0 žádný, 1 soubor, 2 na obrazovce a program se zastaví
cycle-picture-stop = mimo toleranci: 0 program pokračuje, 1 zastaví se s hlášením
cycle-picture-stop-on-undersize = mimo toleranci: 0 program pokračuje, 1 zastaví se, 2 zastaví se jen pod rozměrem
cycle-picture-stop-on-scrap = mimo toleranci: 0 program pokračuje, 1 zastaví se, 2 zastaví se jen při zmetku
cycle-picture-tool = sledovaný nástroj, číslo nebo název; 0 je žádný
cycle-picture-any-length = { $name } Délka
cycle-picture-any-angle = { $name } Úhel
cycle-picture-any-choice = { $name } Jedna z hodnot { $of }
cycle-picture-any-number = { $name } Číslo
cycle-picture-part = Díl: { $count ->
    [one] jeden prvek
    [few] { $count } prvky
   *[other] { $count } prvků
  }: { $names }.
cycle-picture-path = Dráha sondy, hotovo { $step } z { $moves } pohybů, { $contacts ->
    [one] 1 bod dotyku
    [few] { $contacts } body dotyku
   *[other] { $contacts } bodů dotyku
}. Kulička na X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, bod dotyku { $touch }
cycle-picture-no-path = Dráha se zobrazí po provedení cyklu
cycle-picture-phase-pre-position = předpolohování
cycle-picture-phase-approach = najetí
cycle-picture-phase-contact = dotyk
cycle-picture-phase-retract = odjetí
cycle-picture-phase-leave = opuštění
cycle-picture-from-above = { $first }/{ $second } shora
cycle-picture-from-side = { $first }/{ $second } ze strany
cycle-picture-contacts = Body dotyku kolem kružnice nejmenších čtverců Ø { $diameter } mm, počet { $count }, { $factor }: { $residuals }.
cycle-picture-nominal = Jmenovitá kružnice Ø { $diameter } mm.
cycle-picture-legend-fitted = nejmenší čtverce
cycle-picture-legend-nominal = jmenovitá
cycle-picture-deviation = úchylka ve směru normály { $deviation } mm, bez tolerance
cycle-picture-no-limits = Meze nebyly zadány: nic se neporovnalo
cycle-picture-head-criterion = Kritérium
cycle-picture-head-centre-1 = Střed, 1. osa
cycle-picture-head-centre-2 = Střed, 2. osa
cycle-picture-head-diameter = Ø v mm
cycle-picture-head-form = Tvar
cycle-picture-none = —
cycle-picture-least-squares = Nejmenší čtverce
cycle-picture-circumscribed = Nejmenší opsaná
cycle-picture-inscribed = Největší vepsaná
cycle-picture-zone = Minimální zóna, kruhovitost
cycle-picture-two-point = Dvoubodový rozměr
cycle-picture-two-point-of = Dvoubodový rozměr { $first }–{ $second }
cycle-picture-two-point-least = Nejmenší dvoubodový rozměr, { $first }–{ $second }
cycle-picture-two-point-most = Největší dvoubodový rozměr, { $first }–{ $second }
cycle-picture-no-opposed = žádné dva body dotyku neleží proti sobě
cycle-picture-uncertainty = Rozptýlení s bodu dotyku dává { $diameter } s v průměru, { $against }krát tolik co 3 body po 120°, a { $across } s až { $along } s ve středu

# The saved state, and the window itself
saved-broken = uložený stav nelze přečíst: { $reason }
saved-newer = uložený stav má verzi { $version }, tento program podporuje verze do { $known }
window-no-display = chybí displej: DISPLAY a WAYLAND_DISPLAY nejsou nastaveny. Přihlaste se na ploše, připojte se přes ssh -X, nebo použijte příkazový řádek, který displej nepotřebuje: fitcheck check "25 H7" --measured 25.012; viz fitcheck --help
open-unknown = { $name } není soubor, který okno otevírá; otevírá měření, měřicí protokoly a body dotyku (.csv, .tsv, .txt, .html), NC programy (.h), tabulky (.tab), tabulky nástrojů (.t), simulované obrobky (.toml), tabulky dotykových sond (.tp) a masky (.a)
window-not-opened = okno nelze otevřít: { $reason }; příkazový řádek funguje i bez displeje, viz fitcheck --help

## Rows of a large file

rows = Řádky
rows-cancel = Zrušit
rows-again = Posoudit znovu
rows-close = Zavřít soubor
rows-close-hint = Zavře velký soubor; jeho řádky se neuchovají
rows-move = Přejít na jiný řádek
rows-show = Zobrazit kontrolu řádku
rows-keep = Přidat do historie
rows-kept = Kontrola byla přidána do historie
rows-progress = Přečtená část souboru
rows-running = dosud řádků: { $count }, { $percent } % souboru, { $rate } řádků za sekundu
rows-done = řádků: { $count }, vše posouzeno za { $seconds }
rows-seconds = { $seconds } s
rows-less-than = méně než { $seconds } s
rows-cancelled = NEÚPLNÉ: zrušeno, řádků: { $count }, { $percent } % souboru
rows-failed = NEÚPLNÉ, řádků: { $count }: { $why }
rows-why-bytes = { $size } MiB, více než { $limit } MiB: posuzuje se řádek po řádku a řádky se v historii neuchovají
rows-why-packed = Komprimováno: posuzuje se řádek po řádku a řádky se v historii neuchovají; rozbalený text je do zavření souboru v dočasném souboru
rows-not-judged = NEPOSOUZENO
rows-fate = { $fate } { $count }
rows-fate-hint = Vypíše tyto řádky; lze jich vybrat více druhů
rows-classes = Třídy
rows-all-classes = Všechny třídy
rows-no-class = Bez třídy
rows-some-classes = třídy: { $count }
rows-class = { $class }: { $count }
rows-summary = Souhrn
rows-fate-only = Vypsat řádky velkého souboru: { $fate }
rows-filter-hint = Vypíše řádky, které v buňkách obsahují tato slova, například díl, předpis, hodnotu nebo stav
rows-worst-first = Nejhorší první
rows-worst-first-hint = Vypíše zmetky před opravami a dobrými, nejprve největší odstup od mezí
rows-worst = Nejhorší díl
rows-sifting = Prohledávají se řádky…
rows-sifts-at-end = Filtr a řazení platí až po posouzení všech řádků
rows-in-order = nejhorší první
rows-worst-of-many = z toho nejhorších { $most }, nejhorší první
rows-first-of-many = z toho prvních { $most }
rows-export = Řádky souboru jako { $format }, s výroky…
rows-export-programs = Kontroly řádků ze seznamu jako { $format }…
rows-export-simulated = První řádky souboru uvádějí, že je simulovaný, a zachovat je umí jen CSV. Exportujte jako CSV
rows-export-twice = Soubor má dva sloupce s názvem { $column }. Exportujte jako CSV nebo TSV, které to dovolují
rows-report-counts = { $name }: řádků { $count }; { $good } DOBRÝ, { $rework } OPRAVA, { $remeasure } PŘEMĚŘIT, { $out } MIMO TOLERANCI, { $scrap } ZMETEK, { $unjudged } NEPOSOUZENO; v této zprávě vypsáno { $listed }
rows-report-without = { $count ->
    [one] 1 vypsaný řádek nemá výrok ani kontrolu v této zprávě
    [few] { $count } vypsané řádky nemají výrok ani kontrolu v této zprávě
   *[other] { $count } vypsaných řádků nemá výrok ani kontrolu v této zprávě
}
rows-file-name = { $name }-posouzeno
rows-not-whole = NEÚPLNÉ: počty se netýkají celého souboru
rows-listed = v seznamu { $listed } z { $count } řádků
rows-refused = { $count ->
    [one] 1 řádek neposouzen
    [few] { $number } řádky neposouzeny
   *[other] { $number } řádků neposouzeno
}
rows-doubted = { $count ->
    [one] 1 hodnota může být jiná veličina nebo patřit k jinému dílu
    [few] { $number } hodnoty mohou být jinou veličinou nebo patřit k jinému dílu
   *[other] { $number } hodnot může být jiná veličina nebo patřit k jinému dílu
}
rows-simulated = { $count ->
    [one] 1 řádek uvádí, že nikdo neměřil
    [few] { $number } řádky uvádějí, že nikdo neměřil
   *[other] { $number } řádků uvádí, že nikdo neměřil
}
rows-status-differs = { $count ->
    [one] 1 řádek má v souboru jiný stav
    [few] { $number } řádky mají v souboru jiný stav
   *[other] { $number } řádků má v souboru jiný stav
}
rows-status-unknown = { $count ->
    [one] 1 řádek má v souboru neznámý stav
    [few] { $number } řádky mají v souboru neznámý stav
   *[other] { $number } řádků má v souboru neznámý stav
}
rows-claim-differs = { $count ->
    [one] 1 mez, úchylka nebo druh prvku odporuje svému řádku
    [few] { $number } meze, úchylky nebo druhy prvku odporují svým řádkům
   *[other] { $number } mezí, úchylek nebo druhů prvku odporuje svým řádkům
}
rows-several-lines = { $count ->
    [one] 1 řádek tabulky zabírá několik řádků souboru
    [few] { $number } řádky tabulky zabírají několik řádků souboru
   *[other] { $number } řádků tabulky zabírá několik řádků souboru
}
rows-not-utf8 = { $count ->
    [one] 1 řádek souboru není v UTF-8 a byl přečten jako Windows-1252
    [few] { $number } řádky souboru nejsou v UTF-8 a byly přečteny jako Windows-1252
   *[other] { $number } řádků souboru není v UTF-8 a bylo přečteno jako Windows-1252
}
rows-comments = { $count ->
    [one] 1 komentář se nepočítá jako řádek
    [few] { $number } komentáře se nepočítají jako řádky
   *[other] { $number } komentářů se nepočítá jako řádky
}
rows-note = Řádek { $line }: { $what }
rows-first-notes = Prvních { $first } z { $count }:
rows-line = Řádek { $line }, soubor { $name }
rows-row-line = řádek { $line }
rows-list = Řádky souboru
rows-none = Filtru neodpovídá žádný řádek
rows-none-yet = Zatím žádný řádek
rows-head-line = Řádek
rows-head-what = Co udělat
rows-changed = soubor se od posouzení změnil; posuďte jej znovu
rows-unread = řádky nelze znovu přečíst: { $reason }
rows-no-copy = rozbalený text nelze uchovat: { $reason }
rows-too-much = rozbalený text je větší než { $most } GiB
rows-panicked = běh ukončila vnitřní chyba

## A file that is read or written
working = Probíhá
working-reading = Čte se { $name }: řádků { $rows }, { $done } z { $all } MB, { $rate } řádků za sekundu
working-reading-bytes = Čte se { $name }: { $done } z { $all } MB, { $seconds } s
working-writing = Zapisuje se { $name }: { $done } MB, { $seconds } s
working-progress = Průběh čtení
working-stop = Zastavit
working-stopped = Zastaveno, přečteno řádků: { $rows }; ze souboru { $name } se nic neimportovalo

## What a code reader typed into the field of the value
scanned-callout = { $given } je předpis a byl tak převzat
scanned-serial = { $given } není hodnota: převzato jako sériové číslo dalších kontrol
