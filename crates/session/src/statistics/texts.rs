//! Figures, signals and charts in words: the same for the eye, for a screen reader and for the clipboard.

use std::ops::Range;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::text::{grouped, long, sentence};
use fitcheck_core::words::Words;
use fitcheck_exchange::series::{ASKED_INDEX, Answer, Evaluated, Value};
use fitcheck_statistics::{Reason, Signal};

use super::{Aside, Below, StatisticsPage};

/// A figure as it stands on the page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FigureText {
    pub name: String,
    /// The figure; a dash where there is none.
    pub value: String,
    pub unit: String,
    /// Its interval, or why there is no figure.
    pub note: String,
}

/// A signal as it stands on the page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SignalText {
    /// Its number, as on the chart.
    pub number: usize,
    /// The rule in words.
    pub rule: String,
    /// Where it was found: values, part, time, who.
    pub place: String,
    /// The point at which it fires last.
    pub point: usize,
}

/// So many patterns of a rule are named.
const MOST_STRETCHES: usize = 3;

/// A number with so many decimals, in the words of a language.
pub(super) fn decimals(words: &Words, value: f64, decimals: usize) -> String {
    words.number(&format!("{value:.decimals$}"))
}

/// What was measured, on which part, when and by whom.
pub fn said_of_value(value: &Value, words: &Words) -> String {
    let origin = &value.origin;
    let time = origin.time.map_or_else(String::new, |time| time.strftime("%Y-%m-%d %H:%M").to_string());
    let measured = format!("{} mm", words.mm(value.measured, 3));
    let texts = [measured.as_str(), origin.piece.as_str(), time.as_str(), origin.who.as_str()];
    texts.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ")
}

impl StatisticsPage {
    /// What was read, before anything is said of it: `125 values, 25 groups of 5, 2 left out`.
    pub fn read_text(&self, words: &Words) -> Option<String> {
        let (_, of) = self.open()?;
        Some(of.read_text(words))
    }

    /// What the whole question left aside: entries that cannot be read, and older ones that were not read.
    pub fn aside_text(&self, words: &Words) -> Option<String> {
        let said: Vec<String> = self.told_aside().iter().map(|message| words.say(message)).collect();
        (!said.is_empty()).then(|| said.join(" "))
    }

    fn told_aside(&self) -> Vec<Message> {
        let Some(found) = self.found() else { return Vec::new() };
        let newest = || message!("statistics-page-newest").text("count", grouped(long(found.read)));
        let unread = || message!("statistics-page-unread").count("count", found.unread);
        [found.has_more.then(newest), (0 < found.unread).then(unread)].into_iter().flatten().collect()
    }

    /// What a report says of the question: what was asked, and what was left aside.
    pub(crate) fn told_of_question(&self) -> Vec<Message> {
        let asked = || message!("reports-page-asked").text("question", &self.question);
        let asked = (!self.question.is_empty()).then(asked);
        asked.into_iter().chain(self.told_aside()).collect()
    }

    /// The figures of the chosen feature.
    pub fn figures(&self, words: &Words) -> Vec<FigureText> {
        let Some((_, of)) = self.open() else { return Vec::new() };
        let lengths = [("mean_mm", "mean", 4, 1.0, "mm"), ("sd_mm", "deviation", 2, 1_000.0, "µm")];
        let mut figures: Vec<FigureText> = lengths
            .into_iter()
            .map(|(name, id, decimals, scale, unit)| figure(words, of, (name, id), (decimals, scale, unit)))
            .collect();
        for (name, id) in [("cp", "cp"), ("cpk", "cpk"), ("pp", "pp"), ("ppk", "ppk")] {
            figures.push(figure(words, of, (name, id), (2, 1.0, "")));
        }
        figures.push(outside(words, of));
        figures
    }

    /// How the chosen feature is looked at, where that is not the usual way: groups, stages, limits that stay, a chart that remembers.
    pub fn told_of_look(&self, words: &Words) -> Vec<String> {
        let told = self.open().map_or_else(Vec::new, |(_, of)| of.told());
        told.iter().map(|message| words.say(message)).collect()
    }

    /// Whether Ppk is proven to be what is usually asked for; never whether that is good.
    pub fn proof_text(&self, words: &Words) -> Option<String> {
        let (_, of) = self.open()?;
        let asked = decimals(words, ASKED_INDEX, 2);
        let said = match (of.is_proven(), of.ppk()) {
            (Ok(is_proven), Ok((_, [lower, _]))) => {
                let id = if is_proven { "statistics-page-proven" } else { "statistics-page-not-proven" };
                Message::new(id).text("asked", asked).text("lower", decimals(words, lower, 2))
            }
            (Err(why), _) | (_, Err(why)) => {
                message!("statistics-page-no-ppk").text("asked", asked).message("why", why.message())
            }
        };
        Some(words.say(&said))
    }

