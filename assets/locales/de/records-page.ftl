page-records = Journal

## Was mit einer Prüfung aufgezeichnet wird
records-page-fold = Aufzeichnung
records-page-fold-hint = Seriennummer und Bemerkung werden mit den nächsten Prüfungen aufgezeichnet
records-page-serial = Seriennummer
records-page-serial-short = Serien-Nr.
records-page-remark = Bemerkung
records-page-feature = Merkmal
records-page-record = Aufzeichnung { $number }
records-page-waiting = Wird aufgezeichnet
records-page-not-recorded = Nicht aufgezeichnet: { $why }
records-page-nowhere = Prüfungen werden nicht aufgezeichnet: dafür gibt es keinen Datenordner
records-page-off = Prüfungen werden nicht aufgezeichnet: das Aufzeichnen ist in der Zustandsdatei ausgeschaltet
records-page-opening = Das Journal wird geöffnet
records-page-how-on = Der Abschnitt [records] der Zustandsdatei, state.toml, nennt die Journaldatei und sagt, ob Prüfungen aufgezeichnet werden.
records-page-not-opened = Das Journal kann nicht geöffnet werden, und Prüfungen werden nicht aufgezeichnet: { $why }
records-page-not-kept = { $count ->
    [one] 1 Prüfung ist nicht aufgezeichnet: { $why }
   *[other] { $count } Prüfungen sind nicht aufgezeichnet: { $why }
}
records-page-refused = { $count ->
    [one] 1 Prüfung kann nicht aufgezeichnet werden: { $why }
   *[other] { $count } Prüfungen können nicht aufgezeichnet werden; der Grund bei der ersten: { $why }
}
records-page-not-kept-why = das Journal hat nicht geantwortet
records-page-no-thread = das System kann keinen Thread für das Journal starten
records-page-interrupted = es wurde unterbrochen
records-page-failed = { $count ->
    [one] 1 Prüfung ist nicht aufgezeichnet
   *[other] { $count } Prüfungen sind nicht aufgezeichnet
}
records-page-try-again = Erneut versuchen
records-page-stay = Aufzeichnungen bleiben im Journal
records-page-leave = { $count ->
    [one] 1 Prüfung ist noch nicht aufgezeichnet. Sie geht verloren, wenn das Fenster schließt.
   *[other] { $count } Prüfungen sind noch nicht aufgezeichnet. Sie gehen verloren, wenn das Fenster schließt.
}

## Wer misst
records-page-who = Gemessen von
records-page-nobody = Name…
records-page-who-nobody = Kein Name gewählt. Einen Namen wählen
records-page-who-is = Gemessen von { $name }
records-page-nobody-named = Kein Name
records-page-new-name = Anderer Name
records-page-take-name = Diesen Namen verwenden

## Die Frage
records-page-question = Suchen
records-page-help = Wörter, gut Nacharbeit Ausschuss, oder part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = Mehr
records-page-today = Heute
records-page-this-week = Diese Woche
records-page-not-good = Nicht gut
records-page-measured-only = Nur gemessene
records-page-filter = Filter
records-page-filter-hint = Grenzt die Liste nach Teil, Seriennummer, Datum und mehr ein
records-page-add-filter = Filter hinzufügen
records-page-filter-by = Filtern nach
records-page-filter-value = Wert
records-page-from = Von
records-page-to = Bis
records-page-standing = Nur gültige
records-page-simulated-only = Nur simulierte
records-page-reports-only = Nur Prüfberichte
records-page-alarms-only = Nur Alarme
records-page-checks-only = Ohne Prüfberichte
records-page-remove-filter = Filter { $filter } entfernen
records-page-looking = Suche läuft
records-page-count = { $many ->
    [one] 1 Aufzeichnung
   *[other] { $count } Aufzeichnungen
}
records-page-more = { $count }+ Aufzeichnungen
records-page-unread = Das Journal kann nicht gelesen werden: { $why }
records-page-none = kein Journal geöffnet
records-page-missing = Aufzeichnung { $number } fehlt
records-page-empty = Hier erscheinen Prüfungen, sobald sie aufgezeichnet sind
records-page-none-found = Keine Aufzeichnung gefunden

