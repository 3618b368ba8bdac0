# exchange

# Messungen aus Dateien
exchange-format-logs = HEIDENHAIN-Messprotokolle wie TCHPR421.TXT
exchange-format-log-444 = Messprotokolle vom Antasten 3D, wie Fitcheck sie schreibt
exchange-format-fn16 = FN-16-Ausgabe einer Steuerung, über ihre Maske gelesen (--mask)
exchange-format-series-table = Tabelle einer Steuerung, die ein Programm mit FN 27 füllt, eine Zeile je Teil
exchange-format-contacts = Antastpunkte eines Kreises: x, y und wahlweise z
exchange-format-measurements = Messungen als CSV: Name, Toleranzangabe, Messwert
exchange-empty = die Datei ist leer
exchange-not-recognised = keine Datei eines bekannten Formats
exchange-model-not-read = ein Modell im Format { $format }: Fitcheck liest keine Modelle; die Messwerte als CSV, XLSX, QIF oder AQDEF exportieren
exchange-drawing-not-read = eine Zeichnung im Format { $format }: Fitcheck liest keine Zeichnungen; die Maße als CSV oder XLSX exportieren
exchange-document-not-read = ein Dokument im Format { $format }: Fitcheck liest keine Dokumente; die Werte als CSV, XLSX, QIF oder AQDEF exportieren
exchange-image-not-read = ein Bild im Format { $format }: Fitcheck liest keine Bilder; die Werte als CSV, XLSX, QIF oder AQDEF exportieren
exchange-archive-not-read = ein Archiv im Format { $format }: entpacken und die Dateien darin angeben
exchange-no-sheet = die Arbeitsmappe hat kein Blatt { $given }; sie hat { $sheets }
exchange-other-format = das sind { $format }, keine Messungen als CSV
exchange-parquet-unknown = dieses Programm wurde ohne Parquet gebaut: cargo build --release ohne weitere Optionen baut es ein
exchange-parquet-stream = Parquet beschreibt seine Spalten am Ende der Datei und kann nicht aus einer Pipe gelesen werden: den Namen der Datei angeben
exchange-parquet = diese Parquet-Datei kann nicht gelesen werden: { $reason }
exchange-parquet-nested = Spalte { $column } enthält Spalten oder Listen: nur Spalten mit einzelnen Werten können beurteilt werden
exchange-mask-backwards = { $mask }: { $reason }
exchange-mask-none = keine der angegebenen Masken gibt eine solche Datei aus: { $masks }
exchange-mask-several = mehrere Masken geben eine solche Datei aus; nur die angeben, die sie geschrieben hat: { $masks }
exchange-mask-no-measured = { $mask } gibt keinen Messwert aus: Fitcheck erkennt Q153 bis Q156, Q160 und jede andere Zahl, neben der ihre Toleranzangabe ausgegeben wird
exchange-mask-measured = { $mask }: jede davon könnte der Messwert sein: { $fields }; das Ergebnis des Zyklus ausgeben, wie Q153; sonst braucht die Datei Toleranzangaben mit verschiedenen Grenzmaßen
exchange-print-ambiguous = die Maske kann das auf mehrere Arten lesen
exchange-print-broken = der Ausgabesatz endet zu früh: die Ausgabe von Textzeile { $line } der Maske erwartet
exchange-print-other = die Maske gibt keine solche Textzeile aus, sie enthält aber Zahlen: es kann ein Ausgabesatz mit fehlendem oder geändertem Wert sein; berichtigen oder entfernen
exchange-print-unit = Textzeile { $line } nennt { $unit }, die Ausgabe einer Steuerung wird aber in mm gelesen: die Werte in mm ausgeben
exchange-table-no-part = keine Spalte sagt, zu welchem Teil eine Zeile gehört: die Tabelle einer Serie braucht eine Spalte wie PART oder SERIAL
exchange-table-no-values = keine Spalte enthält Messwerte
exchange-table-no-value = welche Spalte von { $name } der Messwert ist, ist nicht eindeutig
exchange-table-touches = die Zelle in Spalte { $column } berührt ihre Nachbarzelle, eine von beiden kann falsch getrennt sein: mit einem Leerzeichen trennen
exchange-table-unit = die Tabelle ist in Zoll und Spalte { $column } nicht vom Typ LENGTH, ihre Werte können also in mm sein: den Typ LENGTH verwenden
exchange-no-rows = keine Zeile enthält eine Messung
exchange-no-measured-column = keine Spalte mit Messwerten: sie in der ersten Textzeile benennen, wie id;callout;measured
exchange-several-columns = Spalten { $columns } können jeweils { $role } sein: eine mit import --columns wählen, wie { $word }=3, oder die Spalten in der ersten Textzeile so benennen, dass nur eine passt, wie id;callout;measured
exchange-role-id = der Name
exchange-role-tolerance = die Toleranzangabe
exchange-role-nominal = das Nennmaß
exchange-role-measured = der Messwert
exchange-role-time = die Zeit
exchange-role-simulated = die Angabe „simuliert“
exchange-role-number = die Nummer
exchange-role-part = das Teil
exchange-role-serial = die Seriennummer
exchange-role-who = der Bediener
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = die gemessene Größe
exchange-role-upper = das obere Abmaß
exchange-role-lower = das untere Abmaß
exchange-role-minus = das untere Abmaß ohne Minus
exchange-role-maximum = das Höchstmaß
exchange-role-minimum = das Mindestmaß
exchange-role-kind = Bohrung oder Welle
exchange-role-units = die Einheit
exchange-role-status = der Status
exchange-role-machine = die Maschine
exchange-role-batch = das Los
exchange-role-sample = eine Stichprobe
exchange-no-column = { $role } sollte in Spalte { $given } stehen, die Datei hat aber { $columns }
exchange-column-twice = Spalte { $column } kann nicht zugleich { $first } und { $second } sein
exchange-unit = unbekannte Einheit { $unit }: mm, µm oder inch verwenden
exchange-limit = Grenze: { $reason }
exchange-tolerance-unsigned = die Toleranz { $given } hat kein Vorzeichen: ±{ $given } schreiben, oder beide Abmaße, etwa +0.02 0
exchange-minus-again = das untere Abmaß { $given } hat ein Minus, die anderen haben keins: alle mit Vorzeichen schreiben
exchange-limits-contradict = { $callout } hat die Grenzen { $minimum } bis { $maximum }, aber die Spalten sagen { $given }: für die Maßangabe --columns { $columns } angeben, für die Spalten --columns callout=-
exchange-limits-or-deviations = Spalten { $columns } können Grenzen oder Abmaße vom Nennmaß sein: mit --columns wählen, etwa maximum={ $upper },minimum={ $lower } oder upper={ $upper },lower={ $lower }
exchange-limits-or-readings = Spalten { $columns } können Grenzen sein, oder die größte und die kleinste von mehreren Ablesungen: mit --columns wählen, etwa maximum={ $upper },minimum={ $lower } für Grenzen oder maximum=-,minimum=- für Ablesungen
exchange-minus-or-plus = die unteren Abmaße in Spalte { $columns } haben kein Vorzeichen: mit --columns wählen, minus={ $lower } für unter dem Nennmaß oder lower={ $lower } für darüber
exchange-samples-side-by-side = mehrere Messwerte stehen nebeneinander in den Spalten { $columns }: mit fitcheck import lesen, oder einen mit --columns wählen, etwa measured={ $first }
exchange-unit-stated = Textzeile { $line } nennt die Einheit { $unit }, die nicht unterstützt wird („{ $text }“): mm, µm oder inch verwenden, oder die Einheit der Maße wählen (--columns unit=mm)
exchange-unit-mentioned = Textzeile { $line } nennt { $unit } („{ $text }“), nichts sagt aber, ob die Werte in dieser Einheit stehen: die Einheit der Maße wählen (--columns unit=mm, um oder inch)
exchange-units-differ = „{ $at }“ sagt { $unit }, „{ $other-at }“ sagt { $other }: eines von beiden berichtigen
exchange-unit-late = Textzeile { $line } nennt { $unit } („{ $text }“), die Zeilen darüber werden aber in { $read } gelesen: die Einheit über der ersten Zeile nennen oder jene Textzeile berichtigen
exchange-unit-stray = diese Textzeile nennt { $unit } („{ $text }“), alle anderen Zeilen werden aber in { $read } gelesen: die Einheit über der ersten Zeile nennen oder diese Textzeile berichtigen
exchange-unit-given = die gewählte Einheit ist { $given }, die Datei sagt aber { $unit } („{ $text }“): { $unit } wählen oder die Datei berichtigen
exchange-unit-half = Spalte { $column } ist in Inch, und Spalte { $open } nennt ihre Einheit nicht: sie neben beide Namen schreiben oder die Einheit der Maße wählen (--columns unit=inch)
exchange-unit-missing = die Einheit dieser Zeile fehlt: mm, µm oder inch schreiben, oder die Einheit der Maße wählen (--columns unit=mm)
exchange-callout-unit = { $given }: die Zeile ist in Inch, und eine Toleranzangabe mit Maß oder Grenzabmaßen ist in mm: das Nennmaß in eine eigene Spalte neben der Klasse setzen
exchange-row-short = { $expected } Zellen erwartet, { $found } gefunden
exchange-row-long = { $expected } Zellen erwartet, { $found } gefunden: ist das Trennzeichen auch Dezimalzeichen oder Teil eines Textes?
exchange-row-too-long = die Zeile ist länger als { $most } KiB
exchange-open-quote = ein Anführungszeichen ist in dieser Textzeile nicht geschlossen
exchange-header-hides-rows = Textzeile { $line }: der Kopf geht über mehrere Textzeilen, und eine davon sieht wie eine Zeile aus: die Anführungszeichen in der Textzeile schließen, in der sie beginnen
exchange-within-quotes = diese Textzeile kann eine Zeile oder eine Bemerkung sein: Anführungszeichen beginnen darüber und enden hier oder darunter; sie in der Textzeile schließen, in der sie beginnen
exchange-callout = Toleranzangabe: { $reason }
exchange-nominal = Nennmaß: { $reason }
exchange-nominal-differs = Toleranzangabe { $callout } passt nicht zum Nennmaß { $nominal } in der eigenen Spalte
exchange-measured = gemessen: { $reason }
exchange-simulated = simuliert: { $given } ist weder true noch false
exchange-other-header = diese Textzeile nennt andere Spalten als die erste: die Zeilen darunter als eigene Datei beurteilen
exchange-below-other-header = nicht beurteilt: Textzeile { $line } nennt andere Spalten. Die Zeilen darunter als eigene Datei beurteilen
exchange-simulated-below = die Zeilen unter dieser Textzeile sind simuliert: als eigene Datei beurteilen, oder mit fitcheck import
exchange-origin = Herkunft: { $given } sagt weder gemessen noch simuliert; gemessen, eingegeben oder simuliert schreiben, oder simulated=- setzen, wenn diese Spalte etwas anderes sagt
exchange-decimal-sign = gemessen: { $given } hat ein anderes Dezimalzeichen als die anderen Werte: "{ $sign }"
exchange-not-positive = gemessen: ein Durchmesser von { $given } ist nicht größer als 0
exchange-decimal-comma = { $joined } kann eine Zahl mit Dezimalkomma sein: einen Dezimalpunkt oder ein anderes Trennzeichen verwenden
exchange-other-feature = { $given } ist { $feature ->
        [hole] eine Welle, und das sind die Bohrungen: sind die Dateien vertauscht?
       *[shaft] eine Bohrung, und das sind die Wellen: sind die Dateien vertauscht?
    }
