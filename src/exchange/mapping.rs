//! Which column of a CSV is which, as the user says it, or as it would be taken without a word of theirs.
//!
//! A mapping is a list for the command line, `measured=3,callout=Passung,decimal=comma`, and TOML to be kept. What it does not say is
//! detected as ever; what it says and the file does not have is refused.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::cells;
use super::columns::{self, Columns, LabelColumns, LengthColumn, Sample, unit_of};
use super::delimited::without_separator_line;
use super::error::{ImportErrorKind, Role};
use super::own::OwnColumns;
use super::source::Beginning;
use crate::length::Unit;
use crate::message::Say;

/// How many rows show what is in the columns.
const SHOWN: usize = 20;

/// The words of what a column holds.
const ROLES: [(Role, &str); 13] = [
    (Role::Id, "name"),
    (Role::Tolerance, "callout"),
    (Role::Nominal, "nominal"),
    (Role::Measured, "measured"),
    (Role::Time, "time"),
    (Role::Simulated, "simulated"),
    (Role::Number, "number"),
    (Role::Part, "part"),
    (Role::Serial, "serial"),
    (Role::Who, "who"),
    (Role::X, "x"),
    (Role::Y, "y"),
    (Role::Z, "z"),
];

/// Other words for the same.
const OTHER_WORDS: [(&str, Role); 3] = [("id", Role::Id), ("class", Role::Tolerance), ("date", Role::Time)];

const SEPARATORS: [(&str, u8); 4] = [("semicolon", b';'), ("comma", b','), ("tab", b'\t'), ("pipe", b'|')];
const DECIMALS: [(&str, char); 2] = [("point", '.'), ("comma", ',')];
const UNITS: [(&str, Unit); 3] = [("mm", Unit::Millimetre), ("um", Unit::Micrometre), ("inch", Unit::Inch)];

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
    Word {
        /// What was given.
        given: String,
        /// What is allowed.
        allowed: String,
    },
    /// A value that is not one of those of its word.
    Value {
        /// The word.
        word: String,
        /// What was given.
        given: String,
        /// What is allowed.
        allowed: String,
    },
    /// A text that is not TOML, or not that of a mapping.
    Toml {
        /// What is wrong with it.
        reason: String,
    },
}

/// A column by its number, from 1, or by its name in the header; `-` is none.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(untagged)]
enum Column {
    Number(usize),
    Name(String),
}

/// Which column is which, as far as it is said.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
pub struct Mapping {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    separator: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    decimal: Option<String>,
    /// The unit of measured values and nominal sizes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    unit: Option<String>,
    /// The line of the first row.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    first_row: Option<usize>,
    #[serde(default)]
    columns: BTreeMap<String, Column>,
}

/// What would be taken for what, with the first rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Detected {
    /// All of it as a mapping.
    pub mapping: Mapping,
    /// The names of the columns, or nothing where they have none.
    pub names: Vec<String>,
    /// What each column holds; `None` is skipped.
    pub roles: Vec<Option<Role>>,
    /// The first rows with their lines.
    pub rows: Vec<(usize, Vec<String>)>,
}

