# De gang door een onderdeel, en de bewaakte map, op de pagina Delen.

walk-page-begin = Onderdeel beginnen
walk-page-count-up = Doortellen
walk-page-take = Waarde nemen
walk-page-take-meant = { $meant } mm nemen
walk-page-simulate = Simuleren
walk-page-simulate-hint = Meet met de cyclus van het kenmerk op een volmaakt onderdeel: niemand heeft gemeten, en zo blijft het gemerkt
walk-page-again = Opnieuw meten
walk-page-skip = Overslaan
walk-page-skip-for = Om deze reden overslaan
walk-page-skip-not = Niet overslaan
walk-page-next = Volgend onderdeel
walk-page-move = Andere maat
walk-page-import = Waarden importeren…
walk-page-watch = Map bewaken…
walk-page-watch-hint = Bestanden die erin komen worden met het plan beoordeeld en vastgelegd, elk één keer
walk-page-watch-stop = Niet meer bewaken
walk-page-dialog-watch = Een map bewaken
walk-page-no-plan = Nog geen plan: open er een, of schrijf er een in de weergave Plan.
walk-page-plan-wrong = { $count ->
        [one] Het plan heeft een fout: zie de weergave Plan.
       *[other] Het plan heeft { $count } fouten: zie de weergave Plan.
    }
walk-page-not-saved = Het plan heeft wijzigingen die in geen bestand staan: een onderbroken onderdeel kan na een herstart niet terugkomen.
walk-page-serial = Serienummer
walk-page-serial-hint = Typ of scan het, of tel door; Enter begint het onderdeel.
walk-page-recent = Laatst gelezen plannen
walk-page-done = Elke maat heeft een waarde of een reden
walk-page-part = { $part }, serienummer { $serial }
walk-page-part-serial = Serienummer { $serial }
walk-page-part-no-serial = { $part } zonder serienummer
walk-page-other-plan = Het plan is sindsdien gewijzigd: dat telt vanaf het volgende onderdeel.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = Het plan heeft er geen plaats voor
walk-page-value = Gemeten waarde
walk-page-measured-before = { $count ->
        [one] Eén keer gemeten: beide waarden blijven, en de volgende telt
       *[other] { $count } keer gemeten: alle waarden blijven, en de volgende telt
    }
walk-page-last-counts = { $count } keer gemeten: alle waarden blijven, en deze telt
walk-page-skip-why = Waarom wordt het overgeslagen?
walk-page-skip-access = Geen toegang voor de taster
walk-page-skip-gauge = Het meetmiddel ontbreekt
walk-page-skip-machined = Nog niet bewerkt
walk-page-skip-elsewhere = Elders gemeten
walk-page-reason = Andere reden
walk-page-no-reason = een reden ontbreekt
walk-page-skipped = overgeslagen: { $reason }
walk-page-next-warned = { $count ->
        [one] Eén maat heeft geen waarde en geen reden. Nog eens Volgend onderdeel beëindigt het onderdeel.
       *[other] { $count } maten hebben geen waarde en geen reden. Nog eens Volgend onderdeel beëindigt het onderdeel.
    }
walk-page-question-enter = Nog eens Enter neemt hem zoals hij is.
walk-page-part-status = Het onderdeel
walk-page-not-complete = Nog geen oordeel
walk-page-simulated = { $count ->
        [one] Eén waarde is gesimuleerd: niemand heeft gemeten, en het onderdeel is er niet goed door.
       *[other] { $count } waarden zijn gesimuleerd: niemand heeft gemeten, en het onderdeel is er niet goed door.
    }
