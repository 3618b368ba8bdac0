page-budget = Incertidumbre
page-budget-also = Balance

budget-page-text = Balance como TOML
budget-page-none = Cree un balance nuevo o abra uno
budget-page-new = Balance nuevo
budget-page-open = Abrir balance…
budget-page-save = Guardar balance como…
budget-page-dialog-open = Abrir un balance
budget-page-dialog-save = Guardar el balance
budget-page-dialog-readings = Lecturas de la pieza patrón
budget-page-not-saved = { $name }, sin guardar

budget-page-for = Calculado para
budget-page-size = Medida de la pieza
budget-page-contacts = Puntos
budget-page-touches = Número de puntos
budget-page-step = Paso
budget-page-contacts-hint = Vacío: los puntos del balance
budget-page-day = Día
budget-page-day-hint = Día vacío: hoy, { $day }
budget-page-no-day = { $given } no es un día: se esperaba YYYY-MM-DD
budget-page-other-missing = Falta un dato: indique el número de puntos y el paso, o ninguno de los dos
budget-page-take-check = De la comprobación mostrada
budget-page-take-recorded = Puntos grabados
budget-page-own-contacts = Del balance
budget-page-of-check = { $count } puntos de palpación de la comprobación { $what }, { $time }
budget-page-of-simulated-check = { $count } puntos de palpación de la comprobación { $what }, { $time }, simulada
budget-page-of-recorded = { $count } puntos de palpación grabados de { $name }
budget-page-contacts-used = { $count } puntos de palpación, factor { $factor }
budget-page-contacts-stepped = { $count } puntos de palpación a { $step }°, factor { $factor }
budget-page-no-circle = Los puntos de palpación no se usan: { $problem }

budget-page-readings = Lecturas
budget-page-open-readings = De un archivo…
budget-page-take-readings = Del historial
budget-page-own-readings = Del balance
budget-page-readings-own = { $count ->
        [one] una lectura en el balance
       *[other] { $count } lecturas en el balance
    }
budget-page-readings-of-file = { $count ->
        [one] una lectura de { $name }
       *[other] { $count } lecturas de { $name }
    }
budget-page-readings-of-history = { $count ->
        [one] una lectura: la comprobación del historial
       *[other] { $count } lecturas: todas las comprobaciones del historial
    }
budget-page-readings-of-chosen = { $count ->
        [one] una lectura: la comprobación elegida del historial
       *[other] { $count } lecturas: las comprobaciones elegidas del historial
    }
budget-page-readings-are-shafts = { $count ->
        [one] una comprobación de un eje no se usa
       *[other] { $count } comprobaciones de ejes no se usan
    }: la pieza patrón es un agujero
budget-page-readings-are-holes = { $count ->
        [one] una comprobación de un agujero no se usa
       *[other] { $count } comprobaciones de agujeros no se usan
    }: la pieza patrón es un eje
budget-page-readings-simulated = { $count ->
        [one] una lectura es simulada
       *[other] { $count } lecturas son simuladas
    }: no se midió nada
budget-page-more-notes = { $count ->
        [one] y una más
       *[other] y { $count } más
    }

budget-page-answer = Incertidumbre expandida
budget-page-no-answer = Sin resultado
budget-page-expanded = U = { $um } µm
budget-page-covered = k = { $k } para 95,45 %
budget-page-at-size = Para { $size } mm; cada comprobación tiene la incertidumbre de su propia medida
budget-page-covered-by = k = { $k } según { $method }
budget-page-standard = u = { $um } µm
budget-page-degrees = Grados efectivos de libertad { $degrees }
budget-page-infinite = infinitos
budget-page-valid = Válido hasta el { $until }
budget-page-expired = CADUCADO
budget-page-expired-on = válido hasta el { $until }, a { $day }
budget-page-not-yet = AÚN NO VÁLIDO
budget-page-not-yet-on = válido desde el { $date }
budget-page-made = Creado el { $date } por { $by }
budget-page-method = Método { $method }
budget-page-method-gum = JCGM 100 (GUM)
budget-page-largest = Mayor contribución
budget-page-largest-is = { $name }, { $percent } % de la varianza
budget-page-help = Qué ayudaría más
budget-page-help-halved = La mitad: u = { $u } µm
budget-page-help-part-temperature = La mitad de la incertidumbre de la temperatura de la pieza: u = { $u } µm
budget-page-help-scale-temperature = La mitad de la incertidumbre de la temperatura de las escalas: u = { $u } µm
budget-page-help-expansion = La mitad de la diferencia con 20 °C, o la mitad de la incertidumbre de la dilatación: u = { $u } µm
budget-page-help-full-circle = { $count } puntos de palpación repartidos por igual en todo el círculo: u = { $u } µm
budget-page-help-more-touches = { $count } puntos de palpación repartidos por igual en todo el círculo: u = { $u } µm

