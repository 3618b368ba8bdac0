//! What would be taken for what in a file, with its first rows.

use std::collections::BTreeMap;

use csv::StringRecord;
use fitcheck_core::length::Unit;

use super::applied::roles;
use super::{Column, ColumnUnit, DecimalSign, Mapping, Separator, is_named};
use crate::exchange::columns::Columns;
use crate::exchange::delimited::without_separator_line;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::own::OwnColumns;
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;
use crate::exchange::source::Beginning;

/// How many rows show what is in the columns.
pub(super) const SHOWN: usize = 20;

/// What would be taken for what, with the first rows.
#[derive(Debug, Clone, PartialEq)]
pub struct Detected {
    pub mapping: Mapping,
    /// The names of the columns, or nothing where they have none.
    pub names: Vec<String>,
    /// What each column holds; `None` is skipped.
    pub roles: Vec<Option<Role>>,
    /// The first rows with their lines.
    pub rows: Vec<(usize, Vec<String>)>,
    /// The line of the header, where there is one.
    pub header: Option<usize>,
    /// The columns that are skipped though they have a name, or stand in a file without names.
    pub skipped: Vec<String>,
    /// Whether Fitcheck wrote the file: what is skipped of it is known.
    pub is_own: bool,
    /// What says the unit of measured values, as it stands in the file; `None` where nothing does.
    pub unit_from: Option<String>,
}

impl Detected {
    pub(super) fn of(sample: &Sample, columns: &Columns) -> Self {
        let is_header = |line: usize| columns.header == Some(line);
        let names = sample.rows.iter().find(|(line, _)| is_header(*line)).map(|(_, cells)| cells);
        let names: Vec<String> = names.into_iter().flatten().map(|name| name.trim().to_owned()).collect();
        let is_row = |line: usize| {
            columns.header.is_none_or(|header| header < line)
                && columns.first.is_none_or(|first| first <= line)
                && columns.stated.first() <= line
        };
        let rows: Vec<(usize, Vec<String>)> = sample
            .rows
            .iter()
            .filter(|(line, _)| is_row(*line))
            .take(SHOWN)
            .map(|(line, cells)| (*line, cells.iter().map(str::to_owned).collect()))
            .collect();
        let roles = roles(columns);
        let of_sizes = [Some(columns.measured.unit), columns.nominal.map(|column| column.unit)];
        let of_places = columns.labels.place.map(|column| column.map(|column| column.unit));
        let mapping = Mapping {
            sheet: None,
            separator: Separator::of_byte(sample.separator),
            decimal: columns.decimal_sign.and_then(DecimalSign::of_sign),
            unit: common(&of_sizes).map(ColumnUnit::of),
            place_unit: common(&of_places).map(ColumnUnit::of),
            names: BTreeMap::new(),
            first_row: rows.first().map(|(line, _)| *line),
            columns: said(&roles, &names),
        };
        let is_own = columns.own != OwnColumns::default();
        let header = columns.header;
        let skipped = columns.ignored.clone();
        let unit_from = columns.stated.source(columns.measured, &names);
        Self { mapping, names, roles, rows, header, skipped, is_own, unit_from }
    }

    /// What is guessed of a file whose columns are not known.
    pub(super) fn guessed(
        (sheet, separator): (Option<String>, Option<Separator>),
        roles: Vec<Option<Role>>,
        header: Option<&(usize, StringRecord)>,
        rows: Vec<(usize, Vec<String>)>,
    ) -> Self {
        let names: Vec<String> =
            header.iter().flat_map(|(_, cells)| cells.iter()).map(|name| name.trim().to_owned()).collect();
        let line = header.map(|(line, _)| *line);
        let rows = rows.into_iter().filter(|(row, _)| line.is_none_or(|line| line < *row)).collect();
        let columns = said(&roles, &names);
        let mapping = Mapping { sheet, separator, columns, ..Mapping::default() };
        Self { mapping, names, roles, rows, header: line, skipped: Vec::new(), is_own: false, unit_from: None }
    }

    /// The word of what a column holds, from 0.
    pub fn word(&self, at: usize) -> Option<&'static str> {
        self.roles.get(at).copied().flatten().map(Role::word)
    }

    /// Whether a column holds this.
    pub fn has(&self, role: Role) -> bool {
        self.roles.contains(&Some(role))
    }

    /// Whether it is known of every column what it holds.
    pub const fn knows_all(&self) -> bool {
        self.skipped.is_empty() || self.is_own
    }
}

impl Mapping {
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
        Ok(Detected::of(&sample, &columns))
    }
}

/// Each role with its column, or with all of them.
fn said(roles: &[Option<Role>], names: &[String]) -> BTreeMap<String, Column> {
    let mut all: BTreeMap<String, Column> = BTreeMap::new();
    for (at, role) in roles.iter().enumerate().rev() {
        let Some(role) = role else { continue };
        let column = column_of(at, names);
        match all.get_mut(role.word()) {
            Some(Column::Several(columns)) => columns.insert(0, column),
            _ if *role == Role::Sample => _ = all.insert(role.word().to_owned(), Column::Several(vec![column])),
            _ => _ = all.insert(role.word().to_owned(), column),
        }
    }
    all
}

/// The unit of all that have one; `None` where they differ, so that a mapping leaves it to the names.
fn common(units: &[Option<Unit>]) -> Option<Unit> {
    let mut units = units.iter().flatten();
    let first = *units.next()?;
    units.all(|unit| *unit == first).then_some(first)
}

/// A column by its name, where it is the only one of it.
pub(super) fn column_of(at: usize, names: &[String]) -> Column {
    let name = names.get(at).filter(|name| !name.is_empty() && name.as_str() != "-" && !name.contains(','));
    let is_one = |name: &&String| names.iter().filter(|other| is_named(other, name)).count() == 1;
    name.filter(is_one).map_or(Column::Number(at + 1), |name| Column::Name(name.clone()))
}
