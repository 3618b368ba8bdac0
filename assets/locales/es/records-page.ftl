page-records = Registro

## What is recorded with a check
records-page-fold = Registro
records-page-fold-hint = El número de serie y la observación se registran con las próximas comprobaciones
records-page-serial = Número de serie
records-page-serial-short = N.º serie
records-page-remark = Observación
records-page-feature = Elemento
records-page-record = Entrada { $number }
records-page-waiting = Registrando
records-page-not-recorded = No registrado: { $why }
records-page-nowhere = Las comprobaciones no se registran: no hay carpeta de datos para ellas
records-page-off = Las comprobaciones no se registran: el registro está desactivado en el archivo de estado
records-page-opening = Abriendo el registro
records-page-how-on = La sección [records] del archivo de estado, state.toml, da el nombre del archivo de registro y dice si se registran las comprobaciones.
records-page-not-opened = El registro no se puede abrir, y las comprobaciones no se registran: { $why }
records-page-not-kept = { $count ->
    [one] 1 comprobación no está registrada: { $why }
   *[other] { $count } comprobaciones no están registradas: { $why }
}
records-page-refused = { $count ->
    [one] 1 comprobación no se puede registrar: { $why }
   *[other] { $count } comprobaciones no se pueden registrar; el motivo de la primera: { $why }
}
records-page-not-kept-why = el registro no respondió
records-page-no-thread = el sistema no puede iniciar un subproceso para el registro
records-page-interrupted = se interrumpió
records-page-failed = { $count ->
    [one] 1 comprobación no está registrada
   *[other] { $count } comprobaciones no están registradas
}
records-page-try-again = Reintentar
records-page-stay = Las entradas quedan en el registro
records-page-leave = { $count ->
    [one] 1 comprobación aún no está registrada. Se pierde si se cierra la ventana.
   *[other] { $count } comprobaciones aún no están registradas. Se pierden si se cierra la ventana.
}

## Who is measuring
records-page-who = Medido por
records-page-nobody = Nombre…
records-page-who-nobody = No se ha elegido ningún nombre. Elija un nombre
records-page-who-is = Medido por { $name }
records-page-nobody-named = Sin nombre
records-page-new-name = Otro nombre
records-page-take-name = Usar este nombre

## The question
records-page-question = Buscar
records-page-help = Palabras, bueno retrabajo desecho, o part:… serial:… feature:… callout:… class:… verdict:scrap who:… station:… today week from:2026-11-01 to:… measured simulated reports alarms
records-page-more-actions = Más
records-page-today = Hoy
records-page-this-week = Esta semana
records-page-not-good = No buenas
records-page-measured-only = Solo medidas
records-page-filter = Filtro
records-page-filter-hint = Reduce la lista por pieza, número de serie, fecha y más
records-page-add-filter = Añadir filtro
records-page-filter-by = Filtrar por
records-page-filter-value = Valor
records-page-from = Desde
records-page-to = Hasta
records-page-standing = Vigentes
records-page-simulated-only = Solo simuladas
records-page-reports-only = Solo informes
records-page-alarms-only = Solo alarmas
records-page-checks-only = Sin informes
records-page-remove-filter = Quitar el filtro { $filter }
records-page-looking = Buscando
records-page-count = { $many ->
    [one] 1 entrada
   *[other] { $count } entradas
}
records-page-more = { $count }+ entradas
records-page-unread = El registro no se puede leer: { $why }
records-page-none = no hay ningún registro abierto
records-page-missing = Falta la entrada { $number }
records-page-empty = Aquí aparecen las comprobaciones una vez registradas
records-page-none-found = Ninguna entrada coincide

