//! What can be wrong or odd in a table of deviations.

use std::path::PathBuf;

use crate::control::table::{Located, TableError, TableWarning};
use crate::files::FileError;
use crate::length::{Length, LengthError, signed_mm};
use crate::message::{Message, Say};
use crate::tolerance::table::TableShapeError;
use crate::tolerance::{DeviationsError, ToleranceClass};

/// Why tables of deviations cannot be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum DeviationError {
    /// The folder or a file in it cannot be read.
    #[error(transparent)]
    File(#[from] FileError),
    /// A file is no table.
    #[error(transparent)]
    Table(#[from] TableError),
    /// A table does not hold deviations as it should.
    #[error(transparent)]
    Content(#[from] Located<DeviationFault>),
    /// There is no table of deviations in the folder.
    #[error("no table of deviations (*.tab with a column BEREICH) in this folder: {}", folder.display())]
    NoTables {
        /// The folder.
        folder: PathBuf,
    },
}

impl Say for DeviationError {
    fn message(&self) -> Message {
        match self {
            Self::File(error) => error.message(),
            Self::Table(error) => error.message(),
            Self::Content(error) => error.message(),
            Self::NoTables { folder } => Message::new("deviations-no-tables").text("folder", folder.display()),
        }
    }
}

/// What is wrong in a table of deviations; [`Located`] says where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum DeviationFault {
    /// Both spellings of the range column.
    #[error("BEREICH and BEREIK are both there: only one can hold the size ranges")]
    TwoRangeColumns,
    /// The table is in inch.
    #[error("the table is in inch: write size ranges in millimetres and deviations in micrometres")]
    Inch,
    /// No column with the name of a class.
    #[error("no column is a tolerance class such as H7")]
    NoClass,
    /// A row without its partner.
    #[error("the number of rows is odd, {rows}: each size range takes two: upper deviation, lower deviation")]
    OddRows {
        /// How many rows there are.
        rows: usize,
    },
    /// The upper row of a pair has no range.
    #[error("the end of the size range is missing")]
    NoRange,
    /// The lower row of a pair names another range than the upper one.
    #[error("the size range up to {end} mm has {found} in its second row: repeat it or leave it blank")]
    OtherRange {
        /// The range in the upper row.
        end: Length,
        /// The range in the lower row.
        found: Length,
    },
    /// A cell holds no number.
    #[error("column {column}: {error}")]
    Number {
        /// The column.
        column: String,
        /// What is wrong with it.
        error: LengthError,
    },
    /// A range has one deviation of two.
    #[error("column {class} has only one of the two deviations for the size range up to {end} mm")]
    Half {
        /// The class.
        class: ToleranceClass,
        /// The range.
        end: Length,
    },
    /// Upper deviation below the lower one.
    #[error("column {class}: {error}")]
    Order {
        /// The class.
        class: ToleranceClass,
        /// The two deviations.
        error: DeviationsError,
    },
    /// Two cells without a blank between them: a figure may belong to either.
    #[error("column {column} and its neighbour run into each other: keep them apart by a blank")]
    Touches {
        /// The column.
        column: String,
    },
    /// The parts do not fit together.
    #[error("{0}")]
    Shape(TableShapeError),
}

impl Say for DeviationFault {
    fn message(&self) -> Message {
        match self {
            Self::TwoRangeColumns => Message::new("deviations-two-range-columns"),
            Self::Inch => Message::new("deviations-inch"),
            Self::NoClass => Message::new("deviations-no-class"),
            Self::OddRows { rows } => Message::new("deviations-odd-rows").text("rows", rows),
            Self::NoRange => Message::new("deviations-no-range"),
            Self::OtherRange { end, found } => {
                let message = Message::new("deviations-other-range").mm("end", *end);
                signed_mm(message, "found-sign", "found", *found)
            }
            Self::Number { column, error } => in_column(column, error),
            Self::Half { class, end } => Message::new("deviations-half").text("class", class).mm("end", *end),
            Self::Order { class, error } => in_column(class.as_str(), error),
            Self::Touches { column } => Message::new("deviations-touch").text("column", column),
            Self::Shape(error) => error.message(),
        }
    }
}

fn in_column(column: &str, error: &impl Say) -> Message {
    Message::new("deviations-column").text("column", column).message("error", error.message())
}

/// What was odd while reading tables of deviations.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum DeviationWarning {
    /// In the table's format.
    #[error(transparent)]
    Table(#[from] TableWarning),
    /// In its content.
    #[error(transparent)]
    Content(#[from] Located<DeviationDoubt>),
    /// A table of something else.
    #[error("no table of deviations, for it has no column BEREICH; skipped: {file}")]
    NoDeviations {
        /// The file.
        file: String,
    },
}

impl Say for DeviationWarning {
    fn message(&self) -> Message {
        match self {
            Self::Table(warning) => warning.message(),
            Self::Content(warning) => warning.message(),
            Self::NoDeviations { file } => Message::new("deviations-none").text("file", file),
        }
    }
}

/// What is odd in a table of deviations that was read all the same.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum DeviationDoubt {
    /// The range column has the seed's other spelling.
    #[error("BEREIK was read as BEREICH")]
    RangeAlias,
    /// A name that could be a class, over texts.
    #[error("column {name} holds no numbers and was skipped")]
    NoNumbers {
        /// The column.
        name: String,
    },
    /// A name that would be a class in one case of letters.
    #[error("column {name} mixes upper and lower case, so it is no tolerance class and was skipped")]
    MixedCase {
        /// The column.
        name: String,
    },
}

impl Say for DeviationDoubt {
    fn message(&self) -> Message {
        match self {
            Self::RangeAlias => Message::new("deviations-range-alias"),
            Self::NoNumbers { name } => Message::new("deviations-no-numbers").text("name", name),
            Self::MixedCase { name } => Message::new("deviations-mixed-case").text("name", name),
        }
    }
}
