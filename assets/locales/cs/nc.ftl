# Sets of programs, tables and masks for a control.
## Plans
nc-value = { $what }: { $error }
nc-name = název { $name }: dovolena jsou písmena A až Z, číslice a _, nejvýše { $most }
nc-not-on-control = { $kind } se měří cyklem { $cycle }, který { $control } nemá
## Sets
nc-folder = { $folder } není složka pro programy: pište TNC:\ a pak názvy z písmen, číslic, _ a -, oddělené \
nc-no-texts = sada s texty tolerancí je možná jen pro TNC7, ne pro { $control }
nc-series-name = { $name } nemůže být názvem sloupce tabulky série: začněte název písmenem a nepoužívejte NR, PART ani STATUS
nc-series-sizes = série uchovává nejvýše { $most } rozměrů dílu a plán jich má { $sizes }: vytvořte více sad
nc-reads-otherwise = { $file } nelze zapsat tak, aby se zpět přečetl stejně
nc-proof = sada neprošla zkušebním během a nebyla zapsána: { $reason }
nc-proof-no-end = program nekončí
nc-proof-count = změřeno prvků: { $found } z { $expected }
nc-proof-other-verdict = { $name }: výrok se liší od výroku Fitchecku
nc-archive = soubor zip nelze vytvořit: { $reason }
nc-workpiece = obrobek nelze zapsat: { $reason }
nc-own-column = { $class } nepatří mezi 47 tříd NC-Solution 8255: { $table } dostane další sloupec
nc-figure = { $what }
nc-fewer-columns = limit počtu sloupců u iTNC 530: { $table } má jen třídy plánu, { $classes }
nc-by-hand = { $name }: žádný cyklus neměří prvek druhu { $kind }: v sadě není
nc-not-in-set = { $name }: plán uvádí { $said }, ale sada to nepoužívá: na řídicím systému rozhodují jen meze, může tedy udat DOBRÝ i tam, kde fitcheck import ne
nc-features = { $first } (a dalších { $more })
nc-moved-nominal = { $name }: jmenovitý rozměr { $callout } je mimo meze, což TNC7 odmítá: { $parameter } je { $value } mm a { $deviation } se vztahuje k němu
nc-no-place = { $name } potřebuje x, y a z: program tam najíždí
nc-own-cycle = { $name } má vlastní cyklus nebo parametry, které volané programy nepodporují
nc-no-coordinate = chybí { $column }: program tam najíždí
