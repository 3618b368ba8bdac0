//! Which column of a CSV is which, as the user says it, or as it would be taken without a word of theirs.
//!
//! A mapping is a list for the command line, `measured=3,callout=Passung,decimal=comma`, and TOML to be kept. What it does not say is
//! detected as ever; what it says and the file does not have is refused.
//!
//! | file | what |
//! |---|---|
//! | here | the mapping |
//! | `words` | what a column may hold |
//! | `signs` | separators, decimal signs and units |
//! | `written` | it as a text: a list, or TOML |
//! | `applied` | the columns of a file by a mapping |
//! | `detected` | what would be taken for what, and what is open about it |
//! | `first_rows` | the beginning of a file, to be looked at with one mapping after the other |
//! | `choice` | what is chosen for each column, as a mapping |
//! | `remembered` | mappings by the shape of the file that they were made for |

mod applied;
mod choice;
mod detected;
mod first_rows;
mod remembered;
mod signs;
mod words;
mod written;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::exchange::cell::single_blanks;

pub use choice::Choice;
pub use detected::Detected;
pub use first_rows::FirstRows;
use fitcheck_core::length::Unit;
use fitcheck_core::message::Say;
pub use remembered::{Kept, MOST_KEPT, Remembered};
pub use signs::{ColumnUnit, DecimalSign, Separator};

/// Why a text is no mapping.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "mapping", error)]
pub enum MappingError {
    /// A part of a list without an equals sign.
    NoValue {
        /// The part.
        given: String,
    },
    /// A word that is not one of what a mapping says.
    Word { given: String, allowed: String },
    /// A value that is not one of those of its word.
    Value { word: String, given: String, allowed: String },
    /// A word that is there twice, itself or by another word for the same.
    Twice { word: String },
    /// A text that is not TOML, or not that of a mapping.
    Toml {
        /// What is wrong with it.
        reason: String,
    },
}

/// A column by its number, from 1, or by its name in the header; `-` is none. Date and time may have a column each, and so may type and
/// axis.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
enum Column {
    Number(usize),
    Name(String),
    Several(Vec<Self>),
}

/// Which column is which, as far as it is said.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Mapping {
    /// The sheet of a workbook.
    sheet: Option<String>,
    separator: Option<Separator>,
    decimal: Option<DecimalSign>,
    /// The unit of measured values and nominal sizes.
    unit: Option<ColumnUnit>,
    /// The unit of X, Y and Z.
    place_unit: Option<ColumnUnit>,
    /// The line of the first row.
    first_row: Option<usize>,
    columns: BTreeMap<String, Column>,
    /// More names of columns, by the word of what they hold: they count in any file that has one of them.
    names: BTreeMap<String, Vec<String>>,
}

impl Mapping {
    /// The sheet of a workbook, where it is said.
    pub(super) fn sheet(&self) -> Option<&str> {
        self.sheet.as_deref()
    }

    /// How a file is split, and nothing else.
    pub fn split(sheet: Option<String>, separator: Option<Separator>) -> Self {
        Self { sheet, separator, ..Self::default() }
    }

    /// The unit of measured values and nominal sizes, where it is said.
    pub const fn unit(&self) -> Option<ColumnUnit> {
        self.unit
    }

    /// That values are in this unit, and nothing else.
    pub fn of_unit(unit: Unit) -> Self {
        Self { unit: Some(ColumnUnit::of(unit)), ..Self::default() }
    }

    /// Whether it says the unit of values and nothing else.
    pub fn says_unit_alone(&self) -> bool {
        self.unit.is_some() && *self == Self { unit: self.unit, ..Self::default() }
    }

    /// The decimal sign, where it is said.
    pub(super) const fn decimal(&self) -> Option<DecimalSign> {
        self.decimal
    }

    /// The separator, where it is said.
    pub(super) fn separator(&self) -> Option<u8> {
        self.separator.map(Separator::byte)
    }
}

impl Column {
    /// No column.
    fn none() -> Self {
        Self::Name("-".to_owned())
    }

    fn is_none(&self) -> bool {
        matches!(self, Self::Name(name) if name == "-")
    }

    /// The columns, each by itself.
    fn iter(&self) -> std::slice::Iter<'_, Self> {
        match self {
            Self::Several(columns) => columns.iter(),
            one => std::slice::from_ref(one).iter(),
        }
    }

    fn name(&self) -> Option<&str> {
        match self {
            Self::Name(name) if !self.is_none() => Some(name),
            Self::Name(_) | Self::Number(_) | Self::Several(_) => None,
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Number(number) => number.to_string(),
            Self::Name(name) => name.clone(),
            Self::Several(columns) => columns.iter().map(Self::text).collect::<Vec<_>>().join(", "),
        }
    }
}

/// Whether a cell of the header has a name: blanks and capitals do not count.
fn is_named(cell: &str, name: &str) -> bool {
    let bare = |text: &str| single_blanks(text).to_lowercase();
    bare(cell) == bare(name)
}
