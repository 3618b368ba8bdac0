# report

## Errors
report-error-writer = het rapport in formaat { $format } kon niet worden gemaakt: { $reason }
report-error-label-alone = { $format } is voor labels: kies het sjabloon label, of het papier small-label of large-label
report-error-no-statistics = { $format } heeft geen plaats voor statistiek: kies PDF, HTML of Markdown
report-attachment-too-large = de gegevens van het bestand zijn groter dan { $most } bytes
report-attachment-packed = de gegevens in het bestand zijn verpakt met { $filter }, dat Fitcheck niet leest
report-attachment-damaged = de gegevens in het bestand zijn beschadigd: { $reason }
report-attachment-several = het bestand heeft { $count } bijlagen met controles: er wordt één verwacht
report-difference-field = vermelding { $number }: { $field } is { $said } in het bestand, { $kept } in het logboek
report-difference-missing = vermelding { $number }: geen controle van het bestand zegt wat het logboek zegt
report-difference-more = { $count ->
    [one] het bestand heeft 1 controle te veel
   *[other] het bestand heeft { $count } controles te veel
}
report-difference-fewer = { $count ->
    [one] in het bestand ontbreekt 1 controle
   *[other] in het bestand ontbreken { $count } controles
}
report-data-json = de gegevens van het bestand zijn geen rapport van Fitcheck: { $reason }
report-ending-missing = { $file } heeft geen extensie waaruit het formaat van het rapport blijkt: gebruik een van { $endings }
report-ending-unknown = .{ $ending } is geen formaat van het rapport: gebruik een van { $endings }

