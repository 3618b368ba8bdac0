# exchange

# Measurements from files
exchange-format-logs = HEIDENHAIN measuring logs such as TCHPR421.TXT
exchange-format-log-444 = logs of probing in 3-D as written by Fitcheck
exchange-format-fn16 = FN 16 output of a control, read through its mask (--mask)
exchange-format-series-table = table of a control that a program fills with FN 27, a row for each part
exchange-format-contacts = contacts of one circle: x, y and optionally z
exchange-format-measurements = measurements as CSV: id, callout, measured
exchange-empty = the file is empty
exchange-not-recognised = not a file of a known format
exchange-model-not-read = a { $format } model: Fitcheck reads no models; export the measured values as CSV, XLSX, QIF or AQDEF
exchange-drawing-not-read = a { $format } drawing: Fitcheck reads no drawings; export the sizes as CSV or XLSX
exchange-document-not-read = a { $format } document: Fitcheck reads no documents; export the values as CSV, XLSX, QIF or AQDEF
exchange-image-not-read = a { $format } image: Fitcheck reads no images; export the values as CSV, XLSX, QIF or AQDEF
exchange-archive-not-read = a { $format } archive: unpack it and give the files in it
exchange-no-sheet = the workbook has no sheet { $given }; it has { $sheets }
exchange-other-format = these are { $format }, not measurements as CSV
exchange-parquet-unknown = this program was built without Parquet: cargo build --release without further options includes it
exchange-parquet-stream = Parquet lists its columns at the end of the file and cannot be read from a pipe: give the name of the file
exchange-parquet = this Parquet file cannot be read: { $reason }
exchange-parquet-nested = column { $column } contains columns or lists: only columns of single values can be judged
exchange-mask-backwards = { $mask }: { $reason }
exchange-mask-none = none of the given masks prints such a file: { $masks }
exchange-mask-several = several masks print such a file; give only the one that wrote it: { $masks }
exchange-mask-no-measured = { $mask } prints no measured value: Fitcheck recognises Q153 to Q156, Q160, and any other number with its callout printed beside it
exchange-mask-measured = { $mask }: any of these could be the measured value: { $fields }; print the result of the cycle, such as Q153; otherwise the file needs callouts with different limits
exchange-print-ambiguous = the mask can read this in several ways
exchange-print-broken = the record ends too early: expected the output of line { $line } of the mask
exchange-print-other = the mask prints no such line, but it has figures: it may be a record with a missing or changed value; correct it or remove it
exchange-print-unit = line { $line } states { $unit }, but the output of a control is read in mm: print the values in mm
exchange-table-no-part = no column says which part a row is of: a table of a series needs a column such as PART or SERIAL
exchange-table-no-values = no column holds measured values
exchange-table-no-value = it is not clear which column of { $name } is the measured value
exchange-table-touches = the cell in column { $column } touches its neighbour, so either may be split in the wrong place: separate them by a blank
exchange-table-unit = the table is in inch and column { $column } is not of type LENGTH, so its values could be in mm: use the type LENGTH
exchange-no-rows = no row holds a measurement
exchange-no-measured-column = no column of measured values: name it in the first line, such as id;callout;measured
exchange-several-columns = columns { $columns } may each be { $role }: choose one with import --columns, such as { $word }=3, or name the columns in the first line so that only one fits, such as id;callout;measured
exchange-role-id = the name
exchange-role-tolerance = the callout
exchange-role-nominal = the nominal size
exchange-role-measured = the measured value
exchange-role-time = the time
exchange-role-simulated = whether it is simulated
exchange-role-number = the number
exchange-role-part = the part
exchange-role-serial = the serial number
exchange-role-who = the operator
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = what was measured
exchange-role-upper = the upper deviation
exchange-role-lower = the lower deviation
exchange-role-minus = the lower deviation without its minus
exchange-role-maximum = the upper limit
exchange-role-minimum = the lower limit
exchange-role-kind = hole or shaft
exchange-role-units = the unit
exchange-role-status = the status
exchange-role-machine = the machine
exchange-role-batch = the batch
exchange-role-sample = a sample
exchange-no-column = { $role } should be in column { $given }, but the file has { $columns }
exchange-column-twice = column { $column } cannot be both { $first } and { $second }
exchange-unit = unknown unit { $unit }: use mm, µm or inch
exchange-limit = limit: { $reason }
exchange-tolerance-unsigned = the tolerance { $given } has no sign: write ±{ $given }, or both deviations, such as +0.02 0
exchange-minus-again = the lower deviation { $given } has a minus, but the others have none: write all of them with their signs
exchange-limits-contradict = { $callout } has the limits { $minimum } to { $maximum }, but the columns say { $given }: to judge by the callout, give --columns { $columns }; to judge by the columns, give --columns callout=-
exchange-limits-or-deviations = columns { $columns } may be limits or deviations from the nominal size: choose with --columns, such as maximum={ $upper },minimum={ $lower } or upper={ $upper },lower={ $lower }
exchange-limits-or-readings = columns { $columns } may be limits, or the largest and the smallest of several readings: choose with --columns, such as maximum={ $upper },minimum={ $lower } for limits or maximum=-,minimum=- for readings
exchange-minus-or-plus = the lower deviations in column { $columns } have no sign: choose with --columns, minus={ $lower } for below the nominal size or lower={ $lower } for above it
exchange-samples-side-by-side = several measured values stand side by side in columns { $columns }: read them with fitcheck import, or choose one with --columns, such as measured={ $first }
exchange-unit-stated = line { $line } states the unit { $unit }, which is not supported (“{ $text }”): use mm, µm or inch, or choose the unit of sizes (--columns unit=mm)
exchange-unit-mentioned = line { $line } mentions { $unit } (“{ $text }”), but nothing says whether the values are in this unit: choose the unit of sizes (--columns unit=mm, um or inch)
exchange-units-differ = “{ $at }” says { $unit }, “{ $other-at }” says { $other }: correct one of them
exchange-unit-late = line { $line } states { $unit } (“{ $text }”), but the rows above it are read in { $read }: state the unit above the first row, or correct that line
exchange-unit-stray = this line states { $unit } (“{ $text }”), but all other rows are read in { $read }: state the unit above the first row, or correct this line
exchange-unit-given = the unit chosen is { $given }, but the file says { $unit } (“{ $text }”): choose { $unit }, or correct the file
exchange-unit-half = column { $column } is in inch, and column { $open } does not say its unit: write it beside both names, or choose the unit of sizes (--columns unit=inch)
exchange-unit-missing = the unit of this row is missing: write mm, µm or inch, or choose the unit of sizes (--columns unit=mm)
exchange-callout-unit = { $given }: the row is in inch, and a callout with a size or deviations is in mm: put the nominal size in a column of its own beside the class
exchange-row-short = expected { $expected } cells, found { $found }
exchange-row-long = expected { $expected } cells, found { $found }: is the separator also used as decimal sign or within a text?
exchange-row-too-long = the row is longer than { $most } KiB
exchange-open-quote = a quotation mark is not closed on this line
exchange-header-hides-rows = line { $line }: the header runs over several lines, and one of them looks like a row: close the quotation marks on the line where they open
exchange-within-quotes = this line may be a row or a remark: quotation marks open above it and close here or below; close them on the line where they open
exchange-callout = callout: { $reason }
exchange-nominal = nominal size: { $reason }
exchange-nominal-differs = callout { $callout } does not match nominal size { $nominal } in its own column
exchange-measured = measured: { $reason }
exchange-simulated = simulated: { $given } is neither true nor false
exchange-other-header = this line names different columns from the first one: judge the rows below it as a separate file
exchange-below-other-header = not judged: line { $line } names different columns. Judge the rows below it as a separate file
exchange-simulated-below = the rows below this line are simulated: judge them as a separate file, or with fitcheck import
exchange-origin = origin: { $given } says neither measured nor simulated; write measured, typed or simulated, or set simulated=- if this column says something else
exchange-decimal-sign = measured: { $given } has a different decimal sign than the other values: "{ $sign }"
exchange-not-positive = measured: a diameter of { $given } is not above 0
exchange-decimal-comma = { $joined } may be one number with a decimal comma: use a decimal point or another separator
exchange-other-feature = { $given } is { $feature ->
        [hole] a shaft, and these are the holes: are the files swapped?
       *[shaft] a hole, and these are the shafts: are the files swapped?
    }
