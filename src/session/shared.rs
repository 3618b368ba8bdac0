//! What belongs to every page: settings, where limits are looked up, checks, the simulated workpiece, dialogs and
//! notices.
//!
//! A page changes its own state and this, never another page. What others have to know it tells as [`News`].

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;

use jiff::civil::DateTime;

use super::command::{Effect, Page, Purpose, SourceChoice, Theme};
use super::cycles::BenchForm;
use super::history::History;
use super::workpiece::{RecordedContacts, SimulatedWorkpiece};
use super::{Session, tables};
use crate::control::mask::Mask;
use crate::control::shipped_tables;
use crate::journal::Record;
use crate::message::Message;
use crate::tolerance::fit::materials::Materials;
use crate::tolerance::{Base, DeviationTable, Sources};
use crate::words::{Dialogue, Language};

/// The mask that the status window is drawn with.
#[derive(Debug, Clone, Default)]
pub enum MaskChoice {
    /// The shipped mask of the window's language.
    #[default]
    OfLanguage,
    /// A shipped mask.
    Shipped(Dialogue),
    /// The user's own.
    Own {
        /// Its file's name.
        name: String,
        /// The mask.
        mask: Arc<Mask>,
    },
}

/// An open file dialog: a typed path is always the other way.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dialog {
    /// What for.
    pub purpose: Purpose,
    /// The typed path.
    pub path: String,
    /// What went wrong the last time.
    pub problem: Option<Message>,
    /// Whether a file is being read or written.
    pub busy: bool,
}

/// Something to be told, until it is closed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Notice {
    /// The headline.
    pub message: Message,
    /// Details, one a line, as texts: rows of a file that could not be used, warnings.
    pub details: Vec<Message>,
    /// Whether something failed.
    pub is_problem: bool,
}

/// What a page does, or what is done for all of them, that other pages follow.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum News {
    /// A page was opened.
    Opened(Page),
    /// Limits come from elsewhere.
    Sources,
    /// The user's own tables were read.
    OwnTables,
    /// The status window is drawn in another language or with another mask.
    StatusWindow,
    /// The simulated workpiece was changed.
    Workpiece,
    /// The simulated workpiece was changed, and is what is measured from now on.
    WorkpieceTaken,
    /// Contacts were read, and are what is measured from now on.
    ContactsTaken,
    /// A part of this callout is to be checked.
    Check(String),
}

/// Every page: what it is told to do, and what it hears of the others.
pub(super) trait PageState {
    /// What can be done on the page.
    type Command;

    /// Does a command of the page.
    fn apply(&mut self, command: Self::Command, shared: &mut Shared, now: DateTime) -> Vec<Effect>;

    /// Follows what happened elsewhere.
    fn follow(&mut self, news: &News, shared: &mut Shared);
}

/// What belongs to every page.
#[derive(Debug)]
pub(super) struct Shared {
    /// The open page.
    pub page: Page,
    pub language: Language,
    pub theme: Theme,
    /// Whether the keypad is shown.
    pub keypad: bool,
    pub mask: MaskChoice,
    pub sources: Arc<Sources>,
    /// The folder of the user's own tables.
    pub tables_folder: Option<PathBuf>,
    pub materials: Materials,
    pub history: History,
    pub workpiece: SimulatedWorkpiece,
    pub dialog: Option<Dialog>,
    pub notices: Vec<Notice>,
    /// Whether the user wants to close the window and something is unsaved.
    pub leaving: bool,
    news: VecDeque<News>,
}

impl Shared {
    pub fn new(language: Language, theme: Theme) -> Self {
        Self {
            page: Page::default(),
            language,
            theme,
            keypad: false,
            mask: MaskChoice::default(),
            sources: Arc::new(Sources::default()),
            tables_folder: None,
            materials: Materials::shipped().clone(),
            history: History::default(),
            workpiece: SimulatedWorkpiece::default(),
            dialog: None,
            notices: Vec::new(),
            leaving: false,
            news: VecDeque::new(),
        }
    }

    /// Tells the other pages.
    pub fn spread(&mut self, news: News) {
        self.news.push_back(news);
    }

    /// The oldest news that no page has heard.
    pub fn next_news(&mut self) -> Option<News> {
        self.news.pop_front()
    }

    pub fn open(&mut self, page: Page) {
        self.page = page;
        self.spread(News::Opened(page));
    }

    pub fn set_language(&mut self, language: Language) {
        self.language = language;
        self.spread(News::StatusWindow);
    }

    pub fn set_mask(&mut self, mask: MaskChoice) {
        self.mask = mask;
        self.spread(News::StatusWindow);
    }

    /// What a status window is drawn with: a language, and the user's own mask.
    pub fn drawn_with(&self) -> (Dialogue, Option<&Mask>) {
        match &self.mask {
            MaskChoice::OfLanguage => (self.language.dialogue(), None),
            MaskChoice::Shipped(language) => (*language, None),
            MaskChoice::Own { mask, .. } => (self.language.dialogue(), Some(mask.as_ref())),
        }
    }

    /// Looks limits up elsewhere.
    pub fn use_sources(&mut self, sources: Sources) {
        self.sources = Arc::new(sources);
        self.spread(News::Sources);
    }

    pub fn source_choice(&self) -> SourceChoice {
        match self.sources.base() {
            Base::Iso286 => SourceChoice::Iso286,
            Base::Tables(_) => SourceChoice::ControlTables,
        }
    }

