//! What a word, a line or the name of a column says of units.

use csv::StringRecord;
use fitcheck_core::length::Unit;

use super::sign;
use crate::exchange::delimited::SEPARATORS;
use crate::exchange::role::Role;
use crate::exchange::vocabulary::{Names, Rank};
use crate::exchange::{units, words};

/// Names of what states a unit, in small letters.
static KEYS: Names = Names::of(
    "unit|eh|einh|units|uom|u o m|unit of measure|units of measure|unit of measurement|units of measurement|measurement unit|\
    measurement units|measuring unit|measuring units|measure unit|length unit|length units|linear unit|linear units|unit of length|\
    units of length|dimension unit|dimension units|dimensional units|size unit|value unit|measured unit|nominal unit|actual unit|\
    unit measured|unit nominal|unit actual|unit value|unit measure|einheit|einheiten|maßeinheit|masseinheit|maßeinheiten|\
    masseinheiten|messeinheit|messeinheiten|längeneinheit|laengeneinheit|einheit der maße|eenheid|eenheden|maateenheid|meeteenheid|\
    lengte eenheid|lengteeenheid|unità|unita|unità di misura|unita di misura|u m|udm|unité|unidad",
);

/// Words that say such a name within a longer one.
const KEY_WORDS: [&str; 14] = [
    "unit",
    "units",
    "uom",
    "einheit",
    "einheiten",
    "maßeinheit",
    "masseinheit",
    "messeinheit",
    "eenheid",
    "eenheden",
    "meeteenheid",
    "unità",
    "unita",
    "unité",
];

/// Words before a unit that say that values are in it.
static LINKS: Names = Names::of(
    "in|are|is|all|values|value|units|unit|dimensions|dimension|sizes|measurements|lengths|einheit|einheiten|sind|ist|\
    werte|messwerte|maße|masse|angaben|alle|längen|eenheid|eenheden|zijn|is|waarden|maten|afmetingen|unità|unita|sono|valori|misure|\
    quote|dimensioni|tutte|tutti",
);

/// Words that turn a sentence round.
const NOT: [&str; 6] = ["not", "nicht", "niet", "non", "kein", "geen"];

/// Units of what is not a length.
static OTHER: Names = Names::of(
    "c|°c|ºc|℃|f|°f|k|degc|celsius|deg|degree|degrees|°|º|grad|grado|gradi|graden|rad|gon|n|kn|%|s|sec|min|h|ms|kg|g|bar|\
    mpa|gpa|pa|psi|v|a|hz|rpm|pcs|stk|stück|stuks|pz|ea|n/a|none|text|-|–|—",
);

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Word {
    Length(Unit),
    /// A unit of length that is not read.
    Foreign,
    /// A unit of something else.
    Other,
    Unknown,
}

pub(super) fn word(text: &str) -> Word {
    let text = text.trim().trim_matches(['[', ']', '(', ')', '{', '}', '<', '>', ',', ';']).trim();
    let small = text.to_lowercase();
    if let Some(unit) = units::known(text) {
        return Word::Length(unit);
    }
    let is_other = OTHER.has(small.trim_end_matches('.'));
    match small.as_str() {
        _ if is_other && !text.is_empty() => Word::Other,
        "metric" | "metrisch" | "metriek" | "metrico" => Word::Length(Unit::Millimetre),
        small if units::is_foreign(small.trim_end_matches('.')) => Word::Foreign,
        _ => Word::Unknown,
    }
}

/// What was stated: a unit, or what cannot be read as one.
pub(super) type Said = Result<Unit, String>;

/// A unit that a line names, and whether it says that values are in it.
pub(super) type Mention = (Said, bool);

/// Whether a text names what states a unit: with its whole name, or among other words.
pub(super) fn key(text: &str) -> Option<Rank> {
    let bare = words::bare(text);
    // "UoM" is no two words.
    let small = text.trim_matches([' ', '.']).to_lowercase();
    if KEYS.has(&bare) || KEYS.has(&small) {
        return Some(Rank::Exact);
    }
    let is_key = bare.split(' ').any(|part| KEY_WORDS.contains(&part)) && !bare.contains(|c: char| c.is_ascii_digit());
    is_key.then_some(Rank::Contained)
}

/// The unit behind a key; `None` where it says nothing of lengths.
fn value(text: &str) -> Result<Option<Unit>, String> {
    let mut found = None;
    for part in text.split([',', '/', '|', '+', ';', ' ']).map(str::trim).filter(|part| !part.is_empty()) {
        match word(part) {
            Word::Length(unit) if found.is_none_or(|found| found == unit) => found = Some(unit),
            Word::Other => {}
            Word::Length(_) | Word::Foreign | Word::Unknown => return Err(text.trim().to_owned()),
        }
    }
    Ok(found)
}

