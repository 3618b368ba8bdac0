//! What a file holds, as the command that takes it: read whole, and refused with its reason.

use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::civil::DateTime;

use super::file_contents::{FileContents, With, bytes_of, name, whole};
use super::measurements;
use super::working::{Job, Watched};
use crate::control::deviations;
use crate::control::mask::Mask;
use crate::control::probe_table::ProbeTable;
use crate::control::tool_table::ToolTable;
use crate::exchange::contacts::{self, Contacts};
use crate::exchange::{self, ImportInputs};
use crate::journal::chain::Hash;
use crate::message::{Message, OwnTexts, Say as _, message};
use crate::nc::program::ProgramWarning;
use crate::probing::simulated::{Part, Simulation};
use crate::report::changes::EarlierReport;
use crate::report::pairing::PairingParts;
use crate::session::parts::{PlanCommand, WalkCommand};
use crate::session::program::Document;
use crate::session::statistics::StudyCommand;
use crate::session::{
    BothSizes, BudgetCommand, CheckCommand, ColumnsCommand, Command, CycleFile, CyclesCommand, ImportInto,
    PairingCommand, PartsCommand, ProgramCommand, Purpose, ReportsCommand, RowsCommand, StatisticsCommand,
    TablesCommand, ToolsCommand, WorkpieceCommand, usable,
};
use crate::text::decode;
use crate::tolerance::fit::thermal::Temperature;
use crate::tolerance::{DeviationTable, Feature, Sources};
use crate::{files, part, proof};

/// Whether an answer brings what a file holds.
pub(super) const fn is_read(command: &Command) -> bool {
    match command {
        Command::Check(CheckCommand::Imported { result, .. }) => result.is_ok(),
        Command::Check(CheckCommand::Rows(RowsCommand::Opened { result, .. })) => result.is_ok(),
        Command::MaskRead { result, .. } => result.is_ok(),
        Command::TablesRead { result, .. } => result.is_ok(),
        Command::TextsRead { result, .. } => result.is_ok(),
        Command::Tables(TablesCommand::Read { result, .. }) => result.is_ok(),
        Command::Program(ProgramCommand::Read { result, .. }) => result.is_ok(),
        Command::Workpiece(WorkpieceCommand::ContactsRead { result, .. }) => result.is_ok(),
        Command::Workpiece(WorkpieceCommand::Read(result)) => result.is_ok(),
        Command::Workpiece(WorkpieceCommand::PartRead { result, .. }) => result.is_ok(),
        Command::Cycles(CyclesCommand::ProbesRead { result, .. }) => result.is_ok(),
        Command::Tools(ToolsCommand::Read { result, .. }) => result.is_ok(),
        Command::SettingsRead { result, .. }
        | Command::Budget(BudgetCommand::Read { result, .. } | BudgetCommand::UsedRead { result, .. }) => {
            result.is_ok()
        }
        Command::Budget(BudgetCommand::ReadingsRead { result, .. }) => result.is_ok(),
        Command::Parts(PartsCommand::Plan(PlanCommand::Read { result, .. })) => result.is_ok(),
        // A picture's name is taken now, and its dots are read afterwards; of measurements the columns are asked for first.
        Command::Parts(PartsCommand::Plan(PlanCommand::ChoosePicture(_)))
        | Command::Columns(ColumnsCommand::Ask(_)) => true,
        Command::Parts(PartsCommand::Walk(WalkCommand::Imported { result, .. })) => result.is_ok(),
        Command::Parts(PartsCommand::Walk(WalkCommand::Watch { is_folder, .. })) => *is_folder,
        Command::Pairing(PairingCommand::Read { result, .. }) => result.is_ok(),
        Command::Statistics(StatisticsCommand::Study(StudyCommand::Read { result, .. })) => result.is_ok(),
        Command::Reports(ReportsCommand::Earlier { result, .. }) => result.is_ok(),
        _ => false,
    }
}

