//! What a measured deviation says about the tool that made the surface (Q330). Which tool that is, and what its table
//! says, is not known here.

use super::result::CycleResult;
use crate::length::Length;
use crate::tolerance::Feature;

/// How much too long or too large a tool cuts, with the sign in which its table adds it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Correction {
    /// The dimension of the tool.
    pub of: Corrected,
    /// What is added to its delta value: plus is oversize.
    pub by: Length,
}

/// A dimension of a tool that measuring cycles correct.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corrected {
    /// The radius, DR.
    Radius,
    /// The length, DL.
    Length,
}

impl Correction {
    /// The radius, by the deviation of a size that the tool has left on both sides: half of it. A hole that is too small
    /// was cut by a tool that cuts small, and so was a shaft that is too large. A half nanometre goes to the larger.
    pub(in crate::probing) fn of_size(feature: Feature, deviation: Length) -> Self {
        let half = Length::ZERO.midpoint(deviation);
        Self { of: Corrected::Radius, by: if feature == Feature::Hole { half } else { half.negated() } }
    }
}

/// How a cycle corrects a tool: from its result. `None` for a cycle without a tool, and where the result has no
/// deviation.
pub type Corrects = fn(&CycleResult) -> Option<Correction>;
