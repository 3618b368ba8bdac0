page-help = Ayuda

help-page-help = Ayuda de esta página
help-page-help-hint = Abre el manual; en la página de ayuda, vuelve a la página anterior
help-page-explain = Explicar este campo
help-page-explain-hint = Muestra para qué sirve el campo, su unidad, su intervalo y un ejemplo
help-page-about-field = Ayuda: { $name }
help-page-in-manual = En el manual
help-page-entry = Ayuda: { $title }
help-page-keys = Atajos de teclado
help-page-search = Buscar en el manual
help-page-open-found = Abrir el mejor resultado
help-page-nothing = Ninguna página del manual contiene estas palabras.
help-page-topics = Contenido
help-page-list = Páginas del manual
help-page-found = { $title }, { $heading }
help-page-found-line = { $place }: { $line }
help-page-move = Ir a otra página del manual
help-page-read = Mostrar la página
help-page-scroll = Desplazar el texto
help-page-back = Atrás
help-page-english = El manual está en inglés.

# Samples
help-page-samples = Probar
help-page-sample-value = Probar 25 H7 con 25,012
help-page-sample-part = Abrir una pieza de ejemplo
help-page-sample-file = Abrir un archivo de ejemplo
help-page-sample-program = Abrir un programa de ejemplo
help-page-sample-hint = Los ejemplos forman parte del programa. Los valores del archivo de ejemplo están marcados como simulados.

# The sheet of keys
help-page-keys-about = La tecla de una página funciona mientras esa página está abierta.
help-page-everywhere = En todas las páginas
help-page-in-dialogs = En los cuadros de diálogo
help-page-on-workpiece = Pieza de trabajo simulada
help-page-key-row = { $keys }: { $text }
