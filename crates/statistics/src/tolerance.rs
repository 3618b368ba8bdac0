//! The limits of a feature: one or both.

use crate::reason::Reason;

/// A lower limit, an upper one, or both. A natural limit, such as the 0 of a roundness, is none: only the other side counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    lower: Option<f64>,
    upper: Option<f64>,
}

impl Tolerance {
    /// Limits from these.
    ///
    /// # Errors
    /// No limit, one that is no finite number, or a lower one that is not below the upper one.
    pub fn new(lower: Option<f64>, upper: Option<f64>) -> Result<Self, Reason> {
        if lower.is_none() && upper.is_none() {
            return Err(Reason::NoLimits);
        }
        let is_finite = lower.into_iter().chain(upper).all(f64::is_finite);
        let is_ordered = lower.zip(upper).is_none_or(|(lower, upper)| lower < upper);
        if is_finite && is_ordered { Ok(Self { lower, upper }) } else { Err(Reason::SwappedLimits) }
    }

    /// The lower limit.
    pub const fn lower(&self) -> Option<f64> {
        self.lower
    }

    /// The upper limit.
    pub const fn upper(&self) -> Option<f64> {
        self.upper
    }

    /// Lower and upper limit.
    ///
    /// # Errors
    /// One of them is missing.
    pub fn both(&self) -> Result<[f64; 2], Reason> {
        self.lower.zip(self.upper).map(|(lower, upper)| [lower, upper]).ok_or(Reason::OneLimit)
    }

    /// The middle between both limits.
    ///
    /// # Errors
    /// One of them is missing.
    pub fn middle(&self) -> Result<f64, Reason> {
        self.both().map(|[lower, upper]| f64::midpoint(lower, upper))
    }

    /// How many values are below the lower and above the upper limit; a value on a limit is within.
    pub fn outside(&self, values: &[f64]) -> [usize; 2] {
        let below = |value: &&f64| self.lower.is_some_and(|lower| **value < lower);
        let above = |value: &&f64| self.upper.is_some_and(|upper| upper < **value);
        [values.iter().filter(below).count(), values.iter().filter(above).count()]
    }
}
