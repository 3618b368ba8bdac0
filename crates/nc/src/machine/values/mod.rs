//! Parameters of a run: their values, and what a block sets.
//!
//! | file | what |
//! |---|---|
//! | `expressions` | formulas that give a number, and the conditions of jumps |
//! | `texts` | formulas that give a text |
//! | `given` | values that were given before the run |
//! | `lost` | what blocks may have set that were not run |

mod expressions;
mod given;
mod lost;
mod texts;

use std::cell::Cell;

use jiff::civil::DateTime;

use super::budget::Settings;
use super::fault::{Counted, FaultKind};
use super::path::NcPath;
use crate::control::variables::{FIRST_WHOLE_GLOBAL, Family, Parameter, Value, Variables};
use crate::program::{Expression, Operand, TextExpression, TextOperand};
use expressions::reads;
use fitcheck_core::length::Length;
use fitcheck_core::message::Arg;
use given::GivenValues;
use lost::{LostParameters, SettingBlocks};
use texts::text_reads;

/// The range of values on a control: 10^10 either way.
const MOST: f64 = 1e10;

/// The families that each called program has for itself. That a subprogram within a program shares those of its program
/// is ours for lathe controls.
const LOCAL: [Family; 2] = [Family::Ql, Family::LatheLocal];

/// The parameters of a run.
#[derive(Debug)]
pub(super) struct Values {
    variables: Variables,
    /// The parameters that the last block has set.
    changed: Vec<Parameter>,
    given: GivenValues,
    lost: LostParameters,
    /// The local parameters of the calling programs, the outermost first.
    locals: Vec<(Vec<(Parameter, Value)>, SettingBlocks)>,
    /// The most characters of a text.
    longest: usize,
    /// The time that `SYSSTR` gives.
    time: DateTime,
    /// The main program, which `SYSSTR` gives, too.
    main: NcPath,
    /// What the block has read of that which a lathe control's cycle has set.
    read: Cell<Option<Parameter>>,
    /// Whether blocks behind such a cycle may have been read before it has measured.
    is_ahead: bool,
}

impl Values {
    pub(super) fn new(settings: &Settings, main: &NcPath) -> Self {
        Self {
            variables: Variables::new(),
            changed: Vec::new(),
            given: GivenValues::default(),
            lost: LostParameters::default(),
            locals: Vec::new(),
            longest: settings.budget.text,
            time: settings.time,
            main: main.clone(),
            read: Cell::new(None),
            is_ahead: false,
        }
    }

    /// All parameters that have a value.
    pub(super) const fn all(&self) -> &Variables {
        &self.variables
    }

    pub(super) fn changed(&self) -> &[Parameter] {
        &self.changed
    }

    /// The parameters of a mask were printed.
    pub(super) fn printed(&self, parameters: impl IntoIterator<Item = Parameter>) {
        parameters.into_iter().for_each(|parameter| self.given.used(parameter));
    }

    /// The parameters whose value, given before the run, had no effect.
    pub(super) fn given_without_effect(&self) -> Vec<Parameter> {
        self.given.without_effect()
    }

    pub(super) fn begin_block(&mut self) {
        self.changed.clear();
    }

    /// Sets a parameter that the machine itself provides.
    pub(super) fn set(&mut self, parameter: Parameter, value: Value) {
        self.lost.known(parameter);
        self.variables.set(parameter, value);
    }

    /// Sets a Q parameter that the control itself sets.
    pub(super) fn preassign(&mut self, number: u16, value: f64) {
        let parameter = Parameter::q(number);
        self.given.overwritten(parameter);
        self.set(parameter, Value::Number(value));
    }

    /// Takes the values of Q parameters away.
    pub(super) fn forget(&mut self, numbers: std::ops::RangeInclusive<u16>) {
        for number in numbers {
            self.lost.known(Parameter::q(number));
            self.variables.unset(Parameter::q(number));
        }
    }

    /// Gives a parameter a value before the run.
    pub(super) fn give(&mut self, parameter: Parameter, value: Value) -> Result<(), FaultKind> {
        self.put(parameter, value.clone())?;
        self.given.add(parameter, value);
        Ok(())
    }

    /// A called program begins, without local parameters.
    pub(super) fn enter_program(&mut self) {
        let locals = LOCAL.into_iter().flat_map(|family| self.variables.take(family)).collect();
        self.locals.push((locals, self.lost.take(&LOCAL)));
    }

    /// It returns, and the caller gets its own parameters back.
    pub(super) fn leave_program(&mut self) {
        for family in LOCAL {
            self.variables.take(family);
        }
        self.lost.take(&LOCAL);
        let Some((locals, lost)) = self.locals.pop() else { return };
        for (parameter, value) in locals {
            self.variables.set(parameter, value);
        }
        self.lost.put(lost);
    }

