page-pairing = Parowanie

# O co pytamy
pairing-page-wanted = Żądany luz lub pasowanie
pairing-page-wanted-hint = Najmniejszy i największy w mm, np. 0.010..0.030, lub pasowanie, np. 25 H7/g6. Ujemny to wcisk.
pairing-page-wanted-range = Luz { $minimum } … { $maximum } µm, środek { $middle } µm
pairing-page-wanted-fit = { $fit }: luz { $minimum } … { $maximum } µm, środek { $middle } µm
pairing-page-wanted-refused = { $reason }; dozwolone: pasowanie, np. 25 H7/g6, lub dwa luzy w mm, np. 0.010..0.030
pairing-page-holes = Zmierzone otwory
pairing-page-shafts = Zmierzone wałki
pairing-page-no-parts = jeszcze bez części
pairing-page-reading = odczyt…
pairing-page-from-file = { $name }, { $count ->
        [one] 1 część
        [few] { $count } części
        [many] { $count } części
       *[other] { $count } części
    }
pairing-page-from-history = Z historii, { $count ->
        [one] 1 część
        [few] { $count } części
        [many] { $count } części
       *[other] { $count } części
    }
pairing-page-refused = { $count ->
        [one] 1 wiersz odrzucony
        [few] { $count } wiersze odrzucone
        [many] { $count } wierszy odrzuconych
       *[other] { $count } wierszy odrzuconych
    }
pairing-page-all-refused = Wszystkie odrzucone wiersze: { $count }
pairing-page-all-notes = Wszystkie ostrzeżenia: { $count }
pairing-page-open-holes = Otwórz otwory…
pairing-page-open-shafts = Otwórz wałki…
pairing-page-history-holes = Otwory z historii
pairing-page-history-shafts = Wałki z historii
pairing-page-history-hint = Używa zaznaczonych kontroli, a bez zaznaczenia wszystkich z listy
pairing-page-groups = Grupy
pairing-page-groups-hint = Liczba grup o równej szerokości, na które części są dodatkowo sortowane. Puste: bez grup.
pairing-page-do-wanted = Wpisać żądany luz lub pasowanie.
pairing-page-do-holes = Otworzyć zmierzone otwory lub wziąć je z historii.
pairing-page-do-shafts = Otworzyć zmierzone wałki lub wziąć je z historii.
pairing-page-about = Fitcheck tworzy jak najwięcej par w żądanym luzie. Ze wszystkich możliwości wybiera tę o najmniejszej sumie kwadratów odległości od środka. Wystarczą nazwy i zmierzone wymiary. Pliki można też tu upuścić, najpierw otwory.
pairing-page-no-side = { $name } nie zostaje otwarty: są już otwory i wałki. Otworzyć go jako otwory lub jako wałki.
pairing-page-none-in-history = W historii nie ma kontroli { $feature ->
        [hole] otworów
       *[shaft] wałków
    }.
pairing-page-listed-only = Historia jest filtrowana: { $feature ->
        [hole] otwory
       *[shaft] wałki
    } pochodzą z kontroli na liście: { $listed } z { $all }
pairing-page-none-chosen = Żadna z zaznaczonych kontroli nie dotyczy { $feature ->
        [hole] otworu
       *[shaft] wałka
    }.
pairing-page-nothing-read = { $name } nie ma wymiaru, którego można użyć: { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }(odrzucone wiersze: { $count })
    }
pairing-page-nothing-to-save = nie ma par do zapisania

# Pary
pairing-page-pairs = Pary
pairing-page-hole = Otwór
pairing-page-shaft = Wałek
pairing-page-clearance = Luz
pairing-page-from-middle = Od środka
pairing-page-from-middle-head = Od środka
pairing-page-remark = Uwaga
pairing-page-line = linia { $line }
pairing-page-check = kontrola { $line }
pairing-page-hole-simulated = otwór symulowany
pairing-page-shaft-simulated = wałek symulowany
pairing-page-both-simulated = oba symulowane
pairing-page-list = Pary otworów i wałków
pairing-page-row = { $hole } { $hole-mm } mm z { $shaft } { $shaft-mm } mm, luz { $clearance } µm, { $middle } µm od środka
pairing-page-move = Przejdź do innej pary
pairing-page-copy = Kopiuj pary

