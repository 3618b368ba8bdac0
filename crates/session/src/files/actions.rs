//! What can be done in the file dialog.

use super::FilesCommand;
use crate::Session;
use crate::action::possible::{asks_to_replace, free_dialog};
use crate::action::row::{ActionRow, Actions, Sends, actions, keys};
use crate::action::{ActionScope, Held, Key, Shortcut};
use crate::command::Command;
use crate::step::Step;

actions! {
    /// What can be done in the file dialog.
    FilesAction

    /// Shows the system's file dialog.
    Browse;
    /// Shows the folder above.
    FolderUp;
    /// Shows the user's own folder.
    HomeFolder;
    /// Shows all files of the folder, or only those of the kind that is asked for.
    AllFiles;
    /// Goes to another entry of the folder.
    MoveFile(Step): Step::ENTRIES;
    /// Writes over the file that exists.
    ReplaceFile;
    /// Keeps the file that exists.
    KeepFile;
}

impl Actions for FilesAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::Browse => in_dialog("dialog-browse", Command::Browse).hint("dialog-browse-hint"),
            Self::FolderUp => in_dialog("dialog-up", FilesCommand::Up)
                .key(Shortcut { held: Held::Alt, key: Key::Up })
                .when(|session| free_dialog(session).is_some_and(|dialog| dialog.list.parent().is_some())),
            Self::HomeFolder => in_dialog("dialog-home", FilesCommand::Home)
                .key(Shortcut { held: Held::Alt, key: Key::Home })
                .when(|session| free_dialog(session).is_some() && session.home().is_some()),
            Self::AllFiles => ActionRow::new(
                ActionScope::Dialog,
                "dialog-all-files",
                Sends::FromState(|session| {
                    FilesCommand::ShowAll(!free_dialog(session).is_some_and(|dialog| dialog.list.shows_all)).into()
                }),
            )
            .when(|session| free_dialog(session).is_some()),
            Self::MoveFile(step) => in_dialog("dialog-move", FilesCommand::Move(step))
                .key(keys(step))
                .when(|session| free_dialog(session).is_some_and(|dialog| !dialog.list.is_empty())),
            Self::ReplaceFile => {
                ActionRow::new(ActionScope::Dialog, "dialog-replace", Sends::Always(FilesCommand::Replace(true).into()))
                    .when(asks_to_replace)
            }
            Self::KeepFile => {
                ActionRow::new(ActionScope::Dialog, "dialog-keep", Sends::Always(FilesCommand::Replace(false).into()))
                    .when(asks_to_replace)
            }
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        (*self == Self::AllFiles).then(|| session.dialog().is_some_and(|dialog| dialog.list.shows_all))
    }
}

/// While the dialog waits for nothing.
fn in_dialog(text: &'static str, command: impl Into<Command>) -> ActionRow {
    ActionRow::new(ActionScope::Dialog, text, Sends::Always(command.into()))
        .when(|session| free_dialog(session).is_some())
}
