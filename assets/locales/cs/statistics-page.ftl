page-statistics = Statistika

# Co se hledá
statistics-page-question = Záznamy
statistics-page-question-hint = Záznamy, jejichž hodnoty se použijí, v jazyce stránky Záznamy, například part:"Příruba 40" station:"Fréza 3" from:2026-11-01. Prázdné: všechny záznamy.
statistics-page-last = Nejnovější hodnoty
statistics-page-size = Hodnot na bod
statistics-page-pause = Pauza v minutách
statistics-page-mean-of = Průměr z
statistics-page-mean-count = tolika hodnot za sebou
statistics-page-mean-pause = hodnot bez pauzy
statistics-page-mean-part = hodnot jednoho dílu
statistics-page-mean-station = hodnot jednoho stanoviště
statistics-page-mean-person = hodnot jedné osoby
statistics-page-part = Díl
statistics-page-all-parts = Všechny díly
statistics-page-read-again = Načíst znovu
statistics-page-range = musí být celé číslo od { $least } do { $most }
statistics-page-reading = Načítají se hodnoty…
statistics-page-off = Nic se nezaznamenává. Statistika se počítá z hodnot v záznamech.
statistics-page-none = Tomuto dotazu neodpovídá žádný záznam s naměřenou hodnotou.
statistics-page-not-read = Hodnoty nelze načíst: { $why }

# Co se načetlo
statistics-page-values = { $count ->
        [one] 1 hodnota
        [few] { $count } hodnoty
        [many] { $count } hodnoty
       *[other] { $count } hodnot
    }
statistics-page-groups = { $count ->
        [one] 1 skupina
        [few] { $count } skupiny
        [many] { $count } skupiny
       *[other] { $count } skupin
    } po { $size }
statistics-page-out = vynecháno { $count }: { $why ->
        [simulated] simulované
        [invalid] neplatné
        [doubtful] pochybné
        [withdrawn] opravené nebo stažené
       *[user] s důvodem
    }
statistics-page-newest = Načteno bylo { $count } nejnovějších záznamů. Starší nejsou zahrnuty.
statistics-page-unread = { $count ->
        [one] 1 záznam nelze načíst.
        [few] { $count } záznamy nelze načíst.
        [many] { $count } záznamu nelze načíst.
       *[other] { $count } záznamů nelze načíst.
    }

# Prvky
statistics-page-features = Prvky
statistics-page-features-head = Ppk, značka u { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 hodnota
        [few] { $count } hodnoty
        [many] { $count } hodnoty
       *[other] { $count } hodnot
    }, Ppk { $ppk }
statistics-page-below = { $count } z { $all } pod { $asked }
statistics-page-move-feature = Jiný prvek

# Hodnoty
statistics-page-figures = Hodnoty
statistics-page-figure-mean = Průměr
statistics-page-figure-deviation = Směrodatná odchylka
statistics-page-figure-cp = Cp krátkodobě
statistics-page-figure-cpk = Cpk krátkodobě
statistics-page-figure-pp = Pp celkem
statistics-page-figure-ppk = Ppk celkem
statistics-page-figure-outside = Mimo meze
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = z { $count }
statistics-page-expected = očekává se { $ppm } z milionu
statistics-page-proven = Ppk { $asked } je prokázáno: jeho dolní mez je { $lower }.
statistics-page-not-proven = Ppk { $asked } není prokázáno: jeho dolní mez je { $lower }.
statistics-page-no-ppk = Ppk { $asked } není prokázáno: { $why }.

# Diagram
statistics-page-single = Jednotlivé hodnoty
statistics-page-means = Průměry z { $size }
statistics-page-means-of-groups = Průměry skupin
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Histogram
statistics-page-spread = Rozptýlení
statistics-page-probability = Pravděpodobnostní graf
statistics-page-no-chart = Bez regulačních mezí: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 bod
        [few] { $count } body
        [many] { $count } bodu
       *[other] { $count } bodů
    }, střední přímka { $centre }, regulační meze { $lower } … { $upper }, meze { $minimum } … { $maximum }, { $signals ->
        [one] 1 signál
        [few] { $signals } signály
        [many] { $signals } signálu
       *[other] { $signals } signálů
    }, mimo meze { $outside }.
