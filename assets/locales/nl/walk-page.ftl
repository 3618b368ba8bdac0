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
walk-page-serial-again = Serienummer { $serial } is al gemeten. Nog eens Enter, na een halve seconde, begint het opnieuw.
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
walk-page-typed-elsewhere = de waarde is getypt voor { $name }, en nu wordt { $asked } gevraagd: typ hem opnieuw
walk-page-next-size = Volgende: { $name }, { $asked }
walk-page-is-serial = { $given } lijkt op een serienummer en wordt niet als waarde genomen: rond eerst dit onderdeel af en scan het dan voor het volgende. Is het de gemeten waarde, typ die dan met meer decimalen
walk-page-simulate-measured = { $name } is gemeten: een gesimuleerde waarde komt nooit in de plaats van een gemeten waarde
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
walk-page-nothing-asked = er wordt geen maat van het plan gevraagd
walk-page-refused = { $count ->
        [one] Een controle is niet vastgelegd: { $why }
       *[other] { $count } controles zijn niet vastgelegd: { $why }
    }
walk-page-import-late = { $name } werd gelezen toen zijn onderdeel al beëindigd was: de waarden zijn niet genomen
walk-page-imported = { $name }: { $good } genomen, { $bad } niet
walk-page-other-parts = Waarden van andere onderdelen zijn onder hun eigen serienummers vastgelegd: { $serials }
walk-page-label = Het bestand heeft geen serienummers en noemt het onderdeel { $part }: de waarden zijn voor dit onderdeel genomen
walk-page-other-label = van het onderdeel { $part }, en zonder serienummer is niet bekend of dat dit onderdeel is
walk-page-remark-label = Onderdeel in het bestand: { $part }
walk-page-not-judged = regel { $line }: { $why }
walk-page-no-journal = Het onderdeel { $serial } is terug zonder zijn waarden: er is niets vastgelegd waaruit ze konden komen
walk-page-gone = Sommige maten staan niet meer in het plan: wat ervan gemeten is blijft vastgelegd
walk-page-gone-name = { $name }
walk-page-changed = Het plan is gewijzigd: waarden met andere grenzen, met een andere regel of van rijen zonder naam blijven vastgelegd, en hun maten zijn open
walk-page-changed-size = { $name }: { $measured } mm is gemeten met { $asked }
walk-page-given-up = Het onderbroken onderdeel { $serial } komt niet terug, omdat een ander onderdeel begonnen is: de waarden blijven vastgelegd
walk-page-ended = Overgeslagen van het onderdeel { $serial }, dat beëindigd is
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = Een waarde van { $name } is in het journaal verbeterd of ingetrokken: hij telt niet meer voor dit onderdeel
walk-page-put-right = Een waarde van { $name } is in het journaal verbeterd: de verbeterde telt voor dit onderdeel
walk-page-no-folder = { $path } is geen map
walk-page-not-read = De waarden van het onderbroken onderdeel konden niet worden gelezen: { $why }
walk-page-came-back = { $count ->
        [one] Het onderbroken onderdeel { $serial } is terug, met één waarde
       *[other] Het onderbroken onderdeel { $serial } is terug, met { $count } waarden
    }
walk-page-watched = Bewaakte map
walk-page-part-waits = Onderdeel { $serial } komt terug zodra het plan geen fouten meer heeft
walk-page-watch-waits = Map { $path } wordt weer bewaakt zodra het plan geen fouten meer heeft
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
walk-page-contradicted = { $names }: waarden spreken elkaar tegen, en niets zegt welke juist is. De slechtste telt tot u opnieuw meet of kiest.
walk-page-contradicting = { $name } heeft waarden die elkaar tegenspreken: { $values }. De slechtste telt tot u opnieuw meet of kiest.
walk-page-count-newest = De laatste waarde telt
walk-page-newest-counts = { $name }: de laatste waarde telt, zoals gekozen
walk-page-because = Wegens { $names }
walk-page-left-out = Overgeslagen: { $names }. Een onderdeel met overgeslagen maten kan niet goed zijn.
walk-page-whole = Het hele onderdeel
walk-page-whole-serial = Onderdeel { $serial }
walk-page-strip-open = Het onderdeel: nog geen oordeel
walk-page-strip-part = Het onderdeel: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Gemeten met het plan { $name }
walk-page-judged-by-plan = Beoordeeld met het plan { $name }
walk-page-watch-no-mask = Je eigen masker { $path } kan niet worden gelezen: de map wordt bewaakt zodra het opnieuw of een ander masker gekozen is (Menu, Eigen masker…)
walk-page-watch-nobody = { $count ->
        [one] Eén waarde is vastgelegd zonder serienummer: het bestand noemt er geen, en er wordt geen onderdeel met dit plan gemeten
       *[other] { $count } waarden zijn vastgelegd zonder serienummer: het bestand noemt er geen, en er wordt geen onderdeel met dit plan gemeten
    }
walk-page-watch-other-plan = De map wordt beoordeeld met het plan zoals het was toen de bewaking begon. Begin een onderdeel, of bewaak de map opnieuw, om met het huidige plan te beoordelen.
walk-page-watch-not-saved = Het plan heeft wijzigingen die in geen bestand staan: de map wordt na een herstart niet opnieuw bewaakt.
