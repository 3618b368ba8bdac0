# pairing

pairing-not-a-range = vůle { $given }: očekává se nejmenší a největší v mm se dvěma tečkami mezi nimi, například 0.010..0.030
pairing-minimum = nejmenší vůle: { $reason }
pairing-maximum = největší vůle: { $reason }
pairing-swapped = nejmenší vůle { $minimum } mm je větší než největší, { $maximum } mm
pairing-too-narrow = { $feature ->
        [hole] díry
       *[shaft] hřídele
    } od { $from } do { $to } mm nelze roztřídit do skupin, počet { $count }: skupina má nejméně jeden nanometr
pairing-group-count = počet skupin { $count }: očekává se 1 až { $most }
pairing-no-sizes = nejsou { $feature ->
        [hole] díry
       *[shaft] hřídele
    } k roztřídění

# What to check about parts
pairing-parts-outside-limits = { $count ->
        [one] 1 díl je mimo své vlastní meze
        [few] { $count } díly jsou mimo své vlastní meze
       *[other] { $count } dílů je mimo své vlastní meze
    }: páry se volí jen podle vůle
pairing-parts-checked-twice = { $rows ->
        [one] jedna kontrola má název dřívější kontroly
        [few] { $rows } kontroly mají název dřívější kontroly
       *[other] { $rows } kontrol má název dřívější kontroly
    }, například { $id }, kontroly { $first } a { $second }: každá kontrola se počítá jako díl
pairing-parts-simulated-checks = { $count ->
        [one] 1 kontrola je simulovaná
        [few] { $count } kontroly jsou simulované
       *[other] { $count } kontrol je simulovaných
    }: nic se neměřilo
