//! Errors and warnings for a measuring log.

use std::sync::Arc;

use fitcheck_core::length::LengthError;
use fitcheck_core::message::{Located, Say};
use fitcheck_core::probing::cycle::Log;
use fitcheck_core::probing::cycles::CYCLES;

/// The most lines of a log that are not blank; a control writes some thirty.
pub(super) const MOST_LINES: usize = 1_000;

/// The longest line of a log in bytes; a control's has some hundred.
pub(super) const LONGEST_LINE: usize = 4 << 10;

/// Why a log cannot be used, and where: with a column if the error is about a single figure.
pub type LogError = Located<LogFault>;

/// What is wrong with a log. Figures appear as they were written, in the log's own unit.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "log", error)]
pub enum LogFault {
    /// There is no text.
    Empty,
    /// There is no title line.
    NoLog,
    /// Figures of a log without its title: the cycle is unknown.
    NoTitle,
    /// A measuring cycle that Fitcheck does not read.
    OtherCycle {
        /// The cycle's number.
        cycle: u16,
        /// The cycles whose logs Fitcheck reads.
        known: String,
    },
    /// The unit is neither 0 nor 1.
    Unit { given: String },
    /// A figure cannot be read.
    #[say(transparent)]
    Number(LengthError),
    /// A section has too few or too many figures.
    Count {
        section: Section,
        /// How many it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// A section is missing.
    Missing { section: Section },
    /// A figure without a label.
    NoLabel { given: String },
    /// The file ends within a figure.
    CutFigure { given: String },
    /// A maximum below its minimum.
    Swapped { maximum: String, minimum: String },
    /// The permitted positions of the centre are not symmetrical about the nominal one.
    Uneven { minimum: String, maximum: String, nominal: Arc<str> },
    /// The log's deviation is not the actual minus the nominal value.
    Deviation {
        /// The deviation of the log.
        given: String,
        actual: String,
        nominal: Arc<str>,
    },
    /// A diameter of zero or less.
    NotPositive { given: String },
    /// More lines than any log has, or a longer one.
    #[say(args(lines = MOST_LINES, bytes = LONGEST_LINE))]
    TooLong,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "log-section")]
pub enum Section {
    Nominal,
    /// Given limit values.
    Limits,
    Actual,
    Deviations,
}

impl LogFault {
    /// A cycle whose logs Fitcheck does not read, with those that it reads.
    pub(super) fn other_cycle(cycle: u16) -> Self {
        let known = CYCLES.iter().filter(|known| matches!(known.log, Log::Text(_))).map(|known| known.code);
        Self::OtherCycle { cycle, known: known.collect::<Vec<_>>().join(", ") }
    }

    pub(super) const fn at(self, line: usize) -> LogError {
        Located::in_line(line, self)
    }

    /// The text that the fault is about, as it was written; empty if the fault is about something missing.
    pub fn given(&self) -> String {
        match self {
            Self::Unit { given }
            | Self::NoLabel { given }
            | Self::CutFigure { given }
            | Self::Deviation { given, .. }
            | Self::NotPositive { given } => given.clone(),
            Self::Swapped { maximum, .. } | Self::Uneven { maximum, .. } => maximum.clone(),
            Self::Number(
                LengthError::NotANumber { text }
                | LengthError::Ambiguous { text }
                | LengthError::TooFine { text }
                | LengthError::TooLarge { text },
            ) => text.clone(),
            Self::OtherCycle { cycle, .. } => cycle.to_string(),
            Self::Number(LengthError::Empty)
            | Self::Empty
            | Self::NoLog
            | Self::NoTitle
            | Self::TooLong
            | Self::Count { .. }
            | Self::Missing { .. } => String::new(),
        }
    }
}

/// A warning about a log that can be used nevertheless, and its place.
pub type LogWarning = Located<LogWarningKind>;

/// A warning about a log that can be used nevertheless.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "log")]
pub enum LogWarningKind {
    /// No line gives the unit, as in older logs: located at the title.
    NoUnit,
    /// Day or time of the measurement is missing or not readable: located at the title.
    NoTime,
    /// Some or all deviations are missing: located at the last line of the log.
    NoDeviations,
    /// A line that could not be read and is not needed.
    Ignored { text: String },
    /// There is text before the first title.
    TextBefore,
}
