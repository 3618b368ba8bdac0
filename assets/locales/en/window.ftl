# The window: labels, buttons, headings. Sentence case, no colon after a label, an ellipsis on what opens a dialog.

page-check = Check
page-fit = Fits
page-tables = Tables
import = Import…
export = Export
export-people = Inspection report ({ $format })…
export-programs = History as { $format }…
export-status-check = Status window of Check as text…
export-status-cycle = Status window of cycle { $cycle } as text…
export-status-program = Window of the program as text…
menu = Menu
language = Language
theme = Appearance
theme-system = Follow system
theme-light = Light
theme-dark = Dark
theme-contrast = High contrast on white
theme-inverted = High contrast on black
density = Size of controls
density-by-use = Automatic
density-mouse = Mouse
density-touch = Touch
limits-from = Limits from
standard-js-rounded = Round JS half-micrometres down, as in 1988
standard-1988 = cd, ef and fg only up to 10 mm, as in 1988
load-tables = Own tables…
no-own-tables = Stop using own tables
load-mask = Own mask…
undo = Undo
undo-what = Undo: { $what }
undo-add = { $count ->
    [one] add 1 check
   *[other] add { $count } checks
}
undo-correct = correction
undo-feature = hole or shaft
undo-clear = clear history
undone = Undone: { $what }
clear-history = Clear history
choose-bad = { $count ->
    [0] Choose the checks that are not good
    [one] Choose the check that is not good
   *[other] Choose { $count } checks that are not good
}
choose-none = Choose none

callout = Callout
callout-hint = Type a nominal size and a class, such as 25 H7
feature-hole = Hole
feature-shaft = Shaft
feature-neither = Neither
nominal-is = nominal size { $nominal } mm
maximum = Maximum
minimum = Minimum
from-source = from { $source }
source-overrides = Own table: ISO 286 has { $upper } / { $lower } µm, so it differs by { $by-upper } / { $by-lower } µm
measured-value = Measured value
measured-once = Judged already. To judge the same value again, type it again or press the button
by-typing = Type
by-simulating = Simulate
judge = Judge
measure = Measure
clear = Clear
nominal-size = Nominal size
tolerance-class = Class
class-none = Choose
classes-hole = Hole classes
classes-shaft = Shaft classes
part-section = Part
part-name = Part or feature

probe-position = Probe position
centre-x = Centre X
centre-y = Centre Y
height-z = Height Z
first-contact = First contact
clearance = Set-up clearance
centre-tolerance = Centre tolerance ±
simulated-workpiece = Simulated workpiece
simulated-hint = Leave the diameter empty for the middle of the zone. The seed increases after each measurement; the same seed gives the same contacts.
true-diameter = True diameter
seed = Seed
offset-x = Offset X
offset-y = Offset Y
ovality = Ovality
lobes = Lobes
lobe-height = Lobe height
surface-scatter = Surface scatter 1σ
probe-scatter = Probe scatter 1σ

field-range = { $given } is outside −{ $limit } to { $limit }
field-not-negative = { $given } is below 0: 0 to { $limit } is allowed
field-above-zero = { $given } is not above 0: up to { $limit } is allowed
field-not-whole = { $given } is not a whole number

limit-band = Limit band
band-example = an example: { $callout }, a hole
band-empty = The limit band appears with the limits
band-describe = Deviation from nominal size in micrometres: zone from { $lower } to { $upper }, { $left } below it, { $right } above it.
band-describe-measured = Measured { $deviation }, { $above } above the minimum, { $below } below the maximum.
side-rework = rework
side-scrap = scrap
side-out = out of limits

last-values = Last values
last-values-empty = The last values of these limits appear here
last-values-describe = { $count ->
    [one] The last value, newest last:
   *[other] The last { $count } values, newest last:
}
contacts = Contacts
contacts-factor = deviations × { $factor }
contacts-empty = The contacts appear with the measurement
contacts-describe = { $count } contacts seen from above, deviations magnified { $factor } times. { $circle }
centre-is = centre { $x } / { $y }

