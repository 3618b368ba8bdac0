# Running NC programs.

## Paths and files
machine-path-empty = ścieżka jest pusta
machine-path-too-long = ścieżka ma więcej niż { $most } { $most ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    }, na co sterowanie nie pozwala
machine-path-other-root = { $path } nie jest ani ścieżką na TNC:, ani ścieżką od folderu programu
machine-path-leads-out = { $path } wychodzi poza folder
machine-path-no-name = { $name } w { $path } nie jest nazwą pliku ani folderu
machine-store-missing = nie znaleziono pliku: { $path }
machine-store-outside = { $path } wychodzi poza podane foldery
machine-store-no-file = { $path } nie jest plikiem
machine-store-too-large = { $path } jest większy niż { $most } MiB
machine-store-ambiguous = { $path } istnieje w kilku pisowniach, { $names }, a sterowanie ma tylko jeden plik o danej nazwie: usunąć pozostałe lub zmienić ich nazwy
machine-store-elsewhere = { $path } nie leży w folderze wyjściowym: program usuwa pliki tylko tam
machine-store-read-only = nie wybrano folderu wyjściowego
machine-store-system = { $path }: { $reason }

## Faults
machine-fault-in-block = { $program }, wiersz NC { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, linia { $line }, { $text }: { $fault }
machine-used-blocks = osiągnięto limit wierszy NC ({ $most }): możliwa pętla bez końca
machine-used-label-calls = osiągnięto limit zagnieżdżenia wywołań labeli ({ $most }): czy program wywołuje sam siebie?
machine-used-program-calls = osiągnięto limit zagnieżdżenia wywołań programów ({ $most }): czy program wywołuje sam siebie?
machine-used-windows = osiągnięto limit okien ({ $most })
machine-used-outputs = osiągnięto limit wydruków do plików ({ $most })
machine-used-output-files = osiągnięto limit plików wyjściowych ({ $most })
machine-used-folders = osiągnięto limit folderów plików wyjściowych ({ $most })
machine-used-table-writes = osiągnięto limit zapisań zmienionych tabel ({ $most })
machine-used-output = osiągnięto limit wydrukowanych bajtów ({ $most })
machine-used-cycles = osiągnięto limit pomiarów ({ $most })
machine-used-path = osiągnięto limit ruchów ({ $most })
machine-used-files = osiągnięto limit otwartych programów i zmienionych tabel ({ $most })
machine-used-traffic = osiągnięto limit bajtów odczytanych i zapisanych ({ $most })
machine-used-file-bytes = programy i zmienione tabele mają razem więcej niż { $most } { $most ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }
machine-text-too-long = liczba znaków tekstu: { $length }, parametr mieści najwyżej { $most }
machine-unknown-block = nieznany wiersz NC: Fitcheck wykonuje tylko to, co rozumie
machine-unknown-cycle = Fitcheck nie wykonuje cyklu { $cycle }, także tam, gdzie sterowanie go ma: wykonuje { $known }
machine-file-open = { $path } jest otwarty jako tabela FN 26: nie można go kopiować, przenosić ani usuwać
machine-broken = program jest uszkodzony: brakuje { $what }
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } nie jest labelem
machine-no-tool-data = { $parameter } jest niezdefiniowany: zawiera wymiar narzędzia we wrzecionie, który podaje tabela narzędzi
machine-undefined = { $parameter } jest niezdefiniowany
machine-lost = { $parameter } jest niezdefiniowany: może go ustawiać linia { $line }, { $text }, której nie wykonano
machine-file-unknown = { $path } nie jest czytany: może go zapisywać lub usuwać linia { $line }, { $text }, której nie wykonano
machine-tools-unknown = narzędzie nie jest korygowane: tabelę narzędzi może zmieniać linia { $line }, { $text }, której nie wykonano
machine-contacts-unknown = nie wiadomo, które zarejestrowane punkty pomiarowe należą do tego cyklu: część może należeć do linii { $line }, { $text }, której nie wykonano
machine-not-skipped = ten wiersz NC decyduje, co jest wykonywane dalej lub co dostaje inny program: nie można go pominąć
machine-whole-only = { $parameter } przyjmuje tylko liczby całkowite, nie { $value }
machine-no-answer = INPUT „{ $question }” pyta o { $parameter }: podać wartość przed wykonaniem
machine-no-parameter = parametr { $parameter } nie istnieje: Q i QS sięgają do 1999, QL i QR do 499
machine-no-variable = zmienna { $variable } nie istnieje: { $family } ma zakres od { $least } do { $most }
machine-not-number = { $parameter } zawiera tekst: oczekiwana liczba
machine-not-text = { $parameter } zawiera liczbę: oczekiwany tekst
machine-division-by-zero = dzielenie przez zero
machine-negative-root = pierwiastek kwadratowy z { $value } jest niezdefiniowany
machine-no-result = { $function } { $value } jest niezdefiniowane
machine-beyond-range = { $value } jest poza zakresem wartości, od -10^10 do 10^10
machine-not-whole = { $what } = { $value }: oczekiwana liczba całkowita od 0
machine-counted-row = wiersz
machine-counted-word = { $word }
machine-behind-text = liczba znaków tekstu: { $length }; pozycja { $from } jest za jego końcem
machine-no-number-in-text = { $parameter } = "{ $text }" nie jest liczbą
machine-unknown-system-text = nieznany tekst systemowy ID{ $id } NR{ $number }: obsługiwane są tylko data i czas (ID10321)
machine-no-table = żadna tabela nie jest otwarta
machine-several-columns = { $parameter } = { $text } podaje kilka kolumn: przez parametr tekstowy można czytać tylko jedną
machine-no-column = tabela { $table } nie ma kolumny { $column }; jej kolumny to { $columns }
machine-no-row = tabela { $table } nie ma wiersza { $row }: ma wiersze od 0 do { $last }
machine-no-rows = tabela { $table } nie ma wierszy
machine-empty-cell = tabela { $table }, wiersz { $row }, kolumna { $column }: komórka jest pusta
machine-no-number-in-cell = tabela { $table }, wiersz { $row }, kolumna { $column }: { $cell } nie jest liczbą
machine-touches = tabela { $table }, wiersz { $row }, kolumna { $column }: komórka wchodzi na sąsiednią, więc jej wartość jest niepewna
machine-table-write = tabela { $table }: { $error }
machine-mask = maska { $mask }: { $error }
machine-programmed = program sam się zatrzymał z błędem { $number }
machine-no-cycle-parameter = cykl { $cycle } nie ma parametru { $parameter }
machine-cycle-parameter-twice = cykl { $cycle }: { $parameter } podano dwa razy
machine-cycle-parameter-for = cykl { $cycle }: { $parameter } podano dwa razy, a { $other } wcale: czy drugi to { $other }?
machine-global-not-number = GLOBAL DEF { $number }: { $parameter } nie ma liczby
machine-global-twice = GLOBAL DEF { $number }: { $parameter } podano dwa razy
machine-open-subprogram = program kończy się w podprogramie wywołanym w linii { $line }: brakuje LBL 0
machine-repeat-ahead = REP powtarza część między labelem a tym wierszem NC, ale label jest dalej, w linii { $line }
machine-cycle = cykl { $cycle }: { $error }
machine-workpiece = detal: { $error }
machine-no-tool-call = przed tym cyklem pomiarowym nie ma TOOL CALL z osią narzędzia
machine-mode = sterowanie jest w trybie { $mode }: cykle pomiarowe działają tylko w trybie frezowania (FUNCTION MODE MILL)
machine-changed = od linii { $line }, { $text }, działa { $change }: w tym czasie Fitcheck nie mierzy
machine-nothing-selected = przed CALL SELECTED PGM nie ma SEL PGM
machine-no-datum-table = punkt odniesienia trafiłby do wiersza { $row } aktywnej tabeli punktów zerowych (Q303 = 0), którą ma tylko sterowanie: tutaj nie można od niego nic mierzyć
machine-datum-in-tilt = od linii { $line }, { $text }, płaszczyzna jest nachylona: Fitcheck nie ustawia w niej punktu odniesienia, bo nie wiadomo, co sterowanie tam zapisuje; przed cyklem należy zresetować płaszczyznę (PLANE RESET)
machine-point-without-part = cykle 0 i 1 próbkują pojedynczy punkt, a idealny detal go nie ma: należy wybrać symulowany detal lub zapisane kontakty
machine-point-from-nowhere = nie wiadomo we wszystkich osiach, skąd zaczyna się próbkowanie: należy wpisać w bloku X, Y i Z
machine-no-preset = { $table } nie ma wiersza { $row }
machine-preset-locked = { $table }: wiersz { $row } jest zablokowany, cykl nie może go zapisać
machine-shifted-preset = wiersz { $row } jest aktywnym punktem odniesienia i aktywne jest przesunięcie punktu zerowego: nie wiadomo, co robi z nim sterowanie
machine-change-not-known = nieznany punkt odniesienia
machine-change-turning = układ obrócony cyklu 800
machine-change-datum-table = przesunięcie z tabeli punktów zerowych
machine-change-rotation = obrót
machine-change-mirror = odbicie lustrzane
machine-change-scaling = skalowanie
machine-change-axis-scaling = skalowanie poszczególnych osi
machine-change-tilt = nachylona płaszczyzna
machine-change-tilted-shift = przesunięcie z płaszczyzny, która nie jest już nachylona
machine-change-axis-turned = obrót detalu osią obrotową, po którym obie osie płaszczyzny nie mają jeszcze nowego punktu odniesienia,

