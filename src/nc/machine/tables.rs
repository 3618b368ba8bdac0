//! FN 26, FN 27 and FN 28: one table is open at a time.

use std::sync::Arc;

use super::fault::FaultKind;
use super::flow::whole;
use super::path::NcPath;
use super::remark::Remark;
use super::run::Machine;
use super::store::StoreError;
use crate::control::mask::FileUse;
use crate::control::table::{TableFile, WriteError, is_blank, is_number};
use crate::control::variables::{Family, Parameter, Value};
use crate::nc::program::{Columns, Operand, TextOperand};

/// A table that FN 26 has opened.
#[derive(Debug, Clone)]
pub(super) struct OpenTable {
    path: NcPath,
    file: Arc<TableFile>,
    bytes: usize,
    /// The block that changed it first.
    changed_at: Option<usize>,
}

impl OpenTable {
    pub(super) const fn path(&self) -> &NcPath {
        &self.path
    }

    fn name(&self) -> String {
        self.path.file_name().to_owned()
    }

    /// The number of a column; upper and lower case count.
    fn column(&self, name: &str) -> Result<usize, FaultKind> {
        let table = &self.file.table;
        table.column(name).ok_or_else(|| {
            let columns: Vec<&str> = table.columns.iter().map(|column| column.name.as_str()).collect();
            FaultKind::NoColumn { table: self.name(), column: name.to_owned(), columns: columns.join(", ") }
        })
    }

    fn check_row(&self, row: usize) -> Result<(), FaultKind> {
        let rows = self.file.table.rows.len();
        match rows.checked_sub(1) {
            None => Err(FaultKind::NoRows(self.name())),
            Some(last) if last < row => Err(FaultKind::NoRow { table: self.name(), row, last }),
            Some(_) => Ok(()),
        }
    }

    /// The value of a cell for a parameter.
    fn read(&self, row: usize, column: &str, to: Parameter) -> Result<Value, FaultKind> {
        let number = self.column(column)?;
        self.check_row(row)?;
        let cell = self.file.table.cell(row, number);
        let (table, column) = (self.name(), column.to_owned());
        if to.family == Family::Qs && !cell.is_empty() {
            return Ok(Value::Text(cell.to_owned()));
        }
        if is_blank(cell) {
            return Err(FaultKind::EmptyCell { table, row, column });
        }
        if self.file.touches(row, number) {
            return Err(FaultKind::Touches { table, row, column });
        }
        let plain = cell.replace(',', ".").replace('\u{2212}', "-");
        match plain.parse() {
            Ok(value) if is_number(cell) => Ok(Value::Number(value)),
            _ => Err(FaultKind::NoNumberInCell { table, row, column, cell: cell.to_owned() }),
        }
    }
}

impl Machine {
    /// FN 26: another table that is open is closed before.
    pub(super) fn open_table(&mut self, path: &TextOperand) -> Result<(), FaultKind> {
        let path = self.path_of(path)?;
        if self.table.as_ref().is_some_and(|open| open.path == path) {
            return Ok(());
        }
        self.write_tables()?;
        if let Some(changed) = self.changed_tables.get(&path) {
            self.table = Some(changed.clone());
            return Ok(());
        }
        let bytes = self.read(&path)?;
        let size = bytes.len();
        let file = self.known.table(&path, bytes).map_err(|error| FaultKind::Table(Box::new(error)))?;
        self.table = Some(OpenTable { path, file, bytes: size, changed_at: None });
        Ok(())
    }

    /// FN 28: one column fills the parameter, several fill those behind it as well.
    pub(super) fn read_table(&mut self, to: Parameter, row: Operand, columns: &Columns) -> Result<(), FaultKind> {
        let open = self.table.as_ref().ok_or(FaultKind::NoTable)?;
        let row = self.row(row)?;
        let mut found = Vec::new();
        for (column, to) in self.columns(columns)?.iter().zip(following(to)) {
            found.push((to, open.read(row, column, to)?));
        }
        found.into_iter().try_for_each(|(to, value)| self.put(to, value))
    }

