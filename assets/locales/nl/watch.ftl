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
watch-late = de regels tot en met { $last } zeggen meer over waarden die al zijn overgenomen, vanaf regel { $first }: controleer ze in het logboek
watch-no-line-end = de laatste regel heeft geen regeleinde: hij is overgenomen zoals hij er staat
watch-older = een bestand met deze naam is sindsdien met andere inhoud overgenomen, dus { $count ->
    [one] één waarde aan het begin hiervan wordt
   *[other] { $count } waarden aan het begin hiervan worden
} niet opnieuw overgenomen
watch-refused = kon niet worden gelezen, en wordt opnieuw geprobeerd: { $reason }
watch-copy = dezelfde inhoud is eerder overgenomen als { $known }: een werkstuk dat echt opnieuw is gemeten heeft een tijd of serienummer in zijn bestand nodig
watch-verdicts = dit zijn oordelen die Fitcheck heeft geschreven, geen metingen: niets ervan wordt overgenomen
watch-other = een bestand met deze naam is eerder overgenomen en begon anders: dit wordt helemaal overgenomen
