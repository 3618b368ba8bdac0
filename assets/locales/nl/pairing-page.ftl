page-pairing = Paren

# What is asked
pairing-page-wanted = Gewenste speling of passing
pairing-page-wanted-hint = Kleinste en grootste in mm, bijvoorbeeld 0.010..0.030, of een passing, bijvoorbeeld 25 H7/g6. Negatief is overmaat.
pairing-page-wanted-range = Speling { $minimum } … { $maximum } µm, midden { $middle } µm
pairing-page-wanted-fit = { $fit }: speling { $minimum } … { $maximum } µm, midden { $middle } µm
pairing-page-wanted-refused = { $reason }; toegestaan zijn een passing, bijvoorbeeld 25 H7/g6, en twee spelingen in mm, bijvoorbeeld 0.010..0.030
pairing-page-holes = Gemeten boringen
pairing-page-shafts = Gemeten assen
pairing-page-no-parts = nog geen
pairing-page-reading = wordt gelezen…
pairing-page-from-file = { $name }, { $count ->
        [one] 1 onderdeel
       *[other] { $count } onderdelen
    }
pairing-page-from-history = Uit de geschiedenis, { $count ->
        [one] 1 onderdeel
       *[other] { $count } onderdelen
    }
pairing-page-refused = { $count ->
        [one] 1 rij geweigerd
       *[other] { $count } rijen geweigerd
    }
pairing-page-all-refused = Alle { $count } geweigerde rijen
pairing-page-all-notes = Alle { $count } waarschuwingen
pairing-page-open-holes = Boringen openen…
pairing-page-open-shafts = Assen openen…
pairing-page-history-holes = Boringen uit de geschiedenis
pairing-page-history-shafts = Assen uit de geschiedenis
pairing-page-history-hint = Gebruikt de gekozen controles, of alle controles in de lijst als er geen gekozen is
pairing-page-groups = Groepen
pairing-page-groups-hint = In hoeveel groepen van gelijke breedte de onderdelen ook worden gesorteerd. Leeg voor geen.
pairing-page-do-wanted = Vul de gewenste speling of een passing in.
pairing-page-do-holes = Open de gemeten boringen, of neem ze over uit de geschiedenis.
pairing-page-do-shafts = Open de gemeten assen, of neem ze over uit de geschiedenis.
pairing-page-about = Fitcheck maakt zo veel mogelijk paren binnen de gewenste speling. Van alle mogelijkheden neemt het die met de kleinste som van de gekwadrateerde afstanden tot het midden. Namen en gemeten maten zijn genoeg. Bestanden kunnen ook hierheen worden gesleept, de boringen eerst.
pairing-page-no-side = { $name } is niet geopend: er zijn al boringen en assen. Open het bestand als boringen of als assen.
pairing-page-none-in-history = De geschiedenis heeft geen controles van { $feature ->
        [hole] boringen
       *[shaft] assen
    }.
pairing-page-listed-only = De geschiedenis is gefilterd: de { $feature ->
        [hole] boringen
       *[shaft] assen
    } komen uit { $listed } van de { $all } controles
pairing-page-none-chosen = Geen van de gekozen controles is van een { $feature ->
        [hole] boring
       *[shaft] as
    }.
pairing-page-nothing-read = { $name } heeft geen bruikbare maat: { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }({ $count } rijen geweigerd)
    }
pairing-page-nothing-to-save = er zijn geen paren om op te slaan

# The pairs
pairing-page-pairs = Paren
pairing-page-hole = Boring
pairing-page-shaft = As
pairing-page-clearance = Speling
pairing-page-from-middle = Van het midden
pairing-page-from-middle-head = Van midden
pairing-page-remark = Opmerking
pairing-page-line = regel { $line }
pairing-page-check = controle { $line }
pairing-page-hole-simulated = boring gesimuleerd
pairing-page-shaft-simulated = as gesimuleerd
pairing-page-both-simulated = beide gesimuleerd
pairing-page-list = Paren van boringen en assen
pairing-page-row = { $hole } { $hole-mm } mm met { $shaft } { $shaft-mm } mm, speling { $clearance } µm, { $middle } µm van het midden
pairing-page-move = Naar een ander paar
pairing-page-copy = Paren kopiëren

