//! A run: the machine and what it waits for. The window asks for it slice by slice, and so never waits long.

use std::collections::BTreeSet;
use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::cycle::{Move, Phase};
use fitcheck_core::text::Within as _;
use fitcheck_core::verdict::Status;
use fitcheck_nc::control::tool_table::ToolTable;
use fitcheck_nc::control::variables::{Parameter, Value, Variables};
use fitcheck_nc::machine::{
    BlockPlace, CycleRun, Fault, FileRead, Machine, NcPath, Pause, Remark, Step, ToolChanged, Travel, TravelKind,
    Window, Written,
};
use fitcheck_nc::program::Program;

/// Blocks in a slice at full speed: a few milliseconds.
const SLICE: u64 = 2_000;
/// Blocks between two checks of what a slice has cost.
const PART: u64 = 100;
/// Cycles after which a slice ends; a cycle takes far longer than any other block.
const MOST_CYCLES: usize = 10;

/// Moves that are drawn; more could not be told apart.
pub const MOST_MOVES: usize = 500;

/// How fast a run goes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Speed {
    /// Four blocks a second: every block can be read.
    Slow,
    /// Twenty blocks a second: the course of the program can be followed.
    Medium,
    /// As fast as it can.
    #[default]
    Fast,
}

impl Speed {
    pub const ALL: [Self; 3] = [Self::Slow, Self::Medium, Self::Fast];

    /// Seconds between two slices; zero is at once.
    pub const fn interval(self) -> f64 {
        match self {
            Self::Slow => 0.25,
            Self::Medium => 0.05,
            Self::Fast => 0.0,
        }
    }

    pub(super) const fn blocks(self) -> u64 {
        match self {
            Self::Slow | Self::Medium => 1,
            Self::Fast => SLICE,
        }
    }
}

/// What a run does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// It goes on, slice by slice.
    Running,
    /// It waits for the stated reason.
    Paused,
    /// It reached its end.
    Ended,
    /// It ended with an error.
    Faulted,
}

/// Where a run stops by itself.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Goal {
    None,
    /// At no more than this many nested calls.
    Depth(usize),
    Block(BlockPlace),
}

#[derive(Debug)]
pub struct Run {
    pub(super) machine: Machine,
    /// What it does.
    pub state: State,
    pub(super) goal: Goal,
    /// Why it waits.
    pub(super) reason: Message,
    /// The error that it ended with.
    pub fault: Option<Fault>,
    /// The remarks that are listed, by number, and how many were examined. That a given value replaces the program's is
    /// intended, so that remark is not listed.
    listed: Vec<usize>,
    looked_through: usize,
    /// The parameters before the last command.
    pub(super) before: Variables,
    /// How many of its cycles were looked at for the journal.
    pub(super) recorded: usize,
    /// The number under which the last of them was sent to the journal, and its place there.
    pub record: Option<(u64, u64)>,
}

impl Run {
    pub(super) fn new(machine: Machine) -> Self {
        let before = machine.variables().clone();
        let reason = message!("program-page-state-step");
        Self {
            machine,
            state: State::Paused,
            goal: Goal::None,
            reason,
            fault: None,
            listed: Vec::new(),
            looked_through: 0,
            before,
            recorded: 0,
            record: None,
        }
    }

    pub fn is_over(&self) -> bool {
        matches!(self.state, State::Ended | State::Faulted)
    }

    /// The block that runs next, or the one that failed; `None` after the end.
    pub fn place(&self) -> Option<BlockPlace> {
        match (&self.fault, self.state) {
            (Some(fault), _) => Some(fault.place.clone()),
            (None, State::Ended) => None,
            (None, _) => Some(self.machine.place()),
        }
    }

    /// The calling blocks, outermost first, then the one that runs next. Calls of labels are included.
    pub fn calls(&self) -> impl Iterator<Item = BlockPlace> {
        self.machine.calls().iter().map(|call| call.from.clone()).chain(self.place())
    }

    /// The programs that called one another, outermost first, without consecutive repeats.
    pub fn programs(&self) -> Vec<NcPath> {
        let mut programs: Vec<_> = self.calls().map(|place| place.program).collect();
        programs.dedup();
        programs
    }

    pub(super) fn program(&self, path: &NcPath) -> Option<Arc<Program>> {
        self.machine.program(path).cloned()
    }

    /// The parameters.
    pub const fn variables(&self) -> &Variables {
        self.machine.variables()
    }

    /// Whether the last command changed a parameter.
    pub fn is_changed(&self, parameter: Parameter) -> bool {
        self.before.get(parameter) != self.variables().get(parameter)
    }

    /// A parameter as a length at the nearest nanometre, mm.
    pub fn length(&self, parameter: Parameter) -> Option<Length> {
        match self.variables().get(parameter)? {
            Value::Length(length) => Some(*length),
            Value::Number(number) => Length::from_mm_f64(*number).ok(),
            Value::Text(_) => None,
        }
    }

    /// The windows that FN 16 has opened and not closed.
    pub fn windows(&self) -> &[Window] {
        self.machine.windows()
    }

    /// The files that FN 16 would have written.
    pub fn outputs(&self) -> &[Written] {
        self.machine.outputs()
    }

    /// What was measured.
    pub fn cycles(&self) -> &[CycleRun] {
        self.machine.cycles()
    }

