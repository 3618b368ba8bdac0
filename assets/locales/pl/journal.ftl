## The chain of a journal
journal-hex = "{ $text }" nie ma { $digits } cyfr szesnastkowych
journal-break-changed = wpis { $number } nie jest tym, który zapisano
journal-break-removed = { $count ->
        [one] brakuje wpisu { $number }
       *[other] brakuje { $count } wpisów od { $number }
    }
journal-break-inserted = wpis { $number } wstawiono
journal-break-reordered = wpisy { $number } i { $other } zamieniono miejscami
journal-break-rewritten = wpis { $number } różni się od znanego z innego miejsca: dziennik zapisano od nowa od tego lub wcześniejszego wpisu
journal-break-cut-off = dziennik kończy się wpisem { $last }, a z innego miejsca znany jest wpis { $known }: najnowsze wpisy ucięto lub przywrócono starszą kopię

## Entries
journal-body-json = to nie wpis dziennika: { $reason }
journal-body-newer = utworzony przez nowszy Fitcheck: wersja formatu { $version }, ten Fitcheck czyta wersje do { $known }
journal-body-too-large = to nie wpis dziennika: { $bytes } { $bytes ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }, dozwolone najwyżej { $most }
journal-body-too-long = { $field } ma { $bytes } { $bytes ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }, dozwolone najwyżej { $most }
journal-body-control = { $field } ma znak sterujący { $code } na miejscu { $place }: teksty dziennika to jedna linia bez znaków sterujących
journal-body-empty = { $field } jest puste
journal-body-too-many = liczba pozycji w { $field }: { $count }, dozwolone najwyżej { $most }
journal-body-value = { $field } nie może być "{ $given }"
journal-body-contradiction = { $field } przeczy polom, z których wynika
journal-origin-perfect = symulacja, detal bez błędów
journal-origin-workpiece = symulacja, { $file }, ziarno { $seed }
journal-origin-contacts = punkty pomiarowe z { $file }
journal-check-judged-otherwise = rozstrzygnięto: { $kept } i to obowiązuje; ta wersja Fitcheck rozstrzyga: { $now }

## Questions
journal-ask-at = { $reason } (znak { $at })
journal-ask-unknown-key = { $key }: nie jest znanym słowem kluczowym; oczekiwane { $known } lub cudzysłów wokół słowa z dwukropkiem
journal-ask-no-value = { $key }: nie ma wartości
journal-ask-empty-word = słowo w cudzysłowie jest puste
journal-ask-twice = { $key } podano dwa razy
journal-ask-not-closed = cudzysłów nie jest zamknięty
journal-ask-after-quote = po zamknięciu cudzysłowu oczekiwana spacja, jest { $found }
journal-ask-date = "{ $given }" nie jest dniem ani czasem: oczekiwane 2026-11-23 lub 2026-11-23T14:30
journal-ask-verdict = "{ $given }" nie jest oceną: oczekiwane { $known }
journal-ask-callout = { $error }; wymiar tolerowany pisze się w cudzysłowie: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = okres kończy się przed początkiem: from musi być przed to
journal-ask-both-origins = simulated i measured wykluczają się
journal-ask-both-kinds = reports i checks wykluczają się
journal-ask-too-long = zapytanie ma { $bytes } { $bytes ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }, dozwolone najwyżej { $most }