    /// What to do about the figures.
    pub fn advice(&self, words: &Words) -> Vec<String> {
        let advice = self.open().map_or(&[][..], |(_, of)| of.answer.advice.as_slice());
        advice.iter().map(|advice| sentence(&words.told(advice))).collect()
    }

    /// The signals, numbered as on the chart.
    pub fn signals(&self, words: &Words) -> Vec<SignalText> {
        let Some((_, of)) = self.open() else { return Vec::new() };
        (1..).zip(&of.signals).map(|(number, signal)| self.signal(words, number, signal)).collect()
    }

    fn signal(&self, words: &Words, number: usize, signal: &Signal) -> SignalText {
        let rule = sentence(&words.say(&signal.place.said(signal.rule)));
        let points = |of: &Range<usize>| {
            words.say(&match of.len() {
                1 => message!("statistics-page-at").text("point", of.end),
                _ => message!("statistics-page-from-to").text("first", of.start + 1).text("last", of.end),
            })
        };
        let mut places: Vec<String> = signal.stretches.iter().take(MOST_STRETCHES).map(points).collect();
        if MOST_STRETCHES < signal.stretches.len() {
            places.push("…".to_owned());
        }
        let point = signal.stretches.last().map_or(0, |of| of.end.saturating_sub(1));
        let of = self.values_of(point).last().map(|value| said_of_value(value, words));
        let place = [Some(places.join(", ")), of].into_iter().flatten().collect::<Vec<_>>().join(": ");
        SignalText { number, rule, place, point }
    }

    /// What a screen reader says of the chart: one sentence with its figures.
    pub fn chart_text(&self, words: &Words) -> String {
        let Some((_, of)) = self.open() else { return String::new() };
        if let Err(why) = &of.answer.chart {
            return words.say(&message!("statistics-page-no-chart").message("why", why.message()));
        }
        let said = chart_said(&of.answer, of.points.len(), of.signals.len(), words);
        std::iter::once(said).chain(self.told_of_look(words)).collect::<Vec<_>>().join(" ")
    }

    /// What is said of the point at which the keys are.
    pub fn cursor_text(&self, words: &Words) -> Option<String> {
        self.cursor.map(|point| self.point_text(point, words))
    }

    /// What is said of a point: its values, why it is left out, and what fires there.
    pub fn point_text(&self, point: usize, words: &Words) -> String {
        let values: Vec<String> = self.values_of(point).map(|value| said_of_value(value, words)).collect();
        let said = message!("statistics-page-at").text("point", point + 1);
        let mut said = vec![format!("{}: {}", words.say(&said), values.join("; "))];
        if let Some(reason) = self.reason_of(point) {
            said.push(words.say(&message!("statistics-page-left-out-because").text("reason", reason)));
        }
        let signals = self.open().map_or(&[][..], |(_, of)| of.signals.as_slice());
        for (number, signal) in (1..).zip(signals) {
            if signal.stretches.iter().any(|of| of.contains(&point)) {
                said.push(format!("{number}: {}", sentence(&words.say(&signal.place.said(signal.rule)))));
            }
        }
        said.join(". ")
    }

    /// What a screen reader says of one of the smaller charts.
    pub fn aside_said(&self, aside: Aside, words: &Words) -> String {
        let Some((_, of)) = self.open() else { return String::new() };
        let figures: &[(&str, &str, usize, f64)] = match aside {
            Aside::Signals => &[],
            Aside::Histogram => &[("mean_mm", "mm", 4, 1.0), ("sd_mm", "µm", 2, 1_000.0)],
            Aside::Spread if self.below() == Below::Ewma => {
                &[("ewma_mm", "mm", 4, 1.0), ("ewma_lower_mm", "mm", 4, 1.0), ("ewma_upper_mm", "mm", 4, 1.0)]
            }
            Aside::Spread if self.below() == Below::Cusum => &[
                ("cusum_above_mm", "µm", 1, 1_000.0),
                ("cusum_below_mm", "µm", 1, 1_000.0),
                ("cusum_interval_mm", "µm", 1, 1_000.0),
            ],
            Aside::Spread => &[("spread_centre_mm", "µm", 1, 1_000.0), ("spread_upper_mm", "µm", 1, 1_000.0)],
            Aside::Probability => &[("anderson_darling", "", 2, 1.0), ("anderson_darling_p", "", 3, 1.0)],
        };
        let said = figures.iter().filter_map(|(name, unit, digits, scale)| {
            let figure = of.answer.figures.iter().find(|figure| figure.name == *name)?;
            let label = words.get(&format!("statistics-page-said-{}", name.replace('_', "-")));
            Some(match &figure.value {
                Ok((value, _)) => {
                    format!("{label} {} {unit}", decimals(words, value * scale, *digits)).trim_end().to_owned()
                }
                Err(why) => format!("{label}: {}", words.told(why)),
            })
        });
        said.collect::<Vec<_>>().join(", ")
    }

