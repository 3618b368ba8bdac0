# NC-programma's uitvoeren.

## Paden en bestanden
machine-path-empty = het pad is leeg
machine-path-too-long = het pad heeft meer dan { $most } tekens, en dat staat een besturing niet toe
machine-path-other-root = { $path } is geen pad op TNC: en geen pad vanuit de map van het programma
machine-path-leads-out = { $path } leidt buiten de map
machine-path-no-name = { $name } in { $path } is geen naam voor een bestand of map
machine-store-missing = bestand niet gevonden: { $path }
machine-store-outside = { $path } leidt buiten de opgegeven mappen
machine-store-no-file = { $path } is geen bestand
machine-store-too-large = { $path } is groter dan { $most } MiB
machine-store-ambiguous = { $path } bestaat in verschillende schrijfwijzen, { $names }, maar een besturing heeft van elke naam maar één bestand: verwijder of hernoem de andere
machine-store-elsewhere = { $path } staat niet in de map voor uitvoer: een programma wist alleen daar bestanden
machine-store-read-only = er is geen map voor uitvoer gekozen
machine-store-system = { $path }: { $reason }

## Fouten
machine-fault-in-block = { $program }, NC-regel { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, tekstregel { $line }, { $text }: { $fault }
machine-used-blocks = de grens van { $most } NC-regels is bereikt: mogelijk een oneindige lus
machine-used-label-calls = { $most } aanroepen van labels diep genest, de grens is bereikt: roept het programma zichzelf aan?
machine-used-program-calls = { $most } aanroepen van programma's diep genest, de grens is bereikt: roept het programma zichzelf aan?
machine-used-windows = de grens van { $most } vensters is bereikt
machine-used-outputs = de grens van { $most } uitvoeren naar een bestand is bereikt
machine-used-output-files = de grens van { $most } uitvoerbestanden is bereikt
machine-used-folders = de grens van { $most } mappen voor uitvoerbestanden is bereikt
machine-used-table-writes = gewijzigde tabellen zijn { $most } keer opgeslagen: de grens is bereikt
machine-used-output = de grens van { $most } uitgevoerde bytes is bereikt
machine-used-cycles = de grens van { $most } metingen is bereikt
machine-used-path = de grens van { $most } bewegingen is bereikt
machine-used-files = de grens van { $most } geopende programma's en gewijzigde tabellen is bereikt
machine-used-traffic = de grens van { $most } gelezen en geschreven bytes is bereikt
machine-used-file-bytes = programma's en gewijzigde tabellen zijn samen groter dan { $most } bytes
machine-text-too-long = de tekst heeft { $length } tekens, een parameter bevat er hoogstens { $most }
machine-unknown-block = onbekende NC-regel: Fitcheck voert alleen uit wat het begrijpt
machine-unknown-cycle = Fitcheck volgt cyclus { $cycle } niet, ook waar de besturing die heeft: gevolgd worden { $known }
machine-file-open = { $path } is geopend als tabel van FN 26: ze kan niet worden gekopieerd, verplaatst of gewist
machine-broken = het programma is beschadigd: { $what } ontbreekt
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } is geen label
machine-no-tool-data = { $parameter } is niet gedefinieerd: hij bevat een maat van het gereedschap in de spil, die een gereedschapstabel geeft
machine-undefined = { $parameter } is niet gedefinieerd
machine-lost = { $parameter } is niet gedefinieerd: tekstregel { $line }, { $text }, kan hem zetten en is niet uitgevoerd
machine-file-unknown = { $path } wordt niet gelezen: tekstregel { $line }, { $text }, kan dit bestand schrijven of verwijderen en is niet uitgevoerd
machine-tools-unknown = het gereedschap wordt niet gecorrigeerd: tekstregel { $line }, { $text }, kan de gereedschapstabel wijzigen en is niet uitgevoerd
machine-contacts-unknown = het is niet bekend welke opgenomen meetpunten bij deze cyclus horen: sommige kunnen bij tekstregel { $line }, { $text }, horen, die niet is uitgevoerd
machine-not-skipped = deze NC-regel bepaalt wat er daarna wordt uitgevoerd of wat een ander programma krijgt: hij kan niet worden overgeslagen
machine-whole-only = { $parameter } bevat alleen gehele getallen, niet { $value }
machine-no-answer = INPUT "{ $question }" vraagt om { $parameter }: geef de waarde vóór het uitvoeren op
machine-no-parameter = parameter { $parameter } bestaat niet: Q en QS gaan tot 1999, QL en QR tot 499
machine-no-variable = variabele { $variable } bestaat niet: { $family } loopt van { $least } tot { $most }
machine-not-number = { $parameter } bevat een tekst: een getal verwacht
machine-not-text = { $parameter } bevat een getal: een tekst verwacht
machine-division-by-zero = deling door nul
machine-negative-root = de wortel van { $value } is niet gedefinieerd
machine-no-result = { $function } { $value } is niet gedefinieerd
machine-beyond-range = { $value } ligt buiten het waardebereik, −10^10 tot 10^10
machine-not-whole = { $what } = { $value }: een geheel getal vanaf 0 verwacht
machine-counted-row = rij
machine-counted-word = { $word }
machine-behind-text = de tekst heeft { $length } tekens: positie { $from } ligt voorbij het einde
machine-no-number-in-text = { $parameter } = "{ $text }" is geen getal
machine-unknown-system-text = onbekende systeemtekst ID{ $id } NR{ $number }: alleen datum en tijd (ID10321) worden ondersteund
machine-no-table = er is geen tabel open
machine-several-columns = { $parameter } = { $text } noemt meer kolommen: via een tekstparameter wordt er één gelezen
machine-no-column = tabel { $table } heeft geen kolom { $column }; de kolommen zijn { $columns }
machine-no-row = tabel { $table } heeft geen rij { $row }: de rijen zijn 0 tot en met { $last }
machine-no-rows = tabel { $table } heeft geen rijen
machine-empty-cell = tabel { $table }, rij { $row }, kolom { $column }: de cel is leeg
machine-no-number-in-cell = tabel { $table }, rij { $row }, kolom { $column }: { $cell } is geen getal
machine-touches = tabel { $table }, rij { $row }, kolom { $column }: de cel loopt over in de cel ernaast, dus de waarde is onzeker
machine-table-write = tabel { $table }: { $error }
machine-mask = masker { $mask }: { $error }
machine-programmed = het programma heeft zichzelf gestopt met fout { $number }
machine-no-cycle-parameter = cyclus { $cycle } heeft geen parameter { $parameter }
machine-cycle-parameter-twice = cyclus { $cycle }: { $parameter } is twee keer opgegeven
machine-cycle-parameter-for = cyclus { $cycle }: { $parameter } is twee keer opgegeven en { $other } helemaal niet: is de tweede als { $other } bedoeld?
machine-global-not-number = GLOBAL DEF { $number }: { $parameter } heeft geen getal
machine-global-twice = GLOBAL DEF { $number }: { $parameter } is twee keer opgegeven
machine-open-subprogram = het programma eindigt in het subprogramma dat in tekstregel { $line } is aangeroepen: LBL 0 ontbreekt
machine-repeat-ahead = REP herhaalt het deel tussen een label en deze NC-regel, maar het label staat erachter, in tekstregel { $line }
machine-cycle = cyclus { $cycle }: { $error }
machine-workpiece = werkstuk: { $error }
machine-no-tool-call = voor deze meetcyclus staat geen TOOL CALL met een gereedschapsas
machine-mode = de besturing staat in { $mode }: meetcycli worden alleen in het freesbedrijf uitgevoerd (FUNCTION MODE MILL)
machine-changed = { $change } is actief sinds tekstregel { $line }, { $text }: zolang dat zo is, meet Fitcheck niet
machine-nothing-selected = voor CALL SELECTED PGM staat geen SEL PGM
machine-no-datum-table = het referentiepunt zou in regel { $row } van de actieve nulpunttabel komen (Q303 = 0), die alleen de besturing heeft: hier kan van daaruit niets worden gemeten
machine-datum-in-tilt = sinds tekstregel { $line }, { $text }, is het vlak gezwenkt: daarin zet Fitcheck geen referentiepunt, omdat niet bekend is wat een besturing daar schrijft; zet het vlak vóór de cyclus terug (PLANE RESET)
machine-point-without-part = cyclus 0 en 1 tasten één punt, en een perfect werkstuk heeft er geen: kies een gesimuleerd werkstuk of vastgelegde contacten
machine-point-from-nowhere = vanwaar wordt getast, is niet in alle assen bekend: schrijf X, Y en Z in de regel
machine-no-preset = { $table } heeft geen regel { $row }
machine-preset-locked = { $table }: regel { $row } is vergrendeld, de cyclus kan die niet beschrijven
machine-shifted-preset = regel { $row } is het actieve referentiepunt en er is een nulpuntverschuiving actief: wat een besturing daarvan maakt is niet bekend
machine-change-not-known = een onbekend nulpunt
machine-change-turning = het gedraaide coördinatensysteem van cyclus 800
machine-change-datum-table = een verschuiving uit een nulpunttabel
machine-change-rotation = een rotatie
machine-change-mirror = een spiegeling
machine-change-scaling = een maatfactor
machine-change-axis-scaling = schaling van afzonderlijke assen
machine-change-tilt = een gezwenkt bewerkingsvlak
machine-change-tilted-shift = een verschuiving uit een vlak dat niet meer gezwenkt is
machine-change-axis-turned = een draaiing van het werkstuk met een rotatieas, waarna nog niet beide assen van het vlak een nieuw referentiepunt hebben,

