# Ce qu'une langue dit d'elle-même

language-name = Français
language-decimal-sign = ,
