//! What is computed of a series of a journal, as it is looked at.

use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::words::Words;
use fitcheck_statistics::{ChartKind, Reason, Rules, Sample, Signal, signals};

use super::{Answer, FeatureKey, FeatureSeries, Grouping, LeftOut, Memory, Series, Value, Wanted};

/// The index that is usually asked for.
pub const ASKED_INDEX: f64 = 1.33;

/// The level of all intervals.
const LEVEL: f64 = 0.95;

/// How a series is looked at.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// What makes a point.
    pub grouping: Grouping,
    /// A chart that remembers, beside that of points.
    pub memory: Option<Memory>,
    /// The rules that are looked at.
    pub rules: Rules,
    /// The first and the last value that the control limits of their stage come from, by their numbers in the journal; `None` for all values.
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
    /// What makes a point.
    pub grouping: Grouping,
    /// How many values count.
    pub counted: usize,
    /// Those of the last stage in millimetres: the figures are theirs.
    pub values: Vec<f64>,
    /// What lengths of charts are counted from, in millimetres.
    pub base: f64,
    /// The values of all points, by their places in the series.
    pub shown: Vec<usize>,
    /// Which of them each point has.
    pub points: Vec<Range<usize>>,
    /// How many points count.
    pub groups: usize,
    /// Where stages begin: at which point, from 0, and the value that says so. The last ones may wait for more values.
    pub stages: Vec<(usize, u64)>,
    /// How many stages wait: they have too few values for limits of their own.
    pub waiting: usize,
    /// How many values are left out for each reason, where there are any.
    pub left_out: Vec<(LeftOut, usize)>,
    /// How many values somebody left out.
    pub apart: usize,
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

/// The points of a series: its values that count, and which of them each point has.
struct Points {
    places: Vec<Range<usize>>,
    /// The points at which further stages begin, from 0.
    stages: Vec<usize>,
}

impl Points {
    /// No subgroup goes on into the next stage.
    fn of(counted: &[&Value], grouping: Grouping, begins: &[usize]) -> Result<Self, Reason> {
        let ends = begins.iter().copied().chain([counted.len()]);
        let (mut places, mut stages) = (Vec::new(), Vec::new());
        for (start, end) in std::iter::once(0).chain(begins.iter().copied()).zip(ends) {
            if !places.is_empty() {
                stages.push(places.len());
            }
            let groups = grouping.groups(counted.get(start..end).unwrap_or_default())?;
            places.extend(groups.into_iter().map(|group| start + group.start..start + group.end));
        }
        Ok(Self { places, stages })
    }

