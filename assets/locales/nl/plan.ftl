# Plannen van elementen: wat er mis is met een plan.

plan-no-features = het plan heeft geen elementen
plan-no-form-limit = { $text } is geen grens van een vorm- of plaatstolerantie: geef één lengte boven 0 in mm op, bijvoorbeeld 0.02
plan-too-many = het plan heeft meer dan { $most } elementen
plan-too-large = een plan heeft hoogstens { $most } KiB
plan-no-column = kolom { $column } ontbreekt
plan-unknown-column = onbekende kolom { $column }: de kolommen zijn { $known }
plan-column-twice = kolom { $column } komt twee keer voor
plan-cells = de rij heeft { $found } cellen en de kop { $expected }: scheid de kolommen bij een decimale komma met puntkomma's
plan-no-cell = { $column } ontbreekt
plan-value = { $what }: { $error }
plan-no-feature = { $callout } kan een boring of een as zijn: voeg feature = "hole" of feature = "shaft" toe, of kind = "length" als het geen van beide is
plan-fit = { $callout } geldt voor boring en as samen: zet ze als twee elementen in het plan
plan-clearance-height = veilige hoogte { $height } mm ligt niet boven de meethoogte, { $z } mm
plan-same-name = naam { $name } komt twee keer voor{ $line ->
    [0] : bestandsnamen op een besturing maken geen verschil tussen hoofdletters en kleine letters
   *[other] , het eerst op regel { $line }: bestandsnamen op een besturing maken geen verschil tussen hoofdletters en kleine letters
}
plan-unknown = { $column } { $given } is onbekend: { $known } verwacht
plan-other-side = soort { $given } is in strijd met { $column } { $text }, want dat is van een { $side ->
    [hole] boring
   *[shaft] as
    }: corrigeer een van beide, of schrijf diameter
