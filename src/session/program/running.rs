//! Run, pause, single block, to the selected block. A run goes on in slices that the window asks for, so that it never
//! waits long.

use std::collections::BTreeSet;
use std::sync::Arc;

use jiff::civil::DateTime;

use super::inputs::{Input, length};
use super::{Origin, ProgramField, ProgramPage, WorkpieceFrom};
use crate::control::machine::{
    BlockPlace, Contacts, CycleRun, Fault, Folders, Machine, NcPath, Pause, Remark, Settings, Step, Travel, TravelKind,
    Window, Written,
};
use crate::control::program::Program;
use crate::control::variables::{Parameter, Value, Variables};
use crate::length::Length;
use crate::probing::cycle::{Move, Phase, Plane};
use crate::probing::simulated::{Bench, Surface, Workpiece};
use crate::session::Session;
use crate::tolerance::Feature;
use crate::verdict::Status;
use crate::words::{Message, Say as _};

/// Blocks of a slice at full speed: some milliseconds.
const SLICE: u64 = 2_000;
/// Blocks between two looks at what a slice has cost.
const PART: u64 = 100;
/// Cycles after which a slice ends; one takes far longer than any other block.
const MOST_CYCLES: usize = 10;

/// Moves that are drawn: more would be a blot.
pub const MOST_MOVES: usize = 500;

/// How fast a run goes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum Speed {
    /// Four blocks a second: every block can be read.
    Slow,
    /// Twenty blocks a second: the way through the program can be followed.
    Medium,
    /// As fast as it can.
    #[default]
    Fast,
}

impl Speed {
    /// Every speed.
    pub const ALL: [Self; 3] = [Self::Slow, Self::Medium, Self::Fast];

    /// Seconds between two slices; zero is at once.
    pub const fn interval(self) -> f64 {
        match self {
            Self::Slow => 0.25,
            Self::Medium => 0.05,
            Self::Fast => 0.0,
        }
    }

    const fn blocks(self) -> u64 {
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
    /// It waits, for the reason that it says.
    Paused,
    /// It came to its end.
    Ended,
    /// It ended with an error.
    Faulted,
}

/// How far a run goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Mode {
    /// Until something stops it.
    Running,
    /// Until what the next block calls has returned.
    Over,
    /// Until the selected block.
    ToSelected,
}

/// Where a run stops by itself.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Goal {
    None,
    /// No more than so many calls within one another.
    Depth(usize),
    Block(BlockPlace),
}

/// A run.
#[derive(Debug)]
pub struct Run {
    machine: Machine,
    state: State,
    goal: Goal,
    /// Why it waits.
    reason: Message,
    fault: Option<Fault>,
    /// The remarks that are listed, by number, and how many were looked through. That a value given here stands in
    /// place of the program's is what was asked for, and is none.
    listed: Vec<usize>,
    looked_through: usize,
    /// The parameters before the last command.
    before: Variables,
}

impl Run {
    fn new(machine: Machine) -> Self {
        let before = machine.variables().clone();
        let reason = Message::new("program-page-state-step");
        Self {
            machine,
            state: State::Paused,
            goal: Goal::None,
            reason,
            fault: None,
            listed: Vec::new(),
            looked_through: 0,
            before,
        }
    }

    /// What it does.
    pub const fn state(&self) -> State {
        self.state
    }

    /// Whether it is over.
    pub fn is_over(&self) -> bool {
        matches!(self.state, State::Ended | State::Faulted)
    }

    /// The error that it ended with.
    pub const fn fault(&self) -> Option<&Fault> {
        self.fault.as_ref()
    }

    /// The block that runs next, or the one that failed; `None` after the end.
    pub fn place(&self) -> Option<BlockPlace> {
        match (&self.fault, self.state) {
            (Some(fault), _) => Some(fault.place.clone()),
            (None, State::Ended) => None,
            (None, _) => Some(self.machine.place()),
        }
    }

    /// The blocks that called, outermost first, and the one that runs next. Calls of labels are among them.
    pub fn calls(&self) -> impl Iterator<Item = BlockPlace> {
        self.machine.calls().iter().map(|call| call.from.clone()).chain(self.place())
    }

