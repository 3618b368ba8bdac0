## AQDEF of Q-DAS
aqdef-line = oczekiwany klucz i tekst, np. K0001/1 25.012, lub linia wartości
aqdef-number = { $key }: { $reason }
aqdef-whole = { $key }: { $given } nie jest liczbą całkowitą
aqdef-undeclared = wartość charakterystyki { $number }, której nie zadeklarowano przed tą linią
aqdef-of-all = { $key } z numerem 0 byłby wartością każdej charakterystyki: pominięto
aqdef-cut-off = plik kończy się tu bez końca linii, więc { $given } może być ucięte: pominięto; jeśli jest kompletne, dodać koniec linii
aqdef-zeros = linia ma bajty o wartości 0, więc plik nie został zapisany w całości: linię pominięto
aqdef-mark-between = K0002/0 { $given } jest między tym wierszem a poprzednim i może dotyczyć każdego z nich: wartość pominięto
aqdef-twice = { $key } podano dwa razy z różnymi tekstami, wcześniej { $other }: wartości tej charakterystyki nie są oceniane
aqdef-fields = oczekiwana liczba pól w wartości najwyżej { $most }, jest { $found }
aqdef-no-values = { $count ->
        [0] ani charakterystyk, ani wartości
        [one] 1 charakterystyka bez wartości: to plan, a nie pomiary
        [few] { $count } charakterystyki bez wartości: to plan, a nie pomiary
        [many] { $count } charakterystyk bez wartości: to plan, a nie pomiary
       *[other] { $count } charakterystyk bez wartości: to plan, a nie pomiary
    }
aqdef-no-values-beside = { $count ->
        [0] ani charakterystyk, ani wartości
        [one] 1 charakterystyka bez wartości
        [few] { $count } charakterystyki bez wartości
        [many] { $count } charakterystyk bez wartości
       *[other] { $count } charakterystyk bez wartości
    }, a obok tego pliku nie ma { $file } do { $most } MiB: to plan, a nie pomiary; jeśli { $file } jest większy, podać jego
aqdef-no-description = wartości bez charakterystyk: obok tego pliku brakuje { $file }
aqdef-count = K0100 zapowiada charakterystyki: { $expected }, jest { $found }: plik może być ucięty
aqdef-too-large = charakterystyki zajmują więcej niż { $most } MiB
aqdef-beside = { $file }, linia { $line }: { $reason }
aqdef-warning-count = K0100 zapowiada charakterystyki: { $expected }, jest { $found }: plik może być ucięty
aqdef-warning-fewer = oczekiwana liczba wartości { $expected }, jest { $found }
aqdef-warning-missing = { $count ->
        [one] 1 wartość jest pusta lub oznaczona jako brakująca (K0002 to 255 lub 256), od tej linii: pominięto ją
        [few] { $count } wartości są puste lub oznaczone jako brakujące (K0002 to 255 lub 256), od tej linii: pominięto je
        [many] { $count } wartości jest pustych lub oznaczonych jako brakujące (K0002 to 255 lub 256), od tej linii: pominięto je
       *[other] { $count } wartości jest pustych lub oznaczonych jako brakujące (K0002 to 255 lub 256), od tej linii: pominięto je
    }
aqdef-warning-skipped = pominięte pozycje: { $keys }
aqdef-warning-repeated = { $key } podano dwa razy z różnymi tekstami: użyto tego
aqdef-warning-late = { $key } nie należy do wartości odczytanej tuż przed nim: pominięto
aqdef-warning-allowance = z wymiaru nominalnego i odchyłki wynika { $limit }, ale granica jest inna: obowiązuje granica
aqdef-warning-tolerance = { $key } ma tolerancję { $given } mm, a z granic wynika { $expected } mm: obowiązują granice
aqdef-warning-no-limit = podano { $key }, ale K2120 lub K2121 mówi, że takiej granicy nie ma: pominięto
aqdef-warning-kind-of-limit = { $given } nie jest znanym rodzajem granicy (0, 1 lub 2): odczytano jako granicę
aqdef-warning-scrap-limit = granica braku { $limit } różni się od granicy: pominięto ją, a wartość poza granicą po tej stronie to brak
aqdef-warning-scrap-feature = granica braku jest granicą { $feature ->
        [hole] otworu
       *[shaft] wałka
    }, a { $callout } nie: obowiązuje klasa tolerancji
aqdef-warning-cut-off = plik kończy się tu bez końca linii, a { $given } jest krótsze niż pozostałe: może być ucięte
aqdef-warning-zeros = plik ma tu bajty o wartości 0, więc nie został zapisany w całości: może brakować wartości
aqdef-warning-values-left = { $file } ma { $count ->
        [one] 1 linię wartości, która nie jest czytana
        [few] { $count } linie wartości, które nie są czytane
        [many] { $count } linii wartości, które nie są czytane
       *[other] { $count } linii wartości, które nie są czytane
    }
aqdef-warning-values-beside = wartości pochodzą z { $file } obok tego pliku i numery linii odnoszą się do niego
aqdef-warning-description-beside = charakterystyki pochodzą z { $file } obok tego pliku
aqdef-warning-beside = { $file }, linia { $line }: { $reason }
