//! What a file of measurements does to the page: its rows or contacts are judged, listed and shown.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::measurement::measure_contacts;
use fitcheck_core::probing::{Contact, Origin};
use fitcheck_core::verdict::{AxisPosition, PositionVerdict, Status};
use fitcheck_exchange::exchange::Imported;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::entry::FileRole;
use jiff::civil::DateTime;

use super::measuring::{length, record};
use super::worth::RuleFields;
use super::{CheckField, CheckPage, Lot};
use crate::budget::OpenBudget;
use crate::help::Sample;
use crate::notice::Notice;
use crate::page::Page;
use crate::recording::used;
use crate::shared::Shared;
use crate::state::PageState as _;

impl CheckPage {
    /// What the user's own fields say, whatever a shown record lent them: it judges what a file holds.
    pub(crate) fn own_worth(&self) -> RuleFields {
        let mut texts = self.texts.clone();
        for (field, text) in &self.own {
            texts.set(*field, text.clone());
        }
        RuleFields::read(&texts, self.own_judging(), &mut |_, _| {})
    }

    /// Takes what a file holds into the history; contacts are judged by the limits on screen.
    pub(super) fn imported(
        &mut self,
        name: &str,
        result: Result<Box<Imported>, Message>,
        shared: &mut Shared,
        now: DateTime,
    ) {
        let Some(mut imported) = shared.file_answered(result) else { return };
        // The newest file is the one that is meant.
        self.errands.extend(self.rows.iter_mut().flat_map(|rows| rows.cancel(&shared.sources)));
        self.shows_rows = false;
        let sha256 = shared.recording.of_file(name);
        let file = used(FileRole::Measurements, name, sha256);
        let mut notice = import_notice(name, &imported);
        shared.add_columns(&mut notice, name);
        if let Some(contacts) = imported.contacts.take() {
            // Contacts are judged by what the user asked for, not by what an older check lent.
            self.edited(&shared.sources);
            match judge_contacts(name, &contacts, self, shared.budget.as_deref(), now) {
                Ok(record) => {
                    let record = Arc::new(record);
                    let id = shared.history.add(vec![Arc::clone(&record)]);
                    self.keep(id, (&[record], &[]), file.as_ref(), shared);
                    self.inputs.keep(id, &self.texts);
                    notice.change = shared.history.last_change();
                    self.show(id, shared);
                }
                Err(why) => {
                    notice.message = message!("import-contacts-not-judged").text("name", name);
                    notice.details.insert(0, why);
                    notice.is_problem = true;
                }
            }
            shared.notices.push(notice);
            return;
        }
        match judge_imported(&mut imported, &self.own_worth(), shared.budget.as_deref()) {
            Ok(said) => notice.details.extend(said),
            Err(why) => {
                notice.message = message!("import-not-judged").text("name", name);
                notice.details.insert(0, why);
                notice.is_problem = true;
                shared.notices.push(notice);
                return;
            }
        }
        if let Some(counts) = counts(&imported.records) {
            let of_rows = std::mem::replace(&mut notice.message, message!("import-counted"));
            notice.message = message!("import-counted").message("file", of_rows).message("counts", counts);
        }
        notice.page = Some(Page::Check);
        let is_sample = file.as_ref().is_some_and(|file| Sample::is_measured_in(&file.name, file.sha256));
        if is_sample {
            notice.details.push(message!("sample-not-recorded"));
        }
        shared.notices.push(notice);
        let records: Vec<_> = std::mem::take(&mut imported.records).into_iter().map(Arc::new).collect();
        shared.history.leave_out(left_out(name, &imported));
        let is_lot = 1 < imported.rows && !(records.is_empty() && imported.unjudged.is_empty());
        if !is_lot && records.is_empty() {
            return;
        }
        let lot = |first| Lot::new(name, &imported, &records, first);
        let first = shared.history.next();
        self.clear(&shared.sources);
        self.lot = is_lot.then(|| lot(first));
        if !records.is_empty() {
            shared.history.add(records.clone());
            shared.note_change();
            if !is_sample {
                self.keep(first, (&records, &imported.labels), file.as_ref(), shared);
            }
        }
        if is_lot {
            self.show_of_lot(shared);
        } else {
            self.show(first, shared);
        }
    }

    /// Shows the row of the lot that is chosen.
    pub(super) fn show_of_lot(&mut self, shared: &mut Shared) {
        if let Some(id) = self.lot.as_ref().and_then(Lot::record) {
            self.show(id, shared);
        }
    }
}

/// So many rows without a verdict are named on a report.
const MOST_LEFT_OUT: usize = 100;

