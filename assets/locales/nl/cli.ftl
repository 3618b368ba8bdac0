# De opdrachtregel

cli-stream = { $value }
cli-output = { $value }
cli-about = { $what }: { $error }
cli-warning = waarschuwing: { $what }
cli-remark = opmerking: { $what }

# Waar een fout over gaat
cli-what-callout = passing
cli-what-measured-value = gemeten waarde
cli-what-hole = boring
cli-what-shaft = as
cli-what-measured-hole = gemeten boring
cli-what-measured-shaft = gemeten as
cli-what-hole-material = materiaal van de boring
cli-what-shaft-material = materiaal van de as
cli-what-temperature = temperatuur
cli-what-smallest-clearance = kleinste speling
cli-what-largest-clearance = grootste speling
cli-what-nominal-size = nominale maat { $text }
cli-what-true-diameter = werkelijke diameter
cli-what-simulated-workpiece = gesimuleerd werkstuk
cli-what-simulated-measurement = gesimuleerde meting
cli-what-perfect-workpiece = werkstuk op nominale maat
cli-what-size = maat
cli-what-cycle = cyclus { $code }
cli-what-log = meetprotocol
cli-what-entry = vermelding { $number }
cli-what-option = --{ $name }
cli-what-set = --set { $name }={ $value }

