## Printed reports
printed-no-value = pod { $column } není naměřená hodnota
printed-cells = čísel: { $found }, sloupců: { $expected }; není jasné, které číslo patří do kterého sloupce: vytiskněte zprávu se všemi sloupci
printed-no-column = chybí sloupec { $column }: přidejte naměřené hodnoty do formátu tisku zprávy
printed-no-heading = čísla bez záhlaví nad nimi: chybí začátek rozměru
printed-no-rows = { $name } nemá žádný řádek: zpráva může být oříznutá
printed-minus-sign = dolní tolerance { $given } může ležet pod jmenovitou hodnotou nebo nad ní a žádný jiný řádek to nerozhodne: tiskněte dolní tolerance bez znaménka
printed-unknown-row = neznámá osa { $given }: řádek je přeskočen
printed-warning-deviation = zpráva udává úchylku { $given } mm, ale z jejích čísel vychází { $expected } mm
printed-warning-beyond = zpráva udává { $given } mm mimo toleranci, ale z jejích čísel vychází { $expected } mm
printed-warning-no-end = chybí poslední řádek { $end }: zpráva může být oříznutá
printed-warning-lines = přeskočeno, není to měření: { $text } (řádků tohoto druhu celkem: { $count })
printed-warning-out-of-place = zpráva říká { $given } a žádná ze zde načtených mezí to neříká: podívejte se do zprávy
