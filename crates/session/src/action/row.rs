//! What a row says about an action, and the usual kinds of rows.

use fitcheck_core::words::Words;

use super::{ActionScope, Held, Key, Part, Shortcut};
use crate::Session;
use crate::command::Command;
use crate::field::Field;
use crate::page::Page;
use crate::step::Step;

/// The actions of a page, or of what lies over every page.
pub(crate) trait Actions {
    /// What is to be known of an action: menus, buttons, tooltips and keys are made from it.
    fn row(&self) -> ActionRow;

    /// Its name, where that depends on the state or on a list; otherwise that of its row.
    fn name(&self, _session: &Session, _words: &Words) -> Option<String> {
        None
    }

    /// Whether what it switches is on; `None` where it switches nothing.
    fn is_on(&self, _session: &Session) -> Option<bool> {
        None
    }

    /// What Enter does in a text field while a page is open.
    fn on_enter(_field: Field, _page: Page) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }
}

/// A list of actions; one with a value is one action for each of its values.
macro_rules! actions {
    ($(#[$whole:meta])* $list:ident $($(#[$doc:meta])* $name:ident $(($of:ty): $all:expr)?;)*) => {
        $(#[$whole])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
        pub enum $list {
            $($(#[$doc])* $name $(($of))?,)*
        }

        impl $list {
            pub(crate) fn all() -> impl Iterator<Item = Self> {
                [$($crate::action::row::actions!(@all $name $($all)?)),*].into_iter().flatten()
            }

            /// The command that it sends now; `None` where it is not possible.
            pub fn command(self, session: &$crate::Session) -> Option<$crate::Command> {
                $crate::Action::from(self).command(session)
            }

            /// Its name, in the words of a language.
            pub fn text(self, session: &$crate::Session, words: &fitcheck_core::words::Words) -> String {
                $crate::Action::from(self).text(session, words)
            }

            /// Whether what it switches is on, where it switches something.
            pub fn is_on(self, session: &$crate::Session) -> Option<bool> {
                $crate::Action::from(self).is_on(session)
            }
        }
    };
    (@all $name:ident) => { vec![Self::$name] };
    (@all $name:ident $all:expr) => { $all.into_iter().map(Self::$name).collect::<Vec<_>>() };
}

pub(crate) use actions;

/// What is to be known of an action.
pub(crate) struct ActionRow {
    /// The id of its text.
    pub text: &'static str,
    /// The id of a further explanation.
    pub hint: Option<&'static str>,
    /// The id of other words that it is found by.
    pub also: Option<&'static str>,
    pub place: ActionScope,
    pub keys: [Option<Shortcut>; 2],
    pub possible: fn(&Session) -> bool,
    pub sends: Sends,
}

/// What an action sends.
pub(crate) enum Sends {
    Always(Command),
    /// A command that depends on the state: a switch is turned to its other side.
    FromState(fn(&Session) -> Command),
    /// A command about the row at which the keys are; none where they are at no row.
    AtCursor(fn(&Session) -> Option<Command>),
}

impl Sends {
    pub fn command(self, session: &Session) -> Option<Command> {
        match self {
            Self::Always(command) => Some(command),
            Self::FromState(command) => Some(command(session)),
            Self::AtCursor(command) => command(session),
        }
    }
}

impl ActionRow {
    pub fn new(place: ActionScope, text: &'static str, sends: Sends) -> Self {
        Self { text, hint: None, also: None, place, keys: [None; 2], possible: |_| true, sends }
    }

    pub fn when(self, possible: fn(&Session) -> bool) -> Self {
        Self { possible, ..self }
    }

    pub fn hint(self, hint: &'static str) -> Self {
        Self { hint: Some(hint), ..self }
    }

    pub fn also(self, also: &'static str) -> Self {
        Self { also: Some(also), ..self }
    }

    pub fn key(self, key: Shortcut) -> Self {
        Self { keys: [Some(key), None], ..self }
    }

    pub fn keys(self, first: Shortcut, second: Shortcut) -> Self {
        Self { keys: [Some(first), Some(second)], ..self }
    }
}

pub(crate) fn everywhere(text: &'static str, command: Command) -> ActionRow {
    ActionRow::new(ActionScope::Everywhere, text, Sends::Always(command))
}

pub(crate) fn on(page: Page, text: &'static str, command: impl Into<Command>) -> ActionRow {
    ActionRow::new(ActionScope::Page(page), text, Sends::Always(command.into()))
}

/// In a part that has the focus as a whole.
pub(crate) fn within(part: Part, text: &'static str, command: impl Into<Command>) -> ActionRow {
    ActionRow::new(ActionScope::Part(part), text, Sends::Always(command.into()))
}

/// The keys of a step.
pub(crate) const fn keys(step: Step) -> Shortcut {
    let key = match step {
        Step::Left => Key::Left,
        Step::Right => Key::Right,
        Step::Up => Key::Up,
        Step::Down => Key::Down,
        Step::PageUp => Key::PageUp,
        Step::PageDown => Key::PageDown,
        Step::First => Key::Home,
        Step::Last => Key::End,
        Step::Top => return Shortcut { held: Held::Ctrl, key: Key::Home },
        Step::Bottom => return Shortcut { held: Held::Ctrl, key: Key::End },
    };
    Shortcut::plain(key)
}
