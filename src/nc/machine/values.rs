//! Parameters of a run: what they hold, and what a block sets.

use super::fault::FaultKind;
use super::flow::whole;
use super::path::NcPath;
use super::remark::Remark;
use super::run::Machine;
use crate::control::variables::{Family, Parameter, Value};
use crate::length::Length;
use crate::nc::program::{Expression, Operand, TextExpression, TextOperand};

/// The range of values in a control: 10^10 either way.
const MOST: f64 = 1e10;

impl Machine {
    /// The number that a parameter holds.
    pub(super) fn number(&self, parameter: Parameter) -> Result<f64, FaultKind> {
        match self.variables.get(parameter) {
            Some(Value::Number(number)) => Ok(*number),
            Some(Value::Length(length)) => Ok(length.to_mm_f64()),
            Some(Value::Text(_)) => Err(FaultKind::NotNumber(parameter)),
            None => Err(FaultKind::Undefined(parameter)),
        }
    }

    /// The text that a parameter holds.
    pub(super) fn text(&self, parameter: Parameter) -> Result<&str, FaultKind> {
        match self.variables.get(parameter) {
            Some(Value::Text(text)) => Ok(text),
            Some(Value::Number(_) | Value::Length(_)) => Err(FaultKind::NotText(parameter)),
            None => Err(FaultKind::Undefined(parameter)),
        }
    }

    /// The number of an operand.
    pub(super) fn operand(&self, operand: Operand) -> Result<f64, FaultKind> {
        match operand {
            Operand::Number(number) => Ok(number),
            Operand::Parameter { parameter, is_negative } => {
                let number = self.number(parameter)?;
                Ok(if is_negative { -number } else { number })
            }
        }
    }

    /// The value of an operand as it is: a length stays exact.
    pub(super) fn value(&self, operand: Operand) -> Result<Value, FaultKind> {
        if let Operand::Parameter { parameter, is_negative } = operand
            && let Some(Value::Length(length)) = self.variables.get(parameter)
        {
            return Ok(Value::Length(if is_negative { length.negated() } else { *length }));
        }
        self.operand(operand).map(Value::Number)
    }

    /// An operand that counts something.
    pub(super) fn whole(&self, what: &'static str, operand: Operand) -> Result<usize, FaultKind> {
        let value = self.operand(operand)?;
        whole(value).ok_or(FaultKind::NotWhole { what, value })
    }

    /// The text of an operand.
    pub(super) fn text_operand<'a>(&'a self, operand: &'a TextOperand) -> Result<&'a str, FaultKind> {
        match operand {
            TextOperand::Text(text) => Ok(text),
            TextOperand::Parameter(parameter) => self.text(*parameter),
        }
    }

    /// The path that an operand names, from the program that runs.
    pub(super) fn path_of(&self, operand: &TextOperand) -> Result<NcPath, FaultKind> {
        Ok(self.frame.path.resolve(self.text_operand(operand)?)?)
    }

    /// Sets a parameter that a control has to a value that it can hold.
    pub(super) fn put(&mut self, parameter: Parameter, value: Value) -> Result<(), FaultKind> {
        let most = match parameter.family {
            Family::Q | Family::Qs => 1_999,
            Family::Ql | Family::Qr => 499,
        };
        if most < parameter.number {
            return Err(FaultKind::NoParameter(parameter));
        }
        match &value {
            Value::Number(number) => {
                in_range(*number)?;
            }
            Value::Text(text) => self.check_length(text)?,
            Value::Length(_) => {}
        }
        match (&value, parameter.family) {
            (Value::Text(_), Family::Qs)
            | (Value::Number(_) | Value::Length(_), Family::Q | Family::Ql | Family::Qr) => {}
            (Value::Text(_), _) => return Err(FaultKind::NotNumber(parameter)),
            (_, Family::Qs) => return Err(FaultKind::NotText(parameter)),
        }
        self.variables.set(parameter, value);
        self.changed.push(parameter);
        Ok(())
    }

