//! From the form of a correction to the entry that makes it. The old entry stays as it is, and both are seen.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::Message;
use fitcheck_core::probing::Origin;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::entry::{About, Check, Checked, Content, Entry};

use super::{RecordRow, RecordsField, RecordsPage};
use crate::recording::{Recorded, correcting};
use crate::shared::{News, Shared};
use crate::state::PageState as _;
use crate::texts::Range;

/// The correction that is being made.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Correcting {
    /// Whether the record is taken back, and nothing put in its place.
    pub withdraws: bool,
    /// Whether it is being written: the number of its batch.
    pub run: Option<u64>,
    /// The entry that is being written.
    pub(super) entry: Option<Box<Entry>>,
    /// Why it was not written.
    pub problem: Option<Message>,
}

type Refusal = (RecordsField, Message);

impl RecordsPage {
    /// Whether the open record can be corrected: a check that no other entry corrects or takes back.
    pub fn can_correct(&self) -> bool {
        self.opened_row().is_some_and(|row| {
            row.corrected_by.is_none() && row.entry.as_ref().is_ok_and(|entry| entry.check().is_some())
        })
    }

    /// The record that the open one corrects: with it withdrawn, neither stands.
    pub fn corrects(&self) -> Option<u64> {
        Some(self.opened_row()?.entry.as_ref().ok()?.corrects()?.target.number)
    }

    /// The typed value of the open record, where it was typed and can be typed again.
    pub fn typed_value(&self) -> Option<Length> {
        let record = size(self.opened_row()?)?;
        let measured = record.correction.map_or(record.measurement.diameter, |correction| correction.measured);
        (record.measurement.origin == Origin::Typed).then_some(measured)
    }

    /// Opens the form with what the record says, or closes it.
    pub(super) fn correct(&mut self, is_open: bool) {
        self.correcting = None;
        for field in [RecordsField::Reason, RecordsField::Measured] {
            self.texts.remove(&field);
            self.errors.remove(&field);
        }
        if !is_open || !self.can_correct() {
            return;
        }
        let Some(Ok(about)) = self.opened_row().map(|row| row.entry.as_ref().map(|entry| entry.about.clone())) else {
            return;
        };
        let About { part, serial, feature, who, remark, .. } = about;
        let texts = [
            (RecordsField::Part, part),
            (RecordsField::Serial, serial),
            (RecordsField::Feature, feature),
            (RecordsField::Measurer, who),
            (RecordsField::Remark, remark),
        ];
        self.texts.extend(texts);
        let typed = self.typed_value().map(|value| (RecordsField::Measured, value.to_string()));
        self.texts.extend(typed);
        self.correcting = Some(Correcting::default());
    }

    /// Whether the correction takes the record back.
    pub(super) const fn withdraw(&mut self, withdraws: bool) {
        if let Some(correcting) = &mut self.correcting {
            correcting.withdraws = withdraws;
        }
    }

    /// Sends the correction to the journal; what is missing is said beside its field.
    pub(super) fn send_correction(&mut self, shared: &mut Shared) {
        let Some(form) = self.correcting.clone().filter(|form| form.run.is_none()) else { return };
        match self.correction(&form) {
            Ok((about, content)) => {
                let entry = Some(Box::new(Entry { about: about.clone(), content: content.clone() }));
                let (run, problem) = match shared.recording.keep_correction(about, content) {
                    Ok(run) => (Some(run), None),
                    Err(problem) => (None, Some(problem)),
                };
                self.correcting = Some(Correcting { run, entry, problem, ..form });
            }
            Err((field, problem)) => _ = self.errors.insert(field, problem),
        }
    }

    /// The entry that the form asks for.
    fn correction(&self, form: &Correcting) -> Result<(About, Content), Refusal> {
        let row = self.opened_row().cloned();
        let reason = self.text(RecordsField::Reason).trim();
        let refused = |field, id| (field, Message::new(id));
        if reason.is_empty() {
            return Err(refused(RecordsField::Reason, "records-page-no-reason"));
        }
        let row = row.ok_or_else(|| refused(RecordsField::Reason, "records-page-not-open"))?;
        let entry = row.entry.as_ref().map_err(|problem| (RecordsField::Reason, problem.clone()))?;
        let correction = correcting(row.head, reason);
        if form.withdraws {
            return Ok((entry.about.clone(), Content::Withdrawal(correction)));
        }
        let text = |field: RecordsField| self.text(field).trim().to_owned();
        let about = About {
            part: text(RecordsField::Part),
            serial: text(RecordsField::Serial),
            feature: text(RecordsField::Feature),
            who: text(RecordsField::Measurer),
            remark: text(RecordsField::Remark),
            ..entry.about.clone()
        };
        let check = entry.check().ok_or_else(|| refused(RecordsField::Reason, "records-page-not-open"))?;
        let what = match &check.what {
            Checked::Cycle(_) => check.what.clone(),
            Checked::Size(record) => Checked::Size(Arc::new(self.corrected(record, &about)?)),
        };
        let is_same = about == entry.about && what == check.what;
        if is_same {
            return Err(refused(RecordsField::Reason, "records-page-nothing-changed"));
        }
        let check = Check { what, files: check.files.clone(), corrects: Some(correction) };
        Ok((about, Content::Check(Box::new(check))))
    }

    /// The record with the name and the typed value of the form, judged by its own rule.
    fn corrected(&self, record: &Record, about: &About) -> Result<Record, Refusal> {
        let id = if about.feature.is_empty() { about.part.clone() } else { about.feature.clone() };
        let record = Record { id, ..record.clone() };
        let Some(before) = self.typed_value() else { return Ok(record) };
        let typed = Range::AboveZero.read(self.text(RecordsField::Measured));
        let typed = typed.map_err(|problem| (RecordsField::Measured, problem))?;
        let again = (typed != before).then(|| record.typed_again(typed)).flatten();
        Ok(again.unwrap_or(record))
    }

    /// The journal has answered: the form closes, and the new record is opened; or it says why nothing was written.
    pub(super) fn correction_kept(&mut self, run: u64, shared: &mut Shared) {
        let Some(form) = self.correcting.as_mut().filter(|form| form.run == Some(run)) else { return };
        match shared.recording.of_slip((run, 0)) {
            Some(Recorded::Kept(number)) => {
                let old = self.open.as_ref().map(|open| open.number);
                let entry = form.entry.take();
                self.correct(false);
                if let Some(old) = old {
                    self.listing.forget(old);
                    self.chosen.remove(&old);
                    // Nor does the check page show or report it any more.
                    if let Some(id) = shared.recording.check_of(old) {
                        shared.history.take_out(id);
                    }
                    let by = entry.filter(|entry| entry.check().is_some()).map(|entry| Box::new((number, *entry)));
                    shared.spread(News::TakenBack { number: old, by });
                }
                self.ask(shared, false);
                let effects = self.open(number);
                self.errands.extend(effects);
            }
            Some(Recorded::Failed(problem)) => form.problem = Some(problem.clone()),
            Some(Recorded::Waiting) | None => {}
        }
    }
}

/// The check of a size in a row.
fn size(row: &RecordRow) -> Option<&Arc<Record>> {
    match &row.entry.as_ref().ok()?.check()?.what {
        Checked::Size(record) => Some(record),
        Checked::Cycle(_) => None,
    }
}
