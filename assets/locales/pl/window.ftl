# Okno: opisy, przyciski, nagłówki.

page-check = Kontrola
page-fit = Pasowania
page-tables = Tabele
import = Importuj…
export = Eksport
export-people = Raport z kontroli ({ $format })…
export-programs = Historia jako { $format }…
export-status-check = Okno statusu z Kontroli jako tekst…
export-status-cycle = Okno statusu cyklu { $cycle } jako tekst…
export-status-program = Okno programu jako tekst…
menu = Menu
language = Język
theme = Wygląd
theme-system = Jak w systemie
theme-light = Jasny
theme-dark = Ciemny
theme-contrast = Wysoki kontrast, białe tło
theme-inverted = Wysoki kontrast, czarne tło
density = Wielkość elementów obsługi
density-by-use = Automatycznie
density-mouse = Mysz
density-touch = Dotyk
limits-from = Źródło granic
standard-js-rounded = Połówki µm w JS zaokrąglane w dół, jak w 1988
standard-1988 = cd, ef, fg tylko do 10 mm, jak w 1988
load-tables = Własne tabele…
no-own-tables = Nie używaj własnych tabel
load-mask = Własna maska…
undo = Cofnij
undo-what = Cofnij: { $what }
undo-add = { $count ->
    [one] dodanie 1 kontroli
   *[other] dodanie { $count } kontroli
}
undo-correct = korekta
undo-feature = otwór lub wałek
undo-clear = wyczyszczenie historii
undone = Cofnięto: { $what }
clear-history = Wyczyść historię
choose-bad = { $count ->
    [0] Zaznacz niedobre kontrole
    [one] Zaznacz 1 niedobrą kontrolę
    [few] Zaznacz { $count } niedobre kontrole
    [many] Zaznacz { $count } niedobrych kontroli
   *[other] Zaznacz { $count } niedobrych kontroli
}
choose-none = Odznacz wszystko

callout = Wymiar tolerowany
callout-hint = Wpisać wymiar nominalny i klasę, np. 25 H7
feature-hole = Otwór
feature-shaft = Wałek
feature-neither = Żadne z dwóch
nominal-is = wymiar nominalny { $nominal } mm
maximum = Maksimum
minimum = Minimum
from-source = z: { $source }
source-overrides = Własna tabela: w ISO 286 jest { $upper } / { $lower } µm, czyli różnica { $by-upper } / { $by-lower } µm
measured-value = Wartość zmierzona
measured-once = Już oceniono. Aby ocenić tę samą wartość ponownie, należy ją wpisać jeszcze raz lub nacisnąć przycisk
by-typing = Wpisz
by-simulating = Symuluj
judge = Oceń
measure = Zmierz
clear = Wyczyść
nominal-size = Wymiar nominalny
tolerance-class = Klasa
class-none = Wybierz
classes-hole = Klasy otworów
classes-shaft = Klasy wałków
part-section = Część
part-name = Część lub element

probe-position = Pozycja próbkowania
centre-x = Środek X
centre-y = Środek Y
height-z = Wysokość Z
first-contact = Pierwszy punkt
clearance = Odstęp bezp.
centre-tolerance = Tolerancja środka ±
simulated-workpiece = Symulowany detal
simulated-hint = Puste pole średnicy oznacza środek pola tolerancji. Ziarno rośnie po każdym pomiarze; to samo ziarno daje te same punkty pomiarowe.
true-diameter = Średnica rzeczyw.
seed = Ziarno
offset-x = Przesunięcie X
offset-y = Przesunięcie Y
ovality = Owalność
lobes = Liczba garbów
lobe-height = Wysokość garbu
surface-scatter = Rozrzut powierzchni 1σ
probe-scatter = Rozrzut sondy 1σ

field-range = { $given } jest poza zakresem od −{ $limit } do { $limit }
field-not-negative = { $given } jest mniejsze od 0: dozwolony zakres od 0 do { $limit }
field-above-zero = { $given } nie jest większe od 0: dozwolone wartości do { $limit }
field-not-whole = { $given } nie jest liczbą całkowitą

limit-band = Wykres granic
band-example = przykład: { $callout }, otwór
band-empty = Wykres granic pojawi się razem z wymiarami granicznymi
band-describe = Odchyłka od wymiaru nominalnego w mikrometrach: pole tolerancji od { $lower } do { $upper }, { $left } poniżej, { $right } powyżej.
band-describe-measured = Zmierzono { $deviation }, { $above } powyżej minimum, { $below } poniżej maksimum.
side-rework = poprawka
side-scrap = brak
side-out = poza tolerancją

last-values = Ostatnie wartości
last-values-empty = Tu pojawią się ostatnie wartości dla tych wymiarów granicznych
last-values-describe = { $count ->
    [one] Ostatnia wartość, najnowsza na końcu:
    [few] Ostatnie { $count } wartości, najnowsza na końcu:
    [many] Ostatnich { $count } wartości, najnowsza na końcu:
   *[other] Ostatnich { $count } wartości, najnowsza na końcu:
}
contacts = Punkty pomiarowe
contacts-factor = odchyłki × { $factor }
contacts-empty = Punkty pomiarowe pojawią się po pomiarze
contacts-describe = Punkty pomiarowe widziane z góry: { $count }, odchyłki powiększone { $factor } razy. { $circle }
centre-is = środek { $x } / { $y }

