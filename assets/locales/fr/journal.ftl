## La chaîne d'un journal
journal-hex = « { $text } » : { $digits } chiffres hexadécimaux attendus
journal-break-changed = l'entrée { $number } n'est pas celle qui a été écrite
journal-break-removed = { $count ->
        [one] l'entrée { $number } manque
       *[other] { $count } entrées à partir de { $number } manquent
    }
journal-break-inserted = l'entrée { $number } a été insérée
journal-break-reordered = les entrées { $number } et { $other } ont échangé leurs places
journal-break-rewritten = l'entrée { $number } diffère de celle connue ailleurs : le journal a été réécrit à partir de là ou d'une entrée antérieure
journal-break-cut-off = le journal finit par l'entrée { $last }, mais l'entrée { $known } est connue ailleurs : ses entrées les plus récentes ont été coupées, ou une copie plus ancienne a été remise

## Entrées
journal-body-json = pas une entrée de journal : { $reason }
journal-body-newer = écrit par un Fitcheck plus récent : version { $version } du format, ce Fitcheck lit les versions jusqu'à { $known }
journal-body-too-large = pas une entrée de journal : { $bytes } octets, au plus { $most } admis
journal-body-too-long = { $field } a { $bytes } octets, au plus { $most } admis
journal-body-control = { $field } a le caractère de commande { $code } comme caractère { $place } : les textes d'un journal tiennent en une ligne sans caractères de commande
journal-body-empty = { $field } est vide
journal-body-too-many = { $field } a { $count } entrées, au plus { $most } admises
journal-body-value = { $field } ne peut pas être « { $given } »
journal-body-contradiction = { $field } contredit les champs dont il découle
journal-origin-perfect = simulé, pièce sans défauts
journal-origin-workpiece = simulé, { $file }, graine { $seed }
journal-origin-contacts = points de palpage de { $file }
journal-check-judged-otherwise = décidé { $kept }, ce qui reste valide ; cette version de Fitcheck décide { $now }

## Questions
journal-ask-at = { $reason } (caractère { $at })
journal-ask-unknown-key = { $key } : mot-clé inconnu ; { $known } attendu, ou des guillemets autour d'un mot avec deux-points
journal-ask-no-value = { $key } : sans valeur
journal-ask-empty-word = un mot entre guillemets est vide
journal-ask-twice = { $key } est donné deux fois
journal-ask-not-closed = un guillemet n'est pas fermé
journal-ask-after-quote = espace attendue après le guillemet fermant, { $found } trouvé
journal-ask-date = « { $given } » n'est ni un jour ni une heure : 2026-11-23 ou 2026-11-23T14:30 attendu
journal-ask-verdict = « { $given } » n'est pas un verdict : { $known } attendu
journal-ask-callout = { $error } ; une cote tolérancée se met entre guillemets : callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = la période finit avant de commencer : from doit être avant to
journal-ask-both-origins = simulated et measured s'excluent
journal-ask-both-kinds = reports et checks s'excluent
journal-ask-too-long = la question a { $bytes } octets, au plus { $most } admis

## Le journal d'un poste
store-missing = il n'y a pas de journal à { $path }
store-not-a-file = { $path } n'est pas un fichier
store-not-a-journal = { $path } n'est pas un journal de Fitcheck ; il est resté inchangé
store-newer = { $path } a été écrit par un Fitcheck plus récent (version { $version }, celui-ci lit jusqu'à { $known }) ; il est resté inchangé
store-older = { $path } a été écrit par un Fitcheck plus ancien : il est mis à niveau dès qu'on y consigne quelque chose
store-damaged = { $path } est endommagé : ses pages se contredisent
store-full = plus de place pour { $path } : rien n'a été consigné
store-read-only = { $path } est protégé en écriture : rien n'a été consigné
store-locked = un autre programme a verrouillé { $path } trop longtemps : rien n'a été consigné
store-disk = le disque de { $path } signale une erreur : { $reason }
store-cannot-open = { $path } ne peut pas être ouvert
store-network-folder = { $path } est dans un dossier d'une autre machine, où deux postes pourraient écraser les entrées l'un de l'autre : choisir un dossier de cette machine, et un serveur pour l'atelier
store-altered = « { $name } », qui protège les entrées contre les modifications, manque dans { $path } ou a été modifié
store-no-beginning = { $path } ne dit pas de quelle chaîne il s'agit
store-moved = { $path } a été déplacé ou mis de côté entre-temps : rien n'a été consigné
store-other-target = l'entrée { $number } n'est pas celle à corriger : rien n'a été consigné
store-corrected = l'entrée { $number } a déjà été corrigée ou retirée par l'entrée { $by } : corriger celle-là, sauf si c'est un retrait
store-is-report = l'entrée { $number } est un rapport : elle dit quel fichier a été écrit, et ne peut être ni corrigée ni retirée
store-is-alarm = l'entrée { $number } est une alarme d'une carte de contrôle : elle dit quelle règle s'est déclenchée, et ne peut être ni corrigée ni retirée ; y répondre
store-no-alarm = l'entrée { $number } n'est pas une alarme d'une carte de contrôle : on ne peut répondre qu'à une alarme
journal-alarm-since-part = { $rule }, depuis la pièce { $serial }
journal-alarm-since-entry = { $rule }, depuis le relevé { $number }
store-other-journal = l'entrée { $number } de ce journal n'est pas celle que nomme le rapport : rien n'a été consigné
store-finding-no-beginning = le journal n'a pas de première entrée qui nomme sa chaîne
store-finding-pages = les pages du journal se contredisent, et des questions peuvent manquer des entrées qui y sont : { $reason }
store-finding-index = un index pour les questions ne correspond pas à sa table : { $reason }
store-hidden = l'entrée { $number } de { $path } n'est pas à sa place : le journal a été modifié ou son fichier est endommagé ; exécuter fitcheck journal verify
store-no-entry = { $path } n'a pas d'entrée { $number } : la dernière est { $last }
store-backup = la copie de { $path } était incomplète et a été supprimée
store-interrupted = arrêté
store-database = { $path } : { $reason }
store-remark-begun = un nouveau journal a été créé : { $path }
store-remark-set-aside = le journal { $path } était endommagé : il est maintenant dans { $folder }, inchangé, et un nouveau a été créé à sa place
store-remark-migrated = { $path } a été mis à niveau vers cette version ; le fichier tel qu'il était avant est { $copy }
store-remark-behind = { $path } finit par l'entrée { $last }, mais a eu l'entrée { $known } : ses entrées les plus récentes ont été coupées, ou une copie plus ancienne a été remise
store-remark-other = l'entrée { $number } de { $path } diffère de ce qu'elle était : le journal a été réécrit à partir de là ou d'une entrée antérieure
store-remark-replaced = { $path } n'est pas le journal qui était là avant, qui avait { $known } entrées
store-remark-waits = un autre programme écrit dans { $path } : attente de sa fin
store-remark-no-anchor = la dernière entrée de ce journal n'a pas pu être notée dans { $path } : { $reason }
store-finding-altered = « { $name } », qui protège les entrées contre les modifications, manque ou a été modifié
store-finding-not-found = { $entries ->
        [one] { $entries } entrée est indexée autrement que ce qu'elle dit, ou n'est pas indexée
       *[other] { $entries } entrées sont indexées autrement que ce qu'elles disent, ou ne sont pas indexées
    }