    /// The point that has a value, by the place of the value.
    fn at(&self, place: usize) -> usize {
        self.places.partition_point(|point| point.end <= place)
    }
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
        let counts = |at: &usize| self.values.get(*at).is_some_and(|value| value.left_out.is_none());
        let shown: Vec<usize> = (0..self.values.len()).filter(counts).collect();
        let counted: Vec<&Value> = shown.iter().filter_map(|at| self.values.get(*at)).collect();
        let begins = self.begins(look, &shown);
        let places: BTreeSet<usize> = begins.iter().map(|(place, _)| *place).filter(|place| 0 < *place).collect();
        let places: Vec<usize> = places.into_iter().collect();
        let evaluated = |places: &[usize]| match Points::of(&counted, look.grouping, places) {
            Ok(points) => self.evaluated(look, &counted, points),
            Err(reason) => self.ungrouped(look, &counted, reason),
        };
        // A stage that has no limits of its own yet waits.
        let mut of = evaluated(&places);
        for waiting in 1..=places.len() {
            if of.answer.chart.is_ok() {
                break;
            }
            let fewer = evaluated(places.get(..places.len() - waiting).unwrap_or_default());
            if fewer.answer.chart.is_ok() {
                of = Evaluated { waiting, ..fewer };
            }
        }
        let points = Points { places: of.points.clone(), stages: Vec::new() };
        of.stages = begins.into_iter().map(|(place, number)| (points.at(place), number)).collect();
        Evaluated { shown, ..of }
    }

    /// Where stages begin: with the first value that counts from the one on that somebody named.
    fn begins(&self, look: &Look, shown: &[usize]) -> Vec<(usize, u64)> {
        let named = self.values.iter().enumerate().filter_map(|(at, value)| Some((at, value.origin.number?)));
        let begin = |(at, number): (usize, u64)| (shown.partition_point(|shown| *shown < at), number);
        let begins = named.filter(|(_, number)| look.stages.contains(number)).map(begin);
        begins.filter(|(place, _)| *place < shown.len()).collect()
    }

    /// The figures of values of which some do not say to which subgroup they belong: there is no chart.
    fn ungrouped(&self, look: &Look, counted: &[&Value], reason: Reason) -> Evaluated {
        let single = Points { places: (0..counted.len()).map(|at| at..at + 1).collect(), stages: Vec::new() };
        let as_single = Look { memory: None, grouping: Grouping::Single, ..look.clone() };
        let of = self.evaluated(&as_single, counted, single);
        let answer = of.answer.without_chart(reason);
        let grouping = look.grouping;
        Evaluated { grouping, answer, signals: Vec::new(), points: Vec::new(), groups: 0, ..of }
    }

    fn evaluated(&self, look: &Look, counted: &[&Value], points: Points) -> Evaluated {
        let why = |value: &Value| value.origin.number.and_then(|number| look.apart.get(&number)).cloned();
        let of = self.values.iter().collect();
        let mut series = Series { name: None, groups: Vec::new(), counted: counted.to_vec(), of };
        let now = points.stages.last().copied().unwrap_or(0);
        let (mut values, mut left_out) = (Vec::new(), Vec::new());
        for (point, places) in points.places.iter().enumerate() {
            let sample = sample(counted.get(places.clone()).unwrap_or_default(), why);
            match sample.left_out {
                Some(why) => left_out.push((point + 1, why)),
                None if now <= point => values.extend(&sample.values),
                None => {}
            }
            series.groups.push(sample.values);
        }
        let place = |wanted: u64| counted.iter().position(|value| value.origin.number == Some(wanted));
        let frozen = look.baseline.map(|[first, last]| Some(points.at(place(first)?)..points.at(place(last)?) + 1));
        let wanted = Wanted {
            limits: self.key.limits.map(|limit| limit.map(Length::to_mm_f64)),
            chart: (look.grouping == Grouping::Single).then_some(ChartKind::Individuals),
            memory: look.memory,
            rules: look.rules,
            // A baseline that is not in sight as a whole is longer than the series: it is refused.
            baseline: matches!(frozen, Some(None)).then_some(usize::MAX),
            frozen: frozen.flatten(),
            stages: points.stages.iter().map(|point| point + 1).collect(),
            left_out,
            level: LEVEL,
            ..Wanted::default()
        };
        let answer = Answer::of(&series, &wanted);
        let apart = counted.iter().filter(|value| why(value).is_some()).count();
        Evaluated {
            signals: answer.chart.as_ref().map_or_else(|_| Vec::new(), signals),
            grouping: look.grouping,
            counted: counted.len() - apart,
            values,
            base: self.base().map_or(0.0, Length::to_mm_f64),
            shown: Vec::new(),
            groups: series.groups.len() - wanted.left_out.len(),
            points: points.places,
            stages: Vec::new(),
            waiting: 0,
            left_out: series.left_out().collect(),
            apart,
            answer,
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
        let mut said = vec![message!("statistics-page-values").count("count", self.counted)];
        if self.grouping != Grouping::Single && !self.points.is_empty() {
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

    /// How it was looked at, where that is not the usual way: what makes a subgroup, where stages begin, which points limits come from, and the
    /// chart that remembers.
    pub fn told(&self) -> Vec<Message> {
        let mut told = Vec::new();
        let by = match self.grouping {
            Grouping::Single | Grouping::Of(_) => None,
            Grouping::By(factor) => Some((factor.word(), 0)),
            Grouping::Pause(minutes) => Some(("pause", minutes)),
        };
        told.extend(
            by.map(|(by, minutes)| message!("statistics-look-grouped").text("by", by).text("minutes", minutes)),
        );
        if let Ok(chart) = &self.answer.chart {
            let begins: Vec<String> =
                chart.stages.iter().skip(1).map(|stage| (stage.points.start + 1).to_string()).collect();
            if !begins.is_empty() {
                told.push(message!("statistics-look-stages").text("points", begins.join(", ")));
            }
            if let Some(frozen) = &self.answer.wanted.frozen {
                let stage = chart.stages.iter().find(|stage| stage.points.contains(&frozen.start));
                let last = stage.map_or(frozen.end, |stage| frozen.end.min(stage.points.end));
                told.push(message!("statistics-look-frozen").text("first", frozen.start + 1).text("last", last));
            }
            told.extend((0 < self.waiting).then(|| message!("statistics-look-waits").count("count", self.waiting)));
        }
        if let Some(memory) = self.answer.wanted.memory {
            let method = memory.method();
            told.push(match self.answer.remembered() {
                Ok(_) => message!("statistics-look-memory").text("method", method),
                Err(why) => message!("statistics-look-no-memory").text("method", method).message("why", why.message()),
            });
        }
        told
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
