# NC-Programme

## Lesen
program-empty = das Programm ist leer
program-too-large = das Programm ist größer als { $most } MiB
program-too-many-lines = das Programm hat mehr als { $most } Textzeilen
program-binary = die Datei ist kein Text: { $controls } ihrer { $bytes } Bytes sind keine Zeichen
program-no-begin = das Programm beginnt nicht mit BEGIN PGM
program-second-begin = zweites BEGIN PGM
program-no-end = END PGM fehlt
program-units = END PGM sagt { $end }, BEGIN PGM sagt { $begin }
program-after-end = Text nach END PGM gehört nicht zum Programm
program-no-section = { $section } fehlt
program-no-unit = der Kopf nennt die Maßeinheit nicht (#EINHEIT METRISCH / INCH): das Programm wird in mm gelesen
program-after-last-section = nach ENDE / END dürfen nur Unterprogramme folgen
program-unclosed-comment = dem Kommentar fehlt die schließende Klammer ]
program-numbers = Satznummer { $number } folgt auf { $previous }; Satznummern außer der Reihe: { $count }
program-label-again = LBL { $label } ist schon in Textzeile { $first } definiert
program-unclosed-quote = das Anführungszeichen ist nicht geschlossen
program-open-end = die Textzeile endet mit ~, aber nichts folgt
program-cycle-cut = Zyklus { $cycle } endete in Textzeile { $line }, an deren Ende kein ~ steht: { $parameter } gehört nicht dazu und würde stattdessen zugewiesen
program-no-star = der NC-Satz endet nicht mit *
program-iso-no-end = der letzte NC-Satz fehlt: % mit dem Namen des Programms
program-iso-units = der letzte NC-Satz sagt { $end }, der erste { $begin }
program-iso-after-end = Text nach dem letzten NC-Satz gehört nicht zum Programm
program-iso-cycle-cut = Zyklus { $cycle } endete in Textzeile { $line }: { $parameter } gehört nicht dazu und würde stattdessen zugewiesen
program-comment-holds = { $found } gehört zum Kommentar, der am Ende seiner Textzeile endet
program-cycle-without-tilde = Zyklus { $cycle } endete in Textzeile { $line }, an deren Ende kein ~ steht: die Textzeilen darunter werden als Teil davon gelesen
program-block-goes-on = der NC-Satz darüber endet mit ~, daher würde dieser NC-Satz dazugehören
program-comment-goes-on = der Kommentar endet mit ~, daher würde dieser NC-Satz dazugehören
program-not-understood = nicht verstanden: { $reason }
program-more = { $count } weitere Hinweise werden nicht angezeigt

## Label
program-label-missing = LBL { $label } kommt im Programm nicht vor
program-label-twice = LBL { $label } ist zweimal definiert, in Textzeile { $first } und Textzeile { $second }
program-label-zero = LBL 0 beendet ein Unterprogramm: kein Sprung kann dorthin führen
program-label-parameter = welches Label { $label } enthält, ist erst beim Lauf des Programms bekannt

## Warum ein NC-Satz nicht verstanden wird
program-missing = { $wanted } fehlt
program-unexpected = { $wanted } erwartet, { $found } gefunden
program-left-over = unerwarteter Text { $found }
program-unknown-function = { $found } ist keine Funktion
program-number-size = { $found } ist zu groß
program-parameter-range = { $found } ist kein Parameter: { $family } geht von { $least } bis { $most }
program-range = { $found } ist zu groß: höchstens { $most }
program-label-of-parameter = { $parameter } kann nicht der Name des Labels sein, das hier beginnt
program-relation = FN { $number } vergleicht mit { $allowed }: { $found } gefunden
program-not-together = { $one } und { $other } können nicht im selben NC-Satz stehen
program-unknown-word = { $found } ist nicht bekannt
program-no-form = die ISO-Form von { $found } ist nicht bekannt
program-measure-unknown = nicht bekannt ist, ob hier G90 oder G91 wirkt
program-and-with-or = AND und OR in einer Bedingung brauchen Klammern, die zeigen, was zuerst gilt
program-letter-twice = { $letters } ist zweimal angegeben
program-second-unit = vorher wurde eine andere Unit angegeben
program-acts-in-unit = Units bleiben ohne Einfluss, aber dieser NC-Satz misst, ruft auf oder setzt eine Variable
program-shifts-in-unit = Units bleiben ohne Einfluss, aber dieser NC-Satz kann den Nullpunkt verschieben
program-alone = { $found } ohne { $missing }
program-axis-twice = eine Achse ist zweimal angegeben
program-too-deep = Klammern und Funktionen sind mehr als { $most } Ebenen tief geschachtelt
program-too-many-operands = die Formel hat mehr als { $most } Operanden
program-too-long = der NC-Satz hat mehr als { $most } Zeichen
program-too-much = Formeln und lange NC-Sätze brauchen zusammen mehr als { $most } MiB
program-wanted-word = { $word }
program-wanted-number = eine Zahl
program-wanted-value = eine Zahl oder ein Q-Parameter
program-wanted-value-or-variable = eine Zahl oder eine Variable
program-wanted-variable = eine Variable (#l, #c, #g, #x, #i)
program-wanted-parameter = ein Parameter
program-wanted-number-parameter = ein Q-, QL- oder QR-Parameter
program-wanted-text-parameter = ein QS-Parameter
program-wanted-text = ein Text in Anführungszeichen oder ein QS-Parameter
program-wanted-label = ein Label
program-wanted-path = ein Pfad
program-wanted-relation = EQU, NE, GT, LT oder IS
program-wanted-unit = MM oder INCH
program-wanted-cycle-value = ein Wert
