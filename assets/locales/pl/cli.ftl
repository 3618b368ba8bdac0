# The command line

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = ostrzeżenie: { $what }
cli-remark = uwaga: { $what }

# What an error is about
cli-what-callout = wymiar tolerowany
cli-what-measured-value = wartość zmierzona
cli-what-hole = otwór
cli-what-shaft = wałek
cli-what-measured-hole = zmierzony otwór
cli-what-measured-shaft = zmierzony wałek
cli-what-hole-material = materiał otworu
cli-what-shaft-material = materiał wałka
cli-what-temperature = temperatura
cli-what-smallest-clearance = najmniejszy luz
cli-what-largest-clearance = największy luz
cli-what-nominal-size = wymiar nominalny { $text }
cli-what-true-diameter = średnica rzeczywista
cli-what-simulated-workpiece = symulowany detal
cli-what-simulated-measurement = symulowany pomiar
cli-what-perfect-workpiece = detal nominalny
cli-what-size = wymiar
cli-what-cycle = cykl { $code }
cli-what-log = protokół
cli-what-entry = wpis { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Errors
cli-batch-simulated = pierwsze linie { $name } mówią, że plik jest symulowany, a tylko CSV może je zachować: zapisać CSV
cli-dash = - to standardowe wyjście, tutaj niemożliwe: podać nazwę, a dla pliku lub folderu o nazwie - podać ./-
cli-no-subcommand = { $given } nie jest podpoleceniem; tutaj są: { $names }
cli-not-above-zero = { $diameter } mm nie jest większe od 0
cli-ratio-of-one-limit = reguła asme-simple porównuje niepewność z tolerancją: oczekiwane --lower i --upper
cli-already-corrected = --temperature: plik mówi, że jego wartości już dotyczą 20 °C
cli-not-a-multiple = { $given }: oczekiwana liczba większa od 0, najwyżej trzy miejsca po przecinku
cli-no-limits = podać --lower, --upper lub oba, granica dolna poniżej górnej
cli-risk-without-uncertainty = ryzyko procesu wymaga --u lub --expanded
cli-risk-without-process = --consumer-risk wymaga --process-mean i --process-sd albo --gamma
cli-not-a-risk = ryzyko { $given }: oczekiwane prawdopodobieństwo między 0 a 1, np. 0.001
cli-not-a-gamma = rozkład gamma { $given }: oczekiwany kształt i skala w µm, np. 4,0.25
cli-no-zone-for-risk = żaden zakres wartości przyjętych nie ma takiego ryzyka odbiorcy
cli-line-too-long = linia jest dłuższa niż { $limit } { $limit ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }
cli-not-a-table = { $name } nie jest tabelą odchyłek
cli-stats-features = kilka cech: wybierz jedną przez --feature: { $names }
cli-stats-no-feature = nie ma cechy { $given }: pliki mają { $names }
cli-stats-limits = granice różnią się między wartościami: podaj --lower i --upper albo wybierz cechę przez --feature
cli-stats-no-point = nie ma punktu { $point }: karta ma { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (jeśli to prawda: --confirm-layout)
cli-stats-no-budget = to badanie nie daje wkładu do budżetu
cli-stats-no-picture = nie można narysować obrazu: { $why }
cli-stats-points = --stage i --leave-out dotyczą jednej cechy: wybierz ją przez --feature zamiast --all
cli-stats-parameters = --parameters dotyczy --chart ewma lub cusum
cli-add-feature = { $error }: dodać --feature hole lub --feature shaft
cli-add-wide-zone = { $asked }: { $error }; jeśli takie pole tolerancji jest zamierzone, dodać --wide-zone
cli-add-far-temperature = { $what }: { $error }; jeśli ta temperatura jest zamierzona, dodać --far-temperature
cli-remark-open = { $count ->
    [one] jedna wartość jest poza granicami; poprawka czy brak zależy od otworu lub wałka: dodaj --feature hole lub --feature shaft, kolumnę kind z tymi słowami albo plan
    [few] wartości poza granicami: { $count }; poprawka czy brak zależy od otworu lub wałka: dodaj --feature hole lub --feature shaft, kolumnę kind z tymi słowami albo plan
   *[other] wartości poza granicami: { $count }; poprawka czy brak zależy od otworu lub wałka: dodaj --feature hole lub --feature shaft, kolumnę kind z tymi słowami albo plan
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked }: { $um } µm powyżej maksimum; czy to poprawka, czy brak, zależy od otworu lub wałka: dodać --feature hole lub --feature shaft
   *[below] { $asked }: { $um } µm poniżej minimum; czy to poprawka, czy brak, zależy od otworu lub wałka: dodać --feature hole lub --feature shaft
}
cli-parts-of-several = zmierzone części należą do jednego pasowania: podać jeden wymiar tolerowany
cli-search-with-parts = szukanie nie przyjmuje zmierzonych części, materiałów ani temperatur
cli-search-without-size = szukanie wymaga jednego wymiaru nominalnego, np. 25
cli-search-without-clearance = szukanie wymaga --min-clearance i --max-clearance
cli-table-ending = { $path }: nazwa tabeli sterowania kończy się na .tab
cli-format-ending = { $path }: plik w formacie { $format } kończy się na .{ $endings }
cli-several-tables = tabela sterowania to jeden plik: podać jedną tabelę lub klasy jednego rodzaju (otwory albo wałki)
cli-report-format = --format { $format } nie pasuje do rozszerzenia { $file }: pominąć jedno z nich
cli-stopped = zatrzymano przez Ctrl+C po { $rows } { $rows ->
        [one] wierszu
       *[other] wierszach
    }
cli-report-empty = żadna kontrola nie nadawała się do użycia, więc nie zapisano raportu
cli-inputs-too-large = dane wejściowe cyklu mają najwyżej { $most } KiB
cli-not-an-object = dane wejściowe muszą być obiektem JSON, np. {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: oczekiwana liczba lub tekst
cli-given-twice = { $name } podano dwa razy
cli-option-of-standard = --{ $option } nie działa z --source control: tabele sterowania mają jedno wydanie ISO 286
cli-set-twice = { $name } ustawiono dwa razy
cli-several-blocks = kilka cykli pomiarowych, w wierszach { $blocks }: wybierz jeden przez --at WIERSZ
cli-other-cycle = to jest cykl { $given }, a nie { $wanted }
cli-not-predef = PREDEF nie jest dozwolone dla parametru { $name }
cli-no-probe = tabela sond nie ma sondy { $number }
cli-not-a-pair = { $text }: wpisać parametr jako NAME=VALUE
cli-not-a-position = pozycja { $text }: oczekiwane trzy liczby X,Y,Z w mm
cli-not-a-number = to nie jest liczba
cli-no-folder = nie ma takiego folderu: { $path }
cli-watched-already = inny program obserwuje { $path } dla tego dziennika
cli-no-program = { $error }; wbudowane programy to { $names }
cli-option-beside-plan = --{ $option } dotyczy pojedynczego wymiaru tolerowanego: plan ma na to kolumnę
cli-option-missing = brakuje --{ $option }: pojedynczy wymiar tolerowany wymaga --x, --y i --z
cli-batch-ending = { $path }: plik wyjściowy musi kończyć się na .{ $endings }, a do kompresji dodatkowo na .gz lub .zst
cli-batch-onto-itself = { $path } jest jednym z plików wejściowych: zapisać wyniki do innego pliku
cli-batch-columns = { $name } ma inne kolumny niż pierwszy plik, który ma { $columns }
cli-batch-separator = { $name } ma inny separator niż pierwszy plik: zapisać .jsonl lub ocenić ten plik osobno
cli-batch-types = kolumna { $column } w { $name } ma inny typ w pierwszym pliku: zapisać .csv lub ocenić ten plik osobno
cli-batch-packed = { $path }: Parquet jest już skompresowany: pominąć .gz lub .zst
cli-batch-twice = { $name } ma dwie kolumny o nazwie { $column }: zapisać .csv, który na to pozwala
cli-batch-input = { $name }: { $error }
cli-batch-name = { $name } ma już kolumnę { $column }: opcja --prefix dodaje słowo przed nazwami dodanych kolumn
cli-use-force = { $error }; --force nadpisuje

# A --check of a report
cli-check-no-measured = { $text } nie ma wartości zmierzonej: wpisać wymiar tolerowany, = i milimetry, np. 25 H7=25,012
cli-check-measured = wartość zmierzona: { $value }
cli-check-not-positive = wartość zmierzona { $measured } mm nie jest większa od 0

# Remarks
cli-remark-wrote = zapisano { $path }
cli-remark-wrote-files = zapisano { $path } (pliki: { $count })
cli-remark-simulated = symulacja: niczego nie zmierzono
cli-remark-perfect-workpiece = symulacja: każdy cykl mierzył idealny, nominalny detal; inny detal podaje --workpiece FILE.toml
cli-remark-corrected = zmierzono { $measured } mm przy { $temperature } °C: { $change } µm, czyli { $at-reference } mm przy 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = każda wartość zmierzona jest korygowana z { $temperature } °C do 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = liniały przy { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = korekcja liniowa różni się od dokładnej o { $off } µm
cli-remark-rule = reguła: { $rule }
cli-remark-rule-by-budget = reguła: { $rule }
cli-remark-budget = niepewność z budżetu { $name }, utworzonego { $date }, ważnego do { $until }
cli-remark-budget-contacts = rozrzut dla liczby punktów pomiarowych { $touches }{ $step }, współczynnik geometryczny { $factor }
cli-remark-accepted = przyjmowane: od { $least } do { $most } mm
cli-remark-nothing-accepted = żadna wartość nie jest przyjmowana: reguła nie zostawia nic z tej tolerancji
cli-remark-proven = wykazane według tej reguły
cli-remark-not-proven = niewykazane według tej reguły
cli-remark-conformity = zgodność z prawdopodobieństwem { $percent } %
cli-remark-remove = zebrać { $limit } mm do najbliższej granicy, { $middle } mm do środka pola tolerancji
cli-remark-refused = odrzucono { $refused } z { $asked } wymiarów tolerowanych
cli-remark-no-pair = żadna para nie odpowiada; najbliższa to { $nearest }
cli-remark-trace-ends = ślad kończy się tu, wiersze NC: { $blocks }
cli-remark-batch-utf16 = { $name } jest w UTF-16 i jest zapisywany w UTF-8
cli-remark-batch-floats = { $name } ma liczby zmiennoprzecinkowe w { $columns }: każda jest oceniana jako najkrótszy zapis dziesiętny, który ją przedstawia
cli-remark-tools-not-written = tabela narzędzi nie jest zapisywana: --tools-out FILE.t zapisuje ją z tymi zmianami
cli-remark-clearance-height = bezpieczna wysokość to { $height } mm: zmienia ją --clearance-height
cli-remark-more-entries = pokazano tylko { $limit } { $limit ->
        [one] wpis
        [few] wpisy
        [many] wpisów
       *[other] wpisów
    }: więcej daje --limit N
cli-remark-backed-up = skopiowano do wpisu { $number } włącznie, do { $path } (skrót { $hash })
cli-remark-no-head-known = żaden wpis tego dziennika nie jest znany z innego miejsca: utrata najnowszych wpisów nie zostałaby wykryta

# Warnings
cli-warning-stopped-unrecorded = niczego nie zarejestrowano: wiersze są rejestrowane razem, po odczytaniu wszystkich
cli-warning-column-not-used = kolumna { $column } jest pominięta
cli-warning-expansion-unconfirmed = rozszerzalność { $expansion } · 10⁻⁶/K to wartość typowa, której nie potwierdza tu żaden dokument
cli-warning-file-twice = ten plik podano dwa razy: jego wiersze liczą się podwójnie
cli-warning-position-unused = --position nie działa: cykl { $code } nie zaczyna w pozycji kulki
cli-warning-predef-unused = --predef nie działa na { $name }: nie jest ustawiony na PREDEF
cli-warning-log-option = --{ $option } nie działa: żaden protokół nie jest zapisywany ani pokazywany
cli-warning-more-figures = takie liczby poza listą: jeszcze { $count }
cli-warning-tables-not-used = --tables, --source i opcje normy nie są używane: bez --fit nie są wyszukiwane żadne granice
cli-warning-empty-cell = { $class } ponad { $over } do { $to } mm pozostaje puste: ISO 286 nie ma jednej wartości dla całego zakresu
cli-warning-budget-option = --{ $option } nie działa: budżet od tego nie zależy
cli-warning-contacts-left = cykl użył { $used } z { $count } punktów pomiarowych
cli-warning-not-in-csv = CSV nie ma miejsca na { $options }: mają je HTML, JSON i PDF
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } uwagi nie ma w CSV: zawierają ją HTML i JSON
   *[other] { $count } uwag nie ma w CSV: zawierają je HTML i JSON
}
cli-warning-no-tool-monitored = tabela narzędzi nie jest używana: Q330 nie podaje narzędzia
cli-warning-log-unknown = protokół nie jest zapisywany: protokół cyklu { $code } jest nieznany
cli-warning-limits-alone = tu decydują same granice: reguła decyzyjna i temperatura dotyczą tylko średnic
cli-warning-log-off = protokół nie jest zapisywany: Q281 = 0
cli-warning-log-none = protokół nie jest zapisywany: cykl go nie ma
cli-warning-log-on-screen = protokół nie jest zapisywany: Q281 = 2 pokazuje go na ekranie

# Tables against ISO 286
cli-verify-off = { $place }: { $class } ponad { $over } do { $to } mm: { $table }, w ISO 286 jest { $standard }: { $by }
cli-verify-missing = { $place }: { $class } ponad { $over } do { $to } mm: bez wartości, w ISO 286 jest { $standard }
cli-verify-undefined = { $place }: { $class } ponad { $over } do { $to } mm: { $table }, ale { $reason }
cli-verify-neither = { $place }: { $class } ponad { $over } do { $to } mm: { $reason }
cli-verify-by = { $side ->
        [upper] górna
       *[lower] dolna
    } o { $um } µm { $way ->
        [more] większa
       *[less] mniejsza
    }
cli-verify-table = { $name }: { $classes ->
        [one] { $classes } klasa
        [few] { $classes } klasy
        [many] { $classes } klas
       *[other] { $classes } klas
    }, { $ranges ->
        [one] { $ranges } zakres wymiarów
        [few] { $ranges } zakresy wymiarów
        [many] { $ranges } zakresów wymiarów
       *[other] { $ranges } zakresów wymiarów
    }, porównano { $cells ->
        [one] { $cells } komórkę
        [few] { $cells } komórki
        [many] { $cells } komórek
       *[other] { $cells } komórek
    }: { $differ ->
        [0] wszystkie zgodne z ISO 286
        [one] { $differ } różni się od ISO 286
        [few] { $differ } różnią się od ISO 286
        [many] { $differ } różni się od ISO 286
       *[other] { $differ } różni się od ISO 286
    }
cli-verify-nothing = { $name }: { $classes ->
        [one] { $classes } klasa
        [few] { $classes } klasy
        [many] { $classes } klas
       *[other] { $classes } klas
    }, { $ranges ->
        [one] { $ranges } zakres wymiarów
        [few] { $ranges } zakresy wymiarów
        [many] { $ranges } zakresów wymiarów
       *[other] { $ranges } zakresów wymiarów
    }, porównane komórki: { $cells }: nie ma czego porównać z ISO 286
cli-verify-own = { $table }; nie porównano, to nie klasy ISO 286: { $own }

## Start
start-missing = nie ma takiego pliku: { $path }; podać istniejący plik do otwarcia w oknie lub podpolecenie
start-folder = to folder, a nie plik: { $path }; w oknie otwierają się tylko pliki

## What was recorded
cli-recorded-entry = zarejestrowano jako wpis { $number } w { $file } (skrót { $hash })
cli-recorded-entries = zarejestrowano jako wpisy od { $first } do { $last } w { $file } (skrót ostatniego { $hash })
cli-recorded-nothing = niczego nie oceniono, więc niczego nie zarejestrowano
cli-recorded-without = { $rows ->
    [one] 1 wiersz nie jest zarejestrowany
    [few] { $rows } wiersze nie są zarejestrowane
    [many] { $rows } wierszy nie jest zarejestrowanych
   *[other] { $rows } wierszy nie jest zarejestrowanych
}: { $places }
cli-not-recorded = niczego nie zarejestrowano: { $error }
cli-journal-is-server = do tego potrzebny jest plik dziennika stanowiska: serwer tylko przyjmuje to, co zarejestrowały stanowiska
cli-no-shop = ten program zbudowano bez obsługi serwera warsztatu: podać plik jako dziennik
cli-recorded-not-sent = jeszcze nie wysłano na serwer: { $error }; zapisy są przechowywane tutaj, a wysyła je fitcheck journal send
cli-no-journal-folder = ten system nie ma folderu na dane: podać dziennik przez --journal FILE
cli-no-entry = w { $path } nie ma wpisu { $number }: ostatni to { $last }
cli-no-check = wpis { $number } nie jest kontrolą
cli-no-hash = żaden wpis w { $path } nie ma skrótu, który zaczyna się od { $prefix }
cli-several-hashes = skróty kilku wpisów zaczynają się od { $prefix }: { $numbers }. Podać więcej cyfr albo numer
cli-record-needs-file = --record podaje zapisany plik, a standardowe wyjście nim nie jest: podać -o FILE
cli-report-not-known = { $file } został zapisany, ale dziennik go nie zna: { $error }
cli-already-corrected-by = wpis { $number } został już skorygowany lub wycofany wpisem { $by }: skorygować tamten, chyba że jest wycofaniem
cli-not-typed = wartości wpisu { $number } nie wpisano ręcznie: powtórzyć pomiar lub wycofać kontrolę
cli-nothing-corrected = korekta musi coś zmieniać: podać --measured, --who, --part, --serial, --feature-name, --remark lub --withdraw
cli-remark-sent = { $entries ->
    [0] nie było nic do wysłania
    [one] wysłano 1 wpis
    [few] wysłano { $entries } wpisy
    [many] wysłano { $entries } wpisów
   *[other] wysłano { $entries } wpisów
}: { $server } ma ten dziennik do wpisu { $number }
cli-remark-nothing-found = żadna kontrola nie pasuje do { $question }
cli-remark-unread = { $entries ->
    [one] pominięto 1 wpis
    [few] pominięto { $entries } wpisy
    [many] pominięto { $entries } wpisów
   *[other] pominięto { $entries } wpisów
}: ta wersja nie umie { $entries ->
    [one] go
   *[other] ich
} odczytać
cli-head-without-chain = serwer ma kilka łańcuchów: podać --head CHAIN:NUMBER:HASH
cli-head-of-other = ten dziennik to łańcuch { $chain }, a --head podaje { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } element
    [few] { $count } elementy
    [many] { $count } elementów
   *[other] { $count } elementów
}
cli-remark-plan-example = nie podano wymiaru tolerowanego: plan ma jeden element jako przykład
cli-remark-plan-to-fill = plan zapisano, o ile jest znany; błędy do poprawienia: { $count }
cli-remark-no-columns = plik jest czytany według własnego formatu i nie ma kolumn do wyboru
cli-remark-plan-head-left = CSV zawiera tylko elementy: { $keys } części nie zapisano
cli-warning-neither-stands = wpis { $number } korygował wpis { $target }: teraz żaden z nich się nie liczy. Jeśli jedna z wartości jest właściwa, zarejestrować ją ponownie
cli-warning-beyond-limits = poza granicami: przyjęty według reguły, bo przekroczenie nie jest wykazane
cli-warning-plan-missing = niezmierzone: { $names }
cli-warning-plan-missing-of = { $who }: niezmierzone: { $names }
cli-warning-contradiction = { $name } ma sprzeczne wartości: { $values }
cli-warning-contradiction-of = { $who }: { $name } ma sprzeczne wartości: { $values }
cli-warning-worst-counts = liczy się najgorsza ze sprzecznych wartości, aż do wyboru: --repeats last lub --repeats worst. Numery seryjne rozróżniają części, a czas każdej wartości pokazuje, która jest ostatnia
cli-warning-plan-more-parts = więcej niż { $most } { $most ->
        [one] część
        [few] części
        [many] części
       *[other] części
    }: brakujące elementy pozostałych nie są podawane
