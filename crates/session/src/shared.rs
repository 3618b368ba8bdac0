//! What belongs to every page: settings, where limits are looked up, checks, the simulated workpiece, dialogs and
//! notices.
//!
//! A page changes its own state and this, never another page. It announces what others have to know as [`News`].

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::tolerance::fit::materials::Materials;
use fitcheck_core::tolerance::{Absent, Base, Sources};
use fitcheck_core::words::{Dialogue, Language, Words};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::entry::Entry;
use fitcheck_exchange::journal::query::RecordId;
use fitcheck_nc::control::mask::Mask;
use fitcheck_nc::control::shipped_tables;
use fitcheck_nc::machine::{NcPath, Store};

use super::budget::OpenBudget;
use super::check::RuleFields;
use super::columns::Columns;
use super::command::Command;
use super::effect::Effect;
use super::files::{Dialog, DialogId, Places, Working};
use super::history::History;
use super::notice::{Notice, Notices};
use super::own_texts::ChosenTexts;
use super::page::Page;
use super::parts::NewestValue;
use super::purpose::Purpose;
use super::recording::{Recorded, Recording};
use super::ruler::Ruler;
use super::saved::SavedRecords;
use super::settings::{DecimalSign, Density, Mode, RowHeight, Theme};
use super::tools::OpenTools;
use super::workpiece::SimulatedWorkpiece;
use super::zoom::Zoom;

/// The mask that the status window is drawn with.
#[derive(Debug, Clone, Default)]
pub enum MaskChoice {
    /// The built-in mask of the window's language.
    #[default]
    OfLanguage,
    /// A built-in mask.
    Shipped(Dialogue),
    /// The user's own.
    Own {
        /// Its file's name.
        name: String,
        /// Its file.
        path: PathBuf,
        mask: Arc<Mask>,
    },
}

/// Where the NC program of this file finds other files. No file is opened here, so the window hands it in; until then a
/// program finds none.
#[derive(Clone, Copy)]
pub(super) struct ProgramFiles(pub fn(&Path) -> Box<dyn Store>);

impl fmt::Debug for ProgramFiles {
    // An address would differ from one run to the next.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("ProgramFiles")
    }
}

impl Default for ProgramFiles {
    fn default() -> Self {
        Self(|_program| Box::new(BTreeMap::<NcPath, Vec<u8>>::new()))
    }
}

/// The user's own mask of the last time, before another one is chosen.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) enum OwnMask {
    /// There was none, or it was read.
    #[default]
    Settled,
    /// It is being read.
    Awaited(PathBuf),
    /// It could not be read; it may be there the next time.
    Unread(PathBuf),
}

/// A change by a page, or for all of them, that other pages follow.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum News {
    Opened(Page),
    /// Limits come from other sources.
    Sources,
    /// The user's own tables were read.
    OwnTables,
    /// The status window is drawn in another language or with another mask.
    StatusWindow,
    /// The user's own mask of the last time cannot be read.
    OwnMask,
    /// The simulated workpiece was changed.
    Workpiece,
    /// The simulated workpiece was changed, and is what is measured from now on.
    WorkpieceTaken,
    /// Contacts were read, and are what is measured from now on.
    ContactsTaken,
    /// A part of several features was read, and is what is measured from now on.
    PartTaken,
    /// Tools are monitored with another table, or with none.
    Tools,
    /// Checks may use another budget's uncertainty, or none any more.
    Budget,
    /// Checks use this budget from now on: its uncertainty takes the place of a typed one.
    BudgetTaken,
    /// Checks use no budget any more.
    BudgetLeft,
    /// The record of a number was corrected or withdrawn.
    TakenBack {
        number: u64,
        /// The number of what stands in its place, and what it tells.
        by: Option<Box<(u64, Entry)>>,
    },
    /// A record is to be shown.
    ShowRecord(u64),
    /// Undo took checks of the history back, with what stood in their place.
    Undone {
        ids: BTreeSet<RecordId>,
        /// Those of their records that have a number.
        numbers: BTreeSet<u64>,
    },
    /// A record is being corrected.
    Correcting,
    /// The correction that put this check into the history is taken back.
    UndoCorrection(RecordId),
    /// Other columns of files are remembered.
    Columns,
    /// Values are brought to 20 °C from another temperature, or no longer.
    Temperature,
    /// The journal is open, or cannot be opened.
    Journal,
    /// The journal has answered about a batch of checks: whether they are on disk.
    Kept(u64, bool),
    /// These values are on disk, the newest of each feature: rules of control charts may fire there. None where only the open alarms are
    /// asked for.
    Measured(Vec<NewestValue>),
    /// A part of this callout is to be checked.
    Check(String),
    /// What a record asked for is to be measured again.
    MeasureAgain {
        record: Arc<Record>,
        part: String,
        serial: String,
    },
}

