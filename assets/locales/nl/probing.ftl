# probing

origin-simulated = gesimuleerd, cyclus { $cycle }, startgetal { $seed }
origin-contacts = meetpunten uit { $file }
origin-imported = geïmporteerd uit { $file }
origin-imported-simulation = geïmporteerd uit { $file }, gesimuleerd
origin-typed = getypt
caveat-only-a-diameter = alleen een diameter: vorm en positie zijn onbekend
caveat-only-a-circle = alleen diameter en midden: de vorm is onbekend
caveat-three-contacts = 3 meetpunten: de vorm is niet te meten
caveat-four-contacts = 4 meetpunten: behalve ovaliteit is geen vorm te zien
caveat-few-contacts = { $contacts } meetpunten: de vorm ertussen is niet te zien
caveat-short-arc = de meetpunten beslaan maar { $arc }°: spreiding werkt versterkt door in diameter en midden
caveat-two-point = de diameter over de meetpunten { $one } en { $other } is { $size } mm, voorbij de grens van { $limit } mm, die de gemiddelde cirkel niet overschrijdt: een maat geldt standaard tussen elke twee punten tegenover elkaar
caveat-form = de radii van de meetpunten verschillen { $form } mm, dus de diameters daarover kunnen meer verschillen dan het tolerantieveld van { $zone } mm: twee punten tegenover elkaar kunnen buiten de grenzen liggen
caveat-heights = de hoogten van de meetpunten verschillen { $spread } mm: op een kegel of scheve as verandert dat de diameter
caveat-stated = de maataanduiding noemt achter de tolerantie { $upper } en { $lower } µm, de tolerantie heeft { $used-upper } en { $used-lower } µm: de tolerantie is gebruikt; controleer wat de tekening bedoelt
caveat-count = de maataanduiding geldt voor { $count } elementen: deze waarde is die van één
caveat-form-class = klasse { $class } van ISO 2768-2 geldt voor vorm en plaats: de maat toont die niet
caveat-each-two-point = { $modifier } eist elke tweepuntsmaat binnen de grenzen: dit is maar één diameter
caveat-mean-of-two-points = { $modifier } eist elke tweepuntsmaat binnen de grenzen: de kleinste-kwadratendiameter is alleen hun gemiddelde
caveat-not-least-squares = { $modifier } bedoelt de kleinste-kwadratenmaat: één diameter toont die niet
caveat-one-section = { $modifier } bedoelt de kleinste-kwadratenmaat van het hele element: dit is die van één doorsnede
caveat-envelope = { $modifier } eist de omhulling met ideale vorm op de maximum-materiaalmaat: één diameter toont niet of het oppervlak daarbuiten komt; gebruik een kaliber
caveat-other-size = { $modifier } bedoelt een andere maat dan de gemeten: een tweepunts- of kleinste-kwadratendiameter bewijst die niet
caveat-condition = { $modifier } zegt waar of hoe de maat geldt: de gemeten waarde toont niet of daaraan is voldaan
contact-beyond-travel = meetpunt { $number } ligt { $distance } mm van waar het tasten ervan begint, en de kogel gaat hoogstens { $allowed } mm ver (DIST of K, plus SET_UP van de tastsysteemtabel en Q320): controleer of deze meetpunten van dit element zijn, in deze volgorde, en vanaf dit nulpunt
contact-missed = meetpunt { $number }: het tastsysteem heeft op de tastweg niets geraakt
contact-no-height = meetpunt { $number } heeft geen hoogte: voeg aan het bestand een kolom z toe
contact-used-up = meetpunt { $number }: het bestand heeft maar { $available ->
    [one] { $available } meetpunt
   *[other] { $available } meetpunten
    }

