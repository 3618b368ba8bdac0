# De gang door een onderdeel, en de bewaakte map, op de pagina Onderdelen.

walk-page-begin = Onderdeel beginnen
walk-page-count-up = Volgend nummer
walk-page-take = Beoordelen
walk-page-take-meant = { $meant } mm gebruiken
walk-page-it-is-so = Het klopt: { $measured } mm beoordelen
walk-page-measure-anew = Verwerpen en opnieuw meten
walk-page-confirmed = bij het meten bevestigd: het klopt
walk-page-alarms = Open alarmen: { $count }
walk-page-alarms-short = Alarmen
walk-page-alarms-more = Meer alarmen: { $count }
walk-page-alarm = { $name }: { $said }
walk-page-alarm-ask = Alarm beantwoorden
walk-page-alarm-ask-of = Alarm van { $name } beantwoorden
walk-page-alarm-answer = Antwoord vastleggen
walk-page-alarm-later = Later
walk-page-alarm-cause = Oorzaak
walk-page-alarm-action = Maatregel
walk-page-alarm-causes = Gereedschapsslijtage; Nieuw gereedschap; Gereedschapscorrectie; Opspanning; Spanen of vuil; Temperatuur; Materiaal; Meetfout; Onbekend
walk-page-alarm-actions = Gereedschap gewisseld; Correctie aangepast; Onderdeel opnieuw opgespannen; Machine schoongemaakt; Opnieuw gemeten; Insteller ingelicht; Wordt gevolgd; Geen nodig
walk-page-alarm-empty = schrijf een tekst, of kies er een uit de lijst
walk-page-alarms-unread = De regels van de regelkaarten kunnen niet worden bekeken: { $why }
walk-page-alarms-unchecked = De regels van de regelkaarten kunnen niet worden bekeken, { $name }: { $why }
walk-page-alarm-unrecorded = Het alarm van de regelkaart kan niet worden vastgelegd: { $why }
walk-page-simulate = Simuleren
walk-page-simulate-hint = Voert de cyclus van het element uit op een perfect onderdeel; niemand meet de waarde, en ze blijft gemerkt als gesimuleerd
walk-page-again = Opnieuw meten
walk-page-skip = Overslaan
walk-page-skip-for = Om deze reden overslaan
walk-page-skip-not = Niet overslaan
walk-page-next = Volgend onderdeel
walk-page-move = Naar een andere maat
walk-page-import = Waarden importeren…
walk-page-watch = Map bewaken…
walk-page-watch-hint = Bestanden die in de map worden gezet, worden met het plan beoordeeld en vastgelegd, elk één keer
walk-page-watch-stop = Bewaken stoppen
walk-page-dialog-watch = Map bewaken
walk-page-begin-warned = { $count ->
    [one] 1 maat van dit onderdeel heeft geen waarde en geen reden. Druk nog eens om dit onderdeel te beëindigen.
   *[other] { $count } maten van dit onderdeel hebben geen waarde en geen reden. Druk nog eens om dit onderdeel te beëindigen.
}
walk-page-no-plan = Nog geen plan: open er een, of maak er een in de weergave Plan.
walk-page-plan-wrong = { $count ->
        [one] Het plan heeft een fout: zie de weergave Plan.
       *[other] Het plan heeft { $count } fouten: zie de weergave Plan.
    }
walk-page-not-saved = Het plan heeft niet-opgeslagen wijzigingen: een onderbroken onderdeel kan na een herstart niet worden hersteld.
walk-page-serial = Serienummer
walk-page-serial-again = Serienummer { $serial } is al gemeten. Druk na een halve seconde nog eens op Enter om het opnieuw te beginnen.
walk-page-serial-hint = Typ of scan het, of gebruik het volgende nummer; Enter begint het onderdeel.
walk-page-recent = Recente plannen
walk-page-done = Elke maat heeft een waarde of is overgeslagen
walk-page-part = { $part }, serienummer { $serial }
walk-page-part-serial = Serienummer { $serial }
walk-page-part-no-serial = { $part } zonder serienummer
walk-page-other-plan = Het plan is sindsdien gewijzigd: de wijzigingen gelden vanaf het volgende onderdeel.
walk-page-part-of = Dit onderdeel wordt gemeten met { $own }
walk-page-open-is = Nu geopend: { $open }
walk-page-begin-by = Onderdeel beginnen met { $open }
walk-page-keep-on = Dit onderdeel verder meten
walk-page-unfinished = Een onderdeel met { $own } is niet af. Meten vraagt of het verdergaat.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = Geen plaats in het plan
walk-page-value = Gemeten waarde
walk-page-measured-before = { $count ->
        [one] Eén keer gemeten: beide waarden blijven bewaard, en de nieuwe telt
       *[other] { $count } keer gemeten: alle waarden blijven bewaard, en de nieuwe telt
    }
