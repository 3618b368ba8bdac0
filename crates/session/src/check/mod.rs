//! The check page: one part against its limits.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `choices` | what is chosen beside them |
//! | `asked` | what the texts mean: callout, limits, errors beside their fields |
//! | `doubted` | texts that may not mean what they say, and those that do |
//! | `measuring` | from the fields to a measurement |
//! | `afterwards` | hole or shaft, said after the verdict |
//! | `operating` | what is other for an operator |
//! | `importing` | from a file to checks and the notice about it |
//! | `scanned` | a code in the field of the value |
//! | `worth` | the rule that judges it, its uncertainty, its temperature |
//! | `inputs` | what a check was made with, besides callout and value |
//! | `lot` | the rows of an imported file: how many are what, worst first |

mod actions;
mod afterwards;
mod apply;
mod asked;
mod choices;
mod command;
mod doubted;
mod field;
mod importing;
mod inputs;
mod lot;
mod measuring;
mod operating;
mod rows;
mod scanned;
mod worth;

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::Message;
use fitcheck_core::part::Column;
use fitcheck_core::tolerance::{Callout, Feature, Sources};
use fitcheck_core::verdict::Doubt;
use fitcheck_core::verdict::rules::RuleName;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::query::RecordId;
use fitcheck_nc::control::simulated::marked;

pub use actions::{CheckAction, HISTORY, ROWS};
pub use asked::CheckInputs;
pub(super) use asked::{class_text, nominal_text};
pub use choices::{MeasureBy, RuleChoice, UncertaintyFrom};
pub use command::CheckCommand;
pub use doubted::DoubtedText;
pub use field::CheckField;
pub use lot::Lot;
pub use worth::{RuleFields, rule_name_id};

use self::doubted::Meant;
use self::inputs::Inputs;
use super::asking::Asking;
use super::effect::Effect;
use super::gauges::FromGauge;
use super::recording::Named;
use super::rows::Rows;
use super::saved::SavedInputs;
use super::texts::{KeptField as _, Texts};
use crate::state::PageState as _;

/// A record that is shown, and what the mask makes of it.
#[derive(Debug, Clone)]
pub struct ShownCheck {
    pub record: Arc<Record>,
    /// Its number in the history; `None` where it is not in it.
    pub id: Option<RecordId>,
    /// The status window's text, or why the mask cannot be drawn.
    pub window: Result<String, Message>,
}

/// A typed value that may not be what it seems to be: it is asked about before it is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Question {
    /// The typed value.
    pub measured: Length,
    /// What is strange about it.
    pub doubt: Doubt,
}

/// The state of the check page.
#[derive(Debug, Default)]
#[expect(clippy::struct_excessive_bools, reason = "each answers another question about the page")]
pub struct CheckPage {
    texts: Texts<CheckField>,
    /// Where the next measurement comes from.
    pub by: MeasureBy,
    /// Hole or shaft, and the callout that was meant: another one is asked about anew. Without one it is that of the first callout.
    feature: Option<(Option<Callout>, Feature)>,
    judging: RuleChoice,
    /// How the user wants the next part to be judged, while a shown record's own stands in its place.
    own_judging: Option<RuleChoice>,
    /// How the uncertainty was told before a budget took its place, until somebody chooses.
    before_budget: Option<UncertaintyFrom>,
    /// What the fields mean.
    pub asked: CheckInputs,
    /// The record that is shown, if any. It always belongs to what stands in the fields: any edit takes it away.
    pub shown: Option<ShownCheck>,
    /// The record whose limits are on screen: it may come from tables that are no longer used, or from a log without a
    /// callout. Limits of the latter stay after its verdict is gone.
    lent: Option<Arc<Record>>,
    /// The user's own texts of the fields that hold what a shown record was made with: they are the next part's.
    own: BTreeMap<CheckField, String>,
    inputs: Inputs,
    /// Why the last simulation was refused, until something is changed.
    pub refusal: Option<Message>,
    /// Whether the typed diameter was measured already: a new callout empties its field.
    measured_is_used: bool,
    /// Whether Enter came once more for a check that is shown already.
    pub is_repeated: bool,
    /// The gauge that the measured value in its field is from.
    pub gauge: Option<FromGauge>,
    /// When a typed value was judged last.
    judged: Asking,
    /// What is asked about the typed value before it is judged.
    pub question: Option<Question>,
    /// The doubted texts that are meant.
    meant: Meant,
    /// Whether a doubted text is asked about.
    asks: bool,
    /// The file that was imported last, while one of its rows or none is shown.
    pub lot: Option<Lot>,
    /// The rows of a large file.
    pub rows: Option<Rows>,
    /// Whether they stand in the place of the history.
    shows_rows: bool,
    /// How many runs over large files there were.
    runs: u64,
    /// What has to be done outside because of what happened elsewhere.
    errands: Vec<Effect>,
}