word-none = No result
nothing-measured = Nothing was measured
judged-without-own = Judged without your own tables
word-question = Is this right?
simulated = SIMULATED
status-simulated = { simulated } { $status }
judge-anyway = Judge { $measured } mm as it is
take-meant = Use { $meant } mm
take-text = Use { $meant }
keep-text = Judge by { $given } as it is
doubted-enter = Enter uses the highlighted button; typing replaces the text
doubted-type = Nothing is judged until the text is typed again or used as it is
question-enter = After half a second, Enter presses the filled button; typing replaces the value
doubt-sentence = The { $doubt }
lot-title = { $rows ->
    [one] { $name }: 1 row
   *[other] { $name }: { $rows } rows
}
lot-unjudged = { $count } not judged
lot-refused = { $count ->
    [one] 1 row refused
   *[other] { $count } rows refused
}
lot-doubted = { $count ->
    [one] 1 doubtful value
   *[other] { $count } doubtful values
}
lot-shown = Shown: { $place } of { $judged }, worst first; line { $line }
lot-shown-part = Shown: { $place } of { $judged }, worst first; line { $line }, part { $part }
lot-worst = Worst
lot-worse = Worse
lot-better = Better
lot-best = Best
lot-count = { $status } { $count }
above-minimum = { $um } µm above minimum
below-minimum = { $um } µm below minimum
below-maximum = { $um } µm below maximum
above-maximum = { $um } µm above maximum
remove-amount = Remove { $um } µm
remove-to-limit = to the nearest limit
remove-to-limit-per-side = to the nearest limit, { $um } µm per side
remove-to-middle = { $um } µm to the middle of the zone
position-in = Centre in position
position-out = Centre out of position
diameter-alone = Diameter alone: { $status }
first-steps = First steps
first-steps-title = First time here?
first-steps-about = These settings are kept.
first-steps-done = Done
first-way-part = A whole part
first-way-part-about = Feature by feature, by a plan with a picture.
first-way-file = A file of values
first-way-file-about = CSV, a workbook, QIF, AQDEF or a measuring log.
first-way-program = Without a machine
first-way-program-about = An NC program or a cycle measures a simulated hole, contact by contact.
first-step-callout = 1. Callout: what the drawing says
first-step-value = 2. Measured value: typed, simulated, or from a file
first-step-verdict = 3. Verdict, and how much to remove
why = Why?
why-limits = Limits from { $what }
why-measured = Measured value: { $what }
why-rule = Rule: { $what }
why-caveat = Limit of this measurement: { $what }

popup-title = Status window
popup-title-accepted = Status window: outside the limits, accepted by the rule
popup-title-simulated = Status window, SIMULATED
popup-exact = The window rounds to four decimals. Exact values: { $values }
popup-empty = No measurement yet
copy = Copy
mask-choice = Mask
mask-choice-of-language = Window language
mask-choice-own = Own mask…

history = History
history-count = { $count ->
    [0] no checks
    [one] 1 check
   *[other] { $count } checks
}
history-chosen = { $count } chosen for export
history-hidden = { $hidden } of them not listed
history-shown = { $shown } of { $count ->
    [one] 1 check
   *[other] { $count } checks
}
history-exported-listed = { $count ->
    [0] No check is listed: nothing to export
    [one] The 1 listed check of { $all } will be exported
   *[other] The { $count } listed checks of { $all } will be exported
}
rows-exported = The { $listed } listed rows of { $name } will be exported, in the order of the list
rows-export-not-yet = The rows can be exported when they are all judged and listed
history-exported = { $count ->
    [0] Nothing to export
    [one] 1 check will be exported
   *[other] All { $count } checks will be exported
}
history-cleared = { $count ->
    [one] 1 check removed from the history. Undo (Ctrl+Z) brings it back.
   *[other] { $count } checks removed from the history. Undo (Ctrl+Z) brings them back.
}
history-none-found = No check matches the filter
history-filter = Filter
history-filter-hint = Lists the checks that contain these words: part, callout, value, date, status or file
history-only-bad = Only not good
history-only-bad-hint = Rework, re-measure and scrap
history-sort-hint = Sorts by this column; press again to reverse the order, once more for newest first
history-ascending = { $column }, sorted ascending
history-descending = { $column }, sorted descending
history-list = Checks in the history
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, chosen for export
history-move = Go to another check
history-show = Show the check
history-choose = Choose for export
choose-all = Choose all listed
copy-checks = Copy for a spreadsheet
history-empty = Checks appear here, the newest first
head-time = Date and time
head-part = Part
head-callout = Callout
head-measured = Measured
head-deviation = Deviation
head-status = Status
head-from = From
choose-check = Choose { $check } of { $time } for export

