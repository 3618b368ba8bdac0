# exchange

# Misure da file
exchange-format-logs = protocolli di misura HEIDENHAIN come TCHPR421.TXT
exchange-format-log-444 = protocolli della tastatura 3D come li scrive Fitcheck
exchange-format-fn16 = output FN 16 di un controllo numerico, letto con la sua maschera (--mask)
exchange-format-series-table = tabella di un controllo numerico che un programma riempie con FN 27, una riga per pezzo
exchange-format-contacts = punti di contatto di un cerchio: x, y e facoltativamente z
exchange-format-measurements = misure come CSV: id, callout, measured
exchange-empty = il file è vuoto
exchange-not-recognised = non è un file di formato noto
exchange-model-not-read = un modello { $format }: Fitcheck non legge modelli; esportare i valori misurati come CSV, XLSX, QIF o AQDEF
exchange-drawing-not-read = un disegno { $format }: Fitcheck non legge disegni; esportare le quote come CSV o XLSX
exchange-document-not-read = un documento { $format }: Fitcheck non legge documenti; esportare i valori come CSV, XLSX, QIF o AQDEF
exchange-image-not-read = un'immagine { $format }: Fitcheck non legge immagini; esportare i valori come CSV, XLSX, QIF o AQDEF
exchange-archive-not-read = un archivio { $format }: decomprimerlo e indicare i file contenuti
exchange-no-sheet = la cartella di lavoro non ha un foglio { $given }; contiene { $sheets }
exchange-other-format = il file contiene { $format }, non misure come CSV
exchange-parquet-unknown = questo programma è compilato senza Parquet: cargo build --release senza altre opzioni lo comprende
exchange-parquet-stream = Parquet elenca le colonne alla fine del file e non si può leggere da una pipe: indicare il nome del file
exchange-parquet = questo file Parquet non è leggibile: { $reason }
exchange-parquet-nested = la colonna { $column } contiene colonne o elenchi: si possono valutare solo colonne di valori singoli
exchange-mask-backwards = { $mask }: { $reason }
exchange-mask-none = nessuna delle maschere indicate stampa un file simile: { $masks }
exchange-mask-several = più maschere stampano un file simile; indicare solo quella che lo ha scritto: { $masks }
exchange-mask-no-measured = { $mask } non stampa alcun valore misurato: Fitcheck riconosce da Q153 a Q156, Q160, e ogni altro numero con l'indicazione stampata accanto
exchange-mask-measured = { $mask }: ciascuno di questi può essere il valore misurato: { $fields }; stampare il risultato del ciclo, come Q153; altrimenti il file richiede indicazioni con limiti diversi
exchange-print-ambiguous = la maschera può leggerlo in più modi
exchange-print-broken = il record finisce troppo presto: atteso l'output della linea { $line } della maschera
exchange-print-other = la maschera non stampa una linea simile, ma contiene numeri: può essere un record con un valore mancante o modificato; correggerla o rimuoverla
exchange-print-unit = la linea { $line } indica { $unit }, ma l'output di un controllo numerico si legge in mm: stampare i valori in mm
exchange-table-no-part = nessuna colonna dice a quale pezzo appartiene una riga: la tabella di una serie ha bisogno di una colonna come PART o SERIAL
exchange-table-no-values = nessuna colonna contiene valori misurati
exchange-table-no-value = non è chiaro quale colonna di { $name } sia il valore misurato
exchange-table-touches = la cella nella colonna { $column } tocca quella vicina, una delle due può essere divisa male: separarle con uno spazio
exchange-table-unit = la tabella è in pollici e la colonna { $column } non è di tipo LENGTH, quindi i valori possono essere in mm: usare il tipo LENGTH
exchange-no-rows = nessuna riga contiene una misura
exchange-no-measured-column = nessuna colonna di valori misurati: indicarla nella prima linea, come id;callout;measured
exchange-several-columns = ciascuna delle colonne { $columns } può essere { $role }: sceglierne una con import --columns, come { $word }=3, o dare nella prima linea nomi tali che solo una corrisponda, come id;callout;measured
exchange-role-id = il nome
exchange-role-tolerance = l'indicazione
exchange-role-nominal = la quota nominale
exchange-role-measured = il valore misurato
exchange-role-time = l'ora
exchange-role-simulated = se è simulato
exchange-role-number = il numero
exchange-role-part = il pezzo
exchange-role-serial = il numero di serie
exchange-role-who = l'operatore
exchange-role-x = X
exchange-role-y = Y
exchange-role-z = Z
exchange-role-quantity = la grandezza misurata
exchange-role-upper = lo scostamento superiore
exchange-role-lower = lo scostamento inferiore
exchange-role-minus = lo scostamento inferiore senza il meno
exchange-role-maximum = il limite superiore
exchange-role-minimum = il limite inferiore
exchange-role-kind = foro o albero
exchange-role-units = l’unità
exchange-role-status = lo stato
exchange-role-machine = la macchina
exchange-role-batch = il lotto
exchange-role-sample = un campione
exchange-no-column = { $role } dovrebbe essere nella colonna { $given }, ma il file ha { $columns }
exchange-column-twice = la colonna { $column } non può essere sia { $first } sia { $second }
exchange-unit = unità sconosciuta { $unit }: usare mm, µm o inch
exchange-limit = limite: { $reason }
exchange-tolerance-unsigned = la tolleranza { $given } è senza segno: scrivere ±{ $given }, oppure entrambi gli scostamenti, come +0.02 0
exchange-minus-again = lo scostamento inferiore { $given } ha il meno, ma gli altri no: scriverli tutti con il segno
exchange-limits-contradict = { $callout } ha i limiti da { $minimum } a { $maximum }, ma le colonne dicono { $given }: per giudicare secondo la quota indicare --columns { $columns }, secondo le colonne --columns callout=-
exchange-limits-or-deviations = le colonne { $columns } possono essere limiti o scostamenti dalla quota nominale: scegliere con --columns, come maximum={ $upper },minimum={ $lower } oppure upper={ $upper },lower={ $lower }
exchange-limits-or-readings = le colonne { $columns } possono essere limiti, oppure la maggiore e la minore di più letture: scegliere con --columns, come maximum={ $upper },minimum={ $lower } per i limiti o maximum=-,minimum=- per le letture
exchange-minus-or-plus = gli scostamenti inferiori nella colonna { $columns } sono senza segno: scegliere con --columns, minus={ $lower } per sotto la quota nominale o lower={ $lower } per sopra
exchange-samples-side-by-side = più valori misurati stanno affiancati nelle colonne { $columns }: leggerli con fitcheck import, oppure sceglierne uno con --columns, come measured={ $first }
exchange-unit-stated = la linea { $line } indica l'unità { $unit }, che non è supportata («{ $text }»): usare mm, µm o inch, o scegliere l'unità delle dimensioni (--columns unit=mm)
exchange-unit-mentioned = la linea { $line } nomina { $unit } («{ $text }»), ma nulla dice se i valori sono in questa unità: scegliere l'unità delle dimensioni (--columns unit=mm, um o inch)
exchange-units-differ = «{ $at }» dice { $unit }, «{ $other-at }» dice { $other }: correggere uno dei due
exchange-unit-late = la linea { $line } indica { $unit } («{ $text }»), ma le righe sopra vengono lette in { $read }: indicare l'unità sopra la prima riga, o correggere quella linea
exchange-unit-stray = questa linea indica { $unit } («{ $text }»), ma tutte le altre righe vengono lette in { $read }: indicare l'unità sopra la prima riga, o correggere questa linea
exchange-unit-given = l'unità scelta è { $given }, ma il file dice { $unit } («{ $text }»): scegliere { $unit }, o correggere il file
exchange-unit-half = la colonna { $column } è in pollici, e la colonna { $open } non indica la sua unità: scriverla accanto a entrambi i nomi, o scegliere l'unità delle dimensioni (--columns unit=inch)
exchange-unit-missing = manca l'unità di questa riga: scrivere mm, µm o inch, o scegliere l'unità delle dimensioni (--columns unit=mm)
exchange-callout-unit = { $given }: la riga è in pollici, e un'indicazione con una dimensione o scostamenti è in mm: mettere la quota nominale in una colonna propria accanto alla classe
exchange-row-short = attese { $expected } celle, trovate { $found }
exchange-row-long = attese { $expected } celle, trovate { $found }: il separatore è usato anche come segno decimale o in un testo?
exchange-row-too-long = la riga supera { $most } KiB
exchange-open-quote = in questa linea le virgolette non sono chiuse
exchange-header-hides-rows = linea { $line }: l'intestazione occupa più linee, e una di esse sembra una riga: chiudere le virgolette nella linea in cui si aprono
exchange-within-quotes = questa linea può essere una riga o una nota: le virgolette si aprono sopra e si chiudono qui o sotto; chiuderle nella linea in cui si aprono
exchange-callout = indicazione: { $reason }
exchange-nominal = quota nominale: { $reason }
exchange-nominal-differs = l'indicazione { $callout } non corrisponde alla quota nominale { $nominal } nella sua colonna
exchange-measured = valore misurato: { $reason }
exchange-simulated = simulato: { $given } non è né true né false
exchange-other-header = questa linea indica colonne diverse dalla prima: valutare le righe sottostanti come file separato
exchange-below-other-header = non valutato: la linea { $line } indica colonne diverse. Valutare le righe sottostanti come file separato
exchange-simulated-below = le righe sotto questa linea sono simulate: valutarle come file separato, o con fitcheck import
exchange-origin = provenienza: { $given } non dice né misurato né simulato; scrivere measured, typed o simulated, o impostare simulated=- se questa colonna dice altro
exchange-decimal-sign = valore misurato: { $given } ha un segno decimale diverso dagli altri valori: «{ $sign }»
exchange-not-positive = valore misurato: un diametro di { $given } non è maggiore di 0
exchange-decimal-comma = { $joined } può essere un solo numero con virgola decimale: usare il punto decimale o un altro separatore
exchange-other-feature = { $given } è { $feature ->
        [hole] un albero, e questi sono i fori: i file sono scambiati?
       *[shaft] un foro, e questi sono gli alberi: i file sono scambiati?
    }
