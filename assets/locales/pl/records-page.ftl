page-records = Zapisy

## What is recorded with a check
records-page-fold = Zapis
records-page-fold-hint = Numer seryjny i uwaga są rejestrowane z następnymi kontrolami
records-page-serial = Numer seryjny
records-page-serial-short = Nr seryjny
records-page-remark = Uwaga
records-page-feature = Element
records-page-record = Zapis { $number }
records-page-waiting = Rejestrowanie
records-page-not-recorded = Nie zarejestrowano: { $why }
records-page-nowhere = Kontrole nie są rejestrowane: nie ma dla nich folderu danych
records-page-off = Kontrole nie są rejestrowane: rejestrowanie wyłączono w pliku stanu
records-page-opening = Trwa otwieranie dziennika
records-page-how-on = Sekcja [records] pliku stanu, state.toml, podaje plik dziennika i to, czy kontrole są rejestrowane.
records-page-not-opened = Nie można otworzyć dziennika, kontrole nie są rejestrowane: { $why }
records-page-not-kept = { $count ->
    [one] 1 kontrola nie jest zarejestrowana: { $why }
    [few] { $count } kontrole nie są zarejestrowane: { $why }
    [many] { $count } kontroli nie jest zarejestrowanych: { $why }
   *[other] { $count } kontroli nie jest zarejestrowanych: { $why }
}
records-page-refused = { $count ->
    [one] 1 kontroli nie można zarejestrować: { $why }
   *[other] { $count } kontroli nie można zarejestrować; powód przy pierwszej: { $why }
}
records-page-not-kept-why = dziennik nie odpowiedział
records-page-no-thread = system nie może uruchomić wątku dla dziennika
records-page-interrupted = przerwano
records-page-failed = { $count ->
    [one] 1 kontrola nie jest zarejestrowana
    [few] { $count } kontrole nie są zarejestrowane
    [many] { $count } kontroli nie jest zarejestrowanych
   *[other] { $count } kontroli nie jest zarejestrowanych
}
records-page-try-again = Spróbuj ponownie
records-page-stay = Zapisy pozostają w dzienniku
records-page-leave = { $count ->
    [one] 1 kontrola nie jest jeszcze zarejestrowana. Zamknięcie okna oznacza jej utratę.
    [few] { $count } kontrole nie są jeszcze zarejestrowane. Zamknięcie okna oznacza ich utratę.
    [many] { $count } kontroli nie jest jeszcze zarejestrowanych. Zamknięcie okna oznacza ich utratę.
   *[other] { $count } kontroli nie jest jeszcze zarejestrowanych. Zamknięcie okna oznacza ich utratę.
}

## Who is measuring
records-page-who = Zmierzył(a)
records-page-nobody = Nazwisko…
records-page-who-nobody = Nie wybrano nazwiska. Wybrać nazwisko
records-page-who-is = Zmierzył(a) { $name }
records-page-nobody-named = Bez nazwiska
records-page-new-name = Inne nazwisko
records-page-take-name = Użyj tego nazwiska

## The question
records-page-question = Szukaj
records-page-help = Słowa, dobry poprawka brak, lub part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = Więcej
records-page-today = Dziś
records-page-this-week = Ten tydzień
records-page-not-good = Niedobre
records-page-measured-only = Tylko zmierzone
records-page-filter = Filtr
records-page-filter-hint = Zawęża listę według części, numeru seryjnego, daty i innych
records-page-add-filter = Dodaj filtr
records-page-filter-by = Filtruj według
records-page-filter-value = Wartość
records-page-from = Od
records-page-to = Do
records-page-standing = Ważne
records-page-simulated-only = Tylko symulowane
records-page-reports-only = Tylko raporty
records-page-alarms-only = Tylko alarmy
records-page-checks-only = Bez raportów
records-page-remove-filter = Usuń filtr { $filter }
records-page-looking = Szukanie
records-page-count = { $many ->
    [one] 1 zapis
    [few] { $count } zapisy
    [many] { $count } zapisów
   *[other] { $count } zapisów
}
records-page-more = { $count }+ zapisów
records-page-unread = Nie można odczytać dziennika: { $why }
records-page-none = żaden dziennik nie jest otwarty
records-page-missing = Brakuje zapisu { $number }
records-page-empty = Kontrole pojawią się tu po zarejestrowaniu
records-page-none-found = Żaden zapis nie pasuje