## The list
records-page-list = Entradas
records-page-head-number = N.º
records-page-zone = En la zona
records-page-move = Ir a otra entrada
records-page-open = Abrir la entrada
records-page-choose = Elegir para un informe
records-page-choose-record = Elegir la entrada { $number } para un informe
records-page-chosen = { $count ->
    [one] 1 elegida
   *[other] { $count } elegidas
}
records-page-copy = Copiar
records-page-report-of = Informe de { $count }…
records-page-reports-listed = El informe abarca todas las entradas mostradas: { $count }
records-page-reports-chosen = El informe abarca las entradas elegidas: { $count }
records-page-too-many = Se muestran { $count } entradas. Un informe o una selección admite { $most } como máximo: reduzca la lista, por ejemplo por pieza o fecha
records-page-still-looking = La lista aún no está completa. Inténtelo de nuevo cuando se muestre el recuento
records-page-nothing-to-report = Ninguna entrada mostrada puede ir en un informe: están anuladas, son simuladas o de ciclos
records-page-report = Informe…
records-page-with-simulated = Con comprobaciones simuladas
records-page-with-simulated-hint = Las comprobaciones simuladas no son evidencia; el informe indica que contiene algunas
records-page-report-simulated = { $count ->
    [one] 1 de estas comprobaciones es simulada: no es evidencia
   *[other] { $count } de estas comprobaciones son simuladas: no son evidencia
}
records-page-report-from = Del registro { $chain }, entradas { $numbers }; su entrada más reciente es { $number } ({ $hash })
records-page-out-simulated = { $count ->
    [one] 1 comprobación simulada queda fuera
   *[other] { $count } comprobaciones simuladas quedan fuera
}
records-page-out-replaced = { $count ->
    [one] 1 entrada corregida o retirada queda fuera
   *[other] { $count } entradas corregidas o retiradas quedan fuera
}
records-page-report-corrects = { $count ->
    [one] 1 valor sustituye a una entrada corregida
   *[other] { $count } valores sustituyen a entradas corregidas
}
records-page-out-cycles = { $count ->
    [one] 1 entrada de un ciclo queda fuera
   *[other] { $count } entradas de ciclos quedan fuera
}
records-page-out-reports = { $count ->
    [one] 1 informe o alarma queda fuera: no es una comprobación
   *[other] { $count } informes y alarmas quedan fuera: no son comprobaciones
}
records-page-out-unread = { $count ->
    [one] 1 entrada ilegible queda fuera
   *[other] { $count } entradas ilegibles quedan fuera
}
records-page-see = Anulada, ver { $number }
records-page-void = Entrada { $number }, anulada: ver { $by }
records-page-instead = en vez de { $number }
records-page-takes-back = Retira { $number }
records-page-withdrawal = Retirada
records-page-report-entry = Informe
records-page-alarm = Alarma
records-page-alarm-answers = Respuesta a la alarma { $number }
records-page-alarm-answered = Alarma, respuesta { $number }
records-page-alarm-first = Primer valor: { $number }
records-page-alarm-last = Valor en el que se activó la regla: { $number }
records-page-cycle = Ciclo { $cycle }
records-page-went-back = { $time } (reloj)

## An open record
records-page-close = Volver a la lista
records-page-reading = Leyendo la entrada
records-page-measure-again = Remedir
records-page-measure-again-hint = Lleva cota, pieza, número de serie y regla a la página de comprobación
records-page-correct = Corregir…
records-page-correct-hint = Añade una entrada en lugar de esta; ambas se conservan
records-page-simulated = Simulada: nadie ha medido esto
records-page-corrected-by = Corregida o retirada por la entrada { $number }
records-page-corrects = En lugar de la entrada { $number }
records-page-in-report = En el informe { $number }, { $name }
records-page-reports-unread = Los informes con esta comprobación no se pueden leer: { $why }
records-page-report-unknown = { $name } está escrito, pero el registro no lo conoce: { $why }
records-page-callout = { $feature ->
    [hole] { $callout }, agujero
    [neither] { $callout }, ni agujero ni eje
   *[shaft] { $callout }, eje
}
records-page-distance = A los límites
records-page-importer = Importado por
records-page-void-why = Anulada porque
records-page-void-by = Corregida o retirada por
records-page-decided = Decisión
records-page-limits = Límites
records-page-source = Límites según
records-page-contacts = Puntos
records-page-rule = Regla
records-page-station = Puesto
records-page-time = { $time } ({ $offset } { $zone })
records-page-clock = El reloj del puesto se atrasó antes de esta entrada
records-page-cycle-number = Ciclo
records-page-program = Programa
records-page-block = { $program }, línea { $line }
records-page-datum = Punto de referencia
records-page-datum-set = X { $x }, Y { $y }, Z { $z } mm, fijado en la línea { $line }: { $block }
records-page-datum-at = X { $x }, Y { $y }, Z { $z } mm
records-page-datum-rotation = ejes girados { $angle }°, desde la línea { $line }: { $block }
records-page-datum-tilt = plano inclinado A { $a }°, B { $b }°, C { $c }°, desde la línea { $line }: { $block }
records-page-parameters = Parámetros
records-page-figures = Resultados
records-page-file-measurements = Mediciones
records-page-file-program = Programa
records-page-file-workpiece = Pieza de trabajo
records-page-file-budget = Balance de incertidumbre
records-page-report-file = Archivo
records-page-report-format = Formato
records-page-report-size = Tamaño
records-page-report-bytes = { $count } bytes
records-page-report-title = Título
records-page-report-sha256 = SHA-256
records-page-report-checks = Comprobaciones registradas
records-page-report-numbers = Sus entradas
records-page-report-unrecorded = Comprobaciones sin entrada
records-page-report-head = Entrada más reciente entonces
records-page-chain = Cadena
records-page-chain-name = Registro
records-page-hash = Hash

