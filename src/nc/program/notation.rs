//! In which notation a program is written.

use super::iso;
use super::lines::Lines;

/// How a program is written. All notations give the same blocks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Notation {
    /// Klartext of HEIDENHAIN milling controls (`.h`).
    Klartext,
    /// ISO programs of HEIDENHAIN milling controls (`.i`).
    Iso,
}

impl Notation {
    /// The notation of a text.
    pub(super) fn of(text: &str, lines: &Lines) -> Self {
        if iso::begins(text, lines) { Self::Iso } else { Self::Klartext }
    }
}
