//! The words of a log in the control's dialogue languages, from `assets/logs`.
//!
//! They belong to the files that a control writes, not to the window, so they are not in the locales. A reader goes by
//! order and numbers and never needs them.

use std::collections::BTreeMap;

use fitcheck_core::probing::cycle::LogFigure;
use fitcheck_core::words::{Dialogue, PerDialogue};
use fitcheck_shipped as shipped;
use serde::Deserialize;

/// The words of one dialogue language.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::control) struct Labels {
    pub(super) date: String,
    pub(super) time: String,
    pub(super) program: String,
    pub(super) unit: String,
    pub(super) nominal: String,
    pub(super) limits: String,
    pub(super) actual: String,
    pub(super) deviations: String,
    pub(super) further: String,
    pub(super) end: String,
    pub(super) measuring_height: String,
    /// The title of each cycle's log, by what programs call the cycle.
    titles: BTreeMap<String, String>,
    /// The words of each figure, by the name that a cycle's declaration gives it.
    figures: BTreeMap<String, Words>,
    /// A page of points.
    pub(in crate::control) surface: Surface,
}

/// The words of a figure.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Words {
    /// The word in nominal values, actual values and deviations.
    pub(super) value: String,
    /// Its upper limit; a value without limits has none.
    #[serde(default)]
    pub(super) maximum: String,
    /// Its lower limit.
    #[serde(default)]
    pub(super) minimum: String,
}

/// The words of a page of points.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::control) struct Surface {
    pub(in crate::control) title: String,
    pub(in crate::control) number: String,
    pub(in crate::control) measured_at: String,
    pub(in crate::control) axis: String,
    pub(in crate::control) nominal: String,
    pub(in crate::control) normal: String,
    pub(in crate::control) measured: String,
    pub(in crate::control) deviation: String,
    pub(in crate::control) along: String,
    pub(in crate::control) along_sense: String,
    pub(in crate::control) tolerance: String,
    pub(in crate::control) status: String,
    pub(in crate::control) no_tolerance: String,
    pub(in crate::control) not_judged: String,
    pub(in crate::control) simulated: String,
}

impl Labels {
    /// The words of a dialogue language.
    pub(in crate::control) fn of(dialogue: Dialogue) -> &'static Self {
        static LABELS: PerDialogue<Labels> = PerDialogue::new(|dialogue| {
            let text = shipped::text(shipped::LOGS, &format!("{dialogue}.toml"));
            #[expect(clippy::expect_used, reason = "the file is part of the program and read by a test")]
            toml::from_str(text).expect("words of logs can be read")
        });
        LABELS.of(dialogue)
    }

    /// The title of a cycle's log; a test finds missing ones.
    pub(super) fn title(&self, cycle: u16) -> Option<&str> {
        self.titles.get(&cycle.to_string()).map(String::as_str)
    }

    /// The words of a figure; a test finds missing ones.
    pub(super) fn figure(&self, figure: &LogFigure) -> &Words {
        static NONE: Words = Words { value: String::new(), maximum: String::new(), minimum: String::new() };
        self.figures.get(figure.word).unwrap_or(&NONE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fitcheck_core::probing::cycle::{FigureKind, Log};
    use fitcheck_core::probing::cycles::CYCLES;

    #[test]
    fn every_language_has_the_words_of_every_cycle() {
        let mut missing = std::collections::BTreeSet::new();
        for language in Dialogue::ALL {
            let labels = Labels::of(language);
            let mut need = |has: bool, what: &str, name: &str| {
                missing.extend((!has).then(|| format!("assets/logs/{language}.toml has no {what} {name}")));
            };
            for cycle in CYCLES {
                let Log::Text(log) = cycle.log else { continue };
                let has_title = labels.title(cycle.number).is_some_and(|title| title.contains(cycle.code));
                need(has_title, "title", cycle.code);
                for figure in log.figures {
                    let words = labels.figure(figure);
                    let is_limited = figure.kind != FigureKind::Information;
                    let is_whole = !is_limited || !words.maximum.is_empty() && !words.minimum.is_empty();
                    need(!words.value.is_empty() && is_whole, "whole [figures]", figure.word);
                }
            }
            need(labels.surface.title.contains("444"), "title", "444");
        }
        assert!(missing.is_empty(), "{missing:#?}");
    }
}
