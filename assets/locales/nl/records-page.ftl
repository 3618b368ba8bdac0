page-records = Logboek

## Wat bij een controle wordt vastgelegd
records-page-fold = Vastleggen
records-page-fold-hint = Serienummer en opmerking worden bij de volgende controles vastgelegd
records-page-serial = Serienummer
records-page-serial-short = Serienr.
records-page-remark = Opmerking
records-page-feature = Element
records-page-record = Vastlegging { $number }
records-page-waiting = Wordt vastgelegd
records-page-not-recorded = Niet vastgelegd: { $why }
records-page-nowhere = Controles worden niet vastgelegd: er is geen gegevensmap voor
records-page-off = Controles worden niet vastgelegd: het vastleggen is uitgezet in het statusbestand
records-page-opening = Het logboek wordt geopend
records-page-how-on = Het deel [records] van het statusbestand, state.toml, noemt het logboekbestand en zegt of controles worden vastgelegd.
records-page-not-opened = Het logboek kan niet worden geopend, en controles worden niet vastgelegd: { $why }
records-page-not-kept = { $count ->
    [one] 1 controle is niet vastgelegd: { $why }
   *[other] { $count } controles zijn niet vastgelegd: { $why }
}
records-page-refused = { $count ->
    [one] 1 controle kan niet worden vastgelegd: { $why }
   *[other] { $count } controles kunnen niet worden vastgelegd; de reden bij de eerste: { $why }
}
records-page-not-kept-why = het logboek gaf geen antwoord
records-page-no-thread = het systeem kan geen thread voor het logboek starten
records-page-interrupted = het is onderbroken
records-page-failed = { $count ->
    [one] 1 controle is niet vastgelegd
   *[other] { $count } controles zijn niet vastgelegd
}
records-page-try-again = Opnieuw proberen
records-page-stay = Vastleggingen blijven in het logboek
records-page-leave = { $count ->
    [one] 1 controle is nog niet vastgelegd. Die gaat verloren als het venster sluit.
   *[other] { $count } controles zijn nog niet vastgelegd. Die gaan verloren als het venster sluit.
}

## Wie er meet
records-page-who = Gemeten door
records-page-nobody = Naam…
records-page-who-nobody = Er is geen naam gekozen. Een naam kiezen
records-page-who-is = Gemeten door { $name }
records-page-nobody-named = Geen naam
records-page-new-name = Andere naam
records-page-take-name = Deze naam gebruiken

## De vraag
records-page-question = Zoeken
records-page-help = Woorden, goed nabewerking afgekeurd, of part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = Meer
records-page-today = Vandaag
records-page-this-week = Deze week
records-page-not-good = Niet goed
records-page-measured-only = Alleen gemeten
records-page-filter = Filter
records-page-filter-hint = Beperkt de lijst tot een onderdeel, serienummer, datum en meer
records-page-add-filter = Filter toevoegen
records-page-filter-by = Filteren op
records-page-filter-value = Waarde
records-page-from = Vanaf
records-page-to = Tot en met
records-page-standing = Niet vervallen
records-page-simulated-only = Alleen gesimuleerd
records-page-reports-only = Alleen rapporten
records-page-alarms-only = Alleen alarmen
records-page-checks-only = Zonder rapporten
records-page-remove-filter = Filter { $filter } verwijderen
records-page-looking = Zoeken…
records-page-count = { $many ->
    [one] 1 vastlegging
   *[other] { $count } vastleggingen
}
records-page-more = { $count }+ vastleggingen
records-page-unread = Het logboek kan niet worden gelezen: { $why }
records-page-none = er is geen logboek geopend
records-page-missing = Vastlegging { $number } ontbreekt
records-page-empty = Controles verschijnen hier zodra zij zijn vastgelegd
records-page-none-found = Geen vastlegging gevonden

