page-settings = Nastavení

# The sections
settings-page-find = Hledat nastavení
settings-page-sections = Oddíl
settings-page-general = Obecné
settings-page-appearance = Vzhled
settings-page-rule = Pravidlo a meze
settings-page-own-files = Vlastní soubory
settings-page-records = Záznamy
settings-page-shop-server = Server dílny
settings-page-folders = Složky
settings-page-keys = Klávesy
settings-page-about = O programu
settings-page-nothing = Tato slova nemá žádné nastavení
settings-page-defaults = Obnovit výchozí
settings-page-defaults-hint = Nastaví tento oddíl jako při prvním spuštění. Soubory, jména a adresy zůstanou.

# General
settings-page-language-about = Všechny texty okna a jeho desetinný oddělovač.
settings-page-own-texts = Vlastní texty
settings-page-own-texts-about = Slova vaší dílny místo vestavěných: soubor Fluent pro jeden jazyk, například nl_OurShop.ftl.
settings-page-own-texts-count = { $file }: vlastní texty { $count } z { $all }
settings-page-own-texts-reading = { $file } se čte
settings-page-own-texts-unread = { $file } nelze přečíst a nepoužívá se: { $why }
settings-page-own-texts-elsewhere = Jazyk těchto textů je { $language }; platí jen tehdy, když je okno v tomto jazyce.
settings-page-own-texts-refused = { $count ->
    [one] 1 text je odmítnut a použije se vestavěný:
    [few] { $count } texty jsou odmítnuty a použijí se vestavěné:
    [many] { $count } textu je odmítnuto a použijí se vestavěné:
   *[other] { $count } textů je odmítnuto a použijí se vestavěné:
}
settings-page-own-texts-more = … a ještě { $count }
load-texts = Vlastní texty…
no-own-texts = Nepoužívat vlastní texty
dialog-own-texts = Vlastní texty
file-kind-own-texts = Texty
settings-page-keypad-about = Velké klávesy pro dotykové obrazovky a rukavice.
sounds = Zvuky
sounds-about = Každý výrok je slyšet: jeden dlouhý tón znamená dobrý, dva tóny žádají pohled na díl, tři znamenají zmetek. Simulované hodnoty slyšet není.
sounds-failed = Není slyšet žádný zvuk: { $reason }
sounds-no-player = Není slyšet žádný zvuk: v tomto počítači není žádný z těchto programů: { $players }
settings-page-shop = Nastavení pro celou dílnu
settings-page-shop-about = Jeden soubor pro ostatní stanice. Neobsahuje jméno, adresu serveru ani předpis.
settings-page-export = Exportovat nastavení…
settings-page-import = Importovat nastavení…
settings-page-dialog-export = Export nastavení
settings-page-dialog-import = Import nastavení
settings-page-imported = { $count ->
    [0] { $name }: nic není jinak
    [one] { $name }: změněno 1 nastavení
   *[other] { $name }: změněno { $count } nastavení
}
settings-page-unknown-key = { $key } není nastavení této verze. Export je zachová.
settings-page-no-version = soubor nemá verzi: není to soubor nastavení
settings-page-edition = Vydání ISO 286
file-kind-settings = Nastavení

# Appearance
settings-page-colours = Barvy
settings-page-colours-about = Výrok má vždy také slovo a tvar, bez ohledu na barvu.
settings-page-zoom = Měřítko
settings-page-zoom-about = Zvětší nebo zmenší vše. Klávesy jsou Ctrl s plus, minus a 0.
settings-page-zoom-out = Zmenšit
settings-page-zoom-in = Zvětšit
settings-page-zoom-normal = Měřítko 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automaticky: dotykem se tlačítka a pole zvětší, myší zmenší.
settings-page-decimal = Desetinný oddělovač
settings-page-decimal-about = V okně. Zprávy se řídí svým jazykem, soubory vlastním nastavením.
settings-page-decimal-of-language = Podle jazyka
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Řádky seznamů
settings-page-rows-about = Výška řádků tabulek: běžně 32 px, hustě 26 px. Při dotyku vždy 48 px.
settings-page-rows-usual = Běžně
settings-page-rows-close = Hustě

