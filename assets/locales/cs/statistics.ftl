# statistics

# Proč tu není číslo
statistics-reason-empty = nejsou žádné hodnoty
statistics-reason-not-a-number = hodnota { $place } není číslo
statistics-reason-too-few = příliš málo hodnot nebo skupin: { $found }, potřeba je nejméně { $needed }
statistics-reason-all-equal = všechny hodnoty jsou stejné: není rozptyl, se kterým by se dalo počítat
statistics-reason-no-subgroups = žádná podskupina nemá dvě nebo více hodnot
statistics-reason-ungrouped = hodnoty, které neuvádějí svou skupinu: { $count }
statistics-look-grouped = Body jsou průměry: { $by ->
        [part] hodnot jednoho dílu
        [batch] hodnot jedné dávky
        [machine] hodnot jednoho stroje
        [gauge] hodnot jednoho stanoviště
        [who] hodnot jedné osoby
       *[other] hodnot bez pauzy delší než { $minutes } min
    }.
statistics-look-stages = Body, v nichž začíná etapa: { $points }. Hodnoty jsou z poslední etapy.
statistics-look-waits = Etapy, které ještě nemají dost různých hodnot a zatím se nepoužívají: { $count }.
statistics-look-frozen = Regulační meze jsou z bodů { $first } až { $last }.
statistics-look-memory = Druhý diagram: { $method }.
statistics-look-no-memory = Žádný diagram { $method }: { $why }.
statistics-reason-large-subgroup = počet hodnot v podskupině je { $found }: rozpětí se používá nejvýše pro { $most }
statistics-reason-unequal-subgroups = podskupiny mají { $least } až { $most } hodnot: tento diagram potřebuje stejně velké podskupiny
statistics-reason-no-limits = nejsou žádné meze
statistics-reason-one-limit = je jen jedna mez a potřeba jsou obě
statistics-reason-swapped-limits = dolní mez není pod horní
statistics-reason-not-positive = toto rozdělení má jen kladné hodnoty
statistics-reason-negative = toto rozdělení nemá záporné hodnoty
statistics-reason-no-fit = toto rozdělení hodnotám neodpovídá
statistics-reason-uneven-cell = měření dílu { $part } operátorem { $operator }: { $found }, očekává se { $needed }
statistics-reason-no-baseline = referenční období není ve své etapě, nebo jeho čísla nelze použít
statistics-reason-parameter = { $name } nemůže být { $given }

# Pravidla regulačních diagramů tam, kde některé zasáhne
statistics-rule-beyond-limits = 1 bod za regulační mezí
statistics-rule-nine-one-side = 9 bodů za sebou na jedné straně střední přímky
statistics-rule-six-trend = 6 bodů za sebou stoupá nebo klesá
statistics-rule-fourteen-alternating = 14 bodů za sebou střídavě nahoru a dolů
statistics-rule-two-of-three = 2 ze 3 bodů za hranicí 2 s na jedné straně
statistics-rule-four-of-five = 4 z 5 bodů za hranicí 1 s na jedné straně
statistics-rule-fifteen-within = 15 bodů za sebou do 1 s od střední přímky
statistics-rule-eight-beyond = 8 bodů za sebou za hranicí 1 s na kterékoli straně
statistics-rule-eight-one-side = 8 bodů za sebou na jedné straně střední přímky
statistics-chart-maximum = největší { $size }
statistics-chart-minimum = nejmenší { $size }
statistics-chart-upper = horní { $size }
statistics-chart-mean = průměr { $size }
statistics-chart-lower = dolní { $size }
statistics-chart-values = Jednotlivé hodnoty v µm od { $base }, nejstarší vlevo
statistics-chart-means = Průměry podskupin v µm od { $base }, nejstarší vlevo
statistics-chart-histogram = Histogram
statistics-chart-moving-range = Klouzavé rozpětí, µm
statistics-chart-range = Rozpětí podskupin, µm
statistics-chart-deviation = Směrodatná odchylka podskupin, µm
statistics-chart-probability = Pravděpodobnostní graf
statistics-chart-ewma = Vážené průměry (EWMA)
statistics-chart-cusum = Součty odchylek od průměru (CUSUM)
statistics-chart-probability-test = Pravděpodobnostní graf, Anderson-Darling { $statistic }, p = { $p }

# Co s čísly udělat
statistics-advice-few-values = počet hodnot { $count }: intervaly jsou široké, obvyklých je { $enough } nebo více
statistics-advice-few-points = počet bodů pro regulační meze je { $count }: obvyklých je { $enough } nebo více
statistics-advice-unstable = počet bodů, v nichž zasáhlo některé pravidlo: { $count }; způsobilost platí jen pro stabilní proces
statistics-advice-not-of-law = hodnoty sotva pocházejí z tohoto rozdělení (p = { $p }): jeho podíly mimo meze nejsou spolehlivé
statistics-advice-centred = nekorigovat: { $what ->
        [line] rozměr je teď
       *[mean] průměr je
    } { $um } µm od středu tolerance, což je při počtu hodnot { $count } šum
statistics-advice-near = nekorigovat: { $what ->
        [line] rozměr je teď
       *[mean] průměr je
    } { $um } µm od středu tolerance, počet hodnot { $count }
statistics-advice-correct = korigovat o { $correction } µm: { $what ->
        [line] rozměr je teď
       *[mean] průměr je
    } { $um } µm od středu tolerance, počet hodnot { $count }
