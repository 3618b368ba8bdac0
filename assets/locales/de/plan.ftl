# Pläne von Merkmalen: was an einem falsch ist.

plan-no-features = der Plan hat keine Merkmale
plan-no-form-limit = { $text } ist keine Grenze einer Form- oder Lagetoleranz: eine Länge über 0 in mm angeben, etwa 0.02
plan-too-many = der Plan hat mehr als { $most } Merkmale
plan-too-large = ein Plan hat höchstens { $most } KiB
plan-no-column = Spalte { $column } fehlt
plan-unknown-column = unbekannte Spalte { $column }: die Spalten sind { $known }
plan-column-twice = Spalte { $column } kommt zweimal vor
plan-cells = die Zeile hat { $found } Zellen und der Kopf { $expected }: bei Dezimalkomma die Spalten mit Semikolon trennen
plan-no-cell = { $column } fehlt
plan-value = { $what }: { $error }
plan-no-feature = { $callout } kann Bohrung oder Welle sein: feature = "hole" oder feature = "shaft" hinzufügen, oder kind = "length", wo es keins von beiden ist
plan-fit = { $callout } ist eine Passung: Bohrung und Welle als zwei Merkmale schreiben
plan-clearance-height = sichere Höhe { $height } mm liegt nicht über der Messhöhe, { $z } mm
plan-same-name = Name { $name } kommt zweimal vor{ $line ->
    [0] : Dateinamen auf einer Steuerung unterscheiden Groß- und Kleinschreibung nicht
   *[other] , zuerst in Textzeile { $line }: Dateinamen auf einer Steuerung unterscheiden Groß- und Kleinschreibung nicht
}
plan-unknown = { $column } { $given } ist nicht bekannt: { $known } erwartet
plan-other-side = Art { $given } widerspricht { $column } { $text }; das gehört zu einer { $side ->
    [hole] Bohrung
   *[shaft] Welle
    }: eines von beiden berichtigen, oder diameter schreiben
