//! Charts that remember: EWMA and CUSUM. They find small shifts sooner than the limits of single points do.

use crate::moments::{checked, parameter};
use crate::reason::Reason;

/// An exponentially weighted moving average: z = λ x + (1 − λ) z before it (Roberts 1959; ISO 7870-6).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ewma {
    /// The weight λ of the newest value, above 0 and at most 1; 0.2 is usual.
    pub weight: f64,
    /// How many standard deviations of the average the limits are away; above 0.
    pub width: f64,
}

/// A point of an EWMA chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EwmaPoint {
    /// The average.
    pub value: f64,
    /// The lower limit.
    pub lower: f64,
    /// The upper limit.
    pub upper: f64,
}

impl EwmaPoint {
    /// Whether the average is beyond a limit.
    pub fn is_out(&self) -> bool {
        self.value < self.lower || self.upper < self.value
    }
}

/// A point of a chart that remembers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MemoryPoint {
    /// A weighted average.
    Average(EwmaPoint),
    /// The sums of what is above and below the mean.
    Sums(CusumPoint),
}

impl MemoryPoint {
    /// Whether it is beyond its limits.
    pub fn is_out(&self) -> bool {
        match self {
            Self::Average(point) => point.is_out(),
            Self::Sums(point) => point.is_out(),
        }
    }
}

impl Default for Ewma {
    /// λ = 0.2 and 2.962 s: a stable process is 500 values away from a false alarm (Lucas and Saccucci 1990).
    fn default() -> Self {
        Self { weight: 0.2, width: 2.962 }
    }
}

impl Ewma {
    /// The averages of values about a mean with a standard deviation, with limits that are exact from the first point on:
    /// w s √(λ/(2 − λ) (1 − (1 − λ)^2i)).
    ///
    /// # Errors
    /// No values, values that are no finite numbers, parameters beyond their range.
    pub fn points(&self, values: &[f64], mean: f64, sigma: f64) -> Result<Vec<EwmaPoint>, Reason> {
        checked(values)?;
        let Self { weight, width } = *self;
        if !(0.0 < weight && weight <= 1.0) {
            return Err(parameter("lambda", weight));
        }
        checked_above_zero("width", width)?;
        checked_above_zero("sigma", sigma)?;
        let mut average = mean;
        let mut left = 1.0;
        let points = values.iter().map(|value| {
            average += weight * (value - average);
            left *= (1.0 - weight).powi(2);
            let half = width * sigma * (weight / (2.0 - weight) * (1.0 - left)).sqrt();
            EwmaPoint { value: average, lower: mean - half, upper: mean + half }
        });
        Ok(points.collect())
    }
}

/// A tabular CUSUM: what values are above and below their mean by more than an allowance, added up (Page 1954; ISO 7870-4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cusum {
    /// The allowance k in standard deviations: half the shift that is to be found; at least 0.
    pub allowance: f64,
    /// The decision interval h in standard deviations; above 0.
    pub interval: f64,
}

/// A point of a CUSUM chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CusumPoint {
    /// The sum of what is above the mean, at least 0.
    pub above: f64,
    /// The sum of what is below it, at least 0.
    pub below: f64,
    /// The decision interval: a sum beyond it says that the mean has moved.
    pub interval: f64,
    /// Since how many points the larger sum has been above 0: the shift began there.
    pub since: usize,
}

impl CusumPoint {
    /// Whether a sum is beyond the decision interval.
    pub fn is_out(&self) -> bool {
        self.interval < self.above || self.interval < self.below
    }
}

impl Default for Cusum {
    /// k = 0.5 and h = 5: a stable process is 465 values away from a false alarm, one that moved by 1 s is found after 10.
    fn default() -> Self {
        Self { allowance: 0.5, interval: 5.0 }
    }
}

impl Cusum {
    /// The sums of values about a mean with a standard deviation. They are not set back after an alarm.
    ///
    /// # Errors
    /// No values, values that are no finite numbers, parameters beyond their range.
    pub fn points(&self, values: &[f64], mean: f64, sigma: f64) -> Result<Vec<CusumPoint>, Reason> {
        checked(values)?;
        if !(0.0 <= self.allowance && self.allowance.is_finite()) {
            return Err(parameter("allowance", self.allowance));
        }
        checked_above_zero("interval", self.interval)?;
        checked_above_zero("sigma", sigma)?;
        let slack = self.allowance * sigma;
        let [mut above, mut below] = [Sum::default(); 2];
        let points = values.iter().map(|value| {
            above.add(value - mean - slack);
            below.add(mean - value - slack);
            let larger = if below.sum < above.sum { above } else { below };
            let interval = self.interval * sigma;
            CusumPoint { above: above.sum, below: below.sum, interval, since: larger.since }
        });
        Ok(points.collect())
    }
}

/// A sum that never falls below 0, and since how many points it has been above.
#[derive(Debug, Clone, Copy, Default)]
struct Sum {
    sum: f64,
    since: usize,
}

impl Sum {
    fn add(&mut self, what: f64) {
        self.sum = (self.sum + what).max(0.0);
        self.since = if 0.0 < self.sum { self.since + 1 } else { 0 };
    }
}

fn checked_above_zero(name: &'static str, value: f64) -> Result<(), Reason> {
    if 0.0 < value && value.is_finite() { Ok(()) } else { Err(parameter(name, value)) }
}
