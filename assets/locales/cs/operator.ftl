# The window for an operator

operator-mode = Pro koho je toto okno
operator-mode-about = Obsluha má měření, výsledky a nápovědu velkým písmem; vše ostatní je v úplném okně
operator-mode-operator = Obsluha
operator-mode-operator-about = Měření, výsledky a nápověda: dotykem, v rukavicích, ze dvou metrů.
operator-mode-full = Vše
operator-mode-full-about = Všechny stránky, pro práci u stolu.
operator-question = Pro koho je toto okno?
operator-question-later = Lze kdykoli změnit v nastavení; obsluha se tam dostane přes „Odejít“.
operator-leave = Odejít
operator-report = Zpráva
operator-undo = Zpět
operator-measure = Měřit
operator-results = Výsledky
operator-one-size = Jeden rozměr
operator-part = Díl
operator-last = Poslední výsledky
operator-newer = Novější
operator-older = Starší
operator-back-to-results = Zpět k výsledkům
operator-dropped = { $name } se zde neotevře: obsluha neotevírá soubory. Nejprve přejděte do úplného okna.
operator-no-results = Zatím nic nebylo změřeno.
operator-features = { $count ->
    [one] 1 prvek
    [few] Prvky: { $count }
   *[other] Prvky: { $count }
}
operator-next = Další
operator-next-part = Další díl
operator-to-value = Hodnota
operator-type-callout = Zadejte, co udává výkres, například 25 H7.
operator-type-value = Změřte a zadejte hodnotu.
operator-choose-part = Vyberte díl a zadejte jeho sériové číslo.
operator-hole-or-shaft = Co se měří?
operator-plans = Díly
operator-no-plans = V tomto počítači zatím nebyl otevřen žádný plán. Plány se otevírají v úplném okně na stránce Díly.
operator-go-on-first = Nejprve si přečtěte výrok a stiskněte Další: co bylo zadáno předtím, nebylo převzato

## The PIN
operator-pin = PIN okna obsluhy
operator-pin-about = Zadává ho ten, kdo okno obsluhy opouští. Uchovává se jen jeho hash se solí
operator-pin-use = Zamknout tímto PINem
operator-pin-remove = Odebrat PIN
operator-pin-try = Odemknout
operator-stay = Zůstat
operator-pin-short = PIN má nejméně { $least } znaky
operator-pin-set = Okno obsluhy je nyní zamčené PINem
operator-pin-removed = Okno obsluhy už není zamčené
operator-pin-wrong = Toto není správný PIN
operator-pin-not-hashed = Hash PINu nelze vypočítat: { $why }
operator-pin-asked = Zadejte PIN pro opuštění okna obsluhy.
operator-pin-forgotten = PIN zapomenutý? Příručka říká, jak se dostane dovnitř správce: The operator’s window, The PIN.
