//! The standard deviation within subgroups, by one of several methods, with the degrees of freedom that it is worth.

use crate::constants::{c4, d2, d3};
use crate::moments::{Moments, count};
use crate::reason::Reason;

/// How a standard deviation was estimated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// The mean moving range of neighbours over d2(2).
    MovingRange,
    /// The ranges of subgroups over d2.
    Ranges,
    /// The standard deviations of subgroups over c4.
    Deviations,
    /// The root of the pooled variances of subgroups.
    Pooled,
    /// The standard deviation of all values.
    Overall,
    /// Given with a baseline.
    Known,
}

impl Method {
    /// Its name in files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::MovingRange => "mean moving range / d2",
            Self::Ranges => "mean range / d2",
            Self::Deviations => "mean standard deviation / c4",
            Self::Pooled => "pooled standard deviation",
            Self::Overall => "standard deviation",
            Self::Known => "given",
        }
    }
}

/// An estimated standard deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sigma {
    /// The standard deviation; above 0.
    pub value: f64,
    /// A standard deviation of one sample with so many degrees of freedom scatters as much as this estimate.
    pub degrees: f64,
    /// How it was estimated.
    pub method: Method,
}

impl Sigma {
    /// The standard deviation within subgroups. [`Method::MovingRange`] takes all values as one series in their order.
    ///
    /// Subgroups of unequal size are weighted by what they are worth: n − 1, or the inverse variance of R/d2 and s/c4 (Burr
    /// 1969), which is the plain mean where all are equal. Subgroups of one value say nothing and are passed over.
    ///
    /// # Errors
    /// No spread, no subgroup of two values, ranges of more than 25 values, values that are not finite numbers.
    pub fn within<'a>(groups: impl IntoIterator<Item = &'a [f64]>, method: Method) -> Result<Self, Reason> {
        match method {
            Method::MovingRange => Self::of_moving_ranges(groups),
            Method::Ranges => {
                Self::weighted(groups, method, |group| Ok((group.range(), d2(group.count)?, d3(group.count)?)))
            }
            Method::Deviations => Self::weighted(groups, method, |group| {
                let c4 = c4(group.count)?;
                let deviation = (group.squares / group.degrees()).sqrt();
                Ok((deviation, c4, (1.0 - c4 * c4).sqrt()))
            }),
            Method::Pooled => Self::pooled(groups),
            Method::Overall | Method::Known => {
                let values: Vec<f64> = groups.into_iter().flatten().copied().collect();
                Self::overall(&Moments::of(&values)?)
            }
        }
    }

    /// The standard deviation of all values, with n − 1.
    ///
    /// # Errors
    /// One value alone, or equal values.
    pub fn overall(of: &Moments) -> Result<Self, Reason> {
        Ok(Self { value: of.deviation()?, degrees: of.degrees(), method: Method::Overall })
    }

    /// Of neighbours in a series. Its degrees of freedom are 0.62 (n − 1), as overlapping ranges are worth less.
    fn of_moving_ranges<'a>(groups: impl IntoIterator<Item = &'a [f64]>) -> Result<Self, Reason> {
        let (mut sum, mut number, mut before) = (0.0, 0, None);
        for value in groups.into_iter().flatten().copied() {
            if !value.is_finite() {
                return Err(Reason::NotANumber { place: number + 1 });
            }
            sum += before.map_or(0.0, |before: f64| (value - before).abs());
            number += 1;
            before = Some(value);
        }
        if number < 2 {
            return Err(if number == 0 { Reason::Empty } else { Reason::TooFew { found: number, needed: 2 } });
        }
        let steps = count(number) - 1.0;
        Self::checked(sum / steps / d2(2)?, 0.62 * steps, Method::MovingRange)
    }

    /// Of subgroups, each with its figure, and with the mean and the standard deviation of that figure for σ = 1.
    fn weighted<'a>(
        groups: impl IntoIterator<Item = &'a [f64]>,
        method: Method,
        figure: impl Fn(&Moments) -> Result<(f64, f64, f64), Reason>,
    ) -> Result<Self, Reason> {
        let (mut sum, mut weights) = (0.0, 0.0);
        for group in groups.into_iter().filter(|group| 1 < group.len()) {
            let (figure, mean, deviation) = figure(&Moments::of(group)?)?;
            let weight = (mean / deviation).powi(2);
            sum += weight * figure / mean;
            weights += weight;
        }
        if weights <= 0.0 {
            return Err(Reason::NoSubgroups);
        }
        // Patnaik 1950: the degrees of freedom of the chi law with this coefficient of variation.
        let degrees = 1.0 / (2.0 * (1.0 + 2.0 / weights).sqrt() - 2.0);
        Self::checked(sum / weights, degrees, method)
    }

    /// Of the squares within all subgroups.
    fn pooled<'a>(groups: impl IntoIterator<Item = &'a [f64]>) -> Result<Self, Reason> {
        let (mut squares, mut degrees) = (0.0, 0.0);
        for group in groups.into_iter().filter(|group| 1 < group.len()) {
            let group = Moments::of(group)?;
            squares += group.squares;
            degrees += group.degrees();
        }
        if degrees <= 0.0 {
            return Err(Reason::NoSubgroups);
        }
        Self::checked((squares / degrees).sqrt(), degrees, Method::Pooled)
    }

    fn checked(value: f64, degrees: f64, method: Method) -> Result<Self, Reason> {
        if 0.0 < value { Ok(Self { value, degrees, method }) } else { Err(Reason::AllEqual) }
    }
}
