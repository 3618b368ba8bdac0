## Tabellen von CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = kein Messwert in Spalte actual
calypso-cut-off = die letzte Textzeile, END, fehlt: die Datei ist vielleicht abgeschnitten
calypso-row-cut-off = die Datei endet hier ohne Zeilenende, daher ist die Zeile vielleicht abgeschnitten: sie ist übersprungen; ist sie vollständig, ein Zeilenende hinzufügen
calypso-zeros = die Textzeile hat Bytes mit Wert 0, daher wurde die Datei nicht vollständig geschrieben: die Zeile ist übersprungen
calypso-differs = die Zeilen von { $name } in Textzeile { $first } und { $second } haben verschiedene Sollwerte oder Grenzmaße
calypso-warning-no-end = die letzte Textzeile, END, fehlt: die Datei ist vielleicht abgeschnitten
calypso-warning-behind = übersprungen nach der Textzeile END: { $given }
calypso-warning-zeros = die Datei hat hier Bytes mit Wert 0, daher wurde sie nicht vollständig geschrieben: vielleicht fehlen Zeilen
calypso-warning-deviation = die Tabelle hat eine Abweichung von { $given } mm, ihre Werte ergeben aber { $expected } mm
calypso-warning-exceed = die Tabelle hat { $given } mm außerhalb der Toleranz, ihre Werte ergeben aber { $expected } mm
