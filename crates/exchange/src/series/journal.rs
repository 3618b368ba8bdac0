//! Series of a journal: checks become values, one series for each feature; and what is computed of one.
//!
//! A feature is what has the same part, name, callout and limits: where a drawing changes, a new series begins.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::message;
use fitcheck_core::words::Words;
use fitcheck_statistics::{ChartKind, Reason, Rules, Sample, Signal, signals};

use super::{Answer, Grouping, LeftOut, Memory, Series, Value, Wanted};
use crate::journal::Record;
use crate::journal::entry::{Checked, Entry};
use crate::journal::natural::Natural;

/// So many entries of a journal are read at most, the newest of them.
pub const MOST_READ: usize = 100_000;

/// The index that is usually asked for.
pub const ASKED_INDEX: f64 = 1.33;

/// The level of all intervals.
const LEVEL: f64 = 0.95;

/// What makes a feature.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub struct FeatureKey {
    /// The part; empty where nobody said.
    pub part: Natural,
    /// The feature; empty where the part has one only.
    pub name: Natural,
    /// What was asked for, as it is written, or the limits where there is no callout; empty where there are none.
    pub callout: String,
    /// The nominal size; `None` where only limits are known.
    pub nominal: Option<Length>,
    /// Lower and upper limit.
    pub limits: [Option<Length>; 2],
}

impl FeatureKey {
    /// Its name and what was asked for: `Flange, B1, 25 H7`; a feature of a part is named without it, too.
    pub fn title(&self, with_part: bool) -> String {
        let part = if with_part || self.name.0.is_empty() { self.part.0.as_str() } else { "" };
        joined([part, self.name.0.as_str(), self.callout.as_str()])
    }

    /// The same in two lines: `B1`, and below it `Flange, 25 H7`.
    pub fn lines(&self, with_part: bool) -> [String; 2] {
        let name = self.name.0.as_str();
        let part = if with_part || name.is_empty() { self.part.0.as_str() } else { "" };
        let mut texts = [name, part, self.callout.as_str()].into_iter().filter(|text| !text.is_empty());
        let first = texts.next().map(str::to_owned).unwrap_or_default();
        [first, joined(texts)]
    }
}

fn joined<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    texts.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ")
}

/// Features with what was computed of each, in the same order.
#[derive(Debug, Clone, Default)]
pub struct EvaluatedSeries {
    pub features: Vec<Arc<FeatureSeries>>,
    pub answers: Arc<Vec<Evaluated>>,
}

impl EvaluatedSeries {
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (&FeatureSeries, &Evaluated)> {
        self.features.iter().map(Arc::as_ref).zip(self.answers.iter())
    }

    /// Whether they are of several parts.
    pub fn has_parts(&self) -> bool {
        let mut parts = self.features.iter().map(|feature| &feature.key.part);
        let first = parts.next();
        parts.any(|part| Some(part) != first)
    }
}

/// The values of one feature, the oldest first, with those that are left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FeatureSeries {
    pub key: FeatureKey,
    pub values: Vec<Value>,
}

/// Sorts the checks of a journal into series while they are read.
#[derive(Debug, Default)]
pub struct Gathering {
    found: BTreeMap<FeatureKey, Vec<(u64, Value)>>,
    /// In place of which entry a correction stands.
    corrects: BTreeMap<u64, u64>,
}

impl Gathering {
    /// Takes an entry by its number; `is_replaced` where another one corrects it or takes it back.
    pub fn take(&mut self, number: u64, entry: &Entry, is_replaced: bool) {
        let Some(value) = Value::of_entry(number, entry, is_replaced) else { return };
        let (callout, nominal) = match entry.check().map(|check| &check.what) {
            Some(Checked::Size(record)) => (asked_for(record), Some(record.limits.nominal)),
            _ => (String::new(), None),
        };
        let [part, name] = [&value.origin.part, &value.name].map(|text| Natural(text.clone()));
        let key = FeatureKey { part, name, callout, nominal, limits: value.limits };
        self.found.entry(key).or_default().push((number, value));
        self.corrects.extend(entry.corrects().map(|correction| (number, correction.target.number)));
    }

