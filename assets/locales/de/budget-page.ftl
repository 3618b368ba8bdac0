page-budget = Unsicherheit
page-budget-also = Budget

budget-page-text = Budget als TOML
budget-page-none = Ein neues Budget anlegen oder eines öffnen
budget-page-new = Neues Budget
budget-page-open = Budget öffnen…
budget-page-save = Budget speichern unter…
budget-page-dialog-open = Budget öffnen
budget-page-dialog-save = Budget speichern
budget-page-dialog-readings = Einzelmesswerte des kalibrierten Werkstücks
budget-page-not-saved = { $name }, nicht gespeichert

budget-page-for = Berechnet für
budget-page-size = Gemessenes Maß
budget-page-contacts = Antastpunkte
budget-page-touches = Anzahl Antastpunkte
budget-page-step = Schritt
budget-page-contacts-hint = Leer: die Antastpunkte des Budgets
budget-page-day = Tag
budget-page-day-hint = Tag leer: heute, { $day }
budget-page-no-day = { $given } ist kein Tag: JJJJ-MM-TT erwartet
budget-page-other-missing = Fehlt: sowohl Anzahl der Antastpunkte als auch Schritt angeben, oder keines von beiden
budget-page-take-check = Aus der angezeigten Prüfung
budget-page-take-recorded = Erfasste Antastpunkte
budget-page-own-contacts = Aus dem Budget
budget-page-of-check = { $count } Antastpunkte der Prüfung { $what }, { $time }
budget-page-of-simulated-check = { $count } Antastpunkte der Prüfung { $what }, { $time }, simuliert
budget-page-of-recorded = { $count } erfasste Antastpunkte aus { $name }
budget-page-contacts-used = { $count } Antastpunkte, Faktor { $factor }
budget-page-contacts-stepped = { $count } Antastpunkte alle { $step }°, Faktor { $factor }
budget-page-no-circle = Die Antastpunkte werden nicht verwendet: { $problem }

budget-page-readings = Einzelmesswerte
budget-page-open-readings = Aus Datei…
budget-page-take-readings = Aus dem Verlauf
budget-page-own-readings = Aus dem Budget
budget-page-readings-own = { $count ->
        [one] ein Einzelmesswert im Budget
       *[other] { $count } Einzelmesswerte im Budget
    }
budget-page-readings-of-file = { $count ->
        [one] ein Einzelmesswert aus { $name }
       *[other] { $count } Einzelmesswerte aus { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] ein Einzelmesswert: die Prüfung des Verlaufs
       *[other] { $count } Einzelmesswerte: alle Prüfungen des Verlaufs
    }
budget-page-readings-of-chosen = { $count ->
        [one] ein Einzelmesswert: die ausgewählte Prüfung des Verlaufs
       *[other] { $count } Einzelmesswerte: die ausgewählten Prüfungen des Verlaufs
    }
budget-page-readings-are-shafts = { $count ->
        [one] eine Prüfung einer Welle wird
       *[other] { $count } Prüfungen von Wellen werden
    } nicht verwendet: das Werkstück ist eine Bohrung
budget-page-readings-are-holes = { $count ->
        [one] eine Prüfung einer Bohrung wird
       *[other] { $count } Prüfungen von Bohrungen werden
    } nicht verwendet: das Werkstück ist eine Welle
budget-page-readings-simulated = { $count ->
        [one] ein Einzelmesswert ist
       *[other] { $count } Einzelmesswerte sind
    } simuliert: nichts wurde gemessen
budget-page-more-notes = { $count ->
        [one] und ein weiterer Hinweis
       *[other] und { $count } weitere Hinweise
    }

