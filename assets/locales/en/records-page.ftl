page-records = Records

## What is recorded with a check
records-page-fold = Record
records-page-fold-hint = Serial number and remark are recorded with the next checks
records-page-serial = Serial number
records-page-serial-short = Serial no.
records-page-remark = Remark
records-page-feature = Feature
records-page-record = Record { $number }
records-page-waiting = Being recorded
records-page-not-recorded = Not recorded: { $why }
records-page-nowhere = Checks are not recorded: there is no data folder for them
records-page-off = Checks are not recorded: recording is turned off in the state file
records-page-opening = The journal is being opened
records-page-how-on = The section [records] of the state file, state.toml, names the journal file and says whether checks are recorded.
records-page-not-opened = The journal cannot be opened, and checks are not recorded: { $why }
records-page-not-kept = { $count ->
    [one] 1 check is not recorded: { $why }
   *[other] { $count } checks are not recorded: { $why }
}
records-page-refused = { $count ->
    [one] 1 check cannot be recorded: { $why }
   *[other] { $count } checks cannot be recorded; the reason for the first one: { $why }
}
records-page-not-kept-why = the journal did not answer
records-page-no-thread = the system cannot start a thread for the journal
records-page-interrupted = it was interrupted
records-page-failed = { $count ->
    [one] 1 check is not recorded
   *[other] { $count } checks are not recorded
}
records-page-try-again = Try again
records-page-stay = Records stay in the journal
records-page-leave = { $count ->
    [one] 1 check is not recorded yet. It is lost if the window closes.
   *[other] { $count } checks are not recorded yet. They are lost if the window closes.
}

## Who is measuring
records-page-who = Measured by
records-page-nobody = Name…
records-page-who-nobody = No name is chosen. Choose a name
records-page-who-is = Measured by { $name }
records-page-nobody-named = No name
records-page-new-name = Another name
records-page-take-name = Use this name

## The question
records-page-question = Find
records-page-help = Words, good rework scrap, or part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = More
records-page-today = Today
records-page-this-week = This week
records-page-not-good = Not good
records-page-measured-only = Measured only
records-page-filter = Filter
records-page-filter-hint = Narrows the list by part, serial number, date and more
records-page-add-filter = Add filter
records-page-filter-by = Filter by
records-page-filter-value = Value
records-page-from = From
records-page-to = To
records-page-standing = Not void
records-page-simulated-only = Simulated only
records-page-reports-only = Reports only
records-page-alarms-only = Alarms only
records-page-checks-only = No reports
records-page-remove-filter = Remove filter { $filter }
records-page-looking = Searching
records-page-count = { $many ->
    [one] 1 record
   *[other] { $count } records
}
records-page-more = { $count }+ records
records-page-unread = The journal cannot be read: { $why }
records-page-none = no journal is open
records-page-missing = Record { $number } is missing
records-page-empty = Checks appear here once they are recorded
records-page-none-found = No record matches

## The list
records-page-list = Records
records-page-head-number = No.
records-page-zone = In the zone
records-page-move = Go to another record
records-page-open = Open the record
records-page-choose = Choose for a report
records-page-choose-record = Choose record { $number } for a report
records-page-chosen = { $count ->
    [one] 1 chosen
   *[other] { $count } chosen
}
records-page-copy = Copy
records-page-report-of = Report of { $count }…
records-page-reports-listed = A report is of all { $count } listed records
records-page-reports-chosen = A report is of the { $count } chosen records
records-page-too-many = { $count } records are listed. A report or a choice takes { $most } at most: narrow the list, for example by part or date
records-page-still-looking = The list is not complete yet. Try again when its count is shown
records-page-nothing-to-report = No listed record can be reported: they are void, simulated or of cycles
records-page-report = Report…
records-page-with-simulated = With simulated checks
records-page-with-simulated-hint = Simulated checks are not evidence; the report says that it contains some
records-page-report-simulated = { $count ->
    [one] 1 of these checks is simulated: it is not evidence
   *[other] { $count } of these checks are simulated: they are not evidence
}
records-page-report-from = From the journal { $chain }, records { $numbers }; its newest entry is { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] 1 simulated check is left out
   *[other] { $count } simulated checks are left out
}
records-page-out-replaced = { $count ->
    [one] 1 corrected or withdrawn record is left out
   *[other] { $count } corrected or withdrawn records are left out
}
records-page-report-corrects = { $count ->
    [one] 1 value stands in place of a corrected record
   *[other] { $count } values stand in place of corrected records
}
records-page-out-cycles = { $count ->
    [one] 1 record of a cycle is left out
   *[other] { $count } records of cycles are left out
}
records-page-out-reports = { $count ->
    [one] 1 report or alarm is left out: it is not a check
   *[other] { $count } reports and alarms are left out: they are not checks
}
records-page-out-unread = { $count ->
    [one] 1 record that cannot be read is left out
   *[other] { $count } records that cannot be read are left out
}
records-page-see = Void, see { $number }
records-page-void = Record { $number }, void: see { $by }
records-page-instead = for { $number }
records-page-takes-back = Withdraws { $number }
records-page-withdrawal = Withdrawal
records-page-report-entry = Report
records-page-alarm = Alarm
records-page-alarm-answers = Answer to alarm { $number }
records-page-alarm-answered = Alarm, answer { $number }
records-page-alarm-first = First value: { $number }
records-page-alarm-last = Value at which the rule fired: { $number }
records-page-cycle = Cycle { $cycle }
records-page-went-back = { $time } (clock)

