//! What can be done with the palette.

use crate::step::Step;

/// Something about the palette.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PaletteCommand {
    /// Opens or closes it.
    Show(bool),
    /// Replaces what is searched for.
    Type(String),
    /// Goes to another entry.
    Move(Step),
    /// Does what an entry stands for, by its number; without one what the highlighted entry does.
    Do(Option<usize>),
}
