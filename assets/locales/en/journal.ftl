## The chain of a journal
journal-hex = "{ $text }" is not { $digits } hexadecimal digits
journal-break-changed = entry { $number } is not the one that was written
journal-break-removed = { $count ->
        [one] entry { $number } is
       *[other] { $count } entries from { $number } on are
    } missing
journal-break-inserted = entry { $number } was inserted
journal-break-reordered = entries { $number } and { $other } have changed places
journal-break-rewritten = entry { $number } differs from the one that is known elsewhere: the journal was rewritten from there or from an earlier entry
journal-break-cut-off = the journal ends with entry { $last }, but entry { $known } is known elsewhere: its newest entries were cut off, or an older copy was put back

## Entries
journal-body-json = not an entry of a journal: { $reason }
journal-body-newer = made by a newer Fitcheck: version { $version } of the format, this Fitcheck reads versions up to { $known }
journal-body-too-large = not an entry of a journal: { $bytes } bytes, at most { $most } are allowed
journal-body-too-long = { $field } has { $bytes } bytes, at most { $most } are allowed
journal-body-control = { $field } has the control character { $code } as its character { $place }: texts of a journal are one line without control characters
journal-body-empty = { $field } is empty
journal-body-too-many = { $field } has { $count } entries, at most { $most } are allowed
journal-body-value = { $field } cannot be "{ $given }"
journal-body-contradiction = { $field } contradicts the fields from which it follows
journal-origin-perfect = simulated, a workpiece without faults
journal-origin-workpiece = simulated, { $file }, seed { $seed }
journal-origin-contacts = contacts from { $file }
journal-check-judged-otherwise = decided as { $kept }, which stands; this version of Fitcheck decides { $now }

## Questions
journal-ask-at = { $reason } (character { $at })
journal-ask-unknown-key = { $key }: is not a known keyword; expected { $known }, or quotation marks around a word with a colon
journal-ask-no-value = { $key }: has no value
journal-ask-empty-word = a word in quotation marks is empty
journal-ask-twice = { $key } is given twice
journal-ask-not-closed = a quotation mark is not closed
journal-ask-after-quote = expected a blank after the closing quotation mark, found { $found }
journal-ask-date = "{ $given }" is not a day or a time: expected 2026-11-23 or 2026-11-23T14:30
journal-ask-verdict = "{ $given }" is not a verdict: expected { $known }
journal-ask-callout = { $error }; a callout goes in quotation marks: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = the period ends before it begins: from must be before to
journal-ask-both-origins = simulated and measured exclude each other
journal-ask-both-kinds = reports and checks exclude each other
journal-ask-too-long = the question has { $bytes } bytes, at most { $most } are allowed

## The journal of a station
store-missing = there is no journal at { $path }
store-not-a-file = { $path } is not a file
store-not-a-journal = { $path } is not a journal of Fitcheck; it was left unchanged
store-newer = { $path } was made by a newer Fitcheck (version { $version }, this one supports { $known }); it was left unchanged
store-older = { $path } was made by an older Fitcheck: it is upgraded when something is recorded in it
store-damaged = { $path } is damaged: its pages contradict each other
store-full = no space is left for { $path }: nothing was recorded
store-read-only = { $path } may not be written to: nothing was recorded
store-locked = another program has locked { $path } for too long: nothing was recorded
store-disk = the disk of { $path } reports an error: { $reason }
store-cannot-open = { $path } cannot be opened
store-network-folder = { $path } is in a folder of another machine, where two stations could overwrite each other's entries: choose a folder on this machine, and a server for the shop
store-altered = "{ $name }", which protects entries from changes, is missing in { $path } or was changed
store-no-beginning = { $path } does not say which chain it is
store-moved = { $path } was moved or set aside in the meantime: nothing was recorded
store-other-target = entry { $number } is not the one that was to be corrected: nothing was recorded
store-corrected = entry { $number } was already corrected or withdrawn by entry { $by }: correct that one, unless it is a withdrawal
store-is-report = entry { $number } is a report: it says which file was written, and cannot be corrected or withdrawn
store-is-alarm = entry { $number } is an alarm of a control chart: it says which rule fired, and cannot be corrected or withdrawn; answer it instead
store-no-alarm = entry { $number } is not an alarm of a control chart: only an alarm can be answered
journal-alarm-since-part = { $rule }, since part { $serial }
journal-alarm-since-entry = { $rule }, since record { $number }
store-other-journal = entry { $number } of this journal is not the one that the report names: nothing was recorded
store-finding-no-beginning = the journal has no first entry that names its chain
store-finding-pages = the pages of the journal contradict each other, and questions may miss entries that are in it: { $reason }
store-finding-index = an index for questions does not match its table: { $reason }
store-hidden = entry { $number } of { $path } is not found in its place: the journal was changed or its file is damaged; run fitcheck journal verify
store-no-entry = { $path } has no entry { $number }: the last one is { $last }
store-backup = the copy of { $path } was incomplete and has been removed
store-interrupted = stopped
store-database = { $path }: { $reason }
store-remark-begun = a new journal was created: { $path }
store-remark-set-aside = the journal { $path } was damaged: it is now in { $folder }, unchanged, and a new one was created in its place
store-remark-migrated = { $path } was upgraded to this version; the file as it was before is { $copy }
store-remark-behind = { $path } ends with entry { $last }, but once had entry { $known }: its newest entries were cut off, or an older copy was put back
store-remark-other = entry { $number } of { $path } differs from what it was: the journal was rewritten from there or from an earlier entry
store-remark-replaced = { $path } is not the journal that was there before, which had { $known } entries
store-remark-waits = another program is writing to { $path }: waiting for it to finish
store-remark-no-anchor = the last entry of this journal could not be noted in { $path }: { $reason }
store-finding-altered = "{ $name }", which protects entries from changes, is missing or was changed
store-finding-not-found = { $entries ->
        [one] 1 entry is indexed by something other than what it says, or is not indexed
       *[other] { $entries } entries are indexed by something other than what they say, or are not indexed
    }
