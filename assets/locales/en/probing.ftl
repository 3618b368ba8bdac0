# probing

# Where a measurement comes from, and what it cannot tell.
origin-simulated = simulated, cycle { $cycle }, seed { $seed }
origin-contacts = contacts from { $file }
origin-imported = imported from { $file }
origin-typed = typed
caveat-only-a-diameter = one diameter only: nothing is known of form and position
caveat-three-contacts = 3 contacts: form cannot be measured
caveat-four-contacts = 4 contacts: no form seen beyond ovality
caveat-few-contacts = { $contacts } contacts: form between them is not seen
caveat-short-arc = contacts cover only { $arc }°: scatter is magnified in diameter and centre
contact-missed = touch { $number }: no contact on the probing path
contact-used-up = touch { $number }: the file has only { $available } contacts

cycle-out-of-range = Q{ $q } { $name } = { $given }: { $allowed }
cycle-length-range = at least { $least } mm, at most { $most } mm
cycle-angle-range = at most { $most } either way
cycle-angle-size-range = at least { $smallest } in size, at most { $most }
cycle-one-of = not one of { $allowed }
cycle-tool-range = a tool number is 0 to 99999
cycle-not-a-value = Q{ $q } { $name }: { $error }
cycle-no-diameter = Q{ $q } { $name } = 0 mm: a circle needs a diameter above 0
cycle-missing = Q{ $q } { $name } is missing
cycle-no-such-parameter = cycle { $cycle } has no parameter Q{ $q }
cycle-limits-swapped = minimum dimension { $minimum } mm is above maximum dimension { $maximum } mm
cycle-too-large = the measured circle is too large: { $error }
workpiece-cannot-be = { $what } = { $given }: at least { $least }, at most { $most }

# Touches.
contact-in-material = touch { $number }: the probing path begins inside the material

# Circle evaluation.
circle-too-few = a circle needs at least 3 contacts, given: { $contacts }
circle-coinciding = contacts { $first } and { $second } coincide at x = { $x }, y = { $y }: a circle needs 3 different points
circle-collinear = all { $contacts } contacts lie on one straight line: no circle goes through them
circle-straight = the { $contacts } contacts fit a straight line better than any circle
circle-not-finite = contact { $contact }: { $axis } = { $value } is not a finite number
circle-too-large = { $what } = { $value } mm is too large: at most { $most } mm either way
circle-three-contacts = 3 contacts: form cannot be measured, the residual is always zero
circle-four-contacts = 4 contacts: four lobes stay unseen and change the diameter
circle-short-arc = the contacts cover only { $arc }° of arc: scatter in the diameter is { $factor } times that of 3 contacts at 120°
circle-circumscribed-of-short-arc = the minimum circumscribed circle of a short arc is not the size of the feature
circle-counts-twice = contacts { $first } and { $second } coincide: this place counts twice
circle-no-inscribed = there is no maximum inscribed circle: the contacts do not surround one
circle-no-zone = there is no minimum zone: a straight strip is narrower than every ring
circle-too-many-contacts = maximum inscribed circle and minimum zone are not computed for { $contacts } contacts: at most { $most }
circle-short-chord = contacts { $first } and { $second } oppose each other beside the centre: this size is { $short } µm too small
circle-more-of-a-kind = the same holds for { $more } more
circle-apart = contact { $contact } lies { $apart } mm off the circle, far more than the others: dust or a false touch?
