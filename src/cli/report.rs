//! `fitcheck report`

use std::path::{Path, PathBuf};

use jiff::civil::DateTime;

use super::args::one_of;
use super::{CliError, Io, Outcome, Refused as _, TableArgs};
use crate::exchange::import;
use crate::files;
use crate::journal::Record;
use crate::length::{Length, LengthError};
use crate::message::{Message, Say};
use crate::probing::{Measurement, Origin};
use crate::report::{self, EndingError, RENDERINGS, Rendering, Report};
use crate::tolerance::{Callout, CalloutError, LimitsError, Sources};
use crate::words::{Language, Words};

/// Write an inspection report of one or more checks
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Files of measurements to report, in any format that `fitcheck import` reads
    #[arg(value_name = "FILE", required_unless_present = "checks")]
    files: Vec<PathBuf>,

    /// A callout and its measured value in millimetres, optionally with a name before it; can be repeated
    #[arg(long = "check", value_name = "[NAME:] CALLOUT=MM")]
    checks: Vec<String>,

    #[arg(short, long, value_name = "FILE", value_parser = output, help = output_help())]
    output: Output,

    /// Format of standard output; for a file its ending gives the format
    #[arg(long, required_if_eq("output", "-"), value_parser = one_of(RENDERINGS, |rendering| rendering.name))]
    format: Option<&'static Rendering>,

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
    #[arg(long, default_value = "en", value_parser = one_of(Language::all(), |language| language.code()))]
    language: Language,

    /// Date and time of the report, and of checks without their own; default: now
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
  fitcheck report bores.csv TCHPR421.TXT -o report.html
  fitcheck report --check \"25 H7=25.012\" -o - --format json

The exit code is that of the worst check. A check that cannot be read or judged is named on standard error
and in the report; the others are reported, and the exit code is 1.";

/// Why a `--check` is not a check.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "cli-check")]
enum CheckError {
    /// There is no equals sign.
    NoMeasured { text: String },
    /// The callout cannot be read.
    #[say(transparent)]
    Callout(#[from] CalloutError),
    /// There are no limits for the callout.
    #[say(transparent)]
    Limits(#[from] LimitsError),
    /// The measured value cannot be read.
    Measured(LengthError),
    /// The diameter is zero or less.
    NotPositive { measured: Length },
}

/// Where the report goes.
#[derive(Debug, Clone)]
enum Output {
    /// Standard output, in the format of `--format`.
    Standard,
    /// A file, in the format of its ending.
    File(PathBuf, &'static Rendering),
}

/// The help of `--output`: `.html, .htm, .csv or .json`.
fn output_help() -> String {
    let endings = report::endings().replace(' ', ", ");
    let (first, last) = endings.rsplit_once(", ").unwrap_or_default();
    format!("File to write, in the format of its ending: {first} or {last}; \"-\" is standard output")
}

/// Reads `--output`: a wrong ending is wrong usage.
fn output(text: &str) -> Result<Output, EndingError> {
    if text == "-" {
        return Ok(Output::Standard);
    }
    Ok(Output::File(PathBuf::from(text), report::rendering_for(Path::new(text))?))
}

/// The checks so far, and what did not become one.
#[derive(Debug, Default)]
struct Collected {
    checks: Vec<Record>,
    notes: Vec<Message>,
    bad: bool,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let rendering = self.rendering()?;
        let sources = self.tables.load(io)?;
        let words = Words::new(self.language);
        let now = self.time.unwrap_or_else(super::now);
        let mut collected = Collected::default();
        for path in &self.files {
            collected.file(path, &sources, now, io);
        }
        for text in &self.checks {
            match record(text, &sources, now) {
                Ok(record) => collected.checks.push(record),
                Err(error) => collected.refuse(Message::new("report-note").text("place", text), error.message(), io),
            }
        }
        let Collected { checks, notes, bad, .. } = collected;
        let Some(worst) = checks.iter().map(|record| record.verdict.status()).max() else {
            return Err(CliError::ReportEmpty);
        };
        let report = Report {
            title: self.title.clone().unwrap_or_default(),
            part: self.part.clone(),
            order: self.order.clone(),
            inspector: self.inspector.clone(),
            notes,
            ..Report::new(now, checks)
        };
        let bytes = (rendering.render)(&report, &words).said()?;
        match &self.output {
            Output::Standard => io.data().write_all(&bytes)?,
            Output::File(path, _) => super::save(path, &bytes, io)?,
        }
        Ok(if bad { Outcome::BadData } else { Outcome::Judged(worst) })
    }

    /// The rendering of the file's ending, or of `--format` for standard output.
    fn rendering(&self) -> Result<&'static Rendering, CliError> {
        match (&self.output, self.format) {
            (Output::File(file, by_ending), Some(named)) if by_ending.name != named.name => {
                Err(CliError::ReportFormat { format: named.name, file: file.clone() })
            }
            (Output::File(_, rendering), _) => Ok(rendering),
            // Without a format, clap has already refused standard output.
            (Output::Standard, named) => Ok(named.unwrap_or(&report::html::RENDERING)),
        }
    }
}

impl Collected {
    /// Takes in a file of measurements.
    fn file(&mut self, path: &Path, sources: &Sources, now: DateTime, io: &mut Io<'_>) {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let bytes = match files::read(path) {
            Ok(bytes) => bytes,
            Err(error) => return self.refuse(Message::new("report-note").text("place", &name), error.message(), io),
        };
        let imported = import(&name, &bytes, sources, now);
        let line = |line: usize| Message::new("report-note-line").text("place", &name).text("line", line);
        for error in &imported.errors {
            self.refuse(Message::new("report-note").text("place", &name), error.message(), io);
        }
        for unjudged in &imported.unjudged {
            self.refuse(line(unjudged.line), unjudged.why.message(), io);
        }
        for warning in &imported.warnings {
            self.note(line(warning.place.line.unwrap_or_default()), warning.what.message(), io);
        }
        self.checks.extend(imported.records);
    }

