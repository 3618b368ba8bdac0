# report

## Fehler
report-error-writer = der Prüfbericht im Format { $format } konnte nicht erstellt werden: { $reason }
report-error-label-alone = { $format } ist für Etiketten: wählen Sie die Vorlage label oder das Papier small-label oder large-label
report-error-no-statistics = { $format } hat keinen Platz für Statistik: PDF, HTML oder Markdown wählen
report-attachment-too-large = die Daten der Datei sind größer als { $most } Byte
report-attachment-packed = die Daten in der Datei sind mit { $filter } gepackt, das Fitcheck nicht liest
report-attachment-damaged = die Daten in der Datei sind beschädigt: { $reason }
report-attachment-several = die Datei hat { $count } Anhänge mit Prüfungen: erwartet wird einer
report-difference-field = Eintrag { $number }: { $field } ist { $said } in der Datei, { $kept } im Journal
report-difference-missing = Eintrag { $number }: keine Prüfung der Datei sagt, was das Journal sagt
report-difference-more = { $count ->
    [one] die Datei hat 1 Prüfung zu viel
   *[other] die Datei hat { $count } Prüfungen zu viel
}
report-difference-fewer = { $count ->
    [one] in der Datei fehlt 1 Prüfung
   *[other] in der Datei fehlen { $count } Prüfungen
}
report-data-json = die Daten der Datei sind kein Prüfbericht von Fitcheck: { $reason }
report-ending-missing = { $file } hat keine Endung, die das Format des Prüfberichts angibt: eine von { $endings } verwenden
report-ending-unknown = .{ $ending } ist kein Format des Prüfberichts: eines von { $endings } verwenden

