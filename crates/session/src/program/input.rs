//! The seven inputs of 8255: their parameters, and what may be typed.

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::cycle::{self, Axis, Meaning};
use fitcheck_core::probing::cycles::measuring;
use fitcheck_core::tolerance::Feature;
use fitcheck_nc::control::variables::{Parameter, Value};

use crate::texts::Range;

/// An input of NC-Solution 8255 (7/2020).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Input {
    /// Nominal size, Q1, mm.
    Size,
    /// Tolerance class, QS1.
    Class,
    /// Centre in X, Q11, mm.
    CentreX,
    /// Centre in Y, Q21, mm.
    CentreY,
    /// Measuring height, Q31, mm.
    Height,
    /// Angle of the first contact, Q41, degrees.
    Angle,
    /// Set-up clearance, Q51, mm.
    Clearance,
}

impl Input {
    /// All of them, in the order of the program.
    pub const ALL: [Self; 7] =
        [Self::Size, Self::Class, Self::CentreX, Self::CentreY, Self::Height, Self::Angle, Self::Clearance];

    /// The parameter that holds it.
    pub const fn parameter(self) -> Parameter {
        match self {
            Self::Size => Parameter::q(1),
            Self::Class => Parameter::qs(1),
            Self::CentreX => Parameter::q(11),
            Self::CentreY => Parameter::q(21),
            Self::Height => Parameter::q(31),
            Self::Angle => Parameter::q(41),
            Self::Clearance => Parameter::q(51),
        }
    }

    /// The input that a parameter holds.
    pub(super) fn of(parameter: Parameter) -> Option<Self> {
        Self::ALL.into_iter().find(|input| input.parameter() == parameter)
    }

    pub const fn unit(self) -> &'static str {
        match self {
            Self::Class => "",
            Self::Angle => "°",
            _ => "mm",
        }
    }

    /// The parameter of the measuring cycle that it sets; the parameter says what is allowed.
    const fn of_cycle(self) -> Option<Meaning> {
        match self {
            Self::Size | Self::Class => None,
            Self::CentreX => Some(Meaning::Centre(Axis::First)),
            Self::CentreY => Some(Meaning::Centre(Axis::Second)),
            Self::Height => Some(Meaning::MeasuringHeight),
            Self::Angle => Some(Meaning::FirstAngle),
            Self::Clearance => Some(Meaning::SetUpClearance),
        }
    }

    /// Reads a text as the value of the parameter.
    pub(super) fn read(self, text: &str) -> Result<Value, Message> {
        let Some(meaning) = self.of_cycle() else {
            return match self {
                Self::Class => Ok(Value::Text(text.trim().to_owned())),
                _ => Range::AboveZero.read(text).map(Value::Length),
            };
        };
        let parameter = measuring(Feature::Hole).meant(meaning);
        match parameter.map(|parameter| parameter.accept(text)) {
            Some(Ok(cycle::Value::Length(length))) => Ok(Value::Length(length)),
            Some(Ok(cycle::Value::Angle(angle))) => Ok(Value::Number(angle.to_degrees_f64())),
            Some(Err(error)) => Err(error.message()),
            Some(Ok(_)) | None => Err(message!("field-not-whole").text("given", text.trim())),
        }
    }
}
