//! `fitcheck report`

use std::io::Write as _;
use std::path::{Path, PathBuf};

use clap::builder::PossibleValuesParser;
use jiff::civil::DateTime;

use super::{CliError, Io, Outcome, TableArgs};
use crate::journal::Record;
use crate::length::{Length, LengthError};
use crate::probing::{Measurement, Origin};
use crate::report::{self, EndingError, RENDERINGS, Rendering, Report};
use crate::tolerance::{Callout, CalloutError, LimitsError, Tables};
use crate::verdict::{doubt, judge};
use crate::words::{Language, Message, Say, Words};

/// Write an inspection report of one or more checks
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// A callout and its measured value in millimetres, with a name in front if you like; may be given again
    #[arg(long = "check", value_name = "[NAME:] CALLOUT=MM")]
    checks: Vec<String>,

    /// File to write, in the format of its ending: .html, .htm, .csv or .json; "-" is standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,

    /// Format of what goes to standard output
    #[arg(long, value_parser = PossibleValuesParser::new(RENDERINGS.iter().map(|rendering| rendering.name)))]
    format: Option<String>,

    /// Title of the report
    #[arg(long)]
    title: Option<String>,

    /// Part or drawing number
    #[arg(long)]
    part: Option<String>,

    /// Order number
    #[arg(long)]
    order: Option<String>,

    /// Who inspected
    #[arg(long, value_name = "NAME")]
    inspector: Option<String>,

    /// Language of the HTML report; CSV and JSON are the same in every language
    #[arg(long, default_value = "en", value_parser = PossibleValuesParser::new(Language::COMPLETE.map(Language::code)))]
    language: String,

    /// Date and time of the report and of checks that have none; now when not given
    #[arg(long, value_name = "YYYY-MM-DDTHH:MM")]
    time: Option<DateTime>,

    #[command(flatten)]
    tables: TableArgs,
}

const EXAMPLES: &str = "\
Examples:
  fitcheck report --check \"25 H7=25.012\" -o bore.html
  fitcheck report --check \"Bore A: 25 H7=25.012\" --check \"Stud: 10 g6=9,991\" \\
      --part 4711 --order 2026-118 --inspector \"J. Jansen\" --language nl -o report.html
  fitcheck report --check \"25 H7=25.012\" -o - --format json

The exit code is that of the worst check. A row that cannot be used is named on standard error and on the
report, the others are reported, and the exit code is 1.";

/// Why a `--check` is no check.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum CheckError {
    /// There is no equals sign.
    #[error("{text} has no measured value: write a callout, = and millimetres, such as 25 H7=25.012")]
    NoMeasured { text: String },
    /// The callout cannot be read.
    #[error("{0}")]
    Callout(#[from] CalloutError),
    /// There are no limits for the callout.
    #[error("{0}")]
    Limits(#[from] LimitsError),
    /// The measured value cannot be read.
    #[error("measured value: {0}")]
    Measured(LengthError),
    /// A diameter is above zero.
    #[error("measured value {measured} mm is not above 0")]
    NotPositive { measured: Length },
}

/// Why there is nothing to write.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
enum ReportError {
    /// `-o -` without `--format`.
    #[error("standard output has no ending that tells the format: add --format {}", names())]
    NoFormat,
    /// `--format` and an ending that is another format's.
    #[error("--format {format} does not fit {file}: leave one of them out")]
    Format { format: String, file: String },
    /// The ending is none of the report's.
    #[error("{0}")]
    Ending(#[from] EndingError),
    /// No check could be used.
    #[error("there is no check to report: give one, such as --check \"25 H7=25.012\"")]
    Empty,
}

fn names() -> String {
    RENDERINGS.map(|rendering| rendering.name).join("|")
}
