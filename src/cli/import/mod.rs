//! `fitcheck import`: measurements from files, with a verdict for each.

pub(super) mod columns;
mod keeping;
mod print;
mod row;

use std::path::{Path, PathBuf};

use jiff::civil::DateTime;
use keeping::Keeping;
use print::Printed;

use super::admitted::Admits as _;
use super::judging::{Judge, JudgeArgs, SaidArgs};
use super::measured::{Hashing, Measured, unreadable};
use super::parts::{PlanParts, RepeatArgs};
use super::progress::{Watched, Work};
use super::record::RecordArgs;
use super::rows::names;
use super::said::{CliRemark, CliWarning};
use super::{CliError, Format, IntoCliError as _, Io, Outcome, TableArgs, said};
use crate::control::mask::Mask;
use crate::exchange::{Body, ByPlan, FORMATS, ImportInputs, Item, MOST_ROWS, Role, WHOLE, import_from};
use crate::files;
use crate::journal::chain::Hash;
use crate::part::{Plan, Size};
use crate::report::csv::More;
use crate::verdict::Status;
pub(super) use print::Printer;
pub(super) use row::{ImportRow, Rows};

/// Read measurements from files of any known format and judge each
#[derive(Debug, clap::Args)]
#[command(after_help = help())]
pub(super) struct Args {
    /// Files to read; a file that cannot be used is reported, and the next one is read
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,

    /// Format of the verdicts
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Mask (.a) that printed the files with FN 16; can be repeated, and the one that fits is used
    #[arg(long = "mask", value_name = "FILE")]
    masks: Vec<PathBuf>,

    /// What the columns of a CSV hold, by number or name, such as measured=3,callout=Passung; or a .toml file with the same
    #[arg(long, value_name = "LIST|FILE", conflicts_with = "masks")]
    columns: Option<String>,

    /// Show how the columns of the files are read, and import nothing
    #[arg(long, conflicts_with_all = ["masks", "record"])]
    show_columns: bool,

    /// Date and time of measurements whose file has none; default: now
    #[arg(long, value_name = "YYYY-MM-DDTHH:MM")]
    time: Option<DateTime>,

    /// Judge by a part plan: values are matched to features by name, number or location; the plan's limits and rule apply
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
    record: RecordArgs,
}

fn help() -> String {
    let formats = FORMATS.iter().map(|format| {
        let endings: Vec<String> = format.endings.iter().map(|ending| format!(".{ending}")).collect();
        format!("  {:<14}{} ({})\n", format.name, format, endings.join(" "))
    });
    let largest = WHOLE >> 20;
    let roles = Role::all().map(Role::word).collect::<Vec<_>>().join(", ");
    format!(
        "\
Formats, recognised by content:
{}
A CSV needs a column of measured values, and one of callouts, or of nominal sizes with a class or deviations, or of limits. \
A header in English, Dutch, German, Italian, French or Spanish identifies them; without one, their content does. \
The separator is a comma, semicolon, tab or pipe, and the decimal sign a point or comma. \
The header may give a unit: measured [mm], measured_um, Istmaß (inch). \
--columns sets what none of these show: {roles} are columns; separator (semicolon, comma, tab, pipe), decimal (point, comma), unit of sizes and place-unit of x, y and z (mm, um, \
inch), first-row (a line) and sheet (of a workbook) are set in the same way, and - means no column. Give each only once. \
--show-columns shows how the columns would be read; text and JSON also give the TOML that --columns reads.

Columns of --format csv, and names in JSON:
  {}
status is that of the diameter; position is that of the centre, IN or OUT, if the control monitored it. \
The last six show how a value was corrected to 20 °C, here or before; a decision rule and a budget add the same columns as \
in fitcheck report.

Examples:
  fitcheck import bores.csv
  fitcheck import TCHPR421.TXT TCHPR422.TXT --format csv > verdicts.csv
  fitcheck import --tables my_tables --format json measurements.csv
  fitcheck import --plan flange.toml TCHPR421.TXT bores.csv
  fitcheck import --mask fit_list.a fit_list.txt
  fitcheck import --show-columns parts.csv
  fitcheck import --columns measured=3,callout=2,decimal=comma parts.csv
  fitcheck import bores.csv --rule iso14253-2017 --u 1.2 --format csv

The exit code is that of the worst verdict, a centre out of position counting as scrap; \
it is 1 if any row or file could not be used or judged, and 14 (judged, but look first: see fitcheck --help) instead of 0, 10 or 12 \
if something contradicts a verdict. With --plan it is that of the worst part, by the value of \
each feature that counts (the last one by its time; if values contradict each other, the worst one), and 1 if none is worse than good but features of a part have no value. Features without \
a value are named at the end; in CSV and JSON each is a row with the plan as its file, and what contradicts all values of a file \
is a row without a value. \
Files may have any size, but a log of points, a pipe and a .dfx that is read beside its .dfd have up to \
{largest} MiB, and a sheet of a workbook unpacks to at most 512 MiB. \
With --record, up to {MOST_ROWS} rows of a file are read.",
        formats.collect::<String>(),
        names::<Printed<'_>>().into_iter().chain(More::CORRECTED.names().map(str::to_owned)).collect::<Vec<_>>().join(","),
    )
}

