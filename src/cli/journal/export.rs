//! `fitcheck journal export`: all checks that a question asks for, for other programs.

use std::io::Write;
use std::path::PathBuf;

use super::list::unread;
use super::row::{self, header};
use super::show::line;
use super::{CliError, Io, JournalArgs, Outcome, QUESTIONS, QuestionArgs, Refused as _, heard_or_not, save_with};
use crate::cli::args::one_of;
use crate::message::Say as _;
use crate::report::csv;
use crate::store::StoreError;
use crate::store::local::{Reader, Row};

/// So many entries are read at once.
const PAGE: usize = 500;

fn help() -> String {
    format!(
        "\
{QUESTIONS}

An export is the journal at one moment, however many programs record into it. Corrected and withdrawn
checks are in it, as are those that correct them (correction_of); standing leaves them out.

Columns of csv:
  {}
json has one entry on each line: its body as it is kept, with number, hash and chain.

Examples:
  fitcheck journal export -o checks.csv
  fitcheck journal export part:Flange standing --format json > flange.jsonl",
        header().join(",")
    )
}

/// Write checks as CSV or lines of JSON, the oldest first
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    #[command(flatten)]
    question: QuestionArgs,
    /// The file; default: standard output
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// Format of the export
    #[arg(long, value_name = "FORMAT", default_value = "csv", value_parser = one_of(FORMATS, |format| format))]
    format: &'static str,
    #[command(flatten)]
    journal: JournalArgs,
}

const FORMATS: [&str; 2] = ["csv", "json"];

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let question = self.question.read()?;
        let reader = Reader::open(&self.journal.file()?).said()?;
        // Entries never change, so these numbers are the journal as it is now.
        let mut numbers = reader.numbers(&question, None, usize::MAX).said()?;
        numbers.reverse();
        let mut export = Export { reader: &reader, numbers: &numbers, failed: None, unread: Vec::new() };
        let written = if let Some(path) = &self.output {
            save_with(path, &mut |out| export.write(self.format, out), io)
        } else {
            heard_or_not(export.write(self.format, io.data()))
        };
        // The journal's own words come first: its error only passes through the file's.
        if let Some(failed) = &export.failed {
            return Err(CliError::Said(failed.message()));
        }
        written?;
        Ok(unread(&export.unread, io))
    }
}

struct Export<'a> {
    reader: &'a Reader,
    numbers: &'a [u64],
    /// Why the journal could not be read to its end.
    failed: Option<StoreError>,
    /// Entries that this version cannot read.
    unread: Vec<Row>,
}

impl Export<'_> {
    fn write(&mut self, format: &str, out: &mut dyn Write) -> std::io::Result<()> {
        let is_csv = format == "csv";
        if is_csv {
            csv::line(header(), out)?;
        }
        for page in self.numbers.chunks(PAGE) {
            let rows = match self.reader.rows(page) {
                Ok(rows) => rows,
                Err(error) => {
                    let told = std::io::Error::other(error.to_string());
                    self.failed = Some(error);
                    return Err(told);
                }
            };
            for row in rows {
                if is_csv {
                    csv::line(row::line(&row), out)?;
                } else {
                    out.write_all(&line(&row, self.reader.chain(), None))?;
                }
                if row.entry.is_err() {
                    self.unread.push(row);
                }
            }
        }
        Ok(())
    }
}
