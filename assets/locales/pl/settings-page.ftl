page-settings = Ustawienia

# Sekcje
settings-page-find = Znajdź ustawienie
settings-page-sections = Sekcja
settings-page-general = Ogólne
settings-page-appearance = Wygląd
settings-page-rule = Reguła i granice
settings-page-own-files = Własne pliki
settings-page-records = Zapisy
settings-page-shop-server = Serwer
settings-page-folders = Foldery
settings-page-keys = Klawisze
settings-page-about = O programie
settings-page-nothing = Żadne ustawienie nie zawiera tych słów
settings-page-defaults = Przywróć domyślne
settings-page-defaults-hint = Ustawia tę sekcję jak przy pierwszym uruchomieniu. Pliki, nazwiska i adresy pozostają.

# Ogólne
settings-page-language-about = Wszystkie teksty okna i jego znak dziesiętny.
settings-page-own-texts = Własne teksty
settings-page-own-texts-about = Słowa warsztatu zamiast wbudowanych: plik Fluent dla jednego języka, na przykład nl_OurShop.ftl.
settings-page-own-texts-count = { $file }: własne teksty { $count } z { $all }
settings-page-own-texts-reading = { $file }: trwa odczyt
settings-page-own-texts-unread = { $file }: nie można było odczytać, nie jest używany: { $why }
settings-page-own-texts-elsewhere = Język tych tekstów to { $language }; liczą się tylko wtedy, gdy okno jest w tym języku.
settings-page-own-texts-refused = { $count ->
    [one] 1 tekst odrzucono i używany jest wbudowany:
    [few] { $count } teksty odrzucono i używane są wbudowane:
    [many] { $count } tekstów odrzucono i używane są wbudowane:
   *[other] { $count } tekstu odrzucono i używane są wbudowane:
}
settings-page-own-texts-more = … i jeszcze { $count }
load-texts = Własne teksty…
no-own-texts = Nie używaj własnych tekstów
dialog-own-texts = Własne teksty
file-kind-own-texts = Teksty
settings-page-keypad-about = Duże klawisze do ekranów dotykowych i rękawic.
sounds = Dźwięki
sounds-about = Każdą ocenę słychać: jeden długi ton to dobry, dwa tony proszą o spojrzenie na część, trzy to brak. Wartości symulowanych nie słychać.
sounds-failed = Nie słychać dźwięku: { $reason }
sounds-no-player = Nie słychać dźwięku: na tym komputerze nie ma żadnego z tych programów: { $players }
settings-page-shop = Ustawienia dla całego warsztatu
settings-page-shop-about = Jeden plik dla innych stanowisk. Nie ma w nim nazwiska, adresu serwera ani wymiaru tolerowanego.
settings-page-export = Eksportuj ustawienia…
settings-page-import = Importuj ustawienia…
settings-page-dialog-export = Eksport ustawień
settings-page-dialog-import = Import ustawień
settings-page-imported = { $count ->
    [0] { $name }: bez różnic
    [one] { $name }: zmieniono 1 ustawienie
    [few] { $name }: zmieniono { $count } ustawienia
    [many] { $name }: zmieniono { $count } ustawień
   *[other] { $name }: zmieniono { $count } ustawień
}
settings-page-unknown-key = { $key } nie jest ustawieniem tej wersji. Eksport je zachowuje.
settings-page-no-version = plik nie ma wersji: nie jest plikiem ustawień
settings-page-edition = Wydanie ISO 286
file-kind-settings = Ustawienia

# Wygląd
settings-page-colours = Kolory
settings-page-colours-about = Ocena ma też słowo i kształt, niezależnie od koloru.
settings-page-zoom = Powiększenie
settings-page-zoom-about = Skaluje wszystko. Klawisze: Ctrl z plusem, minusem i 0.
settings-page-zoom-out = Pomniejsz
settings-page-zoom-in = Powiększ
settings-page-zoom-normal = Powiększenie 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automatycznie: dotyk powiększa przyciski i pola, mysz je zmniejsza.
settings-page-decimal = Znak dziesiętny
settings-page-decimal-about = W oknie. Raporty: według swojego języka, pliki: według własnych ustawień.
settings-page-decimal-of-language = Według języka
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Wiersze list
settings-page-rows-about = Wysokość wierszy tabel: zwykła 32 px, mała 26 px. Przy dotyku zawsze 48 px.
settings-page-rows-usual = Zwykła
settings-page-rows-close = Mała

