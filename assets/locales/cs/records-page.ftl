page-records = Záznamy

## What is recorded with a check
records-page-fold = Záznam
records-page-fold-hint = Sériové číslo a poznámka se zaznamenají s dalšími kontrolami
records-page-serial = Sériové číslo
records-page-serial-short = Sér. č.
records-page-remark = Poznámka
records-page-feature = Prvek
records-page-record = Záznam { $number }
records-page-waiting = Zaznamenává se
records-page-not-recorded = Nezaznamenáno: { $why }
records-page-nowhere = Kontroly se nezaznamenávají: není pro ně žádná datová složka
records-page-off = Kontroly se nezaznamenávají: zaznamenávání je ve stavovém souboru vypnuto
records-page-opening = Otevírá se deník
records-page-how-on = Oddíl [records] stavového souboru state.toml udává soubor deníku a zda se kontroly zaznamenávají.
records-page-not-opened = Deník nelze otevřít a kontroly se nezaznamenávají: { $why }
records-page-not-kept = { $count ->
    [one] 1 kontrola není zaznamenána: { $why }
    [few] { $count } kontroly nejsou zaznamenány: { $why }
   *[other] { $count } kontrol není zaznamenáno: { $why }
}
records-page-refused = { $count ->
    [one] 1 kontrolu nelze zaznamenat: { $why }
    [few] { $count } kontroly nelze zaznamenat; důvod u první: { $why }
   *[other] { $count } kontrol nelze zaznamenat; důvod u první: { $why }
}
records-page-not-kept-why = deník neodpověděl
records-page-no-thread = systém nemůže pro deník spustit vlákno
records-page-interrupted = bylo přerušeno
records-page-failed = { $count ->
    [one] 1 kontrola není zaznamenána
    [few] { $count } kontroly nejsou zaznamenány
   *[other] { $count } kontrol není zaznamenáno
}
records-page-try-again = Zkusit znovu
records-page-stay = Záznamy zůstávají v deníku
records-page-leave = { $count ->
    [one] 1 kontrola ještě není zaznamenána. Zavřením okna se ztratí.
    [few] { $count } kontroly ještě nejsou zaznamenány. Zavřením okna se ztratí.
   *[other] { $count } kontrol ještě není zaznamenáno. Zavřením okna se ztratí.
}

## Who is measuring
records-page-who = Měřil
records-page-nobody = Jméno…
records-page-who-nobody = Není zvoleno žádné jméno. Zvolte jméno
records-page-who-is = Měří { $name }
records-page-nobody-named = Bez jména
records-page-new-name = Jiné jméno
records-page-take-name = Použít toto jméno

## The question
records-page-question = Hledat
records-page-help = Slova, dobrý oprava zmetek, nebo part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = Další
records-page-today = Dnes
records-page-this-week = Tento týden
records-page-not-good = Kromě dobrých
records-page-measured-only = Jen měřené
records-page-filter = Filtr
records-page-filter-hint = Zúží seznam podle dílu, sériového čísla, data a dalšího
records-page-add-filter = Přidat filtr
records-page-filter-by = Filtrovat podle
records-page-filter-value = Hodnota
records-page-from = Od
records-page-to = Do
records-page-standing = Jen platné
records-page-simulated-only = Jen simulované
records-page-reports-only = Jen zprávy
records-page-alarms-only = Jen výstrahy
records-page-checks-only = Bez zpráv
records-page-remove-filter = Odebrat filtr { $filter }
records-page-looking = Hledá se
records-page-count = { $many ->
    [one] 1 záznam
    [few] { $count } záznamy
   *[other] { $count } záznamů
}
records-page-more = { $count }+ záznamů
records-page-unread = Deník nelze přečíst: { $why }
records-page-none = není otevřen žádný deník
records-page-missing = Chybí záznam { $number }
records-page-empty = Zde se zobrazí zaznamenané kontroly
records-page-none-found = Neodpovídá žádný záznam

