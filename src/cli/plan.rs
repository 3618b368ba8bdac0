//! `fitcheck plan`: part plans checked, begun and brought into another form.

use std::path::{Path, PathBuf};

use jiff::civil::DateTime;
use serde_json::{Value as Json, json};

use super::import::columns;
use super::rows::{csv_line, line, names};
use super::{CliError, CliRemark, ErrorSubject, Figure, Format, IntoCliError as _, Io, Outcome, TableArgs, read_input};
use crate::cli::io::{is_dash, write_new};
use crate::exchange::{self, ImportInputs, Mapping, PLAN_ENDINGS};
use crate::files;
use crate::message::{IntoArg as _, Say as _};
use crate::part::{Column, Document, Draft, DraftFeature, HeadField, Plan, PlanError, PlanFault, PlanFeature, Size};
use crate::tolerance::Sources;

const EXAMPLES: &str = "\
Examples:
  fitcheck plan new flange.toml --part 'Flange 4711' '25 H7' '20 g6'
  fitcheck plan check flange.toml
  fitcheck plan convert plan.csv -o plan.toml

A plan is the list of features of a part, as TOML or CSV; docs/PLANS.md describes all keys. \
Workbooks with the same columns, tables of characteristics with nominal sizes, tolerances or limits, AQDEF (.dfq, .dfd), QIF, \
CALYPSO tables, text reports of PC-DMIS and printouts of probing macros can be read as plans, too. \
plan convert writes what is known, and reports what is missing as faults. \
All faults are reported at once, each with its line.

Exit codes: 0 no faults, 1 a fault or a file that cannot be used, 2 wrong usage.";

/// Check, create and convert part plans
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    #[command(subcommand)]
    what: Todo,
}

#[derive(Debug, clap::Subcommand)]
enum Todo {
    /// Report all faults of a plan, and the limits of its features
    Check(CheckArgs),
    /// Create a plan
    New(BeginArgs),
    /// Write a plan as TOML or as CSV
    Convert(ConvertArgs),
}

#[derive(Debug, clap::Args)]
struct CheckArgs {
    /// Plans; - is standard input
    #[arg(required = true, value_name = "PLAN")]
    files: Vec<PathBuf>,
    /// Format of the answer
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    #[command(flatten)]
    tables: TableArgs,
}

#[derive(Debug, clap::Args)]
struct BeginArgs {
    /// The file to write: .toml or .csv
    #[arg(value_name = "PLAN")]
    file: PathBuf,
    /// The callouts of its features, such as "25 H7"
    #[arg(value_name = "CALLOUT")]
    callouts: Vec<String>,
    /// The part's name or number
    #[arg(long, value_name = "NAME")]
    part: Option<String>,
    /// Overwrite an existing file
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    tables: TableArgs,
}

#[derive(Debug, clap::Args)]
struct ConvertArgs {
    /// The plan; - is standard input
    #[arg(value_name = "PLAN")]
    file: PathBuf,
    /// The file to write: .toml, or .csv for the features only
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Overwrite an existing file
    #[arg(long)]
    force: bool,
    /// What the columns of a table hold, by number or name, such as callout=2,name=Merkmal; or a .toml file with the same
    #[arg(long, value_name = "LIST|FILE")]
    columns: Option<String>,
    #[command(flatten)]
    tables: TableArgs,
}

/// Whether a name is that of a plan's file, or of standard input.
pub(super) fn is_plan_file(path: &Path) -> bool {
    let is_known = |ending: &std::ffi::OsStr| PLAN_ENDINGS.iter().any(|known| ending.eq_ignore_ascii_case(known));
    path.as_os_str() == "-" || path.extension().is_some_and(is_known)
}

/// A plan without a fault; all faults are told, the last one as the error.
pub(super) fn read_plan(path: &Path, sources: &Sources, io: &mut Io<'_>) -> Result<Plan, CliError> {
    read_named(path, sources, io).map(|(_name, plan)| plan)
}

/// The same with the name that it has in messages.
pub(super) fn read_named(path: &Path, sources: &Sources, io: &mut Io<'_>) -> Result<(String, Plan), CliError> {
    let (name, document) = read_document(path, io)?;
    let plan = whole(&document, Some(&name), sources, io)?;
    Ok((name, plan))
}

/// What a document says, or all its faults.
pub(super) fn whole(
    document: &Document,
    name: Option<&str>,
    sources: &Sources,
    io: &mut Io<'_>,
) -> Result<Plan, CliError> {
    let faults = match document.plan(sources) {
        Ok(plan) => return Ok(plan),
        Err(faults) => faults,
    };
    let mut last = None;
    for fault in faults {
        if let Some(before) = last.replace(said(fault, name)) {
            io.fail(before);
        }
    }
    Err(last.unwrap_or_else(|| CliError::Said(PlanFault::NotAPlan.message())))
}

