//! Errors and warnings of a file or a row: what is wrong, and what was given.

use super::contacts::ContactsError;
use crate::control::log::{LogFault, LogWarningKind};
use crate::control::point_log::PointFault;
use crate::length::{Length, LengthError};
use crate::message::{Located, Message, Say, shortened};
use crate::tolerance::{Callout, CalloutError, Feature, LimitsError};

/// A row that could not be used. Its place has its line, or 1 for the whole file; the column is the number of the cell
/// in its row or, in a log, the character in its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportError {
    /// What is wrong.
    pub kind: ImportErrorKind,
    /// What was given there; long texts are shortened.
    pub given: String,
}

impl Say for ImportError {
    fn message(&self) -> Message {
        self.kind.message()
    }
}

/// What is wrong with a row or a file.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "exchange", error)]
pub enum ImportErrorKind {
    /// A file of Fitcheck says that the centre was out of position.
    PositionOut,
    /// A file of Fitcheck says that nothing was decided.
    Undecided {
        /// The reason that it gives.
        given: String,
    },
    /// The columns of a correction to 20 °C and the measured value contradict each other.
    Correction,
    /// There is nothing in the file.
    Empty,
    /// No format recognises the file.
    NotRecognised,
    /// Another format than the one that was expected.
    OtherFormat {
        /// The format.
        format: Message,
    },
    /// A Parquet file, and a program built without the feature `parquet`.
    ParquetUnknown,
    /// A Parquet file in a stream that has no end yet.
    ParquetStream,
    /// A Parquet file that cannot be read.
    Parquet {
        /// What is wrong with it.
        reason: String,
    },
    /// A column of a Parquet file that has columns or lists in it.
    ParquetNested {
        /// The column.
        column: String,
    },
    /// A comment that holds a measurement: a row that somebody has put aside, or one whose name begins with `#`.
    #[say(id = "exchange-warning-comment")]
    Comment,
    /// Only a header, comments or blank lines.
    NoRows,
    /// A log that cannot be used.
    #[say(transparent)]
    Log(LogFault),
    /// A measurement of cycle 444 that cannot be used.
    #[say(transparent)]
    Point(PointFault),
    /// Contacts that cannot be used.
    #[say(transparent)]
    Contacts(Box<Located<ContactsError>>),
    /// No column holds the measured values.
    NoMeasuredColumn,
    /// Several columns could have the same role.
    SeveralColumns {
        /// Which.
        role: Role,
        /// The columns, by number or name.
        columns: String,
    },
    /// The header names an unsupported unit.
    Unit {
        /// What was given.
        unit: String,
    },
    /// A required cell is missing.
    RowShort {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// More cells than columns, caused for example by a decimal comma among separating commas.
    RowLong {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A quotation mark that is not closed on its line.
    OpenQuote,
    /// A row that is too long.
    RowTooLong {
        /// The most, KiB.
        most: usize,
    },
    /// The callout cannot be read.
    Callout(#[say(name = "reason")] CalloutError),
    /// The nominal size in a column of its own cannot be read.
    Nominal(#[say(name = "reason")] LengthError),
    /// The callout and the column of nominal sizes contradict each other.
    NominalDiffers {
        /// The callout.
        callout: Callout,
        /// The other nominal size.
        nominal: Length,
    },
    /// The callout has no limits.
    #[say(transparent)]
    Limits(LimitsError),
    /// The measured value cannot be read.
    Measured(#[say(name = "reason")] LengthError),
    /// A decimal sign other than that of the rest of the column.
    DecimalSign {
        /// What was given.
        given: String,
        /// The sign of the other values.
        sign: char,
    },
    /// A cell of the column that says whether nobody measured.
    Simulated {
        /// What was given.
        given: String,
    },
    /// A diameter of zero or less.
    NotPositive {
        /// What was given.
        given: String,
    },
    /// Two cells that may be one number with a decimal comma.
    DecimalComma {
        /// The two cells together.
        joined: String,
    },
    /// A callout of a shaft among holes, or of a hole among shafts.
    OtherFeature {
        /// The callout.
        given: String,
        /// What the file should hold.
        feature: Feature,
    },
    /// The measurement of a hole or of a shaft in a log among the others.
    OtherLog {
        /// What the file should hold.
        feature: Feature,
    },
    /// A measurement that is not a size.
    NotASize(#[say(name = "what")] Message),
    /// Contacts where sizes are needed.
    ContactsNotSizes,
    /// More rows than [`MOST_ROWS`](super::imported::MOST_ROWS).
    TooManyRows {
        /// How many.
        most: usize,
    },
}

/// What a column can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "exchange-role")]
pub enum Role {
    /// Name of the part or feature.
    Id,
    /// Callout or tolerance class.
    Tolerance,
    /// Nominal size.
    Nominal,
    /// Measured value.
    Measured,
    /// Date, time or both.
    Time,
    /// Whether nobody measured.
    Simulated,
}

/// A warning about a file or row that was still used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportWarning {
    /// The line of the record or unjudged measurement that it belongs to; `None` where it is about the file.
    pub row: Option<usize>,
    /// What it says.
    pub kind: ImportWarningKind,
}

impl Say for ImportWarning {
    fn message(&self) -> Message {
        self.kind.message()
    }
}

/// What a warning says, without its place.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "exchange-warning")]
pub enum ImportWarningKind {
    /// A warning about a log.
    #[say(transparent)]
    Log(LogWarningKind),
    /// Values that a file of Fitcheck says to be at 20 °C already.
    Corrected,
    /// A file of Fitcheck whose verdicts may be by another rule.
    OtherRule,
    /// Skipped columns.
    IgnoredColumns {
        /// Their names or numbers.
        columns: String,
    },
    /// A skipped line above the measurements.
    NotUsed {
        /// The line's text.
        text: String,
    },
    /// A comment above the header that holds a measurement.
    Comment,
    /// A row that runs over several lines, within quotation marks.
    SeveralLines {
        /// How many.
        lines: usize,
    },
    /// The time cannot be read, so the time of import is used.
    Time {
        /// What was given.
        given: String,
    },
    /// There is a column for the time, and the row has none.
    NoTime,
    /// A time with an offset from UTC, which no record has.
    Offset {
        /// What was given.
        given: String,
    },
    /// The measured value ends the file, and may have had more decimals.
    CutOff {
        /// What is left of it.
        given: String,
    },
}

impl ImportWarningKind {
    /// That the cells of a line above the measurements are not used.
    pub(super) fn not_used(cells: &csv::StringRecord) -> Self {
        let text = cells.iter().map(str::trim).filter(|cell| !cell.is_empty()).collect::<Vec<_>>().join(" ");
        Self::NotUsed { text: shorten(&text) }
    }
}

/// The longest text that errors repeat, in characters.
const LONGEST_GIVEN: usize = 60;

/// A cell as errors repeat it.
pub(super) fn shorten(cell: &str) -> String {
    shortened(cell, LONGEST_GIVEN)
}
