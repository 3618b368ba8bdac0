page-parts = Pezzi
parts-page-walk = Misurare
parts-page-plan = Piano
parts-page-new = Nuovo piano
parts-page-open = Aprire piano…
parts-page-save = Salvare piano…
parts-page-save-csv = Salvare piano come CSV…
parts-page-undo = Annullare
parts-page-redo = Ripristinare
parts-page-dialog-open = Aprire un piano di misura
parts-page-dialog-save = Salvare il piano di misura
parts-page-not-saved = { $name }, non salvato
parts-page-no-plan = Ancora nessun piano: aprirne o crearne uno.
parts-page-move = Passare a un'altra cella
parts-page-extend = Estendere la selezione
parts-page-edit = Modificare la cella
parts-page-take = Fatto
parts-page-empty = Svuotare le celle
parts-page-copy = Copiare le celle
parts-page-paste = Incollare
parts-page-insert = Inserire riga
parts-page-delete = Eliminare righe
parts-page-up = Spostare in su
parts-page-down = Spostare in giù
parts-page-sort = Ordinare
parts-page-sort-hint = Ordina secondo la colonna della cella corrente, A2 prima di A10; ordinare di nuovo per invertire l'ordine
parts-page-renumber = Rinumerare
parts-page-renumber-hint = Numera gli elementi da 1 nell'ordine delle righe
parts-page-all-columns = Tutte le colonne
parts-page-previous = Errore precedente
parts-page-next = Errore successivo
parts-page-choose-picture = Scegliere immagine…
parts-page-dialog-picture = Scegliere l'immagine del pezzo
parts-page-table = Elementi del piano
parts-page-cell-name = Cella del piano
parts-page-cell = Riga { $row }, { $column }, { $text }
parts-page-cell-empty = Riga { $row }, { $column }, vuota
parts-page-cell-wrong = { $cell }, errore: { $what }
parts-page-new-row = nuova
parts-page-limits = Limiti
parts-page-editing = { $column } della riga { $row }
parts-page-head = Pezzo
parts-page-words = Uno tra: { $words }
parts-page-no-fault = Nessun errore nel piano
parts-page-blank = Digitare il primo elemento, o incollare righe da un foglio di calcolo
parts-page-faults = { $count ->
    [one] Un errore
   *[other] { $count } errori
}
parts-page-features = { $count ->
    [one] Un elemento
   *[other] { $count } elementi
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Riga { $row }
parts-page-fault-plan = Piano
parts-page-lost = Non compreso nel file: il piano non misura e non salva nulla finché non è corretto nel file o tralasciato qui
parts-page-take-meant = Usare { $meant }
parts-page-leave-out = Tralasciare
parts-page-leave-out-hint = Il piano ha allora solo ciò che è stato letto; ciò che non è stato compreso può essere un elemento
parts-page-left-out = { $count ->
    [one] { $name }: un dato non compreso è tralasciato dal piano; il file lo conserva finché il piano non viene salvato
   *[other] { $name }: { $count } dati non compresi sono tralasciati dal piano; il file li conserva finché il piano non viene salvato
}
parts-page-pasted-rows = { $count ->
    [one] Una riga incollata è stata saltata: un piano ha al massimo { $most } elementi
   *[other] { $count } righe incollate sono state saltate: un piano ha al massimo { $most } elementi
}
parts-page-pasted-columns = { $count ->
    [one] Una colonna incollata è stata saltata: a destra non ci sono altre colonne. «Tutte le colonne» ne mostra altre
   *[other] { $count } colonne incollate sono state saltate: a destra non ci sono altre colonne. «Tutte le colonne» ne mostra altre
}
parts-page-column-number = N.
parts-page-column-name = Nome
parts-page-column-kind = Tipo
parts-page-column-axis = Asse
parts-page-column-callout = Indicazione
parts-page-column-callout2 = Indicazione Y
parts-page-column-feature = Foro o albero
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Angolo
parts-page-column-clearance = Distanza
parts-page-column-clearance-height = Alt. sicurezza
parts-page-column-cycle = Ciclo
parts-page-column-parameters = Parametri
parts-page-column-material = Materiale
parts-page-column-rule = Regola
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Plausibile
parts-page-column-plausible2 = Plausibile Y
parts-page-column-remark = Nota
parts-page-column-balloon-x = Pallino X
parts-page-column-balloon-y = Pallino Y
parts-page-head-part = Pezzo
parts-page-head-drawing = Disegno
parts-page-head-picture = Immagine
parts-page-head-material = Materiale
parts-page-head-rule = Regola
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Corsa X (mm)
parts-page-head-travel-y = Corsa Y (mm)
parts-page-head-travel-z = Corsa Z (mm)
parts-page-head-remark = Nota
parts-page-head-file = file accanto al piano
parts-page-head-two = min max
parts-page-picture = Immagine del pezzo
parts-page-picture-said = Immagine del pezzo, { $on } di { $count } pallini posizionati
parts-page-picture-none = Nessuna immagine
parts-page-picture-awaited = Lettura dell'immagine
parts-page-picture-folder = { $given } non è il nome di un file accanto al piano: l'immagine deve essere nella cartella del piano, quindi indicarne il nome senza cartella
parts-page-picture-unsaved = Salvare prima il piano: l'immagine deve essere nella stessa cartella
parts-page-picture-elsewhere = { $given } non è nella cartella del piano: copiarla prima lì, così restano insieme
parts-page-picture-large = { $name } ha { $given } KiB; un'immagine ha al massimo { $most } KiB
parts-page-picture-dots = { $name } ha { $width } × { $height } pixel; un'immagine ha al massimo { $most } milioni di pixel
parts-page-picture-kind = { $name } non è un'immagine PNG, JPEG o SVG
parts-page-picture-broken = { $name } non è leggibile come immagine: { $reason }
parts-page-balloon = Pallino { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, prossimo
parts-page-balloon-beside = { $balloon }, non sull'immagine
parts-page-balloon-open = non misurato
parts-page-balloon-skipped = saltato
parts-page-beside = Non ancora sull'immagine: trascinarli sopra
parts-page-beside-more = e altri { $count }
parts-page-balloon-simulated = { $status }, simulato
parts-page-more = Righe e celle
parts-page-picture-heavy = { $name } richiederebbe troppo tempo per il disegno: ha filtri, motivi grandi o troppi livelli; rimuoverli, o salvare l'immagine come PNG
parts-page-csv-copy = Il file è una copia: CSV ha solo gli elementi, e del pezzo viene tralasciato { $keys }
parts-page-opened = { $count ->
    [one] { $name } è aperto, ma il piano tralascia un dato presente nel file
   *[other] { $name } è aperto, ma il piano tralascia { $count } dati presenti nel file
}
parts-page-pasted-twice = Una colonna incollata è stata tralasciata: la prima riga indica più volte { $keys }, e vale la prima colonna con quel nome
parts-page-pasted-unknown = Tralasciate le colonne incollate che un piano non ha: { $names }
parts-page-pasted-nameless = { $count ->
    [one] Una colonna incollata è stata tralasciata: nella prima riga non ha un nome
   *[other] { $count } colonne incollate sono state tralasciate: nella prima riga non hanno un nome
}
parts-page-comments = { $count ->
    [one] Il salvataggio rimuove un commento dal file
   *[other] Il salvataggio rimuove { $count } commenti dal file
}
parts-page-comments-lost = { $count ->
    [one] Un commento è stato rimosso da { $name }: un piano viene scritto senza commenti
   *[other] { $count } commenti sono stati rimossi da { $name }: un piano viene scritto senza commenti
}
