# tolerance

## Lengths
length-empty = a length is missing
length-not-a-number = { $text } is not a number
length-ambiguous = { $text } is ambiguous: write one decimal sign and no thousands separator
length-too-fine = { $text } is finer than a nanometre
length-too-large = { $text } is too large: at most { $max } mm either way

## Callouts and classes
callout-empty = a callout is missing: write a nominal size and a tolerance class, such as 25 H7
callout-no-nominal = { $text } does not begin with a nominal size: write one, such as 25 H7
callout-nominal = nominal size: { $error }
callout-not-positive = nominal size { $nominal } mm is not above 0
class-missing = a tolerance class is missing, such as H7 for a hole or h7 for a shaft
class-mixed-case = { $text } mixes upper and lower case: write { $upper } for a hole or { $lower } for a shaft
class-malformed = { $text } is not a tolerance class: write letters and a grade, such as H7 or js13

## Deviations and limits
deviations-order = upper deviation { $upper } mm is below lower deviation { $lower } mm
nominal-by-operator = ? means that the operator positions the probe: write the nominal value without it
nominal-not-probed = @ means that the control does not probe and takes the value after it: nothing would be measured
source-choice-iso286 = ISO 286, every class to 3150 mm
source-choice-control = The control's tables, 47 classes to 400 mm
source-choice-after-own = Own tables, then { $base }
source-iso286 = ISO 286, over { $over } up to { $to } mm
source-iso286-remark = ISO 286, over { $over } up to { $to } mm; { $remark }
source-shipped-table = built-in table { $name }, over { $over } up to { $to } mm
source-table = table { $name }, over { $over } up to { $to } mm
figure-own-table = { $class } over { $over } up to { $to } mm: table { $table } differs from ISO 286, which has { $upper } and { $lower } mm
figure-standard = { $class } over { $over } up to { $to } mm: { $why }
source-file = file { $name }
source-iso2768 = ISO 2768-1 class { $class }, over { $over } up to { $to } mm
source-callout = the callout itself
source-without-own = { $source }; own tables in { $folder } could not be read
source-recorded = { $text }
limits-own-awaited = The own tables in { $folder } are still being read
limits-no-feature = { $callout } does not say whether the hole or the shaft is meant
limits-other-feature = { $feature ->
    [hole] { $class } is a hole class and not a shaft class
   *[shaft] { $class } is a shaft class and not a hole class
}
limits-other-case = { $feature ->
    [hole] { $class } is a hole class and table { $table } does not have it; the shaft class is { $other }
   *[shaft] { $class } is a shaft class and table { $table } does not have it; the hole class is { $other }
}
limits-unknown-class = { $class } is not in table { $table }; it has { $known }
limits-no-own-table = { $class } is not an ISO 286 tolerance class: write letters and a grade, such as H7 or js13, or choose own tables with a column { $class }
limits-no-own-column = { $class } is not an ISO 286 tolerance class, and table { $table } has no column { $class }: it has { $known }
limits-beyond-last-range = nominal size { $nominal } mm is beyond table { $table }, whose last range is over { $over } up to and including { $to } mm
limits-not-defined = { $class } is not defined over { $over } up to { $to } mm in table { $table }; { $where }
limits-defined-nowhere = it is not defined at any size
limits-defined = it is defined { $ranges }
limits-range = over { $over } up to { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = the limits of { $nominal } mm are too large

## Zones out of all proportion
zone-micrometres = a zone of { $width } mm is out of all proportion to { $nominal } mm, whose IT 18 is { $widest } mm: if the deviations are in micrometres, write { $offer }
zone-wide = a zone of { $width } mm is out of all proportion to { $nominal } mm, whose IT 18 is { $widest } mm: check nominal size and limits
zone-micrometres-to-zero = minimum limit { $minimum } mm is not above 0: if the deviations are in micrometres, write { $offer }
zone-to-zero = minimum limit { $minimum } mm is not above 0: check nominal size and limits
zone-coordinate-micrometres = a zone of { $width } mm is wider than { $widest } mm, the maximum for a coordinate: if the deviations are in micrometres, write { $offer }
zone-coordinate = a zone of { $width } mm is wider than { $widest } mm, the maximum for a coordinate: check the limits

shape-no-ranges = the table has no size range
shape-not-ascending = size range up to { $end } mm does not end above the one before it, { $before } mm
shape-cells = column { $class } has { $cells } cells for { $ranges } size ranges
shape-twice = column { $class } occurs twice

## Verdicts
status-good = GOOD
status-accepted = ACCEPTED
status-rework = REWORK
status-re-measure = RE-MEASURE
status-out-of-limits = OUT OF LIMITS
status-scrap = SCRAP
rule-simple = no guard band, limits belong to the zone
rule-iso14253-2017 = ISO 14253-1:2017, 95 % conformity, { $prover ->
    [customer] the customer proves nonconformity
   *[supplier] the supplier proves conformity
    }; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, guard band U, { $prover ->
    [customer] the customer proves nonconformity
   *[supplier] the supplier proves conformity
    }; { $u }
rule-ilac-g8 = ILAC-G8, guard band { $factor } U, { $prover ->
    [customer] the customer proves nonconformity
   *[supplier] the supplier proves conformity
    }; { $u }
rule-asme-simple = ASME B89.7.3.1, simple acceptance 4:1; { $u }
rule-asme-stringent = ASME B89.7.3.1, stringent acceptance, guard band { $factor } U; { $u }
rule-asme-relaxed = ASME B89.7.3.1, relaxed acceptance by { $factor } U; { $u }
rule-fixed = guard band { $width } µm, { $prover ->
    [customer] the customer proves nonconformity
   *[supplier] the supplier proves conformity
    }
rule-no-uncertainty = rule { $rule } needs the uncertainty of the measured value
rule-no-factor = rule { $rule } has no factor
rule-no-width = rule { $rule } computes its guard band from the uncertainty
rule-width-missing = rule { $rule } needs a guard band above 0 µm
rule-no-prover = rule { $rule } does not depend on the burden of proof
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = an uncertainty must be above 0 µm
uncertainty-factor = coverage factor { $given }: expected a number from 1 to 10, with at most three decimals
uncertainty-by-budget = u of each value by the budget
undecided-contacts = the { $contacts } contacts make the diameter { $times } times less certain than { $contacts } contacts around the full circle, but the given uncertainty only applies up to 3 times: spread the contacts over a longer arc, or give a budget
doubt-times-inch = measured value is 25.4 times the nominal size: was it converted from inch twice?
doubt-inches = measured value is the nominal size divided by 25.4: is it in inch?
doubt-double = measured value is twice the nominal size: was a diameter taken for a radius?
doubt-half = measured value is half the nominal size: is it a radius?
doubt-decimal-sign = measured value is about the nominal size with its decimal sign elsewhere: is it { $meant } mm?
doubt-far = measured value is { $distance } mm outside the limits: is it this part, in millimetres?
doubt-implausible = measured value is outside what the plan says can be, { $lower } to { $upper } mm: are unit and decimal sign right?

## Files
file-is-folder = this is a folder, not a file: { $path }
file-missing = no such file or folder: { $path }
file-exists = a file or folder of this name already exists: { $path }
file-half-set = writing a set of files stopped in the middle, so some files of the folder are old and some are new: write the set again to finish it; what is still to be moved is in { $path }
file-not-a-file = this is a pipe or a device, not a file: { $path }
file-changed = the file changed while it was read; read it again: { $path }
file-busy = the file is open in another program: close it there and try again: { $path }
file-stopped = stopped: nothing was written: { $path }
file-too-large = the file is larger than { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-grade-missing = { $class } is not an ISO 286 tolerance class: write letters and a grade, such as H7 or js13
iso286-no-grade = { $class } is not an ISO 286 tolerance class: the grades are { $grades }
iso286-no-letter = { $class } is not an ISO 286 tolerance class: letter { $letters } does not exist, only { $known }
iso286-too-large = nominal size { $nominal } mm is beyond ISO 286, which ends at 3150 mm
iso286-not-here = { $class } is not defined at { $nominal } mm in ISO 286; { $where }
iso286-js-rounded = JS rounded as in 1988
iso286-contested-ef = contested: ef is 28 µm here, other sources have 25 µm
iso286-older-it5 = for trial use; older catalogues have a smaller IT5 here
iso286-trial-use = for trial use

## Fits
fit-kind-clearance = clearance fit
fit-kind-transition = transition fit
fit-kind-interference = interference fit
fit-basis-hole = hole basis
fit-basis-shaft = shaft basis
fit-basis-both = hole and shaft basis
fit-preferred-hole-basis = preferred fit of the hole basis
fit-preferred-shaft-basis = preferred fit of the shaft basis
fit-function-loose-running = loose running
fit-function-free-running = free running
fit-function-close-running = close running
fit-function-sliding = sliding
fit-function-locational-clearance = locational clearance
fit-function-locational-transition = locational transition
fit-function-locational-transition-tighter = locational transition, tighter
fit-function-locational-interference = locational interference
fit-function-medium-drive = medium drive
fit-function-force = force
fit-one-sided = { $callout } is not a fit: write a size, a hole class and a shaft class, such as 25 H7/g6
fit-not-a-hole = { $minimum } to { $maximum } mm are the limits of a shaft: expected those of a hole
fit-not-a-shaft = { $minimum } to { $maximum } mm are the limits of a hole: expected those of a shaft
fit-nominal-sizes = a fit has one nominal size: the hole has { $hole } mm, the shaft { $shaft } mm
fit-too-large = the clearance is too large
fit-search-order = smallest clearance { $minimum } mm is above largest clearance { $maximum } mm
fit-search-no-classes = the tables have no classes for both hole and shaft at { $nominal } mm
fit-thermal-too-fine = { $text } has more than three decimals
fit-thermal-temperature = a temperature of { $text } °C is out of range: from -273.15 to 1000 °C
fit-thermal-expansion = an expansion of { $text } is out of range: from -20 to 500, in millionths per kelvin, such as 11.5 for steel
fit-thermal-expansion-unit = an expansion of { $text } is in another unit: expansions are in millionths per kelvin; write { $meant }

## Temperatures that are doubted
thermal-doubt-fahrenheit = { $given } °C is far from any temperature at which parts are measured: if it is in degrees Fahrenheit, write { $meant }
thermal-doubt-kelvin = { $given } °C is far from any temperature at which parts are measured: if it is in kelvin, write { $meant }
thermal-doubt-far = { $given } °C is far from any temperature at which parts are measured, { $least } to { $most } °C: check it
thermal-doubt-beyond = { $given } °C is outside { $least } to { $most } °C, where an expansion of { $expansion } millionths per kelvin applies: give the expansion for this temperature

## Materials
material-published = published value
material-verify = usual value, to be verified
material-own = own value
material-toml = { $reason }
material-version = materials file version { $found } is not supported: expected version { $known }
material-too-many = { $count } materials are too many: at most { $most }
material-too-large = a materials file has at most { $most } bytes
material-name = a material's name has 1 to { $longest } characters and no control characters
material-range = a range of temperatures begins with the lower one: write two numbers in °C, such as [-50, 200]
material-elastic = modulus and poisson must be given together: modulus from 1 to 1200000 MPa, poisson from 0 to 0.5, yield from 1 to 10000 MPa
material-twice = material { $name } is defined twice
material-unknown = unknown material { $name }: choose one of { $known }, or give the expansion itself, such as 11.5
## Callouts: deviations, limits, fits and general tolerances
callout-at = { $reason } (character { $at })
callout-no-tolerance = a tolerance is missing, such as H7, h7, H7/g6, m, +0.1 -0.2 or ±0.1
callout-general-capital = { $capital } has no grade: write { $offer } for the general tolerance of ISO 2768-1, or add a grade, such as { $capital }7
callout-fit-order = the shaft comes before the hole: write { $offer }
callout-fit-side = { $first } and { $second } are not a hole and a shaft: a fit is written with capital letters, then small letters, such as 25 H7/g6
callout-number = { $part }: { $error }
callout-not-a = { $found } is not a { $part }: { $how }
callout-missing = the { $part } is missing: { $how }
callout-part-deviation = deviation
callout-part-limit = limit of size
callout-part-actual = value after @
callout-how-deviation = write a sign and a number, such as +0.1 or -0.1
callout-how-limit = write two sizes, the larger first, such as 12.01/11.985
callout-how-actual = write a number, such as 10H7@10.004
callout-no-sign = { $number } has no sign: write +{ $number } or -{ $number } for a deviation, without a space in the number
callout-no-unit = { $number } has no unit and the other deviation is in µm: write the unit after both
callout-deviation-order = the lower deviation comes before the upper one: write { $offer }
callout-limits-order = the smaller limit comes before the larger one: write { $offer }
callout-limits-apart = { $larger } mm is more than twice { $smaller } mm, so these are probably not limits: write deviations, such as 12 +0.2 0
callout-limits-or-deviation = this is ambiguous: write { $limits } for limits of size or { $deviation } for a lower deviation
callout-limits-meant = such a deviation would leave no size: write { $limits } for limits of size
callout-minimum-not-positive = minimum limit { $minimum } mm is not above 0
callout-micrometres-meant = minimum limit { $minimum } mm is not above 0: if the deviations are in micrometres, write { $offer }
callout-mixed-decimals = { $number } has a different decimal sign than the number before it: use one kind
callout-cycle-sign = { $sign } is for the texts of cycles 14xx, not for a callout
callout-not-in-cycle-text = { $found } cannot stand in a text of cycles 14xx: write a class, a general class or deviations
callout-too-much = { $found } is not expected here: the text is complete without it
callout-too-long = the text is too long: at most { $most } characters
callout-band-order = the lower deviation comes before the upper one: write QS400 as 0.4-0.1
callout-lone-order = the lower deviation comes before the upper one: write { $offer }
callout-inch = { $given } is { $nominal } mm: callouts are in millimetres, write { $offer }
callout-inch-size = { $given } is { $nominal } mm: write size and tolerance in millimetres
callout-inch-somewhere = { $given } is in inches: write size and tolerance in millimetres, with 25.4 mm for 1 in
callout-thread = { $given } is a thread, not a plain hole or shaft: write its minor or pitch diameter with both limits, such as 5.153/4.917
callout-exact = a theoretically exact size has no tolerance of its own: write the size with the limits that apply to it, such as 25 ±0.1
callout-reference = a size in brackets is for reference only and has no tolerance: write it without brackets if it is to be judged
callout-one-sided = { $given } has one limit only: write both limits of size, the larger first, such as 8.2/8
callout-roughness = { $given } is a surface roughness, not a size: write a size with its tolerance, such as 25 H7
callout-modifier = { $given } is not a modifier of ISO 14405-1: the modifiers are { $known }
callout-grade = { $given } is not defined at { $nominal } mm: write a grade from IT1 to IT18 that ISO 286 has there
callout-ansi = { $class } is a class of ANSI B4.1, whose tables Fitcheck does not have: write a class of ISO 286, or size and deviations in millimetres
callout-stated-micrometres = the deviations behind the tolerance are out of all proportion to { $nominal } mm: if they are in micrometres, write ({ $offer })
callout-stated-of-fit = deviations behind a fit may belong to either part: write them behind each class on its own
iso286-grade-alone = { $class } is a grade: it says how wide a zone is, but not where it lies; write ±{ $grade }/2 or a class, such as H7
general-too-small = nominal size { $nominal } mm is below { $first } mm, where ISO 2768-1 begins: write the deviations next to the size
general-too-large = nominal size { $nominal } mm is beyond ISO 2768-1, which ends at { $last } mm
general-not-defined = ISO 2768-1 does not define class { $class } { $range }; it is defined { $defined }
general-range-from = from { $over } up to { $to } mm

## Tables made of the standard
make-no-class = no tolerance class is given: name one or more, such as H7 H8 JS9
make-both-features = { $hole } and { $shaft } cannot be in one table: only the case of their letters differs, so make one table for holes and one for shafts
make-last-size = the last size is { $to } mm: it must be above 0 and at most 3150 mm

## Press fits
press-no-interference = the fit has a clearance of at least { $clearance } mm: a press fit needs an interference, such as 40 H7/s6
press-length = length { $length } mm is not above 0
press-hub-outer = outer diameter of the hub { $given } mm is not above the diameter of the joint, { $nominal } mm
press-shaft-bore = bore of the shaft { $given } mm: write 0 for a solid shaft, or a bore below { $nominal } mm
press-roughness = roughness { $given } mm is below 0
press-friction = a press fit needs a friction above 0
press-material = the modulus of elasticity of { $name } is not known: choose another material, or add modulus and poisson to a file of your own materials
press-ratio = { $text } is not a number from 0 to 1 with at most three decimals
press-yields = NOT ELASTIC: the stress of the { $part ->
    [hole] hub
   *[shaft] shaft
    } would be { $stress } MPa, above its yield strength of { $limit } MPa: elastic theory does not apply, and nothing is said to hold
press-yield-unknown = whether the { $part ->
    [hole] hub
   *[shaft] shaft
    } yields is not known: its material has no yield strength here; give one
press-may-be-loose = the parts may have a clearance of { $clearance } mm: the joint may not hold at all
press-all-smoothed = smoothing of the roughness, { $loss } mm, may use up the interference: the joint may not hold at all
press-no-roughness = no roughness Rz was given: no loss of interference by smoothing is subtracted
press-too-hot = heating the hub alone is not enough up to { $most } °C, where its expansion is known
press-too-cold = cooling the shaft alone is not enough, even in liquid nitrogen
press-contraction-unknown = the contraction of the shaft's material in the cold is not known: its expansion is used, so the shaft may have to be colder
