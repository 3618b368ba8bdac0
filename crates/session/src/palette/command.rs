//! What can be done with the palette.

use std::sync::Arc;

use fitcheck_core::message::Message;

use crate::records::RecordRow;
use crate::step::Step;

/// Something about the palette.
#[derive(Debug, Clone, PartialEq)]
pub enum PaletteCommand {
    /// Opens or closes it.
    Show(bool),
    /// Replaces what is searched for.
    Type(String),
    /// Goes to another entry.
    Move(Step),
    /// Shows what else can be done with the highlighted entry, or goes back to what was found.
    More(bool),
    /// The journal has found records for a question.
    Found {
        /// The number of the question.
        run: u64,
        /// The newest ones, or why none can be read.
        result: Result<Vec<Arc<RecordRow>>, Message>,
    },
    /// Does what an entry stands for, by its number; without one what the highlighted entry does.
    Do(Option<usize>),
}
