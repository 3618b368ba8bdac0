## The chain of a journal
journal-hex = "{ $text }" no son { $digits } dígitos hexadecimales
journal-break-changed = la entrada { $number } no es la que se escribió
journal-break-removed = { $count ->
        [one] falta la entrada { $number }
       *[other] faltan { $count } entradas desde la { $number }
    }
journal-break-inserted = la entrada { $number } fue insertada
journal-break-reordered = las entradas { $number } y { $other } han cambiado de lugar
journal-break-rewritten = la entrada { $number } difiere de la que se conoce en otro lugar: el registro se reescribió desde ella o desde una anterior
journal-break-cut-off = el registro termina con la entrada { $last }, pero en otro lugar se conoce la entrada { $known }: se cortaron sus entradas más recientes, o se repuso una copia anterior

## Entries
journal-body-json = no es una entrada de un registro: { $reason }
journal-body-newer = hecho por un Fitcheck más nuevo: versión { $version } del formato, este Fitcheck lee versiones hasta la { $known }
journal-body-too-large = no es una entrada de un registro: { $bytes } bytes, se admiten como máximo { $most }
journal-body-too-long = { $field } tiene { $bytes } bytes, se admiten como máximo { $most }
journal-body-control = { $field } tiene el carácter de control { $code } como carácter { $place }: los textos de un registro son una línea sin caracteres de control
journal-body-empty = { $field } está vacío
journal-body-too-many = { $field } tiene { $count } valores, se admiten como máximo { $most }
journal-body-value = { $field } no puede ser "{ $given }"
journal-body-contradiction = { $field } contradice los campos de los que se deduce
journal-origin-perfect = simulado, una pieza de trabajo sin errores
journal-origin-workpiece = simulado, { $file }, semilla { $seed }
journal-origin-contacts = puntos de palpación de { $file }
journal-check-judged-otherwise = decidido como { $kept }, que sigue valiendo; esta versión de Fitcheck decide { $now }

## Questions
journal-ask-at = { $reason } (carácter { $at })
journal-ask-unknown-key = { $key }: no es una palabra clave conocida; se esperaba { $known }, o comillas en torno a una palabra con dos puntos
journal-ask-no-value = { $key }: no tiene valor
journal-ask-empty-word = una palabra entre comillas está vacía
journal-ask-twice = { $key } se da dos veces
journal-ask-not-closed = unas comillas no están cerradas
journal-ask-after-quote = se esperaba un espacio después de las comillas de cierre, se encontró { $found }
journal-ask-date = "{ $given }" no es un día ni una hora: se esperaba 2026-11-23 o 2026-11-23T14:30
journal-ask-verdict = "{ $given }" no es un dictamen: se esperaba { $known }
journal-ask-callout = { $error }; una cota va entre comillas: callout:"25 H7"
journal-ask-class = { $error }
journal-ask-order = el período termina antes de empezar: from debe ser anterior a to
journal-ask-both-origins = simulated y measured se excluyen
journal-ask-both-kinds = reports y checks se excluyen
journal-ask-too-long = la consulta tiene { $bytes } bytes, se admiten como máximo { $most }

## The journal of a station
store-missing = no hay ningún registro en { $path }
store-not-a-file = { $path } no es un archivo
store-not-a-journal = { $path } no es un registro de Fitcheck; se dejó sin cambios
store-newer = { $path } fue hecho por un Fitcheck más nuevo (versión { $version }, este admite { $known }); se dejó sin cambios
store-older = { $path } fue hecho por un Fitcheck anterior: se actualiza cuando se registra algo en él
store-damaged = { $path } está dañado: sus páginas se contradicen
store-full = no queda espacio para { $path }: no se registró nada
store-read-only = no se puede escribir en { $path }: no se registró nada
store-locked = otro programa ha bloqueado { $path } demasiado tiempo: no se registró nada
store-disk = el disco de { $path } comunica un error: { $reason }
store-cannot-open = { $path } no se puede abrir
store-network-folder = { $path } está en una carpeta de otra máquina, donde dos puestos podrían sobrescribirse las entradas: elija una carpeta de esta máquina, y un servidor para el taller
store-altered = "{ $name }", que protege las entradas contra cambios, falta en { $path } o se modificó
store-no-beginning = { $path } no dice qué cadena es
store-moved = { $path } se movió o se apartó entretanto: no se registró nada
store-other-target = la entrada { $number } no es la que se debía corregir: no se registró nada
store-corrected = la entrada { $number } ya fue corregida o retirada por la entrada { $by }: corrija esta, salvo que sea una retirada
store-is-report = la entrada { $number } es un informe: dice qué archivo se escribió y no se puede corregir ni retirar
store-is-alarm = la entrada { $number } es una alarma de una carta de control: dice qué regla se activó y no se puede corregir ni retirar; respóndala
store-no-alarm = la entrada { $number } no es una alarma de una carta de control: solo se puede responder a una alarma
journal-alarm-since-part = { $rule }, desde la pieza { $serial }
journal-alarm-since-entry = { $rule }, desde el registro { $number }
store-other-journal = la entrada { $number } de este registro no es la que nombra el informe: no se registró nada
store-finding-no-beginning = el registro no tiene una primera entrada que nombre su cadena
store-finding-pages = las páginas del registro se contradicen, y las consultas pueden no hallar entradas que están en él: { $reason }
store-finding-index = un índice para consultas no concuerda con su tabla: { $reason }
store-hidden = la entrada { $number } de { $path } no se encuentra en su lugar: el registro se modificó o su archivo está dañado; ejecute fitcheck journal verify
store-no-entry = { $path } no tiene la entrada { $number }: la última es { $last }
store-backup = la copia de { $path } estaba incompleta y se ha quitado
store-interrupted = detenido
store-database = { $path }: { $reason }
store-remark-begun = se creó un registro nuevo: { $path }
store-remark-set-aside = el registro { $path } estaba dañado: ahora está en { $folder }, sin cambios, y en su lugar se creó uno nuevo
store-remark-migrated = { $path } se actualizó a esta versión; el archivo tal como era es { $copy }
store-remark-behind = { $path } termina con la entrada { $last }, pero tuvo la entrada { $known }: se cortaron sus entradas más recientes, o se repuso una copia anterior
store-remark-other = la entrada { $number } de { $path } difiere de lo que era: el registro se reescribió desde ella o desde una anterior
store-remark-replaced = { $path } no es el registro que estaba allí antes, que tenía { $known } entradas
store-remark-waits = otro programa está escribiendo en { $path }: se espera a que termine
store-remark-no-anchor = la última entrada de este registro no se pudo anotar en { $path }: { $reason }
store-finding-altered = "{ $name }", que protege las entradas contra cambios, falta o se modificó
store-finding-not-found = { $entries ->
        [one] 1 entrada está indexada por algo distinto de lo que dice, o no está indexada
       *[other] { $entries } entradas están indexadas por algo distinto de lo que dicen, o no están indexadas
    }