exchange-rejected = il file stesso respinge questo valore ({ $given }): rimuovere la riga, o correggerla nel file
exchange-no-part = { $given } indica un dato di più pezzi o un campione di azzeramento di uno strumento, non un pezzo: rimuovere la riga, o dare al pezzo un altro nome
exchange-other-log = { $feature ->
        [hole] è il protocollo di un albero, e questi sono i fori: i file sono scambiati?
       *[shaft] è il protocollo di un foro, e questi sono gli alberi: i file sono scambiati?
    }
exchange-not-a-size = { $what }: non è una dimensione che si possa abbinare
exchange-no-place-axis = giace lungo { $axis }, ma i cicli 421 e 422 tastano lungo Z
exchange-no-place-no-axis = il file non dice lungo quale asse giace
exchange-no-place-kind = { $kind }: i cicli 421 e 422 tastano solo cerchi e cilindri
exchange-no-place-system = è controllato nel sistema di coordinate { $system }, ma le coordinate si riferiscono a quello del file
exchange-contacts-not-sizes = righe di due o tre numeri sono punti di contatto: dare i nomi delle colonne nella prima linea, come id;measured
exchange-too-many-rows = sono state lette solo le prime { $most } righe: dividere il file
exchange-unjudged-no-callout = non valutato: nessuna indicazione
exchange-unjudged-no-limits = non valutato: le dimensioni limite del protocollo sono 0, quindi il diametro non è stato sorvegliato
exchange-unjudged-coordinate = una coordinata del ciclo { $cycle }, non un foro o un albero
exchange-unjudged-coordinate-without-limits = non valutato: i limiti del protocollo sono 0, quindi la coordinata non è stata sorvegliata
exchange-unjudged-size = { $what } del ciclo { $cycle }, non un foro o un albero
exchange-unjudged-size-without-limits = non valutato: i limiti del protocollo sono 0, quindi non sorvegliato: { $what }
exchange-unjudged-point = un punto su superficie del ciclo { $cycle }: il suo scostamento lungo la normale non è una dimensione
exchange-unjudged-point-without-tolerance = non valutato: il punto è stato tastato senza tolleranza
exchange-unjudged-contacts = non valutato: { $count } punti di contatto senza indicazione
exchange-warning-ignored-columns = colonne saltate: { $columns }
exchange-warning-quantity-unknown = la colonna { $column } non ha parole note per la grandezza misurata ({ $words }): tutti i suoi valori vengono letti come dimensioni; se è corretto, indicare import --columns quantity=-
exchange-warning-not-used = saltato, non è una misura: { $text }
exchange-warning-minus-supplied = la colonna { $column } è senza segni meno: i valori sono letti come scostamenti inferiori sotto la quota nominale
exchange-warning-callouts-unnamed = la colonna { $column } sembra contenere le quote con tolleranza, ma il suo nome non è noto: chiamarla callout, oppure dare il suo numero con --columns, per esempio callout=2
exchange-warning-limits-read = le colonne { $columns } sono lette come limiti
exchange-warning-head-read = letto per tutti i valori: { $said }
exchange-warning-samples-read = le colonne { $columns } sono lette come pezzi affiancati: ogni valore è giudicato da solo, una cella vuota non è un valore, e senza numeri di serie ogni colonna è un pezzo a sé
exchange-warning-comment = una linea che comincia con # è un commento, ma questa contiene una misura
exchange-warning-several-lines = la riga occupa { $lines } linee tra virgolette
exchange-warning-time = { $given } non è una data con ora: si usa l'ora dell'importazione
exchange-warning-place = { $given } non è una lunghezza: la posizione viene saltata
exchange-warning-no-time = qui non ci sono data e ora: si usa l'ora dell'importazione
exchange-warning-offset = { $given } viene conservata come ora locale, senza la differenza da UTC
exchange-warning-cut-off = il file finisce qui senza fine linea, e { $given } ha meno decimali degli altri valori: può essere troncato
exchange-warning-open-end = il file finisce qui senza fine linea: l'ultimo valore, { $given }, può essere troncato

