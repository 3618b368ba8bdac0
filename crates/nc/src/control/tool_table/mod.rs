//! The tool table `tool.t`: from rows of a control's table to tools, and back with changed cells.
//!
//! T, NAME, L, R, DL, DR, TL, RT, LBREAK, RBREAK and TYP are used, other columns are kept and not read. Names of the
//! columns and ranges: manuals of TNC 320, TNC 620 and TNC7 and a public file, see `docs/SOURCES.md`.
//!
//! | file | what |
//! |---|---|
//! | `number` | the number of a tool, 5 or 5.1 |
//! | `columns` | from the rows to tools |
//! | `fault` | why a file is not a tool table |
//! | `monitor` | Q330: what the result of a cycle changes |

mod columns;
mod fault;
mod monitor;
mod number;

use std::collections::BTreeMap;
use std::sync::Arc;

pub use fault::{ToolTableError, ToolTableFault};
pub use monitor::{Breakage, Changed, Monitored, ToolChange, ToolFault};
pub use number::{NoToolNumber, ToolNumber};

use super::table::{ControlTable, TableFile, TableWarning, TableWarningKind, WriteError, is_blank};
use columns::Columns;
use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::{FilePlace, Located};

/// TYP of a touch probe (manual TNC7, tool types).
pub const PROBE: u32 = 21;

/// The text of TL for a locked tool.
const LOCKED: &str = "L";

/// A row of the tool table. Lengths are exact, whatever the table's unit.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Tool {
    /// T.
    pub number: ToolNumber,
    /// NAME; empty if it has none.
    pub name: String,
    /// L.
    pub length: Length,
    /// R.
    pub radius: Length,
    /// DL, which measuring cycles change; plus is oversize.
    pub delta_length: Length,
    /// DR, the same.
    pub delta_radius: Length,
    /// TL.
    pub is_locked: bool,
    /// RT, the tool that takes its place.
    pub replacement: Option<ToolNumber>,
    /// LBREAK, above 0; `None` where breakage of the length is not monitored.
    pub length_breakage: Option<Length>,
    /// RBREAK, the same for the radius.
    pub radius_breakage: Option<Length>,
    /// TYP, where the table says it.
    pub kind: Option<u32>,
}

impl Tool {
    /// Whether the table says that it is something else than a touch probe.
    pub fn is_no_probe(&self) -> bool {
        self.kind.is_some_and(|kind| kind != PROBE)
    }
}

/// The columns that measuring cycles change by a length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DeltaColumn {
    /// DL.
    Length,
    /// DR.
    Radius,
}

impl DeltaColumn {
    /// The largest value, 999.9999 mm either way.
    pub const MOST: Length = Length::constant(999_999_900);

    pub const fn name(self) -> &'static str {
        match self {
            Self::Length => "DL",
            Self::Radius => "DR",
        }
    }

    /// The name of the column with its breakage tolerance.
    pub const fn breakage(self) -> &'static str {
        match self {
            Self::Length => "LBREAK",
            Self::Radius => "RBREAK",
        }
    }
}

/// A tool table, as read and as changed since.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ToolTable {
    tools: Vec<Tool>,
    /// The row of each number.
    numbers: BTreeMap<ToolNumber, usize>,
    /// The rows of each name, in capitals.
    names: BTreeMap<String, Vec<usize>>,
    unit: Unit,
    /// The file that it was read from.
    bytes: Arc<[u8]>,
    file: Arc<TableFile>,
    columns: Columns,
    /// The texts of changed cells, by row and column.
    changed: BTreeMap<(usize, usize), String>,
}

