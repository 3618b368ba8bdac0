# tolerance

## Lengths
length-empty = brakuje długości
length-not-a-number = { $text } nie jest liczbą
length-ambiguous = { $text } jest niejednoznaczne: wpisać jeden znak dziesiętny, bez separatora tysięcy
length-too-fine = { $text } jest dokładniejsze niż nanometr
length-too-large = { $text } jest za duże: najwyżej { $max } mm w obie strony

## Callouts and classes
callout-empty = brakuje wymiaru tolerowanego: wpisać wymiar nominalny i klasę tolerancji, np. 25 H7
callout-no-nominal = { $text } nie zaczyna się od wymiaru nominalnego: wpisać go, np. 25 H7
callout-nominal = wymiar nominalny: { $error }
callout-not-positive = wymiar nominalny { $nominal } mm nie jest większy od 0
class-missing = brakuje klasy tolerancji, np. H7 dla otworu lub h7 dla wałka
class-mixed-case = { $text } miesza wielkie i małe litery: wpisać { $upper } dla otworu lub { $lower } dla wałka
class-malformed = { $text } nie jest klasą tolerancji: wpisać litery i stopień, np. H7 lub js13

## Deviations and limits
deviations-order = odchyłka górna { $upper } mm jest poniżej odchyłki dolnej { $lower } mm
nominal-by-operator = ? oznacza, że sondę ustawia operator: zapisz wartość nominalną bez tego znaku
nominal-not-probed = @ oznacza, że sterowanie nie mierzy i przyjmuje wartość po tym znaku: nic nie zostałoby zmierzone
source-choice-iso286 = ISO 286, każda klasa do 3150 mm
source-choice-control = Tabele sterowania, 47 klas do 400 mm
source-choice-after-own = Własne tabele, potem { $base }
source-iso286 = ISO 286, ponad { $over } do { $to } mm
source-iso286-remark = ISO 286, ponad { $over } do { $to } mm; { $remark }
source-shipped-table = wbudowana tabela { $name }, ponad { $over } do { $to } mm
source-table = tabela { $name }, ponad { $over } do { $to } mm
figure-own-table = { $class } ponad { $over } do { $to } mm: tabela { $table } różni się od ISO 286, gdzie jest { $upper } i { $lower } mm
figure-standard = { $class } ponad { $over } do { $to } mm: { $why }
source-file = plik { $name }
source-iso2768 = ISO 2768-1 klasa { $class }, ponad { $over } do { $to } mm
source-callout = sam wymiar tolerowany
source-without-own = { $source }; nie można było odczytać własnych tabel w { $folder }
source-recorded = { $text }
limits-own-awaited = Trwa odczyt własnych tabel w { $folder }
limits-no-feature = { $callout } nie mówi, czy chodzi o otwór, czy o wałek
limits-other-feature = { $feature ->
    [hole] { $class } jest klasą otworu, a nie wałka
   *[shaft] { $class } jest klasą wałka, a nie otworu
}
limits-other-case = { $feature ->
    [hole] { $class } jest klasą otworu i nie ma jej w tabeli { $table }; klasa wałka to { $other }
   *[shaft] { $class } jest klasą wałka i nie ma jej w tabeli { $table }; klasa otworu to { $other }
}
limits-unknown-class = { $class } nie ma w tabeli { $table }; są w niej { $known }
limits-no-own-table = { $class } nie jest klasą tolerancji według ISO 286: wpisać litery i stopień, np. H7 lub js13, albo wybrać własne tabele z kolumną { $class }
limits-no-own-column = { $class } nie jest klasą tolerancji według ISO 286, a tabela { $table } nie ma kolumny { $class }: są w niej { $known }
limits-beyond-last-range = wymiar nominalny { $nominal } mm wykracza poza tabelę { $table }, której ostatni zakres to ponad { $over } do { $to } mm włącznie
limits-not-defined = { $class } nie jest zdefiniowana dla wymiarów ponad { $over } do { $to } mm w tabeli { $table }; { $where }
limits-defined-nowhere = nie jest zdefiniowana dla żadnego wymiaru
limits-defined = jest zdefiniowana dla wymiarów { $ranges }
limits-range = ponad { $over } do { $to } mm
limits-ranges = { $first }, { $rest }
limits-too-large = wymiary graniczne dla { $nominal } mm są za duże

