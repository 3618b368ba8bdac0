//! How commands and news change the check page.

use std::sync::Arc;

use jiff::civil::DateTime;

use super::{
    Asked, CheckCommand, CheckField, CheckPage, Lot, MeasureBy, Question, Shown, class_text, measuring, nominal_text,
};
use crate::exchange::Imported;
use crate::journal::query::RecordId;
use crate::journal::{Record, status_window};
use crate::message::{Message, Say as _};
use crate::probing::Origin;
use crate::session::command::{Effect, Page};
use crate::session::rows::Rows;
use crate::session::shared::{News, PageState, Shared};
use crate::tolerance::Sources;
use crate::words::Words;

impl PageState for CheckPage {
    type Command = CheckCommand;

    fn apply(&mut self, command: CheckCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        match command {
            CheckCommand::Type(CheckField::HistoryFilter, text) => {
                self.texts.set(CheckField::HistoryFilter, text);
                self.filter(shared);
            }
            CheckCommand::Type(field, text) => self.type_text(field, text, &shared.sources),
            CheckCommand::ChooseClass(class) => {
                let nominal = nominal_text(self.text(CheckField::Callout));
                self.take_callout(&format!("{nominal} {class}"), &shared.sources);
            }
            CheckCommand::ChooseFeature(feature) => {
                self.feature = Some(feature);
                self.callout_changed(false, &shared.sources);
            }
            CheckCommand::MeasureBy(by) if by == self.by => {}
            CheckCommand::MeasureBy(by) => {
                self.by = by;
                self.edited(&shared.sources);
            }
            CheckCommand::Measure => self.measure(shared, now),
            CheckCommand::TakeMeant => {
                if let Some(meant) = self.question.and_then(|question| question.doubt.meant()) {
                    self.texts.set(CheckField::Measured, meant.to_string());
                    self.edited(&shared.sources);
                    self.measure(shared, now);
                }
            }
            CheckCommand::Clear => {
                self.texts.set(CheckField::Measured, "");
                self.measured_is_used = false;
                self.clear(&shared.sources);
            }
            CheckCommand::CopyStatus => {
                return self.status_text().map(|text| Effect::Copy(text.to_owned())).into_iter().collect();
            }
            CheckCommand::Show(id) => {
                if !self.lot.as_mut().is_some_and(|lot| lot.go_to(id)) {
                    self.lot = None;
                }
                self.show(id, shared);
            }
            CheckCommand::ShowInLot(step) => {
                if let Some(lot) = &mut self.lot {
                    lot.step(step);
                    self.show_of_lot(shared);
                }
            }
            CheckCommand::Choose(id, is_chosen) => shared.history.choose(id, is_chosen),
            CheckCommand::List(command) => {
                let copied = shared.history.apply(command, shared.language);
                return copied.map(Effect::Copy).into_iter().collect();
            }
            CheckCommand::ClearHistory => {
                let count = shared.history.clear();
                if 0 < count {
                    self.clear(&shared.sources);
                    shared.note(Message::new("history-cleared").count("count", count), Vec::new());
                    shared.note_change();
                }
            }
            CheckCommand::Undo => self.undo(shared),
            CheckCommand::Imported { name, result } => self.imported(&name, result, shared, now),
            CheckCommand::Rows(command) => return self.apply_rows(command, shared, now),
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        match news {
            News::Sources => {
                self.callout_changed(true, &shared.sources);
                let errands = self.judge_again();
                self.errands.extend(errands);
            }
            News::StatusWindow => {
                self.filter(shared);
                if let Some(shown) = self.shown.take() {
                    self.draw(shown.record, shared);
                }
            }
            News::Check(callout) => self.take_callout(callout, &shared.sources),
            News::Opened(_)
            | News::OwnTables
            | News::Workpiece
            | News::WorkpieceTaken
            | News::ContactsTaken
            | News::PartTaken
            | News::Tools
            | News::Budget => {}
        }
    }
}

impl CheckPage {
    /// Lists what the filter says in the language of the window.
    fn filter(&self, shared: &mut Shared) {
        shared.history.filter(self.text(CheckField::HistoryFilter), &Words::new(shared.language));
    }

