# report

## Errors
report-error-writer = nie można utworzyć raportu { $format }: { $reason }
report-error-label-alone = { $format } jest dla etykiet: wybierz szablon label albo papier small-label lub large-label
report-error-no-statistics = { $format } nie ma miejsca na statystykę: wybierz PDF, HTML lub Markdown
report-attachment-too-large = dane w pliku są większe niż { $most } B
report-attachment-packed = dane w pliku są spakowane metodą { $filter }, której Fitcheck nie czyta
report-attachment-damaged = dane w pliku są uszkodzone: { $reason }
report-attachment-several = liczba załączników z kontrolami w pliku: { $count }, oczekiwano jednego
report-difference-field = wpis { $number }: { $field } to w pliku { $said }, w dzienniku { $kept }
report-difference-missing = wpis { $number }: żadna kontrola z pliku nie mówi tego, co dziennik
report-difference-more = { $count ->
    [one] w pliku jest o 1 kontrolę za dużo
    [few] w pliku jest o { $count } kontrole za dużo
    [many] w pliku jest o { $count } kontroli za dużo
   *[other] w pliku jest o { $count } kontroli za dużo
}
report-difference-fewer = { $count ->
    [one] w pliku brakuje 1 kontroli
    [few] w pliku brakuje { $count } kontroli
    [many] w pliku brakuje { $count } kontroli
   *[other] w pliku brakuje { $count } kontroli
}
report-data-json = dane w pliku to nie raport programu Fitcheck: { $reason }
report-ending-missing = { $file } nie ma rozszerzenia, które podaje format raportu: użyć jednego z { $endings }
report-ending-unknown = .{ $ending } nie jest formatem raportu: użyć jednego z { $endings }

