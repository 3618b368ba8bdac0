## The server of a shop: its address
shop-address-scheme = the address of a server begins with postgres://
shop-address-no-host = the address names no server: write postgres://USER@HOST/DATABASE
shop-address-no-user = the address names no user: write postgres://USER@HOST/DATABASE
shop-address-at = the address has one @ too many: in a password or a name, write %40 for @, %2F for / and %3F for ?
shop-address-unreadable = the address of the server cannot be read: { $reason }
shop-address-mode = sslmode "{ $given }" is not known: write disable, require, verify-ca or verify-full
shop-address-plain = sslmode=disable is for a server on this computer only, and { $host } is another one

## Its password
shop-password-open = the password file was skipped, because other users can read it (chmod 600 prevents that): { $path }
shop-password-unread = the password file was skipped: { $what }
shop-password-no-keyring = the system's keyring returned no password: { $reason }

## Why it could not be asked
shop-unreachable = { $address } cannot be reached: { $reason }
shop-lost = the connection to the server was lost: { $reason }
shop-full = the server has no space left
shop-busy = the server asks to wait: { $reason }
shop-no-password = the server asks for the password of "{ $user }", and none was found: set PGPASSWORD, or write it to the password file or the system's keyring
shop-refused = the server refuses this user: { $reason }
shop-no-tls = the server offers no TLS, and nothing is sent to another computer without it
shop-certificate = the certificate of the server is not accepted: { $fault }
shop-certificate-unknown-issuer = it was not issued by an authority that this computer trusts; for a shop's own authority, name its file with sslrootcert=FILE in the address
shop-certificate-other-name = it is for a different host from the one in the address
shop-certificate-expired = it has expired
shop-certificate-not-yet = it is not valid yet
shop-certificate-other = { $reason }
shop-authorities = the certificates of the authorities cannot be used: { $reason }: { $path }
shop-no-authorities = this computer trusts no authority: name the file of the shop's own authority with sslrootcert=FILE in the address
shop-not-made = the database "{ $database }" holds no journal yet: run fitcheck journal init-shop with its address first
shop-no-right = the server does not permit this user to do that: { $reason }
shop-foreign = the database has a schema "fitcheck" that was not made by Fitcheck; it was left unchanged
shop-newer = the journal on the server was made by a newer Fitcheck (version { $version }, this one supports { $known }); it was left unchanged
shop-old-server = PostgreSQL { $version } is too old: version { $oldest } or later is required
shop-encoding = the texts of this database are { $encoding }: create one with ENCODING 'UTF8'
shop-other-login = this journal belongs to "{ $login }" on the server, and "{ $ours }" may not add to it
shop-fork = entry { $number } on the server ({ $theirs }) differs from the one here ({ $ours }): there are two copies of this journal, or it was changed
shop-ahead = the server has { $theirs } entries of this journal, but here there are only { $ours }: an older copy was put back, or there are two copies of it
shop-not-text = entry { $number } cannot be sent: its bytes are not text
shop-too-long = entry { $number } cannot be sent: it has { $bytes } bytes
shop-server = the server reports: { $reason } ({ $code })
shop-journal = { $what }
shop-machine = this computer cannot do that: { $reason }
shop-stopped = stopped

## Its schema
shop-made-new = the journal was created in the database (version { $version })
shop-made-upgraded = the journal in the database was upgraded from version { $from } to version { $version }
shop-made-already = the journal existed already (version { $version })

## What is wrong on it
shop-finding-altered = "{ $name }", which protects entries from changes, is missing on the server or switched off
shop-finding-row-security = the table "{ $name }" no longer restricts stations to their own journals: its row security is switched off
shop-finding-chain-name = a journal on the server has an invalid name: { $name }
shop-finding-changed = { $kind } "{ $name }" on the server is not as init-shop creates it: find out who changed it, and run init-shop
shop-finding-gone = { $kind } "{ $name }" is missing on the server: find out who removed it, and run init-shop
shop-finding-strange = { $kind } "{ $name }" is on the server but was not created by init-shop: find out who created it
shop-thing-function = the function
shop-thing-grant = the grant on
shop-thing-index = the index
shop-thing-owner = the owner of
shop-thing-policy = the policy
shop-thing-role = the role
shop-thing-rule = the rule
shop-thing-table = the table, column or condition
shop-thing-trigger = the trigger
shop-thing-view = the view
