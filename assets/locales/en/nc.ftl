# Sets of programs, tables and masks for a control.
## Plans
nc-no-features = the plan has no feature
nc-too-many = the plan has more than { $most } features
nc-too-large = a plan has at most { $most } KiB
nc-no-column = column { $column } is missing
nc-unknown-column = unknown column { $column }: the columns are { $known }
nc-column-twice = column { $column } occurs twice
nc-cells = the row has { $found } cells and the header { $expected }: with a decimal comma, separate the columns with semicolons
nc-no-cell = { $column } is missing
nc-value = { $what }: { $error }
nc-no-class = { $callout } has no tolerance class, such as H7: the programs look up limits by class
nc-fit = { $callout } is a fit: write the hole and the shaft as two features
nc-clearance-height = clearance height { $height } mm is not above the measuring height, { $z } mm
nc-name = name { $name }: letters A to Z, digits and _ are allowed, at most { $most }
nc-same-name = name { $name } occurs twice: file names on a control ignore case
nc-unknown = { $column } { $given } is not known: expected { $known }
nc-not-of = a { $kind } has no { $column }
nc-direction = axis { $given } is not a direction: expected { $known }, or three numbers such as 0.5 0 -1, from -10 to 10 with at most 9 decimals and not all 0
nc-no-band = { $text } is not the band of a point, such as ±0.05 or +0.1/-0.05: { $error }
nc-band-side = a point cannot have deviations from { $lower } to { $upper } mm: the cycle takes an upper one of 0 or more and a lower one of 0 or less, not both 0
nc-side-class = { $callout }: both sides of a { $kind } need classes such as { $example }
nc-not-on-control = a { $kind } is measured by cycle { $cycle }, which an { $control } does not have
nc-face-class = { $callout }: a face is judged as an outside dimension and needs a shaft class, such as h9
nc-face-place = { $callout }: the face is at { $coordinate } mm along the measured axis, which must be its nominal size
## Sets
nc-folder = { $folder } is not a folder for programs: write TNC:\ and then names of letters, digits, _ and -, separated by \
nc-reads-otherwise = { $file } cannot be written so that it reads back the same
nc-proof = the set failed its test run and was not written: { $reason }
nc-proof-no-end = the program does not end
nc-proof-count = { $found } of { $expected } features were measured
nc-proof-other-verdict = { $name }: the verdict differs from Fitcheck's
nc-archive = the zip file cannot be made: { $reason }
nc-workpiece = the workpiece cannot be written: { $reason }
nc-own-column = { $class } is not one of the 47 classes of NC-Solution 8255: { $table } gets an extra column
nc-figure = { $what }
nc-fewer-columns = column limit of an iTNC 530: { $table } has only the plan's classes, { $classes }
nc-moved-nominal = { $name }: the nominal size of { $callout } is outside the limits, which a TNC7 refuses: { $parameter } is { $value } mm, and { $deviation } counts from there
