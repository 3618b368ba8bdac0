# La cartella in cui si mettono i file.

watch-written = scrittura in corso
watch-locked = in uso da un altro programma: { $reason }
watch-same = lo stesso contenuto è già stato importato come { $known }
watch-note = Fitcheck non ha potuto usare o valutare tutto in { $name }:
watch-again = il file è stato riscritto e comincia come prima: { $count ->
    [one] un valore importato
   *[other] { $count } valori importati
} di nuovo
watch-begins-as = il file comincia come { $known }, già importato: { $count ->
    [one] un valore importato
   *[other] { $count } valori importati
} di nuovo
watch-same-again = riscritto con lo stesso contenuto, quindi nulla viene importato
watch-by-another = un altro programma sorveglia questa cartella per lo stesso registro
watch-late = le linee fino alla { $last } completano valori già importati, dalla linea { $first } in poi: verificare questi valori nel registro
watch-no-line-end = l'ultima linea non ha fine linea; è stata importata così com'è
watch-older = un file con questo nome è stato importato dopo con un altro contenuto; dall'inizio di questo non importato di nuovo: { $count ->
    [one] un valore
   *[other] { $count } valori
}
watch-refused = non è leggibile; Fitcheck continua a provare: { $reason }
watch-copy = lo stesso contenuto è già stato importato come { $known }; se un pezzo è stato davvero rimisurato, il suo file richiede un'ora o un numero di serie
watch-verdicts = il file contiene esiti scritti da Fitcheck, non misure; nulla viene importato
watch-other = un file con questo nome è già stato importato e cominciava in modo diverso; questo viene importato per intero
