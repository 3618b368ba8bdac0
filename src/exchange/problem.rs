//! What is wrong or odd with a file or a row, where, and what was given.

use std::fmt;

use super::contacts::ContactsError;
use crate::control::log::{LogReason, LogWarning};
use crate::control::log444::PointFault;
use crate::length::{Length, LengthError};

use crate::message::{Message, Say};
use crate::tolerance::{Callout, CalloutError, LimitsError};

/// A row that could not be used.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}{}: {reason}", .column.map_or_else(String::new, |column| format!(", column {column}")))]
pub struct Problem {
    /// Where it is, from 1; 1 where the whole file is meant.
    pub line: usize,
    /// The number of the cell in its row, or in a log the character in its line, from 1.
    pub column: Option<usize>,
    /// What is wrong.
    pub reason: Reason,
    /// What was given there; long texts are cut.
    pub given: String,
}

impl Say for Problem {
    fn message(&self) -> Message {
        let reason = self.reason.message();
        match self.column {
            Some(column) => Message::new("exchange-at-column")
                .text("line", self.line)
                .text("column", column)
                .message("reason", reason),
            None => Message::new("exchange-at-line").text("line", self.line).message("reason", reason),
        }
    }
}

/// What is wrong with a row or a file.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Reason {
    /// There is nothing in the file.
    #[error("the file is empty")]
    Empty,
    /// No format knows the file.
    #[error("not a file of a known format")]
    NotRecognised,
    /// Only a header, comments or blank lines.
    #[error("there is no row with a measurement")]
    NoRows,
    /// A log that cannot be used.
    #[error("{0}")]
    Log(LogReason),
    /// A measurement of cycle 444 that cannot be used.
    #[error("{0}")]
    Point(PointFault),
    /// Contacts that cannot be used.
    #[error("{0}")]
    Contacts(ContactsError),
    /// No column holds the measured values.
    #[error("no column of measured values: name it in the first line, such as id;callout;measured")]
    NoMeasuredColumn,
    /// Several columns could be the same thing.
    #[error("columns {columns} may each be {role}: name them in the first line, such as id;callout;measured")]
    SeveralColumns {
        /// Which.
        role: Role,
        /// The columns, by number or name.
        columns: String,
    },
    /// The header names a unit that is not read.
    #[error("unit {unit} is not known: use mm, µm or inch")]
    Unit {
        /// What was given.
        unit: String,
    },
    /// A cell that is needed is not there.
    #[error("the row has {found} cells where {expected} are due")]
    RowShort {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// More cells than columns, as a decimal comma between separating commas makes them.
    #[error(
        "the row has {found} cells where {expected} are due: is a separator used as decimal sign or in a text, too?"
    )]
    RowLong {
        /// How many cells there are.
        found: usize,
        /// How many there should be.
        expected: usize,
    },
    /// A quotation mark that is not closed on its line.
    #[error("a quotation mark is not closed on this line")]
    OpenQuote,
    /// The callout cannot be read.
    #[error("callout: {0}")]
    Callout(CalloutError),
    /// The nominal size in a column of its own cannot be read.
    #[error("nominal size: {0}")]
    Nominal(LengthError),
    /// Callout and column of nominal sizes contradict each other.
    #[error("callout {callout} does not have the nominal size {nominal} of its own column")]
    NominalDiffers {
        /// The callout.
        callout: Callout,
        /// The other nominal size.
        nominal: Length,
    },
    /// The callout has no limits.
    #[error("{0}")]
    Limits(LimitsError),
    /// The measured value cannot be read.
    #[error("measured: {0}")]
    Measured(LengthError),
    /// The other decimal sign than in the rest of the column.
    #[error("measured: {given} has another decimal sign than the other values, {sign}")]
    DecimalSign {
        /// What was given.
        given: String,
        /// The sign of the other values.
        sign: char,
    },
    /// A diameter of zero or less.
    #[error("measured: a diameter of {given} is not above 0")]
    NotPositive {
        /// What was given.
        given: String,
    },
    /// Two cells that may be one number with a decimal comma.
    #[error("{joined} may be one number with a decimal comma: use a decimal point or another separator")]
    DecimalComma {
        /// The two cells together.
        joined: String,
    },
    /// More rows than [`MOST_ROWS`](super::imported::MOST_ROWS).
    #[error("only the first {most} rows were read: split the file")]
    TooManyRows {
        /// How many.
        most: usize,
    },
}