    /// The programs that called one another, outermost first, without repeats behind one another.
    pub fn programs(&self) -> Vec<NcPath> {
        let mut programs: Vec<_> = self.calls().map(|place| place.program).collect();
        programs.dedup();
        programs
    }

    pub(super) fn program(&self, path: &NcPath) -> Option<Arc<Program>> {
        self.machine.program(&path.to_string()).cloned()
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

    /// The worst status of what was measured.
    pub fn status(&self) -> Option<Status> {
        self.machine.status()
    }

    /// Whether the ball's centre has gone any way.
    pub fn has_path(&self) -> bool {
        !self.machine.path().is_empty()
    }

    /// The way of the ball's centre, the last [`MOST_MOVES`] moves.
    pub fn path(&self) -> Vec<Move> {
        let path = self.machine.path();
        let first = path.len().saturating_sub(MOST_MOVES);
        path.get(first..).unwrap_or_default().iter().map(as_move).collect()
    }

    /// How many remarks there are about the run.
    pub const fn remark_count(&self) -> usize {
        self.listed.len()
    }

    /// A remark by its number.
    pub fn remark(&self, number: usize) -> Option<&(BlockPlace, Remark)> {
        self.machine.remarks().get(*self.listed.get(number)?)
    }

    /// How many remarks are not listed.
    pub const fn unlisted_remarks(&self) -> usize {
        self.machine.unlisted_remarks()
    }

    /// How many blocks were run.
    pub const fn blocks_run(&self) -> u64 {
        self.machine.blocks_run()
    }

    pub(super) fn toggle_breakpoint(&mut self, place: &BlockPlace) {
        self.machine.toggle_breakpoint(&place.program.to_string(), place.block);
    }

    fn pause(&mut self, id: &'static str) {
        self.pause_because(Message::new(id));
    }

    fn pause_because(&mut self, reason: Message) {
        (self.state, self.reason, self.goal) = (State::Paused, reason, Goal::None);
    }

    /// Runs one block.
    fn step(&mut self) {
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
            Ok(Step::Ended) => (self.state, self.goal) = (State::Ended, Goal::None),
            Ok(Step::Paused(pause)) => self.pause_because(reason(&pause)),
            Err(fault) => {
                (self.state, self.goal) = (State::Faulted, Goal::None);
                self.fault = Some(fault);
            }
        }
    }

    /// Runs a slice. `is_first` is whether the run begins or goes on with it: then a breakpoint was seen already.
    fn slice(&mut self, blocks: u64, is_first: bool, breakpoints: &BTreeSet<BlockPlace>) {
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

    /// Why the run pauses here, where it has come as far as it should.
    fn goal_reached(&self) -> Option<&'static str> {
        let (reached, reason) = match &self.goal {
            Goal::None => (false, ""),
            Goal::Depth(depth) => (self.machine.calls().len() <= *depth, "program-page-state-over"),
            Goal::Block(place) => (self.machine.place() == *place, "program-page-state-goal"),
        };
        reached.then_some(reason)
    }
}

/// A move as it is drawn: a block of the program is one on the way to the next touch.
fn as_move(travel: &Travel) -> Move {
    let (phase, touch) = match travel.kind {
        TravelKind::Cycle(phase) => (phase, None),
        TravelKind::Rapid | TravelKind::Feed => (Phase::PrePosition, None),
    };
    Move { phase, touch, from: travel.from, to: travel.to, about: travel.about }
}

fn reason(pause: &Pause) -> Message {
    match pause {
        Pause::Stop => Message::new("program-page-state-stop"),
        Pause::OptionalStop => Message::new("program-page-state-optional-stop"),
        Pause::Breakpoint => Message::new("program-page-state-breakpoint"),
        Pause::Tolerance(stop) => Message::new("program-page-state-tolerance").message("stop", stop.message()),
        Pause::Log => Message::new("program-page-state-log"),
    }
}

