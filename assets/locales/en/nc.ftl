# Sets of programs, tables and masks for a control.
## Plans
nc-no-features = the plan has no feature
nc-too-many = the plan has more than { $most } features
nc-csv = the CSV cannot be read: { $reason }
nc-no-column = column { $column } is missing
nc-unknown-column = column { $column } is not known; known are { $known }
nc-column-twice = column { $column } occurs twice
nc-cells = the row has { $found } cells and the header { $expected }: with a decimal comma, separate the columns by semicolons
nc-no-cell = { $column } is missing
nc-value = { $what }: { $error }
nc-no-class = { $callout } has no tolerance class: the programs look a class up in a table, such as H7
nc-fit = { $callout } is a fit: write the hole and the shaft as two features
nc-clearance-height = clearance height { $height } mm is not above the measuring height, { $z } mm
nc-name = name { $name }: letters A to Z, digits and _ are allowed, at most { $most }
nc-same-name = name { $name } occurs twice; a control does not tell a from A in file names
## Sets
nc-folder = { $folder } is no folder for programs: write TNC:\, then names of letters, digits, _ and -, apart by \
nc-other-limits = { $table } would not give the limits of { $callout }
nc-reads-otherwise = { $file } cannot be written so that it reads back the same
nc-proof = the set was run and is not given out: { $reason }
nc-proof-no-end = the program does not end
nc-proof-count = { $found } of { $expected } features were measured
nc-proof-other-verdict = { $name }: another verdict than Fitcheck's
nc-archive = the zip file cannot be made: { $reason }
nc-own-column = { $class } is none of the 47 classes of NC-Solution 8255: { $table } has a column more
nc-fewer-columns = an iTNC 530 takes no more columns: { $table } has the plan's classes only, { $classes }
nc-moved-nominal = { $name }: the nominal size of { $callout } is outside the limits, which a TNC7 refuses: Q262 is { $value } mm, and Q163 counts from there
