page-budget = Incertezza
page-budget-also = Bilancio

budget-page-text = Bilancio come TOML
budget-page-none = Creare un nuovo bilancio, o aprirne uno
budget-page-new = Nuovo bilancio
budget-page-open = Aprire bilancio…
budget-page-save = Salvare bilancio come…
budget-page-dialog-open = Aprire un bilancio
budget-page-dialog-save = Salvare il bilancio
budget-page-dialog-readings = Letture del campione tarato
budget-page-not-saved = { $name }, non salvato

budget-page-for = Calcolato per
budget-page-size = Dimensione misurata
budget-page-contacts = Punti di contatto
budget-page-touches = Numero di contatti
budget-page-step = Passo
budget-page-contacts-hint = Vuoto: i punti di contatto del bilancio
budget-page-day = Giorno
budget-page-day-hint = Giorno vuoto: oggi, { $day }
budget-page-no-day = { $given } non è un giorno: atteso AAAA-MM-GG
budget-page-other-missing = Manca un valore: indicare sia il numero di contatti sia il passo, o nessuno dei due
budget-page-take-check = Dal controllo mostrato
budget-page-take-recorded = Contatti registrati
budget-page-own-contacts = Dal bilancio
budget-page-of-check = { $count } punti di contatto del controllo { $what }, { $time }
budget-page-of-simulated-check = { $count } punti di contatto del controllo { $what }, { $time }, simulato
budget-page-of-recorded = { $count } punti di contatto registrati di { $name }
budget-page-contacts-used = { $count } punti di contatto, fattore { $factor }
budget-page-contacts-stepped = { $count } punti di contatto ogni { $step }°, fattore { $factor }
budget-page-no-circle = I punti di contatto non vengono usati: { $problem }

budget-page-readings = Letture
budget-page-open-readings = Da un file…
budget-page-take-readings = Dalla cronologia
budget-page-own-readings = Dal bilancio
budget-page-readings-own = { $count ->
        [one] una lettura nel bilancio
       *[other] { $count } letture nel bilancio
    }
budget-page-readings-of-file = { $count ->
        [one] una lettura di { $name }
       *[other] { $count } letture di { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] una lettura: il controllo della cronologia
       *[other] { $count } letture: tutti i controlli della cronologia
    }
budget-page-readings-of-chosen = { $count ->
        [one] una lettura: il controllo selezionato della cronologia
       *[other] { $count } letture: i controlli selezionati della cronologia
    }
budget-page-readings-are-shafts = { $count ->
        [one] un controllo di un albero non viene usato
       *[other] { $count } controlli di alberi non vengono usati
    }: il campione è un foro
budget-page-readings-are-holes = { $count ->
        [one] un controllo di un foro non viene usato
       *[other] { $count } controlli di fori non vengono usati
    }: il campione è un albero
budget-page-readings-simulated = { $count ->
        [one] una lettura è simulata
       *[other] { $count } letture sono simulate
    }: non è stato misurato nulla
budget-page-more-notes = { $count ->
        [one] e un'altra
       *[other] e altre { $count }
    }

