# statistics

# Why there is no figure
statistics-reason-empty = there are no values
statistics-reason-not-a-number = value { $place } is not a number
statistics-reason-too-few = too few values or groups: { $found }, at least { $needed } needed
statistics-reason-all-equal = all values are equal: there is no spread to compute with
statistics-reason-no-subgroups = no subgroup has two values or more
statistics-reason-ungrouped = values that do not say to which group they belong: { $count }
statistics-look-grouped = Points are means: { $by ->
        [part] of the values of one part
        [batch] of the values of one batch
        [machine] of the values of one machine
        [gauge] of the values of one station
        [who] of the values of one person
       *[other] of values without a pause of more than { $minutes } min
    }.
statistics-look-stages = Points at which a stage begins: { $points }. The figures are those of the last stage.
statistics-look-waits = Stages that have too few different values yet and do not count so far: { $count }.
statistics-look-frozen = The control limits are those of points { $first } to { $last }.
statistics-look-memory = Second chart: { $method }.
statistics-look-no-memory = No chart { $method }: { $why }.
statistics-reason-large-subgroup = a subgroup has { $found } values: ranges are used for at most { $most }
statistics-reason-unequal-subgroups = subgroups have { $least } to { $most } values: this chart needs subgroups of equal size
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
statistics-chart-ewma = Weighted averages (EWMA)
statistics-chart-cusum = Sums of deviations from the mean (CUSUM)
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
statistics-advice-average-out = the weighted average is beyond its limits, first at point { $at }: the mean has moved
statistics-advice-sum-out = the sum is beyond the decision interval, first at point { $at }: the mean has moved, since about point { $since }
statistics-advice-groups-alike = the groups do not differ more than by chance (p = { $p })
statistics-advice-groups-differ = the groups differ (p = { $p })

# Studies of gauges
statistics-gauge-operator-per-value = every value has an operator of its own: are the columns right?
statistics-gauge-more-operators = operators: { $operators }, parts: { $parts }: are the columns of parts and operators swapped?
statistics-gauge-operators-differ-more = operators differ more than parts do: are the columns of parts and operators swapped?
statistics-gauge-same-parts = every operator has parts of the same names: is the study crossed?
statistics-gauge-several-masters = the values are of { $parts } parts, and this study needs one master
statistics-gauge-master-good = good enough for this tolerance: Cg and Cgk reach { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = not good enough for this tolerance: Cg and Cgk must reach { $required }, with a display step of at most 5 % of the tolerance (AIAG MSA, VDA 5)
statistics-gauge-smallest = smallest tolerance that it is good enough for: { $mm } mm ({ $level } %: up to { $most } mm)
statistics-gauge-biased = the bias of { $um } µm is more than chance (p = { $p })
statistics-gauge-not-biased = the bias of { $um } µm may be chance (p = { $p })
statistics-gauge-good = good enough: the gauge takes { $percent } % of { $of ->
        [tolerance] the tolerance
       *[variation] all variation
    }, and up to 10 % is good (AIAG MSA)
statistics-gauge-accepted = good enough only where it must do: the gauge takes { $percent } % of { $of ->
        [tolerance] the tolerance
       *[variation] all variation
    }, and 10 % to 30 % depends on the use (AIAG MSA)
statistics-gauge-bad = not good enough: the gauge takes { $percent } % of { $of ->
        [tolerance] the tolerance
       *[variation] all variation
    }, and more than 30 % is too much (AIAG MSA)
statistics-gauge-smallest-shares = smallest tolerance that it is good enough for: { $good } mm; where it must do: { $accepted } mm
statistics-gauge-interaction-kept = operators differ more on some parts than on others (p = { $p }): the interaction is kept
statistics-gauge-interaction-pooled = operators do not differ more on some parts than on others (p = { $p }): the interaction is pooled with the repeatability
statistics-gauge-negative = the variance of { $what ->
        [operator] operators
        [interaction] the interaction
       *[part] parts
    } came out negative and counts as 0
statistics-gauge-not-linear = the bias changes with the size (p = { $p })
statistics-gauge-linear = the bias does not change with the size more than by chance (p = { $p })
statistics-gauge-stable = stable: no rule fires and the readings do not drift
statistics-gauge-not-stable = not stable: a rule fires or the readings drift

# Why values make no study
series-study-no-parts = values that name no part: { $count }
series-study-no-operators = values that name no operator, beside others that do: { $count }
series-study-uneven-cell = readings of part { $part } by operator { $operator }: { $found }, expected { $needed }
series-study-uneven-operator = parts of operator { $operator }: { $found }, expected { $needed }
series-study-nested = each part was read by one operator only: this is a nested study
series-study-no-reference = values without a calibrated size: { $count }
series-study-references = the values of one master have several calibrated sizes

# How figures of a study are computed
series-method-word = { $word }
series-method-given = given
series-method-mean = mean, Student
series-method-deviation = standard deviation, chi-square
series-method-bias = mean - reference, Student
series-method-t-test = t test
series-method-type1 = type 1
series-method-share = { $percent } % of the tolerance, { $spread } s
series-method-required = Cg and Cgk at least { $required }
series-method-anova = analysis of variance
series-method-degrees = analysis of variance, { $degrees } degrees of freedom
series-method-ratio = F = { $f }
series-method-negative = negative, set to 0
series-method-chi-square = chi-square
series-method-large-sample = modified large sample
series-method-variances = variances
series-method-categories = 1.41 parts / gauge
series-method-linearity = linearity
series-method-least-squares = least squares
series-method-within-masters = s within masters
statistics-on-spread = spread: { $rule }
