# The command line

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = warning: { $what }
cli-remark = note: { $what }

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
cli-what-entry = entry { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Errors
cli-batch-simulated = the first lines of { $name } say that it is simulated, and only CSV can keep them: write CSV
cli-dash = - is standard output, which is not possible here: give a name, or ./- for a file or folder named -
cli-no-subcommand = { $given } is not a subcommand; these are: { $names }
cli-not-above-zero = { $diameter } mm is not above 0
cli-ratio-of-one-limit = rule asme-simple compares the uncertainty with the tolerance: expected --lower and --upper
cli-already-corrected = --temperature: the file says that its values are at 20 °C already
cli-not-a-multiple = { $given }: expected a number above 0 with at most three decimals
cli-no-limits = give --lower, --upper or both, with the lower limit below the upper one
cli-risk-without-uncertainty = the risks of a process need --u or --expanded
cli-risk-without-process = --consumer-risk needs --process-mean and --process-sd, or --gamma
cli-not-a-risk = risk { $given }: expected a probability between 0 and 1, such as 0.001
cli-not-a-gamma = gamma law { $given }: expected its shape and its scale in µm, such as 4,0.25
cli-no-zone-for-risk = no zone of accepted values has this consumer's risk
cli-line-too-long = the line is longer than { $limit } bytes
cli-not-a-table = { $name } is not a table of deviations
cli-stats-features = several features: choose one with --feature: { $names }
cli-stats-no-feature = no feature { $given }: the files have { $names }
cli-stats-limits = limits differ from value to value: give --lower and --upper, or choose a feature with --feature
cli-stats-no-point = no point { $point }: the chart has { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (if it is right: --confirm-layout)
cli-stats-no-budget = this study gives no contribution to a budget
cli-stats-no-picture = no picture can be drawn: { $why }
cli-stats-points = --stage and --leave-out are for one feature: choose it with --feature instead of --all
cli-stats-parameters = --parameters is for --chart ewma or cusum
cli-add-feature = { $error }: add --feature hole or --feature shaft
cli-add-wide-zone = { $asked }: { $error }; if this zone is intended, add --wide-zone
cli-add-far-temperature = { $what }: { $error }; if this temperature is intended, add --far-temperature
cli-remark-open = { $count ->
    [one] one value is out of limits; whether it is rework or scrap depends on hole or shaft: add --feature hole or --feature shaft, a column kind with these words, or a plan
   *[other] { $count } values are out of limits; whether they are rework or scrap depends on hole or shaft: add --feature hole or --feature shaft, a column kind with these words, or a plan
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked }: { $um } µm above maximum; whether it is rework or scrap depends on hole or shaft: add --feature hole or --feature shaft
   *[below] { $asked }: { $um } µm below minimum; whether it is rework or scrap depends on hole or shaft: add --feature hole or --feature shaft
}
cli-parts-of-several = measured parts belong to one fit: give one callout
cli-search-with-parts = a search takes no measured parts, materials or temperatures
cli-search-without-size = a search needs one nominal size, such as 25
cli-search-without-clearance = a search needs --min-clearance and --max-clearance
cli-table-ending = { $path }: the name of a control table ends in .tab
cli-format-ending = { $path }: a file of format { $format } ends in .{ $endings }
cli-several-tables = a control table is one file: name one table, or classes of one feature
cli-report-format = --format { $format } does not fit the ending of { $file }: leave one of them out
cli-stopped = stopped by Ctrl+C after { $rows } rows
cli-report-empty = no check was usable, so no report was written
cli-inputs-too-large = the inputs of a cycle have at most { $most } KiB
cli-not-an-object = the inputs must be a JSON object such as {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: expected a number or a text
cli-given-twice = { $name } is given twice
cli-option-of-standard = --{ $option } has no effect with --source control: the control's tables have one edition of ISO 286
cli-set-twice = { $name } is set twice
cli-several-blocks = several measuring cycles, on the lines { $blocks }: choose one by --at LINE
cli-other-cycle = this is cycle { $given }, not { $wanted }
cli-not-predef = PREDEF is not allowed for parameter { $name }
cli-no-probe = the touch-probe table has no probe { $number }
cli-not-a-pair = { $text }: write a parameter as NAME=VALUE
cli-not-a-position = position { $text }: expected three numbers X,Y,Z in mm
cli-not-a-number = this is not a number
cli-no-folder = no such folder: { $path }
cli-watched-already = another program watches { $path } for this journal
cli-no-program = { $error }; built-in programs are { $names }
cli-option-beside-plan = --{ $option } is for a single callout: a plan has a column for it
cli-option-missing = --{ $option } is missing: a single callout needs --x, --y and --z
cli-batch-ending = { $path }: the output must end in .{ $endings }, followed by .gz or .zst to compress it
cli-batch-onto-itself = { $path } is one of the inputs: write the answers to another file
cli-batch-columns = { $name } has different columns from the first file, which has { $columns }
cli-batch-separator = { $name } has a different separator from the first file: write .jsonl, or judge this file separately
cli-batch-types = column { $column } of { $name } has a different type in the first file: write .csv, or judge this file separately
cli-batch-packed = { $path }: Parquet is already compressed: leave out .gz or .zst
cli-batch-twice = { $name } has two columns named { $column }: write .csv, which allows both
cli-batch-input = { $name }: { $error }
cli-batch-name = { $name } already has a column { $column }: use --prefix to put a word before the names of the added columns
cli-use-force = { $error }; --force overwrites

# A --check of a report
cli-check-no-measured = { $text } has no measured value: write a callout, = and millimetres, such as 25 H7=25.012
cli-check-measured = measured value: { $value }
cli-check-not-positive = measured value { $measured } mm is not above 0

# Remarks
cli-remark-wrote = wrote { $path }
cli-remark-wrote-files = wrote { $path } ({ $count } files)
cli-remark-simulated = simulated: nothing was measured
cli-remark-perfect-workpiece = simulated: every cycle measured a perfect workpiece at nominal; for another workpiece, use --workpiece FILE.toml
cli-remark-corrected = measured { $measured } mm at { $temperature } °C: { $change } µm, so { $at-reference } mm at 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = every measured value is corrected from { $temperature } °C to 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = scales at { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = the linear correction differs from the exact one by { $off } µm
cli-remark-rule = rule: { $rule }
cli-remark-rule-by-budget = rule: { $rule }
cli-remark-budget = uncertainty from the budget { $name }, created { $date }, valid until { $until }
cli-remark-budget-contacts = scatter of { $touches } contacts{ $step }, geometry factor { $factor }
cli-remark-accepted = accepted: { $least } to { $most } mm
cli-remark-nothing-accepted = no value is accepted: the rule leaves no part of this tolerance
cli-remark-proven = proven by this rule
cli-remark-not-proven = not proven by this rule
cli-remark-conformity = conforms with a probability of { $percent } %
cli-remark-remove = remove { $limit } mm to the nearest limit, { $middle } mm to the middle of the zone
cli-remark-refused = { $refused } of { $asked } callouts refused
cli-remark-no-pair = no pair fits; the nearest is { $nearest }
cli-remark-trace-ends = the trace ends here, after { $blocks } blocks
cli-remark-batch-utf16 = { $name } is UTF-16 and is written as UTF-8
cli-remark-batch-floats = { $name } has floating-point numbers in { $columns }: each is judged as the shortest decimal that represents it
cli-remark-tools-not-written = the tool table is not written: --tools-out FILE.t writes it with these changes
cli-remark-clearance-height = the clearance height is { $height } mm: --clearance-height changes it
cli-remark-more-entries = only { $limit } entries are listed: for more, use --limit N
cli-remark-backed-up = copied up to entry { $number } to { $path } (hash { $hash })
cli-remark-no-head-known = no entry of this journal is known elsewhere: missing newest entries would not be found

# Warnings
cli-warning-stopped-unrecorded = nothing was recorded: rows are recorded together, once all of them are read
cli-warning-column-not-used = column { $column } is skipped
cli-warning-expansion-unconfirmed = the expansion of { $expansion } · 10⁻⁶/K is a common value that no document confirms here
cli-warning-file-twice = this file is named twice: its rows are counted twice
cli-warning-position-unused = --position has no effect: cycle { $code } does not start at the position of the ball
cli-warning-predef-unused = --predef has no effect on { $name }: it is not set to PREDEF
cli-warning-log-option = --{ $option } has no effect: no log is written or shown
cli-warning-more-figures = { $count } more such figures are not listed
cli-warning-tables-not-used = --tables, --source and options of the standard are not used: no limits are looked up without --fit
cli-warning-empty-cell = { $class } over { $over } up to { $to } mm is left empty: ISO 286 has no single value for all of it
cli-warning-budget-option = --{ $option } has no effect: the budget does not depend on it
cli-warning-contacts-left = the cycle used { $used } of { $count } contacts
cli-warning-not-in-csv = CSV has no place for { $options }: HTML, JSON and PDF do
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } note is not in the CSV: HTML and JSON contain it
   *[other] { $count } notes are not in the CSV: HTML and JSON contain them
}
cli-warning-no-tool-monitored = the tool table is not used: no tool is given in Q330
cli-warning-log-unknown = no log is written: the log of cycle { $code } is unknown
cli-warning-limits-alone = the limits alone decide here: the decision rule and the temperature apply only to diameters
cli-warning-log-off = no log is written: Q281 = 0
cli-warning-log-none = no log is written: the cycle has none
cli-warning-log-on-screen = no log is written: Q281 = 2 shows it on screen

# Tables against ISO 286
cli-verify-off = { $place }: { $class } over { $over } up to { $to } mm: { $table }, ISO 286 has { $standard }: { $by }
cli-verify-missing = { $place }: { $class } over { $over } up to { $to } mm: no value, ISO 286 has { $standard }
cli-verify-undefined = { $place }: { $class } over { $over } up to { $to } mm: { $table }, but { $reason }
cli-verify-neither = { $place }: { $class } over { $over } up to { $to } mm: { $reason }
cli-verify-by = { $side ->
        [upper] upper
       *[lower] lower
    } { $um } µm { $way ->
        [more] more
       *[less] less
    }
cli-verify-table = { $name }: { $classes ->
        [one] { $classes } class
       *[other] { $classes } classes
    }, { $ranges ->
        [one] { $ranges } size range
       *[other] { $ranges } size ranges
    }, { $cells ->
        [one] { $cells } cell
       *[other] { $cells } cells
    } compared: { $differ ->
        [0] all agree with ISO 286
        [one] { $differ } differs from ISO 286
       *[other] { $differ } differ from ISO 286
    }
cli-verify-nothing = { $name }: { $classes ->
        [one] { $classes } class
       *[other] { $classes } classes
    }, { $ranges ->
        [one] { $ranges } size range
       *[other] { $ranges } size ranges
    }, { $cells } cells compared: nothing to compare with ISO 286
cli-verify-own = { $table }; not compared, not ISO 286 classes: { $own }

## Start
start-missing = no such file: { $path }; name an existing file to open it in the window, or a subcommand
start-folder = this is a folder, not a file: { $path }; only files open in the window

## What was recorded
cli-recorded-entry = recorded as entry { $number } of { $file } (hash { $hash })
cli-recorded-entries = recorded as entries { $first } to { $last } of { $file } (hash of the last one { $hash })
cli-recorded-nothing = nothing was judged, so nothing was recorded
cli-recorded-without = { $rows ->
    [one] 1 row is not recorded
   *[other] { $rows } rows are not recorded
}: { $places }
cli-not-recorded = nothing was recorded: { $error }
cli-journal-is-server = this needs the journal file of a station: a server only receives what stations have recorded
cli-no-shop = this program was built without support for a shop server: name a file as the journal
cli-recorded-not-sent = not yet sent to the server: { $error }; the records are kept here, and fitcheck journal send sends them
cli-no-journal-folder = this system has no folder for your data: name a journal with --journal FILE
cli-no-entry = there is no entry { $number } in { $path }: the last one is { $last }
cli-no-check = entry { $number } is not a check
cli-no-hash = no entry of { $path } has a hash that begins with { $prefix }
cli-several-hashes = the hashes of several entries begin with { $prefix }: { $numbers }. Give more digits or the number
cli-record-needs-file = --record names the file that was written, and standard output is none: give -o FILE
cli-report-not-known = { $file } is written, but the journal does not know it: { $error }
cli-already-corrected-by = entry { $number } was already corrected or withdrawn by entry { $by }: correct that one, unless it is a withdrawal
cli-not-typed = the value of entry { $number } was not typed: measure again, or withdraw the check
cli-nothing-corrected = a correction must change something: give --measured, --who, --part, --serial, --feature-name, --remark or --withdraw
cli-remark-sent = { $entries ->
    [0] nothing had to be sent
    [one] 1 entry was sent
   *[other] { $entries } entries were sent
} to { $server }, which has this journal up to entry { $number }
cli-remark-nothing-found = no check matches { $question }
cli-remark-unread = { $entries ->
    [one] 1 entry is
   *[other] { $entries } entries are
} skipped: this version cannot read { $entries ->
    [one] it
   *[other] them
}
cli-head-without-chain = a server has several chains: give --head CHAIN:NUMBER:HASH
cli-head-of-other = this journal is the chain { $chain }, but --head names { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } feature
   *[other] { $count } features
}
cli-remark-plan-example = no callout given: the plan has one feature as an example
cli-remark-plan-to-fill = the plan is written as far as it is known; faults to correct in it: { $count }
cli-remark-no-columns = the file is read by its own format and has no columns to choose
cli-remark-plan-head-left = CSV holds only the features: { $keys } of the part is not written
cli-warning-neither-stands = entry { $number } corrected entry { $target }: now neither of them counts. If one of the values is right, record it again
cli-warning-beyond-limits = outside the limits: accepted by the rule, since it is not proven to be out
cli-warning-plan-missing = not measured: { $names }
cli-warning-plan-missing-of = { $who }: not measured: { $names }
cli-warning-contradiction = { $name } has values that contradict each other: { $values }
cli-warning-contradiction-of = { $who }: { $name } has values that contradict each other: { $values }
cli-warning-worst-counts = the worst of several contradicting values counts until you choose: --repeats last or --repeats worst. Serial numbers tell parts apart, and a time for each value shows which one is the last
cli-warning-plan-more-parts = more than { $most } parts: missing features of the others are not reported
cli-warning-plan-no-value = missing: no value found
cli-warning-plan-no-value-of = missing on { $who }: no value found
cli-remark-watching = watching { $folder }; files imported before: { $known }
cli-warning-see-note = not everything could be used: the file beside it ending in { $note } gives the reasons
cli-not-seconds = { $given } is not a time in seconds
cli-warning-same-content = the same content was imported before as { $known }: nothing is recorded again
cli-warning-not-alone = cannot tell whether another program watches this folder for the same journal: { $reason }

