# Dove si trova un errore o un avviso in un file

located-in-file = { $what }: { $file }, linea { $line }, colonna { $column }
located-in-line-of-file = { $what }: { $file }, linea { $line }
located-at-file = { $what }: { $file }
located-at-column = linea { $line }, colonna { $column }: { $what }
located-at-line = linea { $line }: { $what }

# Testi propri dell'utente

own-text-language = { $given } non inizia con il codice di una lingua. Il nome di un file di testi propri inizia con uno di { $codes }, come nl_OurShop.ftl: rinominare il file
own-text-too-large = il file ha { $bytes } byte, e un file di testi propri può averne { $most }: tenere solo i testi diversi
own-text-not-utf8 = il byte { $byte } non è UTF-8: salvare il file come UTF-8
own-text-syntax = { $given } non è leggibile come Fluent ({ $reason }). Scrivere il nome all'inizio di una linea, poi = e il testo, e far rientrare le linee successive
own-text-not-a-text = { $given } è un termine o ha attributi, e si possono sostituire solo testi: scrivere nome = testo
own-text-unknown = non esiste un testo { $name }, e nessun nome gli somiglia. I nomi sono quelli dei testi integrati: correggere o eliminare
own-text-misspelt = non esiste un testo { $name }. Il nome più simile è { $nearest }: correggere o eliminare
own-text-twice = { $name } è dato due volte, la prima alla linea { $first }, e nessuno dei due vale: eliminarne uno
own-text-empty = { $given } ha un testo vuoto, o una variante che non mostra nulla: scrivere un testo, o eliminarlo per avere quello integrato
own-text-control = { $given } ha il carattere di controllo { $code }, e sono ammessi solo caratteri visibili: eliminarlo
own-text-too-much = { $given } è più lungo di { $longest } caratteri, ha più di { $deepest } parentesi una nell'altra o troppe varianti: scriverlo in modo più semplice
own-text-surplus = { $name } ha { $given }, per cui non viene inserito nulla. È possibile solo { $allowed }: correggere o eliminare
own-text-surplus-of-none = { $name } ha { $given }, ma in questo testo non viene inserito nulla: eliminarlo
own-text-lost = in { $name } manca { $lost } del testo integrato, almeno in una variante, e qualcosa non verrebbe detto: inserirlo
own-text-read-back = { $name } dice da dove viene un valore e viene riletto dai file, perciò non si può sostituire: eliminarlo
own-text-property = { $name } appartiene alla lingua e non è un testo sostituibile: eliminarlo
own-text-same-verdict = { $name } non vale, perché { $clash } dice { $word }, come anche { $other }. Ogni esito ha bisogno di una parola propria, anche accanto a quelle integrate e inglesi: dare a ciascuno un'altra parola
