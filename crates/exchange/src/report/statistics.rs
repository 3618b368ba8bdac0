//! The statistics of each feature of a report: figures with their intervals, charts, rules that fire, advice.
//!
//! Features are those of the series that were chosen, of the parts, or else checks of one name. Checks that all have other names and the same limits
//! are one feature.

use std::collections::HashMap;
use std::io;

use fitcheck_core::length::Length;
use fitcheck_core::message::message;
use fitcheck_core::text::sentence;
use fitcheck_core::words::Words;
use fitcheck_statistics::Reason;
use fitcheck_statistics::picture::{Picture, svg};

use super::Report;
use super::origins::Entry;
use super::template::Section;
use crate::exchange::Labels;
use crate::journal::Record;
use crate::series::{ASKED_INDEX, Answer, Evaluated, FeatureSeries, Figure, Grouping, LeftOut, Series, Value, Wanted};

/// The most values that are kept in memory.
const MOST_VALUES: usize = 1_000_000;

/// So many points of a rule are listed.
const MOST_POINTS: usize = 20;

/// The level of the intervals.
const LEVEL: f64 = 0.95;

/// A feature with everything that is said of it.
pub(super) struct FeatureStatistics {
    pub heading: String,
    /// What was read.
    pub read: String,
    pub figures: Vec<Entry>,
    /// What is proven, what fires, and what to do.
    pub told: Vec<String>,
    /// Its charts as SVG, where there are any.
    pub charts: Option<String>,
}

impl FeatureStatistics {
    /// The charts in words: a screen reader says what they show.
    pub fn said(&self) -> String {
        let figures = self.figures.iter().map(|figure| format!("{}: {}", figure.label, figure.value));
        let all: Vec<String> = [self.heading.clone(), self.read.clone()].into_iter().chain(figures).collect();
        all.join("; ")
    }
}

/// The features of a report; none where its template shows no statistics.
///
/// # Errors
/// Those of its checks.
pub(super) fn of(report: &Report, words: &Words) -> io::Result<Vec<FeatureStatistics>> {
    if !report.template.has(Section::Statistics) {
        return Ok(Vec::new());
    }
    if 0 < report.series.iter().len() {
        let with_part = report.series.has_parts();
        return Ok(report.series.iter().map(|of| evaluated(of, with_part, words)).collect());
    }
    let mut gathered = Gathered::default();
    gathered.take(report)?;
    let one_name = gathered.features.len() == gathered.count && gathered.are_alike();
    if one_name && 1 < gathered.count {
        let features = std::mem::take(&mut gathered.features);
        let mut all = features.into_iter();
        let Some(mut first) = all.next() else { return Ok(Vec::new()) };
        first.values.extend(all.flat_map(|feature| feature.values));
        first.name.clear();
        gathered.features.push(first);
    }
    let left_out = gathered.left_out;
    let mut features: Vec<_> = gathered.features.iter().map(|feature| feature.statistics(words)).collect();
    if let Some(first) = features.first_mut().filter(|_| 0 < left_out) {
        let most = message!("report-statistics-most").count("count", MOST_VALUES);
        first.told.insert(0, words.say(&most));
    }
    Ok(features)
}

/// The values of a feature.
struct Gatherer {
    name: String,
    callout: String,
    nominal: Length,
    values: Vec<Value>,
}

#[derive(Default)]
struct Gathered {
    features: Vec<Gatherer>,
    places: HashMap<String, usize>,
    count: usize,
    left_out: usize,
}

impl Gathered {
    fn take(&mut self, report: &Report) -> io::Result<()> {
        for part in &report.parts {
            for (size, _, record) in part.sizes() {
                if let Some(record) = record {
                    let labels = Labels { serial: part.serial().to_owned(), ..Labels::default() };
                    self.add(&size.name(), record, &labels);
                }
            }
        }
        if report.parts.is_empty() {
            report.checks.each(&mut |record| {
                self.add(&record.id, record, &Labels::default());
                Ok(())
            })?;
        }
        Ok(())
    }

    fn add(&mut self, name: &str, record: &Record, labels: &Labels) {
        if self.count == MOST_VALUES {
            self.left_out += 1;
            return;
        }
        self.count += 1;
        let value = Value { name: name.to_owned(), ..Value::of_record(record, labels, record.doubt.is_some()) };
        let place = self.places.get(name).copied().unwrap_or(self.features.len());
        if let Some(feature) = self.features.get_mut(place) {
            feature.values.push(value);
            return;
        }
        self.places.insert(name.to_owned(), place);
        let callout = record.callout.map(|callout| callout.to_string()).unwrap_or_default();
        let nominal = record.limits.nominal;
        self.features.push(Gatherer { name: name.to_owned(), callout, nominal, values: vec![value] });
    }

    fn are_alike(&self) -> bool {
        let limits = |feature: &Gatherer| feature.values.first().map(|value| value.limits);
        self.features.windows(2).all(|pair| matches!(pair, [one, other] if limits(one) == limits(other)))
    }
}

impl Gatherer {
    fn statistics(&self, words: &Words) -> FeatureStatistics {
        let names = [self.name.clone(), words.number(&self.callout)];
        let heading: Vec<String> = names.into_iter().filter(|name| !name.is_empty()).collect();
        let heading = heading.join(", ");
        let mut told = Vec::new();
        let Ok(series) = Series::of(&self.values, None, Grouping::Single) else {
            return FeatureStatistics { heading, read: String::new(), figures: Vec::new(), told, charts: None };
        };
        let limits = series.limits().unwrap_or_else(|_| {
            told.push(words.get("report-statistics-limits"));
            [None, None]
        });
        let wanted = Wanted { limits, level: LEVEL, ..Wanted::default() };
        let answer = Answer::of(&series, &wanted);
        let charts = answer.sheet(&series, Some(self.nominal.to_mm_f64()), words);
        let read = read(&series, words);
        said(Top { heading, read, told, count: series.count() }, &answer, charts, words)
    }
}

