//! Run, pause, single block, to the selected block: what commands make of the run.

use std::sync::Arc;

use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_nc::machine::{BlockPlace, Machine, Settings, Shipped};
use jiff::civil::DateTime;

use super::run::{Goal, Run, State};
use super::{Origin, ProgramField, ProgramPage, Speed, Switch};
use crate::shared::Shared;

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

impl ProgramPage {
    /// What the run does and why it waits, in a sentence.
    pub fn state_message(&self) -> Message {
        if let Some(refused) = &self.refused {
            return refused.clone();
        }
        match &self.run {
            None => message!("program-page-state-ready"),
            Some(run) => match run.state {
                State::Running => message!("program-page-state-running"),
                State::Paused => run.reason.clone(),
                State::Ended => message!("program-page-state-ended").text("blocks", run.blocks_run()),
                State::Faulted => message!("program-page-state-fault"),
            },
        }
    }

    /// Whether a run goes on, so that the window has to ask for slices.
    pub fn is_running(&self) -> bool {
        self.run.as_ref().is_some_and(|run| run.state == State::Running)
    }

    /// Brings the current block into sight and selects it.
    fn follow(&mut self) {
        // A program that measured or opened a window names its parameters, even after it has returned.
        let places = self.run.as_ref().map(|run| {
            let cycle = run.cycles().last();
            let window = run.windows().last();
            [cycle.map(|cycle| cycle.place.program.clone()), window.map(|window| window.place.program.clone())]
        });
        for path in places.into_iter().flatten().flatten() {
            self.know(&path);
        }
        if let Some(place) = self.run.as_ref().and_then(Run::place) {
            self.look_at(&place, true);
        }
    }
}

impl ProgramPage {
    /// A machine before the first block, or why there is none.
    fn new_run(&mut self, shared: &Shared, now: DateTime) -> Result<Run, Message> {
        if self.errors.keys().any(|field| matches!(field, ProgramField::Input(_) | ProgramField::Tool(_))) {
            return Err(message!("program-page-refused-inputs"));
        }
        let document = self.main().ok_or_else(|| message!("program-page-refused-none"))?;
        let path = document.path.to_string();
        let program = Arc::clone(&document.program);
        let contacts = self.contacts(shared)?;
        let folders = match &self.origin {
            Some(Origin::File(path)) => (shared.program_files.0)(path),
            _ => Box::new(Shipped),
        };
        let mut settings = Settings::new(shared.language.dialogue(), now);
        settings.skip_unknown = self.is_on(Switch::SkipUnknown);
        settings.assumes_tool = self.is_on(Switch::AssumeTool);
        settings.block_skip = self.is_on(Switch::BlockSkip);
        settings.optional_stop = self.is_on(Switch::OptionalStop);
        settings.tool_table = shared.tool_table().cloned();
        let mut machine = Machine::new(&path, program, folders, contacts, settings);
        for (parameter, value) in &self.given {
            machine.set(*parameter, value.clone()).map_err(|fault| fault.message())?;
        }
        for place in &self.breakpoints {
            machine.toggle_breakpoint(place.clone());
        }
        Ok(Run::new(machine))
    }

    /// The run that a command is for: the one that waits, or a new one. A finished run stays until it is reset.
    fn ready_run(&mut self, shared: &Shared, now: DateTime) -> Option<&mut Run> {
        self.refused = None;
        if self.run.is_none() {
            match self.new_run(shared, now) {
                Ok(run) => self.run = Some(run),
                Err(refused) => {
                    self.refused = Some(refused);
                    return None;
                }
            }
        }
        let run = self.run.as_mut()?;
        run.before = run.machine.variables().clone();
        Some(run)
    }

    pub(super) fn start_or_go_on(&mut self, shared: &Shared, now: DateTime, mode: Mode) {
        // A finished run starts again.
        if self.run.as_ref().is_some_and(Run::is_over) {
            self.run = None;
        }
        let selected =
            self.shown().map(|document| BlockPlace { program: document.path.clone(), block: document.selected });
        let speed = self.speed;
        let Some(run) = self.ready_run(shared, now) else { return };
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

    pub(super) fn step(&mut self, shared: &Shared, now: DateTime) {
        // After the end it starts again, as a run does.
        if self.run.as_ref().is_some_and(Run::is_over) {
            self.run = None;
        }
        let Some(run) = self.ready_run(shared, now) else { return };
        // A single block during a run pauses the run.
        run.pause("program-page-state-step");
        run.step();
        self.follow();
    }

    pub(super) fn tick(&mut self) {
        if self.is_running() {
            self.slice(self.speed.blocks(), false);
        }
    }

    fn slice(&mut self, blocks: u64, is_first: bool) {
        let Some(run) = &mut self.run else { return };
        run.slice(blocks, is_first, &self.breakpoints);
        let is_watched = self.speed != Speed::Fast;
        if !self.is_running() || is_watched {
            self.follow();
        }
    }

    pub(super) fn pause(&mut self) {
        if let Some(run) = self.run.as_mut().filter(|run| run.state == State::Running) {
            run.pause("program-page-state-paused");
            self.follow();
        }
    }

    /// Back to before the first block. The open program is shown again.
    pub(super) fn reset(&mut self) {
        self.run = None;
        self.refused = None;
        let main = self.main.clone();
        self.documents.retain(|path, _| Some(path) == main.as_ref());
        if self.shown != main {
            self.shown = main;
            self.looks = self.looks.wrapping_add(1);
            self.look = 0;
        }
    }
}
