//! What a file states about the unit of its lengths beside the names of its columns: the one place that decides, for every reader of
//! columns and for `batch`.
//!
//! | where | what is done |
//! |---|---|
//! | a title above the header, a comment above the first row | the unit of every length that says no other one |
//! | a row of units below the header | the unit of each column |
//! | a column of units | the unit of each row, nominal size and measured value alike |
//! | a title or comment behind rows | must say what was read before |
//! | what the user says | must be what the file says |
//!
//! Two statements that contradict each other, and one that is not understood, are refused. `mention` has the words, `decide` the
//! decision by the first rows, `late` the lines behind them.

mod decide;
mod late;
mod mention;

use csv::StringRecord;

use super::column::{LengthColumn, name_of};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::refused::{Cell, Refused};
use super::{cells, units};
use crate::exchange::cell;
use crate::exchange::cell::Cells as _;
pub(super) use decide::decide;
use fitcheck_core::length::Unit;
pub(super) use late::{agree, stray, stray_row, unit_lines};
use mention::{Word, behind_number, word};
pub(super) use mention::{
    are_units, inch_in, is_row_of_units, may_state, names_units, not_mm, plain_unit, states_other,
};

/// What a file states.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Stated {
    /// The columns whose cells state the unit of their rows.
    pub(super) columns: Vec<usize>,
    /// Those of them that state the unit of a temperature, as far as was seen.
    others: Vec<usize>,
    /// The unit of all lengths, by a statement or by the user.
    file: Option<Unit>,
    /// The line and the text of that statement.
    from: Option<(usize, String)>,
    /// Whether the user said it.
    is_given: bool,
    /// The row of units with its line.
    row: Option<(usize, StringRecord)>,
    /// The columns that state their own unit, by name or in the row of units.
    own: Vec<(usize, Unit)>,
    /// The only unit of the first rows, where a column states them.
    sampled: Option<Unit>,
    /// The letters of the header, to know it where it is repeated.
    header: String,
    /// The line of the first row.
    first: usize,
}

/// A line without what separates its words.
fn squeezed<'c>(cells: impl Iterator<Item = &'c str>) -> String {
    cells.flat_map(str::chars).filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// A line as errors repeat it.
fn joined(cells: &StringRecord) -> String {
    shorten(&cell::joined(cells))
}

pub(super) const fn sign(unit: Unit) -> &'static str {
    match unit {
        Unit::Millimetre => "mm",
        Unit::Micrometre => "\u{b5}m",
        Unit::Inch => "inch",
    }
}

fn differ((unit, at): (Unit, &str), (other, other_at): (Unit, &str)) -> ImportErrorKind {
    ImportErrorKind::UnitsDiffer { unit: sign(unit), at: shorten(at), other: sign(other), other_at: shorten(other_at) }
}

impl Stated {
    /// The unit of the first rows; `None` where they have several.
    fn decided(&self, measured: LengthColumn) -> Option<Unit> {
        if self.columns.is_empty() { Some(measured.unit) } else { self.file.or(self.sampled) }
    }

    /// Whether a row gives the units of the columns.
    pub(super) fn is_row_of_units(&self, cells: &StringRecord) -> bool {
        self.row.as_ref().is_some_and(|(_, row)| row == cells)
    }

    /// Whether a row is the names of the columns once more.
    pub(super) fn repeats_names(&self, cells: &StringRecord) -> bool {
        !self.header.is_empty() && squeezed(cells.iter()) == self.header
    }

    /// The line of the first row.
    pub(super) const fn first(&self) -> usize {
        self.first
    }