walk-page-last-counts = { $count } keer gemeten: alle waarden blijven bewaard, en deze telt
walk-page-skip-why = Reden om over te slaan
walk-page-skip-access = Geen toegang voor het tastsysteem
walk-page-skip-gauge = Meetmiddel ontbreekt
walk-page-skip-machined = Nog niet bewerkt
walk-page-skip-elsewhere = Elders gemeten
walk-page-reason = Andere reden
walk-page-no-reason = een reden ontbreekt
walk-page-skipped = overgeslagen: { $reason }
walk-page-next-warned = { $count ->
        [one] Eén maat heeft geen waarde en geen reden. Kies nog eens Volgend onderdeel om dit onderdeel te beëindigen.
       *[other] { $count } maten hebben geen waarde en geen reden. Kies nog eens Volgend onderdeel om dit onderdeel te beëindigen.
    }
walk-page-typed-elsewhere = de waarde is getypt voor { $name }, en nu wordt { $asked } gevraagd: typ die opnieuw
walk-page-next-size = Volgende: { $name }, { $asked }
walk-page-is-serial = { $given } lijkt op een serienummer en wordt niet als waarde genomen: rond eerst dit onderdeel af en scan het dan voor het volgende. Is het de gemeten waarde, typ die dan met meer decimalen
walk-page-simulate-measured = { $name } is gemeten: een gesimuleerde waarde komt nooit in de plaats van een gemeten waarde
walk-page-part-status = Status van het onderdeel
walk-page-not-complete = Nog geen oordeel
walk-page-simulated = { $count ->
        [one] Eén waarde is gesimuleerd: niemand heeft die gemeten, dus daarmee kan het onderdeel niet goed zijn.
       *[other] { $count } waarden zijn gesimuleerd: niemand heeft die gemeten, dus daarmee kan het onderdeel niet goed zijn.
    }
walk-page-missing = Ontbreekt: { $names }
walk-page-off = Vastleggen staat uit: een onderbroken onderdeel kan na een herstart niet worden hersteld.
walk-page-nowhere = Er wordt niets vastgelegd: een onderbroken onderdeel kan na een herstart niet worden hersteld.
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
walk-page-import-late = { $name } is gelezen nadat het onderdeel beëindigd was: de waarden zijn niet gebruikt
walk-page-imported = { $name }: { $good } geïmporteerd, { $bad } niet
walk-page-file-for-check = Niets hiervan hoort bij dit plan. De pagina Controle kan het bestand beoordelen naar wat het zelf vraagt
walk-page-found-by-name = { $count ->
    [one] Gevonden op naam: 1 rij
   *[other] Gevonden op naam: { $count } rijen
}
walk-page-found-by-number = Alleen op nummer gevonden, met hun regels: { $rows }
walk-page-found-by-place = Op plaats gevonden, met hun regels: { $rows }
walk-page-other-parts = Waarden van andere onderdelen zijn onder hun eigen serienummers vastgelegd: { $serials }
walk-page-label = Het bestand heeft geen serienummers en noemt het onderdeel { $part }: de waarden zijn voor dit onderdeel gebruikt
walk-page-other-label = van het onderdeel { $part }, en zonder serienummer is niet bekend of dat dit onderdeel is
walk-page-remark-label = Onderdeel in het bestand: { $part }
walk-page-not-judged = regel { $line }: { $why }
walk-page-no-journal = Onderdeel { $serial } is hersteld zonder zijn waarden: er is niets vastgelegd om ze uit te herstellen
walk-page-gone = Sommige maten staan niet meer in het plan: hun gemeten waarden blijven vastgelegd
walk-page-gone-name = { $name }
walk-page-changed = Het plan is gewijzigd: waarden die met andere grenzen of een andere regel beoordeeld zijn, en waarden van rijen zonder naam, blijven vastgelegd, en hun maten zijn weer open
walk-page-changed-size = { $name }: { $measured } mm is gemeten met { $asked }
walk-page-given-up = Het onderbroken onderdeel { $serial } wordt niet hersteld, omdat een ander onderdeel begonnen is: de waarden blijven vastgelegd
walk-page-ended = Niet gebruikt voor onderdeel { $serial }, dat beëindigd is
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = Een waarde van { $name } is in het logboek gecorrigeerd of ingetrokken: ze telt niet meer voor dit onderdeel
walk-page-put-right = Een waarde van { $name } is in het logboek gecorrigeerd: de gecorrigeerde telt voor dit onderdeel
walk-page-no-folder = { $path } is geen map
walk-page-not-read = De waarden van het onderbroken onderdeel konden niet worden gelezen: { $why }
walk-page-came-back = { $count ->
        [one] Het onderbroken onderdeel { $serial } is hersteld met één waarde
       *[other] Het onderbroken onderdeel { $serial } is hersteld met { $count } waarden
    }
