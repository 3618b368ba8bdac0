//! A mapping as a text: a list for the command line, or TOML to be kept.

use std::collections::BTreeMap;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

use super::words::role_of;
use super::{Column, ColumnUnit, DecimalSign, Mapping, MappingError, Separator};

/// A mapping as it is written: nothing of it is looked at yet.
#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Written {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    sheet: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    separator: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    decimal: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    place_unit: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    first_row: Option<usize>,
    #[serde(default)]
    columns: BTreeMap<String, Column>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    names: BTreeMap<String, Vec<String>>,
}

impl Written {
    /// The mapping, where all words and values are known, and each word is there once.
    fn mapping(self) -> Result<Mapping, MappingError> {
        let mut columns = BTreeMap::new();
        for (word, column) in self.columns {
            let role = role_of(&word)?;
            let is_pair = |columns: &[Column]| {
                (1..=role.most()).contains(&columns.len())
                    && !columns.iter().any(|column| matches!(column, Column::Several(_)) || column.is_none())
            };
            if let Column::Several(columns) = &column
                && !is_pair(columns)
            {
                let given = columns.iter().map(Column::text).collect::<Vec<_>>().join(", ");
                return Err(MappingError::Value { word, given, allowed: "3, \"Measured\", \"-\"".to_owned() });
            }
            if columns.insert(role.word().to_owned(), column).is_some() {
                return Err(MappingError::Twice { word });
            }
        }
        let named = |(word, names): (String, Vec<String>)| Ok((role_of(&word)?.word().to_owned(), names));
        let names = self.names.into_iter().map(named).collect::<Result<_, MappingError>>()?;
        Ok(Mapping {
            names,
            sheet: self.sheet,
            separator: self.separator.as_deref().map(Separator::from_str).transpose()?,
            decimal: self.decimal.as_deref().map(DecimalSign::from_str).transpose()?,
            unit: self.unit.as_deref().map(ColumnUnit::from_str).transpose()?,
            place_unit: self.place_unit.as_deref().map(|given| ColumnUnit::of_word("place-unit", given)).transpose()?,
            first_row: self.first_row,
            columns,
        })
    }
}

impl Mapping {
    /// Reads TOML, as [`Self::to_toml`] writes it.
    ///
    /// # Errors
    /// [`MappingError`]
    pub fn from_toml(text: &str) -> Result<Self, MappingError> {
        let written: Written = toml::from_str(text).map_err(|error| no_toml(error.message()))?;
        written.mapping()
    }

    /// It as TOML, to be kept.
    ///
    /// # Errors
    /// [`MappingError::Toml`] where the number of a line or column is larger than one of TOML.
    pub fn to_toml(&self) -> Result<String, MappingError> {
        let written = Written {
            sheet: self.sheet.clone(),
            separator: self.separator.map(|separator| separator.to_string()),
            decimal: self.decimal.map(|sign| sign.to_string()),
            unit: self.unit.map(|unit| unit.to_string()),
            place_unit: self.place_unit.map(|unit| unit.to_string()),
            first_row: self.first_row,
            columns: self.columns.clone(),
            names: self.names.clone(),
        };
        toml::to_string(&written).map_err(|error| no_toml(&error.to_string()))
    }
}

fn no_toml(reason: &str) -> MappingError {
    MappingError::Toml { reason: reason.to_owned() }
}

impl FromStr for Mapping {
    type Err = MappingError;

    /// `measured=3,callout=Passung,separator=semicolon`.
    fn from_str(text: &str) -> Result<Self, MappingError> {
        let mut written = Written::default();
        for part in text.split(',').map(str::trim).filter(|part| !part.is_empty()) {
            let (word, value) = part.split_once('=').ok_or_else(|| MappingError::NoValue { given: part.to_owned() })?;
            let word = word.trim();
            let value = value.trim();
            let of_the_file = match word {
                "sheet" => Some(&mut written.sheet),
                "separator" => Some(&mut written.separator),
                "decimal" => Some(&mut written.decimal),
                "unit" => Some(&mut written.unit),
                "place-unit" => Some(&mut written.place_unit),
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
                written.first_row.replace(line).is_some()
            } else {
                let role = role_of(word)?;
                let column = value.parse().map_or_else(|_| Column::Name(value.to_owned()), Column::Number);
                written.columns.insert(role.word().to_owned(), column).is_some()
            };
            if is_twice {
                return Err(MappingError::Twice { word: word.to_owned() });
            }
        }
        written.mapping()
    }
}
