//! What a cell or a row of a CSV seems to hold: numbers, callouts, classes, nothing; what the numbers of a column look like.

use std::borrow::Cow;

use csv::StringRecord;
use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::tolerance::{Callout, ToleranceClass};

use super::units;

/// Whether a row holds no figures: neither numbers nor callouts, nor anything meant as one.
pub(super) fn may_be_names(cells: &StringRecord) -> bool {
    let begins_with_digit =
        |cell: &str| cell.trim().trim_start_matches(['Ø', '⌀']).starts_with(|c: char| c.is_ascii_digit());
    !has_number(cells) && !cells.iter().any(begins_with_digit)
}

pub(super) fn has_number(cells: &StringRecord) -> bool {
    cells.iter().any(is_number)
}

/// Whether a row holds a callout or class, and a number.
pub(super) fn is_data(cells: &StringRecord) -> bool {
    has_number(cells)
        && (cells.iter().any(|cell| is_callout(cell) || is_class_with_grade(cell)) || own_callout(cells).is_some())
}

pub(super) fn is_blank(cells: &StringRecord) -> bool {
    cells.iter().all(|cell| cell.trim().is_empty())
}

pub(super) fn is_comment(cells: &StringRecord) -> bool {
    cells.get(0).is_some_and(|cell| cell.trim_start().starts_with('#'))
}

pub(super) fn is_number(cell: &str) -> bool {
    length(cell, Unit::Millimetre).is_ok()
}

/// A length as tables have it: with a unit of its own, and with signs between its thousands.
///
/// # Errors
/// What is wrong with the text.
pub(super) fn length(text: &str, unit: Unit) -> Result<Length, LengthError> {
    Length::parse_in(text, unit).or_else(|error| {
        let (number, own) = split_inch(text.trim());
        match (ungrouped(number), own) {
            (Cow::Borrowed(_), None) => Err(error),
            (number, own) => Length::parse_in(&number, own.unwrap_or(unit)),
        }
    })
}

/// A number without the sign of inch behind it, and the unit where it has one.
fn split_inch(text: &str) -> (&str, Option<Unit>) {
    let number = text.trim_end_matches(|c: char| c == '.' || !c.is_ascii_digit() && c != ',').trim_end();
    let behind = text.strip_prefix(number).map_or("", str::trim);
    match units::known(behind) {
        Some(Unit::Inch) if !number.is_empty() => (number, Some(Unit::Inch)),
        _ => (text, None),
    }
}

/// A number without the signs between its thousands: `1.025,012`, `1 025.012`, `1'025.0`. Without a decimal sign behind them nothing says
/// that they are thousands: `25 012` may be 25.012.
fn ungrouped(text: &str) -> Cow<'_, str> {
    let digits = text.trim_start_matches(['+', '-', '\u{2212}']);
    let Some(separator) = digits.chars().find(|c| !c.is_ascii_digit()) else { return Cow::Borrowed(text) };
    let is_blank = matches!(separator, ' ' | '\u{a0}' | '\u{2009}' | '\u{202f}' | '\'' | '\u{2019}');
    let is_sign = matches!(separator, '.' | ',');
    if !is_blank && !is_sign {
        return Cow::Borrowed(text);
    }
    let is_decimal = |c: char| matches!(c, '.' | ',') && c != separator;
    let Some((whole, rest)) = digits.find(is_decimal).and_then(|at| digits.split_at_checked(at)) else {
        return Cow::Borrowed(text);
    };
    let mut groups = whole.split(separator);
    let first = groups.next().unwrap_or("");
    let is_number = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    let begins = (1..=3).contains(&first.len()) && is_number(first) && !first.starts_with('0');
    let mut count = 0;
    let are_thousands = groups.all(|group| {
        count += 1;
        group.len() == 3 && is_number(group)
    });
    if !begins || !are_thousands || count == 0 || rest.contains(separator) && !is_blank {
        return Cow::Borrowed(text);
    }
    let sign = text.get(..text.len() - digits.len()).unwrap_or("");
    Cow::Owned(format!("{sign}{}{rest}", whole.replace(separator, "")))
}

/// The decimal sign of a number: the last one of two.
pub(super) fn sign_of(cell: &str) -> Option<char> {
    cell.chars().rfind(|c| matches!(c, '.' | ','))
}

pub(super) fn is_callout(cell: &str) -> bool {
    // Deviations and limits look like dates and part numbers: 2024-03-14, 17-3. "3 pcs" may be a callout, and seldom is.
    cell.parse::<Callout>().is_ok_and(|callout| callout.class().is_some_and(ToleranceClass::has_grade))
}

