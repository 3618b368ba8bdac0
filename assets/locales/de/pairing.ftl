# pairing

pairing-not-a-range = Spiel { $given }: das kleinste und das größte in mm mit zwei Punkten dazwischen erwartet, wie 0.010..0.030
pairing-minimum = kleinstes Spiel: { $reason }
pairing-maximum = größtes Spiel: { $reason }
pairing-swapped = das kleinste Spiel { $minimum } mm ist größer als das größte, { $maximum } mm
pairing-too-narrow = { $feature ->
        [hole] Bohrungen
       *[shaft] Wellen
    } von { $from } bis { $to } mm können nicht in { $count } Gruppen sortiert werden: eine Gruppe hat mindestens einen Nanometer
pairing-group-count = { $count } Gruppen: 1 bis { $most } erwartet
pairing-no-sizes = keine { $feature ->
        [hole] Bohrungen
       *[shaft] Wellen
    } zu sortieren

# Was an Teilen zu prüfen ist
pairing-parts-outside-limits = { $count ->
        [one] 1 Teil liegt außerhalb seiner eigenen Grenzmaße
       *[other] { $count } Teile liegen außerhalb ihrer eigenen Grenzmaße
    }: Paare werden nur nach Spiel gewählt
pairing-parts-checked-twice = { $rows ->
        [one] eine Prüfung hat den Namen einer früheren Prüfung
       *[other] { $rows } Prüfungen haben den Namen einer früheren Prüfung
    }, wie { $id }, Prüfungen { $first } und { $second }: jede Prüfung zählt als ein Teil
pairing-parts-simulated-checks = { $count ->
        [one] 1 Prüfung ist simuliert
       *[other] { $count } Prüfungen sind simuliert
    }: nichts wurde gemessen
