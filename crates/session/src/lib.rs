//! The state of the application, and the only place that changes it.
//!
//! Menu, key, button, file and test send a [`Command`]; [`Session::apply`] changes the state and answers with
//! [`Effect`]s for the world outside. No file, thread, clock or window is touched here: the time comes in.
//!
//! Pages of the same shape, each in a folder of its name, as in `gui`: its state, its text fields (`field`), what can be
//! done (`command`, `actions`) and how (`apply`). A page changes itself and what belongs to all (`shared`), never another
//! page. One line in `page` ties it to everything that has to name every page.
//!
//! | file | what |
//! |---|---|
//! | `check` | one part against its limits |
//! | `fit` | hole against shaft |
//! | `cycles` | a measuring cycle on a workpiece or on recorded contacts |
//! | `tables` | tables of deviations against ISO 286 |
//! | `program` | an NC program is run and stepped |
//! | `pairing` | measured holes against measured shafts |
//! | `budget` | how sure a measured value is |
//! | `records` | everything that was recorded |
//! | `statistics` | the values of a feature as a series |
//! | `reports` | reports to print, to sign and to keep |
//! | `parts` | plans of whole parts, and the walk through them |
//! | `help` | the manual, and the keys |
//! | `settings_page` | everything that can be set |
//! | `gauges` | gauges on serial and USB ports: what is set, what came, where values go |
//! | `rows` | the rows of a file that is too large for the history |
//! | `operator` | Enter, and the verdict that rests until it was read |
//! | `own_texts`, `choosing_texts` | the user's own texts, and in whose words what is said |
//! | `shared`, `notice`, `history`, `recording`, `workpiece`, `part`, `tools` | what belongs to every page; `readers` reads it |
//! | `document` | what is edited and has a file: unsaved changes are asked about before they are lost |
//! | `asking` | questions that Enter answers, and none in passing |
//! | `page`, `state` | the list of the pages; what every page is |
//! | `command`, `effect` | every command, and what it asks of the outside world |
//! | `field`, `field_table`, `fields` | every text field; its name, its place, its paragraph of the manual; finding them |
//! | `treated` | what F1 opens in a field or in a part that folds away |
//! | `texts`, `typing` | the texts in fields, and what typing does |
//! | `purpose`, `settings`, `zoom`, `ruler`, `step` | what files are for; how the window looks; how large a millimetre is; every step from one thing to the next |
//! | `action` | what a user can do by menu, button or key |
//! | `files` | dialogs, and what comes back from files |
//! | `palette` | everything that can be done, found by its name |
//! | `columns` | the columns of files of measurements, as they are corrected and remembered |
//! | `saved` | what survives a restart |
//!
//! To add a page, begin here; `gui/mod.rs` has the other half:
//!
//! 1. Write its folder: `mod.rs` (state), `field.rs` (text fields), `command.rs` and `apply.rs` (what can be done, and how: the trait
//!    `PageState` in `state.rs`), `actions.rs` (menus, buttons, keys, what Enter does, and the [`action::Part`] of a list or table that
//!    takes keys; add that to [`focused`]). `pairing` is a small one to read first.
//! 2. Add its line to `page.rs`, with the page of the manual that F1 opens, its `mod` and `pub use` here. Ctrl with a digit opens the first
//!    nine pages.
//! 3. Add what survives a restart beside texts to `saved.rs`, with a default where a state file lacks it.
//! 4. Test it without a window in `tests/core/session_NAME.rs`.

/// `From` the value of a variant, for variants that each hold a different type.
macro_rules! from_variants {
    ($whole:ident: $($variant:ident($part:ty)),+) => {
        $(impl From<$part> for $whole {
            fn from(part: $part) -> Self {
                Self::$variant(part)
            }
        })+
    };
}

pub mod action;
mod asking;
mod budget;
mod check;
mod choosing_texts;
mod columns;
mod command;
mod cycles;
mod document;
mod effect;
mod field;
mod field_table;
mod fields;
mod files;
mod fit;
mod gauges;
pub mod help;
mod history;
mod notice;
mod operator;
mod own_texts;
mod page;
mod pairing;
mod palette;
mod part;
pub mod parts;
pub mod program;
mod purpose;
mod readers;
mod recording;
pub mod records;
mod reports;
mod rows;
mod ruler;
mod saved;
mod settings;
mod settings_page;
mod shared;
mod sound;
mod state;
pub mod statistics;
mod step;
pub mod tables;
mod texts;
mod tools;
mod treated;
mod typing;
mod workpiece;
mod zoom;

