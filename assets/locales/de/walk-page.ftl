# Der Gang durch ein Teil, und der überwachte Ordner, auf der Seite Teile.

walk-page-begin = Teil beginnen
walk-page-count-up = Nächste Nummer
walk-page-take = Beurteilen
walk-page-take-meant = { $meant } mm verwenden
walk-page-it-is-so = Es ist so: { $measured } mm beurteilen
walk-page-measure-anew = Verwerfen und neu messen
walk-page-confirmed = bei der Messung bestätigt: es ist so
walk-page-alarms = Offene Alarme: { $count }
walk-page-alarms-short = Alarme
walk-page-alarms-more = Weitere Alarme: { $count }
walk-page-alarm = { $name }: { $said }
walk-page-alarm-ask = Alarm beantworten
walk-page-alarm-ask-of = Alarm beantworten: { $name }
walk-page-alarm-answer = Antwort eintragen
walk-page-alarm-later = Später
walk-page-alarm-cause = Ursache
walk-page-alarm-action = Maßnahme
walk-page-alarm-causes = Werkzeugverschleiß; Neues Werkzeug; Werkzeugkorrektur; Spannung; Späne oder Schmutz; Temperatur; Werkstoff; Messfehler; Unbekannt
walk-page-alarm-actions = Werkzeug gewechselt; Korrektur geändert; Teil neu gespannt; Maschine gereinigt; Neu gemessen; Einrichter informiert; Wird beobachtet; Keine nötig
walk-page-alarm-empty = einen Text schreiben oder einen aus der Liste wählen
walk-page-alarms-unread = Die Regeln der Regelkarten können nicht geprüft werden: { $why }
walk-page-alarms-unchecked = Die Regeln der Regelkarten können nicht geprüft werden, { $name }: { $why }
walk-page-alarm-unrecorded = Der Alarm der Regelkarte kann nicht aufgezeichnet werden: { $why }
walk-page-simulate = Simulieren
walk-page-simulate-hint = Führt den Zyklus des Merkmals an einem idealen Teil aus; niemand misst den Wert, und er bleibt als simuliert gekennzeichnet
walk-page-again = Neu messen
walk-page-skip = Überspringen
walk-page-skip-for = Aus diesem Grund überspringen
walk-page-skip-not = Nicht überspringen
walk-page-next = Nächstes Teil
walk-page-move = Zu einem anderen Maß
walk-page-import = Werte importieren…
walk-page-watch = Ordner überwachen…
walk-page-watch-hint = In den Ordner gelegte Dateien werden nach dem Plan beurteilt und aufgezeichnet, jede einmal
walk-page-watch-stop = Überwachung beenden
walk-page-dialog-watch = Ordner überwachen
walk-page-begin-warned = { $count ->
    [one] 1 Maß dieses Teils hat weder Wert noch Grund. Noch einmal drücken, um dieses Teil zu beenden.
   *[other] { $count } Maße dieses Teils haben weder Wert noch Grund. Noch einmal drücken, um dieses Teil zu beenden.
}
walk-page-no-plan = Noch kein Plan: einen öffnen oder in der Ansicht Plan anlegen.
walk-page-plan-wrong = { $count ->
        [one] Der Plan hat einen Fehler: siehe Ansicht Plan.
       *[other] Der Plan hat { $count } Fehler: siehe Ansicht Plan.
    }
walk-page-not-saved = Der Plan hat nicht gespeicherte Änderungen: ein unterbrochenes Teil kann nach einem Neustart nicht wiederhergestellt werden.
walk-page-serial = Seriennummer
walk-page-serial-again = Seriennummer { $serial } wurde schon gemessen. Nach einer halben Sekunde noch einmal Enter drücken, um sie neu zu beginnen.
walk-page-serial-hint = Eingeben, scannen oder die nächste Nummer verwenden; Enter beginnt das Teil.
walk-page-recent = Letzte Pläne
walk-page-done = Jedes Maß hat einen Wert oder ist übersprungen
walk-page-part = { $part }, Seriennummer { $serial }
walk-page-part-serial = Seriennummer { $serial }
walk-page-part-no-serial = { $part }, keine Seriennummer
walk-page-other-plan = Der Plan wurde seitdem geändert: die Änderungen gelten ab dem nächsten Teil.
walk-page-part-of = Dieses Teil wird gemessen nach { $own }
walk-page-open-is = Jetzt geöffnet: { $open }
walk-page-begin-by = Teil beginnen nach { $open }
walk-page-keep-on = Dieses Teil weiter messen
walk-page-unfinished = Ein Teil nach { $own } ist nicht fertig. Messen fragt, ob es weitergeht.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = Keine Lage im Plan
walk-page-value = Messwert
walk-page-measured-before = { $count ->
        [one] Einmal gemessen: beide Werte bleiben erhalten, und der neue zählt
       *[other] { $count }-mal gemessen: alle Werte bleiben erhalten, und der neue zählt
    }
