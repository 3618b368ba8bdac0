## The server of a shop: its address
shop-address-scheme = adres serwera zaczyna się od postgres://
shop-address-no-host = adres nie podaje serwera: wpisać postgres://USER@HOST/DATABASE
shop-address-no-user = adres nie podaje użytkownika: wpisać postgres://USER@HOST/DATABASE
shop-address-at = adres ma o jeden @ za dużo: w haśle lub nazwie wpisać %40 zamiast @, %2F zamiast / i %3F zamiast ?
shop-address-unreadable = nie można odczytać adresu serwera: { $reason }
shop-address-mode = sslmode "{ $given }" jest nieznane: wpisać disable, require, verify-ca lub verify-full
shop-address-plain = sslmode=disable dotyczy tylko serwera na tym komputerze, a { $host } to inny

## Its password
shop-password-open = pominięto plik haseł, bo mogą go czytać inni użytkownicy (zapobiega temu chmod 600): { $path }
shop-password-unread = pominięto plik haseł: { $what }
shop-password-no-keyring = systemowa baza kluczy nie zwróciła hasła: { $reason }

## Why it could not be asked
shop-unreachable = nie można połączyć się z { $address }: { $reason }
shop-lost = utracono połączenie z serwerem: { $reason }
shop-full = serwer nie ma już miejsca
shop-busy = serwer prosi o odczekanie: { $reason }
shop-no-password = serwer pyta o hasło użytkownika "{ $user }", a żadnego nie znaleziono: ustawić PGPASSWORD lub wpisać je do pliku haseł albo systemowej bazy kluczy
shop-refused = serwer odrzuca tego użytkownika: { $reason }
shop-no-tls = serwer nie oferuje TLS, a bez niego nic nie jest wysyłane do innego komputera
shop-certificate = certyfikat serwera nie jest akceptowany: { $fault }
shop-certificate-unknown-issuer = nie wystawił go urząd, któremu ufa ten komputer; plik własnego urzędu warsztatu podaje się w adresie przez sslrootcert=FILE
shop-certificate-other-name = jest dla innego hosta niż w adresie
shop-certificate-expired = wygasł
shop-certificate-not-yet = nie jest jeszcze ważny
shop-certificate-other = { $reason }
shop-authorities = nie można użyć certyfikatów urzędów: { $reason }: { $path }
shop-no-authorities = ten komputer nie ufa żadnemu urzędowi: plik własnego urzędu warsztatu podać w adresie przez sslrootcert=FILE
shop-not-made = baza danych "{ $database }" nie ma jeszcze dziennika: najpierw uruchomić fitcheck journal init-shop z jej adresem
shop-no-right = serwer nie pozwala na to temu użytkownikowi: { $reason }
shop-foreign = baza danych ma schemat "fitcheck", którego nie utworzył Fitcheck; pozostawiono bez zmian
shop-newer = dziennik na serwerze utworzył nowszy Fitcheck (wersja { $version }, ten obsługuje { $known }); pozostawiono bez zmian
shop-old-server = PostgreSQL { $version } jest za stary: wymagana wersja { $oldest } lub nowsza
shop-encoding = teksty tej bazy danych są w { $encoding }: utworzyć bazę z ENCODING 'UTF8'
shop-other-login = ten dziennik należy na serwerze do "{ $login }", a "{ $ours }" nie może do niego dodawać
shop-fork = wpis { $number } na serwerze ({ $theirs }) różni się od tutejszego ({ $ours }): są dwie kopie tego dziennika lub go zmieniono
shop-ahead = liczba wpisów tego dziennika na serwerze: { $theirs }, tutaj tylko { $ours }: przywrócono starszą kopię lub są dwie kopie
shop-not-text = wpisu { $number } nie można wysłać: jego bajty nie są tekstem
shop-too-long = wpisu { $number } nie można wysłać: ma { $bytes } { $bytes ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }
shop-server = serwer zgłasza: { $reason } ({ $code })
shop-journal = { $what }
shop-machine = ten komputer nie może tego zrobić: { $reason }
shop-stopped = zatrzymano

## Its schema
shop-made-new = utworzono dziennik w bazie danych (wersja { $version })
shop-made-upgraded = dziennik w bazie danych zaktualizowano z wersji { $from } do wersji { $version }
shop-made-already = dziennik już istniał (wersja { $version })

## What is wrong on it
shop-finding-altered = na serwerze brakuje "{ $name }", które chroni wpisy przed zmianą, lub je wyłączono
shop-finding-row-security = tabela "{ $name }" nie ogranicza już stanowisk do ich własnych dzienników: jej ochrona wierszy jest wyłączona
shop-finding-chain-name = dziennik na serwerze ma nieprawidłową nazwę: { $name }
shop-finding-changed = { $kind } "{ $name }" na serwerze: stan inny niż po init-shop: ustalić, kto to zmienił, i uruchomić init-shop
shop-finding-gone = na serwerze brakuje: { $kind } "{ $name }": ustalić, kto to usunął, i uruchomić init-shop
shop-finding-strange = na serwerze jest, lecz nie z init-shop: { $kind } "{ $name }": ustalić, kto to utworzył
shop-thing-function = funkcja
shop-thing-grant = uprawnienie do
shop-thing-index = indeks
shop-thing-owner = właściciel
shop-thing-policy = polityka
shop-thing-role = rola
shop-thing-rule = reguła
shop-thing-table = tabela, kolumna lub warunek
shop-thing-trigger = wyzwalacz
shop-thing-view = widok
