# control

# Masken
mask-empty = die Maske ist leer
mask-too-large = die Maske ist größer als { $most } KiB
mask-unknown = { $found } ist weder Ausgabesatz noch Schlüsselwort noch Kommentar
mask-unclosed-quote = das Anführungszeichen ist nicht geschlossen
mask-unknown-format = { $found } ist kein Format: zulässig sind %S %RS %F %LF %D %I %%
mask-too-wide = { $found } ist zu breit: höchstens { $most }
mask-count = { $formats } Formate und { $parameters } Parameter
mask-unknown-parameter = { $found } ist kein Parameter: zulässig sind Q, QL, QR, QS mit einer Nummer, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = das ; am Ende fehlt
mask-unknown-word = { $word } ist unbekannt und hat keine Wirkung
mask-behind-semicolon = { $found } nach dem ; ist übersprungen
mask-other-languages = die Maske hat Text für { $languages } und keinen für { $wanted }
mask-inverse-touching = { $first } und { $second } werden ohne etwas dazwischen ausgegeben, daher kann die Ausgabe nicht zurückgelesen werden
mask-inverse-blanks = { $first } und { $second } sind Texte mit nur Leerzeichen dazwischen, daher kann die Ausgabe nicht zurückgelesen werden: ein Text kann Leerzeichen enthalten
mask-inverse-no-mark = kein fester Text zeigt, wo ein Ausgabesatz beginnt, daher kann die Ausgabe nicht zurückgelesen werden
mask-inverse-too-long = die Maske gibt mehr als { $most } Textzeilen auf einmal aus: nur kürzere Ausgabesätze können zurückgelesen werden
mask-inverse-no-number = die Maske gibt keine Zahl aus, die ein Messwert sein könnte
mask-undefined = { $name } ist nicht definiert
mask-text-as-number = { $name } ist ein Text, das Format braucht eine Zahl
mask-number-as-text = { $name } ist eine Zahl, das Format braucht einen Text
mask-not-finite = { $name } ist keine endliche Zahl
# Messprotokolle
log-empty = die Datei ist leer
log-no-log = kein Messprotokoll: keine Titelzeile mit der Nummer eines Messzyklus
log-too-long = das Messprotokoll hat mehr als { $lines } Textzeilen oder eine Textzeile mit mehr als { $bytes } Byte
log-no-title = das Messprotokoll hat keine Titelzeile, daher ist sein Zyklus nicht bekannt
log-other-cycle = Messprotokolle von Zyklus { $cycle } können nicht gelesen werden, nur die von { $known }
log-unit = Maßeinheit { $given } ist weder 0 (mm) noch 1 (Inch)
log-count = { $section }: { $expected } erwartet, { $found } gefunden
log-missing = { $section } fehlt: das Messprotokoll ist abgeschnitten oder unvollständig
log-no-label = keine Bezeichnung vor { $given }
log-cut-figure = die Datei endet in diesem Wert: { $given } ist vielleicht unvollständig
log-swapped = Höchstmaß { $maximum } liegt unter dem Mindestmaß { $minimum }
log-uneven = Grenzmaße { $minimum } und { $maximum } liegen nicht symmetrisch zum Sollwert { $nominal }
log-deviation = Abweichung { $given } ist nicht Istwert minus Sollwert, { $actual } - { $nominal }
log-not-positive = Durchmesser { $given } ist nicht größer als 0
log-section-nominal = Abschnitt der Sollwerte
log-section-limits = Abschnitt der Grenzwerte
log-section-actual = Abschnitt der Istwerte
log-section-deviations = Abschnitt der Abweichungen
log-no-unit = keine Textzeile nennt die Maßeinheit: Millimeter angenommen
log-no-time = Datum und Uhrzeit der Messung sind nicht bekannt
log-no-deviations = die Abweichungen fehlen: das Messprotokoll ist vielleicht abgeschnitten
log-ignored = übersprungen: { $text }
log-text-before = Text vor dem ersten Messprotokoll wurde übersprungen

