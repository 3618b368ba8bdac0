//! The clearances that a search for pairs may choose from.

use super::PairClearances;

/// Clearances in nanometres, both ends included; for the walk only, so they may lie anywhere.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    pub(super) low: i64,
    pub(super) high: i64,
}

impl Window {
    pub(super) const fn of(wanted: PairClearances) -> Self {
        Self { low: wanted.minimum().nanometres(), high: wanted.maximum().nanometres() }
    }

    /// What of these clearances lies in a band of this width around their middle.
    pub(super) const fn around_middle(self, band: i64) -> Self {
        let Self { low, high } = self;
        // Ends of the band on a half nanometre: inwards, where the last whole one is.
        let inwards = (high - low - band).div_euclid(2) + (high - low - band).rem_euclid(2);
        Self { low: low + inwards, high: high - inwards }
    }
}
