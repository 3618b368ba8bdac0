//! Why a callout or two limits are not a fit.

use crate::length::Length;
use crate::message::Say;
use crate::tolerance::callout::Callout;
use crate::tolerance::sources::LimitsError;

/// Why a callout or two limits are not a fit.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "fit", error)]
pub enum FitError {
    /// The callout does not have two classes.
    OneSided {
        /// What was given.
        callout: Callout,
    },
    /// A part has no limits.
    #[say(transparent)]
    Limits(#[from] LimitsError),
    /// The first limits are those of a shaft.
    NotAHole {
        /// Lower limit of size.
        minimum: Length,
        /// Upper limit of size.
        maximum: Length,
    },
    /// The second limits are those of a hole.
    NotAShaft {
        /// Lower limit of size.
        minimum: Length,
        /// Upper limit of size.
        maximum: Length,
    },
    /// The nominal sizes differ.
    NominalSizes {
        /// The hole's.
        hole: Length,
        /// The shaft's.
        shaft: Length,
    },
    /// A clearance is beyond what a length holds.
    TooLarge,
}