/// What stands above the figures.
struct Top {
    heading: String,
    read: String,
    told: Vec<String>,
    count: usize,
}

/// A feature as the page Statistics shows it: with what was left out, and the points that its control limits come from.
fn evaluated((feature, of): (&FeatureSeries, &Evaluated), with_part: bool, words: &Words) -> FeatureStatistics {
    let answer = &of.answer;
    let heading = words.number(&feature.key.title(with_part));
    let mut told: Vec<String> = of.told().iter().map(|message| words.say(message)).collect();
    told.extend(answer.wanted.left_out.iter().map(|(point, reason)| {
        let reason = words.say(&message!("statistics-page-left-out-because").text("reason", &**reason));
        format!("{}: {reason}", words.say(&message!("statistics-page-at").text("point", *point)))
    }));
    let top = Top { heading, read: of.read_text(words), told, count: of.values.len() };
    said(top, answer, of.sheet(words), words)
}

fn said(top: Top, answer: &Answer, charts: Result<Picture, Reason>, words: &Words) -> FeatureStatistics {
    let Top { heading, read, mut told, count } = top;
    told.extend(proven(answer, words));
    told.extend(answer.fired.iter().map(|(rule, points)| {
        let mut all: Vec<String> = points.iter().take(MOST_POINTS).map(usize::to_string).collect();
        if MOST_POINTS < points.len() {
            all.push("…".to_owned());
        }
        sentence(&format!("{}: {}", words.told(rule), all.join(", ")))
    }));
    told.extend(answer.advice.iter().map(|advice| sentence(&words.told(advice))));
    let figures = figures(answer, count, words);
    let mut of = FeatureStatistics { heading, read, figures, told, charts: None };
    of.charts = charts.ok().map(|charts| svg(&charts, &of.said()));
    of
}

/// `125 values, 2 left out: simulated`
fn read(series: &Series<'_>, words: &Words) -> String {
    let values = message!("statistics-page-values").count("count", series.count());
    let out =
        |(why, count): (LeftOut, usize)| message!("statistics-page-out").count("count", count).text("why", why.word());
    let said = std::iter::once(values).chain(series.left_out().map(out));
    said.map(|message| words.say(&message)).collect::<Vec<_>>().join(", ")
}

/// The figures that the page Statistics shows, too.
const FIGURES: [(&str, &str); 6] = [
    ("mean_mm", "statistics-page-figure-mean"),
    ("sd_mm", "statistics-page-figure-deviation"),
    ("cp", "statistics-page-figure-cp"),
    ("cpk", "statistics-page-figure-cpk"),
    ("pp", "statistics-page-figure-pp"),
    ("ppk", "statistics-page-figure-ppk"),
];

fn figures(answer: &Answer, count: usize, words: &Words) -> Vec<Entry> {
    let mut entries: Vec<Entry> = FIGURES
        .iter()
        .filter_map(|(name, label)| {
            let figure = answer.figures.iter().find(|figure| figure.name == *name)?;
            Some(Entry { label: words.get(label), value: shown(figure, words) })
        })
        .collect();
    let [below, above] = answer.outside;
    let mut outside = format!("{} {}", below + above, words.say(&message!("statistics-page-of").count("count", count)));
    let expected = answer.figures.iter().find(|figure| figure.name == "ppm_overall");
    if let Some(Ok((ppm, _))) = expected.map(|figure| figure.value.clone()) {
        let said = message!("statistics-page-expected").text("ppm", words.number(&format!("{ppm:.0}")));
        outside = format!("{outside}; {}", words.say(&said));
    }
    if answer.wanted.limits.iter().any(Option::is_some) {
        entries.push(Entry { label: words.get("statistics-page-figure-outside"), value: outside });
    }
    entries
}

/// A figure with its interval, or why there is none.
fn shown(figure: &Figure, words: &Words) -> String {
    let number = |value: f64| match figure.name {
        "mean_mm" => words.number(&format!("{value:.4}")),
        "sd_mm" => words.number(&format!("{:.2}", value * 1_000.0)),
        _ => words.number(&format!("{value:.2}")),
    };
    let unit = match figure.name {
        "mean_mm" => " mm",
        "sd_mm" => " µm",
        _ => "",
    };
    match &figure.value {
        Ok((value, Some([lower, upper]))) => {
            let interval =
                message!("statistics-page-interval").text("lower", number(*lower)).text("upper", number(*upper));
            format!("{}{unit} ({})", number(*value), words.say(&interval))
        }
        Ok((value, None)) => format!("{}{unit}", number(*value)),
        Err(reason) => words.told(reason),
    }
}

/// Whether the lower bound of Ppk proves what is asked for.
fn proven(answer: &Answer, words: &Words) -> Option<String> {
    let ppk = answer.figures.iter().find(|figure| figure.name == "ppk")?;
    let Ok((_, Some([lower, _]))) = &ppk.value else { return None };
    let asked = words.number(&format!("{ASKED_INDEX:.2}"));
    let bound = words.number(&format!("{lower:.2}"));
    let said = if ASKED_INDEX <= *lower {
        message!("statistics-page-proven").text("asked", asked).text("lower", bound)
    } else {
        message!("statistics-page-not-proven").text("asked", asked).text("lower", bound)
    };
    Some(words.say(&said))
}
