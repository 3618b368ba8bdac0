# Het venster: opschriften, knoppen, koppen.

page-check = Controle
page-fit = Passingen
page-tables = Tabellen
import = Importeren…
export = Exporteren
export-people = Meetrapport ({ $format })…
export-programs = Geschiedenis als { $format }…
export-status-check = Statusvenster van Controle als tekst…
export-status-cycle = Statusvenster van cyclus { $cycle } als tekst…
export-status-program = Venster van het programma als tekst…
menu = Menu
language = Taal
theme = Weergave
theme-system = Systeem volgen
theme-light = Licht
theme-dark = Donker
theme-contrast = Hoog contrast op wit
theme-inverted = Hoog contrast op zwart
density = Grootte van de bediening
density-by-use = Automatisch
density-mouse = Muis
density-touch = Aanraking
limits-from = Grensmaten uit
standard-js-rounded = Halve micrometers van JS naar beneden afronden, zoals in 1988
standard-1988 = cd, ef, fg alleen tot 10 mm, zoals in 1988
load-tables = Eigen tabellen…
no-own-tables = Eigen tabellen niet meer gebruiken
load-mask = Eigen masker…
undo = Ongedaan maken
undo-what = Ongedaan maken: { $what }
undo-add = { $count ->
    [one] 1 controle toevoegen
   *[other] { $count } controles toevoegen
}
undo-correct = correctie
undo-feature = boring of as
undo-clear = geschiedenis wissen
undone = Ongedaan gemaakt: { $what }
clear-history = Geschiedenis wissen
choose-bad = { $count ->
    [0] Niet goede controles kiezen
    [one] 1 niet goede controle kiezen
   *[other] { $count } niet goede controles kiezen
}
choose-none = Niets kiezen

callout = Passing
callout-hint = Typ een nominale maat en een klasse, bijvoorbeeld 25 H7
feature-hole = Boring
feature-shaft = As
feature-neither = Geen van beide
nominal-is = nominale maat { $nominal } mm
maximum = Maximum
minimum = Minimum
from-source = uit { $source }
source-overrides = Eigen tabel: ISO 286 heeft { $upper } / { $lower } µm, dus een verschil van { $by-upper } / { $by-lower } µm
measured-value = Gemeten waarde
measured-once = Al beoordeeld. Typ de waarde opnieuw of gebruik de knop om dezelfde waarde nog eens te beoordelen
by-typing = Typen
by-simulating = Simuleren
judge = Beoordelen
measure = Meten
clear = Wissen
nominal-size = Nominale maat
tolerance-class = Klasse
class-none = Kiezen
classes-hole = Klassen voor boringen
classes-shaft = Klassen voor assen
part-section = Onderdeel
part-name = Onderdeel of element

probe-position = Tastpositie
centre-x = Midden X
centre-y = Midden Y
height-z = Hoogte Z
first-contact = Eerste meetpunt
clearance = Veiligheidsafstand
centre-tolerance = Tolerantie midden ±
simulated-workpiece = Gesimuleerd werkstuk
simulated-hint = Zonder diameter geldt het midden van het tolerantieveld. Het startgetal loopt na elke meting op; hetzelfde startgetal geeft dezelfde meetpunten.
true-diameter = Werkelijke diameter
seed = Startgetal
offset-x = Verschuiving X
offset-y = Verschuiving Y
ovality = Ovaliteit
lobes = Lobben
lobe-height = Lobhoogte
surface-scatter = Spreiding oppervlak 1σ
probe-scatter = Spreiding tastsysteem 1σ

field-range = { $given } ligt buiten −{ $limit } tot { $limit }
field-not-negative = { $given } is kleiner dan 0: toegestaan is 0 tot { $limit }
field-above-zero = { $given } is niet groter dan 0: toegestaan is tot { $limit }
field-not-whole = { $given } is geen geheel getal

limit-band = Grensband
band-example = een voorbeeld: { $callout }, een boring
band-empty = De grensband verschijnt met de grensmaten
band-describe = Afwijking van de nominale maat in micrometer: tolerantieveld van { $lower } tot { $upper }, { $left } daaronder, { $right } daarboven.
band-describe-measured = Gemeten { $deviation }, { $above } boven het minimum, { $below } onder het maximum.
side-rework = nabewerking
side-scrap = afgekeurd
side-out = buiten grenzen

last-values = Laatste waarden
last-values-empty = Hier verschijnen de laatste waarden bij deze grensmaten
last-values-describe = { $count ->
    [one] De laatste waarde, nieuwste achteraan:
   *[other] De laatste { $count } waarden, nieuwste achteraan:
}
contacts = Meetpunten
contacts-factor = afwijkingen × { $factor }
contacts-empty = De meetpunten verschijnen met de meting
contacts-describe = { $count } meetpunten van boven gezien, afwijkingen { $factor } keer vergroot. { $circle }
centre-is = midden { $x } / { $y }

