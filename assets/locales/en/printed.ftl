## Printed reports
printed-no-value = no measured value below { $column }
printed-cells = { $found } figures below { $expected } columns: it is not clear which figure stands in which column; print the report with all columns
printed-no-column = no column { $column }: add the measured values to the print format of the report
printed-no-heading = figures without a heading above them: the beginning of the dimension is missing
printed-no-rows = { $name } has no row: the report may be cut off
printed-minus-sign = the minus tolerance { $given } can lie below or above the nominal value, and no other row decides: print minus tolerances without a sign
printed-unknown-row = unknown axis { $given }: the row is skipped
printed-warning-deviation = the report has a deviation of { $given } mm, but its figures give { $expected } mm
printed-warning-beyond = the report has { $given } mm beyond the tolerance, but its figures give { $expected } mm
printed-warning-no-end = the last line, { $end }, is missing: the report may be cut off
printed-warning-lines = skipped, not a measurement: { $text } (lines of this kind in all: { $count })
printed-warning-out-of-place = the report says { $given }, and none of its limits that are read here says so: look at the report