## Sentences about one check
report-feature-hole = boring
report-feature-shaft = as
report-feature-neither = noch boring noch as
report-side-good = goed
report-side-rework = nabewerking
report-side-scrap = afgekeurd
report-side-out = buiten grenzen
report-side-too-small = te klein
report-side-too-large = te groot
report-source-instead = { $source }; ISO 286 geeft hier { $upper } en { $lower } µm
report-too-small = { $um } µm te klein
report-too-large = { $um } µm te groot
report-inside = binnen de grensmaten
report-above-minimum = { $um } µm boven minimum
report-below-minimum = { $um } µm onder minimum
report-below-maximum = { $um } µm onder maximum
report-above-maximum = { $um } µm boven maximum
report-position-unknown = niet gemeten
report-position-unmonitored = niet bewaakt
report-position-in = BINNEN
report-position-out = BUITEN
report-axis-unmonitored = { $axis } { $deviation } mm: niet bewaakt
report-axis-in = { $axis } { $deviation } mm, toegestaan ± { $tolerance } mm: BINNEN
report-axis-out = { $axis } { $deviation } mm, toegestaan ± { $tolerance } mm: BUITEN
report-cause-position = het midden ligt buiten de toegestane positie; de maat alleen is { $status }
report-origin-circle = { $origin }; kleinste-kwadratencirkel door { $contacts } meetpunten
report-centre = gemeten midden X { $x } mm, Y { $y } mm
report-band-nominal = nominale maat { $size } mm
report-band-title = Grensband, gemeten { $value }: { $distances }
report-in-guard-band = niets is beslist: de waarde ligt in een veiligheidsmarge van de beslisregel
report-corrected = gemeten { $measured } mm bij { $temperature } °C, uitzetting { $expansion } · 10⁻⁶/K: gecorrigeerd met { $change } µm tot { $reference } mm bij 20 °C
report-all-corrected = gemeten bij { $temperature } °C, uitzetting { $expansion } · 10⁻⁶/K; elke waarde is gecorrigeerd naar 20 °C
report-scales = meetlinialen bij { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = zonder correctie van de meetlinialen
report-own-uncertainty = u van elke waarde bij de controle
report-accepted-zone = { $least } tot { $most } mm
report-accepted-none = geen: de regel laat niets van deze tolerantie over
report-proven = bewezen volgens deze regel
report-not-proven = niet bewezen volgens deze regel
report-conformity = voldoet met een kans van { $percent } %
report-budget-made = { $name }, opgesteld op { $date } door { $by }, geldig tot en met { $until }
report-budget-expired = VERLOPEN op de dag van de controle
report-budget-not-yet = NOG NIET GELDIG op de dag van de controle
report-guard-undecided = veiligheidsmarge: opnieuw meten
report-guard-beyond = veiligheidsmarge: aanvaard buiten de grensmaat
report-guard-range = { $what }, { $from } tot { $to } µm

## The page
report-title = Meetrapport
report-part = Onderdeel
report-order = Order
report-inspector = Controleur
report-program = Programma
report-notes = Overgeslagen rijen en waarschuwingen
report-no-checks = Dit rapport bevat geen controles.
report-page-all-good = Op deze pagina staat geen van de { $total } controles: ze zijn allemaal goed en geen ervan is twijfelachtig. Een rapport als CSV of JSON bevat elke controle.
report-page-not-good = Op deze pagina staan alleen de { $listed } van { $total } controles die niet goed of twijfelachtig zijn. De aantallen gelden voor alle controles; een rapport als CSV of JSON bevat ze allemaal.
report-page-first = Op deze pagina staan alleen de eerste { $listed } van { $wanted } controles die niet goed of twijfelachtig zijn, van { $total } controles in totaal. De aantallen gelden voor alle controles; een rapport als CSV of JSON bevat ze allemaal.
report-total = Totaal
report-check = Controle
report-id = Naam
report-callout = Passing
report-heading-without-callout = { $nominal } mm, grensmaten zonder klasse
report-verdict = Oordeel
report-nominal = Nominale maat
report-maximum = Maximum
report-minimum = Minimum
report-measured = Gemeten
report-deviation = Afwijking
report-remove = Verspanen
report-on-diameter = op diameter
report-per-side = per zijde
report-remove-to-limit = tot de dichtstbijzijnde grensmaat
report-remove-to-middle = tot het midden van het tolerantieveld
report-remove-to-accepted = tot de aanvaarde waarden
report-position = Positie
report-limits-from = Grensmaten uit
report-measured-from = Gemeten waarde
report-from = Bron
report-limits = Grensmaten
report-missing = Ontbreekt
report-skipped = Overgeslagen
report-verdict-from = Beslisregel
report-temperature = Temperatuur
report-accepted = Aanvaarde waarden
report-proof = Bewijs
report-budget = Onzekerheidsbudget
report-cannot-tell = Beperkingen van deze meting
report-contacts = Meetpunten
report-contacts-at-end = aan het einde van het rapport
report-contact = Nr.
report-radial = radiale afwijking
report-sign-name = Naam
report-sign-date = Datum
report-sign-signature = Handtekening
report-footer = Elk oordeel berust op onafgeronde waarden en op de grensmaten en de beslisregel die ernaast staan.

## Notes
report-note = { $place }: { $what }
report-note-line = { $place }, regel { $line }: { $what }
report-note-more = { $count ->
    [one] nog 1 opmerking staat hier niet
   *[other] nog { $count } opmerkingen staan hier niet
}

## A whole part
report-balloon = Ballon
report-picture-room = { $name } staat hier niet: met afbeeldingen van alle onderdelen zou de pagina te groot worden
report-picture-beside = { $count ->
    [one] één element heeft er geen ballon op
   *[other] { $count } elementen hebben er geen ballon op
}
report-part-older = { $count ->
    [one] Eén andere waarde staat niet in de lijst: van elke maat staat er de waarde die telt
   *[other] { $count } andere waarden staan niet in de lijst: van elke maat staat er de waarde die telt
}
report-more-parts = { $count ->
    [one] Nog één onderdeel staat er niet als geheel in; zijn waarden staan in de lijst
   *[other] Nog { $count } onderdelen staan er niet als geheel in, alleen de eerste { $most }; hun waarden staan in de lijst
}

## Sjablonen van rapporten
report-template-toml = { $reason }
report-template-version = sjabloonversie { $found } wordt niet ondersteund: verwacht versie { $known }
report-template-too-large = een sjabloon heeft hoogstens { $most } bytes
report-template-text = { $key } is leeg, langer dan { $longest } tekens of heeft een besturingsteken
report-template-twice = { $key } noemt { $word } twee keer
report-template-empty = { $key } is leeg: noem er minstens één
report-template-language = { $given } is geen taal van rapporten: gebruik een van { $known }
report-template-logo = het logo { $given } moet de naam van een bestand naast het sjabloon zijn
report-section-verdict = Oordeel
report-section-head = Kop
report-section-picture = Afbeelding met ballonnen
report-section-lot = Onderdelen, slechtste eerst
report-section-statistics = Statistiek van kenmerken
report-statistics-limits = De grenzen verschillen per waarde: er wordt geen bekwaamheid vermeld.
report-statistics-most = De statistiek bevat alleen de eerste { $count } waarden.
report-section-features = Waarden
report-section-statement = Conformiteitsverklaring
report-section-rule = Regel en grenzen in woorden
report-section-caveats = Beperkingen van de meting
report-section-remarks = Opmerkingen
report-section-signature = Handtekeningregel
report-section-code = Code van de regel
report-revision = Revisie
report-serial = Serienummer
report-batch = Partij
report-customer = Klant
report-material = Materiaal
report-station = Station
report-instrument = Meetmiddel
report-calibrated = Gekalibreerd
report-date = Datum
report-plan = Meetplan
report-records = Regels
report-blank = Waarde
report-remark = Opmerking
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Etiket 62 × 29 mm
report-paper-large-label = Etiket 100 × 50 mm
report-template-inspection = Meetrapport
report-template-inspection-purpose = Onderdelen of controles, met afbeeldingen
report-template-first-article = Eerste exemplaar
report-template-first-article-purpose = Elk element, ook wat ontbreekt
report-template-certificate = Certificaat
report-template-certificate-purpose = Waarden en conformiteitsverklaring
report-template-list = Lijst van controles
report-template-list-purpose = Alle controles onder elkaar
report-template-statistics = Statistiek
report-template-statistics-purpose = Elk kenmerk over al zijn waarden, met grafieken
report-template-sheet = Meetblad
report-template-sheet-purpose = Leeg, om met de hand in te vullen
report-template-label = Etiket
report-template-label-purpose = Oordeel, onderdeel en serienummer
## Pagina's om af te drukken
report-pdf-page = Pagina { $page } van { $pages }
report-pdf-band = Grensband
report-pdf-remove = { $name }: { $um } µm op diameter verspanen
report-pdf-simulated = Gesimuleerde waarden, door niemand gemeten: { $count } van { $total }
report-pdf-beyond = Waarden die de beslisregel buiten de grensmaten aanvaardt: { $count } van { $total }
report-pdf-corrected = Naar 20 °C gecorrigeerde waarden: { $count } van { $total }
report-pdf-guarded = Waarden met een eigen beslisregel: { $count } van { $total }
report-pdf-doubted = Twijfelachtige waarden, met een vraagteken: { $count } van { $total }
report-pdf-notes = Overgeslagen rijen en waarschuwingen, aan het einde vermeld: { $count }
report-pdf-more-lacks = Meer op de pagina's van de onderdelen: { $count }
report-pdf-more = Meer in de bijgevoegde gegevens: { $count }
report-pdf-all-checks = Alle controles
report-pdf-attached = Bij dit bestand gevoegd, voor programma's: { $names }
report-pdf-not-attached = Niet alle gegevens zijn bijgevoegd: een bestand van meer dan { $most } MB zou te groot zijn
report-pdf-contacts = De meetpunten staan in de bijgevoegde gegevens.
report-pdf-cut = Een tekst die op … eindigt, is hier ingekort; in de bijgevoegde gegevens staat hij volledig.
report-pdf-substituted = Een □ staat voor een teken dat de lettertypen van deze pagina's missen, zoals tekens die van rechts naar links worden geschreven; gekopieerde tekst en de bijgevoegde gegevens hebben het teken wel.
report-statement-conforms = { $count ->
    [one] Conformiteitsverklaring: de waarde ligt binnen haar grenzen volgens de hier genoemde beslisregel.
   *[other] Conformiteitsverklaring: alle { $count } waarden liggen binnen hun grenzen volgens de hier genoemde beslisregel.
}
report-statement-not = { $count ->
    [one] Geen conformiteit: de waarde voldoet niet volgens de hier genoemde beslisregel.
   *[other] Geen conformiteit: { $bad } van { $count } waarden voldoen niet volgens de hier genoemde beslisregel.
}
report-statement-partial = Geen conformiteitsverklaring: sommige rijen zijn geweigerd, niet beoordeeld of niet gelezen. Het rapport vermeldt ze.
report-statement-simulated = { $count ->
    [one] Geen conformiteitsverklaring: één waarde is gesimuleerd en door niemand gemeten.
   *[other] Geen conformiteitsverklaring: { $count } waarden zijn gesimuleerd en door niemand gemeten.
}
report-statement-open = Geen conformiteitsverklaring: er ontbreken waarden, { $count } in totaal.
report-code-said = Code van regel { $number }, de hash { $hash }
report-lot-order = Onderdelen staan met het slechtste eerst.
## Een werkmap
report-sheets = Alleen de eerste { $listed } van { $total } onderdelen hebben een eigen blad; het blad met de onderdelen bevat ze allemaal.
report-sheets-corrected = op 20 °C
report-sheets-without = Afbeeldingen en meetpunten staan niet in deze werkmap: een rapport als HTML bevat beide, een rapport als JSON de meetpunten.
report-sheets-cut = { $count ->
    [one] Eén tekst is ingekort: in een cel passen hoogstens 32767 tekens.
   *[other] { $count } teksten zijn ingekort: in een cel passen hoogstens 32767 tekens.
}
report-journal = Regels { $numbers } van logboek { $chain }; de laatste regel was toen: { $number }:{ $hash }
report-template-new-about = Een sjabloon voor rapporten. Verwijder wat een rapport niet moet tonen; haal de # weg bij wat het wel moet tonen.
report-template-new-name = Nieuw sjabloon
report-changed-since = Gewijzigd sinds het rapport van { $since }:
report-changed-none = geen resultaat en geen grens
report-changed-result = { $name }: { $before } → { $now }
report-changed-limits = { $name }: grenzen { $low } tot { $high } → { $lower } tot { $higher } mm
report-changed-added = { $name }: nieuw
report-changed-removed = { $name }: niet meer in het rapport
report-changed-several = { $name }: niet vergeleken, omdat er meer dan één waarde is
report-since-no-report = geen rapport van Fitcheck met zijn gegevens: geef de PDF of de JSON ervan
