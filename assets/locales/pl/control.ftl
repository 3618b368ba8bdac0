# control

# Masks
mask-empty = maska jest pusta
mask-too-large = maska jest większa niż { $most } KiB
mask-unknown = { $found } nie jest rekordem, słowem kluczowym ani komentarzem
mask-unclosed-quote = cudzysłów nie jest zamknięty
mask-unknown-format = { $found } nie jest formatem: dozwolone są %S %RS %F %LF %D %I %%
mask-too-wide = { $found } jest za szeroki: najwyżej { $most }
mask-count = liczba formatów { $formats }, liczba parametrów { $parameters }
mask-unknown-parameter = { $found } nie jest parametrem: dozwolone są Q, QL, QR, QS z numerem, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = brakuje ; na końcu
mask-unknown-word = { $word } jest nieznane i nie działa
mask-behind-semicolon = { $found } po ; pominięto
mask-other-languages = maska ma tekst dla { $languages }, a nie ma dla { $wanted }
mask-inverse-touching = { $first } i { $second } są drukowane bez niczego pomiędzy, więc wydruku nie można odczytać z powrotem
mask-inverse-blanks = { $first } i { $second } to teksty, między którymi są tylko spacje, więc wydruku nie można odczytać z powrotem: tekst może zawierać spacje
mask-inverse-no-mark = żaden stały tekst nie oznacza początku rekordu, więc wydruku nie można odczytać z powrotem
mask-inverse-too-long = maska drukuje więcej niż { $most } { $most ->
        [one] linię
        [few] linie
        [many] linii
       *[other] linii
    } naraz: z powrotem można odczytać tylko krótsze rekordy
mask-inverse-no-number = maska nie drukuje liczby, która mogłaby być wartością zmierzoną
mask-undefined = { $name } jest niezdefiniowany
mask-text-as-number = { $name } to tekst, format wymaga liczby
mask-number-as-text = { $name } to liczba, format wymaga tekstu
mask-not-finite = { $name } nie jest liczbą skończoną
# Measuring logs
log-empty = plik jest pusty
log-no-log = to nie protokół pomiaru: nie ma linii tytułu z numerem cyklu pomiarowego
log-too-long = protokół ma więcej niż { $lines } { $lines ->
        [one] linię
        [few] linie
        [many] linii
       *[other] linii
    } lub linię dłuższą niż { $bytes } { $bytes ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }
log-no-title = protokół nie ma linii tytułu, więc cykl jest nieznany
log-other-cycle = protokołów cyklu { $cycle } nie można czytać, tylko { $known }
log-unit = rodzaj miary { $given } to ani 0 (mm), ani 1 (cal)
log-count = { $section }: oczekiwane { $expected }, jest { $found }
log-missing = brakuje: { $section }; protokół jest ucięty lub niekompletny
log-no-label = przed { $given } nie ma opisu
log-cut-figure = plik kończy się w tej wartości: { $given } może być niekompletne
log-swapped = maksimum { $maximum } jest poniżej minimum { $minimum }
log-uneven = granice { $minimum } i { $maximum } nie są symetryczne względem wartości nominalnej { $nominal }
log-deviation = odchyłka { $given } to nie wartość rzeczywista minus nominalna, { $actual } - { $nominal }
log-not-positive = średnica { $given } nie jest większa od 0
log-section-nominal = sekcja wartości nominalnych
log-section-limits = sekcja wartości granicznych
log-section-actual = sekcja wartości rzeczywistych
log-section-deviations = sekcja odchyłek
log-no-unit = żadna linia nie podaje jednostki: przyjęto milimetry
log-no-time = data i godzina pomiaru są nieznane
log-no-deviations = brakuje odchyłek: protokół może być ucięty
log-ignored = pominięto: { $text }
log-text-before = pominięto tekst przed pierwszym protokołem

## Tables
table-empty = plik jest pusty
table-not-text = znak { $code } nie jest tekstem: plik nie jest tabelą lub jest uszkodzony
table-line-too-long = linia jest dłuższa niż { $limit } { $limit ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }
table-too-large = tabela ma więcej niż { $limit } { $limit ->
        [one] komórkę
        [few] komórki
        [many] komórek
       *[other] komórek
    }
table-too-many-columns = tabela ma więcej niż { $limit } { $limit ->
        [one] kolumnę
        [few] kolumny
        [many] kolumn
       *[other] kolumn
    }
