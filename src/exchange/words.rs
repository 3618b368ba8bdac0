//! The words that people use to name columns, in English, Dutch, German and Italian, and the units after them.

use std::collections::{HashMap, HashSet};
use std::sync::LazyLock;

use super::error::Role;
use crate::length::Unit;

/// How sure a name is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rank {
    /// The whole name is known.
    Exact,
    /// A word of it is known.
    Contained,
    /// The name fits, but others do as well: `diameter` may be nominal or measured.
    Weak,
}

const ID: &str = "id|nr|no|number|nummer|num|numero|part|part no|part number|part id|teil|teilenummer|deel|onderdeel|\
    workpiece|werkstuk|werkstück|pezzo|stuk|name|naam|nome|bezeichnung|benaming|feature|feature id|merkmal|kenmerk|\
    caratteristica|element|elemento|bore|hole|bohrung|boring|gat|foro|shaft|as|welle|albero|label|serial|serial number|\
    seriennummer|serienummer|matricola|pos|item|code|codice|what|was|wat";
const TOLERANCE: &str = "callout|fit|tolerance|tol|toleranz|tolerantie|tolleranza|passing|passung|accoppiamento|\
    toleranzfeld|tolerantieveld|spec|specification|specificatie|spezifikation|specifica|size and class";
const CLASS: &str = "class|klasse|classe|tolerance class|toleranzklasse|tolerantieklasse|classe di tolleranza|iso";
const NOMINAL: &str = "nominal|nominal size|nominal diameter|nominal value|nom|nennmaß|nennmass|nenngröße|nennwert|\
    sollmaß|sollmass|sollwert|soll|nominaal|nominale maat|nominale diameter|nominale|quota nominale|valore nominale|\
    diametro nominale|dimensione nominale|basic size|target";
const MEASURED: &str = "measured|measured value|measured size|measured diameter|measurement|actual|actual value|\
    actual size|actual diameter|reading|istmaß|istmass|istwert|ist|messwert|gemessen|gemessener wert|gemeten|\
    gemeten waarde|gemeten maat|meetwaarde|meting|werkelijk|werkelijke maat|werkelijke waarde|misurato|misurata|\
    valore misurato|diametro misurato|quota misurata|misurazione|effettivo|valore effettivo|dimensione effettiva";
const WEAK: &str = "diameter|durchmesser|diametro|ø|dia|d|size|maat|maß|mass|grootte|value|wert|waarde|valore|misura|\
    dimension|dimensione|mm";
const TIME: &str = "time|timestamp|time stamp|datetime|date time|date and time|date|tijd|tijdstip|datum|datum tijd|\
    datum en tijd|zeit|uhrzeit|zeitstempel|zeitpunkt|data|ora|data ora|data e ora|measured at|measured on";

const SIMULATED: &str = "simulated|gesimuleerd|simuliert|simulato";

/// Words that give a longer name another meaning: limits, deviations, whoever or whatever measured.
const OTHER: &str = "deviation|dev|afwijking|abweichung|scostamento|error|fout|fehler|errore|min|max|minimum|maximum|\
    minimaal|maximaal|minimo|massimo|lower|upper|onder|boven|unten|oben|inferiore|superiore|limit|limits|grens|grenze|\
    limite|by|door|von|at|on|op|am|gauge|tool|device|unit|eenheid|einheit|unità|height|hoogte|höhe|altezza|temp|\
    temperature|temperatuur|temperatur|temperatura|position|positie|posizione|x|y|z|status|result|resultaat|ergebnis|\
    risultato|count|anzahl|aantal|plus|minus|um|form|rundheit|roundness|rondheid|type|typ|tipo";

/// The lists above, to be asked by a word.
struct Known {
    /// What a whole name says.
    whole: HashMap<&'static str, (Role, Rank)>,
    /// What a word within a longer name says; the first of these roles counts.
    within: HashMap<&'static str, usize>,
    other: HashSet<&'static str>,
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
    Known { whole, within, other: OTHER.split('|').collect() }
});

