# report

## Errors
report-error-writer = zprávu { $format } nelze vytvořit: { $reason }
report-error-label-alone = { $format } je pro štítky: zvolte šablonu label nebo papír small-label či large-label
report-error-no-statistics = { $format } nemá místo pro statistiku: zvolte PDF, HTML nebo Markdown
report-attachment-too-large = data souboru jsou větší než { $most } bajtů
report-attachment-packed = data v souboru jsou zabalena metodou { $filter }, kterou Fitcheck nečte
report-attachment-damaged = data v souboru jsou poškozena: { $reason }
report-attachment-several = počet příloh s kontrolami v souboru: { $count }, očekává se jedna
report-difference-field = zápis { $number }: { $field } je v souboru { $said }, v deníku { $kept }
report-difference-missing = zápis { $number }: žádná kontrola v souboru neříká to, co deník
report-difference-more = { $count ->
    [one] v souboru je o 1 kontrolu více
    [few] v souboru je o { $count } kontroly více
    [many] v souboru je o { $count } kontroly více
   *[other] v souboru je o { $count } kontrol více
}
report-difference-fewer = { $count ->
    [one] v souboru chybí 1 kontrola
    [few] v souboru chybí { $count } kontroly
    [many] v souboru chybí { $count } kontroly
   *[other] v souboru chybí { $count } kontrol
}
report-data-json = data souboru nejsou zpráva programu Fitcheck: { $reason }
report-ending-missing = { $file } nemá příponu, která určuje formát zprávy: použijte jednu z { $endings }
report-ending-unknown = .{ $ending } není formát zprávy: použijte jednu z přípon { $endings }

