//! The preset table of the control, where the program's folders have one: rows are read for cycle 247, and datum cycles write them.
//!
//! Its place and the names of its columns are those of a TNC 640, from memory (`docs/SOURCES.md`, "Datum cycles"); other controls have fewer columns or other names for the row and
//! the rotation, which are known here, too. What a value in the column of locked rows means is remembered: anything but a blank, `-` and 0
//! counts as locked.

use std::collections::BTreeMap;

use fitcheck_core::length::{Length, Unit};

use super::fault::FaultKind;
use super::files::Files;
use super::path::NcPath;
use super::remark::Remark;
use super::store::StoreError;
use super::values::whole;
use crate::control::mask::FileUse;
use crate::control::table::{ControlTable, TableFile, TableUnit, is_blank};

/// Where a control has it.
const PLACE: &str = r"TNC:\table\preset.pr";

/// The columns with the number of the row: the first that is there.
const NUMBERS: [&str; 2] = ["NO", "NR"];
/// The zero in each axis of the machine.
const AXES: [&str; 3] = ["X", "Y", "Z"];
/// The basic rotation, about Z: the first that is there.
const ROTATIONS: [&str; 2] = ["SPC", "ROT"];
/// Rotations about the other axes, which are not followed.
const TILTS: [&str; 2] = ["SPA", "SPB"];
const LOCKED: &str = "LOCKED";

/// A row of the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PresetRow {
    /// Where its zero is, from that of the machine; `None` where a cell is blank.
    pub zero: [Option<Length>; 3],
    /// Its rotation about Z, degrees; `None` where the table has none.
    pub turned: Option<f64>,
    pub is_tilted: bool,
}

/// What is written into a row: cells that have no value stay.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TableRow {
    /// Where its zero is, from that of the machine.
    pub zero: [Option<Length>; 3],
    /// Its rotation about Z, degrees.
    pub turned: Option<f64>,
}

/// The table as it was read, and what was written into it since.
#[derive(Debug)]
struct PresetTable {
    path: NcPath,
    bytes: Vec<u8>,
    file: TableFile,
    /// The row of the file for each number.
    rows: BTreeMap<u32, usize>,
    axes: [usize; 3],
    changed: BTreeMap<(usize, usize), String>,
}

/// The preset table, looked for once.
#[derive(Debug, Default)]
pub(super) struct Presets {
    is_looked_for: bool,
    table: Option<PresetTable>,
    /// How many times it was written.
    writes: usize,
}

/// Whether a file is the preset table, wherever a program looks for it.
pub(super) fn is_preset_table(path: &NcPath) -> bool {
    PLACE.rsplit_once('\\').is_some_and(|(_, name)| path.file_name().eq_ignore_ascii_case(name))
}

/// The row of a number, where it is one.
pub(super) fn row_number(number: f64) -> Option<u32> {
    whole(number).and_then(|row| u32::try_from(row).ok())
}

impl PresetTable {
    fn read(path: NcPath, bytes: Vec<u8>) -> Result<Self, FaultKind> {
        let name = path.file_name().to_owned();
        let file =
            ControlTable::read_with_short_rows(&bytes, &name).map_err(|error| FaultKind::Table(Box::new(error)))?;
        let column = |column: &str| {
            let names = || file.table.columns.iter().map(|column| column.name.as_str()).collect::<Vec<_>>().join(", ");
            let missing = || FaultKind::NoColumn { table: name.clone(), column: column.to_owned(), columns: names() };
            file.table.column(column).ok_or_else(missing)
        };
        let [x, y, z] = AXES.map(column);
        let axes = [x?, y?, z?];
        let [first, other] = NUMBERS.map(column);
        let number = first.or(other)?;
        let rows = (0..file.table.rows.len()).filter_map(|row| Some((file.table.cell(row, number).parse().ok()?, row)));
        let rows = rows.collect();
        Ok(Self { path, rows, axes, changed: BTreeMap::new(), bytes, file })
    }

    fn unit(&self) -> Unit {
        if self.file.table.unit == Some(TableUnit::Inch) { Unit::Inch } else { Unit::Millimetre }
    }

    fn name(&self) -> String {
        self.path.file_name().to_owned()
    }

    /// The text of a cell, as it is now.
    fn text(&self, row: usize, column: usize) -> &str {
        self.changed.get(&(row, column)).map_or_else(|| self.file.table.cell(row, column), String::as_str)
    }

    /// The row of the file, by its number.
    fn row_of(&self, number: u32) -> Result<usize, FaultKind> {
        self.rows.get(&number).copied().ok_or_else(|| FaultKind::NoPreset { table: self.name(), row: number })
    }

    /// What a cell says; `None` where it is blank.
    fn cell<T>(&self, row: usize, column: usize, read: impl Fn(&str) -> Option<T>) -> Result<Option<T>, FaultKind> {
        let cell = self.text(row, column);
        let table = self.name();
        let name = || self.file.table.columns.get(column).map_or_else(String::new, |column| column.name.clone());
        if self.file.touches(row, column) {
            return Err(FaultKind::Touches { table, row, column: name() });
        }
        if is_blank(cell) {
            return Ok(None);
        }
        let no_number = || FaultKind::NoNumberInCell { table, row, column: name(), cell: cell.to_owned() };
        read(cell).map(Some).ok_or_else(no_number)
    }

    fn value(&self, row: usize, column: usize) -> Result<Option<Length>, FaultKind> {
        self.cell(row, column, |cell| Length::parse_in(cell, self.unit()).ok())
    }

