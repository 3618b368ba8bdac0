# Strona cykli: formularz cyklu pomiarowego, jego detal, tor i wyniki.

page-cycles = Cykle

cycles-cycle = Cykl
cycles-choose = Cykl { $number } { $name }
cycles-group-position = Pozycja
cycles-group-probing = Próbkowanie
cycles-group-tolerance = Tolerancja
cycles-group-output = Wydruk
cycles-optional-position = Pozycja, opcjonalnie
cycles-optional-probing = Próbkowanie, opcjonalnie
cycles-optional-tolerance = Tolerancja, opcjonalnie
cycles-optional-output = Wydruk, opcjonalnie
cycles-contacts-from = Źródło punktów
cycles-perfect = Idealna część
cycles-simulated = Symulowane
cycles-recorded = Zarejestrowane
cycles-workpiece = Detal…
cycles-suit = Dopasuj detal do cyklu
cycles-open-contacts = Punkty pomiarowe…
cycles-no-file = jeszcze bez pliku
cycles-contacts-of = { $count ->
    [one] { $count } punkt pomiarowy
    [few] { $count } punkty pomiarowe
    [many] { $count } punktów pomiarowych
   *[other] { $count } punktów pomiarowych
    }, { $file }
cycles-probe = Sonda
cycles-probe-is = SET_UP { $set-up } mm, DIST { $dist } mm
cycles-open-probes = Własna tabela sond…
cycles-shipped-probes = Wbudowana tabela
cycles-run = Wykonaj
cycles-needed = wymagane
cycles-none = puste
cycles-predef = PREDEF oznacza
cycles-predef-missing = PREDEF: wpisać wartość z GLOBAL DEF
cycles-without-effect = Przyjmowane bez skutku
cycles-position = Pozycja kulki
cycles-ball-stands = Kulka jest w
cycles-paste-block = Wklej wiersz NC…
cycles-copy-block = Kopiuj jako wiersz NC
cycles-copy-results = Kopiuj wyniki
cycles-block-copied = Skopiowano wiersz NC
cycles-block = Wiersz NC
cycles-block-hint = Wkleić wiersz NC, np. TCH PROBE 427 … Q263=+35 ;TEXT ~ lub G785 R0 BR0 K2: zastępuje formularz
cycles-fill = Wypełnij formularz

cycles-nothing-seen = Tor i punkty pomiarowe pojawią się po wykonaniu: nacisnąć Enter lub F5
cycles-allowed = Dozwolone: { $range } { $unit }
cycles-must-be-given = Wymagane
cycles-may-be-left-out = Opcjonalne
cycles-default = { $value }, jeśli puste
cycles-may-be-predef = PREDEF jest dozwolone
cycles-path = Tor kulki
cycles-first = Pierwszy
cycles-back = Wstecz
cycles-next = Następny
cycles-last = Ostatni
cycles-move = Ruch
cycles-phase-pre-position = pozycjonowanie wstępne
cycles-phase-approach = najazd
cycles-phase-contact = punkt pomiarowy
cycles-phase-retract = odsunięcie
cycles-phase-leave = odjazd
cycles-move-contact = { $number } z { $count }: { $phase } { $touch }, w { $to }
cycles-move-of-touch = { $number } z { $count }: { $phase }, punkt pomiarowy { $touch }, z { $from } do { $to }
cycles-move-of-none = { $number } z { $count }: { $phase }, z { $from } do { $to }
cycles-criteria = Porównanie kryteriów

cycles-word-stopped = Nie zmierzono
cycles-word-no-verdict = Bez oceny
cycles-no-limits = nie podano granic
cycles-no-limits-marked = nie podano granic; sterowanie melduje wtedy „w tolerancji”
cycles-more-out = { $what }, poniżej jeszcze { $count }
cycles-no-window = Bez wymiarów granicznych: sterowanie nie pokazuje okna statusu
cycles-results = Parametry wyników
cycles-log-file = Sterowanie zapisuje { $name }
cycles-log-screen = Sterowanie zatrzymuje się i pokazuje protokół na ekranie
cycles-log-shown = Sterowanie pokazuje wynik na ekranie
cycles-save-log = Zapisz protokół…
cycles-dialog-save-log = Zapisywanie protokołu pomiaru
cycles-no-log = nie ma protokołu do zapisania
cycles-from-perfect = Zmierzono na idealnym detalu o wymiarze nominalnym, z punktem jako sondą
cycles-from-simulated = Zmierzono na symulowanym detalu, ziarno { $seed }
cycles-from-recorded = Punkty pomiarowe z { $file }
cycles-unused = Punkty pomiarowe z pliku nieużyte przez cykl: { $count ->
    [one] jeden
   *[other] { $count }
    }

cycles-fields-wrong = { $count ->
    [one] jednego pola
   *[other] { $count } pól
    } nie można użyć: patrz formularz
