# The walk through a part, and the watched folder, on the parts page.

walk-page-begin = Empezar pieza
walk-page-count-up = Número siguiente
walk-page-take = Evaluar
walk-page-take-meant = Usar { $meant } mm
walk-page-it-is-so = Es así: evaluar { $measured } mm
walk-page-measure-anew = Descartar y volver a medir
walk-page-confirmed = confirmado al medir: es así
walk-page-alarms = Alarmas abiertas: { $count }
walk-page-alarms-short = Alarmas
walk-page-alarms-more = Más alarmas: { $count }
walk-page-alarm = { $name }: { $said }
walk-page-alarm-ask = Responder a la alarma
walk-page-alarm-ask-of = Responder a la alarma de { $name }
walk-page-alarm-answer = Registrar respuesta
walk-page-alarm-later = Más tarde
walk-page-alarm-cause = Causa
walk-page-alarm-action = Medida tomada
walk-page-alarm-causes = Desgaste de la herramienta; Herramienta nueva; Corrección de la herramienta; Sujeción; Virutas o suciedad; Temperatura; Material; Error de medición; Desconocida
walk-page-alarm-actions = Herramienta cambiada; Corrección ajustada; Pieza sujetada de nuevo; Máquina limpiada; Medido de nuevo; Preparador avisado; En observación; Ninguna necesaria
walk-page-alarm-empty = escriba un texto o elija uno de la lista
walk-page-alarms-unread = No se pueden comprobar las reglas de las cartas de control: { $why }
walk-page-alarms-unchecked = No se pueden comprobar las reglas de las cartas de control, { $name }: { $why }
walk-page-alarm-unrecorded = No se puede registrar la alarma de la carta de control: { $why }
walk-page-simulate = Simular
walk-page-simulate-hint = Ejecuta el ciclo del elemento en una pieza perfecta; nadie mide el valor, y queda marcado como simulado
walk-page-again = Remedir
walk-page-skip = Omitir
walk-page-skip-for = Omitir por este motivo
walk-page-skip-not = No omitir
walk-page-next = Pieza siguiente
walk-page-move = Ir a otra cota
walk-page-import = Importar valores…
walk-page-watch = Vigilar carpeta…
walk-page-watch-hint = Los archivos que llegan a la carpeta se evalúan según el plan y se registran, cada uno una vez
walk-page-watch-stop = Dejar de vigilar
walk-page-dialog-watch = Vigilar carpeta
walk-page-begin-warned = { $count ->
    [one] 1 cota de esta pieza no tiene ni valor ni motivo. Otra pulsación termina esta pieza.
   *[other] { $count } cotas de esta pieza no tienen ni valor ni motivo. Otra pulsación termina esta pieza.
}
walk-page-no-plan = Aún no hay plan: abra uno o créelo en la vista Plan.
walk-page-plan-wrong = { $count ->
        [one] El plan tiene un error: véase la vista Plan.
       *[other] El plan tiene { $count } errores: véase la vista Plan.
    }
walk-page-not-saved = El plan tiene cambios sin guardar: una pieza interrumpida no se puede restaurar tras un reinicio.
walk-page-serial = Número de serie
walk-page-serial-again = El número de serie { $serial } ya se ha medido. Pulse Intro otra vez, tras medio segundo, para empezarlo de nuevo.
walk-page-serial-hint = Escríbalo, escanéelo o use el número siguiente; Intro empieza la pieza.
walk-page-recent = Planes recientes
walk-page-done = Todas las cotas tienen valor o están omitidas
walk-page-part = { $part }, número de serie { $serial }
walk-page-part-serial = Número de serie { $serial }
walk-page-part-no-serial = { $part }, sin número de serie
walk-page-other-plan = El plan ha cambiado desde entonces: los cambios valen a partir de la pieza siguiente.
walk-page-part-of = Esta pieza se mide según { $own }
walk-page-open-is = Abierto ahora: { $open }
walk-page-begin-by = Empezar una pieza según { $open }
walk-page-keep-on = Seguir midiendo esta pieza
walk-page-unfinished = Una pieza medida según { $own } no está terminada. Medir pregunta si se continúa con ella.
walk-page-place = X { $x }  Y { $y }  Z { $z }
walk-page-no-place = Sin ubicación en el plan
walk-page-value = Valor medido
walk-page-measured-before = { $count ->
        [one] Medido una vez: se conservan ambos valores, y se usa el nuevo
       *[other] Medido { $count } veces: se conservan todos los valores, y se usa el nuevo
    }
