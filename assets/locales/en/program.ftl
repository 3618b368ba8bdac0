# NC programs

## Reading
program-empty = the program is empty
program-too-large = the program is larger than { $most } MiB
program-too-many-lines = the program has more than { $most } lines
program-binary = the file is not text: { $controls } of its { $bytes } bytes are not characters
program-no-begin = the program does not begin with BEGIN PGM
program-second-begin = second BEGIN PGM
program-no-end = END PGM is missing
program-units = END PGM says { $end }, BEGIN PGM says { $begin }
program-after-end = text after END PGM is not part of the program
program-no-section = { $section } is missing
program-no-unit = the head does not give the unit (#EINHEIT METRISCH / INCH): the program is read as one in mm
program-after-last-section = only subprograms may follow ENDE / END
program-unclosed-comment = the comment has no closing bracket ]
program-numbers = block number { $number } follows { $previous }; block numbers out of order: { $count }
program-label-again = LBL { $label } is already defined in line { $first }
program-unclosed-quote = the quotation mark is not closed
program-open-end = the line ends in ~, but nothing follows
program-cycle-cut = cycle { $cycle } ended in line { $line }, which has no ~ at its end: { $parameter } is not part of it and would be assigned instead
program-no-star = the block does not end in *
program-iso-no-end = the last block is missing: % with the name of the program
program-iso-units = the last block says { $end }, the first { $begin }
program-iso-after-end = text after the last block is not part of the program
program-iso-cycle-cut = cycle { $cycle } ended in line { $line }: { $parameter } is not part of it and would be assigned instead
program-comment-holds = { $found } is part of the comment, which ends at the end of its line
program-cycle-without-tilde = cycle { $cycle } ended in line { $line }, which has no ~ at its end: the lines below are read as part of it
program-block-goes-on = the block above ends in ~, so this block would be part of it
program-comment-goes-on = the comment ends in ~, so this block would be part of it
program-not-understood = not understood: { $reason }
program-more = { $count } more remarks are not listed

## Labels
program-label-missing = LBL { $label } does not occur in the program
program-label-twice = LBL { $label } is defined twice, in line { $first } and line { $second }
program-label-zero = LBL 0 ends a subprogram: nothing can jump to it
program-label-parameter = which label { $label } holds is known only while the program runs

## Why a block is not understood
program-missing = { $wanted } is missing
program-unexpected = expected { $wanted }, found { $found }
program-left-over = unexpected text { $found }
program-unknown-function = { $found } is not a function
program-number-size = { $found } is too large
program-parameter-range = { $found } is not a parameter: { $family } goes from { $least } to { $most }
program-range = { $found } is too large: at most { $most }
program-label-of-parameter = { $parameter } cannot be the name of the label that begins here
program-relation = FN { $number } compares with { $allowed }: found { $found }
program-not-together = { $one } and { $other } cannot be in the same block
program-unknown-word = { $found } is not known
program-no-form = the ISO form of { $found } is not known
program-measure-unknown = it is not known whether G90 or G91 is active here
program-and-with-or = AND and OR in one condition need brackets that show which comes first
program-letter-twice = { $letters } is given twice
program-second-unit = another unit was given before
program-acts-in-unit = units are passed over, but this block measures, calls or sets a variable
program-shifts-in-unit = units are passed over, but this block may shift the zero point
program-alone = { $found } without { $missing }
program-axis-twice = an axis is given twice
program-too-deep = brackets and functions are nested more than { $most } deep
program-too-many-operands = the formula has more than { $most } operands
program-too-long = the block has more than { $most } characters
program-too-much = formulas and long blocks take more than { $most } MiB in all
program-wanted-word = { $word }
program-wanted-number = a number
program-wanted-value = a number or a Q parameter
program-wanted-value-or-variable = a number or a variable
program-wanted-variable = a variable (#l, #c, #g, #x, #i)
program-wanted-parameter = a parameter
program-wanted-number-parameter = a Q, QL or QR parameter
program-wanted-text-parameter = a QS parameter
program-wanted-text = a quoted text or a QS parameter
program-wanted-label = a label
program-wanted-path = a path
program-wanted-relation = EQU, NE, GT, LT or IS
program-wanted-unit = MM or INCH
program-wanted-cycle-value = a value
