# Plans of features: what is wrong with one.

plan-no-features = plan nie ma elementów
plan-no-form-limit = { $text } nie jest granicą tolerancji kształtu lub położenia: podać jedną długość powyżej 0 w mm, na przykład 0.02
plan-too-many = plan ma więcej niż { $most } { $most ->
        [one] element
        [few] elementy
        [many] elementów
       *[other] elementów
    }
plan-too-large = plan ma najwyżej { $most } KiB
plan-no-column = brakuje kolumny { $column }
plan-unknown-column = nieznana kolumna { $column }: kolumny to { $known }
plan-column-twice = kolumna { $column } występuje dwa razy
plan-cells = liczba komórek w wierszu: { $found }, w nagłówku: { $expected }; przy przecinku dziesiętnym rozdzielać kolumny średnikami
plan-no-cell = brakuje { $column }
plan-value = { $what }: { $error }
plan-no-feature = { $callout } może być otworem lub wałkiem: dodać feature = "hole" lub feature = "shaft", albo kind = "length", jeśli nie jest żadnym z nich
plan-fit = { $callout } to pasowanie: wpisać otwór i wałek jako dwa elementy
plan-clearance-height = bezpieczna wysokość { $height } mm nie jest powyżej wysokości pomiaru, { $z } mm
plan-same-name = nazwa { $name } występuje dwa razy{ $line ->
    [0] : nazwy plików na sterowaniu nie rozróżniają wielkości liter
   *[other] , pierwszy raz w linii { $line }: nazwy plików na sterowaniu nie rozróżniają wielkości liter
}
plan-unknown = { $column } { $given } jest nieznane: oczekiwane { $known }
plan-other-side = rodzaj { $given } przeczy temu: { $column } { $text }, bo to jest { $side ->
    [hole] otwór
   *[shaft] wałek
    }: poprawić jedno z nich lub wpisać diameter
