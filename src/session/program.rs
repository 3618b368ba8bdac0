//! The program page: an NC program is read, run, stepped and watched.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `command` | what can be done |
//! | `document` | a program as it is shown: outline, names of parameters, the selected block |
//! | `tokens` | what a line is made of, so that it can be told apart |
//! | `inputs` | the seven inputs of 8255 as fields, and Fitcheck's own answer |
//! | `run` | a run: the machine, slice by slice |
//! | `running` | run, pause, single block, to the selected block |
//! | `watching` | parameters with their names, changes and values given beforehand |
//! | `opening` | programs from files, and what is typed |
//! | `workpiece` | what is measured |
//! | `problems` | what is wrong, block by block |
//!
//! A run belongs to its inputs: any change of an input clears it. Nothing is written; what a program prints to files is
//! listed.

mod command;
mod document;
mod inputs;
mod opening;
mod problems;
mod run;
mod running;
mod tokens;
mod watching;
mod workpiece;

use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

use jiff::civil::DateTime;

pub use command::{BlockStep, Origin, ProgramCommand, ProgramField, Switch, WorkpieceFrom};
pub use document::{Document, Entry, EntryKind};
pub use inputs::{Agreement, Input};
pub use problems::{Problem, ProblemKind};
pub use run::{MOST_MOVES, Run, Speed, State};
pub use tokens::{Token, tokens};
pub use watching::{Name, Watched};

use super::{Effect, Session};
use crate::control::variables::{Parameter, Value};
use crate::message::Message;
use crate::nc::machine::{BlockPlace, NcPath};
use crate::nc::program::ProgramWarning;

/// The state of the program page.
#[derive(Debug, Default)]
pub struct ProgramPage {
    origin: Option<Origin>,
    /// Files that were opened, newest first.
    recent: Vec<PathBuf>,
    main: Option<NcPath>,
    shown: Option<NcPath>,
    documents: BTreeMap<NcPath, Document>,
    /// What reading the open program remarked.
    warnings: Vec<ProgramWarning>,
    texts: BTreeMap<ProgramField, String>,
    errors: BTreeMap<ProgramField, Message>,
    workpiece: WorkpieceFrom,
    /// Values that were given beforehand.
    given: BTreeMap<Parameter, Value>,
    pinned: BTreeSet<Parameter>,
    breakpoints: BTreeSet<BlockPlace>,
    switches: Switches,
    speed: Speed,
    run: Option<Run>,
    /// Why a run could not begin.
    refused: Option<Message>,
    /// Counts every time that a block has to come into sight.
    looks: u64,
    /// The line that has to.
    look: usize,
}

/// What is switched on.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
struct Switches {
    skip_unknown: bool,
    block_skip: bool,
    optional_stop: bool,
}

/// How many blocks a page is.
const PAGE: usize = 20;

impl ProgramPage {
    /// Where the open program came from; `None` before the page was opened for the first time.
    pub const fn origin(&self) -> Option<&Origin> {
        self.origin.as_ref()
    }

    /// Files that were opened, newest first.
    pub fn recent(&self) -> &[PathBuf] {
        &self.recent
    }

    /// The open program.
    pub fn main(&self) -> Option<&Document> {
        self.main.as_ref().and_then(|path| self.documents.get(path))
    }

    /// The shown program: the open one, or one that it calls.
    pub fn shown(&self) -> Option<&Document> {
        self.shown.as_ref().and_then(|path| self.documents.get(path))
    }

    fn shown_mut(&mut self) -> Option<&mut Document> {
        self.shown.as_ref().and_then(|path| self.documents.get_mut(path))
    }

    /// The text of a field.
    pub fn text(&self, field: ProgramField) -> &str {
        self.texts.get(&field).map_or("", String::as_str)
    }

    /// What is wrong with a field.
    pub fn error(&self, field: ProgramField) -> Option<&Message> {
        self.errors.get(&field)
    }

    /// What is measured.
    pub const fn workpiece(&self) -> WorkpieceFrom {
        self.workpiece
    }

    /// How fast a run goes.
    pub const fn speed(&self) -> Speed {
        self.speed
    }

    /// Whether something is switched on.
    pub const fn is_on(&self, switch: Switch) -> bool {
        match switch {
            Switch::SkipUnknown => self.switches.skip_unknown,
            Switch::BlockSkip => self.switches.block_skip,
            Switch::OptionalStop => self.switches.optional_stop,
        }
    }

    /// Whether a block of the shown program has a breakpoint.
    pub fn has_breakpoint(&self, block: usize) -> bool {
        let Some(program) = &self.shown else { return false };
        // Almost always there is none at all.
        !self.breakpoints.is_empty() && self.breakpoints.contains(&BlockPlace { program: program.clone(), block })
    }

    /// The run, once it began.
    pub const fn run(&self) -> Option<&Run> {
        self.run.as_ref()
    }

