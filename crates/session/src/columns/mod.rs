//! The columns of a file of measurements: shown where they are not certain or where the user asks, corrected, and remembered for
//! files of the same shape.
//!
//! | file | what |
//! |---|---|
//! | here | what is open, what is remembered, and what a notice says of a file that was read |
//! | `open` | a file whose columns are being looked at |
//! | `command` | what can be done |
//! | `apply` | how |

mod apply;
mod command;
mod open;
mod told;

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::length::Unit;
use fitcheck_exchange::exchange::{ColumnUnit, Remembered, Role};

pub use command::ColumnsCommand;
pub use open::{ColumnChoice, ColumnsRequest, OpenColumns, UsedColumns, refusal};

use super::purpose::ImportInto;

/// What a notice offers about the columns of its file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NoticeColumns {
    /// The file.
    pub path: PathBuf,
    /// Where its values went.
    pub into: ImportInto,
    /// The shape whose mapping is remembered.
    pub shape: Option<String>,
    /// Whether it has no columns to correct, but says no unit.
    pub lacks_unit: bool,
}

/// A file that says no unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct UnitLess {
    /// Its name without the folder.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// Where its values go.
    pub into: ImportInto,
}

/// The columns of files.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    pub remembered: Arc<Remembered>,
    /// Files whose columns are asked about, the first one is shown.
    open: VecDeque<OpenColumns>,
    /// What was said of the file whose content comes next.
    used: Option<UsedColumns>,
    /// That file, where it says no unit.
    unit_less: Option<UnitLess>,
}

impl Columns {
    pub fn restore(remembered: Remembered) -> Self {
        Self { remembered: Arc::new(remembered), ..Self::default() }
    }

    /// What survives a restart.
    pub fn saved(&self) -> Remembered {
        (*self.remembered).clone()
    }

    pub fn open(&self) -> Option<&OpenColumns> {
        self.open.front()
    }
}

/// The name of what a column holds.
pub fn role_id(role: Option<Role>) -> String {
    format!("columns-page-role-{}", role.map_or("none", Role::word))
}

/// The name of a unit; `None` is the one that the names of the columns say.
pub fn unit_id(unit: Option<ColumnUnit>) -> &'static str {
    match unit.map(ColumnUnit::unit) {
        Some(Unit::Millimetre) => "columns-page-unit-mm",
        Some(Unit::Micrometre) => "columns-page-unit-um",
        Some(Unit::Inch) => "columns-page-unit-inch",
        None => "columns-page-unit-names",
    }
}
