//! Which column of a CSV is which, as the user says it, or as it would be taken without a word of theirs.
//!
//! A mapping is a list for the command line, `measured=3,callout=Passung,decimal=comma`, and TOML to be kept. What it does not say is
//! detected as ever; what it says and the file does not have is refused.
//!
//! | file | what |
//! |---|---|
//! | here | the mapping, from and to texts |
//! | `words` | what may be said |
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
mod words;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

pub use choice::{Choice, DECIMAL_WORDS, SEPARATOR_WORDS, UNIT_WORDS};
pub use detected::Detected;
pub use first_rows::FirstRows;
use fitcheck_core::length::Unit;
use fitcheck_core::message::Say;
pub use remembered::{Kept, MOST_KEPT, Remembered};
use words::{DECIMALS, SEPARATORS, UNITS, known, role_of};

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
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Mapping {
    /// The sheet of a workbook.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    sheet: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    separator: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    decimal: Option<String>,
    /// The unit of measured values and nominal sizes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
    /// The unit of X, Y and Z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    place_unit: Option<String>,
    /// The line of the first row.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    first_row: Option<usize>,
    #[serde(default)]
    columns: BTreeMap<String, Column>,
}

impl Mapping {
    /// Reads TOML, as [`Self::to_toml`] writes it.
    ///
    /// # Errors
    /// [`MappingError`]
    pub fn from_toml(text: &str) -> Result<Self, MappingError> {
        let mapping: Self =
            toml::from_str(text).map_err(|error| MappingError::Toml { reason: error.message().to_owned() })?;
        mapping.checked()
    }

    /// It as TOML, to be kept.
    pub fn to_toml(&self) -> String {
        toml::to_string(self).unwrap_or_default()
    }

    /// The sheet of a workbook, where it is said.
    pub(super) fn sheet(&self) -> Option<&str> {
        self.sheet.as_deref()
    }

    /// Whether all words and values are known, and each word is there once.
    fn checked(mut self) -> Result<Self, MappingError> {
        for (word, column) in std::mem::take(&mut self.columns) {
            let role = role_of(&word)?;
            let is_pair = |columns: &[Column]| {
                role.may_be_two()
                    && matches!(columns.len(), 1..=2)
                    && !columns.iter().any(|column| matches!(column, Column::Several(_)) || column.is_none())
            };
            if let Column::Several(columns) = &column
                && !is_pair(columns)
            {
                let given = columns.iter().map(Column::text).collect::<Vec<_>>().join(", ");
                return Err(MappingError::Value { word, given, allowed: "3, \"Measured\", \"-\"".to_owned() });
            }
            if self.columns.insert(role.word().to_owned(), column).is_some() {
                return Err(MappingError::Twice { word });
            }
        }
        known("separator", self.separator.as_deref(), &SEPARATORS)?;
        known("decimal", self.decimal.as_deref(), &DECIMALS)?;
        known("unit", self.unit.as_deref(), &UNITS)?;
        known("place-unit", self.place_unit.as_deref(), &UNITS)?;
        Ok(self)
    }

    /// How a file is split, and nothing else.
    pub fn split(sheet: Option<String>, separator: Option<String>) -> Self {
        Self { sheet, separator, ..Self::default() }
    }

    /// The word of the unit of measured values and nominal sizes, where it is said.
    pub fn unit_word(&self) -> Option<&str> {
        self.unit.as_deref()
    }

    /// The separator, where it is said.
    pub(super) fn separator(&self) -> Option<u8> {
        known("separator", self.separator.as_deref(), &SEPARATORS).ok().flatten()
    }

    fn decimal(&self) -> Option<char> {
        known("decimal", self.decimal.as_deref(), &DECIMALS).ok().flatten()
    }

    fn unit(&self) -> Option<Unit> {
        known("unit", self.unit.as_deref(), &UNITS).ok().flatten()
    }

    fn place_unit(&self) -> Option<Unit> {
        known("place-unit", self.place_unit.as_deref(), &UNITS).ok().flatten()
    }
}

impl std::str::FromStr for Mapping {
    type Err = MappingError;

    /// `measured=3,callout=Passung,separator=semicolon`.
    fn from_str(text: &str) -> Result<Self, MappingError> {
        let mut mapping = Self::default();
        for part in text.split(',').map(str::trim).filter(|part| !part.is_empty()) {
            let (word, value) = part.split_once('=').ok_or_else(|| MappingError::NoValue { given: part.to_owned() })?;
            let (word, value) = (word.trim(), value.trim());
            let of_the_file = match word {
                "sheet" => Some(&mut mapping.sheet),
                "separator" => Some(&mut mapping.separator),
                "decimal" => Some(&mut mapping.decimal),
                "unit" => Some(&mut mapping.unit),
                "place-unit" => Some(&mut mapping.place_unit),
                _ => None,
            };
            let is_twice = if let Some(said) = of_the_file {
                said.replace(value.to_owned()).is_some()
            } else if word == "first-row" {
                let line = value.parse().ok().filter(|line| 0 < *line).ok_or_else(|| MappingError::Value {
                    word: word.to_owned(),
                    given: value.to_owned(),
                    allowed: "1, 2, 3, …".to_owned(),
                })?;
                mapping.first_row.replace(line).is_some()
            } else {
                let role = role_of(word)?;
                let column = value.parse().map_or_else(|_| Column::Name(value.to_owned()), Column::Number);
                mapping.columns.insert(role.word().to_owned(), column).is_some()
            };
            if is_twice {
                return Err(MappingError::Twice { word: word.to_owned() });
            }
        }
        mapping.checked()
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
    let bare = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
    bare(cell) == bare(name)
}
