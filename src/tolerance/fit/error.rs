//! Why two limits are no fit.

use crate::length::{Length, signed_mm};
use crate::words::{Message, Say};

/// Why two limits are no fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum FitError {
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
