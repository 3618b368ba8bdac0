//! How commands and news change the cycles page.

use fitcheck_core::message::{Message, message};
use fitcheck_core::probing::cycle;
use jiff::civil::DateTime;

use super::{ContactsFrom, CycleField, CyclesAction, CyclesCommand, CyclesPage};
use crate::action::Action;
use crate::command::Command;
use crate::effect::Effect;
use crate::page::Page;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;

impl PageState for CyclesPage {
    type Command = CyclesCommand;
    type Field = CycleField;

    fn restored(saved: &Saved, _shared: &Shared) -> Self {
        let mut page = Self::default();
        page.restore(&saved.cycles);
        page
    }

    fn save(&self, saved: &mut Saved) {
        saved.cycles = self.saved();
    }

    fn apply(&mut self, command: CyclesCommand, shared: &mut Shared, now: DateTime) -> Vec<Effect> {
        match command {
            CyclesCommand::Choose(number) => self.choose(number),
            CyclesCommand::Type(field, text) => self.set(field, text),
            CyclesCommand::From(from) => self.take_from(from),
            CyclesCommand::ChooseProbe(number) => {
                self.probe = Some(number);
                self.changed();
            }
            CyclesCommand::ShippedProbes => {
                self.probes = None;
                self.probe = None;
                self.changed();
            }
            CyclesCommand::ProbesRead { name, result } => {
                if let Some(table) = shared.file_answered(result) {
                    let details = table.warnings.iter().map(fitcheck_core::message::Say::message).collect();
                    shared.note_details(message!("cycles-probes-loaded").text("name", &name), details);
                    self.probes = Some((name, table));
                    self.probe = None;
                    self.changed();
                }
            }
            CyclesCommand::Run => self.measure(shared, now),
            CyclesCommand::Clear => self.clear(),
            CyclesCommand::Step(step) => self.go(step),
            CyclesCommand::StepTo(number) => self.step = number.min(self.last()),
            CyclesCommand::ShowBlock(is_open) => {
                if is_open {
                    self.block.get_or_insert_default();
                } else {
                    self.block = None;
                }
                self.block_problem = None;
            }
            CyclesCommand::TypeBlock(text) => {
                self.block = Some(text);
                self.block_problem = None;
            }
            CyclesCommand::TakeBlock => self.take_block(),
            CyclesCommand::CopyBlock => match self.written(shared.language.dialogue()) {
                Ok(block) => {
                    shared.note(message!("cycles-block-copied"), Vec::new());
                    return vec![Effect::Copy(block)];
                }
                Err(problem) => shared.tell(problem),
            },
            CyclesCommand::CopyResults => return self.results_text().map(Effect::Copy).into_iter().collect(),
            CyclesCommand::CopyStatus => {
                return self.status_text(shared.drawn_with()).map(Effect::Copy).into_iter().collect();
            }
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        match news {
            // Other sources do not use the workpiece.
            // What another page has opened is chosen there alone: a cycle never measures it by itself.
            News::WorkpieceTaken if shared.page != Page::Program => self.take_from(ContactsFrom::Simulated),
            News::Workpiece | News::WorkpieceTaken if self.from == ContactsFrom::Simulated => self.changed(),
            News::Tools => self.changed(),
            News::ContactsTaken if shared.page != Page::Program => {
                self.recorded.clone_from(&shared.workpiece.recorded);
                self.take_from(ContactsFrom::Recorded);
            }
            _ => {}
        }
    }

    fn text(&self, field: CycleField) -> &str {
        let text = match field {
            CycleField::Parameter(key) => self.texts.get(&(self.cycle.number, key)),
            CycleField::Global(key) => self.globals.get(&(self.cycle.number, key)),
            CycleField::Position(axis) => self.position.get(&axis),
        };
        text.map_or("", String::as_str)
    }

    fn error(&self, field: CycleField) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn repeated(&self) -> Option<Action> {
        self.would_repeat().then_some(CyclesAction::RunCycle.into())
    }

    fn closes(&self) -> Option<Command> {
        self.block.as_deref().map(|_| CyclesCommand::ShowBlock(false).into())
    }

    fn is_free_text(&self, field: CycleField) -> bool {
        // A tool may be called by its name.
        let CycleField::Parameter(key) = field else { return false };
        self.cycle.parameter(key).is_some_and(|parameter| parameter.range == cycle::Range::Tool)
    }
}

impl CyclesPage {
    fn set(&mut self, field: CycleField, text: String) {
        match field {
            CycleField::Parameter(key) => _ = self.texts.insert((self.cycle.number, key), text),
            CycleField::Global(key) => _ = self.globals.insert((self.cycle.number, key), text),
            CycleField::Position(axis) => _ = self.position.insert(axis, text),
        }
        self.changed();
    }

    fn take_from(&mut self, from: ContactsFrom) {
        self.from = from;
        self.changed();
    }

    /// No result stays beside inputs that it was not made with.
    pub(super) fn changed(&mut self) {
        self.clear();
        self.read();
    }

    pub(super) fn clear(&mut self) {
        self.run = None;
        self.step = 0;
    }
}
