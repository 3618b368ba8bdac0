# statistics

# Waarom er geen cijfer is
statistics-reason-empty = er zijn geen waarden
statistics-reason-not-a-number = waarde { $place } is geen getal
statistics-reason-too-few = te weinig waarden of groepen: { $found }, minstens { $needed } nodig
statistics-reason-all-equal = alle waarden zijn gelijk: er is geen spreiding om mee te rekenen
statistics-reason-no-subgroups = geen enkele steekproef heeft twee of meer waarden
statistics-reason-large-subgroup = een steekproef heeft { $found } waarden: de spreidingsbreedte wordt tot { $most } gebruikt
statistics-reason-no-limits = er zijn geen grenzen
statistics-reason-one-limit = er is maar één grens, en beide zijn nodig
statistics-reason-swapped-limits = de ondergrens ligt niet onder de bovengrens
statistics-reason-not-positive = deze verdeling heeft alleen positieve waarden
statistics-reason-negative = deze verdeling heeft geen negatieve waarden
statistics-reason-no-fit = deze verdeling past niet bij de waarden
statistics-reason-uneven-cell = metingen van onderdeel { $part } door operator { $operator }: { $found }, verwacht { $needed }
statistics-reason-no-baseline = de referentieperiode ligt niet in haar fase, of haar cijfers zijn niet bruikbaar
statistics-reason-parameter = { $name } kan niet { $given } zijn

# Regels van regelkaarten, waar er een aanslaat
statistics-rule-beyond-limits = 1 punt buiten een regelgrens
statistics-rule-nine-one-side = 9 punten na elkaar aan één kant van de middellijn
statistics-rule-six-trend = 6 punten na elkaar stijgend of dalend
statistics-rule-fourteen-alternating = 14 punten na elkaar afwisselend op en neer
statistics-rule-two-of-three = 2 van 3 punten voorbij 2 s aan één kant
statistics-rule-four-of-five = 4 van 5 punten voorbij 1 s aan één kant
statistics-rule-fifteen-within = 15 punten na elkaar binnen 1 s van de middellijn
statistics-rule-eight-beyond = 8 punten na elkaar voorbij 1 s, aan weerskanten
statistics-rule-eight-one-side = 8 punten na elkaar aan één kant van de middellijn
statistics-chart-maximum = grootste { $size }
statistics-chart-minimum = kleinste { $size }
statistics-chart-upper = bovenste { $size }
statistics-chart-mean = gemiddelde { $size }
statistics-chart-lower = onderste { $size }
statistics-chart-values = Losse waarden in µm vanaf { $base }, oudste links
statistics-chart-means = Gemiddelden van groepen in µm vanaf { $base }, oudste links
statistics-chart-histogram = Histogram
statistics-chart-moving-range = Voortschrijdend bereik, µm
statistics-chart-range = Spreidingsbreedte van groepen, µm
statistics-chart-deviation = Standaardafwijking van groepen, µm
statistics-chart-probability = Kansdiagram
statistics-chart-probability-test = Kansdiagram, Anderson-Darling { $statistic }, p = { $p }

# Wat er met de cijfers te doen is
statistics-advice-few-values = { $count } waarden: de intervallen zijn breed, gebruikelijk zijn er { $enough } of meer
statistics-advice-few-points = de regelgrenzen komen uit { $count } punten: gebruikelijk zijn er { $enough } of meer
statistics-advice-unstable = punten waar een regel aanslaat: { $count }; bekwaamheid geldt alleen voor een stabiel proces
statistics-advice-not-of-law = de waarden komen nauwelijks uit deze verdeling (p = { $p }): haar aandelen buiten de grenzen zijn niet betrouwbaar
statistics-advice-centred = niet corrigeren: { $what ->
        [line] de maat ligt nu
       *[mean] het gemiddelde ligt
    } { $um } µm naast het midden van de tolerantie, met { $count } waarden is dat ruis
statistics-advice-near = niet corrigeren: { $what ->
        [line] de maat ligt nu
       *[mean] het gemiddelde ligt
    } { $um } µm naast het midden van de tolerantie, { $count } waarden
statistics-advice-correct = corrigeer met { $correction } µm: { $what ->
        [line] de maat ligt nu
       *[mean] het gemiddelde ligt
    } { $um } µm naast het midden van de tolerantie, { $count } waarden
statistics-advice-no-trend = geen trend: de verandering van onderdeel tot onderdeel is ruis
statistics-advice-trend = de maat verandert { $um } µm per onderdeel
statistics-advice-trend-at-limit = de maat verandert { $um } µm per onderdeel, en vanaf nu zijn onderdelen buiten de grens te verwachten
statistics-advice-trend-to = de maat verandert { $um } µm per onderdeel: er resten ongeveer { $parts } onderdelen tot de grens ({ $level } %: { $least } tot { $most })
statistics-advice-groups-alike = de groepen verschillen niet meer dan door toeval (p = { $p })
statistics-advice-groups-differ = de groepen verschillen (p = { $p })
