# Where an error or a warning is in a file

located-in-file = { $what }: { $file }, řádek { $line }, sloupec { $column }
located-in-line-of-file = { $what }: { $file }, řádek { $line }
located-at-file = { $what }: { $file }
located-at-column = řádek { $line }, sloupec { $column }: { $what }
located-at-line = řádek { $line }: { $what }

# Vlastní texty uživatele

own-text-language = { $given } nezačíná kódem žádného jazyka. Název souboru s vlastními texty začíná jedním z { $codes }, například nl_OurShop.ftl: přejmenujte soubor
own-text-too-large = velikost souboru v bajtech: { $bytes }, soubor s vlastními texty smí mít nejvýše { $most }: ponechte jen texty, které jsou jiné
own-text-not-utf8 = bajt { $byte } není UTF-8: uložte soubor jako UTF-8
own-text-syntax = { $given } nelze přečíst jako Fluent ({ $reason }). Napište název na začátek řádku, pak = a text, a další řádky odsaďte
own-text-not-a-text = { $given } je termín nebo má atributy, a nahradit lze jen texty: napište název = text
own-text-unknown = text { $name } neexistuje a žádný název se mu nepodobá. Názvy jsou ty, které mají vestavěné texty: opravte nebo smažte
own-text-misspelt = text { $name } neexistuje. Nejbližší název je { $nearest }: opravte nebo smažte
own-text-twice = { $name } je zadán dvakrát, poprvé na řádku { $first }, a neplatí ani jeden: jeden smažte
own-text-empty = { $given } má prázdný text nebo variantu, která nic neukazuje: napište text, nebo jej smažte a použije se vestavěný
own-text-control = { $given } má řídicí znak { $code }, dovoleny jsou jen viditelné znaky: smažte jej
own-text-too-much = { $given } má více znaků než { $longest }, více vnořených závorek než { $deepest } nebo příliš mnoho variant: napište jej jednodušeji
own-text-surplus = { $name } má { $given }, kam se nic nevkládá. Možné je jen { $allowed }: opravte nebo smažte
own-text-surplus-of-none = { $name } má { $given }, ale do tohoto textu se nic nevkládá: smažte to
own-text-lost = v { $name } chybí { $lost } z vestavěného textu, alespoň v jedné variantě, takže by něco nebylo řečeno: doplňte to
own-text-read-back = { $name } říká, odkud hodnota pochází, a čte se zpět ze souborů, proto jej nelze nahradit: smažte jej
own-text-property = { $name } patří k jazyku a není text, který lze nahradit: smažte jej
own-text-same-verdict = { $name } neplatí, protože { $clash } říká { $word }, a to říká i { $other }. Každý výrok potřebuje vlastní slovo, i vedle vestavěných a anglických: dejte každému jiné slovo