## An open record
records-page-close = Back to the list
records-page-reading = Reading the record
records-page-measure-again = Measure again
records-page-measure-again-hint = Takes callout, part, serial number and rule to the check page
records-page-correct = Correct…
records-page-correct-hint = Adds a record in place of this one; both stay
records-page-simulated = Simulated: nobody measured this
records-page-corrected-by = Corrected or withdrawn by record { $number }
records-page-corrects = In place of record { $number }
records-page-in-report = In report { $number }, { $name }
records-page-reports-unread = The reports with this check cannot be read: { $why }
records-page-report-unknown = { $name } is written, but the journal does not know it: { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, hole
    [neither] { $callout }, neither hole nor shaft
   *[shaft] { $callout }, shaft
}
records-page-distance = From the limits
records-page-importer = Imported by
records-page-void-why = Void because
records-page-void-by = Corrected or withdrawn by
records-page-decided = Decision
records-page-limits = Limits
records-page-source = Limits from
records-page-contacts = Contacts
records-page-rule = Rule
records-page-station = Station
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = The clock of the station was set back before this record
records-page-cycle-number = Cycle
records-page-program = Program
records-page-block = { $program }, line { $line }
records-page-datum = Datum
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, set in line { $line }: { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = axes turned by { $angle }°, since line { $line }: { $block }
records-page-datum-tilt = plane tilted by A { $a }°, B { $b }°, C { $c }°, since line { $line }: { $block }
records-page-parameters = Parameters
records-page-figures = Results
records-page-file-measurements = Measurements
records-page-file-program = Program
records-page-file-workpiece = Workpiece
records-page-file-budget = Uncertainty budget
records-page-report-file = File
records-page-report-format = Format
records-page-report-size = Size
records-page-report-bytes = { $count } bytes
records-page-report-title = Title
records-page-report-sha256 = SHA-256
records-page-report-checks = Recorded checks
records-page-report-numbers = Their records
records-page-report-unrecorded = Checks without a record
records-page-report-head = Newest entry then
records-page-chain = Chain
records-page-chain-name = Journal
records-page-hash = Hash

## A correction
records-page-correction = Correct record { $number }
records-page-correction-rule = Judged again as record { $number } was: { $rule }.
records-page-correction-temperature = Corrected from { $temperature } °C to 20 °C.
records-page-correction-rest = Part, serial number, name
records-page-correction-hint = A new record takes the place of this one. Both stay in the journal.
records-page-corrector = Corrected by
records-page-reason = Reason
records-page-reason-mistyped = mistyped
records-page-reason-wrong-part = wrong part
records-page-reason-trial = trial
records-page-withdrawal-hint = The record no longer counts, and nothing takes its place. Both entries stay in the journal.
records-page-withdraw = Withdraw the record
records-page-withdraw-hint = Nothing takes its place
records-page-withdraw-neither = Record { $number }, which this one corrects, does not count again
records-page-send-correction = Record the correction
records-page-leave-correction = Cancel
records-page-undo-void = Not undone: the record was withdrawn after the correction
records-page-undone-reason = undone
records-page-taken-back = { $checks ->
    [one] 1 check taken back
   *[other] { $checks } checks taken back
}; { $records ->
    [one] record { $numbers } is withdrawn
   *[other] records { $numbers } are withdrawn
}
records-page-taken-back-unwritten = { $checks ->
    [one] 1 check taken back; it was not recorded yet and will not be
   *[other] { $checks } checks taken back; they were not recorded yet and will not be
}
records-page-not-withdrawn = { $records ->
    [one] Record { $numbers } still counts and could not be withdrawn: { $why }
   *[other] Records { $numbers } still count and could not be withdrawn: { $why }
}
records-page-undone = Correction undone
records-page-no-reason = A correction needs a reason
records-page-nothing-changed = Nothing is different: change a field, or withdraw the record
records-page-not-open = The record is not open
records-page-not-recording = Checks are not recorded

## The journal
records-page-place = { $file } · entries: { $entries }
records-page-unsent = { $count } not yet sent to { $server }
records-page-all-sent = all sent to { $server }
records-page-server-unknown = { $server } has not been reached yet
records-page-server = Server of the shop
records-page-server-hint = Sends every record to a PostgreSQL server, in the background; without it everything stays on this computer
records-page-server-address = Address, such as postgres://mill3@shop.example/checks
records-page-server-passwords = The password comes from the address, PGPASSWORD, the password file or the system's keyring. A password in the address goes to the keyring and is stored nowhere else.
records-page-take-server = Use this server
records-page-leave-server = Stop sending
records-page-send-again = Send again
records-page-not-sent = Not sent: { $why }
records-page-and = { $one }; { $other }
records-page-no-shop = this Fitcheck was built without support for a shop server (feature shop)
records-page-in-keyring = The password of { $server } is now in the system's keyring
records-page-not-in-keyring = The password of { $server } could not be put into the system's keyring ({ $reason }): it is used until the window is closed, and must then come from PGPASSWORD or the password file
records-page-verify = Verify
records-page-verify-hint = Checks every entry against the one before it
records-page-verify-cancel = Cancel verification
records-page-verify-cancelled = Verification cancelled
records-page-verify-progress = Progress of the verification
records-page-verifying = { $done } of { $of } entries
records-page-whole = { $time }: { $entries } entries verified, up to { $number } ({ $hash })
records-page-broken = { $time }: { $entries } entries checked; the journal is not as it was written
records-page-not-verified = { $time }: not verified: { $why }
records-page-no-anchors = the entries that are known elsewhere cannot be read: { $why }
