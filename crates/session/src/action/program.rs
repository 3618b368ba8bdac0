//! The rows of the program page in the table of actions.

use super::possible::can_step;
use super::row::{Row, on, within};
use super::{Held, Key, Part, Shortcut};
use crate::program::{ProgramCommand, Switch};
use crate::{Command, Page, Purpose, Step};

fn of_page(text: &'static str, command: ProgramCommand) -> Row {
    on(Page::Program, text, command)
}

pub(super) fn open_part() -> Row {
    on(Page::Program, "program-page-open-part", Command::OpenDialog(Purpose::OpenPart))
}

pub(super) fn open() -> Row {
    on(Page::Program, "program-page-open", Command::OpenDialog(Purpose::OpenProgram)).key(Shortcut::ctrl('O'))
}

pub(super) fn run() -> Row {
    of_page("program-page-run", ProgramCommand::Run)
        .key(Shortcut::plain(Key::Function(5)))
        .when(|session| !session.program().is_running())
}

pub(super) fn pause() -> Row {
    of_page("program-page-pause", ProgramCommand::Pause)
        .key(Shortcut::plain(Key::Escape))
        .when(|session| session.program().is_running())
}

pub(super) fn step() -> Row {
    of_page("program-page-step", ProgramCommand::Step).key(Shortcut::plain(Key::Function(10))).when(can_step)
}

pub(super) fn step_over() -> Row {
    of_page("program-page-step-over", ProgramCommand::StepOver).key(Shortcut::shift(Key::Function(10))).when(can_step)
}

pub(super) fn run_to_selected() -> Row {
    of_page("program-page-to-selected", ProgramCommand::RunToSelected)
        .key(Shortcut { held: Held::Ctrl, key: Key::Function(10) })
        .when(|session| !session.program().is_running())
}

pub(super) fn toggle_breakpoint() -> Row {
    of_page("program-page-breakpoint", ProgramCommand::ToggleBreakpoint(None)).key(Shortcut::plain(Key::Function(9)))
}

pub(super) fn reset() -> Row {
    of_page("program-page-reset", ProgramCommand::Reset)
        .key(Shortcut::shift(Key::Function(5)))
        .when(|session| session.program().run().is_some())
}

pub(super) fn switch(switch: Switch) -> Row {
    let text = match switch {
        Switch::SkipUnknown => "program-page-skip-unknown",
        Switch::AssumeTool => "program-page-assume-tool",
        Switch::BlockSkip => "program-page-block-skip",
        Switch::OptionalStop => "program-page-optional-stop",
    };
    of_page(text, ProgramCommand::Toggle(switch))
}

pub(super) fn go(step: Step) -> Row {
    within(Part::Listing, "program-page-move", ProgramCommand::Move(step))
}

pub(super) fn give_value() -> Row {
    of_page("program-page-give", ProgramCommand::SetValue).hint("program-page-give-hint")
}
