//! Why a subcommand could not do its work, and how the errors of the rooms become that.

use std::path::PathBuf;

use super::answers::LONGEST_LINE;
use crate::files::FileError;
use crate::length::Length;
use crate::message::{Arg, IntoArg, Message, Say, printed};
use crate::tolerance::LimitsError;
use crate::tolerance::fit::thermal::ThermalDoubt;

/// Why a subcommand could not do its work.
#[derive(Debug, Say)]
#[say(prefix = "cli", error)]
pub(super) enum CliError {
    /// Standard input or output failed.
    Stream(
        #[from]
        #[say(with = ToString::to_string)]
        std::io::Error,
    ),
    /// A file could not be read or written.
    #[say(transparent)]
    File(#[from] FileError),
    /// An error of a room, in its words.
    #[say(transparent)]
    Said(Message),
    /// An error of a room, and what it is about: a file, an option, a callout.
    About { what: Arg, error: Message },
    /// An answer that cannot be written as CSV or JSON.
    Output(String),

    /// The mark of a simulation above rows that would be written without it.
    BatchSimulated { name: String },
    /// A dash, which is standard output, for what cannot go there.
    Dash,
    /// A name that no subcommand has.
    NoSubcommand { given: String, names: String },
    /// A measured diameter of zero or less.
    NotAboveZero { diameter: Length },
    /// An option of ISO 286, where the control's tables answer.
    OptionOfStandard { option: &'static str },
    /// A temperature for values that are at 20 °C already.
    AlreadyCorrected,
    /// Not a multiple of an uncertainty.
    NotAMultiple { given: String },
    /// Limits of which none was given, or of which the lower is not below the upper.
    NoLimits,
    /// A tolerance of one limit has no ratio to the uncertainty.
    RatioOfOneLimit,
    /// Risks of a process need the uncertainty.
    RiskWithoutUncertainty,
    /// The accepted values for a risk need the process.
    RiskWithoutProcess,
    /// Not a probability.
    NotARisk { given: String },
    /// Not the shape and the scale of a gamma law.
    NotAGamma { given: String },
    /// No accepted values have this risk.
    NoZoneForRisk,
    /// A line of standard input that is longer than the reader's limit.
    #[say(args(limit = LONGEST_LINE))]
    LineTooLong,
    /// A file that can be read and has no deviations.
    NotATable { name: String },
    /// Values of several features, of which none is named.
    StatsFeatures { names: String },
    /// A feature without values.
    StatsNoFeature { given: String, names: String },
    /// Limits that differ from value to value.
    StatsLimits,
    /// A point that the chart does not have.
    StatsNoPoint { point: usize, count: usize },
    /// Values that make no groups.
    StatsReason { why: Message },
    /// A layout that looks wrong and is not confirmed.
    StatsLayout { doubt: Message },
    /// A budget of a study that gives none.
    StatsNoBudget,
    /// Charts that cannot be drawn.
    StatsNoPicture { why: Message },
    /// Points of a chart, and every feature has one of its own.
    StatsPoints,
    /// Parameters of a chart that has none.
    StatsParameters,

    /// Hole or shaft must be named.
    AddFeature { error: LimitsError },
    /// A zone out of all proportion, which may be meant.
    AddWideZone { asked: Arg, error: LimitsError },
    /// A temperature that is doubted and may be meant.
    AddFarTemperature { what: Arg, error: ThermalDoubt },

    /// Measured parts for several fits.
    PartsOfSeveral,
    /// A search with measured parts, materials or temperatures.
    SearchWithParts,
    /// A search without one nominal size.
    SearchWithoutSize,
    /// A search without both clearances.
    SearchWithoutClearance,

    /// The file of a control table has another ending.
    TableEnding { path: PathBuf },
    /// A file's ending does not belong to its format.
    FormatEnding { path: PathBuf, format: &'static str, endings: String },
    /// Several tables for one file.
    SeveralTables,

    /// Ctrl+C ended it before it was done.
    Stopped {
        #[say(with = printed)]
        rows: u64,
    },

    /// `--format` asks for a format other than that of the file's ending.
    ReportFormat { format: &'static str, file: PathBuf },
    /// No check could be used.
    ReportEmpty,
    /// A report on standard output is to be recorded.
    RecordNeedsFile,
    /// The file is there, and the journal has no entry of it.
    ReportNotKnown { file: String, error: Message },

    /// Inputs of a cycle that are larger than any.
    InputsTooLarge { most: usize },
    /// Inputs of a cycle that are not a JSON object.
    NotAnObject { error: String },
    /// An input of a cycle that is neither number nor text.
    NotAnInput { name: String, value: String },
    /// An input of a cycle that occurs twice in a file.
    GivenTwice { name: String },
    /// An input of a cycle that is set twice.
    SetTwice { name: String },
    /// The block of another cycle.
    OtherCycle { given: &'static str, wanted: &'static str },
    /// A program with several blocks of measuring cycles, and none is chosen.
    SeveralBlocks { blocks: String },
    /// A parameter that PREDEF cannot stand for, or that does not exist.
    NotPredef { name: String },
    /// A probe that the touch-probe table lacks.
    NoProbe { number: u32 },
    /// A parameter without its value.
    NotAPair { text: String },
    /// A position that is not three numbers.
    NotAPosition { text: String },

    /// A value of `--set` that is not a decimal number.
    NotANumber,
    /// A folder that does not exist.
    NoFolder { path: PathBuf },
    /// A folder that another program watches for the same journal.
    WatchedAlready { path: PathBuf },
    /// Not a time in seconds.
    NotSeconds { given: String },
    /// A program that is neither in a file nor built in.
    NoProgram { error: FileError, names: String },

    /// A file of answers with an unknown ending.
    BatchEnding { path: PathBuf, endings: String },
    /// An output that is an input, too.
    BatchOntoItself { path: PathBuf },
    /// Inputs whose columns differ.
    BatchColumns { name: String, columns: String },
    /// Inputs whose cells are separated by different signs, for one CSV.
    BatchSeparator { name: String },
    /// A column whose type differs between inputs, for one Parquet file.
    BatchTypes { name: String, column: String },
    /// A Parquet file under the name of a packed one.
    BatchPacked { path: PathBuf },
    /// Two columns of one name, for objects and Parquet.
    BatchTwice { name: String, column: String },
    /// An input without rows that can be judged.
    BatchInput { name: String, error: String },
    /// A column of the input has the name of an added one.
    BatchName { name: String, column: String },

    /// An option for a single callout, given with a plan.
    OptionBesidePlan { option: &'static str },
    /// An option that a single callout needs.
    OptionMissing { option: &'static str },
    /// The verdict stands and is not in the journal.
    NotRecorded { error: Message },
    /// An entry that is not there.
    NoEntry {
        #[say(with = printed)]
        number: u64,
        #[say(with = printed)]
        last: u64,
        path: PathBuf,
    },
    /// Digits that no hash of a journal begins with.
    NoHash { prefix: String, path: PathBuf },
    /// Digits that the hashes of several entries begin with.
    SeveralHashes { prefix: String, numbers: String },
    /// An entry that is not a check.
    NoCheck {
        #[say(with = printed)]
        number: u64,
    },
    /// A check that another entry has corrected already.
    AlreadyCorrectedBy {
        #[say(with = printed)]
        number: u64,
        #[say(with = printed)]
        by: u64,
    },
    /// Another measured value for a check whose value was not typed.
    NotTyped {
        #[say(with = printed)]
        number: u64,
    },
    /// A correction that changes nothing.
    NothingCorrected,
    /// An entry that is known elsewhere, without the chain that it is of.
    HeadWithoutChain,
    /// An entry that is known of another chain.
    HeadOfOther { chain: String, other: String },
    /// A program that was built without the server of a shop.
    #[cfg(not(feature = "shop"))]
    NoShop,
    /// The address of a server, where a file is needed.
    JournalIsServer,
    /// The system has no folder for a user's data.
    NoJournalFolder,

    /// A file that already exists.
    UseForce { error: FileError },
}

/// What an error is about, where it is neither a file nor a callout.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "cli-what")]
pub(super) enum ErrorSubject<'a> {
    /// No text at all was given.
    Callout,
    /// `--measured`
    MeasuredValue,
    /// The hole of a fit.
    Hole,
    /// The shaft of a fit.
    Shaft,
    /// `fit --hole`
    MeasuredHole,
    /// `fit --shaft`
    MeasuredShaft,
    /// `--hole-material`
    HoleMaterial,
    /// `--shaft-material`
    ShaftMaterial,
    /// `--temperature` and those of hole and shaft
    Temperature,
    /// `--min-clearance`
    SmallestClearance,
    /// `--max-clearance`
    LargestClearance,
    /// The size of a search.
    NominalSize { text: &'a str },
    /// The simulated workpiece's diameter.
    TrueDiameter,
    /// The simulated workpiece.
    SimulatedWorkpiece,
    /// Measuring it.
    SimulatedMeasurement,
    /// The workpiece without faults.
    PerfectWorkpiece,
    /// An end of a size range.
    Size,
    /// A measuring cycle.
    Cycle { code: &'a str },
    /// The measuring log.
    Log,
    /// An entry of a journal.
    Entry {
        #[say(with = printed)]
        number: u64,
    },
    /// An option.
    Option { name: &'a str },
    /// A parameter that is set before a run.
    Set { name: &'a str, value: &'a str },
}

impl From<serde_json::Error> for CliError {
    fn from(error: serde_json::Error) -> Self {
        if error.is_io() { Self::Stream(error.into()) } else { Self::Output(error.to_string()) }
    }
}

impl From<csv::Error> for CliError {
    /// A closed pipe stays a closed pipe.
    fn from(error: csv::Error) -> Self {
        match error.into_kind() {
            csv::ErrorKind::Io(error) => Self::Stream(error),
            other => Self::Output(format!("{other:?}")),
        }
    }
}

/// An error of a room on its way out.
pub(super) trait IntoCliError<T> {
    /// In the words of the room.
    fn said(self) -> Result<T, CliError>;
    /// After what it is about.
    fn about(self, what: &(impl IntoArg + ?Sized)) -> Result<T, CliError>;
}

impl<T, E: Say> IntoCliError<T> for Result<T, E> {
    fn said(self) -> Result<T, CliError> {
        self.map_err(|error| CliError::Said(error.message()))
    }

    fn about(self, what: &(impl IntoArg + ?Sized)) -> Result<T, CliError> {
        self.map_err(|error| CliError::About { what: what.arg(), error: error.message() })
    }
}
