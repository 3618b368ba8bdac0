# Co język mówi o sobie

language-name = Polski
language-decimal-sign = ,
