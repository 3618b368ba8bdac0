//! The check page: one part against its limits.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `asked` | what the texts mean: callout, limits, errors beside their fields |
//! | `measuring` | from the fields to a measurement |

mod apply;
mod asked;
mod command;
mod field;
mod measuring;

use std::ops::Range;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

pub use asked::Asked;
pub(super) use asked::{class_text, nominal_text};
pub use command::CheckCommand;
pub use field::CheckField;

use super::field::Texts;
use super::saved::SavedInputs;
use crate::journal::Record;
use crate::message::Message;
use crate::tolerance::{Callout, Feature, Sources};

/// Where the next measurement comes from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum MeasureBy {
    /// A cycle on the simulated workpiece.
    #[default]
    Simulating,
    /// A diameter that is typed.
    Typing,
}

/// A record that is shown, and what the mask makes of it.
#[derive(Debug, Clone)]
pub struct Shown {
    /// The record.
    pub record: Arc<Record>,
    /// The status window's text, or why the mask cannot be drawn.
    pub window: Result<String, Message>,
}

/// The state of the check page.
#[derive(Debug)]
pub struct CheckPage {
    texts: Texts<CheckField>,
    by: MeasureBy,
    /// Hole or shaft, where the callout does not say it.
    feature: Option<Feature>,
    asked: Asked,
    shown: Option<Shown>,
    /// Whether the typed diameter was measured already: a new callout empties its field.
    measured_is_used: bool,
}

impl CheckPage {
    /// The page with what was saved, or with empty fields.
    pub(super) fn new(saved: &SavedInputs, sources: &Sources) -> Self {
        let (texts, by, feature) = (Texts::restored(&saved.texts), saved.by, saved.feature);
        let asked = Asked::read(&texts, feature, sources);
        Self { texts, by, feature, asked, shown: None, measured_is_used: false }
    }

    pub(super) fn texts(&self) -> impl Iterator<Item = (String, String)> {
        self.texts.saved()
    }

    /// The text of a field.
    pub fn text(&self, field: CheckField) -> &str {
        self.texts.text(field)
    }

    /// What is wrong with a field.
    pub fn error(&self, field: CheckField) -> Option<&Message> {
        self.asked.error(field)
    }

    /// Where in a field's text an error shows: characters counted from 0.
    pub fn culprit(&self, field: CheckField) -> Option<&Range<usize>> {
        self.asked.culprit().filter(|_| field == CheckField::Callout)
    }

    /// What the fields mean.
    pub const fn asked(&self) -> &Asked {
        &self.asked
    }

    /// Where the next measurement comes from.
    pub const fn by(&self) -> MeasureBy {
        self.by
    }

    /// Hole or shaft, where the callout does not say it.
    pub const fn feature(&self) -> Option<Feature> {
        self.feature
    }

    /// The record that is shown, if any. It always belongs to the limits on screen.
    pub const fn shown(&self) -> Option<&Shown> {
        self.shown.as_ref()
    }

    /// The status window's text, where there is one.
    pub fn status_text(&self) -> Option<&str> {
        self.shown.as_ref()?.window.as_deref().ok()
    }

    /// The callout of the part that is judged: one side of a fit.
    fn part_callout(&self) -> Option<Callout> {
        let callout = self.asked.callout()?;
        Some(self.feature.map_or(callout, |feature| callout.of_part(feature)))
    }
}
