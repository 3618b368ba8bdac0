//! The outside world: files and dialogs on a named thread of their own, one at a time.
//!
//! The answer comes back as a [`Command`] and asks for one frame. Tests run errands at once, on the frame's thread.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};

use eframe::egui::{Context, ViewportCommand};
use jiff::civil::DateTime;

use crate::control::deviations;
use crate::control::mask::Mask;
use crate::control::probe_table::ProbeTable;
use crate::control::text::decode;
use crate::exchange::{self, contacts, tables::TABLE_FORMATS};
use crate::files;
use crate::message::{Message, Say as _};
use crate::nc::program::ProgramWarning;
use crate::probing::Contact;
use crate::probing::simulated::Simulation;
use crate::report::RENDERINGS;
use crate::session::program::Document;
use crate::session::{
    CheckCommand, Command, CycleFile, CyclesCommand, Effect, ProgramCommand, Purpose, TablesCommand, WorkpieceCommand,
};
use crate::tolerance::{DeviationTable, Sources};

/// How errands are run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Errands {
    /// On a thread: the window stays responsive.
    OnThread,
    /// At once: for tests. File dialogs answer that nothing was picked.
    AtOnce,
}

/// Runs effects and collects their answers.
#[derive(Debug)]
pub(super) struct Runner {
    errands: Errands,
    sender: Sender<Command>,
    receiver: Receiver<Command>,
}

impl Runner {
    pub fn new(errands: Errands) -> Self {
        let (sender, receiver) = channel();
        Self { errands, sender, receiver }
    }

    /// The commands that came back since the last frame.
    pub fn answers(&self) -> Vec<Command> {
        self.receiver.try_iter().collect()
    }

    /// Runs an effect; the frame itself does the clipboard.
    pub fn run(&self, ctx: &Context, effect: Effect, sources: &Arc<Sources>, now: DateTime) {
        let effect = match effect {
            Effect::Copy(text) => return ctx.copy_text(text),
            Effect::Leave => return ctx.send_viewport_cmd(ViewportCommand::Close),
            effect => effect,
        };
        let (sender, ctx, sources) = (self.sender.clone(), ctx.clone(), Arc::clone(sources));
        let errands = self.errands;
        let errand = move || {
            let command = answer(effect, errands, &sources, now);
            // A closed window hears no answer; that is not an error.
            let _closed = sender.send(command);
            ctx.request_repaint();
        };
        match errands {
            Errands::AtOnce => errand(),
            Errands::OnThread => {
                if let Err(error) = std::thread::Builder::new().name("errand".to_owned()).spawn(errand) {
                    log::error!("no thread for files: {error}");
                }
            }
        }
    }
}

fn answer(effect: Effect, errands: Errands, sources: &Sources, now: DateTime) -> Command {
    match effect {
        Effect::Browse(purpose) => Command::Picked((errands == Errands::OnThread).then(|| pick(purpose)).flatten()),
        Effect::Read(purpose, path) => read(purpose, path, sources, now),
        Effect::Save(path, bytes) => {
            let result = files::write(&path, &bytes);
            Command::Saved { path, result }
        }
        Effect::Copy(_) | Effect::Focus(_) | Effect::Leave => Command::Picked(None),
    }
}

fn read(purpose: Purpose, path: PathBuf, sources: &Sources, now: DateTime) -> Command {
    let name = name(&path);
    match purpose {
        Purpose::Import => CheckCommand::Imported { result: import(&path, sources, now), name }.into(),
        Purpose::LoadMask => Command::MaskRead { name, result: read_mask(&path) },
        Purpose::LoadTables => Command::TablesRead { result: read_tables(&path), folder: path },
        Purpose::OpenTable => TablesCommand::Read { name, result: read_table(&path) }.into(),
        Purpose::OpenProgram => ProgramCommand::Read { result: read_program(&path), path }.into(),
        Purpose::OpenCycleFile(CycleFile::Contacts) => {
            WorkpieceCommand::ContactsRead { name, result: read_contacts(&path) }.into()
        }
        Purpose::OpenCycleFile(CycleFile::Workpiece) => WorkpieceCommand::Read(read_workpiece(&path)).into(),
        Purpose::OpenCycleFile(CycleFile::Probes) => {
            CyclesCommand::ProbesRead { name, result: read_probes(&path) }.into()
        }
        // These purposes write files.
        _ => Command::Picked(None),
    }
}

fn name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}

fn import(path: &Path, sources: &Sources, now: DateTime) -> Result<Box<exchange::Imported>, Message> {
    let bytes = files::read(path).map_err(|error| error.message())?;
    Ok(Box::new(exchange::import(&name(path), &bytes, sources, now)))
}