table-no-begin = tabela zaczyna się od BEGIN i nazwy, a nie od { $found }
table-no-name = po BEGIN brakuje nazwy tabeli
table-unclosed-quote = cudzysłów nie jest zamknięty
table-unclosed-block = blok { $block } z linii { $line } nie jest zamknięty
table-second-block = kolumny opisano drugi raz
table-unexpected = oczekiwane { $expected }, jest { $found }
table-not-a-size = { $key } musi być liczbą całkowitą do { $limit }, a nie { $text }
table-no-columns = brakuje linii z nazwami kolumn
table-tab = znak tabulacji: rozdzielać kolumny tylko spacjami
table-column-twice = kolumna { $name } występuje dwa razy
table-short-row = wiersz kończy się przed kolumną { $name }: uzupełnić spacjami lub wpisać - jako „bez wartości”
table-truncated = plik kończy się w tym wierszu i bez [END]: może być ucięty
table-text-after-end = tekst po [END]: { $found }
table-no-end = brakuje [END]
table-no-lock = tabela narzędzi nie ma kolumny TL: złamane narzędzie nie zostanie w niej zablokowane
table-no-unit = tabela nie podaje jednostki: jej długości odczytano w milimetrach
table-begin-word = { $word } w linii BEGIN nie ma znanego znaczenia
table-width = kolumna { $name } ma tu szerokość { $found }, a w opisie { $described } (w znakach); obowiązuje linia z nazwami kolumn
table-not-in-table = kolumnę { $name } opisano, ale nie ma jej w tabeli
table-not-described = kolumny { $name } nie opisano
table-skipped = { $name } jest nieznane i zostało pominięte
table-write-too-wide = wiersz { $row }, kolumna { $column }: { $text } nie mieści się, szerokość w znakach: { $width }
table-write-too-many-columns = liczba kolumn tabeli: { $columns }; iTNC 530 przyjmuje najwyżej { $limit }
table-write-too-long = liczba znaków w liniach tabeli: { $characters }; iTNC 530 przyjmuje najwyżej { $limit }
table-write-reads-otherwise = tabeli nie można zapisać tak, aby odczytać ją tak samo: sprawdzić nazwy tabeli i kolumn

## Tables of deviations
deviations-no-tables = w tym folderze nie ma tabeli odchyłek (*.tab z kolumną BEREICH): { $folder }
tables-contradict = { $first } i { $second } są sprzeczne, { $class } ponad { $over } do { $to } mm: { $one ->
        [none] bez wartości
       *[other] { $one } µm
    } i { $other ->
        [none] bez wartości
       *[other] { $other } µm
    }: usunąć kolumnę z jednej z nich
deviations-two-range-columns = tabela ma i BEREICH, i BEREIK: zakresy wymiarów może zawierać tylko jedna
deviations-inch = tabela jest w calach: wpisać zakresy wymiarów w milimetrach i odchyłki w mikrometrach
deviations-no-class = żadna kolumna nie jest klasą tolerancji, np. H7
deviations-odd-rows = liczba wierszy jest nieparzysta ({ $rows }): każdy zakres wymiarów ma dwa, najpierw odchyłka górna, potem dolna
deviations-no-range = brakuje końca zakresu wymiarów
deviations-other-range = zakres wymiarów do { $end } mm ma w drugim wierszu { $found }: powtórzyć wartość lub zostawić puste
deviations-column = kolumna { $column }: { $error }
deviations-half = kolumna { $class } ma tylko jedną z dwóch odchyłek dla zakresu wymiarów do { $end } mm
deviations-touches = kolumna { $column } i sąsiednia stykają się: rozdzielić je spacją
deviations-no-deviations = pominięto, to nie tabela odchyłek (bez kolumny BEREICH): { $file }
deviations-range-alias = BEREIK odczytano jako BEREICH
deviations-other-column = pominięto kolumnę { $name }, bo jej nazwa nie może być klasą tolerancji: tabela zapisana z tej jej nie ma
deviations-no-numbers = pominięto kolumnę { $name }, bo zawiera teksty zamiast odchyłek: tabela zapisana z tej jej nie ma
deviations-mixed-case = pominięto kolumnę { $name }, bo klasa tolerancji nie miesza wielkich i małych liter: tabela zapisana z tej jej nie ma

## Parameters
no-parameter = { $given } nie jest parametrem: dozwolone są Q, QL, QR i QS z numerem

## Writing measuring logs
log-write-cycle = cykl { $cycle } nie zapisuje tych wartości
log-write-no-title = protokół cyklu { $cycle } nie ma tytułu w { $file }
log-write-unit = protokół jest w mm lub calach, nie w µm
log-write-character = { $given } nie można zapisać: protokół nie może zawierać znaku U+{ $code }
log-write-program = { $given } nie dałoby się odczytać jako ścieżki programu: wpisać ścieżkę, np. TNC:\PART\CHECK.H
log-write-unfinished = plik kończy się w środku linii: może być ucięty, więc niczego do niego nie dodano
log-write-reads-otherwise = protokołu nie można zapisać tak, aby odczytać go tak samo: sprawdzić datę, godzinę i dalsze wyniki