fn begins_with_figure(text: &str) -> bool {
    text.trim_start_matches(['+', '-', '\u{2212}', '.']).starts_with(|c: char| c.is_ascii_digit())
}

/// What a line that is no row says of units.
pub(super) fn mentions<'c>(cells: impl Iterator<Item = &'c str>) -> Vec<Mention> {
    let marks = ['#', '!', '%', '*', '/', '\''];
    // A line may have a million empty cells.
    let cells: Vec<&str> = cells.map(str::trim).filter(|cell| !cell.is_empty()).collect();
    let roles: Vec<_> = cells.iter().map(|cell| words::role(cell)).collect();
    let has_measured = roles.iter().any(|role| matches!(role, Some((Role::Measured, rank)) if *rank != Rank::Weak));
    // A commented header states the units of its own columns.
    let is_header = has_measured && 2 <= roles.iter().flatten().count();
    let fields: Vec<&str> = cells
        .iter()
        .flat_map(|cell| cell.split([':', '=']))
        .map(|field| field.trim_start_matches(marks).trim())
        .filter(|field| !field.is_empty())
        .collect();
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(&field) = fields.get(at) {
        let before = at.checked_sub(1).and_then(|at| fields.get(at));
        let behind = fields.get(at + 1);
        at += 1;
        if let Some(rank) = key(field)
            && let Some(text) = behind
            && word(field) == Word::Unknown
        {
            let is_foreign = || text.split_whitespace().any(|part| word(part) == Word::Foreign);
            match value(text) {
                Ok(unit) => found.extend(unit.map(|unit| (Ok(unit), true))),
                Err(text) if rank == Rank::Exact || is_foreign() => found.push((Err(text), true)),
                Err(_) => continue,
            }
            at += 1;
        } else if !is_header {
            found.extend(of_field(field, before.copied(), behind.copied()));
        }
    }
    if is_header {
        let is_size = |role: &Option<(Role, Rank)>| matches!(role, Some((Role::Measured | Role::Nominal, _)));
        for (cell, _) in cells.iter().zip(&roles).filter(|(_, role)| is_size(role)) {
            match of_name(cell.trim_start_matches(marks)) {
                Ok(unit) => found.extend(unit.map(|unit| (Ok(unit), true))),
                Err(unknown) => found.push((Err(unknown), true)),
            }
        }
    }
    found
}

/// Whether a comment says anything of units.
pub(in crate::exchange) fn may_state(cells: &StringRecord) -> bool {
    !mentions(cells.iter()).is_empty()
}

/// What a text without a key says.
fn of_field(field: &str, before: Option<&str>, behind: Option<&str>) -> Option<Mention> {
    let is_link = |text: &str| LINKS.has(text);
    let has_link = |text: &str| text.to_lowercase().split_whitespace().any(is_link);
    // "Tip [mm];3" is a size of its own.
    let is_of_number = before.is_some_and(begins_with_figure) || behind.is_some_and(begins_with_figure);
    let said = |text: &str| match word(text) {
        Word::Length(unit) => Some(Ok(unit)),
        Word::Foreign => Some(Err(text.trim_matches(['[', ']', '(', ')']).to_owned())),
        Word::Other | Word::Unknown => None,
    };
    // A letter is a shift or a class, "IN" is a country: they are units where something says so.
    if (field.chars().count() == 1 || units::is_also_a_word(field)) && !before.is_some_and(has_link) {
        return None;
    }
    // A lone sign of inch is a quotation mark.
    if let Some(unit) = said(field).filter(|_| field.contains(char::is_alphabetic)) {
        let is_clear = before.is_none_or(has_link) && 1 < field.chars().count() && !units::is_also_a_word(field);
        return (!is_of_number).then_some((unit, is_clear));
    }
    let is_negated = field.to_lowercase().split_whitespace().any(|part| NOT.contains(&part));
    let bracket = field.strip_suffix([')', ']']).and_then(|field| field.rsplit_once(['(', '[']));
    if let Some((_, inside)) = bracket.filter(|(_, inside)| 1 < inside.chars().count() || word(inside) != Word::Foreign)
        && let Some(unit) = said(inside)
    {
        return (!is_of_number).then_some((unit, !is_negated));
    }
    let tokens: Vec<&str> = field.split_whitespace().map(|token| token.trim_matches(['.', ',', '!', '?'])).collect();
    if let Some(unclear) = unclear(field, &tokens, is_negated) {
        return Some((Err(unclear), false));
    }
    for (at, token) in tokens.iter().enumerate() {
        let previous = at.checked_sub(1).and_then(|at| tokens.get(at)).map(|token| token.to_lowercase());
        let previous = previous.as_deref();
        if previous.is_some_and(begins_with_figure) {
            continue;
        }
        let is_last = at + 1 == tokens.len();
        let is_linked = previous.is_some_and(is_link);
        let is_before_key = tokens.get(at + 1).is_some_and(|next| key(next).is_some());
        match (word(token), said(token)) {
            (Word::Length(_), Some(unit)) => {
                let is_sign = units::is_also_a_word(token) || !token.contains(char::is_alphabetic);
                if !is_sign {
                    return Some((unit, (is_linked || is_before_key) && !is_negated));
                }
                if is_last && previous == Some("in") {
                    return Some((unit, !is_negated));
                }
            }
            (Word::Foreign, Some(unit))
                if is_linked && (1 < token.chars().count() || is_last && previous == Some("in")) =>
            {
                return Some((unit, !is_negated));
            }
            _ => {}
        }
    }
    None
}

