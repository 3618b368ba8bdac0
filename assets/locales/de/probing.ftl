# probing

# Woher eine Messung kommt, und was sie nicht sagen kann.
origin-simulated = simuliert, Zyklus { $cycle }, Startwert { $seed }
origin-contacts = Antastpunkte aus { $file }
origin-imported = importiert aus { $file }
origin-imported-simulation = importiert aus { $file }, simuliert
origin-typed = eingegeben
caveat-only-a-diameter = nur ein Durchmesser: Form und Lage sind nicht bekannt
caveat-only-a-circle = nur Durchmesser und Mitte: Form ist nicht bekannt
caveat-three-contacts = 3 Antastpunkte: Form ist nicht messbar
caveat-four-contacts = 4 Antastpunkte: außer Ovalität wird keine Formabweichung erkannt
caveat-few-contacts = { $contacts } Antastpunkte: Formabweichung dazwischen wird nicht erkannt
caveat-short-arc = Antastpunkte decken nur { $arc }° ab: Streuung wirkt in Durchmesser und Mitte verstärkt
caveat-two-point = der Durchmesser über die Antastpunkte { $one } und { $other } ist { $size } mm, jenseits des Grenzmaßes { $limit } mm, das der mittlere Kreis nicht überschreitet: ohne weitere Angabe gilt ein Maß zwischen je zwei gegenüberliegenden Punkten
caveat-form = die Radien der Antastpunkte unterscheiden sich um { $form } mm, daher können sich Durchmesser darüber um mehr als das Toleranzfeld von { $zone } mm unterscheiden: zwei gegenüberliegende Punkte können außerhalb der Grenzmaße liegen
caveat-heights = die Höhen der Antastpunkte unterscheiden sich um { $spread } mm: an einem Kegel oder bei gekippter Achse ändert das den Durchmesser
caveat-stated = die Maßangabe nennt hinter der Toleranz { $upper } und { $lower } µm, die Toleranz hat { $used-upper } und { $used-lower } µm: es gilt die Toleranz; prüfen Sie, was die Zeichnung meint
caveat-count = die Maßangabe gilt für { $count } Geometrieelemente: dieser Wert ist der von einem
caveat-form-class = Klasse { $class } von ISO 2768-2 gilt für Form und Lage: das Maß zeigt sie nicht
caveat-each-two-point = { $modifier } verlangt jedes Zweipunktmaß innerhalb der Grenzen: dies ist nur ein Durchmesser
caveat-mean-of-two-points = { $modifier } verlangt jedes Zweipunktmaß innerhalb der Grenzen: der Gauß-Durchmesser ist nur deren Mittel
caveat-not-least-squares = { $modifier } meint das Gauß-Maß: ein einzelner Durchmesser zeigt es nicht
caveat-one-section = { $modifier } meint das Gauß-Maß des ganzen Geometrieelements: dies ist das eines Schnitts
caveat-envelope = { $modifier } verlangt die Hülle idealer Form beim Maximum-Material-Maß: ein Durchmesser zeigt nicht, ob die Oberfläche sie überschreitet; verwenden Sie eine Lehre
caveat-other-size = { $modifier } meint ein anderes Maß als das gemessene: ein Zweipunkt- oder Gauß-Durchmesser beweist es nicht
caveat-condition = { $modifier } sagt, wo oder wie das Maß gilt: der Messwert zeigt nicht, ob das eingehalten wurde
contact-beyond-travel = Antastpunkt { $number } liegt { $distance } mm vom Beginn seines Antastwegs entfernt, und die Kugel fährt höchstens { $allowed } mm (DIST oder K, plus SET_UP der Tastsystemtabelle und Q320): prüfen, ob diese Antastpunkte zu diesem Merkmal gehören, in dieser Reihenfolge, und ab diesem Nullpunkt zählen
contact-missed = Antastpunkt { $number }: das Tastsystem traf auf dem Antastweg auf nichts
contact-no-height = Antastpunkt { $number } hat keine Höhe: der Datei eine Spalte z hinzufügen
contact-used-up = Antastpunkt { $number }: die Datei hat nur { $available ->
    [one] { $available } Antastpunkt
   *[other] { $available } Antastpunkte
    }