/// The cell with the callout of an own column: `25 PF` and not `3 pcs`, because another cell holds a number within a tenth
/// of its nominal size.
pub(super) fn own_callout(cells: &StringRecord) -> Option<usize> {
    let nominal = |cell: &str| {
        let callout = cell.parse::<Callout>().ok()?;
        callout.class().map(|_class| callout.nominal())
    };
    let is_near = |cell: &str, nominal: Length| {
        let apart = |number: Length| number.saturating_sub(nominal).abs().nanometres();
        Length::parse_in(cell, Unit::Millimetre).is_ok_and(|number| apart(number) <= nominal.nanometres() / 10)
    };
    let has_measured = |nominal: Length| cells.iter().any(|cell| is_near(cell, nominal));
    cells.iter().position(|cell| nominal(cell).is_some_and(has_measured))
}

/// Whether a cell of a column that is named is a class.
pub(super) fn is_class(cell: &str) -> bool {
    cell.parse::<ToleranceClass>().is_ok()
}

/// Whether a cell of a column without a name is a class: there a word such as GOOD is none.
pub(super) fn is_class_with_grade(cell: &str) -> bool {
    cell.parse::<ToleranceClass>().is_ok_and(ToleranceClass::has_grade)
}

/// Whether a cell is nothing but digits: one half of a number whose decimal comma was taken for a separator.
pub(super) fn is_whole(cell: &str) -> bool {
    let cell = cell.trim();
    !cell.is_empty() && cell.bytes().all(|byte| byte.is_ascii_digit())
}

/// How many decimals a number has.
pub(super) fn decimals(cell: &str) -> usize {
    cell.trim()
        .rsplit_once(['.', ','])
        .map_or(0, |(_, decimals)| decimals.chars().take_while(char::is_ascii_digit).count())
}

/// The decimal sign that most numbers of a column have; in a tie, the first one.
pub(super) fn decimal_sign<'c>(cells: impl Iterator<Item = &'c str> + Clone) -> Option<char> {
    let mut signs = cells.filter_map(sign_of);
    let all_signs = signs.clone();
    let first = signs.next()?;
    let (same, all) = all_signs.fold((0, 0), |(same, all), sign| (same + usize::from(sign == first), all + 1));
    let other = if first == '.' { ',' } else { '.' };
    Some(if same * 2 < all { other } else { first })
}

/// What whole numbers of a column look like.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct WholeNumbers {
    /// The most digits of one.
    digits: usize,
    /// Whether any begins with a 0 before other digits.
    begins_with_zero: bool,
}

impl WholeNumbers {
    pub(super) fn see(&mut self, cell: &str) {
        self.digits = self.digits.max(cell.len());
        self.begins_with_zero |= begins_with_zero(cell);
    }

    /// Whether a whole number may be one of them, and not the decimals of the cell before it.
    pub(super) fn may_have(&self, cell: &str) -> bool {
        let cell = cell.trim();
        cell.len() <= self.digits && (self.begins_with_zero || !begins_with_zero(cell))
    }
}

fn begins_with_zero(cell: &str) -> bool {
    1 < cell.len() && cell.starts_with('0')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_signs_between_their_thousands_and_units() {
        for (text, expected) in [
            ("1.025,012", Some("1025.012")),
            ("1,025.012", Some("1025.012")),
            ("1 025,012", Some("1025.012")),
            ("1\u{202f}025,012", Some("1025.012")),
            ("1\u{a0}025.5 mm", Some("1025.5")),
            ("1'025.012", Some("1025.012")),
            ("-1\u{2019}025.5", Some("-1025.5")),
            ("12 345 678,9 µm", Some("12345.6789")),
            ("1.025", Some("1.025")),
            ("0,98472 in", Some("25.011888")),
            ("1\"", Some("25.4")),
            ("1.0009 inch", Some("25.42286")),
            ("25012 µm", Some("25.012")),
            ("25,012 mm", Some("25.012")),
            ("1.025.012", None),
            ("1.02,012", None),
            ("0.025,012", None),
            ("1 02", None),
            ("25 012", None),
            ("25'012", None),
            ("25 012 µm", None),
            ("25 012 7", None),
            ("25,012;", None),
            ("25 in H7", None),
            ("in", None),
        ] {
            let read = length(text, Unit::Millimetre).ok().map(|length| length.to_string());
            assert_eq!(read.as_deref(), expected, "{text}");
        }
    }
}
