page-budget = Nejistota
page-budget-also = Bilance

budget-page-text = Bilance jako TOML
budget-page-none = Vytvořte novou bilanci, nebo ji otevřete
budget-page-new = Nová bilance
budget-page-open = Otevřít bilanci…
budget-page-save = Uložit bilanci jako…
budget-page-dialog-open = Otevřít bilanci
budget-page-dialog-save = Uložit bilanci
budget-page-dialog-readings = Odečty kalibrovaného kusu
budget-page-not-saved = { $name }, neuloženo

budget-page-for = Vyhodnoceno pro
budget-page-size = Měřený rozměr
budget-page-contacts = Body dotyku
budget-page-touches = Počet bodů dotyku
budget-page-step = Krok
budget-page-contacts-hint = Prázdné: body dotyku z bilance
budget-page-day = Den
budget-page-day-hint = Den prázdný: dnes, { $day }
budget-page-no-day = { $given } není den: očekává se YYYY-MM-DD
budget-page-other-missing = Chybí údaj: zadejte počet bodů dotyku i krok, nebo ani jedno
budget-page-take-check = Ze zobrazené kontroly
budget-page-take-recorded = Zaznamenané body dotyku
budget-page-own-contacts = Z bilance
budget-page-of-check = body dotyku: { $count }, z kontroly { $what }, { $time }
budget-page-of-simulated-check = body dotyku: { $count }, z kontroly { $what }, { $time }, simulováno
budget-page-of-recorded = zaznamenané body dotyku: { $count }, { $name }
budget-page-contacts-used = body dotyku: { $count }, činitel { $factor }
budget-page-contacts-stepped = body dotyku: { $count } po { $step }°, činitel { $factor }
budget-page-no-circle = Body dotyku se nepoužijí: { $problem }

budget-page-readings = Odečty
budget-page-open-readings = Ze souboru…
budget-page-take-readings = Z historie
budget-page-own-readings = Z bilance
budget-page-readings-own = { $count ->
        [one] jeden odečet v bilanci
        [few] { $count } odečty v bilanci
       *[other] { $count } odečtů v bilanci
    }
budget-page-readings-of-file = { $count ->
        [one] jeden odečet z { $name }
        [few] { $count } odečty z { $name }
       *[other] { $count } odečtů z { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] jeden odečet: kontrola z historie
        [few] { $count } odečty: všechny kontroly z historie
       *[other] { $count } odečtů: všechny kontroly z historie
    }
budget-page-readings-of-chosen = { $count ->
        [one] jeden odečet: vybraná kontrola z historie
        [few] { $count } odečty: vybrané kontroly z historie
       *[other] { $count } odečtů: vybrané kontroly z historie
    }
budget-page-readings-are-shafts = { $count ->
        [one] jedna kontrola hřídele se nepoužije
        [few] { $count } kontroly hřídelů se nepoužijí
       *[other] { $count } kontrol hřídelů se nepoužije
    }: kus je díra
budget-page-readings-are-holes = { $count ->
        [one] jedna kontrola díry se nepoužije
        [few] { $count } kontroly děr se nepoužijí
       *[other] { $count } kontrol děr se nepoužije
    }: kus je hřídel
budget-page-readings-simulated = { $count ->
        [one] jeden odečet je simulovaný
        [few] { $count } odečty jsou simulované
       *[other] { $count } odečtů je simulovaných
    }: nic se neměřilo
budget-page-more-notes = { $count ->
        [one] a ještě jedna
        [few] a ještě { $count }
       *[other] a ještě { $count }
    }

