page-statistics = Statistik

# Was gefragt ist
statistics-page-question = Einträge
statistics-page-question-hint = Die Einträge, deren Werte verwendet werden, in der Sprache der Seite Journal, etwa part:"Flansch 40" station:"Fräse 3" from:2026-11-01. Leer: alle Einträge.
statistics-page-last = Neueste Werte
statistics-page-size = Werte je Punkt
statistics-page-part = Teil
statistics-page-all-parts = Alle Teile
statistics-page-read-again = Neu lesen
statistics-page-range = muss eine ganze Zahl von { $least } bis { $most } sein
statistics-page-reading = Werte werden gelesen…
statistics-page-off = Es wird nichts aufgezeichnet. Statistik entsteht aus den Werten im Journal.
statistics-page-none = Kein Eintrag mit einem Messwert passt zu dieser Frage.
statistics-page-not-read = Die Werte können nicht gelesen werden: { $why }

# Was gelesen wurde
statistics-page-values = { $count ->
        [one] 1 Wert
       *[other] { $count } Werte
    }
statistics-page-groups = { $count ->
        [one] 1 Gruppe
       *[other] { $count } Gruppen
    } zu { $size }
statistics-page-out = { $count } ausgelassen: { $why ->
        [simulated] simuliert
        [invalid] ungültig
        [doubtful] zweifelhaft
        [withdrawn] korrigiert oder zurückgezogen
       *[user] mit Begründung
    }
statistics-page-newest = Die neuesten { $count } Einträge wurden gelesen. Ältere sind nicht enthalten.
statistics-page-unread = { $count ->
        [one] 1 Eintrag kann nicht gelesen werden.
       *[other] { $count } Einträge können nicht gelesen werden.
    }

# Merkmale
statistics-page-features = Merkmale
statistics-page-features-head = Ppk, Marke bei { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 Wert
       *[other] { $count } Werte
    }, Ppk { $ppk }
statistics-page-below = { $count } von { $all } unter { $asked }
statistics-page-move-feature = Ein anderes Merkmal

# Kennwerte
statistics-page-figures = Kennwerte
statistics-page-figure-mean = Mittelwert
statistics-page-figure-deviation = Standardabweichung
statistics-page-figure-cp = Cp kurzzeitig
statistics-page-figure-cpk = Cpk kurzzeitig
statistics-page-figure-pp = Pp gesamt
statistics-page-figure-ppk = Ppk gesamt
statistics-page-figure-outside = Außerhalb der Grenzwerte
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = von { $count }
statistics-page-expected = erwartet { $ppm } von einer Million
statistics-page-proven = Ppk von { $asked } ist nachgewiesen: die untere Vertrauensgrenze ist { $lower }.
statistics-page-not-proven = Ppk von { $asked } ist nicht nachgewiesen: die untere Vertrauensgrenze ist { $lower }.
statistics-page-no-ppk = Ppk von { $asked } ist nicht nachgewiesen: { $why }.

# Die Karte
statistics-page-single = Einzelwerte
statistics-page-means = Mittelwerte aus { $size }
statistics-page-histogram = Histogramm
statistics-page-spread = Streuung
statistics-page-probability = Wahrscheinlichkeitsnetz
statistics-page-no-chart = Keine Eingriffsgrenzen: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 Punkt
       *[other] { $count } Punkte
    }, Mittellinie { $centre }, Eingriffsgrenzen { $lower } … { $upper }, Grenzwerte { $minimum } … { $maximum }, { $signals ->
        [one] 1 Signal
       *[other] { $signals } Signale
    }, { $outside } außerhalb der Grenzwerte.
statistics-page-said-mean-mm = Mittelwert
statistics-page-said-sd-mm = Standardabweichung
statistics-page-said-spread-centre-mm = mittlere Streuung
statistics-page-said-spread-upper-mm = obere Eingriffsgrenze der Streuung
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Ein anderer Punkt
statistics-page-open = Eintrag öffnen
statistics-page-zoom-in = Weniger Punkte
statistics-page-zoom-out = Mehr Punkte
statistics-page-zoom-whole = Alle Punkte
statistics-page-freeze = Grenzen aus den Punkten bis hier
statistics-page-unfreeze = Grenzen aus allen Punkten
statistics-page-freeze-hint = Spätere Punkte verschieben die Eingriffsgrenzen nicht.
statistics-page-leave-out = Auslassen…
statistics-page-leave-out-hint = Der Punkt bleibt mit seiner Begründung in der Karte. Für Grenzen, Regeln und Kennwerte zählt er nicht.
statistics-page-take-in = Wieder einbeziehen
statistics-page-reason = Begründung
statistics-page-take-reason = Auslassen
statistics-page-cancel-reason = Abbrechen
statistics-page-copy = Kennwerte kopieren
statistics-page-copy-hint = Kennwerte, Signale und Rat als Tabelle für eine Tabellenkalkulation
statistics-page-report = Bericht…
statistics-page-report-hint = Kennwerte und Diagramme aller Merkmale als Bericht zum Unterschreiben

# Signale
statistics-page-signals = Signale
statistics-page-no-signals = Keine Regel spricht an.
statistics-page-rules = Regeln
statistics-page-on-spread = Streuung: { $rule }
statistics-page-alarms = Offene Alarme: { $count }
statistics-page-at = Punkt { $point }
statistics-page-from-to = Punkte { $first } bis { $last }
statistics-page-left-out-because = Ausgelassen: { $reason }
statistics-page-advice = Rat
