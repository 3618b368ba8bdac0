//! Why a file is not a tool table, with the place of the cell.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::{Located, Say};

use crate::control::table::TableError;

/// Why a file is not a tool table.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "tool-table", error)]
pub enum ToolTableError {
    /// It is not a table of a control.
    #[say(transparent)]
    Table(#[from] TableError),
    /// A cell or a column that cannot be used.
    #[say(transparent)]
    Cell(#[from] Located<ToolTableFault>),
}

/// What is wrong with a cell or a column.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "tool-table", error)]
pub enum ToolTableFault {
    /// A column that must be there is missing.
    NoColumn {
        /// Its name.
        column: &'static str,
    },
    /// There are no rows.
    NoTool,
    /// A cell runs into its neighbour, so either may be split wrongly.
    Touches {
        /// The column's name.
        column: &'static str,
    },
    /// A cell is not the number of a tool.
    NoNumber {
        /// The column's name.
        column: &'static str,
        /// The text found.
        given: String,
    },
    /// A number occurs twice.
    Twice { number: super::ToolNumber },
    /// A name is longer than a control takes.
    NameTooLong {
        /// The text found.
        given: String,
        /// The most characters.
        most: usize,
    },
    /// A cell is not a length.
    NoLength {
        /// The column's name.
        column: &'static str,
        /// What is wrong.
        error: LengthError,
    },
    /// A length beyond its range.
    OutOfRange {
        /// The column's name.
        column: &'static str,
        given: Length,
        /// The smallest that is allowed.
        least: Length,
        /// The largest.
        most: Length,
    },
    /// A cell does not say whether the tool is locked.
    NoLock {
        /// The text found.
        given: String,
    },
    /// A cell is not a whole number.
    NotWhole {
        /// The column's name.
        column: &'static str,
        /// The text found.
        given: String,
    },
}
