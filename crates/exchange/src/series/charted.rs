//! The chart of a series: its limits, the rules that fire, and the averages or sums that remember.

use fitcheck_statistics::{
    Advice, Chart, ChartKind, ChartPlan, ChartPoint, ENOUGH_POINTS, MemoryPoint, Reason, Rule, Sample, chart, count,
};

use super::figure::{Figure, FigureKind};
use super::wanted::{Memory, Wanted};

/// A chart that remembers. Every stage begins anew.
#[derive(Debug, Clone)]
pub struct Remembered {
    pub memory: Memory,
    /// The points that count, each with its number from 1.
    pub points: Vec<(usize, MemoryPoint)>,
}

impl Remembered {
    /// The numbers of the points beyond their limits.
    pub fn out(&self) -> impl Iterator<Item = usize> {
        self.points.iter().filter(|(_, point)| point.is_out()).map(|(number, _)| *number)
    }
}

/// What a chart says.
#[derive(Debug)]
pub(super) struct Charted {
    pub(super) chart: Result<Chart, Reason>,
    pub(super) memory: Option<Remembered>,
    pub(super) figures: Vec<Figure>,
    pub(super) fired: Vec<(Rule, Vec<usize>)>,
    pub(super) advice: Vec<Advice>,
}

/// The chart of points.
pub(super) fn plan(wanted: &Wanted, kind: ChartKind) -> ChartPlan {
    ChartPlan { rules: wanted.rules, stages: wanted.stages(), ..ChartPlan::of(kind) }
}

impl Charted {
    pub(super) fn of(samples: &[Sample], kind: ChartKind, wanted: &Wanted) -> Self {
        match chart(samples, &plan(wanted, kind)) {
            Ok(drawn) => Self::drawn(drawn, samples, wanted),
            Err(reason) => {
                let none = Figure::none(["centre_mm", "centre line"], FigureKind::Length, reason.clone(), kind.word());
                Self { figures: vec![none], ..Self::of_chart(Err(reason)) }
            }
        }
    }

    const fn of_chart(chart: Result<Chart, Reason>) -> Self {
        Self { chart, memory: None, figures: Vec::new(), fired: Vec::new(), advice: Vec::new() }
    }

    /// What a computed chart says.
    pub(super) fn drawn(drawn: Chart, samples: &[Sample], wanted: &Wanted) -> Self {
        let mut charted = Self::of_chart(Err(Reason::Empty));
        charted.limits(&drawn);
        charted.rules(&drawn);
        if let Some(memory) = wanted.memory {
            charted.remember(&drawn, samples, memory);
        }
        charted.chart = Ok(drawn);
        charted
    }

    /// Of points of several sizes or stages the last one has the limits that count now.
    fn limits(&mut self, drawn: &Chart) {
        let last = drawn.points.last();
        let spread = drawn.points.iter().rev().find_map(|point| point.spread);
        let lines = [
            (["centre_mm", "centre line"], last.map(|point| point.location.centre)),
            (["lower_control_mm", "lower control limit"], last.map(|point| point.location.lower)),
            (["upper_control_mm", "upper control limit"], last.map(|point| point.location.upper)),
            (["spread_centre_mm", "centre line, spread"], spread.map(|spread| spread.centre)),
            (["spread_upper_mm", "upper control limit, spread"], spread.map(|spread| spread.upper)),
        ];
        for (name, value) in lines {
            let figure = |value| Figure::bare(name, FigureKind::Length, value, drawn.kind.word());
            self.figures.extend(value.map(figure));
        }
    }

