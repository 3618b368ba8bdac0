//! The laws of errors and of test statistics: normal, gamma, chi-square, Student's, Fisher's.
//!
//! The same bits on every system: nothing behind them but the functions of `libm`. Quantiles are sought on the distribution functions,
//! whose values keep their digits in both tails. Tests of `crates/statistics` compare with 30 digits.

use std::f64::consts::TAU;

use libm::erfc;

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

/// The gamma law of this shape, with scale 1: the regularised incomplete gamma functions.
pub fn gamma(shape: f64, value: f64) -> Tails {
    if value <= 0.0 {
        return Tails { below: 0.0, above: 1.0 };
    }
    let density = gamma_density(shape, value) * value;
    if value < shape + 1.0 {
        let (mut term, mut sum) = (1.0 / shape, 1.0 / shape);
        for step in 1..MOST_TERMS {
            term *= value / (shape + f64::from(step));
            sum += term;
            if term <= sum * f64::EPSILON / 4.0 {
                break;
            }
        }
        Tails::of(density * sum)
    } else {
        // The fraction of Legendre: 1/(x+1-a- 1(1-a)/(x+3-a- 2(2-a)/(x+5-a- …
        let term = |step: f64| (step * (shape - step), value + 2.0 * step + 1.0 - shape);
        let above = density / fraction(value + 1.0 - shape, term);
        Tails { below: 1.0 - above, above }
    }
}

/// The density of the same law, for a value above 0. By the saddle point, so that a large shape loses no digits (C. Loader, Fast and
/// Accurate Computation of Binomial Probabilities, 2000).
pub fn gamma_density(shape: f64, value: f64) -> f64 {
    if value <= 0.0 {
        return 0.0;
    }
    libm::sqrt(shape / TAU) * libm::exp(-deviance(shape, value) - stirling_error(shape)) / value
}

/// The chi-square law of this many degrees of freedom, which need not be whole.
pub fn chi_square(degrees: f64, value: f64) -> Tails {
    gamma(degrees / 2.0, value / 2.0)
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

/// From so many degrees of freedom up the series of Student's quantile is exact to twelve digits.
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
    if rest.is_infinite() || part <= 0.0 {
        return 0.0;
    }
    if part.is_infinite() || rest <= 0.0 {
        return 1.0;
    }
    let all = part + rest;
    let (x, y) = (part / all, rest / all);
    let both = a + b;
    let at = deviance(a, both * x) + deviance(b, both * y);
    let errors = stirling_error(both) - stirling_error(a) - stirling_error(b);
    let front = libm::sqrt(a / TAU * (b / both)) * libm::exp(errors - at);
    if x < (a + 1.0) / (both + 2.0) {
        front / beta_fraction([a, b], [x, y])
    } else {
        1.0 - front / beta_fraction([b, a], [y, x])
    }
}

/// The continued fraction below the incomplete beta function whose first terms do not cancel near its middle: A. Didonato and A. Morris,
/// Algorithm 708, 1992, equation 9. `y` is 1 − `x`.
fn beta_fraction([a, b]: [f64; 2], [x, y]: [f64; 2]) -> f64 {
    let denominator = |n: f64| {
        let last = (a + n) * (a * y - b * x + 1.0 + n * (1.0 + y)) / (a + 2.0 * n + 1.0);
        if n < 0.5 { last } else { n + n * (b - n) * x / (a + 2.0 * n - 1.0) + last }
    };
    let numerator = |n: f64| {
        let at = x / (a + 2.0 * n - 1.0);
        (a + n - 1.0) * at * (a + b + n - 1.0) * at * n * (b - n)
    };
    fraction(denominator(0.0), |n| (numerator(n), denominator(n)))
}

/// So many terms of a series or a fraction are taken at most: the square root of the largest parameter and some more are needed.
const MOST_TERMS: u32 = 200_000;

/// A number and a continued fraction behind it, whose terms are numerators and denominators from the first one on, by the method of Lentz.
fn fraction(before: f64, term: impl Fn(f64) -> (f64, f64)) -> f64 {
    let kept = |value: f64| if value.abs() < f64::MIN_POSITIVE { f64::MIN_POSITIVE } else { value };
    let (mut value, mut forward, mut inverse) = (kept(before), kept(before), 0.0);
    for step in 1..MOST_TERMS {
        let (numerator, denominator) = term(f64::from(step));
        inverse = 1.0 / kept(denominator + numerator * inverse);
        forward = kept(denominator + numerator / forward);
        let factor = forward * inverse;
        value *= factor;
        if (factor - 1.0).abs() <= f64::EPSILON {
            break;
        }
    }
    value
}

/// How far ln Γ(n+1) is from Stirling's √(2πn) (n/e)ⁿ.
fn stirling_error(n: f64) -> f64 {
    if n < 16.0 {
        return libm::lgamma(n + 1.0) - (n + 0.5) * libm::log(n) + n - 0.5 * libm::log(TAU);
    }
    let square = n * n;
    let rest = 1.0 / 1_680.0 - (1.0 / 1_188.0 - 691.0 / 360_360.0 / square) / square;
    (1.0 / 12.0 - (1.0 / 360.0 - (1.0 / 1_260.0 - rest / square) / square) / square) / n
}

/// `x ln(x / mean) + mean − x`, exact where both are nearly the same.
fn deviance(x: f64, mean: f64) -> f64 {
    let off = x - mean;
    if x + mean <= 10.0 * off.abs() {
        return x * (libm::log(x) - libm::log(mean)) - off;
    }
    let ratio = off / (x + mean);
    let mut sum = off * ratio;
    let mut term = 2.0 * x * ratio;
    for odd in 1..1_000 {
        term *= ratio * ratio;
        let next = sum + term / f64::from(2 * odd + 1);
        if next.total_cmp(&sum).is_eq() {
            break;
        }
        sum = next;
    }
    sum
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
pub fn root([mut low, mut high]: [f64; 2], of: impl Fn(f64) -> f64) -> Option<f64> {
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