    /// Of each feature the newest `most` values that count, with what was left out between them. What corrects a value stands in its place.
    pub fn finish(self, most: usize) -> Vec<FeatureSeries> {
        let Self { found, corrects } = self;
        let place = |number: u64| {
            let mut number = number;
            // An entry corrects an earlier one.
            while let Some(target) = corrects.get(&number).filter(|target| **target < number) {
                number = *target;
            }
            number
        };
        let newest = |(key, mut values): (FeatureKey, Vec<(u64, Value)>)| {
            values.sort_by_key(|(number, _)| std::cmp::Reverse((place(*number), *number)));
            let mut counted = 0;
            let is_new = |(_, value): &(u64, Value)| {
                counted += usize::from(value.left_out.is_none());
                counted <= most
            };
            let mut values: Vec<Value> = values.into_iter().take_while(is_new).map(|(_, value)| value).collect();
            values.reverse();
            FeatureSeries { key, values }
        };
        found.into_iter().map(newest).collect()
    }
}

/// The callout, or the limits where nobody wrote one.
fn asked_for(record: &Record) -> String {
    let [minimum, maximum] = [record.limits.minimum(), record.limits.maximum()];
    record.callout.map_or_else(|| format!("{minimum} … {maximum} mm"), |callout| callout.to_string())
}

/// How a series is looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// What makes a point.
    pub grouping: Grouping,
    /// A chart that remembers, beside that of points.
    pub memory: Option<Memory>,
    /// The rules that are looked at.
    pub rules: Rules,
    /// The first and the last value that control limits come from, by their numbers in the journal; `None` for all values.
    pub baseline: Option<[u64; 2]>,
    /// The first values of further stages, by their numbers in the journal.
    pub stages: BTreeSet<u64>,
    /// Values that somebody left out, by their numbers in the journal, with the reasons.
    pub apart: BTreeMap<u64, Arc<str>>,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            grouping: Grouping::Single,
            memory: None,
            rules: Rules::NELSON,
            baseline: None,
            stages: BTreeSet::new(),
            apart: BTreeMap::new(),
        }
    }
}

/// What is computed of the series of a feature.
#[derive(Debug)]
pub struct Evaluated {
    pub answer: Answer,
    /// What fires on the chart, numbered as it stands.
    pub signals: Vec<Signal>,
    /// The values that count, in millimetres.
    pub values: Vec<f64>,
    /// What lengths of charts are counted from, in millimetres.
    pub base: f64,
    /// The values of all points, by their places in the series.
    pub shown: Vec<usize>,
    /// Which of them each point has.
    pub points: Vec<Range<usize>>,
    /// How many points count.
    pub groups: usize,
    /// How many values are left out for each reason, where there are any.
    pub left_out: Vec<(LeftOut, usize)>,
    /// How many values somebody left out.
    pub apart: usize,
}

impl FeatureSeries {
    /// The nominal size, or else a limit or a value.
    fn base(&self) -> Option<Length> {
        let FeatureKey { nominal, limits: [lower, upper], .. } = self.key;
        let first = self.values.first().map(|value| value.measured);
        nominal.or(lower).or(upper).or(first)
    }

