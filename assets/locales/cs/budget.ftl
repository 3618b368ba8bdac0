# budget

budget-toml = { $said }
budget-too-large = soubor bilance má nejvýše { $most } KiB
budget-not-one = bilance potřebuje buď tabulky [[contribution]], nebo jednu tabulku [calibrated]
budget-too-many = příspěvků je { $count }: bilance jich má nejvýše { $most }
budget-empty = { $key } je prázdné: očekává se text
budget-day = { $key }: { $given } není den: očekává se YYYY-MM-DD
budget-days = valid_until { $until } je před date { $date }
budget-key = { $table }: { $key } se zde nepoužívá: dovolené klíče jsou { $allowed }
budget-missing = { $table }: chybí { $keys }
budget-range = { $table }: { $key } je { $given }: očekává se { $least } až { $most }
budget-resolution-law = { $table }: rozlišení má rovnoměrné rozdělení: očekává se law = "rectangular" nebo žádné law
budget-geometry = { $table }: { $error }
budget-length = { $key }: { $error }
budget-geometry-touches = body dotyku: { $touches }; očekává se 3 až { $most }
budget-geometry-step = body dotyku: { $touches } po { $step } stupních; očekává se krok 0,01 až { $most } stupňů
budget-evaluation-no-size = { $contribution } závisí na rozměru, ale žádný rozměr není zadán
budget-evaluation-no-contacts = { $contribution } závisí na bodech dotyku, ale bilance nemá touches a step_deg a žádné body dotyku nejsou zadány
budget-evaluation-nothing = všechny příspěvky jsou nulové
budget-calibrated-too-few = { $readings ->
        [one] jeden odečet
        [few] { $readings } odečty
       *[other] { $readings } odečtů
    }: jsou třeba nejméně 2
budget-calibrated-far-away = střední hodnota odečtů { $mean } mm je více než 1 mm od kalibrovaného rozměru { $size } mm
budget-calibrated-nothing = všechny nejistoty jsou nulové

budget-warning-expired = bilance je prošlá: platila do { $until }
budget-warning-not-yet = bilance ještě neplatí: její datum je { $date }
budget-warning-of-template = v bilanci jsou ještě údaje ze šablony (název, autor nebo čísla): o této stanici nic neříkají
budget-warning-failed-study = studie říká o tomto měřidle: { $why }
budget-warning-template-figures = tyto příspěvky mají ještě čísla ze šablony: { $contributions }. Ověřte, že pro tuto stanici platí
budget-warning-few-readings = odečty kalibrovaného kusu: { $readings }; ISO 15530-3 požaduje nejméně { $fewest }
budget-warning-bias-corrected = vychýlení { $bias } µm: nejistota platí pro hodnoty, od kterých bylo vychýlení odečteno; Fitcheck je neodečítá
budget-warning-bias-not-corrected = vychýlení { $bias } µm: neodečítá se, nejistota je proto zahrnuje
budget-warning-other-size = kalibrovaný kus bilance má { $calibrated } mm, ale naměřeno bylo { $measured } mm: nejistota platí pro díly podobné kusu
budget-warning-other-side = kalibrovaný kus bilance je { $calibrated ->
    [hole] díra, ale měřen byl hřídel
   *[shaft] hřídel, ale měřena byla díra
    }
budget-warning-other-expansion = { $contribution } v bilanci má roztažnost { $budget } · 10⁻⁶/K, ale hodnota byla přepočtena s { $given }
budget-warning-other-temperature = { $contribution } v bilanci je pro teplotu { $budget } K od 20 °C, ale hodnota byla přepočtena pro { $given } K
budget-warning-recorded = { $text }
