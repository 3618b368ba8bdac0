# tolerance

## Längen
length-empty = eine Länge fehlt
length-not-a-number = { $text } ist keine Zahl
length-ambiguous = { $text } ist mehrdeutig: ein einziges Dezimalzeichen und kein Tausendertrennzeichen schreiben
length-too-fine = { $text } ist feiner als ein Nanometer
length-too-large = { $text } ist zu groß: höchstens { $max } mm in beide Richtungen

## Toleranzangaben und Toleranzklassen
callout-empty = eine Toleranzangabe fehlt: Nennmaß und Toleranzklasse schreiben, wie 25 H7
callout-no-nominal = { $text } beginnt nicht mit einem Nennmaß: eines schreiben, wie 25 H7
callout-nominal = Nennmaß: { $error }
callout-not-positive = Nennmaß { $nominal } mm ist nicht größer als 0
class-missing = eine Toleranzklasse fehlt, wie H7 für eine Bohrung oder h7 für eine Welle
class-mixed-case = { $text } mischt Groß- und Kleinbuchstaben: { $upper } für eine Bohrung oder { $lower } für eine Welle schreiben
class-malformed = { $text } ist keine Toleranzklasse: Buchstaben und einen Toleranzgrad schreiben, wie H7 oder js13

## Grenzabmaße und Grenzmaße
deviations-order = oberes Grenzabmaß { $upper } mm liegt unter dem unteren Grenzabmaß { $lower } mm
nominal-by-operator = ? bedeutet, dass der Bediener den Taster positioniert: schreiben Sie den Sollwert ohne dieses Zeichen
nominal-not-probed = @ bedeutet, dass die Steuerung nicht antastet und den Wert dahinter übernimmt: es würde nichts gemessen
source-choice-iso286 = ISO 286, jede Klasse bis 3150 mm
source-choice-control = Tabellen der Steuerung, 47 Klassen bis 400 mm
source-choice-after-own = Eigene Tabellen, dann { $base }
source-iso286 = ISO 286, über { $over } bis { $to } mm
source-iso286-remark = ISO 286, über { $over } bis { $to } mm; { $remark }
source-shipped-table = mitgelieferte Tabelle { $name }, über { $over } bis { $to } mm
source-table = Tabelle { $name }, über { $over } bis { $to } mm
figure-own-table = { $class } über { $over } bis { $to } mm: Tabelle { $table } weicht von ISO 286 ab, dort stehen { $upper } und { $lower } mm
figure-standard = { $class } über { $over } bis { $to } mm: { $why }
source-file = Datei { $name }
source-iso2768 = ISO 2768-1 Klasse { $class }, über { $over } bis { $to } mm
source-callout = die Toleranzangabe selbst
source-without-own = { $source }; eigene Tabellen in { $folder } konnten nicht gelesen werden
source-recorded = { $text }
limits-own-awaited = Die eigenen Tabellen in { $folder } werden noch gelesen
limits-no-feature = { $callout } sagt nicht, ob die Bohrung oder die Welle gemeint ist
limits-other-feature = { $feature ->
    [hole] { $class } ist eine Klasse für Bohrungen, nicht für Wellen
   *[shaft] { $class } ist eine Klasse für Wellen, nicht für Bohrungen
}
limits-other-case = { $feature ->
    [hole] { $class } ist eine Klasse für Bohrungen und steht nicht in Tabelle { $table }; die Klasse für Wellen ist { $other }
   *[shaft] { $class } ist eine Klasse für Wellen und steht nicht in Tabelle { $table }; die Klasse für Bohrungen ist { $other }
}
limits-unknown-class = { $class } steht nicht in Tabelle { $table }; sie hat { $known }
limits-no-own-table = { $class } ist keine Toleranzklasse nach ISO 286: Buchstaben und einen Toleranzgrad schreiben, wie H7 oder js13, oder eigene Tabellen mit einer Spalte { $class } wählen
limits-no-own-column = { $class } ist keine Toleranzklasse nach ISO 286, und Tabelle { $table } hat keine Spalte { $class }: sie hat { $known }
limits-beyond-last-range = Nennmaß { $nominal } mm liegt außerhalb der Tabelle { $table }, deren letzter Nennmaßbereich über { $over } bis einschließlich { $to } mm geht
limits-not-defined = { $class } ist über { $over } bis { $to } mm in Tabelle { $table } nicht definiert; { $where }
limits-defined-nowhere = auch bei keinem anderen Maß
limits-defined = definiert ist sie { $ranges }
limits-range = über { $over } bis { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = die Grenzmaße von { $nominal } mm sind zu groß

## Toleranzfelder außer jedem Verhältnis
zone-micrometres = ein Toleranzfeld von { $width } mm steht in keinem Verhältnis zu { $nominal } mm, dessen IT 18 { $widest } mm ist: bei Grenzabmaßen in Mikrometern { $offer } schreiben
zone-wide = ein Toleranzfeld von { $width } mm steht in keinem Verhältnis zu { $nominal } mm, dessen IT 18 { $widest } mm ist: Nennmaß und Grenzmaße prüfen
zone-micrometres-to-zero = Mindestmaß { $minimum } mm ist nicht größer als 0: bei Grenzabmaßen in Mikrometern { $offer } schreiben
zone-to-zero = Mindestmaß { $minimum } mm ist nicht größer als 0: Nennmaß und Grenzmaße prüfen
zone-coordinate-micrometres = ein Toleranzfeld von { $width } mm ist breiter als { $widest } mm, das Maximum für eine Koordinate: bei Grenzabmaßen in Mikrometern { $offer } schreiben
zone-coordinate = ein Toleranzfeld von { $width } mm ist breiter als { $widest } mm, das Maximum für eine Koordinate: Grenzmaße prüfen

shape-no-ranges = die Tabelle hat keinen Nennmaßbereich
shape-not-ascending = Nennmaßbereich bis { $end } mm endet nicht über dem vorigen, { $before } mm
shape-cells = Spalte { $class } hat { $cells } Zellen für { $ranges } Nennmaßbereiche
shape-twice = Spalte { $class } kommt zweimal vor

## Urteile
status-good = GUT
status-accepted = ANGENOMMEN
status-rework = NACHARBEIT
status-re-measure = NEU MESSEN
status-out-of-limits = AUSSER TOLERANZ
status-scrap = AUSSCHUSS
rule-simple = kein Sicherheitsband, die Grenzmaße gehören zum Toleranzfeld
rule-iso14253-2017 = ISO 14253-1:2017, 95 % Konformität, { $prover ->
    [customer] der Kunde weist Nichtkonformität nach
   *[supplier] der Lieferant weist Konformität nach
    }; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, Sicherheitsband U, { $prover ->
    [customer] der Kunde weist Nichtkonformität nach
   *[supplier] der Lieferant weist Konformität nach
    }; { $u }
rule-ilac-g8 = ILAC-G8, Sicherheitsband { $factor } U, { $prover ->
    [customer] der Kunde weist Nichtkonformität nach
   *[supplier] der Lieferant weist Konformität nach
    }; { $u }
rule-asme-simple = ASME B89.7.3.1, einfache Annahme 4:1; { $u }
rule-asme-stringent = ASME B89.7.3.1, strenge Annahme, Sicherheitsband { $factor } U; { $u }
rule-asme-relaxed = ASME B89.7.3.1, gelockerte Annahme um { $factor } U; { $u }
rule-fixed = Sicherheitsband { $width } µm, { $prover ->
    [customer] der Kunde weist Nichtkonformität nach
   *[supplier] der Lieferant weist Konformität nach
    }
rule-no-uncertainty = Regel { $rule } braucht die Unsicherheit des Messwerts
rule-no-factor = Regel { $rule } hat keinen Faktor
rule-no-width = Regel { $rule } berechnet ihr Sicherheitsband aus der Unsicherheit
rule-width-missing = Regel { $rule } braucht ein Sicherheitsband über 0 µm
rule-no-prover = Regel { $rule } hängt nicht von der Nachweispflicht ab
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = eine Unsicherheit muss größer als 0 µm sein
uncertainty-factor = Erweiterungsfaktor { $given }: eine Zahl von 1 bis 10 mit höchstens drei Nachkommastellen erwartet
uncertainty-by-budget = u jedes Werts aus dem Budget
undecided-contacts = mit diesen { $contacts } Antastpunkten ist der Durchmesser { $times }-mal so unsicher wie mit { $contacts } Antastpunkten rund um den ganzen Kreis, die angegebene Unsicherheit gilt aber nur bis zum 3-Fachen: die Antastpunkte über einen längeren Bogen verteilen oder ein Budget angeben
doubt-times-inch = Messwert ist das 25,4-Fache des Nennmaßes: wurde zweimal aus Inch umgerechnet?
doubt-inches = Messwert ist das Nennmaß geteilt durch 25,4: steht er in Inch?
doubt-double = Messwert ist das Doppelte des Nennmaßes: wurde ein Durchmesser als Radius genommen?
doubt-half = Messwert ist die Hälfte des Nennmaßes: ist er ein Radius?
doubt-decimal-sign = Messwert ist etwa das Nennmaß mit dem Dezimalzeichen an anderer Stelle: sind es { $meant } mm?
doubt-far = Messwert liegt { $distance } mm außerhalb der Grenzmaße: ist es dieses Teil, in Millimetern?
doubt-implausible = Messwert liegt außerhalb dessen, was laut Plan sein kann, { $lower } bis { $upper } mm: stimmen Einheit und Dezimalzeichen?

## Dateien
file-is-folder = das ist ein Ordner, keine Datei: { $path }
file-missing = Datei oder Ordner nicht vorhanden: { $path }
file-exists = eine Datei oder einen Ordner dieses Namens gibt es schon: { $path }
file-half-set = das Schreiben eines Dateisatzes wurde mittendrin beendet, daher sind manche Dateien im Ordner alt und manche neu: den Dateisatz noch einmal schreiben, um ihn zu vervollständigen; was noch zu verschieben ist, steht in { $path }
file-not-a-file = das ist eine Pipe oder ein Gerät, keine Datei: { $path }
file-changed = die Datei hat sich während des Lesens geändert; noch einmal lesen: { $path }
file-busy = die Datei ist in einem anderen Programm geöffnet: dort schließen und noch einmal versuchen: { $path }
file-stopped = angehalten: nichts wurde geschrieben: { $path }
file-too-large = die Datei ist größer als { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-grade-missing = { $class } ist keine Toleranzklasse nach ISO 286: Buchstaben und einen Toleranzgrad schreiben, wie H7 oder js13
iso286-no-grade = { $class } ist keine Toleranzklasse nach ISO 286: die Toleranzgrade sind { $grades }
iso286-no-letter = { $class } ist keine Toleranzklasse nach ISO 286: den Buchstaben { $letters } gibt es nicht, nur { $known }
iso286-too-large = Nennmaß { $nominal } mm liegt außerhalb von ISO 286, die bei 3150 mm endet
iso286-not-here = { $class } ist bei { $nominal } mm in ISO 286 nicht definiert; { $where }
iso286-js-rounded = JS gerundet wie 1988
iso286-contested-ef = strittig: ef ist hier 28 µm, andere Quellen nennen 25 µm
iso286-older-it5 = zur Erprobung; ältere Kataloge haben hier einen kleineren IT5
iso286-trial-use = zur Erprobung

## Passungen
fit-kind-clearance = Spielpassung
fit-kind-transition = Übergangspassung
fit-kind-interference = Übermaßpassung
fit-basis-hole = Einheitsbohrung
fit-basis-shaft = Einheitswelle
fit-basis-both = Einheitsbohrung und Einheitswelle
fit-preferred-hole-basis = Vorzugspassung der Einheitsbohrung
fit-preferred-shaft-basis = Vorzugspassung der Einheitswelle
fit-function-loose-running = weiter Laufsitz
fit-function-free-running = leichter Laufsitz
fit-function-close-running = enger Laufsitz
fit-function-sliding = Gleitsitz
fit-function-locational-clearance = Lagesitz mit Spiel
fit-function-locational-transition = Lagesitz, Übergang
fit-function-locational-transition-tighter = Lagesitz, Übergang, fester
fit-function-locational-interference = Lagesitz mit Übermaß
fit-function-medium-drive = Treibsitz
fit-function-force = Presssitz
fit-one-sided = { $callout } ist keine Passung: Maß, Klasse der Bohrung und Klasse der Welle schreiben, wie 25 H7/g6
fit-not-a-hole = { $minimum } bis { $maximum } mm sind die Grenzmaße einer Welle: die einer Bohrung erwartet
fit-not-a-shaft = { $minimum } bis { $maximum } mm sind die Grenzmaße einer Bohrung: die einer Welle erwartet
fit-nominal-sizes = eine Passung hat ein einziges Nennmaß: die Bohrung hat { $hole } mm, die Welle { $shaft } mm
fit-too-large = das Spiel ist zu groß
fit-search-order = kleinstes Spiel { $minimum } mm liegt über dem größten Spiel { $maximum } mm
fit-search-no-classes = die Tabellen haben bei { $nominal } mm keine Klassen für Bohrung und Welle zugleich
fit-thermal-too-fine = { $text } hat mehr als drei Nachkommastellen
fit-thermal-temperature = eine Temperatur von { $text } °C liegt außerhalb des Bereichs: von -273,15 bis 1000 °C
fit-thermal-expansion = eine Ausdehnung von { $text } liegt außerhalb des Bereichs: von -20 bis 500, in Millionsteln je Kelvin, wie 11,5 für Stahl
fit-thermal-expansion-unit = eine Ausdehnung von { $text } steht in einer anderen Einheit: Ausdehnungen gelten in Millionsteln je Kelvin; { $meant } schreiben

## Zweifelhafte Temperaturen
thermal-doubt-fahrenheit = { $given } °C liegt weit von jeder Temperatur, bei der Teile gemessen werden: bei Grad Fahrenheit { $meant } schreiben
thermal-doubt-kelvin = { $given } °C liegt weit von jeder Temperatur, bei der Teile gemessen werden: bei Kelvin { $meant } schreiben
thermal-doubt-far = { $given } °C liegt weit von jeder Temperatur, bei der Teile gemessen werden, { $least } bis { $most } °C: prüfen
thermal-doubt-beyond = { $given } °C liegt außerhalb von { $least } bis { $most } °C, wo eine Ausdehnung von { $expansion } Millionsteln je Kelvin gilt: die Ausdehnung für diese Temperatur angeben

## Werkstoffe
material-published = veröffentlichter Wert
material-verify = üblicher Wert, noch zu bestätigen
material-own = eigener Wert
material-toml = { $reason }
material-version = Version { $found } einer Werkstoffdatei wird nicht unterstützt: Version { $known } erwartet
material-too-many = { $count } Werkstoffe sind zu viele: höchstens { $most }
material-too-large = eine Werkstoffdatei hat höchstens { $most } Byte
material-name = der Name eines Werkstoffs hat 1 bis { $longest } Zeichen und keine Steuerzeichen
material-range = ein Temperaturbereich beginnt mit der niedrigeren: zwei Zahlen in °C schreiben, wie [-50, 200]
material-elastic = modulus und poisson gehören zusammen: modulus von 1 bis 1200000 MPa, poisson von 0 bis 0.5, yield von 1 bis 10000 MPa
material-twice = Werkstoff { $name } ist zweimal definiert
material-unknown = unbekannter Werkstoff { $name }: einen aus { $known } wählen oder die Ausdehnung selbst angeben, wie 11,5
## Toleranzangaben: Grenzabmaße, Grenzmaße, Passungen und Allgemeintoleranzen
callout-at = { $reason } (Zeichen { $at })
callout-no-tolerance = eine Toleranz fehlt, wie H7, h7, H7/g6, m, +0,1 -0,2 oder ±0,1
callout-general-capital = { $capital } hat keinen Toleranzgrad: { $offer } für die Allgemeintoleranz nach ISO 2768-1 schreiben oder einen Toleranzgrad hinzufügen, wie { $capital }7
callout-fit-order = die Welle steht vor der Bohrung: { $offer } schreiben
callout-fit-side = { $first } und { $second } sind nicht Bohrung und Welle: eine Passung hat erst Großbuchstaben, dann Kleinbuchstaben, wie 25 H7/g6
callout-number = { $part }: { $error }
callout-not-a = { $found } ist kein { $part }: { $how }
callout-missing = { $part } fehlt: { $how }
callout-part-deviation = Grenzabmaß
callout-part-limit = Grenzmaß
callout-part-actual = Wert nach @
callout-how-deviation = Vorzeichen und Zahl schreiben, wie +0,1 oder -0,1
callout-how-limit = zwei Maße schreiben, das größere zuerst, wie 12,01/11,985
callout-how-actual = eine Zahl schreiben, wie 10H7@10,004
callout-no-sign = { $number } hat kein Vorzeichen: +{ $number } oder -{ $number } für ein Grenzabmaß schreiben, ohne Leerzeichen in der Zahl
callout-no-unit = { $number } hat keine Einheit, und das andere Grenzabmaß steht in µm: die Einheit hinter beide schreiben
callout-deviation-order = das untere Grenzabmaß steht vor dem oberen: { $offer } schreiben
callout-limits-order = das kleinere Grenzmaß steht vor dem größeren: { $offer } schreiben
callout-limits-apart = { $larger } mm ist mehr als das Doppelte von { $smaller } mm, daher sind das wohl keine Grenzmaße: Grenzabmaße schreiben, wie 12 +0,2 0
callout-limits-or-deviation = das ist mehrdeutig: { $limits } für Grenzmaße oder { $deviation } für ein unteres Grenzabmaß schreiben
callout-limits-meant = ein solches Grenzabmaß ließe kein Maß übrig: { $limits } für Grenzmaße schreiben
callout-minimum-not-positive = Mindestmaß { $minimum } mm ist nicht größer als 0
callout-micrometres-meant = Mindestmaß { $minimum } mm ist nicht größer als 0: bei Grenzabmaßen in Mikrometern { $offer } schreiben
callout-mixed-decimals = { $number } hat ein anderes Dezimalzeichen als die Zahl davor: nur eines verwenden
callout-cycle-sign = { $sign } gehört in Texte der Zyklen 14xx, nicht in eine Toleranzangabe
callout-not-in-cycle-text = { $found } ist in einem Text der Zyklen 14xx nicht zulässig: eine Klasse, eine Klasse der Allgemeintoleranzen oder Grenzabmaße schreiben
callout-too-much = { $found } wird hier nicht erwartet: der Text ist ohne dies vollständig
callout-too-long = der Text ist zu lang: höchstens { $most } Zeichen
callout-band-order = das untere Grenzabmaß steht vor dem oberen: QS400 als 0.4-0.1 schreiben
callout-lone-order = das untere Grenzabmaß steht vor dem oberen: { $offer } schreiben
callout-inch = { $given } sind { $nominal } mm: Maßangaben sind in Millimetern, schreiben Sie { $offer }
callout-inch-size = { $given } sind { $nominal } mm: schreiben Sie Maß und Toleranz in Millimetern
callout-inch-somewhere = { $given } ist in Zoll: schreiben Sie Maß und Toleranz in Millimetern, 1 Zoll sind 25.4 mm
callout-thread = { $given } ist ein Gewinde, keine glatte Bohrung oder Welle: schreiben Sie Kern- oder Flankendurchmesser mit beiden Grenzmaßen, etwa 5.153/4.917
callout-exact = ein theoretisch genaues Maß hat keine eigene Toleranz: schreiben Sie das Maß mit den Grenzen, die dafür gelten, etwa 25 ±0.1
callout-reference = ein Maß in Klammern ist ein Hilfsmaß ohne Toleranz: schreiben Sie es ohne Klammern, wenn es beurteilt werden soll
callout-one-sided = { $given } hat nur eine Grenze: schreiben Sie beide Grenzmaße, das größere zuerst, etwa 8.2/8
callout-roughness = { $given } ist eine Rauheit, kein Maß: schreiben Sie ein Maß mit Toleranz, etwa 25 H7
callout-modifier = { $given } ist kein Symbol nach ISO 14405-1: es gibt { $known }
callout-grade = { $given } ist bei { $nominal } mm nicht definiert: schreiben Sie einen Grundtoleranzgrad von IT1 bis IT18, den ISO 286 dort hat
callout-ansi = { $class } ist eine Klasse nach ANSI B4.1, deren Tabellen Fitcheck nicht hat: schreiben Sie eine Klasse nach ISO 286 oder Maß und Abmaße in Millimetern
callout-stated-micrometres = die Abmaße hinter der Toleranz stehen in keinem Verhältnis zu { $nominal } mm: sind es Mikrometer, schreiben Sie ({ $offer })
callout-stated-of-fit = Abmaße hinter einer Passung können zu jedem der Teile gehören: schreiben Sie sie hinter jede Klasse einzeln
iso286-grade-alone = { $class } ist ein Grundtoleranzgrad: er sagt, wie breit ein Feld ist, aber nicht, wo es liegt; schreiben Sie ±{ $grade }/2 oder eine Klasse, etwa H7
general-too-small = Nennmaß { $nominal } mm liegt unter { $first } mm, wo ISO 2768-1 beginnt: die Grenzabmaße neben das Maß schreiben
general-too-large = Nennmaß { $nominal } mm liegt außerhalb von ISO 2768-1, die bei { $last } mm endet
general-not-defined = ISO 2768-1 definiert Klasse { $class } { $range } nicht; definiert ist sie { $defined }
general-range-from = von { $over } bis { $to } mm

## Tabellen aus der Norm
make-no-class = keine Toleranzklasse angegeben: eine oder mehrere nennen, wie H7 H8 JS9
make-both-features = { $hole } und { $shaft } können nicht in einer Tabelle stehen: nur Groß- und Kleinschreibung unterscheidet sie, daher eine Tabelle für Bohrungen und eine für Wellen anlegen
make-last-size = das letzte Maß ist { $to } mm: es muss größer als 0 und höchstens 3150 mm sein

## Press fits
press-no-interference = die Passung hat ein Spiel von mindestens { $clearance } mm: ein Pressverband braucht ein Übermaß, etwa 40 H7/s6
press-length = Länge { $length } mm ist nicht größer als 0
press-hub-outer = Außendurchmesser der Nabe { $given } mm ist nicht größer als der Fugendurchmesser { $nominal } mm
press-shaft-bore = Bohrung der Welle { $given } mm: schreiben Sie 0 für eine Vollwelle oder eine Bohrung unter { $nominal } mm
press-roughness = Rautiefe { $given } mm ist kleiner als 0
press-friction = ein Pressverband braucht eine Reibung größer als 0
press-material = der Elastizitätsmodul von { $name } ist nicht bekannt: wählen Sie einen anderen Werkstoff oder ergänzen Sie modulus und poisson in einer eigenen Werkstoffdatei
press-ratio = { $text } ist keine Zahl von 0 bis 1 mit höchstens drei Nachkommastellen
press-yields = NICHT ELASTISCH: die Spannung { $part ->
    [hole] der Nabe
   *[shaft] der Welle
    } wäre { $stress } MPa, über der Streckgrenze von { $limit } MPa: die elastische Theorie gilt nicht, und es wird nicht gesagt, dass etwas hält
press-yield-unknown = ob { $part ->
    [hole] die Nabe
   *[shaft] die Welle
    } plastisch wird, ist nicht bekannt: der Werkstoff hat hier keine Streckgrenze; geben Sie eine an
press-may-be-loose = die Teile können ein Spiel von { $clearance } mm haben: die Verbindung hält vielleicht gar nicht
press-all-smoothed = die Glättung der Rauheit, { $loss } mm, kann das Übermaß aufbrauchen: die Verbindung hält vielleicht gar nicht
press-no-roughness = keine Rautiefe Rz angegeben: es wird kein Übermaßverlust durch Glättung abgezogen
press-too-hot = die Nabe allein zu erwärmen reicht bis { $most } °C nicht, so weit ihre Ausdehnung bekannt ist
press-too-cold = die Welle allein zu kühlen reicht auch in flüssigem Stickstoff nicht
press-contraction-unknown = die Schrumpfung des Wellenwerkstoffs in der Kälte ist nicht bekannt: gerechnet wird mit seiner Ausdehnung, die Welle muss vielleicht kälter sein
