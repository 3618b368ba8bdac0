# Het venster voor een operator

operator-mode = Voor wie dit venster is
operator-mode-about = Een operator heeft meten, resultaten en hulp, in grote letters; al het andere staat in het volledige venster
operator-mode-operator = Operator
operator-mode-operator-about = Meten, resultaten en hulp, voor vingers, handschoenen en twee meter.
operator-mode-full = Alles
operator-mode-full-about = Alle pagina's, voor aan een bureau.
operator-question = Voor wie is dit venster?
operator-question-later = Dat kan altijd in de instellingen worden veranderd; een operator komt daar met “Verlaten”.
operator-leave = Verlaten
operator-report = Rapport
operator-undo = Ongedaan
operator-measure = Meten
operator-results = Resultaten
operator-one-size = Eén maat
operator-part = Onderdeel
operator-last = Laatste resultaten
operator-newer = Nieuwer
operator-older = Ouder
operator-back-to-results = Terug naar de resultaten
operator-dropped = { $name } wordt hier niet geopend: een operator opent geen bestanden. Ga eerst naar het volledige venster.
operator-no-results = Er is nog niets gemeten.
operator-features = { $count ->
    [one] 1 element
   *[other] Alle { $count } elementen
}
operator-next = Volgende
operator-next-part = Volgend onderdeel
operator-to-value = Waarde
operator-type-callout = Typ wat er op de tekening staat, zoals 25 H7.
operator-type-value = Meet en typ de waarde.
operator-choose-part = Kies een onderdeel en typ het serienummer.
operator-hole-or-shaft = Wat wordt er gemeten?
operator-plans = Onderdelen
operator-no-plans = Op deze computer is nog geen plan geopend. Plannen worden geopend in het volledige venster, op de pagina Onderdelen.
operator-go-on-first = Lees eerst het oordeel en druk op Volgende: wat daarvoor is getypt, is niet overgenomen

## The PIN
operator-pin = Pincode van het operatorvenster
operator-pin-about = Wie het operatorvenster verlaat, typt die. Alleen een hash met salt ervan wordt bewaard
operator-pin-use = Met deze pincode vergrendelen
operator-pin-remove = Pincode verwijderen
operator-pin-try = Ontgrendelen
operator-stay = Blijven
operator-pin-short = een pincode heeft { $least } of meer tekens
operator-pin-set = Het operatorvenster is nu met een pincode vergrendeld
operator-pin-removed = Het operatorvenster is niet meer vergrendeld
operator-pin-wrong = Dit is niet de pincode
operator-pin-not-hashed = De pincode kon niet worden gehasht: { $why }
operator-pin-asked = Typ de pincode om het operatorvenster te verlaten.
operator-pin-forgotten = Vergeten? De handleiding zegt hoe een beheerder binnenkomt: The operator’s window, The PIN.
