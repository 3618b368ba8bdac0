//! A table as it is in a file.

use std::sync::Arc;

use fitcheck_core::message::{FilePlace, Located};

use super::ControlTable;
use super::fault::TableWarning;

/// A table as it is in a file: with the warnings, and the places of its parts.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableFile {
    pub table: ControlTable,
    /// Warnings about a table that could still be read.
    pub warnings: Vec<TableWarning>,
    pub(super) file: Arc<str>,
    /// The line with the names of the columns.
    pub(super) names_line: usize,
    /// Where the columns start, in characters from 0.
    pub(super) starts: Vec<usize>,
    pub(super) row_lines: Vec<usize>,
    /// Row and column of the cells that begin directly after their neighbour, in order.
    pub(super) touching: Vec<(usize, usize)>,
}

impl TableFile {
    /// The place where a cell begins.
    pub fn cell_place(&self, row: usize, column: usize) -> FilePlace {
        self.place(self.row_lines.get(row).copied().unwrap_or(self.names_line), column)
    }

    /// A message about a cell, with its place.
    pub(crate) fn at_cell<T>(&self, row: usize, column: usize, what: T) -> Located<T> {
        Located { what, place: self.cell_place(row, column) }
    }

    /// A message about a column, with the place of its name.
    pub(crate) fn at_name<T>(&self, column: usize, what: T) -> Located<T> {
        Located { what, place: self.place(self.names_line, column) }
    }

    /// Whether there is no blank between the text of a cell and that of a neighbour: either may be split wrongly.
    pub fn touches(&self, row: usize, column: usize) -> bool {
        self.touching.binary_search(&(row, column)).is_ok() || self.touching.binary_search(&(row, column + 1)).is_ok()
    }

    fn place(&self, line: usize, column: usize) -> FilePlace {
        FilePlace::in_file(&self.file, line, self.start_of(column) + 1)
    }

    /// Where a column starts; beyond the last one, the line.
    pub(super) fn start_of(&self, column: usize) -> usize {
        self.starts.get(column).map_or(0, |start| *start)
    }
}
