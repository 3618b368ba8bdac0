# Plans of features: what is wrong with one.

plan-no-features = plán nemá žádné prvky
plan-no-form-limit = { $text } není mez tolerance tvaru nebo polohy: uveďte jednu délku větší než 0 v mm, například 0.02
plan-too-many = plán má více než { $most } prvků
plan-too-large = plán má nejvýše { $most } KiB
plan-no-column = chybí sloupec { $column }
plan-unknown-column = neznámý sloupec { $column }: sloupce jsou { $known }
plan-column-twice = sloupec { $column } se vyskytuje dvakrát
plan-cells = řádek má buněk { $found } a záhlaví { $expected }: při desetinné čárce oddělujte sloupce středníky
plan-no-cell = chybí { $column }
plan-value = { $what }: { $error }
plan-no-feature = { $callout } může být díra nebo hřídel: doplňte feature = "hole" nebo feature = "shaft", nebo kind = "length", není-li to ani jedno
plan-fit = { $callout } je uložení: zapište díru a hřídel jako dva prvky
plan-clearance-height = bezpečná výška { $height } mm není nad výškou měření { $z } mm
plan-same-name = název { $name } se vyskytuje dvakrát{ $line ->
    [0] : názvy souborů na řídicím systému nerozlišují velká a malá písmena
   *[other] , poprvé na řádku { $line }: názvy souborů na řídicím systému nerozlišují velká a malá písmena
}
plan-unknown = { $column } { $given } není známo: očekává se { $known }
plan-other-side = druh { $given } odporuje údaji { $column } { $text }, který patří k { $side ->
    [hole] díře
   *[shaft] hřídeli
    }: jedno opravte, nebo pište diameter
plan-not-of = { $kind } nemá { $column }
plan-direction = osa { $given } není směr: očekává se { $known }, nebo tři čísla, například 0.5 0 -1, od -10 do 10 s nejvýše 9 desetinnými místy a ne všechna 0
plan-no-band = { $text } není toleranční pás pro bod, například ±0.05 nebo +0.1/-0.05: { $error }
plan-band-side = bod nemůže mít úchylky od { $lower } do { $upper } mm: cyklus potřebuje horní 0 nebo více a dolní 0 nebo méně, ne obě 0
plan-side-class = { $callout }, { $kind }: obě strany potřebují třídy, například { $example }
plan-face-class = { $callout }: plocha se posuzuje jako vnější rozměr a potřebuje třídu hřídele, například h9
plan-face-place = { $callout }: plocha je podél osy měření na { $coordinate } mm, což musí být její jmenovitý rozměr
plan-not-a-plan = není to plán: plán má řádek s názvy sloupců, například name;callout;x;y;z, nebo začíná fitcheck_plan = 1
plan-other-version = tento plán má verzi { $given }: podporovány jsou verze 1 až { $newest }
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = neznámý klíč { $key }: očekává se { $known }
plan-other-value = { $key }: očekává se { $expected }, nalezeno { $found }
plan-parameter = cyklus { $cycle } nepřebírá z plánu { $given }: pište NAME=VALUE s jedním z { $known }
plan-no-parameter = žádný měřicí cyklus nepřebírá z plánu { $given }: pište NAME=VALUE, například Q423=3
plan-travel = { $axis }{ $given } je mimo pojezd stroje, { $minimum } až { $maximum } mm
plan-clearance-travel = sonda jezdí na Z{ $height }, což je mimo pojezd stroje, { $minimum } až { $maximum } mm: uveďte jinou clearance_height
plan-no-travel = { $given } není pojezd: pište dvě čísla, menší jako první, například -250 250
plan-no-plausible = { $column }: { $given } není rozsah: pište dvě délky v mm, menší jako první, například 24.5 25.5
plan-plausible-limits = { $column }: { $lower } až { $upper } mm neobsahuje meze rozměru, { $minimum } až { $maximum } mm: uveďte širší rozsah
plan-text = { $column }: očekává se jeden řádek s nejvýše { $most } znaky
plan-same-number = { $line ->
    [0] číslo { $number } se vyskytuje dvakrát: jiný prvek má { $other }
   *[other] číslo { $number } se vyskytuje dvakrát: prvek na řádku { $line } má { $other }
}
plan-same-size = { $line ->
    [0] hodnota { $called } by mohla patřit k tomuto prvku nebo k { $other }: jeden z nich přejmenujte
   *[other] hodnota { $called } by mohla patřit k tomuto prvku nebo k { $other } na řádku { $line }: jeden z nich přejmenujte
}
plan-number-is-name = { $line ->
    [0] číslo { $number } je názvem jiného prvku, { $other }
   *[other] číslo { $number } je názvem jiného prvku, { $other } na řádku { $line }
}
plan-name-is-number = { $line ->
    [0] hodnota { $called } by mohla patřit k tomuto prvku nebo k { $other }, jehož je to číslo
   *[other] hodnota { $called } by mohla patřit k tomuto prvku nebo k { $other } na řádku { $line }, jehož je to číslo
}
plan-balloon = { $given } není místo na obrázku: očekává se 0 až 1
plan-not-found-unknown = neposouzeno: žádný prvek plánu nemá tento název, číslo ani polohu
plan-not-found-no-clue = neposouzeno: hodnota nemá název, číslo ani polohu, neodpovídá jí proto žádný prvek plánu
plan-not-found-half-place = neposouzeno: žádný prvek plánu nemá tento název ani číslo a poloha potřebuje X a Y
plan-not-found-contradiction = neposouzeno: název odpovídá { $name } v plánu, ale číslo odpovídá { $number }
plan-not-found-other-name = žádný prvek plánu se nejmenuje { $given }; stejné číslo má { $name }, může však jít o pořadové číslo: pojmenujte prvek jako v plánu, nebo uveďte jeho jmenovitý rozměr
plan-not-found-running-number = neposouzeno: jen číslo odpovídá { $name } v plánu a může jít o pořadové číslo, protože jiné řádky souboru k tomuto plánu nepatří
plan-not-found-other-nominal = neposouzeno: odpovídá { $name } v plánu, ale jmenovitý rozměr je { $given } a v plánu { $planned }
plan-not-found-other-limits = neposouzeno: odpovídá { $name } v plánu, ale meze { $given } nemají nic společného s mezemi plánu { $planned }
plan-not-found-several = neposouzeno: tuto polohu má několik prvků plánu: { $names }
plan-not-found-which-side = neposouzeno: hodnota neříká, o který rozměr jde: { $names }
part-standing = změřeno { $measured }, chybí { $missing }, přeskočeno { $skipped }
plan-not-found-other-kind = neposouzeno: odpovídá { $name } v plánu, to je však { $kind } a měřilo se něco jiného
plan-remark-file = { $said }
plan-remark-left = { $name }: přeskočeno: { $why }
plan-remark-class-left = { $name }: { $class } má jiné meze než soubor; platí meze souboru
plan-remark-place-left = { $name }: poloha nebyla převzata: { $why }
plan-remark-axes-assumed = polohy: soubor neříká, podél kterých os leží jeho díry a hřídele; předpokládá se Z
plan-remark-uncertainty-left = { $name }: rozšířená nejistota { $expanded } mm je přeskočena, protože její polovina není celý počet nanometrů
plan-remark-clearance-raised = { $name } leží nad obvyklou bezpečnou výškou: zapsáno { $height }
plan-simulated-no-place = { $name } nemá v plánu polohu: nelze simulovat
plan-simulated-no-cycle = { $name } neměří žádný cyklus: nelze simulovat
