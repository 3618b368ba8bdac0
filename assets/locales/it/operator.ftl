# La finestra per un operatore

operator-mode = Per chi è questa finestra
operator-mode-about = Un operatore ha misura, risultati e guida, in caratteri grandi; tutto il resto è nella finestra completa
operator-mode-operator = Operatore
operator-mode-operator-about = Misura, risultati e guida, per dita, guanti e due metri di distanza.
operator-mode-full = Tutto
operator-mode-full-about = Tutte le pagine, per la scrivania.
operator-question = Per chi è questa finestra?
operator-question-later = Si può cambiare in ogni momento nelle impostazioni; un operatore vi arriva con «Uscire».
operator-leave = Uscire
operator-report = Rapporto
operator-undo = Annullare
operator-measure = Misurare
operator-results = Risultati
operator-one-size = Una quota
operator-part = Pezzo
operator-last = Ultimi risultati
operator-newer = Più recenti
operator-older = Meno recenti
operator-back-to-results = Tornare ai risultati
operator-dropped = { $name } non si apre qui: un operatore non apre file. Passare prima alla finestra completa.
operator-no-results = Non è stato ancora misurato nulla.
operator-features = { $count ->
    [one] 1 elemento
   *[other] I { $count } elementi
}
operator-next = Avanti
operator-next-part = Pezzo successivo
operator-to-value = Valore
operator-type-callout = Digitare ciò che dice il disegno, come 25 H7.
operator-type-value = Misurare e digitare il valore.
operator-choose-part = Scegliere un pezzo e digitarne il numero di serie.
operator-hole-or-shaft = Che cosa si misura?
operator-plans = Pezzi
operator-no-plans = Su questo computer non è stato ancora aperto alcun piano. I piani si aprono nella finestra completa, nella pagina Pezzi.
operator-go-on-first = Leggere prima l'esito e premere Avanti: ciò che è stato digitato prima non vale

## The PIN
operator-pin = PIN della finestra operatore
operator-pin-about = Lo digita chi lascia la finestra operatore. Si conserva soltanto un hash con salt
operator-pin-use = Bloccare con questo PIN
operator-pin-remove = Rimuovere il PIN
operator-pin-try = Sbloccare
operator-stay = Restare
operator-pin-short = un PIN ha almeno { $least } caratteri
operator-pin-set = La finestra operatore ora è bloccata con un PIN
operator-pin-removed = La finestra operatore non è più bloccata
operator-pin-wrong = Questo non è il PIN
operator-pin-not-hashed = Impossibile calcolare l'hash del PIN: { $why }
operator-pin-asked = Digitare il PIN per lasciare la finestra operatore.
operator-pin-forgotten = Dimenticato? Il manuale dice come entra un amministratore: The operator's window, The PIN.
