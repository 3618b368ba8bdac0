# Przejście przez część i obserwowany folder, na stronie części.

walk-page-begin = Rozpocznij część
walk-page-count-up = Następny numer
walk-page-take = Oceń
walk-page-take-meant = Użyj { $meant } mm
walk-page-it-is-so = Tak jest: oceń { $measured } mm
walk-page-measure-anew = Odrzuć i zmierz ponownie
walk-page-confirmed = potwierdzono przy pomiarze: tak jest
walk-page-alarms = Otwarte alarmy: { $count }
walk-page-alarms-short = Alarmy
walk-page-alarms-more = Kolejne alarmy: { $count }
walk-page-alarm = { $name }: { $said }
walk-page-alarm-ask = Odpowiedz na alarm
walk-page-alarm-ask-of = Odpowiedz na alarm: { $name }
walk-page-alarm-answer = Zapisz odpowiedź
walk-page-alarm-later = Później
walk-page-alarm-cause = Przyczyna
walk-page-alarm-action = Działanie
walk-page-alarm-causes = Zużycie narzędzia; Nowe narzędzie; Korekcja narzędzia; Mocowanie; Wióry lub brud; Temperatura; Materiał; Błąd pomiaru; Nieznana
walk-page-alarm-actions = Wymieniono narzędzie; Zmieniono korekcję; Zamocowano ponownie; Oczyszczono maszynę; Zmierzono ponownie; Powiadomiono ustawiacza; Obserwowane dalej; Niepotrzebne
walk-page-alarm-empty = wpisać tekst lub wybrać go z listy
walk-page-alarms-unread = Nie można sprawdzić reguł kart kontrolnych: { $why }
walk-page-alarms-unchecked = Nie można sprawdzić reguł kart kontrolnych, { $name }: { $why }
walk-page-alarm-unrecorded = Nie można zapisać alarmu karty kontrolnej: { $why }
walk-page-simulate = Symuluj
walk-page-simulate-hint = Wykonuje cykl elementu na idealnej części; nikt nie mierzy tej wartości, pozostaje ona oznaczona jako symulowana
walk-page-again = Powtórz
walk-page-skip = Pomiń
walk-page-skip-for = Pomiń z tego powodu
walk-page-skip-not = Nie pomijaj
walk-page-next = Następna część
walk-page-move = Przejdź do innego wymiaru
walk-page-import = Importuj wartości…
walk-page-watch = Obserwuj folder…
walk-page-watch-hint = Pliki wrzucone do folderu są oceniane według planu i rejestrowane, każdy raz
walk-page-watch-stop = Zakończ obserwację
walk-page-dialog-watch = Obserwacja folderu
walk-page-begin-warned = { $count ->
    [one] 1 wymiar tej części nie ma wartości ani powodu. Ponowne naciśnięcie kończy tę część.
    [few] { $count } wymiary tej części nie mają wartości ani powodu. Ponowne naciśnięcie kończy tę część.
    [many] { $count } wymiarów tej części nie ma wartości ani powodu. Ponowne naciśnięcie kończy tę część.
   *[other] { $count } wymiarów tej części nie ma wartości ani powodu. Ponowne naciśnięcie kończy tę część.
}
walk-page-no-plan = Jeszcze bez planu: otworzyć lub utworzyć go w widoku Plan.
walk-page-plan-wrong = { $count ->
        [one] Plan ma błąd: patrz widok Plan.
        [few] Plan ma { $count } błędy: patrz widok Plan.
        [many] Plan ma { $count } błędów: patrz widok Plan.
       *[other] Plan ma { $count } błędów: patrz widok Plan.
    }
walk-page-not-saved = Plan ma niezapisane zmiany: przerwanej części nie będzie można przywrócić po ponownym uruchomieniu.
walk-page-serial = Numer seryjny
walk-page-serial-again = Numer seryjny { $serial } już zmierzono. Ponowny Enter, po pół sekundy, rozpoczyna tę część jeszcze raz.
walk-page-serial-hint = Wpisać, zeskanować lub użyć następnego numeru; Enter rozpoczyna część.
walk-page-recent = Ostatnie plany
walk-page-done = Każdy wymiar ma wartość lub jest pominięty
walk-page-part = { $part }, numer seryjny { $serial }
walk-page-part-serial = Numer seryjny { $serial }
walk-page-part-no-serial = { $part }, bez numeru seryjnego
walk-page-other-plan = Plan się od tego czasu zmienił: zmiany obowiązują od następnej części.
walk-page-part-of = Ta część jest mierzona według { $own }
walk-page-open-is = Teraz otwarty: { $open }
walk-page-begin-by = Rozpocznij część według { $open }
walk-page-keep-on = Mierz tę część dalej
walk-page-unfinished = Część mierzona według { $own } nie jest zakończona. Widok Pomiar pyta, czy ją kontynuować.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = Bez położenia w planie
walk-page-value = Wartość zmierzona
walk-page-measured-before = { $count ->
        [one] Zmierzono raz: obie wartości są zachowane, używana jest nowa
       *[other] Zmierzono { $count } razy: wszystkie wartości są zachowane, używana jest nowa
    }
