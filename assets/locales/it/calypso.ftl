## Tabelle di CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = nessun valore misurato nella colonna actual
calypso-cut-off = manca l'ultima linea, END: il file può essere troncato
calypso-row-cut-off = il file finisce qui senza fine linea, quindi la riga può essere troncata: viene saltata; se è completa, aggiungere un fine linea
calypso-zeros = la linea ha byte di valore 0, quindi il file non è stato scritto completamente: la riga viene saltata
calypso-differs = le righe di { $name } nelle linee { $first } e { $second } hanno valori nominali o limiti diversi
calypso-warning-no-end = manca l'ultima linea, END: il file può essere troncato
calypso-warning-behind = saltato dopo la linea END: { $given }
calypso-warning-zeros = il file ha qui byte di valore 0, quindi non è stato scritto completamente: possono mancare righe
calypso-warning-deviation = la tabella ha uno scostamento di { $given } mm, ma i suoi valori danno { $expected } mm
calypso-warning-exceed = la tabella ha { $given } mm oltre la tolleranza, ma i suoi valori danno { $expected } mm
