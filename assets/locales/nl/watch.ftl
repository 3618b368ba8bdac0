# De map waarin bestanden worden neergezet.

watch-written = wordt geschreven
watch-locked = in gebruik door een ander programma: { $reason }
watch-same = dezelfde inhoud is eerder geïmporteerd als { $known }
watch-note = Fitcheck kon niet alles in { $name } gebruiken of beoordelen:
watch-again = het bestand is opnieuw geschreven en begint zoals eerst: { $count ->
    [one] één waarde
   *[other] { $count } waarden
} opnieuw geïmporteerd
watch-begins-as = het bestand begint als { $known }, dat al is geïmporteerd: { $count ->
    [one] één waarde
   *[other] { $count } waarden
} opnieuw geïmporteerd
watch-same-again = opnieuw geschreven met dezelfde inhoud, dus er wordt niets geïmporteerd
watch-by-another = een ander programma bewaakt deze map al voor hetzelfde logboek
watch-late = de regels tot en met { $last } vullen waarden aan die al geïmporteerd zijn, vanaf regel { $first }: controleer deze waarden in het logboek
watch-no-line-end = de laatste regel heeft geen regeleinde: hij is geïmporteerd zoals hij is
watch-older = een bestand met deze naam is sindsdien met andere inhoud geïmporteerd, dus { $count ->
    [one] één waarde aan het begin hiervan wordt
   *[other] { $count } waarden aan het begin hiervan worden
} niet opnieuw geïmporteerd
watch-refused = kan niet worden gelezen; Fitcheck blijft het proberen: { $reason }
watch-copy = dezelfde inhoud is eerder geïmporteerd als { $known }; is een onderdeel echt opnieuw gemeten, dan heeft het bestand een tijd of een serienummer nodig
watch-verdicts = het bestand bevat oordelen die Fitcheck heeft geschreven, geen metingen: er wordt niets geïmporteerd
watch-other = een bestand met deze naam is eerder geïmporteerd en begon anders: dit bestand wordt helemaal geïmporteerd
