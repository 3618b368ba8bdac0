## The chain of a journal
journal-hex = "{ $text }" is not { $digits } hexadecimal digits
journal-break-removed = entry { $number } is missing: entry { $next } comes next
journal-break-out-of-order = entry { $number } stands where it does not belong
journal-break-changed = entry { $number } is not the one that was written: it or its hash was changed, or it was put here
journal-break-other-than-kept = entry { $number } is another one than is known elsewhere: the journal was written anew from there or before
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
journal-check-judged-otherwise = decided as { $kept }, which stands; this version of Fitcheck decides { $now }
