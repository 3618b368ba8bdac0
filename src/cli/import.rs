//! `fitcheck import`: measurements from files, with a verdict for each.

mod keeping;
mod print;
mod row;

use std::path::{Path, PathBuf};

use jiff::civil::DateTime;

use super::judging::JudgeArgs;
use super::record::RecordArgs;
use super::{CliError, Format, Io, Outcome, TableArgs, said};
use crate::exchange::{FORMATS, Item, import_each};
use crate::files;
use crate::report::columns::names;
use crate::verdict::Status;
use keeping::Keeping;
use print::Printer;
use row::{Row, Rows};

/// Read measurements from files of any known format and judge each
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    /// Files to read; a file that cannot be used is reported and the next one is read
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// Format of the verdicts
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Date and time of measurements whose file has none; default: now
    #[arg(long, value_name = "YYYY-MM-DDTHH:MM")]
    time: Option<DateTime>,

    #[command(flatten)]
    tables: TableArgs,

    #[command(flatten)]
    by: JudgeArgs,

    #[command(flatten)]
    record: RecordArgs,
}

fn help() -> String {
    let formats = FORMATS.iter().map(|format| {
        let endings: Vec<String> = format.endings.iter().map(|ending| format!(".{ending}")).collect();
        format!("  {:<14}{} ({})\n", format.name, format, endings.join(" "))
    });
    let largest = files::LARGEST >> 20;
    format!(
        "\
Formats, told by content:
{}
A CSV needs a column of callouts (or of nominal sizes and classes) and one of measured values. \
A header in English, Dutch, German or Italian tells them apart; without one their content does. \
Comma, semicolon, tab and pipe separate; point or comma is the decimal sign. \
A unit may stand in the header: measured [mm], measured_um, Istmaß (inch).

Columns of --format csv, and names in JSON:
  {}
status is the diameter's; position tells the centre's, IN or OUT, where the control monitored it. \
A decision rule, a budget and a temperature add the columns that they add in fitcheck report.

Examples:
  fitcheck import bores.csv
  fitcheck import TCHPR421.TXT TCHPR422.TXT --format csv > verdicts.csv
  fitcheck import --tables my_tables --format json measurements.csv
  fitcheck import bores.csv --rule iso14253-2017 --u 1.2 --format csv

The exit code is that of the worst verdict, a centre out of position counting as scrap; \
it is 1 where any row or file could not be used or not be judged. Files are read up to {largest} MiB.",
        formats.collect::<String>(),
        names(&row::COLUMNS).join(","),
    )
}

/// The result of all files together.
#[derive(Debug, Default)]
struct Tally {
    worst: Option<Status>,
    bad: bool,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let now = self.time.unwrap_or_else(super::now);
        let recorder = self.record.recorder(io)?;
        let judge = self.by.judge(io)?;
        judge.tell(io);
        judge.tell_rule(io);
        let mut printer = Printer::new(self.format, judge.more(), io)?;
        let mut tally = Tally::default();
        let mut keeping = recorder.map(|recorder| Keeping::new(recorder, io));
        // After an error of the stream nobody reads on, and what is recorded is recorded all the same.
        let mut printed = Ok(());
        super::io::warn_of_repeats(&self.files, io);
        for path in &self.files {
            match files::read(path) {
                Ok(bytes) => {
                    let name = path.file_name().unwrap_or_default().to_string_lossy();
                    let mut rows = Rows::of(path, &judge, keeping.is_some());
                    if let Some(keeping) = &mut keeping {
                        keeping.reads(&name, &bytes);
                    }
                    import_each(&name, &bytes, &sources, now, &mut |item| {
                        warn(path, &item, io);
                        if (printed.is_ok() || keeping.is_some())
                            && let Some(row) = rows.row(item)
                        {
                            tally.count(&row);
                            if let Some(keeping) = &mut keeping {
                                keeping.see(&row);
                            }
                            if printed.is_ok() {
                                printed = printer.row(&row, io);
                            }
                        }
                    });
                }
                Err(error) => {
                    io.fail(&error);
                    let row = Row::of_file(path, error.to_string());
                    tally.count(&row);
                    if printed.is_ok() {
                        printed = printer.row(&row, io);
                    }
                }
            }
        }
        let printed = printed.and_then(|()| printer.end(io));
        if let Some(keeping) = keeping {
            tally.bad |= keeping.end(io)?;
        }
        printed?;
        Ok(match tally.worst {
            _ if tally.bad => Outcome::BadData,
            Some(worst) => Outcome::Judged(worst),
            None => Outcome::Done,
        })
    }
}

/// Warns about the whole file; warnings about a row are beside the row.
fn warn(path: &Path, item: &Item, io: &mut Io<'_>) {
    if let Item::Warning(warning) = item
        && warning.what.row.is_none()
    {
        let line = warning.place.line.unwrap_or(1);
        io.tell(format_args!("{}:{line}: {}", path.display(), said::warning(&warning.what.kind)));
    }
}

impl Tally {
    fn count(&mut self, row: &Row) {
        self.bad |= row.error.is_some();
        self.worst = self.worst.max(row.part_status());
    }
}
