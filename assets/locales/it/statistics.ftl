# statistics

# Perché non c'è un valore
statistics-reason-empty = non ci sono valori
statistics-reason-not-a-number = il valore { $place } non è un numero
statistics-reason-too-few = troppo pochi valori o gruppi: { $found }, ne servono almeno { $needed }
statistics-reason-all-equal = tutti i valori sono uguali: non c'è dispersione con cui calcolare
statistics-reason-no-subgroups = nessun sottogruppo ha due o più valori
statistics-reason-large-subgroup = un sottogruppo ha { $found } valori: l'escursione si usa fino a { $most }
statistics-reason-no-limits = non ci sono limiti
statistics-reason-one-limit = c'è un solo limite, e ne servono due
statistics-reason-swapped-limits = il limite inferiore non è sotto quello superiore
statistics-reason-not-positive = questa distribuzione ha solo valori positivi
statistics-reason-negative = questa distribuzione non ha valori negativi
statistics-reason-no-fit = questa distribuzione non si adatta ai valori
statistics-reason-uneven-cell = letture del pezzo { $part } da parte dell'operatore { $operator }: { $found }, attese { $needed }
statistics-reason-no-baseline = il periodo di riferimento non è nella sua fase, o i suoi valori non sono utilizzabili
statistics-reason-parameter = { $name } non può essere { $given }

# Regole delle carte di controllo, dove una scatta
statistics-rule-beyond-limits = 1 punto oltre un limite di controllo
statistics-rule-nine-one-side = 9 punti di seguito dallo stesso lato della linea centrale
statistics-rule-six-trend = 6 punti di seguito in salita o in discesa
statistics-rule-fourteen-alternating = 14 punti di seguito alternati in su e in giù
statistics-rule-two-of-three = 2 punti su 3 oltre 2 s dallo stesso lato
statistics-rule-four-of-five = 4 punti su 5 oltre 1 s dallo stesso lato
statistics-rule-fifteen-within = 15 punti di seguito entro 1 s dalla linea centrale
statistics-rule-eight-beyond = 8 punti di seguito oltre 1 s, da un lato o dall'altro
statistics-rule-eight-one-side = 8 punti di seguito dallo stesso lato della linea centrale
