page-statistics = Statystyka

# O co chodzi w pytaniu
statistics-page-question = Zapisy
statistics-page-question-hint = Zapisy, których wartości są używane, w języku strony Zapisy, na przykład part:"Kołnierz 40" station:"Frezarka 3" from:2026-11-01. Puste pole: wszystkie zapisy.
statistics-page-last = Najnowsze wartości
statistics-page-size = Wartości na punkt
statistics-page-pause = Przerwa w minutach
statistics-page-mean-of = Średnia z
statistics-page-mean-count = tylu wartości z rzędu
statistics-page-mean-pause = wartości bez przerwy
statistics-page-mean-part = wartości jednej części
statistics-page-mean-station = wartości jednego stanowiska
statistics-page-mean-person = wartości jednej osoby
statistics-page-part = Część
statistics-page-all-parts = Wszystkie części
statistics-page-read-again = Wczytaj ponownie
statistics-page-range = musi być liczbą całkowitą od { $least } do { $most }
statistics-page-reading = Wczytywanie wartości…
statistics-page-off = Nic nie jest rejestrowane. Statystyka powstaje z wartości w dzienniku.
statistics-page-none = Żaden zapis ze zmierzoną wartością nie odpowiada na to pytanie.
statistics-page-not-read = Nie można wczytać wartości: { $why }

# Co wczytano
statistics-page-values = { $count ->
        [one] 1 wartość
        [few] { $count } wartości
        [many] { $count } wartości
       *[other] { $count } wartości
    }
statistics-page-groups = { $count ->
        [one] 1 grupa
        [few] { $count } grupy
        [many] { $count } grup
       *[other] { $count } grupy
    } po { $size }
statistics-page-out = pominięto { $count }: { $why ->
        [simulated] symulowane
        [invalid] nieważne
        [doubtful] wątpliwe
        [withdrawn] poprawione lub wycofane
       *[user] z podaniem powodu
    }
statistics-page-newest = Wczytano najnowsze zapisy: { $count }. Starsze nie są uwzględnione.
statistics-page-unread = { $count ->
        [one] Nie można wczytać 1 zapisu.
        [few] Nie można wczytać { $count } zapisów.
        [many] Nie można wczytać { $count } zapisów.
       *[other] Nie można wczytać { $count } zapisu.
    }

# Cechy
statistics-page-features = Cechy
statistics-page-features-head = Ppk, znak przy { $asked }
statistics-page-feature-said = { $name }, { $count ->
        [one] 1 wartość
        [few] { $count } wartości
        [many] { $count } wartości
       *[other] { $count } wartości
    }, Ppk { $ppk }
statistics-page-below = { $count } z { $all } poniżej { $asked }
statistics-page-move-feature = Inna cecha

# Wartości
statistics-page-figures = Wartości
statistics-page-figure-mean = Średnia
statistics-page-figure-deviation = Odchylenie standardowe
statistics-page-figure-cp = Cp krótkoterminowe
statistics-page-figure-cpk = Cpk krótkoterminowe
statistics-page-figure-pp = Pp ogółem
statistics-page-figure-ppk = Ppk ogółem
statistics-page-figure-outside = Poza granicami
statistics-page-interval = 95 %: { $lower } … { $upper }
statistics-page-of = z { $count }
statistics-page-expected = oczekiwane { $ppm } na milion
statistics-page-proven = Ppk { $asked } jest wykazane: jego dolna granica to { $lower }.
statistics-page-not-proven = Ppk { $asked } nie jest wykazane: jego dolna granica to { $lower }.
statistics-page-no-ppk = Ppk { $asked } nie jest wykazane: { $why }.

# Karta
statistics-page-single = Pojedyncze wartości
statistics-page-means = Średnie z { $size }
statistics-page-means-of-groups = Średnie grup
statistics-page-ewma = EWMA
statistics-page-cusum = CUSUM
statistics-page-histogram = Histogram
statistics-page-spread = Rozrzut
statistics-page-probability = Wykres prawdopodobieństwa
statistics-page-no-chart = Brak granic kontrolnych: { $why }.
statistics-page-chart-said = { $count ->
        [one] 1 punkt
        [few] { $count } punkty
        [many] { $count } punktów
       *[other] { $count } punktu
    }, linia środkowa { $centre }, granice kontrolne { $lower } … { $upper }, granice { $minimum } … { $maximum }, { $signals ->
        [one] 1 sygnał
        [few] { $signals } sygnały
        [many] { $signals } sygnałów
       *[other] { $signals } sygnału
    }, poza granicami { $outside }.