## Opmerkingen
machine-file-from = { $path } is gelezen uit { $file }
machine-file-given = { $path } is gelezen
machine-file-built-in = { $path } is ingebouwd
machine-remark-skipped = onbekende NC-regel overgeslagen
machine-remark-cycle-passed-over = deze cyclus kalibreert de taster of meet een gereedschap: hij is overgeslagen. Wat hij teruggeeft is vanaf hier niet gedefinieerd, tenzij het vóór de uitvoering is gegeven (--set Q115=0)
machine-remark-measurement-skipped = deze meting is overgeslagen: de resultaten zijn vanaf hier niet gedefinieerd
machine-remark-datum-skipped = deze meting is overgeslagen: de resultaten zijn vanaf hier niet gedefinieerd, en hierna wordt niet meer gemeten, omdat zij een nulpunt kan zetten
machine-remark-not-followed = deze NC-regel wordt niet uitgevoerd en kan het nulpunt wijzigen: hierna wordt niet meer gemeten
machine-remark-no-system-data = { $parameter } is vanaf hier ongedefinieerd: de systeemgegevens van FN 18 kent alleen een besturing
machine-remark-axis-assumed = voor deze cyclus staat geen TOOL CALL: gemeten langs Z met het eerste tastsysteem
machine-remark-measured-again = opnieuw gemeten na nabewerking: deze meting telt
machine-remark-spindle-turns = de spil draait sinds M{ $function }: een besturing zou niet tasten
machine-remark-rotary-moved = { $axes } zijn eerder verplaatst: het werkstuk is gemeten alsof het niet gedraaid is
machine-remark-other-preset = referentiepunt { $number }: aangenomen is dat het werkstuk ook daar ligt
machine-remark-rotation-ended = de basisrotatie van { $angle } is beëindigd: deze cyclus meet zonder, en ze blijft uit
machine-remark-axes-as-tilted = het vlak is gezwenkt: er wordt aangenomen dat de rotatieassen staan zoals het vlak dat vraagt
machine-remark-machine-zero-assumed = FN 18 vraagt een plaats vanaf het nulpunt van de machine: waar dat ligt, is hier niet bekend, en er wordt geteld vanaf dat van het werkstuk
machine-remark-datum-set = referentiepunt gezet: het nulpunt ligt nu op { $zero } mm in de coördinaten van het werkstuk
machine-remark-preset-set = regel { $row } van de referentiepunttabel op { $zero } mm in de coördinaten van het werkstuk gezet: die werkt met cyclus 247
machine-remark-active-preset-set = regel { $row } is het actieve referentiepunt: het nulpunt ligt nu op { $zero } mm in de coördinaten van het werkstuk; op een iTNC 530 pas na cyclus 247
machine-remark-presets-left = { $path } blijft zoals die is: geen cyclus 247 ervoor zegt welke regel actief is, dus is niet bekend waar het werkstuk op de machine ligt
machine-remark-shift-ended = de nulpuntverschuiving eindigt in { $axes } zonder dat daar is gemeten, zoals op een TNC7: een iTNC 530 houdt haar misschien
machine-remark-built-in = { $path } is niet bij de opgegeven bestanden: het ingebouwde is gelezen
machine-remark-other-names = { $read } is gelezen, maar { $others } bestaat ook: een besturing heeft van elke naam maar één bestand
machine-remark-read = { $path }: { $what }
machine-remark-other-spelling = tabel { $table } heeft geen kolom { $column }: { $other } is gebruikt, de andere schrijfwijze in NC-Solution 8255
machine-remark-row-number = tabel { $table }: NR is { $found } in rij { $row }: FN 27 en FN 28 tellen de rijen vanaf 0
machine-remark-length-converted = tabel { $table }: kolom { $column } is een LENGTH en is tussen mm en inch omgerekend
machine-remark-ended-within = M{ $function } in een aangeroepen programma heeft de uitvoering beëindigd: een besturing staat dat daar niet toe
machine-remark-given-wins = { $parameter } = { $value } is vooraf opgegeven en vervangt de waarde in deze NC-regel
machine-remark-given-without-effect = { $parameter } is vooraf opgegeven en had geen effect: geen NC-regel heeft hem gelezen
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = de NC-regel laat { $parameters } weg: deze waarden zijn gebruikt, maar een besturing kan de NC-regel weigeren
machine-remark-measurement-behind-end = { $count ->
        [one] er staat een meetcyclus
       *[other] er staan { $count } meetcycli
    } na deze NC-regel, waar een besturing stopt met lezen: wat daarna komt, is niet gemeten