## Zones out of all proportion
zone-micrometres = pole tolerancji { $width } mm jest niewspółmierne do { $nominal } mm, dla którego IT 18 wynosi { $widest } mm: jeśli odchyłki są w mikrometrach, wpisać { $offer }
zone-wide = pole tolerancji { $width } mm jest niewspółmierne do { $nominal } mm, dla którego IT 18 wynosi { $widest } mm: sprawdzić wymiar nominalny i wymiary graniczne
zone-micrometres-to-zero = wymiar minimalny { $minimum } mm nie jest większy od 0: jeśli odchyłki są w mikrometrach, wpisać { $offer }
zone-to-zero = wymiar minimalny { $minimum } mm nie jest większy od 0: sprawdzić wymiar nominalny i wymiary graniczne
zone-coordinate-micrometres = pole tolerancji { $width } mm jest szersze niż { $widest } mm, maksimum dla współrzędnej: jeśli odchyłki są w mikrometrach, wpisać { $offer }
zone-coordinate = pole tolerancji { $width } mm jest szersze niż { $widest } mm, maksimum dla współrzędnej: sprawdzić granice

shape-no-ranges = tabela nie ma zakresu wymiarów
shape-not-ascending = zakres wymiarów do { $end } mm nie kończy się powyżej poprzedniego, { $before } mm
shape-cells = liczba komórek w kolumnie { $class }: { $cells }, liczba zakresów wymiarów: { $ranges }
shape-twice = kolumna { $class } występuje dwa razy

## Verdicts
status-good = DOBRY
status-accepted = PRZYJĘTY
status-rework = POPRAWKA
status-re-measure = POWTÓRZYĆ
status-out-of-limits = POZA TOLERANCJĄ
status-scrap = BRAK
rule-simple = bez pasma ochronnego, granice należą do pola tolerancji
rule-iso14253-2017 = ISO 14253-1:2017, zgodność 95 %, { $prover ->
    [customer] odbiorca wykazuje niezgodność
   *[supplier] dostawca wykazuje zgodność
    }; { $u }
rule-iso14253-1998 = ISO 14253-1:1998, pasmo ochronne U, { $prover ->
    [customer] odbiorca wykazuje niezgodność
   *[supplier] dostawca wykazuje zgodność
    }; { $u }
rule-ilac-g8 = ILAC-G8, pasmo ochronne { $factor } U, { $prover ->
    [customer] odbiorca wykazuje niezgodność
   *[supplier] dostawca wykazuje zgodność
    }; { $u }
rule-asme-simple = ASME B89.7.3.1, prosta akceptacja 4:1; { $u }
rule-asme-stringent = ASME B89.7.3.1, akceptacja zaostrzona, pasmo ochronne { $factor } U; { $u }
rule-asme-relaxed = ASME B89.7.3.1, akceptacja złagodzona o { $factor } U; { $u }
rule-fixed = pasmo ochronne { $width } µm, { $prover ->
    [customer] odbiorca wykazuje niezgodność
   *[supplier] dostawca wykazuje zgodność
    }