# Obraz
pairing-page-picture = Części według wymiaru
pairing-page-legend = Pierścień: otwór. Krążek: wałek, przesunięty o środek, { $middle } µm: para w środku leży poziomo. Krzyżyk: bez pary.
pairing-page-part-of = Po lewej: wszystkie części; ramka oznacza narysowane.
pairing-page-thinned = Za gęsto, aby narysować wszystkie: rysowana jest 1 na { $step }.
pairing-page-left-over = bez pary
pairing-page-describe = { $holes ->
        [one] 1 otwór
        [few] { $holes } otwory
        [many] { $holes } otworów
       *[other] { $holes } otworów
    } po lewej, { $shafts ->
        [one] 1 wałek
        [few] { $shafts } wałki
        [many] { $shafts } wałków
       *[other] { $shafts } wałków
    } po prawej, na jednej skali wymiarów; wałki są przesunięte o { $middle } µm, tak że para w środku żądanego luzu leży poziomo. { $pairs ->
        [one] 1 para jest narysowana jako linia.
        [few] { $pairs } pary są narysowane jako linie.
        [many] { $pairs } par jest narysowanych jako linie.
       *[other] { $pairs } par jest narysowanych jako linie.
    }
pairing-page-describe-part = { $pairs ->
        [one] 1 para jest widoczna.
        [few] { $pairs } pary są widoczne.
        [many] { $pairs } par jest widocznych.
       *[other] { $pairs } par jest widocznych.
    }
pairing-page-describe-selected = Wybrano: { $hole } z { $shaft }, luz { $clearance } µm.

# Odpowiedź
pairing-page-count = { $count ->
        [one] 1 para
        [few] { $count } pary
        [many] { $count } par
       *[other] { $count } par
    }
pairing-page-none = Jeszcze bez wyniku
pairing-page-at-work = Parowanie…
pairing-page-nothing-left = wszystkie w parach
pairing-page-left = bez pary: { $holes ->
        [one] 1 otwór
        [few] { $holes } otwory
        [many] { $holes } otworów
       *[other] { $holes } otworów
    }, { $shafts ->
        [one] 1 wałek
        [few] { $shafts } wałki
        [many] { $shafts } wałków
       *[other] { $shafts } wałków
    }
pairing-page-simulated = { $count ->
        [one] 1 para z symulowaną częścią
        [few] { $count } pary z symulowaną częścią
        [many] { $count } par z symulowaną częścią
       *[other] { $count } par z symulowaną częścią
    }
pairing-page-no-pair = Żaden otwór i wałek nie mają luzu w żądanym zakresie.
pairing-page-smallest = Luz najmniejszy
pairing-page-largest = Luz największy
pairing-page-middle = Żądany środek
pairing-page-band = Zakres wokół niego
pairing-page-grinding = Szlifowanie
pairing-page-grind = { $amount } µm z wałków bez pary lub z otworów bez pary: { $count ->
        [one] 1 para więcej
        [few] { $count } pary więcej
        [many] { $count } par więcej
       *[other] { $count } par więcej
    }
pairing-page-grind-means = Najmniejszy naddatek do zebrania, co 1 µm, który daje najwięcej dodatkowych par. Istniejące pary pozostają.
pairing-page-grind-nothing = Żadna wartość nie daje następnej pary.
pairing-page-grind-bounded = Wypróbowano wartości do { $tried } µm; najdalsze części wymagałyby { $reach } µm.
pairing-page-groups-title = Grupy
pairing-page-group = Grupa { $number }: { $count ->
        [one] 1 para
        [few] { $count } pary
        [many] { $count } par
       *[other] { $count } par
    }
pairing-page-all-within = ✓ wszystkie w zakresie
pairing-page-not-all-within = ✗ nie wszystkie w zakresie
pairing-page-no-group-pairs = jedna strona jest pusta
pairing-page-group-holes = { $count ->
        [one] 1 otwór
        [few] { $count } otwory
        [many] { $count } otworów
       *[other] { $count } otworów
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] 1 wałek
        [few] { $count } wałki
        [many] { $count } wałków
       *[other] { $count } wałków
    } { $from } … { $to } mm
pairing-page-group-clearance = luz { $range }
pairing-page-outside-groups = W żadnej grupie, poza polami tolerancji: { $holes ->
        [one] 1 otwór
        [few] { $holes } otwory
        [many] { $holes } otworów
       *[other] { $holes } otworów
    }, { $shafts ->
        [one] 1 wałek
        [few] { $shafts } wałki
        [many] { $shafts } wałków
       *[other] { $shafts } wałków
    }

# Pliki
pairing-page-save-csv = Zapisz jako CSV…
pairing-page-save-json = Zapisz jako JSON…
pairing-page-file-name = pary
pairing-page-dialog-holes = Otwieranie zmierzonych otworów
pairing-page-dialog-shafts = Otwieranie zmierzonych wałków
pairing-page-dialog-save = Zapisywanie par
file-kind-holes = Zmierzone otwory
file-kind-shafts = Zmierzone wałki
file-kind-pairs = Pary
