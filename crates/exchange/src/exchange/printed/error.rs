//! What is wrong with a printed report, and what is said of one that was read.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::Say;

/// What is wrong with a report or a row.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "printed", error)]
pub enum PrintedFault {
    /// A figure that should be a number.
    #[say(id = "calypso-number")]
    Number {
        /// The name of its column.
        column: String,
        /// What is wrong with the number.
        reason: LengthError,
    },
    /// A row without a measured value.
    NoValue {
        /// The name of the column where it should stand.
        column: &'static str,
    },
    /// A row that ends the file without a line end.
    #[say(id = "calypso-row-cut-off")]
    CutOff,
    /// A row with bytes 0 in it.
    #[say(id = "calypso-zeros")]
    Zeros,
    /// Figures that do not stand below the names of their columns.
    Cells {
        /// How many figures there are.
        found: usize,
        /// How many columns.
        expected: usize,
    },
    /// A heading without the column of the measured values.
    NoColumn {
        /// The name of the column.
        column: &'static str,
    },
    /// Figures that stand below no heading.
    NoHeading,
    /// A dimension without a row.
    NoRows {
        /// What the report calls it.
        name: String,
    },
    /// A minus tolerance that may lie below the nominal size or above it.
    MinusSign {
        /// As the report has it.
        given: String,
    },
    /// A row of a feature that begins with a word that is not known.
    UnknownRow {
        /// The word.
        given: String,
    },
}

/// What is said of a report or a row that was read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "printed-warning")]
pub enum PrintedWarning {
    /// The report has another deviation than its figures give.
    Deviation {
        given: Length,
        /// What the figures make.
        expected: Length,
    },
    /// The report has another length beyond the tolerance than its figures give.
    Beyond {
        given: Length,
        /// What the figures make.
        expected: Length,
    },
    /// The line that ends the report is missing.
    NoEnd {
        /// The line.
        end: &'static str,
    },
    /// The report says that something is out of its limits which has none here.
    OutOfPlace {
        /// As the report says it.
        given: String,
    },
    /// Lines that are no measurement.
    Lines {
        /// How many.
        count: usize,
        /// The first one.
        text: String,
    },
}

impl PrintedWarning {
    /// As [`ImportWarningKind::stands_against`](crate::exchange::ImportWarningKind::stands_against).
    pub const fn stands_against(&self) -> bool {
        match self {
            Self::Deviation { .. } | Self::Beyond { .. } | Self::NoEnd { .. } | Self::OutOfPlace { .. } => true,
            Self::Lines { .. } => false,
        }
    }
}
