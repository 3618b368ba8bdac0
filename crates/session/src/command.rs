//! Every command, and what it asks of the outside world.
//!
//! The list of commands is the window's manual: menu, key, button, test and script all send one of these.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::part::Plan;
use fitcheck_core::tolerance::{Base, DeviationTable, Feature, iso286};
use fitcheck_core::words::{Dialogue, Language};
use fitcheck_exchange::exchange::Mapping;
use fitcheck_exchange::exchange::batch::Part;
use fitcheck_exchange::journal::ask::Question;
use fitcheck_exchange::journal::entry::Entry;
use fitcheck_exchange::report::pairing::Asked;
use fitcheck_files::FileError;
use fitcheck_nc::control::mask::Mask;

use super::budget::BudgetCommand;
use super::check::CheckCommand;
use super::columns::ColumnsCommand;
use super::cycles::CyclesCommand;
use super::field::Field;
use super::files::{Content, FilesCommand, Launch};
use super::fit::FitCommand;
use super::history::ListCommand;
use super::pairing::PairingCommand;
use super::parts::{PartsCommand, WalkCommand};
use super::program::ProgramCommand;
use super::records::RecordsCommand;
use super::rows::RowsCommand;
use super::tables::TablesCommand;
use super::tools::ToolsCommand;
use super::workpiece::WorkpieceCommand;

/// A change of the state.
#[derive(Debug, Clone)]
pub enum Command {
    /// Does something on the check page.
    Check(CheckCommand),
    /// Does something on the fit page.
    Fit(FitCommand),
    /// Does something on the cycles page.
    Cycles(CyclesCommand),
    /// Does something on the table page.
    Tables(TablesCommand),
    /// Does something on the program page.
    Program(ProgramCommand),
    /// Does something on the pairing page.
    Pairing(PairingCommand),
    /// Does something on the budget page.
    Budget(BudgetCommand),
    /// Does something on the parts page.
    Parts(PartsCommand),
    /// Does something on the records page, or with what is recorded.
    Records(RecordsCommand),
    /// Does something with the columns of a file of measurements.
    Columns(ColumnsCommand),
    /// Does something with the simulated workpiece or recorded contacts.
    Workpiece(WorkpieceCommand),
    /// Does something with the tool table.
    Tools(ToolsCommand),
    /// Does something with the file dialog, recent files or a file that was written.
    Files(FilesCommand),
    OpenPage(Page),
    /// Goes to a field and selects its text.
    GoTo(Field),
    /// Enter was pressed in a field: does what it is for there, or gives the highlighted answer to what is asked.
    Enter(Field),
    /// Shows or hides the keypad.
    ShowKeypad(bool),
    /// Changes the language of the window.
    SetLanguage(Language),
    /// Chooses light, dark, or the system's setting.
    SetTheme(Theme),
    /// Chooses how high everything is that is pressed.
    SetDensity(Density),
    /// A finger touched the window, or a mouse moved over it.
    Touched(bool),
    /// Draws the status window with a built-in mask; `None` is the mask of the language.
    SetMask(Option<Dialogue>),
    /// Asks for a file or a folder.
    OpenDialog(Purpose),
    /// Replaces the path in the dialog.
    TypePath(String),
    /// Shows the system's file dialog.
    Browse,
    /// The system's file dialog answered; `None` when it was cancelled or cannot be shown.
    Picked(Option<PathBuf>),
    /// Does what the dialog is for.
    Confirm,
    /// Closes the dialog or the oldest notice.
    Close,
    /// Asks whether the window may be closed: at once, unless a table or a budget has unsaved changes.
    AskToLeave,
    /// Closes the window without saving, or keeps it open.
    Leave(bool),
    /// A mask was read, or not.
    MaskRead {
        path: PathBuf,
        /// The mask and its warnings.
        result: Result<(Box<Mask>, Vec<Message>), Message>,
    },
    /// A folder of tables was read, or not.
    TablesRead {
        folder: PathBuf,
        /// The tables, and warnings.
        result: Result<(Vec<DeviationTable>, Vec<Message>), Message>,
    },
    /// Stops using the user's own tables.
    NoOwnTables,
    /// Looks limits up in another source, after the user's own tables.
    UseSource(Base),
    /// Chooses where editions of ISO 286 differ.
    SetStandard(iso286::Options),
    /// The answer to what a dialog asked for: it closes that dialog or shows what is wrong, and leaves any other alone.
    Answered(DialogId, Box<Self>),
    /// A file was written, or not.
    Saved {
        path: PathBuf,
        /// Whether that succeeded.
        result: Result<(), FileError>,
    },
}