statistics-page-said-mean-mm = průměr
statistics-page-said-sd-mm = směrodatná odchylka
statistics-page-said-spread-centre-mm = střední rozptýlení
statistics-page-said-spread-upper-mm = horní regulační mez rozptýlení
statistics-page-said-ewma-mm = vážený průměr
statistics-page-said-ewma-lower-mm = dolní mez průměru
statistics-page-said-ewma-upper-mm = horní mez průměru
statistics-page-said-cusum-above-mm = součet nad průměrem
statistics-page-said-cusum-below-mm = součet pod průměrem
statistics-page-said-cusum-interval-mm = rozhodovací interval
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Jiný bod
statistics-page-open = Otevřít záznam
statistics-page-zoom-in = Méně bodů
statistics-page-zoom-out = Více bodů
statistics-page-zoom-whole = Všechny body
statistics-page-freeze = Meze z bodů až sem
statistics-page-unfreeze = Meze ze všech bodů
statistics-page-freeze-hint = Pozdější body regulační meze neposunou.
statistics-page-leave-out = Vynechat…
statistics-page-leave-out-hint = Bod zůstane v diagramu i s důvodem. Do mezí, pravidel a hodnot se nepočítá.
statistics-page-stage = Začít zde etapu
statistics-page-no-stage = Zrušit etapu
statistics-page-stage-hint = Od tohoto bodu se meze počítají znovu, například po výměně nástroje. Hodnoty jsou z poslední etapy.
statistics-page-take-in = Znovu zahrnout
statistics-page-reason = Důvod
statistics-page-take-reason = Vynechat
statistics-page-cancel-reason = Zrušit
statistics-page-copy = Kopírovat hodnoty
statistics-page-copy-hint = Hodnoty, signály a rady jako tabulka pro tabulkový procesor
statistics-page-report = Zpráva…
statistics-page-report-hint = Číselné údaje a grafy všech znaků jako zpráva k podpisu
statistics-page-save-chart = Uložit graf…
statistics-page-save-chart-hint = Všechny grafy znaku na jednom listu, jako SVG nebo PNG
statistics-page-dialog-chart = Uložit graf
statistics-page-chart-ending = Název souboru musí končit na .svg nebo .png.

# Signály
statistics-page-signals = Signály
statistics-page-no-signals = Žádné pravidlo nezasáhlo.
statistics-page-rules = Pravidla
statistics-page-alarms = Otevřené výstrahy: { $count }
statistics-page-at = Bod { $point }
statistics-page-from-to = Body { $first } až { $last }
statistics-page-left-out-because = Vynecháno: { $reason }
statistics-page-advice = Rady

# Studie měřidla
statistics-study = Studie měřidla
statistics-study-open = Otevřít odečty…
statistics-study-open-hint = Soubor s odečty měřidla v libovolném formátu měření
statistics-study-dialog = Otevřít odečty měřidla
statistics-study-readings = { $count ->
        [one] 1 odečet
        [few] { $count } odečty
        [many] { $count } odečtu
       *[other] { $count } odečtů
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 odečet
        [few] { $count } odečty
        [many] { $count } odečtu
       *[other] { $count } odečtů
    }
