//! `fitcheck report`

mod part;
mod reading;
mod recording;
mod template;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::civil::DateTime;
use part::ReportParts;
use reading::{Collected, ReportChecks, name};
use recording::ReportRecordArgs;
use template::TemplateArgs;

use super::args::one_of;
use super::judging::{JudgeArgs, SaidArgs};
use super::measured::Measured;
use super::parts::RepeatArgs;
use super::progress::Work;
use super::{CliError, CliWarning, IntoCliError as _, Io, Outcome, TableArgs};
use crate::journal::Record;
use crate::journal::entry::Shown;
use crate::length::{Length, LengthError};
use crate::message::{Say, message};
use crate::probing::{Measurement, Origin};
use crate::proof::{self, Seen, SeenFile};
use crate::report::template::HeadField;
use crate::report::{self, EndingError, Holds, RENDERINGS, Rendering, Report};
use crate::tolerance::{Callout, CalloutError, LimitsError, Sources};
use crate::words::{Language, Words};

/// Write an inspection report of one or more checks
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// Files of measurements to report, in any format that `fitcheck import` reads
    #[arg(value_name = "FILE", required_unless_present_any = ["checks", "plan"])]
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

    /// Name of the inspector
    #[arg(long, value_name = "NAME")]
    inspector: Option<String>,

    /// Language of the report as HTML, PDF, PNG, Markdown or XLSX; the other formats are the same in every language;
    /// default: that of the template, else en
    #[arg(long, value_parser = one_of(Language::all(), |language| language.code()))]
    language: Option<Language>,

    /// An earlier report of the part, as PDF or JSON: HTML, PDF, Markdown and XLSX say which results and limits changed since
    #[arg(long, value_name = "FILE")]
    since: Option<PathBuf>,

    #[command(flatten)]
    look: TemplateArgs,

    /// Date and time of the report, and of checks without their own; default: now
    #[arg(long, value_name = "YYYY-MM-DDTHH:MM")]
    time: Option<DateTime>,

    /// Judge by a part plan: values are matched to features, and the report shows the whole part with its picture
    #[arg(long, value_name = "PLAN")]
    plan: Option<PathBuf>,

    #[command(flatten)]
    tables: TableArgs,

    #[command(flatten)]
    said: SaidArgs,

    #[command(flatten)]
    by: JudgeArgs,

    #[command(flatten)]
    repeats: RepeatArgs,

    #[command(flatten)]
    record: ReportRecordArgs,
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
  fitcheck report --plan flange.toml results.qif --language de -o flange.pdf
  fitcheck report bores.csv --paper letter -o report.pdf
  fitcheck report --plan flange.toml results.qif --template certificate --head customer=Northgate -o flange.pdf
  fitcheck report --plan flange.toml results.qif --template label --paper large-label -o label.png
  fitcheck report --check \"25 H7=25.012\" -o - --format json
  fitcheck report bores.csv -o bores.html --record --who Anna
  fitcheck report bores.csv -o report.xlsx
  fitcheck report --plan flange.toml results.csv -o flange.dfq

A report as PDF has pages to print and to sign. The same data as JSON and CSV are attached, unless
they are very large. The file can be kept (PDF/A-3a) and read aloud (PDF/UA-1). PNG is for labels.

With --plan, the page begins with the parts, each with its status, what is missing, its picture with a
balloon for each feature, and the source of each value. JSON has the same under parts, without
positions on the picture. Markdown and XLSX have it without the picture; AQDEF and QIF have the values of
the parts with their serial numbers.

AQDEF (.dfq) has limits and no decision rules: a value that its limits alone would call better than the
report does is marked as not valid there, such as a simulated one. In QIF nothing but a good value
that was measured is a PASS.

The exit code is that of the worst check. A check that cannot be read or judged is named on standard
error, and in every report but CSV; the others are reported, and the exit code is 1.
With --plan it is that of the worst part, by the value of each feature that counts (the last one
by its time; if values contradict each other, the worst one), and 1 if none is worse than good but
a part lacks a value. 14 (judged, but look first: see fitcheck --help) takes the place of 0, 10 and
12 if something contradicts a verdict. CSV holds only the checks, with the name of the picture:
standard error reports what it leaves out.

With --record, the journal gets an entry with the name and the SHA-256 of the file, and counts its
checks as not recorded: fitcheck journal verify FILE then says whether a file is this one. If that
cannot be recorded, the file stays, and the exit code is 1.";

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

/// The help of `--output`: `.html, .htm, .csv, … or .qif`.
fn output_help() -> String {
    let endings = report::endings().replace(' ', ", ");
    let (first, last) = endings.rsplit_once(", ").unwrap_or(("", &endings));
    format!("File to write, in the format of its ending: {first} or {last}; \"-\" is standard output")
}