    fn row(&self, number: u32) -> Result<PresetRow, FaultKind> {
        let row = self.row_of(number)?;
        let [x, y, z] = self.axes.map(|column| self.value(row, column));
        let mut tilts = TILTS.into_iter().filter_map(|name| self.file.table.column(name));
        let turns = |column: usize| {
            let cell = self.text(row, column);
            !is_blank(cell) && !cell.parse::<f64>().is_ok_and(|angle| angle.abs() <= 0.0)
        };
        let is_tilted = tilts.any(turns);
        let turned = self.rotation().map(|column| self.angle(row, column)).transpose()?.flatten();
        Ok(PresetRow { zero: [x?, y?, z?], turned, is_tilted })
    }

    /// The column of the rotation about Z.
    fn rotation(&self) -> Option<usize> {
        ROTATIONS.into_iter().find_map(|name| self.file.table.column(name))
    }

    /// Degrees in a cell; `None` where it is blank.
    fn angle(&self, row: usize, column: usize) -> Result<Option<f64>, FaultKind> {
        self.cell(row, column, |cell| cell.parse::<f64>().ok().filter(|angle| angle.abs() <= 360.0))
    }

    fn check_unlocked(&self, number: u32) -> Result<(), FaultKind> {
        let row = self.row_of(number)?;
        let cell = self.file.table.column(LOCKED).map_or("", |column| self.text(row, column));
        if is_blank(cell) || cell == "0" {
            return Ok(());
        }
        Err(FaultKind::PresetLocked { table: self.name(), row: number })
    }

    /// Puts a zero into the axes that have one, and a rotation.
    fn put(&mut self, number: u32, TableRow { zero, turned }: TableRow) -> Result<(), FaultKind> {
        let row = self.row_of(number)?;
        let unit = self.unit();
        for (column, zero) in self.axes.into_iter().zip(zero) {
            let Some(zero) = zero else { continue };
            // In inches the nearest 0.00001 in, the finest that is a whole number of nanometres.
            let text = if unit == Unit::Inch { zero.rounded(Unit::Inch, 5) } else { zero.exact(Unit::Millimetre, 0) };
            let sign = if zero < Length::ZERO { "" } else { "+" };
            self.changed.insert((row, column), format!("{sign}{text}"));
        }
        if let (Some(column), Some(turned)) = (self.rotation(), turned) {
            let before = self.angle(row, column)?.unwrap_or_default();
            if 0.0 < (turned - before).abs() {
                let width = self.file.table.columns.get(column).map_or(0, |column| column.width);
                self.changed.insert((row, column), fitting(turned, width));
            }
        }
        Ok(())
    }
}

/// An angle with as many decimals as a cell has room for, at most six.
fn fitting(degrees: f64, width: usize) -> String {
    let texts = [6, 5, 4, 3, 2, 1, 0].map(|decimals: usize| format!("{degrees:+.decimals$}"));
    texts.into_iter().find(|text| text.len() < width).unwrap_or_else(|| format!("{degrees:+.0}"))
}

impl Presets {
    /// The table; `None` where no folder of the program has one.
    fn table(&mut self, files: &mut Files) -> Result<Option<&mut PresetTable>, FaultKind> {
        if !self.is_looked_for {
            self.is_looked_for = true;
            let path = NcPath::new(PLACE)?;
            self.table = match files.read(&path) {
                Ok(bytes) => Some(PresetTable::read(path, bytes)?),
                Err(FaultKind::Store(StoreError::Missing { .. })) => None,
                Err(fault) => return Err(fault),
            };
        }
        Ok(self.table.as_mut())
    }

    /// Its path, once it was read.
    pub(super) fn path(&self) -> Option<&NcPath> {
        self.table.as_ref().map(|table| &table.path)
    }

    /// A row that a cycle writes: an error where it is locked.
    pub(super) fn unlocked(&mut self, number: u32, files: &mut Files) -> Result<Option<PresetRow>, FaultKind> {
        let Some(table) = self.table(files)? else { return Ok(None) };
        table.check_unlocked(number)?;
        table.row(number).map(Some)
    }

    /// A row as it is now; `None` where there is no table.
    pub(super) fn row(&mut self, number: u32, files: &mut Files) -> Result<Option<PresetRow>, FaultKind> {
        self.table(files)?.map(|table| table.row(number)).transpose()
    }

    /// Writes a zero, from that of the machine, and a rotation into a row and the table into the output folder.
    pub(super) fn write(
        &mut self,
        number: u32,
        written: TableRow,
        files: &mut Files,
    ) -> Result<Option<Remark>, FaultKind> {
        self.table(files)?;
        let Self { table: Some(table), writes, .. } = self else { return Ok(None) };
        // A row 0 that the table lacks is no row that a program names.
        if number == 0 && !table.rows.contains_key(&0) {
            return Ok(None);
        }
        if written.zero == [None; 3] && written.turned.is_none() {
            return Ok(Some(Remark::PresetsLeft { path: table.path.clone() }));
        }
        table.put(number, written)?;
        let written = table.file.patched(&table.bytes, &table.changed);
        let bytes = written.map_err(|error| FaultKind::TableWrite { table: table.name(), error })?;
        let path = table.path.clone();
        files.count_table_write(writes)?;
        let size = files.write(&path, &bytes, FileUse::Replace)?;
        files.spend(size.unwrap_or(bytes.len()))?;
        Ok(Some(if size.is_some() { Remark::TableWritten { path } } else { Remark::NotWritten { path } }))
    }
}