walk-page-last-counts = Zmierzono { $count } razy: wszystkie wartości są zachowane, używana jest ta
walk-page-skip-why = Powód pominięcia
walk-page-skip-access = Sonda nie ma dostępu
walk-page-skip-gauge = Nie ma przyrządu
walk-page-skip-machined = Jeszcze nieobrobiony
walk-page-skip-elsewhere = Zmierzony gdzie indziej
walk-page-reason = Inny powód
walk-page-no-reason = wymagany jest powód
walk-page-skipped = pominięty: { $reason }
walk-page-next-warned = { $count ->
        [one] Jeden wymiar nie ma wartości ani powodu. Ponowny wybór „Następna część” kończy tę część.
        [few] { $count } wymiary nie mają wartości ani powodu. Ponowny wybór „Następna część” kończy tę część.
        [many] { $count } wymiarów nie ma wartości ani powodu. Ponowny wybór „Następna część” kończy tę część.
       *[other] { $count } wymiarów nie ma wartości ani powodu. Ponowny wybór „Następna część” kończy tę część.
    }
walk-page-typed-elsewhere = wartość wpisano dla { $name }, a teraz oczekiwany jest { $asked }: wpisać ją ponownie
walk-page-next-size = Następny: { $name }, { $asked }
walk-page-is-serial = { $given } wygląda na numer seryjny i nie zostaje przyjęte jako wartość: najpierw zakończyć tę część, potem zeskanować numer do następnej. Jeśli to wartość zmierzona, wpisać ją z większą liczbą miejsc po przecinku
walk-page-simulate-measured = { $name } jest zmierzony: wartość symulowana nigdy nie zastępuje zmierzonej
walk-page-part-status = Status części
walk-page-not-complete = Jeszcze bez oceny
walk-page-simulated = { $count ->
        [one] Jedna wartość jest symulowana: nikt jej nie zmierzył, więc nie daje oceny „dobry”.
        [few] { $count } wartości są symulowane: nikt ich nie zmierzył, więc nie dają oceny „dobry”.
        [many] { $count } wartości jest symulowanych: nikt ich nie zmierzył, więc nie dają oceny „dobry”.
       *[other] { $count } wartości jest symulowanych: nikt ich nie zmierzył, więc nie dają oceny „dobry”.
    }
walk-page-missing = Brakuje: { $names }
walk-page-off = Rejestrowanie jest wyłączone: przerwanej części nie będzie można przywrócić po ponownym uruchomieniu.
walk-page-nowhere = Nic nie jest rejestrowane: przerwanej części nie będzie można przywrócić po ponownym uruchomieniu.
walk-page-no-part = Żadna część nie jest mierzona.
walk-page-sizes = Wymiary części
walk-page-open = niezmierzony
walk-page-row-simulated = symulowany
walk-page-times = wartości: { $count }
walk-page-rule-plan = Ocena według reguły planu: { $rule }
walk-page-rule-own = Plan nie ma reguły; ocena według reguły ze strony Kontrola: { $rule }
walk-page-nothing-asked = żaden wymiar planu nie jest mierzony
walk-page-refused = { $count ->
        [one] Nie zarejestrowano jednej kontroli: { $why }
       *[other] Nie zarejestrowano { $count } kontroli: { $why }
    }
walk-page-import-late = { $name } odczytano po zakończeniu części: wartości nie są użyte
walk-page-imported = { $name }: zaimportowano { $good }, bez importu { $bad }
walk-page-file-for-check = Nic w pliku nie należy do tego planu. Strona Kontrola może ocenić plik według tego, co sam podaje
walk-page-found-by-name = { $count ->
    [one] Dopasowano według nazwy: 1 wiersz
    [few] Dopasowano według nazwy: { $count } wiersze
    [many] Dopasowano według nazwy: { $count } wierszy
   *[other] Dopasowano według nazwy: { $count } wierszy
}
walk-page-found-by-number = Dopasowano tylko według numeru, z liniami: { $rows }
walk-page-found-by-place = Dopasowano według położenia, z liniami: { $rows }
walk-page-other-parts = Wartości innych części są rejestrowane pod ich numerami seryjnymi: { $serials }
walk-page-label = Plik nie ma numerów seryjnych i nazywa część { $part }: jego wartości przyjęto dla tej części
walk-page-other-label = dotyczy części { $part }, a bez numeru seryjnego nie wiadomo, czy to ta część
walk-page-remark-label = Część w pliku: { $part }
walk-page-not-judged = linia { $line }: { $why }
walk-page-no-journal = Część { $serial } przywrócono bez wartości: nie ma zapisów, z których można je przywrócić
walk-page-gone = Niektórych wymiarów nie ma już w planie: ich wartości zmierzone pozostają w zapisach
walk-page-gone-name = { $name }
walk-page-changed = Plan się zmienił: wartości ocenione według innych granic lub innej reguły oraz wartości wierszy bez nazwy pozostają w zapisach, a ich wymiary są znowu do zmierzenia
walk-page-changed-size = { $name }: { $measured } mm zmierzono dla { $asked }
walk-page-given-up = Przerwana część { $serial } nie zostaje przywrócona, bo rozpoczęto inną część: jej wartości pozostają w zapisach
walk-page-ended = Nie użyto dla zakończonej części { $serial }
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = Wartość { $name } skorygowano lub wycofano w zapisach: nie dotyczy już tej części
walk-page-put-right = Wartość { $name } skorygowano w zapisach: dla tej części obowiązuje skorygowana
walk-page-no-folder = { $path } nie jest folderem
walk-page-not-read = Nie można było odczytać wartości przerwanej części: { $why }
walk-page-came-back = { $count ->
        [one] Przywrócono przerwaną część { $serial } z jedną wartością
        [few] Przywrócono przerwaną część { $serial } z { $count } wartościami
        [many] Przywrócono przerwaną część { $serial } z { $count } wartościami
       *[other] Przywrócono przerwaną część { $serial } z { $count } wartościami
    }
