//! Formulas that give a number, and the conditions of jumps. Numbers are binary, as on the control.

use std::cmp::Ordering;

use fitcheck_core::length::without_zeros;
use fitcheck_core::text::{before, behind};

use super::super::fault::{Counted, FaultKind};
use super::{Values, in_range, shown};
use crate::control::mask;
use crate::control::variables::Parameter;
use crate::program::{Condition, Expression, NumberFunction, Operand, Operation, Relation, Test};

impl Values {
    pub(super) fn evaluate(&self, formula: &Expression) -> Result<f64, FaultKind> {
        match formula {
            Expression::Value(operand) => self.operand(*operand),
            Expression::Pi => Ok(std::f64::consts::PI),
            Expression::Function(function, operand) => in_range(apply(*function, self.evaluate(operand)?)?),
            Expression::Binary(operation, left, right) => {
                in_range(combine(*operation, self.evaluate(left)?, self.evaluate(right)?)?)
            }
            Expression::ToNumber(parameter) => self.to_number(*parameter),
            Expression::Position { source, wanted, from } => self.find(*source, *wanted, *from),
            Expression::TextLength(parameter) => match self.variables.get(*parameter) {
                None => self.check_defined(*parameter).map(|()| -1.0),
                Some(_) => Ok(count(self.text(*parameter)?)),
            },
            Expression::Compare { source, other } => {
                // By code point, as UTF-8 compares; a text comes before any text that it is the beginning of.
                Ok(match self.text(*source)?.cmp(self.text(*other)?) {
                    Ordering::Less => -1.0,
                    Ordering::Equal => 0.0,
                    Ordering::Greater => 1.0,
                })
            }
        }
    }

    /// TONUMB: a decimal number with point or comma.
    fn to_number(&self, parameter: Parameter) -> Result<f64, FaultKind> {
        let text = self.text(parameter)?;
        let no_number = || FaultKind::NoNumberInText { parameter, text: text.to_owned() };
        let plain = text.trim().replace(',', ".");
        let is_decimal = plain.bytes().all(|byte| byte.is_ascii_digit() || b"+-.".contains(&byte));
        in_range(plain.parse().ok().filter(|_| is_decimal).ok_or_else(no_number)?)
    }

    /// INSTR: the place in characters from 0; the length of the text where it does not occur.
    fn find(&self, source: Parameter, wanted: Parameter, from: Operand) -> Result<f64, FaultKind> {
        let text = self.text(source)?;
        let wanted = self.text(wanted)?;
        let from = self.whole(Counted::Word("BEG"), from)?;
        let characters = text.chars().count();
        let Some((start, _)) = text.char_indices().chain([(text.len(), ' ')]).nth(from) else {
            return Err(FaultKind::BehindText { length: characters, from });
        };
        Ok(match behind(text, start).find(wanted) {
            Some(found) => count(before(text, start + found)),
            None => count(text),
        })
    }

    /// Whether a jump is made.
    pub(in crate::machine) fn holds(&self, condition: &Condition) -> Result<bool, FaultKind> {
        match condition {
            Condition::IsDefined(parameter) => {
                self.check_defined(*parameter)?;
                Ok(self.variables.get(*parameter).is_some())
            }
            Condition::IsUndefined(parameter) => {
                self.check_defined(*parameter)?;
                Ok(self.variables.get(*parameter).is_none())
            }
            Condition::Compare(left, relation, right) => {
                Ok(compare(self.operand(*left)?, *relation, self.operand(*right)?))
            }
        }
    }

    /// Whether a condition of IF or WHILE holds: conditions are read from left to right, as far as needed.
    pub(in crate::machine) fn passes(&self, test: &Test) -> Result<bool, FaultKind> {
        match test {
            Test::Compare(left, relation, right) => Ok(compare(self.evaluate(left)?, *relation, self.evaluate(right)?)),
            Test::Not(test) => Ok(!self.passes(test)?),
            Test::All(tests) => tests.iter().try_fold(true, |all, test| Ok(all && self.passes(test)?)),
            Test::Any(tests) => tests.iter().try_fold(false, |any, test| Ok(any || self.passes(test)?)),
        }
    }

    /// The value of an operand for a text: as a decimal number.
    pub(in crate::machine) fn decimal(&self, operand: Operand, decimals: Option<usize>) -> Result<String, FaultKind> {
        /// As many decimals as a value has, but no more than this: the rest is noise of binary arithmetic.
        const MOST: usize = 9;
        let value = self.value(operand)?;
        let rounded = mask::decimal(&value, decimals.unwrap_or(MOST)).unwrap_or_else(|| shown(&value));
        if decimals.is_some() {
            return Ok(rounded);
        }
        Ok(without_zeros(&rounded).to_owned())
    }
}

