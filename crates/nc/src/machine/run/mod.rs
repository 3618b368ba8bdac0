//! The machine as its users see it: set up, run block by block, asked what it has done.
//!
//! `blocks` has what each block does; `data` parameters and tables, `around` what sets something up, `lathe` what only lathe
//! controls have, `point` cycles 0 and 1,
//! `skipped` what is unknown behind blocks that are not run.

mod around;
mod blocks;
mod data;
mod file_functions;
mod lathe;
mod point;
mod skipped;
mod system;

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use super::around::Around;
use super::budget::Settings;
use super::contacts::Contacts;
use super::cycles::{CycleRun, Cycles};
use super::fault::{BlockPlace, Fault, FaultKind};
use super::files::Files;
use super::flow::{Call, Flow};
use super::moves::{Travel, Way};
use super::path::NcPath;
use super::presets::Presets;
use super::prints::{Prints, Window, Written};
use super::remark::{Remark, Remarks};
use super::step::{Pause, Step};
use super::store::{Origin, Store};
use super::tables::Tables;
use super::tools::{ToolChanged, Tools};
use super::values::Values;
use crate::control::tool_table::ToolTable;
use crate::control::variables::{Parameter, Value, Variables};
use crate::program::{Notation, Program, Unit, Unread};
use fitcheck_core::message::{Message, message};
use fitcheck_core::verdict::Status;
use point::PointStart;
use skipped::UnknownFiles;
use system::SpindleTool;

/// The state of a run: what a restart clears.
#[derive(Debug)]
struct Run {
    flow: Flow,
    values: Values,
    tables: Tables,
    presets: Presets,
    prints: Prints,
    cycles: Cycles,
    tools: Tools,
    spindle_tool: SpindleTool,
    point: Option<PointStart>,
    way: Way,
    around: Around,
    remarks: Remarks,
    /// What unknown blocks that were skipped may do, by their place.
    unread: BTreeMap<BlockPlace, Arc<Unread>>,
    /// Files that skipped blocks may have touched.
    unknown_files: UnknownFiles,
    /// Parameters that skipped blocks of SQL may have bound to columns.
    bound: BTreeSet<Parameter>,
    blocks: u64,
}

impl Run {
    fn new(path: NcPath, program: Arc<Program>, contacts: Contacts, settings: &Settings) -> Self {
        let is_inch = program.unit() == Some(Unit::Inch);
        let mut values = Values::new(settings, &path);
        let notation = program.notation();
        if notation != Notation::DinPlus {
            // Tool axis, spindle and coolant of a control that was just started, and the unit of the main program.
            let unit = if is_inch { 1.0 } else { 0.0 };
            for (number, value) in [(109, -1.0), (110, -1.0), (111, 0.0), (113, unit)] {
                values.set(Parameter::q(number), Value::Number(value));
            }
        }
        let cycles = Cycles::new(contacts, settings);
        Self {
            flow: Flow::new(path, program, &settings.budget),
            values,
            tables: Tables::default(),
            presets: Presets::default(),
            prints: Prints::new(settings.budget, cycles.is_simulated()),
            cycles,
            tools: Tools::new(settings.tool_table.clone()),
            spindle_tool: SpindleTool::default(),
            point: None,
            way: Way::new(&settings.budget, notation),
            around: Around::new(notation),
            remarks: Remarks::new(&settings.budget),
            unread: BTreeMap::new(),
            unknown_files: UnknownFiles::default(),
            bound: BTreeSet::new(),
            blocks: 0,
        }
    }
}

#[derive(Debug)]
enum State {
    Ready,
    Ended,
    Faulted(Fault),
}

/// Runs a program as a control does. It owns all its data and can move to another thread.
///
/// ```
/// use std::sync::Arc;
///
/// use fitcheck_nc::machine::{Contacts, Machine, Settings, Shipped, Step};
/// use fitcheck_nc::program::Program;
/// use fitcheck_nc::control::variables::{Parameter, Value};
/// use fitcheck_core::words::Dialogue;
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
    settings: Settings,
    files: Files,
    breakpoints: BTreeSet<BlockPlace>,
    run: Run,
    state: State,
}

impl std::fmt::Debug for Machine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Machine").field("place", &self.place()).field("state", &self.state).finish_non_exhaustive()
    }
}

impl Machine {
    /// A machine before the first block of a program. If a path is not one of a control, only its file name counts.
    pub fn new(
        path: &str,
        program: Arc<Program>,
        store: impl Store + 'static,
        contacts: Contacts,
        settings: Settings,
    ) -> Self {
        let path = NcPath::of_file(path);
        let main = (path.clone(), Arc::clone(&program));
        let files = Files::new(Box::new(store), settings.budget, main.clone());
        let run = Run::new(path, program, contacts, &settings);
        Self { main, settings, files, breakpoints: BTreeSet::new(), run, state: State::Ready }
    }

    /// Goes back before the first block: all results of the run are cleared; settings, breakpoints and files that the
    /// store has written stay. Programs and tables that have not changed since are not parsed again.
    pub fn restart(&mut self, contacts: Contacts) {
        self.files.restart(self.main.clone());
        let (path, program) = self.main.clone();
        self.run = Run::new(path, program, contacts, &self.settings);
        self.state = State::Ready;
    }

    /// Gives a parameter a value before the run. The main program's first assignment to it is then skipped with a
    /// remark, unless that assignment uses the parameter's own value.
    ///
    /// # Errors
    /// [`FaultKind`] if the parameter does not exist on a control, or cannot hold the value.
    pub fn set(&mut self, parameter: Parameter, value: Value) -> Result<(), FaultKind> {
        self.run.values.give(parameter, value)
    }

