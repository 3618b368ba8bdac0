# NC-Programme ausführen.

## Pfade und Dateien
machine-path-empty = der Pfad ist leer
machine-path-too-long = der Pfad hat mehr als { $most } Zeichen, was eine Steuerung nicht zulässt
machine-path-other-root = { $path } ist weder ein Pfad auf TNC: noch ein Pfad ab dem Ordner des Programms
machine-path-leads-out = { $path } führt aus dem Ordner hinaus
machine-path-no-name = { $name } in { $path } ist kein Name für eine Datei oder einen Ordner
machine-store-missing = Datei nicht gefunden: { $path }
machine-store-outside = { $path } führt aus den angegebenen Ordnern hinaus
machine-store-no-file = { $path } ist keine Datei
machine-store-too-large = { $path } ist größer als { $most } MiB
machine-store-ambiguous = { $path } gibt es in mehreren Schreibweisen, { $names }, eine Steuerung hat aber nur eine Datei jedes Namens: die anderen entfernen oder umbenennen
machine-store-elsewhere = { $path } liegt nicht im Ausgabeordner: ein Programm löscht Dateien nur dort
machine-store-read-only = kein Ausgabeordner gewählt
machine-store-system = { $path }: { $reason }

## Fehler
machine-fault-in-block = { $program }, NC-Satz { $number }, { $text }: { $fault }
machine-fault-in-line = { $program }, Textzeile { $line }, { $text }: { $fault }
machine-used-blocks = Grenze von { $most } NC-Sätzen erreicht: möglicherweise Endlosschleife
machine-used-label-calls = Grenze von { $most } geschachtelten Label-Aufrufen erreicht: ruft das Programm sich selbst auf?
machine-used-program-calls = Grenze von { $most } geschachtelten Programmaufrufen erreicht: ruft das Programm sich selbst auf?
machine-used-windows = Grenze von { $most } Fenstern erreicht
machine-used-outputs = Grenze von { $most } Dateiausgaben erreicht
machine-used-output-files = Grenze von { $most } Ausgabedateien erreicht
machine-used-folders = Grenze von { $most } Ordnern für Ausgabedateien erreicht
machine-used-table-writes = Grenze von { $most } Schreibvorgängen geänderter Tabellen erreicht
machine-used-output = Grenze von { $most } ausgegebenen Byte erreicht
machine-used-cycles = Grenze von { $most } Messungen erreicht
machine-used-path = Grenze von { $most } Bewegungen erreicht
machine-used-files = Grenze von { $most } offenen Programmen und geänderten Tabellen erreicht
machine-used-traffic = Grenze von { $most } gelesenen und geschriebenen Byte erreicht
machine-used-file-bytes = Programme und geänderte Tabellen überschreiten zusammen { $most } Byte
machine-text-too-long = der Text hat { $length } Zeichen, ein Parameter fasst höchstens { $most }
machine-unknown-block = unbekannter NC-Satz: Fitcheck führt nur aus, was es versteht
machine-unknown-cycle = Fitcheck bildet Zyklus { $cycle } nicht nach, auch wo die Steuerung ihn hat: nachgebildet sind { $known }
machine-file-open = { $path } ist als Tabelle von FN 26 geöffnet: sie kann nicht kopiert, verschoben oder gelöscht werden
machine-broken = das Programm ist fehlerhaft: { $what } fehlt
machine-no-program = { $path }: { $error }
machine-no-label = { $parameter } = { $value } ist kein Label
machine-no-tool-data = { $parameter } ist nicht definiert: er hält ein Maß des Werkzeugs in der Spindel, das eine Werkzeugtabelle sagt
machine-undefined = { $parameter } ist nicht definiert
machine-lost = { $parameter } ist nicht definiert: Textzeile { $line }, { $text }, setzt ihn vielleicht und wurde nicht ausgeführt
machine-file-unknown = { $path } wird nicht gelesen: Textzeile { $line }, { $text }, schreibt oder entfernt die Datei vielleicht und wurde nicht ausgeführt
machine-tools-unknown = das Werkzeug wird nicht korrigiert: Textzeile { $line }, { $text }, ändert die Werkzeugtabelle vielleicht und wurde nicht ausgeführt
machine-contacts-unknown = nicht bekannt ist, welche erfassten Antastpunkte zu diesem Zyklus gehören: einige gehören vielleicht zu Textzeile { $line }, { $text }, die nicht ausgeführt wurde
machine-not-skipped = dieser NC-Satz entscheidet, was als Nächstes läuft oder was ein anderes Programm erhält: er kann nicht übersprungen werden
machine-whole-only = { $parameter } enthält nur ganze Zahlen, nicht { $value }
machine-no-answer = INPUT "{ $question }" fragt nach { $parameter }: vor dem Lauf einen Wert angeben
machine-no-parameter = Parameter { $parameter } gibt es nicht: Q und QS gehen bis 1999, QL und QR bis 499
machine-no-variable = Variable { $variable } gibt es nicht: { $family } geht von { $least } bis { $most }
machine-not-number = { $parameter } enthält einen Text: eine Zahl erwartet
machine-not-text = { $parameter } enthält eine Zahl: ein Text erwartet
machine-division-by-zero = Division durch null
machine-negative-root = die Quadratwurzel von { $value } ist nicht definiert
machine-no-result = { $function } { $value } ist nicht definiert
machine-beyond-range = { $value } liegt außerhalb des Wertebereichs, -10^10 bis 10^10
machine-not-whole = { $what } = { $value }: eine ganze Zahl ab 0 erwartet
machine-counted-row = Zeile
machine-counted-word = { $word }
machine-behind-text = der Text hat { $length } Zeichen: Position { $from } liegt hinter seinem Ende
machine-no-number-in-text = { $parameter } = "{ $text }" ist keine Zahl
machine-unknown-system-text = unbekannter Systemtext ID{ $id } NR{ $number }: nur Datum und Uhrzeit (ID10321) werden unterstützt
machine-no-table = keine Tabelle geöffnet
machine-several-columns = { $parameter } = { $text } nennt mehrere Spalten: über einen Textparameter kann nur eine gelesen werden
machine-no-column = Tabelle { $table } hat keine Spalte { $column }; ihre Spalten sind { $columns }
machine-no-row = Tabelle { $table } hat keine Zeile { $row }: ihre Zeilen sind 0 bis { $last }
machine-no-rows = Tabelle { $table } hat keine Zeilen
machine-empty-cell = Tabelle { $table }, Zeile { $row }, Spalte { $column }: die Zelle ist leer
machine-no-number-in-cell = Tabelle { $table }, Zeile { $row }, Spalte { $column }: { $cell } ist keine Zahl
machine-touches = Tabelle { $table }, Zeile { $row }, Spalte { $column }: die Zelle läuft in ihre Nachbarin, daher ist ihr Wert unsicher
machine-table-write = Tabelle { $table }: { $error }
machine-mask = Maske { $mask }: { $error }
machine-programmed = das Programm hat sich selbst mit Fehler { $number } angehalten
machine-no-cycle-parameter = Zyklus { $cycle } hat keinen Parameter { $parameter }
machine-cycle-parameter-twice = Zyklus { $cycle }: { $parameter } ist zweimal angegeben
machine-cycle-parameter-for = Zyklus { $cycle }: { $parameter } ist zweimal angegeben, und { $other } gar nicht: ist das zweite als { $other } gemeint?
machine-global-not-number = GLOBAL DEF { $number }: { $parameter } hat keine Zahl
machine-global-twice = GLOBAL DEF { $number }: { $parameter } ist zweimal angegeben
machine-open-subprogram = das Programm endet in dem Unterprogramm, das in Textzeile { $line } aufgerufen wird: LBL 0 fehlt
machine-repeat-ahead = REP wiederholt den Teil zwischen einem Label und diesem NC-Satz, das Label steht aber dahinter, in Textzeile { $line }
machine-cycle = Zyklus { $cycle }: { $error }
machine-workpiece = Werkstück: { $error }
machine-no-tool-call = vor diesem Messzyklus steht kein TOOL CALL mit einer Werkzeugachse
machine-mode = die Steuerung ist in der Betriebsart { $mode }: Messzyklen laufen nur im Fräsbetrieb (FUNCTION MODE MILL)
machine-changed = { $change } wirkt seit Textzeile { $line }, { $text }: währenddessen misst Fitcheck nicht
machine-nothing-selected = vor CALL SELECTED PGM steht kein SEL PGM
machine-no-datum-table = der Bezugspunkt käme in Zeile { $row } der aktiven Nullpunkttabelle (Q303 = 0), die nur die Steuerung hat: hier kann von ihm aus nichts gemessen werden
machine-datum-in-tilt = seit Textzeile { $line }, { $text }, ist die Ebene geschwenkt: darin setzt Fitcheck keinen Bezugspunkt, weil nicht bekannt ist, was eine Steuerung dort schreibt; vor dem Zyklus die Ebene zurücksetzen (PLANE RESET)
machine-point-without-part = die Zyklen 0 und 1 tasten einen einzelnen Punkt an, und ein ideales Werkstück hat keinen: ein simuliertes Werkstück oder aufgezeichnete Antastpunkte wählen
machine-point-from-nowhere = von wo angetastet wird, ist nicht in allen Achsen bekannt: X, Y und Z in den Satz schreiben
machine-no-preset = { $table } hat keine Zeile { $row }
machine-preset-locked = { $table }: Zeile { $row } ist gesperrt, der Zyklus kann sie nicht beschreiben
machine-shifted-preset = Zeile { $row } ist der aktive Bezugspunkt, und eine Nullpunktverschiebung ist aktiv: was eine Steuerung aus ihr macht, ist nicht bekannt
machine-change-not-known = ein unbekannter Bezugspunkt
machine-change-turning = das gedrehte System von Zyklus 800
machine-change-datum-table = eine Verschiebung aus einer Nullpunkttabelle
machine-change-rotation = eine Drehung
machine-change-mirror = eine Spiegelung
machine-change-scaling = ein Maßfaktor
machine-change-axis-scaling = ein achsspezifischer Maßfaktor
machine-change-tilt = eine geschwenkte Ebene
machine-change-tilted-shift = eine Verschiebung aus einer Ebene, die nicht mehr geschwenkt ist
machine-change-axis-turned = eine Drehung des Teils mit einer Drehachse, nach der noch nicht beide Achsen der Ebene einen neuen Bezugspunkt haben,

