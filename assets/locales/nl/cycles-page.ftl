# De cycluspagina: het formulier van een meetcyclus, het werkstuk, de baan en de resultaten.

page-cycles = Cycli

cycles-cycle = Cyclus
cycles-choose = Cyclus { $number } { $name }
cycles-group-position = Positie
cycles-group-probing = Tasten
cycles-group-tolerance = Tolerantie
cycles-group-output = Uitvoer
cycles-optional-position = Positie, optioneel
cycles-optional-probing = Tasten, optioneel
cycles-optional-tolerance = Tolerantie, optioneel
cycles-optional-output = Uitvoer, optioneel
cycles-contacts-from = Meetpunten van
cycles-perfect = Perfect werkstuk
cycles-simulated = Gesimuleerd
cycles-recorded = Uit bestand
cycles-workpiece = Werkstuk…
cycles-suit = Werkstuk aan cyclus aanpassen
cycles-open-contacts = Meetpunten…
cycles-no-file = nog geen bestand
cycles-contacts-of = { $count ->
    [one] { $count } meetpunt
   *[other] { $count } meetpunten
    }, { $file }
cycles-probe = Tastsysteem
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Eigen tastsysteemtabel…
cycles-shipped-probes = Ingebouwde tabel
cycles-run = Uitvoeren
cycles-needed = verplicht
cycles-none = geen
cycles-predef = PREDEF staat voor
cycles-predef-missing = PREDEF: typ de waarde uit GLOBAL DEF
cycles-without-effect = Toegestaan, zonder werking
cycles-position = Plaats van de kogel
cycles-ball-stands = Kogel staat op
cycles-paste-block = NC-regel plakken…
cycles-copy-block = Als NC-regel kopiëren
cycles-copy-results = Resultaten kopiëren
cycles-block-copied = De NC-regel is gekopieerd
cycles-block = NC-regel
cycles-block-hint = Plak een NC-regel zoals TCH PROBE 427 … Q263=+35 ;TEKST ~ of G785 R0 BR0 K2: die vervangt het formulier
cycles-fill = Formulier invullen

cycles-nothing-seen = Baan en meetpunten verschijnen na een meting: druk op Enter of F5
cycles-allowed = Toegestaan: { $range } { $unit }
cycles-must-be-given = Verplicht
cycles-may-be-left-out = Optioneel
cycles-default = { $value } als het veld leeg blijft
cycles-may-be-predef = PREDEF is toegestaan
cycles-path = Baan van de kogel
cycles-first = Eerste
cycles-back = Vorige
cycles-next = Volgende
cycles-last = Laatste
cycles-move = Beweging
cycles-phase-pre-position = voorpositioneren
cycles-phase-approach = naderen
cycles-phase-contact = meetpunt
cycles-phase-retract = terugtrekken
cycles-phase-leave = vrijzetten
cycles-move-contact = { $number } van { $count }: { $phase } { $touch }, op { $to }
cycles-move-of-touch = { $number } van { $count }: { $phase }, meetpunt { $touch }, van { $from } naar { $to }
cycles-move-of-none = { $number } van { $count }: { $phase }, van { $from } naar { $to }
cycles-criteria = Criteria naast elkaar

cycles-word-stopped = Niet gemeten
cycles-word-no-verdict = Geen oordeel
cycles-no-limits = geen grenzen opgegeven
cycles-no-limits-marked = geen grenzen opgegeven; een besturing meldt dan binnen de tolerantie
cycles-more-out = { $what }, nog { $count } hieronder
cycles-no-window = Geen grensmaten: de besturing toont geen statusvenster
cycles-results = Resultaatparameters
cycles-log-file = De besturing schrijft { $name }
cycles-log-screen = De besturing stopt en toont het meetprotocol op het scherm
cycles-log-shown = De besturing toont het resultaat op het scherm
cycles-save-log = Meetprotocol opslaan…
cycles-dialog-save-log = Meetprotocol opslaan
cycles-no-log = geen meetprotocol om op te slaan
cycles-from-perfect = Gemeten op een perfect werkstuk op nominale maat, met een punt als tastsysteem
cycles-from-simulated = Gemeten op het gesimuleerde werkstuk, startgetal { $seed }
cycles-from-recorded = Meetpunten uit { $file }
cycles-unused = De cyclus heeft { $count ->
    [one] één meetpunt
   *[other] { $count } meetpunten
    } van het bestand niet gebruikt

cycles-fields-wrong = { $count ->
    [one] één veld is
   *[other] { $count } velden zijn
    } niet bruikbaar: zie het formulier
