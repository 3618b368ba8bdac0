//! Formulas for numbers: powers first, then products, then sums; a function binds only the operand after it.
//!
//! A sign binds like a function. Operations of the same rank go from left to right, powers too.

use super::cursor::{Cursor, Parsed, shown};
use super::expression::{Expression, NumberFunction, Operation};
use super::fault::{BlockFault, ExpectedWord};
use super::operand::Operand;
use super::words::{FUNCTIONS, LATHE_FUNCTIONS, meaning};
use crate::control::variables::Parameter;

/// The most nested brackets and functions.
pub(super) const MOST_DEPTH: usize = 64;
/// The most operands of a formula: its tree is never deeper than this plus [`MOST_DEPTH`].
pub(super) const MOST_OPERANDS: usize = 500;

/// Reads a formula as far as it goes.
pub(super) fn expression(cursor: &mut Cursor<'_>) -> Parsed<Expression> {
    Formula { cursor, depth: 0, operands: 0 }.sum()
}

/// Joins two operands.
pub(super) fn binary(operation: Operation, left: Expression, right: Expression) -> Expression {
    Expression::Binary(operation, Box::new(left), Box::new(right))
}

struct Formula<'c, 'a> {
    cursor: &'c mut Cursor<'a>,
    depth: usize,
    operands: usize,
}

impl Formula<'_, '_> {
    fn sum(&mut self) -> Parsed<Expression> {
        let mut left = self.product()?;
        loop {
            let operation = if self.cursor.take('+') {
                Operation::Add
            } else if self.cursor.take('-') {
                Operation::Subtract
            } else {
                return Ok(left);
            };
            left = binary(operation, left, self.product()?);
        }
    }

    fn product(&mut self) -> Parsed<Expression> {
        let mut left = self.power()?;
        loop {
            let operation = if self.cursor.take('*') {
                Operation::Multiply
            } else if self.cursor.take('/') {
                Operation::Divide
            } else if !self.cursor.is_of_lathes() && self.cursor.take('%') {
                Operation::Remainder
            } else {
                return Ok(left);
            };
            left = binary(operation, left, self.power()?);
        }
    }

    fn power(&mut self) -> Parsed<Expression> {
        let mut left = self.operand()?;
        while !self.cursor.is_of_lathes() && self.cursor.take('^') {
            left = binary(Operation::Power, left, self.operand()?);
        }
        Ok(left)
    }

    /// An operand with everything before it.
    fn operand(&mut self) -> Parsed<Expression> {
        if self.depth == MOST_DEPTH {
            return Err(self.cursor.fail(BlockFault::TooDeep { most: MOST_DEPTH }));
        }
        self.depth += 1;
        let operand = self.signed();
        self.depth -= 1;
        operand
    }

    fn signed(&mut self) -> Parsed<Expression> {
        if self.cursor.take('+') {
            return self.operand();
        }
        if self.cursor.take('-') {
            return Ok(negative(self.operand()?));
        }
        if self.cursor.take('(') {
            let inner = self.sum()?;
            self.cursor.expect(')', ")")?;
            return Ok(inner);
        }
        self.plain()
    }

    /// A number, a parameter, PI, or a function with its operand.
    fn plain(&mut self) -> Parsed<Expression> {
        self.operands += 1;
        if MOST_OPERANDS < self.operands {
            return Err(self.cursor.fail(BlockFault::TooManyOperands { most: MOST_OPERANDS }));
        }
        if let Some(number) = self.cursor.number()? {
            return Ok(Expression::Value(Operand::Number(number)));
        }
        let from = self.cursor.clone();
        if let Some(parameter) = self.cursor.parameter()? {
            if parameter.family.is_text() {
                return Err(from.clone().stop(ExpectedWord::Value));
            }
            return Ok(Expression::Value(Operand::Parameter { parameter, is_negative: false }));
        }
        let word = self.cursor.letters();
        if word.is_empty() {
            return Err(self.cursor.stop(ExpectedWord::Value));
        }
        self.cursor.take_prefix(word);
        if self.cursor.is_of_lathes() {
            return self.lathe_function(word, &from);
        }
        if word.eq_ignore_ascii_case("PI") {
            return Ok(Expression::Pi);
        }
        if let Some(function) = meaning(&FUNCTIONS, word) {
            return Ok(Expression::Function(function, Box::new(self.operand()?)));
        }
        match text_function(self.cursor, word)? {
            Some(expression) => Ok(expression),
            None => Err(from.fail(BlockFault::UnknownFunction { found: shown(word) })),
        }
    }

    /// A function of lathe controls: its operand stands in brackets.
    fn lathe_function(&mut self, word: &str, from: &Cursor<'_>) -> Parsed<Expression> {
        let Some(function) = meaning(&LATHE_FUNCTIONS, word) else {
            return Err(from.fail(BlockFault::UnknownFunction { found: shown(word) }));
        };
        if self.cursor.next() != Some('(') {
            return Err(self.cursor.stop(ExpectedWord::Word("(")));
        }
        Ok(Expression::Function(function, Box::new(self.operand()?)))
    }
}

/// The opposite sign; for a number or parameter it becomes part of it.
fn negative(operand: Expression) -> Expression {
    match operand {
        Expression::Value(Operand::Number(number)) => Expression::Value(Operand::Number(-number)),
        Expression::Value(Operand::Parameter { parameter, is_negative }) => {
            Expression::Value(Operand::Parameter { parameter, is_negative: !is_negative })
        }
        other => Expression::Function(NumberFunction::Negative, Box::new(other)),
    }
}

/// The functions that turn a text into a number; the word has already been taken.
fn text_function(cursor: &mut Cursor<'_>, word: &str) -> Parsed<Option<Expression>> {
    let is = |name: &str| word.eq_ignore_ascii_case(name);
    if !["TONUMB", "INSTR", "STRLEN", "STRCOMP"].into_iter().any(is) {
        return Ok(None);
    }
    cursor.expect('(', "(")?;
    let source = text_word(cursor, "SRC_")?;
    let expression = if is("TONUMB") {
        Expression::ToNumber(source)
    } else if is("STRLEN") {
        Expression::TextLength(source)
    } else {
        let wanted = text_word(cursor, "SEA_")?;
        if is("STRCOMP") {
            Expression::Compare { source, other: wanted }
        } else {
            let from = value_word(cursor, "BEG")?;
            Expression::Position { source, wanted, from }
        }
    };
    cursor.expect(')', ")")?;
    Ok(Some(expression))
}

/// `SRC_QS10`.
pub(super) fn text_word(cursor: &mut Cursor<'_>, word: &'static str) -> Parsed<Parameter> {
    if !cursor.take_prefix(word) {
        return Err(cursor.stop(ExpectedWord::Word(word)));
    }
    cursor.text_parameter(ExpectedWord::TextParameter)
}

/// `BEG2`, `BEG+Q5`.
pub(super) fn value_word(cursor: &mut Cursor<'_>, word: &'static str) -> Parsed<Operand> {
    if !cursor.take_prefix(word) {
        return Err(cursor.stop(ExpectedWord::Word(word)));
    }
    cursor.operand()
}
