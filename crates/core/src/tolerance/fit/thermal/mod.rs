//! The clearance at a temperature other than the reference temperature of 20 °C (ISO 1).
//!
//! First order in the temperature, which is enough: a coefficient is seldom known to better than a tenth. Coefficients
//! and temperatures are exact decimals; the result is rounded once, at the end, to the nanometre.

mod doubt;

use std::fmt;
use std::str::FromStr;

pub use doubt::{Range, ThermalDoubt};

use crate::length::{Length, decimal_parts, without_zeros};
use crate::message::{Arg, IntoArg, Say, printed};

/// The reference temperature of ISO 1.
const REFERENCE: i32 = 20_000;
/// A thousandth of 10⁻⁶/K times a thousandth of a kelvin.
const SCALE: i128 = 1_000_000_000_000;

/// A coefficient of linear expansion in thousandths of 10⁻⁶/K, from −20 to 500 · 10⁻⁶/K.
///
/// The bounds include every engineering metal and plastic; a value beyond them is probably in another unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Expansion(i32);

/// A temperature in thousandths of a degree Celsius, from −273.15 to 1000 °C.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Temperature(i32);

/// Why a text is not a temperature or a coefficient of expansion.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "fit-thermal", error)]
pub enum ThermalError {
    /// The text is not a decimal number.
    #[say(id = "length-not-a-number")]
    NotANumber {
        /// What was given.
        text: String,
    },
    /// More than three decimals.
    TooFine {
        /// What was given.
        text: String,
    },
    /// A temperature out of range.
    Temperature {
        /// What was given.
        text: String,
    },
    /// A coefficient out of range.
    Expansion {
        /// What was given.
        text: String,
    },
    /// A coefficient that is in another unit: per kelvin, or millimetres per metre and kelvin.
    ExpansionUnit {
        /// What was given.
        text: String,
        /// The same in millionths per kelvin.
        meant: Expansion,
    },
}

impl Expansion {
    /// The smallest, −20 · 10⁻⁶/K.
    pub const MIN: Self = Self(-20_000);
    /// The largest, 500 · 10⁻⁶/K.
    pub const MAX: Self = Self(500_000);

    /// A coefficient of so many thousandths of 10⁻⁶/K; `None` out of range.
    pub fn from_thousandths(thousandths: i32) -> Option<Self> {
        Some(Self(thousandths)).filter(|found| (Self::MIN..=Self::MAX).contains(found))
    }

    /// The coefficient in thousandths of 10⁻⁶/K.
    pub const fn thousandths(self) -> i32 {
        self.0
    }
}

impl Temperature {
    /// The reference temperature, 20 °C.
    pub const REFERENCE: Self = Self(REFERENCE);
    /// The lowest, −273.15 °C.
    pub const MIN: Self = Self(-273_150);
    /// The highest, 1000 °C.
    pub const MAX: Self = Self(1_000_000);

    /// A temperature of so many thousandths of a degree Celsius; `None` out of range.
    pub fn from_thousandths(thousandths: i32) -> Option<Self> {
        Some(Self(thousandths)).filter(|found| (Self::MIN..=Self::MAX).contains(found))
    }

    /// The temperature in thousandths of a degree Celsius.
    pub const fn thousandths(self) -> i32 {
        self.0
    }
}

impl FromStr for Expansion {
    type Err = ThermalError;

    /// Reads millionths per kelvin, `11.5`: point or comma, at most three decimals. Less than a tenth of one, other than zero, is what
    /// `11.5e-6` and `0.0115` are, and is refused with what they mean.
    fn from_str(text: &str) -> Result<Self, ThermalError> {
        let text = text.trim();
        if let Some(meant) = in_other_unit(text) {
            return Err(ThermalError::ExpansionUnit { text: text.to_owned(), meant });
        }
        let found = i32::try_from(thousandths(text)?).ok().map(Self);
        let in_range = found.filter(|found| Self::MIN <= *found && *found <= Self::MAX);
        in_range.ok_or_else(|| ThermalError::Expansion { text: text.to_owned() })
    }
}

impl FromStr for Temperature {
    type Err = ThermalError;

    /// Reads degrees Celsius, `80`, `20,5 °C`, `-40C`: point or comma, at most three decimals.
    fn from_str(text: &str) -> Result<Self, ThermalError> {
        let text = text.trim();
        let number = text.strip_suffix('C').unwrap_or(text);
        let number = number.strip_suffix('°').unwrap_or(number).trim_end();
        let found = i32::try_from(thousandths(number)?).ok().map(Self);
        let in_range = found.filter(|found| Self::MIN <= *found && *found <= Self::MAX);
        in_range.ok_or_else(|| ThermalError::Temperature { text: number.to_owned() })
    }
}

/// A coefficient per kelvin, or in millimetres per metre and kelvin; `None` where the text is something else, or may be millionths.
fn in_other_unit(text: &str) -> Option<Expansion> {
    let given: f64 = text.replace(',', ".").parse().ok()?;
    let factor = match given.abs() {
        0.000_000_1..0.000_5 => 1e6,
        0.001..0.1 => 1e3,
        _ => return None,
    };
    // Three decimals, as they can be given.
    let thousandths = format!("{:.0}", given * factor * 1e3).parse().ok()?;
    Expansion::from_thousandths(thousandths)
}

/// Millionths per kelvin with a point and only the decimals it has.
impl fmt::Display for Expansion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&decimal(self.0))
    }
}

/// Degrees Celsius with a point and only the decimals it has, without the unit.
impl fmt::Display for Temperature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&decimal(self.0))
    }
}

/// With the decimal sign and the minus of the language.
impl IntoArg for Expansion {
    fn arg(&self) -> Arg {
        printed(self)
    }
}

