page-statistics = Statistiek

# Wat gevraagd wordt
statistics-page-question = Regels
statistics-page-question-hint = De regels waarvan de waarden worden gebruikt, in de taal van de pagina Logboek, zoals part:"Flens 40" station:"Frees 3" from:2026-11-01. Leeg: alle regels.
statistics-page-last = Nieuwste waarden
statistics-page-size = Waarden per punt
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
statistics-page-take-in = Weer meetellen
statistics-page-reason = Reden
statistics-page-take-reason = Weglaten
statistics-page-cancel-reason = Annuleren
statistics-page-copy = Cijfers kopiëren
statistics-page-copy-hint = Cijfers, signalen en advies als tabel voor een spreadsheet
statistics-page-report = Rapport…
statistics-page-report-hint = De getallen en grafieken van alle kenmerken als rapport om te ondertekenen

# Signalen
statistics-page-signals = Signalen
statistics-page-no-signals = Geen regel slaat aan.
statistics-page-rules = Regels van de kaart
statistics-page-on-spread = Spreiding: { $rule }
statistics-page-alarms = Open alarmen: { $count }
statistics-page-at = Punt { $point }
statistics-page-from-to = Punten { $first } tot en met { $last }
statistics-page-left-out-because = Weggelaten: { $reason }
statistics-page-advice = Advies
