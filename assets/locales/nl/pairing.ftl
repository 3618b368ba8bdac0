# pairing

pairing-not-a-range = spelingen { $given }: de kleinste en de grootste in mm met twee punten ertussen verwacht, bijvoorbeeld 0.010..0.030
pairing-minimum = kleinste speling: { $reason }
pairing-maximum = grootste speling: { $reason }
pairing-swapped = de kleinste speling { $minimum } mm is groter dan de grootste, { $maximum } mm
pairing-too-narrow = { $feature ->
        [hole] boringen
       *[shaft] assen
    } van { $from } tot { $to } mm kunnen niet in { $count } groepen worden gesorteerd: een groep is minstens één nanometer breed
pairing-group-count = { $count } groepen: 1 tot { $most } verwacht
pairing-no-sizes = er zijn geen { $feature ->
        [hole] boringen
       *[shaft] assen
    } om te sorteren

# What to check about parts
pairing-parts-outside-limits = { $count ->
        [one] 1 onderdeel ligt buiten zijn eigen grensmaten
       *[other] { $count } onderdelen liggen buiten hun eigen grensmaten
    }: paren volgen alleen uit de speling
pairing-parts-checked-twice = { $rows ->
        [one] een controle heeft de naam van een eerdere controle
       *[other] { $rows } controles hebben de naam van een eerdere controle
    }, zoals { $id }, controles { $first } en { $second }: elke controle telt als een onderdeel
pairing-parts-simulated-checks = { $count ->
        [one] 1 controle is gesimuleerd
       *[other] { $count } controles zijn gesimuleerd
    }: er is niets gemeten