word-none = Geen resultaat
nothing-measured = Er is niets gemeten
judged-without-own = Beoordeeld zonder de eigen tabellen
word-question = Klopt dit?
simulated = GESIMULEERD
status-simulated = { simulated } { $status }
judge-anyway = { $measured } mm toch beoordelen
take-meant = { $meant } mm gebruiken
take-text = { $meant } gebruiken
keep-text = { $given } toch zo gebruiken
doubted-enter = Enter gebruikt de gekleurde knop; typen vervangt de tekst
doubted-type = Er wordt niets beoordeeld tot de tekst opnieuw getypt of zo gebruikt wordt
question-enter = Na een halve seconde drukt Enter op de gevulde knop; typen vervangt de waarde
doubt-sentence = De { $doubt }
lot-title = { $rows ->
    [one] { $name }: 1 rij
   *[other] { $name }: { $rows } rijen
}
lot-unjudged = { $count } niet beoordeeld
lot-refused = { $count ->
    [one] 1 rij geweigerd
   *[other] { $count } rijen geweigerd
}
lot-doubted = { $count ->
    [one] 1 twijfelachtige waarde
   *[other] { $count } twijfelachtige waarden
}
lot-shown = Getoond: { $place } van { $judged }, slechtste eerst; regel { $line }
lot-shown-part = Getoond: { $place } van { $judged }, slechtste eerst; regel { $line }, onderdeel { $part }
lot-worst = Slechtste
lot-worse = Slechter
lot-better = Beter
lot-best = Beste
lot-count = { $status } { $count }
above-minimum = { $um } µm boven minimum
below-minimum = { $um } µm onder minimum
below-maximum = { $um } µm onder maximum
above-maximum = { $um } µm boven maximum
remove-amount = { $um } µm verspanen
remove-to-limit = tot de grensmaat
remove-to-limit-per-side = tot de grensmaat, { $um } µm per zijde
remove-to-middle = { $um } µm tot het midden
position-in = Midden in positie
position-out = Midden buiten positie
diameter-alone = Alleen de diameter: { $status }
first-steps = Eerste stappen
first-steps-title = Voor het eerst hier?
first-steps-about = Deze instellingen blijven bewaard.
first-steps-done = Klaar
first-way-part = Een heel onderdeel
first-way-part-about = Maat voor maat, volgens een plan met een afbeelding.
first-way-file = Een bestand met gemeten waarden
first-way-file-about = CSV, een werkmap, QIF, AQDEF of een meetprotocol.
first-way-program = Zonder machine
first-way-program-about = Een NC-programma of een cyclus meet een gesimuleerde boring, meetpunt voor meetpunt.
first-step-callout = 1. Passing: wat de tekening zegt
first-step-value = 2. Gemeten waarde: getypt, gesimuleerd of uit een bestand
first-step-verdict = 3. Oordeel, en hoeveel eraf moet
why = Waarom?
why-limits = Grensmaten uit { $what }
why-measured = Gemeten waarde: { $what }
why-rule = Regel: { $what }
why-caveat = Beperking van deze meting: { $what }

popup-title = Statusvenster
popup-title-accepted = Statusvenster: buiten de grenzen, door de regel aanvaard
popup-title-simulated = Statusvenster, GESIMULEERD
popup-exact = Het venster rondt af op vier decimalen. Exacte waarden: { $values }
popup-empty = Nog geen meting
copy = Kopiëren
mask-choice = Masker
mask-choice-of-language = Taal van het venster
mask-choice-own = Eigen masker…

history = Geschiedenis
history-count = { $count ->
    [0] geen controles
    [one] 1 controle
   *[other] { $count } controles
}
history-chosen = { $count } gekozen voor export
history-hidden = waarvan { $hidden } niet getoond
history-shown = { $shown } van { $count ->
    [one] 1 controle
   *[other] { $count } controles
}
history-exported-listed = { $count ->
    [0] Er is geen controle getoond: niets te exporteren
    [one] De ene getoonde controle van { $all } wordt geëxporteerd
   *[other] De { $count } getoonde controles van { $all } worden geëxporteerd
}
rows-exported = De { $listed } getoonde rijen van { $name } worden geëxporteerd, in de volgorde van de lijst
rows-export-not-yet = De rijen kunnen worden geëxporteerd zodra ze allemaal beoordeeld en getoond zijn
history-exported = { $count ->
    [0] Niets te exporteren
    [one] 1 controle wordt geëxporteerd
   *[other] Alle { $count } controles worden geëxporteerd
}
history-cleared = { $count ->
    [one] 1 controle uit de geschiedenis verwijderd. Met Ongedaan maken (Ctrl+Z) komt die terug.
   *[other] { $count } controles uit de geschiedenis verwijderd. Met Ongedaan maken (Ctrl+Z) komen ze terug.
}
history-none-found = Geen controle voldoet aan het filter
history-filter = Filter
history-filter-hint = Toont de controles waarin deze woorden staan: onderdeel, passing, waarde, datum, status of bestand
history-only-bad = Alleen niet goed
history-only-bad-hint = Nabewerking, opnieuw meten en afgekeurd
history-sort-hint = Sorteert op deze kolom; nogmaals keert de volgorde om, daarna de nieuwste bovenaan
history-ascending = { $column }, oplopend gesorteerd
history-descending = { $column }, aflopend gesorteerd
history-list = Controles in de geschiedenis
history-row = { $time }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-part = { $time }, { $part }, { $callout }, { $measured } mm, { $deviation }, { $status }, { $from }
history-row-chosen = { $row }, gekozen voor export
history-move = Naar een andere controle
history-show = Controle tonen
history-choose = Kiezen voor export
choose-all = Alle getoonde kiezen
copy-checks = Kopiëren voor een spreadsheet
history-empty = Hier verschijnen de controles, de nieuwste bovenaan
head-time = Datum en tijd
head-part = Onderdeel
head-callout = Passing
head-measured = Gemeten
head-deviation = Afwijking
head-status = Status
head-from = Herkomst
choose-check = { $check } van { $time } kiezen voor export

