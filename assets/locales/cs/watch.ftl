# The folder that files are dropped into.

watch-written = právě se zapisuje
watch-locked = používá jej jiný program: { $reason }
watch-same = stejný obsah byl importován dříve jako { $known }
watch-note = Fitcheck nemohl použít nebo posoudit vše v { $name }:
watch-again = soubor byl přepsán a začíná stejně jako dříve: { $count ->
    [one] znovu importována jedna hodnota
    [few] znovu importovány { $count } hodnoty
   *[other] znovu importováno { $count } hodnot
}
watch-begins-as = soubor začíná jako { $known }, který byl importován dříve: { $count ->
    [one] znovu importována jedna hodnota
    [few] znovu importovány { $count } hodnoty
   *[other] znovu importováno { $count } hodnot
}
watch-same-again = přepsán se stejným obsahem, nic se proto neimportuje
watch-by-another = tuto složku sleduje pro stejný deník jiný program
watch-late = řádky až po { $last } doplňují hodnoty, které už byly importovány, od řádku { $first }: ověřte tyto hodnoty v deníku
watch-no-line-end = poslední řádek nemá konec řádku; byl importován tak, jak je
watch-older = soubor tohoto názvu byl později importován s jiným obsahem; od začátku tohoto souboru se znovu neimportuje: { $count ->
    [one] jedna hodnota
    [few] { $count } hodnoty
   *[other] { $count } hodnot
}
watch-refused = nelze přečíst; Fitcheck to zkouší dál: { $reason }
watch-copy = stejný obsah byl importován dříve jako { $known }; byl-li díl opravdu přeměřen, potřebuje jeho soubor čas nebo sériové číslo
watch-verdicts = soubor obsahuje výroky, které zapsal Fitcheck, ne měření; nic se neimportuje
watch-other = soubor tohoto názvu byl importován dříve a začínal jinak; tento se importuje celý
