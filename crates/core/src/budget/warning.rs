//! What to check about a budget.

use crate::length::Length;
use crate::message::{Say, printed};
use crate::tolerance::Feature;

/// What to check about a budget.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "budget-warning")]
pub enum BudgetWarning {
    /// Its last day is over.
    Expired {
        /// That day.
        until: String,
    },
    /// It is made on a later day.
    NotYet {
        /// That day.
        date: String,
    },
    /// A calibrated piece that is much smaller or larger.
    OtherSize {
        /// Its size.
        calibrated: Length,
        /// What was measured.
        measured: Length,
    },
    /// A calibrated piece of the other side.
    OtherSide {
        /// Its side.
        calibrated: Feature,
    },
    /// A contribution for another expansion than the one of the correction, in millionths per kelvin.
    OtherExpansion {
        /// Its name.
        contribution: String,
        /// The budget's.
        #[say(with = printed)]
        budget: String,
        /// The correction's.
        #[say(with = printed)]
        given: String,
    },
    /// A contribution for another temperature than the one of the correction, in kelvin from 20 °C.
    OtherTemperature {
        /// Its name.
        contribution: String,
        /// The budget's.
        #[say(with = printed)]
        budget: String,
        /// The correction's.
        #[say(with = printed)]
        given: String,
    },
    /// A study found the gauge not good enough.
    FailedStudy {
        /// Why, in the words of the study.
        why: String,
    },
    /// Some of it is what the template says, not the station.
    OfTemplate,
    /// Some of its figures are those of the template; they can be true of the station, too.
    TemplateFigures {
        /// The names of their contributions.
        contributions: String,
    },
    /// Fewer readings than ISO 15530-3 asks for.
    FewReadings {
        /// How many there are.
        readings: usize,
        /// How many it asks for.
        fewest: usize,
    },
    /// A bias by which measured values must be corrected.
    BiasCorrected {
        /// In micrometres, with its sign.
        #[say(with = printed)]
        bias: String,
    },
    /// A bias that is part of the uncertainty.
    BiasNotCorrected {
        /// In micrometres, with its sign.
        #[say(with = printed)]
        bias: String,
    },
    /// Whatever a kept record says, in English.
    Recorded {
        /// What it says.
        text: String,
    },
}

impl BudgetWarning {
    /// Whether it says only that the budget does not count on the day.
    pub const fn is_about_validity(&self) -> bool {
        matches!(self, Self::Expired { .. } | Self::NotYet { .. })
    }
}
