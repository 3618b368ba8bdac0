//! What a row of the table says about an action, and the usual kinds of rows.

use super::possible::free_dialog;
use super::{Part, Place, Shortcut};
use crate::{Command, Page, Session};

/// A row of the table.
pub(super) struct Row {
    /// The id of its text.
    pub text: &'static str,
    /// The id of a further explanation.
    pub hint: Option<&'static str>,
    pub place: Place,
    pub keys: [Option<Shortcut>; 2],
    pub possible: fn(&Session) -> bool,
    pub sends: Sends,
}

/// What an action sends.
pub(super) enum Sends {
    Always(Command),
    /// A command that depends on the state: a switch is turned to its other side.
    FromState(fn(&Session) -> Command),
}

impl Sends {
    pub fn command(self, session: &Session) -> Command {
        match self {
            Self::Always(command) => command,
            Self::FromState(command) => command(session),
        }
    }
}

impl Row {
    pub fn new(place: Place, text: &'static str, sends: Sends) -> Self {
        Self { text, hint: None, place, keys: [None; 2], possible: |_| true, sends }
    }

    pub fn when(self, possible: fn(&Session) -> bool) -> Self {
        Self { possible, ..self }
    }

    pub fn hint(self, hint: &'static str) -> Self {
        Self { hint: Some(hint), ..self }
    }

    pub fn key(self, key: Shortcut) -> Self {
        Self { keys: [Some(key), None], ..self }
    }

    pub fn keys(self, first: Shortcut, second: Shortcut) -> Self {
        Self { keys: [Some(first), Some(second)], ..self }
    }
}

pub(super) fn everywhere(text: &'static str, command: Command) -> Row {
    Row::new(Place::Everywhere, text, Sends::Always(command))
}

pub(super) fn switch(text: &'static str, command: fn(&Session) -> Command) -> Row {
    Row::new(Place::Everywhere, text, Sends::FromState(command))
}

pub(super) fn of_workpiece(text: &'static str, command: impl Into<Command>) -> Row {
    Row::new(Place::Workpiece, text, Sends::Always(command.into()))
}

pub(super) fn on(page: Page, text: &'static str, command: impl Into<Command>) -> Row {
    Row::new(Place::Page(page), text, Sends::Always(command.into()))
}

pub(super) fn within(part: Part, text: &'static str, command: impl Into<Command>) -> Row {
    Row::new(Place::Part(part), text, Sends::Always(command.into()))
}

/// In the file dialog, while it waits for nothing.
pub(super) fn in_dialog(text: &'static str, command: impl Into<Command>) -> Row {
    Row::new(Place::Dialog, text, Sends::Always(command.into())).when(|session| free_dialog(session).is_some())
}
