page-statistics = Statistics

# What is asked
statistics-page-question = Records
statistics-page-question-hint = The records whose values are used, in the language of the page Records, such as part:"Flange 40" station:"Mill 3" from:2026-11-01. Empty uses all of them.
statistics-page-last = Newest values
statistics-page-size = Values per point
statistics-page-pause = Pause in minutes
statistics-page-mean-of = Mean of
statistics-page-mean-count = so many values in a row
statistics-page-mean-pause = values without a pause
statistics-page-mean-part = values of one part
statistics-page-mean-station = values of one station
statistics-page-mean-person = values of one person
statistics-page-part = Part
statistics-page-all-parts = All parts
statistics-page-read-again = Read again
statistics-page-range = must be a whole number from { $least } to { $most }
statistics-page-reading = Reading values…
statistics-page-off = Nothing is recorded. Statistics are made from the values in the journal.
statistics-page-none = No record has a measured value that answers this question.
statistics-page-not-read = The values cannot be read: { $why }

# What was read
statistics-page-values = { $count ->
        [one] 1 value
       *[other] { $count } values
    }
statistics-page-groups = { $count ->
        [one] 1 group
       *[other] { $count } groups
    } of { $size }
statistics-page-out = { $count } left out: { $why ->
        [simulated] simulated
        [invalid] not valid
        [doubtful] doubtful
        [withdrawn] corrected or withdrawn
       *[user] with a reason
    }
statistics-page-newest = The newest { $count } records were read. Older ones are not included.
statistics-page-unread = { $count ->
        [one] 1 record cannot be read.
       *[other] { $count } records cannot be read.
    }

# Features
statistics-page-features = Features
statistics-page-features-head = Ppk, mark at { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 value
       *[other] { $count } values
    }, Ppk { $ppk }
statistics-page-below = { $count } of { $all } below { $asked }
statistics-page-move-feature = Another feature

# Figures
statistics-page-figures = Figures
statistics-page-figure-mean = Mean
statistics-page-figure-deviation = Standard deviation
statistics-page-figure-cp = Cp short term
statistics-page-figure-cpk = Cpk short term
statistics-page-figure-pp = Pp overall
statistics-page-figure-ppk = Ppk overall
statistics-page-figure-outside = Outside the limits
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = of { $count }
statistics-page-expected = expected { $ppm } in a million
statistics-page-proven = Ppk of { $asked } is proven: its lower bound is { $lower }.
statistics-page-not-proven = Ppk of { $asked } is not proven: its lower bound is { $lower }.
statistics-page-no-ppk = Ppk of { $asked } is not proven: { $why }.

# The chart
statistics-page-single = Single values
statistics-page-means = Means of { $size }
statistics-page-means-of-groups = Means of groups
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Histogram
statistics-page-spread = Spread
statistics-page-probability = Probability plot
statistics-page-no-chart = No control limits: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 point
       *[other] { $count } points
    }, centre line { $centre }, control limits { $lower } … { $upper }, limits { $minimum } … { $maximum }, { $signals ->
        [one] 1 signal
       *[other] { $signals } signals
    }, { $outside } outside the limits.
statistics-page-said-mean-mm = mean
statistics-page-said-sd-mm = standard deviation
statistics-page-said-spread-centre-mm = mean spread
statistics-page-said-spread-upper-mm = upper control limit of the spread
statistics-page-said-ewma-mm = weighted average
statistics-page-said-ewma-lower-mm = lower limit of the average
statistics-page-said-ewma-upper-mm = upper limit of the average
statistics-page-said-cusum-above-mm = sum above the mean
statistics-page-said-cusum-below-mm = sum below the mean
statistics-page-said-cusum-interval-mm = decision interval
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Another point
statistics-page-open = Open the record
statistics-page-zoom-in = Fewer points
statistics-page-zoom-out = More points
statistics-page-zoom-whole = All points
statistics-page-freeze = Limits from the points up to here
statistics-page-unfreeze = Limits from all points
statistics-page-freeze-hint = Later points do not move the control limits.
statistics-page-leave-out = Leave out…
statistics-page-leave-out-hint = The point stays in the chart with its reason. It does not count for limits, rules and figures.
statistics-page-stage = Begin a stage here
statistics-page-no-stage = Remove the stage
statistics-page-stage-hint = Control limits are computed anew from this point on, such as after a change of tools. The figures are those of the last stage.
statistics-page-take-in = Include again
statistics-page-reason = Reason
statistics-page-take-reason = Leave out
statistics-page-cancel-reason = Cancel
statistics-page-copy = Copy figures
statistics-page-copy-hint = Figures, signals and advice as a table for a spreadsheet
statistics-page-report = Report…
statistics-page-report-hint = The figures and charts of all features as a report to sign
statistics-page-save-chart = Save chart…
statistics-page-save-chart-hint = All charts of the feature on one sheet, as SVG or PNG
statistics-page-dialog-chart = Save chart
statistics-page-chart-ending = The name of the file must end in .svg or .png.

