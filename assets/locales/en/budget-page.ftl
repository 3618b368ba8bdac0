page-budget = Uncertainty
page-budget-also = Budget

budget-page-text = Budget as TOML
budget-page-none = Create a new budget, or open one
budget-page-new = New budget
budget-page-open = Open budget…
budget-page-save = Save budget as…
budget-page-dialog-open = Open a budget
budget-page-dialog-save = Save the budget
budget-page-dialog-readings = Readings of the calibrated piece
budget-page-not-saved = { $name }, not saved

budget-page-for = Evaluated for
budget-page-size = Measured size
budget-page-contacts = Contacts
budget-page-touches = Number of contacts
budget-page-step = Step
budget-page-contacts-hint = Empty: the contacts of the budget
budget-page-day = Day
budget-page-day-hint = Day empty: today, { $day }
budget-page-no-day = { $given } is not a day: expected YYYY-MM-DD
budget-page-other-missing = Missing: give both the number of contacts and the step, or neither
budget-page-take-check = From the shown check
budget-page-take-recorded = Recorded contacts
budget-page-own-contacts = From the budget
budget-page-of-check = { $count } contacts of the check { $what }, { $time }
budget-page-of-simulated-check = { $count } contacts of the check { $what }, { $time }, simulated
budget-page-of-recorded = { $count } recorded contacts of { $name }
budget-page-contacts-used = { $count } contacts, factor { $factor }
budget-page-contacts-stepped = { $count } contacts at { $step }°, factor { $factor }
budget-page-no-circle = The contacts are not used: { $problem }

budget-page-readings = Readings
budget-page-open-readings = From a file…
budget-page-take-readings = From the history
budget-page-own-readings = From the budget
budget-page-readings-own = { $count ->
        [one] one reading in the budget
       *[other] { $count } readings in the budget
    }
budget-page-readings-of-file = { $count ->
        [one] one reading of { $name }
       *[other] { $count } readings of { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] one reading: the check of the history
       *[other] { $count } readings: all checks of the history
    }
budget-page-readings-of-chosen = { $count ->
        [one] one reading: the chosen check of the history
       *[other] { $count } readings: the chosen checks of the history
    }
budget-page-readings-are-shafts = { $count ->
        [one] a check of a shaft is
       *[other] { $count } checks of shafts are
    } not used: the piece is a hole
budget-page-readings-are-holes = { $count ->
        [one] a check of a hole is
       *[other] { $count } checks of holes are
    } not used: the piece is a shaft
budget-page-readings-simulated = { $count ->
        [one] one reading is
       *[other] { $count } readings are
    } simulated: nothing was measured
budget-page-more-notes = { $count ->
        [one] and one more
       *[other] and { $count } more
    }