/// Why rows have no verdict: a report of the list says it.
fn left_out(name: &str, imported: &Imported) -> Vec<Message> {
    let refused = imported
        .errors
        .iter()
        .map(|error| message!("report-note").text("place", name).message("what", error.message()));
    let unjudged = imported.unjudged.iter().map(|unjudged| {
        let place = message!("report-note-line").text("place", name).text("line", unjudged.line);
        place.message("what", unjudged.why.message())
    });
    let count = imported.errors.len() + imported.unjudged.len();
    let more = count.saturating_sub(MOST_LEFT_OUT);
    let more = (0 < more).then(|| message!("report-note-more").count("count", more));
    refused.chain(unjudged).take(MOST_LEFT_OUT).chain(more).collect()
}

/// How many rows have which verdict; nothing for one row, whose verdict is shown.
fn counts(records: &[Record]) -> Option<Message> {
    let count = |status| records.iter().filter(|record| record.verdict.status() == status).count();
    let told = [
        ("good", "is-good", Status::Good),
        ("rework", "is-rework", Status::Rework),
        ("again", "is-again", Status::ReMeasure),
        ("out", "is-out", Status::OutOfLimits),
        ("scrap", "is-scrap", Status::Scrap),
    ];
    let counts = told.into_iter().fold(message!("import-counts"), |said, (number, word, status)| {
        said.count(number, count(status)).message(word, status.message())
    });
    (1 < records.len()).then_some(counts)
}

/// The notice about an imported file: how many checks, and every row that could not be used.
fn import_notice(name: &str, imported: &Imported) -> Notice {
    let good = imported.records.len() + usize::from(imported.contacts.is_some());
    let message = message!("import-notice").text("name", name).count("good", good).count("bad", imported.errors.len());
    let problems = imported.errors.iter().map(fitcheck_core::message::Say::message);
    let unjudged =
        imported.unjudged.iter().filter(|_| imported.contacts.is_none()).map(|unjudged| unjudged.why.message());
    let warnings = imported.warnings.iter().map(fitcheck_core::message::Say::message);
    let details = problems.chain(unjudged).chain(warnings).collect();
    Notice { details, ..Notice::of(message, good == 0) }
}

/// Judges contacts from a file by the limits on screen.
fn judge_contacts(
    name: &str,
    contacts: &[Contact],
    page: &CheckPage,
    budget: Option<&OpenBudget>,
    now: DateTime,
) -> Result<Record, Message> {
    let asked = &page.asked;
    let limits = asked.limits.as_ref().ok_or_else(|| message!("measured-needs-limits"))?;
    let origin = Origin::Contacts { file: name.into() };
    let measurement = measure_contacts(contacts, origin).map_err(|error| error.message())?;
    // A position that cannot be read is refused: leaving it out would call a shifted feature good.
    let nominal = |field| length(asked, field).map_err(|(_, problem)| problem);
    let nominal_x = nominal(CheckField::CentreX)?;
    let nominal_y = nominal(CheckField::CentreY)?;
    let permitted = nominal(CheckField::CentreTolerance)?;
    let position = measurement.centre.map(|[x, y]| {
        let tolerance = (Length::ZERO < permitted).then_some(permitted);
        let axis = |is: Length, nominal| AxisPosition { deviation: is.saturating_sub(nominal), tolerance };
        PositionVerdict { axes: [axis(x, nominal_x), axis(y, nominal_y)] }
    });
    let record = record(page.text(CheckField::Part), asked, limits, (measurement, position), now);
    asked.worth.judge(record, budget).map_err(|(_, problem)| problem)
}

/// Judges what a file holds by the user's rule, and says so. Its values are taken as they are: at which temperature each was
/// measured is not known.
fn judge_imported(
    imported: &mut Imported,
    worth: &RuleFields,
    budget: Option<&OpenBudget>,
) -> Result<Vec<Message>, Message> {
    let mut said = Vec::new();
    let judged = std::mem::take(&mut imported.records).into_iter().map(|record| worth.judge(record, budget));
    imported.records = judged.collect::<Result<_, _>>().map_err(|(_, problem)| problem)?;
    if let Some(first) = imported.records.first() {
        let rule = first.verdict.rule;
        if !rule.is_plain() {
            said.push(message!("import-judged-by").message("rule", rule.rounded_message()));
            if imported.records.iter().any(|record| record.verdict.rule != rule) {
                said.push(message!("import-judged-by-each"));
            }
        }
        if worth.is_warm() {
            said.push(message!("import-not-corrected"));
        }
    }
    Ok(said)
}
