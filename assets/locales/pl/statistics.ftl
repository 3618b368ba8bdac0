# statistics

# Dlaczego nie ma liczby
statistics-reason-empty = nie ma żadnych wartości
statistics-reason-not-a-number = wartość { $place } nie jest liczbą
statistics-reason-too-few = za mało wartości lub grup: { $found }, potrzeba co najmniej { $needed }
statistics-reason-all-equal = wszystkie wartości są równe: nie ma rozrzutu, z którym można liczyć
statistics-reason-no-subgroups = żadna podgrupa nie ma dwóch lub więcej wartości
statistics-reason-ungrouped = wartości, które nie podają swojej grupy: { $count }
statistics-look-grouped = Punkty są średnimi: { $by ->
        [part] wartości jednej części
        [batch] wartości jednej partii
        [machine] wartości jednej maszyny
        [gauge] wartości jednego stanowiska
        [who] wartości jednej osoby
       *[other] wartości bez przerwy dłuższej niż { $minutes } min
    }.
statistics-look-stages = Punkty, w których zaczyna się etap: { $points }. Wartości pochodzą z ostatniego etapu.
statistics-look-waits = Etapy, które mają jeszcze za mało różnych wartości i na razie się nie liczą: { $count }.
statistics-look-frozen = Granice kontrolne pochodzą z punktów od { $first } do { $last }.
statistics-look-memory = Druga karta: { $method }.
statistics-look-no-memory = Brak karty { $method }: { $why }.
statistics-reason-large-subgroup = liczba wartości w podgrupie to { $found }: rozstęp stosuje się najwyżej do { $most }
statistics-reason-unequal-subgroups = podgrupy mają od { $least } do { $most } wartości: ta karta wymaga podgrup równej wielkości
statistics-reason-no-limits = nie ma granic
statistics-reason-one-limit = jest tylko jedna granica, a potrzebne są obie
statistics-reason-swapped-limits = dolna granica nie leży poniżej górnej
statistics-reason-not-positive = ten rozkład ma tylko wartości dodatnie
statistics-reason-negative = ten rozkład nie ma wartości ujemnych
statistics-reason-no-fit = ten rozkład nie pasuje do wartości
statistics-reason-uneven-cell = odczyty części { $part } przez operatora { $operator }: { $found }, oczekiwano { $needed }
statistics-reason-no-baseline = okres odniesienia nie leży w swoim etapie albo jego liczb nie można użyć
statistics-reason-parameter = { $name } nie może wynosić { $given }

# Reguły kart kontrolnych, gdy któraś zadziała
statistics-rule-beyond-limits = 1 punkt poza granicą kontrolną
statistics-rule-nine-one-side = 9 punktów z rzędu po jednej stronie linii środkowej
statistics-rule-six-trend = 6 punktów z rzędu rosnących lub malejących
statistics-rule-fourteen-alternating = 14 punktów z rzędu na przemian w górę i w dół
statistics-rule-two-of-three = 2 z 3 punktów poza 2 s po jednej stronie
statistics-rule-four-of-five = 4 z 5 punktów poza 1 s po jednej stronie
statistics-rule-fifteen-within = 15 punktów z rzędu w odległości do 1 s od linii środkowej
statistics-rule-eight-beyond = 8 punktów z rzędu poza 1 s, po dowolnej stronie
statistics-rule-eight-one-side = 8 punktów z rzędu po jednej stronie linii środkowej
statistics-chart-maximum = największy { $size }
statistics-chart-minimum = najmniejszy { $size }
statistics-chart-upper = górna { $size }
statistics-chart-mean = średnia { $size }
statistics-chart-lower = dolna { $size }
statistics-chart-values = Wartości pojedyncze w µm od { $base }, najstarsze z lewej
statistics-chart-means = Średnie grup w µm od { $base }, najstarsze z lewej
statistics-chart-histogram = Histogram
statistics-chart-moving-range = Ruchomy rozstęp, µm
statistics-chart-range = Rozstęp grup, µm
statistics-chart-deviation = Odchylenie standardowe grup, µm
statistics-chart-probability = Wykres prawdopodobieństwa
statistics-chart-ewma = Średnie ważone (EWMA)
statistics-chart-cusum = Sumy odchyleń od średniej (CUSUM)
statistics-chart-probability-test = Wykres prawdopodobieństwa, Anderson-Darling { $statistic }, p = { $p }

# Co zrobić z liczbami
statistics-advice-few-values = liczba wartości { $count }: przedziały są szerokie, zwykle jest ich { $enough } lub więcej
statistics-advice-few-points = granice kontrolne wynikają z tylu punktów: { $count }; zwykle jest ich { $enough } lub więcej
statistics-advice-unstable = liczba punktów, w których zadziałała reguła: { $count }; zdolność dotyczy tylko procesu stabilnego
statistics-advice-not-of-law = wartości raczej nie pochodzą z tego rozkładu (p = { $p }): jego udziały poza granicami nie są wiarygodne
statistics-advice-centred = nie korygować: { $what ->
        [line] wymiar leży teraz
       *[mean] średnia leży
    } { $um } µm od środka tolerancji, a przy liczbie wartości { $count } to szum
statistics-advice-near = nie korygować: { $what ->
        [line] wymiar leży teraz
       *[mean] średnia leży
    } { $um } µm od środka tolerancji, liczba wartości { $count }
statistics-advice-correct = skorygować o { $correction } µm: { $what ->
        [line] wymiar leży teraz
       *[mean] średnia leży
    } { $um } µm od środka tolerancji, liczba wartości { $count }
