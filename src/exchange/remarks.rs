//! Columns whose names say nothing known: somebody may have written into any of their cells that a value is rejected, simulated or warm. Most
//! of these cells are empty, numbers or names, so that a row is asked at little cost.

use super::beside::of_no_size;
use super::claim::Claim;
use super::evidence::says_simulated;
use super::stated;
use super::warmth;
use crate::length::Unit;

/// Such a column.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct RemarkColumn {
    pub(super) at: usize,
    pub(super) name: String,
    /// Whether it holds the names of what was measured: they say something where they are those of a mean or a roundness.
    pub(super) is_of_names: bool,
    /// The unit of the measured values.
    pub(super) unit: Unit,
}

impl RemarkColumn {
    /// What a cell says against its value; a temperature only where nothing brought values to 20 °C.
    pub(super) fn claim(&self, text: &str, asks_temperature: bool) -> Option<Claim> {
        let text = text.trim();
        if !may_say(text.as_bytes()) {
            return None;
        }
        if self.is_of_names {
            return of_no_size(text);
        }
        let said = || if self.name.is_empty() { text.to_owned() } else { format!("{} {text}", self.name) };
        if says_simulated(text) {
            return Some(Claim::simulated(&said()));
        }
        if stated::states_other(text, self.unit) {
            return Some(Claim::of_unit(&said()));
        }
        let warm = || warmth::mentioned(text).filter(|_| asks_temperature);
        Claim::of_word(text).filter(Claim::is_known).or_else(|| warm().map(|warm| Claim::warm(&said(), warm)))
    }
}

/// Whether a cell may say something: not where it is empty, a number, or a name with a number in it.
#[inline]
pub(super) fn may_say(cell: &[u8]) -> bool {
    let (mut has_letter, mut has_digit, mut has_blank, mut has_sign) = (false, false, false, false);
    for byte in cell {
        match byte {
            b'0'..=b'9' => has_digit = true,
            b' ' | b'(' | b':' => has_blank = true,
            b'a'..=b'z' | b'A'..=b'Z' => has_letter = true,
            0x80.. => has_sign = true,
            _ => {}
        }
    }
    has_sign || has_letter && (has_blank || !has_digit)
}

/// A cell without what its numbers are: what one of a shape does not say, none of the shape says.
pub(super) fn shape(cell: &[u8], shape: &mut Vec<u8>) {
    shape.clear();
    for byte in cell {
        match byte {
            b'0'..=b'9' if shape.last() == Some(&b'0') => {}
            b'0'..=b'9' => shape.push(b'0'),
            byte => shape.push(*byte),
        }
    }
}

/// Whether no cell of a shape says anything, whatever its numbers are.
pub(super) fn says_nothing(column: &RemarkColumn, shape: &str) -> bool {
    // Degrees Celsius and kelvins of a part.
    ["35", "300"].iter().all(|number| column.claim(&shape.replace('0', number), true).is_none())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> bool {
        let column = RemarkColumn { at: 0, name: "Remark".to_owned(), is_of_names: false, unit: Unit::Millimetre };
        let is_said = column.claim(text, true).is_some();
        let mut of = Vec::new();
        shape(text.as_bytes(), &mut of);
        // What is said is said by its shape, too.
        assert!(!is_said || !says_nothing(&column, std::str::from_utf8(&of).unwrap()), "{text}");
        is_said
    }

    #[test]
    fn cells_that_say_something_are_told_from_names_and_numbers() {
        for text in [
            "rejected",
            "n.i.O.",
            "NOK",
            "✗ burr",
            "simulated",
            "part at 35 °C",
            "Teil 35C",
            "NOK: burr 3",
            "part 308 K",
        ] {
            assert_eq!(said(text), text != "✗ burr", "{text}");
        }
        for text in ["", "-", "12.5", "SN-000123", "a3f09c-77", "Meier", "B 12", "burr 3 mm", "after shift 2"] {
            assert!(!said(text), "{text}");
        }
    }
}
