# report

## Errors
report-error-writer = zprávu { $format } nelze vytvořit: { $reason }
report-ending-missing = { $file } nemá příponu, která určuje formát zprávy: použijte jednu z { $endings }
report-ending-unknown = .{ $ending } není formát zprávy: použijte jednu z přípon { $endings }

## Sentences about one check
report-feature-hole = díra
report-feature-shaft = hřídel
report-side-good = dobrý
report-side-rework = oprava
report-side-scrap = zmetek
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
report-created = Vytvořeno
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

## Sešit
report-sheets = Vlastní list má jen prvních { $listed } z { $total } dílů; list dílů je obsahuje všechny.
report-sheets-corrected = korigováno na 20 °C
report-sheets-without = Obrázky a body dotyku v tomto sešitu nejsou: zpráva HTML obsahuje obojí, zpráva JSON body dotyku.
report-sheets-cut = { $count ->
    [one] Jeden text je zkrácen: do buňky se vejde nejvýše 32767 znaků.
    [few] { $count } texty jsou zkráceny: do buňky se vejde nejvýše 32767 znaků.
   *[other] { $count } textů je zkráceno: do buňky se vejde nejvýše 32767 znaků.
}
