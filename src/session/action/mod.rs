//! Everything that a user can do by menu, button or key: what it is called, its keys, where it applies, whether it is
//! possible now, and the command that it sends.
//!
//! | file | what |
//! |---|---|
//! | here | the list, and what is asked of it |
//! | `table` | a row for every entry |
//! | `shortcut` | keys, without a window |
//!
//! Choices among what a user has (a class, a table of the list, a block) are not actions: they send commands.

mod shortcut;
mod table;

pub use shortcut::{Held, Key, Shortcut};

use self::table::Row;
use super::cycles::CyclesCommand;
use super::program::{ProgramField, Switch};
use super::tables::{self, TablesField};
use super::workpiece::WorkpieceCommand;
use super::{CheckField, Command, Density, Field, MeasureBy, Page, Session, Step, Theme};
use crate::exchange::tables::TABLE_FORMATS;
use crate::journal::query::Column;
use crate::length::Length;
use crate::message::Message;
use crate::report::RENDERINGS;
use crate::tolerance::{Base, Feature};
use crate::verdict::Status;
use crate::words::Words;

/// Where an action applies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Place {
    /// On every page.
    Everywhere,
    /// On the pages that measure the simulated workpiece.
    Workpiece,
    /// On a page.
    Page(Page),
    /// In the focused part of a page.
    Part(Part),
}

/// A part of a page that takes the focus as a whole.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Part {
    /// The map of classes on the fit page.
    Classes,
    /// The cells of the table page.
    Cells,
    /// The listing of the program page.
    Listing,
    /// The list of checks on the check page.
    History,
}

impl Part {
    /// The parts of all pages.
    pub const ALL: [Self; 4] = [Self::Classes, Self::Cells, Self::Listing, Self::History];

    /// The page that it belongs to.
    pub const fn page(self) -> Page {
        match self {
            Self::Classes => Page::Fit,
            Self::Cells => Page::Tables,
            Self::Listing => Page::Program,
            Self::History => Page::Check,
        }
    }
}

impl Place {
    /// Whether it is on a page.
    pub fn is_on(self, page: Page) -> bool {
        match self {
            Self::Everywhere => true,
            Self::Workpiece => matches!(page, Page::Cycles | Page::Program),
            Self::Page(of) => of == page,
            Self::Part(part) => part.page() == page,
        }
    }

    /// The nearer place goes first: where two places use the same keys, the smaller one takes them.
    const fn rank(self) -> u8 {
        match self {
            Self::Part(_) => 0,
            Self::Page(_) => 1,
            Self::Workpiece => 2,
            Self::Everywhere => 3,
        }
    }
}