# Punti di contatto
contacts-file-empty = il file non contiene punti di contatto
contacts-no-columns = l'intestazione deve indicare x e y, e può indicare z; è { $given }
contacts-twice = le colonne { $first } e { $second } sono entrambe { $name }
contacts-cells = attese { $wanted } celle, trovate { $cells }: { $given }
contacts-not-a-number = { $name } è { $given }, non un numero di millimetri
contacts-row-too-long = la riga supera { $most } KiB
contacts-comment = una linea che comincia con # è un commento, ma questa contiene coordinate: rimuovere il #, o l'intera linea
contacts-other-unit = i punti di contatto sono in mm, ma questa linea indica { $given }: convertirli in mm
contacts-too-many = il file ha più di { $most } punti di contatto
contacts-simulated = questi punti di contatto sono simulati e non misurano nulla: usare invece un file di pezzo in lavorazione
contacts-origin = { $given } non dice né misurato né simulato: scrivere measured o simulated, o rimuovere la colonna
contacts-open-quote = le virgolette non sono chiuse
contacts-mixed-signs = { $given } ha un segno decimale diverso dalle righe precedenti

## Tabelle di scostamenti
table-format-name = { $name } non comincia con una lettera: su un TNC7 i nomi delle tabelle devono farlo
table-format-operator = { $name } contiene { $sign }: su un TNC7 i nomi delle tabelle non possono avere operatori aritmetici
table-format-warning-lower-sign = il manuale di PC-DMIS non mostra scostamenti inferiori diversi da 0: prima di farvi affidamento, verificare { $class } in PC-DMIS, in particolare i segni
table-format-csv = impossibile scrivere il CSV: { $reason }
table-format-parquet-unknown = questo programma è compilato senza Parquet: cargo build --release senza altre opzioni lo comprende
table-format-parquet = impossibile scrivere il file Parquet: { $reason }
table-format-itnc530 = tabella del controllo numerico per iTNC 530
table-format-tnc640 = tabella del controllo numerico per TNC 620 e TNC 640
table-format-tnc7 = tabella del controllo numerico per TNC7
table-format-plain-csv = CSV, una linea per classe e campo di dimensioni
table-format-plain-parquet = Parquet, una riga per classe e campo di dimensioni
table-format-pcdmis = CSV di tolleranze ISO per PC-DMIS

