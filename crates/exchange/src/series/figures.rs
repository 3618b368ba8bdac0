//! What is computed of a series: each figure with its interval and its method, or why there is none.

use super::Series;
use fitcheck_core::message::Say as _;
use fitcheck_statistics::{
    Advice, Baseline, CapabilityPlan, Chart, ChartKind, ChartPlan, ENOUGH_POINTS, ENOUGH_VALUES, Estimate, Family,
    Fitted, Indices, Method, Moments, Reason, Rule, Rules, Sample, Sigma, Stage, Tolerance, anderson_darling,
    capability, chart, offset, percentiles, trend,
};

/// What is asked of a series.
#[derive(Debug, Clone, Copy)]
pub struct Wanted {
    pub limits: [Option<f64>; 2],
    pub target: Option<f64>,
    pub chart: Option<ChartKind>,
    pub rules: Rules,
    pub baseline: Option<usize>,
    pub law: Option<Family>,
    pub level: f64,
}

/// How a figure is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FigureKind {
    /// Millimetres.
    Length,
    /// An index, a statistic, a distance in s.
    Index,
    /// Parts in a million.
    Ppm,
    /// A probability.
    Probability,
}

/// A figure.
#[derive(Debug)]
pub struct Figure {
    /// Its name for machines.
    pub name: &'static str,
    /// Its name for people.
    pub label: &'static str,
    pub kind: FigureKind,
    /// The figure, with an interval where it is estimated; or why there is none.
    pub value: Result<(f64, Option<[f64; 2]>), Reason>,
    pub method: String,
}

/// All that is said of a series.
#[derive(Debug)]
pub struct Answer {
    pub wanted: Wanted,
    pub figures: Vec<Figure>,
    /// How many values are below the lower and above the upper limit.
    pub outside: [usize; 2],
    /// The chart, or why there is none.
    pub chart: Result<Chart, Reason>,
    /// The law that fits the values best, of the family that is asked for; or why there is none.
    pub fitted: Result<Fitted, Reason>,
    /// The rules that fire, each with its points, from 1.
    pub fired: Vec<(Rule, Vec<usize>)>,
    pub advice: Vec<Advice>,
}

/// A step of a tool's offset, in millimetres.
const STEP: f64 = 0.001;

/// How near to a limit a trend may come, in standard deviations.
const RESERVE: f64 = 3.0;

impl Answer {
    pub fn of(series: &Series<'_>, wanted: &Wanted) -> Self {
        let values = series.groups.concat();
        let largest = series.groups.iter().map(Vec::len).max().unwrap_or_default();
        let kind = wanted.chart.unwrap_or(ChartKind::for_size(largest));
        let mut answer = Self {
            wanted: *wanted,
            figures: Vec::new(),
            outside: [0, 0],
            chart: drawn(series, kind, wanted),
            fitted: Fitted::of(&values, wanted.law.unwrap_or(Family::Normal)),
            fired: Vec::new(),
            advice: Vec::new(),
        };
        let tolerance = Tolerance::new(wanted.limits[0], wanted.limits[1]);
        answer.moments(series, &values, kind.method());
        match tolerance.clone() {
            Ok(tolerance) => answer.capability(series, &values, &tolerance, kind),
            Err(reason) => answer.put("cpk", "Cpk", FigureKind::Index, Err(reason), String::new()),
        }
        answer.shape(&values, tolerance.as_ref().ok());
        answer.lines(kind);
        answer.advise(&values, tolerance.as_ref().ok());
        answer
    }

    /// Whether nothing could be computed.
    pub fn is_empty(&self) -> bool {
        self.figures.iter().all(|figure| figure.value.is_err())
    }

    fn put(
        &mut self,
        name: &'static str,
        label: &'static str,
        kind: FigureKind,
        value: Result<(f64, Option<[f64; 2]>), Reason>,
        method: String,
    ) {
        self.figures.push(Figure { name, label, kind, value, method });
    }

    fn estimate(&mut self, name: &'static str, label: &'static str, kind: FigureKind, value: Estimate, method: &str) {
        self.put(name, label, kind, Ok((value.value, Some([value.lower, value.upper]))), method.to_owned());
    }