## Hinweise
machine-file-from = { $path } wurde aus { $file } gelesen
machine-file-given = { $path } wurde gelesen
machine-file-built-in = { $path } ist mitgeliefert
machine-remark-skipped = unbekannter NC-Satz übersprungen
machine-remark-cycle-passed-over = dieser Zyklus kalibriert den Taster oder vermisst ein Werkzeug: er wurde übergangen. Was er zurückgibt, ist ab hier nicht definiert, wenn es nicht vor dem Lauf gegeben wurde (--set Q115=0)
machine-remark-measurement-skipped = diese Messung wurde übersprungen: ihre Ergebnisse sind ab hier nicht definiert
machine-remark-datum-skipped = diese Messung wurde übersprungen: ihre Ergebnisse sind ab hier nicht definiert, und danach wird nichts gemessen, da sie einen Bezugspunkt setzen kann
machine-remark-not-followed = dieser NC-Satz wird nicht ausgeführt und ändert vielleicht den Bezugspunkt: danach wird nichts gemessen
machine-remark-no-system-data = { $parameter } ist ab hier nicht definiert: nur eine Steuerung kennt die Systemdaten von FN 18
machine-remark-axis-assumed = vor diesem Zyklus steht kein TOOL CALL: entlang Z mit dem ersten Tastsystem gemessen
machine-remark-measured-again = nach Nacharbeit neu gemessen: diese Messung zählt
machine-remark-spindle-turns = die Spindel dreht seit M{ $function }: eine Steuerung würde nicht antasten
machine-remark-rotary-moved = { $axes } vor diesem Zyklus bewegt: das Werkstück wurde gemessen, als wäre es nicht gedreht
machine-remark-other-preset = Bezugspunkt { $number }: das Werkstück ist auch dort angenommen
machine-remark-rotation-ended = die Grunddrehung von { $angle } ist beendet: dieser Zyklus misst ohne sie, und sie bleibt aus
machine-remark-axes-as-tilted = die Ebene ist geschwenkt: es wird angenommen, dass die Drehachsen so stehen, wie sie es braucht
machine-remark-machine-zero-assumed = FN 18 fragt nach einem Ort vom Nullpunkt der Maschine: wo der liegt, ist hier nicht bekannt, und es zählt der des Werkstücks
machine-remark-datum-set = Bezugspunkt gesetzt: sein Nullpunkt liegt jetzt bei { $zero } mm in den Koordinaten des Werkstücks
machine-remark-preset-set = Zeile { $row } der Bezugspunkttabelle auf { $zero } mm in den Koordinaten des Werkstücks gesetzt: sie wirkt mit Zyklus 247
machine-remark-active-preset-set = Zeile { $row } ist der aktive Bezugspunkt: sein Nullpunkt liegt jetzt bei { $zero } mm in den Koordinaten des Werkstücks; auf einer iTNC 530 erst nach Zyklus 247
machine-remark-presets-left = { $path } bleibt, wie sie ist: kein Zyklus 247 davor sagt, welche Zeile aktiv ist, und so ist nicht bekannt, wo das Werkstück auf der Maschine liegt
machine-remark-shift-ended = die Nullpunktverschiebung endet in { $axes }, ohne dass dort gemessen wurde, wie auf einer TNC7: eine iTNC 530 behält sie vielleicht
machine-remark-built-in = { $path } ist nicht unter den angegebenen Dateien: die mitgelieferte wurde gelesen
machine-remark-other-names = { $read } wurde gelesen, es gibt aber auch { $others }: eine Steuerung hat nur eine Datei jedes Namens
machine-remark-read = { $path }: { $what }
machine-remark-other-spelling = Tabelle { $table } hat keine Spalte { $column }: { $other } wurde verwendet, die andere Schreibweise in NC-Solution 8255
machine-remark-row-number = Tabelle { $table }: NR ist { $found } in Zeile { $row }: FN 27 und FN 28 zählen Zeilen ab 0
machine-remark-length-converted = Tabelle { $table }: Spalte { $column } ist eine LENGTH und wurde zwischen mm und Inch umgerechnet
machine-remark-ended-within = M{ $function } in einem aufgerufenen Programm hat den Lauf beendet: eine Steuerung lässt es dort nicht zu
machine-remark-given-wins = { $parameter } = { $value } wurde vor dem Lauf angegeben und ersetzt den Wert dieses NC-Satzes
machine-remark-given-without-effect = { $parameter } wurde vor dem Lauf angegeben und hatte keine Wirkung: kein NC-Satz hat ihn gelesen
machine-remark-doubted = { $what }
machine-remark-measured = { $what }
machine-remark-filled = der NC-Satz lässt { $parameters } weg: diese Werte wurden verwendet, eine Steuerung nimmt den NC-Satz aber vielleicht nicht an
machine-remark-measurement-behind-end = { $count ->
        [one] ein Messzyklus steht
       *[other] { $count } Messzyklen stehen
    } nach diesem NC-Satz, an dem eine Steuerung zu lesen aufhört: danach wurde nichts gemessen
