//! Layout, figures and advice in words: the same for the eye, for a screen reader and for the clipboard.

use fitcheck_core::message::{Message, message};
use fitcheck_core::text::sentence;
use fitcheck_core::words::Words;
use fitcheck_exchange::series::{Figure, FigureKind, Group, Layout, StudyKind};
use fitcheck_statistics::Advice;
use fitcheck_statistics::gauge::Finding;

use super::{Study, StudyRead};
use crate::statistics::texts::{chart_said, decimals};

/// A figure as it stands on the page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StudyFigure {
    pub name: String,
    /// The figure with its unit; a dash where there is none.
    pub value: String,
    /// Its interval, or why there is no figure.
    pub interval: String,
    pub method: String,
}

/// So many faults are named.
const MOST_FAULTS: usize = 8;

/// The name of a kind of study.
pub const fn kind_id(kind: StudyKind) -> &'static str {
    match kind {
        StudyKind::Type1 => "statistics-study-type1",
        StudyKind::Crossed => "statistics-study-crossed",
        StudyKind::Nested => "statistics-study-nested",
        StudyKind::Linearity => "statistics-study-linearity",
        StudyKind::Stability => "statistics-study-stability",
    }
}

impl StudyRead {
    /// What was read: `90 values, 2 left out: simulated`.
    pub fn read_text(&self, words: &Words) -> String {
        let mut said = vec![words.say(&message!("statistics-page-values").count("count", self.count))];
        for (why, count) in &self.left_out {
            said.push(words.say(&message!("statistics-page-out").text("why", why.word()).count("count", *count)));
        }
        said.join(", ")
    }

    /// How it was understood: `10 parts, 3 operators, 3 repeats`.
    pub fn layout_text(&self, words: &Words) -> String {
        let Layout { kind, parts, operators, readings: [least, most] } = self.understood.layout;
        let say = |id: &'static str, count: usize| words.say(&Message::new(id).count("count", count));
        let each = |what: String| words.say(&message!("statistics-study-each").text("what", what));
        let readings = if least == most {
            say("statistics-study-readings", most)
        } else {
            words.say(&message!("statistics-study-readings-between").text("least", least).text("most", most))
        };
        let said = match kind {
            StudyKind::Type1 => vec![say("statistics-study-masters", 1), readings],
            StudyKind::Crossed => vec![
                say("statistics-study-parts", parts),
                say("statistics-study-operators", operators),
                say("statistics-study-repeats", most),
            ],
            StudyKind::Nested => vec![
                say("statistics-study-operators", operators),
                each(say("statistics-study-parts", parts)),
                say("statistics-study-repeats", most),
            ],
            StudyKind::Linearity => vec![say("statistics-study-masters", parts), each(readings)],
            StudyKind::Stability => vec![say("statistics-study-points", parts), each(readings)],
        };
        said.join(", ")
    }

    /// What looks wrong with it.
    pub fn doubts(&self, words: &Words) -> Vec<String> {
        self.understood.doubts.iter().map(|doubt| sentence(&words.told(doubt))).collect()
    }

    /// What is missing, or is there too often.
    pub fn faults(&self, words: &Words) -> Vec<String> {
        let faults = &self.understood.faults;
        let named = faults.iter().take(MOST_FAULTS).map(|fault| sentence(&words.told(fault)));
        let more = faults.len().saturating_sub(MOST_FAULTS);
        let more = (0 < more).then(|| words.say(&message!("statistics-study-more-faults").count("count", more)));
        named.chain(more).collect()
    }

    /// The limits that count, where they are those of the file.
    pub fn limits_text(&self, words: &Words) -> Option<String> {
        let [lower, upper] =
            self.limits.map(|limit| limit.map_or_else(|| "–".to_owned(), |mm| words.number(&mm.to_string())));
        let said = message!("statistics-study-own-limits").text("lower", lower).text("upper", upper);
        self.has_own_limits.then(|| words.say(&said))
    }
}

