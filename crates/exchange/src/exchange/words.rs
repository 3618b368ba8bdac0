//! The words that people use to name columns, in English, Dutch, German and Italian; `units` has the units beside them.
//!
//! To add a name of a column: add it to its list, in small letters, with one blank for each sign. Names of what is compared beside a value are
//! in `beside`, words of a verdict in `claim`, words of what was measured in `quantity`. Tests: `tests/core/beside.rs`, `column_mapping.rs`.

use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

use super::role::Role;
use super::units::{self, Parts};

/// How sure a name is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rank {
    /// The whole name is known.
    Exact,
    /// A word of it is known.
    Contained,
    /// The name fits, but others do as well: `diameter` may be nominal or measured.
    Weak,
    /// The name may be that of a measured value and may say another one: `gemeten voor` is "measured before" or "measured at the
    /// front". It is never taken, and beside a measured value it is asked about.
    Unsure,
}

const ID: &str = "id|nr|no|number|nummer|num|numero|part|part no|part number|part id|teil|teilenummer|deel|onderdeel|\
    workpiece|werkstuk|werkstück|pezzo|stuk|name|naam|nome|bezeichnung|benaming|feature|feature id|merkmal|kenmerk|\
    caratteristica|characteristic|characteristic name|element|elemento|bore|hole|bohrung|boring|gat|foro|shaft|as|welle|albero|label|serial|serial number|\
    seriennummer|serienummer|matricola|pos|item|code|codice|what|was|wat";
const TOLERANCE: &str = "callout|fit|tolerance|tol|toleranz|tolerantie|tolleranza|passing|passung|accoppiamento|\
    toleranzfeld|tolerantieveld|spec|specification|specificatie|spezifikation|specifica|size and class";
const CLASS: &str = "class|klasse|classe|tolerance class|toleranzklasse|tolerantieklasse|classe di tolleranza|iso";
const NOMINAL: &str = "nominal|nominal size|nominal diameter|nominal value|nom|nennmaß|nennmass|nenngröße|nennwert|\
    sollmaß|sollmass|sollwert|soll|nominaal|nominale maat|nominale diameter|nominale|quota nominale|valore nominale|\
    diametro nominale|dimensione nominale|basic size|target";
const MEASURED: &str = "measured|meas|act|mis|measured value|measured size|measured diameter|measurement|actual|actual value|\
    actual size|actual diameter|reading|remeasured|re measured|remeasurement|recheck|re check|rechecked|nachgemessen|\
    nachmessung|hermeten|hermeting|rimisurato|rimisurata|istmaß|istmass|istwert|ist|messwert|gemessen|gemessener wert|gemeten|\
    gemeten waarde|gemeten maat|meetwaarde|meting|werkelijk|werkelijke maat|werkelijke waarde|misurato|misurata|\
    valore misurato|diametro misurato|quota misurata|misurazione|effettivo|valore effettivo|dimensione effettiva";
const WEAK: &str = "diameter|durchmesser|diametro|ø|dia|d|size|maat|maß|mass|grootte|value|wert|waarde|valore|misura|\
    dimension|dimensione|mm";
const TIME: &str = "time|timestamp|time stamp|datetime|date time|date and time|date|tijd|tijdstip|datum|datum tijd|\
    datum en tijd|zeit|uhrzeit|zeitstempel|zeitpunkt|data|ora|data ora|data e ora|measured at|measured on";

const SIMULATED: &str = "simulated|is simulated|gesimuleerd|simuliert|simulato|simulata";

/// Names of a column that says where a value comes from.
const ORIGIN: &str = "origin|value origin|data origin|measurement origin|herkunft|wertherkunft|oorsprong|herkomst|origine|\
    provenienza";

/// Names of a column that says whether a value was brought to 20 °C.
const CORRECTED: &str = "temp comp|temp compensation|temp compensated|temperature compensation|temperature correction|temp correction|\
    tempkomp|temp komp|temp kompensation|temperaturkompensation|temperaturkorrektur|temperatuurcompensatie|temperatuurcorrectie|\
    normalized|normalised|compensazione|compensazione termica|corrected|is corrected|temperature corrected|corrected to 20 c|at 20 c|temperature compensated|\
    compensated|gecorrigeerd|temperatuur gecorrigeerd|temperatuurgecorrigeerd|gecompenseerd|bij 20 c|op 20 c|korrigiert|\
    temperaturkorrigiert|temperaturkompensiert|kompensiert|auf 20 c|bei 20 c|corretto|corretta|compensato|a 20 c|correction um";

