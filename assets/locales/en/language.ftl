# What a language says of itself

language-name = English
language-decimal-sign = .
