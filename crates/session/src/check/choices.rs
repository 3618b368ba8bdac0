//! What is chosen on the check page, besides its text fields.

use fitcheck_core::verdict::rules::{Prover, RuleName};
use serde::{Deserialize, Serialize};

/// Where the next measurement comes from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeasureBy {
    /// A cycle on the simulated workpiece.
    Simulating,
    /// A diameter that is typed.
    #[default]
    Typing,
}

/// How the uncertainty of a measured value is told.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum UncertaintyFrom {
    #[default]
    Standard,
    /// As an expanded one, with its coverage factor.
    Expanded,
    /// By the budget in use, for each value and its contacts.
    Budget,
}

impl UncertaintyFrom {
    /// Every way.
    pub const ALL: [Self; 3] = [Self::Standard, Self::Expanded, Self::Budget];
}

/// What is chosen, besides the fields.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(default)]
pub struct RuleChoice {
    pub rule: RuleName,
    /// Who has to prove.
    pub prover: Prover,
    /// How the uncertainty is told.
    pub from: UncertaintyFrom,
}
