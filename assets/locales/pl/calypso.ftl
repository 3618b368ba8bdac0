## Tables of CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = w kolumnie actual nie ma wartości zmierzonej
calypso-cut-off = brakuje ostatniej linii, END: plik może być ucięty
calypso-row-cut-off = plik kończy się tu bez końca linii, więc wiersz może być ucięty: pominięto go; jeśli jest kompletny, dodać koniec linii
calypso-zeros = linia ma bajty o wartości 0, więc plik nie został zapisany w całości: wiersz pominięto
calypso-differs = wiersze { $name } w liniach { $first } i { $second } mają różne wartości nominalne lub granice
calypso-warning-no-end = brakuje ostatniej linii, END: plik może być ucięty
calypso-warning-behind = pominięto po linii END: { $given }
calypso-warning-zeros = plik ma tu bajty o wartości 0, więc nie został zapisany w całości: może brakować wierszy
calypso-warning-deviation = tabela ma odchyłkę { $given } mm, a z jej wartości wynika { $expected } mm
calypso-warning-exceed = tabela ma { $given } mm poza tolerancją, a z jej wartości wynika { $expected } mm
