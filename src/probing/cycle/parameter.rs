//! The declaration of a parameter: Q number, name, range and default.

use std::fmt;

use super::CycleError;
use super::value::{Angle, Value};
use crate::length::{Length, LengthError};
use crate::words::{Message, Say};

/// One parameter of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Parameter {
    /// Its Q number.
    pub q: u16,
    /// Its name in English NC programs.
    pub name: &'static str,
    /// What it may be.
    pub range: Range,
    /// What it is when nothing is given; `None` where it must be given.
    pub default: Option<i64>,
}

/// What a parameter may be; the bounds are allowed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Range {
    /// A length, mm.
    Length {
        /// From.
        least: Length,
        /// To.
        most: Length,
    },
    /// An angle, degrees, at most so many either way, and at least so many in size.
    Angle {
        /// The most either way.
        most: Angle,
        /// The least in size; zero where every size is allowed.
        smallest: Angle,
    },
    /// One of a few numbers.
    OneOf(&'static [i64]),
    /// The number of a tool, 0 to 99999, or 0 for none.
    Tool,
}

/// What is allowed, as the second half of a range error.
impl fmt::Display for Range {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { least, most } => write!(f, "at least {least} mm, at most {most} mm"),
            Self::Angle { most, smallest } if *smallest == Angle::default() => write!(f, "at most {most} either way"),
            Self::Angle { most, smallest } => write!(f, "at least {smallest} in size, at most {most}"),
            Self::OneOf(allowed) => write!(f, "not one of {}", listed(allowed)),
            Self::Tool => f.write_str("a tool number is 0 to 99999"),
        }
    }
}

impl Say for Range {
    fn message(&self) -> Message {
        match self {
            Self::Length { least, most } => Message::new("cycle-length-range").text("least", least).text("most", most),
            Self::Angle { most, smallest } if *smallest == Angle::default() => {
                Message::new("cycle-angle-range").text("most", most)
            }
            Self::Angle { most, smallest } => {
                Message::new("cycle-angle-size-range").text("smallest", smallest).text("most", most)
            }
            Self::OneOf(allowed) => Message::new("cycle-one-of").text("allowed", listed(allowed)),
            Self::Tool => Message::new("cycle-tool-range"),
        }
    }
}

fn listed(numbers: &[i64]) -> String {
    numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ")
}

impl Parameter {
    /// A length within the control's ±99999.9999 mm.
    pub const fn coordinate(q: u16, name: &'static str) -> Self {
        let most = Length::constant(99_999_999_900);
        Self { q, name, range: Range::Length { least: most.negated(), most }, default: None }
    }

    /// A length from 0 to 99999.9999 mm.
    pub const fn size(q: u16, name: &'static str) -> Self {
        let most = Length::constant(99_999_999_900);
        Self { q, name, range: Range::Length { least: Length::ZERO, most }, default: None }
    }

    /// One of a few numbers.
    pub const fn choice(q: u16, name: &'static str, of: &'static [i64]) -> Self {
        Self { q, name, range: Range::OneOf(of), default: None }
    }

    /// An angle.
    pub const fn angle(q: u16, name: &'static str, most: i32, smallest: i32) -> Self {
        let range = Range::Angle { most: Angle::from_degrees(most), smallest: Angle::from_degrees(smallest) };
        Self { q, name, range, default: None }
    }

    /// The same with a default: nanometres, ten-thousandths of a degree, or the number itself.
    #[must_use]
    pub const fn or(mut self, default: i64) -> Self {
        self.default = Some(default);
        self
    }

    pub(super) fn default_value(&self) -> Option<Value> {
        let default = self.default?;
        Some(match self.range {
            Range::Length { .. } => Value::Length(Length::from_nanometres(default).ok()?),
            Range::Angle { .. } => Value::Angle(Angle(default)),
            Range::OneOf(_) | Range::Tool => Value::Whole(default),
        })
    }

    /// Whether a value is one that this parameter may have.
    pub fn allows(&self, value: Value) -> bool {
        match (self.range, value) {
            (Range::Length { least, most }, Value::Length(length)) => least <= length && length <= most,
            (Range::Angle { most, smallest }, Value::Angle(angle)) => {
                smallest.0 <= angle.0.saturating_abs() && angle.0.saturating_abs() <= most.0
            }
            (Range::OneOf(allowed), Value::Whole(whole)) => allowed.contains(&whole),
            (Range::Tool, Value::Whole(whole)) => (0..=99_999).contains(&whole),
            _ => false,
        }
    }

    /// Reads a value as people type it; the range is checked when the cycle runs.
    ///
    /// # Errors
    /// [`CycleError::NotAValue`] for a text that is no number of the declared kind.
    pub fn read(&self, text: &str) -> Result<Value, CycleError> {
        let read = match self.range {
            Range::Length { .. } => text.parse().map(Value::Length),
            Range::Angle { .. } => text.parse().map(Value::Angle),
            Range::OneOf(_) | Range::Tool => text
                .trim()
                .parse()
                .map(Value::Whole)
                .map_err(|_whole| LengthError::NotANumber { text: text.trim().to_owned() }),
        };
        read.map_err(|error| CycleError::NotAValue { q: self.q, name: self.name, error })
    }

    /// Reads a value and holds it against the range.
    ///
    /// # Errors
    /// [`CycleError::NotAValue`] or [`CycleError::OutOfRange`].
    pub fn accept(&self, text: &str) -> Result<Value, CycleError> {
        let value = self.read(text)?;
        if self.allows(value) { Ok(value) } else { Err(self.out_of_range(value)) }
    }

    /// The error for a value outside the range.
    pub(super) fn out_of_range(&self, value: Value) -> CycleError {
        CycleError::OutOfRange { q: self.q, name: self.name, given: value.with_unit(), range: self.range }
    }
}
