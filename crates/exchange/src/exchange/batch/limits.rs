//! Plain rows judged by limits in columns of their own.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::{Bounds, Feature};

use super::figures::{bounds_of, number};
use super::judge::{Judge, Take};
use super::judged::Judged;
use super::layout::utf8;
use super::tally::Tally;
use crate::exchange::row::TextRow;

impl Judge<'_> {
    /// Judges a plain row by limits in columns of their own; `None` as above.
    #[inline]
    pub(super) fn by_limits(
        &mut self,
        row: &TextRow<'_>,
        measured: Length,
        said: Option<Unit>,
        tally: &mut Tally,
        take: &mut impl Take,
    ) -> Option<()> {
        let fast = &self.court.fast;
        let limits = fast.limits?;
        if !fast.is_plain_size(row)? {
            return None;
        }
        let nominal = match fast.nominal {
            Some((at, unit)) => Some(number(row, (at, said.unwrap_or(unit)))?.0),
            None => None,
        };
        let (nominal, deviations) = bounds_of(row, limits, nominal, said)?;
        let feature = match fast.side {
            Some(side) => self.side(row.cell(side.at())?),
            None => None,
        };
        let bounds = Bounds::new(feature, nominal, deviations).filter(|bounds| Length::ZERO < bounds.minimum())?;
        self.court.sources.proportionate(&bounds).ok()?;
        self.give(row, &Judged::new(bounds, measured), None, tally, take);
        Some(())
    }

    /// Hole or shaft, as a cell says; a word is read once.
    fn side(&mut self, cell: &[u8]) -> Option<Feature> {
        /// So many words are remembered.
        const MOST: usize = 16;
        if let Some((_, side)) = self.sides.iter().find(|(known, _)| known == cell) {
            return *side;
        }
        let side = self.court.fast.side.and_then(|column| column.feature(utf8(cell).trim().trim_matches('"')));
        self.sides.truncate(MOST - 1);
        self.sides.push((cell.to_vec(), side));
        side
    }
}