/// What a column can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

impl Role {
    const fn id(self) -> &'static str {
        match self {
            Self::Id => "exchange-role-id",
            Self::Tolerance => "exchange-role-tolerance",
            Self::Nominal => "exchange-role-nominal",
            Self::Measured => "exchange-role-measured",
            Self::Time => "exchange-role-time",
        }
    }
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Id => "the name",
            Self::Tolerance => "the callout",
            Self::Nominal => "the nominal size",
            Self::Measured => "the measured value",
            Self::Time => "the time",
        })
    }
}

impl Say for Reason {
    fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("exchange-empty"),
            Self::NotRecognised => Message::new("exchange-not-recognised"),
            Self::NoRows => Message::new("exchange-no-rows"),
            Self::Log(reason) => reason.message(),
            Self::Point(fault) => fault.message(),
            Self::Contacts(error) => error.message(),
            Self::NoMeasuredColumn => Message::new("exchange-no-measured-column"),
            Self::SeveralColumns { role, columns } => Message::new("exchange-several-columns")
                .text("columns", columns)
                .message("role", Message::new(role.id())),
            Self::Unit { unit } => Message::new("exchange-unit").text("unit", unit),
            Self::RowShort { found, expected } => {
                Message::new("exchange-row-short").text("found", found).text("expected", expected)
            }
            Self::RowLong { found, expected } => {
                Message::new("exchange-row-long").text("found", found).text("expected", expected)
            }
            Self::OpenQuote => Message::new("exchange-open-quote"),
            Self::Callout(error) => Message::new("exchange-callout").message("reason", error.message()),
            Self::Nominal(error) => Message::new("exchange-nominal").message("reason", error.message()),
            Self::NominalDiffers { callout, nominal } => {
                Message::new("exchange-nominal-differs").text("callout", callout).text("nominal", nominal)
            }
            Self::Limits(error) => Message::new("exchange-limits").message("reason", error.message()),
            Self::Measured(error) => Message::new("exchange-measured").message("reason", error.message()),
            Self::DecimalSign { given, sign } => {
                Message::new("exchange-decimal-sign").text("given", given).text("sign", sign)
            }
            Self::NotPositive { given } => Message::new("exchange-not-positive").text("given", given),
            Self::DecimalComma { joined } => Message::new("exchange-decimal-comma").text("joined", joined),
            Self::TooManyRows { most } => Message::new("exchange-too-many-rows").text("most", most),
        }
    }
}

/// Something odd that did not keep a file or row from being used.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Warning {
    /// Where it is, from 1.
    pub line: usize,
    /// The line of the record or unjudged measurement that it belongs to; `None` where it is about the file.
    pub row: Option<usize>,
    /// What is odd.
    pub reason: WarningReason,
}

/// What is odd.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum WarningReason {
    /// In a log.
    Log(LogWarning),
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

impl Say for WarningReason {
    fn message(&self) -> Message {
        match self {
            Self::Log(warning) => warning.message(),
            Self::IgnoredColumns { columns } => Message::new("exchange-ignored-columns").text("columns", columns),
            Self::NotUsed { text } => Message::new("exchange-not-used").text("text", text),
            Self::Comment => Message::new("exchange-comment"),
            Self::Time { given } => Message::new("exchange-time").text("given", given),
        }
    }
}

impl fmt::Display for WarningReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Log(warning) => warning.fmt(f),
            Self::IgnoredColumns { columns } => write!(f, "columns not used: {columns}"),
            Self::NotUsed { text } => write!(f, "not a measurement and not used: {text}"),
            Self::Comment => f.pad("a line that begins with # is a comment, but this one holds a measurement"),
            Self::Time { given } => write!(f, "{given} is not a date and time: time of import used"),
        }
    }
}