cycles-no-workpiece = het gesimuleerde werkstuk is niet volledig
cycles-workpiece-wrong = gesimuleerd werkstuk: { $problem }
cycles-workpiece-field = { $name }: { $problem }
cycles-no-contacts = er is nog geen bestand met meetpunten geopend
cycles-cannot-suit = Nog geen passend werkstuk: { $problem }
cycles-not-written = het werkstuk kan niet worden geschreven: { $reason }
cycles-contacts-loaded = Meetpunten uit { $name } worden gebruikt
cycles-column-ignored = kolom { $column } is overgeslagen
cycles-probes-loaded = Tastsysteemtabel { $name } wordt gebruikt
cycles-dialog-contacts = Opgenomen meetpunten openen
cycles-dialog-workpiece = Gesimuleerd werkstuk openen
cycles-dialog-probes = Tastsysteemtabel openen
cycles-dialog-save-workpiece = Gesimuleerd werkstuk opslaan

cycles-open-workpiece = Openen…
cycles-save-workpiece = Opslaan…
cycles-shape-bore = Boring
cycles-shape-stud = As
cycles-shape-face = Vlak
cycles-shape-point = Punt op een vrij oppervlak
cycles-shape-slot = Sleuf
cycles-shape-ridge = Dam
cycles-shape-pocket = Kamer
cycles-shape-boss = Rechthoekige tap
cycles-plane = Vlak van de cirkel
workpiece-probe = Tastsysteem
workpiece-machine = Spreiding en temperatuur
workpiece-centre-1 = Midden, 1e as
workpiece-centre-2 = Midden, 2e as
workpiece-ovality-angle = Hoek van de ovaliteit
workpiece-lobe-angle = Hoek van de lobben
workpiece-point-x = Punt X
workpiece-point-y = Punt Y
workpiece-point-z = Punt Z
workpiece-normal-x = Normaal X
workpiece-normal-y = Normaal Y
workpiece-normal-z = Normaal Z
workpiece-wave-height = Amplitude van de golf
workpiece-wave-length = Golflengte
workpiece-wave-x = Golfrichting X
workpiece-wave-y = Golfrichting Y
workpiece-wave-z = Golfrichting Z
workpiece-deviation = Afwijking langs de normaal
workpiece-radius = Radius van het oppervlak
workpiece-width = Breedte
workpiece-length-1 = 1e lengte
workpiece-length-2 = 2e lengte
workpiece-angle = Hoek van de wanden
workpiece-ball = Kogelradius
workpiece-trigger = Schakelspreiding 1σ
workpiece-calibration = Kalibratiefout
workpiece-offset-x = Verschuiving van de kogel X
workpiece-offset-y = Verschuiving van de kogel Y
workpiece-lobing-count = Lobben van de schakelweg
workpiece-lobing = Amplitude van de schakelweg
workpiece-lobing-angle = Hoek van de schakelweg
workpiece-temperature = Werkstuktemperatuur
workpiece-expansion = Uitzetting