/// What belongs to every page.
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of its own")]
#[derive(Debug, Default)]
pub(super) struct Shared {
    /// The open page.
    pub page: Page,
    pub language: Language,
    pub theme: Theme,
    /// Whom the window is for; `None` until somebody has said it.
    pub mode: Option<Mode>,
    /// How large a millimetre is on this screen.
    pub ruler: Option<Ruler>,
    /// The salted hash of the PIN that locks the operator's window.
    pub pin: Option<String>,
    /// Whether the keypad is shown.
    pub keypad: bool,
    /// Whether a verdict is heard.
    pub sounds: bool,
    pub density: Density,
    pub decimal: DecimalSign,
    pub rows: RowHeight,
    pub zoom: Zoom,
    /// Whether the check page shows the first steps.
    pub welcomes: bool,
    /// Whether a finger was used last.
    pub is_touched: bool,
    /// Whether it is asked whom the window is for.
    pub asks_for_mode: bool,
    pub mask: MaskChoice,
    /// The user's own mask of the last time.
    pub own_mask: OwnMask,
    /// The file of the user's own texts.
    pub own_texts: Option<ChosenTexts>,
    /// The file of own texts that was still being read when the user chose another one, or none: its answer comes too late.
    pub given_up_texts: Option<PathBuf>,
    /// The mask that was still being read when the user chose another one: its answer comes too late.
    pub given_up_mask: Option<PathBuf>,
    /// The user's own mask by its name, for whatever reads prints.
    pub own_masks: Arc<Vec<(String, Mask)>>,
    pub sources: Arc<Sources>,
    /// The folder of the user's own tables.
    pub tables_folder: Option<PathBuf>,
    /// What waits until those and the mask are read: a file that is judged as it is read.
    held: Vec<Effect>,
    /// The folder that was still being read when the user chose other tables, or none: its answer comes too late.
    pub given_up: Option<PathBuf>,
    pub materials: Materials,
    pub program_files: ProgramFiles,
    pub history: History,
    pub recording: Recording,
    pub workpiece: SimulatedWorkpiece,
    /// The tool table that was opened.
    pub tools: Option<Arc<OpenTools>>,
    /// How the check page judges the next value, for pages that judge values of their own.
    pub worth: RuleFields,
    /// The budget whose uncertainty checks may use.
    pub budget: Option<Arc<OpenBudget>>,
    pub dialog: Option<Dialog>,
    /// How many dialogs were opened.
    dialogs: u64,
    /// The dialog whose answer is being applied.
    pub answered: Option<DialogId>,
    pub places: Places,
    pub columns: Columns,
    pub notices: Notices,
    /// The file that is being read or written, where that takes long.
    pub working: Option<Box<Working>>,
    /// Whether the user wants to close the window and something is unsaved.
    pub leaving: bool,
    news: VecDeque<News>,
}

impl Shared {
    pub fn new(language: Language, theme: Theme, records: SavedRecords) -> Self {
        let recording = Recording::new(records);
        Self { language, theme, recording, materials: Materials::shipped().clone(), ..Self::default() }
    }

    /// A number as it is typed in the window's language.
    pub(super) fn as_typed(&self, number: &str) -> String {
        number.replace('.', &self.decimal_sign().to_string())
    }

    /// Takes what a measured value is worth from now on.
    pub(super) fn take_worth(&mut self, worth: RuleFields) {
        let is_other = worth.temperature() != self.worth.temperature();
        self.worth = worth;
        if is_other {
            self.spread(News::Temperature);
        }
    }

    /// Announces news to the other pages.
    pub fn spread(&mut self, news: News) {
        self.news.push_back(news);
    }

    /// The oldest news that no page has heard.
    pub fn next_news(&mut self) -> Option<News> {
        self.news.pop_front()
    }

    /// Opens a page; in the operator's mode only one of its own.
    pub fn open(&mut self, page: Page) {
        if self.is_for_operators() && !page.is_for_operators() {
            return;
        }
        self.page = page;
        self.spread(News::Opened(page));
    }

