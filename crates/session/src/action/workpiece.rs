//! What can be done with the simulated workpiece, recorded contacts and the tool table, on the pages that measure with them.

use crate::action::ActionScope;
use crate::action::row::{ActionRow, Actions, Sends, actions};
use crate::command::Command;
use crate::purpose::{CycleFile, Purpose};
use crate::tools::ToolsCommand;
use crate::workpiece::WorkpieceCommand;

actions! {
    /// What can be done with the simulated workpiece, recorded contacts and the tool table, on the pages that measure with them.
    WorkpieceAction

    /// Opens the dialog of the simulated workpiece.
    EditWorkpiece;
    /// Makes a simulated workpiece that suits the page's inputs.
    SuitWorkpiece;
    /// Reads a simulated workpiece.
    OpenWorkpiece;
    /// Writes the simulated workpiece.
    SaveWorkpiece;
    /// Reads recorded contacts.
    OpenContacts;
    /// Reads a tool table.
    OpenTools;
    /// Monitors no tools.
    CloseTools;
    /// Writes the tool table as the run has changed it.
    SaveTools;
}

impl Actions for WorkpieceAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::EditWorkpiece => of_workpiece("cycles-workpiece", WorkpieceCommand::Show(true)),
            Self::SuitWorkpiece => of_workpiece("cycles-suit", WorkpieceCommand::Suit),
            Self::OpenWorkpiece => {
                of_workpiece("cycles-open-workpiece", open(Purpose::OpenCycleFile(CycleFile::Workpiece)))
            }
            Self::SaveWorkpiece => of_workpiece("cycles-save-workpiece", open(Purpose::SaveWorkpiece))
                .when(|session| session.workpiece().simulation.is_some()),
            Self::OpenContacts => {
                of_workpiece("cycles-open-contacts", open(Purpose::OpenCycleFile(CycleFile::Contacts)))
            }
            Self::OpenTools => of_workpiece("tools-open", open(Purpose::OpenTools)),
            Self::CloseTools => {
                of_workpiece("tools-close", ToolsCommand::Close).when(|session| session.tools().is_some())
            }
            Self::SaveTools => {
                of_workpiece("tools-save", open(Purpose::SaveTools)).when(|session| session.changed_tools().is_some())
            }
        }
    }
}

const fn open(purpose: Purpose) -> Command {
    Command::OpenDialog(purpose)
}

fn of_workpiece(text: &'static str, command: impl Into<Command>) -> ActionRow {
    ActionRow::new(ActionScope::Workpiece, text, Sends::Always(command.into()))
}