walk-page-last-counts = { $count }-mal gemessen: alle Werte bleiben erhalten, und dieser zählt
walk-page-skip-why = Grund für das Überspringen
walk-page-skip-access = Kein Zugang für das Tastsystem
walk-page-skip-gauge = Messmittel fehlt
walk-page-skip-machined = Noch nicht bearbeitet
walk-page-skip-elsewhere = Anderswo gemessen
walk-page-reason = Anderer Grund
walk-page-no-reason = ein Grund fehlt
walk-page-skipped = übersprungen: { $reason }
walk-page-next-warned = { $count ->
        [one] Ein Maß hat weder Wert noch Grund. Noch einmal Nächstes Teil wählen, um dieses Teil zu beenden.
       *[other] { $count } Maße haben weder Wert noch Grund. Noch einmal Nächstes Teil wählen, um dieses Teil zu beenden.
    }
walk-page-typed-elsewhere = der Wert wurde für { $name } eingegeben, und jetzt ist { $asked } gefragt: noch einmal eingeben
walk-page-next-size = Nächstes: { $name }, { $asked }
walk-page-is-serial = { $given } sieht wie eine Seriennummer aus und wird nicht als Wert genommen: erst dieses Teil abschließen, dann für das nächste scannen. Ist es doch der Messwert, mit mehr Nachkommastellen eingeben
walk-page-simulate-measured = { $name } ist gemessen: ein simulierter Wert tritt nie an die Stelle eines gemessenen
walk-page-part-status = Status des Teils
walk-page-not-complete = Noch kein Urteil
walk-page-simulated = { $count ->
        [one] Ein Wert ist simuliert: niemand hat ihn gemessen, damit kann das Teil nicht gut sein.
       *[other] { $count } Werte sind simuliert: niemand hat sie gemessen, damit kann das Teil nicht gut sein.
    }
walk-page-missing = Fehlt: { $names }
walk-page-off = Das Aufzeichnen ist ausgeschaltet: ein unterbrochenes Teil kann nach einem Neustart nicht wiederhergestellt werden.
walk-page-nowhere = Nichts wird aufgezeichnet: ein unterbrochenes Teil kann nach einem Neustart nicht wiederhergestellt werden.
walk-page-no-part = Kein Teil wird gemessen.
walk-page-sizes = Maße des Teils
walk-page-open = offen
walk-page-row-simulated = simuliert
walk-page-times = { $count } Werte
walk-page-rule-plan = Beurteilt nach der Regel des Plans: { $rule }
walk-page-rule-own = Der Plan hat keine Regel; beurteilt nach der Regel der Seite Prüfung: { $rule }
walk-page-nothing-asked = kein Maß des Plans wird gemessen
walk-page-refused = { $count ->
        [one] Eine Prüfung wurde nicht aufgezeichnet: { $why }
       *[other] { $count } Prüfungen wurden nicht aufgezeichnet: { $why }
    }
walk-page-import-late = { $name } wurde gelesen, als das Teil schon beendet war: die Werte werden nicht verwendet
walk-page-imported = { $name }: { $good } importiert, { $bad } nicht
walk-page-file-for-check = Nichts darin gehört zu diesem Plan. Die Seite Prüfung kann die Datei nach dem beurteilen, was sie selbst verlangt
walk-page-found-by-name = { $count ->
    [one] Nach Name zugeordnet: 1 Zeile
   *[other] Nach Name zugeordnet: { $count } Zeilen
}
walk-page-found-by-number = Nur nach Nummer zugeordnet, mit Textzeilen: { $rows }
walk-page-found-by-place = Nach Lage zugeordnet, mit Textzeilen: { $rows }
walk-page-other-parts = Werte anderer Teile werden unter deren Seriennummern aufgezeichnet: { $serials }
walk-page-label = Die Datei hat keine Seriennummern und nennt das Teil { $part }: ihre Werte gelten für dieses Teil
walk-page-other-label = vom Teil { $part }, und ohne Seriennummer ist nicht bekannt, ob es dieses Teil ist
walk-page-remark-label = Teil in der Datei: { $part }
walk-page-not-judged = Textzeile { $line }: { $why }
walk-page-no-journal = Teil { $serial } wurde ohne seine Werte wiederhergestellt: es gibt keine Aufzeichnungen dafür
walk-page-gone = Manche Maße stehen nicht mehr im Plan: ihre Messwerte bleiben aufgezeichnet
walk-page-gone-name = { $name }
walk-page-changed = Der Plan wurde geändert: Werte, die nach anderen Grenzmaßen oder einer anderen Regel beurteilt sind, und Werte von Zeilen ohne Namen bleiben aufgezeichnet, und ihre Maße sind wieder offen
walk-page-changed-size = { $name }: { $measured } mm wurde gemessen nach { $asked }
walk-page-given-up = Das unterbrochene Teil { $serial } wird nicht wiederhergestellt, da ein anderes Teil begonnen wurde: seine Werte bleiben aufgezeichnet
walk-page-ended = Nicht verwendet für das Teil { $serial }, das beendet ist
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = Ein Wert von { $name } wurde im Journal berichtigt oder zurückgenommen: er gilt nicht mehr für dieses Teil
walk-page-put-right = Ein Wert von { $name } wurde im Journal berichtigt: der berichtigte gilt für dieses Teil
walk-page-no-folder = { $path } ist kein Ordner
walk-page-not-read = Die Werte des unterbrochenen Teils konnten nicht gelesen werden: { $why }
walk-page-came-back = { $count ->
        [one] Das unterbrochene Teil { $serial } wurde mit einem Wert wiederhergestellt
       *[other] Das unterbrochene Teil { $serial } wurde mit { $count } Werten wiederhergestellt
    }
