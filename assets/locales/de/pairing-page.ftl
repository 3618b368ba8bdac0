page-pairing = Paarung

# Was gefragt ist
pairing-page-wanted = Gewünschtes Spiel oder Passung
pairing-page-wanted-hint = Kleinstes und größtes in mm, wie 0.010..0.030, oder eine Passung, wie 25 H7/g6. Negativ ist Übermaß.
pairing-page-wanted-range = Spiel { $minimum } … { $maximum } µm, Mitte { $middle } µm
pairing-page-wanted-fit = { $fit }: Spiel { $minimum } … { $maximum } µm, Mitte { $middle } µm
pairing-page-wanted-refused = { $reason }; zulässig sind eine Passung, wie 25 H7/g6, und zwei Werte für das Spiel in mm, wie 0.010..0.030
pairing-page-holes = Gemessene Bohrungen
pairing-page-shafts = Gemessene Wellen
pairing-page-no-parts = noch keine
pairing-page-reading = wird gelesen…
pairing-page-from-file = { $name }, { $count ->
        [one] 1 Teil
       *[other] { $count } Teile
    }
pairing-page-from-history = Aus dem Verlauf, { $count ->
        [one] 1 Teil
       *[other] { $count } Teile
    }
pairing-page-refused = { $count ->
        [one] 1 Zeile abgewiesen
       *[other] { $count } Zeilen abgewiesen
    }
pairing-page-all-refused = Alle { $count } abgewiesenen Zeilen
pairing-page-all-notes = Alle { $count } Warnungen
pairing-page-open-holes = Bohrungen öffnen…
pairing-page-open-shafts = Wellen öffnen…
pairing-page-history-holes = Bohrungen des Verlaufs
pairing-page-history-shafts = Wellen des Verlaufs
pairing-page-history-hint = Verwendet die ausgewählten Prüfungen oder alle angezeigten, wenn keine ausgewählt ist
pairing-page-groups = Gruppen
pairing-page-groups-hint = Anzahl gleich breiter Gruppen, in die die Teile auch sortiert werden. Leer für keine.
pairing-page-do-wanted = Gewünschtes Spiel oder eine Passung eingeben.
pairing-page-do-holes = Gemessene Bohrungen öffnen oder aus dem Verlauf nehmen.
pairing-page-do-shafts = Gemessene Wellen öffnen oder aus dem Verlauf nehmen.
pairing-page-about = Fitcheck bildet so viele Paare wie möglich innerhalb des gewünschten Spiels. Unter allen Möglichkeiten dazu nimmt es die mit der kleinsten Summe der quadrierten Abstände von der Mitte. Namen und gemessene Maße genügen. Dateien lassen sich auch hierher ziehen, die Bohrungen zuerst.
pairing-page-no-side = { $name } wird nicht geöffnet: Bohrungen und Wellen sind schon da. Als Bohrungen oder als Wellen öffnen.
pairing-page-none-in-history = Der Verlauf hat keine Prüfungen von { $feature ->
        [hole] Bohrungen
       *[shaft] Wellen
    }.
pairing-page-listed-only = Der Verlauf ist gefiltert: die { $feature ->
        [hole] Bohrungen
       *[shaft] Wellen
    } kommen aus den { $listed } angezeigten von { $all } Prüfungen
pairing-page-none-chosen = Keine der ausgewählten Prüfungen ist die einer { $feature ->
        [hole] Bohrung
       *[shaft] Welle
    }.
pairing-page-nothing-read = { $name } hat kein verwendbares Maß: { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }({ $count } Zeilen abgewiesen)
    }
pairing-page-nothing-to-save = keine Paare zu speichern

# Die Paare
pairing-page-pairs = Paare
pairing-page-hole = Bohrung
pairing-page-shaft = Welle
pairing-page-clearance = Spiel
pairing-page-from-middle = Von der Mitte
pairing-page-from-middle-head = Von Mitte
pairing-page-remark = Bemerkung
pairing-page-line = Textzeile { $line }
pairing-page-check = Prüfung { $line }
pairing-page-hole-simulated = Bohrung simuliert
pairing-page-shaft-simulated = Welle simuliert
pairing-page-both-simulated = beide simuliert
pairing-page-list = Paare aus Bohrungen und Wellen
pairing-page-row = { $hole } { $hole-mm } mm mit { $shaft } { $shaft-mm } mm, Spiel { $clearance } µm, { $middle } µm von der Mitte
pairing-page-move = Zu einem anderen Paar
pairing-page-copy = Paare kopieren

