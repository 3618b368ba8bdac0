# Set di programmi, tabelle e maschere per un controllo numerico.
## Piani
nc-value = { $what }: { $error }
nc-name = nome { $name }: sono ammesse lettere da A a Z, cifre e _, al massimo { $most }
nc-not-on-control = { $kind }: si misura con il ciclo { $cycle }, che un { $control } non ha
## Set
nc-folder = { $folder } non è una cartella per programmi: scrivere TNC:\ e poi nomi di lettere, cifre, _ e -, separati da \
nc-no-texts = un set con testi di tolleranza è possibile solo per TNC7, non per { $control }
nc-series-name = { $name } non può essere il nome di una colonna della tabella della serie: iniziare il nome con una lettera e non usare NR, PART o STATUS
nc-series-sizes = una serie conserva al massimo { $most } quote di un pezzo e il piano ne ha { $sizes }: creare più set
nc-reads-otherwise = { $file } non si può scrivere in modo da rileggerlo uguale
nc-proof = il set non ha superato l'esecuzione di prova e non è stato scritto: { $reason }
nc-proof-no-end = il programma non finisce
nc-proof-count = misurati { $found } elementi su { $expected }
nc-proof-other-verdict = { $name }: l'esito differisce da quello di Fitcheck
nc-archive = impossibile creare il file zip: { $reason }
nc-workpiece = impossibile scrivere il pezzo in lavorazione: { $reason }
nc-own-column = { $class } non è una delle 47 classi di NC-Solution 8255: { $table } riceve una colonna in più
nc-figure = { $what }
nc-fewer-columns = limite di colonne di un iTNC 530: { $table } ha solo le classi del piano, { $classes }
nc-by-hand = { $name }: nessun ciclo misura un elemento di tipo { $kind }: non è nel set
nc-not-in-set = { $name }: il piano dice { $said }, ma il set non lo usa: sul controllo numerico decidono solo i limiti, quindi può dire BUONO dove fitcheck import non lo dice
nc-features = { $first } (e altri { $more })
nc-moved-nominal = { $name }: la quota nominale di { $callout } è fuori dai limiti, cosa che un TNC7 rifiuta: { $parameter } è { $value } mm, e { $deviation } si riferisce a quel valore
nc-no-place = { $name } richiede x, y e z: il programma vi si sposta
nc-own-cycle = { $name } ha un ciclo o parametri propri, che i programmi chiamati non supportano
nc-no-coordinate = { $column } non è indicato: il programma vi si sposta
