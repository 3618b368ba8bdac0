## AQDEF van Q-DAS
aqdef-line = een sleutel en een tekst zoals K0001/1 25.012 verwacht, of een regel met waarden
aqdef-number = { $key }: { $reason }
aqdef-whole = { $key }: { $given } is geen geheel getal
aqdef-undeclared = een waarde van kenmerk { $number }, dat erboven niet is beschreven
aqdef-of-all = { $key } met nummer 0 zou de waarde van elk kenmerk zijn: overgeslagen
aqdef-cut-off = het bestand eindigt hier zonder regeleinde, dus { $given } is misschien afgekapt: overgeslagen; zet er een regeleinde achter als de waarde volledig is
aqdef-zeros = de regel heeft bytes met waarde 0, dus het bestand is niet volledig geschreven: de regel is overgeslagen
aqdef-mark-between = K0002/0 { $given } staat tussen deze rij en de vorige, en kan bij beide horen: de waarde is overgeslagen
aqdef-twice = { $key } is twee keer gegeven met verschillende teksten, eerder met { $other }: waarden van dit kenmerk zijn niet beoordeeld
aqdef-fields = hoogstens { $most } velden van een waarde verwacht, { $found } gevonden
aqdef-no-values = { $count ->
        [0] geen kenmerken en geen waarden
        [one] 1 kenmerk en geen waarde: dit is een plan, geen metingen
       *[other] { $count } kenmerken en geen waarde: dit is een plan, geen metingen
    }
aqdef-no-values-beside = { $count ->
        [0] geen kenmerken en geen waarden
        [one] 1 kenmerk en geen waarde
       *[other] { $count } kenmerken en geen waarde
    }, en geen { $file } tot { $most } MiB naast dit bestand: dit is een plan, geen metingen; geef { $file } zelf als het groter is
aqdef-no-description = waarden zonder kenmerken: { $file } ontbreekt naast dit bestand
aqdef-count = K0100 kondigt { $expected } kenmerken aan, { $found } gevonden: het bestand is misschien afgekapt
aqdef-too-large = de kenmerken zijn groter dan { $most } MiB
aqdef-beside = { $file }, regel { $line }: { $reason }
aqdef-warning-count = K0100 kondigt { $expected } kenmerken aan, { $found } gevonden: het bestand is misschien afgekapt
aqdef-warning-fewer = { $expected } waarden verwacht, { $found } gevonden
aqdef-warning-missing = { $count ->
        [one] 1 waarde is leeg of als ontbrekend gemerkt (K0002 is 255 of 256), vanaf deze regel: die is overgeslagen
       *[other] { $count } waarden zijn leeg of als ontbrekend gemerkt (K0002 is 255 of 256), vanaf deze regel: ze zijn overgeslagen
    }
aqdef-warning-skipped = overgeslagen velden: { $keys }
aqdef-warning-repeated = { $key } staat er twee keer met verschillende teksten: deze telt
aqdef-warning-late = { $key } hoort bij geen waarde die net daarvoor is gelezen: overgeslagen
aqdef-warning-allowance = nominale maat en grensmaatafwijking geven { $limit }, maar de grensmaat is een andere: de grensmaat telt
aqdef-warning-tolerance = { $key } heeft een tolerantie van { $given } mm, maar de grensmaten geven { $expected } mm: de grensmaten tellen
aqdef-warning-no-limit = { $key } is gegeven, maar volgens K2120 of K2121 is er geen grens: overgeslagen
aqdef-warning-kind-of-limit = { $given } is geen bekende soort grens (0, 1 of 2): genomen als grens
aqdef-warning-scrap-limit = de afkeurgrens { $limit } is niet de grensmaat zelf: die is overgeslagen, en een waarde voorbij de grensmaat aan deze kant is afkeur
aqdef-warning-scrap-feature = de afkeurgrens is die van { $feature ->
        [hole] een boring
       *[shaft] een as
    }, en { $callout } niet: de tolerantieklasse telt
aqdef-warning-cut-off = het bestand eindigt hier zonder regeleinde, en { $given } is korter dan de andere: misschien afgekapt
aqdef-warning-zeros = het bestand heeft hier bytes met waarde 0, dus het is niet volledig geschreven: misschien ontbreken er waarden
aqdef-warning-values-left = { $file } heeft { $count ->
        [one] 1 regel met waarden, die niet is gelezen
       *[other] { $count } regels met waarden, die niet zijn gelezen
    }
aqdef-warning-values-beside = de waarden komen uit { $file } naast dit bestand, en de regelnummers verwijzen daarnaar
aqdef-warning-description-beside = de kenmerken komen uit { $file } naast dit bestand
aqdef-warning-beside = { $file }, regel { $line }: { $reason }