## Limiti come SQL
sql-border = tabella { $table }: un campo di dimensioni finisce a { $end } mm; come SQL i campi devono finire a millimetri interi
sql-too-far = tabella { $table }: un campo di dimensioni finisce a { $end } mm; come SQL i campi devono finire entro { $most } mm
sql-twice = la classe { $class } è indicata due volte
exchange-correction = il valore a 20 °C non deriva dal valore misurato e dalle sue temperature: attese le colonne come le scrive Fitcheck
exchange-warning-corrected = i valori con un dato nella colonna as_measured_mm sono già a 20 °C
sizes-warning-named-twice = { $rows ->
        [one] una riga ha il nome di una riga precedente
       *[other] { $rows } righe hanno il nome di una riga precedente
    }, come { $id } alle linee { $first } e { $second }: ogni riga conta come un pezzo
sizes-warning-simulated-rows = { $count ->
        [one] 1 riga è simulata
       *[other] { $count } righe sono simulate
    }: non è stato misurato nulla
exchange-position-out = il centro era fuori posizione, ma il file ha solo la dimensione
exchange-undecided = qui non è stato deciso nulla: { $given }
exchange-warning-other-rule = gli esiti di questo file possono venire da un'altra regola di decisione (colonna rule_name): i suoi valori vengono valutati di nuovo
exchange-read = il resto del file non è leggibile: { $reason }
exchange-too-large = supera { $most } MiB, il limite per i file di questo formato
exchange-unjudged-one-limit = non valutato: manca uno dei due limiti
exchange-unjudged-no-tolerance = non valutato: nessun limite indicato
exchange-unjudged-rounded = non valutato: le cifre stampate valgono per ogni valore da { $from } a { $to }, e in mezzo c'è un limite: stampare più decimali
exchange-unjudged-implausible = non valutato: { $measured } mm non può essere: il piano indica da { $lower } a { $upper } mm; controllare unità e segno decimale, o rimisurare
exchange-unjudged-swapped-limits = non valutato: il limite inferiore { $minimum } è sopra il limite superiore { $maximum }
exchange-unjudged-not-a-size = { $what }: non è una dimensione di un foro o di un albero
exchange-warning-limits-differ = { $callout } ha i limiti da { $minimum } a { $maximum }, ma il file ne ha altri: valgono i limiti del file
exchange-warning-class-unknown = la classe { $given } qui non ha limiti: valgono i limiti del file
exchange-warning-status-differs = il file dice { $given }, ma i limiti dicono { $status }
exchange-warning-status-unknown = il file dice { $given }, che non è uno stato noto: i limiti dicono { $status }
exchange-warning-limit-differs = il file dice { $given }, ma i limiti sono da { $minimum } a { $maximum }
exchange-warning-deviation-differs = il file dice { $given }, ma non è lo scostamento di { $measured } da { $nominal }
exchange-warning-feature-differs = il file dice { $given }, ma i limiti sono quelli di { $feature ->
        [hole] un foro
       *[shaft] un albero
    }
