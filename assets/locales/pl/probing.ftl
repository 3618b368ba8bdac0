# probing

# Where a measurement comes from, and what it cannot tell.
origin-simulated = symulacja, cykl { $cycle }, ziarno { $seed }
origin-contacts = punkty pomiarowe z { $file }
origin-imported = import z { $file }
origin-imported-simulation = import z { $file }, symulacja
origin-typed = wpisano
caveat-only-a-diameter = tylko jedna średnica: kształt i położenie nieznane
caveat-only-a-circle = tylko średnica i środek: kształt nieznany
caveat-three-contacts = 3 punkty pomiarowe: nie można zmierzyć kształtu
caveat-four-contacts = 4 punkty pomiarowe: poza owalnością kształt nie jest wykrywany
caveat-few-contacts = liczba punktów pomiarowych { $contacts }: kształt między nimi nie jest wykrywany
caveat-short-arc = punkty pomiarowe obejmują tylko { $arc }°: rozrzut w średnicy i środku jest powiększony
caveat-two-point = średnica między punktami { $one } i { $other } wynosi { $size } mm, poza granicą { $limit } mm, której okrąg średni nie przekracza: domyślnie wymiar obowiązuje między dowolnymi dwoma przeciwległymi punktami
caveat-form = promienie punktów pomiarowych różnią się o { $form } mm, więc średnice między nimi mogą różnić się bardziej niż pole tolerancji { $zone } mm: dwa przeciwległe punkty mogą leżeć poza granicami
caveat-heights = wysokości punktów pomiarowych różnią się o { $spread } mm: na stożku lub przy pochylonej osi zmienia to średnicę
caveat-stated = wymiar podaje za tolerancją { $upper } i { $lower } µm, a tolerancja ma { $used-upper } i { $used-lower } µm: użyto tolerancji; sprawdź, co oznacza rysunek
caveat-count = wymiar dotyczy { $count } elementów: ta wartość jest wartością jednego
caveat-form-class = klasa { $class } z ISO 2768-2 dotyczy kształtu i położenia: wymiar ich nie pokazuje
caveat-each-two-point = { $modifier } wymaga każdego wymiaru dwupunktowego w granicach: to tylko jedna średnica
caveat-mean-of-two-points = { $modifier } wymaga każdego wymiaru dwupunktowego w granicach: średnica najmniejszych kwadratów jest tylko ich średnią
caveat-not-least-squares = { $modifier } oznacza wymiar najmniejszych kwadratów: jedna średnica go nie pokazuje
caveat-one-section = { $modifier } oznacza wymiar najmniejszych kwadratów całego elementu: to wymiar jednego przekroju
caveat-envelope = { $modifier } wymaga powłoki o idealnym kształcie przy wymiarze maksimum materiału: jedna średnica nie pokazuje, czy powierzchnia ją przekracza; użyj sprawdzianu
caveat-other-size = { $modifier } oznacza inny wymiar niż zmierzony: średnica dwupunktowa ani najmniejszych kwadratów go nie dowodzi
caveat-condition = { $modifier } mówi, gdzie lub jak obowiązuje wymiar: zmierzona wartość nie pokazuje, czy to spełniono
contact-beyond-travel = punkt pomiarowy { $number } leży { $distance } mm od początku próbkowania, a kulka przejeżdża najwyżej { $allowed } mm (DIST lub K, plus SET_UP z tabeli sond i Q320): sprawdzić, czy punkty są z tego elementu, w tej kolejności i liczone od tego punktu zerowego
contact-missed = punkt pomiarowy { $number }: sonda niczego nie napotkała na drodze próbkowania
contact-no-height = punkt pomiarowy { $number } nie ma wysokości: dodać do pliku kolumnę z
contact-used-up = punkt pomiarowy { $number }: w pliku są tylko { $available ->
    [one] { $available } punkt
    [few] { $available } punkty
    [many] { $available } punktów
   *[other] { $available } punktów
    }

