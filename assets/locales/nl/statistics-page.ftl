page-statistics = Statistiek

# Wat gevraagd wordt
statistics-page-question = Regels
statistics-page-question-hint = De regels waarvan de waarden worden gebruikt, in de taal van de pagina Logboek, zoals part:"Flens 40" station:"Frees 3" from:2026-11-01. Leeg: alle regels.
statistics-page-last = Nieuwste waarden
statistics-page-size = Waarden per punt
statistics-page-pause = Pauze in minuten
statistics-page-mean-of = Gemiddelde van
statistics-page-mean-count = zoveel waarden na elkaar
statistics-page-mean-pause = waarden zonder pauze
statistics-page-mean-part = waarden van één onderdeel
statistics-page-mean-station = waarden van één station
statistics-page-mean-person = waarden van één persoon
statistics-page-part = Werkstuk
statistics-page-all-parts = Alle werkstukken
statistics-page-read-again = Opnieuw lezen
statistics-page-range = moet een geheel getal van { $least } tot en met { $most } zijn
statistics-page-reading = Waarden worden gelezen…
statistics-page-off = Er wordt niets vastgelegd. Statistiek wordt gemaakt uit de waarden in het logboek.
statistics-page-none = Geen regel met een gemeten waarde voldoet aan deze vraag.
statistics-page-not-read = De waarden kunnen niet worden gelezen: { $why }

# Wat gelezen is
statistics-page-values = { $count ->
        [one] 1 waarde
       *[other] { $count } waarden
    }
statistics-page-groups = { $count ->
        [one] 1 groep
       *[other] { $count } groepen
    } van { $size }
statistics-page-out = { $count } weggelaten: { $why ->
        [simulated] gesimuleerd
        [invalid] ongeldig
        [doubtful] twijfelachtig
        [withdrawn] gecorrigeerd of ingetrokken
       *[user] met een reden
    }
statistics-page-newest = De nieuwste { $count } regels zijn gelezen. Oudere tellen niet mee.
statistics-page-unread = { $count ->
        [one] 1 regel kan niet worden gelezen.
       *[other] { $count } regels kunnen niet worden gelezen.
    }

# Kenmerken
statistics-page-features = Kenmerken
statistics-page-features-head = Ppk, streep bij { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 waarde
       *[other] { $count } waarden
    }, Ppk { $ppk }
statistics-page-below = { $count } van { $all } onder { $asked }
statistics-page-move-feature = Een ander kenmerk

# Cijfers
statistics-page-figures = Cijfers
statistics-page-figure-mean = Gemiddelde
statistics-page-figure-deviation = Standaardafwijking
statistics-page-figure-cp = Cp korte termijn
statistics-page-figure-cpk = Cpk korte termijn
statistics-page-figure-pp = Pp totaal
statistics-page-figure-ppk = Ppk totaal
statistics-page-figure-outside = Buiten de grenzen
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = van { $count }
statistics-page-expected = verwacht { $ppm } per miljoen
statistics-page-proven = Ppk van { $asked } is aangetoond: de ondergrens is { $lower }.
statistics-page-not-proven = Ppk van { $asked } is niet aangetoond: de ondergrens is { $lower }.
statistics-page-no-ppk = Ppk van { $asked } is niet aangetoond: { $why }.

# De kaart
statistics-page-single = Losse waarden
statistics-page-means = Gemiddelden van { $size }
statistics-page-means-of-groups = Gemiddelden van groepen
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Histogram
statistics-page-spread = Spreiding
statistics-page-probability = Waarschijnlijkheidsplot
statistics-page-no-chart = Geen regelgrenzen: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 punt
       *[other] { $count } punten
    }, middellijn { $centre }, regelgrenzen { $lower } … { $upper }, grenzen { $minimum } … { $maximum }, { $signals ->
        [one] 1 signaal
       *[other] { $signals } signalen
    }, { $outside } buiten de grenzen.