## Tabellen
table-empty = die Datei ist leer
table-not-text = Zeichen { $code } ist kein Text: die Datei ist keine Tabelle oder ist beschädigt
table-line-too-long = die Textzeile ist länger als { $limit } Byte
table-too-large = die Tabelle hat mehr als { $limit } Zellen
table-too-many-columns = die Tabelle hat mehr als { $limit } Spalten
table-no-begin = eine Tabelle beginnt mit BEGIN und ihrem Namen, nicht mit { $found }
table-no-name = nach BEGIN fehlt der Name der Tabelle
table-unclosed-quote = ein Anführungszeichen ist nicht geschlossen
table-unclosed-block = der Block { $block } von Textzeile { $line } ist nicht geschlossen
table-second-block = die Spalten werden ein zweites Mal beschrieben
table-unexpected = { $expected } erwartet, { $found } gefunden
table-not-a-size = { $key } muss eine ganze Zahl bis { $limit } sein, nicht { $text }
table-no-columns = die Textzeile mit den Spaltennamen fehlt
table-tab = Tabulatorzeichen: Spalten nur mit Leerzeichen trennen
table-column-twice = Spalte { $name } kommt zweimal vor
table-short-row = die Zeile endet vor Spalte { $name }: mit Leerzeichen auffüllen, oder - für keinen Wert schreiben
table-truncated = die Datei endet in dieser Zeile und ohne [END]: sie ist vielleicht abgeschnitten
table-text-after-end = Text nach [END]: { $found }
table-no-end = [END] fehlt
table-no-lock = die Werkzeugtabelle hat keine Spalte TL: ein gebrochenes Werkzeug wird in ihr nicht gesperrt
table-no-unit = die Tabelle nennt ihre Maßeinheit nicht: ihre Längen wurden als Millimeter gelesen
table-begin-word = { $word } hat in der BEGIN-Zeile keine bekannte Bedeutung
table-width = Spalte { $name } ist hier { $found } Zeichen breit, in der Beschreibung aber { $described }; die Textzeile mit den Spaltennamen gilt
table-not-in-table = Spalte { $name } ist beschrieben, aber nicht in der Tabelle
table-not-described = Spalte { $name } ist nicht beschrieben
table-skipped = { $name } ist unbekannt und wurde übersprungen
table-write-too-wide = Zeile { $row }, Spalte { $column }: { $text } passt nicht in { $width } Zeichen
table-write-too-many-columns = die Tabelle hat { $columns } Spalten; eine iTNC 530 nimmt höchstens { $limit }
table-write-too-long = die Textzeilen der Tabelle haben { $characters } Zeichen; eine iTNC 530 nimmt höchstens { $limit }
table-write-reads-otherwise = die Tabelle kann nicht so geschrieben werden, dass beim Lesen dasselbe herauskommt: Namen der Tabelle und ihrer Spalten prüfen

## Tabellen mit Grenzabmaßen
deviations-no-tables = keine Tabelle mit Grenzabmaßen (*.tab mit einer Spalte BEREICH) in diesem Ordner: { $folder }
tables-contradict = { $first } und { $second } widersprechen einander, { $class } über { $over } bis { $to } mm: { $one ->
        [none] kein Wert
       *[other] { $one } µm
    } und { $other ->
        [none] kein Wert
       *[other] { $other } µm
    }: die Spalte aus einer von beiden entfernen
