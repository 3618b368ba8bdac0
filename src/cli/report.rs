//! `fitcheck report`

mod part;

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::civil::DateTime;

use super::args::one_of;
use super::judging::{Judge, JudgeArgs, Warned};
use super::measured::Measured;
use super::progress::{Watched, Work, stopped};
use super::{CliError, CliWarning, Io, Outcome, TableArgs};
use part::Parts;
use crate::exchange::{self, ByPlan, Item, import_from};
use crate::files::{self, FileError};
use crate::journal::Record;
use crate::length::{Length, LengthError};
use crate::message::{Message, Say};
use crate::part::Plan;
use crate::probing::{Measurement, Origin};
use crate::report::csv::More;
use crate::report::part::PartSheet;
use crate::report::{self, Checks, EndingError, RENDERINGS, Rendering, Report};
use crate::tolerance::{Callout, CalloutError, LimitsError, Sources};
use crate::verdict::Status;
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

    /// Judge by a part plan: each value finds its feature, and the report shows the whole part with its picture
    #[arg(long, value_name = "PLAN", requires = "files")]
    plan: Option<PathBuf>,

    #[command(flatten)]
    tables: TableArgs,

    #[command(flatten)]
    by: JudgeArgs,
}

const EXAMPLES: &str = "\
Examples:
  fitcheck report --check \"25 H7=25.012\" -o bore.html
  fitcheck report --check \"Bore A: 25 H7=25.012\" --check \"Stud: 10 g6=9,991\" \\
      --part 4711 --order 2026-118 --inspector \"J. Jansen\" --language nl -o report.html
  fitcheck report bores.csv TCHPR421.TXT -o report.html
  fitcheck report bores.csv --rule iso14253-2017 --budget station3.toml -o report.html
  fitcheck report bores.csv --temperature 26 --material steel -o report.html
  fitcheck report --plan flange.toml results.qif TCHPR421.TXT -o flange.html
  fitcheck report --check \"25 H7=25.012\" -o - --format json

With --plan the page begins with each part: its status, what is missing, its picture with a balloon
a feature, and where each value is from. JSON has the same as parts, without places on the picture.

The exit code is that of the worst check. A check that cannot be read or judged is named on standard
error, and in the report as HTML and JSON; the others are reported, and the exit code is 1. It is 1, too,
where a part of the plan lacks a value. CSV has the checks alone, with the name of the picture: standard
error tells what it does not hold.";

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

/// The most notes on a report; all of them are on standard error.
const MOST_NOTES: usize = 1_000;

/// The checks of files and options. The files are read again for every look at the checks, so that they may be of any size.
#[derive(Debug)]
struct Given {
    files: Vec<(PathBuf, Measured, Work)>,
    /// From options.
    typed: Vec<Record>,
    sources: Sources,
    now: DateTime,
    judge: Judge,
    plan: Option<Arc<Plan>>,
}

impl Given {
    fn read(&self, (path, file, work): (&Path, &Measured, &Work), take: &mut dyn FnMut(Item)) {
        let beside = |ending: &str| files::beside(path, ending);
        let given = exchange::Given { beside: &beside, ..exchange::Given::new(&self.sources, self.now) };
        let mut by_plan = self.plan.as_deref().map(ByPlan::new);
        let mut take = |item: Item| {
            // What comes after the wish to stop is what it broke.
            if work.is_stopped() {
                return;
            }
            if item.is_row() {
                work.row();
            }
            match &mut by_plan {
                Some(by_plan) => by_plan.item(item, take),
                None => take(item),
            }
        };
        file.read(|body| import_from(&name(path), &mut Watched::new(body, work), given, &mut take));
    }

    /// How many rows were done, where Ctrl+C ended it.
    fn stopped(&self) -> Option<CliError> {
        let is_stopped = self.files.iter().any(|(.., work)| work.is_stopped());
        is_stopped.then(|| CliError::Stopped { rows: self.files.iter().map(|(.., work)| work.rows()).sum() })
    }
}

/// The name of a file without its folder.
fn name(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

impl Checks for Given {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        for (path, file, work) in &self.files {
            let mut seen = Ok(());
            work.again(&name(path));
            self.read((path, file, work), &mut |item| {
                // What cannot be judged was noted at the first look.
                if seen.is_ok()
                    && let Item::Record { record, .. } = item
                    && let Ok(record) = self.judge.judged(*record)
                {
                    seen = see(&record);
                }
            });
            seen?;
            if work.is_stopped() {
                return Err(stopped());
            }
            work.line().end();
            if !file.is_unchanged() {
                return Err(io::Error::other(FileError::Changed { path: path.clone() }.to_string()));
            }
        }
        self.typed.iter().try_for_each(see)
    }

    /// One way judges all of them.
    fn more(&self) -> io::Result<More> {
        Ok(self.judge.more())
    }
}

