# budget

budget-toml = { $said }
budget-too-large = un file di bilancio ha al massimo { $most } KiB
budget-not-one = un bilancio richiede tabelle [[contribution]] oppure una tabella [calibrated]
budget-too-many = { $count } contributi: un bilancio ne ha al massimo { $most }
budget-empty = { $key } è vuoto: atteso un testo
budget-day = { $key }: { $given } non è un giorno: atteso AAAA-MM-GG
budget-days = valid_until { $until } è prima di date { $date }
budget-key = { $table }: { $key } qui non si usa: le chiavi ammesse sono { $allowed }
budget-missing = { $table }: manca { $keys }
budget-range = { $table }: { $key } è { $given }: atteso da { $least } a { $most }
budget-resolution-law = { $table }: una risoluzione è rettangolare: atteso law = "rectangular" o nessun law
budget-geometry = { $table }: { $error }
budget-length = { $key }: { $error }
budget-geometry-touches = { $touches } punti di contatto: attesi da 3 a { $most }
budget-geometry-step = { $touches } punti di contatto ogni { $step } gradi: atteso un passo da 0,01 a { $most } gradi
budget-evaluation-no-size = { $contribution } dipende dalla dimensione, ma nessuna dimensione è indicata
budget-evaluation-no-contacts = { $contribution } dipende dai punti di contatto, ma il bilancio non ha touches e step_deg, e nessun punto di contatto è indicato
budget-evaluation-nothing = ogni contributo è zero
budget-calibrated-too-few = { $readings ->
        [one] una lettura
       *[other] { $readings } letture
    }: ne servono almeno 2
budget-calibrated-far-away = la media delle letture, { $mean } mm, dista più di 1 mm dalla dimensione tarata, { $size } mm
budget-calibrated-nothing = ogni incertezza è zero

budget-warning-expired = il bilancio è scaduto: era valido fino al { $until }
budget-warning-not-yet = il bilancio non è ancora valido: la sua data è { $date }
budget-warning-of-template = il bilancio ha ancora dati del modello per nome, autore o numeri: non dicono nulla di questa stazione
budget-warning-failed-study = uno studio dice di questo strumento: { $why }
budget-warning-template-figures = questi contributi hanno ancora i numeri del modello: { $contributions }. Verificare che valgano per questa stazione
budget-warning-few-readings = { $readings } letture del campione tarato: ISO 15530-3 ne richiede almeno { $fewest }
budget-warning-bias-corrected = errore sistematico { $bias } µm: l'incertezza vale per valori da cui è stato sottratto; Fitcheck non lo sottrae
budget-warning-bias-not-corrected = errore sistematico { $bias } µm: non è corretto, quindi l'incertezza lo comprende
budget-warning-other-size = il campione tarato del bilancio ha { $calibrated } mm, ma sono stati misurati { $measured } mm: l'incertezza vale per pezzi come il campione
budget-warning-other-side = il campione tarato del bilancio è { $calibrated ->
    [hole] un foro, ma è stato misurato un albero
   *[shaft] un albero, ma è stato misurato un foro
    }
budget-warning-other-expansion = { $contribution } del bilancio ha la dilatazione { $budget } · 10⁻⁶/K, ma il valore è stato corretto con { $given }
budget-warning-other-temperature = { $contribution } del bilancio vale per una temperatura a { $budget } K da 20 °C, ma il valore è stato corretto per { $given } K
budget-warning-recorded = { $text }
