# probing

origin-simulated = gesimuleerd, cyclus { $cycle }, startgetal { $seed }
origin-contacts = meetpunten uit { $file }
origin-imported = geïmporteerd uit { $file }
origin-typed = getypt
caveat-only-a-diameter = slechts één diameter: over vorm en positie is niets bekend
caveat-three-contacts = 3 meetpunten: de vorm is niet te meten
caveat-four-contacts = 4 meetpunten: geen vorm te zien behalve ovaliteit
caveat-few-contacts = { $contacts } meetpunten: de vorm ertussen is niet te zien
caveat-short-arc = de meetpunten beslaan slechts { $arc }°: spreiding wordt vergroot in diameter en midden
contact-missed = aanraking { $number }: geen contact op de meetweg
contact-used-up = aanraking { $number }: het bestand heeft maar { $available } meetpunten

cycle-out-of-range = Q{ $q } { $name } = { $given }: { $allowed }
cycle-length-range = minstens { $least } mm, hoogstens { $most } mm
cycle-angle-range = hoogstens { $most } in beide richtingen
cycle-angle-size-range = minstens { $smallest } groot, hoogstens { $most }
cycle-one-of = geen van { $allowed }
cycle-tool-range = een gereedschapsnummer is 0 tot 99999
cycle-not-a-value = Q{ $q } { $name }: { $error }
cycle-no-diameter = Q{ $q } { $name } = 0 mm: een cirkel heeft een diameter boven 0 nodig
cycle-missing = Q{ $q } { $name } ontbreekt
cycle-no-such-parameter = cyclus { $cycle } heeft geen parameter Q{ $q }
cycle-limits-swapped = de minimale maat { $minimum } mm is groter dan de maximale maat { $maximum } mm
cycle-too-large = de gemeten cirkel is te groot: { $error }
workpiece-cannot-be = { $what } = { $given }: minstens { $least }, hoogstens { $most }
# Where a measurement comes from, and what it cannot tell.

# Touches.
contact-in-material = tasting { $number }: de tastweg begint in het materiaal

# Circle evaluation.
circle-too-few = een cirkel heeft minstens 3 tastpunten nodig, gegeven: { $contacts }
circle-coinciding = tastpunten { $first } en { $second } vallen samen op x = { $x }, y = { $y }: een cirkel heeft 3 verschillende punten nodig
circle-collinear = alle { $contacts } tastpunten liggen op één rechte lijn: daar gaat geen cirkel door
circle-straight = de { $contacts } tastpunten passen beter op een rechte lijn dan op welke cirkel ook
circle-not-finite = tastpunt { $contact }: { $axis } = { $value } is geen eindig getal
circle-too-large = { $what } = { $value } mm is te groot: hoogstens { $most } mm in beide richtingen
circle-three-contacts = 3 tastpunten: vorm is niet te meten, de restafwijking is altijd nul
circle-four-contacts = 4 tastpunten: vier lobben blijven onzichtbaar en veranderen de diameter
circle-short-arc = de tastpunten beslaan maar { $arc }° van de cirkel: de spreiding in de diameter is { $factor } keer die van 3 tastpunten op 120°
circle-circumscribed-of-short-arc = de kleinste omgeschreven cirkel van een korte boog is niet de maat van het element
circle-counts-twice = tastpunten { $first } en { $second } vallen samen: deze plaats telt dubbel
circle-no-inscribed = er is geen grootste ingeschreven cirkel: de tastpunten omsluiten er geen
circle-no-zone = er is geen minimale zone: een rechte strook is smaller dan elke ring
circle-too-many-contacts = grootste ingeschreven cirkel en minimale zone worden niet berekend voor { $contacts } tastpunten: hoogstens { $most }
circle-short-chord = tastpunten { $first } en { $second } liggen tegenover elkaar naast het middelpunt: deze maat is { $short } µm te klein
circle-more-of-a-kind = hetzelfde geldt voor nog { $more }
circle-apart = tastpunt { $contact } ligt { $apart } mm naast de cirkel, veel verder dan de andere: vuil of een valse tasting?