from_variants!(Command: Check(CheckCommand), Fit(FitCommand), Cycles(CyclesCommand), Tables(TablesCommand));
impl From<RowsCommand> for Command {
    fn from(command: RowsCommand) -> Self {
        Self::Check(CheckCommand::Rows(command))
    }
}

impl From<WalkCommand> for Command {
    fn from(command: WalkCommand) -> Self {
        Self::Parts(PartsCommand::Walk(command))
    }
}

impl From<ListCommand> for Command {
    fn from(command: ListCommand) -> Self {
        Self::Check(CheckCommand::List(command))
    }
}

from_variants!(Command: Pairing(PairingCommand), Budget(BudgetCommand), Records(RecordsCommand), Parts(PartsCommand));
from_variants!(Command: Columns(ColumnsCommand));
from_variants!(Command: Program(ProgramCommand), Workpiece(WorkpieceCommand), Tools(ToolsCommand), Files(FilesCommand));

/// What a file dialog is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Purpose {
    /// Reading measurements.
    Import,
    /// Reading a mask.
    LoadMask,
    /// Reading a folder of tables.
    LoadTables,
    /// Writing the history or the chosen checks in a format of the report's list, by its number there.
    Export(usize),
    /// Writing the status window's text.
    ExportStatus,
    /// Reading one table for the table page.
    OpenTable,
    /// Writing the shown table in a format of the tables' list, by its number there.
    SaveTable(usize),
    /// Reading something for the cycles page.
    OpenCycleFile(CycleFile),
    /// Writing the simulated workpiece.
    SaveWorkpiece,
    /// Writing the measuring log of the cycle that was run.
    SaveCycleLog,
    /// Reading an NC program.
    OpenProgram,
    /// Reading a simulated part of several features.
    OpenPart,
    /// Reading a tool table.
    OpenTools,
    /// Writing the tool table as a run has changed it.
    SaveTools,
    /// Reading an uncertainty budget.
    OpenBudget,
    /// Reading the budget that checks used the last time.
    UseBudget,
    /// Writing the budget of the budget page.
    SaveBudget,
    /// Reading a part plan.
    OpenPlan,
    /// Reading measurements into the part that is walked through, by its number among all that were begun.
    ImportValues(u64),
    /// Reading measurements whose columns are to be seen first.
    AskColumns(ImportInto),
    /// Watching a folder that files are dropped into.
    WatchFolder,
    /// Writing the plan: as TOML, or as CSV.
    SavePlan(usize),
    /// Choosing the picture of a plan.
    OpenPicture,
    /// Reading readings of a calibrated piece.
    OpenReadings,
    /// Reading measured holes or shafts for the pairing page.
    OpenParts(Feature),
    /// Writing the pairs in a format of their list, by its number there.
    SavePairs(usize),
    /// Writing the chosen records in a format of the report's list, by its number there.
    ReportRecords(usize),
    /// Writing the part that is being measured in a format of the report's list, by its number there.
    ReportPart(usize),
}

impl Purpose {
    /// Whether a folder is asked for, and no file.
    pub const fn is_folder(self) -> bool {
        matches!(self, Self::LoadTables | Self::WatchFolder)
    }