fn said(fault: PlanError, name: Option<&str>) -> CliError {
    match name {
        Some(name) => CliError::About { what: name.arg(), error: fault.message() },
        // What was not in a file was an option.
        None => match fault.what {
            PlanFault::Number { column, error } => {
                let name = column.replace('_', "-");
                CliError::About { what: ErrorSubject::Option { name: &name }.arg(), error: error.message() }
            }
            what => CliError::Said(what.message()),
        },
    }
}

fn read_document(path: &Path, io: &mut Io<'_>) -> Result<(String, Document), CliError> {
    read_mapped(path, None, io)
}

fn read_mapped(path: &Path, mapping: Option<&Mapping>, io: &mut Io<'_>) -> Result<(String, Document), CliError> {
    let (name, bytes) = read_input(path, io)?;
    let document = of_bytes(path, &name, &bytes, mapping).about(&name)?;
    tell_remarks(&document, &name, io);
    Ok((name, document))
}

fn of_bytes(path: &Path, name: &str, bytes: &[u8], mapping: Option<&Mapping>) -> Result<Document, PlanError> {
    let beside = |ending: &str| files::beside(path, ending);
    // Limits of classes are compared with those of the standard; a plan has no times.
    let sources = Sources::default();
    exchange::read_plan(
        name,
        bytes,
        ImportInputs { beside: &beside, mapping, ..ImportInputs::new(&sources, DateTime::MIN) },
    )
}

/// Says what a plan of another tool does not take over.
fn tell_remarks(document: &Document, name: &str, io: &mut Io<'_>) {
    for remark in &document.remarks {
        io.warn_about(name, remark);
    }
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        match &self.what {
            Todo::Check(args) => args.run(io),
            Todo::New(args) => args.run(io),
            Todo::Convert(args) => args.run(io),
        }
    }
}

impl CheckArgs {
    fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let mut has_faults = false;
        let mut is_first = true;
        let mut answers = Vec::new();
        for path in &self.files {
            let (name, read) = match read_input(path, io) {
                Ok((name, bytes)) => {
                    let read = of_bytes(path, &name, &bytes, None).map_err(|error| vec![error]);
                    if let Ok(document) = &read {
                        tell_remarks(document, &name, io);
                    }
                    (name, read.and_then(|document| document.plan(&sources)))
                }
                Err(error) => {
                    io.fail(&error);
                    has_faults = true;
                    continue;
                }
            };
            has_faults |= read.is_err();
            match self.format {
                Format::Json => answers.push(answer(&name, &read)),
                Format::Csv => {
                    if std::mem::take(&mut is_first) {
                        csv_line(names::<PlanRow<'_>>(), io);
                    }
                    csv(&name, &read, io);
                }
                Format::Text => text(&name, &read, io),
            }
        }
        if self.format == Format::Json {
            io.json(&answers);
        }
        Ok(if has_faults { Outcome::BadData } else { Outcome::Done })
    }
}

type ReadPlan = Result<Plan, Vec<PlanError>>;

fn text(name: &str, read: &ReadPlan, io: &mut Io<'_>) {
    let plan = match read {
        Ok(plan) => plan,
        Err(faults) => return faults.iter().for_each(|fault| io.fail(said(fault.clone(), Some(name)))),
    };
    let part = if plan.head.part.is_empty() { name } else { &plan.head.part };
    writeln!(io.people(), "{part}: {}", CliRemark::PlanHas { count: plan.features().len() });
    for size in plan.sizes() {
        let number = &size.feature.number;
        let limits = size.limits;
        let asked = asked(&size);
        let place = size.feature.place.map_or_else(String::new, |[x, y, z]| format!("X{x} Y{y} Z{z}"));
        let limits = format!("{} … {}", limits.minimum(), limits.maximum());
        let line = format!("  {number:>4}  {:<20} {asked:<14} {limits:<22} {place}", size.name());
        writeln!(io.people(), "{}", line.trim_end());
    }
}

row! {
    /// A line of CSV: a size, or a fault.
    #[derive(Default)]
    struct PlanRow<'a> of(file: &'a str, size: &Size<'_>) {
        file: &'a str = file,
        line: Option<usize> = size.feature.line,
        number: String = size.feature.number.clone(),
        name: String = size.name(),
        callout: String = asked(size),
        min_mm: Option<Figure> = Some(Figure::mm(size.limits.minimum(), 3)),
        max_mm: Option<Figure> = Some(Figure::mm(size.limits.maximum(), 3)),
        error: Option<String> = None,
    }
}

/// The callout of a size, or what is asked of it in other words.
fn asked(size: &Size<'_>) -> String {
    size.callout.map_or_else(|| size.feature.kind.asked(), |callout| callout.to_string())
}