# Fouten
cli-batch-simulated = de eerste regels van { $name } zeggen dat het bestand gesimuleerd is, en alleen CSV kan die overnemen: schrijf CSV
cli-dash = - is de standaarduitvoer, en dat kan hier niet: geef een naam, of ./- voor een bestand of map met de naam -
cli-no-subcommand = { $given } is geen subcommando; hier zijn er: { $names }
cli-not-above-zero = { $diameter } mm is niet groter dan 0
cli-ratio-of-one-limit = regel asme-simple vergelijkt de onzekerheid met de tolerantie: --lower en --upper verwacht
cli-already-corrected = --temperature: volgens het bestand gelden de waarden al bij 20 °C
cli-not-a-multiple = { $given }: een getal boven 0 met hoogstens drie decimalen verwacht
cli-no-limits = geef --lower, --upper of beide, met de ondergrens onder de bovengrens
cli-risk-without-uncertainty = voor de risico's van een proces is --u of --expanded nodig
cli-risk-without-process = voor --consumer-risk zijn --process-mean en --process-sd nodig, of --gamma
cli-not-a-risk = risico { $given }: een kans tussen 0 en 1 verwacht, zoals 0.001
cli-not-a-gamma = gammaverdeling { $given }: vorm en schaal in µm verwacht, zoals 4,0.25
cli-no-zone-for-risk = bij geen enkel gebied van aanvaarde waarden hoort dit risico voor de afnemer
cli-line-too-long = de regel is langer dan { $limit } bytes
cli-not-a-table = { $name } is geen tabel met afwijkingen
cli-stats-features = meerdere kenmerken: kies er een met --feature: { $names }
cli-stats-no-feature = geen kenmerk { $given }: de bestanden hebben { $names }
cli-stats-limits = de grenzen verschillen van waarde tot waarde: geef --lower en --upper, of kies een kenmerk met --feature
cli-stats-no-point = geen punt { $point }: de kaart heeft er { $count }
cli-stats-reason = { $why }
cli-stats-layout = { $doubt } (als het klopt: --confirm-layout)
cli-stats-no-budget = deze studie geeft geen bijdrage aan een budget
cli-stats-no-picture = er kan geen afbeelding worden getekend: { $why }
cli-stats-points = --stage en --leave-out gelden voor één kenmerk: kies het met --feature in plaats van --all
cli-stats-parameters = --parameters hoort bij --chart ewma of cusum
cli-add-feature = { $error }: geef --feature hole of --feature shaft op
cli-add-wide-zone = { $asked }: { $error }; geef --wide-zone op als dit tolerantieveld zo bedoeld is
cli-add-far-temperature = { $what }: { $error }; geef --far-temperature op als deze temperatuur zo bedoeld is
cli-remark-open = { $count ->
    [one] één waarde is buiten de grenzen; of dat nabewerken of afkeur is, hangt af van boring of as: voeg --feature hole of --feature shaft toe, een kolom kind met deze woorden, of een plan
   *[other] { $count } waarden zijn buiten de grenzen; of dat nabewerken of afkeur is, hangt af van boring of as: voeg --feature hole of --feature shaft toe, een kolom kind met deze woorden, of een plan
}
cli-remark-rework-or-scrap = { $side ->
    [above] { $asked }: { $um } µm boven de bovengrens; of dat nabewerking of afkeur is, hangt af van boring of as: geef --feature hole of --feature shaft op
   *[below] { $asked }: { $um } µm onder de ondergrens; of dat nabewerking of afkeur is, hangt af van boring of as: geef --feature hole of --feature shaft op
}
cli-parts-of-several = gemeten onderdelen horen bij één passing: geef één passing op
cli-search-with-parts = bij het zoeken kunnen geen gemeten onderdelen, materialen of temperaturen worden opgegeven
cli-search-without-size = voor het zoeken is één nominale maat nodig, bijvoorbeeld 25
cli-search-without-clearance = voor het zoeken zijn --min-clearance en --max-clearance nodig
cli-table-ending = { $path }: de naam van een besturingstabel eindigt op .tab
cli-format-ending = { $path }: een bestand in formaat { $format } eindigt op .{ $endings }
cli-several-tables = een besturingstabel is één bestand: noem één tabel, of klassen voor alleen boringen of alleen assen
cli-report-format = --format { $format } past niet bij de extensie van { $file }: laat een van beide weg
cli-stopped = gestopt met Ctrl+C na { $rows } rijen
cli-report-empty = geen enkele controle was bruikbaar, dus er is geen rapport geschreven
cli-inputs-too-large = de invoer van een cyclus heeft hoogstens { $most } KiB
cli-not-an-object = de invoer moet een JSON-object zijn, zoals {"{"}"Q263": 35{"}"}: { $error }
cli-not-an-input = { $name } = { $value }: een getal of een tekst verwacht
cli-given-twice = { $name } is twee keer opgegeven
cli-option-of-standard = --{ $option } heeft geen effect met --source control: de tabellen van de besturing hebben één uitgave van ISO 286
cli-set-twice = { $name } is twee keer ingesteld
cli-several-blocks = meerdere meetcycli, op de regels { $blocks }: kies er een met --at REGEL
cli-other-cycle = dit is cyclus { $given }, niet { $wanted }
cli-not-predef = voor parameter { $name } is PREDEF niet toegestaan
cli-no-probe = de tastsysteemtabel heeft geen tastsysteem { $number }
cli-not-a-pair = { $text }: schrijf een parameter als NAAM=WAARDE
cli-not-a-position = positie { $text }: drie getallen X,Y,Z in mm verwacht
cli-not-a-number = dit is geen getal
cli-no-folder = de map bestaat niet: { $path }
cli-watched-already = een ander programma bewaakt { $path } al voor dit logboek
cli-no-program = { $error }; de ingebouwde programma's zijn { $names }
cli-option-beside-plan = --{ $option } is voor één losse passing: een plan heeft daar een kolom voor
cli-option-missing = --{ $option } ontbreekt: voor een losse passing zijn --x, --y en --z nodig
cli-batch-ending = { $path }: de uitvoer moet eindigen op .{ $endings }, met .gz of .zst erachter om te comprimeren
cli-batch-onto-itself = { $path } is een van de invoerbestanden: schrijf de antwoorden naar een ander bestand
cli-batch-columns = { $name } heeft andere kolommen dan het eerste bestand, dat { $columns } heeft
cli-batch-separator = { $name } heeft een ander scheidingsteken dan het eerste bestand: schrijf .jsonl, of beoordeel dit bestand apart
cli-batch-types = kolom { $column } van { $name } heeft een ander type dan in het eerste bestand: schrijf .csv, of beoordeel dit bestand apart
cli-batch-packed = { $path }: Parquet is al gecomprimeerd: laat .gz of .zst weg
cli-batch-twice = { $name } heeft twee kolommen met de naam { $column }: schrijf .csv, waarin dat mag
cli-batch-input = { $name }: { $error }
cli-batch-name = { $name } heeft al een kolom { $column }: zet met --prefix een woord voor de namen van de toegevoegde kolommen
cli-use-force = { $error }; --force overschrijft

# Een --check van een rapport
cli-check-no-measured = { $text } heeft geen gemeten waarde: schrijf een passing, = en millimeters, bijvoorbeeld 25 H7=25,012
cli-check-measured = gemeten waarde: { $value }
cli-check-not-positive = gemeten waarde { $measured } mm is niet groter dan 0

