//! Measured parts of a fit: the clearance that they have or can have, and each part's own verdict.

use super::{Status, Verdict, judge};
use crate::length::Length;
use crate::tolerance::Feature;
use crate::tolerance::fit::Fit;

/// Two measured parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Actual {
    /// The hole's measured diameter.
    pub hole: Length,
    /// The shaft's measured diameter.
    pub shaft: Length,
    /// Hole minus shaft; negative is an interference.
    pub clearance: Length,
    /// Whether the clearance is in the range that the callout allows, both ends included. This is possible even with a
    /// part outside its own limits: the parts' verdicts say that.
    pub conforms: bool,
    /// The verdict of the hole alone.
    pub hole_verdict: Verdict,
    /// The verdict of the shaft alone.
    pub shaft_verdict: Verdict,
}

impl Actual {
    /// The clearance of two measured parts, and each part's own verdict.
    pub fn of(fit: &Fit, hole: Length, shaft: Length) -> Self {
        let clearance = hole.saturating_sub(shaft);
        Self {
            hole,
            shaft,
            clearance,
            conforms: fit.allows(clearance),
            hole_verdict: judge(fit.hole(), hole, None),
            shaft_verdict: judge(fit.shaft(), shaft, None),
        }
    }

    /// The worse of the two parts.
    pub fn status(&self) -> Status {
        self.hole_verdict.status().max(self.shaft_verdict.status())
    }
}

/// One measured part; the other one is anywhere within its limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Possible {
    /// Which part was measured.
    pub feature: Feature,
    /// Its measured diameter.
    pub measured: Length,
    /// Its verdict alone.
    pub verdict: Verdict,
    /// The smallest clearance with a good counterpart.
    pub minimum: Length,
    /// The largest clearance with a good counterpart.
    pub maximum: Length,
}

impl Possible {
    /// The clearances that one measured part leaves possible when its counterpart is within its limits.
    pub fn of(fit: &Fit, feature: Feature, measured: Length) -> Self {
        let (limits, minimum, maximum) = match feature {
            Feature::Hole => {
                let clearance = |shaft| measured.saturating_sub(shaft);
                (fit.hole(), clearance(fit.shaft().maximum()), clearance(fit.shaft().minimum()))
            }
            Feature::Shaft => {
                let clearance = |hole: Length| hole.saturating_sub(measured);
                (fit.shaft(), clearance(fit.hole().minimum()), clearance(fit.hole().maximum()))
            }
        };
        Self { feature, measured, verdict: judge(limits, measured, None), minimum, maximum }
    }
}
