# Waar in een bestand een fout of waarschuwing staat

located-in-file = { $what }: { $file }, regel { $line }, kolom { $column }
located-in-line-of-file = { $what }: { $file }, regel { $line }
located-at-file = { $what }: { $file }
located-at-column = regel { $line }, kolom { $column }: { $what }
located-at-line = regel { $line }: { $what }

# Eigen teksten van de gebruiker

own-text-language = { $given } begint niet met de code van een taal. De naam van een bestand met eigen teksten begint met een van { $codes }, zoals nl_OurShop.ftl: geef het bestand een andere naam
own-text-too-large = het bestand heeft { $bytes } bytes en een bestand met eigen teksten mag er { $most } hebben: laat alleen de teksten staan die anders zijn
own-text-not-utf8 = byte { $byte } is geen UTF-8: sla het bestand op als UTF-8
own-text-syntax = { $given } is niet te lezen als Fluent ({ $reason }). Schrijf de naam aan het begin van een regel, dan = en de tekst, en laat de volgende regels inspringen
own-text-not-a-text = { $given } is een term of heeft attributen, en alleen teksten zijn te vervangen: schrijf naam = tekst
own-text-unknown = er is geen tekst { $name }, en geen naam lijkt erop. De namen zijn die van de ingebouwde teksten: verbeter of verwijder hem
own-text-misspelt = er is geen tekst { $name }. De naam die het meest lijkt is { $nearest }: verbeter of verwijder hem
own-text-twice = { $name } is twee keer opgegeven, eerst in regel { $first }, en geen van beide telt: verwijder er een
own-text-empty = { $given } heeft een lege tekst, of een variant die niets laat zien: schrijf een tekst, of verwijder hem voor de ingebouwde
own-text-control = { $given } heeft het stuurteken { $code }, en alleen zichtbare tekens zijn toegestaan: verwijder het
own-text-too-much = { $given } is langer dan { $longest } tekens, heeft accolades meer dan { $deepest } diep, of heeft te veel varianten: schrijf hem eenvoudiger
own-text-surplus = { $name } heeft { $given }, en daarvoor wordt niets ingevuld. Alleen { $allowed } is mogelijk: verbeter of verwijder het
own-text-surplus-of-none = { $name } heeft { $given }, maar in deze tekst wordt niets ingevuld: verwijder het
own-text-lost = { $name } mist { $lost } van de ingebouwde tekst, ten minste in één variant, zodat er iets ongezegd zou blijven: voeg het toe
own-text-read-back = { $name } zegt waar een waarde vandaan komt en wordt uit bestanden teruggelezen, en is daarom niet te vervangen: verwijder hem
own-text-property = { $name } hoort bij de taal en is geen tekst die te vervangen is: verwijder hem
own-text-same-verdict = { $name } telt niet, want { $clash } zegt { $word }, en { $other } zegt dat ook. Oordelen hebben elk een eigen woord nodig, ook naast de ingebouwde en de Engelse: geef ze elk een ander woord
