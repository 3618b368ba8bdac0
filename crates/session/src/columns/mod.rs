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

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::message;
use fitcheck_core::words::Words;
use fitcheck_exchange::exchange::{Detected, Remembered, Role};

pub use command::{ColumnChoice, ColumnsCommand};
pub use open::{Asked, OpenColumns, refusal};

use super::command::ImportInto;
use super::shared::{Notice, Shared};

/// What the columns of a file were taken for.
#[derive(Debug, Clone, PartialEq)]
pub struct UsedColumns {
    /// The file's name without its folder.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// Where its values go.
    pub into: ImportInto,
    /// What each column holds.
    pub detected: Detected,
    /// The shape and the day of the mapping that was remembered for it.
    pub remembered: Option<(String, String)>,
}

/// What a notice offers about the columns of its file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NoticeColumns {
    /// The file.
    pub path: PathBuf,
    /// Where its values went.
    pub into: ImportInto,
    /// The shape whose mapping is remembered.
    pub shape: Option<String>,
}

/// The columns of files.
#[derive(Debug, Default)]
pub(crate) struct Columns {
    remembered: Arc<Remembered>,
    /// Files whose columns are asked about, the first one is shown.
    open: VecDeque<OpenColumns>,
    /// What was said of the file whose content comes next.
    used: Option<UsedColumns>,
}

impl Columns {
    pub fn restore(remembered: Remembered) -> Self {
        Self { remembered: Arc::new(remembered), ..Self::default() }
    }

    /// What survives a restart.
    pub fn saved(&self) -> Remembered {
        (*self.remembered).clone()
    }

    pub const fn remembered(&self) -> &Arc<Remembered> {
        &self.remembered
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
pub fn unit_id(word: Option<&str>) -> &'static str {
    match word {
        Some("mm") => "columns-page-unit-mm",
        Some("um") => "columns-page-unit-um",
        Some("inch") => "columns-page-unit-inch",
        _ => "columns-page-unit-names",
    }
}

impl Shared {
    /// A notice of a file says what its columns were taken for, and offers to correct that.
    pub fn add_columns(&mut self, notice: &mut Notice, name: &str) {
        let Some(used) = self.columns.used.take().filter(|used| used.name == name) else { return };
        let words = Words::new(self.language);
        let detected = &used.detected;
        let of_column = |(at, role): (usize, &Option<Role>)| {
            let name = detected.names.get(at).filter(|name| !name.is_empty()).cloned();
            let message = message!("columns-page-taken-one")
                .text("column", name.unwrap_or_else(|| (at + 1).to_string()))
                .text("role", words.get(&role_id(Some((*role)?))));
            Some(words.say(&message))
        };
        let columns: Vec<String> = (0..).zip(&detected.roles).filter_map(of_column).collect();
        let message = message!("columns-page-taken")
            .text("columns", columns.join(", "))
            .text("unit", words.get(unit_id(detected.mapping.unit_word())));
        let remembered = used.remembered.as_ref();
        let said = remembered.map(|(_, day)| message!("columns-page-remembered").text("day", day));
        let from = detected.unit_from.as_ref().map(|from| message!("columns-page-unit-from").text("from", from));
        notice.details.extend(said.into_iter().chain([message]).chain(from));
        let shape = remembered.map(|(shape, _)| shape.clone());
        notice.columns = Some(NoticeColumns { path: used.path, into: used.into, shape });
    }
}