dialog-import = Metingen importeren
dialog-mask = Eigen masker
dialog-tables = Map met eigen tabellen
dialog-export = Exporteren
dialog-export-rows = Getoonde rijen exporteren
dialog-export-status = Statusvenster exporteren
file-path = Bestand
folder-path = Map
dialog-open = Openen
dialog-save = Opslaan
dialog-browse = Bladeren…
dialog-cancel = Annuleren
dialog-busy = Bezig…
dialog-no-path = Er ontbreekt een pad
dialog-no-status = Geen statusvenster om op te slaan
dialog-browse-hint = Toont het bestandsvenster van het systeem
dialog-up = Bovenliggende map
dialog-home = Persoonlijke map
dialog-all-files = Alle bestanden
file-kind-measurements = Metingen
file-kind-mask = Maskers
file-kind-own-tables = Mappen met tabellen
file-kind-report = Rapporten
file-kind-rows = Rijen
file-kind-status = Tekst
file-kind-table = Tabellen
file-kind-contacts = Meetpunten
file-kind-workpiece = Gesimuleerde werkstukken
file-kind-probes = Tastsysteemtabellen
file-kind-log = Meetprotocollen
file-kind-program = NC-programma's
file-kind-part = Gesimuleerde onderdelen
file-kind-set = Bestanden voor een besturing
file-kind-tools = Gereedschapstabellen
file-kind-plan = Onderdeelplannen
file-kind-picture = Afbeeldingen
file-kind-watched = Bewaakte mappen
file-kind-budget = Onzekerheidsbudgetten
file-kind-chart = Regelkaarten
file-kind-readings = Aflezingen
file-kind-study = Aflezingen van een meetmiddel
dialog-move = Naar een ander item gaan
dialog-recent-folders = Recente mappen
dialog-exists = { $name } bestaat al. Vervangen?
dialog-exists-set = { $name } bestaat al in deze map. De bestanden van de set daar vervangen?
dialog-replace = Vervangen
dialog-keep = Behouden
dialog-nothing-picked = Het bestandsvenster van het systeem heeft geen bestand opgeleverd. Kies er een in de lijst of typ een pad.
dialog-list = Map { $folder }
dialog-entries = Bestanden en mappen
dialog-list-none = Er is geen map geopend: typ een pad
dialog-list-reading = De map wordt gelezen…
dialog-list-empty = Er is niets te kiezen in deze map
dialog-list-more = Alleen de eerste { $most } items worden getoond: typ de naam van een ander item
dialog-is-folder = Map
file-name-checks = controles
open-written = Openen
show-in-folder = Tonen in map
launch-failed = het bestand kan niet worden geopend: { $reason }
recent-files = Recente bestanden
forget-recent = Lijst wissen
recent-file = { $name } · { $what } · { $folder }
dialog-list-left-out = { $count ->
    [one] 1 item wordt niet getoond
   *[other] { $count } items worden niet getoond
}
file-bytes = { $count } B
file-kilobytes = { $count } kB
file-megabytes = { $count } MB
notice = Melding
copied = { $lines ->
    [one] Gekopieerd, één regel
   *[other] Gekopieerd, { $lines } regels
    }
notice-problem = Fout
notice-more = { $count ->
    [one] Er volgt nog 1 melding
   *[other] Er volgen nog { $count } meldingen
}
messages = Eerdere meldingen
messages-forget = Lijst leegmaken
messages-count = { $count ->
    [one] 1 eerdere melding
   *[other] { $count } eerdere meldingen
}
close = Sluiten
file-written = { $name } is geschreven in { $folder }
file-written-here = { $name } is geschreven
tables-loaded = { $count ->
    [one] 1 tabel wordt gebruikt uit { $folder }
   *[other] { $count } tabellen worden gebruikt uit { $folder }
}
mask-loaded-with-warnings = { $name } is gelezen met waarschuwingen
state-set-aside = De bewaarde toestand kon niet worden gelezen. Het bestand is bewaard als { $path }, en het venster begint met de standaardinstellingen.
state-set-aside-now = De bewaarde toestand kan niet meer worden gelezen. Het bestand is bewaard als { $path }, en de toestand van dit venster wordt op zijn plaats opgeslagen.
state-not-kept = De toestand van dit venster wordt niet bewaard: { $reason }
import-contacts-not-judged = De meetpunten in { $name } zijn niet beoordeeld
import-notice = { $name }: { $good ->
    [0] geen controle
    [one] 1 controle
   *[other] { $good } controles
}, { $bad ->
    [0] geen rij geweigerd
    [one] 1 rij geweigerd
   *[other] { $bad } rijen geweigerd
}
import-counted = { $file }. { $counts }
check-said-afterwards = na het oordeel gezegd: { $as }
lot-open = { $count ->
    [one] Eén waarde wacht op boring of as:
   *[other] { $count } waarden wachten op boring of as:
}
check-all-holes = Alle zijn boringen
check-all-shafts = Alle zijn assen
check-judged-again = { $count ->
    [one] Eén waarde buiten zijn grenzen is opnieuw beoordeeld: { $as }
   *[other] { $count } waarden buiten hun grenzen zijn opnieuw beoordeeld: { $as }
}
import-counts = { $is-good } { $good }, { $is-rework } { $rework }{ $again ->
    [0] { "" }
   *[other] , { $is-again } { $again }
}{ $out ->
    [0] { "" }
   *[other] , { $is-out } { $out }
}, { $is-scrap } { $scrap }
notice-show = Tonen
notice-open-in = Openen op de pagina { $page }
judge-unplanned = Openen op de pagina Controle
sample-not-recorded = Een voorbeeld wordt niet vastgelegd.
limits-own-first = Eerst uit eigen tabellen: { $names }
limits-own-stay = Eigen tabellen gaan nog steeds voor: { $names }. Met Menu, Grensmaten uit, worden ze niet meer gebruikt.
measured-needs-value = Typ de gemeten waarde
measured-needs-limits = Geen grensmaten om aan te toetsen: typ eerst een passing

keypad = Toetsenblok
key = Toets
key-blank = Spatie
key-decimal = Decimaalteken
key-minus = Min
edge-left = Rand van het linkerpaneel: verplaatsen met de pijltjestoetsen
edge-right = Rand van het rechterpaneel: verplaatsen met de pijltjestoetsen
edge-top = Rand van het bovenste paneel: verplaatsen met de pijltjestoetsen
edge-bottom = Rand van het onderste paneel: verplaatsen met de pijltjestoetsen
key-letters = Letters
key-holes = Klassen van boringen
key-shafts = Klassen van assen
key-more-letters = M tot X
key-signs = Y, Z en tekens
key-figures = Cijfers
key-shift = Hoofdletters of kleine letters
key-back = Laatste teken wissen
key-clear = Leegmaken
key-enter = Enter

