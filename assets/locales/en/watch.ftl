# The folder that files are dropped into.

watch-written = being written
watch-locked = another program holds it: { $reason }
watch-same = the same content was taken before as { $known }
