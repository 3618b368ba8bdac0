# Was eine Sprache von sich selbst sagt

language-name = Deutsch
language-decimal-sign = ,
