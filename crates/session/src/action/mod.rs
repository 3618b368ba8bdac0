//! Everything that a user can do by menu, button or key: what it is called, its keys, where it applies, whether it is
//! possible now, and the command that it sends.
//!
//! The actions of a page are in its own folder. Here is what belongs to all of them:
//!
//! | file | what |
//! |---|---|
//! | here | what is asked of an action: its name, whether it is possible, its command |
//! | `row` | what is to be known of an action, and how a list of actions is written |
//! | `window`, `workpiece` | the actions of every page, and of the pages that measure a workpiece |
//! | `operator` | what an operator can do |
//! | `status` | the status window that is written as text |
//! | `possible` | conditions that several pages share |
//! | `place` | where an action applies |
//! | `shortcut` | keys, without a window |
//! | `keys` | which keys are heard and shown |
//!
//! Choices among what a user has (a class, a table of the list, a block) are not actions: they send commands.
//!
//! To add an action (menu, button or key):
//!
//! 1. Add a variant and its row to the `actions.rs` of its page, or to `window`: text, keys, where it applies, when it is possible, and
//!    the command that it sends.
//! 2. Add its texts to every folder of `assets/locales`.
//! 3. Name the action in one line of `gui/` where it is a button or an entry of a menu. Keys and tooltips follow from the row.
//! 4. Write a new key into the tables of `docs/manual/window.md`: the test `session_actions` compares them.

mod keys;
mod operator;
mod place;
pub(crate) mod possible;
pub(crate) mod row;
mod shortcut;
mod status;
pub(crate) mod window;
mod workpiece;

pub use place::{ActionScope, Keeps, Part};
pub use shortcut::{Held, Key, Shortcut};
pub use window::WindowAction;
pub use workpiece::WorkpieceAction;

use std::sync::LazyLock;

use fitcheck_core::words::Words;

use self::row::{ActionRow, Actions};
use super::columns::ColumnsCommand;
use super::field::Field;
use super::files::FilesAction;
use super::help::HelpCommand;
use super::page::pages;
use super::palette::PaletteCommand;
use super::settings_page::SettingsCommand;
use super::workpiece::WorkpieceCommand;
use super::{Command, Notice, Page, Session};

macro_rules! action {
    ($($(#[$doc:meta])* $page:ident: $folder:ident, $State:ident, $Command:ident, $Field:ident, $Action:ident, $name:literal, $manual:literal;)+) => {
        /// Something that a user can do by menu, button or key.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum Action {
            /// On every page.
            Window(WindowAction),
            /// In the file dialog.
            Files(FilesAction),
            /// On the pages that measure a workpiece.
            Workpiece(WorkpieceAction),
            $($(#[$doc])* $page(super::$folder::$Action),)+
        }

        impl Action {
            /// Every action, in the order of the pages.
            pub fn all() -> impl Iterator<Item = Self> {
                let window = WindowAction::all().map(Self::Window).chain(FilesAction::all().map(Self::Files));
                window$(.chain(super::$folder::$Action::all().map(Self::$page)))+
                    .chain(WorkpieceAction::all().map(Self::Workpiece))
            }

            fn list(&self) -> &dyn Actions {
                match self {
                    Self::Window(action) => action,
                    Self::Files(action) => action,
                    Self::Workpiece(action) => action,
                    $(Self::$page(action) => action,)+
                }
            }

            /// What Enter does in a text field of a page.
            pub fn on_enter(field: Field, page: Page) -> Option<Self> {
                let window = WindowAction::on_enter(field, page).map(Self::Window);
                window$(.or_else(|| super::$folder::$Action::on_enter(field, page).map(Self::$page)))+
            }
        }

        $(impl From<super::$folder::$Action> for Action {
            fn from(action: super::$folder::$Action) -> Self {
                Self::$page(action)
            }
        })+
    };
}

pages!(action);
from_variants!(Action: Window(WindowAction), Files(FilesAction), Workpiece(WorkpieceAction));

/// What takes the focus as a whole, on all pages.
static PARTS: LazyLock<Vec<Part>> = LazyLock::new(|| {
    let mut parts = Vec::new();
    for action in Action::all() {
        if let ActionScope::Part(part) = action.place()
            && !parts.contains(&part)
        {
            parts.push(part);
        }
    }
    parts
});

impl Part {
    /// The parts of a page that take keys.
    pub fn of(page: Page) -> impl Iterator<Item = Self> {
        PARTS.iter().copied().filter(move |part| part.page == page)
    }
}

impl Action {
    pub(crate) fn row(self) -> ActionRow {
        self.list().row()
    }

    /// Where it applies.
    pub fn place(self) -> ActionScope {
        self.row().place
    }

    /// Its name, in the words of a language.
    pub fn text(self, session: &Session, words: &Words) -> String {
        self.list().name(session, words).unwrap_or_else(|| words.get(self.row().text))
    }

    /// The id of a further explanation.
    pub fn hint(self) -> Option<&'static str> {
        self.row().hint
    }

    /// Whether what it switches is on, where it switches something.
    pub fn is_on(self, session: &Session) -> Option<bool> {
        self.list().is_on(session)
    }

    /// The command that it sends now; `None` where it is not possible.
    pub fn command(self, session: &Session) -> Option<Command> {
        if session.can(self) { self.row().sends.command(session) } else { None }
    }
}

impl Session {
    /// Whether something can be done now.
    pub fn can(&self, action: impl Into<Action>) -> bool {
        let action = action.into();
        (!self.is_for_operators() || action.is_for_operators()) && (action.row().possible)(self)
    }

    /// How many listed checks are not good.
    fn bad_count(&self) -> usize {
        self.history().listed().bad()
    }

    /// The command that closes the topmost thing over the page.
    fn uppermost(&self) -> Option<Command> {
        if let Some(palette) = &self.palette {
            let back = if palette.shows_more { PaletteCommand::More(false) } else { PaletteCommand::Show(false) };
            Some(back.into())
        } else if self.settings_page().asks_for_pin() {
            Some(SettingsCommand::Stay.into())
        } else if self.is_leaving() {
            Some(Command::Leave(false))
        } else if self.asks_about().is_some() {
            Some(Command::Discard(false))
        } else if self.dialog().is_some() {
            Some(Command::Close)
        } else if self.open_columns().is_some() {
            Some(ColumnsCommand::Leave.into())
        } else if self.shows_messages() {
            Some(Command::ShowMessages(false))
        } else if self.help.explains {
            Some(HelpCommand::Explain(false).into())
        } else if self.notice().is_some_and(Notice::asks) {
            Some(Command::Close)
        } else {
            // The form of a correction stands on the check page, too.
            let of_form = self.records().leaves_form().filter(|_| self.page() == Page::Check);
            let of_workpiece = self.workpiece_is_open() && matches!(self.page(), Page::Cycles | Page::Program);
            let of_page = of_form
                .or_else(|| self.closes_on_page())
                .or_else(|| of_workpiece.then(|| WorkpieceCommand::Show(false).into()));
            // What goes by itself is the last to ask for a key.
            of_page.or_else(|| (!self.notices().is_empty()).then_some(Command::Close))
        }
    }
}
