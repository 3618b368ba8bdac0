## The server of a shop: its address
shop-address-scheme = het adres van een server begint met postgres://
shop-address-no-host = het adres noemt geen server: schrijf postgres://GEBRUIKER@SERVER/DATABASE
shop-address-no-user = het adres noemt geen gebruiker: schrijf postgres://GEBRUIKER@SERVER/DATABASE
shop-address-at = het adres heeft een @ te veel: schrijf in een wachtwoord of naam %40 voor @, %2F voor / en %3F voor ?
shop-address-unreadable = het adres van de server is niet te lezen: { $reason }
shop-address-mode = sslmode "{ $given }" is onbekend: schrijf disable, require, verify-ca of verify-full
shop-address-plain = sslmode=disable is alleen voor een server op deze computer, en { $host } is een andere

## Its password
shop-password-open = het wachtwoordbestand is overgeslagen, want andere gebruikers kunnen het lezen (chmod 600 voorkomt dat): { $path }
shop-password-unread = het wachtwoordbestand is overgeslagen: { $what }
shop-password-no-keyring = de sleutelbos van het systeem gaf geen wachtwoord: { $reason }

## Why it could not be asked
shop-unreachable = { $address } is niet bereikbaar: { $reason }
shop-lost = de verbinding met de server is verbroken: { $reason }
shop-full = de server heeft geen ruimte meer
shop-busy = de server vraagt om te wachten: { $reason }
shop-no-password = de server vraagt het wachtwoord van "{ $user }", en er is er geen gevonden: zet PGPASSWORD, of schrijf het in het wachtwoordbestand of de sleutelbos van het systeem
shop-refused = de server laat deze gebruiker niet toe: { $reason }
shop-no-tls = de server biedt geen TLS, en zonder TLS wordt niets naar een andere computer gestuurd
shop-certificate = het certificaat van de server wordt niet aanvaard: { $fault }
shop-certificate-unknown-issuer = geen autoriteit die deze computer vertrouwt heeft het uitgegeven; noem voor een eigen autoriteit haar bestand met sslrootcert=BESTAND in het adres
shop-certificate-other-name = het is voor een andere server dan het adres noemt
shop-certificate-expired = het is verlopen
shop-certificate-not-yet = het is nog niet geldig
shop-certificate-other = { $reason }
shop-authorities = de certificaten van de autoriteiten zijn niet bruikbaar: { $reason }: { $path }
shop-no-authorities = deze computer vertrouwt geen enkele autoriteit: noem het bestand van de eigen autoriteit met sslrootcert=BESTAND in het adres
shop-not-made = de database "{ $database }" heeft nog geen logboek: voer eerst fitcheck journal init-shop uit met haar adres
shop-no-right = de server staat deze gebruiker dat niet toe: { $reason }
shop-foreign = de database heeft een schema "fitcheck" dat niet door Fitcheck is gemaakt; het is niet gewijzigd
shop-newer = het logboek op de server is door een nieuwere Fitcheck gemaakt (versie { $version }, deze ondersteunt { $known }); het is niet gewijzigd
shop-old-server = PostgreSQL { $version } is te oud: versie { $oldest } of later is nodig
shop-encoding = de teksten van deze database zijn { $encoding }: maak er een met ENCODING 'UTF8'
shop-other-login = dit logboek is op de server van "{ $login }", en "{ $ours }" mag er niets aan toevoegen
shop-fork = vermelding { $number } op de server ({ $theirs }) verschilt van die hier ({ $ours }): er zijn twee kopieën van dit logboek, of het is gewijzigd
shop-ahead = de server heeft { $theirs } vermeldingen van dit logboek, maar hier zijn er maar { $ours }: er is een oudere kopie teruggezet, of er zijn twee kopieën van
shop-not-text = vermelding { $number } kan niet worden verstuurd: de bytes zijn geen tekst
shop-too-long = vermelding { $number } kan niet worden verstuurd: die heeft { $bytes } bytes
shop-server = de server meldt: { $reason } ({ $code })
shop-journal = { $what }
shop-machine = deze computer kan dat niet: { $reason }
shop-stopped = gestopt

## Its schema
shop-made-new = het logboek is in de database gemaakt (versie { $version })
shop-made-upgraded = het logboek in de database is van versie { $from } naar versie { $version } omgezet
shop-made-already = het logboek was er al (versie { $version })

## What is wrong on it
shop-finding-altered = "{ $name }", dat vermeldingen tegen wijzigen beschermt, ontbreekt op de server of is uitgeschakeld
shop-finding-row-security = de tabel "{ $name }" houdt stations niet meer bij hun eigen logboek: de rijbeveiliging is uitgeschakeld
shop-finding-chain-name = een logboek op de server heeft een ongeldige naam: { $name }
shop-finding-changed = { $kind } "{ $name }" is op de server niet zoals init-shop het maakt: zoek uit wie dit heeft veranderd, en voer init-shop uit
shop-finding-gone = { $kind } "{ $name }" ontbreekt op de server: zoek uit wie dit heeft verwijderd, en voer init-shop uit
shop-finding-strange = { $kind } "{ $name }" staat op de server en is niet door init-shop gemaakt: zoek uit wie dit heeft gemaakt
shop-thing-function = de functie
shop-thing-grant = het recht op
shop-thing-index = de index
shop-thing-owner = de eigenaar van
shop-thing-policy = de regel voor rijen
shop-thing-role = de rol
shop-thing-rule = de herschrijfregel
shop-thing-table = de tabel, kolom of voorwaarde
shop-thing-trigger = de trigger
shop-thing-view = de view
