# probing

# Where a measurement comes from, and what it cannot tell.
origin-simulated = simulated, cycle { $cycle }, seed { $seed }
origin-contacts = contacts from { $file }
origin-imported = imported from { $file }
origin-imported-simulation = imported from { $file }, simulated
origin-typed = typed
caveat-only-a-diameter = one diameter only: form and position are unknown
caveat-only-a-circle = diameter and centre only: form is unknown
caveat-three-contacts = 3 contacts: form cannot be measured
caveat-four-contacts = 4 contacts: no form beyond ovality is detected
caveat-few-contacts = { $contacts } contacts: form between them is not detected
caveat-short-arc = contacts cover only { $arc }°: scatter is magnified in diameter and centre
caveat-two-point = the diameter across contacts { $one } and { $other } is { $size } mm, beyond the limit of { $limit } mm, which the mean circle does not exceed: by default, a size applies between any two opposite points
caveat-form = the contacts' radii differ by { $form } mm, so diameters across them may differ by more than the zone of { $zone } mm: two opposite points may lie outside the limits
caveat-heights = the contacts' heights differ by { $spread } mm: on a cone or a tilted axis that changes the diameter
caveat-stated = the callout states { $upper } and { $lower } µm behind the tolerance, which has { $used-upper } and { $used-lower } µm: the tolerance was used; check which one the drawing means
caveat-count = the callout applies to { $count } features: this value is that of one
caveat-form-class = class { $class } of ISO 2768-2 is for form and position: the size does not show them
caveat-each-two-point = { $modifier } requires every two-point size to lie within the limits: this is one diameter only
caveat-mean-of-two-points = { $modifier } requires every two-point size to lie within the limits: the least-squares diameter is only their mean
caveat-not-least-squares = { $modifier } refers to the least-squares size: one diameter does not show it
caveat-one-section = { $modifier } refers to the least-squares size of the whole feature: this is that of one section
caveat-envelope = { $modifier } requires the envelope of perfect form at maximum material size: one diameter does not show whether the surface exceeds it; use a gauge
caveat-other-size = { $modifier } refers to another size than the measured one: a two-point or least-squares diameter does not prove it
caveat-condition = { $modifier } states where or how the size applies: the measured value does not show whether this was met
contact-beyond-travel = contact { $number } lies { $distance } mm from where its probing begins, and the ball travels at most { $allowed } mm (DIST or K, plus SET_UP of the touch-probe table and Q320): check that these contacts are of this feature, in this order, and counted from this zero
contact-missed = contact { $number }: the probe met nothing on the probing path
contact-no-height = contact { $number } has no height: add a column z to the file
contact-used-up = contact { $number }: the file has only { $available ->
    [one] { $available } contact
   *[other] { $available } contacts
    }

