//! The declaration of a parameter: key, name, question, range and what applies when it is not given.

use super::error::{CycleError, ToolFault};
use super::inputs::Inputs;
use super::key::Key;
use super::meaning::Meaning;
use super::name::ParameterName;
use super::range::{HIGHEST_TOOL, LONGEST_TEXT, Range};
use super::texts::{Texts, in_language};
use super::value::{Angle, PREDEF, Value};
use crate::length::{Length, LengthError};
use crate::message::{Arg, Say};
use crate::tolerance::callout::qs400;
use crate::tolerance::{Nominal, NominalError};
use crate::words::Dialogue;

/// One parameter of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parameter {
    /// What programs call it.
    pub key: Key,
    /// Its name in English NC programs, after the semicolon of a block.
    pub name: &'static str,
    /// The same in other dialogue languages, where there is one.
    pub names: Texts,
    /// The question that the control asks, where it is known or worded here (docs/SOURCES.md).
    pub questions: Texts,
    /// The values that are allowed.
    pub range: Range,
    /// What it means: how it is drawn, and which sentence explains it.
    pub meaning: Meaning,
    /// What applies when no value is given.
    pub unset: Unset,
    /// Another default for when another parameter has a certain value.
    pub unset_where: Option<UnsetWhere>,
    /// Whether PREDEF may stand for the value of GLOBAL DEF.
    pub may_be_predef: bool,
    /// Whether it has an effect; the others are only accepted and kept, and a form need not ask for them.
    pub has_effect: bool,
}

/// What applies when a parameter is not given.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unset {
    /// It must be given.
    Refused,
    /// It has no value, and the cycle runs without one.
    Empty,
    /// A value: nanometres, ten-thousandths of a degree, or the number itself.
    Value(i64),
}

/// The default of a parameter for when another one, a choice, has a certain value.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnsetWhere {
    /// The other parameter.
    pub key: Key,
    /// Its value.
    pub is: i64,
    /// The default in that case, as in [`Unset::Value`].
    pub default: i64,
}

impl Parameter {
    /// A parameter that must be given.
    pub const fn new(key: Key, name: &'static str, range: Range) -> Self {
        Self {
            key,
            name,
            names: &[],
            questions: &[],
            range,
            meaning: Meaning::of_range(range),
            unset: Unset::Refused,
            unset_where: None,
            may_be_predef: false,
            has_effect: true,
        }
    }

    /// A length within the control's ±99999.9999 mm.
    pub const fn coordinate(key: Key, name: &'static str) -> Self {
        let most = Length::constant(99_999_999_900);
        Self::new(key, name, Range::Length { least: most.negated(), most })
    }

    /// A length from 0 to 99999.9999 mm.
    pub const fn size(key: Key, name: &'static str) -> Self {
        let most = Length::constant(99_999_999_900);
        Self::new(key, name, Range::Length { least: Length::ZERO, most })
    }

    /// A nominal coordinate of cycles 14xx within the control's ±99999.9999 mm, with or without a tolerance.
    pub const fn nominal_coordinate(number: u16, name: &'static str) -> Self {
        let most = Length::constant(99_999_999_900);
        Self::new(Key::Qs(number), name, Range::Nominal { least: most.negated(), most })
    }

    /// A nominal size of cycles 14xx from 0 to 99999.9999 mm, with or without a tolerance.
    pub const fn nominal_size(number: u16, name: &'static str) -> Self {
        let most = Length::constant(99_999_999_900);
        Self::new(Key::Qs(number), name, Range::Nominal { least: Length::ZERO, most })
    }

    /// One of a few numbers.
    pub const fn choice(key: Key, name: &'static str, of: &'static [i64]) -> Self {
        Self::new(key, name, Range::OneOf(of))
    }

    /// An angle in degrees, at most `most` either way and at least `smallest` in size.
    pub const fn angle(key: Key, name: &'static str, most: i32, smallest: i32) -> Self {
        let range = Range::Angle { most: Angle::from_degrees(most), smallest: Angle::from_degrees(smallest) };
        Self::new(key, name, range)
    }

    /// The same with other numbers to choose from.
    #[must_use]
    pub const fn of(mut self, numbers: &'static [i64]) -> Self {
        self.range = Range::OneOf(numbers);
        self
    }

    /// The same with a meaning of its own.
    #[must_use]
    pub const fn means(mut self, meaning: Meaning) -> Self {
        self.meaning = meaning;
        self
    }

    /// The same with a default: nanometres, ten-thousandths of a degree, or the number itself.
    #[must_use]
    pub const fn or(mut self, default: i64) -> Self {
        self.unset = Unset::Value(default);
        self
    }

