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
}