/// Names that say more of a value than what it is of: they count beside a column that names the feature.
const LABELS: [(Role, &str); 4] = [
    (
        Role::Part,
        "part|part no|part number|part id|teil|teilenummer|teil nr|deel|onderdeel|onderdeelnummer|workpiece|werkstuk|\
        werkstück|pezzo|drawing|drawing no|drawing number|zeichnung|zeichnungsnummer|tekening|tekeningnummer|disegno|\
        numero disegno|codice pezzo",
    ),
    (
        Role::Serial,
        "serial|serial no|serial number|sn|seriennummer|serien nr|serienummer|serienr|matricola|numero di serie|numero seriale",
    ),
    (
        Role::Number,
        "number|no|nr|nummer|num|numero|characteristic no|characteristic number|merkmalsnummer|merkmal nr|kenmerknummer|balloon|\
        balloon no|pos|position no|positie nr|positionsnummer",
    ),
    (
        Role::Who,
        "who|operator|inspector|measured by|checked by|inspected by|prüfer|bediener|gemessen von|geprüft von|operateur|\
        keurmeester|inspecteur|gemeten door|gekeurd door|operatore|ispettore|collaudatore|misurato da",
    ),
];

/// Names of the coordinates of a place.
const PLACES: [(Role, &str); 3] = [
    (Role::X, "x|x pos|pos x|x position|position x|x positie|positie x|posizione x|x soll|x nominal"),
    (Role::Y, "y|y pos|pos y|y position|position y|y positie|positie y|posizione y|y soll|y nominal"),
    (Role::Z, "z|z pos|pos z|z position|position z|z positie|positie z|posizione z|z soll|z nominal"),
];

/// Words that give a longer name another meaning: limits, deviations, whoever or whatever measured.
const OTHER: &str = "deviation|dev|afwijking|abweichung|scostamento|error|fout|fehler|errore|min|max|minimum|maximum|\
    minimaal|maximaal|minimo|massimo|lower|upper|onder|boven|unten|oben|inferiore|superiore|limit|limits|grens|grenze|\
    limite|by|door|von|at|on|op|am|gauge|tool|device|unit|eenheid|einheit|unità|height|hoogte|höhe|altezza|temp|\
    temperature|temperatuur|temperatur|temperatura|position|positie|posizione|x|y|z|status|result|resultaat|ergebnis|\
    risultato|count|anzahl|aantal|plus|minus|um|form|rundheit|roundness|rondheid|type|typ|tipo";

/// Words that say another measurement or another quantity than the diameter that was measured now: an earlier or an expected one,
/// that of a master or at the setting of a gauge, a radius. In a name for a part they say nothing.
const STRANGE: &str = "simulated|simulation|sim|previous|prev|prior|old|former|earlier|last|expected|predicted|estimated|\
    calculated|computed|assumed|planned|reference|ref|radius|radial|roughness|depth|angle|runout|concentricity|\
    cylindricity|flatness|straightness|parallelism|wear|correction|uncertainty|sigma|std|stdev|range|spread|scatter|\
    force|torque|pressure|humidity|\
    gesimuleerd|gesimuleerde|simulatie|vorig|vorige|eerder|eerdere|oud|oude|laatste|verwacht|verwachte|geschat|\
    geschatte|berekend|berekende|referentie|straal|ruwheid|diepte|hoek|slingering|cilindriciteit|vlakheid|rechtheid|\
    slijtage|correctie|onzekerheid|spreiding|\
    simuliert|simulierter|simulierte|simuliertes|vorherig|vorheriger|vorherige|vorheriges|voriger|voriges|früher|\
    früherer|frühere|früheres|alt|alter|alte|altes|letzter|letzte|letztes|erwartet|erwarteter|erwartete|erwartetes|\
    geschätzt|geschätzter|geschätzte|geschätztes|berechnet|berechneter|berechnete|berechnetes|referenz|halbmesser|\
    rauheit|rauigkeit|rauhigkeit|tiefe|winkel|rundlauf|zylindrizität|ebenheit|geradheit|parallelität|verschleiß|\
    verschleiss|korrektur|unsicherheit|streuung|spannweite|\
    simulato|simulata|precedente|vecchio|vecchia|ultimo|ultima|atteso|attesa|previsto|prevista|stimato|stimata|\
    calcolato|calcolata|riferimento|raggio|rugosità|rugosita|profondità|profondita|angolo|cilindricità|planarità|\
    usura|correzione|incertezza|dispersione|\
    before|pre|beforehand|vorher|vóór|vooraf|uncoated|prehone|prehoned|rough|rohteil|roh|vorgedreht|vorbearbeitet|vorbearbeitung|\
    unbeschichtet|voorbewerkt|onbehandeld|ruw|grezzo|grezza|sgrossato|sgrossata|\
    counterpart|mating|gegenstück|gegenstueck|gegenteil|tegenstuk|controparte|prüfring|pruefring|normal|vorgabe|\
    master|masters|setting|preset|calibration|calibrated|calibrating|cal|zero|zeroing|zeroed|gage|\
    einstellring|einstellmeister|einstellung|einstellmaß|einstellmass|einstellnormal|meister|meisterring|meisterteil|\
    lehrring|kalibrierung|kalibriert|kalibrierring|eichung|eichring|null|nullung|nullpunkt|nullmaß|nullmass|referenzring|\
    referenzteil|referenzmaß|referenzmass|\
    instelring|instelmaat|instelling|kalibratie|kalibreren|kalibreerring|ijking|ijkring|ijkmaat|nul|nulpunt|nulling|meester|\
    meesterring|referentiering|\
    azzeramento|azzerato|taratura|calibrazione|calibratura|calibro|impostazione|regolazione";