    /// The unit that the cells of a row state.
    fn of_row<'c>(&self, cells: &'c StringRecord) -> Result<Option<Unit>, Refused<'c>> {
        let mut found: Option<(Unit, &str)> = None;
        for &at in &self.columns {
            let text = cells.cell(at).trim();
            let cell = Cell { at: Some(at), text };
            let is_other = self.others.contains(&at);
            let unit = match word(text) {
                Word::Length(unit) => unit,
                Word::Other if is_other => continue,
                _ if text.is_empty() && (is_other || self.is_given) => continue,
                _ if text.is_empty() => return Err((cell, ImportErrorKind::UnitMissing)),
                _ => return Err((cell, ImportErrorKind::Unit { unit: shorten(text) })),
            };
            let before = found.or_else(|| Some((self.file?, self.from.as_ref().map_or("--columns", |(_, text)| text))));
            if let Some((before, text_before)) = before.filter(|(before, _)| *before != unit) {
                return Err((cell, differ((before, text_before), (unit, text))));
            }
            found = Some((unit, text));
        }
        Ok(found.map(|(unit, _)| unit))
    }

    /// A column of sizes as a row has it.
    pub(super) fn in_row<'c>(
        &self,
        column: LengthColumn,
        cells: &'c StringRecord,
    ) -> Result<LengthColumn, Refused<'c>> {
        if self.columns.is_empty() {
            return Ok(column);
        }
        let Some(unit) = self.of_row(cells)? else { return Ok(column) };
        let text = cells.cell(column.at).trim();
        let cell = Cell { at: Some(column.at), text };
        if let Some((_, own)) = self.own.iter().find(|(own, own_unit)| *own == column.at && *own_unit != unit) {
            return Err((cell, differ((*own, &name_of(column.at, "")), (unit, sign(unit)))));
        }
        if let Some(own) = behind_number(text).filter(|own| *own != unit) {
            return Err((cell, differ((own, text), (unit, sign(unit)))));
        }
        Ok(LengthColumn { unit, ..column })
    }

    /// A column of limits as a row has it: deviations may be in a unit of their own, beside sizes in that of the row.
    pub(super) fn of_limit<'c>(
        &self,
        column: LengthColumn,
        cells: &'c StringRecord,
    ) -> Result<LengthColumn, Refused<'c>> {
        let has_own = self.own.iter().any(|(own, _)| *own == column.at);
        if has_own { Ok(column) } else { self.in_row(column, cells) }
    }

    /// The unit of a coordinate in a row.
    pub(super) fn of_place(&self, column: LengthColumn, cells: &StringRecord) -> Unit {
        let has_own = self.own.iter().any(|(own, _)| *own == column.at);
        let of_row = || self.of_row(cells).ok().flatten();
        if self.columns.is_empty() || has_own { column.unit } else { of_row().unwrap_or(column.unit) }
    }

    /// Whether a statement says that all lengths of a row are in inch: a callout with a size, which is in mm, would be doubtful.
    pub(super) fn is_inch(&self, cells: &StringRecord) -> bool {
        !self.is_given
            && (self.file == Some(Unit::Inch) || self.of_row(cells).is_ok_and(|unit| unit == Some(Unit::Inch)))
    }

    /// Whether rows are judged by the units of their columns, or by the only column of units; `None` where each row is looked at closely.
    pub(super) fn plain(&self) -> Option<(Option<usize>, bool)> {
        let is_inch = !self.is_given && self.file == Some(Unit::Inch);
        match self.columns.as_slice() {
            [] => Some((None, is_inch)),
            [at] if self.own.is_empty() && self.file.is_none() && self.others.is_empty() => Some((Some(*at), is_inch)),
            _ => None,
        }
    }

    /// What is said of a unit that is not mm and that no name of a column says, with its line.
    pub(super) fn told(&self, measured: LengthColumn) -> Option<(usize, ImportWarningKind)> {
        let unit = measured.unit;
        if unit == Unit::Millimetre {
            return None;
        }
        let of_row = |(line, cells): &(usize, StringRecord)| {
            let is_stated = cells.get(measured.at).is_some_and(|cell| units::known(cell).is_some());
            is_stated.then(|| (*line, joined(cells)))
        };
        let (line, text) = self.from.clone().or_else(|| self.row.as_ref().and_then(of_row))?;
        Some((line, ImportWarningKind::UnitRead { unit: sign(unit).to_owned(), text }))
    }

    /// What says the unit of measured values, as the file has it; `None` where nothing does.
    pub(super) fn source(&self, measured: LengthColumn, names: &[String]) -> Option<String> {
        let name = |at: usize| name_of(at, names.get(at).map_or("", String::as_str));
        if let Some(at) = self.columns.first() {
            return Some(name(*at));
        }
        let measured = measured.at;
        if let Some((_, text)) = &self.from {
            return Some(text.clone());
        }
        self.own.iter().find(|(at, _)| *at == measured)?;
        let in_row = |(_, cells): &(usize, StringRecord)| {
            let cell = cells.cell(measured);
            (!cells::is_blank(cells) && units::known(cell).is_some()).then(|| joined(cells))
        };
        self.row.as_ref().and_then(in_row).or_else(|| Some(name(measured)))
    }
}
