# What a language says of itself

language-name = Español
language-decimal-sign = ,
