//! What a measured value of a size can be at all: a value beyond that is a slip of unit, decimal sign or feature, and is asked about.

use super::fault::PlanFault;
use crate::length::Length;
use crate::tolerance::Limits;

/// The smallest and the largest value that a size can have, whole nanometres. It contains the limits of the size: what they allow or
/// call rework or scrap near by is a value all the same.
///
/// The value is compared as it was measured, before any correction to 20 °C.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plausible {
    /// The smallest value; less than [`Self::upper`].
    lower: Length,
    /// The largest value.
    upper: Length,
}

impl Plausible {
    /// From the smaller one to the larger one; `None` where they are not in this order.
    pub(super) fn new([lower, upper]: [Length; 2]) -> Option<Self> {
        (lower < upper).then_some(Self { lower, upper })
    }

    /// The same where it contains the limits of its size.
    pub(super) fn about(self, limits: &Limits, column: &'static str) -> Result<Self, PlanFault> {
        let Self { lower, upper } = self;
        let (minimum, maximum) = (limits.minimum(), limits.maximum());
        let contains = self.admits(minimum) && self.admits(maximum);
        if contains { Ok(self) } else { Err(PlanFault::PlausibleLimits { column, lower, upper, minimum, maximum }) }
    }

    /// The smallest value.
    pub const fn lower(self) -> Length {
        self.lower
    }

    /// The largest value.
    pub const fn upper(self) -> Length {
        self.upper
    }

    /// Whether a value can be one of the size; one that is equal to either end can.
    pub fn admits(self, measured: Length) -> bool {
        self.lower <= measured && measured <= self.upper
    }
}