    pub fn is_for_operators(&self) -> bool {
        self.mode == Some(Mode::Operator)
    }

    pub fn set_mode(&mut self, mode: Mode) {
        self.mode = Some(mode);
        self.asks_for_mode = false;
        // An operator has the keypad at first.
        self.keypad |= mode == Mode::Operator;
        if self.is_for_operators() && !self.page.is_for_operators() {
            self.open(Page::Check);
        }
    }

    /// How the window looks from now on, and whom it is for.
    pub fn look(&mut self, command: &Command) {
        match *command {
            Command::SetRuler(ruler) => self.ruler = ruler,
            Command::ShowKeypad(shown) => self.keypad = shown,
            Command::UseSounds(sounds) => self.sounds = sounds,
            Command::SetLanguage(language) => self.set_language(language),
            Command::SetTheme(theme) => self.theme = theme,
            Command::SetDensity(density) => self.density = density,
            Command::SetRows(rows) => self.rows = rows,
            Command::SetDecimal(decimal) => self.set_decimal(decimal),
            Command::SetZoom(zoom) => self.zoom = zoom,
            Command::Welcome(welcomes) => {
                self.welcomes = welcomes;
                if welcomes {
                    self.open(Page::Check);
                }
            }
            Command::Touched(is_touched) => {
                self.is_touched = is_touched;
                // A mouse that moves while it is asked is no answer.
                self.asks_for_mode |= is_touched && self.mode.is_none();
            }
            _ => {}
        }
    }

    /// A verdict that is not good waits until somebody says that he has read it: what is typed before that is told, and not taken.
    pub fn tell_to_go_on(&mut self) {
        self.note(message!("operator-go-on-first"), Vec::new());
    }

    pub fn set_language(&mut self, language: Language) {
        self.language = language;
        self.spread(News::StatusWindow);
    }

    pub fn set_decimal(&mut self, decimal: DecimalSign) {
        self.decimal = decimal;
        self.spread(News::StatusWindow);
    }

    /// What stands before the decimals of a number in the window.
    pub fn decimal_sign(&self) -> char {
        match self.decimal {
            DecimalSign::OfLanguage => self.language.decimal_sign(),
            DecimalSign::Point => '.',
            DecimalSign::Comma => ',',
        }
    }

    /// The texts of the window.
    pub fn words(&self) -> Words {
        self.report_words().with_decimal_sign(self.decimal_sign())
    }