word-none = Bez wyniku
nothing-measured = Niczego nie zmierzono
judged-without-own = Oceniono bez własnych tabel
word-question = Zgadza się?
simulated = SYMULACJA
status-simulated = { simulated }: { $status }
judge-anyway = Mimo to oceń { $measured } mm
take-meant = Użyj { $meant } mm
take-text = Użyj { $meant }
keep-text = Mimo to użyj { $given }
doubted-enter = Enter używa wyróżnionego przycisku; wpisywanie zastępuje tekst
doubted-type = Nic nie zostanie ocenione, dopóki tekst nie zostanie wpisany ponownie lub użyty bez zmian
question-enter = Po pół sekundy Enter naciska wypełniony przycisk; wpisywanie zastępuje wartość
doubt-sentence = Wątpliwość: { $doubt }
lot-title = { $rows ->
    [one] { $name }: 1 wiersz
    [few] { $name }: { $rows } wiersze
    [many] { $name }: { $rows } wierszy
   *[other] { $name }: { $rows } wierszy
}
lot-unjudged = nieocenione: { $count }
lot-refused = { $count ->
    [one] 1 wiersz odrzucony
    [few] { $count } wiersze odrzucone
    [many] { $count } wierszy odrzuconych
   *[other] { $count } wierszy odrzuconych
}
lot-doubted = { $count ->
    [one] 1 wątpliwa wartość
    [few] { $count } wątpliwe wartości
    [many] { $count } wątpliwych wartości
   *[other] { $count } wątpliwych wartości
}
lot-shown = Pokazano: { $place } z { $judged }, od najgorszego; linia { $line }
lot-shown-part = Pokazano: { $place } z { $judged }, od najgorszego; linia { $line }, część { $part }
lot-worst = Najgorszy
lot-worse = Gorszy
lot-better = Lepszy
lot-best = Najlepszy
lot-count = { $status } { $count }
above-minimum = { $um } µm powyżej minimum
below-minimum = { $um } µm poniżej minimum
below-maximum = { $um } µm poniżej maksimum
above-maximum = { $um } µm powyżej maksimum
remove-amount = Zebrać { $um } µm
remove-to-limit = do granicy
remove-to-limit-per-side = do granicy, { $um } µm na stronę
remove-to-middle = { $um } µm do środka pola
position-in = Środek w pozycji
position-out = Środek poza pozycją
diameter-alone = Sama średnica: { $status }
first-steps = Pierwsze kroki
first-steps-title = Pierwszy raz?
first-steps-about = Te ustawienia zostaną zachowane.
first-steps-done = Gotowe
first-way-part = Cała część
first-way-part-about = Element po elemencie, według planu z obrazem.
first-way-file = Plik z wartościami
first-way-file-about = CSV, skoroszyt, QIF, AQDEF lub protokół pomiaru.
first-way-program = Bez maszyny
first-way-program-about = Program NC lub cykl mierzy symulowany otwór, punkt po punkcie.
first-step-callout = 1. Wymiar tolerowany: co podaje rysunek
first-step-value = 2. Wartość zmierzona: wpisana, symulowana lub z pliku
first-step-verdict = 3. Ocena i ile materiału zebrać
why = Dlaczego?
why-limits = Granice z: { $what }
why-measured = Wartość zmierzona: { $what }
why-rule = Reguła: { $what }
why-caveat = Ograniczenie tego pomiaru: { $what }

popup-title = Okno statusu
popup-title-accepted = Okno statusu: poza granicami, przyjęty według reguły
popup-title-simulated = Okno statusu, SYMULACJA
popup-exact = Okno zaokrągla do czterech miejsc po przecinku. Wartości dokładne: { $values }
popup-empty = Jeszcze bez pomiaru
copy = Kopiuj
mask-choice = Maska
mask-choice-of-language = Język okna
mask-choice-own = Własna maska…

history = Historia
history-count = { $count ->
    [0] bez kontroli
    [one] 1 kontrola
    [few] { $count } kontrole
    [many] { $count } kontroli
   *[other] { $count } kontroli
}
history-chosen = zaznaczone do eksportu: { $count }
history-hidden = w tym poza listą: { $hidden }
history-shown = { $shown } z { $count ->
    [one] 1 kontroli
   *[other] { $count } kontroli
}
history-exported-listed = { $count ->
    [0] Na liście nie ma kontroli: nic do eksportu
    [one] Eksport obejmie jedyną kontrolę na liście, wszystkich jest { $all }
    [few] Eksport obejmie { $count } kontrole z listy, wszystkich jest { $all }
    [many] Eksport obejmie { $count } kontroli z listy, wszystkich jest { $all }
   *[other] Eksport obejmie { $count } kontroli z listy, wszystkich jest { $all }
}
rows-exported = Eksport obejmie wiersze z listy w jej kolejności: { $listed }, plik { $name }
rows-export-not-yet = Wiersze można eksportować, gdy wszystkie są ocenione i na liście
history-exported = { $count ->
    [0] Nic do eksportu
    [one] Eksport obejmie 1 kontrolę
    [few] Eksport obejmie wszystkie { $count } kontrole
    [many] Eksport obejmie wszystkie kontrole: { $count }
   *[other] Eksport obejmie wszystkie kontrole: { $count }
}
history-cleared = { $count ->
    [one] Usunięto z historii 1 kontrolę. Cofnij (Ctrl+Z) ją przywraca.
    [few] Usunięto z historii { $count } kontrole. Cofnij (Ctrl+Z) je przywraca.
    [many] Usunięto z historii { $count } kontroli. Cofnij (Ctrl+Z) je przywraca.
   *[other] Usunięto z historii { $count } kontroli. Cofnij (Ctrl+Z) je przywraca.
}
history-none-found = Żadna kontrola nie pasuje do filtra
history-filter = Filtr
history-filter-hint = Pokazuje kontrole zawierające te słowa: część, wymiar tolerowany, wartość, data, status lub plik
history-only-bad = Tylko niedobre
history-only-bad-hint = Poprawka, powtórzyć i brak
history-sort-hint = Sortuje według tej kolumny; ponowne naciśnięcie odwraca kolejność, kolejne przywraca najnowsze na początku
history-ascending = { $column }, sortowanie rosnące
history-descending = { $column }, sortowanie malejące
history-list = Kontrole w historii
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, zaznaczono do eksportu
history-move = Przejdź do innej kontroli
history-show = Pokaż kontrolę
history-choose = Zaznacz do eksportu
choose-all = Zaznacz wszystkie na liście
copy-checks = Kopiuj do arkusza
history-empty = Tu pojawią się kontrole, najnowsze na początku
head-time = Data i godzina
head-part = Część
head-callout = Wymiar tol.
head-measured = Zmierzono
head-deviation = Odchyłka
head-status = Status
head-from = Źródło
choose-check = Zaznacz { $check } z { $time } do eksportu