    /// Whether something is read; otherwise a file is written.
    pub const fn is_reading(self) -> bool {
        match self {
            Self::Export(_)
            | Self::ExportStatus
            | Self::SaveTable(_)
            | Self::SaveWorkpiece
            | Self::SaveCycleLog
            | Self::SaveTools
            | Self::SaveBudget
            | Self::SavePlan(_)
            | Self::SavePairs(_)
            | Self::ReportRecords(_)
            | Self::ReportPart(_) => false,
            Self::Import
            | Self::LoadMask
            | Self::LoadTables
            | Self::OpenTable
            | Self::OpenCycleFile(_)
            | Self::OpenProgram
            | Self::OpenPart
            | Self::OpenTools
            | Self::OpenBudget
            | Self::OpenPlan
            | Self::OpenPicture
            | Self::ImportValues(_)
            | Self::AskColumns(_)
            | Self::WatchFolder
            | Self::UseBudget
            | Self::OpenReadings
            | Self::OpenParts(_) => true,
        }
    }
}

/// Where measurements of a file go.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ImportInto {
    /// The history of the check page.
    History,
    /// The part that is walked through, by its number among all that were begun: it may be another one when the file is read.
    Part(u64),
}

impl ImportInto {
    /// The purpose that reads them there.
    pub const fn purpose(self) -> Purpose {
        match self {
            Self::History => Purpose::Import,
            Self::Part(run) => Purpose::ImportValues(run),
        }
    }
}

/// A file that the cycles page reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CycleFile {
    /// Recorded contacts.
    Contacts,
    /// A simulated workpiece and probe.
    Workpiece,
    /// A touch-probe table.
    Probes,
}

/// A page of the window.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Page {
    /// One part: good, rework or scrap.
    #[default]
    Check,
    /// Hole against shaft.
    Fit,
    /// Measuring cycles.
    Cycles,
    /// Tables of deviations.
    Tables,
    /// NC programs.
    Program,
    /// Measured holes against measured shafts.
    Pairing,
    /// Uncertainty budgets.
    Budget,
    /// Everything that was recorded.
    Records,
    /// Plans of whole parts, and the walk through them.
    Parts,
}

impl Page {
    /// Every page in the order of the top bar.
    pub const ALL: [Self; 9] = [
        Self::Check,
        Self::Fit,
        Self::Cycles,
        Self::Tables,
        Self::Program,
        Self::Pairing,
        Self::Budget,
        Self::Records,
        Self::Parts,
    ];
}

/// Light or dark.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Theme {
    /// As the system is set.
    #[default]
    System,
    Light,
    Dark,
}

/// How high everything is that is pressed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Density {
    /// As it is used: high once a finger has touched the window, until a mouse moves over it.
    #[default]
    ByUse,
    Mouse,
    /// For fingers and gloves.
    Touch,
}

impl Density {
    /// Every choice.
    pub const ALL: [Self; 3] = [Self::ByUse, Self::Mouse, Self::Touch];
}

/// The number of a dialog among all that were opened.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub struct DialogId(pub(super) u64);