exchange-warning-temperature-differs = il file dice { $given }, ma il valore conta come misurato a { $counted } °C: indicare --temperature e --material
exchange-warning-speaks-of-temperature = il file nomina una temperatura diversa da { $counted } °C, a cui i suoi valori contano come misurati: { $text }
exchange-warning-speaks-of-unit = una nota indica un'unità diversa da quella dei valori: { $text }
exchange-warning-speaks-of-simulation = questa linea nomina una simulazione: verificare se il valore è stato misurato: { $text }
exchange-warning-all-nominal = tutti i { $count } valori sono esattamente le loro quote nominali: può essere un elenco di quote che nessuno ha misurato
exchange-warning-name-of-no-size = { $given } non è il nome di una dimensione di un solo pezzo, ma il valore è stato valutato come tale
exchange-warning-other-values = le colonne con altre dimensioni vicine a quelle misurate non vengono valutate: { $columns }
exchange-warning-part-rejected = il file dice { $given } dell'intero pezzo
exchange-warning-uncertainty-not-used = il file indica un'incertezza estesa di { $expanded } mm: nessuna regola la usa, quindi indicare --u
exchange-warning-plan-differs = il file ha i limiti da { $minimum } a { $maximum }: valgono i limiti del piano
exchange-warning-plan-differs-below = il file ha il limite inferiore { $minimum }: vale il limite inferiore del piano
exchange-warning-above-own-limit = non è del piano, ed è sopra il limite superiore del suo file, { $maximum }
exchange-warning-below-own-limit = non è del piano, ed è sotto il limite inferiore del suo file, { $minimum }
exchange-warning-plan-differs-above = il file ha il limite superiore { $maximum }: vale il limite superiore del piano
exchange-warning-plan-differs-nominal = il file ha la quota nominale { $nominal }: vale la quota nominale del piano
exchange-warning-part-differs = il file indica il pezzo { $given }: viene valutato come { $part }, il pezzo del piano
exchange-warning-found-by-number-of = nessun elemento del piano si chiama { $given }; attribuito per numero a { $name } del piano
exchange-warning-found-by-place-of = nessun elemento del piano si chiama { $given }; attribuito per posizione a { $name } del piano
exchange-warning-found-by-number = attribuito per numero a { $name } del piano
exchange-warning-found-by-place = attribuito per posizione a { $name } del piano
exchange-format-aqdef = Q-DAS AQDEF, in un solo file o come .dfd e .dfx
exchange-format-calypso = tabelle di caratteristiche di CALYPSO come NAME_chr.txt
exchange-format-calypso-text = rapporti stampati di CALYPSO salvati come testo
exchange-format-geopak = tolleranze di MCOSMOS (GEOPAK) in un file senza nomi di colonne
exchange-format-gauge = righe di strumenti di misura salvate in un file, come 01A+025.012
exchange-format-pcdmis = rapporti di testo di PC-DMIS
exchange-format-probed = stampe di macro di tastatura, come le scrivono Renishaw e i sistemi CAM
exchange-warning-unit-assumed = nessuna unità indicata: le lunghezze senza unità vengono lette come mm
exchange-warning-unit-read = le lunghezze vengono lette in { $unit }, come indica il file: { $text }
exchange-warning-rounded = { $given } ha cifre oltre il nanometro: viene arrotondato al nanometro più vicino
exchange-warning-rounded-values = { $count ->
        [one] 1 valore misurato ha cifre oltre il nanometro, da questa linea: viene arrotondato al nanometro più vicino
       *[other] { $count } valori misurati hanno cifre oltre il nanometro, da questa linea in poi: vengono arrotondati al nanometro più vicino
    }
