//! The state of the application, and the only place that changes it.
//!
//! Menu, key, button, file and test send a [`Command`]; [`Session::apply`] changes the state and answers with
//! [`Effect`]s for the world outside. No file, thread, clock or window is touched here: the time comes in.
//!
//! | file | what |
//! |---|---|
//! | `command` | everything that can be done |
//! | `inputs` | the text fields |
//! | `asked` | what the texts mean: callout, limits, errors beside their fields |
//! | `cycles` | the cycles page: a measuring cycle on a workpiece or on recorded contacts |
//! | `fit` | the fit page: hole against shaft |
//! | `files` | dialogs, and what comes back from files |
//! | `measuring` | from the fields to a measurement |
//! | `program` | the program page: an NC program is run and stepped |
//! | `saved` | what survives a restart |
//! | `tables` | the table page |

mod asked;
mod command;
mod cycles;
mod files;
mod fit;
mod inputs;
mod measuring;
pub mod program;
mod saved;
pub mod tables;

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;

use jiff::civil::DateTime;

pub use asked::Asked;
pub use command::{Command, CycleFile, Effect, Page, Purpose, SourceChoice, Theme};
pub use cycles::{
    Axis, ContactsFrom, CycleField, CycleRun, CyclesCommand, CyclesPage, RecordedContacts, RunLog, Step,
    WorkpieceField, WorkpieceForm,
};
pub use fit::{
    ClassMap, Direction, Equivalent, FitCommand, FitPage, MapCell, Mark, Parts, Picture, PictureZone, WarmFit,
    expansion_field, extremes, measured_field,
};
pub use inputs::{Field, Inputs, MeasureBy};
pub use program::{ProgramCommand, ProgramField, ProgramPage};
pub use saved::{Saved, SavedCycles, SavedError};
pub use tables::{TablesCommand, TablesPage};

use crate::control::mask::Mask;
use crate::control::{shipped_tables, status};
use crate::journal::Record;
use crate::message::{Message, Say as _};
use crate::tolerance::fit::materials::Materials;
use crate::tolerance::{Base, Callout, Sources};
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

/// A record that is shown, and what the mask makes of it.
#[derive(Debug, Clone)]
pub struct Shown {
    /// The record.
    pub record: Arc<Record>,
    /// The status window's text, or why the mask cannot be drawn.
    pub window: Result<String, Message>,
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

/// What undo goes back to.
#[derive(Debug, Clone)]
struct Snapshot {
    history: Vec<Arc<Record>>,
    chosen: BTreeSet<usize>,
}

/// How many steps back undo remembers.
const UNDO_STEPS: usize = 50;

/// The state of the application.
#[derive(Debug)]
pub struct Session {
    page: Page,
    inputs: Inputs,
    asked: Asked,
    fit: FitPage,
    materials: Materials,
    sources: Arc<Sources>,
    tables_folder: Option<PathBuf>,
    mask: MaskChoice,
    language: Language,
    theme: Theme,
    keypad: bool,
    shown: Option<Shown>,
    measured_is_used: bool,
    history: Vec<Arc<Record>>,
    chosen: BTreeSet<usize>,
    undo: Vec<Snapshot>,
    dialog: Option<Dialog>,
    notices: Vec<Notice>,
    leaving: bool,
    tables: TablesPage,
    cycles: CyclesPage,
    program: ProgramPage,
}

/// The source that a choice stands for.
fn base(choice: SourceChoice) -> Base {
    match choice {
        SourceChoice::Iso286 => Base::Iso286,
        SourceChoice::ControlTables => Base::Tables(shipped_tables()),
    }
}

impl Session {
    /// A session with ISO 286 as source of limits and empty fields.
    pub fn new(language: Language) -> Self {
        Self::with(language, Theme::default(), Inputs::default())
    }

    fn with(language: Language, theme: Theme, inputs: Inputs) -> Self {
        let sources = Arc::new(Sources::default());
        let asked = Asked::read(&inputs, &sources);
        let mut fit = FitPage::default();
        fit.read(&inputs, &sources);
        Self {
            page: Page::default(),
            inputs,
            asked,
            fit,
            sources,
            tables_folder: None,
            mask: MaskChoice::default(),
            language,
            theme,
            keypad: false,
            shown: None,
            measured_is_used: false,
            history: Vec::new(),
            chosen: BTreeSet::new(),
            undo: Vec::new(),
            dialog: None,
            notices: Vec::new(),
            leaving: false,
            materials: Materials::shipped().clone(),
            tables: TablesPage::default(),
            cycles: CyclesPage::default(),
            program: ProgramPage::default(),
        }
    }

    /// The open page.
    pub const fn page(&self) -> Page {
        self.page
    }

