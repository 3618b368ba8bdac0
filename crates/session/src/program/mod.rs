//! The program page: an NC program is read, run, stepped and watched.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `document` | a program as it is shown: outline, names of parameters, the selected block |
//! | `tokens` | the parts of a line, to be distinguished on screen |
//! | `inputs` | the seven inputs of 8255 as fields, and Fitcheck's own answer |
//! | `run` | a run: the machine, slice by slice |
//! | `running` | run, pause, single block, to the selected block |
//! | `keeping` | what its cycles say goes to the journal |
//! | `watching` | parameters with their names, changes and values given before a run |
//! | `opening` | programs from files, and what is typed |
//! | `workpiece` | what is measured |
//! | `tools` | the tools of Q330: fixed ones, and parameters that a tool is given to |
//! | `creating` | the files with which a control measures for itself |
//! | `notes` | errors, warnings and remarks, block by block |
//!
//! A run belongs to its inputs: any change of an input clears it. Nothing is written; what a program prints to files is
//! listed.

mod actions;
mod apply;
mod command;
mod creating;
mod document;
mod field;
mod input;
mod inputs;
mod keeping;
mod named_tools;
mod notes;
mod opening;
mod run;
mod running;
mod tokens;
mod tools;
mod watching;
mod workpiece;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_exchange::journal::chain::Hash;
use fitcheck_nc::control::variables::{Parameter, Value};
use fitcheck_nc::machine::{BlockPlace, NcPath};
use fitcheck_nc::program::ProgramWarning;

use crate::workpiece::RecordedContacts;

pub use actions::{LISTING, ProgramAction};
pub use command::{Origin, ProgramCommand, Switch, WorkpieceFrom};
pub use creating::{Creating, SetFrom};
pub(crate) use creating::{ForSet, PlanForSet, no_folder, written};
pub use document::{Document, Entry, EntryKind};
pub use field::ProgramField;
pub use input::Input;
pub use inputs::Agreement;
pub use named_tools::ToolOf;
pub use notes::{Note, NoteKind};
pub use run::{MOST_MOVES, Run, Speed, State};
pub use tokens::{Token, tokens, tokens_of};
pub use watching::{Name, Watched};

/// The state of the program page.
#[derive(Debug, Default)]
pub struct ProgramPage {
    /// Where the open program came from; `None` before the page was opened for the first time.
    pub origin: Option<Origin>,
    main: Option<NcPath>,
    shown: Option<NcPath>,
    documents: BTreeMap<NcPath, Document>,
    /// The warnings of the reader about the open program.
    warnings: Vec<ProgramWarning>,
    texts: BTreeMap<ProgramField, String>,
    errors: BTreeMap<ProgramField, Message>,
    /// What is measured.
    pub workpiece: WorkpieceFrom,
    /// The contacts that were opened here: the cycles page has its own.
    pub recorded: Option<Arc<RecordedContacts>>,
    /// What the user typed for parameters, in the form or under "Start with": the only place for both.
    typed: BTreeMap<Parameter, String>,
    /// The values of these texts, for the start of a run.
    given: BTreeMap<Parameter, Value>,
    pinned: BTreeSet<Parameter>,
    breakpoints: BTreeSet<BlockPlace>,
    switches: BTreeSet<Switch>,
    /// How fast a run goes.
    pub speed: Speed,
    /// The run, once it began.
    pub run: Option<Run>,
    /// SHA-256 of the open program's file.
    sha256: Option<Hash>,
    /// The files for a control.
    pub creating: Creating,
    /// Why a run could not begin.
    refused: Option<Message>,
    /// Counts how often a program was opened by the user.
    opened: u64,
    /// Counts how often a line had to come into sight.
    looks: u64,
    /// The line that has to come into sight.
    look: usize,
}

impl ProgramPage {
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

    /// Whether something is switched on.
    pub fn is_on(&self, switch: Switch) -> bool {
        self.switches.contains(&switch)
    }

    /// Whether a block of the shown program has a breakpoint.
    pub fn has_breakpoint(&self, block: usize) -> bool {
        let Some(program) = &self.shown else { return false };
        // Almost always there is none at all.
        !self.breakpoints.is_empty() && self.breakpoints.contains(&BlockPlace { program: program.clone(), block })
    }

    /// Whether nobody measured what a run measures: it is a workpiece that is simulated, given or perfect.
    pub fn is_simulated(&self) -> bool {
        self.workpiece != WorkpieceFrom::Recorded
    }

    /// A number that changes when the user has opened a program.
    pub const fn opened_count(&self) -> u64 {
        self.opened
    }

    /// A number that changes when a line has to come into sight, and that line of the shown program.
    pub const fn look(&self) -> (u64, usize) {
        (self.looks, self.look)
    }

    /// Adds a program of the run to those that can be shown.
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
