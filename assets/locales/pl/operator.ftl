# Okno dla operatora

operator-mode = Dla kogo jest to okno
operator-mode-about = Operator ma pomiar, wyniki i pomoc, dużymi literami; wszystko inne jest w pełnym oknie
operator-mode-operator = Operator
operator-mode-operator-about = Pomiar, wyniki i pomoc: dotykiem, w rękawicach, z dwóch metrów.
operator-mode-full = Wszystko
operator-mode-full-about = Wszystkie strony, do pracy przy biurku.
operator-question = Dla kogo jest to okno?
operator-question-later = Można to zmienić w każdej chwili w ustawieniach; operator dochodzi tam przez „Wyjdź”.
operator-leave = Wyjdź
operator-report = Raport
operator-undo = Cofnij
operator-measure = Pomiar
operator-results = Wyniki
operator-one-size = Jeden wymiar
operator-part = Część
operator-last = Ostatnie wyniki
operator-newer = Nowsze
operator-older = Starsze
operator-back-to-results = Wróć do wyników
operator-dropped = { $name } nie otworzy się tutaj: operator nie otwiera plików. Najpierw przejść do pełnego okna.
operator-no-results = Jeszcze niczego nie zmierzono.
operator-features = { $count ->
    [one] 1 element
    [few] Elementy: { $count }
    [many] Elementy: { $count }
   *[other] Elementy: { $count }
}
operator-next = Dalej
operator-next-part = Następna część
operator-to-value = Wartość
operator-type-callout = Wpisać to, co podaje rysunek, np. 25 H7.
operator-type-value = Zmierzyć i wpisać wartość.
operator-choose-part = Wybrać część i wpisać jej numer seryjny.
operator-hole-or-shaft = Co jest mierzone?
operator-plans = Części
operator-no-plans = Na tym komputerze nie otwarto jeszcze żadnego planu. Plany otwiera się w pełnym oknie, na stronie Części.
operator-go-on-first = Najpierw odczytać ocenę i nacisnąć „Dalej”: to, co wpisano wcześniej, nie zostało przyjęte

## The PIN
operator-pin = PIN okna operatora
operator-pin-about = Wpisuje go ten, kto opuszcza okno operatora. Zapisywany jest tylko jego skrót z solą
operator-pin-use = Zablokuj tym PIN-em
operator-pin-remove = Usuń PIN
operator-pin-try = Odblokuj
operator-stay = Zostań
operator-pin-short = PIN ma co najmniej { $least } znaki
operator-pin-set = Okno operatora jest odtąd zablokowane PIN-em
operator-pin-removed = Okno operatora nie jest już zablokowane
operator-pin-wrong = To nie jest ten PIN
operator-pin-not-hashed = Nie można obliczyć skrótu PIN-u: { $why }
operator-pin-asked = Wpisać PIN, aby opuścić okno operatora.
operator-pin-forgotten = PIN zapomniany? Podręcznik podaje, jak wejdzie administrator: The operator’s window, The PIN.