/// Reads what a dialog of this purpose asks for.
pub(super) fn read(purpose: Purpose, path: PathBuf, with: With<'_>) -> FileContents {
    let name = name(&path);
    let mut seen = None;
    let command = match purpose {
        Purpose::Import => return measurements::read(ImportInto::History, path, None, with),
        Purpose::ImportValues(run) => return measurements::read(ImportInto::Part(run), path, None, with),
        Purpose::OpenStudy => return measurements::read(ImportInto::Study, path, None, with),
        Purpose::AskColumns(into) => return measurements::ask(into, path, with),
        Purpose::LoadMask => Command::MaskRead { result: read_mask(&path), path },
        Purpose::ImportSettings => Command::SettingsRead { result: read_settings(&path), path },
        Purpose::LoadTexts => Command::TextsRead { result: read_texts(&path), path },
        Purpose::LoadTables => Command::TablesRead { result: read_tables(&path), folder: path },
        Purpose::OpenTable => TablesCommand::Read { name, result: read_table(&path) }.into(),
        Purpose::OpenProgram => ProgramCommand::Read { result: read_program(&path, &mut seen), path }.into(),
        Purpose::OpenCycleFile(CycleFile::Contacts) => {
            WorkpieceCommand::ContactsRead { name, result: read_contacts(&path, &mut seen) }.into()
        }
        Purpose::OpenCycleFile(CycleFile::Workpiece) | Purpose::OpenPart => {
            read_workpiece(&path, name, &mut seen).into()
        }
        Purpose::OpenCycleFile(CycleFile::Probes) => {
            CyclesCommand::ProbesRead { name, result: read_probes(&path) }.into()
        }
        Purpose::OpenTools => ToolsCommand::Read { name, result: read_tools(&path) }.into(),
        Purpose::OpenBudget => BudgetCommand::Read { result: read_text(&path, &mut seen), path }.into(),
        Purpose::UseBudget => BudgetCommand::UsedRead { result: read_text(&path, &mut seen), path }.into(),
        Purpose::OpenPlan => PartsCommand::Plan(PlanCommand::Read { result: read_plan(&path, &mut seen), path }).into(),
        Purpose::CompareReport => ReportsCommand::Earlier { result: read_earlier(&path), name }.into(),
        Purpose::OpenPicture => PartsCommand::Plan(PlanCommand::ChoosePicture(path)).into(),
        Purpose::WatchFolder => WalkCommand::Watch { is_folder: path.is_dir(), folder: path }.into(),
        Purpose::OpenReadings => BudgetCommand::ReadingsRead { result: read_readings(&path), name }.into(),
        Purpose::OpenParts(feature) => PairingCommand::Read {
            feature,
            result: read_parts(&path, &name, feature, &(with.begins)(&path, false)),
            path,
        }
        .into(),
        // These purposes write files.
        _ => Command::Picked(None),
    };
    FileContents { before: None, command, sha256: seen }
}

fn read_plan(path: &Path, seen: &mut Option<Hash>) -> Result<Box<part::Document>, Message> {
    let bytes = bytes_of(path, seen)?;
    let beside = |ending: &str| files::beside(path, ending);
    let sources = Sources::default();
    let given = ImportInputs { beside: &beside, ..ImportInputs::new(&sources, DateTime::MIN) };
    exchange::read_plan(&name(path), &bytes, given).map(Box::new).map_err(|error| error.message())
}

fn read_mask(path: &Path) -> Result<(Box<Mask>, Vec<Message>), Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    let (mask, warnings) = Mask::read(&bytes).map_err(|error| error.message())?;
    Ok((Box::new(mask), warnings.iter().map(crate::message::Say::message).collect()))
}

fn read_earlier(path: &Path) -> Result<Arc<EarlierReport>, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    proof::earlier_report(&bytes).map(Arc::new)
}

fn read_texts(path: &Path) -> Result<Arc<OwnTexts>, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    OwnTexts::read(&name(path), &bytes).map(Arc::new).map_err(|error| error.message())
}

