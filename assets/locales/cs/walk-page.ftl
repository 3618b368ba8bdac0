# The walk through a part, and the watched folder, on the parts page.

walk-page-begin = Začít díl
walk-page-count-up = Další číslo
walk-page-take = Posoudit
walk-page-take-meant = Použít { $meant } mm
walk-page-it-is-so = Je to tak: posoudit { $measured } mm
walk-page-measure-anew = Zahodit a změřit znovu
walk-page-confirmed = potvrzeno při měření: je to tak
walk-page-alarms = Otevřené výstrahy: { $count }
walk-page-alarms-short = Výstrahy
walk-page-alarms-more = Další výstrahy: { $count }
walk-page-alarm = { $name }: { $said }
walk-page-alarm-ask = Odpovědět na výstrahu
walk-page-alarm-ask-of = Odpovědět na výstrahu: { $name }
walk-page-alarm-answer = Zapsat odpověď
walk-page-alarm-later = Později
walk-page-alarm-cause = Příčina
walk-page-alarm-action = Opatření
walk-page-alarm-causes = Opotřebený nástroj; Nový nástroj; Korekce nástroje; Upnutí; Třísky nebo nečistota; Teplota; Materiál; Chyba měření; Neznámá
walk-page-alarm-actions = Nástroj vyměněn; Korekce upravena; Díl znovu upnut; Stroj vyčištěn; Změřeno znovu; Seřizovač informován; Sledováno dál; Není třeba
walk-page-alarm-empty = uveďte text, nebo vyberte některý ze seznamu
walk-page-alarms-unread = Pravidla regulačních diagramů nelze prověřit: { $why }
walk-page-alarms-unchecked = Pravidla regulačních diagramů nelze prověřit, { $name }: { $why }
walk-page-alarm-unrecorded = Výstrahu regulačního diagramu nelze zaznamenat: { $why }
walk-page-simulate = Simulovat
walk-page-simulate-hint = Provede cyklus prvku na dokonalém dílu; hodnotu nikdo neměří a zůstane označena jako simulovaná
walk-page-again = Přeměřit
walk-page-skip = Přeskočit
walk-page-skip-for = Přeskočit z tohoto důvodu
walk-page-skip-not = Nepřeskakovat
walk-page-next = Další díl
walk-page-move = Přejít na jiný rozměr
walk-page-import = Importovat hodnoty…
walk-page-watch = Sledovat složku…
walk-page-watch-hint = Soubory vložené do složky se posoudí podle plánu a zaznamenají, každý jednou
walk-page-watch-stop = Ukončit sledování
walk-page-dialog-watch = Sledovat složku
walk-page-begin-warned = { $count ->
    [one] 1 rozměr tohoto dílu nemá hodnotu ani důvod. Dalším stisknutím se díl ukončí.
    [few] { $count } rozměry tohoto dílu nemají hodnotu ani důvod. Dalším stisknutím se díl ukončí.
   *[other] { $count } rozměrů tohoto dílu nemá hodnotu ani důvod. Dalším stisknutím se díl ukončí.
}
walk-page-no-plan = Zatím žádný plán: otevřete jej, nebo jej vytvořte v pohledu Plán.
walk-page-plan-wrong = { $count ->
        [one] Plán má chybu: viz pohled Plán.
        [few] Plán má { $count } chyby: viz pohled Plán.
       *[other] Plán má { $count } chyb: viz pohled Plán.
    }
walk-page-not-saved = Plán má neuložené změny: přerušený díl nelze po restartu obnovit.
walk-page-serial = Sériové číslo
walk-page-serial-again = Sériové číslo { $serial } už bylo měřeno. Chcete-li je začít znovu, stiskněte po půl sekundě opět Enter.
walk-page-serial-hint = Zadejte je, naskenujte, nebo použijte další číslo; Enter začne díl.
walk-page-recent = Nedávné plány
walk-page-done = Každý rozměr má hodnotu nebo je přeskočen
walk-page-part = { $part }, sériové číslo { $serial }
walk-page-part-serial = Sériové číslo { $serial }
walk-page-part-no-serial = { $part }, bez sériového čísla
walk-page-other-plan = Plán se mezitím změnil: změny platí od dalšího dílu.
walk-page-part-of = Tento díl se měří podle { $own }
walk-page-open-is = Nyní otevřeno: { $open }
walk-page-begin-by = Začít díl podle { $open }
walk-page-keep-on = Pokračovat v měření dílu
walk-page-unfinished = Díl měřený podle { $own } není dokončen. Pohled Měřit se zeptá, zda v něm pokračovat.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = V plánu není poloha
walk-page-value = Naměřená hodnota
walk-page-measured-before = { $count ->
        [one] Změřeno jednou: obě hodnoty se uchovají a použije se nová
       *[other] Změřeno { $count }krát: všechny hodnoty se uchovají a použije se nová
    }
