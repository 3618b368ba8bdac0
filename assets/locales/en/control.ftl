# control

# Masks
mask-empty = the mask is empty
mask-too-large = the mask is larger than { $most } KiB
mask-unknown = { $found } is not a record, keyword or comment
mask-unclosed-quote = the quotation mark is not closed
mask-unknown-format = { $found } is not a format: allowed are %S %RS %F %LF %D %I %%
mask-too-wide = { $found } is too wide: at most { $most }
mask-count = { $formats } formats and { $parameters } parameters
mask-unknown-parameter = { $found } is not a parameter: allowed are Q, QL, QR, QS with a number, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = the ; at the end is missing
mask-unknown-word = { $word } is unknown and has no effect
mask-behind-semicolon = { $found } after the ; is skipped
mask-other-languages = the mask has text for { $languages } and none for { $wanted }
mask-inverse-touching = { $first } and { $second } are printed with nothing between them, so the output cannot be read back
mask-inverse-blanks = { $first } and { $second } are texts with only blanks between them, so the output cannot be read back: a text may contain blanks
mask-inverse-no-mark = no literal text marks where a record begins, so the output cannot be read back
mask-inverse-too-long = the mask prints more than { $most } lines at a time: only shorter records can be read back
mask-inverse-no-number = the mask prints no number that could be a measured value
mask-undefined = { $name } is not defined
mask-text-as-number = { $name } is a text, the format needs a number
mask-number-as-text = { $name } is a number, the format needs a text
mask-not-finite = { $name } is not a finite number
# Measuring logs
log-empty = the file is empty
log-no-log = not a measuring log: no title line with the number of a measuring cycle
log-too-long = the log has more than { $lines } lines, or a line of more than { $bytes } bytes
log-no-title = the log has no title line, so its cycle is unknown
log-other-cycle = logs of cycle { $cycle } cannot be read, only those of { $known }
log-unit = type of dimension { $given } is neither 0 (mm) nor 1 (inch)
log-count = { $section }: expected { $expected }, found { $found }
log-missing = { $section } is missing: the log is cut off or incomplete
log-no-label = no label before { $given }
log-cut-figure = the file ends within this value: { $given } may be incomplete
log-swapped = maximum { $maximum } is below minimum { $minimum }
log-uneven = limits { $minimum } and { $maximum } are not symmetrical about the nominal value { $nominal }
log-deviation = deviation { $given } is not actual minus nominal value, { $actual } - { $nominal }
log-not-positive = diameter { $given } is not above 0
log-section-nominal = section of nominal values
log-section-limits = section of limit values
log-section-actual = section of actual values
log-section-deviations = section of deviations
log-no-unit = no line gives the unit: millimetres assumed
log-no-time = date and time of the measurement are unknown
log-no-deviations = the deviations are missing: the log may be cut off
log-ignored = skipped: { $text }
log-text-before = text before the first log was skipped

## Tables
table-empty = the file is empty
table-not-text = character { $code } is not text: the file is not a table or is damaged
table-line-too-long = the line is longer than { $limit } bytes
table-too-large = the table has more than { $limit } cells
table-too-many-columns = the table has more than { $limit } columns
table-no-begin = a table begins with BEGIN and its name, not with { $found }
table-no-name = the name of the table is missing after BEGIN
table-unclosed-quote = a quotation mark is not closed
table-unclosed-block = the block { $block } of line { $line } is not closed
table-second-block = the columns are described a second time
table-unexpected = expected { $expected }, found { $found }
table-not-a-size = { $key } must be a whole number up to { $limit }, not { $text }
table-no-columns = the line with the names of the columns is missing
table-tab = tab character: separate columns with spaces only
table-column-twice = column { $name } occurs twice
table-short-row = the row ends before column { $name }: fill it with spaces, or write - for no value
table-truncated = the file ends within this row and without [END]: it may be cut off
table-text-after-end = text after [END]: { $found }
table-no-end = [END] is missing
table-no-lock = the tool table has no column TL: a broken tool is not locked in it
table-no-unit = the table does not name its unit: its lengths were read as millimetres
table-begin-word = { $word } has no known meaning in the BEGIN line
table-width = column { $name } is { $found } characters wide here but { $described } in the description; the line of column names applies
table-not-in-table = column { $name } is described but not in the table
table-not-described = column { $name } is not described
table-skipped = { $name } is unknown and was skipped
table-write-too-wide = row { $row }, column { $column }: { $text } does not fit into { $width } characters
table-write-too-many-columns = the table has { $columns } columns; an iTNC 530 takes at most { $limit }
table-write-too-long = the lines of the table have { $characters } characters; an iTNC 530 takes at most { $limit }
table-write-reads-otherwise = the table cannot be written so that it reads back the same: check the names of the table and its columns

## Tables of deviations
deviations-no-tables = no table of deviations (*.tab with a column BEREICH) in this folder: { $folder }
tables-contradict = { $first } and { $second } contradict each other, { $class } over { $over } up to { $to } mm: { $one ->
        [none] no value
       *[other] { $one } µm
    } and { $other ->
        [none] no value
       *[other] { $other } µm
    }: remove the column from one of them
