//! Cells by their columns.

use csv::StringRecord;

/// The cells of a row, or the names of a header.
pub(super) trait Cells {
    /// The cell of a column. It is empty where the row is shorter, and where the file has no such column: what is absent says nothing.
    fn cell(&self, column: impl Into<Option<usize>>) -> &str;
}

impl Cells for StringRecord {
    #[inline]
    fn cell(&self, column: impl Into<Option<usize>>) -> &str {
        column.into().and_then(|at| self.get(at)).unwrap_or("")
    }
}
