//! The unit beside the name of a column: `measured [mm]`, `measured_um`, `[inch] measured`, `measured in mm`.
//!
//! What may be a unit and is none that is known is refused: a measured value in another unit is a wrong verdict.

use fitcheck_core::length::Unit;
use unicode_normalization::UnicodeNormalization as _;

use super::vocabulary::is_word;
use super::warmth;
use fitcheck_core::text::Within as _;

/// The longest last word of a name that may be the sign of a unit.
const LONGEST_SIGN: usize = 3;

/// The brackets that stand around units.
const BRACKETS: [(char, char); 4] = [('[', ']'), ('(', ')'), ('{', '}'), ('<', '>')];

/// A name of a column, taken apart.
#[derive(Debug, Default)]
pub(super) struct ColumnNameParts {
    /// Its words in small letters, without the unit and without what stands in brackets.
    pub(super) name: Vec<String>,
    /// What may be its units, each with what it means.
    units: Vec<(String, Option<Unit>)>,
    /// The words in brackets.
    pub(super) inside: Vec<String>,
    /// Whether one pair of brackets ends the name and there is no other: a remark.
    pub(super) is_remark: bool,
}

/// The unit that the name of a column says.
///
/// # Errors
/// What may be a unit and is not read.
pub(super) fn unit(header: &str) -> Result<Option<Unit>, String> {
    let ColumnNameParts { units, .. } = split(header);
    if let Some((unknown, _)) = units.iter().find(|(_, unit)| unit.is_none()) {
        return Err(unknown.clone());
    }
    let mut known = units.iter().filter_map(|(_, unit)| *unit);
    let first = known.next();
    if known.any(|other| Some(other) != first) {
        return Err(units.iter().map(|(text, _)| text.as_str()).collect::<Vec<_>>().join(", "));
    }
    Ok(first)
}

/// Whether a unit is one of angles.
pub(super) fn is_of_angle(unit: &str) -> bool {
    matches!(unit.trim().to_lowercase().as_str(), "°" | "deg" | "degree" | "degrees" | "grad" | "gon" | "rad")
}

/// Takes a name apart.
pub(super) fn split(header: &str) -> ColumnNameParts {
    let mut parts = ColumnNameParts::default();
    let mut rest = header.trim();
    let mut outside = String::new();
    let mut brackets = 0;
    // A bracket that is not closed goes on to the end.
    while let Some((at, open)) = rest.char_indices().find(|(_, c)| BRACKETS.iter().any(|(open, _)| open == c)) {
        let close = BRACKETS.iter().find(|(known, _)| *known == open).map_or(open, |(_, close)| *close);
        outside.push_str(rest.within(..at));
        outside.push(' ');
        let behind = rest.within(at + open.len_utf8()..);
        let (inside, after) = behind.split_once(close).unwrap_or((behind, ""));
        parts.bracket(inside.trim());
        brackets += 1;
        parts.is_remark = brackets == 1 && after.is_empty() && inside.len() < behind.len();
        rest = after;
    }
    outside.push_str(rest);
    parts.outside(&outside);
    parts
}

impl ColumnNameParts {
    /// What stands between brackets: a unit, words that are none, or something that may be one.
    fn bracket(&mut self, text: &str) {
        let before = self.units.len();
        let mut is_clear = true;
        for part in text.split([',', ';']) {
            is_clear &= self.part_of_bracket(part);
        }
        if !is_clear {
            self.units.truncate(before);
            self.units.push((text.to_owned(), None));
        }
    }

    /// The same between commas; `false` where it may be another unit: an unknown word, or a unit with a number.
    fn part_of_bracket(&mut self, text: &str) -> bool {
        let tokens: Vec<&str> = text.split_whitespace().collect();
        let mut has_unit = false;
        let mut has_number = false;
        let mut is_known = true;
        let mut left = tokens.as_slice();
        while let [token, more @ ..] = left {
            left = more;
            if is_number(token) {
                match more {
                    [next, more @ ..] if is_temperature(next) => left = more,
                    _ => has_number = true,
                }
            } else if let Some(unit) = known(token).filter(|_| more.is_empty() || !is_also_a_word(token)) {
                has_unit = true;
                self.units.push(((*token).to_owned(), Some(unit)));
            } else if !is_temperature_with_number(token) {
                let words = words_of(token);
                is_known &= may_stand_beside(token, &words);
                self.inside.extend(words);
            }
        }
        let is_known = is_known || !has_unit && warmth::speaks(text);
        is_known && !(has_unit && has_number)
    }

