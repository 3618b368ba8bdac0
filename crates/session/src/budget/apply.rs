//! How commands and news change the budget page.

use std::path::{Path, PathBuf};

use fitcheck_core::budget::{BudgetError, GeometryError};
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::simulated::LARGEST;
use jiff::civil::DateTime;

use super::readings::Source;
use super::{BudgetCommand, BudgetDocument, BudgetField, BudgetPage, TakenContacts, lines};
use crate::document::Document as _;
use crate::effect::Effect;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;
use crate::texts::Texts;

impl PageState for BudgetPage {
    type Command = BudgetCommand;
    type Field = BudgetField;

    fn restored(saved: &Saved, _shared: &Shared) -> Self {
        let used_file = saved.budget.clone();
        let awaits_used = used_file.is_some();
        Self { texts: Texts::restored(&saved.inputs.texts), used_file, awaits_used, ..Self::default() }
    }

    fn save(&self, saved: &mut Saved) {
        saved.inputs.texts.extend(self.texts.saved().filter(|(key, _)| BudgetField::is_kept(key)));
        // A path that is not text cannot be written.
        saved.budget = self.used_file.clone().filter(|path| path.to_str().is_some());
    }

    fn apply(&mut self, command: BudgetCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        match command {
            BudgetCommand::Type(field, text) if BudgetField::OF_ROW.contains(&field) => {
                self.type_in_row(field, text, shared);
            }
            BudgetCommand::Type(field, text) if field.head_key().is_some() => self.type_in_head(field, text),
            BudgetCommand::Type(field, text) => self.type_text(field, text),
            BudgetCommand::Edit(text) => {
                self.document.text = text;
                self.read_anew();
            }
            BudgetCommand::Show(shows) => self.shows = shows,
            BudgetCommand::Choose(row) => self.choose(row),
            BudgetCommand::Add => self.add_row(shared),
            BudgetCommand::Remove => self.remove_row(shared),
            BudgetCommand::SetKind(kind) => self.set_kind(kind, shared),
            BudgetCommand::SetLaw(law) => self.set_law(law, shared),
            BudgetCommand::SetType(evaluated) => self.put("type", &lines::quoted(evaluated.letter())),
            BudgetCommand::Give(given) => self.give(given, shared),
            BudgetCommand::New => self.open_or_ask(BudgetDocument::new(now.date())),
            BudgetCommand::Read { path, result } => self.budget_read(path, result, shared),
            BudgetCommand::UsedRead { path, result } => self.used_read(path, result, shared),
            BudgetCommand::TakeContacts(record) => self.take(TakenContacts::of_check(&record), shared),
            BudgetCommand::TakeRecorded => {
                if let Some(recorded) = shared.workpiece.recorded.clone() {
                    self.take(TakenContacts::recorded(&recorded), shared);
                }
            }
            BudgetCommand::OwnContacts => {
                self.contacts = None;
                self.answer_anew();
            }
            BudgetCommand::ReadingsRead { name, result } => {
                if let Some(sizes) = shared.file_answered(result) {
                    self.use_source(Some(Source::File { name, sizes }));
                    self.note_readings(shared);
                }
            }
            BudgetCommand::TakeRecords => {
                let records = shared.history.for_report().map(std::sync::Arc::clone).collect();
                self.use_source(Some(Source::Records { records, is_choice: 0 < shared.history.chosen_count() }));
                self.note_readings(shared);
            }
            BudgetCommand::OwnReadings => self.use_source(None),
            BudgetCommand::Use => self.use_this(shared),
            BudgetCommand::Leave => self.leave(shared),
        }
        Vec::new()
    }

    fn follow(&mut self, _news: &News, _shared: &mut Shared) {}

    fn text(&self, field: BudgetField) -> &str {
        self.texts.text(field)
    }

    fn error(&self, field: BudgetField) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn unsaved(&self) -> Vec<String> {
        self.document.unsaved()
    }

    fn asks_about(&self) -> Option<String> {
        self.document.asks_about()
    }

    fn discard(&mut self, loses: bool, _shared: &mut Shared) {
        if self.document.answer(loses) {
            self.opened();
        }
    }

    fn file_written(&mut self, path: &Path, is_whole: bool, shared: &mut Shared) -> Option<Message> {
        if self.document.written(path, is_whole) {
            self.used_is_saved(shared);
        }
        None
    }
}

impl BudgetPage {
    fn type_text(&mut self, field: BudgetField, text: String) {
        self.texts.set(field, text);
        if matches!(field, BudgetField::Touches | BudgetField::Step) {
            // What is typed is what is meant.
            self.contacts = None;
        }
        self.answer_anew();
    }

    fn budget_read(&mut self, path: PathBuf, result: Result<String, Message>, shared: &mut Shared) {
        // A text that is too large for a budget is too large to be edited.
        let result =
            result.and_then(|text| if LARGEST < text.len() { Err(BudgetError::TooLarge.message()) } else { Ok(text) });
        if let Some(text) = shared.file_answered(result) {
            let mut document = BudgetDocument::read(path, &text);
            document.sha256 = shared.recording.of_file(&document.name());
            self.open_or_ask(document);
        }
    }

    fn open_or_ask(&mut self, document: BudgetDocument) {
        if self.document.open_or_ask(document) {
            self.opened();
        }
    }

    /// Another budget is shown. Readings were those of the one before.
    pub(super) fn opened(&mut self) {
        self.source = None;
        self.chosen = None;
        self.rows.clear();
        self.read_anew();
    }

    fn take(&mut self, taken: Result<TakenContacts, GeometryError>, shared: &mut Shared) {
        match taken {
            Ok(taken) => {
                self.contacts = Some(taken);
                // What does not count does not stand in the fields.
                self.texts.set(BudgetField::Touches, "");
                self.texts.set(BudgetField::Step, "");
                self.answer_anew();
            }
            Err(problem) => shared.tell(message!("budget-page-no-circle").message("problem", problem.message())),
        }
    }

    fn use_source(&mut self, source: Option<Source>) {
        self.source = source;
        self.answer_anew();
    }

    /// Says where readings come from, with everything that is to be said of them.
    fn note_readings(&self, shared: &mut Shared) {
        if let Some(readings) = &self.readings {
            shared.note_details(readings.from.clone(), readings.notes.clone());
        }
    }
}
