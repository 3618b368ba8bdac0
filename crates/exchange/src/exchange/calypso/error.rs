//! What is wrong with a table of CALYPSO, and what is said of one that was read.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::Say;

/// What is wrong with a table or a row.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "calypso", error)]
pub enum CalypsoFault {
    /// A cell that should be a number.
    Number {
        /// The name of its column.
        column: String,
        /// What is wrong with the number.
        reason: LengthError,
    },
    /// A row without a measured value.
    NoActual,
    /// The last line is missing, so characteristics may be, too.
    CutOff,
    /// A row that ends the file without a line end.
    RowCutOff,
    /// A row with bytes 0 in it.
    Zeros,
    /// Two rows of one name with different nominal values or limits.
    Differs {
        name: String,
        /// The line of the first row.
        first: usize,
        /// The line of the second one.
        second: usize,
    },
}

/// What is said of a table or a row that was read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "calypso-warning")]
pub enum CalypsoWarning {
    /// The last line is missing.
    NoEnd,
    /// A line after the last one.
    Behind {
        /// What it says.
        given: String,
    },
    /// A line of bytes 0 alone.
    Zeros,
    /// The deviation of the table is not that of its values.
    Deviation {
        given: Length,
        /// What the values make.
        expected: Length,
    },
    /// How much the table says to be beyond the tolerance is not what its values make.
    Exceed {
        given: Length,
        /// What the values make.
        expected: Length,
    },
}

impl CalypsoWarning {
    /// As [`ImportWarningKind::stands_against`](crate::exchange::ImportWarningKind::stands_against).
    pub const fn stands_against(&self) -> bool {
        match self {
            Self::NoEnd | Self::Behind { .. } | Self::Zeros | Self::Deviation { .. } | Self::Exceed { .. } => true,
        }
    }
}