exchange-rejected = the file itself rejects this value ({ $given }): remove the row, or correct it in the file
exchange-no-part = { $given } names a figure of several parts or a setting standard of a gauge, not a part: remove the row, or give the part another name
exchange-other-log = { $feature ->
        [hole] this is the log of a shaft, and these are the holes: are the files swapped?
       *[shaft] this is the log of a hole, and these are the shafts: are the files swapped?
    }
exchange-not-a-size = { $what }: this is not a size that can be paired
exchange-no-place-axis = it lies along { $axis }, but cycles 421 and 422 probe along Z
exchange-no-place-no-axis = the file does not say along which axis it lies
exchange-no-place-kind = { $kind }: cycles 421 and 422 probe only circles and cylinders
exchange-no-place-system = it is checked in coordinate system { $system }, but the coordinates refer to that of the file
exchange-contacts-not-sizes = rows of two or three numbers are contacts: name the columns in the first line, such as id;measured
exchange-too-many-rows = only the first { $most } rows were read: split the file
exchange-unjudged-no-callout = not judged: no callout given
exchange-unjudged-no-limits = not judged: the log's limits of size are 0, so the diameter was not monitored
exchange-unjudged-coordinate = a coordinate of cycle { $cycle }, not a hole or shaft
exchange-unjudged-coordinate-without-limits = not judged: the log's limits are 0, so the coordinate was not monitored
exchange-unjudged-size = { $what } of cycle { $cycle }, not a hole or shaft
exchange-unjudged-size-without-limits = not judged: the log's limits are 0, so the { $what } was not monitored
exchange-unjudged-point = a surface point of cycle { $cycle }: its deviation along the normal is not a size
exchange-unjudged-point-without-tolerance = not judged: the point was probed without a tolerance
exchange-unjudged-contacts = not judged: { $count } contacts without a callout
exchange-warning-ignored-columns = columns skipped: { $columns }
exchange-warning-quantity-unknown = column { $column } has no known word for what was measured ({ $words }): all its values are read as sizes; if that is right, give import --columns quantity=-
exchange-warning-not-used = skipped, not a measurement: { $text }
exchange-warning-minus-supplied = column { $column } has no minus signs: its values are read as lower deviations below the nominal size
exchange-warning-callouts-unnamed = column { $column } looks as if it held the callouts, but its name is not known: name it callout, or give its number with --columns, such as callout=2
exchange-warning-limits-read = columns { $columns } are read as limits
exchange-warning-head-read = read for all values: { $said }
exchange-warning-samples-read = columns { $columns } hold parts side by side, one part each: values are judged one by one, empty cells are skipped, and columns without serial numbers count as separate parts
exchange-warning-comment = a line that begins with # is a comment, but this one holds a measurement
exchange-warning-several-lines = the row runs over { $lines } lines within quotation marks
exchange-warning-time = { $given } is not a date and time: the time of import is used
exchange-warning-place = { $given } is not a length: the location is skipped
exchange-warning-no-time = no date and time here: the time of import is used
exchange-warning-offset = { $given } is stored as local time without its offset from UTC
exchange-warning-cut-off = the file ends here without a line end, and { $given } has fewer decimals than the other values: it may be cut off
exchange-warning-open-end = the file ends here without a line end: its last value, { $given }, may be cut off