statistics-page-said-mean-mm = średnia
statistics-page-said-sd-mm = odchylenie standardowe
statistics-page-said-spread-centre-mm = średni rozrzut
statistics-page-said-spread-upper-mm = górna granica kontrolna rozrzutu
statistics-page-said-ewma-mm = średnia ważona
statistics-page-said-ewma-lower-mm = dolna granica średniej
statistics-page-said-ewma-upper-mm = górna granica średniej
statistics-page-said-cusum-above-mm = suma powyżej średniej
statistics-page-said-cusum-below-mm = suma poniżej średniej
statistics-page-said-cusum-interval-mm = przedział decyzyjny
statistics-page-said-anderson-darling = Anderson-Darling
statistics-page-said-anderson-darling-p = p
statistics-page-move-point = Inny punkt
statistics-page-open = Otwórz zapis
statistics-page-zoom-in = Mniej punktów
statistics-page-zoom-out = Więcej punktów
statistics-page-zoom-whole = Wszystkie punkty
statistics-page-freeze = Granice z punktów do tego miejsca
statistics-page-unfreeze = Granice ze wszystkich punktów
statistics-page-freeze-hint = Późniejsze punkty nie przesuwają granic kontrolnych.
statistics-page-leave-out = Pomiń…
statistics-page-leave-out-hint = Punkt zostaje na karcie wraz z powodem. Nie liczy się do granic, reguł i wartości.
statistics-page-stage = Zacznij tu etap
statistics-page-no-stage = Usuń etap
statistics-page-stage-hint = Od tego punktu granice są liczone od nowa, na przykład po wymianie narzędzia. Wartości pochodzą z ostatniego etapu.
statistics-page-take-in = Uwzględnij ponownie
statistics-page-reason = Powód
statistics-page-take-reason = Pomiń
statistics-page-cancel-reason = Anuluj
statistics-page-copy = Kopiuj wartości
statistics-page-copy-hint = Wartości, sygnały i porady jako tabela do arkusza kalkulacyjnego
statistics-page-report = Raport…
statistics-page-report-hint = Wartości i wykresy wszystkich cech jako raport do podpisu
statistics-page-save-chart = Zapisz kartę…
statistics-page-save-chart-hint = Wszystkie karty cechy na jednym arkuszu, jako SVG lub PNG
statistics-page-dialog-chart = Zapisz kartę
statistics-page-chart-ending = Nazwa pliku musi kończyć się na .svg lub .png.

# Sygnały
statistics-page-signals = Sygnały
statistics-page-no-signals = Żadna reguła nie zadziałała.
statistics-page-rules = Reguły
statistics-page-alarms = Otwarte alarmy: { $count }
statistics-page-at = Punkt { $point }
statistics-page-from-to = Punkty od { $first } do { $last }
statistics-page-left-out-because = Pominięto: { $reason }
statistics-page-advice = Porady

# Badanie przyrządu
statistics-study = Badanie przyrządu
statistics-study-open = Otwórz odczyty…
statistics-study-open-hint = Plik z odczytami przyrządu w dowolnym formacie pomiarów
statistics-study-dialog = Otwórz odczyty przyrządu
statistics-study-readings = { $count ->
        [one] 1 odczyt
        [few] { $count } odczyty
        [many] { $count } odczytów
       *[other] { $count } odczytu
    }
statistics-study-opened = { $name }: { $count ->
        [one] 1 odczyt
        [few] { $count } odczyty
        [many] { $count } odczytów
       *[other] { $count } odczytu
    }
