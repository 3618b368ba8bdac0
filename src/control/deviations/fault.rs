//! What can be wrong or odd in a table of deviations.

use crate::control::table::{TableError, TableWarning};
use crate::length::{Length, LengthError};
use crate::message::{Located, Say};
use crate::tolerance::table::TableShapeError;
use crate::tolerance::{DeviationsError, ToleranceClass};

/// Why a table of deviations cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(error)]
pub enum DeviationError {
    /// A file is no table.
    #[say(transparent)]
    Table(#[from] TableError),
    /// A table does not hold deviations as it should.
    #[say(transparent)]
    Content(#[from] Located<DeviationFault>),
}

/// What is wrong in a table of deviations; [`Located`] says where.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "deviations", error)]
pub enum DeviationFault {
    /// Both spellings of the range column.
    TwoRangeColumns,
    /// The table is in inch.
    Inch,
    /// No column with the name of a class.
    NoClass,
    /// A row without its partner.
    OddRows {
        /// How many rows there are.
        rows: usize,
    },
    /// The upper row of a pair has no range.
    NoRange,
    /// The lower row of a pair names another range than the upper one.
    OtherRange {
        /// The range in the upper row.
        end: Length,
        /// The range in the lower row.
        found: Length,
    },
    /// A cell holds no number.
    #[say(id = "deviations-column")]
    Number {
        /// The column.
        column: String,
        /// What is wrong with it.
        error: LengthError,
    },
    /// A range has one deviation of two.
    Half {
        /// The class.
        class: ToleranceClass,
        /// The range.
        end: Length,
    },
    /// Upper deviation below the lower one.
    #[say(id = "deviations-column")]
    Order {
        /// The class.
        #[say(name = "column")]
        class: ToleranceClass,
        /// The two deviations.
        error: DeviationsError,
    },
    /// Two cells without a blank between them: a figure may belong to either.
    Touches {
        /// The column.
        column: String,
    },
    /// The parts do not fit together.
    #[say(transparent)]
    Shape(TableShapeError),
}

/// What was odd while reading tables of deviations.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "deviations")]
pub enum DeviationWarning {
    /// In the table's format.
    #[say(transparent)]
    Table(#[from] TableWarning),
    /// In its content.
    #[say(transparent)]
    Content(#[from] Located<DeviationWarningKind>),
    /// A table of something else.
    NoDeviations {
        /// The file.
        file: String,
    },
}

/// What is odd in a table of deviations that was read all the same.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "deviations")]
pub enum DeviationWarningKind {
    /// The range column has the other spelling of NC-Solution 8255.
    RangeAlias,
    /// A name that could be a class, over texts.
    NoNumbers {
        /// The column.
        name: String,
    },
    /// A name that would be a class in one case of letters.
    MixedCase {
        /// The column.
        name: String,
    },
}