deviations-two-range-columns = die Tabelle hat BEREICH und BEREIK: nur eine kann die Nennmaßbereiche enthalten
deviations-inch = die Tabelle ist in Inch: Nennmaßbereiche in Millimetern und Grenzabmaße in Mikrometern schreiben
deviations-no-class = keine Spalte ist eine Toleranzklasse wie H7
deviations-odd-rows = die Anzahl der Zeilen ist ungerade ({ $rows }): jeder Nennmaßbereich braucht zwei, zuerst das obere, dann das untere Grenzabmaß
deviations-no-range = das Ende des Nennmaßbereichs fehlt
deviations-other-range = der Nennmaßbereich bis { $end } mm hat { $found } in seiner zweiten Zeile: wiederholen oder leer lassen
deviations-column = Spalte { $column }: { $error }
deviations-half = Spalte { $class } hat für den Nennmaßbereich bis { $end } mm nur eines der beiden Grenzabmaße
deviations-touches = Spalte { $column } und ihre Nachbarin laufen ineinander: mit einem Leerzeichen trennen
deviations-no-deviations = übersprungen, keine Tabelle mit Grenzabmaßen (keine Spalte BEREICH): { $file }
deviations-range-alias = BEREIK wurde als BEREICH gelesen
deviations-other-column = Spalte { $name } wurde übersprungen, da ihr Name nicht der einer Toleranzklasse sein kann: einer daraus geschriebenen Tabelle fehlt sie
deviations-no-numbers = Spalte { $name } wurde übersprungen, da sie Texte und keine Grenzabmaße enthält: einer daraus geschriebenen Tabelle fehlt sie
deviations-mixed-case = Spalte { $name } wurde übersprungen, da eine Toleranzklasse Groß- und Kleinbuchstaben nicht mischt: einer daraus geschriebenen Tabelle fehlt sie

## Parameter
no-parameter = { $given } ist kein Parameter: zulässig sind Q, QL, QR und QS mit einer Nummer

## Messprotokolle schreiben
log-write-cycle = Zyklus { $cycle } schreibt diese Werte nicht
log-write-no-title = das Messprotokoll von Zyklus { $cycle } hat keinen Titel in { $file }
log-write-unit = ein Messprotokoll ist in mm oder Inch, nicht in µm
log-write-character = { $given } kann nicht geschrieben werden: ein Messprotokoll kann das Zeichen U+{ $code } nicht enthalten
log-write-program = { $given } würde nicht als Pfad eines Programms zurückgelesen: einen Pfad wie TNC:\PART\CHECK.H schreiben
log-write-unfinished = die Datei endet in einer Textzeile: sie ist vielleicht abgeschnitten, daher wird nichts hinzugefügt
log-write-reads-otherwise = das Messprotokoll kann nicht so geschrieben werden, dass beim Lesen dasselbe herauskommt: Datum, Uhrzeit und weitere Ergebnisse prüfen

## Messprotokoll von Zyklus 444
point-log-no-log = kein Messprotokoll von Zyklus 444: die Seite enthält keine maschinenlesbare Messung
point-log-count = die Seite sagt, dass sie { $expected } Messungen enthält, enthält aber { $found }: sie ist abgeschnitten oder wurde geändert
point-log-cut-off = die Messung hat kein Ende: die Seite ist abgeschnitten
point-log-json = die Messung kann nicht gelesen werden: { $what }
point-log-version = Version { $version } des Messprotokolls wird nicht unterstützt: { $known } oder früher erwartet
point-log-normal = Normale { $given } hat keine Richtung: sie braucht drei Zahlen, die nicht alle 0 sind
point-log-deviation = Abweichung { $given } in { $axis } ist nicht gemessene minus Soll-Koordinate, { $difference }
point-log-along = Abweichung { $given } entlang der Normalen folgt nicht aus denen der Achsen, { $along }
point-log-band = oberes Grenzabmaß { $upper } liegt unter dem unteren Grenzabmaß { $lower }
point-log-status = Status { $given } folgt nicht aus Abweichung und Toleranz, { $status }
## Die Tastsystemtabelle
probe-table-no-column = die Tabelle hat keine Spalte { $column }
probe-table-no-probe = die Tabelle hat kein Tastsystem
probe-table-no-length = { $column }: { $error }
probe-table-too-small = { $column } = { $given } mm: der Wert muss { $least } sein
probe-table-zero-or-more = mindestens 0
probe-table-above-zero = größer als 0
probe-table-not-whole = { $column } = { $given }: eine ganze Zahl erwartet
probe-table-twice = Tastsystem { $number } kommt zweimal vor

