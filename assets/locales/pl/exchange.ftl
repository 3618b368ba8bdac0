# exchange

# Measurements from files
exchange-format-logs = protokoły pomiaru HEIDENHAIN, np. TCHPR421.TXT
exchange-format-log-444 = protokoły próbkowania w 3-D zapisane przez Fitcheck
exchange-format-fn16 = wydruk FN 16 ze sterowania, czytany przez jego maskę (--mask)
exchange-format-series-table = tabela sterowania, którą program wypełnia przez FN 27, jeden wiersz na część
exchange-format-contacts = punkty pomiarowe jednego okręgu: x, y i opcjonalnie z
exchange-format-measurements = pomiary w CSV: id, callout, measured
exchange-empty = plik jest pusty
exchange-not-recognised = to nie jest plik znanego formatu
exchange-model-not-read = model { $format }: Fitcheck nie czyta modeli; wyeksportować wartości zmierzone jako CSV, XLSX, QIF lub AQDEF
exchange-drawing-not-read = rysunek { $format }: Fitcheck nie czyta rysunków; wyeksportować wymiary jako CSV lub XLSX
exchange-document-not-read = dokument { $format }: Fitcheck nie czyta dokumentów; wyeksportować wartości jako CSV, XLSX, QIF lub AQDEF
exchange-image-not-read = obraz { $format }: Fitcheck nie czyta obrazów; wyeksportować wartości jako CSV, XLSX, QIF lub AQDEF
exchange-archive-not-read = archiwum { $format }: rozpakować i podać pliki z niego
exchange-no-sheet = skoroszyt nie ma arkusza { $given }; ma { $sheets }
exchange-other-format = to { $format }, a nie pomiary w CSV
exchange-parquet-unknown = ten program zbudowano bez Parquet: cargo build --release bez dalszych opcji go zawiera
exchange-parquet-stream = Parquet podaje kolumny na końcu pliku i nie można go czytać z potoku: podać nazwę pliku
exchange-parquet = nie można odczytać tego pliku Parquet: { $reason }
exchange-parquet-nested = kolumna { $column } zawiera kolumny lub listy: oceniać można tylko kolumny pojedynczych wartości
exchange-mask-backwards = { $mask }: { $reason }
exchange-mask-none = żadna z podanych masek nie drukuje takiego pliku: { $masks }
exchange-mask-several = kilka masek drukuje taki plik; podać tylko tę, która go zapisała: { $masks }
exchange-mask-no-measured = { $mask } nie drukuje wartości zmierzonej: Fitcheck rozpoznaje Q153 do Q156, Q160 oraz każdą inną liczbę z wydrukowanym obok wymiarem tolerowanym
exchange-mask-measured = { $mask }: wartością zmierzoną może być każde z: { $fields }; drukować wynik cyklu, np. Q153; w przeciwnym razie plik wymaga wymiarów tolerowanych o różnych granicach
exchange-print-ambiguous = maska może to odczytać na kilka sposobów
exchange-print-broken = rekord kończy się za wcześnie: oczekiwany wydruk linii { $line } maski
exchange-print-other = maska nie drukuje takiej linii, ale są w niej liczby: może to być rekord z brakującą lub zmienioną wartością; popraw ją lub usuń
exchange-print-unit = linia { $line } podaje { $unit }, ale wydruk ze sterowania jest czytany w mm: drukować wartości w mm
exchange-table-no-part = żadna kolumna nie mówi, której części dotyczy wiersz: tabela serii wymaga kolumny takiej jak PART lub SERIAL
exchange-table-no-values = żadna kolumna nie zawiera wartości zmierzonych
exchange-table-no-value = nie wiadomo, która kolumna { $name } jest wartością zmierzoną
exchange-table-touches = komórka w kolumnie { $column } styka się z sąsiednią, jedna z nich może być źle rozdzielona: rozdziel je odstępem
exchange-table-unit = tabela jest w calach, a kolumna { $column } nie jest typu LENGTH, więc jej wartości mogą być w mm: użyj typu LENGTH
exchange-no-rows = żaden wiersz nie zawiera pomiaru
exchange-no-measured-column = nie ma kolumny wartości zmierzonych: nazwać ją w pierwszej linii, np. id;callout;measured
exchange-several-columns = każda z kolumn { $columns } może zawierać: { $role }; wybrać jedną przez import --columns, np. { $word }=3, lub nazwać kolumny w pierwszej linii tak, aby pasowała tylko jedna, np. id;callout;measured
exchange-role-id = nazwa
exchange-role-tolerance = wymiar tolerowany
exchange-role-nominal = wymiar nominalny
exchange-role-measured = wartość zmierzona
exchange-role-time = czas
exchange-role-simulated = znacznik symulacji
exchange-role-number = numer
exchange-role-part = część
exchange-role-serial = numer seryjny
exchange-role-who = operator
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = co zmierzono
exchange-role-upper = odchyłka górna
exchange-role-lower = odchyłka dolna
exchange-role-minus = odchyłka dolna bez minusa
exchange-role-maximum = wymiar graniczny górny
exchange-role-minimum = wymiar graniczny dolny
exchange-role-kind = otwór lub wałek
exchange-role-units = jednostka
exchange-role-status = stan
exchange-role-machine = maszyna
exchange-role-batch = partia
exchange-role-sample = próbka
exchange-no-column = { $role }: oczekiwana kolumna { $given }, ale plik ma { $columns }
exchange-column-twice = kolumna { $column } nie może jednocześnie zawierać: { $first } i { $second }
exchange-unit = nieznana jednostka { $unit }: użyć mm, µm lub cala (inch)
exchange-limit = granica: { $reason }
exchange-tolerance-unsigned = tolerancja { $given } nie ma znaku: wpisać ±{ $given } albo obie odchyłki, np. +0.02 0
exchange-minus-again = odchyłka dolna { $given } ma minus, a inne go nie mają: wpisać wszystkie ze znakiem
exchange-limits-contradict = { $callout } ma granice od { $minimum } do { $maximum }, ale kolumny podają { $given }: aby oceniać według wymiaru, podać --columns { $columns }, według kolumn --columns callout=-
exchange-limits-or-deviations = kolumny { $columns } mogą być granicami albo odchyłkami od wymiaru nominalnego: wybrać przez --columns, np. maximum={ $upper },minimum={ $lower } albo upper={ $upper },lower={ $lower }
exchange-limits-or-readings = kolumny { $columns } mogą być granicami albo największym i najmniejszym z kilku odczytów: wybrać przez --columns, np. maximum={ $upper },minimum={ $lower } dla granic albo maximum=-,minimum=- dla odczytów
exchange-minus-or-plus = odchyłki dolne w kolumnie { $columns } nie mają znaku: wybrać przez --columns, minus={ $lower } dla poniżej wymiaru nominalnego albo lower={ $lower } dla powyżej
exchange-samples-side-by-side = kilka wartości zmierzonych stoi obok siebie w kolumnach { $columns }: odczytać je przez fitcheck import albo wybrać jedną przez --columns, np. measured={ $first }
exchange-unit-stated = linia { $line } podaje nieobsługiwaną jednostkę { $unit } („{ $text }”): użyć mm, µm lub inch albo wybrać jednostkę wymiarów (--columns unit=mm)
exchange-unit-mentioned = linia { $line } wspomina { $unit } („{ $text }”), ale nic nie mówi, czy wartości są w tej jednostce: wybrać jednostkę wymiarów (--columns unit=mm, um lub inch)
exchange-units-differ = „{ $at }” podaje { $unit }, „{ $other-at }” podaje { $other }: poprawić jedno z nich
exchange-unit-late = linia { $line } podaje { $unit } („{ $text }”), ale wiersze powyżej są czytane w { $read }: podać jednostkę nad pierwszym wierszem lub poprawić tę linię
exchange-unit-stray = ta linia podaje { $unit } („{ $text }”), ale wszystkie inne wiersze są czytane w { $read }: podać jednostkę nad pierwszym wierszem lub poprawić tę linię
exchange-unit-given = wybrana jednostka to { $given }, a plik podaje { $unit } („{ $text }”): wybrać { $unit } lub poprawić plik
exchange-unit-half = kolumna { $column } jest w calach, a kolumna { $open } nie podaje jednostki: wpisać ją przy obu nazwach lub wybrać jednostkę wymiarów (--columns unit=inch)
exchange-unit-missing = brakuje jednostki tego wiersza: wpisać mm, µm lub inch albo wybrać jednostkę wymiarów (--columns unit=mm)
exchange-callout-unit = { $given }: wiersz jest w calach, a wymiar tolerowany z wymiarem lub odchyłkami jest w mm: umieścić wymiar nominalny w osobnej kolumnie obok klasy
exchange-row-short = oczekiwana liczba komórek { $expected }, jest { $found }
exchange-row-long = oczekiwana liczba komórek { $expected }, jest { $found }: czy separator jest też znakiem dziesiętnym lub stoi w tekście?
exchange-row-too-long = wiersz jest dłuższy niż { $most } KiB
exchange-open-quote = cudzysłów w tej linii nie jest zamknięty
exchange-header-hides-rows = linia { $line }: nagłówek zajmuje kilka linii, a jedna z nich wygląda jak wiersz: zamknąć cudzysłowy w linii, w której się otwierają
exchange-within-quotes = ta linia może być wierszem lub uwagą: cudzysłów otwiera się powyżej i zamyka tu lub poniżej; zamknąć go w linii, w której się otwiera
exchange-callout = wymiar tolerowany: { $reason }
exchange-nominal = wymiar nominalny: { $reason }
exchange-nominal-differs = wymiar tolerowany { $callout } nie zgadza się z wymiarem nominalnym { $nominal } w osobnej kolumnie
exchange-measured = wartość zmierzona: { $reason }
exchange-simulated = simulated: { $given } nie jest ani true, ani false
exchange-other-header = ta linia podaje inne kolumny niż pierwsza: ocenić wiersze poniżej jako osobny plik
exchange-below-other-header = nie oceniono: linia { $line } podaje inne kolumny. Ocenić wiersze poniżej jako osobny plik
exchange-simulated-below = wiersze poniżej tej linii są symulowane: ocenić je jako osobny plik lub przez fitcheck import
exchange-origin = origin: { $given } nie mówi, czy zmierzono, czy symulowano; wpisać measured, typed lub simulated, albo ustawić simulated=-, jeśli kolumna mówi o czymś innym
exchange-decimal-sign = wartość zmierzona: { $given } ma inny znak dziesiętny niż pozostałe wartości: "{ $sign }"
exchange-not-positive = wartość zmierzona: średnica { $given } nie jest większa od 0
exchange-decimal-comma = { $joined } może być jedną liczbą z przecinkiem dziesiętnym: użyć kropki dziesiętnej lub innego separatora
exchange-other-feature = { $given } to { $feature ->
        [hole] wałek, a to są otwory: czy pliki są zamienione?
       *[shaft] otwór, a to są wałki: czy pliki są zamienione?
    }
