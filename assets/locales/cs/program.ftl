# NC programs

## Reading
program-empty = program je prázdný
program-too-large = program je větší než { $most } MiB
program-too-many-lines = program má více než { $most } řádků
program-binary = soubor není text: { $controls } z jeho { $bytes } bajtů nejsou znaky
program-no-begin = program nezačíná BEGIN PGM
program-second-begin = druhé BEGIN PGM
program-no-end = chybí END PGM
program-units = END PGM udává { $end }, BEGIN PGM udává { $begin }
program-after-end = text za END PGM k programu nepatří
program-no-section = chybí { $section }
program-no-unit = hlavička neudává jednotku (#EINHEIT METRISCH / INCH): program se čte jako v mm
program-after-last-section = za ENDE / END smějí následovat jen podprogramy
program-unclosed-comment = u komentáře chybí koncová závorka ]
program-numbers = číslo bloku { $number } následuje po { $previous }; čísla bloků mimo pořadí: { $count }
program-label-again = LBL { $label } je definováno už na řádku { $first }
program-unclosed-quote = uvozovky nejsou uzavřeny
program-open-end = řádek končí ~, ale nic nenásleduje
program-cycle-cut = cyklus { $cycle } skončil na řádku { $line }, který nemá na konci ~: { $parameter } k němu nepatří a místo toho by byl přiřazen
program-no-star = blok nekončí *
program-iso-no-end = chybí poslední blok: % s názvem programu
program-iso-units = poslední blok udává { $end }, první { $begin }
program-iso-after-end = text za posledním blokem k programu nepatří
program-iso-cycle-cut = cyklus { $cycle } skončil na řádku { $line }: { $parameter } k němu nepatří a místo toho by byl přiřazen
program-comment-holds = { $found } je součástí komentáře, který končí na konci svého řádku
program-cycle-without-tilde = cyklus { $cycle } skončil na řádku { $line }, který nemá na konci ~: řádky pod ním se čtou jako jeho součást
program-block-goes-on = předchozí blok končí ~, tento blok by tedy byl jeho součástí
program-comment-goes-on = komentář končí ~, tento blok by tedy byl jeho součástí
program-not-understood = nesrozumitelné: { $reason }
program-more = dalších nevypsaných poznámek: { $count }

## Labels
program-label-missing = LBL { $label } se v programu nevyskytuje
program-label-twice = LBL { $label } je definováno dvakrát, na řádku { $first } a na řádku { $second }
program-label-zero = LBL 0 ukončuje podprogram: nelze na něj skočit
program-label-parameter = které návěští je v { $label }, je známo až za běhu programu

## Why a block is not understood
program-missing = chybí { $wanted }
program-unexpected = očekává se { $wanted }, nalezeno { $found }
program-left-over = neočekávaný text { $found }
program-unknown-function = { $found } není funkce
program-number-size = { $found } je příliš velké
program-parameter-range = { $found } není parametr: { $family } jde od { $least } do { $most }
program-range = { $found } je příliš velké: nejvýše { $most }
program-label-of-parameter = { $parameter } nemůže být názvem návěští, které zde začíná
program-relation = FN { $number } porovnává pomocí { $allowed }: nalezeno { $found }
program-not-together = { $one } a { $other } nemohou být v jednom bloku
program-unknown-word = { $found } není známo
program-no-form = ISO tvar { $found } není znám
program-measure-unknown = není známo, zda zde platí G90, nebo G91
program-and-with-or = AND a OR v jedné podmínce potřebují závorky, které určí pořadí
program-letter-twice = { $letters } je uvedeno dvakrát
program-second-unit = předtím byla uvedena jiná jednotka
program-acts-in-unit = unity nemají vliv, tento blok však měří, volá nebo nastavuje proměnnou
program-shifts-in-unit = unity nemají vliv, tento blok však může posunout nulový bod
program-alone = { $found } bez { $missing }
program-axis-twice = osa je uvedena dvakrát
program-too-deep = závorky a funkce jsou vnořeny hlouběji než { $most }
program-too-many-operands = vzorec má více než { $most } operandů
program-too-long = blok má více než { $most } znaků
program-too-much = vzorce a dlouhé bloky zabírají celkem více než { $most } MiB
program-wanted-word = { $word }
program-wanted-number = číslo
program-wanted-value = číslo nebo Q parametr
program-wanted-value-or-variable = číslo nebo proměnná
program-wanted-variable = proměnná (#l, #c, #g, #x, #i)
program-wanted-parameter = parametr
program-wanted-number-parameter = parametr Q, QL nebo QR
program-wanted-text-parameter = parametr QS
program-wanted-text = text v uvozovkách nebo parametr QS
program-wanted-label = návěští
program-wanted-path = cesta
program-wanted-relation = EQU, NE, GT, LT nebo IS
program-wanted-unit = MM nebo INCH
program-wanted-cycle-value = hodnota