    /// FN 27: in memory; the file is written when the table is closed.
    pub(super) fn write_table(&mut self, row: Operand, columns: &Columns, from: Parameter) -> Result<(), FaultKind> {
        let open = self.table.as_ref().ok_or(FaultKind::NoTable)?;
        let row = self.row(row)?;
        let columns = self.columns(columns)?;
        let mut cells = Vec::new();
        for (column, from) in columns.iter().zip(following(from)) {
            let number = open.column(column)?;
            open.check_row(row)?;
            cells.push((number, self.cell(open, row, number, from)?));
        }
        let (is_first, bytes) = (open.changed_at.is_none(), open.bytes);
        if is_first {
            self.keep_file(bytes)?;
        }
        let at = self.frame.next.saturating_sub(1);
        if let Some(open) = &mut self.table {
            open.changed_at.get_or_insert(at);
            let rows = &mut Arc::make_mut(&mut open.file).table.rows;
            for (number, text) in cells {
                if let Some(cell) = rows.get_mut(row).and_then(|cells| cells.get_mut(number)) {
                    *cell = text;
                }
            }
        }
        Ok(())
    }

    /// What a parameter writes into a cell: a text, or a number with the column's decimals.
    fn cell(&self, open: &OpenTable, row: usize, number: usize, from: Parameter) -> Result<String, FaultKind> {
        let Some(column) = open.file.table.columns.get(number) else { return Ok(String::new()) };
        let text = if from.family == Family::Qs {
            let text = self.text(from)?.to_owned();
            if column.is_text() == Some(false) && !is_number(&text) && !is_blank(&text) {
                return Err(FaultKind::NoNumberInText { parameter: from, text });
            }
            text
        } else {
            self.decimal(Operand::Parameter { parameter: from, is_negative: false }, column.decimals)?
        };
        // A blank must be left between the columns.
        if column.width <= text.chars().count() {
            let error = WriteError::TooWide { row, column: column.name.clone(), text, width: column.width };
            return Err(FaultKind::TableWrite { table: open.name(), error });
        }
        Ok(text)
    }

    fn row(&self, row: Operand) -> Result<usize, FaultKind> {
        let value = self.operand(row)?;
        whole(value).ok_or(FaultKind::NotWhole { what: "row", value })
    }

    fn columns<'a>(&'a self, columns: &'a Columns) -> Result<Vec<&'a str>, FaultKind> {
        Ok(match columns {
            Columns::Names(names) => names.iter().map(String::as_str).collect(),
            Columns::Parameter(parameter) => self.text(*parameter)?.split(',').map(str::trim).collect(),
        })
    }

    /// Writes the open table where FN 27 has changed it. Where nothing is written, the change lives on in memory.
    pub(super) fn write_tables(&mut self) -> Result<(), FaultKind> {
        let Some(open) = self.table.take() else { return Ok(()) };
        let Some(changed_at) = open.changed_at else { return Ok(()) };
        let written = open.file.table.write();
        let bytes = written.map_err(|error| FaultKind::TableWrite { table: open.name(), error })?;
        match self.store.write(&open.path, &bytes, FileUse::Replace) {
            Err(StoreError::ReadOnly) => {
                self.remark(changed_at, Remark::NotWritten { path: open.path.clone() });
                self.changed_tables.insert(open.path.clone(), open);
                // It was put together all the same: a loop around a large table would go on for days.
                self.moved(bytes.len())
            }
            done => {
                let size = done?;
                self.remark(changed_at, Remark::TableWritten { path: open.path });
                self.moved(size)
            }
        }
    }
}

/// A parameter and those behind it.
fn following(first: Parameter) -> impl Iterator<Item = Parameter> {
    (first.number..=u16::MAX).map(move |number| Parameter { number, ..first })
}