## De lijst
records-page-list = Vastleggingen
records-page-head-number = Nr.
records-page-zone = In tol.-veld
records-page-move = Naar een andere vastlegging
records-page-open = Vastlegging openen
records-page-choose = Voor een rapport kiezen
records-page-choose-record = Vastlegging { $number } voor een rapport kiezen
records-page-chosen = { $count ->
    [one] 1 gekozen
   *[other] { $count } gekozen
}
records-page-copy = Kopiëren
records-page-report-of = Rapport van { $count }…
records-page-reports-listed = Een rapport is van alle { $count } getoonde vastleggingen
records-page-reports-chosen = Een rapport is van de { $count } gekozen vastleggingen
records-page-too-many = Er staan { $count } vastleggingen in de lijst. Een rapport of keuze kan er hoogstens { $most } bevatten: beperk de lijst, bijvoorbeeld op onderdeel of datum
records-page-still-looking = De lijst is nog niet volledig. Probeer het opnieuw als het aantal er staat
records-page-nothing-to-report = Geen vastlegging in de lijst kan in een rapport: ze zijn vervallen, gesimuleerd of van cycli
records-page-report = Rapport…
records-page-with-simulated = Met gesimuleerde controles
records-page-with-simulated-hint = Gesimuleerde controles zijn geen bewijs; het rapport zegt dat het er bevat
records-page-report-simulated = { $count ->
    [one] 1 van deze controles is gesimuleerd: dat is geen bewijs
   *[other] { $count } van deze controles zijn gesimuleerd: dat is geen bewijs
}
records-page-report-from = Uit het logboek { $chain }, vastleggingen { $numbers }; de nieuwste is { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] 1 gesimuleerde controle is weggelaten
   *[other] { $count } gesimuleerde controles zijn weggelaten
}
records-page-out-replaced = { $count ->
    [one] 1 gecorrigeerde of ingetrokken vastlegging is weggelaten
   *[other] { $count } gecorrigeerde of ingetrokken vastleggingen zijn weggelaten
}
records-page-report-corrects = { $count ->
    [one] 1 waarde staat in de plaats van een gecorrigeerde vastlegging
   *[other] { $count } waarden staan in de plaats van gecorrigeerde vastleggingen
}
records-page-out-cycles = { $count ->
    [one] 1 vastlegging van een cyclus is weggelaten
   *[other] { $count } vastleggingen van cycli zijn weggelaten
}
records-page-out-reports = { $count ->
    [one] 1 rapport of alarm is weggelaten: het is geen controle
   *[other] { $count } rapporten en alarmen zijn weggelaten: het zijn geen controles
}
records-page-out-unread = { $count ->
    [one] 1 vastlegging die niet kan worden gelezen is weggelaten
   *[other] { $count } vastleggingen die niet kunnen worden gelezen zijn weggelaten
}
records-page-see = Vervallen, zie { $number }
records-page-void = Vastlegging { $number }, vervallen: zie { $by }
records-page-instead = i.p.v. { $number }
records-page-takes-back = Trekt { $number } in
records-page-withdrawal = Intrekking
records-page-report-entry = Rapport
records-page-alarm = Alarm
records-page-alarm-answers = Antwoord op alarm { $number }
records-page-alarm-answered = Alarm, antwoord { $number }
records-page-alarm-first = Eerste waarde: { $number }
records-page-alarm-last = Waarde waarbij de regel afging: { $number }
records-page-cycle = Cyclus { $cycle }
records-page-went-back = { $time } (klok terug)

