# pairing

pairing-not-a-range = clearances { $given }: expected the smallest and the largest in mm with two points between them, such as 0.010..0.030
pairing-minimum = smallest clearance: { $reason }
pairing-maximum = largest clearance: { $reason }
pairing-swapped = the smallest clearance { $minimum } mm is larger than the largest, { $maximum } mm
pairing-too-narrow = { $feature ->
        [hole] holes
       *[shaft] shafts
    } from { $from } to { $to } mm cannot be sorted into { $count } groups: a group has at least one nanometre
pairing-group-count = { $count } groups: expected 1 to { $most }
pairing-no-sizes = there are no { $feature ->
        [hole] holes
       *[shaft] shafts
    } to sort

# What to check about parts
pairing-parts-outside-limits = { $count ->
        [one] 1 part is outside its own limits
       *[other] { $count } parts are outside their own limits
    }: pairs are chosen by clearance alone
pairing-parts-checked-twice = { $rows ->
        [one] a check has the name of an earlier check
       *[other] { $rows } checks have the name of an earlier check
    }, such as { $id }, checks { $first } and { $second }: each check counts as a part
pairing-parts-simulated-checks = { $count ->
        [one] 1 check is simulated
       *[other] { $count } checks are simulated
    }: nothing was measured
