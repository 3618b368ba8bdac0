//! Why a callout or two limits are no fit.

use crate::length::{Length, signed_mm};
use crate::message::{Message, Say};
use crate::tolerance::callout::Callout;
use crate::tolerance::sources::LimitsError;

/// Why a callout or two limits are no fit.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
    /// The callout has not two classes.
    #[error("{callout} is no fit: write a size, a hole class and a shaft class, such as 25 H7/g6")]
    OneSided {
        /// What was given.
        callout: Callout,
    },
    /// A part has no limits.
    #[error("{0}")]
    Limits(#[from] LimitsError),
    /// The first limits are those of a shaft.
    #[error("{minimum} to {maximum} mm are a shaft's limits, where a hole's are needed")]
    NotAHole {
        /// Lower limit of size.
        minimum: Length,
        /// Upper limit of size.
        maximum: Length,
    },
    /// The second limits are those of a hole.
    #[error("{minimum} to {maximum} mm are a hole's limits, where a shaft's are needed")]
    NotAShaft {
        /// Lower limit of size.
        minimum: Length,
        /// Upper limit of size.
        maximum: Length,
    },
    /// The nominal sizes differ.
    #[error("a fit has one nominal size: the hole has {hole} mm, the shaft {shaft} mm")]
    NominalSizes {
        /// The hole's.
        hole: Length,
        /// The shaft's.
        shaft: Length,
    },
    /// A clearance is beyond what a length holds.
    #[error("the clearance is too large")]
    TooLarge,
}

impl Say for FitError {
    fn message(&self) -> Message {
        let limits = |id, minimum, maximum| {
            let message = signed_mm(Message::new(id), "minimum-sign", "minimum", minimum);
            signed_mm(message, "maximum-sign", "maximum", maximum)
        };
        match *self {
            Self::OneSided { callout } => Message::new("fit-one-sided").text("callout", callout),
            Self::Limits(ref error) => error.message(),
            Self::NotAHole { minimum, maximum } => limits("fit-not-a-hole", minimum, maximum),
            Self::NotAShaft { minimum, maximum } => limits("fit-not-a-shaft", minimum, maximum),
            Self::NominalSizes { hole, shaft } => {
                let message = signed_mm(Message::new("fit-nominal-sizes"), "hole-sign", "hole", hole);
                signed_mm(message, "shaft-sign", "shaft", shaft)
            }
            Self::TooLarge => Message::new("fit-too-large"),
        }
    }
}