## Table page
tables-choice = Tabel
tables-kind-shipped = ingebouwd
tables-kind-own = eigen
tables-kind-file = uit een bestand
tables-kind-copy = kopie
tables-kind-made = uit ISO 286
tables-unsaved = niet opgeslagen
tables-open = Openen…
tables-save = Opslaan als
tables-redo = Opnieuw
tables-use = Voor grensmaten gebruiken
tables-in-use = Gebruikt voor grensmaten
tables-filter = Filter
tables-filter-hint = Klassen zoals H7 g6, letters, graden of een maat in mm
tables-shown = { $count ->
    [one] { $shown } van 1 klasse
   *[other] { $shown } van { $count } klassen
}
tables-only-differences = Alleen verschillen
tables-unmatched = niets gevonden voor { $words }
tables-agrees = { $count ->
    [one] de enige cel komt overeen met ISO 286
   *[other] alle { $count } cellen komen overeen met ISO 286
}
tables-differs = { $count ->
    [one] 1 van { $compared } cellen wijkt af van ISO 286
   *[other] { $count } van { $compared } cellen wijken af van ISO 286
}
tables-compared-nothing = niets om met ISO 286 te vergelijken
tables-own-classes = { $count ->
    [one] 1 eigen klasse
   *[other] { $count } eigen klassen
}
tables-own-class = eigen
tables-previous = Vorig verschil
tables-next = Volgend verschil
tables-not-saved = Wijzigingen zijn niet opgeslagen
tables-keys = Pijltjestoetsen verplaatsen, Enter wijzigt, Delete maakt leeg, F8 gaat naar het volgende verschil, Ctrl+F naar het filter
tables-move = Naar een andere cel
tables-edit-cell = Cel wijzigen
tables-grid = Afwijkingen van { $name } in µm
tables-range-head = boven – t/m, mm
tables-pair = { $upper } / { $lower } µm
tables-no-value = leeg
tables-cell = { $class }, boven { $over } tot en met { $to } mm, { $figures }
tables-cell-differs = { $class }, boven { $over } tot en met { $to } mm, { $figures }, wijkt af van ISO 286
tables-no-columns = De tabel heeft geen klasse
tables-upper = Boven
tables-lower = Onder
tables-head-table = Tabel, µm
tables-head-standard = ISO 286
tables-head-by = Verschil
tables-cell-agrees = Zoals in ISO 286
tables-cell-off = ISO 286 heeft { $upper } / { $lower } µm; de tabel wijkt { $upper-by } / { $lower-by } µm af
tables-more-differences = en nog { $count }
tables-cell-missing = Hier leeg; ISO 286 heeft { $upper } / { $lower } µm
tables-cell-empty = Hier leeg, en in ISO 286 niet gedefinieerd
tables-defined = In ISO 286 is de klasse { $ranges } gedefinieerd
tables-shipped-hint = Een ingebouwde tabel blijft ongewijzigd: bij een wijziging ontstaat een kopie, en die wordt getoond.
tables-set = Invullen
tables-take-standard = ISO 286 overnemen
tables-empty-cell = Leegmaken
tables-remove-column = { $class } verwijderen
tables-from-standard = Uit ISO 286
tables-classes = Klassen, zoals H7 K7 P9
tables-add-columns = Aan deze tabel toevoegen
tables-up-to = Maten tot en met
tables-make = Nieuwe tabel
tables-order = bovenafwijking { $upper } µm ligt onder onderafwijking { $lower } µm
tables-used-edited = { $name } geeft de grensmaten: controles gebruiken de wijziging vanaf nu
tables-used = Grensmaten komen eerst uit { $name }, tot het venster wordt gesloten. Sla de tabel op in de map met eigen tabellen om die te blijven gebruiken.
tables-read-with-warnings = { $name } is gelezen met waarschuwingen
tables-nothing-read = Het bestand bevat geen tabel met afwijkingen
tables-nothing-to-save = Er is geen tabel open
tables-cell-unreadable = De waarden van de gekozen cel zijn onleesbaar: corrigeer ze eerst
tables-too-many = { $count } tabellen met niet-opgeslagen wijzigingen zijn open: sla er eerst een op
tables-dialog-open = Tabel openen
tables-dialog-save = Tabel opslaan
## Fit page
fit-callout = Passing van boring en as
fit-callout-hint = Typ een nominale maat en beide klassen, bijvoorbeeld 25 H7/g6
fit-example = een voorbeeld: { $callout }
fit-shaft-missing = De klasse van de as ontbreekt, bijvoorbeeld g6 in 25 H7/g6
fit-hole-missing = De klasse van de boring ontbreekt, bijvoorbeeld H7 in 25 H7/g6
fit-classes-missing = Een passing heeft de klassen van boring en as, bijvoorbeeld 25 H7/g6
fit-preferred = Voorkeurspassing
fit-function = Functie
fit-list-hole-basis = Eenheidsboring
fit-list-shaft-basis = Eenheidsas
fit-parts = Gemeten onderdelen
fit-hole-measured = Gemeten boring
fit-shaft-measured = Gemeten as
fit-temperature = Temperatuur
fit-hole-material = Materiaal boring
fit-hole-expansion = Boring, µm/(m K)
fit-shaft-material = Materiaal as
fit-shaft-expansion = As, µm/(m K)
fit-own-value = Eigen waarde
fit-press = Perspassing
fit-press-length = Voeglengte
fit-hub-outer = Naaf buiten
fit-shaft-bore = Asboring
fit-press-material = Een perspassing heeft voor beide delen een materiaal van de lijst nodig: kies er een
fit-press-pressure = Voegdruk
fit-press-force = Houdt axiaal
fit-press-torque = Houdt als koppel
fit-press-pressing = Perskracht
fit-press-hub = Naaf: spanning / vloeigrens
fit-press-shaft = As: spanning / vloeigrens
fit-press-heat = Naaf verwarmen tot
fit-press-cool = Of as koelen tot
fit-press-friction = Wrijving { $friction }; elastisch, bij 20 °C en in rust. Axiale kracht en koppel gelden niet tegelijk
fit-search = Zoeken op speling
fit-wanted-minimum = Minimum
fit-wanted-maximum = Maximum
fit-scope = In
fit-scope-all = Alle klassen
fit-scope-basis = Eenheidsboring en eenheidsas
fit-scope-preferred = Voorkeurs- en benoemde passingen
fit-search-hint = De kleinste en de grootste speling; een negatieve waarde is een overmaat. Een eenheid mag erbij: 7 µm
fit-search-size = Voor het zoeken is een nominale maat nodig: typ die hierboven
fit-found = { $count ->
    [one] 1 passing
   *[other] { $count } passingen
}
fit-found-first = de beste { $count } staan in de lijst
fit-found-none = Geen passing voldoet. De dichtstbijzijnde
fit-missed-by = { $below } µm te weinig, { $above } µm te veel
fit-is-preferred = voorkeur