exchange-rejected = sam plik odrzuca tę wartość ({ $given }): usunąć wiersz lub poprawić w pliku
exchange-no-part = { $given } oznacza liczbę dla kilku części lub wzorzec nastawczy przyrządu, a nie część: usunąć wiersz lub nadać części inną nazwę
exchange-other-log = { $feature ->
        [hole] to protokół wałka, a to są otwory: czy pliki są zamienione?
       *[shaft] to protokół otworu, a to są wałki: czy pliki są zamienione?
    }
exchange-not-a-size = { $what }: tego wymiaru nie można parować
exchange-no-place-axis = leży wzdłuż { $axis }, a cykle 421 i 422 próbkują wzdłuż Z
exchange-no-place-no-axis = plik nie mówi, wzdłuż której osi leży
exchange-no-place-kind = { $kind }: cykle 421 i 422 próbkują tylko okręgi i walce
exchange-no-place-system = jest sprawdzany w układzie współrzędnych { $system }, a współrzędne odnoszą się do układu pliku
exchange-contacts-not-sizes = wiersze z dwiema lub trzema liczbami to punkty pomiarowe: nazwać kolumny w pierwszej linii, np. id;measured
exchange-too-many-rows = odczytano tylko początek, liczba wierszy: { $most }; podzielić plik
exchange-unjudged-no-callout = nie oceniono: nie podano wymiaru tolerowanego
exchange-unjudged-no-limits = nie oceniono: wymiary graniczne w protokole to 0, więc średnica nie była monitorowana
exchange-unjudged-coordinate = współrzędna z cyklu { $cycle }, nie otwór ani wałek
exchange-unjudged-coordinate-without-limits = nie oceniono: granice w protokole to 0, więc współrzędna nie była monitorowana
exchange-unjudged-size = { $what } z cyklu { $cycle }, nie otwór ani wałek
exchange-unjudged-size-without-limits = nie oceniono: granice w protokole to 0, więc nie monitorowano: { $what }
exchange-unjudged-point = punkt powierzchni z cyklu { $cycle }: jego odchyłka wzdłuż normalnej nie jest wymiarem
exchange-unjudged-point-without-tolerance = nie oceniono: punkt próbkowano bez tolerancji
exchange-unjudged-contacts = nie oceniono: punkty pomiarowe ({ $count }) bez wymiaru tolerowanego
exchange-warning-ignored-columns = pominięte kolumny: { $columns }
exchange-warning-quantity-unknown = kolumna { $column } nie ma znanego słowa na to, co zmierzono ({ $words }): wszystkie wartości są czytane jako wymiary; jeśli to prawda, podać import --columns quantity=-
exchange-warning-not-used = pominięto, to nie pomiar: { $text }
exchange-warning-minus-supplied = kolumna { $column } nie ma minusów: jej wartości są czytane jako odchyłki dolne poniżej wymiaru nominalnego
exchange-warning-callouts-unnamed = kolumna { $column } wygląda na kolumnę wymiarów tolerowanych, ale jej nazwa nie jest znana: nazwij ją callout albo podaj jej numer przez --columns, na przykład callout=2
exchange-warning-limits-read = kolumny { $columns } są czytane jako granice
exchange-warning-head-read = odczytano dla wszystkich wartości: { $said }
exchange-warning-samples-read = kolumny { $columns } są czytane jako części obok siebie: każda wartość jest oceniana osobno, pusta komórka nie jest wartością, a bez numerów seryjnych każda kolumna to osobna część
exchange-warning-comment = linia zaczynająca się od # jest komentarzem, ale ta zawiera pomiar
exchange-warning-several-lines = liczba linii, które zajmuje wiersz w cudzysłowie: { $lines }
exchange-warning-time = { $given } nie jest datą i godziną: użyto czasu importu
exchange-warning-place = { $given } nie jest długością: położenie pominięto
exchange-warning-no-time = nie ma tu daty i godziny: użyto czasu importu
exchange-warning-offset = { $given } zapisano jako czas lokalny bez przesunięcia względem UTC
exchange-warning-cut-off = plik kończy się tu bez końca linii, a { $given } ma mniej miejsc po przecinku niż pozostałe wartości: może być ucięty
exchange-warning-open-end = plik kończy się tu bez końca linii: ostatnia wartość, { $given }, może być ucięta