/// The list; an action with a value is one action for each of its values.
macro_rules! actions {
    ($($(#[$doc:meta])* $name:ident $(($of:ty): $all:expr)?;)*) => {
        /// Something that a user can do by menu, button or key.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Action {
            $($(#[$doc])* $name $(($of))?,)*
        }

        impl Action {
            /// Every action, in the order of the pages.
            pub fn all() -> impl Iterator<Item = Self> {
                let mut all = Vec::new();
                $(actions!(@add all $name $($all)?);)*
                all.into_iter()
            }
        }
    };
    (@add $list:ident $name:ident) => { $list.push(Self::$name) };
    (@add $list:ident $name:ident $all:expr) => { $list.extend($all.into_iter().map(Self::$name)) };
}

actions! {
    /// Opens a page.
    Open(Page): Page::ALL;
    /// Reads measurements.
    Import;
    /// Writes the checks in a format of the report's list, by its number there.
    Export(usize): 0..RENDERINGS.len();
    /// Writes the status window's text.
    ExportStatus;
    /// Chooses light, dark, or the system's setting.
    UseTheme(Theme): [Theme::System, Theme::Light, Theme::Dark];
    /// Chooses how high everything is that is pressed.
    UseDensity(Density): Density::ALL;
    /// Looks limits up in a source of the list.
    UseSource(Base): Base::ALL;
    /// Rounds the halves of js, or not.
    RoundJs;
    /// Uses the edition of 1988, or the one of 2010.
    Edition1988;
    /// Reads a folder of the user's own tables.
    LoadTables;
    /// Stops using the user's own tables.
    NoOwnTables;
    /// Reads a mask.
    LoadMask;
    /// Undoes the last change of the history.
    Undo;
    /// Empties the history.
    ClearHistory;
    /// Chooses every listed check that is not good for export.
    ChooseBad;
    /// Chooses none.
    ChooseNone;
    /// Shows or hides the keypad.
    Keypad;
    /// Closes what lies over the page: a dialog, a window, the oldest notice.
    Close;

    /// Measures and judges.
    Measure;
    /// Judges a typed value that was asked about, as it is.
    JudgeAnyway;
    /// Takes what a typed value may have been instead of it.
    TakeMeant;
    /// Shows another row of the imported file, worst first.
    ShowInLot(Step): Step::PATH;
    /// Clears the result.
    ClearResult;
    /// Chooses where the next measurement comes from.
    MeasureBy(MeasureBy): [MeasureBy::Typing, MeasureBy::Simulating];
    /// Puts the status window's text on the clipboard.
    CopyStatus;
    /// Goes to the filter of the history.
    FindInHistory;
    /// Leaves the good checks out of the list.
    OnlyBad;
    /// Sorts the list by a column.
    SortHistory(Column): Column::ALL;
    /// Goes to another check of the list.
    MoveCheck(Step): Step::BLOCKS;
    /// Shows the check again.
    ShowCheck;
    /// Chooses the check for export, or not.
    ChooseCheck;
    /// Chooses every check of the list.
    ChooseAll;
    /// Puts the chosen checks, or the one at which the keys are, on the clipboard.
    CopyChecks;

    /// Goes to another class of the map.
    MoveClass(Step): Step::CLASSES;
    /// Shows the map of hole classes or of shaft classes.
    ShowClasses(Feature): [Feature::Hole, Feature::Shaft];
    /// Takes one side of the fit to the check page.
    CheckPart(Feature): [Feature::Hole, Feature::Shaft];

    /// Runs the cycle.
    RunCycle;
    /// Clears the result.
    ClearCycle;
    /// Steps along the path.
    StepPath(Step): Step::PATH;
    /// Opens the dialog of the simulated workpiece.
    EditWorkpiece;
    /// Makes a simulated workpiece that suits the page's inputs.
    SuitWorkpiece;
    /// Reads a simulated workpiece.
    OpenWorkpiece;
    /// Writes the simulated workpiece.
    SaveWorkpiece;
    /// Reads recorded contacts.
    OpenContacts;
    /// Reads a touch-probe table.
    OpenProbes;
    /// Takes the built-in touch-probe table.
    ShippedProbes;
    /// Opens the field for an NC block.
    PasteBlock;
    /// Fills the form from the NC block.
    TakeBlock;
    /// Puts the form as an NC block on the clipboard.
    CopyBlock;
    /// Puts the status window's text on the clipboard.
    CopyCycleStatus;
    /// Puts the results on the clipboard.
    CopyResults;
    /// Writes the measuring log.
    SaveLog;

    /// Reads a table.
    OpenTable;
    /// Writes the shown table in a format of the tables' list, by its number there.
    SaveTable(usize): 0..TABLE_FORMATS.len();
    /// Undoes the last edit of the shown table.
    UndoEdit;
    /// Redoes it.
    RedoEdit;
    /// Looks limits up in the shown table first.
    UseTable;
    /// Goes to the filter.
    FindInTable;
    /// Selects the previous cell that differs from ISO 286.
    PreviousDifference;
    /// Selects the next one.
    NextDifference;
    /// Goes to another cell.
    MoveCell(Step): Step::CELLS;
    /// Goes to the fields of the cell.
    EditCell;
    /// Puts the fields into the cell.
    SetCell;
    /// Puts what ISO 286 says into the cell.
    TakeStandard;
    /// Empties the cell.
    EmptyCell;
    /// Adds classes to the shown table.
    AddColumns;
    /// Removes the selected cell's class.
    RemoveColumn;
    /// Makes a table from ISO 286.
    MakeTable;

    /// Reads an NC program.
    OpenProgram;
    /// Runs the program.
    RunProgram;
    /// Pauses it.
    PauseProgram;
    /// Runs one block.
    StepProgram;
    /// Runs one block, including everything that it calls.
    StepOver;
    /// Runs up to the selected block.
    RunToSelected;
    /// Sets a breakpoint at the selected block, or removes it.
    ToggleBreakpoint;
    /// Goes back to before the first block.
    ResetProgram;
    /// Switches an option of the run on or off.
    Switch(Switch): Switch::ALL;
    /// Goes to another block.
    MoveBlock(Step): Step::BLOCKS;
    /// Gives a parameter a value at the next start.
    GiveValue;
}

impl Action {
    fn row(self) -> Row {
        table::row(self)
    }

    /// Where it applies.
    pub fn place(self) -> Place {
        self.row().place
    }

    /// All its keys, even those that another action takes first. The first one is shown to the user.
    pub fn shortcuts(self) -> impl Iterator<Item = Shortcut> {
        self.row().keys.into_iter().flatten()
    }

    /// The keys that are shown on a page; `None` where it has none, or where another action of the page takes them.
    pub fn shortcut_on(self, page: Page) -> Option<Shortcut> {
        let first = self.shortcuts().next().filter(|_| self.place().is_on(page))?;
        (!self.leaves_to_another(first, page)).then_some(first)
    }

    /// Whether another action of the page takes these keys, also while it is not possible: Ctrl+Z on the table page never
    /// undoes what is not in sight.
    fn leaves_to_another(self, keys: Shortcut, page: Page) -> bool {
        let rank = self.place().rank();
        let takes = |other: Self| {
            let place = other.place();
            place.is_on(page) && place.rank() < rank && other.shortcuts().any(|other| other == keys)
        };
        // Escape belongs to whatever can use it: a run that goes on, or what lies over the page.
        keys.key != Key::Escape && Self::all().any(takes)
    }

    /// What Enter does in a text field of a page.
    pub const fn on_enter(field: Field, page: Page) -> Option<Self> {
        match (field, page) {
            (Field::Program(ProgramField::Filter) | Field::Check(CheckField::HistoryFilter), _) => None,
            (Field::Program(ProgramField::Name | ProgramField::Value), _) => Some(Self::GiveValue),
            (Field::Tables(TablesField::CellUpper | TablesField::CellLower), _) => Some(Self::SetCell),
            (Field::Tables(TablesField::To), _) => Some(Self::MakeTable),
            (_, Page::Check) => Some(Self::Measure),
            (_, Page::Cycles) => Some(Self::RunCycle),
            (_, Page::Program) => Some(Self::RunProgram),
            (_, Page::Fit | Page::Tables) => None,
        }
    }

    /// Its name, in the words of a language.
    pub fn text(self, session: &Session, words: &Words) -> String {
        match self {
            Self::Export(number) => {
                RENDERINGS.get(number).map(|to| words.get(&format!("export-{}", to.name))).unwrap_or_default()
            }
            Self::SaveTable(number) => {
                let format = TABLE_FORMATS.get(number).map(|format| words.get(format.description));
                capitalised(&format.map(|format| format!("{format}…")).unwrap_or_default())
            }
            Self::RemoveColumn => {
                let selected = session.tables().shown().and_then(tables::Document::selected);
                let class = selected.map_or_else(|| words.get("class-none"), |(class, _)| class.to_string());
                words.say(&Message::new("tables-remove-column").text("class", class))
            }
            Self::JudgeAnyway | Self::TakeMeant => {
                let mm = |length: Option<Length>| length.map(|length| words.mm(length, 3)).unwrap_or_default();
                let question = session.check().question();
                let message = Message::new(self.row().text)
                    .text("measured", mm(question.map(|question| question.measured)))
                    .text("meant", mm(question.and_then(|question| question.doubt.meant())));
                words.say(&message)
            }
            Self::Undo => {
                let what = session.history().undoes();
                what.map_or_else(
                    || words.get("undo"),
                    |what| words.say(&Message::new("undo-what").message("what", what)),
                )
            }
            Self::ChooseBad => words.say(&Message::new("choose-bad").count("count", session.bad_count())),
            Self::UseTable if session.tables().is_used(session.sources()) => words.get("tables-in-use"),
            _ => words.get(self.row().text),
        }
    }

    /// The id of a further explanation.
    pub fn hint(self) -> Option<&'static str> {
        self.row().hint
    }

    /// Whether what it switches is on, where it switches something.
    pub fn is_on(self, session: &Session) -> Option<bool> {
        table::is_on(self, session)
    }

    /// The command that it sends now; `None` where it is not possible.
    pub fn command(self, session: &Session) -> Option<Command> {
        let row = self.row();
        (row.possible)(session).then(|| row.sends.command(session))
    }
}

impl Session {
    /// Whether something can be done now.
    pub fn can(&self, action: Action) -> bool {
        (action.row().possible)(self)
    }

    /// How many listed checks are not good.
    fn bad_count(&self) -> usize {
        let counts = Status::ALL.into_iter().zip(self.history().listed().counts());
        counts.filter(|(status, _)| *status != Status::Good).map(|(_, count)| count).sum()
    }

    /// The command that closes the topmost thing over the page.
    fn uppermost(&self) -> Option<Command> {
        let is_on = |page| self.page() == page;
        let has_notice = !self.notices().is_empty();
        if self.is_leaving() {
            Some(Command::Leave(false))
        } else if self.dialog().is_some() || has_notice {
            Some(Command::Close)
        } else if self.cycles().block().is_some() && is_on(Page::Cycles) {
            Some(CyclesCommand::ShowBlock(false).into())
        } else if self.workpiece_is_open() && (is_on(Page::Cycles) || is_on(Page::Program)) {
            Some(WorkpieceCommand::Show(false).into())
        } else {
            None
        }
    }

    /// The actions of the keys now, the nearest place first: `part` has the focus, or a text field (`is_typing`).
    pub fn keys(&self, part: Option<Part>, is_typing: bool) -> Vec<(Shortcut, Action)> {
        let is_covered = self.dialog().is_some() || self.is_leaving();
        let is_heard = |action: Action| match action.place() {
            Place::Everywhere => true,
            // The workpiece's window lies over the listing, and takes Escape.
            Place::Page(Page::Program) if self.workpiece_is_open() => false,
            Place::Part(of) => part == Some(of) && of.page() == self.page(),
            place => place.is_on(self.page()),
        };
        let heard =
            Action::all().filter(|action| if is_covered { *action == Action::Close } else { is_heard(*action) });
        let mut keys: Vec<_> = heard
            .flat_map(|action| action.shortcuts().map(move |shortcut| (shortcut, action)))
            .filter(|(shortcut, action)| !(is_typing && shortcut.is_of_text()) && self.can(*action))
            .filter(|(shortcut, action)| !action.leaves_to_another(*shortcut, self.page()))
            .collect();
        keys.sort_by_key(|(_, action)| action.place().rank());
        keys
    }
}

/// Capitalised, as an entry of a menu.
fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|first| first.to_uppercase().chain(chars).collect()).unwrap_or_default()
}
