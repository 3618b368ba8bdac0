## The chain of a journal
journal-hex = „{ $text }“ není hexadecimální číslo s počtem číslic { $digits }
journal-break-changed = zápis { $number } není ten, který byl zapsán
journal-break-removed = { $count ->
        [one] chybí zápis { $number }
        [few] od zápisu { $number } chybí { $count } zápisy
       *[other] od zápisu { $number } chybí { $count } zápisů
    }
journal-break-inserted = zápis { $number } byl vložen
journal-break-reordered = zápisy { $number } a { $other } si vyměnily místo
journal-break-rewritten = zápis { $number } se liší od zápisu známého odjinud: deník byl přepsán od tohoto nebo dřívějšího zápisu
journal-break-cut-off = deník končí zápisem { $last }, ale odjinud je znám zápis { $known }: nejnovější zápisy byly odříznuty, nebo byla vrácena starší kopie

## Entries
journal-body-json = není to zápis deníku: { $reason }
journal-body-newer = vytvořil novější Fitcheck: verze formátu { $version }, tento Fitcheck čte verze do { $known }
journal-body-too-large = není to zápis deníku: { $bytes } bajtů, dovoleno je nejvýše { $most }
journal-body-too-long = { $field } má { $bytes } bajtů, dovoleno je nejvýše { $most }
journal-body-control = { $field } má řídicí znak { $code } na místě { $place }: texty deníku jsou jeden řádek bez řídicích znaků
journal-body-empty = { $field } je prázdné
journal-body-too-many = { $field } má { $count } položek, dovoleno je nejvýše { $most }
journal-body-value = { $field } nemůže být „{ $given }“
journal-body-contradiction = { $field } odporuje polím, ze kterých plyne
journal-origin-perfect = simulováno, obrobek bez vad
journal-origin-workpiece = simulováno, { $file }, počáteční číslo { $seed }
journal-origin-contacts = body dotyku z { $file }
journal-check-judged-otherwise = rozhodnuto jako { $kept }, což platí; tato verze Fitchecku rozhoduje { $now }

## Questions
journal-ask-at = { $reason } (znak { $at })
journal-ask-unknown-key = { $key }: není známé klíčové slovo; očekává se { $known }, nebo uvozovky kolem slova s dvojtečkou
journal-ask-no-value = { $key }: nemá hodnotu
journal-ask-empty-word = slovo v uvozovkách je prázdné
journal-ask-twice = { $key } je uvedeno dvakrát
journal-ask-not-closed = uvozovky nejsou uzavřeny
journal-ask-after-quote = za koncovými uvozovkami se očekává mezera, nalezeno { $found }
journal-ask-date = „{ $given }“ není den ani čas: očekává se 2026-11-23 nebo 2026-11-23T14:30
journal-ask-verdict = „{ $given }“ není výrok: očekává se { $known }
journal-ask-callout = { $error }; předpis se píše do uvozovek: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = období končí dříve, než začne: from musí být před to
journal-ask-both-origins = simulated a measured se vylučují
journal-ask-both-kinds = reports a checks se vylučují
journal-ask-too-long = dotaz má { $bytes } bajtů, dovoleno je nejvýše { $most }

## The journal of a station
store-missing = v { $path } není deník
store-not-a-file = { $path } není soubor
store-not-a-journal = { $path } není deník Fitchecku; zůstal beze změny
store-newer = { $path } vytvořil novější Fitcheck (verze { $version }, tento podporuje { $known }); zůstal beze změny
store-older = { $path } vytvořil starší Fitcheck: převede se, až se do něj něco zaznamená
store-damaged = { $path } je poškozen: jeho stránky si odporují
store-full = pro { $path } už není místo: nic nebylo zaznamenáno
store-read-only = do { $path } se nesmí zapisovat: nic nebylo zaznamenáno
store-locked = { $path } byl příliš dlouho uzamčen jiným programem: nic nebylo zaznamenáno
store-disk = disk s { $path } hlásí chybu: { $reason }
store-cannot-open = { $path } nelze otevřít
store-network-folder = { $path } je ve složce jiného počítače, kde by si dvě stanice mohly zápisy navzájem přepsat: zvolte složku v tomto počítači a pro dílnu server
store-altered = „{ $name }“, které chrání zápisy před změnami, v { $path } chybí nebo bylo změněno
store-no-beginning = { $path } neudává, který je to řetěz
store-moved = { $path } byl mezitím přesunut nebo odložen stranou: nic nebylo zaznamenáno
store-other-target = zápis { $number } není ten, který měl být korigován: nic nebylo zaznamenáno
store-corrected = zápis { $number } už byl korigován nebo odvolán zápisem { $by }: korigujte ten, pokud to není odvolání
store-is-report = zápis { $number } je zpráva: říká, který soubor byl zapsán, a nelze jej korigovat ani odvolat
store-is-alarm = zápis { $number } je výstraha regulačního diagramu: říká, které pravidlo zasáhlo, a nelze jej korigovat ani odvolat; odpovězte na ni
store-no-alarm = zápis { $number } není výstraha regulačního diagramu: odpovědět lze jen na ni
journal-alarm-since-part = { $rule }, od dílu { $serial }
journal-alarm-since-entry = { $rule }, od záznamu { $number }
store-other-journal = zápis { $number } tohoto deníku není ten, který uvádí zpráva: nic nebylo zaznamenáno
store-finding-no-beginning = deník nemá první zápis, který pojmenovává jeho řetěz
store-finding-pages = stránky deníku si odporují a dotazy nemusí najít zápisy, které v něm jsou: { $reason }
store-finding-index = rejstřík pro dotazy neodpovídá své tabulce: { $reason }
store-hidden = zápis { $number } v { $path } není na svém místě: deník byl změněn nebo je jeho soubor poškozen; spusťte fitcheck journal verify
store-no-entry = { $path } nemá zápis { $number }: poslední je { $last }
store-backup = kopie { $path } byla neúplná a byla odstraněna
store-interrupted = zastaveno
store-database = { $path }: { $reason }
store-remark-begun = byl vytvořen nový deník: { $path }
store-remark-set-aside = deník { $path } byl poškozen: je nyní beze změny v { $folder } a na jeho místě byl vytvořen nový
store-remark-migrated = { $path } byl převeden na tuto verzi; soubor v původní podobě je { $copy }
store-remark-behind = { $path } končí zápisem { $last }, ale kdysi měl zápis { $known }: nejnovější zápisy byly odříznuty, nebo byla vrácena starší kopie
store-remark-other = zápis { $number } v { $path } se liší od původního: deník byl přepsán od tohoto nebo dřívějšího zápisu
store-remark-replaced = { $path } není deník, který tam byl dříve a měl zápisů { $known }
store-remark-waits = do { $path } zapisuje jiný program: čeká se na dokončení
store-remark-no-anchor = poslední zápis tohoto deníku nelze poznamenat do { $path }: { $reason }
store-finding-altered = „{ $name }“, které chrání zápisy před změnami, chybí nebo bylo změněno
store-finding-not-found = { $entries ->
        [one] 1 zápis je v rejstříku pod něčím jiným, než udává, nebo v něm není
        [few] { $entries } zápisy jsou v rejstříku pod něčím jiným, než udávají, nebo v něm nejsou
       *[other] { $entries } zápisů je v rejstříku pod něčím jiným, než udávají, nebo v něm nejsou
    }