statistics-page-said-mean-mm = gemiddelde
statistics-page-said-sd-mm = standaardafwijking
statistics-page-said-spread-centre-mm = gemiddelde spreiding
statistics-page-said-spread-upper-mm = bovenste regelgrens van de spreiding
statistics-page-said-ewma-mm = gewogen gemiddelde
statistics-page-said-ewma-lower-mm = ondergrens van het gemiddelde
statistics-page-said-ewma-upper-mm = bovengrens van het gemiddelde
statistics-page-said-cusum-above-mm = som boven het gemiddelde
statistics-page-said-cusum-below-mm = som onder het gemiddelde
statistics-page-said-cusum-interval-mm = beslissingsinterval
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Een ander punt
statistics-page-open = Regel openen
statistics-page-zoom-in = Minder punten
statistics-page-zoom-out = Meer punten
statistics-page-zoom-whole = Alle punten
statistics-page-freeze = Grenzen uit de punten tot hier
statistics-page-unfreeze = Grenzen uit alle punten
statistics-page-freeze-hint = Latere punten verschuiven de regelgrenzen niet.
statistics-page-leave-out = Weglaten…
statistics-page-leave-out-hint = Het punt blijft met zijn reden in de kaart. Voor grenzen, regels en cijfers telt het niet mee.
statistics-page-stage = Fase hier beginnen
statistics-page-no-stage = Fase verwijderen
statistics-page-stage-hint = Vanaf dit punt worden de grenzen opnieuw berekend, bijvoorbeeld na een gereedschapswissel. De waarden zijn die van de laatste fase.
statistics-page-take-in = Weer meetellen
statistics-page-reason = Reden
statistics-page-take-reason = Weglaten
statistics-page-cancel-reason = Annuleren
statistics-page-copy = Cijfers kopiëren
statistics-page-copy-hint = Cijfers, signalen en advies als tabel voor een spreadsheet
statistics-page-report = Rapport…
statistics-page-report-hint = De getallen en grafieken van alle kenmerken als rapport om te ondertekenen
statistics-page-save-chart = Kaart opslaan…
statistics-page-save-chart-hint = Alle kaarten van het kenmerk op één blad, als SVG of PNG
statistics-page-dialog-chart = Kaart opslaan
statistics-page-chart-ending = De bestandsnaam moet eindigen op .svg of .png.

# Signalen
statistics-page-signals = Signalen
statistics-page-no-signals = Geen regel slaat aan.
statistics-page-rules = Regels van de kaart
statistics-page-alarms = Open alarmen: { $count }
statistics-page-at = Punt { $point }
statistics-page-from-to = Punten { $first } tot en met { $last }
statistics-page-left-out-because = Weggelaten: { $reason }
statistics-page-advice = Advies

# Een meetmiddelstudie
statistics-study = Meetmiddelstudie
statistics-study-open = Aflezingen openen…
statistics-study-open-hint = Een bestand met aflezingen van een meetmiddel, in elk formaat van metingen
statistics-study-dialog = Aflezingen van een meetmiddel openen
statistics-study-readings = { $count ->
        [one] 1 aflezing
       *[other] { $count } aflezingen
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 aflezing
       *[other] { $count } aflezingen
    }