# Contacts
contacts-file-empty = the file holds no contacts
contacts-no-columns = the header must name x and y, and may name z; it is { $given }
contacts-twice = columns { $first } and { $second } are both { $name }
contacts-cells = expected { $wanted } cells, found { $cells }: { $given }
contacts-not-a-number = { $name } is { $given }, not a number of millimetres
contacts-row-too-long = the row is longer than { $most } KiB
contacts-comment = a line that begins with # is a comment, but this one holds coordinates: remove the #, or the whole line
contacts-other-unit = contacts are in mm, but this line states { $given }: convert them to mm
contacts-too-many = the file has more than { $most } contacts
contacts-simulated = these contacts are simulated and measure nothing: use a workpiece file instead
contacts-origin = { $given } says neither measured nor simulated: write measured or simulated, or remove the column
contacts-open-quote = a quotation mark is not closed
contacts-mixed-signs = { $given } has a different decimal sign than the rows before it

## Tables of deviations
table-format-name = { $name } does not begin with a letter: table names on a TNC7 must
table-format-operator = { $name } contains { $sign }: table names on a TNC7 cannot have arithmetic operators
table-format-warning-lower-sign = the PC-DMIS manual shows no lower deviation other than 0: check { $class } in PC-DMIS before you rely on it, especially its signs
table-format-csv = the CSV cannot be written: { $reason }
table-format-parquet-unknown = this program was built without Parquet: cargo build --release without further options includes it
table-format-parquet = the Parquet file cannot be written: { $reason }
table-format-itnc530 = control table for iTNC 530
table-format-tnc640 = control table for TNC 620 and TNC 640
table-format-tnc7 = control table for TNC7
table-format-plain-csv = CSV, a line for every class and size range
table-format-plain-parquet = Parquet, a row for each class and size range
table-format-pcdmis = CSV of ISO tolerances for PC-DMIS

