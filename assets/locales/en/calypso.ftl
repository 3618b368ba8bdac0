## Tables of CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = no measured value in column actual
calypso-cut-off = the last line, END, is missing: the file may be cut off
calypso-row-cut-off = the file ends here without a line end, so the row may be cut off: it is skipped; if it is complete, add a line end
calypso-zeros = the line has bytes of value 0, so the file was not written completely: the row is skipped
calypso-differs = the rows of { $name } in lines { $first } and { $second } have different nominal values or limits
calypso-warning-no-end = the last line, END, is missing: the file may be cut off
calypso-warning-behind = skipped after the line END: { $given }
calypso-warning-zeros = the file has bytes of value 0 here, so it was not written completely: rows may be missing
calypso-warning-deviation = the table has a deviation of { $given } mm, but its values give { $expected } mm
calypso-warning-exceed = the table has { $given } mm beyond the tolerance, but its values give { $expected } mm
