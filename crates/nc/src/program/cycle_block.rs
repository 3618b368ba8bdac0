//! What the block of a cycle says: its number, and a value for each of its parameters.

use std::fmt;

use super::operand::{Operand, TextOperand};
use super::place::TextPlace;
use crate::control::variables::Parameter;

/// A cycle with its lines, in the order of the program.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleBlock {
    /// The number after `TCH PROBE` or `CYCL DEF`, as written: `421`, `7.0`; the whole word of a lathe control, `G785`.
    pub number: String,
    /// The name after it, as written.
    pub name: String,
    /// Its parameters; the address letters of a lathe control's cycle, which it has, and each no more than once.
    pub lines: Vec<CycleLine>,
}

/// What a line of a cycle gives a value to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CycleName {
    /// Q or QS.
    Parameter(Parameter),
    /// A word or an address letter, such as `MB` and the `K` of G785.
    Word(String),
}

impl fmt::Display for CycleName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(parameter) => write!(f, "{parameter}"),
            Self::Word(word) => f.pad(word),
        }
    }
}

impl From<Parameter> for CycleName {
    fn from(parameter: Parameter) -> Self {
        Self::Parameter(parameter)
    }
}

/// `Q263=+35 ;1ST POINT 1ST AXIS`
#[derive(Debug, Clone, PartialEq)]
pub struct CycleLine {
    /// Q, QS or a word.
    pub parameter: CycleName,
    pub value: CycleValue,
    /// The place of the parameter.
    pub place: TextPlace,
    /// The comment after it, which names the parameter in the language of the control.
    pub comment: String,
}

/// The value of a cycle's parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum CycleValue {
    /// A number or a parameter; `text` is the original text, so that decimals reach the cycle exactly.
    Number {
        value: Operand,
        /// As written.
        text: String,
    },
    /// A quoted text or a QS parameter.
    Text(TextOperand),
    /// A word: `PREDEF`, `MAX`, `AUTO`.
    Word(String),
}