impl Say for Warning {
    fn message(&self) -> Message {
        Message::new("exchange-at-line").text("line", self.line).message("reason", self.reason.message())
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.reason)
    }
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

#[cfg(test)]
mod tests {
    use super::super::imported::{Coordinate, WhyUnjudged};
    use super::*;
    use crate::probing::cycle::FoundName;
    use crate::verdict::Status;
    use crate::words::{Language, Words};

    #[track_caller]
    fn check<T: Say + fmt::Display>(what: &T) {
        assert_eq!(Words::new(Language::En).told(what), what.to_string());
        let dutch = Words::new(Language::Nl).told(what);
        assert_ne!(dutch, what.message().id);
        assert_ne!(dutch, what.to_string(), "not translated");
    }

    #[test]
    fn every_reason_is_said_in_english_and_dutch() {
        let text = || "25.0".to_owned();
        let length: Length = "25.0".parse().unwrap();
        let missing = "25 Z9".parse::<Callout>().unwrap();
        for reason in [
            Reason::Empty,
            Reason::NotRecognised,
            Reason::NoRows,
            Reason::Log(LogReason::NoTitle),
            Reason::Point(PointFault::NoLog),
            Reason::Contacts(super::super::contacts::ContactsError::Empty),
            Reason::NoMeasuredColumn,
            Reason::SeveralColumns { role: Role::Id, columns: text() },
            Reason::SeveralColumns { role: Role::Tolerance, columns: text() },
            Reason::SeveralColumns { role: Role::Nominal, columns: text() },
            Reason::SeveralColumns { role: Role::Measured, columns: text() },
            Reason::SeveralColumns { role: Role::Time, columns: text() },
            Reason::Unit { unit: text() },
            Reason::RowShort { found: 1, expected: 2 },
            Reason::RowLong { found: 3, expected: 2 },
            Reason::OpenQuote,
            Reason::Nominal(LengthError::Empty),
            Reason::NominalDiffers { callout: missing, nominal: length },
            Reason::Measured(LengthError::Empty),
            Reason::DecimalSign { given: text(), sign: ',' },
            Reason::NotPositive { given: text() },
            Reason::DecimalComma { joined: text() },
            Reason::TooManyRows { most: 5 },
        ] {
            check(&reason);
            check(&Problem { line: 3, column: Some(2), reason: reason.clone(), given: text() });
            check(&Problem { line: 3, column: None, reason, given: text() });
        }
        for reason in [
            Reason::Callout("".parse::<Callout>().unwrap_err()),
            Reason::Limits(LimitsError::TooLarge { nominal: length }),
        ] {
            assert_eq!(Words::new(Language::En).told(&reason), reason.to_string());
            assert_ne!(Words::new(Language::Nl).told(&reason), reason.message().id);
        }
    }

    #[test]
    fn warnings_and_what_is_not_judged_are_said_in_english_and_dutch() {
        for reason in [
            WarningReason::Log(LogWarning::NoUnit { line: 1 }),
            WarningReason::IgnoredColumns { columns: "remark".to_owned() },
            WarningReason::NotUsed { text: "Order 7".to_owned() },
            WarningReason::Comment,
            WarningReason::Time { given: "yesterday".to_owned() },
        ] {
            check(&reason);
            check(&Warning { line: 3, row: None, reason });
        }
        let length: Length = "25.0".parse().unwrap();
        let (status, removal) = (Status::Good, None);
        let coordinate = Coordinate { cycle: "427", nominal: None, maximum: length, minimum: length, status, removal };
        for why in [
            WhyUnjudged::NoCallout,
            WhyUnjudged::NoLimits { nominal: length },
            WhyUnjudged::Coordinate(coordinate),
            WhyUnjudged::CoordinateWithoutLimits,
            WhyUnjudged::Size { what: FoundName::WIDTH, judged: coordinate },
            WhyUnjudged::SizeWithoutLimits { what: FoundName::SIDE_1 },
            WhyUnjudged::Point(coordinate),
            WhyUnjudged::PointWithoutTolerance,
            WhyUnjudged::Contacts { count: 4 },
        ] {
            check(&why);
        }
        for format in super::super::FORMATS {
            check(format);
        }
    }
}
