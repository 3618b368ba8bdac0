page-pairing = Emparejar

# What is asked
pairing-page-wanted = Juego o ajuste deseado
pairing-page-wanted-hint = Mínimo y máximo en mm, como 0.010..0.030, o un ajuste, como 25 H7/g6. Negativo es apriete.
pairing-page-wanted-range = Juego { $minimum } … { $maximum } µm, centro { $middle } µm
pairing-page-wanted-fit = { $fit }: juego { $minimum } … { $maximum } µm, centro { $middle } µm
pairing-page-wanted-refused = { $reason }; se admite un ajuste, como 25 H7/g6, y dos juegos en mm, como 0.010..0.030
pairing-page-holes = Agujeros medidos
pairing-page-shafts = Ejes medidos
pairing-page-no-parts = aún ninguno
pairing-page-reading = leyendo…
pairing-page-from-file = { $name }, { $count ->
        [one] 1 pieza
       *[other] { $count } piezas
    }
pairing-page-from-history = Del historial, { $count ->
        [one] 1 pieza
       *[other] { $count } piezas
    }
pairing-page-refused = { $count ->
        [one] 1 fila no admitida
       *[other] { $count } filas no admitidas
    }
pairing-page-all-refused = Las { $count } filas no admitidas
pairing-page-all-notes = Las { $count } advertencias
pairing-page-open-holes = Abrir agujeros…
pairing-page-open-shafts = Abrir ejes…
pairing-page-history-holes = Agujeros del historial
pairing-page-history-shafts = Ejes del historial
pairing-page-history-hint = Usa las comprobaciones elegidas, o todas las mostradas si no hay ninguna elegida
pairing-page-groups = Grupos
pairing-page-groups-hint = Número de grupos de igual ancho en que se clasifican además las piezas. Vacío: ninguno.
pairing-page-do-wanted = Escriba el juego deseado o un ajuste.
pairing-page-do-holes = Abra los agujeros medidos, o tómelos del historial.
pairing-page-do-shafts = Abra los ejes medidos, o tómelos del historial.
pairing-page-about = Fitcheck forma tantos pares como sea posible dentro del juego deseado. De todas las formas de hacerlo, toma la de menor suma de distancias al cuadrado hasta el centro. Bastan nombres y valores medidos. También se pueden soltar archivos aquí, los agujeros primero.
pairing-page-no-side = { $name } no se abre: ya hay agujeros y ejes. Ábralo como agujeros o como ejes.
pairing-page-none-in-history = El historial no tiene comprobaciones de { $feature ->
        [hole] agujeros
       *[shaft] ejes
    }.
pairing-page-listed-only = El historial está filtrado: los { $feature ->
        [hole] agujeros
       *[shaft] ejes
    } vienen de las { $listed } comprobaciones mostradas de { $all }
pairing-page-none-chosen = Ninguna de las comprobaciones elegidas es de un { $feature ->
        [hole] agujero
       *[shaft] eje
    }.
pairing-page-nothing-read = { $name } no tiene ninguna medida utilizable: { $reason }{ $count ->
        [one] { "" }
       *[other] { " " }({ $count } filas no admitidas)
    }
pairing-page-nothing-to-save = no hay pares que guardar

# The pairs
pairing-page-pairs = Pares
pairing-page-hole = Agujero
pairing-page-shaft = Eje
pairing-page-clearance = Juego
pairing-page-from-middle = Desde el centro
pairing-page-from-middle-head = Del centro
pairing-page-remark = Observación
pairing-page-line = línea { $line }
pairing-page-check = comprobación { $line }
pairing-page-hole-simulated = agujero simulado
pairing-page-shaft-simulated = eje simulado
pairing-page-both-simulated = ambos simulados
pairing-page-list = Pares de agujeros y ejes
pairing-page-row = { $hole } { $hole-mm } mm con { $shaft } { $shaft-mm } mm, juego { $clearance } µm, { $middle } µm desde el centro
pairing-page-move = Ir a otro par
pairing-page-copy = Copiar pares

