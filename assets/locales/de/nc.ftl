# Dateisätze aus Programmen, Tabellen und Masken für eine Steuerung.
## Pläne
nc-value = { $what }: { $error }
nc-name = Name { $name }: zulässig sind Buchstaben A bis Z, Ziffern und _, höchstens { $most }
nc-not-on-control = { $kind } wird mit Zyklus { $cycle } gemessen, den eine { $control } nicht hat
## Dateisätze
nc-folder = { $folder } ist kein Ordner für Programme: TNC:\ schreiben, dann Namen aus Buchstaben, Ziffern, _ und -, getrennt durch \
nc-no-texts = ein Satz mit Toleranztexten ist nur für TNC7 möglich, nicht für { $control }
nc-series-name = { $name } kann keine Spalte der Serientabelle benennen: den Namen mit einem Buchstaben beginnen und nicht NR, PART oder STATUS verwenden
nc-series-sizes = eine Serie nimmt höchstens { $most } Maße eines Teils auf, der Plan hat { $sizes }: mehrere Dateisätze erstellen
nc-reads-otherwise = { $file } kann nicht so geschrieben werden, dass beim Lesen dasselbe herauskommt
nc-proof = der Dateisatz hat seinen Probelauf nicht bestanden und wurde nicht geschrieben: { $reason }
nc-proof-no-end = das Programm endet nicht
nc-proof-count = { $found } von { $expected } Merkmalen wurden gemessen
nc-proof-other-verdict = { $name }: das Urteil weicht von dem von Fitcheck ab
nc-archive = die Zip-Datei kann nicht erstellt werden: { $reason }
nc-workpiece = das Werkstück kann nicht geschrieben werden: { $reason }
nc-own-column = { $class } ist keine der 47 Klassen der NC-Solution 8255: { $table } erhält eine zusätzliche Spalte
nc-figure = { $what }
nc-fewer-columns = Spaltengrenze einer iTNC 530: { $table } hat nur die Klassen des Plans, { $classes }
nc-by-hand = { $name }: kein Zyklus misst ein Merkmal der Art { $kind }: es ist nicht im Satz
nc-not-in-set = { $name }: der Plan sagt { $said }, der Dateisatz verwendet es aber nicht: auf der Steuerung entscheiden nur die Grenzmaße, daher kann sie GUT sagen, wo fitcheck import es nicht sagt
nc-features = { $first } (und { $more } weitere)
nc-moved-nominal = { $name }: das Nennmaß von { $callout } liegt außerhalb der Grenzmaße, was eine TNC7 nicht annimmt: { $parameter } ist { $value } mm, und { $deviation } bezieht sich darauf
nc-no-place = { $name } braucht x, y und z: das Programm fährt dorthin
nc-own-cycle = { $name } hat einen eigenen Zyklus oder eigene Parameter, die die aufgerufenen Programme nicht unterstützen
nc-no-coordinate = { $column } ist nicht angegeben: das Programm fährt dorthin
