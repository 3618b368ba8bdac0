//! What the name of a column says, in six languages; `vocabulary` has the words, `units` the units beside them.
//!
//! Names of what is compared beside a value are in `beside`, words of a verdict in `claim`, words of what was measured in `quantity`.
//! Tests: `tests/core/beside.rs`, `column_mapping.rs`.

use std::collections::HashMap;
use std::sync::LazyLock;

use super::limits;
use super::role::Role;
use super::units::{self, ColumnNameParts};
use super::vocabulary::{KNOWN, Names, Rank, WITHIN, by_word};

/// Names of a column that says where a value comes from.
static ORIGIN: Names = Names::of(
    "origin|value origin|data origin|measurement origin|herkunft|wertherkunft|oorsprong|herkomst|origine|\
    provenienza",
);

/// Names of a column that says whether a value was brought to 20 °C.
static CORRECTED: Names = Names::of(
    "temp comp|temp compensation|temp compensated|temperature compensation|temperature correction|temp correction|\
    tempkomp|temp komp|temp kompensation|temperaturkompensation|temperaturkorrektur|temperatuurcompensatie|temperatuurcorrectie|\
    normalized|normalised|compensazione|compensazione termica|corrected|is corrected|temperature corrected|corrected to 20 c|at 20 c|temperature compensated|\
    compensated|gecorrigeerd|temperatuur gecorrigeerd|temperatuurgecorrigeerd|gecompenseerd|bij 20 c|op 20 c|korrigiert|\
    temperaturkorrigiert|temperaturkompensiert|kompensiert|auf 20 c|bei 20 c|corretto|corretta|compensato|a 20 c|correction um|\
    corrigé à 20 c|à 20 c|corregido a 20 c|skorygowano do 20 c|korigováno na 20 c|na 20 c",
);

/// Words of a name whose numbers are those of features: a balloon, a characteristic, a bore. A number below another name may count the rows.
static OF_FEATURES: Names = Names::of(
    "name|naam|nome|bezeichnung|benaming|feature|merkmal|merkmalsnummer|kenmerk|kenmerknummer|\
    characteristic|caratteristica|element|elemento|bore|hole|bohrung|boring|gat|foro|shaft|as|welle|albero|label|balloon|bubble|repère|alésage|característica|caractéristique|agujero|pos|\
    position|positie|posizione|positionsnummer|what|was|wat",
);

/// Names that say more of a value than what it is of: they count beside a column that names the feature.
const LABELS: [(Role, &str); 6] = [
    (
        Role::Part,
        "part|part no|part number|part id|teil|teilenummer|teil nr|deel|onderdeel|onderdeelnummer|workpiece|werkstuk|\
        werkstück|pezzo|drawing|drawing no|drawing number|zeichnung|zeichnungsnummer|tekening|tekeningnummer|disegno|\
        numero disegno|codice pezzo|pièce|numéro de pièce|code pièce|plan|numéro de plan|pieza|número de pieza|plano|número de plano",
    ),
    (
        Role::Serial,
        "serial|serial no|serial number|sn|seriennummer|serien nr|serienummer|serienr|matricola|numero di serie|numero seriale|numéro de série|número de serie|ser number|\
        part ident",
    ),
    (
        Role::Number,
        "number|no|nr|nummer|num|numero|characteristic no|characteristic number|merkmalsnummer|merkmal nr|kenmerknummer|balloon|\
        balloon no|elem no|element no|pos|position no|positie nr|positionsnummer|repère|numéro|número|print no|char no|bubble|bubble no|ballon",
    ),
    (
        Role::Who,
        "who|operator|inspector|measured by|checked by|inspected by|prüfer|bediener|gemessen von|geprüft von|operateur|\
        keurmeester|inspecteur|gemeten door|gekeurd door|operatore|ispettore|collaudatore|misurato da|opérateur|contrôleur|mesuré par|operador|operario|inspector|medido por",
    ),
    (
        Role::Machine,
        "machine|machine no|machine number|machine id|maschine|maschinennummer|maschinen nr|machinenummer|macchina|macchina n|\
        machine outil|máquina|maquina|equipment|anlage",
    ),
    (
        Role::Batch,
        "batch|batch no|batch number|lot|lot no|lot number|charge|chargennummer|chargen nr|los|losnummer|partij|partijnummer|batchnummer|\
        lotto|numero lotto|numéro de lot|lote|número de lote",
    ),
];

