//! Words of the language and their meanings, each only once: reading and writing use the same lists.

use super::expression::{NumberFunction, Operation, Relation};
use super::movement::Axis;

/// Functions of formulas.
pub(super) const FUNCTIONS: [(&str, NumberFunction); 16] = [
    ("SQ", NumberFunction::Square),
    ("SQRT", NumberFunction::SquareRoot),
    ("SIN", NumberFunction::Sine),
    ("COS", NumberFunction::Cosine),
    ("TAN", NumberFunction::Tangent),
    ("ASIN", NumberFunction::ArcSine),
    ("ACOS", NumberFunction::ArcCosine),
    ("ATAN", NumberFunction::ArcTangent),
    ("LN", NumberFunction::NaturalLogarithm),
    ("LOG", NumberFunction::Logarithm),
    ("EXP", NumberFunction::Exponential),
    ("NEG", NumberFunction::Negative),
    ("INT", NumberFunction::Integer),
    ("ABS", NumberFunction::Absolute),
    ("FRAC", NumberFunction::Fraction),
    ("SGN", NumberFunction::Sign),
];

/// Functions of formulas of lathe controls, as far as they are known.
pub(super) const LATHE_FUNCTIONS: [(&str, NumberFunction); 5] = [
    ("SIN", NumberFunction::Sine),
    ("COS", NumberFunction::Cosine),
    ("SQRT", NumberFunction::SquareRoot),
    ("ABS", NumberFunction::Absolute),
    ("INT", NumberFunction::Integer),
];

/// Operations between two operands; `LEN` and `ANG` only in FN 8 and FN 13.
pub(super) const OPERATIONS: [(&str, Operation); 8] = [
    ("+", Operation::Add),
    ("-", Operation::Subtract),
    ("*", Operation::Multiply),
    ("/", Operation::Divide),
    ("^", Operation::Power),
    ("%", Operation::Remainder),
    ("LEN", Operation::Hypotenuse),
    ("ANG", Operation::Angle),
];

/// FN and D with two operands.
const TWO_OPERANDS: [(u32, Operation); 6] = [
    (1, Operation::Add),
    (2, Operation::Subtract),
    (3, Operation::Multiply),
    (4, Operation::Divide),
    (8, Operation::Hypotenuse),
    (13, Operation::Angle),
];

/// FN and D with one operand.
const ONE_OPERAND: [(u32, NumberFunction); 3] =
    [(5, NumberFunction::SquareRoot), (6, NumberFunction::Sine), (7, NumberFunction::Cosine)];

/// What FN or D of a number computes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Computed {
    Of(NumberFunction),
    Between(Operation),
}

/// What FN or D of this number computes, if it does.
pub(super) fn computed(number: u32) -> Option<Computed> {
    let of = ONE_OPERAND.iter().find(|(known, _)| *known == number).map(|&(_, function)| Computed::Of(function));
    let between = || TWO_OPERANDS.iter().find(|(known, _)| *known == number);
    of.or_else(|| between().map(|&(_, operation)| Computed::Between(operation)))
}

/// FN 9 to FN 12: number, word, meaning.
pub(super) const RELATIONS: [(u32, &str, Relation); 4] = [
    (9, "EQU", Relation::Equal),
    (10, "NE", Relation::NotEqual),
    (11, "GT", Relation::Greater),
    (12, "LT", Relation::Less),
];

pub(super) const AXES: [(&str, Axis); 9] = [
    ("X", Axis::X),
    ("Y", Axis::Y),
    ("Z", Axis::Z),
    ("A", Axis::A),
    ("B", Axis::B),
    ("C", Axis::C),
    ("U", Axis::U),
    ("V", Axis::V),
    ("W", Axis::W),
];

/// Corrections of the tool radius; those with a sign belong to paraxial positioning.
pub(super) const COMPENSATIONS: [&str; 5] = ["R0", "RL", "RR", "R+", "R-"];

/// The deepest level of headings; deeper ones count as this level. A control's line is far shorter.
pub(super) const DEEPEST: usize = 50;

/// The meaning of a word, in any case.
pub(super) fn meaning<T: Copy>(list: &[(&str, T)], word: &str) -> Option<T> {
    list.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|&(_, meaning)| meaning)
}

pub(super) fn word<T: Copy + PartialEq>(list: &[(&'static str, T)], meaning: T) -> &'static str {
    list.iter().find(|(_, known)| *known == meaning).map_or("", |&(name, _)| name)
}