statistics-advice-no-trend = brak trendu: zmiana między kolejnymi częściami to szum
statistics-advice-trend = wymiar zmienia się o { $um } µm na część
statistics-advice-trend-at-limit = wymiar zmienia się o { $um } µm na część i od teraz należy się spodziewać części poza granicą
statistics-advice-trend-to = wymiar zmienia się o { $um } µm na część: do granicy pozostało około { $parts } części ({ $level } %: od { $least } do { $most })
statistics-advice-average-out = średnia ważona jest poza swoimi granicami, po raz pierwszy w punkcie { $at }: średnia się przesunęła
statistics-advice-sum-out = suma jest poza przedziałem decyzyjnym, po raz pierwszy w punkcie { $at }: średnia się przesunęła, mniej więcej od punktu { $since }
statistics-advice-groups-alike = grupy nie różnią się bardziej niż przypadkowo (p = { $p })
statistics-advice-groups-differ = grupy się różnią (p = { $p })

# Badania przyrządów
statistics-gauge-operator-per-value = każda wartość ma własnego operatora: czy kolumny są właściwe?
statistics-gauge-more-operators = operatorzy: { $operators }, części: { $parts }: czy kolumny części i operatorów są zamienione?
statistics-gauge-operators-differ-more = operatorzy różnią się bardziej niż części: czy kolumny części i operatorów są zamienione?
statistics-gauge-same-parts = każdy operator ma części o tych samych nazwach: czy badanie jest krzyżowe?
statistics-gauge-several-masters = wartości pochodzą z { $parts } części, a to badanie wymaga jednego wzorca
statistics-gauge-master-good = wystarczająco dobry dla tej tolerancji: Cg i Cgk osiągają { $required } (AIAG MSA, VDA 5)
statistics-gauge-master-bad = niewystarczający dla tej tolerancji: Cg i Cgk muszą osiągnąć { $required }, przy działce odczytu najwyżej 5 % tolerancji (AIAG MSA, VDA 5)
statistics-gauge-smallest = najmniejsza tolerancja, dla której jest wystarczająco dobry: { $mm } mm ({ $level } %: do { $most } mm)
statistics-gauge-biased = obciążenie { $um } µm to więcej niż przypadek (p = { $p })
statistics-gauge-not-biased = obciążenie { $um } µm może być przypadkiem (p = { $p })
statistics-gauge-good = wystarczająco dobry: przyrząd zajmuje { $percent } % { $of ->
        [tolerance] tolerancji
       *[variation] całej zmienności
    }, a do 10 % jest dobrze (AIAG MSA)
statistics-gauge-accepted = wystarczająco dobry tylko wtedy, gdy musi wystarczyć: przyrząd zajmuje { $percent } % { $of ->
        [tolerance] tolerancji
       *[variation] całej zmienności
    }, a od 10 % do 30 % zależy od zastosowania (AIAG MSA)
statistics-gauge-bad = niewystarczający: przyrząd zajmuje { $percent } % { $of ->
        [tolerance] tolerancji
       *[variation] całej zmienności
    }, a ponad 30 % to za dużo (AIAG MSA)
statistics-gauge-smallest-shares = najmniejsza tolerancja, dla której jest wystarczająco dobry: { $good } mm; jeśli musi wystarczyć: { $accepted } mm
statistics-gauge-interaction-kept = operatorzy różnią się na niektórych częściach bardziej niż na innych (p = { $p }): interakcja pozostaje
statistics-gauge-interaction-pooled = operatorzy nie różnią się na niektórych częściach bardziej niż na innych (p = { $p }): interakcja jest doliczona do powtarzalności
statistics-gauge-negative = wariancja { $what ->
        [operator] operatorów
        [interaction] interakcji
       *[part] części
    } wyszła ujemna i liczy się jako 0
statistics-gauge-not-linear = obciążenie zmienia się z wymiarem (p = { $p })
statistics-gauge-linear = obciążenie nie zmienia się z wymiarem bardziej niż przypadkowo (p = { $p })
statistics-gauge-stable = stabilny: żadna reguła nie reaguje, a wskazania nie dryfują
statistics-gauge-not-stable = niestabilny: reaguje reguła albo wskazania dryfują

# Dlaczego wartości nie są badaniem
series-study-no-parts = wartości bez części: { $count }
series-study-no-operators = wartości bez operatora obok innych, które go mają: { $count }
series-study-uneven-cell = odczyty części { $part } przez operatora { $operator }: { $found }, oczekiwano { $needed }
series-study-uneven-operator = części operatora { $operator }: { $found }, oczekiwano { $needed }
series-study-nested = każdą część mierzył tylko jeden operator: to badanie zagnieżdżone
series-study-no-reference = wartości bez wymiaru wzorcowanego: { $count }
series-study-references = wartości jednego wzorca mają kilka wymiarów wzorcowanych

# Jak obliczono wartości badania
series-method-word = { $word }
series-method-given = podano
series-method-mean = średnia, Student
series-method-deviation = odchylenie standardowe, chi-kwadrat
series-method-bias = średnia − wartość odniesienia, Student
series-method-t-test = test t
series-method-type1 = typ 1
series-method-share = { $percent } % tolerancji, { $spread } s
series-method-required = Cg i Cgk co najmniej { $required }
series-method-anova = analiza wariancji
series-method-degrees = analiza wariancji, stopnie swobody: { $degrees }
series-method-ratio = F = { $f }
series-method-negative = ujemna, liczona jako 0
series-method-chi-square = chi-kwadrat
series-method-large-sample = zmodyfikowana duża próba
series-method-variances = wariancje
series-method-categories = 1,41 części / przyrząd
series-method-linearity = liniowość
series-method-least-squares = najmniejsze kwadraty
series-method-within-masters = s w obrębie wzorców
statistics-on-spread = rozrzut: { $rule }
