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
cycle-missing = Q{ $q } { $name } ontbreekt
cycle-no-such-parameter = cyclus { $cycle } heeft geen parameter Q{ $q }
cycle-limits-swapped = de minimale maat { $minimum } mm is groter dan de maximale maat { $maximum } mm
cycle-too-large = de gemeten cirkel is te groot: { $error }
workpiece-cannot-be = { $what } = { $given }: { $allowed }