    fn moments(&mut self, series: &Series<'_>, values: &[f64], method: Method) {
        let level = self.wanted.level;
        let moments = Moments::of(values);
        let whole = |value: Estimate| (value.value, Some([value.lower, value.upper]));
        // A mean without an interval would be a bare figure: the reason stands in its place.
        let mean = moments.clone().and_then(|of| of.mean_estimate(level)).map(whole);
        let deviation = moments.and_then(|of| of.deviation_estimate(level)).map(whole);
        self.put("mean_mm", "mean", FigureKind::Length, mean, "mean, Student".to_owned());
        self.put("sd_mm", "s", FigureKind::Length, deviation, "standard deviation, chi-square".to_owned());
        let within = Sigma::within(series.groups.iter().map(Vec::as_slice), method);
        let within = within.map(|sigma| whole(Estimate::of_deviation(sigma.value, sigma.degrees, level)));
        self.put("sigma_mm", "s within", FigureKind::Length, within, method.word().to_owned());
    }

    fn capability(&mut self, series: &Series<'_>, values: &[f64], tolerance: &Tolerance, kind: ChartKind) {
        let Wanted { target, level, .. } = self.wanted;
        let plan = CapabilityPlan { target, level, ..CapabilityPlan::of(*tolerance, kind.method()) };
        self.outside = tolerance.outside(values);
        let found = match capability(series.groups.iter().map(Vec::as_slice), &plan) {
            Ok(found) => found,
            Err(reason) => return self.put("cpk", "Cpk", FigureKind::Index, Err(reason), String::new()),
        };
        match &found.within {
            Ok(inside) => {
                let method = inside.sigma.method.word();
                self.indices(["cp", "cpk"], ["Cp", "Cpk"], inside, method);
                self.estimate("ppm_within", "ppm, within", FigureKind::Ppm, inside.ppm, method);
            }
            Err(reason) => {
                self.put("cpk", "Cpk", FigureKind::Index, Err(reason.clone()), kind.method().word().to_owned())
            }
        }
        let overall = &found.overall;
        let method = overall.sigma.method.word();
        self.indices(["pp", "ppk"], ["Pp", "Ppk"], overall, method);
        if let Some(cpm) = overall.about_target {
            self.estimate("cpm", "Cpm", FigureKind::Index, cpm, "about the target, Boyles");
        }
        self.estimate("ppm_overall", "ppm, overall", FigureKind::Ppm, overall.ppm, method);
        for (side, name, label) in [
            (overall.lower, "lower_distance_s", "lower limit at s"),
            (overall.upper, "upper_distance_s", "upper limit at s"),
        ] {
            if let Some(side) = side {
                self.estimate(name, label, FigureKind::Index, side.distance, method);
            }
        }
    }

    fn indices(&mut self, names: [&'static str; 2], labels: [&'static str; 2], of: &Indices, method: &str) {
        if let Some(potential) = of.potential {
            self.estimate(names[0], labels[0], FigureKind::Index, potential, method);
        }
        self.estimate(names[1], labels[1], FigureKind::Index, of.actual, method);
    }

    /// The test of the law, and capability by its percentiles where one is asked for.
    fn shape(&mut self, values: &[f64], tolerance: Option<&Tolerance>) {
        let Wanted { law, level, .. } = self.wanted;
        let family = law.unwrap_or(Family::Normal);
        let test = self.fitted.clone().and_then(|fitted| anderson_darling(values, &fitted));
        let method = format!("Anderson-Darling, {}", family.word());
        match test {
            Ok(test) => {
                self.put("anderson_darling", "A²", FigureKind::Index, Ok((test.statistic, None)), method.clone());
                if let Some(p) = test.p {
                    self.put("anderson_darling_p", "p of A²", FigureKind::Probability, Ok((p, None)), method);
                    if p < 1.0 - level {
                        self.advice.push(Advice::NotOfLaw { p: fitcheck_statistics::probability(p) });
                    }
                }
            }
            Err(reason) => self.put("anderson_darling", "A²", FigureKind::Index, Err(reason), method),
        }
        let (Some(family), Some(tolerance)) = (law, tolerance) else { return };
        let method = format!("percentiles, {}", family.word());
        let found = match percentiles(values, family, tolerance, level) {
            Ok(found) => found,
            Err(reason) => return self.put("ppk_percentile", "Ppk", FigureKind::Index, Err(reason), method),
        };
        if let Some(potential) = found.potential {
            self.estimate("pp_percentile", "Pp", FigureKind::Index, potential, &method);
        }
        self.estimate("ppk_percentile", "Ppk", FigureKind::Index, found.actual, &method);
        for (ppm, name, label) in [(found.below, "ppm_below", "ppm below"), (found.above, "ppm_above", "ppm above")] {
            if let Some(ppm) = ppm {
                self.estimate(name, label, FigureKind::Ppm, ppm, &method);
            }
        }
    }

