//! The command line: one file a subcommand, each a thin walk through the rooms.
//!
//! Exit codes: 0 done and good, 10 rework, 11 scrap, 12 re-measure, 1 bad data, 2 wrong usage. A closed pipe ends the
//! program quietly. Nothing here needs a display.

mod check;
mod circle;
mod cycle;
mod fit;
mod import;
mod limits;
mod nc;
mod report;
mod run;
mod table;

use std::io::{BufRead, Read as _, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::builder::PossibleValuesParser;
use clap::{Parser, Subcommand, ValueEnum};

use crate::control::shipped_tables;
use crate::files::{self, FileError};
use crate::report::columns::Cell;
use crate::tolerance::{Base, Sources, iso286};
use crate::verdict::Status;

/// Good, rework or scrap: limits and fits, measured.
///
/// Without a subcommand the window opens.
#[derive(Debug, Parser)]
#[command(name = "fitcheck", version, max_term_width = 100, after_help = EXIT_CODES)]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
}

const EXIT_CODES: &str = "Exit codes: 0 done and good, 10 rework, 11 scrap, 12 re-measure, 1 bad data, 2 wrong usage.";

#[derive(Debug, Subcommand)]
enum Command {
    Limits(limits::Args),
    Check(check::Args),
    Fit(fit::Args),
    Import(import::Args),
    Circle(circle::Args),
    Cycle(Box<cycle::Args>),
    Nc(Box<nc::Args>),
    Report(report::Args),
    Run(Box<run::Args>),
    Table(table::Args),
}

/// How a result is printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people.
    Text,
    /// For spreadsheets and scripts: the same in every language.
    Csv,
    /// For programs: the same in every language.
    Json,
}

/// Where the tables come from.
#[derive(Debug, Clone, clap::Args)]
pub struct TableArgs {
    /// Folder with your own control tables (*.tab); they come first for the classes and sizes that they hold
    #[arg(long, value_name = "FOLDER", global = false)]
    tables: Option<PathBuf>,
    /// What answers after your own tables
    #[arg(long, value_enum, default_value_t = SourceChoice::Iso286)]
    source: SourceChoice,
    #[command(flatten)]
    standard: StandardArgs,
}

/// The two sources of limits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum SourceChoice {
    /// ISO 286, every class to 3150 mm.
    Iso286,
    /// The control's two tables, 47 classes to 400 mm.
    Control,
}

/// Where editions of ISO 286 differ.
#[derive(Debug, Clone, clap::Args)]
pub struct StandardArgs {
    /// Edition of ISO 286 for cd, ef and fg: to 10 mm (1988) or to 50 mm (2010)
    #[arg(long, value_name = "YEAR", default_value = "2010", value_parser = PossibleValuesParser::new(["1988", "2010"]))]
    edition: String,
    /// Round half micrometres of JS7 to JS11 and js7 to js11 off, as in 1988
    #[arg(long)]
    js_rounded: bool,
}

impl StandardArgs {
    /// The options of the standard.
    pub fn options(&self) -> iso286::Options {
        iso286::Options {
            edition: if self.edition == "1988" { iso286::Edition::Of1988 } else { iso286::Edition::Of2010 },
            js: if self.js_rounded { iso286::JsHalves::Rounded } else { iso286::JsHalves::Exact },
        }
    }
}

impl TableArgs {
    /// Where limits are looked up; warnings about the user's own tables go to standard error.
    fn load(&self, io: &mut Io<'_>) -> Result<Sources, CliError> {
        let base = match self.source {
            SourceChoice::Iso286 => Base::Iso286,
            SourceChoice::Control => Base::Tables(shipped_tables()),
        };
        let sources = Sources::default().with_base(base).with_options(self.standard.options());
        let Some(folder) = &self.tables else { return Ok(sources) };
        let own = crate::control::deviations::read_folder(folder).map_err(|error| CliError::Data(error.to_string()))?;
        for warning in &own.warnings {
            io.tell(format_args!("warning: {warning}"))?;
        }
        Ok(sources.with_own(own.tables))
    }
}

/// An exact decimal: as it is in CSV, a number in JSON.
#[derive(Debug)]
struct Figure(String);

impl serde::Serialize for Figure {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match (self.0.parse::<i64>(), self.0.parse::<f64>()) {
            (Ok(whole), _) => serializer.serialize_i64(whole),
            // A length has at most 16 figures and none finer than a nanometre: its nearest float prints the same.
            (_, Ok(number)) => serializer.serialize_f64(number),
            _ => serializer.serialize_str(&self.0),
        }
    }
}

impl Cell for Figure {
    fn cell(&self) -> Option<String> {
        Some(self.0.clone())
    }
}