budget-page-answer = Rozšířená nejistota
budget-page-no-answer = Bez výsledku
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } pro 95,45 %
budget-page-at-size = Pro { $size } mm; každá kontrola má nejistotu svého rozměru
budget-page-covered-by = k = { $k } podle { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Efektivní stupně volnosti { $degrees }
budget-page-infinite = nekonečno
budget-page-valid = Platí do { $until }
budget-page-expired = PROŠLÁ
budget-page-expired-on = platila do { $until }, k datu { $day }
budget-page-not-yet = JEŠTĚ NEPLATÍ
budget-page-not-yet-on = platí od { $date }
budget-page-made = Vytvořil { $by } dne { $date }
budget-page-method = Metoda { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Největší příspěvek
budget-page-largest-is = { $name }, { $percent } % rozptylu
budget-page-help = Co by nejvíce pomohlo
budget-page-help-halved = Jeho polovina: u = { $u } µm
budget-page-help-part-temperature = Poloviční nejistota teploty dílu: u = { $u } µm
budget-page-help-scale-temperature = Poloviční nejistota teploty odměřování: u = { $u } µm
budget-page-help-expansion = Poloviční rozdíl od 20 °C nebo poloviční nejistota roztažnosti: u = { $u } µm
budget-page-help-full-circle = Body dotyku rovnoměrně po celé kružnici, počet { $count }: u = { $u } µm
budget-page-help-more-touches = Body dotyku rovnoměrně po celé kružnici, počet { $count }: u = { $u } µm

budget-page-checks = Kontroly
budget-page-use = Použít pro kontroly
budget-page-leave = Přestat používat
budget-page-uses-none = Kontroly nepoužívají žádnou bilanci
budget-page-uses-this = Používá se: { $name }
budget-page-uses-another = Používá se: { $name } ze souboru { $file }, která se liší od zde zobrazené
budget-page-uses-typed = „{ $name }“ neplatí: kontroly používají nejistotu zvolenou na stránce Kontrola
budget-page-uses-no-rule = „{ $name }“ je zvolena, ale žádné pravidlo na stránce Kontrola zatím nejistotu nepoužívá: zvolte tam pravidlo
budget-page-used-before = Dosud kontroly používaly zadanou nejistotu ({ $uncertainty }). „Přestat používat“ ji vrátí
budget-page-used = Kontroly používají bilanci { $name }
budget-page-used-no-rule = „{ $name }“ zatím nemění žádný výrok: pravidlo na stránce Kontrola je „{ $rule }“ a to nejistotu nepoužívá. Zvolte jiné pravidlo
budget-page-not-kept = Aby se bilance používala i po restartu, uložte ji
budget-page-readings-not-kept = Odečty nejsou v souboru bilance: po restartu se bilance už nepoužije
budget-page-used-unread = { $path }: bilanci používanou pro kontroly nelze přečíst, kontroly proto žádnou nepoužívají: { $problem }

budget-page-table = Příspěvky
budget-page-column-name = Název
budget-page-column-type = Typ
budget-page-column-law = Rozdělení
budget-page-column-sensitivity = c
budget-page-column-share = Podíl
budget-page-row = { $name }, typ { $type }, { $law }, u { $u } { $unit }, citlivost { $sensitivity }, příspěvek { $um } µm, podíl { $percent } %, stupně volnosti { $degrees }
budget-page-law-normal = normální
budget-page-law-rectangular = rovnoměrné
budget-page-law-u-shaped = tvar U
budget-page-law-triangular = trojúhelníkové
budget-page-shares = Podíly na rozptylu
budget-page-terms = Členy a rozšířená nejistota
budget-page-mean = Střední hodnota odečtů { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, s korekcí
budget-page-edition-2004 = U, 2004, bez korekce
budget-page-nothing-seen = Tabulka a podíly se zobrazí, až bude možné bilanci vyhodnotit
budget-page-named = { $name }
budget-page-placeholders = Kontroly zatím tuto bilanci nemohou použít. Tyto údaje jsou ještě ze šablony: { $what }. Zadejte do jejich polí vlastní
budget-page-placeholder-name = její název („{ $name }“)
budget-page-placeholder-by = kdo ji vytvořil („{ $by }“)
budget-page-placeholder-figures = čísla všech příspěvků

## The budget as a table

budget-show-table = Tabulka
budget-show-text = Text
budget-rows = Příspěvky
budget-head-name = Název bilance
budget-head-by = Vytvořil
budget-row-new = Nový příspěvek
budget-row-add = Přidat příspěvek
budget-row-remove = Odebrat příspěvek
budget-row-removed = Příspěvek „{ $name }“ byl z bilance odebrán
budget-row-comments-removed = Komentáře u odebraných klíčů se neuchovaly
budget-row-said = { $value } { $unit }, dělitel { $divisor }, { $law }
budget-row-unread = neúplné
budget-row-name = Název
budget-row-k = Koeficient rozšíření k
budget-row-alpha = Roztažnost, 1/K
budget-row-delta = Rozdíl od 20 °C
budget-row-touches = Vlastní body dotyku
budget-row-step = Vlastní krok
budget-row-sensitivity = Citlivost c
budget-row-freedom = Stupně volnosti
budget-row-freedom-a = Stupně volnosti, n − 1 při n odečtech
budget-row-kind = Působí na
budget-row-type = Typ
budget-row-law = Rozdělení
budget-row-given = Zadáno jako
budget-row-half-width = Poloviční šířka
budget-row-resolution = Krok indikace
budget-given-standard = Standardní nejistota
budget-given-expanded = Rozšířená nejistota
budget-type-a = A, statisticky
budget-type-b = B, jinak
budget-kind-plain = Průměr
budget-kind-scatter = Rozptýlení dotyku
budget-kind-part-temperature = Teplota dílu
budget-kind-scale-temperature = Teplota odměřování
budget-kind-part-expansion = Roztažnost dílu
budget-kind-scale-expansion = Roztažnost odměřování
budget-kind-resolution = Rozlišení
budget-table-stale = V textu je chyba: tabulka ukazuje poslední čitelné příspěvky
budget-table-other = Text zapisuje příspěvky způsobem, který tabulka neumí měnit. Upravte text
budget-table-calibrated = Tato bilance je pro kalibrovaný kus a nemá příspěvky. Upravte text
budget-law-normal = Normální rozdělení
budget-law-rectangular = Rovnoměrné rozdělení
budget-law-u-shaped = Rozdělení tvaru U
budget-law-triangular = Trojúhelníkové rozdělení
