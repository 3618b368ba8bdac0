page-pairing = Pairing

# What is asked
pairing-page-wanted = Wanted clearance or fit
pairing-page-wanted-hint = Smallest and largest in mm, such as 0.010..0.030, or a fit, such as 25 H7/g6. Negative is interference.
pairing-page-wanted-range = Clearance { $minimum } … { $maximum } µm, middle { $middle } µm
pairing-page-wanted-fit = { $fit }: clearance { $minimum } … { $maximum } µm, middle { $middle } µm
pairing-page-wanted-refused = { $reason }; allowed are a fit, such as 25 H7/g6, and two clearances in mm, such as 0.010..0.030
pairing-page-holes = Measured holes
pairing-page-shafts = Measured shafts
pairing-page-no-parts = none yet
pairing-page-reading = reading…
pairing-page-from-file = { $name }, { $count ->
        [one] 1 part
       *[other] { $count } parts
    }
pairing-page-from-history = From the history, { $count ->
        [one] 1 part
       *[other] { $count } parts
    }
pairing-page-refused = { $count ->
        [one] 1 row refused
       *[other] { $count } rows refused
    }
pairing-page-all-refused = All { $count } refused rows
pairing-page-all-notes = All { $count } warnings
pairing-page-open-holes = Open holes…
pairing-page-open-shafts = Open shafts…
pairing-page-history-holes = Holes of the history
pairing-page-history-shafts = Shafts of the history
pairing-page-history-hint = Uses the chosen checks, or all that are listed if none is chosen
pairing-page-groups = Groups
pairing-page-groups-hint = Number of groups of equal width into which the parts are also sorted. Leave empty for none.
pairing-page-do-wanted = Type the wanted clearance or a fit.
pairing-page-do-holes = Open the measured holes, or take them from the history.
pairing-page-do-shafts = Open the measured shafts, or take them from the history.
pairing-page-about = Fitcheck makes as many pairs as possible within the wanted clearance. Of all ways to do so, it takes the one with the least sum of squared distances from the middle. Names and measured sizes are enough. Files can also be dropped here, the holes first.
pairing-page-no-side = { $name } is not opened: there are holes and shafts already. Open it as holes or as shafts.
pairing-page-none-in-history = The history has no checks of { $feature ->
        [hole] holes
       *[shaft] shafts
    }.
pairing-page-listed-only = The history is filtered: the { $feature ->
        [hole] holes
       *[shaft] shafts
    } come from the { $listed } listed checks of { $all }
pairing-page-none-chosen = None of the chosen checks is of a { $feature ->
        [hole] hole
       *[shaft] shaft
    }.
pairing-page-nothing-read = { $name } has no size that can be used: { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }({ $count } rows refused)
    }
pairing-page-nothing-to-save = there are no pairs to save

# The pairs
pairing-page-pairs = Pairs
pairing-page-hole = Hole
pairing-page-shaft = Shaft
pairing-page-clearance = Clearance
pairing-page-from-middle = From the middle
pairing-page-from-middle-head = From middle
pairing-page-remark = Remark
pairing-page-line = line { $line }
pairing-page-check = check { $line }
pairing-page-hole-simulated = hole simulated
pairing-page-shaft-simulated = shaft simulated
pairing-page-both-simulated = both simulated
pairing-page-list = Pairs of holes and shafts
pairing-page-row = { $hole } { $hole-mm } mm with { $shaft } { $shaft-mm } mm, clearance { $clearance } µm, { $middle } µm from the middle
pairing-page-move = Go to another pair
pairing-page-copy = Copy pairs

# The picture
pairing-page-picture = Parts by size
pairing-page-legend = Ring: hole. Disc: shaft, shifted by the middle, { $middle } µm: a pair at the middle is level. Cross: leftover.
pairing-page-part-of = Left: all parts; the frame marks those that are drawn.
pairing-page-thinned = Too close to draw all: 1 of { $step } is drawn.
pairing-page-left-over = left over
pairing-page-describe = { $holes ->
        [one] 1 hole
       *[other] { $holes } holes
    } on the left, { $shafts ->
        [one] 1 shaft
       *[other] { $shafts } shafts
    } on the right, on one scale of size; shafts are shifted by { $middle } µm, so that a pair at the middle of the wanted clearance is level. { $pairs ->
        [one] 1 pair is drawn as a line.
       *[other] { $pairs } pairs are drawn as lines.
    }
pairing-page-describe-part = { $pairs ->
        [one] 1 pair is visible.
       *[other] { $pairs } pairs are visible.
    }
pairing-page-describe-selected = Selected: { $hole } with { $shaft }, clearance { $clearance } µm.

# The answer
pairing-page-count = { $count ->
        [one] 1 pair
       *[other] { $count } pairs
    }
pairing-page-none = No answer yet
pairing-page-at-work = Pairing…
pairing-page-nothing-left = nothing left over
pairing-page-left = left over: { $holes ->
        [one] 1 hole
       *[other] { $holes } holes
    }, { $shafts ->
        [one] 1 shaft
       *[other] { $shafts } shafts
    }
pairing-page-simulated = { $count ->
        [one] 1 pair with a simulated part
       *[other] { $count } pairs with a simulated part
    }
pairing-page-no-pair = No hole and shaft have a clearance in the wanted range.
pairing-page-smallest = Smallest clearance
pairing-page-largest = Largest clearance
pairing-page-middle = Wanted middle
pairing-page-band = Band around it
pairing-page-grinding = Grinding
pairing-page-grind = { $amount } µm off the leftover shafts, or out of the leftover holes: { $count ->
        [one] 1 more pair
       *[other] { $count } more pairs
    }
pairing-page-grind-means = The smallest amount, in steps of 1 µm, that gives the most additional pairs. Existing pairs are kept.
pairing-page-grind-nothing = No amount gives another pair.
pairing-page-grind-bounded = Amounts up to { $tried } µm were tried; the farthest parts would need { $reach } µm.
pairing-page-groups-title = Groups
pairing-page-group = Group { $number }: { $count ->
        [one] 1 pair
       *[other] { $count } pairs
    }
pairing-page-all-within = ✓ all within
pairing-page-not-all-within = ✗ not all within
pairing-page-no-group-pairs = one side is empty
pairing-page-group-holes = { $count ->
        [one] 1 hole
       *[other] { $count } holes
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] 1 shaft
       *[other] { $count } shafts
    } { $from } … { $to } mm
pairing-page-group-clearance = clearance { $range }
pairing-page-outside-groups = In no group, outside the zones: { $holes ->
        [one] 1 hole
       *[other] { $holes } holes
    }, { $shafts ->
        [one] 1 shaft
       *[other] { $shafts } shafts
    }

# Files
pairing-page-save-csv = Save as CSV…
pairing-page-save-json = Save as JSON…
pairing-page-file-name = pairs
pairing-page-dialog-holes = Open measured holes
pairing-page-dialog-shafts = Open measured shafts
pairing-page-dialog-save = Save pairs
file-kind-holes = Measured holes
file-kind-shafts = Measured shafts
file-kind-pairs = Pairs