impl ProgramPage {
    /// What the run does and why it waits, in a sentence.
    pub fn state_message(&self) -> Message {
        if let Some(refused) = &self.refused {
            return refused.clone();
        }
        match &self.run {
            None => Message::new("program-page-state-ready"),
            Some(run) => match run.state {
                State::Running => Message::new("program-page-state-running"),
                State::Paused => run.reason.clone(),
                State::Ended => Message::new("program-page-state-ended").text("blocks", run.blocks_run()),
                State::Faulted => Message::new("program-page-state-fault"),
            },
        }
    }

    /// Whether a run goes on, so that the window has to ask for slices.
    pub fn is_running(&self) -> bool {
        self.run.as_ref().is_some_and(|run| run.state == State::Running)
    }

    /// The current block comes into sight and is the selected one.
    fn follow(&mut self) {
        // A program that measured or opened a window names its parameters, also after it has returned.
        let places = self.run.as_ref().map(|run| {
            let (cycle, window) = (run.cycles().last(), run.windows().last());
            [cycle.map(|cycle| cycle.place.program.clone()), window.map(|window| window.place.program.clone())]
        });
        for path in places.into_iter().flatten().flatten() {
            self.know(&path);
        }
        if let Some(place) = self.run.as_ref().and_then(Run::place) {
            self.look_at(&place, true);
        }
    }

    /// A hole's or a shaft's workpiece at the inputs' centre.
    fn round(feature: Feature, centre: [Length; 2], diameter: Length) -> Contacts {
        let workpiece = Workpiece::round(feature, centre.map(Length::to_mm_f64), diameter.to_mm_f64());
        let surface = Surface::Round(workpiece, Plane::Xy);
        Contacts::Workpiece(Bench::perfect(surface))
    }

    fn field_length(&self, field: ProgramField) -> Result<Length, Message> {
        let text = self.text(field);
        // An empty centre is the one that the program expects.
        let expected = match field {
            ProgramField::WorkpieceX => Some(Input::CentreX),
            ProgramField::WorkpieceY => Some(Input::CentreY),
            _ => None,
        };
        match expected {
            Some(input) if text.trim().is_empty() => Ok(self.input_length(input).unwrap_or_default()),
            _ => length(text),
        }
    }
}

impl Session {
    /// A machine before the first block, or why there is none.
    fn new_run(&mut self, now: DateTime) -> Result<Run, Message> {
        let page = &self.program;
        let unreadable = || Message::new("program-page-refused-inputs");
        if page.errors.keys().any(|field| matches!(field, ProgramField::Input(_))) {
            return Err(unreadable());
        }
        let document = page.main().ok_or_else(|| Message::new("program-page-refused-none"))?;
        let (path, program) = (document.path().to_string(), Arc::clone(document.program()));
        let contacts = self.program_contacts()?;
        let page = &self.program;
        let folders = match &page.origin {
            Some(Origin::File(path)) => path.parent().map_or_else(Folders::new, |folder| {
                // A bare file name lies in the folder that Fitcheck was started in.
                let here = folder.as_os_str().is_empty();
                Folders::new().reading(if here { std::path::Path::new(".") } else { folder })
            }),
            _ => Folders::new(),
        };
        let mut settings = Settings::new(self.language, now);
        settings.skip_unknown = page.switches.skip_unknown;
        settings.block_skip = page.switches.block_skip;
        settings.optional_stop = page.switches.optional_stop;
        let mut machine = Machine::new(&path, program, folders, contacts, settings);
        for (parameter, value) in page.changed_inputs() {
            machine.set(parameter, value).map_err(|fault| fault.message())?;
        }
        for (parameter, value) in &page.given {
            machine.set(*parameter, value.clone()).map_err(|fault| fault.message())?;
        }
        for place in &page.breakpoints {
            machine.toggle_breakpoint(&place.program.to_string(), place.block);
        }
        Ok(Run::new(machine))
    }