## Limits as SQL
sql-border = table { $table }: a size range ends at { $end } mm; as SQL, ranges must end at whole millimetres
sql-too-far = table { $table }: a size range ends at { $end } mm; as SQL, ranges must end by { $most } mm
sql-twice = class { $class } is named twice
exchange-correction = the value at 20 °C does not follow from the measured value and its temperatures: expected the columns as Fitcheck writes them
exchange-warning-corrected = values with an entry in the column as_measured_mm are already at 20 °C
sizes-warning-named-twice = { $rows ->
        [one] a row has the name of an earlier row
       *[other] { $rows } rows have the name of an earlier row
    }, such as { $id } on lines { $first } and { $second }: each row counts as a part
sizes-warning-simulated-rows = { $count ->
        [one] 1 row is simulated
       *[other] { $count } rows are simulated
    }: nothing was measured
exchange-position-out = the centre was out of position, but the file has only the size
exchange-undecided = nothing was decided here: { $given }
exchange-warning-other-rule = the verdicts in this file may come from another decision rule (column rule_name): its values are judged again
exchange-read = the rest of the file cannot be read: { $reason }
exchange-too-large = larger than { $most } MiB, the limit for files of this format
exchange-unjudged-one-limit = not judged: one of the two limits is missing
exchange-unjudged-no-tolerance = not judged: no limits given
exchange-unjudged-rounded = not judged: the printed figures stand for any value from { $from } to { $to }, and a limit lies between them: print more decimals
exchange-unjudged-implausible = not judged: { $measured } mm cannot be: the plan says { $lower } to { $upper } mm; check unit and decimal sign, or measure again
exchange-unjudged-swapped-limits = not judged: the lower limit { $minimum } is above the upper limit { $maximum }
exchange-unjudged-not-a-size = { $what }: not a size of a hole or shaft
exchange-warning-limits-differ = { $callout } has the limits { $minimum } to { $maximum }, but the file has others: the file's limits apply
exchange-warning-class-unknown = class { $given } has no limits here: the file's limits apply
exchange-warning-status-differs = the file says { $given }, but the limits say { $status }
exchange-warning-status-unknown = the file says { $given }, which is not a known status: the limits say { $status }
exchange-warning-limit-differs = the file says { $given }, but the limits are { $minimum } to { $maximum }
exchange-warning-deviation-differs = the file says { $given }, but that is not the deviation of { $measured } from { $nominal }
exchange-warning-feature-differs = the file says { $given }, but the limits are those of { $feature ->
        [hole] a hole
       *[shaft] a shaft
    }