    pub(super) fn check_length(&self, text: &str) -> Result<(), FaultKind> {
        let most = self.budget().text;
        // A text has at most as many characters as bytes.
        if most < text.len() {
            let length = text.chars().count();
            if most < length {
                return Err(FaultKind::TextTooLong { length, most });
            }
        }
        Ok(())
    }

    /// `Q5 = …`
    pub(super) fn assign(&mut self, at: usize, to: Parameter, value: &Expression) -> Result<(), FaultKind> {
        if !self.given.is_empty() && self.is_given(at, to, || reads(value, to)) {
            return Ok(());
        }
        let value = match value {
            Expression::Value(operand) => self.value(*operand)?,
            formula => Value::Number(self.evaluate(formula)?),
        };
        self.put(to, value)
    }

    /// `QS5 = …`
    pub(super) fn assign_text(&mut self, at: usize, to: Parameter, value: &TextExpression) -> Result<(), FaultKind> {
        if !self.given.is_empty() && self.is_given(at, to, || text_reads(value, to)) {
            return Ok(());
        }
        let text = self.evaluate_text(value)?;
        self.put(to, Value::Text(text))
    }

    /// `Q5 SET UNDEFINED`
    pub(super) fn undefine(&mut self, at: usize, parameter: Parameter) {
        if self.given.is_empty() || !self.is_given(at, parameter, || false) {
            self.variables.unset(parameter);
            self.changed.push(parameter);
        }
    }

    /// Whether a value that was given before the run stands in place of this assignment: the first one in the main
    /// program, unless it counts on from the value.
    fn is_given(&mut self, at: usize, parameter: Parameter, counts_on: impl Fn() -> bool) -> bool {
        if self.is_within_call() {
            return false;
        }
        let Some(value) = self.given.remove(&parameter) else { return false };
        if counts_on() {
            return false;
        }
        self.remark(at, Remark::GivenWins { parameter, value: shown(&value) });
        self.changed.push(parameter);
        true
    }
}

/// A number that a control can hold.
pub(super) fn in_range(number: f64) -> Result<f64, FaultKind> {
    // NaN is in no range.
    if number.abs() <= MOST { Ok(number) } else { Err(FaultKind::BeyondRange(number)) }
}

/// A value as programs write it.
pub fn shown(value: &Value) -> String {
    match value {
        Value::Length(length) => length.to_string(),
        Value::Number(number) => number.to_string(),
        Value::Text(text) => format!("\"{text}\""),
    }
}

/// The value at the nearest nanometre.
pub(super) fn length_of(value: &Value) -> Option<Length> {
    match value {
        Value::Length(length) => Some(*length),
        Value::Number(number) => Length::from_mm_f64(*number).ok(),
        Value::Text(_) => None,
    }
}

fn operand_reads(operand: Operand, wanted: Parameter) -> bool {
    matches!(operand, Operand::Parameter { parameter, .. } if parameter == wanted)
}

/// Whether a formula asks for a parameter.
fn reads(formula: &Expression, wanted: Parameter) -> bool {
    match formula {
        Expression::Value(operand) => operand_reads(*operand, wanted),
        Expression::Function(_, operand) => reads(operand, wanted),
        Expression::Binary(_, left, right) => reads(left, wanted) || reads(right, wanted),
        Expression::Position { from, .. } => operand_reads(*from, wanted),
        Expression::Pi | Expression::ToNumber(_) | Expression::TextLength(_) | Expression::Compare { .. } => false,
    }
}

fn text_reads(formula: &TextExpression, wanted: Parameter) -> bool {
    match formula {
        TextExpression::Value(TextOperand::Parameter(parameter)) => *parameter == wanted,
        TextExpression::Join(items) => items.iter().any(|item| text_reads(item, wanted)),
        TextExpression::Part { source, .. } => *source == wanted,
        TextExpression::Value(TextOperand::Text(_))
        | TextExpression::FromNumber { .. }
        | TextExpression::System { .. } => false,
    }
}
