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
