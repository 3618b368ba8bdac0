//! Keys as they are shown to a user, without a window.

use std::fmt;

/// A key with what is held down.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Shortcut {
    /// What is held down.
    pub held: Held,
    /// What is pressed.
    pub key: Key,
}

/// What is held down while a key is pressed. Ctrl is the command key where the system has one.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Held {
    Nothing,
    Shift,
    Ctrl,
    CtrlShift,
    Alt,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Key {
    /// A capital letter or a digit.
    Character(char),
    Function(u8),
    /// The left arrow.
    Left,
    /// The right arrow.
    Right,
    /// The upward arrow.
    Up,
    /// The downward arrow.
    Down,
    PageUp,
    PageDown,
    Home,
    End,
    Enter,
    Escape,
    Delete,
    /// The space bar.
    Space,
}

impl Shortcut {
    pub(crate) const fn plain(key: Key) -> Self {
        Self { held: Held::Nothing, key }
    }

    pub(crate) const fn shift(key: Key) -> Self {
        Self { held: Held::Shift, key }
    }

    pub(crate) const fn ctrl(key: char) -> Self {
        Self { held: Held::Ctrl, key: Key::Character(key) }
    }

    /// Whether a text field that has the focus uses the keys itself, to undo its own edits.
    pub(crate) const fn is_of_text(self) -> bool {
        matches!(self, Self { held: Held::Ctrl | Held::CtrlShift, key: Key::Character('Z' | 'Y') })
    }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Character(character) => write!(f, "{character}"),
            Self::Function(number) => write!(f, "F{number}"),
            Self::Left => f.write_str("←"),
            Self::Right => f.write_str("→"),
            Self::Up => f.write_str("↑"),
            Self::Down => f.write_str("↓"),
            Self::PageUp => f.write_str("PageUp"),
            Self::PageDown => f.write_str("PageDown"),
            Self::Home => f.write_str("Home"),
            Self::End => f.write_str("End"),
            Self::Enter => f.write_str("Enter"),
            Self::Escape => f.write_str("Esc"),
            Self::Delete => f.write_str("Delete"),
            Self::Space => f.write_str("Space"),
        }
    }
}

impl fmt::Display for Shortcut {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.held {
            Held::Nothing => "",
            Held::Shift => "Shift+",
            Held::Ctrl => "Ctrl+",
            Held::CtrlShift => "Ctrl+Shift+",
            Held::Alt => "Alt+",
        })?;
        self.key.fmt(f)
    }
}
