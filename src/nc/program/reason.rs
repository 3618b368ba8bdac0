//! Why a block of a known kind cannot be understood.

use crate::control::variables::Parameter;
use crate::message::{Message, Say};

/// Why a block cannot be understood.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Reason {
    /// The block ends too early.
    #[error("{0} is missing")]
    Missing(Wanted),
    /// Something else stands there.
    #[error("{wanted} is due, {found} is given")]
    Unexpected {
        /// What is allowed.
        wanted: Wanted,
        /// What stands there.
        found: String,
    },
    /// The block is complete, and yet goes on.
    #[error("{found} is left over")]
    Left {
        /// What stands there.
        found: String,
    },
    /// A word in a formula that is no function of it.
    #[error("{found} is no function of formulas")]
    UnknownFunction {
        /// The word.
        found: String,
    },
    /// A number that is no finite number.
    #[error("{found} is too large a number")]
    NumberSize {
        /// What stands there.
        found: String,
    },
    /// A parameter with a number that its family does not have.
    #[error("{found} is no parameter, {family} goes from 0 to {most}")]
    ParameterRange {
        /// What stands there.
        found: String,
        /// Q, QL, QR or QS.
        family: &'static str,
        /// The last one.
        most: u16,
    },
    /// A whole number beyond its range.
    #[error("{found} is too large, at most {most}")]
    Range {
        /// What stands there.
        found: String,
        /// The largest.
        most: u32,
    },
    /// A label is known when the program is read.
    #[error("{parameter} cannot name the label that begins here")]
    LabelParameter {
        /// What stands there.
        parameter: Parameter,
    },
    /// FN 9 to FN 12 each have their comparison.
    #[error("FN {number} compares with {allowed}, {found} is given")]
    Relation {
        /// The function.
        number: u32,
        /// Its word.
        allowed: &'static str,
        /// What stands there.
        found: &'static str,
    },
    /// An axis occurs twice.
    #[error("an axis is given twice")]
    AxisTwice,
    /// Brackets and functions within one another.
    #[error("brackets and functions are nested more than {most} deep")]
    TooDeep {
        /// What is allowed.
        most: usize,
    },
    /// A formula without end.
    #[error("the formula has more than {most} operands")]
    TooManyOperands {
        /// What is allowed.
        most: usize,
    },
    /// A block without end.
    #[error("the block has more than {most} characters")]
    TooLong {
        /// What is allowed.
        most: usize,
    },
    /// Formulas without end.
    #[error("formulas and long blocks hold more than {most} MiB in all")]
    TooMuch {
        /// What is allowed.
        most: usize,
    },
}

impl Say for Reason {
    fn message(&self) -> Message {
        match self {
            Self::Missing(wanted) => Message::new("program-missing").message("wanted", wanted.message()),
            Self::Unexpected { wanted, found } => {
                Message::new("program-unexpected").message("wanted", wanted.message()).text("found", found)
            }
            Self::Left { found } => Message::new("program-left-over").text("found", found),
            Self::UnknownFunction { found } => Message::new("program-unknown-function").text("found", found),
            Self::NumberSize { found } => Message::new("program-number-size").text("found", found),
            Self::ParameterRange { found, family, most } => {
                Message::new("program-parameter-range").text("found", found).text("family", family).text("most", most)
            }
            Self::Range { found, most } => Message::new("program-range").text("found", found).text("most", most),
            Self::LabelParameter { parameter } => {
                Message::new("program-label-of-parameter").text("parameter", parameter)
            }
            Self::Relation { number, allowed, found } => {
                Message::new("program-relation").text("number", number).text("allowed", allowed).text("found", found)
            }
            Self::AxisTwice => Message::new("program-axis-twice"),
            Self::TooDeep { most } => Message::new("program-too-deep").text("most", most),
            Self::TooManyOperands { most } => Message::new("program-too-many-operands").text("most", most),
            Self::TooLong { most } => Message::new("program-too-long").text("most", most),
            Self::TooMuch { most } => Message::new("program-too-much").text("most", most),
        }
    }
}

/// What is allowed at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Wanted {
    /// A word or sign of the language.
    #[error("{0}")]
    Word(&'static str),
    /// A number.
    #[error("a number")]
    Number,
    /// A number or a Q parameter.
    #[error("a number or a Q parameter")]
    Value,
    /// A parameter.
    #[error("a parameter")]
    Parameter,
    /// A Q parameter.
    #[error("a Q, QL or QR parameter")]
    NumberParameter,
    /// A QS parameter.
    #[error("a QS parameter")]
    TextParameter,
    /// A quoted text or a QS parameter.
    #[error("a quoted text or a QS parameter")]
    Text,
    /// A label.
    #[error("a label")]
    Label,
    /// A path.
    #[error("a path")]
    Path,
    /// A comparison.
    #[error("EQU, NE, GT, LT or IS")]
    Relation,
    /// A unit.
    #[error("MM or INCH")]
    Unit,
    /// What a cycle's parameter is set to.
    #[error("a value")]
    CycleValue,
}

impl Say for Wanted {
    fn message(&self) -> Message {
        match self {
            Self::Word(word) => Message::new("program-wanted-word").text("word", word),
            Self::Number => Message::new("program-wanted-number"),
            Self::Value => Message::new("program-wanted-value"),
            Self::Parameter => Message::new("program-wanted-parameter"),
            Self::NumberParameter => Message::new("program-wanted-number-parameter"),
            Self::TextParameter => Message::new("program-wanted-text-parameter"),
            Self::Text => Message::new("program-wanted-text"),
            Self::Label => Message::new("program-wanted-label"),
            Self::Path => Message::new("program-wanted-path"),
            Self::Relation => Message::new("program-wanted-relation"),
            Self::Unit => Message::new("program-wanted-unit"),
            Self::CycleValue => Message::new("program-wanted-cycle-value"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::words::{Language, Words};

    #[track_caller]
    fn check(what: &(impl Say + std::fmt::Display), is_the_same_in_dutch: bool) {
        let (english, dutch) = (Words::new(Language::En), Words::new(Language::Nl));
        assert_eq!(english.told(what), what.to_string());
        let told = dutch.told(what);
        assert!(!told.contains("program-"), "{told}");
        assert_eq!(told == what.to_string(), is_the_same_in_dutch, "{told}");
    }

    #[test]
    fn every_reason_is_said_in_every_language() {
        let found = || "Q5000".to_owned();
        for reason in [
            Reason::Missing(Wanted::Value),
            Reason::Unexpected { wanted: Wanted::Word("GOTO"), found: found() },
            Reason::Left { found: found() },
            Reason::UnknownFunction { found: found() },
            Reason::NumberSize { found: found() },
            Reason::ParameterRange { found: found(), family: "Q", most: 1999 },
            Reason::Range { found: found(), most: 65535 },
            Reason::LabelParameter { parameter: Parameter::qs(5) },
            Reason::Relation { number: 10, allowed: "NE", found: "EQU" },
            Reason::AxisTwice,
            Reason::TooDeep { most: 64 },
            Reason::TooManyOperands { most: 500 },
            Reason::TooLong { most: 65536 },
            Reason::TooMuch { most: 8 },
        ] {
            check(&reason, false);
        }
        for wanted in [
            Wanted::Number,
            Wanted::Value,
            Wanted::Parameter,
            Wanted::NumberParameter,
            Wanted::TextParameter,
            Wanted::Text,
            Wanted::Label,
            Wanted::Path,
            Wanted::Relation,
            Wanted::Unit,
            Wanted::CycleValue,
        ] {
            check(&wanted, false);
        }
        check(&Wanted::Word("GOTO"), true);
    }
}
