//! Values of parameters: lengths, angles, whole numbers.

use std::collections::BTreeMap;
use std::fmt;
use std::str::FromStr;

use crate::length::{Length, LengthError};

/// A quarter turn in ten-thousandths of a degree.
pub(in crate::probing) const QUARTER_TURN: i64 = 900_000;

/// An angle in ten-thousandths of a degree, as the control writes it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle(pub(super) i64);

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
        let bare = text.trim();
        let bare = bare.strip_suffix('°').unwrap_or(bare);
        // A length may name its unit; 45 mm is no angle.
        if bare.contains(|c: char| c.is_alphabetic() || c == '°') {
            return Err(LengthError::NotANumber { text: text.trim().to_owned() });
        }
        let millionths = bare.parse::<Length>()?.nanometres();
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
    pub(super) fn with_unit(self) -> String {
        match self {
            Self::Length(length) => format!("{length} mm"),
            Self::Angle(_) | Self::Whole(_) => self.to_string(),
        }
    }
}

/// The values that a cycle is run with, by Q number.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Inputs {
    pub(super) given: BTreeMap<u16, Value>,
    pub(super) defaults: BTreeMap<u16, Value>,
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
    pub(in crate::probing) fn value(&self, q: u16) -> Option<Value> {
        self.given.get(&q).or_else(|| self.defaults.get(&q)).copied()
    }

    /// Whether a value was given, so that no default is taken.
    pub(in crate::probing) fn is_given(&self, q: u16) -> bool {
        self.given.contains_key(&q)
    }

    /// A length that [`Cycle::checked`] has put in.
    pub(in crate::probing) fn length(&self, q: u16) -> Length {
        if let Some(Value::Length(length)) = self.value(q) { length } else { Length::ZERO }
    }

    pub(in crate::probing) fn angle(&self, q: u16) -> Angle {
        if let Some(Value::Angle(angle)) = self.value(q) { angle } else { Angle::default() }
    }

    pub(in crate::probing) fn whole(&self, q: u16) -> i64 {
        if let Some(Value::Whole(whole)) = self.value(q) { whole } else { 0 }
    }
}