cycle-out-of-range = { $key } { $name } = { $given }: { $allowed }
cycle-length-range = minstens { $least } mm, hoogstens { $most } mm
cycle-angle-range = hoogstens { $most } in beide richtingen
cycle-angle-size-range = minstens { $smallest } groot, hoogstens { $most }
cycle-one-of = een van { $allowed } verwacht
cycle-tool-range = een gereedschapsnummer van 0 tot 99999,9, of een gereedschapsnaam van hoogstens 255 tekens
cycle-not-a-value = { $key } { $name }: { $error }
cycle-tool-no-name = { $text } roept geen gereedschap op: geef het nummer, of de naam
cycle-tool-empty = er is geen gereedschap genoemd: schrijf Q330=0 voor geen gereedschap
cycle-tool-unquoted = { $text } is geen getal, en de naam van een gereedschap staat tussen aanhalingstekens
cycle-no-diameter = { $key } { $name } = 0 mm: een cirkel heeft een diameter groter dan 0 nodig
cycle-one-limit = { $given } is opgegeven zonder { $missing }: 0 zou de andere grens zijn
cycle-missing = { $key } { $name } ontbreekt
cycle-no-such-parameter = cyclus { $cycle } heeft geen parameter { $parameter }: de parameters zijn { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm is groter dan { $maximum-key } = { $maximum } mm: de minimale maat is groter dan de maximale
cycle-too-large = de gemeten cirkel is te groot: { $error }
workpiece-cannot-be = { $what } = { $given }: minstens { $least }, hoogstens { $most }
# Where a measurement comes from, and what it cannot tell.

# Touches.
contact-in-material = meetpunt { $number }: de tastweg begint in het materiaal
contact-in-feature = meetpunt { $number }: de tastweg begint in het materiaal van { $feature }
contact-behind = meetpunt { $number }: de kogel raakt de wand van { $feature } van achteren, en de dikte van het materiaal daar is onbekend
contact-ambiguous = meetpunt { $number }: de kogel raakt { $feature } en { $other } op dezelfde plaats, dus het is niet bekend welke er wordt gemeten

# Circle evaluation.
circle-too-few = een cirkel heeft minstens 3 meetpunten nodig, gevonden: { $contacts }
circle-coinciding = meetpunten { $first } en { $second } vallen samen op x = { $x }, y = { $y }: een cirkel heeft 3 verschillende punten nodig
circle-collinear = alle { $contacts } meetpunten liggen op één rechte lijn: daar gaat geen cirkel door
circle-straight = de { $contacts } meetpunten passen beter op een rechte lijn dan op welke cirkel ook
circle-not-finite = meetpunt { $contact }: { $axis } = { $value } is geen eindig getal
circle-too-large = { $what } = { $value } mm is te groot: hoogstens { $most } mm in beide richtingen
circle-part-contact = meetpunt { $contact }: { $axis }
circle-part-diameter = diameter
circle-part-centre = midden { $axis }
circle-three-contacts = 3 meetpunten: de vorm is niet te meten, de restafwijking is altijd nul
circle-four-contacts = 4 meetpunten: vier lobben blijven onzichtbaar en veranderen de diameter
circle-short-arc = de meetpunten beslaan maar { $arc }° van de cirkel: de spreiding in de diameter is { $factor } keer die van 3 meetpunten op 120°
circle-circumscribed-of-short-arc = de kleinste omgeschreven cirkel van een korte boog is niet de maat van het element
circle-counts-twice = meetpunten { $first } en { $second } vallen samen: deze plaats telt dubbel
circle-no-inscribed = geen grootste ingeschreven cirkel: de meetpunten omsluiten er geen
circle-no-zone = geen minimale zone: een rechte strook is smaller dan elke ring
circle-too-many-contacts = grootste ingeschreven cirkel en minimale zone worden voor { $contacts } meetpunten niet berekend: hoogstens { $most }
circle-short-chord = meetpunten { $first } en { $second } liggen tegenover elkaar, maar naast het midden: deze maat is { $short } µm te klein
circle-more-of-a-kind = hetzelfde geldt voor nog { $more }
circle-apart = meetpunt { $contact } ligt { $apart } mm naast de cirkel, veel verder dan de andere: vuil of een valse tasting?
circle-heights = de hoogten van de meetpunten verschillen { $spread } mm: op een kegel of scheve as verandert dat de diameter

## Measuring cycles: errors, results, remarks
contact-out-of-reach = meetpunt { $number }: het tastsysteem heeft binnen de tastweg van { $longest } mm niets geraakt
cycle-number-range = een getal, hoogstens { $most } in beide richtingen
cycle-count-range = een geheel getal van 0 tot { $most }
cycle-band-range = een tolerantie zoals 0.4-0.1, 0.4 of -0.1; 0 betekent geen tolerantie
cycle-range = { $range }
cycle-range-tool = 0 … { $highest }, of hoogstens { $longest } tekens
cycle-range-band = 0.4-0.1, 0.4, -0.1 of niets
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = geen tolerantie
cycle-no-global = { $key } { $name } = PREDEF: geen GLOBAL DEF geeft een waarde
cycle-no-path = { $key } { $name } = 0 mm: een tastweg heeft een lengte nodig; het teken geeft de richting
cycle-no-transfer = { $row-key } = { $row } bij { $key } = -1: er staat niet bij in welke tabel die regel staat; { $key } moet 0 of 1 zijn (een besturing meldt fout 1078)
cycle-other-feature = { $key } { $name } = { $given }: de klasse past niet bij { $geometry }: hoofdletters gelden voor een boring, kleine letters voor een tap
cycle-not-measured = { $key } { $name } = { $given }: de cyclus meet deze waarde niet: schrijf ze zonder tolerantie
cycle-inch-tolerance = { $key } { $name } = { $given }: in een programma in inches is de eenheid van een tolerantie niet bekend: schrijf een programma in mm, of het getal zonder tolerantie
cycle-no-edge = { $first } en { $second } zijn gelijk: een kant heeft twee punten in haar richting nodig
cycle-no-sphere = de meetpunten bepalen geen bol
cycle-no-rotation = { $key } { $name }: Fitcheck volgt alleen een basisrotatie (Q1121 = 1), en die zonder correctie (Q1120 = 0)
cycle-no-normal = { $first }, { $second } en { $third } zijn alle drie 0: een normaal heeft een richting nodig
cycle-apart = meetpunt { $contact }: de twee tastingen liggen { $difference } mm uit elkaar, { $key } staat { $most } mm toe
cycle-too-far = de gemeten coördinaat is te groot: { $error }
cycle-stop = programmastop door Q309 = { $setting }: { $out }
check-within = { $what } { $measured } mm ligt binnen { $minimum } tot { $maximum } mm
check-above = { $what } { $measured } mm ligt boven het maximum { $maximum } mm: { $status }
check-below = { $what } { $measured } mm ligt onder het minimum { $minimum } mm: { $status }
check-and = { $one }; { $other }
found-centre-1 = gemeten midden, 1e as
found-centre-2 = gemeten midden, 2e as
found-centre-3 = gemeten midden, 3e as
found-diameter = gemeten diameter
found-centre-deviation-1 = afwijking van het midden, 1e as
found-centre-deviation-2 = afwijking van het midden, 2e as
found-centre-deviation-3 = afwijking van het midden, 3e as
found-diameter-deviation = afwijking van de diameter
found-coordinate = gemeten coördinaat
found-coordinate-deviation = afwijking van de coördinaat
found-position-1 = gemeten positie, 1e as
found-position-2 = gemeten positie, 2e as
found-position-3 = gemeten positie, 3e as
found-angle = gemeten hoek
found-deviation-1 = afwijking, 1e as
found-deviation-2 = afwijking, 2e as
found-deviation-3 = afwijking, 3e as
found-deviation-along = afwijking langs de normaal
found-second-position-1 = 2e punt: gemeten positie, 1e as
found-second-position-2 = 2e punt: gemeten positie, 2e as
found-second-position-3 = 2e punt: gemeten positie, 3e as
found-second-deviation-1 = 2e punt: afwijking, 1e as
found-second-deviation-2 = 2e punt: afwijking, 2e as
found-second-deviation-3 = 2e punt: afwijking, 3e as
found-second-diameter = 2e cirkel: gemeten diameter
found-second-diameter-deviation = 2e cirkel: afwijking van de diameter
found-rotation = gemeten rotatie
found-side-1 = gemeten lengte, 1e zijde
found-side-2 = gemeten lengte, 2e zijde
found-width = gemeten breedte
found-centre-line = positie van de middenlijn
found-side-deviation-1 = afwijking van de 1e zijde
found-side-deviation-2 = afwijking van de 2e zijde
found-width-deviation = afwijking van de breedte
found-good = binnen tolerantie
found-rework = nabewerking
found-scrap = afkeur
found-status = status: -1 niet gedefinieerd, 0 goed, 1 nabewerking, 2 afkeur
cycle-note-machine-builder = de machinefabrikant moet deze cyclus vrijgeven en aanpassen: zie het machinehandboek
cycle-note-not-on-itnc530 = een iTNC 530 heeft deze cyclus niet; TNC 320, TNC 620, TNC 640 en TNC7 hebben hem
cycle-note-normal-from-cad = neem de normaal uit een CAD- of CAM-systeem
cycle-note-software-option = de besturing heeft softwareoptie { $option } nodig
cycle-note-recommended = waar de besturing cyclus { $cycle } heeft, raadt HEIDENHAIN die in plaats van deze aan
cycle-note-ends-rotation = beëindigt een actieve basisrotatie
remark-without-effect = { $key } is toegestaan maar heeft geen werking
remark-tool-not-monitored = Q330 = { $tool }: het gereedschap wordt niet bewaakt: geen gereedschapstabel
remark-outside-dimension = een buitenmaat is aangenomen: boven het maximum is nabewerking, onder het minimum is afkeur
remark-nominal-outside-limits = nominale diameter { $nominal } mm ligt niet tussen de grensmaten: een TNC7 weigert dat
remark-nominal-width-outside-limits = nominale breedte { $nominal } mm ligt niet tussen de grensmaten: een TNC7 weigert dat
remark-nominal-coordinate-outside-limits = nominale coördinaat { $nominal } mm ligt niet tussen de grensmaten: volgens zijn handboek kan een TNC7 dat weigeren
remark-contact-astray = { $count ->
    [one] meetpunt { $contact } ligt { $distance } mm van waar de cyclus tast: misschien hoort het bij een ander element
   *[other] { $count } meetpunten liggen niet waar de cyclus tast, meetpunt { $contact } het verst met { $distance } mm: misschien horen ze bij een ander element
}
remark-deviation-without-parameter = de afwijking heeft hier geen parameter: het handboek zegt dat een besturing haar opslaat, maar niet in welke
remark-new-datum = nieuw referentiepunt, { $target }: { $axes } mm (gemeten → gewenst)
datum-target-display = meteen actief
datum-target-active = correctie van het actieve referentiepunt
datum-target-preset = regel { $row } van de referentiepunttabel
datum-target-table = regel { $row } van de nulpunttabel
remark-new-rotation = nieuwe basisrotatie van { $angle }: { $target }
remark-axis-turned = as { $axis } draait het werkstuk over { $angle }: alleen de machine weet waar het midden ervan ligt, en Fitcheck schrijft het nulpunt van de as in geen enkele tabel
remark-variable-holds-diameter = #i99 is als diameter gelezen: het handboek zegt niet welke waarde erin staat
remark-no-tolerance = { $key } is geen tolerantie: er wordt niets beoordeeld

## The simulated machine
workpiece-file-toml = regel { $line }: { $said }
workpiece-file-too-large = een werkstukbestand heeft hoogstens { $most } KiB
workpiece-file-not-one = het bestand heeft { $found } van { $tables }: precies één is nodig
workpiece-file-cannot-be = regel { $line }: { $error }
workpiece-file-several = het bestand heeft [[feature]]-tabellen: hier wordt een werkstuk met één oppervlak verwacht
workpiece-file-too-many = een onderdeel heeft hoogstens { $most } elementen
workpiece-file-feature = regel { $line }, teken { $column }: { $feature }: { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } is geen soort element: de soorten zijn { $known }
feature-fault-no-key = bij { $kind } hoort { $key }
feature-fault-other-key = bij { $kind } hoort geen { $key }
feature-fault-name = een naam heeft 1 tot { $most } tekens op één regel
feature-fault-same-name = een ander element heeft dezelfde naam

# Figures of the simulated workpiece, as errors name them.
figure-temperature = temperatuur
figure-expansion = uitzetting
figure-probe-scatter = spreiding van het tastsysteem
figure-ball-radius = kogelradius
figure-calibration-error = kalibratiefout
figure-offset = verschuiving
figure-lobing = amplitude van de schakelweg
figure-lobing-angle = hoek van de schakelweg
figure-lobing-count = lobben van de schakelweg
figure-centre-x = midden x
figure-centre-y = midden y
figure-diameter = diameter
figure-surface-scatter = spreiding van het oppervlak
figure-ovality = ovaliteit
figure-ovality-angle = hoek van de ovaliteit
figure-ovality-count = aantal toppen van de ovaliteit
figure-lobe-height = lobhoogte
figure-lobe-angle = hoek van de lobben
figure-lobes = lobben
figure-point = punt
figure-normal = normaal
figure-normal-length = lengte van de normaal
figure-wave-length = golflengte
figure-wave-amplitude = amplitude van de golf
figure-wave-direction = golfrichting
figure-deviation = afwijking
figure-radius = radius
figure-width = breedte
figure-first-length = 1e lengte
figure-second-length = 2e lengte
figure-angle = hoek
figure-top = bovenkant
figure-bottom = onderkant
figure-length = lengte van de wanden
figure-reach = reikwijdte
figure-stylus-radius = radius van de taststift

## What of the probe touches.
mover-ball = kogel
mover-stylus = taststift