cycle-out-of-range = { $key } { $name } = { $given }: { $allowed }
cycle-length-range = at least { $least } mm, at most { $most } mm
cycle-angle-range = at most { $most } either way
cycle-angle-size-range = at least { $smallest } in size, at most { $most }
cycle-one-of = expected one of { $allowed }
cycle-tool-range = a tool number from 0 to 99999.9, or a tool name of at most 255 characters
cycle-not-a-value = { $key } { $name }: { $error }
cycle-tool-no-name = { $text } calls no tool: write its number, or its name
cycle-tool-empty = no tool is named: for none, write Q330=0
cycle-tool-unquoted = { $text } is not a number, and a tool name needs quotation marks
cycle-no-diameter = { $key } { $name } = 0 mm: a circle needs a diameter above 0
cycle-one-limit = { $given } is given without { $missing }: 0 would be the other limit
cycle-missing = { $key } { $name } is missing
cycle-no-such-parameter = cycle { $cycle } has no parameter { $parameter }: its parameters are { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm is above { $maximum-key } = { $maximum } mm: the minimum dimension is above the maximum
cycle-too-large = the measured circle is too large: { $error }
workpiece-cannot-be = { $what } = { $given }: at least { $least }, at most { $most }

# Touches.
contact-in-material = contact { $number }: the probing path begins inside the material
contact-in-feature = contact { $number }: the probing path begins inside the material of { $feature }
contact-behind = contact { $number }: the ball reaches the wall of { $feature } from behind, and the thickness of the material there is unknown
contact-ambiguous = contact { $number }: the ball meets { $feature } and { $other } at the same place, so it is not known which one is measured

# Circle evaluation.
circle-too-few = a circle needs at least 3 contacts, found { $contacts }
circle-coinciding = contacts { $first } and { $second } coincide at x = { $x }, y = { $y }: a circle needs 3 different points
circle-collinear = all { $contacts } contacts lie on one straight line: no circle goes through them
circle-straight = the { $contacts } contacts fit a straight line better than any circle
circle-not-finite = contact { $contact }: { $axis } = { $value } is not a finite number
circle-too-large = { $what } = { $value } mm is too large: at most { $most } mm either way
circle-part-contact = contact { $contact }: { $axis }
circle-part-diameter = diameter
circle-part-centre = centre { $axis }
circle-three-contacts = 3 contacts: form cannot be measured, the residual is always zero
circle-four-contacts = 4 contacts: four lobes are not detected and change the diameter
circle-short-arc = the contacts cover only { $arc }° of arc: scatter in the diameter is { $factor } times that of 3 contacts at 120°
circle-circumscribed-of-short-arc = the minimum circumscribed circle of a short arc is not the size of the feature
circle-counts-twice = contacts { $first } and { $second } coincide: this place counts twice
circle-no-inscribed = no maximum inscribed circle: the contacts do not surround one
circle-no-zone = no minimum zone: a straight strip is narrower than any ring
circle-too-many-contacts = maximum inscribed circle and minimum zone are not computed for { $contacts } contacts: at most { $most }
circle-short-chord = contacts { $first } and { $second } are opposite each other but off the centre: this size is { $short } µm too small
circle-more-of-a-kind = the same applies to { $more } more
circle-apart = contact { $contact } lies { $apart } mm off the circle, far more than the others: dust or a false trigger?
circle-heights = the contacts' heights differ by { $spread } mm: on a cone or a tilted axis that changes the diameter

## Measuring cycles: errors, results, remarks
contact-out-of-reach = contact { $number }: the probe met nothing within the probing path of { $longest } mm
cycle-number-range = a number, at most { $most } either way
cycle-count-range = a whole number from 0 to { $most }
cycle-band-range = a tolerance such as 0.4-0.1, 0.4 or -0.1; 0 means no tolerance
cycle-range = { $range }
cycle-range-tool = 0 … { $highest }, or at most { $longest } characters
cycle-range-band = 0.4-0.1, 0.4, -0.1 or nothing
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = no tolerance
cycle-no-global = { $key } { $name } = PREDEF: no GLOBAL DEF gives a value
cycle-no-path = { $key } { $name } = 0 mm: a probing path needs a length; its sign gives the direction
cycle-no-transfer = { $row-key } = { $row } with { $key } = -1: it is not stated which table has that row; { $key } must be 0 or 1 (a control reports error 1078)
cycle-other-feature = { $key } { $name } = { $given }: the class does not agree with { $geometry }: a class in capitals is for a hole, one in small letters for a stud
cycle-not-measured = { $key } { $name } = { $given }: the cycle does not measure this value: write it without a tolerance
cycle-inch-tolerance = { $key } { $name } = { $given }: in a program in inches the unit of a tolerance is not known: write a program in mm, or the number without a tolerance
cycle-no-edge = { $first } and { $second } are the same: an edge needs two points along it
cycle-no-sphere = the contacts do not determine a sphere
cycle-no-rotation = { $key } { $name }: Fitcheck follows a basic rotation (Q1121 = 1) alone, and only without a correction (Q1120 = 0)
cycle-no-normal = { $first }, { $second } and { $third } are all 0: a normal needs a direction
cycle-apart = contact { $contact }: its two probings lie { $difference } mm apart, { $key } permits { $most } mm
cycle-too-far = the measured coordinate is too large: { $error }
cycle-stop = program stop by Q309 = { $setting }: { $out }
check-within = { $what } { $measured } mm is within { $minimum } to { $maximum } mm
check-above = { $what } { $measured } mm is above its maximum { $maximum } mm: { $status }
check-below = { $what } { $measured } mm is below its minimum { $minimum } mm: { $status }
check-and = { $one }; { $other }
found-centre-1 = measured centre, 1st axis
found-centre-2 = measured centre, 2nd axis
found-centre-3 = measured centre, 3rd axis
found-diameter = measured diameter
found-centre-deviation-1 = deviation of the centre, 1st axis
found-centre-deviation-2 = deviation of the centre, 2nd axis
found-centre-deviation-3 = deviation of the centre, 3rd axis
found-diameter-deviation = deviation of the diameter
found-coordinate = measured coordinate
found-coordinate-deviation = deviation of the coordinate
found-position-1 = measured position, 1st axis
found-position-2 = measured position, 2nd axis
found-position-3 = measured position, 3rd axis
found-angle = measured angle
found-deviation-1 = deviation, 1st axis
found-deviation-2 = deviation, 2nd axis
found-deviation-3 = deviation, 3rd axis
found-deviation-along = deviation along the normal
found-second-position-1 = 2nd point: measured position, 1st axis
found-second-position-2 = 2nd point: measured position, 2nd axis
found-second-position-3 = 2nd point: measured position, 3rd axis
found-second-deviation-1 = 2nd point: deviation, 1st axis
found-second-deviation-2 = 2nd point: deviation, 2nd axis
found-second-deviation-3 = 2nd point: deviation, 3rd axis
found-second-diameter = 2nd circle: measured diameter
found-second-diameter-deviation = 2nd circle: deviation of the diameter
found-rotation = measured rotation
found-side-1 = measured length, 1st side
found-side-2 = measured length, 2nd side
found-width = measured width
found-centre-line = position of the centre line
found-side-deviation-1 = deviation of the 1st side
found-side-deviation-2 = deviation of the 2nd side
found-width-deviation = deviation of the width
found-good = within tolerance
found-rework = rework
found-scrap = scrap
found-status = status: -1 undefined, 0 good, 1 rework, 2 scrap
cycle-note-machine-builder = the machine builder must enable and adapt this cycle: see the machine manual
cycle-note-not-on-itnc530 = an iTNC 530 does not have this cycle; TNC 320, TNC 620, TNC 640 and TNC7 have it
cycle-note-normal-from-cad = take the normal from a CAD or CAM system
cycle-note-software-option = the control needs software option { $option }
cycle-note-recommended = where the control has cycle { $cycle }, HEIDENHAIN recommends it instead
cycle-note-ends-rotation = ends a basic rotation that is active
remark-without-effect = { $key } is accepted but has no effect
remark-tool-not-monitored = Q330 = { $tool }: the tool is not monitored: no tool table
remark-outside-dimension = an outside dimension is assumed: above the maximum is rework, below the minimum is scrap
remark-nominal-outside-limits = nominal diameter { $nominal } mm is not between the limits: a TNC7 refuses that
remark-nominal-width-outside-limits = nominal width { $nominal } mm is not between the limits: a TNC7 refuses that
remark-nominal-coordinate-outside-limits = nominal coordinate { $nominal } mm is not between the limits: by its manual a TNC7 may refuse that
remark-contact-astray = { $count ->
    [one] contact { $contact } lies { $distance } mm from where the cycle probes: perhaps it belongs to another feature
   *[other] { $count } contacts lie apart from where the cycle probes, contact { $contact } by { $distance } mm: perhaps they belong to another feature
}
remark-deviation-without-parameter = the deviation has no parameter here: the manual says that a control stores it, but not in which one
remark-new-datum = new datum, { $target }: { $axes } mm (measured → wanted)
datum-target-display = active at once
datum-target-active = correction of the active preset
datum-target-preset = row { $row } of the preset table
datum-target-table = row { $row } of the datum table
remark-new-rotation = new basic rotation of { $angle }: { $target }
remark-axis-turned = axis { $axis } turns the part by { $angle }: only the machine knows where its centre is, and Fitcheck writes its zero into no table
remark-variable-holds-diameter = #i99 is read as the diameter: the manual does not say which value it holds
remark-no-tolerance = { $key } is not a tolerance: nothing is judged

## The simulated machine
workpiece-file-toml = line { $line }: { $said }
workpiece-file-too-large = a workpiece file has at most { $most } KiB
workpiece-file-not-one = the file has { $found } of { $tables }: it needs exactly one
workpiece-file-cannot-be = line { $line }: { $error }
workpiece-file-several = the file has [[feature]] tables: one workpiece with a single surface is expected here
workpiece-file-too-many = a part has at most { $most } features
workpiece-file-feature = line { $line }, column { $column }: { $feature }: { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } is not a kind of feature: the kinds are { $known }
feature-fault-no-key = a { $kind } needs { $key }
feature-fault-other-key = a { $kind } has no { $key }
feature-fault-name = a name has 1 to { $most } characters on one line
feature-fault-same-name = another feature has the same name

# Figures of the simulated workpiece, as errors name them.
figure-temperature = temperature
figure-expansion = expansion
figure-probe-scatter = probe scatter
figure-ball-radius = ball radius
figure-calibration-error = calibration error
figure-offset = offset
figure-lobing = pre-travel amplitude
figure-lobing-angle = pre-travel angle
figure-lobing-count = pre-travel lobes
figure-centre-x = centre x
figure-centre-y = centre y
figure-diameter = diameter
figure-surface-scatter = surface scatter
figure-ovality = ovality
figure-ovality-angle = ovality angle
figure-ovality-count = ovality count
figure-lobe-height = lobe height
figure-lobe-angle = lobe angle
figure-lobes = lobes
figure-point = point
figure-normal = normal
figure-normal-length = length of the normal
figure-wave-length = wave length
figure-wave-amplitude = wave amplitude
figure-wave-direction = wave direction
figure-deviation = deviation
figure-radius = radius
figure-width = width
figure-first-length = 1st length
figure-second-length = 2nd length
figure-angle = angle
figure-top = top
figure-bottom = bottom
figure-length = length of the walls
figure-reach = reach
figure-stylus-radius = stylus radius

## What of the probe touches.
mover-ball = ball
mover-stylus = stylus
