//! How much text of a program becomes trees in memory.

use super::cursor::{Cursor, Stop};
use super::fault::BlockFault;
use super::lines::Piece;
use super::warnings::Odd;

/// The most text in formulas and in lines longer than [`LONG`], 8 MiB: once read, it takes up to fifty times its length
/// in memory. Real programs stay far below.
const MOST_FORMULAS: usize = 8 << 20;
/// A line from this length on is long: a control's has about 250 characters.
const LONG: usize = 256;

/// The text in formulas and long lines so far, in bytes.
#[derive(Debug, Default)]
pub(super) struct Weight(usize);

impl Weight {
    /// Counts the lines of a block, whose formulas begin with one of these words; too much in all is an error.
    pub(super) fn add(&mut self, pieces: &[Piece<'_>], formulas: &[&str]) -> Result<(), Odd> {
        let Some(&first) = pieces.first() else { return Ok(()) };
        let is_formula = formulas.iter().any(|word| Cursor::new(first.code).take_prefix(word));
        self.count(pieces.iter().map(|piece| piece.code.len()), is_formula)
            .map_err(|reason| Odd::of(&first, Stop { at: 0, reason }))
    }

    /// Counts lines by their lengths in bytes: all of a formula, of others the long ones; too much in all is an error.
    pub(super) fn count(&mut self, lengths: impl Iterator<Item = usize>, is_formula: bool) -> Result<(), BlockFault> {
        let weight: usize = lengths.filter(|length| is_formula || LONG < *length).sum();
        self.0 = self.0.saturating_add(weight);
        let is_within = weight == 0 || self.0 <= MOST_FORMULAS;
        if is_within { Ok(()) } else { Err(BlockFault::TooMuch { most: MOST_FORMULAS >> 20 }) }
    }
}
