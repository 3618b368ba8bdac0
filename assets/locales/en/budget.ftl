# budget

budget-toml = { $said }
budget-too-large = a budget file has at most { $most } KiB
budget-not-one = a budget needs either [[contribution]] tables or one [calibrated] table
budget-too-many = { $count } contributions: a budget has at most { $most }
budget-empty = { $key } is empty: expected a text
budget-day = { $key }: { $given } is not a day: expected YYYY-MM-DD
budget-days = valid_until { $until } is before date { $date }
budget-key = { $table }: { $key } is not used here: the allowed keys are { $allowed }
budget-missing = { $table }: { $keys } is missing
budget-range = { $table }: { $key } is { $given }: expected { $least } to { $most }
budget-resolution-law = { $table }: a resolution is rectangular: expected law = "rectangular" or no law
budget-geometry = { $table }: { $error }
budget-length = { $key }: { $error }
budget-geometry-touches = { $touches } touches: expected 3 to { $most }
budget-geometry-step = { $touches } touches at { $step } degrees: expected a step of 0.01 to { $most } degrees
budget-evaluation-no-size = { $contribution } depends on the size, but no size is given
budget-evaluation-no-contacts = { $contribution } depends on the contacts, but the budget has no touches and step_deg, and no contacts are given
budget-evaluation-nothing = every contribution is zero
budget-calibrated-too-few = { $readings ->
        [one] one reading
       *[other] { $readings } readings
    }: at least 2 are needed
budget-calibrated-far-away = the mean of the readings, { $mean } mm, is more than 1 mm from the calibrated size, { $size } mm
budget-calibrated-nothing = every uncertainty is zero

budget-warning-expired = the budget has expired: it was valid until { $until }
budget-warning-not-yet = the budget is not valid yet: its date is { $date }
budget-warning-of-template = the budget still has entries from the template for its name, its author or its figures: they say nothing about this station
budget-warning-failed-study = a study says of this gauge: { $why }
budget-warning-template-figures = these contributions still have the figures of the template: { $contributions }. Check that they are true of this station
budget-warning-few-readings = { $readings } readings of the calibrated piece: ISO 15530-3 asks for at least { $fewest }
budget-warning-bias-corrected = bias { $bias } µm: the uncertainty applies to values from which the bias has been subtracted; Fitcheck does not subtract it
budget-warning-bias-not-corrected = bias { $bias } µm: it is not corrected, so the uncertainty includes it
budget-warning-other-size = the calibrated piece of the budget has { $calibrated } mm, but { $measured } mm were measured: the uncertainty applies to parts like the piece
budget-warning-other-side = the calibrated piece of the budget is a { $calibrated ->
    [hole] hole, but a shaft was measured
   *[shaft] shaft, but a hole was measured
    }
budget-warning-other-expansion = { $contribution } of the budget has the expansion { $budget } · 10⁻⁶/K, but the value was corrected with { $given }
budget-warning-other-temperature = { $contribution } of the budget is for a temperature { $budget } K from 20 °C, but the value was corrected for { $given } K
budget-warning-recorded = { $text }
