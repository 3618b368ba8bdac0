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
callout-not-positive = nominal size { $nominal-sign }{ $nominal } mm is not above 0
class-missing = a tolerance class is missing, such as H7 for a hole or h7 for a shaft
class-mixed-case = { $text } mixes upper and lower case: write { $upper } for a hole or { $lower } for a shaft
class-malformed = { $text } is not a tolerance class: write letters and a grade, such as H7 or js13

## Deviations and limits
deviations-order = upper deviation { $upper-sign }{ $upper } mm is below lower deviation { $lower-sign }{ $lower } mm
source-shipped-table = ISO 286 table { $name }, over { $over } up to { $to } mm
source-table = table { $name }, over { $over } up to { $to } mm
source-file = file { $name }
limits-hole-class = { $class } is a hole class and table { $table } does not have it; the shaft class is { $other }
limits-shaft-class = { $class } is a shaft class and table { $table } does not have it; the hole class is { $other }
limits-unknown-class = { $class } is not in table { $table }; it has { $known }
limits-beyond-last-range = nominal size { $nominal } mm is beyond table { $table }, whose last range is over { $over } up to and including { $to } mm
limits-not-defined = { $class } is not defined over { $over } up to { $to } mm in table { $table }; { $where }
limits-defined-nowhere = it is defined nowhere
limits-defined = it is defined { $ranges }
limits-range = over { $over } up to { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = the limits of { $nominal } mm are too large
shape-no-ranges = the table has no size range
shape-not-ascending = size range up to { $end-sign }{ $end } mm does not end above the one before it, { $before-sign }{ $before } mm
shape-cells = column { $class } has { $cells } cells for { $ranges } size ranges
shape-twice = column { $class } occurs twice

## Verdicts
rule-simple = no guard band, limits belong to the zone
doubt-times-inch = measured value is 25.4 times the nominal size: converted from inch once too often?
doubt-inches = measured value is the nominal size over 25.4: is it in inch?
doubt-double = measured value is twice the nominal size: was a diameter taken for a radius?
doubt-half = measured value is half the nominal size: is it a radius?

## Files
file-is-folder = this is a folder, not a file: { $path }
file-missing = no such file or folder: { $path }
file-too-large = the file is larger than { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-no-grade = { $class } is no class of ISO 286: its grades are { $grades }
iso286-no-letter = { $class } is no class of ISO 286: it has no letter { $letters }, only { $known }
iso286-too-large = nominal size { $nominal } mm is beyond ISO 286, which ends at 3150 mm
iso286-not-here = { $class } is not defined at { $nominal } mm in ISO 286; { $where }

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
fit-not-a-hole = { $minimum-sign }{ $minimum } to { $maximum-sign }{ $maximum } mm are a shaft's limits, where a hole's are needed
fit-not-a-shaft = { $minimum-sign }{ $minimum } to { $maximum-sign }{ $maximum } mm are a hole's limits, where a shaft's are needed
fit-nominal-sizes = a fit has one nominal size: the hole has { $hole-sign }{ $hole } mm, the shaft { $shaft-sign }{ $shaft } mm
fit-too-large = the clearance is too large
fit-search-order = smallest clearance { $minimum-sign }{ $minimum } mm is above largest clearance { $maximum-sign }{ $maximum } mm
fit-thermal-too-fine = { $text } has more than three decimals
fit-thermal-temperature = a temperature of { $text } °C is out of range: from -273.15 to 1000 °C
fit-thermal-expansion = an expansion of { $text } is out of range: from -20 to 500, in millionths a kelvin, such as 11.5 for steel

## Materials
material-published = published value
material-verify = usual value, to be verified
material-own = own value
material-toml = line { $line }, column { $column }: { $reason }
material-version = version { $found } of a file of materials is not known, only version { $known }
material-too-many = there are { $count } materials: at most { $most }
material-name = line { $line }: a material's name has 1 to { $longest } characters and no control characters
material-twice = line { $line }: there are two materials called { $name }
material-unknown = no material is called { $name }; there are { $known }, or give the expansion itself, such as 11.5
