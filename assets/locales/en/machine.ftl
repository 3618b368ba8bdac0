# Running NC programs.

## Paths and files
machine-path-empty = the path is empty
machine-path-too-long = the path has more than { $most } characters
machine-path-other-root = { $path } is no path on TNC: and none from the program's folder
machine-path-leads-out = { $path } leads out of the folder
machine-path-no-name = { $name } in { $path } is no name for a file or a folder
machine-store-missing = there is no file { $path }
machine-store-outside = { $path } leads out of the folders that were given
machine-store-no-file = { $path } is no file
machine-store-too-large = { $path } is larger than { $most } MiB
machine-store-read-only = no folder was chosen for outputs
machine-store-system = { $path }: { $reason }

## Faults
machine-fault-in-block = { $program }, block { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, line { $line }, { $text }: { $fault }
machine-used-blocks = the run has used up its { $most } blocks: does it loop for ever?
machine-used-label-calls = { $most } calls of labels are within one another, one more is not allowed: does the program call itself?
machine-used-program-calls = { $most } calls of programs are within one another, one more is not allowed: does the program call itself?
machine-used-windows = the run has opened { $most } windows, one more is not allowed
machine-used-outputs = the run has printed to files { $most } times, one more is not allowed
machine-used-output = the run has printed { $most } bytes, more is not allowed
machine-used-cycles = the run has measured { $most } times, one more is not allowed
machine-used-path = the path has { $most } moves, one more is not allowed
machine-used-files = { $most } programs and changed tables are open, one more is not allowed
machine-used-traffic = the run has read and written { $most } bytes, more is not allowed
machine-used-file-bytes = programs and changed tables have more than { $most } bytes together
machine-text-too-long = the text has { $length } characters, a parameter holds at most { $most }
machine-unknown-block = this block is not known here: nothing is run that is not understood
machine-unknown-cycle = cycle { $cycle } is not known here; known are { $known }
machine-broken = the program is broken: { $what } is missing
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } is no label
machine-undefined = { $parameter } is undefined
machine-no-parameter = there is no parameter { $parameter }: Q and QS go up to 1999, QL and QR up to 499
machine-not-number = { $parameter } holds a text, a number is needed
machine-not-text = { $parameter } holds a number, a text is needed
machine-division-by-zero = division by zero
machine-negative-root = the root of { $value } does not exist
machine-no-result = { $function } { $value } does not exist
machine-beyond-range = { $value } is beyond the range of values, 10^10 either way
machine-not-whole = { $what } = { $value }: a whole number from 0 is needed
machine-behind-text = the text has { $length } characters, nothing begins at { $from }
machine-no-number-in-text = { $parameter } = "{ $text }" is no number
machine-unknown-system-text = ID{ $id } NR{ $number } is not known here; known are date and time, ID10321
machine-no-table = no table is open
machine-no-column = table { $table } has no column { $column }; its columns are { $columns }
machine-no-row = table { $table } has no row { $row }: its rows are 0 to { $last }
machine-no-rows = table { $table } has no rows
machine-empty-cell = table { $table }, row { $row }, column { $column }: the cell is empty
machine-no-number-in-cell = table { $table }, row { $row }, column { $column }: { $cell } is no number
machine-touches = table { $table }, row { $row }, column { $column }: the cell touches its neighbour, either may be cut wrongly
machine-table-write = table { $table }: { $error }
machine-mask = mask { $mask }: { $error }
machine-programmed = the program stopped itself with error { $number }
machine-no-cycle-parameter = cycle { $cycle } has no parameter { $parameter }
machine-cycle-parameter-twice = cycle { $cycle }: { $parameter } is given twice
machine-cycle = cycle { $cycle }: { $error }
machine-workpiece = workpiece: { $error }
machine-inch = cycles are run in programs in MM only

## Remarks
machine-remark-skipped = the block is not known here and was passed over
machine-remark-ended-within = M{ $function } in a called program ended the run: a control does not allow it there
machine-remark-given-wins = { $parameter } = { $value } was given before the run and stands in place of this block's value
machine-remark-not-written = { $path } was not written: no folder was chosen for outputs
machine-remark-not-saved = { $path } was not written: { $reason }
machine-remark-full = { $path } has reached its { $kilobytes } kilobytes, nothing was added
machine-remark-table-written = { $path } was written
machine-remark-contacts-left = the cycles took { $used } of { $count } recorded contacts
machine-remark-more = { $count } more remarks are not listed
machine-remark-other-probe = tool { $tool } is not in the touch-probe table: probe { $probe } was used

## Pauses
machine-pause-stop = the program has stopped: STOP or M0
machine-pause-optional-stop = the program has stopped: M1
machine-pause-breakpoint = the next block has a breakpoint
machine-pause-log = the measuring log is on the screen (Q281 = 2)