budget-page-answer = Incertezza estesa
budget-page-no-answer = Nessun risultato
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } per 95,45 %
budget-page-at-size = Per { $size } mm; ogni controllo ha l'incertezza della propria dimensione
budget-page-covered-by = k = { $k } secondo { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Gradi di libertà efficaci { $degrees }
budget-page-infinite = infiniti
budget-page-valid = Valido fino al { $until }
budget-page-expired = SCADUTO
budget-page-expired-on = valido fino al { $until }, il { $day }
budget-page-not-yet = NON ANCORA VALIDO
budget-page-not-yet-on = valido dal { $date }
budget-page-made = Creato il { $date } da { $by }
budget-page-method = Metodo { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Contributo maggiore
budget-page-largest-is = { $name }, { $percent } % della varianza
budget-page-help = Che cosa aiuterebbe di più
budget-page-help-halved = Dimezzandolo: u = { $u } µm
budget-page-help-part-temperature = Dimezzando l'incertezza della temperatura del pezzo: u = { $u } µm
budget-page-help-scale-temperature = Dimezzando l'incertezza della temperatura delle righe ottiche: u = { $u } µm
budget-page-help-expansion = Dimezzando la distanza da 20 °C, o l'incertezza della dilatazione: u = { $u } µm
budget-page-help-full-circle = { $count } punti di contatto equidistanti sull'intero cerchio: u = { $u } µm
budget-page-help-more-touches = { $count } punti di contatto equidistanti sull'intero cerchio: u = { $u } µm

budget-page-checks = Controlli
budget-page-use = Usare per i controlli
budget-page-leave = Non usare più
budget-page-uses-none = I controlli non usano un bilancio
budget-page-uses-this = In uso: { $name }
budget-page-uses-another = In uso: { $name } da { $file }, che differisce da quanto mostrato qui
budget-page-uses-typed = «{ $name }» non conta: i controlli usano l'incertezza scelta nella pagina Controllo
budget-page-uses-no-rule = «{ $name }» è scelto, ma nella pagina Controllo nessuna regola usa ancora un'incertezza: scegliere lì la regola
budget-page-used-before = Finora i controlli usavano l'incertezza digitata ({ $uncertainty }). «Non usare più» la ripristina
budget-page-used = I controlli usano il bilancio { $name }
budget-page-used-no-rule = «{ $name }» non cambia ancora alcun esito: la regola nella pagina Controllo è «{ $rule }», che non usa incertezze. Scegliere un'altra regola
budget-page-not-kept = Salvare il bilancio per usarlo anche dopo un riavvio
budget-page-readings-not-kept = Le letture non sono nel file del bilancio: dopo un riavvio il bilancio non viene più usato
budget-page-used-unread = { $path }: il bilancio in uso per i controlli non è leggibile, quindi i controlli non usano un bilancio: { $problem }

budget-page-table = Contributi
budget-page-column-name = Nome
budget-page-column-type = Tipo
budget-page-column-law = Distribuz.
budget-page-column-sensitivity = c
budget-page-column-share = Parte
budget-page-row = { $name }, tipo { $type }, { $law }, u { $u } { $unit }, sensibilità { $sensitivity }, contributo { $um } µm, parte { $percent } %, gradi di libertà { $degrees }
budget-page-law-normal = normale
budget-page-law-rectangular = rettangolare
budget-page-law-u-shaped = a U
budget-page-law-triangular = triangolare
budget-page-shares = Parti della varianza
budget-page-terms = Termini e incertezza estesa
budget-page-mean = Media delle letture { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, con correzione
budget-page-edition-2004 = U, 2004, senza correzione
budget-page-nothing-seen = La tabella e le parti appaiono quando il bilancio è calcolabile
budget-page-named = { $name }
budget-page-placeholders = I controlli non possono ancora usare questo bilancio. Questi dati sono ancora quelli del modello: { $what }. Digitare i propri nei rispettivi campi
budget-page-placeholder-name = il nome («{ $name }»)
budget-page-placeholder-by = l'autore («{ $by }»)
budget-page-placeholder-figures = i numeri di tutti i contributi

## Il bilancio come tabella

budget-show-table = Tabella
budget-show-text = Testo
budget-rows = Contributi
budget-head-name = Nome del bilancio
budget-head-by = Creato da
budget-row-new = Nuovo contributo
budget-row-add = Aggiungere contributo
budget-row-remove = Rimuovere contributo
budget-row-removed = Contributo «{ $name }» rimosso dal bilancio
budget-row-comments-removed = I commenti accanto alle chiavi rimosse non ci sono più
budget-row-said = { $value } { $unit }, divisore { $divisor }, { $law }
budget-row-unread = non completo
budget-row-name = Nome
budget-row-k = Fattore di copertura k
budget-row-alpha = Dilatazione, 1/K
budget-row-delta = Distanza da 20 °C
budget-row-touches = Contatti propri
budget-row-step = Passo proprio
budget-row-sensitivity = Sensibilità c
budget-row-freedom = Gradi di libertà
budget-row-freedom-a = Gradi di libertà, n − 1 di n letture
budget-row-kind = Vale per
budget-row-type = Tipo
budget-row-law = Distribuzione
budget-row-given = Indicato come
budget-row-half-width = Semiampiezza
budget-row-resolution = Passo del visualizzatore
budget-given-standard = Incertezza tipo
budget-given-expanded = Incertezza estesa
budget-type-a = A, statistica
budget-type-b = B, altro
budget-kind-plain = Diametro
budget-kind-scatter = Dispersione di un contatto
budget-kind-part-temperature = Temperatura del pezzo
budget-kind-scale-temperature = Temperatura delle righe ottiche
budget-kind-part-expansion = Dilatazione del pezzo
budget-kind-scale-expansion = Dilatazione delle righe ottiche
budget-kind-resolution = Risoluzione
budget-table-stale = Il testo ha un errore: la tabella mostra i contributi com'erano l'ultima volta
budget-table-other = Il testo scrive i contributi in un modo che la tabella non può modificare. Modificare il testo
budget-table-calibrated = Questo bilancio è di un campione tarato e non ha contributi. Modificare il testo
budget-law-normal = Distribuzione normale
budget-law-rectangular = Distribuzione rettangolare
budget-law-u-shaped = Distribuzione a U
budget-law-triangular = Distribuzione triangolare