## Remarks
machine-file-from = { $path } odczytano z { $file }
machine-file-given = odczytano { $path }
machine-file-built-in = { $path } jest wbudowany
machine-remark-skipped = pominięto nieznany wiersz NC
machine-remark-cycle-passed-over = ten cykl kalibruje sondę albo mierzy narzędzie: został pominięty. To, co zwraca, jest odtąd niezdefiniowane, chyba że podano to przed uruchomieniem (--set Q115=0)
machine-remark-measurement-skipped = pominięto ten pomiar: jego wyniki są odtąd niezdefiniowane
machine-remark-datum-skipped = pominięto ten pomiar: jego wyniki są odtąd niezdefiniowane i nic po nim nie jest mierzone, bo może ustawiać punkt odniesienia
machine-remark-not-followed = ten wiersz NC nie jest wykonywany i może zmieniać punkt odniesienia: nic po nim nie jest mierzone
machine-remark-no-system-data = { $parameter } jest odtąd niezdefiniowany: dane systemowe FN 18 zna tylko sterowanie
machine-remark-axis-assumed = przed tym cyklem nie ma TOOL CALL: pomiar wzdłuż Z pierwszą sondą
machine-remark-measured-again = powtórzono pomiar po poprawce: liczy się ten pomiar
machine-remark-spindle-turns = wrzeciono obraca się od M{ $function }: sterowanie by nie próbkowało
machine-remark-rotary-moved = przed tym cyklem poruszono { $axes }: detal zmierzono tak, jakby nie został obrócony
machine-remark-other-preset = punkt odniesienia { $number }: przyjęto, że detal leży także tam
machine-remark-rotation-ended = obrót podstawowy { $angle } zakończył się: ten cykl mierzy bez niego, i pozostaje on wyłączony
machine-remark-axes-as-tilted = płaszczyzna jest nachylona: przyjęto, że osie obrotowe stoją tak, jak ona tego wymaga
machine-remark-machine-zero-assumed = FN 18 pyta o miejsce od zera maszyny: nie wiadomo tu, gdzie ono leży, i miejsce liczy się od zera detalu
machine-remark-datum-set = punkt odniesienia ustawiony: jego zero leży teraz w { $zero } mm we współrzędnych detalu
machine-remark-preset-set = wiersz { $row } tabeli punktów odniesienia ustawiony na { $zero } mm we współrzędnych detalu: działa z cyklem 247
machine-remark-active-preset-set = wiersz { $row } jest aktywnym punktem odniesienia: jego zero leży teraz w { $zero } mm we współrzędnych detalu; na iTNC 530 dopiero po cyklu 247
machine-remark-presets-left = { $path } pozostaje bez zmian: żaden wcześniejszy cykl 247 nie mówi, który wiersz jest aktywny, więc nie wiadomo, gdzie detal leży na maszynie
machine-remark-shift-ended = przesunięcie punktu zerowego kończy się w { $axes }, choć tam nie mierzono, jak na TNC7: iTNC 530 może je zachować
machine-remark-built-in = { $path } nie ma wśród podanych plików: odczytano wbudowany
machine-remark-other-names = odczytano { $read }, ale istnieje też { $others }: sterowanie ma tylko jeden plik o danej nazwie
machine-remark-read = { $path }: { $what }
machine-remark-other-spelling = tabela { $table } nie ma kolumny { $column }: użyto { $other }, drugiej pisowni z NC-Solution 8255
machine-remark-row-number = tabela { $table }: NR to { $found } w wierszu { $row }: FN 27 i FN 28 liczą wiersze od 0
machine-remark-length-converted = tabela { $table }: kolumna { $column } jest typu LENGTH i przeliczono ją między mm a calami
machine-remark-ended-within = M{ $function } w wywołanym programie zakończyło wykonanie: sterowanie na to nie pozwala
machine-remark-given-wins = { $parameter } = { $value } podano przed wykonaniem i zastępuje wartość z tego wiersza NC
machine-remark-given-without-effect = { $parameter } podano przed wykonaniem bez skutku: żaden wiersz NC go nie czytał
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = wiersz NC pomija { $parameters }: użyto tych wartości, ale sterowanie może odrzucić ten wiersz
machine-remark-measurement-behind-end = { $count ->
        [one] jeden cykl pomiarowy jest
        [few] { $count } cykle pomiarowe są
        [many] { $count } cykli pomiarowych jest
       *[other] { $count } cykli pomiarowych jest
    } po tym wierszu NC, gdzie sterowanie przestaje czytać: niczego po nim nie zmierzono
