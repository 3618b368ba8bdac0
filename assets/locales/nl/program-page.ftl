## De programmapagina

page-program = Programma's
program-page-dialog-open = NC-programma openen
program-page-choice = NC-programma
program-page-open = Openen…
program-page-not-shipped = { $name } is niet in deze versie opgenomen
program-page-nothing = Er is geen programma open
program-page-listing = { $name }, { $count ->
    [one] { $count } regel
   *[other] { $count } regels
  }

program-page-run = Starten
program-page-pause = Pauze
program-page-step = Regel voor regel
program-page-step-over = Hele aanroep
program-page-to-selected = Tot cursor
program-page-breakpoint = Breekpunt
program-page-reset = Terugzetten
program-page-move = Naar een andere regel
program-page-speed = Snelheid
program-page-speed-slow = 4 regels/s
program-page-speed-medium = 20 regels/s
program-page-speed-fast = volle snelheid
program-page-options = Opties
program-page-skip-unknown = Onbekende regels overslaan
program-page-assume-tool = Zonder TOOL CALL langs Z tasten
program-page-block-skip = Regels met / overslaan
program-page-optional-stop = Stoppen bij M1
program-page-outline-none = kop of label
program-page-outline = Ga naar

program-page-state-ready = Klaar om te starten
program-page-state-running = Loopt
program-page-state-paused = Gepauzeerd
program-page-state-step = Regel voor regel
program-page-state-breakpoint = Gepauzeerd bij een breekpunt
program-page-state-goal = Gepauzeerd bij de cursor
program-page-state-over = Gepauzeerd na de aanroep
program-page-state-stop = Het programma is zelf gestopt: verder met Starten
program-page-state-optional-stop = Het programma is zelf gestopt met M1: verder met Starten
program-page-state-tolerance = Buiten de tolerantie: { $stop }
program-page-state-log = Het meetprotocol staat op het scherm: verder met Starten
program-page-state-ended = Beëindigd na { $blocks } regels
program-page-state-fault = Gestopt met een fout
program-page-refused-inputs = Een invoerwaarde is niet leesbaar
program-page-refused-none = Er is geen programma open
program-page-refused-workpiece = Het werkstuk is niet leesbaar
program-page-refused-no-contacts = Er zijn geen meetpunten open

program-page-has-breakpoint = breekpunt
program-page-is-current = volgende regel
program-page-is-failed = fout hier

program-page-inputs = Invoer
program-page-answers = Fitcheck en het programma
program-page-program = Programma
program-page-verdict = Oordeel
program-page-no-limits = Geen grensmaten: een invoerwaarde is niet leesbaar
program-page-agrees = Het programma en Fitcheck zeggen hetzelfde
program-page-contested = Programma { $program }, Fitcheck { $own }
program-page-contested-limits = Programma { $program }, met andere grenzen dan die van Fitcheck
program-page-stopped-at = Gestopt met een fout; tot dan { $program }
program-page-differs = Het programma wijkt af: { $what }
program-page-differs-minimum = minimale maat { $program } mm, volgens Fitcheck { $own } mm
program-page-differs-maximum = maximale maat { $program } mm, volgens Fitcheck { $own } mm
program-page-differs-status = het zegt { $program }, Fitcheck zegt { $own }
program-page-differs-fault = het is met een fout gestopt
program-page-differs-native-refuses = het geeft een oordeel, Fitcheck heeft geen grensmaten
program-page-other-inputs = Niet vergeleken: het programma heeft intussen andere invoer ingesteld en meet een ander element
program-page-both-refuse = Noch het programma noch Fitcheck geeft een antwoord

program-page-workpiece = Werkstuk
program-page-from-perfect = perfect, tolerantiemidden
program-page-from-nominal = perfect, op nominale maat
program-page-from-given = perfect, opgegeven diameter
program-page-from-simulated = gesimuleerd
program-page-from-part = onderdeel met meerdere elementen
program-page-open-part = Onderdeel openen…
program-page-dialog-part = Gesimuleerd onderdeel met meerdere elementen openen
program-page-refused-no-part = Er is geen onderdeel geopend
program-page-from-recorded = opgenomen meetpunten
program-page-workpiece-x = Werkelijk midden X
program-page-workpiece-y = Werkelijk midden Y
program-page-edit-workpiece = Werkstuk en tastsysteem…
program-page-open-contacts = Andere meetpunten…
program-page-recorded = { $count ->
    [one] { $count } meetpunt
   *[other] { $count } meetpunten
  } uit { $name }
program-page-path = Baan van het tastsysteem
program-page-no-path = Nog geen baan
program-page-zero = Nulpunt X { $x }, Y { $y }, Z { $z } mm
program-page-turned = { $angle }° gedraaid
program-page-tilted = gezwenkt A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = Het programma heeft geen venster geopend
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, GESIMULEERD
program-page-cycles = Gemeten
program-page-show-block = Regel tonen
program-page-last-of = De laatste { $shown } van { $all }
program-page-outputs = Bestanden
program-page-outputs-hint = Hier getoond, niet naar schijf geschreven

