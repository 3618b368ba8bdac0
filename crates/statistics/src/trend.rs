//! Where a series goes: its slope, the parts that are left until a limit, and how far a tool must be corrected.

use crate::line::Line;
use crate::moments::{Estimate, Moments, checked, checked_level, count, parameter};
use crate::reason::Reason;
use crate::tolerance::Tolerance;

/// The trend of a series.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trend {
    /// The line over the numbers of the values, from 1.
    pub line: Line,
    /// The change from one value to the next.
    pub slope: Estimate,
    /// When it reaches the limit that it goes to; `None` where the slope is noise, or that limit does not exist.
    pub reach: Option<Reach>,
}

/// How many more parts there are until the mean is as near to a limit as its reserve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Reach {
    /// The limit.
    pub limit: f64,
    /// The parts until then, counted from the last value; 0 where it is over already. The upper end may be infinite.
    pub parts: Estimate,
}

impl Trend {
    /// Whether the slope differs from 0 at the level of its interval.
    pub fn is_real(&self) -> bool {
        0.0 < self.slope.lower || self.slope.upper < 0.0
    }
}

/// The trend of values in their order, and when it reaches a limit.
///
/// `reserve` is how many standard deviations about the line the mean stays away from the limit: with 3, one part in a thousand is
/// beyond it then; with 0, every second. The interval of the parts is that of Fieller (1954).
///
/// # Errors
/// Fewer than three values, values that are no finite numbers, or that lie on a line.
pub fn trend(values: &[f64], tolerance: Option<&Tolerance>, reserve: f64, level: f64) -> Result<Trend, Reason> {
    checked(values)?;
    checked_level(level)?;
    if !(0.0..=100.0).contains(&reserve) {
        return Err(parameter("reserve", reserve));
    }
    let points: Vec<[f64; 2]> = values.iter().enumerate().map(|(at, value)| [count(at + 1), *value]).collect();
    let line = Line::of(&points)?;
    let mut found = Trend { line, slope: line.slope_estimate(level), reach: None };
    if found.is_real() {
        let rises = 0.0 < line.slope.value;
        let limit = tolerance.and_then(|limits| if rises { limits.upper() } else { limits.lower() });
        let sign = if rises { 1.0 } else { -1.0 };
        found.reach = limit
            .map(|limit| Reach { limit, parts: parts_until(&line, limit - sign * reserve * line.deviation, level) });
    }
    Ok(found)
}

/// The parts until the line reaches a value; its slope differs from 0.
fn parts_until(line: &Line, value: f64, level: f64) -> Estimate {
    let (slope, rise) = (line.slope.value, value - line.level);
    let left = |from_middle: f64| (line.middle + from_middle - count(line.count)).max(0.0);
    let factor = (line.factor(level) * line.deviation).powi(2);
    let square = slope * slope - factor / line.squares;
    let rest = rise * rise - factor / count(line.count);
    let root = (slope * slope * rise * rise - square * rest).max(0.0).sqrt();
    let ends = [-1.0, 1.0].map(|sign| (slope * rise + sign * root) / square);
    let [one, other] = ends.map(left);
    Estimate { value: left(rise / slope), lower: one.min(other), upper: one.max(other) }
}

/// Whether and how far a tool must be corrected.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Offset {
    /// How far the size is above the middle of the tolerance; negative below.
    pub distance: Estimate,
    /// Whether that is the end of the line of a trend: the mean of a drift is where the size was some time ago.
    pub is_of_trend: bool,
    /// By how much sizes must change: whole steps and never more than the size is off. `None` where the interval holds 0, which is
    /// noise, or less than one step is left.
    pub correction: Option<f64>,
    /// How many values it comes from.
    pub count: usize,
}

/// What the mean, or with a trend the last point of its line, says of the tool's offset. Who corrects noise makes the scatter
/// larger (Deming's funnel).
///
/// # Errors
/// Fewer than two values, equal ones, values that are no finite numbers, a step that is not above 0.
pub fn offset(values: &[f64], middle: f64, step: f64, level: f64) -> Result<Offset, Reason> {
    let moments = Moments::of(values)?;
    if !(0.0 < step && step.is_finite()) {
        return Err(parameter("step", step));
    }
    let mean = moments.mean_estimate(level)?;
    let drift = trend(values, None, 0.0, level).ok().filter(Trend::is_real);
    let now = drift.map_or(mean, |drift| drift.line.at(count(moments.count), level));
    let distance = now.map(|size| size - middle);
    let is_real = 0.0 < distance.lower || distance.upper < 0.0;
    let steps = (distance.value / step).trunc();
    let correction = (is_real && 1.0 <= steps.abs()).then_some(-steps * step);
    Ok(Offset { distance, is_of_trend: drift.is_some(), correction, count: moments.count })
}
