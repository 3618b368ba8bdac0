# Gdzie w pliku jest błąd lub ostrzeżenie

located-in-file = { $what }: { $file }, linia { $line }, kolumna { $column }
located-in-line-of-file = { $what }: { $file }, linia { $line }
located-at-file = { $what }: { $file }
located-at-column = linia { $line }, kolumna { $column }: { $what }
located-at-line = linia { $line }: { $what }

# Własne teksty użytkownika

own-text-language = { $given } nie zaczyna się od kodu języka. Nazwa pliku z własnymi tekstami zaczyna się od jednego z { $codes }, na przykład nl_OurShop.ftl: zmień nazwę pliku
own-text-too-large = rozmiar pliku w bajtach: { $bytes }, a plik z własnymi tekstami może mieć najwyżej { $most }: zostaw tylko teksty, które są inne
own-text-not-utf8 = bajt { $byte } nie jest UTF-8: zapisz plik jako UTF-8
own-text-syntax = { $given }: nie można odczytać jako Fluent ({ $reason }). Napisz nazwę na początku linii, potem = i tekst, a dalsze linie wetnij
own-text-not-a-text = { $given } to termin lub ma atrybuty, a zastąpić można tylko teksty: napisz nazwa = tekst
own-text-unknown = nie ma tekstu { $name } ani podobnej nazwy. Nazwy są takie jak wbudowanych tekstów: popraw lub usuń
own-text-misspelt = nie ma tekstu { $name }. Najbliższa nazwa to { $nearest }: popraw lub usuń
own-text-twice = { $name } podano dwa razy, najpierw w linii { $first }, i żaden się nie liczy: usuń jeden
own-text-empty = { $given } ma pusty tekst albo wariant, który nic nie pokazuje: napisz tekst albo usuń go, aby mieć wbudowany
own-text-control = { $given } ma znak sterujący { $code }, a dozwolone są tylko znaki widoczne: usuń go
own-text-too-much = { $given }: więcej znaków niż { $longest }, więcej zagnieżdżonych nawiasów niż { $deepest } albo za dużo wariantów: napisz prościej
own-text-surplus = { $name } ma { $given }, w co nic nie jest wstawiane. Możliwe jest tylko { $allowed }: popraw lub usuń
own-text-surplus-of-none = { $name } ma { $given }, ale w ten tekst nic nie jest wstawiane: usuń to
own-text-lost = w { $name } brakuje { $lost } z wbudowanego tekstu, przynajmniej w jednym wariancie, i coś nie byłoby powiedziane: dodaj
own-text-read-back = { $name } mówi, skąd pochodzi wartość, i jest odczytywany z plików, więc nie można go zastąpić: usuń
own-text-property = { $name } należy do języka i nie jest tekstem, który można zastąpić: usuń
own-text-same-verdict = { $name } się nie liczy, bo { $clash } mówi { $word }, a to mówi też { $other }. Każda ocena potrzebuje własnego słowa, także obok wbudowanych i angielskich: daj każdej inne słowo
