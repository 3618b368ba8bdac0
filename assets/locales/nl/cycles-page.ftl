# De cycluspagina: het formulier van een meetcyclus, het werkstuk, de weg en de resultaten.

page-cycles = Cycli

cycles-cycle = Cyclus
cycles-contacts-from = Contacten van
cycles-perfect = Perfect werkstuk
cycles-simulated = Gesimuleerd
cycles-recorded = Uit bestand
cycles-workpiece = Werkstuk…
cycles-suit = Passend bij de cyclus
cycles-open-contacts = Contacten…
cycles-no-file = nog geen bestand
cycles-contacts-of = { $count ->
    [one] { $count } contact
   *[other] { $count } contacten
    }, { $file }
cycles-probe = Taster
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Eigen tastertabel…
cycles-shipped-probes = Ingebouwde tabel
cycles-run = Uitvoeren
cycles-needed = verplicht
cycles-none = geen
cycles-predef = PREDEF staat voor
cycles-predef-missing = PREDEF: typ de waarde die GLOBAL DEF geeft
cycles-without-effect = Aanvaard zonder werking
cycles-position = Waar de kogel staat
cycles-ball-stands = Kogel staat op
cycles-paste-block = NC-blok…
cycles-copy-block = Als NC-blok kopiëren
cycles-block = NC-blok
cycles-block-hint = Plak een blok zoals TCH PROBE 427 … Q263=+35 ;TEKST ~ of G785 R0 BR0 K2: het vervangt het formulier
cycles-fill = Formulier invullen

cycles-nothing-seen = Weg en contacten verschijnen met de meting: Enter of F5
cycles-allowed = Toegestaan: { $range } { $unit }
cycles-must-be-given = Moet worden opgegeven
cycles-may-be-left-out = Mag worden weggelaten
cycles-default = { $value } als er niets wordt getypt
cycles-may-be-predef = PREDEF mag worden getypt
cycles-path = Weg van de kogel
cycles-first = Eerste
cycles-back = Terug
cycles-next = Volgende
cycles-last = Laatste
cycles-move = Beweging
cycles-phase-pre-position = voorpositioneren
cycles-phase-approach = naderen
cycles-phase-contact = contact
cycles-phase-retract = terugtrekken
cycles-phase-leave = wegrijden
cycles-move-contact = { $number } van { $count }: { $phase }, aanraking { $touch }, op { $to }
cycles-move-of-touch = { $number } van { $count }: { $phase }, aanraking { $touch }, van { $from } naar { $to }
cycles-move-of-none = { $number } van { $count }: { $phase }, van { $from } naar { $to }
cycles-criteria = Criteria naast elkaar

cycles-word-stopped = Niet gemeten
cycles-word-no-verdict = Geen oordeel
cycles-no-limits = er zijn geen grenzen opgegeven
cycles-no-window = Geen grensmaten: de besturing toont geen statusvenster
cycles-results = Resultaatparameters
cycles-log-file = De besturing schrijft { $name }
cycles-log-screen = De besturing stopt en toont het protocol op het scherm
cycles-log-shown = De besturing toont het resultaat op het scherm
cycles-save-log = Protocol opslaan…
cycles-dialog-save-log = Het meetprotocol opslaan
cycles-no-log = er is geen protocol om op te slaan
cycles-from-perfect = Gemeten op een perfect werkstuk op nominale maat, met een punt als taster
cycles-from-simulated = Gemeten op het gesimuleerde werkstuk, toevalsgetal { $seed }
cycles-from-recorded = Contacten uit { $file }
cycles-unused = De cyclus heeft { $count ->
    [one] één contact
   *[other] { $count } contacten
    } van het bestand niet gebruikt

cycles-fields-wrong = { $count ->
    [one] een veld is
   *[other] { $count } velden zijn
    } niet bruikbaar: zie het formulier
cycles-no-bench = het gesimuleerde werkstuk is niet volledig
cycles-bench-wrong = gesimuleerd werkstuk: { $problem }
cycles-bench-field = { $name }: { $problem }
cycles-no-contacts = er is nog geen bestand met contacten geopend
cycles-cannot-suit = Nog geen passend werkstuk: { $problem }
cycles-not-written = het werkstuk kan niet worden geschreven: { $reason }
cycles-contacts-loaded = Contacten van { $name } worden gebruikt
cycles-column-ignored = kolom { $column } wordt niet gebruikt
cycles-probes-loaded = Tastertabel { $name } wordt gebruikt
cycles-dialog-contacts = Opgenomen contacten openen
cycles-dialog-bench = Gesimuleerd werkstuk openen
cycles-dialog-probes = Tastertabel openen
cycles-dialog-save-bench = Gesimuleerd werkstuk opslaan

cycles-open-bench = Openen…
cycles-save-bench = Opslaan…
cycles-kind-bore = Gat
cycles-kind-stud = As
cycles-kind-face = Vlak
cycles-kind-point = Punt van een vrij oppervlak
cycles-plane = Vlak van de cirkel
cycles-bench-probe = Taster
cycles-bench-machine = Spreiding en temperatuur
cycles-bench-centre-1 = Middelpunt, 1e as
cycles-bench-centre-2 = Middelpunt, 2e as
cycles-bench-ovality-angle = Hoek van de ovaliteit
cycles-bench-lobe-angle = Hoek van de lobben
cycles-bench-point-x = Punt X
cycles-bench-point-y = Punt Y
cycles-bench-point-z = Punt Z
cycles-bench-normal-x = Normaal X
cycles-bench-normal-y = Normaal Y
cycles-bench-normal-z = Normaal Z
cycles-bench-wave-height = Amplitude van de golf
cycles-bench-wave-length = Golflengte
cycles-bench-wave-x = Golfrichting X
cycles-bench-wave-y = Golfrichting Y
cycles-bench-wave-z = Golfrichting Z
cycles-bench-deviation = Afwijking langs de normaal
cycles-bench-radius = Radius van het oppervlak
cycles-bench-ball = Kogelradius
cycles-bench-trigger = Schakelspreiding 1σ
cycles-bench-calibration = Kalibratiefout
cycles-bench-offset-x = Verzet van de kogel X
cycles-bench-offset-y = Verzet van de kogel Y
cycles-bench-lobing-count = Lobben van de schakelweg
cycles-bench-lobing = Amplitude van de schakelweg
cycles-bench-lobing-angle = Hoek van de schakelweg
cycles-bench-temperature = Werkstuktemperatuur
cycles-bench-expansion = Uitzetting

cycles-choice-q301-0 = op meethoogte
cycles-choice-q301-1 = op veilige hoogte
cycles-choice-q365-0 = recht
cycles-choice-q365-1 = over een boog
cycles-choice-q423-3 = contacten
cycles-choice-q423-4 = contacten
cycles-choice-q281-0 = geen protocol
cycles-choice-q281-1 = protocol in een bestand
cycles-choice-q281-2 = stop, protocol op scherm
cycles-choice-q309-0 = geen stop
cycles-choice-q309-1 = stop bij overschrijding
cycles-choice-q309-2 = stop alleen bij ondermaat
cycles-choice-q272-1 = hoofdas X
cycles-choice-q272-2 = nevenas Y
cycles-choice-q272-3 = tasteras Z
cycles-choice-q267-minus-1 = negatieve richting
cycles-choice-q267-1 = positieve richting
cycles-choice-q498-0 = nee
cycles-choice-q498-1 = ja
cycles-choice-r-0 = X/Y, G17
cycles-choice-r-1 = Z/X, G18
cycles-choice-r-2 = Y/Z, G19
cycles-choice-br-0 = binnen
cycles-choice-br-1 = buiten