exchange-unjudged-quantity = { $quantity ->
        [102] rotondità (K2009 è 102)
        [109] posizione (K2009 è 109)
        [117] una coordinata (K2009 è 117)
       *[other] una grandezza diversa da un diametro (K2009 è { $quantity })
    }: non è una dimensione di un foro o di un albero
exchange-unjudged-kind = non misurato: { $kind ->
        [1] un conteggio di pezzi non conformi (K2004 è 1)
        [5] una scheda di raccolta difetti (K2004 è 5)
        [6] una scheda di raccolta difetti (K2004 è 6)
       *[other] un tipo di caratteristica sconosciuto (K2004 è { $kind })
    }
exchange-unjudged-attribute = non valutato: contrassegnato con { $given } (K0002); solo 0 contrassegna di certo un valore valido
exchange-unjudged-not-valid = non valutato: il file dice { $said }, quindi può non esserci un valore valido
exchange-unjudged-declaration = non valutato: la linea { $declaration } della sua dichiarazione non è utilizzabile
exchange-format-qif = QIF 2.0, 2.1, 3.0: risultati di software di misura, e piani
exchange-xml = non è XML ben formato: { $reason }
exchange-xml-doctype = un DOCTYPE non è supportato: rimuoverlo, o esportare il file senza
exchange-xml-entity = l'entità { $name } non è nota: sono supportate solo &lt; &gt; &amp; &quot; e &apos;
exchange-xml-depth = raggiunto il limite di { $most } elementi annidati
exchange-xml-long = un tag o un testo supera { $most } KiB
exchange-xml-mixed = { $name } ha un elemento in mezzo al suo testo
exchange-xml-cut-off = il file finisce dentro un elemento: può essere troncato
exchange-xml-encoding = codifica sconosciuta { $given }: usare UTF-8, UTF-16 o ISO 8859-1
exchange-xml-bytes = questi byte non sono testo nella codifica del file
exchange-qif-unit = unità di lunghezza { $unit }: il nome è sconosciuto, o non corrisponde al fattore; usare mm, inch o un'altra unità con il suo fattore in metri
exchange-qif-no-unit = il file non ha un'unità di lunghezza: richiede FileUnits con PrimaryUnits e LinearUnit
exchange-qif-reference = { $what } { $id } non è nel file
exchange-qif-too-many = il file ha più di { $most } elementi { $what }
exchange-qif-no-value = qui nessun valore misurato; stato { $status }
exchange-qif-limit = limiti o quota nominale: { $reason }
exchange-qif-other-kind = la misura è di tipo { $measured }, ma la sua caratteristica è di tipo { $defined }
exchange-qif-several-values = la misura ha più valori
exchange-qif-defined-as-limit = DefinedAsLimit manca o non è né true né false, quindi i numeri possono essere limiti o scostamenti
exchange-qif-no-nominal = i limiti sono scostamenti, ma non c'è una quota nominale
exchange-qif-zone = la classe { $class } e { $zone } si contraddicono: le maiuscole sono fori, le minuscole alberi
exchange-qif-no-results = un file QIF senza valori misurati: un piano si può leggere come piano di misura
exchange-qif-no-characteristics = il file QIF non dichiara caratteristiche
exchange-warning-standard-uncertainty-not-used = il file indica un'incertezza tipo composta di { $standard } e un errore medio di { $mean-error }: nessuna regola li usa, quindi indicare --u
exchange-warning-sheet-hidden = il foglio { $sheet } viene letto, benché nascosto nella cartella di lavoro
exchange-warning-rows-hidden = { $count ->
    [one] la riga { $rows } è nascosta o filtrata nella cartella di lavoro, ma viene letta come le altre
   *[other] { $count } righe sono nascoste o filtrate nella cartella di lavoro, ma vengono lette come le altre: { $rows }
}
exchange-warning-columns-hidden = le colonne nascoste vengono lette come le altre: { $columns }
exchange-warning-qif-version = versione QIF { $version }: questo programma è fatto per le versioni 2.0, 2.1 e 3.0
exchange-warning-qif-count = { $list } dice n={ $said }, ma ne ha { $found }: può mancare o essere di troppo qualcosa
exchange-warning-qif-twice = l'id { $id } compare due volte: si usa il primo elemento
exchange-format-xlsx = misure in una cartella di lavoro: colonne come in CSV
exchange-workbook = questa cartella di lavoro non è leggibile: { $reason }
exchange-not-a-workbook = un file ZIP, ma non una cartella di lavoro: decomprimerlo e indicare i file contenuti
exchange-old-workbook = una cartella di lavoro in formato { $format }, che non è supportato: salvarla come XLSX
exchange-workbook-password = la cartella di lavoro ha una password: salvarla senza
exchange-zip-cut-off = manca la fine della cartella di lavoro: può essere troncata
exchange-zip-members = l'elenco dei file interni della cartella di lavoro è danneggiato o ha più di { $most } file
exchange-zip-bomb = { $member } decompresso supera { $most } MiB, o è compresso troppo per una cartella di lavoro: non viene letto
exchange-zip-twice = due file interni della cartella di lavoro hanno lo stesso nome, quindi è stata modificata: aprirla in un programma di calcolo e salvarla
exchange-zip-texts = la cartella di lavoro ha più di { $most } testi diversi
exchange-sheet-wide = la cella { $cell } è oltre le prime { $most } colonne
exchange-too-many-cells = il foglio ha più di { $most } celle
exchange-cell = { $cell }: { $reason }
exchange-formula-without-value = il valore della formula ={ $formula } non è salvato: aprire la cartella di lavoro in un programma di calcolo e salvarla
exchange-cell-split = il valore della cella non è salvato come un solo testo semplice, quindi se ne è potuta leggere solo una parte: aprire la cartella di lavoro in un programma di calcolo e salvarla
exchange-cell-error = la cella mostra { $error }
exchange-warning-sheets-left = viene letto il foglio { $sheet }; altri fogli no: { $left }
gauge-frame = i caratteri che racchiudono la linea sono stati saltati
gauge-channel = dal canale { $channel }
gauge-inches = { $given } pollici
gauge-error-text = { $given } può essere un numero di errore dello strumento: se è una dimensione, scriverla con la sua unità, { $given } mm
gauge-opinion = lo strumento dice { $sign }; decidono i limiti del piano

