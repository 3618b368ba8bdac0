//! Charts of individuals and moving ranges, of means and ranges, of means and standard deviations.
//!
//! ISO 7870-2; Montgomery, *Introduction to Statistical Quality Control*. Limits are 3 s to either side; those of a stage come
//! from its baseline and stay as they are when points are added. A point that is left out stays on the chart with its reason;
//! limits, moving ranges and rules are those of the series without it. On ranges and standard deviations only the rule of
//! the limits is used.

use std::ops::Range;
use std::sync::Arc;

use crate::constants::{c4, d2, d3};
use crate::moments::{Moments, count};
use crate::reason::Reason;
use crate::rules::{Rule, Rules, Scanner};
use crate::sigma::{Method, Sigma};

/// A kind of chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChartKind {
    /// Single values and their moving ranges (I-MR).
    Individuals,
    /// Means and ranges of subgroups (X̄-R).
    MeansRanges,
    /// Means and standard deviations of subgroups (X̄-s).
    MeansDeviations,
}

impl ChartKind {
    /// Its name in files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Individuals => "I-MR",
            Self::MeansRanges => "Xbar-R",
            Self::MeansDeviations => "Xbar-s",
        }
    }

    /// The chart for subgroups of at most this size: ranges up to ten values, as they say less of more.
    pub const fn for_size(largest: usize) -> Self {
        match largest {
            0 | 1 => Self::Individuals,
            2..=10 => Self::MeansRanges,
            _ => Self::MeansDeviations,
        }
    }

    /// How it estimates the standard deviation.
    pub const fn method(self) -> Method {
        match self {
            Self::Individuals => Method::MovingRange,
            Self::MeansRanges => Method::Ranges,
            Self::MeansDeviations => Method::Deviations,
        }
    }
}

/// What one point of a chart is made of: one value, or those of a subgroup.
#[derive(Debug, Clone, PartialEq)]
pub struct Sample {
    /// The values; at least one.
    pub values: Vec<f64>,
    /// Why the point is left out of limits and rules, where it is.
    pub left_out: Option<Arc<str>>,
}

impl Sample {
    /// A sample that counts.
    pub const fn of(values: Vec<f64>) -> Self {
        Self { values, left_out: None }
    }
}

/// Where the limits of a stage come from.
#[derive(Debug, Clone, PartialEq)]
pub enum Baseline {
    /// All points of the stage.
    All,
    /// These points of the series, within the stage; counted from 0.
    Points(Range<usize>),
    /// Mean and standard deviation of single values, from an earlier study.
    Known {
        /// The mean.
        mean: f64,
        /// The standard deviation; above 0.
        sigma: f64,
    },
}

/// A stretch of a chart with limits of its own, up to the next stage.
#[derive(Debug, Clone, PartialEq)]
pub struct Stage {
    /// Its first point, counted from 0.
    pub first: usize,
    /// Where its limits come from.
    pub baseline: Baseline,
}

/// What is drawn and how.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartPlan {
    /// The kind of chart.
    pub kind: ChartKind,
    /// How the standard deviation is estimated. A chart of individuals takes [`Method::MovingRange`] or [`Method::Deviations`], s / c4 of
    /// all values; the others take any but the moving range.
    pub method: Method,
    /// Which rules are looked at.
    pub rules: Rules,
    /// The stages, in order; the first one begins at 0.
    pub stages: Vec<Stage>,
}

impl ChartPlan {
    /// A chart of one stage with the limits of all its points and all rules of Nelson.
    pub fn of(kind: ChartKind) -> Self {
        let stages = vec![Stage { first: 0, baseline: Baseline::All }];
        Self { kind, method: kind.method(), rules: Rules::NELSON, stages }
    }
}

/// A stage with its figures.
#[derive(Debug, Clone, PartialEq)]
pub struct StageFigures {
    /// Its points.
    pub points: Range<usize>,
    /// Its centre line.
    pub mean: f64,
    /// The standard deviation of single values.
    pub sigma: Sigma,
    /// How many points say how wide the limits are: of subgroups those of several values; 0 where the limits were given.
    pub baseline: usize,
}

/// One of the two figures of a sample, with its limits.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The figure.
    pub value: f64,
    /// The lower control limit.
    pub lower: f64,
    /// The centre line.
    pub centre: f64,
    /// The upper control limit.
    pub upper: f64,
    /// The rules that fire here.
    pub fired: Rules,
}

/// A point of a chart.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartPoint {
    /// Value or mean.
    pub location: Point,
    /// Moving range, range or standard deviation: none at the first value of a stage and in subgroups of one value.
    pub spread: Option<Point>,
    /// Why it is left out, where it is.
    pub left_out: Option<Arc<str>>,
}

/// A computed chart.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Its kind.
    pub kind: ChartKind,
    /// Its stages.
    pub stages: Vec<StageFigures>,
    /// A point for each sample.
    pub points: Vec<ChartPoint>,
}