## Sätze über eine Prüfung
report-feature-hole = Bohrung
report-feature-shaft = Welle
report-feature-neither = weder Bohrung noch Welle
report-side-good = gut
report-side-rework = Nacharbeit
report-side-scrap = Ausschuss
report-side-out = außer Toleranz
report-side-too-small = zu klein
report-side-too-large = zu groß
report-source-instead = { $source }; ISO 286 sagt hier { $upper } und { $lower } µm
report-too-small = { $um } µm zu klein
report-too-large = { $um } µm zu groß
report-inside = innerhalb der Grenzmaße
report-above-minimum = { $um } µm über Mindestmaß
report-below-minimum = { $um } µm unter Mindestmaß
report-below-maximum = { $um } µm unter Höchstmaß
report-above-maximum = { $um } µm über Höchstmaß
report-position-unknown = nicht gemessen
report-position-unmonitored = nicht überwacht
report-position-in = INNERHALB
report-position-out = AUSSERHALB
report-axis-unmonitored = { $axis } { $deviation } mm: nicht überwacht
report-axis-in = { $axis } { $deviation } mm, zulässig ± { $tolerance } mm: INNERHALB
report-axis-out = { $axis } { $deviation } mm, zulässig ± { $tolerance } mm: AUSSERHALB
report-cause-position = die Mitte ist außer Toleranz; das Maß allein ist { $status }
report-origin-circle = { $origin }; Ausgleichskreis durch { $contacts } Antastpunkte
report-centre = gemessene Mitte X { $x } mm, Y { $y } mm
report-band-nominal = Nennmaß { $size } mm
report-band-title = Toleranzband, gemessen { $value }: { $distances }
report-in-guard-band = nichts ist entschieden: der Wert liegt in einem Sicherheitsband der Entscheidungsregel
report-corrected = gemessen { $measured } mm bei { $temperature } °C, Ausdehnung { $expansion } · 10⁻⁶/K: um { $change } µm korrigiert auf { $reference } mm bei 20 °C
report-all-corrected = gemessen bei { $temperature } °C, Ausdehnung { $expansion } · 10⁻⁶/K; jeder Wert ist auf 20 °C korrigiert
report-scales = Maßstäbe bei { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = ohne Korrektur der Maßstäbe
report-own-uncertainty = u jedes Werts bei seiner Prüfung
report-accepted-zone = { $least } bis { $most } mm
report-accepted-none = keine: die Regel lässt von dieser Toleranz nichts übrig
report-proven = nach dieser Regel nachgewiesen
report-not-proven = nach dieser Regel nicht nachgewiesen
report-conformity = konform mit einer Wahrscheinlichkeit von { $percent } %
report-budget-made = { $name }, erstellt am { $date } von { $by }, gültig bis { $until }
report-budget-expired = am Tag der Prüfung ABGELAUFEN
report-budget-not-yet = am Tag der Prüfung NOCH NICHT GÜLTIG
report-guard-undecided = Sicherheitsband: neu messen
report-guard-beyond = Sicherheitsband: jenseits des Grenzmaßes angenommen
report-guard-range = { $what }, { $from } bis { $to } µm

## Die Seite
report-title = Prüfbericht
report-part = Teil
report-order = Auftrag
report-inspector = Prüfer
report-program = Programm
report-notes = Übersprungene Zeilen und Warnungen
report-no-checks = Dieser Prüfbericht enthält keine Prüfungen.
report-page-all-good = Keine der { $total } Prüfungen steht auf dieser Seite: alle sind gut, und keine ist zweifelhaft. Ein Prüfbericht als CSV oder JSON enthält jede Prüfung.
report-page-not-good = Diese Seite enthält nur die { $listed } von { $total } Prüfungen, die nicht gut oder zweifelhaft sind. Die Anzahlen umfassen jede Prüfung; ein Prüfbericht als CSV oder JSON enthält alle.
report-page-first = Diese Seite enthält nur die ersten { $listed } von { $wanted } Prüfungen, die nicht gut oder zweifelhaft sind, von insgesamt { $total } Prüfungen. Die Anzahlen umfassen jede Prüfung; ein Prüfbericht als CSV oder JSON enthält alle.
report-total = Gesamt
report-check = Prüfung
report-id = Name
report-callout = Toleranzangabe
report-heading-without-callout = { $nominal } mm, Grenzmaße ohne Klasse
report-verdict = Urteil
report-nominal = Nennmaß
report-maximum = Höchstmaß
report-minimum = Mindestmaß
report-measured = Gemessen
report-deviation = Abweichung
report-remove = Abzunehmen
report-on-diameter = im Durchmesser
report-per-side = je Seite
report-remove-to-limit = bis zum Grenzmaß
report-remove-to-middle = bis zur Toleranzmitte
report-remove-to-accepted = bis zu den angenommenen Werten
report-position = Position
report-limits-from = Grenzmaße aus
report-measured-from = Messwert
report-from = Herkunft
report-limits = Grenzmaße
report-missing = Fehlt
report-skipped = Übersprungen
report-verdict-from = Entscheidungsregel
report-temperature = Temperatur
report-accepted = Angenommene Werte
report-proof = Nachweis
report-budget = Messunsicherheitsbudget
report-cannot-tell = Einschränkungen dieser Messung
report-contacts = Antastpunkte
report-contacts-at-end = am Ende des Prüfberichts
report-contact = Nr.
report-radial = radiale Abweichung
report-sign-name = Name
report-sign-date = Datum
report-sign-signature = Unterschrift
report-footer = Jedes Urteil beruht auf ungerundeten Werten und auf den daneben genannten Grenzmaßen und der daneben genannten Entscheidungsregel.

## Hinweise
report-note = { $place }: { $what }
report-note-line = { $place }, Textzeile { $line }: { $what }
report-note-more = { $count ->
    [one] 1 weiterer Hinweis wird nicht angezeigt
   *[other] { $count } weitere Hinweise werden nicht angezeigt
}

## Ein ganzes Teil
report-balloon = Stempel
report-picture-room = { $name } wird hier nicht gezeigt: die Bilder aller Teile würden die Seite zu groß machen
report-picture-beside = { $count ->
    [one] ein Merkmal hat darauf keinen Stempel
   *[other] { $count } Merkmale haben darauf keinen Stempel
}
report-part-older = { $count ->
    [one] Ein weiterer Wert wird nicht angezeigt: je Maß steht hier nur der Wert, der zählt
   *[other] { $count } weitere Werte werden nicht angezeigt: je Maß steht hier nur der Wert, der zählt
}
report-more-parts = { $count ->
    [one] Ein weiteres Teil wird nicht ganz gezeigt; seine Werte stehen in der Liste
   *[other] { $count } weitere Teile werden nicht ganz gezeigt, nur die ersten { $most }; ihre Werte stehen in der Liste
}

## Vorlagen für Berichte
report-template-toml = { $reason }
report-template-version = Vorlagenversion { $found } wird nicht unterstützt: erwartet wird Version { $known }
report-template-too-large = eine Vorlage hat höchstens { $most } Byte
report-template-text = { $key } ist leer, länger als { $longest } Zeichen oder enthält ein Steuerzeichen
report-template-twice = { $key } nennt { $word } zweimal
report-template-empty = { $key } ist leer: mindestens ein Eintrag ist nötig
report-template-language = { $given } ist keine Sprache für Berichte: möglich sind { $known }
report-template-logo = das Logo { $given } muss der Name einer Datei neben der Vorlage sein
report-section-verdict = Urteil
report-section-head = Kopf
report-section-picture = Bild mit Stempeln
report-section-lot = Teile, schlechtestes zuerst
report-section-statistics = Statistik der Merkmale
report-statistics-limits = Die Grenzmaße sind nicht bei allen Werten gleich: Es wird keine Fähigkeit angegeben.
report-statistics-most = Die Statistik enthält nur die ersten { $count } Werte.
report-section-features = Werte
report-section-statement = Konformitätsaussage
report-section-rule = Regel und Grenzen in Worten
report-section-caveats = Einschränkungen der Messung
report-section-remarks = Bemerkungen
report-section-signature = Unterschriftszeile
report-section-code = Code des Eintrags
report-revision = Revision
report-serial = Seriennummer
report-batch = Los
report-customer = Kunde
report-material = Werkstoff
report-station = Station
report-instrument = Messmittel
report-calibrated = Kalibriert
report-date = Datum
report-plan = Prüfplan
report-records = Einträge
report-blank = Wert
report-remark = Bemerkung
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Etikett 62 × 29 mm
report-paper-large-label = Etikett 100 × 50 mm
report-template-inspection = Prüfbericht
report-template-inspection-purpose = Teile oder Prüfungen, mit Bildern
report-template-first-article = Erstmuster
report-template-first-article-purpose = Jedes Merkmal, auch was fehlt
report-template-certificate = Zertifikat
report-template-certificate-purpose = Werte und Konformitätsaussage
report-template-list = Liste der Prüfungen
report-template-list-purpose = Alle Prüfungen untereinander
report-template-statistics = Statistik
report-template-statistics-purpose = Jedes Merkmal über alle Werte, mit Diagrammen
report-template-sheet = Messblatt
report-template-sheet-purpose = Leer, zum Ausfüllen von Hand
report-template-label = Etikett
report-template-label-purpose = Urteil, Teil und Seriennummer
## Seiten zum Drucken
report-pdf-page = Seite { $page } von { $pages }
report-pdf-band = Toleranzband
report-pdf-remove = { $name }: { $um } µm im Durchmesser abnehmen
report-pdf-simulated = Simulierte Werte, von niemandem gemessen: { $count } von { $total }
report-pdf-beyond = Werte, die die Entscheidungsregel außerhalb der Grenzmaße annimmt: { $count } von { $total }
report-pdf-corrected = Auf 20 °C korrigierte Werte: { $count } von { $total }
report-pdf-guarded = Werte mit eigener Entscheidungsregel: { $count } von { $total }
report-pdf-doubted = Zweifelhafte Werte, mit Fragezeichen: { $count } von { $total }
report-pdf-notes = Übersprungene Zeilen und Warnungen, am Ende aufgeführt: { $count }
report-pdf-more-lacks = Weiteres auf den Seiten der Teile: { $count }
report-pdf-more = Weitere in den angehängten Daten: { $count }
report-pdf-all-checks = Alle Prüfungen
report-pdf-attached = An diese Datei angehängt, für Programme: { $names }
report-pdf-not-attached = Nicht alle Daten sind angehängt: eine Datei von mehr als { $most } MB wäre zu groß
report-pdf-contacts = Die Antastpunkte stehen in den angehängten Daten.
report-pdf-cut = Ein Text, der mit … endet, ist hier gekürzt; in den angehängten Daten steht er ganz.
report-pdf-substituted = Ein □ steht für ein Zeichen, das die Schriften dieser Seiten nicht haben, etwa von rechts nach links geschriebene; kopierter Text und die angehängten Daten haben das Zeichen.
report-statement-conforms = { $count ->
    [one] Konformitätsaussage: Der Wert liegt nach der hier genannten Entscheidungsregel innerhalb seiner Grenzen.
   *[other] Konformitätsaussage: Alle { $count } Werte liegen nach der hier genannten Entscheidungsregel innerhalb ihrer Grenzen.
}
report-statement-not = { $count ->
    [one] Keine Konformität: Der Wert ist nach der hier genannten Entscheidungsregel nicht konform.
   *[other] Keine Konformität: { $bad } von { $count } Werten sind nach der hier genannten Entscheidungsregel nicht konform.
}
report-statement-partial = Keine Konformitätsaussage: Einige Zeilen wurden zurückgewiesen, nicht beurteilt oder nicht gelesen. Der Bericht führt sie auf.
report-statement-simulated = { $count ->
    [one] Keine Konformitätsaussage: Ein Wert ist simuliert und wurde von niemandem gemessen.
   *[other] Keine Konformitätsaussage: { $count } Werte sind simuliert und wurden von niemandem gemessen.
}
report-statement-open = Keine Konformitätsaussage: Werte fehlen, insgesamt { $count }.
report-code-said = Code des Eintrags { $number }, sein Hash { $hash }
report-lot-order = Das schlechteste Teil steht zuerst.
## Eine Arbeitsmappe
report-sheets = Nur die ersten { $listed } von { $total } Teilen haben ein eigenes Blatt; das Blatt der Teile enthält alle.
report-sheets-corrected = auf 20 °C
report-sheets-without = Bilder und Antastpunkte stehen nicht in dieser Arbeitsmappe: Ein Prüfbericht als HTML enthält beides, einer als JSON die Antastpunkte.
report-sheets-cut = { $count ->
    [one] Ein Text ist gekürzt: Eine Zelle fasst höchstens 32767 Zeichen.
   *[other] { $count } Texte sind gekürzt: Eine Zelle fasst höchstens 32767 Zeichen.
}
report-journal = Einträge { $numbers } des Journals { $chain }; sein letzter Eintrag damals: { $number }:{ $hash }
report-template-new-about = Eine Vorlage für Berichte. Löschen Sie, was ein Bericht nicht zeigen soll; entfernen Sie das # vor dem, was er zeigen soll.
report-template-new-name = Neue Vorlage
report-changed-since = Geändert seit dem Bericht vom { $since }:
report-changed-none = kein Ergebnis und keine Grenze
report-changed-result = { $name }: { $before } → { $now }
report-changed-limits = { $name }: Grenzen { $low } bis { $high } → { $lower } bis { $higher } mm
report-changed-added = { $name }: neu
report-changed-removed = { $name }: nicht mehr im Bericht
report-changed-several = { $name }: nicht verglichen, weil mehrere Werte vorliegen
report-since-no-report = kein Bericht von Fitcheck mit seinen Daten: geben Sie sein PDF oder sein JSON an
