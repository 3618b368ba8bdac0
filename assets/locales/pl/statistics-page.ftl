page-statistics = Statystyka

# O co chodzi w pytaniu
statistics-page-question = Zapisy
statistics-page-question-hint = Zapisy, których wartości są używane, w języku strony Zapisy, na przykład part:"Kołnierz 40" station:"Frezarka 3" from:2026-11-01. Puste pole: wszystkie zapisy.
statistics-page-last = Najnowsze wartości
statistics-page-size = Wartości na punkt
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
statistics-page-take-in = Uwzględnij ponownie
statistics-page-reason = Powód
statistics-page-take-reason = Pomiń
statistics-page-cancel-reason = Anuluj
statistics-page-copy = Kopiuj wartości
statistics-page-copy-hint = Wartości, sygnały i porady jako tabela do arkusza kalkulacyjnego
statistics-page-report = Raport…
statistics-page-report-hint = Wartości i wykresy wszystkich cech jako raport do podpisu

# Sygnały
statistics-page-signals = Sygnały
statistics-page-no-signals = Żadna reguła nie zadziałała.
statistics-page-rules = Reguły
statistics-page-on-spread = Rozrzut: { $rule }
statistics-page-alarms = Otwarte alarmy: { $count }
statistics-page-at = Punkt { $point }
statistics-page-from-to = Punkty od { $first } do { $last }
statistics-page-left-out-because = Pominięto: { $reason }
statistics-page-advice = Porady
