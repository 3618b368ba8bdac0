//! Why a block of a known kind cannot be understood.

use crate::control::variables::Parameter;
use crate::message::Say;

/// Why a block cannot be understood.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "program", error)]
pub enum BlockFault {
    /// The block ends too early.
    Missing(#[say(name = "wanted")] Wanted),
    /// Something else stands there.
    Unexpected {
        /// What is allowed.
        wanted: Wanted,
        /// What stands there.
        found: String,
    },
    /// The block is complete, and yet goes on.
    LeftOver {
        /// What stands there.
        found: String,
    },
    /// A word in a formula that is not a function of it.
    UnknownFunction {
        /// The word.
        found: String,
    },
    /// A number that is not a finite number.
    NumberSize {
        /// What stands there.
        found: String,
    },
    /// A parameter with a number that its family does not have.
    ParameterRange {
        /// What stands there.
        found: String,
        /// Q, QL, QR or QS.
        family: &'static str,
        /// The last one.
        most: u16,
    },
    /// A whole number beyond its range.
    Range {
        /// What stands there.
        found: String,
        /// The largest.
        most: u32,
    },
    /// A label is known when the program is read.
    LabelOfParameter {
        /// What stands there.
        parameter: Parameter,
    },
    /// FN 9 to FN 12 each have their comparison.
    Relation {
        /// The function.
        number: u32,
        /// Its word.
        allowed: &'static str,
        /// What stands there.
        found: &'static str,
    },
    /// An axis occurs twice.
    AxisTwice,
    /// Brackets and functions within one another.
    TooDeep {
        /// What is allowed.
        most: usize,
    },
    /// A formula without end.
    TooManyOperands {
        /// What is allowed.
        most: usize,
    },
    /// A block without end.
    TooLong {
        /// What is allowed.
        most: usize,
    },
    /// Formulas without end.
    TooMuch {
        /// What is allowed.
        most: usize,
    },
}

/// What is allowed at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "program-wanted")]
pub enum Wanted {
    /// A word or sign of the language.
    Word(#[say(name = "word")] &'static str),
    /// A number.
    Number,
    /// A number or a Q parameter.
    Value,
    /// A parameter.
    Parameter,
    /// A Q parameter.
    NumberParameter,
    /// A QS parameter.
    TextParameter,
    /// A quoted text or a QS parameter.
    Text,
    /// A label.
    Label,
    /// A path.
    Path,
    /// A comparison.
    Relation,
    /// A unit.
    Unit,
    /// What a cycle's parameter is set to.
    CycleValue,
}
