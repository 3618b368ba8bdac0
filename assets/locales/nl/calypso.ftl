## Tabellen van CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = geen gemeten waarde in kolom actual
calypso-cut-off = de laatste regel, END, ontbreekt: het bestand is misschien afgekapt
calypso-warning-no-end = de laatste regel, END, ontbreekt: het bestand is misschien afgekapt
calypso-warning-behind = overgeslagen, na de regel END: { $given }
calypso-warning-cut-off = het bestand eindigt hier zonder regeleinde: de rij is misschien afgekapt
calypso-warning-deviation = de tabel heeft een afwijking van { $given } mm, en haar waarden geven { $expected } mm
calypso-warning-exceed = de tabel heeft { $given } mm buiten de tolerantie, en haar waarden geven { $expected } mm
