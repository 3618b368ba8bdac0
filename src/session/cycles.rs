//! The cycles page: a form made from a cycle's declaration, where its contacts come from, and what it found.
//!
//! | file | what |
//! |---|---|
//! | here | the fields and what they mean, read anew at every change |
//! | `command` | what can be done, and the text fields |
//! | `workpiece`, `workpiece_field` | the simulated workpiece as text fields |
//! | `running` | from the fields to a run, and stepping along its path |
//! | `filling` | NC blocks and files into fields |
//!
//! A result is kept with what it was made with: any change of an input clears it.

mod command;
mod filling;
mod running;
mod workpiece;
mod workpiece_field;

use std::collections::BTreeMap;
use std::sync::Arc;

use jiff::civil::DateTime;

pub use command::{Axis, ContactsFrom, CycleField, CyclesCommand};
pub use running::{CycleRun, RunLog, Step};
pub use workpiece::WorkpieceForm;
pub use workpiece_field::WorkpieceField;

use super::{Effect, Session};
use crate::control::probe_table::ProbeTable;
use crate::length::Length;
use crate::message::{Message, Say as _};
use crate::probing::cycle::{Cycle, Inputs, Key, Parameter, Unset, Value};
use crate::probing::cycles::CYCLES;
use crate::probing::{Contact, TouchProbe};

/// Contacts of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedContacts {
    /// The file's name.
    pub name: String,
    /// The contacts in probing order.
    pub contacts: Vec<Contact>,
}

/// The state of the cycles page.
#[derive(Debug)]
pub struct CyclesPage {
    cycle: &'static Cycle,
    texts: BTreeMap<(u16, Key), String>,
    globals: BTreeMap<(u16, Key), String>,
    position: BTreeMap<Axis, String>,
    errors: BTreeMap<CycleField, Message>,
    inputs: Inputs,
    from: ContactsFrom,
    workpiece: WorkpieceForm,
    workpiece_is_open: bool,
    recorded: Option<Arc<RecordedContacts>>,
    probes: Option<(String, ProbeTable)>,
    probe: Option<u32>,
    block: Option<String>,
    block_problem: Option<Message>,
    run: Option<CycleRun>,
    step: usize,
}

impl Default for CyclesPage {
    fn default() -> Self {
        #[expect(clippy::expect_used, reason = "the list of cycles is a constant with members")]
        let cycle = CYCLES.first().copied().expect("there are cycles");
        let mut page = Self {
            cycle,
            texts: BTreeMap::new(),
            globals: BTreeMap::new(),
            position: BTreeMap::new(),
            errors: BTreeMap::new(),
            inputs: Inputs::new(),
            from: ContactsFrom::default(),
            workpiece: WorkpieceForm::default(),
            workpiece_is_open: false,
            recorded: None,
            probes: None,
            probe: None,
            block: None,
            block_problem: None,
            run: None,
            step: 0,
        };
        page.read();
        page
    }
}