dialog-import = Import measurements
dialog-mask = Own mask
dialog-tables = Folder with own tables
dialog-export = Export
dialog-export-rows = Export the listed rows
dialog-export-status = Export the status window
file-path = File
folder-path = Folder
dialog-open = Open
dialog-save = Save
dialog-browse = Browse…
dialog-cancel = Cancel
dialog-busy = Working…
dialog-no-path = A path is missing
dialog-no-status = No status window to save
dialog-browse-hint = Shows the system's file dialog
dialog-up = Parent folder
dialog-home = Home folder
dialog-all-files = All files
file-kind-measurements = Measurements
file-kind-mask = Masks
file-kind-own-tables = Folders of tables
file-kind-report = Reports
file-kind-rows = Rows
file-kind-status = Text
file-kind-table = Tables
file-kind-contacts = Contacts
file-kind-workpiece = Simulated workpieces
file-kind-probes = Touch-probe tables
file-kind-log = Measuring logs
file-kind-program = NC programs
file-kind-part = Simulated parts
file-kind-set = Files for a control
file-kind-tools = Tool tables
file-kind-plan = Part plans
file-kind-picture = Pictures
file-kind-watched = Watched folders
file-kind-budget = Uncertainty budgets
file-kind-chart = Charts
file-kind-readings = Readings
file-kind-study = Readings of a gauge
dialog-move = Go to another entry
dialog-recent-folders = Recent folders
dialog-exists = { $name } already exists. Replace it?
dialog-exists-set = { $name } already exists in this folder. Replace the files of the set there?
dialog-replace = Replace
dialog-keep = Keep
dialog-nothing-picked = The system's dialog returned no file. Choose one in the list, or type a path.
dialog-list = Folder { $folder }
dialog-entries = Files and folders
dialog-list-none = No folder is open: type a path
dialog-list-reading = Reading the folder…
dialog-list-empty = Nothing to choose in this folder
dialog-list-more = Only the first { $most } entries are listed: type the name of another one
dialog-is-folder = Folder
file-name-checks = checks
open-written = Open
show-in-folder = Show in folder
launch-failed = the file cannot be opened: { $reason }
recent-files = Recent files
forget-recent = Clear the list
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] 1 entry is not shown
   *[other] { $count } entries are not shown
}
file-bytes = { $count } B
file-kilobytes = { $count } kB
file-megabytes = { $count } MB
notice = Note
copied = { $lines ->
    [one] Copied, one line
   *[other] Copied, { $lines } lines
    }