exchange-rejected = die Datei selbst verwirft diesen Wert ({ $given }): die Zeile entfernen oder in der Datei berichtigen
exchange-no-part = { $given } nennt eine Kennzahl mehrerer Teile oder ein Einstellnormal eines Messmittels, kein Teil: die Zeile entfernen oder dem Teil einen anderen Namen geben
exchange-other-log = { $feature ->
        [hole] das ist das Messprotokoll einer Welle, und das sind die Bohrungen: sind die Dateien vertauscht?
       *[shaft] das ist das Messprotokoll einer Bohrung, und das sind die Wellen: sind die Dateien vertauscht?
    }
exchange-not-a-size = { $what }: das ist kein Maß, das gepaart werden kann
exchange-no-place-axis = es liegt entlang { $axis }, Zyklen 421 und 422 tasten aber entlang Z an
exchange-no-place-no-axis = die Datei sagt nicht, entlang welcher Achse es liegt
exchange-no-place-kind = { $kind }: Zyklen 421 und 422 tasten nur Kreise und Zylinder an
exchange-no-place-system = es wird im Koordinatensystem { $system } geprüft, die Koordinaten beziehen sich aber auf das der Datei
exchange-contacts-not-sizes = Zeilen mit zwei oder drei Zahlen sind Antastpunkte: die Spalten in der ersten Textzeile benennen, wie id;measured
exchange-too-many-rows = nur die ersten { $most } Zeilen wurden gelesen: die Datei aufteilen
exchange-unjudged-no-callout = nicht beurteilt: keine Toleranzangabe
exchange-unjudged-no-limits = nicht beurteilt: die Grenzmaße im Messprotokoll sind 0, daher wurde der Durchmesser nicht überwacht
exchange-unjudged-coordinate = eine Koordinate aus Zyklus { $cycle }, keine Bohrung oder Welle
exchange-unjudged-coordinate-without-limits = nicht beurteilt: die Grenzmaße im Messprotokoll sind 0, daher wurde die Koordinate nicht überwacht
exchange-unjudged-size = { $what } aus Zyklus { $cycle }, keine Bohrung oder Welle
exchange-unjudged-size-without-limits = nicht beurteilt: die Grenzmaße im Messprotokoll sind 0, daher nicht überwacht: { $what }
exchange-unjudged-point = ein Flächenpunkt aus Zyklus { $cycle }: seine Abweichung entlang der Normalen ist kein Maß
exchange-unjudged-point-without-tolerance = nicht beurteilt: der Punkt wurde ohne Toleranz angetastet
exchange-unjudged-contacts = nicht beurteilt: { $count } Antastpunkte ohne Toleranzangabe
exchange-warning-ignored-columns = übersprungene Spalten: { $columns }
exchange-warning-quantity-unknown = Spalte { $column } hat kein bekanntes Wort für die gemessene Größe ({ $words }): alle ihre Werte werden als Maße gelesen; ist das richtig, import --columns quantity=- angeben
exchange-warning-not-used = übersprungen, keine Messung: { $text }
exchange-warning-minus-supplied = Spalte { $column } hat keine Minuszeichen: ihre Werte gelten als untere Abmaße unter dem Nennmaß
exchange-warning-callouts-unnamed = Spalte { $column } sieht aus, als enthielte sie die Passungen, aber ihr Name ist nicht bekannt: sie Passung nennen oder ihre Nummer mit --columns angeben, etwa callout=2
exchange-warning-limits-read = Spalten { $columns } werden als Grenzen gelesen
exchange-warning-head-read = für alle Werte gelesen: { $said }
exchange-warning-samples-read = Spalten { $columns } werden als Teile nebeneinander gelesen: jeder Wert wird für sich beurteilt, eine leere Zelle ist kein Wert, und ohne Seriennummern ist jede Spalte ein eigenes Teil
exchange-warning-comment = eine Textzeile, die mit # beginnt, ist ein Kommentar, diese enthält aber eine Messung
exchange-warning-several-lines = die Zeile geht in Anführungszeichen über { $lines } Textzeilen
exchange-warning-time = { $given } ist kein Datum mit Uhrzeit: die Zeit des Importierens wird verwendet
exchange-warning-place = { $given } ist keine Länge: die Lage ist übersprungen
exchange-warning-no-time = hier stehen weder Datum noch Uhrzeit: die Zeit des Importierens wird verwendet
exchange-warning-offset = { $given } wird als Ortszeit gespeichert, ohne Abstand zu UTC
exchange-warning-cut-off = die Datei endet hier ohne Zeilenende, und { $given } hat weniger Nachkommastellen als die anderen Werte: vielleicht abgeschnitten
exchange-warning-open-end = die Datei endet hier ohne Zeilenende: ihr letzter Wert, { $given }, ist vielleicht abgeschnitten

