//! What is wrong or odd with a measuring log.

use std::fmt;

use crate::length::LengthError;
use crate::message::{Message, Say};
use crate::probing::cycle::Log;
use crate::probing::cycles::CYCLES;

/// Why a log cannot be used, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {reason}")]
pub struct LogError {
    /// Line of the file, from 1.
    pub line: usize,
    /// Column of the line in characters, from 1, where the error is a single figure's.
    pub column: Option<usize>,
    /// What is wrong.
    pub reason: LogReason,
}

/// What is wrong with a log. Figures are given as they were written, in the log's own unit.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum LogReason {
    /// There is no text.
    #[error("the file is empty")]
    Empty,
    /// There is no title line.
    #[error("not a measuring log: there is no title line with the number of a measuring cycle")]
    NoLog,
    /// Figures of a log without its title: the cycle is unknown.
    #[error("the log has no title line, so its cycle is unknown")]
    NoTitle,
    /// A measuring cycle that is not read.
    #[error("logs of cycle {cycle} are not read, only those of {known}")]
    OtherCycle {
        /// The cycle's number.
        cycle: u16,
        /// The cycles whose logs are read.
        known: String,
    },
    /// The unit is neither 0 nor 1.
    #[error("type of dimension {given} is neither 0 (mm) nor 1 (inch)")]
    Unit {
        /// What was given.
        given: String,
    },
    /// A figure cannot be read.
    #[error("{0}")]
    Number(LengthError),
    /// A section has too few or too many figures.
    #[error("{section}: expected {expected}, found {found}")]
    Count {
        /// The section.
        section: Section,
        /// How many it has.
        found: usize,
        /// How many it should have.
        expected: usize,
    },
    /// A section is missing.
    #[error("{section} is missing: the log is cut off or incomplete")]
    Missing {
        /// The section.
        section: Section,
    },
    /// A figure without a label.
    #[error("{given} has no label before it")]
    NoLabel {
        /// What was given.
        given: String,
    },
    /// The file ends within a figure.
    #[error("the file ends within this value: {given} may be incomplete")]
    CutFigure {
        /// What was given.
        given: String,
    },
    /// A maximum below its minimum.
    #[error("maximum {maximum} is below minimum {minimum}")]
    Swapped {
        /// The maximum.
        maximum: String,
        /// The minimum.
        minimum: String,
    },
    /// The permitted positions of the centre do not lie evenly about the nominal one.
    #[error("limits {minimum} and {maximum} are not symmetrical about the nominal value {nominal}")]
    Uneven {
        /// The minimum.
        minimum: String,
        /// The maximum.
        maximum: String,
        /// The nominal value.
        nominal: String,
    },
    /// The log's deviation is not actual minus nominal value.
    #[error("deviation {given} is not actual minus nominal value, {actual} - {nominal}")]
    Deviation {
        /// The deviation of the log.
        given: String,
        /// The actual value.
        actual: String,
        /// The nominal value.
        nominal: String,
    },
    /// A diameter of zero or less.
    #[error("diameter {given} is not above 0")]
    NotPositive {
        /// What was given.
        given: String,
    },
}

/// A section of a log.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
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

impl Section {
    const fn id(self) -> &'static str {
        match self {
            Self::Nominal => "log-section-nominal",
            Self::Limits => "log-section-limits",
            Self::Actual => "log-section-actual",
            Self::Deviations => "log-section-deviations",
        }
    }
}

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Nominal => "section of nominal values",
            Self::Limits => "section of limit values",
            Self::Actual => "section of actual values",
            Self::Deviations => "section of deviations",
        })
    }
}

impl LogReason {
    /// A cycle whose logs are not read, with those whose are.
    pub(super) fn other_cycle(cycle: u16) -> Self {
        let known = CYCLES.iter().filter(|known| matches!(known.log, Log::Text(_))).map(|known| known.code);
        Self::OtherCycle { cycle, known: known.collect::<Vec<_>>().join(", ") }
    }

    pub(super) const fn at(self, line: usize) -> LogError {
        LogError { line, column: None, reason: self }
    }

