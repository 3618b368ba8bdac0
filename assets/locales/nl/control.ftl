# control

# Maskers
mask-empty = het masker is leeg
mask-unknown = regel { $line }, kolom { $column }: { $found } is geen uitvoerregel, sleutelwoord of commentaar
mask-unclosed-quote = regel { $line }, kolom { $column }: het aanhalingsteken wordt niet gesloten
mask-unknown-format = regel { $line }, kolom { $column }: { $found } is geen formaat, toegestaan zijn %S %RS %F %LF %D %I %%
mask-too-wide = regel { $line }, kolom { $column }: { $found } is te breed, hoogstens { $most }
mask-count = regel { $line }: { $formats } formaten en { $parameters } parameters
mask-unknown-parameter = regel { $line }, kolom { $column }: { $found } is geen parameter, toegestaan zijn Q, QL, QR, QS met een nummer, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = regel { $line }: de ; aan het einde ontbreekt
mask-unknown-word = regel { $line }: { $word } is onbekend en heeft geen werking
mask-behind-semicolon = regel { $line }: { $found } achter de ; wordt overgeslagen
mask-undefined = regel { $line }, kolom { $column }: { $name } heeft geen waarde
mask-text-as-number = regel { $line }, kolom { $column }: { $name } is een tekst, het formaat vraagt een getal
mask-number-as-text = regel { $line }, kolom { $column }: { $name } is een getal, het formaat vraagt een tekst
mask-not-finite = regel { $line }, kolom { $column }: { $name } is geen eindig getal
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