exchange-warning-temperature-differs = the file says { $given }, but the value counts as measured at { $counted } °C: give --temperature and --material
exchange-warning-speaks-of-temperature = the file mentions a temperature other than { $counted } °C, at which its values count as measured: { $text }
exchange-warning-speaks-of-unit = a remark states a different unit from that of the values: { $text }
exchange-warning-speaks-of-simulation = this line mentions a simulation: check whether the value was measured: { $text }
exchange-warning-all-nominal = all { $count } values are exactly their nominal sizes: this may be a list of sizes that nobody measured
exchange-warning-name-of-no-size = { $given } is not the name of a size of one part, but the value was judged as one
exchange-warning-other-values = columns with other sizes near the measured ones are not judged: { $columns }
exchange-warning-part-rejected = the file says { $given } about the whole part
exchange-warning-uncertainty-not-used = the file states an expanded uncertainty of { $expanded } mm: no rule uses it, so give --u instead
exchange-warning-plan-differs = the file has the limits { $minimum } to { $maximum }: the plan's limits apply
exchange-warning-plan-differs-below = the file has the lower limit { $minimum }: the plan's lower limit applies
exchange-warning-above-own-limit = not of the plan, and above the upper limit of its file, { $maximum }
exchange-warning-below-own-limit = not of the plan, and below the lower limit of its file, { $minimum }
exchange-warning-plan-differs-above = the file has the upper limit { $maximum }: the plan's upper limit applies
exchange-warning-plan-differs-nominal = the file has the nominal size { $nominal }: the plan's nominal size applies
exchange-warning-part-differs = the file names part { $given }: it is judged as { $part }, the plan's part
exchange-warning-found-by-number-of = no feature of the plan is called { $given }; matched by number to { $name } of the plan
exchange-warning-found-by-place-of = no feature of the plan is called { $given }; matched by location to { $name } of the plan
exchange-warning-found-by-number = matched by number to { $name } of the plan
exchange-warning-found-by-place = matched by location to { $name } of the plan
exchange-format-aqdef = Q-DAS AQDEF, in one file or as .dfd and .dfx
exchange-format-calypso = CALYPSO tables of characteristics such as NAME_chr.txt
exchange-format-calypso-text = CALYPSO printed reports saved as text
exchange-format-geopak = MCOSMOS (GEOPAK) tolerances in a file without column names
exchange-format-gauge = lines of gauges saved in a file, such as 01A+025.012
exchange-format-pcdmis = PC-DMIS text reports
exchange-format-probed = printouts of probing macros, as Renishaw and CAM systems write them
exchange-warning-unit-assumed = no unit given: lengths without a unit are read as mm
exchange-warning-unit-read = lengths are read in { $unit }, as the file states: { $text }
exchange-warning-rounded = { $given } has digits beyond the nanometre: it is rounded to the nearest nanometre
exchange-warning-rounded-values = { $count ->
        [one] 1 measured value has digits beyond the nanometre, from this line on: it is rounded to the nearest nanometre
       *[other] { $count } measured values have digits beyond the nanometre, from this line on: they are rounded to the nearest nanometre
    }
exchange-unjudged-quantity = { $quantity ->
        [102] roundness (K2009 is 102)
        [109] position (K2009 is 109)
        [117] a coordinate (K2009 is 117)
       *[other] a quantity other than a diameter (K2009 is { $quantity })
    }: not a size of a hole or shaft
exchange-unjudged-kind = not measured: { $kind ->
        [1] a count of nonconforming parts (K2004 is 1)
        [5] an error log sheet (K2004 is 5)
        [6] an error log sheet (K2004 is 6)
       *[other] an unknown kind of characteristic (K2004 is { $kind })
    }