# The picture
pairing-page-picture = Onderdelen naar maat
pairing-page-legend = Ring: boring. Schijf: as, verschoven over het midden, { $middle } µm: een paar op het midden ligt horizontaal. Kruis: overblijver.
pairing-page-part-of = Links: alle onderdelen; het kader geeft aan welke getekend zijn.
pairing-page-thinned = Te dicht op elkaar om alles te tekenen: 1 van de { $step } is getekend.
pairing-page-left-over = overblijver
pairing-page-describe = { $holes ->
        [one] 1 boring
       *[other] { $holes } boringen
    } links, { $shafts ->
        [one] 1 as
       *[other] { $shafts } assen
    } rechts, op één schaal van maten; assen zijn { $middle } µm verschoven, zodat een paar op het midden van de gewenste speling horizontaal ligt. { $pairs ->
        [one] 1 paar is als lijn getekend.
       *[other] { $pairs } paren zijn als lijnen getekend.
    }
pairing-page-describe-part = { $pairs ->
        [one] 1 paar is in beeld.
       *[other] { $pairs } paren zijn in beeld.
    }
pairing-page-describe-selected = Gekozen: { $hole } met { $shaft }, speling { $clearance } µm.

# The answer
pairing-page-count = { $count ->
        [one] 1 paar
       *[other] { $count } paren
    }
pairing-page-none = Nog geen antwoord
pairing-page-at-work = Paren worden gezocht…
pairing-page-nothing-left = geen overblijvers
pairing-page-left = overblijvers: { $holes ->
        [one] 1 boring
       *[other] { $holes } boringen
    }, { $shafts ->
        [one] 1 as
       *[other] { $shafts } assen
    }
pairing-page-simulated = { $count ->
        [one] 1 paar met een gesimuleerd onderdeel
       *[other] { $count } paren met een gesimuleerd onderdeel
    }
pairing-page-no-pair = Geen boring en as hebben een speling binnen het gewenste bereik.
pairing-page-smallest = Kleinste speling
pairing-page-largest = Grootste speling
pairing-page-middle = Gewenst midden
pairing-page-band = Band eromheen
pairing-page-grinding = Slijpen
pairing-page-grind = { $amount } µm van de overgebleven assen, of uit de overgebleven boringen: { $count ->
        [one] 1 paar meer
       *[other] { $count } paren meer
    }
pairing-page-grind-means = De kleinste hoeveelheid, in stappen van 1 µm, die de meeste extra paren geeft. Gemaakte paren blijven.
pairing-page-grind-nothing = Geen hoeveelheid geeft een extra paar.
pairing-page-grind-bounded = Hoeveelheden tot { $tried } µm zijn geprobeerd; de verste onderdelen hebben { $reach } µm nodig.
pairing-page-groups-title = Groepen
pairing-page-group = Groep { $number }: { $count ->
        [one] 1 paar
       *[other] { $count } paren
    }
pairing-page-all-within = ✓ alle binnen
pairing-page-not-all-within = ✗ niet alle binnen
pairing-page-no-group-pairs = één kant is leeg
pairing-page-group-holes = { $count ->
        [one] 1 boring
       *[other] { $count } boringen
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] 1 as
       *[other] { $count } assen
    } { $from } … { $to } mm
pairing-page-group-clearance = speling { $range }
pairing-page-outside-groups = In geen groep, buiten de tolerantievelden: { $holes ->
        [one] 1 boring
       *[other] { $holes } boringen
    }, { $shafts ->
        [one] 1 as
       *[other] { $shafts } assen
    }

# Files
pairing-page-save-csv = Opslaan als CSV…
pairing-page-save-json = Opslaan als JSON…
pairing-page-file-name = paren
pairing-page-dialog-holes = Gemeten boringen openen
pairing-page-dialog-shafts = Gemeten assen openen
pairing-page-dialog-save = Paren opslaan
file-kind-holes = Gemeten boringen
file-kind-shafts = Gemeten assen
file-kind-pairs = Paren
