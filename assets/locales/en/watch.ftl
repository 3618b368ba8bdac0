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
