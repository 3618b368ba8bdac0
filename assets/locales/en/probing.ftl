# probing

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
cycle-missing = Q{ $q } { $name } is missing
cycle-no-such-parameter = cycle { $cycle } has no parameter Q{ $q }
cycle-limits-swapped = minimum dimension { $minimum } mm is above maximum dimension { $maximum } mm
cycle-too-large = the measured circle is too large: { $error }
workpiece-cannot-be = { $what } = { $given }: { $allowed }