cycles-choice-move-to-clearance-0 = op meethoogte
cycles-choice-move-to-clearance-1 = op veilige hoogte
cycles-choice-clearance-mode-minus-1 = nooit op veilige hoogte
cycles-choice-clearance-mode-0 = voor en na de cyclus
cycles-choice-clearance-mode-1 = voor en na elk object
cycles-choice-clearance-mode-2 = bij elk meetpunt
cycles-choice-traverse-0 = rechte lijn
cycles-choice-traverse-1 = over een boog
cycles-choice-contact-count-3 = meetpunten
cycles-choice-contact-count-4 = meetpunten
cycles-choice-contact-count-5 = meetpunten
cycles-choice-contact-count-6 = meetpunten
cycles-choice-contact-count-7 = meetpunten
cycles-choice-contact-count-8 = meetpunten
cycles-choice-contact-count-9 = meetpunten
cycles-choice-log-0 = geen meetprotocol
cycles-choice-log-1 = meetprotocol in een bestand
cycles-choice-log-2 = stop, meetprotocol op het scherm
cycles-choice-stop-0 = geen stop
cycles-choice-stop-1 = stop buiten de tolerantie
cycles-choice-stop-on-undersize-0 = geen stop
cycles-choice-stop-on-undersize-1 = stop buiten de tolerantie
cycles-choice-stop-on-undersize-2 = stop alleen bij ondermaat
cycles-choice-stop-on-scrap-0 = geen stop
cycles-choice-stop-on-scrap-1 = stop buiten de tolerantie
cycles-choice-stop-on-scrap-2 = stop alleen bij afkeur
cycles-choice-measured-axis-1 = hoofdas X
cycles-choice-measured-axis-2 = nevenas Y
cycles-choice-measured-axis-3 = tasteras Z
cycles-choice-axis-of-plane-1 = hoofdas X
cycles-choice-axis-of-plane-2 = nevenas Y
cycles-choice-direction-minus-1 = negatieve richting
cycles-choice-direction-1 = positieve richting
cycles-choice-directed-axis-minus-3 = tasteras Z, negatieve richting
cycles-choice-directed-axis-minus-2 = nevenas Y, negatieve richting
cycles-choice-directed-axis-minus-1 = hoofdas X, negatieve richting
cycles-choice-directed-axis-1 = hoofdas X, positieve richting
cycles-choice-directed-axis-2 = nevenas Y, positieve richting
cycles-choice-directed-axis-3 = tasteras Z, positieve richting
cycles-choice-tool-axis-probing-0 = blijft
cycles-choice-tool-axis-probing-1 = getast en gezet
cycles-choice-transfer-minus-1 = niet opgegeven
cycles-choice-transfer-0 = nulpunttabel
cycles-choice-transfer-1 = referentiepunttabel
cycles-choice-preset-correction-0 = blijft zoals het is
cycles-choice-preset-correction-1 = door het punt gecorrigeerd
cycles-choice-preset-correction-2 = door het 2e punt gecorrigeerd
cycles-choice-preset-correction-3 = door het midden van beide gecorrigeerd
cycles-choice-compensation-axis-0 = as van de gemeten hoek
cycles-choice-compensation-axis-4 = as A
cycles-choice-compensation-axis-5 = as B
cycles-choice-compensation-axis-6 = as C
cycles-choice-zero-after-alignment-0 = houdt zijn waarde
cycles-choice-zero-after-alignment-1 = toont nul
cycles-choice-rotary-alignment-0 = blijven staan
cycles-choice-rotary-alignment-1 = draaien, de taster gaat mee
cycles-choice-rotary-alignment-2 = draaien alleen
cycles-choice-rotation-transfer-0 = verandert niets
cycles-choice-rotation-transfer-1 = basisrotatie
cycles-choice-rotation-transfer-2 = verschuiving van de rotatieas
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = binnen
cycles-choice-side-1 = buiten
cycles-choice-geometries-0 = twee boringen
cycles-choice-geometries-1 = twee tappen
cycles-choice-geometries-2 = een boring en een tap
cycles-choice-geometries-3 = een tap en een boring

## De gereedschapstabel

tools = Gereedschapstabel
tools-none = geen
tools-open-one = { $name }, { $count ->
    [one] één gereedschap
   *[other] { $count } gereedschappen
  }
tools-open = Gereedschapstabel openen…
tools-close = Geen gereedschapstabel
tools-save = Gereedschapstabel opslaan…
tools-save-hint = De tabel met deze wijzigingen. De volgende uitvoering begint met de tabel zoals hij is geopend.
tools-dialog-open = Gereedschapstabel openen
tools-dialog-save = Gewijzigde gereedschapstabel opslaan
tools-loaded = Gereedschapstabel { $name } wordt gebruikt
tools-pick = gereedschap kiezen
tools-pick-of = { $parameter } uit de gereedschapstabel
tools-input = { $parameter } Gereedschap voor bewaking (Q330)
tools-fixed = Q330 = { $tool } in het programma
tools-more = { $count ->
    [one] nog één gereedschap
   *[other] nog { $count } gereedschappen
  }
tools-row = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, geblokkeerd
tools-without-name = { $count ->
    [one] één gereedschap staat niet in de lijst: de naam wijst het niet eenduidig aan
   *[other] { $count } gereedschappen staan niet in de lijst: hun namen wijzen ze niet eenduidig aan
  }
tools-not-in-table = Q330 = { $tool }: de gereedschapstabel heeft dit gereedschap niet
tools-not-monitored = Zonder gereedschapstabel wordt geen gereedschap bewaakt (Q330)
tools-none-named = Q330 noemt geen gereedschap: de gereedschapstabel wordt niet gebruikt
tools-no-deviation = de gemeten waarde wijkt niet af: het gereedschap wordt niet gewijzigd
tools-changed = Gewijzigd in de gereedschapstabel
tools-nothing-changed = geen uitvoering heeft de gereedschapstabel gewijzigd

## Een onderdeel met meerdere elementen

cycles-part-refused = het bestand heeft [[feature]]-tabellen: een losse cyclus meet één oppervlak; de pagina Programma's en fitcheck run meten zo'n onderdeel
part-features = Elementen van het onderdeel
part-of-features = { $name }, { $count ->
    [one] één element
   *[other] { $count } elementen
  }, kogelradius { $ball } mm
part-round = { $name }: { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name }: { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name }: { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name }: { $kind } X { $x } Y { $y } Z { $z }
