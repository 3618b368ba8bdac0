//! Bias over the range of sizes: readings of several masters and the line through their biases (AIAG MSA).

use crate::line::Line;
use crate::moments::{Estimate, Moments, checked_level, count};
use crate::reason::Reason;
use crate::sigma::{Method, Sigma};
use fitcheck_core::law::{student_both, student_factor};

/// The bias at one master.
#[derive(Debug, Clone, PartialEq)]
pub struct BiasAt {
    /// The calibrated size.
    pub reference: f64,
    /// How many readings there are.
    pub count: usize,
    /// The mean bias.
    pub mean: f64,
    /// The same with its interval; a master with one reading, or with equal ones, has none.
    pub bias: Result<Estimate, Reason>,
    /// How probable such a bias is where there is none; `None` without an interval.
    pub p: Option<f64>,
}

/// What a linearity study found.
#[derive(Debug, Clone, PartialEq)]
pub struct Linearity {
    /// The bias over the calibrated size: it changes with it where the slope differs from 0.
    pub line: Line,
    /// The bias of all readings, with the standard deviation within masters; none where each master has one reading.
    pub bias: Result<Estimate, Reason>,
    /// The bias at each master, in the order of their sizes.
    pub masters: Vec<BiasAt>,
}

/// Evaluates readings of several masters, each with its calibrated size.
///
/// # Errors
/// Fewer than two masters or three readings, values that are no finite numbers, biases that lie on a line.
pub fn linearity(readings: &[[f64; 2]], level: f64) -> Result<Linearity, Reason> {
    checked_level(level)?;
    let biases: Vec<[f64; 2]> = readings.iter().map(|[reference, value]| [*reference, value - reference]).collect();
    let line = Line::of(&biases)?;
    let mut sorted = biases;
    sorted.sort_by(|[one, _], [other, _]| one.total_cmp(other));
    let (mut masters, mut within) = (Vec::new(), Vec::new());
    for master in sorted.chunk_by(|[one, _], [other, _]| one.total_cmp(other).is_eq()) {
        let values: Vec<f64> = master.iter().map(|[_, bias]| *bias).collect();
        let of = Moments::of(&values)?;
        masters.push(BiasAt {
            reference: master.first().map_or(f64::NAN, |[reference, _]| *reference),
            count: of.count,
            mean: of.mean,
            bias: of.mean_estimate(level),
            p: of.deviation().ok().map(|s| student_both(of.degrees(), of.mean * count(of.count).sqrt() / s)),
        });
        within.push(values);
    }
    let mean = Moments::of(&within.concat())?.mean;
    let bias = Sigma::within(within.iter().map(Vec::as_slice), Method::Pooled).map(|sigma| {
        Estimate::about(mean, student_factor(sigma.degrees, level) * sigma.value / count(readings.len()).sqrt())
    });
    Ok(Linearity { line, bias, masters })
}
