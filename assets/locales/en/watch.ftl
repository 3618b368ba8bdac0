# The folder that files are dropped into.

watch-written = being written
watch-locked = in use by another program: { $reason }
watch-same = the same content was imported before as { $known }
watch-note = Fitcheck could not use or judge everything in { $name }:
watch-again = the file was rewritten and begins as before: { $count ->
    [one] one value
   *[other] { $count } values
} imported again
watch-begins-as = the file begins like { $known }, which was imported before: { $count ->
    [one] one value
   *[other] { $count } values
} imported again
watch-same-again = rewritten with the same content, so nothing is imported
watch-by-another = another program watches this folder for the same journal
watch-late = lines up to { $last } say more of values that were already taken, from line { $first } on: check them in the journal
watch-no-line-end = the last line has no line end: it was taken as it is
watch-older = a file of this name was taken since with other content, so { $count ->
    [one] one value at the beginning of this one is
   *[other] { $count } values at the beginning of this one are
} not taken again
watch-refused = could not be read, and is tried again: { $reason }
watch-copy = the same content was taken before as { $known }: a part that was really measured again needs a time or a serial number in its file
watch-verdicts = these are verdicts that Fitcheck wrote, not measurements: nothing of it is taken
