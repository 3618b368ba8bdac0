//! Laws that are fitted to values: normal, lognormal, Weibull and folded normal.
//!
//! The normal and the lognormal law have mean and standard deviation with n − 1, of the values or of their logarithms; the other
//! two are fitted by maximum likelihood. The folded normal law is that of form and position, which cannot fall below 0.

use crate::moments::{Estimate, Moments, checked_level, count};
use crate::reason::Reason;
use fitcheck_core::law::{Tails, normal, normal_quantile, root};

/// A family of laws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Family {
    /// The normal law.
    Normal,
    /// The law whose logarithm is normal.
    LogNormal,
    /// Weibull's law with scale and shape, from 0 up.
    Weibull,
    /// The law of the distance from 0 of a normal value.
    FoldedNormal,
}

impl Family {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Normal, Self::LogNormal, Self::Weibull, Self::FoldedNormal];

    /// Its name in files and options.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Normal => "normal",
            Self::LogNormal => "lognormal",
            Self::Weibull => "weibull",
            Self::FoldedNormal => "folded-normal",
        }
    }

    /// Its law with two parameters: location and scale, or the scale and the shape of Weibull's.
    const fn with(self, [first, second]: [f64; 2]) -> Law {
        Law { family: self, first, second }
    }
}

/// A law of a family.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Law {
    /// Its family.
    pub family: Family,
    /// The mean of the normal law, of the logarithms, or of the law before it is folded; the scale of Weibull's.
    pub first: f64,
    /// The standard deviation of the same; the shape of Weibull's.
    pub second: f64,
}

impl Law {
    /// The probabilities below and above a value.
    pub fn tails(&self, value: f64) -> Tails {
        let Self { first, second, .. } = *self;
        match self.family {
            Family::Normal => normal((value - first) / second),
            _ if value <= 0.0 => Tails { below: 0.0, above: 1.0 },
            Family::LogNormal => normal((libm::log(value) - first) / second),
            Family::Weibull => {
                let power = libm::pow(value / first, second);
                Tails { below: -libm::expm1(-power), above: libm::exp(-power) }
            }
            Family::FoldedNormal => {
                let above = normal((value - first) / second).above + normal((value + first) / second).above;
                let below = normal((value - first) / second).below - normal((value + first) / second).above;
                Tails { below: below.max(0.0), above: above.min(1.0) }
            }
        }
    }

    /// The value below which a share lies.
    pub fn quantile(&self, share: f64) -> f64 {
        let Self { first, second, .. } = *self;
        match self.family {
            Family::Normal => first + second * normal_quantile(share),
            Family::LogNormal => libm::exp(first + second * normal_quantile(share)),
            Family::Weibull => first * libm::pow(-libm::log1p(-share), 1.0 / second),
            Family::FoldedNormal => {
                let lacks = |value: f64| {
                    let tails = self.tails(value);
                    if share < 0.5 { tails.below - share } else { 1.0 - share - tails.above }
                };
                root([0.0, first + 40.0 * second], lacks).unwrap_or(f64::NAN)
            }
        }
    }

    /// The logarithm of the density.
    fn density(&self, value: f64) -> f64 {
        let Self { first, second, .. } = *self;
        let bell = |z: f64| -0.5 * z * z - libm::log(second * (2.0 * std::f64::consts::PI).sqrt());
        match self.family {
            Family::Normal => bell((value - first) / second),
            Family::LogNormal => bell((libm::log(value) - first) / second) - libm::log(value),
            Family::Weibull => {
                let ratio = value / first;
                libm::log(second / first) + (second - 1.0) * libm::log(ratio) - libm::pow(ratio, second)
            }
            Family::FoldedNormal => {
                bell((value - first) / second) + libm::log1p(libm::exp(-2.0 * value * first / (second * second)))
            }
        }
    }
}

/// A law fitted to values, with the covariance of its two parameters.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fitted {
    /// The law.
    pub law: Law,
    /// Variance of the first parameter, covariance, variance of the second.
    covariance: [f64; 3],
}

impl Fitted {
    /// The law of a family that fits values best.
    ///
    /// # Errors
    /// Fewer than three values, equal ones, values that the law cannot have, no fit.
    pub fn of(values: &[f64], family: Family) -> Result<Self, Reason> {
        let moments = Moments::of(values)?;
        if moments.count < 3 {
            return Err(Reason::TooFew { found: moments.count, needed: 3 });
        }
        moments.deviation()?;
        let law = match family {
            Family::Normal => family.with([moments.mean, moments.deviation()?]),
            Family::LogNormal => {
                let logarithms = Moments::of(&logarithms(values, &moments)?)?;
                family.with([logarithms.mean, logarithms.deviation()?])
            }
            Family::Weibull => family.with(weibull(values, &moments)?),
            Family::FoldedNormal => family.with(folded(values, &moments)?),
        };
        Ok(Self { law, covariance: covariance(&law, values).ok_or(Reason::NoFit)? })
    }

