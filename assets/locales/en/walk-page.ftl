# The walk through a part, and the watched folder, on the parts page.

walk-page-begin = Begin the part
walk-page-count-up = Count up
walk-page-take = Take value
walk-page-take-meant = Take { $meant } mm
walk-page-simulate = Simulate
walk-page-simulate-hint = Measures by the feature's cycle on a perfect part: nobody measured it, and it is marked so for good
walk-page-again = Measure again
walk-page-skip = Leave out
walk-page-skip-for = Leave out for this reason
walk-page-skip-not = Do not leave out
walk-page-next = Next part
walk-page-move = Another size
walk-page-import = Import values…
walk-page-watch = Watch a folder…
walk-page-watch-hint = Files that are dropped into it are judged by the plan and recorded, each once
walk-page-watch-stop = Stop watching
walk-page-dialog-watch = Watch a folder
walk-page-no-plan = No plan yet: open one, or write one on the view Plan.
walk-page-plan-wrong = { $count ->
        [one] The plan has a mistake: see the view Plan.
       *[other] The plan has { $count } mistakes: see the view Plan.
    }
walk-page-not-saved = The plan has changes that no file holds: a part that is interrupted cannot come back after a restart.
walk-page-serial = Serial number
walk-page-serial-hint = Type or scan it, or count it up; Enter begins the part.
walk-page-recent = Plans that were read last
walk-page-done = Every size has a value or a reason
walk-page-part = { $part }, serial number { $serial }
walk-page-part-serial = Serial number { $serial }
walk-page-part-no-serial = { $part } without a serial number
walk-page-other-plan = The plan has been changed since: that counts from the next part on.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = The plan has no place for it
walk-page-value = Measured value
walk-page-measured-before = { $count ->
        [one] Measured once: both values stay, and the next one counts
       *[other] Measured { $count } times: all values stay, and the next one counts
    }
walk-page-last-counts = Measured { $count } times: all values stay, and this one counts
walk-page-skip-why = Why is it left out?
walk-page-skip-access = No access for the probe
walk-page-skip-gauge = The gauge is missing
walk-page-skip-machined = Not machined yet
walk-page-skip-elsewhere = Measured elsewhere
walk-page-reason = Another reason
walk-page-no-reason = a reason is missing
walk-page-skipped = left out: { $reason }
walk-page-next-warned = { $count ->
        [one] A size has neither a value nor a reason. Next part once more ends the part.
       *[other] { $count } sizes have neither a value nor a reason. Next part once more ends the part.
    }
walk-page-question-enter = Enter once more takes it as it is.
walk-page-part-status = The part
walk-page-not-complete = No verdict yet
walk-page-simulated = { $count ->
        [one] One value is simulated: nobody measured it, and the part is not good by it.
       *[other] { $count } values are simulated: nobody measured them, and the part is not good by them.
    }
walk-page-missing = Missing: { $names }
walk-page-off = Records are turned off: an interrupted part cannot come back after a restart.
walk-page-nowhere = Nothing is recorded: an interrupted part cannot come back after a restart.
walk-page-no-part = No part is being measured.
walk-page-sizes = Sizes of the part
walk-page-open = open
walk-page-row-simulated = simulated
walk-page-times = { $count } values
walk-page-rule-plan = Judged by the plan's rule: { $rule }
walk-page-rule-own = The plan has no rule; judged by the rule of the check page: { $rule }
walk-page-nothing-asked = no size of the plan is asked for
walk-page-refused = { $count ->
        [one] A check is not recorded: { $why }
       *[other] { $count } checks are not recorded: { $why }
    }
walk-page-import-late = { $name } was read when the part was ended already: its values are not taken
walk-page-imported = { $name }: { $good } taken, { $bad } not
walk-page-other-parts = Values of other parts are recorded under their own serial numbers: { $serials }
walk-page-not-judged = line { $line }: { $why }
walk-page-no-journal = The part { $serial } is back without its values: nothing was recorded that they could come from
walk-page-gone = Some sizes are not in the plan any more: what was measured of them stays in the records
walk-page-gone-name = { $name }
walk-page-taken-back = A value of { $name } was corrected or withdrawn in the records: it counts no more for this part
walk-page-put-right = A value of { $name } was corrected in the records: the corrected one counts for this part
walk-page-no-folder = { $path } is not a folder
walk-page-not-read = The values of the interrupted part could not be read: { $why }
walk-page-came-back = { $count ->
        [one] The interrupted part { $serial } is back, with one value
       *[other] The interrupted part { $serial } is back, with { $count } values
    }
walk-page-watched = Watched folder
walk-page-watch-no-plan = a folder is watched with a plan without mistakes: open one first
walk-page-watch-no-journal = the journal cannot be opened: what was taken already is not known, so no folder is watched
walk-page-watch-begins = The journal is asked what was taken already
walk-page-known = { $count ->
        [0] Nothing was taken before
        [one] One file was taken before, and is not taken again
       *[other] { $count } files and parts of files were taken before, and are not taken again
    }
walk-page-mask = Prints are read back through the mask { $name }
walk-page-watch-recording = Being recorded
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] One file taken
       *[other] { $count } files taken
    }
walk-page-report = Report…
walk-page-report-other-picture = { $name }: the plan has named another picture since this part was begun
