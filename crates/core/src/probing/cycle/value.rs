//! Values of parameters and results: lengths, angles, numbers, texts.

use std::fmt;
use std::str::FromStr;

use crate::length::{Length, LengthError};
use crate::message::{Message, message};
use crate::tolerance::{Deviations, Nominal};

/// A quarter turn in ten-thousandths of a degree.
pub(in crate::probing) const QUARTER_TURN: i64 = 900_000;

/// An angle in ten-thousandths of a degree, as the control writes it.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Angle(pub(super) i64);

impl Angle {
    /// An angle of this many whole degrees.
    pub const fn from_degrees(degrees: i32) -> Self {
        #[expect(clippy::as_conversions, reason = "widening in a const function")]
        Self(degrees as i64 * 10_000)
    }

    /// The nearest ten-thousandth of these degrees; zero for what is no number.
    pub fn nearest(degrees: f64) -> Self {
        Self(Length::from_mm_f64(degrees).map_or(0, |rounded| (rounded.nanometres() + 50).div_euclid(100)))
    }

    /// Ten-thousandths of a degree.
    pub const fn ten_thousandths(self) -> i64 {
        self.0
    }

    /// The angle turned on by this many steps, within one turn.
    #[must_use]
    pub fn stepped(self, step: Self, count: u8) -> Self {
        // Each less than a turn, so that the sum fits.
        let [start, step] = [self.0, step.0].map(|angle| angle.rem_euclid(4 * QUARTER_TURN));
        Self((start + step * i64::from(count)).rem_euclid(4 * QUARTER_TURN))
    }

    /// One of several equal parts of it, to the nearest ten-thousandth of a degree; of no parts as of one.
    #[must_use]
    pub fn divided(self, parts: u8) -> Self {
        let parts = i64::from(parts.max(1));
        Self((self.0 + parts / 2).div_euclid(parts))
    }

    /// The unit vector in this direction, exact at every quarter turn.
    pub fn direction(self) -> [f64; 2] {
        let turned = self.0.rem_euclid(4 * QUARTER_TURN);
        let beyond = Self(turned % QUARTER_TURN);
        let (sin, cos) = libm::sincos(beyond.to_degrees_f64().to_radians());
        match turned / QUARTER_TURN {
            0 => [cos, sin],
            1 => [-sin, cos],
            2 => [-cos, -sin],
            _ => [sin, -cos],
        }
    }

    /// Degrees as a float, for output.
    pub fn to_degrees_f64(self) -> f64 {
        self.as_length().to_mm_f64()
    }

    fn as_length(self) -> Length {
        Length::from_nanometres(self.0.saturating_mul(100)).unwrap_or(Length::MAX)
    }
}

impl FromStr for Angle {
    type Err = LengthError;

    /// Reads degrees with at most four decimals, point or comma: the same digits as a length.
    fn from_str(text: &str) -> Result<Self, LengthError> {
        let bare = text.trim();
        let bare = bare.strip_suffix('°').unwrap_or(bare);
        // A length may name its unit; 45 mm is not an angle.
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
        write!(f, "{}°", self.as_length())
    }
}

/// The value of a parameter or a result.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// Millimetres.
    Length(Length),
    /// Degrees.
    Angle(Angle),
    /// A choice or a marker.
    Whole(i64),
    /// A number without a unit: a component of a normal, the number of a tool.
    Number(f64),
    /// A text: the name of a tool.
    Text(String),
    /// A tolerance band about a nominal coordinate (QS400); `None` for no tolerance.
    Band(Option<Deviations>),
    /// A nominal value with or without limits, as cycles 14xx take it.
    Nominal(Nominal),
    /// The word PREDEF: the value from GLOBAL DEF.
    Predef,
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => length.fmt(f),
            Self::Angle(angle) => angle.fmt(f),
            Self::Whole(whole) => whole.fmt(f),
            Self::Number(number) => number.fmt(f),
            Self::Text(text) => f.pad(text),
            Self::Band(band) => f.pad(&band.as_ref().map_or_else(String::new, band_text)),
            Self::Nominal(nominal) => nominal.fmt(f),
            Self::Predef => f.pad(PREDEF),
        }
    }
}

/// The word that stands for the value of GLOBAL DEF.
pub(super) const PREDEF: &str = "PREDEF";

/// A band as in QS400: `0.4-0.1`, `0.4`, `-0.1`.
fn band_text(band: &Deviations) -> String {
    let upper = band.upper();
    let lower = band.lower();
    let plus = if Length::ZERO <= lower { "+" } else { "" };
    match (upper == Length::ZERO, lower == Length::ZERO) {
        (_, true) => upper.to_string(),
        (true, _) => lower.to_string(),
        _ => format!("{upper}{plus}{lower}"),
    }
}

impl Value {
    /// The millimetres of a length or of a nominal value, whose tolerance is left out.
    pub const fn length(&self) -> Option<Length> {
        match self {
            Self::Length(length) => Some(*length),
            Self::Nominal(nominal) => Some(nominal.value()),
            _ => None,
        }
    }

    /// The value with its unit. A text stays as it is; numbers are printed as each language prints them.
    pub fn with_unit(&self) -> Message {
        match self {
            Self::Length(length) => message!("cycle-value-length").number("value", length),
            Self::Band(None) => message!("cycle-value-no-tolerance"),
            Self::Nominal(nominal) if nominal.limits().is_none() => {
                message!("cycle-value-length").number("value", nominal.value())
            }
            Self::Text(text) => message!("cycle-value").text("value", text),
            _ => message!("cycle-value").number("value", self),
        }
    }
}