walk-page-last-counts = Změřeno { $count }krát: všechny hodnoty se uchovají a použije se tato
walk-page-skip-why = Důvod přeskočení
walk-page-skip-access = Sonda nemá přístup
walk-page-skip-gauge = Chybí měřidlo
walk-page-skip-machined = Ještě neobrobeno
walk-page-skip-elsewhere = Měří se jinde
walk-page-reason = Jiný důvod
walk-page-no-reason = je nutný důvod
walk-page-skipped = přeskočeno: { $reason }
walk-page-next-warned = { $count ->
        [one] Jeden rozměr nemá hodnotu ani důvod. Chcete-li díl ukončit, zvolte znovu Další díl.
        [few] { $count } rozměry nemají hodnotu ani důvod. Chcete-li díl ukončit, zvolte znovu Další díl.
       *[other] { $count } rozměrů nemá hodnotu ani důvod. Chcete-li díl ukončit, zvolte znovu Další díl.
    }
walk-page-typed-elsewhere = hodnota byla zadána pro { $name }, nyní se však žádá { $asked }: zadejte ji znovu
walk-page-next-size = Další: { $name }, { $asked }
walk-page-is-serial = { $given } vypadá jako sériové číslo a nepřebírá se jako hodnota: nejprve tento díl dokončete, pak je naskenujte pro další díl. Je-li to naměřená hodnota, zadejte ji s více desetinnými místy
walk-page-simulate-measured = { $name }: změřeno; simulovaná hodnota nikdy nenahradí naměřenou
walk-page-part-status = Stav dílu
walk-page-not-complete = Zatím bez výroku
walk-page-simulated = { $count ->
        [one] Jedna hodnota je simulovaná: nikdo ji neměřil, díl s ní proto nemůže být dobrý.
        [few] { $count } hodnoty jsou simulované: nikdo je neměřil, díl s nimi proto nemůže být dobrý.
       *[other] { $count } hodnot je simulovaných: nikdo je neměřil, díl s nimi proto nemůže být dobrý.
    }
walk-page-missing = Chybí: { $names }
walk-page-off = Záznamy jsou vypnuty: přerušený díl nelze po restartu obnovit.
walk-page-nowhere = Nic se nezaznamenává: přerušený díl nelze po restartu obnovit.
walk-page-no-part = Neměří se žádný díl.
walk-page-sizes = Rozměry dílu
walk-page-open = nezměřeno
walk-page-row-simulated = simulováno
walk-page-times = hodnot: { $count }
walk-page-rule-plan = Posouzeno podle pravidla plánu: { $rule }
walk-page-rule-own = Plán nemá pravidlo; posouzeno podle pravidla na stránce Kontrola: { $rule }
walk-page-nothing-asked = neměří se žádný rozměr plánu
walk-page-refused = { $count ->
        [one] Jedna kontrola nebyla zaznamenána: { $why }
        [few] { $count } kontroly nebyly zaznamenány: { $why }
       *[other] { $count } kontrol nebylo zaznamenáno: { $why }
    }
walk-page-import-late = { $name }: přečteno až po ukončení dílu, hodnoty se nepoužijí
walk-page-imported = { $name }: importováno { $good }, neimportováno { $bad }
walk-page-file-for-check = Nic v něm nepatří k tomuto plánu. Stránka Kontrola může soubor posoudit podle jeho vlastních předpisů
walk-page-found-by-name = { $count ->
    [one] Přiřazen podle názvu: 1 řádek
    [few] Přiřazeny podle názvu: { $count } řádky
   *[other] Přiřazeno podle názvu: { $count } řádků
}
walk-page-found-by-number = Přiřazeno jen podle čísla, s jejich řádky: { $rows }
walk-page-found-by-place = Přiřazeno podle polohy, s jejich řádky: { $rows }
walk-page-other-parts = Hodnoty jiných dílů se zaznamenávají pod jejich sériovými čísly: { $serials }
walk-page-label = Soubor nemá sériová čísla a označuje díl jako { $part }: jeho hodnoty se berou pro tento díl
walk-page-other-label = patří k dílu { $part } a bez sériového čísla není jisté, že je to tento díl
walk-page-remark-label = Díl v souboru: { $part }
walk-page-not-judged = řádek { $line }: { $why }
walk-page-no-journal = Díl { $serial } byl obnoven bez hodnot: nejsou záznamy, ze kterých by se obnovily
walk-page-gone = Některé rozměry už v plánu nejsou: jejich naměřené hodnoty zůstávají v záznamech
walk-page-gone-name = { $name }
walk-page-changed = Plán se změnil: hodnoty posouzené podle jiných mezí nebo jiného pravidla a hodnoty řádků bez názvu zůstávají v záznamech a jejich rozměry je třeba změřit znovu
walk-page-changed-size = { $name }: { $measured } mm bylo měřeno podle { $asked }
walk-page-given-up = Přerušený díl { $serial } se neobnoví, protože byl začat jiný díl: jeho hodnoty zůstávají v záznamech
walk-page-ended = Nepoužito pro díl { $serial }, který je ukončen
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = Hodnota rozměru { $name } byla v záznamech korigována nebo odvolána: pro tento díl už neplatí
walk-page-put-right = Hodnota rozměru { $name } byla v záznamech korigována: pro tento díl platí korigovaná
walk-page-no-folder = { $path } není složka
walk-page-not-read = Hodnoty přerušeného dílu nelze přečíst: { $why }
walk-page-came-back = { $count ->
        [one] Přerušený díl { $serial } byl obnoven s jednou hodnotou
       *[other] Přerušený díl { $serial } byl obnoven, počet hodnot: { $count }
    }
