page-settings = Impostazioni

# Le sezioni
settings-page-find = Cercare un'impostazione
settings-page-sections = Sezione
settings-page-general = Generale
settings-page-appearance = Aspetto
settings-page-rule = Regola e limiti
settings-page-own-files = File propri
settings-page-records = Registro
settings-page-shop-server = Server
settings-page-folders = Cartelle
settings-page-keys = Tasti
settings-page-about = Informazioni
settings-page-nothing = Nessuna impostazione con queste parole
settings-page-defaults = Valori predefiniti
settings-page-defaults-hint = Riporta questa sezione come al primo avvio. File, nomi e indirizzi restano.

# Generale
settings-page-language-about = Tutti i testi della finestra, e il suo segno decimale.
settings-page-own-texts = Testi propri
settings-page-own-texts-about = Parole della propria officina al posto di quelle integrate: un file Fluent per una lingua, come nl_OurShop.ftl.
settings-page-own-texts-count = { $file }: testi propri { $count } di { $all }
settings-page-own-texts-reading = { $file } è in lettura
settings-page-own-texts-unread = non è stato possibile leggere { $file }, e non è in uso: { $why }
settings-page-own-texts-elsewhere = Sono testi in { $language } e valgono solo quando la finestra è in quella lingua.
settings-page-own-texts-refused = { $count ->
    [one] 1 testo è rifiutato, e vale quello integrato:
    [many] { $count } testi sono rifiutati, e valgono quelli integrati:
   *[other] { $count } testi sono rifiutati, e valgono quelli integrati:
}
settings-page-own-texts-more = … e altri { $count }
load-texts = Testi propri…
no-own-texts = Non usare più i testi propri
dialog-own-texts = Testi propri
file-kind-own-texts = Testi
settings-page-keypad-about = Tasti grandi per schermi tattili e guanti.
sounds = Suoni
sounds-about = Ogni esito si sente. Un suono lungo: buono; due suoni: guardare il pezzo; tre: scarto. I valori simulati non si sentono.
sounds-failed = Non si sente alcun suono: { $reason }
sounds-no-player = Non si sente alcun suono: nessuno di questi programmi è su questo computer: { $players }
settings-page-shop = Impostazioni per tutta l'officina
settings-page-shop-about = Un solo file per altre stazioni. Senza nome, indirizzo di server e indicazione.
settings-page-export = Esportare impostazioni…
settings-page-import = Importare impostazioni…
settings-page-dialog-export = Esportare le impostazioni
settings-page-dialog-import = Importare le impostazioni
settings-page-imported = { $count ->
    [0] { $name }: nulla è diverso
    [one] { $name }: 1 impostazione modificata
   *[other] { $name }: { $count } impostazioni modificate
}
settings-page-unknown-key = { $key } non è un'impostazione di questa versione. Un'esportazione la conserva.
settings-page-no-version = il file non ha una versione: non è un file di impostazioni
settings-page-edition = Edizione di ISO 286
file-kind-settings = Impostazioni

# Aspetto
settings-page-colours = Colori
settings-page-colours-about = L'esito ha sempre anche una parola e una forma, oltre al colore.
settings-page-zoom = Zoom
settings-page-zoom-about = Ingrandisce o riduce tutto. I tasti sono Ctrl con più, meno e 0.
settings-page-zoom-out = Ridurre
settings-page-zoom-in = Ingrandire
settings-page-zoom-normal = Zoom al 100 %
settings-page-percent = { $percent } %
settings-page-density-about = Automatica: un tocco ingrandisce pulsanti e campi, il mouse li rimpicciolisce.
settings-page-decimal = Segno decimale
settings-page-decimal-about = Nella finestra. I rapporti seguono la loro lingua, i file le loro impostazioni.
settings-page-decimal-of-language = Secondo la lingua
settings-page-decimal-point = 25.012
settings-page-decimal-comma = 25,012
settings-page-rows = Righe degli elenchi
settings-page-rows-about = Altezza delle righe delle tabelle: normale 32 px, fitta 26 px. Al tocco sempre 48 px.
settings-page-rows-usual = Normale
settings-page-rows-close = Fitta

