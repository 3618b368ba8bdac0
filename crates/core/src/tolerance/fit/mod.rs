//! Fits: a hole and a shaft of the same nominal size.
//!
//! | file | what |
//! |---|---|
//! | here | clearances and the kind of fit |
//! | `error` | why two limits are not a fit |
//! | `basis` | hole basis or shaft basis |
//! | `preferred` | the preferred fits of ISO 286-1 and the names of ANSI B4.2 |
//! | `equivalent` | the same fit in the other basis, and whether it is exactly the same |
//! | `thermal` | the clearance at another temperature |
//! | `press` | press fits: pressure, what they hold, stresses, joining temperatures |
//! | `materials` | coefficients of expansion and elasticity, built-in and the user's own |
//! | `search` | from a wanted clearance to the classes that give it |
//!
//! A clearance is a length; a negative one is an interference. The kind of a fit depends on the size and is never
//! stored for a pair of letters.

pub mod basis;
pub mod equivalent;
mod error;
pub mod materials;
pub mod preferred;
pub mod press;
pub mod search;
pub mod thermal;

pub use basis::{Basis, basis};
pub use error::FitError;

use super::callout::{Callout, Tolerance};
use super::class::Feature;
use super::limits::Limits;
use super::sources::Sources;
use crate::length::Length;
use crate::message::Say;

/// A hole and a shaft of the same nominal size.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fit {
    hole: Limits,
    shaft: Limits,
}

/// How a hole and a shaft within their limits go together, as ISO 286-1 defines it, with its extreme cases: a smallest
/// clearance of zero is still a clearance fit, a largest clearance of zero is an interference fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Say)]
#[say(prefix = "fit-kind")]
pub enum FitKind {
    /// The smallest clearance is zero or more.
    Clearance,
    /// Clearance or interference, depending on the actual parts.
    Transition,
    /// The largest clearance is zero or less, and the smallest is below zero.
    Interference,
}

impl FitKind {
    /// The kind of a fit with these clearances.
    pub fn of(minimum: Length, maximum: Length) -> Self {
        if Length::ZERO <= minimum {
            Self::Clearance
        } else if maximum <= Length::ZERO {
            Self::Interference
        } else {
            Self::Transition
        }
    }

    /// The word for machines, the same in every language.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Clearance => "clearance",
            Self::Transition => "transition",
            Self::Interference => "interference",
        }
    }
}

impl Fit {
    /// A fit of a hole and a shaft.
    ///
    /// # Errors
    /// [`FitError`] when a part is not the hole or shaft that it should be, when the nominal sizes differ, or when a
    /// clearance would be beyond what a length holds.
    pub fn new(hole: Limits, shaft: Limits) -> Result<Self, FitError> {
        if hole.feature != Some(Feature::Hole) {
            return Err(FitError::NotAHole { minimum: hole.minimum(), maximum: hole.maximum() });
        }
        if shaft.feature != Some(Feature::Shaft) {
            return Err(FitError::NotAShaft { minimum: shaft.minimum(), maximum: shaft.maximum() });
        }
        if hole.nominal != shaft.nominal {
            return Err(FitError::NominalSizes { hole: hole.nominal, shaft: shaft.nominal });
        }
        let clearances = (hole.maximum().checked_sub(shaft.minimum()), hole.minimum().checked_sub(shaft.maximum()));
        if let (Some(_), Some(_)) = clearances { Ok(Self { hole, shaft }) } else { Err(FitError::TooLarge) }
    }

    /// The fit of a callout such as `25 H7/g6`, with each part's limits from the same sources.
    ///
    /// ```
    /// use fitcheck_core::tolerance::Sources;
    /// use fitcheck_core::tolerance::fit::{Fit, FitKind};
    ///
    /// let fit = Fit::of_callout(&"50 H7/p6".parse()?, &Sources::default())?;
    /// assert_eq!((fit.minimum_clearance().to_string(), fit.kind()), ("-0.042".into(), FitKind::Interference));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`FitError::OneSided`] for a callout that is not a fit, [`FitError::Limits`] where a class is not defined.
    pub fn of_callout(callout: &Callout, sources: &Sources) -> Result<Self, FitError> {
        if !matches!(callout.tolerance(), Tolerance::Fit { .. }) {
            return Err(FitError::OneSided { callout: *callout });
        }
        let limits = |feature| sources.limits(callout, Some(feature));
        Self::new(limits(Feature::Hole)?, limits(Feature::Shaft)?)
    }

    /// The hole's limits.
    pub const fn hole(&self) -> &Limits {
        &self.hole
    }

    /// The shaft's limits.
    pub const fn shaft(&self) -> &Limits {
        &self.shaft
    }

    /// Both parts with their limits: the hole, then the shaft.
    pub const fn parts(&self) -> [(Feature, &Limits); 2] {
        [(Feature::Hole, &self.hole), (Feature::Shaft, &self.shaft)]
    }

    /// The nominal size of both.
    pub const fn nominal(&self) -> Length {
        self.hole.nominal
    }

    /// The largest clearance, ES − ei; negative when there is always interference.
    pub fn maximum_clearance(&self) -> Length {
        self.hole.maximum().saturating_sub(self.shaft.minimum())
    }

    /// The smallest clearance, EI − es; negative is the largest interference.
    pub fn minimum_clearance(&self) -> Length {
        self.hole.minimum().saturating_sub(self.shaft.maximum())
    }

    /// The clearance of two parts in the middle of their zones, with a half nanometre rounded towards the larger.
    pub fn mean_clearance(&self) -> Length {
        self.minimum_clearance().midpoint(self.maximum_clearance())
    }

    /// Clearance, transition or interference, at this size.
    pub fn kind(&self) -> FitKind {
        FitKind::of(self.minimum_clearance(), self.maximum_clearance())
    }

    /// Whether a clearance is in the range of this fit, both ends included.
    pub fn allows(&self, clearance: Length) -> bool {
        self.minimum_clearance() <= clearance && clearance <= self.maximum_clearance()
    }
}