## Sentences about one check
report-feature-hole = otwór
report-feature-shaft = wałek
report-feature-neither = ani otwór, ani wałek
report-side-good = dobry
report-side-rework = poprawka
report-side-scrap = brak
report-side-out = poza tolerancją
report-side-too-small = za mały
report-side-too-large = za duży
report-source-instead = { $source }; ISO 286 podaje tu { $upper } i { $lower } µm
report-too-small = { $um } µm za mały
report-too-large = { $um } µm za duży
report-inside = w granicach
report-above-minimum = { $um } µm powyżej minimum
report-below-minimum = { $um } µm poniżej minimum
report-below-maximum = { $um } µm poniżej maksimum
report-above-maximum = { $um } µm powyżej maksimum
report-position-unknown = niezmierzona
report-position-unmonitored = niemonitorowana
report-position-in = W POLU
report-position-out = POZA
report-axis-unmonitored = { $axis } { $deviation } mm: niemonitorowana
report-axis-in = { $axis } { $deviation } mm, dopuszczalna ± { $tolerance } mm: W POLU
report-axis-out = { $axis } { $deviation } mm, dopuszczalna ± { $tolerance } mm: POZA
report-cause-position = środek jest poza pozycją; sam wymiar: { $status }
report-origin-circle = { $origin }; okrąg średniokwadratowy, punkty pomiarowe: { $contacts }
report-centre = zmierzony środek X { $x } mm, Y { $y } mm
report-band-nominal = wymiar nominalny { $size } mm
report-band-title = Wykres granic, zmierzono { $value }: { $distances }
report-in-guard-band = nic nie jest rozstrzygnięte: wartość leży w paśmie ochronnym reguły decyzyjnej
report-corrected = zmierzono { $measured } mm przy { $temperature } °C, rozszerzalność { $expansion } · 10⁻⁶/K: skorygowano o { $change } µm do { $reference } mm przy 20 °C
report-all-corrected = zmierzono przy { $temperature } °C, rozszerzalność { $expansion } · 10⁻⁶/K; każdą wartość skorygowano do 20 °C
report-scales = liniały przy { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = bez korekcji liniałów
report-own-uncertainty = u każdej wartości przy jej kontroli
report-accepted-zone = od { $least } do { $most } mm
report-accepted-none = żadne: reguła nie zostawia nic z tej tolerancji
report-proven = wykazane według tej reguły
report-not-proven = niewykazane według tej reguły
report-conformity = zgodność z prawdopodobieństwem { $percent } %
report-budget-made = { $name }, utworzono { $date }, autor: { $by }, ważny do { $until }
report-budget-expired = WYGASŁ w dniu kontroli
report-budget-not-yet = JESZCZE NIEWAŻNY w dniu kontroli
report-guard-undecided = pasmo ochronne: powtórzyć
report-guard-beyond = pasmo ochronne: przyjęty poza granicą
report-guard-range = { $what }, od { $from } do { $to } µm

## The page
report-title = Raport z kontroli
report-part = Część
report-order = Zlecenie
report-inspector = Kontroler
report-program = Program
report-notes = Pominięte wiersze i ostrzeżenia
report-no-checks = Ten raport nie ma kontroli.
report-page-all-good = Na tej stronie nie ma żadnej z kontroli ({ $total }): wszystkie są dobre i żadna nie budzi wątpliwości. Raport CSV lub JSON podaje każdą kontrolę.
report-page-not-good = Ta strona podaje tylko kontrole niedobre lub budzące wątpliwości: { $listed } z { $total }. Liczby obejmują każdą kontrolę; raport CSV lub JSON podaje wszystkie.
report-page-first = Ta strona podaje tylko pierwsze { $listed } z { $wanted } kontroli niedobrych lub budzących wątpliwości, spośród { $total } kontroli. Liczby obejmują każdą kontrolę; raport CSV lub JSON podaje wszystkie.
report-total = Razem
report-check = Kontrola
report-id = Nazwa
report-callout = Wymiar tol.
report-heading-without-callout = { $nominal } mm, granice bez klasy
report-verdict = Ocena
report-nominal = Wymiar nominalny
report-maximum = Maksimum
report-minimum = Minimum
report-measured = Zmierzono
report-deviation = Odchyłka
report-remove = Do zebrania
report-on-diameter = na średnicy
report-per-side = na stronę
report-remove-to-limit = do najbliższej granicy
report-remove-to-middle = do środka pola tolerancji
report-remove-to-accepted = do wartości przyjmowanych
report-position = Pozycja
report-limits-from = Źródło granic
report-measured-from = Wartość zmierzona
report-from = Źródło
report-limits = Granice
report-missing = Brakuje
report-skipped = Pominięto
report-verdict-from = Reguła decyzyjna
report-temperature = Temperatura
report-accepted = Wartości przyjmowane
report-proof = Dowód
report-budget = Budżet niepewności
report-cannot-tell = Ograniczenia tego pomiaru
report-contacts = Punkty pomiarowe
report-contacts-at-end = na końcu raportu
report-contact = Nr
report-radial = odchyłka promieniowa
report-sign-name = Nazwisko
report-sign-date = Data
report-sign-signature = Podpis
report-footer = Każda ocena opiera się na wartościach niezaokrąglonych oraz na podanych przy niej granicach i regule decyzyjnej.

## Notes
report-note = { $place }: { $what }
report-note-line = { $place }, linia { $line }: { $what }
report-note-more = { $count ->
    [one] jeszcze 1 informacja jest poza listą
    [few] jeszcze { $count } informacje są poza listą
    [many] jeszcze { $count } informacji jest poza listą
   *[other] jeszcze { $count } informacji jest poza listą
}

## A whole part
report-balloon = Balonik
report-picture-room = { $name } nie jest tu pokazany: z obrazami wszystkich części strona byłaby za duża
report-picture-beside = { $count ->
    [one] jeden element nie ma na nim balonika
    [few] { $count } elementy nie mają na nim balonika
    [many] { $count } elementów nie ma na nim balonika
   *[other] { $count } elementów nie ma na nim balonika
}
report-part-older = { $count ->
    [one] Jeszcze jedna wartość jest poza listą: dla każdego wymiaru podana jest tylko wartość, która się liczy
    [few] Jeszcze { $count } wartości są poza listą: dla każdego wymiaru podana jest tylko wartość, która się liczy
    [many] Jeszcze { $count } wartości jest poza listą: dla każdego wymiaru podana jest tylko wartość, która się liczy
   *[other] Jeszcze { $count } wartości jest poza listą: dla każdego wymiaru podana jest tylko wartość, która się liczy
}
report-more-parts = { $count ->
    [one] Jeszcze jedna część nie jest pokazana w całości; jej wartości są na liście
    [few] Jeszcze { $count } części nie są pokazane w całości, w całości tylko pierwsze { $most }; ich wartości są na liście
    [many] Jeszcze { $count } części nie jest pokazanych w całości, w całości tylko pierwsze { $most }; ich wartości są na liście
   *[other] Jeszcze { $count } części nie jest pokazanych w całości, w całości tylko pierwsze { $most }; ich wartości są na liście
}

## Szablony raportów
report-template-toml = { $reason }
report-template-version = wersja szablonu { $found } nie jest obsługiwana: oczekiwana wersja { $known }
report-template-too-large = szablon ma najwyżej { $most } bajtów
report-template-text = { $key } jest puste, dłuższe niż { $longest } znaków lub zawiera znak sterujący
report-template-twice = { $key } wymienia { $word } dwa razy
report-template-empty = { $key } jest puste: potrzebny jest co najmniej jeden wpis
report-template-language = { $given } nie jest językiem raportów: użyj jednego z { $known }
report-template-logo = logo { $given } musi być nazwą pliku obok szablonu
report-section-verdict = Ocena
report-section-head = Nagłówek
report-section-picture = Rysunek z balonikami
report-section-lot = Części, od najgorszej
report-section-statistics = Statystyka cech
report-statistics-limits = Granice różnią się między wartościami: zdolność nie jest podana.
report-statistics-most = Statystyka obejmuje tylko pierwsze { $count } wartości.
report-section-features = Wartości
report-section-statement = Stwierdzenie zgodności
report-section-rule = Reguła i granice słowami
report-section-caveats = Ograniczenia pomiaru
report-section-remarks = Uwagi
report-section-signature = Linia podpisu
report-section-code = Kod zapisu
report-revision = Rewizja
report-serial = Numer seryjny
report-batch = Partia
report-customer = Klient
report-material = Materiał
report-station = Stanowisko
report-instrument = Przyrząd
report-calibrated = Wzorcowanie
report-date = Data
report-plan = Plan
report-records = Zapisy
report-blank = Wartość
report-remark = Uwaga
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Etykieta 62 × 29 mm
report-paper-large-label = Etykieta 100 × 50 mm
report-template-inspection = Raport z kontroli
report-template-inspection-purpose = Części lub kontrole, z rysunkami
report-template-first-article = Pierwsza sztuka
report-template-first-article-purpose = Każdy element, także brakujące
report-template-certificate = Świadectwo
report-template-certificate-purpose = Wartości i stwierdzenie zgodności
report-template-list = Lista kontroli
report-template-list-purpose = Wszystkie kontrole jedna pod drugą
report-template-statistics = Statystyka
report-template-statistics-purpose = Każda cecha na wszystkich wartościach, z wykresami
report-template-sheet = Karta pomiarowa
report-template-sheet-purpose = Pusta, do wypełnienia ręcznie
report-template-label = Etykieta
report-template-label-purpose = Ocena, część i numer seryjny
## Strony do druku
report-pdf-page = Strona { $page } z { $pages }
report-pdf-band = Wykres granic
report-pdf-remove = { $name }: zebrać { $um } µm na średnicy
report-pdf-simulated = Wartości symulowane, których nikt nie zmierzył: { $count } z { $total }
report-pdf-beyond = Wartości przyjęte poza granicami przez regułę decyzyjną: { $count } z { $total }
report-pdf-corrected = Wartości skorygowane do 20 °C: { $count } z { $total }
report-pdf-guarded = Wartości z własną regułą decyzyjną: { $count } z { $total }
report-pdf-doubted = Wartości wątpliwe, oznaczone znakiem zapytania: { $count } z { $total }
report-pdf-notes = Pominięte wiersze i ostrzeżenia, wymienione na końcu: { $count }
report-pdf-more-lacks = Więcej na stronach części: { $count }
report-pdf-more = Więcej w dołączonych danych: { $count }
report-pdf-all-checks = Wszystkie kontrole
report-pdf-attached = Dołączone do tego pliku, dla programów: { $names }
report-pdf-not-attached = Nie wszystkie dane są dołączone: plik większy niż { $most } MB byłby za duży
report-pdf-contacts = Punkty pomiarowe są w dołączonych danych.
report-pdf-cut = Tekst, który kończy się znakiem …, jest tu skrócony; w dołączonych danych jest cały.
report-pdf-substituted = Znak □ zastępuje znak, którego nie mają czcionki tych stron, na przykład pisany od prawej do lewej; skopiowany tekst i dołączone dane zawierają ten znak.
report-statement-conforms = { $count ->
    [one] Stwierdzenie zgodności: wartość mieści się w granicach według podanej reguły decyzyjnej.
    [few] Stwierdzenie zgodności: wszystkie wartości ({ $count }) mieszczą się w granicach według podanej reguły decyzyjnej.
   *[other] Stwierdzenie zgodności: wszystkie wartości ({ $count }) mieszczą się w granicach według podanej reguły decyzyjnej.
}
report-statement-not = { $count ->
    [one] Brak zgodności: wartość nie spełnia wymagań według podanej reguły decyzyjnej.
    [few] Brak zgodności: { $bad } z { $count } wartości nie spełnia wymagań według podanej reguły decyzyjnej.
   *[other] Brak zgodności: { $bad } z { $count } wartości nie spełnia wymagań według podanej reguły decyzyjnej.
}
report-statement-partial = Brak stwierdzenia zgodności: niektóre wiersze odrzucono, nie oceniono ich lub nie odczytano. Raport je wymienia.
report-statement-simulated = { $count ->
    [one] Brak stwierdzenia zgodności: jedna wartość jest symulowana i nikt jej nie zmierzył.
    [few] Brak stwierdzenia zgodności: { $count } wartości jest symulowanych i nikt ich nie zmierzył.
   *[other] Brak stwierdzenia zgodności: { $count } wartości jest symulowanych i nikt ich nie zmierzył.
}
report-statement-open = Brak stwierdzenia zgodności: brakuje wartości, łącznie { $count }.
report-code-said = Kod zapisu { $number }, jego skrót { $hash }
report-lot-order = Najgorsza część jest pierwsza.
## Skoroszyt
report-sheets = Własny arkusz mają tylko pierwsze części ({ $listed } z { $total }); arkusz części podaje wszystkie.
report-sheets-corrected = skorygowano do 20 °C
report-sheets-without = Obrazów i punktów pomiarowych nie ma w tym skoroszycie: raport HTML zawiera jedne i drugie, raport JSON punkty pomiarowe.
report-sheets-cut = { $count ->
    [one] Jeden tekst jest skrócony: komórka mieści najwyżej 32767 znaków.
    [few] { $count } teksty są skrócone: komórka mieści najwyżej 32767 znaków.
    [many] { $count } tekstów jest skróconych: komórka mieści najwyżej 32767 znaków.
   *[other] { $count } tekstów jest skróconych: komórka mieści najwyżej 32767 znaków.
}
report-journal = Zapisy { $numbers } dziennika { $chain }; jego ostatni wpis wtedy: { $number }:{ $hash }
report-template-new-about = Szablon raportów. Usuń to, czego raport nie ma pokazywać; usuń znak # przed tym, co ma pokazywać.
report-template-new-name = Nowy szablon
report-changed-since = Zmiany od raportu z { $since }:
report-changed-none = żaden wynik i żadna granica
report-changed-result = { $name }: { $before } → { $now }
report-changed-limits = { $name }: granice od { $low } do { $high } → od { $lower } do { $higher } mm
report-changed-added = { $name }: nowe
report-changed-removed = { $name }: nie ma już w raporcie
report-changed-several = { $name }: nie porównano, ponieważ jest kilka wartości
report-since-no-report = nie jest raportem programu Fitcheck z danymi: podaj jego plik PDF lub JSON