/// Units in a sentence that nobody can follow without asking: "not in mm but in inch", "in 1/1000 mm".
fn unclear(field: &str, tokens: &[&str], is_negated: bool) -> Option<String> {
    let is_unit = |token: &str| {
        let is_sure = 1 < token.chars().count() && token.contains(char::is_alphabetic) && !units::is_also_a_word(token);
        is_sure && matches!(word(token), Word::Length(_) | Word::Foreign)
    };
    let pairs = tokens.iter().zip(tokens.iter().skip(1));
    let has_fraction = pairs.clone().any(|(number, unit)| {
        let parts = number.split_once('/');
        let is_fraction = parts.is_some_and(|(above, below)| begins_with_figure(above) && begins_with_figure(below));
        is_fraction && below_of(number) && is_unit(unit)
    });
    // "3 mm" is a size of its own.
    let free =
        pairs.filter(|(before, token)| is_unit(token) && !begins_with_figure(before)).map(|(_, token)| word(token));
    let mut first = None;
    let has_two = free.clone().any(|unit| *first.get_or_insert(unit) != unit);
    (has_fraction || has_two || is_negated && free.count() != 0).then(|| field.to_owned())
}

/// Whether a fraction is one of a unit, as `1/1000`, and no size in inches, as `3/4`.
fn below_of(number: &str) -> bool {
    number.split_once('/').is_some_and(|(_, below)| ["10", "100", "1000", "1.000", "10000"].contains(&below))
}

/// The unit that the name of a column says; a name that is nothing but a unit says it too.
pub(super) fn of_name(name: &str) -> Result<Option<Unit>, String> {
    Ok(units::unit(name)?.or_else(|| units::known(name.trim()).filter(|_| !units::is_also_a_word(name.trim()))))
}

/// Whether the row below a header gives the units of its columns.
pub(in crate::exchange) fn is_row_of_units(header: &StringRecord, cells: &StringRecord) -> bool {
    let is_sign = |cell: &str| match word(cell) {
        Word::Length(_) | Word::Foreign => true,
        Word::Other => cell.contains('\u{b0}'),
        Word::Unknown => false,
    };
    let is_unit = |(at, cell): (usize, &str)| is_sign(cell) && header.get(at).is_none_or(|name| key(name).is_none());
    // A name beside a unit is a row without its value.
    let is_name = |cell: &str| word(cell) == Word::Unknown && cell.contains(char::is_alphanumeric);
    !cells.iter().any(is_name) && cells.iter().enumerate().any(is_unit)
}

/// The unit behind the number of a cell.
pub(super) fn behind_number(text: &str) -> Option<Unit> {
    let unit = text.trim_start_matches(|c: char| c.is_ascii_digit() || " .,+-\u{2212}".contains(c));
    units::known(unit).filter(|_| unit.len() < text.len())
}

/// Whether a text states clearly that values are in another unit than this one.
pub(in crate::exchange) fn states_other(text: &str, unit: Unit) -> bool {
    mentions([text].into_iter()).into_iter().any(|(said, is_clear)| is_clear && said != Ok(unit))
}

