## The program page

page-program = Programy
program-page-dialog-open = Otwieranie programu NC
program-page-choice = Program NC
program-page-open = Otwórz…
program-page-not-shipped = { $name } nie wchodzi w skład tej wersji
program-page-nothing = Żaden program nie jest otwarty
program-page-listing = { $name }, { $count ->
    [one] { $count } wiersz NC
    [few] { $count } wiersze NC
    [many] { $count } wierszy NC
   *[other] { $count } wierszy NC
  }

program-page-run = Wykonaj
program-page-pause = Pauza
program-page-step = Pojedynczy wiersz
program-page-step-over = Przez wywołanie
program-page-to-selected = Do kursora
program-page-breakpoint = Punkt zatrzymania
program-page-reset = Resetuj
program-page-move = Przejdź do innego wiersza NC
program-page-speed = Prędkość
program-page-speed-slow = 4 wiersze NC/s
program-page-speed-medium = 20 wierszy NC/s
program-page-speed-fast = pełna prędkość
program-page-options = Opcje
program-page-skip-unknown = Pomijaj nieznane wiersze NC
program-page-assume-tool = Próbkuj wzdłuż Z bez TOOL CALL
program-page-block-skip = Pomijaj wiersze NC z /
program-page-optional-stop = Zatrzymaj przy M1
program-page-outline-none = nagłówek lub label
program-page-outline = Przejdź do

program-page-state-ready = Gotowy do wykonania
program-page-state-running = W trakcie
program-page-state-paused = Pauza
program-page-state-step = Pojedynczy wiersz
program-page-state-breakpoint = Pauza w punkcie zatrzymania
program-page-state-goal = Pauza przy kursorze
program-page-state-over = Pauza po wywołaniu
program-page-state-stop = Program sam się zatrzymał: „Wykonaj” go kontynuuje
program-page-state-optional-stop = Program sam się zatrzymał przy M1: „Wykonaj” go kontynuuje
program-page-state-tolerance = Poza tolerancją: { $stop }
program-page-state-log = Protokół jest na ekranie: „Wykonaj” kontynuuje
program-page-state-ended = Koniec, wiersze NC: { $blocks }
program-page-state-fault = Zatrzymano z błędem
program-page-refused-inputs = Nie można odczytać danych wejściowych
program-page-refused-none = Żaden program nie jest otwarty
program-page-refused-workpiece = Nie można odczytać detalu
program-page-refused-no-contacts = Żadne punkty pomiarowe nie są otwarte

program-page-has-breakpoint = punkt zatrzymania
program-page-is-current = następny wiersz NC
program-page-is-failed = tu błąd

program-page-inputs = Dane wejściowe
program-page-answers = Fitcheck i program
program-page-program = Program
program-page-verdict = Ocena
program-page-no-limits = Bez granic: nie można odczytać danych wejściowych
program-page-agrees = Program zgadza się z Fitcheck
program-page-contested = Program { $program }, Fitcheck { $own }
program-page-contested-limits = Program { $program }, według innych granic niż Fitcheck
program-page-stopped-at = Zatrzymano z błędem; dotąd { $program }
program-page-differs = Program daje inny wynik: { $what }
program-page-differs-minimum = jego minimum to { $program } mm, w Fitcheck { $own } mm
program-page-differs-maximum = jego maksimum to { $program } mm, w Fitcheck { $own } mm
program-page-differs-status = podaje { $program }, Fitcheck podaje { $own }
program-page-differs-fault = zatrzymał się z błędem
program-page-differs-native-refuses = wydał ocenę, Fitcheck nie ma granic
program-page-other-inputs = Nie porównano: program ustawił potem inne dane wejściowe i mierzy inny element
program-page-both-refuse = Ani program, ani Fitcheck nie daje wyniku

program-page-workpiece = Detal
program-page-from-perfect = idealny, środek granic
program-page-from-nominal = idealny, nominalny
program-page-from-given = idealny, podana średnica
program-page-from-simulated = symulowany
program-page-from-part = część z kilkoma elementami
program-page-open-part = Otwórz część…
program-page-dialog-part = Otwieranie symulowanej części z kilkoma elementami
program-page-refused-no-part = Żadna część nie jest otwarta
program-page-from-recorded = zarejestrowane punkty
program-page-workpiece-x = Środek rzeczyw. X
program-page-workpiece-y = Środek rzeczyw. Y
program-page-edit-workpiece = Detal i sonda…
program-page-open-contacts = Inne punkty pomiarowe…
program-page-recorded = { $count ->
    [one] { $count } punkt pomiarowy
    [few] { $count } punkty pomiarowe
    [many] { $count } punktów pomiarowych
   *[other] { $count } punktów pomiarowych
  } z { $name }
program-page-path = Tor sondy
program-page-no-path = Jeszcze bez toru
program-page-zero = Zero X { $x }, Y { $y }, Z { $z } mm
program-page-turned = obrót o { $angle }°
program-page-tilted = nachylenie A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = Program nie otworzył okna
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, SYMULACJA
program-page-cycles = Zmierzono
program-page-show-block = Pokaż wiersz NC
program-page-last-of = Ostatnie { $shown } z { $all }
program-page-outputs = Pliki
program-page-outputs-hint = Pokazane tutaj, niezapisane na dysku