# Antastpunkte
contacts-file-empty = die Datei enthält keine Antastpunkte
contacts-no-columns = der Kopf muss x und y nennen und darf z nennen; er ist { $given }
contacts-twice = Spalten { $first } und { $second } sind beide { $name }
contacts-cells = { $wanted } Zellen erwartet, { $cells } gefunden: { $given }
contacts-not-a-number = { $name } ist { $given }, keine Zahl in Millimetern
contacts-row-too-long = die Zeile ist länger als { $most } KiB
contacts-comment = eine Textzeile, die mit # beginnt, ist ein Kommentar, diese enthält aber Koordinaten: das # oder die ganze Textzeile entfernen
contacts-other-unit = Antastpunkte stehen in mm, diese Textzeile nennt aber { $given }: in mm umrechnen
contacts-too-many = die Datei hat mehr als { $most } Antastpunkte
contacts-simulated = diese Antastpunkte sind simuliert und messen nichts: stattdessen eine Werkstückdatei verwenden
contacts-origin = { $given } sagt weder gemessen noch simuliert: gemessen oder simuliert schreiben, oder die Spalte entfernen
contacts-open-quote = ein Anführungszeichen ist nicht geschlossen
contacts-mixed-signs = { $given } hat ein anderes Dezimalzeichen als die Zeilen davor