## Sentences about one check
report-feature-hole = díra
report-feature-shaft = hřídel
report-feature-neither = ani díra, ani hřídel
report-side-good = dobrý
report-side-rework = oprava
report-side-scrap = zmetek
report-side-out = mimo toleranci
report-side-too-small = příliš malý
report-side-too-large = příliš velký
report-source-instead = { $source }; ISO 286 zde udává { $upper } a { $lower } µm
report-too-small = o { $um } µm menší
report-too-large = o { $um } µm větší
report-inside = v mezích
report-above-minimum = { $um } µm nad minimem
report-below-minimum = { $um } µm pod minimem
report-below-maximum = { $um } µm pod maximem
report-above-maximum = { $um } µm nad maximem
report-position-unknown = neměřeno
report-position-unmonitored = nehlídáno
report-position-in = UVNITŘ
report-position-out = MIMO
report-axis-unmonitored = { $axis } { $deviation } mm: nehlídáno
report-axis-in = { $axis } { $deviation } mm, dovoleno ± { $tolerance } mm: UVNITŘ
report-axis-out = { $axis } { $deviation } mm, dovoleno ± { $tolerance } mm: MIMO
report-cause-position = poloha středu je mimo toleranci; samotný rozměr: { $status }
report-origin-circle = { $origin }; kružnice nejmenších čtverců, bodů dotyku: { $contacts }
report-centre = naměřený střed X { $x } mm, Y { $y } mm
report-band-nominal = jmenovitý rozměr { $size } mm
report-band-title = Pás mezí, naměřeno { $value }: { $distances }
report-in-guard-band = nic není rozhodnuto: hodnota leží v ochranném pásmu rozhodovacího pravidla
report-corrected = naměřeno { $measured } mm při { $temperature } °C, roztažnost { $expansion } · 10⁻⁶/K: přepočteno o { $change } µm na { $reference } mm při 20 °C
report-all-corrected = měřeno při { $temperature } °C, roztažnost { $expansion } · 10⁻⁶/K; každá hodnota je přepočtena na 20 °C
report-scales = odměřování při { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = bez přepočtu odměřování
report-own-uncertainty = u každé hodnoty u její kontroly
report-accepted-zone = { $least } až { $most } mm
report-accepted-none = žádné: pravidlo z této tolerance nic nenechává
report-proven = podle tohoto pravidla prokázáno
report-not-proven = podle tohoto pravidla neprokázáno
report-conformity = shoda s pravděpodobností { $percent } %
report-budget-made = { $name }, vytvořil { $by } dne { $date }, platí do { $until }
report-budget-expired = v den kontroly PROŠLÁ
report-budget-not-yet = v den kontroly JEŠTĚ NEPLATÍ
report-guard-undecided = ochranné pásmo: přeměřit
report-guard-beyond = ochranné pásmo: přijato za mezí
report-guard-range = { $what }, { $from } až { $to } µm

## The page
report-title = Zpráva o kontrole
report-part = Díl
report-order = Zakázka
report-inspector = Kontroloval
report-program = Program
report-notes = Přeskočené řádky a varování
report-no-checks = Tato zpráva neobsahuje žádné kontroly.
report-page-all-good = Na této stránce není vypsána žádná z kontrol ({ $total }): všechny jsou dobré a žádná není pochybná. Zpráva CSV nebo JSON obsahuje každou kontrolu.
report-page-not-good = Na této stránce je vypsáno jen { $listed } z { $total } kontrol, které nejsou dobré nebo jsou pochybné. Počty zahrnují každou kontrolu; zpráva CSV nebo JSON je obsahuje všechny.
report-page-first = Na této stránce je vypsáno jen prvních { $listed } z { $wanted } kontrol, které nejsou dobré nebo jsou pochybné, celkem kontrol: { $total }. Počty zahrnují každou kontrolu; zpráva CSV nebo JSON je obsahuje všechny.
report-total = Celkem
report-check = Kontrola
report-id = Název
report-callout = Předpis
report-heading-without-callout = { $nominal } mm, meze bez třídy
report-verdict = Výrok
report-nominal = Jmenovitý rozměr
report-maximum = Maximum
report-minimum = Minimum
report-measured = Naměřeno
report-deviation = Úchylka
report-remove = Odebrat
report-on-diameter = na průměr
report-per-side = na stranu
report-remove-to-limit = k nejbližší mezi
report-remove-to-middle = do středu tolerančního pole
report-remove-to-accepted = k přijímaným hodnotám
report-position = Poloha
report-limits-from = Zdroj mezí
report-measured-from = Naměřená hodnota
report-from = Zdroj
report-limits = Meze
report-missing = Chybí
report-skipped = Přeskočeno
report-verdict-from = Rozhodovací pravidlo
report-temperature = Teplota
report-accepted = Přijímané hodnoty
report-proof = Důkaz
report-budget = Bilance nejistot
report-cannot-tell = Omezení tohoto měření
report-contacts = Body dotyku
report-contacts-at-end = na konci zprávy
report-contact = Č.
report-radial = radiální úchylka
report-sign-name = Jméno
report-sign-date = Datum
report-sign-signature = Podpis
report-footer = Každý výrok vychází z nezaokrouhlených hodnot a z mezí a rozhodovacího pravidla u něj uvedených.

## Notes
report-note = { $place }: { $what }
report-note-line = { $place }, řádek { $line }: { $what }
report-note-more = { $count ->
    [one] 1 další hlášení není vypsáno
    [few] { $count } další hlášení nejsou vypsána
   *[other] { $count } dalších hlášení není vypsáno
}

## A whole part
report-balloon = Bublina
report-picture-room = { $name } zde není zobrazen: obrázky všech dílů by stránku příliš zvětšily
report-picture-beside = { $count ->
    [one] jeden prvek na něm nemá bublinu
    [few] { $count } prvky na něm nemají bublinu
   *[other] { $count } prvků na něm nemá bublinu
}
report-part-older = { $count ->
    [one] Jedna další hodnota není vypsána: u každého rozměru je jen platná hodnota
    [few] { $count } další hodnoty nejsou vypsány: u každého rozměru je jen platná hodnota
   *[other] { $count } dalších hodnot není vypsáno: u každého rozměru je jen platná hodnota
}
report-more-parts = { $count ->
    [one] Jeden další díl není zobrazen celý; jeho hodnoty jsou v seznamu
    [few] { $count } další díly nejsou zobrazeny celé, celých je jen prvních { $most }; jejich hodnoty jsou v seznamu
   *[other] { $count } dalších dílů není zobrazeno celých, celých je jen prvních { $most }; jejich hodnoty jsou v seznamu
}

## Šablony zpráv
report-template-toml = { $reason }
report-template-version = verze šablony { $found } není podporována: očekává se verze { $known }
report-template-too-large = šablona má nejvýše { $most } bajtů
report-template-text = { $key } je prázdné, delší než { $longest } znaků nebo obsahuje řídicí znak
report-template-twice = { $key } uvádí { $word } dvakrát
report-template-empty = { $key } je prázdné: je třeba aspoň jedna položka
report-template-language = { $given } není jazyk zpráv: použijte jeden z { $known }
report-template-logo = logo { $given } musí být název souboru vedle šablony
report-section-verdict = Výrok
report-section-head = Záhlaví
report-section-picture = Obrázek s bublinami
report-section-lot = Díly, nejhorší první
report-section-statistics = Statistika prvků
report-statistics-limits = Meze nejsou u všech hodnot stejné: způsobilost se neuvádí.
report-statistics-most = Statistika má jen prvních { $count } hodnot.
report-section-features = Hodnoty
report-section-statement = Prohlášení o shodě
report-section-rule = Pravidlo a meze slovy
report-section-caveats = Omezení měření
report-section-remarks = Poznámky
report-section-signature = Řádek podpisu
report-section-code = Kód záznamu
report-revision = Revize
report-serial = Sériové číslo
report-batch = Dávka
report-customer = Zákazník
report-material = Materiál
report-station = Stanoviště
report-instrument = Měřidlo
report-calibrated = Kalibrováno
report-date = Datum
report-plan = Plán
report-records = Záznamy
report-blank = Hodnota
report-remark = Poznámka
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Štítek 62 × 29 mm
report-paper-large-label = Štítek 100 × 50 mm
report-template-inspection = Zpráva o kontrole
report-template-inspection-purpose = Díly nebo kontroly, s obrázky
report-template-first-article = První kus
report-template-first-article-purpose = Každý prvek, i co chybí
report-template-certificate = Osvědčení
report-template-certificate-purpose = Hodnoty a prohlášení o shodě
report-template-list = Seznam kontrol
report-template-list-purpose = Všechny kontroly pod sebou
report-template-statistics = Statistika
report-template-statistics-purpose = Každý prvek přes všechny hodnoty, s diagramy
report-template-sheet = Měřicí list
report-template-sheet-purpose = Prázdný, k ručnímu vyplnění
report-template-label = Štítek
report-template-label-purpose = Výrok, díl a sériové číslo
## Stránky k tisku
report-pdf-page = Strana { $page } z { $pages }
report-pdf-band = Pás mezí
report-pdf-remove = { $name }: odebrat { $um } µm na průměr
report-pdf-simulated = Simulované hodnoty, které nikdo neměřil: { $count } z { $total }
report-pdf-beyond = Hodnoty, které rozhodovací pravidlo přijímá mimo meze: { $count } z { $total }
report-pdf-corrected = Hodnoty opravené na 20 °C: { $count } z { $total }
report-pdf-guarded = Hodnoty s vlastním rozhodovacím pravidlem: { $count } z { $total }
report-pdf-doubted = Pochybné hodnoty, označené otazníkem: { $count } z { $total }
report-pdf-notes = Přeskočené řádky a varování, vypsané na konci: { $count }
report-pdf-more-lacks = Další na stránkách dílů: { $count }
report-pdf-more = Další v připojených datech: { $count }
report-pdf-all-checks = Všechny kontroly
report-pdf-attached = Připojeno k tomuto souboru, pro programy: { $names }
report-pdf-not-attached = Nejsou připojena všechna data: soubor větší než { $most } MB by byl příliš velký
report-pdf-contacts = Body dotyku jsou v připojených datech.
report-pdf-cut = Text, který končí …, je zde zkrácen; v připojených datech je celý.
report-pdf-substituted = □ zastupuje znak, který písma těchto stránek nemají, například znaky psané zprava doleva; zkopírovaný text a připojená data tento znak obsahují.
report-statement-conforms = { $count ->
    [one] Prohlášení o shodě: hodnota leží v mezích podle uvedeného rozhodovacího pravidla.
    [few] Prohlášení o shodě: všechny hodnoty ({ $count }) leží v mezích podle uvedeného rozhodovacího pravidla.
   *[other] Prohlášení o shodě: všechny hodnoty ({ $count }) leží v mezích podle uvedeného rozhodovacího pravidla.
}
report-statement-not = { $count ->
    [one] Bez shody: hodnota nevyhovuje podle uvedeného rozhodovacího pravidla.
    [few] Bez shody: { $bad } z { $count } hodnot nevyhovuje podle uvedeného rozhodovacího pravidla.
   *[other] Bez shody: { $bad } z { $count } hodnot nevyhovuje podle uvedeného rozhodovacího pravidla.
}
report-statement-partial = Bez prohlášení o shodě: některé řádky byly odmítnuty, neposouzeny nebo nepřečteny. Zpráva je uvádí.
report-statement-simulated = { $count ->
    [one] Bez prohlášení o shodě: jedna hodnota je simulovaná a nikdo ji neměřil.
    [few] Bez prohlášení o shodě: { $count } hodnot je simulovaných a nikdo je neměřil.
   *[other] Bez prohlášení o shodě: { $count } hodnot je simulovaných a nikdo je neměřil.
}
report-statement-open = Bez prohlášení o shodě: chybějí hodnoty, celkem { $count }.
report-code-said = Kód záznamu { $number }, jeho otisk { $hash }
report-lot-order = Nejhorší díl je první.
## Sešit
report-sheets = Vlastní list má jen prvních { $listed } z { $total } dílů; list dílů je obsahuje všechny.
report-sheets-corrected = korigováno na 20 °C
report-sheets-without = Obrázky a body dotyku v tomto sešitu nejsou: zpráva HTML obsahuje obojí, zpráva JSON body dotyku.
report-sheets-cut = { $count ->
    [one] Jeden text je zkrácen: do buňky se vejde nejvýše 32767 znaků.
    [few] { $count } texty jsou zkráceny: do buňky se vejde nejvýše 32767 znaků.
   *[other] { $count } textů je zkráceno: do buňky se vejde nejvýše 32767 znaků.
}
report-journal = Záznamy { $numbers } deníku { $chain }; jeho poslední záznam tehdy: { $number }:{ $hash }
report-template-new-about = Šablona zpráv. Smažte, co zpráva nemá ukazovat; odstraňte znak # u toho, co ukazovat má.
report-template-new-name = Nová šablona
report-changed-since = Změny od zprávy z { $since }:
report-changed-none = žádný výsledek a žádná mez
report-changed-result = { $name }: { $before } → { $now }
report-changed-limits = { $name }: meze { $low } až { $high } → { $lower } až { $higher } mm
report-changed-added = { $name }: nové
report-changed-removed = { $name }: ve zprávě již není
report-changed-several = { $name }: neporovnáno, protože je více hodnot
report-since-no-report = není zpráva programu Fitcheck s daty: zadejte její PDF nebo JSON
