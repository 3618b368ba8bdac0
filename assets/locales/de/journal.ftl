## Die Kette eines Journals
journal-hex = "{ $text }" sind nicht { $digits } Hexadezimalziffern
journal-break-changed = Eintrag { $number } ist nicht der, der geschrieben wurde
journal-break-removed = { $count ->
        [one] Eintrag { $number } fehlt
       *[other] { $count } Einträge ab { $number } fehlen
    }
journal-break-inserted = Eintrag { $number } wurde eingefügt
journal-break-reordered = Einträge { $number } und { $other } sind vertauscht
journal-break-rewritten = Eintrag { $number } weicht von dem anderswo bekannten ab: das Journal wurde von dort oder von einem früheren Eintrag an neu geschrieben
journal-break-cut-off = das Journal endet mit Eintrag { $last }, anderswo ist aber Eintrag { $known } bekannt: seine neuesten Einträge wurden abgeschnitten, oder eine ältere Kopie wurde zurückgespielt

## Einträge
journal-body-json = kein Eintrag eines Journals: { $reason }
journal-body-newer = von einem neueren Fitcheck: Version { $version } des Formats, dieses Fitcheck liest Versionen bis { $known }
journal-body-too-large = kein Eintrag eines Journals: { $bytes } Byte, höchstens { $most } sind zulässig
journal-body-too-long = { $field } hat { $bytes } Byte, höchstens { $most } sind zulässig
journal-body-control = { $field } hat das Steuerzeichen { $code } als Zeichen { $place }: Texte eines Journals sind eine Zeile ohne Steuerzeichen
journal-body-empty = { $field } ist leer
journal-body-too-many = { $field } hat { $count } Angaben, höchstens { $most } sind zulässig
journal-body-value = { $field } kann nicht "{ $given }" sein
journal-body-contradiction = { $field } widerspricht den Feldern, aus denen es folgt
journal-origin-perfect = simuliert, ideales Werkstück
journal-origin-workpiece = simuliert, { $file }, Startwert { $seed }
journal-origin-contacts = Antastpunkte aus { $file }
journal-check-judged-otherwise = als { $kept } entschieden, das gilt; diese Version von Fitcheck entscheidet { $now }

## Fragen
journal-ask-at = { $reason } (Zeichen { $at })
journal-ask-unknown-key = { $key }: ist kein bekanntes Schlüsselwort; { $known } erwartet, oder Anführungszeichen um ein Wort mit Doppelpunkt
journal-ask-no-value = { $key }: hat keinen Wert
journal-ask-empty-word = ein Wort in Anführungszeichen ist leer
journal-ask-twice = { $key } ist zweimal angegeben
journal-ask-not-closed = ein Anführungszeichen ist nicht geschlossen
journal-ask-after-quote = ein Leerzeichen nach dem schließenden Anführungszeichen erwartet, { $found } gefunden
journal-ask-date = "{ $given }" ist weder Tag noch Zeit: 2026-11-23 oder 2026-11-23T14:30 erwartet
journal-ask-verdict = "{ $given }" ist kein Urteil: { $known } erwartet
journal-ask-callout = { $error }; eine Toleranzangabe gehört in Anführungszeichen: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = der Zeitraum endet, bevor er beginnt: from muss vor to liegen
journal-ask-both-origins = simulated und measured schließen einander aus
journal-ask-both-kinds = reports und checks schließen einander aus
journal-ask-too-long = die Abfrage hat { $bytes } Byte, höchstens { $most } sind zulässig

