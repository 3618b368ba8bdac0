//! The control's parameters: Q, QL and QR hold numbers, QS holds text.
//!
//! A parameter that was never set is undefined; reading it gives `None`, never zero.

use std::collections::BTreeMap;
use std::fmt;

use crate::message::Say;

/// Which family a parameter belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Family {
    /// Global numbers.
    Q,
    /// Numbers local to a program.
    Ql,
    /// Numbers that survive power-off.
    Qr,
    /// Texts.
    Qs,
}

/// The name of a parameter: `Q153`, `QS3`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Parameter {
    /// The family.
    pub family: Family,
    /// The number within the family.
    pub number: u16,
}

impl Parameter {
    /// `Qn`.
    pub const fn q(number: u16) -> Self {
        Self { family: Family::Q, number }
    }

    /// `QSn`.
    pub const fn qs(number: u16) -> Self {
        Self { family: Family::Qs, number }
    }
}

impl fmt::Display for Parameter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let family = match self.family {
            Family::Q => "Q",
            Family::Ql => "QL",
            Family::Qr => "QR",
            Family::Qs => "QS",
        };
        f.pad(&format!("{family}{}", self.number))
    }
}

crate::message::as_text!(Parameter);

/// A text that does not name a parameter.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(id = "no-parameter", error)]
pub struct NoParameter(#[say(name = "given")] pub String);

impl std::str::FromStr for Parameter {
    type Err = NoParameter;

    /// `Q1`, `ql5`, `QS400`.
    fn from_str(text: &str) -> Result<Self, NoParameter> {
        let given = text.trim();
        let name = given.to_ascii_uppercase();
        let digits = name.trim_start_matches(|c: char| c.is_ascii_alphabetic());
        let family = match name.strip_suffix(digits) {
            Some("Q") => Family::Q,
            Some("QL") => Family::Ql,
            Some("QR") => Family::Qr,
            Some("QS") => Family::Qs,
            _ => return Err(NoParameter(given.to_owned())),
        };
        let is_number = digits.bytes().all(|byte| byte.is_ascii_digit());
        let number = digits.parse().ok().filter(|_| is_number);
        number.map(|number| Self { family, number }).ok_or_else(|| NoParameter(given.to_owned()))
    }
}

/// The value of a parameter.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number that is a length in millimetres, exact.
    Length(crate::length::Length),
    /// Any other number.
    Number(f64),
    /// A text.
    Text(String),
}

/// All parameters that have a value.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Variables(BTreeMap<Parameter, Value>);

impl Variables {
    /// Nothing defined.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives a parameter a value.
    pub fn set(&mut self, parameter: Parameter, value: Value) {
        self.0.insert(parameter, value);
    }

    /// The value, or `None` if it is undefined.
    pub fn get(&self, parameter: Parameter) -> Option<&Value> {
        self.0.get(&parameter)
    }

    /// Makes a parameter undefined.
    pub fn unset(&mut self, parameter: Parameter) {
        self.0.remove(&parameter);
    }

    /// Makes all parameters of a family undefined and returns their old values.
    pub fn take(&mut self, family: Family) -> Vec<(Parameter, Value)> {
        let of = |number| Parameter { family, number };
        self.0.extract_if(of(0)..=of(u16::MAX), |_, _| true).collect()
    }

    /// All defined parameters in order.
    pub fn iter(&self) -> impl Iterator<Item = (Parameter, &Value)> {
        self.0.iter().map(|(&parameter, value)| (parameter, value))
    }
}
