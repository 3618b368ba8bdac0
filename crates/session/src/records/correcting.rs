//! From the form of a correction to the entry that makes it: value and callout, or who and what it was. One entry takes the old one back,
//! gives the reason and stands in its place; the old one stays as it is, and both are seen.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::Origin;
use fitcheck_core::tolerance::{Callout, Feature, Limits};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::journal::entry::{About, Check, Checked, Content, Entry};
use fitcheck_exchange::journal::query::RecordId;

use super::{RecordRow, RecordsField, RecordsPage};
use crate::check::CheckField;
use crate::effect::Effect;
use crate::page::Page;
use crate::recording::{Named, Recorded, correcting};
use crate::shared::{News, Shared};
use crate::state::PageState as _;
use crate::texts::Range;

/// The correction that is being made.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Correcting {
    /// Whether the record is taken back, and nothing put in its place.
    pub withdraws: bool,
    /// What the callout in the form means now; of a record without a size there is none.
    pub asked: Option<(Option<Callout>, Limits)>,
    /// Hole or shaft, where the callout does not say it.
    pub feature: Option<Feature>,
    /// Whether it is being written: the number of its batch.
    pub run: Option<u64>,
    /// Why it was not written.
    pub problem: Option<Message>,
}

/// An entry that corrects another one, on its way to the journal.
#[derive(Debug)]
pub(super) struct Replacing {
    old: Arc<RecordRow>,
    entry: Entry,
    /// Whether it takes a correction back.
    is_undo: bool,
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

    /// The check of a size in the open record.
    pub fn opened_size(&self) -> Option<&Arc<Record>> {
        size(self.opened_row()?.entry.as_ref().ok()?)
    }

    /// The typed value of the open record, where it was typed and can be typed again.
    pub fn typed_value(&self) -> Option<Length> {
        let record = self.opened_size()?;
        (record.measurement.origin == Origin::Typed).then(|| record.measured())
    }

    /// Opens a record with the form of its correction, as soon as it is read.
    pub(super) fn correct_number(&mut self, number: u64, shared: &mut Shared) -> Vec<Effect> {
        let effects = self.open(number);
        self.corrects_soon = true;
        self.correct_now(shared);
        effects
    }

    /// Opens the form that was asked for, where its record is read.
    pub(super) fn correct_now(&mut self, shared: &mut Shared) {
        if self.corrects_soon && self.opened_row().is_some() {
            self.correct(true, shared);
        }
    }

