# Where an error or a warning is in a file

located-in-file = { $what }: { $file }, line { $line }, column { $column }
located-in-line-of-file = { $what }: { $file }, line { $line }
located-at-file = { $what }: { $file }
located-at-column = line { $line }, column { $column }: { $what }
located-at-line = line { $line }: { $what }

# Texts of the user's own

own-text-language = { $given } begins with no code of a language. The name of a file of own texts begins with one of { $codes }, such as nl_OurShop.ftl: rename the file
own-text-too-large = the file has { $bytes } bytes, and a file of own texts may have { $most }: keep only the texts that are other ones
own-text-not-utf8 = byte { $byte } is no UTF-8: save the file as UTF-8
own-text-syntax = { $given } cannot be read as Fluent ({ $reason }). Write the name at the beginning of a line, = and the text, and indent its further lines
own-text-not-a-text = { $given } is a term or has attributes, and only texts can be replaced: write it as name = text
own-text-unknown = there is no text { $name }, and no name is like it. The names are those of the built-in texts: correct it or delete it
own-text-misspelt = there is no text { $name }. The nearest name is { $nearest }: correct it or delete it
own-text-twice = { $name } is given twice, first in line { $first }, and neither counts: delete one of them
own-text-empty = { $given } has an empty text, or a variant that shows nothing: write a text, or delete it to have the built-in one
own-text-control = { $given } has the control character { $code }, and only characters that can be seen are allowed: delete it
own-text-too-much = { $given } is longer than { $longest } characters, has braces more than { $deepest } deep, or has too many variants: write it more simply
own-text-surplus = { $name } has { $given }, which nothing is put in for. Only { $allowed } can be shown: correct it or delete it
own-text-surplus-of-none = { $name } has { $given }, but nothing is put into this text: delete it
own-text-lost = { $name } lacks { $lost } of the built-in text, at least in one variant, so that something would not be said: put it in
own-text-read-back = { $name } says where a value comes from and is read back from files, so it cannot be replaced: delete it
own-text-property = { $name } belongs to the language itself and cannot be replaced: delete it
own-text-same-verdict = { $name } does not count, for { $clash } says { $word }, which { $other } says as well. Verdicts need words of their own, also beside the built-in and the English ones: give each another word