budget-page-answer = Expanded uncertainty
budget-page-no-answer = No answer
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } for 95.45 %
budget-page-at-size = For { $size } mm; each check has the uncertainty of its own size
budget-page-covered-by = k = { $k } by { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Effective degrees of freedom { $degrees }
budget-page-infinite = infinite
budget-page-valid = Valid until { $until }
budget-page-expired = EXPIRED
budget-page-expired-on = valid until { $until }, on { $day }
budget-page-not-yet = NOT YET VALID
budget-page-not-yet-on = valid from { $date }
budget-page-made = Created { $date } by { $by }
budget-page-method = Method { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Largest contribution
budget-page-largest-is = { $name }, { $percent } % of the variance
budget-page-help = What would help most
budget-page-help-halved = Half of it: u = { $u } µm
budget-page-help-part-temperature = Half the uncertainty of the part temperature: u = { $u } µm
budget-page-help-scale-temperature = Half the uncertainty of the scale temperature: u = { $u } µm
budget-page-help-expansion = Half the distance from 20 °C, or half the uncertainty of the expansion: u = { $u } µm
budget-page-help-full-circle = { $count } contacts evenly spaced around the full circle: u = { $u } µm
budget-page-help-more-touches = { $count } contacts evenly spaced around the full circle: u = { $u } µm

budget-page-checks = Checks
budget-page-use = Use for checks
budget-page-leave = Stop using
budget-page-uses-none = Checks use no budget
budget-page-uses-this = In use: { $name }
budget-page-uses-another = In use: { $name } from { $file }, which differs from what is shown here
budget-page-uses-typed = “{ $name }” does not count: checks use the uncertainty that is chosen on Check
budget-page-uses-no-rule = “{ $name }” is chosen, but no rule on Check uses an uncertainty yet: choose the rule there
budget-page-used-before = Until now, checks used the typed uncertainty ({ $uncertainty }). “Stop using” brings it back
budget-page-used = Checks use the budget { $name }
budget-page-used-no-rule = “{ $name }” changes no verdict yet: the rule on Check is “{ $rule }”, which uses no uncertainty. Choose another rule
budget-page-not-kept = Save the budget to keep using it after a restart
budget-page-readings-not-kept = The readings are not in the budget file: after a restart, the budget is no longer used
budget-page-used-unread = { $path }: the budget in use for checks cannot be read, so checks use no budget: { $problem }

budget-page-table = Contributions
budget-page-column-name = Name
budget-page-column-type = Type
budget-page-column-law = Law
budget-page-column-sensitivity = c
budget-page-column-share = Share
budget-page-row = { $name }, type { $type }, { $law }, u { $u } { $unit }, sensitivity { $sensitivity }, contribution { $um } µm, share { $percent } %, degrees of freedom { $degrees }
budget-page-law-normal = normal
budget-page-law-rectangular = rectangular
budget-page-law-u-shaped = U-shaped
budget-page-law-triangular = triangular
budget-page-shares = Shares of the variance
budget-page-terms = Terms and expanded uncertainty
budget-page-mean = Mean of the readings { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, corrected
budget-page-edition-2004 = U, 2004, not corrected
budget-page-nothing-seen = The table and the shares appear once the budget can be evaluated
budget-page-named = { $name }
budget-page-placeholders = Checks cannot use this budget yet. These entries are still those of the template: { $what }. Type your own in their fields
budget-page-placeholder-name = its name (“{ $name }”)
budget-page-placeholder-by = who made it (“{ $by }”)
budget-page-placeholder-figures = the figures of all contributions

## The budget as a table

budget-show-table = Table
budget-show-text = Text
budget-rows = Contributions
budget-head-name = Name of the budget
budget-head-by = Made by
budget-row-new = New contribution
budget-row-add = Add contribution
budget-row-remove = Remove contribution
budget-row-removed = Contribution “{ $name }” removed from the budget
budget-row-comments-removed = Comments that stood beside the removed keys are gone
budget-row-said = { $value } { $unit }, divisor { $divisor }, { $law }
budget-row-unread = not complete
budget-row-name = Name
budget-row-k = Coverage factor k
budget-row-alpha = Expansion, 1/K
budget-row-delta = Distance from 20 °C
budget-row-touches = Own contacts
budget-row-step = Own step
budget-row-sensitivity = Sensitivity c
budget-row-freedom = Degrees of freedom
budget-row-freedom-a = Degrees of freedom, n − 1 of n readings
budget-row-kind = Counts for
budget-row-type = Type
budget-row-law = Law
budget-row-given = Given as
budget-row-half-width = Half width
budget-row-resolution = Step of the display
budget-given-standard = Standard uncertainty
budget-given-expanded = Expanded uncertainty
budget-type-a = A, statistics
budget-type-b = B, other
budget-kind-plain = Diameter
budget-kind-scatter = Scatter of a touch
budget-kind-part-temperature = Temperature of the part
budget-kind-scale-temperature = Temperature of the scales
budget-kind-part-expansion = Expansion of the part
budget-kind-scale-expansion = Expansion of the scales
budget-kind-resolution = Resolution
budget-table-stale = The text has a fault: the table shows the contributions as they last were
budget-table-other = The text writes its contributions in a way that the table cannot change. Edit the text
budget-table-calibrated = This budget is of a calibrated piece and has no contributions. Edit the text
budget-law-normal = Normal law
budget-law-rectangular = Rectangular law
budget-law-u-shaped = U-shaped law
budget-law-triangular = Triangular law