## Log of cycle 444
point-log-no-log = to nie protokół cyklu 444: strona nie zawiera pomiaru czytelnego dla programu
point-log-count = strona podaje, że pomiarów jest { $expected }, a jest { $found }: jest ucięta lub zmieniona
point-log-cut-off = pomiar nie ma końca: strona jest ucięta
point-log-json = nie można odczytać pomiaru: { $what }
point-log-version = wersja protokołu { $version } nie jest obsługiwana: oczekiwana { $known } lub starsza
point-log-normal = normalna { $given } nie ma kierunku: potrzebne są trzy liczby, nie wszystkie 0
point-log-deviation = odchyłka { $given } w { $axis } to nie współrzędna zmierzona minus nominalna, { $difference }
point-log-along = odchyłka { $given } wzdłuż normalnej nie wynika z odchyłek osi, { $along }
point-log-band = odchyłka górna { $upper } jest poniżej dolnej { $lower }
point-log-status = status { $given } nie wynika z odchyłki i tolerancji, { $status }
## The touch-probe table
probe-table-no-column = tabela nie ma kolumny { $column }
probe-table-no-probe = tabela nie ma sondy
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: musi być { $least }
probe-table-zero-or-more = co najmniej 0
probe-table-above-zero = większe od 0
probe-table-not-whole = { $column } = { $given }: oczekiwana liczba całkowita
probe-table-twice = sonda { $number } występuje dwa razy

## The tool table
tool-table-no-column = tabela nie ma kolumny { $column }
tool-table-no-tool = tabela nie ma narzędzia
tool-table-touches = { $column }: komórka wchodzi na sąsiednią, więc jej wartość jest niepewna
tool-table-no-number = { $column } = { $given }: oczekiwany numer narzędzia od 0 do 32767, z indeksem, np. 5.1, lub bez
tool-table-twice = narzędzie { $number } występuje dwa razy
tool-table-name-too-long = NAME = { $given }: nazwa ma najwyżej { $most } { $most ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    }
tool-table-no-length = { $column }: { $error }
tool-table-out-of-range = { $column } = { $given } mm: oczekiwane od { $least } do { $most } mm
tool-table-no-lock = TL = { $given }: oczekiwane L lub 1 dla narzędzia zablokowanego; 0, - lub nic dla wolnego
tool-table-not-whole = { $column } = { $given }: oczekiwana liczba całkowita
tool-unknown = Q330 = { $tool }: w tabeli narzędzi nie ma takiego narzędzia; są { $known }
tool-no-deviation = Q330 = { $tool }: cykl { $cycle } nie ma tu granic, więc nie ma odchyłki do korekcji narzędzia
tool-out-of-range = narzędzie { $tool }: { $column } zmieniłoby się z { $from } na { $to } mm: największa wartość to { $most } mm w obie strony
tool-broken = błąd 1065: narzędzie { $tool } jest złamane: { $column } zmieniłoby się o { $by } mm, { $limit } to { $most } mm; narzędzie zablokowano bez korekcji
tool-broken-replacement = błąd 1065: narzędzie { $tool } jest złamane: { $column } zmieniłoby się o { $by } mm, { $limit } to { $most } mm; narzędzie zablokowano bez korekcji; narzędzie zamienne to { $replacement }
tool-corrected = narzędzie { $tool }: { $column } zmieniono o { $by } mm, z { $from } na { $to } mm
tool-corrected-rounded = narzędzie { $tool }: { $column } zmieniono o { $by } mm, z { $from } na { $to } mm: tabela zapamiętuje najbliższe 0,00001 cala
tool-locked = narzędzie { $tool }: zablokowane, TL = { $to }

## The log of a cycle's result
cycle-log-other-verdict = wartości protokołu, zaokrąglone do 0,0001 { $unit }, dają { $log }, a cykl dał { $cycle }

## The block of a probing cycle
block-none = to nie cykl próbkowania: wiersz NC zaczyna się od TCH PROBE i numeru lub od G785
block-inches = wiersz NC należy do programu w calach, a byłby czytany w mm: wykonać program
block-none-at = ten wiersz nie należy do żadnego cyklu pomiarowego: zaczynają się w wierszach { $blocks }
block-second = drugi cykl próbkowania: podawać po jednym; pierwszy zaczyna się w linii { $first }
block-unknown-cycle = TCH PROBE { $given }: cykle to { $known }
block-not-a-parameter = { $given } nie jest parametrem: wpisać jako { $example }
block-no-value = { $key } nie ma wartości
block-twice = { $key } podano dwa razy, pierwszy raz w linii { $first }
block-unclosed-quote = cudzysłów nie jest zamknięty
block-behind-end = { $given } jest po końcu wiersza NC: każda linia oprócz ostatniej kończy się znakiem ~
block-too-many-parts = linia ma więcej niż { $most } { $most ->
        [one] część
        [few] części
        [many] części
       *[other] części
    } między ~
block-cut-off = wiersz NC kończy się znakiem ~, więc brakuje linii: może być ucięty
block-reference = { $key } = { $given }: wartość { $given } jest znana tylko podczas wykonania programu
block-not-writable = { $key } = { $given }: tekst w wierszu NC nie może zawierać cudzysłowów ani końców linii
block-unused = linia { $line }: { $text } nie należy do cyklu próbkowania i zostało pominięte
block-unused-more = linia { $line }: { $text } nie należy do cyklu próbkowania i zostało pominięte, podobnie jeszcze { $more }