cycle-out-of-range = { $key } { $name } = { $given }: { $allowed }
cycle-length-range = mindestens { $least } mm, höchstens { $most } mm
cycle-angle-range = höchstens { $most } in beide Richtungen
cycle-angle-size-range = dem Betrag nach mindestens { $smallest }, höchstens { $most }
cycle-one-of = eines von { $allowed } erwartet
cycle-tool-range = eine Werkzeugnummer von 0 bis 99999.9, oder ein Werkzeugname mit höchstens 255 Zeichen
cycle-not-a-value = { $key } { $name }: { $error }
cycle-tool-no-name = { $text } ruft kein Werkzeug auf: seine Nummer oder seinen Namen schreiben
cycle-tool-empty = kein Werkzeug ist genannt: für keines Q330=0 schreiben
cycle-tool-unquoted = { $text } ist keine Zahl, und ein Werkzeugname braucht Anführungszeichen
cycle-no-diameter = { $key } { $name } = 0 mm: ein Kreis braucht einen Durchmesser über 0
cycle-one-limit = { $given } ist ohne { $missing } angegeben: das andere Grenzmaß wäre 0
cycle-missing = { $key } { $name } fehlt
cycle-no-such-parameter = Zyklus { $cycle } hat keinen Parameter { $parameter }: seine Parameter sind { $known }
cycle-limits-swapped = { $minimum-key } = { $minimum } mm liegt über { $maximum-key } = { $maximum } mm: das Mindestmaß liegt über dem Höchstmaß
cycle-too-large = der gemessene Kreis ist zu groß: { $error }
workpiece-cannot-be = { $what } = { $given }: mindestens { $least }, höchstens { $most }

# Antastungen.
contact-in-material = Antastpunkt { $number }: der Antastweg beginnt im Material
contact-in-feature = Antastpunkt { $number }: der Antastweg beginnt im Material von { $feature }
contact-behind = Antastpunkt { $number }: die Kugel erreicht die Wand von { $feature } von hinten, und die Dicke des Materials ist dort nicht bekannt
contact-ambiguous = Antastpunkt { $number }: die Kugel trifft { $feature } und { $other } an derselben Stelle, daher ist nicht bekannt, was gemessen wird

# Auswertung des Kreises.
circle-too-few = ein Kreis braucht mindestens 3 Antastpunkte, { $contacts } gefunden
circle-coinciding = Antastpunkte { $first } und { $second } fallen zusammen bei x = { $x }, y = { $y }: ein Kreis braucht 3 verschiedene Punkte
circle-collinear = alle { $contacts } Antastpunkte liegen auf einer Geraden: kein Kreis geht hindurch
circle-straight = die { $contacts } Antastpunkte passen besser zu einer Geraden als zu einem Kreis
circle-not-finite = Antastpunkt { $contact }: { $axis } = { $value } ist keine endliche Zahl
circle-too-large = { $what } = { $value } mm ist zu groß: höchstens { $most } mm in beide Richtungen
circle-part-contact = Antastpunkt { $contact }: { $axis }
circle-part-diameter = Durchmesser
circle-part-centre = Mitte { $axis }
circle-three-contacts = 3 Antastpunkte: Form ist nicht messbar, die Restabweichung ist immer null
circle-four-contacts = 4 Antastpunkte: vier Ecken werden nicht erkannt und ändern den Durchmesser
circle-short-arc = die Antastpunkte decken nur einen Bogen von { $arc }° ab: die Streuung im Durchmesser ist { $factor }-mal so groß wie bei 3 Antastpunkten im Abstand von 120°
circle-circumscribed-of-short-arc = der kleinste Hüllkreis eines kurzen Bogens ist nicht das Maß des Merkmals
circle-counts-twice = Antastpunkte { $first } und { $second } fallen zusammen: diese Stelle zählt doppelt
circle-no-inscribed = kein größter Pferchkreis: die Antastpunkte umschließen keinen
circle-no-zone = keine kleinste Ringzone: ein gerader Streifen ist schmaler als jeder Ring
circle-too-many-contacts = größter Pferchkreis und kleinste Ringzone werden für { $contacts } Antastpunkte nicht berechnet: höchstens { $most }
circle-short-chord = Antastpunkte { $first } und { $second } liegen einander gegenüber, aber neben der Mitte: dieses Maß ist { $short } µm zu klein
circle-more-of-a-kind = dasselbe gilt für { $more } weitere
circle-apart = Antastpunkt { $contact } liegt { $apart } mm neben dem Kreis, weit mehr als die anderen: Schmutz oder ein Fehlsignal?
circle-heights = die Höhen der Antastpunkte unterscheiden sich um { $spread } mm: an einem Kegel oder bei gekippter Achse ändert das den Durchmesser

