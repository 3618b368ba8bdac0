//! The command line: one file per subcommand, each a short walk through the rooms.
//!
//! Exit codes: 0 done and good, 10 rework, 11 scrap, 12 re-measure, 13 out of limits, 14 judged, but look first, 1 bad data, 2 wrong
//! usage, 130 stopped by Ctrl+C. `Outcome::worse` ranks them. A closed pipe ends the program quietly. Nothing here needs a display.
//!
//! To add a subcommand:
//!
//! 1. Write a file with its `Args` and their `run`, and its `mod` line; `table/verify.rs` is a small one to read first. What an argument
//!    is called in errors is a variant of `ErrorSubject`.
//! 2. Add its line to the table `subcommands!`, and declare what it answers with `row!` (CSV and JSON) or `object!` (JSON).
//! 3. Add calls of it and of each option and value to the corpus and record the answers (`tests/core/corpus.rs`). A test names every
//!    missing call.
//! 4. Its errors are variants of `error.rs`, its warnings and remarks of `said.rs`; their texts are in `cli.ftl` in every folder of
//!    `assets/locales`. Test it in `tests/core/NAME_cli.rs`.
//! 5. Describe it in `docs/manual/command-line.md` and `CHANGELOG.md`.
//!
//! The subcommands share:
//!
//! | file | what |
//! |---|---|
//! | `admitted` | what a run must admit by its exit code |
//! | `args` | arguments of several subcommands: format, tables, dialogue language |
//! | `io` | the standard streams, reading and saving files |
//! | `progress` | how far something long has come, and its end by Ctrl+C |
//! | `material` | materials of parts; the temperature of a measured part |
//! | `record` | what is judged, kept in a journal |
//! | `rule` | the decision rule and the uncertainty |
//! | `tools` | the tool table of a control, read and written |
//! | `answers` | callouts answered one by one as text, CSV or JSON |
//! | `people` | what people read: lengths and tables |
//! | `rows` | answers in figures: each value declared once, for CSV and JSON |
//! | `error` | why a subcommand could not do its work |
//! | `said` | remarks and warnings beside an answer |
//! | `of_window` | what only the window knows of this computer |
//! | `start` | a subcommand, the window, or files that it opens |

/// The table of subcommands: one file and one line each.
macro_rules! subcommands {
    ($($name:ident($args:ty)),+ $(,)?) => {
        #[derive(Debug, clap::Subcommand)]
        enum Command {
            $($name(Box<$args>),)+
        }

        impl Command {
            fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
                match self {
                    $(Self::$name(args) => args.run(io),)+
                }
            }
        }
    };
}

#[macro_use]
mod admitted;
#[macro_use]
mod rows;

mod answers;
mod args;
mod batch;
mod budget;
mod check;
mod circle;
mod completions;
mod cycle;
mod decide;
mod doctor;
mod error;
mod fit;
mod import;
mod io;
mod journal;
mod journal_place;
mod judging;
mod limits;
mod man;
mod material;
mod measured;
mod nc;
mod of_window;
mod pair;
mod parts;
mod people;
mod plan;
mod progress;
mod record;
mod report;
mod rule;
mod run;
mod said;
mod sql;
mod start;
mod stats;
mod table;
mod tools;
mod watch;

use std::process::ExitCode;

use clap::Parser;

use crate::files::{self, ZoneError};
use crate::row::figure::Figure;
use crate::verdict::Status;
use args::{Format, StandardArgs, TableArgs};
use error::{CliError, ErrorSubject, IntoCliError};
pub use io::{Io, tell};
use io::{diameter, now, put, read_contacts, read_input, read_table, save, save_with};
pub use of_window::{Kept, OfWindow};
use said::{CliRemark, CliWarning};
pub use start::Start;

/// Judge measured holes and shafts: good, rework or scrap.
///
/// Without a subcommand, the window opens. With file names instead, the window opens these files.
#[derive(Debug, Parser)]
#[command(name = "fitcheck", bin_name = "fitcheck", version = version(), max_term_width = 100, after_help = EXIT_CODES)]
#[command(override_usage = "fitcheck [COMMAND]\n       fitcheck FILE...")]
pub struct Cli {
    #[command(subcommand)]
    command: Option<Command>,
    /// Only warnings and errors on standard error, and that nothing was measured: no notes, progress or names of written files
    #[arg(short, long, global = true)]
    quiet: bool,
}

/// The version; of a package with the commit that it was built from, and that commit's day.
fn version() -> String {
    let version = env!("CARGO_PKG_VERSION");
    match (option_env!("FITCHECK_COMMIT"), option_env!("FITCHECK_DATE")) {
        (Some(commit), Some(date)) => format!("{version} ({commit}, {date})"),
        _ => version.to_owned(),
    }
}

