//! What is wrong or odd with a file or a row, where, and what was given.

use super::contacts::ContactsError;
use crate::control::log::{LogFault, LogWarningKind};
use crate::control::point_log::PointFault;
use crate::length::{Length, LengthError};
use crate::message::{Located, Message, Say};
use crate::tolerance::{Callout, CalloutError, LimitsError};

/// A row that could not be used. Its place is its line, 1 where the whole file is meant, and as the column the number of
/// the cell in its row, or in a log the character in its line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// What is wrong.
    pub reason: Reason,
    /// What was given there; long texts are cut.
    pub given: String,
}

impl Say for Problem {
    fn message(&self) -> Message {
        self.reason.message()
    }
}

/// What is wrong with a row or a file.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "exchange", error)]
pub enum Reason {
    /// There is nothing in the file.
    Empty,
    /// No format knows the file.
    NotRecognised,
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
    /// Several columns could be the same thing.
    SeveralColumns {
        /// Which.
        role: Role,
        /// The columns, by number or name.
        columns: String,
    },
    /// The header names a unit that is not read.
    Unit {
        /// What was given.
        unit: String,
    },
    /// A cell that is needed is not there.
    RowShort {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// More cells than columns, as a decimal comma between separating commas makes them.
    RowLong {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A quotation mark that is not closed on its line.
    OpenQuote,
    /// The callout cannot be read.
    Callout(#[say(name = "reason")] CalloutError),
    /// The nominal size in a column of its own cannot be read.
    Nominal(#[say(name = "reason")] LengthError),
    /// Callout and column of nominal sizes contradict each other.
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
    /// The other decimal sign than in the rest of the column.
    DecimalSign {
        /// What was given.
        given: String,
        /// The sign of the other values.
        sign: char,
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
}

/// Something odd that did not keep a file or row from being used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Warning {
    /// The line of the record or unjudged measurement that it belongs to; `None` where it is about the file.
    pub row: Option<usize>,
    /// What is odd.
    pub reason: WarningReason,
}

impl Say for Warning {
    fn message(&self) -> Message {
        self.reason.message()
    }
}

/// What is odd.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "exchange-warning")]
pub enum WarningReason {
    /// In a log.
    #[say(transparent)]
    Log(LogWarningKind),
    /// Columns that are not used.
    IgnoredColumns {
        /// Their names or numbers.
        columns: String,
    },
    /// A line above the measurements.
    NotUsed {
        /// What it says.
        text: String,
    },
    /// A comment that holds a measurement.
    Comment,
    /// The time cannot be read, so the time of import is used.
    Time {
        /// What was given.
        given: String,
    },
}

/// The longest text that errors repeat, in characters.
const LONGEST_GIVEN: usize = 60;

/// A cell as errors repeat it: a long one is cut, control characters are made visible, and what was changed can no
/// longer be read as a number or callout.
pub(super) fn shorten(cell: &str) -> std::borrow::Cow<'_, str> {
    if cell.contains(char::is_control) {
        let visible = cell.replace(char::is_control, "\u{fffd}");
        return shorten(&visible).into_owned().into();
    }
    match cell.char_indices().nth(LONGEST_GIVEN).and_then(|(end, _)| cell.get(..end)) {
        Some(short) => format!("{short}…").into(),
        None => cell.into(),
    }
}
