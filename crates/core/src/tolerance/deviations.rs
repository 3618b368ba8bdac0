//! The two deviations from a nominal size.

use crate::length::Length;
use crate::message::Say;

/// Upper and lower limit deviation from the nominal size; upper is never below lower.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Deviations {
    upper: Length,
    lower: Length,
}

/// The upper deviation is below the lower one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(id = "deviations-order", error)]
pub struct DeviationsError {
    /// The upper deviation that was given.
    pub upper: Length,
    /// The lower deviation that was given.
    pub lower: Length,
}

impl Deviations {
    /// A pair of deviations.
    ///
    /// # Errors
    /// [`DeviationsError`] when `upper` is below `lower`; they are not swapped.
    pub fn new(upper: Length, lower: Length) -> Result<Self, DeviationsError> {
        if upper < lower {
            return Err(DeviationsError { upper, lower });
        }
        Ok(Self { upper, lower })
    }

    /// The deviations between two values, whichever is the upper one: for trusted values, never for given texts.
    pub(super) fn spanning(one: Length, other: Length) -> Self {
        Self { upper: one.max(other), lower: one.min(other) }
    }

    /// Upper limit deviation (ES or es).
    #[inline]
    pub const fn upper(&self) -> Length {
        self.upper
    }

    /// Lower limit deviation (EI or ei).
    #[inline]
    pub const fn lower(&self) -> Length {
        self.lower
    }

    /// How far both deviations, upper and lower, lie above those of another pair.
    pub fn minus(&self, other: &Self) -> (Length, Length) {
        (self.upper.saturating_sub(other.upper), self.lower.saturating_sub(other.lower))
    }

    /// Width of the tolerance zone, zero or more.
    #[inline]
    pub fn width(&self) -> Length {
        self.upper.saturating_sub(self.lower)
    }
}
