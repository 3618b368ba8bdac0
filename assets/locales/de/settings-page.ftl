page-settings = Einstellungen

# Die Abschnitte
settings-page-find = Einstellung suchen
settings-page-sections = Abschnitt
settings-page-general = Allgemein
settings-page-appearance = Darstellung
settings-page-rule = Regel und Grenzmaße
settings-page-own-files = Eigene Dateien
settings-page-records = Aufzeichnen
settings-page-shop-server = Werkstattserver
settings-page-folders = Ordner
settings-page-keys = Tasten
settings-page-about = Über Fitcheck
settings-page-nothing = Keine Einstellung mit diesen Wörtern
settings-page-defaults = Auf Standard zurück
settings-page-defaults-hint = Setzt diesen Abschnitt wie beim ersten Start. Dateien, Namen und Adressen bleiben.

# Allgemein
settings-page-language-about = Alle Texte des Fensters und sein Dezimalzeichen.
settings-page-own-texts = Eigene Texte
settings-page-own-texts-about = Wörter Ihrer Werkstatt statt der eingebauten: eine Fluent-Datei für eine Sprache, etwa nl_OurShop.ftl.
settings-page-own-texts-count = { $file }: { $count } von { $all } Texten sind eigene
settings-page-own-texts-reading = { $file } wird gelesen
settings-page-own-texts-unread = { $file } konnte nicht gelesen werden und wird nicht verwendet: { $why }
settings-page-own-texts-elsewhere = Es sind Texte in { $language }; sie zählen nur, wenn das Fenster diese Sprache spricht.
settings-page-own-texts-refused = { $count ->
    [one] 1 Text ist abgelehnt, und der eingebaute wird verwendet:
   *[other] { $count } Texte sind abgelehnt, und die eingebauten werden verwendet:
}
settings-page-own-texts-more = … und { $count } weitere
load-texts = Eigene Texte…
no-own-texts = Eigene Texte nicht mehr verwenden
dialog-own-texts = Eigene Texte
file-kind-own-texts = Texte
settings-page-keypad-about = Große Tasten für Touchscreens und Handschuhe.
sounds = Töne
sounds-about = Jedes Urteil ist zu hören: ein langer Ton heißt gut, zwei Töne bitten um einen Blick auf das Teil, drei heißen Ausschuss. Simulierte Werte sind nicht zu hören.
sounds-failed = Es ist kein Ton zu hören: { $reason }
sounds-no-player = Es ist kein Ton zu hören: keines dieser Programme ist auf diesem Computer: { $players }
settings-page-shop = Einstellungen für die ganze Werkstatt
settings-page-shop-about = Eine Datei für andere Stationen. Ohne Namen, Serveradresse und Toleranzangabe.
settings-page-export = Einstellungen exportieren…
settings-page-import = Einstellungen importieren…
settings-page-dialog-export = Einstellungen exportieren
settings-page-dialog-import = Einstellungen importieren
settings-page-imported = { $count ->
    [0] { $name }: nichts ist anders
    [one] { $name }: 1 Einstellung geändert
   *[other] { $name }: { $count } Einstellungen geändert
}
settings-page-unknown-key = { $key } ist keine Einstellung dieser Version. Ein Export behält den Schlüssel.
settings-page-no-version = die Datei hat keine Version: sie ist keine Datei mit Einstellungen
settings-page-edition = Ausgabe von ISO 286
file-kind-settings = Einstellungen

# Darstellung
settings-page-colours = Farben
settings-page-colours-about = Das Urteil hat außer der Farbe immer auch ein Wort und eine Form.
settings-page-zoom = Zoom
settings-page-zoom-about = Skaliert alles. Die Tasten sind Ctrl mit Plus, Minus und 0.
settings-page-zoom-out = Verkleinern
settings-page-zoom-in = Vergrößern
settings-page-zoom-normal = Zoom auf 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automatisch: bei Touch werden Schaltflächen und Felder größer, mit der Maus kleiner.
settings-page-decimal = Dezimalzeichen
settings-page-decimal-about = Im Fenster. Berichte folgen ihrer Sprache, Dateien ihren eigenen Einstellungen.
settings-page-decimal-of-language = Wie die Sprache
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Zeilen von Listen
settings-page-rows-about = Höhe der Zeilen in Tabellen: normal sind 32 px, eng sind 26 px. Bei Touch immer 48 px.
settings-page-rows-usual = Normal
settings-page-rows-close = Eng

