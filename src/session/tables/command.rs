//! What can be done on the table page.

use super::TablesField;
use crate::message::Message;
use crate::tolerance::{DeviationTable, ToleranceClass};

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
    /// Selects the next cell that differs from ISO 286, in reading order and round again.
    NextDifference,
    /// Selects the one before.
    PreviousDifference,
    /// Puts the two fields into the selected cell; both empty is an empty cell.
    SetCell,
    /// Puts the selected cell back into the fields.
    RevertCell,
    /// Empties the selected cell.
    EmptyCell,
    /// Puts what ISO 286 says into the selected cell.
    TakeStandard,
    /// Takes the shown table's last edit back.
    Undo,
    /// Does it again.
    Redo,
    /// Adds the classes of their field to the shown table, with the deviations of ISO 286.
    AddColumns,
    /// Removes the selected cell's class.
    RemoveColumn,
    /// Makes a table of the classes and up to the size in their fields.
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

/// A step from cell to cell; it ends at the table's edge.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Step {
    /// To the class on the left.
    Left,
    /// To the class on the right.
    Right,
    /// To the smaller size range.
    Up,
    /// To the larger size range.
    Down,
    /// Ten size ranges up.
    PageUp,
    /// Ten size ranges down.
    PageDown,
    /// To the first class.
    First,
    /// To the last class.
    Last,
    /// To the first size range.
    Top,
    /// To the last size range.
    Bottom,
}

impl Step {
    /// Every step.
    pub const ALL: [Self; 10] = [
        Self::Left,
        Self::Right,
        Self::Up,
        Self::Down,
        Self::PageUp,
        Self::PageDown,
        Self::First,
        Self::Last,
        Self::Top,
        Self::Bottom,
    ];
}