    /// A number that changes when a line has to come into sight, and that line of the shown program.
    pub const fn look(&self) -> (u64, usize) {
        (self.looks, self.look)
    }

    /// Takes a program of the run among those that can be shown.
    fn know(&mut self, path: &NcPath) {
        let known = self.documents.contains_key(path);
        if !known && let Some(program) = self.run.as_ref().and_then(|run| run.program(path)) {
            self.documents.insert(path.clone(), Document::new(path.clone(), program));
        }
    }

    /// Shows a block of a program that is known.
    fn look_at(&mut self, place: &BlockPlace, select: bool) {
        self.know(&place.program);
        let Some(document) = self.documents.get_mut(&place.program) else { return };
        if select {
            document.select(place.block);
        }
        self.look = document.first_line(place.block);
        self.looks = self.looks.wrapping_add(1);
        self.shown = Some(place.program.clone());
    }
}

impl Session {
    /// The program page.
    pub const fn program(&self) -> &ProgramPage {
        &self.program
    }

    pub(super) fn apply_program(&mut self, command: ProgramCommand, now: DateTime) -> Vec<Effect> {
        match command {
            ProgramCommand::OpenShipped(name) => self.open_shipped(name),
            ProgramCommand::Read { path, result } => self.program_read(path, result),
            ProgramCommand::Type(field, text) => self.type_program_field(field, text),
            ProgramCommand::ChooseWorkpiece(from) => self.choose_workpiece(from),
            ProgramCommand::Run => self.start_or_go_on(now, running::Mode::Running),
            ProgramCommand::Step => self.step_program(now),
            ProgramCommand::StepOver => self.start_or_go_on(now, running::Mode::Over),
            ProgramCommand::RunToSelected => self.start_or_go_on(now, running::Mode::ToSelected),
            ProgramCommand::Tick => self.tick_program(),
            ProgramCommand::Pause => self.pause_program(),
            ProgramCommand::Reset => self.reset_program(),
            ProgramCommand::SetSpeed(speed) => self.program.speed = speed,
            ProgramCommand::Switch(switch, on) => self.switch_program(switch, on),
            ProgramCommand::ToggleBreakpoint(block) => self.toggle_breakpoint(block),
            ProgramCommand::Select(block) => {
                if let Some(document) = self.program.shown_mut() {
                    document.select(block);
                }
            }
            ProgramCommand::Move(step) => self.move_in_program(step),
            ProgramCommand::ShowProgram(path) => self.show_program(path),
            ProgramCommand::GoTo(place) => self.program.look_at(&place, true),
            ProgramCommand::Pin(parameter, true) => _ = self.program.pinned.insert(parameter),
            ProgramCommand::Pin(parameter, false) => _ = self.program.pinned.remove(&parameter),
            ProgramCommand::SetValue => self.give_value(),
            ProgramCommand::DropValue(parameter) => {
                self.program.given.remove(&parameter);
                self.reset_program();
            }
        }
        Vec::new()
    }

    fn switch_program(&mut self, switch: Switch, on: bool) {
        let switches = &mut self.program.switches;
        match switch {
            Switch::SkipUnknown => switches.skip_unknown = on,
            Switch::BlockSkip => switches.block_skip = on,
            Switch::OptionalStop => switches.optional_stop = on,
        }
        self.reset_program();
    }

    fn toggle_breakpoint(&mut self, block: Option<usize>) {
        let Some(document) = self.program.shown() else { return };
        let block = block.unwrap_or_else(|| document.selected());
        if document.program().blocks().len() <= block {
            return;
        }
        let place = BlockPlace { program: document.path().clone(), block };
        if !self.program.breakpoints.remove(&place) {
            self.program.breakpoints.insert(place.clone());
        }
        if let Some(run) = &mut self.program.run {
            run.toggle_breakpoint(&place);
        }
    }

    fn move_in_program(&mut self, step: BlockStep) {
        let Some(document) = self.program.shown() else { return };
        let (here, last) = (document.selected(), document.program().blocks().len().saturating_sub(1));
        let block = match step {
            BlockStep::Up => here.saturating_sub(1),
            BlockStep::Down => here + 1,
            BlockStep::PageUp => here.saturating_sub(PAGE),
            BlockStep::PageDown => here + PAGE,
            BlockStep::First => 0,
            BlockStep::Last => last,
        };
        let place = BlockPlace { program: document.path().clone(), block: block.min(last) };
        self.program.look_at(&place, true);
    }

    /// A program of the call stack: at the block that calls, or that runs next.
    fn show_program(&mut self, path: NcPath) {
        let calls = self.program.run.iter().flat_map(Run::calls);
        let place = calls.filter(|place| place.program == path).last();
        let block = self.program.documents.get(&path).map_or(0, Document::selected);
        self.program.look_at(&place.unwrap_or(BlockPlace { program: path, block }), false);
    }
}