/// Words beside a measured value that say how it was found and leave it what it is.
const BESIDE: &str = "average|avg|mean|median|final|raw|corrected|in|gemiddeld|gemiddelde|mediaan|mittel|mittelwert|mittlerer|\
    mittlere|median|media|medio|mediana|of|the|a|an|de|het|een|van|der|die|das|des|von|il|la|lo|di|del|della|bei|bij|a|\
    with|mit|met|con|probe|taster|tastsystem|tastatore|cmm|kmg|machine|maschine|messmaschine|meetmachine|macchina|\
    point|points|punkt|punkte|punt|punten|punto|punti|two|three|four|inner|outer|inside|outside|innen|außen|aussen|\
    binnen|buiten|interno|esterno|round|zone|hand|val|eff|dim|1st|2nd|3rd|4th|vor|voor|prima|after|nach|na|dopo|ort|r";

/// The lists above, to be asked by a word.
struct Known {
    /// What a whole name says.
    whole: HashMap<&'static str, (Role, Rank)>,
    /// What a word within a longer name says; the first of these roles counts.
    within: HashMap<&'static str, usize>,
    other: HashSet<&'static str>,
    strange: HashSet<&'static str>,
    /// Every word of any list: none of them is a unit.
    words: HashSet<&'static str>,
}

/// The roles that one word within a longer name is enough for, the most telling first.
const WITHIN: [(Role, &str); 3] = [(Role::Nominal, NOMINAL), (Role::Measured, MEASURED), (Role::Tolerance, TOLERANCE)];

static KNOWN: LazyLock<Known> = LazyLock::new(|| {
    let exact = [
        (Role::Measured, MEASURED),
        (Role::Nominal, NOMINAL),
        (Role::Tolerance, TOLERANCE),
        (Role::Time, TIME),
        (Role::Simulated, SIMULATED),
        (Role::Id, ID),
    ];
    let exact = exact.map(|(role, list)| (role, Rank::Exact, list));
    let unsure = [(Role::Tolerance, Rank::Contained, CLASS), (Role::Measured, Rank::Weak, WEAK)];
    let mut whole = HashMap::new();
    for (role, rank, list) in exact.into_iter().chain(unsure) {
        for name in list.split('|') {
            whole.entry(name).or_insert((role, rank));
        }
    }
    let mut within = HashMap::new();
    for (place, (_, list)) in WITHIN.iter().enumerate() {
        for word in list.split('|') {
            within.entry(word).or_insert(place);
        }
    }
    let names = whole.keys().flat_map(|name| name.split(' '));
    let words = names.chain([OTHER, STRANGE, BESIDE].into_iter().flat_map(|list| list.split('|'))).collect();
    Known { words, whole, within, other: OTHER.split('|').collect(), strange: STRANGE.split('|').collect() }
});

/// Whether a word, in small letters, says something else than a unit.
pub(super) fn is_word(word: &str) -> bool {
    KNOWN.words.contains(word)
}

/// Words that make a tolerance what a value is out of: `OutOfTol` says how far, or that it is.
const OUT: [&str; 8] = ["out", "outside", "over", "außer", "ausser", "außerhalb", "buiten", "fuori"];

/// Whether a name says that its values are of before something was done, as far as a single name can say so.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Before {
    No,
    Perhaps,
    Yes,
}

/// Italian words between "before" and what was done.
const OF: [&str; 9] = ["di", "del", "dello", "della", "dell", "dei", "degli", "delle", "d"];

/// How German words end for what is done to a part: `vor Honen`, `vor Bearbeitung`; `vor Bund` is in front of the collar.
const DONE: [&str; 4] = ["en", "ung", "arbeit", "montage"];