fit-picture = Tolerantievelden van boring en as
fit-picture-legend = µm vanaf de nullijn; fundamentele afwijking vet
fit-picture-empty = De tolerantievelden verschijnen met de passing
fit-arrow-clearance = Werkelijke speling
fit-arrow-interference = Werkelijke overmaat
fit-describe-zero = Nullijn op { $nominal } mm.
fit-describe-zone = { $part } { $class } van { $lower } tot { $upper } µm.
fit-describe-fundamental = Fundamentele afwijking { $deviation } µm.
fit-describe-measured = { $part } gemeten op { $deviation } µm.
fit-classes = Klassen bij { $nominal } mm
fit-classes-none = Klassen
fit-classes-empty = De klassen verschijnen met een nominale maat
fit-classes-nowhere = Bij deze maat is geen klasse gedefinieerd
fit-staircase = Tolerantievelden van graad { $grade }

fit-word-clearance = Spelingpassing
fit-word-transition = Overgangspassing
fit-word-interference = Perspassing
fit-word-none = Nog geen passing
fit-maximum-clearance = Grootste speling
fit-minimum-clearance = Kleinste speling
fit-maximum-interference = Grootste overmaat
fit-minimum-interference = Kleinste overmaat
fit-mean-clearance = Gemiddelde speling
fit-mean-interference = Gemiddelde overmaat
fit-ansi = ANSI B4.2: { $name }
fit-equivalent = Gelijkwaardige passing
fit-equivalent-same = Precies dezelfde spelingen
fit-equivalent-differs = Niet dezelfde: kleinste speling { $minimum } µm, grootste { $maximum } µm
fit-check-hole = Boring controleren
fit-check-shaft = As controleren
fit-move = Naar een andere klasse
fit-actual-clearance = Speling { $um } µm
fit-actual-interference = Overmaat { $um } µm
fit-conforms = Binnen de grensmaten van de passing
fit-conforms-not = Buiten de grensmaten van de passing
fit-with-good-shaft = Speling met een goede as
fit-with-good-hole = Speling met een goede boring
fit-at-temperature = Bij { $degrees } °C
fit-temperature-change = de speling verandert met { $um } µm
fit-these-parts = Deze onderdelen: { $clearance }

## Own materials
materials-refused = De eigen materialen kunnen niet worden gebruikt: { $path }, { $reason }

## Palette
section-said = { $name }: { $value }
crash-report = Het venster is door een fout in het programma geëindigd. Een verslag ervan, zonder gemeten waarden, staat in { $path }
rail-more = Meer
top-open = { $name } is geopend
top-undo = Laatste wijziging ongedaan maken
top-recorded = Vastgelegd, { $number }
top-recording = Wordt vastgelegd
top-not-recorded = Niet vastgelegd
palette = Zoeken of iets doen
palette-do = Doen
palette-open = Openen
palette-settings = Instellingen en hulp
palette-records = Logboek
palette-fit = Passing { $fit }
palette-in-tables = { $what } in de tabellen
palette-uncertainty = Onzekerheid bij { $size } mm
palette-records-of = { $what } in het logboek
palette-show-setting = Tonen op de instellingenpagina
palette-more = Wat kan hier nog meer mee
palette-back = Terug naar wat gevonden is
palette-check-value = { $callout } controleren met { $value }
palette-check = { $callout } controleren
palette-search-manual = De handleiding doorzoeken op “{ $query }”
palette-nothing = Niets heet zo
palette-hint = Een passing, een pagina, een opdracht of een bestand

## Leaving
leave = Fitcheck afsluiten?
discard = De wijzigingen weggooien?
discard-unsaved = { $name } heeft niet-opgeslagen wijzigingen.
discard-no = Verder bewerken
discard-yes = Wijzigingen weggooien
leave-unsaved = Niet opgeslagen: { $names }
leave-stay = Verder werken
leave-anyway = Afsluiten zonder opslaan

