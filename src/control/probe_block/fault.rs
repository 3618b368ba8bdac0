//! What is wrong with the block of a probing cycle, and where.

use crate::message::{Message, Say};
use crate::probing::cycle::{CycleError, Key};

/// Why a block cannot be read or written.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("line {line}: {fault}")]
pub struct ProbeBlockError {
    /// The line, from 1.
    pub line: usize,
    /// What is wrong.
    pub fault: ProbeBlockFault,
}

/// What is wrong with a block.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ProbeBlockFault {
    /// No block of a probing cycle.
    #[error("no probing cycle here: a block begins with TCH PROBE and a number, or with G785")]
    NoBlock,
    /// A second one.
    #[error("a second probing cycle: one at a time, the first begins on line {first}")]
    SecondBlock {
        /// The line of the first one.
        first: usize,
    },
    /// A cycle that is not one of ours.
    #[error("TCH PROBE {given}: the cycles are {known}")]
    UnknownCycle {
        /// What stands behind TCH PROBE.
        given: String,
        /// The numbers of the known cycles.
        known: String,
    },
    /// A line of the block is no parameter.
    #[error("{given} is no parameter: one is written as {example}")]
    NotAParameter {
        /// The line without its comment.
        given: String,
        /// How it is done.
        example: &'static str,
    },
    /// A parameter without a value.
    #[error("{key} has no value")]
    NoValue {
        /// The parameter.
        key: String,
    },
    /// A parameter twice.
    #[error("{key} is given twice, first on line {first}")]
    Twice {
        /// The parameter.
        key: Key,
        /// The line of the first one.
        first: usize,
    },
    /// A quotation mark without its partner.
    #[error("a quotation mark is not closed")]
    UnclosedQuote,
    /// A parameter of the cycle behind the block.
    #[error("{given} stands behind the end of the block: every line but the last ends with ~")]
    BehindEnd {
        /// The line without its comment.
        given: String,
    },
    /// The last line asks for another one.
    #[error("the block ends with ~, so a line is missing: it may be cut off")]
    CutOff,
    /// The value is in a parameter of a program.
    #[error("{key} = {given}: only a running program knows what is in {given}")]
    Reference {
        /// The parameter of the cycle.
        key: String,
        /// The parameter that it is given by.
        given: String,
    },
    /// The cycle does not take the parameter or its value.
    #[error(transparent)]
    Cycle(CycleError),
    /// A text that a block cannot hold.
    #[error("{key} = {given}: a text in a block holds no quotation mark and no line end")]
    NotWritable {
        /// The parameter.
        key: Key,
        /// Its text.
        given: String,
    },
}

impl ProbeBlockFault {
    pub(super) const fn at(self, line: usize) -> ProbeBlockError {
        ProbeBlockError { line, fault: self }
    }
}

impl Say for ProbeBlockError {
    fn message(&self) -> Message {
        Message::new("block-at-line").text("line", self.line).message("fault", self.fault.message())
    }
}

impl Say for ProbeBlockFault {
    fn message(&self) -> Message {
        match self {
            Self::NoBlock => Message::new("block-none"),
            Self::SecondBlock { first } => Message::new("block-second").text("first", first),
            Self::UnknownCycle { given, known } => {
                Message::new("block-unknown-cycle").text("given", given).text("known", known)
            }
            Self::NotAParameter { given, example } => {
                Message::new("block-not-a-parameter").text("given", given).text("example", example)
            }
            Self::NoValue { key } => Message::new("block-no-value").text("key", key),
            Self::Twice { key, first } => Message::new("block-twice").text("key", key).text("first", first),
            Self::UnclosedQuote => Message::new("block-unclosed-quote"),
            Self::BehindEnd { given } => Message::new("block-behind-end").text("given", given),
            Self::CutOff => Message::new("block-cut-off"),
            Self::Reference { key, given } => Message::new("block-reference").text("key", key).text("given", given),
            Self::Cycle(error) => error.message(),
            Self::NotWritable { key, given } => {
                Message::new("block-not-writable").text("key", key).text("given", given)
            }
        }
    }
}