    /// The text fields.
    pub const fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// What the fields mean.
    pub const fn asked(&self) -> &Asked {
        &self.asked
    }

    /// Where limits are looked up.
    pub const fn sources(&self) -> &Arc<Sources> {
        &self.sources
    }

    /// What limits are looked up in after the user's own tables.
    pub fn source_choice(&self) -> SourceChoice {
        match self.sources.base() {
            Base::Iso286 => SourceChoice::Iso286,
            Base::Tables(_) => SourceChoice::ControlTables,
        }
    }

    /// The folder of the user's own tables, where one was chosen.
    pub const fn tables_folder(&self) -> Option<&PathBuf> {
        self.tables_folder.as_ref()
    }

    /// The mask that the status window is drawn with.
    pub const fn mask(&self) -> &MaskChoice {
        &self.mask
    }

    /// The language of the window.
    pub const fn language(&self) -> Language {
        self.language
    }

    /// Light or dark.
    pub const fn theme(&self) -> Theme {
        self.theme
    }

    /// Whether the keypad is shown.
    pub const fn has_keypad(&self) -> bool {
        self.keypad
    }

    /// The record that is shown, if any. It always belongs to the limits on screen.
    pub const fn shown(&self) -> Option<&Shown> {
        self.shown.as_ref()
    }

    /// All checks, oldest first.
    pub fn history(&self) -> &[Arc<Record>] {
        &self.history
    }

    /// Whether a record is chosen for the report.
    pub fn is_chosen(&self, number: usize) -> bool {
        self.chosen.contains(&number)
    }

    /// How many records are chosen.
    pub fn chosen_count(&self) -> usize {
        self.chosen.len()
    }

    /// Whether there is something to take back.
    pub const fn can_undo(&self) -> bool {
        !self.undo.is_empty()
    }

    /// The open file dialog.
    pub const fn dialog(&self) -> Option<&Dialog> {
        self.dialog.as_ref()
    }

    /// What is to be told, oldest first.
    pub fn notices(&self) -> &[Notice] {
        &self.notices
    }

    /// Tells something that happened outside, such as a state file that was set aside.
    pub fn tell(&mut self, message: Message) {
        self.notices.push(Notice { message, details: Vec::new(), is_problem: true });
    }

    /// The names of tables with unsaved changes.
    pub fn unsaved_tables(&self) -> Vec<&str> {
        self.tables.documents().iter().filter(|table| table.is_unsaved()).map(tables::Document::title).collect()
    }

    /// Whether the user wants to close the window and something is unsaved.
    pub const fn is_leaving(&self) -> bool {
        self.leaving
    }

    /// Adds the user's own materials to the shipped ones; one of the same name takes its place.
    pub fn use_materials(&mut self, own: Materials) {
        self.materials = Materials::shipped().with_own(own);
    }

    /// What parts can be made of.
    pub const fn materials(&self) -> &Materials {
        &self.materials
    }

    /// Does a command at a local date and time, and says what the world outside has to do.
    pub fn apply(&mut self, command: Command, now: DateTime) -> Vec<Effect> {
        match command {
            Command::OpenPage(page) => self.open_page(page),
            Command::Type(field, text) => self.type_text(field, text),
            Command::ChooseClass(class) => self.choose_class(class.as_str()),
            Command::ChooseFeature(feature) => {
                self.inputs.feature = Some(feature);
                self.callout_changed(false);
            }
            Command::MeasureBy(by) => self.inputs.by = by,
            Command::ShowKeypad(shown) => self.keypad = shown,
            Command::Measure if self.page == Page::Check => self.measure(now),
            Command::Measure if self.page == Page::Cycles => return self.apply_cycles(CyclesCommand::Run, now),
            Command::Measure if self.page == Page::Program => {
                return self.apply_program(ProgramCommand::Run, now);
            }
            Command::Measure => {}
            Command::ClearResult => self.clear_result(),
            Command::Show(number) => self.show(number),
            Command::Choose(number, true) if number < self.history.len() => _ = self.chosen.insert(number),
            Command::Choose(number, _) => _ = self.chosen.remove(&number),
            Command::ClearHistory => self.clear_history(),
            Command::Undo => self.take_back(),
            Command::SetLanguage(language) => self.set_language(language),
            Command::SetTheme(theme) => self.theme = theme,
            Command::SetMask(language) => {
                self.set_mask(language.map_or(MaskChoice::OfLanguage, MaskChoice::Shipped));
            }
            Command::OpenDialog(purpose) => self.open_dialog(purpose),
            Command::TypePath(path) => {
                if let Some(dialog) = &mut self.dialog {
                    (dialog.path, dialog.problem) = (path, None);
                }
            }
            Command::Browse => return self.dialog.iter().map(|dialog| Effect::Browse(dialog.purpose)).collect(),
            Command::Picked(path) => return self.picked(path, now),
            Command::Confirm => return self.confirm(now),
            Command::Close => self.close(),
            Command::AskToLeave if self.unsaved_tables().is_empty() => return vec![Effect::Leave],
            Command::AskToLeave => self.leaving = true,
            Command::Leave(false) => self.leaving = false,
            Command::Leave(true) => return vec![Effect::Leave],
            Command::Imported { name, result } => self.imported(&name, result, now),
            Command::MaskRead { name, result } => self.mask_read(name, result),
            Command::TablesRead { folder, result } => self.tables_read(folder, result),
            Command::NoOwnTables => self.use_tables(Vec::new(), None),
            Command::UseSource(choice) => {
                self.use_sources(self.sources.as_ref().clone().with_base(base(choice)));
            }
            Command::SetStandard(options) => {
                self.use_sources(self.sources.as_ref().clone().with_options(options));
            }
            Command::Saved { path, result } => self.saved_file(&path, result),
            Command::Fit(command) => self.apply_fit(&command),
            Command::Tables(command) => self.apply_tables(command),
            Command::Cycles(command) => return self.apply_cycles_for_page(command, now),
            Command::Program(command) => return self.apply_program(command, now),
            Command::CopyStatus => return self.status_text().map(Effect::Copy).into_iter().collect(),
        }
        Vec::new()
    }

