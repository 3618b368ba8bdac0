# Plans of features: what is wrong with one.

plan-no-features = the plan has no feature
plan-too-many = the plan has more than { $most } features
plan-too-large = a plan has at most { $most } KiB
plan-no-column = column { $column } is missing
plan-unknown-column = unknown column { $column }: the columns are { $known }
plan-column-twice = column { $column } occurs twice
plan-cells = the row has { $found } cells and the header { $expected }: with a decimal comma, separate the columns with semicolons
plan-no-cell = { $column } is missing
plan-value = { $what }: { $error }
plan-fit = { $callout } is a fit: write the hole and the shaft as two features
plan-clearance-height = clearance height { $height } mm is not above the measuring height, { $z } mm
plan-same-name = name { $name } occurs twice{ $line ->
    [0] : file names on a control ignore case
   *[other] , first on line { $line }: file names on a control ignore case
}
plan-unknown = { $column } { $given } is not known: expected { $known }
plan-not-of = a { $kind } has no { $column }
plan-direction = axis { $given } is not a direction: expected { $known }, or three numbers such as 0.5 0 -1, from -10 to 10 with at most 9 decimals and not all 0
plan-no-band = { $text } is not the band of a point, such as ±0.05 or +0.1/-0.05: { $error }
plan-band-side = a point cannot have deviations from { $lower } to { $upper } mm: the cycle takes an upper one of 0 or more and a lower one of 0 or less, not both 0
plan-side-class = { $callout }: both sides of a { $kind } need classes such as { $example }
plan-face-class = { $callout }: a face is judged as an outside dimension and needs a shaft class, such as h9
plan-face-place = { $callout }: the face is at { $coordinate } mm along the measured axis, which must be its nominal size
plan-not-a-plan = this is not a plan: a plan has a line with the names of its columns, such as name;callout;x;y;z, or begins with fitcheck_plan = 1
plan-other-version = this plan is of version { $given }: versions 1 to { $newest } are read
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = unknown key { $key }: expected { $known }
plan-other-value = { $key }: expected { $expected }, found { $found }
plan-parameter = cycle { $cycle } does not take { $given } from a plan: write NAME=VALUE with one of { $known }
plan-no-parameter = no measuring cycle takes { $given } from a plan: write NAME=VALUE, such as Q423=3
plan-travel = { $axis }{ $given } is outside the machine's travel, { $minimum } to { $maximum } mm
plan-clearance-travel = the probe moves at Z{ $height }, which is outside the machine's travel, { $minimum } to { $maximum } mm: give another clearance_height
plan-no-travel = { $given } is no travel: write two numbers, the smaller one first, such as -250 250
plan-text = { $column }: one line with at most { $most } characters
plan-same-number = { $line ->
    [0] number { $number } occurs twice: another feature has { $other }
   *[other] number { $number } occurs twice: the feature on line { $line } has { $other }
}
plan-same-size = { $line ->
    [0] a value { $called } could be of this feature or of { $other }: give one of them another name
   *[other] a value { $called } could be of this feature or of { $other } on line { $line }: give one of them another name
}
plan-number-is-name = { $line ->
    [0] number { $number } is the name of another feature, { $other }
   *[other] number { $number } is the name of another feature, { $other } on line { $line }
}
plan-name-is-number = { $line ->
    [0] a value { $called } could be of this feature or of { $other }, whose number it is
   *[other] a value { $called } could be of this feature or of { $other } on line { $line }, whose number it is
}
plan-balloon = { $given } is not a place on the picture: from 0 to 1
plan-not-found-unknown = not judged: no feature of the plan has this name or number, or lies there
plan-not-found-no-clue = not judged: the value has neither a name nor a number nor a place, so no feature of the plan is found for it
plan-not-found-half-place = not judged: no feature of the plan has this name or number, and a place needs X and Y
plan-not-found-contradiction = not judged: by its name it is { $name } of the plan, by its number { $number }
plan-not-found-other-name = no feature of the plan is called { $given }, and a number alone may be a running one: { $name } has it; name the feature as the plan does, or give its nominal size
plan-not-found-other-nominal = not judged: it would be { $name } of the plan, but its nominal size is { $given }
plan-not-found-several = not judged: several features of the plan lie there: { $names }
plan-not-found-which-side = not judged: the value does not say which of { $names } it is
part-standing = { $measured } measured, { $missing } missing, { $skipped } left out
plan-not-found-other-kind = not judged: it would be { $name } of the plan, but that is a { $kind }, and something else was measured
plan-remark-left = { $name } is left out: { $why }
plan-remark-class-left = { $name }: { $class } has other limits than the file, which count
plan-remark-uncertainty-left = { $name }: the expanded uncertainty of { $expanded } mm is left out, because half of it is no whole number of nanometres
plan-simulated-no-place = { $name } has no place in the plan: it cannot be simulated
plan-simulated-no-cycle = no cycle measures { $name }: it cannot be simulated