## The time zone of this computer
zone-not-understood = TZ is set to "{ $given }", which is not a time zone: set it to a name such as Europe/Amsterdam or to UTC, or remove it
zone-unknown = the time zone of this computer is not known, so times are in UTC: set TZ to a name such as Europe/Amsterdam

# The doctor
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, it is { $time }
doctor-clock = not before the newest entry of the journal
doctor-clock-behind = earlier than the newest entry of { $path }, which was written at { $newest }: set the clock of this computer
doctor-folder = { $path }: files can be written
doctor-journal = { $path }: entries { $entries }
doctor-no-journal = { $path } is not there yet: the first check that is recorded makes it
doctor-server = { $address } answers
doctor-no-server = no server is set: name it with --journal postgres://…, or in the window under Settings
doctor-gauges = ports of this computer: { $ports }
doctor-no-port = this computer has no serial port: plug the gauge in, or its cable
doctor-gauge-gone = { $gauge }: port { $port } is not there: plug the gauge in, or choose another port in the window under Settings
doctor-no-gauges = this program was built without the ports of gauges: the packages have them
doctor-ports-not-listed = the ports of this computer cannot be listed: { $reason }
doctor-tables = { $path }: tables { $count }
doctor-no-tables = no tables of your own: ISO 286 and the tables of the control are built in
doctor-settings = what the window keeps can be read
doctor-window = drawn with { $renderer }
doctor-no-window = this program was built without the window
