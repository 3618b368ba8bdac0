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