# Opmerkingen
cli-remark-wrote = { $path } geschreven
cli-remark-wrote-files = { $path } geschreven ({ $count } bestanden)
cli-remark-simulated = gesimuleerd: er is niets gemeten
cli-remark-perfect-workpiece = gesimuleerd: elke cyclus heeft een perfect werkstuk op nominale maat gemeten; geef met --workpiece FILE.toml een ander op
cli-remark-corrected = gemeten { $measured } mm bij { $temperature } °C: { $change } µm, dus { $at-reference } mm bij 20 °C ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-corrected-all = elke gemeten waarde wordt van { $temperature } °C naar 20 °C gecorrigeerd ({ $material ->
    [none] { $expansion } · 10⁻⁶/K
   *[other] { $material }, { $expansion } · 10⁻⁶/K
})
cli-remark-scales = meetlinialen bij { $temperature } °C, { $expansion } · 10⁻⁶/K
cli-remark-linear-correction = de lineaire correctie verschilt { $off } µm van de exacte
cli-remark-rule = regel: { $rule }
cli-remark-rule-by-budget = regel: { $rule }
cli-remark-budget = onzekerheid volgens het budget { $name }, opgesteld op { $date }, geldig tot en met { $until }
cli-remark-budget-contacts = spreiding van { $touches } meetpunten{ $step }, geometriefactor { $factor }
cli-remark-accepted = aanvaard: { $least } tot { $most } mm
cli-remark-nothing-accepted = geen waarde wordt aanvaard: de regel laat niets van deze tolerantie over
cli-remark-proven = bewezen volgens deze regel
cli-remark-not-proven = niet bewezen volgens deze regel
cli-remark-conformity = voldoet met een kans van { $percent } %
cli-remark-remove = { $limit } mm verspanen tot de dichtstbijzijnde grensmaat, { $middle } mm tot het midden van het tolerantieveld
cli-remark-refused = { $refused } van { $asked } passingen geweigerd
cli-remark-no-pair = geen enkele passing voldoet; de dichtstbijzijnde is { $nearest }
cli-remark-trace-ends = de lijst van uitgevoerde NC-regels eindigt hier, na { $blocks } NC-regels
cli-remark-batch-utf16 = { $name } is UTF-16 en wordt als UTF-8 geschreven
cli-remark-batch-floats = { $name } heeft zwevendekommagetallen in { $columns }: elk wordt beoordeeld als het kortste decimale getal dat het weergeeft
cli-remark-tools-not-written = de gereedschapstabel is niet geschreven: --tools-out BESTAND.t schrijft hem met deze wijzigingen
cli-remark-clearance-height = de veilige hoogte is { $height } mm: wijzig die met --clearance-height
cli-remark-more-entries = er staan maar { $limit } vermeldingen in de lijst: met --limit N staan er meer in
cli-remark-backed-up = gekopieerd tot en met vermelding { $number } naar { $path } (hash { $hash })
cli-remark-no-head-known = van dit logboek is elders geen vermelding bekend: het ontbreken van de nieuwste vermeldingen zou niet worden gevonden

