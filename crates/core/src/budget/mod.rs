//! Uncertainty budgets: how sure a measured value is, from the contributions of one station and probe (GUM), or from repeated
//! measurements of a calibrated piece (ISO 15530-3).
//!
//! | file | what |
//! |---|---|
//! | here | a budget, its contributions, and on which days it is valid |
//! | `file` | a budget as TOML: its keys and what is allowed |
//! | `error` | why a file is not a budget |
//! | `piece` | its table `[calibrated]` |
//! | `kinds` | the kinds of contributions, and the keys that each has |
//! | `numbers` | which keys a contribution has, and their ranges |
//! | `geometry` | how contacts spread the scatter of a touch into the diameter |
//! | `evaluation` | the table of contributions, combined and expanded uncertainty, what would help most |
//! | `coverage` | the coverage factor for 95.45 % |
//! | `doubts` | whether a budget is about what is judged with it |
//! | `template` | what a new budget begins with, and what of it still stands in another one |
//! | `calibrated` | a calibrated piece, measured again and again |
//! | `warning` | what to check about a budget |
//! | `assessment` | a budget evaluated for a day, and what is kept of it beside a verdict |
//!
//! Uncertainties are binary fractions of micrometres here; a rule gets them rounded up to the picometre. The day, the size and
//! the contacts are given: nothing here asks a clock or a file.

mod assessment;
mod calibrated;
mod coverage;
mod doubts;
mod error;
mod evaluation;
mod file;
mod geometry;
mod kinds;
mod numbers;
mod piece;
pub mod template;
mod warning;

pub use assessment::{Answer, Assessment, AssessmentError, Provenance};
pub use calibrated::{Calibrated, CalibratedError, FEWEST_READINGS, Repeated};
pub use coverage::{PROBABILITY, factor, student};
pub use error::BudgetError;
pub use evaluation::{Conditions, ContributionRow, Evaluation, EvaluationError, Help};
pub use geometry::{Geometry, GeometryError};
pub use kinds::{Keys, KindName};
pub use warning::BudgetWarning;

use jiff::civil::Date;
use serde::Deserialize;

use crate::length::without_zeros;
use crate::message::{Arg, IntoArg as _};
use crate::verdict::rules::{Uncertainty, UncertaintyError};

/// A budget of one station and probe.
#[derive(Debug, Clone, PartialEq)]
pub struct Budget {
    /// Which station and probe.
    pub name: String,
    /// When it was made.
    pub date: Date,
    /// Who made it.
    pub by: String,
    /// The last day on which it counts.
    pub valid_until: Date,
    /// Why a study found the gauge not good enough, where one did: that is told with every check.
    pub failed_study: Option<String>,
    /// What it is made of.
    pub basis: Basis,
}

/// What a budget is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Basis {
    /// Contributions, combined as in the GUM.
    Contributions(Vec<Contribution>),
    /// Repeated measurements of a calibrated piece.
    Calibrated(Calibrated),
}

/// One contribution to a budget.
#[derive(Debug, Clone, PartialEq)]
pub struct Contribution {
    /// What it comes from.
    pub name: String,
    /// How it was evaluated.
    pub evaluated: Evaluated,
    /// The law of its values.
    pub law: Law,
    /// What it does to the diameter.
    pub kind: ContributionKind,
    /// Its standard uncertainty: kelvin for temperatures, µm/(m K) for expansions, otherwise micrometres.
    pub u: f64,
    /// By what it is multiplied besides what its kind says.
    pub sensitivity: f64,
    /// Its degrees of freedom; `None` where they are infinite.
    pub degrees_of_freedom: Option<f64>,
}

/// How a contribution was evaluated (GUM 4.2, 4.3).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Deserialize)]
pub enum Evaluated {
    /// By statistics of a series of observations.
    A,
    /// By other means.
    B,
}

