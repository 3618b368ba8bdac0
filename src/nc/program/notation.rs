//! In which notation a program is written.

use super::lines::Lines;

/// How a program is written. All notations give the same blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Notation {
    /// Klartext of HEIDENHAIN milling controls (`.h`).
    Klartext,
}

impl Notation {
    /// The notation of a text.
    pub(super) const fn of(_text: &str, _lines: &Lines) -> Self {
        Self::Klartext
    }
}