## Die Liste
records-page-list = Aufzeichnungen
records-page-head-number = Nr.
records-page-zone = Im Tol.-Feld
records-page-move = Zu einer anderen Aufzeichnung
records-page-open = Aufzeichnung öffnen
records-page-choose = Für einen Bericht auswählen
records-page-choose-record = Aufzeichnung { $number } für einen Bericht auswählen
records-page-chosen = { $count ->
    [one] 1 ausgewählt
   *[other] { $count } ausgewählt
}
records-page-copy = Kopieren
records-page-report-of = Bericht über { $count }…
records-page-reports-listed = Ein Bericht umfasst alle { $count } angezeigten Aufzeichnungen
records-page-reports-chosen = Ein Bericht umfasst die { $count } ausgewählten Aufzeichnungen
records-page-too-many = { $count } Aufzeichnungen stehen in der Liste. Ein Bericht oder eine Auswahl umfasst höchstens { $most }: die Liste eingrenzen, zum Beispiel nach Teil oder Datum
records-page-still-looking = Die Liste ist noch nicht vollständig. Erneut versuchen, wenn die Anzahl angezeigt wird
records-page-nothing-to-report = Über keine angezeigte Aufzeichnung lässt sich berichten: sie sind ungültig, simuliert oder von Zyklen
records-page-report = Bericht…
records-page-with-simulated = Mit simulierten Prüfungen
records-page-with-simulated-hint = Simulierte Prüfungen sind kein Nachweis; der Bericht sagt, dass er welche enthält
records-page-report-simulated = { $count ->
    [one] 1 dieser Prüfungen ist simuliert: sie ist kein Nachweis
   *[other] { $count } dieser Prüfungen sind simuliert: sie sind kein Nachweis
}
records-page-report-from = Aus dem Journal { $chain }, Aufzeichnungen { $numbers }; der neueste Eintrag ist { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] 1 simulierte Prüfung ist weggelassen
   *[other] { $count } simulierte Prüfungen sind weggelassen
}
records-page-out-replaced = { $count ->
    [one] 1 berichtigte oder zurückgenommene Aufzeichnung ist weggelassen
   *[other] { $count } berichtigte oder zurückgenommene Aufzeichnungen sind weggelassen
}
records-page-report-corrects = { $count ->
    [one] 1 Wert steht an der Stelle einer berichtigten Aufzeichnung
   *[other] { $count } Werte stehen an der Stelle berichtigter Aufzeichnungen
}
records-page-out-cycles = { $count ->
    [one] 1 Aufzeichnung eines Zyklus ist weggelassen
   *[other] { $count } Aufzeichnungen von Zyklen sind weggelassen
}
records-page-out-reports = { $count ->
    [one] 1 Prüfbericht oder Alarm ist weggelassen: er ist keine Prüfung
   *[other] { $count } Prüfberichte und Alarme sind weggelassen: sie sind keine Prüfungen
}
records-page-out-unread = { $count ->
    [one] 1 nicht lesbare Aufzeichnung ist weggelassen
   *[other] { $count } nicht lesbare Aufzeichnungen sind weggelassen
}
records-page-see = Ungültig, siehe { $number }
records-page-void = Aufzeichnung { $number }, ungültig: siehe { $by }
records-page-instead = statt { $number }
records-page-takes-back = Nimmt { $number } zurück
records-page-withdrawal = Rücknahme
records-page-report-entry = Prüfbericht
records-page-alarm = Alarm
records-page-alarm-answers = Antwort auf Alarm { $number }
records-page-alarm-answered = Alarm, Antwort { $number }
records-page-alarm-first = Erster Wert: { $number }
records-page-alarm-last = Wert, bei dem die Regel ausgelöst hat: { $number }
records-page-cycle = Zyklus { $cycle }
records-page-went-back = { $time } (Uhr zurück)

