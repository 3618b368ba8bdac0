//! What can be wrong with a program, or odd about it.

use super::block::{Place, Target, Unit};
use super::reason::Reason;
use crate::message::{Message, Say};

/// Why a file is no program at all.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ProgramError {
    /// There is nothing to read.
    #[error("the program is empty")]
    Empty,
    /// More than any measuring program needs.
    #[error("the program is larger than {most} MiB")]
    TooLarge {
        /// What is allowed.
        most: usize,
    },
    /// More lines than any measuring program needs.
    #[error("the program has more than {most} lines")]
    TooManyLines {
        /// What is allowed.
        most: usize,
    },
    /// Too many bytes that no text holds.
    #[error("the file is no text: {controls} of its {bytes} bytes are no characters")]
    Binary {
        /// How many bytes are no characters.
        controls: usize,
        /// How many there are.
        bytes: usize,
    },
}

impl Say for ProgramError {
    fn message(&self) -> Message {
        match self {
            Self::Empty => Message::new("program-empty"),
            Self::TooLarge { most } => Message::new("program-too-large").text("most", most),
            Self::TooManyLines { most } => Message::new("program-too-many-lines").text("most", most),
            Self::Binary { controls, bytes } => {
                Message::new("program-binary").text("controls", controls).text("bytes", bytes)
            }
        }
    }
}

/// What is odd about a program, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {}, column {}: {what}", .place.line, .place.column)]
pub struct ProgramWarning {
    /// Where.
    pub place: Place,
    /// What.
    pub what: Oddity,
}

impl Say for ProgramWarning {
    fn message(&self) -> Message {
        Message::new("program-at")
            .text("line", self.place.line)
            .text("column", self.place.column)
            .message("what", self.what.message())
    }
}

/// What is odd about a program that can still be read.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Oddity {
    /// The first block is another one.
    #[error("the program does not begin with BEGIN PGM")]
    NoBegin,
    /// There is a second `BEGIN PGM`.
    #[error("BEGIN PGM stands here again")]
    SecondBegin,
    /// `END PGM` does not occur.
    #[error("END PGM is missing")]
    NoEnd,
    /// Beginning and end name different units.
    #[error("END PGM says {end}, BEGIN PGM says {begin}")]
    Units {
        /// The unit of `BEGIN PGM`: this one counts.
        begin: Unit,
        /// The unit of `END PGM`.
        end: Unit,
    },
    /// Something stands behind `END PGM`.
    #[error("what stands behind END PGM is not part of the program")]
    AfterEnd,
    /// Block numbers that do not rise; said once.
    #[error("block number {number} stands behind {previous}; block numbers that do not rise: {count}")]
    Numbers {
        /// The first number that does not rise.
        number: u32,
        /// The number before it.
        previous: u32,
        /// How many there are in all.
        count: usize,
    },
    /// A label is defined again; using it is an error.
    #[error("LBL {label} is already defined in line {first}")]
    LabelTwice {
        /// The label.
        label: Target,
        /// Where it is defined first.
        first: usize,
    },
    /// A quotation mark without its partner.
    #[error("the quotation mark is not closed")]
    UnclosedQuote,
    /// The file ends behind a `~`.
    #[error("the line ends in ~, but nothing follows")]
    OpenEnd,
    /// A block of a known kind that cannot be understood; it is kept as text.
    #[error("not understood: {0}")]
    NotUnderstood(Reason),
    /// Too many to list.
    #[error("{count} more remarks are not listed")]
    More {
        /// How many.
        count: usize,
    },
}

impl Say for Oddity {
    fn message(&self) -> Message {
        match self {
            Self::NoBegin => Message::new("program-no-begin"),
            Self::SecondBegin => Message::new("program-second-begin"),
            Self::NoEnd => Message::new("program-no-end"),
            Self::Units { begin, end } => Message::new("program-units").text("begin", begin).text("end", end),
            Self::AfterEnd => Message::new("program-after-end"),
            Self::Numbers { number, previous, count } => {
                Message::new("program-numbers").text("number", number).text("previous", previous).text("count", count)
            }
            Self::LabelTwice { label, first } => {
                Message::new("program-label-again").text("label", label).text("first", first)
            }
            Self::UnclosedQuote => Message::new("program-unclosed-quote"),
            Self::OpenEnd => Message::new("program-open-end"),
            Self::NotUnderstood(reason) => Message::new("program-not-understood").message("reason", reason.message()),
            Self::More { count } => Message::new("program-more").text("count", count),
        }
    }
}

/// Why a label cannot be jumped to.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum LabelFault {
    /// It does not occur.
    #[error("LBL {label} does not occur in the program")]
    Missing {
        /// The label.
        label: Target,
    },
    /// It occurs more than once.
    #[error("LBL {label} is defined twice, in line {first} and line {second}")]
    Twice {
        /// The label.
        label: Target,
        /// Where first.
        first: usize,
        /// Where again.
        second: usize,
    },
    /// `LBL 0` ends subprograms and is no place to go to.
    #[error("LBL 0 ends subprograms, nothing can jump to it")]
    Zero,
    /// The parameter has to be replaced by its value first.
    #[error("which label {label} holds is known only while the program runs")]
    Parameter {
        /// The parameter.
        label: Target,
    },
}

impl Say for LabelFault {
    fn message(&self) -> Message {
        match self {
            Self::Missing { label } => Message::new("program-label-missing").text("label", label),
            Self::Twice { label, first, second } => {
                Message::new("program-label-twice").text("label", label).text("first", first).text("second", second)
            }
            Self::Zero => Message::new("program-label-zero"),
            Self::Parameter { label } => Message::new("program-label-parameter").text("label", label),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::variables::Parameter;
    use crate::words::{Language, Words};

    #[track_caller]
    fn check(what: &(impl Say + std::fmt::Display)) {
        let (english, dutch) = (Words::new(Language::En), Words::new(Language::Nl));
        assert_eq!(english.told(what), what.to_string());
        let told = dutch.told(what);
        assert!(!told.contains("program-"), "{told}");
        assert_ne!(told, what.to_string());
    }

    #[test]
    fn every_error_and_remark_is_said_in_every_language() {
        check(&ProgramError::Empty);
        check(&ProgramError::TooLarge { most: 64 });
        check(&ProgramError::TooManyLines { most: 2_000_000 });
        check(&ProgramError::Binary { controls: 1234, bytes: 12345 });
        let label = Target::Name("LOOP".to_owned());
        for what in [
            Oddity::NoBegin,
            Oddity::SecondBegin,
            Oddity::NoEnd,
            Oddity::Units { begin: Unit::Mm, end: Unit::Inch },
            Oddity::AfterEnd,
            Oddity::Numbers { number: 5, previous: 12345, count: 3 },
            Oddity::LabelTwice { label: label.clone(), first: 1234 },
            Oddity::UnclosedQuote,
            Oddity::OpenEnd,
            Oddity::NotUnderstood(Reason::AxisTwice),
            Oddity::More { count: 1234 },
        ] {
            check(&what);
            check(&ProgramWarning { place: Place { line: 12345, column: 7 }, what });
        }
        check(&LabelFault::Missing { label: Target::Number(12345) });
        check(&LabelFault::Twice { label, first: 1, second: 2 });
        check(&LabelFault::Zero);
        check(&LabelFault::Parameter { label: Target::Parameter(Parameter::qs(5)) });
    }
}
