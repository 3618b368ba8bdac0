//! Why a file is not a simulated machine or part.

use super::reading::LARGEST;
use super::{Shape, WorkpieceError};
use crate::message::Say;

/// Why a file is not a machine.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "workpiece-file", error)]
pub enum SimulationError {
    /// It is not TOML, or has other keys.
    Toml {
        /// The line.
        line: usize,
        /// The TOML reader's message, in English.
        said: String,
    },
    /// Larger than any such file.
    #[say(args(most = LARGEST >> 10))]
    TooLarge,
    /// No surface, or more than one.
    #[say(args(tables = tables()))]
    NotOne {
        /// How many there are.
        found: usize,
    },
    /// A file with `[[feature]]` tables, where one surface is wanted.
    Several,
    /// More features than a part can have.
    TooMany {
        /// What is allowed.
        most: usize,
    },
    /// Something is wrong with a feature.
    Feature {
        /// The line.
        line: usize,
        /// The character in it.
        column: usize,
        /// The feature's name.
        feature: String,
        /// What is wrong.
        fault: FeatureFault,
    },
    /// An impossible figure.
    CannotBe {
        /// The line.
        line: usize,
        /// Which figure, and what is allowed.
        error: WorkpieceError,
    },
}

/// What is wrong with a feature of a file.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "feature-fault", error)]
pub enum FeatureFault {
    /// A key or value that TOML or the table does not have.
    Toml {
        /// The TOML reader's message, in English.
        said: String,
    },
    /// There is no such kind.
    Kind {
        /// What was given.
        given: String,
        /// The kinds.
        known: String,
    },
    /// A key that the kind needs.
    NoKey {
        /// The kind.
        kind: &'static str,
        /// The key.
        key: &'static str,
    },
    /// A key that the kind does not have.
    OtherKey {
        /// The kind.
        kind: &'static str,
        /// The key.
        key: &'static str,
    },
    /// An empty or too long name.
    Name {
        /// The most characters.
        most: usize,
    },
    /// Another feature has the same name.
    SameName,
    /// An impossible figure.
    #[say(transparent)]
    Figure(WorkpieceError),
}

/// The tables of which a file has exactly one: `[bore], [stud], …`.
fn tables() -> String {
    Shape::ALL.map(|shape| format!("[{}]", shape.table())).join(", ")
}
