//! `fitcheck report`

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
use crate::words::{Language, Words};

/// Write an inspection report of one or more checks
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// A callout and its measured value in millimetres, with a name in front if you like; may be given again
    #[arg(long = "check", required = true, value_name = "[NAME:] CALLOUT=MM")]
    checks: Vec<String>,

    /// File to write, in the format of its ending: .html, .htm, .csv or .json; "-" is standard output
    #[arg(short, long, value_name = "FILE", value_parser = output)]
    output: Output,

    /// Format of what goes to standard output; a file's ending tells its own
    #[arg(long, required_if_eq("output", "-"), value_parser = PossibleValuesParser::new(names()))]
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
    /// `--format` asks for another format than the file's ending.
    #[error("--format {format} does not fit the ending of {}: leave one of them out", file.display())]
    Format { format: String, file: PathBuf },
    /// No check could be used.
    #[error("no check could be used, so no report was written")]
    Empty,
}

/// Where the report goes.
#[derive(Debug, Clone)]
enum Output {
    /// Standard output, in the format of `--format`.
    Standard,
    /// A file, in the format of its ending.
    File(PathBuf, &'static Rendering),
}

/// Reads `--output`: a wrong ending is wrong usage.
fn output(text: &str) -> Result<Output, EndingError> {
    if text == "-" {
        return Ok(Output::Standard);
    }
    Ok(Output::File(PathBuf::from(text), report::rendering_for(Path::new(text))?))
}

/// The names of `--format`.
fn names() -> Vec<&'static str> {
    RENDERINGS.iter().map(|rendering| rendering.name).collect()
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let rendering = self.rendering()?;
        let tables = self.tables.load(io)?;
        let words = Words::new(Language::from_code(&self.language).unwrap_or_default());
        let now = self.time.unwrap_or_else(now);
        let mut checks = Vec::new();
        let mut notes = Vec::new();
        for text in &self.checks {
            match record(text, &tables, now) {
                Ok(record) => checks.push(record),
                Err(error) => {
                    writeln!(io.err, "fitcheck: --check \"{text}\": {error}")?;
                    notes.push(format!("{text}: {error}"));
                }
            }
        }
        let Some(worst) = checks.iter().map(|record| record.verdict.status()).max() else {
            return Err(CliError::Data(ReportError::Empty.to_string()));
        };
        let outcome = if notes.is_empty() { Outcome::Judged(worst) } else { Outcome::BadData };
        let report = Report {
            title: self.title.clone().unwrap_or_default(),
            part: self.part.clone(),
            order: self.order.clone(),
            inspector: self.inspector.clone(),
            notes,
            ..Report::new(now, checks)
        };
        let bytes = (rendering.render)(&report, &words).map_err(|error| CliError::Data(error.to_string()))?;
        match &self.output {
            Output::Standard => io.out.write_all(&bytes)?,
            Output::File(path, _) => super::save(path, &bytes, io)?,
        }
        Ok(outcome)
    }

    /// The rendering of the file's ending, or of `--format` for standard output.
    fn rendering(&self) -> Result<&'static Rendering, CliError> {
        let named = RENDERINGS.iter().find(|rendering| self.format.as_deref() == Some(rendering.name));
        match (&self.output, named) {
            (Output::File(file, by_ending), Some(named)) if by_ending.name != named.name => {
                let (format, file) = (named.name.to_owned(), file.clone());
                Err(CliError::Data(ReportError::Format { format, file }.to_string()))
            }
            (Output::File(_, rendering), _) => Ok(rendering),
            // Without a format, clap has refused standard output before.
            (Output::Standard, named) => Ok(named.unwrap_or(&report::html::RENDERING)),
        }
    }
}

/// The local date and time to the second.
fn now() -> DateTime {
    let now = jiff::Zoned::now().datetime();
    now.with().subsec_nanosecond(0).build().unwrap_or(now)
}

/// Judges a `--check`: a name and a colon perhaps, a callout, an equals sign, a diameter.
fn record(text: &str, tables: &Tables, time: DateTime) -> Result<Record, CheckError> {
    let (asked, measured) = text.rsplit_once('=').ok_or_else(|| CheckError::NoMeasured { text: text.to_owned() })?;
    let (id, callout) = asked.rsplit_once(':').unwrap_or(("", asked));
    let callout: Callout = callout.parse()?;
    let limits = tables.limits(&callout)?;
    let measured: Length = measured.parse().map_err(CheckError::Measured)?;
    if measured <= Length::ZERO {
        return Err(CheckError::NotPositive { measured });
    }
    Ok(Record {
        time,
        id: id.trim().to_owned(),
        callout: Some(callout),
        measurement: Measurement::of_diameter(measured, Origin::Typed),
        verdict: judge(&limits, measured, None),
        doubt: doubt(limits.nominal, measured),
        limits,
    })
}
