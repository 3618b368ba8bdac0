# control

# Masks
mask-empty = the mask is empty
mask-unknown = line { $line }, column { $column }: { $found } is no record, keyword or comment
mask-unclosed-quote = line { $line }, column { $column }: the quotation mark is not closed
mask-unknown-format = line { $line }, column { $column }: { $found } is no format, allowed are %S %RS %F %LF %D %I %%
mask-too-wide = line { $line }, column { $column }: { $found } is too wide, at most { $most }
mask-count = line { $line }: { $formats } formats and { $parameters } parameters
mask-unknown-parameter = line { $line }, column { $column }: { $found } is no parameter, allowed are Q, QL, QR, QS with a number, DAY MONTH YEAR2 YEAR4 HOUR MIN SEC CALL_PATH
mask-no-semicolon = line { $line }: the ; at the end is missing
mask-unknown-word = line { $line }: { $word } is not known and has no effect
mask-behind-semicolon = line { $line }: { $found } behind the ; is passed over
mask-undefined = line { $line }, column { $column }: { $name } is not defined
mask-text-as-number = line { $line }, column { $column }: { $name } is a text, the format wants a number
mask-number-as-text = line { $line }, column { $column }: { $name } is a number, the format wants a text
mask-not-finite = line { $line }, column { $column }: { $name } is not a finite number