    fn type_text(&mut self, field: Field, text: String) {
        let nominal = (field == Field::Nominal).then(|| text.clone());
        self.inputs.set(field, text);
        match field {
            Field::Callout => self.callout_changed(true),
            Field::Nominal => {
                let class = asked::class_text(self.inputs.text(Field::Callout)).to_owned();
                let callout = format!("{} {class}", nominal.unwrap_or_default().trim());
                self.inputs.set(Field::Callout, callout.trim().to_owned());
                self.callout_changed(false);
            }
            Field::Measured => {
                self.inputs.by = MeasureBy::Typing;
                self.measured_is_used = false;
                self.read_fields();
            }
            Field::TableFilter | Field::CellUpper | Field::CellLower | Field::TableClasses | Field::TableTo => {
                self.table_field_changed(field);
            }
            _ => self.read_fields(),
        }
    }

    fn open_page(&mut self, page: Page) {
        self.page = page;
        if page == Page::Tables {
            self.open_tables_page();
        } else if page == Page::Program {
            self.open_program_page();
        }
    }

    /// Reads the fields anew. The limits stay those of the record that is shown: it may come from a log without a
    /// callout, or from tables that are no longer used.
    fn read_fields(&mut self) {
        self.asked = Asked::read(&self.inputs, &self.sources);
        self.fit.read(&self.inputs, &self.sources);
        if let Some(shown) = &self.shown {
            self.asked.show_limits(shown.record.limits.clone(), shown.record.callout);
        }
    }

    fn choose_class(&mut self, class: &str) {
        let nominal = asked::nominal_text(self.inputs.text(Field::Callout)).to_owned();
        self.inputs.set(Field::Callout, format!("{nominal} {class}").trim().to_owned());
        self.callout_changed(true);
    }

    /// No verdict stays beside limits that it was not made with.
    fn callout_changed(&mut self, nominal_follows: bool) {
        if nominal_follows {
            let nominal = asked::nominal_text(self.inputs.text(Field::Callout)).to_owned();
            self.inputs.set(Field::Nominal, nominal);
        }
        self.shown = None;
        self.read_fields();
        if self.asked.callout().is_some_and(|callout| callout.feature().is_some()) {
            // The next callout without letters asks anew.
            self.inputs.feature = None;
        }
        if self.measured_is_used {
            self.inputs.set(Field::Measured, String::new());
            self.measured_is_used = false;
        }
    }

    fn measure(&mut self, now: DateTime) {
        match measuring::measure(&self.inputs, &self.asked, now) {
            Ok(record) => {
                if self.inputs.by == MeasureBy::Simulating {
                    let next = self.asked.seed.unwrap_or_default().wrapping_add(1);
                    self.inputs.set(Field::Seed, next.to_string());
                    self.read_fields();
                } else {
                    self.measured_is_used = true;
                }
                self.add(vec![Arc::new(record)]);
            }
            Err((field, problem)) => self.asked.refuse(field, problem),
        }
    }

    /// Adds records to the history and shows the last of them.
    fn add(&mut self, records: Vec<Arc<Record>>) {
        if records.is_empty() {
            return;
        }
        self.remember();
        self.history.extend(records);
        self.show(self.history.len() - 1);
    }