const EXIT_CODES: &str = "\
Exit codes: 0 done and good, 10 rework, 11 scrap, 12 re-measure, 13 out of limits,
14 judged, but look first, 1 bad data, 2 wrong usage, 130 stopped by Ctrl+C.

14 takes the place of 0, 10 and 12: everything has an answer, but something contradicts it (the file's own status, another value of the \
same feature, a value that may be another quantity, nobody measured), or something measured is not in it (another sheet, a file with \
the bytes of another one, limits that a measuring block leaves out). Standard error gives the reason. With scrap the exit code stays 11, out of limits 13, bad data 1.";

subcommands! {
    Limits(limits::Args),
    Check(check::Args),
    Fit(fit::Args),
    Import(import::Args),
    Batch(batch::Args),
    Budget(budget::Args),
    Circle(circle::Args),
    Completions(completions::Args),
    Cycle(cycle::Args),
    Decide(decide::Args),
    Doctor(doctor::Args),
    Journal(journal::Args),
    Man(man::Args),
    Nc(nc::Args),
    Pair(pair::Args),
    Plan(plan::Args),
    Report(report::Args),
    Run(run::Args),
    Sql(sql::Args),
    Stats(stats::Args),
    Table(table::Args),
    Watch(watch::Args),
}

/// How a subcommand ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    /// Done; nothing was judged or everything is good.
    Done,
    /// Judged: the worst status.
    Judged(Status),
    /// Judged, but look first: something stands against the answer, or something measured was left out of it.
    LookFirst,
    /// Some of the data could not be used; the rest was answered.
    BadData,
    /// Ctrl+C ended it: what was answered until then stays.
    Stopped,
}

impl Outcome {
    /// What becomes of it where standard output could not be written: nothing is good then, and scrap stays scrap.
    const fn unwritten(self) -> Self {
        match self {
            Self::Judged(Status::Scrap) | Self::Stopped => self,
            Self::Done | Self::Judged(_) | Self::LookFirst | Self::BadData => Self::BadData,
        }
    }

    /// The exit code as listed above.
    const fn code(self) -> u8 {
        match self {
            Self::Done | Self::Judged(Status::Good) => 0,
            Self::Judged(Status::Rework) => 10,
            Self::Judged(Status::Scrap) => 11,
            Self::Judged(Status::ReMeasure) => 12,
            Self::Judged(Status::OutOfLimits) => 13,
            Self::LookFirst => 14,
            Self::BadData => 1,
            // As every shell says it of a program that SIGINT has ended.
            Self::Stopped => 130,
        }
    }

    /// Which of two counts: the one place that ranks them.
    const fn worse(self, other: Self) -> Self {
        if self.rank() < other.rank() { other } else { self }
    }

    const fn rank(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Judged(Status::Good) => 1,
            Self::Judged(Status::Rework) => 2,
            Self::Judged(Status::ReMeasure) => 3,
            Self::LookFirst => 4,
            Self::Judged(Status::OutOfLimits) => 5,
            Self::Judged(Status::Scrap) => 6,
            Self::BadData => 7,
            Self::Stopped => 8,
        }
    }
}

impl Cli {
    /// Runs the subcommand on the given streams and returns the exit code.
    pub fn run(&self, io: &mut Io<'_>) -> u8 {
        if self.quiet {
            io.be_quiet();
        }
        let result = self.command.as_ref().map_or(Ok(Outcome::Done), |command| command.run(io));
        let unwritten = io.unwritten();
        match result {
            Ok(outcome) => match unwritten {
                None => outcome.worse(io.admitted()).code(),
                Some(error) => {
                    io.fail(CliError::Stream(error));
                    outcome.unwritten().code()
                }
            },
            Err(CliError::Stream(error)) if error.kind() == std::io::ErrorKind::BrokenPipe => 0,
            Err(error) => {
                let outcome =
                    if matches!(error, CliError::Stopped { .. }) { Outcome::Stopped } else { Outcome::BadData };
                io.fail(error);
                outcome.code()
            }
        }
    }

    /// Runs the subcommand on the process's own streams; what only the window knows is asked where it is needed.
    pub fn run_here(&self, of_window: Option<fn() -> OfWindow>) -> ExitCode {
        // Days, entries and prints would have the times of another zone; the doctor says so among the rest.
        if let Err(error @ ZoneError::NotUnderstood { .. }) = files::zone()
            && !matches!(self.command, Some(Command::Doctor(_)))
        {
            Self::wrong_usage(&error);
        }
        ExitCode::from(Io::standard(of_window, |io| self.run(io)))
    }
}
