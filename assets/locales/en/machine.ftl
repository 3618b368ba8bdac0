# Running NC programs.

## Paths and files
machine-path-empty = the path is empty
machine-path-too-long = the path has more than { $most } characters, which a control does not allow
machine-path-other-root = { $path } is neither a path on TNC: nor a path from the program's folder
machine-path-leads-out = { $path } leads out of the folder
machine-path-no-name = { $name } in { $path } is not a name for a file or folder
machine-store-missing = file not found: { $path }
machine-store-outside = { $path } leads out of the given folders
machine-store-no-file = { $path } is not a file
machine-store-too-large = { $path } is larger than { $most } MiB
machine-store-ambiguous = { $path } exists in several spellings, { $names }, but a control has only one file of each name: remove or rename the others
machine-store-elsewhere = { $path } is not in the output folder: a program deletes files only there
machine-store-read-only = no output folder was chosen
machine-store-system = { $path }: { $reason }

## Faults
machine-fault-in-block = { $program }, block { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, line { $line }, { $text }: { $fault }
machine-used-blocks = limit of { $most } blocks reached: possible endless loop
machine-used-label-calls = nesting limit of { $most } label calls reached: does the program call itself?
machine-used-program-calls = nesting limit of { $most } program calls reached: does the program call itself?
machine-used-windows = limit of { $most } windows reached
machine-used-outputs = limit of { $most } file outputs reached
machine-used-output-files = limit of { $most } output files reached
machine-used-folders = limit of { $most } folders for output files reached
machine-used-table-writes = limit of { $most } writes of changed tables reached
machine-used-output = limit of { $most } printed bytes reached
machine-used-cycles = limit of { $most } measurements reached
machine-used-path = limit of { $most } moves reached
machine-used-files = limit of { $most } open programs and changed tables reached
machine-used-traffic = limit of { $most } bytes read and written reached
machine-used-file-bytes = programs and changed tables exceed { $most } bytes together
machine-text-too-long = the text has { $length } characters, a parameter holds at most { $most }
machine-unknown-block = unknown block: Fitcheck runs only what it understands
machine-unknown-cycle = Fitcheck does not follow cycle { $cycle }, even where the control has it: it follows { $known }
machine-file-open = { $path } is open as a table of FN 26: it cannot be copied, moved or deleted
machine-broken = the program is broken: { $what } is missing
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } is not a label
machine-no-tool-data = { $parameter } is undefined: it holds a measure of the tool in the spindle, which a tool table says
machine-undefined = { $parameter } is undefined
machine-lost = { $parameter } is undefined: line { $line }, { $text }, may set it and was not run
machine-file-unknown = { $path } is not read: line { $line }, { $text }, may write or remove it and was not run
machine-tools-unknown = the tool is not corrected: line { $line }, { $text }, may change the tool table and was not run
machine-contacts-unknown = it is not known which recorded contacts belong to this cycle: some may belong to line { $line }, { $text }, which was not run
machine-not-skipped = this block decides what runs next or what another program receives: it cannot be skipped
machine-whole-only = { $parameter } holds whole numbers only, not { $value }
machine-no-answer = INPUT "{ $question }" asks for { $parameter }: give it a value before the run
machine-no-parameter = parameter { $parameter } does not exist: Q and QS go up to 1999, QL and QR up to 499
machine-no-variable = variable { $variable } does not exist: { $family } goes from { $least } to { $most }
machine-not-number = { $parameter } holds a text: expected a number
machine-not-text = { $parameter } holds a number: expected a text
machine-division-by-zero = division by zero
machine-negative-root = the square root of { $value } is not defined
machine-no-result = { $function } { $value } is not defined
machine-beyond-range = { $value } is beyond the range of values, -10^10 to 10^10
machine-not-whole = { $what } = { $value }: expected a whole number from 0
machine-counted-row = row
machine-counted-word = { $word }
machine-behind-text = the text has { $length } characters: position { $from } is past its end
machine-no-number-in-text = { $parameter } = "{ $text }" is not a number
machine-unknown-system-text = unknown system text ID{ $id } NR{ $number }: only date and time (ID10321) are supported
machine-no-table = no table is open
machine-several-columns = { $parameter } = { $text } names several columns: only one can be read through a text parameter
machine-no-column = table { $table } has no column { $column }; its columns are { $columns }
machine-no-row = table { $table } has no row { $row }: its rows are 0 to { $last }
machine-no-rows = table { $table } has no rows
machine-empty-cell = table { $table }, row { $row }, column { $column }: the cell is empty
machine-no-number-in-cell = table { $table }, row { $row }, column { $column }: { $cell } is not a number
machine-touches = table { $table }, row { $row }, column { $column }: the cell runs into its neighbour, so its value is uncertain
machine-table-write = table { $table }: { $error }
machine-mask = mask { $mask }: { $error }
machine-programmed = the program stopped itself with error { $number }
machine-no-cycle-parameter = cycle { $cycle } has no parameter { $parameter }
machine-cycle-parameter-twice = cycle { $cycle }: { $parameter } is given twice
machine-cycle-parameter-for = cycle { $cycle }: { $parameter } is given twice, and { $other } not at all: is the second one meant as { $other }?
machine-global-not-number = GLOBAL DEF { $number }: { $parameter } has no number
machine-global-twice = GLOBAL DEF { $number }: { $parameter } is given twice
machine-open-subprogram = the program ends within the subprogram that is called in line { $line }: LBL 0 is missing
machine-repeat-ahead = REP repeats the part between a label and this block, but the label comes after it, in line { $line }
machine-cycle = cycle { $cycle }: { $error }
machine-workpiece = workpiece: { $error }
machine-no-tool-call = no TOOL CALL with a tool axis comes before this measuring cycle
machine-mode = the control is in { $mode } mode: measuring cycles run in milling mode only (FUNCTION MODE MILL)
machine-changed = { $change } has been active since line { $line }, { $text }: Fitcheck does not measure while it is active
machine-nothing-selected = no SEL PGM comes before CALL SELECTED PGM
machine-no-datum-table = the datum would go into row { $row } of the active datum table (Q303 = 0), which only the control has: nothing can be measured from it here
machine-datum-in-tilt = the plane has been tilted since line { $line }, { $text }: Fitcheck sets no datum in it, because what a control writes there is not known; reset the plane before the cycle (PLANE RESET)
machine-point-without-part = cycles 0 and 1 probe a single point, and a perfect workpiece has none: choose a simulated workpiece or recorded contacts
machine-point-from-nowhere = where the probing begins is not known in all axes: write X, Y and Z in the block
machine-no-preset = { $table } has no row { $row }
machine-preset-locked = { $table }: row { $row } is locked, so the cycle cannot write it
machine-shifted-preset = row { $row } is the active preset, and a datum shift is active: what a control makes of the shift is not known
machine-change-not-known = an unknown datum
machine-change-turning = the turned system of cycle 800
machine-change-datum-table = a shift from a datum table
machine-change-rotation = a rotation
machine-change-mirror = mirroring
machine-change-scaling = scaling
machine-change-axis-scaling = scaling of single axes
machine-change-tilt = a tilted plane
machine-change-tilted-shift = a shift from a plane that is no longer tilted
machine-change-axis-turned = a turn of the part by a rotary axis, without a new datum in both axes of the plane since,