## Messzyklen: Fehler, Ergebnisse, Hinweise
contact-out-of-reach = Antastpunkt { $number }: das Tastsystem traf innerhalb des Antastwegs von { $longest } mm auf nichts
cycle-number-range = eine Zahl, höchstens { $most } in beide Richtungen
cycle-count-range = eine ganze Zahl von 0 bis { $most }
cycle-band-range = eine Toleranz wie 0.4-0.1, 0.4 oder -0.1; 0 heißt keine Toleranz
cycle-range = { $range }
cycle-range-tool = 0 … { $highest }, oder höchstens { $longest } Zeichen
cycle-range-band = 0.4-0.1, 0.4, -0.1 oder nichts
cycle-value = { $value }
cycle-value-length = { $value } mm
cycle-value-no-tolerance = keine Toleranz
cycle-no-global = { $key } { $name } = PREDEF: kein GLOBAL DEF gibt einen Wert
cycle-no-path = { $key } { $name } = 0 mm: ein Antastweg braucht eine Länge; ihr Vorzeichen gibt die Richtung
cycle-no-transfer = { $row-key } = { $row } bei { $key } = -1: es ist nicht angegeben, in welcher Tabelle die Zeile steht; { $key } muss 0 oder 1 sein (eine Steuerung meldet Fehler 1078)
cycle-other-feature = { $key } { $name } = { $given }: die Klasse passt nicht zu { $geometry }: Großbuchstaben gelten für eine Bohrung, Kleinbuchstaben für einen Zapfen
cycle-not-measured = { $key } { $name } = { $given }: der Zyklus misst diesen Wert nicht: schreiben Sie ihn ohne Toleranz
cycle-inch-tolerance = { $key } { $name } = { $given }: in einem Programm in Zoll ist die Einheit einer Toleranz nicht bekannt: schreiben Sie ein Programm in mm oder die Zahl ohne Toleranz
cycle-no-edge = { $first } und { $second } sind gleich: eine Kante braucht zwei Punkte in ihrer Richtung
cycle-no-sphere = die Antastpunkte bestimmen keine Kugel
cycle-no-rotation = { $key } { $name }: Fitcheck verfolgt nur eine Grunddrehung (Q1121 = 1), und diese ohne Korrektur (Q1120 = 0)
cycle-no-normal = { $first }, { $second } und { $third } sind alle 0: eine Normale braucht eine Richtung
cycle-apart = Antastpunkt { $contact }: seine beiden Antastungen liegen { $difference } mm auseinander, { $key } erlaubt { $most } mm
cycle-too-far = die gemessene Koordinate ist zu groß: { $error }
cycle-stop = Programmstopp durch Q309 = { $setting }: { $out }
check-within = { $what } { $measured } mm liegt innerhalb von { $minimum } bis { $maximum } mm
check-above = { $what } { $measured } mm liegt über dem Höchstmaß { $maximum } mm: { $status }
check-below = { $what } { $measured } mm liegt unter dem Mindestmaß { $minimum } mm: { $status }
check-and = { $one }; { $other }
found-centre-1 = gemessene Mitte, 1. Achse
found-centre-2 = gemessene Mitte, 2. Achse
found-centre-3 = gemessene Mitte, 3. Achse
found-diameter = gemessener Durchmesser
found-centre-deviation-1 = Abweichung der Mitte, 1. Achse
found-centre-deviation-2 = Abweichung der Mitte, 2. Achse
found-centre-deviation-3 = Abweichung der Mitte, 3. Achse
found-diameter-deviation = Abweichung des Durchmessers
found-coordinate = gemessene Koordinate
found-coordinate-deviation = Abweichung der Koordinate
found-position-1 = gemessene Position, 1. Achse
found-position-2 = gemessene Position, 2. Achse
found-position-3 = gemessene Position, 3. Achse
found-angle = gemessener Winkel
found-deviation-1 = Abweichung, 1. Achse
found-deviation-2 = Abweichung, 2. Achse
found-deviation-3 = Abweichung, 3. Achse
found-deviation-along = Abweichung entlang der Normalen
found-second-position-1 = 2. Punkt: gemessene Position, 1. Achse
found-second-position-2 = 2. Punkt: gemessene Position, 2. Achse
found-second-position-3 = 2. Punkt: gemessene Position, 3. Achse
found-second-deviation-1 = 2. Punkt: Abweichung, 1. Achse
found-second-deviation-2 = 2. Punkt: Abweichung, 2. Achse
found-second-deviation-3 = 2. Punkt: Abweichung, 3. Achse
found-second-diameter = 2. Kreis: gemessener Durchmesser
found-second-diameter-deviation = 2. Kreis: Abweichung des Durchmessers
found-rotation = gemessene Drehung
found-side-1 = gemessene Länge, 1. Seite
found-side-2 = gemessene Länge, 2. Seite
found-width = gemessene Breite
found-centre-line = Lage der Mittellinie
found-side-deviation-1 = Abweichung der 1. Seite
found-side-deviation-2 = Abweichung der 2. Seite
found-width-deviation = Abweichung der Breite
found-good = in Toleranz
found-rework = Nacharbeit
found-scrap = Ausschuss
found-status = Status: -1 nicht definiert, 0 gut, 1 Nacharbeit, 2 Ausschuss
cycle-note-machine-builder = der Maschinenhersteller muss diesen Zyklus freigeben und anpassen: siehe Maschinenhandbuch
cycle-note-not-on-itnc530 = eine iTNC 530 hat diesen Zyklus nicht; TNC 320, TNC 620, TNC 640 und TNC7 haben ihn
cycle-note-normal-from-cad = die Normale aus einem CAD- oder CAM-System übernehmen
cycle-note-software-option = die Steuerung braucht die Software-Option { $option }
cycle-note-recommended = wo die Steuerung Zyklus { $cycle } hat, empfiehlt HEIDENHAIN ihn stattdessen
cycle-note-ends-rotation = beendet eine aktive Grunddrehung
remark-without-effect = { $key } ist zulässig, hat aber keine Wirkung
remark-tool-not-monitored = Q330 = { $tool }: das Werkzeug wird nicht überwacht: keine Werkzeugtabelle
remark-outside-dimension = ein Außenmaß ist angenommen: über dem Höchstmaß ist Nacharbeit, unter dem Mindestmaß ist Ausschuss
remark-nominal-outside-limits = Solldurchmesser { $nominal } mm liegt nicht zwischen den Grenzmaßen: eine TNC7 nimmt das nicht an
remark-nominal-width-outside-limits = Sollbreite { $nominal } mm liegt nicht zwischen den Grenzmaßen: eine TNC7 nimmt das nicht an
remark-nominal-coordinate-outside-limits = Soll-Koordinate { $nominal } mm liegt nicht zwischen den Grenzmaßen: laut Handbuch nimmt eine TNC7 das vielleicht nicht an
remark-contact-astray = { $count ->
    [one] Antastpunkt { $contact } liegt { $distance } mm von der Stelle, an der der Zyklus antastet: vielleicht gehört er zu einem anderen Merkmal
   *[other] { $count } Antastpunkte liegen abseits der Stellen, an denen der Zyklus antastet, Antastpunkt { $contact } um { $distance } mm: vielleicht gehören sie zu einem anderen Merkmal
}
remark-deviation-without-parameter = die Abweichung hat hier keinen Parameter: laut Handbuch speichert eine Steuerung sie, aber nicht gesagt ist, in welchem
remark-new-datum = neuer Bezugspunkt, { $target }: { $axes } mm (gemessen → gewünscht)
datum-target-display = sofort aktiv
datum-target-active = Korrektur des aktiven Bezugspunkts
datum-target-preset = Zeile { $row } der Bezugspunkttabelle
datum-target-table = Zeile { $row } der Nullpunkttabelle
remark-new-rotation = neue Grunddrehung { $angle }: { $target }
remark-axis-turned = Achse { $axis } dreht das Teil um { $angle }: wo ihre Mitte liegt, weiß nur die Maschine, und ihren Nullpunkt schreibt Fitcheck in keine Tabelle
remark-variable-holds-diameter = #i99 wird als Durchmesser gelesen: das Handbuch sagt nicht, welchen Wert sie enthält
remark-no-tolerance = { $key } ist keine Toleranz: nichts wird beurteilt

