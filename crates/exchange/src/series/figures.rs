//! What is computed of a series: each figure with its interval and its method, or why there is none.

use super::Series;
use super::charted::{Charted, Remembered};
use super::figure::{Figure, FigureKind, FigureMethod};
use super::layout::Layout;
use super::wanted::{Memory, Wanted};
use fitcheck_core::message::Say as _;
use fitcheck_statistics::gauge::Finding;
use fitcheck_statistics::{
    Advice, CapabilityPlan, Chart, ChartKind, ENOUGH_VALUES, Estimate, Family, Fitted, Indices, Method, Moments,
    Reason, Rule, Sigma, Tolerance, anderson_darling, capability, offset, percentiles, trend,
};

/// A group of a comparison, or a master of a study, with its figure.
#[derive(Debug)]
pub struct Group {
    pub name: String,
    pub count: usize,
    pub figure: Figure,
}

/// All that is said of a series.
#[derive(Debug)]
pub struct Answer {
    pub wanted: Wanted,
    /// How a study was understood.
    pub layout: Option<Layout>,
    /// Why the layout looks wrong, where it is not confirmed: nothing is computed then.
    pub doubt: Option<Finding>,
    pub figures: Vec<Figure>,
    /// The groups of a comparison, the masters of a linearity study.
    pub groups: Vec<Group>,
    /// How many values are below the lower and above the upper limit.
    pub outside: [usize; 2],
    /// The chart, or why there is none.
    pub chart: Result<Chart, Reason>,
    /// The law that fits the values best, of the family that is asked for; or why there is none.
    pub fitted: Result<Fitted, Reason>,
    pub memory: Option<Remembered>,
    /// The rules that fire, each with its points, from 1.
    pub fired: Vec<(Rule, Vec<usize>)>,
    pub advice: Vec<Advice>,
    /// What a study gives an uncertainty budget.
    pub contributions: Vec<Contribution>,
}

/// A contribution of type A to an uncertainty budget.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contribution {
    pub name: &'static str,
    /// Its standard uncertainty in millimetres.
    pub standard: f64,
    pub degrees: f64,
}

/// A step of a tool's offset, in millimetres.
const STEP: f64 = 0.001;

/// How near to a limit a trend may come, in standard deviations.
const RESERVE: f64 = 3.0;

const CPK: [&str; 2] = ["cpk", "Cpk"];

impl Answer {
    /// The figures of a series: with several stages those of the last one, as the process is now.
    pub fn of(series: &Series<'_>, wanted: &Wanted) -> Self {
        let mut answer = Self::begun(wanted);
        let tolerance = Tolerance::new(wanted.limits[0], wanted.limits[1]);
        let kind = wanted.kind(series);
        let samples = wanted.samples(series);
        let now = wanted.stages().last().map_or(0, |stage| stage.first);
        let counted = samples.iter().skip(now).filter(|sample| sample.left_out.is_none());
        let groups: Vec<&[f64]> = counted.map(|sample| sample.values.as_slice()).collect();
        let values = groups.concat();
        answer.fitted = Fitted::of(&values, wanted.law.unwrap_or(Family::Normal));
        answer.moments(&groups, &values, kind.method());
        match &tolerance {
            Ok(tolerance) => answer.capability(&groups, &values, tolerance, kind),
            Err(reason) => answer.figures.push(Figure::none(CPK, FigureKind::Index, reason.clone(), "")),
        }
        answer.shape(&values, tolerance.as_ref().ok());
        answer.take(Charted::of(&samples, kind, wanted));
        answer.advise(&values, tolerance.as_ref().ok());
        answer
    }

    /// An answer that says nothing yet.
    pub(super) fn begun(wanted: &Wanted) -> Self {
        Self {
            wanted: wanted.clone(),
            layout: None,
            doubt: None,
            figures: Vec::new(),
            groups: Vec::new(),
            outside: [0, 0],
            chart: Err(Reason::Empty),
            fitted: Err(Reason::Empty),
            memory: None,
            fired: Vec::new(),
            advice: Vec::new(),
            contributions: Vec::new(),
        }
    }

