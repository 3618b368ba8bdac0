# What a language says of itself

language-name = Čeština
language-decimal-sign = ,
