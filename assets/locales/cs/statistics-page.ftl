page-statistics = Statistika

# Co se hledá
statistics-page-question = Záznamy
statistics-page-question-hint = Záznamy, jejichž hodnoty se použijí, v jazyce stránky Záznamy, například part:"Příruba 40" station:"Fréza 3" from:2026-11-01. Prázdné: všechny záznamy.
statistics-page-last = Nejnovější hodnoty
statistics-page-size = Hodnot na bod
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
statistics-page-take-in = Znovu zahrnout
statistics-page-reason = Důvod
statistics-page-take-reason = Vynechat
statistics-page-cancel-reason = Zrušit
statistics-page-copy = Kopírovat hodnoty
statistics-page-copy-hint = Hodnoty, signály a rady jako tabulka pro tabulkový procesor
statistics-page-report = Zpráva…
statistics-page-report-hint = Číselné údaje a grafy všech znaků jako zpráva k podpisu

# Signály
statistics-page-signals = Signály
statistics-page-no-signals = Žádné pravidlo nezasáhlo.
statistics-page-rules = Pravidla
statistics-page-on-spread = Rozptýlení: { $rule }
statistics-page-alarms = Otevřené výstrahy: { $count }
statistics-page-at = Bod { $point }
statistics-page-from-to = Body { $first } až { $last }
statistics-page-left-out-because = Vynecháno: { $reason }
statistics-page-advice = Rady
