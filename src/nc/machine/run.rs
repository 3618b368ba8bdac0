//! The machine: which block is next, what it has done so far, and when it stops.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::budget::{Budget, Settings, UsedUp};
use super::contacts::{Contacts, Probed};
use super::cycles::CycleRun;
use super::fault::{BlockPlace, Fault, FaultKind};
use super::flow::{Call, Frame};
use super::known::Known;
use super::moves::{Position, Travel};
use super::path::NcPath;
use super::prints::{Window, Written};
use super::remark::Remark;
use super::step::{Pause, Step};
use super::store::{Shipped, Store};
use super::tables::OpenTable;
use crate::control::variables::{Parameter, Value, Variables};
use crate::nc::program::{Block, Body, MachineFunction, Program, Unit};
use crate::probing::TouchProbe;

#[derive(Debug)]
pub(super) enum State {
    Ready,
    Ended,
    Faulted(Fault),
}

/// Runs a program as a control does. It owns all that it needs and may go to another thread.
///
/// ```
/// use std::sync::Arc;
///
/// use fitcheck::nc::machine::{Contacts, Machine, Settings, Shipped, Step};
/// use fitcheck::nc::program::Program;
/// use fitcheck::control::variables::{Parameter, Value};
/// use fitcheck::words::Dialogue;
///
/// let text = b"BEGIN PGM sum MM\nQ1 = 5 * 3 + 2 * 10\nEND PGM sum MM\n";
/// let program = Arc::new(Program::read(text)?.0);
/// let settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 1, 31).at(12, 0, 0, 0));
/// let mut machine = Machine::new("sum.h", program, Shipped, Contacts::Perfect, settings);
/// assert_eq!(machine.run(100)?, Step::Ended);
/// assert_eq!(machine.variables().get(Parameter::q(1)), Some(&Value::Number(35.0)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Machine {
    main: (NcPath, Arc<Program>),
    pub(super) known: Known,
    pub(super) store: Box<dyn Store>,
    pub(super) probed: Probed,
    pub(super) settings: Settings,
    pub(super) programs: BTreeMap<NcPath, Arc<Program>>,
    pub(super) file_bytes: usize,
    pub(super) traffic: usize,
    pub(super) frame: Frame,
    pub(super) calls: Vec<Call>,
    pub(super) variables: Variables,
    pub(super) changed: Vec<Parameter>,
    pub(super) given: BTreeMap<Parameter, Value>,
    pub(super) table: Option<OpenTable>,
    pub(super) changed_tables: BTreeMap<NcPath, OpenTable>,
    pub(super) open_outputs: BTreeSet<NcPath>,
    pub(super) windows: Vec<Window>,
    pub(super) outputs: Vec<Written>,
    pub(super) output_bytes: usize,
    pub(super) cycles: Vec<CycleRun>,
    pub(super) probe: TouchProbe,
    pub(super) other_tool: Option<String>,
    pub(super) position: Position,
    pub(super) path: Vec<Travel>,
    pub(super) remarks: Vec<(BlockPlace, Remark)>,
    /// Which of the remarks are about a block.
    remarks_of: BTreeMap<BlockPlace, Vec<usize>>,
    pub(super) unlisted: usize,
    pub(super) breakpoints: BTreeSet<(NcPath, usize)>,
    pub(super) blocks_run: u64,
    pub(super) state: State,
}

impl std::fmt::Debug for Machine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Machine").field("place", &self.place()).field("state", &self.state).finish_non_exhaustive()
    }
}

impl Machine {
    /// A machine before the first block of a program. Of a path that is none on the control, the file name counts.
    pub fn new(
        path: &str,
        program: Arc<Program>,
        store: impl Store + 'static,
        contacts: Contacts,
        settings: Settings,
    ) -> Self {
        Self::start(NcPath::of_file(path), program, Box::new(store), contacts, settings)
    }

    fn start(
        path: NcPath,
        program: Arc<Program>,
        store: Box<dyn Store>,
        contacts: Contacts,
        settings: Settings,
    ) -> Self {
        let probe = settings.probe_table.probe(None).copied().unwrap_or_default();
        let is_inch = program.unit() == Some(Unit::Inch);
        let mut machine = Self {
            main: (path.clone(), Arc::clone(&program)),
            known: Known::default(),
            store,
            probed: Probed::new(contacts),
            settings,
            programs: BTreeMap::from([(path.clone(), Arc::clone(&program))]),
            file_bytes: 0,
            traffic: 0,
            frame: Frame::new(path, program),
            calls: Vec::new(),
            variables: Variables::new(),
            changed: Vec::new(),
            given: BTreeMap::new(),
            table: None,
            changed_tables: BTreeMap::new(),
            open_outputs: BTreeSet::new(),
            windows: Vec::new(),
            outputs: Vec::new(),
            output_bytes: 0,
            cycles: Vec::new(),
            probe,
            other_tool: None,
            position: Position::default(),
            path: Vec::new(),
            remarks: Vec::new(),
            remarks_of: BTreeMap::new(),
            unlisted: 0,
            breakpoints: BTreeSet::new(),
            blocks_run: 0,
            state: State::Ready,
        };
        // Q113 says the unit of the main program.
        machine.variables.set(Parameter::q(113), Value::Number(if is_inch { 1.0 } else { 0.0 }));
        machine
    }

