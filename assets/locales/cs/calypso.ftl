## Tables of CALYPSO
calypso-number = { $column }: { $reason }
calypso-no-actual = ve sloupci actual není naměřená hodnota
calypso-cut-off = chybí poslední řádek END: soubor může být oříznutý
calypso-row-cut-off = soubor zde končí bez konce řádku, řádek tedy může být oříznutý: je přeskočen; je-li úplný, doplňte konec řádku
calypso-zeros = řádek obsahuje bajty s hodnotou 0, soubor tedy nebyl zapsán celý: řádek je přeskočen
calypso-differs = řádky { $name } na řádcích souboru { $first } a { $second } mají různé jmenovité hodnoty nebo meze
calypso-warning-no-end = chybí poslední řádek END: soubor může být oříznutý
calypso-warning-behind = přeskočeno za řádkem END: { $given }
calypso-warning-zeros = soubor zde obsahuje bajty s hodnotou 0, nebyl tedy zapsán celý: řádky mohou chybět
calypso-warning-deviation = tabulka udává úchylku { $given } mm, ale z jejích hodnot vychází { $expected } mm
calypso-warning-exceed = tabulka udává { $given } mm mimo toleranci, ale z jejích hodnot vychází { $expected } mm