fn compare(left: f64, relation: Relation, right: f64) -> bool {
    match relation {
        Relation::Equal => left.partial_cmp(&right) == Some(Ordering::Equal),
        Relation::NotEqual => left.partial_cmp(&right) != Some(Ordering::Equal),
        Relation::Greater => right < left,
        Relation::Less => left < right,
    }
}

/// How many characters a text has; far below 2^53.
fn count(text: &str) -> f64 {
    f64::from(u32::try_from(text.chars().count()).unwrap_or(u32::MAX))
}

fn apply(function: NumberFunction, value: f64) -> Result<f64, FaultKind> {
    let none = |function| Err(FaultKind::NoResult { function, value });
    Ok(match function {
        NumberFunction::Square => value * value,
        NumberFunction::SquareRoot if value < 0.0 => return Err(FaultKind::NegativeRoot(value)),
        NumberFunction::SquareRoot => value.sqrt(),
        NumberFunction::Sine => libm::sin(value.to_radians()),
        NumberFunction::Cosine => libm::cos(value.to_radians()),
        NumberFunction::Tangent => libm::tan(value.to_radians()),
        NumberFunction::ArcSine if 1.0 < value.abs() => return none("ASIN"),
        NumberFunction::ArcSine => libm::asin(value).to_degrees(),
        NumberFunction::ArcCosine if 1.0 < value.abs() => return none("ACOS"),
        NumberFunction::ArcCosine => libm::acos(value).to_degrees(),
        NumberFunction::ArcTangent => libm::atan(value).to_degrees(),
        NumberFunction::NaturalLogarithm if value <= 0.0 => return none("LN"),
        NumberFunction::NaturalLogarithm => libm::log(value),
        NumberFunction::Logarithm if value <= 0.0 => return none("LOG"),
        NumberFunction::Logarithm => libm::log10(value),
        NumberFunction::Exponential => libm::exp(value),
        NumberFunction::Negative => -value,
        NumberFunction::Integer => value.trunc(),
        NumberFunction::Absolute => value.abs(),
        NumberFunction::Fraction => value.fract(),
        NumberFunction::Sign if value < 0.0 => -1.0,
        NumberFunction::Sign => 1.0,
    })
}

fn combine(operation: Operation, left: f64, right: f64) -> Result<f64, FaultKind> {
    let is_zero = |value: f64| value.abs() <= 0.0;
    Ok(match operation {
        Operation::Add => left + right,
        Operation::Subtract => left - right,
        Operation::Multiply => left * right,
        Operation::Divide | Operation::Remainder if is_zero(right) => return Err(FaultKind::DivisionByZero),
        Operation::Divide => left / right,
        Operation::Remainder => left % right,
        Operation::Power if is_zero(left) && right < 0.0 => return Err(FaultKind::DivisionByZero),
        // A number below zero has whole powers only.
        Operation::Power if left < 0.0 && 0.0 < right.fract().abs() => return Err(FaultKind::NegativeRoot(left)),
        Operation::Power => libm::pow(left, right),
        Operation::Hypotenuse => libm::hypot(left, right),
        Operation::Angle if is_zero(left) && is_zero(right) => {
            return Err(FaultKind::NoResult { function: "0 ANG", value: 0.0 });
        }
        // From 0 up to a full turn, as the control gives it.
        Operation::Angle => {
            let turned = libm::atan2(left, right).to_degrees().rem_euclid(360.0);
            // A tiny angle below zero is rounded to the full turn.
            if turned < 360.0 { turned } else { 0.0 }
        }
    })
}

fn operand_reads(operand: Operand, wanted: Parameter) -> bool {
    matches!(operand, Operand::Parameter { parameter, .. } if parameter == wanted)
}

/// Whether a formula contains a parameter.
pub(super) fn reads(formula: &Expression, wanted: Parameter) -> bool {
    match formula {
        Expression::Value(operand) => operand_reads(*operand, wanted),
        Expression::Function(_, operand) => reads(operand, wanted),
        Expression::Binary(_, left, right) => reads(left, wanted) || reads(right, wanted),
        Expression::Position { from, .. } => operand_reads(*from, wanted),
        Expression::Pi | Expression::ToNumber(_) | Expression::TextLength(_) | Expression::Compare { .. } => false,
    }
}
