# budget

budget-toml = { $said }
budget-too-large = plik budżetu ma najwyżej { $most } KiB
budget-not-one = budżet wymaga albo tabel [[contribution]], albo jednej tabeli [calibrated]
budget-too-many = za dużo składowych, { $count }: budżet ma najwyżej { $most }
budget-empty = { $key } jest puste: oczekiwany tekst
budget-day = { $key }: { $given } nie jest dniem: oczekiwane YYYY-MM-DD
budget-days = valid_until { $until } jest przed date { $date }
budget-key = { $table }: { $key } nie jest tu używany: dozwolone klucze to { $allowed }
budget-missing = { $table }: brakuje { $keys }
budget-range = { $table }: { $key } to { $given }: oczekiwane od { $least } do { $most }
budget-resolution-law = { $table }: rozdzielczość ma rozkład prostokątny: oczekiwane law = "rectangular" lub bez law
budget-geometry = { $table }: { $error }
budget-length = { $key }: { $error }
budget-geometry-touches = punkty pomiarowe { $touches }: oczekiwane od 3 do { $most }
budget-geometry-step = punkty pomiarowe { $touches } co { $step } stopni: oczekiwany krok od 0,01 do { $most } stopni
budget-evaluation-no-size = { $contribution } zależy od wymiaru, ale wymiaru nie podano
budget-evaluation-no-contacts = { $contribution } zależy od punktów pomiarowych, ale budżet nie ma touches i step_deg, a punktów nie podano
budget-evaluation-nothing = każda składowa jest zerowa
budget-calibrated-too-few = { $readings ->
        [one] jeden odczyt
        [few] { $readings } odczyty
        [many] { $readings } odczytów
       *[other] { $readings } odczytów
    }: potrzebne są co najmniej 2
budget-calibrated-far-away = średnia z odczytów, { $mean } mm, różni się o ponad 1 mm od wymiaru wzorcowanego, { $size } mm
budget-calibrated-nothing = każda niepewność jest zerowa

budget-warning-expired = budżet wygasł: był ważny do { $until }
budget-warning-not-yet = budżet nie jest jeszcze ważny: jego data to { $date }
budget-warning-of-template = budżet ma nadal nazwę, autora lub liczby z szablonu: nie mówią one nic o tym stanowisku
budget-warning-failed-study = badanie mówi o tym przyrządzie: { $why }
budget-warning-template-figures = te składowe mają nadal liczby z szablonu: { $contributions }. Sprawdzić, czy są prawdziwe dla tego stanowiska
budget-warning-few-readings = odczyty przedmiotu wzorcowanego: { $readings }; ISO 15530-3 wymaga co najmniej { $fewest }
budget-warning-bias-corrected = błąd systematyczny { $bias } µm: niepewność dotyczy wartości, od których go odjęto; Fitcheck go nie odejmuje
budget-warning-bias-not-corrected = błąd systematyczny { $bias } µm: nie jest korygowany, więc niepewność go obejmuje
budget-warning-other-size = przedmiot wzorcowany w budżecie ma { $calibrated } mm, a zmierzono { $measured } mm: niepewność dotyczy części podobnych do tego przedmiotu
budget-warning-other-side = przedmiot wzorcowany w budżecie to { $calibrated ->
    [hole] otwór, a zmierzono wałek
   *[shaft] wałek, a zmierzono otwór
    }
budget-warning-other-expansion = { $contribution } w budżecie ma rozszerzalność { $budget } · 10⁻⁶/K, a wartość skorygowano z { $given }
budget-warning-other-temperature = { $contribution } w budżecie dotyczy temperatury różnej od 20 °C o { $budget } K, a wartość skorygowano dla { $given } K
budget-warning-recorded = { $text }