exchange-unjudged-attribute = not judged: marked with { $given } (K0002); only 0 is known to mark a valid value
exchange-unjudged-not-valid = not judged: the file says { $said }, so there may be no valid value
exchange-unjudged-declaration = not judged: line { $declaration } of its declaration cannot be used
exchange-format-qif = QIF 2.0, 2.1, 3.0: results of measuring software, and plans
exchange-xml = not well-formed XML: { $reason }
exchange-xml-doctype = a DOCTYPE is not supported: remove it, or export the file without it
exchange-xml-entity = entity { $name } is not known: only &lt; &gt; &amp; &quot; and &apos; are supported
exchange-xml-depth = nesting limit of { $most } elements reached
exchange-xml-long = a tag or text is longer than { $most } KiB
exchange-xml-mixed = { $name } has an element in the middle of its text
exchange-xml-cut-off = the file ends within an element: it may be cut off
exchange-xml-encoding = unknown encoding { $given }: use UTF-8, UTF-16 or ISO 8859-1
exchange-xml-bytes = these bytes are not text in the file's encoding
exchange-qif-unit = unit of length { $unit }: the name is unknown, or does not match the factor; use mm, inch or another unit with its factor to metres
exchange-qif-no-unit = the file has no unit of length: it needs FileUnits with PrimaryUnits and LinearUnit
exchange-qif-reference = { $what } { $id } is not in the file
exchange-qif-too-many = the file has more than { $most } { $what } elements
exchange-qif-no-value = no measured value here; status { $status }
exchange-qif-limit = limits or nominal size: { $reason }
exchange-qif-other-kind = the measurement is of kind { $measured }, but its characteristic is of kind { $defined }
exchange-qif-several-values = the measurement has several values
exchange-qif-defined-as-limit = DefinedAsLimit is missing or neither true nor false, so the numbers may be limits or deviations
exchange-qif-no-nominal = the limits are deviations, but there is no nominal size
exchange-qif-zone = class { $class } and { $zone } contradict each other: uppercase letters are holes, lowercase letters are shafts
exchange-qif-no-results = a QIF file without measured values: a plan can be read as a part plan
exchange-qif-no-characteristics = the QIF file declares no characteristics
exchange-warning-standard-uncertainty-not-used = the file states a combined standard uncertainty of { $standard } and a mean error of { $mean-error }: no rule uses them, so give --u instead
exchange-warning-sheet-hidden = sheet { $sheet } is read, although it is hidden in the workbook
exchange-warning-rows-hidden = { $count ->
    [one] row { $rows } is hidden or filtered out in the workbook, but is read like the others
   *[other] { $count } rows are hidden or filtered out in the workbook, but are read like the others: { $rows }
}
exchange-warning-columns-hidden = hidden columns are read like the others: { $columns }
exchange-warning-qif-version = QIF version { $version }: this program is made for versions 2.0, 2.1 and 3.0
exchange-warning-qif-count = { $list } says n={ $said }, but has { $found }: something may be missing or added
exchange-warning-qif-twice = id { $id } occurs twice: the first element is used
exchange-format-xlsx = measurements in a spreadsheet workbook: columns as in CSV
exchange-workbook = this workbook cannot be read: { $reason }
exchange-not-a-workbook = a ZIP file, but not a workbook: unpack it and give the files in it
exchange-old-workbook = a workbook in { $format } format, which is not supported: save it as XLSX
exchange-workbook-password = the workbook has a password: save it without one
exchange-zip-cut-off = the end of the workbook is missing: it may be cut off
exchange-zip-members = the workbook's list of members is damaged or has more than { $most } entries
exchange-zip-bomb = { $member } unpacks to more than { $most } MiB, or is compressed too densely for a workbook: it is not read
exchange-zip-twice = two members of the workbook have the same name, so it has been changed: open it in a spreadsheet program and save it
exchange-zip-texts = the workbook has more than { $most } different texts
exchange-sheet-wide = cell { $cell } is beyond the first { $most } columns
exchange-too-many-cells = the sheet has more than { $most } cells
exchange-cell = { $cell }: { $reason }
exchange-formula-without-value = the value of the formula ={ $formula } is not stored: open the workbook in a spreadsheet program and save it
exchange-cell-split = the value of the cell is not stored as one plain text, so only a part of it could be read: open the workbook in a spreadsheet program and save it
exchange-cell-error = the cell shows { $error }
exchange-warning-sheets-left = sheet { $sheet } is read; other sheets are not: { $left }
gauge-frame = the characters that frame the line were skipped
gauge-channel = from channel { $channel }
gauge-inches = { $given } inches
gauge-error-text = { $given } may be an error number of the gauge: if it is a size, write it with its unit, { $given } mm
gauge-opinion = the gauge says { $sign }; the plan's limits decide
gauge-no-unit = { $given } names no unit: say in the settings of the gauge whether it sends millimetres or inches
exchange-gauge-unit = line { $line } of these gauge lines, { $given }, says neither mm nor inch: give the unit with import --columns unit=mm or --columns unit=inch
gauge-other-form = { $given } differs from the line that the gauge was taught with, { $example }, in more than its digits
gauge-other-decimals = { $given } has { $decimals ->
        [one] 1 decimal
       *[other] { $decimals } decimals
    }, and the line that the gauge was taught with has { $taught }: the gauge sends another unit, or a part of the number was lost

teach-zero = 0 could be every zero of the line: teach the gauge with a line of another value
teach-not-text = { $line } has characters that are no text
teach-nowhere = { $value } mm does not stand in the line { $line }: type the value that the gauge showed for it
teach-twice = { $value } mm stands more than once in the line { $line }: teach the gauge with a line of another value
teach-other-unit = the line says { $given }, which is not { $value } mm: type the value that the gauge showed, in millimetres

mapping-no-value = { $given } assigns no column: write a word, = and a column, such as measured=3
mapping-word = { $given } is not a known column content: allowed are { $allowed }
mapping-value = { $word }: { $given } is unknown: allowed are { $allowed }
mapping-twice = { $word } is given twice: give it once
mapping-toml = not a mapping of columns: { $reason }

# How a value was judged by a plan, and what was given beside it.
planned-rule = judged by the plan's rule instead of { $given }: { $rule }
planned-uncertainty = judged with the plan's uncertainty instead of the given one: { $u }
planned-material = corrected to 20 °C with the plan's material instead of the given one: { $name }
planned-corrected = corrected from { $temperature } °C to 20 °C (expansion { $expansion } · 10⁻⁶/K)
planned-not-corrected = not corrected to 20 °C: a location on the part is not a size
planned-error-already-corrected = the file says that the value is at 20 °C already: judge it without a temperature
