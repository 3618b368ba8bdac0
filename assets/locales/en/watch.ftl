# The folder that files are dropped into.

watch-written = being written
watch-locked = another program holds it: { $reason }
watch-same = the same content was taken before as { $known }
watch-note = Fitcheck could not use or judge everything in { $name }:
watch-again = the file was written anew and begins as before: { $count ->
    [one] one value
   *[other] { $count } values
} taken again
watch-begins-as = the file begins as { $known }, which was taken before: { $count ->
    [one] one value
   *[other] { $count } values
} taken again
watch-same-again = written again with the same content, so nothing of it is taken
watch-by-another = another program watches this folder for the same journal
