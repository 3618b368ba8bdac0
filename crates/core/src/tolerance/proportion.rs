//! Whether a zone is in proportion to its size: micrometres that were written where millimetres are read are not.
//!
//! `25 +21/0` is a drawing's `25 +0.021/0`, and read as millimetres it takes a hole of 30 mm for good. The coarsest grade there is
//! says what a zone can be: one that is wider than IT 18 of its size, or that reaches to zero, is doubted, and nothing is judged by it
//! until somebody says that it is meant. A zone of ISO 286 or ISO 2768 itself is never doubted.

use super::callout::{Callout, as_micrometres, signed, thousandths};
pub use super::coarsest::widest;
use super::deviations::Deviations;
use super::limits::Bounds;
use crate::length::Length;
use crate::message::Say;

/// Why a zone is doubted, with what was probably meant.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "zone", error)]
pub enum ZoneDoubt {
    /// Too wide, and as micrometres it would not be.
    Micrometres {
        /// How wide it is.
        width: Length,
        /// Nominal size.
        nominal: Length,
        /// IT 18 of this size.
        widest: Length,
        /// The same with micrometres.
        offer: Callout,
    },
    /// Too wide.
    Wide {
        /// How wide it is.
        width: Length,
        /// Nominal size.
        nominal: Length,
        /// IT 18 of this size.
        widest: Length,
    },
    /// Down to zero or beyond, and as micrometres it would not be.
    MicrometresToZero {
        /// The minimum limit.
        minimum: Length,
        /// The same with micrometres.
        offer: Callout,
    },
    /// Down to zero or beyond.
    ToZero {
        /// The minimum limit.
        minimum: Length,
    },
    /// Of a coordinate: wider than that of any length up to half a metre.
    CoordinateMicrometres {
        /// How wide it is.
        width: Length,
        /// The widest that is not doubted.
        widest: Length,
        /// The deviations as micrometres.
        offer: String,
    },
    /// The same where micrometres are not what was meant either.
    Coordinate {
        /// How wide it is.
        width: Length,
        /// The widest that is not doubted.
        widest: Length,
    },
}

impl ZoneDoubt {
    /// What was probably meant, where that is a callout.
    pub const fn meant(&self) -> Option<&Callout> {
        match self {
            Self::Micrometres { offer, .. } | Self::MicrometresToZero { offer, .. } => Some(offer),
            Self::Wide { .. } | Self::ToZero { .. } | Self::CoordinateMicrometres { .. } | Self::Coordinate { .. } => {
                None
            }
        }
    }

    /// What was probably meant, where that is deviations alone.
    pub const fn meant_band(&self) -> Option<&str> {
        match self {
            Self::CoordinateMicrometres { offer, .. } => Some(offer.as_str()),
            Self::Micrometres { .. }
            | Self::MicrometresToZero { .. }
            | Self::Wide { .. }
            | Self::ToZero { .. }
            | Self::Coordinate { .. } => None,
        }
    }

    /// The same where deviations were not what was written.
    #[must_use]
    pub fn without_offer(self) -> Self {
        match self {
            Self::Micrometres { width, nominal, widest, .. } => Self::Wide { width, nominal, widest },
            Self::MicrometresToZero { minimum, .. } => Self::ToZero { minimum },
            Self::CoordinateMicrometres { width, widest, .. } => Self::Coordinate { width, widest },
            other @ (Self::Wide { .. } | Self::ToZero { .. } | Self::Coordinate { .. }) => other,
        }
    }
}

/// What a coordinate counts as where it is smaller: its zero is wherever somebody put it, so it says nothing of the zone.
const COORDINATE: Length = Length::from_micrometres(500_000);

/// IT 18 of the smallest size: [`widest`] is never less.
const LEAST_WIDEST: Length = Length::from_micrometres(1_400);

/// What is doubtful about the zone of a size; nothing where it is inside IT 18 and above zero.
pub fn doubt(bounds: &Bounds) -> Option<ZoneDoubt> {
    let Bounds { nominal, .. } = *bounds;
    let width = bounds.maximum().saturating_sub(bounds.minimum());
    let deviations =
        Deviations::spanning(bounds.maximum().saturating_sub(nominal), bounds.minimum().saturating_sub(nominal));
    if bounds.minimum() <= Length::ZERO {
        let minimum = bounds.minimum();
        return Some(match as_micrometres(nominal, deviations) {
            Some(offer) => ZoneDoubt::MicrometresToZero { minimum, offer },
            None => ZoneDoubt::ToZero { minimum },
        });
    }
    // Most zones are that narrow, and millions of rows are asked about.
    if width <= LEAST_WIDEST {
        return None;
    }
    let widest = widest(nominal);
    (widest < width).then(|| match as_micrometres(nominal, deviations) {
        Some(offer) => ZoneDoubt::Micrometres { width, nominal, widest, offer },
        None => ZoneDoubt::Wide { width, nominal, widest },
    })
}

/// What is doubtful about the zone of a coordinate or of a deviation from a place, which may lie about zero.
pub fn doubt_of_coordinate(nominal: Length, deviations: Deviations) -> Option<ZoneDoubt> {
    let width = deviations.width();
    let widest = widest(nominal.abs().max(COORDINATE));
    (widest < width).then(|| match thousandths(deviations) {
        Some(meant) => {
            let offer = format!("{} {}", signed(meant.upper()), signed(meant.lower()));
            ZoneDoubt::CoordinateMicrometres { width, widest, offer }
        }
        None => ZoneDoubt::Coordinate { width, widest },
    })
}
