page-settings = Instellingen

# The sections
settings-page-find = Instelling zoeken
settings-page-sections = Rubriek
settings-page-general = Algemeen
settings-page-appearance = Weergave
settings-page-rule = Regel en grensmaten
settings-page-own-files = Eigen bestanden
settings-page-records = Vastleggen
settings-page-shop-server = Werkplaatsserver
settings-page-folders = Mappen
settings-page-keys = Toetsen
settings-page-about = Over Fitcheck
settings-page-nothing = Geen instelling met deze woorden
settings-page-defaults = Terug naar standaard
settings-page-defaults-hint = Zet deze rubriek terug zoals bij de eerste start. Bestanden, namen en adressen blijven.

# General
settings-page-language-about = Alle teksten van het venster en het decimaalteken.
settings-page-own-texts = Eigen teksten
settings-page-own-texts-about = Woorden van uw werkplaats in plaats van de ingebouwde: een Fluent-bestand voor één taal, zoals nl_OurShop.ftl.
settings-page-own-texts-count = { $file }: { $count } van { $all } teksten zijn van u
settings-page-own-texts-reading = { $file } wordt gelezen
settings-page-own-texts-unread = { $file } kon niet worden gelezen en wordt niet gebruikt: { $why }
settings-page-own-texts-elsewhere = Het zijn teksten in { $language }; ze tellen alleen als het venster die taal spreekt.
settings-page-own-texts-refused = { $count ->
    [one] 1 tekst is geweigerd, en de ingebouwde wordt gebruikt:
   *[other] { $count } teksten zijn geweigerd, en de ingebouwde worden gebruikt:
}
settings-page-own-texts-more = … en nog { $count }
load-texts = Eigen teksten…
no-own-texts = Eigen teksten niet meer gebruiken
dialog-own-texts = Eigen teksten
file-kind-own-texts = Teksten
settings-page-keypad-about = Grote toetsen voor aanraakschermen en handschoenen.
sounds = Geluid
sounds-about = Elk oordeel klinkt: één lange toon betekent goed, twee tonen vragen om een blik op het onderdeel, drie betekenen afgekeurd. Gesimuleerde waarden klinken niet.
sounds-failed = Er klinkt geen geluid: { $reason }
sounds-no-player = Er klinkt geen geluid: geen van deze programma's staat op deze computer: { $players }
settings-page-shop = Instellingen voor de hele werkplaats
settings-page-shop-about = Eén bestand voor andere stations. Zonder naam, serveradres en passing.
settings-page-export = Instellingen exporteren…
settings-page-import = Instellingen importeren…
settings-page-dialog-export = Instellingen exporteren
settings-page-dialog-import = Instellingen importeren
settings-page-imported = { $count ->
    [0] { $name }: er verandert niets
    [one] { $name }: 1 instelling gewijzigd
   *[other] { $name }: { $count } instellingen gewijzigd
}
settings-page-unknown-key = { $key } is geen instelling van deze versie. Bij exporteren blijft de sleutel behouden.
settings-page-no-version = het bestand heeft geen versie: het is geen instellingenbestand
settings-page-edition = Uitgave van ISO 286
file-kind-settings = Instellingen

# Appearance
settings-page-colours = Kleuren
settings-page-colours-about = Het oordeel heeft altijd ook een woord en een vorm.
settings-page-zoom = Zoom
settings-page-zoom-about = Vergroot of verkleint alles. De toetsen zijn Ctrl met plus, min en 0.
settings-page-zoom-out = Uitzoomen
settings-page-zoom-in = Inzoomen
settings-page-zoom-normal = Zoomen naar 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automatisch: bij aanraken worden knoppen en velden groter, met de muis weer kleiner.
settings-page-decimal = Decimaalteken
settings-page-decimal-about = In het venster. Rapporten volgen hun taal, bestanden hun eigen instellingen.
settings-page-decimal-of-language = Volgens de taal
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Rijen van lijsten
settings-page-rows-about = Hoogte van de rijen in tabellen: gewoon is 32 px, compact is 26 px. Bij aanraking altijd 48 px.
settings-page-rows-usual = Gewoon
settings-page-rows-close = Compact

