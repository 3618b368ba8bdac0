//! What can be done on the cycles page.

use fitcheck_core::message::Message;
use fitcheck_nc::control::probe_table::ProbeTable;

use super::{ContactsFrom, CycleField};
use crate::Step;

/// What can be done on the cycles page.
#[derive(Debug, Clone)]
pub enum CyclesCommand {
    /// Chooses a cycle by its number; what was typed for the others is kept.
    Choose(u16),
    /// Replaces the text of a field.
    Type(CycleField, String),
    /// Chooses where contacts come from.
    From(ContactsFrom),
    /// Takes a row of the touch-probe table by its number.
    ChooseProbe(u32),
    /// Takes the built-in touch-probe table.
    ShippedProbes,
    Run,
    /// Clears the result.
    Clear,
    /// Steps along the path.
    Step(Step),
    /// Shows a move of the path by its number, from 0.
    StepTo(usize),
    /// Opens or closes the field for an NC block.
    ShowBlock(bool),
    /// Replaces the NC block.
    TypeBlock(String),
    /// Fills the form from the NC block.
    TakeBlock,
    /// Puts the form as an NC block on the clipboard.
    CopyBlock,
    /// Puts the results on the clipboard, one a line.
    CopyResults,
    /// Puts the status window's text on the clipboard.
    CopyStatus,
    /// A touch-probe table was read, or not.
    ProbesRead {
        /// Its name without the folder.
        name: String,
        result: Result<ProbeTable, Message>,
    },
}