## The list
records-page-list = Záznamy
records-page-head-number = Č.
records-page-zone = V tol. poli
records-page-move = Přejít na jiný záznam
records-page-open = Otevřít záznam
records-page-choose = Vybrat do zprávy
records-page-choose-record = Vybrat záznam { $number } do zprávy
records-page-chosen = { $count ->
    [one] 1 vybraný
    [few] { $count } vybrané
   *[other] { $count } vybraných
}
records-page-copy = Kopírovat
records-page-report-of = Zpráva ({ $count })…
records-page-reports-listed = Zpráva obsahuje všechny záznamy ze seznamu: { $count }
records-page-reports-chosen = Zpráva obsahuje vybrané záznamy: { $count }
records-page-too-many = V seznamu je záznamů: { $count }. Zpráva nebo výběr pojme nejvýše { $most }: zužte seznam, například podle dílu nebo data
records-page-still-looking = Seznam ještě není úplný. Zkuste to znovu, až bude zobrazen počet
records-page-nothing-to-report = Žádný záznam ze seznamu nelze dát do zprávy: jsou neplatné, simulované nebo z cyklů
records-page-report = Zpráva…
records-page-with-simulated = Včetně simulovaných kontrol
records-page-with-simulated-hint = Simulované kontroly nejsou důkazem; zpráva uvede, že nějaké obsahuje
records-page-report-simulated = { $count ->
    [one] 1 z těchto kontrol je simulovaná: není důkazem
    [few] { $count } z těchto kontrol jsou simulované: nejsou důkazem
   *[other] { $count } z těchto kontrol je simulovaných: nejsou důkazem
}
records-page-report-from = Z deníku { $chain }, záznamy { $numbers }; jeho nejnovější zápis je { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] 1 simulovaná kontrola je vynechána
    [few] { $count } simulované kontroly jsou vynechány
   *[other] { $count } simulovaných kontrol je vynecháno
}
records-page-out-replaced = { $count ->
    [one] 1 korigovaný nebo odvolaný záznam je vynechán
    [few] { $count } korigované nebo odvolané záznamy jsou vynechány
   *[other] { $count } korigovaných nebo odvolaných záznamů je vynecháno
}
records-page-report-corrects = { $count ->
    [one] 1 hodnota nahrazuje korigovaný záznam
    [few] { $count } hodnoty nahrazují korigované záznamy
   *[other] { $count } hodnot nahrazuje korigované záznamy
}
records-page-out-cycles = { $count ->
    [one] 1 záznam cyklu je vynechán
    [few] { $count } záznamy cyklů jsou vynechány
   *[other] { $count } záznamů cyklů je vynecháno
}
records-page-out-reports = { $count ->
    [one] 1 zpráva nebo výstraha je vynechána: není to kontrola
    [few] { $count } zprávy a výstrahy jsou vynechány: nejsou to kontroly
    [many] { $count } zprávy a výstrahy je vynecháno: nejsou to kontroly
   *[other] { $count } zpráv a výstrah je vynecháno: nejsou to kontroly
}
records-page-out-unread = { $count ->
    [one] 1 nečitelný záznam je vynechán
    [few] { $count } nečitelné záznamy jsou vynechány
   *[other] { $count } nečitelných záznamů je vynecháno
}
records-page-see = Neplatný, viz { $number }
records-page-void = Záznam { $number }, neplatný: viz { $by }
records-page-instead = místo { $number }
records-page-takes-back = Odvolává { $number }
records-page-withdrawal = Odvolání
records-page-report-entry = Zpráva
records-page-alarm = Výstraha
records-page-alarm-answers = Odpověď na výstrahu { $number }
records-page-alarm-answered = Výstraha, odpověď { $number }
records-page-alarm-first = První hodnota: { $number }
records-page-alarm-last = Hodnota, při níž pravidlo zasáhlo: { $number }
records-page-cycle = Cyklus { $cycle }
records-page-went-back = { $time } (hodiny)