plan-not-of = zu { $kind } gehört kein { $column }
plan-direction = Achse { $given } ist keine Richtung: { $known } erwartet, oder drei Zahlen wie 0.5 0 -1, von -10 bis 10 mit höchstens 9 Nachkommastellen und nicht alle 0
plan-no-band = { $text } ist keine Toleranz für einen Punkt, wie ±0.05 oder +0.1/-0.05: { $error }
plan-band-side = ein Punkt kann keine Grenzabmaße von { $lower } bis { $upper } mm haben: der Zyklus braucht ein oberes von mindestens 0 und ein unteres von höchstens 0, nicht beide 0
plan-side-class = { $callout }: bei { $kind } brauchen beide Seiten Klassen wie { $example }
plan-face-class = { $callout }: eine Fläche wird als Außenmaß beurteilt und braucht eine Klasse für Wellen, wie h9
plan-face-place = { $callout }: die Fläche liegt entlang der Messachse bei { $coordinate } mm; das muss ihr Nennmaß sein
plan-not-a-plan = das ist kein Plan: ein Plan hat eine Textzeile mit den Namen seiner Spalten, wie name;callout;x;y;z, oder beginnt mit fitcheck_plan = 1
plan-other-version = dieser Plan hat Version { $given }: Versionen 1 bis { $newest } werden unterstützt
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = unbekannter Schlüssel { $key }: { $known } erwartet
plan-other-value = { $key }: { $expected } erwartet, { $found } gefunden
plan-parameter = Zyklus { $cycle } nimmt { $given } nicht aus einem Plan: NAME=WERT mit einem von { $known } schreiben
plan-no-parameter = kein Messzyklus nimmt { $given } aus einem Plan: NAME=WERT schreiben, wie Q423=3
plan-travel = { $axis }{ $given } liegt außerhalb des Verfahrwegs der Maschine, { $minimum } bis { $maximum } mm
plan-clearance-travel = das Tastsystem fährt auf Z{ $height }, außerhalb des Verfahrwegs der Maschine, { $minimum } bis { $maximum } mm: eine andere clearance_height angeben
plan-no-travel = { $given } ist kein Verfahrweg: zwei Zahlen schreiben, die kleinere zuerst, wie -250 250
plan-no-plausible = { $column }: { $given } ist kein Bereich: zwei Längen in mm schreiben, die kleinere zuerst, wie 24.5 25.5
plan-plausible-limits = { $column }: { $lower } bis { $upper } mm enthält die Grenzmaße nicht, { $minimum } bis { $maximum } mm: einen größeren Bereich angeben
plan-text = { $column }: eine Zeile mit höchstens { $most } Zeichen erwartet
plan-same-number = { $line ->
    [0] Nummer { $number } kommt zweimal vor: ein anderes Merkmal hat { $other }
   *[other] Nummer { $number } kommt zweimal vor: das Merkmal in Textzeile { $line } hat { $other }
}
plan-same-size = { $line ->
    [0] ein Wert { $called } könnte zu diesem Merkmal oder zu { $other } gehören: eines umbenennen
   *[other] ein Wert { $called } könnte zu diesem Merkmal oder zu { $other } in Textzeile { $line } gehören: eines umbenennen
}
plan-number-is-name = { $line ->
    [0] Nummer { $number } ist der Name eines anderen Merkmals, { $other }
   *[other] Nummer { $number } ist der Name eines anderen Merkmals, { $other } in Textzeile { $line }
}
plan-name-is-number = { $line ->
    [0] ein Wert { $called } könnte zu diesem Merkmal gehören oder zu { $other }, dessen Nummer das ist
   *[other] ein Wert { $called } könnte zu diesem Merkmal gehören oder zu { $other } in Textzeile { $line }, dessen Nummer das ist
}
plan-balloon = { $given } ist keine Stelle im Bild: 0 bis 1 erwartet
plan-not-found-unknown = nicht beurteilt: kein Merkmal des Plans hat diesen Namen, diese Nummer oder diese Lage
plan-not-found-no-clue = nicht beurteilt: der Wert hat weder Name noch Nummer noch Lage, daher passt er zu keinem Merkmal des Plans
plan-not-found-half-place = nicht beurteilt: kein Merkmal des Plans hat diesen Namen oder diese Nummer, und eine Lage braucht X und Y
plan-not-found-contradiction = nicht beurteilt: der Name passt zu { $name } des Plans, die Nummer aber zu { $number }
plan-not-found-other-name = kein Merkmal des Plans heißt { $given }; { $name } hat dieselbe Nummer, sie kann aber eine laufende Nummer sein: das Merkmal wie im Plan benennen oder sein Nennmaß angeben
plan-not-found-running-number = nicht beurteilt: nur die Nummer passt zu { $name } des Plans, und sie kann eine laufende Nummer sein, denn andere Zeilen der Datei gehören nicht zu diesem Plan
plan-not-found-other-nominal = nicht beurteilt: der Wert passt zu { $name } des Plans, sein Nennmaß ist aber { $given } und das des Plans { $planned }
plan-not-found-other-limits = nicht beurteilt: der Wert passt zu { $name } des Plans, seine Grenzmaße { $given } haben aber nichts gemeinsam mit denen des Plans { $planned }
plan-not-found-several = nicht beurteilt: mehrere Merkmale des Plans haben diese Lage: { $names }
plan-not-found-which-side = nicht beurteilt: der Wert sagt nicht, zu welchem er gehört: { $names }
part-standing = { $measured } gemessen, { $missing } fehlen, { $skipped } übersprungen
plan-not-found-other-kind = nicht beurteilt: der Wert passt zu { $name } des Plans, das ist aber { $kind }, und gemessen wurde etwas anderes
plan-remark-file = { $said }
plan-remark-left = { $name } ist übersprungen: { $why }
plan-remark-class-left = { $name }: { $class } hat andere Grenzmaße als die Datei; die Grenzmaße der Datei gelten
plan-remark-place-left = { $name }: keine Position übernommen: { $why }
plan-remark-axes-assumed = Positionen: die Datei sagt nicht, entlang welcher Achsen ihre Bohrungen und Wellen liegen; Z ist angenommen
plan-remark-uncertainty-left = { $name }: die erweiterte Unsicherheit von { $expanded } mm ist übersprungen, da ihre Hälfte keine ganze Zahl von Nanometern ist
plan-remark-clearance-raised = { $name } liegt über der üblichen sicheren Höhe: { $height } ist eingetragen
plan-simulated-no-place = { $name } hat keine Lage im Plan: kann nicht simuliert werden
plan-simulated-no-cycle = kein Zyklus misst { $name }: kann nicht simuliert werden