rule-no-uncertainty = reguła { $rule } wymaga niepewności wartości zmierzonej
rule-no-factor = reguła { $rule } nie ma współczynnika
rule-no-width = reguła { $rule } oblicza pasmo ochronne z niepewności
rule-width-missing = reguła { $rule } wymaga pasma ochronnego większego niż 0 µm
rule-no-prover = reguła { $rule } nie zależy od ciężaru dowodu
uncertainty = u = { $u } µm, U = { $expanded } µm (k = { $k })
uncertainty-not-positive = niepewność musi być większa niż 0 µm
uncertainty-factor = współczynnik rozszerzenia { $given }: oczekiwana liczba od 1 do 10, najwyżej trzy miejsca po przecinku
uncertainty-by-budget = u każdej wartości z budżetu
undecided-contacts = niepewność średnicy z punktów pomiarowych ({ $contacts }) jest { $times } razy większa niż z { $contacts } punktów na pełnym okręgu, a podana niepewność obowiązuje tylko do 3 razy: rozłożyć punkty na dłuższym łuku lub podać budżet
doubt-times-inch = wartość zmierzona to 25,4 razy wymiar nominalny: czy przeliczono ją dwa razy z cali?
doubt-inches = wartość zmierzona to wymiar nominalny podzielony przez 25,4: czy jest w calach?
doubt-double = wartość zmierzona to dwa razy wymiar nominalny: czy średnicę wzięto za promień?
doubt-half = wartość zmierzona to połowa wymiaru nominalnego: czy to promień?
doubt-decimal-sign = wartość zmierzona to w przybliżeniu wymiar nominalny z przesuniętym znakiem dziesiętnym: czy to { $meant } mm?
doubt-far = wartość zmierzona jest { $distance } mm poza granicami: czy to ta część, w milimetrach?
doubt-implausible = wartość zmierzona leży poza tym, co według planu jest możliwe, od { $lower } do { $upper } mm: czy jednostka i znak dziesiętny są poprawne?

## Files
file-is-folder = to folder, a nie plik: { $path }
file-missing = nie ma takiego pliku ani folderu: { $path }
file-exists = plik lub folder o tej nazwie już istnieje: { $path }
file-half-set = zapisywanie zestawu plików przerwało się w połowie, więc część plików w folderze jest stara, a część nowa: zapisać zestaw ponownie, aby go dokończyć; to, co trzeba jeszcze przenieść, jest w { $path }
file-not-a-file = to potok lub urządzenie, a nie plik: { $path }
file-changed = plik zmienił się podczas odczytu; odczytać go ponownie: { $path }
file-busy = plik jest otwarty w innym programie: zamknąć go tam i spróbować ponownie: { $path }
file-stopped = zatrzymano: nic nie zapisano: { $path }
file-too-large = plik jest większy niż { $limit } MiB: { $path }
file-system = { $reason }: { $path }

## ISO 286
iso286-grade-missing = { $class } nie jest klasą tolerancji według ISO 286: wpisać litery i stopień, np. H7 lub js13
iso286-no-grade = { $class } nie jest klasą tolerancji według ISO 286: stopnie to { $grades }
iso286-no-letter = { $class } nie jest klasą tolerancji według ISO 286: litera { $letters } nie istnieje, są tylko { $known }
iso286-too-large = wymiar nominalny { $nominal } mm wykracza poza ISO 286, która kończy się na 3150 mm
iso286-not-here = { $class } nie jest zdefiniowana dla { $nominal } mm w ISO 286; { $where }
iso286-js-rounded = JS zaokrąglone jak w 1988
iso286-contested-ef = sporne: ef wynosi tu 28 µm, inne źródła podają 25 µm
iso286-older-it5 = do stosowania próbnego; starsze katalogi mają tu mniejsze IT5
iso286-trial-use = do stosowania próbnego