machine-remark-cycle-skipped = dieser Messzyklus wurde wegen des / davor wie gewünscht übersprungen
machine-remark-rounded = Tabelle { $table }, Spalte { $column }: { $value } wurde auf { $written } gerundet
machine-remark-not-judged = hier kein Urteil: nichts wurde mit Grenzmaßen verglichen
machine-remark-not-written = { $path } wurde nicht geschrieben: kein Ausgabeordner gewählt
machine-remark-deleted = { $path } wurde vom Programm gelöscht
machine-remark-not-deleted = { $path } wurde nicht gelöscht: kein Ausgabeordner gewählt
machine-remark-other-device = { $given } ist ein anderes Gerät: die Datei ist { $path }
machine-remark-screen-meant = SCREEN gilt als Name einer Datei: war SCREEN: gemeint?
machine-remark-empty-mask = die Maske { $mask } ist leer: so auch, was sie ausgibt
machine-remark-not-saved = { $path } wurde nicht geschrieben: { $reason }
machine-remark-full = { $path } hat die Grenze von { $kilobytes } Kilobyte erreicht: nichts wurde hinzugefügt
machine-remark-table-written = { $path } wurde geschrieben
machine-remark-contacts-left = die Zyklen haben { $used } von { $count } erfassten Antastpunkten verwendet
machine-remark-more = { $count } weitere Hinweise werden nicht angezeigt
machine-remark-empty-spindle = Werkzeug 0 wurde aufgerufen: eine TNC7 hat dann kein Tastsystem in der Spindel
machine-remark-no-tool-named = kein TOOL CALL vor diesem Zyklus nennt ein Werkzeug: mit dem ersten Tastsystem gemessen
machine-remark-tool-call-words = TOOL CALL nimmt { $words } nicht: übersprungen
machine-remark-no-nominal = der Zyklus hat kein Nennmaß: das Tastsystem trifft das ideale Werkstück auf halbem Weg entlang K
machine-remark-other-probe = Werkzeug { $tool } steht nicht in der Tastsystemtabelle: Tastsystem { $probe } wurde verwendet
machine-remark-collision = Kollision: { $mover } würde { $feature } berühren, mit der Kugelmitte bei X { $x } Y { $y } Z { $z } mm
machine-remark-unchecked = Bewegungen werden nicht vollständig gegen { $features } geprüft
machine-remark-stylus-unchecked = der Taststift wird nicht auf Kollisionen geprüft: er steht nicht in Richtung Z
machine-remark-tool-offsets = { $offsets } des TOOL CALL ändert das simulierte Tastsystem nicht
machine-remark-tool-locked = Werkzeug { $tool } ist in der Werkzeugtabelle gesperrt
machine-remark-no-probe-tool = Werkzeug { $tool } ist kein Tastsystem: TYP = { $kind }, { $probe } erwartet
machine-remark-no-such-tool = Werkzeug { $tool } steht nicht in der Werkzeugtabelle
machine-remark-same-name = { $more ->
    [one] ein weiteres Werkzeug hat den Namen { $tool }
   *[other] { $more } weitere Werkzeuge haben den Namen { $tool }
}: das erste in der Werkzeugtabelle wurde verwendet
machine-remark-content-uncertain = { $parameter } wird hier gelesen, nirgends ist aber beschrieben, dass darin der Durchmesser steht
machine-remark-not-waited = { $parameter } wird nach dem Zyklus ohne G909 gelesen: eine Steuerung liest NC-Sätze voraus und hat vielleicht noch nicht gemessen
machine-remark-position-unknown = die Position vor dem Zyklus ist nicht bekannt: ohne D beginnt er an der Sollmitte, ohne WB auf Höhe 0