statistics-study-none = Otevřete soubor s odečty měřidla. Jeho sloupce říkají, který díl se měřil a kým. Než se něco vypočítá, uvidíte, jak byl soubor pochopen.
statistics-study-kind = Druh studie
statistics-study-type1 = Typ 1
statistics-study-crossed = Křížená
statistics-study-nested = Vnořená
statistics-study-linearity = Linearita
statistics-study-stability = Stabilita
statistics-study-type1-hint = Jeden etalon, 25 odečtů nebo více
statistics-study-crossed-hint = Každý operátor měří každý díl, dvakrát nebo vícekrát
statistics-study-nested-hint = Každý operátor má vlastní díly
statistics-study-linearity-hint = Několik etalonů různých rozměrů
statistics-study-stability-hint = Jeden etalon v čase
statistics-study-feature = Prvek studie
statistics-study-lower = Dolní mez
statistics-study-upper = Horní mez
statistics-study-reference = Kalibrovaný rozměr
statistics-study-resolution = Krok zobrazení
statistics-study-references-hint = Jeden rozměr pro každý etalon podle jména: M1 = 30.0012; M2 = 40.0005. Prázdné pole používá jmenovité rozměry souboru.
statistics-study-reference-unnamed = { $given } nejmenuje etalon: napište jeho jméno před rozměr, například M1 = 30.0012
statistics-study-own-limits = Meze ze souboru: { $lower } … { $upper } mm
statistics-study-understood = Jak byl soubor pochopen
statistics-study-confirm = Dokud to nepotvrdíte, nic se nepočítá.
statistics-study-evaluate = Vyhodnotit
statistics-study-all-the-same = Přesto vyhodnotit
statistics-study-working = Vyhodnocuje se…
statistics-study-answer = Je toto měřidlo dost dobré?
statistics-study-each = po { $what }
statistics-study-parts = { $count ->
        [one] 1 díl
        [few] { $count } díly
        [many] { $count } dílu
       *[other] { $count } dílů
    }
statistics-study-operators = { $count ->
        [one] 1 operátor
        [few] { $count } operátoři
        [many] { $count } operátora
       *[other] { $count } operátorů
    }
statistics-study-repeats = { $count ->
        [one] 1 opakování
        [few] { $count } opakování
        [many] { $count } opakování
       *[other] { $count } opakování
    }
statistics-study-masters = { $count ->
        [one] 1 etalon
        [few] { $count } etalony
        [many] { $count } etalonu
       *[other] { $count } etalonů
    }
statistics-study-points = { $count ->
        [one] 1 bod
        [few] { $count } body
        [many] { $count } bodu
       *[other] { $count } bodů
    }
statistics-study-readings-between = { $least } až { $most } odečtů
statistics-study-more-faults = a další: { $count }
statistics-study-limits-differ = Meze v souboru se liší hodnotu od hodnoty: zadejte dolní a horní mez, nebo vyberte prvek.
statistics-study-features = Soubor má několik prvků: vyberte ten, který měřidlo měřilo.
statistics-study-save-budget = Uložit jako bilanci…
statistics-study-save-budget-hint = Rozptyl, který studie našla, jako typ A se stupni volnosti, pro stránku Nejistota
statistics-study-no-budget = Tato studie nedává do bilance žádný příspěvek
statistics-study-source = { $of ->
        [part] díly
        [operator] operátoři
        [interaction] interakce
        [repeatability] opakovatelnost
        [gauge] měřidlo
       *[total] celkem
    }
statistics-study-mean-square = Střední čtverec, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Rozptyl, { $source }
statistics-study-figure-reference = Kalibrovaný rozměr
statistics-study-figure-bias = Strannost
statistics-study-figure-mean-bias = Průměrná strannost
statistics-study-figure-bias-p = p strannosti
statistics-study-figure-bias-t = t strannosti
statistics-study-figure-bias-at = Strannost při { $size } mm ({ $count })
statistics-study-figure-smallest = Nejmenší tolerance
statistics-study-figure-smallest-good = Nejmenší tolerance, 10 %
statistics-study-figure-smallest-accepted = Nejmenší tolerance, 30 %
statistics-study-figure-repeatability = Opakovatelnost, s
statistics-study-figure-gauge = Měřidlo, s
statistics-study-figure-of-variance = Podíl na rozptylu
statistics-study-figure-of-readings = Podíl na všech odečtech
statistics-study-figure-of-tolerance = Podíl na toleranci
statistics-study-figure-categories = Rozlišitelné kategorie
statistics-study-figure-slope = Sklon
statistics-study-figure-slope-p = p sklonu
statistics-study-figure-intercept = Strannost při 0
statistics-study-figure-intercept-p = p strannosti při 0
statistics-study-figure-residual = s kolem přímky
statistics-study-figure-centre = Střední přímka
statistics-study-figure-lower-control = Dolní regulační mez
statistics-study-figure-upper-control = Horní regulační mez
statistics-study-figure-spread-centre = Střední rozptýlení
statistics-study-figure-spread-upper = Horní regulační mez rozptýlení
