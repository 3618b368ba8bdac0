## The server of a shop: its address
shop-address-scheme = adresa serveru začíná postgres://
shop-address-no-host = adresa neuvádí server: pište postgres://USER@HOST/DATABASE
shop-address-no-user = adresa neuvádí uživatele: pište postgres://USER@HOST/DATABASE
shop-address-at = adresa má jedno @ navíc: v hesle nebo jménu pište %40 za @, %2F za / a %3F za ?
shop-address-unreadable = adresu serveru nelze přečíst: { $reason }
shop-address-mode = sslmode „{ $given }“ není známo: pište disable, require, verify-ca nebo verify-full
shop-address-plain = sslmode=disable je jen pro server v tomto počítači a { $host } je jiný počítač

## Its password
shop-password-open = soubor hesel byl přeskočen, protože jej mohou číst jiní uživatelé (chmod 600 tomu zabrání): { $path }
shop-password-unread = soubor hesel byl přeskočen: { $what }
shop-password-no-keyring = klíčenka systému nevrátila heslo: { $reason }

## Why it could not be asked
shop-unreachable = { $address } není dostupná: { $reason }
shop-lost = spojení se serverem bylo ztraceno: { $reason }
shop-full = na serveru už není místo
shop-busy = server žádá vyčkat: { $reason }
shop-no-password = server žádá heslo uživatele „{ $user }“ a žádné nebylo nalezeno: nastavte PGPASSWORD, nebo je zapište do souboru hesel či do klíčenky systému
shop-refused = server tohoto uživatele odmítá: { $reason }
shop-no-tls = server nenabízí TLS a bez něj se na jiný počítač nic neodesílá
shop-certificate = certifikát serveru není přijat: { $fault }
shop-certificate-unknown-issuer = nevydala jej autorita, které tento počítač důvěřuje; pro vlastní autoritu dílny uveďte její soubor v adrese pomocí sslrootcert=FILE
shop-certificate-other-name = je pro jiného hostitele, než je v adrese
shop-certificate-expired = jeho platnost skončila
shop-certificate-not-yet = ještě neplatí
shop-certificate-other = { $reason }
shop-authorities = certifikáty autorit nelze použít: { $reason }: { $path }
shop-no-authorities = tento počítač nedůvěřuje žádné autoritě: uveďte soubor vlastní autority dílny v adrese pomocí sslrootcert=FILE
shop-not-made = databáze „{ $database }“ zatím neobsahuje deník: nejprve spusťte fitcheck journal init-shop s její adresou
shop-no-right = server to tomuto uživateli nedovoluje: { $reason }
shop-foreign = databáze má schéma „fitcheck“, které nevytvořil Fitcheck; zůstalo beze změny
shop-newer = deník na serveru vytvořil novější Fitcheck (verze { $version }, tento podporuje { $known }); zůstal beze změny
shop-old-server = PostgreSQL { $version } je příliš starý: je třeba verze { $oldest } nebo novější
shop-encoding = texty této databáze jsou { $encoding }: vytvořte ji s ENCODING 'UTF8'
shop-other-login = tento deník patří na serveru uživateli „{ $login }“ a „{ $ours }“ do něj nesmí přidávat
shop-fork = zápis { $number } na serveru ({ $theirs }) se liší od zdejšího ({ $ours }): existují dvě kopie tohoto deníku, nebo byl změněn
shop-ahead = na serveru má tento deník zápisů { $theirs }, zde však jen { $ours }: byla vrácena starší kopie, nebo existují dvě kopie
shop-not-text = zápis { $number } nelze odeslat: jeho bajty nejsou text
shop-too-long = zápis { $number } nelze odeslat: má { $bytes } bajtů
shop-server = server hlásí: { $reason } ({ $code })
shop-journal = { $what }
shop-machine = tento počítač to nemůže provést: { $reason }
shop-stopped = zastaveno

## Its schema
shop-made-new = deník byl v databázi vytvořen (verze { $version })
shop-made-upgraded = deník v databázi byl převeden z verze { $from } na verzi { $version }
shop-made-already = deník už existoval (verze { $version })

## What is wrong on it
shop-finding-altered = „{ $name }“, které chrání zápisy před změnami, na serveru chybí nebo je vypnuto
shop-finding-row-security = tabulka „{ $name }“ už neomezuje stanice na jejich vlastní deníky: její zabezpečení řádků je vypnuto
shop-finding-chain-name = deník na serveru má neplatný název: { $name }
shop-finding-changed = { $kind } „{ $name }“ na serveru neodpovídá tomu, co vytváří init-shop: zjistěte, kdo to změnil, a spusťte init-shop
shop-finding-gone = { $kind } „{ $name }“ na serveru chybí: zjistěte, kdo to odstranil, a spusťte init-shop
shop-finding-strange = { $kind } „{ $name }“ na serveru je, ale nevytvořil to init-shop: zjistěte, kdo to vytvořil
shop-thing-function = funkce
shop-thing-grant = oprávnění k
shop-thing-index = index
shop-thing-owner = vlastník objektu
shop-thing-policy = zásada
shop-thing-role = role
shop-thing-rule = pravidlo
shop-thing-table = tabulka, sloupec nebo podmínka
shop-thing-trigger = spouštěč
shop-thing-view = pohled
