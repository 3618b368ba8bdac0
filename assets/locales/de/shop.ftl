## Der Server einer Werkstatt: seine Adresse
shop-address-scheme = die Adresse eines Servers beginnt mit postgres://
shop-address-no-host = die Adresse nennt keinen Server: postgres://USER@HOST/DATABASE schreiben
shop-address-no-user = die Adresse nennt keinen Benutzer: postgres://USER@HOST/DATABASE schreiben
shop-address-at = die Adresse hat ein @ zu viel: in Kennwort oder Name %40 für @, %2F für / und %3F für ? schreiben
shop-address-unreadable = die Adresse des Servers kann nicht gelesen werden: { $reason }
shop-address-mode = sslmode "{ $given }" ist nicht bekannt: disable, require, verify-ca oder verify-full schreiben
shop-address-plain = sslmode=disable gilt nur für einen Server auf diesem Computer, und { $host } ist ein anderer

## Sein Kennwort
shop-password-open = die Kennwortdatei wurde übersprungen, da andere Benutzer sie lesen können (chmod 600 verhindert das): { $path }
shop-password-unread = die Kennwortdatei wurde übersprungen: { $what }
shop-password-no-keyring = der Schlüsselbund des Systems lieferte kein Kennwort: { $reason }

## Warum er nicht gefragt werden konnte
shop-unreachable = { $address } ist nicht erreichbar: { $reason }
shop-lost = die Verbindung zum Server ist abgebrochen: { $reason }
shop-full = der Server hat keinen Platz mehr
shop-busy = der Server bittet zu warten: { $reason }
shop-no-password = der Server verlangt das Kennwort von "{ $user }", und keines wurde gefunden: PGPASSWORD setzen, oder es in die Kennwortdatei oder den Schlüsselbund des Systems eintragen
shop-refused = der Server lehnt diesen Benutzer ab: { $reason }
shop-no-tls = der Server bietet kein TLS, und ohne TLS wird nichts an einen anderen Computer gesendet
shop-certificate = das Zertifikat des Servers wird nicht angenommen: { $fault }
shop-certificate-unknown-issuer = es wurde von keiner Zertifizierungsstelle ausgestellt, der dieser Computer vertraut; für eine eigene der Werkstatt deren Datei mit sslrootcert=FILE in der Adresse nennen
shop-certificate-other-name = es gilt für einen anderen Host als den in der Adresse
shop-certificate-expired = es ist abgelaufen
shop-certificate-not-yet = es ist noch nicht gültig
shop-certificate-other = { $reason }
shop-authorities = die Zertifikate der Zertifizierungsstellen können nicht verwendet werden: { $reason }: { $path }
shop-no-authorities = dieser Computer vertraut keiner Zertifizierungsstelle: die Datei der eigenen Stelle der Werkstatt mit sslrootcert=FILE in der Adresse nennen
shop-not-made = die Datenbank "{ $database }" enthält noch kein Journal: zuerst fitcheck journal init-shop mit ihrer Adresse ausführen
shop-no-right = der Server erlaubt diesem Benutzer das nicht: { $reason }
shop-foreign = die Datenbank hat ein Schema "fitcheck", das nicht von Fitcheck stammt; es blieb unverändert
shop-newer = das Journal auf dem Server stammt von einem neueren Fitcheck (Version { $version }, dieses unterstützt { $known }); es blieb unverändert
shop-old-server = PostgreSQL { $version } ist zu alt: Version { $oldest } oder neuer ist nötig
shop-encoding = die Texte dieser Datenbank sind { $encoding }: eine mit ENCODING 'UTF8' anlegen
shop-other-login = dieses Journal gehört auf dem Server "{ $login }", und "{ $ours }" darf nichts hinzufügen
shop-fork = Eintrag { $number } auf dem Server ({ $theirs }) weicht von dem hier ({ $ours }) ab: es gibt zwei Kopien dieses Journals, oder es wurde geändert
shop-ahead = der Server hat { $theirs } Einträge dieses Journals, hier sind es aber nur { $ours }: eine ältere Kopie wurde zurückgespielt, oder es gibt zwei Kopien davon
shop-not-text = Eintrag { $number } kann nicht gesendet werden: seine Bytes sind kein Text
shop-too-long = Eintrag { $number } kann nicht gesendet werden: er hat { $bytes } Byte
shop-server = der Server meldet: { $reason } ({ $code })
shop-journal = { $what }
shop-machine = dieser Computer kann das nicht: { $reason }
shop-stopped = angehalten

## Sein Schema
shop-made-new = das Journal wurde in der Datenbank angelegt (Version { $version })
shop-made-upgraded = das Journal in der Datenbank wurde von Version { $from } auf Version { $version } umgestellt
shop-made-already = das Journal war schon vorhanden (Version { $version })

## Was daran falsch ist
shop-finding-altered = "{ $name }", das Einträge vor Änderungen schützt, fehlt auf dem Server oder ist ausgeschaltet
shop-finding-row-security = die Tabelle "{ $name }" beschränkt Stationen nicht mehr auf ihre eigenen Journale: ihre Zeilensicherheit ist ausgeschaltet
shop-finding-chain-name = ein Journal auf dem Server hat einen ungültigen Namen: { $name }
shop-finding-changed = { $kind } "{ $name }" auf dem Server ist nicht so, wie init-shop es anlegt: herausfinden, wer das geändert hat, und init-shop ausführen
shop-finding-gone = { $kind } "{ $name }" fehlt auf dem Server: herausfinden, wer das entfernt hat, und init-shop ausführen
shop-finding-strange = { $kind } "{ $name }" ist auf dem Server, wurde aber nicht von init-shop angelegt: herausfinden, wer das angelegt hat
shop-thing-function = die Funktion
shop-thing-grant = die Berechtigung für
shop-thing-index = der Index
shop-thing-owner = der Eigentümer von
shop-thing-policy = die Richtlinie
shop-thing-role = die Rolle
shop-thing-rule = die Regel
shop-thing-table = die Tabelle, Spalte oder Bedingung
shop-thing-trigger = der Trigger
shop-thing-view = die Sicht