## Remarks
machine-file-from = { $path } was read from { $file }
machine-file-given = { $path } was read
machine-file-built-in = { $path } is built in
machine-remark-skipped = unknown block skipped
machine-remark-cycle-passed-over = this cycle calibrates the probe or measures a tool: it was passed over. What it returns is undefined from here on, unless it was given before the run (--set Q115=0)
machine-remark-measurement-skipped = this measurement was skipped: its results are undefined from here on
machine-remark-datum-skipped = this measurement was skipped: its results are undefined from here on, and nothing is measured after it, because it may set a datum
machine-remark-not-followed = this block is not run and may change the datum: nothing is measured after it
machine-remark-no-system-data = { $parameter } is undefined from here on: only a control knows the system data of FN 18
machine-remark-axis-assumed = no TOOL CALL comes before this cycle: measured along Z with the first probe
machine-remark-measured-again = measured again after rework: this measurement counts
machine-remark-spindle-turns = the spindle turns since M{ $function }: a control would not probe
machine-remark-rotary-moved = { $axes } moved before this cycle: the workpiece was measured as if it had not been turned
machine-remark-other-preset = preset { $number }: the workpiece is assumed to lie there, too
machine-remark-rotation-ended = the basic rotation of { $angle } has ended: this cycle measures without it, and it stays off
machine-remark-axes-as-tilted = the plane is tilted: the rotary axes are taken to stand as it needs them
machine-remark-machine-zero-assumed = FN 18 asks for a place from the zero of the machine: where that is is not known here, and the place counts from the zero of the workpiece
machine-remark-datum-set = datum set: its zero is now at { $zero } mm in the coordinates of the workpiece
machine-remark-preset-set = row { $row } of the preset table set to { $zero } mm in the coordinates of the workpiece: it acts with cycle 247
machine-remark-active-preset-set = row { $row } is the active preset: its zero is now at { $zero } mm in the coordinates of the workpiece; on an iTNC 530 only after cycle 247
machine-remark-presets-left = { $path } stays as it is: no cycle 247 before says which row is active, so it is not known where the workpiece lies on the machine
machine-remark-shift-ended = the datum shift ended in { $axes } without having been measured there, as on a TNC7: an iTNC 530 may keep it
machine-remark-built-in = { $path } is not among the given files: the built-in one was read
machine-remark-other-names = { $read } was read, but { $others } also exists: a control has only one file of each name
machine-remark-read = { $path }: { $what }
machine-remark-other-spelling = table { $table } has no column { $column }: { $other } was used, the other spelling in NC-Solution 8255
machine-remark-row-number = table { $table }: NR is { $found } in row { $row }: FN 27 and FN 28 count rows from 0
machine-remark-length-converted = table { $table }: column { $column } is a LENGTH and was converted between mm and inches
machine-remark-ended-within = M{ $function } in a called program ended the run: a control does not allow it there
machine-remark-given-wins = { $parameter } = { $value } was given before the run and replaces this block's value
machine-remark-given-without-effect = { $parameter } was given before the run and had no effect: no block read it
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = the block leaves out { $parameters }: these values were used, but a control may refuse the block
machine-remark-measurement-behind-end = { $count ->
        [one] a measuring cycle comes
       *[other] { $count } measuring cycles come
    } after this block, where a control stops reading: nothing after it was measured
