# budget

budget-toml = { $said }
budget-too-large = een budgetbestand heeft hoogstens { $most } KiB
budget-not-one = een budget heeft ofwel tabellen [[contribution]] ofwel één tabel [calibrated] nodig
budget-too-many = { $count } bijdragen: een budget heeft er hoogstens { $most }
budget-empty = { $key } is leeg: een tekst verwacht
budget-day = { $key }: { $given } is geen dag: JJJJ-MM-DD verwacht
budget-days = valid_until { $until } ligt vóór date { $date }
budget-key = { $table }: { $key } wordt hier niet gebruikt: toegestaan zijn { $allowed }
budget-missing = { $table }: { $keys } ontbreekt
budget-range = { $table }: { $key } is { $given }: { $least } tot { $most } verwacht
budget-resolution-law = { $table }: een resolutie is rechthoekig verdeeld: law = "rectangular" of geen law verwacht
budget-geometry = { $table }: { $error }
budget-length = { $key }: { $error }
budget-geometry-touches = { $touches } meetpunten: 3 tot { $most } verwacht
budget-geometry-step = { $touches } meetpunten om de { $step } graden: een stap van 0.01 tot { $most } graden verwacht
budget-evaluation-no-size = { $contribution } hangt af van de maat, maar er is geen maat gegeven
budget-evaluation-no-contacts = { $contribution } hangt af van de meetpunten, maar het budget heeft geen touches en step_deg, en er zijn geen meetpunten gegeven
budget-evaluation-nothing = elke bijdrage is nul
budget-calibrated-too-few = { $readings ->
        [one] één aflezing
       *[other] { $readings } aflezingen
    }: minstens 2 nodig
budget-calibrated-far-away = het gemiddelde van de aflezingen, { $mean } mm, ligt meer dan 1 mm van de gekalibreerde maat, { $size } mm
budget-calibrated-nothing = elke onzekerheid is nul

budget-warning-expired = het budget is verlopen: het was geldig tot en met { $until }
budget-warning-not-yet = het budget is nog niet geldig: zijn datum is { $date }
budget-warning-of-template = in het budget staan nog gegevens van het sjabloon in plaats van de naam, de opsteller of de getallen: ze zeggen niets over dit station
budget-warning-failed-study = een studie zegt over dit meetmiddel: { $why }
budget-warning-template-figures = deze bijdragen hebben nog de getallen van het sjabloon: { $contributions }. Controleer of die voor dit station kloppen
budget-warning-few-readings = { $readings } aflezingen van het gekalibreerde werkstuk: ISO 15530-3 vraagt er minstens { $fewest }
budget-warning-bias-corrected = afwijking { $bias } µm: de onzekerheid geldt voor waarden waarvan de afwijking is afgetrokken; Fitcheck trekt die niet af
budget-warning-bias-not-corrected = afwijking { $bias } µm: niet gecorrigeerd, dus de onzekerheid bevat die
budget-warning-other-size = het gekalibreerde werkstuk van het budget is { $calibrated } mm, maar er is { $measured } mm gemeten: de onzekerheid geldt voor onderdelen zoals dat werkstuk
budget-warning-other-side = het gekalibreerde werkstuk van het budget is een { $calibrated ->
    [hole] boring, maar er is een as gemeten
   *[shaft] as, maar er is een boring gemeten
    }
budget-warning-other-expansion = { $contribution } van het budget heeft de uitzetting { $budget } · 10⁻⁶/K, maar de waarde is gecorrigeerd met { $given }
budget-warning-other-temperature = { $contribution } van het budget is voor een temperatuur { $budget } K van 20 °C, maar de waarde is gecorrigeerd voor { $given } K
budget-warning-recorded = { $text }
