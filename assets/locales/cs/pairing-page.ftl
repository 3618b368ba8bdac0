page-pairing = Párování

# What is asked
pairing-page-wanted = Požadovaná vůle nebo uložení
pairing-page-wanted-hint = Nejmenší a největší v mm, například 0.010..0.030, nebo uložení, například 25 H7/g6. Záporná hodnota je přesah.
pairing-page-wanted-range = Vůle { $minimum } … { $maximum } µm, střed { $middle } µm
pairing-page-wanted-fit = { $fit }: vůle { $minimum } … { $maximum } µm, střed { $middle } µm
pairing-page-wanted-refused = { $reason }; dovoleno je uložení, například 25 H7/g6, a dvě vůle v mm, například 0.010..0.030
pairing-page-holes = Změřené díry
pairing-page-shafts = Změřené hřídele
pairing-page-no-parts = zatím žádné
pairing-page-reading = čte se…
pairing-page-from-file = { $name }, { $count ->
        [one] 1 díl
        [few] { $count } díly
       *[other] { $count } dílů
    }
pairing-page-from-history = Z historie, { $count ->
        [one] 1 díl
        [few] { $count } díly
       *[other] { $count } dílů
    }
pairing-page-refused = { $count ->
        [one] 1 odmítnutý řádek
        [few] { $count } odmítnuté řádky
       *[other] { $count } odmítnutých řádků
    }
pairing-page-all-refused = Všechny odmítnuté řádky ({ $count })
pairing-page-all-notes = Všechna varování ({ $count })
pairing-page-open-holes = Otevřít díry…
pairing-page-open-shafts = Otevřít hřídele…
pairing-page-history-holes = Díry z historie
pairing-page-history-shafts = Hřídele z historie
pairing-page-history-hint = Použije vybrané kontroly, nebo všechny ze seznamu, není-li žádná vybrána
pairing-page-groups = Skupiny
pairing-page-groups-hint = Počet skupin stejné šířky, do kterých se díly také roztřídí. Prázdné: žádné.
pairing-page-do-wanted = Zadejte požadovanou vůli nebo uložení.
pairing-page-do-holes = Otevřete změřené díry, nebo je vezměte z historie.
pairing-page-do-shafts = Otevřete změřené hřídele, nebo je vezměte z historie.
pairing-page-about = Fitcheck vytvoří co nejvíce párů v požadované vůli. Ze všech možností vybere tu s nejmenším součtem čtverců odstupů od středu. Stačí názvy a naměřené rozměry. Soubory lze sem také přetáhnout, nejprve díry.
pairing-page-no-side = { $name } se neotevře: díry i hřídele už jsou. Otevřete jej jako díry nebo jako hřídele.
pairing-page-none-in-history = V historii nejsou kontroly { $feature ->
        [hole] děr
       *[shaft] hřídelů
    }.
pairing-page-listed-only = Historie je filtrována: { $feature ->
        [hole] díry
       *[shaft] hřídele
    } pocházejí z kontrol v seznamu, { $listed } z { $all }
pairing-page-none-chosen = Žádná z vybraných kontrol není kontrolou { $feature ->
        [hole] díry
       *[shaft] hřídele
    }.
pairing-page-nothing-read = { $name } nemá žádný použitelný rozměr: { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }(odmítnuto řádků: { $count })
    }
pairing-page-nothing-to-save = nejsou páry k uložení

# The pairs
pairing-page-pairs = Páry
pairing-page-hole = Díra
pairing-page-shaft = Hřídel
pairing-page-clearance = Vůle
pairing-page-from-middle = Od středu
pairing-page-from-middle-head = Od středu
pairing-page-remark = Poznámka
pairing-page-line = řádek { $line }
pairing-page-check = kontrola { $line }
pairing-page-hole-simulated = díra simulovaná
pairing-page-shaft-simulated = hřídel simulovaný
pairing-page-both-simulated = oba simulované
pairing-page-list = Páry děr a hřídelů
pairing-page-row = { $hole } { $hole-mm } mm s { $shaft } { $shaft-mm } mm, vůle { $clearance } µm, { $middle } µm od středu
pairing-page-move = Přejít na jiný pár
pairing-page-copy = Kopírovat páry

