## The chain of a journal
journal-hex = "{ $text }" is geen reeks van { $digits } hexadecimale cijfers
journal-break-removed = regel { $number } ontbreekt: daarna komt regel { $next }
journal-break-out-of-order = regel { $number } staat waar hij niet hoort
journal-break-changed = regel { $number } is niet de regel die is geschreven: hij of zijn hash is veranderd, of hij is hier neergezet
journal-break-other-than-kept = regel { $number } is een andere dan elders bekend is: het logboek is vanaf daar of eerder opnieuw geschreven
journal-break-cut-off = het logboek eindigt met regel { $last }, en regel { $known } is elders bekend: de nieuwste regels zijn afgesneden, of een oudere kopie is teruggezet

## Entries
journal-body-json = geen regel van een logboek: { $reason }
journal-body-newer = gemaakt door een nieuwere Fitcheck: versie { $version } van het formaat, deze Fitcheck leest versies tot en met { $known }
journal-body-too-large = geen regel van een logboek: { $bytes } bytes, hoogstens { $most } zijn toegestaan
journal-body-too-long = { $field } heeft { $bytes } bytes, hoogstens { $most } zijn toegestaan
journal-body-control = { $field } heeft het stuurteken { $code } als teken { $place }: teksten van een logboek zijn één regel zonder stuurtekens
journal-body-empty = { $field } is leeg
journal-body-too-many = { $field } heeft { $count } onderdelen, hoogstens { $most } zijn toegestaan
journal-body-value = { $field } kan niet "{ $given }" zijn
journal-body-contradiction = { $field } zegt iets anders dan de velden waaruit het volgt
journal-check-judged-otherwise = geoordeeld als { $kept }, en dat blijft zo; deze versie van Fitcheck oordeelt { $now }
