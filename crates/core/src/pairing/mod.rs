//! Which measured holes go with which measured shafts: selective assembly.
//!
//! | file | what |
//! |---|---|
//! | here | the wanted clearances |
//! | `wanted` | those that a search may choose from |
//! | `matching` | as many pairs as possible |
//! | `closest` | of all ways to make as many, the one closest to the middle |
//! | `groups` | sorting into groups of equal width, for those who assemble from bins |
//! | `leftovers` | the amount of grinding that saves most of what is left over |
//!
//! Sizes come in as lengths and go out as positions in the given lists; names, files and texts are the caller's. A
//! clearance is hole minus shaft; a negative one is an interference.

mod closest;
mod groups;
mod leftovers;
mod matching;
mod wanted;

use std::str::FromStr;

pub use groups::{Group, Groups, MOST_GROUPS, Range, Ranges, groups};
pub use leftovers::{Grinding, MOST_AMOUNTS, Saving, grinding};
pub use matching::{Pair, Pairing, pair};

use crate::length::{Length, LengthError};
use crate::message::Say;
use crate::tolerance::Feature;

/// The clearances that a pair may have, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PairClearances {
    minimum: Length,
    maximum: Length,
}

/// Why parts cannot be paired or sorted as asked.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "pairing", error)]
pub enum PairingError {
    /// A text that is not two lengths with two points between them.
    NotARange {
        /// What was given.
        given: String,
    },
    /// The smallest clearance cannot be read.
    Minimum(#[say(name = "reason")] LengthError),
    /// The largest clearance cannot be read.
    Maximum(#[say(name = "reason")] LengthError),
    /// The smallest clearance is larger than the largest one.
    Swapped {
        /// The first.
        minimum: Length,
        /// The second.
        maximum: Length,
    },
    /// Sizes that are too close together for so many groups.
    TooNarrow {
        /// Holes or shafts.
        feature: Feature,
        /// The smallest.
        from: Length,
        /// The largest.
        to: Length,
        /// How many groups were asked for.
        count: usize,
    },
    /// No groups, or more than are made.
    #[say(args(most = MOST_GROUPS))]
    GroupCount {
        /// How many were asked for.
        count: usize,
    },
    /// No sizes to sort.
    NoSizes {
        /// Holes or shafts.
        feature: Feature,
    },
}

impl PairClearances {
    /// Clearances from the smallest to the largest.
    ///
    /// # Errors
    /// [`PairingError::Swapped`] where the smallest is larger than the largest.
    pub fn new(minimum: Length, maximum: Length) -> Result<Self, PairingError> {
        if maximum < minimum {
            return Err(PairingError::Swapped { minimum, maximum });
        }
        Ok(Self { minimum, maximum })
    }

    /// The smallest clearance that a pair may have.
    pub const fn minimum(self) -> Length {
        self.minimum
    }

    /// The largest clearance that a pair may have.
    pub const fn maximum(self) -> Length {
        self.maximum
    }

    /// Whether a pair may have this clearance.
    pub fn allows(self, clearance: Length) -> bool {
        self.minimum <= clearance && clearance <= self.maximum
    }

    /// The width of the smallest band around the middle that a clearance lies in: twice its distance from the middle, and
    /// so a whole number of nanometres also where the middle is none.
    pub fn band(self, clearance: Length) -> Length {
        let below = clearance.saturating_sub(self.minimum);
        let above = self.maximum.saturating_sub(clearance);
        below.saturating_sub(above).abs()
    }
}

/// `0.010..0.030` in millimetres, or with units: `-20 µm..-5 µm`.
impl FromStr for PairClearances {
    type Err = PairingError;

    fn from_str(text: &str) -> Result<Self, PairingError> {
        let not_a_range = || PairingError::NotARange { given: crate::message::shortened(text, 40) };
        let (minimum, maximum) = text.split_once("..").ok_or_else(not_a_range)?;
        let minimum = minimum.parse().map_err(PairingError::Minimum)?;
        Self::new(minimum, maximum.parse().map_err(PairingError::Maximum)?)
    }
}
