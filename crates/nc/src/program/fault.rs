//! Why a block of a known kind cannot be understood.

use fitcheck_core::message::Say;

use crate::control::variables::Parameter;

/// Why a block cannot be understood.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "program", error)]
pub enum BlockFault {
    /// The block ends too early.
    Missing(#[say(name = "wanted")] ExpectedWord),
    /// Something else was found.
    Unexpected {
        /// What is allowed.
        wanted: ExpectedWord,
        found: String,
    },
    /// The block is complete, but text follows.
    LeftOver { found: String },
    /// `S6000` in a straight line: the speed stands in TOOL CALL.
    SpeedInMove { found: String },
    /// A word in a formula that is not one of its functions.
    UnknownFunction {
        /// The word.
        found: String,
    },
    /// A number that is not a finite number.
    NumberSize { found: String },
    /// A parameter number that its family does not have.
    ParameterRange {
        found: String,
        /// Q, QL, QR or QS, or that of a lathe control.
        family: &'static str,
        /// The first number.
        least: u16,
        /// The last number.
        most: u16,
    },
    /// `AND` and `OR` in one condition, without brackets that say which comes first.
    AndWithOr,
    /// An address letter occurs twice.
    LetterTwice { letters: String },
    /// Another unit than the one that was said before.
    SecondUnit,
    /// A measurement or an assignment among the blocks of a unit, which are passed over.
    ActsInUnit,
    /// A block of a unit that may shift the zero point.
    ShiftsInUnit,
    /// A branch without the block that ends or begins it.
    Alone {
        /// The word found.
        found: &'static str,
        /// The word that is missing.
        missing: &'static str,
    },
    /// A whole number beyond its range.
    Range {
        found: String,
        /// The largest.
        most: u32,
    },
    /// A label must be known when the program is read, so it cannot be a parameter.
    LabelOfParameter {
        /// The parameter found.
        parameter: Parameter,
    },
    /// FN 9 to FN 12 each have their comparison.
    Relation {
        /// The function.
        number: u32,
        /// Its word.
        allowed: &'static str,
        /// The word found.
        found: &'static str,
    },
    /// Functions that do not stand in one block.
    NotTogether { one: String, other: String },
    /// A function of which it is not known what it does.
    UnknownWord { found: String },
    /// A function whose form in ISO is not known.
    NoForm {
        /// The function.
        found: String,
    },
    /// A coordinate where neither G90 nor G91 is known to be in force.
    MeasureUnknown,
    /// An axis occurs twice.
    AxisTwice,
    /// Too many nested brackets and functions.
    TooDeep {
        /// What is allowed.
        most: usize,
    },
    /// A formula with too many operands.
    TooManyOperands {
        /// What is allowed.
        most: usize,
    },
    TooLong {
        /// What is allowed.
        most: usize,
    },
    /// Too much text in formulas and long lines.
    TooMuch {
        /// What is allowed.
        most: usize,
    },
}

/// What is allowed at a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "program-wanted")]
pub enum ExpectedWord {
    /// A word or sign of the language.
    Word(#[say(name = "word")] &'static str),
    Number,
    /// A number or a Q parameter.
    Value,
    Parameter,
    /// A number or a variable of a lathe control.
    ValueOrVariable,
    /// A variable of a lathe control.
    Variable,
    /// A Q parameter.
    NumberParameter,
    /// A QS parameter.
    TextParameter,
    /// A quoted text or a QS parameter.
    Text,
    Label,
    Path,
    /// A comparison.
    Relation,
    Unit,
    /// A value of a cycle's parameter.
    CycleValue,
}
