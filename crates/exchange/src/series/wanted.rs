//! What is asked of a series.

use std::ops::Range;
use std::sync::Arc;

use fitcheck_statistics::{Baseline, ChartKind, Cusum, Ewma, Family, Rules, Sample, Stage};

use super::{Series, SeriesError};

/// A chart that remembers, beside the chart of points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Memory {
    Ewma(Ewma),
    Cusum(Cusum),
}

impl Memory {
    /// The first figure of each kind; it has the reason where there is no chart.
    pub(super) const FIRST_FIGURES: [&str; 2] = ["ewma_mm", "cusum_above_mm"];

    /// What it is, with its parameters.
    pub fn method(self) -> String {
        match self {
            Self::Ewma(Ewma { weight, width }) => format!("EWMA, lambda {weight}, L {width}"),
            Self::Cusum(Cusum { allowance, interval }) => format!("CUSUM, k {allowance}, h {interval}"),
        }
    }
}

/// What is asked of a series.
#[derive(Debug, Clone)]
pub struct Wanted {
    pub limits: [Option<f64>; 2],
    pub target: Option<f64>,
    pub chart: Option<ChartKind>,
    pub memory: Option<Memory>,
    pub rules: Rules,
    /// So many first points of each stage have its limits.
    pub baseline: Option<usize>,
    /// Points, from 0, that the limits of their stage come from, as far as they are in it. Other stages have limits of all their points.
    pub frozen: Option<Range<usize>>,
    /// Mean and standard deviation of single values from an earlier study, for all stages.
    pub known: Option<[f64; 2]>,
    /// The first points of further stages, from 1.
    pub stages: Vec<usize>,
    /// Points that are left out, from 1, each with its reason.
    pub left_out: Vec<(usize, Arc<str>)>,
    pub law: Option<Family>,
    pub level: f64,
}

impl Default for Wanted {
    fn default() -> Self {
        Self {
            limits: [None, None],
            target: None,
            chart: None,
            memory: None,
            rules: Rules::NELSON,
            baseline: None,
            frozen: None,
            known: None,
            stages: Vec::new(),
            left_out: Vec::new(),
            law: None,
            level: 0.95,
        }
    }
}

impl Wanted {
    /// The chart of points for these subgroups.
    pub fn kind(&self, series: &Series<'_>) -> ChartKind {
        let largest = series.groups.iter().map(Vec::len).max().unwrap_or_default();
        self.chart.unwrap_or(ChartKind::for_size(largest))
    }

    /// Refuses points that the series does not have.
    pub fn checked(&self, series: &Series<'_>) -> Result<(), SeriesError> {
        let count = self.points_of(series);
        let named = self.left_out.iter().map(|(point, _)| point).chain(&self.stages).copied();
        named
            .filter(|point| !(1..=count).contains(point))
            .map(|point| Err(SeriesError::NoPoint { point, count }))
            .next()
            .unwrap_or(Ok(()))
    }

    /// How many points the chart has.
    fn points_of(&self, series: &Series<'_>) -> usize {
        if self.kind(series) == ChartKind::Individuals { series.count() } else { series.groups.len() }
    }

    /// The points of the chart.
    pub(super) fn samples(&self, series: &Series<'_>) -> Vec<Sample> {
        let mut samples: Vec<Sample> = match self.kind(series) {
            ChartKind::Individuals => series.groups.iter().flatten().map(|value| Sample::of(vec![*value])).collect(),
            ChartKind::MeansRanges | ChartKind::MeansDeviations => {
                series.groups.iter().cloned().map(Sample::of).collect()
            }
        };
        for (point, reason) in &self.left_out {
            if let Some(sample) = point.checked_sub(1).and_then(|at| samples.get_mut(at)) {
                sample.left_out = Some(Arc::clone(reason));
            }
        }
        samples
    }

    /// The stages of the chart.
    pub(super) fn stages(&self) -> Vec<Stage> {
        let mut first: Vec<usize> =
            [0].into_iter().chain(self.stages.iter().filter_map(|point| point.checked_sub(1))).collect();
        first.sort_unstable();
        first.dedup();
        let ends: Vec<usize> = first.iter().skip(1).copied().chain([usize::MAX]).collect();
        let baseline = |first: usize, end: usize| match (self.known, self.baseline, &self.frozen) {
            (Some([mean, sigma]), ..) => Baseline::Known { mean, sigma },
            (None, Some(count), _) => Baseline::Points(first..first.saturating_add(count)),
            (None, None, Some(frozen)) if (first..end).contains(&frozen.start) => {
                Baseline::Points(frozen.start..frozen.end.min(end))
            }
            (None, None, _) => Baseline::All,
        };
        first.into_iter().zip(ends).map(|(first, end)| Stage { first, baseline: baseline(first, end) }).collect()
    }
}