dialog-import = Import pomiarów
dialog-mask = Własna maska
dialog-tables = Folder z własnymi tabelami
dialog-export = Eksport
dialog-export-rows = Eksport wierszy z listy
dialog-export-status = Eksport okna statusu
file-path = Plik
folder-path = Folder
dialog-open = Otwórz
dialog-save = Zapisz
dialog-browse = Przeglądaj…
dialog-cancel = Anuluj
dialog-busy = W toku…
dialog-no-path = Brakuje ścieżki
dialog-no-status = Nie ma okna statusu do zapisania
dialog-browse-hint = Pokazuje systemowe okno wyboru plików
dialog-up = Folder nadrzędny
dialog-home = Folder domowy
dialog-all-files = Wszystkie pliki
file-kind-measurements = Pomiary
file-kind-mask = Maski
file-kind-own-tables = Foldery z tabelami
file-kind-report = Raporty
file-kind-rows = Wiersze
file-kind-status = Tekst
file-kind-table = Tabele
file-kind-contacts = Punkty pomiarowe
file-kind-workpiece = Symulowane detale
file-kind-probes = Tabele sond
file-kind-log = Protokoły pomiaru
file-kind-program = Programy NC
file-kind-part = Symulowane części
file-kind-set = Pliki dla sterowania
file-kind-tools = Tabele narzędzi
file-kind-plan = Plany części
file-kind-picture = Obrazy
file-kind-watched = Obserwowane foldery
file-kind-budget = Budżety niepewności
file-kind-chart = Karty kontrolne
file-kind-readings = Odczyty
file-kind-study = Odczyty przyrządu
dialog-move = Przejdź do innej pozycji
dialog-recent-folders = Ostatnie foldery
dialog-exists = { $name } już istnieje. Zastąpić?
dialog-exists-set = { $name } już istnieje w tym folderze. Zastąpić pliki zestawu?
dialog-replace = Zastąp
dialog-keep = Zachowaj
dialog-nothing-picked = Okno systemowe nie zwróciło pliku. Należy wybrać plik z listy lub wpisać ścieżkę.
dialog-list = Folder { $folder }
dialog-entries = Pliki i foldery
dialog-list-none = Żaden folder nie jest otwarty: wpisać ścieżkę
dialog-list-reading = Odczyt folderu…
dialog-list-empty = W tym folderze nie ma nic do wyboru
dialog-list-more = Lista pokazuje tylko pierwsze pozycje ({ $most }): nazwę innej należy wpisać
dialog-is-folder = Folder
file-name-checks = kontrole
open-written = Otwórz
show-in-folder = Pokaż w folderze
launch-failed = nie można otworzyć pliku: { $reason }
recent-files = Ostatnie pliki
forget-recent = Wyczyść listę
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] 1 pozycja nie jest pokazana
    [few] { $count } pozycje nie są pokazane
    [many] { $count } pozycji nie jest pokazanych
   *[other] { $count } pozycji nie jest pokazanych
}
file-bytes = { $count } B
file-kilobytes = { $count } kB
file-megabytes = { $count } MB
notice = Informacja
copied = { $lines ->
    [one] Skopiowano jedną linię
    [few] Skopiowano { $lines } linie
    [many] Skopiowano { $lines } linii
   *[other] Skopiowano { $lines } linii
    }
