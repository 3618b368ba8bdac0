//! What the state asks of the outside world.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::part::Plan;
use fitcheck_exchange::exchange::Mapping;
use fitcheck_exchange::exchange::batch::{ListedRows, Part, Sifting};
use fitcheck_exchange::journal::ask::Question;
use fitcheck_exchange::journal::entry::Entry;
use fitcheck_exchange::report::pairing::PairingRequest;
use fitcheck_exchange::series::{FeatureSeries, Look};
use fitcheck_gauges::PortSettings;
use fitcheck_nc::sets::NcSet;

use super::field::Field;
use super::files::{Content, DialogId, Launch};
use super::parts::AlarmSearch;
use super::purpose::{ImportInto, Purpose};
use super::sound::Rhythm;
use super::statistics::StudyAsked;

/// What the state asks of the outside world; done at the edge, not on the frame's thread.
#[derive(Debug, Clone, PartialEq)]
pub enum Effect {
    /// Do this for a dialog and send every answer as `Command::Answered`.
    ForDialog(DialogId, Box<Self>),
    /// Show the system's file dialog and send `Command::Picked`.
    Browse {
        /// What is asked for.
        purpose: Purpose,
        /// The folder that it begins with.
        folder: Option<PathBuf>,
        /// The proposed name of a file that is written.
        name: String,
    },
    /// Read what lies in a folder and send `FilesCommand::Listed`.
    List(PathBuf),
    /// Read what a dialog of this purpose asks for, and send the command that takes it: `CheckCommand::Imported`,
    /// `RowsCommand::Opened` in place of it for a large one, `ColumnsCommand::Ask` where its columns are not certain,
    /// `Command::MaskRead`, `Command::TablesRead`, or the one of a page that reads such files. Before it comes
    /// `FilesCommand::Seen`; a folder in place of a file is only told by `FilesCommand::IsFolder`.
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
    /// Write a file that does not exist yet and send `Command::Saved`; before it `RecordsCommand::Reported`, where the content is of the
    /// journal and the file is whole.
    Save(PathBuf, Content),
    /// Write a file over another one and send the same.
    Replace(PathBuf, Content),
    /// Write the files of a set into a folder, all or none, and send `FilesCommand::SetWritten`.
    SaveSet {
        folder: PathBuf,
        set: Arc<NcSet>,
        /// Whether files of their names are replaced.
        replaces: bool,
    },
    /// Stop reading or writing the file that is at work, if there is one.
    StopWorking,
    /// Start the program for a file and send `FilesCommand::Launched`.
    Launch(PathBuf, Launch),
    /// Judge the rows of a large file and send `RowsCommand::Judged` again and again.
    JudgeRows {
        run: u64,
        /// The file.
        path: PathBuf,
    },
    /// End the run over a large file, if there is one.
    StopRows,
    /// Read rows of a large file again and send `RowsCommand::Read`.
    ReadRows {
        /// The number of the run that judged them.
        run: u64,
        /// Parts of the file, with the numbers of the rows in each, ascending.
        wanted: Vec<(Arc<Part>, Vec<usize>)>,
    },
    /// Look at rows of a large file again and send `RowsCommand::Sifted`; the question before is given up.
    SiftRows {
        /// The number of the run that judged them.
        run: u64,
        /// The number of the question.
        number: u64,
        rows: Box<ListedRows>,
        sifting: Sifting,
    },
    /// Pair measured parts and send `PairingCommand::Paired`.
    Pair {
        /// The number of the question.
        run: u64,
        asked: Box<PairingRequest>,
    },
    /// Evaluate a study of a gauge and send `StudyCommand::Evaluated`.
    EvaluateStudy {
        /// The number of the question.
        run: u64,
        asked: Box<StudyAsked>,
    },
    /// Open the journal, which is made where there is none, and send `RecordsCommand::Opened` with so many of its newest checks.
    OpenJournal {
        file: PathBuf,
        /// The name of the station, for a journal that is made.
        station: String,
        /// How many checks.
        newest: u64,
    },
    /// Write entries to the journal, with the time of now, and send `RecordsCommand::Kept` once they are on disk.
    Keep {
        /// The number of the batch.
        run: u64,
        /// The entries; whoever writes them puts in their time.
        entries: Vec<Entry>,
    },
    /// Find records and send `RecordsCommand::Found` again and again; the question before is given up.
    AskRecords {
        /// The number of the question.
        run: u64,
        /// What is asked.
        question: Box<Question>,
        /// Whether to wait until nobody types.
        rests: bool,
    },
    /// Find a few of the newest records for the palette and send `PaletteCommand::Found`; the question before is given up.
    FindRecords {
        /// The number of the question.
        run: u64,
        /// What is asked.
        question: Box<Question>,
        /// How many records.
        most: usize,
    },
    /// Read these records and send `RecordsCommand::Read`.
    ReadRecords(Vec<u64>),
    /// Read the reports that show the check of a number, and send `RecordsCommand::ReportsRead`.
    ReadReports(u64),
    /// Read the checks that answer a question from the journal, the oldest first and at most so many, and send
    /// `WalkCommand::Came`.
    ReadPart {
        /// The number of the question.
        run: u64,
        /// What is asked.
        question: Box<Question>,
        /// How many checks.
        most: usize,
    },
    /// Read the values that answer a question from the journal, of each feature so many that count, and send
    /// `StatisticsCommand::Found`; the question before is given up.
    ReadSeries {
        /// The number of the question.
        run: u64,
        /// What is asked.
        question: Box<Question>,
        most: usize,
        /// Whether to wait until nobody types.
        rests: bool,
    },
    /// Look for rules that fire at the newest values, and for open alarms, and send `WalkCommand::AlarmsFound`.
    FindAlarms(Box<AlarmSearch>),
    /// Compute the figures and charts of features, each as it is looked at, and send `StatisticsCommand::Evaluated`.
    EvaluateSeries {
        /// The number of the question.
        run: u64,
        features: Vec<Arc<FeatureSeries>>,
        looks: Vec<Look>,
    },
    /// Watch a folder in place of any other, judge by a plan, and send `WalkCommand::Watched` again and again.
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
    /// Walk along the chain and send `RecordsCommand::Verifying` now and then, and `RecordsCommand::Verified` at the end.
    VerifyRecords {
        /// The number of the walk.
        run: u64,
    },
    /// End the walk, if there is one.
    StopVerify,
    /// Send the journal to the server at an address, in the background, and send `RecordsCommand::Server` at once and
    /// `RecordsCommand::Sent` again and again; `None` ends it. The address may have a password.
    SendTo(Option<String>),
    /// Tell that the journal has something to send.
    WakeSender,
    /// Send at once, whatever went wrong before.
    SendAgain,
    /// Set the pages of a report and send `ReportsCommand::Drawn`.
    DrawReport {
        /// The number of the question.
        run: u64,
        content: Box<Content>,
    },
    /// Read the user's own templates of reports from a folder and send `ReportsCommand::Templates`.
    ReadTemplates(PathBuf),
    /// Write a template of reports with this text into a folder, and send `ReportsCommand::TemplateMade`.
    NewTemplate { folder: PathBuf, text: String },
    /// Read the company's logo and send `SettingsCommand::LogoRead`.
    ReadLogo(PathBuf),
    /// Hand a report to the system's printer and send `ReportsCommand::Printed`.
    Print(Box<Content>),
    /// Read the part's picture and send `PlanCommand::PictureRead`.
    ReadPicture(PathBuf),
    /// Look for the ports of this computer and send `GaugeCommand::Ports`.
    FindPorts,
    /// Open the port of a gauge, now or as soon as it is there, and send `Command::Heard` again and again.
    OpenGauge {
        /// The number of the port.
        run: u64,
        settings: PortSettings,
    },
    /// Close the port of this number.
    CloseGauge(u64),
    /// Play the sound of a verdict after the one that is heard, and send `Command::SoundFailed` where there is none.
    Sound(Rhythm),
    /// Ask the system for what is on the clipboard; it comes to what has the focus.
    AskForClipboard,
    /// Hash a PIN with a salt of its own and send `SettingsCommand::PinHashed`.
    HashPin(String),
    /// Try a PIN against a hash and send `SettingsCommand::PinTried`.
    TryPin { pin: String, hash: String },
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
