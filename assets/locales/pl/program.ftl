# NC programs

## Reading
program-empty = program jest pusty
program-too-large = program jest większy niż { $most } MiB
program-too-many-lines = program ma więcej niż { $most } { $most ->
        [one] linię
        [few] linie
        [many] linii
       *[other] linii
    }
program-binary = plik nie jest tekstem: { $controls } z { $bytes } bajtów to nie znaki
program-no-begin = program nie zaczyna się od BEGIN PGM
program-second-begin = drugie BEGIN PGM
program-no-end = brakuje END PGM
program-units = END PGM podaje { $end }, BEGIN PGM podaje { $begin }
program-after-end = tekst po END PGM nie należy do programu
program-no-section = brakuje { $section }
program-no-unit = nagłówek nie podaje jednostki (#EINHEIT METRISCH / INCH): program jest czytany w mm
program-after-last-section = po ENDE / END mogą być tylko podprogramy
program-unclosed-comment = komentarz nie ma nawiasu zamykającego ]
program-numbers = wiersz NC numer { $number } następuje po { $previous }; numery wierszy NC nie po kolei: { $count }
program-label-again = LBL { $label } jest już zdefiniowany w linii { $first }
program-unclosed-quote = cudzysłów nie jest zamknięty
program-open-end = linia kończy się znakiem ~, ale nic po niej nie następuje
program-cycle-cut-many = cykl { $cycle } skończył się w linii { $line }, która nie ma ~ na końcu: linie od { $parameter } do linii { $last } do niego nie należą i zostałyby przypisane. Każda linia cyklu kończy się znakiem ~, oprócz ostatniej
program-cycle-cut = cykl { $cycle } skończył się w linii { $line }, która nie ma ~ na końcu: { $parameter } do niego nie należy i zostałby przypisany
program-no-star = wiersz NC nie kończy się znakiem *
program-iso-no-end = brakuje ostatniego wiersza NC: % z nazwą programu
program-iso-units = ostatni wiersz NC podaje { $end }, pierwszy { $begin }
program-iso-after-end = tekst po ostatnim wierszu NC nie należy do programu
program-iso-cycle-cut = cykl { $cycle } skończył się w linii { $line }: { $parameter } do niego nie należy i zostałby przypisany
program-comment-holds = { $found } należy do komentarza, który kończy się z końcem linii
program-cycle-without-tilde = cykl { $cycle } skończył się w linii { $line }, która nie ma ~ na końcu: linie poniżej są czytane jako jego część
program-block-goes-on = poprzedni wiersz NC kończy się znakiem ~, więc ten byłby jego częścią
program-comment-goes-on = komentarz kończy się znakiem ~, więc ten wiersz NC byłby jego częścią
program-not-understood = niezrozumiałe: { $reason }
program-more = uwagi poza listą: jeszcze { $count }

## Labels
program-label-missing = LBL { $label } nie występuje w programie
program-label-twice = LBL { $label } jest zdefiniowany dwa razy, w linii { $first } i w linii { $second }
program-label-zero = LBL 0 kończy podprogram: nie można do niego skoczyć
program-label-parameter = label w { $label } jest znany dopiero podczas wykonania programu

## Why a block is not understood
program-missing = brakuje: { $wanted }
program-unexpected = oczekiwane: { $wanted }, jest { $found }
program-speed-in-move = { $found } stoi w prostej: prędkość wrzeciona należy do TOOL CALL
program-left-over = nieoczekiwany tekst { $found }
program-unknown-function = { $found } nie jest funkcją
program-number-size = { $found } jest za duże
program-parameter-range = { $found } nie jest parametrem: { $family } ma zakres od { $least } do { $most }
program-range = { $found } jest za duże: najwyżej { $most }
program-label-of-parameter = { $parameter } nie może być nazwą labela, który się tu zaczyna
program-relation = FN { $number } porównuje przez { $allowed }: jest { $found }
program-not-together = { $one } i { $other } nie mogą być w tym samym wierszu NC
program-unknown-word = { $found } jest nieznane
program-no-form = postać ISO dla { $found } jest nieznana
program-measure-unknown = nie wiadomo, czy działa tu G90, czy G91
program-and-with-or = AND i OR w jednym warunku wymagają nawiasów, które pokazują kolejność
program-letter-twice = { $letters } podano dwa razy
program-second-unit = wcześniej podano inną jednostkę
program-acts-in-unit = moduły UNIT uznaje się za niemające wpływu, ale ten wiersz NC mierzy, wywołuje lub ustawia zmienną
program-shifts-in-unit = moduły UNIT uznaje się za niemające wpływu, ale ten wiersz NC może przesuwać punkt zerowy
program-alone = { $found } bez { $missing }
program-axis-twice = oś podano dwa razy
program-too-deep = nawiasy i funkcje są zagnieżdżone głębiej niż { $most }
program-too-many-operands = wzór ma więcej niż { $most } { $most ->
        [one] argument
        [few] argumenty
        [many] argumentów
       *[other] argumentów
    }
program-too-long = wiersz NC ma więcej niż { $most } { $most ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    }
program-too-much = wzory i długie wiersze NC zajmują razem więcej niż { $most } MiB
program-wanted-word = { $word }
program-wanted-number = liczba
program-wanted-value = liczba lub parametr Q
program-wanted-value-or-variable = liczba lub zmienna
program-wanted-variable = zmienna (#l, #c, #g, #x, #i)
program-wanted-parameter = parametr
program-wanted-number-parameter = parametr Q, QL lub QR
program-wanted-text-parameter = parametr QS
program-wanted-text = tekst w cudzysłowie lub parametr QS
program-wanted-label = label
program-wanted-path = ścieżka
program-wanted-relation = EQU, NE, GT, LT lub IS
program-wanted-unit = MM lub INCH
program-wanted-cycle-value = wartość
