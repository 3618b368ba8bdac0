# The walk through a part, and the watched folder, on the parts page.

walk-page-begin = Start part
walk-page-count-up = Next number
walk-page-take = Judge
walk-page-take-meant = Use { $meant } mm
walk-page-it-is-so = It is so: judge { $measured } mm
walk-page-measure-anew = Discard and measure again
walk-page-confirmed = confirmed when it was measured: it is so
walk-page-alarms = Open alarms: { $count }
walk-page-alarms-short = Alarms
walk-page-alarms-more = More alarms: { $count }
walk-page-alarm = { $name }: { $said }
walk-page-alarm-ask = Answer the alarm
walk-page-alarm-ask-of = Answer the alarm of { $name }
walk-page-alarm-answer = Record answer
walk-page-alarm-later = Later
walk-page-alarm-cause = Cause
walk-page-alarm-action = Action
walk-page-alarm-causes = Tool wear; New tool; Tool offset; Clamping; Chips or dirt; Temperature; Material; Measuring error; Unknown
walk-page-alarm-actions = Tool changed; Offset corrected; Part clamped again; Machine cleaned; Measured again; Setter told; Watched further; None needed
walk-page-alarm-empty = write a text, or choose one from the list
walk-page-alarms-unread = Cannot look at the rules of control charts: { $why }
walk-page-alarms-unchecked = Cannot look at the rules of control charts, { $name }: { $why }
walk-page-alarm-unrecorded = Cannot record the alarm of the control chart: { $why }
walk-page-simulate = Simulate
walk-page-simulate-hint = Runs the feature's cycle on a perfect part; nobody measures the value, and it stays marked as simulated
walk-page-again = Measure again
walk-page-skip = Skip
walk-page-skip-for = Skip for this reason
walk-page-skip-not = Do not skip
walk-page-next = Next part
walk-page-move = Go to another size
walk-page-import = Import values…
walk-page-watch = Watch a folder…
walk-page-watch-hint = Files dropped into the folder are judged by the plan and recorded, each one once
walk-page-watch-stop = Stop watching
walk-page-dialog-watch = Watch a folder
walk-page-begin-warned = { $count ->
    [one] 1 size of this part has neither a value nor a reason. Press it again to end this part.
   *[other] { $count } sizes of this part have neither a value nor a reason. Press it again to end this part.
}
walk-page-no-plan = No plan yet: open one, or create one in the Plan view.
walk-page-plan-wrong = { $count ->
        [one] The plan has a fault: see the Plan view.
       *[other] The plan has { $count } faults: see the Plan view.
    }
walk-page-not-saved = The plan has unsaved changes: an interrupted part cannot be restored after a restart.
walk-page-serial = Serial number
walk-page-serial-again = Serial number { $serial } has been measured already. Press Enter again, after half a second, to start it again.
walk-page-serial-hint = Type it, scan it or use the next number; Enter starts the part.
walk-page-recent = Recent plans
walk-page-done = Every size has a value or is skipped
walk-page-part = { $part }, serial number { $serial }
walk-page-part-serial = Serial number { $serial }
walk-page-part-no-serial = { $part }, no serial number
walk-page-other-plan = The plan has changed since: the changes apply from the next part on.
walk-page-part-of = This part is measured by { $own }
walk-page-open-is = Open now: { $open }
walk-page-begin-by = Begin a part by { $open }
walk-page-keep-on = Measure this part on
walk-page-unfinished = A part measured by { $own } is not finished. Measure asks whether to go on with it.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = No location in the plan
walk-page-value = Measured value
walk-page-measured-before = { $count ->
        [one] Measured once: both values are kept, and the new one is used
       *[other] Measured { $count } times: all values are kept, and the new one is used
    }
walk-page-last-counts = Measured { $count } times: all values are kept, and this one is used
walk-page-skip-why = Reason for skipping
walk-page-skip-access = No access for the probe
walk-page-skip-gauge = Gauge missing
walk-page-skip-machined = Not machined yet
walk-page-skip-elsewhere = Measured elsewhere
walk-page-reason = Other reason
walk-page-no-reason = a reason is required
walk-page-skipped = skipped: { $reason }
walk-page-next-warned = { $count ->
        [one] One size has neither a value nor a reason. Choose Next part again to end this part.
       *[other] { $count } sizes have neither a value nor a reason. Choose Next part again to end this part.
    }
walk-page-typed-elsewhere = the value was typed for { $name }, and { $asked } is asked for now: type it again
walk-page-next-size = Next: { $name }, { $asked }
walk-page-is-serial = { $given } looks like a serial number and is not taken as a value: finish this part first, then scan it for the next part. If it is the measured value, type it with more decimals
walk-page-simulate-measured = { $name } is measured: a simulated value never takes the place of a measured one
walk-page-part-status = Part status
walk-page-not-complete = No verdict yet
walk-page-simulated = { $count ->
        [one] One value is simulated: nobody measured it, so it cannot make the part good.
       *[other] { $count } values are simulated: nobody measured them, so they cannot make the part good.
    }