    /// The same figures without a chart, for this reason.
    pub(super) fn without_chart(mut self, reason: Reason) -> Self {
        if let Ok(of_chart) = self.chart.as_ref().map(|chart| FigureMethod::from(chart.kind.word())) {
            self.figures.retain(|figure| figure.method != of_chart);
            self.advice.retain(|advice| !matches!(advice, Advice::FewPoints { .. } | Advice::Unstable { .. }));
        }
        Self { chart: Err(reason), memory: None, fired: Vec::new(), ..self }
    }

    /// Takes what a chart says.
    pub(super) fn take(&mut self, charted: Charted) {
        let Charted { chart, memory, figures, fired, advice } = charted;
        self.chart = chart;
        self.memory = memory;
        self.figures.extend(figures);
        self.fired = fired;
        self.advice.extend(advice);
    }

    /// Whether nothing could be computed.
    pub fn is_empty(&self) -> bool {
        self.figures.iter().all(|figure| figure.value.is_err())
    }

    /// The figure of this name.
    pub fn figure(&self, name: &str) -> Option<&Figure> {
        self.figures.iter().find(|figure| figure.name == name)
    }

    pub(super) fn put(
        &mut self,
        name: [&'static str; 2],
        kind: FigureKind,
        value: Result<Estimate, Reason>,
        method: impl Into<FigureMethod>,
    ) {
        self.figures.push(Figure::of(name, kind, value, method));
    }

    pub(super) fn bare(
        &mut self,
        name: [&'static str; 2],
        kind: FigureKind,
        value: f64,
        method: impl Into<FigureMethod>,
    ) {
        self.figures.push(Figure::bare(name, kind, value, method));
    }

    fn moments(&mut self, groups: &[&[f64]], values: &[f64], method: Method) {
        let level = self.wanted.level;
        let moments = Moments::of(values);
        // A mean without an interval would be a bare figure: the reason stands in its place.
        let mean = moments.clone().and_then(|of| of.mean_estimate(level));
        let deviation = moments.and_then(|of| of.deviation_estimate(level));
        self.put(["mean_mm", "mean"], FigureKind::Length, mean, "mean, Student");
        self.put(["sd_mm", "s"], FigureKind::Length, deviation, "standard deviation, chi-square");
        let within = Sigma::within(groups.iter().copied(), method);
        let within = within.map(|sigma| Estimate::of_deviation(sigma.value, sigma.degrees, level));
        self.put(["sigma_mm", "s within"], FigureKind::Length, within, method.word());
    }

    fn capability(&mut self, groups: &[&[f64]], values: &[f64], tolerance: &Tolerance, kind: ChartKind) {
        let Wanted { target, level, .. } = self.wanted;
        let plan = CapabilityPlan { target, level, ..CapabilityPlan::of(*tolerance, kind.method()) };
        self.outside = tolerance.outside(values);
        let found = match capability(groups.iter().copied(), &plan) {
            Ok(found) => found,
            Err(reason) => return self.figures.push(Figure::none(CPK, FigureKind::Index, reason, "")),
        };
        match &found.within {
            Ok(inside) => {
                let method = inside.sigma.method.word();
                self.indices([["cp", "Cp"], CPK], inside, method);
                self.put(["ppm_within", "ppm, within"], FigureKind::Ppm, Ok(inside.ppm), method);
            }
            Err(reason) => {
                let method = kind.method().word();
                self.figures.push(Figure::none(CPK, FigureKind::Index, reason.clone(), method));
            }
        }
        let overall = &found.overall;
        let method = overall.sigma.method.word();
        self.indices([["pp", "Pp"], ["ppk", "Ppk"]], overall, method);
        if let Some(cpm) = overall.about_target {
            self.put(["cpm", "Cpm"], FigureKind::Index, Ok(cpm), "about the target, Boyles");
        }
        self.put(["ppm_overall", "ppm, overall"], FigureKind::Ppm, Ok(overall.ppm), method);
        for (side, name) in [
            (overall.lower, ["lower_distance_s", "lower limit at s"]),
            (overall.upper, ["upper_distance_s", "upper limit at s"]),
        ] {
            if let Some(side) = side {
                self.put(name, FigureKind::Index, Ok(side.distance), method);
            }
        }
    }

    fn indices(&mut self, names: [[&'static str; 2]; 2], of: &Indices, method: &str) {
        if let Some(potential) = of.potential {
            self.put(names[0], FigureKind::Index, Ok(potential), method);
        }
        self.put(names[1], FigureKind::Index, Ok(of.actual), method);
    }

    /// The test of the law, and capability by its percentiles where one is asked for.
    fn shape(&mut self, values: &[f64], tolerance: Option<&Tolerance>) {
        let Wanted { law, level, .. } = self.wanted;
        let family = law.unwrap_or(Family::Normal);
        let test = self.fitted.clone().and_then(|fitted| anderson_darling(values, &fitted));
        let method = format!("Anderson-Darling, {}", family.word());
        let name = ["anderson_darling", "A²"];
        match test {
            Ok(test) => {
                self.bare(name, FigureKind::Index, test.statistic, method.clone());
                if let Some(p) = test.p {
                    self.bare(["anderson_darling_p", "p of A²"], FigureKind::Probability, p, method);
                    if p < 1.0 - level {
                        self.advice.push(Advice::NotOfLaw { p: fitcheck_statistics::probability(p) });
                    }
                }
            }
            Err(reason) => self.figures.push(Figure::none(name, FigureKind::Index, reason, method)),
        }
        let (Some(family), Some(tolerance)) = (law, tolerance) else { return };
        let method = format!("percentiles, {}", family.word());
        let ppk = ["ppk_percentile", "Ppk"];
        let found = match percentiles(values, family, tolerance, level) {
            Ok(found) => found,
            Err(reason) => return self.figures.push(Figure::none(ppk, FigureKind::Index, reason, method)),
        };
        if let Some(potential) = found.potential {
            self.put(["pp_percentile", "Pp"], FigureKind::Index, Ok(potential), method.clone());
        }
        self.put(ppk, FigureKind::Index, Ok(found.actual), method.clone());
        for (ppm, name) in [(found.below, ["ppm_below", "ppm below"]), (found.above, ["ppm_above", "ppm above"])] {
            if let Some(ppm) = ppm {
                self.put(name, FigureKind::Ppm, Ok(ppm), method.clone());
            }
        }
    }

    fn advise(&mut self, values: &[f64], tolerance: Option<&Tolerance>) {
        let level = self.wanted.level;
        if (2..ENOUGH_VALUES).contains(&values.len()) {
            self.advice.push(Advice::FewValues { count: values.len(), enough: ENOUGH_VALUES });
        }
        if let Ok(trend) = trend(values, tolerance, RESERVE, level) {
            self.advice.push(Advice::of_trend(&trend, level));
        }
        let middle = self.wanted.target.or_else(|| tolerance.and_then(|tolerance| tolerance.middle().ok()));
        if let Some(found) = middle.and_then(|middle| offset(values, middle, STEP, level).ok()) {
            self.advice.push(Advice::of_offset(&found));
        }
    }

    /// The chart that remembers, or why there is none.
    pub(super) fn remembered(&self) -> Result<&Remembered, Reason> {
        let why = |name: &str| self.figure(name)?.value.clone().err();
        let lacks = || Memory::FIRST_FIGURES.into_iter().find_map(why).unwrap_or(Reason::Empty);
        self.memory.as_ref().ok_or_else(lacks)
    }

    /// The sentences, in English.
    pub fn sentences(&self) -> impl Iterator<Item = String> {
        self.advice.iter().map(|advice| advice.message().to_string())
    }
}