deviations-two-range-columns = the table has both BEREICH and BEREIK: only one can hold the size ranges
deviations-inch = the table is in inch: write size ranges in millimetres and deviations in micrometres
deviations-no-class = no column is a tolerance class such as H7
deviations-odd-rows = the number of rows is odd ({ $rows }): each size range takes two, first the upper deviation, then the lower deviation
deviations-no-range = the end of the size range is missing
deviations-other-range = the size range up to { $end } mm has { $found } in its second row: repeat it or leave it blank
deviations-column = column { $column }: { $error }
deviations-half = column { $class } has only one of the two deviations for the size range up to { $end } mm
deviations-touches = column { $column } and its neighbour run into each other: separate them with a space
deviations-no-deviations = skipped, not a table of deviations (no column BEREICH): { $file }
deviations-range-alias = BEREIK was read as BEREICH
deviations-other-column = column { $name } was skipped, because its name cannot be that of a tolerance class: a table written from this one lacks it
deviations-no-numbers = column { $name } was skipped, because it holds texts and no deviations: a table written from this one lacks it
deviations-mixed-case = column { $name } was skipped, because a tolerance class does not mix upper and lower case: a table written from this one lacks it

## Parameters
no-parameter = { $given } is not a parameter: allowed are Q, QL, QR and QS with a number

## Writing measuring logs
log-write-cycle = cycle { $cycle } does not write these values
log-write-no-title = the log of cycle { $cycle } has no title in { $file }
log-write-unit = a log is in mm or inch, not in µm
log-write-character = { $given } cannot be written: a log cannot contain the character U+{ $code }
log-write-program = { $given } would not be read back as the path of a program: write a path such as TNC:\PART\CHECK.H
log-write-unfinished = the file ends within a line: it may be cut off, so nothing is added to it
log-write-reads-otherwise = the log cannot be written so that it reads back the same: check date, time and further results

## Log of cycle 444
point-log-no-log = not a log of cycle 444: the page holds no machine-readable measurement
point-log-count = the page says that it holds { $expected } measurements, but it holds { $found }: it is cut off or was changed
point-log-cut-off = the measurement has no end: the page is cut off
point-log-json = the measurement cannot be read: { $what }
point-log-version = log version { $version } is not supported: expected { $known } or earlier
point-log-normal = normal { $given } has no direction: it needs three numbers that are not all 0
point-log-deviation = deviation { $given } in { $axis } is not measured minus nominal coordinate, { $difference }
point-log-along = deviation { $given } along the normal does not follow from those of the axes, { $along }
point-log-band = upper deviation { $upper } is below lower deviation { $lower }
point-log-status = status { $given } does not follow from deviation and tolerance, { $status }
## The touch-probe table
probe-table-no-column = the table has no column { $column }
probe-table-no-probe = the table has no probe
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: it must be { $least }
probe-table-zero-or-more = 0 or more
probe-table-above-zero = above 0
probe-table-not-whole = { $column } = { $given }: expected a whole number
probe-table-twice = probe { $number } occurs twice

## The tool table
tool-table-no-column = the table has no column { $column }
tool-table-no-tool = the table has no tool
tool-table-touches = { $column }: the cell runs into its neighbour, so its value is uncertain
tool-table-no-number = { $column } = { $given }: expected a tool number from 0 to 32767, with an index such as 5.1 or without
tool-table-twice = tool { $number } occurs twice
tool-table-name-too-long = NAME = { $given }: a name has at most { $most } characters
tool-table-no-length = { $column }: { $error }
tool-table-out-of-range = { $column } = { $given } mm: expected { $least } to { $most } mm
tool-table-no-lock = TL = { $given }: expected L or 1 for a locked tool; 0, - or nothing for a free one
tool-table-not-whole = { $column } = { $given }: expected a whole number
tool-unknown = Q330 = { $tool }: the tool table has no such tool; it has { $known }
tool-no-deviation = Q330 = { $tool }: cycle { $cycle } has no limits here, so there is no deviation to correct the tool by
tool-out-of-range = tool { $tool }: { $column } would change from { $from } to { $to } mm: the largest value is { $most } mm either way
tool-broken = error 1065: tool { $tool } is broken: { $column } would change by { $by } mm, { $limit } is { $most } mm; the tool is locked and not corrected
tool-broken-replacement = error 1065: tool { $tool } is broken: { $column } would change by { $by } mm, { $limit } is { $most } mm; the tool is locked and not corrected; its replacement is tool { $replacement }
tool-corrected = tool { $tool }: { $column } changed by { $by } mm, from { $from } to { $to } mm
tool-corrected-rounded = tool { $tool }: { $column } changed by { $by } mm, from { $from } to { $to } mm: the table keeps the nearest 0.00001 in
tool-locked = tool { $tool }: locked, TL = { $to }

## The log of a cycle's result
cycle-log-other-verdict = the log's values, rounded to 0.0001 { $unit }, give { $log } where the cycle gave { $cycle }

## The block of a probing cycle
block-none = not a probing cycle: a block begins with TCH PROBE and a number, or with G785
block-inches = the block belongs to a program in inches but would be read in mm: run the program
block-none-at = no measuring cycle has this line: they begin on the lines { $blocks }
block-second = second probing cycle: give one at a time; the first begins on line { $first }
block-unknown-cycle = TCH PROBE { $given }: the cycles are { $known }
block-not-a-parameter = { $given } is not a parameter: write it as { $example }
block-no-value = { $key } has no value
block-twice = { $key } is given twice, first on line { $first }
block-unclosed-quote = a quotation mark is not closed
block-behind-end = { $given } comes after the end of the block: every line but the last ends with ~
block-too-many-parts = the line has more than { $most } parts between ~
block-cut-off = the block ends with ~, so a line is missing: it may be cut off
block-reference = { $key } = { $given }: the value of { $given } is known only while a program runs
block-not-writable = { $key } = { $given }: a text in a block cannot contain quotation marks or line ends
block-unused = line { $line }: { $text } is not part of the probing cycle and was skipped
block-unused-more = line { $line }: { $text } is not part of the probing cycle and was skipped, and { $more } more