## Die simulierte Maschine
workpiece-file-toml = Textzeile { $line }: { $said }
workpiece-file-too-large = eine Werkstückdatei hat höchstens { $most } KiB
workpiece-file-not-one = die Datei hat { $found } von { $tables }: sie braucht genau eine
workpiece-file-cannot-be = Textzeile { $line }: { $error }
workpiece-file-several = die Datei hat Tabellen [[feature]]: hier ein Werkstück mit einer einzigen Fläche erwartet
workpiece-file-too-many = ein Teil hat höchstens { $most } Merkmale
workpiece-file-feature = Textzeile { $line }, Spalte { $column }: { $feature }: { $fault }
feature-fault-toml = { $said }
feature-fault-kind = { $given } ist keine Art von Merkmal: die Arten sind { $known }
feature-fault-no-key = zu { $kind } gehört { $key }
feature-fault-other-key = zu { $kind } gehört kein { $key }
feature-fault-name = ein Name hat 1 bis { $most } Zeichen in einer Zeile
feature-fault-same-name = ein anderes Merkmal hat denselben Namen

# Größen des simulierten Werkstücks, wie Fehler sie nennen.
figure-temperature = Temperatur
figure-expansion = Ausdehnung
figure-probe-scatter = Streuung Tastsystem
figure-ball-radius = Kugelradius
figure-calibration-error = Kalibrierfehler
figure-offset = Versatz
figure-lobing = Amplitude des Schaltwegs
figure-lobing-angle = Winkel des Schaltwegs
figure-lobing-count = Ecken des Schaltwegs
figure-centre-x = Mitte x
figure-centre-y = Mitte y
figure-diameter = Durchmesser
figure-surface-scatter = Streuung Oberfläche
figure-ovality = Ovalität
figure-ovality-angle = Winkel der Ovalität
figure-ovality-count = Anzahl der Ovalität
figure-lobe-height = Eckenhöhe
figure-lobe-angle = Winkel der Ecken
figure-lobes = Eckenzahl
figure-point = Punkt
figure-normal = Normale
figure-normal-length = Länge der Normalen
figure-wave-length = Wellenlänge
figure-wave-amplitude = Wellenamplitude
figure-wave-direction = Wellenrichtung
figure-deviation = Abweichung
figure-radius = Radius
figure-width = Breite
figure-first-length = 1. Länge
figure-second-length = 2. Länge
figure-angle = Winkel
figure-top = Oberkante
figure-bottom = Unterkante
figure-length = Länge der Wände
figure-reach = Reichweite
figure-stylus-radius = Radius des Taststifts

## Was vom Tastsystem berührt.
mover-ball = Tastkugel
mover-stylus = Taststift
