//! What a measuring cycle declares: its parameters, once, with name, unit, range and default.
//!
//! Range errors, and later forms and NC blocks, are made from the declaration. Where contacts come from is not a
//! cycle's business.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use super::circle::{Circle, CircleError};
use super::contact::{Contact, NoContact, Prober};
use crate::length::{Length, LengthError};
use crate::verdict::{PositionVerdict, Status};
use crate::words::{Language, Message, Say};

/// A measuring cycle of the control.
#[derive(Debug)]
pub struct Cycle {
    /// Its number, 421.
    pub number: u16,
    /// Its name in NC programs, by dialogue language.
    pub names: &'static [(Language, &'static str)],
    /// Its parameters in the order of NC programs.
    pub parameters: &'static [Parameter],
    /// Runs it.
    pub run: fn(&Inputs, &mut dyn Prober) -> Result<CycleResult, CycleError>,
}

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

/// A quarter turn in ten-thousandths of a degree.
pub(super) const QUARTER_TURN: i64 = 900_000;

/// An angle in ten-thousandths of a degree, as the control writes it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle(i64);

impl Angle {
    /// An angle of so many whole degrees.
    pub const fn from_degrees(degrees: i32) -> Self {
        #[expect(clippy::as_conversions, reason = "widening in a const function")]
        Self(degrees as i64 * 10_000)
    }

    /// Ten-thousandths of a degree.
    pub const fn ten_thousandths(self) -> i64 {
        self.0
    }

    /// The angle so many steps further, within one turn.
    #[must_use]
    pub fn stepped(self, step: Self, count: u8) -> Self {
        let turned = i128::from(self.0) + i128::from(step.0) * i128::from(count);
        // Less than a turn, so it fits.
        Self(i64::try_from(turned.rem_euclid(i128::from(4 * QUARTER_TURN))).unwrap_or_default())
    }

    /// The unit vector in this direction, exact at every quarter turn.
    pub fn direction(self) -> [f64; 2] {
        let turned = self.0.rem_euclid(4 * QUARTER_TURN);
        let beyond = i32::try_from(turned % QUARTER_TURN).unwrap_or_default();
        let (sin, cos) = (f64::from(beyond) / 10_000.0).to_radians().sin_cos();
        match turned / QUARTER_TURN {
            0 => [cos, sin],
            1 => [-sin, cos],
            2 => [-cos, -sin],
            _ => [sin, -cos],
        }
    }
}

impl FromStr for Angle {
    type Err = LengthError;

    /// Reads degrees with at most four decimals, point or comma: the same figures as a length.
    fn from_str(text: &str) -> Result<Self, LengthError> {
        let millionths = text.trim().trim_end_matches('°').parse::<Length>()?.nanometres();
        if millionths % 100 != 0 {
            return Err(LengthError::TooFine { text: text.trim().to_owned() });
        }
        Ok(Self(millionths / 100))
    }
}

/// Degrees with only the decimals they have.
impl fmt::Display for Angle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let degrees = Length::from_nanometres(self.0.saturating_mul(100)).unwrap_or(Length::MAX);
        write!(f, "{degrees}°")
    }
}

/// The value of a parameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// Millimetres.
    Length(Length),
    /// Degrees.
    Angle(Angle),
    /// A choice or a tool's number.
    Whole(i64),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => length.fmt(f),
            Self::Angle(angle) => angle.fmt(f),
            Self::Whole(whole) => whole.fmt(f),
        }
    }
}

impl Value {
    /// The value with its unit, for errors.
    fn with_unit(self) -> String {
        match self {
            Self::Length(length) => format!("{length} mm"),
            Self::Angle(_) | Self::Whole(_) => self.to_string(),
        }
    }
}

/// The values that a cycle is run with, by Q number.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Inputs {
    given: BTreeMap<u16, Value>,
    defaults: BTreeMap<u16, Value>,
}

impl Inputs {
    /// Nothing given.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives a parameter a value; it is checked when the cycle runs.
    #[must_use]
    pub fn with(mut self, q: u16, value: Value) -> Self {
        self.given.insert(q, value);
        self
    }

    /// The value that was given, or the default that [`Cycle::checked`] has put in.
    fn value(&self, q: u16) -> Option<Value> {
        self.given.get(&q).or_else(|| self.defaults.get(&q)).copied()
    }

    /// Whether a value was given, so that no default is taken.
    pub(super) fn is_given(&self, q: u16) -> bool {
        self.given.contains_key(&q)
    }

    /// A length that [`Cycle::checked`] has put in.
    pub(super) fn length(&self, q: u16) -> Length {
        if let Some(Value::Length(length)) = self.value(q) { length } else { Length::ZERO }
    }

    pub(super) fn angle(&self, q: u16) -> Angle {
        if let Some(Value::Angle(angle)) = self.value(q) { angle } else { Angle::default() }
    }

    pub(super) fn whole(&self, q: u16) -> i64 {
        if let Some(Value::Whole(whole)) = self.value(q) { whole } else { 0 }
    }
}