use std::path::Path;
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use jiff::civil::DateTime;

pub use action::{Action, WindowAction, WorkpieceAction};
pub use budget::{
    Asks, Bar, BothSizes, BudgetAction, BudgetCommand, BudgetDocument, BudgetField, BudgetForce, BudgetPage,
    BudgetView, GivenAs, KindChoice, OpenBudget, Readings, TakenContacts, UseOf, WrittenContribution, advice, bars,
};
pub use check::{
    CheckAction, CheckCommand, CheckField, CheckInputs, CheckPage, DoubtedText, Lot, MeasureBy, Question, RuleChoice,
    RuleFields, ShownCheck, UncertaintyFrom, rule_name_id,
};
pub use columns::{
    ColumnChoice, ColumnsCommand, ColumnsRequest, NoticeColumns, OpenColumns, UnitLess, UsedColumns, refusal, role_id,
    unit_id,
};
pub use command::Command;
pub use cycles::{
    Axis, ContactsFrom, CycleField, CycleRun, CyclesAction, CyclesCommand, CyclesPage, RunLog, ValueOrigin,
    WorkpieceField, WorkpieceForm, fold_name, group_name, may_fold,
};
pub use document::OpenDocument;
pub use effect::Effect;
pub use field::Field;
pub use field_table::FieldPlace;
pub use fields::FieldDrawing;
pub use files::{
    Content, Dialog, DialogId, FilesAction, FilesCommand, FolderList, HEAD, Launch, OpenError, ReadOutcome, RecentFile,
    Working,
};
pub use fit::{
    ClassMap, Equivalent, FRICTION, FitAction, FitCommand, FitField, FitPage, MapCell, Mark, MeasuredParts, Picture,
    PictureZone, WarmFit, extremes,
};
use fitcheck_core::tolerance::fit::thermal::Temperature;
use fitcheck_core::tolerance::{Absent, Sources};
use fitcheck_core::verdict::Rule;
use fitcheck_core::words::Language;
use fitcheck_nc::control::mask::Mask;
use fitcheck_nc::control::shipped_tables;
pub use gauges::{FromGauge, GaugeAction, GaugeCommand, GaugeLine, Gauges, OpenGauge, PortState};
pub use help::{HelpAction, HelpCommand, HelpField, HelpPage};
pub use history::{ChangeId, History, ListCommand, status_text};
pub use notice::Notice;
pub use own_texts::{ChosenTexts, TextsState};
pub use page::Page;
pub use pairing::{
    Bin, FromMiddle, Marks, PairRow, Paired, PairingAction, PairingCommand, PairingField, PairingPage, PairingView,
    PairsPicture, usable,
};
pub use palette::{Palette, PaletteCommand, PaletteEntry, PaletteGroup};
pub use part::{feature_message, shape_id};
pub use parts::{PartsAction, PartsCommand, PartsField, PartsPage, PlanField, WalkField};
pub use program::{ProgramAction, ProgramCommand, ProgramField, ProgramPage};
pub use purpose::{CycleFile, ImportInto, Purpose};
pub use recording::{Keeping, MOST_NAMES, Named, OpenJournal, RESTORED, Recorded, Recording};
pub use records::{RecordRow, RecordsAction, RecordsCommand, RecordsField, RecordsPage};
pub use reports::{Drawing, Magnification, ReportOf, ReportsAction, ReportsCommand, ReportsField, ReportsPage};
pub use rows::{End, LARGE, Large, Listed, News, Rows, RowsCommand, ShownRow, row_forms};
pub use ruler::{Ruler, RulerStep};
pub use saved::{
    Saved, SavedCycles, SavedError, SavedFile, SavedFiles, SavedGauge, SavedInputs, SavedRecords, SavedReports,
    SavedWalk, SavedWatch,
};
pub use settings::{DecimalSign, Density, Mode, RowHeight, Theme};
pub use settings_page::{
    Control, KeyRow, KeysOfPlace, SETTINGS, Section, Setting, SettingsAction, SettingsCommand, SettingsField,
    SettingsPage, Told,
};
pub use shared::MaskChoice;
use shared::OwnMask;
pub use sound::Rhythm;
pub use statistics::{StatisticsAction, StatisticsCommand, StatisticsField, StatisticsPage};
pub use step::Step;
pub use tables::{TablesAction, TablesCommand, TablesField, TablesPage};
pub use tools::{Monitoring, NamedTool, OpenTools, ToolsCommand, text_of_tool, tool_message};
pub use workpiece::{OpenPart, RecordedContacts, WorkpieceCommand};
pub use zoom::Zoom;