    /// Figures and signals as a table for a spreadsheet.
    pub(super) fn copied(&self, words: &Words) -> Option<String> {
        let (feature, _) = self.open()?;
        let mut lines = vec![feature.key.title(true)];
        lines.extend(self.read_text(words));
        lines.extend(self.told_of_look(words));
        let cells = |figure: FigureText| {
            let FigureText { name, value, unit, note } = figure;
            [name, value, unit, note].join("\t")
        };
        lines.extend(self.figures(words).into_iter().map(cells));
        lines.extend(self.proof_text(words));
        lines.extend(
            self.signals(words)
                .into_iter()
                .map(|SignalText { number, rule, place, .. }| [number.to_string(), rule, place].join("\t")),
        );
        lines.extend(self.advice(words));
        Some(lines.join("\n"))
    }
}

/// A chart as one sentence with its figures.
pub(super) fn chart_said(answer: &Answer, points: usize, signals: usize, words: &Words) -> String {
    let mm = |name: &str| match answer.figure(name).map(|found| &found.value) {
        Some(Ok((value, _))) => format!("{} mm", decimals(words, *value, 4)),
        _ => "–".to_owned(),
    };
    let limit = |limit: Option<f64>| {
        let length = limit.and_then(|limit| Length::from_mm_f64(limit).ok());
        length.map_or_else(|| "–".to_owned(), |limit| format!("{} mm", words.mm(limit, 3)))
    };
    let [lower, upper] = answer.wanted.limits.map(limit);
    let said = message!("statistics-page-chart-said")
        .count("count", points)
        .text("centre", mm("centre_mm"))
        .text("lower", mm("lower_control_mm"))
        .text("upper", mm("upper_control_mm"))
        .text("minimum", lower)
        .text("maximum", upper);
    words.say(&said.count("signals", signals).count("outside", answer.outside.iter().sum()))
}

fn figure(
    words: &Words,
    of: &Evaluated,
    (name, id): (&str, &str),
    (digits, scale, unit): (usize, f64, &str),
) -> FigureText {
    let number = |value: f64| decimals(words, value * scale, digits);
    let name_text = words.get(&format!("statistics-page-figure-{id}"));
    // Where nothing at all could be computed, one figure has the reason for all of them.
    let lacks = || {
        let of_index = of.answer.figure("cpk").and_then(|found| found.value.as_ref().err());
        if of.answer.figure("ppk").is_some() { Reason::OneLimit } else { of_index.cloned().unwrap_or(Reason::NoLimits) }
    };
    let found = of.answer.figure(name).map_or_else(|| Err(lacks()), |found| found.value.clone());
    let (value, unit, note) = match found {
        Ok((value, Some([lower, upper]))) => {
            let interval =
                message!("statistics-page-interval").text("lower", number(lower)).text("upper", number(upper));
            (number(value), unit, words.say(&interval))
        }
        Ok((value, None)) => (number(value), unit, String::new()),
        Err(why) => ("–".to_owned(), "", words.told(&why)),
    };
    FigureText { name: name_text, value, unit: unit.to_owned(), note }
}

fn outside(words: &Words, of: &Evaluated) -> FigureText {
    let name = words.get("statistics-page-figure-outside");
    let count: usize = of.answer.outside.iter().sum();
    let has_limits = of.answer.wanted.limits.iter().any(Option::is_some);
    let note = match of.answer.figure("ppm_overall").map(|found| &found.value) {
        Some(Ok((ppm, _))) => words.say(&message!("statistics-page-expected").text("ppm", decimals(words, *ppm, 0))),
        _ => String::new(),
    };
    let (value, unit, note) = if has_limits {
        let of_all = words.say(&message!("statistics-page-of").text("count", of.values.len()));
        (count.to_string(), of_all, note)
    } else {
        ("–".to_owned(), String::new(), words.told(&Reason::NoLimits))
    };
    FigureText { name, value, unit, note }
}
