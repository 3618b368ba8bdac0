//! The uncertainty of a measured value.

use super::{Bands, RuleInputs, thousandths};
use crate::length::{Length, LengthError, Unit, without_zeros};
use crate::message::{Message, Say, message};
use crate::tolerance::Bounds;

/// The largest coverage factor.
const MOST_K: u32 = 10_000;

/// A standard uncertainty above 0, and the coverage factor that makes it an expanded one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Uncertainty {
    /// Picometres: budgets have decimals of nanometres.
    pm: i64,
    /// The coverage factor, thousandths.
    k: u32,
}

/// Why there is no such uncertainty.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "uncertainty", error)]
pub enum UncertaintyError {
    /// Not a number of micrometres.
    #[say(transparent)]
    Length(LengthError),
    /// Zero or less.
    NotPositive,
    /// A coverage factor that is not from 1 to 10, with at most three decimals.
    Factor {
        /// What was given.
        given: String,
    },
}

impl Uncertainty {
    /// A standard uncertainty in micrometres as text, to the picometre, with the coverage factor 2.
    ///
    /// # Errors
    /// [`UncertaintyError`] unless it is a number above zero.
    pub fn standard(text: &str) -> Result<Self, UncertaintyError> {
        // A length has six decimals: those of a number of micrometres are picometres.
        let length = Length::parse_in(text, Unit::Millimetre).map_err(UncertaintyError::Length)?;
        if length <= Length::ZERO {
            return Err(UncertaintyError::NotPositive);
        }
        Ok(Self { pm: length.nanometres(), k: 2_000 })
    }

    /// An expanded uncertainty in micrometres as text, divided by its coverage factor.
    ///
    /// # Errors
    /// As for [`Self::standard`].
    pub fn expanded(text: &str, k: u32) -> Result<Self, UncertaintyError> {
        let Self { pm, .. } = Self::standard(text)?;
        let exact = i128::from(pm) * 1_000;
        let divided = (exact + i128::from(k) - 1) / i128::from(k.max(1));
        Ok(Self { pm: i64::try_from(divided).unwrap_or(i64::MAX), k })
    }

    /// The same with another coverage factor, in thousandths.
    #[must_use]
    pub const fn covered(self, k: u32) -> Self {
        Self { k, ..self }
    }

    /// A standard uncertainty in picometres with its coverage factor in thousandths, as records keep it; `None` where it is not
    /// above zero or beyond what a length can hold, or the factor is not from 1 to 10.
    pub fn of_picometres(pm: i64, k: u32) -> Option<Self> {
        let is_one = (1..=Length::MAX.nanometres()).contains(&pm) && (1_000..=MOST_K).contains(&k);
        is_one.then_some(Self { pm, k })
    }

    /// The standard uncertainty in picometres and the coverage factor in thousandths: both exactly.
    pub const fn picometres(self) -> (i64, u32) {
        (self.pm, self.k)
    }

    /// A coverage factor as text, in thousandths.
    ///
    /// # Errors
    /// [`UncertaintyError::Factor`] unless it is from 1 to 10 with at most three decimals.
    pub fn factor(text: &str) -> Result<u32, UncertaintyError> {
        let factor = multiple(text).filter(|factor| (1_000..=MOST_K).contains(factor));
        factor.ok_or_else(|| UncertaintyError::Factor { given: text.to_owned() })
    }

    /// The standard uncertainty, nanometres.
    #[expect(clippy::as_conversions, clippy::cast_precision_loss, reason = "an uncertainty has few digits")]
    pub(super) const fn nm(self) -> f64 {
        self.pm as f64 / 1_000.0
    }

    /// The standard uncertainty times a number of thousandths, nanometres, rounded up.
    pub(super) fn times(self, factor: i64) -> i64 {
        rounded_up(i128::from(self.pm) * i128::from(factor), 1_000_000)
    }

    /// The expanded uncertainty in picometres times a thousand, exactly.
    pub(super) fn expanded_exactly(self) -> i128 {
        i128::from(self.pm) * i128::from(self.k)
    }

    /// The standard uncertainty in micrometres, with the decimals it has.
    pub fn um(self) -> String {
        exact(i128::from(self.pm) * 1_000)
    }

    /// The expanded uncertainty in micrometres, with the decimals it has.
    pub fn expanded_um(self) -> String {
        exact(self.expanded_exactly())
    }

    /// The coverage factor.
    pub fn k(self) -> String {
        thousandths(self.k)
    }
}

impl Uncertainty {
    /// As a person reads it, with at most three decimals of a micrometre; what is computed with stays exact.
    pub fn rounded_message(self) -> Message {
        let [u, expanded] = [i128::from(self.pm) * 1_000, self.expanded_exactly()].map(rounded);
        message!("uncertainty").number("u", u).number("expanded", expanded).number("k", self.k())
    }
}

impl Say for Uncertainty {
    fn message(&self) -> Message {
        message!("uncertainty").number("u", self.um()).number("expanded", self.expanded_um()).number("k", self.k())
    }
}

impl Bands {
    /// A multiple of the expanded uncertainty, for conformity and nonconformity.
    pub(super) fn expanded(given: &RuleInputs, _bounds: &Bounds) -> Self {
        let factor = i128::from(given.factor.unwrap_or(1_000));
        let expanded = given.uncertainty.map_or(0, Uncertainty::expanded_exactly);
        let width = Length::from_nanometres(rounded_up(expanded * factor, 1_000_000_000)).unwrap_or(Length::MAX);
        Self { conforming: Some(width), nonconforming: width }
    }
}

/// A number from 0 with at most three decimals, in thousandths.
pub fn multiple(text: &str) -> Option<u32> {
    let nm = Length::parse_in(text, Unit::Micrometre).ok()?.nanometres();
    u32::try_from(nm).ok()
}

fn rounded_up(number: i128, divisor: i128) -> i64 {
    i64::try_from((number + divisor - 1) / divisor).unwrap_or(i64::MAX)
}

/// Picometres times a thousand as micrometres with at most three decimals. One that would be nothing stays as it is: it is above 0.
fn rounded(number: i128) -> String {
    let nanometres = (number + 500_000) / 1_000_000;
    exact(if nanometres == 0 { number } else { nanometres * 1_000_000 })
}

/// Picometres times a thousand as micrometres.
fn exact(number: i128) -> String {
    without_zeros(&format!("{}.{:09}", number / 1_000_000_000, number % 1_000_000_000)).to_owned()
}
