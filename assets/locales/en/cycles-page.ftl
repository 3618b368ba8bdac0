# The cycles page: the form of a measuring cycle, its workpiece, its path and its results.

page-cycles = Cycles

cycles-cycle = Cycle
cycles-choose = Cycle { $number } { $name }
cycles-group-position = Position
cycles-group-probing = Probing
cycles-group-tolerance = Tolerance
cycles-group-output = Output
cycles-optional-position = Position, optional
cycles-optional-probing = Probing, optional
cycles-optional-tolerance = Tolerance, optional
cycles-optional-output = Output, optional
cycles-contacts-from = Contacts from
cycles-perfect = Perfect part
cycles-simulated = Simulated
cycles-recorded = Recorded
cycles-workpiece = Workpiece…
cycles-suit = Match workpiece to cycle
cycles-open-contacts = Contacts…
cycles-no-file = no file yet
cycles-contacts-of = { $count ->
    [one] { $count } contact
   *[other] { $count } contacts
    }, { $file }
cycles-probe = Probe
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Own touch-probe table…
cycles-shipped-probes = Built-in table
cycles-run = Run
cycles-needed = required
cycles-none = none
cycles-predef = PREDEF stands for
cycles-predef-missing = PREDEF: type the value that GLOBAL DEF gives
cycles-without-effect = Accepted without effect
cycles-position = Ball position
cycles-ball-stands = Ball is at
cycles-paste-block = Paste NC block…
cycles-copy-block = Copy as NC block
cycles-copy-results = Copy results
cycles-block-copied = The NC block was copied
cycles-block = NC block
cycles-block-hint = Paste a block such as TCH PROBE 427 … Q263=+35 ;TEXT ~ or G785 R0 BR0 K2: it replaces the form
cycles-fill = Fill the form

cycles-nothing-seen = Path and contacts appear after a run: press Enter or F5
cycles-allowed = Allowed: { $range } { $unit }
cycles-must-be-given = Required
cycles-may-be-left-out = Optional
cycles-default = { $value } if left empty
cycles-may-be-predef = PREDEF is allowed
cycles-path = Path of the ball
cycles-first = First
cycles-back = Back
cycles-next = Next
cycles-last = Last
cycles-move = Move
cycles-phase-pre-position = pre-position
cycles-phase-approach = approach
cycles-phase-contact = contact
cycles-phase-retract = retract
cycles-phase-leave = leave
cycles-move-contact = { $number } of { $count }: { $phase } { $touch }, at { $to }
cycles-move-of-touch = { $number } of { $count }: { $phase }, contact { $touch }, from { $from } to { $to }
cycles-move-of-none = { $number } of { $count }: { $phase }, from { $from } to { $to }
cycles-criteria = Criteria side by side

cycles-word-stopped = Not measured
cycles-word-no-verdict = No verdict
cycles-no-limits = no limits were given
cycles-no-limits-marked = no limits were given; a control then reports within tolerance
cycles-more-out = { $what }, { $count } more below
cycles-no-window = No limits of size: the control shows no status window
cycles-results = Result parameters
cycles-log-file = The control writes { $name }
cycles-log-screen = The control stops and shows its log on screen
cycles-log-shown = The control shows the result on screen
cycles-save-log = Save log…
cycles-dialog-save-log = Save the measuring log
cycles-no-log = no log to save
cycles-from-perfect = Measured on a perfect workpiece at nominal size, with a point as the probe
cycles-from-simulated = Measured on the simulated workpiece, seed { $seed }
cycles-from-recorded = Contacts from { $file }
cycles-unused = The cycle left { $count ->
    [one] one contact
   *[other] { $count } contacts
    } of the file unused

cycles-fields-wrong = { $count ->
    [one] one field
   *[other] { $count } fields
    } cannot be used: see the form
