//! What can be done with the columns of a file.

use fitcheck_core::length::Unit;

use super::{ColumnChoice, ColumnsRequest, UnitLess, UsedColumns};

/// Something about the columns of a file.
#[derive(Debug, Clone)]
pub enum ColumnsCommand {
    /// A file was looked at, and its columns are asked about.
    Ask(Box<ColumnsRequest>),
    /// What the columns of the file were taken for whose content comes next.
    Used(Box<UsedColumns>),
    /// The file says no unit whose content comes next.
    UnitLess(Box<UnitLess>),
    /// Reads the file again that the oldest notice tells of: its lengths are in this unit.
    In(Unit),
    /// Chooses something for the file that is shown.
    Choose(ColumnChoice),
    /// Imports the file that is shown with what is chosen, and remembers that.
    Take,
    /// Leaves the file alone.
    Leave,
    /// Asks about the columns of the file that the oldest notice tells of.
    Correct,
    /// Forgets what was remembered for it.
    Forget,
}