# Waarschuwingen
cli-warning-stopped-unrecorded = er is niets vastgelegd: de rijen worden samen vastgelegd, zodra ze alle gelezen zijn
cli-warning-column-not-used = kolom { $column } is overgeslagen
cli-warning-expansion-unconfirmed = de uitzetting van { $expansion } · 10⁻⁶/K is een gangbare waarde die hier door geen document is bevestigd
cli-warning-file-twice = dit bestand is tweemaal genoemd: de rijen tellen dubbel
cli-warning-position-unused = --position heeft geen effect: cyclus { $code } begint niet op de plaats van de kogel
cli-warning-predef-unused = --predef heeft geen effect op { $name }: die staat niet op PREDEF
cli-warning-log-option = --{ $option } heeft geen effect: er wordt geen meetprotocol geschreven of getoond
cli-warning-more-figures = nog { $count } zulke waarden zijn niet vermeld
cli-warning-tables-not-used = --tables, --source en opties van de norm worden niet gebruikt: zonder --fit worden geen grensmaten opgezocht
cli-warning-empty-cell = { $class } boven { $over } tot en met { $to } mm blijft leeg: ISO 286 heeft geen waarde die voor het hele bereik geldt
cli-warning-budget-option = --{ $option } heeft geen effect: het budget hangt er niet van af
cli-warning-contacts-left = de cyclus heeft { $used } van de { $count } meetpunten gebruikt
cli-warning-not-in-csv = CSV heeft geen plaats voor { $options }: HTML, JSON en PDF wel
cli-warning-notes-not-in-csv = { $count ->
    [one] { $count } opmerking staat niet in de CSV: in HTML en JSON wel
   *[other] { $count } opmerkingen staan niet in de CSV: in HTML en JSON wel
}
cli-warning-no-tool-monitored = de gereedschapstabel wordt niet gebruikt: Q330 noemt geen gereedschap
cli-warning-log-unknown = er wordt geen meetprotocol geschreven: dat van cyclus { $code } is niet bekend
cli-warning-limits-alone = hier beslissen alleen de grensmaten: de beslisregel en de temperatuur gelden alleen voor diameters
cli-warning-log-off = er wordt geen meetprotocol geschreven: Q281 = 0
cli-warning-log-none = er wordt geen meetprotocol geschreven: de cyclus heeft er geen
cli-warning-log-on-screen = er wordt geen meetprotocol geschreven: Q281 = 2 toont het op het scherm

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
        [0] alle komen overeen met ISO 286
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
cli-verify-own = { $table }; niet vergeleken, geen klassen van ISO 286: { $own }

## Start
start-missing = bestand bestaat niet: { $path }; noem een bestaand bestand om het in het venster te openen, of een subopdracht
start-folder = dit is een map, geen bestand: { $path }; alleen bestanden gaan open in het venster

## What was recorded
cli-recorded-entry = vastgelegd als vermelding { $number } van { $file } (hash { $hash })
cli-recorded-entries = vastgelegd als vermeldingen { $first } tot en met { $last } van { $file } (hash van de laatste { $hash })
cli-recorded-nothing = er is niets beoordeeld, dus er is niets vastgelegd
cli-recorded-without = { $rows ->
    [one] 1 rij is niet vastgelegd
   *[other] { $rows } rijen zijn niet vastgelegd
}: { $places }
cli-not-recorded = er is niets vastgelegd: { $error }
cli-journal-is-server = hiervoor is het logboekbestand van een station nodig: een server ontvangt alleen wat stations hebben vastgelegd
cli-no-shop = dit programma is gebouwd zonder ondersteuning voor een werkplaatsserver: noem een bestand als logboek
cli-recorded-not-sent = nog niet naar de server verzonden: { $error }; wat is vastgelegd blijft hier bewaard, en fitcheck journal send verzendt het
cli-no-journal-folder = dit systeem heeft geen map voor eigen gegevens: noem een logboek met --journal FILE
cli-no-entry = in { $path } is geen vermelding { $number }: de laatste is { $last }
cli-no-check = vermelding { $number } is geen controle
cli-no-hash = geen vermelding van { $path } heeft een hash die begint met { $prefix }
cli-several-hashes = de hash van meerdere vermeldingen begint met { $prefix }: { $numbers }. Geef meer tekens of het nummer
cli-record-needs-file = --record noemt het bestand dat is geschreven, en de standaarduitvoer is er geen: geef -o FILE op
cli-report-not-known = { $file } is geschreven, maar het logboek kent het niet: { $error }
cli-already-corrected-by = vermelding { $number } is al gecorrigeerd of ingetrokken door vermelding { $by }: corrigeer die, tenzij het een intrekking is
cli-not-typed = de waarde van vermelding { $number } is niet getypt: meet opnieuw, of trek de controle in
cli-nothing-corrected = een correctie moet iets veranderen: geef --measured, --who, --part, --serial, --feature-name, --remark of --withdraw
cli-remark-sent = { $entries ->
    [0] er was niets te sturen
    [one] 1 vermelding is gestuurd
   *[other] { $entries } vermeldingen zijn gestuurd
} naar { $server }, die dit logboek heeft tot en met vermelding { $number }
cli-remark-nothing-found = geen controle voldoet aan { $question }
cli-remark-unread = { $entries ->
    [one] 1 vermelding is
   *[other] { $entries } vermeldingen zijn
} overgeslagen: deze versie kan { $entries ->
    [one] die
   *[other] ze
} niet lezen
cli-head-without-chain = een server heeft meerdere ketens: geef --head CHAIN:NUMBER:HASH
cli-head-of-other = dit logboek is de keten { $chain }, maar --head noemt { $other }
cli-remark-plan-has = { $count ->
    [one] { $count } element
   *[other] { $count } elementen
}
cli-remark-plan-example = geen passing opgegeven: het plan heeft één element als voorbeeld
cli-remark-plan-to-fill = het plan is geschreven voor zover bekend; fouten om erin te verbeteren: { $count }
cli-remark-no-columns = het bestand wordt volgens zijn eigen formaat gelezen en heeft geen kolommen om te kiezen
cli-remark-plan-head-left = CSV heeft alleen de elementen: { $keys } van het onderdeel blijft weg
cli-warning-neither-stands = vermelding { $number } corrigeerde vermelding { $target }: nu telt geen van beide. Klopt een van de waarden, leg die dan opnieuw vast
cli-warning-beyond-limits = buiten de grenzen: door de regel aanvaard, want niet bewezen dat het erbuiten ligt
cli-warning-plan-missing = niet gemeten: { $names }
cli-warning-plan-missing-of = { $who }: niet gemeten: { $names }
cli-warning-contradiction = { $name } heeft waarden die elkaar tegenspreken: { $values }
cli-warning-contradiction-of = { $who }: { $name } heeft waarden die elkaar tegenspreken: { $values }
cli-warning-worst-counts = van waarden die elkaar tegenspreken telt de slechtste tot er gekozen is: --repeats last of --repeats worst. Serienummers houden onderdelen uit elkaar, en een tijd bij elke waarde laat zien welke de laatste is
cli-warning-plan-more-parts = meer dan { $most } onderdelen: ontbrekende elementen van de andere worden niet gemeld
cli-warning-plan-no-value = ontbreekt: er is geen waarde voor gevonden
cli-warning-plan-no-value-of = dit ontbreekt bij { $who }: er is geen waarde voor gevonden
cli-remark-watching = { $folder } wordt bewaakt; eerder geïmporteerde bestanden: { $known }
cli-warning-see-note = niet alles was bruikbaar: het bestand ernaast dat eindigt op { $note } geeft de redenen
cli-not-seconds = { $given } is geen tijd in seconden
cli-warning-same-content = dezelfde inhoud is eerder geïmporteerd als { $known }: er wordt niets opnieuw vastgelegd
cli-warning-not-alone = het is niet bekend of een ander programma deze map voor hetzelfde logboek bewaakt: { $reason }

