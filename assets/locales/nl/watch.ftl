# De map waarin bestanden worden neergezet.

watch-written = wordt geschreven
watch-locked = een ander programma houdt het vast: { $reason }
watch-same = dezelfde inhoud is eerder overgenomen als { $known }
watch-note = Fitcheck kon niet alles in { $name } gebruiken of beoordelen:
watch-again = het bestand is opnieuw geschreven en begint zoals eerst: { $count ->
    [one] één waarde
   *[other] { $count } waarden
} opnieuw overgenomen
watch-begins-as = het bestand begint als { $known }, dat al is overgenomen: { $count ->
    [one] één waarde
   *[other] { $count } waarden
} opnieuw overgenomen
watch-same-again = opnieuw geschreven met dezelfde inhoud, dus niets ervan wordt overgenomen
watch-by-another = een ander programma bewaakt deze map al voor hetzelfde logboek
