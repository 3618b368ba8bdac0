# tolerance

## Lengtes
length-empty = een lengte ontbreekt
length-not-a-number = { $text } is geen getal
length-ambiguous = { $text } is dubbelzinnig: schrijf één decimaalteken en geen scheidingsteken voor duizendtallen
length-too-fine = { $text } is fijner dan een nanometer
length-too-large = { $text } is te groot: hoogstens { $max } mm in beide richtingen

## Maataanduidingen en tolerantieklassen
callout-empty = een passing ontbreekt: schrijf een nominale maat en een tolerantieklasse, zoals 25 H7
callout-no-nominal = { $text } begint niet met een nominale maat: schrijf die erbij, zoals 25 H7
callout-nominal = nominale maat: { $error }
callout-not-positive = nominale maat { $nominal } mm is niet groter dan 0
class-missing = een tolerantieklasse ontbreekt, zoals H7 voor een boring of h7 voor een as
class-mixed-case = { $text } heeft hoofdletters en kleine letters door elkaar: schrijf { $upper } voor een boring of { $lower } voor een as
class-malformed = { $text } is geen tolerantieklasse: schrijf letters en een graad, zoals H7 of js13

## Afwijkingen en grensmaten
deviations-order = bovenafwijking { $upper } mm ligt onder onderafwijking { $lower } mm
nominal-by-operator = ? betekent dat de bediener de taster positioneert: schrijf de nominale waarde zonder dit teken
nominal-not-probed = @ betekent dat de besturing niet tast en de waarde erachter overneemt: er zou niets worden gemeten
source-choice-iso286 = ISO 286, elke klasse tot 3150 mm
source-choice-control = De tabellen van de besturing, 47 klassen tot 400 mm
source-choice-after-own = Eigen tabellen, dan { $base }
source-iso286 = ISO 286, boven { $over } tot en met { $to } mm
source-iso286-remark = ISO 286, boven { $over } tot en met { $to } mm; { $remark }
source-shipped-table = ingebouwde tabel { $name }, boven { $over } tot en met { $to } mm
source-table = tabel { $name }, boven { $over } tot en met { $to } mm
figure-own-table = { $class } boven { $over } tot en met { $to } mm: tabel { $table } wijkt af van ISO 286, die { $upper } en { $lower } mm heeft
figure-standard = { $class } boven { $over } tot en met { $to } mm: { $why }
source-file = bestand { $name }
source-iso2768 = ISO 2768-1 klasse { $class }, boven { $over } tot en met { $to } mm
source-callout = de passing zelf
source-without-own = { $source }; eigen tabellen in { $folder } konden niet worden gelezen
source-recorded = { $text }
limits-own-awaited = De eigen tabellen in { $folder } worden nog gelezen
limits-no-feature = { $callout } zegt niet of de boring of de as bedoeld is
limits-other-feature = { $feature ->
    [hole] { $class } is een klasse voor boringen, niet voor assen
   *[shaft] { $class } is een klasse voor assen, niet voor boringen
}
limits-other-case = { $feature ->
    [hole] { $class } is een klasse voor boringen en staat niet in tabel { $table }; de klasse voor assen is { $other }
   *[shaft] { $class } is een klasse voor assen en staat niet in tabel { $table }; de klasse voor boringen is { $other }
}
limits-unknown-class = { $class } staat niet in tabel { $table }; die heeft { $known }
limits-no-own-table = { $class } is geen tolerantieklasse van ISO 286: schrijf letters en een graad, zoals H7 of js13, of kies eigen tabellen met een kolom { $class }
limits-no-own-column = { $class } is geen tolerantieklasse van ISO 286 en tabel { $table } heeft geen kolom { $class }: zij heeft { $known }
limits-beyond-last-range = nominale maat { $nominal } mm valt buiten tabel { $table }; het laatste maatbereik is boven { $over } tot en met { $to } mm
limits-not-defined = { $class } is niet gedefinieerd boven { $over } tot en met { $to } mm in tabel { $table }; { $where }
limits-defined-nowhere = ook bij geen andere maat
limits-defined = wel { $ranges }
limits-range = boven { $over } tot en met { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = de grensmaten van { $nominal } mm zijn te groot

## Tolerantievelden buiten elke verhouding
zone-micrometres = een tolerantieveld van { $width } mm staat in geen verhouding tot { $nominal } mm, waarvan IT 18 { $widest } mm is: zijn de afwijkingen micrometers? Schrijf dan { $offer }
zone-wide = een tolerantieveld van { $width } mm staat in geen verhouding tot { $nominal } mm, waarvan IT 18 { $widest } mm is: controleer nominale maat en grensmaten
zone-micrometres-to-zero = minimale grensmaat { $minimum } mm is niet groter dan 0: zijn de afwijkingen micrometers? Schrijf dan { $offer }
zone-to-zero = minimale grensmaat { $minimum } mm is niet groter dan 0: controleer nominale maat en grensmaten
zone-coordinate-micrometres = een tolerantieveld van { $width } mm is breder dan { $widest } mm, het maximum voor een coördinaat: zijn de afwijkingen micrometers? Schrijf dan { $offer }
zone-coordinate = een tolerantieveld van { $width } mm is breder dan { $widest } mm, het maximum voor een coördinaat: controleer de grensmaten

shape-no-ranges = de tabel heeft geen maatbereik
shape-not-ascending = maatbereik tot en met { $end } mm eindigt niet boven het vorige, { $before } mm
shape-cells = kolom { $class } heeft { $cells } cellen voor { $ranges } maatbereiken
shape-twice = kolom { $class } komt twee keer voor

## Oordelen
status-good = GOED
status-accepted = AANVAARD
status-rework = NABEWERKING
status-re-measure = OPNIEUW METEN
status-out-of-limits = BUITEN GRENZEN
status-scrap = AFGEKEURD
rule-simple = geen veiligheidsmarge, de grensmaten horen bij het tolerantieveld
rule-iso14253-2017 = ISO 14253-1:2017, 95 % conformiteit, { $prover ->
    [customer] de afnemer bewijst niet-conformiteit
   *[supplier] de leverancier bewijst conformiteit
    }; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, veiligheidsmarge U, { $prover ->
    [customer] de afnemer bewijst niet-conformiteit
   *[supplier] de leverancier bewijst conformiteit
    }; { $u }
rule-ilac-g8 = ILAC-G8, veiligheidsmarge { $factor } U, { $prover ->
    [customer] de afnemer bewijst niet-conformiteit
   *[supplier] de leverancier bewijst conformiteit
    }; { $u }
rule-asme-simple = ASME B89.7.3.1, eenvoudige aanvaarding 4:1; { $u }
rule-asme-stringent = ASME B89.7.3.1, strenge aanvaarding, veiligheidsmarge { $factor } U; { $u }
rule-asme-relaxed = ASME B89.7.3.1, ruime aanvaarding met { $factor } U; { $u }
rule-fixed = veiligheidsmarge { $width } µm, { $prover ->
    [customer] de afnemer bewijst niet-conformiteit
   *[supplier] de leverancier bewijst conformiteit
    }
rule-no-uncertainty = regel { $rule } heeft de onzekerheid van de gemeten waarde nodig
rule-no-factor = regel { $rule } heeft geen factor
rule-no-width = regel { $rule } berekent zijn veiligheidsmarge uit de onzekerheid
rule-width-missing = regel { $rule } heeft een veiligheidsmarge boven 0 µm nodig
rule-no-prover = regel { $rule } hangt niet af van de bewijslast
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = een onzekerheid moet groter dan 0 µm zijn
uncertainty-factor = dekkingsfactor { $given }: een getal van 1 tot 10 verwacht, met hoogstens drie decimalen
uncertainty-by-budget = u van elke waarde volgens het budget
undecided-contacts = met deze { $contacts } meetpunten is de diameter { $times } keer zo onzeker als met { $contacts } meetpunten rond de hele cirkel, maar de opgegeven onzekerheid geldt maar tot en met 3 keer: verdeel de meetpunten over een langere boog, of geef een budget op
doubt-times-inch = gemeten waarde is 25,4 keer de nominale maat: is er twee keer uit inch omgerekend?
doubt-inches = gemeten waarde is de nominale maat gedeeld door 25,4: staat die in inch?
doubt-double = gemeten waarde is twee keer de nominale maat: is een diameter voor een radius aangezien?
doubt-half = gemeten waarde is de helft van de nominale maat: is het een radius?
doubt-decimal-sign = gemeten waarde is ongeveer de nominale maat met het decimaalteken op een andere plaats: is het { $meant } mm?
doubt-far = gemeten waarde ligt { $distance } mm buiten de grensmaten: is het dit onderdeel, in millimeters?
doubt-implausible = gemeten waarde ligt buiten wat volgens het plan kan, { $lower } tot { $upper } mm: kloppen eenheid en decimaalteken?

## Bestanden
file-is-folder = dit is een map, geen bestand: { $path }
file-missing = bestand of map bestaat niet: { $path }
file-exists = er bestaat al een bestand of map met deze naam: { $path }
file-half-set = het schrijven van een reeks bestanden is halverwege gestopt, dus sommige bestanden in de map zijn oud en andere nieuw: schrijf de reeks opnieuw om die af te maken; wat nog verplaatst moet worden staat in { $path }
file-not-a-file = dit is een pipe of een apparaat, geen bestand: { $path }
file-changed = het bestand is veranderd terwijl het werd gelezen; lees het opnieuw: { $path }
file-busy = het bestand is open in een ander programma: sluit het daar en probeer het opnieuw: { $path }
file-stopped = gestopt: er is niets geschreven: { $path }
file-too-large = het bestand is groter dan { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-grade-missing = { $class } is geen tolerantieklasse van ISO 286: schrijf letters en een graad, zoals H7 of js13
iso286-no-grade = { $class } is geen tolerantieklasse van ISO 286: de graden zijn { $grades }
iso286-no-letter = { $class } is geen tolerantieklasse van ISO 286: letter { $letters } bestaat niet, alleen { $known }
iso286-too-large = nominale maat { $nominal } mm valt buiten ISO 286, die bij 3150 mm ophoudt
iso286-not-here = { $class } is bij { $nominal } mm niet gedefinieerd in ISO 286; { $where }
iso286-js-rounded = JS afgerond als in 1988
iso286-contested-ef = omstreden: ef is hier 28 µm, andere bronnen geven 25 µm
iso286-older-it5 = op proef; oudere catalogi hebben hier een kleinere IT5
iso286-trial-use = op proef

## Passingen
fit-kind-clearance = spelingpassing
fit-kind-transition = overgangspassing
fit-kind-interference = perspassing
fit-basis-hole = eenheidsboring
fit-basis-shaft = eenheidsas
fit-basis-both = eenheidsboring en eenheidsas
fit-preferred-hole-basis = voorkeurspassing van de eenheidsboring
fit-preferred-shaft-basis = voorkeurspassing van de eenheidsas
fit-function-loose-running = ruim lopend
fit-function-free-running = vrij lopend
fit-function-close-running = nauw lopend
fit-function-sliding = glijdend
fit-function-locational-clearance = plaatsbepalend met speling
fit-function-locational-transition = plaatsbepalend, overgang
fit-function-locational-transition-tighter = plaatsbepalend, overgang, strakker
fit-function-locational-interference = plaatsbepalend met overmaat
fit-function-medium-drive = licht klemmend
fit-function-force = zwaar klemmend
fit-one-sided = { $callout } is geen passing van boring en as: schrijf een maat, een klasse voor de boring en een voor de as, zoals 25 H7/g6
fit-not-a-hole = { $minimum } tot { $maximum } mm zijn de grensmaten van een as: die van een boring verwacht
fit-not-a-shaft = { $minimum } tot { $maximum } mm zijn de grensmaten van een boring: die van een as verwacht
fit-nominal-sizes = een passing heeft één nominale maat: de boring heeft { $hole } mm, de as { $shaft } mm
fit-too-large = de speling is te groot
fit-search-order = kleinste speling { $minimum } mm ligt boven grootste speling { $maximum } mm
fit-search-no-classes = de tabellen hebben bij { $nominal } mm geen klassen voor zowel boring als as
fit-thermal-too-fine = { $text } heeft meer dan drie decimalen
fit-thermal-temperature = een temperatuur van { $text } °C valt buiten het bereik: van -273,15 tot 1000 °C
fit-thermal-expansion = een uitzetting van { $text } valt buiten het bereik: van -20 tot 500, in miljoensten per kelvin, zoals 11,5 voor staal
fit-thermal-expansion-unit = een uitzetting van { $text } staat in een andere eenheid: uitzettingen zijn in miljoensten per kelvin; schrijf { $meant }

## Temperaturen die niet kunnen kloppen
thermal-doubt-fahrenheit = { $given } °C ligt ver van elke temperatuur waarbij wordt gemeten: zijn dit graden Fahrenheit? Schrijf dan { $meant }
thermal-doubt-kelvin = { $given } °C ligt ver van elke temperatuur waarbij wordt gemeten: is dit in kelvin? Schrijf dan { $meant }
thermal-doubt-far = { $given } °C ligt ver van elke temperatuur waarbij wordt gemeten, { $least } tot { $most } °C: controleer die
thermal-doubt-beyond = { $given } °C ligt buiten { $least } tot { $most } °C, waarbinnen een uitzetting van { $expansion } miljoensten per kelvin geldt: geef de uitzetting voor deze temperatuur

## Materialen
material-published = gepubliceerde waarde
material-verify = gangbare waarde, nog te controleren
material-own = eigen waarde
material-toml = { $reason }
material-version = versie { $found } van een materialenbestand wordt niet ondersteund: versie { $known } verwacht
material-too-many = { $count } materialen zijn er te veel: hoogstens { $most }
material-too-large = een materialenbestand heeft hoogstens { $most } bytes
material-name = de naam van een materiaal heeft 1 tot { $longest } tekens en geen stuurtekens
material-range = een temperatuurbereik begint met de laagste: schrijf twee getallen in °C, zoals [-50, 200]
material-elastic = modulus en poisson horen bij elkaar: modulus van 1 tot 1200000 MPa, poisson van 0 tot 0.5, yield van 1 tot 10000 MPa
material-twice = materiaal { $name } is twee keer gedefinieerd
material-unknown = onbekend materiaal { $name }: kies een van { $known }, of geef de uitzetting zelf op, zoals 11,5
## Maataanduidingen: afwijkingen, grensmaten, passingen en algemene toleranties
callout-at = { $reason } (teken { $at })
callout-no-tolerance = de tolerantie ontbreekt, zoals H7, h7, H7/g6, m, +0,1 -0,2 of ±0,1
callout-general-capital = { $capital } heeft geen graad: schrijf { $offer } voor de algemene tolerantie van ISO 2768-1, of voeg een graad toe, zoals { $capital }7
callout-fit-order = de as staat voor de boring: schrijf { $offer }
callout-fit-side = { $first } en { $second } zijn geen boring en as: een passing heeft eerst hoofdletters, dan kleine letters, zoals 25 H7/g6
callout-number = { $part }: { $error }
callout-not-a = { $found } is geen { $part }: { $how }
callout-missing = er ontbreekt een { $part }: { $how }
callout-part-deviation = afwijking
callout-part-limit = grensmaat
callout-part-actual = waarde na @
callout-how-deviation = schrijf een teken en een getal, zoals +0,1 of -0,1
callout-how-limit = schrijf twee maten, de grootste eerst, zoals 12,01/11,985
callout-how-actual = schrijf een getal, zoals 10H7@10,004
callout-no-sign = { $number } heeft geen teken: schrijf +{ $number } of -{ $number } voor een afwijking, zonder spatie in het getal
callout-no-unit = { $number } heeft geen eenheid en de andere afwijking staat in µm: schrijf de eenheid achter beide
callout-deviation-order = de onderafwijking staat voor de bovenafwijking: schrijf { $offer }
callout-limits-order = de kleinste grensmaat staat voor de grootste: schrijf { $offer }
callout-limits-apart = { $larger } mm is meer dan twee keer { $smaller } mm, dus dit zijn waarschijnlijk geen grensmaten: schrijf afwijkingen, zoals 12 +0,2 0
callout-limits-or-deviation = dit is dubbelzinnig: schrijf { $limits } voor grensmaten of { $deviation } voor een onderafwijking
callout-limits-meant = zo'n afwijking zou geen maat overlaten: schrijf { $limits } voor grensmaten
callout-minimum-not-positive = minimale grensmaat { $minimum } mm is niet groter dan 0
callout-micrometres-meant = minimale grensmaat { $minimum } mm is niet groter dan 0: zijn de afwijkingen micrometers? Schrijf dan { $offer }
callout-mixed-decimals = { $number } heeft een ander decimaalteken dan het getal ervoor: gebruik één soort
callout-cycle-sign = { $sign } hoort in de teksten van de cycli 14xx, niet in een passing
callout-not-in-cycle-text = { $found } is in een tekst van de cycli 14xx niet toegestaan: schrijf een klasse, een algemene klasse of afwijkingen
callout-too-much = { $found } wordt hier niet verwacht: de tekst is zonder dit al volledig
callout-too-long = de tekst is te lang: hoogstens { $most } tekens
callout-band-order = de onderafwijking staat voor de bovenafwijking: schrijf QS400 als 0.4-0.1
callout-lone-order = de onderafwijking staat voor de bovenafwijking: schrijf { $offer }
callout-inch = { $given } is { $nominal } mm: maataanduidingen zijn in millimeters, schrijf { $offer }
callout-inch-size = { $given } is { $nominal } mm: schrijf maat en tolerantie in millimeters
callout-inch-somewhere = { $given } is in inch: schrijf maat en tolerantie in millimeters, 1 inch is 25.4 mm
callout-thread = { $given } is schroefdraad, geen glad gat of gladde as: schrijf kern- of flankdiameter met beide grenzen, zoals 5.153/4.917
callout-exact = een theoretisch juiste maat heeft geen eigen tolerantie: schrijf de maat met de grenzen die ervoor gelden, zoals 25 ±0.1
callout-reference = een maat tussen haakjes is een hulpmaat zonder tolerantie: schrijf haar zonder haakjes als ze beoordeeld moet worden
callout-one-sided = { $given } heeft maar één grens: schrijf beide grensmaten, de grootste eerst, zoals 8.2/8
callout-roughness = { $given } is een oppervlakteruwheid, geen maat: schrijf een maat met tolerantie, zoals 25 H7
callout-modifier = { $given } is geen symbool van ISO 14405-1: er zijn { $known }
callout-grade = { $given } is bij { $nominal } mm niet gedefinieerd: schrijf een tolerantiegraad van IT1 tot IT18 die ISO 286 daar heeft
callout-ansi = { $class } is een klasse van ANSI B4.1, waarvan Fitcheck de tabellen niet heeft: schrijf een klasse van ISO 286, of maat en afwijkingen in millimeters
callout-stated-micrometres = de afwijkingen achter de tolerantie zijn buiten elke verhouding tot { $nominal } mm: zijn het micrometers, schrijf dan ({ $offer })
callout-stated-of-fit = afwijkingen achter een passing kunnen bij elk van beide delen horen: schrijf ze achter elke klasse apart
iso286-grade-alone = { $class } is een tolerantiegraad: die zegt hoe breed een zone is, maar niet waar ze ligt; schrijf ±{ $grade }/2 of een klasse, zoals H7
general-too-small = nominale maat { $nominal } mm ligt onder { $first } mm, waar ISO 2768-1 begint: schrijf de afwijkingen bij de maat
general-too-large = nominale maat { $nominal } mm valt buiten ISO 2768-1, die tot en met { $last } mm gaat
general-not-defined = ISO 2768-1 heeft geen klasse { $class } { $range }; wel { $defined }
general-range-from = van { $over } tot en met { $to } mm

## Tables made of the standard
make-no-class = er is geen tolerantieklasse opgegeven: noem er een of meer, zoals H7 H8 JS9
make-both-features = { $hole } en { $shaft } kunnen niet in één tabel staan: alleen hoofdletters en kleine letters onderscheiden ze, maak dus een tabel voor boringen en een voor assen
make-last-size = de laatste maat is { $to } mm: die moet groter dan 0 en hoogstens 3150 mm zijn

## Press fits
press-no-interference = de passing heeft minstens { $clearance } mm speling: een perspassing heeft overmaat nodig, zoals 40 H7/s6
press-length = lengte { $length } mm is niet groter dan 0
press-hub-outer = buitendiameter van de naaf { $given } mm is niet groter dan de voegdiameter { $nominal } mm
press-shaft-bore = boring van de as { $given } mm: schrijf 0 voor een massieve as, of een boring onder { $nominal } mm
press-roughness = ruwheid { $given } mm is kleiner dan 0
press-friction = een perspassing heeft een wrijving boven 0 nodig
press-material = de elasticiteitsmodulus van { $name } is niet bekend: kies een ander materiaal, of voeg modulus en poisson toe aan een bestand met eigen materialen
press-ratio = { $text } is geen getal van 0 tot 1 met hoogstens drie decimalen
press-yields = NIET ELASTISCH: de spanning van de { $part ->
    [hole] naaf
   *[shaft] as
    } zou { $stress } MPa zijn, boven de vloeigrens van { $limit } MPa: de elastische theorie geldt niet, en er wordt niet gezegd dat iets houdt
press-yield-unknown = of de { $part ->
    [hole] naaf
   *[shaft] as
    } vloeit, is niet bekend: het materiaal heeft hier geen vloeigrens; geef er een
press-may-be-loose = de delen kunnen { $clearance } mm speling hebben: de verbinding houdt misschien helemaal niet
press-all-smoothed = het gladdrukken van de ruwheid, { $loss } mm, kan de overmaat opgebruiken: de verbinding houdt misschien helemaal niet
press-no-roughness = geen ruwheid Rz opgegeven: er is geen verlies aan overmaat door gladdrukken afgetrokken
press-too-hot = alleen de naaf verwarmen is niet genoeg tot { $most } °C, zover haar uitzetting bekend is
press-too-cold = alleen de as koelen is niet genoeg, ook niet in vloeibare stikstof
press-contraction-unknown = de krimp van het asmateriaal in de kou is niet bekend: de uitzetting is gebruikt, de as moet misschien kouder zijn
