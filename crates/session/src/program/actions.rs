//! What can be done on the program page.

use fitcheck_core::message::message;
use fitcheck_core::words::Words;

use super::{ProgramCommand, ProgramField, Switch};
use crate::Session;
use crate::action::row::{ActionRow, Actions, actions, keys, on, within};
use crate::action::{Held, Key, Part, Shortcut};
use crate::command::Command;
use crate::field::Field;
use crate::page::Page;
use crate::purpose::Purpose;
use crate::step::Step;

/// The listing of the program.
pub const LISTING: Part = Part::list(Page::Program, "program-listing");

actions! {
    /// What can be done on the program page.
    ProgramAction

    /// Reads an NC program.
    OpenProgram;
    /// Reads a simulated part of several features.
    OpenPart;
    RunProgram;
    PauseProgram;
    /// Runs one block.
    StepProgram;
    /// Runs one block, including everything that it calls.
    StepOver;
    /// Runs up to the selected block.
    RunToSelected;
    /// Sets a breakpoint at the selected block, or removes it.
    ToggleBreakpoint;
    /// Goes back to before the first block.
    ResetProgram;
    /// Switches an option of the run on or off.
    Switch(Switch): Switch::ALL;
    /// Goes to another block.
    MoveBlock(Step): Step::BLOCKS;
    /// Gives a parameter a value at the next start.
    GiveValue;
    /// Shows the files with which a control measures for itself.
    CreateForControl;
    /// Writes them into a folder.
    CreateFiles;
}

impl Actions for ProgramAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::OpenProgram => on(Page::Program, "program-page-open", Command::OpenDialog(Purpose::OpenProgram))
                .key(Shortcut::ctrl('O')),
            Self::OpenPart => on(Page::Program, "program-page-open-part", Command::OpenDialog(Purpose::OpenPart)),
            Self::RunProgram => of_page("program-page-run", ProgramCommand::Run)
                .key(Shortcut::plain(Key::Function(5)))
                .when(|session| !session.program().is_running()),
            Self::PauseProgram => of_page("program-page-pause", ProgramCommand::Pause)
                .key(Shortcut::plain(Key::Escape))
                .when(|session| session.program().is_running()),
            Self::StepProgram => of_page("program-page-step", ProgramCommand::Step)
                .key(Shortcut::plain(Key::Function(10)))
                .when(can_step),
            Self::StepOver => of_page("program-page-step-over", ProgramCommand::StepOver)
                .key(Shortcut::shift(Key::Function(10)))
                .when(can_step),
            Self::RunToSelected => of_page("program-page-to-selected", ProgramCommand::RunToSelected)
                .key(Shortcut { held: Held::Ctrl, key: Key::Function(10) })
                .when(|session| !session.program().is_running()),
            Self::ToggleBreakpoint => of_page("program-page-breakpoint", ProgramCommand::ToggleBreakpoint(None))
                .key(Shortcut::plain(Key::Function(9))),
            Self::ResetProgram => of_page("program-page-reset", ProgramCommand::Reset)
                .key(Shortcut::shift(Key::Function(5)))
                .when(|session| session.program().run.is_some()),
            Self::Switch(switch) => {
                let text = match switch {
                    Switch::SkipUnknown => "program-page-skip-unknown",
                    Switch::AssumeTool => "program-page-assume-tool",
                    Switch::BlockSkip => "program-page-block-skip",
                    Switch::OptionalStop => "program-page-optional-stop",
                };
                of_page(text, ProgramCommand::Toggle(switch))
            }
            Self::MoveBlock(step) => within(LISTING, "program-page-move", ProgramCommand::Move(step)).key(keys(step)),
            Self::GiveValue => of_page("program-page-give", ProgramCommand::SetValue).hint("program-page-give-hint"),
            Self::CreateForControl => of_page("program-page-create", ProgramCommand::ShowCreating)
                .hint("program-page-create-hint")
                .also("program-page-create-also"),
            Self::CreateFiles => {
                on(Page::Program, "program-page-create-files-none", Command::OpenDialog(Purpose::CreateSet))
                    .when(|session| session.program().creating.set().is_some())
            }
        }
    }

    fn name(&self, session: &Session, words: &Words) -> Option<String> {
        let Self::CreateFiles = self else { return None };
        let set = session.program().creating.set()?;
        Some(words.say(&message!("program-page-create-files").count("count", set.files.len())))
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        match *self {
            Self::Switch(switch) => Some(session.program().is_on(switch)),
            _ => None,
        }
    }

    fn on_enter(field: Field, page: Page) -> Option<Self> {
        match (field, page) {
            (Field::Program(ProgramField::Filter), _) => None,
            (Field::Program(ProgramField::Name | ProgramField::Value), _) => Some(Self::GiveValue),
            (Field::Program(_), _) | (Field::Workpiece(_), Page::Program) => Some(Self::RunProgram),
            _ => None,
        }
    }
}

fn of_page(text: &'static str, command: ProgramCommand) -> ActionRow {
    on(Page::Program, text, command)
}

/// Whether a block can be run: the next one, or the first one after the end.
fn can_step(session: &Session) -> bool {
    !session.program().is_running()
}