# The picture
pairing-page-picture = Piezas por medida
pairing-page-legend = Anillo: agujero. Disco: eje, desplazado en el centro, { $middle } µm: un par en el centro queda horizontal. Cruz: sobrante.
pairing-page-part-of = Izquierda: todas las piezas; el marco señala las que se dibujan.
pairing-page-thinned = Demasiado juntas para dibujarlas todas: se dibuja 1 de { $step }.
pairing-page-left-over = sobrante
pairing-page-describe = { $holes ->
        [one] 1 agujero
       *[other] { $holes } agujeros
    } a la izquierda, { $shafts ->
        [one] 1 eje
       *[other] { $shafts } ejes
    } a la derecha, en una misma escala de medida; los ejes están desplazados { $middle } µm, de modo que un par en el centro del juego deseado queda horizontal. { $pairs ->
        [one] 1 par está dibujado como línea.
       *[other] { $pairs } pares están dibujados como líneas.
    }
pairing-page-describe-part = { $pairs ->
        [one] 1 par es visible.
       *[other] { $pairs } pares son visibles.
    }
pairing-page-describe-selected = Elegido: { $hole } con { $shaft }, juego { $clearance } µm.

# The answer
pairing-page-count = { $count ->
        [one] 1 par
       *[other] { $count } pares
    }
pairing-page-none = Aún sin resultado
pairing-page-at-work = Emparejando…
pairing-page-nothing-left = nada sobrante
pairing-page-left = sobrantes: { $holes ->
        [one] 1 agujero
       *[other] { $holes } agujeros
    }, { $shafts ->
        [one] 1 eje
       *[other] { $shafts } ejes
    }
pairing-page-simulated = { $count ->
        [one] 1 par con una pieza simulada
       *[other] { $count } pares con una pieza simulada
    }
pairing-page-no-pair = Ningún agujero y eje tienen un juego en el intervalo deseado.
pairing-page-smallest = Juego mínimo
pairing-page-largest = Juego máximo
pairing-page-middle = Centro deseado
pairing-page-band = Banda en torno a él
pairing-page-grinding = Rectificado
pairing-page-grind = { $amount } µm menos en los ejes sobrantes, o más en los agujeros sobrantes: { $count ->
        [one] 1 par más
       *[other] { $count } pares más
    }
pairing-page-grind-means = La menor cantidad, en pasos de 1 µm, que da más pares adicionales. Los pares existentes se mantienen.
pairing-page-grind-nothing = Ninguna cantidad da otro par.
pairing-page-grind-bounded = Se probaron cantidades hasta { $tried } µm; las piezas más alejadas necesitarían { $reach } µm.
pairing-page-groups-title = Grupos
pairing-page-group = Grupo { $number }: { $count ->
        [one] 1 par
       *[other] { $count } pares
    }
pairing-page-all-within = ✓ todos dentro
pairing-page-not-all-within = ✗ no todos dentro
pairing-page-no-group-pairs = un lado está vacío
pairing-page-group-holes = { $count ->
        [one] 1 agujero
       *[other] { $count } agujeros
    } { $from } … { $to } mm
pairing-page-group-shafts = { $count ->
        [one] 1 eje
       *[other] { $count } ejes
    } { $from } … { $to } mm
pairing-page-group-clearance = juego { $range }
pairing-page-outside-groups = En ningún grupo, fuera de las zonas: { $holes ->
        [one] 1 agujero
       *[other] { $holes } agujeros
    }, { $shafts ->
        [one] 1 eje
       *[other] { $shafts } ejes
    }

# Files
pairing-page-save-csv = Guardar como CSV…
pairing-page-save-json = Guardar como JSON…
pairing-page-file-name = pares
pairing-page-dialog-holes = Abrir agujeros medidos
pairing-page-dialog-shafts = Abrir ejes medidos
pairing-page-dialog-save = Guardar pares
file-kind-holes = Agujeros medidos
file-kind-shafts = Ejes medidos
file-kind-pairs = Pares