machine-remark-cycle-skipped = ten cykl pomiarowy pominięto zgodnie z ustawieniem, z powodu / przed nim
machine-remark-rounded = tabela { $table }, kolumna { $column }: { $value } zaokrąglono do { $written }
machine-remark-not-judged = tu bez oceny: niczego nie porównano z granicami
machine-remark-not-written = { $path } nie zapisano: nie wybrano folderu wyjściowego
machine-remark-deleted = { $path } usunięty przez program
machine-remark-not-deleted = { $path } nie usunięto: nie wybrano folderu wyjściowego
machine-remark-other-device = { $given } to inne urządzenie: plik to { $path }
machine-remark-screen-meant = SCREEN jest brane za nazwę pliku: czy chodziło o SCREEN:?
machine-remark-empty-mask = maska { $mask } jest pusta: to, co drukuje, też
machine-remark-not-saved = { $path } nie zapisano: { $reason }
machine-remark-full = { $path } osiągnął limit kilobajtów ({ $kilobytes }): niczego nie dodano
machine-remark-table-written = zapisano { $path }
machine-remark-contacts-left = cykle użyły { $used } z { $count } zarejestrowanych punktów pomiarowych
machine-remark-more = uwagi poza listą: jeszcze { $count }
machine-remark-empty-spindle = wywołano narzędzie 0: TNC7 nie ma wtedy sondy we wrzecionie
machine-remark-no-tool-named = żadne TOOL CALL przed tym cyklem nie podaje narzędzia: pomiar pierwszą sondą
machine-remark-tool-call-words = TOOL CALL nie przyjmuje { $words }: pominięto
machine-remark-no-nominal = cykl nie ma wymiaru nominalnego: sonda trafia w idealny detal w połowie K
machine-remark-other-probe = narzędzia { $tool } nie ma w tabeli sond: użyto sondy { $probe }
machine-remark-collision = kolizja: { $mover } dotknie elementu { $feature }, przy środku kulki w X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = ruchy nie są w pełni sprawdzone względem { $features }
machine-remark-stylus-unchecked = trzpień nie jest sprawdzany pod kątem kolizji: nie stoi wzdłuż Z
machine-remark-tool-offsets = { $offsets } z TOOL CALL nie zmienia symulowanej sondy
machine-remark-tool-locked = narzędzie { $tool } jest zablokowane w tabeli narzędzi
machine-remark-no-probe-tool = narzędzie { $tool } nie jest sondą: TYP = { $kind }, oczekiwane { $probe }
machine-remark-no-such-tool = narzędzia { $tool } nie ma w tabeli narzędzi
machine-remark-same-name = { $more ->
    [one] jeszcze jedno narzędzie ma nazwę { $tool }
    [few] jeszcze { $more } narzędzia mają nazwę { $tool }
    [many] jeszcze { $more } narzędzi ma nazwę { $tool }
   *[other] jeszcze { $more } narzędzi ma nazwę { $tool }
}: użyto pierwszego w tabeli narzędzi
machine-remark-content-uncertain = { $parameter } jest tu czytany, ale nie udokumentowano, że zawiera średnicę
machine-remark-not-waited = { $parameter } jest czytany bez G909 po cyklu: sterowanie czyta wiersze NC z wyprzedzeniem i mogło jeszcze nie zmierzyć
machine-remark-position-unknown = pozycja przed cyklem jest nieznana: bez D zaczyna się w nominalnym środku, bez WB na wysokości 0