# Signals
statistics-page-signals = Signals
statistics-page-no-signals = No rule fires.
statistics-page-rules = Rules
statistics-page-alarms = Open alarms: { $count }
statistics-page-at = Point { $point }
statistics-page-from-to = Points { $first } to { $last }
statistics-page-left-out-because = Left out: { $reason }
statistics-page-advice = Advice

# A study of a gauge
statistics-study = Gauge study
statistics-study-open = Open readings…
statistics-study-open-hint = A file with readings of a gauge, in any format of measurements
statistics-study-dialog = Open readings of a gauge
statistics-study-readings = { $count ->
        [one] 1 reading
       *[other] { $count } readings
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 reading
       *[other] { $count } readings
    }
statistics-study-none = Open a file with readings of a gauge. Its columns say which part was read and by whom. You see how it was understood before anything is computed.
statistics-study-kind = Kind of study
statistics-study-type1 = Type 1
statistics-study-crossed = Crossed
statistics-study-nested = Nested
statistics-study-linearity = Linearity
statistics-study-stability = Stability
statistics-study-type1-hint = One master, 25 readings or more
statistics-study-crossed-hint = Every operator reads every part, twice or more
statistics-study-nested-hint = Every operator has parts of their own
statistics-study-linearity-hint = Several masters of different sizes
statistics-study-stability-hint = One master over time
statistics-study-feature = Feature of the study
statistics-study-lower = Lower limit
statistics-study-upper = Upper limit
statistics-study-reference = Calibrated size
statistics-study-resolution = Step of the display
statistics-study-references-hint = One size for each master by its name: M1 = 30.0012; M2 = 40.0005. Empty uses the nominal sizes of the file.
statistics-study-reference-unnamed = { $given } names no master: write its name before the size, such as M1 = 30.0012
statistics-study-own-limits = Limits of the file: { $lower } … { $upper } mm
statistics-study-understood = How the file was understood
statistics-study-confirm = Nothing is computed until you confirm this.
statistics-study-evaluate = Evaluate
statistics-study-all-the-same = Evaluate all the same
statistics-study-working = Evaluating…
statistics-study-answer = Is this gauge good enough?
statistics-study-each = { $what } each
statistics-study-parts = { $count ->
        [one] 1 part
       *[other] { $count } parts
    }
statistics-study-operators = { $count ->
        [one] 1 operator
       *[other] { $count } operators
    }
statistics-study-repeats = { $count ->
        [one] 1 repeat
       *[other] { $count } repeats
    }
statistics-study-masters = { $count ->
        [one] 1 master
       *[other] { $count } masters
    }
statistics-study-points = { $count ->
        [one] 1 point
       *[other] { $count } points
    }
statistics-study-readings-between = { $least } to { $most } readings
statistics-study-more-faults = and { $count } more
statistics-study-limits-differ = The limits of the file differ from value to value: enter the lower and the upper limit, or choose a feature.
statistics-study-features = The file has several features: choose the one that the gauge read.
statistics-study-save-budget = Save as budget…
statistics-study-save-budget-hint = The scatter that the study found, as type A with its degrees of freedom, for the page Uncertainty
statistics-study-no-budget = This study gives no contribution to a budget
statistics-study-source = { $of ->
        [part] parts
        [operator] operators
        [interaction] interaction
        [repeatability] repeatability
        [gauge] gauge
       *[total] total
    }
statistics-study-mean-square = Mean square, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Variance, { $source }
statistics-study-figure-reference = Calibrated size
statistics-study-figure-bias = Bias
statistics-study-figure-mean-bias = Mean bias
statistics-study-figure-bias-p = p of the bias
statistics-study-figure-bias-t = t of the bias
statistics-study-figure-bias-at = Bias at { $size } mm ({ $count })
statistics-study-figure-smallest = Smallest tolerance
statistics-study-figure-smallest-good = Smallest tolerance, 10 %
statistics-study-figure-smallest-accepted = Smallest tolerance, 30 %
statistics-study-figure-repeatability = Repeatability, s
statistics-study-figure-gauge = Gauge, s
statistics-study-figure-of-variance = Share of the variance
statistics-study-figure-of-readings = Share of all readings
statistics-study-figure-of-tolerance = Share of the tolerance
statistics-study-figure-categories = Distinct categories
statistics-study-figure-slope = Slope
statistics-study-figure-slope-p = p of the slope
statistics-study-figure-intercept = Bias at 0
statistics-study-figure-intercept-p = p of the bias at 0
statistics-study-figure-residual = s about the line
statistics-study-figure-centre = Centre line
statistics-study-figure-lower-control = Lower control limit
statistics-study-figure-upper-control = Upper control limit
statistics-study-figure-spread-centre = Mean spread
statistics-study-figure-spread-upper = Upper control limit of the spread
