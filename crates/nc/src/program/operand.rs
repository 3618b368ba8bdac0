//! Numbers and texts, or the parameters that hold them.

use crate::control::variables::Parameter;

/// A number or a number parameter, with a sign: `+Q1`, `-5`, `2,5`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Operand {
    /// A number, sign included.
    Number(f64),
    /// A Q, QL or QR parameter.
    Parameter {
        parameter: Parameter,
        /// Whether a minus sign precedes it.
        is_negative: bool,
    },
}

/// A text or a text parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TextOperand {
    /// As written, without quotation marks.
    Text(String),
    /// A QS parameter (also written `:'QS1'` in paths of FN 16).
    Parameter(Parameter),
}
