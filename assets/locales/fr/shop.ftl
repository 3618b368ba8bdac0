## Le serveur d'un atelier : son adresse
shop-address-scheme = l'adresse d'un serveur commence par postgres://
shop-address-no-host = l'adresse ne nomme aucun serveur : écrire postgres://USER@HOST/DATABASE
shop-address-no-user = l'adresse ne nomme aucun utilisateur : écrire postgres://USER@HOST/DATABASE
shop-address-at = l'adresse a un @ de trop : dans un mot de passe ou un nom, écrire %40 pour @, %2F pour / et %3F pour ?
shop-address-unreadable = l'adresse du serveur ne peut pas être lue : { $reason }
shop-address-mode = sslmode « { $given } » est inconnu : écrire disable, require, verify-ca ou verify-full
shop-address-plain = sslmode=disable n'est admis que pour un serveur sur cet ordinateur, et { $host } en est un autre

## Son mot de passe
shop-password-open = le fichier de mots de passe a été ignoré, car d'autres utilisateurs peuvent le lire (chmod 600 l'empêche) : { $path }
shop-password-unread = le fichier de mots de passe a été ignoré : { $what }
shop-password-no-keyring = le trousseau du système n'a renvoyé aucun mot de passe : { $reason }

## Pourquoi il n'a pas pu être interrogé
shop-unreachable = { $address } ne peut pas être joint : { $reason }
shop-lost = la connexion au serveur a été perdue : { $reason }
shop-full = le serveur n'a plus de place
shop-busy = le serveur demande d'attendre : { $reason }
shop-no-password = le serveur demande le mot de passe de « { $user } », et aucun n'a été trouvé : définir PGPASSWORD, ou l'écrire dans le fichier de mots de passe ou le trousseau du système
shop-refused = le serveur refuse cet utilisateur : { $reason }
shop-no-tls = le serveur n'offre pas TLS, et rien n'est envoyé sans TLS à un autre ordinateur
shop-certificate = le certificat du serveur n'est pas accepté : { $fault }
shop-certificate-unknown-issuer = il n'a pas été délivré par une autorité reconnue par cet ordinateur ; pour l'autorité propre à l'atelier, nommer son fichier avec sslrootcert=FILE dans l'adresse
shop-certificate-other-name = il est pour un autre hôte que celui de l'adresse
shop-certificate-expired = il a expiré
shop-certificate-not-yet = il n'est pas encore valable
shop-certificate-other = { $reason }
shop-authorities = les certificats des autorités ne peuvent pas être utilisés : { $reason } : { $path }
shop-no-authorities = cet ordinateur ne reconnaît aucune autorité : nommer le fichier de l'autorité propre à l'atelier avec sslrootcert=FILE dans l'adresse
shop-not-made = la base de données « { $database } » ne contient pas encore de journal : exécuter d'abord fitcheck journal init-shop avec son adresse
shop-no-right = le serveur n'y autorise pas cet utilisateur : { $reason }
shop-foreign = la base de données a un schéma « fitcheck » qui n'a pas été créé par Fitcheck ; il est resté inchangé
shop-newer = le journal du serveur a été écrit par un Fitcheck plus récent (version { $version }, celui-ci lit jusqu'à { $known }) ; il est resté inchangé
shop-old-server = PostgreSQL { $version } est trop ancien : version { $oldest } ou ultérieure requise
shop-encoding = les textes de cette base de données sont en { $encoding } : en créer une avec ENCODING 'UTF8'
shop-other-login = ce journal appartient à « { $login } » sur le serveur, et « { $ours } » ne peut rien y ajouter
shop-fork = l'entrée { $number } du serveur ({ $theirs }) diffère de celle d'ici ({ $ours }) : il y a deux copies de ce journal, ou il a été modifié
shop-ahead = le serveur a { $theirs } entrées de ce journal, mais il n'y en a ici que { $ours } : une copie plus ancienne a été remise, ou il y en a deux copies
shop-not-text = l'entrée { $number } ne peut pas être envoyée : ses octets ne sont pas du texte
shop-too-long = l'entrée { $number } ne peut pas être envoyée : elle a { $bytes } octets
shop-server = le serveur signale : { $reason } ({ $code })
shop-journal = { $what }
shop-machine = impossible sur cet ordinateur : { $reason }
shop-stopped = arrêté

## Son schéma
shop-made-new = le journal a été créé dans la base de données (version { $version })
shop-made-upgraded = le journal de la base de données a été mis à niveau de la version { $from } à la version { $version }
shop-made-already = le journal existait déjà (version { $version })

## Ce qui ne va pas sur le serveur
shop-finding-altered = « { $name } », qui protège les entrées contre les modifications, manque sur le serveur ou est désactivé
shop-finding-row-security = la table « { $name } » ne limite plus les postes à leurs propres journaux : sa sécurité par rangée est désactivée
shop-finding-chain-name = un journal du serveur a un nom non valide : { $name }
shop-finding-changed = { $kind } « { $name } » n'est pas sur le serveur dans l'état créé par init-shop : chercher qui est à l'origine de la modification, et exécuter init-shop
shop-finding-gone = { $kind } « { $name } » manque sur le serveur : chercher qui est à l'origine de la suppression, et exécuter init-shop
shop-finding-strange = { $kind } « { $name } » est sur le serveur, mais ne vient pas d'init-shop : chercher qui en est à l'origine
shop-thing-function = la fonction
shop-thing-grant = le droit sur
shop-thing-index = l'index
shop-thing-owner = le propriétaire de
shop-thing-policy = la politique
shop-thing-role = le rôle
shop-thing-rule = la règle
shop-thing-table = la table, colonne ou condition
shop-thing-trigger = le déclencheur
shop-thing-view = la vue
