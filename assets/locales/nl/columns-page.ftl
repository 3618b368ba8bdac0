# De kolommen van een bestand met metingen: bekeken, verbeterd en onthouden.

columns-page-import = Kolommen…
columns-page-hint = Toont hoe elke kolom van een bestand wordt gelezen, voordat de waarden worden geïmporteerd
columns-page-take = Importeren
columns-page-correct = Kolommen…
columns-page-forget = Deze kolommen vergeten
columns-page-dialog = Importeren en kolommen kiezen
columns-page-title = Kolommen van { $name }
columns-page-wanted = Kies wat elke kolom bevat. Bestanden met dezelfde opbouw worden op dezelfde manier gelezen.
columns-page-uncertain = Van sommige kolommen is de inhoud niet zeker: controleer wat elke kolom bevat en importeer dan. Bestanden met dezelfde opbouw worden op dezelfde manier gelezen.
columns-page-sheet = Blad
columns-page-separator = Scheidingsteken
columns-page-separator-semicolon = Puntkomma
columns-page-separator-comma = Komma
columns-page-separator-tab = Tab
columns-page-separator-pipe = Verticale streep
columns-page-decimal = Decimaalteken
columns-page-decimal-point = Punt
columns-page-decimal-comma = Komma
columns-page-as-found = Zoals in het bestand
columns-page-unit = Eenheid van maten
columns-page-place-unit = Eenheid van X, Y, Z
columns-page-unit-names = Volgens de kop, anders mm
columns-page-unit-from = Uit het bestand: { $from }
columns-page-unit-mm = mm
columns-page-unit-um = µm
columns-page-unit-inch = inch
columns-page-first-row = Eerste rij
columns-page-below-header = Onder de kop
columns-page-line = Regel { $line }
columns-page-column = { $number } { $name }
columns-page-role-none = niet gebruikt
columns-page-role-name = naam
columns-page-role-number = nummer
columns-page-role-callout = passing
columns-page-role-nominal = nominale maat
columns-page-role-measured = gemeten waarde
columns-page-role-time = tijd
columns-page-role-simulated = gesimuleerd
columns-page-role-part = onderdeel
columns-page-role-serial = serienummer
columns-page-role-who = gemeten door
columns-page-role-x = X
columns-page-role-y = Y
columns-page-role-z = Z
columns-page-role-quantity = wat gemeten is
columns-page-header = { $line } kop
columns-page-row = { $line }
columns-page-not-read = { $line } niet gelezen
columns-page-read = { $rows ->
        [0] Geen van de getoonde rijen wordt gelezen
        [one] { $read } van 1 getoonde rij wordt een waarde
       *[other] { $read } van de { $rows } getoonde rijen worden waarden
    }
columns-page-first-problem = Eerste probleem: { $why }
columns-page-no-measured = Geen kolom bevat de gemeten waarde: kies die
columns-page-no-callout = Geen kolom bevat de passing, dus geen waarde kan worden beoordeeld: kies die
columns-page-no-name = Geen kolom zegt van welk element een waarde is: kies naam, nummer, of X en Y
columns-page-taken = Kolommen: { $columns }; eenheid van maten: { $unit }
columns-page-taken-one = { $column } → { $role }
columns-page-remembered = Kolommen gelezen zoals gecorrigeerd op { $day }
columns-page-forgotten = De kolommen zijn vergeten: het volgende bestand met deze opbouw wordt gelezen alsof het het eerste was. De waarden van dit bestand blijven.
columns-page-none = { $name } is geen tabel met kolommen
columns-page-large = { $name } is te groot om met gecorrigeerde kolommen in het venster te lezen: gebruik fitcheck import --columns