## Fits
fit-kind-clearance = pasowanie luźne
fit-kind-transition = pasowanie mieszane
fit-kind-interference = pasowanie ciasne
fit-basis-hole = stały otwór
fit-basis-shaft = stały wałek
fit-basis-both = stały otwór i stały wałek
fit-preferred-hole-basis = pasowanie zalecane, stały otwór
fit-preferred-shaft-basis = pasowanie zalecane, stały wałek
fit-function-loose-running = obrotowe bardzo luźne
fit-function-free-running = obrotowe swobodne
fit-function-close-running = obrotowe dokładne
fit-function-sliding = suwliwe
fit-function-locational-clearance = ustalające luźne
fit-function-locational-transition = ustalające mieszane
fit-function-locational-transition-tighter = ustalające mieszane, ciaśniejsze
fit-function-locational-interference = ustalające ciasne
fit-function-medium-drive = wtłaczane średnie
fit-function-force = wtłaczane mocne
fit-one-sided = { $callout } nie jest pasowaniem: wpisać wymiar, klasę otworu i klasę wałka, np. 25 H7/g6
fit-not-a-hole = od { $minimum } do { $maximum } mm to wymiary graniczne wałka: oczekiwane są wymiary otworu
fit-not-a-shaft = od { $minimum } do { $maximum } mm to wymiary graniczne otworu: oczekiwane są wymiary wałka
fit-nominal-sizes = pasowanie ma jeden wymiar nominalny: otwór ma { $hole } mm, wałek { $shaft } mm
fit-too-large = luz jest za duży
fit-search-order = najmniejszy luz { $minimum } mm jest większy od największego { $maximum } mm
fit-search-no-classes = w tabelach nie ma klas zarówno otworu, jak i wałka dla { $nominal } mm
fit-thermal-too-fine = { $text } ma więcej niż trzy miejsca po przecinku
fit-thermal-temperature = temperatura { $text } °C jest poza zakresem: od -273,15 do 1000 °C
fit-thermal-expansion = rozszerzalność { $text } jest poza zakresem: od -20 do 500, w milionowych częściach na kelwin, np. 11,5 dla stali
fit-thermal-expansion-unit = rozszerzalność { $text } jest w innej jednostce: podaje się ją w milionowych częściach na kelwin; wpisać { $meant }

## Temperatures that are doubted
thermal-doubt-fahrenheit = { $given } °C jest dalekie od temperatur, w których mierzy się części: jeśli to stopnie Fahrenheita, wpisać { $meant }
thermal-doubt-kelvin = { $given } °C jest dalekie od temperatur, w których mierzy się części: jeśli to kelwiny, wpisać { $meant }
thermal-doubt-far = { $given } °C jest dalekie od temperatur, w których mierzy się części, od { $least } do { $most } °C: sprawdzić
thermal-doubt-beyond = { $given } °C jest poza zakresem od { $least } do { $most } °C, w którym obowiązuje rozszerzalność { $expansion } milionowych części na kelwin: podać rozszerzalność dla tej temperatury

## Materials
material-published = wartość z publikacji
material-verify = wartość typowa, do sprawdzenia
material-own = własna wartość
material-toml = { $reason }
material-version = wersja { $found } pliku materiałów nie jest obsługiwana: oczekiwana wersja { $known }
material-too-many = za dużo materiałów, { $count }: najwyżej { $most }
material-too-large = plik materiałów ma najwyżej { $most } { $most ->
        [one] bajt
        [few] bajty
        [many] bajtów
       *[other] bajtów
    }
