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

/// The cells of a line that say something, with a blank between them.
pub(super) fn joined<'c>(cells: impl IntoIterator<Item = &'c str>) -> String {
    cells.into_iter().map(str::trim).filter(|cell| !cell.is_empty()).collect::<Vec<_>>().join(" ")
}

/// A text with one blank wherever it has blanks, and none at its ends.
pub(super) fn single_blanks(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