cycles-no-workpiece = the simulated workpiece is not complete
cycles-workpiece-wrong = simulated workpiece: { $problem }
cycles-workpiece-field = { $name }: { $problem }
cycles-no-contacts = no file of contacts has been opened yet
cycles-cannot-suit = No workpiece matches yet: { $problem }
cycles-not-written = the workpiece cannot be written: { $reason }
cycles-contacts-loaded = Contacts of { $name } are used
cycles-column-ignored = column { $column } is skipped
cycles-probes-loaded = Touch-probe table { $name } is used
cycles-dialog-contacts = Open recorded contacts
cycles-dialog-workpiece = Open a simulated workpiece
cycles-dialog-probes = Open a touch-probe table
cycles-dialog-save-workpiece = Save the simulated workpiece

cycles-open-workpiece = Open…
cycles-save-workpiece = Save…
cycles-shape-bore = Hole
cycles-shape-stud = Shaft
cycles-shape-face = Face
cycles-shape-point = Free surface point
cycles-shape-slot = Slot
cycles-shape-ridge = Ridge
cycles-shape-pocket = Pocket
cycles-shape-boss = Boss
cycles-plane = Plane
workpiece-probe = Probe
workpiece-machine = Scatter and temperature
workpiece-centre-1 = Centre, 1st axis
workpiece-centre-2 = Centre, 2nd axis
workpiece-ovality-angle = Ovality angle
workpiece-lobe-angle = Lobe angle
workpiece-point-x = Point X
workpiece-point-y = Point Y
workpiece-point-z = Point Z
workpiece-normal-x = Normal X
workpiece-normal-y = Normal Y
workpiece-normal-z = Normal Z
workpiece-wave-height = Wave amplitude
workpiece-wave-length = Wave length
workpiece-wave-x = Wave direction X
workpiece-wave-y = Wave direction Y
workpiece-wave-z = Wave direction Z
workpiece-deviation = Deviation along the normal
workpiece-radius = Radius of the surface
workpiece-width = Width
workpiece-length-1 = 1st length
workpiece-length-2 = 2nd length
workpiece-angle = Angle of the walls
workpiece-ball = Ball radius
workpiece-trigger = Trigger scatter 1σ
workpiece-calibration = Calibration error
workpiece-offset-x = Offset of the ball X
workpiece-offset-y = Offset of the ball Y
workpiece-lobing-count = Lobes of the pre-travel
workpiece-lobing = Pre-travel amplitude
workpiece-lobing-angle = Pre-travel angle
workpiece-temperature = Workpiece temperature
workpiece-expansion = Expansion

