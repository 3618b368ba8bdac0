//! What can be done on the cycles page.

use fitcheck_core::message::message;
use fitcheck_core::probing::cycles::CYCLES;
use fitcheck_core::words::Words;

use super::CyclesCommand;
use crate::Session;
use crate::action::row::{ActionRow, Actions, actions, keys, on};
use crate::action::{Held, Key, Shortcut};
use crate::command::Command;
use crate::field::Field;
use crate::page::Page;
use crate::purpose::{CycleFile, Purpose};
use crate::step::Step;

actions! {
    /// What can be done on the cycles page.
    CyclesAction

    /// Chooses a cycle, by its place among all.
    ChooseCycle(usize): 0..CYCLES.len();
    RunCycle;
    /// Clears the result.
    ClearCycle;
    /// Steps along the path.
    StepPath(Step): Step::PATH;
    /// Reads a touch-probe table.
    OpenProbes;
    /// Takes the built-in touch-probe table.
    ShippedProbes;
    /// Opens the field for an NC block.
    PasteBlock;
    /// Fills the form from the NC block.
    TakeBlock;
    /// Puts the form as an NC block on the clipboard.
    CopyBlock;
    /// Puts the status window's text on the clipboard.
    CopyCycleStatus;
    /// Puts the results on the clipboard.
    CopyResults;
    /// Writes the measuring log.
    SaveLog;
}

impl Actions for CyclesAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::ChooseCycle(place) => {
                let number = CYCLES.get(place).map_or(0, |cycle| cycle.number);
                on(Page::Cycles, "cycles-choose", CyclesCommand::Choose(number))
            }
            Self::RunCycle => on(Page::Cycles, "cycles-run", CyclesCommand::Run).key(Shortcut::plain(Key::Function(5))),
            Self::ClearCycle => on(Page::Cycles, "clear", CyclesCommand::Clear),
            Self::StepPath(step) => {
                let (text, possible): (_, fn(&Session) -> bool) = match step {
                    Step::First => ("cycles-first", is_after_first),
                    Step::Left => ("cycles-back", is_after_first),
                    Step::Right => ("cycles-next", is_before_last),
                    _ => ("cycles-last", is_before_last),
                };
                let row = on(Page::Cycles, text, CyclesCommand::Step(step)).when(possible);
                row.key(Shortcut { held: Held::Alt, ..keys(step) })
            }
            Self::OpenProbes => on(Page::Cycles, "cycles-open-probes", open(Purpose::OpenCycleFile(CycleFile::Probes))),
            Self::ShippedProbes => on(Page::Cycles, "cycles-shipped-probes", CyclesCommand::ShippedProbes)
                .when(|session| session.cycles().probes_name().is_some()),
            Self::PasteBlock => on(Page::Cycles, "cycles-paste-block", CyclesCommand::ShowBlock(true)),
            Self::TakeBlock => on(Page::Cycles, "cycles-fill", CyclesCommand::TakeBlock)
                .when(|session| session.cycles().block.is_some()),
            Self::CopyBlock => on(Page::Cycles, "cycles-copy-block", CyclesCommand::CopyBlock)
                .when(|session| session.cycles().is_complete()),
            Self::CopyCycleStatus => on(Page::Cycles, "copy", CyclesCommand::CopyStatus)
                .when(|session| session.cycles().window(session.drawn_with()).is_some_and(|window| window.is_ok())),
            Self::CopyResults => on(Page::Cycles, "cycles-copy-results", CyclesCommand::CopyResults)
                .when(|session| session.cycles().run.as_ref().is_some_and(|run| run.found().is_some())),
            Self::SaveLog => on(Page::Cycles, "cycles-save-log", open(Purpose::SaveCycleLog))
                .when(|session| session.cycles().log().is_some()),
        }
    }

    fn name(&self, _session: &Session, words: &Words) -> Option<String> {
        let Self::ChooseCycle(place) = self else { return None };
        let cycle = CYCLES.get(*place)?;
        let name = cycle.name(words.language().dialogue());
        Some(words.say(&message!("cycles-choose").text("number", cycle.code).text("name", name)))
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        let Self::ChooseCycle(place) = self else { return None };
        Some(CYCLES.get(*place).is_some_and(|cycle| cycle.number == session.cycles().cycle.number))
    }

    fn on_enter(field: Field, page: Page) -> Option<Self> {
        matches!((field, page), (Field::Cycles(_), _) | (Field::Workpiece(_), Page::Cycles)).then_some(Self::RunCycle)
    }
}

const fn open(purpose: Purpose) -> Command {
    Command::OpenDialog(purpose)
}

fn is_after_first(session: &Session) -> bool {
    0 < session.cycles().step
}

fn is_before_last(session: &Session) -> bool {
    session.cycles().step < session.cycles().last()
}