## Tabellen mit Grenzabmaßen
table-format-name = { $name } beginnt nicht mit einem Buchstaben: Tabellennamen auf einer TNC7 müssen das
table-format-operator = { $name } enthält { $sign }: Tabellennamen auf einer TNC7 dürfen keine Rechenzeichen haben
table-format-warning-lower-sign = das Handbuch von PC-DMIS zeigt kein unteres Grenzabmaß außer 0: { $class } vor der Verwendung in PC-DMIS prüfen, vor allem die Vorzeichen
table-format-csv = die CSV kann nicht geschrieben werden: { $reason }
table-format-parquet-unknown = dieses Programm wurde ohne Parquet gebaut: cargo build --release ohne weitere Optionen baut es ein
table-format-parquet = die Parquet-Datei kann nicht geschrieben werden: { $reason }
table-format-itnc530 = Tabelle der Steuerung für iTNC 530
table-format-tnc640 = Tabelle der Steuerung für TNC 620 und TNC 640
table-format-tnc7 = Tabelle der Steuerung für TNC7
table-format-plain-csv = CSV, eine Textzeile je Klasse und Nennmaßbereich
table-format-plain-parquet = Parquet, eine Zeile je Klasse und Nennmaßbereich
table-format-pcdmis = CSV der ISO-Toleranzen für PC-DMIS

