## Gedruckte Berichte
printed-no-value = kein Messwert unter { $column }
printed-cells = { $found } Zahlen unter { $expected } Spalten: es ist nicht klar, welche Zahl in welcher Spalte steht; den Bericht mit allen Spalten drucken
printed-no-column = keine Spalte { $column }: die Messwerte ins Druckformat des Berichts aufnehmen
printed-no-heading = Zahlen ohne Überschrift darüber: der Anfang des Merkmals fehlt
printed-no-rows = { $name } hat keine Zeile: der Bericht ist vielleicht abgeschnitten
printed-minus-sign = die Minustoleranz { $given } kann unter oder über dem Sollwert liegen, und keine andere Zeile entscheidet: Minustoleranzen ohne Vorzeichen drucken
printed-unknown-row = unbekannte Achse { $given }: die Zeile ist übersprungen
printed-warning-deviation = der Bericht hat eine Abweichung von { $given } mm, seine Zahlen ergeben aber { $expected } mm
printed-warning-beyond = der Bericht hat { $given } mm außerhalb der Toleranz, seine Zahlen ergeben aber { $expected } mm
printed-warning-no-end = die letzte Textzeile, { $end }, fehlt: der Bericht ist vielleicht abgeschnitten
printed-warning-lines = übersprungen, keine Messung: { $text } (Textzeilen dieser Art insgesamt: { $count })
printed-warning-out-of-place = der Bericht sagt { $given }, und keine der hier gelesenen Grenzen sagt das: im Bericht nachsehen