machine-remark-cycle-skipped = deze meetcyclus is op verzoek overgeslagen, vanwege de / ervoor
machine-remark-rounded = tabel { $table }, kolom { $column }: { $value } is afgerond op { $written }
machine-remark-not-judged = hier geen oordeel: er is niets met grenzen vergeleken
machine-remark-not-written = { $path } is niet geschreven: er is geen map voor uitvoer gekozen
machine-remark-deleted = { $path } is door het programma gewist
machine-remark-not-deleted = { $path } is niet gewist: er is geen map voor uitvoer gekozen
machine-remark-other-device = { $given } is een ander apparaat: het bestand is { $path }
machine-remark-screen-meant = SCREEN geldt als naam van een bestand: was SCREEN: bedoeld?
machine-remark-empty-mask = het masker { $mask } is leeg: wat het afdrukt ook
machine-remark-not-saved = { $path } is niet geschreven: { $reason }
machine-remark-full = { $path } heeft de grens van { $kilobytes } kilobyte bereikt: er is niets toegevoegd
machine-remark-table-written = { $path } is geschreven
machine-remark-contacts-left = de cycli hebben { $used } van de { $count } opgenomen meetpunten gebruikt
machine-remark-more = nog { $count } opmerkingen zijn niet vermeld
machine-remark-empty-spindle = gereedschap 0 is opgeroepen: een TNC7 heeft dan geen tastsysteem in de spil
machine-remark-no-tool-named = geen TOOL CALL voor deze cyclus noemt een gereedschap: gemeten met het eerste tastsysteem
machine-remark-tool-call-words = TOOL CALL kent { $words } niet: overgeslagen
machine-remark-no-nominal = de cyclus heeft geen nominale maat: het tastsysteem raakt het perfecte werkstuk halverwege K
machine-remark-other-probe = gereedschap { $tool } staat niet in de tastsysteemtabel: tastsysteem { $probe } is gebruikt
machine-remark-collision = de { $mover } zou { $feature } raken, met het midden van de kogel op X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = bewegingen zijn niet volledig gecontroleerd op { $features }
machine-remark-stylus-unchecked = de taststift is niet op botsingen gecontroleerd: hij staat niet langs Z
machine-remark-tool-offsets = { $offsets } van de TOOL CALL verandert het gesimuleerde tastsysteem niet
machine-remark-tool-locked = gereedschap { $tool } is geblokkeerd in de gereedschapstabel
machine-remark-no-probe-tool = gereedschap { $tool } is geen tastsysteem: TYP = { $kind }, { $probe } verwacht
machine-remark-no-such-tool = gereedschap { $tool } staat niet in de gereedschapstabel
machine-remark-same-name = { $more ->
    [one] nog een gereedschap heeft de naam { $tool }
   *[other] nog { $more } gereedschappen hebben de naam { $tool }
}: het eerste in de gereedschapstabel is gebruikt
machine-remark-content-uncertain = { $parameter } wordt hier gelezen, maar het is niet gedocumenteerd dat de diameter erin staat
machine-remark-not-waited = { $parameter } wordt gelezen zonder G909 na de cyclus: een besturing leest NC-regels vooruit en heeft misschien nog niet gemeten
machine-remark-position-unknown = de positie vóór de cyclus is niet bekend: zonder D begint hij in het nominale midden, zonder WB op hoogte 0

