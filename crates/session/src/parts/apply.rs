//! Doing what can be done on the parts page.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::part::{Document, Draft, DraftFeature};
use jiff::civil::DateTime;

use super::document::PlanDocument;
use super::picture::PlanPicture;
use super::sheet::Sheet;
use super::{PartsAction, PartsCommand, PartsField, PartsPage, PartsView, PlanCommand, WalkCommand, serials};
use crate::command::Command;
use crate::effect::Effect;
use crate::page::Page;
use crate::parts::resume::Resume;
use crate::parts::{PlanField, WalkField};
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::{PageQuestion, PageState};
use crate::texts::{KeptField as _, Texts};

impl PageState for PartsPage {
    type Command = PartsCommand;
    type Field = PartsField;

    fn restored(saved: &Saved, _shared: &Shared) -> Self {
        let walk = saved.walk.clone();
        // A window with an interrupted part opens there.
        let is_shown = walk.plan.is_some();
        Self { is_shown, texts: Texts::restored(&saved.inputs.texts), resume: Resume::new(walk), ..Self::default() }
    }

    fn save(&self, saved: &mut Saved) {
        // A value that was not taken is typed again.
        let passing =
            [WalkField::Value, WalkField::Reason, WalkField::Cause, WalkField::Action].map(|field| field.declared().0);
        saved.inputs.texts.extend(self.texts.saved().filter(|(key, _)| !passing.contains(&key.as_str())));
        saved.walk = self.saved_walk();
    }

    fn apply(&mut self, command: PartsCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        let mut effects = Vec::new();
        match command {
            PartsCommand::Type(PartsField::Walk(WalkField::Value), _)
                if shared.is_for_operators() && self.walking.waits() =>
            {
                shared.tell_to_go_on();
            }
            PartsCommand::Type(PartsField::Walk(field), text) => {
                match field {
                    WalkField::Value => self.type_value(&text),
                    WalkField::Serial => self.again = None,
                    WalkField::Reason | WalkField::Cause | WalkField::Action => {}
                }
                self.texts.set(field, text);
                self.errors.remove(&field);
                // Of what is typed a letter at a time only its own serial number is told before Enter.
                if field == WalkField::Value && serials::is_named(self.texts.text(field), self.walking.serial()) {
                    self.refuse_serial(shared);
                }
            }
            PartsCommand::Show(view) => {
                self.settle();
                self.view = view;
                self.ask_for_keys();
            }
            PartsCommand::Type(PartsField::Plan(field), text) => {
                effects.extend(self.apply_plan(PlanCommand::Type(field, text), shared));
            }
            PartsCommand::Plan(command) => effects.extend(self.apply_plan(command, shared)),
            PartsCommand::Walk(command) => effects = self.apply_walk(command, shared, now),
        }
        effects.extend(self.follow_picture());
        effects
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        let was_begun = self.walking.is_begun();
        if let News::Opened(page) = news {
            self.settle();
            self.is_shown = *page == Page::Parts;
            self.ask_for_keys();
        }
        if matches!(news, News::Sources | News::OwnTables) {
            self.document.check(&shared.sources);
        }
        match news {
            News::Kept(run, is_kept) => {
                self.batch_kept(*run, *is_kept, shared);
                if *is_kept {
                    self.look_for_alarms(*run, shared);
                }
            }
            // Notes are in the language of the window, and prints are read through the user's own mask.
            News::Columns | News::StatusWindow | News::Temperature => self.watch_anew(shared),
            News::OwnMask => self.begin_watch(shared),
            News::Undone { ids, numbers } => self.undone(ids, numbers),
            News::TakenBack { number, by } => self.taken_back(*number, by.as_deref(), shared),
            News::Journal => {
                // Those that were open before.
                shared.spread(News::Measured(Vec::new()));
                self.begin_watch(shared);
                self.try_resume(shared);
            }
            News::Sources | News::OwnTables => self.try_resume(shared),
            _ => {}
        }
        self.keep_picture();
        if !was_begun && self.walking.is_begun() {
            self.ask_for_keys();
        }
    }

    fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }

    fn text(&self, field: PartsField) -> &str {
        match field {
            PartsField::Walk(field) => self.texts.text(field),
            PartsField::Plan(field) => self.plan_text(field),
        }
    }

    fn error(&self, field: PartsField) -> Option<&Message> {
        match field {
            PartsField::Walk(field) => self.errors.get(&field),
            PartsField::Plan(PlanField::Head(field)) => self.document.head_error(field),
            PartsField::Plan(PlanField::Cell) => None,
        }
    }

    fn asks(&self) -> Option<PageQuestion> {
        let question = self.walking.question.as_ref().filter(|_| self.view == PartsView::Walk)?;
        let meant = question.doubt.meant().map(|_| PartsAction::TakeMeantValue.into());
        // What cannot be is measured again unless somebody says that it is so.
        let anew = self.walking.asks_about_implausible().then(|| PartsAction::MeasureAnew.into());
        let answers = meant.into_iter().chain(anew).chain([PartsAction::TakeValue.into()]).collect();
        Some(PageQuestion { about: PartsAction::TakeValue.into(), answers })
    }

    fn closes(&self) -> Option<Command> {
        let leaves = self.alarms.answering.map(|_| WalkCommand::LeaveAlarm.into());
        leaves.or_else(|| self.walking.is_skipping.then(|| WalkCommand::AskSkip(false).into()))
    }

    fn unsaved(&self) -> Vec<String> {
        self.document.unsaved()
    }

    fn asks_about(&self) -> Option<String> {
        self.document.asks_about()
    }

    fn discard(&mut self, loses: bool, shared: &mut Shared) {
        if self.document.answer(loses) {
            self.opened(shared);
        }
        let picture = self.follow_picture();
        self.errands.extend(picture);
    }

    fn file_written(&mut self, path: &Path, is_whole: bool, _shared: &mut Shared) -> Option<Message> {
        if let Some(left) = self.document.copied(path, is_whole) {
            return Some(message!("parts-page-csv-copy").text("keys", left.join(", ")));
        }
        let name = self.document.name();
        if !self.document.written(path, is_whole) {
            return None;
        }
        self.watched.saved_as(self.document.plan(), path);
        let lost = std::mem::take(&mut self.document.comments);
        (0 < lost).then(|| message!("parts-page-comments-lost").text("name", name).count("count", lost))
    }

    fn is_free_text(&self, field: PartsField) -> bool {
        // A callout, a name and a place are typed into the same cell.
        field != PartsField::Walk(WalkField::Value)
    }
}

impl PartsPage {
    fn apply_plan(&mut self, command: PlanCommand, shared: &mut Shared) -> Option<Effect> {
        let sources = Arc::clone(&shared.sources);
        match command {
            PlanCommand::New => {
                let draft = Draft::of(vec![DraftFeature::default()]);
                self.open_or_ask(PlanDocument::new(draft, &sources), shared);
            }
            PlanCommand::Read { path, result } => self.plan_read(path, result, shared),
            PlanCommand::Undo => self.step_back(true, &sources),
            PlanCommand::Redo => self.step_back(false, &sources),
            command => return self.edit(command, shared),
        }
        None
    }

    fn plan_read(&mut self, path: PathBuf, result: Result<Box<Document>, Message>, shared: &mut Shared) {
        if let Some(document) = shared.file_answered(result) {
            let document = PlanDocument::read(path, *document, &shared.sources);
            self.open_or_ask(document, shared);
            self.try_resume(shared);
            self.ask_for_keys();
        }
    }

    fn open_or_ask(&mut self, document: PlanDocument, shared: &mut Shared) {
        if self.document.open_or_ask(document) {
            self.opened(shared);
        }
    }

    /// Another plan is shown.
    fn opened(&mut self, shared: &mut Shared) {
        let remarks = self.document.take_remarks();
        let opened = message!("parts-page-opened").text("name", self.document.name()).count("count", remarks.len());
        shared.note_details(opened, remarks);
        if self.document.is_blank() {
            self.view = PartsView::Plan;
        }
        self.sheet = Sheet::of(&self.document);
        self.shown = PlanPicture::default();
        self.forget_suggested();
        if self.is_other_open() {
            let [own, _] = self.both_plans();
            let unfinished = message!("walk-page-unfinished").text("own", own);
            shared.note(unfinished, Vec::new());
        }
        self.ask_for_keys();
    }

    /// Asks for the picture that the plan names now, and keeps the one of the part that is measured.
    fn follow_picture(&mut self) -> Option<Effect> {
        // While a name is typed it is not yet that of a file.
        let picture = if self.document.is_typing() { None } else { self.ask_for_picture() };
        self.keep_picture();
        picture.map(Effect::ReadPicture)
    }

    /// Gives the keys to what is typed next: the table of the plan, the value of the size that is asked for, or the serial number where a
    /// part can be begun.
    fn ask_for_keys(&mut self) {
        let effect = match self.view {
            PartsView::Plan if self.document.is_empty() => None,
            PartsView::Plan => Some(Effect::FocusTable),
            PartsView::Walk if self.walking.is_begun() => {
                self.walking.at.map(|_| Effect::Focus(WalkField::Value.into()))
            }
            PartsView::Walk => self.document.plan().map(|_| Effect::Focus(WalkField::Serial.into())),
        };
        self.errands.extend(effect.filter(|_| self.is_shown));
    }
}