impl Evaluated {
    /// Its letter.
    pub const fn letter(self) -> &'static str {
        match self {
            Self::A => "A",
            Self::B => "B",
        }
    }
}

/// The law of a contribution's values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Law {
    /// Given as a standard or an expanded uncertainty.
    Normal,
    /// Every value within the half width is as probable.
    Rectangular,
    /// The ends are more probable than the middle.
    UShaped,
    /// The middle is more probable than the ends.
    Triangular,
}

impl Law {
    /// Every law.
    pub const ALL: [Self; 4] = [Self::Normal, Self::Rectangular, Self::UShaped, Self::Triangular];

    /// Its name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::Rectangular => "rectangular",
            Self::UShaped => "u-shaped",
            Self::Triangular => "triangular",
        }
    }

    /// By what a half width is divided for the standard uncertainty: √3, √2, √6.
    fn divisor(self) -> f64 {
        match self {
            Self::Normal => 1.0,
            Self::Rectangular => 3_f64.sqrt(),
            Self::UShaped => 2_f64.sqrt(),
            Self::Triangular => 6_f64.sqrt(),
        }
    }
}

/// What a contribution does to the diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContributionKind {
    /// Nothing but its sensitivity.
    Plain,
    /// The scatter of one touch, multiplied by the geometry factor of the contacts: those given here, unless others were taken.
    Scatter(Option<Geometry>),
    /// The temperature of the part: multiplied by the size and its expansion per kelvin.
    PartTemperature(f64),
    /// The temperature of the machine's scales: the same with their expansion.
    ScaleTemperature(f64),
    /// The expansion of the part per kelvin: multiplied by the size and by how far the temperature is from 20 °C.
    PartExpansion(f64),
    /// That of the machine's scales.
    ScaleExpansion(f64),
    /// The step of the display, half of it to either side.
    Resolution,
}

/// Whether a budget counts on a day.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Validity {
    /// It does.
    Valid,
    /// Its last day is over.
    Expired,
    /// It is made on a later day.
    NotYet,
}

impl Validity {
    /// Its word for programs.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Valid => "valid",
            Self::Expired => "expired",
            Self::NotYet => "not-yet-valid",
        }
    }
}

impl ContributionKind {
    /// Whether it depends on the measured size.
    pub const fn grows_with_size(self) -> bool {
        match self {
            Self::PartTemperature(_) | Self::ScaleTemperature(_) | Self::PartExpansion(_) | Self::ScaleExpansion(_) => {
                true
            }
            Self::Plain | Self::Scatter(_) | Self::Resolution => false,
        }
    }
}

impl Budget {
    /// Whether it counts on a day; the first and the last day belong to it.
    pub fn validity(&self, day: Date) -> Validity {
        if self.valid_until < day {
            Validity::Expired
        } else if day < self.date {
            Validity::NotYet
        } else {
            Validity::Valid
        }
    }
}

/// What a rule gets: micrometres rounded up to the picometre, and the coverage factor.
///
/// # Errors
/// [`UncertaintyError`] where a rule has no place for it: a metre and more, or a coverage factor above 10.
pub fn uncertainty(u: f64, k: f64) -> Result<Uncertainty, UncertaintyError> {
    // A thousandth of a picometre is rounding of the sum.
    let picometres = (u * 1e6 - 1e-3).ceil().max(1.0);
    let k = Uncertainty::factor(&format!("{k:.3}"))?;
    Ok(Uncertainty::standard(&format!("{:.6}", picometres / 1e6))?.covered(k))
}

/// A computed value as a text has it: with at most six decimals.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "as `say(with)` calls it")]
fn brief(value: &f64) -> Arg {
    brief_of(*value).arg()
}

fn brief_of(value: f64) -> String {
    without_zeros(&format!("{value:.6}")).to_owned()
}

/// A count as a number to compute with.
fn count(number: usize) -> f64 {
    f64::from(u32::try_from(number).unwrap_or(u32::MAX))
}
