page-budget = Onzekerheid
page-budget-also = Budget

budget-page-text = Budget als TOML
budget-page-none = Een nieuw budget beginnen, of er een openen
budget-page-new = Nieuw budget
budget-page-open = Budget openen…
budget-page-save = Budget opslaan als…
budget-page-dialog-open = Een budget openen
budget-page-dialog-save = Het budget opslaan
budget-page-dialog-readings = Aflezingen van het gekalibreerde werkstuk
budget-page-not-saved = { $name }, niet opgeslagen

budget-page-for = Berekend voor
budget-page-size = Gemeten maat
budget-page-contacts = Meetpunten
budget-page-touches = Aantal meetpunten
budget-page-step = Stap
budget-page-contacts-hint = Leeg: de meetpunten van het budget
budget-page-day = Dag
budget-page-day-hint = Dag leeg: vandaag, { $day }
budget-page-no-day = { $given } is geen dag: JJJJ-MM-DD verwacht
budget-page-other-missing = Ontbreekt: geef zowel het aantal meetpunten als de stap, of geen van beide
budget-page-take-check = Van de getoonde controle
budget-page-take-recorded = Opgenomen meetpunten
budget-page-own-contacts = Van het budget
budget-page-of-check = { $count } meetpunten van de controle { $what }, { $time }
budget-page-of-simulated-check = { $count } meetpunten van de controle { $what }, { $time }, gesimuleerd
budget-page-of-recorded = { $count } opgenomen meetpunten van { $name }
budget-page-contacts-used = { $count } meetpunten, factor { $factor }
budget-page-contacts-stepped = { $count } meetpunten om de { $step }°, factor { $factor }
budget-page-no-circle = De meetpunten worden niet gebruikt: { $problem }

budget-page-readings = Aflezingen
budget-page-open-readings = Uit een bestand…
budget-page-take-readings = Uit de geschiedenis
budget-page-own-readings = Van het budget
budget-page-readings-own = { $count ->
        [one] één aflezing in het budget
       *[other] { $count } aflezingen in het budget
    }
budget-page-readings-of-file = { $count ->
        [one] één aflezing van { $name }
       *[other] { $count } aflezingen van { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] één aflezing: de controle van de geschiedenis
       *[other] { $count } aflezingen: alle controles van de geschiedenis
    }
budget-page-readings-of-chosen = { $count ->
        [one] één aflezing: de gekozen controle van de geschiedenis
       *[other] { $count } aflezingen: de gekozen controles van de geschiedenis
    }
budget-page-readings-are-shafts = { $count ->
        [one] een controle van een as is
       *[other] { $count } controles van assen zijn
    } niet gebruikt: het werkstuk is een boring
budget-page-readings-are-holes = { $count ->
        [one] een controle van een boring is
       *[other] { $count } controles van boringen zijn
    } niet gebruikt: het werkstuk is een as
budget-page-readings-simulated = { $count ->
        [one] één aflezing is
       *[other] { $count } aflezingen zijn
    } gesimuleerd: er is niets gemeten
budget-page-more-notes = { $count ->
        [one] en nog één
       *[other] en nog { $count }
    }