## An open record
records-page-close = Zpět na seznam
records-page-reading = Čte se záznam
records-page-measure-again = Přeměřit
records-page-measure-again-hint = Přenese předpis, díl, sériové číslo a pravidlo na stránku Kontrola
records-page-correct = Korigovat…
records-page-correct-hint = Přidá záznam místo tohoto; oba zůstanou
records-page-simulated = Simulováno: nikdo to neměřil
records-page-corrected-by = Korigován nebo odvolán záznamem { $number }
records-page-corrects = Místo záznamu { $number }
records-page-in-report = Ve zprávě { $number }, { $name }
records-page-reports-unread = Zprávy s touto kontrolou nelze přečíst: { $why }
records-page-report-unknown = { $name } je zapsán, ale deník jej nezná: { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, díra
    [neither] { $callout }, ani díra, ani hřídel
   *[shaft] { $callout }, hřídel
}
records-page-distance = Od mezí
records-page-importer = Importoval
records-page-void-why = Neplatný, protože
records-page-void-by = Korigoval nebo odvolal
records-page-decided = Rozhodnutí
records-page-limits = Meze
records-page-source = Zdroj mezí
records-page-contacts = Body dotyku
records-page-rule = Pravidlo
records-page-station = Stanice
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = Hodiny stanice byly před tímto záznamem posunuty zpět
records-page-cycle-number = Cyklus
records-page-program = Program
records-page-block = { $program }, řádek { $line }
records-page-datum = Vztažný bod
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, nastaveno na řádku { $line }: { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = osy natočené o { $angle }°, od řádku { $line }: { $block }
records-page-datum-tilt = rovina naklopená o A { $a }°, B { $b }°, C { $c }°, od řádku { $line }: { $block }
records-page-parameters = Parametry
records-page-figures = Výsledky
records-page-file-measurements = Měření
records-page-file-program = Program
records-page-file-workpiece = Obrobek
records-page-file-budget = Bilance nejistot
records-page-report-file = Soubor
records-page-report-format = Formát
records-page-report-size = Velikost
records-page-report-bytes = { $count } B
records-page-report-title = Název
records-page-report-sha256 = SHA-256
records-page-report-checks = Zaznamenané kontroly
records-page-report-numbers = Jejich záznamy
records-page-report-unrecorded = Kontroly bez záznamu
records-page-report-head = Tehdy nejnovější zápis
records-page-chain = Řetěz
records-page-chain-name = Deník
records-page-hash = Hash

## A correction
records-page-correction = Korigovat záznam { $number }
records-page-correction-rule = Posouzeno znovu stejně jako záznam { $number }: { $rule }.
records-page-correction-temperature = Přepočteno z { $temperature } °C na 20 °C.
records-page-correction-rest = Díl, sériové číslo, jméno
records-page-correction-hint = Místo tohoto záznamu nastoupí nový. Oba zůstanou v deníku.
records-page-corrector = Koriguje
records-page-reason = Důvod
records-page-reason-mistyped = překlep
records-page-reason-wrong-part = nesprávný díl
records-page-reason-trial = zkouška
records-page-withdrawal-hint = Záznam už neplatí a nic jej nenahradí. Oba zápisy zůstanou v deníku.
records-page-withdraw = Odvolat záznam
records-page-withdraw-hint = Nic jej nenahradí
records-page-withdraw-neither = Záznam { $number }, který je tímto korigován, tím znovu nezačne platit
records-page-send-correction = Zaznamenat korekci
records-page-leave-correction = Zrušit
records-page-undo-void = Nevráceno zpět: záznam byl po korekci odvolán
records-page-undone-reason = vráceno zpět
records-page-taken-back = { $checks ->
    [one] Vzata zpět 1 kontrola
    [few] Vzaty zpět { $checks } kontroly
   *[other] Vzato zpět { $checks } kontrol
}; { $records ->
    [one] odvolán záznam { $numbers }
   *[other] odvolány záznamy { $numbers }
}
records-page-taken-back-unwritten = { $checks ->
    [one] Vzata zpět 1 kontrola; ještě nebyla zaznamenána a nebude
    [few] Vzaty zpět { $checks } kontroly; ještě nebyly zaznamenány a nebudou
   *[other] Vzato zpět { $checks } kontrol; ještě nebyly zaznamenány a nebudou
}
records-page-not-withdrawn = { $records ->
    [one] Záznam { $numbers } dál platí a nelze jej odvolat: { $why }
   *[other] Záznamy { $numbers } dál platí a nelze je odvolat: { $why }
}
records-page-undone = Korekce vrácena zpět
records-page-no-reason = Korekce vyžaduje důvod
records-page-nothing-changed = Nic není jinak: změňte některé pole, nebo záznam odvolejte
records-page-not-open = Záznam není otevřen
records-page-not-recording = Kontroly se nezaznamenávají

## The journal
records-page-place = { $file } · zápisů: { $entries }
records-page-unsent = ještě neodesláno na { $server }: { $count }
records-page-all-sent = vše odesláno na { $server }
records-page-server-unknown = { $server } zatím není dostupný
records-page-server = Server dílny
records-page-server-hint = Odesílá každý záznam na pozadí na server PostgreSQL; bez něj vše zůstává v tomto počítači
records-page-server-address = Adresa, například postgres://mill3@shop.example/checks
records-page-server-passwords = Heslo se bere z adresy, z PGPASSWORD, ze souboru hesel nebo z klíčenky systému. Heslo v adrese se uloží do klíčenky a nikam jinam.
records-page-take-server = Použít tento server
records-page-leave-server = Neodesílat
records-page-send-again = Odeslat znovu
records-page-not-sent = Neodesláno: { $why }
records-page-and = { $one }; { $other }
records-page-no-shop = tento Fitcheck byl sestaven bez podpory serveru dílny (feature shop)
records-page-in-keyring = Heslo pro { $server } je nyní v klíčence systému
records-page-not-in-keyring = Heslo pro { $server } nelze uložit do klíčenky systému ({ $reason }): používá se do zavření okna, poté se musí brát z PGPASSWORD nebo ze souboru hesel
records-page-verify = Ověřit
records-page-verify-hint = Porovná každý zápis s předchozím
records-page-verify-cancel = Zrušit ověřování
records-page-verify-cancelled = Ověřování zrušeno
records-page-verify-progress = Průběh ověřování
records-page-verifying = { $done } z { $of } zápisů
records-page-whole = { $time }: ověřeno zápisů: { $entries }, až po { $number } ({ $hash })
records-page-broken = { $time }: prověřeno zápisů: { $entries }; deník není takový, jaký byl zapsán
records-page-not-verified = { $time }: neověřeno: { $why }
records-page-no-anchors = zápisy známé odjinud nelze přečíst: { $why }