# Rule and limits
settings-page-limits-about = Kde se hledají meze třídy. Vlastní tabulky mají vždy přednost.
settings-page-js-about = Pro výkresy podle vydání 1988, stupně 7 až 11. Jinak poloviny mikrometru zůstávají.
settings-page-1988-about = Pro výkresy podle vydání 1988. Jinak jsou stanoveny i pro větší rozměry.
settings-page-decision-rule = Rozhodovací pravidlo
settings-page-decision-rule-about = Která část tolerančního pole se při dané nejistotě hodnoty přijímá.
settings-page-prover = Důkazní břemeno
settings-page-prover-about = Kdo musí prokázat, že díl vyhovuje, nebo nevyhovuje.
settings-page-uncertainty-from = Nejistota je zadána jako
settings-page-uncertainty-from-about = Zadaná hodnota, nebo bilance, která zná každý rozměr a jeho body dotyku.
settings-page-uncertainty-about = Pro každou hodnotu na stránce Kontrola. Prázdné: neznámá.
settings-page-coverage-about = Kolik standardních nejistot tvoří rozšířenou.
settings-page-budget = Bilance nejistot
settings-page-budget-about = Otevřete bilanci na její stránce a použijte ji pro kontroly.
settings-page-guard-factor-about = Šířka ochranného pásma pro pravidla s násobkem.
settings-page-guard-width-about = Pro pravidlo s pevným ochranným pásmem.
settings-page-part-temperature = Teplota dílu
settings-page-part-temperature-about = Hodnoty se přepočtou na 20 °C. Prázdné: nepřepočítává se.
settings-page-part-expansion-about = Jak se roztahuje materiál dílu.
settings-page-scale-temperature = Teplota odměřování
settings-page-scale-temperature-about = Jen když ji stroj nekompenzuje.
settings-page-scale-expansion-about = Jak se roztahuje odměřování stroje.
settings-page-clearance-about = Jak daleko od povrchu jej sonda začne hledat.
settings-page-height = Výška měření Z
settings-page-height-about = V jaké výšce se sonda dotkne obrobku.
settings-page-first-contact-about = Úhel prvního bodu dotyku.
settings-page-centre-tolerance-about = O kolik smí být střed posunut v X a Y. 0: nehlídá se.

# Own files
settings-page-own-tables = Vlastní tabulky
settings-page-own-tables-about = Složka s tabulkami jako na vašem řídicím systému. Mají přednost před ISO 286.
settings-page-mask = Maska stavového okna
settings-page-mask-about = Co řídicí systém vypíše a v jakém jazyce.
settings-page-own-mask = Vlastní maska
settings-page-own-mask-about = Soubor masky vašeho řídicího systému místo vestavěné.
settings-page-columns = Sloupce souborů
settings-page-columns-about = Před importem souboru ukáže, co který sloupec znamená, a zapamatuje si to.

# Records
settings-page-journal = Deník
settings-page-journal-about = Sem se zapisuje každá kontrola. Stavový soubor může určit jiný soubor.
settings-page-who-about = Každá kontrola se zaznamená s tímto jménem.
settings-page-station = Stanice
settings-page-station-about = Název tohoto počítače v záznamech.

# Shop server
settings-page-server = Adresa serveru
settings-page-server-about = Odesílá každý záznam na pozadí do PostgreSQL, například postgres://mill3@shop.example/checks. Heslo se uloží do klíčenky.
settings-page-sent = Dosud odesláno
settings-page-sent-about = Záznamy čekají v tomto počítači, dokud je server nemá.

# Folders
settings-page-watched = Sledovaná složka
settings-page-watched-about = Soubory do ní vložené se posoudí podle otevřeného plánu a zaznamenají.
settings-page-recent-about = Nabídka obsahuje naposledy načtené soubory.
settings-page-recent-count = { $count ->
    [0] žádné soubory
    [one] 1 soubor
    [few] { $count } soubory
   *[other] { $count } souborů
}

# Keys
settings-page-everywhere = Všude
settings-page-on-workpiece = Cykly a programy
settings-page-in-dialog = V dialogu souborů

# About
settings-page-version = Verze
settings-page-version-about = Fitcheck na první pohled ukáže, zda je změřená díra nebo hřídel v pořádku.
settings-page-version-is = { $version }, commit { $commit }
settings-page-unknown = neznámý
settings-page-licences = Licence vestavěných částí
settings-page-licence = Licence
settings-page-licence-about = Svobodný software. Vložená písma mají vlastní licence.
settings-page-state-file = Stavový soubor
settings-page-state-file-about = Uchovává nastavení, pole a nedávné soubory, sekundu po každé změně.
settings-page-journal-file = Soubor deníku
settings-page-journal-file-about = Uchovává každou kontrolu této stanice.
settings-page-not-used = nepoužívá se
settings-page-own-tables-unread = { $folder } nelze přečíst a nepoužívá se
settings-page-nowhere = neuchovává se
settings-page-changed = Změněno: { $name }
settings-page-several-changed = Změněno nastavení: { $count }
settings-page-take-back = Vrátit poslední změnu nastavení
settings-page-preview = Příklad s tímto nastavením

## The size of the screen
ruler = Velikost obrazovky
ruler-about = Přiložte k obrázku platební kartu a vyrovnejte šířku: tlačítka obsluhy pak mají 20 mm
ruler-card = Platební karta: zatím neporovnána
ruler-known = Platební karta, 85,6 mm
ruler-much-shorter = Mnohem kratší
ruler-shorter = O něco kratší
ruler-longer = O něco delší
ruler-much-longer = Mnohem delší
ruler-forget = Zapomenout
settings-page-company = Firma ve zprávách
settings-page-company-about = Stojí nahoře v PDF a HTML, pokud šablona neuvádí firmu.
settings-page-company-address = Adresa ve zprávách
settings-page-company-address-about = Středník začíná nový řádek.
settings-page-company-logo = Logo ve zprávách
settings-page-company-logo-about = Úplná cesta k souboru PNG, JPEG nebo SVG.
settings-page-company-logo-place = { $given } není úplná cesta: začněte diskem nebo kořenovou složkou