    /// The number that a parameter holds.
    pub(super) fn number(&self, parameter: Parameter) -> Result<f64, FaultKind> {
        self.given.used(parameter);
        if parameter.family == Family::LatheControl {
            self.read.set(Some(parameter));
        }
        match self.variables.get(parameter) {
            Some(Value::Number(number)) => Ok(*number),
            Some(Value::Length(length)) => Ok(length.to_mm_f64()),
            Some(Value::Text(_)) => Err(FaultKind::NotNumber(parameter)),
            None => Err(self.missing(parameter)),
        }
    }

    /// The text that a parameter holds.
    pub(super) fn text(&self, parameter: Parameter) -> Result<&str, FaultKind> {
        self.given.used(parameter);
        match self.variables.get(parameter) {
            Some(Value::Text(text)) => Ok(text),
            Some(Value::Number(_) | Value::Length(_)) => Err(FaultKind::NotText(parameter)),
            None => Err(self.missing(parameter)),
        }
    }

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
            // Counts as reading it, too.
            self.number(parameter)?;
            return Ok(Value::Length(if is_negative { length.negated() } else { *length }));
        }
        self.operand(operand).map(Value::Number)
    }

    /// The variable of the control that the block has read, if it has.
    pub(super) const fn take_read(&mut self) -> Option<Parameter> {
        self.read.get_mut().take()
    }

    /// A cycle has set its results.
    pub(super) const fn measured(&mut self) {
        self.is_ahead = true;
    }

    /// G909: the control waits for what stands before.
    pub(super) const fn wait(&mut self) {
        self.is_ahead = false;
    }

    /// Whether no G909 stands behind the last cycle.
    pub(super) const fn is_ahead(&self) -> bool {
        self.is_ahead
    }

    /// `INPUT`: the value that was given before the run, once.
    pub(super) fn answer(&mut self, parameter: Parameter) -> Option<Value> {
        self.given(parameter, true, || false)
    }

    /// An operand that counts something.
    pub(super) fn whole(&self, what: Counted, operand: Operand) -> Result<usize, FaultKind> {
        let value = self.operand(operand)?;
        whole(value).ok_or(FaultKind::NotWhole { what, value })
    }

    pub(super) fn text_operand<'a>(&'a self, operand: &'a TextOperand) -> Result<&'a str, FaultKind> {
        match operand {
            TextOperand::Text(text) => Ok(text),
            TextOperand::Parameter(parameter) => self.text(*parameter),
        }
    }

    /// A path, with the values of the parameters that stand in it: `TNC:\LOG\:'QS1'.TXT`; numbers have the decimals that they need.
    pub(super) fn path_text(&self, operand: &TextOperand) -> Result<String, FaultKind> {
        let text = self.text_operand(operand)?;
        let TextOperand::Text(_) = operand else { return Ok(text.to_owned()) };
        let mut pieces = text.split(":'");
        let mut path = pieces.next().unwrap_or("").to_owned();
        for piece in pieces {
            let named = piece.split_once('\'').and_then(|(name, rest)| Some((name.parse::<Parameter>().ok()?, rest)));
            let Some((parameter, rest)) = named else {
                path.push_str(":'");
                path.push_str(piece);
                continue;
            };
            let value = if parameter.family.is_text() {
                self.text(parameter)?.to_owned()
            } else {
                self.decimal(Operand::Parameter { parameter, is_negative: false }, None)?
            };
            path.push_str(&value);
            path.push_str(rest);
        }
        Ok(path)
    }

    /// Sets a parameter that exists on a control to a value that it can hold.
    pub(super) fn put(&mut self, parameter: Parameter, value: Value) -> Result<(), FaultKind> {
        exists(parameter)?;
        match (&value, parameter.family.is_text()) {
            (Value::Text(text), true) => self.check_length(text)?,
            (Value::Text(_), false) => return Err(FaultKind::NotNumber(parameter)),
            (_, true) => return Err(FaultKind::NotText(parameter)),
            (Value::Number(number), false) => {
                in_range(*number)?;
            }
            (Value::Length(_), false) => {}
        }
        check_whole(parameter, &value)?;
        self.given.overwritten(parameter);
        self.lost.known(parameter);
        self.variables.set(parameter, value);
        self.changed.push(parameter);
        Ok(())
    }

    fn check_length(&self, text: &str) -> Result<(), FaultKind> {
        let most = self.longest;
        // A text has at most as many characters as bytes.
        if most < text.len() {
            let length = text.chars().count();
            if most < length {
                return Err(FaultKind::TextTooLong { length, most });
            }
        }
        Ok(())
    }

    /// `Q5 = …`. Returns the value that was given before the run, if it takes the place of this one.
    pub(super) fn assign(
        &mut self,
        to: Parameter,
        value: &Expression,
        is_main: bool,
    ) -> Result<Option<Value>, FaultKind> {
        let given = self.given(to, is_main, || reads(value, to));
        if given.is_none() {
            let value = match value {
                Expression::Value(operand) => self.value(*operand)?,
                formula => Value::Number(self.evaluate(formula)?),
            };
            self.put(to, value)?;
        }
        Ok(given)
    }

    /// `QS5 = …`; the same for a text.
    pub(super) fn assign_text(
        &mut self,
        to: Parameter,
        value: &TextExpression,
        is_main: bool,
    ) -> Result<Option<Value>, FaultKind> {
        let given = self.given(to, is_main, || text_reads(value, to));
        if given.is_none() {
            let text = self.evaluate_text(value)?;
            self.put(to, Value::Text(text))?;
        }
        Ok(given)
    }

    /// `Q5 SET UNDEFINED`; the same.
    pub(super) fn undefine(&mut self, parameter: Parameter, is_main: bool) -> Option<Value> {
        let given = self.given(parameter, is_main, || false);
        if given.is_none() {
            self.lost.known(parameter);
            self.unset(parameter);
        }
        given
    }

    fn unset(&mut self, parameter: Parameter) {
        self.given.overwritten(parameter);
        self.variables.unset(parameter);
        self.changed.push(parameter);
    }

    /// The value that was given before the run, if it takes the place of this assignment: the first one in the main
    /// program, unless the assignment uses the parameter's own value.
    fn given(&mut self, parameter: Parameter, is_main: bool, counts_on: impl Fn() -> bool) -> Option<Value> {
        let value = if is_main { self.given.take(parameter)? } else { return None };
        if counts_on() {
            return None;
        }
        self.given.used(parameter);
        self.changed.push(parameter);
        Some(value)
    }
}

