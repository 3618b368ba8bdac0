# Sets of programs, tables and masks for a control.
## Plans
nc-value = { $what }: { $error }
nc-name = name { $name }: letters A to Z, digits and _ are allowed, at most { $most }
nc-not-on-control = a { $kind } is measured by cycle { $cycle }, which an { $control } does not have
## Sets
nc-folder = { $folder } is not a folder for programs: write TNC:\ and then names of letters, digits, _ and -, separated by \
nc-no-texts = a set with tolerance texts is possible for TNC7 only, not for { $control }
nc-series-name = { $name } cannot name a column of the series table: begin the name with a letter, and do not use NR, PART or STATUS
nc-series-sizes = a series keeps at most { $most } sizes of a part, and the plan has { $sizes }: make several sets
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
nc-by-hand = { $name }: no cycle measures a { $kind }: it is not in the set
nc-not-in-set = { $name }: the plan says { $said }, but the set does not use it: on the control the limits alone decide, so it may say GOOD where fitcheck import does not
nc-features = { $first } (and { $more } more)
nc-moved-nominal = { $name }: the nominal size of { $callout } is outside the limits, which a TNC7 refuses: { $parameter } is { $value } mm, and { $deviation } refers to that
nc-no-place = { $name } needs x, y and z: the program moves there
nc-own-cycle = { $name } has its own cycle or parameters, which the called programs do not support
nc-no-coordinate = { $column } is not given: the program moves there
