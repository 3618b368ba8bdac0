# The command line

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = warning: { $what }
cli-note = note: { $what }

# What an error is about
cli-what-callout = callout
cli-what-measured-value = measured value
cli-what-hole = hole
cli-what-shaft = shaft
cli-what-measured-hole = measured hole
cli-what-measured-shaft = measured shaft
cli-what-hole-material = hole material
cli-what-shaft-material = shaft material
cli-what-temperature = temperature
cli-what-smallest-clearance = smallest clearance
cli-what-largest-clearance = largest clearance
cli-what-nominal-size = nominal size { $text }
cli-what-true-diameter = true diameter
cli-what-simulated-workpiece = simulated workpiece
cli-what-simulated-measurement = simulated measurement
cli-what-perfect-workpiece = workpiece at nominal
cli-what-size = size
cli-what-cycle = cycle { $code }
cli-what-log = log
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Errors
cli-not-above-zero = { $diameter } mm is not above 0
cli-line-too-long = the line is longer than { $limit } bytes
cli-not-a-table = { $name } is no table of deviations
cli-add-feature = { $error }: add --feature hole or --feature shaft
cli-rework-or-scrap = { $asked }: { $measured } mm is outside { $minimum } to { $maximum } mm; whether that is rework or scrap depends on hole or shaft: add --feature hole or --feature shaft
cli-parts-of-several = measured parts belong to one fit: give one callout
cli-search-with-parts = a search has no measured parts, materials or temperatures
cli-search-without-size = a search needs one nominal size, such as 25
cli-search-without-clearance = a search needs --min-clearance and --max-clearance
cli-table-ending = { $path }: the name of a control table ends in .tab
cli-format-ending = { $path }: a file of format { $format } ends in .{ $endings }
cli-several-tables = a control table is one file: name one table, or classes of one feature
cli-report-format = --format { $format } does not fit the ending of { $file }: leave one of them out
cli-report-empty = no check could be used, so no report was written
cli-not-an-object = inputs are a JSON object such as {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: a number or a text is needed
cli-given-twice = { $name } is given twice
cli-set-twice = { $name } is set twice
cli-other-cycle = this is cycle { $given }, not { $wanted }
cli-not-predef = { $name } is no parameter that may be PREDEF
cli-no-probe = the touch-probe table has no probe { $number }
cli-not-a-pair = { $text }: a parameter is given as NAME=VALUE
cli-not-a-position = position { $text }: three numbers X,Y,Z in mm are needed
cli-not-a-number = this is no number
cli-no-folder = no such folder: { $path }
cli-no-program = { $error }; built-in programs are { $names }
cli-option-beside-plan = --{ $option } is for a single callout: a plan has a column for it
cli-option-missing = --{ $option } is missing: a single callout needs --x, --y and --z
cli-no-control = { $name }: no such control
cli-use-force = { $error }; --force overwrites

# A --check of a report
cli-check-no-measured = { $text } has no measured value: write a callout, = and millimetres, such as 25 H7=25.012
cli-check-measured = measured value: { $value }
cli-check-not-positive = measured value { $measured } mm is not above 0

# Notes
cli-note-wrote = wrote { $path }
cli-note-wrote-files = wrote { $path } ({ $count } files)
cli-note-column-not-used = column { $column } is not used
cli-note-remove = remove { $limit } mm to the nearest limit, { $middle } mm to the middle of the zone
cli-note-own-table = table { $name } differs from ISO 286, which has { $upper } and { $lower } mm
cli-note-refused = { $refused } of { $asked } callouts refused
cli-note-no-pair = no pair fits; nearest is { $nearest }
cli-note-empty-cell = { $class } over { $over } up to { $to } mm is left empty: ISO 286 has no single value for all of it
cli-note-contacts-left = the cycle took { $used } of { $count } contacts
cli-note-log-unknown = no log is made: that of cycle { $code } is not known
cli-note-log-off = no log is written: Q281 = 0
cli-note-log-none = no log is written: the cycle has none
cli-note-log-on-screen = no log is written: Q281 = 2 shows it on screen
cli-note-clearance-height = the clearance height is { $height } mm: --clearance-height gives another
