# De map waarin bestanden worden neergezet.

watch-written = wordt geschreven
watch-locked = een ander programma houdt het vast: { $reason }
watch-same = dezelfde inhoud is eerder genomen als { $known }