/// Names of the coordinates of a place.
const PLACES: [(Role, &str); 3] = [
    (Role::X, "x|x pos|pos x|x position|position x|x positie|positie x|posizione x|x soll|x nominal"),
    (Role::Y, "y|y pos|pos y|y position|position y|y positie|positie y|posizione y|y soll|y nominal"),
    (Role::Z, "z|z pos|pos z|z position|position z|z positie|positie z|posizione z|z soll|z nominal"),
];

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
    if let Some(limit) = limits::by_name(header) {
        return Some(limit.role());
    }
    let ColumnNameParts { mut name, inside, is_remark, .. } = units::split(header);
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
    static ALL: LazyLock<HashMap<&'static str, Role>> =
        LazyLock::new(|| by_word(LABELS.iter().chain(&PLACES).map(|(role, list)| (*list, *role))));
    ALL.get(bare(header).as_str()).copied()
}

/// Whether numbers in a column with this name may be running ones, or those of parts: nothing in it says that they are of features.
pub(super) fn may_be_running(header: &str) -> bool {
    let names_features = |word: &str| OF_FEATURES.has(word);
    !bare(header).split(' ').any(names_features)
}

/// Names of a column that says what somebody or something else decided.
static STATUS: Names = Names::of(
    "status|result|verdict|decision|judgement|judgment|pass fail|ok nok|resultaat|uitslag|oordeel|beoordeling|\
    ergebnis|urteil|bewertung|entscheid|entscheidung|befund|risultato|esito|giudizio",
);

/// Words with which a line begins that sums up the rows above it.
static SUMMARY: Names = Names::of(
    "summary|total|totals|zusammenfassung|gesamtergebnis|gesamt|samenvatting|totaal|riepilogo|totale|résumé|synthèse|resumen|end of report|\
    ende|end",
);

/// What a line of two cells says of the rows above it, besides a status.
static SUMMED: Names = Names::of(
    "characteristics total|total characteristics|characteristics in tolerance|characteristics out of tolerance|in tolerance|in tol|\
    out of tolerance|out of tol|disposition",
);

/// Whether a line that is no measurement sums up the rows above it.
pub(super) fn is_summary(cells: &csv::StringRecord) -> bool {
    let mut filled = cells.iter().map(str::trim).filter(|cell| !cell.is_empty());
    let Some(first) = filled.next() else { return false };
    let name = bare(first);
    SUMMARY.has(&name) || filled.count() == 1 && (SUMMED.has(&name) || is_status(first))
}

/// Names of a column of results: measured values, or what somebody decided.
static RESULTS: Names = Names::of(
    "result|results|messergebnis|messergebnisse|ergebnis|ergebnisse|resultaat|resultaten|meetresultaat|risultato|risultati|\
    résultat|résultats|resultado|resultados",
);

/// Whether a column with this name may have measured values, if they are numbers.
pub(super) fn may_be_results(header: &str) -> bool {
    let name = bare(header);
    RESULTS.has(&name)
}

/// Whether a column with this name says the status of a value.
pub(super) fn is_status(header: &str) -> bool {
    let name = bare(header);
    STATUS.has(&name)
}

/// Names of rows that are figures of several parts, or of what a gauge was set by.
static OF_SEVERAL: Names = Names::of(
    "mean|average|avg|max|maximum|min|minimum|range|median|sigma|std|std dev|stdev|standard deviation|cp|cpk|pp|ppk|usl|lsl|\
    count|sum|total|mittelwert|mittel|spannweite|streuung|standardabweichung|anzahl|summe|gemiddelde|gemiddeld|spreiding|standaarddeviatie|\
    aantal|totaal|media|mediana|massimo|minimo|escursione|deviazione standard|scarto tipo|master|setting master|setting ring|reference ring|master ring|\
    einstellring|einstellmeister|meister|instelring|meesterring|nominal|nennmaß|sollwert|nominaal|nominale",
);

/// Whether a row of this name is of no part.
pub(super) fn is_of_several_parts(name: &str) -> bool {
    let name = plain(name);
    OF_SEVERAL.has(&name)
}

/// Whether a column with this name says where a value comes from.
pub(super) fn is_origin(header: &str) -> bool {
    let name = plain(header);
    ORIGIN.has(&name)
}

/// Whether a column with this name says whether a value was brought to 20 °C.
pub(super) fn is_corrected(header: &str) -> bool {
    let name = plain(header);
    CORRECTED.has(&name)
}

/// Whether the name of a measured value says that it was brought to 20 °C, as in `Istmaß auf 20 °C` or `corrected diameter`.
pub(super) fn says_corrected(header: &str) -> bool {
    let name = plain(header);
    let words = || name.split(' ');
    let is_word = |word: &str| CORRECTED.has(word);
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
    fn names_of_six_languages_are_known() {
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
            ("upper tolerance", Some((Role::Upper, Rank::Exact))),
            ("valeur mesurée", Some((Role::Measured, Rank::Exact))),
            ("cota nominal", Some((Role::Nominal, Rank::Exact))),
            ("remark", None),
            ("", None),
        ] {
            assert_eq!(role(name), expected, "{name}");
        }
    }
}
