//! What is wrong with a measurement of cycle 444 or with its page.

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::{Located, Say};
use fitcheck_core::verdict::Status;

/// Why a page or one of its measurements cannot be used or written, and where: the line of the page or, when
/// measurements are written, the number of the measurement.
pub type PointLogError = Located<PointFault>;

/// What is wrong with a measurement of cycle 444 or with its page.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "point-log", error)]
pub enum PointFault {
    /// There is no measurement in the page.
    NoLog,
    /// The page holds fewer or more measurements than it announces.
    Count {
        /// How many it should hold.
        expected: usize,
        /// How many it holds.
        found: usize,
    },
    /// A measurement without its end.
    CutOff,
    /// Not the JSON that Fitcheck writes.
    Json {
        /// What is wrong, in English.
        what: String,
    },
    /// Written by a later version of Fitcheck.
    Version {
        /// The version of the page.
        version: u32,
        /// The latest known one.
        known: u32,
    },
    /// A figure cannot be read.
    #[say(transparent)]
    Number(#[from] LengthError),
    /// The normal does not have a direction.
    Normal { given: String },
    /// The control has only millimetres and inches.
    #[say(id = "log-write-unit")]
    Unit,
    /// The deviation of an axis is not the measured minus the nominal coordinate.
    Deviation {
        /// X, Y or Z.
        axis: &'static str,
        /// The deviation of the log.
        given: Length,
        /// What it should be.
        difference: Length,
    },
    /// The deviation along the normal does not follow from those of the axes.
    Along {
        /// The deviation of the log.
        given: Length,
        /// What it should be.
        along: Length,
    },
    /// The largest permitted deviation is below the smallest.
    Band { upper: Length, lower: Length },
    /// The status does not follow from deviation and tolerance.
    #[say(args(given = word(*given), status = word(*status)))]
    Status {
        /// The status of the log.
        #[say(skip)]
        given: Option<Status>,
        /// What it should be.
        #[say(skip)]
        status: Option<Status>,
    },
}

/// The word of a status for machines; a dash where there is none.
fn word(status: Option<Status>) -> &'static str {
    status.map_or("-", Status::word)
}

impl PointFault {
    pub(super) const fn at(self, line: usize) -> PointLogError {
        Located::in_line(line, self)
    }

    /// The figure or text that the fault is about; empty if the fault is about something missing.
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
            Self::Number(LengthError::Empty) | Self::NoLog | Self::CutOff | Self::Json { .. } | Self::Unit => {
                String::new()
            }
        }
    }
}
