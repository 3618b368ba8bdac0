//! A control's table as a table of deviations, and the two built-in ones.
//!
//! Layout as program 82551 of NC-Solution 8255 reads it (description of 7/2020): column BEREICH holds the upper,
//! inclusive end of a size range in millimetres; each range has two rows, upper deviation then lower, in micrometres;
//! each tolerance class has one column, and a user's own column may have another name, such as PF. What a column with
//! other content holds is not used, and a warning says so: who writes the table again loses it. Rules: `docs/SOURCES.md`,
//! tables.

mod fault;
mod write;

use std::sync::{Arc, LazyLock};

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::Located;
use fitcheck_core::text::beginning;
use fitcheck_core::tolerance::table::{Column as ClassColumn, TableShapeError};
use fitcheck_core::tolerance::{ClassError, DeviationTable, Deviations, ToleranceClass};
use fitcheck_shipped as shipped;

pub use fault::{DeviationError, DeviationFault, DeviationWarning, DeviationWarningKind};
pub use write::to_control_table;

use super::table::{Column, ControlTable, TableFile, TableUnit, is_blank, is_number};

/// The name of the column with the ends of the size ranges.
const RANGE: &str = "BEREICH";
/// Another spelling of it, used once in the description of NC-Solution 8255.
const RANGE_ALIAS: &str = "BEREIK";
/// The other spelling of the range column's name: NC-Solution 8255 has both, BEREICH and once BEREIK. `None` for any
/// other name.
pub fn other_spelling(name: &str) -> Option<&'static str> {
    match name {
        RANGE => Some(RANGE_ALIAS),
        RANGE_ALIAS => Some(RANGE),
        _ => None,
    }
}

/// The column of the row number: never a deviation.
const ROW_NUMBER: &str = "NR";

/// The tables of NC-Solution 8255: `82553_hole.tab` and `82553_shaft.tab`, embedded in the program.
///
/// They are read once, at the first call.
pub fn shipped_tables() -> Vec<Arc<DeviationTable>> {
    static TABLES: LazyLock<Vec<Arc<DeviationTable>>> = LazyLock::new(|| {
        // The touch-probe table is there, too, but is not a table of deviations.
        let tables = shipped::TABLES.iter().filter_map(|(name, bytes)| match read_table(bytes, name, name, true) {
            Ok((table, _warnings)) => table.map(Arc::new),
            // A test proves that they can be read; without a table, every callout is an error.
            Err(error) => {
                log::error!("shipped table: {error}");
                None
            }
        });
        tables.collect()
    });
    TABLES.clone()
}

/// Reads a table of deviations; a table without a range column is not one, and a warning says so.
///
/// `name` is the name of the result, `file` the name for messages.
///
/// # Errors
/// [`DeviationError`] with file, line and column.
pub fn read_table(
    bytes: &[u8],
    name: &str,
    file: &str,
    shipped: bool,
) -> Result<(Option<DeviationTable>, Vec<DeviationWarning>), DeviationError> {
    let table_file = ControlTable::read(bytes, file)?;
    let mut reading = Reading { file: &table_file, warnings: Vec::new() };
    let table = reading.table(name, shipped)?;
    let mut warnings = reading.warnings;
    if table.is_none() {
        warnings.push(DeviationWarning::NoDeviations { file: file.to_owned() });
    }
    let odd = table_file.warnings.into_iter().map(DeviationWarning::Table);
    Ok((table, odd.chain(warnings).collect()))
}

/// A table that is being read as deviations.
struct Reading<'a> {
    file: &'a TableFile,
    warnings: Vec<DeviationWarning>,
}

type Fault = Located<DeviationFault>;

