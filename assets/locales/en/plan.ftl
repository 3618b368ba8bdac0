# Plans of features: what is wrong with one.

plan-no-features = the plan has no features
plan-no-form-limit = { $text } is not the limit of a form or location tolerance: write one length above 0 in mm, such as 0.02
plan-too-many = the plan has more than { $most } features
plan-too-large = a plan has at most { $most } KiB
plan-no-column = column { $column } is missing
plan-unknown-column = unknown column { $column }: the columns are { $known }
plan-column-twice = column { $column } occurs twice
plan-cells = the row has { $found } cells and the header { $expected }: with a decimal comma, separate the columns with semicolons
plan-no-cell = { $column } is missing
plan-value = { $what }: { $error }
plan-no-feature = { $callout } may be a hole or a shaft: add feature = "hole" or feature = "shaft", or kind = "length" where it is neither
plan-fit = { $callout } is a fit: write the hole and the shaft as two features
plan-clearance-height = clearance height { $height } mm is not above the measuring height, { $z } mm
plan-same-name = name { $name } occurs twice{ $line ->
    [0] : file names on a control ignore case
   *[other] , first on line { $line }: file names on a control ignore case
}
plan-unknown = { $column } { $given } is not known: expected { $known }
plan-other-side = kind { $given } contradicts the { $column } { $text }, which is that of a { $side ->
    [hole] hole
   *[shaft] shaft
    }: correct one of them, or write diameter
plan-not-of = a { $kind } has no { $column }
plan-direction = axis { $given } is not a direction: expected { $known }, or three numbers such as 0.5 0 -1, from -10 to 10 with at most 9 decimals and not all 0
plan-no-band = { $text } is not a tolerance band for a point, such as ±0.05 or +0.1/-0.05: { $error }
plan-band-side = a point cannot have deviations from { $lower } to { $upper } mm: the cycle needs an upper one of 0 or more and a lower one of 0 or less, not both 0
plan-side-class = { $callout }: both sides of a { $kind } need classes such as { $example }
plan-face-class = { $callout }: a face is judged as an outside dimension and needs a shaft class, such as h9
plan-face-place = { $callout }: the face is at { $coordinate } mm along the measured axis, which must be its nominal size
plan-not-a-plan = this is not a plan: a plan has a line with the names of its columns, such as name;callout;x;y;z, or begins with fitcheck_plan = 1
plan-other-version = this plan has version { $given }: versions 1 to { $newest } are supported
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = unknown key { $key }: expected { $known }
plan-other-value = { $key }: expected { $expected }, found { $found }
plan-parameter = cycle { $cycle } does not take { $given } from a plan: write NAME=VALUE with one of { $known }
plan-no-parameter = no measuring cycle takes { $given } from a plan: write NAME=VALUE, such as Q423=3
plan-travel = { $axis }{ $given } is outside the machine's travel, { $minimum } to { $maximum } mm
plan-clearance-travel = the probe moves at Z{ $height }, which is outside the machine's travel, { $minimum } to { $maximum } mm: give another clearance_height
plan-no-travel = { $given } is not a travel: write two numbers, the smaller one first, such as -250 250
plan-no-plausible = { $column }: { $given } is not a range: write two lengths in mm, the smaller one first, such as 24.5 25.5
plan-plausible-limits = { $column }: { $lower } to { $upper } mm does not contain the limits of size, { $minimum } to { $maximum } mm: give a wider range
plan-text = { $column }: expected one line of at most { $most } characters
plan-same-number = { $line ->
    [0] number { $number } occurs twice: another feature has { $other }
   *[other] number { $number } occurs twice: the feature on line { $line } has { $other }
}
plan-same-size = { $line ->
    [0] a value { $called } could belong to this feature or to { $other }: rename one of them
   *[other] a value { $called } could belong to this feature or to { $other } on line { $line }: rename one of them
}
plan-number-is-name = { $line ->
    [0] number { $number } is the name of another feature, { $other }
   *[other] number { $number } is the name of another feature, { $other } on line { $line }
}
plan-name-is-number = { $line ->
    [0] a value { $called } could belong to this feature or to { $other }, whose number it is
   *[other] a value { $called } could belong to this feature or to { $other } on line { $line }, whose number it is
}
plan-balloon = { $given } is not a place on the picture: expected 0 to 1
plan-not-found-unknown = not judged: no feature of the plan has this name, number or location
plan-not-found-no-clue = not judged: the value has no name, number or location, so it matches no feature of the plan
plan-not-found-half-place = not judged: no feature of the plan has this name or number, and a location needs X and Y
plan-not-found-contradiction = not judged: its name matches { $name } of the plan, but its number matches { $number }
plan-not-found-other-name = no feature of the plan is called { $given }; { $name } has the same number, but that may be a running number: name the feature as the plan does, or give its nominal size
plan-not-found-running-number = not judged: only its number matches { $name } of the plan, and that may be a running number, for other rows of the file are not of this plan
plan-not-found-other-nominal = not judged: it matches { $name } of the plan, but its nominal size is { $given } and the plan's is { $planned }
plan-not-found-other-limits = not judged: it matches { $name } of the plan, but its limits { $given } have nothing in common with the plan's { $planned }
plan-not-found-several = not judged: several features of the plan have this location: { $names }
plan-not-found-which-side = not judged: the value does not say which of { $names } it is
part-standing = { $measured } measured, { $missing } missing, { $skipped } skipped
plan-not-found-other-kind = not judged: it matches { $name } of the plan, but that is a { $kind }, and something else was measured
plan-remark-file = { $said }
plan-remark-left = { $name } is skipped: { $why }
plan-remark-class-left = { $name }: { $class } has other limits than the file; the file's limits apply
plan-remark-place-left = { $name }: no position was taken over: { $why }
plan-remark-axes-assumed = positions: the file does not say along which axes its holes and shafts lie; Z is assumed
plan-remark-uncertainty-left = { $name }: the expanded uncertainty of { $expanded } mm is skipped, because half of it is not a whole number of nanometres
plan-remark-clearance-raised = { $name } lies above the usual clearance height: { $height } is written
plan-simulated-no-place = { $name } has no location in the plan: it cannot be simulated
plan-simulated-no-cycle = no cycle measures { $name }: it cannot be simulated