## The list
records-page-list = Zapisy
records-page-head-number = Nr
records-page-zone = W polu tol.
records-page-move = Przejdź do innego zapisu
records-page-open = Otwórz zapis
records-page-choose = Zaznacz do raportu
records-page-choose-record = Zaznacz zapis { $number } do raportu
records-page-chosen = { $count ->
    [one] 1 zaznaczony
    [few] { $count } zaznaczone
    [many] { $count } zaznaczonych
   *[other] { $count } zaznaczonych
}
records-page-copy = Kopiuj
records-page-report-of = Raport ({ $count })…
records-page-reports-listed = Raport obejmuje wszystkie zapisy z listy: { $count }
records-page-reports-chosen = Raport obejmuje zaznaczone zapisy: { $count }
records-page-too-many = Liczba zapisów na liście: { $count }. Raport lub wybór obejmuje najwyżej { $most }: zawęzić listę, np. według części lub daty
records-page-still-looking = Lista nie jest jeszcze kompletna. Spróbować ponownie, gdy pojawi się liczba zapisów
records-page-nothing-to-report = Żaden zapis z listy nie nadaje się do raportu: są nieważne, symulowane lub z cykli
records-page-report = Raport…
records-page-with-simulated = Z kontrolami symulowanymi
records-page-with-simulated-hint = Kontrole symulowane nie są dowodem; raport podaje, że je zawiera
records-page-report-simulated = { $count ->
    [one] 1 z tych kontroli jest symulowana: nie jest dowodem
    [few] { $count } z tych kontroli są symulowane: nie są dowodem
    [many] { $count } z tych kontroli jest symulowanych: nie są dowodem
   *[other] { $count } z tych kontroli jest symulowanych: nie są dowodem
}
records-page-report-from = Z dziennika { $chain }, zapisy { $numbers }; najnowszy wpis to { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] pominięto 1 kontrolę symulowaną
    [few] pominięto { $count } kontrole symulowane
    [many] pominięto { $count } kontroli symulowanych
   *[other] pominięto { $count } kontroli symulowanych
}
records-page-out-replaced = { $count ->
    [one] pominięto 1 zapis skorygowany lub wycofany
    [few] pominięto { $count } zapisy skorygowane lub wycofane
    [many] pominięto { $count } zapisów skorygowanych lub wycofanych
   *[other] pominięto { $count } zapisów skorygowanych lub wycofanych
}
records-page-report-corrects = { $count ->
    [one] 1 wartość zastępuje skorygowany zapis
    [few] { $count } wartości zastępują skorygowane zapisy
    [many] { $count } wartości zastępuje skorygowane zapisy
   *[other] { $count } wartości zastępuje skorygowane zapisy
}
records-page-out-cycles = { $count ->
    [one] pominięto 1 zapis z cyklu
    [few] pominięto { $count } zapisy z cykli
    [many] pominięto { $count } zapisów z cykli
   *[other] pominięto { $count } zapisów z cykli
}
records-page-out-reports = { $count ->
    [one] Pominięto 1 raport lub alarm: nie jest kontrolą
    [few] Pominięto { $count } raporty i alarmy: nie są kontrolami
    [many] Pominięto { $count } raportów i alarmów: nie są kontrolami
   *[other] Pominięto { $count } raportu i alarmu: nie są kontrolami
}
records-page-out-unread = { $count ->
    [one] pominięto 1 zapis, którego nie można odczytać
    [few] pominięto { $count } zapisy, których nie można odczytać
    [many] pominięto { $count } zapisów, których nie można odczytać
   *[other] pominięto { $count } zapisów, których nie można odczytać
}
records-page-see = Nieważny, patrz { $number }
records-page-void = Zapis { $number }, nieważny: patrz { $by }
records-page-instead = zamiast { $number }
records-page-takes-back = Wycofuje { $number }
records-page-withdrawal = Wycofanie
records-page-report-entry = Raport
records-page-alarm = Alarm
records-page-alarm-answers = Odpowiedź na alarm { $number }
records-page-alarm-answered = Alarm, odpowiedź { $number }
records-page-alarm-first = Pierwsza wartość: { $number }
records-page-alarm-last = Wartość, przy której reguła zadziałała: { $number }
records-page-cycle = Cykl { $cycle }
records-page-went-back = { $time } (zegar)