/// Whether a control has the parameter.
fn exists(parameter: Parameter) -> Result<(), FaultKind> {
    let family = parameter.family;
    let numbers = parameter.family.numbers();
    if numbers.contains(&parameter.number) {
        return Ok(());
    }
    if !family.is_of_lathes() {
        return Err(FaultKind::NoParameter(parameter));
    }
    let (least, most) = numbers.into_inner();
    Err(FaultKind::NoVariable { variable: parameter, family: family.prefix(), least, most })
}

/// The upper global variables of a lathe control hold whole numbers; whether it would round others is not known.
fn check_whole(parameter: Parameter, value: &Value) -> Result<(), FaultKind> {
    if parameter.family != Family::LatheGlobal || parameter.number < FIRST_WHOLE_GLOBAL {
        return Ok(());
    }
    let number = match value {
        Value::Number(number) => *number,
        Value::Length(length) => length.to_mm_f64(),
        Value::Text(_) => return Ok(()),
    };
    if number.fract().abs() <= 0.0 { Ok(()) } else { Err(FaultKind::WholeOnly { parameter, value: number }) }
}

/// A number that a control can hold.
fn in_range(number: f64) -> Result<f64, FaultKind> {
    // NaN is outside every range.
    if number.abs() <= MOST { Ok(number) } else { Err(FaultKind::BeyondRange(number)) }
}

/// A whole number from 0, if the value is one.
pub(super) fn whole(value: f64) -> Option<usize> {
    const MOST: f64 = 1e15;
    if !(0.0..=MOST).contains(&value) || 0.0 < value.fract() {
        return None;
    }
    #[expect(
        clippy::as_conversions,
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "a whole number in range, just checked"
    )]
    Some(value as usize)
}

/// A value as programs write it.
pub fn shown(value: &Value) -> String {
    match value {
        Value::Length(length) => length.to_string(),
        Value::Number(number) => number.to_string(),
        Value::Text(text) => format!("\"{text}\""),
    }
}

/// The same within a sentence: numbers have the decimal sign of its language, texts stay as they are.
pub(super) fn shown_arg(value: &Value) -> Arg {
    match value {
        Value::Length(_) | Value::Number(_) => Arg::Number(shown(value)),
        Value::Text(_) => Arg::Text(shown(value)),
    }
}

/// The value, rounded to the nearest nanometre.
pub(super) fn length_of(value: &Value) -> Option<Length> {
    match value {
        Value::Length(length) => Some(*length),
        Value::Number(number) => Length::from_mm_f64(*number).ok(),
        Value::Text(_) => None,
    }
}