/// What the state asks of the outside world; done at the edge, not on the frame's thread.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Do this for a dialog and send every answer as [`Command::Answered`].
    ForDialog(DialogId, Box<Self>),
    /// Show the system's file dialog and send [`Command::Picked`].
    Browse {
        /// What is asked for.
        purpose: Purpose,
        /// The folder that it begins with.
        folder: Option<PathBuf>,
        /// The proposed name of a file that is written.
        name: String,
    },
    /// Read what lies in a folder and send [`FilesCommand::Listed`].
    List(PathBuf),
    /// Read what a dialog of this purpose asks for, and send the command that takes it: [`CheckCommand::Imported`],
    /// [`RowsCommand::Opened`] in place of it for a large one, [`ColumnsCommand::Ask`] where its columns are not certain,
    /// [`Command::MaskRead`], [`Command::TablesRead`], or the one of a page that reads such files. Before it comes
    /// [`FilesCommand::Seen`]; a folder in place of a file is only told by [`FilesCommand::IsFolder`].
    Read(Purpose, PathBuf),
    /// Read measurements with these columns, and send what [`Self::Read`] sends.
    ReadColumns {
        /// Where they go.
        into: ImportInto,
        /// The file.
        path: PathBuf,
        /// Which column is which.
        mapping: Box<Mapping>,
    },
    /// Write a file that does not exist yet and send [`Command::Saved`].
    Save(PathBuf, Content),
    /// Write a file over another one and send [`Command::Saved`].
    Replace(PathBuf, Content),
    /// Stop reading or writing the file that is at work, if there is one.
    StopWorking,
    /// Start the program for a file and send [`FilesCommand::Launched`].
    Launch(PathBuf, Launch),
    /// Judge the rows of a large file and send [`RowsCommand::Judged`] again and again.
    JudgeRows {
        run: u64,
        /// The file.
        path: PathBuf,
    },
    /// End the run over a large file, if there is one.
    StopRows,
    /// Read rows of a large file again and send [`RowsCommand::Read`].
    ReadRows {
        /// The number of the run that judged them.
        run: u64,
        /// Parts of the file, with the numbers of the rows in each, ascending.
        wanted: Vec<(Arc<Part>, Vec<usize>)>,
    },
    /// Pair measured parts and send [`PairingCommand::Paired`].
    Pair {
        /// The number of the question.
        run: u64,
        asked: Box<Asked>,
    },
    /// Open the journal, which is made where there is none, and send [`RecordsCommand::Opened`] with so many of its newest checks.
    OpenJournal {
        file: PathBuf,
        /// The name of the station, for a journal that is made.
        station: String,
        /// How many checks.
        newest: u64,
    },
    /// Write entries to the journal, with the time of now, and send [`RecordsCommand::Kept`] once they are on disk.
    Keep {
        /// The number of the batch.
        run: u64,
        /// The entries; whoever writes them puts in their time.
        entries: Vec<Entry>,
    },
    /// Find records and send [`RecordsCommand::Found`] again and again; the question before is given up.
    AskRecords {
        /// The number of the question.
        run: u64,
        /// What is asked.
        question: Box<Question>,
        /// Whether to wait until nobody types.
        rests: bool,
    },
    /// Read these records and send [`RecordsCommand::Read`].
    ReadRecords(Vec<u64>),
    /// Read the checks that answer a question from the journal, the oldest first and at most so many, and send
    /// [`super::parts::WalkCommand::Came`].
    ReadPart {
        /// The number of the question.
        run: u64,
        /// What is asked.
        question: Box<Question>,
        /// How many checks.
        most: usize,
    },
    /// Watch a folder in place of any other, judge by a plan, and send [`super::parts::WalkCommand::Watched`] again and again.
    Watch {
        /// The number of the watch.
        run: u64,
        folder: PathBuf,
        plan: Arc<Plan>,
    },
    /// What a look of a watch has found is recorded.
    WatchTaken {
        /// The number of the watch.
        run: u64,
        look: u64,
    },
    /// End the watch, if there is one.
    StopWatch,
    /// Walk along the chain and send [`RecordsCommand::Verifying`] now and then, and [`RecordsCommand::Verified`] at the end.
    VerifyRecords {
        /// The number of the walk.
        run: u64,
    },
    /// End the walk, if there is one.
    StopVerify,
    /// Send the journal to the server at an address, in the background, and send [`RecordsCommand::Server`] at once and
    /// [`RecordsCommand::Sent`] again and again; `None` ends it. The address may have a password.
    SendTo(Option<String>),
    /// Tell that the journal has something to send.
    WakeSender,
    /// Send at once, whatever went wrong before.
    SendAgain,
    /// Read the part's picture and send [`PlanCommand::PictureRead`].
    ///
    /// [`PlanCommand::PictureRead`]: crate::parts::PlanCommand::PictureRead
    ReadPicture(PathBuf),
    /// Ask the system for what is on the clipboard; it comes to what has the focus.
    AskForClipboard,
    /// Close the window.
    Leave,
    /// Put a text on the clipboard.
    Copy(String),
    /// Give the focus to a field and select its text.
    Focus(Field),
    /// Give the focus to the table of the plan.
    FocusTable,
}

impl Effect {
    /// What is done, for whichever dialog.
    pub fn errand(&self) -> &Self {
        match self {
            Self::ForDialog(_, errand) => errand.errand(),
            errand => errand,
        }
    }
}
