## The program page

page-program = Programs
program-page-dialog-open = Open an NC program
program-page-choice = NC program
program-page-open = Open…
program-page-not-shipped = { $name } is not included in this version
program-page-nothing = No program is open
program-page-listing = { $name }, { $count ->
    [one] { $count } block
   *[other] { $count } blocks
  }

program-page-run = Run
program-page-pause = Pause
program-page-step = Single block
program-page-step-over = Step over
program-page-to-selected = To cursor
program-page-breakpoint = Breakpoint
program-page-reset = Reset
program-page-move = Go to another block
program-page-speed = Speed
program-page-speed-slow = 4 blocks/s
program-page-speed-medium = 20 blocks/s
program-page-speed-fast = full speed
program-page-options = Options
program-page-skip-unknown = Skip unknown blocks
program-page-assume-tool = Probe along Z without TOOL CALL
program-page-block-skip = Skip blocks with /
program-page-optional-stop = Stop at M1
program-page-outline-none = heading or label
program-page-outline = Go to

program-page-state-ready = Ready to run
program-page-state-running = Running
program-page-state-paused = Paused
program-page-state-step = Single block
program-page-state-breakpoint = Paused at a breakpoint
program-page-state-goal = Paused at the cursor
program-page-state-over = Paused after the call
program-page-state-stop = The program stopped itself: Run continues
program-page-state-optional-stop = The program stopped itself with M1: Run continues
program-page-state-tolerance = Out of tolerance: { $stop }
program-page-state-log = The log is on the screen: Run continues
program-page-state-ended = Ended after { $blocks } blocks
program-page-state-fault = Stopped with an error
program-page-refused-inputs = An input cannot be read
program-page-refused-none = No program is open
program-page-refused-workpiece = The workpiece cannot be read
program-page-refused-no-contacts = No contacts are open

program-page-has-breakpoint = breakpoint
program-page-is-current = next block
program-page-is-failed = error here

program-page-inputs = Inputs
program-page-answers = Fitcheck and the program
program-page-program = Program
program-page-verdict = Verdict
program-page-no-limits = No limits: an input cannot be read
program-page-agrees = The program agrees with Fitcheck
program-page-contested = Program { $program }, Fitcheck { $own }
program-page-contested-limits = Program { $program }, by other limits than Fitcheck’s
program-page-stopped-at = Stopped with an error; { $program } so far
program-page-differs = The program differs: { $what }
program-page-differs-minimum = its minimum is { $program } mm, Fitcheck’s { $own } mm
program-page-differs-maximum = its maximum is { $program } mm, Fitcheck’s { $own } mm
program-page-differs-status = it says { $program }, Fitcheck says { $own }
program-page-differs-fault = it stopped with an error
program-page-differs-native-refuses = it gave a verdict, Fitcheck has no limits
program-page-other-inputs = Not compared: the program has set other inputs since and measures another feature
program-page-both-refuse = Neither the program nor Fitcheck gives an answer

program-page-workpiece = Workpiece
program-page-from-perfect = perfect, middle of the limits
program-page-from-nominal = perfect, at nominal
program-page-from-given = perfect, diameter given
program-page-from-simulated = simulated
program-page-from-part = part of several features
program-page-open-part = Open a part…
program-page-dialog-part = Open a simulated part of several features
program-page-refused-no-part = No part is open
program-page-from-recorded = recorded contacts
program-page-workpiece-x = Actual centre X
program-page-workpiece-y = Actual centre Y
program-page-edit-workpiece = Workpiece and probe…
program-page-open-contacts = Other contacts…
program-page-recorded = { $count ->
    [one] { $count } contact
   *[other] { $count } contacts
  } from { $name }
program-page-path = Path of the probe
program-page-no-path = No path yet
program-page-zero = Zero X { $x }, Y { $y }, Z { $z } mm
program-page-turned = turned by { $angle }°
program-page-tilted = tilted A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = The program has opened no window
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, SIMULATED
program-page-cycles = Measured
program-page-show-block = Show the block
program-page-last-of = The last { $shown } of { $all }
program-page-outputs = Files
program-page-outputs-hint = Shown here, not written to disk