## Eine geöffnete Aufzeichnung
records-page-close = Zurück zur Liste
records-page-reading = Die Aufzeichnung wird gelesen
records-page-measure-again = Neu messen
records-page-measure-again-hint = Übernimmt Toleranzangabe, Teil, Seriennummer und Regel auf die Seite Prüfung
records-page-correct = Berichtigen…
records-page-correct-hint = Fügt eine Aufzeichnung anstelle dieser hinzu; beide bleiben
records-page-simulated = Simuliert: niemand hat dies gemessen
records-page-corrected-by = Berichtigt oder zurückgenommen durch Aufzeichnung { $number }
records-page-corrects = Anstelle von Aufzeichnung { $number }
records-page-in-report = Im Prüfbericht { $number }, { $name }
records-page-reports-unread = Die Prüfberichte mit dieser Prüfung können nicht gelesen werden: { $why }
records-page-report-unknown = { $name } ist geschrieben, aber das Journal kennt die Datei nicht: { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, Bohrung
    [neither] { $callout }, weder Bohrung noch Welle
   *[shaft] { $callout }, Welle
}
records-page-distance = Abstand zum Grenzmaß
records-page-importer = Importiert von
records-page-void-why = Ungültig, weil
records-page-void-by = Berichtigt oder zurückgenommen von
records-page-decided = Entscheidung
records-page-limits = Grenzmaße
records-page-source = Grenzmaße aus
records-page-contacts = Antastpunkte
records-page-rule = Regel
records-page-station = Station
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = Die Uhr der Station wurde vor dieser Aufzeichnung zurückgestellt
records-page-cycle-number = Zyklus
records-page-program = Programm
records-page-block = { $program }, Textzeile { $line }
records-page-datum = Bezugspunkt
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, gesetzt in Textzeile { $line }: { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = Achsen um { $angle }° gedreht, seit Textzeile { $line }: { $block }
records-page-datum-tilt = Ebene um A { $a }°, B { $b }°, C { $c }° geschwenkt, seit Textzeile { $line }: { $block }
records-page-parameters = Parameter
records-page-figures = Ergebnisse
records-page-file-measurements = Messungen
records-page-file-program = Programm
records-page-file-workpiece = Werkstück
records-page-file-budget = Unsicherheitsbudget
records-page-report-file = Datei
records-page-report-format = Format
records-page-report-size = Größe
records-page-report-bytes = { $count } Byte
records-page-report-title = Titel
records-page-report-sha256 = SHA-256
records-page-report-checks = Aufgezeichnete Prüfungen
records-page-report-numbers = Ihre Aufzeichnungen
records-page-report-unrecorded = Prüfungen ohne Aufzeichnung
records-page-report-head = Damals neuester Eintrag
records-page-chain = Kette
records-page-chain-name = Journal
records-page-hash = Hash

## Eine Berichtigung
records-page-correction = Aufzeichnung { $number } berichtigen
records-page-correction-rule = Neu beurteilt wie Aufzeichnung { $number }: { $rule }.
records-page-correction-temperature = Korrigiert von { $temperature } °C auf 20 °C.
records-page-correction-rest = Teil, Seriennummer, Name
records-page-correction-hint = Eine neue Aufzeichnung tritt an die Stelle dieser. Beide bleiben im Journal.
records-page-corrector = Berichtigt von
records-page-reason = Grund
records-page-reason-mistyped = Tippfehler
records-page-reason-wrong-part = falsches Teil
records-page-reason-trial = Versuch
records-page-withdrawal-hint = Die Aufzeichnung zählt nicht mehr, und nichts tritt an ihre Stelle. Beide Einträge bleiben im Journal.
records-page-withdraw = Aufzeichnung zurücknehmen
records-page-withdraw-hint = Nichts tritt an ihre Stelle
records-page-withdraw-neither = Aufzeichnung { $number }, die durch diese berichtigt wird, zählt dadurch nicht wieder
records-page-send-correction = Berichtigung aufzeichnen
records-page-leave-correction = Abbrechen
records-page-undo-void = Nicht rückgängig gemacht: die Aufzeichnung wurde nach der Berichtigung zurückgenommen
records-page-undone-reason = rückgängig gemacht
records-page-taken-back = { $checks ->
    [one] 1 Prüfung rückgängig gemacht
   *[other] { $checks } Prüfungen rückgängig gemacht
}; { $records ->
    [one] Aufzeichnung { $numbers } ist zurückgenommen
   *[other] Aufzeichnungen { $numbers } sind zurückgenommen
}
records-page-taken-back-unwritten = { $checks ->
    [one] 1 Prüfung rückgängig gemacht; sie war noch nicht aufgezeichnet und wird es auch nicht
   *[other] { $checks } Prüfungen rückgängig gemacht; sie waren noch nicht aufgezeichnet und werden es auch nicht
}
records-page-not-withdrawn = { $records ->
    [one] Aufzeichnung { $numbers } zählt noch und konnte nicht zurückgenommen werden: { $why }
   *[other] Aufzeichnungen { $numbers } zählen noch und konnten nicht zurückgenommen werden: { $why }
}
records-page-undone = Berichtigung rückgängig gemacht
records-page-no-reason = Eine Berichtigung braucht einen Grund
records-page-nothing-changed = Nichts ist anders: ein Feld ändern oder die Aufzeichnung zurücknehmen
records-page-not-open = Die Aufzeichnung ist nicht geöffnet
records-page-not-recording = Prüfungen werden nicht aufgezeichnet

## Das Journal
records-page-place = { $file } · Einträge: { $entries }
records-page-unsent = { $count } noch nicht an { $server } gesendet
records-page-all-sent = alles an { $server } gesendet
records-page-server-unknown = { $server } wurde noch nicht erreicht
records-page-server = Werkstattserver
records-page-server-hint = Sendet jeden Eintrag im Hintergrund an einen PostgreSQL-Server; ohne ihn bleibt alles auf diesem Computer
records-page-server-address = Adresse, wie postgres://fraese3@werkstatt.example/checks
records-page-server-passwords = Das Kennwort kommt aus der Adresse, aus PGPASSWORD, der Kennwortdatei oder dem Schlüsselbund des Systems. Ein Kennwort in der Adresse kommt in den Schlüsselbund und wird sonst nirgends gespeichert.
records-page-take-server = Diesen Server verwenden
records-page-leave-server = Nicht mehr senden
records-page-send-again = Erneut senden
records-page-not-sent = Nicht gesendet: { $why }
records-page-and = { $one }; { $other }
records-page-no-shop = dieses Fitcheck wurde ohne Unterstützung für einen Werkstattserver gebaut (feature shop)
records-page-in-keyring = Das Kennwort von { $server } ist jetzt im Schlüsselbund des Systems
records-page-not-in-keyring = Das Kennwort von { $server } konnte nicht in den Schlüsselbund des Systems gelegt werden ({ $reason }): es gilt, bis das Fenster geschlossen wird, und muss danach aus PGPASSWORD oder der Kennwortdatei kommen
records-page-verify = Verifizieren
records-page-verify-hint = Vergleicht jeden Eintrag mit dem vorigen
records-page-verify-cancel = Verifizierung abbrechen
records-page-verify-cancelled = Verifizierung abgebrochen
records-page-verify-progress = Fortschritt der Verifizierung
records-page-verifying = { $done } von { $of } Einträgen
records-page-whole = { $time }: { $entries } Einträge verifiziert, bis { $number } ({ $hash })
records-page-broken = { $time }: { $entries } Einträge verglichen; das Journal ist nicht so, wie es geschrieben wurde
records-page-not-verified = { $time }: nicht verifiziert: { $why }
records-page-no-anchors = die anderswo bekannten Einträge können nicht gelesen werden: { $why }