machine-passed-over = { $count } { $count ->
        [one] NC-Satz
       *[other] NC-Sätze
    } ohne Einfluss auf eine Messung { $count ->
        [one] wurde
       *[other] wurden
    } nicht ausgeführt: { $list }

## Pausen
machine-pause-stop = das Programm hat angehalten: STOP oder M0
machine-pause-optional-stop = das Programm hat angehalten: M1
machine-pause-breakpoint = der nächste NC-Satz hat einen Haltepunkt
machine-pause-log = das Messprotokoll steht am Bildschirm (Q281 = 2)

## Ein NC-Satz eines Messzyklus ohne sein Programm
alone-moved = { $text } bewegt den Antastzyklus danach oder ändert seine Achsen, der Zyklus wird aber ausgeführt, als geschähe das nicht: stattdessen das ganze Programm ausführen
alone-called = { $text } führt NC-Sätze aus, die den Antastzyklus danach bewegen können, sie werden aber nicht gelesen: stattdessen das ganze Programm ausführen
alone-not-understood = { $text } wird nicht verstanden und kann den Antastzyklus danach bewegen: das Programm prüfen oder als Ganzes ausführen
alone-not-run = das Programm geht nicht weiter als { $text } und erreicht den Antastzyklus danach nicht, daher misst eine Steuerung hier nicht: das Programm prüfen
alone-passed = { $text } kann am Antastzyklus vorbeiführen, daher misst eine Steuerung hier vielleicht nicht: stattdessen das ganze Programm ausführen
alone-skipped = eine Steuerung überspringt den Antastzyklus vielleicht wegen des / davor: muss er gemessen werden, das / löschen
