page-parts = Díly
parts-page-walk = Měřit
parts-page-plan = Plán
parts-page-new = Nový plán
parts-page-open = Otevřít plán…
parts-page-save = Uložit plán…
parts-page-save-csv = Uložit plán jako CSV…
parts-page-undo = Zpět
parts-page-redo = Znovu
parts-page-dialog-open = Otevřít plán dílu
parts-page-dialog-save = Uložit plán dílu
parts-page-not-saved = { $name }, neuloženo
parts-page-no-plan = Zatím žádný plán: otevřete jej nebo vytvořte.
parts-page-move = Přejít na jinou buňku
parts-page-extend = Rozšířit výběr
parts-page-edit = Upravit buňku
parts-page-take = Hotovo
parts-page-empty = Vyprázdnit buňky
parts-page-copy = Kopírovat buňky
parts-page-paste = Vložit
parts-page-insert = Přidat řádek
parts-page-delete = Smazat řádky
parts-page-up = Nahoru
parts-page-down = Dolů
parts-page-sort = Seřadit
parts-page-sort-hint = Seřadí podle sloupce aktuální buňky, A2 před A10; dalším seřazením se pořadí obrátí
parts-page-renumber = Přečíslovat
parts-page-renumber-hint = Očísluje prvky od 1 v pořadí řádků
parts-page-all-columns = Všechny sloupce
parts-page-previous = Předchozí chyba
parts-page-next = Další chyba
parts-page-choose-picture = Vybrat obrázek…
parts-page-dialog-picture = Vybrat obrázek dílu
parts-page-table = Prvky plánu
parts-page-cell-name = Buňka plánu
parts-page-cell = Řádek { $row }, { $column }, { $text }
parts-page-cell-empty = Řádek { $row }, { $column }, prázdné
parts-page-cell-wrong = { $cell }, chyba: { $what }
parts-page-new-row = nový
parts-page-limits = Meze
parts-page-editing = { $column }, řádek { $row }
parts-page-head = Díl
parts-page-words = Jedno z: { $words }
parts-page-no-fault = Plán je bez chyb
parts-page-blank = Zadejte první prvek, nebo vložte řádky z tabulkového procesoru
parts-page-faults = { $count ->
    [one] Jedna chyba
    [few] { $count } chyby
   *[other] { $count } chyb
}
parts-page-features = { $count ->
    [one] Jeden prvek
    [few] { $count } prvky
   *[other] { $count } prvků
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Řádek { $row }
parts-page-fault-plan = Plán
parts-page-lost = V souboru je něco nesrozumitelného: dokud se to v souboru neopraví nebo zde nevynechá, plán nic neměří ani neukládá
parts-page-take-meant = Použít { $meant }
parts-page-leave-out = Vynechat
parts-page-leave-out-hint = Plán pak má jen to, co bylo možné přečíst; to nesrozumitelné může být prvek
parts-page-left-out = { $count ->
    [one] { $name }: jedna nesrozumitelná položka je v plánu vynechána; v souboru zůstane do uložení plánu
    [few] { $name }: { $count } nesrozumitelné položky jsou v plánu vynechány; v souboru zůstanou do uložení plánu
   *[other] { $name }: { $count } nesrozumitelných položek je v plánu vynecháno; v souboru zůstanou do uložení plánu
}
parts-page-pasted-rows = { $count ->
    [one] Jeden vložený řádek byl přeskočen: plán má nejvýše { $most } prvků
    [few] { $count } vložené řádky byly přeskočeny: plán má nejvýše { $most } prvků
   *[other] { $count } vložených řádků bylo přeskočeno: plán má nejvýše { $most } prvků
}
parts-page-pasted-columns = { $count ->
    [one] Jeden vložený sloupec byl přeskočen: vpravo už žádný sloupec není. „Všechny sloupce“ zobrazí další
    [few] { $count } vložené sloupce byly přeskočeny: vpravo už žádné sloupce nejsou. „Všechny sloupce“ zobrazí další
   *[other] { $count } vložených sloupců bylo přeskočeno: vpravo už žádné sloupce nejsou. „Všechny sloupce“ zobrazí další
}
parts-page-column-number = Č.
parts-page-column-name = Název
parts-page-column-kind = Druh
parts-page-column-axis = Osa
parts-page-column-callout = Předpis
parts-page-column-callout2 = Předpis Y
parts-page-column-feature = Díra nebo hřídel
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Úhel
parts-page-column-clearance = Bezp. vzdál.
parts-page-column-clearance-height = Bezpečná výška
parts-page-column-cycle = Cyklus
parts-page-column-parameters = Parametry
parts-page-column-material = Materiál
parts-page-column-rule = Pravidlo
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Možné od–do
parts-page-column-plausible2 = Možné od–do Y
parts-page-column-remark = Poznámka
parts-page-column-balloon-x = Bublina X
parts-page-column-balloon-y = Bublina Y
parts-page-head-part = Díl
parts-page-head-drawing = Výkres
parts-page-head-picture = Obrázek
parts-page-head-material = Materiál
parts-page-head-rule = Pravidlo
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Pojezd X (mm)
parts-page-head-travel-y = Pojezd Y (mm)
parts-page-head-travel-z = Pojezd Z (mm)
parts-page-head-remark = Poznámka
parts-page-head-file = soubor vedle plánu
parts-page-head-two = min max
parts-page-picture = Obrázek dílu
parts-page-picture-said = Obrázek dílu, umístěno bublin { $on } z { $count }
parts-page-picture-none = Bez obrázku
parts-page-picture-awaited = Čte se obrázek
parts-page-picture-folder = { $given } není název souboru vedle plánu: obrázek musí být ve složce plánu, zadejte tedy jeho název bez složky
parts-page-picture-unsaved = Nejprve uložte plán: obrázek musí být ve stejné složce
parts-page-picture-elsewhere = { $given } není ve složce plánu: nejprve jej tam zkopírujte, aby oba soubory zůstaly spolu
parts-page-picture-large = { $name } má { $given } KiB; obrázek má nejvýše { $most } KiB
parts-page-picture-dots = { $name } má { $width } × { $height } pixelů; obrázek má nejvýše { $most } milionů pixelů
parts-page-picture-kind = { $name } není obrázek PNG, JPEG ani SVG
parts-page-picture-broken = { $name } nelze přečíst jako obrázek: { $reason }
parts-page-balloon = Bublina { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, další
parts-page-balloon-beside = { $balloon }, mimo obrázek
parts-page-balloon-open = nezměřeno
parts-page-balloon-skipped = přeskočeno
parts-page-beside = Zatím mimo obrázek: přetáhněte na něj
parts-page-beside-more = a dalších { $count }
parts-page-balloon-simulated = { $status }, simulováno
parts-page-more = Řádky a buňky
parts-page-picture-heavy = Vykreslení { $name } by trvalo příliš dlouho: obsahuje filtry, velké vzory nebo příliš mnoho vrstev; odstraňte je, nebo obrázek uložte jako PNG
parts-page-csv-copy = Soubor je kopie: CSV obsahuje jen prvky a { $keys } dílu v něm chybí
parts-page-opened = { $count ->
    [one] { $name } je otevřen, plán však vynechává jednu věc, která v souboru je
    [few] { $name } je otevřen, plán však vynechává { $count } věci, které v souboru jsou
   *[other] { $name } je otevřen, plán však vynechává { $count } věcí, které v souboru jsou
}
parts-page-pasted-twice = Vložený sloupec byl vynechán: první řádek uvádí { $keys } více než jednou a použije se první sloupec toho názvu
parts-page-pasted-unknown = Vložené sloupce, které plán nemá, byly vynechány: { $names }
parts-page-pasted-nameless = { $count ->
    [one] Jeden vložený sloupec byl vynechán: první řádek pro něj nemá název
    [few] { $count } vložené sloupce byly vynechány: první řádek pro ně nemá názvy
   *[other] { $count } vložených sloupců bylo vynecháno: první řádek pro ně nemá názvy
}
parts-page-comments = { $count ->
    [one] Uložením se ze souboru odstraní komentář
    [few] Uložením se ze souboru odstraní { $count } komentáře
   *[other] Uložením se ze souboru odstraní { $count } komentářů
}
parts-page-comments-lost = { $count ->
    [one] Z { $name } byl odstraněn komentář: plán se zapisuje bez komentářů
    [few] Z { $name } byly odstraněny { $count } komentáře: plán se zapisuje bez komentářů
   *[other] Z { $name } bylo odstraněno { $count } komentářů: plán se zapisuje bez komentářů
}
