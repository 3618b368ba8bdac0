//! The words of a log in the control's dialogue languages, from `assets/logs`.
//!
//! They belong to the files that a control writes, not to the window, so they stand apart from the locales. A reader
//! goes by order and numbers and never asks for them.

use serde::Deserialize;

use super::Values;
use crate::shipped;
use crate::tolerance::Feature;
use crate::words::{Dialogue, PerDialogue};

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
    /// Centre in reference and minor axis, diameter.
    pub(super) place: [String; 3],
    /// Maximum and minimum in the reference axis, then in the minor axis.
    pub(super) centre_limits: [String; 4],
    pub(super) coordinate: String,
    pub(super) measuring_height: String,
    hole: Sort,
    stud: Sort,
    length: Sort,
    /// The log of cycle 444.
    pub(in crate::control) surface: Surface,
}

/// What differs between the cycles.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sort {
    pub(super) title: String,
    pub(super) maximum: String,
    pub(super) minimum: String,
}

/// The words of cycle 444's log.
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

    /// What differs between the cycles.
    pub(super) const fn sort(&self, values: &Values) -> &Sort {
        match values {
            Values::Circle(circle) => match circle.feature {
                Feature::Hole => &self.hole,
                Feature::Shaft => &self.stud,
            },
            Values::Coordinate(_) => &self.length,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dialogue_can_be_read() {
        for dialogue in Dialogue::ALL {
            assert!(Labels::of(dialogue).surface.title.contains("444"), "{dialogue}");
        }
    }
}