# Contacts
contacts-file-empty = plik nie zawiera punktów pomiarowych
contacts-no-columns = nagłówek musi podawać x i y, może też z; jest { $given }
contacts-twice = kolumny { $first } i { $second } to obie { $name }
contacts-cells = oczekiwana liczba komórek { $wanted }, jest { $cells }: { $given }
contacts-not-a-number = { $name } to { $given }, a nie liczba milimetrów
contacts-row-too-long = wiersz jest dłuższy niż { $most } KiB
contacts-comment = linia zaczynająca się od # jest komentarzem, ale ta zawiera współrzędne: usunąć # lub całą linię
contacts-other-unit = punkty pomiarowe są w mm, ale ta linia podaje { $given }: przeliczyć je na mm
contacts-too-many = plik ma więcej niż { $most } { $most ->
        [one] punkt pomiarowy
        [few] punkty pomiarowe
        [many] punktów pomiarowych
       *[other] punktów pomiarowych
    }
contacts-simulated = te punkty pomiarowe są symulowane i niczego nie mierzą: użyć pliku detalu
contacts-origin = { $given } nie mówi, czy zmierzono, czy symulowano: wpisać measured lub simulated albo usunąć kolumnę
contacts-open-quote = cudzysłów nie jest zamknięty
contacts-mixed-signs = { $given } ma inny znak dziesiętny niż wiersze powyżej