walk-page-watched = Überwachter Ordner
walk-page-part-waits = Teil { $serial } wird wiederhergestellt, sobald sein Plan keine Fehler mehr hat
walk-page-watch-waits = Ordner { $path } wird wieder überwacht, sobald der Plan keine Fehler mehr hat
walk-page-watch-no-plan = zum Überwachen eines Ordners ist ein Plan ohne Fehler nötig: zuerst einen öffnen
walk-page-watch-no-journal = das Journal kann nicht geöffnet werden: welche Dateien schon importiert sind, ist nicht bekannt, daher wird kein Ordner überwacht
walk-page-watch-begins = Im Journal wird nach schon importierten Dateien gesucht
walk-page-known = { $count ->
        [0] Das Journal hat keine früher importierten Dateien
        [one] Das Journal hat eine früher importierte Datei, aus welchem Ordner auch immer: sie wird nicht noch einmal importiert
       *[other] Das Journal hat { $count } früher importierte Dateien und Teile von Dateien, aus welchem Ordner auch immer: sie werden nicht noch einmal importiert
    }
walk-page-mask = Ausgabe von FN 16 wird über die Maske { $name } zurückgelesen
walk-page-watch-recording = Wird aufgezeichnet
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] Eine Datei importiert
       *[other] { $count } Dateien importiert
    }
walk-page-report = Bericht…
walk-page-report-people = Prüfbericht ({ $format })…
walk-page-report-programs = Werte des Teils als { $format }…
walk-page-contradicted = { $names }: Werte widersprechen einander, und nichts sagt, welcher richtig ist. Der schlechteste zählt, bis neu gemessen oder gewählt wird.
walk-page-contradicting = { $name } hat Werte, die einander widersprechen: { $values }. Der schlechteste zählt, bis neu gemessen oder gewählt wird.
walk-page-count-newest = Der letzte Wert zählt
walk-page-newest-counts = { $name }: der letzte Wert zählt, wie gewählt
walk-page-accepted = Außerhalb der Grenzmaße angenommen: { $names }
walk-page-because = Wegen { $names }
walk-page-left-out = Übersprungen: { $names }. Ein Teil mit übersprungenen Maßen kann nicht gut sein.
walk-page-whole = Das ganze Teil
walk-page-whole-serial = Das Teil { $serial }
walk-page-strip-open = Das Teil: noch kein Urteil
walk-page-strip-part = Das Teil: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Gemessen nach dem Plan { $name }
walk-page-judged-by-plan = Beurteilt nach dem Plan { $name }
walk-page-watch-no-mask = Die eigene Maske { $path } kann nicht gelesen werden: der Ordner wird überwacht, sobald diese Maske erneut oder eine andere gewählt ist (Menü, Eigene Maske…)
walk-page-watch-nobody = { $count ->
        [one] Ein Wert ist ohne Seriennummer aufgezeichnet: seine Datei nennt keine, und kein Teil wird nach diesem Plan gemessen
       *[other] { $count } Werte sind ohne Seriennummer aufgezeichnet: ihre Datei nennt keine, und kein Teil wird nach diesem Plan gemessen
    }
walk-page-watch-other-plan = Der Ordner wird nach dem Plan beurteilt, wie er zu Beginn der Überwachung war. Ein Teil beginnen oder den Ordner neu überwachen, um nach dem jetzigen Plan zu beurteilen.
walk-page-watch-not-saved = Der Plan hat nicht gespeicherte Änderungen: der Ordner wird nach einem Neustart nicht wieder überwacht.
walk-page-values = Werte von { $name }
walk-page-to-do = { $name }: { $what }
walk-page-of = Maß { $at } von { $count }
walk-page-no-serial = Keine Seriennummer