program-page-parameters = Parameters
program-page-filter = Filter
program-page-set = Start with
program-page-value = Value
program-page-give = Set
program-page-give-hint = The next run begins with this value
program-page-given = Set for the next run
program-page-drop = remove
program-page-no-parameter = { $given } is not a parameter: write Q5, QL5, QR5 or QS5
program-page-no-number = { $given } is not a number
program-page-none-found = No matching parameter
program-page-no-parameters = Parameters are listed once the program runs
program-page-undefined = undefined
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, changed
program-page-pin = Keep { $parameter } at the top
program-page-unpin = Do not keep { $parameter } at the top
program-page-q108 = radius of the tool
program-page-q109 = tool axis: 0 X, 1 Y, 2 Z
program-page-q110 = spindle: 0 M3, 1 M4, 2 or 3 stopped behind them
program-page-q111 = coolant: 0 off, 1 on
program-page-q113 = unit: 0 mm, 1 inch
program-page-q114 = length of the tool
program-page-q115 = probed position, X
program-page-q116 = probed position, Y
program-page-q117 = probed position, Z
program-page-q150 = measured angle

program-page-problems = { $count ->
    [one] { $count } remark
   *[other] { $count } remarks
  }
program-page-unlisted = { $count ->
    [one] { $count } more is not listed
   *[other] { $count } more are not listed
  }
program-page-at-block = block { $number }: { $what }
program-page-at-line = line { $line }: { $what }

program-page-create = Create for a control…
program-page-create-hint = NC programs, tables and mask with which a control measures for itself
program-page-create-also = write NC programs files set
program-page-create-head = Create for a control
program-page-create-control = Control
program-page-create-language = Dialogue language
program-page-create-from = From
program-page-create-series = For a series: each start measures the next part
program-page-create-texts = Tolerances of diameters as texts of the cycle
program-page-create-callout = { $callout } from Check, at X { $x } Y { $y } Z { $z }
program-page-create-no-callout = The callout on Check
program-page-create-plan = Plan { $name }, { $count ->
    [one] { $count } feature
   *[other] { $count } features
  }
program-page-create-nothing = Enter a callout on Check, or open a plan on Parts
program-page-create-plan-wrong = { $name } has mistakes: open the plan on Parts and correct them
program-page-create-folder = Folder on the control: { $folder }
program-page-create-proven-callout = Read back and run: { $callout } gets exactly Fitcheck’s limits
program-page-create-proven-plan = Read back and run: every feature gets the plan’s limits
program-page-create-clearance-height = The clearance height is { $height } mm; in a plan, a column sets it
program-page-create-files-none = Create files…
program-page-create-files = Create { $count ->
    [one] { $count } file…
   *[other] { $count } files…
  }
program-page-dialog-create = Create files for a control: choose or name a folder
program-page-create-written = { $count ->
    [one] { $count } file was
   *[other] { $count } files were
  } written to { $folder }: { $names }
program-page-create-no-folder = { $name } is a file: name a folder
program-page-contacts-left = The contacts from { $name } belong to the program before: this one measures a perfect workpiece
program-page-unfinished = Not compared: the program did not come to its end
program-page-unknown = { $fault }. To run on without it, switch on Options → Skip unknown blocks
program-page-missing-file = { $fault }. It was looked for in { $folder }, and among the built-in files. Put it there, beside the program, or open the program in the folder that has it
program-page-unknown-datum = { $fault }. Without its datum nothing is measured. For a trial, open a copy of the program without the block that sets it, and a workpiece seen from that datum
program-page-not-written = { $path } would be written on the control. Its text stands under Files; on the command line, fitcheck run --output-folder writes it
program-page-no-verdict = No limits, no verdict
