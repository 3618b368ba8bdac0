## The server of a shop: its address
shop-address-scheme = la dirección de un servidor empieza por postgres://
shop-address-no-host = la dirección no nombra ningún servidor: escriba postgres://USER@HOST/DATABASE
shop-address-no-user = la dirección no nombra ningún usuario: escriba postgres://USER@HOST/DATABASE
shop-address-at = la dirección tiene un @ de más: en una contraseña o un nombre, escriba %40 para @, %2F para / y %3F para ?
shop-address-unreadable = la dirección del servidor no se puede leer: { $reason }
shop-address-mode = sslmode "{ $given }" no es conocido: escriba disable, require, verify-ca o verify-full
shop-address-plain = sslmode=disable es solo para un servidor en este ordenador, y { $host } es otro

## Its password
shop-password-open = el archivo de contraseñas se omitió, porque otros usuarios pueden leerlo (chmod 600 lo impide): { $path }
shop-password-unread = el archivo de contraseñas se omitió: { $what }
shop-password-no-keyring = el llavero del sistema no devolvió ninguna contraseña: { $reason }

## Why it could not be asked
shop-unreachable = no se puede alcanzar { $address }: { $reason }
shop-lost = se perdió la conexión con el servidor: { $reason }
shop-full = al servidor no le queda espacio
shop-busy = el servidor pide esperar: { $reason }
shop-no-password = el servidor pide la contraseña de "{ $user }", y no se encontró ninguna: defina PGPASSWORD, o escríbala en el archivo de contraseñas o en el llavero del sistema
shop-refused = el servidor rechaza a este usuario: { $reason }
shop-no-tls = el servidor no ofrece TLS, y sin él no se envía nada a otro ordenador
shop-certificate = el certificado del servidor no se acepta: { $fault }
shop-certificate-unknown-issuer = no lo emitió una autoridad en la que este ordenador confíe; para la autoridad propia de un taller, indique su archivo con sslrootcert=FILE en la dirección
shop-certificate-other-name = es para un host distinto del de la dirección
shop-certificate-expired = ha caducado
shop-certificate-not-yet = aún no es válido
shop-certificate-other = { $reason }
shop-authorities = los certificados de las autoridades no se pueden usar: { $reason }: { $path }
shop-no-authorities = este ordenador no confía en ninguna autoridad: indique el archivo de la autoridad propia del taller con sslrootcert=FILE en la dirección
shop-not-made = la base de datos "{ $database }" aún no contiene ningún registro: ejecute antes fitcheck journal init-shop con su dirección
shop-no-right = el servidor no permite eso a este usuario: { $reason }
shop-foreign = la base de datos tiene un esquema "fitcheck" que no hizo Fitcheck; se dejó sin cambios
shop-newer = el registro del servidor fue hecho por un Fitcheck más nuevo (versión { $version }, este admite { $known }); se dejó sin cambios
shop-old-server = PostgreSQL { $version } es demasiado antiguo: se requiere la versión { $oldest } o posterior
shop-encoding = los textos de esta base de datos están en { $encoding }: cree una con ENCODING 'UTF8'
shop-other-login = este registro pertenece a "{ $login }" en el servidor, y "{ $ours }" no puede añadirle nada
shop-fork = la entrada { $number } del servidor ({ $theirs }) difiere de la de aquí ({ $ours }): hay dos copias de este registro, o se modificó
shop-ahead = el servidor tiene { $theirs } entradas de este registro, pero aquí hay solo { $ours }: se repuso una copia anterior, o hay dos copias de él
shop-not-text = la entrada { $number } no se puede enviar: sus bytes no son texto
shop-too-long = la entrada { $number } no se puede enviar: tiene { $bytes } bytes
shop-server = el servidor comunica: { $reason } ({ $code })
shop-journal = { $what }
shop-machine = este ordenador no puede hacerlo: { $reason }
shop-stopped = detenido

## Its schema
shop-made-new = el registro se creó en la base de datos (versión { $version })
shop-made-upgraded = el registro de la base de datos se actualizó de la versión { $from } a la versión { $version }
shop-made-already = el registro ya existía (versión { $version })

## What is wrong on it
shop-finding-altered = "{ $name }", que protege las entradas contra cambios, falta en el servidor o está desactivado
shop-finding-row-security = la tabla "{ $name }" ya no limita los puestos a sus propios registros: su seguridad por filas está desactivada
shop-finding-chain-name = un registro del servidor tiene un nombre no válido: { $name }
shop-finding-changed = { $kind } "{ $name }" en el servidor no está tal como lo deja init-shop: averigüe quién hizo el cambio, y ejecute init-shop
shop-finding-gone = en el servidor falta { $kind } "{ $name }": averigüe quién hizo el cambio, y ejecute init-shop
shop-finding-strange = en el servidor está { $kind } "{ $name }", que no creó init-shop: averigüe de quién procede
shop-thing-function = la función
shop-thing-grant = el permiso sobre
shop-thing-index = el índice
shop-thing-owner = el propietario de
shop-thing-policy = la directiva
shop-thing-role = el rol
shop-thing-rule = la regla
shop-thing-table = la tabla, columna o condición
shop-thing-trigger = el disparador
shop-thing-view = la vista