/// Computes a chart.
///
/// # Errors
/// No samples, a sample without values or with values that are no finite numbers, stages or baselines that do not fit the series,
/// a baseline of fewer than two counted points or without spread, more than 25 values for a range.
pub fn chart(samples: &[Sample], plan: &ChartPlan) -> Result<Chart, Reason> {
    if samples.is_empty() {
        return Err(Reason::Empty);
    }
    let mut place = 0;
    for sample in samples {
        if sample.values.is_empty() || plan.kind == ChartKind::Individuals && 1 < sample.values.len() {
            return Err(Reason::NoSubgroups);
        }
        if let Some(at) = sample.values.iter().position(|value| !value.is_finite()) {
            return Err(Reason::NotANumber { place: place + at + 1 });
        }
        place += sample.values.len();
    }
    let mut drawn = Chart { kind: plan.kind, stages: Vec::new(), points: Vec::with_capacity(samples.len()) };
    let ends = plan.stages.iter().skip(1).map(|stage| stage.first).chain([samples.len()]);
    for (stage, end) in plan.stages.iter().zip(ends) {
        let points = stage.first..end;
        let within = samples.get(points.clone()).filter(|within| !within.is_empty()).ok_or(Reason::NoBaseline)?;
        if stage.first != drawn.points.len() {
            return Err(Reason::NoBaseline);
        }
        let figures = figures(samples, points, &stage.baseline, plan)?;
        draw(within, &figures, plan, &mut drawn.points)?;
        drawn.stages.push(figures);
    }
    if drawn.points.len() < samples.len() { Err(Reason::NoBaseline) } else { Ok(drawn) }
}

/// Centre line and standard deviation of a stage.
fn figures(
    samples: &[Sample],
    points: Range<usize>,
    baseline: &Baseline,
    plan: &ChartPlan,
) -> Result<StageFigures, Reason> {
    let from = match baseline {
        Baseline::All => points.clone(),
        Baseline::Points(from) if points.start <= from.start && from.end <= points.end => from.clone(),
        Baseline::Points(_) => return Err(Reason::NoBaseline),
        Baseline::Known { mean, sigma } => {
            if !mean.is_finite() || !sigma.is_finite() || *sigma <= 0.0 {
                return Err(Reason::NoBaseline);
            }
            let sigma = Sigma { value: *sigma, degrees: f64::INFINITY, method: Method::Known };
            return Ok(StageFigures { points, mean: *mean, sigma, baseline: 0 });
        }
    };
    let counted: Vec<&[f64]> = samples
        .get(from)
        .unwrap_or_default()
        .iter()
        .filter(|sample| sample.left_out.is_none())
        .map(|sample| sample.values.as_slice())
        .collect();
    if counted.len() < 2 {
        return Err(Reason::TooFew { found: counted.len(), needed: 2 });
    }
    let values = counted.concat();
    let sigma = match (plan.kind, plan.method) {
        // All values are one sample.
        (ChartKind::Individuals, Method::Deviations) => Sigma::within([values.as_slice()], plan.method)?,
        (_, method) => Sigma::within(counted.iter().copied(), method)?,
    };
    // A subgroup of one value says nothing of the spread.
    let says = |group: &&&[f64]| plan.kind == ChartKind::Individuals || 1 < group.len();
    let baseline = counted.iter().filter(says).count();
    Ok(StageFigures { points, mean: Moments::of(&values)?.mean, sigma, baseline })
}

/// The points of a stage.
fn draw(samples: &[Sample], of: &StageFigures, plan: &ChartPlan, into: &mut Vec<ChartPoint>) -> Result<(), Reason> {
    let mut scanner = Scanner::default();
    let mut before = None;
    for sample in samples {
        let counts = sample.left_out.is_none();
        let moments = Moments::of(&sample.values)?;
        let error = of.sigma.value / count(moments.count).sqrt();
        let mut location = Point {
            value: moments.mean,
            lower: of.mean - 3.0 * error,
            centre: of.mean,
            upper: of.mean + 3.0 * error,
            fired: Rules::NONE,
        };
        if counts {
            let fired = scanner.next(location.value, (location.value - of.mean) / error);
            location.fired = plan.rules.both(fired);
        }
        let range = before.filter(|_| counts).map(|before: f64| (moments.mean - before).abs());
        let mut spread = spread(plan.kind, &moments, range, of.sigma.value)?;
        if let Some(point) = spread.as_mut().filter(|_| counts) {
            let is_out = point.upper < point.value || point.value < point.lower;
            point.fired = plan.rules.both(Rules::NONE.with(Rule::BeyondLimits, is_out));
        }
        if counts {
            before = Some(moments.mean);
        }
        into.push(ChartPoint { location, spread, left_out: sample.left_out.clone() });
    }
    Ok(())
}

/// The spread of a sample with its limits; `range` is the moving range.
fn spread(kind: ChartKind, of: &Moments, range: Option<f64>, sigma: f64) -> Result<Option<Point>, Reason> {
    let (value, mean, deviation) = match kind {
        ChartKind::Individuals => match range {
            Some(range) => (range, d2(2)?, d3(2)?),
            None => return Ok(None),
        },
        _ if of.count < 2 => return Ok(None),
        ChartKind::MeansRanges => (of.range(), d2(of.count)?, d3(of.count)?),
        ChartKind::MeansDeviations => {
            let c4 = c4(of.count)?;
            ((of.squares / of.degrees()).sqrt(), c4, (1.0 - c4 * c4).sqrt())
        }
    };
    Ok(Some(Point {
        value,
        lower: (mean - 3.0 * deviation).max(0.0) * sigma,
        centre: mean * sigma,
        upper: (mean + 3.0 * deviation) * sigma,
        fired: Rules::NONE,
    }))
}
