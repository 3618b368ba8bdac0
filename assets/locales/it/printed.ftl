## Rapporti stampati
printed-no-value = nessun valore misurato sotto { $column }
printed-cells = { $found } numeri sotto { $expected } colonne: non è chiaro quale numero stia in quale colonna; stampare il rapporto con tutte le colonne
printed-no-column = nessuna colonna { $column }: aggiungere i valori misurati al formato di stampa del rapporto
printed-no-heading = numeri senza intestazione sopra: manca l'inizio della dimensione
printed-no-rows = { $name } non ha righe: il rapporto può essere troncato
printed-minus-sign = la tolleranza inferiore { $given } può stare sotto o sopra il valore nominale, e nessun'altra riga lo decide: stampare le tolleranze inferiori senza segno
printed-unknown-row = asse sconosciuto { $given }: la riga viene saltata
printed-warning-deviation = il rapporto ha uno scostamento di { $given } mm, ma i suoi numeri danno { $expected } mm
printed-warning-beyond = il rapporto ha { $given } mm oltre la tolleranza, ma i suoi numeri danno { $expected } mm
printed-warning-no-end = manca l'ultima linea, { $end }: il rapporto può essere troncato
printed-warning-lines = saltata, non è una misura: { $text } (linee di questo tipo in tutto: { $count })
printed-warning-out-of-place = il rapporto dice { $given }, e nessuno dei limiti letti qui lo dice: guardare il rapporto