## Tables of deviations
table-format-name = { $name } nie zaczyna się od litery: na TNC7 nazwy tabel muszą
table-format-operator = { $name } zawiera { $sign }: na TNC7 nazwy tabel nie mogą mieć operatorów arytmetycznych
table-format-warning-lower-sign = podręcznik PC-DMIS pokazuje tylko odchyłkę dolną 0: przed użyciem sprawdzić { $class } w PC-DMIS, zwłaszcza znaki
table-format-csv = nie można zapisać CSV: { $reason }
table-format-parquet-unknown = ten program zbudowano bez Parquet: cargo build --release bez dalszych opcji go zawiera
table-format-parquet = nie można zapisać pliku Parquet: { $reason }
table-format-itnc530 = tabela sterowania dla iTNC 530
table-format-tnc640 = tabela sterowania dla TNC 620 i TNC 640
table-format-tnc7 = tabela sterowania dla TNC7
table-format-plain-csv = CSV, linia na każdą klasę i zakres wymiarów
table-format-plain-parquet = Parquet, wiersz na każdą klasę i zakres wymiarów
table-format-pcdmis = CSV tolerancji ISO dla PC-DMIS

## Limits as SQL
sql-border = tabela { $table }: zakres wymiarów kończy się na { $end } mm; w SQL zakresy muszą kończyć się na całych milimetrach
sql-too-far = tabela { $table }: zakres wymiarów kończy się na { $end } mm; w SQL zakresy muszą kończyć się najdalej na { $most } mm
sql-twice = klasę { $class } podano dwa razy
exchange-correction = wartość dla 20 °C nie wynika z wartości zmierzonej i jej temperatur: oczekiwane kolumny tak, jak zapisuje je Fitcheck
exchange-warning-corrected = wartości z liczbą w kolumnie as_measured_mm już dotyczą 20 °C
sizes-warning-named-twice = { $rows ->
        [one] jeden wiersz ma nazwę wcześniejszego
        [few] { $rows } wiersze mają nazwę wcześniejszego
        [many] { $rows } wierszy ma nazwę wcześniejszego
       *[other] { $rows } wierszy ma nazwę wcześniejszego
    }, np. { $id } w liniach { $first } i { $second }: każdy wiersz liczy się jako część
