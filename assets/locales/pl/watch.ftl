# The folder that files are dropped into.

watch-written = w trakcie zapisywania
watch-locked = używany przez inny program: { $reason }
watch-same = tę samą treść zaimportowano już jako { $known }
watch-note = Fitcheck nie mógł użyć lub ocenić wszystkiego w { $name }:
watch-again = plik zapisano od nowa z takim samym początkiem; zaimportowano ponownie: { $count ->
    [one] jedną wartość
    [few] { $count } wartości
    [many] { $count } wartości
   *[other] { $count } wartości
}
watch-begins-as = plik zaczyna się jak { $known }, już zaimportowany; zaimportowano ponownie: { $count ->
    [one] jedną wartość
    [few] { $count } wartości
    [many] { $count } wartości
   *[other] { $count } wartości
}
watch-same-again = zapisano od nowa z tą samą treścią, więc nic nie jest importowane
watch-by-another = inny program obserwuje ten folder dla tego samego dziennika
watch-late = linie do { $last } uzupełniają wartości już zaimportowane, od linii { $first }: sprawdzić te wartości w dzienniku
watch-no-line-end = ostatnia linia nie ma końca linii; zaimportowano ją bez zmian
watch-older = plik o tej nazwie zaimportowano później z inną treścią; nie zaimportowano ponownie z początku tego pliku: { $count ->
    [one] jednej wartości
   *[other] { $count } wartości
}
watch-refused = nie można odczytać; Fitcheck próbuje dalej: { $reason }
watch-copy = tę samą treść zaimportowano już jako { $known }; jeśli pomiar części naprawdę powtórzono, jej plik wymaga czasu lub numeru seryjnego
watch-verdicts = plik zawiera oceny zapisane przez Fitcheck, a nie pomiary; nic nie jest importowane
watch-other = plik o tej nazwie już zaimportowano i zaczynał się inaczej; ten jest importowany w całości