/// Why a subcommand could not do its work.
#[derive(Debug, thiserror::Error)]
pub enum CliError {
    /// Standard input or output failed.
    #[error("{0}")]
    Stream(#[from] std::io::Error),
    /// A file could not be read or written.
    #[error("{0}")]
    File(#[from] FileError),
    /// What was given cannot be used.
    #[error("{0}")]
    Data(String),
}

/// The standard streams, as arguments so that tests bring their own.
pub struct Io<'a> {
    /// Standard input.
    pub input: &'a mut dyn BufRead,
    /// Standard output, buffered.
    pub out: &'a mut dyn Write,
    /// Standard error.
    pub err: &'a mut dyn Write,
}

/// How a subcommand ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Done; nothing was judged or everything is good.
    Done,
    /// Judged: the worst status of all.
    Judged(Status),
    /// Some of the data could not be used; the rest was answered.
    BadData,
}

impl Outcome {
    /// The exit code of the contract.
    pub const fn code(self) -> u8 {
        match self {
            Self::Done | Self::Judged(Status::Good) => 0,
            Self::Judged(Status::Rework) => 10,
            Self::Judged(Status::Scrap) => 11,
            Self::Judged(Status::ReMeasure) => 12,
            Self::BadData => 1,
        }
    }
}

impl Io<'_> {
    /// Writes a line to standard error; nobody listening there is no error, so that the rest is still done.
    fn tell(&mut self, line: std::fmt::Arguments<'_>) -> Result<(), CliError> {
        heard_or_not(writeln!(self.err, "{}", tame(&line.to_string())))
    }
}

/// A text from a file as a terminal may get it: control characters, which could write a title or hide a line, become
/// blanks.
fn tame(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\n' && c != '\t' { ' ' } else { c }).collect()
}

/// A closed pipe is not an error, and must never end a subcommand before its verdict.
fn heard_or_not(written: std::io::Result<()>) -> Result<(), CliError> {
    match written {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.into()),
        _ => Ok(()),
    }
}

impl Cli {
    /// Whether a subcommand was named; without one the window opens.
    pub const fn has_subcommand(&self) -> bool {
        self.command.is_some()
    }

    /// Runs the subcommand on the given streams and answers with the exit code.
    pub fn run(&self, io: &mut Io<'_>) -> u8 {
        let result = match &self.command {
            Some(Command::Limits(args)) => args.run(io),
            Some(Command::Check(args)) => args.run(io),
            Some(Command::Fit(args)) => args.run(io),
            Some(Command::Import(args)) => args.run(io),
            Some(Command::Circle(args)) => args.run(io),
            Some(Command::Cycle(args)) => args.run(io),
            Some(Command::Nc(args)) => args.run(io),
            Some(Command::Report(args)) => args.run(io),
            Some(Command::Run(args)) => args.run(io),
            Some(Command::Table(args)) => args.run(io),
            None => Ok(Outcome::Done),
        };
        let result = result.and_then(|outcome| heard_or_not(io.out.flush()).map(|()| outcome));
        match result {
            Ok(outcome) => outcome.code(),
            Err(CliError::Stream(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => 0,
            Err(error) => {
                // Standard error may be closed as well; there is nobody left to tell.
                let _unheard = writeln!(io.err, "fitcheck: {}", tame(&error.to_string()));
                Outcome::BadData.code()
            }
        }
    }

    /// Runs the subcommand on the process's own streams.
    pub fn run_here(&self) -> ExitCode {
        let mut out = std::io::BufWriter::new(std::io::stdout().lock());
        let mut err = std::io::stderr().lock();
        let mut input = std::io::stdin().lock();
        ExitCode::from(self.run(&mut Io { input: &mut input, out: &mut out, err: &mut err }))
    }
}

/// The bytes of a file, or of standard input for `-`, and the name to call it by.
fn read_input(path: &Path, io: &mut Io<'_>) -> Result<(String, Vec<u8>), CliError> {
    if path.as_os_str() == "-" {
        let mut bytes = Vec::new();
        std::io::Read::take(&mut *io.input, files::LARGEST + 1).read_to_end(&mut bytes)?;
        if files::LARGEST < u64::try_from(bytes.len()).unwrap_or(u64::MAX) {
            return Err(FileError::TooLarge { path: path.to_owned() }.into());
        }
        return Ok(("standard input".to_owned(), bytes));
    }
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    Ok((name, files::read(path)?))
}

/// The local date and time to the second: what a person reads, and what every control prints.
fn now() -> jiff::civil::DateTime {
    let now = jiff::Zoned::now().datetime();
    now.with().subsec_nanosecond(0).build().unwrap_or(now)
}

/// Writes an output file and says its name on standard error.
fn save(path: &Path, bytes: &[u8], io: &mut Io<'_>) -> Result<(), CliError> {
    files::write(path, bytes)?;
    io.tell(format_args!("wrote {}", path.display()))
}
