//! `fitcheck run`: an NC program on a simulated workpiece or on recorded contacts.
//!
//! | file | what |
//! |---|---|
//! | `text` | windows, trace and notes, for people |
//! | `answer` | everything, for programs |

mod answer;
mod text;

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::text::long;

use super::args::{dialogue, text_or_json};
use super::cycle::{Source, SourceArgs, pairs, probe_table};
use super::io::not_dash;
use super::record::{RecordArgs, Recorder};
use super::tools::ToolArgs;
use super::{CliError, ErrorSubject, Format, IntoCliError as _, Io, Outcome, now, read_input};
use crate::control::variables::{Parameter, Value};
use crate::files::{self, FileError};
use crate::journal::entry::{CycleCheck, FileRole};
use crate::nc::machine::{Contacts, Fault, Machine, NcPath, Pause, Settings, Shipped, Step};
use crate::nc::program::{Program, ProgramWarning};
use crate::store::programs::Folders;
use crate::words::Dialogue;

/// How much of a block's text is shown, in characters: a control's line has some 250.
const LONGEST_TEXT: usize = 1_000;

const EXAMPLES: &str = "\
Examples:
  fitcheck run 8255_nl.h --set Q1=25 QS1=H7 --workpiece bore.toml     the built-in program on a bore
  fitcheck run part.h --trace                                        every block and what it changes
  fitcheck run part.h --folder tables --output-folder results --format json

A value of --set replaces the main program's own first assignment to that parameter.
Fitcheck looks for TNC:\\fit\\a.tab as fit/a.tab and as a.tab: in the output folder, in the
program's own folder, in the folders of --folder in their order, and then among the built-in files.
Files that FN 16 prints go below the output folder and nowhere else; it is created if missing, and
without one they are not written. STOP and M0 do not wait. Without --workpiece and --contacts, every
cycle measures a perfect workpiece at nominal. fitcheck cycle --help describes a workpiece file. As
on a control, the limits alone decide: no decision rule, uncertainty or temperature.

With --tools, cycles with Q330 correct DR or DL of that tool for the rest of the run; a broken
tool is locked (TL), and the run stops. --tools-out writes the changed table, also after a fault.

Text: the windows on standard output, notes on standard error. JSON: blocks, status, source, parameters,
files, windows, outputs, cycles, tool changes, pauses, remarks, faults, trace.

Exit codes: 0 good or nothing judged, 10 rework, 11 scrap, 12 re-measure,
14 judged, but look first (see fitcheck --help), 1 a fault or bad data, 2 wrong usage.";

const CONTACTS: &str = "Recorded contacts for all cycles in probing order: x, y, z in mm, points of the surface";

/// Run an NC program as a control does, within limits
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
#[command(mut_arg("contacts", |arg| arg.help(CONTACTS)))]
#[expect(clippy::struct_excessive_bools, reason = "each is a switch of the command line")]
pub(super) struct Args {
    /// The program, or the name of a built-in one; - reads standard input
    #[arg(value_name = "PROGRAM.h")]
    program: PathBuf,
    /// Parameters to set before the run, such as Q1=25 or QS1=H7
    #[arg(long = "set", value_name = "NAME=VALUE", num_args = 1..)]
    settings: Vec<String>,
    #[command(flatten)]
    from: SourceArgs,
    /// Folder with programs, tables and masks, besides the program's own
    #[arg(long = "folder", value_name = "FOLDER")]
    folders: Vec<PathBuf>,
    /// Use no built-in programs, tables and masks in place of missing files
    #[arg(long)]
    no_builtin: bool,
    /// Folder for the files that FN 16 and FN 27 write
    #[arg(long, value_name = "FOLDER")]
    output_folder: Option<PathBuf>,
    /// Touch-probe table of a control, instead of the built-in one
    #[arg(long, value_name = "FILE.tp")]
    probe_table: Option<PathBuf>,
    #[command(flatten)]
    record: RecordArgs,
    #[command(flatten)]
    tools: ToolArgs,
    /// Skip unknown blocks instead of stopping; what they may have set is undefined from there on
    #[arg(long)]
    skip_unknown: bool,
    /// If no TOOL CALL comes before a cycle, measure along Z with the first probe instead of stopping
    #[arg(long)]
    assume_tool: bool,
    /// Skip blocks with a / before them
    #[arg(long)]
    block_skip: bool,
    /// List every block with the values that it changes, and the origin of every file
    #[arg(long)]
    trace: bool,
    /// Run at most N blocks
    #[arg(long, value_name = "N", default_value_t = 10_000_000)]
    max_blocks: u64,
    /// Dialogue language of masks and notes
    #[arg(long, default_value = "en", value_parser = dialogue())]
    language: Dialogue,
    /// Format of the result
    #[arg(long, default_value = "text", value_parser = text_or_json())]
    format: Format,
}

