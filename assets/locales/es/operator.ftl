# The window for an operator

operator-mode = Para quién es esta ventana
operator-mode-about = Un operador tiene medición, resultados y ayuda, en letra grande; todo lo demás está en la ventana completa
operator-mode-operator = Operador
operator-mode-operator-about = Medición, resultados y ayuda: con el dedo, con guantes y a dos metros.
operator-mode-full = Todo
operator-mode-full-about = Todas las páginas, para un escritorio.
operator-question = ¿Para quién es esta ventana?
operator-question-later = Se puede cambiar en cualquier momento en la configuración; un operador llega allí con «Salir».
operator-leave = Salir
operator-report = Informe
operator-undo = Deshacer
operator-measure = Medir
operator-results = Resultados
operator-one-size = Una cota
operator-part = Pieza
operator-last = Últimos resultados
operator-newer = Más recientes
operator-older = Más antiguos
operator-back-to-results = Volver a los resultados
operator-dropped = { $name } no se abre aquí: un operador no abre archivos. Pase antes a la ventana completa.
operator-no-results = Aún no se ha medido nada.
operator-features = { $count ->
    [one] 1 elemento
   *[other] Elementos: { $count }
}
operator-next = Siguiente
operator-next-part = Pieza siguiente
operator-to-value = Valor
operator-type-callout = Escriba lo que indica el plano, como 25 H7.
operator-type-value = Mida y escriba el valor.
operator-choose-part = Elija una pieza y escriba su número de serie.
operator-hole-or-shaft = ¿Qué se mide?
operator-plans = Piezas
operator-no-plans = En este ordenador aún no se ha abierto ningún plan. Los planes se abren en la ventana completa, en la página Piezas.
operator-go-on-first = Lea antes el dictamen y pulse Siguiente: lo escrito antes de eso no se ha tomado

## The PIN
operator-pin = PIN de la ventana del operador
operator-pin-about = Lo escribe quien sale de la ventana del operador. Solo se guarda un hash con sal
operator-pin-use = Bloquear con este PIN
operator-pin-remove = Quitar el PIN
operator-pin-try = Desbloquear
operator-stay = Quedarse
operator-pin-short = un PIN tiene { $least } caracteres o más
operator-pin-set = La ventana del operador está ahora bloqueada con un PIN
operator-pin-removed = La ventana del operador ya no está bloqueada
operator-pin-wrong = Este no es el PIN
operator-pin-not-hashed = No se pudo calcular el hash del PIN: { $why }
operator-pin-asked = Escriba el PIN para salir de la ventana del operador.
operator-pin-forgotten = ¿PIN olvidado? El manual dice cómo entra un administrador: The operator’s window, The PIN.