machine-passed-over = { $count } { $count ->
        [one] NC-regel
       *[other] NC-regels
    } zonder invloed op metingen: { $list }

## Pauzes
machine-pause-stop = het programma is gestopt: STOP of M0
machine-pause-optional-stop = het programma is gestopt: M1
machine-pause-breakpoint = de volgende NC-regel heeft een breekpunt
machine-pause-log = het meetprotocol staat op het scherm (Q281 = 2)

## A block of a measuring cycle without its program
alone-moved = { $text } verplaatst de tastcyclus erna of verandert zijn assen, maar de cyclus wordt uitgevoerd alsof dat niet zo is: voer het hele programma uit
alone-called = { $text } voert NC-regels uit die de tastcyclus erna kunnen verplaatsen, maar die zijn niet gelezen: voer het hele programma uit
alone-not-understood = { $text } wordt niet begrepen en kan de tastcyclus erna verplaatsen: controleer het programma, of voer het in zijn geheel uit
alone-not-run = het programma komt niet verder dan { $text } en bereikt de tastcyclus erna niet, dus een besturing meet hier niet: controleer het programma
alone-passed = { $text } kan de tastcyclus overslaan, dus een besturing meet hier misschien niet: voer het hele programma uit
alone-skipped = een besturing kan de tastcyclus overslaan vanwege de / ervoor: verwijder de / als er gemeten moet worden