    /// Goes back before the first block: all that the run has found is forgotten, settings and breakpoints stay, and so
    /// does what the store has written. Programs and tables that have not changed since are not read again.
    pub fn restart(&mut self, contacts: Contacts) {
        let mut known = std::mem::take(&mut self.known);
        known.programs.append(&mut self.programs);
        let store = std::mem::replace(&mut self.store, Box::new(Shipped));
        let breakpoints = std::mem::take(&mut self.breakpoints);
        let (path, program) = self.main.clone();
        let settings = self.settings.clone();
        *self = Self { known, breakpoints, ..Self::start(path, program, store, contacts, settings) };
    }

    /// Gives a parameter a value before the run. The main program's first assignment to it is then passed over with a
    /// remark, unless it counts on from the parameter's own value.
    ///
    /// # Errors
    /// [`FaultKind`] where a control has no such parameter, or it cannot hold the value.
    pub fn set(&mut self, parameter: Parameter, value: Value) -> Result<(), FaultKind> {
        self.put(parameter, value.clone())?;
        self.given.insert(parameter, value);
        Ok(())
    }

    /// Runs one block.
    ///
    /// # Errors
    /// [`Fault`]; the run is over then, and every further step says the same again.
    pub fn step(&mut self) -> Result<Step, Fault> {
        match &self.state {
            State::Ready => {}
            State::Ended => return Ok(Step::Ended),
            State::Faulted(fault) => return Err(fault.clone()),
        }
        self.changed.clear();
        let at = self.frame.next;
        let mut done = self.block(at);
        if matches!(done, Ok(Step::Ended)) {
            self.state = State::Ended;
            if let Some((count, used)) = self.probed.left() {
                self.remark(at, Remark::ContactsLeft { count, used });
            }
            // Another error of the end counts as one of the block that ended the run.
            if let Err(kind) = self.write_tables() {
                done = Err(kind);
            }
        }
        done.map_err(|kind| self.fail(at, kind))
    }

    /// Ends the run with a fault; what FN 27 has changed until then is written, as on the control.
    fn fail(&mut self, at: usize, kind: FaultKind) -> Fault {
        let table = self.table().cloned();
        if let (Err(error), Some(path)) = (self.write_tables(), table) {
            self.remark(at, Remark::NotSaved { path, reason: error.to_string() });
        }
        let fault = self.fault(at, kind);
        self.state = State::Faulted(fault.clone());
        fault
    }

    /// Runs blocks until the run pauses or ends, until the next one has a breakpoint, or so many.
    ///
    /// # Errors
    /// As [`Self::step`].
    pub fn run(&mut self, most: u64) -> Result<Step, Fault> {
        for done in 0..most {
            if 0 < done && self.is_at_breakpoint() {
                return Ok(Step::Paused(Pause::Breakpoint));
            }
            match self.step()? {
                Step::Went => {}
                over => return Ok(over),
            }
        }
        Ok(Step::Went)
    }

    fn is_at_breakpoint(&self) -> bool {
        !self.breakpoints.is_empty() && self.breakpoints.contains(&(self.frame.path.clone(), self.frame.next))
    }

    /// Runs the block at a place of the current program.
    fn block(&mut self, at: usize) -> Result<Step, FaultKind> {
        let program = Arc::clone(&self.frame.program);
        if self.settings.budget.blocks <= self.blocks_run {
            return Err(UsedUp::Blocks(self.settings.budget.blocks).into());
        }
        let block = program.blocks().get(at).ok_or(FaultKind::Broken { what: "END PGM" })?;
        self.blocks_run += 1;
        self.frame.next = at + 1;
        if !self.frame.has_begun {
            self.frame.has_begun = match block.body {
                Body::Begin { .. } => true,
                Body::Nothing | Body::Heading { .. } => false,
                _ => return Err(FaultKind::Broken { what: "BEGIN PGM" }),
            };
        }
        if block.may_be_skipped && self.settings.block_skip {
            return Ok(Step::Went);
        }
        self.body(at, block)
    }

