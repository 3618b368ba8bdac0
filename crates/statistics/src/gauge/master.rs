//! Type 1: many readings of one calibrated master give scatter and bias (VDA 5; Bosch booklet 10; AIAG MSA).
//!
//! Cg = share × T / (spread × s) and Cgk = (share / 2 × T − |bias|) / (spread / 2 × s), usually with a fifth of the tolerance and 6 s.

use crate::moments::{Estimate, Moments, count, parameter};
use crate::reason::Reason;
use fitcheck_core::law::{normal_quantile, student_both};

/// What the readings are compared with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MasterPlan {
    /// The calibrated size.
    pub reference: f64,
    /// The width of the tolerance; above 0.
    pub tolerance: f64,
    /// The share of the tolerance that the scatter may have; 0.2.
    pub share: f64,
    /// How many s the scatter spans; 6, in some houses 4.
    pub spread: f64,
    /// What Cg and Cgk must reach; 1.33.
    pub required: f64,
    /// The smallest step of the display, which may be a twentieth of the tolerance.
    pub resolution: Option<f64>,
    /// The level of the intervals.
    pub level: f64,
}

impl MasterPlan {
    /// A fifth of the tolerance over 6 s, at least 1.33, with intervals of 95 %.
    pub const fn of(reference: f64, tolerance: f64) -> Self {
        Self { reference, tolerance, share: 0.2, spread: 6.0, required: 1.33, resolution: None, level: 0.95 }
    }
}

/// What a type 1 study found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MasterStudy {
    /// Count, mean and spread of the readings.
    pub moments: Moments,
    /// Their standard deviation.
    pub deviation: Estimate,
    /// How far the mean is above the calibrated size.
    pub bias: Estimate,
    /// The bias in standard errors.
    pub t: f64,
    /// How probable that is where there is no bias.
    pub p: f64,
    /// Cg.
    pub cg: Estimate,
    /// Cgk.
    pub cgk: Estimate,
    /// The smallest tolerance for which Cg, Cgk and the resolution are good enough. Its interval has both ends of scatter and bias.
    pub smallest: Estimate,
    /// Whether all of them are good enough for the given tolerance.
    pub is_good: bool,
}

/// Evaluates readings of a master.
///
/// # Errors
/// Fewer than two readings, equal ones, which say that the display is too coarse, values that are no finite numbers, parameters
/// beyond their range.
pub fn master_study(readings: &[f64], plan: &MasterPlan) -> Result<MasterStudy, Reason> {
    let MasterPlan { tolerance, share, spread, required, resolution, level, .. } = *plan;
    let positive = [("tolerance", tolerance), ("share", share), ("spread", spread), ("required", required)];
    let resolution_given = resolution.map(|resolution| ("resolution", resolution));
    for (name, given) in positive.into_iter().chain(resolution_given) {
        if !(0.0 < given && given.is_finite()) {
            return Err(parameter(name, given));
        }
    }
    let moments = Moments::of(readings)?;
    let deviation = moments.deviation_estimate(level)?;
    let bias = moments.mean_estimate(level)?.map(|mean| mean - plan.reference);
    let number = count(moments.count);
    let t = bias.value * number.sqrt() / deviation.value;
    let index = (share / 2.0 * tolerance - bias.value.abs()) / (spread / 2.0 * deviation.value);
    // As Bissell's interval of Cpk: s counts for the distance, the mean for its place, in units of spread / 2 s.
    let error = (4.0 / (spread * spread * number) + index * index / (2.0 * moments.degrees())).sqrt();
    let needed = |deviation: f64, bias: f64| {
        let by_scatter = required * spread * deviation / share;
        let by_bias = 2.0 * (required * spread / 2.0 * deviation + bias) / share;
        by_scatter.max(by_bias).max(resolution.unwrap_or(0.0) * 20.0)
    };
    let holds_zero = bias.lower <= 0.0 && 0.0 <= bias.upper;
    let [near, far] = [bias.lower.abs().min(bias.upper.abs()), bias.lower.abs().max(bias.upper.abs())];
    let smallest = Estimate {
        value: needed(deviation.value, bias.value.abs()),
        lower: needed(deviation.lower, if holds_zero { 0.0 } else { near }),
        upper: needed(deviation.upper, far),
    };
    Ok(MasterStudy {
        moments,
        deviation,
        bias,
        t,
        p: student_both(moments.degrees(), t),
        cg: deviation.map(|deviation| share * tolerance / (spread * deviation)),
        cgk: Estimate::about(index, normal_quantile(f64::midpoint(1.0, level)) * error),
        smallest,
        is_good: smallest.value <= tolerance,
    })
}