budget-page-answer = Uitgebreide onzekerheid
budget-page-no-answer = Geen antwoord
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } voor 95,45 %
budget-page-at-size = Voor { $size } mm; elke controle krijgt de onzekerheid van de eigen maat
budget-page-covered-by = k = { $k } volgens { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Effectieve vrijheidsgraden { $degrees }
budget-page-infinite = oneindig
budget-page-valid = Geldig tot en met { $until }
budget-page-expired = VERLOPEN
budget-page-expired-on = geldig tot en met { $until }, op { $day }
budget-page-not-yet = NOG NIET GELDIG
budget-page-not-yet-on = geldig vanaf { $date }
budget-page-made = Opgesteld { $date } door { $by }
budget-page-method = Methode { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Grootste bijdrage
budget-page-largest-is = { $name }, { $percent } % van de variantie
budget-page-help = Wat het meest zou helpen
budget-page-help-halved = De helft ervan: u = { $u } µm
budget-page-help-part-temperature = De onzekerheid van de werkstuktemperatuur gehalveerd: u = { $u } µm
budget-page-help-scale-temperature = De onzekerheid van de temperatuur van de meetlinialen gehalveerd: u = { $u } µm
budget-page-help-expansion = Half zo ver van 20 °C, of de onzekerheid van de uitzetting gehalveerd: u = { $u } µm
budget-page-help-full-circle = { $count } meetpunten gelijkmatig over de hele cirkel: u = { $u } µm
budget-page-help-more-touches = { $count } meetpunten gelijkmatig over de hele cirkel: u = { $u } µm

budget-page-checks = Controles
budget-page-use = Voor controles gebruiken
budget-page-leave = Niet meer gebruiken
budget-page-uses-none = Controles gebruiken geen budget
budget-page-uses-this = In gebruik: { $name }
budget-page-uses-another = In gebruik: { $name } uit { $file }, dat afwijkt van wat hier staat
budget-page-uses-typed = “{ $name }” telt niet mee: controles gebruiken de onzekerheid die op de pagina Controle is gekozen
budget-page-uses-no-rule = “{ $name }” is gekozen, maar op de pagina Controle gebruikt nog geen regel een onzekerheid: kies daar de regel
budget-page-used-before = Tot nu toe gebruikten controles de getypte onzekerheid ({ $uncertainty }). Met “Niet meer gebruiken” komt die terug
budget-page-used = Controles gebruiken het budget { $name }
budget-page-used-no-rule = “{ $name }” verandert nog geen oordeel: de regel op de pagina Controle is “{ $rule }”, en die gebruikt geen onzekerheid. Kies een andere regel
budget-page-not-kept = Sla het budget op om het ook na een herstart te gebruiken
budget-page-readings-not-kept = De aflezingen staan niet in het budgetbestand: na een herstart wordt het budget niet meer gebruikt
budget-page-used-unread = { $path }: het budget dat voor controles in gebruik was, kan niet worden gelezen, dus gebruiken controles geen budget: { $problem }

budget-page-table = Bijdragen
budget-page-column-name = Naam
budget-page-column-type = Type
budget-page-column-law = Verdeling
budget-page-column-sensitivity = c
budget-page-column-share = Aandeel
budget-page-row = { $name }, type { $type }, { $law }, u { $u } { $unit }, gevoeligheid { $sensitivity }, bijdrage { $um } µm, aandeel { $percent } %, vrijheidsgraden { $degrees }
budget-page-law-normal = normaal
budget-page-law-rectangular = rechthoekig
budget-page-law-u-shaped = U-vormig
budget-page-law-triangular = driehoekig
budget-page-shares = Aandelen in de variantie
budget-page-terms = Termen en uitgebreide onzekerheid
budget-page-mean = Gemiddelde van de aflezingen { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, gecorrigeerd
budget-page-edition-2004 = U, 2004, niet gecorrigeerd
budget-page-nothing-seen = De tabel en de aandelen verschijnen zodra het budget berekend kan worden
budget-page-named = { $name }
budget-page-placeholders = Controles kunnen dit budget nog niet gebruiken. Deze gegevens zijn nog die van het sjabloon: { $what }. Typ eigen gegevens in hun velden
budget-page-placeholder-name = de naam (“{ $name }”)
budget-page-placeholder-by = de opsteller (“{ $by }”)
budget-page-placeholder-figures = de getallen van alle bijdragen

## Het budget als tabel

budget-show-table = Tabel
budget-show-text = Tekst
budget-rows = Bijdragen
budget-head-name = Naam van het budget
budget-head-by = Opgesteld door
budget-row-new = Nieuwe bijdrage
budget-row-add = Bijdrage toevoegen
budget-row-remove = Bijdrage verwijderen
budget-row-removed = Bijdrage “{ $name }” uit het budget verwijderd
budget-row-comments-removed = Het commentaar bij de verwijderde sleutels is vervallen
budget-row-said = { $value } { $unit }, deler { $divisor }, { $law }
budget-row-unread = niet volledig
budget-row-name = Naam
budget-row-k = Dekkingsfactor k
budget-row-alpha = Uitzetting, 1/K
budget-row-delta = Afstand tot 20 °C
budget-row-touches = Eigen meetpunten
budget-row-step = Eigen stap
budget-row-sensitivity = Gevoeligheid c
budget-row-freedom = Vrijheidsgraden
budget-row-freedom-a = Vrijheidsgraden, n − 1 van n aflezingen
budget-row-kind = Werkt op
budget-row-type = Type
budget-row-law = Verdeling
budget-row-given = Opgegeven als
budget-row-half-width = Halve breedte
budget-row-resolution = Stap van de aanduiding
budget-given-standard = Standaardonzekerheid
budget-given-expanded = Uitgebreide onzekerheid
budget-type-a = A, statistiek
budget-type-b = B, anders
budget-kind-plain = Diameter
budget-kind-scatter = Spreiding van één tasting
budget-kind-part-temperature = Temperatuur van het werkstuk
budget-kind-scale-temperature = Temperatuur van de meetlinialen
budget-kind-part-expansion = Uitzetting van het werkstuk
budget-kind-scale-expansion = Uitzetting van de meetlinialen
budget-kind-resolution = Resolutie
budget-table-stale = De tekst bevat een fout: de tabel toont de bijdragen zoals ze het laatst waren
budget-table-other = De tekst schrijft de bijdragen op een manier die de tabel niet kan wijzigen. Bewerk de tekst
budget-table-calibrated = Dit budget is van een gekalibreerd werkstuk en heeft geen bijdragen. Bewerk de tekst
budget-law-normal = Normale verdeling
budget-law-rectangular = Rechthoekige verdeling
budget-law-u-shaped = U-vormige verdeling
budget-law-triangular = Driehoekige verdeling