program-page-parameters = Parameters
program-page-filter = Filter
program-page-set = Beginnen met
program-page-value = Waarde
program-page-give = Instellen
program-page-give-hint = De volgende uitvoering begint met deze waarde
program-page-given = Ingesteld voor de volgende uitvoering
program-page-drop = verwijderen
program-page-no-parameter = { $given } is geen parameter: schrijf Q5, QL5, QR5 of QS5
program-page-no-number = { $given } is geen getal
program-page-none-found = Geen parameter gevonden
program-page-no-parameters = Parameters verschijnen zodra het programma is gestart
program-page-undefined = niet gedefinieerd
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, gewijzigd
program-page-pin = { $parameter } bovenaan houden
program-page-unpin = { $parameter } niet bovenaan houden
program-page-q108 = radius van het gereedschap
program-page-q109 = gereedschapsas: 0 X, 1 Y, 2 Z
program-page-q110 = spil: 0 M3, 1 M4, 2 of 3 daarna gestopt
program-page-q111 = koelmiddel: 0 uit, 1 aan
program-page-q113 = maateenheid: 0 mm, 1 inch
program-page-q114 = lengte van het gereedschap
program-page-q115 = tastpositie, X
program-page-q116 = tastpositie, Y
program-page-q117 = tastpositie, Z
program-page-q150 = gemeten hoek

program-page-problems = { $count ->
    [one] { $count } opmerking
   *[other] { $count } opmerkingen
  }
program-page-unlisted = { $count ->
    [one] { $count } opmerking staat niet in de lijst
   *[other] { $count } opmerkingen staan niet in de lijst
  }
program-page-at-block = NC-regel { $number }: { $what }
program-page-at-line = tekstregel { $line }: { $what }

program-page-create = Voor een besturing maken…
program-page-create-hint = NC-programma's, tabellen en masker waarmee een besturing zelf meet
program-page-create-also = schrijven NC programma bestanden set
program-page-create-head = Voor een besturing maken
program-page-create-control = Besturing
program-page-create-language = Dialoogtaal
program-page-create-from = Uit
program-page-create-series = Voor een serie: elke start meet het volgende onderdeel
program-page-create-texts = Toleranties van diameters als teksten van de cyclus
program-page-create-callout = { $callout } van Controle, op X { $x } Y { $y } Z { $z }
program-page-create-no-callout = De passing op Controle
program-page-create-plan = Plan { $name }, { $count ->
    [one] { $count } element
   *[other] { $count } elementen
  }
program-page-create-nothing = Vul op Controle een passing in, of open een plan op Onderdelen
program-page-create-plan-wrong = { $name } heeft fouten: open het plan op Onderdelen en corrigeer ze
program-page-create-folder = Map op de besturing: { $folder }
program-page-create-proven-callout = Teruggelezen en uitgevoerd: { $callout } krijgt precies de grensmaten van Fitcheck
program-page-create-proven-plan = Teruggelezen en uitgevoerd: elk element krijgt de grensmaten van het plan
program-page-create-clearance-height = De veilige hoogte is { $height } mm; in een plan staat die in een kolom
program-page-create-files-none = Bestanden maken…
program-page-create-files = { $count ->
    [one] { $count } bestand
   *[other] { $count } bestanden
  } maken…
program-page-dialog-create = Bestanden voor een besturing maken: kies of noem een map
program-page-create-written = { $count ->
    [one] { $count } bestand is
   *[other] { $count } bestanden zijn
  } geschreven in { $folder }: { $names }
program-page-create-no-folder = { $name } is een bestand: noem een map
program-page-contacts-left = De meetpunten uit { $name } horen bij het vorige programma: dit meet een perfect werkstuk
program-page-unfinished = Niet vergeleken: het programma is niet tot zijn einde gekomen
program-page-unknown = { $fault }. Zet Opties → Onbekende regels overslaan aan om zonder verder te gaan
program-page-missing-file = { $fault }. Er is gezocht in { $folder } en onder de ingebouwde bestanden. Zet het daar, naast het programma, of open het programma in de map die het bestand heeft
program-page-unknown-datum = { $fault }. Zonder het nulpunt wordt er niets gemeten. Open voor een proef een kopie van het programma zonder de NC-regel die het zet, en een werkstuk gezien vanuit dat nulpunt
program-page-not-written = { $path } zou op de besturing worden geschreven. De tekst staat onder Bestanden; op de opdrachtregel schrijft fitcheck run --output-folder het
program-page-no-verdict = Geen grensmaten, geen oordeel