/// What a line of contacts, which are in mm, says against that: another unit, or one that is not known.
pub(in crate::exchange) fn not_mm<'c>(cells: impl Iterator<Item = &'c str>) -> Option<String> {
    mentions(cells).into_iter().find_map(|(unit, _)| match unit {
        Ok(Unit::Millimetre) => None,
        Ok(unit) => Some(sign(unit).to_owned()),
        Err(unknown) => Some(unknown),
    })
}

/// The word by which a line says that something in it is in inch, also behind a number.
pub(in crate::exchange) fn inch_in(line: &str) -> Option<&str> {
    let mut before = "";
    line.split_whitespace().map(|token| token.trim_matches([':', ';', ',', '.', '(', ')', '[', ']'])).find(|token| {
        let is_behind_number = begins_with_figure(std::mem::replace(&mut before, token));
        let is_unit = units::known(token) == Some(Unit::Inch);
        let is_sure = token.contains(char::is_alphabetic) && !units::is_also_a_word(token);
        is_unit && (is_sure || is_behind_number) || behind_number(token) == Some(Unit::Inch)
    })
}

/// Whether all cells of a row are units or nothing.
pub(in crate::exchange) fn are_units<'c>(mut cells: impl Iterator<Item = &'c str>) -> bool {
    cells.all(|cell| cell.trim().is_empty() || matches!(word(cell), Word::Length(_) | Word::Foreign))
}

/// Whether a column of this name states units.
pub(in crate::exchange) fn names_units(name: &str) -> bool {
    key(name) == Some(Rank::Exact)
}

/// The unit of a cell in most of its spellings, as bytes.
#[inline]
pub(in crate::exchange) fn plain_unit(cell: &[u8]) -> Option<Unit> {
    match cell {
        b"mm" | b"MM" => Some(Unit::Millimetre),
        b"um" | b"\xc2\xb5m" | b"\xce\xbcm" => Some(Unit::Micrometre),
        b"in" | b"inch" | b"INCH" | b"Inch" | b"IN" => Some(Unit::Inch),
        _ => None,
    }
}

/// The cells of a line, whatever separates them.
pub(super) fn split(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| u8::try_from(c).is_ok_and(|byte| SEPARATORS.contains(&byte)))
        .map(|cell| cell.trim().trim_matches('"'))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_state_units_or_name_them_or_say_nothing() {
        let clear = |unit: Unit| vec![(Ok(unit), true)];
        let unclear = |unit: Unit| vec![(Ok(unit), false)];
        let no = |text: &str| vec![(Err(text.to_owned()), true)];
        let asked = |text: &str| vec![(Err(text.to_owned()), false)];
        let mm = Unit::Millimetre;
        let um = Unit::Micrometre;
        let inch = Unit::Inch;
        for (line, expected) in [
            ("# unit: inch", clear(inch)),
            ("Unit:;inch", clear(inch)),
            ("units=INCH", clear(inch)),
            ("All values in inch", clear(inch)),
            ("Maße in mm", clear(mm)),
            ("Alle Werte in Zoll", clear(inch)),
            ("Alle maten in duim", clear(inch)),
            ("Tutte le misure in pollici", clear(inch)),
            ("Einheit;µm", clear(um)),
            ("Messprotokoll [mm]", clear(mm)),
            ("inch", clear(inch)),
            ("(inch)", clear(inch)),
            ("Values: inches", clear(inch)),
            ("inch units", clear(inch)),
            ("values in in", clear(inch)),
            ("Dimensions in cm", no("cm")),
            ("Unit: furlong", no("furlong")),
            ("Unit: 0.001 mm", no("0.001 mm")),
            ("# measured in mils", no("mils")),
            ("Part;4711;Units;inch;Operator;JJ", clear(inch)),
            ("Zoll;12345", Vec::new()),
            ("Werkzeug Zoll", unclear(inch)),
            ("values are not in inch", asked("values are not in inch")),
            ("Werte in mm statt in Zoll", asked("Werte in mm statt in Zoll")),
            ("Werte in 1/1000 mm", asked("Werte in 1/1000 mm")),
            ("Temperature;20.1 C;Probe;3 mm", Vec::new()),
            ("Temperature unit;°C", Vec::new()),
            ("Unit;°C", Vec::new()),
            ("Unit;", Vec::new()),
            ("Tip [mm];3", Vec::new()),
            ("Part Name;Plate 4711;Drawing;D-200", Vec::new()),
            ("in the machine", Vec::new()),
            ("checked by;JJ", Vec::new()),
            ("# id;callout;measured [inch]", clear(inch)),
            ("# id;callout;measured;deviation [µm]", Vec::new()),
        ] {
            assert_eq!(mentions(split(line)), expected, "{line}");
        }
    }
}