walk-page-watched = Obserwowany folder
walk-page-part-waits = Część { $serial } zostanie przywrócona, gdy jej plan nie będzie miał błędów
walk-page-watch-waits = Folder { $path } będzie znowu obserwowany, gdy plan nie będzie miał błędów
walk-page-watch-no-plan = obserwacja folderu wymaga planu bez błędów: najpierw go otworzyć
walk-page-watch-no-journal = nie można otworzyć dziennika: nie wiadomo, które pliki już zaimportowano, więc żaden folder nie jest obserwowany
walk-page-watch-begins = Szukanie w dzienniku plików już zaimportowanych
walk-page-known = { $count ->
        [0] W dzienniku nie ma plików już zaimportowanych
        [one] W dzienniku jest jeden plik już zaimportowany, z dowolnego folderu: nie zostanie zaimportowany ponownie
        [few] W dzienniku są { $count } pliki lub części plików już zaimportowane, z dowolnego folderu: nie zostaną zaimportowane ponownie
        [many] W dzienniku jest { $count } plików lub części plików już zaimportowanych, z dowolnego folderu: nie zostaną zaimportowane ponownie
       *[other] W dzienniku jest { $count } plików lub części plików już zaimportowanych, z dowolnego folderu: nie zostaną zaimportowane ponownie
    }
walk-page-mask = Wydruk FN 16 jest odczytywany przez maskę { $name }
walk-page-watch-recording = Rejestrowanie
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] Zaimportowano jeden plik
        [few] Zaimportowano { $count } pliki
        [many] Zaimportowano { $count } plików
       *[other] Zaimportowano { $count } plików
    }
walk-page-report = Raport…
walk-page-report-people = Raport z kontroli ({ $format })…
walk-page-report-programs = Wartości części jako { $format }…
walk-page-contradicted = { $names }: wartości są sprzeczne i nic nie mówi, która jest właściwa. Liczy się najgorsza, do powtórzenia pomiaru lub wyboru.
walk-page-contradicting = { $name } ma sprzeczne wartości: { $values }. Liczy się najgorsza, do powtórzenia pomiaru lub wyboru.
walk-page-count-newest = Liczy się ostatnia
walk-page-newest-counts = { $name }: liczy się ostatnia wartość, zgodnie z wyborem
walk-page-accepted = Przyjęte poza granicami: { $names }
walk-page-because = Z powodu: { $names }
walk-page-left-out = Pominięte: { $names }. Część z pominiętymi wymiarami nie może mieć oceny „dobry”.
walk-page-whole = Cała część
walk-page-whole-serial = Część { $serial }
walk-page-strip-open = Część: jeszcze bez oceny
walk-page-strip-part = Część: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Zmierzono według planu { $name }
walk-page-judged-by-plan = Oceniono według planu { $name }
walk-page-watch-no-mask = Nie można odczytać własnej maski { $path }: folder będzie obserwowany po ponownym wyborze tej lub innej maski (Menu, Własna maska…)
walk-page-watch-nobody = { $count ->
        [one] Jedną wartość zarejestrowano bez numeru seryjnego: plik go nie podaje i żadna część nie jest mierzona według tego planu
        [few] { $count } wartości zarejestrowano bez numeru seryjnego: plik go nie podaje i żadna część nie jest mierzona według tego planu
        [many] { $count } wartości zarejestrowano bez numeru seryjnego: plik go nie podaje i żadna część nie jest mierzona według tego planu
       *[other] { $count } wartości zarejestrowano bez numeru seryjnego: plik go nie podaje i żadna część nie jest mierzona według tego planu
    }
walk-page-watch-other-plan = Folder jest oceniany według planu z chwili rozpoczęcia obserwacji. Aby oceniać według obecnego planu, rozpocząć część lub ponownie włączyć obserwację folderu.
walk-page-watch-not-saved = Plan ma niezapisane zmiany: po ponownym uruchomieniu folder nie będzie obserwowany.
walk-page-values = Wartości { $name }
walk-page-to-do = { $name }: { $what }
walk-page-of = wymiar { $at } z { $count }
walk-page-no-serial = Bez numeru seryjnego