material-name = nazwa materiału ma od 1 do { $longest } { $longest ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    }, bez znaków sterujących
material-range = zakres temperatur zaczyna się od niższej: wpisać dwie liczby w °C, np. [-50, 200]
material-elastic = modulus i poisson podaje się razem: modulus od 1 do 1200000 MPa, poisson od 0 do 0.5, yield od 1 do 10000 MPa
material-twice = materiał { $name } jest zdefiniowany dwa razy
material-unknown = nieznany materiał { $name }: wybrać jeden z { $known } lub podać samą rozszerzalność, np. 11,5
## Callouts: deviations, limits, fits and general tolerances
callout-at = { $reason } (znak { $at })
callout-no-tolerance = brakuje tolerancji, np. H7, h7, H7/g6, m, +0,1 -0,2 lub ±0,1
callout-general-capital = { $capital } nie ma stopnia: wpisać { $offer } dla tolerancji ogólnej według ISO 2768-1 lub dodać stopień, np. { $capital }7
callout-fit-order = wałek stoi przed otworem: wpisać { $offer }
callout-fit-side = { $first } i { $second } to nie otwór i wałek: pasowanie zapisuje się wielkimi, potem małymi literami, np. 25 H7/g6
callout-number = { $part }: { $error }
callout-not-a = { $found } to nie { $part }: { $how }
callout-missing = brakuje ({ $part }): { $how }
callout-part-deviation = odchyłka
callout-part-limit = wymiar graniczny
callout-part-actual = wartość po @
callout-how-deviation = wpisać znak i liczbę, np. +0,1 lub -0,1
callout-how-limit = wpisać dwa wymiary, najpierw większy, np. 12,01/11,985
callout-how-actual = wpisać liczbę, np. 10H7@10,004
callout-no-sign = { $number } nie ma znaku: dla odchyłki wpisać +{ $number } lub -{ $number }, bez spacji w liczbie
callout-no-unit = { $number } nie ma jednostki, a druga odchyłka jest w µm: wpisać jednostkę przy obu
callout-deviation-order = odchyłka dolna stoi przed górną: wpisać { $offer }
callout-limits-order = mniejszy wymiar graniczny stoi przed większym: wpisać { $offer }
callout-limits-apart = { $larger } mm to ponad dwa razy { $smaller } mm, więc to raczej nie wymiary graniczne: wpisać odchyłki, np. 12 +0,2 0
callout-limits-or-deviation = to niejednoznaczne: wpisać { $limits } dla wymiarów granicznych lub { $deviation } dla odchyłki dolnej
callout-limits-meant = po takiej odchyłce nie zostałby żaden wymiar: wpisać { $limits } dla wymiarów granicznych
callout-minimum-not-positive = wymiar minimalny { $minimum } mm nie jest większy od 0
callout-micrometres-meant = wymiar minimalny { $minimum } mm nie jest większy od 0: jeśli odchyłki są w mikrometrach, wpisać { $offer }
callout-mixed-decimals = { $number } ma inny znak dziesiętny niż liczba przed nią: użyć jednego
callout-cycle-sign = { $sign } służy w tekstach cykli 14xx, nie w wymiarze tolerowanym
callout-not-in-cycle-text = { $found } nie może stać w tekście cykli 14xx: wpisać klasę, klasę ogólną lub odchyłki
callout-too-much = { $found } jest tu zbędne: tekst jest bez tego kompletny
callout-too-long = tekst jest za długi: najwyżej { $most } { $most ->
        [one] znak
        [few] znaki
        [many] znaków
       *[other] znaków
    }