impl Study {
    /// Why nothing is computed yet, or what looks wrong by the figures.
    pub fn doubt_of_figures(&self, words: &Words) -> Option<String> {
        let doubt = self.found()?.ok()?.answer.doubt.as_ref()?;
        Some(sentence(&words.told(doubt)))
    }

    /// Whether the gauge is good enough and what is the smallest tolerance that it is good enough for; then everything else that
    /// is to be said.
    pub fn advice(&self, words: &Words) -> [Vec<String>; 2] {
        let advice = self.evaluated().map_or(&[][..], |found| found.answer.advice.as_slice());
        let (answers, rest): (Vec<&Advice>, Vec<&Advice>) = advice.iter().partition(|advice| is_answer(advice));
        [answers, rest].map(|advice| advice.into_iter().map(|advice| sentence(&words.told(advice))).collect())
    }

    /// The figures, those that answer the question first; of a linearity study also those of each master.
    pub fn figures(&self, words: &Words) -> Vec<StudyFigure> {
        let Some(found) = self.evaluated() else { return Vec::new() };
        let is_linear = found.answer.layout.is_some_and(|layout| layout.kind == StudyKind::Linearity);
        let (anova, figures): (Vec<&Figure>, Vec<&Figure>) =
            found.answer.figures.iter().partition(|figure| is_of_anova(figure));
        let shown_of = |figure| shown(figure, name(figure, is_linear, words), words);
        let figures = figures.into_iter().chain(anova).map(shown_of);
        let group = |group: &Group| {
            let said = message!("statistics-study-figure-bias-at").text("size", words.number(&group.name));
            shown(&group.figure, words.say(&said.count("count", group.count)), words)
        };
        figures.chain(found.answer.groups.iter().map(group)).collect()
    }

    /// What a screen reader says of the chart of a stability study.
    pub fn chart_text(&self, words: &Words) -> String {
        let Some(found) = self.evaluated() else { return String::new() };
        let answer = &found.answer;
        let Ok(chart) = &answer.chart else { return String::new() };
        chart_said(answer, chart.points.len(), found.signals.len(), words)
    }

    /// Layout, advice and figures as a table for a spreadsheet.
    pub(in crate::statistics) fn copied(&self, words: &Words) -> Option<String> {
        self.evaluated()?;
        let read = self.read.as_ref()?.as_ref().ok()?;
        let mut lines: Vec<String> = self.file().map(|file| file.name.clone()).into_iter().collect();
        lines.push(format!("{}: {}", words.get(kind_id(self.kind)), read.layout_text(words)));
        lines.extend(self.advice(words).concat());
        let cells = |StudyFigure { name, value, interval, method }| [name, value, interval, method].join("\t");
        lines.extend(self.figures(words).into_iter().map(cells));
        Some(lines.join("\n"))
    }
}

/// Whether advice answers the question of the study.
const fn is_answer(advice: &Advice) -> bool {
    matches!(
        advice,
        Advice::Gauge(
            Finding::MasterGood { .. }
                | Finding::MasterBad { .. }
                | Finding::Smallest { .. }
                | Finding::Good { .. }
                | Finding::Accepted { .. }
                | Finding::Bad { .. }
                | Finding::SmallestShares { .. }
                | Finding::Linear { .. }
                | Finding::NotLinear { .. }
                | Finding::Stable
                | Finding::NotStable
        )
    )
}

/// Whether a figure is a step of the analysis of variance.
fn is_of_anova(figure: &Figure) -> bool {
    ["ms_", "p_", "var_"].iter().any(|begin| figure.name.starts_with(begin))
}