sizes-warning-simulated-rows = { $count ->
        [one] 1 wiersz jest symulowany
        [few] { $count } wiersze są symulowane
        [many] { $count } wierszy jest symulowanych
       *[other] { $count } wierszy jest symulowanych
    }: niczego nie zmierzono
exchange-position-out = środek był poza pozycją, ale plik ma tylko wymiar
exchange-undecided = tu niczego nie rozstrzygnięto: { $given }
exchange-warning-other-rule = oceny w tym pliku mogą pochodzić z innej reguły decyzyjnej (kolumna rule_name): jego wartości są oceniane ponownie
exchange-read = reszty pliku nie można odczytać: { $reason }
exchange-too-large = większy niż { $most } MiB, limit dla plików tego formatu
exchange-unjudged-one-limit = nie oceniono: brakuje jednej z dwóch granic
exchange-unjudged-no-tolerance = nie oceniono: nie podano granic
exchange-unjudged-rounded = nie oceniono: wydrukowane cyfry oznaczają dowolną wartość od { $from } do { $to }, a granica leży między nimi: drukować więcej miejsc po przecinku
exchange-unjudged-implausible = nie oceniono: { $measured } mm jest niemożliwe: plan podaje od { $lower } do { $upper } mm; sprawdzić jednostkę i znak dziesiętny lub zmierzyć ponownie
exchange-unjudged-swapped-limits = nie oceniono: granica dolna { $minimum } jest powyżej górnej { $maximum }
exchange-unjudged-not-a-size = { $what }: nie jest wymiarem otworu ani wałka
exchange-warning-limits-differ = { $callout } ma granice od { $minimum } do { $maximum }, ale plik ma inne: obowiązują granice z pliku
exchange-warning-class-unknown = klasa { $given } nie ma tu granic: obowiązują granice z pliku
exchange-warning-status-differs = plik podaje { $given }, a z granic wynika { $status }
exchange-warning-status-unknown = plik podaje { $given }, co nie jest znanym statusem: z granic wynika { $status }
exchange-warning-limit-differs = plik podaje { $given }, a granice to { $minimum } do { $maximum }
exchange-warning-deviation-differs = plik podaje { $given }, ale to nie jest odchyłka { $measured } od { $nominal }
exchange-warning-feature-differs = plik podaje { $given }, ale granice są dla { $feature ->
        [hole] otworu
       *[shaft] wałka
    }
