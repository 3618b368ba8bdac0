//! Values from files: those of an import, and those that a watched folder brings.

use std::sync::Arc;

use super::PartsPage;
use super::judging::judged_by;
use super::measuring::Arriving;
use crate::exchange::{ByPlan, Item, Labels};
use crate::journal::Record;
use crate::journal::entry::{FileRole, UsedFile};
use crate::message::{Located, Message, Say as _};
use crate::part::Plan;
use crate::session::recording::used;
use crate::session::shared::{Notice, Shared};

/// What a file held.
#[derive(Debug, Default)]
pub(super) struct Arrived {
    /// Its checks.
    pub values: Vec<Arriving>,
    /// What found no feature or could not be used.
    pub problems: Vec<Message>,
    /// What is worth knowing.
    pub warnings: Vec<Message>,
    /// The serial numbers of other parts.
    pub others: Vec<String>,
}

impl PartsPage {
    /// Takes what a file holds into the part that is being measured.
    pub(super) fn imported(&mut self, name: &str, result: Result<Vec<Item>, Message>, shared: &mut Shared) {
        let Some(items) = shared.file_answered(result) else { return };
        let sha256 = shared.recording.of_file(name);
        // It was read for a part that has been ended meanwhile.
        let Some(plan) = self.walking.plan().map(Arc::clone) else {
            return shared.tell(Message::new("walk-page-import-late").text("name", name));
        };
        let mut by_plan = ByPlan::new(&plan);
        let mut judged = Vec::new();
        for item in items {
            by_plan.item(item, &mut |item| judged.push(item));
        }
        let arrived = self.arrive(&plan, judged, used(FileRole::Measurements, name, sha256).as_ref(), shared);
        let message = Message::new("walk-page-imported")
            .text("name", name)
            .count("good", arrived.values.len())
            .count("bad", arrived.problems.len());
        let is_problem = arrived.values.is_empty();
        let said = said_of_others(&arrived);
        let details = arrived.problems.iter().chain(&said).chain(&arrived.warnings).cloned().collect();
        let mut notice = Notice { details, ..Notice::of(message, is_problem) };
        shared.add_columns(&mut notice, name);
        shared.notices.push(notice);
        self.keep(arrived.values, shared);
        self.walking.stay_open();
    }

    /// What a plan made of a file, with the rule of the check page where the plan has none.
    pub(super) fn arrive(&self, plan: &Plan, items: Vec<Item>, file: Option<&UsedFile>, shared: &Shared) -> Arrived {
        let mut arrived = Arrived::default();
        let is_of_walk = self.walking.plan().is_some_and(|own| **own == *plan);
        for item in items {
            match item {
                Item::Record { line, record, labels } => match self.arriving(plan, *record, labels, shared) {
                    Ok(mut value) => {
                        value.file = file.cloned();
                        if !is_of_walk {
                            value.at = None;
                        }
                        if let Some(labels) = value.labels.as_deref().filter(|_| value.at.is_none())
                            && !labels.serial.is_empty()
                            && !arrived.others.contains(&labels.serial)
                        {
                            arrived.others.push(labels.serial.clone());
                        }
                        arrived.values.push(value);
                    }
                    Err(why) => {
                        let not = Message::new("walk-page-not-judged").text("line", line).message("why", why);
                        arrived.problems.push(not);
                    }
                },
                Item::Unjudged(unjudged) => {
                    arrived.problems.push(Located::in_line(unjudged.line, unjudged.why.clone()).message());
                }
                Item::Error(error) => arrived.problems.push(error.message()),
                Item::Warning(warning) => arrived.warnings.push(warning.message()),
                Item::Contacts(_) => {}
            }
        }
        arrived
    }

    fn arriving(&self, plan: &Plan, record: Record, labels: Labels, shared: &Shared) -> Result<Arriving, Message> {
        let size = plan.sizes().find(|size| size.name() == record.id);
        let size = size.ok_or_else(|| Message::new("walk-page-nothing-asked"))?;
        let (record, remarks) = judged_by(&size, record, shared)?;
        let is_own = labels.serial.is_empty() || labels.serial == self.walking.serial();
        let at = self.walking.place_of(&record.id).filter(|_| is_own);
        Ok(Arriving { at, record: Arc::new(record), remarks, labels: Some(Box::new(labels)), file: None })
    }
}

/// That some values are of other parts: they are recorded under their own serial numbers.
pub(super) fn said_of_others(arrived: &Arrived) -> Vec<Message> {
    /// The most serial numbers that are named.
    const MOST: usize = 10;
    if arrived.others.is_empty() {
        return Vec::new();
    }
    let named = arrived.others.iter().take(MOST).cloned().collect::<Vec<_>>().join(", ");
    let more = if MOST < arrived.others.len() { " …" } else { "" };
    vec![Message::new("walk-page-other-parts").text("serials", format!("{named}{more}"))]
}
