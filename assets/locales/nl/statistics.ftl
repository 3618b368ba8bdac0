# statistics

# Waarom er geen cijfer is
statistics-reason-empty = er zijn geen waarden
statistics-reason-not-a-number = waarde { $place } is geen getal
statistics-reason-too-few = te weinig waarden of groepen: { $found }, minstens { $needed } nodig
statistics-reason-all-equal = alle waarden zijn gelijk: er is geen spreiding om mee te rekenen
statistics-reason-no-subgroups = geen enkele steekproef heeft twee of meer waarden
statistics-reason-ungrouped = waarden die niet zeggen bij welke groep ze horen: { $count }
statistics-look-grouped = Punten zijn gemiddelden: { $by ->
        [part] van de waarden van één onderdeel
        [batch] van de waarden van één partij
        [machine] van de waarden van één machine
        [gauge] van de waarden van één station
        [who] van de waarden van één persoon
       *[other] van waarden zonder een pauze van meer dan { $minutes } min
    }.
statistics-look-stages = Punten waar een fase begint: { $points }. De waarden zijn die van de laatste fase.
statistics-look-waits = Fasen die nog te weinig verschillende waarden hebben en nog niet tellen: { $count }.
statistics-look-frozen = De regelgrenzen komen uit de punten { $first } tot { $last }.
statistics-look-memory = Tweede kaart: { $method }.
statistics-look-no-memory = Geen kaart { $method }: { $why }.
statistics-reason-large-subgroup = een steekproef heeft { $found } waarden: de spreidingsbreedte wordt tot { $most } gebruikt
statistics-reason-unequal-subgroups = steekproeven hebben { $least } tot { $most } waarden: deze kaart vraagt steekproeven van gelijke grootte
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
statistics-chart-ewma = Gewogen gemiddelden (EWMA)
statistics-chart-cusum = Sommen van afwijkingen van het gemiddelde (CUSUM)
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
statistics-advice-average-out = het gewogen gemiddelde ligt buiten zijn grenzen, voor het eerst bij punt { $at }: het gemiddelde is verschoven
statistics-advice-sum-out = de som ligt buiten het beslissingsinterval, voor het eerst bij punt { $at }: het gemiddelde is verschoven, sinds ongeveer punt { $since }
statistics-advice-groups-alike = de groepen verschillen niet meer dan door toeval (p = { $p })
statistics-advice-groups-differ = de groepen verschillen (p = { $p })

# Studies van meetmiddelen
statistics-gauge-operator-per-value = elke waarde heeft een eigen operator: kloppen de kolommen?
statistics-gauge-more-operators = operators: { $operators }, onderdelen: { $parts }: zijn de kolommen van onderdelen en operators verwisseld?
statistics-gauge-operators-differ-more = operators verschillen meer dan onderdelen: zijn de kolommen van onderdelen en operators verwisseld?
statistics-gauge-same-parts = elke operator heeft onderdelen met dezelfde namen: is de studie gekruist?
statistics-gauge-several-masters = de waarden zijn van { $parts } onderdelen, en deze studie vraagt één referentie
statistics-gauge-master-good = goed genoeg voor deze tolerantie: Cg en Cgk halen { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = niet goed genoeg voor deze tolerantie: Cg en Cgk moeten { $required } halen, met een afleesstap van hoogstens 5 % van de tolerantie (AIAG MSA, VDA 5)
statistics-gauge-smallest = kleinste tolerantie waarvoor het goed genoeg is: { $mm } mm ({ $level } %: tot { $most } mm)
statistics-gauge-biased = de systematische afwijking van { $um } µm is meer dan toeval (p = { $p })
statistics-gauge-not-biased = de systematische afwijking van { $um } µm kan toeval zijn (p = { $p })
statistics-gauge-good = goed genoeg: het meetmiddel neemt { $percent } % van { $of ->
        [tolerance] de tolerantie
       *[variation] alle spreiding
    }, en tot 10 % is goed (AIAG MSA)
statistics-gauge-accepted = alleen goed genoeg als het moet: het meetmiddel neemt { $percent } % van { $of ->
        [tolerance] de tolerantie
       *[variation] alle spreiding
    }, en 10 % tot 30 % hangt af van het gebruik (AIAG MSA)
statistics-gauge-bad = niet goed genoeg: het meetmiddel neemt { $percent } % van { $of ->
        [tolerance] de tolerantie
       *[variation] alle spreiding
    }, en meer dan 30 % is te veel (AIAG MSA)
statistics-gauge-smallest-shares = kleinste tolerantie waarvoor het goed genoeg is: { $good } mm; als het moet: { $accepted } mm
statistics-gauge-interaction-kept = operators verschillen bij sommige onderdelen meer dan bij andere (p = { $p }): de interactie blijft
statistics-gauge-interaction-pooled = operators verschillen niet bij sommige onderdelen meer dan bij andere (p = { $p }): de interactie telt bij de herhaalbaarheid
statistics-gauge-negative = de variantie van { $what ->
        [operator] operators
        [interaction] de interactie
       *[part] onderdelen
    } werd negatief en telt als 0
statistics-gauge-not-linear = de systematische afwijking verandert met de maat (p = { $p })
statistics-gauge-linear = de systematische afwijking verandert niet meer dan door toeval met de maat (p = { $p })
statistics-gauge-stable = stabiel: geen regel slaat aan en de aflezingen verlopen niet
statistics-gauge-not-stable = niet stabiel: een regel slaat aan of de aflezingen verlopen

# Waarom waarden geen studie zijn
series-study-no-parts = waarden zonder onderdeel: { $count }
series-study-no-operators = waarden zonder operator naast andere met operator: { $count }
series-study-uneven-cell = metingen van onderdeel { $part } door operator { $operator }: { $found }, verwacht { $needed }
series-study-uneven-operator = onderdelen van operator { $operator }: { $found }, verwacht { $needed }
series-study-nested = elk onderdeel is door maar één operator gemeten: dit is een geneste studie
series-study-no-reference = waarden zonder gekalibreerde maat: { $count }
series-study-references = de waarden van één referentie hebben meerdere gekalibreerde maten

# Hoe cijfers van een studie zijn berekend
series-method-word = { $word }
series-method-given = gegeven
series-method-mean = gemiddelde, Student
series-method-deviation = standaardafwijking, chi-kwadraat
series-method-bias = gemiddelde − referentie, Student
series-method-t-test = t-toets
series-method-type1 = type 1
series-method-share = { $percent } % van de tolerantie, { $spread } s
series-method-required = Cg en Cgk minstens { $required }
series-method-anova = variantieanalyse
series-method-degrees = variantieanalyse, vrijheidsgraden: { $degrees }
series-method-ratio = F = { $f }
series-method-negative = negatief, telt als 0
series-method-chi-square = chi-kwadraat
series-method-large-sample = aangepaste grote steekproef
series-method-variances = varianties
series-method-categories = 1,41 onderdelen / meetmiddel
series-method-linearity = lineariteit
series-method-least-squares = kleinste kwadraten
series-method-within-masters = s binnen referenties
statistics-on-spread = spreiding: { $rule }