statistics-advice-no-trend = žádný trend: změna od dílu k dílu je šum
statistics-advice-trend = rozměr se mění o { $um } µm na díl
statistics-advice-trend-at-limit = rozměr se mění o { $um } µm na díl a od této chvíle je třeba počítat s díly za mezí
statistics-advice-trend-to = rozměr se mění o { $um } µm na díl: počet dílů do meze je asi { $parts } ({ $level } %: { $least } až { $most })
statistics-advice-average-out = vážený průměr je mimo své meze, poprvé v bodě { $at }: průměr se posunul
statistics-advice-sum-out = součet je mimo rozhodovací interval, poprvé v bodě { $at }: průměr se posunul, přibližně od bodu { $since }
statistics-advice-groups-alike = skupiny se neliší více než náhodně (p = { $p })
statistics-advice-groups-differ = skupiny se liší (p = { $p })

# Studie měřidel
statistics-gauge-operator-per-value = každá hodnota má vlastního operátora: jsou sloupce správně?
statistics-gauge-more-operators = operátoři: { $operators }, díly: { $parts }: nejsou sloupce dílů a operátorů prohozené?
statistics-gauge-operators-differ-more = operátoři se liší více než díly: nejsou sloupce dílů a operátorů prohozené?
statistics-gauge-same-parts = každý operátor má díly stejných názvů: není studie křížová?
statistics-gauge-several-masters = hodnoty jsou z { $parts } dílů a tato studie potřebuje jediný etalon
statistics-gauge-master-good = pro tuto toleranci dost dobré: Cg a Cgk dosahují { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = pro tuto toleranci nedostatečné: Cg a Cgk musí dosáhnout { $required } a krok zobrazení smí být nejvýše 5 % tolerance (AIAG MSA, VDA 5)
statistics-gauge-smallest = nejmenší tolerance, pro kterou je dost dobré: { $mm } mm ({ $level } %: až { $most } mm)
statistics-gauge-biased = strannost { $um } µm je víc než náhoda (p = { $p })
statistics-gauge-not-biased = strannost { $um } µm může být náhoda (p = { $p })
statistics-gauge-good = dost dobré: měřidlo zabírá { $percent } % { $of ->
        [tolerance] tolerance
       *[variation] celkového rozptylu
    } a do 10 % je to dobré (AIAG MSA)
statistics-gauge-accepted = dost dobré, jen pokud musí stačit: měřidlo zabírá { $percent } % { $of ->
        [tolerance] tolerance
       *[variation] celkového rozptylu
    } a od 10 % do 30 % záleží na použití (AIAG MSA)
statistics-gauge-bad = nedostatečné: měřidlo zabírá { $percent } % { $of ->
        [tolerance] tolerance
       *[variation] celkového rozptylu
    } a více než 30 % je příliš (AIAG MSA)
statistics-gauge-smallest-shares = nejmenší tolerance, pro kterou je dost dobré: { $good } mm; pokud musí stačit: { $accepted } mm
statistics-gauge-interaction-kept = operátoři se u některých dílů liší více než u jiných (p = { $p }): interakce zůstává
statistics-gauge-interaction-pooled = operátoři se u některých dílů neliší více než u jiných (p = { $p }): interakce se počítá k opakovatelnosti
statistics-gauge-negative = rozptyl { $what ->
        [operator] operátorů
        [interaction] interakce
       *[part] dílů
    } vyšel záporný a počítá se jako 0
statistics-gauge-not-linear = strannost se mění s rozměrem (p = { $p })
statistics-gauge-linear = strannost se s rozměrem nemění víc než náhodou (p = { $p })
statistics-gauge-stable = stabilní: žádné pravidlo nehlásí a údaje se neposouvají
statistics-gauge-not-stable = nestabilní: některé pravidlo hlásí nebo se údaje posouvají

# Proč hodnoty nejsou studií
series-study-no-parts = hodnoty bez dílu: { $count }
series-study-no-operators = hodnoty bez operátora vedle jiných, které ho mají: { $count }
series-study-uneven-cell = měření dílu { $part } operátorem { $operator }: { $found }, očekáváno { $needed }
series-study-uneven-operator = díly operátora { $operator }: { $found }, očekáváno { $needed }
series-study-nested = každý díl měřil jen jeden operátor: to je vnořená studie
series-study-no-reference = hodnoty bez kalibrovaného rozměru: { $count }
series-study-references = hodnoty jednoho etalonu mají několik kalibrovaných rozměrů

# Jak se počítají hodnoty studie
series-method-word = { $word }
series-method-given = zadáno
series-method-mean = průměr, Student
series-method-deviation = směrodatná odchylka, chí-kvadrát
series-method-bias = průměr − reference, Student
series-method-t-test = t-test
series-method-type1 = typ 1
series-method-share = { $percent } % tolerance, { $spread } s
series-method-required = Cg a Cgk alespoň { $required }
series-method-anova = analýza rozptylu
series-method-degrees = analýza rozptylu, stupně volnosti: { $degrees }
series-method-ratio = F = { $f }
series-method-negative = záporný, počítá se 0
series-method-chi-square = chí-kvadrát
series-method-large-sample = modifikovaný velký výběr
series-method-variances = rozptyly
series-method-categories = 1,41 díly / měřidlo
series-method-linearity = linearita
series-method-least-squares = nejmenší čtverce
series-method-within-masters = s v rámci etalonů
statistics-on-spread = rozptýlení: { $rule }