/// The result of all files together.
#[derive(Debug, Default)]
struct Tally {
    worst: Option<Status>,
    bad: bool,
    /// How many values wait for hole or shaft.
    open: usize,
    /// The parts of the plan, where there is one: the last value of a size counts.
    parts: Option<PlanParts>,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let masks = self.masks.iter().map(|path| mask(path, io)).collect::<Result<Vec<_>, _>>()?;
        let mapping = self.columns.as_deref().map(columns::mapping).transpose()?;
        if self.show_columns {
            return Ok(columns::show(&self.files, mapping.as_ref(), self.format, io));
        }
        let now = self.time.unwrap_or_else(super::now);
        let recorder = self.record.recorder(io)?;
        let plan = self.plan.as_ref().map(|path| super::plan::read_plan(path, &sources, io)).transpose()?;
        let judge = self.by.judge(io)?.with(&self.said);
        judge.tell(io);
        judge.tell_rule(io);
        let mut import = Import {
            printer: Printer::new(self.format, judge.more_of(plan.as_ref()), io),
            judge: &judge,
            tally: Tally {
                parts: plan.as_ref().map(|plan| PlanParts::of(plan, self.repeats.repeats())),
                ..Tally::default()
            },
            keeping: recorder.map(|recorder| match &plan {
                Some(plan) => Keeping::new(recorder.of_plan(&plan.head.part), io),
                None => Keeping::new(recorder, io),
            }),
            by_plan: plan.as_ref().map(ByPlan::new),
            printed: Ok(()),
            rows: 0,
            is_stopped: false,
        };
        super::io::warn_of_repeats(&self.files, io);
        // What is recorded waits in memory until the end.
        let most_rows = if import.keeping.is_some() { MOST_ROWS } else { usize::MAX };
        for path in &self.files {
            if import.is_stopped {
                break;
            }
            match Measured::open(path) {
                Ok(file) => {
                    let beside = |ending: &str| files::beside(path, ending);
                    let masks = masks.as_slice();
                    let mapping = mapping.as_ref();
                    let has_plan = plan.is_some();
                    let given = ImportInputs {
                        beside: &beside,
                        masks,
                        mapping,
                        most_rows,
                        has_plan,
                        temperature: judge.temperature(),
                        ..ImportInputs::new(&sources, now)
                    };
                    import.file(path, &file, given, io)?;
                }
                Err(error) => {
                    io.fail(&error);
                    import.row(&ImportRow::of_file(path, error.to_string()), io);
                }
            }
        }
        import.end(self.plan.as_deref(), io)
    }
}

/// One import of several files.
struct Import<'a> {
    judge: &'a Judge,
    printer: Printer,
    tally: Tally,
    keeping: Option<Keeping>,
    by_plan: Option<ByPlan<'a>>,
    /// After an error of the stream nobody reads on, and what is recorded is recorded all the same.
    printed: Result<(), CliError>,
    /// How many rows there were so far.
    rows: u64,
    /// Whether Ctrl+C ended it.
    is_stopped: bool,
}

