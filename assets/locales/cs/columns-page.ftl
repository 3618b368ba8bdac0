# The columns of a file of measurements: seen, corrected and remembered.

columns-page-import = Sloupce…
columns-page-hint = Před importem hodnot ukáže, jak se čte každý sloupec souboru
columns-page-take = Importovat
columns-page-correct = Sloupce…
columns-page-forget = Zapomenout tyto sloupce
columns-page-dialog = Importovat a zvolit sloupce
columns-page-title = Sloupce souboru { $name }
columns-page-wanted = Zvolte, co který sloupec obsahuje. Soubory se stejným uspořádáním se budou číst stejně.
columns-page-uncertain = Některé sloupce nejsou jisté: ověřte, co který obsahuje, a pak importujte. Soubory se stejným uspořádáním se budou číst stejně.
columns-page-sheet = List
columns-page-separator = Oddělovač
columns-page-separator-semicolon = Středník
columns-page-separator-comma = Čárka
columns-page-separator-tab = Tabulátor
columns-page-separator-pipe = Svislá čára
columns-page-decimal = Desetinný oddělovač
columns-page-decimal-point = Tečka
columns-page-decimal-comma = Čárka
columns-page-as-found = Jako v souboru
columns-page-unit = Jednotka rozměrů
columns-page-place-unit = Jednotka X, Y, Z
columns-page-unit-names = Ze záhlaví, jinak mm
columns-page-unit-from = Ze souboru: { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = palec
columns-page-first-row = První řádek
columns-page-below-header = Pod záhlavím
columns-page-line = Řádek { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = nepoužito
columns-page-role-name = název
columns-page-role-number = číslo
columns-page-role-callout = předpis
columns-page-role-nominal = jmenovitý rozměr
columns-page-role-measured = naměřená hodnota
columns-page-role-time = čas
columns-page-role-simulated = simulováno
columns-page-role-part = díl
columns-page-role-serial = sériové číslo
columns-page-role-who = obsluha
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = co se měřilo
columns-page-header = { $line } záhlaví
columns-page-row = { $line }
columns-page-not-read = { $line } nečte se
columns-page-read = { $rows ->
        [0] Žádný ze zobrazených řádků se nečte
        [one] Řádky s hodnotou: { $read } z 1 zobrazeného
       *[other] Řádky s hodnotou: { $read } z { $rows } zobrazených
    }
columns-page-first-problem = První chyba: { $why }
columns-page-no-measured = Naměřená hodnota není v žádném sloupci: zvolte jej
columns-page-no-callout = Předpis není v žádném sloupci, žádnou hodnotu proto nelze posoudit: zvolte jej
columns-page-no-name = Žádný sloupec neurčuje prvek hodnoty: zvolte název, číslo, nebo X a Y
columns-page-taken = Sloupce: { $columns }; jednotka rozměrů: { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Sloupce čteny podle úpravy ze dne { $day }
columns-page-forgotten = Sloupce zapomenuty: další soubor s tímto uspořádáním se bude číst jako první. Hodnoty tohoto souboru zůstávají.
columns-page-none = { $name } není tabulka se sloupci
columns-page-large = { $name } je příliš velký na čtení s upravenými sloupci v okně: použijte fitcheck import --columns