walk-page-missing = Ontbreekt: { $names }
walk-page-off = Vastleggen staat uit: een onderbroken onderdeel kan na een herstart niet terugkomen.
walk-page-nowhere = Er wordt niets vastgelegd: een onderbroken onderdeel kan na een herstart niet terugkomen.
walk-page-no-part = Er wordt geen onderdeel gemeten.
walk-page-sizes = Maten van het onderdeel
walk-page-open = open
walk-page-row-simulated = gesimuleerd
walk-page-times = { $count } waarden
walk-page-rule-plan = Beoordeeld met de regel van het plan: { $rule }
walk-page-rule-own = Het plan heeft geen regel; beoordeeld met de regel van de pagina Controle: { $rule }
walk-page-not-corrected = Niet naar 20 °C herleid: een plaats op het onderdeel is geen maat
walk-page-material = Naar 20 °C herleid met het materiaal van het plan, { $name }
walk-page-nothing-asked = er wordt geen maat van het plan gevraagd
walk-page-refused = { $count ->
        [one] Een controle is niet vastgelegd: { $why }
       *[other] { $count } controles zijn niet vastgelegd: { $why }
    }
walk-page-import-late = { $name } werd gelezen toen het onderdeel al beëindigd was: de waarden zijn niet genomen
walk-page-imported = { $name }: { $good } genomen, { $bad } niet
walk-page-other-parts = Waarden van andere onderdelen zijn onder hun eigen serienummers vastgelegd: { $serials }
walk-page-not-judged = regel { $line }: { $why }
walk-page-no-journal = Het onderdeel { $serial } is terug zonder zijn waarden: er is niets vastgelegd waaruit ze konden komen
walk-page-gone = Sommige maten staan niet meer in het plan: wat ervan gemeten is blijft vastgelegd
walk-page-gone-name = { $name }
walk-page-taken-back = Een waarde van { $name } is in het journaal verbeterd of ingetrokken: hij telt niet meer voor dit onderdeel
walk-page-put-right = Een waarde van { $name } is in het journaal verbeterd: de verbeterde telt voor dit onderdeel
walk-page-no-folder = { $path } is geen map
walk-page-not-read = De waarden van het onderbroken onderdeel konden niet worden gelezen: { $why }
walk-page-came-back = { $count ->
        [one] Het onderbroken onderdeel { $serial } is terug, met één waarde
       *[other] Het onderbroken onderdeel { $serial } is terug, met { $count } waarden
    }
walk-page-watched = Bewaakte map
walk-page-watch-no-plan = een map wordt bewaakt met een plan zonder fouten: open er eerst een
walk-page-watch-no-journal = het journaal kan niet worden geopend: wat al genomen is, is niet bekend, dus er wordt geen map bewaakt
walk-page-watch-begins = Het journaal wordt gevraagd wat al genomen is
walk-page-known = { $count ->
        [0] Het journaal heeft nog geen bestanden
        [one] Het journaal heeft één eerder bestand, uit welke map ook: het wordt niet nog eens genomen
       *[other] Het journaal heeft { $count } eerdere bestanden en delen van bestanden, uit welke map ook: ze worden niet nog eens genomen
    }
walk-page-mask = Afdrukken worden teruggelezen door het masker { $name }
walk-page-watch-recording = Wordt vastgelegd
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] Eén bestand genomen
       *[other] { $count } bestanden genomen
    }
walk-page-report = Rapport…
walk-page-report-html = Meetrapport (HTML)…
walk-page-report-csv = Waarden van het onderdeel als CSV…
walk-page-report-json = Waarden van het onderdeel als JSON…
walk-page-because = Wegens { $names }
walk-page-left-out = Overgeslagen: { $names }. Een onderdeel met overgeslagen maten kan niet goed zijn.
walk-page-whole = Het hele onderdeel
walk-page-whole-serial = Onderdeel { $serial }
walk-page-strip-open = Het onderdeel: nog geen oordeel
walk-page-strip-part = Het onderdeel: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Gemeten met het plan { $name }
walk-page-judged-by-plan = Beoordeeld met het plan { $name }
walk-page-report-other-picture = { $name }: het plan noemt een andere afbeelding sinds met dit onderdeel begonnen is