    /// The same with another default where another parameter, a choice, has a certain value.
    #[must_use]
    pub const fn or_where(mut self, key: Key, is: i64, default: i64) -> Self {
        self.unset_where = Some(UnsetWhere { key, is, default });
        self
    }

    /// The same, but it must be given.
    #[must_use]
    pub const fn required(mut self) -> Self {
        self.unset = Unset::Refused;
        self.unset_where = None;
        self
    }

    /// The same, but it may be left out.
    #[must_use]
    pub const fn or_nothing(mut self) -> Self {
        self.unset = Unset::Empty;
        self
    }

    /// The same under another number, which other cycles use for the same thing.
    #[must_use]
    pub const fn at(mut self, number: u16) -> Self {
        self.key = Key::Q(number);
        self
    }

    /// The same with the control's names in other languages.
    #[must_use]
    pub const fn named(mut self, names: Texts) -> Self {
        self.names = names;
        self
    }

    /// The same with the control's questions.
    #[must_use]
    pub const fn asked(mut self, questions: Texts) -> Self {
        self.questions = questions;
        self
    }

    /// The same with PREDEF allowed.
    #[must_use]
    pub const fn or_predef(mut self) -> Self {
        self.may_be_predef = true;
        self
    }

    /// The same, but only accepted and kept.
    #[must_use]
    pub const fn without_effect(mut self) -> Self {
        self.has_effect = false;
        self
    }

    /// The name in a dialogue language; English where the language has none.
    pub fn name_in(&self, language: Dialogue) -> &'static str {
        in_language(self.names, language).unwrap_or(self.name)
    }

    /// The name as errors say it.
    pub const fn called(&self) -> ParameterName {
        ParameterName::new(self.name, self.names)
    }

    /// The control's question in a dialogue language; else in English, else the name.
    pub fn question(&self, language: Dialogue) -> &'static str {
        in_language(self.questions, language)
            .or_else(|| in_language(self.questions, Dialogue::En))
            .unwrap_or_else(|| self.name_in(language))
    }

    /// The value that applies when none is given and no other parameter changes it.
    pub fn default_value(&self) -> Option<Value> {
        if let Unset::Value(default) = self.unset { self.value_of(default) } else { None }
    }

    /// The value that applies when none is given, depending on the other parameters.
    pub fn default_with(&self, inputs: &Inputs) -> Option<Value> {
        match self.unset_where {
            Some(UnsetWhere { key, is, default }) if inputs.value(key) == Some(&Value::Whole(is)) => {
                self.value_of(default)
            }
            _ => self.default_value(),
        }
    }

    fn value_of(&self, default: i64) -> Option<Value> {
        Some(match self.range {
            Range::Length { .. } => Value::Length(Length::from_nanometres(default).ok()?),
            Range::Nominal { .. } => Value::Nominal(Nominal::of(Length::from_nanometres(default).ok()?)),
            Range::Angle { .. } => Value::Angle(Angle(default)),
            Range::OneOf(_) | Range::Count { .. } => Value::Whole(default),
            Range::Number { .. } | Range::Tool => Value::Number(f64::from(i32::try_from(default).ok()?)),
            Range::Band => Value::Band(None),
        })
    }

    /// Whether this parameter may have a value.
    pub fn allows(&self, value: &Value) -> bool {
        match (self.range, value) {
            (_, Value::Predef) => self.may_be_predef,
            (Range::Length { least, most }, Value::Length(length)) => least <= *length && *length <= most,
            (Range::Nominal { least, most }, Value::Nominal(nominal)) => {
                let (minimum, maximum) = nominal.limits().unwrap_or((least, most));
                let in_range = |length: Length| least <= length && length <= most;
                in_range(nominal.value()) && in_range(minimum) && in_range(maximum)
            }
            (Range::Angle { most, smallest }, Value::Angle(angle)) => {
                smallest.0 <= angle.0.saturating_abs() && angle.0.saturating_abs() <= most.0
            }
            (Range::OneOf(allowed), Value::Whole(whole)) => allowed.contains(whole),
            (Range::Count { most }, Value::Whole(whole)) => (0..=i64::from(most)).contains(whole),
            // NaN is outside every range.
            (Range::Number { most }, Value::Number(number)) => number.abs() <= f64::from(most),
            (Range::Tool, Value::Number(number)) => {
                let decimals = number.to_string().split_once('.').map_or(0, |(_, decimals)| decimals.len());
                (0.0..=HIGHEST_TOOL).contains(number) && decimals <= 1
            }
            (Range::Tool, Value::Text(name)) => !name.is_empty() && name.chars().count() <= LONGEST_TEXT,
            (Range::Band, Value::Band(_)) => true,
            _ => false,
        }
    }

    /// Reads a value as people type it; the range is checked when the cycle runs.
    ///
    /// # Errors
    /// [`CycleError::NotAValue`] for a text that is not a value of the declared kind, [`CycleError::OutOfRange`] for a
    /// choice that is not a whole number.
    pub fn read(&self, text: &str) -> Result<Value, CycleError> {
        if self.may_be_predef && text.trim().eq_ignore_ascii_case(PREDEF) {
            return Ok(Value::Predef);
        }
        let read = match self.range {
            Range::Length { .. } => text.parse().map(Value::Length).map_err(|error: LengthError| error.message()),
            Range::Nominal { .. } => text.parse().map(Value::Nominal).map_err(|error: NominalError| error.message()),
            Range::Angle { .. } => text.parse().map(Value::Angle).map_err(|error: LengthError| error.message()),
            Range::OneOf(_) | Range::Count { .. } => match (whole(text), number(text)) {
                (Some(whole), _) => Ok(Value::Whole(whole)),
                (None, Some(_)) => {
                    let given = Arg::Number(text.trim().to_owned());
                    let range = self.range;
                    let name = self.called();
                    let given = Box::new(given);
                    return Err(CycleError::OutOfRange { key: self.key, name, given, range });
                }
                (None, None) => Err(no_number(text).message()),
            },
            Range::Number { .. } => number(text).map(Value::Number).ok_or_else(|| no_number(text).message()),
            Range::Tool if text.trim().is_empty() => Err(ToolFault::Empty.message()),
            Range::Tool => match number(text) {
                Some(number) => Ok(Value::Number(number)),
                None if is_tool_name(text.trim()) => Ok(Value::Text(text.trim().to_owned())),
                None => Err(ToolFault::NoName { text: text.trim().to_owned() }.message()),
            },
            Range::Band => qs400(text).map(Value::Band).map_err(|error| error.message()),
        };
        read.map_err(|error| CycleError::NotAValue { key: self.key, name: self.called(), error })
    }

    /// Reads a word that stands in a block without quotation marks: the name of a tool has some.
    ///
    /// # Errors
    /// [`CycleError::NotAValue`].
    pub fn read_word(&self, word: &str) -> Result<Value, CycleError> {
        if self.range == Range::Tool && number(word).is_none() {
            let error = ToolFault::Unquoted { text: word.to_owned() }.message();
            return Err(CycleError::NotAValue { key: self.key, name: self.called(), error });
        }
        self.read(word)
    }

    /// Reads a value and checks it against the range.
    ///
    /// # Errors
    /// [`CycleError::NotAValue`] or [`CycleError::OutOfRange`].
    pub fn accept(&self, text: &str) -> Result<Value, CycleError> {
        let value = self.read(text)?;
        if self.allows(&value) { Ok(value) } else { Err(self.out_of_range(&value)) }
    }

    /// The error for a value outside the range.
    pub(super) fn out_of_range(&self, value: &Value) -> CycleError {
        let given = Box::new(Arg::Message(value.with_unit()));
        CycleError::OutOfRange { key: self.key, name: self.called(), given, range: self.range }
    }
}