/// The result of a run besides what the machine remembers.
#[derive(Default)]
struct Ended {
    pauses: Vec<Pause>,
    fault: Option<Fault>,
    /// What the reader of the program had to say.
    warnings: Vec<String>,
    /// Where the changed tool table was written to.
    tools_out: Option<String>,
}

/// A listener to every block.
trait Listener {
    /// Before a block.
    fn before(&mut self, machine: &Machine);
    /// After it, also where it failed.
    fn after(&mut self, machine: &Machine, io: &mut Io<'_>);
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let language = self.language;
        let recorder = self.record.recorder(io)?;
        let source = self.from.read(io)?;
        if let Source::Workpiece { file, part } = &source {
            // Impossible figures are reported now, with the file's name, and not in the middle of the run.
            part.machine().about(file)?;
        }
        let (mut machine, warnings) = self.machine(&source, io)?;
        let mut names = BTreeSet::new();
        for (name, value) in pairs(&self.settings)? {
            if !names.insert(set(&mut machine, name, value)?) {
                return Err(CliError::SetTwice { name: name.to_owned() });
            }
        }
        let ended = self.run_and_print(&mut machine, &warnings, &source, io);
        // What was measured before a fault was measured, whoever reads what is printed.
        let recorded = recorder.map_or(Ok(()), |recorder| keep(recorder, &machine, &source, io));
        let ended = match ended {
            Ok(ended) => ended,
            Err(unprinted) => {
                recorded.unwrap_or_else(|unrecorded| io.fail(unrecorded));
                return Err(unprinted);
            }
        };
        if let Some(fault) = ended.fault {
            text::tell_fault(&fault, language.language(), io);
            recorded?;
            return Ok(Outcome::BadData);
        }
        recorded?;
        if machine.remarks_stand_against() {
            io.look_first();
        }
        Ok(machine.status().map_or(Outcome::Done, Outcome::Judged))
    }

    /// Runs it, and prints what is to be said of it.
    fn run_and_print(
        &self,
        machine: &mut Machine,
        warnings: &[ProgramWarning],
        source: &Source,
        io: &mut Io<'_>,
    ) -> Result<Ended, CliError> {
        let language = self.language;
        if self.format == Format::Text {
            let mut listener = text::Printer::new(self.trace);
            let ended = run(machine, &mut listener, io);
            text::notes(machine, &ended, self.trace, language.language(), io);
            text::tell_source(machine, source, io);
            self.tools.write(machine.tool_table(), !machine.tool_changes().is_empty(), io)?;
            return Ok(ended);
        }
        let mut listener = answer::Trace::new(self.trace);
        let mut ended = run(machine, &mut listener, io);
        ended.warnings = warnings.iter().map(ToString::to_string).collect();
        // Before the answer, which says whether the table is written; an error comes after it.
        let written = self.tools.write(machine.tool_table(), !machine.tool_changes().is_empty(), io);
        ended.tools_out = written.as_ref().ok().cloned().flatten();
        io.json(&answer::Answer { machine, ended: &ended, source, trace: &listener });
        written.map(|_written| ended)
    }

    /// The machine, and what the reader of the program has to say.
    fn machine(&self, source: &Source, io: &mut Io<'_>) -> Result<(Machine, Vec<ProgramWarning>), CliError> {
        let (name, bytes, beside) = self.read_program(io)?;
        io.used(FileRole::Program, &name, &bytes);
        let (program, warnings) = Program::read(&bytes).about(&name)?;
        for warning in &warnings {
            io.warn_about(&name, warning);
        }
        let mut store = self.folders.iter().fold(beside, Folders::reading);
        if self.no_builtin {
            store = store.without_built_in();
        }
        for folder in &self.folders {
            if !folder.is_dir() {
                return Err(CliError::NoFolder { path: folder.clone() });
            }
            files::no_half_set(folder)?;
        }
        if let Some(folder) = &self.output_folder {
            not_dash(folder)?;
            files::make_folder(folder)?;
            store = store.writing(folder);
        }
        let mut settings = Settings::new(self.language, now());
        settings.budget.blocks = self.max_blocks;
        settings.skip_unknown = self.skip_unknown;
        settings.assumes_tool = self.assume_tool;
        settings.block_skip = self.block_skip;
        settings.probe_table = probe_table(self.probe_table.as_deref(), io)?;
        settings.tool_table = self.tools.read(io)?;
        let contacts = contacts_of(source);
        Ok((Machine::new(&name, Arc::new(program), store, contacts, settings), warnings))
    }