    /// What stands outside of brackets.
    fn outside(&mut self, text: &str) {
        // The signs of inch are no letters: 1″.
        let text = text.replace("''", "\"");
        let marked: String = text.chars().map(|c| if is_inch_sign(c) { ' ' } else { c }).collect();
        if marked != text {
            self.units.push(("\"".to_owned(), Some(Unit::Inch)));
        }
        let mut words = words_of(&marked);
        // "measured at 20 °C"
        if let [before @ .., number, "c" | "f" | "k"] = words.iter().map(String::as_str).collect::<Vec<_>>().as_slice()
            && is_number(number)
            && warmth::mentioned(&text).is_some()
        {
            let is_before = before.last().is_some_and(|word| ["at", "bei", "bij", "a", "auf", "op"].contains(word));
            words.truncate(before.len() - usize::from(is_before));
        }
        // A name that is nothing but a unit is a name: mm.
        while 1 < words.len()
            && let Some(at) = words.iter().rposition(|word| is_full_unit(word))
        {
            let word = words.remove(at);
            self.units.push((word.clone(), known(&word)));
            // "measured in mm"
            if 1 < at && words.get(at - 1).is_some_and(|before| before == "in") {
                words.remove(at - 1);
            }
        }
        if self.units.is_empty()
            && 1 < words.len()
            && let Some(last) = words.last()
        {
            let unit = known(last);
            if unit.is_some() || is_foreign(last) || may_be_sign(last, text.trim_end()) {
                self.units.push((last.clone(), unit));
                words.pop();
            }
        }
        self.name = words;
    }
}

/// The words of a text in small letters; `measuredValue` is two of them.
pub(super) fn words_of(text: &str) -> Vec<String> {
    // Some systems write "ü" as two characters.
    let composed = text.contains('\u{308}').then(|| text.nfc().collect::<String>());
    let text = composed.as_deref().unwrap_or(text);
    let mut spaced = String::new();
    let mut before = ' ';
    for c in text.chars() {
        if c == '⌀' {
            spaced.push('ø');
        } else if !c.is_alphanumeric() {
            spaced.push(' ');
        } else {
            if before.is_lowercase() && c.is_uppercase() {
                spaced.push(' ');
            }
            spaced.extend(c.to_lowercase());
        }
        before = c;
    }
    spaced.split_whitespace().map(str::to_owned).collect()
}

/// A unit that is read, in four languages.
pub(super) fn known(token: &str) -> Option<Unit> {
    let token = token.trim_matches(['.', ':']).to_lowercase();
    match token.as_str() {
        "mm" | "millimeter" | "millimeters" | "millimetre" | "millimetres" | "millimetri" | "millimetro" => {
            Some(Unit::Millimetre)
        }
        "\u{b5}m" | "\u{3bc}m" | "um" | "micron" | "microns" | "micrometer" | "micrometers" | "micrometre"
        | "micrometres" | "mikrometer" | "micrometri" | "micrometro" => Some(Unit::Micrometre),
        "in" | "inch" | "inches" | "zoll" | "duim" | "duimen" | "pollice" | "pollici" | "''" => Some(Unit::Inch),
        sign if !sign.is_empty() && sign.chars().all(is_inch_sign) => Some(Unit::Inch),
        _ => None,
    }
}

/// Whether a word beside a number is a unit of length, one that is read or another. With `is_behind` it is the only one behind the
/// number: "in" is a unit there alone.
pub(super) fn may_be_unit(word: &str, is_behind: bool) -> bool {
    (is_behind || !is_also_a_word(word)) && (known(word).is_some() || is_foreign(&word.to_lowercase()))
}

/// `"`, and what word processors make of it.
const fn is_inch_sign(c: char) -> bool {
    matches!(c, '"' | '\u{2033}' | '\u{201c}' | '\u{201d}' | '\u{201e}' | '\u{2dd}' | '\u{ff02}')
}

/// A unit that is one wherever it stands in a name.
fn is_full_unit(word: &str) -> bool {
    !is_also_a_word(word) && known(word).is_some()
}

/// Whether a unit is one at the end only, because the word means something else: "in the machine".
pub(super) fn is_also_a_word(word: &str) -> bool {
    matches!(word.to_lowercase().as_str(), "in" | "um")
}