walk-page-last-counts = Medido { $count } veces: se conservan todos los valores, y se usa este
walk-page-skip-why = Motivo para omitir
walk-page-skip-access = Sin acceso para el palpador
walk-page-skip-gauge = Falta el aparato
walk-page-skip-machined = Aún sin mecanizar
walk-page-skip-elsewhere = Medido en otro lugar
walk-page-reason = Otro motivo
walk-page-no-reason = hace falta un motivo
walk-page-skipped = omitido: { $reason }
walk-page-next-warned = { $count ->
        [one] Una cota no tiene ni valor ni motivo. Elija otra vez Pieza siguiente para terminar esta pieza.
       *[other] { $count } cotas no tienen ni valor ni motivo. Elija otra vez Pieza siguiente para terminar esta pieza.
    }
walk-page-typed-elsewhere = el valor se escribió para { $name }, y ahora se pide { $asked }: escríbalo de nuevo
walk-page-next-size = Siguiente: { $name }, { $asked }
walk-page-is-serial = { $given } parece un número de serie y no se toma como valor: termine antes esta pieza y escanéelo después para la siguiente. Si es el valor medido, escríbalo con más decimales
walk-page-simulate-measured = { $name } está medido: un valor simulado nunca ocupa el lugar de uno medido
walk-page-part-status = Estado de la pieza
walk-page-not-complete = Aún sin dictamen
walk-page-simulated = { $count ->
        [one] Un valor es simulado: nadie lo midió, así que no puede hacer buena la pieza.
       *[other] { $count } valores son simulados: nadie los midió, así que no pueden hacer buena la pieza.
    }
walk-page-missing = Faltan: { $names }
walk-page-off = El registro está desactivado: una pieza interrumpida no se puede restaurar tras un reinicio.
walk-page-nowhere = No se registra nada: una pieza interrumpida no se puede restaurar tras un reinicio.
walk-page-no-part = No se está midiendo ninguna pieza.
walk-page-sizes = Cotas de la pieza
walk-page-open = pendiente
walk-page-row-simulated = simulado
walk-page-times = { $count } valores
walk-page-rule-plan = Evaluado según la regla del plan: { $rule }
walk-page-rule-own = El plan no tiene regla; evaluado según la regla de la página de comprobación: { $rule }
walk-page-nothing-asked = no se está midiendo ninguna cota del plan
walk-page-refused = { $count ->
        [one] Una comprobación no se registró: { $why }
       *[other] { $count } comprobaciones no se registraron: { $why }
    }
walk-page-import-late = { $name } se leyó después de terminar la pieza: sus valores no se usan
walk-page-imported = { $name }: { $good } importados, { $bad } no
walk-page-file-for-check = Nada del archivo es de este plan. La página Comprobación puede evaluarlo por lo que él mismo pide
walk-page-found-by-name = { $count ->
    [one] Asignada por nombre: 1 fila
   *[other] Asignadas por nombre: { $count } filas
}
walk-page-found-by-number = Asignadas solo por número, con sus líneas: { $rows }
walk-page-found-by-place = Asignadas por ubicación, con sus líneas: { $rows }
walk-page-other-parts = Los valores de otras piezas se registran con sus propios números de serie: { $serials }
walk-page-label = El archivo no tiene números de serie y llama a la pieza { $part }: sus valores se toman para esta pieza
walk-page-other-label = de la pieza { $part }, y sin número de serie no se sabe si es esta pieza
walk-page-remark-label = Pieza en el archivo: { $part }
walk-page-not-judged = línea { $line }: { $why }
walk-page-no-journal = La pieza { $serial } se restauró sin sus valores: no hay registro del que restaurarlos
walk-page-gone = Algunas cotas ya no están en el plan: sus valores medidos quedan en el registro
walk-page-gone-name = { $name }
walk-page-changed = El plan ha cambiado: los valores evaluados con otros límites u otra regla, y los de filas sin nombre, quedan en el registro, y sus cotas vuelven a estar pendientes
walk-page-changed-size = { $name }: { $measured } mm se midió según { $asked }
walk-page-given-up = La pieza interrumpida { $serial } no se restaura, porque se ha empezado otra pieza: sus valores quedan en el registro
walk-page-ended = No usado para la pieza { $serial }, que está terminada
walk-page-ended-size = { $name }: { $reason }
walk-page-taken-back = Un valor de { $name } se corrigió o retiró en el registro: ya no vale para esta pieza
walk-page-put-right = Un valor de { $name } se corrigió en el registro: el corregido vale para esta pieza
walk-page-no-folder = { $path } no es una carpeta
walk-page-not-read = Los valores de la pieza interrumpida no se pudieron leer: { $why }
walk-page-came-back = { $count ->
        [one] La pieza interrumpida { $serial } se restauró con un valor
       *[other] La pieza interrumpida { $serial } se restauró con { $count } valores
    }
