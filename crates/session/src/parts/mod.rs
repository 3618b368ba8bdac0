//! The parts page: a plan of the features of a part, and the walk through them.
//!
//! | file | what |
//! |---|---|
//! | here | the page: which of its two views is open |
//! | `document` | the plan: a draft that is edited, the file that holds it, undo and redo, and what is wrong with it |
//! | `sheet`, `editing`, `draft_cells`, `rows`, `pasting`, `paste`, `sorting` | its table: where the keys are, and what can be done there |
//! | `picture` | the part's picture and the balloons on it |
//! | `walking` | the part that is being measured: which size is asked for, what was measured |
//! | `measuring`, `judging`, `serials` | what is done on the walk; a value becomes a check; serial numbers are counted up |
//! | `ending` | a part begins, and the next one comes |
//! | `arriving`, `watched`, `watch_news` | values from files; a folder that is watched |
//! | `resume`, `planned` | an interrupted part comes back, as far as its plan asks for the same |
//! | `alarms`, `alarm_search`, `alarms_found` | rules of control charts that fire at a value, and the answers to them |
//! | `reporting` | the part as a report |
//! | `headline`, `choices` | what one look is told; the words that a cell may have |
//! | `field`, `command`, `apply` | its text fields, what can be done, and how |

mod actions;
mod alarm_search;
mod alarms;
mod alarms_found;
mod apply;
mod arriving;
mod choices;
mod command;
mod document;
mod draft_cells;
mod editing;
mod ending;
mod field;
mod headline;
mod judging;
mod measuring;
mod paste;
mod pasting;
mod picture;
mod planned;
mod reporting;
mod resume;
mod rows;
mod serials;
mod sheet;
mod sorting;
mod walking;
mod watch_news;
mod watched;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::part::Plan;

pub use actions::{PLAN, PartsAction, SIZES};
pub use alarm_search::{AlarmSearch, NewestValue};
pub use alarms::{Alarms, OpenAlarm, choices};
pub use alarms_found::AlarmsFound;
pub use command::{PartsCommand, PlanCommand, WalkCommand};
pub use document::PlanDocument;
pub use field::{PartsField, PlanField, WalkField};
pub use headline::{FinishedPart, Headline};
pub use picture::{Balloon, PartPicture, PictureState};
pub use sheet::Sheet;
pub use walking::{Value, WalkRow, Walking};
pub use watch_news::{WatchNews, WatchedFile};
pub use watched::{TakenFile, Watched};

use self::resume::Resume;
use super::asking::Asking;
use super::document::OpenDocument;
use super::effect::Effect;
use super::gauges::FromGauge;
use super::program::PlanForSet;
use crate::texts::Texts;

/// The views of the page.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum PartsView {
    /// The part is measured, feature by feature.
    #[default]
    Walk,
    /// The plan is edited.
    Plan,
}

impl PartsView {
    /// Both, in the order of the switch.
    pub const ALL: [Self; 2] = [Self::Walk, Self::Plan];
}

#[derive(Debug, Default)]
pub struct PartsPage {
    /// The open view.
    pub view: PartsView,
    /// Whether it is the open page.
    is_shown: bool,
    texts: Texts<WalkField>,
    errors: BTreeMap<WalkField, Message>,
    pub document: OpenDocument<PlanDocument>,
    /// The table of the plan.
    pub sheet: Sheet,
    shown: picture::PlanPicture,
    walk_picture: Option<picture::WalkPicture>,
    /// The part that is being measured.
    pub walking: Walking,
    asking: Asking,
    /// The gauge that the value in its field is from.
    pub gauge: Option<FromGauge>,
    /// The parts that were measured since the window was opened, by their names and serial numbers.
    ended: BTreeSet<(String, String)>,
    /// The serial number that is to be begun once more, after the question about it.
    again: Option<String>,
    /// The serial number that was counted up from that of the last part.
    suggested: Option<String>,
    resume: Resume,
    /// The folder that is watched, and what came from it.
    pub watched: Watched,
    /// Alarms of control charts.
    pub alarms: Alarms,
    /// What has to be done outside because of what happened elsewhere.
    errands: Vec<Effect>,
}

impl PartsPage {
    /// The plan that a control could measure; `None` where none is open.
    pub(super) fn for_set(&self) -> Option<PlanForSet> {
        let document = &self.document;
        if document.is_empty() || document.is_blank() {
            return None;
        }
        let features = document.draft().rows.len();
        Some(PlanForSet { name: document.name(), features, plan: document.plan().cloned() })
    }

    /// The part that is measured, or else the one whose plan is open.
    pub(crate) fn part(&self) -> Option<&str> {
        let plan = self.walking.plan.as_ref().or_else(|| self.document.plan())?;
        Some(plan.head.part.as_str()).filter(|part| !part.is_empty())
    }

    /// Whether the plan was changed since the part was begun.
    pub fn has_other_plan(&self) -> bool {
        match (self.walking.plan.as_ref(), self.document.plan()) {
            (Some(own), Some(now)) => !Arc::ptr_eq(own, now) && own != now,
            (own, _) => own.is_some(),
        }
    }

    /// Whether another document is open than the plan by which the part is measured.
    pub fn is_other_open(&self) -> bool {
        let own = self.walking.path.as_deref();
        let is_same = self.walking.opened == self.document.opened || own.is_some() && own == self.document.path();
        self.walking.is_begun() && !is_same
    }

    /// Whether that has to be said before another value is typed.
    pub fn asks_which_plan(&self) -> bool {
        self.is_other_open() && self.walking.kept_on != self.document.opened
    }

    /// The names of the plan by which the part is measured and of the one that is open.
    pub fn both_plans(&self) -> [String; 2] {
        let part = |plan: Option<&Arc<Plan>>| plan.map_or_else(String::new, |plan| plan.head.part.clone());
        let own = self.walking.path.as_deref().map_or_else(|| part(self.walking.plan.as_ref()), name_of);
        let open = if self.document.path().is_some() { String::new() } else { part(self.document.plan()) };
        [own, if open.is_empty() { self.document.name() } else { open }]
    }

    /// The file of the plan by which the watched folder is judged, where another plan is open.
    pub fn watched_plan(&self) -> Option<String> {
        let path = self.watched.plan_path()?;
        (Some(path) != self.document.path()).then(|| name_of(path))
    }
}

/// The name of a file without its folder.
fn name_of(path: &std::path::Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
