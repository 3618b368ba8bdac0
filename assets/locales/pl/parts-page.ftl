page-parts = Części
parts-page-walk = Pomiar
parts-page-plan = Plan
parts-page-new = Nowy plan
parts-page-open = Otwórz plan…
parts-page-save = Zapisz plan…
parts-page-save-csv = Zapisz plan jako CSV…
parts-page-undo = Cofnij
parts-page-redo = Ponów
parts-page-dialog-open = Otwieranie planu części
parts-page-dialog-save = Zapisywanie planu części
parts-page-not-saved = { $name }, niezapisany
parts-page-no-plan = Jeszcze bez planu: otworzyć lub utworzyć.
parts-page-move = Przejdź do innej komórki
parts-page-extend = Rozszerz zaznaczenie
parts-page-edit = Edytuj komórkę
parts-page-take = Gotowe
parts-page-empty = Wyczyść komórki
parts-page-copy = Kopiuj komórki
parts-page-paste = Wklej
parts-page-insert = Wstaw wiersz
parts-page-delete = Usuń wiersze
parts-page-up = W górę
parts-page-down = W dół
parts-page-sort = Sortuj
parts-page-sort-hint = Sortuje według kolumny bieżącej komórki, A2 przed A10; ponowne sortowanie odwraca kolejność
parts-page-renumber = Przenumeruj
parts-page-renumber-hint = Numeruje elementy od 1 w kolejności wierszy
parts-page-all-columns = Wszystkie kolumny
parts-page-previous = Poprzedni błąd
parts-page-next = Następny błąd
parts-page-choose-picture = Wybierz obraz…
parts-page-dialog-picture = Wybór obrazu części
parts-page-table = Elementy planu
parts-page-cell-name = Komórka planu
parts-page-cell = Wiersz { $row }, { $column }, { $text }
parts-page-cell-empty = Wiersz { $row }, { $column }, puste
parts-page-cell-wrong = { $cell }, błąd: { $what }
parts-page-new-row = nowy
parts-page-limits = Granice
parts-page-editing = { $column }, wiersz { $row }
parts-page-head = Część
parts-page-words = Do wyboru: { $words }
parts-page-no-fault = Plan bez błędów
parts-page-blank = Wpisać pierwszy element lub wkleić wiersze z arkusza
parts-page-faults = { $count ->
    [one] Jeden błąd
    [few] { $count } błędy
    [many] { $count } błędów
   *[other] { $count } błędów
}
parts-page-features = { $count ->
    [one] Jeden element
    [few] { $count } elementy
    [many] { $count } elementów
   *[other] { $count } elementów
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Wiersz { $row }
parts-page-fault-plan = Plan
parts-page-lost = Niezrozumiałe w pliku: plan niczego nie mierzy ani nie zapisuje, dopóki nie zostanie to poprawione w pliku lub pominięte tutaj
parts-page-take-meant = Użyj { $meant }
parts-page-leave-out = Pomiń je
parts-page-leave-out-hint = Plan ma wtedy tylko to, co dało się odczytać; niezrozumiała pozycja może być elementem
parts-page-left-out = { $count ->
    [one] { $name }: w planie pominięto jedną niezrozumiałą pozycję; w pliku pozostaje do zapisania planu
    [few] { $name }: w planie pominięto { $count } niezrozumiałe pozycje; w pliku pozostają do zapisania planu
    [many] { $name }: w planie pominięto { $count } niezrozumiałych pozycji; w pliku pozostają do zapisania planu
   *[other] { $name }: w planie pominięto { $count } niezrozumiałych pozycji; w pliku pozostają do zapisania planu
}
parts-page-pasted-rows = { $count ->
    [one] Pominięto jeden wklejony wiersz: największa liczba elementów w planie to { $most }
    [few] Pominięto { $count } wklejone wiersze: największa liczba elementów w planie to { $most }
    [many] Pominięto { $count } wklejonych wierszy: największa liczba elementów w planie to { $most }
   *[other] Pominięto { $count } wklejonych wierszy: największa liczba elementów w planie to { $most }
}
parts-page-pasted-columns = { $count ->
    [one] Pominięto jedną wklejoną kolumnę: po prawej nie ma już kolumn. „Wszystkie kolumny” pokazuje więcej
    [few] Pominięto { $count } wklejone kolumny: po prawej nie ma już kolumn. „Wszystkie kolumny” pokazuje więcej
    [many] Pominięto { $count } wklejonych kolumn: po prawej nie ma już kolumn. „Wszystkie kolumny” pokazuje więcej
   *[other] Pominięto { $count } wklejonych kolumn: po prawej nie ma już kolumn. „Wszystkie kolumny” pokazuje więcej
}
parts-page-column-number = Nr
parts-page-column-name = Nazwa
parts-page-column-kind = Rodzaj
parts-page-column-axis = Oś
parts-page-column-callout = Wymiar tol.
parts-page-column-callout2 = Wymiar tol. Y
parts-page-column-feature = Otwór lub wałek
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Kąt
parts-page-column-clearance = Odstęp bezp.
parts-page-column-clearance-height = Bezp. wysokość
parts-page-column-cycle = Cykl
parts-page-column-parameters = Parametry
parts-page-column-material = Materiał
parts-page-column-rule = Reguła
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Możliwe od–do
parts-page-column-plausible2 = Możliwe od–do Y
parts-page-column-remark = Uwaga
parts-page-column-balloon-x = Balonik X
parts-page-column-balloon-y = Balonik Y
parts-page-head-part = Część
parts-page-head-drawing = Rysunek
parts-page-head-picture = Obraz
parts-page-head-material = Materiał
parts-page-head-rule = Reguła
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Przesuw X (mm)
parts-page-head-travel-y = Przesuw Y (mm)
parts-page-head-travel-z = Przesuw Z (mm)
parts-page-head-remark = Uwaga
parts-page-head-file = plik obok planu
parts-page-head-two = min. maks.
parts-page-picture = Obraz części
parts-page-picture-said = Obraz części, umieszczone baloniki: { $on } z { $count }
parts-page-picture-none = Bez obrazu
parts-page-picture-awaited = Odczyt obrazu
parts-page-picture-folder = { $given } nie jest nazwą pliku obok planu: obraz musi być w folderze planu, więc podać nazwę bez folderu
parts-page-picture-unsaved = Najpierw zapisać plan: obraz musi być w tym samym folderze
parts-page-picture-elsewhere = { $given } nie jest w folderze planu: najpierw skopiować tam plik, aby oba pozostały razem
parts-page-picture-large = { $name } ma { $given } KiB; obraz ma najwyżej { $most } KiB
parts-page-picture-dots = { $name }: { $width } × { $height } px; obraz ma najwyżej { $most } mln pikseli
parts-page-picture-kind = { $name } nie jest obrazem PNG, JPEG ani SVG
parts-page-picture-broken = { $name } nie daje się odczytać jako obraz: { $reason }
parts-page-balloon = Balonik { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, następny
parts-page-balloon-beside = { $balloon }, poza obrazem
parts-page-balloon-open = niezmierzony
parts-page-balloon-skipped = pominięty
parts-page-beside = Jeszcze poza obrazem: przeciągnąć na obraz
parts-page-beside-more = i jeszcze { $count }
parts-page-balloon-simulated = { $status }, symulowany
parts-page-more = Wiersze i komórki
parts-page-picture-heavy = { $name } rysowałby się za długo: ma filtry, duże wzory lub za dużo warstw; usunąć je lub zapisać obraz jako PNG
parts-page-csv-copy = Plik jest kopią: CSV ma tylko elementy, a z danych części pominięto { $keys }
parts-page-opened = { $count ->
    [one] { $name } jest otwarty, ale plan pomija jedną rzecz, którą plik zawiera
    [few] { $name } jest otwarty, ale plan pomija { $count } rzeczy, które plik zawiera
    [many] { $name } jest otwarty, ale plan pomija { $count } rzeczy, które plik zawiera
   *[other] { $name } jest otwarty, ale plan pomija { $count } rzeczy, które plik zawiera
}
parts-page-pasted-twice = Pominięto wklejoną kolumnę: pierwszy wiersz podaje { $keys } więcej niż raz, użyto pierwszej kolumny o tej nazwie
parts-page-pasted-unknown = Pominięto wklejone kolumny, których plan nie ma: { $names }
parts-page-pasted-nameless = { $count ->
    [one] Pominięto jedną wklejoną kolumnę: pierwszy wiersz nie ma nad nią nazwy
    [few] Pominięto { $count } wklejone kolumny: pierwszy wiersz nie ma nad nimi nazw
    [many] Pominięto { $count } wklejonych kolumn: pierwszy wiersz nie ma nad nimi nazw
   *[other] Pominięto { $count } wklejonych kolumn: pierwszy wiersz nie ma nad nimi nazw
}
parts-page-comments = { $count ->
    [one] Zapisanie planu usuwa z pliku komentarz
    [few] Zapisanie planu usuwa z pliku { $count } komentarze
    [many] Zapisanie planu usuwa z pliku { $count } komentarzy
   *[other] Zapisanie planu usuwa z pliku { $count } komentarzy
}
parts-page-comments-lost = { $count ->
    [one] Z { $name } usunięto komentarz: plan zapisuje się bez komentarzy
    [few] Z { $name } usunięto { $count } komentarze: plan zapisuje się bez komentarzy
    [many] Z { $name } usunięto { $count } komentarzy: plan zapisuje się bez komentarzy
   *[other] Z { $name } usunięto { $count } komentarzy: plan zapisuje się bez komentarzy
}
