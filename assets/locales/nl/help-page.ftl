page-help = Hulp

help-page-help = Hulp bij deze pagina
help-page-help-hint = Opent de handleiding; op de hulppagina terug naar de pagina van daarvoor
help-page-explain = Dit veld uitleggen
help-page-explain-hint = Toont waarvoor het veld dient, met eenheid, bereik en een voorbeeld
help-page-about-field = Hulp bij { $name }
help-page-in-manual = In de handleiding
help-page-entry = Hulp: { $title }
help-page-keys = Sneltoetsen
help-page-search = Zoeken in de handleiding
help-page-open-found = Beste treffer openen
help-page-nothing = Geen pagina van de handleiding bevat deze woorden.
help-page-topics = Inhoud
help-page-list = Pagina's van de handleiding
help-page-found = { $title }, { $heading }
help-page-found-line = { $place }: { $line }
help-page-move = Naar een andere pagina van de handleiding
help-page-read = Pagina tonen
help-page-scroll = Tekst verschuiven
help-page-back = Terug
help-page-english = De handleiding is alleen in het Engels beschikbaar.

# Samples
help-page-samples = Uitproberen
help-page-sample-value = 25 H7 met 25,012 proberen
help-page-sample-part = Voorbeeldonderdeel openen
help-page-sample-file = Voorbeeldbestand openen
help-page-sample-program = Voorbeeldprogramma openen
help-page-sample-hint = De voorbeelden zijn ingebouwd. De waarden in het voorbeeldbestand zijn gemarkeerd als gesimuleerd.

# The sheet of keys
help-page-keys-about = Een toets van een pagina werkt zolang die pagina open is.
help-page-everywhere = Op elke pagina
help-page-in-dialogs = In dialoogvensters
help-page-on-workpiece = Gesimuleerd werkstuk
help-page-key-row = { $keys }: { $text }