## Grenzmaße als SQL
sql-border = Tabelle { $table }: ein Nennmaßbereich endet bei { $end } mm; als SQL müssen Bereiche bei ganzen Millimetern enden
sql-too-far = Tabelle { $table }: ein Nennmaßbereich endet bei { $end } mm; als SQL müssen Bereiche spätestens bei { $most } mm enden
sql-twice = Klasse { $class } ist zweimal genannt
exchange-correction = der Wert bei 20 °C folgt nicht aus dem Messwert und seinen Temperaturen: die Spalten erwartet, wie Fitcheck sie schreibt
exchange-warning-corrected = Werte mit einer Angabe in der Spalte as_measured_mm gelten schon bei 20 °C
sizes-warning-named-twice = { $rows ->
        [one] eine Zeile hat den Namen einer früheren Zeile
       *[other] { $rows } Zeilen haben den Namen einer früheren Zeile
    }, wie { $id } in den Textzeilen { $first } und { $second }: jede Zeile zählt als ein Teil
sizes-warning-simulated-rows = { $count ->
        [one] 1 Zeile ist simuliert
       *[other] { $count } Zeilen sind simuliert
    }: nichts wurde gemessen
exchange-position-out = die Lage der Mitte war außer Toleranz, die Datei hat aber nur das Maß
exchange-undecided = hier war nichts entschieden: { $given }
exchange-warning-other-rule = die Urteile in dieser Datei können von einer anderen Entscheidungsregel stammen (Spalte rule_name): ihre Werte werden neu beurteilt
exchange-read = der Rest der Datei kann nicht gelesen werden: { $reason }
exchange-too-large = größer als { $most } MiB, die Grenze für Dateien dieses Formats
exchange-unjudged-one-limit = nicht beurteilt: eines der beiden Grenzmaße fehlt
exchange-unjudged-no-tolerance = nicht beurteilt: keine Grenzmaße angegeben
exchange-unjudged-rounded = nicht beurteilt: die ausgegebenen Ziffern stehen für jeden Wert von { $from } bis { $to }, und dazwischen liegt ein Grenzmaß: mehr Nachkommastellen ausgeben
exchange-unjudged-implausible = nicht beurteilt: { $measured } mm kann nicht sein: der Plan nennt { $lower } bis { $upper } mm; Einheit und Dezimalzeichen prüfen oder neu messen
exchange-unjudged-swapped-limits = nicht beurteilt: das untere Grenzmaß { $minimum } liegt über dem oberen Grenzmaß { $maximum }
exchange-unjudged-not-a-size = { $what }: kein Maß einer Bohrung oder Welle
exchange-warning-limits-differ = { $callout } hat die Grenzmaße { $minimum } bis { $maximum }, die Datei hat aber andere: die Grenzmaße der Datei gelten
exchange-warning-class-unknown = Klasse { $given } hat hier keine Grenzmaße: die Grenzmaße der Datei gelten
exchange-warning-status-differs = die Datei sagt { $given }, die Grenzmaße sagen aber { $status }
exchange-warning-status-unknown = die Datei sagt { $given }, und das ist kein bekannter Status: die Grenzmaße sagen { $status }
exchange-warning-limit-differs = die Datei sagt { $given }, die Grenzmaße sind aber { $minimum } bis { $maximum }
exchange-warning-deviation-differs = die Datei sagt { $given }, das ist aber nicht die Abweichung von { $measured } gegenüber { $nominal }
exchange-warning-feature-differs = die Datei sagt { $given }, die Grenzmaße sind aber die { $feature ->
        [hole] einer Bohrung
       *[shaft] einer Welle
    }
