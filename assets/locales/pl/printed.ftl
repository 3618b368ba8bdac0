## Printed reports
printed-no-value = pod { $column } nie ma wartości zmierzonej
printed-cells = liczby: { $found }, kolumny: { $expected }; nie wiadomo, która liczba należy do której kolumny: wydrukować raport ze wszystkimi kolumnami
printed-no-column = brak kolumny { $column }: dodać wartości zmierzone do formatu wydruku raportu
printed-no-heading = liczby bez nagłówka nad nimi: brakuje początku wymiaru
printed-no-rows = { $name } nie ma żadnego wiersza: raport może być ucięty
printed-minus-sign = tolerancja dolna { $given } może leżeć poniżej lub powyżej wartości nominalnej i żaden inny wiersz tego nie rozstrzyga: drukować tolerancje dolne bez znaku
printed-unknown-row = nieznana oś { $given }: wiersz pominięto
printed-warning-deviation = raport ma odchyłkę { $given } mm, a z jego liczb wynika { $expected } mm
printed-warning-beyond = raport ma { $given } mm poza tolerancją, a z jego liczb wynika { $expected } mm
printed-warning-no-end = brakuje ostatniej linii, { $end }: raport może być ucięty
printed-warning-lines = pominięto, to nie pomiar: { $text } (linii tego rodzaju łącznie: { $count })
printed-warning-out-of-place = raport mówi { $given }, a nie wynika to z żadnej z odczytanych tu granic: sprawdzić w raporcie
