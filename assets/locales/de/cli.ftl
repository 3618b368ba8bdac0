# Die Befehlszeile

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = Warnung: { $what }
cli-remark = Hinweis: { $what }

# Worum es bei einem Fehler geht
cli-what-callout = Toleranzangabe
cli-what-measured-value = Messwert
cli-what-hole = Bohrung
cli-what-shaft = Welle
cli-what-measured-hole = gemessene Bohrung
cli-what-measured-shaft = gemessene Welle
cli-what-hole-material = Werkstoff der Bohrung
cli-what-shaft-material = Werkstoff der Welle
cli-what-temperature = Temperatur
cli-what-smallest-clearance = kleinstes Spiel
cli-what-largest-clearance = größtes Spiel
cli-what-nominal-size = Nennmaß { $text }
cli-what-true-diameter = wahrer Durchmesser
cli-what-simulated-workpiece = simuliertes Werkstück
cli-what-simulated-measurement = simulierte Messung
cli-what-perfect-workpiece = Werkstück mit Nennmaß
cli-what-size = Maß
cli-what-cycle = Zyklus { $code }
cli-what-log = Messprotokoll
cli-what-entry = Eintrag { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Fehler
cli-batch-simulated = die ersten Textzeilen von { $name } sagen, dass die Datei simuliert ist, und nur CSV kann sie behalten: CSV schreiben
cli-dash = - ist die Standardausgabe, und das ist hier nicht möglich: einen Namen angeben, oder ./- für eine Datei oder einen Ordner namens -
cli-no-subcommand = { $given } ist kein Unterbefehl; hier gibt es: { $names }
cli-not-above-zero = { $diameter } mm ist nicht größer als 0
cli-ratio-of-one-limit = Regel asme-simple vergleicht die Unsicherheit mit der Toleranz: --lower und --upper erwartet
cli-already-corrected = --temperature: laut Datei gelten ihre Werte schon bei 20 °C
cli-not-a-multiple = { $given }: eine Zahl über 0 mit höchstens drei Nachkommastellen erwartet
cli-no-limits = --lower, --upper oder beide angeben, mit dem unteren Grenzmaß unter dem oberen
cli-risk-without-uncertainty = die Risiken eines Prozesses brauchen --u oder --expanded
cli-risk-without-process = --consumer-risk braucht --process-mean und --process-sd, oder --gamma
cli-not-a-risk = Risiko { $given }: eine Wahrscheinlichkeit zwischen 0 und 1 erwartet, wie 0.001
cli-not-a-gamma = Gammaverteilung { $given }: Form und Skala in µm erwartet, wie 4,0.25
cli-no-zone-for-risk = kein Bereich angenommener Werte hat dieses Risiko für den Kunden
cli-line-too-long = die Textzeile ist länger als { $limit } Byte
cli-not-a-table = { $name } ist keine Tabelle mit Grenzabmaßen
cli-stats-features = mehrere Merkmale: eines mit --feature wählen: { $names }
cli-stats-no-feature = kein Merkmal { $given }: die Dateien haben { $names }
cli-stats-limits = die Grenzwerte unterscheiden sich von Wert zu Wert: --lower und --upper angeben oder ein Merkmal mit --feature wählen
cli-stats-no-point = kein Punkt { $point }: die Karte hat { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (wenn es stimmt: --confirm-layout)
cli-stats-no-budget = diese Studie gibt keinen Beitrag zu einem Budget
cli-stats-no-picture = kein Bild möglich: { $why }
cli-stats-points = --stage und --leave-out gelten für ein Merkmal: mit --feature wählen statt --all
cli-stats-parameters = --parameters gilt für --chart ewma oder cusum
cli-add-feature = { $error }: --feature hole oder --feature shaft hinzufügen
cli-add-wide-zone = { $asked }: { $error }; ist dieses Toleranzfeld so gewollt, --wide-zone hinzufügen
cli-add-far-temperature = { $what }: { $error }; ist diese Temperatur so gewollt, --far-temperature hinzufügen
cli-remark-open = { $count ->
    [one] ein Wert ist außerhalb der Grenzen; ob das Nacharbeit oder Ausschuss ist, hängt von Bohrung oder Welle ab: --feature hole oder --feature shaft hinzufügen, eine Spalte kind mit diesen Wörtern oder einen Plan
   *[other] { $count } Werte sind außerhalb der Grenzen; ob das Nacharbeit oder Ausschuss ist, hängt von Bohrung oder Welle ab: --feature hole oder --feature shaft hinzufügen, eine Spalte kind mit diesen Wörtern oder einen Plan
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked }: { $um } µm über dem Höchstmaß; ob das Nacharbeit oder Ausschuss ist, hängt von Bohrung oder Welle ab: --feature hole oder --feature shaft hinzufügen
   *[below] { $asked }: { $um } µm unter dem Mindestmaß; ob das Nacharbeit oder Ausschuss ist, hängt von Bohrung oder Welle ab: --feature hole oder --feature shaft hinzufügen
}
cli-parts-of-several = gemessene Teile gehören zu einer einzigen Passung: eine einzige Toleranzangabe nennen
cli-search-with-parts = eine Suche nimmt keine gemessenen Teile, Werkstoffe oder Temperaturen
cli-search-without-size = eine Suche braucht ein einziges Nennmaß, wie 25
cli-search-without-clearance = eine Suche braucht --min-clearance und --max-clearance
cli-table-ending = { $path }: der Name einer Tabelle der Steuerung endet auf .tab
cli-format-ending = { $path }: eine Datei im Format { $format } endet auf .{ $endings }
cli-several-tables = eine Tabelle der Steuerung ist eine einzige Datei: eine Tabelle nennen, oder Klassen nur für Bohrungen oder nur für Wellen
cli-report-format = --format { $format } passt nicht zur Endung von { $file }: eines von beiden weglassen
cli-stopped = mit Ctrl+C angehalten nach { $rows } Zeilen
cli-report-empty = keine Prüfung war verwendbar, daher wurde kein Prüfbericht geschrieben
cli-inputs-too-large = die Eingaben eines Zyklus haben höchstens { $most } KiB
cli-not-an-object = die Eingaben müssen ein JSON-Objekt sein, wie {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: eine Zahl oder ein Text erwartet
cli-given-twice = { $name } ist zweimal angegeben
cli-option-of-standard = --{ $option } hat mit --source control keine Wirkung: die Tabellen der Steuerung haben eine einzige Ausgabe von ISO 286
cli-set-twice = { $name } ist zweimal gesetzt
cli-several-blocks = mehrere Messzyklen, in den Zeilen { $blocks }: mit --at ZEILE einen wählen
cli-other-cycle = das ist Zyklus { $given }, nicht { $wanted }
cli-not-predef = für Parameter { $name } ist PREDEF nicht zulässig
cli-no-probe = die Tastsystemtabelle hat kein Tastsystem { $number }
cli-not-a-pair = { $text }: einen Parameter als NAME=WERT schreiben
cli-not-a-position = Position { $text }: drei Zahlen X,Y,Z in mm erwartet
cli-not-a-number = das ist keine Zahl
cli-no-folder = Ordner nicht vorhanden: { $path }
cli-watched-already = ein anderes Programm überwacht { $path } schon für dieses Journal
cli-no-program = { $error }; mitgelieferte Programme sind { $names }
cli-option-beside-plan = --{ $option } gilt für eine einzelne Toleranzangabe: ein Plan hat dafür eine Spalte
cli-option-missing = --{ $option } fehlt: eine einzelne Toleranzangabe braucht --x, --y und --z
cli-batch-ending = { $path }: die Ausgabe muss auf .{ $endings } enden, mit .gz oder .zst dahinter zum Komprimieren
cli-batch-onto-itself = { $path } ist eine der Eingabedateien: die Antworten in eine andere Datei schreiben
cli-batch-columns = { $name } hat andere Spalten als die erste Datei; diese hat { $columns }
cli-batch-separator = { $name } hat ein anderes Trennzeichen als die erste Datei: .jsonl schreiben oder diese Datei getrennt beurteilen
cli-batch-types = Spalte { $column } von { $name } hat in der ersten Datei einen anderen Typ: .csv schreiben oder diese Datei getrennt beurteilen
cli-batch-packed = { $path }: Parquet ist schon komprimiert: .gz oder .zst weglassen
cli-batch-twice = { $name } hat zwei Spalten mit dem Namen { $column }: .csv schreiben, dort sind beide möglich
cli-batch-input = { $name }: { $error }
cli-batch-name = { $name } hat schon eine Spalte { $column }: mit --prefix ein Wort vor die Namen der hinzugefügten Spalten setzen
cli-use-force = { $error }; --force überschreibt

# Ein --check eines Prüfberichts
cli-check-no-measured = { $text } hat keinen Messwert: Toleranzangabe, = und Millimeter schreiben, wie 25 H7=25.012
cli-check-measured = Messwert: { $value }
cli-check-not-positive = Messwert { $measured } mm ist nicht größer als 0

# Hinweise
cli-remark-wrote = { $path } geschrieben
cli-remark-wrote-files = { $path } geschrieben ({ $count } Dateien)
cli-remark-simulated = simuliert: nichts wurde gemessen
cli-remark-perfect-workpiece = simuliert: jeder Zyklus hat ein ideales Werkstück mit Nennmaß gemessen; für ein anderes Werkstück --workpiece FILE.toml benutzen
cli-remark-corrected = gemessen { $measured } mm bei { $temperature } °C: { $change } µm, also { $at-reference } mm bei 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = jeder Messwert wird von { $temperature } °C auf 20 °C korrigiert ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = Maßstäbe bei { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = die lineare Korrektur weicht um { $off } µm von der genauen ab
cli-remark-rule = Regel: { $rule }
cli-remark-rule-by-budget = Regel: { $rule }
cli-remark-budget = Unsicherheit aus dem Budget { $name }, erstellt am { $date }, gültig bis { $until }
cli-remark-budget-contacts = Streuung von { $touches } Antastpunkten{ $step }, Geometriefaktor { $factor }
cli-remark-accepted = angenommen: { $least } bis { $most } mm
cli-remark-nothing-accepted = kein Wert wird angenommen: die Regel lässt von dieser Toleranz nichts übrig
cli-remark-proven = nach dieser Regel nachgewiesen
cli-remark-not-proven = nach dieser Regel nicht nachgewiesen
cli-remark-conformity = konform mit einer Wahrscheinlichkeit von { $percent } %
cli-remark-remove = { $limit } mm abnehmen bis zum Grenzmaß, { $middle } mm bis zur Toleranzmitte
cli-remark-refused = { $refused } von { $asked } Toleranzangaben abgewiesen
cli-remark-no-pair = keine Passung erfüllt das; die nächstliegende ist { $nearest }
cli-remark-trace-ends = die Ablaufliste endet hier, nach { $blocks } NC-Sätzen
cli-remark-batch-utf16 = { $name } ist UTF-16 und wird als UTF-8 geschrieben
cli-remark-batch-floats = { $name } hat Gleitkommazahlen in { $columns }: jede wird als die kürzeste Dezimalzahl beurteilt, die sie darstellt
cli-remark-tools-not-written = die Werkzeugtabelle ist nicht geschrieben: --tools-out FILE.t schreibt sie mit diesen Änderungen
cli-remark-clearance-height = die sichere Höhe ist { $height } mm: --clearance-height ändert sie
cli-remark-more-entries = nur { $limit } Einträge werden angezeigt: mit --limit N mehr
cli-remark-backed-up = kopiert bis Eintrag { $number } nach { $path } (Hash { $hash })
cli-remark-no-head-known = kein Eintrag dieses Journals ist anderswo bekannt: fehlende neueste Einträge würden nicht gefunden

# Warnungen
cli-warning-stopped-unrecorded = nichts wurde aufgezeichnet: Zeilen werden gemeinsam aufgezeichnet, sobald alle gelesen sind
cli-warning-column-not-used = Spalte { $column } ist übersprungen
cli-warning-expansion-unconfirmed = die Ausdehnung von { $expansion } · 10⁻⁶/K ist ein üblicher Wert, den hier kein Dokument bestätigt
cli-warning-file-twice = diese Datei ist zweimal genannt: ihre Zeilen zählen doppelt
cli-warning-position-unused = --position hat keine Wirkung: Zyklus { $code } beginnt nicht an der Kugelposition
cli-warning-predef-unused = --predef hat keine Wirkung auf { $name }: der Parameter steht nicht auf PREDEF
cli-warning-log-option = --{ $option } hat keine Wirkung: kein Messprotokoll wird geschrieben oder angezeigt
cli-warning-more-figures = { $count } weitere solche Werte werden nicht angezeigt
cli-warning-tables-not-used = --tables, --source und Optionen der Norm werden nicht verwendet: ohne --fit werden keine Grenzmaße gesucht
cli-warning-empty-cell = { $class } über { $over } bis { $to } mm bleibt leer: ISO 286 hat keinen Wert, der für den ganzen Bereich gilt
cli-warning-budget-option = --{ $option } hat keine Wirkung: das Budget hängt nicht davon ab
cli-warning-contacts-left = der Zyklus hat { $used } von { $count } Antastpunkten verwendet
cli-warning-not-in-csv = CSV hat keinen Platz für { $options }: HTML, JSON und PDF schon
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } Hinweis steht nicht in der CSV: HTML und JSON enthalten ihn
   *[other] { $count } Hinweise stehen nicht in der CSV: HTML und JSON enthalten sie
}
cli-warning-no-tool-monitored = die Werkzeugtabelle wird nicht verwendet: Q330 nennt kein Werkzeug
cli-warning-log-unknown = kein Messprotokoll wird geschrieben: das von Zyklus { $code } ist nicht bekannt
cli-warning-limits-alone = hier entscheiden nur die Grenzmaße: Entscheidungsregel und Temperatur gelten nur für Durchmesser
cli-warning-log-off = kein Messprotokoll wird geschrieben: Q281 = 0
cli-warning-log-none = kein Messprotokoll wird geschrieben: der Zyklus hat keines
cli-warning-log-on-screen = kein Messprotokoll wird geschrieben: Q281 = 2 zeigt es am Bildschirm

# Tabellen gegen ISO 286
cli-verify-off = { $place }: { $class } über { $over } bis { $to } mm: { $table }, ISO 286 hat { $standard }: { $by }
cli-verify-missing = { $place }: { $class } über { $over } bis { $to } mm: kein Wert, ISO 286 hat { $standard }
cli-verify-undefined = { $place }: { $class } über { $over } bis { $to } mm: { $table }, aber { $reason }
cli-verify-neither = { $place }: { $class } über { $over } bis { $to } mm: { $reason }
cli-verify-by = { $side ->
        [upper] oberes
       *[lower] unteres
    } { $um } µm { $way ->
        [more] mehr
       *[less] weniger
    }
cli-verify-table = { $name }: { $classes ->
        [one] { $classes } Klasse
       *[other] { $classes } Klassen
    }, { $ranges ->
        [one] { $ranges } Nennmaßbereich
       *[other] { $ranges } Nennmaßbereiche
    }, { $cells ->
        [one] { $cells } Zelle
       *[other] { $cells } Zellen
    } verglichen: { $differ ->
        [0] alle stimmen mit ISO 286 überein
        [one] { $differ } weicht von ISO 286 ab
       *[other] { $differ } weichen von ISO 286 ab
    }
cli-verify-nothing = { $name }: { $classes ->
        [one] { $classes } Klasse
       *[other] { $classes } Klassen
    }, { $ranges ->
        [one] { $ranges } Nennmaßbereich
       *[other] { $ranges } Nennmaßbereiche
    }, { $cells } Zellen verglichen: nichts mit ISO 286 zu vergleichen
cli-verify-own = { $table }; nicht verglichen, keine Klassen nach ISO 286: { $own }

## Start
start-missing = Datei nicht vorhanden: { $path }; eine vorhandene Datei nennen, um sie im Fenster zu öffnen, oder einen Unterbefehl
start-folder = das ist ein Ordner, keine Datei: { $path }; im Fenster öffnen sich nur Dateien

## Was aufgezeichnet wurde
cli-recorded-entry = aufgezeichnet als Eintrag { $number } von { $file } (Hash { $hash })
cli-recorded-entries = aufgezeichnet als Einträge { $first } bis { $last } von { $file } (Hash des letzten { $hash })
cli-recorded-nothing = nichts wurde beurteilt, daher wurde nichts aufgezeichnet
cli-recorded-without = { $rows ->
    [one] 1 Zeile ist nicht aufgezeichnet
   *[other] { $rows } Zeilen sind nicht aufgezeichnet
}: { $places }
cli-not-recorded = nichts wurde aufgezeichnet: { $error }
cli-journal-is-server = dazu ist die Journaldatei einer Station nötig: ein Server erhält nur, was Stationen aufgezeichnet haben
cli-no-shop = dieses Programm wurde ohne Unterstützung für einen Werkstattserver gebaut: eine Datei als Journal nennen
cli-recorded-not-sent = noch nicht an den Server gesendet: { $error }; die Aufzeichnungen bleiben hier erhalten, und fitcheck journal send sendet sie
cli-no-journal-folder = dieses System hat keinen Ordner für eigene Daten: ein Journal mit --journal FILE nennen
cli-no-entry = in { $path } gibt es keinen Eintrag { $number }: der letzte ist { $last }
cli-no-check = Eintrag { $number } ist keine Prüfung
cli-no-hash = kein Eintrag in { $path } hat einen Hash, der mit { $prefix } beginnt
cli-several-hashes = die Hashes mehrerer Einträge beginnen mit { $prefix }: { $numbers }. Mehr Stellen oder die Nummer angeben
cli-record-needs-file = --record nennt die Datei, die geschrieben wurde, und die Standardausgabe ist keine: -o FILE angeben
cli-report-not-known = { $file } ist geschrieben, aber das Journal kennt die Datei nicht: { $error }
cli-already-corrected-by = Eintrag { $number } wurde schon durch Eintrag { $by } berichtigt oder zurückgenommen: jenen berichtigen, wenn er keine Rücknahme ist
cli-not-typed = der Wert von Eintrag { $number } wurde nicht eingegeben: neu messen oder die Prüfung zurücknehmen
cli-nothing-corrected = eine Berichtigung muss etwas ändern: --measured, --who, --part, --serial, --feature-name, --remark oder --withdraw angeben
cli-remark-sent = { $entries ->
    [0] nichts war zu senden
    [one] 1 Eintrag wurde gesendet
   *[other] { $entries } Einträge wurden gesendet
} an { $server }, der dieses Journal bis Eintrag { $number } hat
cli-remark-nothing-found = keine Prüfung passt zu { $question }
cli-remark-unread = { $entries ->
    [one] 1 Eintrag ist
   *[other] { $entries } Einträge sind
} übersprungen: diese Version kann { $entries ->
    [one] ihn
   *[other] sie
} nicht lesen
cli-head-without-chain = ein Server hat mehrere Ketten: --head CHAIN:NUMBER:HASH angeben
cli-head-of-other = dieses Journal ist die Kette { $chain }, --head nennt aber { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } Merkmal
   *[other] { $count } Merkmale
}
cli-remark-plan-example = keine Toleranzangabe genannt: der Plan hat ein Merkmal als Beispiel
cli-remark-plan-to-fill = der Plan ist geschrieben, soweit er bekannt ist; darin zu behebende Fehler: { $count }
cli-remark-no-columns = die Datei wird nach ihrem eigenen Format gelesen und hat keine Spalten zu wählen
cli-remark-plan-head-left = CSV enthält nur die Merkmale: { $keys } des Teils wird nicht geschrieben
cli-warning-neither-stands = Eintrag { $number } berichtigte Eintrag { $target }: jetzt zählt keiner von beiden. Ist einer der Werte richtig, ihn noch einmal aufzeichnen
cli-warning-beyond-limits = außerhalb der Grenzmaße: nach der Regel angenommen, da nicht nachgewiesen ist, dass der Wert außerhalb liegt
cli-warning-plan-missing = nicht gemessen: { $names }
cli-warning-plan-missing-of = { $who }: nicht gemessen: { $names }
cli-warning-contradiction = { $name } hat Werte, die einander widersprechen: { $values }
cli-warning-contradiction-of = { $who }: { $name } hat Werte, die einander widersprechen: { $values }
cli-warning-worst-counts = von mehreren einander widersprechenden Werten zählt der schlechteste, bis gewählt wird: --repeats last oder --repeats worst. Seriennummern unterscheiden Teile, und eine Zeit bei jedem Wert zeigt, welcher der letzte ist
cli-warning-plan-more-parts = mehr als { $most } Teile: fehlende Merkmale der übrigen werden nicht gemeldet
cli-warning-plan-no-value = fehlt: kein Wert gefunden
cli-warning-plan-no-value-of = fehlt bei { $who }: kein Wert gefunden
cli-remark-watching = { $folder } wird überwacht; früher importierte Dateien: { $known }
cli-warning-see-note = nicht alles war verwendbar: die Datei daneben mit der Endung { $note } nennt die Gründe
cli-not-seconds = { $given } ist keine Zeit in Sekunden
cli-warning-same-content = derselbe Inhalt wurde früher als { $known } importiert: nichts wird noch einmal aufgezeichnet
cli-warning-not-alone = nicht feststellbar, ob ein anderes Programm diesen Ordner für dasselbe Journal überwacht: { $reason }