    /// Runs one block.
    ///
    /// # Errors
    /// [`Fault`]; the run is over then, and every further step gives the same fault.
    pub fn step(&mut self) -> Result<Step, Fault> {
        match &self.state {
            State::Ready => {}
            State::Ended => return Ok(Step::Ended),
            State::Faulted(fault) => return Err(fault.clone()),
        }
        let done = self.run.step(&mut self.files, &self.settings);
        match &done {
            Ok(Step::Ended) => self.state = State::Ended,
            Ok(Step::Went | Step::Paused(_)) => {}
            Err(fault) => self.state = State::Faulted(fault.clone()),
        }
        done
    }

    /// Runs blocks until the run pauses or ends, the next block has a breakpoint, or `most` blocks have run.
    ///
    /// # Errors
    /// As for [`Self::step`].
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
        !self.breakpoints.is_empty() && self.breakpoints.contains(&self.place())
    }

    /// Sets or clears a breakpoint.
    pub fn toggle_breakpoint(&mut self, place: BlockPlace) {
        if !self.breakpoints.remove(&place) {
            self.breakpoints.insert(place);
        }
    }

    pub const fn breakpoints(&self) -> &BTreeSet<BlockPlace> {
        &self.breakpoints
    }

    /// All parameters that have a value now.
    pub const fn variables(&self) -> &Variables {
        self.run.values.all()
    }

    /// The parameters that the last block has set.
    pub fn changed(&self) -> &[Parameter] {
        self.run.values.changed()
    }

    /// The block that runs next.
    pub fn place(&self) -> BlockPlace {
        self.run.flow.place_of(self.run.flow.next())
    }

    /// The program that is running.
    pub const fn current(&self) -> &Arc<Program> {
        self.run.flow.program()
    }

    /// A program that has been loaded.
    pub fn program(&self, path: &NcPath) -> Option<&Arc<Program>> {
        self.files.loaded(path)
    }

    /// Where each file comes from that the run has read, the main program aside.
    pub const fn origins(&self) -> &BTreeMap<NcPath, Origin> {
        self.files.origins()
    }

    /// The calls that lead to the current block, the outermost first.
    pub fn calls(&self) -> &[Call] {
        self.run.flow.calls()
    }

    /// What FN 16 has shown, in order; `SCLR:` closes windows.
    pub fn windows(&self) -> &[Window] {
        self.run.prints.windows()
    }

    /// What FN 16 has printed to files, in order.
    pub fn outputs(&self) -> &[Written] {
        self.run.prints.outputs()
    }

    /// What the cycles have found, in order.
    pub fn cycles(&self) -> &[CycleRun] {
        self.run.cycles.runs()
    }

    /// The tool table as the run has changed it, if it has one; the store is not asked to write it.
    pub const fn tool_table(&self) -> Option<&ToolTable> {
        self.run.tools.table()
    }

    /// What cycles with Q330 have changed in the tool table, in order.
    pub fn tool_changes(&self) -> &[ToolChanged] {
        self.run.tools.changes()
    }

    /// The path of the ball's centre so far.
    pub fn path(&self) -> &[Travel] {
        self.run.way.travels()
    }

    /// Where the ball's centre is, mm, in X, Y and Z as far as known.
    pub fn position(&self) -> [Option<f64>; 3] {
        self.run.way.position()
    }

    /// How many blocks were passed over because nothing that is measured depends on them, by their first words.
    pub const fn passed_over(&self) -> &BTreeMap<String, usize> {
        self.run.around.passed()
    }

    /// The same as a message, without the blank's form, which nearly every program has and which is for graphics only; `None`
    /// if there were no others.
    pub fn passed_over_message(&self) -> Option<Message> {
        let passed = || self.passed_over().iter().filter(|(words, _)| *words != "BLK FORM");
        let listed: Vec<String> = passed().map(|(words, count)| format!("{count} {words}")).collect();
        let count: usize = passed().map(|(_, count)| count).sum();
        let message = || message!("machine-passed-over").count("count", count).text("list", listed.join(", "));
        (0 < count).then(message)
    }

    /// What is worth knowing, in order.
    pub fn remarks(&self) -> &[(BlockPlace, Remark)] {
        self.run.remarks.list()
    }

    /// Whether something worth knowing stands against what was judged, listed or not; where nothing was judged, whether a measurement was
    /// left out.
    pub fn remarks_stand_against(&self) -> bool {
        self.run.remarks.stand_against(self.status().is_some())
    }

    /// How many remarks are not listed.
    pub const fn unlisted_remarks(&self) -> usize {
        self.run.remarks.unlisted()
    }

    /// How many blocks have been run.
    pub const fn blocks_run(&self) -> u64 {
        self.run.blocks
    }

    /// The table that is open.
    pub fn table(&self) -> Option<&NcPath> {
        self.run.tables.path()
    }

    /// Whether the run is over, by its end or by a fault.
    pub const fn is_over(&self) -> bool {
        !matches!(self.state, State::Ready)
    }

    /// The worst status of the cycles that gave one; rework that was measured again since does not count.
    pub fn status(&self) -> Option<Status> {
        self.cycles().iter().filter(|run| !run.is_reworked).filter_map(|run| run.result.verdict()).max()
    }

    /// The settings of the run.
    pub const fn settings(&self) -> &Settings {
        &self.settings
    }
}