impl CheckPage {
    /// The page with what was saved, or with empty fields.
    pub(super) fn new(saved: &SavedInputs, sources: &Sources) -> Self {
        let texts = Texts::restored(&saved.texts);
        let by = saved.by;
        let judging = saved.judging;
        let asked = CheckInputs::read(&texts, None, judging, sources, &Meant::default());
        Self { texts, by, judging, asked, ..Self::default() }
    }

    /// The texts that are kept: the user's own, without a value that was judged. A forgotten filter would hide checks
    /// after the next start.
    pub(super) fn texts(&self) -> Vec<(String, String)> {
        let mut texts = self.texts.clone();
        for (field, text) in &self.own {
            texts.set(*field, text.clone());
        }
        let filters = [CheckField::HistoryFilter, CheckField::RowsFilter].map(|field| field.declared().0);
        let (measured, _) = CheckField::Measured.declared();
        let is_judged = self.measured_is_used;
        let is_kept = |key: &str| !(filters.contains(&key) || is_judged && key == measured);
        texts.saved().filter(|(key, _)| is_kept(key)).collect()
    }

    /// What the user names beside the next check, whatever a shown one lent.
    pub(super) fn named(&self) -> Named {
        let own = |field: CheckField| {
            let text = self.own.get(&field).map_or_else(|| self.text(field), String::as_str);
            text.trim().to_owned()
        };
        let [part, serial, remark] = [CheckField::Part, CheckField::Serial, CheckField::Remark].map(own);
        Named { part, serial, remark, ..Named::default() }
    }

    /// What a control could measure: the callout, and where it is, as cells of a plan.
    pub(super) fn for_set(&self) -> (String, Vec<(Column, String)>) {
        let typed = || self.text(CheckField::Callout).trim().to_owned();
        let callout = self.part_callout().map_or_else(typed, |callout| callout.to_string());
        let cell = |(column, field): (Column, CheckField)| {
            // What cannot be read is said as it was typed.
            let typed = || self.text(field).trim().to_owned();
            (column, self.asked.length(field).map_or_else(typed, |length| length.to_string()))
        };
        let cells = [
            (Column::X, CheckField::CentreX),
            (Column::Y, CheckField::CentreY),
            (Column::Z, CheckField::Height),
            (Column::Angle, CheckField::FirstAngle),
            (Column::Clearance, CheckField::Clearance),
        ];
        let says_it = self.part_callout().is_some_and(|callout| callout.feature().is_some());
        let chosen = self.feature().filter(|_| !says_it).map(|feature| (Column::Feature, feature.word().to_owned()));
        (callout, cells.map(cell).into_iter().chain(chosen).collect())
    }

    /// How the next part is judged, for the state file.
    pub(super) fn own_judging(&self) -> RuleChoice {
        self.own_judging.unwrap_or(self.judging)
    }

    /// Hole or shaft, where the callout does not say it.
    pub fn feature(&self) -> Option<Feature> {
        self.feature.map(|(_, feature)| feature)
    }

    /// Whether what stands in the fields was judged already, and nothing was entered since: Enter is no second measurement.
    pub const fn would_repeat(&self) -> bool {
        matches!(self.by, MeasureBy::Typing) && self.measured_is_used && self.shown.is_some()
    }

    /// Whether somebody is typing a measured value.
    pub(super) fn is_being_typed(&self) -> bool {
        self.gauge.is_none() && !self.measured_is_used && !self.text(CheckField::Measured).trim().is_empty()
    }

    /// Says that it was asked for once more.
    pub(super) const fn say_repeated(&mut self) {
        self.is_repeated = self.would_repeat();
    }

    /// The text that is asked about before anything is judged.
    pub fn doubted(&self) -> Option<&DoubtedText> {
        self.asked.doubted.as_ref().filter(|_| self.asks)
    }

    /// Whether the next part is judged by more than its limits: the rows of a large file are not.
    pub fn judges_by_more_than_limits(&self) -> bool {
        let temperature = self.own.get(&CheckField::PartTemperature);
        let temperature = temperature.map_or_else(|| self.text(CheckField::PartTemperature), String::as_str);
        self.own_judging().rule != RuleName::Simple || !temperature.trim().is_empty()
    }

    /// The status window's text as it leaves the program, where there is one: below a mark where nobody measured.
    pub fn status_text(&self) -> Option<String> {
        let shown = self.shown.as_ref()?;
        let text = shown.window.as_deref().ok()?;
        Some(marked(text, shown.record.measurement.origin.is_simulated()))
    }

    /// The callout of the part that is judged: one side of a fit.
    fn part_callout(&self) -> Option<Callout> {
        let callout = self.asked.callout?;
        Some(self.feature().map_or(callout, |feature| callout.of_part(feature)))
    }
}
