//! How a material gives way: modulus of elasticity, Poisson's ratio, yield strength.

use std::fmt;
use std::str::FromStr;

use crate::length::{decimal_parts, without_zeros};
use crate::message::{IntoArg, Say, printed};

/// A number from 0 to 1 in whole thousandths: a coefficient of friction, Poisson's ratio.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Ratio(u16);

/// A text that is no [`Ratio`].
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(id = "press-ratio", error)]
pub struct RatioError {
    /// What was given.
    pub text: String,
}

/// How a material gives way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Elastic {
    /// Modulus of elasticity in MPa, above zero.
    pub modulus_mpa: u32,
    /// Poisson's ratio.
    pub poisson: Ratio,
    /// Yield strength in MPa, where one may be assumed.
    pub yield_mpa: Option<u32>,
}

impl Ratio {
    /// So many thousandths; `None` above 1.
    pub fn from_thousandths(thousandths: u16) -> Option<Self> {
        Some(Self(thousandths)).filter(|ratio| ratio.0 <= 1_000)
    }

    /// As a float.
    pub fn value(self) -> f64 {
        f64::from(self.0) / 1e3
    }
}

impl FromStr for Ratio {
    type Err = RatioError;

    /// Reads a decimal number from 0 to 1 with point or comma and at most three decimals.
    fn from_str(text: &str) -> Result<Self, RatioError> {
        let given = text.trim();
        let read = || {
            let (whole, decimals) = decimal_parts(given)?;
            let decimals = decimals.trim_end_matches('0');
            let whole = whole.trim_start_matches('0');
            let thousandths =
                if 3 < decimals.len() || 1 < whole.len() { None } else { Some(format!("{whole}{decimals:0<3}")) };
            Self::from_thousandths(thousandths?.parse().ok()?)
        };
        read().ok_or_else(|| RatioError { text: given.chars().take(40).collect() })
    }
}

impl fmt::Display for Ratio {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(without_zeros(&format!("{}.{:03}", self.0 / 1_000, self.0 % 1_000)))
    }
}

/// With the decimal sign of the language.
impl IntoArg for Ratio {
    fn arg(&self) -> crate::message::Arg {
        printed(self)
    }
}

impl Elastic {
    /// The modulus as a float, MPa.
    pub fn modulus(&self) -> f64 {
        f64::from(self.modulus_mpa)
    }
}