## An open record
records-page-close = Wróć do listy
records-page-reading = Odczyt zapisu
records-page-measure-again = Powtórz pomiar
records-page-measure-again-hint = Przenosi wymiar tolerowany, część, numer seryjny i regułę na stronę Kontrola
records-page-correct = Skoryguj…
records-page-correct-hint = Dodaje zapis w miejsce tego; oba pozostają
records-page-simulated = Symulowany: nikt tego nie zmierzył
records-page-corrected-by = Skorygowany lub wycofany zapisem { $number }
records-page-corrects = W miejsce zapisu { $number }
records-page-in-report = W raporcie { $number }, { $name }
records-page-reports-unread = Nie można odczytać raportów z tą kontrolą: { $why }
records-page-report-unknown = { $name } został zapisany, ale dziennik go nie zna: { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, otwór
    [neither] { $callout }, ani otwór, ani wałek
   *[shaft] { $callout }, wałek
}
records-page-distance = Od granic
records-page-importer = Zaimportował(a)
records-page-void-why = Nieważny, powód
records-page-void-by = Skorygował(a) lub wycofał(a)
records-page-decided = Decyzja
records-page-limits = Granice
records-page-source = Źródło granic
records-page-contacts = Punkty pomiarowe
records-page-rule = Reguła
records-page-station = Stanowisko
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = Zegar stanowiska cofnięto przed tym zapisem
records-page-cycle-number = Cykl
records-page-program = Program
records-page-block = { $program }, linia { $line }
records-page-datum = Punkt odniesienia
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, ustawiony w linii { $line }: { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = osie obrócone o { $angle }°, od linii { $line }: { $block }
records-page-datum-tilt = płaszczyzna nachylona o A { $a }°, B { $b }°, C { $c }°, od linii { $line }: { $block }
records-page-parameters = Parametry
records-page-figures = Wyniki
records-page-file-measurements = Pomiary
records-page-file-program = Program
records-page-file-workpiece = Detal
records-page-file-budget = Budżet niepewności
records-page-report-file = Plik
records-page-report-format = Format
records-page-report-size = Rozmiar
records-page-report-bytes = { $count } B
records-page-report-title = Tytuł
records-page-report-sha256 = SHA-256
records-page-report-checks = Zarejestrowane kontrole
records-page-report-numbers = Ich zapisy
records-page-report-unrecorded = Kontrole bez zapisu
records-page-report-head = Najnowszy wpis wtedy
records-page-chain = Łańcuch
records-page-chain-name = Dziennik
records-page-hash = Skrót

## A correction
records-page-correction = Korekta zapisu { $number }
records-page-correction-rule = Ponowna ocena tak jak zapisu { $number }: { $rule }.
records-page-correction-temperature = Skorygowano z { $temperature } °C do 20 °C.
records-page-correction-rest = Część, numer seryjny, nazwisko
records-page-correction-hint = Nowy zapis wchodzi w miejsce tego. Oba pozostają w dzienniku.
records-page-corrector = Skorygował(a)
records-page-reason = Powód
records-page-reason-mistyped = pomyłka przy wpisie
records-page-reason-wrong-part = niewłaściwa część
records-page-reason-trial = próba
records-page-withdrawal-hint = Zapis przestaje się liczyć i nic nie wchodzi na jego miejsce. Oba wpisy pozostają w dzienniku.
records-page-withdraw = Wycofaj zapis
records-page-withdraw-hint = Nic nie wchodzi na jego miejsce
records-page-withdraw-neither = Zapis { $number }, który ten koryguje, nie liczy się przez to ponownie
records-page-send-correction = Zarejestruj korektę
records-page-leave-correction = Anuluj
records-page-undo-void = Nie cofnięto: zapis wycofano po korekcie
records-page-undone-reason = cofnięto
records-page-taken-back = { $checks ->
    [one] cofnięto 1 kontrolę
    [few] cofnięto { $checks } kontrole
    [many] cofnięto { $checks } kontroli
   *[other] cofnięto { $checks } kontroli
}; { $records ->
    [one] wycofano zapis { $numbers }
   *[other] wycofano zapisy { $numbers }
}
records-page-taken-back-unwritten = { $checks ->
    [one] cofnięto 1 kontrolę; nie była jeszcze zarejestrowana i nie będzie
    [few] cofnięto { $checks } kontrole; nie były jeszcze zarejestrowane i nie będą
    [many] cofnięto { $checks } kontroli; nie były jeszcze zarejestrowane i nie będą
   *[other] cofnięto { $checks } kontroli; nie były jeszcze zarejestrowane i nie będą
}
records-page-not-withdrawn = { $records ->
    [one] Zapis { $numbers } nadal się liczy i nie można było go wycofać: { $why }
   *[other] Zapisy { $numbers } nadal się liczą i nie można było ich wycofać: { $why }
}
records-page-undone = Korektę cofnięto
records-page-no-reason = Korekta wymaga powodu
records-page-nothing-changed = Nic się nie różni: zmienić pole lub wycofać zapis
records-page-not-open = Zapis nie jest otwarty
records-page-not-recording = Kontrole nie są rejestrowane

## The journal
records-page-place = { $file } · wpisy: { $entries }
records-page-unsent = jeszcze niewysłane do { $server }: { $count }
records-page-all-sent = wszystko wysłano do { $server }
records-page-server-unknown = { $server }: jeszcze bez połączenia
records-page-server = Serwer warsztatu
records-page-server-hint = Wysyła każdy zapis w tle do serwera PostgreSQL; bez niego wszystko pozostaje na tym komputerze
records-page-server-address = Adres, np. postgres://frez3@warsztat.example/checks
records-page-server-passwords = Hasło pochodzi z adresu, PGPASSWORD, pliku haseł lub systemowej bazy kluczy. Hasło z adresu trafia do bazy kluczy i nigdzie indziej.
records-page-take-server = Użyj tego serwera
records-page-leave-server = Przestań wysyłać
records-page-send-again = Wyślij ponownie
records-page-not-sent = Nie wysłano: { $why }
records-page-and = { $one }; { $other }
records-page-no-shop = ten Fitcheck zbudowano bez obsługi serwera warsztatu (feature shop)
records-page-in-keyring = Hasło do { $server } jest teraz w systemowej bazie kluczy
records-page-not-in-keyring = Hasła do { $server } nie można było umieścić w systemowej bazie kluczy ({ $reason }): obowiązuje do zamknięcia okna, potem musi pochodzić z PGPASSWORD lub pliku haseł
records-page-verify = Zweryfikuj
records-page-verify-hint = Porównuje każdy wpis z poprzednim
records-page-verify-cancel = Przerwij weryfikację
records-page-verify-cancelled = Weryfikację przerwano
records-page-verify-progress = Postęp weryfikacji
records-page-verifying = wpisy: { $done } z { $of }
records-page-whole = { $time }: zweryfikowane wpisy: { $entries }, do { $number } ({ $hash })
records-page-broken = { $time }: sprawdzone wpisy: { $entries }; dziennik nie jest taki, jaki zapisano
records-page-not-verified = { $time }: nie zweryfikowano: { $why }
records-page-no-anchors = nie można odczytać wpisów znanych z innych miejsc: { $why }