/// The name of a figure.
fn name(figure: &Figure, is_linear: bool, words: &Words) -> String {
    let of = |id: &'static str, of: &str| {
        let source = words.say(&message!("statistics-study-source").text("of", of));
        words.say(&Message::new(id).text("source", source))
    };
    if let Some(source) = figure.name.strip_prefix("ms_") {
        return of("statistics-study-mean-square", source);
    }
    if let Some(source) = figure.name.strip_prefix("p_") {
        return of("statistics-study-p", source);
    }
    if let Some(source) = figure.name.strip_prefix("var_") {
        return of("statistics-study-variance", source);
    }
    let id = match figure.name {
        "reference_mm" => "statistics-study-figure-reference",
        "mean_mm" => "statistics-page-figure-mean",
        "sd_mm" => "statistics-page-figure-deviation",
        "bias_mm" if is_linear => "statistics-study-figure-mean-bias",
        "bias_mm" => "statistics-study-figure-bias",
        "bias_p" => "statistics-study-figure-bias-p",
        "bias_t" => "statistics-study-figure-bias-t",
        "smallest_tolerance_mm" => "statistics-study-figure-smallest",
        "repeatability_mm" => "statistics-study-figure-repeatability",
        "gauge_mm" => "statistics-study-figure-gauge",
        "percent_contribution" => "statistics-study-figure-of-variance",
        "percent_of_study" => "statistics-study-figure-of-readings",
        "percent_of_tolerance" => "statistics-study-figure-of-tolerance",
        "categories" => "statistics-study-figure-categories",
        "smallest_good_mm" => "statistics-study-figure-smallest-good",
        "smallest_accepted_mm" => "statistics-study-figure-smallest-accepted",
        "slope" => "statistics-study-figure-slope",
        "slope_p" => "statistics-study-figure-slope-p",
        "intercept_mm" => "statistics-study-figure-intercept",
        "intercept_p" => "statistics-study-figure-intercept-p",
        "residual_mm" => "statistics-study-figure-residual",
        "centre_mm" => "statistics-study-figure-centre",
        "lower_control_mm" => "statistics-study-figure-lower-control",
        "upper_control_mm" => "statistics-study-figure-upper-control",
        "spread_centre_mm" => "statistics-study-figure-spread-centre",
        "spread_upper_mm" => "statistics-study-figure-spread-upper",
        // Cg, Cgk, R²: the same in every language.
        _ => return figure.label.to_owned(),
    };
    words.get(id)
}

/// Lengths of sizes; the others are small.
const SIZES: [&str; 5] = ["reference_mm", "mean_mm", "centre_mm", "lower_control_mm", "upper_control_mm"];

/// Smaller probabilities are not told apart.
const LEAST_P: f64 = 0.0001;

/// A figure with its interval and its method.
fn shown(figure: &Figure, name: String, words: &Words) -> StudyFigure {
    let is_size = SIZES.contains(&figure.name) || figure.name.starts_with("smallest_");
    let (scale, digits, unit) = match figure.kind {
        FigureKind::Length if is_size => (1.0, 4, " mm"),
        FigureKind::Length => (1_000.0, 2, " µm"),
        FigureKind::Square => (1e6, 3, " µm²"),
        FigureKind::Percent => (1.0, 1, " %"),
        FigureKind::Ppm => (1.0, 0, ""),
        FigureKind::Index if figure.name == "categories" => (1.0, 0, ""),
        FigureKind::Index => (1.0, 3, ""),
        FigureKind::Probability => (1.0, 4, ""),
    };
    let number = |value: f64| match figure.kind {
        FigureKind::Probability if value < LEAST_P => words.number(&format!("< {LEAST_P}")),
        _ => decimals(words, value * scale, digits),
    };
    let (value, interval) = match &figure.value {
        Ok((value, ends)) => {
            let interval = ends.map(|[lower, upper]| {
                let said = message!("statistics-page-interval").text("lower", number(lower));
                words.say(&said.text("upper", number(upper)))
            });
            (format!("{}{unit}", number(*value)), interval.unwrap_or_default())
        }
        Err(why) => ("–".to_owned(), words.told(why)),
    };
    StudyFigure { name, value, interval, method: words.told(&figure.method) }
}
