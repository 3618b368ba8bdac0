# report

## Errori
report-error-writer = impossibile creare il rapporto { $format }: { $reason }
report-ending-missing = { $file } non ha un'estensione che indichi il formato del rapporto: usarne una tra { $endings }
report-ending-unknown = .{ $ending } non è un formato del rapporto: usarne uno tra { $endings }

## Frasi su un controllo
report-feature-hole = foro
report-feature-shaft = albero
report-side-good = buono
report-side-rework = ripresa
report-side-scrap = scarto
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
report-created = Creato
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

## Una cartella di lavoro
report-sheets = Solo i primi { $listed } di { $total } pezzi hanno un foglio proprio; il foglio dei pezzi li elenca tutti.
report-sheets-corrected = a 20 °C
report-sheets-without = Immagini e punti di contatto non sono in questa cartella di lavoro: un rapporto HTML contiene entrambi, un rapporto JSON i punti di contatto.
report-sheets-cut = { $count ->
    [one] Un testo è abbreviato: una cella contiene al massimo 32767 caratteri.
   *[other] { $count } testi sono abbreviati: una cella contiene al massimo 32767 caratteri.
}
