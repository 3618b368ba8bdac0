# statistics

# Why there is no figure
statistics-reason-empty = there are no values
statistics-reason-not-a-number = value { $place } is not a number
statistics-reason-too-few = too few values or groups: { $found }, at least { $needed } needed
statistics-reason-all-equal = all values are equal: there is no spread to compute with
statistics-reason-no-subgroups = no subgroup has two values or more
statistics-reason-large-subgroup = a subgroup has { $found } values: ranges are used for at most { $most }
statistics-reason-no-limits = there are no limits
statistics-reason-one-limit = there is only one limit, and both are needed
statistics-reason-swapped-limits = the lower limit is not below the upper one
statistics-reason-not-positive = this distribution has positive values only
statistics-reason-negative = this distribution has no negative values
statistics-reason-no-fit = this distribution does not fit the values
statistics-reason-uneven-cell = readings of part { $part } by operator { $operator }: { $found }, expected { $needed }
statistics-reason-no-baseline = the baseline is not within its stage, or its figures cannot be used
statistics-reason-parameter = { $name } cannot be { $given }

# Rules of control charts, where one fires
statistics-rule-beyond-limits = 1 point beyond a control limit
statistics-rule-nine-one-side = 9 points in a row on one side of the centre line
statistics-rule-six-trend = 6 points in a row rising or falling
statistics-rule-fourteen-alternating = 14 points in a row alternately up and down
statistics-rule-two-of-three = 2 of 3 points beyond 2 s on one side
statistics-rule-four-of-five = 4 of 5 points beyond 1 s on one side
statistics-rule-fifteen-within = 15 points in a row within 1 s of the centre line
statistics-rule-eight-beyond = 8 points in a row beyond 1 s, on either side
statistics-rule-eight-one-side = 8 points in a row on one side of the centre line
statistics-chart-maximum = maximum { $size }
statistics-chart-minimum = minimum { $size }
statistics-chart-upper = upper { $size }
statistics-chart-mean = mean { $size }
statistics-chart-lower = lower { $size }
statistics-chart-values = Single values in µm from { $base }, oldest left
statistics-chart-means = Means of groups in µm from { $base }, oldest left
statistics-chart-histogram = Histogram
statistics-chart-moving-range = Moving range, µm
statistics-chart-range = Range of groups, µm
statistics-chart-deviation = Standard deviation of groups, µm
statistics-chart-probability = Probability plot
statistics-chart-probability-test = Probability plot, Anderson-Darling { $statistic }, p = { $p }

# What to do with the figures
statistics-advice-few-values = { $count } values: the intervals are wide, { $enough } or more are usual
statistics-advice-few-points = control limits come from { $count } points: { $enough } or more are usual
statistics-advice-unstable = points at which a rule fires: { $count }; capability holds for a stable process only
statistics-advice-not-of-law = the values hardly come from this distribution (p = { $p }): its shares outside the limits are not reliable
statistics-advice-centred = do not correct: { $what ->
        [line] the size is now
       *[mean] the mean is
    } { $um } µm off the middle of the tolerance, which is noise with { $count } values
statistics-advice-near = do not correct: { $what ->
        [line] the size is now
       *[mean] the mean is
    } { $um } µm off the middle of the tolerance, { $count } values
statistics-advice-correct = correct by { $correction } µm: { $what ->
        [line] the size is now
       *[mean] the mean is
    } { $um } µm off the middle of the tolerance, { $count } values
statistics-advice-no-trend = no trend: the change from part to part is noise
statistics-advice-trend = the size changes by { $um } µm per part
statistics-advice-trend-at-limit = the size changes by { $um } µm per part, and parts beyond the limit must be expected now
statistics-advice-trend-to = the size changes by { $um } µm per part: about { $parts } parts are left until the limit ({ $level } %: { $least } to { $most })
statistics-advice-groups-alike = the groups do not differ more than by chance (p = { $p })
statistics-advice-groups-differ = the groups differ (p = { $p })