exchange-warning-temperature-differs = die Datei sagt { $given }, der Wert gilt aber als bei { $counted } °C gemessen: --temperature und --material angeben
exchange-warning-speaks-of-temperature = die Datei nennt eine andere Temperatur als { $counted } °C, bei der ihre Werte als gemessen gelten: { $text }
exchange-warning-speaks-of-unit = eine Bemerkung nennt eine andere Einheit als die der Werte: { $text }
exchange-warning-speaks-of-simulation = diese Textzeile nennt eine Simulation: prüfen, ob der Wert gemessen wurde: { $text }
exchange-warning-all-nominal = alle { $count } Werte sind genau ihre Nennmaße: das ist vielleicht eine Liste von Maßen, die niemand gemessen hat
exchange-warning-name-of-no-size = { $given } ist nicht der Name eines Maßes eines Teils, der Wert wurde aber als solches beurteilt
exchange-warning-other-values = Spalten mit anderen Maßen nahe den gemessenen werden nicht beurteilt: { $columns }
exchange-warning-part-rejected = die Datei sagt { $given } über das ganze Teil
exchange-warning-uncertainty-not-used = die Datei nennt eine erweiterte Unsicherheit von { $expanded } mm: keine Regel verwendet sie, daher stattdessen --u angeben
exchange-warning-plan-differs = die Datei hat die Grenzmaße { $minimum } bis { $maximum }: die Grenzmaße des Plans gelten
exchange-warning-plan-differs-below = die Datei hat das untere Grenzmaß { $minimum }: das untere Grenzmaß des Plans gilt
exchange-warning-above-own-limit = nicht im Plan, und über dem oberen Grenzmaß seiner Datei, { $maximum }
exchange-warning-below-own-limit = nicht im Plan, und unter dem unteren Grenzmaß seiner Datei, { $minimum }
exchange-warning-plan-differs-above = die Datei hat das obere Grenzmaß { $maximum }: das obere Grenzmaß des Plans gilt
exchange-warning-plan-differs-nominal = die Datei hat das Nennmaß { $nominal }: das Nennmaß des Plans gilt
exchange-warning-part-differs = die Datei nennt Teil { $given }: es wird als { $part } beurteilt, das Teil des Plans
exchange-warning-found-by-number-of = kein Merkmal des Plans heißt { $given }; nach Nummer zugeordnet: { $name } des Plans
exchange-warning-found-by-place-of = kein Merkmal des Plans heißt { $given }; nach Lage zugeordnet: { $name } des Plans
exchange-warning-found-by-number = nach Nummer zugeordnet: { $name } des Plans
exchange-warning-found-by-place = nach Lage zugeordnet: { $name } des Plans
exchange-format-aqdef = AQDEF von Q-DAS, in einer Datei oder als .dfd und .dfx
exchange-format-calypso = CALYPSO-Tabellen mit Merkmalen, wie NAME_chr.txt
exchange-format-calypso-text = Protokolle von CALYPSO, als Text gespeichert
exchange-format-geopak = Toleranzen von MCOSMOS (GEOPAK) in einer Datei ohne Spaltennamen
exchange-format-gauge = Zeilen von Messmitteln in einer Datei, etwa 01A+025.012
exchange-format-pcdmis = Textberichte von PC-DMIS
exchange-format-probed = Ausdrucke von Antastmakros, wie Renishaw und CAM-Systeme sie schreiben
exchange-warning-unit-assumed = keine Einheit angegeben: Längen ohne Einheit werden als mm gelesen
exchange-warning-unit-read = Längen werden in { $unit } gelesen, wie die Datei sagt: { $text }
exchange-warning-rounded = { $given } hat Ziffern unterhalb des Nanometers: auf den nächsten Nanometer gerundet
exchange-warning-rounded-values = { $count ->
        [one] 1 Messwert hat Ziffern unterhalb des Nanometers, ab dieser Textzeile: auf den nächsten Nanometer gerundet
       *[other] { $count } Messwerte haben Ziffern unterhalb des Nanometers, ab dieser Textzeile: auf den nächsten Nanometer gerundet
    }
exchange-unjudged-quantity = { $quantity ->
        [102] Rundheit (K2009 ist 102)
        [109] Position (K2009 ist 109)
        [117] eine Koordinate (K2009 ist 117)
       *[other] eine andere Größe als ein Durchmesser (K2009 ist { $quantity })
    }: kein Maß einer Bohrung oder Welle
exchange-unjudged-kind = nicht gemessen: { $kind ->
        [1] eine Anzahl fehlerhafter Teile (K2004 ist 1)
        [5] eine Fehlersammelkarte (K2004 ist 5)
        [6] eine Fehlersammelkarte (K2004 ist 6)
       *[other] eine unbekannte Art von Merkmal (K2004 ist { $kind })
    }