    /// Undoes the last change of the history, and closes the notice that tells of it. Where the list is not in sight, a
    /// notice says what was undone.
    fn undo(&mut self, shared: &mut Shared) {
        let change = shared.history.last_change();
        let Some(undone) = shared.history.take_back() else { return };
        self.clear(&shared.sources);
        shared.notices.retain(|notice| notice.change.is_none() || notice.change != change);
        if shared.page != Page::Check {
            shared.note(Message::new("undone").message("what", undone), Vec::new());
        }
    }

    fn type_text(&mut self, field: CheckField, text: String, sources: &Sources) {
        self.own.remove(&field);
        self.texts.set(field, text);
        match field {
            CheckField::Callout => return self.callout_changed(true, sources),
            CheckField::Nominal => {
                let (nominal, class) = (self.text(CheckField::Nominal), class_text(self.text(CheckField::Callout)));
                let callout = format!("{} {class}", nominal.trim());
                self.texts.set(CheckField::Callout, callout.trim());
                return self.callout_changed(false, sources);
            }
            CheckField::Measured => {
                self.by = MeasureBy::Typing;
                self.measured_is_used = false;
            }
            _ => {}
        }
        self.edited(sources);
    }

    /// Reads the fields anew. The limits are those of the record that lends them.
    fn read(&mut self, sources: &Sources) {
        self.asked = Asked::read(&self.texts, self.feature, sources);
        if let Some(record) = &self.lent {
            self.asked.show_limits(record.limits.clone(), record.callout);
        }
    }

    fn take_callout(&mut self, callout: &str, sources: &Sources) {
        self.texts.set(CheckField::Callout, callout.trim());
        self.callout_changed(true, sources);
    }

    /// No verdict stays beside limits that it was not made with.
    fn callout_changed(&mut self, nominal_follows: bool, sources: &Sources) {
        if nominal_follows {
            let nominal = nominal_text(self.text(CheckField::Callout)).to_owned();
            self.texts.set(CheckField::Nominal, nominal);
        }
        if self.measured_is_used {
            self.texts.set(CheckField::Measured, "");
            self.measured_is_used = false;
        }
        self.clear(sources);
        if self.asked.callout().is_some_and(|callout| callout.feature().is_some()) {
            // The next callout without letters asks again.
            self.feature = None;
        }
    }

    /// No verdict stays beside a value, a position or a name that it was not made with, and what it lent goes with it:
    /// the next value is judged by the source that is chosen now. Only limits without a callout stay, for the fields
    /// have no others.
    fn edited(&mut self, sources: &Sources) {
        (self.shown, self.question, self.lot, self.refusal) = (None, None, None, None);
        self.rows.iter_mut().for_each(Rows::hide);
        self.lent = self.lent.take().filter(|record| record.callout.is_none());
        for (field, text) in std::mem::take(&mut self.own) {
            self.texts.set(field, text);
        }
        self.read(sources);
    }

    /// Without a record, the limits are again those of the fields.
    pub(super) fn clear(&mut self, sources: &Sources) {
        self.lent = None;
        self.edited(sources);
    }

    fn measure(&mut self, shared: &mut Shared, now: DateTime) {
        let asked_about = self.question.take();
        // What stands in the fields is what is meant.
        self.own.clear();
        self.edited(&shared.sources);
        let record = match measuring::measure(self, now) {
            Ok(record) => record,
            Err((field, problem)) => {
                // A typed value has its error beside it, in sight.
                self.refusal = Some(problem.clone()).filter(|_| self.by == MeasureBy::Simulating);
                return self.asked.refuse(field, problem);
            }
        };
        if self.by == MeasureBy::Typing
            && let Some(doubt) = record.doubt
        {
            let question = Question { measured: record.measurement.diameter, doubt };
            if asked_about != Some(question) {
                self.question = Some(question);
                return;
            }
        }
        self.measured_is_used = self.by == MeasureBy::Typing;
        let id = shared.history.add(vec![Arc::new(record)]);
        if self.by == MeasureBy::Simulating {
            self.inputs.keep(id, &self.texts);
            let next = self.asked.seed.unwrap_or_default().wrapping_add(1);
            self.texts.set(CheckField::Seed, next.to_string());
        }
        self.show(id, shared);
    }

    /// Shows a record of the history; what made it stands in the fields.
    fn show(&mut self, id: RecordId, shared: &mut Shared) {
        let Some(record) = shared.history.get(id) else { return };
        shared.history.go_to(id);
        self.show_record(record, Some(id), shared);
    }