use self::asking::Asking;
use self::files::Places;
use self::page::pages;
use self::shared::Shared;
use self::state::{PageQuestion, PageState as _};

/// What takes the focus as a whole on the pages.
pub mod focused {
    pub use super::check::{HISTORY, ROWS};
    pub use super::fit::CLASSES;
    pub use super::help::TOPICS;
    pub use super::pairing::PAIRS;
    pub use super::parts::{PLAN, SIZES};
    pub use super::program::LISTING;
    pub use super::records::RECORDS;
    pub use super::statistics::{CHART, FEATURES};
    pub use super::tables::CELLS;
}

macro_rules! session {
    ($($(#[$doc:meta])* $page:ident: $folder:ident, $State:ident, $Command:ident, $Field:ident, $Action:ident, $name:literal, $manual:literal;)+) => {
        /// The state of the application.
        #[derive(Debug)]
        pub struct Session {
            shared: Shared,
            $($folder: $State,)+
            /// When a page asked something last.
            asking: Asking,
            /// The palette, while it is open.
            pub palette: Option<Palette>,
            /// How often it asked the journal.
            palette_runs: u64,
            /// Whether what is done now was chosen in it.
            by_palette: bool,
        }

        impl Session {
            /// Every page as it was left.
            fn with_pages(saved: &Saved, shared: Shared) -> Self {
                Self { $($folder: $State::restored(saved, &shared),)+ asking: Asking::default(), palette: None, palette_runs: 0, by_palette: false, shared }
            }

            /// Adds what every page keeps.
            fn save_pages(&self, saved: &mut Saved) {
                $(self.$folder.save(saved);)+
            }

            /// Does a command: one of a page, or one that belongs to no page.
            fn apply_command(&mut self, command: Command, now: DateTime) -> Vec<Effect> {
                match command {
                    $(Command::$page(command) => self.$folder.apply(command, &mut self.shared, now),)+
                    command => self.apply_shared(command, now),
                }
            }

            /// Every page hears what happened elsewhere; what it has to do outside comes back.
            fn spread_news(&mut self) -> Vec<Effect> {
                while let Some(news) = self.shared.next_news() {
                    $(self.$folder.follow(&news, &mut self.shared);)+
                }
                let mut errands = Vec::new();
                $(errands.extend(self.$folder.take_errands());)+
                errands
            }

            /// What the open page asks before it does something.
            fn page_asks(&self) -> Option<PageQuestion> {
                match self.page() {
                    $(Page::$page => self.$folder.asks(),)+
                }
            }

            /// Whether an action would only do once more what stands on screen: Enter repeats nothing, its button and keys do.
            fn repeats(&self, action: Action) -> bool {
                [$(self.$folder.repeated()),+].contains(&Some(action))
            }

            /// The command that closes the topmost thing over the open page.
            fn closes_on_page(&self) -> Option<Command> {
                match self.page() {
                    $(Page::$page => self.$folder.closes(),)+
                }
            }

            /// The names of documents with unsaved changes.
            pub fn unsaved(&self) -> Vec<String> {
                let mut names = Vec::new();
                $(names.extend(self.$folder.unsaved());)+
                names
            }

            /// The name of the document whose changes are asked about before another one takes its place.
            pub fn asks_about(&self) -> Option<String> {
                None$(.or_else(|| self.$folder.asks_about()))+
            }

            /// The answer to that question.
            fn discard(&mut self, loses: bool) {
                $(self.$folder.discard(loses, &mut self.shared);)+
            }

            /// A file was written, or not; what the pages say of it.
            fn file_written(&mut self, path: &Path, is_whole: bool) -> Vec<Message> {
                let mut said = Vec::new();
                $(said.extend(self.$folder.file_written(path, is_whole, &mut self.shared));)+
                said
            }

            $($(#[$doc])*
            pub const fn $folder(&self) -> &$State {
                &self.$folder
            })+
        }

        /// The pattern of the commands that went to their pages, or were taken apart.
        macro_rules! applied_before {
            () => {
                $(Command::$page(_))|+ | Command::Answered(..) | Command::Enter(_) | Command::Answer(_)
            };
        }
    };
}

pages!(session);

impl Session {
    /// A session with ISO 286 as source of limits and empty fields.
    pub fn new(language: Language) -> Self {
        Self::restore(Saved { language, ..Saved::default() }).0
    }

    /// A session from what was saved. The tables' folder and the budget that checks used are read by the effects that come
    /// with it; until the answer of the first comes, nothing is judged by a class.
    pub fn restore(saved: Saved) -> (Self, Vec<Effect>) {
        let mut shared = Shared::new(saved.language, saved.theme, saved.records.clone());
        shared.mode = saved.mode;
        shared.ruler = saved.ruler;
        shared.pin.clone_from(&saved.pin);
        shared.keypad = saved.keypad;
        shared.sounds = saved.sounds;
        shared.places = Places::restore(saved.files.clone());
        shared.density = saved.density;
        shared.rows = saved.rows;
        shared.decimal = saved.decimal;
        shared.welcomes = !saved.welcomed;
        shared.zoom = saved.zoom;
        shared.columns = columns::Columns::restore(saved.columns.clone());
        let awaited = saved.tables_folder.as_ref().map(|folder| Absent::Awaited(folder.to_string_lossy().into()));
        let sources = Sources::default().with_base(saved.source, shipped_tables).with_options(saved.standard);
        shared.sources = Arc::new(sources.with_absent(awaited));
        if saved.walk.plan.is_some() {
            // An interrupted part goes on where it was.
            shared.page = Page::Parts;
        }
        // A folder that cannot be read now may be there the next time.
        shared.tables_folder.clone_from(&saved.tables_folder);
        shared.own_mask = saved.mask.clone().map_or(OwnMask::Settled, OwnMask::Awaited);
        shared.own_texts = saved.own_texts.clone().map(|path| ChosenTexts { path, state: TextsState::Awaited });
        let mut session = Self::with_pages(&saved, shared);
        let gauges = session.settings_page.take_errands();
        let tables = saved.tables_folder.map(|folder| Effect::Read(Purpose::LoadTables, folder));
        let mask = saved.mask.map(|path| Effect::Read(Purpose::LoadMask, path));
        let texts = saved.own_texts.map(|path| Effect::Read(Purpose::LoadTexts, path));
        let budget = saved.budget.map(|path| Effect::Read(Purpose::UseBudget, path));
        // The plan of a part that was interrupted.
        let plan = saved.walk.plan.or_else(|| saved.walk.watched.map(|watched| watched.plan));
        let plan = plan.map(|path| Effect::Read(Purpose::OpenPlan, path));
        (session, tables.into_iter().chain(mask).chain(texts).chain(budget).chain(plan).chain(gauges).collect())
    }

    /// What survives a restart.
    pub fn saved(&self) -> Saved {
        let mut saved = Saved {
            language: self.shared.language,
            theme: self.shared.theme,
            mode: self.shared.mode,
            ruler: self.shared.ruler,
            pin: self.shared.pin.clone(),
            keypad: self.shared.keypad,
            sounds: self.shared.sounds,
            density: self.shared.density,
            rows: self.shared.rows,
            decimal: self.shared.decimal,
            welcomed: !self.shared.welcomes,
            zoom: self.shared.zoom,
            // A path that is not text cannot be written.
            tables_folder: self.shared.tables_folder.clone().filter(|folder| folder.to_str().is_some()),
            mask: self.shared.mask_file().filter(|path| path.to_str().is_some()),
            own_texts: self.own_texts().map(|texts| texts.path.clone()).filter(|path| path.to_str().is_some()),
            source: self.shared.sources.base(),
            standard: self.shared.sources.options(),
            files: self.shared.places.saved(),
            columns: self.shared.columns.saved(),
            records: self.shared.recording.saved(),
            ..Saved::default()
        };
        self.save_pages(&mut saved);
        saved
    }

    /// The user's own mask by its name: what it has printed is read back through it. Nothing where a built-in one is chosen.
    pub const fn own_masks(&self) -> &Arc<Vec<(String, Mask)>> {
        &self.shared.own_masks
    }

    /// Applies a command at a local date and time, and returns what the outside world has to do.
    pub fn apply(&mut self, command: Command, now: DateTime) -> Vec<Effect> {
        if let Command::Answered(dialog, answer) = command {
            self.shared.answered = Some(dialog);
            let effects = self.apply(*answer, now);
            self.shared.answered = None;
            return effects;
        }
        if let Command::Enter(field) = command {
            return self.enter(field, now);
        }
        if let Command::Answer(place) = command {
            // The second click of two comes where the answer has just appeared.
            let answer = self.answers().get(place).copied().filter(|_| !self.asking.is_in_passing(now));
            let command = answer.and_then(|action| action.command(self));
            return command.map_or_else(Vec::new, |command| self.apply(command, now));
        }
        if matches!(command, Command::Check(CheckCommand::Undo))
            && let Some(field) = self.half_typed()
        {
            let mut effects = self.apply(field.typed(String::new()), now);
            effects.push(Effect::Focus(field));
            return effects;
        }
        let asked_before = self.asks_for_enter();
        self.budget.see_day(now.date());
        self.shared.recording.now = now;
        self.statistics.see_part(self.parts.part());
        self.shared.recording.named = self.check.named();
        self.shared.take_worth(self.check.own_worth());
        let before = self.is_setting(&command).then(|| self.saved());
        let checks = self.shared.history.len();
        // What a journal had is shown, and was measured before.
        let is_measuring = !matches!(command, Command::Records(_));
        let hears = matches!(command, Command::UseSounds(true)).then_some(Rhythm::Long);
        let mut effects = self.apply_command(command, now);
        let copied = effects.iter().find_map(|effect| if let Effect::Copy(text) = effect { Some(text) } else { None });
        if let Some(text) = copied {
            self.shared.notices.push(Notice::of(message!("copied").count("lines", text.lines().count()), false));
        }
        if let Some(before) = before {
            self.note_setting(before);
        }
        // Who has a verdict needs no first steps any more.
        self.shared.welcomes &= self.shared.history.len() <= checks;
        let came = if is_measuring { self.shared.history.len().saturating_sub(checks) } else { 0 };
        let newest = self.shared.history.newest(came);
        if newest.iter().any(|record| record.verdict.asks_for_a_look()) {
            self.settings_page.gauges.saw_not_good(now);
        }
        let heard = newest.iter().filter_map(|record| Rhythm::of(record)).max().or(hears);
        effects.extend(heard.filter(|_| self.shared.sounds).map(Effect::Sound));
        self.shared.take_worth(self.check.own_worth());
        let errands = self.spread_news();
        if let Some(format) = self.records.report_soon.take() {
            self.open_dialog(Purpose::ReportRecords(format), now);
        }
        if self.shared.page == Page::Program {
            let (callout, position) = self.check.for_set();
            let given = program::ForSet { callout, position, plan: self.parts.for_set() };
            self.program.make_set(given, &self.shared);
        }
        let shared = &mut self.shared;
        let to_read = shared.dialog.as_mut().and_then(|dialog| dialog.list.take_unread());
        effects.extend(to_read.map(Effect::List));
        effects.extend(errands);
        effects.extend(self.draw_report(now));
        let shared = &mut self.shared;
        effects.extend(shared.recording.take_errands());
        let effects = shared.in_order(effects);
        if !asked_before && self.asks_for_enter() {
            self.asking.ask(now);
        }
        effects
    }

    /// Applies a command that belongs to no page.
    fn apply_shared(&mut self, command: Command, now: DateTime) -> Vec<Effect> {
        let shared = &mut self.shared;
        match command {
            applied_before!() => {}
            Command::Workpiece(command) => {
                let cycles = &self.cycles;
                let program = &self.program;
                shared.apply_workpiece(command, |shared| match shared.page {
                    Page::Program => program.suited(shared).map(Ok),
                    _ => Some(cycles.suited(shared)),
                });
            }
            Command::Tools(command) => shared.apply_tools(command),
            Command::Palette(command) => return self.take_palette(command, now),
            Command::OpenPage(page) => shared.open(page),
            Command::SoundFailed(why) => shared.tell(why),
            Command::DroppedOnOperator(name) => shared.tell(message!("operator-dropped").text("name", name)),
            Command::GoTo(field) => return vec![Effect::Focus(field)],
            Command::GoOn => return self.go_on(),
            Command::SetMode(mode) => return self.set_mode(mode),
            Command::SetRuler(_)
            | Command::ShowKeypad(_)
            | Command::UseSounds(_)
            | Command::SetLanguage(_)
            | Command::SetTheme(_)
            | Command::SetDensity(_)
            | Command::SetRows(_)
            | Command::SetDecimal(_)
            | Command::SetZoom(_)
            | Command::Welcome(_)
            | Command::Touched(_) => shared.look(&command),
            Command::SetMask(language) => {
                shared.set_mask(language.map_or(MaskChoice::OfLanguage, MaskChoice::Shipped));
            }
            Command::Files(command) => return self.apply_files(command, now),
            Command::Columns(command) => return self.apply_columns(command, now),
            Command::OpenDialog(purpose) => return self.ask_for_file(purpose, now),
            Command::TypePath(path) => {
                if let Some(dialog) = &mut shared.dialog {
                    dialog.type_path(path);
                }
            }
            Command::Browse => return self.browse(),
            Command::Picked(path) => return self.picked(path.as_deref(), now),
            Command::Confirm => return self.confirm(now),
            Command::Close => self.close(),
            Command::CloseNotice => shared.notices.close(),
            Command::ShowMessages(shows) => shared.notices.shows_earlier = shows,
            Command::ForgetMessages => shared.notices.forget_earlier(),
            Command::AskToLeave => {
                if !self.would_lose() {
                    return vec![Effect::Leave];
                }
                self.shared.leaving = true;
            }
            Command::Discard(loses) => self.discard(loses),
            Command::Leave(false) => shared.leaving = false,
            Command::Leave(true) => return vec![Effect::Leave],
            Command::MaskRead { path, result } => self.mask_read(path, result),
            Command::TablesRead { folder, result } => self.tables_read(folder, result),
            Command::SettingsRead { path, result } => return self.settings_read(&path, result, now),
            Command::NoOwnTables => self.use_tables(Vec::new(), None),
            Command::TextsRead { path, result } => self.texts_read(path, result),
            Command::NoOwnTexts => self.leave_texts(),
            Command::UseSource(base) => shared.use_base(base),
            Command::SetStandard(options) => {
                let sources = shared.sources.as_ref().clone().with_options(options);
                shared.use_sources(sources);
            }
            Command::BackToDefaults(section) => {
                let commands = self.commands_to_defaults(section);
                return commands.into_iter().flat_map(|command| self.apply(command, now)).collect();
            }
            Command::SettingBack => return self.setting_back(now),
            Command::Heard { run, news } => return self.heard(run, news, now),
            Command::Saved { path, result } => self.saved_file(&path, result),
        }
        Vec::new()
    }

    /// From which temperature the values of files are brought to 20 °C; `None` where they count as they are.
    pub fn temperature(&self) -> Option<Temperature> {
        self.check.own_worth().temperature()
    }

    /// The rule that the next value of the check page is judged by, as far as it is known before the value is.
    pub fn rule_ahead(&self) -> Option<Rule> {
        let asked = &self.check.asked;
        asked.worth.rule_ahead(asked.limits.as_ref()?, self.used_budget())
    }

    /// The answers to what the open page asks, the highlighted one first; none where nothing is asked.
    pub fn answers(&self) -> Vec<Action> {
        self.page_asks().map_or_else(Vec::new, |question| question.answers)
    }

    /// What Enter does in a text field of the open page now: what it always does, or the highlighted answer where the page asks about that.
    pub fn on_enter(&self, field: Field) -> Option<Action> {
        let usual = Action::on_enter(field, self.page())?;
        let question = self.page_asks().filter(|question| question.about == usual);
        question.and_then(|question| question.answers.first().copied()).or(Some(usual))
    }

    /// The budget whose uncertainty checks may use.
    pub fn used_budget(&self) -> Option<&OpenBudget> {
        self.shared.budget.as_deref()
    }

    /// What checks do with it.
    pub fn budget_force(&self) -> BudgetForce {
        BudgetForce::of(self.check.own_worth().judging)
    }

    /// Whether the rows of a large file are listed in the place of the history.
    pub fn lists_rows(&self) -> bool {
        self.shared.page == Page::Check && self.check.shows_rows()
    }
}
