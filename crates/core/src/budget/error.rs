//! Why a file is not a budget.

use super::{GeometryError, brief};
use crate::length::LengthError;
use crate::message::Say;
use crate::probing::simulated::LARGEST;

/// The most contributions of a budget.
pub(super) const MOST: usize = 1_000;

/// Why a file is not a budget.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "budget", error)]
pub enum BudgetError {
    /// It is not TOML, or has other keys.
    Toml {
        /// The TOML reader's message, in English.
        said: String,
    },
    /// Larger than any such file.
    #[say(args(most = LARGEST >> 10))]
    TooLarge,
    /// Neither contributions nor a calibrated piece, or both.
    NotOne,
    /// More contributions than a budget can have.
    #[say(args(most = MOST))]
    TooMany {
        /// How many there are.
        count: usize,
    },
    /// A text that says nothing.
    Empty {
        /// Its key.
        key: &'static str,
    },
    /// Not a day.
    Day {
        /// The key.
        key: &'static str,
        /// What was given.
        given: String,
    },
    /// The last valid day is before the day on which it was made.
    Days {
        /// The day on which it was made.
        date: String,
        /// The last valid day.
        until: String,
    },
    /// A key that this table cannot have with the others that it has.
    Key {
        /// The table.
        table: String,
        /// The key.
        key: &'static str,
        /// The keys that it can have.
        allowed: String,
    },
    /// A key without which the table says nothing.
    Missing {
        /// The table.
        table: String,
        /// The key, or the keys of which one is needed.
        keys: &'static str,
    },
    /// A number out of its range.
    Range {
        /// The table.
        table: String,
        /// The key.
        key: &'static str,
        /// What was given.
        given: f64,
        /// The smallest allowed number.
        #[say(with = brief)]
        least: f64,
        /// The largest.
        #[say(with = brief)]
        most: f64,
    },
    /// A law that a display does not have.
    ResolutionLaw {
        /// The contribution.
        table: String,
    },
    /// Touches that are not on a circle.
    Geometry {
        /// The contribution.
        table: String,
        /// What is wrong.
        error: GeometryError,
    },
    /// A length that is none.
    Length {
        /// The key.
        key: &'static str,
        /// What is wrong.
        error: LengthError,
    },
}
