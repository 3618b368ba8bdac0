page-help = Nápověda

help-page-help = Nápověda k této stránce
help-page-help-hint = Otevře příručku; na stránce Nápověda se vrátí na předchozí stránku
help-page-explain = Vysvětlit toto pole
help-page-explain-hint = Ukáže, k čemu pole je, jeho jednotku, rozsah a příklad
help-page-about-field = Nápověda: { $name }
help-page-in-manual = V příručce
help-page-entry = Nápověda: { $title }
help-page-keys = Klávesové zkratky
help-page-search = Hledat v příručce
help-page-open-found = Otevřít nejlepší nález
help-page-nothing = Žádná stránka příručky tato slova nemá.
help-page-topics = Obsah
help-page-list = Stránky příručky
help-page-found = { $title }, { $heading }
help-page-found-line = { $place }: { $line }
help-page-move = Přejít na jinou stránku příručky
help-page-read = Zobrazit stránku
help-page-scroll = Posouvat text
help-page-back = Zpět
help-page-english = Příručka je v angličtině.

# Samples
help-page-samples = Vyzkoušet
help-page-sample-value = Vyzkoušet 25 H7 s 25,012
help-page-sample-part = Otevřít ukázkový díl
help-page-sample-file = Otevřít ukázkový soubor
help-page-sample-program = Otevřít ukázkový program
help-page-sample-hint = Ukázky jsou součástí programu. Hodnoty v ukázkovém souboru jsou označeny jako simulované.

# The sheet of keys
help-page-keys-about = Klávesa stránky funguje, dokud je stránka otevřená.
help-page-everywhere = Na každé stránce
help-page-in-dialogs = V dialozích
help-page-on-workpiece = Simulovaný obrobek
help-page-key-row = { $keys }: { $text }
