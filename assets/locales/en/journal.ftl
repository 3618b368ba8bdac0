## The chain of a journal
journal-hex = "{ $text }" is not { $digits } hexadecimal digits
journal-break-changed = entry { $number } is not the one that was written
journal-break-removed = { $count ->
        [one] entry { $number } is
       *[other] { $count } entries from { $number } on are
    } missing
journal-break-inserted = entry { $number } was inserted
journal-break-reordered = entries { $number } and { $other } have changed places
journal-break-rewritten = entry { $number } is another one than is known elsewhere: the journal was written anew from there or before
journal-break-cut-off = the journal ends with entry { $last }, and entry { $known } is known elsewhere: its newest entries were cut off, or an older copy was put back

## Entries
journal-body-json = not an entry of a journal: { $reason }
journal-body-newer = made by a newer Fitcheck: version { $version } of the format, this Fitcheck reads versions up to { $known }
journal-body-too-large = not an entry of a journal: { $bytes } bytes, at most { $most } are allowed
journal-body-too-long = { $field } has { $bytes } bytes, at most { $most } are allowed
journal-body-control = { $field } has the control character { $code } as its character { $place }: texts of a journal are one line without control characters
journal-body-empty = { $field } is empty
journal-body-too-many = { $field } has { $count } entries, at most { $most } are allowed
journal-body-value = { $field } cannot be "{ $given }"
journal-body-contradiction = { $field } says something else than the fields that it follows from
journal-origin-perfect = simulated, a workpiece without faults
journal-origin-workpiece = simulated, { $file }, seed { $seed }
journal-origin-contacts = contacts from { $file }
journal-check-judged-otherwise = decided as { $kept }, which stands; this version of Fitcheck decides { $now }

## Questions
journal-ask-at = { $reason } (character { $at })
journal-ask-unknown-key = { $key }: is not something to ask for; expected { $known }, or quotation marks around a word with a colon
journal-ask-no-value = { $key }: has no value
journal-ask-empty-word = a word in quotation marks is empty
journal-ask-twice = { $key } is given twice
journal-ask-not-closed = a quotation mark is not closed
journal-ask-after-quote = expected a blank after the closing quotation mark, found { $found }
journal-ask-date = "{ $given }" is not a day or a time: expected 2026-11-23 or 2026-11-23T14:30
journal-ask-verdict = "{ $given }" is not a verdict: expected { $known }
journal-ask-callout = { $error }; a callout goes in quotation marks: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = the question ends before it begins: from is not before to
journal-ask-both-origins = simulated and measured exclude each other
journal-ask-too-long = the question has { $bytes } bytes, at most { $most } are allowed

## The journal of a station
store-missing = there is no journal at { $path }
store-not-a-file = { $path } is not a file
store-not-a-journal = { $path } is not a journal of Fitcheck; it was left as it is
store-newer = { $path } was made by a newer Fitcheck (version { $version }, this one knows { $known }); it was left as it is
store-older = { $path } was made by an older Fitcheck: it is brought to this version when something is recorded in it
store-damaged = { $path } is damaged: its pages do not agree
store-full = no space is left for { $path }: nothing was recorded
store-read-only = { $path } may not be written to: nothing was recorded
store-locked = another program holds { $path }, longer than this one waits: nothing was recorded
store-disk = the disk of { $path } fails: { $reason }
store-cannot-open = { $path } cannot be opened
store-network-folder = { $path } is in a folder of another machine, where two stations would write over each other: choose a folder of this machine, and a server for the shop
store-altered = "{ $name }", which keeps entries from being changed, is missing in { $path } or was changed
store-no-beginning = { $path } does not tell which chain it is
store-moved = { $path } was moved or set aside meanwhile: nothing was recorded
store-other-target = entry { $number } is another one than the one that was to be corrected: nothing was recorded
store-corrected = entry { $number } was corrected or withdrawn by entry { $by } already: correct that one, unless it is a withdrawal
store-finding-no-beginning = the journal has no first entry that tells its chain
store-finding-pages = the pages of the journal do not agree, and questions may miss entries that are in it: { $reason }
store-finding-index = an index of questions does not agree with its table: { $reason }
store-hidden = entry { $number } of { $path } is not found where it must be: the journal was changed or its file is damaged; run fitcheck journal verify
store-no-entry = { $path } has no entry { $number }: the last one is { $last }
store-backup = the copy of { $path } did not come out whole, and was taken away
store-interrupted = stopped
store-database = { $path }: { $reason }
store-remark-begun = a new journal was begun: { $path }
store-remark-set-aside = the journal { $path } was damaged: it lies in { $folder } now, unchanged, and a new one was begun in its place
store-remark-migrated = { $path } was brought to this version; as it was it is { $copy }
store-remark-behind = { $path } ends with entry { $last } and once had entry { $known }: its newest entries were cut off, or an older copy was put back
store-remark-other = entry { $number } of { $path } is another one than it was: the journal was written anew from there or before
store-remark-replaced = { $path } is another journal than the one that was there, which had { $known } entries
store-remark-waits = another program is writing to { $path }: waiting for its turn to end
store-remark-no-anchor = the last entry of this journal could not be kept in { $path }: { $reason }
store-finding-altered = "{ $name }", which keeps entries from being changed, is missing or was changed
store-finding-not-found = { $entries ->
        [one] 1 entry is found by something else than what it says, or is not found
       *[other] { $entries } entries are found by something else than what they say, or are not found
    }