# Regola e limiti
settings-page-limits-about = Dove si cercano i limiti di una classe. Le tabelle proprie hanno sempre la precedenza.
settings-page-js-about = Per disegni secondo l'edizione 1988, gradi da 7 a 11. Altrimenti i mezzi micrometri restano.
settings-page-1988-about = Per disegni secondo l'edizione 1988. Altrimenti sono definiti anche per dimensioni maggiori.
settings-page-decision-rule = Regola di decisione
settings-page-decision-rule-about = Quale parte della zona di tolleranza viene accettata, data l'incertezza del valore.
settings-page-prover = Onere della prova
settings-page-prover-about = Chi deve provare che un pezzo è conforme, o che non lo è.
settings-page-uncertainty-from = Incertezza indicata come
settings-page-uncertainty-from-about = Un valore digitato, o il bilancio, che conosce ogni dimensione e i suoi punti di contatto.
settings-page-uncertainty-about = Di ogni valore della pagina Controllo. Vuoto: non nota.
settings-page-coverage-about = Quante incertezze tipo formano quella estesa.
settings-page-budget = Bilancio dell'incertezza
settings-page-budget-about = Aprire un bilancio nella sua pagina e usarlo per i controlli.
settings-page-guard-factor-about = L'ampiezza della banda di guardia, per le regole con un multiplo.
settings-page-guard-width-about = Per la regola con banda di guardia fissa.
settings-page-part-temperature = Temperatura del pezzo
settings-page-part-temperature-about = I valori vengono corretti a 20 °C. Vuoto: non corretti.
settings-page-part-expansion-about = Quanto si dilata il materiale del pezzo.
settings-page-scale-temperature = Temperatura delle righe ottiche
settings-page-scale-temperature-about = Solo se la macchina non la compensa.
settings-page-scale-expansion-about = Quanto si dilatano le righe ottiche della macchina.
settings-page-clearance-about = A quale distanza dalla superficie il sistema di tastatura comincia a cercarla.
settings-page-height = Altezza di misura Z
settings-page-height-about = A quale altezza il sistema di tastatura tocca il pezzo in lavorazione.
settings-page-first-contact-about = L'angolo del primo contatto.
settings-page-centre-tolerance-about = Quanto può scostarsi il centro in X e Y. 0: non sorvegliato.

# File propri
settings-page-own-tables = Tabelle proprie
settings-page-own-tables-about = Una cartella con tabelle come sul controllo numerico. Vengono prima di ISO 286.
settings-page-mask = Maschera della finestra di stato
settings-page-mask-about = Ciò che il controllo numerico stampa, e in quale lingua.
settings-page-own-mask = Maschera propria
settings-page-own-mask-about = Un file maschera del controllo numerico al posto di quella integrata.
settings-page-columns = Colonne dei file
settings-page-columns-about = Mostra prima dell'importazione il significato di ogni colonna, e lo ricorda.

# Registro
settings-page-journal = Registro
settings-page-journal-about = Qui viene scritto ogni controllo. Il file di stato può indicare un altro file.
settings-page-who-about = Ogni controllo viene registrato con questo nome.
settings-page-station = Stazione
settings-page-station-about = Il nome di questo computer nelle registrazioni.

# Server officina
settings-page-server = Indirizzo del server
settings-page-server-about = Invia ogni registrazione a PostgreSQL in background, ad esempio postgres://mill3@shop.example/checks. Una password va nel portachiavi.
settings-page-sent = Inviate finora
settings-page-sent-about = Le registrazioni attendono su questo computer finché il server le ha ricevute.

# Cartelle
settings-page-watched = Cartella sorvegliata
settings-page-watched-about = I file messi nella cartella vengono valutati secondo il piano aperto e registrati.
settings-page-recent-about = Il menu elenca gli ultimi file letti.
settings-page-recent-count = { $count ->
    [0] nessun file
    [one] 1 file
   *[other] { $count } file
}

# Tasti
settings-page-everywhere = Ovunque
settings-page-on-workpiece = Cicli e programmi
settings-page-in-dialog = Nella finestra dei file

# Informazioni
settings-page-version = Versione
settings-page-version-about = Fitcheck dice a colpo d'occhio se un foro o un albero misurato è buono.
settings-page-version-is = { $version }, commit { $commit }
settings-page-unknown = sconosciuto
settings-page-licences = Licenze dei componenti integrati
settings-page-licence = Licenza
settings-page-licence-about = Software libero. I caratteri integrati hanno licenze proprie.
settings-page-state-file = File di stato
settings-page-state-file-about = Conserva impostazioni, campi e file recenti, un secondo dopo ogni modifica.
settings-page-journal-file = File del registro
settings-page-journal-file-about = Conserva ogni controllo di questa stazione.
settings-page-not-used = non in uso
settings-page-own-tables-unread = non è stato possibile leggere { $folder }, e non è in uso
settings-page-nowhere = non conservato
settings-page-changed = { $name }: modifica eseguita
settings-page-several-changed = { $count } impostazioni modificate
settings-page-take-back = Annullare l'ultima modifica di un'impostazione
settings-page-preview = Esempio con queste impostazioni

## The size of the screen
ruler = Dimensioni dello schermo
ruler-about = Accostare una carta bancaria all'immagine e portare l'immagine alla stessa larghezza: i pulsanti dell'operatore sono allora di 20 mm
ruler-card = Una carta bancaria: non ancora confrontata
ruler-known = Una carta bancaria, 85,6 mm
ruler-much-shorter = Molto più corta
ruler-shorter = Un po' più corta
ruler-longer = Un po' più lunga
ruler-much-longer = Molto più lunga
ruler-forget = Dimenticare
settings-page-company = Azienda sui rapporti
settings-page-company-about = Sta in cima a PDF e HTML, se il modello non indica un’azienda.
settings-page-company-address = Indirizzo sui rapporti
settings-page-company-address-about = Un punto e virgola inizia una nuova riga.
settings-page-company-logo = Logo sui rapporti
settings-page-company-logo-about = Il percorso intero di un file PNG, JPEG o SVG.
settings-page-company-logo-place = { $given } non è un percorso intero: iniziare dall’unità o dalla cartella radice
