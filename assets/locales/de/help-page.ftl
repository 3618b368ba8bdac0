page-help = Hilfe

help-page-help = Hilfe zu dieser Seite
help-page-help-hint = Öffnet das Handbuch; auf der Seite Hilfe zurück zur vorigen Seite
help-page-explain = Dieses Feld erklären
help-page-explain-hint = Zeigt, wozu das Feld dient, mit Einheit, Bereich und einem Beispiel
help-page-about-field = Hilfe zu { $name }
help-page-in-manual = Im Handbuch
help-page-entry = Hilfe: { $title }
help-page-keys = Tastenkürzel
help-page-search = Im Handbuch suchen
help-page-open-found = Besten Treffer öffnen
help-page-nothing = Keine Seite des Handbuchs enthält diese Wörter.
help-page-topics = Inhalt
help-page-list = Seiten des Handbuchs
help-page-found = { $title }, { $heading }
help-page-found-line = { $place }: { $line }
help-page-move = Zu einer anderen Seite des Handbuchs
help-page-read = Seite anzeigen
help-page-scroll = Text verschieben
help-page-back = Zurück
help-page-english = Das Handbuch gibt es nur auf Englisch.

# Beispiele
help-page-samples = Ausprobieren
help-page-sample-value = 25 H7 mit 25,012 ausprobieren
help-page-sample-part = Beispielteil öffnen
help-page-sample-file = Beispieldatei öffnen
help-page-sample-program = Beispielprogramm öffnen
help-page-sample-hint = Die Beispiele sind Bestandteil des Programms. Die Werte in der Beispieldatei sind als simuliert gekennzeichnet.

# Das Blatt mit den Tasten
help-page-keys-about = Eine Taste einer Seite wirkt, solange diese Seite geöffnet ist.
help-page-everywhere = Auf jeder Seite
help-page-in-dialogs = In Dialogen
help-page-on-workpiece = Simuliertes Werkstück
help-page-key-row = { $keys }: { $text }