impl Import<'_> {
    fn file(&mut self, path: &Path, file: &Measured, given: ImportInputs<'_>, io: &mut Io<'_>) -> Result<(), CliError> {
        let name = files::name_of(path).to_string_lossy();
        let plan = self.by_plan.as_ref().map(ByPlan::plan);
        let mut rows = Rows::of(path, self.judge, self.keeping.is_some()).by(plan);
        if let Some(keeping) = &mut self.keeping {
            keeping.reads(&name);
        }
        let is_kept = self.keeping.is_some();
        let work = Work::on(&name, file.size());
        io.watch(&work);
        // The plan is asked while its answers are taken.
        let by_plan = self.by_plan.take();
        let mut take_one = |item: Item| {
            // What comes after the wish to stop is what it broke.
            if work.is_stopped() {
                return;
            }
            if item.is_row() {
                work.row();
            }
            warn(path, &item, io);
            // The drive is to be seen to, so it is said beside the row.
            if let Some(error) = unreadable(path, &item) {
                io.fail(&error);
            }
            if let Some(row) = ImportRow::against(path, &item)
                && self.printed.is_ok()
            {
                self.printed = self.printer.against(&row, io);
            }
            if let Some(row) = rows.row(item) {
                if let Some(keeping) = &mut self.keeping {
                    keeping.see(&row);
                }
                self.row(&row, io);
            }
        };
        let mut take = |item: Item| match &by_plan {
            Some(by_plan) => by_plan.item(item, &mut take_one),
            None => take_one(item),
        };
        let hash = file.read(|body| read(&mut Watched::new(body, &work), &name, given, is_kept, &mut take));
        self.by_plan = by_plan;
        self.rows += work.rows();
        self.is_stopped = work.is_stopped();
        if self.is_stopped {
            return Ok(());
        }
        if let (Some(hash), Some(keeping)) = (hash, &mut self.keeping) {
            keeping.has_read(hash.map_err(|error| files::system(path, &error))?);
        }
        Ok(())
    }

    /// Counts a row and prints it.
    fn row(&mut self, row: &ImportRow, io: &mut Io<'_>) {
        self.tally.count(row);
        if row.wants_a_look {
            io.look_first();
        }
        if self.printed.is_ok() {
            self.printed = self.printer.row(row, io);
        }
    }

    /// Says which sizes of which parts have no value: in a sentence, and for machines as rows.
    fn missing(&mut self, plan: &Plan, path: &Path, io: &mut Io<'_>) {
        let Some(parts) = &self.tally.parts else { return };
        parts.tell_contradictions(io);
        let sizes: Vec<Size<'_>> = plan.sizes().collect();
        for (who, walk) in parts.each() {
            let missing: Vec<&Size<'_>> = walk.missing().filter_map(|at| sizes.get(at)).collect();
            if missing.is_empty() {
                continue;
            }
            for size in &missing {
                if self.printed.is_ok() {
                    self.printed = self.printer.row(&ImportRow::missing(path, size, &who), io);
                }
            }
            let names = missing.iter().map(|size| size.name()).collect::<Vec<_>>().join(", ");
            io.warn(&CliWarning::missing(who, names));
        }
        if let (most, true) = parts.count() {
            io.warn(&CliWarning::PlanMoreParts { most });
        }
    }

    fn end(mut self, plan: Option<&Path>, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        // What is missing of a file that was not read to its end is not known.
        if let (Some(by_plan), Some(plan)) = (self.by_plan.take().filter(|_| !self.is_stopped), plan) {
            self.missing(by_plan.plan(), plan, io);
        }
        if self.printed.is_ok() {
            self.printer.end(io);
        }
        // Of a plan's size the plan has said it.
        if 0 < self.tally.open && plan.is_none() {
            io.remark(&CliRemark::Open { count: self.tally.open });
        }
        if self.is_stopped {
            self.printed?;
            if self.keeping.is_some() {
                io.warn(&CliWarning::StoppedUnrecorded);
            }
            return Err(CliError::Stopped { rows: self.rows });
        }
        if let Some(keeping) = self.keeping {
            self.tally.bad |= keeping.end(io)?;
        }
        self.printed?;
        Ok(self.tally.outcome())
    }
}

/// Reads a mask, and gives its name without its folder.
pub(super) fn mask(path: &Path, io: &mut Io<'_>) -> Result<(String, Mask), CliError> {
    let name = files::name_of(path).to_string_lossy();
    let (mask, warnings) = Mask::read(&files::read(path)?).about(&*name)?;
    for warning in &warnings {
        io.warn_about(&*name, warning);
    }
    Ok((name.into_owned(), mask))
}

/// Reads a file; the hash of what was read, where it is wanted.
fn read(
    body: &mut dyn Body,
    name: &str,
    given: ImportInputs<'_>,
    wants_hash: bool,
    take: &mut dyn FnMut(Item),
) -> Option<std::io::Result<Hash>> {
    if !wants_hash {
        import_from(name, body, given, take);
        return None;
    }
    let mut hashing = Hashing::new(body);
    import_from(name, &mut hashing, given, take);
    Some(hashing.end())
}

/// Warns about the whole file; warnings about a row are beside the row, and count with it.
pub(super) fn warn(path: &Path, item: &Item, io: &mut Io<'_>) {
    if let Item::Warning(warning) = item
        && warning.what.row.is_none()
    {
        let line = warning.place.line.unwrap_or(1);
        if warning.what.kind.wants_a_look() {
            io.look_first();
        }
        io.tell(format_args!("{}:{line}: {}", path.display(), said::warning(&warning.what.kind)));
    }
}

impl Tally {
    fn count(&mut self, row: &ImportRow) {
        self.bad |= row.error.is_some();
        self.open += usize::from(row.is_open);
        match (&mut self.parts, &row.judged) {
            (Some(parts), Some(record)) => parts.see(record, &row.labels, row.line),
            _ => self.worst = self.worst.max(row.part_status()),
        }
    }

    fn outcome(&self) -> Outcome {
        match (&self.parts, self.worst) {
            _ if self.bad => Outcome::BadData,
            (Some(parts), worst) => parts.outcome(worst),
            (None, Some(worst)) => Outcome::Judged(worst),
            (None, None) => Outcome::Done,
        }
    }
}