/// Reads `--output`: a wrong ending is wrong usage.
fn output(text: &str) -> Result<Output, EndingError> {
    if text == "-" {
        return Ok(Output::Standard);
    }
    Ok(Output::File(PathBuf::from(text), report::rendering_for(Path::new(text))?))
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let rendering = self.rendering()?;
        let recorder = self.record.recorder(matches!(self.output, Output::File(..)))?;
        let judge = self.by.judge(io)?.with(&self.said);
        let sources = self.tables.load(io)?;
        let template = self.look.template()?;
        rendering.refusal(self.look.paper(&template)).map_or(Ok(()), Err).said()?;
        let words = Words::new(self.language.or_else(|| template.language()).unwrap_or_default());
        let now = self.time.unwrap_or_else(super::now);
        let mut collected = Collected::default();
        if let Some(path) = &self.plan {
            collected.parts = Some(ReportParts::read(path, &sources, self.repeats.repeats(), io)?);
        }
        let plan = collected.parts.as_ref().map(|parts| Arc::clone(&parts.plan));
        let mut given =
            ReportChecks { files: Vec::new(), typed: Vec::new(), sources, now, judge, plan, are_corrected: false };
        given.judge.tell(io);
        super::io::warn_of_repeats(&self.files, io);
        for path in &self.files {
            match Measured::open(path) {
                Ok(file) => {
                    let work = Work::on(&name(path), file.size());
                    io.watch(&work);
                    let read = collected.file((path, &file, &work), &given, io);
                    work.line().end();
                    read?;
                    given.files.push((path.clone(), file, work));
                    if let Some(stopped) = given.stopped() {
                        return Err(stopped);
                    }
                }
                Err(error) => {
                    collected.refuse(message!("report-note").text("place", name(path)), error.message(), io);
                }
            }
        }
        self.typed(&mut given, &mut collected, io);
        given.are_corrected = collected.are_corrected;
        let checks = Arc::new(given);
        let (parts, of_plan) = collected.end_parts(template.is_blank(), io);
        // A sheet that is filled in by hand needs no value.
        let is_form = template.is_blank() && !parts.is_empty();
        collected.tell_open(self.plan.is_some(), io);
        let outcome = collected.outcome().or(is_form.then_some(Outcome::Done)).ok_or(CliError::ReportEmpty)?;
        let count = collected.checks;
        let (one_part, serial) = collected.one_part(self.plan.is_some() || !self.checks.is_empty());
        let mut report = Report {
            title: self.title.as_ref().map_or_else(String::new, Clone::clone),
            part: self.part.clone().or(of_plan).or(one_part),
            order: self.order.clone(),
            inspector: self.inspector.clone(),
            is_partial: collected.is_partial(),
            notes: collected.notes(),
            parts,
            ..Report::new(now, Arc::clone(&checks))
        };
        report.tell(HeadField::Serial, &serial);
        let report = self.compared(self.look.dress(report, &template))?;
        if rendering.holds == Holds::Checks {
            self.warn_of_checks_alone(report.notes.len(), io);
        }
        let written = match &self.output {
            Output::Standard => (rendering.render)(&report, &words, io.data()).map(|()| None).map_err(CliError::from),
            Output::File(path, _) => save(path, rendering, &report, &words, io).map(|seen| Some((path, seen))),
        };
        if let Some(stopped) = checks.stopped() {
            return Err(stopped);
        }
        if let Some((recorder, (path, seen))) = recorder.zip(written?) {
            let shown = Shown { unrecorded: count, ..Shown::default() };
            let reported = seen.reported(name(path), rendering, &report.title, shown);
            let unknown = |error| CliError::ReportNotKnown { file: name(path), error };
            recorder.keep_report(reported, io).map_err(unknown)?;
        }
        Ok(outcome)
    }

    /// Judges the checks that options give.
    fn typed(&self, given: &mut ReportChecks, collected: &mut Collected, io: &mut Io<'_>) {
        for text in &self.checks {
            let judged = record(text, &given.sources, given.now).map_err(|error| error.message());
            match judged.and_then(|record| given.judge.judged(record).map_err(|error| error.message())) {
                Ok(record) => {
                    collected.see_typed(&record, io);
                    given.typed.push(record);
                }
                Err(error) => collected.refuse(message!("report-note").text("place", text), error, io),
            }
        }
    }

    /// The report with the earlier one that it is compared with, where one is given.
    fn compared(&self, report: Report) -> Result<Report, CliError> {
        let Some(path) = &self.since else { return Ok(report) };
        let file = crate::files::read_file(path).said()?;
        let earlier = proof::earlier_report(&file).about(&name(path))?;
        Ok(Report { earlier: Some(Arc::new(earlier)), ..report })
    }

    /// Warns of what a file of checks alone has no place for.
    fn warn_of_checks_alone(&self, notes: usize, io: &mut Io<'_>) {
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

/// Writes the file, and sees what is written.
fn save(
    path: &Path,
    rendering: &Rendering,
    report: &Report,
    words: &Words,
    io: &mut Io<'_>,
) -> Result<SeenFile, CliError> {
    let mut file = Seen::new(std::io::sink()).finish();
    let mut write = |out: &mut (dyn Write + Send)| {
        let mut seen = Seen::new(out);
        (rendering.render)(report, words, &mut seen)?;
        file = seen.finish();
        Ok(())
    };
    super::save_with(path, &mut write, io)?;
    Ok(file)
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