    fn body(&mut self, at: usize, block: &Block) -> Result<Step, FaultKind> {
        match &block.body {
            Body::Begin { .. } | Body::Nothing | Body::Heading { .. } => {}
            Body::Label(label) => self.pass_label(label),
            Body::End { .. } => return Ok(self.end_program()),
            Body::CallLabel { label, repeat } => self.call_label(at, label, *repeat)?,
            Body::CallProgram(path) => self.call_program(at, path)?,
            Body::Assign { to, value } => self.assign(at, *to, value)?,
            Body::Undefine(parameter) => self.undefine(at, *parameter),
            Body::AssignText { to, value } => self.assign_text(at, *to, value)?,
            Body::Jump { condition, label } => {
                if self.holds(condition)? {
                    self.jump(label)?;
                }
            }
            Body::Error(number) => {
                let number = self.whole("FN 14: ERROR", *number)?;
                return Err(FaultKind::Programmed(u32::try_from(number).unwrap_or(u32::MAX)));
            }
            Body::Print { mask, output } => self.print(at, mask, output)?,
            Body::TableOpen(path) => self.open_table(path)?,
            Body::TableRead { to, row, columns } => self.read_table(*to, *row, columns)?,
            Body::TableWrite { row, columns, from } => self.write_table(*row, columns, *from)?,
            Body::ToolCall { tool, .. } => self.call_tool(tool.as_ref())?,
            Body::Move(movement) => {
                self.travel(at, movement)?;
                return Ok(self.machine_functions(at, &movement.machine));
            }
            Body::MachineFunctions(functions) => return Ok(self.machine_functions(at, functions)),
            Body::Stop(functions) => {
                return Ok(match self.machine_functions(at, functions) {
                    Step::Went => Step::Paused(Pause::Stop),
                    step => step,
                });
            }
            Body::Probe(cycle) => return self.probe(at, cycle),
            Body::Other if self.is_blank_form(at) => {}
            Body::CycleDefinition(_) | Body::Other => self.unknown(at)?,
        }
        Ok(Step::Went)
    }

    /// M0, M1, M2 and M30; all others move nothing here.
    fn machine_functions(&mut self, at: usize, functions: &[MachineFunction]) -> Step {
        let mut step = Step::Went;
        for function in functions {
            match function.number {
                0 => step = Step::Paused(Pause::Stop),
                1 if self.settings.optional_stop => step = Step::Paused(Pause::OptionalStop),
                2 | 30 => {
                    if self.is_within_call() {
                        self.remark(at, Remark::EndedWithin { function: function.number });
                    }
                    return Step::Ended;
                }
                _ => {}
            }
        }
        step
    }

    /// The blank's form is for the control's graphics and changes nothing.
    fn is_blank_form(&self, at: usize) -> bool {
        let mut text = self.frame.program.text_of(at);
        text.next().is_some_and(|line| {
            let line = line.trim_start_matches(|c: char| c.is_ascii_digit() || c.is_whitespace() || c == '/');
            line.get(..8).is_some_and(|word| word.eq_ignore_ascii_case("BLK FORM"))
        })
    }

    /// A block that is not known stops the run, or is passed over where the user says so.
    pub(super) fn unknown(&mut self, at: usize) -> Result<(), FaultKind> {
        if !self.settings.skip_unknown {
            return Err(FaultKind::UnknownBlock);
        }
        self.remark(at, Remark::Skipped);
        Ok(())
    }

    /// Remembers what is worth knowing, once a block; so many, then they are counted only.
    pub(super) fn remark(&mut self, at: usize, remark: Remark) {
        let place = self.place_of(at);
        // Only those of the block are looked through: a loop makes the same ones again and again.
        let said = self.remarks_of.get(&place).into_iter().flatten();
        if said.filter_map(|number| self.remarks.get(*number)).any(|(_, said)| *said == remark) {
            return;
        }
        if self.remarks.len() < self.settings.budget.remarks {
            self.remarks_of.entry(place.clone()).or_default().push(self.remarks.len());
            self.remarks.push((place, remark));
        } else {
            self.unlisted += 1;
        }
    }

    pub(super) fn place_of(&self, block: usize) -> BlockPlace {
        BlockPlace { program: self.frame.path.clone(), block }
    }

    fn fault(&self, at: usize, kind: FaultKind) -> Fault {
        const LONGEST: usize = 80;
        let program = &self.frame.program;
        // Behind the last block, the last one is named.
        let at = at.min(program.blocks().len().saturating_sub(1));
        let block = program.blocks().get(at);
        let text = program.text_of(at).next().unwrap_or_default();
        let number = block.and_then(|block| block.number);
        let bare = text.trim().trim_start_matches(|c: char| c.is_ascii_digit()).trim_start();
        let bare = if number.is_some() { bare } else { text.trim() };
        let mut text: String = bare.chars().take(LONGEST).map(|c| if c.is_control() { ' ' } else { c }).collect();
        if LONGEST < bare.chars().count() {
            text.push('…');
        }
        let line = block.map_or_else(|| program.line_count(), |block| block.lines.start + 1);
        Fault { place: self.place_of(at), number, line, text, kind: Box::new(kind) }
    }

    pub(super) const fn budget(&self) -> &Budget {
        &self.settings.budget
    }
}