notice-problem = Błąd
notice-more = { $count ->
    [one] Jeszcze 1 komunikat
    [few] Jeszcze { $count } komunikaty
    [many] Jeszcze { $count } komunikatów
   *[other] Jeszcze { $count } komunikatów
}
messages = Wcześniejsze komunikaty
messages-forget = Opróżnij tę listę
messages-count = { $count ->
    [one] 1 wcześniejszy komunikat
    [few] { $count } wcześniejsze komunikaty
    [many] { $count } wcześniejszych komunikatów
   *[other] { $count } wcześniejszych komunikatów
}
close = Zamknij
file-written = Zapisano { $name } w { $folder }
file-written-here = Zapisano { $name }
tables-loaded = { $count ->
    [one] Używana jest 1 tabela z { $folder }
    [few] Używane są { $count } tabele z { $folder }
    [many] Używanych jest { $count } tabel z { $folder }
   *[other] Używanych jest { $count } tabel z { $folder }
}
mask-loaded-with-warnings = { $name } odczytano z ostrzeżeniami
state-set-aside = Nie można było odczytać zapisanego stanu. Zachowano go jako { $path }, a okno startuje z ustawieniami domyślnymi.
state-set-aside-now = Zapisanego stanu nie można już odczytać. Zachowano go jako { $path }, a na jego miejscu zapisywany jest stan tego okna.
state-not-kept = Stan tego okna nie jest zapisywany: { $reason }
import-contacts-not-judged = Punkty pomiarowe z { $name } nie zostały ocenione
import-notice = { $name }: { $good ->
    [0] bez kontroli
    [one] 1 kontrola
    [few] { $good } kontrole
    [many] { $good } kontroli
   *[other] { $good } kontroli
}, { $bad ->
    [0] bez odrzuconych wierszy
    [one] 1 wiersz odrzucony
    [few] { $bad } wiersze odrzucone
    [many] { $bad } wierszy odrzuconych
   *[other] { $bad } wierszy odrzuconych
}
import-counted = { $file }. { $counts }
check-said-afterwards = podano po ocenie: { $as }
lot-open = { $count ->
    [one] Przy jednej wartości brakuje otworu lub wałka:
    [few] Przy { $count } wartościach brakuje otworu lub wałka:
   *[other] Przy { $count } wartościach brakuje otworu lub wałka:
}
check-all-holes = Wszystkie to otwory
check-all-shafts = Wszystkie to wałki
check-judged-again = { $count ->
    [one] Jedną wartość poza granicami oceniono ponownie: { $as }
    [few] { $count } wartości poza granicami oceniono ponownie: { $as }
   *[other] { $count } wartości poza granicami oceniono ponownie: { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Pokaż
notice-open-in = Otwórz na stronie { $page }
judge-unplanned = Otwórz na stronie Kontrola
sample-not-recorded = Przykład nie jest rejestrowany.
limits-own-first = Najpierw z własnych tabel: { $names }
limits-own-stay = Własne tabele nadal mają pierwszeństwo: { $names }. Można je wyłączyć w Menu, Źródło granic.
measured-needs-value = Wpisać wartość zmierzoną
measured-needs-limits = Bez wymiarów granicznych nie ma oceny: najpierw wpisać wymiar tolerowany

keypad = Klawiatura
key = Klawisz
key-blank = Spacja
key-decimal = Znak dziesiętny
key-minus = Minus
edge-left = Krawędź lewego panelu: przesuwana strzałkami
edge-right = Krawędź prawego panelu: przesuwana strzałkami
edge-top = Krawędź górnego panelu: przesuwana strzałkami
edge-bottom = Krawędź dolnego panelu: przesuwana strzałkami
key-letters = Litery
key-holes = Klasy otworów
key-shafts = Klasy wałków
key-more-letters = M do X
key-signs = Y, Z i znaki
key-figures = Cyfry
key-shift = Wielkie lub małe litery
key-back = Usuń ostatni znak
key-clear = Opróżnij
key-enter = Enter

## Table page
tables-choice = Tabela
tables-kind-shipped = wbudowana
tables-kind-own = własna
tables-kind-file = z pliku
tables-kind-copy = kopia
tables-kind-made = z ISO 286
tables-unsaved = niezapisana
tables-open = Otwórz…
tables-save = Zapisz jako
tables-redo = Ponów
tables-use = Użyj do granic
tables-in-use = Źródło granic
tables-filter = Filtr
tables-filter-hint = Klasy, np. H7 g6, litery, stopnie tolerancji lub wymiar w mm
tables-shown = { $count ->
    [one] { $shown } z 1 klasy
   *[other] { $shown } z { $count } klas
}
tables-only-differences = Tylko różnice
tables-unmatched = nic nie pasuje do { $words }
tables-agrees = { $count ->
    [one] zgodna z ISO 286 w jedynej komórce
   *[other] zgodna z ISO 286 we wszystkich { $count } komórkach
}
tables-differs = { $count ->
    [one] 1 z { $compared } komórek różni się od ISO 286
    [few] { $count } z { $compared } komórek różnią się od ISO 286
    [many] { $count } z { $compared } komórek różni się od ISO 286
   *[other] { $count } z { $compared } komórek różni się od ISO 286
}
tables-compared-nothing = nie ma czego porównać z ISO 286
tables-own-classes = { $count ->
    [one] 1 własna klasa
    [few] { $count } własne klasy
    [many] { $count } własnych klas
   *[other] { $count } własnych klas
}
tables-own-class = własna
tables-previous = Poprzednia różnica
tables-next = Następna różnica
tables-not-saved = Zmiany nie są zapisane
tables-keys = Strzałki zmieniają komórkę, Enter edytuje, Delete opróżnia, F8 przechodzi do następnej różnicy, Ctrl+F do filtra
tables-move = Przejdź do innej komórki
tables-edit-cell = Edytuj komórkę
tables-grid = Odchyłki w µm, tabela { $name }
tables-range-head = ponad – do, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = puste
tables-cell = { $class }, ponad { $over } do { $to } mm, { $figures }
tables-cell-differs = { $class }, ponad { $over } do { $to } mm, { $figures }, różni się od ISO 286
tables-no-columns = Tabela nie ma żadnej klasy
tables-upper = Górna
tables-lower = Dolna
tables-head-table = Tabela, µm
tables-head-standard = ISO 286
tables-head-by = różnica
tables-cell-agrees = Jak w ISO 286
tables-cell-off = W ISO 286 jest { $upper } / { $lower } µm; różnica tabeli { $upper-by } / { $lower-by } µm
tables-more-differences = i jeszcze { $count }
tables-cell-missing = Tu puste; w ISO 286 jest { $upper } / { $lower } µm
tables-cell-empty = Tu puste i w ISO 286 niezdefiniowane
tables-defined = Zakres klasy w ISO 286: { $ranges }
tables-shipped-hint = Tabela wbudowana nigdy się nie zmienia: edycja tworzy i pokazuje kopię.
tables-set = Ustaw
tables-take-standard = Przyjmij ISO 286
tables-empty-cell = Opróżnij
tables-remove-column = Usuń { $class }
tables-from-standard = Z ISO 286
tables-classes = Klasy, np. H7 K7 P9
tables-add-columns = Dodaj do tej tabeli
tables-up-to = Wymiary do
tables-make = Nowa tabela
tables-order = odchyłka górna { $upper } µm jest poniżej odchyłki dolnej { $lower } µm
tables-used-edited = { $name } podaje wymiary graniczne: kontrole od teraz uwzględniają zmianę
tables-used = Wymiary graniczne pochodzą najpierw z { $name }, aż do zamknięcia okna. Aby używać tabeli dalej, należy ją zapisać w folderze własnych tabel.
tables-read-with-warnings = { $name } odczytano z ostrzeżeniami
tables-nothing-read = Plik nie zawiera tabeli odchyłek
tables-nothing-to-save = Żadna tabela nie jest otwarta
tables-cell-unreadable = Wartości wybranej komórki są nieczytelne: najpierw je poprawić
tables-too-many = Otwarte tabele z niezapisanymi zmianami: { $count }. Najpierw jedną zapisać
tables-dialog-open = Otwieranie tabeli
tables-dialog-save = Zapisywanie tabeli
## Fit page
fit-callout = Pasowanie otworu i wałka
fit-callout-hint = Wpisać wymiar nominalny i obie klasy, np. 25 H7/g6
fit-example = przykład: { $callout }
fit-shaft-missing = Brakuje klasy wałka, np. g6 w 25 H7/g6
fit-hole-missing = Brakuje klasy otworu, np. H7 w 25 H7/g6
fit-classes-missing = Pasowanie ma klasy otworu i wałka, np. 25 H7/g6
fit-preferred = Pasowanie zalecane
fit-function = Funkcja
fit-list-hole-basis = Stały otwór
fit-list-shaft-basis = Stały wałek
fit-parts = Rzeczywiste części
fit-hole-measured = Zmierzony otwór
fit-shaft-measured = Zmierzony wałek
fit-temperature = Temperatura
fit-hole-material = Materiał otworu
fit-hole-expansion = Otwór, µm/(m K)
fit-shaft-material = Materiał wałka
fit-shaft-expansion = Wałek, µm/(m K)
fit-own-value = Własna wartość
fit-press = Połączenie wciskowe
fit-press-length = Długość połączenia
fit-hub-outer = Piasta zewn.
fit-shaft-bore = Otwór wału
fit-press-material = Połączenie wciskowe wymaga materiału z listy dla obu części: wybierz go
fit-press-pressure = Nacisk w połączeniu
fit-press-force = Trzyma osiowo
fit-press-torque = Trzyma jako moment
fit-press-pressing = Siła wtłaczania
fit-press-hub = Piasta: naprężenie / granica
fit-press-shaft = Wał: naprężenie / granica
fit-press-heat = Nagrzać piastę do
fit-press-cool = Albo oziębić wał do
fit-press-friction = Tarcie { $friction }; sprężyście, w 20 °C i w spoczynku. Siła osiowa i moment nie obowiązują jednocześnie
fit-search = Szukanie według luzu
fit-wanted-minimum = Minimum
fit-wanted-maximum = Maksimum
fit-scope = Wśród
fit-scope-all = Wszystkie klasy
fit-scope-basis = Stały otwór i stały wałek
fit-scope-preferred = Pasowania zalecane i nazwane
fit-search-hint = Najmniejszy i największy luz; wartość ujemna to wcisk. Można dodać jednostkę: 7 µm
fit-search-size = Do szukania potrzebny jest wymiar nominalny: wpisać go powyżej
fit-found = { $count ->
    [one] 1 pasowanie
    [few] { $count } pasowania
    [many] { $count } pasowań
   *[other] { $count } pasowań
}
fit-found-first = na liście najlepsze: { $count }
fit-found-none = Żadne pasowanie nie odpowiada. Najbliższe
fit-missed-by = { $below } µm za mało, { $above } µm za dużo
fit-is-preferred = zalecane

fit-picture = Pola tolerancji otworu i wałka
fit-picture-legend = µm od linii zerowej; odchyłka podstawowa pogrubiona
fit-picture-empty = Pola tolerancji pojawią się razem z pasowaniem
fit-arrow-clearance = Luz rzeczywisty
fit-arrow-interference = Wcisk rzeczywisty
fit-describe-zero = Linia zerowa przy { $nominal } mm.
fit-describe-zone = { $part } { $class } od { $lower } do { $upper } µm.
fit-describe-fundamental = Odchyłka podstawowa { $deviation } µm.
fit-describe-measured = { $part }: zmierzono { $deviation } µm.
fit-classes = Klasy dla { $nominal } mm
fit-classes-none = Klasy
fit-classes-empty = Klasy pojawią się razem z wymiarem nominalnym
fit-classes-nowhere = Dla tego wymiaru nie jest zdefiniowana żadna klasa
fit-staircase = Pola tolerancji, stopień { $grade }

fit-word-clearance = Pasowanie luźne
fit-word-transition = Pasowanie mieszane
fit-word-interference = Pasowanie ciasne
fit-word-none = Jeszcze bez pasowania
fit-maximum-clearance = Luz największy
fit-minimum-clearance = Luz najmniejszy
fit-maximum-interference = Wcisk największy
fit-minimum-interference = Wcisk najmniejszy
fit-mean-clearance = Luz średni
fit-mean-interference = Wcisk średni
fit-ansi = ANSI B4.2: { $name }
fit-equivalent = Pasowanie równoważne
fit-equivalent-same = Dokładnie te same luzy
fit-equivalent-differs = Nie to samo: najmniejszy luz { $minimum } µm, największy { $maximum } µm
fit-check-hole = Skontroluj otwór
fit-check-shaft = Skontroluj wałek
fit-move = Przejdź do innej klasy
fit-actual-clearance = Luz { $um } µm
fit-actual-interference = Wcisk { $um } µm
fit-conforms = W granicach wymiaru tolerowanego
fit-conforms-not = Poza granicami wymiaru tolerowanego
fit-with-good-shaft = Luz z dobrym wałkiem
fit-with-good-hole = Luz z dobrym otworem
fit-at-temperature = Przy { $degrees } °C
fit-temperature-change = luz zmienia się o { $um } µm
fit-these-parts = Te części: { $clearance }

## Own materials
materials-refused = Nie można użyć własnych materiałów: { $path }, { $reason }

## Palette
section-said = { $name }: { $value }
crash-report = Okno zamknęło się z powodu błędu programu. Opis błędu, bez wartości zmierzonych, jest w { $path }
rail-more = Więcej
top-open = Otwarto { $name }
top-undo = Cofnij ostatnią zmianę
top-recorded = Zarejestrowano, { $number }
top-recording = Rejestrowanie
top-not-recorded = Nie zarejestrowano
palette = Szukaj lub wykonaj
palette-do = Wykonaj
palette-open = Otwórz
palette-settings = Ustawienia i pomoc
palette-records = Zapisy
palette-fit = Pasowanie { $fit }
palette-in-tables = { $what } w tabelach
palette-uncertainty = Niepewność przy { $size } mm
palette-records-of = Zapisy: { $what }
palette-show-setting = Pokaż na stronie ustawień
palette-more = Co jeszcze można z tym zrobić
palette-back = Wróć do wyników szukania
palette-check-value = Skontroluj { $callout } z { $value }
palette-check = Skontroluj { $callout }
palette-search-manual = Szukaj w podręczniku „{ $query }”
palette-nothing = Nic nie ma takiej nazwy
palette-hint = Wymiar tolerowany, strona, polecenie lub plik

## Leaving
leave = Zamknąć Fitcheck?
discard = Odrzucić zmiany?
discard-unsaved = { $name } ma niezapisane zmiany.
discard-no = Edytuj dalej
discard-yes = Odrzuć zmiany
leave-unsaved = Nie zapisano: { $names }
leave-stay = Pracuj dalej
leave-anyway = Zamknij bez zapisywania

## Cycle pictures
cycle-picture-centre-1 = nominalny środek w pierwszej osi
cycle-picture-centre-2 = nominalny środek w drugiej osi
cycle-picture-centre-tolerance-1 = dopuszczalna odchyłka środka w pierwszej osi, w obie strony; 0: bez monitorowania
cycle-picture-centre-tolerance-2 = dopuszczalna odchyłka środka w drugiej osi, w obie strony; 0: bez monitorowania
cycle-picture-side-length-1 = nominalna długość prostokąta wzdłuż pierwszej osi
cycle-picture-side-length-2 = nominalna długość prostokąta wzdłuż drugiej osi
cycle-picture-maximum-side-1 = największa dopuszczalna długość wzdłuż pierwszej osi
cycle-picture-maximum-side-2 = największa dopuszczalna długość wzdłuż drugiej osi
cycle-picture-minimum-side-1 = najmniejsza dopuszczalna długość wzdłuż pierwszej osi
cycle-picture-minimum-side-2 = najmniejsza dopuszczalna długość wzdłuż drugiej osi
cycle-picture-width = nominalna szerokość, od ścianki do ścianki
cycle-picture-maximum-width = największa dopuszczalna szerokość
cycle-picture-minimum-width = najmniejsza dopuszczalna szerokość
cycle-picture-start-1 = punkt w rowku, w którym sonda zaczyna, pierwsza oś
cycle-picture-start-2 = punkt w rowku, w którym sonda zaczyna, druga oś
cycle-picture-shift = przesunięcie drugiego punktu pomiarowego wzdłuż ścianek; 0: naprzeciw pierwszego
cycle-picture-first-point-1 = pierwszy punkt, na ściance po stronie plus: pierwsza oś
cycle-picture-first-point-2 = pierwszy punkt, na ściance po stronie plus: druga oś
cycle-picture-second-point-1 = drugi punkt, na ściance po stronie minus: pierwsza oś
cycle-picture-second-point-2 = drugi punkt, na ściance po stronie minus: druga oś
cycle-picture-axis-of-plane = mierzona oś: 1 pierwsza oś, 2 druga oś
cycle-picture-diameter = średnica nominalna
cycle-picture-maximum-size = największa dopuszczalna średnica
cycle-picture-minimum-size = najmniejsza dopuszczalna średnica
cycle-picture-start-diameter = średnica okręgu, na którym sonda stoi przed każdym próbkowaniem
cycle-picture-first-angle = kąt pierwszego punktu pomiarowego, liczony od pierwszej osi
cycle-picture-step = kąt od punktu do punktu; minus obraca zgodnie z ruchem wskazówek zegara
cycle-picture-arc = kąt, na którym rozłożone są punkty; 360 to pełny obrót, minus obraca zgodnie z ruchem wskazówek zegara
cycle-picture-longest-path = najdłuższa droga próbkowania; plus prowadzi od środka, minus do środka
cycle-picture-difference = każdy punkt jest próbkowany dwa razy: największa dopuszczalna różnica
cycle-picture-measuring-height = wysokość środka kulki w punkcie pomiarowym
cycle-picture-set-up-clearance = odstęp przed punktem pomiarowym, dodawany do SET_UP z tabeli sond
cycle-picture-clearance-height = wysokość, na której sonda porusza się swobodnie
cycle-picture-point-1 = próbkowany punkt, pierwsza oś
cycle-picture-point-2 = próbkowany punkt, druga oś
cycle-picture-point-3 = próbkowany punkt, trzecia oś
cycle-picture-next-point-1 = drugi punkt prostej, pierwsza oś
cycle-picture-next-point-2 = drugi punkt prostej, druga oś
cycle-picture-next-point-3 = drugi punkt prostej, trzecia oś
cycle-picture-second-centre-1 = nominalny środek drugiego okręgu, pierwsza oś
cycle-picture-second-centre-2 = nominalny środek drugiego okręgu, druga oś
cycle-picture-second-diameter = nominalna średnica drugiego okręgu
cycle-picture-second-height = wysokość, na której próbkowany jest drugi okrąg
cycle-picture-geometries = 0 dwa otwory, 1 dwa czopy, 2 otwór i czop, 3 czop i otwór
cycle-picture-maximum-coordinate = największa dopuszczalna współrzędna
cycle-picture-minimum-coordinate = najmniejsza dopuszczalna współrzędna
cycle-picture-normal-1 = składowa normalnej do powierzchni w pierwszej osi; normalna wskazuje na zewnątrz materiału
cycle-picture-normal-2 = składowa normalnej do powierzchni w drugiej osi; normalna wskazuje na zewnątrz materiału
cycle-picture-normal-3 = składowa normalnej do powierzchni w trzeciej osi; normalna wskazuje na zewnątrz materiału
cycle-picture-band = dopuszczalna odchyłka wzdłuż normalnej: nadmiar plus, niedomiar minus
cycle-picture-retract = droga powrotna od punktu pomiarowego, przeciwnie do kierunku próbkowania
cycle-picture-move-to-clearance = droga między punktami: 0 na wysokości pomiaru, 1 przez bezpieczną wysokość
cycle-picture-clearance-mode = bezpieczna wysokość: −1 nigdy, 0 przed cyklem i po nim, 1 przed każdym obiektem i po nim, 2 przy każdym punkcie
cycle-picture-traverse = droga do następnego punktu: 0 po prostej, 1 po łuku
cycle-picture-contact-count = liczba punktów pomiarowych
cycle-picture-plane = płaszczyzna okręgu: 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 próbkowanie wewnątrz, 1 na zewnątrz
cycle-picture-measured-axis = mierzona oś: 1 pierwsza oś, 2 druga oś, 3 oś sondy
cycle-picture-direction = kierunek najazdu: −1 przeciwnie do osi, +1 zgodnie z osią
cycle-picture-directed-axis = oś mierzona, 1 pierwsza, 2 druga, 3 oś sondy; minus mierzy przeciwnie do osi
cycle-picture-tool-axis-probing = oś sondy: 0 pozostaje bez zmian, 1 jest też próbkowana i ustawiana
cycle-picture-tool-axis-point-1 = gdzie próbkowana jest oś sondy, pierwsza oś
cycle-picture-tool-axis-point-2 = gdzie próbkowana jest oś sondy, druga oś
cycle-picture-tool-axis-point-3 = gdzie w osi sondy oczekiwana jest powierzchnia
cycle-picture-new-datum-1 = współrzędna, którą zmierzone miejsce otrzymuje w pierwszej osi
cycle-picture-new-datum-2 = współrzędna, którą zmierzone miejsce otrzymuje w drugiej osi
cycle-picture-new-datum-3 = współrzędna, którą zmierzone miejsce otrzymuje w osi sondy
cycle-picture-new-coordinate = współrzędna, którą zmierzone miejsce otrzymuje w mierzonej osi
cycle-picture-table-row = wiersz tabeli, do którego trafia punkt odniesienia; przy 0 jest od razu aktywny
cycle-picture-transfer = tabela: −1 nie podano, 0 punkty zerowe, 1 punkty odniesienia
cycle-picture-preset-correction = 0 pozostawia aktywny punkt odniesienia bez zmian; inna liczba koryguje go tak, że ten punkt pokazuje wartość nominalną
cycle-picture-aligned-angle = kąt, do którego ustawiana jest krawędź, od pierwszej osi; 0 ustawia ją wzdłuż osi
cycle-picture-compensation-axis = oś obrotowa, która ustawia krawędź: 0 ta, wokół której zmierzono kąt, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = oś obrotowa po ustawieniu: 0 zachowuje swoją wartość, 1 pokazuje zero
cycle-picture-rotary-alignment = osie obrotowe po pomiarze: 0 stoją, inna liczba obraca je tak, że prosta jest ustawiona
cycle-picture-rotation-transfer = zmierzony kąt: 0 niczego nie zmienia, 1 staje się obrotem podstawowym, 2 przesunięciem osi obrotowej
cycle-picture-log = protokół pomiaru: 0 bez, 1 plik, 2 na ekranie i program się zatrzymuje
cycle-picture-stop = poza tolerancją: 0 program biegnie dalej, 1 zatrzymuje się z komunikatem
cycle-picture-stop-on-undersize = poza tolerancją: 0 program biegnie dalej, 1 zatrzymuje się, 2 zatrzymuje się tylko przy niedomiarze
cycle-picture-stop-on-scrap = poza tolerancją: 0 program działa dalej, 1 zatrzymuje się, 2 zatrzymuje się tylko przy braku
cycle-picture-tool = monitorowane narzędzie, numer lub nazwa; 0: żadne
cycle-picture-any-length = { $name } Długość
cycle-picture-any-angle = { $name } Kąt
cycle-picture-any-choice = { $name } Do wyboru: { $of }
cycle-picture-any-number = { $name } Liczba
cycle-picture-part = Część, { $count ->
    [one] jeden element
    [few] { $count } elementy
    [many] { $count } elementów
   *[other] { $count } elementów
  }: { $names }.
cycle-picture-path = Tor sondy, wykonano { $step } z { $moves } ruchów, { $contacts ->
    [one] 1 punkt pomiarowy
    [few] { $contacts } punkty pomiarowe
    [many] { $contacts } punktów pomiarowych
   *[other] { $contacts } punktów pomiarowych
}. Kulka w X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, punkt pomiarowy { $touch }
cycle-picture-no-path = Tor pojawi się po wykonaniu cyklu
cycle-picture-phase-pre-position = pozycjonowanie wstępne
cycle-picture-phase-approach = najazd
cycle-picture-phase-contact = punkt pomiarowy
cycle-picture-phase-retract = odsunięcie
cycle-picture-phase-leave = odjazd
cycle-picture-from-above = { $first }/{ $second } z góry
cycle-picture-from-side = { $first }/{ $second } z boku
cycle-picture-contacts = Punkty pomiarowe ({ $count }) wokół okręgu średniokwadratowego Ø { $diameter } mm, { $factor }: { $residuals }.
cycle-picture-nominal = Okrąg nominalny Ø { $diameter } mm.
cycle-picture-legend-fitted = najmniejsze kwadraty
cycle-picture-legend-nominal = nominalny
cycle-picture-deviation = odchyłka wzdłuż normalnej { $deviation } mm, bez tolerancji
cycle-picture-no-limits = Nie podano granic: niczego nie porównano
cycle-picture-head-criterion = Kryterium
cycle-picture-head-centre-1 = Środek, oś 1
cycle-picture-head-centre-2 = Środek, oś 2
cycle-picture-head-diameter = Ø w mm
cycle-picture-head-form = Kształt
cycle-picture-none = —
cycle-picture-least-squares = Najmniejsze kwadraty
cycle-picture-circumscribed = Najmniejszy opisany
cycle-picture-inscribed = Największy wpisany
cycle-picture-zone = Strefa minimalna, okrągłość
cycle-picture-two-point = Wymiar dwupunktowy
cycle-picture-two-point-of = Wymiar dwupunktowy { $first }–{ $second }
cycle-picture-two-point-least = Najmniejszy wymiar dwupunktowy, { $first }–{ $second }
cycle-picture-two-point-most = Największy wymiar dwupunktowy, { $first }–{ $second }
cycle-picture-no-opposed = żadne dwa punkty pomiarowe nie leżą naprzeciw siebie
cycle-picture-uncertainty = Rozrzut s punktu pomiarowego daje { $diameter } s w średnicy, { $against } razy tyle co 3 punkty co 120°, oraz od { $across } s do { $along } s w środku

# Zapisany stan i samo okno
saved-broken = nie można odczytać zapisanego stanu: { $reason }
saved-newer = zapisany stan ma wersję { $version }, ten program obsługuje wersje do { $known }
window-no-display = nie ma ekranu: DISPLAY i WAYLAND_DISPLAY nie są ustawione. Należy zalogować się na pulpicie, połączyć przez ssh -X lub użyć wiersza poleceń, który nie potrzebuje ekranu: fitcheck check "25 H7" --measured 25.012; patrz fitcheck --help
open-unknown = { $name } nie jest plikiem, który okno otwiera; otwiera pomiary, protokoły pomiaru i punkty pomiarowe (.csv, .tsv, .txt, .html), programy NC (.h), tabele (.tab), tabele narzędzi (.t), symulowane detale (.toml), tabele sond (.tp) i maski (.a)
window-not-opened = nie można otworzyć okna: { $reason }; wiersz poleceń działa bez ekranu, patrz fitcheck --help

## Rows of a large file

rows = Wiersze
rows-cancel = Anuluj
rows-again = Oceń ponownie
rows-close = Zamknij plik
rows-close-hint = Zamyka duży plik; jego wiersze nie są zachowywane
rows-move = Przejdź do innego wiersza
rows-show = Pokaż kontrolę wiersza
rows-keep = Dodaj do historii
rows-kept = Kontrolę dodano do historii
rows-progress = Odczytana część pliku
rows-running = dotąd wierszy: { $count }, { $percent } % pliku, { $rate } { $rate ->
        [one] wiersz
        [few] wiersze
        [many] wierszy
       *[other] wierszy
    } na sekundę
rows-done = wiersze: { $count }, wszystkie ocenione w { $seconds }
rows-seconds = { $seconds } s
rows-less-than = mniej niż { $seconds } s
rows-cancelled = NIEPEŁNY: przerwano po { $count } { $count ->
        [one] wierszu
       *[other] wierszach
    }, { $percent } % pliku
rows-failed = NIEPEŁNY po { $count } { $count ->
        [one] wierszu
       *[other] wierszach
    }: { $why }
rows-why-bytes = { $size } MiB, więcej niż { $limit } MiB: ocena wiersz po wierszu, bez zachowania wierszy w historii
rows-why-packed = Plik skompresowany: ocena wiersz po wierszu, bez zachowania wierszy w historii; rozpakowany tekst jest w pliku tymczasowym do zamknięcia pliku
rows-not-judged = NIEOCENIONE
rows-fate = { $fate } { $count }
rows-fate-hint = Pokazuje te wiersze; można wybrać kilka
rows-classes = Klasy
rows-all-classes = Wszystkie klasy
rows-no-class = Bez klasy
rows-some-classes = klasy: { $count }
rows-class = { $class }: { $count }
rows-summary = Podsumowanie
rows-fate-only = Pokaż wiersze dużego pliku: { $fate }
rows-filter-hint = Pokazuje wiersze, których komórki zawierają te słowa, np. część, wymiar tolerowany, wartość lub status
rows-worst-first = Od najgorszych
rows-worst-first-hint = Pokazuje braki przed poprawkami i dobrymi, największe odchylenie od granic na początku
rows-worst = Najgorsza część
rows-sifting = Przeszukiwanie wierszy…
rows-sifts-at-end = Filtr i kolejność działają, gdy wszystkie wiersze są ocenione
rows-in-order = od najgorszych
rows-worst-of-many = najgorsze: { $most }, od najgorszego
rows-first-of-many = pierwsze: { $most }
rows-export = Wiersze pliku jako { $format }, z oceną…
rows-export-programs = Kontrole wierszy z listy jako { $format }…
rows-export-simulated = Pierwsze linie pliku mówią, że jest symulowany, a tylko CSV może je zachować. Eksportować jako CSV
rows-export-twice = Plik ma dwie kolumny o nazwie { $column }. Eksportować jako CSV lub TSV, które na to pozwalają
rows-report-counts = { $name }: wiersze { $count }; DOBRY { $good }, POPRAWKA { $rework }, POWTÓRZYĆ { $remeasure }, POZA TOLERANCJĄ { $out }, BRAK { $scrap }, NIEOCENIONE { $unjudged }; w tym raporcie: { $listed }
rows-report-without = { $count ->
    [one] 1 wiersz z listy nie ma w tym raporcie oceny ani kontroli
    [few] { $count } wiersze z listy nie mają w tym raporcie oceny ani kontroli
    [many] { $count } wierszy z listy nie ma w tym raporcie oceny ani kontroli
   *[other] { $count } wierszy z listy nie ma w tym raporcie oceny ani kontroli
}
rows-file-name = { $name }-oceniony
rows-not-whole = NIEPEŁNE: liczby nie dotyczą całego pliku
rows-listed = na liście { $listed } z { $count } wierszy
rows-refused = { $count ->
    [one] 1 wiersz nieoceniony
    [few] { $number } wiersze nieocenione
    [many] { $number } wierszy nieocenionych
   *[other] { $number } wierszy nieocenionych
}
rows-doubted = { $count ->
    [one] 1 wartość może być inną wielkością lub należeć do innej części
    [few] { $number } wartości mogą być inną wielkością lub należeć do innej części
    [many] { $number } wartości może być inną wielkością lub należeć do innej części
   *[other] { $number } wartości może być inną wielkością lub należeć do innej części
}
rows-simulated = { $count ->
    [one] 1 wiersz mówi, że nikt nie mierzył
    [few] { $number } wiersze mówią, że nikt nie mierzył
    [many] { $number } wierszy mówi, że nikt nie mierzył
   *[other] { $number } wierszy mówi, że nikt nie mierzył
}
rows-status-differs = { $count ->
    [one] 1 wiersz ma w swoim pliku inny status
    [few] { $number } wiersze mają w swoim pliku inny status
    [many] { $number } wierszy ma w swoim pliku inny status
   *[other] { $number } wierszy ma w swoim pliku inny status
}
rows-status-unknown = { $count ->
    [one] 1 wiersz ma w swoim pliku nieznany status
    [few] { $number } wiersze mają w swoim pliku nieznany status
    [many] { $number } wierszy ma w swoim pliku nieznany status
   *[other] { $number } wierszy ma w swoim pliku nieznany status
}
rows-claim-differs = { $count ->
    [one] 1 granica, odchyłka lub rodzaj elementu przeczy swojemu wierszowi
    [few] { $number } granice, odchyłki lub rodzaje elementu przeczą swoim wierszom
    [many] { $number } granic, odchyłek lub rodzajów elementu przeczy swoim wierszom
   *[other] { $number } granic, odchyłek lub rodzajów elementu przeczy swoim wierszom
}
rows-several-lines = { $count ->
    [one] 1 wiersz zajmuje kilka linii
    [few] { $number } wiersze zajmują kilka linii
    [many] { $number } wierszy zajmuje kilka linii
   *[other] { $number } wierszy zajmuje kilka linii
}
rows-not-utf8 = { $count ->
    [one] 1 linia nie jest w UTF-8 i odczytano ją jako Windows-1252
    [few] { $number } linie nie są w UTF-8 i odczytano je jako Windows-1252
    [many] { $number } linii nie jest w UTF-8 i odczytano je jako Windows-1252
   *[other] { $number } linii nie jest w UTF-8 i odczytano je jako Windows-1252
}
rows-comments = { $count ->
    [one] 1 komentarz nie jest wierszem
    [few] { $number } komentarze nie są wierszami
    [many] { $number } komentarzy nie jest wierszami
   *[other] { $number } komentarzy nie jest wierszami
}
rows-note = Linia { $line }: { $what }
rows-first-notes = Pierwsze { $first } z { $count }:
rows-line = Linia { $line }, plik { $name }
rows-row-line = linia { $line }
rows-list = Wiersze pliku
rows-none = Żaden wiersz nie pasuje do filtra
rows-none-yet = Jeszcze bez wierszy
rows-head-line = Linia
rows-head-what = Do zrobienia
rows-changed = plik zmienił się od czasu oceny; ocenić go ponownie
rows-unread = nie można ponownie odczytać wierszy: { $reason }
rows-no-copy = nie można zachować rozpakowanego tekstu: { $reason }
rows-too-much = rozpakowany tekst jest większy niż { $most } GiB
rows-panicked = przebieg przerwał błąd wewnętrzny

## A file that is read or written
working = W toku
working-reading = Odczyt { $name }: wiersze { $rows }, { $done } z { $all } MB, { $rate } { $rate ->
        [one] wiersz
        [few] wiersze
        [many] wierszy
       *[other] wierszy
    } na sekundę
working-reading-bytes = Odczyt { $name }: { $done } z { $all } MB, { $seconds } s
working-writing = Zapisywanie { $name }: { $done } MB, { $seconds } s
working-progress = Postęp odczytu
working-stop = Zatrzymaj
working-stopped = Zatrzymano po { $rows } { $rows ->
        [one] wierszu
       *[other] wierszach
    }: nic z { $name } nie zaimportowano

## What a code reader typed into the field of the value
scanned-callout = { $given } to wymiar tolerowany i jako taki został przyjęty
scanned-serial = { $given } nie jest wartością: przyjęto jako numer seryjny następnych kontroli