    /// Opens the form with what the record says, or closes it.
    pub(super) fn correct(&mut self, is_open: bool, shared: &mut Shared) {
        let was_open = self.correcting.take().is_some();
        self.corrects_soon = false;
        for field in [RecordsField::Reason, RecordsField::Measured, RecordsField::Callout] {
            self.texts.remove(&field);
            self.errors.remove(&field);
        }
        if !is_open || !self.can_correct() {
            if was_open && shared.page == Page::Check {
                self.errands.push(Effect::Focus(CheckField::Measured.into()));
            }
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
        let typed = self.typed_value();
        self.texts.extend(typed.map(|value| (RecordsField::Measured, shared.as_typed(&value.to_string()))));
        let mut form = Correcting::default();
        if let Some(record) = self.opened_size().map(Arc::clone) {
            let callout = record.callout.map_or_else(String::new, |callout| callout.to_string());
            self.texts.insert(RecordsField::Callout, callout);
            form.feature = record.limits.feature;
            form.asked = Some((record.callout, record.limits.clone()));
        }
        let first = match (typed, &form.asked) {
            (Some(_), _) => RecordsField::Measured,
            (None, Some(_)) => RecordsField::Callout,
            (None, None) => RecordsField::Reason,
        };
        self.errands.push(Effect::Focus(first.into()));
        self.correcting = Some(form);
        // No verdict stays beside other inputs.
        shared.spread(News::Correcting);
    }

    /// Whether the correction takes the record back.
    pub(super) const fn withdraw(&mut self, withdraws: bool) {
        if let Some(correcting) = &mut self.correcting {
            correcting.withdraws = withdraws;
        }
    }

    /// Says whether a hole or a shaft is meant.
    pub(super) fn mean(&mut self, feature: Feature, shared: &Shared) {
        if let Some(correcting) = &mut self.correcting {
            correcting.feature = Some(feature);
        }
        self.read_callout(shared);
    }

    /// The callout in the form.
    pub fn corrected_callout(&self) -> Option<Callout> {
        self.text(RecordsField::Callout).parse().ok()
    }

    /// Reads the callout of the form: the record's own keeps its limits, whichever tables are used now.
    pub(super) fn read_callout(&mut self, shared: &Shared) {
        let Some(record) = self.opened_size().map(Arc::clone) else { return };
        let Some(feature) = self.correcting.as_ref().map(|form| form.feature) else { return };
        let text = self.text(RecordsField::Callout).trim().to_owned();
        let is_own = record.callout.map_or_else(String::new, |callout| callout.to_string()) == text
            && feature.is_none_or(|feature| Some(feature) == record.limits.feature);
        let asked = if is_own { Ok((record.callout, record.limits.clone())) } else { asked(&text, feature, shared) };
        self.errors.remove(&RecordsField::Callout);
        let asked = asked.map_err(|problem| self.errors.insert(RecordsField::Callout, problem)).ok();
        if let Some(form) = &mut self.correcting {
            form.asked = asked;
        }
    }

    /// Sends the correction to the journal; what is missing is said beside its field.
    pub(super) fn send_correction(&mut self, shared: &mut Shared) {
        let Some(form) = self.correcting.clone().filter(|form| form.run.is_none()) else { return };
        match self.correction(&form) {
            Ok((old, entry)) => {
                let sent = self.replace(Replacing { old, entry, is_undo: false }, shared);
                let (run, problem) = (sent.as_ref().ok().copied(), sent.err());
                self.correcting = Some(Correcting { run, problem, ..form });
            }
            Err((field, problem)) => {
                self.errors.insert(field, problem);
                // What is typed next is what was missing.
                self.errands.push(Effect::Focus(field.into()));
            }
        }
    }

    fn replace(&mut self, replacing: Replacing, shared: &mut Shared) -> Result<u64, Message> {
        let Entry { about, content } = replacing.entry.clone();
        let run = shared.recording.keep_correction(about, content)?;
        self.replacing.insert(run, replacing);
        Ok(run)
    }

    /// The entry that the form asks for.
    fn correction(&self, form: &Correcting) -> Result<(Arc<RecordRow>, Entry), Refusal> {
        let reason = self.text(RecordsField::Reason).trim();
        let refused = |field, id| (field, Message::new(id));
        let row = self.opened_row().ok_or_else(|| refused(RecordsField::Reason, "records-page-not-open"))?;
        let entry = row.entry.as_ref().map_err(|problem| (RecordsField::Reason, problem.clone()))?;
        let check = entry.check().ok_or_else(|| refused(RecordsField::Reason, "records-page-not-open"))?;
        let text = |field: RecordsField| self.text(field).trim().to_owned();
        let about = About {
            part: text(RecordsField::Part),
            serial: text(RecordsField::Serial),
            feature: text(RecordsField::Feature),
            who: text(RecordsField::Measurer),
            remark: text(RecordsField::Remark),
            ..entry.about.clone()
        };
        let what = match &check.what {
            _ if form.withdraws => None,
            Checked::Cycle(_) => Some(check.what.clone()),
            Checked::Size(record) => Some(Checked::Size(Arc::new(self.corrected(record, &about, form)?))),
        };
        if reason.is_empty() {
            return Err(refused(RecordsField::Reason, "records-page-no-reason"));
        }
        let correction = correcting(row.head, reason);
        let Some(what) = what else {
            let content = Content::Withdrawal(correction);
            return Ok((Arc::clone(row), Entry { about: entry.about.clone(), content }));
        };
        if about == entry.about && what == check.what {
            return Err(refused(RecordsField::Reason, "records-page-nothing-changed"));
        }
        let check = Check { what, files: check.files.clone(), corrects: Some(correction) };
        Ok((Arc::clone(row), Entry { about, content: Content::Check(Box::new(check)) }))
    }

    /// The record with the name, the callout and the typed value of the form, judged by its own rule.
    fn corrected(&self, record: &Record, about: &About, form: &Correcting) -> Result<Record, Refusal> {
        let id = if about.feature.is_empty() { about.part.clone() } else { about.feature.clone() };
        let mut record = Record { id, ..record.clone() };
        if let Some(before) = self.typed_value() {
            let typed = Range::AboveZero.read(self.text(RecordsField::Measured));
            let typed = typed.map_err(|problem| (RecordsField::Measured, problem))?;
            let again = (typed != before).then(|| record.typed_again(typed)).flatten();
            record = again.unwrap_or(record);
        }
        let Some((callout, limits)) = form.asked.clone() else {
            let problem = self.errors.get(&RecordsField::Callout).cloned();
            let problem = problem.unwrap_or_else(|| Message::new("measured-needs-limits"));
            return Err((RecordsField::Callout, problem));
        };
        let is_same = (&callout, &limits) == (&record.callout, &record.limits);
        Ok(if is_same { record } else { record.asked_again(callout, limits) })
    }

    /// The journal has answered: the form closes, and the new record is opened; or it says why nothing was written.
    pub(super) fn correction_kept(&mut self, run: u64, shared: &mut Shared) {
        let number = match shared.recording.of_slip((run, 0)) {
            Some(Recorded::Kept(number)) => number,
            Some(Recorded::Failed(problem)) => {
                let problem = problem.clone();
                if let Some(form) = self.correcting.as_mut().filter(|form| form.run == Some(run)) {
                    form.problem = Some(problem);
                }
                return;
            }
            Some(Recorded::Waiting) | None => return,
        };
        let Some(Replacing { old, entry, is_undo }) = self.replacing.remove(&run) else { return };
        if self.correcting.as_ref().is_some_and(|form| form.run == Some(run)) {
            self.correct(false, shared);
        }
        let target = old.head.number;
        self.listing.forget(target);
        self.chosen.remove(&target);
        // The check page strikes it through, and reports it no more.
        if let Some(id) = shared.recording.check_of(target) {
            let part = &entry.about.part;
            let named =
                |record: &Arc<Record>| if record.id.is_empty() { record.called(part) } else { Arc::clone(record) };
            let new = shared.history.replace(id, number, size(&entry).map(named));
            if let Some(new) = new {
                shared.recording.know_correction(new, run, Named::of_entry(&entry.about));
                if let (false, Ok(before)) = (is_undo, &old.entry) {
                    shared.history.can_undo_correction(new);
                    self.before.insert(new, before.clone());
                }
            }
        }
        let by = entry.check().is_some().then(|| Box::new((number, entry.clone())));
        shared.spread(News::TakenBack { number: target, by });
        self.ask(shared, false);
        let effects = self.open(number);
        self.errands.extend(effects);
    }

    /// Undo takes a correction back: what stood before it stands again, as an entry of its own.
    pub(super) fn undo_correction(&mut self, new: RecordId, shared: &mut Shared) {
        let Some(entry) = self.before.remove(&new) else { return };
        let Content::Check(check) = entry.content.clone() else { return };
        let Some(corrected) = Self::standing(new, shared) else {
            return shared.tell(message!("records-page-undo-void"));
        };
        let reason = shared.recorded_words().get("records-page-undone");
        let check = Check { corrects: Some(correcting(corrected, &reason)), ..*check };
        let replaced = Entry { about: entry.about.clone(), content: Content::Check(Box::new(check)) };
        let old = RecordRow { head: corrected, entry: Ok(entry), corrected_by: None, went_back: false };
        let replacing = Replacing { old: Arc::new(old), entry: replaced, is_undo: true };
        if let Err(problem) = self.replace(replacing, shared) {
            shared.tell(problem);
        }
    }

    /// What stands now in the place of a corrected check: it may have been corrected again. `None` where it was taken back.
    fn standing(id: RecordId, shared: &Shared) -> Option<Head> {
        let mut standing = id;
        while let Some(number) = shared.history.replaced_by(standing) {
            standing = shared.recording.check_of(number)?;
        }
        shared.recording.head_of(standing)
    }
}

/// The part of a callout that is judged, and its limits.
fn asked(text: &str, feature: Option<Feature>, shared: &Shared) -> Result<(Option<Callout>, Limits), Message> {
    let callout: Callout = text.parse().map_err(|error: fitcheck_core::tolerance::CalloutError| error.message())?;
    let limits = shared.sources.limits(&callout, callout.feature().or(feature)).map_err(|error| error.message())?;
    Ok((Some(callout.of_part(limits.feature)), limits))
}

/// The check of a size in an entry.
fn size(entry: &Entry) -> Option<&Arc<Record>> {
    match &entry.check()?.what {
        Checked::Size(record) => Some(record),
        Checked::Cycle(_) => None,
    }
}
