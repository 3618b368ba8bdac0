//! Columns whose names say nothing known: somebody may have written into any of their cells that a value is rejected, simulated or warm. Most
//! of these cells are empty, numbers or names, so that a row is asked at little cost.

use std::collections::VecDeque;

use fitcheck_core::length::Unit;

use super::beside::of_no_size;
use super::claim::Claim;
use super::evidence::says_simulated;
use super::{stated, warmth};

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
        if may_state_unit(text) && stated::states_other(text, self.unit) {
            return Some(Claim::of_unit(&said()));
        }
        let warm = || warmth::mentioned(text).filter(|_| asks_temperature);
        Claim::of_word(text).filter(Claim::is_known).or_else(|| warm().map(|warm| Claim::warm(&said(), warm)))
    }
}

/// Whether a cell may say something: not where it is empty, a number, or a name with a number in it.
#[inline]
pub(super) fn may_say(cell: &[u8]) -> bool {
    let mut has_letter = false;
    let mut has_digit = false;
    let mut has_blank = false;
    let mut has_sign = false;
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

/// Whether a text has a part of a word for units or of their names: most remarks have none.
fn may_state_unit(text: &str) -> bool {
    const PARTS: [&str; 16] = [
        "inch", "zoll", "duim", "pollic", "mm", "\u{b5}m", "\u{3bc}m", "um", "mil", "micr", "mikr", "metr", "cm",
        "unit", "einheit", "eenheid",
    ];
    let small = text.to_lowercase();
    PARTS.iter().any(|part| small.contains(part)) || small.contains(['"', '\u{2033}']) || small.contains(" in")
}

/// So many shapes are remembered.
const MOST_SHAPES: usize = 64;

/// Shapes of cells that were met: what one of a shape does not say, none of it says, whatever its numbers are.
#[derive(Debug, Default)]
pub(super) struct Heard {
    /// With the column, and whether they say nothing.
    shapes: VecDeque<(usize, String, bool)>,
    shape: String,
}

impl Heard {
    /// Whether a cell says nothing, because no other one of its shape does.
    pub(super) fn says_nothing(&mut self, column: &RemarkColumn, cell: &str) -> bool {
        self.take_shape(cell);
        if let Some((.., says_nothing)) =
            self.shapes.iter().find(|(at, known, _)| *at == column.at && *known == self.shape)
        {
            return *says_nothing;
        }
        // Degrees Celsius and kelvins of a part.
        let says_nothing =
            ["35", "300"].iter().all(|number| column.claim(&self.shape.replace('0', number), true).is_none());
        if self.shapes.len() == MOST_SHAPES {
            self.shapes.pop_front();
        }
        self.shapes.push_back((column.at, self.shape.clone(), says_nothing));
        says_nothing
    }

    /// Takes a cell with a single zero for each number.
    fn take_shape(&mut self, cell: &str) {
        self.shape.clear();
        let mut is_number = false;
        for c in cell.chars() {
            let is_digit = c.is_ascii_digit();
            if !(is_digit && is_number) {
                self.shape.push(if is_digit { '0' } else { c });
            }
            is_number = is_digit;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(text: &str) -> bool {
        let column = RemarkColumn { at: 0, name: "Remark".to_owned(), is_of_names: false, unit: Unit::Millimetre };
        let is_said = column.claim(text, true).is_some();
        // What is said is said by its shape, too.
        assert!(!is_said || !Heard::default().says_nothing(&column, text), "{text}");
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