/// What a first look at the checks finds, and what did not become a check.
#[derive(Debug, Default)]
struct Collected {
    worst: Option<Status>,
    notes: Vec<Message>,
    more_notes: usize,
    bad: bool,
    warned: Warned,
    /// The whole parts, with a plan.
    parts: Option<Parts>,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let rendering = self.rendering()?;
        let judge = self.by.judge(io)?;
        let sources = self.tables.load(io)?;
        let words = Words::new(self.language);
        let now = self.time.unwrap_or_else(super::now);
        let mut collected = Collected::default();
        if let Some(path) = &self.plan {
            collected.parts = Some(Parts::read(path, &sources, io)?);
        }
        let plan = collected.parts.as_ref().map(|parts| Arc::clone(&parts.plan));
        let mut given = Given { files: Vec::new(), typed: Vec::new(), sources, now, judge, plan };
        given.judge.tell(io);
        super::io::warn_of_repeats(&self.files, io);
        for path in &self.files {
            match Measured::open(path) {
                Ok(file) => {
                    let work = Work::on(&name(path), file.size());
                    io.watch(&work);
                    collected.file((path, &file, &work), &given, io);
                    work.line().end();
                    given.files.push((path.clone(), file, work));
                    if let Some(stopped) = given.stopped() {
                        return Err(stopped);
                    }
                }
                Err(error) => {
                    collected.refuse(Message::new("report-note").text("place", name(path)), error.message(), io);
                }
            }
        }
        for text in &self.checks {
            let judged = record(text, &given.sources, now).map_err(|error| error.message());
            match judged.and_then(|record| given.judge.judged(record).map_err(|error| error.message())) {
                Ok(record) => {
                    collected.see(&record, io);
                    given.typed.push(record);
                }
                Err(error) => collected.refuse(Message::new("report-note").text("place", text), error, io),
            }
        }
        let checks = Arc::new(given);
        let (parts, of_plan) = collected.end_parts(io);
        let Some(worst) = collected.worst else { return Err(CliError::ReportEmpty) };
        let bad = collected.bad;
        let report = Report {
            title: self.title.clone().unwrap_or_default(),
            part: self.part.clone().or(of_plan),
            order: self.order.clone(),
            inspector: self.inspector.clone(),
            notes: collected.notes(),
            parts,
            ..Report::new(now, Arc::clone(&checks))
        };
        if rendering.name == report::csv::RENDERING.name {
            self.warn_of_csv(report.notes.len(), io);
        }
        let written = match &self.output {
            Output::Standard => (rendering.render)(&report, &words, io.data()).map_err(CliError::from),
            Output::File(path, _) => super::save_with(path, &mut |out| (rendering.render)(&report, &words, out), io),
        };
        if let Some(stopped) = checks.stopped() {
            return Err(stopped);
        }
        written?;
        Ok(if bad { Outcome::BadData } else { Outcome::Judged(worst) })
    }

    /// Warns of what CSV has no place for.
    fn warn_of_csv(&self, notes: usize, io: &mut Io<'_>) {
        let given = [
            ("--title", &self.title),
            ("--part", &self.part),
            ("--order", &self.order),
            ("--inspector", &self.inspector),
        ];
        let options: Vec<&str> =
            given.into_iter().filter(|(_, text)| text.is_some()).map(|(option, _)| option).collect();
        if !options.is_empty() {
            io.warn(&CliWarning::NotInCsv { options: &options.join(", ") });
        }
        if 0 < notes {
            io.warn(&CliWarning::NotesNotInCsv { count: notes });
        }
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
    /// Looks at a file of measurements.
    fn file(&mut self, (path, file, work): (&Path, &Measured, &Work), given: &Given, io: &mut Io<'_>) {
        let name = &name(path);
        let line = |line: usize| Message::new("report-note-line").text("place", name).text("line", line);
        given.read((path, file, work), &mut |item| match item {
            Item::Record { record, line: at, labels } => match given.judge.judged(*record) {
                Ok(record) => {
                    self.see(&record, io);
                    self.parts.iter_mut().for_each(|parts| parts.see(&record, &labels));
                }
                Err(error) => self.refuse(line(at), error.message(), io),
            },
            Item::Unjudged(unjudged) => self.refuse(line(unjudged.line), unjudged.why.message(), io),
            Item::Error(error) => self.refuse(Message::new("report-note").text("place", name), error.message(), io),
            Item::Warning(warning) => {
                self.note(line(warning.place.line.unwrap_or_default()), warning.what.message(), io);
            }
            Item::Contacts(_) => {}
        });
    }

    /// The whole parts, and the name of the part that the plan is of. What keeps them from being complete is told.
    fn end_parts(&mut self, io: &mut Io<'_>) -> (Vec<PartSheet>, Option<String>) {
        let Some(parts) = self.parts.take() else { return (Vec::new(), None) };
        if let Some(why) = parts.unseen() {
            io.warn(why);
        }
        let name = Some(parts.plan.head.part.clone()).filter(|name| !name.is_empty());
        let (sheets, is_complete, more) = parts.end(io);
        self.bad |= !is_complete;
        self.notes.extend(more);
        (sheets, name)
    }

    fn see(&mut self, record: &Record, io: &mut Io<'_>) {
        self.warned.see(record, io);
        self.worst = self.worst.max(Some(record.verdict.status()));
    }

    /// The notes of the report; the last one says how many more there are.
    fn notes(self) -> Vec<Message> {
        let more = (0 < self.more_notes).then(|| Message::new("report-note-more").count("count", self.more_notes));
        self.notes.into_iter().chain(more).collect()
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
        if self.notes.len() < MOST_NOTES {
            self.notes.push(note);
        } else {
            self.more_notes += 1;
        }
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