    fn rules(&mut self, drawn: &Chart) {
        let fires = |point: &ChartPoint, rule| {
            point.location.fired.has(rule) || point.spread.is_some_and(|spread| spread.fired.has(rule))
        };
        for rule in Rule::ALL {
            let points = (1..).zip(&drawn.points).filter(|(_, point)| fires(point, rule));
            let points: Vec<usize> = points.map(|(number, _)| number).collect();
            if !points.is_empty() {
                self.fired.push((rule, points));
            }
        }
        // A stage whose limits were given has no baseline.
        let few = drawn.stages.last().map(|stage| stage.baseline).filter(|count| (1..ENOUGH_POINTS).contains(count));
        self.advice.extend(few.map(|count| Advice::FewPoints { count, enough: ENOUGH_POINTS }));
        let alarms = drawn.points.iter().filter(|point| Rule::ALL.into_iter().any(|rule| fires(point, rule))).count();
        if 0 < alarms {
            self.advice.push(Advice::Unstable { count: alarms });
        }
    }

    fn remember(&mut self, drawn: &Chart, samples: &[Sample], memory: Memory) {
        let method = memory.method();
        let found = match remembered(drawn, samples, memory) {
            Ok(found) => found,
            Err(reason) => {
                let name = match memory {
                    Memory::Ewma(_) => ["ewma_mm", "average"],
                    Memory::Cusum(_) => ["cusum_above_mm", "sum above"],
                };
                return self.figures.push(Figure::none(name, FigureKind::Length, reason, method));
            }
        };
        let lines = match found.points.last() {
            Some((_, MemoryPoint::Average(point))) => [
                (["ewma_mm", "average"], point.value),
                (["ewma_lower_mm", "lower limit of the average"], point.lower),
                (["ewma_upper_mm", "upper limit of the average"], point.upper),
            ],
            Some((_, MemoryPoint::Sums(point))) => [
                (["cusum_above_mm", "sum above"], point.above),
                (["cusum_below_mm", "sum below"], point.below),
                (["cusum_interval_mm", "decision interval"], point.interval),
            ],
            None => return,
        };
        self.figures.extend(lines.map(|(name, value)| Figure::bare(name, FigureKind::Length, value, method.clone())));
        let out = found.points.iter().enumerate().find(|(_, (_, point))| point.is_out());
        self.advice.extend(out.map(|(place, (at, point))| match point {
            MemoryPoint::Average(_) => Advice::AverageOut { at: *at },
            // The sum began at the point that has 1 in it; points that are left out do not count.
            MemoryPoint::Sums(sums) => {
                let first = found.points.get((place + 1).saturating_sub(sums.since));
                Advice::SumOut { at: *at, since: first.map_or(*at, |(number, _)| *number) }
            }
        }));
        self.memory = Some(found);
    }
}

/// The averages or sums of the points that count, in each stage about its mean.
fn remembered(drawn: &Chart, samples: &[Sample], memory: Memory) -> Result<Remembered, Reason> {
    let sizes = || samples.iter().filter(|sample| sample.left_out.is_none()).map(|sample| sample.values.len());
    let (least, most) = (sizes().min().unwrap_or(1), sizes().max().unwrap_or(1));
    if least < most {
        return Err(Reason::UnequalSubgroups { least, most });
    }
    let mut points = Vec::with_capacity(drawn.points.len());
    for stage in &drawn.stages {
        let within = (1..).zip(&drawn.points).take(stage.points.end).skip(stage.points.start);
        let counted = within.filter(|(_, point)| point.left_out.is_none());
        let (numbers, values): (Vec<usize>, Vec<f64>) =
            counted.map(|(number, point)| (number, point.location.value)).unzip();
        if values.is_empty() {
            continue;
        }
        let sigma = stage.sigma.value / count(most).sqrt();
        let found: Vec<MemoryPoint> = match memory {
            Memory::Ewma(ewma) => {
                ewma.points(&values, stage.mean, sigma)?.into_iter().map(MemoryPoint::Average).collect()
            }
            Memory::Cusum(cusum) => {
                cusum.points(&values, stage.mean, sigma)?.into_iter().map(MemoryPoint::Sums).collect()
            }
        };
        points.extend(numbers.into_iter().zip(found));
    }
    Ok(Remembered { memory, points })
}