/// Whether a text may be the name of a tool. One that begins like a number has only letters, figures and the signs that a control
/// takes in names (TNC 640, ISO programming), so that `+0*` and `25*` are slips and `5_MILL` is a name.
fn is_tool_name(text: &str) -> bool {
    let is_allowed = |c: char| c.is_ascii_alphanumeric() || "#$%&,-_.@".contains(c);
    !text.starts_with(['+', '-', '\u{2212}'])
        && (!text.starts_with(|c: char| c.is_ascii_digit()) || text.chars().all(is_allowed))
}

fn no_number(text: &str) -> LengthError {
    let text = text.trim();
    if text.is_empty() { LengthError::Empty } else { LengthError::NotANumber { text: text.to_owned() } }
}

/// A whole number, also with decimals that are all zero, because programs write 3 as 3.0.
fn whole(text: &str) -> Option<i64> {
    let text = text.trim().replace('\u{2212}', "-");
    let (whole, decimals) = text.split_once(['.', ',']).unwrap_or((&text, ""));
    if decimals.bytes().all(|byte| byte == b'0') { whole.parse().ok() } else { None }
}

/// A finite decimal number with point or comma. Words such as `nan` and `inf` do not count.
pub fn number(text: &str) -> Option<f64> {
    let plain = text.trim().replace(',', ".").replace('\u{2212}', "-");
    let begins = plain.trim_start_matches(['+', '-']).starts_with(|c: char| c.is_ascii_digit() || c == '.');
    let figures = plain.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    if begins && figures { plain.parse().ok().filter(|number: &f64| number.is_finite()) } else { None }
}