impl Detected {
    /// The word of what a column holds, from 0.
    pub fn word(&self, at: usize) -> Option<&'static str> {
        self.roles.get(at).copied().flatten().map(word_of)
    }
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

    /// Whether all words and values are known.
    fn checked(self) -> Result<Self, MappingError> {
        for word in self.columns.keys() {
            role_of(word)?;
        }
        known("separator", self.separator.as_deref(), &SEPARATORS)?;
        known("decimal", self.decimal.as_deref(), &DECIMALS)?;
        known("unit", self.unit.as_deref(), &UNITS)?;
        Ok(self)
    }

    /// The separator, where it is said.
    pub(super) fn separator(&self) -> Option<u8> {
        known("separator", self.separator.as_deref(), &SEPARATORS).ok().flatten()
    }

    /// What the columns of a file are: as detected, but for what is said here.
    pub(super) fn columns(&self, sample: &mut Sample) -> Result<Columns, ImportErrorKind> {
        if *self == Self::default() {
            return sample.columns();
        }
        if sample.rows.is_empty() {
            return Err(ImportErrorKind::NoRows);
        }
        self.place_header(sample);
        let width = sample.rows.iter().map(|(_, cells)| cells.len()).max().unwrap_or_default();
        // Names that mean nothing to anybody else are names here.
        let unknown = sample.above.checked_sub(1).filter(|_| self.first_row.is_none());
        let header = sample.header.or(unknown).and_then(|at| sample.rows.get(at)).cloned();
        let names = header.as_ref().map(|(_, names)| names.clone()).unwrap_or_default();
        let said = self.said(&names, width)?;
        sample.measured = said.iter().find(|(role, _)| *role == Role::Measured).and_then(|(_, at)| *at);
        let detected = sample.columns();
        let at = |role: Role| said.iter().find(|(of, _)| *of == role).map(|(_, at)| *at);
        let used: Vec<usize> = said.iter().filter_map(|(_, at)| *at).collect();
        let free = |at: Option<usize>| at.filter(|at| !used.contains(at));
        let of_names = |at: usize| unit_of(names.get(at).unwrap_or_default());
        let unit = known("unit", self.unit.as_deref(), &UNITS).ok().flatten();
        let length = |at: usize| -> Result<LengthColumn, ImportErrorKind> {
            Ok(LengthColumn { at, unit: unit.map_or_else(|| of_names(at), Ok)? })
        };
        let measured_at = match (at(Role::Measured), &detected) {
            (Some(Some(at)), _) => at,
            (None, Ok(detected)) if !used.contains(&detected.measured.at) => detected.measured.at,
            (None, Err(error)) => return Err(error.clone()),
            _ => return Err(ImportErrorKind::NoMeasuredColumn),
        };
        let found = detected.ok();
        let either = |role: Role, found: Option<usize>| at(role).unwrap_or_else(|| free(found));
        let found_of = |of: fn(&Columns) -> Option<usize>| found.as_ref().and_then(of);
        let nominal = either(Role::Nominal, found_of(|found| found.nominal.map(|column| column.at)));
        let place = |role: Role, axis: usize| -> Result<Option<LengthColumn>, ImportErrorKind> {
            let found = found.as_ref().and_then(|found| *found.labels.place.get(axis)?).map(|column| column.at);
            either(role, found).map(|at| Ok::<_, ImportErrorKind>(LengthColumn { at, unit: of_names(at)? })).transpose()
        };
        let labels = LabelColumns {
            number: either(Role::Number, found_of(|found| found.labels.number)),
            part: either(Role::Part, found_of(|found| found.labels.part)),
            serial: either(Role::Serial, found_of(|found| found.labels.serial)),
            who: either(Role::Who, found_of(|found| found.labels.who)),
            place: [place(Role::X, 0)?, place(Role::Y, 1)?, place(Role::Z, 2)?],
        };
        let times = found.as_ref().map(|found| found.time.clone()).unwrap_or_default();
        let mut columns = Columns {
            id: either(Role::Id, found_of(|found| found.id)).filter(|at| *at != measured_at),
            tolerance: either(Role::Tolerance, found_of(|found| found.tolerance)).filter(|at| *at != measured_at),
            nominal: nominal.filter(|at| *at != measured_at).map(length).transpose()?,
            measured: length(measured_at)?,
            time: match at(Role::Time) {
                // Date and time may have a column each, and one of them is named.
                Some(Some(at)) if times.contains(&at) => times,
                Some(at) => at.into_iter().collect(),
                None => times.into_iter().filter(|at| !used.contains(at)).collect(),
            },
            simulated: either(Role::Simulated, found_of(|found| found.simulated)),
            count: if names.is_empty() { found.as_ref().map_or(width, |found| found.count) } else { names.len() },
            header: header.as_ref().map(|(line, _)| *line).or_else(|| found.as_ref().and_then(|found| found.header)),
            names_known: sample.header.is_some(),
            ignored: Vec::new(),
            decimal_sign: None,
            behind: None,
            fewest_decimals: None,
            own: if names.is_empty() { OwnColumns::default() } else { OwnColumns::of(&names) },
            labels,
            first: self.first_row,
        };
        columns.count = columns.count.max(used.iter().max().map_or(0, |at| at + 1));
        let roles = roles(&columns);
        let is_ignored = |at: &usize| {
            let is_own = columns.own.of_correction().any(|own| own == *at);
            let is_named = names.is_empty() || names.get(*at).is_some_and(|name| !name.trim().is_empty());
            roles.get(*at).is_some_and(Option::is_none) && !is_own && is_named
        };
        let ignored = (0..columns.count).filter(is_ignored);
        columns.ignored = ignored.map(|at| columns::name_of(at, names.get(at).unwrap_or_default())).collect();
        sample.look_at_values(&mut columns);
        if let Ok(Some(sign)) = known("decimal", self.decimal.as_deref(), &DECIMALS) {
            columns.decimal_sign = Some(sign);
        }
        Ok(columns)
    }

    /// Finds the header by the names that are said, or above the first row.
    fn place_header(&self, sample: &mut Sample) {
        let names: Vec<&str> = self.columns.values().filter_map(Column::name).collect();
        let has = |cells: &csv::StringRecord, name: &str| cells.iter().any(|cell| is_named(cell, name));
        let first = self.first_row.and_then(|first| sample.rows.iter().position(|(line, _)| first <= *line));
        let above = sample.rows.get(..first.unwrap_or(sample.rows.len())).unwrap_or_default();
        if !names.is_empty() {
            // The row that has most of the names; the first of equals.
            let count = |cells: &csv::StringRecord| names.iter().filter(|name| has(cells, name)).count();
            let best = above.iter().enumerate().rev().max_by_key(|(_, (_, cells))| count(cells));
            if let Some((at, _)) = best.filter(|(_, (_, cells))| 0 < count(cells)) {
                sample.header = Some(at);
                sample.above = at + 1;
            }
        } else if let Some(first) = first
            && sample.header.is_none_or(|at| first <= at)
        {
            let is_name = |at: &usize| sample.rows.get(*at).is_some_and(|(_, cells)| cells::may_be_names(cells));
            sample.header = first.checked_sub(1).filter(is_name);
        }
        if let Some(first) = first {
            sample.above = first;
        }
    }

    /// The columns that are said, from 0; `None` for a role that no column has.
    fn said(&self, names: &csv::StringRecord, width: usize) -> Result<Vec<(Role, Option<usize>)>, ImportErrorKind> {
        let mut said: Vec<(Role, Option<usize>)> = Vec::new();
        for (word, column) in &self.columns {
            let Ok(role) = role_of(word) else { continue };
            let at = match column {
                Column::Name(name) if name == "-" => None,
                Column::Name(name) => {
                    let found: Vec<usize> =
                        (0..).zip(names).filter(|(_, cell)| is_named(cell, name)).map(|(at, _)| at).collect();
                    match found.as_slice() {
                        [] => return Err(no_column(role, name, names, width)),
                        [at] => Some(*at),
                        several => return Err(columns::several(role, names, several)),
                    }
                }
                Column::Number(number) => match number.checked_sub(1).filter(|at| *at < width) {
                    None => return Err(no_column(role, &number.to_string(), names, width)),
                    at => at,
                },
            };
            let twice = said.iter().find(|(_, known)| at.is_some() && *known == at);
            if let Some(((first, _), at)) = twice.zip(at) {
                let column = columns::name_of(at, names.get(at).unwrap_or_default());
                return Err(ImportErrorKind::ColumnTwice { column, first: *first, second: role });
            }
            said.push((role, at));
        }
        Ok(said)
    }

    /// What would be taken for what in a file of which these are the first bytes, as far as this mapping leaves it open.
    ///
    /// # Errors
    /// Why the file as a whole cannot be read.
    pub fn detect(&self, bytes: &[u8]) -> Result<Detected, ImportErrorKind> {
        let beginning = Beginning::new("", bytes);
        let head = beginning.text();
        let (text, first_line, separator) = without_separator_line(&head);
        let mut sample = Sample::of(text, first_line, self.separator().or(separator));
        let columns = self.columns(&mut sample)?;
        let is_header = |line: usize| columns.header == Some(line);
        let names = sample.rows.iter().find(|(line, _)| is_header(*line)).map(|(_, cells)| cells);
        let names: Vec<String> = names.into_iter().flatten().map(|name| name.trim().to_owned()).collect();
        let is_row = |line: usize| {
            columns.header.is_none_or(|header| header < line) && columns.first.is_none_or(|first| first <= line)
        };
        let rows: Vec<(usize, Vec<String>)> = sample
            .rows
            .iter()
            .filter(|(line, _)| is_row(*line))
            .take(SHOWN)
            .map(|(line, cells)| (*line, cells.iter().map(str::to_owned).collect()))
            .collect();
        let roles = roles(&columns);
        let word =
            |list: &[(&'static str, u8)]| list.iter().find(|(_, of)| *of == sample.separator).map(|(word, _)| *word);
        let mapping = Self {
            separator: word(&SEPARATORS).map(str::to_owned),
            decimal: columns
                .decimal_sign
                .and_then(|sign| DECIMALS.iter().find(|(_, of)| *of == sign))
                .map(|(word, _)| (*word).to_owned()),
            unit: UNITS.iter().find(|(_, of)| *of == columns.measured.unit).map(|(word, _)| (*word).to_owned()),
            first_row: rows.first().map(|(line, _)| *line),
            columns: roles
                .iter()
                .enumerate()
                .rev()
                .filter_map(|(at, role)| Some((word_of((*role)?).to_owned(), column_of(at, &names))))
                .collect(),
        };
        Ok(Detected { mapping, names, roles, rows })
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
            let wrong = |allowed: &str| MappingError::Value {
                word: word.to_owned(),
                given: value.to_owned(),
                allowed: allowed.to_owned(),
            };
            match word {
                "separator" => mapping.separator = Some(value.to_owned()),
                "decimal" => mapping.decimal = Some(value.to_owned()),
                "unit" => mapping.unit = Some(value.to_owned()),
                "first-row" => {
                    let line = value.parse().ok().filter(|line| 0 < *line);
                    mapping.first_row = Some(line.ok_or_else(|| wrong("1, 2, 3, …"))?);
                }
                _ => {
                    let role = role_of(word)?;
                    let column = value.parse().map_or_else(|_| Column::Name(value.to_owned()), Column::Number);
                    mapping.columns.insert(word_of(role).to_owned(), column);
                }
            }
        }
        mapping.checked()
    }
}