## Cycle pictures
cycle-picture-centre-1 = nominaal midden in de eerste as
cycle-picture-centre-2 = nominaal midden in de tweede as
cycle-picture-centre-tolerance-1 = toegestane afwijking van het midden in de eerste as, naar beide kanten; 0 bewaakt niets
cycle-picture-centre-tolerance-2 = toegestane afwijking van het midden in de tweede as, naar beide kanten; 0 bewaakt niets
cycle-picture-side-length-1 = nominale lengte van de rechthoek langs de eerste as
cycle-picture-side-length-2 = nominale lengte van de rechthoek langs de tweede as
cycle-picture-maximum-side-1 = grootste toegestane lengte langs de eerste as
cycle-picture-maximum-side-2 = grootste toegestane lengte langs de tweede as
cycle-picture-minimum-side-1 = kleinste toegestane lengte langs de eerste as
cycle-picture-minimum-side-2 = kleinste toegestane lengte langs de tweede as
cycle-picture-width = nominale breedte, van wand tot wand
cycle-picture-maximum-width = grootste toegestane breedte
cycle-picture-minimum-width = kleinste toegestane breedte
cycle-picture-start-1 = punt in de sleuf waar het tastsysteem begint, eerste as
cycle-picture-start-2 = punt in de sleuf waar het tastsysteem begint, tweede as
cycle-picture-shift = verschuiving van het tweede meetpunt langs de wanden; bij 0 ligt het tegenover het eerste
cycle-picture-first-point-1 = eerste punt, op de wand aan de pluskant: eerste as
cycle-picture-first-point-2 = eerste punt, op de wand aan de pluskant: tweede as
cycle-picture-second-point-1 = tweede punt, op de wand aan de minkant: eerste as
cycle-picture-second-point-2 = tweede punt, op de wand aan de minkant: tweede as
cycle-picture-axis-of-plane = gemeten as: 1 eerste as, 2 tweede as
cycle-picture-diameter = nominale diameter
cycle-picture-maximum-size = grootste toegestane diameter
cycle-picture-minimum-size = kleinste toegestane diameter
cycle-picture-start-diameter = diameter van de cirkel waarop het tastsysteem vóór elke tasting staat
cycle-picture-first-angle = hoek van het eerste meetpunt, gerekend vanaf de eerste as
cycle-picture-step = hoek van meetpunt tot meetpunt; min draait met de klok mee
cycle-picture-arc = hoek waarover de meetpunten verdeeld zijn; 360 is een volle cirkel, min draait met de klok mee
cycle-picture-longest-path = langste tastweg; plus leidt van het midden af, min ernaartoe
cycle-picture-difference = elk meetpunt wordt twee keer getast: grootste toegestane verschil
cycle-picture-measuring-height = hoogte van het midden van de kogel bij het meetpunt
cycle-picture-set-up-clearance = afstand vóór het meetpunt, opgeteld bij SET_UP uit de tastsysteemtabel
cycle-picture-clearance-height = hoogte waarop het tastsysteem vrij kan bewegen
cycle-picture-point-1 = te tasten punt, eerste as
cycle-picture-point-2 = te tasten punt, tweede as
cycle-picture-point-3 = te tasten punt, derde as
cycle-picture-next-point-1 = tweede punt van de lijn, eerste as
cycle-picture-next-point-2 = tweede punt van de lijn, tweede as
cycle-picture-next-point-3 = tweede punt van de lijn, derde as
cycle-picture-second-centre-1 = nominaal midden van de tweede cirkel, eerste as
cycle-picture-second-centre-2 = nominaal midden van de tweede cirkel, tweede as
cycle-picture-second-diameter = nominale diameter van de tweede cirkel
cycle-picture-second-height = hoogte waarop de tweede cirkel wordt getast
cycle-picture-geometries = 0 twee boringen, 1 twee tappen, 2 een boring en een tap, 3 een tap en een boring
cycle-picture-maximum-coordinate = grootste toegestane coördinaat
cycle-picture-minimum-coordinate = kleinste toegestane coördinaat
cycle-picture-normal-1 = component van de oppervlaktenormaal in de eerste as; de normaal wijst uit het materiaal
cycle-picture-normal-2 = component van de oppervlaktenormaal in de tweede as; de normaal wijst uit het materiaal
cycle-picture-normal-3 = component van de oppervlaktenormaal in de derde as; de normaal wijst uit het materiaal
cycle-picture-band = toegestane afwijking langs de normaal: overmaat plus, ondermaat min
cycle-picture-retract = weg terug vanaf het meetpunt, tegen de tastrichting in
cycle-picture-move-to-clearance = weg tussen meetpunten: 0 op meethoogte, 1 over de veilige hoogte
cycle-picture-clearance-mode = veilige hoogte: −1 nooit, 0 voor en na de cyclus, 1 voor en na elk object, 2 bij elk meetpunt
cycle-picture-traverse = weg naar het volgende meetpunt: 0 rechte lijn, 1 boog
cycle-picture-contact-count = aantal meetpunten
cycle-picture-plane = vlak van de cirkel: 0 X/Y, 1 Z/X, 2 Y/Z
cycle-picture-side = 0 tast binnen, 1 buiten
cycle-picture-measured-axis = gemeten as: 1 eerste as, 2 tweede as, 3 tasteras
cycle-picture-direction = tastrichting: −1 tegen de as in, +1 met de as mee
cycle-picture-directed-axis = gemeten as, 1 eerste, 2 tweede, 3 tasteras; min tast tegen de as in
cycle-picture-tool-axis-probing = tasteras: 0 blijft zoals zij is, 1 wordt ook getast en gezet
cycle-picture-tool-axis-point-1 = waar de tasteras wordt getast, eerste as
cycle-picture-tool-axis-point-2 = waar de tasteras wordt getast, tweede as
cycle-picture-tool-axis-point-3 = waar het vlak in de tasteras wordt verwacht
cycle-picture-new-datum-1 = coördinaat die de gemeten plaats in de eerste as krijgt
cycle-picture-new-datum-2 = coördinaat die de gemeten plaats in de tweede as krijgt
cycle-picture-new-datum-3 = coördinaat die de gemeten plaats in de tasteras krijgt
cycle-picture-new-coordinate = coördinaat die de gemeten plaats in de gemeten as krijgt
cycle-picture-table-row = regel van de tabel waarin het referentiepunt komt; bij 0 is het meteen actief
cycle-picture-transfer = tabel: −1 niet opgegeven, 0 nulpunttabel, 1 referentiepunttabel
cycle-picture-preset-correction = 0 laat het actieve referentiepunt zoals het is; een ander getal corrigeert het, zodat dit punt zijn nominale waarde toont
cycle-picture-aligned-angle = hoek waarop de kant wordt uitgelijnd, vanaf de eerste as; 0 legt hem langs de as
cycle-picture-compensation-axis = rotatieas die de kant uitlijnt: 0 de as waarom de hoek is gemeten, 4 A, 5 B, 6 C
cycle-picture-zero-after-alignment = de rotatieas na het uitlijnen: 0 houdt zijn waarde, 1 toont nul
cycle-picture-rotary-alignment = de rotatieassen na het meten: 0 blijven staan, een ander getal draait ze, zodat de lijn is uitgelijnd
cycle-picture-rotation-transfer = de gemeten hoek: 0 verandert niets, 1 wordt de basisrotatie, 2 een verschuiving van de rotatieas
cycle-picture-log = meetprotocol: 0 geen, 1 bestand, 2 op het scherm en het programma stopt
cycle-picture-stop = buiten tolerantie: 0 het programma gaat door, 1 het stopt met een melding
cycle-picture-stop-on-undersize = buiten tolerantie: 0 het programma gaat door, 1 het stopt, 2 het stopt alleen bij ondermaat
cycle-picture-stop-on-scrap = buiten tolerantie: 0 het programma gaat door, 1 het stopt, 2 het stopt alleen bij afkeur
cycle-picture-tool = te bewaken gereedschap, met nummer of naam; 0 is geen
cycle-picture-any-length = { $name } Een lengte
cycle-picture-any-angle = { $name } Een hoek
cycle-picture-any-choice = { $name } Een van { $of }
cycle-picture-any-number = { $name } Een getal
cycle-picture-part = Onderdeel met { $count ->
    [one] één element
   *[other] { $count } elementen
  }: { $names }.