# Das Bild
pairing-page-picture = Teile nach Maß
pairing-page-legend = Ring: Bohrung. Scheibe: Welle, um die Mitte verschoben, { $middle } µm: ein Paar in der Mitte liegt waagrecht. Kreuz: Rest.
pairing-page-part-of = Links: alle Teile; der Rahmen zeigt die gezeichneten.
pairing-page-thinned = Zu dicht, um alle zu zeichnen: 1 von { $step } ist gezeichnet.
pairing-page-left-over = Rest
pairing-page-describe = { $holes ->
        [one] 1 Bohrung
       *[other] { $holes } Bohrungen
    } links, { $shafts ->
        [one] 1 Welle
       *[other] { $shafts } Wellen
    } rechts, auf einer gemeinsamen Maßskala; Wellen sind um { $middle } µm verschoben, sodass ein Paar in der Mitte des gewünschten Spiels waagrecht liegt. { $pairs ->
        [one] 1 Paar ist als Linie gezeichnet.
       *[other] { $pairs } Paare sind als Linien gezeichnet.
    }
pairing-page-describe-part = { $pairs ->
        [one] 1 Paar ist sichtbar.
       *[other] { $pairs } Paare sind sichtbar.
    }
pairing-page-describe-selected = Ausgewählt: { $hole } mit { $shaft }, Spiel { $clearance } µm.

# Die Antwort
pairing-page-count = { $count ->
        [one] 1 Paar
       *[other] { $count } Paare
    }
pairing-page-none = Noch keine Antwort
pairing-page-at-work = Paarung läuft…
pairing-page-nothing-left = kein Rest
pairing-page-left = Rest: { $holes ->
        [one] 1 Bohrung
       *[other] { $holes } Bohrungen
    }, { $shafts ->
        [one] 1 Welle
       *[other] { $shafts } Wellen
    }
pairing-page-simulated = { $count ->
        [one] 1 Paar mit einem simulierten Teil
       *[other] { $count } Paare mit einem simulierten Teil
    }
pairing-page-no-pair = Keine Bohrung und Welle haben ein Spiel im gewünschten Bereich.
pairing-page-smallest = Kleinstes Spiel
pairing-page-largest = Größtes Spiel
pairing-page-middle = Gewünschte Mitte
pairing-page-band = Band darum
pairing-page-grinding = Schleifen
pairing-page-grind = { $amount } µm von den übrigen Wellen ab oder aus den übrigen Bohrungen heraus: { $count ->
        [one] 1 Paar mehr
       *[other] { $count } Paare mehr
    }
pairing-page-grind-means = Der kleinste Betrag, in Schritten von 1 µm, der die meisten zusätzlichen Paare ergibt. Vorhandene Paare bleiben.
pairing-page-grind-nothing = Kein Betrag ergibt ein weiteres Paar.
pairing-page-grind-bounded = Beträge bis { $tried } µm wurden versucht; die entferntesten Teile bräuchten { $reach } µm.
pairing-page-groups-title = Gruppen
pairing-page-group = Gruppe { $number }: { $count ->
        [one] 1 Paar
       *[other] { $count } Paare
    }
pairing-page-all-within = ✓ alle innerhalb
pairing-page-not-all-within = ✗ nicht alle innerhalb
pairing-page-no-group-pairs = eine Seite ist leer
pairing-page-group-holes = { $count ->
        [one] 1 Bohrung
       *[other] { $count } Bohrungen
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] 1 Welle
       *[other] { $count } Wellen
    } { $from } … { $to } mm
pairing-page-group-clearance = Spiel { $range }
pairing-page-outside-groups = In keiner Gruppe, außerhalb der Toleranzfelder: { $holes ->
        [one] 1 Bohrung
       *[other] { $holes } Bohrungen
    }, { $shafts ->
        [one] 1 Welle
       *[other] { $shafts } Wellen
    }

# Dateien
pairing-page-save-csv = Als CSV speichern…
pairing-page-save-json = Als JSON speichern…
pairing-page-file-name = paare
pairing-page-dialog-holes = Gemessene Bohrungen öffnen
pairing-page-dialog-shafts = Gemessene Wellen öffnen
pairing-page-dialog-save = Paare speichern
file-kind-holes = Gemessene Bohrungen
file-kind-shafts = Gemessene Wellen
file-kind-pairs = Paare
