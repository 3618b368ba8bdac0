page-budget = Niepewność
page-budget-also = Budżet

budget-page-text = Budżet jako TOML
budget-page-none = Utworzyć nowy budżet lub otworzyć istniejący
budget-page-new = Nowy budżet
budget-page-open = Otwórz budżet…
budget-page-save = Zapisz budżet jako…
budget-page-dialog-open = Otwieranie budżetu
budget-page-dialog-save = Zapisywanie budżetu
budget-page-dialog-readings = Odczyty przedmiotu wzorcowanego
budget-page-not-saved = { $name }, niezapisany

budget-page-for = Obliczono dla
budget-page-size = Zmierzony wymiar
budget-page-contacts = Punkty pomiarowe
budget-page-touches = Liczba punktów
budget-page-step = Krok
budget-page-contacts-hint = Puste: punkty pomiarowe z budżetu
budget-page-day = Dzień
budget-page-day-hint = Pusty dzień: dziś, { $day }
budget-page-no-day = { $given } nie jest dniem: oczekiwane YYYY-MM-DD
budget-page-other-missing = Brakuje: podać i liczbę punktów, i krok, albo nic
budget-page-take-check = Z pokazanej kontroli
budget-page-take-recorded = Zarejestrowane punkty
budget-page-own-contacts = Z budżetu
budget-page-of-check = Punkty pomiarowe ({ $count }) kontroli { $what }, { $time }
budget-page-of-simulated-check = Punkty pomiarowe ({ $count }) kontroli { $what }, { $time }, symulowane
budget-page-of-recorded = Zarejestrowane punkty pomiarowe ({ $count }) z { $name }
budget-page-contacts-used = punkty pomiarowe: { $count }, współczynnik { $factor }
budget-page-contacts-stepped = punkty pomiarowe: { $count } co { $step }°, współczynnik { $factor }
budget-page-no-circle = Punkty pomiarowe nie są użyte: { $problem }

budget-page-readings = Odczyty
budget-page-open-readings = Z pliku…
budget-page-take-readings = Z historii
budget-page-own-readings = Z budżetu
budget-page-readings-own = { $count ->
        [one] jeden odczyt w budżecie
        [few] { $count } odczyty w budżecie
        [many] { $count } odczytów w budżecie
       *[other] { $count } odczytów w budżecie
    }
budget-page-readings-of-file = { $count ->
        [one] jeden odczyt z { $name }
        [few] { $count } odczyty z { $name }
        [many] { $count } odczytów z { $name }
       *[other] { $count } odczytów z { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] jeden odczyt: kontrola z historii
        [few] { $count } odczyty: wszystkie kontrole z historii
        [many] { $count } odczytów: wszystkie kontrole z historii
       *[other] { $count } odczytów: wszystkie kontrole z historii
    }
budget-page-readings-of-chosen = { $count ->
        [one] jeden odczyt: zaznaczona kontrola z historii
        [few] { $count } odczyty: zaznaczone kontrole z historii
        [many] { $count } odczytów: zaznaczone kontrole z historii
       *[other] { $count } odczytów: zaznaczone kontrole z historii
    }
budget-page-readings-are-shafts = { $count ->
        [one] jedna kontrola wałka nie jest użyta
        [few] { $count } kontrole wałków nie są użyte
        [many] { $count } kontroli wałków nie jest użytych
       *[other] { $count } kontroli wałków nie jest użytych
    }: przedmiot jest otworem
budget-page-readings-are-holes = { $count ->
        [one] jedna kontrola otworu nie jest użyta
        [few] { $count } kontrole otworów nie są użyte
        [many] { $count } kontroli otworów nie jest użytych
       *[other] { $count } kontroli otworów nie jest użytych
    }: przedmiot jest wałkiem
budget-page-readings-simulated = { $count ->
        [one] jeden odczyt jest symulowany
        [few] { $count } odczyty są symulowane
        [many] { $count } odczytów jest symulowanych
       *[other] { $count } odczytów jest symulowanych
    }: niczego nie zmierzono
budget-page-more-notes = { $count ->
        [one] i jeszcze jedna
       *[other] i jeszcze { $count }
    }