impl Reading<'_> {
    fn table(&mut self, name: &str, shipped: bool) -> Result<Option<DeviationTable>, Fault> {
        let Some(range) = self.range_column()? else { return Ok(None) };
        let table = &self.file.table;
        if table.unit == Some(TableUnit::Inch) {
            return Err(self.file.at_name(range, DeviationFault::Inch));
        }
        let rows = table.rows.len();
        if !rows.is_multiple_of(2) {
            return Err(self.file.at_cell(rows - 1, 0, DeviationFault::OddRows { rows }));
        }
        let ends = self.ends(range)?;
        let mut columns = Vec::new();
        for (number, column) in table.columns.iter().enumerate() {
            if number != range && column.name != ROW_NUMBER {
                columns.extend(self.class_column(number, column, &ends)?);
            }
        }
        if columns.is_empty() {
            return Err(self.file.at_name(range, DeviationFault::NoClass));
        }
        DeviationTable::new(name, shipped, ends, columns)
            .map(Some)
            .map_err(|shape| self.file.at_name(range, DeviationFault::Shape(shape)))
    }

    fn range_column(&mut self) -> Result<Option<usize>, Fault> {
        match (self.file.table.column(RANGE), self.file.table.column(RANGE_ALIAS)) {
            (Some(_), Some(alias)) => Err(self.file.at_name(alias, DeviationFault::TwoRangeColumns)),
            (None, Some(alias)) => {
                self.warn(alias, DeviationWarningKind::RangeAlias);
                Ok(Some(alias))
            }
            (range, None) => Ok(range),
        }
    }

    /// The ends of the ranges: in the even rows; an odd row has the same end or none.
    fn ends(&self, range: usize) -> Result<Vec<Length>, Fault> {
        let mut ends: Vec<Length> = Vec::with_capacity(self.file.table.rows.len() / 2);
        let mut before = Length::ZERO;
        for row in (0..self.file.table.rows.len()).step_by(2) {
            let Some(end) = self.value(row, range, Unit::Millimetre)? else {
                return Err(self.file.at_cell(row, range, DeviationFault::NoRange));
            };
            if end <= before {
                let shape = TableShapeError::NotAscending { end, before };
                return Err(self.file.at_cell(row, range, DeviationFault::Shape(shape)));
            }
            let repeated = self.value(row + 1, range, Unit::Millimetre)?;
            if let Some(found) = repeated.filter(|found| *found != end) {
                return Err(self.file.at_cell(row + 1, range, DeviationFault::OtherRange { end, found }));
            }
            ends.push(end);
            before = end;
        }
        if ends.is_empty() {
            return Err(self.file.at_name(range, DeviationFault::Shape(TableShapeError::NoRanges)));
        }
        Ok(ends)
    }

    /// A column of deviations, or `None` for a column with other content.
    fn class_column(&mut self, number: usize, column: &Column, ends: &[Length]) -> Result<Option<ClassColumn>, Fault> {
        let class: ToleranceClass = match column.name.parse() {
            Ok(class) => class,
            // "Js7", "Pf": probably meant as a class; "Remark" over texts is not.
            Err(ClassError::MixedCase { .. }) if self.has_numbers(number) => {
                self.warn(number, DeviationWarningKind::MixedCase { name: column.name.clone() });
                return Ok(None);
            }
            Err(_no_class) => {
                if self.has_text(number) {
                    self.warn(number, DeviationWarningKind::OtherColumn { name: column.name.clone() });
                }
                return Ok(None);
            }
        };
        // Texts under a name that could be a class; a name without a grade is more often that of a remark, so there the
        // block decides, too.
        let is_remark = column.is_text() == Some(true) && !class.has_grade();
        if is_remark || self.has_text(number) && !self.has_numbers(number) {
            if self.has_text(number) {
                self.warn(number, DeviationWarningKind::NoNumbers { name: column.name.clone() });
            }
            return Ok(None);
        }
        let mut cells = Vec::with_capacity(ends.len());
        for (pair, &end) in ends.iter().enumerate() {
            cells.push(self.deviations(pair * 2, number, class, end)?);
        }
        Ok(Some(ClassColumn { class, cells }))
    }

    fn deviations(
        &self,
        row: usize,
        number: usize,
        class: ToleranceClass,
        end: Length,
    ) -> Result<Option<Deviations>, Fault> {
        let upper = self.value(row, number, Unit::Micrometre)?;
        let lower = self.value(row + 1, number, Unit::Micrometre)?;
        match (upper, lower) {
            (None, None) => Ok(None),
            (Some(upper), Some(lower)) => Deviations::new(upper, lower)
                .map(Some)
                .map_err(|error| self.file.at_cell(row + 1, number, DeviationFault::Order { class, error })),
            (upper, _) => {
                let missing = if upper.is_none() { row } else { row + 1 };
                Err(self.file.at_cell(missing, number, DeviationFault::Half { class, end }))
            }
        }
    }

    fn has_text(&self, column: usize) -> bool {
        (0..self.file.table.rows.len()).any(|row| !is_blank(self.file.table.cell(row, column)))
    }

    fn has_numbers(&self, column: usize) -> bool {
        (0..self.file.table.rows.len()).any(|row| is_number(self.file.table.cell(row, column)))
    }

    /// The number in a cell; `None` for a blank cell and for `-`.
    fn value(&self, row: usize, column: usize, unit: Unit) -> Result<Option<Length>, Fault> {
        let cell = self.file.table.cell(row, column);
        let name = || self.file.table.columns.get(column).map_or_else(String::new, |column| column.name.clone());
        if self.file.touches(row, column) {
            return Err(self.file.at_cell(row, column, DeviationFault::Touches { column: name() }));
        }
        if is_blank(cell) {
            return Ok(None);
        }
        // A cell holds a bare number; a cell with its own unit is an error.
        let value = if is_number(cell) || is_ambiguous(cell) {
            Length::parse_in(cell, unit)
        } else {
            Err(LengthError::NotANumber { text: beginning(cell) })
        };
        value
            .map(Some)
            .map_err(|error| self.file.at_cell(row, column, DeviationFault::Number { column: name(), error }))
    }

    /// A warning about a column, located at its name.
    fn warn(&mut self, column: usize, what: DeviationWarningKind) {
        self.warnings.push(DeviationWarning::Content(self.file.at_name(column, what)));
    }
}

/// Two kinds of decimal signs: [`Length`] has its own error for that.
fn is_ambiguous(cell: &str) -> bool {
    cell.contains('.') && cell.contains(',') && cell.bytes().all(|byte| b"+-.,0123456789".contains(&byte))
}