exchange-warning-temperature-differs = plik podaje { $given }, ale wartość uznano za zmierzoną przy { $counted } °C: podać --temperature i --material
exchange-warning-speaks-of-temperature = plik wspomina inną temperaturę niż { $counted } °C, w której jego wartości uznano za zmierzone: { $text }
exchange-warning-speaks-of-unit = uwaga podaje inną jednostkę niż jednostka wartości: { $text }
exchange-warning-speaks-of-simulation = ta linia wspomina o symulacji: sprawdzić, czy wartość zmierzono: { $text }
exchange-warning-all-nominal = wszystkie wartości ({ $count }) są dokładnie równe wymiarom nominalnym: to może być lista wymiarów, których nikt nie zmierzył
exchange-warning-name-of-no-size = { $given } nie jest nazwą wymiaru jednej części, ale wartość oceniono jako taki wymiar
exchange-warning-other-values = kolumny z innymi wymiarami, bliskimi zmierzonym, nie są oceniane: { $columns }
exchange-warning-part-rejected = plik podaje { $given } o całej części
exchange-warning-uncertainty-not-used = plik podaje niepewność rozszerzoną { $expanded } mm: żadna reguła jej nie używa, więc podać --u
exchange-warning-plan-differs = plik ma granice od { $minimum } do { $maximum }: obowiązują granice planu
exchange-warning-plan-differs-below = plik ma granicę dolną { $minimum }: obowiązuje granica dolna planu
exchange-warning-above-own-limit = nie z planu i powyżej górnej granicy swojego pliku, { $maximum }
exchange-warning-below-own-limit = nie z planu i poniżej dolnej granicy swojego pliku, { $minimum }
exchange-warning-plan-differs-above = plik ma granicę górną { $maximum }: obowiązuje granica górna planu
exchange-warning-plan-differs-nominal = plik ma wymiar nominalny { $nominal }: obowiązuje wymiar nominalny planu
exchange-warning-part-differs = plik podaje część { $given }: jest oceniana jako { $part }, część z planu
exchange-warning-found-by-number-of = żaden element planu nie nazywa się { $given }; według numeru dopasowano do { $name } w planie
exchange-warning-found-by-place-of = żaden element planu nie nazywa się { $given }; według położenia dopasowano do { $name } w planie
exchange-warning-found-by-number = według numeru dopasowano do { $name } w planie
exchange-warning-found-by-place = według położenia dopasowano do { $name } w planie
exchange-format-aqdef = Q-DAS AQDEF, w jednym pliku lub jako .dfd i .dfx
exchange-format-calypso = tabele charakterystyk CALYPSO, np. NAME_chr.txt
exchange-format-calypso-text = drukowane raporty CALYPSO zapisane jako tekst
exchange-format-geopak = tolerancje MCOSMOS (GEOPAK) w pliku bez nazw kolumn
exchange-format-gauge = wiersze przyrządów zapisane w pliku, np. 01A+025.012
exchange-format-pcdmis = raporty tekstowe PC-DMIS
exchange-format-probed = wydruki makr sondy, jakie zapisują Renishaw i systemy CAM
exchange-warning-unit-assumed = nie podano jednostki: długości bez jednostki są czytane w mm
exchange-warning-unit-read = długości są czytane w { $unit }, jak podaje plik: { $text }
exchange-warning-rounded = { $given } ma cyfry dalsze niż nanometr: zaokrąglono do najbliższego nanometra
exchange-warning-rounded-values = { $count ->
        [one] 1 wartość zmierzona ma cyfry dalsze niż nanometr, od tej linii: zaokrąglono ją do najbliższego nanometra
        [few] { $count } wartości zmierzone mają cyfry dalsze niż nanometr, od tej linii: zaokrąglono je do najbliższego nanometra
        [many] { $count } wartości zmierzonych ma cyfry dalsze niż nanometr, od tej linii: zaokrąglono je do najbliższego nanometra
       *[other] { $count } wartości zmierzonych ma cyfry dalsze niż nanometr, od tej linii: zaokrąglono je do najbliższego nanometra
    }
exchange-unjudged-quantity = { $quantity ->
        [102] okrągłość (K2009 to 102)
        [109] pozycja (K2009 to 109)
        [117] współrzędna (K2009 to 117)
       *[other] wielkość inna niż średnica (K2009 to { $quantity })
    }: nie jest wymiarem otworu ani wałka
exchange-unjudged-kind = nie zmierzono: { $kind ->
        [1] liczba części niezgodnych (K2004 to 1)
        [5] karta zbiorcza błędów (K2004 to 5)
        [6] karta zbiorcza błędów (K2004 to 6)
       *[other] nieznany rodzaj charakterystyki (K2004 to { $kind })
    }
