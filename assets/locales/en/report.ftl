# report

## Errors
report-error-writer = the { $format } report could not be made: { $reason }
report-error-label-alone = { $format } is for labels: choose the template label, or the paper small-label or large-label
report-error-no-statistics = { $format } has no place for statistics: choose PDF, HTML or Markdown
report-attachment-too-large = the data of the file is larger than { $most } bytes
report-attachment-packed = the data in the file is packed with { $filter }, which Fitcheck does not read
report-attachment-damaged = the data in the file is damaged: { $reason }
report-attachment-several = the file has { $count } attachments with checks: expected one
report-difference-field = entry { $number }: { $field } is { $said } in the file, { $kept } in the journal
report-difference-missing = entry { $number }: no check of the file says what the journal says
report-difference-more = { $count ->
    [one] the file has 1 check too many
   *[other] the file has { $count } checks too many
}
report-difference-fewer = { $count ->
    [one] 1 check is missing in the file
   *[other] { $count } checks are missing in the file
}
report-data-json = the data of the file is not a report of Fitcheck: { $reason }
report-ending-missing = { $file } has no ending that gives the report's format: use one of { $endings }
report-ending-unknown = .{ $ending } is not a format of the report: use one of { $endings }

## Sentences about one check
report-feature-hole = hole
report-feature-shaft = shaft
report-feature-neither = neither hole nor shaft
report-side-good = good
report-side-rework = rework
report-side-scrap = scrap
report-side-out = out of limits
report-side-too-small = too small
report-side-too-large = too large
report-source-instead = { $source }; ISO 286 says { $upper } and { $lower } µm here
report-too-small = { $um } µm too small
report-too-large = { $um } µm too large
report-inside = inside the limits
report-above-minimum = { $um } µm above minimum
report-below-minimum = { $um } µm below minimum
report-below-maximum = { $um } µm below maximum
report-above-maximum = { $um } µm above maximum
report-position-unknown = not measured
report-position-unmonitored = not monitored
report-position-in = IN
report-position-out = OUT
report-axis-unmonitored = { $axis } { $deviation } mm: not monitored
report-axis-in = { $axis } { $deviation } mm, permitted ± { $tolerance } mm: IN
report-axis-out = { $axis } { $deviation } mm, permitted ± { $tolerance } mm: OUT
report-cause-position = the centre is out of position; the size alone is { $status }
report-origin-circle = { $origin }; least-squares circle through { $contacts } contacts
report-centre = measured centre X { $x } mm, Y { $y } mm
report-band-nominal = nominal size { $size } mm
report-band-title = Limit band, measured { $value }: { $distances }
report-in-guard-band = nothing is decided: the value lies in a guard band of the decision rule
report-corrected = measured { $measured } mm at { $temperature } °C, expansion { $expansion } · 10⁻⁶/K: corrected by { $change } µm to { $reference } mm at 20 °C
report-all-corrected = measured at { $temperature } °C, expansion { $expansion } · 10⁻⁶/K; every value is corrected to 20 °C
report-scales = scales at { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = without a correction of the scales
report-own-uncertainty = u of each value beside its check
report-accepted-zone = { $least } to { $most } mm
report-accepted-none = none: the rule leaves no part of this tolerance
report-proven = proven by this rule
report-not-proven = not proven by this rule
report-conformity = conforms with a probability of { $percent } %
report-budget-made = { $name }, created { $date } by { $by }, valid until { $until }
report-budget-expired = EXPIRED on the day of the check
report-budget-not-yet = NOT YET VALID on the day of the check
report-guard-undecided = guard band: re-measure
report-guard-beyond = guard band: accepted beyond the limit
report-guard-range = { $what }, { $from } to { $to } µm

## The page
report-title = Inspection report
report-part = Part
report-order = Order
report-inspector = Inspector
report-program = Program
report-notes = Skipped rows and warnings
report-no-checks = This report has no checks.
report-page-all-good = None of the { $total } checks is listed on this page: all are good and none is in doubt. A CSV or JSON report lists every check.
report-page-not-good = This page lists only the { $listed } of { $total } checks that are not good or in doubt. The counts include every check; a CSV or JSON report lists them all.
report-page-first = This page lists only the first { $listed } of { $wanted } checks that are not good or in doubt, out of { $total } checks. The counts include every check; a CSV or JSON report lists them all.
report-total = Total
report-check = Check
report-id = Name
report-callout = Callout
report-heading-without-callout = { $nominal } mm, limits without a class
report-verdict = Verdict
report-nominal = Nominal size
report-maximum = Maximum
report-minimum = Minimum
report-measured = Measured
report-deviation = Deviation
report-remove = To remove
report-on-diameter = on diameter
report-per-side = per side
report-remove-to-limit = to the nearest limit
report-remove-to-middle = to the middle of the zone
report-remove-to-accepted = to the accepted values
report-position = Position
report-limits-from = Limits from
report-measured-from = Measured value
report-from = Source
report-limits = Limits
report-missing = Missing
report-skipped = Skipped
report-verdict-from = Decision rule
report-temperature = Temperature
report-accepted = Accepted values
report-proof = Proof
report-budget = Uncertainty budget
report-cannot-tell = Limits of this measurement
report-contacts = Contacts
report-contacts-at-end = at the end of the report
report-contact = No.
report-radial = radial deviation
report-sign-name = Name
report-sign-date = Date
report-sign-signature = Signature
report-footer = Each verdict is based on unrounded values and on the limits and the decision rule stated beside it.

## Notes
report-note = { $place }: { $what }
report-note-line = { $place }, line { $line }: { $what }
report-note-more = { $count ->
    [one] 1 more note is not listed
   *[other] { $count } more notes are not listed
}

## A whole part
report-balloon = Balloon
report-picture-room = { $name } is not shown here: the pictures of all parts would make the page too large
report-picture-beside = { $count ->
    [one] one feature has no balloon on it
   *[other] { $count } features have no balloon on it
}
report-part-older = { $count ->
    [one] One more value is not listed: for each size, only the value that counts is listed
   *[other] { $count } more values are not listed: for each size, only the value that counts is listed
}
report-more-parts = { $count ->
    [one] One more part is not shown in full; its values are in the list
   *[other] { $count } more parts are not shown in full, only the first { $most } are; their values are in the list
}

## Templates of reports
report-template-toml = { $reason }
report-template-version = template version { $found } is not supported: expected version { $known }
report-template-too-large = a template has at most { $most } bytes
report-template-text = { $key } is empty, is longer than { $longest } characters or has a control character
report-template-twice = { $key } lists { $word } twice
report-template-empty = { $key } is empty: list at least one
report-template-language = { $given } is not a language of reports: use one of { $known }
report-template-logo = the logo { $given } must be the name of a file beside the template
report-section-verdict = Verdict
report-section-head = Head
report-section-picture = Picture with balloons
report-section-lot = Parts, worst first
report-section-statistics = Statistics of features
report-statistics-limits = The limits differ from value to value: no capability is stated.
report-statistics-most = The statistics have only the first { $count } values.
report-section-features = Values
report-section-statement = Statement of conformity
report-section-rule = Rule and limits in words
report-section-caveats = Limits of the measurement
report-section-remarks = Remarks
report-section-signature = Signature line
report-section-code = Code of the record
report-revision = Revision
report-serial = Serial number
report-batch = Batch
report-customer = Customer
report-material = Material
report-station = Station
report-instrument = Instrument
report-calibrated = Calibrated
report-date = Date
report-plan = Plan
report-records = Records
report-blank = Value
report-remark = Remark
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Label 62 × 29 mm
report-paper-large-label = Label 100 × 50 mm
report-template-inspection = Inspection report
report-template-inspection-purpose = Parts or checks, with pictures
report-template-first-article = First article
report-template-first-article-purpose = Every feature, also what is missing
report-template-certificate = Certificate
report-template-certificate-purpose = Values and statement of conformity
report-template-list = List of checks
report-template-list-purpose = Any checks, one below the other
report-template-statistics = Statistics
report-template-statistics-purpose = Each feature over all its values, with charts
report-template-sheet = Measurement sheet
report-template-sheet-purpose = Empty, to fill in by hand
report-template-label = Label
report-template-label-purpose = Verdict, part and serial number
## Pages to print
report-pdf-page = Page { $page } of { $pages }
report-pdf-band = Limit band
report-pdf-remove = { $name }: remove { $um } µm on the diameter
report-pdf-simulated = Simulated values, measured by nobody: { $count } of { $total }
report-pdf-beyond = Values accepted outside the limits by the decision rule: { $count } of { $total }
report-pdf-corrected = Values corrected to 20 °C: { $count } of { $total }
report-pdf-guarded = Values judged by a decision rule of their own: { $count } of { $total }
report-pdf-doubted = Values in doubt, marked with a question mark: { $count } of { $total }
report-pdf-notes = Skipped rows and warnings, listed at the end: { $count }
report-pdf-more-lacks = More on the pages of the parts: { $count }
report-pdf-more = More in the attached data: { $count }
report-pdf-all-checks = All checks
report-pdf-attached = Attached to this file, for programs: { $names }
report-pdf-not-attached = Not all data are attached: a file of more than { $most } MB would be too large
report-pdf-contacts = The contacts are in the attached data.
report-pdf-cut = A text that ends in … is cut here; it is whole in the attached data.
report-pdf-substituted = A □ stands for a character that the fonts of these pages lack, such as those written from right to left; copied text and the attached data have the character.
report-statement-conforms = { $count ->
    [one] Statement of conformity: the value lies within its limits by the decision rule stated here.
   *[other] Statement of conformity: all { $count } values lie within their limits by the decision rule stated here.
}
report-statement-not = { $count ->
    [one] No conformity: the value does not conform by the decision rule stated here.
   *[other] No conformity: { $bad } of { $count } values do not conform by the decision rule stated here.
}
report-statement-partial = No statement of conformity: some rows were refused, not judged or not read. The report lists them.
report-statement-simulated = { $count ->
    [one] No statement of conformity: one value is simulated and was measured by nobody.
   *[other] No statement of conformity: { $count } values are simulated and were measured by nobody.
}
report-statement-open = No statement of conformity: values are missing, { $count } in all.
report-code-said = Code of record { $number }, its hash { $hash }
report-lot-order = Parts are listed with the worst first.
## A workbook
report-sheets = Only the first { $listed } of { $total } parts have a sheet of their own; the sheet of the parts lists all of them.
report-sheets-corrected = corrected to 20 °C
report-sheets-without = Pictures and contacts are not in this workbook: an HTML report has both, a JSON report has the contacts.
report-sheets-cut = { $count ->
    [one] One text is cut short: a cell holds at most 32767 characters.
   *[other] { $count } texts are cut short: a cell holds at most 32767 characters.
}
report-journal = Records { $numbers } of journal { $chain }; its last entry then: { $number }:{ $hash }
report-template-new-about = A template of reports. Delete what a report is not to show; remove the # of what it is to show.
report-template-new-name = New template
report-changed-since = Changed since the report of { $since }:
report-changed-none = no result and no limit
report-changed-result = { $name }: { $before } → { $now }
report-changed-limits = { $name }: limits { $low } to { $high } → { $lower } to { $higher } mm
report-changed-added = { $name }: new
report-changed-removed = { $name }: no longer in the report
report-changed-several = { $name }: not compared, because it has several values
report-since-no-report = not a report of Fitcheck with its data: give its PDF or its JSON
