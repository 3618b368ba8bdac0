# budget

budget-toml = { $said }
budget-too-large = eine Budgetdatei hat höchstens { $most } KiB
budget-not-one = ein Budget braucht entweder Tabellen [[contribution]] oder eine Tabelle [calibrated]
budget-too-many = { $count } Beiträge: ein Budget hat höchstens { $most }
budget-empty = { $key } ist leer: ein Text erwartet
budget-day = { $key }: { $given } ist kein Tag: JJJJ-MM-TT erwartet
budget-days = valid_until { $until } liegt vor date { $date }
budget-key = { $table }: { $key } wird hier nicht verwendet: zulässig sind { $allowed }
budget-missing = { $table }: { $keys } fehlt
budget-range = { $table }: { $key } ist { $given }: { $least } bis { $most } erwartet
budget-resolution-law = { $table }: eine Auflösung ist rechteckig verteilt: law = "rectangular" oder kein law erwartet
budget-geometry = { $table }: { $error }
budget-length = { $key }: { $error }
budget-geometry-touches = { $touches } Antastpunkte: 3 bis { $most } erwartet
budget-geometry-step = { $touches } Antastpunkte alle { $step } Grad: ein Schritt von 0.01 bis { $most } Grad erwartet
budget-evaluation-no-size = { $contribution } hängt vom Maß ab, aber kein Maß ist angegeben
budget-evaluation-no-contacts = { $contribution } hängt von den Antastpunkten ab, aber das Budget hat kein touches und step_deg, und keine Antastpunkte sind angegeben
budget-evaluation-nothing = jeder Beitrag ist null
budget-calibrated-too-few = { $readings ->
        [one] ein Einzelmesswert
       *[other] { $readings } Einzelmesswerte
    }: mindestens 2 sind nötig
budget-calibrated-far-away = der Mittelwert der Einzelmesswerte, { $mean } mm, liegt mehr als 1 mm vom kalibrierten Maß, { $size } mm
budget-calibrated-nothing = jede Unsicherheit ist null

budget-warning-expired = das Budget ist abgelaufen: es war gültig bis { $until }
budget-warning-not-yet = das Budget ist noch nicht gültig: sein Datum ist { $date }
budget-warning-of-template = das Budget hat bei Name, Ersteller oder Zahlen noch Angaben aus der Vorlage: sie sagen nichts über diese Station
budget-warning-failed-study = eine Studie sagt über dieses Messmittel: { $why }
budget-warning-template-figures = diese Beiträge haben noch die Zahlen der Vorlage: { $contributions }. Prüfen, ob sie für diese Station zutreffen
budget-warning-few-readings = { $readings } Einzelmesswerte des kalibrierten Werkstücks: ISO 15530-3 verlangt mindestens { $fewest }
budget-warning-bias-corrected = systematische Abweichung { $bias } µm: die Unsicherheit gilt für Werte, von denen sie abgezogen wurde; Fitcheck zieht sie nicht ab
budget-warning-bias-not-corrected = systematische Abweichung { $bias } µm: sie ist nicht korrigiert, daher enthält die Unsicherheit sie
budget-warning-other-size = das kalibrierte Werkstück des Budgets hat { $calibrated } mm, gemessen wurden { $measured } mm: die Unsicherheit gilt für Teile wie dieses Werkstück
budget-warning-other-side = das kalibrierte Werkstück des Budgets ist eine { $calibrated ->
    [hole] Bohrung, gemessen wurde aber eine Welle
   *[shaft] Welle, gemessen wurde aber eine Bohrung
    }
budget-warning-other-expansion = { $contribution } des Budgets hat die Ausdehnung { $budget } · 10⁻⁶/K, der Wert wurde aber mit { $given } korrigiert
budget-warning-other-temperature = { $contribution } des Budgets gilt für eine Temperatur { $budget } K von 20 °C, der Wert wurde aber für { $given } K korrigiert
budget-warning-recorded = { $text }
