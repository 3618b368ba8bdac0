page-statistics = Statistics

# What is asked
statistics-page-question = Records
statistics-page-question-hint = The records whose values are used, in the language of the page Records, such as part:"Flange 40" station:"Mill 3" from:2026-11-01. Empty uses all of them.
statistics-page-last = Newest values
statistics-page-size = Values per point
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
statistics-page-take-in = Include again
statistics-page-reason = Reason
statistics-page-take-reason = Leave out
statistics-page-cancel-reason = Cancel
statistics-page-copy = Copy figures
statistics-page-copy-hint = Figures, signals and advice as a table for a spreadsheet
statistics-page-report = Report…
statistics-page-report-hint = The figures and charts of all features as a report to sign

# Signals
statistics-page-signals = Signals
statistics-page-no-signals = No rule fires.
statistics-page-rules = Rules
statistics-page-on-spread = Spread: { $rule }
statistics-page-alarms = Open alarms: { $count }
statistics-page-at = Point { $point }
statistics-page-from-to = Points { $first } to { $last }
statistics-page-left-out-because = Left out: { $reason }
statistics-page-advice = Advice
