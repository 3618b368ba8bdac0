## Tables of CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = no measured value in column actual
calypso-cut-off = the last line, END, is missing: the file may be cut off
calypso-warning-no-end = the last line, END, is missing: the file may be cut off
calypso-warning-behind = skipped after the line END: { $given }
calypso-warning-cut-off = the file ends here without a line end: the row may be cut off
calypso-warning-deviation = the table has a deviation of { $given } mm, but its values give { $expected } mm
calypso-warning-exceed = the table has { $given } mm beyond the tolerance, but its values give { $expected } mm