cycles-no-workpiece = symulowany detal nie jest kompletny
cycles-workpiece-wrong = symulowany detal: { $problem }
cycles-workpiece-field = { $name }: { $problem }
cycles-no-contacts = nie otwarto jeszcze pliku z punktami pomiarowymi
cycles-cannot-suit = Jeszcze żaden detal nie pasuje: { $problem }
cycles-not-written = nie można zapisać detalu: { $reason }
cycles-contacts-loaded = Używane są punkty pomiarowe z { $name }
cycles-column-ignored = kolumna { $column } jest pominięta
cycles-probes-loaded = Używana jest tabela sond { $name }
cycles-dialog-contacts = Otwieranie zarejestrowanych punktów
cycles-dialog-workpiece = Otwieranie symulowanego detalu
cycles-dialog-probes = Otwieranie tabeli sond
cycles-dialog-save-workpiece = Zapisywanie symulowanego detalu

cycles-open-workpiece = Otwórz…
cycles-save-workpiece = Zapisz…
cycles-shape-bore = Otwór
cycles-shape-stud = Wałek
cycles-shape-face = Powierzchnia
cycles-shape-point = Punkt powierzchni
cycles-shape-slot = Rowek
cycles-shape-ridge = Mostek
cycles-shape-pocket = Kieszeń
cycles-shape-boss = Czop
cycles-plane = Płaszczyzna
workpiece-probe = Sonda
workpiece-machine = Rozrzut i temperatura
workpiece-centre-1 = Środek, oś 1
workpiece-centre-2 = Środek, oś 2
workpiece-ovality-angle = Kąt owalności
workpiece-lobe-angle = Kąt garbów
workpiece-point-x = Punkt X
workpiece-point-y = Punkt Y
workpiece-point-z = Punkt Z
workpiece-normal-x = Normalna X
workpiece-normal-y = Normalna Y
workpiece-normal-z = Normalna Z
workpiece-wave-height = Amplituda fali
workpiece-wave-length = Długość fali
workpiece-wave-x = Kierunek fali X
workpiece-wave-y = Kierunek fali Y
workpiece-wave-z = Kierunek fali Z
workpiece-deviation = Odchyłka po normalnej
workpiece-radius = Promień powierzchni
workpiece-width = Szerokość
workpiece-length-1 = Długość 1
workpiece-length-2 = Długość 2
workpiece-angle = Kąt ścianek
workpiece-ball = Promień kulki
workpiece-trigger = Rozrzut sygnału 1σ
workpiece-calibration = Błąd kalibracji
workpiece-offset-x = Przesunięcie kulki X
workpiece-offset-y = Przesunięcie kulki Y
workpiece-lobing-count = Garby drogi wstępnej
workpiece-lobing = Amplituda drogi wst.
workpiece-lobing-angle = Kąt drogi wstępnej
workpiece-temperature = Temperatura detalu
workpiece-expansion = Rozszerzalność

cycles-choice-move-to-clearance-0 = na wysokości pomiaru
cycles-choice-move-to-clearance-1 = na bezpiecznej wysokości
cycles-choice-clearance-mode-minus-1 = nigdy na bezpiecznej wysokości
cycles-choice-clearance-mode-0 = przed cyklem i po nim
cycles-choice-clearance-mode-1 = przed każdym obiektem i po nim
cycles-choice-clearance-mode-2 = przy każdym punkcie
cycles-choice-traverse-0 = po prostej
cycles-choice-traverse-1 = po łuku
cycles-choice-contact-count-3 = punkty
cycles-choice-contact-count-4 = punkty
cycles-choice-contact-count-5 = punktów
cycles-choice-contact-count-6 = punktów
cycles-choice-contact-count-7 = punktów
cycles-choice-contact-count-8 = punktów
cycles-choice-contact-count-9 = punktów
cycles-choice-log-0 = bez protokołu
cycles-choice-log-1 = protokół do pliku
cycles-choice-log-2 = stop, protokół na ekranie
cycles-choice-stop-0 = bez zatrzymania
cycles-choice-stop-1 = stop poza tolerancją
cycles-choice-stop-on-undersize-0 = bez zatrzymania
cycles-choice-stop-on-undersize-1 = stop poza tolerancją
cycles-choice-stop-on-undersize-2 = stop tylko przy niedomiarze
cycles-choice-stop-on-scrap-0 = bez zatrzymania
cycles-choice-stop-on-scrap-1 = stop poza tolerancją
cycles-choice-stop-on-scrap-2 = stop tylko przy braku
cycles-choice-measured-axis-1 = oś główna X
cycles-choice-measured-axis-2 = oś pomocnicza Y
cycles-choice-measured-axis-3 = oś sondy Z
cycles-choice-axis-of-plane-1 = oś główna X
cycles-choice-axis-of-plane-2 = oś pomocnicza Y
cycles-choice-direction-minus-1 = kierunek ujemny
cycles-choice-direction-1 = kierunek dodatni
cycles-choice-directed-axis-minus-3 = oś sondy Z, kierunek ujemny
cycles-choice-directed-axis-minus-2 = oś pomocnicza Y, kierunek ujemny
cycles-choice-directed-axis-minus-1 = oś główna X, kierunek ujemny
cycles-choice-directed-axis-1 = oś główna X, kierunek dodatni
cycles-choice-directed-axis-2 = oś pomocnicza Y, kierunek dodatni
cycles-choice-directed-axis-3 = oś sondy Z, kierunek dodatni
cycles-choice-tool-axis-probing-0 = bez zmian
cycles-choice-tool-axis-probing-1 = próbkowana i ustawiana
cycles-choice-transfer-minus-1 = nie podano
cycles-choice-transfer-0 = tabela punktów zerowych
cycles-choice-transfer-1 = tabela punktów odniesienia
cycles-choice-preset-correction-0 = bez zmian
cycles-choice-preset-correction-1 = skorygowany o punkt
cycles-choice-preset-correction-2 = skorygowany o 2. punkt
cycles-choice-preset-correction-3 = skorygowany o środek obu
cycles-choice-compensation-axis-0 = oś zmierzonego kąta
cycles-choice-compensation-axis-4 = oś A
cycles-choice-compensation-axis-5 = oś B
cycles-choice-compensation-axis-6 = oś C
cycles-choice-zero-after-alignment-0 = zachowuje wartość
cycles-choice-zero-after-alignment-1 = pokazuje zero
cycles-choice-rotary-alignment-0 = stoją
cycles-choice-rotary-alignment-1 = obracają się, sonda podąża
cycles-choice-rotary-alignment-2 = obracają się same
cycles-choice-rotation-transfer-0 = niczego nie zmienia
cycles-choice-rotation-transfer-1 = obrót podstawowy
cycles-choice-rotation-transfer-2 = przesunięcie osi obrotowej
cycles-choice-plane-0 = X/Y, G17
cycles-choice-plane-1 = Z/X, G18
cycles-choice-plane-2 = Y/Z, G19
cycles-choice-side-0 = wewnątrz
cycles-choice-side-1 = na zewnątrz
cycles-choice-geometries-0 = dwa otwory
cycles-choice-geometries-1 = dwa czopy
cycles-choice-geometries-2 = otwór i czop
cycles-choice-geometries-3 = czop i otwór

