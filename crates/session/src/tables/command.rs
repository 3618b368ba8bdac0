//! What can be done on the table page.

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::{DeviationTable, ToleranceClass};

use super::TablesField;
use crate::Step;

/// What can be done on the table page.
#[derive(Debug, Clone)]
pub enum TablesCommand {
    /// Replaces the text of a field.
    Type(TablesField, String),
    /// Shows a table of the list.
    Open(TableChoice),
    /// A table's file was read, or not.
    Read {
        /// Its name without the folder.
        name: String,
        /// The table and its warnings.
        result: Result<(Box<DeviationTable>, Vec<Message>), Message>,
    },
    /// Selects a cell: class, and number of the size range.
    Select(ToleranceClass, usize),
    /// Selects a cell near the selected one.
    Move(Step),
    /// Selects the next cell that differs from ISO 286, column by column and round again.
    NextDifference,
    /// Selects the previous one.
    PreviousDifference,
    /// Shows only what differs from ISO 286, or everything.
    OnlyDifferences(bool),
    /// Puts the two fields into the selected cell; two empty fields make an empty cell.
    SetCell,
    /// Puts the selected cell back into the fields.
    RevertCell,
    /// Empties the selected cell.
    EmptyCell,
    /// Puts the deviations of ISO 286 into the selected cell.
    TakeStandard,
    /// Undoes the last edit of the shown table.
    Undo,
    Redo,
    /// Adds the classes of their field to the shown table, with the deviations of ISO 286.
    AddColumns,
    /// Removes the selected cell's class.
    RemoveColumn,
    /// Makes a table of the classes in their field, up to the size in its field.
    Make,
    /// Looks limits up in the shown table first.
    Use,
}

/// A table of the page's list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableChoice {
    /// One that is open, by its number.
    Document(usize),
    /// One of the user's own that was not opened yet, by its number there.
    Own(usize),
}
