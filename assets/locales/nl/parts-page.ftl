page-parts = Onderdelen
parts-page-walk = Meten
parts-page-plan = Plan
parts-page-new = Nieuw plan
parts-page-open = Plan openen…
parts-page-save = Plan opslaan…
parts-page-save-csv = Plan opslaan als CSV…
parts-page-undo = Ongedaan maken
parts-page-redo = Opnieuw
parts-page-dialog-open = Een onderdeelplan openen
parts-page-dialog-save = Het onderdeelplan opslaan
parts-page-not-saved = { $name }, niet opgeslagen
parts-page-no-plan = Nog geen plan: open er een of begin er een.
parts-page-move = Naar een andere cel
parts-page-extend = Selectie uitbreiden
parts-page-edit = Cel bewerken
parts-page-take = Klaar
parts-page-empty = Cellen leegmaken
parts-page-copy = Cellen kopiëren
parts-page-paste = Plakken
parts-page-insert = Rij invoegen
parts-page-delete = Rijen verwijderen
parts-page-up = Omhoog
parts-page-down = Omlaag
parts-page-sort = Sorteren
parts-page-sort-hint = Sorteert op de kolom van de huidige cel, A2 voor A10; nogmaals sorteren keert de volgorde om
parts-page-renumber = Nummeren
parts-page-renumber-hint = Nummert de elementen vanaf 1 in de volgorde van de rijen
parts-page-all-columns = Alle kolommen
parts-page-previous = Vorige fout
parts-page-next = Volgende fout
parts-page-choose-picture = Afbeelding kiezen…
parts-page-dialog-picture = Afbeelding van het onderdeel kiezen
parts-page-table = Elementen van het plan
parts-page-cell-name = Cel van het plan
parts-page-cell = Rij { $row }, { $column }, { $text }
parts-page-cell-empty = Rij { $row }, { $column }, leeg
parts-page-cell-wrong = { $cell }, fout: { $what }
parts-page-new-row = nieuw
parts-page-limits = Grensmaten
parts-page-editing = { $column } van rij { $row }
parts-page-head = Onderdeel
parts-page-words = Een van: { $words }
parts-page-no-fault = Geen fouten in het plan
parts-page-blank = Typ het eerste element, of plak rijen uit een spreadsheet
parts-page-faults = { $count ->
    [one] Eén fout
   *[other] { $count } fouten
}
parts-page-features = { $count ->
    [one] Eén element
   *[other] { $count } elementen
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Rij { $row }
parts-page-fault-plan = Plan
parts-page-lost = Niet begrepen in het bestand: het plan meet en bewaart niets tot dit in het bestand gecorrigeerd of hier weggelaten is
parts-page-take-meant = { $meant } gebruiken
parts-page-leave-out = Deze weglaten
parts-page-leave-out-hint = Het plan heeft dan alleen wat gelezen kon worden; wat niet begrepen is, kan een element zijn
parts-page-left-out = { $count ->
    [one] { $name }: één vermelding die niet begrepen is, is uit het plan weggelaten; het bestand houdt die tot het plan wordt opgeslagen
   *[other] { $name }: { $count } vermeldingen die niet begrepen zijn, zijn uit het plan weggelaten; het bestand houdt ze tot het plan wordt opgeslagen
}
parts-page-pasted-rows = { $count ->
    [one] Eén geplakte rij is overgeslagen: een plan heeft hoogstens { $most } elementen
   *[other] { $count } geplakte rijen zijn overgeslagen: een plan heeft hoogstens { $most } elementen
}
parts-page-pasted-columns = { $count ->
    [one] Eén geplakte kolom is weggelaten: rechts ervan zijn er geen meer. “Alle kolommen” toont er meer
   *[other] { $count } geplakte kolommen zijn weggelaten: rechts zijn er geen meer. “Alle kolommen” toont er meer
}
parts-page-column-number = Nr.
parts-page-column-name = Naam
parts-page-column-kind = Soort
parts-page-column-axis = As
parts-page-column-callout = Passing
parts-page-column-callout2 = Passing Y
parts-page-column-feature = Boring of as
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Hoek
parts-page-column-clearance = Afstand
parts-page-column-clearance-height = Veilige hoogte
parts-page-column-cycle = Cyclus
parts-page-column-parameters = Parameters
parts-page-column-material = Materiaal
parts-page-column-rule = Regel
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Plausibel
parts-page-column-plausible2 = Plausibel Y
parts-page-column-remark = Opmerking
parts-page-column-balloon-x = Ballon X
parts-page-column-balloon-y = Ballon Y
parts-page-head-part = Onderdeel
parts-page-head-drawing = Tekening
parts-page-head-picture = Afbeelding
parts-page-head-material = Materiaal
parts-page-head-rule = Beslisregel
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Bereik X (mm)
parts-page-head-travel-y = Bereik Y (mm)
parts-page-head-travel-z = Bereik Z (mm)
parts-page-head-remark = Opmerking
parts-page-head-file = bestand naast het plan
parts-page-head-two = van tot
parts-page-picture = Afbeelding van het onderdeel
parts-page-picture-said = Afbeelding van het onderdeel, { $on } van { $count } ballonnen geplaatst
parts-page-picture-none = Geen afbeelding
parts-page-picture-awaited = De afbeelding wordt gelezen
parts-page-picture-folder = { $given } is niet de naam van een bestand naast het plan: de afbeelding moet in de map van het plan staan, geef de naam dus zonder map
parts-page-picture-unsaved = Sla het plan eerst op: de afbeelding moet in dezelfde map staan
parts-page-picture-elsewhere = { $given } staat niet in de map van het plan: kopieer de afbeelding eerst daarheen, dan blijven beide bij elkaar
parts-page-picture-large = { $name } heeft { $given } KiB; een afbeelding heeft hoogstens { $most } KiB
parts-page-picture-dots = { $name } heeft { $width } × { $height } pixels; een afbeelding heeft hoogstens { $most } miljoen pixels
parts-page-picture-kind = { $name } is geen PNG-, JPEG- of SVG-afbeelding
parts-page-picture-broken = { $name } kan niet als afbeelding worden gelezen: { $reason }
parts-page-balloon = Ballon { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, volgende
parts-page-balloon-beside = { $balloon }, niet op de afbeelding
parts-page-balloon-open = niet gemeten
parts-page-balloon-skipped = overgeslagen
parts-page-beside = Nog niet op de afbeelding: sleep ze erheen
parts-page-beside-more = en nog { $count }
parts-page-balloon-simulated = { $status }, gesimuleerd
parts-page-more = Rijen en cellen
parts-page-picture-heavy = { $name } tekenen duurt te lang: er zijn filters, grote patronen of te veel lagen; verwijder ze, of sla de afbeelding op als PNG
parts-page-csv-copy = Het bestand is een kopie: CSV heeft alleen de elementen, en { $keys } van het onderdeel blijft weg
parts-page-opened = { $count ->
    [one] { $name } is open, maar één ding uit het bestand ontbreekt in het plan
   *[other] { $name } is open, maar { $count } dingen uit het bestand ontbreken in het plan
}
parts-page-pasted-twice = Een geplakte kolom is weggelaten: de eerste rij noemt { $keys } meer dan eens, en de eerste kolom met die naam telt
parts-page-pasted-unknown = Geplakte kolommen die een plan niet heeft, zijn weggelaten: { $names }
parts-page-pasted-nameless = { $count ->
    [one] Eén geplakte kolom is weggelaten: de eerste rij heeft er geen naam boven
   *[other] { $count } geplakte kolommen zijn weggelaten: de eerste rij heeft er geen namen boven
}
parts-page-comments = { $count ->
    [one] Bij het opslaan verdwijnt een opmerking uit het bestand
   *[other] Bij het opslaan verdwijnen { $count } opmerkingen uit het bestand
}
parts-page-comments-lost = { $count ->
    [one] Een opmerking is uit { $name } verdwenen: een plan wordt zonder opmerkingen geschreven
   *[other] { $count } opmerkingen zijn uit { $name } verdwenen: een plan wordt zonder opmerkingen geschreven
}
