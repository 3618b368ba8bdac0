//! Whether values come from a law: the test of Anderson and Darling.

use crate::fitted::{Family, Fitted, Law};
use crate::moments::{count, parameter};
use crate::reason::Reason;

/// What the test found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AndersonDarling {
    /// The statistic A².
    pub statistic: f64,
    /// The same for fitted parameters and this number of values, A*²; as it is where nothing is known of it.
    pub adjusted: f64,
    /// How probable such a statistic is where the law holds; `None` for the folded normal law, for which no table is published.
    pub p: Option<f64>,
}

/// Tests whether values come from a law of a family that is fitted to them.
///
/// The probability is that of D'Agostino and Stephens (1986) for the normal and the lognormal law, and that of CMH-17 for Weibull's.
///
/// # Errors
/// What the fit refuses, and fewer than eight values, for which the approximations do not hold.
pub fn anderson_darling(values: &[f64], fitted: &Fitted) -> Result<AndersonDarling, Reason> {
    let needed = 8;
    if values.len() < needed {
        return Err(Reason::TooFew { found: values.len(), needed });
    }
    let law = fitted.law;
    let statistic = statistic(values, &law);
    if !statistic.is_finite() {
        return Err(parameter("A²", statistic));
    }
    let number = count(values.len());
    Ok(match law.family {
        Family::Normal | Family::LogNormal => {
            let adjusted = statistic * (1.0 + 0.75 / number + 2.25 / (number * number));
            AndersonDarling { statistic, adjusted, p: Some(normal_p(adjusted)) }
        }
        Family::Weibull => {
            let adjusted = statistic * (1.0 + 0.2 / number.sqrt());
            let p = 1.0 / (1.0 + libm::exp(-0.1 + 1.24 * libm::log(adjusted) + 4.48 * adjusted));
            AndersonDarling { statistic, adjusted, p: Some(p) }
        }
        Family::FoldedNormal => AndersonDarling { statistic, adjusted: statistic, p: None },
    })
}

fn statistic(values: &[f64], law: &Law) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let tails: Vec<_> = sorted.iter().map(|value| law.tails(*value)).collect();
    let number = count(values.len());
    let pairs = tails.iter().zip(tails.iter().rev()).enumerate();
    let sum: f64 =
        pairs.map(|(at, (low, high))| (2.0 * count(at) + 1.0) * (libm::log(low.below) + libm::log(high.above))).sum();
    -number - sum / number
}

/// D'Agostino and Stephens 1986, table 4.9.
fn normal_p(a: f64) -> f64 {
    let p = if 0.6 <= a {
        libm::exp(1.2937 - 5.709 * a + 0.0186 * a * a)
    } else if 0.34 <= a {
        libm::exp(0.9177 - 4.279 * a - 1.38 * a * a)
    } else if 0.2 <= a {
        1.0 - libm::exp(-8.318 + 42.796 * a - 59.938 * a * a)
    } else {
        1.0 - libm::exp(-13.436 + 101.14 * a - 223.73 * a * a)
    };
    // Beyond 13 the parabola of the exponent would rise again.
    if 13.0 < a { 0.0 } else { p }
}