cycle-picture-path = Baan van het tastsysteem, { $step } van { $moves } verplaatsingen gedaan, { $contacts ->
    [one] 1 meetpunt
   *[other] { $contacts } meetpunten
}. Kogel op X { $x }, Y { $y }, Z { $z } mm.
cycle-picture-path-touch = { $phase }, meetpunt { $touch }
cycle-picture-no-path = De baan verschijnt na het uitvoeren van de cyclus
cycle-picture-phase-pre-position = voorpositioneren
cycle-picture-phase-approach = naderen
cycle-picture-phase-contact = tasten
cycle-picture-phase-retract = terugtrekken
cycle-picture-phase-leave = vrijzetten
cycle-picture-from-above = { $first }/{ $second } van boven
cycle-picture-from-side = { $first }/{ $second } van opzij
cycle-picture-contacts = { $count } meetpunten om hun kleinste-kwadratencirkel Ø { $diameter } mm, { $factor }: { $residuals }.
cycle-picture-nominal = Nominale cirkel Ø { $diameter } mm.
cycle-picture-legend-fitted = kleinste kwadraten
cycle-picture-legend-nominal = nominaal
cycle-picture-deviation = afwijking langs de normaal { $deviation } mm, zonder tolerantie
cycle-picture-no-limits = Geen grenzen opgegeven: er is niets vergeleken
cycle-picture-head-criterion = Criterium
cycle-picture-head-centre-1 = Midden, 1e as
cycle-picture-head-centre-2 = Midden, 2e as
cycle-picture-head-diameter = Ø in mm
cycle-picture-head-form = Vorm
cycle-picture-none = —
cycle-picture-least-squares = Kleinste kwadraten
cycle-picture-circumscribed = Kleinste omgeschreven
cycle-picture-inscribed = Grootste ingeschreven
cycle-picture-zone = Minimale zone, rondheid
cycle-picture-two-point = Tweepuntsmaat
cycle-picture-two-point-of = Tweepuntsmaat { $first }–{ $second }
cycle-picture-two-point-least = Kleinste tweepuntsmaat, { $first }–{ $second }
cycle-picture-two-point-most = Grootste tweepuntsmaat, { $first }–{ $second }
cycle-picture-no-opposed = geen twee meetpunten liggen tegenover elkaar
cycle-picture-uncertainty = Spreiding s van een meetpunt geeft { $diameter } s in de diameter, { $against } keer die van 3 meetpunten op 120°, en { $across } s tot { $along } s in het midden

# De bewaarde toestand, en het venster zelf
saved-broken = de bewaarde toestand is onleesbaar: { $reason }
saved-newer = de bewaarde toestand heeft versie { $version }, dit programma ondersteunt versies tot en met { $known }
window-no-display = geen beeldscherm: DISPLAY en WAYLAND_DISPLAY zijn niet ingesteld. Meld aan op een bureaublad, maak verbinding met ssh -X, of gebruik de opdrachtregel, die geen beeldscherm nodig heeft: fitcheck check "25 H7" --measured 25.012; zie fitcheck --help
open-unknown = { $name } is geen bestand dat het venster opent; het opent metingen, meetprotocollen en meetpunten (.csv, .tsv, .txt, .html), NC-programma's (.h), tabellen (.tab), gereedschapstabellen (.t), gesimuleerde werkstukken (.toml), tastsysteemtabellen (.tp) en maskers (.a)
window-not-opened = het venster kan niet worden geopend: { $reason }; de opdrachtregel werkt zonder beeldscherm, zie fitcheck --help

## Rows of a large file

