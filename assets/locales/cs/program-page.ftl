## The program page

page-program = Programy
program-page-dialog-open = Otevřít NC program
program-page-choice = NC program
program-page-open = Otevřít…
program-page-not-shipped = { $name } není součástí této verze
program-page-nothing = Není otevřen žádný program
program-page-listing = { $name }, { $count ->
    [one] { $count } blok
    [few] { $count } bloky
   *[other] { $count } bloků
  }

program-page-run = Spustit
program-page-pause = Pauza
program-page-step = Po bloku
program-page-step-over = Přes volání
program-page-to-selected = Ke kurzoru
program-page-breakpoint = Zarážka
program-page-reset = Na začátek
program-page-move = Přejít na jiný blok
program-page-speed = Rychlost
program-page-speed-slow = 4 bloky/s
program-page-speed-medium = 20 bloků/s
program-page-speed-fast = plná rychlost
program-page-options = Možnosti
program-page-skip-unknown = Přeskočit neznámé bloky
program-page-assume-tool = Bez TOOL CALL snímat podél Z
program-page-block-skip = Přeskočit bloky s /
program-page-optional-stop = Zastavit na M1
program-page-outline-none = nadpis nebo návěští
program-page-outline = Přejít na

program-page-state-ready = Připraveno ke spuštění
program-page-state-running = Běží
program-page-state-paused = Pozastaveno
program-page-state-step = Po bloku
program-page-state-breakpoint = Pozastaveno na zarážce
program-page-state-goal = Pozastaveno u kurzoru
program-page-state-over = Pozastaveno po volání
program-page-state-stop = Program se sám zastavil: Spustit pokračuje
program-page-state-optional-stop = Program se sám zastavil na M1: Spustit pokračuje
program-page-state-tolerance = Mimo toleranci: { $stop }
program-page-state-log = Protokol je na obrazovce: Spustit pokračuje
program-page-state-ended = Ukončeno, bloků: { $blocks }
program-page-state-fault = Zastaveno s chybou
program-page-refused-inputs = Některý vstup nelze přečíst
program-page-refused-none = Není otevřen žádný program
program-page-refused-workpiece = Obrobek nelze přečíst
program-page-refused-no-contacts = Nejsou otevřeny žádné body dotyku

program-page-has-breakpoint = zarážka
program-page-is-current = další blok
program-page-is-failed = zde chyba

program-page-inputs = Vstupy
program-page-answers = Fitcheck a program
program-page-program = Program
program-page-verdict = Výrok
program-page-no-limits = Bez mezí: některý vstup nelze přečíst
program-page-agrees = Program se shoduje s Fitcheckem
program-page-contested = Program { $program }, Fitcheck { $own }
program-page-contested-limits = Program { $program }, podle jiných mezí než Fitcheck
program-page-stopped-at = Zastaveno s chybou; zatím { $program }
program-page-differs = Program se liší: { $what }
program-page-differs-minimum = jeho minimum je { $program } mm, ve Fitchecku { $own } mm
program-page-differs-maximum = jeho maximum je { $program } mm, ve Fitchecku { $own } mm
program-page-differs-status = udává { $program }, Fitcheck udává { $own }
program-page-differs-fault = zastavil se s chybou
program-page-differs-native-refuses = vydal výrok, Fitcheck nemá meze
program-page-other-inputs = Neporovnáno: program mezitím nastavil jiné vstupy a měří jiný prvek
program-page-both-refuse = Program ani Fitcheck nedávají výsledek

program-page-workpiece = Obrobek
program-page-from-perfect = dokonalý, střed mezí
program-page-from-nominal = dokonalý, jmenovitý
program-page-from-given = dokonalý, zadaný průměr
program-page-from-simulated = simulovaný
program-page-from-part = díl s více prvky
program-page-open-part = Otevřít díl…
program-page-dialog-part = Otevřít simulovaný díl s více prvky
program-page-refused-no-part = Není otevřen žádný díl
program-page-from-recorded = zaznamenané body dotyku
program-page-workpiece-x = Skutečný střed X
program-page-workpiece-y = Skutečný střed Y
program-page-edit-workpiece = Obrobek a sonda…
program-page-open-contacts = Jiné body dotyku…
program-page-recorded = { $count ->
    [one] { $count } bod dotyku
    [few] { $count } body dotyku
   *[other] { $count } bodů dotyku
  } z { $name }
program-page-path = Dráha sondy
program-page-no-path = Zatím žádná dráha
program-page-zero = Nula X { $x }, Y { $y }, Z { $z } mm
program-page-turned = natočeno o { $angle }°
program-page-tilted = naklopeno A { $a }°, B { $b }°, C { $c }°

program-page-no-windows = Program neotevřel žádné okno
program-page-window = { $from }, { $mask }
program-page-window-simulated = { $from }, { $mask }, SIMULOVÁNO
program-page-cycles = Změřeno
program-page-show-block = Zobrazit blok
program-page-last-of = Posledních { $shown } z { $all }
program-page-outputs = Soubory
program-page-outputs-hint = Zobrazeny zde, nezapsány na disk

