# Wat een taal van zichzelf zegt

language-name = Nederlands
language-decimal-sign = ,