impl ToolTable {
    /// Reads a table; `file` is its name in messages. Lengths are in the unit of the BEGIN line, else in
    /// millimetres, with a warning.
    /// Rows may end where only blank cells follow; blank numbers are 0.
    ///
    /// ```
    /// use fitcheck_nc::control::tool_table::ToolTable;
    ///
    /// let bytes = b"BEGIN TOOL.T MM\nT   NAME   L   R   DL  DR      TL\n5   MILL   +90 +6  +0  -0.005  L\n[END]\n";
    /// let table = ToolTable::read(bytes, "tool.t")?;
    /// assert_eq!(table.tools()[0].delta_radius.to_string(), "-0.005");
    /// assert!(table.tools()[0].is_locked);
    /// # Ok::<(), fitcheck_nc::control::tool_table::ToolTableError>(())
    /// ```
    ///
    /// # Errors
    /// [`ToolTableError`] with file, line and column.
    pub fn read(bytes: &[u8], file: &str) -> Result<Self, ToolTableError> {
        let name: Arc<str> = file.into();
        let mut file = ControlTable::read_with_short_rows(bytes, &name)?;
        if file.table.unit.is_none() {
            let place = FilePlace { file: Some(Arc::clone(&name)), ..FilePlace::default() };
            file.warnings.push(Located { what: TableWarningKind::NoUnit, place });
        }
        let columns = Columns::of(&file)?;
        if columns.lock.is_none() {
            let place = FilePlace { file: Some(Arc::clone(&name)), ..FilePlace::default() };
            file.warnings.push(Located { what: TableWarningKind::NoLock, place });
        }
        let mut tools = Vec::new();
        let mut numbers = BTreeMap::new();
        let mut names = BTreeMap::<_, Vec<_>>::new();
        for row in 0..file.table.rows.len() {
            let tool = columns.tool(&file, row)?;
            if numbers.insert(tool.number, row).is_some() {
                return Err(file.at_cell(row, columns.number, ToolTableFault::Twice { number: tool.number }).into());
            }
            if !tool.name.is_empty() {
                names.entry(tool.name.to_uppercase()).or_default().push(row);
            }
            tools.push(tool);
        }
        if tools.is_empty() {
            return Err(file.at_name(columns.number, ToolTableFault::NoTool).into());
        }
        let unit = columns::unit(&file);
        let bytes = bytes.into();
        let file = Arc::new(file);
        let changed = BTreeMap::new();
        Ok(Self { tools, numbers, names, unit, bytes, file, columns, changed })
    }

    /// The tools in the table's order, at least one; no number occurs twice.
    pub fn tools(&self) -> &[Tool] {
        &self.tools
    }

    /// Warnings about a table that could still be read.
    pub fn warnings(&self) -> &[TableWarning] {
        &self.file.warnings
    }

    /// The row of a tool by its number.
    pub fn row_of(&self, number: ToolNumber) -> Option<usize> {
        self.numbers.get(&number).copied()
    }

    /// The rows of the tools with a name, which controls keep in capitals; several may have the same.
    pub fn rows_named(&self, name: &str) -> &[usize] {
        self.names.get(&name.to_uppercase()).map_or(&[], Vec::as_slice)
    }

    /// The file with its changed cells; every other byte is as it was read.
    ///
    /// # Errors
    /// [`WriteError`] if a new value does not fit into its column.
    pub fn write(&self) -> Result<Vec<u8>, WriteError> {
        self.file.patched(&self.bytes, &self.changed)
    }

    /// The text of a cell, as it is now.
    fn text(&self, row: usize, column: usize) -> &str {
        self.changed.get(&(row, column)).map_or_else(|| self.file.table.cell(row, column), String::as_str)
    }

    /// Changes DL or DR. In a table in inches the value becomes the nearest 0.00001 in, the finest that is a whole number
    /// of nanometres; in millimetres it is exact. Returns the value that the table has now, or `None` beyond the range.
    fn set_delta(&mut self, row: usize, column: DeltaColumn, value: Length) -> Option<Length> {
        let text = match self.unit {
            Unit::Inch => value.rounded(Unit::Inch, 5),
            Unit::Millimetre | Unit::Micrometre => value.exact(Unit::Millimetre, 0),
        };
        let value = Length::parse_in(&text, self.unit).ok().filter(|value| value.abs() <= DeltaColumn::MOST)?;
        let tool = self.tools.get_mut(row)?;
        let number = match column {
            DeltaColumn::Length => {
                tool.delta_length = value;
                self.columns.delta_length
            }
            DeltaColumn::Radius => {
                tool.delta_radius = value;
                self.columns.delta_radius
            }
        };
        let sign = if value < Length::ZERO { "" } else { "+" };
        self.put(row, number, format!("{sign}{text}"), |text, unit| {
            is_blank(text) && value == Length::ZERO || Length::parse_in(text, unit) == Ok(value)
        });
        Some(value)
    }

    fn lock(&mut self, row: usize) {
        let Some(tool) = self.tools.get_mut(row) else { return };
        if !tool.is_locked {
            tool.is_locked = true;
            if let Some(column) = self.columns.lock {
                self.put(row, column, LOCKED.to_owned(), |_text, _unit| false);
            }
        }
    }

    /// Keeps the new text of a cell, or none where the file says the same.
    fn put(&mut self, row: usize, column: usize, text: String, is_same: impl Fn(&str, Unit) -> bool) {
        if is_same(self.file.table.cell(row, column), self.unit) {
            self.changed.remove(&(row, column));
        } else {
            self.changed.insert((row, column), text);
        }
    }
}
