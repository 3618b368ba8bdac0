# exchange

# Measurements from files
exchange-format-logs = HEIDENHAIN measuring logs such as TCHPR421.TXT
exchange-format-log-444 = logs of probing in 3-D as written by Fitcheck
exchange-format-contacts = contacts of one circle: x, y and optionally z
exchange-format-measurements = measurements as CSV: id, callout, measured
exchange-empty = the file is empty
exchange-not-recognised = not a file of a known format
exchange-other-format = these are { $format }, not measurements as CSV
exchange-parquet-unknown = this program was built without Parquet: cargo build --release without further options has it
exchange-parquet-stream = Parquet has its columns at its end and cannot be read from a pipe: give the file by its name
exchange-parquet = this Parquet file cannot be read: { $reason }
exchange-parquet-nested = column { $column } has columns or lists in it: only columns of single values can be judged
exchange-no-rows = no row holds a measurement
exchange-no-measured-column = no column of measured values: name it in the first line, such as id;callout;measured
exchange-several-columns = columns { $columns } may each be { $role }: name them in the first line, such as id;callout;measured
exchange-role-id = the name
exchange-role-tolerance = the callout
exchange-role-nominal = the nominal size
exchange-role-measured = the measured value
exchange-role-time = the time
exchange-role-simulated = whether it is simulated
exchange-unit = unknown unit { $unit }: use mm, µm or inch
exchange-row-short = expected { $expected } cells, found { $found }
exchange-row-long = expected { $expected } cells, found { $found }: is the separator also used as decimal sign or within a text?
exchange-row-too-long = the row is longer than { $most } KiB
exchange-open-quote = a quotation mark is not closed on this line
exchange-callout = callout: { $reason }
exchange-nominal = nominal size: { $reason }
exchange-nominal-differs = callout { $callout } does not match nominal size { $nominal } in its own column
exchange-measured = measured: { $reason }
exchange-simulated = simulated: { $given } is neither true nor false
exchange-decimal-sign = measured: { $given } has a different decimal sign than the other values: "{ $sign }"
exchange-not-positive = measured: a diameter of { $given } is not above 0
exchange-decimal-comma = { $joined } may be one number with a decimal comma: use a decimal point or another separator
exchange-other-feature = { $given } is { $feature ->
        [hole] a shaft, and these are the holes: are the files swapped?
       *[shaft] a hole, and these are the shafts: are the files swapped?
    }
exchange-other-log = { $feature ->
        [hole] this is the log of a shaft, and these are the holes: are the files swapped?
       *[shaft] this is the log of a hole, and these are the shafts: are the files swapped?
    }
exchange-not-a-size = { $what }: this is not a size that can be paired
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
exchange-warning-not-used = skipped, not a measurement: { $text }
exchange-warning-comment = a line that begins with # is a comment, but this one holds a measurement
exchange-warning-several-lines = the row runs over { $lines } lines within quotation marks
exchange-warning-time = { $given } is not a date and time: the time of import is used
exchange-warning-no-time = no date and time here: the time of import is used
exchange-warning-offset = { $given } is kept as local time without its offset from UTC
exchange-warning-cut-off = the file ends here without a line end, and { $given } has fewer decimals than the other values: it may be cut off

# Contacts
contacts-file-empty = the file holds no contacts
contacts-no-columns = the header must name x and y, and may name z; it is { $given }
contacts-twice = columns { $first } and { $second } are both { $name }
contacts-cells = expected { $wanted } cells, found { $cells }: { $given }
contacts-not-a-number = { $name } is { $given }, not a number of millimetres
contacts-row-too-long = the row is longer than { $most } KiB
contacts-comment = a line that begins with # is a comment, but this one holds coordinates: take the # away, or the whole line
contacts-too-many = the file has more than { $most } contacts
contacts-open-quote = a quotation mark is not closed
contacts-mixed-signs = { $given } has a different decimal sign than the rows before it

## Tables of deviations
table-format-name = { $name } does not begin with a letter: table names on a TNC7 do
table-format-operator = { $name } contains { $sign }: table names on a TNC7 have no arithmetic operators
table-format-warning-lower-sign = the PC-DMIS manual shows no lower deviation other than 0: check { $class } in PC-DMIS before you rely on it, above all its signs
table-format-csv = the CSV cannot be written: { $reason }
table-format-parquet-unknown = this program was built without Parquet: cargo build --release without further options has it
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
exchange-correction = the value at 20 °C does not follow from the value as measured and its temperatures: expected the columns as Fitcheck writes them
exchange-warning-corrected = values with an entry in the column as_measured_mm are at 20 °C already
sizes-warning-named-twice = { $rows ->
        [one] a row has the name of an earlier row
       *[other] { $rows } rows have the name of an earlier row
    }, such as { $id } on lines { $first } and { $second }: each row counts as a part
sizes-warning-simulated-rows = { $count ->
        [one] 1 row is simulated
       *[other] { $count } rows are simulated
    }: nothing was measured
exchange-position-out = the centre was out of position, and a file has the size alone
exchange-undecided = nothing was decided here: { $given }
exchange-warning-other-rule = the verdicts of this file may be by another decision rule (column rule_name): its values are judged anew