walk-page-missing = Missing: { $names }
walk-page-off = Records are turned off: an interrupted part cannot be restored after a restart.
walk-page-nowhere = Nothing is recorded: an interrupted part cannot be restored after a restart.
walk-page-no-part = No part is being measured.
walk-page-sizes = Sizes of the part
walk-page-open = open
walk-page-row-simulated = simulated
walk-page-times = { $count } values
walk-page-rule-plan = Judged by the plan's rule: { $rule }
walk-page-rule-own = The plan has no rule; judged by the rule on the check page: { $rule }
walk-page-nothing-asked = no size of the plan is being measured
walk-page-refused = { $count ->
        [one] One check was not recorded: { $why }
       *[other] { $count } checks were not recorded: { $why }
    }
walk-page-import-late = { $name } was read after the part had ended: its values are not used
walk-page-imported = { $name }: { $good } imported, { $bad } not
walk-page-file-for-check = Nothing in it is of this plan. Check can judge the file by what it asks for itself
walk-page-found-by-name = { $count ->
    [one] Matched by name: 1 row
   *[other] Matched by name: { $count } rows
}
walk-page-found-by-number = Matched by number alone, with their lines: { $rows }
walk-page-found-by-place = Matched by location, with their lines: { $rows }
walk-page-other-parts = Values of other parts are recorded under their own serial numbers: { $serials }
walk-page-label = The file has no serial numbers and calls the part { $part }: its values are taken for this part
walk-page-other-label = of the part { $part }, and without a serial number it is not known to be this part
walk-page-remark-label = Part in the file: { $part }
walk-page-not-judged = line { $line }: { $why }
walk-page-no-journal = Part { $serial } was restored without its values: there are no records to restore them from
walk-page-gone = Some sizes are no longer in the plan: their measured values stay in the records
walk-page-gone-name = { $name }
walk-page-changed = The plan has changed: values judged by other limits or another rule, and values of rows without a name, stay in the records, and their sizes are open again
walk-page-changed-size = { $name }: { $measured } mm was measured by { $asked }
walk-page-given-up = The interrupted part { $serial } is not restored, because another part has been started: its values stay in the records
walk-page-ended = Not used for the part { $serial }, which has ended
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = A value of { $name } was corrected or withdrawn in the records: it no longer applies to this part
walk-page-put-right = A value of { $name } was corrected in the records: the corrected one applies to this part
walk-page-no-folder = { $path } is not a folder
walk-page-not-read = The values of the interrupted part could not be read: { $why }
walk-page-came-back = { $count ->
        [one] The interrupted part { $serial } was restored with one value
       *[other] The interrupted part { $serial } was restored with { $count } values
    }
walk-page-watched = Watched folder
walk-page-part-waits = Part { $serial } is restored once its plan has no faults
walk-page-watch-waits = Folder { $path } is watched again once the plan has no faults
walk-page-watch-no-plan = watching a folder needs a plan without faults: open one first
walk-page-watch-no-journal = the journal cannot be opened: which files were imported before is unknown, so no folder is watched
walk-page-watch-begins = Checking the journal for files imported before
walk-page-known = { $count ->
        [0] The journal has no files that were imported before
        [one] The journal has one file that was imported before, from any folder: it is not imported again
       *[other] The journal has { $count } files and parts of files that were imported before, from any folder: they are not imported again
    }
walk-page-mask = FN 16 output is read back through the mask { $name }
walk-page-watch-recording = Being recorded
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] One file imported
       *[other] { $count } files imported
    }
walk-page-report = Report…
walk-page-report-people = Inspection report ({ $format })…
walk-page-report-programs = Values of the part as { $format }…
walk-page-contradicted = { $names }: values contradict each other, and nothing says which one is right. The worst one counts until you measure again or choose.
walk-page-contradicting = { $name } has values that contradict each other: { $values }. The worst one counts until you measure again or choose.
walk-page-count-newest = The last value counts
walk-page-newest-counts = { $name }: the last value counts, as chosen
walk-page-accepted = Accepted outside the limits: { $names }
walk-page-because = Because of { $names }
walk-page-left-out = Skipped: { $names }. A part with skipped sizes cannot be good.
walk-page-whole = The whole part
walk-page-whole-serial = The part { $serial }
walk-page-strip-open = The part: no verdict yet
walk-page-strip-part = The part: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Measured by the plan { $name }
walk-page-judged-by-plan = Judged by the plan { $name }
walk-page-watch-no-mask = Your own mask { $path } cannot be read: the folder is watched once you choose this mask again or another one (Menu, Own mask…)
walk-page-watch-nobody = { $count ->
        [one] One value is recorded without a serial number: its file names none, and no part is being measured by this plan
       *[other] { $count } values are recorded without a serial number: their file names none, and no part is being measured by this plan
    }
walk-page-watch-other-plan = The folder is judged by the plan as it was when the watch began. Start a part, or watch the folder again, to judge by the plan as it is now.
walk-page-watch-not-saved = The plan has unsaved changes: the folder is not watched again after a restart.
walk-page-values = Values of { $name }
walk-page-to-do = { $name }: { $what }
walk-page-of = size { $at } of { $count }
walk-page-no-serial = No serial number