# Regel und Grenzmaße
settings-page-limits-about = Woher die Grenzmaße einer Klasse kommen. Eigene Tabellen gehen immer vor.
settings-page-js-about = Für Zeichnungen nach der Ausgabe von 1988, Toleranzgrade 7 bis 11. Sonst bleiben halbe Mikrometer stehen.
settings-page-1988-about = Für Zeichnungen nach der Ausgabe von 1988. Sonst sind sie auch für größere Maße definiert.
settings-page-decision-rule = Entscheidungsregel
settings-page-decision-rule-about = Welcher Teil des Toleranzfelds angenommen wird, bei gegebener Unsicherheit des Werts.
settings-page-prover = Nachweispflicht
settings-page-prover-about = Wer nachweisen muss, dass ein Teil konform ist oder nicht.
settings-page-uncertainty-from = Unsicherheit angeben als
settings-page-uncertainty-from-about = Ein eingegebener Wert oder das Budget, das jedes Maß und seine Antastpunkte kennt.
settings-page-uncertainty-about = Für jeden Wert auf der Seite Prüfung. Leer: nicht bekannt.
settings-page-coverage-about = Wie viele Standardunsicherheiten die erweiterte ergeben.
settings-page-budget = Unsicherheitsbudget
settings-page-budget-about = Ein Budget auf seiner Seite öffnen und für Prüfungen verwenden.
settings-page-guard-factor-about = Die Breite des Sicherheitsbands, für Regeln mit einem Vielfachen.
settings-page-guard-width-about = Für die Regel mit festem Sicherheitsband.
settings-page-part-temperature = Temperatur des Teils
settings-page-part-temperature-about = Werte werden auf 20 °C korrigiert. Leer: nicht korrigiert.
settings-page-part-expansion-about = Wie stark sich der Werkstoff des Teils ausdehnt.
settings-page-scale-temperature = Temperatur der Maßstäbe
settings-page-scale-temperature-about = Nur wenn die Maschine sie nicht kompensiert.
settings-page-scale-expansion-about = Wie stark sich die Maßstäbe der Maschine ausdehnen.
settings-page-clearance-about = Wie weit vor der Oberfläche das Tastsystem mit dem Suchen beginnt.
settings-page-height = Messhöhe Z
settings-page-height-about = Auf welcher Höhe das Tastsystem das Werkstück berührt.
settings-page-first-contact-about = Der Winkel des ersten Antastpunkts.
settings-page-centre-tolerance-about = Wie weit die Mitte in X und Y abweichen darf. 0: nicht überwacht.

# Eigene Dateien
settings-page-own-tables = Eigene Tabellen
settings-page-own-tables-about = Ein Ordner mit Tabellen wie auf der Steuerung. Sie gehen vor ISO 286.
settings-page-mask = Maske des Statusfensters
settings-page-mask-about = Was die Steuerung ausgibt, und in welcher Sprache.
settings-page-own-mask = Eigene Maske
settings-page-own-mask-about = Eine Maskendatei der Steuerung anstelle der mitgelieferten.
settings-page-columns = Spalten von Dateien
settings-page-columns-about = Zeigt vor dem Importieren, welche Spalte was ist, und merkt es sich.

# Aufzeichnen
settings-page-journal = Journal
settings-page-journal-about = Jede Prüfung wird hier eingetragen. Die Zustandsdatei kann eine andere Datei nennen.
settings-page-who-about = Jede Prüfung wird mit diesem Namen aufgezeichnet.
settings-page-station = Station
settings-page-station-about = Der Name dieses Computers in den Aufzeichnungen.

# Werkstattserver
settings-page-server = Adresse des Servers
settings-page-server-about = Sendet jeden Eintrag im Hintergrund an PostgreSQL, wie postgres://fraese3@werkstatt.example/checks. Ein Kennwort kommt in den Schlüsselbund.
settings-page-sent = Gesendet
settings-page-sent-about = Einträge warten auf diesem Computer, bis der Server sie hat.

# Ordner
settings-page-watched = Überwachter Ordner
settings-page-watched-about = Dateien darin werden nach dem geöffneten Plan beurteilt und aufgezeichnet.
settings-page-recent-about = Das Menü zeigt die zuletzt gelesenen Dateien.
settings-page-recent-count = { $count ->
    [0] keine Dateien
    [one] 1 Datei
   *[other] { $count } Dateien
}

# Tasten
settings-page-everywhere = Überall
settings-page-on-workpiece = Zyklen und Programme
settings-page-in-dialog = Im Dateidialog

# Über Fitcheck
settings-page-version = Version
settings-page-version-about = Fitcheck zeigt auf einen Blick, ob eine gemessene Bohrung oder Welle gut ist.
settings-page-version-is = { $version }, Commit { $commit }
settings-page-unknown = unbekannt
settings-page-licences = Lizenzen der mitgelieferten Bestandteile
settings-page-licence = Lizenz
settings-page-licence-about = Freie Software. Die eingebetteten Schriften haben eigene Lizenzen.
settings-page-state-file = Zustandsdatei
settings-page-state-file-about = Bewahrt Einstellungen, Felder und letzte Dateien auf, eine Sekunde nach jeder Änderung.
settings-page-journal-file = Journaldatei
settings-page-journal-file-about = Bewahrt jede Prüfung dieser Station auf.
settings-page-not-used = nicht in Verwendung
settings-page-own-tables-unread = { $folder } konnte nicht gelesen werden und wird nicht verwendet
settings-page-nowhere = nicht aufbewahrt
settings-page-changed = { $name } wurde geändert
settings-page-several-changed = { $count } Einstellungen wurden geändert
settings-page-take-back = Letzte Änderung einer Einstellung rückgängig machen
settings-page-preview = Beispiel mit diesen Einstellungen

## The size of the screen
ruler = Größe des Bildschirms
ruler-about = Eine Bankkarte an das Bild halten und es gleich breit machen: die Tasten eines Bedieners sind dann 20 mm groß
ruler-card = Eine Bankkarte: noch nicht verglichen
ruler-known = Eine Bankkarte, 85,6 mm
ruler-much-shorter = Viel kürzer
ruler-shorter = Etwas kürzer
ruler-longer = Etwas länger
ruler-much-longer = Viel länger
ruler-forget = Vergessen
settings-page-company = Firma auf Berichten
settings-page-company-about = Steht oben auf PDF und HTML, wenn die Vorlage keine Firma nennt.
settings-page-company-address = Adresse auf Berichten
settings-page-company-address-about = Ein Semikolon beginnt eine neue Zeile.
settings-page-company-logo = Logo auf Berichten
settings-page-company-logo-about = Der ganze Pfad einer PNG-, JPEG- oder SVG-Datei.
settings-page-company-logo-place = { $given } ist kein ganzer Pfad: beginnen Sie mit dem Laufwerk oder dem Wurzelordner