cycle-out-of-range = { $key } { $name } = { $given }: { $allowed }
cycle-length-range = co najmniej { $least } mm, najwyżej { $most } mm
cycle-angle-range = najwyżej { $most } w obie strony
cycle-angle-size-range = wielkość co najmniej { $smallest }, najwyżej { $most }
cycle-one-of = oczekiwane jedno z { $allowed }
cycle-tool-range = numer narzędzia od 0 do 99999,9 lub nazwa narzędzia do 255 znaków
cycle-not-a-value = { $key } { $name }: { $error }
cycle-tool-no-name = { $text } nie wywołuje narzędzia: wpisać jego numer lub nazwę
cycle-tool-empty = nie podano narzędzia: dla żadnego wpisz Q330=0
cycle-tool-unquoted = { $text } nie jest liczbą, a nazwa narzędzia wymaga cudzysłowu
cycle-no-diameter = { $key } { $name } = 0 mm: okrąg wymaga średnicy większej od 0
cycle-one-limit = podano { $given } bez { $missing }: drugą granicą byłoby 0
cycle-missing = brakuje { $key } { $name }
cycle-no-such-parameter = cykl { $cycle } nie ma parametru { $parameter }: ma parametry { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm jest powyżej { $maximum-key } = { $maximum } mm: wymiar minimalny jest większy od maksymalnego
cycle-too-large = zmierzony okrąg jest za duży: { $error }
workpiece-cannot-be = { $what } = { $given }: co najmniej { $least }, najwyżej { $most }

# Touches.
contact-in-material = punkt pomiarowy { $number }: droga próbkowania zaczyna się w materiale
contact-in-feature = punkt pomiarowy { $number }: droga próbkowania zaczyna się w materiale elementu { $feature }
contact-behind = punkt pomiarowy { $number }: kulka dochodzi do ścianki { $feature } od tyłu, a grubość materiału w tym miejscu jest nieznana
contact-ambiguous = punkt pomiarowy { $number }: kulka trafia w { $feature } i { $other } w tym samym miejscu, więc nie wiadomo, co jest mierzone

# Circle evaluation.
circle-too-few = okrąg wymaga co najmniej 3 punktów pomiarowych, jest { $contacts }
circle-coinciding = punkty pomiarowe { $first } i { $second } pokrywają się w x = { $x }, y = { $y }: okrąg wymaga 3 różnych punktów
circle-collinear = wszystkie punkty pomiarowe ({ $contacts }) leżą na jednej prostej: nie przechodzi przez nie żaden okrąg
circle-straight = punkty pomiarowe ({ $contacts }) pasują do prostej lepiej niż do jakiegokolwiek okręgu
circle-not-finite = punkt pomiarowy { $contact }: { $axis } = { $value } nie jest liczbą skończoną
circle-too-large = { $what } = { $value } mm to za dużo: najwyżej { $most } mm w obie strony
circle-part-contact = punkt pomiarowy { $contact }: { $axis }
circle-part-diameter = średnica
circle-part-centre = środek { $axis }
circle-three-contacts = 3 punkty pomiarowe: nie można zmierzyć kształtu, odchyłka resztkowa jest zawsze zerowa
circle-four-contacts = 4 punkty pomiarowe: cztery garby nie są wykrywane i zmieniają średnicę
circle-short-arc = punkty pomiarowe obejmują tylko { $arc }° łuku: rozrzut średnicy jest { $factor } razy większy niż z 3 punktów co 120°
circle-circumscribed-of-short-arc = najmniejszy okrąg opisany na krótkim łuku nie jest wymiarem elementu
circle-counts-twice = punkty pomiarowe { $first } i { $second } pokrywają się: to miejsce liczy się dwa razy
circle-no-inscribed = nie ma największego okręgu wpisanego: punkty pomiarowe go nie otaczają
circle-no-zone = nie ma strefy minimalnej: prosty pas jest węższy niż jakikolwiek pierścień
circle-too-many-contacts = największy okrąg wpisany i strefa minimalna nie są obliczane, gdy punktów pomiarowych jest { $contacts }: najwyżej { $most }
circle-short-chord = punkty pomiarowe { $first } i { $second } leżą naprzeciw siebie, ale poza środkiem: ten wymiar jest o { $short } µm za mały
circle-more-of-a-kind = to samo dotyczy jeszcze { $more }
circle-apart = punkt pomiarowy { $contact } leży { $apart } mm od okręgu, dużo dalej niż pozostałe: brud lub fałszywy sygnał?
circle-heights = wysokości punktów pomiarowych różnią się o { $spread } mm: na stożku lub przy pochylonej osi zmienia to średnicę

## Measuring cycles: errors, results, remarks
contact-out-of-reach = punkt pomiarowy { $number }: sonda niczego nie napotkała na drodze próbkowania { $longest } mm
cycle-number-range = liczba, najwyżej { $most } w obie strony
cycle-count-range = liczba całkowita od 0 do { $most }
cycle-band-range = tolerancja, np. 0.4-0.1, 0.4 lub -0.1; 0 oznacza bez tolerancji
cycle-range = { $range }
cycle-range-tool = 0 … { $highest } lub najwyżej { $longest } { $longest ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    }
cycle-range-band = 0.4-0.1, 0.4, -0.1 lub nic
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = bez tolerancji
cycle-no-global = { $key } { $name } = PREDEF: żadne GLOBAL DEF nie podaje wartości
cycle-no-path = { $key } { $name } = 0 mm: droga próbkowania wymaga długości; jej znak podaje kierunek
cycle-no-transfer = { $row-key } = { $row } przy { $key } = -1: nie podano, w której tabeli jest ten wiersz; { $key } musi być 0 lub 1 (sterowanie zgłasza błąd 1078)
cycle-other-feature = { $key } { $name } = { $given }: klasa nie zgadza się z { $geometry }: wielkie litery dotyczą otworu, małe czopa
cycle-not-measured = { $key } { $name } = { $given }: cykl nie mierzy tej wartości: zapisz ją bez tolerancji
cycle-inch-tolerance = { $key } { $name } = { $given }: w programie w calach jednostka tolerancji nie jest znana: napisz program w mm albo liczbę bez tolerancji
cycle-no-edge = { $first } i { $second } są równe: krawędź wymaga dwóch punktów wzdłuż niej
cycle-no-sphere = punkty nie wyznaczają kuli
cycle-no-rotation = { $key } { $name }: Fitcheck śledzi tylko obrót podstawowy (Q1121 = 1), i to bez korekty (Q1120 = 0)
cycle-no-normal = { $first }, { $second } i { $third } są równe 0: normalna wymaga kierunku
cycle-apart = punkt pomiarowy { $contact }: jego dwa próbkowania różnią się o { $difference } mm, { $key } dopuszcza { $most } mm
cycle-too-far = zmierzona współrzędna jest za duża: { $error }
cycle-stop = zatrzymanie programu przez Q309 = { $setting }: { $out }
check-within = { $what } { $measured } mm: w zakresie od { $minimum } do { $maximum } mm
check-above = { $what } { $measured } mm: powyżej maksimum { $maximum } mm: { $status }
check-below = { $what } { $measured } mm: poniżej minimum { $minimum } mm: { $status }
check-and = { $one }; { $other }
found-centre-1 = zmierzony środek, oś 1
found-centre-2 = zmierzony środek, oś 2
found-centre-3 = zmierzony środek, oś 3
found-diameter = zmierzona średnica
found-centre-deviation-1 = odchyłka środka, oś 1
found-centre-deviation-2 = odchyłka środka, oś 2
found-centre-deviation-3 = odchyłka środka, oś 3
found-diameter-deviation = odchyłka średnicy
found-coordinate = zmierzona współrzędna
found-coordinate-deviation = odchyłka współrzędnej
found-position-1 = zmierzona pozycja, oś 1
found-position-2 = zmierzona pozycja, oś 2
found-position-3 = zmierzona pozycja, oś 3
found-angle = zmierzony kąt
found-deviation-1 = odchyłka, oś 1
found-deviation-2 = odchyłka, oś 2
found-deviation-3 = odchyłka, oś 3
found-deviation-along = odchyłka wzdłuż normalnej
found-second-position-1 = 2. punkt: zmierzona pozycja, oś 1
found-second-position-2 = 2. punkt: zmierzona pozycja, oś 2
found-second-position-3 = 2. punkt: zmierzona pozycja, oś 3
found-second-deviation-1 = 2. punkt: odchyłka, oś 1
found-second-deviation-2 = 2. punkt: odchyłka, oś 2
found-second-deviation-3 = 2. punkt: odchyłka, oś 3
found-second-diameter = 2. okrąg: zmierzona średnica
found-second-diameter-deviation = 2. okrąg: odchyłka średnicy
found-rotation = zmierzony obrót
found-side-1 = zmierzona długość, bok 1
found-side-2 = zmierzona długość, bok 2
found-width = zmierzona szerokość
found-centre-line = położenie linii środkowej
found-side-deviation-1 = odchyłka boku 1
found-side-deviation-2 = odchyłka boku 2
found-width-deviation = odchyłka szerokości
found-good = w tolerancji
found-rework = poprawka
found-scrap = brak
found-status = status: -1 niezdefiniowany, 0 dobry, 1 poprawka, 2 brak
cycle-note-machine-builder = producent maszyny musi udostępnić i dopasować ten cykl: patrz instrukcja maszyny
cycle-note-not-on-itnc530 = iTNC 530 nie ma tego cyklu; mają go TNC 320, TNC 620, TNC 640 i TNC7
cycle-note-normal-from-cad = normalną wziąć z systemu CAD lub CAM
cycle-note-software-option = sterowanie wymaga opcji software { $option }
cycle-note-recommended = jeśli sterowanie ma cykl { $cycle }, HEIDENHAIN zaleca ten cykl
cycle-note-ends-rotation = kończy aktywny obrót podstawowy
remark-without-effect = { $key } jest przyjmowane, ale nie ma skutku
remark-tool-not-monitored = Q330 = { $tool }: narzędzie nie jest monitorowane: bez tabeli narzędzi
remark-outside-dimension = przyjęto wymiar zewnętrzny: powyżej maksimum poprawka, poniżej minimum brak
remark-nominal-outside-limits = średnica nominalna { $nominal } mm nie leży między granicami: TNC7 to odrzuca
remark-nominal-width-outside-limits = szerokość nominalna { $nominal } mm nie leży między granicami: TNC7 to odrzuca
remark-nominal-coordinate-outside-limits = współrzędna nominalna { $nominal } mm nie leży między granicami: według instrukcji TNC7 może to odrzucić
remark-contact-astray = { $count ->
    [one] punkt pomiarowy { $contact } leży { $distance } mm od miejsca, w którym cykl próbkuje: może należeć do innego elementu
    [few] { $count } punkty pomiarowe leżą z dala od miejsca, w którym cykl próbkuje, punkt { $contact } o { $distance } mm: mogą należeć do innego elementu
    [many] { $count } punktów pomiarowych leży z dala od miejsca, w którym cykl próbkuje, punkt { $contact } o { $distance } mm: mogą należeć do innego elementu
   *[other] { $count } punktów pomiarowych leży z dala od miejsca, w którym cykl próbkuje, punkt { $contact } o { $distance } mm: mogą należeć do innego elementu
}
remark-deviation-without-parameter = odchyłka nie ma tu parametru: instrukcja mówi, że sterowanie ją zapisuje, ale nie podaje gdzie
remark-new-datum = nowy punkt odniesienia, { $target }: { $axes } mm (zmierzono → żądano)
datum-target-display = od razu aktywny
datum-target-active = korekta aktywnego punktu odniesienia
datum-target-preset = wiersz { $row } tabeli punktów odniesienia
datum-target-table = wiersz { $row } tabeli punktów zerowych
remark-new-rotation = nowy obrót podstawowy o { $angle }: { $target }
remark-axis-turned = oś { $axis } obraca detal o { $angle }: tylko maszyna wie, gdzie leży jej środek, a zera osi Fitcheck nie zapisuje w żadnej tabeli
remark-variable-holds-diameter = #i99 jest czytane jako średnica: instrukcja nie mówi, jaką wartość zawiera
remark-no-tolerance = { $key } nie jest tolerancją: nic nie jest oceniane

## The simulated machine
workpiece-file-toml = linia { $line }: { $said }
workpiece-file-too-large = plik detalu ma najwyżej { $most } KiB
workpiece-file-not-one = plik ma { $found } z { $tables }: potrzebny jest dokładnie jeden
workpiece-file-cannot-be = linia { $line }: { $error }
workpiece-file-several = plik ma tabele [[feature]]: tu oczekiwany jest jeden detal z jedną powierzchnią
workpiece-file-too-many = część ma najwyżej { $most } { $most ->
        [one] element
        [few] elementy
        [many] elementów
       *[other] elementów
    }
workpiece-file-feature = linia { $line }, kolumna { $column }: { $feature }: { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } nie jest rodzajem elementu: rodzaje to { $known }
feature-fault-no-key = { $kind } wymaga { $key }
feature-fault-other-key = { $kind } nie ma { $key }
feature-fault-name = nazwa ma od 1 do { $most } { $most ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    } w jednej linii
feature-fault-same-name = inny element ma tę samą nazwę

# Figures of the simulated workpiece, as errors name them.
figure-temperature = temperatura
figure-expansion = rozszerzalność
figure-probe-scatter = rozrzut sondy
figure-ball-radius = promień kulki
figure-calibration-error = błąd kalibracji
figure-offset = przesunięcie
figure-lobing = amplituda drogi wstępnej
figure-lobing-angle = kąt drogi wstępnej
figure-lobing-count = garby drogi wstępnej
figure-centre-x = środek x
figure-centre-y = środek y
figure-diameter = średnica
figure-surface-scatter = rozrzut powierzchni
figure-ovality = owalność
figure-ovality-angle = kąt owalności
figure-ovality-count = liczba owalności
figure-lobe-height = wysokość garbu
figure-lobe-angle = kąt garbów
figure-lobes = liczba garbów
figure-point = punkt
figure-normal = normalna
figure-normal-length = długość normalnej
figure-wave-length = długość fali
figure-wave-amplitude = amplituda fali
figure-wave-direction = kierunek fali
figure-deviation = odchyłka
figure-radius = promień
figure-width = szerokość
figure-first-length = długość 1
figure-second-length = długość 2
figure-angle = kąt
figure-top = góra
figure-bottom = dół
figure-length = długość ścianek
figure-reach = zasięg
figure-stylus-radius = promień trzpienia

## What of the probe touches.
mover-ball = kulka
mover-stylus = trzpień
