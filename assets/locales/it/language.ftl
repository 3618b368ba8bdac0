# Ciò che una lingua dice di sé

language-name = Italiano
language-decimal-sign = ,
