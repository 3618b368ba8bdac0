# report

## Fehler
report-error-writer = der Prüfbericht im Format { $format } konnte nicht erstellt werden: { $reason }
report-ending-missing = { $file } hat keine Endung, die das Format des Prüfberichts angibt: eine von { $endings } verwenden
report-ending-unknown = .{ $ending } ist kein Format des Prüfberichts: eines von { $endings } verwenden

## Sätze über eine Prüfung
report-feature-hole = Bohrung
report-feature-shaft = Welle
report-side-good = gut
report-side-rework = Nacharbeit
report-side-scrap = Ausschuss
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
report-created = Erstellt
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

## Eine Arbeitsmappe
report-sheets = Nur die ersten { $listed } von { $total } Teilen haben ein eigenes Blatt; das Blatt der Teile enthält alle.
report-sheets-corrected = auf 20 °C
report-sheets-without = Bilder und Antastpunkte stehen nicht in dieser Arbeitsmappe: Ein Prüfbericht als HTML enthält beides, einer als JSON die Antastpunkte.
report-sheets-cut = { $count ->
    [one] Ein Text ist gekürzt: Eine Zelle fasst höchstens 32767 Zeichen.
   *[other] { $count } Texte sind gekürzt: Eine Zelle fasst höchstens 32767 Zeichen.
}
