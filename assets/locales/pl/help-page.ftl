page-help = Pomoc

help-page-help = Pomoc do tej strony
help-page-help-hint = Otwiera podręcznik; na stronie pomocy wraca do poprzedniej strony
help-page-explain = Objaśnij to pole
help-page-explain-hint = Pokazuje, do czego służy pole, jego jednostkę, zakres i przykład
help-page-about-field = Pomoc: { $name }
help-page-in-manual = W podręczniku
help-page-entry = Pomoc: { $title }
help-page-keys = Skróty klawiszowe
help-page-search = Szukaj w podręczniku
help-page-open-found = Otwórz najlepsze trafienie
help-page-nothing = Żadna strona podręcznika nie zawiera tych słów.
help-page-topics = Spis treści
help-page-list = Strony podręcznika
help-page-found = { $title }, { $heading }
help-page-found-line = { $place }: { $line }
help-page-move = Przejdź do innej strony podręcznika
help-page-read = Pokaż stronę
help-page-scroll = Przewiń tekst
help-page-back = Wstecz
help-page-english = Podręcznik jest w języku angielskim.

# Przykłady
help-page-samples = Wypróbuj
help-page-sample-value = Wypróbuj 25 H7 z 25,012
help-page-sample-part = Otwórz przykładową część
help-page-sample-file = Otwórz przykładowy plik
help-page-sample-program = Otwórz przykładowy program
help-page-sample-hint = Przykłady są częścią programu. Wartości w przykładowym pliku są oznaczone jako symulowane.

# Arkusz klawiszy
help-page-keys-about = Klawisz strony działa, gdy ta strona jest otwarta.
help-page-everywhere = Na każdej stronie
help-page-in-dialogs = W oknach dialogowych
help-page-on-workpiece = Symulowany detal
help-page-key-row = { $keys }: { $text }
