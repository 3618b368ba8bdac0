## The chain of a journal
journal-hex = "{ $text }" is geen reeks van { $digits } hexadecimale cijfers
journal-break-changed = vermelding { $number } is niet de vermelding die is geschreven
journal-break-removed = { $count ->
        [one] vermelding { $number } ontbreekt
       *[other] { $count } vermeldingen ontbreken vanaf { $number }
    }
journal-break-inserted = vermelding { $number } is ingevoegd
journal-break-reordered = de vermeldingen { $number } en { $other } zijn verwisseld
journal-break-rewritten = vermelding { $number } verschilt van de vermelding die elders bekend is: het logboek is vanaf daar of vanaf een eerdere vermelding opnieuw geschreven
journal-break-cut-off = het logboek eindigt met vermelding { $last }, maar vermelding { $known } is elders bekend: de nieuwste vermeldingen zijn afgesneden, of een oudere kopie is teruggezet

## Entries
journal-body-json = geen vermelding van een logboek: { $reason }
journal-body-newer = gemaakt door een nieuwere Fitcheck: versie { $version } van het formaat, deze Fitcheck leest versies tot en met { $known }
journal-body-too-large = geen vermelding van een logboek: { $bytes } bytes, hoogstens { $most } zijn toegestaan
journal-body-too-long = { $field } heeft { $bytes } bytes, hoogstens { $most } zijn toegestaan
journal-body-control = { $field } heeft het stuurteken { $code } als teken { $place }: teksten van een logboek zijn één regel zonder stuurtekens
journal-body-empty = { $field } is leeg
journal-body-too-many = { $field } heeft { $count } onderdelen, hoogstens { $most } zijn toegestaan
journal-body-value = { $field } kan niet "{ $given }" zijn
journal-body-contradiction = { $field } spreekt de velden tegen waaruit het volgt
journal-origin-perfect = gesimuleerd, een werkstuk zonder fouten
journal-origin-workpiece = gesimuleerd, { $file }, startgetal { $seed }
journal-origin-contacts = meetpunten uit { $file }
journal-check-judged-otherwise = geoordeeld als { $kept }, en dat blijft zo; deze versie van Fitcheck oordeelt { $now }

## Questions
journal-ask-at = { $reason } (teken { $at })
journal-ask-unknown-key = { $key }: is geen bekend zoekwoord; { $known } verwacht, of aanhalingstekens rond een woord met een dubbele punt
journal-ask-no-value = { $key }: heeft geen waarde
journal-ask-empty-word = een woord tussen aanhalingstekens is leeg
journal-ask-twice = { $key } staat er twee keer
journal-ask-not-closed = een aanhalingsteken is niet gesloten
journal-ask-after-quote = spatie verwacht na het laatste aanhalingsteken, { $found } gevonden
journal-ask-date = "{ $given }" is geen dag of tijdstip: 2026-11-23 of 2026-11-23T14:30 verwacht
journal-ask-verdict = "{ $given }" is geen oordeel: { $known } verwacht
journal-ask-callout = { $error }; een passing staat tussen aanhalingstekens: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = de periode eindigt voordat zij begint: from moet vóór to liggen
journal-ask-both-origins = simulated en measured sluiten elkaar uit
journal-ask-both-kinds = reports en checks sluiten elkaar uit
journal-ask-too-long = de zoekopdracht heeft { $bytes } bytes, hoogstens { $most } zijn toegestaan