/// Words that mean "before" in one place and something else in another: `voor honen`, but `voor` and `achter` are front and rear;
/// `prima di honing`, but `prima misura` is the first one. `vor Ort` is where it was measured.
fn before(name: &[String]) -> Before {
    let words: Vec<&str> = name.iter().map(String::as_str).collect();
    let of = |at: usize, word: &str| {
        let next = words.get(at + 1).copied();
        let is_before = match word {
            "vor" => {
                next.is_none_or(|next| ["dem", "der"].contains(&next) || DONE.iter().any(|end| next.ends_with(end)))
            }
            "voor" => 0 < at && next.is_some(),
            "prima" => next.is_some_and(|next| OF.contains(&next)),
            _ => false,
        };
        match word {
            _ if is_before => Before::Yes,
            "voor" => Before::Perhaps,
            "vor" if next != Some("ort") => Before::Perhaps,
            "prima" if 0 < at => Before::Perhaps,
            _ => Before::No,
        }
    };
    let all = (0..).zip(&words).map(|(at, word)| of(at, word));
    all.fold(Before::No, |found, next| if found == Before::No || next == Before::Yes { next } else { found })
}

/// Whether a name says that its values are of after something was done: one beside it with `voor` or `prima` is then before that.
pub(super) fn is_after(header: &str) -> bool {
    units::split(header).name.iter().any(|word| matches!(word.as_str(), "after" | "nach" | "na" | "dopo"))
}

/// Whether a name may say that its values are of before something was done.
pub(super) fn may_be_before(header: &str) -> bool {
    before(&units::split(header).name) == Before::Perhaps
}

/// What a column with this name holds.
pub(super) fn role(header: &str) -> Option<(Role, Rank)> {
    let Parts { mut name, inside, is_remark, .. } = units::split(header);
    let is_strange = |words: &[String]| words.iter().any(|word| KNOWN.strange.contains(word.as_str()));
    // A remark in brackets is no part of a name, but it may say that a size is another one.
    let is_size = |role: Role| matches!(role, Role::Measured | Role::Nominal | Role::Tolerance);
    let is_other = is_strange(&name) || is_strange(&inside);
    let is_other_size = is_strange(&inside);
    let before = before(&[name.as_slice(), inside.as_slice()].concat());
    if !is_remark {
        name.extend(inside.iter().cloned());
    }
    let may_be_radius = name.iter().any(|word| word == "r");
    let name = name.join(" ");
    let is_nominal = inside.iter().any(|word| KNOWN.within.get(word.as_str()) == Some(&0));
    if let Some(known) = KNOWN.whole.get(name.as_str()).filter(|(role, _)| !is_other_size || !is_size(*role)) {
        if known.0 == Role::Tolerance && is_deviation(header) {
            return None;
        }
        // A remark says what the name does not: `measured (before honing)`.
        match (known.0, before) {
            (Role::Measured, Before::Yes) => return None,
            (Role::Measured, Before::Perhaps) => return Some((Role::Measured, Rank::Unsure)),
            _ => {}
        }
        // "diameter (nominal)"
        let is_measured = known.1 != Rank::Weak || !is_nominal;
        return Some(if is_measured { *known } else { (Role::Nominal, Rank::Contained) });
    }
    if name.split(' ').any(|part| KNOWN.other.contains(part)) {
        return None;
    }
    let is_id = |part: &str| matches!(part, "id" | "nr" | "no" | "number" | "nummer" | "name" | "naam" | "nome");
    if name.split(' ').any(is_id) {
        return Some((Role::Id, Rank::Contained));
    }
    if is_other || before == Before::Yes {
        return None;
    }
    let place = name.split(' ').filter_map(|part| KNOWN.within.get(part)).min()?;
    let (role, _) = WITHIN.get(*place)?;
    match role {
        Role::Tolerance if is_deviation(header) || name.split(' ').any(|word| OUT.contains(&word)) => None,
        Role::Measured if before == Before::Perhaps || may_be_radius => Some((*role, Rank::Unsure)),
        _ => Some((*role, Rank::Contained)),
    }
}

/// Whether the name has the sign of an upper or lower deviation: `+TOL`, `Tol-`.
fn is_deviation(header: &str) -> bool {
    let is_sign = |c: char| matches!(c, '+' | '-' | '\u{2212}');
    let name = header.trim();
    name.starts_with(is_sign) || name.ends_with(is_sign)
}

