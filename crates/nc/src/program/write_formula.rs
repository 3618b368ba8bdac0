//! Formulas to text, with blanks around operators and brackets, and no more brackets than needed.

use super::expression::{Expression, NumberFunction, Operation, TextExpression};
use super::operand::{Operand, TextOperand};
use super::words::{FUNCTIONS, OPERATIONS, word};
use crate::control::variables::Parameter;

/// `Q5 = …`; FN 8 and FN 13 for operations that no formula has.
pub(super) fn formula(to: Parameter, value: &Expression) -> String {
    if let Expression::Binary(operation, left, right) = value
        && let (Expression::Value(left), Expression::Value(right)) = (&**left, &**right)
        && let Some(number) = match operation {
            Operation::Hypotenuse => Some(8),
            Operation::Angle => Some(13),
            _ => None,
        }
    {
        return format!("FN {number}: {to} = {} {} {}", signed(*left), word(&OPERATIONS, *operation), signed(*right));
    }
    format!("{to} = {}", expression(value, Rank::Sum))
}

/// How strongly an operation binds; a weaker operand of a stronger operation gets brackets.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    Sum,
    Product,
    Power,
    Single,
}

impl Rank {
    const fn of(operation: Operation) -> Self {
        match operation {
            Operation::Add | Operation::Subtract => Self::Sum,
            Operation::Multiply | Operation::Divide | Operation::Remainder => Self::Product,
            Operation::Power | Operation::Hypotenuse | Operation::Angle => Self::Power,
        }
    }

    /// The rank of the right operand: operations of the same rank go from left to right.
    const fn above(self) -> Self {
        match self {
            Self::Sum => Self::Product,
            Self::Product => Self::Power,
            Self::Power | Self::Single => Self::Single,
        }
    }
}

fn expression(value: &Expression, least: Rank) -> String {
    match value {
        Expression::Value(operand) => unsigned(*operand),
        Expression::Pi => "PI".to_owned(),
        Expression::Function(function, operand) => {
            let is_value = matches!(**operand, Expression::Value(_));
            let name = match function {
                // Before anything but a value, the sign is the function.
                NumberFunction::Negative if !is_value => "-",
                function => word(&FUNCTIONS, *function),
            };
            format!("{name} {}", expression(operand, Rank::Single))
        }
        Expression::Binary(operation, left, right) => {
            let rank = Rank::of(*operation);
            let left = expression(left, rank);
            let right = expression(right, rank.above());
            let text = format!("{left} {} {right}", word(&OPERATIONS, *operation));
            if rank < least { format!("( {text} )") } else { text }
        }
        Expression::ToNumber(source) => format!("TONUMB ( SRC_{source} )"),
        Expression::Position { source, wanted, from } => {
            format!("INSTR ( SRC_{source} SEA_{wanted} BEG{} )", word_value(*from))
        }
        Expression::TextLength(source) => format!("STRLEN ( SRC_{source} )"),
        Expression::Compare { source, other } => format!("STRCOMP ( SRC_{source} SEA_{other} )"),
    }
}

pub(super) fn text_formula(value: &TextExpression) -> String {
    match value {
        TextExpression::Value(TextOperand::Text(text)) => quoted(text),
        TextExpression::Value(TextOperand::Parameter(parameter)) => parameter.to_string(),
        TextExpression::Join(items) => items.iter().map(text_formula).collect::<Vec<_>>().join(" || "),
        TextExpression::FromNumber { number, decimals: None } => format!("TOCHAR ( DAT{} )", signed(*number)),
        TextExpression::FromNumber { number, decimals: Some(decimals) } => {
            format!("TOCHAR ( DAT{} DECIMALS{} )", signed(*number), word_value(*decimals))
        }
        TextExpression::Part { source, from, length: None } => {
            format!("SUBSTR ( SRC_{source} BEG{} )", word_value(*from))
        }
        TextExpression::Part { source, from, length: Some(length) } => {
            format!("SUBSTR ( SRC_{source} BEG{} LEN{} )", word_value(*from), word_value(*length))
        }
        TextExpression::System { id, number } => {
            format!("SYSSTR ( ID{} NR{} )", word_value(*id), word_value(*number))
        }
    }
}

/// With its sign, as in the words of a block: `+60`, `-Q1`.
pub(super) fn signed(operand: Operand) -> String {
    match operand {
        Operand::Number(number) => format!("{number:+}"),
        Operand::Parameter { parameter, is_negative: false } => format!("+{parameter}"),
        Operand::Parameter { parameter, is_negative: true } => format!("-{parameter}"),
    }
}

/// As in formulas: no plus, and a blank after the minus.
fn unsigned(operand: Operand) -> String {
    let text = signed(operand);
    match text.strip_prefix('-') {
        Some(size) => format!("- {size}"),
        None => text.trim_start_matches('+').to_owned(),
    }
}

/// As after the words of functions, a number without plus, a parameter with it: `BEG2`, `BEG+Q5`.
pub(super) fn word_value(operand: Operand) -> String {
    match operand {
        Operand::Number(number) => number.to_string(),
        Operand::Parameter { .. } => signed(operand),
    }
}

/// A text within quotation marks; those within it become apostrophes, control characters become blanks.
pub(super) fn quoted(text: &str) -> String {
    format!("\"{}\"", text.replace('"', "'").replace(char::is_control, " "))
}