exchange-unjudged-attribute = nicht beurteilt: gekennzeichnet mit { $given } (K0002); nur von 0 ist bekannt, dass der Wert gültig ist
exchange-unjudged-not-valid = nicht beurteilt: die Datei sagt { $said }, daher gibt es vielleicht keinen gültigen Wert
exchange-unjudged-declaration = nicht beurteilt: Textzeile { $declaration } der Beschreibung ist nicht verwendbar
exchange-format-qif = QIF 2.0, 2.1, 3.0: Ergebnisse von Messsoftware, und Pläne
exchange-xml = kein wohlgeformtes XML: { $reason }
exchange-xml-doctype = ein DOCTYPE wird nicht unterstützt: entfernen, oder die Datei ohne ihn exportieren
exchange-xml-entity = Entität { $name } ist nicht bekannt: nur &lt; &gt; &amp; &quot; und &apos; werden unterstützt
exchange-xml-depth = Grenze von { $most } geschachtelten Elementen erreicht
exchange-xml-long = ein Tag oder Text ist länger als { $most } KiB
exchange-xml-mixed = { $name } hat ein Element mitten im Text
exchange-xml-cut-off = die Datei endet in einem Element: sie ist vielleicht abgeschnitten
exchange-xml-encoding = unbekannte Kodierung { $given }: UTF-8, UTF-16 oder ISO 8859-1 verwenden
exchange-xml-bytes = diese Bytes sind kein Text in der Kodierung der Datei
exchange-qif-unit = Längeneinheit { $unit }: der Name ist unbekannt oder passt nicht zum Faktor; mm, inch oder eine andere Einheit mit ihrem Faktor zu Metern verwenden
exchange-qif-no-unit = die Datei hat keine Längeneinheit: nötig ist FileUnits mit PrimaryUnits und LinearUnit
exchange-qif-reference = { $what } { $id } ist nicht in der Datei
exchange-qif-too-many = die Datei hat mehr als { $most } Elemente { $what }
exchange-qif-no-value = hier kein Messwert; Status { $status }
exchange-qif-limit = Grenzmaße oder Nennmaß: { $reason }
exchange-qif-other-kind = die Messung ist von der Art { $measured }, ihr Merkmal aber von der Art { $defined }
exchange-qif-several-values = die Messung hat mehrere Werte
exchange-qif-defined-as-limit = DefinedAsLimit fehlt oder ist weder true noch false, daher können die Zahlen Grenzmaße oder Grenzabmaße sein
exchange-qif-no-nominal = die Grenzen sind Grenzabmaße, ein Nennmaß gibt es aber nicht
exchange-qif-zone = Klasse { $class } und { $zone } widersprechen einander: Großbuchstaben sind Bohrungen, Kleinbuchstaben sind Wellen
exchange-qif-no-results = eine QIF-Datei ohne Messwerte: ein Plan kann als Prüfplan gelesen werden
exchange-qif-no-characteristics = die QIF-Datei beschreibt keine Merkmale
exchange-warning-standard-uncertainty-not-used = die Datei nennt eine kombinierte Standardunsicherheit von { $standard } und eine mittlere Abweichung von { $mean-error }: keine Regel verwendet sie, daher stattdessen --u angeben
exchange-warning-sheet-hidden = Blatt { $sheet } wird gelesen, obwohl es in der Arbeitsmappe ausgeblendet ist
exchange-warning-rows-hidden = { $count ->
    [one] Zeile { $rows } ist in der Arbeitsmappe ausgeblendet oder ausgefiltert, wird aber wie die anderen gelesen
   *[other] { $count } Zeilen sind in der Arbeitsmappe ausgeblendet oder ausgefiltert, werden aber wie die anderen gelesen: { $rows }
}
exchange-warning-columns-hidden = ausgeblendete Spalten werden wie die anderen gelesen: { $columns }
exchange-warning-qif-version = QIF-Version { $version }: dieses Programm ist für die Versionen 2.0, 2.1 und 3.0 gemacht
exchange-warning-qif-count = { $list } sagt n={ $said }, hat aber { $found }: vielleicht fehlt etwas oder kam etwas hinzu
exchange-warning-qif-twice = id { $id } kommt zweimal vor: das erste Element wird verwendet
exchange-format-xlsx = Messungen in einer Arbeitsmappe einer Tabellenkalkulation: Spalten wie in CSV
exchange-workbook = diese Arbeitsmappe kann nicht gelesen werden: { $reason }
exchange-not-a-workbook = eine ZIP-Datei, aber keine Arbeitsmappe: entpacken und die Dateien darin angeben
exchange-old-workbook = eine Arbeitsmappe im Format { $format }, das nicht unterstützt wird: als XLSX speichern
exchange-workbook-password = die Arbeitsmappe hat ein Kennwort: ohne Kennwort speichern
exchange-zip-cut-off = das Ende der Arbeitsmappe fehlt: sie ist vielleicht abgeschnitten
exchange-zip-members = das Inhaltsverzeichnis der Arbeitsmappe ist beschädigt oder hat mehr als { $most } Angaben
exchange-zip-bomb = { $member } ist entpackt größer als { $most } MiB oder für eine Arbeitsmappe zu stark komprimiert: wird nicht gelesen
exchange-zip-twice = zwei Bestandteile der Arbeitsmappe haben denselben Namen, sie wurde also verändert: in einer Tabellenkalkulation öffnen und speichern
exchange-zip-texts = die Arbeitsmappe hat mehr als { $most } verschiedene Texte
exchange-sheet-wide = Zelle { $cell } liegt hinter den ersten { $most } Spalten
exchange-too-many-cells = das Blatt hat mehr als { $most } Zellen
exchange-cell = { $cell }: { $reason }
exchange-formula-without-value = der Wert der Formel ={ $formula } ist nicht gespeichert: die Arbeitsmappe in einer Tabellenkalkulation öffnen und speichern
exchange-cell-split = der Wert der Zelle ist nicht als ein einfacher Text gespeichert, daher war nur ein Teil davon lesbar: die Arbeitsmappe in einer Tabellenkalkulation öffnen und speichern
exchange-cell-error = die Zelle zeigt { $error }
exchange-warning-sheets-left = Blatt { $sheet } wird gelesen; andere Blätter nicht: { $left }
gauge-frame = die Zeichen um die Textzeile wurden übersprungen
gauge-channel = von Kanal { $channel }
gauge-inches = { $given } Inch
gauge-error-text = { $given } kann eine Fehlernummer des Messmittels sein: ist es ein Maß, mit Einheit schreiben, { $given } mm
gauge-opinion = das Messmittel sagt { $sign }; die Grenzmaße des Plans entscheiden

