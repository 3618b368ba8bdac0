# Kolumny pliku pomiarów: obejrzane, poprawione i zapamiętane.

columns-page-import = Kolumny…
columns-page-hint = Pokazuje przed importem wartości, jak czytana jest każda kolumna pliku
columns-page-take = Importuj
columns-page-correct = Kolumny…
columns-page-forget = Zapomnij te kolumny
columns-page-dialog = Import z wyborem kolumn
columns-page-title = Kolumny pliku { $name }
columns-page-wanted = Wybrać, co zawiera każda kolumna. Pliki o tym samym układzie będą czytane tak samo.
columns-page-uncertain = Niektóre kolumny są niepewne: sprawdzić, co każda zawiera, potem importować. Pliki o tym samym układzie będą czytane tak samo.
columns-page-sheet = Arkusz
columns-page-separator = Separator
columns-page-separator-semicolon = Średnik
columns-page-separator-comma = Przecinek
columns-page-separator-tab = Tabulator
columns-page-separator-pipe = Kreska pionowa
columns-page-decimal = Znak dziesiętny
columns-page-decimal-point = Kropka
columns-page-decimal-comma = Przecinek
columns-page-as-found = Jak w pliku
columns-page-unit = Jednostka wymiarów
columns-page-place-unit = Jednostka X, Y, Z
columns-page-unit-names = Z nagłówka, inaczej mm
columns-page-unit-from = Z pliku: { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = cal
columns-page-first-row = Pierwszy wiersz
columns-page-below-header = Pod nagłówkiem
columns-page-line = Linia { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = nieużywana
columns-page-role-name = nazwa
columns-page-role-number = numer
columns-page-role-callout = wymiar tolerowany
columns-page-role-nominal = wymiar nominalny
columns-page-role-measured = wartość zmierzona
columns-page-role-time = czas
columns-page-role-simulated = symulowane
columns-page-role-part = część
columns-page-role-serial = numer seryjny
columns-page-role-who = operator
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = co zmierzono
columns-page-header = { $line } nagłówek
columns-page-row = { $line }
columns-page-not-read = { $line } nieczytana
columns-page-read = { $rows ->
        [0] Żaden z pokazanych wierszy nie jest czytany
        [one] Wiersze, które dają wartość: { $read } z 1 pokazanego
       *[other] Wiersze, które dają wartość: { $read } z { $rows } pokazanych
    }
columns-page-first-problem = Pierwszy błąd: { $why }
columns-page-no-measured = Żadna kolumna nie zawiera wartości zmierzonej: wybrać ją
columns-page-no-callout = Żadna kolumna nie zawiera wymiaru tolerowanego, więc nie można ocenić żadnej wartości: wybrać ją
columns-page-no-name = Żadna kolumna nie wskazuje elementu wartości: wybrać nazwę, numer lub X i Y
columns-page-taken = Kolumny: { $columns }; jednostka wymiarów: { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Kolumny czytane tak, jak poprawiono { $day }
columns-page-forgotten = Kolumny zapomniano: następny plik o tym układzie będzie czytany jak pierwszy. Wartości tego pliku pozostają.
columns-page-none = { $name } nie jest tabelą z kolumnami
columns-page-large = { $name } jest za duży, aby czytać go w oknie z poprawionymi kolumnami: użyć fitcheck import --columns