## The tool table

tools = Tabela narzędzi
tools-none = żadna
tools-open-one = { $name }, { $count ->
    [one] jedno narzędzie
    [few] { $count } narzędzia
    [many] { $count } narzędzi
   *[other] { $count } narzędzi
  }
tools-open = Otwórz tabelę narzędzi…
tools-close = Bez tabeli narzędzi
tools-save = Zapisz tabelę narzędzi…
tools-save-hint = Tabela z tymi zmianami. Następne wykonanie zaczyna od tabeli takiej, jak ją otwarto.
tools-dialog-open = Otwieranie tabeli narzędzi
tools-dialog-save = Zapisywanie zmienionej tabeli narzędzi
tools-loaded = Używana jest tabela narzędzi { $name }
tools-pick = wybierz narzędzie
tools-pick-of = { $parameter } z tabeli narzędzi
tools-input = { $parameter } Narzędzie do monitorowania (Q330)
tools-fixed = Q330 = { $tool } w programie
tools-more = { $count ->
    [one] jeszcze jedno narzędzie
    [few] jeszcze { $count } narzędzia
    [many] jeszcze { $count } narzędzi
   *[other] jeszcze { $count } narzędzi
  }
tools-row = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm
tools-row-locked = { $tool }: L { $length }, R { $radius }, DL { $delta-length }, DR { $delta-radius }, LBREAK { $length-breakage }, RBREAK { $radius-breakage } mm, zablokowane
tools-without-name = { $count ->
    [one] jednego narzędzia nie ma na liście: nazwa go nie identyfikuje
   *[other] { $count } narzędzi nie ma na liście: nazwy ich nie identyfikują
  }
tools-not-in-table = Q330 = { $tool }: w tabeli narzędzi nie ma takiego narzędzia
tools-not-monitored = Bez tabeli narzędzi żadne narzędzie nie jest monitorowane (Q330)
tools-none-named = Q330 nie podaje narzędzia: tabela narzędzi nie jest używana
tools-no-deviation = wartość zmierzona nie ma odchyłki: narzędzie bez zmian
tools-changed = Zmieniono w tabeli narzędzi
tools-nothing-changed = żadne wykonanie nie zmieniło tabeli narzędzi

## A part of several features

cycles-part-refused = plik ma tabele [[feature]]: pojedynczy cykl mierzy jedną powierzchnię; taką część mierzą strona Programy i fitcheck run
part-features = Elementy części
part-of-features = { $name }, { $count ->
    [one] jeden element
    [few] { $count } elementy
    [many] { $count } elementów
   *[other] { $count } elementów
  }, promień kulki { $ball } mm
part-round = { $name }: { $kind } Ø { $size } mm, { $first } { $x } { $second } { $y }
part-width = { $name }: { $kind } { $size } mm, { $first } { $x } { $second } { $y }
part-sides = { $name }: { $kind } { $size } × { $size2 } mm, { $first } { $x } { $second } { $y }
part-face = { $name }: { $kind } X { $x } Y { $y } Z { $z }
