## Afgedrukte rapporten
printed-no-value = geen gemeten waarde onder { $column }
printed-cells = { $found } getallen onder { $expected } kolommen: het is niet duidelijk welk getal in welke kolom staat; druk het rapport met alle kolommen af
printed-no-column = geen kolom { $column }: voeg de gemeten waarden toe aan het afdrukformaat van het rapport
printed-no-heading = getallen zonder kop erboven: het begin van de maat ontbreekt
printed-no-rows = { $name } heeft geen rij: het rapport is misschien afgekapt
printed-minus-sign = de mintolerantie { $given } kan onder of boven de nominale waarde liggen, en geen andere rij beslist: druk mintoleranties zonder teken af
printed-unknown-row = onbekende as { $given }: de rij is overgeslagen
printed-warning-deviation = het rapport heeft een afwijking van { $given } mm, maar de getallen geven { $expected } mm
printed-warning-beyond = het rapport heeft { $given } mm buiten de tolerantie, maar de getallen geven { $expected } mm
printed-warning-no-end = de laatste regel, { $end }, ontbreekt: het rapport is misschien afgekapt
printed-warning-lines = overgeslagen, geen meting: { $text } (regels van deze soort in totaal: { $count })
printed-warning-out-of-place = het rapport zegt { $given }, en geen van de grenswaarden die hier gelezen zijn zegt dat: kijk in het rapport