# The picture
pairing-page-picture = Díly podle rozměru
pairing-page-legend = Kroužek: díra. Kolečko: hřídel, posunutý o střed, { $middle } µm: pár ve středu leží vodorovně. Křížek: zbylý díl.
pairing-page-part-of = Vlevo: všechny díly; rámeček označuje vykreslené.
pairing-page-thinned = Příliš husté na vykreslení všech: vykreslen je 1 z { $step }.
pairing-page-left-over = zbylý
pairing-page-describe = { $holes ->
        [one] 1 díra
        [few] { $holes } díry
       *[other] { $holes } děr
    } vlevo, { $shafts ->
        [one] 1 hřídel
        [few] { $shafts } hřídele
       *[other] { $shafts } hřídelů
    } vpravo, na jedné stupnici rozměrů; hřídele jsou posunuty o { $middle } µm, pár ve středu požadované vůle tedy leží vodorovně. { $pairs ->
        [one] 1 pár je vykreslen jako čára.
        [few] { $pairs } páry jsou vykresleny jako čáry.
       *[other] { $pairs } párů je vykresleno jako čáry.
    }
pairing-page-describe-part = { $pairs ->
        [one] Vidět je 1 pár.
        [few] Vidět jsou { $pairs } páry.
       *[other] Vidět je { $pairs } párů.
    }
pairing-page-describe-selected = Vybráno: { $hole } s { $shaft }, vůle { $clearance } µm.

# The answer
pairing-page-count = { $count ->
        [one] 1 pár
        [few] { $count } páry
       *[other] { $count } párů
    }
pairing-page-none = Zatím bez výsledku
pairing-page-at-work = Páruje se…
pairing-page-nothing-left = nic nezbylo
pairing-page-left = zbylo: { $holes ->
        [one] 1 díra
        [few] { $holes } díry
       *[other] { $holes } děr
    }, { $shafts ->
        [one] 1 hřídel
        [few] { $shafts } hřídele
       *[other] { $shafts } hřídelů
    }
pairing-page-simulated = { $count ->
        [one] 1 pár se simulovaným dílem
        [few] { $count } páry se simulovaným dílem
       *[other] { $count } párů se simulovaným dílem
    }
pairing-page-no-pair = Žádná díra a hřídel nemají vůli v požadovaném rozsahu.
pairing-page-smallest = Nejmenší vůle
pairing-page-largest = Největší vůle
pairing-page-middle = Požadovaný střed
pairing-page-band = Pás kolem něj
pairing-page-grinding = Broušení
pairing-page-grind = { $amount } µm ze zbylých hřídelů nebo ze zbylých děr: { $count ->
        [one] další 1 pár
        [few] další { $count } páry
       *[other] dalších { $count } párů
    }
pairing-page-grind-means = Nejmenší úběr, po krocích 1 µm, který dá nejvíce dalších párů. Stávající páry zůstávají.
pairing-page-grind-nothing = Žádný úběr nedá další pár.
pairing-page-grind-bounded = Zkoušel se úběr do { $tried } µm; nejvzdálenější díly by potřebovaly { $reach } µm.
pairing-page-groups-title = Skupiny
pairing-page-group = Skupina { $number }: { $count ->
        [one] 1 pár
        [few] { $count } páry
       *[other] { $count } párů
    }
pairing-page-all-within = ✓ vše v rozsahu
pairing-page-not-all-within = ✗ ne vše v rozsahu
pairing-page-no-group-pairs = jedna strana je prázdná
pairing-page-group-holes = { $count ->
        [one] 1 díra
        [few] { $count } díry
       *[other] { $count } děr
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] 1 hřídel
        [few] { $count } hřídele
       *[other] { $count } hřídelů
    } { $from } … { $to } mm
pairing-page-group-clearance = vůle { $range }
pairing-page-outside-groups = V žádné skupině, mimo toleranční pole: { $holes ->
        [one] 1 díra
        [few] { $holes } díry
       *[other] { $holes } děr
    }, { $shafts ->
        [one] 1 hřídel
        [few] { $shafts } hřídele
       *[other] { $shafts } hřídelů
    }

# Files
pairing-page-save-csv = Uložit jako CSV…
pairing-page-save-json = Uložit jako JSON…
pairing-page-file-name = pary
pairing-page-dialog-holes = Otevřít změřené díry
pairing-page-dialog-shafts = Otevřít změřené hřídele
pairing-page-dialog-save = Uložit páry
file-kind-holes = Změřené díry
file-kind-shafts = Změřené hřídele
file-kind-pairs = Páry
