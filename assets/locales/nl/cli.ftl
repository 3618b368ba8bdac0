# De opdrachtregel

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = waarschuwing: { $what }
cli-remark = opmerking: { $what }

# Waar een fout over gaat
cli-what-callout = passing
cli-what-measured-value = gemeten waarde
cli-what-hole = gat
cli-what-shaft = as
cli-what-measured-hole = gemeten gat
cli-what-measured-shaft = gemeten as
cli-what-hole-material = materiaal van het gat
cli-what-shaft-material = materiaal van de as
cli-what-temperature = temperatuur
cli-what-smallest-clearance = kleinste speling
cli-what-largest-clearance = grootste speling
cli-what-nominal-size = nominale maat { $text }
cli-what-true-diameter = ware diameter
cli-what-simulated-workpiece = gesimuleerd werkstuk
cli-what-simulated-measurement = gesimuleerde meting
cli-what-perfect-workpiece = werkstuk op nominale maat
cli-what-size = maat
cli-what-cycle = cyclus { $code }
cli-what-log = protocol
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Fouten
cli-not-above-zero = { $diameter } mm is niet groter dan 0
cli-line-too-long = de regel is langer dan { $limit } bytes
cli-not-a-table = { $name } is geen tabel met afwijkingen
cli-add-feature = { $error }: voeg --feature hole of --feature shaft toe
cli-rework-or-scrap = { $asked }: { $measured } mm ligt buiten { $minimum } tot { $maximum } mm; of dat nabewerken of afkeur is, hangt af van gat of as: voeg --feature hole of --feature shaft toe
cli-parts-of-several = gemeten delen horen bij één passing: geef één passing
cli-search-with-parts = zoeken gaat zonder gemeten delen, materialen of temperaturen
cli-search-without-size = zoeken vraagt om één nominale maat, zoals 25
cli-search-without-clearance = zoeken vraagt om --min-clearance en --max-clearance
cli-table-ending = { $path }: de naam van een besturingstabel eindigt op .tab
cli-format-ending = { $path }: een bestand in formaat { $format } eindigt op .{ $endings }
cli-several-tables = een besturingstabel is één bestand: noem één tabel, of klassen voor alleen gaten of alleen assen
cli-report-format = --format { $format } past niet bij de extensie van { $file }: laat een van beide weg
cli-report-empty = geen enkele controle kon worden gebruikt, dus er is geen rapport geschreven
cli-not-an-object = invoer is een JSON-object zoals {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: hier hoort een getal of een tekst
cli-given-twice = { $name } staat er twee keer
cli-set-twice = { $name } is twee keer gezet
cli-other-cycle = dit is cyclus { $given }, niet { $wanted }
cli-not-predef = { $name } is geen parameter die PREDEF mag zijn
cli-no-probe = de tastertabel heeft geen taster { $number }
cli-not-a-pair = { $text }: een parameter wordt gegeven als NAAM=WAARDE
cli-not-a-position = positie { $text }: drie getallen X,Y,Z in mm zijn nodig
cli-not-a-number = dit is geen getal
cli-no-folder = map bestaat niet: { $path }
cli-no-program = { $error }; ingebouwde programma's zijn { $names }
cli-option-beside-plan = --{ $option } is voor één losse passing: een plan heeft er een kolom voor
cli-option-missing = --{ $option } ontbreekt: een losse passing vraagt om --x, --y en --z
cli-use-force = { $error }; --force overschrijft

# Een --check van een rapport
cli-check-no-measured = { $text } heeft geen gemeten waarde: schrijf een passing, = en millimeters, bijvoorbeeld 25 H7=25.012
cli-check-measured = gemeten waarde: { $value }
cli-check-not-positive = gemeten waarde { $measured } mm is niet groter dan 0

# Opmerkingen
cli-remark-wrote = { $path } geschreven
cli-remark-wrote-files = { $path } geschreven ({ $count } bestanden)
cli-remark-simulated = gesimuleerd: er is niets gemeten
cli-remark-remove = verwijder { $limit } mm tot de dichtstbijzijnde grensmaat, { $middle } mm tot het midden van de tolerantie
cli-remark-refused = { $refused } van { $asked } passingen geweigerd
cli-remark-no-pair = geen enkel paar past; het dichtst erbij is { $nearest }
cli-remark-clearance-height = de veilige hoogte is { $height } mm: --clearance-height geeft een andere

# Waarschuwingen
cli-warning-column-not-used = kolom { $column } wordt niet gebruikt
cli-warning-own-table = tabel { $name } wijkt af van ISO 286, die { $upper } en { $lower } mm heeft
cli-warning-empty-cell = { $class } boven { $over } tot en met { $to } mm blijft leeg: ISO 286 heeft niet één waarde voor het hele bereik
cli-warning-contacts-left = de cyclus nam { $used } van { $count } tastpunten
cli-warning-log-unknown = er wordt geen protocol gemaakt: dat van cyclus { $code } is niet bekend
cli-warning-log-off = er wordt geen protocol geschreven: Q281 = 0
cli-warning-log-none = er wordt geen protocol geschreven: de cyclus heeft er geen
cli-warning-log-on-screen = er wordt geen protocol geschreven: Q281 = 2 toont het op het scherm

# Tabellen tegen ISO 286
cli-verify-off = { $place }: { $class } boven { $over } tot en met { $to } mm: { $table }, ISO 286 heeft { $standard }: { $by }
cli-verify-missing = { $place }: { $class } boven { $over } tot en met { $to } mm: geen waarde, ISO 286 heeft { $standard }
cli-verify-undefined = { $place }: { $class } boven { $over } tot en met { $to } mm: { $table }, maar { $reason }
cli-verify-neither = { $place }: { $class } boven { $over } tot en met { $to } mm: { $reason }
cli-verify-by = { $side ->
        [upper] bovenste
       *[lower] onderste
    } { $um } µm { $way ->
        [more] meer
       *[less] minder
    }
cli-verify-table = { $name }: { $classes ->
        [one] { $classes } klasse
       *[other] { $classes } klassen
    }, { $ranges ->
        [one] { $ranges } maatbereik
       *[other] { $ranges } maatbereiken
    }, { $cells ->
        [one] { $cells } cel
       *[other] { $cells } cellen
    } vergeleken: { $differ ->
        [0] alles volgens ISO 286
        [one] { $differ } wijkt af van ISO 286
       *[other] { $differ } wijken af van ISO 286
    }
cli-verify-nothing = { $name }: { $classes ->
        [one] { $classes } klasse
       *[other] { $classes } klassen
    }, { $ranges ->
        [one] { $ranges } maatbereik
       *[other] { $ranges } maatbereiken
    }, { $cells } cellen vergeleken: niets te vergelijken met ISO 286
cli-verify-own = { $table }; niet vergeleken, geen klasse van ISO 286: { $own }

## Start
start-missing = bestand bestaat niet: { $path }; noem een bestaand bestand om het in het venster te openen, of een subopdracht
start-folder = dit is een map, geen bestand: { $path }; alleen bestanden gaan open in het venster