    /// Computes everything.
    pub fn evaluate(&self, look: &Look) -> Evaluated {
        let why = |value: &Value| value.origin.number.and_then(|number| look.apart.get(&number)).cloned();
        let counts = |at: &usize| self.values.get(*at).is_some_and(|value| value.left_out.is_none());
        let shown: Vec<usize> = (0..self.values.len()).filter(counts).collect();
        let of: Vec<&Value> = self.values.iter().collect();
        let counted: Vec<&Value> = shown.iter().filter_map(|at| self.values.get(*at)).collect();
        let (points, ungrouped) = match look.grouping.groups(&counted) {
            Ok(points) => (points, None),
            Err(reason) => (Vec::new(), Some(reason)),
        };
        let mut series = Series { name: None, groups: Vec::new(), counted, of };
        let (mut values, mut apart) = (Vec::new(), Vec::new());
        for (point, places) in (1..).zip(&points) {
            let sample = sample(series.counted.get(places.clone()).unwrap_or_default(), why);
            match sample.left_out {
                Some(why) => apart.push((point, why)),
                None => values.extend(&sample.values),
            }
            series.groups.push(sample.values);
        }
        let point_of = |wanted: &u64| {
            let place = series.counted.iter().position(|value| value.origin.number == Some(*wanted))?;
            Some(points.partition_point(|point| point.end <= place) + 1)
        };
        // A baseline that is not in sight as a whole is longer than the series: it is refused.
        let baseline = look.baseline.map(|[first, last]| {
            let last = point_of(&last).filter(|_| point_of(&first) == Some(1));
            last.unwrap_or(usize::MAX)
        });
        let wanted = Wanted {
            limits: self.key.limits.map(|limit| limit.map(Length::to_mm_f64)),
            chart: (look.grouping == Grouping::Single).then_some(ChartKind::Individuals),
            memory: look.memory,
            rules: look.rules,
            baseline,
            stages: look.stages.iter().filter_map(point_of).collect(),
            left_out: apart,
            level: LEVEL,
            ..Wanted::default()
        };
        let groups = series.groups.len() - wanted.left_out.len();
        let answer = ungrouped.map_or_else(|| Answer::of(&series, &wanted), |why| Answer::none(&wanted, why));
        Evaluated {
            signals: answer.chart.as_ref().map_or_else(|_| Vec::new(), signals),
            answer,
            values,
            base: self.base().map_or(0.0, Length::to_mm_f64),
            points,
            groups,
            left_out: series.left_out().collect(),
            apart: shown.iter().filter_map(|at| self.values.get(*at)).filter(|value| why(value).is_some()).count(),
            shown,
        }
    }
}

/// A point: what counts of its values, or all of them where nothing does.
fn sample(values: &[&Value], why: impl Fn(&Value) -> Option<Arc<str>>) -> Sample {
    let mm = |value: &&Value| value.measured.to_mm_f64();
    let counted: Vec<f64> = values.iter().filter(|value| why(value).is_none()).map(mm).collect();
    if counted.is_empty() {
        Sample { values: values.iter().map(mm).collect(), left_out: values.iter().find_map(|value| why(value)) }
    } else {
        Sample::of(counted)
    }
}

impl Evaluated {
    /// What was read, before anything is said of it: `125 values, 25 groups of 5, 2 left out`.
    pub fn read_text(&self, words: &Words) -> String {
        let mut said = vec![message!("statistics-page-values").count("count", self.values.len())];
        if self.answer.wanted.chart != Some(ChartKind::Individuals) {
            let sizes = || self.points.iter().map(ExactSizeIterator::len);
            let (least, most) = (sizes().min().unwrap_or(0), sizes().max().unwrap_or(0));
            let size = if least < most { format!("{least}–{most}") } else { most.to_string() };
            said.push(message!("statistics-page-groups").count("count", self.groups).text("size", size));
        }
        let out = |why, count: usize| message!("statistics-page-out").text("why", why).count("count", count);
        said.extend(self.left_out.iter().map(|(why, count)| out(why.word(), *count)));
        said.extend((0 < self.apart).then(|| out("user", self.apart)));
        said.iter().map(|message| words.say(message)).collect::<Vec<_>>().join(", ")
    }

    /// Ppk with its interval, or why there is none.
    ///
    /// # Errors
    /// The reason.
    pub fn ppk(&self) -> Result<(f64, [f64; 2]), Reason> {
        let figure = self.answer.figure("ppk").or_else(|| self.answer.figure("cpk")).ok_or(Reason::NoLimits)?;
        let (value, interval) = figure.value.clone()?;
        interval.map(|interval| (value, interval)).ok_or(Reason::NoLimits)
    }

    /// Whether Ppk is proven to be what is asked for: its lower bound is not below it.
    ///
    /// # Errors
    /// Why there is no Ppk.
    pub fn is_proven(&self) -> Result<bool, Reason> {
        self.ppk().map(|(_, [lower, _])| ASKED_INDEX <= lower)
    }
}
