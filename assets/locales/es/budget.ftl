# budget

budget-toml = { $said }
budget-too-large = un archivo de balance tiene como máximo { $most } KiB
budget-not-one = un balance necesita o bien tablas [[contribution]] o bien una tabla [calibrated]
budget-too-many = { $count } contribuciones: un balance tiene como máximo { $most }
budget-empty = { $key } está vacío: se esperaba un texto
budget-day = { $key }: { $given } no es un día: se esperaba YYYY-MM-DD
budget-days = valid_until { $until } es anterior a date { $date }
budget-key = { $table }: { $key } no se usa aquí: las claves admitidas son { $allowed }
budget-missing = { $table }: falta { $keys }
budget-range = { $table }: { $key } es { $given }: se esperaba de { $least } a { $most }
budget-resolution-law = { $table }: una resolución es rectangular: se esperaba law = "rectangular" o ningún law
budget-geometry = { $table }: { $error }
budget-length = { $key }: { $error }
budget-geometry-touches = { $touches } palpaciones: se esperaban de 3 a { $most }
budget-geometry-step = { $touches } palpaciones a { $step } grados: se esperaba un paso de 0,01 a { $most } grados
budget-evaluation-no-size = { $contribution } depende de la medida, pero no se ha dado ninguna
budget-evaluation-no-contacts = { $contribution } depende de los puntos de palpación, pero el balance no tiene touches ni step_deg, y no se han dado puntos
budget-evaluation-nothing = todas las contribuciones son cero
budget-calibrated-too-few = { $readings ->
        [one] una lectura
       *[other] { $readings } lecturas
    }: se necesitan al menos 2
budget-calibrated-far-away = la media de las lecturas, { $mean } mm, está a más de 1 mm de la medida calibrada, { $size } mm
budget-calibrated-nothing = todas las incertidumbres son cero

budget-warning-expired = el balance ha caducado: era válido hasta el { $until }
budget-warning-not-yet = el balance aún no es válido: su fecha es { $date }
budget-warning-of-template = el balance aún tiene datos de la plantilla en su nombre, su autor o sus cifras: no dicen nada de este puesto
budget-warning-failed-study = un estudio dice de este medidor: { $why }
budget-warning-template-figures = estas contribuciones aún tienen las cifras de la plantilla: { $contributions }. Revise que valgan para este puesto
budget-warning-few-readings = { $readings } lecturas de la pieza patrón: ISO 15530-3 pide al menos { $fewest }
budget-warning-bias-corrected = sesgo { $bias } µm: la incertidumbre vale para valores a los que se ha restado el sesgo; Fitcheck no lo resta
budget-warning-bias-not-corrected = sesgo { $bias } µm: no se corrige, así que la incertidumbre lo incluye
budget-warning-other-size = la pieza patrón del balance tiene { $calibrated } mm, pero se midieron { $measured } mm: la incertidumbre vale para piezas como el patrón
budget-warning-other-side = la pieza patrón del balance es un { $calibrated ->
    [hole] agujero, pero se midió un eje
   *[shaft] eje, pero se midió un agujero
    }
budget-warning-other-expansion = { $contribution } del balance tiene la dilatación { $budget } · 10⁻⁶/K, pero el valor se corrigió con { $given }
budget-warning-other-temperature = { $contribution } del balance es para una temperatura a { $budget } K de 20 °C, pero el valor se corrigió para { $given } K
budget-warning-recorded = { $text }