cli-warning-plan-no-value = brakuje: nie znaleziono wartości
cli-warning-plan-no-value-of = brakuje na { $who }: nie znaleziono wartości
cli-remark-watching = obserwacja { $folder }; pliki już zaimportowane: { $known }
cli-warning-see-note = nie wszystko dało się użyć: powody podaje plik obok, zakończony na { $note }
cli-not-seconds = { $given } nie jest czasem w sekundach
cli-warning-same-content = tę samą treść zaimportowano już jako { $known }: nic nie jest rejestrowane ponownie
cli-warning-not-alone = nie wiadomo, czy inny program obserwuje ten folder dla tego samego dziennika: { $reason }

## The time zone of this computer
zone-not-understood = TZ jest ustawione na "{ $given }", co nie jest strefą czasową: ustawić nazwę, np. Europe/Amsterdam, lub UTC, albo usunąć
zone-unknown = strefa czasowa tego komputera jest nieznana, więc czasy są w UTC: ustawić TZ na nazwę, np. Europe/Amsterdam

# Doktor
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, jest { $time }
doctor-clock = nie wcześniej niż najnowszy wpis dziennika
doctor-clock-behind = wcześniej niż najnowszy wpis w { $path }, zapisany { $newest }: ustaw zegar tego komputera
doctor-folder = { $path }: można zapisywać pliki
doctor-journal = { $path }: wpisów { $entries }
doctor-no-journal = { $path } jeszcze nie ma: utworzy go pierwsza zapisana kontrola
doctor-server = { $address } odpowiada
doctor-no-server = nie ustawiono serwera: podaj go przez --journal postgres://…, albo w oknie w Ustawieniach
doctor-gauges = porty tego komputera: { $ports }
doctor-no-port = ten komputer nie ma portu szeregowego: podłącz przyrząd lub jego kabel
doctor-gauge-gone = { $gauge }: nie ma portu { $port }: podłącz przyrząd albo wybierz w oknie w Ustawieniach inny port
doctor-no-gauges = ten program zbudowano bez portów przyrządów: pakiety je mają
doctor-ports-not-listed = nie można wypisać portów tego komputera: { $reason }
doctor-tables = { $path }: tabel { $count }
doctor-no-tables = brak własnych tabel: ISO 286 i tabele sterowania są wbudowane
doctor-settings = to, co zachowuje okno, można odczytać
doctor-window = rysowane przez { $renderer }
doctor-no-window = ten program zbudowano bez okna
