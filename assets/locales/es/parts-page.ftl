page-parts = Piezas
parts-page-walk = Medir
parts-page-plan = Plan
parts-page-new = Plan nuevo
parts-page-open = Abrir plan…
parts-page-save = Guardar plan…
parts-page-save-csv = Guardar plan como CSV…
parts-page-undo = Deshacer
parts-page-redo = Rehacer
parts-page-dialog-open = Abrir un plan de pieza
parts-page-dialog-save = Guardar el plan de pieza
parts-page-not-saved = { $name }, sin guardar
parts-page-no-plan = Aún no hay plan: abra uno o créelo.
parts-page-move = Ir a otra celda
parts-page-extend = Ampliar la selección
parts-page-edit = Editar celda
parts-page-take = Listo
parts-page-empty = Vaciar celdas
parts-page-copy = Copiar celdas
parts-page-paste = Pegar
parts-page-insert = Insertar fila
parts-page-delete = Eliminar filas
parts-page-up = Subir
parts-page-down = Bajar
parts-page-sort = Ordenar
parts-page-sort-hint = Ordena por la columna de la celda actual, A2 antes que A10; otra vez invierte el orden
parts-page-renumber = Renumerar
parts-page-renumber-hint = Numera los elementos desde 1 en el orden de las filas
parts-page-all-columns = Todas las columnas
parts-page-previous = Error anterior
parts-page-next = Error siguiente
parts-page-choose-picture = Elegir imagen…
parts-page-dialog-picture = Elegir la imagen de la pieza
parts-page-table = Elementos del plan
parts-page-cell-name = Celda del plan
parts-page-cell = Fila { $row }, { $column }, { $text }
parts-page-cell-empty = Fila { $row }, { $column }, vacía
parts-page-cell-wrong = { $cell }, error: { $what }
parts-page-new-row = nueva
parts-page-limits = Límites
parts-page-editing = { $column } de la fila { $row }
parts-page-head = Pieza
parts-page-words = Uno de: { $words }
parts-page-no-fault = Sin errores en el plan
parts-page-blank = Escriba el primer elemento, o pegue filas de una hoja de cálculo
parts-page-faults = { $count ->
    [one] Un error
   *[other] { $count } errores
}
parts-page-features = { $count ->
    [one] Un elemento
   *[other] { $count } elementos
}
parts-page-fault-of = { $row }, { $column }
parts-page-fault-row = Fila { $row }
parts-page-fault-plan = Plan
parts-page-lost = No se entiende en el archivo: el plan no mide ni guarda nada hasta que esto se corrija en el archivo o se deje fuera aquí
parts-page-take-meant = Usar { $meant }
parts-page-leave-out = Dejarlo fuera
parts-page-leave-out-hint = El plan tiene entonces solo lo que se pudo leer; lo no entendido puede ser un elemento
parts-page-left-out = { $count ->
    [one] { $name }: un dato no entendido queda fuera del plan; el archivo lo conserva hasta que se guarde el plan
   *[other] { $name }: { $count } datos no entendidos quedan fuera del plan; el archivo los conserva hasta que se guarde el plan
}
parts-page-pasted-rows = { $count ->
    [one] Se omitió una fila pegada: un plan tiene como máximo { $most } elementos
   *[other] Se omitieron { $count } filas pegadas: un plan tiene como máximo { $most } elementos
}
parts-page-pasted-columns = { $count ->
    [one] Se omitió una columna pegada: no hay más columnas a la derecha. «Todas las columnas» muestra más
   *[other] Se omitieron { $count } columnas pegadas: no hay más columnas a la derecha. «Todas las columnas» muestra más
}
parts-page-column-number = N.º
parts-page-column-name = Nombre
parts-page-column-kind = Tipo
parts-page-column-axis = Eje coord.
parts-page-column-callout = Cota
parts-page-column-callout2 = Cota Y
parts-page-column-feature = Agujero o eje
parts-page-column-x = X
parts-page-column-y = Y
parts-page-column-z = Z
parts-page-column-angle = Ángulo
parts-page-column-clearance = Dist. segur.
parts-page-column-clearance-height = Alt. segur.
parts-page-column-cycle = Ciclo
parts-page-column-parameters = Parámetros
parts-page-column-material = Material
parts-page-column-rule = Regla
parts-page-column-u-um = u (µm)
parts-page-column-plausible = Posible
parts-page-column-plausible2 = Posible Y
parts-page-column-remark = Observación
parts-page-column-balloon-x = Globo X
parts-page-column-balloon-y = Globo Y
parts-page-head-part = Pieza
parts-page-head-drawing = Plano
parts-page-head-picture = Imagen
parts-page-head-material = Material
parts-page-head-rule = Regla
parts-page-head-u-um = u (µm)
parts-page-head-travel-x = Recorrido X (mm)
parts-page-head-travel-y = Recorrido Y (mm)
parts-page-head-travel-z = Recorrido Z (mm)
parts-page-head-remark = Observación
parts-page-head-file = archivo junto al plan
parts-page-head-two = mín máx
parts-page-picture = Imagen de la pieza
parts-page-picture-said = Imagen de la pieza, { $on } de { $count } globos colocados
parts-page-picture-none = Sin imagen
parts-page-picture-awaited = Leyendo la imagen
parts-page-picture-folder = { $given } no es el nombre de un archivo junto al plan: la imagen debe estar en la carpeta del plan, así que indique su nombre sin carpeta
parts-page-picture-unsaved = Guarde antes el plan: la imagen debe estar en la misma carpeta
parts-page-picture-elsewhere = { $given } no está en la carpeta del plan: cópielo antes allí, para que ambos sigan juntos
parts-page-picture-large = { $name } tiene { $given } KiB; una imagen tiene como máximo { $most } KiB
parts-page-picture-dots = { $name } tiene { $width } × { $height } píxeles; una imagen tiene como máximo { $most } millones de píxeles
parts-page-picture-kind = { $name } no es una imagen PNG, JPEG o SVG
parts-page-picture-broken = { $name } no se puede leer como imagen: { $reason }
parts-page-balloon = Globo { $label }, { $name }, { $status }
parts-page-balloon-next = { $balloon }, siguiente
parts-page-balloon-beside = { $balloon }, no está en la imagen
parts-page-balloon-open = sin medir
parts-page-balloon-skipped = omitido
parts-page-beside = Aún no en la imagen: arrástrelos a ella
parts-page-beside-more = y { $count } más
parts-page-balloon-simulated = { $status }, simulado
parts-page-more = Filas y celdas
parts-page-picture-heavy = { $name } tardaría demasiado en dibujarse: tiene filtros, motivos grandes o demasiadas capas; quítelos, o guarde la imagen como PNG
parts-page-csv-copy = El archivo es una copia: CSV tiene solo los elementos, y { $keys } de la pieza queda fuera
parts-page-opened = { $count ->
    [one] { $name } está abierto, pero el plan deja fuera un dato que el archivo tiene
   *[other] { $name } está abierto, pero el plan deja fuera { $count } datos que el archivo tiene
}
parts-page-pasted-twice = Una columna pegada quedó fuera: la primera fila nombra { $keys } más de una vez, y se usa la primera columna con ese nombre
parts-page-pasted-unknown = Quedaron fuera columnas pegadas que un plan no tiene: { $names }
parts-page-pasted-nameless = { $count ->
    [one] Una columna pegada quedó fuera: la primera fila no tiene nombre sobre ella
   *[other] { $count } columnas pegadas quedaron fuera: la primera fila no tiene nombres sobre ellas
}
parts-page-comments = { $count ->
    [one] Al guardar se quita un comentario del archivo
   *[other] Al guardar se quitan { $count } comentarios del archivo
}
parts-page-comments-lost = { $count ->
    [one] Se quitó un comentario de { $name }: un plan se escribe sin comentarios
   *[other] Se quitaron { $count } comentarios de { $name }: un plan se escribe sin comentarios
}
