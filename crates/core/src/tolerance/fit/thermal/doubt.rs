//! Whether a temperature is what was meant: degrees Fahrenheit or kelvin that are read as Celsius, and temperatures at which a coefficient
//! of expansion says nothing.

use super::{Expansion, Temperature};
use crate::message::Say;

/// From where to where something holds, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Range {
    /// The lowest temperature.
    pub least: Temperature,
    /// The highest.
    pub most: Temperature,
}

impl Range {
    /// Where a part and the scales are while a value is measured: whoever measures further off says so.
    pub const MEASURED: Self = Self::celsius(-20, 50);

    /// Where a coefficient of expansion holds that does not say it: one near 20 °C is off by some tenths of itself beyond.
    pub const USUAL: Self = Self::celsius(-50, 200);

    const fn celsius(least: i32, most: i32) -> Self {
        Self { least: Temperature(least * 1_000), most: Temperature(most * 1_000) }
    }

    /// Whether a temperature lies in it.
    pub fn contains(self, temperature: Temperature) -> bool {
        self.least <= temperature && temperature <= self.most
    }
}

/// Why a temperature is doubted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "thermal-doubt", error)]
pub enum ThermalDoubt {
    /// As degrees Fahrenheit it would be a usual one.
    Fahrenheit {
        /// What was given.
        given: Temperature,
        /// The same in degrees Celsius.
        meant: Temperature,
    },
    /// As kelvin it would be a usual one.
    Kelvin {
        /// What was given.
        given: Temperature,
        /// The same in degrees Celsius.
        meant: Temperature,
    },
    /// Far from where anything is measured.
    Far {
        /// What was given.
        given: Temperature,
        /// The lowest that is not doubted.
        least: Temperature,
        /// The highest.
        most: Temperature,
    },
    /// Beyond where the coefficient of expansion holds.
    Beyond {
        /// What was given.
        given: Temperature,
        /// The coefficient.
        expansion: Expansion,
        /// The lowest temperature at which it holds.
        least: Temperature,
        /// The highest.
        most: Temperature,
    },
}

impl ThermalDoubt {
    /// The temperature that was probably meant.
    pub const fn meant(self) -> Option<Temperature> {
        match self {
            Self::Fahrenheit { meant, .. } | Self::Kelvin { meant, .. } => Some(meant),
            Self::Far { .. } | Self::Beyond { .. } => None,
        }
    }

    /// What is doubtful about the temperature of a part, or of scales, that is measured.
    ///
    /// ```
    /// use fitcheck_core::tolerance::fit::thermal::ThermalDoubt;
    ///
    /// let meant = |given: &str| Some(ThermalDoubt::of_measured(given.parse().ok()?)?.meant()?.to_string());
    /// assert_eq!([meant("68"), meant("293.15"), meant("23.7")], [Some("20".into()), Some("20".into()), None]);
    /// ```
    pub fn of_measured(given: Temperature) -> Option<Self> {
        let Range { least, most } = Range::MEASURED;
        if Range::MEASURED.contains(given) {
            return None;
        }
        Some(other_scale(given).unwrap_or(Self::Far { given, least, most }))
    }

    /// What is doubtful about a temperature at which a coefficient is to hold. It holds at 20 °C, wherever else.
    pub fn of_expansion(given: Temperature, expansion: Expansion, range: Range) -> Option<Self> {
        let Range { least, most } = range;
        let holds = range.contains(given) || given == Temperature::REFERENCE;
        (!holds).then_some(Self::Beyond { given, expansion, least, most })
    }
}

/// Where a workshop is, in Celsius.
const WORKSHOP: Range = Range::celsius(10, 40);

/// A temperature of a workshop on another scale.
fn other_scale(given: Temperature) -> Option<ThermalDoubt> {
    let thousandths = given.thousandths();
    let fahrenheit = Temperature((thousandths - 32_000) * 5 / 9);
    let kelvin = Temperature(thousandths - 273_150);
    if WORKSHOP.contains(fahrenheit) {
        return Some(ThermalDoubt::Fahrenheit { given, meant: fahrenheit });
    }
    WORKSHOP.contains(kelvin).then_some(ThermalDoubt::Kelvin { given, meant: kelvin })
}