plan-not-of = { $kind } nie ma { $column }
plan-direction = oś { $given } nie jest kierunkiem: oczekiwane { $known } lub trzy liczby, np. 0.5 0 -1, od -10 do 10, najwyżej 9 miejsc po przecinku, nie wszystkie 0
plan-no-band = { $text } nie jest polem tolerancji punktu, np. ±0.05 lub +0.1/-0.05: { $error }
plan-band-side = punkt nie może mieć odchyłek od { $lower } do { $upper } mm: cykl wymaga górnej co najmniej 0 i dolnej najwyżej 0, nie obu równych 0
plan-side-class = { $callout }: oba boki, { $kind }, wymagają klas, np. { $example }
plan-face-class = { $callout }: powierzchnia jest oceniana jako wymiar zewnętrzny i wymaga klasy wałka, np. h9
plan-face-place = { $callout }: powierzchnia jest na { $coordinate } mm wzdłuż mierzonej osi i tyle musi wynosić jej wymiar nominalny
plan-not-a-plan = to nie jest plan: plan ma linię z nazwami kolumn, np. name;callout;x;y;z, lub zaczyna się od fitcheck_plan = 1
plan-other-version = ten plan ma wersję { $given }: obsługiwane są wersje od 1 do { $newest }
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = nieznany klucz { $key }: oczekiwane { $known }
plan-other-value = { $key }: oczekiwane { $expected }, jest { $found }
plan-parameter = cykl { $cycle } nie przyjmuje z planu { $given }: wpisać NAME=VALUE z jednym z { $known }
plan-no-parameter = żaden cykl pomiarowy nie przyjmuje z planu { $given }: wpisać NAME=VALUE, np. Q423=3
plan-travel = { $axis }{ $given } jest poza zakresem przesuwu maszyny, od { $minimum } do { $maximum } mm
plan-clearance-travel = sonda porusza się na Z{ $height }, poza zakresem przesuwu maszyny, od { $minimum } do { $maximum } mm: podać inne clearance_height
plan-no-travel = { $given } nie jest zakresem przesuwu: wpisać dwie liczby, najpierw mniejszą, np. -250 250
plan-no-plausible = { $column }: { $given } nie jest zakresem: wpisać dwie długości w mm, najpierw mniejszą, np. 24.5 25.5
plan-plausible-limits = { $column }: od { $lower } do { $upper } mm nie zawiera wymiarów granicznych, od { $minimum } do { $maximum } mm: podać szerszy zakres
plan-text = { $column }: oczekiwana jedna linia, najwyżej { $most } { $most ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    }
plan-same-number = { $line ->
    [0] numer { $number } występuje dwa razy: inny element ma { $other }
   *[other] numer { $number } występuje dwa razy: element w linii { $line } ma { $other }
}
plan-same-size = { $line ->
    [0] wartość o nazwie { $called } może należeć do tego elementu lub do { $other }: zmienić nazwę jednego z nich
   *[other] wartość o nazwie { $called } może należeć do tego elementu lub do { $other } w linii { $line }: zmienić nazwę jednego z nich
}
plan-number-is-name = { $line ->
    [0] numer { $number } jest nazwą innego elementu, { $other }
   *[other] numer { $number } jest nazwą innego elementu, { $other } w linii { $line }
}
plan-name-is-number = { $line ->
    [0] wartość o nazwie { $called } może należeć do tego elementu lub do { $other }, bo to jego numer
   *[other] wartość o nazwie { $called } może należeć do tego elementu lub do { $other } w linii { $line }, bo to jego numer
}
plan-balloon = { $given } nie jest miejscem na obrazie: oczekiwane od 0 do 1
plan-not-found-unknown = nie oceniono: żaden element planu nie ma tej nazwy, numeru ani położenia
plan-not-found-no-clue = nie oceniono: wartość nie ma nazwy, numeru ani położenia, więc nie pasuje do żadnego elementu planu
plan-not-found-half-place = nie oceniono: żaden element planu nie ma tej nazwy ani numeru, a położenie wymaga X i Y
plan-not-found-contradiction = nie oceniono: nazwa wskazuje { $name } w planie, a numer wskazuje { $number }
plan-not-found-other-name = żaden element planu nie nazywa się { $given }; { $name } ma ten sam numer, ale może to być numer kolejny: nazwać element jak w planie lub podać jego wymiar nominalny
plan-not-found-running-number = nie oceniono: tylko numer wskazuje { $name } w planie, a może to być numer kolejny, bo inne wiersze pliku nie należą do tego planu
plan-not-found-other-nominal = nie oceniono: wskazuje { $name } w planie, ale wymiar nominalny to { $given }, a w planie { $planned }
plan-not-found-other-limits = nie oceniono: wskazuje { $name } w planie, ale granice { $given } nie mają nic wspólnego z granicami planu { $planned }
plan-not-found-several = nie oceniono: kilka elementów planu ma to położenie: { $names }
plan-not-found-which-side = nie oceniono: wartość nie mówi, który to z { $names }
part-standing = zmierzone { $measured }, brakujące { $missing }, pominięte { $skipped }
plan-not-found-other-kind = nie oceniono: wskazuje { $name } w planie, ale tam jest { $kind }, a zmierzono coś innego
plan-remark-file = { $said }
plan-remark-left = { $name } pominięto: { $why }
plan-remark-class-left = { $name }: { $class } ma inne granice niż plik; obowiązują granice z pliku
plan-remark-place-left = { $name }: nie przejęto położenia: { $why }
plan-remark-axes-assumed = położenia: plik nie mówi, wzdłuż których osi leżą otwory i wałki; przyjęto Z
plan-remark-uncertainty-left = { $name }: niepewność rozszerzoną { $expanded } mm pominięto, bo jej połowa nie jest całkowitą liczbą nanometrów
plan-remark-clearance-raised = { $name } leży powyżej zwykłej bezpiecznej wysokości: wpisano { $height }
plan-simulated-no-place = { $name } nie ma położenia w planie: nie można go symulować
plan-simulated-no-cycle = żaden cykl nie mierzy { $name }: nie można go symulować