    /// A figure of the law with its interval for many values, by how it changes with the parameters (the delta method).
    ///
    /// # Errors
    /// A level beyond 0 to 1, or a figure that is no finite number.
    pub fn estimate(&self, level: f64, figure: impl Fn(&Law) -> f64) -> Result<Estimate, Reason> {
        checked_level(level)?;
        let Law { family, first, second } = self.law;
        let value = figure(&self.law);
        let slope = |steps: [f64; 2]| {
            let at = |sign: f64| figure(&family.with([first + sign * steps[0], second + sign * steps[1]]));
            (at(1.0) - at(-1.0)) / (2.0 * (steps[0] + steps[1]))
        };
        let [one, two] = steps(&self.law);
        let [variance, covariance, other] = self.covariance;
        let one = if 0.0 < variance { slope([one, 0.0]) } else { 0.0 };
        let two = slope([0.0, two]);
        let error = (one * one * variance + 2.0 * one * two * covariance + two * two * other).sqrt();
        let half = normal_quantile(f64::midpoint(1.0, level)) * error;
        if value.is_finite() && half.is_finite() { Ok(Estimate::about(value, half)) } else { Err(Reason::NoFit) }
    }
}

fn logarithms(values: &[f64], moments: &Moments) -> Result<Vec<f64>, Reason> {
    if moments.least <= 0.0 {
        Err(Reason::NotPositive)
    } else {
        Ok(values.iter().map(|&value| libm::log(value)).collect())
    }
}

/// Scale and shape of Weibull's law by maximum likelihood.
fn weibull(values: &[f64], moments: &Moments) -> Result<[f64; 2], Reason> {
    let logarithms = logarithms(values, moments)?;
    let of = Moments::of(&logarithms)?;
    // With the greatest value as the unit, no power overflows.
    let unit = libm::log(moments.greatest);
    let powers = |shape: f64| {
        let (mut sum, mut weighted) = (0.0, 0.0);
        for logarithm in &logarithms {
            let power = libm::exp(shape * (logarithm - unit));
            sum += power;
            weighted += power * logarithm;
        }
        (sum, weighted)
    };
    let score = |shape: f64| {
        let (sum, weighted) = powers(shape);
        weighted / sum - 1.0 / shape - of.mean
    };
    // The shape of the same law by its moments: the logarithm has the standard deviation π / (√6 k).
    let first = std::f64::consts::PI / 6.0_f64.sqrt() / of.deviation()?;
    let shape = root([first / 20.0, first * 20.0], score).ok_or(Reason::NoFit)?;
    let (sum, _) = powers(shape);
    Ok([moments.greatest * libm::pow(sum / count(of.count), 1.0 / shape), shape])
}

/// Mean and standard deviation before folding, by maximum likelihood: the mean is that of x tanh(x μ / σ²), and
/// σ² is the mean square less μ². Values as flat as a bell about 0 have the mean 0.
fn folded(values: &[f64], moments: &Moments) -> Result<[f64; 2], Reason> {
    if moments.least < 0.0 {
        return Err(Reason::Negative);
    }
    let number = count(values.len());
    let square = values.iter().map(|value| value * value).sum::<f64>() / number;
    let fourth = values.iter().map(|value| value.powi(4)).sum::<f64>() / number;
    if 3.0 * square * square <= fourth {
        return Ok([0.0, square.sqrt()]);
    }
    let score = |mean: f64| {
        let variance = square - mean * mean;
        values.iter().map(|value| value * libm::tanh(value * mean / variance)).sum::<f64>() / number - mean
    };
    let mean = root([moments.mean * 1e-3, moments.mean], score);
    let mean = mean.unwrap_or(if score(moments.mean * 1e-3) < 0.0 { 0.0 } else { moments.mean });
    Ok([mean, (square - mean * mean).sqrt()])
}

/// Steps by which parameters are changed to see what changes with them.
fn steps(law: &Law) -> [f64; 2] {
    let scale = if law.family == Family::Weibull { law.first / law.second } else { law.second };
    [1e-4 * scale, 1e-4 * law.second]
}

/// The inverse of the observed information; the first parameter is fixed where it is at the end of its range.
fn covariance(law: &Law, values: &[f64]) -> Option<[f64; 3]> {
    let [one, two] = steps(law);
    let likelihood = |a: f64, b: f64| {
        let law = law.family.with([law.first + a * one, law.second + b * two]);
        values.iter().map(|value| law.density(*value)).sum::<f64>()
    };
    let middle = likelihood(0.0, 0.0);
    let second = (2.0 * middle - likelihood(0.0, 1.0) - likelihood(0.0, -1.0)) / (two * two);
    if law.family == Family::FoldedNormal && law.first < one {
        return (0.0 < second).then(|| [0.0, 0.0, 1.0 / second]);
    }
    let first = (2.0 * middle - likelihood(1.0, 0.0) - likelihood(-1.0, 0.0)) / (one * one);
    let mixed = likelihood(1.0, 1.0) - likelihood(1.0, -1.0) - likelihood(-1.0, 1.0) + likelihood(-1.0, -1.0);
    let mixed = -mixed / (4.0 * one * two);
    let determinant = first * second - mixed * mixed;
    (0.0 < determinant && 0.0 < first).then(|| [second, -mixed, first].map(|entry| entry / determinant))
}