    /// Tells the user what failed.
    pub fn tell(&mut self, message: Message) {
        self.notices.push(Notice { message, details: Vec::new(), is_problem: true });
    }

    /// Tells the user what was done.
    pub fn note(&mut self, message: Message, details: Vec<Message>) {
        self.notices.push(Notice { message, details, is_problem: false });
    }

    /// The same, where there are details to tell.
    pub fn note_details(&mut self, message: Message, details: Vec<Message>) {
        if !details.is_empty() {
            self.note(message, details);
        }
    }

    pub fn open_dialog(&mut self, purpose: Purpose, path: String) {
        self.dialog = Some(Dialog { purpose, path, problem: None, busy: false });
    }

    pub fn refuse_dialog(&mut self, problem: Message) {
        if let Some(dialog) = &mut self.dialog {
            (dialog.busy, dialog.problem) = (false, Some(problem));
        }
    }

    /// Whether the dialog that sent a file to work is still open; it may have been closed, and another one opened.
    fn dialog_waits(&self) -> bool {
        self.dialog.as_ref().is_some_and(|dialog| dialog.busy)
    }

    /// What a file holds that a dialog asked for. The dialog is done, or says what is wrong with the file; where it was
    /// closed, that is told.
    pub fn from_file<T>(&mut self, result: Result<T, Message>) -> Option<T> {
        match result {
            Ok(read) => {
                if self.dialog_waits() {
                    self.dialog = None;
                }
                Some(read)
            }
            Err(problem) => {
                if self.dialog_waits() {
                    self.refuse_dialog(problem)
                } else {
                    self.tell(problem)
                }
                None
            }
        }
    }
}

/// The source that a choice stands for.
pub(super) fn base(choice: SourceChoice) -> Base {
    match choice {
        SourceChoice::Iso286 => Base::Iso286,
        SourceChoice::ControlTables => Base::Tables(shipped_tables()),
    }
}

impl Session {
    /// The open page.
    pub const fn page(&self) -> Page {
        self.shared.page
    }

    /// Where limits are looked up.
    pub const fn sources(&self) -> &Arc<Sources> {
        &self.shared.sources
    }

    /// What limits are looked up in after the user's own tables.
    pub fn source_choice(&self) -> SourceChoice {
        self.shared.source_choice()
    }

    /// The folder of the user's own tables, where one was chosen.
    pub const fn tables_folder(&self) -> Option<&PathBuf> {
        self.shared.tables_folder.as_ref()
    }

    /// The mask that the status window is drawn with.
    pub const fn mask(&self) -> &MaskChoice {
        &self.shared.mask
    }

    /// What a status window is drawn with: a language, and the user's own mask.
    pub fn drawn_with(&self) -> (Dialogue, Option<&Mask>) {
        self.shared.drawn_with()
    }

    /// The language of the window.
    pub const fn language(&self) -> Language {
        self.shared.language
    }

    /// Light or dark.
    pub const fn theme(&self) -> Theme {
        self.shared.theme
    }

    /// Whether the keypad is shown.
    pub const fn has_keypad(&self) -> bool {
        self.shared.keypad
    }

    /// All checks, oldest first.
    pub fn history(&self) -> &[Arc<Record>] {
        self.shared.history.records()
    }

    /// Whether a record is chosen for the report.
    pub fn is_chosen(&self, number: usize) -> bool {
        self.shared.history.is_chosen(number)
    }

    /// How many records are chosen.
    pub fn chosen_count(&self) -> usize {
        self.shared.history.chosen_count()
    }

    /// Whether there is something to take back.
    pub const fn can_undo(&self) -> bool {
        self.shared.history.can_undo()
    }

    /// The simulated workpiece that the cycles page and the program page measure.
    pub const fn bench(&self) -> &BenchForm {
        &self.shared.workpiece.form
    }

    /// Whether its dialog is open.
    pub const fn bench_is_open(&self) -> bool {
        self.shared.workpiece.is_open
    }

    /// The recorded contacts that both pages measure.
    pub fn recorded(&self) -> Option<&RecordedContacts> {
        self.shared.workpiece.recorded.as_deref()
    }

    /// What parts can be made of.
    pub const fn materials(&self) -> &Materials {
        &self.shared.materials
    }

    /// Adds the user's own materials to the shipped ones; one of the same name takes its place.
    pub fn use_materials(&mut self, own: Materials) {
        self.shared.materials = Materials::shipped().with_own(own);
    }

    /// The open file dialog.
    pub const fn dialog(&self) -> Option<&Dialog> {
        self.shared.dialog.as_ref()
    }

    /// What is to be told, oldest first.
    pub fn notices(&self) -> &[Notice] {
        &self.shared.notices
    }

    /// Tells something that happened outside, such as a state file that was set aside.
    pub fn tell(&mut self, message: Message) {
        self.shared.tell(message);
    }

    /// The names of tables with unsaved changes.
    pub fn unsaved_tables(&self) -> Vec<&str> {
        self.tables.unsaved().map(tables::Document::title).collect()
    }

    /// The user's own tables that are not open yet: their number among [`Sources::own`], and table.
    pub fn unopened_tables(&self) -> impl Iterator<Item = (usize, &Arc<DeviationTable>)> {
        let own = self.shared.sources.own().iter().enumerate();
        own.filter(|(_, table)| self.tables.by_title(table.name()).is_none())
    }

    /// Whether the user wants to close the window and something is unsaved.
    pub const fn is_leaving(&self) -> bool {
        self.shared.leaving
    }
}
