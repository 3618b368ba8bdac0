//! How commands and news change the cycles page.

use fitcheck_core::message::message;
use jiff::civil::DateTime;

use super::{ContactsFrom, CycleField, CyclesCommand, CyclesPage};
use crate::command::Effect;
use crate::shared::{News, PageState, Shared};

impl PageState for CyclesPage {
    type Command = CyclesCommand;

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
                (self.probes, self.probe) = (None, None);
                self.changed();
            }
            CyclesCommand::ProbesRead { name, result } => {
                if let Some(table) = shared.file_answered(result) {
                    let details = table.warnings.iter().map(fitcheck_core::message::Say::message).collect();
                    shared.note_details(message!("cycles-probes-loaded").text("name", &name), details);
                    (self.probes, self.probe) = (Some((name, table)), None);
                    self.changed();
                }
            }
            CyclesCommand::Run => self.measure(shared, now),
            CyclesCommand::Clear => self.clear(),
            CyclesCommand::Step(step) => self.go(step),
            CyclesCommand::StepTo(number) => self.step = number.min(self.last()),
            CyclesCommand::ShowBlock(is_open) => {
                self.block = is_open.then(|| self.block.take().unwrap_or_default());
                self.block_problem = None;
            }
            CyclesCommand::TypeBlock(text) => (self.block, self.block_problem) = (Some(text), None),
            CyclesCommand::TakeBlock => self.take_block(),
            CyclesCommand::CopyBlock => match self.written(shared.language.dialogue()) {
                Ok(block) => return vec![Effect::Copy(block)],
                Err(problem) => shared.tell(problem),
            },
            CyclesCommand::CopyResults => return self.results_text().map(Effect::Copy).into_iter().collect(),
            CyclesCommand::CopyStatus => {
                let window = self.window(shared.drawn_with());
                return window.and_then(Result::ok).map(Effect::Copy).into_iter().collect();
            }
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, _shared: &mut Shared) {
        match news {
            // Other sources do not use the workpiece.
            News::Workpiece if self.from == ContactsFrom::Simulated => self.changed(),
            News::WorkpieceTaken => self.take_from(ContactsFrom::Simulated),
            News::Tools => self.changed(),
            News::ContactsTaken => self.take_from(ContactsFrom::Recorded),
            _ => {}
        }
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
        (self.run, self.step) = (None, 0);
    }
}