program-page-parameters = Parametry
program-page-filter = Filtr
program-page-set = Zacznij z
program-page-value = Wartość
program-page-give = Ustaw
program-page-give-hint = Następne wykonanie zaczyna z tą wartością
program-page-given = Ustawiono do następnego wykonania
program-page-drop = usuń
program-page-no-parameter = { $given } nie jest parametrem: wpisać Q5, QL5, QR5 lub QS5
program-page-no-number = { $given } nie jest liczbą
program-page-none-found = Żaden parametr nie pasuje
program-page-no-parameters = Parametry pojawią się, gdy program ruszy
program-page-undefined = niezdefiniowany
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, zmieniony
program-page-pin = Trzymaj { $parameter } na górze
program-page-unpin = Nie trzymaj { $parameter } na górze
program-page-q108 = promień narzędzia
program-page-q109 = oś narzędzia: 0 X, 1 Y, 2 Z
program-page-q110 = wrzeciono: 0 M3, 1 M4, 2 lub 3 potem zatrzymane
program-page-q111 = chłodziwo: 0 wyłączone, 1 włączone
program-page-q113 = jednostka: 0 mm, 1 cal
program-page-q114 = długość narzędzia
program-page-q115 = próbkowana pozycja, X
program-page-q116 = próbkowana pozycja, Y
program-page-q117 = próbkowana pozycja, Z
program-page-q150 = zmierzony kąt

program-page-problems = { $count ->
    [one] { $count } uwaga
    [few] { $count } uwagi
    [many] { $count } uwag
   *[other] { $count } uwag
  }
program-page-unlisted = poza listą { $count ->
    [one] jeszcze { $count }
   *[other] jeszcze { $count }
  }
program-page-at-block = wiersz NC { $number }: { $what }
program-page-at-line = linia { $line }: { $what }

program-page-create = Utwórz dla sterowania…
program-page-create-hint = Programy NC, tabele i maska, z którymi sterowanie mierzy samo
program-page-create-also = zapisz programy NC pliki zestaw
program-page-create-head = Utwórz dla sterowania
program-page-create-control = Sterowanie
program-page-create-language = Język dialogowy
program-page-create-from = Z
program-page-create-series = Dla serii: każde uruchomienie mierzy następny detal
program-page-create-texts = Tolerancje średnic jako teksty cyklu
program-page-create-callout = { $callout } ze strony Kontrola, w X { $x } Y { $y } Z { $z }
program-page-create-no-callout = Wymiar tolerowany ze strony Kontrola
program-page-create-plan = Plan { $name }, { $count ->
    [one] { $count } element
    [few] { $count } elementy
    [many] { $count } elementów
   *[other] { $count } elementów
  }
program-page-create-nothing = Wpisać wymiar tolerowany na stronie Kontrola lub otworzyć plan na stronie Części
program-page-create-plan-wrong = { $name } ma błędy: otworzyć plan na stronie Części i poprawić je
program-page-create-folder = Folder na sterowaniu: { $folder }
program-page-create-proven-callout = Odczytano i wykonano próbnie: { $callout } dostaje dokładnie granice Fitcheck
program-page-create-proven-plan = Odczytano i wykonano próbnie: każdy element dostaje granice planu
program-page-create-clearance-height = Bezpieczna wysokość to { $height } mm; w planie ustawia ją kolumna
program-page-create-files-none = Utwórz pliki…
program-page-create-files = Utwórz { $count ->
    [one] { $count } plik…
    [few] { $count } pliki…
    [many] { $count } plików…
   *[other] { $count } plików…
  }
program-page-dialog-create = Pliki dla sterowania: wybrać lub podać folder
program-page-create-written = { $count ->
    [one] Zapisano { $count } plik
    [few] Zapisano { $count } pliki
    [many] Zapisano { $count } plików
   *[other] Zapisano { $count } plików
  } w { $folder }: { $names }
program-page-create-no-folder = { $name } to plik: podać folder
program-page-contacts-left = Punkty pomiarowe z { $name } należą do poprzedniego programu: ten mierzy idealny detal
program-page-unfinished = Nie porównano: program nie doszedł do końca
program-page-unknown = { $fault }. Aby wykonać program bez tego, włączyć Opcje → Pomijaj nieznane wiersze NC
program-page-missing-file = { $fault }. Szukano w { $folder } i wśród plików wbudowanych. Umieścić plik tam, obok programu, lub otworzyć program w folderze, który go zawiera
program-page-unknown-datum = { $fault }. Bez punktu odniesienia nic nie jest mierzone. Na próbę otworzyć kopię programu bez wiersza NC, który go ustawia, oraz detal widziany od tego punktu odniesienia
program-page-not-written = { $path } powstałby na sterowaniu. Tekst jest w sekcji Pliki; w wierszu poleceń zapisuje go fitcheck run --output-folder
program-page-no-verdict = Bez granic, bez oceny
