//! `fitcheck journal export`: all checks that a question asks for, for other programs.

use std::io::Write;
use std::path::PathBuf;

use super::list::{unread, without_reports};
use super::row::Line;
use super::show::line;
use super::{CliError, Format, IntoCliError as _, Io, JournalArgs, Outcome, QUESTIONS, QuestionArgs, put, server};
use crate::cli::args::one_of;
use crate::cli::journal_place::JournalPlace;
use crate::cli::progress::{Size, Work, stopped};
use crate::cli::rows;
use crate::journal::chain::ChainId;
use crate::message::{Message, Say as _};
use crate::report::csv;
use crate::store::local::{ListedEntry, Reader};

/// So many entries are read at once.
const PAGE: usize = 500;

fn help() -> String {
    format!(
        "\
{QUESTIONS}

An export is the journal at one moment, however many programs record into it. It includes corrected
and withdrawn checks, and those that correct them (correction_of); standing leaves the former out.
Reports and alarms are no checks: they are left out, unless reports or alarms asks for them alone.
A server gives the checks of all stations, the last received first.

Columns of csv:
  {}
json has one entry on each line: its body as it is stored, with number, hash and chain.

Examples:
  fitcheck journal export -o checks.csv
  fitcheck journal export part:Flange standing --format json > flange.jsonl",
        rows::names::<Line>().join(",")
    )
}

/// Write checks as CSV or lines of JSON, oldest first
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    #[command(flatten)]
    question: QuestionArgs,
    /// The file to write; - or no file is standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Format of the export
    #[arg(long, value_name = "FORMAT", default_value = "csv", value_parser = one_of([Format::Csv, Format::Json], |format| format.word()))]
    format: Format,
    #[command(flatten)]
    journal: JournalArgs,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let question = without_reports(self.question.read(io)?);
        let from = match self.journal.place()? {
            JournalPlace::File(file) => {
                let reader = Reader::open(&file).said()?;
                // Entries never change, so these numbers are the journal as it is now.
                let mut numbers = reader.numbers(&question, None, usize::MAX).said()?;
                numbers.reverse();
                Source::Journal { reader, numbers }
            }
            JournalPlace::Server(address) => Source::Server(Box::new(server::pages(&address, question, io)?)),
        };
        let size = match &from {
            Source::Journal { numbers, .. } => u64::try_from(numbers.len()).map_or(Size::Open, Size::Rows),
            Source::Server(_) => Size::Open,
        };
        let work = Work::of(
            &self.output.as_ref().map_or_else(|| "journal".to_owned(), |path| path.display().to_string()),
            size,
        );
        io.watch(&work);
        let mut export = Export { from: &from, work: &work, failed: None, unread: Vec::new() };
        let written = put(self.output.as_deref(), &mut |out| export.write(self.format, out), io);
        if work.is_stopped() {
            return Err(CliError::Stopped { rows: work.rows() });
        }
        // The journal's own words come first: its error only passes through the file's.
        if let Some(failed) = &export.failed {
            return Err(CliError::Said(failed.clone()));
        }
        written?;
        Ok(unread(&export.unread, io))
    }
}

/// Where the entries come from.
enum Source {
    Journal { reader: Reader, numbers: Vec<u64> },
    Server(Box<server::Pages>),
}

impl Source {
    /// Gives page after page to `take`, until that fails.
    ///
    /// # Errors
    /// Why the journal could not be read to its end.
    fn each(
        &self,
        take: &mut dyn FnMut(ChainId, ListedEntry) -> std::io::Result<()>,
    ) -> Result<std::io::Result<()>, Message> {
        match self {
            Self::Journal { reader, numbers } => {
                for page in numbers.chunks(PAGE) {
                    for row in reader.rows(page).map_err(|error| error.message())? {
                        if let Err(error) = take(reader.chain(), row) {
                            return Ok(Err(error));
                        }
                    }
                }
                Ok(Ok(()))
            }
            Self::Server(pages) => pages.each(PAGE, take),
        }
    }
}

struct Export<'a> {
    from: &'a Source,
    work: &'a Work,
    /// Why the journal could not be read to its end.
    failed: Option<Message>,
    /// Entries that this version cannot read.
    unread: Vec<ListedEntry>,
}

impl Export<'_> {
    fn write(&mut self, format: Format, out: &mut dyn Write) -> std::io::Result<()> {
        let Self { from, work, failed, unread } = self;
        let is_csv = format == Format::Csv;
        if is_csv {
            csv::line(rows::names::<Line>(), out)?;
        }
        let read = from.each(&mut |chain, row| {
            if work.is_stopped() {
                return Err(stopped());
            }
            work.row();
            if is_csv {
                out.write_all(rows::line(&Line::of(&row)).end())?;
            } else {
                out.write_all(&line(&row, chain, None))?;
            }
            if row.entry.is_err() {
                unread.push(row);
            }
            Ok(())
        });
        read.unwrap_or_else(|why| {
            let told = std::io::Error::other(why.to_string());
            *failed = Some(why);
            Err(told)
        })
    }
}