    /// The text that the reason is about, as it was written; empty where it is about what is missing.
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

impl Say for LogError {
    fn message(&self) -> Message {
        Message::new("log-at-line").text("line", self.line).message("reason", self.reason.message())
    }
}

impl Say for LogReason {
    fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("log-empty"),
            Self::NoLog => Message::new("log-no-log"),
            Self::NoTitle => Message::new("log-no-title"),
            Self::OtherCycle { cycle, known } => {
                Message::new("log-other-cycle").text("cycle", cycle).text("known", known)
            }
            Self::Unit { given } => Message::new("log-unit").text("given", given),
            Self::Number(error) => Message::new("log-number").message("reason", error.message()),
            Self::Count { section, found, expected } => Message::new("log-count")
                .message("section", Message::new(section.id()))
                .text("found", found)
                .text("expected", expected),
            Self::Missing { section } => Message::new("log-missing").message("section", Message::new(section.id())),
            Self::NoLabel { given } => Message::new("log-no-label").text("given", given),
            Self::CutFigure { given } => Message::new("log-cut-figure").text("given", given),
            Self::Swapped { maximum, minimum } => {
                Message::new("log-swapped").text("maximum", maximum).text("minimum", minimum)
            }
            Self::Uneven { minimum, maximum, nominal } => {
                Message::new("log-uneven").text("minimum", minimum).text("maximum", maximum).text("nominal", nominal)
            }
            Self::Deviation { given, actual, nominal } => {
                Message::new("log-deviation").text("given", given).text("actual", actual).text("nominal", nominal)
            }
            Self::NotPositive { given } => Message::new("log-not-positive").text("given", given),
        }
    }
}

/// What is odd about a log that can be used nevertheless.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LogWarning {
    /// No line tells the unit, as in older logs.
    NoUnit {
        /// Line of the title.
        line: usize,
    },
    /// Day or time of the measurement is missing or not readable.
    NoTime {
        /// Line of the title.
        line: usize,
    },
    /// The deviations are missing in whole or in part.
    NoDeviations {
        /// The last line of the log.
        line: usize,
    },
    /// A line that was not understood and is not needed.
    Ignored {
        /// The line.
        line: usize,
        /// What it says.
        text: String,
    },
    /// There is text before the first title.
    TextBefore {
        /// The line where it begins.
        line: usize,
    },
}

impl LogWarning {
    /// The line of the file, from 1.
    pub const fn line(&self) -> usize {
        match self {
            Self::NoUnit { line }
            | Self::NoTime { line }
            | Self::NoDeviations { line }
            | Self::Ignored { line, .. }
            | Self::TextBefore { line } => *line,
        }
    }
}

impl Say for LogWarning {
    fn message(&self) -> Message {
        match self {
            Self::NoUnit { .. } => Message::new("log-no-unit"),
            Self::NoTime { .. } => Message::new("log-no-time"),
            Self::NoDeviations { .. } => Message::new("log-no-deviations"),
            Self::Ignored { text, .. } => Message::new("log-ignored").text("text", text),
            Self::TextBefore { .. } => Message::new("log-text-before"),
        }
    }
}

impl fmt::Display for LogWarning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoUnit { .. } => f.pad("no line gives the unit: millimetres assumed"),
            Self::NoTime { .. } => f.pad("date and time of the measurement are unknown"),
            Self::NoDeviations { .. } => f.pad("the deviations are missing: the log may be cut off"),
            Self::Ignored { text, .. } => write!(f, "skipped: {text}"),
            Self::TextBefore { .. } => f.pad("text before the first log was skipped"),
        }
    }
}

#[cfg(test)]
mod tests {
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
    fn every_reason_is_said_in_english_and_dutch() {
        let text = || "25.0".to_owned();
        for reason in [
            LogReason::Empty,
            LogReason::NoLog,
            LogReason::NoTitle,
            LogReason::other_cycle(430),
            LogReason::Unit { given: text() },
            LogReason::Number(LengthError::NotANumber { text: text() }),
            LogReason::Count { section: Section::Nominal, found: 2, expected: 3 },
            LogReason::Count { section: Section::Limits, found: 5, expected: 6 },
            LogReason::Missing { section: Section::Actual },
            LogReason::Missing { section: Section::Deviations },
            LogReason::NoLabel { given: text() },
            LogReason::CutFigure { given: text() },
            LogReason::Swapped { maximum: text(), minimum: text() },
            LogReason::Uneven { minimum: text(), maximum: text(), nominal: text() },
            LogReason::Deviation { given: text(), actual: text(), nominal: text() },
            LogReason::NotPositive { given: text() },
        ] {
            check(&reason);
            check(&reason.at(7));
        }
    }

    #[test]
    fn every_warning_is_said_in_english_and_dutch() {
        for warning in [
            LogWarning::NoUnit { line: 1 },
            LogWarning::NoTime { line: 1 },
            LogWarning::NoDeviations { line: 1 },
            LogWarning::Ignored { line: 1, text: "Operator: A".to_owned() },
            LogWarning::TextBefore { line: 1 },
        ] {
            check(&warning);
        }
    }
}
