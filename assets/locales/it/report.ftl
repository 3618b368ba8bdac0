# report

## Errori
report-error-writer = impossibile creare il rapporto { $format }: { $reason }
report-error-label-alone = { $format } è per le etichette: scegliere il modello label, oppure la carta small-label o large-label
report-error-no-statistics = { $format } non ha posto per le statistiche: scegliere PDF, HTML o Markdown
report-attachment-too-large = i dati del file superano { $most } byte
report-attachment-packed = i dati nel file sono compressi con { $filter }, che Fitcheck non legge
report-attachment-damaged = i dati nel file sono danneggiati: { $reason }
report-attachment-several = il file ha { $count } allegati con controlli: se ne aspetta uno
report-difference-field = voce { $number }: { $field } è { $said } nel file, { $kept } nel registro
report-difference-missing = voce { $number }: nessun controllo del file dice ciò che dice il registro
report-difference-more = { $count ->
    [one] il file ha 1 controllo di troppo
   *[other] il file ha { $count } controlli di troppo
}
report-difference-fewer = { $count ->
    [one] nel file manca 1 controllo
   *[other] nel file mancano { $count } controlli
}
report-data-json = i dati del file non sono un rapporto di Fitcheck: { $reason }
report-ending-missing = { $file } non ha un'estensione che indichi il formato del rapporto: usarne una tra { $endings }
report-ending-unknown = .{ $ending } non è un formato del rapporto: usarne uno tra { $endings }

## Frasi su un controllo
report-feature-hole = foro
report-feature-shaft = albero
report-feature-neither = né foro né albero
report-side-good = buono
report-side-rework = ripresa
report-side-scrap = scarto
report-side-out = fuori limite
report-side-too-small = troppo piccolo
report-side-too-large = troppo grande
report-source-instead = { $source }; ISO 286 dice qui { $upper } e { $lower } µm
report-too-small = { $um } µm troppo piccolo
report-too-large = { $um } µm troppo grande
report-inside = entro i limiti
report-above-minimum = { $um } µm sopra il minimo
report-below-minimum = { $um } µm sotto il minimo
report-below-maximum = { $um } µm sotto il massimo
report-above-maximum = { $um } µm sopra il massimo
report-position-unknown = non misurata
report-position-unmonitored = non sorvegliata
report-position-in = ENTRO
report-position-out = FUORI
report-axis-unmonitored = { $axis } { $deviation } mm: non sorvegliato
report-axis-in = { $axis } { $deviation } mm, ammesso ± { $tolerance } mm: ENTRO
report-axis-out = { $axis } { $deviation } mm, ammesso ± { $tolerance } mm: FUORI
report-cause-position = il centro è fuori posizione; la sola dimensione: { $status }
report-origin-circle = { $origin }; cerchio ai minimi quadrati per { $contacts } punti di contatto
report-centre = centro misurato X { $x } mm, Y { $y } mm
report-band-nominal = quota nominale { $size } mm
report-band-title = Banda dei limiti, misurato { $value }: { $distances }
report-in-guard-band = nulla è deciso: il valore è in una banda di guardia della regola di decisione
report-corrected = misurato { $measured } mm a { $temperature } °C, dilatazione { $expansion } · 10⁻⁶/K: corretto di { $change } µm a { $reference } mm a 20 °C
report-all-corrected = misurato a { $temperature } °C, dilatazione { $expansion } · 10⁻⁶/K; ogni valore è corretto a 20 °C
report-scales = righe ottiche a { $temperature } °C, { $expansion } · 10⁻⁶/K
report-scales-none = senza correzione delle righe ottiche
report-own-uncertainty = u di ogni valore accanto al suo controllo
report-accepted-zone = da { $least } a { $most } mm
report-accepted-none = nessuno: la regola non lascia nulla di questa tolleranza
report-proven = provato secondo questa regola
report-not-proven = non provato secondo questa regola
report-conformity = conforme con una probabilità di { $percent } %
report-budget-made = { $name }, creato il { $date } da { $by }, valido fino al { $until }
report-budget-expired = SCADUTO il giorno del controllo
report-budget-not-yet = NON ANCORA VALIDO il giorno del controllo
report-guard-undecided = banda di guardia: rimisurare
report-guard-beyond = banda di guardia: accettato oltre il limite
report-guard-range = { $what }, da { $from } a { $to } µm

