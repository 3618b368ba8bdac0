# control

# Masks
mask-empty = the mask is empty
mask-unknown = line { $line }, column { $column }: { $found } is no record, keyword or comment
mask-unclosed-quote = line { $line }, column { $column }: the quotation mark is not closed
mask-unknown-format = line { $line }, column { $column }: { $found } is no format, allowed are %S %RS %F %LF %D %I %%
mask-too-wide = line { $line }, column { $column }: { $found } is too wide, at most { $most }
mask-count = line { $line }: { $formats } formats and { $parameters } parameters
mask-unknown-parameter = line { $line }, column { $column }: { $found } is no parameter, allowed are Q, QL, QR, QS with a number, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = line { $line }: the ; at the end is missing
mask-unknown-word = line { $line }: { $word } is not known and has no effect
mask-behind-semicolon = line { $line }: { $found } behind the ; is passed over
mask-undefined = line { $line }, column { $column }: { $name } is not defined
mask-text-as-number = line { $line }, column { $column }: { $name } is a text, the format wants a number
mask-number-as-text = line { $line }, column { $column }: { $name } is a number, the format wants a text
mask-not-finite = line { $line }, column { $column }: { $name } is not a finite number
# Measuring logs
log-at-line = line { $line }: { $reason }
log-empty = the file is empty
log-no-log = no measuring log here: no title line with the number of a measuring cycle
log-no-title = a log without its title line: which cycle measured is not known
log-other-cycle = logs of cycle { $cycle } are not read, only those of 421, 422 and 427
log-unit = type of dimension { $given } is neither 0 (mm) nor 1 (inch)
log-number = { $reason }
log-count = { $section } has { $found } figures where { $expected } are due
log-missing = { $section } is missing: the log is cut off or not complete
log-no-label = { $given } stands without a label before it
log-cut-figure = the file ends within this figure: { $given } may not be all of it
log-swapped = maximum { $maximum } is below minimum { $minimum }
log-uneven = limits { $minimum } and { $maximum } do not lie evenly about the nominal value { $nominal }
log-deviation = deviation { $given } is not actual minus nominal value, { $actual } - { $nominal }
log-not-positive = diameter { $given } is not above 0
log-section-nominal = section of nominal values
log-section-limits = section of limit values
log-section-actual = section of actual values
log-section-deviations = section of deviations
log-no-unit = no line tells the unit: millimetres taken
log-no-time = date and time of the measurement are not known
log-no-deviations = the deviations are missing: the log may be cut off
log-ignored = not used: { $text }
log-text-before = text before the first log was not used