fn csv(file: &str, read: &ReadPlan, io: &mut Io<'_>) {
    let mut print = |one: &PlanRow<'_>| io.data().write_all(line(one).end());
    match read {
        Ok(plan) => plan.sizes().for_each(|size| print(&PlanRow::of(file, &size))),
        Err(faults) => {
            for fault in faults {
                let line = fault.place.line;
                let error = Some(fault.what.to_string());
                print(&PlanRow { file, line, error, ..PlanRow::default() });
            }
        }
    }
}

fn answer(name: &str, read: &ReadPlan) -> Json {
    match read {
        Ok(plan) => json!({
            "file": name,
            "part": plan.head.part,
            "features": plan.features().iter().map(FeatureAnswer::of).collect::<Vec<_>>(),
            "errors": [],
        }),
        Err(faults) => {
            let errors = faults.iter().map(|fault| {
                json!({ "line": fault.place.line, "column": fault.place.column, "error": fault.what.to_string() })
            });
            json!({ "file": name, "features": [], "errors": errors.collect::<Vec<_>>() })
        }
    }
}

object! {
    struct FeatureAnswer<'a> of(feature: &'a PlanFeature) {
        line: Option<usize> = feature.line,
        number: &'a str = &feature.number,
        name: &'a str = &feature.name,
        kind: &'static str = feature.kind.word(),
        feature: Option<&'static str> = Some(feature.feature()?.word()),
        sizes: Vec<SizeAnswer> = feature.sizes().map(|size| SizeAnswer::of(&size)).collect(),
        place_mm: Option<[Figure; 3]> = Some(feature.place?.map(|length| Figure::mm(length, 3))),
        cycle: Option<&'static str> = Some(feature.cycle?.code),
        rule: Option<&'static str> = Some(feature.rule?.name().word()),
        material: Option<&'a str> = Some(&feature.material.as_ref()?.name),
        remark: &'a str = &feature.remark,
    }

    struct SizeAnswer of(size: &Size<'_>) {
        name: String = size.name(),
        callout: Option<String> = Some(size.callout?.to_string()),
        min_mm: Figure = Figure::mm(size.limits.minimum(), 3),
        max_mm: Figure = Figure::mm(size.limits.maximum(), 3),
        source: String = size.limits.source.to_string(),
        plausible_mm: Option<[Figure; 2]> = Some([size.plausible?.lower(), size.plausible?.upper()].map(|length| Figure::mm(length, 3))),
    }
}

impl BeginArgs {
    fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let mut draft = Draft::default();
        draft.set(HeadField::Part, self.part.as_ref().map_or_else(String::new, Clone::clone));
        draft.rows =
            self.callouts.iter().map(|callout| DraftFeature::of([(Column::Callout, callout.clone())])).collect();
        // A plan without a feature is the frame of one.
        if draft.rows.is_empty() {
            draft.rows.push(DraftFeature::of([(Column::Callout, "25 H7".to_owned())]));
            io.remark(&CliRemark::PlanExample);
        }
        draft.renumber();
        for (number, row) in (1..).zip(&mut draft.rows) {
            let number: usize = number;
            row.set(Column::Name, format!("F{number}"));
        }
        let document = Document::of(draft);
        whole(&document, None, &sources, io)?;
        save(&document.draft, &self.file, self.force, io)
    }
}

impl ConvertArgs {
    fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let sources = self.tables.load(io)?;
        let mapping = self.columns.as_deref().map(columns::mapping).transpose()?;
        let (name, document) = read_mapped(&self.file, mapping.as_ref(), io)?;
        let faults = document.plan(&sources).err().unwrap_or_else(Vec::new);
        // Nothing can be filled in where there is nothing.
        if document.draft.rows.is_empty() {
            whole(&document, Some(&name), &sources, io)?;
        }
        let written = save(&document.draft, &self.output, self.force, io)?;
        for fault in &faults {
            io.fail(said(fault.clone(), Some(&name)));
        }
        if faults.is_empty() {
            return Ok(written);
        }
        io.remark(&CliRemark::PlanToFill { count: faults.len() });
        Ok(Outcome::BadData)
    }
}

fn save(draft: &Draft, path: &Path, force: bool, io: &mut Io<'_>) -> Result<Outcome, CliError> {
    let is_csv = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("csv"));
    let left = HeadField::ALL.into_iter().filter(|field| draft.text(*field).is_some() && field.column().is_none());
    let keys: Vec<&str> = left.map(HeadField::key).collect();
    if is_csv && !keys.is_empty() {
        io.remark(&CliRemark::PlanHeadLeft { keys: keys.join(", ") });
    }
    let text = if is_csv { draft.to_csv() } else { draft.to_toml() };
    if is_dash(path) {
        io.data().write_all(text.as_bytes());
        return Ok(Outcome::Done);
    }
    write_new(path, text.as_bytes(), force)?;
    io.note(CliRemark::Wrote { path: path.display().to_string() });
    Ok(Outcome::Done)
}
