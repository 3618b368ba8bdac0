# control

# Meetprotocollen
log-at-line = regel { $line }: { $reason }
log-empty = het bestand is leeg
log-no-log = hier staat geen meetprotocol: er is geen titelregel met het nummer van een meetcyclus
log-no-title = een protocol zonder titelregel: onbekend is met welke cyclus is gemeten
log-other-cycle = protocollen van cyclus { $cycle } worden niet gelezen, alleen die van 421, 422 en 427
log-unit = maateenheid { $given } is niet 0 (mm) en niet 1 (inch)
log-number = { $reason }
log-count = { $section } heeft { $found } getallen, het moeten er { $expected } zijn
log-missing = { $section } ontbreekt: het protocol is afgebroken of niet volledig
log-no-label = voor { $given } staat niet wat het is
log-cut-figure = het bestand eindigt midden in dit getal: { $given } is misschien niet volledig
log-swapped = maximum { $maximum } ligt onder minimum { $minimum }
log-uneven = de grenzen { $minimum } en { $maximum } liggen niet gelijk om de nominale waarde { $nominal }
log-deviation = afwijking { $given } is niet werkelijke min nominale waarde, { $actual } - { $nominal }
log-not-positive = diameter { $given } is niet groter dan 0
log-section-nominal = het blok met nominale waarden
log-section-limits = het blok met grenswaarden
log-section-actual = het blok met werkelijke waarden
log-section-deviations = het blok met afwijkingen
log-no-unit = geen regel noemt de maateenheid: millimeter aangenomen
log-no-time = datum en tijd van de meting zijn niet bekend
log-no-deviations = de afwijkingen ontbreken: het protocol is misschien afgebroken
log-ignored = niet gebruikt: { $text }
log-text-before = de tekst voor het eerste protocol is niet gebruikt
