//! What can be done with the columns of a file.

use fitcheck_exchange::exchange::Role;

use super::{Asked, UsedColumns};

/// Something about the columns of a file.
#[derive(Debug, Clone)]
pub enum ColumnsCommand {
    /// A file was looked at, and its columns are asked about.
    Ask(Box<Asked>),
    /// What the columns of the file were taken for whose content comes next.
    Used(Box<UsedColumns>),
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

/// What is chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ColumnChoice {
    /// What a column holds, from 0.
    Role(usize, Option<Role>),
    /// The sheet of a workbook; its columns are detected anew.
    Sheet(String),
    /// The word of the separator; the columns are detected anew.
    Separator(&'static str),
    /// The word of the decimal sign; `None` as in the file.
    Decimal(Option<&'static str>),
    /// The word of the unit of sizes; `None` as the names of the columns say.
    Unit(Option<&'static str>),
    /// The word of the unit of X, Y and Z; `None` as the names of the columns say.
    PlaceUnit(Option<&'static str>),
    /// The line of the first row; `None` below the header.
    FirstRow(Option<usize>),
}