fn read_mask(path: &Path) -> Result<(Box<Mask>, Vec<Message>), Message> {
    let bytes = files::read(path).map_err(|error| error.message())?;
    let (mask, warnings) = Mask::read(&bytes).map_err(|error| error.message())?;
    Ok((Box::new(mask), warnings.iter().map(crate::message::Say::message).collect()))
}

fn read_tables(folder: &Path) -> Result<(Vec<DeviationTable>, Vec<Message>), Message> {
    let own = files::read_tables(folder).map_err(|error| error.message())?;
    let warnings = own.warnings.iter().map(crate::message::Say::message).collect();
    Ok((own.tables, warnings))
}

fn read_table(path: &Path) -> Result<(Box<DeviationTable>, Vec<Message>), Message> {
    let bytes = files::read(path).map_err(|error| error.message())?;
    let (table, warnings) =
        deviations::read_table(&bytes, &name(path), &path.display().to_string(), false).map_err(|e| e.message())?;
    let mut warnings: Vec<_> = warnings.iter().map(crate::message::Say::message).collect();
    match table {
        Some(table) => Ok((Box::new(table), warnings)),
        // The last warning says that the table holds no deviations.
        None => Err(warnings.pop().unwrap_or_else(|| Message::new("tables-nothing-read"))),
    }
}

fn read_program(path: &Path) -> Result<(Box<Document>, Vec<ProgramWarning>), Message> {
    let bytes = files::read(path).map_err(|error| error.message())?;
    let (document, warnings) = Document::read(&name(path), &bytes).map_err(|error| error.message())?;
    Ok((Box::new(document), warnings))
}

fn read_contacts(path: &Path) -> Result<(Vec<Contact>, Vec<Message>), Message> {
    let bytes = files::read(path).map_err(|error| error.message())?;
    let read = contacts::read(&bytes).map_err(|error| error.message())?;
    let ignored = read.ignored.iter().map(|column| Message::new("cycles-column-ignored").text("column", column));
    Ok((read.contacts, ignored.collect()))
}

fn read_workpiece(path: &Path) -> Result<Box<Simulation>, Message> {
    let bytes = files::read(path).map_err(|error| error.message())?;
    Simulation::read(&decode(&bytes)).map(Box::new).map_err(|error| error.message())
}

fn read_probes(path: &Path) -> Result<ProbeTable, Message> {
    let bytes = files::read(path).map_err(|error| error.message())?;
    ProbeTable::read(&bytes, &name(path)).map_err(|error| error.message())
}

/// The system's own dialog. `None` when it was cancelled, or when there is none: the path can still be typed.
fn pick(purpose: Purpose) -> Option<PathBuf> {
    let dialog = rfd::FileDialog::new();
    // Patterns are literal: both cases are listed.
    let both = |endings: &[&str]| -> Vec<String> {
        endings.iter().flat_map(|ending| [ending.to_lowercase(), ending.to_uppercase()]).collect()
    };
    let open = |name: &str, endings: &[&str]| {
        rfd::FileDialog::new().add_filter(name, &both(endings)).add_filter("*", &["*"]).pick_file()
    };
    match purpose {
        Purpose::Import => open("Measurements", &exchange::endings()),
        Purpose::LoadMask => open("Mask", &["a"]),
        Purpose::LoadTables => dialog.pick_folder(),
        Purpose::OpenTable => open("TAB", &["tab"]),
        Purpose::OpenProgram => open("NC", &["h"]),
        Purpose::OpenCycleFile(CycleFile::Contacts) => open("Contacts", &["csv", "txt"]),
        Purpose::OpenCycleFile(CycleFile::Workpiece) => open("TOML", &["toml"]),
        Purpose::OpenCycleFile(CycleFile::Probes) => open("TP", &["tp"]),
        Purpose::SaveWorkpiece => {
            dialog.add_filter("TOML", &both(&["toml"])).set_file_name("workpiece.toml").save_file()
        }
        Purpose::SaveCycleLog => {
            // The endings that the control uses: text, and HTML for cycle 444.
            dialog.add_filter("Log", &both(&["txt", "html"])).save_file()
        }
        Purpose::SaveTable(number) => {
            let format = TABLE_FORMATS.get(number)?;
            dialog.add_filter(format.name, &both(format.endings)).save_file()
        }
        Purpose::ExportStatus => dialog.set_file_name("fitcheck-status.txt").save_file(),
        Purpose::Export(number) => {
            let rendering = RENDERINGS.get(number)?;
            let ending = rendering.endings.first()?;
            let name = format!("fitcheck.{ending}");
            dialog.add_filter(rendering.name, &both(rendering.endings)).set_file_name(name).save_file()
        }
    }
}