machine-remark-cycle-skipped = this measuring cycle was skipped as requested, because of the / before it
machine-remark-rounded = table { $table }, column { $column }: { $value } was rounded to { $written }
machine-remark-not-judged = no verdict here: nothing was compared with limits
machine-remark-not-written = { $path } was not written: no output folder was chosen
machine-remark-deleted = { $path } was deleted by the program
machine-remark-not-deleted = { $path } was not deleted: no output folder was chosen
machine-remark-other-device = { $given } is another device: the file is { $path }
machine-remark-screen-meant = SCREEN is taken as the name of a file: was SCREEN: meant?
machine-remark-empty-mask = the mask { $mask } is empty: so is what it prints
machine-remark-not-saved = { $path } was not written: { $reason }
machine-remark-full = { $path } has reached its limit of { $kilobytes } kilobytes: nothing was added
machine-remark-table-written = { $path } was written
machine-remark-contacts-left = the cycles used { $used } of { $count } recorded contacts
machine-remark-more = { $count } more remarks are not listed
machine-remark-empty-spindle = tool 0 was called: a TNC7 then has no probe in the spindle
machine-remark-no-tool-named = no TOOL CALL before this cycle names a tool: measured with the first probe
machine-remark-tool-call-words = TOOL CALL does not take { $words }: skipped
machine-remark-no-nominal = the cycle has no nominal size: the probe meets the perfect workpiece half-way along K
machine-remark-other-probe = tool { $tool } is not in the touch-probe table: probe { $probe } was used
machine-remark-collision = the { $mover } would touch { $feature }, with the centre of the ball at X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = moves are not checked in full against { $features }
machine-remark-stylus-unchecked = the stylus is not checked for collisions: it does not stand along Z
machine-remark-tool-offsets = { $offsets } of the TOOL CALL does not change the simulated probe
machine-remark-tool-locked = tool { $tool } is locked in the tool table
machine-remark-no-probe-tool = tool { $tool } is not a touch probe: TYP = { $kind }, expected { $probe }
machine-remark-no-such-tool = tool { $tool } is not in the tool table
machine-remark-same-name = { $more ->
    [one] another tool has the name { $tool }
   *[other] { $more } more tools have the name { $tool }
}: the first one in the tool table was used
machine-remark-content-uncertain = { $parameter } is read here, but it is not documented that it holds the diameter
machine-remark-not-waited = { $parameter } is read without G909 after the cycle: a control reads blocks ahead and may not have measured yet
machine-remark-position-unknown = the position before the cycle is not known: without D it begins at the nominal center, without WB at height 0

machine-passed-over = { $count } { $count ->
        [one] block
       *[other] blocks
    } on which no measurement depends { $count ->
        [one] was
       *[other] were
    } passed over: { $list }

## Pauses
machine-pause-stop = the program has stopped: STOP or M0
machine-pause-optional-stop = the program has stopped: M1
machine-pause-breakpoint = the next block has a breakpoint
machine-pause-log = the measuring log is on the screen (Q281 = 2)

## A block of a measuring cycle without its program
alone-moved = { $text } moves the probing cycle after it or changes its axes, but the cycle is run as if it did not: run the whole program instead
alone-called = { $text } runs blocks that may move the probing cycle after it, but they are not read: run the whole program instead
alone-not-understood = { $text } is not understood and may move the probing cycle after it: check the program, or run it as a whole
alone-not-run = the program goes no further than { $text } and does not reach the probing cycle after it, so a control does not measure here: check the program
alone-passed = { $text } can go past the probing cycle, so a control may not measure here: run the whole program instead
alone-skipped = a control may skip the probing cycle because of the / before it: if it must be measured, delete the /