budget-page-answer = Niepewność rozszerzona
budget-page-no-answer = Bez wyniku
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } dla 95,45 %
budget-page-at-size = Dla { $size } mm; każda kontrola ma niepewność dla swojego wymiaru
budget-page-covered-by = k = { $k } według { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Efektywne stopnie swobody { $degrees }
budget-page-infinite = nieskończone
budget-page-valid = Ważny do { $until }
budget-page-expired = WYGASŁ
budget-page-expired-on = ważny do { $until }, na dzień { $day }
budget-page-not-yet = JESZCZE NIEWAŻNY
budget-page-not-yet-on = ważny od { $date }
budget-page-made = Utworzono { $date }, autor: { $by }
budget-page-method = Metoda { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Największa składowa
budget-page-largest-is = { $name }, { $percent } % wariancji
budget-page-help = Co pomogłoby najbardziej
budget-page-help-halved = Połowa tej składowej: u = { $u } µm
budget-page-help-part-temperature = Połowa niepewności temperatury części: u = { $u } µm
budget-page-help-scale-temperature = Połowa niepewności temperatury liniałów: u = { $u } µm
budget-page-help-expansion = Połowa różnicy do 20 °C lub połowa niepewności rozszerzalności: u = { $u } µm
budget-page-help-full-circle = Punkty pomiarowe ({ $count }) równomiernie na pełnym okręgu: u = { $u } µm
budget-page-help-more-touches = Punkty pomiarowe ({ $count }) równomiernie na pełnym okręgu: u = { $u } µm

budget-page-checks = Kontrole
budget-page-use = Użyj do kontroli
budget-page-leave = Przestań używać
budget-page-uses-none = Kontrole nie używają budżetu
budget-page-uses-this = W użyciu: { $name }
budget-page-uses-another = W użyciu: { $name } z { $file }, inny niż pokazany tutaj
budget-page-uses-typed = „{ $name }” się nie liczy: kontrole używają niepewności wybranej na stronie Kontrola
budget-page-uses-no-rule = Wybrano „{ $name }”, ale żadna reguła na stronie Kontrola nie używa jeszcze niepewności: wybrać tam regułę
budget-page-used-before = Dotąd kontrole używały niepewności wpisanej ({ $uncertainty }). „Przestań używać” ją przywraca
budget-page-used = Kontrole używają budżetu { $name }
budget-page-used-no-rule = „{ $name }” nie zmienia jeszcze żadnej oceny: reguła na stronie Kontrola to „{ $rule }” i nie używa niepewności. Wybrać inną regułę
budget-page-not-kept = Zapisać budżet, aby używać go po ponownym uruchomieniu
budget-page-readings-not-kept = Odczytów nie ma w pliku budżetu: po ponownym uruchomieniu budżet nie będzie używany
budget-page-used-unread = { $path }: nie można odczytać budżetu używanego do kontroli, więc kontrole nie używają budżetu: { $problem }

budget-page-table = Składowe
budget-page-column-name = Nazwa
budget-page-column-type = Typ
budget-page-column-law = Rozkład
budget-page-column-sensitivity = c
budget-page-column-share = Udział
budget-page-row = { $name }, typ { $type }, { $law }, u { $u } { $unit }, wrażliwość { $sensitivity }, składowa { $um } µm, udział { $percent } %, stopnie swobody { $degrees }
budget-page-law-normal = normalny
budget-page-law-rectangular = prostokątny
budget-page-law-u-shaped = w kształcie U
budget-page-law-triangular = trójkątny
budget-page-shares = Udziały w wariancji
budget-page-terms = Wyrazy i niepewność rozszerzona
budget-page-mean = Średnia z odczytów { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, z korekcją
budget-page-edition-2004 = U, 2004, bez korekcji
budget-page-nothing-seen = Tabela i udziały pojawią się, gdy budżet da się obliczyć
budget-page-named = { $name }
budget-page-placeholders = Kontrole nie mogą jeszcze używać tego budżetu. Te dane pochodzą nadal z szablonu: { $what }. Wpisać własne w ich pola
budget-page-placeholder-name = nazwa („{ $name }”)
budget-page-placeholder-by = autor („{ $by }”)
budget-page-placeholder-figures = liczby wszystkich składowych

## The budget as a table

budget-show-table = Tabela
budget-show-text = Tekst
budget-rows = Składowe
budget-head-name = Nazwa budżetu
budget-head-by = Autor
budget-row-new = Nowa składowa
budget-row-add = Dodaj składową
budget-row-remove = Usuń składową
budget-row-removed = Z budżetu usunięto składową „{ $name }”
budget-row-comments-removed = Komentarze przy usuniętych kluczach przepadły
budget-row-said = { $value } { $unit }, dzielnik { $divisor }, { $law }
budget-row-unread = niekompletna
budget-row-name = Nazwa
budget-row-k = Współczynnik rozszerzenia k
budget-row-alpha = Rozszerzalność, 1/K
budget-row-delta = Różnica do 20 °C
budget-row-touches = Własne punkty
budget-row-step = Własny krok
budget-row-sensitivity = Wrażliwość c
budget-row-freedom = Stopnie swobody
budget-row-freedom-a = Stopnie swobody, n − 1 z n odczytów
budget-row-kind = Dotyczy
budget-row-type = Typ
budget-row-law = Rozkład
budget-row-given = Podano jako
budget-row-half-width = Półszerokość
budget-row-resolution = Krok wskazania
budget-given-standard = Niepewność standardowa
budget-given-expanded = Niepewność rozszerzona
budget-type-a = A, statystyka
budget-type-b = B, inne
budget-kind-plain = Średnica
budget-kind-scatter = Rozrzut punktu
budget-kind-part-temperature = Temperatura części
budget-kind-scale-temperature = Temperatura liniałów
budget-kind-part-expansion = Rozszerzalność części
budget-kind-scale-expansion = Rozszerzalność liniałów
budget-kind-resolution = Rozdzielczość
budget-table-stale = Tekst ma błąd: tabela pokazuje ostatni poprawny stan składowych
budget-table-other = Tekst zapisuje składowe w sposób, którego tabela nie może zmieniać. Edytować tekst
budget-table-calibrated = Ten budżet dotyczy przedmiotu wzorcowanego i nie ma składowych. Edytować tekst
budget-law-normal = Rozkład normalny
budget-law-rectangular = Rozkład prostokątny
budget-law-u-shaped = Rozkład w kształcie U
budget-law-triangular = Rozkład trójkątny
