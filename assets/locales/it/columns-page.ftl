# Le colonne di un file di misure: viste, corrette e ricordate.

columns-page-import = Colonne…
columns-page-hint = Mostra come viene letta ogni colonna di un file prima di importarne i valori
columns-page-take = Importare
columns-page-correct = Colonne…
columns-page-forget = Dimenticare queste colonne
columns-page-dialog = Importare e scegliere le colonne
columns-page-title = Colonne di { $name }
columns-page-wanted = Scegliere il contenuto di ogni colonna. I file con la stessa struttura verranno letti allo stesso modo.
columns-page-uncertain = Alcune colonne sono incerte: verificare il contenuto di ciascuna, poi importare. I file con la stessa struttura verranno letti allo stesso modo.
columns-page-sheet = Foglio
columns-page-separator = Separatore
columns-page-separator-semicolon = Punto e virgola
columns-page-separator-comma = Virgola
columns-page-separator-tab = Tabulazione
columns-page-separator-pipe = Barra verticale
columns-page-decimal = Segno decimale
columns-page-decimal-point = Punto
columns-page-decimal-comma = Virgola
columns-page-as-found = Come nel file
columns-page-unit = Unità delle dimensioni
columns-page-place-unit = Unità di X, Y, Z
columns-page-unit-names = Dall'intestazione, altrimenti mm
columns-page-unit-from = Dal file: { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = pollici
columns-page-first-row = Prima riga
columns-page-below-header = Sotto l'intestazione
columns-page-line = Linea { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = non usata
columns-page-role-name = nome
columns-page-role-number = numero
columns-page-role-callout = indicazione
columns-page-role-nominal = quota nominale
columns-page-role-measured = valore misurato
columns-page-role-time = ora
columns-page-role-simulated = simulato
columns-page-role-part = pezzo
columns-page-role-serial = numero di serie
columns-page-role-who = operatore
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = grandezza misurata
columns-page-header = { $line } intestaz.
columns-page-row = { $line }
columns-page-not-read = { $line } non letta
columns-page-read = { $rows ->
        [0] Nessuna delle righe mostrate viene letta
        [one] { $read } di 1 riga mostrata diventa un valore
       *[other] { $read } di { $rows } righe mostrate diventano valori
    }
columns-page-first-problem = Primo errore: { $why }
columns-page-no-measured = Nessuna colonna contiene il valore misurato: sceglierne una
columns-page-no-callout = Nessuna colonna contiene l'indicazione, quindi nessun valore può essere valutato: sceglierne una
columns-page-no-name = Nessuna colonna identifica l'elemento di un valore: scegliere nome, numero, o X e Y
columns-page-taken = Colonne: { $columns }; unità delle dimensioni: { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Colonne lette come corrette il { $day }
columns-page-forgotten = Colonne dimenticate: il prossimo file con questa struttura viene letto come se fosse il primo. I valori di questo file restano.
columns-page-none = { $name } non è una tabella con colonne
columns-page-large = { $name } è troppo grande per leggerlo nella finestra con colonne corrette: usare fitcheck import --columns