# Rule and limits
settings-page-limits-about = Waar de grensmaten van een klasse vandaan komen. Eigen tabellen gaan altijd voor.
settings-page-js-about = Voor tekeningen volgens de uitgave van 1988, graad 7 tot en met 11. Anders blijven halve micrometers staan.
settings-page-1988-about = Voor tekeningen volgens de uitgave van 1988. Anders gelden ze ook voor grotere maten.
settings-page-decision-rule = Beslisregel
settings-page-decision-rule-about = Welk deel van het tolerantieveld wordt aanvaard, gezien de onzekerheid van de waarde.
settings-page-prover = Bewijslast
settings-page-prover-about = Wie moet bewijzen dat een onderdeel voldoet, of juist niet.
settings-page-uncertainty-from = Onzekerheid opgeven als
settings-page-uncertainty-from-about = Een getypte waarde, of het budget, dat elke maat en de meetpunten kent.
settings-page-uncertainty-about = Van elke waarde op de controlepagina. Leeg: onbekend.
settings-page-coverage-about = Hoeveel standaardonzekerheden de uitgebreide onzekerheid vormen.
settings-page-budget = Onzekerheidsbudget
settings-page-budget-about = Open een budget op de pagina Onzekerheid en gebruik het voor controles.
settings-page-guard-factor-about = De breedte van de veiligheidsmarge, voor regels met een veelvoud.
settings-page-guard-width-about = Voor de regel met een vaste veiligheidsmarge.
settings-page-part-temperature = Temperatuur van het werkstuk
settings-page-part-temperature-about = Waarden worden naar 20 °C gecorrigeerd. Leeg: niet gecorrigeerd.
settings-page-part-expansion-about = Hoeveel het materiaal van het werkstuk uitzet.
settings-page-scale-temperature = Temperatuur van de meetlinialen
settings-page-scale-temperature-about = Alleen als de machine die niet compenseert.
settings-page-scale-expansion-about = Hoeveel de meetlinialen van de machine uitzetten.
settings-page-clearance-about = Hoe ver van het oppervlak het tastsysteem begint te zoeken.
settings-page-height = Meethoogte Z
settings-page-height-about = Op welke hoogte het tastsysteem het werkstuk raakt.
settings-page-first-contact-about = De hoek van het eerste meetpunt.
settings-page-centre-tolerance-about = Hoeveel het midden in X en Y mag afwijken. 0: niet bewaakt.

# Own files
settings-page-own-tables = Eigen tabellen
settings-page-own-tables-about = Een map met tabellen zoals op de besturing. Ze gaan voor ISO 286.
settings-page-mask = Masker van het statusvenster
settings-page-mask-about = Wat de besturing afdrukt, en in welke taal.
settings-page-own-mask = Eigen masker
settings-page-own-mask-about = Een maskerbestand van de besturing in plaats van het ingebouwde.
settings-page-columns = Kolommen van bestanden
settings-page-columns-about = Toont vóór het importeren welke kolom wat is, en onthoudt dat.

# Records
settings-page-journal = Logboek
settings-page-journal-about = Elke controle komt hierin. In het statusbestand kan een ander bestand staan.
settings-page-who-about = Elke controle wordt met deze naam vastgelegd.
settings-page-station = Station
settings-page-station-about = De naam van deze computer in de vastgelegde controles.

# Shop server
settings-page-server = Adres van de server
settings-page-server-about = Stuurt elke vermelding op de achtergrond naar PostgreSQL, bijvoorbeeld postgres://frees3@werkplaats.example/checks. Een wachtwoord gaat naar de sleutelbos.
settings-page-sent = Verzonden
settings-page-sent-about = Vermeldingen wachten op deze computer tot de server ze heeft.

# Folders
settings-page-watched = Bewaakte map
settings-page-watched-about = Bestanden in deze map worden volgens het geopende plan beoordeeld en vastgelegd.
settings-page-recent-about = Het menu toont de bestanden die het laatst zijn gelezen.
settings-page-recent-count = { $count ->
    [0] geen bestanden
    [one] 1 bestand
   *[other] { $count } bestanden
}

# Keys
settings-page-everywhere = Overal
settings-page-on-workpiece = Cycli en programma's
settings-page-in-dialog = In het bestandsvenster

# About
settings-page-version = Versie
settings-page-version-about = Fitcheck zegt in één oogopslag of een gemeten boring of as goed is.
settings-page-version-is = { $version }, commit { $commit }
settings-page-unknown = onbekend
settings-page-licences = Licenties van wat is ingebouwd
settings-page-licence = Licentie
settings-page-licence-about = Vrije software. De ingebouwde lettertypen hebben eigen licenties.
settings-page-state-file = Statusbestand
settings-page-state-file-about = Bewaart instellingen, velden en recente bestanden, een seconde na elke wijziging.
settings-page-journal-file = Logboekbestand
settings-page-journal-file-about = Bewaart elke controle van dit station.
settings-page-not-used = niet in gebruik
settings-page-own-tables-unread = { $folder } kon niet worden gelezen en wordt niet gebruikt
settings-page-nowhere = wordt niet bewaard
settings-page-changed = { $name } is gewijzigd
settings-page-several-changed = { $count } instellingen zijn gewijzigd
settings-page-take-back = Laatste wijziging van een instelling ongedaan maken
settings-page-preview = Voorbeeld met deze instellingen

## The size of the screen
ruler = Grootte van het scherm
ruler-about = Houd een bankpas tegen het plaatje en maak het even breed: de knoppen van een operator zijn dan 20 mm groot
ruler-card = Een bankpas: nog niet vergeleken
ruler-known = Een bankpas, 85,6 mm
ruler-much-shorter = Veel korter
ruler-shorter = Iets korter
ruler-longer = Iets langer
ruler-much-longer = Veel langer
ruler-forget = Vergeten
settings-page-company = Bedrijf op rapporten
settings-page-company-about = Staat boven aan PDF en HTML, als het sjabloon geen bedrijf noemt.
settings-page-company-address = Adres op rapporten
settings-page-company-address-about = Een puntkomma begint een nieuwe regel.
settings-page-company-logo = Logo op rapporten
settings-page-company-logo-about = Het hele pad van een PNG-, JPEG- of SVG-bestand.
settings-page-company-logo-place = { $given } is geen heel pad: begin met het station of de hoofdmap