    /// Shows a record, of the history or not; what made it stands in the fields.
    pub(super) fn show_record(&mut self, record: Arc<Record>, id: Option<RecordId>, shared: &Shared) {
        self.rows.iter_mut().for_each(Rows::hide);
        // The limits on screen follow the record, never the other way round.
        let lot = self.lot.take();
        match record.callout {
            Some(callout) if Some(callout) != self.part_callout() => {
                self.take_callout(&callout.to_string(), &shared.sources);
            }
            Some(_) => {}
            // A log carries limits and no callout: the one in the field would belong to others.
            None if self.text(CheckField::Callout).is_empty() => {}
            None => self.take_callout("", &shared.sources),
        }
        if record.callout.is_some_and(|callout| callout.feature().is_none()) {
            self.feature = Some(record.limits.feature);
        }
        (self.lot, self.question, self.refusal) = (lot, None, None);
        self.show_inputs(id, &record);
        self.lent = Some(Arc::clone(&record));
        self.read(&shared.sources);
        self.draw(record, shared);
    }

    /// Puts what a record was made with back into the fields: nothing else stands beside the verdict. The user's own
    /// texts come back with the next edit.
    fn show_inputs(&mut self, id: Option<RecordId>, record: &Record) {
        for (field, text) in std::mem::take(&mut self.own) {
            self.texts.set(field, text);
        }
        for (field, text) in self.inputs.of(id, record) {
            if self.text(field).trim() != text {
                self.own.insert(field, self.text(field).to_owned());
                self.texts.set(field, text);
            }
        }
        let is_typed = record.measurement.origin == Origin::Typed;
        let measured = self.asked.length(CheckField::Measured).filter(|_| is_typed);
        if measured != Some(record.measurement.diameter) {
            let text = if is_typed { record.measurement.diameter.to_string() } else { String::new() };
            self.texts.set(CheckField::Measured, text);
        }
        self.measured_is_used = is_typed;
    }

    fn draw(&mut self, record: Arc<Record>, shared: &Shared) {
        let (language, mask) = shared.drawn_with();
        let window = status_window(&record, language, mask).map_err(|error| error.message());
        self.shown = Some(Shown { record, window });
    }

    fn imported(&mut self, name: &str, result: Result<Box<Imported>, Message>, shared: &mut Shared, now: DateTime) {
        let Some(mut imported) = shared.file_answered(result) else { return };
        // The newest file is the one that is meant.
        self.errands.extend(self.rows.as_mut().map(Rows::cancel).unwrap_or_default());
        self.shows_rows = false;
        let mut notice = measuring::import_notice(name, &imported);
        if let Some(contacts) = imported.contacts.take() {
            // Contacts are judged by what the user asked for, not by what an older check lent.
            self.edited(&shared.sources);
            match measuring::judge_contacts(name, &contacts, self, now) {
                Ok(record) => {
                    let id = shared.history.add(vec![Arc::new(record)]);
                    self.inputs.keep(id, &self.texts);
                    notice.change = shared.history.last_change();
                    self.show(id, shared);
                }
                Err(why) => {
                    notice.message = Message::new("import-contacts-not-judged").text("name", name);
                    notice.details.insert(0, why);
                    notice.is_problem = true;
                }
            }
            shared.notices.push(notice);
            return;
        }
        shared.notices.push(notice);
        let records: Vec<_> = std::mem::take(&mut imported.records).into_iter().map(Arc::new).collect();
        let is_lot = 1 < imported.rows && !(records.is_empty() && imported.unjudged.is_empty());
        if !is_lot && records.is_empty() {
            return;
        }
        let lot = |first| Lot::new(name, &imported, &records, first);
        let first = shared.history.next();
        self.clear(&shared.sources);
        self.lot = is_lot.then(|| lot(first));
        if !records.is_empty() {
            shared.history.add(records);
            shared.note_change();
        }
        if is_lot {
            self.show_of_lot(shared);
        } else {
            self.show(first, shared);
        }
    }

    /// Shows the row of the lot that is chosen.
    fn show_of_lot(&mut self, shared: &mut Shared) {
        if let Some(id) = self.lot.as_ref().and_then(Lot::record) {
            self.show(id, shared);
        }
    }
}