program-page-parameters = Parametry
program-page-filter = Filtr
program-page-set = Začít s
program-page-value = Hodnota
program-page-give = Nastavit
program-page-give-hint = Další běh začne s touto hodnotou
program-page-given = Nastaveno pro další běh
program-page-drop = odebrat
program-page-no-parameter = { $given } není parametr: pište Q5, QL5, QR5 nebo QS5
program-page-no-number = { $given } není číslo
program-page-none-found = Neodpovídá žádný parametr
program-page-no-parameters = Parametry se vypíšou, jakmile program běží
program-page-undefined = nedefinováno
program-page-parameter = { $parameter } { $name } = { $value }
program-page-parameter-changed = { $parameter } { $name } = { $value }, změněno
program-page-pin = Držet { $parameter } nahoře
program-page-unpin = Nedržet { $parameter } nahoře
program-page-q108 = rádius nástroje
program-page-q109 = osa nástroje: 0 X, 1 Y, 2 Z
program-page-q110 = vřeteno: 0 M3, 1 M4, 2 nebo 3 poté zastaveno
program-page-q111 = chladicí kapalina: 0 vypnuta, 1 zapnuta
program-page-q113 = jednotka: 0 mm, 1 palec
program-page-q114 = délka nástroje
program-page-q115 = sejmutá poloha, X
program-page-q116 = sejmutá poloha, Y
program-page-q117 = sejmutá poloha, Z
program-page-q150 = naměřený úhel

program-page-problems = { $count ->
    [one] { $count } poznámka
    [few] { $count } poznámky
   *[other] { $count } poznámek
  }
program-page-unlisted = { $count ->
    [one] ještě { $count } není vypsána
    [few] ještě { $count } nejsou vypsány
   *[other] ještě { $count } není vypsáno
  }
program-page-at-block = blok { $number }: { $what }
program-page-at-line = řádek { $line }: { $what }

program-page-create = Vytvořit pro řídicí systém…
program-page-create-hint = NC programy, tabulky a maska, se kterými řídicí systém měří sám
program-page-create-also = zapsat sada souborů NC programy
program-page-create-head = Vytvořit pro řídicí systém
program-page-create-control = Řídicí systém
program-page-create-language = Jazyk dialogu
program-page-create-from = Z čeho
program-page-create-series = Pro sérii: každé spuštění měří další díl
program-page-create-texts = Tolerance průměrů jako texty cyklu
program-page-create-callout = { $callout } z Kontroly, na X { $x } Y { $y } Z { $z }
program-page-create-no-callout = Předpis z Kontroly
program-page-create-plan = Plán { $name }, { $count ->
    [one] { $count } prvek
    [few] { $count } prvky
   *[other] { $count } prvků
  }
program-page-create-nothing = Zadejte předpis na stránce Kontrola, nebo otevřete plán na stránce Díly
program-page-create-plan-wrong = { $name } obsahuje chyby: otevřete plán na stránce Díly a opravte je
program-page-create-folder = Složka na řídicím systému: { $folder }
program-page-create-proven-callout = Přečteno zpět a spuštěno: { $callout } dostává přesně meze Fitchecku
program-page-create-proven-plan = Přečteno zpět a spuštěno: každý prvek dostává meze plánu
program-page-create-clearance-height = Bezpečná výška je { $height } mm; v plánu ji určuje sloupec
program-page-create-files-none = Vytvořit soubory…
program-page-create-files = Vytvořit { $count ->
    [one] { $count } soubor…
    [few] { $count } soubory…
   *[other] { $count } souborů…
  }
program-page-dialog-create = Vytvořit soubory pro řídicí systém: zvolte nebo pojmenujte složku
program-page-create-written = { $count ->
    [one] { $count } soubor zapsán
    [few] { $count } soubory zapsány
   *[other] { $count } souborů zapsáno
  } do složky { $folder }: { $names }
program-page-create-no-folder = { $name } je soubor: uveďte složku
program-page-contacts-left = Body dotyku z { $name } patří k předchozímu programu: tento měří dokonalý obrobek
program-page-unfinished = Neporovnáno: program nedoběhl do konce
program-page-unknown = { $fault }. Aby běh pokračoval bez něj, zapněte Možnosti → Přeskočit neznámé bloky
program-page-missing-file = { $fault }. Hledalo se ve složce { $folder } a mezi vestavěnými soubory. Uložte jej tam, vedle programu, nebo otevřete program ve složce, kde soubor je
program-page-unknown-datum = { $fault }. Bez nulového bodu se nic neměří. Na zkoušku otevřete kopii programu bez bloku, který jej nastavuje, a obrobek viděný z tohoto nulového bodu
program-page-not-written = { $path } by se zapsal na řídicím systému. Jeho text je v části Soubory; z příkazového řádku jej zapíše fitcheck run --output-folder
program-page-no-verdict = Bez mezí není výrok