walk-page-watched = Bewaakte map
walk-page-part-waits = Onderdeel { $serial } wordt hersteld zodra het plan geen fouten meer heeft
walk-page-watch-waits = Map { $path } wordt weer bewaakt zodra het plan geen fouten meer heeft
walk-page-watch-no-plan = om een map te bewaken is een plan zonder fouten nodig: open er eerst een
walk-page-watch-no-journal = het logboek kan niet worden geopend: welke bestanden al geïmporteerd zijn, is niet bekend, dus er wordt geen map bewaakt
walk-page-watch-begins = In het logboek wordt gezocht naar bestanden die al geïmporteerd zijn
walk-page-known = { $count ->
        [0] Het logboek heeft geen eerder geïmporteerde bestanden
        [one] Het logboek heeft één eerder geïmporteerd bestand, uit welke map ook: het wordt niet opnieuw geïmporteerd
       *[other] Het logboek heeft { $count } eerder geïmporteerde bestanden en delen van bestanden, uit welke map ook: ze worden niet opnieuw geïmporteerd
    }
walk-page-mask = FN 16-uitvoer wordt teruggelezen via het masker { $name }
walk-page-watch-recording = Wordt vastgelegd
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] Eén bestand geïmporteerd
       *[other] { $count } bestanden geïmporteerd
    }
walk-page-report = Rapport…
walk-page-report-people = Meetrapport ({ $format })…
walk-page-report-programs = Waarden van het onderdeel als { $format }…
walk-page-contradicted = { $names }: waarden spreken elkaar tegen, en niets zegt welke juist is. De slechtste telt tot er opnieuw gemeten of gekozen is.
walk-page-contradicting = { $name } heeft waarden die elkaar tegenspreken: { $values }. De slechtste telt tot er opnieuw gemeten of gekozen is.
walk-page-count-newest = De laatste waarde telt
walk-page-newest-counts = { $name }: de laatste waarde telt, zoals gekozen
walk-page-accepted = Buiten de grenzen aanvaard: { $names }
walk-page-because = Wegens { $names }
walk-page-left-out = Overgeslagen: { $names }. Een onderdeel met overgeslagen maten kan niet goed zijn.
walk-page-whole = Het hele onderdeel
walk-page-whole-serial = Onderdeel { $serial }
walk-page-strip-open = Het onderdeel: nog geen oordeel
walk-page-strip-part = Het onderdeel: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Gemeten met het plan { $name }
walk-page-judged-by-plan = Beoordeeld met het plan { $name }
walk-page-watch-no-mask = Het eigen masker { $path } kan niet worden gelezen: de map wordt bewaakt zodra dit masker opnieuw of een ander masker gekozen is (Menu, Eigen masker…)
walk-page-watch-nobody = { $count ->
        [one] Eén waarde is vastgelegd zonder serienummer: het bestand noemt er geen, en er wordt geen onderdeel met dit plan gemeten
       *[other] { $count } waarden zijn vastgelegd zonder serienummer: het bestand noemt er geen, en er wordt geen onderdeel met dit plan gemeten
    }
walk-page-watch-other-plan = De map wordt beoordeeld met het plan zoals het was toen de bewaking begon. Begin een onderdeel, of bewaak de map opnieuw, om met het huidige plan te beoordelen.
walk-page-watch-not-saved = Het plan heeft niet-opgeslagen wijzigingen: de map wordt na een herstart niet opnieuw bewaakt.
walk-page-values = Waarden van { $name }
walk-page-to-do = { $name }: { $what }
walk-page-of = maat { $at } van { $count }
walk-page-no-serial = Zonder serienummer