/// What else a column with this name says of a value: the part, who measured, where it is.
pub(super) fn label(header: &str) -> Option<Role> {
    let name = bare(header);
    let lists = LABELS.iter().chain(&PLACES);
    lists.into_iter().find(|(_, list)| list.split('|').any(|known| known == name)).map(|(role, _)| *role)
}

/// Names of a column that says what somebody or something else decided.
const STATUS: &str = "status|result|verdict|decision|judgement|judgment|pass fail|ok nok|resultaat|uitslag|oordeel|beoordeling|\
    ergebnis|urteil|bewertung|entscheid|entscheidung|befund|risultato|esito|giudizio";

/// Whether a column with this name says the status of a value.
pub(super) fn is_status(header: &str) -> bool {
    let name = bare(header);
    STATUS.split('|').any(|known| known == name)
}

/// Names of rows that are figures of several parts, or of what a gauge was set by.
const OF_SEVERAL: &str = "mean|average|avg|max|maximum|min|minimum|range|median|sigma|std|std dev|stdev|standard deviation|cp|cpk|pp|ppk|usl|lsl|\
    count|sum|total|mittelwert|mittel|spannweite|streuung|standardabweichung|anzahl|summe|gemiddelde|gemiddeld|spreiding|standaarddeviatie|\
    aantal|totaal|media|mediana|massimo|minimo|deviazione standard|scarto tipo|master|setting master|setting ring|reference ring|master ring|\
    einstellring|einstellmeister|meister|instelring|meesterring|nominal|nennmaß|sollwert|nominaal|nominale";

/// Whether a row of this name is of no part.
pub(super) fn is_of_several_parts(name: &str) -> bool {
    let name = plain(name);
    OF_SEVERAL.split('|').any(|known| known == name)
}

/// Whether a column with this name says where a value comes from.
pub(super) fn is_origin(header: &str) -> bool {
    let name = plain(header);
    ORIGIN.split('|').any(|known| known == name)
}

/// Whether a column with this name says whether a value was brought to 20 °C.
pub(super) fn is_corrected(header: &str) -> bool {
    let name = plain(header);
    CORRECTED.split('|').any(|known| known == name)
}

/// Whether the name of a measured value says that it was brought to 20 °C, as in `Istmaß auf 20 °C` or `corrected diameter`.
pub(super) fn says_corrected(header: &str) -> bool {
    let name = plain(header);
    let words = || name.split(' ');
    let is_word = |word: &str| CORRECTED.split('|').any(|known| known == word);
    words().any(is_word) || words().zip(words().skip(1)).any(|pair| pair == ("20", "c"))
}

/// Everything of a name in small letters, with single blanks between words.
fn plain(header: &str) -> String {
    let words = header.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
    words.map(str::to_lowercase).collect::<Vec<_>>().join(" ")
}

/// The name in small letters, without its unit and what stands in brackets, with single blanks between words.
pub(super) fn bare(header: &str) -> String {
    units::split(header).name.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_four_languages_are_known() {
        for (name, expected) in [
            ("id", Some((Role::Id, Rank::Exact))),
            ("Part No.", Some((Role::Id, Rank::Exact))),
            ("Bohrung", Some((Role::Id, Rank::Exact))),
            ("measurement id", Some((Role::Id, Rank::Contained))),
            ("Callout", Some((Role::Tolerance, Rank::Exact))),
            ("Passung", Some((Role::Tolerance, Rank::Exact))),
            ("passing", Some((Role::Tolerance, Rank::Exact))),
            ("tolleranza", Some((Role::Tolerance, Rank::Exact))),
            ("Toleranzklasse", Some((Role::Tolerance, Rank::Contained))),
            ("Nennmaß [mm]", Some((Role::Nominal, Rank::Exact))),
            ("nominal_mm", Some((Role::Nominal, Rank::Exact))),
            ("measured_mm", Some((Role::Measured, Rank::Exact))),
            ("Istmaß (mm)", Some((Role::Measured, Rank::Exact))),
            ("Gemeten [mm]", Some((Role::Measured, Rank::Exact))),
            ("valore misurato", Some((Role::Measured, Rank::Exact))),
            ("measuredValue", Some((Role::Measured, Rank::Exact))),
            ("Bore Ø measured in mm", Some((Role::Measured, Rank::Contained))),
            ("Ø", Some((Role::Measured, Rank::Weak))),
            ("Diameter", Some((Role::Measured, Rank::Weak))),
            ("Datum", Some((Role::Time, Rank::Exact))),
            ("measured at", Some((Role::Time, Rank::Exact))),
            ("measured by", None),
            ("measured deviation", None),
            ("upper tolerance", None),
            ("remark", None),
            ("", None),
        ] {
            assert_eq!(role(name), expected, "{name}");
        }
    }
}