    fn program_contacts(&mut self) -> Result<Contacts, Message> {
        let limits = self.program_limits().and_then(Result::ok);
        let page = &mut self.program;
        let centre = [Input::CentreX, Input::CentreY].map(|input| page.input_length(input).unwrap_or_default());
        match page.workpiece {
            WorkpieceFrom::Perfect => {
                Ok(limits
                    .map_or(Contacts::Perfect, |limits| ProgramPage::round(limits.feature, centre, limits.middle())))
            }
            WorkpieceFrom::Given => {
                let mut read = |field| {
                    let result = page.field_length(field);
                    if let Err(problem) = &result {
                        page.errors.insert(field, problem.clone());
                    }
                    result.map_err(|_told| Message::new("program-page-refused-workpiece"))
                };
                let diameter = read(ProgramField::Diameter)?;
                let centre = [read(ProgramField::WorkpieceX)?, read(ProgramField::WorkpieceY)?];
                let feature = limits.map_or(Feature::Hole, |limits| limits.feature);
                Ok(ProgramPage::round(feature, centre, diameter))
            }
            WorkpieceFrom::Simulated => match self.cycles.bench().bench() {
                Some(bench) => Ok(Contacts::Workpiece(*bench)),
                None => Err(Message::new("program-page-refused-workpiece")),
            },
            WorkpieceFrom::Recorded => match self.cycles.recorded() {
                Some(recorded) => Ok(Contacts::Recorded(recorded.contacts.clone())),
                None => Err(Message::new("program-page-refused-no-contacts")),
            },
        }
    }

    /// The run that a command is for: the one that waits, or a new one. A run that is over stays until it is reset.
    fn ready_run(&mut self, now: DateTime) -> Option<&mut Run> {
        self.program.refused = None;
        if self.program.run.is_none() {
            match self.new_run(now) {
                Ok(run) => self.program.run = Some(run),
                Err(refused) => {
                    self.program.refused = Some(refused);
                    return None;
                }
            }
        }
        let run = self.program.run.as_mut()?;
        run.before = run.machine.variables().clone();
        Some(run)
    }

    pub(super) fn start_or_go_on(&mut self, now: DateTime, mode: Mode) {
        // A run that is over begins anew.
        if self.program.run.as_ref().is_some_and(Run::is_over) {
            self.program.run = None;
        }
        let selected = self
            .program
            .shown()
            .map(|document| BlockPlace { program: document.path().clone(), block: document.selected() });
        let speed = self.program.speed;
        let Some(run) = self.ready_run(now) else { return };
        if run.state == State::Running {
            return;
        }
        run.goal = match (mode, selected) {
            (Mode::Running, _) => Goal::None,
            (Mode::Over, _) => Goal::Depth(run.machine.calls().len()),
            (Mode::ToSelected, Some(place)) => Goal::Block(place),
            (Mode::ToSelected, None) => return,
        };
        run.state = State::Running;
        self.slice(speed.blocks(), true);
    }

    pub(super) fn step_program(&mut self, now: DateTime) {
        let Some(run) = self.ready_run(now) else { return };
        if run.is_over() {
            return;
        }
        // A single block out of a run that goes on pauses it.
        run.pause("program-page-state-step");
        run.step();
        self.program.follow();
    }

    pub(super) fn tick_program(&mut self) {
        if self.program.is_running() {
            self.slice(self.program.speed.blocks(), false);
        }
    }

    fn slice(&mut self, blocks: u64, is_first: bool) {
        let page = &mut self.program;
        let Some(run) = &mut page.run else { return };
        run.slice(blocks, is_first, &page.breakpoints);
        let is_watched = page.speed != Speed::Fast;
        if !page.is_running() || is_watched {
            page.follow();
        }
    }

    pub(super) fn pause_program(&mut self) {
        if let Some(run) = self.program.run.as_mut().filter(|run| run.state == State::Running) {
            run.pause("program-page-state-paused");
            self.program.follow();
        }
    }

    /// Back to before the first block. The open program is shown again.
    pub(super) fn reset_program(&mut self) {
        let page = &mut self.program;
        (page.run, page.refused) = (None, None);
        let main = page.main.clone();
        page.documents.retain(|path, _| Some(path) == main.as_ref());
        if page.shown != main {
            page.shown = main;
            page.looks = page.looks.wrapping_add(1);
            page.look = 0;
        }
    }
}