cycles-choice-move-to-clearance-0 = at measuring height
cycles-choice-move-to-clearance-1 = at clearance height
cycles-choice-clearance-mode-minus-1 = never at clearance height
cycles-choice-clearance-mode-0 = before and after the cycle
cycles-choice-clearance-mode-1 = before and after each object
cycles-choice-clearance-mode-2 = at each contact
cycles-choice-traverse-0 = straight
cycles-choice-traverse-1 = on an arc
cycles-choice-contact-count-3 = contacts
cycles-choice-contact-count-4 = contacts
cycles-choice-contact-count-5 = contacts
cycles-choice-contact-count-6 = contacts
cycles-choice-contact-count-7 = contacts
cycles-choice-contact-count-8 = contacts
cycles-choice-contact-count-9 = contacts
cycles-choice-log-0 = no log
cycles-choice-log-1 = log in a file
cycles-choice-log-2 = stop, log on screen
cycles-choice-stop-0 = no stop
cycles-choice-stop-1 = stop if out of tolerance
cycles-choice-stop-on-undersize-0 = no stop
cycles-choice-stop-on-undersize-1 = stop if out of tolerance
cycles-choice-stop-on-undersize-2 = stop on undersize only
cycles-choice-stop-on-scrap-0 = no stop
cycles-choice-stop-on-scrap-1 = stop if out of tolerance
cycles-choice-stop-on-scrap-2 = stop for scrap only
cycles-choice-measured-axis-1 = reference axis X
cycles-choice-measured-axis-2 = minor axis Y
cycles-choice-measured-axis-3 = probe axis Z
cycles-choice-axis-of-plane-1 = reference axis X
cycles-choice-axis-of-plane-2 = minor axis Y
cycles-choice-direction-minus-1 = negative direction
cycles-choice-direction-1 = positive direction
cycles-choice-directed-axis-minus-3 = probe axis Z, negative direction
cycles-choice-directed-axis-minus-2 = minor axis Y, negative direction
cycles-choice-directed-axis-minus-1 = reference axis X, negative direction
cycles-choice-directed-axis-1 = reference axis X, positive direction
cycles-choice-directed-axis-2 = minor axis Y, positive direction
cycles-choice-directed-axis-3 = probe axis Z, positive direction
cycles-choice-tool-axis-probing-0 = left as it is
cycles-choice-tool-axis-probing-1 = probed and set
cycles-choice-transfer-minus-1 = not stated
cycles-choice-transfer-0 = datum table
cycles-choice-transfer-1 = preset table
cycles-choice-preset-correction-0 = left as it is
cycles-choice-preset-correction-1 = corrected by the point
cycles-choice-preset-correction-2 = corrected by the 2nd point
cycles-choice-preset-correction-3 = corrected by the middle of both
cycles-choice-compensation-axis-0 = axis of the measured angle
cycles-choice-compensation-axis-4 = axis A
cycles-choice-compensation-axis-5 = axis B
cycles-choice-compensation-axis-6 = axis C
cycles-choice-zero-after-alignment-0 = keeps its value
cycles-choice-zero-after-alignment-1 = reads zero
cycles-choice-rotary-alignment-0 = stay
cycles-choice-rotary-alignment-1 = turn, the probe goes along
cycles-choice-rotary-alignment-2 = turn alone
cycles-choice-rotation-transfer-0 = changes nothing
cycles-choice-rotation-transfer-1 = basic rotation
cycles-choice-rotation-transfer-2 = offset of the rotary axis
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = inside
cycles-choice-side-1 = outside
cycles-choice-geometries-0 = two holes
cycles-choice-geometries-1 = two studs
cycles-choice-geometries-2 = a hole and a stud
cycles-choice-geometries-3 = a stud and a hole

## The tool table

tools = Tool table
tools-none = none
tools-open-one = { $name }, { $count ->
    [one] one tool
   *[other] { $count } tools
  }
tools-open = Open a tool table…
tools-close = No tool table
tools-save = Save tool table…
tools-save-hint = The table with these changes. The next run begins with the table as it was opened.
tools-dialog-open = Open a tool table
tools-dialog-save = Save the changed tool table
tools-loaded = Tool table { $name } is used
tools-pick = choose a tool
tools-pick-of = { $parameter } from the tool table
tools-input = { $parameter } Tool for monitoring (Q330)
tools-fixed = Q330 = { $tool } in the program
tools-more = { $count ->
    [one] one more tool
   *[other] { $count } more tools
  }
tools-row = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, locked
tools-without-name = { $count ->
    [one] one tool is not listed: its name does not identify it
   *[other] { $count } tools are not listed: their names do not identify them
  }
tools-not-in-table = Q330 = { $tool }: the tool table has no such tool
tools-not-monitored = Without a tool table, no tool is monitored (Q330)
tools-none-named = Q330 names no tool: the tool table is not used
tools-no-deviation = the measured value does not deviate: the tool is not changed
tools-changed = Changed in the tool table
tools-nothing-changed = no run has changed the tool table

## A part of several features

cycles-part-refused = the file has [[feature]] tables: a cycle on its own measures one surface; the programs page and fitcheck run measure such a part
part-features = Features of the part
part-of-features = { $name }, { $count ->
    [one] one feature
   *[other] { $count } features
  }, ball radius { $ball } mm
part-round = { $name }: { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name }: { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name }: { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name }: { $kind } X { $x } Y { $y } Z { $z }
