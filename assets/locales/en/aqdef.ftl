## AQDEF of Q-DAS
aqdef-line = expected a key and a text such as K0001/1 25.012, or a line of values
aqdef-number = { $key }: { $reason }
aqdef-whole = { $key }: { $given } is not a whole number
aqdef-undeclared = value of characteristic { $number }, which is not declared before this line
aqdef-of-all = { $key } with number 0 would be the value of every characteristic: it is skipped
aqdef-cut-off = the file ends here without a line end, so { $given } may be cut off: it is skipped; if it is complete, add a line end
aqdef-zeros = the line has bytes of value 0, so the file was not written completely: the line is skipped
aqdef-mark-between = K0002/0 { $given } is between this row and the one before it and may apply to either: the value is skipped
aqdef-twice = { $key } is given twice with different texts, before with { $other }: values of this characteristic are not judged
aqdef-fields = expected at most { $most } fields in a value, found { $found }
aqdef-no-values = { $count ->
        [0] neither characteristics nor values
        [one] 1 characteristic but no values: this is a plan, not measurements
       *[other] { $count } characteristics but no values: this is a plan, not measurements
    }
aqdef-no-values-beside = { $count ->
        [0] neither characteristics nor values
        [one] 1 characteristic but no values
       *[other] { $count } characteristics but no values
    }, and no { $file } of up to { $most } MiB beside this file: this is a plan, not measurements; give { $file } itself if it is larger
aqdef-no-description = values without characteristics: { $file } is missing beside this file
aqdef-count = K0100 announces { $expected } characteristics, found { $found }: the file may be cut off
aqdef-too-large = the characteristics take more than { $most } MiB
aqdef-beside = { $file }, line { $line }: { $reason }
aqdef-warning-count = K0100 announces { $expected } characteristics, found { $found }: the file may be cut off
aqdef-warning-fewer = expected { $expected } values, found { $found }
aqdef-warning-missing = { $count ->
        [one] 1 value is empty or marked as missing (K0002 is 255 or 256), from this line on: it is skipped
       *[other] { $count } values are empty or marked as missing (K0002 is 255 or 256), from this line on: they are skipped
    }
aqdef-warning-skipped = entries skipped: { $keys }
aqdef-warning-repeated = { $key } is given twice with different texts: this one is used
aqdef-warning-late = { $key } does not belong to a value read just before it: it is skipped
aqdef-warning-allowance = nominal size and allowance give { $limit }, but the limit is different: the limit applies
aqdef-warning-tolerance = { $key } has a tolerance of { $given } mm, but the limits give { $expected } mm: the limits apply
aqdef-warning-no-limit = { $key } is given, but K2120 or K2121 says that there is no such limit: it is skipped
aqdef-warning-kind-of-limit = { $given } is not a known kind of limit (0, 1 or 2): it is read as a limit
aqdef-warning-scrap-limit = the scrap limit { $limit } differs from the limit: it is skipped, and a value beyond the limit on this side is scrap
aqdef-warning-scrap-feature = the scrap limit is that of { $feature ->
        [hole] a hole
       *[shaft] a shaft
    }, but { $callout } is not: the tolerance class applies
aqdef-warning-cut-off = the file ends here without a line end, and { $given } is shorter than the others: it may be cut off
aqdef-warning-zeros = the file has bytes of value 0 here, so it was not written completely: values may be missing
aqdef-warning-values-left = { $file } has { $count ->
        [one] 1 line of values, which is not read
       *[other] { $count } lines of values, which are not read
    }
aqdef-warning-values-beside = the values come from { $file } beside this file, and line numbers refer to it
aqdef-warning-description-beside = the characteristics come from { $file } beside this file
aqdef-warning-beside = { $file }, line { $line }: { $reason }