impl CyclesPage {
    /// The chosen cycle.
    pub const fn cycle(&self) -> &'static Cycle {
        self.cycle
    }

    /// The text of a field; empty where nothing was typed.
    pub fn text(&self, field: CycleField) -> &str {
        let text = match field {
            CycleField::Parameter(key) => self.texts.get(&(self.cycle.number, key)),
            CycleField::Global(key) => self.globals.get(&(self.cycle.number, key)),
            CycleField::Position(axis) => self.position.get(&axis),
            CycleField::Workpiece(field) => return self.workpiece.text(field),
        };
        text.map_or("", String::as_str)
    }

    /// What is wrong with a field.
    pub fn error(&self, field: CycleField) -> Option<&Message> {
        match field {
            CycleField::Workpiece(field) => self.workpiece.error(field),
            field => self.errors.get(&field),
        }
    }

    /// The value of a parameter: what was typed or its default, where that can be used.
    pub fn value(&self, parameter: &Parameter) -> Option<Value> {
        self.inputs.value(parameter.key).cloned().or_else(|| parameter.default_with(&self.inputs))
    }

    /// Whether PREDEF was typed for a parameter, so that its value has to be said elsewhere.
    pub fn is_predef(&self, key: Key) -> bool {
        self.inputs.value(key) == Some(&Value::Predef)
    }

    /// What was typed, as far as it can be used.
    pub const fn inputs(&self) -> &Inputs {
        &self.inputs
    }

    /// Whether every field can be used and none is missing.
    pub fn is_complete(&self) -> bool {
        self.errors.is_empty() && self.missing().next().is_none()
    }

    /// The first field, in the order of the form, that keeps the cycle from running.
    pub fn first_wrong(&self) -> Option<CycleField> {
        let of_parameter =
            |parameter: &Parameter| [CycleField::Parameter(parameter.key), CycleField::Global(parameter.key)];
        let parameters = self.cycle.parameters.iter().flat_map(of_parameter);
        let mut fields = parameters.chain(Axis::ALL.map(CycleField::Position));
        fields.find(|field| self.errors.contains_key(field))
    }

    /// The parameters that must be given and are not.
    fn missing(&self) -> impl Iterator<Item = &'static Parameter> {
        let is_missing = |parameter: &&Parameter| {
            parameter.unset == Unset::Refused && self.text(CycleField::Parameter(parameter.key)).trim().is_empty()
        };
        self.cycle.parameters.iter().filter(is_missing)
    }

    /// Where contacts come from.
    pub const fn from(&self) -> ContactsFrom {
        self.from
    }

    /// The simulated workpiece.
    pub const fn workpiece(&self) -> &WorkpieceForm {
        &self.workpiece
    }

    /// Whether its dialog is open.
    pub const fn workpiece_is_open(&self) -> bool {
        self.workpiece_is_open
    }

    /// The recorded contacts.
    pub fn recorded(&self) -> Option<&RecordedContacts> {
        self.recorded.as_deref()
    }

    /// The name of the user's touch-probe table, where one was opened.
    pub fn probes_name(&self) -> Option<&str> {
        self.probes.as_ref().map(|(name, _)| name.as_str())
    }

    /// The probes of the table.
    pub fn probes(&self) -> &[TouchProbe] {
        &self.probe_table().probes
    }

    fn probe_table(&self) -> &ProbeTable {
        self.probes.as_ref().map_or_else(|| ProbeTable::shipped(), |(_, table)| table)
    }

    /// The probe that measures.
    pub fn probe(&self) -> TouchProbe {
        self.probe_table().probe(self.probe).copied().unwrap_or_default()
    }

    /// The NC block that is being typed, where its field is open.
    pub fn block(&self) -> Option<&str> {
        self.block.as_deref()
    }

    /// Why the NC block cannot be used.
    pub const fn block_problem(&self) -> Option<&Message> {
        self.block_problem.as_ref()
    }

    /// What the last run found; it belongs to the inputs on screen.
    pub const fn run(&self) -> Option<&CycleRun> {
        self.run.as_ref()
    }

    /// The number of the move that is shown, from 0.
    pub const fn step(&self) -> usize {
        self.step
    }

    fn set(&mut self, field: CycleField, text: String) {
        match field {
            CycleField::Parameter(key) => _ = self.texts.insert((self.cycle.number, key), text),
            CycleField::Global(key) => _ = self.globals.insert((self.cycle.number, key), text),
            CycleField::Position(axis) => _ = self.position.insert(axis, text),
            CycleField::Workpiece(field) => {
                self.workpiece.set(field, text);
                // Other sources do not know the workpiece.
                if self.from != ContactsFrom::Simulated {
                    return;
                }
            }
        }
        self.changed();
    }

    /// No result stays beside inputs that it was not made with.
    fn changed(&mut self) {
        self.clear();
        self.read();
    }

    fn clear(&mut self) {
        (self.run, self.step) = (None, 0);
    }

    /// Reads the fields anew.
    fn read(&mut self) {
        self.errors.clear();
        let mut inputs = Inputs::new().with_probe(self.probe());
        for parameter in self.cycle.parameters {
            inputs = self.read_parameter(parameter, inputs);
        }
        if let Some(position) = self.read_position() {
            inputs = inputs.with_position(position);
        }
        self.inputs = inputs;
    }

    fn read_parameter(&mut self, parameter: &Parameter, inputs: Inputs) -> Inputs {
        let field = CycleField::Parameter(parameter.key);
        let text = self.text(field);
        if text.trim().is_empty() {
            return inputs;
        }
        match parameter.accept(text) {
            Ok(Value::Predef) => self.read_global(parameter, inputs.with(parameter.key, Value::Predef)),
            Ok(value) => inputs.with(parameter.key, value),
            Err(error) => {
                self.errors.insert(field, error.message());
                inputs
            }
        }
    }

    fn read_global(&mut self, parameter: &Parameter, inputs: Inputs) -> Inputs {
        let field = CycleField::Global(parameter.key);
        match parameter.accept(self.text(field)) {
            Err(_) if self.text(field).trim().is_empty() => {
                self.errors.insert(field, Message::new("cycles-predef-missing"));
                inputs
            }
            Ok(Value::Predef) => {
                self.errors.insert(field, Message::new("cycles-predef-missing"));
                inputs
            }
            Ok(value) => inputs.with_global(parameter.key, value),
            Err(error) => {
                self.errors.insert(field, error.message());
                inputs
            }
        }
    }

    /// All three or none: a half position would be guessed.
    fn read_position(&mut self) -> Option<[f64; 3]> {
        if Axis::ALL.iter().all(|axis| self.text(CycleField::Position(*axis)).trim().is_empty()) {
            return None;
        }
        let [x, y, z] = Axis::ALL.map(|axis| {
            let field = CycleField::Position(axis);
            let read = self.text(field).parse().map(Length::to_mm_f64);
            read.map_err(|error| self.errors.insert(field, error.message())).ok()
        });
        Some([x?, y?, z?])
    }
}