machine-passed-over = bez wpływu na pomiar: { $count } { $count ->
        [one] wiersz NC
        [few] wiersze NC
        [many] wierszy NC
       *[other] wierszy NC
    }: { $list }

## Pauses
machine-pause-stop = program się zatrzymał: STOP lub M0
machine-pause-optional-stop = program się zatrzymał: M1
machine-pause-breakpoint = następny wiersz NC ma punkt zatrzymania
machine-pause-log = protokół pomiaru jest na ekranie (Q281 = 2)

## A block of a measuring cycle without its program
alone-moved = { $text } przesuwa następny cykl próbkowania lub zmienia jego osie, ale cykl jest wykonywany bez tego: wykonać cały program
alone-called = { $text } wykonuje wiersze NC, które mogą przesuwać następny cykl próbkowania, ale nie są czytane: wykonać cały program
alone-not-understood = { $text } jest niezrozumiałe i może przesuwać następny cykl próbkowania: sprawdzić program lub wykonać go w całości
alone-not-run = program nie wychodzi poza { $text } i nie dochodzi do następnego cyklu próbkowania, więc sterowanie tu nie mierzy: sprawdzić program
alone-passed = { $text } może ominąć cykl próbkowania, więc sterowanie może tu nie mierzyć: wykonać cały program
alone-skipped = sterowanie może pominąć cykl próbkowania z powodu / przed nim: jeśli ma być mierzony, usunąć /