## De tijdzone van deze computer
zone-not-understood = TZ staat op "{ $given }", en dat is geen tijdzone: geef een naam als Europe/Amsterdam of UTC, of verwijder de variabele
zone-unknown = de tijdzone van deze computer is niet bekend, dus zijn tijden in UTC: zet TZ op een naam als Europe/Amsterdam

# De doctor
doctor-program = Fitcheck { $version }
doctor-zone = { $zone }, het is { $time }
doctor-clock = niet vóór de nieuwste vermelding van het logboek
doctor-clock-behind = vóór de nieuwste vermelding van { $path }, geschreven om { $newest }: zet de klok van deze computer goed
doctor-folder = { $path }: bestanden kunnen worden geschreven
doctor-journal = { $path }: vermeldingen { $entries }
doctor-no-journal = { $path } is er nog niet: de eerste vastgelegde controle maakt het aan
doctor-server = { $address } antwoordt
doctor-no-server = geen server ingesteld: noem hem met --journal postgres://…, of in het venster onder Instellingen
doctor-gauges = poorten van deze computer: { $ports }
doctor-no-port = deze computer heeft geen seriële poort: sluit het meetmiddel of de kabel aan
doctor-gauge-gone = { $gauge }: poort { $port } is er niet: sluit het meetmiddel aan, of kies in het venster onder Instellingen een andere poort
doctor-no-gauges = dit programma is gebouwd zonder poorten voor meetmiddelen: de pakketten hebben ze
doctor-ports-not-listed = de poorten van deze computer kunnen niet worden opgesomd: { $reason }
doctor-tables = { $path }: tabellen { $count }
doctor-no-tables = geen eigen tabellen: ISO 286 en de tabellen van de besturing zijn ingebouwd
doctor-settings = wat het venster bewaart, is leesbaar
doctor-window = getekend met { $renderer }
doctor-no-window = dit programma is gebouwd zonder het venster
