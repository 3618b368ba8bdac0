//! A straight line through points, by least squares.

use crate::moments::{Estimate, Moments, count};
use crate::reason::Reason;
use fitcheck_core::law::{student_both, student_factor};

/// A straight line y = intercept + slope x with what its coefficients are worth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// How many points there are.
    pub count: usize,
    /// Where it crosses x = 0.
    pub intercept: Coefficient,
    /// How it rises.
    pub slope: Coefficient,
    /// The standard deviation of the points about it, with n − 2; above 0.
    pub deviation: f64,
    /// The share of the squares that it explains.
    pub explained: f64,
    /// The mean of x.
    pub middle: f64,
    /// The mean of y.
    pub level: f64,
    /// The sum of the squares of x about its mean.
    pub squares: f64,
}

/// A coefficient of a line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficient {
    /// Its value.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
    /// Its value in standard errors.
    pub t: f64,
    /// How probable that is, to either side, where it is truly 0.
    pub p: f64,
}

impl Line {
    /// The line of points (NIST/SEMATECH e-Handbook 4.1.4.1).
    ///
    /// # Errors
    /// Fewer than three points, coordinates that are no finite numbers, points above each other, points that lie on a line.
    pub fn of(points: &[[f64; 2]]) -> Result<Self, Reason> {
        if points.len() < 3 {
            return Err(Reason::TooFew { found: points.len(), needed: 3 });
        }
        let x = Moments::of(&points.iter().map(|[x, _]| *x).collect::<Vec<_>>())?;
        let y = Moments::of(&points.iter().map(|[_, y]| *y).collect::<Vec<_>>())?;
        if x.squares <= 0.0 {
            return Err(Reason::AllEqual);
        }
        let products: f64 = points.iter().map(|[at, value]| (at - x.mean) * (value - y.mean)).sum();
        let slope = products / x.squares;
        let rest: f64 = points.iter().map(|[at, value]| (value - y.mean - slope * (at - x.mean)).powi(2)).sum();
        // What rounding leaves of points on a line is no scatter.
        if rest <= y.squares * 1e-24 {
            return Err(Reason::AllEqual);
        }
        let number = count(points.len());
        let degrees = number - 2.0;
        let deviation = (rest / degrees).sqrt();
        let coefficient = |value: f64, error: f64| {
            let t = value / error;
            Coefficient { value, error, t, p: student_both(degrees, t) }
        };
        let intercept_error = deviation * (1.0 / number + x.mean * x.mean / x.squares).sqrt();
        Ok(Self {
            count: points.len(),
            intercept: coefficient(y.mean - slope * x.mean, intercept_error),
            slope: coefficient(slope, deviation / x.squares.sqrt()),
            deviation,
            explained: 1.0 - rest / y.squares,
            middle: x.mean,
            level: y.mean,
            squares: x.squares,
        })
    }

    /// How many standard errors to either side cover a coefficient.
    pub(crate) fn factor(&self, level: f64) -> f64 {
        student_factor(count(self.count) - 2.0, level)
    }

    /// Where the line is at x, with the interval of its mean there (NIST/SEMATECH e-Handbook 4.5.1.2).
    pub fn at(&self, x: f64, level: f64) -> Estimate {
        let away = x - self.middle;
        let error = self.deviation * (1.0 / count(self.count) + away * away / self.squares).sqrt();
        Estimate::about(self.level + self.slope.value * away, self.factor(level) * error)
    }

    /// The slope with its interval.
    pub fn slope_estimate(&self, level: f64) -> Estimate {
        Estimate::about(self.slope.value, self.factor(level) * self.slope.error)
    }
}
