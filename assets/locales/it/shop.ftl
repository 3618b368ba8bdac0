## Il server di un'officina: il suo indirizzo
shop-address-scheme = l'indirizzo di un server comincia con postgres://
shop-address-no-host = l'indirizzo non indica un server: scrivere postgres://USER@HOST/DATABASE
shop-address-no-user = l'indirizzo non indica un utente: scrivere postgres://USER@HOST/DATABASE
shop-address-at = l'indirizzo ha un @ di troppo: in una password o in un nome, scrivere %40 per @, %2F per / e %3F per ?
shop-address-unreadable = l'indirizzo del server non è leggibile: { $reason }
shop-address-mode = sslmode «{ $given }» non è noto: scrivere disable, require, verify-ca o verify-full
shop-address-plain = sslmode=disable vale solo per un server su questo computer, e { $host } è un altro

## La sua password
shop-password-open = il file delle password è stato saltato, perché altri utenti possono leggerlo (chmod 600 lo impedisce): { $path }
shop-password-unread = il file delle password è stato saltato: { $what }
shop-password-no-keyring = il portachiavi del sistema non ha restituito una password: { $reason }

## Perché non si è potuto interrogare
shop-unreachable = { $address } non è raggiungibile: { $reason }
shop-lost = il collegamento al server si è interrotto: { $reason }
shop-full = il server non ha più spazio
shop-busy = il server chiede di attendere: { $reason }
shop-no-password = il server chiede la password di «{ $user }», e non se ne è trovata alcuna: impostare PGPASSWORD, o scriverla nel file delle password o nel portachiavi del sistema
shop-refused = il server rifiuta questo utente: { $reason }
shop-no-tls = il server non offre TLS, e senza non si invia nulla a un altro computer
shop-certificate = il certificato del server non è accettato: { $fault }
shop-certificate-unknown-issuer = non è stato emesso da un'autorità riconosciuta da questo computer; per un'autorità dell'officina, indicarne il file con sslrootcert=FILE nell'indirizzo
shop-certificate-other-name = è per un host diverso da quello dell'indirizzo
shop-certificate-expired = è scaduto
shop-certificate-not-yet = non è ancora valido
shop-certificate-other = { $reason }
shop-authorities = i certificati delle autorità non sono utilizzabili: { $reason }: { $path }
shop-no-authorities = questo computer non riconosce alcuna autorità: indicare il file dell'autorità dell'officina con sslrootcert=FILE nell'indirizzo
shop-not-made = il database «{ $database }» non contiene ancora un registro: eseguire prima fitcheck journal init-shop con il suo indirizzo
shop-no-right = il server non permette l'operazione a questo utente: { $reason }
shop-foreign = il database ha uno schema «fitcheck» non creato da Fitcheck; è rimasto invariato
shop-newer = il registro sul server è stato creato da un Fitcheck più recente (versione { $version }, questo supporta la { $known }); è rimasto invariato
shop-old-server = PostgreSQL { $version } è troppo vecchio: serve la versione { $oldest } o successiva
shop-encoding = i testi di questo database sono { $encoding }: crearne uno con ENCODING 'UTF8'
shop-other-login = sul server questo registro appartiene a «{ $login }», e «{ $ours }» non può aggiungervi nulla
shop-fork = la voce { $number } sul server ({ $theirs }) differisce da quella qui ({ $ours }): ci sono due copie di questo registro, o è stato modificato
shop-ahead = il server ha { $theirs } voci di questo registro, ma qui ce ne sono solo { $ours }: è stata rimessa una copia più vecchia, o ce ne sono due copie
shop-not-text = la voce { $number } non si può inviare: i suoi byte non sono testo
shop-too-long = la voce { $number } non si può inviare: ha { $bytes } byte
shop-server = il server segnala: { $reason } ({ $code })
shop-journal = { $what }
shop-machine = questo computer non può farlo: { $reason }
shop-stopped = interrotto

## Il suo schema
shop-made-new = il registro è stato creato nel database (versione { $version })
shop-made-upgraded = il registro nel database è stato aggiornato dalla versione { $from } alla versione { $version }
shop-made-already = il registro esisteva già (versione { $version })

## Che cosa non va
shop-finding-altered = «{ $name }», che protegge le voci dalle modifiche, manca sul server o è disattivato
shop-finding-row-security = la tabella «{ $name }» non limita più le stazioni ai propri registri: la sua sicurezza a livello di riga (row security) è disattivata
shop-finding-chain-name = un registro sul server ha un nome non valido: { $name }
shop-finding-changed = { $kind } «{ $name }» sul server non è come da init-shop: accertare chi ha fatto la modifica, ed eseguire init-shop
shop-finding-gone = { $kind } «{ $name }» manca sul server: accertare chi ha fatto la rimozione, ed eseguire init-shop
shop-finding-strange = { $kind } «{ $name }» è sul server ma non viene da init-shop: accertarne la provenienza
shop-thing-function = la funzione
shop-thing-grant = il permesso su
shop-thing-index = l'indice
shop-thing-owner = il proprietario di
shop-thing-policy = la policy
shop-thing-role = il ruolo
shop-thing-rule = la regola
shop-thing-table = la tabella, colonna o condizione
shop-thing-trigger = il trigger
shop-thing-view = la vista