exchange-unjudged-attribute = nie oceniono: oznaczono { $given } (K0002); wiadomo tylko, że 0 oznacza wartość ważną
exchange-unjudged-not-valid = nie oceniono: plik podaje { $said }, więc może nie być ważnej wartości
exchange-unjudged-declaration = nie oceniono: linii { $declaration } jego deklaracji nie można użyć
exchange-format-qif = QIF 2.0, 2.1, 3.0: wyniki oprogramowania pomiarowego oraz plany
exchange-xml = niepoprawny składniowo XML: { $reason }
exchange-xml-doctype = DOCTYPE nie jest obsługiwane: usunąć je lub wyeksportować plik bez niego
exchange-xml-entity = encja { $name } jest nieznana: obsługiwane są tylko &lt; &gt; &amp; &quot; i &apos;
exchange-xml-depth = osiągnięto limit zagnieżdżenia elementów ({ $most })
exchange-xml-long = znacznik lub tekst jest dłuższy niż { $most } KiB
exchange-xml-mixed = { $name } ma element w środku swojego tekstu
exchange-xml-cut-off = plik kończy się w środku elementu: może być ucięty
exchange-xml-encoding = nieznane kodowanie { $given }: użyć UTF-8, UTF-16 lub ISO 8859-1
exchange-xml-bytes = te bajty nie są tekstem w kodowaniu pliku
exchange-qif-unit = jednostka długości { $unit }: nazwa jest nieznana lub nie zgadza się z przelicznikiem; użyć mm, inch lub innej jednostki z przelicznikiem na metry
exchange-qif-no-unit = plik nie ma jednostki długości: potrzebne jest FileUnits z PrimaryUnits i LinearUnit
exchange-qif-reference = { $what } { $id } nie ma w pliku
exchange-qif-too-many = plik ma więcej niż { $most } { $most ->
        [one] element
        [few] elementy
        [many] elementów
       *[other] elementów
    } { $what }
exchange-qif-no-value = nie ma tu wartości zmierzonej; status { $status }
exchange-qif-limit = granice lub wymiar nominalny: { $reason }
exchange-qif-other-kind = pomiar jest rodzaju { $measured }, a jego charakterystyka rodzaju { $defined }
exchange-qif-several-values = pomiar ma kilka wartości
exchange-qif-defined-as-limit = brakuje DefinedAsLimit lub nie jest to ani true, ani false, więc liczby mogą być granicami lub odchyłkami
exchange-qif-no-nominal = granice są odchyłkami, ale nie ma wymiaru nominalnego
exchange-qif-zone = klasa { $class } i { $zone } są sprzeczne: wielkie litery to otwory, małe to wałki
exchange-qif-no-results = plik QIF bez wartości zmierzonych: plan można odczytać jako plan części
exchange-qif-no-characteristics = plik QIF nie deklaruje charakterystyk
exchange-warning-standard-uncertainty-not-used = plik podaje złożoną niepewność standardową { $standard } i błąd średni { $mean-error }: żadna reguła ich nie używa, więc podać --u
exchange-warning-sheet-hidden = arkusz { $sheet } jest czytany, choć jest ukryty w skoroszycie
exchange-warning-rows-hidden = { $count ->
    [one] wiersz { $rows } jest ukryty lub odfiltrowany w skoroszycie, ale jest czytany jak pozostałe
    [few] { $count } wiersze są ukryte lub odfiltrowane w skoroszycie, ale są czytane jak pozostałe: { $rows }
    [many] { $count } wierszy jest ukrytych lub odfiltrowanych w skoroszycie, ale są czytane jak pozostałe: { $rows }
   *[other] { $count } wierszy jest ukrytych lub odfiltrowanych w skoroszycie, ale są czytane jak pozostałe: { $rows }
}
exchange-warning-columns-hidden = ukryte kolumny są czytane jak pozostałe: { $columns }
exchange-warning-qif-version = QIF w wersji { $version }: ten program jest przeznaczony do wersji 2.0, 2.1 i 3.0
exchange-warning-qif-count = { $list } podaje n={ $said }, a ma { $found }: czegoś może brakować lub coś dodano
exchange-warning-qif-twice = id { $id } występuje dwa razy: użyto pierwszego elementu
exchange-format-xlsx = pomiary w skoroszycie: kolumny jak w CSV
exchange-workbook = nie można odczytać tego skoroszytu: { $reason }
exchange-not-a-workbook = to plik ZIP, ale nie skoroszyt: rozpakować i podać pliki z niego
exchange-old-workbook = skoroszyt w formacie { $format } nie jest obsługiwany: zapisać go jako XLSX
exchange-workbook-password = skoroszyt ma hasło: zapisać go bez hasła
exchange-zip-cut-off = brakuje końca skoroszytu: może być ucięty
exchange-zip-members = spis zawartości skoroszytu jest uszkodzony lub ma więcej niż { $most } { $most ->
        [one] pozycję
        [few] pozycje
        [many] pozycji
       *[other] pozycji
    }
