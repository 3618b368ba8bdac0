//! From the rows of the table to tools: the columns that are used, and what their cells may hold.

use fitcheck_core::length::{Length, Unit};

use super::{DeltaColumn, Tool, ToolNumber, ToolTableError, ToolTableFault};
use crate::control::table::{TableFile, TableUnit, is_blank};

/// The most characters of a name (manual TNC7, tool table).
const LONGEST_NAME: usize = 32;
/// The largest length or radius, 99999.9999 mm either way.
const LARGEST: Length = Length::constant(99_999_999_900);

/// The positions of the columns; those that a table may lack are `None`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) number: usize,
    name: Option<usize>,
    length: usize,
    radius: usize,
    pub(super) delta_length: usize,
    pub(super) delta_radius: usize,
    pub(super) lock: Option<usize>,
    replacement: Option<usize>,
    length_breakage: Option<usize>,
    radius_breakage: Option<usize>,
    kind: Option<usize>,
}

impl Columns {
    pub(super) fn of(file: &TableFile) -> Result<Self, ToolTableError> {
        let column = |name| {
            let missing = || file.at_name(0, ToolTableFault::NoColumn { column: name });
            file.table.column(name).ok_or_else(missing)
        };
        Ok(Self {
            number: column("T")?,
            name: file.table.column("NAME"),
            length: column("L")?,
            radius: column("R")?,
            delta_length: column(DeltaColumn::Length.name())?,
            delta_radius: column(DeltaColumn::Radius.name())?,
            lock: file.table.column("TL"),
            replacement: file.table.column("RT"),
            length_breakage: file.table.column(DeltaColumn::Length.breakage()),
            radius_breakage: file.table.column(DeltaColumn::Radius.breakage()),
            kind: file.table.column("TYP"),
        })
    }

    pub(super) fn tool(&self, file: &TableFile, row: usize) -> Result<Tool, ToolTableError> {
        let cells = ToolRow { file, row };
        Ok(Tool {
            number: cells.number(self.number, "T")?,
            name: cells.name(self.name)?,
            length: cells.length(self.length, "L", LARGEST.negated(), LARGEST)?,
            radius: cells.length(self.radius, "R", LARGEST.negated(), LARGEST)?,
            delta_length: cells.delta(self.delta_length, DeltaColumn::Length)?,
            delta_radius: cells.delta(self.delta_radius, DeltaColumn::Radius)?,
            is_locked: cells.is_locked(self.lock)?,
            replacement: cells.replacement(self.replacement)?,
            length_breakage: cells.breakage(self.length_breakage, DeltaColumn::Length)?,
            radius_breakage: cells.breakage(self.radius_breakage, DeltaColumn::Radius)?,
            kind: cells.kind(self.kind)?,
        })
    }
}

/// The unit of the table's lengths: millimetres where the BEGIN line says nothing.
pub(super) fn unit(file: &TableFile) -> Unit {
    if file.table.unit == Some(TableUnit::Inch) { Unit::Inch } else { Unit::Millimetre }
}

/// A row of the table.
struct ToolRow<'a> {
    file: &'a TableFile,
    row: usize,
}

impl<'a> ToolRow<'a> {
    /// The text of a cell that is not blank.
    fn text(&self, column: Option<usize>, name: &'static str) -> Result<Option<&'a str>, ToolTableError> {
        let Some(column) = column else { return Ok(None) };
        let text = self.file.table.cell(self.row, column);
        if is_blank(text) {
            return Ok(None);
        }
        if self.file.touches(self.row, column) {
            return Err(self.fault(column, ToolTableFault::Touches { column: name }));
        }
        Ok(Some(text))
    }

    fn fault(&self, column: usize, what: ToolTableFault) -> ToolTableError {
        self.file.at_cell(self.row, column, what).into()
    }

    fn number(&self, column: usize, name: &'static str) -> Result<ToolNumber, ToolTableError> {
        // A blank cell is an empty text, and that is no number.
        let text = self.text(Some(column), name)?.map_or("", |text| text);
        let given = || ToolTableFault::NoNumber { column: name, given: text.to_owned() };
        text.parse().map_err(|_number| self.fault(column, given()))
    }

    fn name(&self, column: Option<usize>) -> Result<String, ToolTableError> {
        let (Some(text), Some(column)) = (self.text(column, "NAME")?, column) else { return Ok(String::new()) };
        if LONGEST_NAME < text.chars().count() {
            let fault = ToolTableFault::NameTooLong { given: text.to_owned(), most: LONGEST_NAME };
            return Err(self.fault(column, fault));
        }
        Ok(text.to_owned())
    }

    /// A length within a range, in the table's unit; a blank cell is 0.
    fn length(&self, column: usize, name: &'static str, least: Length, most: Length) -> Result<Length, ToolTableError> {
        let Some(text) = self.text(Some(column), name)? else { return Ok(Length::ZERO) };
        let read = Length::parse_in(text, unit(self.file));
        let given = read.map_err(|error| self.fault(column, ToolTableFault::NoLength { column: name, error }))?;
        if given < least || most < given {
            return Err(self.fault(column, ToolTableFault::OutOfRange { column: name, given, least, most }));
        }
        Ok(given)
    }

    fn delta(&self, column: usize, of: DeltaColumn) -> Result<Length, ToolTableError> {
        self.length(column, of.name(), DeltaColumn::MOST.negated(), DeltaColumn::MOST)
    }

    /// A breakage tolerance; blank or 0 monitors nothing.
    fn breakage(&self, column: Option<usize>, of: DeltaColumn) -> Result<Option<Length>, ToolTableError> {
        let Some(column) = column else { return Ok(None) };
        let most = self.length(column, of.breakage(), Length::ZERO, LARGEST)?;
        Ok((Length::ZERO < most).then_some(most))
    }

    fn is_locked(&self, column: Option<usize>) -> Result<bool, ToolTableError> {
        match (self.text(column, "TL")?, column) {
            (None | Some("0"), _) | (_, None) => Ok(false),
            (Some("L" | "1"), _) => Ok(true),
            (Some(given), Some(column)) => Err(self.fault(column, ToolTableFault::NoLock { given: given.to_owned() })),
        }
    }

    /// The replacement tool; blank or 0 is none.
    fn replacement(&self, column: Option<usize>) -> Result<Option<ToolNumber>, ToolTableError> {
        let (Some(text), Some(column)) = (self.text(column, "RT")?, column) else { return Ok(None) };
        if text == "0" { Ok(None) } else { self.number(column, "RT").map(Some) }
    }

    fn kind(&self, column: Option<usize>) -> Result<Option<u32>, ToolTableError> {
        let (Some(text), Some(column)) = (self.text(column, "TYP")?, column) else { return Ok(None) };
        let given = || ToolTableFault::NotWhole { column: "TYP", given: text.to_owned() };
        text.parse().map(Some).map_err(|_whole| self.fault(column, given()))
    }
}