# Reguła i granice
settings-page-limits-about = Skąd brane są granice klasy. Własne tabele są zawsze pierwsze.
settings-page-js-about = Do rysunków według wydania z 1988, stopnie od 7 do 11. W innych przypadkach połówki mikrometra pozostają.
settings-page-1988-about = Do rysunków według wydania z 1988. W innych przypadkach są zdefiniowane także dla większych wymiarów.
settings-page-decision-rule = Reguła decyzyjna
settings-page-decision-rule-about = Jaka część pola tolerancji jest przyjmowana przy danej niepewności wartości.
settings-page-prover = Ciężar dowodu
settings-page-prover-about = Kto ma wykazać, że część jest zgodna lub niezgodna.
settings-page-uncertainty-from = Niepewność podana jako
settings-page-uncertainty-from-about = Wartość wpisana lub budżet, który zna każdy wymiar i jego punkty pomiarowe.
settings-page-uncertainty-about = Każdej wartości na stronie Kontrola. Puste: nieznana.
settings-page-coverage-about = Ile niepewności standardowych tworzy rozszerzoną.
settings-page-budget = Budżet niepewności
settings-page-budget-about = Budżet otwiera się na jego stronie i używa do kontroli.
settings-page-guard-factor-about = Szerokość pasma ochronnego dla reguł z wielokrotnością.
settings-page-guard-width-about = Dla reguły ze stałym pasmem ochronnym.
settings-page-part-temperature = Temperatura części
settings-page-part-temperature-about = Wartości są korygowane do 20 °C. Puste: bez korekcji.
settings-page-part-expansion-about = Jak bardzo rozszerza się materiał części.
settings-page-scale-temperature = Temperatura liniałów
settings-page-scale-temperature-about = Tylko jeśli maszyna jej nie kompensuje.
settings-page-scale-expansion-about = Jak bardzo rozszerzają się liniały maszyny.
settings-page-clearance-about = W jakiej odległości od powierzchni sonda zaczyna jej szukać.
settings-page-height = Wysokość pomiaru Z
settings-page-height-about = Na jakiej wysokości sonda dotyka detalu.
settings-page-first-contact-about = Kąt pierwszego punktu pomiarowego.
settings-page-centre-tolerance-about = O ile środek może być przesunięty w X i Y. 0: bez monitorowania.

# Własne pliki
settings-page-own-tables = Własne tabele
settings-page-own-tables-about = Folder z tabelami jak na sterowaniu. Mają pierwszeństwo przed ISO 286.
settings-page-mask = Maska okna statusu
settings-page-mask-about = Co drukuje sterowanie i w jakim języku.
settings-page-own-mask = Własna maska
settings-page-own-mask-about = Plik maski ze sterowania zamiast wbudowanej.
settings-page-columns = Kolumny plików
settings-page-columns-about = Przed importem pliku pokazuje, co zawiera każda kolumna, i zapamiętuje to.

# Zapisy
settings-page-journal = Dziennik
settings-page-journal-about = Tu wpisywana jest każda kontrola. Plik stanu może podać inny plik.
settings-page-who-about = Każda kontrola jest rejestrowana z tym nazwiskiem.
settings-page-station = Stanowisko
settings-page-station-about = Nazwa tego komputera w zapisach.

# Serwer warsztatu
settings-page-server = Adres serwera
settings-page-server-about = Wysyła każdy zapis w tle do PostgreSQL, np. postgres://frez3@warsztat.example/checks. Hasło trafia do bazy kluczy.
settings-page-sent = Dotąd wysłano
settings-page-sent-about = Zapisy czekają na tym komputerze, aż serwer je przyjmie.

# Foldery
settings-page-watched = Obserwowany folder
settings-page-watched-about = Pliki wrzucone do niego są oceniane według otwartego planu i rejestrowane.
settings-page-recent-about = Menu pokazuje ostatnio odczytane pliki.
settings-page-recent-count = { $count ->
    [0] bez plików
    [one] 1 plik
    [few] { $count } pliki
    [many] { $count } plików
   *[other] { $count } plików
}

# Klawisze
settings-page-everywhere = Wszędzie
settings-page-on-workpiece = Cykle i programy
settings-page-in-dialog = W oknie wyboru plików

# O programie
settings-page-version = Wersja
settings-page-version-about = Fitcheck od razu mówi, czy zmierzony otwór lub wałek jest dobry.
settings-page-version-is = { $version }, commit { $commit }
settings-page-unknown = nieznany
settings-page-licences = Licencje wbudowanych składników
settings-page-licence = Licencja
settings-page-licence-about = Wolne oprogramowanie. Wbudowane czcionki mają własne licencje.
settings-page-state-file = Plik stanu
settings-page-state-file-about = Przechowuje ustawienia, pola i ostatnie pliki, sekundę po każdej zmianie.
settings-page-journal-file = Plik dziennika
settings-page-journal-file-about = Przechowuje każdą kontrolę tego stanowiska.
settings-page-not-used = nieużywane
settings-page-own-tables-unread = { $folder }: nie można było odczytać, nie jest używany
settings-page-nowhere = nieprzechowywane
settings-page-changed = Zmieniono: { $name }
settings-page-several-changed = Zmienione ustawienia: { $count }
settings-page-take-back = Cofnij ostatnią zmianę ustawienia
settings-page-preview = Przykład z tymi ustawieniami

## The size of the screen
ruler = Wielkość ekranu
ruler-about = Przyłożyć kartę bankową do obrazka i wyrównać szerokość: przyciski operatora mają wtedy 20 mm
ruler-card = Karta bankowa: jeszcze nieporównana
ruler-known = Karta bankowa, 85,6 mm
ruler-much-shorter = Dużo krótsza
ruler-shorter = Trochę krótsza
ruler-longer = Trochę dłuższa
ruler-much-longer = Dużo dłuższa
ruler-forget = Zapomnij
settings-page-company = Firma na raportach
settings-page-company-about = Stoi na górze PDF i HTML, jeśli szablon nie podaje firmy.
settings-page-company-address = Adres na raportach
settings-page-company-address-about = Średnik zaczyna nowy wiersz.
settings-page-company-logo = Logo na raportach
settings-page-company-logo-about = Pełna ścieżka pliku PNG, JPEG lub SVG.
settings-page-company-logo-place = { $given } nie jest pełną ścieżką: zacznij od dysku lub folderu głównego