## La pagina
report-title = Rapporto di controllo
report-part = Pezzo
report-order = Commessa
report-inspector = Controllore
report-program = Programma
report-notes = Righe saltate e avvisi
report-no-checks = Questo rapporto non ha controlli.
report-page-all-good = Nessuno dei { $total } controlli è elencato in questa pagina: tutti sono buoni e nessuno è dubbio. Un rapporto CSV o JSON elenca ogni controllo.
report-page-not-good = Questa pagina elenca solo i { $listed } controlli su { $total } che non sono buoni o sono dubbi. I conteggi comprendono ogni controllo; un rapporto CSV o JSON li elenca tutti.
report-page-first = Questa pagina elenca solo i primi { $listed } dei { $wanted } controlli che non sono buoni o sono dubbi, su { $total } controlli. I conteggi comprendono ogni controllo; un rapporto CSV o JSON li elenca tutti.
report-total = Totale
report-check = Controllo
report-id = Nome
report-callout = Indicazione
report-heading-without-callout = { $nominal } mm, limiti senza classe
report-verdict = Esito
report-nominal = Quota nominale
report-maximum = Massimo
report-minimum = Minimo
report-measured = Misurato
report-deviation = Scostamento
report-remove = Da asportare
report-on-diameter = sul diametro
report-per-side = per lato
report-remove-to-limit = fino al limite più vicino
report-remove-to-middle = fino al centro della zona di tolleranza
report-remove-to-accepted = fino ai valori accettati
report-position = Posizione
report-limits-from = Limiti da
report-measured-from = Valore misurato
report-from = Provenienza
report-limits = Limiti
report-missing = Mancanti
report-skipped = Saltate
report-verdict-from = Regola di decisione
report-temperature = Temperatura
report-accepted = Valori accettati
report-proof = Prova
report-budget = Bilancio dell'incertezza
report-cannot-tell = Limitazioni di questa misura
report-contacts = Punti di contatto
report-contacts-at-end = alla fine del rapporto
report-contact = N.
report-radial = scostamento radiale
report-sign-name = Nome
report-sign-date = Data
report-sign-signature = Firma
report-footer = Ogni esito si basa su valori non arrotondati e sui limiti e la regola di decisione indicati accanto.

## Note
report-note = { $place }: { $what }
report-note-line = { $place }, linea { $line }: { $what }
report-note-more = { $count ->
    [one] 1 altra nota non è elencata
   *[other] Altre { $count } note non sono elencate
}

## Un pezzo intero
report-balloon = Pallino
report-picture-room = { $name } non è mostrata qui: le immagini di tutti i pezzi renderebbero la pagina troppo grande
report-picture-beside = { $count ->
    [one] un elemento non vi ha un pallino
   *[other] { $count } elementi non vi hanno un pallino
}
report-part-older = { $count ->
    [one] Un altro valore non è elencato: per ogni quota è elencato solo il valore che conta
   *[other] Altri { $count } valori non sono elencati: per ogni quota è elencato solo il valore che conta
}
report-more-parts = { $count ->
    [one] Un altro pezzo non è mostrato per intero; i suoi valori sono nell'elenco
   *[other] Altri { $count } pezzi non sono mostrati per intero, solo i primi { $most } lo sono; i loro valori sono nell'elenco
}