/// What a column with this name holds.
pub(super) fn role(header: &str) -> Option<(Role, Rank)> {
    let name = bare(header);
    if let Some(known) = KNOWN.whole.get(name.as_str()) {
        return Some(*known);
    }
    if name.split(' ').any(|part| KNOWN.other.contains(part)) {
        return None;
    }
    let is_id = |part: &str| matches!(part, "id" | "nr" | "no" | "number" | "nummer" | "name" | "naam" | "nome");
    if name.split(' ').any(is_id) {
        return Some((Role::Id, Rank::Contained));
    }
    let place = name.split(' ').filter_map(|part| KNOWN.within.get(part)).min()?;
    WITHIN.get(*place).map(|(role, _)| (*role, Rank::Contained))
}

/// The name in small letters, without its unit, with single blanks between words.
pub(super) fn bare(header: &str) -> String {
    let (name, _) = split_unit(header);
    let mut bare = String::new();
    let mut before = ' ';
    for c in name.chars() {
        if c == '⌀' {
            bare.push('ø');
        } else if !c.is_alphanumeric() {
            bare.push(' ');
        } else {
            // measuredValue
            if before.is_lowercase() && c.is_uppercase() {
                bare.push(' ');
            }
            bare.extend(c.to_lowercase());
        }
        before = c;
    }
    bare.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The unit that a column's name ends in.
///
/// # Errors
/// The unit, where it is a length that is not read.
pub(super) fn unit(header: &str) -> Result<Option<Unit>, String> {
    let (_, unit) = split_unit(header);
    let Some(unit) = unit else { return Ok(None) };
    match unit.to_lowercase().as_str() {
        "mm" | "millimeter" | "millimetre" | "millimetri" => Ok(Some(Unit::Millimetre)),
        "\u{b5}m" | "\u{3bc}m" | "um" | "micron" | "microns" | "micrometer" | "micrometre" => {
            Ok(Some(Unit::Micrometre))
        }
        "in" | "inch" | "inches" | "zoll" | "pollici" | "\"" => Ok(Some(Unit::Inch)),
        "cm" | "dm" | "m" | "nm" | "mil" | "mils" | "thou" | "ft" => Err(unit.to_owned()),
        _ => Ok(None),
    }
}

/// A name and the unit after it: `measured [mm]`, `measured (mm)`, `measured_mm`, `measured mm`, `measured in mm`.
fn split_unit(header: &str) -> (&str, Option<&str>) {
    let header = header.trim().trim_end_matches([':', '.']);
    for (open, close) in [('[', ']'), ('(', ')'), ('{', '}'), ('<', '>')] {
        if let Some((name, unit)) = header.strip_suffix(close).and_then(|rest| rest.rsplit_once(open)) {
            return (name, Some(unit.trim()));
        }
    }
    for sign in ['_', ' ', '/', ',', '-'] {
        if let Some((name, unit)) = header.rsplit_once(sign)
            && matches!(
                unit.to_lowercase().as_str(),
                "mm" | "\u{b5}m" | "\u{3bc}m" | "um" | "inch" | "inches" | "zoll" | "cm" | "mil"
            )
        {
            let name = name.trim_end().strip_suffix(" in").unwrap_or(name);
            return (name, Some(unit));
        }
    }
    (header, None)
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

    #[test]
    fn units_stand_behind_names() {
        for (name, expected) in [
            ("measured", Ok(None)),
            ("measured [mm]", Ok(Some(Unit::Millimetre))),
            ("measured_um", Ok(Some(Unit::Micrometre))),
            ("Istmaß (µm)", Ok(Some(Unit::Micrometre))),
            ("actual [inch]", Ok(Some(Unit::Inch))),
            ("actual (in)", Ok(Some(Unit::Inch))),
            ("measured (average)", Ok(None)),
            ("measured [cm]", Err("cm".to_owned())),
        ] {
            assert_eq!(unit(name), expected, "{name}");
        }
    }
}