## Das Journal einer Station
store-missing = kein Journal unter { $path }
store-not-a-file = { $path } ist keine Datei
store-not-a-journal = { $path } ist kein Journal von Fitcheck; es blieb unverändert
store-newer = { $path } stammt von einem neueren Fitcheck (Version { $version }, dieses unterstützt { $known }); es blieb unverändert
store-older = { $path } stammt von einem älteren Fitcheck: es wird umgestellt, sobald etwas darin aufgezeichnet wird
store-damaged = { $path } ist beschädigt: seine Seiten widersprechen einander
store-full = kein Platz mehr für { $path }: nichts wurde aufgezeichnet
store-read-only = in { $path } darf nicht geschrieben werden: nichts wurde aufgezeichnet
store-locked = ein anderes Programm hat { $path } zu lange gesperrt: nichts wurde aufgezeichnet
store-disk = der Datenträger von { $path } meldet einen Fehler: { $reason }
store-cannot-open = { $path } kann nicht geöffnet werden
store-network-folder = { $path } liegt in einem Ordner eines anderen Rechners, wo zwei Stationen einander die Einträge überschreiben könnten: einen Ordner auf diesem Rechner wählen, und einen Server für die Werkstatt
store-altered = "{ $name }", das Einträge vor Änderungen schützt, fehlt in { $path } oder wurde geändert
store-no-beginning = { $path } sagt nicht, welche Kette es ist
store-moved = { $path } wurde inzwischen verschoben oder beiseitegelegt: nichts wurde aufgezeichnet
store-other-target = Eintrag { $number } ist nicht der, der berichtigt werden sollte: nichts wurde aufgezeichnet
store-corrected = Eintrag { $number } wurde schon durch Eintrag { $by } berichtigt oder zurückgenommen: jenen berichtigen, wenn er keine Rücknahme ist
store-is-report = Eintrag { $number } ist ein Prüfbericht: er sagt, welche Datei geschrieben wurde, und kann nicht berichtigt oder zurückgenommen werden
store-is-alarm = Eintrag { $number } ist ein Alarm einer Regelkarte: er sagt, welche Regel ausgelöst hat, und kann nicht berichtigt oder zurückgenommen werden; stattdessen beantworten
store-no-alarm = Eintrag { $number } ist kein Alarm einer Regelkarte: nur ein solcher kann beantwortet werden
journal-alarm-since-part = { $rule }, seit Teil { $serial }
journal-alarm-since-entry = { $rule }, seit Eintrag { $number }
store-other-journal = Eintrag { $number } dieses Journals ist nicht der, den der Prüfbericht nennt: nichts wurde aufgezeichnet
store-finding-no-beginning = das Journal hat keinen ersten Eintrag, der seine Kette nennt
store-finding-pages = die Seiten des Journals widersprechen einander, und Abfragen können vorhandene Einträge übersehen: { $reason }
store-finding-index = ein Index für Abfragen passt nicht zu seiner Tabelle: { $reason }
store-hidden = Eintrag { $number } von { $path } steht nicht an seinem Platz: das Journal wurde geändert oder seine Datei ist beschädigt; fitcheck journal verify ausführen
store-no-entry = { $path } hat keinen Eintrag { $number }: der letzte ist { $last }
store-backup = die Kopie von { $path } war unvollständig und wurde entfernt
store-interrupted = angehalten
store-database = { $path }: { $reason }
store-remark-begun = ein neues Journal wurde angelegt: { $path }
store-remark-set-aside = das Journal { $path } war beschädigt: es liegt jetzt unverändert in { $folder }, und ein neues wurde an seiner Stelle angelegt
store-remark-migrated = { $path } wurde auf diese Version umgestellt; die Datei im früheren Zustand ist { $copy }
store-remark-behind = { $path } endet mit Eintrag { $last }, hatte aber schon Eintrag { $known }: seine neuesten Einträge wurden abgeschnitten, oder eine ältere Kopie wurde zurückgespielt
store-remark-other = Eintrag { $number } von { $path } ist anders als früher: das Journal wurde von dort oder von einem früheren Eintrag an neu geschrieben
store-remark-replaced = { $path } ist nicht das Journal, das vorher dort war und { $known } Einträge hatte
store-remark-waits = ein anderes Programm schreibt in { $path }: warten, bis es fertig ist
store-remark-no-anchor = der letzte Eintrag dieses Journals konnte nicht in { $path } vermerkt werden: { $reason }
store-finding-altered = "{ $name }", das Einträge vor Änderungen schützt, fehlt oder wurde geändert
store-finding-not-found = { $entries ->
        [one] 1 Eintrag ist unter anderem verzeichnet, als er sagt, oder gar nicht verzeichnet
       *[other] { $entries } Einträge sind unter anderem verzeichnet, als sie sagen, oder gar nicht verzeichnet
    }