    /// The program's name, its bytes and its folder; a built-in program where there is no such file.
    fn read_program(&self, io: &mut Io<'_>) -> Result<(String, Vec<u8>, Folders), CliError> {
        let is_missing = !self.no_builtin && !self.program.exists();
        let embedded = self.program.to_str().filter(|_| is_missing).and_then(Shipped::file);
        if let Some(bytes) = embedded {
            return Ok((self.program.display().to_string(), bytes.to_vec(), Folders::new()));
        }
        let is_bare = self.program.parent().is_some_and(|folder| folder.as_os_str().is_empty());
        let (name, bytes) = read_input(&self.program, io).map_err(|error| match error {
            CliError::File(error @ FileError::Missing { .. }) if is_bare => {
                // The programs of NC-Solution 8255 first.
                let mut programs: Vec<_> = Shipped::main_programs().collect();
                programs.sort_by_key(|(dialogue, _)| *dialogue != Dialogue::Nl);
                let names: Vec<&str> = programs.into_iter().map(|(_, name)| name).collect();
                CliError::NoProgram { error, names: names.join(", ") }
            }
            error => error,
        })?;
        let is_file = self.program.as_os_str() != "-";
        if is_file {
            files::no_half_set(self.program.parent().unwrap_or(Path::new("")))?;
        }
        Ok((name, bytes, if is_file { Folders::beside(&self.program) } else { Folders::new() }))
    }
}

/// What the machine probes.
fn contacts_of(source: &Source) -> Contacts {
    match source {
        Source::Perfect => Contacts::Perfect,
        Source::Workpiece { part, .. } => Contacts::Workpiece(part.clone()),
        Source::Contacts { contacts, has_heights, .. } => Contacts::of_file(contacts.clone(), *has_heights),
    }
}

/// Sets a parameter and returns it.
fn set(machine: &mut Machine, name: &str, value: &str) -> Result<Parameter, CliError> {
    let what = ErrorSubject::Set { name, value };
    let parameter: Parameter = name.parse().about(&what)?;
    let value = if parameter.family.is_text() {
        Value::Text(value.to_owned())
    } else {
        let plain = value.trim().replace(',', ".");
        let is_decimal = plain.bytes().all(|byte| byte.is_ascii_digit() || b"+-.".contains(&byte));
        let number = plain.parse().ok().filter(|_| is_decimal);
        Value::Number(number.ok_or(CliError::NotANumber).about(&what)?)
    };
    machine.set(parameter, value).about(&what)?;
    Ok(parameter)
}

/// Runs to the end or to a fault; pauses are remembered and skipped.
fn run(machine: &mut Machine, listener: &mut dyn Listener, io: &mut Io<'_>) -> Ended {
    let mut ended = Ended::default();
    loop {
        listener.before(machine);
        let step = machine.step();
        listener.after(machine, io);
        match step {
            Ok(Step::Went) => {}
            Ok(Step::Ended) => return ended,
            Ok(Step::Paused(pause)) => {
                /// The most pauses that are kept: enough for a program that pauses in a loop.
                const MOST: usize = 1_000;
                if ended.pauses.len() < MOST {
                    ended.pauses.push(pause);
                }
            }
            Err(fault) => {
                ended.fault = Some(fault);
                return ended;
            }
        }
    }
}

/// Records every cycle of a run that judged.
fn keep(mut recorder: Recorder, machine: &Machine, source: &Source, io: &mut Io<'_>) -> Result<(), CliError> {
    for run in machine.cycles().iter().filter(|run| run.result.verdict().is_some()) {
        let (file, line) = place(machine, &run.place.program, run.place.block);
        let line = long(line);
        let check = CycleCheck::of_run(run, source.origin());
        recorder.cycle(CycleCheck { block: Some((file, line)), ..check }, io.files())?;
    }
    recorder.keep(io)
}

/// File name and line of a block, `8255_nl.h:4`.
fn place(machine: &Machine, program: &NcPath, block: usize) -> (String, usize) {
    let line = machine
        .program(program)
        .and_then(|program| program.blocks().get(block))
        .map_or(0, |block| block.lines.start + 1);
    (program.file_name().to_owned(), line)
}
