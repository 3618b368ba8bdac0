//! Formulas for numbers and texts, as a tree.

use super::operand::{Operand, TextOperand};
use crate::control::variables::Parameter;

/// A formula that gives a number. FN 0 to FN 8 and FN 13 are other notations of formulas.
#[derive(Debug, Clone, PartialEq)]
pub enum Expression {
    /// A number or a parameter, with its sign.
    Value(Operand),
    /// The constant PI.
    Pi,
    /// A function before its operand: `SQRT 4`, and `NEG`; a minus sign before a bracket is `NEG` too.
    Function(NumberFunction, Box<Self>),
    /// Two operands: `Q1 + 3`.
    Binary(Operation, Box<Self>, Box<Self>),
    /// `TONUMB ( SRC_QS11 )`.
    ToNumber(Parameter),
    /// `INSTR ( SRC_QS10 SEA_QS13 BEG2 )`.
    Position {
        /// The text to search in.
        source: Parameter,
        /// The text to search for.
        wanted: Parameter,
        /// From which character, counted from 0.
        from: Operand,
    },
    /// `STRLEN ( SRC_QS15 )`.
    TextLength(Parameter),
    /// `STRCOMP ( SRC_QS12 SEA_QS14 )`: -1, 0 or +1.
    Compare {
        /// The first text.
        source: Parameter,
        /// The second.
        other: Parameter,
    },
}

/// How two values are compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// `EQU`
    Equal,
    /// `NE`
    NotEqual,
    /// `GT`
    Greater,
    /// `LT`
    Less,
}

/// What `IF` and `WHILE` of lathe controls ask: always answered by yes or no.
#[derive(Debug, Clone, PartialEq)]
pub enum Test {
    /// Two formulas, compared.
    Compare(Expression, Relation, Expression),
    /// The opposite: `<=` is not `>`.
    Not(Box<Self>),
    /// `AND`: every one holds.
    All(Vec<Self>),
    /// `OR`: at least one holds.
    Any(Vec<Self>),
}

/// The operation between two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    Add,
    Subtract,
    Multiply,
    /// `/`, and `DIV` of FN 4.
    Divide,
    Power,
    /// `%`: the remainder.
    Remainder,
    /// `LEN` of FN 8: the root of the sum of squares.
    Hypotenuse,
    /// `ANG` of FN 13: the angle whose sine is to the first operand as its cosine is to the second, degrees.
    Angle,
}

/// Functions before their operand; angles in degrees.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NumberFunction {
    Square,
    SquareRoot,
    Sine,
    Cosine,
    Tangent,
    ArcSine,
    ArcCosine,
    ArcTangent,
    NaturalLogarithm,
    /// Logarithm to the base 10.
    Logarithm,
    /// Power of e.
    Exponential,
    /// The opposite sign.
    Negative,
    /// Whole part.
    Integer,
    /// Size without sign.
    Absolute,
    /// The part after the point.
    Fraction,
    /// Sign: 1 for 0 and above, -1 below.
    Sign,
}

/// A formula that gives a text: the items joined in order (`||`); at least one.
#[derive(Debug, Clone, PartialEq)]
pub enum TextExpression {
    /// A quoted text or a QS parameter.
    Value(TextOperand),
    /// `QS12 || QS13 || QS14`.
    Join(Vec<Self>),
    /// `TOCHAR ( DAT+Q50 DECIMALS3 )`; if decimals are not given, as many as the value has.
    FromNumber {
        number: Operand,
        /// Digits after the point.
        decimals: Option<Operand>,
    },
    /// `SUBSTR ( SRC_QS10 BEG2 LEN4 )`.
    Part {
        source: Parameter,
        /// From which character, counted from 0.
        from: Operand,
        /// How many characters; to the end if not given.
        length: Option<Operand>,
    },
    /// `SYSSTR ( ID10321 NR0 )`: date and time and others; all are read, but only date and time is run.
    System {
        /// The group.
        id: Operand,
        /// The number in the group.
        number: Operand,
    },
}