    fn show(&mut self, number: usize) {
        let Some(record) = self.history.get(number).cloned() else { return };
        // The limits on screen follow the record, never the other way round.
        match record.callout {
            Some(callout) if Some(callout) != self.part_callout() => {
                self.inputs.set(Field::Callout, callout.to_string());
                self.callout_changed(true);
            }
            Some(_) => {}
            // A log carries limits and no callout: the one in the field would belong to others.
            None if self.inputs.text(Field::Callout).is_empty() => {}
            None => {
                self.inputs.set(Field::Callout, String::new());
                self.callout_changed(true);
            }
        }
        if record.callout.is_some_and(|callout| callout.feature().is_none()) {
            self.inputs.feature = Some(record.limits.feature);
        }
        self.asked.show_limits(record.limits.clone(), record.callout);
        self.draw(record);
    }

    fn draw(&mut self, record: Arc<Record>) {
        let window = self.status_window(&record);
        self.shown = Some(Shown { record, window });
    }

    fn status_window(&self, record: &Record) -> Result<String, Message> {
        let (language, mask) = match &self.mask {
            MaskChoice::OfLanguage => (self.language.dialogue(), None),
            MaskChoice::Shipped(language) => (*language, None),
            MaskChoice::Own { mask, .. } => (self.language.dialogue(), Some(mask.as_ref())),
        };
        status::status_window(record, language, mask).map_err(|error| error.message())
    }

    fn clear_result(&mut self) {
        self.shown = None;
        self.inputs.set(Field::Measured, String::new());
        self.measured_is_used = false;
        self.read_fields();
    }

    fn remember(&mut self) {
        if UNDO_STEPS <= self.undo.len() {
            self.undo.remove(0);
        }
        self.undo.push(Snapshot { history: self.history.clone(), chosen: self.chosen.clone() });
    }

    fn clear_history(&mut self) {
        if self.history.is_empty() {
            return;
        }
        self.remember();
        self.history.clear();
        self.chosen.clear();
        self.clear_shown();
    }

    fn take_back(&mut self) {
        if let Some(snapshot) = self.undo.pop() {
            (self.history, self.chosen) = (snapshot.history, snapshot.chosen);
            self.clear_shown();
        }
    }

    /// Without a record, the limits are again those of the fields.
    fn clear_shown(&mut self) {
        self.shown = None;
        self.read_fields();
    }

    fn set_language(&mut self, language: Language) {
        self.language = language;
        self.redraw();
    }

    fn set_mask(&mut self, mask: MaskChoice) {
        self.mask = mask;
        self.redraw();
    }

    fn redraw(&mut self) {
        if let Some(shown) = self.shown.take() {
            self.draw(shown.record);
        }
    }

    /// What survives a restart.
    pub fn saved(&self) -> Saved {
        Saved {
            language: self.language,
            theme: self.theme,
            keypad: self.keypad,
            tables_folder: self.tables_folder.clone(),
            source: self.source_choice(),
            standard: self.sources.options(),
            inputs: self.inputs.clone(),
            cycles: self.cycles.saved(),
            ..Saved::default()
        }
    }

    /// A session from what was saved. The tables' folder is read by the effect that comes with it.
    pub fn restore(saved: Saved) -> (Self, Vec<Effect>) {
        let effects = saved.tables_folder.clone().map(Effect::ReadTables).into_iter().collect();
        let mut session = Self { keypad: saved.keypad, ..Self::with(saved.language, saved.theme, saved.inputs) };
        let sources = Sources::default().with_base(base(saved.source)).with_options(saved.standard);
        session.sources = Arc::new(sources);
        session.cycles.restore(&saved.cycles);
        session.read_fields();
        (session, effects)
    }

    /// Where in a field's text an error shows: characters counted from 0.
    pub fn culprit(&self, field: Field) -> Option<&std::ops::Range<usize>> {
        match field {
            Field::Callout => self.asked.culprit(),
            Field::FitCallout => self.fit.culprit(),
            _ => None,
        }
    }

    /// What is wrong with a field, on whatever page it stands.
    pub fn error(&self, field: Field) -> Option<&Message> {
        self.asked.error(field).or_else(|| self.fit.error(field)).or_else(|| self.tables.error(field))
    }

    /// The callout of the part that is judged: one side of a fit.
    fn part_callout(&self) -> Option<Callout> {
        let callout = self.asked.callout()?;
        Some(self.inputs.feature.map_or(callout, |feature| callout.of_part(feature)))
    }

    /// The callout that limits are shown for.
    pub fn callout(&self) -> Option<Callout> {
        self.asked.callout()
    }
}
