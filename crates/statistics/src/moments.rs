//! Count, mean and standard deviation of values; estimates with their intervals.

use crate::reason::Reason;
use fitcheck_core::law::{chi_square_quantile, student_factor};

/// A count as a number to compute with.
pub fn count(number: usize) -> f64 {
    f64::from(u32::try_from(number).unwrap_or(u32::MAX))
}

/// An estimate with the interval that holds the true value at the level that was asked for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Estimate {
    /// The estimate itself.
    pub value: f64,
    /// The lower end of its interval.
    pub lower: f64,
    /// The upper end of its interval; it may be infinite.
    pub upper: f64,
}

impl Estimate {
    /// An estimate with as much to either side.
    pub const fn about(value: f64, half: f64) -> Self {
        Self { value, lower: value - half, upper: value + half }
    }

    /// The same estimate on another scale. Where the scale falls, the ends change places.
    #[must_use]
    pub fn map(self, scale: impl Fn(f64) -> f64) -> Self {
        let (one, other) = (scale(self.lower), scale(self.upper));
        Self { value: scale(self.value), lower: one.min(other), upper: one.max(other) }
    }

    /// A standard deviation with its interval by the chi-square law (ISO 2602; NIST/SEMATECH e-Handbook 7.2.3.1).
    pub fn of_deviation(deviation: f64, degrees: f64, level: f64) -> Self {
        let rest = (1.0 - level) / 2.0;
        let end = |share: f64| deviation * (degrees / chi_square_quantile(degrees, share)).sqrt();
        Self { value: deviation, lower: end(1.0 - rest), upper: end(rest) }
    }
}

/// Refuses an empty series and values that are no finite numbers.
pub(crate) fn checked(values: &[f64]) -> Result<(), Reason> {
    if values.is_empty() {
        return Err(Reason::Empty);
    }
    match values.iter().position(|value| !value.is_finite()) {
        Some(at) => Err(Reason::NotANumber { place: at + 1 }),
        None => Ok(()),
    }
}

/// A confidence level: above 0 and below 1.
pub(crate) fn checked_level(level: f64) -> Result<(), Reason> {
    if 0.0 < level && level < 1.0 { Ok(()) } else { Err(parameter("level", level)) }
}

/// That a parameter is beyond its range.
pub(crate) fn parameter(name: &'static str, given: f64) -> Reason {
    Reason::Parameter { given: given.to_string(), name }
}

/// Count, mean, sum of squares and ends of values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    /// How many values there are: at least one.
    pub count: usize,
    /// Their mean.
    pub mean: f64,
    /// The sum of the squares of their distances from the mean.
    pub squares: f64,
    /// The least value.
    pub least: f64,
    /// The greatest value.
    pub greatest: f64,
}

impl Moments {
    /// Those of a series, in two passes with what rounding left over: values of nine equal leading digits keep their spread
    /// (Chan, Golub and `LeVeque` 1983).
    ///
    /// # Errors
    /// No value, or one that is not a finite number.
    pub fn of(values: &[f64]) -> Result<Self, Reason> {
        checked(values)?;
        let number = count(values.len());
        let first = values.iter().copied().sum::<f64>() / number;
        let mean = first + values.iter().map(|value| value - first).sum::<f64>() / number;
        let left: f64 = values.iter().map(|value| value - mean).sum();
        let squares = values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() - left * left / number;
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let greatest = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let squares = if least < greatest { squares.max(0.0) } else { 0.0 };
        Ok(Self { count: values.len(), mean, squares, least, greatest })
    }

    /// The difference of the greatest and the least value.
    pub fn range(&self) -> f64 {
        self.greatest - self.least
    }

    /// The degrees of freedom of the standard deviation, n − 1.
    pub fn degrees(&self) -> f64 {
        count(self.count) - 1.0
    }

    /// The standard deviation with n − 1.
    ///
    /// # Errors
    /// One value alone, or equal values.
    pub fn deviation(&self) -> Result<f64, Reason> {
        if self.count < 2 {
            return Err(Reason::TooFew { found: self.count, needed: 2 });
        }
        if self.least < self.greatest { Ok((self.squares / self.degrees()).sqrt()) } else { Err(Reason::AllEqual) }
    }

    /// The mean with its interval by Student's law (ISO 2602).
    ///
    /// # Errors
    /// Fewer than two values, or equal ones.
    pub fn mean_estimate(&self, level: f64) -> Result<Estimate, Reason> {
        checked_level(level)?;
        let error = self.deviation()? / count(self.count).sqrt();
        Ok(Estimate::about(self.mean, student_factor(self.degrees(), level) * error))
    }

    /// The standard deviation with its interval.
    ///
    /// # Errors
    /// Fewer than two values, or equal ones.
    pub fn deviation_estimate(&self, level: f64) -> Result<Estimate, Reason> {
        checked_level(level)?;
        Ok(Estimate::of_deviation(self.deviation()?, self.degrees(), level))
    }
}

/// The middle value, or the mean of the two in the middle: the centre line of a run chart.
///
/// # Errors
/// No value, or one that is not a finite number.
pub fn median(values: &[f64]) -> Result<f64, Reason> {
    checked(values)?;
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let upper = sorted.get(sorted.len() / 2).copied().ok_or(Reason::Empty)?;
    let lower = sorted.get((sorted.len() - 1) / 2).copied().ok_or(Reason::Empty)?;
    Ok(f64::midpoint(lower, upper))
}
