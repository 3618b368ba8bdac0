# statistics

# Proč tu není číslo
statistics-reason-empty = nejsou žádné hodnoty
statistics-reason-not-a-number = hodnota { $place } není číslo
statistics-reason-too-few = příliš málo hodnot nebo skupin: { $found }, potřeba je nejméně { $needed }
statistics-reason-all-equal = všechny hodnoty jsou stejné: není rozptyl, se kterým by se dalo počítat
statistics-reason-no-subgroups = žádná podskupina nemá dvě nebo více hodnot
statistics-reason-large-subgroup = počet hodnot v podskupině je { $found }: rozpětí se používá nejvýše pro { $most }
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
statistics-advice-groups-alike = skupiny se neliší více než náhodně (p = { $p })
statistics-advice-groups-differ = skupiny se liší (p = { $p })