## Die Zeitzone dieses Computers
zone-not-understood = TZ steht auf "{ $given }", und das ist keine Zeitzone: auf einen Namen wie Europe/Amsterdam oder auf UTC setzen, oder entfernen
zone-unknown = die Zeitzone dieses Computers ist nicht bekannt, daher stehen Zeiten in UTC: TZ auf einen Namen wie Europe/Amsterdam setzen

# Was um das Programm ist
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, es ist { $time }
doctor-clock = nicht vor dem neuesten Eintrag des Journals
doctor-clock-behind = vor dem neuesten Eintrag von { $path }, geschrieben um { $newest }: Uhr dieses Rechners stellen
doctor-folder = { $path }: Dateien können geschrieben werden
doctor-journal = { $path }: Einträge { $entries }
doctor-no-journal = { $path } gibt es noch nicht: die erste aufgezeichnete Prüfung legt es an
doctor-server = { $address } antwortet
doctor-no-server = kein Server eingestellt: mit --journal postgres://… nennen, oder im Fenster unter Einstellungen
doctor-gauges = Anschlüsse dieses Rechners: { $ports }
doctor-no-port = dieser Rechner hat keinen seriellen Anschluss: Messmittel oder dessen Kabel einstecken
doctor-gauge-gone = { $gauge }: Anschluss { $port } fehlt: Messmittel einstecken oder im Fenster unter Einstellungen einen anderen Anschluss wählen
doctor-no-gauges = dieses Programm wurde ohne Anschlüsse für Messmittel gebaut: die Pakete haben sie
doctor-ports-not-listed = die Anschlüsse dieses Rechners lassen sich nicht auflisten: { $reason }
doctor-tables = { $path }: Tabellen { $count }
doctor-no-tables = keine eigenen Tabellen: ISO 286 und die Tabellen der Steuerung sind eingebaut
doctor-settings = was das Fenster aufbewahrt, ist lesbar
doctor-window = gezeichnet mit { $renderer }
doctor-no-window = dieses Programm wurde ohne das Fenster gebaut