/// What a cycle found.
#[derive(Debug, Clone, PartialEq)]
pub struct CycleResult {
    /// The contacts in probing order.
    pub contacts: Vec<Contact>,
    /// The least-squares circle, unrounded, mm.
    pub circle: Circle,
    /// The centre, at the nearest nanometre.
    pub centre: [Length; 2],
    /// The diameter, at the nearest nanometre.
    pub diameter: Length,
    /// The centre against its nominal position.
    pub position: PositionVerdict,
    /// The status that the markers tell; `Good` also where no limits were given, as on the control.
    pub status: Status,
    /// The result parameters by Q number: lengths in mm, markers 0 or 1.
    pub results: Vec<(u16, Value)>,
}

/// Why a cycle did not run, or not to its end.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CycleError {
    /// A parameter is outside its range.
    #[error("Q{q} {name} = {given}: {range}")]
    OutOfRange {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
        /// What was given.
        given: String,
        /// What is allowed.
        range: Range,
    },
    /// A text is no value for a parameter.
    #[error("Q{q} {name}: {error}")]
    NotAValue {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
        /// What is wrong with the text.
        error: LengthError,
    },
    /// A parameter without a default was not given.
    #[error("Q{q} {name} is missing")]
    Missing {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
    },
    /// A parameter that the cycle does not have.
    #[error("cycle {cycle} has no parameter Q{q}")]
    NoSuchParameter {
        /// The cycle.
        cycle: u16,
        /// The parameter.
        q: u16,
    },
    /// The minimum is above the maximum.
    #[error("minimum dimension {minimum} mm is above maximum dimension {maximum} mm")]
    LimitsSwapped {
        /// The minimum.
        minimum: Length,
        /// The maximum.
        maximum: Length,
    },
    /// A nominal diameter of zero.
    #[error("Q{q} {name} = 0 mm: a circle needs a diameter above 0")]
    NoDiameter {
        /// The parameter.
        q: u16,
        /// Its name.
        name: &'static str,
    },
    /// The probe met nothing.
    #[error(transparent)]
    NoContact(#[from] NoContact),
    /// The contacts make no circle.
    #[error(transparent)]
    Circle(#[from] CircleError),
    /// The result is beyond what a length can hold.
    #[error("the measured circle is too large: {0}")]
    TooLarge(LengthError),
}

impl Say for CycleError {
    fn message(&self) -> Message {
        match self {
            Self::OutOfRange { q, name, given, range } => Message::new("cycle-out-of-range")
                .text("q", q)
                .text("name", name)
                .text("given", given)
                .message("allowed", range.message()),
            Self::NotAValue { q, name, error } => {
                Message::new("cycle-not-a-value").text("q", q).text("name", name).message("error", error.message())
            }
            Self::NoDiameter { q, name } => Message::new("cycle-no-diameter").text("q", q).text("name", name),
            Self::Missing { q, name } => Message::new("cycle-missing").text("q", q).text("name", name),
            Self::NoSuchParameter { cycle, q } => {
                Message::new("cycle-no-such-parameter").text("cycle", cycle).text("q", q)
            }
            Self::LimitsSwapped { minimum, maximum } => {
                Message::new("cycle-limits-swapped").mm("minimum", *minimum).mm("maximum", *maximum)
            }
            Self::NoContact(error) => error.message(),
            Self::Circle(error) => error.message(),
            Self::TooLarge(error) => Message::new("cycle-too-large").message("error", error.message()),
        }
    }
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

    fn default_value(&self) -> Option<Value> {
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
}

impl Cycle {
    /// The name in a language; English where the language has none.
    pub fn name(&self, language: Language) -> &'static str {
        let of = |wanted| self.names.iter().find(|(language, _)| *language == wanted).map(|(_, name)| *name);
        of(language).or_else(|| of(Language::En)).unwrap_or_default()
    }

    /// A parameter by its Q number.
    pub fn parameter(&self, q: u16) -> Option<&'static Parameter> {
        self.parameters.iter().find(|parameter| parameter.q == q)
    }

    /// Checks the values against the declaration, fills in defaults and runs the cycle.
    ///
    /// # Errors
    /// [`CycleError`] names the parameter, the value and what is allowed, or what went wrong on the way.
    pub fn measure(&self, inputs: &Inputs, prober: &mut dyn Prober) -> Result<CycleResult, CycleError> {
        (self.run)(&self.checked(inputs)?, prober)
    }

    fn checked(&self, inputs: &Inputs) -> Result<Inputs, CycleError> {
        if let Some(&q) = inputs.given.keys().find(|q| self.parameter(**q).is_none()) {
            return Err(CycleError::NoSuchParameter { cycle: self.number, q });
        }
        let mut checked = inputs.clone();
        for parameter in self.parameters {
            let (q, name) = (parameter.q, parameter.name);
            if let Some(default) = parameter.default_value() {
                checked.defaults.insert(q, default);
            }
            let value = checked.value(q).ok_or(CycleError::Missing { q, name })?;
            if !parameter.allows(value) {
                let (given, range) = (value.with_unit(), parameter.range);
                return Err(CycleError::OutOfRange { q, name, given, range });
            }
        }
        Ok(checked)
    }
}
