//! What is wrong with the block of a probing cycle, and where.

use fitcheck_core::message::{Located, Say};
use fitcheck_core::probing::cycle::{CycleError, Key};

/// The most parts between `~` on a line: each takes memory, also an empty one.
pub(super) const MOST_PARTS: usize = 1_000;

/// Why a block cannot be read or written, and on which line.
pub type ProbeBlockError = Located<ProbeBlockFault>;

/// What is wrong with a block.
#[derive(Debug, Clone, PartialEq, Say)]
#[say(prefix = "block", error)]
pub enum ProbeBlockFault {
    /// No block of a probing cycle.
    #[say(id = "block-none")]
    NoBlock,
    /// A second block.
    #[say(id = "block-second")]
    SecondBlock {
        /// The line of the first one.
        first: usize,
    },
    /// No block of a probing cycle has this line.
    #[say(id = "block-none-at")]
    NoBlockAt {
        /// The lines that blocks of probing cycles begin on, each with its cycle.
        blocks: String,
    },
    /// The block of a program in inches: its lengths would be taken as mm.
    #[say(id = "block-inches")]
    Inches,
    /// A cycle that Fitcheck does not have.
    UnknownCycle {
        /// What follows TCH PROBE.
        given: String,
        /// The numbers of the known cycles.
        known: String,
    },
    /// A line of the block is not a parameter.
    NotAParameter {
        /// The line without its comment.
        given: String,
        /// An example of a correct one.
        example: &'static str,
    },
    /// A parameter without a value.
    NoValue {
        /// The parameter.
        key: String,
    },
    /// A parameter is given twice.
    Twice {
        /// The parameter.
        key: Key,
        /// The line of the first one.
        first: usize,
    },
    /// A quotation mark without its partner.
    UnclosedQuote,
    /// A parameter of the cycle after the end of the block.
    BehindEnd {
        /// The line without its comment.
        given: String,
    },
    /// A line with more parts between `~` than any block has.
    #[say(args(most = MOST_PARTS))]
    TooManyParts,
    /// The last line calls for another one.
    CutOff,
    /// The value is in a parameter of a program.
    Reference {
        /// The parameter of the cycle.
        key: String,
        /// The parameter that holds its value.
        given: String,
    },
    /// The cycle does not accept the parameter or its value.
    #[say(transparent)]
    Cycle(Box<CycleError>),
    /// A text that a block cannot hold.
    NotWritable {
        /// The parameter.
        key: Key,
        given: String,
    },
}

impl ProbeBlockFault {
    pub(super) const fn at(self, line: usize) -> ProbeBlockError {
        Located::in_line(line, self)
    }
}
