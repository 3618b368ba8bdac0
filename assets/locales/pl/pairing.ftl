# pairing

pairing-not-a-range = luzy { $given }: oczekiwany najmniejszy i największy w mm, między nimi dwie kropki, np. 0.010..0.030
pairing-minimum = najmniejszy luz: { $reason }
pairing-maximum = największy luz: { $reason }
pairing-swapped = najmniejszy luz { $minimum } mm jest większy od największego, { $maximum } mm
pairing-too-narrow = { $feature ->
        [hole] otworów
       *[shaft] wałków
    } od { $from } do { $to } mm nie można podzielić na grupy ({ $count }): grupa ma co najmniej jeden nanometr
pairing-group-count = liczba grup { $count }: oczekiwana od 1 do { $most }
pairing-no-sizes = nie ma { $feature ->
        [hole] otworów
       *[shaft] wałków
    } do sortowania

# Co sprawdzić przy częściach
pairing-parts-outside-limits = { $count ->
        [one] 1 część jest poza własnymi granicami
        [few] { $count } części są poza własnymi granicami
        [many] { $count } części jest poza własnymi granicami
       *[other] { $count } części jest poza własnymi granicami
    }: pary są dobierane tylko według luzu
pairing-parts-checked-twice = { $rows ->
        [one] jedna kontrola ma nazwę wcześniejszej
        [few] { $rows } kontrole mają nazwę wcześniejszej
        [many] { $rows } kontroli ma nazwę wcześniejszej
       *[other] { $rows } kontroli ma nazwę wcześniejszej
    }, np. { $id }, kontrole { $first } i { $second }: każda kontrola liczy się jako część
pairing-parts-simulated-checks = { $count ->
        [one] 1 kontrola jest symulowana
        [few] { $count } kontrole są symulowane
        [many] { $count } kontroli jest symulowanych
       *[other] { $count } kontroli jest symulowanych
    }: niczego nie zmierzono