callout-band-order = odchyłka dolna stoi przed górną: wpisać QS400 jako 0.4-0.1
callout-lone-order = odchyłka dolna stoi przed górną: wpisać { $offer }
callout-inch = { $given } to { $nominal } mm: wymiary są w milimetrach, napisz { $offer }
callout-inch-size = { $given } to { $nominal } mm: napisz wymiar i tolerancję w milimetrach
callout-inch-somewhere = { $given } jest w calach: napisz wymiar i tolerancję w milimetrach, 1 cal to 25.4 mm
callout-thread = { $given } to gwint, a nie gładki otwór ani wałek: napisz średnicę wewnętrzną lub podziałową z obiema granicami, np. 5.153/4.917
callout-exact = wymiar teoretycznie dokładny nie ma własnej tolerancji: napisz wymiar z granicami, które go dotyczą, np. 25 ±0.1
callout-reference = wymiar w nawiasie jest pomocniczy i nie ma tolerancji: napisz go bez nawiasu, jeśli ma być oceniany
callout-one-sided = { $given } ma tylko jedną granicę: napisz oba wymiary graniczne, większy najpierw, np. 8.2/8
callout-roughness = { $given } to chropowatość, a nie wymiar: napisz wymiar z tolerancją, np. 25 H7
callout-modifier = { $given } nie jest modyfikatorem ISO 14405-1: modyfikatory to { $known }
callout-grade = { $given } nie jest zdefiniowane dla { $nominal } mm: napisz klasę dokładności od IT1 do IT18, którą ISO 286 tam podaje
callout-ansi = { $class } to klasa ANSI B4.1, której tablic Fitcheck nie ma: napisz klasę ISO 286 albo wymiar i odchyłki w milimetrach
callout-stated-micrometres = odchyłki za tolerancją są nieproporcjonalne do { $nominal } mm: jeśli są w mikrometrach, napisz ({ $offer })
callout-stated-of-fit = odchyłki za pasowaniem mogą dotyczyć każdej z części: napisz je za każdą klasą osobno
iso286-grade-alone = { $class } to klasa dokładności: mówi, jak szerokie jest pole, ale nie, gdzie leży; napisz ±{ $grade }/2 albo klasę, np. H7
general-too-small = wymiar nominalny { $nominal } mm jest poniżej { $first } mm, gdzie zaczyna się ISO 2768-1: wpisać odchyłki przy wymiarze
general-too-large = wymiar nominalny { $nominal } mm wykracza poza ISO 2768-1, która kończy się na { $last } mm
general-not-defined = ISO 2768-1 nie definiuje klasy { $class } dla wymiarów { $range }; jest zdefiniowana dla wymiarów { $defined }
general-range-from = od { $over } do { $to } mm

## Tables made of the standard
make-no-class = nie podano klasy tolerancji: wpisać jedną lub więcej, np. H7 H8 JS9
make-both-features = { $hole } i { $shaft } nie mogą być w jednej tabeli: różnią się tylko wielkością liter, więc zrobić osobną tabelę dla otworów i dla wałków
make-last-size = ostatni wymiar to { $to } mm: musi być większy od 0 i najwyżej 3150 mm

## Press fits
press-no-interference = pasowanie ma luz co najmniej { $clearance } mm: połączenie wciskowe wymaga wcisku, np. 40 H7/s6
press-length = długość { $length } mm nie jest większa od 0
press-hub-outer = średnica zewnętrzna piasty { $given } mm nie jest większa od średnicy połączenia { $nominal } mm
press-shaft-bore = otwór wału { $given } mm: napisz 0 dla wału pełnego albo otwór mniejszy niż { $nominal } mm
press-roughness = chropowatość { $given } mm jest mniejsza od 0
press-friction = połączenie wciskowe wymaga tarcia większego od 0
press-material = moduł sprężystości materiału { $name } nie jest znany: wybierz inny materiał albo dodaj modulus i poisson do pliku własnych materiałów
press-ratio = { $text } nie jest liczbą od 0 do 1 z najwyżej trzema miejscami po przecinku
press-yields = NIESPRĘŻYSTE: naprężenie { $part ->
    [hole] piasty
   *[shaft] wału
    } wyniosłoby { $stress } MPa, powyżej granicy plastyczności { $limit } MPa: teoria sprężystości nie obowiązuje i nie twierdzi się, że cokolwiek trzyma
press-yield-unknown = nie wiadomo, czy { $part ->
    [hole] piasta
   *[shaft] wał
    } się uplastyczni: materiał nie ma tu granicy plastyczności; podaj ją
press-may-be-loose = części mogą mieć luz { $clearance } mm: połączenie może wcale nie trzymać
press-all-smoothed = wygładzenie chropowatości, { $loss } mm, może zużyć wcisk: połączenie może wcale nie trzymać
press-no-roughness = nie podano chropowatości Rz: nie odjęto straty wcisku przez wygładzenie
press-too-hot = samo nagrzanie piasty nie wystarczy do { $most } °C, dokąd znana jest jej rozszerzalność
press-too-cold = samo oziębienie wału nie wystarczy, nawet w ciekłym azocie
press-contraction-unknown = skurcz materiału wału na zimno nie jest znany: użyto jego rozszerzalności, wał może musieć być zimniejszy