impl Column {
    fn name(&self) -> Option<&str> {
        match self {
            Self::Name(name) if name != "-" => Some(name),
            Self::Name(_) | Self::Number(_) => None,
        }
    }
}

/// A column by its name, where it is the only one of it.
fn column_of(at: usize, names: &[String]) -> Column {
    let name = names.get(at).filter(|name| !name.is_empty() && name.as_str() != "-" && !name.contains(','));
    let is_one = |name: &&String| names.iter().filter(|other| is_named(other, name)).count() == 1;
    name.filter(is_one).map_or(Column::Number(at + 1), |name| Column::Name(name.clone()))
}

fn is_named(cell: &str, name: &str) -> bool {
    let bare = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ").to_lowercase();
    bare(cell) == bare(name)
}

fn role_of(word: &str) -> Result<Role, MappingError> {
    let small = word.to_lowercase();
    let role = ROLES.iter().find(|(_, known)| *known == small).map(|(role, _)| *role);
    let role = role.or_else(|| OTHER_WORDS.iter().find(|(known, _)| *known == small).map(|(_, role)| *role));
    role.ok_or_else(|| {
        let words = ROLES.iter().map(|(_, word)| *word).chain(["separator", "decimal", "unit", "first-row"]);
        MappingError::Word { given: word.to_owned(), allowed: words.collect::<Vec<_>>().join(" ") }
    })
}