    /// Centre line and limits of the chart, and the rules that fire on it.
    fn lines(&mut self, kind: ChartKind) {
        match self.chart.clone() {
            Ok(drawn) => self.drawn(&drawn),
            Err(reason) => {
                self.put("centre_mm", "centre line", FigureKind::Length, Err(reason), kind.word().to_owned())
            }
        }
    }

    fn drawn(&mut self, drawn: &Chart) {
        let method = drawn.kind.word();
        // Of points of several sizes the last one has the limits that count now.
        let last = drawn.points.last();
        let spread = drawn.points.iter().rev().find_map(|point| point.spread);
        let lines = [
            ("centre_mm", "centre line", last.map(|point| point.location.centre)),
            ("lower_control_mm", "lower control limit", last.map(|point| point.location.lower)),
            ("upper_control_mm", "upper control limit", last.map(|point| point.location.upper)),
            ("spread_centre_mm", "centre line, spread", spread.map(|spread| spread.centre)),
            ("spread_upper_mm", "upper control limit, spread", spread.map(|spread| spread.upper)),
        ];
        for (name, label, value) in lines {
            if let Some(value) = value {
                self.put(name, label, FigureKind::Length, Ok((value, None)), method.to_owned());
            }
        }
        let fires = |point: &fitcheck_statistics::ChartPoint, rule| {
            point.location.fired.has(rule) || point.spread.is_some_and(|spread| spread.fired.has(rule))
        };
        for rule in Rule::ALL {
            let points = (1..).zip(&drawn.points).filter(|(_, point)| fires(point, rule));
            let points: Vec<usize> = points.map(|(number, _)| number).collect();
            if !points.is_empty() {
                self.fired.push((rule, points));
            }
        }
        let count: usize = drawn.stages.iter().map(|stage| stage.baseline).sum();
        if count < ENOUGH_POINTS {
            self.advice.push(Advice::FewPoints { count, enough: ENOUGH_POINTS });
        }
        let alarms = drawn.points.iter().filter(|point| Rule::ALL.into_iter().any(|rule| fires(point, rule))).count();
        if 0 < alarms {
            self.advice.push(Advice::Unstable { count: alarms });
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

    /// The sentences, in English.
    pub fn sentences(&self) -> impl Iterator<Item = String> {
        self.advice.iter().map(|advice| advice.message().to_string())
    }
}

fn drawn(series: &Series<'_>, kind: ChartKind, wanted: &Wanted) -> Result<Chart, Reason> {
    let Wanted { rules, baseline, .. } = *wanted;
    let single = |sample: Sample| {
        let Sample { values, left_out } = sample;
        values.into_iter().map(move |value| Sample { values: vec![value], left_out: left_out.clone() })
    };
    let samples: Vec<Sample> = match kind {
        ChartKind::Individuals => series.samples().into_iter().flat_map(single).collect(),
        ChartKind::MeansRanges | ChartKind::MeansDeviations => series.samples(),
    };
    let baseline = baseline.map_or(Baseline::All, |count| Baseline::Points(0..count));
    let plan = ChartPlan { rules, stages: vec![Stage { first: 0, baseline }], ..ChartPlan::of(kind) };
    chart(&samples, &plan)
}
