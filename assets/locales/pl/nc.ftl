# Sets of programs, tables and masks for a control.
## Plans
nc-value = { $what }: { $error }
nc-name = nazwa { $name }: dozwolone są litery A do Z, cyfry i _, najwyżej { $most }
nc-not-on-control = { $kind }: pomiar cyklem { $cycle }, którego { $control } nie ma
## Sets
nc-folder = { $folder } nie jest folderem na programy: wpisać TNC:\ i nazwy z liter, cyfr, _ i -, rozdzielone przez \
nc-no-texts = zestaw z tekstami tolerancji jest możliwy tylko dla TNC7, nie dla { $control }
nc-series-name = { $name } nie może być nazwą kolumny tabeli serii: zacznij nazwę od litery i nie używaj NR, PART ani STATUS
nc-series-sizes = seria przechowuje najwyżej { $most } wymiarów części, a plan ma ich { $sizes }: utwórz kilka zestawów
nc-reads-otherwise = { $file } nie można zapisać tak, aby odczytać go tak samo
nc-proof = wykonanie próbne zestawu nie powiodło się i zestawu nie zapisano: { $reason }
nc-proof-no-end = program się nie kończy
nc-proof-count = zmierzono { $found } z { $expected } elementów
nc-proof-other-verdict = { $name }: ocena różni się od oceny Fitcheck
nc-archive = nie można utworzyć pliku zip: { $reason }
nc-workpiece = nie można zapisać detalu: { $reason }
nc-own-column = { $class } nie należy do 47 klas NC-Solution 8255: { $table } dostaje dodatkową kolumnę
nc-figure = { $what }
nc-fewer-columns = limit kolumn iTNC 530: { $table } ma tylko klasy planu, { $classes }
nc-by-hand = { $name }: żaden cykl nie mierzy elementu rodzaju { $kind }: nie ma go w zestawie
nc-not-in-set = { $name }: plan podaje { $said }, ale zestaw tego nie używa: na sterowaniu decydują same granice, więc może ono podać DOBRY tam, gdzie fitcheck import nie poda
nc-features = { $first } (i jeszcze { $more })
nc-moved-nominal = { $name }: wymiar nominalny { $callout } jest poza granicami, co TNC7 odrzuca: { $parameter } to { $value } mm, a { $deviation } odnosi się do tego
nc-no-place = { $name } wymaga x, y i z: tam przejeżdża program
nc-own-cycle = { $name } ma własny cykl lub parametry, których wywoływane programy nie obsługują
nc-no-coordinate = nie podano { $column }: tam przejeżdża program
