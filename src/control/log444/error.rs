//! What is wrong with a measurement of cycle 444 or with its page.

use crate::length::{Length, LengthError, signed_mm};
use crate::message::{Message, Say};
use crate::verdict::Status;

/// Why a page or one of its measurements cannot be used or written, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {fault}")]
pub struct PointLogError {
    /// Line of the page, from 1; where measurements are written, the number of the measurement.
    pub line: usize,
    /// What is wrong.
    pub fault: PointFault,
}

/// What is wrong with a measurement of cycle 444 or with its page.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PointFault {
    /// There is no measurement in the page.
    #[error("no log of cycle 444 here: the page holds no measurement for programs")]
    NoLog,
    /// The page holds fewer or more measurements than it says.
    #[error("the page says that it holds {expected} measurements, but it holds {found}: it is cut off or was changed")]
    Count {
        /// How many it should hold.
        expected: usize,
        /// How many it holds.
        found: usize,
    },
    /// A measurement without its end.
    #[error("the measurement has no end: the page is cut off")]
    CutOff,
    /// Not the JSON that this program writes.
    #[error("the measurement cannot be read: {what}")]
    Json {
        /// What is wrong, in English.
        what: String,
    },
    /// Written by a later program.
    #[error("version {version} of the log is not known, only up to {known}")]
    Version {
        /// The version of the page.
        version: u32,
        /// The latest known one.
        known: u32,
    },
    /// A figure cannot be read.
    #[error("{0}")]
    Number(LengthError),
    /// The normal has no direction.
    #[error("normal {given} has no direction: it needs three numbers that are not all 0")]
    Normal {
        /// What was given.
        given: String,
    },
    /// The control knows millimetres and inches.
    #[error("a log is in mm or inch, not in µm")]
    Unit,
    /// The deviation of an axis is not measured minus nominal coordinate.
    #[error("deviation {given} in {axis} is not measured minus nominal coordinate, {difference}")]
    Deviation {
        /// X, Y or Z.
        axis: &'static str,
        /// The deviation of the log.
        given: Length,
        /// What it should be.
        difference: Length,
    },
    /// The deviation along the normal is not that of the axes.
    #[error("deviation {given} along the normal does not follow from those of the axes, {along}")]
    Along {
        /// The deviation of the log.
        given: Length,
        /// What it should be.
        along: Length,
    },
    /// The largest permitted deviation is below the smallest.
    #[error("upper deviation {upper} is below lower deviation {lower}")]
    Band {
        /// The upper one.
        upper: Length,
        /// The lower one.
        lower: Length,
    },
    /// The status does not follow from deviation and tolerance.
    #[error("status {} does not follow from deviation and tolerance, {}", word(*.given), word(*.status))]
    Status {
        /// The status of the log.
        given: Option<Status>,
        /// What it should be.
        status: Option<Status>,
    },
    /// The page could not be made.
    #[error("the page cannot be made: {what}")]
    Page {
        /// What is wrong, in English.
        what: String,
    },
}

/// The word of a status for machines; a dash where there is none.
fn word(status: Option<Status>) -> &'static str {
    status.map_or("-", Status::word)
}

impl PointFault {
    pub(super) const fn at(self, line: usize) -> PointLogError {
        PointLogError { line, fault: self }
    }

    /// The figure or text that the fault is about; empty where it is about what is missing.
    pub fn given(&self) -> String {
        match self {
            Self::Number(
                LengthError::NotANumber { text }
                | LengthError::Ambiguous { text }
                | LengthError::TooFine { text }
                | LengthError::TooLarge { text },
            ) => text.clone(),
            Self::Normal { given } => given.clone(),
            Self::Deviation { given, .. } | Self::Along { given, .. } => given.to_string(),
            Self::Band { upper, .. } => upper.to_string(),
            Self::Status { given, .. } => word(*given).to_owned(),
            Self::Version { version, .. } => version.to_string(),
            Self::Count { found, .. } => found.to_string(),
            Self::Number(LengthError::Empty)
            | Self::NoLog
            | Self::CutOff
            | Self::Json { .. }
            | Self::Unit
            | Self::Page { .. } => String::new(),
        }
    }
}

impl Say for PointLogError {
    fn message(&self) -> Message {
        Message::new("log-444-at-line").text("line", self.line).message("fault", self.fault.message())
    }
}

impl Say for PointFault {
    fn message(&self) -> Message {
        let two = |message: Message, [first, second]: [(&'static str, &'static str, Length); 2]| {
            let message = signed_mm(message, first.0, first.1, first.2);
            signed_mm(message, second.0, second.1, second.2)
        };
        match self {
            Self::NoLog => Message::new("log-444-no-log"),
            Self::Count { expected, found } => {
                Message::new("log-444-count").text("expected", expected).text("found", found)
            }
            Self::CutOff => Message::new("log-444-cut-off"),
            Self::Json { what } => Message::new("log-444-json").text("what", what),
            Self::Version { version, known } => {
                Message::new("log-444-version").text("version", version).text("known", known)
            }
            Self::Number(error) => Message::new("log-number").message("reason", error.message()),
            Self::Normal { given } => Message::new("log-444-normal").text("given", given),
            Self::Unit => Message::new("log-write-unit"),
            Self::Deviation { axis, given, difference } => two(
                Message::new("log-444-deviation").text("axis", axis),
                [("given-sign", "given", *given), ("difference-sign", "difference", *difference)],
            ),
            Self::Along { given, along } => {
                two(Message::new("log-444-along"), [("given-sign", "given", *given), ("along-sign", "along", *along)])
            }
            Self::Band { upper, lower } => {
                two(Message::new("log-444-band"), [("upper-sign", "upper", *upper), ("lower-sign", "lower", *lower)])
            }
            Self::Status { given, status } => {
                Message::new("log-444-status").text("given", word(*given)).text("status", word(*status))
            }
            Self::Page { what } => Message::new("log-444-page").text("what", what),
        }
    }
}

impl From<LengthError> for PointFault {
    fn from(error: LengthError) -> Self {
        Self::Number(error)
    }
}

#[cfg(test)]
mod tests {
    use std::fmt;

    use super::*;
    use crate::words::{Language, Words};

    #[track_caller]
    fn check<T: Say + fmt::Display>(what: &T) {
        assert_eq!(Words::new(Language::En).told(what), what.to_string());
        let dutch = Words::new(Language::Nl).told(what);
        assert_ne!(dutch, what.message().id);
        assert_ne!(dutch, what.to_string(), "not translated");
    }

    #[test]
    fn every_fault_is_said_in_english_and_dutch() {
        let text = || "0.1".to_owned();
        let mm = |text: &str| text.parse::<Length>().unwrap();
        for fault in [
            PointFault::NoLog,
            PointFault::Count { expected: 3, found: 2 },
            PointFault::CutOff,
            PointFault::Json { what: text() },
            PointFault::Version { version: 2, known: 1 },
            PointFault::Number(LengthError::NotANumber { text: text() }),
            PointFault::Normal { given: text() },
            PointFault::Unit,
            PointFault::Deviation { axis: "X", given: mm("-0.1"), difference: mm("0.2") },
            PointFault::Along { given: mm("0.1"), along: mm("-0.25") },
            PointFault::Band { upper: mm("-0.1"), lower: mm("0.2") },
            PointFault::Status { given: Some(Status::Good), status: None },
            PointFault::Page { what: text() },
        ] {
            check(&fault);
            check(&fault.at(7));
        }
    }
}