mapping-no-value = { $given } non assegna alcuna colonna: scrivere una parola, = e una colonna, come measured=3
mapping-word = { $given } non è un contenuto di colonna noto: sono ammessi { $allowed }
mapping-value = { $word }: { $given } è sconosciuto: sono ammessi { $allowed }
mapping-twice = { $word } è indicato due volte: indicarlo una volta
mapping-toml = non è un'assegnazione di colonne: { $reason }

# Come un valore è stato valutato secondo un piano, e che cosa era indicato accanto.
planned-rule = valutato secondo la regola del piano invece di { $given }: { $rule }
planned-uncertainty = valutato con l'incertezza del piano invece di quella indicata: { $u }
planned-material = corretto a 20 °C con il materiale del piano invece di quello indicato: { $name }
planned-corrected = corretto da { $temperature } °C a 20 °C (dilatazione { $expansion } · 10⁻⁶/K)
planned-not-corrected = non corretto a 20 °C: una posizione sul pezzo non è una dimensione
planned-error-already-corrected = il file dice che il valore è già a 20 °C: valutarlo senza una temperatura

## Gauges
gauge-no-unit = { $given } non indica l'unità: dire nelle impostazioni dello strumento se invia millimetri o pollici
exchange-gauge-unit = la riga { $line } di queste righe di strumento, { $given }, non indica né mm né pollici: indicare l'unità con import --columns unit=mm o --columns unit=inch
gauge-other-form = { $given } differisce non solo nelle cifre dalla linea con cui lo strumento è stato istruito, { $example }
gauge-other-decimals = { $given } ha { $decimals ->
        [one] 1 decimale
       *[other] { $decimals } decimali
    }, e la linea con cui lo strumento è stato istruito ne ha { $taught }: lo strumento invia un'altra unità, o una parte del numero è andata persa
teach-zero = 0 può essere ogni zero della linea: istruire lo strumento con una linea di un altro valore
teach-not-text = { $line } contiene caratteri che non sono testo
teach-nowhere = { $value } mm non compare nella linea { $line }: digitare il valore che lo strumento mostrava in quel momento
teach-twice = { $value } mm compare più di una volta nella linea { $line }: istruire lo strumento con una linea di un altro valore
teach-other-unit = la linea dice { $given }, che non è { $value } mm: digitare il valore che lo strumento mostrava, in millimetri
