## The chain of a journal
journal-hex = "{ $text }" is geen reeks van { $digits } hexadecimale cijfers
journal-break-removed = regel { $number } ontbreekt: daarna komt regel { $next }
journal-break-out-of-order = regel { $number } staat waar hij niet hoort
journal-break-changed = regel { $number } is niet de regel die is geschreven: hij of zijn hash is veranderd, of hij is hier neergezet
journal-break-other-than-kept = regel { $number } is een andere dan elders bekend is: het logboek is vanaf daar of eerder opnieuw geschreven
journal-break-cut-off = het logboek eindigt met regel { $last }, en regel { $known } is elders bekend: de nieuwste regels zijn afgesneden, of een oudere kopie is teruggezet

## Entries
journal-body-json = geen regel van een logboek: { $reason }