statistics-study-none = Open een bestand met aflezingen van een meetmiddel. De kolommen zeggen welk onderdeel door wie is gemeten. U ziet hoe het is begrepen voordat er iets wordt berekend.
statistics-study-kind = Soort studie
statistics-study-type1 = Type 1
statistics-study-crossed = Gekruist
statistics-study-nested = Genest
statistics-study-linearity = Lineariteit
statistics-study-stability = Stabiliteit
statistics-study-type1-hint = Eén referentie, 25 aflezingen of meer
statistics-study-crossed-hint = Elke operator meet elk onderdeel, twee keer of vaker
statistics-study-nested-hint = Elke operator heeft eigen onderdelen
statistics-study-linearity-hint = Meerdere referenties van verschillende maten
statistics-study-stability-hint = Eén referentie in de tijd
statistics-study-feature = Kenmerk van de studie
statistics-study-lower = Ondergrens
statistics-study-upper = Bovengrens
statistics-study-reference = Gekalibreerde maat
statistics-study-resolution = Afleesstap
statistics-study-references-hint = Eén maat per referentie met haar naam: M1 = 30.0012; M2 = 40.0005. Leeg gelden de nominale maten van het bestand.
statistics-study-reference-unnamed = { $given } noemt geen referentie: schrijf haar naam voor de maat, zoals M1 = 30.0012
statistics-study-own-limits = Grenzen van het bestand: { $lower } … { $upper } mm
statistics-study-understood = Hoe het bestand is begrepen
statistics-study-confirm = Er wordt niets berekend voordat u dit bevestigt.
statistics-study-evaluate = Evalueren
statistics-study-all-the-same = Toch evalueren
statistics-study-working = Wordt geëvalueerd…
statistics-study-answer = Is dit meetmiddel goed genoeg?
statistics-study-each = elk { $what }
statistics-study-parts = { $count ->
        [one] 1 onderdeel
       *[other] { $count } onderdelen
    }
statistics-study-operators = { $count ->
        [one] 1 operator
       *[other] { $count } operators
    }
statistics-study-repeats = { $count ->
        [one] 1 herhaling
       *[other] { $count } herhalingen
    }
statistics-study-masters = { $count ->
        [one] 1 referentie
       *[other] { $count } referenties
    }
statistics-study-points = { $count ->
        [one] 1 punt
       *[other] { $count } punten
    }
statistics-study-readings-between = { $least } tot { $most } aflezingen
statistics-study-more-faults = en nog { $count }
statistics-study-limits-differ = De grenzen van het bestand verschillen van waarde tot waarde: geef de onder- en bovengrens, of kies een kenmerk.
statistics-study-features = Het bestand heeft meerdere kenmerken: kies het gemeten kenmerk.
statistics-study-save-budget = Opslaan als budget…
statistics-study-save-budget-hint = De spreiding die de studie vond, als type A met vrijheidsgraden, voor de pagina Onzekerheid
statistics-study-no-budget = Deze studie geeft geen bijdrage aan een budget
statistics-study-source = { $of ->
        [part] onderdelen
        [operator] operators
        [interaction] interactie
        [repeatability] herhaalbaarheid
        [gauge] meetmiddel
       *[total] totaal
    }
statistics-study-mean-square = Gemiddeld kwadraat, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Variantie, { $source }
statistics-study-figure-reference = Gekalibreerde maat
statistics-study-figure-bias = Systematische afwijking
statistics-study-figure-mean-bias = Gemiddelde systematische afwijking
statistics-study-figure-bias-p = p van de afwijking
statistics-study-figure-bias-t = t van de afwijking
statistics-study-figure-bias-at = Afwijking bij { $size } mm ({ $count })
statistics-study-figure-smallest = Kleinste tolerantie
statistics-study-figure-smallest-good = Kleinste tolerantie, 10 %
statistics-study-figure-smallest-accepted = Kleinste tolerantie, 30 %
statistics-study-figure-repeatability = Herhaalbaarheid, s
statistics-study-figure-gauge = Meetmiddel, s
statistics-study-figure-of-variance = Aandeel van de variantie
statistics-study-figure-of-readings = Aandeel van alle aflezingen
statistics-study-figure-of-tolerance = Aandeel van de tolerantie
statistics-study-figure-categories = Te onderscheiden klassen
statistics-study-figure-slope = Helling
statistics-study-figure-slope-p = p van de helling
statistics-study-figure-intercept = Afwijking bij 0
statistics-study-figure-intercept-p = p van de afwijking bij 0
statistics-study-figure-residual = s rond de lijn
statistics-study-figure-centre = Middellijn
statistics-study-figure-lower-control = Onderste regelgrens
statistics-study-figure-upper-control = Bovenste regelgrens
statistics-study-figure-spread-centre = Gemiddelde spreiding
statistics-study-figure-spread-upper = Bovenste regelgrens van de spreiding