rows = Rijen
rows-cancel = Annuleren
rows-again = Opnieuw beoordelen
rows-close = Bestand sluiten
rows-close-hint = Sluit het grote bestand; de rijen blijven niet bewaard
rows-move = Naar een andere rij
rows-show = Controle van de rij tonen
rows-keep = Aan geschiedenis toevoegen
rows-kept = De controle is aan de geschiedenis toegevoegd
rows-progress = Gelezen deel van het bestand
rows-running = { $count } rijen tot nu toe, { $percent } % van het bestand, { $rate } rijen per seconde
rows-done = { $count } rijen, alle beoordeeld in { $seconds }
rows-seconds = { $seconds } s
rows-less-than = minder dan { $seconds } s
rows-cancelled = ONVOLLEDIG: geannuleerd na { $count } rijen, { $percent } % van het bestand
rows-failed = ONVOLLEDIG na { $count } rijen: { $why }
rows-why-bytes = { $size } MiB, meer dan { $limit } MiB: rij voor rij beoordeeld, en de rijen blijven niet in de geschiedenis
rows-why-packed = Gecomprimeerd: rij voor rij beoordeeld, en de rijen blijven niet in de geschiedenis; de uitgepakte tekst staat in een tijdelijk bestand tot het bestand wordt gesloten
rows-not-judged = NIET BEOORDEELD
rows-fate = { $fate } { $count }
rows-fate-hint = Toont deze rijen; meer dan één keuze is mogelijk
rows-classes = Klassen
rows-all-classes = Alle klassen
rows-no-class = Zonder klasse
rows-some-classes = { $count } klassen
rows-class = { $class }: { $count }
rows-summary = Samenvatting
rows-fate-only = Rijen { $fate } van het grote bestand tonen
rows-filter-hint = Toont de rijen met deze woorden in hun cellen, zoals onderdeel, passing, waarde of status
rows-worst-first = Slechtste eerst
rows-worst-first-hint = Toont afgekeurd vóór nabewerking en goed, met de grootste afwijking van de grenzen bovenaan
rows-worst = Slechtste onderdeel
rows-sifting = Rijen worden doorzocht…
rows-sifts-at-end = Filter en volgorde gelden zodra alle rijen beoordeeld zijn
rows-in-order = slechtste eerst
rows-worst-of-many = de { $most } slechtste daarvan, slechtste eerst
rows-first-of-many = de eerste { $most } daarvan
rows-export = Rijen van het bestand als { $format }, met oordeel…
rows-export-programs = Controles van de getoonde rijen als { $format }…
rows-export-simulated = De eerste regels van het bestand zeggen dat het gesimuleerd is, en alleen CSV kan ze bewaren. Exporteer als CSV
rows-export-twice = Het bestand heeft twee kolommen met de naam { $column }. Exporteer als CSV of TSV; die staan beide toe
rows-report-counts = { $name }: { $count } rijen; { $good } GOED, { $rework } NABEWERKING, { $remeasure } OPNIEUW METEN, { $out } BUITEN GRENZEN, { $scrap } AFGEKEURD, { $unjudged } NIET BEOORDEELD; daarvan { $listed } in dit rapport
rows-report-without = { $count ->
    [one] 1 getoonde rij heeft geen oordeel en geen controle in dit rapport
   *[other] { $count } getoonde rijen hebben geen oordeel en geen controle in dit rapport
}
rows-file-name = { $name }-beoordeeld
rows-not-whole = ONVOLLEDIG: de aantallen zijn niet die van het hele bestand
rows-listed = { $listed } van { $count } rijen getoond
rows-refused = { $count ->
    [one] 1 rij niet beoordeeld
   *[other] { $number } rijen niet beoordeeld
}
rows-doubted = { $count ->
    [one] 1 waarde is misschien een andere grootheid of van een ander onderdeel
   *[other] { $number } waarden zijn misschien een andere grootheid of van een ander onderdeel
}
rows-simulated = { $count ->
    [one] 1 rij zegt dat er niets is gemeten
   *[other] { $number } rijen zeggen dat er niets is gemeten
}
rows-status-differs = { $count ->
    [one] 1 rij heeft in het bestand een andere status
   *[other] { $number } rijen hebben in het bestand een andere status
}
rows-status-unknown = { $count ->
    [one] 1 rij heeft in het bestand een status die niet bekend is
   *[other] { $number } rijen hebben in het bestand een status die niet bekend is
}
rows-claim-differs = { $count ->
    [one] 1 grens, afwijking of soort element spreekt zijn rij tegen
   *[other] { $number } grenzen, afwijkingen of soorten elementen spreken hun rij tegen
}
rows-several-lines = { $count ->
    [one] 1 rij loopt over meer regels
   *[other] { $number } rijen lopen over meer regels
}
rows-not-utf8 = { $count ->
    [one] 1 regel is geen UTF-8 en is als Windows-1252 gelezen
   *[other] { $number } regels zijn geen UTF-8 en zijn als Windows-1252 gelezen
}
rows-comments = { $count ->
    [one] 1 commentaarregel is geen rij
   *[other] { $number } commentaarregels zijn geen rijen
}
rows-note = Regel { $line }: { $what }
rows-first-notes = De eerste { $first } van { $count }:
rows-line = Regel { $line } van { $name }
rows-row-line = regel { $line }
rows-list = Rijen van het bestand
rows-none = Geen rij voldoet aan het filter
rows-none-yet = Nog geen rij
rows-head-line = Regel
rows-head-what = Te doen
rows-changed = het bestand is veranderd sinds het is beoordeeld; beoordeel het opnieuw
rows-unread = de rijen kunnen niet opnieuw worden gelezen: { $reason }
rows-no-copy = de uitgepakte tekst kan niet worden bewaard: { $reason }
rows-too-much = de uitgepakte tekst is groter dan { $most } GiB
rows-panicked = een interne fout heeft het beoordelen beëindigd

## A file that is read or written
working = Bezig
working-reading = { $name } lezen: { $rows } rijen, { $done } van { $all } MB, { $rate } rijen per seconde
working-reading-bytes = { $name } lezen: { $done } van { $all } MB, { $seconds } s
working-writing = { $name } schrijven: { $done } MB, { $seconds } s
working-progress = Hoeveel van het bestand gelezen is
working-stop = Stoppen
working-stopped = Gestopt na { $rows } rijen: uit { $name } is niets geïmporteerd

## What a code reader typed into the field of the value
scanned-callout = { $given } is een passing en is als zodanig overgenomen
scanned-serial = { $given } is geen waarde: het is als serienummer van de volgende controles overgenomen
