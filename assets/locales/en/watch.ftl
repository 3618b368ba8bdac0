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
watch-late = lines up to { $last } add to values that were already imported, from line { $first } on: check these values in the journal
watch-no-line-end = the last line has no line end; it was imported as it is
watch-older = a file of this name was imported later with other content; not imported again from the beginning of this one: { $count ->
    [one] one value
   *[other] { $count } values
}
watch-refused = cannot be read; Fitcheck keeps trying: { $reason }
watch-copy = the same content was imported before as { $known }; if a part was really measured again, its file needs a time or a serial number
watch-verdicts = the file holds verdicts that Fitcheck wrote, not measurements; nothing is imported
watch-other = a file of this name was imported before and began differently; all of this one is imported
