//! Run, pause, single block, to the selected block: what commands make of the run.

use std::sync::Arc;

use jiff::civil::DateTime;

use super::run::{Goal, Run, State};
use super::{Origin, ProgramField, ProgramPage, Speed};
use crate::message::{Message, Say as _};
use crate::nc::machine::{BlockPlace, Folders, Machine, Settings};
use crate::session::Session;

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
        let mut settings = Settings::new(self.language.dialogue(), now);
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
