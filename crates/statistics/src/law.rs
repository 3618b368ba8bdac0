//! The laws of test statistics: normal, chi-square, Student's, Fisher's.
//!
//! Quantiles are sought on the distribution functions, whose values keep their digits in both tails; the
//! functions behind them are those of `libm` and `statrs`. The quantiles of `statrs` itself are not used: those of the beta
//! and F laws have open faults. Tests compare with 30 digits.

use libm::erfc;
use statrs::function::beta::checked_beta_reg;
use statrs::function::gamma::{checked_gamma_lr, checked_gamma_ur};

/// A probability with the rest to 1, so that neither loses digits where it is small.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tails {
    /// The probability of at most this value.
    pub below: f64,
    /// The probability of more than this value.
    pub above: f64,
}

impl Tails {
    const fn of(share: f64) -> Self {
        Self { below: share, above: 1.0 - share }
    }
}

/// The normal law with mean 0 and standard deviation 1.
pub fn normal(z: f64) -> Tails {
    let root = std::f64::consts::SQRT_2;
    Tails { below: 0.5 * erfc(-z / root), above: 0.5 * erfc(z / root) }
}

/// The value below which a share of the standard normal law lies; infinite for 0 and 1, and `NaN` beyond them.
pub fn normal_quantile(share: f64) -> f64 {
    if !(0.0..=1.0).contains(&share) {
        return f64::NAN;
    }
    if 0.5 < share {
        return -normal_quantile(1.0 - share);
    }
    if share <= 0.0 {
        return f64::NEG_INFINITY;
    }
    -root([0.0, 40.0], |z| libm::log(share) - libm::log(normal(z).above)).unwrap_or(f64::NAN)
}

/// The chi-square law of this many degrees of freedom, which need not be whole.
pub fn chi_square(degrees: f64, value: f64) -> Tails {
    if value <= 0.0 {
        return Tails { below: 0.0, above: 1.0 };
    }
    let of = |found: Option<f64>| found.unwrap_or(f64::NAN);
    Tails {
        below: of(checked_gamma_lr(degrees / 2.0, value / 2.0).ok()),
        above: of(checked_gamma_ur(degrees / 2.0, value / 2.0).ok()),
    }
}

/// The value below which a share of the chi-square law lies.
pub fn chi_square_quantile(degrees: f64, share: f64) -> f64 {
    positive_quantile(Tails::of(share), |value| chi_square(degrees, value))
}

/// Student's law.
pub fn student(degrees: f64, t: f64) -> Tails {
    let outside = beta(degrees / 2.0, 0.5, degrees, t * t);
    let (small, large) = (outside / 2.0, 1.0 - outside / 2.0);
    if t < 0.0 { Tails { below: small, above: large } } else { Tails { below: large, above: small } }
}

/// The value below which a share of Student's law lies.
pub fn student_quantile(degrees: f64, share: f64) -> f64 {
    if share < 0.5 { -student_above(degrees, share) } else { student_above(degrees, 1.0 - share) }
}

/// From so many degrees of freedom up the series of Student's quantile is exact to twelve digits; the beta function is not.
const MANY: f64 = 10_000.0;

/// The value above which a share of Student's law lies, at most a half. The series is that of Abramowitz and Stegun, 26.7.5.
fn student_above(degrees: f64, share: f64) -> f64 {
    if 0.5 <= share {
        0.0
    } else if degrees < MANY {
        positive_quantile(Tails { below: 1.0 - share, above: share }, |t| student(degrees, t))
    } else {
        let z = -normal_quantile(share);
        let square = z * z;
        z + z * (square + 1.0) / (4.0 * degrees)
            + z * ((5.0 * square + 16.0) * square + 3.0) / (96.0 * degrees * degrees)
    }
}

/// How many standard errors to either side cover an estimate at this level.
pub fn student_factor(degrees: f64, level: f64) -> f64 {
    student_above(degrees, (1.0 - level) / 2.0)
}

/// The probability of more than |t| to either side.
pub fn student_both(degrees: f64, t: f64) -> f64 {
    beta(degrees / 2.0, 0.5, degrees, t * t)
}

/// Fisher's law: the ratio of two mean squares with these degrees of freedom.
pub fn fisher(degrees: [f64; 2], ratio: f64) -> Tails {
    let [of, by] = degrees;
    if ratio <= 0.0 {
        return Tails { below: 0.0, above: 1.0 };
    }
    Tails { below: beta(of / 2.0, by / 2.0, of * ratio, by), above: beta(by / 2.0, of / 2.0, by, of * ratio) }
}

/// The value below which a share of Fisher's law lies.
pub fn fisher_quantile(degrees: [f64; 2], share: f64) -> f64 {
    positive_quantile(Tails::of(share), |ratio| fisher(degrees, ratio))
}

/// The regularised incomplete beta function at `part / (part + rest)`.
fn beta(a: f64, b: f64, part: f64, rest: f64) -> f64 {
    let share = if rest.is_infinite() { 0.0 } else { part / (part + rest) };
    checked_beta_reg(a, b, share).unwrap_or(f64::NAN)
}

/// The quantile of a law of positive values: sought over all magnitudes, on the tail that has the digits.
fn positive_quantile(at: Tails, law: impl Fn(f64) -> Tails) -> f64 {
    if !(0.0..=1.0).contains(&at.below) {
        return f64::NAN;
    }
    let lacks = |logarithm: f64| {
        let Tails { below, above } = law(libm::exp(logarithm));
        if at.below < 0.5 { libm::log(below) - libm::log(at.below) } else { libm::log(at.above) - libm::log(above) }
    };
    root([-700.0, 700.0], lacks).map_or(f64::NAN, libm::exp)
}

/// Where a function changes its sign, to the last bits: regula falsi with the weights of Illinois, and every third step halves.
/// `None` where it does not change its sign.
pub(crate) fn root([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> Option<f64> {
    let (mut at_low, mut at_high) = (of(low), of(high));
    if at_low.is_nan() || at_high.is_nan() || (0.0 < at_low) == (0.0 < at_high) {
        return None;
    }
    let mut last = 0.0;
    for step in 0..300 {
        let middle = f64::midpoint(low, high);
        if middle <= low || high <= middle {
            break;
        }
        let chord = (low * at_high - high * at_low) / (at_high - at_low);
        let next = if step % 3 < 2 && low < chord && chord < high { chord } else { middle };
        let found = of(next);
        let is_high = (0.0 < found) == (0.0 < at_high);
        if is_high {
            (high, at_high) = (next, found);
            at_low *= if 0.0 < found * last { 0.5 } else { 1.0 };
        } else {
            (low, at_low) = (next, found);
            at_high *= if 0.0 < found * last { 0.5 } else { 1.0 };
        }
        last = found;
    }
    Some(if at_low.abs() < at_high.abs() { low } else { high })
}