budget-page-checks = Comprobaciones
budget-page-use = Usar en comprobaciones
budget-page-leave = Dejar de usar
budget-page-uses-none = Las comprobaciones no usan ningún balance
budget-page-uses-this = En uso: { $name }
budget-page-uses-another = En uso: { $name } de { $file }, que difiere de lo que se muestra aquí
budget-page-uses-typed = «{ $name }» no cuenta: las comprobaciones usan la incertidumbre elegida en Comprobación
budget-page-uses-no-rule = «{ $name }» está elegido, pero ninguna regla de Comprobación usa aún una incertidumbre: elija allí la regla
budget-page-used-before = Hasta ahora, las comprobaciones usaban la incertidumbre escrita ({ $uncertainty }). «Dejar de usar» la recupera
budget-page-used = Las comprobaciones usan el balance { $name }
budget-page-used-no-rule = «{ $name }» aún no cambia ningún dictamen: la regla de Comprobación es «{ $rule }», que no usa incertidumbre. Elija otra regla
budget-page-not-kept = Guarde el balance para seguir usándolo tras un reinicio
budget-page-readings-not-kept = Las lecturas no están en el archivo del balance: tras un reinicio, el balance deja de usarse
budget-page-used-unread = { $path }: el balance en uso para las comprobaciones no se puede leer, así que no usan ningún balance: { $problem }

budget-page-table = Contribuciones
budget-page-column-name = Nombre
budget-page-column-type = Tipo
budget-page-column-law = Distrib.
budget-page-column-sensitivity = c
budget-page-column-share = Parte
budget-page-row = { $name }, tipo { $type }, { $law }, u { $u } { $unit }, sensibilidad { $sensitivity }, contribución { $um } µm, parte { $percent } %, grados de libertad { $degrees }
budget-page-law-normal = normal
budget-page-law-rectangular = rectangular
budget-page-law-u-shaped = en U
budget-page-law-triangular = triangular
budget-page-shares = Partes de la varianza
budget-page-terms = Términos e incertidumbre expandida
budget-page-mean = Media de las lecturas { $mm } mm
budget-page-percent = { $percent } %
budget-page-um = { $um } µm
budget-page-edition-2011 = U, 2011, corregido
budget-page-edition-2004 = U, 2004, sin corregir
budget-page-nothing-seen = La tabla y las partes aparecen cuando el balance se puede calcular
budget-page-named = { $name }
budget-page-placeholders = Las comprobaciones aún no pueden usar este balance. Estos datos son todavía los de la plantilla: { $what }. Escriba los propios en sus campos
budget-page-placeholder-name = su nombre («{ $name }»)
budget-page-placeholder-by = quién lo creó («{ $by }»)
budget-page-placeholder-figures = las cifras de todas las contribuciones

## The budget as a table

budget-show-table = Tabla
budget-show-text = Texto
budget-rows = Contribuciones
budget-head-name = Nombre del balance
budget-head-by = Creado por
budget-row-new = Contribución nueva
budget-row-add = Añadir contribución
budget-row-remove = Quitar contribución
budget-row-removed = Contribución «{ $name }» quitada del balance
budget-row-comments-removed = Se han perdido los comentarios que estaban junto a las claves quitadas
budget-row-said = { $value } { $unit }, divisor { $divisor }, { $law }
budget-row-unread = incompleta
budget-row-name = Nombre
budget-row-k = Factor de cobertura k
budget-row-alpha = Dilatación, 1/K
budget-row-delta = Diferencia con 20 °C
budget-row-touches = Puntos propios
budget-row-step = Paso propio
budget-row-sensitivity = Sensibilidad c
budget-row-freedom = Grados de libertad
budget-row-freedom-a = Grados de libertad, n − 1 de n lecturas
budget-row-kind = Vale para
budget-row-type = Tipo
budget-row-law = Distribución
budget-row-given = Se da como
budget-row-half-width = Semiamplitud
budget-row-resolution = Escalón de lectura
budget-given-standard = Incertidumbre típica
budget-given-expanded = Incertidumbre expandida
budget-type-a = A, estadística
budget-type-b = B, otro
budget-kind-plain = Diámetro
budget-kind-scatter = Dispersión de palpación
budget-kind-part-temperature = Temperatura de la pieza
budget-kind-scale-temperature = Temperatura de las escalas
budget-kind-part-expansion = Dilatación de la pieza
budget-kind-scale-expansion = Dilatación de las escalas
budget-kind-resolution = Resolución
budget-table-stale = El texto tiene un error: la tabla muestra las contribuciones como estaban antes
budget-table-other = El texto escribe sus contribuciones de una forma que la tabla no puede cambiar. Edite el texto
budget-table-calibrated = Este balance es de una pieza patrón y no tiene contribuciones. Edite el texto
budget-law-normal = Distribución normal
budget-law-rectangular = Distribución rectangular
budget-law-u-shaped = Distribución en U
budget-law-triangular = Distribución triangular
