//! Errors and warnings for a table of deviations.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::{Located, Say};
use fitcheck_core::tolerance::table::TableShapeError;
use fitcheck_core::tolerance::{DeviationsError, ToleranceClass};

use crate::control::table::{TableError, TableWarning};

/// Why a table of deviations cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(error)]
pub enum DeviationError {
    /// A file is not a table.
    #[say(transparent)]
    Table(#[from] TableError),
    /// A table does not hold proper deviations.
    #[say(transparent)]
    Content(#[from] Located<DeviationFault>),
}

/// What is wrong in a table of deviations; [`Located`] gives the place.
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
    /// The lower row of a pair has another range than the upper one.
    OtherRange {
        /// The range in the upper row.
        end: Length,
        /// The range in the lower row.
        found: Length,
    },
    /// A cell does not hold a number.
    #[say(id = "deviations-column")]
    Number {
        column: String,
        /// What is wrong with it.
        error: LengthError,
    },
    /// A range has only one of its two deviations.
    Half {
        class: ToleranceClass,
        /// The range.
        end: Length,
    },
    /// Upper deviation below the lower one.
    #[say(id = "deviations-column")]
    Order {
        #[say(name = "column")]
        class: ToleranceClass,
        /// The two deviations.
        error: DeviationsError,
    },
    /// Two cells without a blank between them: a digit may belong to either.
    Touches { column: String },
    /// The parts do not fit together.
    #[say(transparent)]
    Shape(TableShapeError),
}

/// Warnings from reading tables of deviations.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "deviations")]
pub enum DeviationWarning {
    /// About the table's format.
    #[say(transparent)]
    Table(#[from] TableWarning),
    /// About its content.
    #[say(transparent)]
    Content(#[from] Located<DeviationWarningKind>),
    /// The table does not hold deviations.
    NoDeviations { file: String },
}

/// A warning about a table of deviations that could still be read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "deviations")]
pub enum DeviationWarningKind {
    /// The range column has the other spelling of NC-Solution 8255.
    RangeAlias,
    /// A name that could be a class, such as `NOTE`, with texts below it, or a block that calls it texts.
    NoNumbers {
        /// The column.
        name: String,
    },
    /// A column whose name is no class, such as `WEAR_1` or `MM`, with something in it.
    OtherColumn {
        /// The column.
        name: String,
    },
    /// A name that would be a class if all its letters had the same case.
    MixedCase {
        /// The column.
        name: String,
    },
}