plan-not-of = bij { $kind } hoort geen { $column }
plan-direction = as { $given } is geen richting: { $known } verwacht, of drie getallen zoals 0.5 0 -1, van -10 tot 10 met hoogstens 9 decimalen en niet alle 0
plan-no-band = { $text } is niet de tolerantie van een punt, zoals ±0.05 of +0.1/-0.05: { $error }
plan-band-side = een punt kan geen afwijkingen van { $lower } tot { $upper } mm hebben: de cyclus neemt een bovenafwijking van 0 of meer en een onderafwijking van 0 of minder, niet beide 0
plan-side-class = { $callout }: beide zijden van { $kind } hebben een klasse zoals { $example } nodig
plan-face-class = { $callout }: een vlak wordt als buitenmaat beoordeeld en heeft een asklasse nodig, zoals h9
plan-face-place = { $callout }: het vlak ligt op { $coordinate } mm langs de meetas, en dat moet de nominale maat zijn
plan-not-a-plan = dit is geen plan: een plan heeft een regel met de namen van zijn kolommen, zoals name;callout;x;y;z, of begint met fitcheck_plan = 1
plan-other-version = dit plan heeft versie { $given }: versies 1 tot { $newest } worden ondersteund
plan-toml = { $said }
plan-file = { $reason }
plan-unknown-key = onbekende sleutel { $key }: { $known } verwacht
plan-other-value = { $key }: { $expected } verwacht, { $found } gevonden
plan-parameter = cyclus { $cycle } neemt { $given } niet uit een plan: schrijf NAAM=WAARDE met een van { $known }
plan-no-parameter = geen meetcyclus neemt { $given } uit een plan: schrijf NAAM=WAARDE, zoals Q423=3
plan-travel = { $axis }{ $given } ligt buiten het bereik van de machine, { $minimum } tot { $maximum } mm
plan-clearance-travel = het tastsysteem beweegt op Z{ $height }, buiten het bereik van de machine, { $minimum } tot { $maximum } mm: geef een andere clearance_height
plan-no-travel = { $given } is geen bereik: schrijf twee getallen, het kleinste eerst, zoals -250 250
plan-no-plausible = { $column }: { $given } is geen bereik: schrijf twee lengten in mm, de kleinste eerst, zoals 24.5 25.5
plan-plausible-limits = { $column }: { $lower } tot { $upper } mm bevat de grensmaten niet, { $minimum } tot { $maximum } mm: geef een ruimer bereik
plan-text = { $column }: één regel met hoogstens { $most } tekens verwacht
plan-same-number = { $line ->
    [0] nummer { $number } komt twee keer voor: een ander element heeft { $other }
   *[other] nummer { $number } komt twee keer voor: het element op regel { $line } heeft { $other }
}
plan-same-size = { $line ->
    [0] een waarde { $called } kan bij dit element of bij { $other } horen: geef een van beide een andere naam
   *[other] een waarde { $called } kan bij dit element of bij { $other } op regel { $line } horen: geef een van beide een andere naam
}
plan-number-is-name = { $line ->
    [0] nummer { $number } is de naam van een ander element, { $other }
   *[other] nummer { $number } is de naam van een ander element, { $other } op regel { $line }
}
plan-name-is-number = { $line ->
    [0] een waarde { $called } kan bij dit element horen, of bij { $other }, dat dit nummer heeft
   *[other] een waarde { $called } kan bij dit element horen, of bij { $other } op regel { $line }, dat dit nummer heeft
}
plan-balloon = { $given } is geen plaats op de afbeelding: 0 tot 1 verwacht
plan-not-found-unknown = niet beoordeeld: geen element van het plan heeft deze naam, dit nummer of deze plaats
plan-not-found-no-clue = niet beoordeeld: de waarde heeft geen naam, nummer of plaats, dus hoort zij bij geen element van het plan
plan-not-found-half-place = niet beoordeeld: geen element van het plan heeft deze naam of dit nummer, en voor een plaats zijn X en Y nodig
plan-not-found-contradiction = niet beoordeeld: de naam hoort bij { $name } van het plan, maar het nummer bij { $number }
plan-not-found-other-name = geen element van het plan heet { $given }; { $name } heeft hetzelfde nummer, maar dat kan een volgnummer zijn: noem het element zoals in het plan, of geef zijn nominale maat
plan-not-found-running-number = niet beoordeeld: alleen het nummer hoort bij { $name } van het plan, en dat kan een volgnummer zijn, want andere rijen van het bestand horen niet bij dit plan
plan-not-found-other-nominal = niet beoordeeld: de waarde hoort bij { $name } van het plan, maar de nominale maat is { $given } en die van het plan { $planned }
plan-not-found-other-limits = niet beoordeeld: de waarde hoort bij { $name } van het plan, maar de grenzen { $given } hebben niets gemeen met die van het plan, { $planned }
plan-not-found-several = niet beoordeeld: meerdere elementen van het plan hebben deze plaats: { $names }
plan-not-found-which-side = niet beoordeeld: de waarde zegt niet welke van { $names } het is
part-standing = { $measured } gemeten, { $missing } ontbreken, { $skipped } overgeslagen
plan-not-found-other-kind = niet beoordeeld: de waarde hoort bij { $name } van het plan, maar dat is een { $kind }, en er is iets anders gemeten
plan-remark-file = { $said }
plan-remark-left = { $name } is overgeslagen: { $why }
plan-remark-class-left = { $name }: { $class } heeft andere grensmaten dan het bestand; die van het bestand tellen
plan-remark-place-left = { $name }: er is geen positie overgenomen: { $why }
plan-remark-axes-assumed = posities: het bestand zegt niet langs welke assen de boringen en assen liggen; Z is aangenomen
plan-remark-uncertainty-left = { $name }: de uitgebreide onzekerheid van { $expanded } mm is overgeslagen, omdat de helft ervan geen heel aantal nanometer is
plan-remark-clearance-raised = { $name } ligt boven de gebruikelijke veilige hoogte: { $height } is geschreven
plan-simulated-no-place = { $name } heeft geen plaats in het plan: het kan niet worden gesimuleerd
plan-simulated-no-cycle = geen cyclus meet { $name }: het kan niet worden gesimuleerd