## Modelli di rapporto
report-template-toml = { $reason }
report-template-version = la versione { $found } del modello non è supportata: serve la versione { $known }
report-template-too-large = un modello ha al massimo { $most } byte
report-template-text = { $key } è vuoto, supera { $longest } caratteri o contiene un carattere di controllo
report-template-twice = { $key } elenca { $word } due volte
report-template-empty = { $key } è vuoto: serve almeno una voce
report-template-language = { $given } non è una lingua dei rapporti: usare una di { $known }
report-template-logo = il logo { $given } deve essere il nome di un file accanto al modello
report-section-verdict = Esito
report-section-head = Intestazione
report-section-picture = Immagine con pallini
report-section-lot = Pezzi, il peggiore per primo
report-section-statistics = Statistica degli elementi
report-statistics-limits = I limiti variano da valore a valore: non è indicata alcuna capacità.
report-statistics-most = La statistica contiene solo i primi { $count } valori.
report-section-features = Valori
report-section-statement = Dichiarazione di conformità
report-section-rule = Regola e limiti a parole
report-section-caveats = Limitazioni della misura
report-section-remarks = Osservazioni
report-section-signature = Riga della firma
report-section-code = Codice della registrazione
report-revision = Revisione
report-serial = Numero di serie
report-batch = Lotto
report-customer = Cliente
report-material = Materiale
report-station = Stazione
report-instrument = Strumento
report-calibrated = Tarato
report-date = Data
report-plan = Piano
report-records = Registrazioni
report-blank = Valore
report-remark = Osservazione
report-paper-a4 = A4
report-paper-letter = US Letter
report-paper-small-label = Etichetta 62 × 29 mm
report-paper-large-label = Etichetta 100 × 50 mm
report-template-inspection = Rapporto di controllo
report-template-inspection-purpose = Pezzi o controlli, con immagini
report-template-first-article = Primo pezzo
report-template-first-article-purpose = Ogni elemento, anche ciò che manca
report-template-certificate = Certificato
report-template-certificate-purpose = Valori e dichiarazione di conformità
report-template-list = Elenco dei controlli
report-template-list-purpose = Tutti i controlli uno sotto l’altro
report-template-statistics = Statistica
report-template-statistics-purpose = Ogni elemento su tutti i suoi valori, con grafici
report-template-sheet = Foglio di misura
report-template-sheet-purpose = Vuoto, da compilare a mano
report-template-label = Etichetta
report-template-label-purpose = Esito, pezzo e numero di serie
## Pagine da stampare
report-pdf-page = Pagina { $page } di { $pages }
report-pdf-band = Banda dei limiti
report-pdf-remove = { $name }: asportare { $um } µm sul diametro
report-pdf-simulated = Valori simulati, che nessuno ha misurato: { $count } su { $total }
report-pdf-beyond = Valori che la regola di decisione accetta fuori dai limiti: { $count } su { $total }
report-pdf-corrected = Valori corretti a 20 °C: { $count } su { $total }
report-pdf-guarded = Valori con una propria regola di decisione: { $count } su { $total }
report-pdf-doubted = Valori dubbi, con un punto interrogativo: { $count } su { $total }
report-pdf-notes = Righe saltate e avvisi, elencati alla fine: { $count }
report-pdf-more-lacks = Altro sulle pagine dei pezzi: { $count }
report-pdf-more = Altri nei dati allegati: { $count }
report-pdf-all-checks = Tutti i controlli
report-pdf-attached = Allegato a questo file, per i programmi: { $names }
report-pdf-not-attached = Non tutti i dati sono allegati: un file di più di { $most } MB sarebbe troppo grande
report-pdf-contacts = I punti di contatto sono nei dati allegati.
report-pdf-cut = Un testo che finisce con … qui è tagliato; nei dati allegati è intero.
report-pdf-substituted = Un □ sta per un carattere che manca nei font di queste pagine, come quelli scritti da destra a sinistra; il testo copiato e i dati allegati contengono il carattere.
report-statement-conforms = { $count ->
    [one] Dichiarazione di conformità: il valore è entro i limiti secondo la regola di decisione indicata.
   *[other] Dichiarazione di conformità: tutti i { $count } valori sono entro i limiti secondo la regola di decisione indicata.
}
report-statement-not = { $count ->
    [one] Nessuna conformità: il valore non è conforme secondo la regola di decisione indicata.
   *[other] Nessuna conformità: { $bad } valori su { $count } non sono conformi secondo la regola di decisione indicata.
}
report-statement-partial = Nessuna dichiarazione di conformità: alcune righe sono state rifiutate, non valutate o non lette. Il rapporto le elenca.
report-statement-simulated = { $count ->
    [one] Nessuna dichiarazione di conformità: un valore è simulato e nessuno lo ha misurato.
   *[other] Nessuna dichiarazione di conformità: { $count } valori sono simulati e nessuno li ha misurati.
}
report-statement-open = Nessuna dichiarazione di conformità: mancano valori, { $count } in tutto.
report-code-said = Codice della registrazione { $number }, il suo hash { $hash }
report-lot-order = Il pezzo peggiore è il primo.
## Una cartella di lavoro
report-sheets = Solo i primi { $listed } di { $total } pezzi hanno un foglio proprio; il foglio dei pezzi li elenca tutti.
report-sheets-corrected = a 20 °C
report-sheets-without = Immagini e punti di contatto non sono in questa cartella di lavoro: un rapporto HTML contiene entrambi, un rapporto JSON i punti di contatto.
report-sheets-cut = { $count ->
    [one] Un testo è abbreviato: una cella contiene al massimo 32767 caratteri.
   *[other] { $count } testi sono abbreviati: una cella contiene al massimo 32767 caratteri.
}
report-journal = Registrazioni { $numbers } del registro { $chain }; la sua ultima voce allora: { $number }:{ $hash }
report-template-new-about = Un modello di rapporti. Eliminare ciò che un rapporto non deve mostrare; togliere il # da ciò che deve mostrare.
report-template-new-name = Nuovo modello
report-changed-since = Modifiche rispetto al rapporto del { $since }:
report-changed-none = nessun risultato e nessun limite
report-changed-result = { $name }: { $before } → { $now }
report-changed-limits = { $name }: limiti da { $low } a { $high } → da { $lower } a { $higher } mm
report-changed-added = { $name }: nuovo
report-changed-removed = { $name }: non è più nel rapporto
report-changed-several = { $name }: non confrontato, perché ci sono più valori
report-since-no-report = non è un rapporto di Fitcheck con i suoi dati: indicare il PDF o il JSON
