//! A master over time: a chart of its readings, and whether they drift.

use crate::chart::{Chart, ChartPlan, Sample, chart};
use crate::moments::{Moments, checked_level};
use crate::reason::Reason;
use crate::trend::{Trend, trend};

/// What a stability study found.
#[derive(Debug, Clone, PartialEq)]
pub struct Stability {
    /// The chart of the readings.
    pub chart: Chart,
    /// The trend of the points that are not left out, by their numbers.
    pub trend: Trend,
}

impl Stability {
    /// Whether no rule fires and nothing drifts.
    pub fn is_stable(&self) -> bool {
        let is_quiet = |point: &crate::chart::ChartPoint| {
            point.location.fired.is_empty() && point.spread.is_none_or(|spread| spread.fired.is_empty())
        };
        self.chart.points.iter().all(is_quiet) && !self.trend.is_real()
    }
}

/// Evaluates readings of a master, one sample each time it was read.
///
/// # Errors
/// What the chart and the trend refuse.
pub fn stability(samples: &[Sample], plan: &ChartPlan, level: f64) -> Result<Stability, Reason> {
    checked_level(level)?;
    let chart = chart(samples, plan)?;
    let counted = samples.iter().filter(|sample| sample.left_out.is_none());
    let means = counted.map(|sample| Ok(Moments::of(&sample.values)?.mean)).collect::<Result<Vec<_>, _>>()?;
    Ok(Stability { chart, trend: trend(&means, None, 0.0, level)? })
}