## The journal of a station
store-missing = w { $path } nie ma dziennika
store-not-a-file = { $path } nie jest plikiem
store-not-a-journal = { $path } nie jest dziennikiem Fitcheck; pozostawiono bez zmian
store-newer = { $path } utworzył nowszy Fitcheck (wersja { $version }, ten obsługuje { $known }); pozostawiono bez zmian
store-older = { $path } utworzył starszy Fitcheck: zostanie zaktualizowany przy pierwszym rejestrowaniu
store-damaged = { $path } jest uszkodzony: jego strony są sprzeczne
store-full = nie ma już miejsca na { $path }: niczego nie zarejestrowano
store-read-only = w { $path } nie wolno zapisywać: niczego nie zarejestrowano
store-locked = inny program zbyt długo blokuje { $path }: niczego nie zarejestrowano
store-disk = dysk z { $path } zgłasza błąd: { $reason }
store-cannot-open = nie można otworzyć { $path }
store-network-folder = { $path } jest w folderze innej maszyny, gdzie dwa stanowiska mogłyby nadpisywać sobie wpisy: wybrać folder na tej maszynie i serwer dla warsztatu
store-altered = w { $path } brakuje "{ $name }", które chroni wpisy przed zmianą, lub je zmieniono
store-no-beginning = { $path } nie mówi, który to łańcuch
store-moved = { $path } w międzyczasie przeniesiono lub odłożono: niczego nie zarejestrowano
store-other-target = wpis { $number } nie jest tym, który miał być skorygowany: niczego nie zarejestrowano
store-corrected = wpis { $number } został już skorygowany lub wycofany wpisem { $by }: skorygować tamten, chyba że jest wycofaniem
store-is-report = wpis { $number } to raport: mówi, który plik zapisano, i nie można go skorygować ani wycofać
store-is-alarm = wpis { $number } to alarm karty kontrolnej: mówi, która reguła zadziałała, i nie można go skorygować ani wycofać; należy na niego odpowiedzieć
store-no-alarm = wpis { $number } nie jest alarmem karty kontrolnej: odpowiedzieć można tylko na alarm
journal-alarm-since-part = { $rule }, od części { $serial }
journal-alarm-since-entry = { $rule }, od zapisu { $number }
store-other-journal = wpis { $number } tego dziennika nie jest tym, który podaje raport: niczego nie zarejestrowano
store-finding-no-beginning = dziennik nie ma pierwszego wpisu, który nazywa łańcuch
store-finding-pages = strony dziennika są sprzeczne, a zapytania mogą nie znaleźć wpisów, które w nim są: { $reason }
store-finding-index = indeks zapytań nie zgadza się z tabelą: { $reason }
store-hidden = wpisu { $number } w { $path } nie ma na swoim miejscu: dziennik zmieniono lub plik jest uszkodzony; uruchomić fitcheck journal verify
store-no-entry = w { $path } nie ma wpisu { $number }: ostatni to { $last }
store-backup = kopia { $path } była niekompletna i została usunięta
store-interrupted = zatrzymano
store-database = { $path }: { $reason }
store-remark-begun = utworzono nowy dziennik: { $path }
store-remark-set-aside = dziennik { $path } był uszkodzony: jest teraz bez zmian w { $folder }, a na jego miejscu utworzono nowy
store-remark-migrated = { $path } zaktualizowano do tej wersji; plik w poprzednim stanie to { $copy }
store-remark-behind = { $path } kończy się wpisem { $last }, a miał już wpis { $known }: najnowsze wpisy ucięto lub przywrócono starszą kopię
store-remark-other = wpis { $number } w { $path } różni się od wcześniejszego: dziennik zapisano od nowa od tego lub wcześniejszego wpisu
store-remark-replaced = { $path } nie jest dziennikiem, który był tam wcześniej i miał { $known } { $known ->
        [one] wpis
        [few] wpisy
        [many] wpisów
       *[other] wpisów
    }
store-remark-waits = inny program zapisuje w { $path }: oczekiwanie na jego koniec
store-remark-no-anchor = ostatniego wpisu tego dziennika nie można było odnotować w { $path }: { $reason }
store-finding-altered = brakuje "{ $name }", które chroni wpisy przed zmianą, lub je zmieniono
store-finding-not-found = { $entries ->
        [one] 1 wpis jest zindeksowany niezgodnie z treścią lub wcale
        [few] { $entries } wpisy są zindeksowane niezgodnie z treścią lub wcale
        [many] { $entries } wpisów jest zindeksowanych niezgodnie z treścią lub wcale
       *[other] { $entries } wpisów jest zindeksowanych niezgodnie z treścią lub wcale
    }