fn word_of(role: Role) -> &'static str {
    ROLES.iter().find(|(known, _)| *known == role).map_or("", |(_, word)| *word)
}

/// What a word means, if there is one.
fn known<T: Copy>(word: &str, given: Option<&str>, list: &[(&'static str, T)]) -> Result<Option<T>, MappingError> {
    let Some(given) = given else { return Ok(None) };
    let found = list.iter().find(|(known, _)| *known == given).map(|(_, value)| *value);
    found.map(Some).ok_or_else(|| MappingError::Value {
        word: word.to_owned(),
        given: given.to_owned(),
        allowed: list.iter().map(|(known, _)| *known).collect::<Vec<_>>().join(" "),
    })
}

fn no_column(role: Role, given: &str, names: &csv::StringRecord, width: usize) -> ImportErrorKind {
    let width = width.max(names.len());
    let names: Vec<String> = (0..width).map(|at| columns::name_of(at, names.get(at).unwrap_or_default())).collect();
    ImportErrorKind::NoColumn { role, given: super::error::shorten(given), columns: columns::listed(&names) }
}

/// What each column holds.
fn roles(columns: &Columns) -> Vec<Option<Role>> {
    let labels = &columns.labels;
    let [x, y, z] = labels.place.map(|column| column.map(|column| column.at));
    let one = [
        (Role::Measured, Some(columns.measured.at)),
        (Role::Tolerance, columns.tolerance),
        (Role::Nominal, columns.nominal.map(|column| column.at)),
        (Role::Id, columns.id),
        (Role::Simulated, columns.simulated),
        (Role::Number, labels.number),
        (Role::Part, labels.part),
        (Role::Serial, labels.serial),
        (Role::Who, labels.who),
        (Role::X, x),
        (Role::Y, y),
        (Role::Z, z),
    ];
    let times = columns.time.iter().map(|at| (Role::Time, Some(*at)));
    let all: Vec<(Role, Option<usize>)> = one.into_iter().chain(times).collect();
    (0..columns.count).map(|at| all.iter().find(|(_, of)| *of == Some(at)).map(|(role, _)| *role)).collect()
}