budget-page-answer = Erweiterte Unsicherheit
budget-page-no-answer = Keine Antwort
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } für 95,45 %
budget-page-at-size = Für { $size } mm; jede Prüfung erhält die Unsicherheit ihres eigenen Maßes
budget-page-covered-by = k = { $k } nach { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Effektive Freiheitsgrade { $degrees }
budget-page-infinite = unendlich
budget-page-valid = Gültig bis { $until }
budget-page-expired = ABGELAUFEN
budget-page-expired-on = gültig bis { $until }, am { $day }
budget-page-not-yet = NOCH NICHT GÜLTIG
budget-page-not-yet-on = gültig ab { $date }
budget-page-made = Erstellt { $date } von { $by }
budget-page-method = Methode { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Größter Beitrag
budget-page-largest-is = { $name }, { $percent } % der Varianz
budget-page-help = Was am meisten helfen würde
budget-page-help-halved = Halbiert: u = { $u } µm
budget-page-help-part-temperature = Unsicherheit der Teiletemperatur halbiert: u = { $u } µm
budget-page-help-scale-temperature = Unsicherheit der Temperatur der Maßstäbe halbiert: u = { $u } µm
budget-page-help-expansion = Abstand zu 20 °C halbiert oder Unsicherheit der Ausdehnung halbiert: u = { $u } µm
budget-page-help-full-circle = { $count } Antastpunkte gleichmäßig rund um den ganzen Kreis: u = { $u } µm
budget-page-help-more-touches = { $count } Antastpunkte gleichmäßig rund um den ganzen Kreis: u = { $u } µm

budget-page-checks = Prüfungen
budget-page-use = Für Prüfungen verwenden
budget-page-leave = Nicht mehr verwenden
budget-page-uses-none = Prüfungen verwenden kein Budget
budget-page-uses-this = In Verwendung: { $name }
budget-page-uses-another = In Verwendung: { $name } aus { $file }, abweichend von dem, was hier steht
budget-page-uses-typed = „{ $name }“ gilt nicht: Prüfungen verwenden die Unsicherheit, die auf der Seite Prüfung gewählt ist
budget-page-uses-no-rule = „{ $name }“ ist gewählt, aber auf der Seite Prüfung verwendet noch keine Regel eine Unsicherheit: dort die Regel wählen
budget-page-used-before = Bisher verwendeten Prüfungen die eingegebene Unsicherheit ({ $uncertainty }). „Nicht mehr verwenden“ stellt sie wieder her
budget-page-used = Prüfungen verwenden das Budget { $name }
budget-page-used-no-rule = „{ $name }“ ändert noch kein Urteil: die Regel auf der Seite Prüfung ist „{ $rule }“, die keine Unsicherheit verwendet. Eine andere Regel wählen
budget-page-not-kept = Das Budget speichern, um es nach einem Neustart weiter zu verwenden
budget-page-readings-not-kept = Die Einzelmesswerte stehen nicht in der Budgetdatei: nach einem Neustart wird das Budget nicht mehr verwendet
budget-page-used-unread = { $path }: das für Prüfungen verwendete Budget kann nicht gelesen werden, daher verwenden Prüfungen kein Budget: { $problem }

budget-page-table = Beiträge
budget-page-column-name = Name
budget-page-column-type = Typ
budget-page-column-law = Verteilung
budget-page-column-sensitivity = c
budget-page-column-share = Anteil
budget-page-row = { $name }, Typ { $type }, { $law }, u { $u } { $unit }, Empfindlichkeit { $sensitivity }, Beitrag { $um } µm, Anteil { $percent } %, Freiheitsgrade { $degrees }
budget-page-law-normal = normal
budget-page-law-rectangular = rechteckig
budget-page-law-u-shaped = U-förmig
budget-page-law-triangular = dreieckig
budget-page-shares = Anteile an der Varianz
budget-page-terms = Terme und erweiterte Unsicherheit
budget-page-mean = Mittelwert der Einzelmesswerte { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, korrigiert
budget-page-edition-2004 = U, 2004, nicht korrigiert
budget-page-nothing-seen = Tabelle und Anteile erscheinen, sobald das Budget berechnet werden kann
budget-page-named = { $name }
budget-page-placeholders = Prüfungen können dieses Budget noch nicht verwenden. Diese Angaben stammen noch aus der Vorlage: { $what }. Eigene Angaben in ihre Felder eingeben
budget-page-placeholder-name = der Name („{ $name }“)
budget-page-placeholder-by = wer es erstellt hat („{ $by }“)
budget-page-placeholder-figures = die Zahlen aller Beiträge

## Das Budget als Tabelle

budget-show-table = Tabelle
budget-show-text = Text
budget-rows = Beiträge
budget-head-name = Name des Budgets
budget-head-by = Erstellt von
budget-row-new = Neuer Beitrag
budget-row-add = Beitrag hinzufügen
budget-row-remove = Beitrag entfernen
budget-row-removed = Beitrag „{ $name }“ aus dem Budget entfernt
budget-row-comments-removed = Kommentare bei den entfernten Schlüsseln sind entfallen
budget-row-said = { $value } { $unit }, Divisor { $divisor }, { $law }
budget-row-unread = nicht vollständig
budget-row-name = Name
budget-row-k = Erweiterungsfaktor k
budget-row-alpha = Ausdehnung, 1/K
budget-row-delta = Abstand zu 20 °C
budget-row-touches = Eigene Antastpunkte
budget-row-step = Eigener Schritt
budget-row-sensitivity = Empfindlichkeit c
budget-row-freedom = Freiheitsgrade
budget-row-freedom-a = Freiheitsgrade, n − 1 von n Einzelmesswerten
budget-row-kind = Wirkt auf
budget-row-type = Typ
budget-row-law = Verteilung
budget-row-given = Angegeben als
budget-row-half-width = Halbweite
budget-row-resolution = Ziffernschritt
budget-given-standard = Standardunsicherheit
budget-given-expanded = Erweiterte Unsicherheit
budget-type-a = A, Statistik
budget-type-b = B, sonstiges
budget-kind-plain = Durchmesser
budget-kind-scatter = Streuung je Antastung
budget-kind-part-temperature = Temperatur des Teils
budget-kind-scale-temperature = Temperatur der Maßstäbe
budget-kind-part-expansion = Ausdehnung des Teils
budget-kind-scale-expansion = Ausdehnung der Maßstäbe
budget-kind-resolution = Auflösung
budget-table-stale = Der Text hat einen Fehler: die Tabelle zeigt die Beiträge, wie sie zuletzt waren
budget-table-other = Der Text schreibt die Beiträge so, dass die Tabelle sie nicht ändern kann. Den Text bearbeiten
budget-table-calibrated = Dieses Budget gehört zu einem kalibrierten Werkstück und hat keine Beiträge. Den Text bearbeiten
budget-law-normal = Normalverteilung
budget-law-rectangular = Rechteckverteilung
budget-law-u-shaped = U-förmige Verteilung
budget-law-triangular = Dreieckverteilung