## The journal of a station
store-missing = er is geen logboek op { $path }
store-not-a-file = { $path } is geen bestand
store-not-a-journal = { $path } is geen logboek van Fitcheck; het is niet gewijzigd
store-newer = { $path } is gemaakt door een nieuwere Fitcheck (versie { $version }, deze ondersteunt { $known }); het is niet gewijzigd
store-older = { $path } is gemaakt door een oudere Fitcheck: het wordt naar deze versie omgezet zodra er iets in wordt vastgelegd
store-damaged = { $path } is beschadigd: de pagina's spreken elkaar tegen
store-full = er is geen ruimte meer voor { $path }: er is niets vastgelegd
store-read-only = in { $path } mag niet worden geschreven: er is niets vastgelegd
store-locked = een ander programma heeft { $path } te lang vergrendeld: er is niets vastgelegd
store-disk = de schijf van { $path } meldt een fout: { $reason }
store-cannot-open = { $path } kan niet worden geopend
store-network-folder = { $path } staat in een map van een andere machine, waar twee stations elkaars vermeldingen kunnen overschrijven: kies een map op deze machine, en een server voor de werkplaats
store-altered = "{ $name }", dat vermeldingen tegen verandering beschermt, ontbreekt in { $path } of is veranderd
store-no-beginning = { $path } zegt niet welke keten het is
store-moved = { $path } is intussen verplaatst of opzij gezet: er is niets vastgelegd
store-other-target = vermelding { $number } is niet de vermelding die gecorrigeerd moest worden: er is niets vastgelegd
store-corrected = vermelding { $number } is al gecorrigeerd of ingetrokken door vermelding { $by }: corrigeer die, tenzij het een intrekking is
store-is-report = vermelding { $number } is een rapport: die zegt welk bestand is geschreven, en kan niet worden gecorrigeerd of ingetrokken
store-is-alarm = vermelding { $number } is een alarm van een regelkaart: die zegt welke regel is afgegaan, en kan niet worden gecorrigeerd of ingetrokken; beantwoord het alarm
store-no-alarm = vermelding { $number } is geen alarm van een regelkaart: alleen een alarm kan worden beantwoord
journal-alarm-since-part = { $rule }, sinds onderdeel { $serial }
journal-alarm-since-entry = { $rule }, sinds vermelding { $number }
store-other-journal = vermelding { $number } van dit logboek is niet de vermelding die het rapport noemt: er is niets vastgelegd
store-finding-no-beginning = het logboek heeft geen eerste vermelding die zijn keten noemt
store-finding-pages = de pagina's van het logboek spreken elkaar tegen, en zoekopdrachten kunnen vermeldingen missen die erin staan: { $reason }
store-finding-index = een index voor zoekopdrachten klopt niet met zijn tabel: { $reason }
store-hidden = vermelding { $number } van { $path } staat niet op zijn plaats: het logboek is veranderd of het bestand is beschadigd; voer fitcheck journal verify uit
store-no-entry = { $path } heeft geen vermelding { $number }: de laatste is { $last }
store-backup = de kopie van { $path } was onvolledig en is verwijderd
store-interrupted = gestopt
store-database = { $path }: { $reason }
store-remark-begun = er is een nieuw logboek gemaakt: { $path }
store-remark-set-aside = het logboek { $path } was beschadigd: het staat nu ongewijzigd in { $folder }, en in zijn plaats is een nieuw logboek gemaakt
store-remark-migrated = { $path } is naar deze versie omgezet; het bestand zoals het was, is { $copy }
store-remark-behind = { $path } eindigt met vermelding { $last }, maar had ooit vermelding { $known }: de nieuwste vermeldingen zijn afgesneden, of een oudere kopie is teruggezet
store-remark-other = vermelding { $number } van { $path } is anders dan die was: het logboek is vanaf daar of vanaf een eerdere vermelding opnieuw geschreven
store-remark-replaced = { $path } is niet het logboek dat er eerder was; dat had { $known } vermeldingen
store-remark-waits = een ander programma schrijft in { $path }: er wordt gewacht tot het klaar is
store-remark-no-anchor = de laatste vermelding van dit logboek kon niet worden genoteerd in { $path }: { $reason }
store-finding-altered = "{ $name }", dat vermeldingen tegen verandering beschermt, ontbreekt of is veranderd
store-finding-not-found = { $entries ->
        [one] 1 vermelding is geïndexeerd met iets anders dan erin staat, of helemaal niet
       *[other] { $entries } vermeldingen zijn geïndexeerd met iets anders dan erin staat, of helemaal niet
    }