impl Session {
    /// The cycles page.
    pub const fn cycles(&self) -> &CyclesPage {
        &self.cycles
    }

    pub(super) fn apply_cycles(&mut self, command: CyclesCommand, now: DateTime) -> Vec<Effect> {
        let page = &mut self.cycles;
        match command {
            CyclesCommand::Choose(number) => page.choose(number),
            CyclesCommand::Type(field, text) => page.set(field, text),
            CyclesCommand::From(from) => {
                page.from = from;
                page.changed();
            }
            CyclesCommand::ShowWorkpiece(is_open) => page.workpiece_is_open = is_open,
            CyclesCommand::ChooseShape(shape) => page.change_workpiece(|workpiece| workpiece.set_shape(shape)),
            CyclesCommand::ChoosePlane(plane) => page.change_workpiece(|workpiece| workpiece.set_plane(plane)),
            CyclesCommand::SuitWorkpiece => self.suit_workpiece(),
            CyclesCommand::ChooseProbe(number) => {
                page.probe = Some(number);
                page.changed();
            }
            CyclesCommand::ShippedProbes => {
                (page.probes, page.probe) = (None, None);
                page.changed();
            }
            CyclesCommand::Run => page.measure(now, self.language.dialogue()),
            CyclesCommand::Clear => page.clear(),
            CyclesCommand::Step(step) => page.go(step),
            CyclesCommand::ShowBlock(is_open) => {
                page.block = is_open.then(|| page.block.take().unwrap_or_default());
                page.block_problem = None;
            }
            CyclesCommand::TypeBlock(text) => (page.block, page.block_problem) = (Some(text), None),
            CyclesCommand::TakeBlock => page.take_block(),
            CyclesCommand::CopyBlock => match page.written(self.language.dialogue()) {
                Ok(block) => return vec![Effect::Copy(block)],
                Err(problem) => self.tell(problem),
            },
            CyclesCommand::CopyResults => return page.results_text().map(Effect::Copy).into_iter().collect(),
            CyclesCommand::CopyStatus => {
                return self.cycle_window().and_then(Result::ok).map(Effect::Copy).into_iter().collect();
            }
            CyclesCommand::ContactsRead { name, result } => self.contacts_read(name, result),
            CyclesCommand::WorkpieceRead(result) => self.workpiece_read(result),
            CyclesCommand::ProbesRead { name, result } => self.probes_read(name, result),
        }
        Vec::new()
    }
}