## Die Werkzeugtabelle
tool-table-no-column = die Tabelle hat keine Spalte { $column }
tool-table-no-tool = die Tabelle hat kein Werkzeug
tool-table-touches = { $column }: die Zelle läuft in ihre Nachbarin, daher ist ihr Wert unsicher
tool-table-no-number = { $column } = { $given }: eine Werkzeugnummer von 0 bis 32767 erwartet, mit Index wie 5.1 oder ohne
tool-table-twice = Werkzeug { $number } kommt zweimal vor
tool-table-name-too-long = NAME = { $given }: ein Name hat höchstens { $most } Zeichen
tool-table-no-length = { $column }: { $error }
tool-table-out-of-range = { $column } = { $given } mm: { $least } bis { $most } mm erwartet
tool-table-no-lock = TL = { $given }: L oder 1 für ein gesperrtes Werkzeug erwartet; 0, - oder nichts für ein freies
tool-table-not-whole = { $column } = { $given }: eine ganze Zahl erwartet
tool-unknown = Q330 = { $tool }: die Werkzeugtabelle hat dieses Werkzeug nicht; sie hat { $known }
tool-no-deviation = Q330 = { $tool }: Zyklus { $cycle } hat hier keine Grenzmaße, daher gibt es keine Abweichung, um die das Werkzeug zu korrigieren wäre
tool-out-of-range = Werkzeug { $tool }: { $column } würde sich von { $from } auf { $to } mm ändern: der größte Wert ist { $most } mm in beide Richtungen
tool-broken = Fehler 1065: Werkzeug { $tool } ist gebrochen: { $column } würde sich um { $by } mm ändern, { $limit } ist { $most } mm; das Werkzeug wird gesperrt und nicht korrigiert
tool-broken-replacement = Fehler 1065: Werkzeug { $tool } ist gebrochen: { $column } würde sich um { $by } mm ändern, { $limit } ist { $most } mm; das Werkzeug wird gesperrt und nicht korrigiert; sein Schwesterwerkzeug ist Werkzeug { $replacement }
tool-corrected = Werkzeug { $tool }: { $column } um { $by } mm geändert, von { $from } auf { $to } mm
tool-corrected-rounded = Werkzeug { $tool }: { $column } um { $by } mm geändert, von { $from } auf { $to } mm: die Tabelle behält die nächsten 0.00001 in
tool-locked = Werkzeug { $tool }: gesperrt, TL = { $to }

## Das Messprotokoll eines Zyklusergebnisses
cycle-log-other-verdict = die Werte des Messprotokolls, auf 0.0001 { $unit } gerundet, ergeben { $log }, wo der Zyklus { $cycle } ergab

## Der NC-Satz eines Antastzyklus
block-none = kein Antastzyklus: ein NC-Satz beginnt mit TCH PROBE und einer Nummer, oder mit G785
block-inches = der NC-Satz gehört zu einem Programm in Inch, würde aber in mm gelesen: das Programm ausführen
block-none-at = diese Zeile gehört zu keinem Messzyklus: sie beginnen in den Zeilen { $blocks }
block-second = zweiter Antastzyklus: jeweils nur einen angeben; der erste beginnt in Textzeile { $first }
block-unknown-cycle = TCH PROBE { $given }: die Zyklen sind { $known }
block-not-a-parameter = { $given } ist kein Parameter: als { $example } schreiben
block-no-value = { $key } hat keinen Wert
block-twice = { $key } ist zweimal angegeben, zuerst in Textzeile { $first }
block-unclosed-quote = ein Anführungszeichen ist nicht geschlossen
block-behind-end = { $given } steht nach dem Ende des NC-Satzes: jede Textzeile außer der letzten endet mit ~
block-too-many-parts = die Textzeile hat mehr als { $most } Teile zwischen ~
block-cut-off = der NC-Satz endet mit ~, daher fehlt eine Textzeile: er ist vielleicht abgeschnitten
block-reference = { $key } = { $given }: der Wert von { $given } ist erst beim Lauf eines Programms bekannt
block-not-writable = { $key } = { $given }: ein Text in einem NC-Satz kann weder Anführungszeichen noch Zeilenenden enthalten
block-unused = Textzeile { $line }: { $text } gehört nicht zum Antastzyklus und wurde übersprungen
block-unused-more = Textzeile { $line }: { $text } gehört nicht zum Antastzyklus und wurde übersprungen, ebenso { $more } weitere