/// With the decimal sign and the minus of the language.
impl IntoArg for Temperature {
    fn arg(&self) -> Arg {
        printed(self)
    }
}

/// The material and the temperature of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Warm {
    /// How much the material expands.
    pub expansion: Expansion,
    /// How warm it is.
    pub temperature: Temperature,
}

impl Warm {
    /// The growth of a length of 1, in billionths of a thousandth (10⁻¹²).
    fn growth(self) -> i128 {
        i128::from(self.expansion.0) * i128::from(self.temperature.0 - REFERENCE)
    }
}

/// How much larger the clearance is with both parts at a temperature than at 20 °C: ΔC = (α hole − α shaft)(T − 20) D.
///
/// ```
/// use fitcheck_core::tolerance::fit::thermal::clearance_change;
///
/// // 50 mm of aluminium around steel at 80 °C: (23.1 − 11.5) · 60 · 50 mm = 34.8 µm.
/// let change = clearance_change("50".parse()?, "23.1".parse()?, "11.5".parse()?, "80".parse()?);
/// assert_eq!(change.nanometres(), 34_800);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn clearance_change(nominal: Length, hole: Expansion, shaft: Expansion, temperature: Temperature) -> Length {
    clearance_change_apart(nominal, Warm { expansion: hole, temperature }, Warm { expansion: shaft, temperature })
}

/// The same where each part has its own temperature, such as a hole that is heated for assembly.
pub fn clearance_change_apart(nominal: Length, hole: Warm, shaft: Warm) -> Length {
    // Below 10^15 nm times 10^12: far inside an i128.
    nanometres(i128::from(nominal.nanometres()) * (hole.growth() - shaft.growth()))
}

/// A measured length brought to the reference temperature.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Correction {
    /// As it was measured.
    pub measured: Length,
    /// At 20 °C, rounded to the nearest nanometre.
    pub at_reference: Length,
    /// The part.
    pub part: Warm,
    /// The scales that it was measured with, where the machine does not compensate them.
    pub scale: Option<Warm>,
}

impl Correction {
    /// Brings a length to 20 °C: `L₂₀ = L [1 − α (T − 20) + α_s (T_s − 20)]` (metrology.md, section 8).
    ///
    /// ```
    /// use fitcheck_core::tolerance::fit::thermal::{Correction, Warm};
    ///
    /// // 80 mm of aluminium at 28 °C, read from scales at 24 °C.
    /// let part = Warm { expansion: "23.1".parse()?, temperature: "28".parse()? };
    /// let scale = Warm { expansion: "10".parse()?, temperature: "24".parse()? };
    /// let found = Correction::new("80".parse()?, part, Some(scale));
    /// assert_eq!(found.at_reference.to_string(), "79.988416");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(measured: Length, part: Warm, scale: Option<Warm>) -> Self {
        let growth = scale.map_or(0, Warm::growth) - part.growth();
        let change = nanometres(i128::from(measured.nanometres()) * growth);
        let at_reference = measured.checked_add(change).unwrap_or(measured);
        Self { measured, at_reference, part, scale }
    }

    /// What was added to the measured length.
    pub fn change(&self) -> Length {
        self.at_reference.saturating_sub(self.measured)
    }

    /// How far the linear correction is from the exact one, `L (1 + α_s ΔT_s) / (1 + α ΔT)`, to the nearest nanometre.
    pub fn against_exact(&self) -> Length {
        let growth = |warm: Warm| f64::from(warm.expansion.0) * 1e-9 * f64::from(warm.temperature.0 - REFERENCE) * 1e-3;
        let part = growth(self.part);
        let scale = self.scale.map_or(0.0, growth);
        // The difference alone, so that no digits of the length cancel.
        let exact = (1.0 + scale) / (1.0 + part) - (1.0 - part + scale);
        // Within the bounds of coefficients and temperatures it is a fraction of the length, so it is one.
        Length::from_mm_f64(self.measured.to_mm_f64() * -exact).unwrap_or(Length::MAX)
    }
}

/// How much longer a length is at a temperature than at 20 °C.
pub fn growth(nominal: Length, part: Warm) -> Length {
    nanometres(i128::from(nominal.nanometres()) * part.growth())
}

/// The nearest whole nanometre, halves away from zero.
fn nanometres(scaled: i128) -> Length {
    let half = SCALE / 2 * scaled.signum();
    let nm = i64::try_from((scaled + half) / SCALE).ok();
    // Within the bounds of coefficients and temperatures a part grows by a fraction of its length, so this holds.
    nm.and_then(|nm| Length::from_nanometres(nm).ok()).unwrap_or(Length::MAX)
}

/// The thousandths of a decimal number; with more than nine figures before the point, a value outside every range.
fn thousandths(text: &str) -> Result<i64, ThermalError> {
    let not_a_number = || ThermalError::NotANumber { text: text.to_owned() };
    let unsigned = text.strip_prefix(['+', '-', '\u{2212}']).unwrap_or(text);
    let (whole, decimals) = decimal_parts(unsigned).ok_or_else(not_a_number)?;
    let decimals = decimals.trim_end_matches('0');
    if 3 < decimals.len() {
        return Err(ThermalError::TooFine { text: text.to_owned() });
    }
    let whole = whole.trim_start_matches('0');
    let number = if 9 < whole.len() { Ok(i64::MAX) } else { format!("{whole}{decimals:0<3}").parse() };
    let number = number.map_err(|_figures| not_a_number())?;
    Ok(if text.starts_with(['-', '\u{2212}']) { -number } else { number })
}

fn decimal(thousandths: i32) -> String {
    let sign = if thousandths < 0 { "-" } else { "" };
    let size = thousandths.unsigned_abs();
    without_zeros(&format!("{sign}{}.{:03}", size / 1000, size % 1000)).to_owned()
}
