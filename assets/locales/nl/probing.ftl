# probing

# Where a measurement comes from, and what it cannot tell.
origin-simulated = gesimuleerd, cyclus { $cycle }, startgetal { $seed }
origin-contacts = tastpunten uit { $file }
origin-imported = ingelezen uit { $file }
origin-typed = ingetypt
caveat-only-a-diameter = alleen een diameter: over vorm en positie is niets bekend
caveat-three-contacts = 3 tastpunten: vorm is niet te meten
caveat-four-contacts = 4 tastpunten: behalve ovaliteit is geen vorm te zien
caveat-few-contacts = { $contacts } tastpunten: de vorm daartussen is niet te zien
caveat-short-arc = tastpunten beslaan maar { $arc }°: spreiding werkt vergroot door in diameter en middelpunt

# Touches.
contact-missed = tasting { $number }: geen contact op de tastweg
contact-in-material = tasting { $number }: de tastweg begint in het materiaal
contact-used-up = tasting { $number }: het bestand heeft maar { $available } tastpunten

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
circle-apart = tastpunt { $contact } ligt { $apart } mm naast de cirkel, veel verder dan de andere: vuil of een valse tasting?
