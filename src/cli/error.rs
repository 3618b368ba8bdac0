//! Why a subcommand could not do its work, and how errors of the rooms become that.

use std::path::PathBuf;

use super::limits::lines::LONGEST_LINE;
use crate::files::FileError;
use crate::length::Length;
use crate::message::{Arg, IntoArg, Message, Say};
use crate::tolerance::LimitsError;

/// Why a subcommand could not do its work.
#[derive(Debug, Say)]
#[say(prefix = "cli", error)]
pub enum CliError {
    /// Standard input or output failed.
    Stream(
        #[from]
        #[say(with = ToString::to_string)]
        std::io::Error,
    ),
    /// A file could not be read or written.
    #[say(transparent)]
    File(#[from] FileError),
    /// What a room says, as it says it.
    #[say(transparent)]
    Said(Message),
    /// What a room says, and what it is about: a file, an option, a callout.
    About {
        /// What stands before the colon.
        what: Arg,
        /// What the room says.
        error: Message,
    },
    /// An answer that cannot be written as CSV or JSON.
    Output(String),

    /// A measured diameter of zero or less.
    NotAboveZero {
        /// In mm.
        diameter: Length,
    },
    /// A line of standard input beyond the bound of the reader.
    #[say(args(limit = LONGEST_LINE))]
    LineTooLong,
    /// A file that is read well and has no deviations.
    NotATable {
        /// The file.
        name: String,
    },

    /// Hole or shaft has to be said.
    AddFeature {
        /// What cannot be said without.
        error: LimitsError,
    },
    /// Outside the limits, and rework or scrap depends on hole or shaft.
    ReworkOrScrap {
        /// The callout as it was given.
        asked: Arg,
        /// In mm.
        measured: Length,
        /// In mm.
        minimum: Length,
        /// In mm.
        maximum: Length,
    },

    /// Measured parts for several fits.
    PartsOfSeveral,
    /// A search with measured parts, materials or temperatures.
    SearchWithParts,
    /// A search without one nominal size.
    SearchWithoutSize,
    /// A search without both clearances.
    SearchWithoutClearance,

    /// The file of a control table has another ending.
    TableEnding {
        /// The file.
        path: PathBuf,
    },
    /// A file's ending is none of its format.
    FormatEnding {
        /// The file.
        path: PathBuf,
        /// The format's name.
        format: &'static str,
        /// Its endings, without the first point.
        endings: String,
    },
    /// Several tables for one file.
    SeveralTables,

    /// `--format` asks for another format than the file's ending.
    ReportFormat {
        /// The format's name.
        format: &'static str,
        /// The file.
        file: PathBuf,
    },
    /// No check could be used.
    ReportEmpty,

    /// Inputs of a cycle that are no JSON object.
    NotAnObject {
        /// What the parser says.
        error: String,
    },
    /// An input of a cycle that is neither number nor text.
    NotAnInput {
        /// The parameter.
        name: String,
        /// What was given.
        value: String,
    },
    /// An input of a cycle that stands twice in a file.
    GivenTwice {
        /// The parameter.
        name: String,
    },
    /// An input of a cycle that is set twice.
    SetTwice {
        /// The parameter.
        name: String,
    },
    /// The block of another cycle.
    OtherCycle {
        /// The block's.
        given: &'static str,
        /// The one that was asked for.
        wanted: &'static str,
    },
    /// A parameter that PREDEF cannot stand for, or none.
    NotPredef {
        /// What was given.
        name: String,
    },
    /// A probe that the touch-probe table lacks.
    NoProbe {
        /// Its number.
        number: u32,
    },
    /// A parameter without its value.
    NotAPair {
        /// What was given.
        text: String,
    },
    /// A position that is not three numbers.
    NotAPosition {
        /// What was given.
        text: String,
    },

    /// A value of `--set` that is no decimal number.
    NotANumber,
    /// A folder that is not there.
    NoFolder {
        /// The folder.
        path: PathBuf,
    },
    /// A program that is neither there nor built in.
    NoProgram {
        /// Which file is missing.
        error: FileError,
        /// The built-in ones.
        names: String,
    },

    /// An option of a single callout beside a plan.
    OptionBesidePlan {
        /// The option without its dashes.
        option: &'static str,
    },
    /// An option that a single callout needs.
    OptionMissing {
        /// The option without its dashes.
        option: &'static str,
    },
    /// A control that has no sets.
    NoControl {
        /// What was given.
        name: String,
    },
    /// A file that is there already.
    UseForce {
        /// Which.
        error: FileError,
    },
}

/// What an error is about, where it is no file and no callout.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "cli-what")]
pub(super) enum What<'a> {
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
    NominalSize {
        /// As it was given.
        text: &'a str,
    },
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
    Cycle {
        /// Its name on a control.
        code: &'a str,
    },
    /// The measuring log.
    Log,
    /// An option.
    Option {
        /// Its name without dashes.
        name: &'a str,
    },
    /// A parameter that is set before a run.
    Set {
        /// The parameter.
        name: &'a str,
        /// Its value.
        value: &'a str,
    },
}

impl From<serde_json::Error> for CliError {
    fn from(error: serde_json::Error) -> Self {
        if error.is_io() { Self::Stream(error.into()) } else { Self::Output(error.to_string()) }
    }
}

impl From<csv::Error> for CliError {
    /// A closed pipe stays one.
    fn from(error: csv::Error) -> Self {
        match error.into_kind() {
            csv::ErrorKind::Io(error) => Self::Stream(error),
            other => Self::Output(format!("{other:?}")),
        }
    }
}

/// A room's error on its way out.
pub(super) trait Refused<T> {
    /// As the room says it.
    fn said(self) -> Result<T, CliError>;
    /// After what it is about.
    fn about(self, what: &(impl IntoArg + ?Sized)) -> Result<T, CliError>;
}

impl<T, E: Say> Refused<T> for Result<T, E> {
    fn said(self) -> Result<T, CliError> {
        self.map_err(|error| CliError::Said(error.message()))
    }

    fn about(self, what: &(impl IntoArg + ?Sized)) -> Result<T, CliError> {
        self.map_err(|error| CliError::About { what: what.arg(), error: error.message() })
    }
}
