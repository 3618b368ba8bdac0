//! The control's parameters: Q, QL and QR of milling controls hold numbers, QS holds text. The variables of lathe controls
//! are families of their own: `#l`, `#c`, `#g` and `#i` hold numbers, `#x` holds text.
//!
//! A parameter that was never set is undefined; reading it gives `None`, never zero.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::RangeInclusive;

use fitcheck_core::message::Say;

fitcheck_core::named! {
    /// Which family a parameter belongs to.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Family {
        /// All families.
        ALL;
        /// What precedes the number: `Q`, `#l`.
        fn prefix;
        /// Global numbers.
        Q = "Q",
        /// Numbers local to a program.
        Ql = "QL",
        /// Numbers that survive power-off.
        Qr = "QR",
        Qs = "QS",
        /// `#l1`: numbers of a lathe control, local to a program.
        LatheLocal = "#l",
        /// `#c1`: numbers of a lathe control, of the channel.
        LatheChannel = "#c",
        /// `#g1`: numbers of a lathe control that survive power-off; from 200 on whole numbers.
        LatheGlobal = "#g",
        /// `#x1`: texts of a lathe control.
        LatheText = "#x",
        /// `#i99`: what a lathe control itself provides.
        LatheControl = "#i",
    }
}

/// The first of the global variables of a lathe control that hold only whole numbers.
pub const FIRST_WHOLE_GLOBAL: u16 = 200;

impl Family {
    /// The numbers that a control has. Those of milling controls are from their manuals, those of lathe controls general
    /// knowledge, those of `#i` ours: only `#i99` is known (`docs/SOURCES.md`).
    pub const fn numbers(self) -> RangeInclusive<u16> {
        match self {
            Self::Q | Self::Qs => 0..=1_999,
            Self::Ql | Self::Qr => 0..=499,
            Self::LatheLocal => 1..=99,
            Self::LatheChannel => 1..=30,
            Self::LatheGlobal => 1..=299,
            Self::LatheText => 1..=20,
            Self::LatheControl => 1..=999,
        }
    }

    /// Whether it holds texts.
    pub const fn is_text(self) -> bool {
        matches!(self, Self::Qs | Self::LatheText)
    }

    /// Whether it is one of a lathe control.
    pub fn is_of_lathes(self) -> bool {
        self.prefix().starts_with('#')
    }
}

/// The name of a parameter: `Q153`, `QS3`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Parameter {
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
        let family = self.family.prefix();
        f.pad(&format!("{family}{}", self.number))
    }
}

fitcheck_core::message::as_text!(Parameter);

/// A text that does not name a parameter.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(id = "no-parameter", error)]
pub struct NoParameter(#[say(name = "given")] pub String);

impl std::str::FromStr for Parameter {
    type Err = NoParameter;

    /// `Q1`, `ql5`, `QS400`, `#l1`.
    fn from_str(text: &str) -> Result<Self, NoParameter> {
        let given = text.trim();
        let none = || NoParameter(given.to_owned());
        let (prefix, digits) =
            given.split_at_checked(given.find(|c: char| c.is_ascii_digit()).ok_or_else(none)?).ok_or_else(none)?;
        let known = |family: &Family| family.prefix().eq_ignore_ascii_case(prefix);
        let family = Family::ALL.into_iter().find(known).ok_or_else(none)?;
        let is_number = digits.bytes().all(|byte| byte.is_ascii_digit());
        let number = digits.parse().ok().filter(|_| is_number);
        number.map(|number| Self { family, number }).ok_or_else(none)
    }
}

#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// A number that is a length in millimetres, exact.
    Length(fitcheck_core::length::Length),
    Number(f64),
    Text(String),
}

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
