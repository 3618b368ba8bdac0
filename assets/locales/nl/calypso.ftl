## Tabellen van CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = geen gemeten waarde in kolom actual
calypso-cut-off = de laatste regel, END, ontbreekt: het bestand is misschien afgekapt
calypso-row-cut-off = het bestand eindigt hier zonder regeleinde, dus de rij is misschien afgekapt: overgeslagen; zet er een regeleinde achter als de rij volledig is
calypso-zeros = de regel heeft bytes met waarde 0, dus het bestand is niet volledig geschreven: de rij is overgeslagen
calypso-differs = de rijen van { $name } in regel { $first } en { $second } hebben verschillende nominale waarden of grensmaten
calypso-warning-no-end = de laatste regel, END, ontbreekt: het bestand is misschien afgekapt
calypso-warning-behind = overgeslagen, na de regel END: { $given }
calypso-warning-zeros = het bestand heeft hier bytes met waarde 0, dus het is niet volledig geschreven: misschien ontbreken er rijen
calypso-warning-deviation = de tabel heeft een afwijking van { $given } mm, maar de waarden geven { $expected } mm
calypso-warning-exceed = de tabel heeft { $given } mm buiten de tolerantie, maar de waarden geven { $expected } mm
