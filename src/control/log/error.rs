//! What is wrong or odd with a measuring log.

use std::sync::Arc;

use crate::length::LengthError;
use crate::message::{Located, Say};
use crate::probing::cycle::Log;
use crate::probing::cycles::CYCLES;

/// Why a log cannot be used, and where: the column is there where the error is a single figure's.
pub type LogError = Located<LogFault>;

/// What is wrong with a log. Figures are given as they were written, in the log's own unit.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "log", error)]
pub enum LogFault {
    /// There is no text.
    Empty,
    /// There is no title line.
    NoLog,
    /// Figures of a log without its title: the cycle is unknown.
    NoTitle,
    /// A measuring cycle that is not read.
    OtherCycle {
        /// The cycle's number.
        cycle: u16,
        /// The cycles whose logs are read.
        known: String,
    },
    /// The unit is neither 0 nor 1.
    Unit {
        /// What was given.
        given: String,
    },
    /// A figure cannot be read.
    #[say(transparent)]
    Number(LengthError),
    /// A section has too few or too many figures.
    Count {
        /// The section.
        section: Section,
        /// How many it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// A section is missing.
    Missing {
        /// The section.
        section: Section,
    },
    /// A figure without a label.
    NoLabel {
        /// What was given.
        given: String,
    },
    /// The file ends within a figure.
    CutFigure {
        /// What was given.
        given: String,
    },
    /// A maximum below its minimum.
    Swapped {
        /// The maximum.
        maximum: String,
        /// The minimum.
        minimum: String,
    },
    /// The permitted positions of the centre do not lie evenly about the nominal one.
    Uneven {
        /// The minimum.
        minimum: String,
        /// The maximum.
        maximum: String,
        /// The nominal value.
        nominal: Arc<str>,
    },
    /// The log's deviation is not actual minus nominal value.
    Deviation {
        /// The deviation of the log.
        given: String,
        /// The actual value.
        actual: String,
        /// The nominal value.
        nominal: Arc<str>,
    },
    /// A diameter of zero or less.
    NotPositive {
        /// What was given.
        given: String,
    },
}

/// A section of a log.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "log-section")]
pub enum Section {
    /// Nominal values.
    Nominal,
    /// Given limit values.
    Limits,
    /// Actual values.
    Actual,
    /// Deviations.
    Deviations,
}

impl LogFault {
    /// A cycle whose logs are not read, with those whose are.
    pub(super) fn other_cycle(cycle: u16) -> Self {
        let known = CYCLES.iter().filter(|known| matches!(known.log, Log::Text(_))).map(|known| known.code);
        Self::OtherCycle { cycle, known: known.collect::<Vec<_>>().join(", ") }
    }

    pub(super) const fn at(self, line: usize) -> LogError {
        Located::in_line(line, self)
    }

    /// The text that the fault is about, as it was written; empty where it is about what is missing.
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
            | Self::Count { .. }
            | Self::Missing { .. } => String::new(),
        }
    }
}

/// What is odd about a log that can be used nevertheless, and where.
pub type LogWarning = Located<LogWarningKind>;

/// What is odd about a log that can be used nevertheless.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "log")]
pub enum LogWarningKind {
    /// No line tells the unit, as in older logs: at the title.
    NoUnit,
    /// Day or time of the measurement is missing or not readable: at the title.
    NoTime,
    /// The deviations are missing in whole or in part: at the last line of the log.
    NoDeviations,
    /// A line that was not understood and is not needed.
    Ignored {
        /// What it says.
        text: String,
    },
    /// There is text before the first title.
    TextBefore,
}
