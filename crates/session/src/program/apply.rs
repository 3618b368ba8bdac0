//! How commands and news change the program page.

use fitcheck_core::message::Message;
use fitcheck_nc::machine::{BlockPlace, NcPath};
use jiff::civil::DateTime;

use super::running::Mode;
use super::{ProgramCommand, ProgramPage, Run, Switch, WorkpieceFrom};
use crate::Step;
use crate::effect::Effect;
use crate::page::Page;
use crate::program::ProgramField;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;

/// How many blocks make a page.
const PAGE: usize = 20;

impl PageState for ProgramPage {
    type Command = ProgramCommand;
    type Field = ProgramField;

    fn restored(_saved: &Saved, _shared: &Shared) -> Self {
        Self::default()
    }

    fn apply(&mut self, command: ProgramCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        match command {
            ProgramCommand::OpenShipped(name) => {
                self.opened = self.opened.wrapping_add(1);
                self.open_shipped(name, shared);
            }
            ProgramCommand::Read { path, result } => self.program_read(path, result, shared),
            ProgramCommand::Type(field, text) => self.type_text(field, text),
            ProgramCommand::ChooseWorkpiece(from) => self.choose_workpiece(from, shared),
            ProgramCommand::Run => self.start_or_go_on(shared, now, Mode::Running),
            ProgramCommand::Step => self.step(shared, now),
            ProgramCommand::StepOver => self.start_or_go_on(shared, now, Mode::Over),
            ProgramCommand::RunToSelected => self.start_or_go_on(shared, now, Mode::ToSelected),
            ProgramCommand::Tick => self.tick(),
            ProgramCommand::Pause => self.pause(),
            ProgramCommand::Reset => self.reset(),
            ProgramCommand::SetSpeed(speed) => self.speed = speed,
            ProgramCommand::Toggle(switch) => self.toggle(switch),
            ProgramCommand::ToggleBreakpoint(block) => self.toggle_breakpoint(block),
            ProgramCommand::Select(block) => {
                if let Some(document) = self.shown_mut() {
                    document.select(block);
                }
            }
            ProgramCommand::Move(step) => self.go(step),
            ProgramCommand::ShowProgram(path) => self.show_program(path),
            ProgramCommand::GoTo(place) => self.look_at(&place, true),
            ProgramCommand::Pin(parameter, true) => _ = self.pinned.insert(parameter),
            ProgramCommand::Pin(parameter, false) => _ = self.pinned.remove(&parameter),
            ProgramCommand::SetValue => self.give_value(),
            ProgramCommand::DropValue(parameter) => self.drop_value(parameter),
            ProgramCommand::ShowCreating => {
                if shared.page != Page::Program {
                    shared.open(Page::Program);
                }
                self.creating.come_into_sight();
            }
            ProgramCommand::CreateFor(control) => self.creating.control = control,
            ProgramCommand::CreateIn(language) => self.creating.choose_language(language),
            ProgramCommand::CreateFrom(from) => self.creating.choose_source(from),
            ProgramCommand::CreateSeries(is_series) => self.creating.is_series = is_series,
            ProgramCommand::CreateByText(by_text) => self.creating.by_text = by_text,
            ProgramCommand::CreateShow(name) => self.creating.shown = name,
        }
        self.keep_new(shared);
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        match news {
            News::Opened(Page::Program) => self.opened(shared),
            News::Workpiece | News::WorkpieceTaken => self.workpiece_changed(WorkpieceFrom::Simulated, shared),
            News::ContactsTaken => self.contacts_taken(shared),
            News::PartTaken => self.workpiece_changed(WorkpieceFrom::Part, shared),
            News::Tools => self.reset(),
            // These two are made by the limits.
            News::Sources if matches!(self.workpiece, WorkpieceFrom::Perfect | WorkpieceFrom::Given) => self.reset(),
            _ => {}
        }
    }

    fn text(&self, field: ProgramField) -> &str {
        let typed = match field {
            ProgramField::Input(input) => self.typed.get(&input.parameter()),
            ProgramField::Tool(parameter) => self.typed.get(&parameter),
            _ => None,
        };
        typed.or_else(|| self.texts.get(&field)).map_or("", String::as_str)
    }

    fn error(&self, field: ProgramField) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn is_free_text(&self, field: ProgramField) -> bool {
        match field {
            ProgramField::Tool(parameter) => parameter.family.is_text(),
            field => matches!(field, ProgramField::Filter | ProgramField::Name | ProgramField::Value),
        }
    }
}

impl ProgramPage {
    fn toggle(&mut self, switch: Switch) {
        if !self.switches.remove(&switch) {
            self.switches.insert(switch);
        }
        self.reset();
    }

    fn toggle_breakpoint(&mut self, block: Option<usize>) {
        let Some(document) = self.shown() else { return };
        let block = block.unwrap_or(document.selected);
        if document.program.blocks().len() <= block {
            return;
        }
        let place = BlockPlace { program: document.path.clone(), block };
        if !self.breakpoints.remove(&place) {
            self.breakpoints.insert(place.clone());
        }
        if let Some(run) = &mut self.run {
            run.toggle_breakpoint(&place);
        }
    }

    fn go(&mut self, step: Step) {
        let Some(document) = self.shown() else { return };
        let here = document.selected;
        let last = document.program.blocks().len().saturating_sub(1);
        let block = match step {
            Step::Up => here.saturating_sub(1),
            Step::Down => here + 1,
            Step::PageUp => here.saturating_sub(PAGE),
            Step::PageDown => here + PAGE,
            Step::First | Step::Top => 0,
            Step::Last | Step::Bottom => last,
            Step::Left | Step::Right => here,
        };
        let place = BlockPlace { program: document.path.clone(), block: block.min(last) };
        self.look_at(&place, true);
    }

    /// Shows a program of the call stack at the block that calls, or that runs next.
    fn show_program(&mut self, path: NcPath) {
        let calls = self.run.iter().flat_map(Run::calls);
        let place = calls.filter(|place| place.program == path).last();
        let block = self.documents.get(&path).map_or(0, |document| document.selected);
        self.look_at(&place.unwrap_or(BlockPlace { program: path, block }), false);
    }
}