fn read_settings(path: &Path) -> Result<String, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    Ok(decode(&bytes).into_owned())
}

fn read_tables(folder: &Path) -> Result<(Vec<DeviationTable>, Vec<Message>), Message> {
    let own = crate::store::tables::read_tables(folder).map_err(|error| error.message())?;
    let warnings = own.warnings.iter().map(crate::message::Say::message).collect();
    Ok((own.tables, warnings))
}

fn read_table(path: &Path) -> Result<(Box<DeviationTable>, Vec<Message>), Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    let (table, warnings) =
        deviations::read_table(&bytes, &name(path), &path.display().to_string(), false).map_err(|e| e.message())?;
    let mut warnings: Vec<_> = warnings.iter().map(crate::message::Say::message).collect();
    match table {
        Some(table) => Ok((Box::new(table), warnings)),
        // The last warning says that the table holds no deviations.
        None => Err(warnings.pop().unwrap_or_else(|| message!("tables-nothing-read"))),
    }
}

fn read_program(path: &Path, seen: &mut Option<Hash>) -> Result<(Box<Document>, Vec<ProgramWarning>), Message> {
    files::no_half_set(path.parent().unwrap_or(path)).map_err(|error| error.message())?;
    let bytes = bytes_of(path, seen)?;
    let (document, warnings) = Document::read(&name(path), &bytes).map_err(|error| error.message())?;
    Ok((Box::new(document), warnings))
}

fn read_contacts(path: &Path, seen: &mut Option<Hash>) -> Result<(Contacts, Vec<Message>), Message> {
    let bytes = bytes_of(path, seen)?;
    let read = contacts::read(&bytes).map_err(|error| error.message())?;
    let ignored = read.ignored.iter().map(|column| message!("cycles-column-ignored").text("column", column));
    let warm = read.told_of_temperature(Temperature::REFERENCE).map(|told| told.message());
    let told = ignored.chain(warm).collect();
    Ok((read, told))
}

/// A workpiece with one surface, or a part of several features: its file says which.
fn read_workpiece(path: &Path, name: String, seen: &mut Option<Hash>) -> WorkpieceCommand {
    let bytes = match bytes_of(path, seen) {
        Ok(bytes) => bytes,
        Err(problem) => return WorkpieceCommand::Read(Err(problem)),
    };
    let text = decode(&bytes);
    if !Part::is_file(&text) {
        return WorkpieceCommand::Read(Simulation::read(&text).map(Box::new).map_err(|error| error.message()));
    }
    let result = Part::read(&text).map_err(|error| error.message());
    // Impossible figures are said now, and not in the middle of a run.
    let result = result.and_then(|part| part.machine().map(|_| Box::new(part)).map_err(|error| error.message()));
    WorkpieceCommand::PartRead { name, result }
}

fn read_text(path: &Path, seen: &mut Option<Hash>) -> Result<String, Message> {
    let bytes = bytes_of(path, seen)?;
    Ok(decode(&bytes).into_owned())
}

fn read_readings(path: &Path) -> Result<Box<BothSizes>, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    Ok(Box::new(BothSizes::read(&name(path), &bytes)))
}

fn read_parts(path: &Path, name: &str, feature: Feature, job: &Job) -> Result<Arc<PairingParts>, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    job.has(bytes.len());
    let mut body = Cursor::new(bytes);
    let sizes = exchange::sizes_from(name, &mut Watched::new(&mut body, job), feature, &mut || job.row());
    usable(name, PairingParts::of_file(name, whole(sizes, job)?))
}

fn read_tools(path: &Path) -> Result<Box<ToolTable>, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    ToolTable::read(&bytes, &name(path)).map(Box::new).map_err(|error| error.message())
}

fn read_probes(path: &Path) -> Result<ProbeTable, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    ProbeTable::read(&bytes, &name(path)).map_err(|error| error.message())
}
