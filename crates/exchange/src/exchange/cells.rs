//! What a cell or a row of a CSV seems to hold: numbers, callouts, classes, nothing; what the numbers of a column look like.

use csv::StringRecord;
use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::{Callout, ToleranceClass};

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
    Length::parse_in(cell, Unit::Millimetre).is_ok()
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
    let mut signs = cells.filter_map(|cell| match (cell.contains('.'), cell.contains(',')) {
        (true, false) => Some('.'),
        (false, true) => Some(','),
        _ => None,
    });
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