## Een geopende vastlegging
records-page-close = Terug naar de lijst
records-page-reading = De vastlegging wordt gelezen
records-page-measure-again = Opnieuw meten
records-page-measure-again-hint = Neemt passing, onderdeel, serienummer en regel mee naar de controlepagina
records-page-correct = Corrigeren…
records-page-correct-hint = Voegt een vastlegging toe in plaats van deze; beide blijven
records-page-simulated = Gesimuleerd: niemand heeft dit gemeten
records-page-corrected-by = Gecorrigeerd of ingetrokken door vastlegging { $number }
records-page-corrects = In plaats van vastlegging { $number }
records-page-in-report = In rapport { $number }, { $name }
records-page-reports-unread = De rapporten met deze controle kunnen niet worden gelezen: { $why }
records-page-report-unknown = { $name } is geschreven, maar het logboek kent het niet: { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, boring
    [neither] { $callout }, noch boring noch as
   *[shaft] { $callout }, as
}
records-page-distance = Afstand tot grens
records-page-importer = Geïmporteerd door
records-page-void-why = Vervallen omdat
records-page-void-by = Gecorrigeerd of ingetrokken door
records-page-decided = Beslissing
records-page-limits = Grensmaten
records-page-source = Grensmaten uit
records-page-contacts = Meetpunten
records-page-rule = Regel
records-page-station = Station
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = De klok van het station is vóór deze vastlegging teruggezet
records-page-cycle-number = Cyclus
records-page-program = Programma
records-page-block = { $program }, tekstregel { $line }
records-page-datum = Referentiepunt
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, gezet in tekstregel { $line }: { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = assen { $angle }° gedraaid, sinds tekstregel { $line }: { $block }
records-page-datum-tilt = vlak gezwenkt over A { $a }°, B { $b }°, C { $c }°, sinds tekstregel { $line }: { $block }
records-page-parameters = Parameters
records-page-figures = Resultaten
records-page-file-measurements = Metingen
records-page-file-program = Programma
records-page-file-workpiece = Werkstuk
records-page-file-budget = Onzekerheidsbudget
records-page-report-file = Bestand
records-page-report-format = Formaat
records-page-report-size = Grootte
records-page-report-bytes = { $count } bytes
records-page-report-title = Titel
records-page-report-sha256 = SHA-256
records-page-report-checks = Vastgelegde controles
records-page-report-numbers = Hun vastleggingen
records-page-report-unrecorded = Controles zonder vastlegging
records-page-report-head = Nieuwste vermelding toen
records-page-chain = Keten
records-page-chain-name = Logboek
records-page-hash = Hash

## Een correctie
records-page-correction = Vastlegging { $number } corrigeren
records-page-correction-rule = Opnieuw beoordeeld zoals vastlegging { $number }: { $rule }.
records-page-correction-temperature = Gecorrigeerd van { $temperature } °C naar 20 °C.
records-page-correction-rest = Onderdeel, serienummer, naam
records-page-correction-hint = Een nieuwe vastlegging komt in plaats van deze. Beide blijven in het logboek.
records-page-corrector = Gecorrigeerd door
records-page-reason = Reden
records-page-reason-mistyped = verkeerd getypt
records-page-reason-wrong-part = verkeerd onderdeel
records-page-reason-trial = proef
records-page-withdrawal-hint = De vastlegging telt niet meer mee, en er komt niets voor in de plaats. Beide blijven in het logboek.
records-page-withdraw = Vastlegging intrekken
records-page-withdraw-hint = Er komt niets voor in de plaats
records-page-withdraw-neither = Vastlegging { $number }, die deze corrigeert, telt daardoor niet weer
records-page-send-correction = Correctie vastleggen
records-page-leave-correction = Annuleren
records-page-undo-void = Niet ongedaan gemaakt: de vastlegging is na de correctie ingetrokken
records-page-undone-reason = ongedaan gemaakt
records-page-taken-back = { $checks ->
    [one] 1 controle ongedaan gemaakt
   *[other] { $checks } controles ongedaan gemaakt
}; { $records ->
    [one] vastlegging { $numbers } is ingetrokken
   *[other] vastleggingen { $numbers } zijn ingetrokken
}
records-page-taken-back-unwritten = { $checks ->
    [one] 1 controle ongedaan gemaakt; die was nog niet vastgelegd en wordt dat ook niet
   *[other] { $checks } controles ongedaan gemaakt; die waren nog niet vastgelegd en worden dat ook niet
}
records-page-not-withdrawn = { $records ->
    [one] Vastlegging { $numbers } telt nog mee en kon niet worden ingetrokken: { $why }
   *[other] Vastleggingen { $numbers } tellen nog mee en konden niet worden ingetrokken: { $why }
}
records-page-undone = Correctie ongedaan gemaakt
records-page-no-reason = Een correctie heeft een reden nodig
records-page-nothing-changed = Er is niets anders: wijzig een veld, of trek de vastlegging in
records-page-not-open = De vastlegging is niet geopend
records-page-not-recording = Controles worden niet vastgelegd

## Het logboek
records-page-place = { $file } · vermeldingen: { $entries }
records-page-unsent = { $count } nog niet verzonden naar { $server }
records-page-all-sent = alles verzonden naar { $server }
records-page-server-unknown = { $server } is nog niet bereikt
records-page-server = Werkplaatsserver
records-page-server-hint = Stuurt elke vermelding op de achtergrond naar een PostgreSQL-server; zonder server blijft alles op deze computer
records-page-server-address = Adres, zoals postgres://frees3@werkplaats.example/checks
records-page-server-passwords = Het wachtwoord komt uit het adres, PGPASSWORD, het wachtwoordbestand of de sleutelbos van het systeem. Een wachtwoord in het adres gaat naar de sleutelbos en wordt nergens anders bewaard.
records-page-take-server = Deze server gebruiken
records-page-leave-server = Niet meer verzenden
records-page-send-again = Opnieuw verzenden
records-page-not-sent = Niet verzonden: { $why }
records-page-and = { $one }; { $other }
records-page-no-shop = deze Fitcheck is gebouwd zonder ondersteuning voor een werkplaatsserver (feature shop)
records-page-in-keyring = Het wachtwoord van { $server } staat nu in de sleutelbos van het systeem
records-page-not-in-keyring = Het wachtwoord van { $server } kon niet in de sleutelbos van het systeem worden gezet ({ $reason }): het geldt tot het venster sluit, en moet daarna uit PGPASSWORD of het wachtwoordbestand komen
records-page-verify = Verifiëren
records-page-verify-hint = Vergelijkt elke vermelding met die ervoor
records-page-verify-cancel = Verificatie afbreken
records-page-verify-cancelled = Verificatie afgebroken
records-page-verify-progress = Voortgang van de verificatie
records-page-verifying = { $done } van { $of } vermeldingen
records-page-whole = { $time }: { $entries } vermeldingen geverifieerd, tot en met { $number } ({ $hash })
records-page-broken = { $time }: { $entries } vermeldingen gecontroleerd; het logboek is niet zoals het is geschreven
records-page-not-verified = { $time }: niet geverifieerd: { $why }
records-page-no-anchors = wat elders van het logboek bekend is kan niet worden gelezen: { $why }