    /// What cycles with Q330 have changed in the tool table, in order.
    pub fn tool_changes(&self) -> &[ToolChanged] {
        self.machine.tool_changes()
    }

    /// The tool table as the run has changed it; `None` where it has changed nothing.
    pub fn changed_tools(&self) -> Option<&ToolTable> {
        self.machine.tool_table().filter(|_| !self.tool_changes().is_empty())
    }

    /// The worst status of what was measured.
    pub fn status(&self) -> Option<Status> {
        self.machine.status()
    }

    /// Whether the ball's centre has moved.
    pub fn has_path(&self) -> bool {
        !self.machine.path().is_empty()
    }

    /// The path of the ball's centre, the last [`MOST_MOVES`] moves.
    pub fn path(&self) -> Vec<Move> {
        let path = self.machine.path();
        let first = path.len().saturating_sub(MOST_MOVES);
        path.within(first..).iter().map(as_move).collect()
    }

    /// How many remarks there are about the run.
    pub const fn remark_count(&self) -> usize {
        self.listed.len()
    }

    pub fn remark(&self, number: usize) -> Option<&(BlockPlace, Remark)> {
        self.machine.remarks().get(*self.listed.get(number)?)
    }

    /// How many files the run has read besides the main program.
    pub fn file_count(&self) -> usize {
        self.machine.origins().len()
    }

    /// A file that the run has read, by its number.
    pub fn file(&self, number: usize) -> Option<FileRead> {
        self.machine.origins().iter().nth(number).map(|(path, origin)| FileRead::of(path, origin))
    }

    /// How many remarks are not listed.
    pub const fn unlisted_remarks(&self) -> usize {
        self.machine.unlisted_remarks()
    }

    /// Which blocks were passed over, if any were.
    pub fn passed_over(&self) -> Option<Message> {
        self.machine.passed_over_message()
    }

    /// How many blocks were run.
    pub const fn blocks_run(&self) -> u64 {
        self.machine.blocks_run()
    }

    pub(super) fn toggle_breakpoint(&mut self, place: &BlockPlace) {
        self.machine.toggle_breakpoint(place.clone());
    }

    pub(super) fn pause(&mut self, id: &'static str) {
        self.pause_because(Message::new(id));
    }

    fn pause_because(&mut self, reason: Message) {
        self.state = State::Paused;
        self.reason = reason;
        self.goal = Goal::None;
    }

    /// Runs one block.
    pub(super) fn step(&mut self) {
        let result = self.machine.step();
        self.take(result);
    }

    fn take(&mut self, result: Result<Step, Fault>) {
        let new = self.machine.remarks().iter().enumerate().skip(self.looked_through);
        let listed = new.filter(|(_, (_, remark))| !matches!(remark, Remark::GivenWins { .. }));
        self.listed.extend(listed.map(|(number, _)| number));
        self.looked_through = self.machine.remarks().len();
        match result {
            Ok(Step::Went) => {}
            Ok(Step::Ended) => {
                self.state = State::Ended;
                self.goal = Goal::None;
            }
            Ok(Step::Paused(pause)) => self.pause_because(reason(&pause)),
            Err(fault) => {
                self.state = State::Faulted;
                self.goal = Goal::None;
                self.fault = Some(fault);
            }
        }
    }

    /// Runs a slice. `is_first` is whether the run begins or continues with it: a breakpoint there was already seen.
    pub(super) fn slice(&mut self, blocks: u64, is_first: bool, breakpoints: &BTreeSet<BlockPlace>) {
        let measured = self.machine.cycles().len();
        let mut left = blocks;
        let mut was_seen = is_first;
        while 0 < left && self.state == State::Running {
            if !was_seen && !breakpoints.is_empty() && breakpoints.contains(&self.machine.place()) {
                return self.pause("program-page-state-breakpoint");
            }
            was_seen = false;
            let most = if self.goal == Goal::None { PART.min(left) } else { 1 };
            left -= most;
            let result = self.machine.run(most);
            self.take(result);
            if self.state == State::Running
                && let Some(reason) = self.goal_reached()
            {
                return self.pause(reason);
            }
            if measured + MOST_CYCLES <= self.machine.cycles().len() {
                return;
            }
        }
    }

    /// Why the run pauses here, if it has reached its goal.
    fn goal_reached(&self) -> Option<&'static str> {
        let (reached, reason) = match &self.goal {
            Goal::None => (false, ""),
            Goal::Depth(depth) => (self.machine.calls().len() <= *depth, "program-page-state-over"),
            Goal::Block(place) => (self.machine.place() == *place, "program-page-state-goal"),
        };
        reached.then_some(reason)
    }
}

/// A move for drawing: a block of the program counts as one on the way to the next contact.
fn as_move(travel: &Travel) -> Move {
    let (phase, touch) = match travel.kind {
        TravelKind::Cycle(phase) => (phase, None),
        TravelKind::Rapid | TravelKind::Feed => (Phase::PrePosition, None),
    };
    Move { phase, touch, from: travel.from, to: travel.to, about: travel.about }
}

fn reason(pause: &Pause) -> Message {
    match pause {
        Pause::Stop => message!("program-page-state-stop"),
        Pause::OptionalStop => message!("program-page-state-optional-stop"),
        Pause::Breakpoint => message!("program-page-state-breakpoint"),
        Pause::Tolerance(stop) => message!("program-page-state-tolerance").message("stop", stop.message()),
        Pause::Log => message!("program-page-state-log"),
    }
}