exchange-zip-bomb = { $member } po rozpakowaniu ma więcej niż { $most } MiB lub jest zbyt mocno skompresowany jak na skoroszyt: nie jest czytany
exchange-zip-twice = dwie części skoroszytu mają tę samą nazwę, więc został zmieniony: otworzyć go w arkuszu kalkulacyjnym i zapisać
exchange-zip-texts = skoroszyt ma więcej niż { $most } różnych tekstów
exchange-sheet-wide = komórka { $cell } jest poza pierwszymi { $most } kolumnami
exchange-too-many-cells = arkusz ma więcej niż { $most } { $most ->
        [one] komórkę
        [few] komórki
        [many] komórek
       *[other] komórek
    }
exchange-cell = { $cell }: { $reason }
exchange-formula-without-value = wartość formuły ={ $formula } nie jest zapisana: otworzyć skoroszyt w arkuszu kalkulacyjnym i zapisać go
exchange-cell-split = wartość komórki nie jest zapisana jako jeden zwykły tekst, więc można by odczytać tylko jej część: otworzyć skoroszyt w arkuszu kalkulacyjnym i zapisać go
exchange-cell-error = komórka pokazuje { $error }
exchange-warning-sheets-left = czytany jest arkusz { $sheet }; inne arkusze nie są: { $left }
gauge-frame = pominięto znaki, które otaczają linię
gauge-channel = z kanału { $channel }
gauge-inches = { $given } cala
gauge-error-text = { $given } może być numerem błędu przyrządu: jeśli to wymiar, wpisać go z jednostką, { $given } mm
gauge-opinion = przyrząd podaje { $sign }; decydują granice planu

mapping-no-value = { $given } nie przypisuje kolumny: wpisać słowo, = i kolumnę, np. measured=3
mapping-word = { $given } nie jest znaną zawartością kolumny: dozwolone są { $allowed }
mapping-value = { $word }: { $given } jest nieznane: dozwolone są { $allowed }
mapping-twice = { $word } podano dwa razy: podać raz
mapping-toml = to nie jest przypisanie kolumn: { $reason }

# How a value was judged by a plan, and what was given beside it.
planned-rule = oceniono według reguły planu zamiast { $given }: { $rule }
planned-uncertainty = oceniono z niepewnością planu zamiast podanej: { $u }
planned-material = skorygowano do 20 °C z materiałem planu zamiast podanego: { $name }
planned-corrected = skorygowano z { $temperature } °C do 20 °C (rozszerzalność { $expansion } · 10⁻⁶/K)
planned-not-corrected = bez korekcji do 20 °C: położenie na części nie jest wymiarem
planned-error-already-corrected = plik mówi, że wartość już dotyczy 20 °C: ocenić ją bez temperatury

## Gauges
gauge-no-unit = { $given } nie podaje jednostki: wybrać w ustawieniach przyrządu, czy wysyła milimetry, czy cale
exchange-gauge-unit = wiersz { $line } tych danych z przyrządu, { $given }, nie podaje ani mm, ani cali: podaj jednostkę przez import --columns unit=mm lub --columns unit=inch
gauge-other-form = { $given } różni się nie tylko cyframi od linii, której nauczono przyrząd, { $example }
gauge-other-decimals = { $given } ma { $decimals ->
        [one] 1 miejsce po przecinku
        [few] { $decimals } miejsca po przecinku
        [many] { $decimals } miejsc po przecinku
       *[other] { $decimals } miejsca po przecinku
    }, a w linii, której nauczono przyrząd, jest ich { $taught }: przyrząd wysyła inną jednostkę lub część liczby została utracona
teach-zero = 0 może być każdym zerem linii: do nauki użyć linii z inną wartością
teach-not-text = { $line } zawiera znaki, które nie są tekstem
teach-nowhere = { $value } mm nie występuje w linii { $line }: wpisać wartość, którą przyrząd przy niej pokazał
teach-twice = { $value } mm występuje w linii { $line } więcej niż raz: do nauki użyć linii z inną wartością
teach-other-unit = linia podaje { $given }, a to nie jest { $value } mm: wpisać wartość, którą pokazał przyrząd, w milimetrach
