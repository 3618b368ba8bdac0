page-help = Guida

help-page-help = Guida di questa pagina
help-page-help-hint = Apre il manuale; nella pagina Guida, torna alla pagina precedente
help-page-explain = Spiegare questo campo
help-page-explain-hint = Mostra a che cosa serve il campo, la sua unità, il suo intervallo e un esempio
help-page-about-field = Guida per { $name }
help-page-in-manual = Nel manuale
help-page-entry = Guida: { $title }
help-page-keys = Tasti di scelta rapida
help-page-search = Cercare nel manuale
help-page-open-found = Aprire il miglior risultato
help-page-nothing = Nessuna pagina del manuale contiene queste parole.
help-page-topics = Indice
help-page-list = Pagine del manuale
help-page-found = { $title }, { $heading }
help-page-found-line = { $place }: { $line }
help-page-move = Passare a un'altra pagina del manuale
help-page-read = Mostrare la pagina
help-page-scroll = Scorrere il testo
help-page-back = Indietro
help-page-english = Il manuale è in inglese.

# Esempi
help-page-samples = Provare
help-page-sample-value = Provare 25 H7 con 25,012
help-page-sample-part = Aprire un pezzo di esempio
help-page-sample-file = Aprire un file di esempio
help-page-sample-program = Aprire un programma di esempio
help-page-sample-hint = Gli esempi fanno parte del programma. I valori del file di esempio sono contrassegnati come simulati.

# La tabella dei tasti
help-page-keys-about = Un tasto di una pagina funziona mentre quella pagina è aperta.
help-page-everywhere = In ogni pagina
help-page-in-dialogs = Nelle finestre di dialogo
help-page-on-workpiece = Pezzo in lavorazione simulato
help-page-key-row = { $keys }: { $text }