walk-page-watched = Carpeta vigilada
walk-page-part-waits = La pieza { $serial } se restaurará cuando su plan no tenga errores
walk-page-watch-waits = La carpeta { $path } se volverá a vigilar cuando el plan no tenga errores
walk-page-watch-no-plan = vigilar una carpeta requiere un plan sin errores: abra uno antes
walk-page-watch-no-journal = el registro no se puede abrir: no se sabe qué archivos se importaron antes, así que no se vigila ninguna carpeta
walk-page-watch-begins = Buscando en el registro archivos importados antes
walk-page-known = { $count ->
        [0] El registro no tiene archivos importados antes
        [one] El registro tiene un archivo importado antes, de cualquier carpeta: no se importa de nuevo
       *[other] El registro tiene { $count } archivos y partes de archivos importados antes, de cualquier carpeta: no se importan de nuevo
    }
walk-page-mask = La salida de FN 16 se vuelve a leer con la máscara { $name }
walk-page-watch-recording = Registrando
walk-page-waiting = { $name }: { $why }
walk-page-watch-count = { $count ->
        [one] Un archivo importado
       *[other] { $count } archivos importados
    }
walk-page-report = Informe…
walk-page-report-people = Informe de inspección ({ $format })…
walk-page-report-programs = Valores de la pieza como { $format }…
walk-page-contradicted = { $names }: los valores se contradicen, y nada dice cuál es correcto. Cuenta el peor hasta que se remida o se elija.
walk-page-contradicting = { $name } tiene valores que se contradicen: { $values }. Cuenta el peor hasta que se remida o se elija.
walk-page-count-newest = Cuenta el último valor
walk-page-newest-counts = { $name }: cuenta el último valor, según lo elegido
walk-page-accepted = Aceptado fuera de los límites: { $names }
walk-page-because = Debido a { $names }
walk-page-left-out = Omitido: { $names }. Una pieza con cotas omitidas no puede ser buena.
walk-page-whole = La pieza entera
walk-page-whole-serial = La pieza { $serial }
walk-page-strip-open = La pieza: aún sin dictamen
walk-page-strip-part = La pieza: { $status }
walk-page-strip-size = { $name }: { $value } mm, { $status }
walk-page-by-plan = Medido según el plan { $name }
walk-page-judged-by-plan = Evaluado según el plan { $name }
walk-page-watch-no-mask = La máscara propia { $path } no se puede leer: la carpeta se vigilará cuando se elija de nuevo esta máscara u otra (Menú, Máscara propia…)
walk-page-watch-nobody = { $count ->
        [one] Un valor se registra sin número de serie: su archivo no da ninguno, y no se está midiendo ninguna pieza según este plan
       *[other] { $count } valores se registran sin número de serie: su archivo no da ninguno, y no se está midiendo ninguna pieza según este plan
    }
walk-page-watch-other-plan = La carpeta se evalúa según el plan tal como era al empezar la vigilancia. Empiece una pieza, o vigile de nuevo la carpeta, para evaluar según el plan actual.
walk-page-watch-not-saved = El plan tiene cambios sin guardar: la carpeta no se vuelve a vigilar tras un reinicio.
walk-page-values = Valores de { $name }
walk-page-to-do = { $name }: { $what }
walk-page-of = cota { $at } de { $count }
walk-page-no-serial = Sin número de serie
