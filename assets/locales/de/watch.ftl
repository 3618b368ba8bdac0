# Der Ordner, in den Dateien gelegt werden.

watch-written = wird geschrieben
watch-locked = von einem anderen Programm benutzt: { $reason }
watch-same = derselbe Inhalt wurde früher als { $known } importiert
watch-note = Fitcheck konnte nicht alles in { $name } verwenden oder beurteilen:
watch-again = die Datei wurde neu geschrieben und beginnt wie zuvor: { $count ->
    [one] ein Wert
   *[other] { $count } Werte
} noch einmal importiert
watch-begins-as = die Datei beginnt wie { $known }, die früher importiert wurde: { $count ->
    [one] ein Wert
   *[other] { $count } Werte
} noch einmal importiert
watch-same-again = mit demselben Inhalt neu geschrieben, daher wird nichts importiert
watch-by-another = ein anderes Programm überwacht diesen Ordner für dasselbe Journal
watch-late = Textzeilen bis { $last } ergänzen schon importierte Werte, ab Textzeile { $first }: diese Werte im Journal prüfen
watch-no-line-end = die letzte Textzeile hat kein Zeilenende; sie wurde importiert, wie sie ist
watch-older = eine Datei dieses Namens wurde später mit anderem Inhalt importiert; vom Anfang dieser nicht noch einmal importiert: { $count ->
    [one] ein Wert
   *[other] { $count } Werte
}
watch-refused = kann nicht gelesen werden; Fitcheck versucht es weiter: { $reason }
watch-copy = derselbe Inhalt wurde früher als { $known } importiert; wurde ein Teil wirklich neu gemessen, braucht seine Datei eine Zeit oder eine Seriennummer
watch-verdicts = die Datei enthält Urteile, die Fitcheck geschrieben hat, keine Messungen; nichts wird importiert
watch-other = eine Datei dieses Namens wurde früher importiert und begann anders; diese wird ganz importiert
