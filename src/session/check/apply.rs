//! How commands and news change the check page.

use std::sync::Arc;

use jiff::civil::DateTime;

use super::{Asked, CheckCommand, CheckField, CheckPage, MeasureBy, Shown, class_text, measuring, nominal_text};
use crate::exchange::Imported;
use crate::journal::{Record, status_window};
use crate::message::{Message, Say as _};
use crate::session::command::Effect;
use crate::session::shared::{News, PageState, Shared};
use crate::tolerance::Sources;

impl PageState for CheckPage {
    type Command = CheckCommand;

    fn apply(&mut self, command: CheckCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        match command {
            CheckCommand::Type(field, text) => self.type_text(field, text, &shared.sources),
            CheckCommand::ChooseClass(class) => {
                let nominal = nominal_text(self.text(CheckField::Callout));
                self.take_callout(&format!("{nominal} {class}"), &shared.sources);
            }
            CheckCommand::ChooseFeature(feature) => {
                self.feature = Some(feature);
                self.callout_changed(false, &shared.sources);
            }
            CheckCommand::MeasureBy(by) => self.by = by,
            CheckCommand::Measure => self.measure(shared, now),
            CheckCommand::Clear => {
                self.texts.set(CheckField::Measured, "");
                self.measured_is_used = false;
                self.clear_shown(&shared.sources);
            }
            CheckCommand::CopyStatus => {
                return self.status_text().map(|text| Effect::Copy(text.to_owned())).into_iter().collect();
            }
            CheckCommand::Show(number) => self.show(number, shared),
            CheckCommand::Choose(number, is_chosen) => shared.history.choose(number, is_chosen),
            CheckCommand::ClearHistory => {
                if shared.history.clear() {
                    self.clear_shown(&shared.sources);
                }
            }
            CheckCommand::Undo => {
                if shared.history.take_back() {
                    self.clear_shown(&shared.sources);
                }
            }
            CheckCommand::Imported { name, result } => self.imported(&name, result, shared, now),
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        match news {
            // No verdict stays beside limits that it was not made with.
            News::Sources => self.callout_changed(true, &shared.sources),
            News::StatusWindow => {
                if let Some(shown) = self.shown.take() {
                    self.draw(shown.record, shared);
                }
            }
            News::Check(callout) => self.take_callout(callout, &shared.sources),
            News::Opened(_) | News::OwnTables | News::Workpiece | News::WorkpieceTaken | News::ContactsTaken => {}
        }
    }
}

impl CheckPage {
    fn type_text(&mut self, field: CheckField, text: String, sources: &Sources) {
        self.texts.set(field, text);
        match field {
            CheckField::Callout => self.callout_changed(true, sources),
            CheckField::Nominal => {
                let (nominal, class) = (self.text(CheckField::Nominal), class_text(self.text(CheckField::Callout)));
                let callout = format!("{} {class}", nominal.trim());
                self.texts.set(CheckField::Callout, callout.trim());
                self.callout_changed(false, sources);
            }
            CheckField::Measured => {
                self.by = MeasureBy::Typing;
                self.measured_is_used = false;
                self.read(sources);
            }
            _ => self.read(sources),
        }
    }

    /// Reads the fields anew. The limits stay those of the record that is shown: it may come from a log without a
    /// callout, or from tables that are no longer used.
    fn read(&mut self, sources: &Sources) {
        self.asked = Asked::read(&self.texts, self.feature, sources);
        if let Some(shown) = &self.shown {
            self.asked.show_limits(shown.record.limits.clone(), shown.record.callout);
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
        self.clear_shown(sources);
        if self.asked.callout().is_some_and(|callout| callout.feature().is_some()) {
            // The next callout without letters asks again.
            self.feature = None;
        }
        if self.measured_is_used {
            self.texts.set(CheckField::Measured, "");
            self.measured_is_used = false;
        }
    }

    /// Without a record, the limits are again those of the fields.
    fn clear_shown(&mut self, sources: &Sources) {
        self.shown = None;
        self.read(sources);
    }

    fn measure(&mut self, shared: &mut Shared, now: DateTime) {
        match measuring::measure(self, now) {
            Ok(record) => {
                if self.by == MeasureBy::Simulating {
                    let next = self.asked.seed.unwrap_or_default().wrapping_add(1);
                    self.texts.set(CheckField::Seed, next.to_string());
                    self.read(&shared.sources);
                } else {
                    self.measured_is_used = true;
                }
                self.add(vec![Arc::new(record)], shared);
            }
            Err((field, problem)) => self.asked.refuse(field, problem),
        }
    }

    /// Adds records to the history and shows the last of them.
    fn add(&mut self, records: Vec<Arc<Record>>, shared: &mut Shared) {
        if records.is_empty() {
            return;
        }
        shared.history.add(records);
        self.show(shared.history.records().len() - 1, shared);
    }

    fn show(&mut self, number: usize, shared: &Shared) {
        let Some(record) = shared.history.records().get(number).cloned() else { return };
        // The limits on screen follow the record, never the other way round.
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
        self.asked.show_limits(record.limits.clone(), record.callout);
        self.draw(record, shared);
    }

    fn draw(&mut self, record: Arc<Record>, shared: &Shared) {
        let (language, mask) = shared.drawn_with();
        let window = status_window(&record, language, mask).map_err(|error| error.message());
        self.shown = Some(Shown { record, window });
    }

    fn imported(&mut self, name: &str, result: Result<Box<Imported>, Message>, shared: &mut Shared, now: DateTime) {
        let Some(imported) = shared.file_answered(result) else { return };
        shared.notices.push(measuring::import_notice(name, &imported));
        let mut records: Vec<_> = imported.records.into_iter().map(Arc::new).collect();
        if let Some(contacts) = imported.contacts {
            match measuring::judge_contacts(name, &contacts, &self.asked, now) {
                Ok(record) => records.push(Arc::new(record)),
                Err(problem) => shared.tell(problem),
            }
        }
        self.add(records, shared);
    }
}