/// Units of length that are not read.
pub(super) fn is_foreign(word: &str) -> bool {
    matches!(
        word,
        "m" | "cm"
            | "dm"
            | "km"
            | "nm"
            | "pm"
            | "mil"
            | "mils"
            | "thou"
            | "tenth"
            | "tenths"
            | "ft"
            | "foot"
            | "feet"
            | "yd"
            | "yard"
            | "yards"
            | "meter"
            | "metre"
            | "metri"
            | "metro"
            | "centimeter"
            | "centimetre"
            | "centimetri"
            | "zentimeter"
            | "decimeter"
            | "dezimeter"
            | "decimetri"
            | "nanometer"
            | "nanometre"
            | "nanometri"
            | "fu\u{df}"
            | "fuss"
            | "voet"
            | "piede"
            | "piedi"
            | "\u{b5}"
            | "\u{3bc}"
            | "my"
            | "mu"
            | "microinch"
            | "microinches"
            | "uin"
            | "\u{b5}in"
            | "\u{3bc}in"
            | "pouce"
            | "pouces"
            | "pulgada"
            | "pulgadas"
            | "tum"
    )
}

/// Whether a last word may be the sign of a unit: short, of letters, and none of the words that are known. One capital letter
/// is the name of a feature.
fn may_be_sign(word: &str, text: &str) -> bool {
    let is_short = word.chars().count() <= LONGEST_SIGN && word.chars().all(char::is_alphabetic);
    let is_capital = word.chars().count() == 1 && text.ends_with(char::is_uppercase);
    is_short && !is_capital && !is_word(word)
}

/// Whether something in brackets is no unit: numbers, words that are known, names of features such as A and P1.
fn may_stand_beside(token: &str, words: &[String]) -> bool {
    let is_plain = token.chars().all(|c| c.is_alphanumeric() || "-_.:⌀#&+?!".contains(c));
    let is_feature =
        token.chars().count() == 1 && token.chars().all(char::is_uppercase) && !is_foreign(&token.to_lowercase());
    let is_known = |word: &String| {
        let letters = word.trim_end_matches(|c: char| c.is_ascii_digit());
        let is_numbered = letters.len() < word.len() && letters.chars().all(char::is_alphabetic);
        let is_unit = is_foreign(letters) || known(letters).is_some();
        is_word(word) && !is_foreign(word) || is_numbered && !is_unit
    };
    is_plain && (is_feature || words.iter().all(is_known))
}

fn is_number(token: &str) -> bool {
    token.bytes().any(|byte| byte.is_ascii_digit())
        && token.bytes().all(|byte| byte.is_ascii_digit() || b".,+-".contains(&byte))
}

/// Degrees: a size holds at a temperature.
fn is_temperature(token: &str) -> bool {
    matches!(
        token.to_lowercase().trim_end_matches('.'),
        "c" | "\u{b0}c" | "\u{ba}c" | "\u{2103}" | "\u{b0}" | "f" | "\u{b0}f" | "k" | "grad" | "degc"
    )
}

/// `20°C`
fn is_temperature_with_number(token: &str) -> bool {
    let unit = token.trim_start_matches(|c: char| c.is_ascii_digit() || ".+-".contains(c));
    unit.len() < token.len() && is_temperature(unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_stand_beside_names() {
        let no = |text: &str| Err(text.to_owned());
        for (name, expected) in [
            ("measured", Ok(None)),
            ("measured [mm]", Ok(Some(Unit::Millimetre))),
            ("measured_um", Ok(Some(Unit::Micrometre))),
            ("Istmaß (µm)", Ok(Some(Unit::Micrometre))),
            ("actual [inch]", Ok(Some(Unit::Inch))),
            ("actual (in)", Ok(Some(Unit::Inch))),
            ("measured in", Ok(Some(Unit::Inch))),
            ("measured in mm", Ok(Some(Unit::Millimetre))),
            ("measured (average)", Ok(None)),
            ("measured [cm]", no("cm")),
            ("measured (20 °C)", Ok(None)),
            ("measured (20°C, mm)", Ok(Some(Unit::Millimetre))),
            ("measured [mm 20]", no("mm 20")),
            ("measured []", Ok(None)),
        ] {
            assert_eq!(unit(name), expected, "{name}");
        }
    }

    #[test]
    fn a_name_is_left_without_its_unit() {
        for (name, expected) in [
            ("Nennmaß [mm]", "nennmaß"),
            ("measuredValue", "measured value"),
            ("⌀ (mm)", "ø"),
            ("mm", "mm"),
            ("x_mm", "x"),
            ("measured diameter in mm", "measured diameter"),
            ("[inch] measured", "measured"),
            ("", ""),
        ] {
            assert_eq!(split(name).name.join(" "), expected, "{name}");
        }
    }
}