notice-problem = Error
notice-more = { $count ->
    [one] 1 more message follows
   *[other] { $count } more messages follow
}
messages = Earlier messages
messages-forget = Empty this list
messages-count = { $count ->
    [one] 1 earlier message
   *[other] { $count } earlier messages
}
close = Close
file-written = { $name } was written to { $folder }
file-written-here = { $name } was written
tables-loaded = { $count ->
    [one] 1 table is used from { $folder }
   *[other] { $count } tables are used from { $folder }
}
mask-loaded-with-warnings = { $name } was read with warnings
state-set-aside = The saved state could not be read. It was kept as { $path }, and the window starts with default settings.
state-set-aside-now = The saved state can no longer be read. It was kept as { $path }, and the state of this window is saved in its place.
state-not-kept = The state of this window is not saved: { $reason }
import-contacts-not-judged = The contacts in { $name } were not judged
import-notice = { $name }: { $good ->
    [0] no check
    [one] 1 check
   *[other] { $good } checks
}, { $bad ->
    [0] no rows refused
    [one] 1 row refused
   *[other] { $bad } rows refused
}
import-counted = { $file }. { $counts }
check-said-afterwards = said after the verdict: { $as }
lot-open = { $count ->
    [one] One value waits for hole or shaft:
   *[other] { $count } values wait for hole or shaft:
}
check-all-holes = All are holes
check-all-shafts = All are shafts
check-judged-again = { $count ->
    [one] One value outside its limits was judged again: { $as }
   *[other] { $count } values outside their limits were judged again: { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Show
notice-open-in = Open in { $page }
judge-unplanned = Open in Check
sample-not-recorded = A sample is not recorded.
limits-own-first = First from own tables: { $names }
limits-own-stay = Own tables are still asked first: { $names }. Menu, Limits from, stops using them.
measured-needs-value = Type the measured value
measured-needs-limits = No limits to judge by: type a callout first

keypad = Keypad
key = Key
key-blank = Space
key-decimal = Decimal sign
key-minus = Minus
edge-left = Edge of the left panel: arrow keys move it
edge-right = Edge of the right panel: arrow keys move it
edge-top = Edge of the upper panel: arrow keys move it
edge-bottom = Edge of the lower panel: arrow keys move it
key-letters = Letters
key-holes = Classes of holes
key-shafts = Classes of shafts
key-more-letters = M to X
key-signs = Y, Z and signs
key-figures = Figures
key-shift = Upper or lower case
key-back = Delete last character
key-clear = Empty
key-enter = Enter

## Table page
tables-choice = Table
tables-kind-shipped = built in
tables-kind-own = own
tables-kind-file = from a file
tables-kind-copy = copy
tables-kind-made = from ISO 286
tables-unsaved = not saved
tables-open = Open…
tables-save = Save as
tables-redo = Redo
tables-use = Use this table for limits
tables-in-use = Used for limits
tables-filter = Filter
tables-filter-hint = Classes such as H7 g6, letters, grades, or a size in mm
tables-shown = { $count ->
    [one] { $shown } of 1 class
   *[other] { $shown } of { $count } classes
}
tables-only-differences = Differences only
tables-unmatched = no match for { $words }
tables-agrees = { $count ->
    [one] agrees with ISO 286 in its 1 cell
   *[other] agrees with ISO 286 in all { $count } cells
}
tables-differs = { $count ->
    [one] 1 of { $compared } cells differs from ISO 286
   *[other] { $count } of { $compared } cells differ from ISO 286
}
tables-compared-nothing = nothing to compare with ISO 286
tables-own-classes = { $count ->
    [one] 1 own class
   *[other] { $count } own classes
}
tables-own-class = own
tables-previous = Previous difference
tables-next = Next difference
tables-not-saved = Changes are not saved
tables-keys = Arrow keys move, Enter edits, Delete empties, F8 goes to the next difference, Ctrl+F to the filter
tables-move = Go to another cell
tables-edit-cell = Edit the cell
tables-grid = Deviations of { $name } in µm
tables-range-head = over – up to, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = empty
tables-cell = { $class }, over { $over } up to { $to } mm, { $figures }
tables-cell-differs = { $class }, over { $over } up to { $to } mm, { $figures }, differs from ISO 286
tables-no-columns = The table has no class
tables-upper = Upper
tables-lower = Lower
tables-head-table = Table, µm
tables-head-standard = ISO 286
tables-head-by = off by
tables-cell-agrees = As in ISO 286
tables-cell-off = ISO 286 has { $upper } / { $lower } µm; the table is off by { $upper-by } / { $lower-by } µm
tables-more-differences = and { $count } more
tables-cell-missing = Empty here; ISO 286 has { $upper } / { $lower } µm
tables-cell-empty = Empty here, and not defined in ISO 286
tables-defined = In ISO 286 the class is defined { $ranges }
tables-shipped-hint = A built-in table is never changed: an edit makes a copy and shows the copy.
tables-set = Set
tables-take-standard = Use ISO 286
tables-empty-cell = Empty
tables-remove-column = Remove { $class }
tables-from-standard = From ISO 286
tables-classes = Classes, such as H7 K7 P9
tables-add-columns = Add to this table
tables-up-to = Sizes up to
tables-make = New table
tables-order = upper deviation { $upper } µm is below lower deviation { $lower } µm
tables-used-edited = { $name } gives the limits: checks use the change from now on
tables-used = Limits are looked up in { $name } first, until the window is closed. To keep using it, save it in the folder of own tables.
tables-read-with-warnings = { $name } was read with warnings
tables-nothing-read = The file holds no table of deviations
tables-nothing-to-save = No table is open
tables-cell-unreadable = The values of the selected cell cannot be read: correct them first
tables-too-many = { $count } tables with unsaved changes are open: save one first
tables-dialog-open = Open a table
tables-dialog-save = Save the table
## Fit page
fit-callout = Fit of hole and shaft
fit-callout-hint = Type a nominal size and both classes, such as 25 H7/g6
fit-example = an example: { $callout }
fit-shaft-missing = The shaft's class is missing, such as g6 in 25 H7/g6
fit-hole-missing = The hole's class is missing, such as H7 in 25 H7/g6
fit-classes-missing = A fit has the classes of hole and shaft, such as 25 H7/g6
fit-preferred = Preferred fit
fit-function = Function
fit-list-hole-basis = Hole basis
fit-list-shaft-basis = Shaft basis
fit-parts = Actual parts
fit-hole-measured = Measured hole
fit-shaft-measured = Measured shaft
fit-temperature = Temperature
fit-hole-material = Material of the hole
fit-hole-expansion = Hole, µm/(m K)
fit-shaft-material = Material of the shaft
fit-shaft-expansion = Shaft, µm/(m K)
fit-own-value = Own value
fit-press = Press fit
fit-press-length = Length of the joint
fit-hub-outer = Hub outside
fit-shaft-bore = Shaft bore
fit-press-material = A press fit needs a material of the list for both parts: choose one
fit-press-pressure = Joint pressure
fit-press-force = Holds axially
fit-press-torque = Holds as torque
fit-press-pressing = Pressing force
fit-press-hub = Hub stress / yield
fit-press-shaft = Shaft stress / yield
fit-press-heat = Heat the hub to
fit-press-cool = Or cool the shaft to
fit-press-friction = Friction { $friction }; elastic, at 20 °C and at rest. Axial force and torque do not hold both at once
fit-search = Search by clearance
fit-wanted-minimum = Minimum
fit-wanted-maximum = Maximum
fit-scope = Among
fit-scope-all = All classes
fit-scope-basis = Hole and shaft basis
fit-scope-preferred = Preferred and named fits
fit-search-hint = The smallest and the largest clearance; a negative value is an interference. You can add a unit: 7 µm
fit-search-size = The search needs a nominal size: type one above
fit-found = { $count ->
    [one] 1 fit
   *[other] { $count } fits
}
fit-found-first = the best { $count } are listed
fit-found-none = No fit matches. The nearest one
fit-missed-by = { $below } µm too little, { $above } µm too much
fit-is-preferred = preferred

fit-picture = Hole and shaft zones
fit-picture-legend = µm from the zero line; fundamental deviation in bold
fit-picture-empty = The zones appear with the fit
fit-arrow-clearance = Actual clearance
fit-arrow-interference = Actual interference
fit-describe-zero = Zero line at { $nominal } mm.
fit-describe-zone = { $part } { $class } from { $lower } to { $upper } µm.
fit-describe-fundamental = Fundamental deviation { $deviation } µm.
fit-describe-measured = { $part } measured at { $deviation } µm.
fit-classes = Classes at { $nominal } mm
fit-classes-none = Classes
fit-classes-empty = The classes appear with a nominal size
fit-classes-nowhere = No class is defined at this size
fit-staircase = Zones of grade { $grade }

fit-word-clearance = Clearance fit
fit-word-transition = Transition fit
fit-word-interference = Interference fit
fit-word-none = No fit yet
fit-maximum-clearance = Maximum clearance
fit-minimum-clearance = Minimum clearance
fit-maximum-interference = Maximum interference
fit-minimum-interference = Minimum interference
fit-mean-clearance = Mean clearance
fit-mean-interference = Mean interference
fit-ansi = ANSI B4.2: { $name }
fit-equivalent = Equivalent fit
fit-equivalent-same = Exactly the same clearances
fit-equivalent-differs = Not the same: smallest clearance { $minimum } µm, largest { $maximum } µm
fit-check-hole = Check the hole
fit-check-shaft = Check the shaft
fit-move = Go to another class
fit-actual-clearance = Clearance { $um } µm
fit-actual-interference = Interference { $um } µm
fit-conforms = Within the limits of the callout
fit-conforms-not = Outside the limits of the callout
fit-with-good-shaft = Clearance with a good shaft
fit-with-good-hole = Clearance with a good hole
fit-at-temperature = At { $degrees } °C
fit-temperature-change = clearance changes by { $um } µm
fit-these-parts = These parts: { $clearance }

## Own materials
materials-refused = Own materials cannot be used: { $path }, { $reason }

## Palette
section-said = { $name }: { $value }
crash-report = The window ended by a fault of the program. A report of it, without measured values, is in { $path }
rail-more = More
top-open = { $name } is open
top-undo = Undo the last change
top-recorded = Recorded, { $number }
top-recording = Recording
top-not-recorded = Not recorded
palette = Search or do anything
palette-do = Do
palette-open = Open
palette-settings = Settings and help
palette-records = Records
palette-fit = Fit { $fit }
palette-in-tables = { $what } in the tables
palette-uncertainty = Uncertainty at { $size } mm
palette-records-of = Records of { $what }
palette-show-setting = Show on the settings page
palette-more = What else with it
palette-back = Back to what was found
palette-check-value = Check { $callout } with { $value }
palette-check = Check { $callout }
palette-search-manual = Search the manual for “{ $query }”
palette-nothing = Nothing has this name
palette-hint = A callout, a page, a command or a file

## Leaving
leave = Close Fitcheck?
discard = Discard the changes?
discard-unsaved = { $name } has unsaved changes.
discard-no = Keep editing
discard-yes = Discard changes
leave-unsaved = Not saved: { $names }
leave-stay = Keep working
leave-anyway = Close without saving

## Cycle pictures
cycle-picture-centre-1 = nominal centre in the first axis
cycle-picture-centre-2 = nominal centre in the second axis
cycle-picture-centre-tolerance-1 = permitted deviation of the centre in the first axis, either way; 0 monitors nothing
cycle-picture-centre-tolerance-2 = permitted deviation of the centre in the second axis, either way; 0 monitors nothing
cycle-picture-side-length-1 = nominal length of the rectangle along the first axis
cycle-picture-side-length-2 = nominal length of the rectangle along the second axis
cycle-picture-maximum-side-1 = largest permitted length along the first axis
cycle-picture-maximum-side-2 = largest permitted length along the second axis
cycle-picture-minimum-side-1 = smallest permitted length along the first axis
cycle-picture-minimum-side-2 = smallest permitted length along the second axis
cycle-picture-width = nominal width, from wall to wall
cycle-picture-maximum-width = largest permitted width
cycle-picture-minimum-width = smallest permitted width
cycle-picture-start-1 = point in the slot where the probe starts, first axis
cycle-picture-start-2 = point in the slot where the probe starts, second axis
cycle-picture-shift = offset of the second contact along the walls; 0 probes opposite the first
cycle-picture-first-point-1 = first point, on the wall on the plus side: first axis
cycle-picture-first-point-2 = first point, on the wall on the plus side: second axis
cycle-picture-second-point-1 = second point, on the wall on the minus side: first axis
cycle-picture-second-point-2 = second point, on the wall on the minus side: second axis
cycle-picture-axis-of-plane = measured axis: 1 first axis, 2 second axis
cycle-picture-diameter = nominal diameter
cycle-picture-maximum-size = largest permitted diameter
cycle-picture-minimum-size = smallest permitted diameter
cycle-picture-start-diameter = diameter of the circle on which the probe stands before each contact
cycle-picture-first-angle = angle of the first contact, measured from the first axis
cycle-picture-step = angle from contact to contact; minus turns clockwise
cycle-picture-arc = angle over which the contacts lie; 360 is a full turn, minus turns clockwise
cycle-picture-longest-path = longest probing path; plus leads away from the centre, minus towards it
cycle-picture-difference = each contact is probed twice: largest permitted difference
cycle-picture-measuring-height = height of the ball’s centre at the contact
cycle-picture-set-up-clearance = clearance before the contact, added to SET_UP of the touch-probe table
cycle-picture-clearance-height = height at which the probe moves freely
cycle-picture-point-1 = point to probe, first axis
cycle-picture-point-2 = point to probe, second axis
cycle-picture-point-3 = point to probe, third axis
cycle-picture-next-point-1 = second point of the line, first axis
cycle-picture-next-point-2 = second point of the line, second axis
cycle-picture-next-point-3 = second point of the line, third axis
cycle-picture-second-centre-1 = nominal centre of the second circle, first axis
cycle-picture-second-centre-2 = nominal centre of the second circle, second axis
cycle-picture-second-diameter = nominal diameter of the second circle
cycle-picture-second-height = height at which the second circle is probed
cycle-picture-geometries = 0 two holes, 1 two studs, 2 a hole and a stud, 3 a stud and a hole
cycle-picture-maximum-coordinate = largest permitted coordinate
cycle-picture-minimum-coordinate = smallest permitted coordinate
cycle-picture-normal-1 = component of the surface normal in the first axis; the normal points out of the material
cycle-picture-normal-2 = component of the surface normal in the second axis; the normal points out of the material
cycle-picture-normal-3 = component of the surface normal in the third axis; the normal points out of the material
cycle-picture-band = permitted deviation along the normal: oversize plus, undersize minus
cycle-picture-retract = path back from the contact, against the probing direction
cycle-picture-move-to-clearance = path between contacts: 0 at measuring height, 1 over the clearance height
cycle-picture-clearance-mode = clearance height: −1 never, 0 before and after the cycle, 1 before and after each object, 2 at each contact
cycle-picture-traverse = path to the next contact: 0 straight line, 1 arc
cycle-picture-contact-count = number of contacts
cycle-picture-plane = plane of the circle: 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 probes inside, 1 outside
cycle-picture-measured-axis = measured axis: 1 first axis, 2 second axis, 3 probe axis
cycle-picture-direction = direction of the approach: −1 against the axis, +1 along it
cycle-picture-directed-axis = measured axis, 1 first, 2 second, 3 probe axis; minus probes against it
cycle-picture-tool-axis-probing = probe axis: 0 is left as it is, 1 is probed and set, too
cycle-picture-tool-axis-point-1 = where the probe axis is probed, first axis
cycle-picture-tool-axis-point-2 = where the probe axis is probed, second axis
cycle-picture-tool-axis-point-3 = where the surface is expected in the probe axis
cycle-picture-new-datum-1 = coordinate that the measured place gets in the first axis
cycle-picture-new-datum-2 = coordinate that the measured place gets in the second axis
cycle-picture-new-datum-3 = coordinate that the measured place gets in the probe axis
cycle-picture-new-coordinate = coordinate that the measured place gets in the measured axis
cycle-picture-table-row = row of the table that the datum goes into; with 0 it is active at once
cycle-picture-transfer = table: −1 not stated, 0 datum table, 1 preset table
cycle-picture-preset-correction = 0 leaves the active preset as it is; another number corrects it, so that this point reads its nominal value
cycle-picture-aligned-angle = angle that the edge is aligned to, from the first axis; 0 aligns it with the axis
cycle-picture-compensation-axis = rotary axis that aligns the edge: 0 the one about which the angle was measured, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = the rotary axis after alignment: 0 keeps its value, 1 reads zero
cycle-picture-rotary-alignment = rotary axes after measuring: 0 they stay, another number turns them, so that the line is aligned
cycle-picture-rotation-transfer = the measured angle: 0 changes nothing, 1 becomes the basic rotation, 2 an offset of the rotary axis
cycle-picture-log = measuring log: 0 none, 1 file, 2 on screen and the program stops
cycle-picture-stop = out of tolerance: 0 the program continues, 1 it stops with a message
cycle-picture-stop-on-undersize = out of tolerance: 0 the program continues, 1 it stops, 2 it stops on undersize only
cycle-picture-stop-on-scrap = out of tolerance: 0 the program continues, 1 it stops, 2 it stops for scrap only
cycle-picture-tool = tool to be monitored, by number or name; 0 is none
cycle-picture-any-length = { $name } A length
cycle-picture-any-angle = { $name } An angle
cycle-picture-any-choice = { $name } One of { $of }
cycle-picture-any-number = { $name } A number
cycle-picture-part = Part with { $count ->
    [one] one feature
   *[other] { $count } features
  }: { $names }.
cycle-picture-path = Path of the probe, { $step } of { $moves } moves done, { $contacts ->
    [one] 1 contact
   *[other] { $contacts } contacts
}. Ball at X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, contact { $touch }
cycle-picture-no-path = The path appears when the cycle has run
cycle-picture-phase-pre-position = pre-position
cycle-picture-phase-approach = approach
cycle-picture-phase-contact = contact
cycle-picture-phase-retract = retract
cycle-picture-phase-leave = leave
cycle-picture-from-above = { $first }/{ $second } from above
cycle-picture-from-side = { $first }/{ $second } from the side
cycle-picture-contacts = { $count } contacts about their least-squares circle Ø { $diameter } mm, { $factor }: { $residuals }.
cycle-picture-nominal = Nominal circle Ø { $diameter } mm.
cycle-picture-legend-fitted = least squares
cycle-picture-legend-nominal = nominal
cycle-picture-deviation = deviation along the normal { $deviation } mm, without a tolerance
cycle-picture-no-limits = No limits were given: nothing was compared
cycle-picture-head-criterion = Criterion
cycle-picture-head-centre-1 = Centre, 1st axis
cycle-picture-head-centre-2 = Centre, 2nd axis
cycle-picture-head-diameter = Ø in mm
cycle-picture-head-form = Form
cycle-picture-none = —
cycle-picture-least-squares = Least squares
cycle-picture-circumscribed = Minimum circumscribed
cycle-picture-inscribed = Maximum inscribed
cycle-picture-zone = Minimum zone, roundness
cycle-picture-two-point = Two-point size
cycle-picture-two-point-of = Two-point size { $first }–{ $second }
cycle-picture-two-point-least = Smallest two-point size, { $first }–{ $second }
cycle-picture-two-point-most = Largest two-point size, { $first }–{ $second }
cycle-picture-no-opposed = no two contacts oppose each other
cycle-picture-uncertainty = Scatter s of a contact gives { $diameter } s in the diameter, { $against } times that of 3 contacts at 120°, and { $across } s to { $along } s in the centre

# The saved state, and the window itself
saved-broken = the saved state cannot be read: { $reason }
saved-newer = the saved state has version { $version }, this program supports versions up to { $known }
window-no-display = no display: DISPLAY and WAYLAND_DISPLAY are not set. Log in on a desktop, connect with ssh -X, or use the command line, which needs no display: fitcheck check "25 H7" --measured 25.012; see fitcheck --help
open-unknown = { $name } is not a file that the window opens; it opens measurements, measuring logs and contacts (.csv, .tsv, .txt, .html), NC programs (.h), tables (.tab), tool tables (.t), simulated workpieces (.toml), touch-probe tables (.tp) and masks (.a)
window-not-opened = the window cannot be opened: { $reason }; the command line works without a display, see fitcheck --help

## Rows of a large file

rows = Rows
rows-cancel = Cancel
rows-again = Judge again
rows-close = Close file
rows-close-hint = Closes the large file; its rows are not kept
rows-move = Go to another row
rows-show = Show the check of the row
rows-keep = Add to history
rows-kept = The check was added to the history
rows-progress = Share of the file that was read
rows-running = { $count } rows so far, { $percent } % of the file, { $rate } rows a second
rows-done = { $count } rows, all judged in { $seconds }
rows-seconds = { $seconds } s
rows-less-than = less than { $seconds } s
rows-cancelled = INCOMPLETE: cancelled after { $count } rows, { $percent } % of the file
rows-failed = INCOMPLETE after { $count } rows: { $why }
rows-why-bytes = { $size } MiB, more than { $limit } MiB: judged row by row, and the rows are not kept in the history
rows-why-packed = Compressed: judged row by row, and the rows are not kept in the history; the uncompressed text is in a temporary file until the file is closed
rows-not-judged = NOT JUDGED
rows-fate = { $fate } { $count }
rows-fate-hint = Lists these rows; several can be chosen
rows-classes = Classes
rows-all-classes = All classes
rows-no-class = Without a class
rows-some-classes = { $count } classes
rows-class = { $class }: { $count }
rows-summary = Summary
rows-fate-only = List { $fate } rows of the large file
rows-filter-hint = Lists the rows that contain these words in their cells, such as part, callout, value or status
rows-worst-first = Worst first
rows-worst-first-hint = Lists scrap before rework and good, the largest deviation from the limits first
rows-worst = Worst part
rows-sifting = Searching the rows…
rows-sifts-at-end = Filter and order apply when all rows are judged
rows-in-order = worst first
rows-worst-of-many = the { $most } worst of them, worst first
rows-first-of-many = the first { $most } of them
rows-export = Rows of the file as { $format }, with verdicts…
rows-export-programs = Checks of the listed rows as { $format }…
rows-export-simulated = The first lines of the file say that it is simulated, and only CSV can keep them. Export as CSV
rows-export-twice = The file has two columns named { $column }. Export as CSV or TSV, which allow both
rows-report-counts = { $name }: { $count } rows; { $good } GOOD, { $rework } REWORK, { $remeasure } RE-MEASURE, { $out } OUT OF LIMITS, { $scrap } SCRAP, { $unjudged } NOT JUDGED; { $listed } of them listed in this report
rows-report-without = { $count ->
    [one] 1 listed row has no verdict and no check in this report
   *[other] { $count } listed rows have no verdict and no check in this report
}
rows-file-name = { $name }-judged
rows-not-whole = INCOMPLETE: the counts are not those of the whole file
rows-listed = { $listed } of { $count } rows listed
rows-refused = { $count ->
    [one] 1 row not judged
   *[other] { $number } rows not judged
}
rows-doubted = { $count ->
    [one] 1 value may be another quantity or belong to another part
   *[other] { $number } values may be another quantity or belong to another part
}
rows-simulated = { $count ->
    [one] 1 row says that nobody measured
   *[other] { $number } rows say that nobody measured
}
rows-status-differs = { $count ->
    [one] 1 row has a different status in its file
   *[other] { $number } rows have a different status in their file
}
rows-status-unknown = { $count ->
    [one] 1 row has an unknown status in its file
   *[other] { $number } rows have an unknown status in their file
}
rows-claim-differs = { $count ->
    [one] 1 limit, deviation or type of feature contradicts its row
   *[other] { $number } limits, deviations or types of features contradict their rows
}
rows-several-lines = { $count ->
    [one] 1 row runs over several lines
   *[other] { $number } rows run over several lines
}
rows-not-utf8 = { $count ->
    [one] 1 line is not UTF-8 and was read as Windows-1252
   *[other] { $number } lines are not UTF-8 and were read as Windows-1252
}
rows-comments = { $count ->
    [one] 1 comment is not a row
   *[other] { $number } comments are not rows
}
rows-note = Line { $line }: { $what }
rows-first-notes = The first { $first } of { $count }:
rows-line = Line { $line } of { $name }
rows-row-line = line { $line }
rows-list = Rows of the file
rows-none = No row matches the filter
rows-none-yet = No row yet
rows-head-line = Line
rows-head-what = To do
rows-changed = the file has changed since it was judged; judge it again
rows-unread = the rows cannot be read again: { $reason }
rows-no-copy = the uncompressed text cannot be kept: { $reason }
rows-too-much = the uncompressed text is larger than { $most } GiB
rows-panicked = an internal error ended the run

## A file that is read or written
working = Working
working-reading = Reading { $name }: { $rows } rows, { $done } of { $all } MB, { $rate } rows a second
working-reading-bytes = Reading { $name }: { $done } of { $all } MB, { $seconds } s
working-writing = Writing { $name }: { $done } MB, { $seconds } s
working-progress = Reading progress
working-stop = Stop
working-stopped = Stopped after { $rows } rows: nothing from { $name } was imported

## What a code reader typed into the field of the value
scanned-callout = { $given } is a callout: it was taken as one
scanned-serial = { $given } is not a value: it was taken as the serial number of the next checks