## A correction
records-page-correction = Corregir la entrada { $number }
records-page-correction-rule = Evaluado de nuevo como la entrada { $number }: { $rule }.
records-page-correction-temperature = Corregido de { $temperature } °C a 20 °C.
records-page-correction-rest = Pieza, número de serie, nombre
records-page-correction-hint = Una entrada nueva ocupa el lugar de esta. Ambas quedan en el registro.
records-page-corrector = Corregido por
records-page-reason = Motivo
records-page-reason-mistyped = mal escrito
records-page-reason-wrong-part = pieza equivocada
records-page-reason-trial = ensayo
records-page-withdrawal-hint = La entrada deja de contar y nada ocupa su lugar. Ambas entradas quedan en el registro.
records-page-withdraw = Retirar la entrada
records-page-withdraw-hint = Nada ocupa su lugar
records-page-withdraw-neither = La entrada { $number }, corregida por esta, no vuelve a contar
records-page-send-correction = Registrar la corrección
records-page-leave-correction = Cancelar
records-page-undo-void = No deshecho: la entrada se retiró después de la corrección
records-page-undone-reason = deshecho
records-page-taken-back = { $checks ->
    [one] 1 comprobación deshecha
   *[other] { $checks } comprobaciones deshechas
}; { $records ->
    [one] la entrada { $numbers } queda retirada
   *[other] las entradas { $numbers } quedan retiradas
}
records-page-taken-back-unwritten = { $checks ->
    [one] 1 comprobación deshecha; aún no estaba registrada y no lo estará
   *[other] { $checks } comprobaciones deshechas; aún no estaban registradas y no lo estarán
}
records-page-not-withdrawn = { $records ->
    [one] La entrada { $numbers } sigue contando y no se pudo retirar: { $why }
   *[other] Las entradas { $numbers } siguen contando y no se pudieron retirar: { $why }
}
records-page-undone = Corrección deshecha
records-page-no-reason = Una corrección necesita un motivo
records-page-nothing-changed = Nada es diferente: cambie un campo o retire la entrada
records-page-not-open = La entrada no está abierta
records-page-not-recording = Las comprobaciones no se registran

## The journal
records-page-place = { $file } · entradas: { $entries }
records-page-unsent = { $count } sin enviar a { $server }
records-page-all-sent = todo enviado a { $server }
records-page-server-unknown = aún no se ha alcanzado { $server }
records-page-server = Servidor del taller
records-page-server-hint = Envía cada entrada a un servidor PostgreSQL, en segundo plano; sin él todo queda en este ordenador
records-page-server-address = Dirección, como postgres://mill3@shop.example/checks
records-page-server-passwords = La contraseña viene de la dirección, PGPASSWORD, el archivo de contraseñas o el llavero del sistema. Una contraseña en la dirección pasa al llavero y no se guarda en ningún otro sitio.
records-page-take-server = Usar este servidor
records-page-leave-server = Dejar de enviar
records-page-send-again = Enviar de nuevo
records-page-not-sent = No enviado: { $why }
records-page-and = { $one }; { $other }
records-page-no-shop = este Fitcheck se compiló sin soporte para un servidor del taller (feature shop)
records-page-in-keyring = La contraseña de { $server } está ahora en el llavero del sistema
records-page-not-in-keyring = La contraseña de { $server } no se pudo guardar en el llavero del sistema ({ $reason }): se usa hasta que se cierre la ventana, y después debe venir de PGPASSWORD o del archivo de contraseñas
records-page-verify = Verificar
records-page-verify-hint = Verifica cada entrada con la anterior
records-page-verify-cancel = Cancelar la verificación
records-page-verify-cancelled = Verificación cancelada
records-page-verify-progress = Progreso de la verificación
records-page-verifying = entradas: { $done } de { $of }
records-page-whole = { $time }: entradas verificadas: { $entries }, hasta la { $number } ({ $hash })
records-page-broken = { $time }: entradas verificadas: { $entries }; el registro no está como se escribió
records-page-not-verified = { $time }: no verificado: { $why }
records-page-no-anchors = las entradas que se conocen en otro lugar no se pueden leer: { $why }