    /// Notes what is not a check, so that nobody takes the report for complete.
    fn refuse(&mut self, place: Message, what: Message, io: &mut Io<'_>) {
        self.bad = true;
        self.note(place, what, io);
    }

    /// Puts a sentence on the report, and in English on standard error.
    fn note(&mut self, place: Message, what: Message, io: &mut Io<'_>) {
        let note = place.message("what", what);
        io.fail(&note);
        self.notes.push(note);
    }
}

/// Judges a `--check`: an optional name and colon, a callout, an equals sign, a diameter.
fn record(text: &str, sources: &Sources, time: DateTime) -> Result<Record, CheckError> {
    let (asked, measured) = text.rsplit_once('=').ok_or_else(|| CheckError::NoMeasured { text: text.to_owned() })?;
    let (id, callout) = asked.rsplit_once(':').unwrap_or(("", asked));
    let callout: Callout = callout.parse()?;
    let limits = sources.limits(&callout, None)?;
    let measured: Length = measured.parse().map_err(CheckError::Measured)?;
    if measured <= Length::ZERO {
        return Err(CheckError::NotPositive { measured });
    }
    let measurement = Measurement::of_diameter(measured, Origin::Typed);
    Ok(Record::judged(time, id.trim().to_owned(), Some(callout), limits, measurement, None))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_check_without_sense_is_refused_in_words() {
        let refused = |text: &str| record(text, &Sources::default(), DateTime::constant(2026, 11, 21, 10, 42, 0, 0));
        let said = |text: &str| refused(text).unwrap_err().to_string();
        assert_eq!(
            said("25 H7"),
            "25 H7 has no measured value: write a callout, = and millimetres, such as 25 H7=25.012"
        );
        assert_eq!(said("Bore: 25=25"), "a tolerance is missing, such as H7, h7, H7/g6, m, +0.1 -0.2 or ±0.1");
    }
}
