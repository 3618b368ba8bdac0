## The chain of a journal
journal-hex = "{ $text }" is not { $digits } hexadecimal digits
journal-break-removed = entry { $number } is missing: entry { $next } comes next
journal-break-out-of-order = entry { $number } stands where it does not belong
journal-break-changed = entry { $number } is not the one that was written: it or its hash was changed, or it was put here
journal-break-other-than-kept = entry { $number } is another one than is known elsewhere: the journal was written anew from there or before
journal-break-cut-off = the journal ends with entry { $last }, and entry { $known } is known elsewhere: its newest entries were cut off, or an older copy was put back

## Entries
journal-body-json = not an entry of a journal: { $reason }