walk-page-watched = Sledovaná složka
walk-page-part-waits = Díl { $serial } se obnoví, až bude jeho plán bez chyb
walk-page-watch-waits = Složka { $path } se začne znovu sledovat, až bude plán bez chyb
walk-page-watch-no-plan = ke sledování složky je třeba plán bez chyb: nejprve jej otevřete
walk-page-watch-no-journal = deník nelze otevřít: není známo, které soubory byly importovány dříve, žádná složka se proto nesleduje
walk-page-watch-begins = V deníku se zjišťují dříve importované soubory
walk-page-known = { $count ->
        [0] V deníku nejsou žádné dříve importované soubory
        [one] V deníku je jeden dříve importovaný soubor, z libovolné složky: znovu se neimportuje
        [few] V deníku jsou { $count } dříve importované soubory a části souborů, z libovolné složky: znovu se neimportují
       *[other] V deníku je { $count } dříve importovaných souborů a částí souborů, z libovolné složky: znovu se neimportují
    }
walk-page-mask = Výstup FN 16 se čte zpět přes masku { $name }
walk-page-watch-recording = Zaznamenává se
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] Importován jeden soubor
        [few] Importovány { $count } soubory
       *[other] Importováno { $count } souborů
    }
walk-page-report = Zpráva…
walk-page-report-people = Zpráva o kontrole ({ $format })…
walk-page-report-programs = Hodnoty dílu jako { $format }…
walk-page-contradicted = { $names }: hodnoty si odporují a nic neříká, která je správná. Platí nejhorší, dokud nepřeměříte nebo nevyberete.
walk-page-contradicting = { $name } má hodnoty, které si odporují: { $values }. Platí nejhorší, dokud nepřeměříte nebo nevyberete.
walk-page-count-newest = Platí poslední hodnota
walk-page-newest-counts = { $name }: platí poslední hodnota, podle volby
walk-page-accepted = Přijato mimo meze: { $names }
walk-page-because = Kvůli: { $names }
walk-page-left-out = Přeskočeno: { $names }. Díl s přeskočenými rozměry nemůže být dobrý.
walk-page-whole = Celý díl
walk-page-whole-serial = Díl { $serial }
walk-page-strip-open = Díl: zatím bez výroku
walk-page-strip-part = Díl: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Měřeno podle plánu { $name }
walk-page-judged-by-plan = Posouzeno podle plánu { $name }
walk-page-watch-no-mask = Vlastní masku { $path } nelze přečíst: složka se začne sledovat, až tuto masku vyberete znovu, nebo vyberete jinou (Nabídka, Vlastní maska…)
walk-page-watch-nobody = { $count ->
        [one] Jedna hodnota je zaznamenána bez sériového čísla: její soubor žádné neuvádí a podle tohoto plánu se žádný díl neměří
        [few] { $count } hodnoty jsou zaznamenány bez sériového čísla: jejich soubor žádné neuvádí a podle tohoto plánu se žádný díl neměří
       *[other] { $count } hodnot je zaznamenáno bez sériového čísla: jejich soubor žádné neuvádí a podle tohoto plánu se žádný díl neměří
    }
walk-page-watch-other-plan = Složka se posuzuje podle plánu, jaký byl na začátku sledování. Chcete-li posuzovat podle současného plánu, začněte díl nebo začněte složku sledovat znovu.
walk-page-watch-not-saved = Plán má neuložené změny: po restartu se složka už nesleduje.
walk-page-values = Hodnoty: { $name }
walk-page-to-do = { $name }: { $what }
walk-page-of = rozměr { $at } z { $count }
walk-page-no-serial = Bez sériového čísla