statistics-study-none = Otwórz plik z odczytami przyrządu. Jego kolumny mówią, która część była mierzona i przez kogo. Zanim cokolwiek zostanie obliczone, widać, jak plik został zrozumiany.
statistics-study-kind = Rodzaj badania
statistics-study-type1 = Typ 1
statistics-study-crossed = Krzyżowe
statistics-study-nested = Zagnieżdżone
statistics-study-linearity = Liniowość
statistics-study-stability = Stabilność
statistics-study-type1-hint = Jeden wzorzec, 25 odczytów lub więcej
statistics-study-crossed-hint = Każdy operator mierzy każdą część, co najmniej dwa razy
statistics-study-nested-hint = Każdy operator ma własne części
statistics-study-linearity-hint = Kilka wzorców o różnych wymiarach
statistics-study-stability-hint = Jeden wzorzec w czasie
statistics-study-feature = Cecha badania
statistics-study-lower = Dolna granica
statistics-study-upper = Górna granica
statistics-study-reference = Wymiar wzorcowany
statistics-study-resolution = Działka odczytu
statistics-study-references-hint = Jeden wymiar dla każdego wzorca z jego nazwą: M1 = 30.0012; M2 = 40.0005. Puste pole: wymiary nominalne z pliku.
statistics-study-reference-unnamed = { $given } nie nazywa wzorca: wpisz jego nazwę przed wymiarem, na przykład M1 = 30.0012
statistics-study-own-limits = Granice z pliku: { $lower } … { $upper } mm
statistics-study-understood = Jak zrozumiano plik
statistics-study-confirm = Nic nie jest obliczane, dopóki tego nie potwierdzisz.
statistics-study-evaluate = Oceń
statistics-study-all-the-same = Oceń mimo to
statistics-study-working = Ocenianie…
statistics-study-answer = Czy ten przyrząd jest wystarczająco dobry?
statistics-study-each = każdy: { $what }
statistics-study-parts = { $count ->
        [one] 1 część
        [few] { $count } części
        [many] { $count } części
       *[other] { $count } części
    }
statistics-study-operators = { $count ->
        [one] 1 operator
        [few] { $count } operatorzy
        [many] { $count } operatorów
       *[other] { $count } operatora
    }
statistics-study-repeats = { $count ->
        [one] 1 powtórzenie
        [few] { $count } powtórzenia
        [many] { $count } powtórzeń
       *[other] { $count } powtórzenia
    }
statistics-study-masters = { $count ->
        [one] 1 wzorzec
        [few] { $count } wzorce
        [many] { $count } wzorców
       *[other] { $count } wzorca
    }
statistics-study-points = { $count ->
        [one] 1 punkt
        [few] { $count } punkty
        [many] { $count } punktów
       *[other] { $count } punktu
    }
statistics-study-readings-between = od { $least } do { $most } odczytów
statistics-study-more-faults = i jeszcze { $count }
statistics-study-limits-differ = Granice w pliku różnią się między wartościami: podaj dolną i górną granicę albo wybierz cechę.
statistics-study-features = Plik ma kilka cech: wybierz tę, którą zmierzono.
statistics-study-save-budget = Zapisz jako budżet…
statistics-study-save-budget-hint = Rozrzut znaleziony w badaniu, jako typ A ze stopniami swobody, dla strony Niepewność
statistics-study-no-budget = To badanie nie daje wkładu do budżetu
statistics-study-source = { $of ->
        [part] części
        [operator] operatorzy
        [interaction] interakcja
        [repeatability] powtarzalność
        [gauge] przyrząd
       *[total] razem
    }
statistics-study-mean-square = Średni kwadrat, { $source }
statistics-study-p = p, { $source }
statistics-study-variance = Wariancja, { $source }
statistics-study-figure-reference = Wymiar wzorcowany
statistics-study-figure-bias = Obciążenie
statistics-study-figure-mean-bias = Średnie obciążenie
statistics-study-figure-bias-p = p obciążenia
statistics-study-figure-bias-t = t obciążenia
statistics-study-figure-bias-at = Obciążenie przy { $size } mm ({ $count })
statistics-study-figure-smallest = Najmniejsza tolerancja
statistics-study-figure-smallest-good = Najmniejsza tolerancja, 10 %
statistics-study-figure-smallest-accepted = Najmniejsza tolerancja, 30 %
statistics-study-figure-repeatability = Powtarzalność, s
statistics-study-figure-gauge = Przyrząd, s
statistics-study-figure-of-variance = Udział w wariancji
statistics-study-figure-of-readings = Udział we wszystkich odczytach
statistics-study-figure-of-tolerance = Udział w tolerancji
statistics-study-figure-categories = Rozróżnialne kategorie
statistics-study-figure-slope = Nachylenie
statistics-study-figure-slope-p = p nachylenia
statistics-study-figure-intercept = Obciążenie przy 0
statistics-study-figure-intercept-p = p obciążenia przy 0
statistics-study-figure-residual = s wokół prostej
statistics-study-figure-centre = Linia centralna
statistics-study-figure-lower-control = Dolna granica kontrolna
statistics-study-figure-upper-control = Górna granica kontrolna
statistics-study-figure-spread-centre = Średni rozrzut
statistics-study-figure-spread-upper = Górna granica kontrolna rozrzutu
