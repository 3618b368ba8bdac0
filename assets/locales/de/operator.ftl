# Das Fenster für einen Bediener

operator-mode = Für wen dieses Fenster ist
operator-mode-about = Ein Bediener hat Messen, Ergebnisse und Hilfe, in großen Buchstaben; alles andere steht im vollen Fenster
operator-mode-operator = Bediener
operator-mode-operator-about = Messen, Ergebnisse und Hilfe, für Finger, Handschuhe und zwei Meter Abstand.
operator-mode-full = Alles
operator-mode-full-about = Alle Seiten, für den Schreibtisch.
operator-question = Für wen ist dieses Fenster?
operator-question-later = Das lässt sich jederzeit in den Einstellungen ändern; ein Bediener kommt mit „Verlassen“ dorthin.
operator-leave = Verlassen
operator-report = Bericht
operator-undo = Rückgängig
operator-measure = Messen
operator-results = Ergebnisse
operator-one-size = Ein Maß
operator-part = Teil
operator-last = Letzte Ergebnisse
operator-newer = Neuere
operator-older = Ältere
operator-back-to-results = Zurück zu den Ergebnissen
operator-dropped = { $name } wird hier nicht geöffnet: ein Bediener öffnet keine Dateien. Zuerst in das volle Fenster wechseln.
operator-no-results = Noch nichts wurde gemessen.
operator-features = { $count ->
    [one] 1 Merkmal
   *[other] Alle { $count } Merkmale
}
operator-next = Weiter
operator-next-part = Nächstes Teil
operator-to-value = Wert
operator-type-callout = Eingeben, was die Zeichnung sagt, wie 25 H7.
operator-type-value = Messen und den Wert eingeben.
operator-choose-part = Ein Teil wählen und seine Seriennummer eingeben.
operator-hole-or-shaft = Was wird gemessen?
operator-plans = Teile
operator-no-plans = Auf diesem Computer wurde noch kein Plan geöffnet. Pläne werden im vollen Fenster geöffnet, auf der Seite Teile.
operator-go-on-first = Erst das Urteil lesen und Weiter drücken: was davor eingegeben wurde, ist nicht übernommen

## The PIN
operator-pin = PIN des Bedienerfensters
operator-pin-about = Wer das Bedienerfenster verlässt, gibt sie ein. Gespeichert wird nur ein Hash mit Salt
operator-pin-use = Mit dieser PIN sperren
operator-pin-remove = PIN entfernen
operator-pin-try = Entsperren
operator-stay = Bleiben
operator-pin-short = eine PIN hat mindestens { $least } Zeichen
operator-pin-set = Das Bedienerfenster ist jetzt mit einer PIN gesperrt
operator-pin-removed = Das Bedienerfenster ist nicht mehr gesperrt
operator-pin-wrong = Das ist nicht die PIN
operator-pin-not-hashed = Der Hash der PIN konnte nicht gebildet werden: { $why }
operator-pin-asked = PIN eingeben, um das Bedienerfenster zu verlassen.
operator-pin-forgotten = Vergessen? Das Handbuch sagt, wie ein Administrator hineinkommt: The operator’s window, The PIN.