mapping-no-value = { $given } weist keine Spalte zu: ein Wort, = und eine Spalte schreiben, wie measured=3
mapping-word = { $given } ist kein bekannter Inhalt einer Spalte: zulässig sind { $allowed }
mapping-value = { $word }: { $given } ist unbekannt: zulässig sind { $allowed }
mapping-twice = { $word } ist zweimal angegeben: nur einmal angeben
mapping-toml = keine Zuordnung von Spalten: { $reason }

# Wie ein Wert nach einem Plan beurteilt wurde, und was daneben angegeben war.
planned-rule = nach der Regel des Plans beurteilt statt { $given }: { $rule }
planned-uncertainty = mit der Unsicherheit des Plans beurteilt statt der angegebenen: { $u }
planned-material = mit dem Werkstoff des Plans auf 20 °C korrigiert statt dem angegebenen: { $name }
planned-corrected = von { $temperature } °C auf 20 °C korrigiert (Ausdehnung { $expansion } · 10⁻⁶/K)
planned-not-corrected = nicht auf 20 °C korrigiert: eine Lage am Teil ist kein Maß
planned-error-already-corrected = die Datei sagt, dass der Wert schon bei 20 °C gilt: ohne Temperatur beurteilen

## Gauges
gauge-no-unit = { $given } nennt keine Einheit: in den Einstellungen des Messmittels angeben, ob es Millimeter oder Inch sendet
exchange-gauge-unit = Zeile { $line } dieser Messmittelzeilen, { $given }, nennt weder mm noch Inch: die Einheit mit import --columns unit=mm oder --columns unit=inch angeben
gauge-other-form = { $given } unterscheidet sich in mehr als den Ziffern von der Textzeile, mit der das Messmittel angelernt wurde, { $example }
gauge-other-decimals = { $given } hat { $decimals ->
        [one] 1 Nachkommastelle
       *[other] { $decimals } Nachkommastellen
    }, und die Textzeile, mit der das Messmittel angelernt wurde, hat { $taught }: das Messmittel sendet eine andere Einheit, oder ein Teil der Zahl ging verloren
teach-zero = 0 kann jede Null der Textzeile sein: das Messmittel mit einer Textzeile eines anderen Werts anlernen
teach-not-text = { $line } enthält Zeichen, die kein Text sind
teach-nowhere = { $value } mm steht nicht in der Textzeile { $line }: den Wert eingeben, den das Messmittel dazu anzeigte
teach-twice = { $value } mm steht mehr als einmal in der Textzeile { $line }: das Messmittel mit einer Textzeile eines anderen Werts anlernen
teach-other-unit = die Textzeile sagt { $given }, und das ist nicht { $value } mm: den Wert eingeben, den das Messmittel anzeigte, in Millimetern