    pub fn set_mask(&mut self, mask: MaskChoice) {
        self.own_masks = Arc::new(match &mask {
            MaskChoice::Own { name, mask, .. } => vec![(name.clone(), Mask::clone(mask))],
            MaskChoice::OfLanguage | MaskChoice::Shipped(_) => Vec::new(),
        });
        if let OwnMask::Awaited(path) = std::mem::take(&mut self.own_mask) {
            let is_it = matches!(&mask, MaskChoice::Own { path: read, .. } if *read == path);
            self.given_up_mask = Some(path).filter(|_| !is_it);
        }
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

    /// The file of the user's own mask, also of one that is not read yet.
    pub fn mask_file(&self) -> Option<PathBuf> {
        match (&self.own_mask, &self.mask) {
            (OwnMask::Awaited(path) | OwnMask::Unread(path), _) | (_, MaskChoice::Own { path, .. }) => {
                Some(path.clone())
            }
            _ => None,
        }
    }

    /// Holds back files that are judged as they are read while the user's own tables or mask are awaited, and lets them go
    /// afterwards: nothing is judged by limits that are about to change.
    pub fn in_order(&mut self, effects: Vec<Effect>) -> Vec<Effect> {
        if !self.awaits_tables() && !matches!(self.own_mask, OwnMask::Awaited(_)) {
            return effects.into_iter().chain(std::mem::take(&mut self.held)).collect();
        }
        let is_judged = |effect: &Effect| match effect.errand() {
            Effect::Read(purpose, _) => {
                matches!(purpose, Purpose::Import | Purpose::ImportValues(_) | Purpose::AskColumns(_))
            }
            Effect::ReadColumns { .. } => true,
            _ => false,
        };
        let (held, others): (Vec<_>, Vec<_>) = effects.into_iter().partition(is_judged);
        self.held.extend(held);
        others
    }

    /// Whether the user's own tables, which were used the last time, have not been read yet.
    pub fn awaits_tables(&self) -> bool {
        matches!(self.sources.absent(), Some(Absent::Awaited(_)))
    }

    /// Looks limits up in other sources.
    /// Another base is asked after the own tables; where there are some, that is said.
    pub fn use_base(&mut self, base: Base) {
        let sources = self.sources.as_ref().clone().with_base(base, shipped_tables);
        let names: Vec<_> = sources.own().iter().map(|table| table.name()).collect();
        if !names.is_empty() {
            self.note(message!("limits-own-stay").text("names", names.join(", ")), Vec::new());
        }
        self.use_sources(sources);
    }

    pub fn use_sources(&mut self, sources: Sources) {
        self.sources = Arc::new(sources);
        self.spread(News::Sources);
    }

    /// Tells the user what failed.
    pub fn tell(&mut self, message: Message) {
        self.notices.push(Notice::of(message, true));
    }

    /// Tells the user that checks are not recorded, and offers to try again: one notice for all of them.
    pub fn tell_of_records(&mut self, message: Message) {
        self.notices.retain(|notice| !notice.records);
        self.notices.push(Notice { records: true, ..Notice::of(message, true) });
    }

    /// Tells the user what was done.
    pub fn note(&mut self, message: Message, details: Vec<Message>) {
        self.notices.push(Notice { details, ..Notice::of(message, false) });
    }

    /// Puts checks of the history in their places that were judged again, here and as corrections in the journal. `false` where one of them
    /// cannot be corrected now.
    pub fn judge_again(&mut self, again: Vec<(RecordId, Arc<Record>)>, reason: &str) -> bool {
        let is_sent = self.recording.judge_again(&again, reason);
        if is_sent {
            self.history.judge_again(again);
        }
        is_sent
    }

    /// Undo took checks back: the records of those that stand are withdrawn. Returns whether there are any.
    pub fn withdraw(&mut self, taken: BTreeSet<RecordId>, standing: &[RecordId]) -> bool {
        let number = |id: &RecordId| match self.recording.of_check(*id) {
            Some(Recorded::Kept(number)) => Some(number),
            _ => None,
        };
        let numbers = standing.iter().filter_map(number).collect();
        let reason = self.recorded_words().get("records-page-undone-reason");
        let has_any = self.recording.take_back(&taken, standing, reason);
        self.go_on_undoing();
        self.spread(News::Undone { ids: taken, numbers });
        has_any
    }

    /// Withdraws what undo took back and what is written by now.
    pub fn go_on_undoing(&mut self) {
        for told in self.recording.go_on_undoing() {
            self.note(told, Vec::new());
        }
    }

    /// Tells the user what was done, where there are details.
    pub fn note_details(&mut self, message: Message, details: Vec<Message>) {
        if !details.is_empty() {
            self.note(message, details);
        }
    }

    /// The newest notice tells of the last change of the history, and offers to undo it.
    pub fn note_change(&mut self) {
        let change = self.history.last_change();
        if let Some(notice) = self.notices.newest_mut() {
            notice.change = change;
        }
    }

    pub fn open_dialog(&mut self, purpose: Purpose, path: String) {
        self.dialogs += 1;
        self.dialog = Some(Dialog::new(DialogId(self.dialogs), purpose, path, self.places.folder(purpose)));
    }

    pub fn refuse_dialog(&mut self, problem: Message) {
        if let Some(dialog) = &mut self.dialog {
            dialog.busy = false;
            dialog.problem = Some(problem);
        }
    }

    /// The dialog to which an answer belongs, while it is open; it may have been closed, and another one opened.
    pub fn answered_dialog(&mut self) -> Option<&mut Dialog> {
        let answered = self.answered;
        self.dialog.as_mut().filter(|dialog| answered == Some(dialog.number))
    }

    /// Whether the dialog that sent a file to work is still open.
    pub fn dialog_waits(&self) -> bool {
        self.dialog.as_ref().is_some_and(|dialog| dialog.busy && self.answered == Some(dialog.number))
    }

    /// The content of a file that a dialog asked for. The dialog closes, or shows what is wrong with the file; if it
    /// was closed before, a notice shows it.
    pub fn file_answered<T>(&mut self, result: Result<T, Message>) -> Option<T> {
        match result {
            Ok(read) => {
                if self.dialog_waits() {
                    self.dialog = None;
                }
                Some(read)
            }
            Err(problem) => {
                if self.dialog_waits() {
                    self.refuse_dialog(problem);
                } else {
                    self.tell(problem);
                }
                None
            }
        }
    }
}
